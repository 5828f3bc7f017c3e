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
use crate::math::{EPS, order_of_three};

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

/// The rounding of moments, relative to the terms they are computed from.
///
/// For the step to another point at most 22 eps: 4 of coordinates that are rounded, 5 of the
/// products, 2 of the sum, 8 of elements typed with 16 digits, 3 of the diagonalisation. The
/// most that a sweep found is 1.6 eps (`tests/traps/cancellation`).
pub(crate) const ROUNDING: f64 = 32.0 * EPS;

/// The excess of the largest moment over the sum of the others, which no body has; refused
/// beyond the `slack`.
///
/// A negative moment is such a case, because a <= b <= c and c <= a + b leave a >= c - b >= 0.
pub(crate) fn possible(moments: [f64; 3], slack: f64) -> Result<f64> {
    let [low, middle, high] = order_of_three(moments).map(|i| moments[i]);
    // In this order nothing overflows.
    let excess = (high - middle) - low;
    match excess > slack {
        true => Err(Error::NotABody { moments, excess, slack }),
        false => Ok(excess),
    }
}

impl PrincipalMoments {
    /// The moments about the first, second and third body axis.
    ///
    /// Errors: a moment that is negative or not finite; [`Error::NotABody`] if one exceeds the sum
    /// of the others by more than 32 eps of the largest (a flat body given in decimals passes).
    /// Errors are also (0, I, I), a rod, and (0, 0, 0), a point mass.
    pub fn new(i1: f64, i2: f64, i3: f64) -> Result<Self> {
        Self::known_within([i1, i2, i3], 0.0)
    }

    /// The same for moments that are known within this much (kg m^2).
    pub(crate) fn known_within(moments: [f64; 3], known_within: f64) -> Result<Self> {
        for (name, moment) in ["I1", "I2", "I3"].into_iter().zip(moments) {
            if moment != 0.0 {
                positive(name, moment)?;
            }
        }
        possible(moments, ROUNDING * moments.into_iter().fold(0.0, f64::max))?;
        if moments.contains(&0.0) {
            return Err(Error::NotABody { moments, excess: 0.0, slack: known_within });
        }
        Ok(Self { moments })
    }

    /// Positive numbers in the place of moments: those of a body or not. Euler's equations, and their
    /// closed form, ask for no more.
    pub(crate) fn of_any(moments: [f64; 3]) -> Result<Self> {
        for (name, moment) in ["I1", "I2", "I3"].into_iter().zip(moments) {
            positive(name, moment)?;
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
