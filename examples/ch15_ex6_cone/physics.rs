//! A cone that lies on a table and rolls about its vertex: in closed form, and by the sums over its
//! particles.

// ANCHOR: physics
use super::Parameters;
use super::cone::{Sums, placed};
use kit::prelude::*;
use rotation_dynamics::attitude::Attitude;

/// omega along the line of contact, outward, over Omega.
pub fn angular_velocity(a: f64) -> f64 {
    -1.0 / tan(a)
}

/// L over M h^2 Omega, outward along the line of contact and upward.
pub fn angular_momentum(a: f64) -> [f64; 2] {
    let square = cos(a) * cos(a);
    let rho = -0.15 * tan(a) * (1.0 + 5.0 * square);
    [rho, 0.15 * (5.0 * square - 1.0)]
}

/// T over M h^2 Omega^2.
pub fn kinetic_energy(a: f64) -> f64 {
    0.075 * (1.0 + 5.0 * cos(a) * cos(a))
}

/// Where the table bears the cone, over h, from the vertex, with w = h Omega^2/g.
pub fn centre_of_pressure(a: f64, w: f64) -> f64 {
    0.75 * cos(a) - angular_momentum(a)[0] * w
}

/// The w at which it tips over the rim.
pub fn tips(a: f64) -> f64 {
    (1.0 - 0.75 * cos(a) * cos(a)) / (-cos(a) * angular_momentum(a)[0])
}

/// The friction that the motion needs, over the weight.
pub fn needed(a: f64, w: f64) -> f64 {
    0.75 * w * cos(a)
}

// ANCHOR: sums
/// The cone after the line of contact has turned by `turn`, by turns alone: about its own axis,
/// and with it about the vertical.
pub fn rolled(a: f64, turn: f64) -> Result<Attitude> {
    placed(a, turn, -turn / sin(a))
}

/// The sums over the particles at this rate, when the line of contact has the azimuth 0.
pub fn summed(p: &Parameters, rate: f64) -> Result<Sums> {
    let h = 0.02 * sin(p.half_angle) / rate;
    p.sums(|t| rolled(p.half_angle, rate * t), h)
}

/// Where the table must bear the cone, m from the vertex, by the particles: what they need beyond
/// their weight comes from the table, whose upward part has this moment about the vertex.
pub fn borne_at(p: &Parameters, rate: f64) -> Result<f64> {
    let (sums, weight) = (summed(p, rate)?, p.mass * p.gravity);
    let at = rolled(p.half_angle, 0.0)?;
    let parts = p.particles();
    let centre: SpaceVector = parts.iter().map(|(m, r)| at.to_space(*r) * *m).sum();
    // About phi = Z x rho, which is Y here: N d = (moment of the weight) - (moment needed).
    Ok((p.gravity * centre.x() - sums.moment.y()) / (weight + sums.force.z()))
}
// ANCHOR_END: sums
// ANCHOR_END: physics
