//! Jacobi's elliptic functions sn, cn, dn and the amplitude am, for any real
//! argument and 0 <= m <= 1.
//!
//! Not for: complex arguments; motions whose set-up needs the theta functions
//! themselves (see [`super::free_body`]).
//!
//! [`Jacobi`] is set up once for a modulus and then evaluated at many arguments.
//! The theta series run in the nome q or, for m > 1/2, in the nome of the
//! complement (Jacobi's imaginary transformation), so the nome never exceeds
//! e^-pi = 0.043 and four terms suffice. Phase and leading terms are
//! double-double, the tails plain `f64`; each value is rounded once.
//!
//! Sources: DLMF 20.2, 22.2, 22.4, 22.6, 22.16; E. T. Whittaker, G. N. Watson,
//! *A Course of Modern Analysis*, 21, 22.

use super::legendre::complete_first;
use super::modulus::Modulus;
use crate::error::{Error, Result, finite};
use crate::math::DoubleDouble as Dd;

/// The functions sn, cn, dn, am of one modulus.
///
/// ```
/// use rotation_dynamics::exact::{Modulus, jacobi::Jacobi};
/// let functions = Jacobi::new(Modulus::from_m(0.5)?);
/// let (sn, cn, dn) = functions.sn_cn_dn(1.0)?;
/// assert_eq!((sn, cn, dn), (0.8030018248956439, 0.5959765676721407, 0.8231610016315962));
/// # Ok::<(), rotation_dynamics::Error>(())
/// ```
#[derive(Debug, Clone, Copy)]
pub struct Jacobi {
    modulus: Modulus,
    regime: Regime,
    quarter: Dd,
}

/// Which series converges fast.
#[derive(Debug, Clone, Copy)]
enum Regime {
    /// m <= 1/2: theta functions of z = pi u / 2K in the nome q.
    Circular(Series),
    /// m > 1/2: theta functions of i v, v = pi u / 2K', in the nome of m1.
    Hyperbolic(Series),
    /// m = 1: tanh and sech.
    Limit,
}

/// The nome and what depends on the modulus alone.
#[derive(Debug, Clone, Copy)]
struct Series {
    /// pi/2K, or pi/2K' if hyperbolic.
    rate: Dd,
    /// 2 q
    twice_nome: Dd,
    q2: f64,
    /// 2 q^4
    twice_q4: f64,
    q6: f64,
    /// 2 q^9
    twice_q9: f64,
    q12: f64,
    /// theta_i(0) / theta_j(0) by its two indices; theta_2 is without 2 q^(1/4).
    over_23: Dd,
    over_24: Dd,
    over_32: Dd,
    over_34: Dd,
    over_42: Dd,
    over_43: Dd,
}

impl Jacobi {
    /// Sets up the series for a modulus.
    pub fn new(modulus: Modulus) -> Self {
        if modulus.m1_extended() == 0.0 {
            return Self { modulus, regime: Regime::Limit, quarter: Dd::from(f64::INFINITY) };
        }
        let quarter = complete_first(modulus);
        if modulus.m_extended() == 0.0 {
            let series = Series::new(quarter, Dd::ZERO);
            return Self { modulus, regime: Regime::Circular(series), quarter };
        }
        let other = complete_first(modulus.complement());
        let regime = if modulus.m_extended() <= 0.5 {
            Regime::Circular(Series::new(quarter, (-(Dd::PI * other) / quarter).exp()))
        } else {
            Regime::Hyperbolic(Series::new(other, (-(Dd::PI * quarter) / other).exp()))
        };
        Self { modulus, regime, quarter }
    }

    /// The modulus.
    pub fn modulus(&self) -> Modulus {
        self.modulus
    }

    /// K, a quarter of the period of sn and cn; infinite at m = 1.
    pub fn quarter_period(&self) -> f64 {
        self.quarter.to_f64()
    }

    /// sn, cn and dn of `u`.
    ///
    /// sn = sin am, cn = cos am, dn = sqrt(1 - m sn^2), where u = F(am | m).
    ///
    /// `u`: any finite number with |u| <= 1e15 K.
    ///
    /// # Errors
    /// `NotFinite`; `OutOfRange` for |u| > 1e15 K.
    ///
    /// # Accuracy
    /// Kit families of 2000 rows, median / P99 / max of
    /// |error| / (2^-53 (|value| + |u d(value)/du|)), from m:
    ///
    /// | rows | median | P99 | max |
    /// |---|---|---|---|
    /// | m in [0, 1), abs(u) <= K | 0.34 | 0.56 | 0.72 |
    /// | 1-m = 1e-16..1e-3, abs(u) <= K | 0.27 | 0.49 | 0.59 |
    /// | m = 1e-300..1e-3, abs(u) <= K | 0.27 | 0.48 | 0.51 |
    /// | m in 0.05..0.95, abs(u) <= 1e4 K | 0.013 | 0.44 | 0.64 |
    /// | 1-m = 1e-16..1e-3, abs(u) <= 100 K | 0.12 | 0.49 | 0.50 |
    /// | m1 = 1e-300..1e-3, abs(u) <= K | 0.01 | 0.46 | 0.48 |
    ///
    /// Given k, and with other seeds, up to 0.87; for |u| <= K the plain relative error is at
    /// most 0.99 as well: rounded once, half a unit in the last place.
    /// Cost: 50 to 150 `libm` sines a sample, 270 the set-up.
    pub fn sn_cn_dn(&self, u: f64) -> Result<(f64, f64, f64)> {
        let (_, [sn, cn, dn]) = self.evaluate(u)?;
        Ok((sn.to_f64(), cn.to_f64(), dn.to_f64()))
    }

