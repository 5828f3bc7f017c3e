//! Exercise 15.1. The simulation knows the friction of two faces and no conservation law; that it
//! confirms the formulas is part of the report.

use crate::answers::cell;
use pages::ch15_ex1_two_discs::physics::*;
use pages::ch15_ex1_two_discs::*;
use support::{Errors, assert_error, assert_largest};

/// The heat that the faces take up, torque times slip summed over the time, is the same for three
/// laws of friction, and the times are not.
#[test]
fn the_loss_does_not_depend_on_the_law_of_friction() {
    let (p, mut errors) = (Parameters::default(), Errors::of("heat over the loss"));
    let mut damaged = Errors::of("time over that of dry friction");
    let a = Answer::new(&p);
    for (law, left) in [("dry", 0.0), ("weakening", 0.0), ("oil", 1e-9)] {
        let run = rubbed(&p, left, |slip| torque(&p, law, slip)).expect("a slip that ends");
        errors.push(run.end_state()[2] / a.lost - 1.0);
        if law != "dry" {
            damaged.push(run.end_time() / a.time - 1.0);
        }
    }
    assert_largest!(errors, 3, @"4.00e-14");
    damaged.exceed(0.1, 2);
}

/// A disc that jumps: at the top of each bounce, when the table has given back all the momentum
/// that gravity took, the faces have rubbed as much as without a fall.
#[test]
fn bounces_cost_no_time() {
    let p = Parameters { drop: 0.02, ..Parameters::default() };
    let (a, run) = (Answer::new(&p), fallen(&p, 0.5, 0.101, 1e-9));
    let run = run.expect("bounces");
    let (mut errors, mut damaged) = (Errors::of("slip over the first"), Errors::of("before the impact"));
    for pair in run.events().windows(2).take(5) {
        let top = 0.5 * (pair[0].t + pair[1].t);
        let slip = |t: f64| {
            let v = run.at(t).expect("a time of the run").v;
            (v[1] - v[2]) / a.relative
        };
        errors.push(slip(top) - (1.0 - top / a.time));
        damaged.push(slip(pair[0].t) - (1.0 - pair[0].t / a.time));
    }
    assert_largest!(errors, 5, @"2.22e-16");
    damaged.exceed(1e-4, 5);
}

/// With the sign of the slip and an odd number of equal steps, the slip that is left is half of what
/// a step changes.
#[test]
fn the_sign_of_the_slip_chatters() {
    let (p, mut errors) = (Parameters::default(), Errors::of("slip left over half a step's change"));
    let (a, mut damaged) = (Answer::new(&p), Errors::of("a tenth of it"));
    for steps in [51, 501, 5001] {
        let left = left_over(&chattering(&p, steps, 2.0 * a.time));
        let half = a.relative / f64::from(steps);
        errors.push(left / half - 1.0);
        damaged.push(left / half - 0.1);
    }
    assert_largest!(errors, 3, @"2.93e-12");
    damaged.exceed(0.5, 3);
    // A step that ends where the slip does: rounding decides.
    let [none, whole] = [50, 5000].map(|steps| left_over(&chattering(&p, steps, 2.0 * a.time)));
    assert_eq!(none, 0.0);
    assert_error!(whole, 2.0 * a.relative / 5000.0, 3.7219e5 eps);
    assert_eq!(cell(&EXAMPLE, "", ["table naive", "stick located", "slip left / rad/s"]).abs(), 0.0);
}
