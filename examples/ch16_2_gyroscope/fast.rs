//! The fast rotor, released at rest: its three formulas, and by how much they miss.

use kit::{Report, Result, Table, claim, sampled, supported_digits};
use rotation_dynamics::exact::heavy_top::{HeavyTop, ReducedTop};
use rotation_dynamics::math::{cos, log, sin};

use core::f64::consts::{PI, TAU};

/// a of the rotor that is released: that of the half-kilogram rotor.
pub const SHAPE: f64 = 9e-4 / 5.45e-3;

/// A rotor released at rest at the tilt `theta`, with c/a = `ratio`.
pub fn released(theta: f64, ratio: f64) -> rotation_dynamics::Result<HeavyTop> {
    let top = ReducedTop::new(SHAPE, cos(theta), ratio * SHAPE)?;
    HeavyTop::from_angles(top, theta, 0.0, 0.0, 0.0)
}

/// Precession, frequency of the nods and dip over their formulas, minus 1. With a `ratio`
/// below 0 the weight pulls up: the axis rises and walks back.
pub fn beyond_the_formulas(theta: f64, ratio: f64) -> Result<[f64; 3]> {
    let exact = released(theta, ratio)?;
    let (period, root) = (exact.nutation_period(), SHAPE.sqrt());
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
fn coefficients_measured(theta: f64) -> Result<[f64; 3]> {
    let ratio = 1e-4;
    let down = beyond_the_formulas(theta, ratio)?;
    let up = beyond_the_formulas(theta, -ratio)?;
    Ok(core::array::from_fn(|i| (down[i] - up[i]) / (2.0 * ratio)))
}

const QUANTITIES: [(&str, &str, &str); 3] = [
    ("precession", "m g l/L_z", "error of m g l/L_z at 60 degrees, over c/a"),
    ("frequency", "L_z/I1", "error of L_z/I1 at 60 degrees, over c/a"),
    ("dip", "2 (c/a) sin(theta)", "error of 2 (c/a) sin(theta) at 60 degrees, over c/a"),
];

pub fn add(report: &mut Report) -> Result<()> {
    let ratios = [1e-5, 2e-5, 5e-5, 1e-4];
    let rows = sampled(ratios, |ratio| beyond_the_formulas(PI / 3.0, ratio))?;
    let (found, expected) = (coefficients_measured(PI / 3.0)?, coefficients(PI / 3.0));
    for (i, (quantity, formula, meaning)) in QUANTITIES.into_iter().enumerate() {
        let points = ratios.iter().zip(&rows).map(|(x, row)| (log(*x), log(row[i].abs())));
        let order = format!("order in c/a of the error of {formula}");
        report.add(
            claim(format!("fast_{quantity}_order"), order, slope(&points.collect::<Vec<_>>()), "-")
                .within(1e-3)
                .against("expansion in c/a", 1.0),
        )?;
        report.add(
            claim(format!("fast_{quantity}_coefficient"), meaning, expected[i], "-")
                .within(1e-6)
                .against("closed form at c/a = 1e-4 and -1e-4", found[i]),
        )?;
    }
    let mut table = Table::new(
        "fast",
        [
            "released at",
            "precession",
            "frequency",
            "dip",
            "cos(theta)",
            "-2 cos(theta)",
            "3 cos(theta)",
        ],
    )?;
    for degrees in [30_u8, 60, 90, 120, 150] {
        let theta = PI * f64::from(degrees) / 180.0;
        let found = coefficients_measured(theta)?;
        let cells = found.into_iter().chain(coefficients(theta));
        // Digits that are sure, and no minus sign before a zero.
        let cells = cells.map(|x| supported_digits(if x.abs() < 5e-5 { 0.0 } else { x }, 5e-5));
        let row: Vec<String> = [format!("{degrees}°")].into_iter().chain(cells).collect();
        table.push(row)?;
    }
    report.add(table)
}

/// Slope of the straight line of least squares through the points.
fn slope(points: &[(f64, f64)]) -> f64 {
    let n = points.len() as f64;
    let mean = |of: fn(&(f64, f64)) -> f64| points.iter().map(of).sum::<f64>() / n;
    let (mx, my) = (mean(|p| p.0), mean(|p| p.1));
    let across: f64 = points.iter().map(|(x, y)| (x - mx) * (y - my)).sum();
    across / points.iter().map(|(x, _)| (x - mx) * (x - mx)).sum::<f64>()
}
