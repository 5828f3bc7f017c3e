//! Exercise 16.2, the conical pendulum; a claim that its simulation does not confirm is an error.

use kit::prelude::*;
use pages::ch16_ex2_conical_pendulum::physics::*;
use pages::ch16_ex2_conical_pendulum::*;
use rotation_dynamics::integrators::{after, place_and_velocity};
use std::f64::consts::PI;
use support::{Errors, assert_largest, second_derivative};

/// It must be what M (a - g) has along the string, with a from the places at five times.
#[test]
fn the_tension_is_what_the_motion_needs() {
    let (q, motion) = (0.49, swung(0.49, 0.0, 0.3, 21.0, 1e-15).unwrap());
    let (mut errors, mut damaged) = (Errors::of("tension"), Errors::of("at rest"));
    for t in (1..200).map(|i| 0.1 * f64::from(i)) {
        let at = |t| in_space(motion.at(t).unwrap(), 1.0, t);
        let [ax, ay, az, ..] = second_derivative(at, t, 0.01);
        let [r, v] = place_and_velocity(&at(t));
        let needed = -r.dot(&SpaceVector::new(ax, ay, az + q));
        errors.push(tension(q, [r, v]) - needed);
        damaged.push(-q * r.z() - needed);
    }
    assert_largest!(errors, 199, @"2.07e-9");
    damaged.exceed(0.01, 199);
}

/// Ten turns in air, left to itself: it sinks as the card of effects says.
#[test]
fn air_lowers_the_cone_as_predicted() {
    let mut errors = Errors::of("sinking over prediction, less one");
    for (q, drag) in [(0.49, 9.4e-4), (0.9, 1e-4), (0.1, 1e-3)] {
        let (turns, start) = (20.0 * PI, in_space([cone(q), 0.0], 1.0, 0.0));
        let [_, _, z, ..] = after(turns, &on_string(q, drag), &start, 1e-15).unwrap();
        errors.push((cone(q) - acos(-z)) / (10.0 * sinking(q, drag)) - 1.0);
    }
    assert_largest!(errors, 3, @"0.0358");
}

/// Started at exactly zero it stays for a thousand turns, however fast; a touch is enough.
#[test]
fn exactly_zero_stays() {
    let still = swung(0.01, 0.0, 0.0, 2000.0 * PI, 1e-15).unwrap();
    assert_eq!(still.end_state(), &[0.0, 0.0]);
    assert!(swung(0.49, 0.0, 1e-9, 32.0, 1e-15).unwrap().end_state()[0] > cone(0.49));
    assert!(acos(1.2).is_nan() && cone(1.2) == 0.0); // below the threshold
    // Left to itself on its cone; the damaged twin has no square.
    assert!((measured_free(0.5).unwrap() - free(0.5)).abs() < 1e-8);
    assert!((measured_free(0.5).unwrap() - free(0.5_f64.sqrt())).abs() > 0.1);
}
