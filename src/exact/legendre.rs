//! Legendre's elliptic integrals: F, E, D, Pi for any real amplitude, and the
//! complete K, E, D, Pi.
//!
//! Not for: parameters outside 0 <= m <= 1, and principal values of Pi (n sin^2 phi > 1).
//!
//! The amplitude is reduced with pi to 159 bits and half-turns are counted, so sin phi and cos phi
//! are right to 106 bits even next to pi/2. The expression 1 - m sin^2 phi is formed as cos^2 + m1
//! sin^2 and 1 - n sin^2 phi as cos^2 + n1 sin^2, which do not cancel. The symmetric integrals are
//! taken in double-double arithmetic and the sum is rounded once.
//!
//! Sources: DLMF 19.2, 19.8, 19.21, 19.25; B. C. Carlson, Numer. Algorithms 10, 13 (1995).

use super::carlson::{rc_extended, rf_extended, rf_rd_extended, rf_rj_extended};
use super::modulus::{Characteristic, Modulus};
use crate::error::{Error, Result, finite};
use crate::math::DoubleDouble as Dd;

/// The complete integral of the first kind, a quarter period of sn.
///
/// K = int_0^(pi/2) dtheta / sqrt(1 - m sin^2 theta) = pi / (2 agm(1, k')).
///
/// # Errors
/// `OutOfRange` at m1 = 0, where K is infinite.
///
/// # Accuracy
/// Rounded once from 100 bits or more: at most half a unit in the last place. Cost: 60 `libm` sines.
///
/// ```
/// use rotation_dynamics::exact::{Modulus, legendre};
/// assert_eq!(legendre::k(Modulus::from_m(0.5)?)?, 1.8540746773013719);
/// # Ok::<(), rotation_dynamics::Error>(())
/// ```
pub fn k(modulus: Modulus) -> Result<f64> {
    not_one(modulus)?;
    Ok(complete_first(modulus).to_f64())
}

/// The complete integral of the second kind.
///
/// E = int_0^(pi/2) sqrt(1 - m sin^2 theta) dtheta; E(m=0) = pi/2, E(m=1) = 1.
///
/// # Accuracy
/// Rounded once from 100 bits or more: at most half a unit in the last place. Cost: 60 `libm` sines.
///
/// ```
/// use rotation_dynamics::exact::{Modulus, legendre};
/// assert_eq!(legendre::complete_e(Modulus::from_m(0.5)?), 1.3506438810476755);
/// # Ok::<(), rotation_dynamics::Error>(())
/// ```
pub fn complete_e(modulus: Modulus) -> f64 {
    complete_second(modulus).to_f64()
}

/// The complete integral D = (K - E)/m without the cancellation at small m.
///
/// D = int_0^(pi/2) sin^2 theta dtheta / sqrt(1 - m sin^2 theta) = R_D(0, m1, 1)/3; D(m=0) = pi/4.
///
/// # Errors
/// `OutOfRange` at m1 = 0, where D is infinite.
///
/// # Accuracy
/// Rounded once: at most half a unit in the last place. Cost: 300 `libm` sines.
pub fn complete_d(modulus: Modulus) -> Result<f64> {
    not_one(modulus)?;
    Ok(Amplitude::RIGHT_ANGLE.d(modulus).to_f64())
}

/// The complete integral of the third kind.
///
/// Pi(n | m) = int_0^(pi/2) dtheta / ((1 - n sin^2 theta) sqrt(1 - m sin^2 theta)).
///
/// # Errors
/// `OutOfRange` at m1 = 0 or n >= 1, where the integral is infinite or a principal value.
///
/// # Accuracy
/// As [`pi`].
pub fn complete_pi(characteristic: Characteristic, modulus: Modulus) -> Result<f64> {
    not_one(modulus)?;
    below_one(characteristic)?;
    Ok(Amplitude::RIGHT_ANGLE.pi(characteristic, modulus).to_f64())
}

