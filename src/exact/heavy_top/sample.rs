//! Attitude and rates at a time, without a branch, where the series is trigonometric.
//!
//! With z, psi_a and psi_b growing steadily,
//!
//!   alpha ~ theta_1(z - i y_a) e^{i psi_a},  beta ~ theta_2(z - i y_b) e^{i psi_b},
//!   omega_1 + i omega_2 ~ theta_2(z - i y) e^{+-iz} conj(e^{i psi_a}) e^{i psi_b},
//!
//! all over the same theta_4(z), which normalising alpha and beta gives. The transverse
//! rate is such a quotient because its square, by the energy, is linear in cos(theta).
//! Its zero follows from the other two: y = y_b - y_a -+ pi K'/2K.
//!
//! Three sine-cosine pairs, of z, psi_a and psi_b, are all a sample takes.

use super::motion::Motion;
use super::rates::RateWave;
use super::{Turns, series::Factor};
use crate::attitude::Attitude;
use crate::exact::batch::{Branchless, LOST, Sampled};
use crate::math::lane::{Constant, Cubics, Gathered, Pair, Phased, Row, WIDEST, cubics, horner};
use crate::math::{Clock, Reduced, Time, sincos_of, unsigned_sincos_of};

/// A motion ready to be sampled.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sampler<V = f64> {
    /// z and the phases of alpha and beta, in quarter turns.
    nutation: Clock<V>,
    phases: Clock<[V; 2]>,
    /// Polynomials in k = 2 cos 2z for alpha and beta: times sin z and cos z the real
    /// parts, times cos z and sin z the imaginary ones.
    re: Cubics<V>,
    im: Cubics<V>,
    /// The transverse rate: times cos z and sin z its real and imaginary part before it
    /// is turned by `sense` z.
    rate: Cubics<V>,
    sense: V,
    spin: V,
    /// The greatest |t|.
    until: f64,
}

/// alpha and beta, normalised, and the parts of them that the rates need.
pub(super) struct Axis<L: Phased> {
    re: L::Pair,
    im: L::Pair,
    /// Sine and cosine of both phases.
    phase: [L::Pair; 2],
    scale: L,
}

impl<L: Phased> Axis<L> {
    /// Of both series and phases; negative where the last bit but one of `whole` is set.
    #[inline(always)]
    pub(super) fn new(re: L::Pair, im: L::Pair, phases: Reduced<L::Pair>, whole: L) -> Self {
        let (first, second) = (re * re + im * im).parts();
        let scale = L::of(1.0) / (first + second).sqrt();
        let (sin, cos) = sincos_of(phases);
        let signed = scale.negative_if_half(whole);
        let both = L::Pair::new(signed, signed);
        Self {
            re: (re * cos - im * sin) * both,
            im: (re * sin + im * cos) * both,
            phase: [sin, cos],
            scale,
        }
    }

    /// The unit quaternion.
    #[inline(always)]
    pub(super) fn quaternion(&self) -> [L; 4] {
        let ((w, x), (z, y)) = (self.re.parts(), self.im.parts());
        [w, x, y, z]
    }

    /// The transverse rate by its series, before it is turned by both phases.
    #[inline(always)]
    pub(super) fn transverse(&self, re: L, im: L) -> [L; 2] {
        // conj(e^{i psi_a}) e^{i psi_b}
        let [phase_sin, phase_cos] = self.phase;
        let ((sin_a, sin_b), (cos_a, cos_b)) = (phase_sin.parts(), phase_cos.parts());
        let cos = cos_a * cos_b + sin_a * sin_b;
        let sin = cos_a * sin_b - sin_a * cos_b;
        [(re * cos - im * sin) * self.scale, (re * sin + im * cos) * self.scale]
    }
}

impl Sampler {
    /// For a motion whose gravity is turned if `flip` < 0, with the phases of alpha and
    /// beta in `turns` and omega_3 = `spin`.
    pub(super) fn new(
        motion: &Motion,
        wave: &RateWave,
        turns: &[Turns; 2],
        flip: f64,
        spin: f64,
    ) -> Self {
        let [a, b] = &motion.series.sides[0];
        let flipped = flip < 0.0;
        let per = motion.half_period.recip();
        let start = motion.offset * per + motion.first as f64 + f64::from(u8::from(flipped));
        let nutation = Clock::new(per, start);
        let phases = turns.map(|turn| {
            let start = turn.start - turn.start.round();
            Clock::new(turn.rate.scaled(4.0), start.scaled(4.0))
        });
        let until = phases.iter().fold(nutation.until(), |until, phase| until.min(phase.until()));
        let (sides, sense, rate) = oriented(a, b, wave, flipped);
        Self {
            nutation,
            phases: phases[0].beside(&phases[1]),
            re: cubics(&sides[0].re, &sides[1].re),
            im: cubics(&sides[0].im, &sides[1].im),
            rate: cubics(&rate.re, &rate.im),
            sense,
            spin,
            until,
        }
    }

