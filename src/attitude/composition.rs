//! Composition of attitudes, inverse, and the angle between two.

use super::{Attitude, norm};
use crate::math::DoubleDouble;
use core::ops::Mul;

impl Attitude {
    /// This rotation followed by `next`, both about the fixed axes: `next * self`.
    #[inline]
    pub fn then(&self, next: &Self) -> Self {
        *next * *self
    }

    /// The inverse rotation, space -> body.
    #[inline]
    pub const fn inverse(&self) -> Self {
        let [w, x, y, z] = self.quaternion();
        Self::from_unit([w, -x, -y, -z])
    }

    /// The angle of the rotation that leads from this attitude to the other, in
    /// [0, pi] (rad).
    ///
    /// Accuracy: a few eps relative, from neighbouring doubles (1e-16) to pi,
    /// measured in `tests/attitude.rs`; the products are formed to 106 bits, so
    /// that nothing cancels when the two are close.
    pub fn angle_to(&self, other: &Self) -> f64 {
        let [w, x, y, z] = self.quaternion();
        let [a, b, c, d] = other.quaternion();
        let sum = |p: [f64; 4], q: [f64; 4]| {
            let mut sum = DoubleDouble::ZERO;
            for i in 0..4 {
                sum += DoubleDouble::product(p[i], q[i]);
            }
            sum
        };
        // The four components of q1* q2.
        let along = sum([w, x, y, z], [a, b, c, d]).abs();
        let across = norm([
            sum([w, -x, -y, z], [b, a, d, c]).to_f64(),
            sum([w, x, -y, -z], [c, d, a, b]).to_f64(),
            sum([w, -x, y, -z], [d, c, b, a]).to_f64(),
        ]);
        across.atan2(along).scaled(2.0).to_f64()
    }
}

/// `a * b`: first `b`, then `a`, as matrices multiply; `b` refers to the axes
/// that `a` carries along.
impl Mul for Attitude {
    type Output = Self;

    #[inline]
    fn mul(self, other: Self) -> Self {
        let [w, x, y, z] = self.quaternion();
        let [a, b, c, d] = other.quaternion();
        let product = [
            (w * a - x * b) - (y * c + z * d),
            (w * b + x * a) + (y * d - z * c),
            (w * c + y * a) + (z * b - x * d),
            (w * d + z * a) + (x * c - y * b),
        ];
        let [p, q, r, s] = product;
        // A Newton step to unit norm; without it the norm walks away with the
        // number of compositions. 1 - |q|^2 is a few eps, so one step is exact.
        let correction = 0.5 * (1.0 - ((p * p + q * q) + (r * r + s * s)));
        Self::from_unit(product.map(|c| c + correction * c))
    }
}