    /// The amplitude: the continuous angle whose sine is sn and whose rate is dn;
    /// am(u + 2K) = am(u) + pi.
    ///
    /// `u`: as for [`Self::sn_cn_dn`].
    ///
    /// # Errors
    /// As [`Self::sn_cn_dn`].
    ///
    /// # Accuracy
    /// Rounded once. Cost: 260 `libm` sines.
    pub fn am(&self, u: f64) -> Result<f64> {
        let (halves, [sn, cn, _]) = self.evaluate(u)?;
        // Back to the half-turn around zero, where the cosine is not negative.
        let sign = if halves.rem_euclid(2.0) == 0.0 { 1.0 } else { -1.0 };
        let rest = (sn * sign).atan2(cn * sign);
        Ok((Dd::PI * halves + rest).to_f64())
    }

    /// The number of half periods 2K nearest to u, and sn, cn, dn at u.
    fn evaluate(&self, u: f64) -> Result<(f64, [Dd; 3])> {
        finite("u", u)?;
        if u.abs() > 1e15 * self.quarter_period() {
            return Err(Error::out_of_range(
                "u",
                u,
                "its size must not exceed 1e15 quarter periods",
            ));
        }
        let u = Dd::from(u);
        match &self.regime {
            Regime::Limit => {
                // In e^-|u|, which underflows where sech does and never overflows.
                let grown = u.abs().scaled(-2.0).exp_m1();
                let (decay, whole) = ((-u.abs()).exp(), grown + 2.0);
                let (tanh, sech) = (-grown / whole, decay.scaled(2.0) / whole);
                let tanh = if u < 0.0 { -tanh } else { tanh };
                Ok((0.0, [tanh, sech, sech]))
            }
            Regime::Circular(series) => {
                let (halves, rest) = self.half_periods(u);
                Ok((halves, signed(halves, series.circular(rest))))
            }
            Regime::Hyperbolic(series) => {
                let (halves, rest) = self.half_periods(u);
                let size = rest.abs();
                let far = size > self.quarter.scaled(0.5);
                // Nearer to K than to 0, the argument is counted back from K; the
                // difference of the pairs is exact enough for cn's zero.
                let near = if far { self.quarter - size } else { size };
                let [sn, cn, dn] = if far {
                    series.before_quarter(near, self.modulus.k1_extended())
                } else {
                    series.hyperbolic(near)
                };
                let sn = if rest < 0.0 { -sn } else { sn };
                Ok((halves, signed(halves, [sn, cn, dn])))
            }
        }
    }

    fn half_periods(&self, u: Dd) -> (f64, Dd) {
        let period = self.quarter.scaled(2.0);
        let halves = (u.to_f64() / period.to_f64()).round();
        (halves, u - period * halves)
    }
}

/// sn, cn and dn for one argument: [`Jacobi::sn_cn_dn`] with its set-up.
///
/// # Errors
/// As [`Jacobi::sn_cn_dn`].
pub fn sn_cn_dn(u: f64, modulus: Modulus) -> Result<(f64, f64, f64)> {
    Jacobi::new(modulus).sn_cn_dn(u)
}

/// The amplitude for one argument: [`Jacobi::am`] with its set-up.
///
/// # Errors
/// As [`Jacobi::am`].
pub fn am(u: f64, modulus: Modulus) -> Result<f64> {
    Jacobi::new(modulus).am(u)
}

impl Series {
    fn new(quarter: Dd, nome: Dd) -> Self {
        let q = nome.to_f64();
        let square = nome.square();
        let (q2, q4) = (square.to_f64(), square.square());
        let (q6, q9) = (q4.to_f64() * q2, q4.to_f64() * q4.to_f64() * q);
        let even = q4.scaled(2.0) + 1.0;
        let odd = nome.scaled(2.0) + 2.0 * q9;
        let (theta3, theta4) = (even + odd, even - odd);
        let theta2 = square + q6 + q6 * q6 + 1.0;
        let (per2, per3, per4) = (theta2.recip(), theta3.recip(), theta4.recip());
        Self {
            rate: Dd::FRAC_PI_2 / quarter,
            twice_nome: nome.scaled(2.0),
            q2,
            twice_q4: 2.0 * q4.to_f64(),
            q6,
            twice_q9: 2.0 * q9,
            q12: q6 * q6,
            over_23: theta2 * per3,
            over_24: theta2 * per4,
            over_32: theta3 * per2,
            over_34: theta3 * per4,
            over_42: theta4 * per2,
            over_43: theta4 * per3,
        }
    }

