//! Quaternions as others write them.

use super::any_attitude;
use nalgebra::{UnitQuaternion, Vector3};
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::error::Error;
use rotation_dynamics::frame::BodyVector;
use rotation_dynamics::math::EPS;
use support::{Errors, Random, assert_largest};

/// Shuster's product, scalar last, ij = -k: A(p) A(q) = A(p * q), A space -> body.
fn shuster([a, b, c, d]: [f64; 4], [x, y, z, w]: [f64; 4]) -> [f64; 4] {
    [
        d * x + w * a - (b * z - c * y),
        d * y + w * b - (c * x - a * z),
        d * z + w * c - (a * y - b * x),
        d * w - (a * x + b * y + c * z),
    ]
}

/// Shuster's matrix of a quaternion: (w^2 - v^2) 1 + 2 v v^T - 2 w [v x].
fn shuster_matrix([x, y, z, w]: [f64; 4]) -> [[f64; 3]; 3] {
    let d = w * w - x * x - y * y - z * z;
    [
        [d + 2.0 * x * x, 2.0 * (x * y + w * z), 2.0 * (x * z - w * y)],
        [2.0 * (x * y - w * z), d + 2.0 * y * y, 2.0 * (y * z + w * x)],
        [2.0 * (x * z + w * y), 2.0 * (y * z - w * x), d + 2.0 * z * z],
    ]
}

#[test]
fn the_other_product_has_the_same_numbers() {
    let mut random = Random(41);
    let mut errors = Errors::in_units_of(EPS, "Shuster's");
    let mut damaged = Errors::of("the same order of factors");
    for _ in 0..1000 {
        let (a, b) = (any_attitude(&mut random), any_attitude(&mut random));
        assert_eq!(Attitude::from_xyzw(a.xyzw()), Ok(a));
        let matrix = shuster_matrix(a.xyzw());
        for (row, ours) in matrix.iter().zip(a.inverse().matrix()) {
            for (theirs, ours) in row.iter().zip(ours) {
                errors.push(theirs - ours);
            }
        }
        let there = Attitude::from_xyzw(shuster(b.xyzw(), a.xyzw())).expect("not zero");
        errors.push((a * b).angle_to(&there));
        let wrong = Attitude::from_xyzw(shuster(a.xyzw(), b.xyzw())).expect("not zero");
        damaged.push((a * b).angle_to(&wrong));
    }
    assert_largest!(errors, 10 * 1000, @"3.33");
    damaged.exceed(0.0, 1000);
}

#[test]
fn nalgebra_turns_vectors_alike() {
    let mut random = Random(42);
    let mut errors = Errors::in_units_of(EPS, "nalgebra's turn");
    for _ in 0..1000 {
        let (attitude, v) = (any_attitude(&mut random), random.vector());
        let theirs = UnitQuaternion::from(attitude);
        assert_eq!(Attitude::try_from(theirs), Ok(attitude));
        let turned = (theirs * Vector3::from(v)).into();
        let ours = attitude.to_space(BodyVector::from(v));
        errors.add((ours - turned).norm(), 0.0, ours.norm());
        let inverse = Attitude::try_from(theirs.inverse()).expect("finite");
        errors.push(inverse.angle_to(&attitude.inverse()));
    }
    // Theirs is the same formula.
    assert_largest!(errors, 2 * 1000, @"0");
    let nan = UnitQuaternion::new_unchecked(nalgebra::Quaternion::new(f64::NAN, 0.0, 0.0, 0.0));
    let error = Attitude::try_from(nan).unwrap_err();
    assert!(matches!(error, Error::NotFinite { name: "w", .. }), "{error}");
}
