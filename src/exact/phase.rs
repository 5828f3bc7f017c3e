//! sn, cn and dn of an argument that grows steadily in time, fast: a set-up in
//! double-double arithmetic, samples in plain `f64` once the phase is reduced in pairs.
//!
//! Not for: a single value ([`super::jacobi`] has it, rounded once).
//!
//! The argument is counted from the nearest whole number of quarter periods K, so
//! |r| <= K/2, and what rounding r to an `f64` drops is handed back as `rest`: sn
//! keeps its relative accuracy around 0, cn around K, for any time. The four theta functions of
//! Neville, sn = s/n, cn = c/n, dn = d/n, run in the nome q for m <= 1/2 and, by Jacobi's imaginary
//! transformation, in the nome of the complement above. Either nome is at most exp(-pi) = 0.043,
//! and four terms reach 1e-19.
//!
//! Sources: E. H. Neville, *Jacobian Elliptic Functions*; DLMF 20.2, 22.2, 22.4(iii),
//! 22.6(iv).

use super::theta::{
    EVEN_COSINES, Multiples, ODD_COSINES, ODD_SINES, Periods, Waves, alternating, dot, horner,
};
use crate::math::{DoubleDouble as Dd, exp, sincos};

/// sn, cn, dn of `start + rate t`.
#[derive(Debug, Clone)]
pub(super) struct Phase {
    /// K, infinite for m = 1, and its reciprocal.
    pub(super) quarter: Dd,
    per_quarter: f64,
    /// Phase at t = 0: so many quarters, and the remainder.
    first: f64,
    start: Dd,
    rate: Dd,
    /// sqrt(1 - m).
    k1: f64,
    series: Series,
}

/// The functions at one time, all over a common positive factor `one`.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sample {
    /// Quarter periods nearest to the argument.
    pub(super) quarters: f64,
    pub(super) sn: f64,
    pub(super) cn: f64,
    pub(super) dn: f64,
    pub(super) one: f64,
    /// The exact argument less the one these values belong to; a few eps.
    pub(super) rest: f64,
}

#[derive(Debug, Clone)]
enum Series {
    /// z = `scale` r. s/sin z, c/cos z, d and n as polynomials in sin^2 z.
    Trigonometric { scale: Dd, terms: [[f64; 4]; 4] },
    /// w = `scale` r; the sums over n of q^(n^2) or q^(n^2-n) times powers of e^w,
    /// where q = exp(-`width`).
    Hyperbolic { scale: Dd, width: f64, terms: [[f64; 4]; 4] },
}

impl Phase {
    /// The phase that starts where sn : cn = `sin` : `cos` (any positive common
    /// factor), for the parameter `m` and its complement `m1`, and grows by `rate` a
    /// second.
    pub(super) fn new(sin: Dd, cos: Dd, m: Dd, m1: Dd, rate: Dd) -> Self {
        let periods = Periods::new(m, m1, 0.5);
        let k1 = m1.sqrt();
        // From a zero of cn, where that is nearer: there sc(r) = -cs(K + r)/k1.
        let (beyond, distance) = periods.nearer_end(sin.square(), cos.square());
        let (first, tangent) = if beyond {
            (if sin > 0.0 { 1.0 } else { -1.0 }, -cos / (k1 * sin))
        } else {
            (if cos < 0.0 { 2.0 } else { 0.0 }, sin / cos)
        };
        // A small tangent is the argument, and its square may be beyond the range of doubles.
        let start = if tangent.abs() < 1e-60 {
            tangent
        } else if tangent < 0.0 {
            -distance
        } else {
            distance
        };
        let quarter = periods.quarter;
        Self {
            quarter,
            per_quarter: quarter.recip().to_f64(),
            first,
            start,
            rate,
            k1: k1.to_f64(),
            series: Series::new(&periods),
        }
    }

    /// The functions `t` seconds after the start.
    pub(super) fn at(&self, t: f64) -> Sample {
        let mut r = self.start + self.rate * t;
        let mut quarters = self.first;
        if self.quarter.is_finite() {
            let n = (r.to_f64() * self.per_quarter).round();
            r -= self.quarter * n;
            quarters += n;
        }
        let ([s, c, d, n], rest) = self.series.neville(r);
        // One quarter on: sn(K+r) = cd, cn(K+r) = -k1 sd, dn(K+r) = k1 nd; two: -sn, -cn.
        let turn = quarters.rem_euclid(4.0);
        let sign = if turn < 2.0 { 1.0 } else { -1.0 };
        let [sn, cn, dn, one] = if turn % 2.0 == 0.0 {
            [sign * s, sign * c, d, n]
        } else {
            [sign * c, -sign * self.k1 * s, self.k1 * n, d]
        };
        Sample { quarters, sn, cn, dn, one, rest }
    }
}

