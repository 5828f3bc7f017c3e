//! A disc on a string that is wound on its rim and tied to it: the fall in closed form, and Newton's
//! law in a plane, to the end of the string and over it.

// ANCHOR: physics
use super::Parameters;
use core::f64::consts::PI;
use rotation_dynamics::Result;
use rotation_dynamics::integrators::{Dop853, size_or};
use rotation_dynamics::math::{atan2, hypot, sincos};
use rotation_dynamics::planar::{Condition, Next, Phased, Run, simulate};

/// The fall while the string unwinds: acceleration of the centre and tension of the string.
pub fn fall(p: &Parameters) -> [f64; 2] {
    let weight = p.mass * p.gravity;
    [p.gravity / (1.0 + p.shape), weight * p.shape / (1.0 + p.shape)]
}

/// The time after which this much string has unwound.
pub fn unwound(p: &Parameters, length: f64) -> f64 {
    (2.0 * length / fall(p)[0]).sqrt()
}

/// The disc and its string at the start; mass, radius and g are 1, y is up from the hook at (0, 0).
#[derive(Debug, Clone, Copy)]
pub struct Disc {
    pub shape: f64, // moment of inertia
    pub wound: f64, // length of the string that is wound up
    pub free: f64,  // length between hook and disc
}

/// Where the string leaves the disc: its rim, with the disc on the left of the string, the knot at
/// the end of the string, or the rim again, with the disc on the right.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Leaves {
    Unwinding,
    Knot,
    Winding,
}

/// What the taut string does.
#[derive(Debug, Clone, Copy)]
pub struct Taut {
    pub arm: [f64; 2], // from the centre of the disc to where the string leaves it
    pub tension: f64,
    pub acceleration: [f64; 2], // of the centre
    pub spin: f64,              // angular acceleration
    pub margin: f64, // not negative: angle still wound up, or cosine between knot and string
    pub winds: f64,  // the rate at which string is wound up or, negative, unwound
}

// ANCHOR: newton
impl Disc {
    pub fn length(&self) -> f64 {
        self.wound + self.free
    }

    /// The string where it is taut. The state: the centre, the direction from it to the knot,
    /// and their rates. The string pulls along `-u` at the end of the arm, which turns the disc
    /// by `-tension * lever`. As it does not stretch, that end's acceleration along `u` is known.
    pub fn taut(&self, leaves: Leaves, &[x, y, knot, vx, vy, rate]: &[f64; 6]) -> Taut {
        let (sk, ck) = sincos(knot);
        // The side of the string on which the disc is.
        let side = if leaves == Leaves::Winding { 1.0 } else { -1.0 };
        let ([ux, uy], arm, bend, margin, winds);
        if leaves == Leaves::Knot {
            let (far, [wx, wy]) = (hypot(x + ck, y + sk), [vx - rate * sk, vy + rate * ck]);
            [ux, uy] = [(x + ck) / far, (y + sk) / far];
            let along = ux * ck + uy * sk;
            let across = ux * wy - uy * wx;
            arm = [ck, sk];
            bend = across * across / far - rate * rate * along;
            (margin, winds) = (-along, 0.0);
        } else {
            let square = x * x + y * y;
            let straight = (square - 1.0).sqrt();
            [ux, uy] = [(straight * x + side * y) / square, (straight * y - side * x) / square];
            let across = ux * vy - uy * vx;
            arm = [side * uy, -side * ux];
            bend = across * across / straight;
            let angle = atan2(ux, -uy) + if side > 0.0 { PI } else { 0.0 };
            (margin, winds) = (side * (knot - angle), side * (rate - across / straight));
        }
        let lever = arm[0] * uy - arm[1] * ux;
        let tension = (bend - uy) / (1.0 + lever * lever / self.shape);
        let acceleration = [-tension * ux, -tension * uy - 1.0];
        Taut { arm, tension, acceleration, spin: -tension * lever / self.shape, margin, winds }
    }
    // ANCHOR_END: newton

    /// The motion from rest: down, over the knot, and up until no more string is wound up.
    pub fn run(&self, step: f64) -> Result<Run<Leaves, 6>> {
        let start = [-1.0, -self.free, -self.wound, 0.0, 0.0, 0.0];
        simulate(self, &Dop853::new(step)?, Leaves::Unwinding, start, 1e5)
    }
}

impl Phased<6> for Disc {
    type Phase = Leaves;

    fn derivative(&self, leaves: Leaves, y: &[f64; 6]) -> [f64; 6] {
        let taut = self.taut(leaves, y);
        let [ax, ay] = taut.acceleration;
        [y[3], y[4], y[5], ax, ay, taut.spin]
    }

    fn conditions(&self, leaves: Leaves) -> Vec<Condition<'_, Leaves, 6>> {
        let margin = move |y: &[f64; 6]| self.taut(leaves, y).margin;
        let slack = Condition::contact("slack", move |y| self.taut(leaves, y).tension, Next::End);
        let roof = Condition::gap("roof", |y: &[f64; 6]| -1.0 - y[1], Next::End);
        let winds = move |y: &[f64; 6]| self.taut(leaves, y).winds;
        let next = match leaves {
            Leaves::Unwinding => Condition::gap("all unwound", margin, Next::Enter(Leaves::Knot)),
            Leaves::Knot => {
                Condition::opening_gap("winds up", margin, Next::Enter(Leaves::Winding))
            }
            Leaves::Winding => Condition::gap("top", winds, Next::End),
        };
        vec![slack, roof, next]
    }

    fn scale(&self, y: &[f64; 6]) -> [f64; 6] {
        size_or([1.0; 6])(y)
    }
}
// ANCHOR_END: physics
