//! Tops on a rounded tip: what is known in closed form, what is kept, and where it ends.

mod contact;
mod kept;
mod limits;

use models::tops::Shape;
use rotation_dynamics::frame::SpaceVector;

const G: f64 = 9.80665;

/// The page's toy top.
fn toy(tip: f64) -> Shape {
    Shape::new(0.1, 4e-5, 4e-5, 0.04, tip).unwrap()
}

/// Another one, flatter, and one that is long.
fn others() -> [Shape; 2] {
    [
        Shape::new(0.2, 9e-5, 1.6e-4, 0.03, 0.004).unwrap(),
        Shape::new(0.05, 6e-5, 2e-5, 0.02, 0.008).unwrap(),
    ]
}

/// The rule of Simpson with `n` (even) parts.
fn simpson(from: f64, to: f64, n: u32, f: impl Fn(f64) -> f64) -> f64 {
    let h = (to - from) / f64::from(n);
    let weight = |i| {
        if i == 0 || i == n { 1.0 } else { 2.0 + 2.0 * f64::from(i % 2) }
    };
    (0..=n).map(|i| weight(i) * f(from + h * f64::from(i))).sum::<f64>() * h / 3.0
}

fn apart(a: SpaceVector, b: SpaceVector) -> f64 {
    (a - b).norm()
}
