//! The page on effects: predictions hold for all parameters, and what is refused.

use crate::answers::{confirmed, refused};
use pages::effects::*;
use support::{Errors, assert_largest};

#[test]
fn predictions_hold_for_every_gyroscope() {
    confirmed(&EXAMPLE, [
        "--spin 250 --seconds 20", "--spin 1000 --seconds 20", "--pivot 0",
        "--pivot 3e-4 --spin 250", "--tolerance 1e-9", "--spin -314.16", "--seconds 0.1",
    ], 7);
}

#[test]
fn what_is_no_gyroscope_is_refused() {
    refused(&EXAMPLE, [
        ("--spin 0", "spin = 0 is not allowed"),
        ("--seconds 100", "seconds = 100 is not allowed"),
        ("--pivot -1", "pivot = -1 is not allowed"),
        ("--tolerance 1", "tolerance = 1 is not allowed"),
    ]);
}

/// The nods of a fast gyroscope alias with equal looks (up to fourfold at 900 rad/s): a prediction
/// looks within steps, and the simulations at its largest.
#[test]
fn nods_do_not_alias_with_the_looks() {
    confirmed(&EXAMPLE, [
        "--spin 500 --seconds 12 --pivot 0", "--spin 800 --seconds 6",
    ], 2);
}

/// Linear: half the effect, half the error; simulated with a hundred
/// times the friction it is not so.
#[test]
fn half_of_a_small_effect_costs_half() {
    let (mut errors, mut damaged) = (Errors::of("ratio less two"), Errors::of("far from linear"));
    for spin in [250.0, 500.0] {
        let p = Parameters { spin, ..Parameters::default() };
        let half = Parameters { pivot: 0.5 * p.pivot, ..p.clone() };
        let predicted = |p: &Parameters| {
            let effect = desk::gyroscope(p).pivot();
            question(p).unwrap().predicted(&effect).unwrap().predicted
        };
        errors.push(predicted(&p) / predicted(&half) - 2.0);
        let simulated = |pivot: f64| {
            let strong = desk::Spinner { pivot, ..desk::gyroscope(&p) };
            question(&p).unwrap().simulated(strong.pivot(), 1e-6).unwrap()
        };
        damaged.push(simulated(1e-2) / simulated(5e-3) - 2.0);
    }
    assert_largest!(errors, 2, @"0");
    damaged.exceed(0.01, 2);
}
