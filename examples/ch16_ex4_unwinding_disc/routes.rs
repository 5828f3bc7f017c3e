//! The other routes: the turn on a string that gives, Lagrange's equations in angles, and a string
//! so long that it stays vertical.

use super::physics::*;
use core::f64::consts::FRAC_PI_2;
use kit::times;
use rotation_dynamics::Result;
use rotation_dynamics::integrators::{Dop853, Event, Solution, ode, size_or};
use rotation_dynamics::math::{cos, hypot, sin, sincos};
use rotation_dynamics::planar::Run;

impl Disc {
    /// Energy of a state, from the hook.
    pub fn energy(&self, &[_, y, _, vx, vy, rate]: &[f64; 6]) -> f64 {
        0.5 * (vx * vx + vy * vy + self.shape * rate * rate) + y
    }

    /// The largest tension on the knot.
    pub fn peak(&self, run: &Run<Leaves, 6>) -> Result<f64> {
        let [from, to] = ["all unwound", "winds up"].map(|name| run.transition(name));
        let turn = &run.pieces()[1].solution;
        let pull = |t| Ok(self.taut(Leaves::Knot, &turn.at(t)?).tension);
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
        let along = |y: &[f64; 6]| {
            let (_, u, arm) = string(y);
            u[0] * arm[0] + u[1] * arm[1]
        };
        let winds = Event::rising("winds", |_, y| along(y)).terminal();
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
        let top = Event::falling("top", |_, y: &[f64; 4]| y[3] - y[1]).terminal();
        let up = method.solve(&reel, 0.0, &[string, rate, l, turns], 1e5, &[top])?;
        let climb = l - up.end_state()[2];
        Ok([over.end_time(), peak, climb, up.end_time()])
    }
}

/// The turn over the knot on a string so long that it stays vertical, to its lowest point: the
/// tension there, and twice the time. The state: the angle of the knot, and its rate.
pub fn long_string(shape: f64, wound: f64, step: f64) -> Result<[f64; 2]> {
    let faster = move |angle: f64, rate: f64| {
        let (s, c) = sincos(angle);
        c * (1.0 + s * rate * rate) / (c * c + shape)
    };
    let start = [0.0, (2.0 * wound / (1.0 + shape)).sqrt()];
    let lowest = Event::rising("lowest", |_, y: &[f64; 2]| y[0] - FRAC_PI_2).terminal();
    let turn = ode(|_, y: &[f64; 2]| [y[1], faster(y[0], y[1])]).scaled(size_or([1.0; 2]));
    let turned: Solution<2> = Dop853::new(step)?.solve(&turn, 0.0, &start, 1e5, &[lowest])?;
    let rate = turned.end_state()[1];
    Ok([1.0 + rate * rate, 2.0 * turned.end_time()])
}

/// The highest value of a function in this span, and where: the best of 100 points, then the
/// golden section.
pub fn highest([from, to]: [f64; 2], f: impl Fn(f64) -> Result<f64>) -> Result<[f64; 2]> {
    let (step, mut best) = ((to - from) / 100.0, [from, f(from)?]);
    for t in times(from, to, 100) {
        let value = f(t)?;
        if value > best[1] {
            best = [t, value];
        }
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
