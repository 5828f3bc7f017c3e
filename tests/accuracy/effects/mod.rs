//! The effects of the library: what they claim, the motions they make, what they refuse.

mod claims;
mod kept;
mod listed;
mod motions;
mod pairs;
mod refusals;
mod stop;

use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::frame::BodyVector;
use rotation_dynamics::inertia::PrincipalMoments;

pub fn body(i1: f64, i2: f64, i3: f64) -> RigidBody {
    RigidBody::new(PrincipalMoments::new(i1, i2, i3).expect("a body"))
}

/// This body with these rates (rad/s), tilted.
pub fn tilted(body: &RigidBody, rates: [f64; 3]) -> State {
    let angles = EulerAngles { phi: 0.4, theta: 0.9, zeta: -0.3 };
    let attitude = Attitude::from_euler(angles).expect("an attitude");
    let rates = BodyVector::from_array(rates);
    body.state(attitude, rates).expect("a state")
}
