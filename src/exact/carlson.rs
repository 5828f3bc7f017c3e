//! Carlson's symmetric elliptic integrals R_F, R_C, R_D, R_J of real arguments.
//!
//! Not for: Cauchy principal values (R_C with y < 0, R_J with p < 0) and complex
//! arguments.
//!
//! Each is computed by Carlson's duplication in double-double arithmetic and
//! rounded once, so an answer is off by half a unit in the last place. Every
//! intermediate is a sum of positive terms; the arguments are scaled by a power
//! of four first. The last terms of the duplication are a Taylor polynomial in
//! deviations below 1/400, for which plain `f64` is enough.
//!
//! Sources: B. C. Carlson, Numer. Algorithms 10, 13 (1995); DLMF 19.16, 19.20,
//! 19.26, 19.36.

use crate::error::{Error, Result, finite};
use crate::math::{DoubleDouble as Dd, ilogb, ldexp};

/// R_F, Carlson's integral of the first kind.
///
/// R_F(x, y, z) = 1/2 int_0^inf dt / sqrt((t+x)(t+y)(t+z)), symmetric, of degree -1/2.
///
/// `x`, `y`, `z`: not negative, at most one of them zero; the others may differ by
/// a factor of 1e300. Special cases: R_F(x, x, x) = 1/sqrt(x), R_F(x, y, y) = R_C(x, y).
///
/// # Errors
/// `NotFinite`; `OutOfRange` for a negative argument, a second zero, or too great a ratio.
///
/// # Accuracy
/// Kit families of 2000 rows, median / P99 / max of the relative error in 2^-53:
/// arguments 1e-3..1e3 0.34 / 0.88 / 0.96, arguments 1e-150..1e150 0.34 / 0.89 / 0.98:
/// rounded once, at most half a unit in the last place. Cost: 120 to 250 `libm` sines.
///
/// ```
/// let rf = rotation_dynamics::exact::carlson::rf(1.0, 2.0, 0.0)?;
/// assert_eq!(rf, 1.3110287771460598); // Carlson (1995), section 3, has 14 digits
/// # Ok::<(), rotation_dynamics::Error>(())
/// ```
pub fn rf(x: f64, y: f64, z: f64) -> Result<f64> {
    let scaling = Scaling::new([("x", x), ("y", y), ("z", z)], &[])?;
    let [x, y, z] = scaling.scaled([x, y, z]);
    scaling.unscaled(rf_extended(x, y, z), -1)
}

/// R_C, the degenerate case R_C(x, y) = R_F(x, y, y): an arc tangent or a logarithm.
///
/// R_C(x, y) = atan(sqrt((y-x)/x)) / sqrt(y-x) for x < y,
/// atanh(sqrt((x-y)/x)) / sqrt(x-y) for x > y, 1/sqrt(x) for x = y.
///
/// `x` >= 0, `y` > 0; they may differ by a factor of 1e300.
///
/// # Errors
/// `NotFinite`; `OutOfRange` for x < 0, y <= 0, or too great a ratio.
///
/// # Accuracy
/// As [`rf`]: 0.35 / 0.89 / 0.97 and 0.34 / 0.88 / 1.00. Cost: 60 `libm` sines.
///
/// ```
/// let rc = rotation_dynamics::exact::carlson::rc(0.0, 0.25)?;
/// assert_eq!(rc, core::f64::consts::PI); // Carlson (1995), section 3
/// # Ok::<(), rotation_dynamics::Error>(())
/// ```
pub fn rc(x: f64, y: f64) -> Result<f64> {
    let scaling = Scaling::new([("x", x), ("y", y)], &["y"])?;
    let [x, y] = scaling.scaled([x, y]);
    scaling.unscaled(rc_extended(x.sqrt(), y.sqrt(), y - x), -1)
}

/// R_D, the degenerate case R_D(x, y, z) = R_J(x, y, z, z): an integral of the second kind.
///
/// R_D(x, y, z) = 3/2 int_0^inf dt / (sqrt((t+x)(t+y)) (t+z)^(3/2)), of degree -3/2.
///
/// `x`, `y` >= 0, at most one of them zero; `z` > 0; ratios up to 1e300.
///
/// # Errors
/// `NotFinite`; `OutOfRange` for a negative argument, x = y = 0, z = 0, too great
/// a ratio, or a result that is no `f64`.
///
/// # Accuracy
/// As [`rf`]: 0.34 / 0.86 / 0.96 and 0.35 / 0.89 / 0.95. Cost: 190 `libm` sines.
///
/// ```
/// let rd = rotation_dynamics::exact::carlson::rd(0.0, 2.0, 1.0)?;
/// assert_eq!(rd, 1.7972103521033884); // Carlson (1995), section 3, has 14 digits
/// # Ok::<(), rotation_dynamics::Error>(())
/// ```
pub fn rd(x: f64, y: f64, z: f64) -> Result<f64> {
    let scaling = Scaling::new([("x", x), ("y", y), ("z", z)], &["z"])?;
    let [x, y, z] = scaling.scaled([x, y, z]);
    scaling.unscaled(rf_rd_extended(x, y, z).1, -3)
}

