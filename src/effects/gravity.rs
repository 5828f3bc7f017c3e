//! Gravity on a body held at a point of its axis.

use super::{Conserved, Effect, Feature, IntegrableCase, Properties};
use crate::body::{RigidBody, State};
use crate::error::{Result, finite, positive};
use crate::frame::SpaceVector;
use crate::math::Lane;

/// The name of every gravity, so that two of them in one scene are noticed.
pub(crate) const GRAVITY: &str = "gravity";

/// Gravity on a body whose centre of mass lies on its axis e3, at a distance
/// from the fixed point.
///
/// The force is m g along -Z at l e3. Its torque about the fixed point is l e3 x (-m g Z) = m g l
/// (Z x e3), and U = m g l cos(theta). No torque about Z nor about e3: energy, L_Z and (of a
/// symmetric body) L_z are kept.
///
/// ```
/// use rotation_dynamics::attitude::Attitude;
/// use rotation_dynamics::body::{RigidBody, State};
/// use rotation_dynamics::effects::{Effect, GravityAtLever};
/// use rotation_dynamics::frame::SpaceVector;
/// use rotation_dynamics::inertia::PrincipalMoments;
/// # fn main() -> rotation_dynamics::Result<()> {
/// let gravity = GravityAtLever::new(2.0, 0.5)?;
/// // The axis points along Y: to fall, the body turns about -X.
/// let across = Attitude::from_quaternion([1.0, -1.0, 0.0, 0.0])?;
/// let state = State::new(across, SpaceVector::zero())?;
/// let body = RigidBody::new(PrincipalMoments::symmetric(1.0, 0.5)?);
/// let torque = gravity.torque(0.0, &body, &state);
/// assert!((torque - SpaceVector::new(-1.0, 0.0, 0.0)).norm() < 1e-15);
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
    const PROPERTIES: Properties = Properties {
        axis_only: true,
        on_rates: false,
        on_time: false,
        smooth: true,
        weight: true,
        conserved: Conserved { energy: true, momentum: [false, false, true], axial_momentum: true },
        ..Properties::ANYTHING
    };

    fn name(&self) -> &'static str {
        GRAVITY
    }

    #[inline]
    fn torque(&self, _t: f64, body: &RigidBody, state: &State) -> SpaceVector {
        SpaceVector::from_array(self.torques_on_axis(body, state.attitude.axis().to_array()))
    }

    #[inline(always)]
    fn torques_on_axis<L: Lane>(&self, _body: &RigidBody, [x, y, _]: [L; 3]) -> [L; 3] {
        let moment = self.moment();
        [y * -moment, x * moment, L::of(0.0)]
    }

    #[inline]
    fn potential_energy(&self, _t: f64, _body: &RigidBody, state: &State) -> f64 {
        self.moment() * state.attitude.axis().z()
    }

    #[inline]
    fn torque_scale(&self, _t: f64, _body: &RigidBody, _state: &State) -> f64 {
        self.moment().abs()
    }

    fn narrowest(&self) -> Option<Feature> {
        Some(Feature::WIDE)
    }

    fn integrable_case(&self) -> IntegrableCase {
        IntegrableCase::HeavyTop(*self)
    }
}
