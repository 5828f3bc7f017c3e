//! The torque of an attracting body on an orbit that is given: Sun, Moon, a planet.

use super::gravity_gradient::{deviations, extremes, torque_towards};
use super::{Effect, Feature, KeplerOrbit, Properties};
use crate::body::{RigidBody, State};
use crate::error::{Error, Result, finite, positive};
use crate::frame::SpaceVector;
use core::f64::consts::PI;

/// The torque about the centre of mass of a body whose near side is attracted more than
/// its far side, by a body on a [`KeplerOrbit`].
///
/// ```text
/// torque = 3 g n x (I n),   g = G m/r^3,
/// U = (3/2) g (n . I n - trace(I)/3)
/// ```
///
/// with n the direction to the attracting body, of mass m, and r its distance, both from
/// the orbit. On a circle it is the [`GravityGradient`](super::GravityGradient), to rounding
/// (4 eps, as measured). Several attracting bodies are several effects of one scene.
///
/// [`averaged`](OrbitingBody::averaged) is the mean of it over the orbit, for times that are long
/// against the period. With the normal k of the orbit, the mean of n n/r^3 is the mean of 1/r^3
/// times (1 - k k)/2, so it is
///
/// ```text
/// mean torque = 3 g k x (I k),   g = -(1/2) G m/(a^3 (1 - e^2)^(3/2)).
/// ```
///
/// Range of validity: as of the gravity gradient; the attitude does not act back on the
/// orbit. Number: [`number`](Self::number).
///
/// ```
/// use rotation_dynamics::attitude::Attitude;
/// use rotation_dynamics::body::RigidBody;
/// use rotation_dynamics::effects::{KeplerOrbit, OrbitingBody};
/// use rotation_dynamics::frame::{BodyVector, SpaceVector};
/// use rotation_dynamics::inertia::PrincipalMoments;
/// use rotation_dynamics::scene::Scene;
/// # fn main() -> rotation_dynamics::Result<()> {
/// // The Earth for a month: the Moon pulls at its bulge.
/// let day = 86_400.0;
/// let orbit = KeplerOrbit::elliptic(3.844e8, 27.55 * day, 0.0549)?.oriented(1.0, 0.0898, 2.0)?;
/// let moon = OrbitingBody::new(4.9028e12, orbit)?;
/// let earth = RigidBody::new(PrincipalMoments::symmetric(1.0 - 3.2738e-3, 1.0)?);
/// let tilted = Attitude::about_space_axis(SpaceVector::new(-1.0, 0.0, 0.0), 0.40909)?;
/// let start = earth.state(tilted, BodyVector::new(0.0, 0.0, 7.292e-5))?;
/// let month = Scene::new(earth).with(moon).solve(&start, 27.55 * day, 1e-7)?.state;
/// // The pole moves by about an arcsecond, against the orbital motion.
/// let moved = month.angular_momentum - start.angular_momentum;
/// let arcsec = moved.norm() / start.angular_momentum.norm() * 206_265.0;
/// assert!((0.5..2.0).contains(&arcsec) && moved.x() > 0.0);
/// # Ok(())
/// # }
/// ```
///
/// Source: P. C. Hughes, *Spacecraft Attitude Dynamics* (1986), 8.1; for the mean
/// H. Goldstein, C. Poole, J. Safko, *Classical Mechanics*, 3rd ed., 5.8.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OrbitingBody<const AVERAGED: bool = false> {
    gravitational_parameter: f64,
    orbit: KeplerOrbit,
}

impl OrbitingBody {
    /// A body with this G m (m^3/s^2, its own alone) on this orbit.
    ///
    /// # Errors
    /// A gravitational parameter that is not positive and finite, or a torque per moment of
    /// inertia at the pericentre that doubles do not hold.
    pub fn new(gravitational_parameter: f64, orbit: KeplerOrbit) -> Result<Self> {
        positive("gravitational parameter", gravitational_parameter)?;
        let made = Self { gravitational_parameter, orbit };
        finite("G m/r^3 at the pericentre", made.strongest())?;
        positive("G m/r^3 at the pericentre", made.strongest())?;
        Ok(made)
    }

    /// Its mean over the orbit: of a body spread along it, so that each part has what the body
    /// has in time.
    ///
    /// # Errors
    /// An orbit that does not close.
    pub fn averaged(&self) -> Result<OrbitingBody<true>> {
        if self.orbit.period() == f64::INFINITY {
            return Err(Error::out_of_range(
                "eccentricity",
                self.orbit.eccentricity(),
                "less than 1: other orbits have no mean",
            ));
        }
        Ok(OrbitingBody {
            gravitational_parameter: self.gravitational_parameter,
            orbit: self.orbit,
        })
    }
}

