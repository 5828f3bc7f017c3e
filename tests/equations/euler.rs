//! Euler's equations, on axes that turn with the body: a scene that is stepped on fixed axes obeys them.

use rotation_dynamics::accuracy::Limits;
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::RigidBody;
use rotation_dynamics::effects::Torque;
use rotation_dynamics::frame::BodyVector;
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::motion::Motion;
use rotation_dynamics::scene::Scene;
use support::{Errors, assert_largest, derivative};

/// Three different moments and a torque on the body's axes: the scene is stepped on fixed axes, and
/// its rates on the body are differentiated. The twin: the torque with the other sign.
#[test]
fn eulers_equations_hold_with_a_torque() {
    let moments = [1.0, 1.5, 0.8];
    let body = RigidBody::new(PrincipalMoments::new(moments[0], moments[1], moments[2]).unwrap());
    let torque = [0.3, -0.2, 0.4];
    let push = Torque::on_body("push", move |_, _, _| BodyVector::from_array(torque)).smooth();
    let start = body.state(Attitude::IDENTITY, BodyVector::new(0.4, -0.7, 1.1)).unwrap();
    let scene = Scene::new(body).with(push);
    let motion = scene.solve_along(&start, 5.0, 1e-13, &Limits::default()).unwrap();
    let rates = |t: f64| body.angular_velocity(&motion.try_state(t).unwrap()).to_array();
    let (mut errors, mut twin) =
        (Errors::of("I dOmega/dt"), Errors::of("with the torque reversed"));
    for t in [0.7, 2.1, 3.3, 4.6] {
        let omega = rates(t);
        for (i, j, k) in [(0, 1, 2), (1, 2, 0), (2, 0, 1)] {
            let left = moments[i] * derivative(|t| rates(t)[i], t, 2e-3);
            let turned = (moments[j] - moments[k]) * omega[j] * omega[k];
            errors.push(left - (turned + torque[i]));
            twin.push(left - (turned - torque[i]));
        }
    }
    assert_largest!(errors, 12, @"5.35e-13");
    twin.exceed(0.1, 12);
}
