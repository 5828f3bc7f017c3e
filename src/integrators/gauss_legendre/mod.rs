//! The Gauss-Legendre method with eight stages: order 16, symplectic, symmetric.
//!
//! Implicit, and still the fastest way to step smooth rotation to many digits. Its eight stages are
//! evaluated side by side in the lanes of a vector register. The stage equations are solved by a
//! few sweeps that begin at the previous step's polynomial, and a step spans a good part of a
//! revolution.
//!
//! Lanes do what scalar code would do, in its order and without contraction, so
//! the bits do not depend on what the processor has.
//!
//! Not for: systems with jumps inside a step, or stiff ones (the sweeps would
//! not contract; [`Error::NoConvergence`] says so).
//!
//! How it is derived: `book/src/how_gauss_legendre.md`.
//!
//! Sources: J. C. Butcher, Math. Comp. 18, 50 (1964); E. Hairer, R. I. McLachlan,
//! A. Razakarivony, BIT 48, 231 (2008) for round-off in implicit methods.

mod bodies;
pub mod coefficients;
mod free_rotation;
mod sweeps;

pub use bodies::BodyAxes;
pub(crate) use bodies::SideBySide;
pub use free_rotation::FreeRotation;
pub(super) use free_rotation::{inverse_moments, momentum_on_body, rates_of};

use super::compensated::Compensated;
use super::explicit::no_steps;
use super::ode::check_span;
use super::{Integrator, Ode, Work, advance_by_counting};
use crate::error::{Error, Result};
use crate::math::lane::WIDEST;
use crate::math::{EPS, Lane};

/// One number for each of the eight stages.
pub type Lanes = [f64; 8];

/// The registers that a run may use; it takes the best of them that there are.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Registers {
    /// The registers that every processor of its kind has.
    Common,
    /// Up to the registers of AVX2: four numbers each.
    Avx2,
    /// Up to the registers of AVX-512: eight numbers.
    Avx512,
}

/// A system y' = f(t, y) evaluated at several times and states at once.
///
/// Write the formulas over [`Lane`] with plain `+ - * /`, without closures, and mark
/// the method `#[inline(always)]`: it is compiled once for every kind of processor.
pub trait StageOde<const N: usize> {
    /// f(t, y), lane by lane. The method asks for eight lanes.
    fn derivatives<L: Lane>(&self, t: L, y: &[L; N]) -> [L; N];

    /// The size against which an error in each component counts, as in
    /// [`Ode::scale`]: asked for at the start of a run. Each must be positive.
    fn scale(&self, y: &[f64; N]) -> [f64; N];
}

/// Any [`Ode`] as a [`StageOde`], one lane after the other: the same bits as a
/// form written on lanes.
///
/// Without branches in its formulas the compiler often finds the lanes itself.
#[derive(Debug, Clone, Copy)]
pub struct LaneByLane<O>(pub O);

impl<const N: usize, O: Ode<N>> StageOde<N> for LaneByLane<O> {
    #[inline(always)]
    fn derivatives<L: Lane>(&self, t: L, y: &[L; N]) -> [L; N] {
        let mut times = [0.0; WIDEST];
        t.store(&mut times);
        let mut states = [[0.0; WIDEST]; N];
        for i in 0..N {
            y[i].store(&mut states[i]);
        }
        let mut out = [[0.0; WIDEST]; N];
        for lane in 0..L::WIDTH {
            let mut state = [0.0; N];
            for i in 0..N {
                state[i] = states[i][lane];
            }
            let derivative = self.0.derivative(times[lane], &state);
            for i in 0..N {
                out[i][lane] = derivative[i];
            }
        }
        let mut lanes = *y;
        for i in 0..N {
            lanes[i] = L::load(&out[i]);
        }
        lanes
    }

    fn scale(&self, y: &[f64; N]) -> [f64; N] {
        self.0.scale(y)
    }
}

