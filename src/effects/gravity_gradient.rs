//! The torque of an attracting body on a satellite.

use super::{Conserved, Effect, Feature, Properties};
use crate::body::{RigidBody, State};
use crate::error::{Error, Result, finite, positive};
use crate::frame::{BodyVector, SpaceVector};
use crate::math::{MOST_TURNS, sincos};
use core::f64::consts::TAU;

/// The torque about the centre of mass of a satellite whose near side is attracted more
/// than its far side, on a circular orbit that is given.
///
/// ```text
/// torque = 3 n0^2 n x (I n),   n0^2 = G M/r^3,
/// U = (3/2) n0^2 (n . I n - trace(I)/3)
/// ```
///
/// with n the direction to the attracting body, which turns about the normal of the orbit
/// at the mean motion n0. U leaves out -G M m/r; its mean over all directions is 0.
///
/// The moving n does work: kinetic energy plus U changes by dU/dt at a fixed attitude
/// ([`Effect::power`]). The conserved quantity is that energy less n0 times the
/// component of L along the normal (Jacobi's integral). A direction that is
/// [`fixed`](Self::fixed) is a type of its own, which keeps the energy.
///
/// Range of validity: a satellite small against r (the next term is smaller by size/r, for a body
/// that is even in its axes by the square of that). It must be light against the attracting body,
/// which counts as a point; the attitude does not act back on the orbit.
///
/// ```
/// use rotation_dynamics::attitude::Attitude;
/// use rotation_dynamics::body::RigidBody;
/// use rotation_dynamics::effects::GravityGradient;
/// use rotation_dynamics::frame::{BodyVector, SpaceVector};
/// use rotation_dynamics::inertia::PrincipalMoments;
/// use rotation_dynamics::scene::Scene;
/// # fn main() -> rotation_dynamics::Result<()> {
/// let n0 = 1.1e-3; // a turn in 95 minutes
/// let (normal, down) = (SpaceVector::new(0.0, 0.0, 1.0), SpaceVector::new(-1.0, 0.0, 0.0));
/// let gradient = GravityGradient::on_orbit(n0, normal, down)?;
/// // Its long axis, e1, points down and goes round with the orbit: it stays so.
/// let body = RigidBody::new(PrincipalMoments::new(20.0, 90.0, 100.0)?);
/// let start = body.state(Attitude::IDENTITY, BodyVector::new(0.0, 0.0, n0))?;
/// let hour = Scene::new(body).with(gradient).solve(&start, 3600.0, 1e-9)?;
/// let round = Attitude::about_space_axis(normal, n0 * 3600.0)?;
/// assert!(hour.state.attitude.angle_to(&round) < 1e-9);
/// # Ok(())
/// # }
/// ```
///
/// Other orbits: [`OrbitingBody`](super::OrbitingBody).
///
/// Source: P. C. Hughes, *Spacecraft Attitude Dynamics* (1986), 8.1 and 9.3; for the
/// potential H. Goldstein, C. Poole, J. Safko, *Classical Mechanics*, 3rd ed., 5.8.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GravityGradient<const FIXED: bool = false> {
    mean_motion: f64,
    /// The direction at t = 0, and a quarter of an orbit later.
    towards: SpaceVector,
    later: SpaceVector,
}

impl GravityGradient {
    /// The gradient on a circular orbit with this mean motion n0 (rad/s, positive) about this
    /// normal. The attracting body is seen in the direction `towards` at t = 0, all on the fixed
    /// axes; the lengths of the two do not matter.
    ///
    /// # Errors
    /// A mean motion that is not positive and finite, a direction that is not finite or has
    /// no length, directions that are not at right angles (to 1e-9).
    pub fn on_orbit(mean_motion: f64, normal: SpaceVector, towards: SpaceVector) -> Result<Self> {
        let normal = unit(["normal, X", "normal, Y", "normal, Z"], normal)?;
        let towards = unit(TOWARDS, towards)?;
        let along = normal.dot(&towards);
        if along.abs() > 1e-9 {
            return Err(Error::out_of_range(
                "cosine of the angle between normal and towards",
                along,
                "0: the attracting body lies in the plane of the orbit",
            ));
        }
        let towards = unit(TOWARDS, towards - normal * along)?;
        Ok(Self { mean_motion: rate(mean_motion)?, towards, later: normal.cross(&towards) })
    }
}

