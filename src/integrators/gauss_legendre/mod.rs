//! The Gauss-Legendre method with eight stages: order 16, symplectic, symmetric.
//!
//! Implicit, and still the fastest way to step smooth rotation to many digits:
//! its eight stages are evaluated side by side in the lanes of a vector register,
//! the stage equations are solved by a few sweeps that begin at the previous
//! step's polynomial, and a step spans a good part of a revolution.
//!
//! Lanes do what scalar code would do, in its order and without contraction, so
//! the bits do not depend on what the processor has.
//!
//! Not for: systems with jumps inside a step, or stiff ones (the sweeps would
//! not contract; [`Error::NoConvergence`] says so).
//!
//! Sources: J. C. Butcher, Math. Comp. 18, 50 (1964); E. Hairer, R. I. McLachlan,
//! A. Razakarivony, BIT 48, 231 (2008) for round-off in implicit methods.

mod coefficients;

use super::compensated::Compensated;
use super::explicit::{no_steps, node};
use super::ode::check_span;
use super::{About, Integrator, Ode, Work};
use crate::error::{Error, Result};
use coefficients::{CONTINUATION, NODES, STAGES, WEIGHTS};

/// One number for each of the eight stages.
pub type Lanes = [f64; 8];

/// A system y' = f(t, y) evaluated at eight times and states at once.
///
/// Write the formulas on whole lanes with plain `+ - * /` and mark the method
/// `#[inline(always)]`: it is compiled once for every kind of processor.
pub trait StageOde<const N: usize> {
    /// f(t, y), lane by lane.
    fn derivatives(&self, t: &Lanes, y: &[Lanes; N]) -> [Lanes; N];
}

/// Any [`Ode`] as a [`StageOde`], one lane after the other: same bits, less speed.
#[derive(Debug, Clone, Copy)]
pub struct LaneByLane<O>(pub O);

impl<const N: usize, O: Ode<N>> StageOde<N> for LaneByLane<O> {
    #[inline(always)]
    fn derivatives(&self, t: &Lanes, y: &[Lanes; N]) -> [Lanes; N] {
        let mut out = [[0.0; 8]; N];
        for lane in 0..8 {
            let derivative = self.0.derivative(t[lane], &y.map(|c| c[lane]));
            for i in 0..N {
                out[i][lane] = derivative[i];
            }
        }
        out
    }
}

/// The Gauss-Legendre method of order 16 with equal steps.
///
/// The sweeps of a step end when a sweep changes no stage by more than
/// `precision` of the state's scale, or when they no longer gain.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GaussLegendre {
    steps: u64,
    precision: f64,
}

/// More sweeps than any contracting step needs.
const MOST_SWEEPS: u32 = 60;

impl GaussLegendre {
    /// The method with this many equal steps over the whole run, stages solved to round-off.
    ///
    /// Errors: no steps.
    pub fn new(steps: u64) -> Result<Self> {
        Self::with_precision(steps, 0.0)
    }

    /// The same with the stages solved to `precision` (0: to round-off), relative to
    /// the scale of the state: a run that needs nine digits need not sweep for 16.
    ///
    /// Errors: no steps; a precision outside [0, 0.1].
    pub fn with_precision(steps: u64, precision: f64) -> Result<Self> {
        if steps == 0 {
            return Err(no_steps());
        }
        if !(0.0..=0.1).contains(&precision) {
            return Err(Error::OutOfRange {
                name: "precision",
                value: precision,
                allowed: "it must lie between 0 and 0.1",
            });
        }
        Ok(Self { steps, precision })
    }

    /// Every step, in the widest registers that the processor has.
    fn run<const N: usize, O: StageOde<N>>(
        &self,
        ode: &O,
        t: f64,
        start: &[f64; N],
        t_end: f64,
    ) -> Result<([f64; N], Work)> {
        #[cfg(target_arch = "x86_64")]
        {
            if std::is_x86_feature_detected!("avx512f") {
                // SAFETY: the processor has the feature, as just detected.
                return unsafe { self.run_avx512(ode, t, start, t_end) };
            }
            if std::is_x86_feature_detected!("avx2") {
                // SAFETY: the processor has the feature, as just detected.
                return unsafe { self.run_avx2(ode, t, start, t_end) };
            }
        }
        self.run_here(ode, t, start, t_end)
    }

    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx512f")]
    fn run_avx512<const N: usize, O: StageOde<N>>(
        &self,
        ode: &O,
        t: f64,
        start: &[f64; N],
        t_end: f64,
    ) -> Result<([f64; N], Work)> {
        self.run_here(ode, t, start, t_end)
    }

    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx2")]
    fn run_avx2<const N: usize, O: StageOde<N>>(
        &self,
        ode: &O,
        t: f64,
        start: &[f64; N],
        t_end: f64,
    ) -> Result<([f64; N], Work)> {
        self.run_here(ode, t, start, t_end)
    }

