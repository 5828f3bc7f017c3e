//! Zeros and least values of a function of one variable between two places.

use super::EPS;
use crate::error::Result;

/// Narrowings of the place of a least value: 0.618^40 of the bracket.
const NARROWINGS: u32 = 40;

/// Where `side` times the function is least between two places, and its value, by the golden section.
pub(crate) fn least(
    mut value: impl FnMut(f64) -> Result<f64>,
    side: f64,
    [mut from, mut to]: [f64; 2],
) -> Result<(f64, f64)> {
    const PART: f64 = 0.381_966_011_250_105_1;
    let at = |part: f64, from: f64, to: f64| from + part * (to - from);
    let (mut t_a, mut t_b) = (at(PART, from, to), at(1.0 - PART, from, to));
    let (mut a, mut b) = (value(t_a)?, value(t_b)?);
    for _ in 0..NARROWINGS {
        if side * a < side * b {
            to = t_b;
            (t_b, b) = (t_a, a);
            t_a = at(PART, from, to);
            a = value(t_a)?;
        } else {
            from = t_a;
            (t_a, a) = (t_b, b);
            t_b = at(1.0 - PART, from, to);
            b = value(t_b)?;
        }
    }
    Ok(if side * a < side * b { (t_a, a) } else { (t_b, b) })
}

/// A zero between two places where the signs of the function differ: secant and bisection by turns,
/// until the bracket is round-off. The value there is zero or has the sign of the second place.
pub(crate) fn zero(
    mut value: impl FnMut(f64) -> Result<f64>,
    (mut t_a, mut a): (f64, f64),
    (mut t_b, mut b): (f64, f64),
) -> Result<f64> {
    let enough = 2.0 * EPS * t_a.abs().max(t_b.abs());
    // Sixty halvings reach round-off from any bracket; every second turn halves.
    for turn in 0..120 {
        if b == 0.0 || (t_b - t_a).abs() <= enough {
            break;
        }
        let secant = t_b - b * ((t_b - t_a) / (b - a));
        let middle = 0.5 * (t_a + t_b);
        let inside = secant > t_a.min(t_b) && secant < t_a.max(t_b);
        let t = if turn % 2 == 0 && inside { secant } else { middle };
        let value = value(t)?;
        if value != 0.0 && (value < 0.0) == (a < 0.0) {
            (t_a, a) = (t, value);
        } else {
            (t_b, b) = (t, value);
        }
    }
    Ok(t_b)
}
