//! A block of steel in a laboratory, for the cards of the two pages on accuracy: what its model
//! leaves out, against what no method can better, by routes that the pages do not take.

#![allow(dead_code, reason = "other pages can be tested alone")]

use kit::Page;
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::body::RigidBody;
use rotation_dynamics::effects::Torque;
use rotation_dynamics::exact::free_body::FreeBody;
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::{Integrator, Rk4};
use rotation_dynamics::scene::Scene;
use support::{EPS, Errors};

use crate::answers::ledger;

/// The errors of what the page measures after so many periods, which are of its printed digits.
#[track_caller]
pub fn judged(page: &dyn Page, periods: f64) -> Errors {
    let (mut errors, mut damaged) = (Errors::of("measured"), Errors::of("with a third"));
    let [[told, gradient], [_, rounding]] = ledger(page, "")[..] else { panic!("two lines") };
    let [pulled, rounded, third] = block(periods);
    errors.push(gradient / pulled - 1.0);
    errors.push(rounding / rounded - 1.0);
    damaged.push(gradient / third - 1.0);
    damaged.exceed(1.0, 1);
    assert!(told / rounding > 5e9);
    errors
}

/// After so many periods: the gradient of gravity with its torque said here, by RK4; the
/// rounding by how fast the block turns in the end, since a free motion with a larger momentum is
/// the same but sooner; and the gradient with a third of its strength.
fn block(periods: f64) -> [f64; 3] {
    let tilted = EulerAngles { phi: 0.3, theta: 0.7, zeta: -0.4 };
    let attitude = Attitude::from_euler(tilted).unwrap();
    let moments = PrincipalMoments::new(1.0, 2.0, 8.0 / 3.0).unwrap();
    let omega = BodyVector::new(0.8, 0.4, 0.9 / (8.0 / 3.0));
    let (body, free) = (RigidBody::new(moments), FreeBody::new(moments, attitude, omega).unwrap());
    let (start, end) = (body.state(attitude, omega).unwrap(), periods * free.rate_period());
    let astray = |strength: f64| {
        let pull = Torque::on_body("gradient", move |_, body, state| {
            let down = state.attitude.to_body(SpaceVector::new(0.0, 0.0, -1.0));
            let [i, d] = [body.moments().to_array(), down.to_array()];
            down.cross(&BodyVector::new(i[0] * d[0], i[1] * d[1], i[2] * d[2])) * (strength * 9.81 / 6.371e6)
        });
        let scene = Scene::new(body).with(pull);
        let method = Rk4::new(200 + 3 * periods as u64).unwrap();
        let (mut state, mut most) = (start, 0.0_f64);
        for k in 0..100 {
            let [from, to] = [k, k + 1].map(|k| end * f64::from(k) / 100.0);
            state = method.advance(&scene, from, &state, to).unwrap().0;
            most = most.max(free.attitude(to).angle_to(&state.attitude));
        }
        most
    };
    [astray(3.0), free.angular_velocity(end).norm() * end * EPS, astray(1.0)]
}
