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

mod bodies;
pub mod coefficients;

pub use bodies::FreeRotation;

use super::compensated::Compensated;
use super::explicit::{no_steps, node};
use super::ode::{check_span, finite_derivative};
use super::{About, Integrator, Ode, Work};
use crate::error::{Error, Result};
use crate::math::EPS;
use coefficients::{CONTINUATION, NODES, STAGES, STAGES_REST, WEIGHTS, WEIGHTS_REST};

/// One number for each of the eight stages.
pub type Lanes = [f64; 8];

/// A system y' = f(t, y) evaluated at eight times and states at once.
///
/// Write the formulas on whole lanes with plain `+ - * /` and mark the method
/// `#[inline(always)]`: it is compiled once for every kind of processor.
pub trait StageOde<const N: usize> {
    /// f(t, y), lane by lane.
    fn derivatives(&self, t: &Lanes, y: &[Lanes; N]) -> [Lanes; N];

    /// The size against which an error in each component counts, as in
    /// [`Ode::scale`]: asked for at the start of a run. Each must be positive.
    fn scale(&self, y: &[f64; N]) -> [f64; N] {
        y.map(|c| c.abs().max(1.0))
    }
}

/// Any [`Ode`] as a [`StageOde`], one lane after the other: the same bits as a
/// form written on lanes.
///
/// Without branches in its formulas the compiler often finds the lanes itself.
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

    fn scale(&self, y: &[f64; N]) -> [f64; N] {
        self.0.scale(y)
    }
}

/// The Gauss-Legendre method of order 16 with equal steps.
///
/// A step solves Y_i = y + h sum_j a_ij f(t + c_j h, Y_j) by sweeps: all eight
/// slopes are evaluated at once, new stages are formed, and so on. Each sweep
/// gains by a factor near h/2 times the Lipschitz constant of f. The sweeps end
/// when what is still missing (the last change times the last gain) is below
/// the precision, or when round-off lets nothing be gained.
///
/// Accuracy, as measured against the closed forms: a tumbling body ([`FreeRotation`])
/// after 1000 periods of its rates, and the notes' top (16.2, fig. 3, [`SpinFree`])
/// after 2000 time units; a sweep is eight derivatives at once:
///
/// | tumbling: steps a period | sweeps a step | error (rad) | top: time a step | sweeps a step | error (rad) |
/// |---|---|---|---|---|---|
/// | 6 | 17.2 | 1.1e-8 | 2 | 22.5 | 5.2e-8 |
/// | 7 | 15.8 | 9.7e-10 | 1.33 | 16.2 | 1.1e-10 |
/// | 8 | 14.8 | 1.2e-10 | 1 | 13.5 | 1.5e-12 |
/// | 10 | 13.1 | 7.3e-13 | | | |
///
/// Over 1e5 steps the energy stays within 3.5e-14, |L| within 2.0e-14 and the length
/// of the quaternion within 1.6e-14 of their first values; L_Z of the top is kept
/// exactly. Longer steps than 4 a period do not pay: the sweeps gain too little, and
/// at 3 a period they diverge ([`Error::NoConvergence`]).
///
/// [`SpinFree`]: crate::integrators::SpinFree
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GaussLegendre {
    steps: u64,
    precision: f64,
    wide: bool,
}

/// More sweeps than any contracting step needs.
const MOST_SWEEPS: u32 = 60;

/// Changes below this, relative to the scale, may be nothing but round-off.
const ROUND_OFF: f64 = 1e-12;

impl GaussLegendre {
    const ABOUT: About = About {
        name: "Gauss-Legendre 16",
        order: 16,
        source: "J. C. Butcher, Math. Comp. 18, 50 (1964)",
    };

    /// The method with this many equal steps over the whole run, stages solved to round-off.
    ///
    /// Errors: no steps.
    pub fn new(steps: u64) -> Result<Self> {
        Self::with_precision(steps, 0.0)
    }