impl<const AVERAGED: bool> OrbitingBody<AVERAGED> {
    /// Its orbit.
    pub const fn orbit(&self) -> &KeplerOrbit {
        &self.orbit
    }

    /// The direction n, a unit vector, and the strength g (1/s^2) at the time `t` (s): the
    /// torque is 3 g n x (I n). NaN where [`KeplerOrbit::place`] is, or the normal.
    pub fn pull(&self, t: f64) -> (SpaceVector, f64) {
        if AVERAGED {
            return (self.orbit.normal(t), self.strongest());
        }
        let place = self.orbit.at(t);
        (place.direction, self.strength(place.distance))
    }

    fn strength(&self, distance: f64) -> f64 {
        self.gravitational_parameter / distance / distance / distance
    }

    /// g where it is largest.
    fn strongest(&self) -> f64 {
        if AVERAGED {
            return -0.5 * self.gravitational_parameter * self.orbit.mean_inverse_cube();
        }
        self.strength(self.orbit.pericentre())
    }
}

impl<const AVERAGED: bool> Effect for OrbitingBody<AVERAGED> {
    const PROPERTIES: Properties =
        Properties { on_rates: false, smooth: true, ..Properties::ANYTHING };

    fn name(&self) -> &'static str {
        if AVERAGED { "orbiting body, averaged" } else { "orbiting body" }
    }

    #[inline]
    fn torque(&self, t: f64, body: &RigidBody, state: &State) -> SpaceVector {
        let (direction, strength) = self.pull(t);
        torque_towards(direction, 3.0 * strength, body, state)
    }

    fn potential_energy(&self, t: f64, body: &RigidBody, state: &State) -> f64 {
        let (direction, strength) = self.pull(t);
        let [x, y, z] = state.attitude.to_body(direction).to_array();
        let [d1, d2, d3] = deviations(body);
        1.5 * strength * (d1 * x * x + d2 * y * y + d3 * z * z)
    }

    /// dU/dt at a fixed attitude: (3/2) (g' n . I n + 2 g n' . I n).
    fn power(&self, t: f64, body: &RigidBody, state: &State) -> f64 {
        let (direction, strength) = self.pull(t);
        let (moving, growing) = if AVERAGED {
            let node = SpaceVector::new(0.0, 0.0, self.orbit.node_rate());
            (node.cross(&direction), 0.0)
        } else {
            let place = self.orbit.at(t);
            let receding = place.velocity.dot(&direction);
            let across = place.velocity - direction * receding;
            let by = 1.0 / place.distance;
            (across * by, -3.0 * strength * (receding * by))
        };
        let [x, y, z] = state.attitude.to_body(direction).to_array();
        let [dx, dy, dz] = state.attitude.to_body(moving).to_array();
        let [d1, d2, d3] = deviations(body);
        1.5 * growing * (d1 * x * x + d2 * y * y + d3 * z * z)
            + 3.0 * strength * (d1 * x * dx + d2 * y * dy + d3 * z * dz)
    }

    /// The number by which it is judged: 3 |g|/omega^2 (I_max - I_min)/I_max at its strongest,
    /// about the angle (rad) by which it turns L while the body turns once; infinite for a body
    /// at rest.
    fn number(&self, body: &RigidBody, state: &State) -> f64 {
        let [least, largest] = extremes(body);
        if largest == least {
            return 0.0;
        }
        let omega = body.angular_velocity(state).norm();
        3.0 * (self.strongest().abs() / omega / omega) * ((largest - least) / largest)
    }

    /// The largest torque, (3/2) |g| (I_max - I_min) at the pericentre.
    fn torque_scale(&self, _t: f64, body: &RigidBody, _state: &State) -> f64 {
        let [least, largest] = extremes(body);
        1.5 * self.strongest().abs() * (largest - least)
    }

    /// Half a turn at the angular velocity of the pericentre, after which n x (I n) would come
    /// again, less on an eccentric orbit, down to half of that on a parabola: the passage. For the
    /// mean, half a turn of the node.
    fn narrowest(&self) -> Option<Feature> {
        let time = if AVERAGED {
            PI / self.orbit.node_rate().abs()
        } else {
            PI / (self.orbit.fastest() * (1.0 + self.orbit.eccentricity()).min(2.0))
        };
        Some(Feature { time, ..Feature::WIDE })
    }
}
