//! The theta series of the free body, in whichever of the two forms converges
//! fast: trigonometric in tau with nome q^2, or, by Jacobi's imaginary
//! transformation, hyperbolic with the complementary nome. Either nome is at
//! most exp(-pi) = 0.043, and four terms reach 1e-19.

use crate::exact::nome::Nome;
use crate::exact::theta::{
    Across, EVEN_COSINES, EVEN_SINES, ODD_COSINES, ODD_SINES, Periods, Zero, alternating, collected,
};
use crate::math::DoubleDouble as Dd;

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
    pub(super) alpha: [[f64; 4]; 2],
    pub(super) beta: [[f64; 4]; 2],
}

/// Polynomials in k = 2 q cosh 2w, w = `rate` t.
#[derive(Debug, Clone)]
pub(super) struct Hyperbolic {
    pub(super) rate: Dd,
    /// q, the root of the complementary nome.
    pub(super) nome: f64,
    pub(super) alpha: [[f64; 4]; 2],
    pub(super) beta: [[f64; 4]; 2],
}

impl Series {
    /// The series for these periods and this zero, tau = `p` t, with |beta|/|alpha| = `ratio` at
    /// tau = 0. Also the rate of arg theta_4 there, and the growth over 2K of the linear phase that
    /// the hyperbolic form drops.
    pub(super) fn new(periods: &Periods, zero: &Zero, p: Dd, ratio: Dd) -> (Self, Dd, Dd) {
        let Periods { quarter, nome, .. } = periods;
        let angle = match zero {
            Zero::Across(zero) => return Self::trigonometric(*quarter, nome.q, zero, p, ratio),
            Zero::Along(angle) => angle.z,
        };
        // K' >= K/2, or pi K/K' <= 2 pi.
        if nome.quarter.scaled(2.0) < *quarter {
            return Self::hyperbolic(nome, angle, p, ratio);
        }
        let per_quarter = nome.quarter / *quarter;
        let q = (-(Dd::PI * per_quarter)).exp();
        let fall = -(-(angle * per_quarter).scaled(2.0)).exp_m1();
        let decay = 1.0 - fall;
        let rest = q / decay;
        let zero = Across { decay, fall, rest };
        Self::trigonometric(*quarter, q, &zero, p, ratio)
    }

    fn trigonometric(k: Dd, q: Dd, zero: &Across, p: Dd, ratio: Dd) -> (Self, Dd, Dd) {
        let nome = q.square();
        // q^2 e^{+-2y}: the growth of the hyperbolic factors is bound to the nome's decay.
        let (up, down) = (q * zero.rest, nome * zero.decay);
        let second = nome.square();
        let sixth = second.square() * second;
        // nome^(n^2-n) up^n and the same of down: three in double-double, three without.
        let (up2, down2) = (up.square(), down.square());
        let grown = [up, second * up2, sixth * up2 * up];
        let decayed = [down, second * down2, sixth * down2 * down];
        let mut sums = [Dd::ONE, Dd::ZERO]; // theta_4(iy) and the sum of its derivative
        let (mut a, mut b) = ([1.0, 0.0, 0.0, 0.0], [0.0; 4]);
        let (mut small, mut small_slope) = (0.0, 0.0);
        let (h, step) = (nome.hi(), second.hi());
        let (mut weight, mut factor) = (sixth.hi(), step * step * step);
        let (mut grow, mut decay) = (up2.hi() * up.hi(), down2.hi() * down.hi());
        for n in 4..=6 {
            weight *= factor;
            factor *= step;
            grow *= up.hi();
            decay *= down.hi();
            let sign = alternating(n as usize);
            small += sign * weight * (grow + decay);
            small_slope -= 2.0 * sign * f64::from(n) * weight * (grow - decay);
        }
        for n in 1..=3 {
            let (order, i) = (f64::from(n), n as usize);
            let (grown, decayed) = (grown[i - 1], decayed[i - 1]);
            let sign = alternating(i);
            let [sum, difference] = [grown.corrected(decayed), grown - decayed];
            sums[0] = sums[0].corrected(sum.scaled(sign));
            sums[1] = sums[1].corrected(difference * (-2.0 * sign * order));
            a[i] = sign * sum.to_f64();
            b[i] = -sign * difference.to_f64();
        }
        sums[0] = sums[0] + small;
        sums[1] = sums[1] + small_slope;
        // nome^(n^2) up^n.
        let weights =
            [1.0, h * up.hi(), step * step * up2.hi(), sixth.hi() * h * step * up2.hi() * up.hi()];
        let e = zero.decay.hi();
        let mut geometric = 1.0;
        let mut power = e;
        let (mut c, mut d) = ([0.0; 4], [0.0; 4]);
        for n in 0..=3 {
            let common = alternating(n as usize) * weights[n as usize];
            // 1 - E^{2n+1} = (1 - E)(1 + E + ... + E^{2n}): no cancellation for a needle, where
            // y -> 0.
            let fall = zero.fall.hi() * geometric;
            geometric += power + power * e;
            power *= e * e;
            c[n as usize] = common * (2.0 - fall);
            d[n as usize] = common * fall;
        }
        let scale = ratio.to_f64() * a.iter().sum::<f64>() / d.iter().sum::<f64>();
        let (c, d) = (c.map(|x| x * scale), d.map(|x| x * scale));
        let series = Self::Trigonometric(Trigonometric {
            alpha: [collected(&EVEN_COSINES, a), collected(&EVEN_SINES, b)],
            beta: [collected(&ODD_SINES, c), collected(&ODD_COSINES, d)],
        });
        let rate = Dd::PI * p / k.scaled(2.0) * (sums[1] / sums[0]);
        (series, rate, Dd::ZERO)
    }

