//! A ladder that slides down a wall: the scene of two contacts, and its motion in closed form, by
//! simulation, and by a solver that keeps the wall.

// ANCHOR: physics
use super::{Parameters, rounding};
use core::f64::consts::FRAC_PI_2;
use kit::prelude::*;
use models::ladder::Ladder as Exact;
use rotation_dynamics::planar::contact::{
    Contact, ContactMotion, Mechanism, MechanismState, Surface, kept_within, motion_within,
};

/// A ladder between wall and floor, per unit mass. Its coordinates are `[x, y, theta]`: its middle,
/// and its angle from the wall.
#[derive(Debug, Clone, Copy)]
pub struct Ladder {
    pub length: f64,
    pub gravity: f64,
    pub inertia: f64, // about the middle, over that of a uniform rod, m l^2/12
    pub mu: f64,      // coefficient of friction at both ends
}

// ANCHOR: scene
impl Mechanism<3, 2> for Ladder {
    fn mass(&self, _: &[f64; 3]) -> [[f64; 3]; 3] {
        let turning = self.inertia * self.length * self.length / 12.0;
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, turning]]
    }

    fn force(&self, _: &MechanismState<3>) -> [f64; 3] {
        [0.0, -self.gravity, 0.0]
    }

    fn contacts(&self, ladder: &MechanismState<3>) -> [Contact<3>; 2] {
        let ((s, c), half) = (sincos(ladder.q[2]), 0.5 * self.length);
        // The two ends, seen from the middle.
        let (top, foot) = ([-half * s, half * c], [half * s, -half * c]);
        let wall = Contact::corner("wall", ladder, top, Surface::WALL);
        let floor = Contact::corner("foot", ladder, foot, Surface::FLOOR);
        [wall.friction(self.mu), floor.friction(self.mu)]
    }

    fn end(&self, ladder: &MechanismState<3>) -> Option<(&'static str, f64)> {
        Some(("lands", FRAC_PI_2 - ladder.q[2]))
    }
    // ANCHOR_END: scene

    /// Errors count relative to each coordinate, so a start a hair off the wall is followed
    /// as closely as any other.
    fn scale(&self, ladder: &MechanismState<3>) -> MechanismState<3> {
        let rate = (1.5 * self.gravity / self.length).sqrt();
        let q = [ladder.q[0].abs(), self.length, ladder.q[2].abs()];
        let v = q.map(|size| rate * size);
        MechanismState { q, v }
    }
}

pub type Slide = ContactMotion<Ladder, 3, 2>;

impl Ladder {
    /// The uniform, smooth ladder of the exercise.
    pub fn smooth(p: &Parameters) -> Self {
        Self { length: p.length, gravity: p.gravity, inertia: 1.0, mu: 0.0 }
    }

    /// At rest at this angle, both ends touching.
    pub fn at_rest(&self, angle: f64) -> MechanismState<3> {
        let half = 0.5 * self.length;
        MechanismState::rest([half * sin(angle), half * cos(angle), angle])
    }

    /// How far the top is from the wall.
    pub fn top_gap(&self, ladder: &MechanismState<3>) -> f64 {
        ladder.q[0] - 0.5 * self.length * sin(ladder.q[2])
    }
}

/// The exact motion, the simulated one, and the one of a solver that keeps the wall.
pub struct Solved {
    pub exact: Exact,
    pub ladder: Ladder,
    pub run: Slide,
    pub naive: Slide,
}

// ANCHOR: solve
pub fn solve(p: &Parameters) -> Result<Solved> {
    let exact = Exact::new(p.length, p.gravity, p.angle)?;
    let ladder = Ladder::smooth(p);
    let start = ladder.at_rest(p.angle);
    let end = 2.0 * exact.landing_time();
    let tolerance = p.tolerance.max(rounding(p));
    let run = motion_within(ladder, tolerance, start, end)?;
    let naive = kept_within(ladder, tolerance, start, end)?;
    Ok(Solved { exact, ladder, run, naive })
}
// ANCHOR_END: solve
// ANCHOR_END: physics
