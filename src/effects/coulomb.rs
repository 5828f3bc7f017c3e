//! Dry friction about the axis, until the spin stops.

use super::{Effect, Feature, Properties, Resistance};
use crate::body::{RigidBody, State};
use crate::error::{Error, Result, finite, not_negative, plain};
use crate::frame::SpaceVector;
use crate::math::{EPS, Lane};

/// The name of this effect.
const NAME: &str = "Coulomb bearing";

/// L_z may be off what the bearing was made for by this part of |L|: rounding.
const ROUNDING: f64 = 64.0 * EPS;

/// Dry friction of constant size about the axis e3 of a symmetric body, until it stops.
///
/// The torque is -tau sign(L_z) e3 while the body spins about its axis, and none once it
/// does not: dry friction holds what is at rest. Without another torque about the axis
/// L_z falls linearly, so the time of the stop is known beforehand,
///
/// t_stop = t_start + |L_z|/tau,
///
/// and is the effect's break point: solutions meet it exactly, and nothing chatters. On
/// either side the torque is smooth. The axis itself moves on freely, with L_z = 0.
///
/// That is why the effect belongs to one body and one start, and to a scene without another torque
/// about the axis. [`Scene::solve`](crate::scene::Scene::solve) and [`check`](super::check) refuse
/// it in a scene with an effect whose properties do not keep L_z ([`Error::Incompatible`]). They
/// also refuse it from a state that is not on the motion for which it was made (the same error). An
/// integrator called by itself does not look.
///
/// Valid for dry and rolling bearings under constant load, at speeds at which the coefficient of
/// friction is constant. A bearing of radius r that carries the force N has tau = mu N r (ball
/// bearing: mu = 0.0015). Number: [`number`](Self::number).
///
/// ```
/// use rotation_dynamics::attitude::Attitude;
/// use rotation_dynamics::body::RigidBody;
/// use rotation_dynamics::effects::CoulombBearing;
/// use rotation_dynamics::frame::BodyVector;
/// use rotation_dynamics::inertia::PrincipalMoments;
/// use rotation_dynamics::scene::Scene;
/// # fn main() -> rotation_dynamics::Result<()> {
/// let body = RigidBody::new(PrincipalMoments::symmetric(1.0, 0.5)?);
/// let start = body.state(Attitude::IDENTITY, BodyVector::new(0.0, 0.0, 4.0))?;
/// let bearing = CoulombBearing::new(0.25, &body, &start, 0.0)?;
/// assert_eq!(bearing.stop(), Some(8.0));
/// let end = Scene::new(body).with(bearing).solve(&start, 20.0, 1e-9)?.state;
/// assert!(body.angular_velocity(&end).z().abs() < 1e-12);
/// # Ok(())
/// # }
/// ```
///
/// Source: C. A. Coulomb, *Théorie des machines simples* (1785); mu of ball bearings: SKF,
/// *Rolling bearings*, "Bearing friction".
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CoulombBearing {
    /// Along e3 while the body spins (N m).
    torque: f64,
    t_start: f64,
    axial_momentum: f64,
    stop: f64,
}

impl CoulombBearing {
    /// The friction torque `tau` (N m) on this body, from this start at `t_start` (s).
    ///
    /// # Errors
    /// A torque that is negative or not finite; a time that is not finite; a body that is
    /// not symmetric, whose own motion changes L_z.
    pub fn new(tau: f64, body: &RigidBody, start: &State, t_start: f64) -> Result<Self> {
        not_negative("friction torque", tau)?;
        finite("start time", t_start)?;
        symmetric(body)?;
        let axial_momentum = finite("L_z", body.angular_momentum(start).z())?;
        let stop =
            if axial_momentum == 0.0 { t_start } else { t_start + axial_momentum.abs() / tau };
        let torque = if axial_momentum == 0.0 { 0.0 } else { tau * -axial_momentum.signum() };
        Ok(Self { torque, t_start, axial_momentum, stop })
    }

    /// The time of the stop (s); `None` if there is no friction, or so little that no `f64`
    /// holds the time.
    pub fn stop(&self) -> Option<f64> {
        self.stop.is_finite().then_some(self.stop)
    }

    /// L_z at the time `t` (kg m^2/s); NaN at a time that is not finite.
    pub fn axial_momentum(&self, t: f64) -> f64 {
        if !t.is_finite() {
            f64::NAN
        } else if t < self.stop {
            self.axial_momentum + self.torque * (t - self.t_start)
        } else {
            0.0
        }
    }
}

fn symmetric(body: &RigidBody) -> Result<()> {
    let moments = body.moments();
    if moments.is_symmetric() {
        return Ok(());
    }
    Err(Error::out_of_range(
        "I2 - I1",
        moments.i2() - moments.i1(),
        "0, a symmetric body: of another the motion itself changes L_z, so the \
                  time at which a Coulomb bearing stops it is not known",
    ))
}

impl Effect for CoulombBearing {
    const PROPERTIES: Properties =
        Properties { on_rates: false, smooth: true, ..Properties::ANYTHING };

    fn name(&self) -> &'static str {
        NAME
    }

    #[inline]
    fn torque(&self, t: f64, _body: &RigidBody, state: &State) -> SpaceVector {
        if !t.is_finite() {
            SpaceVector::new(f64::NAN, f64::NAN, f64::NAN)
        } else if t < self.stop {
            state.attitude.axis() * self.torque
        } else {
            SpaceVector::zero()
        }
    }

    #[inline(always)]
    fn torques_on_axis<L: Lane>(&self, _body: &RigidBody, _axis: [L; 3]) -> [L; 3] {
        [L::of(0.0); 3]
    }

    /// Until the stop.
    fn resistance(&self, t: f64, _body: &RigidBody) -> Option<Resistance> {
        t.is_finite()
            .then(|| if t < self.stop { Resistance::dry(self.torque) } else { Resistance::NONE })
    }

    fn torque_scale(&self, _t: f64, _body: &RigidBody, _state: &State) -> f64 {
        self.torque.abs()
    }

    fn break_points(&self) -> Vec<f64> {
        self.stop().into_iter().collect()
    }

    fn narrowest(&self) -> Option<Feature> {
        Some(Feature::WIDE)
    }

    fn holds_from(
        &self,
        t: f64,
        body: &RigidBody,
        start: &State,
        about_axis: &[&'static str],
    ) -> Result<()> {
        symmetric(body)?;
        let mut others = about_axis.to_vec();
        if let Some(this) = others.iter().position(|name| *name == NAME) {
            others.remove(this);
        }
        if !others.is_empty() {
            let others = others.join(", ");
            let reason = format!(
                "\"{NAME}\" must be the only torque about the body's axis; here are also: {others}"
            );
            return Err(Error::incompatible(others, reason));
        }
        let (value, expected) = (body.angular_momentum(start).z(), self.axial_momentum(t));
        let scale = start.angular_momentum.norm().max(self.axial_momentum.abs());
        if (value - expected).abs() <= ROUNDING * scale {
            return Ok(());
        }
        let reason = format!(
            "\"{NAME}\" was made for a motion in which L_z is {} at t = {}, and here it is {}: \
             make it anew from this body and this start",
            plain(expected),
            plain(t),
            plain(value)
        );
        Err(Error::incompatible(NAME.into(), reason))
    }
}