    fn hyperbolic(own: &Nome, angle: Dd, p: Dd, ratio: Dd) -> (Self, Dd, Dd) {
        let k1 = own.quarter;
        let nome = own.q.sqrt();
        let (sin, cos) = angle.scaled(0.5).sin_cos();
        let (sin2, cos2) = ((sin * cos).scaled(2.0), 1.0 - sin.square().scaled(2.0));
        let (mut sin, mut cos) = (sin, cos);
        let mut sums = [Dd::ZERO; 2];
        let mut waves = [[Dd::ZERO; 4]; 2];
        let (mut alpha0, mut beta0) = (Dd::ZERO, Dd::ZERO);
        // q'^(n(n+1)), and q'^(n^2) and the next step for the samples.
        let (mut weight, mut inner, mut power) = (Dd::ONE, Dd::ONE, nome);
        for n in 0..=4 {
            let odd = f64::from(2 * n + 1);
            sums[0] += weight * cos;
            sums[1] += weight * sin * odd;
            alpha0 += weight * cos;
            beta0 += weight * sin * alternating(n as usize);
            if n <= 3 {
                // q^n goes with the powers of cosh 2w; q^(n^2) is left for here.
                let i = n as usize;
                waves[0][i] = inner * cos;
                waves[1][i] = inner * sin;
            }
            (sin, cos) = (sin * cos2 + cos * sin2, cos * cos2 - sin * sin2);
            inner = weight * power;
            weight = inner * power;
            power = power * nome;
        }
        let scale = ratio * alpha0 / beta0;
        let scaled = |wave: [Dd; 4]| {
            let [a, b, c, d] = wave.map(|x| x * scale);
            [a, -b, c, -d]
        };
        let [cos, sin] = waves;
        let series = Self::Hyperbolic(Hyperbolic {
            rate: Dd::PI * p / k1.scaled(4.0),
            nome: nome.to_f64(),
            alpha: [per_cosh(cos, nome.hi()), per_sinh(sin, nome.hi())],
            beta: [per_sinh(scaled(cos), nome.hi()), per_cosh(scaled(sin), nome.hi())],
        });
        let rate = Dd::PI * p / k1.scaled(4.0) * (sums[1] / sums[0]);
        (series, rate, angle)
    }
}

/// sum c_n q^n sinh((2n+1) w)/sinh w in powers of k = 2 q cosh 2w, its constant rounded once.
fn per_sinh([c0, c1, c2, c3]: [Dd; 4], q: f64) -> [f64; 4] {
    let [b, c, d] = [c1, c2, c3].map(Dd::hi);
    [(c0 + q * (b - q * (c + q * d))).to_f64(), b + q * (c - 2.0 * q * d), c + q * d, d]
}

/// The same of cosh((2n+1) w)/cosh w.
fn per_cosh(c: [Dd; 4], q: f64) -> [f64; 4] {
    let [c0, c1, c2, c3] = c;
    let [b, c, d] = [c1, c2, c3].map(Dd::hi);
    [(c0 - q * (b + q * (c - q * d))).to_f64(), b - q * (c + 2.0 * q * d), c - q * d, d]
}
