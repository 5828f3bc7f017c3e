//! The representations of an attitude, as a reader would give it and be given it.

use rotation_dynamics::Result;
use rotation_dynamics::attitude::Attitude;

/// An attitude written as numbers, and read back.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Form {
    Quaternion,
    Matrix,
    Euler,
    YawPitchRoll,
    RotationVector,
}

impl Form {
    pub const ALL: [Self; 5] = [
        Self::Quaternion,
        Self::Matrix,
        Self::Euler,
        Self::YawPitchRoll,
        Self::RotationVector,
    ];

    /// The names of all.
    pub const NAMES: [&'static str; 5] = [
        Self::Quaternion.name(),
        Self::Matrix.name(),
        Self::Euler.name(),
        Self::YawPitchRoll.name(),
        Self::RotationVector.name(),
    ];

    pub const fn name(self) -> &'static str {
        match self {
            Self::Quaternion => "quaternion",
            Self::Matrix => "matrix",
            Self::Euler => "Euler angles",
            Self::YawPitchRoll => "yaw, pitch, roll",
            Self::RotationVector => "rotation vector",
        }
    }

    /// The attitude written in this form and read from it.
    pub fn through(self, attitude: Attitude) -> Result<Attitude> {
        match self {
            Self::Quaternion => Attitude::from_quaternion(attitude.quaternion()),
            Self::Matrix => Attitude::from_matrix(attitude.matrix()),
            Self::Euler => Attitude::from_euler(attitude.euler_angles()),
            Self::YawPitchRoll => Attitude::from_yaw_pitch_roll(attitude.yaw_pitch_roll()),
            Self::RotationVector => Attitude::from_rotation_vector(attitude.rotation_vector()),
        }
    }
}
