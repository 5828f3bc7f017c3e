//! Exercise 15.9, a dumbbell hit. The simulation knows contacts and impulses and no conservation
//! law; that it confirms the formulas is part of the report.

use crate::answers::ledger;
use core::f64::consts::{PI, TAU};
use pages::ch15_ex9_dumbbell::physics::*;
use pages::ch15_ex9_dumbbell::*;
use rotation_dynamics::math::{acos, cos, hypot, sin};
use support::{EPS, Errors, assert_largest};

/// For a turn and a half the masses run along their cycloids, and the ball stays behind; the
/// damaged twin does not turn.
#[test]
fn the_masses_run_on_cycloids() {
    let (mut errors, mut damaged) = (Errors::of("paths"), Errors::of("no turning"));
    let (a, reach) = (Answer::new(1.0, 0.0), 0.1);
    let run = Blow::new(Hit::across(1.0, reach), 1e-13, 7.0).unwrap();
    for k in 1..=30 {
        let angle = 0.3 * f64::from(k);
        let found = places(&run.at(angle / a.angular_velocity).unwrap().q);
        for (got, want) in found.into_iter().zip(cycloids(a, reach, angle)) {
            errors.push(hypot(got[0] - want[0], got[1] - want[1]));
        }
        damaged.push(hypot(found[1][0] - 0.5 * angle, found[1][1]));
    }
    assert_largest!(errors, 90, @"9.93e-16");
    damaged.exceed(0.008, 30);
}

/// At a cusp a mass is at rest: the struck one after half a turn, the other after a whole.
#[test]
fn each_mass_stands_still_once_a_turn() {
    let mut errors = Errors::in_units_of(EPS, "speed at a cusp");
    let run = Blow::new(Hit::across(1.0, 0.1), 1e-13, 10.0).unwrap();
    for (at_rest, halves) in [(1, 1.0), (2, 2.0), (1, 3.0), (2, 4.0)] {
        let moves = velocities(&run.at(halves * PI / run.after.v[2]).unwrap());
        let [still, other] = [at_rest, 3 - at_rest].map(|k| hypot(moves[k][0], moves[k][1]));
        errors.push(still);
        assert!(other > 1.33);
    }
    assert_largest!(errors, 4, @"12.9");
}

/// Small masses do not meet again: at the height of the ball a mass is at a multiple of a half
/// turn, and the ball only halfway there. Simulated for four turns, by formula for a hundred.
#[test]
fn small_masses_do_not_meet_again() {
    let run = Blow::new(Hit::across(1.0, 0.02), 1e-6, 4.0 * TAU).unwrap();
    assert_eq!(run.motion.events().len(), 1);
    let mut errors = Errors::of("place where a mass is level with the ball, over that of the ball");
    for k in 1..=200 {
        let [ball, lower, upper] = cycloids(Answer::new(1.0, 0.0), 0.0, PI * f64::from(k));
        let level = if k % 2 == 0 { lower } else { upper };
        errors.push(level[0] / ball[0] - 2.0);
        assert!(level[1].abs() < 1e-25 && lower[1] + upper[1] > 0.99);
    }
    assert_largest!(errors, 200, @"8.88e-16");
}

/// With e = 1/2 there is a second hit for any radii, along the second tangent, and it halves the
/// turning. The damaged twin takes the half turn of small masses.
#[test]
fn half_restitution_hits_again() {
    let (mut errors, mut damaged) = (Errors::of("second hit"), Errors::of("half a turn"));
    for reach in [0.01, 0.05, 0.1, 0.3, 0.49] {
        let run = halved(reach, 1e-13).unwrap();
        let hit = &run.motion.events()[1];
        let angle = run.again().unwrap() * run.after.v[2];
        errors.push(angle - second(reach));
        errors.push(hit.after.v[2] / run.after.v[2] - 0.5);
        errors.push(to_upper(places(&hit.after.q)) - reach);
        damaged.push(angle - PI);
    }
    assert_largest!(errors, 15, @"8.88e-16");
    damaged.exceed(0.03, 5);
}

