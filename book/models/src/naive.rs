//! What everyone writes first. Not for use: pages and tests show where it breaks.

use core::f64::consts::{FRAC_PI_2, TAU};
use rotation_dynamics::math::{acos, cos, sort_by_number};

/// The start, and the state after each of `count` equal steps of the classical Runge-Kutta method
/// to the time `end`; nothing is refused, and no sum is compensated.
pub fn runge_kutta<const N: usize>(
    f: impl Fn(&[f64; N]) -> [f64; N],
    start: [f64; N],
    end: f64,
    count: u32,
) -> impl Iterator<Item = [f64; N]> {
    let h = end / f64::from(count);
    let step = move |y: &[f64; N]| {
        let add = |k: &[f64; N], part: f64| core::array::from_fn(|i| y[i] + part * h * k[i]);
        let a = f(y);
        let b = f(&add(&a, 0.5));
        let c = f(&add(&b, 0.5));
        let d = f(&add(&c, 1.0));
        let mean = |i: usize| a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i];
        Some(core::array::from_fn(|i| y[i] + h / 6.0 * mean(i)))
    };
    core::iter::successors(Some(start), step).take(count as usize + 1)
}

/// K by the arithmetic-geometric mean, of 1 less the parameter.
pub fn quarter_period(complement: f64) -> f64 {
    let mean = |(a, b): (f64, f64), _| (0.5 * (a + b), (a * b).sqrt());
    FRAC_PI_2 / (0..60).fold((1.0, complement.sqrt()), mean).0
}

/// The smaller turning point of a top (the notes' a, b, c and E~) by the trigonometric formula
/// for the roots of a cubic, from its coefficients.
pub fn turning_point([a, b, c]: [f64; 3], energy: f64) -> f64 {
    let p = -(2.0 * energy + 2.0 * c + a) / (2.0 * c);
    let q = (2.0 * a * b - 2.0 * c) / (2.0 * c);
    let r = (2.0 * energy + 2.0 * c - a * b * b) / (2.0 * c);
    let [linear, constant] = [q - p * p / 3.0, 2.0 * p * p * p / 27.0 - p * q / 3.0 + r];
    let size = (-linear / 3.0).sqrt();
    let angle = acos((-constant / (2.0 * size * size * size)).clamp(-1.0, 1.0)) / 3.0;
    let third = TAU / 3.0;
    let mut roots = [0.0, 1.0, 2.0].map(|k| 2.0 * size * cos(angle - k * third) - p / 3.0);
    sort_by_number(&mut roots, |root| *root);
    acos(roots[1])
}
