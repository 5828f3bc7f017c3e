//! Atwood's machine in closed form and from Newton's law for each body, with a rope that holds on
//! the pulley or slips, and that may be heavy.

use core::f64::consts::PI;
use kit::solved;
use rotation_dynamics::Result;
use rotation_dynamics::integrators::{Dop853, after, ode, size_or};
use rotation_dynamics::planar::{Condition, Next, Phased, Run, simulate};

/// The machine. Its state is the way and the velocity of the mass on the left downward, and the
/// same of a point of the rim.
#[derive(Debug, Clone, Copy)]
pub struct Machine {
    /// The mass on the left and the one on the right, kg.
    pub masses: [f64; 2],
    /// I/R^2, kg.
    pub pulley: f64,
    /// Acceleration of gravity, m/s^2.
    pub gravity: f64,
    /// The most that one tension can be over the other before the rope slips.
    pub grip: f64,
    /// Mass of the rope for a metre, kg/m.
    pub rope: f64,
    /// How far both masses hang below the axle at the start, m.
    pub height: f64,
}

/// What the rope does on the pulley.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Grip {
    Holds,
    /// It runs faster than the rim.
    Ahead,
    /// The rim runs faster.
    Behind,
}

/// Accelerations of the masses and of the rim, and the tension on either side.
#[derive(Debug, Clone, Copy)]
pub struct Forces {
    pub grip: Grip,
    pub acceleration: f64,
    pub rim: f64,
    pub tensions: [f64; 2],
}

// ANCHOR: answer
impl Forces {
    /// In closed form, for a rope without mass that holds. Beside a much lighter mass g - a would
    /// have lost its digits, so each tension is formed without it.
    pub fn held(m: &Machine) -> Self {
        let ([m1, m2], pulley, grip) = (m.masses, m.pulley, Grip::Holds);
        let part = m.gravity / (m1 + m2 + pulley);
        let (acceleration, rim) = ((m1 - m2) * part, (m1 - m2) * part);
        let tensions = [m1 * (2.0 * m2 + pulley), m2 * (2.0 * m1 + pulley)].map(|sum| sum * part);
        Self {
            grip,
            acceleration,
            rim,
            tensions,
        }
    }

    /// In closed form; the rope slips on the heavier side, where it would pull too much to be held.
    pub fn new(m: &Machine) -> Self {
        let held = Self::held(m);
        let (grip, [more, less]) = match m.masses {
            [left, right] if left < right => (Grip::Behind, [1, 0]),
            _ => (Grip::Ahead, [0, 1]),
        };
        if held.tensions[more] <= m.grip * held.tensions[less] {
            return held;
        }
        let (heavier, lighter) = (m.masses[more], m.masses[less]);
        let part = m.gravity / (heavier + m.grip * lighter);
        let size = (heavier - m.grip * lighter) * part;
        let behind = 2.0 * heavier * lighter * part;
        let mut tensions = [behind; 2];
        tensions[more] = m.grip * behind;
        Self {
            grip,
            acceleration: size.copysign(held.acceleration),
            rim: (tensions[0] - tensions[1]) / m.pulley,
            tensions,
        }
    }
}
// ANCHOR_END: answer

// ANCHOR: newton
impl Machine {
    /// Newton's law for both masses, with their rope, and for the pulley; what the rope does on
    /// the pulley is the fourth equation. Unknown are the two accelerations and the two tensions.
    pub fn forces(&self, grip: Grip, way: f64) -> Forces {
        let left = self.masses[0] + self.rope * (self.height + way);
        let right = self.masses[1] + self.rope * (self.height - way);
        let on_pulley = match grip {
            Grip::Holds => [1.0, -1.0, 0.0, 0.0],
            Grip::Ahead => [0.0, 0.0, 1.0, -self.grip],
            Grip::Behind => [0.0, 0.0, self.grip, -1.0],
        };
        let rows = [
            [left, 0.0, 1.0, 0.0],
            [right, 0.0, 0.0, -1.0],
            [0.0, self.pulley, -1.0, 1.0],
            on_pulley,
        ];
        let weights = [left * self.gravity, -right * self.gravity, 0.0, 0.0];
        let [acceleration, rim, first, second] = solved(rows, weights);
        let tensions = [first, second];
        // For a light pulley their difference would have lost its digits.
        let light = self.pulley < 1e-3 * (left + right);
        let rim = if light && grip == Grip::Holds {
            acceleration
        } else {
            rim
        };
        Forces {
            grip,
            acceleration,
            rim,
            tensions,
        }
    }
    // ANCHOR_END: newton

    /// How far each tension, over the other, is from dragging the rope over the pulley.
    fn lacks(&self, way: f64) -> [f64; 2] {
        let [first, second] = self.forces(Grip::Holds, way).tensions;
        [self.grip * second - first, self.grip * first - second]
    }

    /// What the rope does where it runs as fast as the rim.
    fn level(&self, way: f64) -> Grip {
        match self.lacks(way) {
            [first, _] if first < 0.0 => Grip::Ahead,
            [_, second] if second < 0.0 => Grip::Behind,
            _ => Grip::Holds,
        }
    }

    /// The motion from rest; the rim may run already. It ends at the pulley.
    pub fn run(&self, rim: f64, step: f64, end: f64) -> Result<Run<Grip, 4>> {
        let grip = match rim {
            _ if rim > 0.0 => Grip::Behind,
            _ if rim < 0.0 => Grip::Ahead,
            _ => self.level(0.0),
        };
        simulate(self, &Dop853::new(step)?, grip, [0.0, 0.0, 0.0, rim], end)
    }
}

impl Phased<4> for Machine {
    type Phase = Grip;

    fn derivative(&self, grip: Grip, [way, speed, _, rim]: &[f64; 4]) -> [f64; 4] {
        let forces = self.forces(grip, *way);
        [*speed, forces.acceleration, *rim, forces.rim]
    }

    fn conditions(&self, grip: Grip) -> Vec<Condition<'_, Grip, 4>> {
        let left = |y: &[f64; 4]| self.height - y[0].abs();
        let arrives = Condition::gap("arrives", left, Next::End);
        let slips = |side: usize, next| {
            let lacks = move |y: &[f64; 4]| self.lacks(y[0])[side];
            Condition::gap("slips", lacks, Next::Enter(next))
        };
        let catches = |sign: f64| {
            let next = Next::decide(|_, y: &[f64; 4]| Ok((self.level(y[0]), *y)));
            Condition::opening_gap("catches", move |y| sign * (y[3] - y[1]), next)
        };
        match grip {
            Grip::Holds => vec![arrives, slips(0, Grip::Ahead), slips(1, Grip::Behind)],
            Grip::Behind => vec![arrives, catches(1.0)],
            Grip::Ahead => vec![arrives, catches(-1.0)],
        }
    }

    fn scale(&self, y: &[f64; 4]) -> [f64; 4] {
        size_or([1.0; 4])(y)
    }
}

/// The ratio of the tensions of a rope that slips over half a turn, from the pull of each piece:
/// dT = mu T d(theta).
pub fn capstan(friction: f64) -> Result<f64> {
    let pulled = ode(|_, [t]: &[f64; 1]| [friction * t]).scaled(size_or([1.0; 1]));
    Ok(after(PI, &pulled, &[1.0], 1e-14)?[0])
}
