//! Attitude and rates at a time, without a branch, where the series is trigonometric.
//!
//! z and the phase along L grow steadily and are read together: two sine-cosine pairs
//! are all a sample takes.

use super::series::Trigonometric;
use crate::attitude::Attitude;
use crate::exact::batch::{Branchless, LOST, Sampled};
use crate::math::lane::{Constant, Cubics, Gathered, Pair, Phased, Row, WIDEST, cubics, horner};
use crate::math::{Clock, DoubleDouble as Dd, Reduced, Time, sincos_of};

/// A motion ready to be sampled.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sampler<V = f64> {
    /// z and the phase, in quarter turns.
    clocks: Clock<[V; 2]>,
    /// Polynomials in sin^2 z for alpha and beta: times 1 and sin z the real parts,
    /// times sin z cos z and cos z the imaginary ones.
    re: Cubics<V>,
    im: Cubics<V>,
    /// The contribution of each of Re alpha, Re beta, Im beta, Im alpha to the quaternion.
    columns: Columns<V>,
    pub(super) rates: Rates<V>,
    /// The greatest |t|.
    until: f64,
}

/// Four quaternions, each as its first two and its last two components.
pub(super) type Columns<V> = [[[V; 2]; 2]; 4];

/// The images of 1, i, j and k.
pub(super) fn columns(turned: impl Fn([f64; 4]) -> [f64; 4]) -> Columns<f64> {
    core::array::from_fn(|n| {
        let mut unit = [0.0; 4];
        unit[n] = 1.0;
        let [w, x, y, z] = turned(unit);
        [[w, x], [y, z]]
    })
}

/// The body rates from the direction of L on the ordered axes.
#[derive(Debug, Clone, Copy)]
pub(super) struct Rates<V = f64> {
    /// L/J on the ordered axes, with the sign; and the place of each body axis in that order.
    pub(super) rate: [V; 3],
    pub(super) place: [usize; 3],
    /// l3 = c dn, dn^2 = m1 + m (l1/l1max)^2: the small l3 next to the separatrix
    /// keeps its relative accuracy, which |alpha|^2 - |beta|^2 would lose.
    pub(super) c: V,
    pub(super) m1: V,
    pub(super) m_over_l1: V,
}

impl<V: Constant> Rates<V> {
    /// On the body's own axes.
    #[inline(always)]
    pub(super) fn of<L: Phased>(&self, l1: L, l2: L, first: usize) -> [L; 3] {
        let square = l1 * self.m_over_l1.lane::<L>(first) * l1;
        let l3 = (square + self.m1.lane::<L>(first)).sqrt() * self.c.lane::<L>(first);
        let [one, two, three] = &self.rate;
        let ordered =
            [l1 * one.lane::<L>(first), l2 * two.lane::<L>(first), l3 * three.lane::<L>(first)];
        placed(self.place, ordered)
    }
}

/// Components on ordered axes, put on the body's own axes.
#[inline(always)]
pub(super) fn placed<L: Copy>([x, y, z]: [usize; 3], ordered: [L; 3]) -> [L; 3] {
    [ordered[x], ordered[y], ordered[z]]
}

/// The rates of several bodies are left on the ordered axes.
impl Gathered for Rates {
    type Rows = Rates<Row>;
    fn gathered(each: [Self; WIDEST]) -> Rates<Row> {
        Rates {
            rate: Gathered::gathered(each.map(|of| of.rate)),
            place: [0, 1, 2],
            c: each.map(|of| of.c),
            m1: each.map(|of| of.m1),
            m_over_l1: each.map(|of| of.m_over_l1),
        }
    }
}

impl Gathered for Sampler {
    type Rows = Sampler<Row>;
    fn gathered(each: [Self; WIDEST]) -> Sampler<Row> {
        Sampler {
            clocks: Gathered::gathered(each.map(|of| of.clocks)),
            re: Gathered::gathered(each.map(|of| of.re)),
            im: Gathered::gathered(each.map(|of| of.im)),
            columns: Gathered::gathered(each.map(|of| of.columns)),
            rates: Gathered::gathered(each.map(|of| of.rates)),
            until: each.iter().fold(f64::INFINITY, |until, of| until.min(of.until)),
        }
    }
}

/// The sums as they come, and scaled and turned by the phase.
pub(super) struct Sample<L: Phased> {
    sums: [L::Pair; 2],
    re: L::Pair,
    im: L::Pair,
    /// 2/(|alpha|^2 + |beta|^2).
    twice: L,
}

impl Sampler {
    /// z grows by a quarter in `quarter` seconds and the phase by `local` rad/s, both
    /// from zero at -`start`.
    pub(super) fn new(
        series: &Trigonometric,
        sense: f64,
        start: Dd,
        quarter: Dd,
        local: Dd,
        rates: Rates,
    ) -> Self {
        let clock = |rate: Dd| Clock::new(rate, reduced(rate * start));
        let clocks = [clock(quarter.recip()), clock(local.turns().scaled(4.0))];
        let [alpha, beta] = [&series.alpha, &series.beta];
        let signed = |p: &[f64; 4], sign: f64| p.map(|c| sign * c);
        Self {
            until: clocks[0].until().min(clocks[1].until()),
            clocks: clocks[0].beside(&clocks[1]),
            // The constant phase of beta puts l1 > 0 at tau = 0.
            re: cubics(&alpha[0], &signed(&beta[0], -sense)),
            im: cubics(&signed(&alpha[1], sense), &signed(&beta[1], -1.0)),
            columns: columns(|unit| unit),
            rates,
        }
    }

