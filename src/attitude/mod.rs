//! How a body is turned: the attitude and its coordinates.
//!
//! An [`Attitude`] is the rotation that carries components on the body's axes to components on the
//! fixed axes. It is stored as a unit quaternion, which has no singular place; Euler angles
//! ([`EulerAngles`]), rotation vector and matrix are coordinates of it, for input, output and
//! formulas. Conventions follow the notes (15.1): R = Rz(phi) Rx(theta) Rz(zeta), body -> space.
//! [`YawPitchRoll`] and [`Sequence`] are the conventions of others, and [`Attitude::from_xyzw`] the
//! quaternions of others.
//!
//! Attitudes that are measured: [`Attitude::nearest`] to a matrix, from directions
//! ([`Attitude::from_directions`]), their [`mean`](Attitude::mean), arcs between them
//! ([`Attitude::toward`], [`Arcs`]) and angles that go on beyond a turn ([`unwrapped`]; the
//! closed forms in [`crate::exact`] give those of a motion without a limit to its speed).

mod arcs;
mod composition;
mod euler;
mod fitted;
mod matrix;
pub(crate) mod product;
mod quaternion;
mod rodrigues;
mod rotation_vector;
mod sequence;
mod sequence_rates;
mod unwrapped;
mod yaw_pitch_roll;

pub use arcs::Arcs;
pub use euler::{EulerAngles, EulerRates};
pub use sequence::Sequence;
pub use unwrapped::unwrapped;
pub use yaw_pitch_roll::{YawPitchRoll, YawPitchRollRates};

use crate::error::{Error, Result, finite};
use crate::frame::{BodyVector, SpaceVector};
use crate::math::{DoubleDouble, EPS};

/// The attitude of a body: the rotation from its own axes to the fixed axes.
///
/// Stored as a unit quaternion (w, x, y, z), v_space = q v_body q*. Its norm
/// stays within 4 eps of 1 (measured: 1.8 eps over a million compositions).
/// The quaternions q and -q are the same attitude; `==` compares components,
/// [`Attitude::angle_to`] compares attitudes.
///
/// ```
/// use rotation_dynamics::attitude::{Attitude, EulerAngles};
/// use rotation_dynamics::frame::BodyVector;
/// # fn main() -> rotation_dynamics::Result<()> {
/// let tilted = Attitude::from_euler(EulerAngles { phi: 0.3, theta: 0.7, zeta: -0.4 })?;
/// let top = tilted.to_space(BodyVector::new(0.0, 0.0, 1.0));
/// assert!((top.z() - 0.764_842_187_284_488_5).abs() <= 2e-16);
/// # Ok(())
/// # }
/// ```
///
/// Source: notes 15.1; quaternions as in H. Goldstein, Classical Mechanics, ch. 4.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Attitude {
    quaternion: [f64; 4],
}

/// A quaternion this close to unit norm is kept bit for bit, so that
/// `from_quaternion(a.quaternion())` is `a`.
const UNIT_WITHIN: f64 = 4.0 * EPS;

impl Attitude {
    /// Body axes along the fixed axes.
    pub const IDENTITY: Self = Self { quaternion: [1.0, 0.0, 0.0, 0.0] };

    /// The attitude of the quaternion (w, x, y, z), which is normalised.
    ///
    /// Any nonzero finite quaternion will do, from 1e-308 to 1e308. One that is
    /// unit to 4 eps already is kept bit for bit.
    ///
    /// Errors: a component that is not finite; all components zero.
    /// Accuracy: correctly rounded, in all 100 references of `tests/bodies/attitude`.
    #[doc(alias = "from_wxyz")]
    pub fn from_quaternion(quaternion: [f64; 4]) -> Result<Self> {
        for (name, value) in ["w", "x", "y", "z"].into_iter().zip(quaternion) {
            finite(name, value)?;
        }
        let largest = quaternion.iter().fold(0.0, |m: f64, c| m.max(c.abs()));
        if largest == 0.0 {
            return Err(Error::out_of_range(
                "norm of the quaternion",
                0.0,
                "it must be greater than 0",
            ));
        }
        let scale = scale_for_squares(largest);
        let scaled = quaternion.map(|c| c * scale);
        let norm = norm(scaled);
        if scale == 1.0 && (norm - 1.0).abs().to_f64() <= UNIT_WITHIN {
            return Ok(Self { quaternion });
        }
        Ok(Self { quaternion: scaled.map(|c| (DoubleDouble::from(c) / norm).to_f64()) })
    }