impl GravityGradient<true> {
    /// The gradient of an attracting body that stays in the direction `towards`, with
    /// sqrt(G M/r^3) = `mean_motion` (rad/s, positive): for times that are short against an orbit,
    /// or a distance that is held.
    ///
    /// # Errors
    /// As [`GravityGradient::on_orbit`].
    pub fn fixed(mean_motion: f64, towards: SpaceVector) -> Result<Self> {
        Ok(Self {
            mean_motion: rate(mean_motion)?,
            towards: unit(TOWARDS, towards)?,
            later: SpaceVector::zero(),
        })
    }
}

const TOWARDS: [&str; 3] = ["towards, X", "towards, Y", "towards, Z"];

/// The rate, if its square is a number too.
fn rate(rate: f64) -> Result<f64> {
    positive("mean motion", rate)?;
    positive("mean motion squared", rate * rate)?;
    Ok(rate)
}

fn unit(names: [&'static str; 3], direction: SpaceVector) -> Result<SpaceVector> {
    for (name, value) in names.into_iter().zip(direction.to_array()) {
        finite(name, value)?;
    }
    let length = direction.norm();
    positive("length of a direction", length)?;
    Ok(direction / length)
}

impl<const FIXED: bool> GravityGradient<FIXED> {
    /// The direction n to the attracting body at the time `t` (s); NaN where the time is not
    /// finite or [so late](crate::exact#how-late) that the phase of the orbit is lost.
    pub fn direction(&self, t: f64) -> SpaceVector {
        if FIXED {
            return self.towards + self.later * t;
        }
        let (s, c) = sincos(self.phase(t));
        self.towards * c + self.later * s
    }

    /// n0 t, or NaN where it is lost.
    fn phase(&self, t: f64) -> f64 {
        let phase = self.mean_motion * t;
        if phase.abs() <= MOST_TURNS * TAU { phase } else { f64::NAN }
    }

    /// The mean motion n0, or of a fixed direction sqrt(G M/r^3) (rad/s).
    pub const fn mean_motion(&self) -> f64 {
        self.mean_motion
    }
}

/// 3 g n x (I n) for this direction n and this 3 g (1/s^2), from the differences of the
/// moments: exactly 0 for a sphere.
#[inline]
pub(super) fn torque_towards(
    direction: SpaceVector,
    strength: f64,
    body: &RigidBody,
    state: &State,
) -> SpaceVector {
    let [x, y, z] = state.attitude.to_body(direction).to_array();
    let [i1, i2, i3] = body.moments().to_array();
    let turn = BodyVector::new((i3 - i2) * y * z, (i1 - i3) * z * x, (i2 - i1) * x * y);
    state.attitude.to_space(turn) * strength
}

pub(super) fn extremes(body: &RigidBody) -> [f64; 2] {
    let [i1, i2, i3] = body.moments().to_array();
    [i1.min(i2).min(i3), i1.max(i2).max(i3)]
}

/// The moments less their mean, from their differences.
pub(super) fn deviations(body: &RigidBody) -> [f64; 3] {
    let [i1, i2, i3] = body.moments().to_array();
    [((i1 - i2) + (i1 - i3)) / 3.0, ((i2 - i3) + (i2 - i1)) / 3.0, ((i3 - i1) + (i3 - i2)) / 3.0]
}

impl<const FIXED: bool> Effect for GravityGradient<FIXED> {
    const PROPERTIES: Properties = Properties {
        on_rates: false,
        on_time: !FIXED,
        smooth: true,
        conserved: Conserved { energy: FIXED, ..Conserved::NONE },
        ..Properties::ANYTHING
    };

    fn name(&self) -> &'static str {
        "gravity gradient"
    }

    #[inline]
    fn torque(&self, t: f64, body: &RigidBody, state: &State) -> SpaceVector {
        let strength = 3.0 * self.mean_motion * self.mean_motion;
        torque_towards(self.direction(t), strength, body, state)
    }

    fn potential_energy(&self, t: f64, body: &RigidBody, state: &State) -> f64 {
        let [x, y, z] = state.attitude.to_body(self.direction(t)).to_array();
        let [d1, d2, d3] = deviations(body);
        1.5 * self.mean_motion * self.mean_motion * (d1 * x * x + d2 * y * y + d3 * z * z)
    }

    /// dU/dt at a fixed attitude: 3 n0^2 (I n) . n'.
    fn power(&self, t: f64, body: &RigidBody, state: &State) -> f64 {
        if FIXED {
            return 0.0;
        }
        let n0 = self.mean_motion;
        let (s, c) = sincos(self.phase(t));
        let moving = (self.later * c - self.towards * s) * n0;
        let [x, y, z] = state.attitude.to_body(self.direction(t)).to_array();
        let [dx, dy, dz] = state.attitude.to_body(moving).to_array();
        let [d1, d2, d3] = deviations(body);
        3.0 * n0 * n0 * (d1 * x * dx + d2 * y * dy + d3 * z * dz)
    }

    /// The number by which the gradient is judged: 3 (n0/omega)^2 (I_max - I_min)/I_max, about
    /// the angle (rad) by which it turns L while the body turns once; infinite for a
    /// body at rest.
    fn number(&self, body: &RigidBody, state: &State) -> f64 {
        let [least, largest] = extremes(body);
        if largest == least {
            return 0.0;
        }
        let ratio = self.mean_motion / body.angular_velocity(state).norm();
        3.0 * ratio * ratio * ((largest - least) / largest)
    }

    /// The largest torque, (3/2) n0^2 (I_max - I_min).
    fn torque_scale(&self, _t: f64, body: &RigidBody, _state: &State) -> f64 {
        let [least, largest] = extremes(body);
        1.5 * self.mean_motion * self.mean_motion * (largest - least)
    }

    /// Half an orbit, after which n x (I n) comes again.
    fn narrowest(&self) -> Option<Feature> {
        let time = if FIXED { f64::INFINITY } else { core::f64::consts::PI / self.mean_motion };
        Some(Feature { time, ..Feature::WIDE })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::attitude::Attitude;
    use crate::inertia::PrincipalMoments;

    /// The power is the rate of the potential at a fixed attitude.
    #[test]
    fn the_power_is_that_of_the_potential() {
        let (normal, towards) = (SpaceVector::new(0.0, 0.0, 1.0), SpaceVector::new(1.0, 0.0, 0.0));
        let gradient = GravityGradient::on_orbit(0.7, normal, towards).expect("an orbit");
        let body = RigidBody::new(PrincipalMoments::new(1.0, 1.4, 2.1).expect("a body"));
        let attitude = Attitude::from_quaternion([0.7, 0.1, -0.3, 0.5]).expect("not zero");
        let state = State::new(attitude, SpaceVector::zero()).expect("finite");
        for t in [0.0, 1.3, -40.0] {
            let h = 1e-3;
            let u = |k: f64| gradient.potential_energy(t + k * h, &body, &state);
            let changed = (8.0 * (u(1.0) - u(-1.0)) - (u(2.0) - u(-2.0))) / (12.0 * h);
            let power = gradient.power(t, &body, &state);
            assert!((changed - power).abs() < 1e-10, "{t}: {changed} {power}");
        }
    }
}
