//! Explicit Runge-Kutta methods with fixed step: one loop for every tableau.

use super::compensated::Compensated;
use super::ode::{check_span, finite_derivative};
use super::{Ode, Work};
use crate::error::{Error, Result};

/// The nonzero weights of a linear combination of stages: (index, weight).
pub(super) type Weights = &'static [(usize, f64)];

/// The coefficients of an explicit Runge-Kutta method with `S` stages.
///
/// Stage i is k_i = f(t + c_i h, y + h sum_j a_ij k_j) with j < i, and the step
/// is y + h sum_i b_i k_i.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tableau<const S: usize> {
    /// Times of the stages, as fractions of the step.
    pub c: [f64; S],
    /// Weights of the earlier stages in each stage.
    pub a: [Weights; S],
    /// Weights of the stages in the step; their sum is 1 (the first is never used:
    /// it is what the others leave).
    pub b: Weights,
}

/// h sum_j w_j k_j, for weights whose sum is 1.
///
/// Written as h (k_0 + sum_j w_j (k_j - k_0)): the sum is 1 exactly and not to
/// the rounding of the weights, and round-off acts on differences, which are
/// small. A constant derivative is integrated without error.
#[inline(always)]
pub(super) fn mean_increment<const N: usize>(h: f64, weights: Weights, k: &[[f64; N]]) -> [f64; N] {
    let first = k[0];
    let mut sum = [0.0; N];
    for &(j, w) in weights {
        for i in 0..N {
            sum[i] += w * (k[j][i] - first[i]);
        }
    }
    for i in 0..N {
        sum[i] = h * (first[i] + sum[i]);
    }
    sum
}

/// sum_j w_j k_j.
#[inline(always)]
pub(super) fn combination<const N: usize>(weights: Weights, k: &[[f64; N]]) -> [f64; N] {
    let mut sum = [0.0; N];
    for &(j, w) in weights {
        for i in 0..N {
            sum[i] += w * k[j][i];
        }
    }
    sum
}

/// h sum_j w_j k_j.
#[inline(always)]
pub(super) fn increment<const N: usize>(h: f64, weights: Weights, k: &[[f64; N]]) -> [f64; N] {
    combination(weights, k).map(|s| h * s)
}

/// y + h sum_j w_j k_j.
#[inline(always)]
pub(super) fn stage<const N: usize>(
    y: &[f64; N],
    h: f64,
    weights: Weights,
    k: &[[f64; N]],
) -> [f64; N] {
    let mut out = increment(h, weights, k);
    for i in 0..N {
        out[i] += y[i];
    }
    out
}

/// Step k of n from `t` to `t_end` starts here; the last one ends at `t_end` exactly.
#[inline]
pub(super) fn node(t: f64, t_end: f64, k: u64, n: u64) -> f64 {
    t + (t_end - t) * (k as f64 / n as f64)
}

impl<const S: usize> Tableau<S> {
    /// Carries `start` from `t` to `t_end` in `steps` equal steps.
    ///
    /// Sums are compensated. Errors: a time or state that is not finite; a
    /// derivative that is not finite, with the time and state where it was met.
    pub fn advance<const N: usize>(
        &self,
        ode: &(impl Ode<N> + ?Sized),
        t: f64,
        start: &[f64; N],
        t_end: f64,
        steps: u64,
    ) -> Result<([f64; N], Work)> {
        check_span(t, start, t_end)?;
        if steps == 0 {
            return Err(no_steps());
        }
        let mut work = Work::default();
        if t == t_end {
            return Ok((*start, work));
        }
        let h = (t_end - t) / steps as f64;
        let mut y = Compensated::new(*start);
        let mut k = [[0.0; N]; S];
        for step in 0..steps {
            let now = node(t, t_end, step, steps);
            for i in 0..S {
                let at = now + self.c[i] * h;
                let y_i = stage(&y.value, h, self.a[i], &k);
                k[i] = finite_derivative(at, &y_i, ode.derivative(at, &y_i))?;
            }
            y = y.plus(&mean_increment(h, self.b, &k));
        }
        work.steps = steps;
        work.derivatives = steps * S as u64;
        Ok((y.value, work))
    }
}

/// The error of asking for no steps at all.
pub(super) fn no_steps() -> Error {
    Error::out_of_range("steps", 0.0, "at least 1 step")
}
