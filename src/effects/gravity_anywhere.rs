//! Gravity on a body held at any of its points.

use super::gravity::GRAVITY;
use super::{Conserved, Effect, Feature, GravityAtLever, IntegrableCase, Properties, Resistance};
use crate::body::{RigidBody, State};
use crate::error::{Result, finite, positive};
use crate::frame::{BodyVector, SpaceVector};

/// Gravity on a body whose centre of mass lies anywhere.
///
/// The force is m g along -Z at r, the centre of mass as seen from the fixed point. Its torque
/// about that point is r x (-m g Z), and U = m g r.Z. It has no component along Z: energy and L_Z
/// are kept. The body's moments are those about the fixed point, and `r` is given on their axes.
///
/// Valid where the field is uniform: the body's size over the distance to the centre of the
/// attracting mass must be small. Number: [`number`](Self::number).
///
/// ```
/// use rotation_dynamics::attitude::Attitude;
/// use rotation_dynamics::body::{RigidBody, State};
/// use rotation_dynamics::effects::{Effect, Gravity};
/// use rotation_dynamics::frame::{BodyVector, SpaceVector};
/// use rotation_dynamics::inertia::PrincipalMoments;
/// # fn main() -> rotation_dynamics::Result<()> {
/// // Level, and half a metre along X: to fall, the body turns about +Y.
/// let gravity = Gravity::new(2.0, BodyVector::new(0.5, 0.0, 0.0))?;
/// let body = RigidBody::new(PrincipalMoments::new(0.2, 1.0, 1.1)?);
/// let state = State::new(Attitude::IDENTITY, SpaceVector::zero())?;
/// let torque = gravity.torque(0.0, &body, &state);
/// assert_eq!(torque, SpaceVector::new(0.0, 1.0, 0.0));
/// # Ok(())
/// # }
/// ```
///
/// Source: notes 16.2 (3), with r in place of l e3.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gravity {
    weight: f64,
    centre_of_mass: BodyVector,
}

impl Gravity {
    /// Gravity with this weight m g (N, positive) at this centre of mass r (m, on the
    /// body's axes, from the fixed point).
    ///
    /// # Errors
    /// A weight that is not positive and finite, a component that is not finite, or m g |r|
    /// beyond `f64`.
    pub fn new(weight: f64, centre_of_mass: BodyVector) -> Result<Self> {
        positive("weight", weight)?;
        let names = ["centre of mass, x", "centre of mass, y", "centre of mass, z"];
        for (name, r) in names.into_iter().zip(centre_of_mass.to_array()) {
            finite(name, r)?;
        }
        finite("weight times distance", weight * centre_of_mass.norm())?;
        Ok(Self { weight, centre_of_mass })
    }

    /// The weight m g (N).
    pub const fn weight(&self) -> f64 {
        self.weight
    }

    /// The centre of mass r (m).
    pub const fn centre_of_mass(&self) -> BodyVector {
        self.centre_of_mass
    }

    /// m g |r| (N m), the largest torque.
    pub fn moment(&self) -> f64 {
        self.weight * self.centre_of_mass.norm()
    }
}

impl Effect for Gravity {
    const PROPERTIES: Properties = Properties {
        on_rates: false,
        on_time: false,
        smooth: true,
        weight: true,
        conserved: Conserved {
            energy: true,
            momentum: [false, false, true],
            axial_momentum: false,
        },
        ..Properties::ANYTHING
    };

    fn name(&self) -> &'static str {
        GRAVITY
    }

    #[inline]
    fn torque(&self, _t: f64, _body: &RigidBody, state: &State) -> SpaceVector {
        let r = state.attitude.to_space(self.centre_of_mass);
        SpaceVector::new(-self.weight * r.y(), self.weight * r.x(), 0.0)
    }

    #[inline]
    fn potential_energy(&self, _t: f64, _body: &RigidBody, state: &State) -> f64 {
        self.weight * state.attitude.to_space(self.centre_of_mass).z()
    }

    fn torque_scale(&self, _t: f64, _body: &RigidBody, _state: &State) -> f64 {
        self.moment()
    }

    fn narrowest(&self) -> Option<Feature> {
        Some(Feature::WIDE)
    }

    /// On the axis it sees nothing else.
    fn resistance(&self, _t: f64, _body: &RigidBody) -> Option<Resistance> {
        (self.integrable_case() != IntegrableCase::None).then_some(Resistance::NONE)
    }

    /// On the axis it is the gravity of a top.
    fn integrable_case(&self) -> IntegrableCase {
        let [x, y, z] = self.centre_of_mass.to_array();
        match GravityAtLever::new(self.weight, z) {
            Ok(on_axis) if x == 0.0 && y == 0.0 => IntegrableCase::HeavyTop(on_axis),
            _ => IntegrableCase::None,
        }
    }
}
