//! Moments of inertia: how mass resists turning (notes 15.3).
//!
//! [`PrincipalMoments`] is what the motion of a body needs. [`InertiaTensor`]
//! is the 3x3 form about a point, with its principal axes. [`MassProperties`]
//! (mass, centre of mass, tensor about it) is where both come from: the
//! [`solids`], point masses, and the parallel-axis theorem, which holds only
//! from the centre of mass and therefore lives there.
//!
//! Vectors and tensors here are on the axes of the drawing ([`crate::frame::Design`]);
//! [`crate::body::DesignedBody`] leads to the principal axes and back.
//!
//! Units: kg, m, kg m^2. Not for: bodies that deform.

mod mass_properties;
mod principal_axes;
pub mod solids;
mod tensor;

pub use mass_properties::MassProperties;
pub use principal_axes::PrincipalAxes;
pub use tensor::InertiaTensor;

use crate::error::{Error, Result, positive};
use crate::math::EPS;

/// The three principal moments of inertia of a body (kg m^2), in the order of
/// the body's axes.
///
/// All are positive, and none exceeds the sum of the other two; a flat body
/// attains equality. The order is kept as given.
///
/// ```
/// use rotation_dynamics::inertia::PrincipalMoments;
/// let disc = PrincipalMoments::symmetric(1.0, 2.0).expect("a flat disc");
/// assert_eq!(disc.to_array(), [1.0, 1.0, 2.0]);
/// let error = PrincipalMoments::symmetric(1.0, 2.1).unwrap_err();
/// assert!(error.to_string().contains("belong to no body"));
/// ```
///
/// Source: notes 15.3. The inequality: I1 + I2 - I3 = 2 sum m z^2 >= 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PrincipalMoments {
    moments: [f64; 3],
}

/// Equality in the triangle inequality survives decimal inputs and the rounding
/// of a diagonalisation.
const TRIANGLE_WITHIN: f64 = 32.0 * EPS;

/// True if no moment exceeds the sum of the others by more than `slack` of it.
pub(crate) fn is_triangle([a, b, c]: [f64; 3], slack: f64) -> bool {
    // Halves: a sum of two huge moments must not overflow.
    let holds = |x: f64, y: f64, z: f64| 0.5 * x <= (0.5 * y + 0.5 * z) * (1.0 + slack);
    holds(a, b, c) && holds(b, c, a) && holds(c, a, b)
}

impl PrincipalMoments {
    /// The moments about the first, second and third body axis.
    ///
    /// Errors: a moment that is not finite or not positive;
    /// [`Error::TriangleInequality`] if one exceeds the sum of the others by
    /// more than 32 eps of that sum (a flat body given in decimals passes).
    pub fn new(i1: f64, i2: f64, i3: f64) -> Result<Self> {
        let moments = [
            positive("I1", i1)?,
            positive("I2", i2)?,
            positive("I3", i3)?,
        ];
        if !is_triangle(moments, TRIANGLE_WITHIN) {
            return Err(Error::TriangleInequality { moments });
        }
        Ok(Self { moments })
    }

    /// A symmetric body: `i1` about every axis across, `i3` about the axis.
    ///
    /// Errors: as [`PrincipalMoments::new`]; so i3 <= 2 i1.
    pub fn symmetric(i1: f64, i3: f64) -> Result<Self> {
        Self::new(i1, i1, i3)
    }

    /// The moments (I1, I2, I3).
    #[inline]
    pub const fn to_array(self) -> [f64; 3] {
        self.moments
    }

    /// Moment about the first axis (kg m^2).
    #[inline]
    pub const fn i1(&self) -> f64 {
        self.moments[0]
    }

    /// Moment about the second axis (kg m^2).
    #[inline]
    pub const fn i2(&self) -> f64 {
        self.moments[1]
    }

    /// Moment about the third axis (kg m^2).
    #[inline]
    pub const fn i3(&self) -> f64 {
        self.moments[2]
    }

    /// True if I1 = I2 exactly: a symmetric top about its third axis.
    #[inline]
    pub fn is_symmetric(&self) -> bool {
        self.moments[0] == self.moments[1]
    }
}

#[cfg(test)]
mod tests;
