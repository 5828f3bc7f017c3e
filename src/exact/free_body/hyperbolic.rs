//! Attitude and rates at a time, without a branch, near the separatrix, where the hyperbolic
//! series converges and a period is long.
//!
//! The series runs from the nearest turning point, and the phase along L then lags by a step at
//! each passage half-way between them. It is the reading of a clock of the time, less the reading
//! of a clock of their number.

use super::sample::{Columns, Rates, Sample, columns, reduced};
use super::series::Hyperbolic;
use crate::attitude::Attitude;
use crate::attitude::product::product;
use crate::exact::batch::{Branchless, LOST, Sampled};
use crate::math::lane::{Constant, Cubics, Gathered, Pair, Phased, Row, WIDEST, cubics, horner};
use crate::math::{Clock, DoubleDouble as Dd, Reduced, STEEPEST, Time, sincos_of, sinh_cosh_of};

/// A motion near the separatrix or on it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Late<V = f64> {
    /// The time in half-periods, and the phase in quarter turns.
    clocks: Clock<[V; 2]>,
    /// The quarter turns by which it lags, by the number of half-periods.
    lag: Clock<V>,
    /// w in a half-period.
    width: V,
    /// 2 q and 4 q: k = 2 q cosh 2w = 2 q + 4 q sinh^2 w.
    nome: [V; 2],
    /// Polynomials in k for alpha and beta: times cosh w and sinh w the real parts, times
    /// sinh w and cosh w the imaginary ones.
    re: Cubics<V>,
    im: Cubics<V>,
    columns: Columns<V>,
    pub(super) rates: Rates<V>,
    /// The greatest |t|.
    until: f64,
}

/// So many units of w count as a half-period where there is none.
const ENDLESS: f64 = 1_152_921_504_606_846_976.0; // 2^60

impl Late {
    /// tau = 0 at -`start`, 2K in time `half_period`, and the phase grows by `local` rad/s;
    /// `winding` is dropped from it by the series in each half-period.
    pub(super) fn new(
        series: &Hyperbolic,
        sense: f64,
        start: Dd,
        half_period: Option<Dd>,
        (local, winding): (Dd, Dd),
        rates: Rates,
    ) -> Self {
        let quarters = |angle: Dd| angle.turns().scaled(4.0);
        let (per, width) = match half_period {
            Some(half) => (half.recip(), (series.rate * half).to_f64()),
            None => (series.rate.scaled(1.0 / ENDLESS), ENDLESS),
        };
        let local = quarters(local);
        let clocks = [Clock::new(per, per * start), Clock::new(local, reduced(local * start))];
        let until = clocks[1].until().min(0.25 * clocks[0].until());
        let [alpha, beta] = [&series.alpha, &series.beta];
        let signed = |p: &[f64; 4], sign: f64| p.map(|c| sign * c);
        Self {
            lag: Clock::new(reduced(quarters(winding * -sense)), Dd::ZERO),
            width,
            nome: [2.0 * series.nome, 4.0 * series.nome],
            // The constant phase of beta puts l1 > 0 at tau = 0.
            re: cubics(&alpha[0], &signed(&beta[0], -sense)),
            im: cubics(&signed(&alpha[1], sense), &signed(&beta[1], -1.0)),
            columns: columns(|unit| unit),
            rates,
            until,
            clocks: clocks[0].beside(&clocks[1]),
        }
    }

    /// The same seen from space, on the body's axes: the frames on either side.
    pub(super) fn seen(self, outer: [f64; 4], inner: [f64; 4]) -> Self {
        Self { columns: columns(|quaternion| product(product(outer, quaternion), inner)), ..self }
    }

    /// The attitude alone costs less.
    pub(super) fn attitude(&self, t: f64) -> Attitude {
        Attitude::from_unit(if t.abs() <= self.until {
            self.near(t, 0).quaternion(&self.columns, 0)
        } else {
            LOST.0
        })
    }
}

impl<V: Constant> Late<V> {
    #[inline(always)]
    fn near<L: Phased>(&self, t: L, first: usize) -> Sample<L> {
        let clocks = self.clocks.both_at(&Time::new(t), first);
        let ((rest, phase_rest), (whole, phase_whole)) =
            (clocks.rest.parts(), clocks.whole.parts());
        let half = Reduced { rest, whole };
        let phase = Reduced { rest: phase_rest, whole: phase_whole };
        let lag = self.lag.at(&Time::new(half.count()), first);
        self.sample(half, phase.less(&lag), first)
    }

    #[inline(always)]
    fn sample<L: Phased>(&self, half: Reduced<L>, phase: Reduced<L>, first: usize) -> Sample<L> {
        let Reduced { rest, whole } = half;
        // Steeper than that sinh/cosh is one, and q nothing.
        let (sinh, cosh) = sinh_cosh_of((rest * self.width.lane::<L>(first)).within(STEEPEST));
        let [twice, four] = &self.nome;
        let k = twice.lane::<L>(first) + sinh * four.lane::<L>(first) * sinh;
        // theta_1 changes sign over 2K.
        let (odd, even) = (sinh.negative_if_odd(whole), cosh.negative_if_odd(whole));
        let re = L::Pair::new(cosh, odd) * horner(&self.re, k, first);
        let im = L::Pair::new(sinh, even) * horner(&self.im, k, first);
        let (sin, cos) = sincos_of(phase);
        // At the middle axis, where it rests, the rate is this times what is exact: once rounded.
        Sample::new([re, im], [sin, cos], |norm, _| L::of(2.0) / norm)
    }
}

impl<V: Constant> Branchless<V> for Late<V> {
    fn until(&self) -> f64 {
        self.until
    }

    #[inline(always)]
    fn all<L: Phased>(&self, t: L, first: usize) -> ([L; 4], [L; 3]) {
        let sample = self.near(t, first);
        (sample.quaternion(&self.columns, first), sample.rates(&self.rates, first))
    }
}

impl Sampled for Late {}

impl Gathered for Late {
    type Rows = Late<Row>;
    fn gathered(each: [Self; WIDEST]) -> Late<Row> {
        Late {
            clocks: Gathered::gathered(each.map(|of| of.clocks)),
            lag: Gathered::gathered(each.map(|of| of.lag)),
            width: each.map(|of| of.width),
            nome: Gathered::gathered(each.map(|of| of.nome)),
            re: Gathered::gathered(each.map(|of| of.re)),
            im: Gathered::gathered(each.map(|of| of.im)),
            columns: Gathered::gathered(each.map(|of| of.columns)),
            rates: Gathered::gathered(each.map(|of| of.rates)),
            until: each.iter().fold(f64::INFINITY, |until, of| until.min(of.until)),
        }
    }
}
