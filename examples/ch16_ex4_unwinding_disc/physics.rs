//! A disc on a string that is wound on its rim and tied to it: the fall in closed form, and Newton's
//! law in a plane, to the end of the string and over it.

// ANCHOR: physics
use super::Parameters;
use core::f64::consts::{FRAC_PI_2, PI};
use kit::prelude::*;
use rotation_dynamics::integrators::{Dop853, Event, ode, size_or};
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
        Ok(simulate(self, &Dop853::new(step)?, Leaves::Unwinding, start, 1e5)?)
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

// The other routes: the turn on a string that gives, Lagrange's equations in angles, and a string
// so long that it stays vertical.

impl Disc {
    /// Energy of a state, from the hook.
    pub fn energy(&self, &[_, y, _, vx, vy, rate]: &[f64; 6]) -> f64 {
        0.5 * (vx * vx + vy * vy + self.shape * rate * rate) + y
    }

    /// The largest tension on the knot.
    pub fn peak(&self, run: &Run<Leaves, 6>) -> Result<f64> {
        let [from, to] = ["all unwound", "winds up"].map(|name| run.transition(name));
        let pull = |t| Ok(self.taut(Leaves::Knot, &run.pieces()[1].solution.at(t)?).tension);
        Ok(highest([from?.t, to?.t], pull)?[1])
    }

    /// The turn from this state on a string that gives, with the force `stiffness` for a stretch
    /// of its own length: its largest tension, and the same from the energy at that moment.
    pub fn softly(&self, start: &[f64; 6], stiffness: f64, step: f64) -> Result<[f64; 2]> {
        // Before the turn it is stretched already.
        let own = self.length() / (1.0 + self.taut(Leaves::Knot, start).tension / stiffness);
        let string = move |&[x, y, knot, ..]: &[f64; 6]| {
            let (s, c) = sincos(knot);
            let far = hypot(x + c, y + s);
            let pull = stiffness * (far / own - 1.0).max(0.0);
            (pull, [(x + c) / far, (y + s) / far], [c, s])
        };
        let pulled = ode(|_, y: &[f64; 6]| {
            let (pull, [ux, uy], [c, s]) = string(y);
            let spin = pull * (s * ux - c * uy) / self.shape;
            [y[3], y[4], y[5], -pull * ux, -pull * uy - 1.0, spin]
        })
        .scaled(size_or([1.0; 6]));
        let along = |_, y: &[f64; 6]| {
            let (_, u, arm) = string(y);
            u[0] * arm[0] + u[1] * arm[1]
        };
        let winds = Event::rising("winds", along).terminal();
        let over = Dop853::new(step)?.solve(&pulled, 0.0, start, 1e5, &[winds])?;
        let [when, peak] = highest([0.0, over.end_time()], |t| Ok(string(&over.at(t)?).0))?;
        let first = self.energy(start) + 0.5 * own * string(start).0 * string(start).0 / stiffness;
        let stored = first - self.energy(&over.at(when)?);
        Ok([peak, (2.0 * stored.max(0.0) * stiffness / own).sqrt()])
    }

    /// What follows the unwinding, by Lagrange's equations in the angle of the string and the
    /// angle of the knot, then in the angle and the length of the string: the time of the turn, the
    /// largest tension, the length that is wound up again, and the time this takes.
    pub fn by_angles(&self, step: f64) -> Result<[f64; 4]> {
        let (k, l, method) = (self.shape, self.length(), Dop853::new(step)?);
        let knot = move |[string, knot, rate, turns]: &[f64; 4]| {
            let ((s, c), delta) = (sincos(string - knot), string - knot);
            let a = -turns * turns * c - sin(*string);
            let b = l * rate * rate * c + cos(*knot);
            let faster = (b + a * s) / (k + c * c);
            let pull = cos(*string) + l * rate * rate - faster * c - turns * turns * sin(delta);
            ([*rate, *turns, (a + faster * s) / l, faster], pull)
        };
        let spin = (2.0 * self.wound / (1.0 + k)).sqrt();
        let winds = Event::rising("winds", |_, y: &[f64; 4]| sin(y[0] - y[1])).terminal();
        let turn = ode(|_, y: &[f64; 4]| knot(y).0).scaled(size_or([1.0; 4]));
        let over = method.solve(&turn, 0.0, &[0.0, 0.0, 0.0, spin], 1e5, &[winds])?;
        let peak = highest([0.0, over.end_time()], |t| Ok(knot(&over.at(t)?).1))?[1];
        let [string, _, rate, turns] = *over.end_state();
        let reel = ode(move |_, &[angle, rate, s, turns]: &[f64; 4]| {
            let ((sine, cosine), out) = (sincos(angle), rate - turns);
            let swing = (s * rate * rate - s * sine - 2.0 * s * out * rate) / (s * s);
            [rate, swing, out, -(s * rate * rate + cosine) / (1.0 + k)]
        })
        .scaled(size_or([1.0; 4]));
        let (up, _) = method.zero(&reel, [string, rate, l, turns], 1, 1e5, |y| y[3] - y[1])?;
        Ok([over.end_time(), peak, l - up.state[2], up.t])
    }
}

/// The turn over the knot on a string so long that it stays vertical, to its lowest point: the
/// tension there, and twice the time. The state: the angle of the knot, and its rate.
pub fn long_string(shape: f64, wound: f64, step: f64) -> Result<[f64; 2]> {
    let turn = ode(move |_, &[angle, rate]: &[f64; 2]| {
        let (s, c) = sincos(angle);
        [rate, c * (1.0 + s * rate * rate) / (c * c + shape)]
    })
    .scaled(size_or([1.0; 2]));
    let start = [0.0, (2.0 * wound / (1.0 + shape)).sqrt()];
    let (lowest, _) = Dop853::new(step)?.zero(&turn, start, 1, 1e5, |y| y[0] - FRAC_PI_2)?;
    Ok([1.0 + lowest.state[1] * lowest.state[1], 2.0 * lowest.t])
}

/// The highest value of a function in this span, and where: the best of 100 points, then the
/// golden section.
pub fn highest([from, to]: [f64; 2], f: impl Fn(f64) -> Result<f64>) -> Result<[f64; 2]> {
    let (step, mut best) = ((to - from) / 100.0, [from, f(from)?]);
    for t in times(from, to, 100) {
        let value = f(t)?;
        best = if value > best[1] { [t, value] } else { best };
    }
    let (mut from, mut to) = ((best[0] - step).max(from), (best[0] + step).min(to));
    let part = 0.5 * (5.0_f64.sqrt() - 1.0);
    for _ in 0..50 {
        let (a, b) = (to - part * (to - from), from + part * (to - from));
        if f(a)? > f(b)? { to = b } else { from = a }
    }
    let t = 0.5 * (from + to);
    Ok([t, f(t)?])
}
