//! A free rod that is hit at its end, from what is conserved, and the scene of contacts that knows no
//! conservation law.

// ANCHOR: physics
use super::Parameters;
use super::strike::Strike;
use kit::prelude::*;

/// What the conservation of momentum and of angular momentum gives. Lengths along the rod
/// are counted from its middle, away from the particle.
#[derive(Debug, Clone, Copy)]
pub struct Answer {
    pub length: f64,
    pub centre: f64,   // where the centre of mass is
    pub velocity: f64, // its velocity, before and after
    pub momentum: f64, // angular momentum about it, before and after
    pub angular_velocity: f64,
    pub energies: [f64; 2], // kinetic energy before and after
}

impl Answer {
    pub fn new(p: &Parameters) -> Self {
        let (length, whole, arm) = (p.length, p.mass + p.particle, 0.5 * p.length);
        let (centre, velocity) = (-arm * p.particle / whole, p.speed * p.particle / whole);
        // Two masses at the distance l/2 turn about their centre like this one at that distance.
        let reduced = p.mass * p.particle / whole;
        let momentum = reduced * p.speed * arm;
        let inertia = p.mass * length * length / 12.0 + reduced * arm * arm;
        let angular_velocity = momentum / inertia;
        let moving = 0.5 * whole * velocity * velocity;
        let before = 0.5 * p.particle * p.speed * p.speed;
        let energies = [before, moving + 0.5 * momentum * angular_velocity];
        Self { length, centre, velocity, momentum, angular_velocity, energies }
    }

    /// Velocity of the point at this place on the rod just after the impact, along the particle's.
    pub fn after(&self, place: f64) -> f64 {
        self.velocity - self.angular_velocity * (place - self.centre)
    }

    /// Where a point of the rod is at the time `t` (s) after the impact.
    pub fn at(&self, t: f64, place: f64) -> (f64, f64) {
        let ((s, c), far) = (sincos(self.angular_velocity * t), place - self.centre);
        (self.velocity * t - far * s, self.centre + far * c)
    }
}

/// The scene of these parameters.
pub fn scene(p: &Parameters) -> Strike {
    let &Parameters { mass: rod, particle, length, speed, .. } = p;
    Strike { rod, particle, length, speed, hinged: false, arm: 0.5 * length, rub: 0.0 }
}

/// The answer for the ratio particle over rod, in units of the rod, its length and the speed.
pub fn ratio(particle: f64) -> Answer {
    let (mass, length, speed) = (1.0, 1.0, 1.0);
    Answer::new(&Parameters { mass, particle, length, speed, ..Parameters::default() })
}
// ANCHOR_END: physics
