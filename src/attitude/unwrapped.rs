//! Angles that go on beyond a turn, and angles that lock where a rounding would hide it.

use super::{Attitude, EulerAngles, Sequence, at};
use crate::error::{Error, Result, finite};
use crate::math::DoubleDouble;
use core::f64::consts::{FRAC_PI_2, PI, TAU};

/// Angles (rad) that go on beyond a turn: whole turns are added so that each is at most half a
/// turn from the one before it; the first stays as it is.
///
/// It is right where the angle is read more than twice a turn; of half a turn exactly nothing tells
/// which way it went.
///
/// Errors: an angle that is not finite, or is beyond 1e15 rad, with its index.
/// Accuracy: each is the given angle and a number of turns 2 pi, rounded once.
///
/// ```
/// use rotation_dynamics::attitude::unwrapped;
/// let read = [3.0, -3.0, -2.5, 2.5];
/// let counted = unwrapped(&read)?;
/// assert!((counted[1] - 3.283).abs() < 1e-3 && counted[3] == 2.5);
/// # Ok::<(), rotation_dynamics::Error>(())
/// ```
pub fn unwrapped(angles: &[f64]) -> Result<Vec<f64>> {
    let mut counted: Vec<f64> = Vec::with_capacity(angles.len());
    for (index, angle) in angles.iter().enumerate() {
        readable(*angle).map_err(at("angles", index))?;
        let last = counted.last().unwrap_or(angle);
        let turns = ((last - angle) / TAU).round_ties_even();
        counted.push((DoubleDouble::TWO_PI * turns + *angle).to_f64());
    }
    Ok(counted)
}

fn readable(angle: f64) -> Result<()> {
    if finite("angle", angle)?.abs() <= 1e15 {
        return Ok(());
    }
    let allowed = "beyond 1e15 rad the last bit is a 50th of a turn or more";
    Err(Error::out_of_range("angle", angle, allowed))
}

impl EulerAngles {
    /// The angles of a motion at rising times, phi and zeta counted on beyond a turn as
    /// [`unwrapped`] does; theta stays in [0, pi].
    ///
    /// Where the axis passes through the vertical itself phi and zeta jump by half a turn, and
    /// nothing tells which way. Errors and accuracy: as [`unwrapped`].
    pub fn unwrapped(angles: &[Self]) -> Result<Vec<Self>> {
        let phi: Vec<f64> = angles.iter().map(|angles| angles.phi).collect();
        let zeta: Vec<f64> = angles.iter().map(|angles| angles.zeta).collect();
        let counted = unwrapped(&phi)?.into_iter().zip(unwrapped(&zeta)?);
        let with = |(all, (phi, zeta)): (&Self, (f64, f64))| Self { phi, zeta, ..*all };
        Ok(angles.iter().zip(counted).map(with).collect())
    }
}

impl Attitude {
    /// The angles of a sequence as [`Attitude::angles`], but within `within` (rad) of a lock the
    /// angles of the lock: the third is zero, and the first carries what has a meaning.
    ///
    /// For quaternions from elsewhere, a rounding off the lock; the angles are off the attitude by
    /// `within` at most. Errors: `within` not in 0..1. Accuracy: 4.1 eps beside what is left out.
    ///
    /// ```
    /// use rotation_dynamics::attitude::{Attitude, Sequence};
    /// // Pitch -90 degrees and yaw 45 degrees, as another library has them.
    /// let theirs = [0.6532814824381883, 0.27059805007309845, -0.6532814824381882, 0.2705980500730985];
    /// let angles = Attitude::from_quaternion(theirs)?.angles_locked(Sequence::Zyx, 1e-7)?;
    /// assert_eq!(angles.map(|angle| angle.to_degrees().round()), [45.0, -90.0, 0.0]);
    /// # Ok::<(), rotation_dynamics::Error>(())
    /// ```
    pub fn angles_locked(&self, sequence: Sequence, within: f64) -> Result<[f64; 3]> {
        if !(0.0..1.0).contains(&finite("within", within)?) {
            let allowed = "it must be in 0..1 rad";
            return Err(Error::out_of_range("within", within, allowed));
        }
        let [first, second, third] = self.angles(sequence);
        let (lock, sign) = match sequence.right_handed() {
            _ if sequence.is_proper() && second < 1.0 => (0.0, 1.0),
            _ if sequence.is_proper() => (PI, -1.0),
            (_, hand) => (FRAC_PI_2.copysign(second), hand.copysign(hand * second)),
        };
        if (second - lock).abs() > within {
            return Ok([first, second, third]);
        }
        let both = first + sign * third;
        let turns = (both / TAU).round_ties_even();
        Ok([both - turns * TAU, lock, 0.0])
    }
}
