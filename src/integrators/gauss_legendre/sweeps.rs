//! The steps of the method, and the sweeps that solve the stages of each.
//!
//! Written once over [lanes](crate::math::lane) of eight. The code inside a sweep must be inlined,
//! or it is compiled for registers that are not there: plain loops, no closures.

#[cfg(target_arch = "x86_64")]
use super::Registers;
use super::coefficients::{CONTINUATION, NODES, STAGES, STAGES_REST, WEIGHTS, WEIGHTS_REST};
use super::{GaussLegendre, Lanes, StageOde};
use crate::error::{Error, Result};
use crate::integrators::Work;
use crate::integrators::compensated::Compensated;
use crate::integrators::explicit::node;
use crate::integrators::ode::finite_derivative;
use crate::math::{DoubleDouble, Lane, ilogb, lane, ldexp};
use core::hint::black_box;

/// More sweeps than any contracting step needs.
const MOST_SWEEPS: u32 = 60;

/// Stages that need not be better than this are not solved to round-off.
const LOOSE: f64 = 1e-15;

/// The gain of the sweeps of another step is not trusted to be better.
const LEAST_GAIN: f64 = 0.1;

/// Changes below this, relative to the scale, may be nothing but round-off.
const ROUND_OFF: f64 = 1e-12;

/// The action on each step once its stages are known: a quadrature along the way.
pub(super) trait Companion<const N: usize> {
    /// The step by `h` (in two parts) led from one state through the stages to another.
    fn follow<L: Lane>(&mut self, h: [f64; 2], from: &[f64; N], stages: &[L; N], to: &[f64; N]);
}

/// Nothing is done.
impl<const N: usize> Companion<N> for () {
    #[inline(always)]
    fn follow<L: Lane>(&mut self, _: [f64; 2], _: &[f64; N], _: &[L; N], _: &[f64; N]) {}
}

/// Rows of eight numbers, placed so that none lies across two lines of the cache.
#[derive(Clone, Copy)]
#[repr(align(64))]
struct Rows<const N: usize>([Lanes; N]);

/// The stages' coefficients times the step, in two parts, and the slopes of the step before as a
/// start for the stages.
struct Tableau {
    stages: Rows<8>,
    rest: Rows<8>,
    continued: Rows<8>,
}

impl Tableau {
    fn new(h: DoubleDouble) -> Self {
        let [mut stages, mut rest, mut continued] = [Rows([[0.0; 8]; 8]); 3];
        // Between 1 and 2, where splitting a product cannot overflow.
        let unit = ldexp(1.0, ilogb(h.hi()));
        let step = h.hi() / unit;
        for j in 0..8 {
            for i in 0..8 {
                let product = DoubleDouble::product(step, STAGES[j][i]).scaled(unit);
                stages.0[j][i] = product.hi();
                rest.0[j][i] = h.hi() * STAGES_REST[j][i] + h.lo() * STAGES[j][i] + product.lo();
            }
        }
        for (continued, column) in continued.0.iter_mut().zip(&CONTINUATION) {
            for (stage, column) in stages.0.iter().zip(column) {
                for i in 0..8 {
                    continued[i] += stage[i] * column;
                }
            }
        }
        Self { stages, rest, continued }
    }
}