    /// From components that are unit to a few eps, by construction.
    #[inline]
    pub(crate) const fn from_unit(quaternion: [f64; 4]) -> Self {
        Self { quaternion }
    }

    /// The unit quaternion (w, x, y, z); its sign is free.
    #[doc(alias = "wxyz")]
    #[inline]
    pub const fn quaternion(&self) -> [f64; 4] {
        self.quaternion
    }

    /// Components on the fixed axes of a vector given on the body's axes: R v.
    ///
    /// Accuracy: 6.0 eps of the vector's length, measured in `tests/bodies/attitude`.
    #[inline]
    pub fn to_space(&self, v: BodyVector) -> SpaceVector {
        let [w, x, y, z] = self.quaternion;
        SpaceVector::from_array(turn([w, x, y, z], v.to_array()))
    }

    /// Components on the body's axes of a vector given on the fixed axes: R^T v.
    ///
    /// Accuracy: as [`Attitude::to_space`].
    #[inline]
    pub fn to_body(&self, v: SpaceVector) -> BodyVector {
        let [w, x, y, z] = self.quaternion;
        BodyVector::from_array(turn([w, -x, -y, -z], v.to_array()))
    }

    /// The body's third axis e3 on the fixed axes:
    /// (sin theta sin phi, -sin theta cos phi, cos theta).
    #[inline]
    pub fn axis(&self) -> SpaceVector {
        let [w, x, y, z] = self.quaternion;
        SpaceVector::new(
            2.0 * (x * z + w * y),
            2.0 * (y * z - w * x),
            (w * w + z * z) - (x * x + y * y),
        )
    }

    /// The fixed vertical Z on the body's axes:
    /// (sin theta sin zeta, sin theta cos zeta, cos theta).
    #[inline]
    pub fn vertical(&self) -> BodyVector {
        let [w, x, y, z] = self.quaternion;
        BodyVector::new(
            2.0 * (x * z - w * y),
            2.0 * (y * z + w * x),
            (w * w + z * z) - (x * x + y * y),
        )
    }
}

/// v + 2 w (u x v) + 2 u x (u x v): the added part is small when the rotation is.
#[inline]
fn turn([w, x, y, z]: [f64; 4], [a, b, c]: [f64; 3]) -> [f64; 3] {
    let (p, q, r) = (2.0 * (y * c - z * b), 2.0 * (z * a - x * c), 2.0 * (x * b - y * a));
    [a + (w * p + (y * r - z * q)), b + (w * q + (z * p - x * r)), c + (w * r + (x * q - y * p))]
}

/// A power of two that brings numbers up to `largest` where neither their
/// squares nor the rounding errors of the squares overflow or underflow.
#[inline]
fn scale_for_squares(largest: f64) -> f64 {
    if largest < BIG.recip() {
        BIG * BIG
    } else if largest > BIG {
        (BIG * BIG).recip()
    } else {
        1.0
    }
}

/// 2^300
const BIG: f64 = 2.037_035_976_334_486e90;

/// Euclidean norm to about 100 bits.
fn norm<T: Into<DoubleDouble> + Copy, const N: usize>(components: [T; N]) -> DoubleDouble {
    let components = components.map(Into::into);
    let largest = components.iter().fold(0.0, |m: f64, c| m.max(c.hi().abs()));
    let scale = scale_for_squares(largest);
    let mut sum = DoubleDouble::ZERO;
    for c in components {
        sum += c.scaled(scale).square();
    }
    sum.sqrt().scaled(scale.recip())
}

/// The entry of a list that is refused.
fn at(name: &'static str, index: usize) -> impl FnOnce(Error) -> Error {
    move |reason| Error::AtIndex { name, index, reason: Box::new(reason) }
}
