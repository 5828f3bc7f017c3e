//! A coin that rolls around another: in closed form, rolled about the point where it touches, and as
//! four particles.

// ANCHOR: physics
use super::Parameters;
use core::f64::consts::SQRT_2;
use kit::prelude::*;
use rotation_dynamics::integrators::{Dop853, Event, Ode, Solution, ode, size_or};

/// The radius of the rolling coin over that of the fixed one; negative if it rolls inside.
pub fn ratio(p: &Parameters) -> Result<f64> {
    let r = p.outer / p.inner;
    let inside = from_to(0.001, 0.99).because("in a ring that it fills a coin cannot roll");
    let outside =
        from_to(0.001, 1000.0).because("beyond it the motion of one is lost beside the other");
    match p.side {
        "inside" => Ok(-inside.check("outer/inner, inside a ring,", r)?),
        _ => outside.check("outer/inner", r),
    }
}

/// Angular velocity of the coin over Omega; r is the ratio.
pub fn angular_velocity(r: f64) -> f64 {
    (1.0 + r) / r
}

/// Angular momentum about the middle of the fixed coin over M R1^2 Omega.
pub fn angular_momentum(r: f64) -> f64 {
    (1.0 + r) * (1.0 + 1.5 * r)
}

/// Kinetic energy over M R1^2 Omega^2.
pub fn kinetic_energy(r: f64) -> f64 {
    0.75 * (1.0 + r) * (1.0 + r)
}

// ANCHOR: rolling
/// The coin turns about the point at which it touches, which is at rest: its centre, a point of
/// its rim, the angle of the line of centres, the path of the point; lengths in the radius of the
/// fixed coin, and in place of the time the angle by which the coin has turned.
pub fn rolling(r: f64) -> impl Ode<6> {
    ode(move |_, &[x, y, rim_x, rim_y, _, _]: &[f64; 6]| {
        let contact = (x / (1.0 + r), y / (1.0 + r));
        let sense = r.signum();
        let about = |x: f64, y: f64| (sense * (contact.1 - y), sense * (x - contact.0));
        let (centre, rim) = (about(x, y), about(rim_x, rim_y));
        let orbit = (x * centre.1 - y * centre.0) / (x * x + y * y);
        [centre.0, centre.1, rim.0, rim.1, orbit, hypot(rim.0, rim.1)]
    })
    .scaled(size_or([1.0; 6]))
}
// ANCHOR_END: rolling

/// That motion until the line of centres has turned by `orbit`.
pub fn rolled(r: f64, orbit: f64, step: f64) -> Result<Solution<6>> {
    let there = Event::rising("there", |_, y: &[f64; 6]| y[4] - orbit).terminal();
    let long = 2.0 * orbit * angular_velocity(r).abs();
    Ok(Dop853::new(step)?.solve(&rolling(r), 0.0, &start(r), long, &[there])?)
}

/// At the start the mark of the coin touches.
pub fn start(r: f64) -> [f64; 6] {
    [1.0 + r, 0.0, 1.0, 0.0, 0.0, 0.0]
}

/// The place of a point of the coin, at this distance from its middle and with this angle from
/// the contact at the start, by turns alone: the coin's own, and that of the line of centres.
pub fn place(r: f64, turn: f64, distance: f64, angle: f64) -> [f64; 2] {
    let ((s, c), (t, d)) = (sincos(turn), sincos(angular_velocity(r) * turn + angle));
    [(1.0 + r) * c - distance * d, (1.0 + r) * s - distance * t]
}

/// L, T and the force towards the middle over M R1^2 Omega, M R1^2 Omega^2 and M R1 Omega^2, of
/// four particles that have the mass and the moment of inertia of the coin, from their places
/// shortly before and after.
pub fn particles(r: f64) -> [f64; 3] {
    let h = 1e-2 / angular_velocity(r).abs().max(1.0);
    let mut sums = [0.0; 3];
    for quarter in 0..4 {
        let angle = FRAC_PI_2 * f64::from(quarter) + 0.3;
        let at = |k: f64| place(r, k * h, r.abs() / SQRT_2, angle);
        let of = |sign: f64, [far, middle, near]: [f64; 3]| {
            [0, 1].map(|i| {
                let pair = |k: f64| at(k)[i] + sign * at(-k)[i];
                near * pair(1.0) + middle * pair(2.0) + far * pair(3.0)
            })
        };
        let ([x, y], v) = (at(0.0), of(-1.0, [1.0, -9.0, 45.0]).map(|d| d / (60.0 * h)));
        let twice = of(1.0, [2.0, -27.0, 270.0])[0] - 490.0 * x;
        sums[0] += 0.25 * (x * v[1] - y * v[0]);
        sums[1] += 0.125 * (v[0] * v[0] + v[1] * v[1]);
        sums[2] -= 0.25 * twice / (180.0 * h * h);
    }
    sums
}
// ANCHOR_END: physics
