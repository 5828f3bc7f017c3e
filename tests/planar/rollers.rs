//! The plank on two rollers (exercise 16.8): limit cycle and lift-off. Against the reference
//! it is held in `tests/reference`.

#[path = "plank.rs"]
pub mod plank;

use super::G;
use plank::{Plank, laid};
use rotation_dynamics::math::atan;
use support::{EPS, Errors, assert_error, assert_largest};

/// Errors of period and amplitude of the limit cycle, if the holding friction is off by the
/// part `damage`.
fn limit_cycle(damage: f64) -> Errors {
    let (a, mu, mu_s, v) = (1.2, 0.2, 0.35, 0.25);
    let plank = Plank { a, g: G, kinetic: mu, holding: mu_s * (1.0 + damage), speed: v };
    let motion = laid(&plank, 0.3, 0.0, 30.0, 1e-14).unwrap();
    let named = |name| motion.events().iter().filter(move |e| e.name == name);
    let catches: Vec<_> = named("right sticks").map(|e| e.t).collect();
    let lambda = (2.0 * mu * G / a).sqrt();
    let x_s = 0.5 * a * (mu_s - mu) / (mu_s + mu);
    let period = 4.0 * x_s / v + 4.0 / lambda * atan(v / (lambda * x_s));
    assert_error!(period, 4.17036398431852, 9.6 eps);
    let mut errors = Errors::of("limit cycle");
    // The first catch is not yet in the cycle.
    for pair in catches[1..].windows(2) {
        errors.add(pair[1] - pair[0], period, period);
    }
    for breaks in named("right slips") {
        errors.add(breaks.before.q[0].abs(), x_s, x_s);
    }
    errors
}

/// Holding better than it slips, the plank ends in a limit cycle of stick and slip.
#[test]
fn stick_and_slip_have_a_period() {
    assert_largest!(limit_cycle(0.0), 13, @"7.12e-15");
    limit_cycle(1e-9).exceed(1e-11, 13);
}

/// Pushed outward past the roller, the plank lifts off the other and tips.
#[test]
fn a_plank_lifts_off() {
    let pushed = |a| {
        let plank = Plank { a, g: G, kinetic: 0.3, holding: 0.3, speed: -5.0 };
        let motion = laid(&plank, 0.49, 0.0, 0.5, 1e-14).unwrap();
        let lifts = motion.event("left lets go").unwrap().before.q[0];
        let [_, right] = motion.forces(0.5).unwrap();
        (lifts, motion.at(0.5).unwrap(), right, motion.drift().unwrap())
    };
    let (lifts, end, right, (gap, _)) = pushed(1.0);
    assert_error!(lifts, 0.5, 2.0 eps);
    assert!(end.q[2] < 0.0 && end.q[0] > 0.5, "{end:?}");
    assert!(right.normal > 0.0);
    assert_error!(gap, 7.1e-17);
    // The damaged twin: rollers that stand elsewhere.
    assert!((pushed(1.0 + 1e-12).0 / 0.5 - 1.0).abs() > 1e3 * EPS);
}
