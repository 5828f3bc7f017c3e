//! The loop that chooses the steps.

use super::Dop853;
use super::system::System;
use super::trial::{Trial, sizes};
use crate::error::{Error, Result};
use crate::integrators::Work;
use crate::integrators::compensated::Compensated;
use crate::integrators::ode::{check_span, finite_derivative};
use crate::math::{EPS, exp, log};
use core::ops::ControlFlow;

/// Aim at this part of the step that the error estimate allows.
const SAFETY: f64 = 0.9;
/// The step shrinks at most by this factor at once, and grows at most by the other.
const SHRINK: f64 = 0.333;
const GROW: f64 = 6.0;
/// Weight of the last error in the choice of the next step (PI control).
const MEMORY: f64 = 0.04;
/// An error below this is remembered as this.
const LEAST: f64 = 1e-4;
/// The drift that is left where it is, in errors of a step.
const DRIFT: f64 = 0.1;
/// A run whose steps are all shorter than this many roundings of the time has too coarse a clock:
/// near a pole they shrink to that from longer ones (`tests/traps/messages.rs`).
const COARSE: f64 = 1e5;
/// Exponent of the present error: 1/8, less what the memory takes.
const RESPONSE: f64 = 0.125 - 0.75 * MEMORY;

/// The decision after an accepted step: go on, or end with this state.
type Verdict<const N: usize> = ControlFlow<[f64; N]>;

/// The observer of every accepted step, with the derivative at its end.
type Accepted<'a, const N: usize> =
    &'a mut dyn FnMut(&Trial<N>, [f64; N], &mut Work) -> Result<Verdict<N>>;

impl Dop853 {
    /// Carries `start` from `t` to `t_end`; `accepted` sees every accepted step
    /// with the derivative at its end and may stop the run. With the end comes the length of a
    /// step that is as good as the last. Its work, from none, is in `work` also if it fails.
    pub(super) fn drive<const N: usize>(
        &self,
        ode: &dyn System<N>,
        t: f64,
        start: &[f64; N],
        t_end: f64,
        work: &mut Work,
        accepted: Accepted<'_, N>,
    ) -> Result<([f64; N], f64)> {
        check_span(t, start, t_end)?;
        if t == t_end {
            return Ok((*start, 0.0));
        }
        let direction = 1f64.copysign(t_end - t);
        work.derivatives += 1;
        let first = finite_derivative(t, start, ode.derivative(t, start))?;
        let mut h = if self.first_step > 0.0 {
            self.first_step
        } else {
            self.find_first_step(ode, t, start, &first, t_end, work)?
        };
        let mut trial = Trial::new(t, *start, first, DRIFT * self.tolerance);
        // Of the last error, for the choice of the next step: a power of it by its logarithm takes
        // less than half the time.
        let least = log(LEAST);
        let mut memory = least;
        let mut after_rejection = false;
        let mut longest = 0.0_f64;
        let underflow = |t: f64, step: f64, longest: f64, y: &Compensated<N>| {
            // Where the clock is too coarse all steps are near what it shows.
            let coarse = longest.max(step) < COARSE * EPS * t.abs();
            Error::StepUnderflow {
                t,
                step,
                clock: coarse.then(|| t.abs().next_up() - t.abs()),
                state: y.value.to_vec(),
            }
        };
        // A step that the clock does not show, or with no digits of its own.
        let vanishes = |t: f64, h: f64| t + direction * h == t || h < 4.0 * EPS * t.abs();
        loop {
            let t = trial.t;
            if work.steps + work.rejected >= self.step_limit {
                return Err(Error::LimitReached {
                    what: "steps",
                    t,
                    t_end,
                    limit: self.step_limit,
                });
            }
            h = h.min(self.longest_step);
            // A rest of less than 1 % of a step is not left over.
            let last = 1.01 * h >= (t_end - t) * direction;
            let to = if last { t_end } else { t + direction * h };
            // In a step of no length an event would divide by it.
            if to == t {
                return Err(underflow(t, h, longest, &trial.start));
            }
            // The step the clock really makes: t + h was rounded.
            let made = (to - t) * direction;
            longest = longest.max(made);
            let tried = trial.step_to(ode, to, work);
            let error = match &tried {
                Ok(()) => trial.error(ode, self.tolerance)?,
                Err(_) => f64::INFINITY,
            };
            if error <= 1.0 {
                let first = trial.last(ode, work)?;
                work.steps += 1;
                if let ControlFlow::Break(end) = accepted(&trial, first, work)? {
                    return Ok((end, made));
                }
                let now = log(error);
                let change = SAFETY * exp(MEMORY * memory - RESPONSE * now);
                let change = change.clamp(SHRINK, if after_rejection { 1.0 } else { GROW });
                h = made * change;
                if last {
                    return Ok((trial.end.value, h));
                }
                trial.go_on(first);
                memory = now.max(least);
                after_rejection = false;
                if vanishes(to, h) {
                    return Err(underflow(to, h, longest, &trial.start));
                }
            } else {
                work.rejected += 1;
                let change = if error.is_finite() {
                    (SAFETY * exp(-RESPONSE * log(error))).max(SHRINK)
                } else {
                    SHRINK
                };
                h = made * change;
                after_rejection = true;
                // Rounded by the clock, a shorter step may be the same again.
                if vanishes(t, h) || t + direction * h == to {
                    tried?;
                    return Err(underflow(t, h, longest, &trial.start));
                }
            }
        }
    }

    /// A first step whose error should be near the tolerance (Hairer, Nørsett,
    /// Wanner I, II.4, starting step size).
    fn find_first_step<const N: usize>(
        &self,
        ode: &dyn System<N>,
        t: f64,
        y: &[f64; N],
        first: &[f64; N],
        t_end: f64,
        work: &mut Work,
    ) -> Result<f64> {
        let size = sizes(ode, y)?;
        let norm = |v: &[f64; N]| {
            let sum: f64 = (0..N).map(|i| (v[i] / size[i]) * (v[i] / size[i])).sum();
            if sum.is_finite() {
                return (sum / N as f64).sqrt();
            }
            // Squares that overflow.
            (0..N).fold(0.0, |most: f64, i| most.max((v[i] / size[i]).abs()))
        };
        let span = (t_end - t).abs();
        let (n0, n1) = (norm(y), norm(first));
        let guess = if n0 > 1e-10 && n1 > 1e-10 { 0.01 * n0 / n1 } else { 1e-3 * span };
        let guess = guess.min(span).min(self.longest_step);
        let h = guess.copysign(t_end - t);
        let mut euler = *y;
        for i in 0..N {
            euler[i] += h * first[i];
        }
        work.derivatives += 1;
        let second = ode.derivative(t + h, &euler);
        let mut curve = [0.0; N];
        for i in 0..N {
            curve[i] = (second[i] - first[i]) / guess;
        }
        // Per unit time: how fast the state changes, and how fast its rate does.
        let rate = n1.max(norm(&curve).sqrt());
        let step = exp(0.125 * log(0.01 * self.tolerance)) / rate;
        let step = if step > 0.0 { step } else { guess };
        Ok(step.min(100.0 * guess).min(span))
    }
}
