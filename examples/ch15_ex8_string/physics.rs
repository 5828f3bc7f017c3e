//! A particle on a table, on a string through a hole: in closed form, and by Newton's law in the
//! plane, with a string that cannot stretch.

// ANCHOR: physics
use core::f64::consts::TAU;
use rotation_dynamics::math::{atan2, hypot};
use rotation_dynamics::planar::contact::{Contact, Mechanism, MechanismState};

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

    fn contacts(&self, MechanismState { q, v }: &MechanismState<3>) -> [Contact<3>; 2] {
        let ([x, y, clock], r) = (*q, hypot(q[0], q[1]));
        let across = (x * v[1] - y * v[0]) / r;
        // Taut when the length that is left is the distance from the middle of the hole.
        let taut = |name, left: f64| {
            let inward = [-x / r, -y / r, 0.0];
            Contact::new(name, left - r, inward, -across * across / r)
        };
        let hand = taut("hand", self.hand - self.speed * clock);
        [taut("knot", self.knot), hand.rising(self.speed, 0.0)]
    }
    // ANCHOR_END: string

    fn end(&self, MechanismState { q, .. }: &MechanismState<3>) -> Option<(&'static str, f64)> {
        Some(("edge", hypot(q[0], q[1]) - self.hole))
    }

    fn scale(&self, MechanismState { q, .. }: &MechanismState<3>) -> MechanismState<3> {
        let r = hypot(q[0], q[1]);
        let (q, v) = ([r, r, 1.0], [1.0 / r, 1.0 / r, 1.0]);
        MechanismState { q, v }
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

/// The direction of the string at a state, between 0 and a turn.
pub fn direction(MechanismState { q, .. }: &MechanismState<3>) -> f64 {
    atan2(q[1], q[0]).rem_euclid(TAU)
}
// ANCHOR_END: physics
