//! The independent route: rotation matrices with their exact derivatives, entry by entry.

use core::array::from_fn;
use rotation_dynamics::frame::SpaceVector;
use rotation_dynamics::math::sincos;

/// A number and its rate of change.
#[derive(Clone, Copy)]
pub struct Entry {
    pub value: f64,
    pub rate: f64,
}

pub type Matrix = [[Entry; 3]; 3];

/// A turn about one of the axes 0, 1, 2, by an angle that changes at this rate.
fn about(axis: usize, angle: f64, rate: f64) -> Matrix {
    let (s, c) = sincos(angle);
    let [next, last] = [(axis + 1) % 3, (axis + 2) % 3];
    from_fn(|i| {
        from_fn(|j| {
            let (value, rate) = match (i, j) {
                _ if i == axis && j == axis => (1.0, 0.0),
                _ if i == axis || j == axis => (0.0, 0.0),
                _ if i == j => (c, -s * rate),
                _ if (i, j) == (last, next) => (s, c * rate),
                _ => (-s, -c * rate),
            };
            Entry { value, rate }
        })
    })
}

/// A turn about X.
pub fn about_x(angle: f64, rate: f64) -> Matrix {
    about(0, angle, rate)
}

/// A turn about Z.
pub fn about_z(angle: f64, rate: f64) -> Matrix {
    about(2, angle, rate)
}

/// The product, its rates by the product rule.
pub fn product(a: &Matrix, b: &Matrix) -> Matrix {
    from_fn(|i| {
        from_fn(|j| {
            let sum = |term: fn(Entry, Entry) -> f64| (0..3).map(|k| term(a[i][k], b[k][j])).sum();
            let value = sum(|a, b| a.value * b.value);
            let rate = sum(|a, b| a.rate * b.value + a.value * b.rate);
            Entry { value, rate }
        })
    })
}

/// The vector w of the antisymmetric matrix W that has W r = w x r.
fn vector(w: impl Fn(usize, usize) -> f64) -> [f64; 3] {
    [w(2, 1), w(0, 2), w(1, 0)]
}

/// The angular velocity in space: that of R' R^T.
pub fn in_space(r: &Matrix) -> SpaceVector {
    SpaceVector::from_array(vector(|i, j| (0..3).map(|k| r[i][k].rate * r[j][k].value).sum()))
}

/// The angular velocity on the axes that turn: that of R^T R'.
pub fn on_own_axes(r: &Matrix) -> [f64; 3] {
    vector(|i, j| (0..3).map(|k| r[k][i].value * r[k][j].rate).sum())
}

/// Its size: the squares of all rates of R add up to twice its square.
pub fn length(r: &Matrix) -> f64 {
    let squares = r.iter().flatten().map(|entry| entry.rate * entry.rate);
    (0.5 * squares.sum::<f64>()).sqrt()
}

/// The axes that turn, in space.
pub fn columns(r: &Matrix) -> [SpaceVector; 3] {
    from_fn(|j| SpaceVector::from_array(from_fn(|i| r[i][j].value)))
}
