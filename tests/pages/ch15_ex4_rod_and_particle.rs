//! Exercise 15.4. The simulation knows contacts and impulses and no conservation law; that it
//! confirms the formulas is part of the report.

use crate::answers::{measured, value};
use pages::ch15_ex4_rod_and_particle::strike::Blow;
use pages::ch15_ex4_rod_and_particle::physics::{Answer, ratio, scene};
use pages::ch15_ex4_rod_and_particle::{EXAMPLE, Parameters};
use rotation_dynamics::math::{cbrt, cos, hypot, sin};
use std::f64::consts::PI;
use support::{EPS, Errors, assert_error, assert_largest};

fn blow(p: &Parameters, end: f64) -> Blow {
    Blow::new(scene(p), p.tolerance, 0.5, end).unwrap()
}

/// The point a sixth of the length beyond the middle is at rest just after the impact, for any
/// masses; a rod of another distribution of mass would have it elsewhere.
#[test]
fn the_same_point_is_at_rest_whatever_the_masses() {
    let (mut errors, mut damaged) = (Errors::in_units_of(EPS, "place over l"), Errors::of("a quarter"));
    for particle in [1e-3, 0.1, 0.8, 3.0, 500.0] {
        let v = blow(&Parameters { particle, ..Parameters::default() }, 1.0).after.v;
        let place = v[0] / v[2] / 1.2;
        errors.push(place - 1.0 / 6.0);
        damaged.push(place - 0.25);
    }
    assert_largest!(errors, 5, @"0.75");
    damaged.exceed(0.08, 5);
}

/// Five points of the rod for most of a turn: the simulation runs along the trochoids. The far end
/// of the damaged twin drifts with the rest and does not turn.
#[test]
fn points_of_the_rod_run_on_trochoids() {
    let (p, mut errors, mut damaged) = (Parameters::default(), Errors::of("paths"), Errors::of("no turning"));
    let (a, blow) = (Answer::new(&p), blow(&p, 8.0));
    for k in 1..=24 {
        let t = 0.045 * f64::from(k);
        let [x, y, angle, ..] = blow.at(t).unwrap().q;
        for place in [-0.6, -0.3, 0.0, 0.2, 0.6] {
            let (right, up) = a.at(t, place);
            errors.push(x - place * sin(angle) - right);
            errors.push(y + place * cos(angle) - up);
        }
        let (right, up) = a.at(t, 0.6);
        damaged.push(hypot(right - a.velocity * t, up - 0.6));
    }
    assert_largest!(errors, 240, @"3.22e-15");
    damaged.exceed(0.2, 24);
}

/// On a disc through the point at rest that rolls on a line: this point has cusps, those
/// within have waves, those beyond have loops.
#[test]
fn waves_cusps_and_loops() {
    let (a, mut backward) = (ratio(1.0), [0; 3]);
    let radius = a.velocity / a.angular_velocity;
    for k in 0..1000 {
        let (t, h) = (6e-3 * f64::from(k), 1e-4);
        for (i, far) in [0.9 * radius, radius, 1.1 * radius].into_iter().enumerate() {
            let speed = (a.at(t + h, a.centre + far).0 - a.at(t - h, a.centre + far).0) / (2.0 * h);
            backward[i] += u32::from(speed < -1e-7);
        }
    }
    assert!(backward[..2] == [0, 0] && backward[2] > 100, "{backward:?}");
}

/// "The angular momentum of the CM": about the centre of mass it is M v l/4, about the place of
/// the middle M v l/2, of which the centre carries M v l/4. What the centre carries about
/// itself, as the words say, is nothing.
#[test]
fn e40_about_the_centre_of_mass() {
    let p = Parameters::default();
    let (unit, s, blow) = (p.mass * p.speed * p.length, scene(&p), blow(&p, 2.0));
    let mut errors = Errors::in_units_of(EPS, "L over M v l");
    for state in [blow.before, blow.after, blow.end().unwrap()] {
        let ([x, y], [px, py]) = (s.centre(&state), s.momentum(&state));
        errors.push(s.angular_momentum(&state, [x, y]) / unit - 0.25);
        errors.push(s.angular_momentum(&state, [0.0, 0.0]) / unit - 0.5);
        errors.push((x * py - y * px) / unit - 0.25);
    }
    assert_largest!(errors, 9, @"6");
    assert_error!(value(&EXAMPLE, "about_centre"), 0.25 * unit, 1.6667 eps);
    assert_error!(value(&EXAMPLE, "about_middle"), 0.5 * unit, 0.0 eps);
}

/// What the card measures, by other routes: formulas for the solids and for a shorter lever, and a
/// force that grows as a sine.
#[test]
fn what_the_card_measures() {
    let [thick, ball, missed, contact, table] = measured(&EXAMPLE);
    let p = Parameters::default();
    let (a, m, reduced) = (Answer::new(&p), p.particle, p.mass * p.particle / (p.mass + p.particle));
    let w = a.angular_velocity;
    let turning = |arm: f64, more: f64| reduced * p.speed * arm / (p.mass * p.length * p.length / 12.0 + reduced * arm * arm + more);
    let radius = cbrt(3.0 * m / (4.0 * PI * 7850.0));
    let mut errors = Errors::of("measured less another route, over rate or velocity");
    errors.push((thick[1] - w + turning(0.6, p.mass * 0.02 * 0.02 / 12.0)) / w);
    errors.push((ball[1] - w + turning(0.6, (0.4 * m + reduced) * radius * radius)) / w);
    errors.push((missed[1] - w + turning(0.599, 0.0)) / w);
    errors.push(contact[1] / (1e-3 * w) - 2.0 / PI);
    assert_largest!(errors, 4, @"1.78e-16");
    // Hit off its end the rod turns faster.
    assert!(missed[1] < 0.0);
    // Each piece braked as the centre of mass is, a contact whose force is even in time.
    let mut damaged = Errors::of("other laws");
    damaged.push(table[1] * w / (0.1 * 9.80665) - 1.0);
    damaged.push(contact[1] / (1e-3 * w) - 0.5);
    damaged.push(missed[1] / (w / 600.0) - 1.0);
    damaged.exceed(0.1, 3);
}
