//! A spinning satellite and its two strings, seen along the axis: Lagrange's equations in angles,
//! and Newton's law in polar coordinates. Lengths in the radius of the satellite, masses in that
//! of both weights together, times in 1/w0.

use core::f64::consts::FRAC_PI_2;
use kit::interval::at_least;
use rotation_dynamics::Result;
use rotation_dynamics::integrators::{Dop853, Event, ode, size_or};
use rotation_dynamics::math::{atan2, cos, hypot, sincos};
use rotation_dynamics::planar::{Condition, Next, Phased, Run, simulate};

/// A satellite with its strings, both of the same length.
#[derive(Debug, Clone, Copy)]
pub struct YoYo {
    /// Moment of inertia.
    pub inertia: f64,
    /// Length of a string.
    pub length: f64,
}

/// What a string does.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Hangs {
    /// It unwinds along a tangent.
    Tangent,
    /// It turns about its hook.
    Hook,
}

/// The length of string that is free at the start, since none has no direction.
const FIRST: f64 = 1e-9;

// ANCHOR: lagrange
impl YoYo {
    /// The angle from the outward direction at the hook to the string, on the hook.
    fn lean(&self, unwound: f64) -> f64 {
        unwound - self.length - FRAC_PI_2
    }

    /// The rates of the two angular velocities, from Lagrange's equations. The state: the angle of
    /// the satellite, the angle unwound or turned on the hook, the spin, and the angular velocity
    /// of the string.
    pub fn rates(&self, hangs: Hangs, &[_, unwound, spin, turns]: &[f64; 4]) -> [f64; 2] {
        let (j, l) = (self.inertia, self.length);
        match hangs {
            Hangs::Tangent => {
                let slower = -unwound * turns * turns / (j + 1.0);
                [slower, turns * (2.0 * spin - turns) / unwound]
            }
            Hangs::Hook => {
                let (s, c) = sincos(self.lean(unwound));
                let slower = s * (l * turns * turns + c * spin * spin) / (j + s * s);
                [slower, -(s * spin * spin + c * slower) / l]
            }
        }
    }
    // ANCHOR_END: lagrange

    /// The pull of each string, from the acceleration of its weight.
    pub fn tension(&self, hangs: Hangs, state: &[f64; 4]) -> f64 {
        let [_, unwound, spin, turns] = *state;
        let [slower, _] = self.rates(hangs, state);
        0.5 * match hangs {
            Hangs::Tangent => -slower * self.inertia,
            Hangs::Hook => {
                let (s, c) = sincos(self.lean(unwound));
                self.length * turns * turns + c * spin * spin - s * slower
            }
        }
    }

    /// The motion from the release of the weights to that of the strings, which let go of their
    /// hooks where they point outward.
    pub fn run(&self, step: f64) -> Result<Run<Hangs, 4>> {
        let (start, end) = ([0.0, FIRST, 1.0, 1.0], 100.0 * (1.0 + self.length));
        simulate(self, &Dop853::new(step)?, Hangs::Tangent, start, end)
    }

    /// The spin after the release.
    pub fn last_spin(&self, step: f64) -> Result<f64> {
        Ok(self.run(step)?.transition("outward")?.before[2])
    }

    /// Where a weight is, and its velocity.
    pub fn weight(&self, &[angle, unwound, spin, turns]: &[f64; 4]) -> [[f64; 2]; 2] {
        // On the tangent the point of contact runs on, but the string only unwinds there.
        let free = unwound.min(self.length);
        let (sf, cf) = sincos(angle + free);
        let (sa, ca) = sincos(angle + unwound - FRAC_PI_2);
        let across = free * turns;
        let velocity = [-spin * sf - across * sa, spin * cf + across * ca];
        [[cf + free * ca, sf + free * sa], velocity]
    }
}

impl Phased<4> for YoYo {
    type Phase = Hangs;

    fn derivative(&self, hangs: Hangs, state: &[f64; 4]) -> [f64; 4] {
        let [slower, faster] = self.rates(hangs, state);
        [state[2], state[3] - state[2], slower, faster]
    }

    fn conditions(&self, hangs: Hangs) -> Vec<Condition<'_, Hangs, 4>> {
        let left = move |end: f64| move |y: &[f64; 4]| self.length + end - y[1];
        let slack = Condition::gap("slack", move |y| self.tension(hangs, y), Next::End);
        let other = match hangs {
            Hangs::Tangent => Condition::gap("unwound", left(0.0), Next::Enter(Hangs::Hook)),
            Hangs::Hook => Condition::gap("outward", left(FRAC_PI_2), Next::End),
        };
        vec![slack, other]
    }

    fn scale(&self, y: &[f64; 4]) -> [f64; 4] {
        size_or([1.0; 4])(y)
    }
}

