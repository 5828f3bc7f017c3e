//! Quaternions as others write them.
//!
//! Ours are (w, x, y, z) with Hamilton's product (ij = k) and turn body components into space
//! components. Elsewhere the order of the four numbers differs. In attitude control (Shuster; JPL)
//! the product differs as well: there ij = -k, and the matrix of a quaternion turns space
//! components into body components. The two differences undo each other: the quaternion of a body's
//! attitude has *the same four numbers* in both, there with the scalar last. Only the order of
//! factors is opposite: `a * b` here is b times a there.

use super::Attitude;
use crate::error::{Error, Result};
use crate::frame::written;
use core::fmt;
use nalgebra::{Quaternion, UnitQuaternion};

impl Attitude {
    /// The attitude of a quaternion with the scalar last, (x, y, z, w), normalised.
    ///
    /// Errors and accuracy: as [`Attitude::from_quaternion`].
    /// Source: M. D. Shuster, J. Astronaut. Sci. 41, 439 (1993), for the convention.
    pub fn from_xyzw([x, y, z, w]: [f64; 4]) -> Result<Self> {
        Self::from_quaternion([w, x, y, z])
    }

    /// The unit quaternion with the scalar last, (x, y, z, w); its sign is free.
    #[inline]
    pub const fn xyzw(&self) -> [f64; 4] {
        let [w, x, y, z] = self.quaternion();
        [x, y, z, w]
    }
}

impl From<Attitude> for UnitQuaternion<f64> {
    /// The same numbers, the same product.
    fn from(attitude: Attitude) -> Self {
        let [w, x, y, z] = attitude.quaternion();
        Self::new_unchecked(Quaternion::new(w, x, y, z))
    }
}

impl TryFrom<UnitQuaternion<f64>> for Attitude {
    type Error = Error;

    /// The same numbers, normalised as [`Attitude::from_quaternion`] does.
    ///
    /// Errors: components that are not finite, or all zero (unchecked ones can be).
    fn try_from(quaternion: UnitQuaternion<f64>) -> Result<Self> {
        let q = quaternion.quaternion();
        Self::from_quaternion([q.w, q.i, q.j, q.k])
    }
}

/// The quaternion (w, x, y, z), each number written as the format says: `{:.3}`, `{:+.6}`.
///
/// ```
/// use rotation_dynamics::attitude::Attitude;
/// assert_eq!(format!("{:.2}", Attitude::IDENTITY), "(1.00, 0.00, 0.00, 0.00)");
/// ```
impl fmt::Display for Attitude {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        written(self.quaternion(), f, fmt::Display::fmt)
    }
}