    /// The same with the stages of each step solved to `precision` (0: to
    /// round-off), relative to the scale of the state: a run that needs nine
    /// digits need not sweep for 16. What the steps leave adds up over the run.
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
        Ok(Self {
            steps,
            precision: precision.max(0.5 * EPS),
            wide: true,
        })
    }

    /// The same in the registers that every processor of its kind has: slower,
    /// and the same bits. For those who want to see that.
    pub const fn in_narrow_registers(self) -> Self {
        Self {
            wide: false,
            ..self
        }
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
            if self.wide && std::is_x86_feature_detected!("avx512f") {
                // SAFETY: the processor has the feature, as just detected.
                return unsafe { self.run_avx512(ode, t, start, t_end) };
            }
            if self.wide && std::is_x86_feature_detected!("avx2") {
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
        let mut y = Compensated::new(*start);
        let h = (t_end - t) / self.steps as f64;
        // At rest the scale may be the least number there is: no 0 times infinity.
        let weight = ode.scale(start).map(|s| (h.abs() / s).min(f64::MAX));
        let mut slopes = ode.derivatives(&[t; 8], &start.map(|c| [c; 8]));
        finite_derivative(t, start, slopes.map(|s| s[0]))?;
        let mut work = Work {
            derivatives: 8,
            ..Work::default()
        };
        for step in 0..self.steps {
            let here = node(t, t_end, step, self.steps);
            if step > 0 {
                slopes = slopes.map(|s| combination(&CONTINUATION, &s, [0.0; 8]));
            }
            let sweeps = self.solve(ode, here, h, &y.value, &weight, &mut slopes)?;
            work.derivatives += 8 * u64::from(sweeps);
            let mut increment = [0.0; N];
            for i in 0..N {
                increment[i] = h * weighted_mean(&slopes[i]);
            }
            y = y.plus(&increment);
            work.steps += 1;
        }
        Ok((y.value, work))
    }

    /// Solves the stages of the step from `y` at `t`; the number of sweeps.
    #[inline(always)]
    fn solve<const N: usize, O: StageOde<N>>(
        &self,
        ode: &O,
        t: f64,
        h: f64,
        y: &[f64; N],
        weight: &[f64; N],
        slopes: &mut [Lanes; N],
    ) -> Result<u32> {
        let times = NODES.map(|c| t + c * h);
        // So small that the slopes the sweeps begin with are good enough for it.
        let rest = slopes.map(|s| combination(&STAGES_REST, &s, [0.0; 8]));
        let mut before = f64::INFINITY;
        for sweep in 1..=MOST_SWEEPS {
            let mut stages = [[0.0; 8]; N];
            for i in 0..N {
                let sum = combination(&STAGES, &slopes[i], rest[i]);
                for lane in 0..8 {
                    stages[i][lane] = y[i] + h * sum[lane];
                }
            }
            let new = ode.derivatives(&times, &stages);
            let change = largest_change(&new, slopes, weight);
            *slopes = new;
            // The change is what the old slopes lacked; the new ones lack less, by
            // the gain. Positive conditions: a NaN must not count as converged.
            let gain = (change / before).min(1.0);
            let missing = if sweep > 1 { gain * change } else { change };
            if missing <= self.precision || (change >= before && change <= ROUND_OFF) {
                return Ok(sweep);
            }
            if !change.is_finite() || (sweep == MOST_SWEEPS && change > ROUND_OFF) {
                break;
            }
            if sweep == MOST_SWEEPS {
                return Ok(sweep);
            }
            before = change;
        }
        Err(Error::NoConvergence {
            t,
            h,
            change: before,
        })
    }
}

/// first + sum_j column_j x_j.
#[inline(always)]
fn combination(columns: &[Lanes; 8], x: &Lanes, first: Lanes) -> Lanes {
    let mut sum = first;
    for (column, factor) in columns.iter().zip(x) {
        for lane in 0..8 {
            sum[lane] += column[lane] * factor;
        }
    }
    sum
}

/// The largest weighted difference between two sets of slopes.
#[inline(always)]
fn largest_change<const N: usize>(new: &[Lanes; N], old: &[Lanes; N], weight: &[f64; N]) -> f64 {
    // Unlike `f64::max` it keeps a NaN, on either side.
    let larger = |a: f64, b: f64| if a > b || a.is_nan() { a } else { b };
    let mut largest = [0.0_f64; 8];
    for i in 0..N {
        for lane in 0..8 {
            let change = weight[i] * (new[i][lane] - old[i][lane]).abs();
            largest[lane] = larger(change, largest[lane]);
        }
    }
    largest.into_iter().fold(0.0, |all, c| larger(c, all))
}

/// sum_j b_j x_j with weights whose sum is 1 exactly: x_0 + sum_j b_j (x_j - x_0).
#[inline(always)]
fn weighted_mean(x: &Lanes) -> f64 {
    let mut sum = 0.0;
    for j in 1..8 {
        sum += WEIGHTS_REST[j] * (x[j] - x[0]);
    }
    for j in 1..8 {
        sum += WEIGHTS[j] * (x[j] - x[0]);
    }
    x[0] + sum
}

impl<const N: usize, O: StageOde<N>> Integrator<O, [f64; N]> for GaussLegendre {
    fn about(&self) -> About {
        Self::ABOUT
    }

    fn advance(&self, ode: &O, t: f64, start: &[f64; N], t_end: f64) -> Result<([f64; N], Work)> {
        check_span(t, start, t_end)?;
        if t == t_end {
            return Ok((*start, Work::default()));
        }
        self.run(ode, t, start, t_end)
    }
}
