//! The notes' top: a = 2, b = 1.2, c = 0.2 from rest in theta (16.2, fig. 3).

use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::GravityAtLever;
use rotation_dynamics::frame::BodyVector;
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::math::{cos, sin};
use rotation_dynamics::scene::Scene;
use support::Errors;

pub type HeavyTop = Scene<((), GravityAtLever)>;

/// The body equivalent to the dimensionless problem, and its start at this
/// theta, at rest in theta: I1 = 1, I3 = a, m g l = c, L_z = sqrt(a), L_Z = sqrt(a) b.
pub fn top(a: f64, b: f64, c: f64, theta: f64) -> (HeavyTop, State) {
    let body = RigidBody::new(PrincipalMoments::symmetric(1.0, a).expect("a body"));
    let scene = Scene::new(body).with(GravityAtLever::new(c, 1.0).expect("gravity"));
    let angles = EulerAngles { phi: 0.0, theta, zeta: 0.0 };
    let attitude = Attitude::from_euler(angles).expect("angles");
    let precession = a.sqrt() * (b - cos(theta)) / sin(theta);
    let omega = BodyVector::new(0.0, precession, 1.0 / a.sqrt());
    let start = body.state(attitude, omega).expect("a state");
    (scene, start)
}

/// The smallest theta of the top of fig. 3 at E~ = 0.55.
pub const THETA_3: f64 = 0.359_515_098_053_132_17;

/// The top of fig. 3 at E~ = 0.55, from its smallest theta.
pub fn figure_3() -> (HeavyTop, State) {
    top(2.0, 1.2, 0.2, THETA_3)
}

/// Angle between two attitudes (rad) and length of the difference of the
/// momenta, the larger of the two.
pub fn distance(a: &State, b: &State) -> f64 {
    let mut errors = Errors::of("attitude and momentum");
    errors.push(a.attitude.angle_to(&b.attitude));
    errors.push((a.angular_momentum - b.angular_momentum).norm());
    errors.largest()
}