    #[inline(always)]
    fn run_here<const N: usize, O: StageOde<N>>(
        &self,
        ode: &O,
        t: f64,
        start: &[f64; N],
        t_end: f64,
    ) -> Result<([f64; N], Work)> {
        let mut work = Work::default();
        let mut y = Compensated::new(*start);
        let h = (t_end - t) / self.steps as f64;
        let scale = start.iter().fold(0.0_f64, |m, c| m.max(c.abs()));
        let mut slopes = ode.derivatives(&[t; 8], &start.map(|c| [c; 8]));
        work.derivatives += 8;
        let mut begun = false;
        for k in 0..self.steps {
            let here = node(t, t_end, k, self.steps);
            let times = NODES.map(|c| here + c * h);
            if begun {
                slopes = slopes.map(|s| combination(&CONTINUATION, &s));
            }
            begun = true;
            let mut before = f64::INFINITY;
            for sweep in 1.. {
                let mut stages = [[0.0; 8]; N];
                for i in 0..N {
                    let sum = combination(&STAGES, &slopes[i]);
                    for lane in 0..8 {
                        stages[i][lane] = y.value[i] + h * sum[lane];
                    }
                }
                let new = ode.derivatives(&times, &stages);
                work.derivatives += 8;
                let change = h.abs() * largest_change(&new, &slopes);
                slopes = new;
                // A positive condition first: a NaN must not count as converged.
                if change <= self.precision * scale {
                    break;
                }
                if change >= before && change <= 1e-12 * scale {
                    break; // round-off: no further sweep gains
                }
                if !change.is_finite() || sweep == MOST_SWEEPS {
                    return Err(Error::NoConvergence { t: here, h, change });
                }
                before = change;
            }
            let mut increment = [0.0; N];
            for i in 0..N {
                increment[i] = h * weighted_mean(&slopes[i]);
            }
            y = y.plus(&increment);
            work.steps += 1;
        }
        Ok((y.value, work))
    }
}

/// sum_j column_j x_j.
#[inline(always)]
fn combination(columns: &[Lanes; 8], x: &Lanes) -> Lanes {
    let mut sum = [0.0; 8];
    for (column, factor) in columns.iter().zip(x) {
        for lane in 0..8 {
            sum[lane] += column[lane] * factor;
        }
    }
    sum
}

/// The largest difference between two sets of slopes.
#[inline(always)]
fn largest_change<const N: usize>(new: &[Lanes; N], old: &[Lanes; N]) -> f64 {
    let mut largest = [0.0_f64; 8];
    for i in 0..N {
        for lane in 0..8 {
            let change = (new[i][lane] - old[i][lane]).abs();
            // `max` would drop a NaN.
            if !(change <= largest[lane]) {
                largest[lane] = change;
            }
        }
    }
    let mut all = 0.0;
    for change in largest {
        if !(change <= all) {
            all = change;
        }
    }
    all
}

/// sum_j b_j x_j with weights whose sum is 1 exactly: x_0 + sum_j b_j (x_j - x_0).
#[inline(always)]
fn weighted_mean(x: &Lanes) -> f64 {
    let mut sum = 0.0;
    for j in 1..8 {
        sum += WEIGHTS[j] * (x[j] - x[0]);
    }
    x[0] + sum
}

impl<const N: usize, O: StageOde<N>> Integrator<O, [f64; N]> for GaussLegendre {
    fn about(&self) -> About {
        About {
            name: "Gauss-Legendre 16",
            order: 16,
            source: "J. C. Butcher, Math. Comp. 18, 50 (1964)",
        }
    }

    fn advance(&self, ode: &O, t: f64, start: &[f64; N], t_end: f64) -> Result<([f64; N], Work)> {
        check_span(t, start, t_end)?;
        if t == t_end {
            return Ok((*start, Work::default()));
        }
        self.run(ode, t, start, t_end)
    }
}
