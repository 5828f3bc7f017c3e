//! A cone with a level axis that rolls on its rim: in closed form, by the sums over its particles, and
//! as a body on a joint with a force in place of the table.

// ANCHOR: physics
use super::Parameters;
use super::cone::{Sums, UP, level, placed};
use kit::prelude::*;
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::{Effect, Torque};
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::scene::Scene;

/// omega over Omega, outward along the axis and upward.
pub fn angular_velocity(a: f64) -> [f64; 2] {
    [-1.0 / tan(a), 1.0]
}

/// L over M h^2 Omega, outward along the axis and upward.
pub fn angular_momentum(a: f64) -> [f64; 2] {
    [-0.3 * tan(a), 0.6 * (1.0 + 0.25 * tan(a) * tan(a))]
}

/// T over M h^2 Omega^2.
pub fn kinetic_energy(a: f64) -> f64 {
    0.075 * (5.0 + 1.0 / (cos(a) * cos(a)))
}

/// The force of the table over the weight, with w = h Omega^2/g, if it only presses upward.
pub fn pressure(a: f64, w: f64) -> f64 {
    0.75 - w * angular_momentum(a)[0]
}

/// The cone after its axis has turned by `turn`, by turns alone: about its own axis, and with it
/// about the vertical.
pub fn rolled(a: f64, turn: f64) -> Result<Attitude> {
    placed(0.0, turn, -turn / tan(a))
}

/// The sums over the particles at this rate, when the axis points along X.
pub fn summed(p: &Parameters, rate: f64) -> Result<Sums> {
    let step = 0.02 * sin(p.half_angle) / rate;
    p.sums(|t| rolled(p.half_angle, rate * t), step)
}

/// The force of the table, N, by the particles: what their motion needs beyond the moment of
/// their weight about the vertex, the table must supply at the distance h.
pub fn pressed(p: &Parameters, rate: f64) -> Result<f64> {
    let particles = p.particles();
    let moment: f64 = particles.iter().map(|(m, r)| m * p.gravity * r.z()).sum();
    Ok((moment - summed(p, rate)?.moment.y()) / p.height)
}

// ANCHOR: scene
/// The cone on its joint, with a constant force `n` in place of the table.
pub fn without_table(
    p: &Parameters,
    n: f64,
) -> Result<(Scene<impl Effect + Clone + Send + Sync + 'static>, State)> {
    let (a, h, i) = (p.half_angle, p.height, p.mass * p.height * p.height);
    let own = 0.3 * i * tan(a) * tan(a);
    let across = 0.6 * i * (1.0 + 0.25 * tan(a) * tan(a));
    let moments = PrincipalMoments::symmetric(across, own)?;
    // N at the rim, at the distance h, and the weight at 3 h/4; taken together, since they all
    // but cancel if the cone is slender.
    let lever = h * (n - 0.75 * p.mass * p.gravity);
    let forces = Torque::on_space("table and weight", move |_, _, state: &State| {
        state.attitude.axis().cross(&(UP * lever))
    });
    let scene = Scene::new(RigidBody::new(moments)).with(forces.smooth());
    let start = rolled(a, 0.0)?;
    let [along, up] = angular_velocity(a).map(|part| part * p.rate);
    let rates: BodyVector = start.to_body(level(0.0) * along + UP * up);
    let state = scene.body().state(start, rates)?;
    Ok((scene, state))
}
// ANCHOR_END: scene
// ANCHOR_END: physics
