//! Effects: torque against potential, and what an effect says it keeps.

use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::{Effect, GravityAtLever, Properties};
use rotation_dynamics::frame::SpaceVector;
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::scene::Scene;
use support::{Errors, assert_largest, derivative};

fn body() -> RigidBody {
    RigidBody::new(PrincipalMoments::symmetric(1.0, 0.5).expect("a body"))
}

fn turned(attitude: &Attitude, axis: [f64; 3], angle: f64) -> State {
    let rotation = SpaceVector::from_array(axis.map(|c| c * angle));
    State {
        attitude: attitude.turned_in_space(rotation).expect("a rotation"),
        angular_momentum: SpaceVector::new(0.3, -0.2, 0.9),
    }
}

/// The torque about each fixed axis is minus the slope of the potential.
fn slope_errors(effect: &impl Effect) -> Errors {
    let mut errors = Errors::of("torque against slope");
    for i in 0..30 {
        let i = f64::from(i);
        let angles = EulerAngles { phi: 0.7 * i, theta: 0.1 * i, zeta: -0.3 * i };
        let attitude = Attitude::from_euler(angles).expect("angles");
        let torque = effect.torque(0.0, &body(), &turned(&attitude, [1.0, 0.0, 0.0], 0.0));
        for (k, torque) in torque.to_array().into_iter().enumerate() {
            let mut axis = [0.0; 3];
            axis[k] = 1.0;
            let energy =
                |angle| effect.potential_energy(0.0, &body(), &turned(&attitude, axis, angle));
            errors.push(torque + derivative(energy, 0.0, 1e-3));
        }
    }
    errors
}

#[test]
fn torque_is_the_slope_of_the_potential() {
    let up = GravityAtLever::new(2.0, 0.7).expect("gravity");
    let down = GravityAtLever::new(2.0, -0.7).expect("gravity");
    assert_largest!(slope_errors(&()), 90, @"0");
    // The error of the difference quotient.
    assert_largest!(slope_errors(&up), 90, @"2.96e-13");
    assert_largest!(slope_errors(&down), 90, @"2.96e-13");
    assert_largest!(slope_errors(&((), up)), 90, @"2.96e-13");
    assert_largest!(slope_errors(&((((), up), down), up)), 90, @"2.96e-13");
    // The sign of the torque turned round: measured 2.8, twice the largest torque.
    struct Wrong(GravityAtLever);
    impl Effect for Wrong {
        const PROPERTIES: Properties = GravityAtLever::PROPERTIES;
        fn name(&self) -> &'static str {
            "wrong"
        }
        fn torque(&self, t: f64, body: &RigidBody, state: &State) -> SpaceVector {
            -self.0.torque(t, body, state)
        }
        fn potential_energy(&self, t: f64, body: &RigidBody, state: &State) -> f64 {
            self.0.potential_energy(t, body, state)
        }
        fn torque_scale(&self, t: f64, body: &RigidBody, state: &State) -> f64 {
            self.0.torque_scale(t, body, state)
        }
    }
    assert!(slope_errors(&Wrong(up)).largest() > 1.0);
}

#[test]
fn gravity_turns_about_neither_axis_nor_vertical() {
    let gravity = GravityAtLever::new(2.0, 0.7).expect("gravity");
    let mut along = Errors::of("torque about the axis");
    for i in 0..100 {
        let angles =
            EulerAngles { phi: 0.37 * f64::from(i), theta: 0.03 * f64::from(i), zeta: 0.0 };
        let state = State {
            attitude: Attitude::from_euler(angles).expect("angles"),
            angular_momentum: SpaceVector::zero(),
        };
        let axis = state.attitude.axis();
        let torque = gravity.torque(0.0, &body(), &state);
        assert_eq!(torque.z(), 0.0);
        along.push(torque.dot(&axis));
    }
    // A rounding of products of order 1.4.
    assert_largest!(along, 100, @"1.11e-16");
}

#[test]
fn what_is_absent_takes_no_room() {
    use core::mem::size_of;
    assert_eq!(size_of::<Scene<()>>(), size_of::<RigidBody>());
    assert_eq!(
        size_of::<Scene<((), GravityAtLever)>>(),
        size_of::<RigidBody>() + size_of::<GravityAtLever>()
    );
}

#[test]
fn bad_input() {
    let message = |weight, lever| {
        let refused = GravityAtLever::new(weight, lever).expect_err("refused");
        refused.to_string()
    };
    assert_eq!(message(-1.0, 1.0), "weight = -1 is not allowed: it must be greater than 0");
    assert_eq!(message(f64::NAN, 1.0), "weight = NaN is not a finite number");
    assert_eq!(message(1.0, f64::INFINITY), "lever = inf is not a finite number");
    assert_eq!(message(1e200, 1e200), "weight times lever = inf is not a finite number");
}
