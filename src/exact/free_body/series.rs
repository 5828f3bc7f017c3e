//! The theta series of the free body, in whichever of the two forms converges
//! fast: trigonometric in tau with nome q^2, or, by Jacobi's imaginary
//! transformation, hyperbolic with the complementary nome. Either nome is at
//! most exp(-pi) = 0.043, and four terms reach 1e-19.

use crate::math::DoubleDouble as Dd;
use crate::math::{Lane, exp, expm1, sincos_turns};

/// Real and imaginary parts of alpha and of beta.
pub(super) type Parts<L> = ([L; 2], [L; 2]);

/// theta_4(z + iy) and `ratio` theta_1(z + iy), up to a common real factor and a
/// phase linear in time.
#[derive(Debug, Clone)]
pub(super) enum Series {
    Trigonometric(Trigonometric),
    Hyperbolic(Hyperbolic),
}

/// Polynomials in sin^2 z.
#[derive(Debug, Clone)]
pub(super) struct Trigonometric {
    alpha: [[f64; 4]; 2],
    beta: [[f64; 4]; 2],
}

/// cos and sin of (2n+1) y', each with its power of the nome; w = `rate` t.
#[derive(Debug, Clone)]
pub(super) struct Hyperbolic {
    rate: f64,
    /// pi K/2K' = 2 w_max: the nome is exp of minus this.
    width: f64,
    alpha: [[f64; 4]; 2],
    beta: [[f64; 4]; 2],
}

impl Series {
    /// The series for quarter periods K, K' and zero at i eta, tau = `p` t, with
    /// |beta|/|alpha| = `ratio` at tau = 0; also the rate of arg theta_4 there, and
    /// what the linear phase dropped by the hyperbolic form adds over 2K.
    pub(super) fn new(quarter: Dd, conjugate: Dd, eta: Dd, p: Dd, ratio: Dd) -> (Self, Dd, Dd) {
        if conjugate.scaled(2.0) >= quarter {
            Self::trigonometric(quarter, conjugate, eta, p, ratio)
        } else {
            Self::hyperbolic(quarter, conjugate, eta, p, ratio)
        }
    }

    fn trigonometric(k: Dd, k1: Dd, eta: Dd, p: Dd, ratio: Dd) -> (Self, Dd, Dd) {
        let y = Dd::PI * eta / k.scaled(2.0);
        let width = Dd::TWO_PI * k1 / k;
        let nome = (-width).exp();
        // q^2 e^{+-2y}: the growth of the hyperbolic factors is bound to the nome's decay.
        let up = (y.scaled(2.0) - width).exp();
        let down = (-(y.scaled(2.0) + width)).exp();
        let mut sums = [Dd::ONE, Dd::ZERO]; // theta_4(iy) and the sum of its derivative
        let (mut a, mut b) = ([1.0, 0.0, 0.0, 0.0], [0.0; 4]);
        for n in 1..=8 {
            let order = f64::from(n);
            let common = power(nome, n * n - n);
            let (grown, decayed) = (common * power(up, n), common * power(down, n));
            let sign = alternating(n);
            sums[0] += (grown + decayed) * sign;
            sums[1] += (grown - decayed) * (-2.0 * sign * order);
            if n <= 3 {
                a[n as usize] = sign * (grown + decayed).to_f64();
                b[n as usize] = -sign * (grown - decayed).to_f64();
            }
        }
        let (mut c, mut d) = ([0.0; 4], [0.0; 4]);
        for n in 0..=3 {
            let common = alternating(n) * (power(nome, n * n) * power(up, n)).to_f64();
            // 1 -+ e^{-(4n+2)y} without cancellation for a needle, where y -> 0.
            let decay = expm1(-f64::from(4 * n + 2) * y.to_f64());
            c[n as usize] = common * (2.0 + decay);
            d[n as usize] = -common * decay;
        }
        let scale = ratio.to_f64() * a.iter().sum::<f64>() / d.iter().sum::<f64>();
        let (c, d) = (c.map(|x| x * scale), d.map(|x| x * scale));
        let series = Self::Trigonometric(Trigonometric {
            alpha: [
                [
                    a[0] + a[1] + a[2] + a[3],
                    -2.0 * a[1] - 8.0 * a[2] - 18.0 * a[3],
                    8.0 * a[2] + 48.0 * a[3],
                    -32.0 * a[3],
                ],
                [
                    2.0 * b[1] + 4.0 * b[2] + 6.0 * b[3],
                    -8.0 * b[2] - 32.0 * b[3],
                    32.0 * b[3],
                    0.0,
                ],
            ],
            beta: [
                [
                    c[0] + 3.0 * c[1] + 5.0 * c[2] + 7.0 * c[3],
                    -4.0 * c[1] - 20.0 * c[2] - 56.0 * c[3],
                    16.0 * c[2] + 112.0 * c[3],
                    -64.0 * c[3],
                ],
                [
                    d[0] + d[1] + d[2] + d[3],
                    -4.0 * d[1] - 12.0 * d[2] - 24.0 * d[3],
                    16.0 * d[2] + 80.0 * d[3],
                    -64.0 * d[3],
                ],
            ],
        });
        let rate = Dd::PI * p / k.scaled(2.0) * (sums[1] / sums[0]);
        (series, rate, Dd::ZERO)
    }