/// Around e = 1/2 it depends on the radii: with those of the page a ball of 0.4 hits again and
/// one of 0.3 or of 0.8 does not.
#[test]
fn around_one_half_it_depends_on_the_size() {
    let hits = |e: f64, reach: f64| Blow::new(Hit::across(e, reach), 1e-9, 7.0).unwrap().motion.events().len();
    assert_eq!([0.3, 0.4, 0.6, 0.8, 1.0].map(|e| hits(e, 0.1)), [1, 2, 2, 1, 1]);
    assert_eq!([0.3, 0.45, 0.5, 0.55, 0.8].map(|e| hits(e, 0.01)), [1, 1, 2, 1, 1]);
}

/// The card of effects: a hit with another mass and moment, by the impulse alone, and one beside
/// the middle, by the line of the centres. The damaged twins are the plain dumbbell.
#[test]
fn heavier_dumbbells_and_hits_aside_are_simulated() {
    let (mut errors, mut damaged) = (Errors::of("velocities"), Errors::of("plain dumbbell"));
    for (mass, moment, slant) in [(1.01, 0.2508, 0.0), (1.0, 0.26, 0.7), (1.2, 0.25, 0.3)] {
        let hit = Hit { mass, moment, slant, ..Hit::across(0.6, 0.1) };
        let after = Blow::new(hit, 1e-13, 0.02).unwrap().after.v;
        let impulse = 1.6 / (1.0 + 1.0 / mass + 0.25 * cos(slant) * cos(slant) / moment);
        let plain = Answer::new(0.6, slant);
        errors.push(hypot(after[0], after[1]) - impulse / mass);
        errors.push(after[2] - 0.5 * impulse * cos(slant) / moment);
        damaged.push((hypot(after[0], after[1]) - plain.centre).abs() + (after[2] - plain.angular_velocity).abs());
    }
    for (aside, reach) in [(0.001, 0.1), (0.05, 0.2), (0.01, 0.5)] {
        let after = Blow::new(Hit { aside, ..Hit::across(1.0, reach) }, 1e-13, 0.02).unwrap().after.v;
        let across = after[0] / hypot(after[0], after[1]);
        errors.push(acos(across) - (aside / reach).asin());
        damaged.push(acos(across));
    }
    assert_largest!(errors, 9, @"5.00e-15");
    damaged.exceed(0.003, 6);
    assert_eq!(ledger(&EXAMPLE, "").len(), 4);
    assert_eq!(ledger(&EXAMPLE, "--speed=0.1 --slant=1.5707963267948966").len(), 2);
}

/// The card of effects: the table takes a part that falls to the first order as its friction does;
/// while it turns by 2 rad in the way l, the masses go along V with |cos| and |sin| of half the
/// angle. The damaged twin lets both go straight.
#[test]
fn a_table_that_rubs_takes_its_part() {
    let (mut errors, mut damaged) = (Errors::of("second order"), Errors::of("straight on"));
    let mut first = Errors::of("first order");
    let [x, y, turn, ..] = Blow::new(Hit::across(1.0, 0.1), 1e-13, 0.02).unwrap().after.v;
    let (after, speed) = ([x, y, turn], Answer::new(1.0, 0.0).centre);
    first.push(held_back(after) - 0.5 * (sin(1.0) + 1.0 - cos(1.0)));
    for friction in [1e-2, 1e-3, 1e-4] {
        let rub = friction / (speed * speed);
        let part = rubbed(after, friction).unwrap().0;
        errors.push((part / (rub * held_back(after)) - 1.0) / rub);
        damaged.push(part / rub - 1.0);
    }
    assert_largest!(first, 1, @"6.78e-7");
    assert_largest!(errors, 3, @"0.316");
    damaged.exceed(0.3, 3);
}
