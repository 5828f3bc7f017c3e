//! The hinged rod that is hit by a particle. The simulation knows contacts and impulses and
//! no conservation law; a claim that it does not confirm is an error.

use crate::answers::{confirmed, measured, refused, value};
use pages::ch15_5_rod_and_particle::strike::Blow;
use pages::ch15_5_rod_and_particle::{Answer, EXAMPLE, Parameters, scene};
use rotation_dynamics::math::{cbrt, cos, sin};
use std::f64::consts::PI;
use rotation_dynamics::planar::contact::{MechanismState, misdeclared};
use support::{EPS, Errors, assert_error, assert_largest};

/// Rods and particles of equal mass: M, l, v.
const EQUAL: [[f64; 3]; 5] = [[0.8, 1.2, 5.0], [1.0, 1.0, 1.0], [3.0, 0.3, 20.0], [0.1, 2.0, 0.7], [40.0, 7.0, 3.0]];

fn equal([mass, length, speed]: [f64; 3]) -> Parameters {
    Parameters { mass, particle: mass, length, speed, ..Parameters::default() }
}

fn blow(p: &Parameters) -> Blow {
    Blow::new(scene(p, true), p.tolerance, 0.5, 2.0).unwrap()
}

#[test]
fn other_rods_and_particles_are_confirmed() {
    confirmed(&EXAMPLE, [
        "--particle=0.01", "--particle=80", "--length=0.01 --speed=300",
        "--mass=30 --speed=0.1 --tolerance=1e-9", "--tolerance=1e-3", "--length=0.004",
        "--particle=1000 --mass=0.001", "--particle=0.001 --mass=1000 --length=0.001 --speed=1000",
        "--length=1000 --speed=0.001 --tolerance=1e-9", "--with table",
        "--with table=0.01 --particle=3 --length=0.3", "--with table=2",
    ], 12);
}

#[test]
fn what_cannot_hit_is_refused() {
    refused(&EXAMPLE, [
        ("--speed=0", "speed = 0 is not allowed"),
        ("--mass=-1", "mass = -1 is not allowed"),
        ("--mass=1e300", "it must be from 1e-6 to 1000000"),
        ("--length=nan", "not a finite number"),
        ("--tolerance=1e-16", "tolerance = 1e-16"),
        ("--with table=0", "table = 0 is not allowed"),
        ("--with table=0.0001 --speed=50", "angle until the table stops it"),
    ]);
}

/// Equation (1): sum of m r^2 over ten thousand pieces of the rod, and the particle.
#[test]
fn eq_15_5_ex1_1_moment_about_the_hinge() {
    let (mut errors, mut damaged) = (Errors::of("M l^2/3"), Errors::of("the rod alone"));
    for [m, l, v] in EQUAL {
        let pieces = (0..10_000).map(|k| l * ((f64::from(k) + 0.5) / 1e4 - 0.5));
        let sum = pieces.map(|r| m / 1e4 * r * r).sum::<f64>() + m * (0.5 * l) * (0.5 * l);
        errors.push(m * l * l / 3.0 / sum - 1.0);
        errors.push(Answer::new(&equal([m, l, v])).inertia / sum - 1.0);
        damaged.push(m * l * l / 12.0 / sum - 1.0);
    }
    assert_largest!(errors, 10, @"2.50e-9");
    damaged.exceed(0.7, 5);
}

/// Equation (2): about the hinge the simulated impact keeps M l v/2; about another point not.
#[test]
fn eq_15_5_ex1_2_angular_momentum_about_the_hinge_is_kept() {
    let (mut errors, mut elsewhere) = (Errors::in_units_of(EPS, "L about the hinge"), Errors::of("about the upper end"));
    for [m, l, v] in EQUAL {
        let (p, blow) = (equal([m, l, v]), blow(&equal([m, l, v])));
        let about = |state: &MechanismState<5>, y: f64| scene(&p, true).angular_momentum(state, [0.0, y]) / (m * l * v);
        for state in [blow.before, blow.after, blow.end().unwrap()] {
            errors.push(about(&state, 0.0) - 0.5);
        }
        elsewhere.push(about(&blow.after, 0.5 * l) - about(&blow.before, 0.5 * l));
    }
    assert_largest!(errors, 15, @"22");
    elsewhere.exceed(0.1, 5);
}

/// Equation (3): 3 v/(2 l), and what other conservation laws would give.
#[test]
fn eq_15_5_ex1_3_angular_velocity() {
    let mut errors = Errors::in_units_of(EPS, "Omega l/v");
    let (mut momentum, mut energy) = (Errors::of("momentum kept"), Errors::of("energy kept"));
    for [m, l, v] in EQUAL {
        let found = blow(&equal([m, l, v])).after.v[2] * l / v;
        errors.push(found - 1.5);
        momentum.push(found - 2.0);
        energy.push(found - 3.0_f64.sqrt());
    }
    assert_largest!(errors, 5, @"2");
    momentum.exceed(0.4, 5);
    energy.exceed(0.2, 5);
}

