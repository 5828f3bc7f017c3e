//! Products of quaternions `[w, x, y, z]` as given, with nothing brought to unit length.
//!
//! Written over lanes, so that a step in registers and a closed form have the same text.

use crate::math::{Lane, sincos};

/// p q.
#[inline(always)]
pub(crate) fn product<L: Lane>([a, b, c, d]: [L; 4], [w, x, y, z]: [L; 4]) -> [L; 4] {
    [
        a * w - b * x - c * y - d * z,
        a * x + b * w + c * z - d * y,
        a * y - b * z + c * w + d * x,
        a * z + b * y - c * x + d * w,
    ]
}

/// v q for a vector v on the fixed axes: twice the rate at which q turns with the rate v.
#[inline(always)]
pub(crate) fn vector_times<L: Lane>([a, b, c]: [L; 3], [w, x, y, z]: [L; 4]) -> [L; 4] {
    [-(a * x + b * y + c * z), a * w + b * z - c * y, b * w + c * x - a * z, c * w + a * y - b * x]
}

/// q v for a vector v on the body's axes.
#[inline(always)]
pub(crate) fn times_vector<L: Lane>([w, x, y, z]: [L; 4], [a, b, c]: [L; 3]) -> [L; 4] {
    [-(a * x + b * y + c * z), a * w + c * y - b * z, b * w + a * z - c * x, c * w + b * x - a * y]
}

/// q exp(e3 angle/2): turned by the angle (rad) about the body's third axis.
#[inline(always)]
pub(crate) fn spun([w, x, y, z]: [f64; 4], angle: f64) -> [f64; 4] {
    let (s, c) = sincos(0.5 * angle);
    [w * c - z * s, x * c + y * s, y * c - x * s, z * c + w * s]
}

/// by q + more: the change of q by a turn, small as the turn is, so that its rounding is too.
#[inline(always)]
pub(crate) fn stretched_and(by: f64, q: [f64; 4], more: [f64; 4]) -> [f64; 4] {
    core::array::from_fn(|i| by * q[i] + more[i])
}