/// R_J, Carlson's integral of the third kind.
///
/// R_J(x, y, z, p) = 3/2 int_0^inf dt / (sqrt((t+x)(t+y)(t+z)) (t+p)), symmetric in
/// x, y, z, of degree -3/2.
///
/// `x`, `y`, `z` >= 0, at most one of them zero; `p` > 0; ratios up to 1e300.
///
/// # Errors
/// `NotFinite`; `OutOfRange` for a negative argument, a second zero, p <= 0, too
/// great a ratio, or a result that is no `f64`.
///
/// # Accuracy
/// As [`rf`]: 0.35 / 0.86 / 0.99 and 0.35 / 0.88 / 0.99; with p = 1e-150..1e-5
/// 0.34 / 0.89 / 0.98, with p = 1e5..1e150 0.34 / 0.88 / 0.98. Cost: 700 `libm` sines.
///
/// ```
/// let rj = rotation_dynamics::exact::carlson::rj(0.0, 1.0, 2.0, 3.0)?;
/// assert_eq!(rj, 0.7768862377858233); // Carlson (1995), section 3
/// # Ok::<(), rotation_dynamics::Error>(())
/// ```
pub fn rj(x: f64, y: f64, z: f64, p: f64) -> Result<f64> {
    let scaling = Scaling::new([("x", x), ("y", y), ("z", z), ("p", p)], &["p"])?;
    let [x, y, z, p] = scaling.scaled([x, y, z, p]);
    scaling.unscaled(rf_rj_extended(x, y, z, p).1, -3)
}