impl<const STEADY: bool> GaussLegendre<STEADY> {
    /// Every step, with its work added, in the widest registers that the processor has and the method may use.
    #[cfg_attr(
        target_arch = "x86_64",
        expect(unsafe_code, reason = "the features are asked for first")
    )]
    pub(super) fn run<const N: usize, O: StageOde<N>, C: Companion<N>>(
        &self,
        ode: &O,
        t: f64,
        start: Compensated<N>,
        t_end: f64,
        companion: &mut C,
        work: &mut Work,
    ) -> Result<[f64; N]> {
        #[cfg(target_arch = "x86_64")]
        {
            // A sweep of few components waits for its chain of operations, not for
            // room in the registers, and the narrower ones answer sooner.
            if const { N > 4 } {
                let wide = self.registers >= Registers::Avx512;
                if wide && lane::has_avx512() {
                    // SAFETY: the processor has the feature, as just detected.
                    return unsafe { self.run_avx512(ode, t, start, t_end, companion, work) };
                }
            }
            if self.registers >= Registers::Avx2 && lane::has_avx2() {
                // SAFETY: the processor has the feature, as just detected.
                return unsafe { self.run_avx2(ode, t, start, t_end, companion, work) };
            }
        }
        self.run_in::<lane::CommonEight, N, _, _>(ode, t, start, t_end, companion, work)
    }

    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx512f")]
    fn run_avx512<const N: usize, O: StageOde<N>, C: Companion<N>>(
        &self,
        ode: &O,
        t: f64,
        start: Compensated<N>,
        t_end: f64,
        companion: &mut C,
        work: &mut Work,
    ) -> Result<[f64; N]> {
        self.run_in::<lane::Eight, N, _, _>(ode, t, start, t_end, companion, work)
    }

    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx2")]
    fn run_avx2<const N: usize, O: StageOde<N>, C: Companion<N>>(
        &self,
        ode: &O,
        t: f64,
        start: Compensated<N>,
        t_end: f64,
        companion: &mut C,
        work: &mut Work,
    ) -> Result<[f64; N]> {
        self.run_in::<lane::FourTwice, N, _, _>(ode, t, start, t_end, companion, work)
    }

    #[inline(always)]
    fn run_in<L: Lane, const N: usize, O: StageOde<N>, C: Companion<N>>(
        &self,
        ode: &O,
        t: f64,
        start: Compensated<N>,
        t_end: f64,
        companion: &mut C,
        work: &mut Work,
    ) -> Result<[f64; N]> {
        const { assert!(L::WIDTH == 8) };
        let mut y = start;
        // The step in two parts: its rounding would stretch the time, always to one side.
        let step = DoubleDouble::sum(t_end, -t) / self.steps as f64;
        let (h, h_rest) = (step.hi(), step.lo());
        // At rest the scale may be the least number there is: no 0 times infinity.
        let weight = ode.scale(&y.value).map(|s| (h.abs() / s).min(f64::MAX));
        let mut slopes = Rows([[0.0; 8]; N]);
        let mut stages = [L::of(0.0); N];
        for (stage, value) in stages.iter_mut().zip(&y.value) {
            *stage = L::of(*value);
        }
        let first = ode.derivatives(L::of(t), &stages);
        work.derivatives += 8;
        store(&first, &mut slopes);
        finite_derivative(t, &y.value, slopes.0.map(|s| s[0]))?;
        let equations =
            Equations { tableau: Tableau::new(step), weight, precision: self.precision };
        let mut pace = Pace { sweeps: 0, gain: 1.0 };
        for step in 0..self.steps {
            let here = node(t, t_end, step, self.steps);
            let times = L::load(&NODES) * h + here;
            let solved = if STEADY && self.precision > LOOSE {
                equations.solve_loosely(ode, times, &y.value, &mut slopes, &mut stages, &mut pace)
            } else {
                equations.solve(ode, times, &y, step > 0, &mut slopes, &mut stages)
            };
            match solved {
                Ok(sweeps) => work.derivatives += 8 * u64::from(sweeps),
                Err(Stuck { sweeps, change }) => {
                    work.derivatives += 8 * u64::from(sweeps);
                    return Err(Error::NoConvergence { t: here, h, change });
                }
            }
            let from = y.value;
            for i in 0..N {
                let mean = weighted_mean::<L>(&slopes.0[i]);
                y.add(i, h * mean, h_rest * mean);
            }
            companion.follow([h, h_rest], &from, &stages, &y.value);
            work.steps += 1;
        }
        Ok(y.value)
    }
}

/// The stage equations of any step.
struct Equations<const N: usize> {
    tableau: Tableau,
    weight: [f64; N],
    precision: f64,
}

/// How many sweeps the step before took, and the gain of the last of them.
struct Pace {
    sweeps: u32,
    gain: f64,
}

/// Sweeps that do not gain, and the last change that was a number.
struct Stuck {
    sweeps: u32,
    change: f64,
}

impl<const N: usize> Equations<N> {
    /// To round-off or nearly so, from the slopes of the step before, if it is `continued`.
    #[inline(always)]
    fn solve<L: Lane, O: StageOde<N>>(
        &self,
        ode: &O,
        times: L,
        y: &Compensated<N>,
        continued: bool,
        slopes: &mut Rows<N>,
        stages: &mut [L; N],
    ) -> core::result::Result<u32, Stuck> {
        if continued {
            for i in 0..N {
                combination(&CONTINUATION, &slopes.0[i], L::of(0.0)).store(&mut slopes.0[i]);
            }
        }
        let mut before = f64::INFINITY;
        let mut sweeps = 0;
        // What is carried, and with what the coefficients' rounding leaves out: so small
        // that the slopes the sweeps begin with are good enough for it.
        let (mut first, mut rest) = ([L::of(0.0); N], [L::of(0.0); N]);
        for i in 0..N {
            first[i] = L::of(y.carry[i]);
            rest[i] = combination(&self.tableau.rest.0, &slopes.0[i], first[i]);
        }
        loop {
            put_down(slopes);
            for i in 0..N {
                stages[i] =
                    combination(&self.tableau.stages.0, &slopes.0[i], first[i]) + y.value[i];
            }
            let new = ode.derivatives(times, stages);
            let change = self.change(&new, slopes);
            store(&new, slopes);
            first = rest;
            sweeps += 1;
            // The change is what the old slopes lacked; the new ones lack less, by
            // the gain. Positive conditions: a NaN must not count as converged.
            let gain = (change / before).min(1.0);
            let missing = if sweeps > 1 { gain * change } else { change };
            if missing <= self.precision || (change >= before && change <= ROUND_OFF) {
                return Ok(sweeps);
            }
            if !change.is_finite() || (sweeps == MOST_SWEEPS && change > ROUND_OFF) {
                let change = before;
                return Err(Stuck { sweeps, change });
            }
            if sweeps == MOST_SWEEPS {
                return Ok(sweeps);
            }
            before = change;
        }
    }

