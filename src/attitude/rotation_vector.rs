//! The rotation vector: axis times angle; exponential and logarithm.

use super::{Attitude, norm, scale_for_squares};
use crate::error::{Error, Result, finite};
use crate::frame::{BodyVector, SpaceVector};
use crate::math::{self, DoubleDouble};

impl Attitude {
    /// The attitude reached from the identity by this rotation: direction =
    /// axis, length = angle in radians, right-handed.
    ///
    /// q = (cos a/2, sin(a/2) n). The axis has the same components on the fixed
    /// and on the body's axes.
    ///
    /// Errors: a component, or the length, that is not finite. Accuracy: each component of the
    /// quaternion within 2.4 eps of itself, from vectors of 1e-300 to vectors of 1e15 rad, measured
    /// in `tests/bodies/attitude`.
    pub fn from_rotation_vector(vector: SpaceVector) -> Result<Self> {
        exponential(vector.to_array())
    }

    /// The rotation by `angle` (rad) about an axis given on the fixed axes.
    ///
    /// Errors: an axis of length zero; anything not finite.
    pub fn about_space_axis(axis: SpaceVector, angle: f64) -> Result<Self> {
        about(axis.to_array(), angle)
    }

    /// The rotation by `angle` (rad) about an axis given on the body's axes.
    ///
    /// From the identity the two frames agree; the name says what is meant when
    /// the result is composed: `attitude * Attitude::about_body_axis(..)`.
    ///
    /// Errors: an axis of length zero; anything not finite.
    pub fn about_body_axis(axis: BodyVector, angle: f64) -> Result<Self> {
        about(axis.to_array(), angle)
    }

    /// This attitude after a further rotation given on the fixed axes
    /// (direction = axis, length = angle in radians).
    ///
    /// Errors: a rotation that is not finite.
    pub fn turned_in_space(&self, rotation: SpaceVector) -> Result<Self> {
        Ok(exponential(rotation.to_array())? * *self)
    }

    /// This attitude after a further rotation given on the body's axes
    /// (direction = axis, length = angle in radians).
    ///
    /// Errors: a rotation that is not finite.
    pub fn turned_in_body(&self, rotation: BodyVector) -> Result<Self> {
        Ok(*self * exponential(rotation.to_array())?)
    }

    /// The rotation by `angle` (rad) about coordinate axis 0, 1 or 2, to a few eps: for many
    /// attitudes of which none is delivered.
    pub(crate) fn about_coordinate(axis: usize, angle: f64) -> Self {
        let (sin, cos) = math::sincos(0.5 * angle);
        let mut quaternion = [cos, 0.0, 0.0, 0.0];
        quaternion[1 + axis] = sin;
        Self::from_unit(quaternion)
    }

    /// The rotation vector: axis times angle, angle in [0, pi].
    ///
    /// 2 atan2(|v|, |w|)/|v| times the vector part v, with the sign of w.
    ///
    /// Accuracy, measured with the accuracy kit over 2000 attitudes per family
    /// (two seeds), in eps, median / P99 / max:
    ///
    /// | angle | rotation error | relative error of the vector |
    /// |---|---|---|
    /// | 0.1 ... 3 | 0.5 / 1.9 / 2.2 | |
    /// | pi - 1e-16 ... pi - 0.1 | 1.0 / 2.1 / 2.7 | |
    /// | 1e-20 ... 0.1 | <.01 / 0.03 / 0.06 | <.01 / 0.76 / 0.88 |
    /// | 1e-300 ... 1e-20 | <.01 / <.01 / <.01 | <.01 / <.01 / <.01 |
    /// | 1e-300 ... 0.1, written with w < 0 | <.01 / <.01 / 0.04 | <.01 / 0.43 / 0.75 |
    ///
    /// These are the figures of the exact vector rounded to doubles.
    ///
    /// Cost: one arc tangent to 100 bits, about 90 compositions.
    ///
    /// Special cases: the identity gives zero; at the angle pi the sign of the axis is taken from
    /// the stored quaternion.
    pub fn rotation_vector(&self) -> SpaceVector {
        let [w, x, y, z] = self.quaternion();
        let sin_half = norm([x, y, z]);
        if sin_half == 0.0 {
            return SpaceVector::zero();
        }
        let half = sin_half.atan2(DoubleDouble::from(w.abs()));
        let factor = half.scaled(2.0) / sin_half;
        let factor = if w < 0.0 { -factor } else { factor };
        // Both parts of the factor: each component is rounded once.
        SpaceVector::from_array([x, y, z].map(|c| (factor * c).to_f64()))
    }
}

/// exp of half the rotation vector.
fn exponential(vector: [f64; 3]) -> Result<Attitude> {
    for (name, value) in ["x", "y", "z"].into_iter().zip(vector) {
        finite(name, value)?;
    }
    let (direction, scale) = scaled(vector);
    let length = norm(direction);
    if length == 0.0 {
        return Ok(Attitude::IDENTITY);
    }
    let angle = length.scaled(scale.recip());
    finite("length of the rotation vector", angle.hi())?;
    Ok(turn_by(direction, length, angle))
}

/// The rotation by `angle` about `axis`, of any nonzero length.
fn about(axis: [f64; 3], angle: f64) -> Result<Attitude> {
    for (name, value) in ["axis x", "axis y", "axis z"].into_iter().zip(axis) {
        finite(name, value)?;
    }
    finite("angle", angle)?;
    let (direction, _) = scaled(axis);
    let length = norm(direction);
    if length == 0.0 {
        return Err(Error::out_of_range("length of the axis", 0.0, "it must be greater than 0"));
    }
    Ok(turn_by(direction, length, DoubleDouble::from(angle)))
}

/// The vector times a power of two that brings it where it can be squared.
pub(super) fn scaled(vector: [f64; 3]) -> ([f64; 3], f64) {
    let largest = vector.iter().fold(0.0, |m: f64, c| m.max(c.abs()));
    let scale = scale_for_squares(largest);
    (vector.map(|c| c * scale), scale)
}

/// (cos a/2, sin(a/2) v/|v|); the angle has two parts, so that the rounding of a
/// length of many turns does not turn the body.
fn turn_by(vector: [f64; 3], length: DoubleDouble, angle: DoubleDouble) -> Attitude {
    let (sin, cos) = math::sincos(angle.hi() / 2.0);
    let (sin_rest, cos_rest) = math::sincos(angle.lo() / 2.0);
    let factor = DoubleDouble::from(sin * cos_rest + cos * sin_rest) / length;
    let [x, y, z] = vector.map(|c| (factor * c).to_f64());
    Attitude::from_unit([cos * cos_rest - sin * sin_rest, x, y, z])
}