/// Arguments are multiplied by 4^-`exponent`, which brings the largest near 1.
struct Scaling {
    exponent: i32,
    largest: (&'static str, f64),
}

impl Scaling {
    fn new<const N: usize>(
        arguments: [(&'static str, f64); N],
        not_zero: &[&'static str],
    ) -> Result<Self> {
        let refused = |(name, value), allowed| Err(Error::out_of_range(name, value, allowed));
        let mut largest = arguments[0];
        let mut zero_before = false;
        for (name, value) in arguments {
            finite(name, value)?;
            if value < 0.0 {
                return refused((name, value), "it must not be negative");
            }
            if value == 0.0 {
                if not_zero.contains(&name) {
                    return refused((name, value), "it must be greater than 0");
                }
                if zero_before {
                    return refused((name, value), "only one argument may be 0");
                }
                zero_before = true;
            }
            if value > largest.1 {
                largest = (name, value);
            }
        }
        for (name, value) in arguments {
            if value > 0.0 && value < largest.1 * 1e-301 {
                return refused((name, value), "arguments may differ by a factor of 1e300");
            }
        }
        let exponent = ilogb(largest.1).div_euclid(2);
        Ok(Self { exponent, largest })
    }

    fn scaled<const N: usize>(&self, arguments: [f64; N]) -> [Dd; N] {
        // In two factors: 4^-exponent itself may be out of range.
        let half = ldexp(1.0, -self.exponent);
        arguments.map(|a| Dd::from(a * half * half))
    }

    /// The value times 2^(`degree` exponent), rounded once.
    fn unscaled(&self, value: Dd, degree: i32) -> Result<f64> {
        let result = ldexp(value.to_f64(), degree * self.exponent);
        if result.is_normal() {
            Ok(result)
        } else {
            let (name, value) = self.largest;
            Err(Error::out_of_range(
                name,
                value,
                "the integral must lie between 2.3e-308 and 1.7e308",
            ))
        }
    }
}

/// The deviations from the mean at which the Taylor polynomials of degree 7 leave
/// 3 r^8 < 1e-20 (Carlson 1995, eq. 2.11, 2.22).
const CLOSE: f64 = 0.0025;

/// 2^160: p this far above the other arguments leaves R_J = 3 R_F / p to 2^-80.
const FAR: f64 = 1.461_501_637_330_903e48;

/// R_F(x, y, z) in double-double arithmetic, to 2^-66 or better, of arguments that are not negative,
/// at most one of them zero, and of moderate size.
pub fn rf_extended(mut x: Dd, mut y: Dd, mut z: Dd) -> Dd {
    loop {
        let mean = (x + y + z) / 3.0;
        let d = deviations(mean, [x, y, z]);
        if within(&d, CLOSE) {
            return rf_series(mean, d);
        }
        let (a, b, c) = (x.sqrt(), y.sqrt(), z.sqrt());
        let shift = a * b + b * c + c * a;
        (x, y, z) = (quarter(x + shift), quarter(y + shift), quarter(z + shift));
    }
}

/// R_F(x, y, z) and R_D(x, y, z) from one chain of duplications.
pub(crate) fn rf_rd_extended(mut x: Dd, mut y: Dd, mut z: Dd) -> (Dd, Dd) {
    let mut sum = Dd::ZERO;
    let mut weight = 1.0;
    loop {
        let mean = (x + y + z.scaled(2.0) + z) / 5.0;
        let d = deviations(mean, [x, y, z]);
        if within(&d, CLOSE) {
            let rd = rj_series(mean, [d[0], d[1], d[2], d[2]]);
            let third = (x + y + z) / 3.0;
            let rf = rf_series(third, deviations(third, [x, y, z]));
            return (rf, sum + rd.scaled(weight));
        }
        let (a, b, c) = (x.sqrt(), y.sqrt(), z.sqrt());
        let shift = a * b + b * c + c * a;
        sum += Dd::from(3.0 * weight) / (c * (z + shift));
        weight *= 0.25;
        (x, y, z) = (quarter(x + shift), quarter(y + shift), quarter(z + shift));
    }
}

/// R_F(x, y, z) and R_J(x, y, z, p) from one chain of duplications.
pub(crate) fn rf_rj_extended(mut x: Dd, mut y: Dd, mut z: Dd, mut p: Dd) -> (Dd, Dd) {
    if p > x.max(y).max(z).scaled(1024.0) {
        return rf_rj_large_p([x, y, z], p);
    }
    let mut sum = Dd::ZERO;
    let mut weight = 1.0;
    loop {
        let mean = (x + y + z + p.scaled(2.0)) / 5.0;
        let d = deviations(mean, [x, y, z, p]);
        if within(&d, CLOSE) {
            let rj = rj_series(mean, d);
            let third = (x + y + z) / 3.0;
            let rf = rf_series(third, deviations(third, [x, y, z]));
            return (rf, sum + rj.scaled(weight));
        }
        let (a, b, c, h) = (x.sqrt(), y.sqrt(), z.sqrt(), p.sqrt());
        sum += (duplication_term(h, [a, b, c]) * 3.0).scaled(weight);
        weight *= 0.25;
        let shift = a * b + b * c + c * a;
        (x, y, z) = (quarter(x + shift), quarter(y + shift), quarter(z + shift));
        p = quarter(p + shift);
    }
}

/// R_F and R_J for p far above the other arguments, where each duplication brings
/// p nearer by a factor 4 only.
///
/// With x the least and (p-x)(q-x) = (y-x)(z-x), q lies among the arguments
/// (DLMF 19.21.12): (p-x) R_J(p) + (q-x) R_J(q) = 3 R_F - 3 sqrt(x) R_C(yz, pq).
fn rf_rj_large_p([x, y, z]: [Dd; 3], p: Dd) -> (Dd, Dd) {
    let (x, y) = (x.min(y), x.max(y));
    let (x, z) = (x.min(z), x.max(z));
    // Both subtrahends are below R_F sqrt(max/p): nothing cancels, and far away
    // they are nothing at all.
    if p > y.max(z) * FAR {
        let rf = rf_extended(x, y, z);
        return (rf, rf * 3.0 / p);
    }
    let excess = (y - x) * ((z - x) / (p - x));
    let q = x + excess;
    let (rf, rj) = rf_rj_extended(x, y, z, q);
    // pq - yz without its cancellation.
    let difference = x * (p + q - y - z);
    let rc = rc_extended((y * z).sqrt(), (p * q).sqrt(), difference);
    (rf, ((rf - x.sqrt() * rc) * 3.0 - excess * rj) / (p - x))
}

/// R_C(alpha^2, beta^2) with alpha = h^2 (a+b+c) + abc and beta = h (h^2 + ab+bc+ca)
/// (DLMF 19.26.20), for roots h of p and a, b, c of x, y, z.
///
/// The usual form R_C(1, 1+e) loses 1+e when p is small; here nothing cancels:
/// beta +- alpha is the product of the three factors h +- a, h +- b, h +- c.
fn duplication_term(h: Dd, roots: [Dd; 3]) -> Dd {
    // Each factor by its own power of two, so that no product leaves the range.
    let mut size = 1.0;
    let pairs = roots.map(|a| {
        let scale = ldexp(1.0, -ilogb(h.hi().max(a.hi())));
        size *= scale;
        (h.scaled(scale), a.scaled(scale))
    });
    let [(h1, a), (h2, b), (h3, c)] = pairs;
    let (bc, hh) = (b * c, h2 * h3);
    let (bh, hc) = (b * h3, h2 * c);
    let alpha = a * (hh + bc) + h1 * (bh + hc);
    let beta = h1 * (hh + bc) + a * (bh + hc);
    let difference = (h1 - a) * (h2 - b) * (h3 - c) * (beta + alpha);
    rc_extended(alpha, beta, difference).scaled(size)
}

/// R_C(alpha^2, beta^2) from the roots and `difference` = beta^2 - alpha^2.
pub(crate) fn rc_extended(alpha: Dd, beta: Dd, difference: Dd) -> Dd {
    let square = alpha.square();
    if difference.abs().to_f64() < 0.0625 * square.to_f64() {
        // atan(t)/t in r = t^2; from the third term on, plain f64 weighs 2^-10 of an ulp.
        let r = difference / square;
        let tail = (2..20).rev().fold(0.0, |sum, k| 1.0 / f64::from(2 * k + 1) - r.to_f64() * sum);
        return (Dd::ONE - r / 3.0 + r.square() * tail) / alpha;
    }
    if difference > 0.0 {
        let t = difference.sqrt();
        t.atan2(alpha) / t
    } else {
        let t = (-difference).sqrt();
        ((alpha + t) / beta).ln() / t
    }
}

fn quarter(value: Dd) -> Dd {
    value.scaled(0.25)
}

/// 1 - v/mean for each argument; the difference is formed before it is rounded.
fn deviations<const N: usize>(mean: Dd, arguments: [Dd; N]) -> [f64; N] {
    arguments.map(|v| (mean - v).to_f64() / mean.to_f64())
}

fn within(deviations: &[f64], limit: f64) -> bool {
    deviations.iter().all(|d| d.abs() < limit)
}

/// DLMF 19.36.1: the Taylor polynomial of R_F about equal arguments.
fn rf_series(mean: Dd, [x, y, z]: [f64; 3]) -> Dd {
    let e2 = x * y - z * z;
    let e3 = x * y * z;
    let small = e2 * (-1.0 / 10.0 + e2 * (1.0 / 24.0 - e2 * 5.0 / 208.0))
        + e3 * (1.0 / 14.0 - e2 * (3.0 / 44.0 - e2 / 16.0) + e3 * 3.0 / 104.0);
    (Dd::ONE + small) / mean.sqrt()
}

/// DLMF 19.36.2: the Taylor polynomial of R_J (and with p = z of R_D).
fn rj_series(mean: Dd, [x, y, z, p]: [f64; 4]) -> Dd {
    let xyz = x * y * z;
    let e2 = x * y + y * z + z * x - 3.0 * p * p;
    let e3 = xyz + 2.0 * e2 * p + 4.0 * p * p * p;
    let e4 = (2.0 * xyz + e2 * p + 3.0 * p * p * p) * p;
    let e5 = xyz * p * p;
    let small =
        -3.0 / 14.0 * e2 + e3 / 6.0 + 9.0 / 88.0 * e2 * e2 - 3.0 / 22.0 * e4 - 9.0 / 52.0 * e2 * e3
            + 3.0 / 26.0 * e5
            - e2 * e2 * e2 / 16.0
            + 3.0 / 40.0 * e3 * e3
            + 3.0 / 20.0 * e2 * e4
            + 45.0 / 272.0 * e2 * e2 * e3
            - 9.0 / 68.0 * (e3 * e4 + e2 * e5);
    (Dd::ONE + small) / (mean * mean.sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Values of B. C. Carlson, Numer. Algorithms 10, 13 (1995), the same by mpmath at 25 digits.
    #[test]
    fn published_values() {
        let pairs = [
            (rf(1.0, 2.0, 0.0), 1.311_028_777_146_059_9),
            (rj(2.0, 3.0, 4.0, 5.0), 0.142_975_796_671_567_54),
            (rj(0.0, 1.0, 2.0, 3.0), 0.776_886_237_785_823_3),
            (rd(0.0, 2.0, 1.0), 1.797_210_352_103_388_3),
        ];
        for (got, want) in pairs {
            let got = got.expect("inside");
            assert!((got / want - 1.0).abs() < 4e-16, "{got} {want}");
        }
    }
}
