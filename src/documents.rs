//! How values are written to documents and read from them (feature `serde`).
//!
//! A vector is the list of its components, and a tensor (and a body on the axes of its drawing) is
//! the list of its rows. All else is a record of named fields in SI units and radians. The frame of
//! a vector is not written: its meaning says it. The accuracy of a computed tensor is not written
//! either: rows that are read count as given. Input goes through the constructors, so an invalid
//! document is an error that names its numbers; so are a field that is unknown and one that comes
//! twice.
//!
//! ```json
//! {"attitude": {"w": 1, "x": 0, "y": 0, "z": 0}, "angular_momentum": [0, 0, 0.25]}
//! ```

use crate::attitude::{Attitude, EulerAngles, YawPitchRoll};
use crate::body::{DesignedBody, RigidBody, State};
use crate::frame::{DesignVector, Frame, SpaceVector, Vector};
use crate::inertia::{InertiaTensor, MassProperties, PrincipalMoments};
use core::fmt;
use serde_core::de::{Error, MapAccess, SeqAccess, Visitor};
use serde_core::ser::SerializeStruct;
use serde_core::{Deserialize, Deserializer, Serialize, Serializer};

impl<F: Frame> Serialize for Vector<F> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.to_array().serialize(serializer)
    }
}

impl<'de, F: Frame> Deserialize<'de> for Vector<F> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        <[f64; 3]>::deserialize(deserializer).map(Self::from_array)
    }
}

impl Serialize for InertiaTensor {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.matrix().serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for InertiaTensor {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        Self::new(Deserialize::deserialize(deserializer)?).map_err(D::Error::custom)
    }
}

/// A body on the axes of its drawing is its tensor.
impl Serialize for DesignedBody {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.tensor().serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for DesignedBody {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        Self::new(&InertiaTensor::deserialize(deserializer)?).map_err(D::Error::custom)
    }
}

/// `record!(Type { field: Type, .. } from |value| (fields), by constructor)`.
macro_rules! record {
    ($type:ident { $($field:ident: $part:ty),+ } from $parts:expr, by $make:expr) => {
        impl Serialize for $type {
            fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                let parts: fn(&$type) -> ($($part,)+) = $parts;
                let ($($field,)+) = parts(self);
                let fields = [$(stringify!($field)),+].len();
                let mut record = serializer.serialize_struct(stringify!($type), fields)?;
                $(record.serialize_field(stringify!($field), &$field)?;)+
                record.end()
            }
        }

        impl<'de> Deserialize<'de> for $type {
            fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                const FIELDS: &[&str] = &[$(stringify!($field)),+];
                struct Record;
                impl<'de> Visitor<'de> for Record {
                    type Value = $type;

                    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                        write!(f, "{} of {}", stringify!($type), FIELDS.join(", "))
                    }

                    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<$type, A::Error> {
                        $(let $field: $part = list
                            .next_element()?
                            .ok_or_else(|| A::Error::missing_field(stringify!($field)))?;)+
                        ($make)($($field),+).map_err(A::Error::custom)
                    }

                    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<$type, A::Error> {
                        $(let mut $field: Option<$part> = None;)+
                        while let Some(key) = map.next_key::<String>()? {
                            match key.as_str() {
                                $(stringify!($field) if $field.is_some() => {
                                    return Err(A::Error::duplicate_field(stringify!($field)));
                                }
                                stringify!($field) => $field = Some(map.next_value()?),)+
                                _ => return Err(A::Error::unknown_field(&key, FIELDS)),
                            }
                        }
                        $(let $field = $field
                            .ok_or_else(|| A::Error::missing_field(stringify!($field)))?;)+
                        ($make)($($field),+).map_err(A::Error::custom)
                    }
                }
                deserializer.deserialize_struct(stringify!($type), FIELDS, Record)
            }
        }
    };
}

record!(Attitude { w: f64, x: f64, y: f64, z: f64 }
    from |a| a.quaternion().into(), by |w, x, y, z| Attitude::from_quaternion([w, x, y, z]));
record!(EulerAngles { phi: f64, theta: f64, zeta: f64 }
from |a| (a.phi, a.theta, a.zeta), by |phi, theta, zeta| {
    let angles = EulerAngles { phi, theta, zeta };
    Attitude::from_euler(angles).map(|_| angles)
});
record!(PrincipalMoments { i1: f64, i2: f64, i3: f64 }
    from |m| m.to_array().into(), by PrincipalMoments::new);
record!(MassProperties {
        mass: f64, centre_of_mass: DesignVector, about_centre_of_mass: InertiaTensor
    }
    from |p| (p.mass(), p.centre_of_mass(), p.about_centre_of_mass()), by MassProperties::new);
record!(RigidBody { moments: PrincipalMoments }
    from |b| (b.moments(),), by |moments| crate::Result::Ok(RigidBody::new(moments)));
record!(State { attitude: Attitude, angular_momentum: SpaceVector }
    from |s| (s.attitude, s.angular_momentum), by State::new);
record!(YawPitchRoll { yaw: f64, pitch: f64, roll: f64 }
from |a| (a.yaw, a.pitch, a.roll), by |yaw, pitch, roll| {
    let angles = YawPitchRoll { yaw, pitch, roll };
    Attitude::from_yaw_pitch_roll(angles).map(|_| angles)
});
