//! Exercise 15.3, coins of two sizes. That simulations and formulas agree is part of the report:
//! a claim that differs from its oracle is an error.

use crate::answers::measured;
use core::f64::consts::{PI, TAU};
use pages::ch15_ex3_coins::physics::*;
use pages::ch15_ex3_coins::*;
use rotation_dynamics::math::{atan2, cos, sin};
use support::{Errors, assert_largest};

/// Polygons with equal sides roll on each other: from one side to the next the moving one turns
/// by what the corners of the two leave open, inside by their difference. Radii are in proportion
/// to the numbers of sides.
#[test]
fn polygons_turn_as_the_coins_do() {
    let (mut errors, mut damaged) = (Errors::of("turns of a polygon"), Errors::of("one fewer"));
    for (fixed, moving) in [(10, 6), (4, 4), (5, 50), (9, 3), (7, 6)] {
        // The direction of the next side as seen from the one that lies on the other.
        let bend = |sides: i32| {
            let step = TAU / f64::from(sides);
            atan2(sin(step), cos(step)).rem_euclid(TAU)
        };
        let senses = if moving < fixed { vec![1.0, -1.0] } else { vec![1.0] };
        for sense in senses {
            let rate = angular_velocity(sense * f64::from(moving) / f64::from(fixed));
            let turns = f64::from(fixed) * (bend(fixed) + sense * bend(moving)) / TAU;
            errors.push(turns - rate);
            damaged.push(turns - (rate - 1.0));
        }
    }
    assert_largest!(errors, 8, @"8.88e-16");
    damaged.exceed(0.9, 8);
}

/// What the card measures, by other routes: the mean distance in closed form, arcs that differ by
/// a hundredth, and the formula with another radius.
#[test]
fn what_the_card_measures() {
    let [rubbed, slipped, worn] = measured(&EXAMPLE);
    let p = Parameters::default();
    let (r, path) = (ratio(&p).unwrap(), TAU * (p.inner + p.outer));
    let mut errors = Errors::of("measured over another route, less one");
    errors.push(slipped[1] / (0.01 / r) - 1.0);
    errors.push(worn[1] / (angular_velocity(r) - angular_velocity((p.outer + 1e-5) / p.inner)) - 1.0);
    assert_largest!(errors, 2, @"7.35e-14");
    let mut errors = Errors::of("work of the rubbing, of pieces");
    errors.push(rubbed[1] / (0.2 * 9.80665 * p.mass * 32.0 / (9.0 * PI) * path) - 1.0);
    errors.push(mean_distance(80) * 9.0 * PI / 32.0 - 1.0);
    assert_largest!(errors, 2, @"1.89e-5");
    // The way of the middle alone, and no ratio of the radii.
    let mut damaged = Errors::of("other laws");
    damaged.push(rubbed[1] / (0.2 * 9.80665 * p.mass * path) - 1.0);
    damaged.push(slipped[1] / 0.01 - 1.0);
    damaged.push(worn[1] / (1e-5 / p.outer) - 1.0);
    damaged.exceed(0.1, 3);
}
