//! Hyperbolic sine and cosine without a branch: one text for one number and for several.

use super::lane::{Pair, Phased};
use super::turns::ROUNDER;

/// The greatest |w| for which [`sinh_cosh_of`] and squares of what it gives are in range.
pub(crate) const STEEPEST: f64 = 300.0;

/// ln 2: the first 32 bits, whose products with a whole number are exact, and the rest.
const LN_2: [f64; 2] = [0.693_147_180_369_123_8, 1.908_214_929_270_587_7e-10];

/// (sinh w, cosh w) for |w| <= [`STEEPEST`].
///
/// With w = n ln 2 + r both follow from the values for r, which are series, and for n ln 2, which
/// are powers of two. For small w, where n = 0, sinh w is its series and loses nothing.
///
/// Error: at most 2.7 eps of the value for the sine and 1.8 eps for the cosine, over 60 000
/// arguments against 106-bit values (`tests`).
#[inline(always)]
pub(crate) fn sinh_cosh_of<L: Phased>(w: L) -> (L, L) {
    let whole = w * core::f64::consts::LOG2_E + ROUNDER;
    let n = whole - ROUNDER;
    let rest = (w - n * LN_2[0]) - n * LN_2[1];
    let square = rest * rest;
    let squares = L::Pair::new(square, square);
    let mut sum = L::Pair::both(&SERIES[0]);
    for coefficients in &SERIES[1..] {
        sum = squares * sum + L::Pair::both(coefficients);
    }
    let (odd, even) = sum.parts();
    // sinh r, and cosh r - 1.
    let (sinh, versine) = (rest + rest * square * odd, square * even);
    let (up, down) = (L::two_to(whole), L::two_to(-whole + 2.0 * ROUNDER));
    let (sinh_n, cosh_n) = ((up - down) * 0.5, (up + down) * 0.5);
    (sinh_n + (sinh_n * versine + cosh_n * sinh), cosh_n + (cosh_n * versine + sinh_n * sinh))
}

/// (sinh r - r)/r^3 and (cosh r - 1)/r^2 by powers of r^2, the highest first: the terms of
/// Taylor, of which the next is below 3e-19 and 4e-18 of the value for |r| <= ln(2)/2.
const SERIES: [[f64; 2]; 6] = [
    [1.0 / 6_227_020_800.0, 1.0 / 479_001_600.0],
    [1.0 / 39_916_800.0, 1.0 / 3_628_800.0],
    [1.0 / 362_880.0, 1.0 / 40_320.0],
    [1.0 / 5040.0, 1.0 / 720.0],
    [1.0 / 120.0, 1.0 / 24.0],
    [1.0 / 6.0, 1.0 / 2.0],
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::{DoubleDouble as Dd, EPS};

    /// The largest relative errors of both, eps, over arguments of every size.
    fn errors(of: impl Fn(f64) -> (f64, f64)) -> ([f64; 2], u32) {
        let (mut most, mut count) = ([0.0_f64; 2], 0);
        for k in 0..30_000 {
            let part = f64::from(k) / 30_000.0;
            for w in [STEEPEST * part.powi(5), -2.0 * part] {
                let (sinh, cosh) = of(w);
                let (want_sinh, want_cosh) = Dd::from(w).sinh_cosh();
                for (most, (found, want)) in
                    most.iter_mut().zip([(sinh, want_sinh), (cosh, want_cosh)])
                {
                    if want != 0.0 {
                        let error = ((Dd::from(found) - want) / want).to_f64().abs();
                        *most = most.max(error / EPS);
                    }
                }
                count += 1;
            }
        }
        (most, count)
    }

    #[test]
    fn both_are_as_good_as_claimed() {
        let ([sinh, cosh], count) = errors(sinh_cosh_of::<f64>);
        assert_eq!(count, 60_000);
        assert!((2.6..=2.7).contains(&sinh), "{sinh}");
        assert!((1.7..=1.8).contains(&cosh), "{cosh}");
    }

    /// The damaged twin: the cosine's series one term shorter, where it is all there is.
    #[test]
    fn damaged_a_missing_term_shows() {
        let ([sinh, cosh], _) = errors(|w| {
            let (sinh, cosh) = sinh_cosh_of::<f64>(w);
            let lost = if w.abs() < 0.34 { SERIES[0][1] * w.powi(12) } else { 0.0 };
            (sinh, cosh - lost)
        });
        assert!(sinh <= 2.7 && cosh > 30.0, "{sinh} {cosh}");
    }
}
