//! A particle on a table, on a string through a hole: in closed form, and by Newton's law in the
//! plane, with a string that cannot stretch.

// ANCHOR: physics
use kit::prelude::*;
use rotation_dynamics::integrators::Dop853;
use rotation_dynamics::planar::contact::{
    Contact, ContactMotion, Mechanism, MechanismState, motion,
};

/// The motion while the string is pulled; lengths in r0, speeds in u, forces in m u^2/r0.
#[derive(Debug, Clone, Copy)]
pub struct Answer {
    pub pull: f64, // speed of the hand
}

impl Answer {
    pub fn radius(&self, t: f64) -> f64 {
        1.0 - self.pull * t
    }
    pub fn across(&self, t: f64) -> f64 {
        1.0 / self.radius(t)
    }
    pub fn angular_velocity(&self, t: f64) -> f64 {
        1.0 / (self.radius(t) * self.radius(t))
    }
    pub fn angle(&self, t: f64) -> f64 {
        t / self.radius(t)
    }
    pub fn force(&self, t: f64) -> f64 {
        self.angular_velocity(t) / self.radius(t)
    }
    /// Work of the hand up to `t`, without the jerk: (1/r^2 - 1)/2, written without the difference.
    pub fn work(&self, t: f64) -> f64 {
        0.5 * self.pull * t * (1.0 + self.radius(t)) * self.angular_velocity(t)
    }
}

/// The string on the table: a knot at the hole lets no more of it out, a hand takes it in.
#[derive(Debug, Clone, Copy)]
pub struct Pull {
    pub knot: f64,  // how much of it the knot leaves
    pub hand: f64,  // how much the hand leaves when the clock shows zero
    pub speed: f64, // of the hand
    pub hole: f64,  // radius of the hole
}

// ANCHOR: string
/// Coordinates: the particle, and a clock.
impl Mechanism<3, 2> for Pull {
    fn mass(&self, _: &[f64; 3]) -> [[f64; 3]; 3] {
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
    }

    fn force(&self, _: &MechanismState<3>) -> [f64; 3] {
        [0.0; 3]
    }

    fn contacts(&self, state: &MechanismState<3>) -> [Contact<3>; 2] {
        let ([x, y, clock], r, across) = (state.q, radius(state), across(state));
        // Taut when the length that is left is the distance from the middle of the hole.
        let taut = |name, left: f64| {
            let inward = [-x / r, -y / r, 0.0];
            Contact::new(name, left - r, inward, -across * across / r)
        };
        let hand = taut("hand", self.hand - self.speed * clock);
        [taut("knot", self.knot), hand.rising(self.speed, 0.0)]
    }
    // ANCHOR_END: string

    fn end(&self, state: &MechanismState<3>) -> Option<(&'static str, f64)> {
        Some(("edge", radius(state) - self.hole))
    }

    fn scale(&self, state: &MechanismState<3>) -> MechanismState<3> {
        let r = radius(state);
        MechanismState { q: [r, r, 1.0], v: [1.0 / r, 1.0 / r, 1.0] }
    }
}

/// Distance from the middle of the hole.
pub fn radius(MechanismState { q, .. }: &MechanismState<3>) -> f64 {
    hypot(q[0], q[1])
}

/// Velocity away from the hole.
pub fn outward(MechanismState { q, v }: &MechanismState<3>) -> f64 {
    (q[0] * v[0] + q[1] * v[1]) / hypot(q[0], q[1])
}

/// Velocity at right angles to the string.
pub fn across(MechanismState { q, v }: &MechanismState<3>) -> f64 {
    (q[0] * v[1] - q[1] * v[0]) / hypot(q[0], q[1])
}

/// Kinetic energy.
pub fn energy(MechanismState { v, .. }: &MechanismState<3>) -> f64 {
    0.5 * (v[0] * v[0] + v[1] * v[1])
}
// ANCHOR_END: physics

/// How long the particle circles before the hand pulls.
const BEFORE: f64 = 0.5;

/// A motion of the particle; its mass, its first radius and its first speed are 1. The hand pulls
/// from the time 0 on.
pub struct Pulled {
    pub motion: ContactMotion<Pull, 3, 2>,
    before: f64, // how long the motion lasts before the time 0
}

impl Pulled {
    /// The circle, and the pull at this speed, up to the time `end` or the edge of the hole.
    pub fn new(speed: f64, hole: f64, step: f64, end: f64) -> Result<Self> {
        let (s, c) = sincos(BEFORE);
        let (q, v) = ([c, -s, -BEFORE], [s, c, 1.0]);
        let pull = Pull { knot: 1.0, hand: 1.0, speed, hole };
        let motion = motion(pull, &Dop853::new(step)?, MechanismState { q, v }, BEFORE + end)?;
        Ok(Self { motion, before: BEFORE })
    }

    /// The motion from this state on when the string is held, for a while.
    pub fn held(start: MechanismState<3>, step: f64, end: f64) -> Result<Self> {
        // The hand is out of reach, the hole too.
        let pull = Pull { knot: radius(&start), hand: 2.0, speed: 0.0, hole: 0.0 };
        Ok(Self { motion: motion(pull, &Dop853::new(step)?, start, end)?, before: 0.0 })
    }

    /// This time on the clock of the motion, kept between its beginning and its end.
    fn clock(&self, t: f64) -> f64 {
        (t + self.before).clamp(0.0, self.motion.end_time())
    }

    /// The state at this time.
    pub fn at(&self, t: f64) -> Result<MechanismState<3>> {
        Ok(self.motion.at(self.clock(t))?)
    }

    /// The tension at this time.
    pub fn tension(&self, t: f64) -> Result<f64> {
        let forces = self.motion.forces(self.clock(t))?;
        Ok(forces.iter().map(|force| force.normal).sum())
    }

    /// When it ends.
    pub fn end(&self) -> f64 {
        self.motion.end_time() - self.before
    }

    /// The angle from the time 0 to `t`, in small steps.
    pub fn angle(&self, t: f64) -> Result<f64> {
        let last = self.at(t)?;
        let count = 1 + (2.0 * t * across(&last) / radius(&last)) as u32;
        let places = sampled(times(0.0, t, count), |t| Ok(self.at(t)?.q))?;
        let turn = |[[x, y, _], [u, v, _]]: [[f64; 3]; 2]| atan2(x * v - y * u, x * u + y * v);
        Ok(places.windows(2).map(|pair| turn([pair[0], pair[1]])).sum())
    }
}
