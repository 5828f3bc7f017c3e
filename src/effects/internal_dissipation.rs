//! A body that loses energy inside, with nothing from outside acting.

use super::{Conserved, Effect, Feature, Properties};
use crate::body::{RigidBody, State};
use crate::error::{Result, positive};
use crate::frame::SpaceVector;

/// Energy lost inside a body (fuel that sloshes, an antenna that bends, rock that creeps),
/// at constant L.
///
/// There is no torque: the body's axes drift,
///
/// ```text
/// slip = a L x omega,   on the body's axes  l' = l x omega + a l x (l x omega),
/// ```
///
/// so that l keeps its length and turns towards the axis of the largest moment. The
/// energy falls by dE/dt = -a |L x omega|^2, down to L^2/(2 I_max). A symmetric body's
/// nutation angle obeys tan(theta) = tan(theta_0) exp(-t/tau) with
/// 1/tau = a L^2 (I3 - I1)/(I1 I3) ([`rate`](Self::rate)): a flat body's closes, a thin one's
/// opens, as Explorer 1 did.
///
/// Range of validity: a |L| small against 1, so that little is lost in a turn. The form is
/// the simplest that keeps |L| and loses energy; how a real material's loss depends on
/// rates and frequency is put into a, for one motion.
///
/// ```
/// use rotation_dynamics::attitude::Attitude;
/// use rotation_dynamics::body::RigidBody;
/// use rotation_dynamics::effects::InternalDissipation;
/// use rotation_dynamics::frame::BodyVector;
/// use rotation_dynamics::inertia::PrincipalMoments;
/// use rotation_dynamics::scene::Scene;
/// # fn main() -> rotation_dynamics::Result<()> {
/// // A rod spun about its length, not quite: it ends turning end over end.
/// let body = RigidBody::new(PrincipalMoments::new(1.0, 1.1, 0.1)?);
/// let start = body.state(Attitude::IDENTITY, BodyVector::new(0.01, 0.0, 5.0))?;
/// let scene = Scene::new(body).with(InternalDissipation::new(0.05)?);
/// let end = scene.solve(&start, 600.0, 1e-6)?.state;
/// assert_eq!(end.angular_momentum, start.angular_momentum);
/// let least = start.angular_momentum.norm().powi(2) / (2.0 * 1.1);
/// assert!((scene.energy(&end) / least - 1.0).abs() < 1e-4);
/// # Ok(())
/// # }
/// ```
///
/// Source: A. Bloch, P. S. Krishnaprasad, J. E. Marsden, T. S. Ratiu, Commun. Math. Phys.
/// 175, 1 (1996): the double bracket; P. C. Hughes, *Spacecraft Attitude Dynamics* (1986),
/// 5.5: the energy sink.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct InternalDissipation {
    coefficient: f64,
}

impl InternalDissipation {
    /// The loss with this coefficient a (s/(kg m^2), positive).
    ///
    /// # Errors
    /// A coefficient that is not positive and finite.
    pub fn new(coefficient: f64) -> Result<Self> {
        positive("coefficient", coefficient)?;
        Ok(Self { coefficient })
    }

    /// The coefficient a (s/(kg m^2)).
    pub const fn coefficient(&self) -> f64 {
        self.coefficient
    }
    /// 1/tau = a L^2 (I3 - I1)/(I1 I3) (1/s): the rate at which ln tan(theta) of a symmetric
    /// body falls; negative for a thin one.
    pub fn rate(&self, body: &RigidBody, state: &State) -> f64 {
        let (i1, i3) = (body.moments().i1(), body.moments().i3());
        let l = state.angular_momentum.norm();
        self.coefficient * l * l * (i3 - i1) / (i1 * i3)
    }
}

impl Effect for InternalDissipation {
    const PROPERTIES: Properties = Properties {
        on_time: false,
        smooth: true,
        slips: true,
        conserved: Conserved { momentum: [true; 3], ..Conserved::NONE },
        ..Properties::ANYTHING
    };

    fn name(&self) -> &'static str {
        "internal dissipation"
    }

    #[inline]
    fn torque(&self, _t: f64, _body: &RigidBody, _state: &State) -> SpaceVector {
        SpaceVector::zero()
    }

    #[inline]
    fn slip(&self, _t: f64, body: &RigidBody, state: &State) -> SpaceVector {
        let omega = state.attitude.to_space(body.angular_velocity(state));
        state.angular_momentum.cross(&omega) * self.coefficient
    }

    #[inline]
    /// The number by which the loss is judged: a |L|, the largest slip as a part of omega. A
    /// symmetric body's tan(theta) changes by its a |L|/cos(theta)-th part per radian of
    /// the wobble.
    fn number(&self, _body: &RigidBody, state: &State) -> f64 {
        self.coefficient * state.angular_momentum.norm()
    }

    fn torque_scale(&self, _t: f64, _body: &RigidBody, _state: &State) -> f64 {
        0.0
    }

    fn narrowest(&self) -> Option<Feature> {
        Some(Feature::WIDE)
    }
}