/// The line as it is printed mixes L with l and omega with Omega; read as M l^2 Omega/3 =
/// M l v/2 it has the units of an angular momentum and gives (3).
#[test]
fn e44_one_letter_for_the_length() {
    let [m, l, v] = EQUAL[0];
    let read = |length: f64| 0.5 * m * length * v / (m * l * l / 3.0);
    assert_error!(read(l), value(&EXAMPLE, "angular_velocity"), 0.0 eps);
    // L read as the angular momentum, as on the rest of the page, it is something else.
    assert!((read(value(&EXAMPLE, "momentum")) - read(l)).abs() > 5.0);
}

/// The hinge must stop the middle of the rod: without its impulse the middle would move.
#[test]
fn the_hinge_takes_a_quarter() {
    let ([m, _, v], p) = (EQUAL[0], equal(EQUAL[0]));
    let contact = m * (v - blow(&p).after.v[3]);
    assert_error!(contact, 0.25 * m * v, 0.0 eps);
    assert_error!(-value(&EXAMPLE, "hinge"), contact, 3.0 eps);
    // Free, the same blow sets the middle going.
    let free = Blow::new(scene(&p, false), p.tolerance, 0.5, 1.0).unwrap().after;
    assert!(free.v[0] > 0.9);
}

/// The rows of the contacts are the derivatives of their gaps, hinged and free, before and
/// after; if a middle that is said to be held moves, they are not.
#[test]
fn the_contacts_are_declared_as_they_are() {
    let (p, mut errors) = (Parameters::default(), Errors::of("rows less differences"));
    let mut damaged = Errors::of("a hinge that moves");
    let moving = [0.7, -0.4, 2.0, 1.0, -2.0];
    for (angle, rate) in [(0.0, 0.0), (0.4, 2.0), (2.5, -3.0)] {
        let q = [0.3, -0.2, angle, 0.3 + 0.7 * sin(angle), -0.2 - 0.6 * cos(angle)];
        let state = |v: [f64; 5]| MechanismState { q, v: [v[0], v[1], rate, v[3], v[4]] };
        errors.push(misdeclared(&scene(&p, false), &state(moving)));
        errors.push(misdeclared(&scene(&p, true), &state([0.0, 0.0, 0.0, 1.0, -2.0])));
        damaged.push(misdeclared(&scene(&p, true), &state(moving)));
    }
    assert_largest!(errors, 6, @"1.16e-12");
    damaged.exceed(0.1, 3);
}

/// What the card measures, by other routes: the law of impulses with a pin that takes a part of
/// the lever, a force that grows as a sine, and a torque that is constant.
#[test]
fn what_the_card_measures() {
    let [hinge, thick, ball, contact, table] = measured(&EXAMPLE);
    let p = Parameters::default();
    let (a, arm) = (Answer::new(&p), 0.5 * p.length);
    let (w, rod, lever) = (a.angular_velocity, p.mass * p.length * p.length / 12.0, arm - 0.3 * 0.005);
    let part = (w - hinge[1]) / (lever * p.particle * p.speed / (rod + lever * p.particle * arm));
    assert_error!(part, 1.0, 0.0 eps);
    // The moments of a box, and of a ball beside the end.
    let radius = cbrt(3.0 * p.particle / (4.0 * PI * 7850.0));
    let slower = |more: f64| w - a.momentum / (a.inertia + more);
    let mut errors = Errors::of("slower, over the rate");
    errors.push((thick[1] - slower(p.mass * 0.02 * 0.02 / 12.0)) / w);
    errors.push((ball[1] - slower(1.4 * p.particle * radius * radius)) / w);
    // Its speed closes as a cosine: of the time of contact, 2/pi of a full turning is lost.
    errors.push(contact[1] / (1e-3 * w) - 2.0 / PI);
    // The table brakes both with what they weigh, at half of the arm and at the arm.
    let brake = 0.1 * 9.80665 * arm * (0.5 * p.mass + p.particle) / a.inertia;
    errors.push((table[1] - brake / w) / w);
    assert_largest!(errors, 4, @"6.38e-13");
    // A pin that rubs with its whole radius, a contact whose force is even in time, a rod alone.
    let mut damaged = Errors::of("other laws");
    damaged.push(hinge[1] / (0.005 * a.hinge.abs() / a.inertia) - 1.0);
    damaged.push(contact[1] / (1e-3 * w) - 0.5);
    damaged.push(table[1] * w * a.inertia / (0.1 * 9.80665 * arm * 0.5 * p.mass) - 1.0);
    damaged.exceed(0.1, 3);
}
