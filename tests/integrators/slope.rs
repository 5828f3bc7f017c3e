//! The slope of a straight line through points on logarithmic axes.

use rotation_dynamics::math::log;

/// Least-squares slope of ln(error) against ln(step), and the largest distance
/// of a point from the line, in e-folds.
pub fn fitted(points: &[(f64, f64)]) -> (f64, f64) {
    assert!(points.len() >= 4, "a slope needs at least four points");
    let logs: Vec<(f64, f64)> = points.iter().map(|&(h, e)| (log(h), log(e))).collect();
    let n = logs.len() as f64;
    let (mx, my) = logs
        .iter()
        .fold((0.0, 0.0), |(a, b), &(x, y)| (a + x / n, b + y / n));
    let sxy: f64 = logs.iter().map(|&(x, y)| (x - mx) * (y - my)).sum();
    let sxx: f64 = logs.iter().map(|&(x, _)| (x - mx) * (x - mx)).sum();
    let slope = sxy / sxx;
    let off = logs
        .iter()
        .map(|&(x, y)| (y - my - slope * (x - mx)).abs())
        .fold(0.0, f64::max);
    (slope, off)
}

#[test]
fn the_slope_of_a_cube_is_three() {
    let points: Vec<(f64, f64)> = (1..=5)
        .map(f64::from)
        .map(|h| (h, 7.0 * h * h * h))
        .collect();
    let (slope, off) = fitted(&points);
    assert!((slope - 3.0).abs() < 1e-14 && off < 1e-14);
}
