//! Attitude over random attitudes, errors formed to 100 bits.

use super::{angles_near_a_pole, any_attitude};
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::math::{DoubleDouble, EPS};
use std::f64::consts::PI;
use support::{Errors, Random, assert_error, assert_largest};

/// The exact quaternion of Euler angles, to 100 bits.
fn exact_quaternion(angles: EulerAngles) -> [DoubleDouble; 4] {
    let (s, c) = DoubleDouble::from(angles.theta).scaled(0.5).sin_cos();
    let (sin_sum, cos_sum) = DoubleDouble::sum(angles.phi, angles.zeta).scaled(0.5).sin_cos();
    let (sin_diff, cos_diff) = DoubleDouble::sum(angles.phi, -angles.zeta).scaled(0.5).sin_cos();
    [c * cos_sum, s * cos_diff, s * sin_diff, c * sin_sum]
}

/// Angle between an attitude and exact angles, in eps.
fn rotation_error(attitude: Attitude, angles: EulerAngles) -> f64 {
    let [w, x, y, z] = attitude.quaternion();
    let [a, b, c, d] = exact_quaternion(angles);
    let parts = [
        b * w - a * x - d * y + c * z,
        c * w - a * y - b * z + d * x,
        d * w - a * z - c * x + b * y,
    ];
    2.0 * SpaceVector::from_array(parts.map(DoubleDouble::to_f64)).norm() / EPS
}

#[test]
fn angles_and_back_over_random_attitudes() {
    let mut random = Random(1);
    let [mut out, mut into] = ["euler_angles", "from_euler"].map(Errors::of);
    let mut round = Errors::in_units_of(EPS, "round trip");
    for kind in 0..8 {
        for _ in 0..4000 {
            let given = angles_near_a_pole(&mut random, kind);
            let attitude = Attitude::from_euler(given).expect("finite angles");
            into.push_at(rotation_error(attitude, given), given);
            let angles = attitude.euler_angles();
            out.push_at(rotation_error(attitude, angles), angles);
            assert!((0.0..=PI).contains(&angles.theta) && angles.phi.abs() <= PI);
            let back = Attitude::from_euler(angles).expect("finite angles");
            round.push_at(attitude.angle_to(&back), angles);
        }
    }
    assert_largest!(out, 32_000, @"2.70");
    assert_largest!(into, 32_000, @"3.12");
    assert_largest!(round, 32_000, @"3.59");
    // Damaged: an angle off by 10 eps.
    let given = EulerAngles { phi: 0.25, theta: 0.5, zeta: 0.5 };
    let off = EulerAngles { phi: 0.25 + 10.0 * EPS, ..given };
    let attitude = Attitude::from_euler(given).expect("finite angles");
    assert!(rotation_error(attitude, off) > 4.5);
}

#[test]
fn composition_is_a_group_and_stays_on_the_unit_sphere() {
    let mut random = Random(2);
    let mut errors = Errors::in_units_of(EPS, "group");
    for _ in 0..4000 {
        let (a, b, c) =
            (any_attitude(&mut random), any_attitude(&mut random), any_attitude(&mut random));
        errors.push(((a * b) * c).angle_to(&(a * (b * c))));
        errors.push((a * a.inverse()).angle_to(&Attitude::IDENTITY));
        assert_eq!(b.then(&a), a * b);
        // As matrices multiply: R(ab) v = R(a) (R(b) v).
        let v = BodyVector::from_array(random.vector());
        let once = (a * b).to_space(v);
        let twice = a.to_space(BodyVector::from_array(b.to_space(v).to_array()));
        errors.add((once - twice).norm(), 0.0, v.norm());
        errors.add((a.to_body(a.to_space(v)) - v).norm(), 0.0, v.norm());
    }
    assert_largest!(errors, 4 * 4000, @"8.97");
    let (a, b) = (any_attitude(&mut random), any_attitude(&mut random));
    assert!((a * b).angle_to(&(b * a)) > 0.1, "rotations do not commute");

    let step = any_attitude(&mut random);
    let mut turned = Attitude::IDENTITY;
    let mut lengths = Errors::in_units_of(EPS, "length of the quaternion");
    for _ in 0..1_000_000 {
        turned = step * turned;
        let [w, x, y, z] = turned.quaternion();
        let square = DoubleDouble::product(w, w)
            + DoubleDouble::product(x, x)
            + DoubleDouble::product(y, y)
            + DoubleDouble::product(z, z);
        lengths.push(0.5 * (square - 1.0).to_f64());
    }
    assert_largest!(lengths, 1_000_000, @"1.72");
}

