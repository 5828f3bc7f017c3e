//! To and from nalgebra's types (feature `nalgebra`), and its own formulae beside ours.

use super::Random;
use super::sequences::some_angles;
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use rotation_dynamics::attitude::{Attitude, Sequence, YawPitchRoll};
use rotation_dynamics::error::Error;
use rotation_dynamics::frame::BodyVector;
use rotation_dynamics::math::{self, EPS};
use support::Errors;

#[test]
fn columns_convert_both_ways() {
    let given = [1.5, -2.0, 1e-300];
    let vector = BodyVector::from(given);
    assert_eq!(Vector3::from(vector), Vector3::new(1.5, -2.0, 1e-300));
    assert_eq!(BodyVector::from(Vector3::from(given)), vector);
}

#[test]
fn it_turns_vectors_alike() {
    let mut random = Random(42);
    let mut errors = Errors::in_units_of(EPS, "nalgebra's turn");
    for _ in 0..1000 {
        let (attitude, v) = (random.attitude(), random.vector());
        let theirs = UnitQuaternion::from(attitude);
        assert_eq!(Attitude::try_from(theirs), Ok(attitude));
        let turned = (theirs * Vector3::from(v)).into();
        let ours = attitude.to_space(BodyVector::from(v));
        errors.add((ours - turned).norm(), 0.0, ours.norm());
        let inverse = Attitude::try_from(theirs.inverse()).expect("finite");
        errors.push(inverse.angle_to(&attitude.inverse()));
    }
    // Theirs is the same formula.
    errors.attain(0.0..=0.0, 2 * 1000);
    let nan = UnitQuaternion::new_unchecked(Quaternion::new(f64::NAN, 0.0, 0.0, 0.0));
    let error = Attitude::try_from(nan).unwrap_err();
    assert!(
        matches!(error, Error::NotFinite { name: "w", .. }),
        "{error}"
    );
}

/// nalgebra's own yaw, pitch and roll.
#[test]
fn its_yaw_pitch_and_roll_are_ours() {
    let mut random = Random(33);
    let mut errors = Errors::in_units_of(EPS, "against nalgebra");
    for _ in 0..2000 {
        let [yaw, pitch, roll] = some_angles(&mut random, Sequence::Zyx, 0);
        let pitch = pitch / 2.1;
        let ours = Attitude::from_yaw_pitch_roll(YawPitchRoll { yaw, pitch, roll });
        let ours = ours.expect("finite");
        let theirs = UnitQuaternion::from_euler_angles(roll, pitch, yaw);
        errors.push(ours.angle_to(&theirs.try_into().expect("finite")));
        let (their_roll, their_pitch, their_yaw) = theirs.euler_angles();
        let angles = ours.yaw_pitch_roll();
        let condition = math::cos(pitch);
        errors.push((angles.yaw - their_yaw) * condition);
        errors.push((angles.pitch - their_pitch) * condition);
        errors.push((angles.roll - their_roll) * condition);
    }
    errors.attain(4.7..=4.8, 4 * 2000);
}