impl Sample {
    /// Sine and cosine, over a common factor, of the amplitude less its
    /// `quarters` right angles.
    pub(super) fn amplitude_rest(&self) -> (f64, f64) {
        match self.quarters.rem_euclid(4.0) as u8 {
            0 => (self.sn, self.cn),
            1 => (-self.cn, self.sn),
            2 => (-self.sn, -self.cn),
            _ => (self.cn, -self.sn),
        }
    }
}

/// n(n+1), n^2 and n^2 - n for the first four terms.
const PRONIC: [i32; 4] = [0, 2, 6, 12];
const SQUARE: [i32; 4] = [0, 1, 4, 9];
const PRONIC_BELOW: [i32; 4] = [0, 0, 2, 6];

impl Series {
    fn new(periods: &Periods) -> Self {
        let (own, other) = if periods.hyperbolic {
            (periods.nome.quarter, periods.quarter)
        } else {
            (periods.quarter, periods.nome.conjugate())
        };
        let scale = Dd::FRAC_PI_2 / own;
        let width = if other.is_finite() { Dd::PI * other / own } else { Dd::from(f64::INFINITY) };
        let width = width.to_f64();
        let nome = exp(-width);
        let twice = |n: usize| if n == 0 { 1.0 } else { 2.0 };
        // The coefficients of theta_1, theta_2, theta_3, theta_4 at argument 0, each
        // normalised to s' = c = d = n = 1 there.
        let mut sums = [0.0; 4];
        for n in (0..4).rev() {
            let (pronic, square) = (power(nome, PRONIC[n]), power(nome, SQUARE[n]));
            sums[0] += alternating(n) * pronic * (2 * n + 1) as f64;
            sums[1] += pronic;
            sums[2] += twice(n) * square;
            sums[3] += twice(n) * square * alternating(n);
        }
        let per_scale = scale.recip().to_f64();
        let a = |k: usize, n: usize| match k {
            0 => alternating(n) * per_scale / sums[0],
            1 => 1.0 / sums[1],
            2 => twice(n) / sums[2],
            _ => twice(n) * alternating(n) / sums[3],
        };
        if !periods.hyperbolic {
            let weight = |k: usize, n: usize| {
                a(k, n) * power(nome, if k < 2 { PRONIC[n] } else { SQUARE[n] })
            };
            let mut terms = [[0.0; 4]; 4];
            for (k, polynomials) in MULTIPLES.iter().enumerate() {
                for n in (0..4).rev() {
                    for (term, p) in terms[k].iter_mut().zip(polynomials[n]) {
                        *term += weight(k, n) * p;
                    }
                }
            }
            // Exactly 1 where the sums are 1.
            for row in &mut terms[1..] {
                row[0] = 1.0;
            }
            terms[0][0] = per_scale;
            Self::Trigonometric { scale, terms }
        } else {
            // theta_1..4 of the complement are s, n, d, c; the sample supplies the rest
            // of each power of the nome.
            let mut terms = [[0.0; 4]; 4];
            for n in 0..4 {
                let (square, below) = (power(nome, SQUARE[n]), power(nome, PRONIC_BELOW[n]));
                terms[0][n] = a(0, n) * square;
                terms[1][n] = a(3, n) * below / twice(n);
                terms[2][n] = a(2, n) * below / twice(n);
                terms[3][n] = a(1, n) * square;
            }
            // cosh 0 = 1 needs no second exponential.
            terms[1][0] *= 0.5;
            terms[2][0] *= 0.5;
            Self::Hyperbolic { scale, width, terms }
        }
    }

    /// s, c, d, n at `r`, up to a common positive factor, and the rest of `r`.
    fn neville(&self, r: Dd) -> ([f64; 4], f64) {
        match self {
            Self::Trigonometric { scale, terms } => {
                let z = r * *scale;
                let (sin, cos) = sincos(z.hi());
                let x = sin * sin;
                let values = [
                    sin * horner(&terms[0], x),
                    cos * horner(&terms[1], x),
                    horner(&terms[2], x),
                    horner(&terms[3], x),
                ];
                (values, z.lo() / scale.hi())
            }
            Self::Hyperbolic { scale, width, terms } => {
                let argument = r * *scale;
                let w = argument.hi().abs();
                let waves = Waves::new(w, *width);
                let sign = if argument.hi() < 0.0 { -1.0 } else { 1.0 };
                let edge = 2.0 * exp(-w);
                let values = [
                    sign * dot(&terms[0], &waves.odd_sinh),
                    edge * dot(&terms[1], &waves.even_cosh),
                    edge * dot(&terms[2], &waves.even_cosh),
                    dot(&terms[3], &waves.odd_cosh),
                ];
                (values, argument.lo() / scale.hi())
            }
        }
    }
}

/// Of s, c, d and n.
const MULTIPLES: [Multiples; 4] = [ODD_SINES, ODD_COSINES, EVEN_COSINES, EVEN_COSINES];

/// `base` to a small whole power.
fn power(base: f64, n: i32) -> f64 {
    (0..n).fold(1.0, |product, _| product * base)
}
