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

    /// From components that are unit to a few eps, after one Newton step: 1 - |q|^2 is a
    /// few eps, so one is exact.
    #[inline]
    pub(super) fn brought_to_unit(quaternion: [f64; 4]) -> Self {
        let [p, q, r, s] = quaternion;
        let correction = 0.5 * (1.0 - ((p * p + q * q) + (r * r + s * s)));
        Self::from_unit(quaternion.map(|c| c + correction * c))
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
    /// Accuracy: correctly rounded, from neighbouring quaternions (1e-16) to
    /// pi, in all 140 references of `tests/bodies/attitude`.
    pub fn angle_to(&self, other: &Self) -> f64 {
        let q = self.quaternion();
        let mut other = other.quaternion();
        if q.iter().zip(other).map(|(a, b)| a * b).sum::<f64>() < 0.0 {
            other = other.map(|c| -c);
        }
        let mut along = DoubleDouble::ZERO;
        for i in 0..4 {
            along += DoubleDouble::product(q[i], other[i]);
        }
        // The vector part of q* other is that of q* (other - q), and the
        // difference of two doubles is exact as a pair.
        let step = [0, 1, 2, 3].map(|i| DoubleDouble::sum(other[i], -q[i]));
        let part = |i: usize, j: usize, k: usize| {
            step[i] * q[0] - step[0] * q[i] + step[j] * q[k] - step[k] * q[j]
        };
        let across = norm([part(1, 2, 3), part(2, 3, 1), part(3, 1, 2)]);
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
        // Without it the norm walks away with the number of compositions.
        Self::brought_to_unit(product)
    }
}
