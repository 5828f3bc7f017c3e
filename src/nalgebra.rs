//! Vectors and attitudes to and from nalgebra's (feature `nalgebra`).
//!
//! A `Vector3` has no frame: which axes its components are on is said by the type it is
//! made into.
//!
//! ```
//! use nalgebra::{UnitQuaternion, Vector3};
//! use rotation_dynamics::attitude::Attitude;
//! use rotation_dynamics::frame::{BodyVector, SpaceVector};
//! # fn main() -> rotation_dynamics::Result<()> {
//! let tipped = Attitude::about_space_axis(SpaceVector::new(1.0, 0.0, 0.0), 0.5)?;
//! let theirs = UnitQuaternion::from(tipped);
//! let axis = BodyVector::new(0.0, 0.0, 1.0);
//! let turned = SpaceVector::from(theirs * Vector3::from(axis));
//! assert_eq!(turned, tipped.to_space(axis));
//! assert_eq!(Attitude::try_from(theirs)?, tipped);
//! # Ok(())
//! # }
//! ```

use crate::attitude::Attitude;
use crate::error::{Error, Result};
use crate::frame::{Frame, Vector};
use nalgebra::{Quaternion, UnitQuaternion, Vector3};

impl<F: Frame> From<Vector3<f64>> for Vector<F> {
    #[inline]
    fn from(components: Vector3<f64>) -> Self {
        Self::from_array(components.into())
    }
}

impl<F: Frame> From<Vector<F>> for Vector3<f64> {
    #[inline]
    fn from(vector: Vector<F>) -> Self {
        vector.to_array().into()
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