/// The incomplete integral of the first kind.
///
/// F(phi | m) = int_0^phi dtheta / sqrt(1 - m sin^2 theta); odd in phi, F(phi + pi) = F(phi) + 2K.
///
/// `phi` (rad): any finite angle, |phi| <= 1e15.
///
/// # Errors
/// `NotFinite`; `OutOfRange` for |phi| > 1e15, and for |phi| > pi/2 at m1 = 0.
///
/// # Accuracy
/// Kit families of 2000 rows, median / P99 / max of the relative error in 2^-53:
/// m in [0, 1) 0.36 / 0.89 / 0.97; 1-m = 1e-16..1e-3, phi to 1e-15 below pi/2
/// 0.35 / 0.89 / 0.98. Rounded once: at most half a unit in the last place. Cost: 210 `libm` sines.
///
/// ```
/// use rotation_dynamics::exact::{Modulus, legendre};
/// let half = Modulus::from_m(0.5)?;
/// let turn = legendre::f(core::f64::consts::TAU, half)?;
/// assert!((turn - 4.0 * legendre::k(half)?).abs() < 1e-14);
/// # Ok::<(), rotation_dynamics::Error>(())
/// ```
pub fn f(phi: f64, modulus: Modulus) -> Result<f64> {
    let (halves, rest) = reduced(phi)?;
    if halves != 0.0 {
        not_one(modulus)?;
    }
    let within = rest.f(modulus);
    Ok(with_halves(halves, within, || complete_first(modulus)))
}

/// The incomplete integral of the second kind.
///
/// E(phi | m) = int_0^phi sqrt(1 - m sin^2 theta) dtheta; odd in phi, E(phi + pi) = E(phi) + 2E.
///
/// `phi` (rad): any finite angle, |phi| <= 1e15.
///
/// # Errors
/// `NotFinite`; `OutOfRange` for |phi| > 1e15.
///
/// # Accuracy
/// Kit families of 2000 rows, median / P99 / max of the relative error in 2^-53:
/// m in [0, 1) 0.34 / 0.90 / 0.98; 1-m = 1e-16..1e-3, phi to 1e-15 below pi/2
/// 0.36 / 0.98 / 1.00. Rounded once: at most half a unit in the last place. Cost: 250 `libm` sines.
pub fn e(phi: f64, modulus: Modulus) -> Result<f64> {
    let (halves, rest) = reduced(phi)?;
    let within = rest.e(modulus);
    Ok(with_halves(halves, within, || complete_second(modulus)))
}

/// The incomplete integral D = (F - E)/m without the cancellation at small m.
///
/// D(phi | m) = int_0^phi sin^2 theta dtheta / sqrt(1 - m sin^2 theta)
/// = sin^3 phi R_D(cos^2 phi, 1 - m sin^2 phi, 1)/3.
///
/// `phi` (rad): any finite angle, |phi| <= 1e15.
///
/// # Errors
/// As [`f`].
pub fn d(phi: f64, modulus: Modulus) -> Result<f64> {
    let (halves, rest) = reduced(phi)?;
    if halves != 0.0 {
        not_one(modulus)?;
    }
    let within = rest.d(modulus);
    Ok(with_halves(halves, within, || Amplitude::RIGHT_ANGLE.d(modulus)))
}

