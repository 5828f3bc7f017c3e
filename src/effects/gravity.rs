//! Gravity on a body held at a point of its axis.

use super::{AxisEffect, Effect, Keeps};
use crate::body::{RigidBody, State};
use crate::error::{Result, finite, positive};
use crate::frame::SpaceVector;
use crate::math::Lane;

/// Gravity on a body whose centre of mass lies on its axis e3, at a distance
/// from the fixed point.
///
/// The force is m g along -Z at l e3; its torque about the fixed point is
/// l e3 x (-m g Z) = m g l (Z x e3), and U = m g l cos(theta). No torque about Z
/// nor about e3: energy, L_Z and (of a symmetric body) L_z are kept.
///
/// ```
/// use rotation_dynamics::effects::{AxisEffect, GravityAtLever};
/// use rotation_dynamics::frame::SpaceVector;
/// # fn main() -> rotation_dynamics::Result<()> {
/// let gravity = GravityAtLever::new(2.0, 0.5)?;
/// // The axis points along Y: to fall, the body turns about -X.
/// let torque = gravity.axis_torque(SpaceVector::new(0.0, 1.0, 0.0));
/// assert_eq!(torque, SpaceVector::new(-1.0, 0.0, 0.0));
/// # Ok(())
/// # }
/// ```
///
/// Source: notes 16.2 (3).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GravityAtLever {
    weight: f64,
    lever: f64,
}

impl GravityAtLever {
    /// Gravity with this weight m g (N, positive) at this lever l (m, along the
    /// body axis e3 from the fixed point; negative if the body hangs below it
    /// when e3 points up).
    ///
    /// Errors: a weight that is not positive and finite, a lever that is not
    /// finite, or a product beyond `f64`.
    pub fn new(weight: f64, lever: f64) -> Result<Self> {
        positive("weight", weight)?;
        finite("lever", lever)?;
        finite("weight times lever", weight * lever)?;
        Ok(Self { weight, lever })
    }

    /// The weight m g (N).
    pub const fn weight(&self) -> f64 {
        self.weight
    }

    /// The lever l (m).
    pub const fn lever(&self) -> f64 {
        self.lever
    }

    /// m g l (N m), the largest torque, with the sign of the lever.
    #[inline]
    pub fn moment(&self) -> f64 {
        self.weight * self.lever
    }
}

impl Effect for GravityAtLever {
    const KEEPS: Keeps = Keeps {
        energy: true,
        momentum: [false, false, true],
        axial_momentum: true,
    };

    #[inline]
    fn torque(&self, _t: f64, _body: &RigidBody, state: &State) -> SpaceVector {
        self.axis_torque(state.attitude.axis())
    }

    #[inline]
    fn potential_energy(&self, state: &State) -> f64 {
        self.moment() * state.attitude.axis().z()
    }

    #[inline]
    fn torque_scale(&self) -> f64 {
        self.moment().abs()
    }
}

impl AxisEffect for GravityAtLever {
    #[inline]
    fn axis_torque(&self, axis: SpaceVector) -> SpaceVector {
        let moment = self.moment();
        SpaceVector::new(-moment * axis.y(), moment * axis.x(), 0.0)
    }

    #[inline(always)]
    fn axis_torques<L: Lane>(&self, [x, y, _]: [L; 3]) -> [L; 3] {
        let moment = self.moment();
        [y * -moment, x * moment, L::of(0.0)]
    }
}
