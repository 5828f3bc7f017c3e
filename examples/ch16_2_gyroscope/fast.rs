//! The fast rotor, released at rest: its three formulas, and by how much they miss.

use super::*;
use kit::supported_digits;

/// a of the rotor that is released: that of the half-kilogram rotor.
pub const SHAPE: f64 = 9e-4 / 5.45e-3;

/// A rotor of the shape `a`, released at rest at the tilt `theta`, with c/a = `ratio`.
pub fn released(a: f64, theta: f64, ratio: f64) -> Result<HeavyTop> {
    let top = ReducedTop::new(a, cos(theta), ratio * a)?;
    Ok(HeavyTop::from_angles(top, theta, 0.0, 0.0, 0.0)?)
}

/// Precession, frequency of the nods and dip over their formulas, minus 1. With a `ratio`
/// below 0 the weight pulls up: the axis rises and walks back.
pub fn beyond_the_formulas(a: f64, theta: f64, ratio: f64) -> Result<[f64; 3]> {
    let exact = released(a, theta, ratio)?;
    let (period, root) = (exact.nutation_period(), a.sqrt());
    let dip = exact.theta_max() - exact.theta_min();
    Ok([
        exact.precession_per_period() / period / (ratio * root) - 1.0,
        TAU / period / root - 1.0,
        dip / (2.0 * ratio.abs() * sin(theta)) - 1.0,
    ])
}

/// The three relative errors of the formulas over c/a, to first order, by the expansion
/// on the page: cos(theta), -2 cos(theta), 3 cos(theta).
pub fn coefficients(theta: f64) -> [f64; 3] {
    [1.0, -2.0, 3.0].map(|k| k * cos(theta))
}

/// The same by the closed form: the part of the errors that is odd in c/a.
pub fn coefficients_measured(a: f64, theta: f64) -> Result<[f64; 3]> {
    let ratio = 1e-4;
    let [down, up] = [ratio, -ratio].map(|ratio| beyond_the_formulas(a, theta, ratio));
    let (down, up) = (down?, up?);
    Ok(core::array::from_fn(|i| (down[i] - up[i]) / (2.0 * ratio)))
}

pub fn claims(report: &mut Report) -> Result<()> {
    const EXPANSION: &str = "expansion in c/a";
    const EXACT: &str = "closed form at c/a = 1e-4 and -1e-4";
    let theta = PI / 3.0;
    let [low, high] = [1e-5, 1e-4].map(|ratio| beyond_the_formulas(SHAPE, theta, ratio));
    let (low, high) = (low?, high?);
    // The slope over a decade, on logarithmic axes.
    let [precession, frequency, dip] =
        [0, 1, 2].map(|i| log(high[i] / low[i]) / core::f64::consts::LN_10);
    let (expected, found) = (coefficients(theta), coefficients_measured(SHAPE, theta)?);
    claims! { report,
        /// order in c/a of the error of m g l/L_z
        fast_precession_order: precession, "-", EXPANSION => 1.0, within 1e-3;
        /// error of m g l/L_z at 60 degrees, over c/a
        fast_precession_coefficient: expected[0], "-", EXACT => found[0], within 1e-6;
        /// order in c/a of the error of L_z/I1
        fast_frequency_order: frequency, "-", EXPANSION => 1.0, within 1e-3;
        /// error of L_z/I1 at 60 degrees, over c/a
        fast_frequency_coefficient: expected[1], "-", EXACT => found[1], within 1e-6;
        /// order in c/a of the error of 2 (c/a) sin(theta)
        fast_dip_order: dip, "-", EXPANSION => 1.0, within 1e-3;
        /// error of 2 (c/a) sin(theta) at 60 degrees, over c/a
        fast_dip_coefficient: expected[2], "-", EXACT => found[2], within 1e-6;
    }?;
    let columns =
        "released at, precession, frequency, dip, cos(theta), -2 cos(theta), 3 cos(theta)";
    report.add(Table::of("fast", columns.split(", "), [30, 60, 90, 120, 150], |degrees| {
        let theta = PI * f64::from(degrees) / 180.0;
        let cells = [coefficients_measured(SHAPE, theta)?, coefficients(theta)].concat();
        // Digits that are sure, and no minus sign before a zero.
        let told = |x: f64| supported_digits(if x.abs() < 5e-5 { 0.0 } else { x }, 5e-5);
        Ok([format!("{degrees}°")].into_iter().chain(cells.into_iter().map(told)))
    })?)
}
