//! The closed form that a scene's type has is the one that `solve` takes.

use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::GravityAtLever;
use rotation_dynamics::frame::BodyVector;
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::scene::Scene;
use support::{Errors, assert_largest};

fn scene(moments: [f64; 3]) -> (Scene<()>, State) {
    let [i1, i2, i3] = moments;
    let body = RigidBody::new(PrincipalMoments::new(i1, i2, i3).expect("a body"));
    let (phi, theta, zeta) = (0.4, 0.9, -0.3);
    let attitude = Attitude::from_euler(EulerAngles { phi, theta, zeta }).expect("angles");
    let start = body.state(attitude, BodyVector::new(0.3, -0.2, 2.0));
    (Scene::new(body), start.expect("a state"))
}

#[test]
fn the_type_and_the_dial_have_one_closed_form() {
    let gravity = GravityAtLever::new(0.5, 0.8).expect("gravity");
    let mut apart = Errors::of("exact and solved");
    let mut twin = Errors::of("the free body for the heavy one");
    for moments in [[1.0, 1.0, 0.6], [1.0, 1.4, 0.6]] {
        let (free, start) = scene(moments);
        let exact = free.exact(&start).expect("a motion");
        for t in [0.1, 3.0, 40.0] {
            let solved = free.solve(&start, t, 1e-6).expect("solved");
            assert_eq!(solved.method, "closed form of the free body");
            apart.push(exact.attitude(t).angle_to(&solved.state.attitude));
            let heavy = free.with(gravity);
            let solved = heavy.solve(&start, t, 1e-6).expect("solved");
            twin.push(exact.attitude(t).angle_to(&solved.state.attitude));
            if free.body().moments().is_symmetric() {
                assert_eq!(solved.method, "closed form of the heavy top");
                let exact = heavy.exact(&start).expect("a motion");
                let attitude = exact.try_attitude(t).expect("a time");
                apart.push(attitude.angle_to(&solved.state.attitude));
            }
        }
    }
    assert_largest!(apart, 9, @"0");
    twin.exceed(1e-4, 6);
    let (free, start) = scene([1.0, 1.4, 0.6]);
    let refused = free.with(gravity).exact(&start).expect_err("refused");
    assert!(refused.to_string().contains("I2 - I1"), "{refused}");
}