    /// The same between other frames: `turned` is what becomes of a quaternion.
    pub(super) fn seen(self, turned: impl Fn([f64; 4]) -> [f64; 4]) -> Self {
        Self { columns: columns(turned), ..self }
    }

    /// The attitude alone costs less.
    pub(super) fn attitude(&self, t: f64) -> Attitude {
        Attitude::from_unit(if t.abs() <= self.until {
            let clocks = self.clocks.both_at(&Time::new(t), 0);
            self.quaternion_of(&self.sample::<f64>(clocks, 0), 0)
        } else {
            LOST.0
        })
    }
}

impl<V: Constant> Sampler<V> {
    #[inline(always)]
    fn sample<L: Phased>(&self, clocks: Reduced<L::Pair>, first: usize) -> Sample<L> {
        let (sin, cos) = sincos_of(clocks);
        let ((sin, phase_sin), (cos, phase_cos)) = (sin.parts(), cos.parts());
        let square = sin * sin;
        let re = L::Pair::new(L::of(1.0), sin) * horner(&self.re, square, first);
        let im = L::Pair::new(sin * cos, cos) * horner(&self.im, square, first);
        Sample::new([re, im], [phase_sin, phase_cos], |_, scale| scale * scale * 2.0)
    }

    #[inline(always)]
    fn quaternion_of<L: Phased>(&self, sample: &Sample<L>, first: usize) -> [L; 4] {
        sample.quaternion(&self.columns, first)
    }
}

impl<L: Phased> Sample<L> {
    /// From the sums for alpha and beta, and sine and cosine of the phase; `twice` is 2/(|alpha|^2
    /// + |beta|^2) from that sum and one over its root.
    #[inline(always)]
    pub(super) fn new(
        [re, im]: [L::Pair; 2],
        [sin, cos]: [L; 2],
        twice: impl Fn(L, L) -> L,
    ) -> Self {
        let (first, second) = (re * re + im * im).parts();
        let norm = first + second;
        let scale = L::of(1.0) / norm.sqrt();
        let (sin, cos) = (sin * scale, cos * scale);
        let (sin, cos) = (L::Pair::new(sin, sin), L::Pair::new(cos, cos));
        Self {
            sums: [re, im],
            re: re * cos - im * sin,
            im: re * sin + im * cos,
            twice: twice(norm, scale),
        }
    }

    #[inline(always)]
    pub(super) fn quaternion<V: Constant>(&self, columns: &Columns<V>, first: usize) -> [L; 4] {
        let ((alpha_re, beta_re), (alpha_im, beta_im)) = (self.re.parts(), self.im.parts());
        combined(columns, [alpha_re, beta_re, beta_im, alpha_im], first)
    }

    #[inline(always)]
    pub(super) fn rates<V: Constant>(&self, rates: &Rates<V>, first: usize) -> [L; 3] {
        // 2 alpha conj(beta) = l2 + i l1.
        let [re, im] = self.sums;
        let ((ar, br), (ai, bi)) = (re.parts(), im.parts());
        let (l1, l2) = (ai * br - ar * bi, ar * br + ai * bi);
        rates.of(l1 * self.twice, l2 * self.twice, first)
    }
}

impl<V: Constant> Branchless<V> for Sampler<V> {
    fn until(&self) -> f64 {
        self.until
    }

    #[inline(always)]
    fn all<L: Phased>(&self, t: L, first: usize) -> ([L; 4], [L; 3]) {
        let sample = self.sample::<L>(self.clocks.both_at(&Time::new(t), first), first);
        (self.quaternion_of(&sample, first), sample.rates(&self.rates, first))
    }
}

impl Sampled for Sampler {}

/// The columns, each times its part, added up.
#[inline(always)]
pub(super) fn combined<L: Phased, V: Constant>(
    columns: &Columns<V>,
    parts: [L; 4],
    first: usize,
) -> [L; 4] {
    let [a, b, c, d] = columns;
    let a = times(parts[0], a, first);
    let b = times(parts[1], b, first);
    let c = times(parts[2], c, first);
    let d = times(parts[3], d, first);
    let (w, x) = ((a.0 + b.0) + (c.0 + d.0)).parts();
    let (y, z) = ((a.1 + b.1) + (c.1 + d.1)).parts();
    [w, x, y, z]
}

#[inline(always)]
fn times<L: Phased, V: Constant>(
    part: L,
    [start, end]: &[[V; 2]; 2],
    first: usize,
) -> (L::Pair, L::Pair) {
    let both = L::Pair::new(part, part);
    (both * V::pair::<L>(start, first), both * V::pair::<L>(end, first))
}

/// A phase in quarters less whole turns.
pub(super) fn reduced(quarters: Dd) -> Dd {
    quarters - Dd::from(4.0 * quarters.scaled(0.25).round())
}