/// The incomplete integral of the third kind.
///
/// Pi(n; phi | m) = int_0^phi dtheta / ((1 - n sin^2 theta) sqrt(1 - m sin^2 theta)); odd in phi.
///
/// `phi` (rad): any finite angle, |phi| <= 1e15, for n >= 1 only where n sin^2 phi < 1
/// on the whole path.
///
/// # Errors
/// `NotFinite`; `OutOfRange` for |phi| > 1e15, for a path that reaches n sin^2 phi = 1,
/// and for |phi| > pi/2 at m1 = 0.
///
/// # Accuracy
/// Kit families of 2000 rows, median / P99 / max of the relative error in 2^-53:
/// n in (-1, 1) 0.35 / 0.89 / 0.99; 1-n = 1e-16..1e-3 0.34 / 0.89 / 0.97; -n = 10..1e16
/// 0.36 / 0.91 / 1.00; -n = 1e16..1e150 0.35 / 0.90 / 0.99. For n > 1 the pole is as
/// near as 1 - n sin^2 phi. Cost: 400 to 500 `libm` sines.
///
/// ```
/// use rotation_dynamics::exact::{Characteristic, Modulus, legendre};
/// let n = Characteristic::from_n(-1.0 / 3.0)?;
/// // 1 - m = 1e-40: next to the separatrix, where m itself is 1.
/// let pi = legendre::pi(n, 1.5, Modulus::from_m1(1e-40)?)?;
/// assert_eq!(pi, 2.731763093471559);
/// # Ok::<(), rotation_dynamics::Error>(())
/// ```
pub fn pi(characteristic: Characteristic, phi: f64, modulus: Modulus) -> Result<f64> {
    let (halves, rest) = reduced(phi)?;
    if halves != 0.0 {
        not_one(modulus)?;
        below_one(characteristic)?;
    }
    if rest.pole_gap(characteristic) <= 0.0 {
        return Err(Error::out_of_range(
            "n",
            characteristic.n(),
            "n sin^2 phi must be less than 1",
        ));
    }
    let within = rest.pi(characteristic, modulus);
    Ok(with_halves(halves, within, || Amplitude::RIGHT_ANGLE.pi(characteristic, modulus)))
}

/// An amplitude in [-pi/2, pi/2] by its sine and cosine, each with relative accuracy.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Amplitude {
    sin: Dd,
    cos: Dd,
}

impl Amplitude {
    pub(crate) const RIGHT_ANGLE: Self = Self { sin: Dd::ONE, cos: Dd::ZERO };

    /// sin^2, cos^2 and 1 - m sin^2.
    fn squares(&self, modulus: Modulus) -> (Dd, Dd, Dd) {
        let (s2, c2) = (self.sin.square(), self.cos.square());
        (s2, c2, c2 + modulus.m1_extended() * s2)
    }

    /// 1 - n sin^2.
    fn pole_gap(&self, n: Characteristic) -> Dd {
        self.cos.square() + n.n1_extended() * self.sin.square()
    }

    fn f(&self, modulus: Modulus) -> Dd {
        let (_, c2, w) = self.squares(modulus);
        self.sin * rf_extended(c2, w, Dd::ONE)
    }

    fn e(&self, modulus: Modulus) -> Dd {
        let (s2, c2, w) = self.squares(modulus);
        if w == 0.0 {
            return self.sin;
        }
        // E = F - m D: as m -> 1 this cancels by the factor F, at most 400, out of 2^66.
        let (rf, rd) = rf_rd_extended(c2, w, Dd::ONE);
        self.sin * (rf - modulus.m_extended() * s2 * rd / 3.0)
    }

    fn d(&self, modulus: Modulus) -> Dd {
        let (s2, c2, w) = self.squares(modulus);
        self.sin * s2 * rf_rd_extended(c2, w, Dd::ONE).1 / 3.0
    }

    fn pi(&self, characteristic: Characteristic, modulus: Modulus) -> Dd {
        let (s2, c2, w) = self.squares(modulus);
        let n = characteristic.n_extended();
        let p = self.pole_gap(characteristic);
        if n >= -1.0 {
            let (rf, rj) = rf_rj_extended(c2, w, Dd::ONE, p);
            return self.sin * (rf + n * s2 * rj / 3.0);
        }
        // Below -1 the two terms cancel by sqrt(-n). The second integral with
        // (q-1)(p-1) = m sin^4 has two positive terms instead (DLMF 19.21.12 with x = 1).
        let excess = -(modulus.m_extended() * s2) / n;
        let q = excess + 1.0;
        let rj = rf_rj_extended(c2, w, Dd::ONE, q).1;
        let (xi, eta) = (c2 * w, p * q);
        let rc = rc_extended(self.cos * w.sqrt(), eta.sqrt(), eta - xi);
        self.sin * (excess * rj / 3.0 + rc)
    }
}