/// The same by Newton's law, for a weight of any mass on strings that may give.
#[derive(Debug, Clone, Copy)]
pub struct Reel {
    pub inertia: f64,
    pub weight: f64,
    pub length: f64,
    /// Force for a unit of stretch; none for strings that do not give.
    pub stiffness: Option<f64>,
}

impl Reel {
    /// What the pull of the string does: it accelerates the weight outward and across, and the
    /// satellite about its axis. The state: distance and angle of the weight, angle of the hook,
    /// and their rates.
    fn pull(&self, hangs: Hangs, &[r, at, hook, out, round, spin]: &[f64; 6]) -> [f64; 3] {
        let light = 1.0 / self.weight;
        let (free, parts, moment, needed);
        if hangs == Hangs::Tangent {
            let straight = (r * r - 1.0).max(0.0).sqrt();
            (parts, moment) = ([-straight / r, 1.0 / r], -1.0);
            free = straight + hook - at - atan2(straight, 1.0);
            let across = (out + r * round * straight) / r;
            needed = across * across / straight.max(1e-300);
        } else {
            let ((s, c), far) = (sincos(hook - at), r - cos(hook - at));
            free = (far * far + s * s).sqrt();
            (parts, moment) = ([-far / free, s / free], -r * s / free);
            let [along, over] = [out + spin * s, r * round - spin * c];
            let across = along * parts[1] - over * parts[0];
            needed = across * across / free + spin * spin * (c * -parts[0] - s * parts[1]);
        }
        let pull = match self.stiffness {
            None => needed / (light + moment * moment / self.inertia),
            Some(stiffness) => (stiffness * (free - self.length)).max(0.0),
        };
        let [out, across] = parts.map(|part| pull * part * light);
        [out, across, pull * moment / self.inertia]
    }

    /// From the release of the weight at this spin: spin, and velocity of the weight relative to
    /// the satellite across the string, where the string points outward.
    pub fn last(&self, spin: f64, step: f64) -> Result<[f64; 2]> {
        let newton = |hangs| {
            ode(move |_, y: &[f64; 6]| {
                let [out, across, slower] = self.pull(hangs, y);
                let [r, _, _, v, round, spin] = *y;
                let (out, across) = (out + r * round * round, across - 2.0 * v * round);
                [v, round, spin, out, across / r, slower]
            })
            .scaled(size_or([1.0; 6]))
        };
        // A string that gives may begin without a free part.
        let first = if self.stiffness.is_none() { 1e-4 } else { 0.0 };
        let start = [hypot(1.0, first), -atan2(first, 1.0), self.length - first, 0.0, spin, spin];
        let ahead = |&[_, at, hook, ..]: &[f64; 6]| hook - at;
        let straight = |r: f64| atan2((r * r - 1.0).max(0.0).sqrt(), 1.0);
        let left = move |_: f64, y: &[f64; 6]| ahead(y) - straight(y[0]);
        let unwound = Event::falling("unwound", left).terminal();
        let outward = Event::falling("outward", move |_, y| ahead(y)).terminal();
        let (end, method) = (100.0 * (1.0 + self.length) / spin, Dop853::new(step)?);
        let tangent = method.solve(&newton(Hangs::Tangent), 0.0, &start, end, &[unwound])?;
        let from = tangent.end_state();
        let turned = method.solve(&newton(Hangs::Hook), 0.0, from, end, &[outward])?;
        let [r, _, _, _, round, spin] = *turned.end_state();
        Ok([spin, r * round])
    }
}

/// Where a falling function is zero, by the secant with the sides kept apart.
pub fn zero([mut low, mut high]: [f64; 2], f: impl Fn(f64) -> Result<f64>) -> kit::Result<f64> {
    let (mut above, mut below, mut last) = (f(low)?, f(high)?, 0);
    let apart = -above * below;
    let parted = at_least(0.0).because("no string in between leaves the spin that is wanted");
    parted.check("spins left by a short and a long string, and their sign,", apart)?;
    for _ in 0..100 {
        let x = (low * below - high * above) / (below - above);
        let y = f(x)?;
        if y == 0.0 || (high - low).abs() < 1e-15 * high || y.abs() < 1e-15 {
            return Ok(x);
        }
        // Illinois: the end that stays counts half.
        if y > 0.0 {
            (low, above) = (x, y);
            below *= if last == 1 { 0.5 } else { 1.0 };
            last = 1;
        } else {
            (high, below) = (x, y);
            above *= if last == -1 { 0.5 } else { 1.0 };
            last = -1;
        }
    }
    Ok(0.5 * (low + high))
}
