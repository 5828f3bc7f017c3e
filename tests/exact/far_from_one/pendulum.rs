//! The smallest swings, and pendulums that are fast or slow.

use core::f64::consts::PI;
use rotation_dynamics::exact::pendulum::{Pendulum, Suspension};
use rotation_dynamics::math::{DoubleDouble, EPS, ldexp, pow};
use support::{Errors, assert_error, assert_largest};

fn unit(theta0: f64, omega0: f64) -> Pendulum {
    let suspension = Suspension { moment: 1.0, mass: 1.0, gravity: 1.0, lever: 1.0 };
    Pendulum::new(suspension, theta0, omega0).expect("a pendulum")
}

/// k^2 = (theta0^2 + omega0^2)/4 of the smallest swings, to the last digit a double has there.
#[test]
fn the_energy_of_the_smallest_swings() {
    let mut errors = Errors::of("k^2, in eps of itself or in the smallest double");
    let mut still = Errors::of("the same without the rate");
    for digits in 90..=161 {
        let (theta0, omega0) =
            (2.0 * pow(10.0, -f64::from(digits)), 1.4 * pow(10.0, -f64::from(digits)));
        let up = ldexp(1.0, 500);
        let square = |x: f64| DoubleDouble::product(x * up, x * up);
        let want = (square(theta0) + square(omega0)).scaled(0.25 / up).to_f64() / up;
        let size = (EPS * want).max(5e-324);
        errors.add(unit(theta0, omega0).energy_ratio(), want, size);
        still.add(unit(theta0, 0.0).energy_ratio(), want, size);
    }
    assert_largest!(errors, 72, @"0");
    still.exceed(0.9, 72);
}

/// A rate or a frequency far from one: k^2 and the period are those of the scaled pendulum.
#[test]
fn fast_and_slow_pendulums_scale() {
    let mut errors = Errors::in_units_of(EPS, "k^2 and period");
    for exponent in [-57, -40, 0, 40, 57] {
        let size = pow(10.0, f64::from(exponent));
        let suspension = Suspension { moment: 1.0 / size, mass: size, gravity: size, lever: size };
        for ratio in [1e-60, 0.3, 2.5, 1e30, 1e59] {
            let rate = size * size;
            let pendulum = Pendulum::new(suspension, 0.2, ratio * rate).expect("a pendulum");
            let slow = unit(0.2, ratio);
            errors.add(pendulum.energy_ratio(), slow.energy_ratio(), slow.energy_ratio());
            errors.add(pendulum.period() * rate, slow.period(), slow.period());
        }
    }
    assert_largest!(errors, 50, @"3.21");
}

/// Swings far below a degree, a quadrillion radians later: theta = theta0 cos(W t/(1 + k^2/4 +
/// ...)). A harmonic motion, which has no k^2 there, is seen down to k^2 = 1e-30.
#[test]
fn small_swings_are_late() {
    let mut errors = Errors::in_units_of(EPS, "theta over theta0");
    let mut harmonic = Errors::in_units_of(EPS, "theta over theta0 of the harmonic motion");
    for digits in 17..=35 {
        let theta0 = 2.0 * pow(10.0, -0.5 * f64::from(digits));
        let swing = unit(theta0, 0.0);
        let k2 = DoubleDouble::from(0.5 * theta0).square();
        // Where the cosine is steep, so late that k^2 shows.
        let t = (1e15 / PI).round() * PI + 0.5 * PI;
        let phase = DoubleDouble::from(t) * (DoubleDouble::ONE - k2 * 0.25);
        let got = swing.at(t).expect("a time").theta / theta0;
        errors.push_at(got - phase.cos().to_f64(), digits);
        if digits <= 28 {
            harmonic.push(got - DoubleDouble::from(t).cos().to_f64());
        }
    }
    assert_largest!(errors, 19, @"0.0938");
    harmonic.exceed(100.0, 12);
    assert_error!(unit(1e-9, 0.0).energy_ratio(), 2.5e-19, 0.0);
}
