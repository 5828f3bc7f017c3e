//! Atwood's machine in closed form and from Newton's law for each body, with a rope that holds on
//! the pulley or slips, and that may be heavy.

use core::f64::consts::PI;
// ANCHOR: physics
use kit::solved;
use rotation_dynamics::Result;
use rotation_dynamics::integrators::{Dop853, after, ode, size_or};
use rotation_dynamics::planar::{Condition, Next, Phased, Run, simulate};

/// The machine. Its state is the way and the velocity of the mass on the left, downward, and of
/// a point of the rim.
#[derive(Debug, Clone, Copy)]
pub struct Machine {
    pub masses: [f64; 2], // on the left and on the right, kg
    pub pulley: f64,      // I/R^2, kg
    pub gravity: f64,     // m/s^2
    pub grip: f64,        // the largest ratio of the tensions at which the rope does not slip
    pub rope: f64,        // mass of the rope for a metre, kg/m
    pub height: f64,      // how far both masses hang below the axle at the start, m
}

/// The rope holds on the pulley, or it is ahead of the rim, or behind.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Grip {
    Holds,
    Ahead,
    Behind,
}

/// Accelerations of the masses and of the rim, tensions on the left and on the right.
pub type Forces = [f64; 4];

impl Machine {
    /// In closed form, for a rope without mass; the tensions as sums, since g - a may lose digits.
    pub fn closed_form(&self) -> (Grip, Forces) {
        let ([m1, m2], pulley, k) = (self.masses, self.pulley, self.grip);
        let part = self.gravity / (m1 + m2 + pulley);
        let [t1, t2] = [m1 * (2.0 * m2 + pulley), m2 * (2.0 * m1 + pulley)].map(|sum| sum * part);
        let a = (m1 - m2) * part;
        if t1.max(t2) <= k * t1.min(t2) {
            return (Grip::Holds, [a, a, t1, t2]);
        }
        // It slips on the heavier side, where it would pull too much to be held.
        let (heavier, lighter) = (m1.max(m2), m1.min(m2));
        let part = self.gravity / (heavier + k * lighter);
        let (size, behind) = ((heavier - k * lighter) * part, 2.0 * heavier * lighter * part);
        let (grip, [t1, t2]) = match m1 < m2 {
            true => (Grip::Behind, [behind, k * behind]),
            false => (Grip::Ahead, [k * behind, behind]),
        };
        (grip, [size.copysign(a), (t1 - t2) / pulley, t1, t2])
    }

    // ANCHOR: newton
    /// Newton's law for both masses, with their rope, and for the pulley; the fourth equation says
    /// whether the rope holds or slips. Unknown are both accelerations and both tensions.
    pub fn forces(&self, grip: Grip, way: f64) -> Forces {
        let left = self.masses[0] + self.rope * (self.height + way);
        let right = self.masses[1] + self.rope * (self.height - way);
        let on_pulley = match grip {
            Grip::Holds => [1.0, -1.0, 0.0, 0.0],
            Grip::Ahead => [0.0, 0.0, 1.0, -self.grip],
            Grip::Behind => [0.0, 0.0, self.grip, -1.0],
        };
        let left_mass = [left, 0.0, 1.0, 0.0];
        let right_mass = [right, 0.0, 0.0, -1.0];
        let pulley = [0.0, self.pulley, -1.0, 1.0];
        let weights = [left * self.gravity, -right * self.gravity, 0.0, 0.0];
        let [a, rim, t1, t2] = solved([left_mass, right_mass, pulley, on_pulley], weights);
        // For a light pulley the difference of the tensions would have lost its digits.
        let light = self.pulley < 1e-3 * (left + right) && grip == Grip::Holds;
        [a, if light { a } else { rim }, t1, t2]
    }
    // ANCHOR_END: newton

    /// How far each of the tensions is from dragging the rope over the pulley, N.
    fn lacks(&self, way: f64) -> [f64; 2] {
        let [_, _, t1, t2] = self.forces(Grip::Holds, way);
        [self.grip * t2 - t1, self.grip * t1 - t2]
    }

    /// What the rope does where it runs as fast as the rim.
    fn level(&self, way: f64) -> Grip {
        match self.lacks(way) {
            [first, _] if first < 0.0 => Grip::Ahead,
            [_, second] if second < 0.0 => Grip::Behind,
            _ => Grip::Holds,
        }
    }

    /// The motion from rest; the rim may run ahead already. It ends at the pulley.
    pub fn run(&self, rim: f64, step: f64, end: f64) -> Result<Run<Grip, 4>> {
        let grip = [self.level(0.0), Grip::Behind][usize::from(rim > 0.0)];
        simulate(self, &Dop853::new(step)?, grip, [0.0, 0.0, 0.0, rim], end)
    }
}

impl Phased<4> for Machine {
    type Phase = Grip;

    fn derivative(&self, grip: Grip, [way, speed, _, rim]: &[f64; 4]) -> [f64; 4] {
        let [a, rim_a, ..] = self.forces(grip, *way);
        [*speed, a, *rim, rim_a]
    }

    fn conditions(&self, grip: Grip) -> Vec<Condition<'_, Grip, 4>> {
        let arrives = Condition::gap("arrives", |y: &[f64; 4]| self.height - y[0].abs(), Next::End);
        let slips = |side: usize, next| {
            let lacks = move |y: &[f64; 4]| self.lacks(y[0])[side];
            Condition::gap("slips", lacks, Next::Enter(next))
        };
        let next = Next::decide(|_, y: &[f64; 4]| Ok((self.level(y[0]), *y)));
        let catches = Condition::opening_gap("catches", |y: &[f64; 4]| y[3] - y[1], next);
        match grip {
            Grip::Holds => vec![arrives, slips(0, Grip::Ahead), slips(1, Grip::Behind)],
            Grip::Behind => vec![arrives, catches],
            Grip::Ahead => vec![arrives],
        }
    }

    fn scale(&self, y: &[f64; 4]) -> [f64; 4] {
        size_or([1.0; 4])(y)
    }
}
// ANCHOR_END: physics

/// The ratio of the tensions of a rope that slips over half a turn, from the pull of each piece:
/// dT = mu T d(theta).
pub fn capstan(friction: f64) -> Result<f64> {
    let pulled = ode(|_, [t]: &[f64; 1]| [friction * t]).scaled(size_or([1.0; 1]));
    Ok(after(PI, &pulled, &[1.0], 1e-14)?[0])
}
