//! The dimensional body: a symmetric top that turns about a fixed point.

use crate::error::{Error, Result, finite, positive};
use crate::inertia::PrincipalMoments;
use crate::math::DoubleDouble as Dd;

/// A symmetric body on a fixed pivot, in SI units.
///
/// The centre of mass lies at `lever` on the body's third axis; a negative lever is
/// a body that hangs at theta = 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SymmetricTop {
    i1: f64,
    i3: f64,
    weight: f64,
    lever: f64,
    moment: Dd,
}

impl SymmetricTop {
    /// The top with transverse moment `i1` about the pivot and axial moment `i3`
    /// (kg m^2), weight m g (N) and lever l (m).
    ///
    /// # Errors
    /// A moment that is not positive, or i3 > 2 i1; i3 = 2 i1 is a flat body through
    /// its own centre and needs l = 0. A weight below 0; a lever that is not finite.
    pub fn new(i1: f64, i3: f64, weight: f64, lever: f64) -> Result<Self> {
        let moment = Dd::product(weight, lever);
        Self::checked(i1, i3, weight, lever, moment)
    }

    /// The same from mass (kg) and gravity (m/s^2); m g l is formed exactly.
    ///
    /// # Errors
    /// As [`Self::new`].
    pub fn from_mass(i1: f64, i3: f64, mass: f64, gravity: f64, lever: f64) -> Result<Self> {
        finite("m", mass)?;
        finite("g", gravity)?;
        let moment = Dd::product(mass, gravity) * lever;
        Self::checked(i1, i3, mass * gravity, lever, moment)
    }

    /// The same equations for any positive moments, whether a body has them or not: the
    /// notes' disc, I3 = 2 I1, with its weight off the pivot.
    ///
    /// # Errors
    /// As [`Self::new`], but for the moments.
    pub fn formal(i1: f64, i3: f64, weight: f64, lever: f64) -> Result<Self> {
        Self::of(i1, i3, weight, lever, Dd::product(weight, lever))
    }

    fn checked(i1: f64, i3: f64, weight: f64, lever: f64, moment: Dd) -> Result<Self> {
        let top = Self::of(i1, i3, weight, lever, moment)?;
        if i3 > 2.0 * i1 || (i3 == 2.0 * i1 && lever != 0.0) {
            return Err(Error::out_of_range(
                "I3/I1",
                i3 / i1,
                "I3 <= 2 I1 for every body, and I3 < 2 I1 if the centre of mass is off the pivot",
            ));
        }
        Ok(top)
    }

    fn of(i1: f64, i3: f64, weight: f64, lever: f64, moment: Dd) -> Result<Self> {
        positive("I1", i1)?;
        if i3 == 0.0 {
            // Refuses a rod by its name.
            PrincipalMoments::symmetric(i1, i3)?;
        }
        positive("I3", i3)?;
        finite("m g", weight)?;
        finite("l", lever)?;
        finite("m g l", moment.hi())?;
        if weight < 0.0 {
            return Err(Error::out_of_range(
                "m g",
                weight,
                "a weight is 0 or more; let the lever carry the sign",
            ));
        }
        Ok(Self { i1, i3, weight, lever, moment })
    }

    /// Transverse moment of inertia about the pivot (kg m^2).
    pub const fn i1(&self) -> f64 {
        self.i1
    }

    /// Axial moment of inertia (kg m^2).
    pub const fn i3(&self) -> f64 {
        self.i3
    }

    /// Weight m g (N).
    pub const fn weight(&self) -> f64 {
        self.weight
    }

    /// Distance l of the centre of mass from the pivot along the third axis (m).
    pub const fn lever(&self) -> f64 {
        self.lever
    }

    /// m g l to 106 bits (N m).
    pub(super) const fn moment(&self) -> Dd {
        self.moment
    }
}
