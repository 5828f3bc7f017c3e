//! The gyroscope that keeps a direction: each equation away from the numbers of the page, with a
//! twin that misses.

use crate::answers::{confirmed, refused};
use core::f64::consts::TAU;
use kit::prelude::*;
use kit::simpson;
use pages::ch16_2_navigation::physics::*;
use pages::ch16_2_navigation::*;
use support::{Errors, assert_largest};

const STEP: f64 = 1e-14;

/// The formulas of a star against attitudes of the ground; the twin counts the turn the other way.
#[test]
fn eq_1_the_formulas_of_a_star() {
    let (mut errors, mut damaged) = (Errors::of("direction"), Errors::of("westward"));
    for (latitude, start, turn) in [(0.9, 0.0, 1.6), (0.9, 1.2, 4.0), (-0.4, -2.0, 2.5), (1.5, 3.0, 0.7)] {
        let at = |turn: f64| ground(place(latitude, 0.3), turn).unwrap();
        let seen = at(turn).to_body(at(0.0).to_space(towards([start, 0.0])));
        errors.push((seen - towards(star(latitude, start, turn))).norm());
        damaged.push((seen - towards(star(latitude, start, -turn))).norm());
    }
    assert_largest!(errors, 4, @"4.48e-16");
    damaged.exceed(0.1, 4);
}

/// The rates of that axle; the twin has no tangent of the altitude.
#[test]
fn eq_2_the_rates_of_a_free_axle() {
    let (mut errors, mut damaged) = (Errors::of("rates"), Errors::of("level"));
    for (latitude, start, turn) in [(0.9_f64, 0.2, 0.8), (-0.4, -2.0, 0.5), (1.2, 2.0, 0.7)] {
        let ((s, c), [azimuth, altitude]) = (sincos(latitude), star(latitude, start, turn));
        let [late, soon] = [1e-4, -1e-4].map(|h| star(latitude, start, turn + h));
        let [turns, rises] = [0, 1].map(|i| (late[i] - soon[i]) / 2e-4);
        errors.push(turns - s + c * tan(altitude) * cos(azimuth));
        errors.push(rises - c * sin(azimuth));
        damaged.push(turns - s);
    }
    assert_largest!(errors, 6, @"1.52e-9");
    damaged.exceed(0.01, 3);
}

/// Along parallels, eastward, westward and at rest; the twin forgets the longitude.
#[test]
fn eq_3_the_level_axle() {
    let (mut errors, mut damaged) = (Errors::of("azimuth"), Errors::of("at rest"));
    for (latitude, angle) in [(0.9, 0.5), (0.9, -0.5), (-0.6, 2.0), (1.4, -3.0)] {
        let (way, turned) = (parallel(latitude, angle, 2e4), EARTH * 2e4);
        let known = (turned + angle) * sin(latitude);
        errors.push(carry(way, EARTH, known, STEP).unwrap().0 - known);
        damaged.push(carry(way, EARTH, known, STEP).unwrap().0 - turned * sin(latitude));
    }
    assert_largest!(errors, 4, @"2.22e-15");
    damaged.exceed(0.1, 4);
}

/// A great circle: the mean sine of the latitude, and the whole drift. The twin: the mean of the ends.
#[test]
fn eq_4_the_great_circle() {
    let (mut means, mut errors, mut damaged) = (Errors::of("mean sine"), Errors::of("drift"), Errors::of("ends"));
    for (from, to) in [([0.9, 0.0], [0.86, -2.1]), ([-0.3, 1.0], [1.2, 2.0]), ([0.1, 0.0], [0.2, 3.0])] {
        let way = Journey::great_circle(place(from[0], from[1]), place(to[0], to[1]), 250.0);
        let ([path, earth], half) = (way.drift(way.angle), 0.5 * way.angle);
        let mean = (sin(from[0]) + sin(to[0])) * tan(half) / way.angle;
        let summed = simpson([0.0, way.angle], 400, |x| Ok::<_, kit::Error>(way.at(x)[0].z())).unwrap();
        means.push(mean - summed / way.angle);
        means.push(mean - earth / (EARTH * way.time));
        errors.push(carry(way, EARTH, path + earth, STEP).unwrap().0 - path - earth);
        damaged.push(mean - 0.5 * (sin(from[0]) + sin(to[0])));
    }
    assert_largest!(means, 6, @"8.59e-12");
    assert_largest!(errors, 3, @"7.55e-15");
    damaged.exceed(0.02, 3);
}

/// Off the plan by half the rate of drift times the speed and the square of the time, while that
/// is short; the twin lacks the half.
#[test]
fn eq_5_the_track_bends() {
    let [out, _] = flights(&Parameters::default()).unwrap();
    let (mut errors, mut damaged) = (Errors::of("ratio less one"), Errors::of("no half"));
    for time in [60.0, 120.0, 240.0] {
        let (at, [plan, _]) = (astray(out, time, STEP).unwrap(), out.at(out.angle / out.time * time));
        let ratio = (at - plan).norm() * RADIUS / (EARTH * out.from.z() * 250.0 * time * time);
        errors.push(2.0 * ratio - 1.0);
        damaged.push(ratio - 1.0);
    }
    assert_largest!(errors, 3, @"2.00e-3");
    damaged.exceed(0.4, 3);
}

#[test]
fn other_journeys_and_rotors_are_confirmed() {
    confirmed(&EXAMPLE, [
        "--latitude=0 --to-latitude=10", "--latitude=-33.9 --longitude=151.2 --to-latitude=-33.4 --to-longitude=-70.8",
        "--latitude=89 --to-latitude=-89 --speed=1", "--to-longitude=179.5", "--speed=7900 --tolerance=1e-6",
        "--spin=-2500", "--spin=250000 --offset=1e-4", "--latitude=10 --to-latitude=80 --to-longitude=179.55",
    ], 8);
    let [out, _] = flights(&Parameters::default()).unwrap();
    assert!(EARTH * out.time < TAU); // what is said of the flight needs less than a day
}

#[test]
fn what_is_no_journey_is_refused() {
    refused(&EXAMPLE, [
        ("--latitude=90", "no direction is north"),
        ("--to-latitude=51.47 --to-longitude=-0.45", "less is no journey"),
        ("--speed=0", "it flies for months"),
        ("--spin=0", "without spin it falls"),
        ("--offset=0.1", "with more it nods"),
    ]);
}
