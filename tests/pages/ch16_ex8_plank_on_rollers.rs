//! Exercise 16.8, the plank on rollers. That simulations confirm the formulas is part of the
//! report: a claim or a limit that differs from its oracle is an error.

use core::f64::consts::TAU;
use kit::But;
use pages::ch16_ex8_plank_on_rollers::physics::*;
use pages::ch16_ex8_plank_on_rollers::*;
use rotation_dynamics::planar::contact::{MechanismState, misdeclared};
use support::{Errors, assert_largest};

/// Swings within the largest circle never stick; all wider ones have the same cycle.
#[test]
fn only_wide_swings_end_in_the_cycle() {
    let p = Parameters::default();
    let (widest, (amplitude, period)) = (p.speed / rate(&p, 1.0), cycle(&p));
    let ride = |offset, rounds| released(&p.but(|p| p.offset = offset), 1.0, rounds * period).unwrap();
    for part in [0.01, 0.5, 0.999] {
        assert!(ride(part * widest, 10.0).events().is_empty());
    }
    let (mut errors, mut damaged) = (Errors::of("period and amplitude"), Errors::of("oscillation"));
    for offset in [1.001 * widest, 0.15, amplitude, 0.3, 0.45] {
        let ride = ride(offset, 6.0);
        let mut slips = ride.events().iter().rev().filter(|event| event.name == "right slips");
        let round = slips.next().unwrap().t - slips.next().unwrap().t;
        errors.push_at(round - period, offset);
        damaged.push(round - TAU / rate(&p, 1.0));
    }
    assert_largest!(errors, 5, @"2.31e-14");
    damaged.exceed(0.3, 5);
    // What the scene says about its contacts is true: tilted, thick, and in motion.
    let thick = plank(&p.but(|p| p.thickness = 0.2), 1.0).unwrap();
    assert!(misdeclared(&thick, &MechanismState { q: [0.2, 0.03, -0.15], v: [0.7, -0.3, 0.9] }) < 1e-9);
}

/// The period by the smooth law is too long by less, the sharper it is, and costs more.
#[test]
fn a_smooth_law_is_late_and_dear() {
    let cell = |width, column| crate::answers::cell(&EXAMPLE, "", ["table smooth", width, column]);
    let late = ["1e-1", "1e-2", "1e-3"].map(|width| cell(width, "too long, as a part of the period"));
    let work = ["1e-1", "1e-2", "1e-3"].map(|width| cell(width, "evaluations in a period"));
    assert!(late.windows(2).all(|pair| pair[0] / pair[1] < 5.0 && pair[0] / pair[1] > 3.0), "{late:?}");
    assert!(work[2] / work[1] > 5.0 && work[2] > 5e4, "{work:?}");
    // The contact solver: the whole ride, twice around.
    let p = Parameters::default();
    assert!(released(&p, 1.0, 2.5 * cycle(&p).1).unwrap().work().derivatives < 2000);
}

/// Friction mu times the sign of the slip, in steps of a millisecond.
#[test]
fn a_law_of_signs_chatters_and_has_no_cycle() {
    let p = Parameters::default();
    let (mut x, mut v, h) = (p.offset, 0.0, 1e-3);
    let (mut held, mut turns, mut widest, mut last) = (0, 0, 0.0_f64, 0.0);
    for step in 0..20_000 {
        let (left, right) = (0.5 - x / p.distance, 0.5 + x / p.distance);
        let slip = -p.speed - v;
        let friction = (p.speed - v).signum() * left + slip.signum() * right;
        v += h * p.kinetic * p.gravity * friction;
        x += h * v;
        // While it should be held: from the catch to the middle.
        let t = h * f64::from(step);
        if t > caught(&p, 1.0)[0] && x > 0.0 && t < 1.2 {
            held += 1;
            turns += i32::from(slip * last < 0.0);
        }
        if t > 5.0 {
            widest = widest.max(x.abs());
        }
        last = slip;
    }
    // Nearer to the middle the left roller all but balances the right one, and it takes longer.
    assert!(held > 800 && turns > 300, "{turns} of {held}");
    let circle = p.speed / rate(&p, 1.0);
    assert!((widest / circle - 1.0).abs() < 0.05 && widest < 0.8 * cycle(&p).0, "{widest}");
}
