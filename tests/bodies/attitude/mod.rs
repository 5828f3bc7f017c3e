//! Attitude: against 700-digit values (tests/data/attitude.txt, written by
//! attitude.py), against itself over random attitudes, and against plain forms
//! that look right and are not.
//!
//! eps = 2^-53.

mod between;
mod fitted;
mod properties;
mod quaternions;
mod rates;
mod references;
mod sequence_rates;
mod sequences;

use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::error::Error;
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::math;
use std::f64::consts::PI;
use support::Random;

fn any_attitude(random: &mut Random) -> Attitude {
    Attitude::from_quaternion(random.vector()).expect("not zero")
}

fn unit(quaternion: [f64; 4]) -> Attitude {
    Attitude::from_quaternion(quaternion).expect("not zero")
}

fn turned_by(random: &mut Random, attitude: &Attitude, size: f64) -> Attitude {
    let by = BodyVector::from(random.vector()) * size;
    attitude.turned_in_body(by).expect("finite")
}

/// Angles with theta (or pi - theta) generic, small, tiny or zero.
fn angles_near_a_pole(random: &mut Random, kind: usize) -> EulerAngles {
    let small = match kind % 4 {
        0 => random.between(0.0, PI),
        1 => math::pow(10.0, random.between(-20.0, 0.0)),
        2 => math::pow(10.0, random.between(-300.0, -20.0)),
        _ => 0.0,
    };
    EulerAngles {
        phi: random.between(-PI, PI),
        theta: if kind < 4 { small } else { PI - small },
        zeta: random.between(-PI, PI),
    }
}

#[test]
fn at_the_poles_zeta_is_zero_and_phi_keeps_what_has_a_meaning() {
    let at = |w: f64, x: f64, y: f64, z: f64| {
        let a = Attitude::from_quaternion([w, x, y, z]).expect("not zero").euler_angles();
        [a.phi, a.theta, a.zeta]
    };
    assert_eq!(at(1.0, 0.0, 0.0, 0.0), [0.0, 0.0, 0.0]);
    assert_eq!(at(-1.0, 0.0, 0.0, 0.0), [0.0, 0.0, 0.0]);
    assert_eq!(at(0.0, 0.0, 0.0, 1.0), [PI, 0.0, 0.0]);
    assert_eq!(at(0.0, 0.0, 0.0, -1.0), [PI, 0.0, 0.0]);
    assert_eq!(at(0.0, 1.0, 0.0, 0.0), [0.0, PI, 0.0]);
    assert_eq!(at(0.0, -1.0, 0.0, 0.0), [0.0, PI, 0.0]);
    assert_eq!(at(0.0, 0.0, 1.0, 0.0), [PI, PI, 0.0]);
    // A step off the pole the true angles are back: e3 leans towards -Y for phi = 0.
    let lean = at(1.0, 5e-324, 0.0, 0.0);
    assert_eq!((lean[0], lean[2]), (0.0, 0.0));
    assert!(lean[1] > 0.0);
    assert_eq!(at(1.0, 0.0, 1e-300, 0.0), [PI / 2.0, 2e-300, -PI / 2.0]);
}

#[test]
fn bad_input_is_an_error_with_the_numbers() {
    let mut count = 0;
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for place in 0..4 {
            let mut q = [0.5; 4];
            q[place] = bad;
            let error = Attitude::from_quaternion(q).unwrap_err();
            assert!(matches!(error, Error::NotFinite { .. }), "{error}");
            count += 1;
        }
        for place in 0..3 {
            let mut v = [0.5; 3];
            v[place] = bad;
            let [phi, theta, zeta] = v;
            assert!(Attitude::from_euler(EulerAngles { phi, theta, zeta }).is_err());
            assert!(Attitude::from_rotation_vector(SpaceVector::from_array(v)).is_err());
            assert!(Attitude::about_space_axis(SpaceVector::from_array(v), 1.0).is_err());
            assert!(Attitude::about_body_axis(BodyVector::from_array(v), 1.0).is_err());
            assert!(Attitude::IDENTITY.turned_in_space(SpaceVector::from_array(v)).is_err());
            let tilted = EulerAngles { phi: 0.0, theta: 1.0, zeta: 0.0 };
            assert!(tilted.rates(BodyVector::from_array(v)).is_err());
            let mut matrix = Attitude::IDENTITY.matrix();
            matrix[place][2 - place] = bad;
            assert!(Attitude::from_matrix(matrix).is_err());
            count += 7;
        }
        assert!(Attitude::about_space_axis(SpaceVector::new(0.0, 0.0, 1.0), bad).is_err());
        count += 1;
    }
    assert_eq!(count, 78);
    let zero = Attitude::from_quaternion([0.0; 4]).unwrap_err().to_string();
    assert_eq!(zero, "norm of the quaternion = 0 is not allowed: it must be greater than 0");
    assert!(Attitude::about_space_axis(SpaceVector::zero(), 1.0).is_err());
    // A length that overflows, and one that nearly does.
    let huge = SpaceVector::new(1.5e308, 1.5e308, 0.0);
    assert!(Attitude::from_rotation_vector(huge).is_err());
    let large = SpaceVector::new(1e308, 1e307, -3.0);
    let turned = Attitude::from_rotation_vector(large).expect("finite");
    assert!(turned.quaternion().iter().all(|c| c.is_finite()));

    let mut reflected = Attitude::IDENTITY.matrix();
    reflected[2][2] = -1.0;
    let error = Attitude::from_matrix(reflected).unwrap_err();
    assert!(matches!(error, Error::NotRotation { deviation: 0.0, determinant: -1.0 }));
    let mut sheared = Attitude::IDENTITY.matrix();
    sheared[0][1] = 1e-11;
    let error = Attitude::from_matrix(sheared).unwrap_err().to_string();
    assert!(error.contains("off 1 by 1.000e-11"), "{error}");
}

#[test]
fn a_unit_quaternion_is_kept_bit_for_bit() {
    let mut random = Random(6);
    let mut count = 0;
    for _ in 0..4000 {
        let attitude = any_attitude(&mut random) * any_attitude(&mut random);
        assert_eq!(Attitude::from_quaternion(attitude.quaternion()), Ok(attitude));
        count += 1;
    }
    assert_eq!(count, 4000);
}
