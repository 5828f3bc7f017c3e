//! Sine and cosine as functions of the square of the angle.
//!
//! A rotation vector gives the square; neither a square root nor a division by the
//! angle is needed then, and 1 - cos does not cancel.

use super::sincos;

/// (sin x / x, (1 - cos x) / x^2) from the square of x (rad^2), not negative.
///
/// Error: at most 1.1 and 0.7 eps of the value up to 1, where it is a polynomial of
/// degree 8; 2.9 and 3.9 eps beyond, to 4 (measured).
#[inline]
pub(crate) fn sinc_versine(square: f64) -> (f64, f64) {
    if square <= 1.0 {
        return (polynomial(&SINC, square), polynomial(&VERSINE, square));
    }
    let x = square.sqrt();
    let (s, c) = sincos(0.5 * x);
    (2.0 * s * c / x, 2.0 * s * s / square)
}

/// Degree 8 in pairs: a short chain of operations, the large terms last.
#[inline]
fn polynomial(c: &[f64; 9], x: f64) -> f64 {
    let x2 = x * x;
    let x4 = x2 * x2;
    let high = (c[5] + c[6] * x) + x2 * (c[7] + c[8] * x);
    let low = (c[1] + c[2] * x) + x2 * (c[3] + c[4] * x);
    c[0] + x * (low + x4 * high)
}

/// (-1)^k / (2k+1)!.
const SINC: [f64; 9] = [
    1.0,
    -1.0 / 6.0,
    1.0 / 120.0,
    -1.0 / 5040.0,
    1.0 / 362_880.0,
    -1.0 / 39_916_800.0,
    1.0 / 6_227_020_800.0,
    -1.0 / 1_307_674_368_000.0,
    1.0 / 355_687_428_096_000.0,
];

/// (-1)^k / (2k+2)!.
const VERSINE: [f64; 9] = [
    0.5,
    -1.0 / 24.0,
    1.0 / 720.0,
    -1.0 / 40_320.0,
    1.0 / 3_628_800.0,
    -1.0 / 479_001_600.0,
    1.0 / 87_178_291_200.0,
    -1.0 / 20_922_789_888_000.0,
    1.0 / 6_402_373_705_728_000.0,
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::{DoubleDouble as Dd, EPS};
    use support::{Errors, assert_largest};

    #[test]
    fn against_double_double() {
        let errors = || ["sinc", "versine"].map(|name| Errors::in_units_of(EPS, name));
        let [mut small, mut large] = [errors(), errors()];
        for k in 1..=4000 {
            let square = f64::from(k) * 1e-3 * 1.000_37;
            let x = Dd::from(square).sqrt();
            let half = (x * 0.5).sin_cos().0;
            let want = [x.sin_cos().0 / x, half.square() * 2.0 / square];
            let (sinc, versine) = sinc_versine(square);
            let errors = if square > 1.0 { &mut large } else { &mut small };
            for (i, got) in [sinc, versine].into_iter().enumerate() {
                errors[i].push_at(((want[i] - got) / want[i]).to_f64(), square);
            }
        }
        let [sinc, versine] = small;
        sinc.attain(0.9..=1.1, 999);
        assert_largest!(versine, 999, @"0.698");
        let [sinc, versine] = large;
        assert_largest!(sinc, 3001, @"2.88");
        assert_largest!(versine, 3001, @"3.82");
        assert_eq!(sinc_versine(0.0), (1.0, 0.5));
    }
}
