//! Attitude and rates at a time, without a branch, where the series is trigonometric.
//!
//! z and the phase along L grow steadily and are read together: two sine-cosine pairs
//! are all a sample takes.

use super::series::Trigonometric;
use crate::attitude::Attitude;
use crate::exact::batch::Branchless;
use crate::math::lane::{Cubics, Pair, Phased, cubics, horner};
use crate::math::{Clock, DoubleDouble as Dd, Reduced, Time, sincos_of};

/// A motion ready to be sampled.
#[derive(Debug, Clone)]
pub(super) struct Sampler {
    /// z and the phase, in quarter turns.
    clocks: Clock<[f64; 2]>,
    /// Polynomials in sin^2 z for alpha and beta: times 1 and sin z the real parts,
    /// times sin z cos z and cos z the imaginary ones.
    re: Cubics,
    im: Cubics,
    /// What each of Re alpha, Re beta, Im beta, Im alpha adds to the quaternion.
    columns: [[f64; 4]; 4],
    rates: Rates,
    /// The greatest |t|.
    until: f64,
}

/// The body rates from the direction of L on the ordered axes.
#[derive(Debug, Clone, Copy)]
pub(super) struct Rates {
    /// L/J on the ordered axes, with the sign; and where each body axis stands in that order.
    pub rate: [f64; 3],
    pub place: [usize; 3],
    /// l3 = c dn, dn^2 = m1 + m (l1/l1max)^2: the small l3 next to the separatrix
    /// keeps its relative accuracy, which |alpha|^2 - |beta|^2 would lose.
    pub c: f64,
    pub m1: f64,
    pub m_over_l1: f64,
}

impl Rates {
    /// On the body's own axes.
    #[inline(always)]
    pub fn of<L: Phased>(&self, l1: L, l2: L) -> [L; 3] {
        let l3 = (l1 * self.m_over_l1 * l1 + self.m1).sqrt() * self.c;
        let ordered = [l1 * self.rate[0], l2 * self.rate[1], l3 * self.rate[2]];
        let [x, y, z] = self.place;
        [ordered[x], ordered[y], ordered[z]]
    }
}

/// The sums as they come, and scaled and turned by the phase.
struct Sample<L: Phased> {
    sums: [L::Pair; 2],
    re: L::Pair,
    im: L::Pair,
    scale: L,
}

impl Sampler {
    /// z grows by a quarter in `quarter` seconds and the phase by `local` rad/s, both
    /// from zero at -`start`.
    pub fn new(
        series: &Trigonometric,
        sense: f64,
        start: Dd,
        quarter: Dd,
        local: Dd,
        rates: Rates,
    ) -> Self {
        let clock = |rate: Dd| Clock::new(rate, reduced(rate * start));
        let clocks = [
            clock(quarter.recip()),
            clock(local.scaled(4.0) / Dd::TWO_PI),
        ];
        let [alpha, beta] = [&series.alpha, &series.beta];
        let signed = |p: &[f64; 4], sign: f64| p.map(|c| sign * c);
        Self {
            until: clocks[0].until().min(clocks[1].until()),
            clocks: clocks[0].beside(&clocks[1]),
            // The constant phase of beta puts l1 > 0 at tau = 0.
            re: cubics(&alpha[0], &signed(&beta[0], -sense)),
            im: cubics(&signed(&alpha[1], sense), &signed(&beta[1], -1.0)),
            columns: [
                [1.0, 0.0, 0.0, 0.0],
                [0.0, 1.0, 0.0, 0.0],
                [0.0, 0.0, 1.0, 0.0],
                [0.0, 0.0, 0.0, 1.0],
            ],
            rates,
        }
    }

    /// The same between other frames: `turned` is what becomes of a quaternion.
    pub fn seen(mut self, turned: impl Fn([f64; 4]) -> [f64; 4]) -> Self {
        self.columns = self.columns.map(turned);
        self
    }