    /// To no more than the precision. Terms of the order of round-off are left out, and the first
    /// sweep takes the slopes of the step before as they are. The changes are looked at only where,
    /// by the step before, the sweeps may end.
    #[inline(always)]
    fn solve_loosely<L: Lane, O: StageOde<N>>(
        &self,
        ode: &O,
        times: L,
        y: &[f64; N],
        slopes: &mut Rows<N>,
        stages: &mut [L; N],
        pace: &mut Pace,
    ) -> core::result::Result<u32, Stuck> {
        let mut before = f64::INFINITY;
        let mut sweeps = 0;
        if pace.sweeps > 0 {
            let new = new_slopes(ode, times, &self.tableau.continued, slopes, y, stages);
            store(&new, slopes);
            sweeps += 1;
        }
        loop {
            let new = new_slopes(ode, times, &self.tableau.stages, slopes, y, stages);
            sweeps += 1;
            if sweeps + 1 < pace.sweeps {
                store(&new, slopes);
                continue;
            }
            let change = self.change(&new, slopes);
            store(&new, slopes);
            // Positive conditions: a NaN must not count as converged.
            let gain = if before < f64::INFINITY {
                (change / before).min(1.0)
            } else {
                pace.gain.max(LEAST_GAIN)
            };
            let stands = change <= ROUND_OFF && (change >= before || sweeps >= MOST_SWEEPS);
            if gain * change <= self.precision || stands {
                *pace = Pace { sweeps, gain };
                return Ok(sweeps);
            }
            if !change.is_finite() || sweeps >= MOST_SWEEPS {
                let change = before;
                return Err(Stuck { sweeps, change });
            }
            before = change;
        }
    }

    /// How much new slopes differ from the old, relative to the scale: a sum, so that a NaN
    /// anywhere makes it NaN.
    #[inline(always)]
    fn change<L: Lane>(&self, new: &[L; N], old: &Rows<N>) -> f64 {
        let mut changes = L::of(0.0);
        for ((new, old), weight) in new.iter().zip(&old.0).zip(&self.weight) {
            changes = changes + (*new - L::load(old)).abs() * *weight;
        }
        changes.sum()
    }
}

/// The slopes at the stages that these columns and slopes give, and the stages.
#[inline(always)]
fn new_slopes<L: Lane, const N: usize, O: StageOde<N>>(
    ode: &O,
    times: L,
    columns: &Rows<8>,
    slopes: &mut Rows<N>,
    y: &[f64; N],
    stages: &mut [L; N],
) -> [L; N] {
    put_down(slopes);
    for i in 0..N {
        stages[i] = combination(&columns.0, &slopes.0[i], L::of(y[i]));
    }
    ode.derivatives(times, stages)
}

#[inline(always)]
fn store<L: Lane, const N: usize>(new: &[L; N], slopes: &mut Rows<N>) {
    for (new, slopes) in new.iter().zip(&mut slopes.0) {
        new.store(slopes);
    }
}

/// Each slope is multiplied by a column, in all lanes: loaded from memory that costs nothing,
/// taken out of a register it costs more than the product. The compiler would take it out of
/// the register.
#[inline(always)]
fn put_down<const N: usize>(slopes: &mut Rows<N>) {
    black_box(slopes);
}

/// first + sum_j column_j x_j, as a tree: its depth is what a sweep waits for.
#[inline(always)]
fn combination<L: Lane>(columns: &[Lanes; 8], x: &Lanes, first: L) -> L {
    let early = ((first + term::<L>(columns, x, 0)) + term::<L>(columns, x, 1))
        + (term::<L>(columns, x, 2) + term::<L>(columns, x, 3));
    let late = (term::<L>(columns, x, 4) + term::<L>(columns, x, 5))
        + (term::<L>(columns, x, 6) + term::<L>(columns, x, 7));
    early + late
}

#[inline(always)]
fn term<L: Lane>(columns: &[Lanes; 8], x: &Lanes, j: usize) -> L {
    L::load(&columns[j]) * x[j]
}

/// sum_j b_j x_j with weights whose sum is 1 exactly: x_0 + sum_j b_j (x_j - x_0).
#[inline(always)]
pub(super) fn weighted_mean<L: Lane>(x: &Lanes) -> f64 {
    let off = L::load(x) - x[0];
    x[0] + ((off * L::load(&WEIGHTS_REST)).sum() + (off * L::load(&WEIGHTS)).sum())
}
