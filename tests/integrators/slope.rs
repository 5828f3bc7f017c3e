//! The slope of a straight line through points on logarithmic axes.

use rotation_dynamics::math::log;
use support::{Errors, assert_error, attained};

/// Least-squares slope of ln(error) against ln(step), and the largest distance
/// of a point from the line, in e-folds.
pub fn fitted(points: &[(f64, f64)]) -> (f64, f64) {
    assert!(points.len() >= 4, "a slope needs at least four points");
    let logs: Vec<(f64, f64)> = points.iter().map(|&(h, e)| (log(h), log(e))).collect();
    let n = logs.len() as f64;
    let (mx, my) = logs.iter().fold((0.0, 0.0), |(a, b), &(x, y)| (a + x / n, b + y / n));
    let sxy: f64 = logs.iter().map(|&(x, y)| (x - mx) * (y - my)).sum();
    let sxx: f64 = logs.iter().map(|&(x, _)| (x - mx) * (x - mx)).sum();
    let slope = sxy / sxx;
    let mut off = Errors::of("distance from the line");
    logs.iter().for_each(|&(x, y)| off.push(y - my - slope * (x - mx)));
    (slope, off.largest())
}

/// Asserts the slope and the largest distance from the line, as printed.
#[track_caller]
pub fn assert_slope(points: &[(f64, f64)], slope: &str, off: &str) {
    let (measured, scatter) = fitted(points);
    attained(measured, slope, "slope");
    attained(scatter, off, "distance from the line");
}

#[test]
fn the_slope_of_a_cube_is_three() {
    let points: Vec<(f64, f64)> = (1..=5).map(f64::from).map(|h| (h, 7.0 * h * h * h)).collect();
    let (slope, off) = fitted(&points);
    assert_error!(slope - 3.0, 4.4e-16);
    assert_error!(off, 6.1e-16);
}
