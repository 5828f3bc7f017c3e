//! How much the check of a power allows.

use super::*;
use crate::effects::Effect;
use crate::effects::{Conserved, GravityAtLever};
use crate::frame::BodyVector;
use crate::inertia::PrincipalMoments;

/// Gravity whose torque is longer than its potential says by a part of itself.
struct Stronger(GravityAtLever, f64);

impl Effect for Stronger {
    const PROPERTIES: Properties = Properties {
        on_rates: false,
        on_time: false,
        conserved: Conserved { energy: true, ..Conserved::NONE },
        ..Properties::ANYTHING
    };

    fn name(&self) -> &'static str {
        "stronger gravity"
    }

    fn torque(&self, t: f64, body: &RigidBody, state: &State) -> SpaceVector {
        Effect::torque(&self.0, t, body, state) * (1.0 + self.1)
    }

    fn potential_energy(&self, t: f64, body: &RigidBody, state: &State) -> f64 {
        Effect::potential_energy(&self.0, t, body, state)
    }
}

/// For a body that turns about the torque all of it is power: it may be off by 1e-5 of itself and
/// by no more, in either sense.
#[test]
fn a_power_may_be_off_by_what_is_said() {
    let body = RigidBody::new(PrincipalMoments::symmetric(1.0, 0.5).expect("a body"));
    let gravity = GravityAtLever::new(2.0, 0.4).expect("a weight");
    let tilted = Attitude::from_rotation_vector(SpaceVector::new(0.9, 0.0, 0.0)).expect("finite");
    let start = body.state(tilted, BodyVector::new(1.3, 0.0, 0.0)).expect("a state");
    let held = |off: f64| {
        let effect = Stronger(gravity, off);
        // So long a span that the step in time is no shorter than that of the turn.
        let checked = Checked::unlooked(&effect, &body, [0.0, 1e4], &start);
        let torque = Effect::torque(&effect, 0.0, &body, &start);
        checked.power(0.0, &start, torque).is_ok()
    };
    for part in [0.0, 0.99, -0.99] {
        assert!(held(part * POWER), "{part}");
    }
    for part in [1.01, -1.01] {
        assert!(!held(part * POWER), "{part}");
    }
}