/// The number of half-turns nearest to phi, and the amplitude that remains.
fn reduced(phi: f64) -> Result<(f64, Amplitude)> {
    finite("phi", phi)?;
    if phi.abs() > 1e15 {
        return Err(Error::out_of_range("phi", phi, "its size must not exceed 1e15"));
    }
    let quarters = (phi * core::f64::consts::FRAC_2_PI).round();
    // The rest keeps relative accuracy next to multiples of pi/2: the first
    // product is exact, and so is its difference from phi.
    let rest = Dd::from(phi) - Dd::product(quarters, PI_2_PARTS[0]);
    let rest = rest - Dd::product(quarters, PI_2_PARTS[1]) - quarters * PI_2_PARTS[2];
    let (sin, cos) = rest.sin_cos();
    if quarters.rem_euclid(2.0) == 0.0 {
        return Ok((quarters / 2.0, Amplitude { sin, cos }));
    }
    // Between two multiples of pi: count from the nearer one.
    Ok(if sin > 0.0 {
        let amplitude = Amplitude { sin: -cos, cos: sin };
        ((quarters + 1.0) / 2.0, amplitude)
    } else {
        let amplitude = Amplitude { sin: cos, cos: -sin };
        ((quarters - 1.0) / 2.0, amplitude)
    })
}

/// pi/2 in three parts.
const PI_2_PARTS: [f64; 3] =
    [core::f64::consts::FRAC_PI_2, 6.123_233_995_736_766e-17, -1.497_384_904_859_169_8e-33];

fn with_halves(halves: f64, within: Dd, complete: impl FnOnce() -> Dd) -> f64 {
    if halves == 0.0 { within.to_f64() } else { (complete() * (2.0 * halves) + within).to_f64() }
}

/// K in double-double arithmetic; m1 > 0.
pub(crate) fn complete_first(modulus: Modulus) -> Dd {
    let (mut a, mut b) = (Dd::ONE, modulus.k1_extended());
    // The difference squares in each step; below 1e-17 of a, one more mean is exact.
    while (a - b).abs().to_f64() > 1e-17 * a.to_f64() {
        (a, b) = ((a + b).scaled(0.5), (a * b).sqrt());
    }
    Dd::FRAC_PI_2 / (a + b).scaled(0.5)
}

/// E in double-double arithmetic: K (1 - sum of 2^(i-1) c_i^2), DLMF 19.8.6.
fn complete_second(modulus: Modulus) -> Dd {
    if modulus.m1_extended() == 0.0 {
        return Dd::ONE;
    }
    let (mut a, mut b) = (Dd::ONE, modulus.k1_extended());
    let mut sum = modulus.m_extended().scaled(0.5);
    let mut weight = 1.0;
    // As m -> 1 the bracket cancels by the factor K, at most 400, out of 2^100.
    while (a - b).abs().to_f64() > 1e-17 * a.to_f64() {
        let c = (a - b).scaled(0.5);
        sum += c.square().scaled(weight);
        weight *= 2.0;
        (a, b) = ((a + b).scaled(0.5), (a * b).sqrt());
    }
    Dd::FRAC_PI_2 / (a + b).scaled(0.5) * (Dd::ONE - sum)
}

fn not_one(modulus: Modulus) -> Result<()> {
    if modulus.m1_extended() > 0.0 {
        Ok(())
    } else {
        Err(Error::out_of_range(
            "m1",
            modulus.m1(),
            "it must be greater than 0: the integral is infinite at m = 1",
        ))
    }
}

fn below_one(characteristic: Characteristic) -> Result<()> {
    if characteristic.n1_extended() > 0.0 {
        Ok(())
    } else {
        Err(Error::out_of_range(
            "n",
            characteristic.n(),
            "it must be less than 1 if the path passes pi/2",
        ))
    }
}
