//! What a free body keeps through very many steps: a share of it here, the whole by hand
//! (`benches/record/long.txt`).

use rotation_dynamics::accuracy::{Carrier, Fineness};
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::RigidBody;
use rotation_dynamics::frame::BodyVector;
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::Method;
use rotation_dynamics::scene::Scene;
use support::EPS;

/// How far norm of the quaternion, angular momentum and energy are off after so many steps of
/// half a second, each relative.
fn off(method: Method, steps: u64) -> [f64; 3] {
    let body = RigidBody::new(PrincipalMoments::new(1.0, 1.3, 1.7).unwrap());
    let scene = Scene::new(body);
    let rates = BodyVector::new(0.3, 0.2, 1.0);
    let start = body.state(Attitude::IDENTITY, rates).unwrap();
    let carrier = Carrier::new(method, Fineness::Steps(steps)).unwrap();
    let (end, _) = carrier
        .advance_as_usual(&scene, [0.0, 0.5 * steps as f64], &start)
        .unwrap();
    let norm: f64 = end.attitude.quaternion().iter().map(|c| c * c).sum();
    let momentum = (end.angular_momentum - start.angular_momentum).norm();
    let energy = |state| {
        let [p, q, r] = body.angular_velocity(state).to_array();
        0.5 * (p * p + 1.3 * q * q + 1.7 * r * r)
    };
    [
        norm - 1.0,
        momentum / start.angular_momentum.norm(),
        energy(&end) / energy(&start) - 1.0,
    ]
}

/// The norm to a rounding, the momentum exactly (nothing turns it), the energy to a
/// rounding for each step; RK4 in the same steps is beyond that.
fn kept(steps: u64) -> [f64; 3] {
    let [norm, momentum, energy] = off(Method::GaussLegendre16, steps);
    println!("{steps} steps: norm {norm:e}, momentum {momentum:e}, energy {energy:e}");
    assert!(norm.abs() <= 4.0 * EPS, "{norm:e}");
    assert_eq!(momentum, 0.0);
    assert!(energy.abs() <= EPS * steps as f64, "{energy:e}");
    [norm, momentum, energy]
}

#[test]
fn a_hundred_thousand_steps() {
    let steps = 100_000;
    kept(steps);
    let [.., energy] = off(Method::Rk4, steps);
    assert!(energy.abs() > 10.0 * EPS * steps as f64, "{energy:e}");
}

/// `cargo test --package checks --test integrators -- --ignored ten_million --nocapture`.
#[test]
#[ignore = "ten million steps"]
fn ten_million_steps() {
    kept(10_000_000);
}

/// The same with `a_billion`.
#[test]
#[ignore = "a billion steps: the better part of an hour"]
fn a_billion_steps() {
    kept(1_000_000_000);
}