/// The Gauss-Legendre method of order 16 with equal steps.
///
/// A step solves Y_i = y + h sum_j a_ij f(t + c_j h, Y_j) by sweeps: all eight
/// slopes are evaluated at once, new stages are formed, and so on. The first sweep
/// leaves near h/2 times the Lipschitz constant of f of what was missing, each of
/// the next ones less. The sweeps end when what is still missing (the last change
/// times the last gain) is below the precision, or when round-off lets nothing be gained.
///
/// Accuracy, as measured against the closed forms: a tumbling body ([`FreeRotation`])
/// after 1000 periods of its rates, and the notes' top (16.2, fig. 3, [`SpinFree`])
/// after 2000 time units; a sweep is eight derivatives at once:
///
/// | tumbling: steps a period | sweeps a step | error (rad) | top: time a step | sweeps a step | error (rad) |
/// |---|---|---|---|---|---|
/// | 6 | 17.1 | 6.9e-9 | 2 | 23.6 | 4.2e-8 |
/// | 7 | 15.3 | 5.9e-10 | 1.33 | 17.4 | 8.0e-11 |
/// | 8 | 14.1 | 7.9e-11 | 1 | 14.5 | 1.0e-12 |
/// | 10 | 12.8 | 1.3e-11 | | | |
///
/// Over 1e5 steps the energy of the tumbling body stays within 2.5e-15 of its first value, the
/// energy of the top within 6.0e-15; |L|, and L_Z of the top, are kept exactly. The error of a
/// step: with theta = h |L|/I, the angle that a step turns through (I the smallest moment, or I1
/// where the spin is taken out), it adds 6e-22 theta^17 rad on the tumbling body. On the top it
/// adds 3e-20 theta^17 rad. Stages need not be solved better than that: as
/// [`precision`](Self::with_precision) take the error allowed for a step, on the free body a
/// thirtieth of it. Over a thousand periods that saves two fifths of the sweeps for 1e-6 and a
/// quarter for 1e-9 on the top, a third and an eighth on the free body. [`steady`](Self::steady),
/// sweeps are cheaper, and so is the rest of a step. With seven components they take 27 ns and 29
/// ns instead of 33 ns and 57 ns in registers of AVX-512, 32 ns and 44 ns instead of 53 ns and 71
/// ns in registers of AVX2 (Zen 4 at 3.7 GHz). On a tumbling body, a top in two kinds of variables
/// and an oscillator that is not steady, the error that n = 50 to 100 steps leave stays below 1.7
/// sqrt(n) times the precision. It is mostly on one side: on long runs it goes with the square of
/// n.
///
/// Longer steps than 4 a period do not pay: the sweeps gain too little, and at 3 a
/// period they diverge ([`Error::NoConvergence`]).
///
/// [`SpinFree`]: crate::integrators::SpinFree
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GaussLegendre<const STEADY: bool = false> {
    steps: u64,
    precision: f64,
    registers: Registers,
}

impl GaussLegendre {
    /// The method with this many equal steps over the whole run, stages solved to round-off.
    ///
    /// Errors: no steps.
    pub fn new(steps: u64) -> Result<Self> {
        Self::with_precision(steps, 0.0)
    }

    /// The same with the stages of each step solved to `precision` (0: to round-off), relative to
    /// the scale of the state: a run that needs nine digits need not sweep for 16. The errors of
    /// the steps add up over the run.
    ///
    /// Errors: no steps; a precision outside [0, 0.1].
    pub fn with_precision(steps: u64, precision: f64) -> Result<Self> {
        if steps == 0 {
            return Err(no_steps());
        }
        if !(0.0..=0.1).contains(&precision) {
            return Err(Error::out_of_range(
                "precision",
                precision,
                "it must lie between 0 and 0.1",
            ));
        }
        Ok(Self { steps, precision: precision.max(0.5 * EPS), registers: Registers::Avx512 })
    }

    /// The same where each step needs about as many sweeps as the one before, to a precision above
    /// 1e-15. Its sweeps are cheaper; it takes 0 to 2 in a hundred more of them on long steps, up
    /// to 15 in a hundred more on short ones.
    pub const fn steady(self) -> GaussLegendre<true> {
        let Self { steps, precision, registers } = self;
        GaussLegendre { steps, precision, registers }
    }
}

impl<const STEADY: bool> GaussLegendre<STEADY> {
    /// The same in no better registers than these: the same bits, for those who want
    /// to see what the registers are worth.
    pub const fn limited_to(self, registers: Registers) -> Self {
        Self { registers, ..self }
    }
}

impl<const N: usize, O: StageOde<N>, const STEADY: bool> Integrator<O, [f64; N]>
    for GaussLegendre<STEADY>
{
    advance_by_counting!(O, [f64; N]);

    fn advance_counting(
        &self,
        ode: &O,
        t: f64,
        start: &[f64; N],
        t_end: f64,
        work: &mut Work,
    ) -> Result<[f64; N]> {
        check_span(t, start, t_end)?;
        if t == t_end {
            return Ok(*start);
        }
        self.run(ode, t, Compensated::new(*start), t_end, &mut (), work)
    }
}