    /// sn, cn, dn = theta quotients at z (DLMF 22.2.4-6), |z| <= pi/2.
    fn circular(&self, u: Dd) -> [Dd; 3] {
        let (sin, cos) = (u * self.rate).sin_cos();
        // Chebyshev: sin 3z / sin z = 2c + 1, sin 5z / sin z = 4c^2 + 2c - 1, with c = cos 2z.
        let twofold = (cos - sin) * (cos + sin);
        let c = twofold.to_f64();
        let sin_tail = self.q2 * (-(2.0 * c + 1.0)) + self.q6 * (4.0 * c * c + 2.0 * c - 1.0)
            - self.q12 * (8.0 * c * c * c + 4.0 * c * c - 4.0 * c - 1.0);
        let cos_tail = self.q2 * (2.0 * c - 1.0)
            + self.q6 * (4.0 * c * c - 2.0 * c - 1.0)
            + self.q12 * (8.0 * c * c * c - 4.0 * c * c - 4.0 * c + 1.0);
        let even = self.twice_q4 * (2.0 * c * c - 1.0);
        let odd = self.twice_nome * twofold + self.twice_q9 * (4.0 * c * c - 3.0) * c;
        let theta3 = odd + even + 1.0;
        let theta4 = Dd::ONE + even - odd;
        let theta1 = sin + sin * sin_tail;
        let theta2 = cos + cos * cos_tail;
        let scale = theta4.recip();
        [
            self.over_32 * theta1 * scale,
            self.over_42 * theta2 * scale,
            self.over_43 * theta3 * scale,
        ]
    }

    /// sn, cn, dn by Jacobi's imaginary transformation, 0 <= u <= K/2.
    fn hyperbolic(&self, u: Dd) -> [Dd; 3] {
        let [theta1, theta2, theta3, theta4] = self.imaginary(u);
        let scale = theta2.recip();
        [
            self.over_34 * theta1 * scale,
            self.over_24 * theta4 * scale,
            self.over_23 * theta3 * scale,
        ]
    }

    /// sn, cn, dn at K - w, 0 <= w <= K/2: cd, k' sd and k' nd of w.
    fn before_quarter(&self, w: Dd, k1: Dd) -> [Dd; 3] {
        let [theta1, theta2, theta3, theta4] = self.imaginary(w);
        let scale = theta3.recip();
        let common = k1 * self.over_32 * scale;
        [self.over_34 * theta4 * scale, common * self.over_34 * theta1, common * theta2]
    }

    /// theta_1/i, theta_2 (both over 2 q^(1/4)), theta_3, theta_4 at i v.
    fn imaginary(&self, u: Dd) -> [Dd; 4] {
        let v = u * self.rate;
        let (sinh, cosh) = v.sinh_cosh();
        // q cosh 2v is at most sqrt(q)/2 here; cosh 4v and up are tails.
        let twofold = cosh.square() + sinh.square();
        let nome_c = self.twice_nome * twofold;
        // Each power of q goes with a power of c = cosh 2v, so that nothing overflows.
        let c = twofold.to_f64();
        let q = self.twice_nome.to_f64() * 0.5;
        let (q2, qc) = (q * q, q * c);
        let (q4, q9) = (q2 * q2, q2 * q2 * q2 * q2 * q);
        let sin_tail = -q * (2.0 * qc + q) + q4 * (4.0 * qc * qc + 2.0 * qc * q - q2)
            - q9 * (8.0 * qc * qc * qc + 4.0 * qc * qc * q - 4.0 * qc * q2 - q2 * q);
        let cos_tail = q * (2.0 * qc - q)
            + q4 * (4.0 * qc * qc - 2.0 * qc * q - q2)
            + q9 * (8.0 * qc * qc * qc - 4.0 * qc * qc * q - 4.0 * qc * q2 + q2 * q);
        let even = 2.0 * q2 * (2.0 * qc * qc - q2);
        let odd = nome_c + 2.0 * q2 * q2 * q2 * (4.0 * qc * qc - 3.0 * q2) * qc;
        [sinh + sinh * sin_tail, cosh + cosh * cos_tail, odd + even + 1.0, Dd::ONE + even - odd]
    }
}

fn signed(halves: f64, [sn, cn, dn]: [Dd; 3]) -> [Dd; 3] {
    if halves.rem_euclid(2.0) == 0.0 { [sn, cn, dn] } else { [-sn, -cn, dn] }
}
