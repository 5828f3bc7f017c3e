//! The conical pendulum: in closed form, by the Lagrangian in a plane that turns, and by Newton's law
//! on its string. The one number that decides is q = g/(l w^2).

// ANCHOR: physics
use kit::prelude::*;
use rotation_dynamics::exact::carlson;
use rotation_dynamics::integrators::{Dop853, Ode, Solution, newton, second_order, size_or};

/// Squares of w and of sqrt(g/l). The unit of time is 1/w, or sqrt(l/g) below the threshold.
pub fn squares(q: f64) -> [f64; 2] {
    [(1.0 / q).min(1.0), q.min(1.0)]
}

/// Angle of the cone, rad: its cosine is q. It is 0 if there is no cone.
pub fn cone(q: f64) -> f64 {
    atan2(((1.0 - q) * (1.0 + q)).max(0.0).sqrt(), q)
}

/// Angular frequency of small oscillations, the plane kept turning.
pub fn driven(q: f64) -> f64 {
    if q < 1.0 { ((1.0 - q) * (1.0 + q)).sqrt() } else { (1.0 - 1.0 / q).sqrt() }
}

/// The same for the bob left to itself on a cone.
pub fn free(q: f64) -> f64 {
    (1.0 + 3.0 * q * q).sqrt()
}

/// Period of the swing from rest at `angle` in the turning plane.
pub fn period(q: f64, angle: f64) -> Result<f64> {
    // h = sin^2(theta/2) swings between h0 and h1 or, if that is negative, 0.
    let (h0, rest) = (sin(0.5 * angle).powi(2), cos(0.5 * angle).powi(2));
    let h1 = (1.0 - q) - h0;
    if h1 < 0.0 {
        let [turning, hanging] = squares(q);
        let over = hanging - turning * rest; // -h1 in this unit of time
        return Ok(4.0 * carlson::rf(0.0, rest * over, turning * h0 + over)?);
    }
    Ok(2.0 * carlson::rf(0.0, h0 * (q + h0), h1 * rest)?)
}

// ANCHOR: motions
/// In a plane that turns at w, by the Lagrangian: `[theta, theta']`, time in 1/w (in sqrt(l/g)
/// below the threshold).
pub fn in_plane(q: f64, damping: f64) -> impl Ode<2> {
    second_order(move |_, theta, rate| force(q, theta) - 2.0 * damping * rate)
}

/// (w^2 cos(theta) - g/l) sin(theta); near the threshold the difference would lose its digits.
pub fn force(q: f64, theta: f64) -> f64 {
    let ([turning, hanging], half) = (squares(q), sin(0.5 * theta));
    let upright = if q < 1.0 { 1.0 - q } else { 1.0 / q - 1.0 };
    let difference = match upright.abs() < 1e-2 {
        true => upright - 2.0 * turning * half * half,
        false => turning * cos(theta) - hanging,
    };
    difference * sin(theta)
}

/// In space, held by the string alone, by Newton's law: `[x, y, z, x', y', z']`,
/// the support at the origin, lengths in l, time as above; with quadratic air drag.
pub fn on_string(q: f64, drag: f64) -> impl Ode<6> {
    let g = SpaceVector::new(0.0, 0.0, -squares(q)[1]);
    newton(move |_, [r, v]| g - r * tension(q, [r, v]) - v * (drag * v.norm()))
        .scaled(size_or([1.0; 6]))
}

/// Tension, over M l and the square of the unit of time: it keeps the bob at its distance.
pub fn tension(q: f64, [r, v]: [SpaceVector; 2]) -> f64 {
    (v.dot(&v) - squares(q)[1] * r.z()) / r.dot(&r)
}
// ANCHOR_END: motions

/// The state in space, the plane turning at `w` and having turned by `turn`.
pub fn in_space([theta, rate]: [f64; 2], w: f64, turn: f64) -> [f64; 6] {
    let ((s, c), (y, x), out) = (sincos(theta), sincos(turn), rate * cos(theta));
    let along = w * s;
    let (vx, vy) = (out * x - along * y, out * y + along * x);
    [s * x, s * y, -c, vx, vy, rate * s]
}

/// The motion from rest at `angle` in the turning plane.
pub fn swung(q: f64, damping: f64, angle: f64, end: f64, step: f64) -> Result<Solution<2>> {
    Ok(Dop853::new(step)?.solve(&in_plane(q, damping), 0.0, &[angle, 0.0], end, &[])?)
}
// ANCHOR_END: physics
