//! Yaw, pitch and roll: z-y'-x'', the angles of vehicles.

use super::{Attitude, Sequence};
use crate::error::Result;
use crate::frame::BodyVector;

/// The angles of aircraft, ships and vehicles: R = Rz(yaw) Ry(pitch) Rx(roll), in radians.
///
/// Turns about z, the new y, the newest x; [`Sequence::Zyx`] by names. In aviation x points
/// forward, y to the right and z down, on the body as on the fixed axes (north, east,
/// down): a positive pitch then raises the nose. With Z up, as in the notes, it lowers it.
///
/// Any finite values are an attitude; the result of [`Attitude::yaw_pitch_roll`] has pitch in
/// [-pi/2, pi/2] and the others in [-pi, pi].
///
/// ```
/// use rotation_dynamics::attitude::{Attitude, YawPitchRoll};
/// use std::f64::consts::FRAC_PI_2;
/// # fn main() -> rotation_dynamics::Result<()> {
/// // Straight up, yaw and roll are about one line: yaw carries both, roll is zero.
/// let upright = YawPitchRoll { yaw: 0.5, pitch: FRAC_PI_2, roll: 0.125 };
/// let back = Attitude::from_yaw_pitch_roll(upright)?.yaw_pitch_roll();
/// assert_eq!((back.pitch, back.roll), (FRAC_PI_2, 0.0));
/// assert!((back.yaw - 0.375).abs() < 1e-15);
/// # Ok(())
/// # }
/// ```
///
/// Source: ISO 1151-2:1985 and DIN 9300; J. Diebel, Representing Attitude (2006), 8.2.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct YawPitchRoll {
    /// Turn about the fixed Z (rad).
    pub yaw: f64,
    /// Inclination of the body axis x (rad).
    pub pitch: f64,
    /// Turn about the body axis x (rad).
    pub roll: f64,
}

/// The time derivatives of yaw, pitch and roll, in rad/s.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct YawPitchRollRates {
    /// Rate of yaw (rad/s).
    pub yaw: f64,
    /// Rate of pitch (rad/s).
    pub pitch: f64,
    /// Rate of roll (rad/s).
    pub roll: f64,
}

impl Attitude {
    /// The attitude with this yaw, pitch and roll, of any finite size.
    ///
    /// Errors and accuracy: as [`Attitude::from_sequence`].
    pub fn from_yaw_pitch_roll(angles: YawPitchRoll) -> Result<Self> {
        Self::from_sequence(Sequence::Zyx, angles.to_array())
    }

    /// Yaw, pitch and roll: pitch in [-pi/2, pi/2], the others in [-pi, pi].
    ///
    /// Accuracy, cost and the lock: as [`Attitude::angles`]; where the body points straight
    /// up or down roll is zero and yaw carries both.
    pub fn yaw_pitch_roll(&self) -> YawPitchRoll {
        let [yaw, pitch, roll] = self.angles(Sequence::Zyx);
        YawPitchRoll { yaw, pitch, roll }
    }
}

impl YawPitchRoll {
    /// Angular velocity on the body's axes, in rad/s:
    /// (roll' - yaw' sin p, pitch' cos r + yaw' cos p sin r, yaw' cos p cos r - pitch' sin r).
    ///
    /// Accuracy: as [`Sequence::angular_velocity`].
    pub fn angular_velocity(&self, rates: YawPitchRollRates) -> BodyVector {
        let YawPitchRollRates { yaw, pitch, roll } = rates;
        Sequence::Zyx.angular_velocity(self.to_array(), [yaw, pitch, roll])
    }

    /// The rates of yaw, pitch and roll for an angular velocity on the body's axes.
    ///
    /// yaw' = (w2 sin r + w3 cos r)/cos p, pitch' = w2 cos r - w3 sin r,
    /// roll' = w1 + yaw' sin p.
    ///
    /// Errors and accuracy: as [`Sequence::rates`]; the lock is at a pitch of pi/2.
    pub fn rates(&self, angular_velocity: BodyVector) -> Result<YawPitchRollRates> {
        let [yaw, pitch, roll] = Sequence::Zyx.rates(self.to_array(), angular_velocity)?;
        Ok(YawPitchRollRates { yaw, pitch, roll })
    }

    const fn to_array(self) -> [f64; 3] {
        [self.yaw, self.pitch, self.roll]
    }
}
