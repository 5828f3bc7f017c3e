//! Values to and from documents (feature `serde`): what is written is read back bit for
//! bit, and what no constructor would take is refused with its numbers.

use rotation_dynamics::attitude::{Attitude, EulerAngles, YawPitchRoll};
use rotation_dynamics::body::{DesignedBody, RigidBody, State};
use rotation_dynamics::frame::{BodyVector, DesignVector, SpaceVector};
use rotation_dynamics::inertia::{InertiaTensor, MassProperties, PrincipalMoments, solids};
use serde_core::de::value::{Error as ValueError, MapDeserializer, SeqDeserializer};
use serde_core::{Deserialize, Serialize};
use serde_json::{from_str, to_string};
use std::fmt::Debug;

/// The document of a value that is read back the same.
fn document<T: Serialize + for<'de> Deserialize<'de> + PartialEq + Debug>(value: &T) -> String {
    let text = to_string(value).expect("written");
    assert_eq!(&from_str::<T>(&text).expect("read"), value, "{text}");
    text
}

#[test]
fn what_is_written_is_read_back_bit_for_bit() -> rotation_dynamics::Result<()> {
    assert_eq!(document(&SpaceVector::new(1e-300, -0.1, 5e-324)), "[1e-300,-0.1,5e-324]");
    let angles = EulerAngles { phi: 0.3, theta: 0.7, zeta: -0.4 };
    assert_eq!(document(&angles), r#"{"phi":0.3,"theta":0.7,"zeta":-0.4}"#);
    let angles_of_a_ship = YawPitchRoll { yaw: 2.0, pitch: -0.1, roll: 0.25 };
    assert_eq!(document(&angles_of_a_ship), r#"{"yaw":2.0,"pitch":-0.1,"roll":0.25}"#);
    let moments = PrincipalMoments::new(0.1, 0.7, 0.8)?;
    let body = RigidBody::new(moments);
    assert_eq!(document(&body), r#"{"moments":{"i1":0.1,"i2":0.7,"i3":0.8}}"#);
    let parts = [
        solids::cuboid(2.0, 0.1, 0.3, 0.7)?,
        solids::rod(0.3, 1.1)?.displaced(DesignVector::new(0.2, 0.5, -0.1))?,
    ];
    document(&MassProperties::of_parts(&parts)?);
    assert_eq!(
        document(&InertiaTensor::diagonal([1.0, 2.0, 2.5])?),
        "[[1.0,0.0,0.0],[0.0,2.0,0.0],[0.0,0.0,2.5]]"
    );
    let tensor = MassProperties::of_parts(&parts)?.about_centre_of_mass();
    let body_of_parts = DesignedBody::new(&tensor)?;
    assert_eq!(document(&body_of_parts), document(&tensor));
    let mut read = 0;
    let mut attitude = Attitude::from_euler(angles)?;
    for _ in 0..1000 {
        attitude = attitude * Attitude::from_euler(angles)?;
        let state = body.state(attitude, BodyVector::new(0.1, 0.2, 0.3))?;
        document(&state);
        read += 1;
    }
    assert_eq!(read, 1000);
    let rest = State::new(Attitude::IDENTITY, SpaceVector::zero())?;
    assert_eq!(
        document(&rest),
        r#"{"attitude":{"w":1.0,"x":0.0,"y":0.0,"z":0.0},"angular_momentum":[0.0,0.0,0.0]}"#
    );
    Ok(())
}

/// What is said of a document that is refused.
fn refusal<T: for<'de> Deserialize<'de> + Debug>(text: &str) -> String {
    from_str::<T>(text).expect_err(text).to_string()
}

#[test]
fn an_invalid_document_is_refused_with_its_numbers() {
    let said = [
        (
            refusal::<PrincipalMoments>(r#"{"i1": 1, "i2": 1, "i3": 2.5}"#),
            "(1, 1, 2.5) belong to no body",
        ),
        (
            refusal::<RigidBody>(r#"{"moments": {"i1": -1, "i2": 1, "i3": 1}}"#),
            "I1 = -1 is not allowed",
        ),
        (refusal::<Attitude>(r#"{"w": 0, "x": 0, "y": 0, "z": 0}"#), "norm of the quaternion = 0"),
        (
            refusal::<InertiaTensor>("[[1, 0.1, 0], [0.2, 1, 0], [0, 0, 1]]"),
            "across the diagonal = 0.1",
        ),
        (
            refusal::<InertiaTensor>("[[1, 2, 0], [2, 1, 0], [0, 0, 1]]"),
            "(-1, 1, 3) belong to no body",
        ),
        (
            refusal::<DesignedBody>("[[1, 0, 0], [0, 1, 0], [0, 0, 0]]"),
            "(1, 1, 0) are those of a rod",
        ),
        (
            refusal::<State>(r#"{"attitude": {"w": 1, "x": 0, "y": 0, "z": 0}}"#),
            "missing field `angular_momentum`",
        ),
        (
            refusal::<EulerAngles>(r#"{"phi": 1, "theta": 2, "psi": 3}"#),
            "unknown field `psi`, expected one of `phi`, `theta`, `zeta`",
        ),
        (
            refusal::<EulerAngles>(r#"{"phi": 1, "phi": 2, "theta": 3, "zeta": 4}"#),
            "duplicate field `phi`",
        ),
        (refusal::<EulerAngles>("3"), "EulerAngles of phi, theta, zeta"),
        (refusal::<SpaceVector>("[1, 2]"), "array of length 3"),
        (refusal::<SpaceVector>("[1, 2, null]"), "null"),
    ];
    for (message, words) in &said {
        assert!(message.contains(words), "{message:?} lacks {words:?}");
    }
    assert_eq!(said.len(), 12);
}

/// Formats that know NaN, and those that write no names.
#[test]
fn other_formats_are_held_to_the_same() {
    let named = |values: [f64; 4]| {
        let fields = ["w", "x", "y", "z"].into_iter().zip(values);
        Attitude::deserialize(MapDeserializer::<_, ValueError>::new(fields))
    };
    assert_eq!(named([1.0, 0.0, 0.0, 0.0]), Ok(Attitude::IDENTITY));
    let error = named([1.0, f64::NAN, 0.0, 0.0]).unwrap_err().to_string();
    assert_eq!(error, "x = NaN is not a finite number");

    let listed = |values: &[f64]| {
        let list = SeqDeserializer::<_, ValueError>::new(values.iter().copied());
        PrincipalMoments::deserialize(list)
    };
    assert_eq!(listed(&[1.0, 2.0, 2.5]).map(PrincipalMoments::to_array), Ok([1.0, 2.0, 2.5]));
    let error = listed(&[1.0, f64::INFINITY, 1.0]).unwrap_err().to_string();
    assert_eq!(error, "I2 = inf is not a finite number");
    let error = listed(&[1.0, 2.0]).unwrap_err().to_string();
    assert_eq!(error, "missing field `i3`");
}
