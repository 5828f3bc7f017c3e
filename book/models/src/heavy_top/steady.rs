//! A top in slow steady precession, and what a torque that its scene leaves out does to it.

use super::Gravity;
use core::f64::consts::{PI, TAU};
use rotation_dynamics::accuracy::NeglectedEffects;
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::{Effect, GravityAtLever};
use rotation_dynamics::frame::BodyVector;
use rotation_dynamics::math::{cos, sin};
use rotation_dynamics::scene::Scene;
use rotation_dynamics::{Error, Result};

/// The error asked of the motions that are compared, rad.
const TOLERANCE: f64 = 1e-10;

/// A top that precesses steadily at its tilt, by the smaller of the two rates, for a turn.
///
/// ```
/// use rotation_dynamics::body::RigidBody;
/// use rotation_dynamics::effects::{CoulombBearing, GravityAtLever};
/// use rotation_dynamics::inertia::PrincipalMoments;
/// use rotation_dynamics::math::sin;
/// use models::heavy_top::Steady;
/// # fn main() -> kit::Result<()> {
/// let body = RigidBody::new(PrincipalMoments::symmetric(5.45e-3, 9e-4)?);
/// let steady = Steady::new(body, GravityAtLever::new(4.9, 0.1)?, 1.0, 314.0)?;
/// let bearing = CoulombBearing::new(1e-4, &body, &steady.start, 0.0)?;
/// // Slower, it precesses faster: its axis is ahead after a turn, by both routes.
/// let [_, lead] = steady.changed_by(bearing)?;
/// let predicted = steady.left_out()?.predict(&bearing, 0.0)?.predicted;
/// assert!((predicted / (sin(1.0) * lead) - 1.0).abs() < 0.01);
/// # Ok(())
/// # }
/// ```
#[derive(Debug, Clone)]
pub struct Steady {
    /// The body and its weight.
    pub scene: Scene<Gravity>,
    /// The start, on the way already.
    pub start: State,
    /// The time of a turn about the vertical, s.
    pub turn: f64,
}

impl Steady {
    /// The top of this body and weight at this tilt (rad) with this angular velocity along
    /// its axis (rad/s).
    ///
    /// # Errors
    /// [`Error::OutOfRange`] if it spins too slowly to be held there.
    pub fn new(body: RigidBody, gravity: GravityAtLever, theta: f64, spin: f64) -> Result<Self> {
        let (i1, momentum) = (body.moments().i1(), body.moments().i3() * spin);
        let four = 4.0 * i1 * gravity.moment() * cos(theta);
        let square = momentum * momentum;
        if !(square >= four && square > 0.0) {
            return Err(Error::out_of_range(
                "L_z^2/(4 I1 m g l cos(theta))",
                square / four,
                "1 or more: slower, the weight lets the axis fall",
            ));
        }
        // The small root of I1 cos(theta) p^2 - L_z p + m g l = 0.
        let root = momentum.signum() * (square - four).sqrt();
        let rate = 2.0 * gravity.moment() / (momentum + root);
        let (phi, zeta) = (0.0, 0.0);
        let tilted = Attitude::from_euler(EulerAngles { phi, theta, zeta })?;
        let start = body.state(tilted, BodyVector::new(0.0, rate * sin(theta), spin))?;
        Ok(Self { scene: Scene::new(body).with(gravity), start, turn: TAU / rate.abs() })
    }

    /// The candidates for the card of effects: what counts is the direction of the axis, at
    /// any time of the turn.
    ///
    /// # Errors
    /// None for a motion that [`Steady::new`] made.
    pub fn left_out(&self) -> Result<NeglectedEffects<'_, Gravity>> {
        let candidates = self.scene.neglected_effects(&self.start, self.turn, 1e-3)?;
        Ok(candidates.of_axis())
    }

    /// By how much the axis has sunk and is ahead after the turn (rad, tilt and azimuth), if
    /// this acts as well: two motions, each solved.
    ///
    /// # Errors
    /// Those of [`Scene::solve`].
    pub fn changed_by(&self, effect: impl Effect) -> Result<[f64; 2]> {
        let ([tilt, azimuth], [other, ahead]) = (self.after(())?, self.after(effect)?);
        let beyond = ahead - azimuth;
        Ok([other - tilt, beyond - TAU * (beyond / TAU).round()])
    }

    /// Tilt, and azimuth beyond the turn (between -pi and pi), after the time of a turn, with
    /// this effect.
    ///
    /// # Errors
    /// Those of [`Scene::solve`].
    pub fn after(&self, effect: impl Effect) -> Result<[f64; 2]> {
        let scene = self.scene.with(effect);
        let end = scene.solve(&self.start, self.turn, TOLERANCE)?.state;
        let EulerAngles { phi, theta, .. } = end.attitude.euler_angles();
        Ok([theta, if phi > PI { phi - TAU } else { phi }])
    }
}