    #[inline(always)]
    fn sample<L: Phased>(&self, clocks: Reduced<L::Pair>) -> Sample<L> {
        let (sin, cos) = sincos_of(clocks);
        let ((sin, phase_sin), (cos, phase_cos)) = (sin.parts(), cos.parts());
        let square = sin * sin;
        let re = L::Pair::new(L::of(1.0), sin) * horner(&self.re, square);
        let im = L::Pair::new(sin * cos, cos) * horner(&self.im, square);
        let (first, second) = (re * re + im * im).parts();
        let scale = L::of(1.0) / (first + second).sqrt();
        let (sin, cos) = (phase_sin * scale, phase_cos * scale);
        let (sin, cos) = (L::Pair::new(sin, sin), L::Pair::new(cos, cos));
        Sample {
            sums: [re, im],
            re: re * cos - im * sin,
            im: re * sin + im * cos,
            scale,
        }
    }

    #[inline(always)]
    fn quaternion_of<L: Phased>(&self, sample: &Sample<L>) -> [L; 4] {
        let ((alpha_re, beta_re), (alpha_im, beta_im)) = (sample.re.parts(), sample.im.parts());
        combined(&self.columns, [alpha_re, beta_re, beta_im, alpha_im])
    }

    #[inline(always)]
    fn rates_of<L: Phased>(&self, sample: &Sample<L>) -> [L; 3] {
        // 2 alpha conj(beta) = l2 + i l1.
        let [re, im] = sample.sums;
        let ((ar, br), (ai, bi)) = (re.parts(), im.parts());
        let twice = sample.scale * sample.scale * 2.0;
        self.rates
            .of((ai * br - ar * bi) * twice, (ar * br + ai * bi) * twice)
    }

    /// The attitude alone costs less.
    pub fn attitude(&self, t: f64) -> Attitude {
        let clocks = if t.abs() <= self.until {
            self.clocks.read(Pair::both, &Time::new(t).twice())
        } else {
            self.clocks.both_far(t)
        };
        Attitude::from_unit(self.quaternion_of(&self.sample::<f64>(clocks)))
    }
}

impl Branchless for Sampler {
    fn until(&self) -> f64 {
        self.until
    }

    #[inline(always)]
    fn all<L: Phased>(&self, t: L) -> ([L; 4], [L; 3]) {
        let clocks = self.clocks.read(L::Pair::both, &Time::new(t).twice());
        let sample = self.sample::<L>(clocks);
        (self.quaternion_of(&sample), self.rates_of(&sample))
    }

    #[cold]
    fn far(&self, t: f64) -> ([f64; 4], [f64; 3]) {
        let sample = self.sample::<f64>(self.clocks.both_far(t));
        (self.quaternion_of(&sample), self.rates_of(&sample))
    }
}

/// The columns, each times its part, added up.
#[inline(always)]
pub(super) fn combined<L: Phased>(columns: &[[f64; 4]; 4], parts: [L; 4]) -> [L; 4] {
    let a = times(parts[0], &columns[0]);
    let b = times(parts[1], &columns[1]);
    let c = times(parts[2], &columns[2]);
    let d = times(parts[3], &columns[3]);
    let (w, x) = ((a.0 + b.0) + (c.0 + d.0)).parts();
    let (y, z) = ((a.1 + b.1) + (c.1 + d.1)).parts();
    [w, x, y, z]
}

#[inline(always)]
fn times<L: Phased>(part: L, column: &[f64; 4]) -> (L::Pair, L::Pair) {
    let both = L::Pair::new(part, part);
    let [w, x, y, z] = *column;
    (both * L::Pair::both(&[w, x]), both * L::Pair::both(&[y, z]))
}

/// A phase in quarters less whole turns.
fn reduced(quarters: Dd) -> Dd {
    quarters - Dd::from(4.0 * quarters.scaled(0.25).round())
}
