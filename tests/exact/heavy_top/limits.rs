//! Limits with a formula of their own.

use super::motions::{by_angles, by_body, by_energy};
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::exact::free_body::FreeBody;
use rotation_dynamics::exact::heavy_top::{ReducedTop, Start};
use rotation_dynamics::frame::BodyVector;
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::math::{self, EPS};
use support::{Errors, assert_largest};

/// Small nutations about steady precession: omega^2 = U_eff'' at the minimum. The second
/// derivative is a difference of the torque, of order 8.
#[test]
fn small_nutations_have_the_linear_frequency() {
    let mut errors = Errors::of("square of the frequency");
    let mut damaged = Errors::of("square of the frequency, off by 1e-11");
    let mut torques = Errors::in_units_of(EPS, "torque at the minimum");
    for (a, b, c) in [(2.0, 1.2, 0.2), (2.0, 0.6, 0.2), (0.5, -0.4, 1.3), (1.0, 0.8, -0.7)] {
        let top = ReducedTop::new(a, b, c).expect("a top");
        let (theta, lowest) = top.minimum();
        let h = 0.004;
        let difference = |k: f64| top.torque(theta - k * h) - top.torque(theta + k * h);
        let stiffness = (4.0 / 5.0 * difference(1.0) - 1.0 / 5.0 * difference(2.0)
            + 4.0 / 105.0 * difference(3.0)
            - 1.0 / 280.0 * difference(4.0))
            / h;
        let motion = by_energy(a, b, c, lowest, Start::ThetaMin);
        let frequency = core::f64::consts::TAU / motion.nutation_period();
        let ratio = frequency * frequency / stiffness;
        errors.push(ratio - 1.0);
        damaged.push(ratio * (1.0 + 1e-11) - 1.0);
        // The torque vanishes there.
        torques.add(top.torque(theta), 0.0, a + c.abs());
    }
    assert_largest!(errors, 4, @"2.60e-13");
    damaged.exceed(1e-12, 4);
    assert_largest!(torques, 4, @"1.67");
}

/// b = 1, E~ = 0, c > a/4: sin(theta/2) = sin(theta_max/2) sech(p t), p = sqrt(c - a/4).
#[test]
fn the_homoclinic_motion_is_a_sech() {
    let mut errors = Errors::in_units_of(EPS, "sech");
    for (a, c) in [(1.0, 0.5), (0.3, 2.0), (1.9, 0.5)] {
        let motion = by_energy(a, 1.0, c, 0.0, Start::ThetaMax);
        let largest = (1.0 - a / (4.0 * c)).sqrt();
        let p = (c - a / 4.0).sqrt();
        for t in [0.0, 0.1, -1.0, 5.0, 30.0, 300.0] {
            let half = largest / math::cosh(p * t);
            let got = math::sin(0.5 * motion.angles(t).theta);
            // sech falls by its condition p t.
            errors.push_at((got / half - 1.0) / (1.0 + p * t.abs()), t);
        }
        assert_eq!(motion.complementary_parameter(), 0.0);
        assert!(motion.nutation_period().is_infinite());
    }
    assert_largest!(errors, 3 * 6, @"1.33");
}

/// Without gravity the top is the free symmetric body.
#[test]
fn without_gravity_it_is_the_free_body() {
    let euler = [0.4, 1.1, -0.7];
    let mut turns = Errors::in_units_of(EPS, "attitude");
    let mut rates = Errors::in_units_of(EPS, "rates");
    for omega in [[0.3, -0.2, 6.0], [1.0, 2.0, -0.5], [1e-6, 0.0, 3.0]] {
        let top = by_body(0.0, euler, omega);
        let [phi, theta, zeta] = euler;
        let start = Attitude::from_euler(EulerAngles { phi, theta, zeta }).expect("finite");
        let moments = PrincipalMoments::new(1.0, 1.0, 0.4).expect("a body");
        let free = FreeBody::new(moments, start, BodyVector::from_array(omega)).expect("finite");
        for t in [0.0, 0.3, -7.0, 55.5, 1e4] {
            let apart = top.attitude(t).angle_to(&free.attitude(t));
            let speed = omega.iter().fold(0.0, |m: f64, w| m.max(w.abs()));
            let size = 1.0 + speed * t.abs();
            turns.push_at(apart / size, t);
            let off = top.angular_velocity(t) - free.angular_velocity(t);
            rates.push_at(off.norm() / (speed * size), t);
        }
        // A little gravity is seen.
        let heavy = by_body(1e-9, euler, omega);
        assert!(heavy.attitude(55.5).angle_to(&free.attitude(55.5)) > 1e-10);
    }
    assert_largest!(turns, 3 * 5, @"3.50");
    assert_largest!(rates, 3 * 5, @"2.24");
}

/// Gravity upside down: theta -> pi - theta, phi -> -phi for b -> -b, c -> -c.
#[test]
fn gravity_upside_down_mirrors_the_motion() {
    let mut tilts = Errors::in_units_of(EPS, "cos theta");
    let mut turns = Errors::in_units_of(EPS, "phi");
    for (a, b, c) in [(2.0, 0.6, 0.2), (1.0, 1.3, -0.4), (0.3, -1.0, 1.0), (1.0, 1.0, 0.5)] {
        for (theta, rate) in [(0.5, 0.2), (1.5, -0.3), (2.5, 0.0)] {
            let motion = by_angles(a, b, c, theta, rate);
            let other = by_angles(a, -b, -c, core::f64::consts::PI - theta, -rate);
            for t in [0.0, 0.7, 3.1, -20.0] {
                let sum = motion.cos_theta(t) + other.cos_theta(t);
                tilts.push_at(sum, t);
                if !motion.passes_pole() {
                    let turned = motion.angles(t).phi + other.angles(t).phi - 0.6;
                    turns.push_at(turned, t);
                }
            }
        }
    }
    // pi - theta is rounded, and t is up to 20.
    assert_largest!(tilts, 48, @"104");
    assert_largest!(turns, 28, @"77");
}

/// A million nutations are a million times one: R(t + nT) = Rz(n dphi) R(t) Rz(n dzeta).
#[test]
fn a_million_periods_are_a_power_of_one() {
    let motion = by_energy(2.0, 0.6, 0.2, 0.11, Start::ThetaMin);
    let period = motion.nutation_period();
    let mut errors = Errors::in_units_of(EPS, "angles");
    for n in [1.0, 64.0, 65_536.0, 1_048_576.0] {
        let early = motion.angles(1.25);
        let late = motion.angles(1.25 + n * period);
        let turned = [
            late.phi - early.phi - n * motion.precession_per_period(),
            late.theta - early.theta,
            late.zeta - early.zeta - n * motion.spin_per_period(),
        ];
        // The period itself is rounded: n T eps times the rates (at most 1).
        for value in turned {
            errors.push_at(value / (4.0 + n * period), n);
        }
    }
    assert_largest!(errors, 3 * 4, @"0.921");
}
