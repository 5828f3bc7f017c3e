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
use crate::exact::batch::Branchless;
use crate::math::lane::{Cubics, Pair, Phased, cubics, horner};
use crate::math::{Clock, Reduced, Time, sincos_of, unsigned_sincos_of};

/// A motion ready to be sampled.
#[derive(Debug, Clone)]
pub(super) struct Sampler {
    /// z and the phases of alpha and beta, in quarter turns.
    nutation: Clock<f64>,
    phases: Clock<[f64; 2]>,
    /// Polynomials in k = 2 cos 2z for alpha and beta: times sin z and cos z the real
    /// parts, times cos z and sin z the imaginary ones.
    re: Cubics,
    im: Cubics,
    /// The transverse rate: times cos z and sin z its real and imaginary part before it
    /// is turned by `sense` z.
    rate: Cubics,
    sense: f64,
    spin: f64,
    /// The greatest |t|.
    until: f64,
}

/// alpha and beta, normalised, and what the rates need of them.
struct Axis<L: Phased> {
    re: L::Pair,
    im: L::Pair,
    wave: L::Pair,
    k: L,
    phase: [L::Pair; 2],
    scale: L,
}

impl Sampler {
    /// For a motion whose gravity is turned if `flip` < 0, with the phases of alpha and
    /// beta in `turns` and omega_3 = `spin`.
    pub fn new(motion: &Motion, turns: &[Turns; 2], flip: f64, spin: f64) -> Option<Self> {
        let [a, b] = motion.trigonometric()?;
        let wave = motion.rates.as_ref()?;
        let flipped = flip < 0.0;
        let per = motion.half_period.recip();
        let start = motion.offset * per + motion.first as f64 + f64::from(u8::from(flipped));
        let nutation = Clock::new(per, start);
        let phases = turns.map(|turn| {
            let start = turn.start - turn.start.round();
            Clock::new(turn.rate.scaled(4.0), start.scaled(4.0))
        });
        let until = phases
            .iter()
            .fold(nutation.until(), |until, phase| until.min(phase.until()));
        let (sides, sense, rate) = oriented(a, b, wave, flipped);
        Some(Self {
            nutation,
            phases: phases[0].beside(&phases[1]),
            re: cubics(&sides[0].re, &sides[1].re),
            im: cubics(&sides[0].im, &sides[1].im),
            rate: cubics(&rate.re, &rate.im),
            sense,
            spin,
            until,
        })
    }

    /// z, and the phases of alpha and beta, while |t| is at most `until`.
    #[inline(always)]
    fn phases<L: Phased>(&self, t: L) -> (Reduced<L>, Reduced<L::Pair>) {
        let time = Time::new(t);
        let z = self.nutation.read(|v| L::of(*v), &time);
        (z, self.phases.read(L::Pair::both, &time.twice()))
    }

    #[inline(always)]
    fn axis<L: Phased>(&self, (z, phases): (Reduced<L>, Reduced<L::Pair>)) -> Axis<L> {
        let wave = unsigned_sincos_of(z);
        let (sin, _) = wave.parts();
        let k = L::of(2.0) - sin * 4.0 * sin;
        let re = wave * horner(&self.re, k);
        let im = wave.swapped() * horner(&self.im, k);
        let (first, second) = (re * re + im * im).parts();
        let scale = L::of(1.0) / (first + second).sqrt();
        let (sin, cos) = sincos_of(phases);
        let signed = scale.negative_if_half(z.whole);
        let both = L::Pair::new(signed, signed);
        Axis {
            re: (re * cos - im * sin) * both,
            im: (re * sin + im * cos) * both,
            wave,
            k,
            phase: [sin, cos],
            scale,
        }
    }

    /// The unit quaternion.
    #[inline(always)]
    fn quaternion_of<L: Phased>(axis: &Axis<L>) -> [L; 4] {
        let ((w, x), (z, y)) = (axis.re.parts(), axis.im.parts());
        [w, x, y, z]
    }

    #[inline(always)]
    fn rates_of<L: Phased>(&self, axis: &Axis<L>) -> [L; 3] {
        let wave = axis.wave;
        let (re, im) = (wave.swapped() * horner(&self.rate, axis.k)).parts();
        let (sin, cos) = wave.parts();
        let sin = sin * self.sense;
        let (re, im) = (re * cos - im * sin, re * sin + im * cos);
        // conj(e^{i psi_a}) e^{i psi_b}
        let [phase_sin, phase_cos] = axis.phase;
        let ((sin_a, sin_b), (cos_a, cos_b)) = (phase_sin.parts(), phase_cos.parts());
        let cos = cos_a * cos_b + sin_a * sin_b;
        let sin = cos_a * sin_b - sin_a * cos_b;
        [
            (re * cos - im * sin) * axis.scale,
            (re * sin + im * cos) * axis.scale,
            L::of(self.spin),
        ]
    }

    /// The unit quaternion at time `t`.
    #[inline(always)]
    pub fn quaternion<L: Phased>(&self, t: L) -> [L; 4] {
        Self::quaternion_of(&self.axis(self.phases(t)))
    }

    pub fn attitude(&self, t: f64) -> Attitude {
        Attitude::from_unit(if t.abs() <= self.until {
            self.quaternion(t)
        } else {
            self.far(t).0
        })
    }
}

impl Branchless for Sampler {
    fn until(&self) -> f64 {
        self.until
    }

    #[inline(always)]
    fn all<L: Phased>(&self, t: L) -> ([L; 4], [L; 3]) {
        let axis = self.axis(self.phases(t));
        (Self::quaternion_of(&axis), self.rates_of(&axis))
    }

    #[cold]
    fn far(&self, t: f64) -> ([f64; 4], [f64; 3]) {
        let phases = (self.nutation.read_far(t), self.phases.both_far(t));
        let axis = self.axis::<f64>(phases);
        (Self::quaternion_of(&axis), self.rates_of(&axis))
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
    let first = Factor {
        re: mirrored(&b.re, 1.0),
        im: mirrored(&b.im, -1.0),
    };
    let second = Factor {
        re: mirrored(&a.re, -1.0),
        im: mirrored(&a.im, 1.0),
    };
    let rate = Factor {
        re: mirrored(&rate.im, wave.sense),
        im: mirrored(&rate.re, -wave.sense),
    };
    ([first, second], -wave.sense, rate)
}

/// The polynomial in -k, times `sign`.
fn mirrored(p: &[f64; 4], sign: f64) -> [f64; 4] {
    [sign * p[0], -sign * p[1], sign * p[2], -sign * p[3]]
}
