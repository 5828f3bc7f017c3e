//! The plank on two rollers (exercise 16.8) as a mechanism of two contacts.

use rotation_dynamics::Result;
use rotation_dynamics::integrators::Dop853;
use rotation_dynamics::math::sincos;
use rotation_dynamics::planar::contact::{
    Contact, ContactMotion, Mechanism, MechanismState, motion,
};

/// A thin plank of 2 kg and 3 m on rollers a distance `a` apart, whose tops move with `speed`
/// toward each other (or apart, if it is negative).
pub struct Plank {
    pub a: f64,
    pub g: f64,
    pub kinetic: f64,
    pub holding: f64,
    pub speed: f64,
}

impl Mechanism<3, 2> for Plank {
    fn mass(&self, _: &[f64; 3]) -> [[f64; 3]; 3] {
        [[2.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 1.5]]
    }
    fn force(&self, _: &MechanismState<3>) -> [f64; 3] {
        [0.0, -2.0 * self.g, 0.0]
    }
    fn contacts(&self, plank: &MechanismState<3>) -> [Contact<3>; 2] {
        let ([x, y, tilt], [vx, vy, omega]) = (plank.q, plank.v);
        let (s, c) = sincos(tilt);
        let roller = |name, at: f64, speed: f64| {
            let gap = y * c - (x - at) * s;
            let lever = -(x - at) * c - y * s;
            let bias = -2.0 * omega * (c * vx + s * vy) - gap * omega * omega;
            Contact::new(name, gap, [-s, c, lever], bias)
                .tangent([c, s, 0.0], omega * (c * vy - s * vx))
                .frictions(self.kinetic, self.holding)
                .moving(speed)
        };
        [roller("left", -0.5 * self.a, self.speed), roller("right", 0.5 * self.a, -self.speed)]
    }
}

/// The motion from here, with this error a step.
pub fn laid(
    plank: &Plank,
    x: f64,
    v: f64,
    t_end: f64,
    tolerance: f64,
) -> Result<ContactMotion<&Plank, 3, 2>> {
    let start = MechanismState { q: [x, 0.0, 0.0], v: [v, 0.0, 0.0] };
    motion(plank, &Dop853::new(tolerance)?, start, t_end)
}