    fn hyperbolic(k: Dd, k1: Dd, eta: Dd, p: Dd, ratio: Dd) -> (Self, Dd, Dd) {
        let y = Dd::PI * eta / k1.scaled(4.0);
        let width = if k.is_finite() {
            Dd::PI * k / k1.scaled(2.0)
        } else {
            Dd::from(f64::INFINITY)
        };
        let nome = if k.is_finite() {
            (-width).exp()
        } else {
            Dd::ZERO
        };
        let mut sums = [Dd::ZERO; 2];
        let (mut alpha, mut beta) = ([[0.0; 4]; 2], [[0.0; 4]; 2]);
        let (mut alpha0, mut beta0) = (Dd::ZERO, Dd::ZERO);
        for n in 0..=7 {
            let odd = f64::from(2 * n + 1);
            let (sin, cos) = (y * odd).sin_cos();
            let weight = power(nome, n * n + n);
            sums[0] += weight * cos;
            sums[1] += weight * sin * odd;
            alpha0 += weight * cos;
            beta0 += weight * sin * alternating(n);
            if n <= 3 {
                // The sample supplies e^{2nw} q^n; q^(n^2) is left for here.
                let weight = power(nome, n * n);
                let i = n as usize;
                alpha[0][i] = (weight * cos).to_f64();
                alpha[1][i] = (weight * sin).to_f64();
                beta[0][i] = (weight * cos).to_f64() * alternating(n);
                beta[1][i] = (weight * sin).to_f64() * alternating(n);
            }
        }
        let scale = (ratio * alpha0 / beta0).to_f64();
        let beta = beta.map(|part| part.map(|x| x * scale));
        let series = Self::Hyperbolic(Hyperbolic {
            rate: (Dd::PI * p / k1.scaled(4.0)).to_f64(),
            width: width.to_f64(),
            alpha,
            beta,
        });
        let rate = Dd::PI * p / k1.scaled(4.0) * (sums[1] / sums[0]);
        (series, rate, Dd::PI * eta / k1.scaled(2.0))
    }
}

impl Trigonometric {
    /// The sums at this fraction of 2K from the turning point, -1/2 to 1/2.
    #[inline(always)]
    pub(super) fn sum<L: Lane>(&self, fraction: L) -> Parts<L> {
        let (sin, cos) = sincos_turns(fraction * 0.5);
        let x = sin * sin;
        (
            [poly(&self.alpha[0], x), sin * cos * poly(&self.alpha[1], x)],
            [sin * poly(&self.beta[0], x), cos * poly(&self.beta[1], x)],
        )
    }
}

impl Hyperbolic {
    /// The sums at time `t` from the turning point, within half a period.
    #[inline]
    pub(super) fn sum(&self, t: f64) -> Parts<f64> {
        let w = (self.rate * t).abs();
        // All scaled by e^{-w}: cosh -> 1 + e^{-2w}, sinh -> 1 - e^{-2w}.
        let minus = -expm1(-2.0 * w);
        let decay = 1.0 - minus;
        let growth = exp(2.0 * w - self.width);
        let (mut even, mut odd) = ([0.0; 4], [0.0; 4]);
        let (mut weight, mut power, mut differences) = (1.0, decay, minus);
        for n in 0..4 {
            even[n] = weight * (1.0 + power);
            odd[n] = weight * differences;
            weight *= growth;
            // 1 - E^{2n+3} = (1 - E^{2n+1}) + E^{2n+1} (1 - E)(1 + E).
            differences += power * minus * (1.0 + decay);
            power *= decay * decay;
        }
        let sign = if t < 0.0 { -1.0 } else { 1.0 };
        (
            [dot(&self.alpha[0], &even), sign * dot(&self.alpha[1], &odd)],
            [sign * dot(&self.beta[0], &odd), dot(&self.beta[1], &even)],
        )
    }
}

#[inline(always)]
fn poly<L: Lane>(c: &[f64; 4], x: L) -> L {
    x * (x * (x * c[3] + c[2]) + c[1]) + c[0]
}

#[inline]
fn dot(a: &[f64; 4], b: &[f64; 4]) -> f64 {
    a[0] * b[0] + (a[1] * b[1] + (a[2] * b[2] + a[3] * b[3]))
}

/// (-1)^n.
fn alternating(n: i32) -> f64 {
    if n % 2 == 0 { 1.0 } else { -1.0 }
}

/// `base` to a small whole power.
fn power(base: Dd, n: i32) -> Dd {
    (0..n).fold(Dd::ONE, |product, _| product * base)
}
