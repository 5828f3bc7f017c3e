//! Angular velocity and the rates of the Euler angles (notes 15.2).

use super::angles_near_a_pole;
use rotation_dynamics::attitude::{Attitude, EulerAngles, EulerRates};
use rotation_dynamics::error::Error;
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::math::{self, DoubleDouble, EPS};
use std::f64::consts::PI;
use support::{Errors, Random, assert_error, assert_largest};

/// Notes 15.2 (5): Omega = phi' Z + theta' x + zeta' z, summed as vectors in space.
#[test]
fn angular_velocity_is_the_sum_of_three_turns() {
    let mut random = Random(5);
    let [mut errors, mut routes, mut and_back] =
        ["eq. (5)", "in space", "back to the rates"].map(|what| Errors::in_units_of(EPS, what));
    for i in 0..4000 {
        let angles = angles_near_a_pole(&mut random, [0, 1, 2, 4][i % 4]);
        let [phi, theta, zeta] = random.vector();
        let rates = EulerRates { phi, theta, zeta };
        let attitude = Attitude::from_euler(angles).expect("finite angles");
        let (sin_phi, cos_phi) = math::sincos(angles.phi);
        let in_space = SpaceVector::new(0.0, 0.0, phi)
            + SpaceVector::new(cos_phi, sin_phi, 0.0) * theta
            + attitude.axis() * zeta;
        let got = angles.angular_velocity(rates);
        let size = phi.abs() + theta.abs() + zeta.abs();
        routes.add((got - attitude.to_body(in_space)).norm(), 0.0, size);
        // Eq. (5) on the body's axes, to 100 bits.
        let (s, c) = DoubleDouble::from(angles.theta).sin_cos();
        let (sin_zeta, cos_zeta) = DoubleDouble::from(angles.zeta).sin_cos();
        let exact = [
            cos_zeta * theta + s * sin_zeta * phi,
            s * cos_zeta * phi - sin_zeta * theta,
            c * phi + zeta,
        ];
        for (exact, got) in exact.into_iter().zip(got.to_array()) {
            errors.add((exact - got).to_f64(), 0.0, size);
        }
        // And back, against the condition 1/sin theta.
        let back = angles.rates(got).expect("not at a pole");
        let condition = math::sin(angles.theta);
        for error in [back.phi - phi, back.theta - theta, back.zeta - zeta] {
            and_back.push(error * condition);
        }
    }
    assert_largest!(errors, 3 * 4000, @"1.52");
    assert_largest!(routes, 4000, @"10.3");
    assert_largest!(and_back, 3 * 4000, @"2.24");
}

/// Notes 15.2 (6) against the turning of the attitude itself.
#[test]
fn angular_velocity_is_how_the_attitude_turns() {
    let angles = EulerAngles { phi: 0.4, theta: 1.1, zeta: -0.7 };
    let rates = EulerRates { phi: 0.8, theta: -0.5, zeta: 1.9 };
    let at = |t: f64| {
        Attitude::from_euler(EulerAngles {
            phi: angles.phi + rates.phi * t,
            theta: angles.theta + rates.theta * t,
            zeta: angles.zeta + rates.zeta * t,
        })
        .expect("finite angles")
    };
    let error = |h: f64, velocity: BodyVector| {
        let turned = (at(-h).inverse() * at(h)).rotation_vector();
        (BodyVector::from_array(turned.to_array()) / (2.0 * h) - velocity).norm()
    };
    let velocity = angles.angular_velocity(rates);
    let order = math::log2(error(0.02, velocity) / error(0.01, velocity));
    assert_error!(order, 2.000);
    // Damaged: the term phi' cos theta left out, as if the spin were the whole of w3.
    let wrong = BodyVector::new(velocity.x(), velocity.y(), rates.zeta);
    let order = math::log2(error(0.02, wrong) / error(0.01, wrong));
    assert!(order.abs() < 0.1, "{order}");
}

#[test]
fn at_a_pole_the_rates_are_refused() {
    for theta in [0.0, -0.0, PI, -PI, 2.0 * PI] {
        let angles = EulerAngles { phi: 0.1, theta, zeta: 0.2 };
        let error = angles.rates(BodyVector::new(1.0, 0.0, 0.0)).unwrap_err();
        assert!(matches!(error, Error::GimbalLock { angle, .. } if angle == theta));
        assert!(error.to_string().contains("multiple of pi"));
    }
    let close = EulerAngles { phi: 0.0, theta: 1e-300, zeta: 0.0 };
    assert!(close.rates(BodyVector::new(0.0, 1.0, 0.0)).is_ok());
    let overflow = close.rates(BodyVector::new(0.0, 1e10, 0.0)).unwrap_err();
    assert!(matches!(overflow, Error::NotFinite { name: "phi'", .. }));
}
