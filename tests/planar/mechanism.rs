//! A uniform ladder between the floor and a wall that may overhang.

use core::f64::consts::FRAC_PI_2;
use rotation_dynamics::math::{sincos, tan};
use rotation_dynamics::planar::contact::{Contact, Mechanism, MechanismState, Surface};

/// Its length (m).
pub const LENGTH: f64 = 3.0;

/// The ladder, per unit mass: its centre, and its angle from the vertical.
#[derive(Debug, Clone, Copy)]
pub struct Ladder {
    pub gravity: f64,
    /// How far the wall leans over it (rad).
    pub overhang: f64,
    /// Friction at both ends.
    pub mu: f64,
}

impl Ladder {
    /// At rest at this angle, its top on the wall.
    pub fn at_rest(&self, angle: f64) -> MechanismState<3> {
        let ((s, c), half) = (sincos(angle), 0.5 * LENGTH);
        let top = tan(self.overhang) * LENGTH * c;
        MechanismState::rest([top + half * s, half * c, angle])
    }
}

impl Mechanism<3, 2> for Ladder {
    fn mass(&self, _: &[f64; 3]) -> [[f64; 3]; 3] {
        let inertia = LENGTH * LENGTH / 12.0;
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, inertia]]
    }
    fn force(&self, _: &MechanismState<3>) -> [f64; 3] {
        [0.0, -self.gravity, 0.0]
    }
    fn contacts(&self, ladder: &MechanismState<3>) -> [Contact<3>; 2] {
        let (s, c) = sincos(ladder.q[2]);
        let (s, c) = (0.5 * LENGTH * s, 0.5 * LENGTH * c);
        let (sin, cos) = sincos(self.overhang);
        let wall = Surface { normal: [cos, -sin], offset: 0.0 };
        [
            Contact::corner("wall", ladder, [-s, c], wall).friction(self.mu),
            Contact::corner("foot", ladder, [s, -c], Surface::FLOOR).friction(self.mu),
        ]
    }
    fn end(&self, ladder: &MechanismState<3>) -> Option<(&'static str, f64)> {
        Some(("lands", FRAC_PI_2 - ladder.q[2]))
    }
    fn scale(&self, ladder: &MechanismState<3>) -> MechanismState<3> {
        let rate = (1.5 * self.gravity / LENGTH).sqrt();
        let q = [ladder.q[0].abs(), LENGTH, ladder.q[2].abs()];
        MechanismState { q, v: q.map(|size| rate * size) }
    }
}
