//! The library alone: the day's promise is kept, the card is right about the magnet, and what
//! is refused is refused with its reason.

use crate::answers::{answer, cell, confirmed, number, refused, value};
use kit::{Page, parse, times};
use pages::library::*;
use rotation_dynamics::accuracy::Limits;
use rotation_dynamics::motion::Motion;
use support::{Errors, assert_largest};

/// A swing of this height, solved to this error.
fn asked(askew: f64, tolerance: f64) -> Parameters {
    Parameters { askew, tolerance, ..Parameters::default() }
}

#[test]
fn what_is_asked_for_is_confirmed() {
    confirmed(&EXAMPLE, [
        "--askew 0.001", "--askew 0.2", "--askew 0.8", "--askew 0.3 --tolerance 1e-5",
        "--mean-motion 2e-4", "--mean-motion 2e-3", "--torque 0", "--torque 0.5", "--torque -0.2",
        "--askew -0.1", "--tolerance 1e-11", "--tolerance 1e-3",
    ], 12);
}

/// A swing of 0.3 rad feeds the slightest touch across the plane: with the magnet eight digits of the start are lost in
/// a day.
#[test]
fn what_cannot_be_had_is_refused() {
    refused(&EXAMPLE, [
        ("--askew 0.3", "an error of 1e-8 rad is asked for, and doubles allow"),
        ("--askew 1.6", "does not swing back"),
        ("--askew 0", "hung straight it does not swing"),
        ("--mean-motion 0", "mean_motion = 0 is not allowed"),
        ("--torque -1", "torque = -1 is not allowed"),
        ("--tolerance 1e-12", "tolerance = 1e-12 is not allowed"),
    ]);
}

/// Each hour of the day, for swings and errors of many sizes, against the pendulum that twice the angle is.
#[test]
fn no_hour_is_off_by_more_than_was_asked() {
    let (mut errors, mut damaged) = (Errors::of("error over request"), Errors::of("half the rate"));
    for askew in [1e-3, 0.05, 0.1, 0.15] {
        for tolerance in [1e-4, 1e-6, 1e-8, 1e-10] {
            let p = asked(askew, tolerance);
            let states = day(&p).unwrap();
            for error in off(&p, &states).unwrap() {
                errors.push(error / tolerance);
            }
            // The damaged twin: an orbit that goes round a little faster.
            let other = Parameters { mean_motion: p.mean_motion * (1.0 + 1e-4), ..p };
            damaged.push(off(&other, &states).unwrap()[23] / tolerance);
        }
    }
    assert_largest!(errors, 384, @"1.21e-4");
    damaged.exceed(1.0, 16);
}

/// With a hundredth of the magnet the response is linear: the card's number, a hundredth of it, is what runs with and
/// without the magnet differ by.
#[test]
fn the_card_is_right_about_the_magnet() {
    let p = asked(0.1, 1e-9);
    let (scene, start) = satellite(&p).unwrap();
    let small = magnet(0.01 * MAGNET);
    let weighed = scene.neglected_effects(&start, DAY, 1e-3).unwrap().predict(&small, 0.0).unwrap();
    let with = scene.with(small);
    let with = with.solve_along(&start, DAY, p.tolerance, &Limits::default()).unwrap();
    let without = scene.solve_along(&start, DAY, p.tolerance, &Limits::default()).unwrap();
    let apart = times(0.0, DAY, 400).map(|t| {
        let [a, b] = [with.try_state(t), without.try_state(t)].map(|state| state.unwrap().attitude);
        a.angle_to(&b)
    });
    let mut errors = Errors::of("simulated over predicted, less one");
    errors.push(apart.fold(0.0, f64::max) / weighed.predicted - 1.0);
    assert_largest!(errors, 1, @"2.66e-3");
    // The same number stands on the card, to two digits, for the whole magnet.
    let card = cell(&EXAMPLE, "", ["effects", "magnet on board", "error if left out"]);
    assert!((100.0 * weighed.predicted - card).abs() < 0.005, "{card}");
    assert!(!scene.neglected_effects(&start, DAY, 1e-3).unwrap().predict(&magnet(MAGNET), 0.0).unwrap().linear);
}

/// The first of the page's tries: its answer is what the page says of a tenth of the swing.
#[test]
fn a_tenth_of_the_swing_gives_what_the_page_says() {
    let calm = number(&EXAMPLE, "--askew 0.01", "magnet_worst");
    assert!((calm - value(&EXAMPLE, "magnet_calm")).abs() < 1e-6, "{calm}");
}

/// Every request of the page's table is refused, each for a reason of its own.
#[test]
fn every_row_of_the_refusals_is_one() {
    let report = parse(&answer(&EXAMPLE, "").stdout).unwrap();
    let rows = report.table("table refused").expect("a table").rows().to_vec();
    let mut answers: Vec<String> = rows.iter().map(|row| row[1].clone()).collect();
    assert!(answers.iter().all(|answer| answer != "granted"), "{answers:?}");
    answers.sort();
    answers.dedup();
    assert_eq!((rows.len(), answers.len()), (7, 7));
    assert_eq!(Page::stem(&EXAMPLE), "library");
}

/// The forced swing: its error is a part of the eccentricity; the twin starts without it.
#[test]
fn on_an_ellipse_it_swings_as_the_card_says() {
    let p = Parameters::default();
    let (mut errors, mut twin) = (Errors::of("error of the swing over e"), Errors::of("at rest at the start"));
    for e in [1e-4, 3e-4, 1e-3] {
        let swing = 2.0 * e / 1.1;
        let found = |start: f64| forced(&p, e, start).expect("solved") / swing - 1.0;
        errors.push_at(found(swing) / e, e);
        twin.push(found(0.0));
    }
    assert_largest!(errors, 3, @"0.221");
    twin.exceed(0.1, 3);
}
