//! Friction in proportion to the rates.

use super::{Effect, Feature, Properties, Resistance};
use crate::body::{RigidBody, State};
use crate::error::{Result, not_negative};
use crate::frame::{BodyVector, SpaceVector};
use crate::math::Lane;

/// Friction in proportion to the angular velocity.
///
/// On the body's axes its torque is -(c_t omega_1, c_t omega_2, c_a omega_3). The coefficient c_a
/// belongs to a bearing about the axis e3, c_t to turns of that axis, and with c_a = c_t = c the
/// torque is -c omega. It takes c_t (omega_1^2 + omega_2^2) + c_a omega_3^2 of power.
///
/// Valid for a lubricated bearing whose film is thick and whose flow is laminar (a film of area A,
/// thickness h and viscosity mu at the radius r has c = mu A r^2/h). Valid also for a body so slow
/// that the flow about it creeps (a sphere: c = 8 pi mu R^3). Number: [`number`](Self::number).
///
/// ```
/// use rotation_dynamics::attitude::Attitude;
/// use rotation_dynamics::body::RigidBody;
/// use rotation_dynamics::effects::ViscousFriction;
/// use rotation_dynamics::frame::BodyVector;
/// use rotation_dynamics::inertia::PrincipalMoments;
/// use rotation_dynamics::scene::Scene;
/// # fn main() -> rotation_dynamics::Result<()> {
/// let body = RigidBody::new(PrincipalMoments::symmetric(1.0, 0.5)?);
/// let start = body.state(Attitude::IDENTITY, BodyVector::new(0.0, 0.0, 4.0))?;
/// let scene = Scene::new(body).with(ViscousFriction::about_axis(0.1)?);
/// // The spin decays with exp(-c t/I3): in 10 s by e^2.
/// let end = scene.solve(&start, 10.0, 1e-9)?.state;
/// let spin = body.angular_velocity(&end).z();
/// assert!((spin - 4.0 * rotation_dynamics::math::exp(-2.0)).abs() < 1e-9);
/// # Ok(())
/// # }
/// ```
///
/// Source: N. Petrov's law of the journal bearing, in B. J. Hamrock, S. R. Schmid, B. O.
/// Jacobson, *Fundamentals of Fluid Film Lubrication*; for the sphere L. D. Landau, E. M.
/// Lifshitz, *Fluid Mechanics*, 20, problem 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ViscousFriction {
    transverse: f64,
    axial: f64,
}

impl ViscousFriction {
    /// Friction with the coefficients c_t across and c_a about the axis e3 (N m s).
    ///
    /// # Errors
    /// A coefficient that is negative or not finite.
    pub fn new(transverse: f64, axial: f64) -> Result<Self> {
        Ok(Self {
            transverse: not_negative("transverse friction coefficient", transverse)?,
            axial: not_negative("axial friction coefficient", axial)?,
        })
    }

    /// The torque -c omega, with c in N m s.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn isotropic(coefficient: f64) -> Result<Self> {
        Self::new(coefficient, coefficient)
    }

    /// A bearing about the axis e3: c_a (N m s), and c_t = 0.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn about_axis(coefficient: f64) -> Result<Self> {
        Self::new(0.0, coefficient)
    }

    /// The coefficients across and about the axis (N m s).
    pub const fn coefficients(&self) -> [f64; 2] {
        [self.transverse, self.axial]
    }
}

impl Effect for ViscousFriction {
    const PROPERTIES: Properties =
        Properties { on_time: false, smooth: true, ..Properties::ANYTHING };

    fn name(&self) -> &'static str {
        "viscous friction"
    }

    #[inline]
    fn torque(&self, _t: f64, body: &RigidBody, state: &State) -> SpaceVector {
        let [w1, w2, w3] = body.angular_velocity(state).to_array();
        let (transverse, axial) = (self.transverse, self.axial);
        (state.attitude).to_space(BodyVector::new(-transverse * w1, -transverse * w2, -axial * w3))
    }

    #[inline(always)]
    fn torques_on_axis<L: Lane>(&self, _body: &RigidBody, _axis: [L; 3]) -> [L; 3] {
        [L::of(0.0); 3]
    }

    /// The part c_i/I_i of the momentum in a second.
    fn resistance(&self, _t: f64, body: &RigidBody) -> Option<Resistance> {
        let [i1, i2, i3] = body.moments().to_array();
        let (transverse, axial) = (self.transverse, self.axial);
        Some(Resistance::linear([transverse / i1, transverse / i2, axial / i3]))
    }

    fn narrowest(&self) -> Option<Feature> {
        Some(Feature::WIDE)
    }
}
