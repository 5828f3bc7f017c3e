//! The Kepler ellipse: a nonlinear problem whose solution is known at any time.

use rotation_dynamics::integrators::{Ode, size_or};
use rotation_dynamics::math::{cos, sin};
use support::{Errors, assert_largest};

/// Position and velocity in the plane; unit mass and unit semi-major axis.
pub struct Kepler;

impl Ode<4> for Kepler {
    fn derivative(&self, _t: f64, &[x, y, u, v]: &[f64; 4]) -> [f64; 4] {
        let r2 = x * x + y * y;
        let r3 = r2 * r2.sqrt();
        [u, v, -x / r3, -y / r3]
    }

    fn scale(&self, y: &[f64; 4]) -> [f64; 4] {
        size_or([1.0; 4])(y)
    }
}

/// The eccentricity used throughout.
pub const ECCENTRICITY: f64 = 0.5;

/// The state at time t after the passage through the pericentre.
pub fn exact(t: f64) -> [f64; 4] {
    let e = ECCENTRICITY;
    let mut anomaly = t + e * sin(t);
    for _ in 0..20 {
        anomaly -= (anomaly - e * sin(anomaly) - t) / (1.0 - e * cos(anomaly));
    }
    let (s, c) = (sin(anomaly), cos(anomaly));
    let root = (1.0 - e * e).sqrt();
    let rate = 1.0 / (1.0 - e * c);
    [c - e, root * s, -s * rate, root * c * rate]
}

/// Largest difference of two states over their components.
pub fn distance(a: &[f64; 4], b: &[f64; 4]) -> f64 {
    let mut errors = Errors::of("components");
    a.iter().zip(b).for_each(|(p, q)| errors.push(p - q));
    errors.largest()
}

#[test]
fn the_closed_form_solves_the_equation() {
    // Central difference of order 4 with step 1e-3.
    let mut errors = Errors::of("rates");
    let mut damaged = Errors::of("rates off by 1e-8");
    for i in 0..40 {
        let t = 0.17 * f64::from(i);
        let h = 1e-3;
        let [a, b, c, d] = [exact(t - 2.0 * h), exact(t - h), exact(t + h), exact(t + 2.0 * h)];
        let rate = Kepler.derivative(t, &exact(t));
        for k in 0..4 {
            let difference = (8.0 * (c[k] - b[k]) - (d[k] - a[k])) / (12.0 * h);
            errors.push_at(difference - rate[k], (t, k));
            damaged.push_at(difference - rate[k] * (1.0 + 1e-8), (t, k));
        }
    }
    assert_largest!(errors, 160, @"2.07e-10");
    assert!(damaged.largest() > 10.0 * 2.1e-10);
}