#[test]
fn vectors_cross_the_frames_to_a_few_eps() {
    let mut random = Random(3);
    let mut errors = Errors::in_units_of(EPS, "vector in space");
    for _ in 0..20_000 {
        let (attitude, v) = (any_attitude(&mut random), random.vector());
        let [w, x, y, z] = attitude.quaternion().map(DoubleDouble::from);
        let square = w * w + x * x + y * y + z * z;
        let two = DoubleDouble::from(2.0);
        let matrix = [
            [w * w + x * x - y * y - z * z, two * (x * y - w * z), two * (x * z + w * y)],
            [two * (x * y + w * z), w * w - x * x + y * y - z * z, two * (y * z - w * x)],
            [two * (x * z - w * y), two * (y * z + w * x), w * w - x * x - y * y + z * z],
        ];
        let got = attitude.to_space(BodyVector::from_array(v)).to_array();
        let off = [0, 1, 2].map(|i| {
            let row = matrix[i];
            (((row[0] * v[0] + row[1] * v[1] + row[2] * v[2]) / square) - got[i]).to_f64()
        });
        let length = SpaceVector::from_array(v).norm();
        errors.add(SpaceVector::from_array(off).norm(), 0.0, length);
    }
    assert_largest!(errors, 20_000, @"5.95");
}

#[test]
fn turning_about_space_and_about_body_axes() {
    let mut random = Random(4);
    let mut errors = Errors::in_units_of(EPS, "turns");
    for _ in 0..4000 {
        let start = any_attitude(&mut random);
        let rotation = BodyVector::from_array(random.vector());
        // The same rotation, its axis resolved on either set of axes.
        let in_body = start.turned_in_body(rotation).expect("finite");
        let in_space = start.turned_in_space(start.to_space(rotation)).expect("finite");
        errors.push(in_body.angle_to(&in_space));
        let axis = start.to_space(rotation);
        let about = Attitude::about_space_axis(axis, axis.norm()).expect("an axis") * start;
        errors.push(about.angle_to(&in_space));
        let about = start * Attitude::about_body_axis(rotation, rotation.norm()).expect("an axis");
        errors.push(about.angle_to(&in_space));
    }
    assert_largest!(errors, 3 * 4000, @"9.46");
    // Damaged: body components taken for space components.
    let start = any_attitude(&mut random);
    let in_body = start.turned_in_body(BodyVector::new(0.3, 0.1, 0.0)).expect("finite");
    let wrong = start.turned_in_space(SpaceVector::new(0.3, 0.1, 0.0)).expect("finite");
    assert!(in_body.angle_to(&wrong) > 0.01);
    // Notes 15.1: three turns about Z, the new x, the new z are the Euler angles.
    let (x, z) = (BodyVector::new(1.0, 0.0, 0.0), BodyVector::new(0.0, 0.0, 1.0));
    let mut built = Attitude::IDENTITY;
    for (axis, angle) in [(z, 0.3), (x, 0.7), (z, -0.4)] {
        built = built.turned_in_body(axis * angle).expect("finite");
    }
    let angles = EulerAngles { phi: 0.3, theta: 0.7, zeta: -0.4 };
    let direct = Attitude::from_euler(angles).expect("finite");
    assert_error!(built.angle_to(&direct), 2.0 eps);
}
