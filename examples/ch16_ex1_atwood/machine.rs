//! Atwood's machine from Newton's law for each body, with a rope that holds on the pulley or
//! slips, and that may be heavy.

use core::f64::consts::PI;
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
    pub acceleration: f64,
    pub rim: f64,
    pub tensions: [f64; 2],
}

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
        let [acceleration, rim, first, second] = solve(rows, weights);
        let tensions = [first, second];
        // For a light pulley their difference would have lost its digits.
        let light = self.pulley < 1e-3 * (left + right);
        let rim = if light && grip == Grip::Holds {
            acceleration
        } else {
            rim
        };
        Forces {
            acceleration,
            rim,
            tensions,
        }
    }
    // ANCHOR_END: newton

    /// What the rope does where it runs as fast as the rim.
    fn level(&self, way: f64) -> Grip {
        let [first, second] = self.forces(Grip::Holds, way).tensions;
        if first > self.grip * second {
            Grip::Ahead
        } else if second > self.grip * first {
            Grip::Behind
        } else {
            Grip::Holds
        }
    }

    /// The machine seen from behind.
    #[must_use]
    pub fn mirrored(mut self) -> Self {
        self.masses.reverse();
        self
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
        let mut all = vec![Condition::gap(
            "arrives",
            |y: &[f64; 4]| self.height - y[0].abs(),
            Next::End,
        )];
        let slips = |ahead: bool, next| {
            let margin = move |y: &[f64; 4]| {
                let [first, second] = self.forces(grip, y[0]).tensions;
                let (more, less) = if ahead {
                    (first, second)
                } else {
                    (second, first)
                };
                self.grip * less - more
            };
            Condition::gap("slips", margin, Next::Enter(next))
        };
        let catches = |sign: f64| {
            let next = Next::decide(|_, y: &[f64; 4]| Ok((self.level(y[0]), *y)));
            Condition::opening_gap("catches", move |y: &[f64; 4]| sign * (y[3] - y[1]), next)
        };
        all.extend(match grip {
            Grip::Holds => vec![slips(true, Grip::Ahead), slips(false, Grip::Behind)],
            Grip::Behind => vec![catches(1.0)],
            Grip::Ahead => vec![catches(-1.0)],
        });
        all
    }

    fn scale(&self, y: &[f64; 4]) -> [f64; 4] {
        size_or([1.0; 4])(y)
    }
}

/// The ratio of the tensions of a rope that slips over half a turn, from the pull of each piece:
/// dT = mu T d(theta).
pub fn capstan(friction: f64) -> Result<f64> {
    Ok(after(
        PI,
        &ode(move |_, [t]: &[f64; 1]| [friction * t]).scaled(size_or([1.0; 1])),
        &[1.0],
        1e-14,
    )?[0])
}

/// The solution of four linear equations, by elimination.
fn solve(mut rows: [[f64; 4]; 4], mut right: [f64; 4]) -> [f64; 4] {
    for k in 0..4 {
        let best = (k..4).max_by(|&i, &j| rows[i][k].abs().total_cmp(&rows[j][k].abs()));
        let best = best.unwrap_or(k);
        rows.swap(k, best);
        right.swap(k, best);
        for i in (0..4).filter(|&i| i != k) {
            let part = rows[i][k] / rows[k][k];
            let row = rows[k];
            rows[i]
                .iter_mut()
                .zip(row)
                .for_each(|(a, b)| *a -= part * b);
            right[i] -= part * right[k];
        }
    }
    core::array::from_fn(|k| right[k] / rows[k][k])
}
