//! The rigid body and its state.

use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::error::Error;
use rotation_dynamics::frame::{BodyVector, DesignVector, SpaceVector};
use rotation_dynamics::inertia::{InertiaTensor, PrincipalMoments};
use rotation_dynamics::math::EPS;
use support::{Errors, assert_largest};

#[test]
fn a_body_turns_momentum_into_velocity() {
    let moments = PrincipalMoments::new(1.5, 2.0, 3.1).expect("a body");
    let body = RigidBody::new(moments);
    let mut velocity = Errors::in_units_of(EPS, "angular velocity");
    let mut energy = Errors::in_units_of(EPS, "kinetic energy");
    for i in 0..50 {
        for j in 0..20 {
            let (phi, theta, zeta) = (0.13 * i as f64, 0.15 * j as f64, 0.37 * (i + j) as f64);
            let attitude = Attitude::from_euler(EulerAngles { phi, theta, zeta }).expect("finite");
            let omega = BodyVector::new(0.3 + 0.1 * i as f64, -0.7 * j as f64, 1.1);
            let state = body.state(attitude, omega).expect("finite");
            let back = body.angular_velocity(&state);
            velocity.add((back - omega).norm(), 0.0, omega.norm());
            let tensor = InertiaTensor::diagonal(moments.to_array()).expect("a body");
            let drawn = DesignVector::from_array(omega.to_array());
            let want = tensor.kinetic_energy(drawn);
            energy.push(body.kinetic_energy(&state) / want - 1.0);
            let momentum = tensor.angular_momentum(drawn).to_array();
            let momentum = body.angular_momentum(&state) - BodyVector::from_array(momentum);
            velocity.add(momentum.norm(), 0.0, state.angular_momentum.norm());
        }
    }
    assert_largest!(velocity, 2 * 1000, @"16.2");
    assert_largest!(energy, 1000, @"22");
    // Damaged: the momentum taken on the fixed axes as if they were the body's.
    let attitude =
        Attitude::from_euler(EulerAngles { phi: 0.3, theta: 0.7, zeta: 0.1 }).expect("finite");
    let omega = BodyVector::new(0.3, -0.7, 1.1);
    let state = body.state(attitude, omega).expect("finite");
    let wrong = BodyVector::from_array(state.angular_momentum.to_array());
    assert!((wrong - body.angular_momentum(&state)).norm() > 0.1);
}

#[test]
fn a_state_is_finite() {
    let mut count = 0;
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for place in 0..3 {
            let mut l = [1.0; 3];
            l[place] = bad;
            assert!(State::new(Attitude::IDENTITY, SpaceVector::from_array(l)).is_err());
            let body = RigidBody::new(PrincipalMoments::symmetric(1.0, 1.0).expect("a body"));
            assert!(body.state(Attitude::IDENTITY, BodyVector::from_array(l)).is_err());
            count += 2;
        }
    }
    assert_eq!(count, 18);
    let body = RigidBody::new(PrincipalMoments::symmetric(1e10, 1e10).expect("a body"));
    let overflow = body.state(Attitude::IDENTITY, BodyVector::new(1e300, 0.0, 0.0));
    assert!(matches!(overflow, Err(Error::NotFinite { .. })));
}