    pub(super) fn attitude(&self, t: f64) -> Attitude {
        Attitude::from_unit(if t.abs() <= self.until { self.quaternion(t) } else { LOST.0 })
    }

    /// The unit quaternion at time `t`.
    #[inline(always)]
    pub(super) fn quaternion<L: Phased>(&self, t: L) -> [L; 4] {
        self.axis(self.phases(t, 0), 0).0.quaternion()
    }
}

impl<V: Constant> Sampler<V> {
    /// z, and the phases of alpha and beta, while |t| is at most `until`.
    #[inline(always)]
    fn phases<L: Phased>(&self, t: L, first: usize) -> (Reduced<L>, Reduced<L::Pair>) {
        let time = Time::new(t);
        (self.nutation.at(&time, first), self.phases.both_at(&time, first))
    }

    /// The axis, sine and cosine of z, and k.
    #[inline(always)]
    fn axis<L: Phased>(
        &self,
        (z, phases): (Reduced<L>, Reduced<L::Pair>),
        first: usize,
    ) -> (Axis<L>, L::Pair, L) {
        let wave = unsigned_sincos_of(z);
        let (sin, _) = wave.parts();
        let k = L::of(2.0) - sin * 4.0 * sin;
        let re = wave * horner(&self.re, k, first);
        let im = wave.swapped() * horner(&self.im, k, first);
        (Axis::new(re, im, phases, z.whole), wave, k)
    }

    #[inline(always)]
    fn all_of<L: Phased>(
        &self,
        phases: (Reduced<L>, Reduced<L::Pair>),
        first: usize,
    ) -> ([L; 4], [L; 3]) {
        let (axis, wave, k) = self.axis(phases, first);
        let (re, im) = (wave.swapped() * horner(&self.rate, k, first)).parts();
        let (sin, cos) = wave.parts();
        let sin = sin * self.sense.lane::<L>(first);
        let (re, im) = (re * cos - im * sin, re * sin + im * cos);
        let [p, q] = axis.transverse(re, im);
        (axis.quaternion(), [p, q, self.spin.lane(first)])
    }
}

impl<V: Constant> Branchless<V> for Sampler<V> {
    fn until(&self) -> f64 {
        self.until
    }

    #[inline(always)]
    fn all<L: Phased>(&self, t: L, first: usize) -> ([L; 4], [L; 3]) {
        self.all_of(self.phases(t, first), first)
    }
}

impl Sampled for Sampler {}

impl Gathered for Sampler {
    type Rows = Sampler<Row>;
    fn gathered(each: [Self; WIDEST]) -> Sampler<Row> {
        Sampler {
            nutation: Gathered::gathered(each.map(|of| of.nutation)),
            phases: Gathered::gathered(each.map(|of| of.phases)),
            re: Gathered::gathered(each.map(|of| of.re)),
            im: Gathered::gathered(each.map(|of| of.im)),
            rate: Gathered::gathered(each.map(|of| of.rate)),
            sense: each.map(|of| of.sense),
            spin: each.map(|of| of.spin),
            until: each.iter().fold(f64::INFINITY, |until, of| until.min(of.until)),
        }
    }
}

/// The series of alpha and beta from those in v, the sense of the rate's turn, and the
/// rate's own series.
///
/// Gravity turned, alpha and beta are exchanged. A quarter added to z puts them back
/// into the same form: sin z = -cos z', cos z = sin z', k = -k'. The transverse rate
/// 2 (conj(alpha) beta' - beta conj(alpha)') becomes minus its conjugate.
fn oriented(a: &Factor, b: &Factor, wave: &RateWave, flipped: bool) -> ([Factor; 2], f64, Factor) {
    let rate = wave.factor;
    if !flipped {
        return ([*a, *b], wave.sense, rate);
    }
    let first = Factor { re: mirrored(&b.re, 1.0), im: mirrored(&b.im, -1.0) };
    let second = Factor { re: mirrored(&a.re, -1.0), im: mirrored(&a.im, 1.0) };
    let rate = Factor { re: mirrored(&rate.im, wave.sense), im: mirrored(&rate.re, -wave.sense) };
    ([first, second], -wave.sense, rate)
}

/// The polynomial in -k, times `sign`.
fn mirrored(p: &[f64; 4], sign: f64) -> [f64; 4] {
    [sign * p[0], -sign * p[1], sign * p[2], -sign * p[3]]
}
