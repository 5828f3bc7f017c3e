//! The free body in closed form, whatever its moments and rates.

use crate::{Held, drawn, holds, or_refused, within};
use proptest::prelude::*;
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::RigidBody;
use rotation_dynamics::exact::free_body::FreeBody;
use rotation_dynamics::frame::BodyVector;
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::math::ldexp;
use rotation_dynamics::motion::Motion;
use support::EPS;

/// Round-off in units of eps times the motion's own condition. The closed form is held to 64
/// of them by `tests/reference`.
const K: f64 = 64.0;

fn inputs() -> impl Strategy<Value = (PrincipalMoments, Attitude, BodyVector, f64)> {
    (drawn::moments(), drawn::attitude(), drawn::rates(), drawn::radians())
}

/// The time in which the fastest rate makes so many radians.
fn time(rates: BodyVector, radians: f64) -> f64 {
    radians / rates.to_array().iter().fold(0.0_f64, |most, w| most.max(w.abs()))
}

#[test]
fn energy_and_momentum_stay() {
    holds(
        "free body: what it keeps",
        3000,
        0.02,
        inputs(),
        |(moments, attitude, rates, radians)| {
            let motion = or_refused!(FreeBody::new(moments, attitude, rates));
            let now = or_refused!(motion.try_kinematics(time(rates, radians)));
            prop_assert!(now.is_finite());
            let energy = |w: BodyVector| {
                let each = moments.to_array().into_iter().zip(w.to_array());
                each.map(|(i, w)| i * w * w).sum::<f64>()
            };
            let (from, to) = (energy(rates), energy(now.angular_velocity));
            if from > 1e-280 {
                within!((to / from - 1.0).abs(), K * EPS, "energy");
            }
            let momentum = |w: BodyVector| {
                let [i1, i2, i3] = moments.to_array();
                BodyVector::new(i1 * w.x(), i2 * w.y(), i3 * w.z())
            };
            let (from, to) = (
                attitude.to_space(momentum(rates)),
                now.attitude.to_space(momentum(now.angular_velocity)),
            );
            within!((to - from).norm(), K * EPS * from.norm(), "L on the fixed axes");
            Ok(Held::Yes)
        },
    );
}

#[test]
fn a_turned_start_turns_the_motion() {
    let inputs = (inputs(), drawn::attitude());
    holds(
        "free body: the start turned",
        3000,
        0.02,
        inputs,
        |((moments, attitude, rates, radians), turn)| {
            let t = time(rates, radians);
            let motion = or_refused!(FreeBody::new(moments, attitude, rates));
            let turned = or_refused!(FreeBody::new(moments, turn * attitude, rates));
            let off = turned.attitude(t).angle_to(&(turn * motion.attitude(t)));
            within!(off, 16.0 * EPS, "attitude");
            Ok(Held::Yes)
        },
    );
}

/// e1, e2, e3 called e3, e1, e2.
#[test]
fn the_names_of_the_axes_do_not_matter() {
    let third = Attitude::from_quaternion([0.5; 4]).unwrap();
    holds(
        "free body: axes renamed",
        3000,
        0.02,
        inputs(),
        |(moments, attitude, rates, radians)| {
            let t = time(rates, radians);
            let ([i1, i2, i3], [a, b, c]) = (moments.to_array(), rates.to_array());
            let renamed = or_refused!(PrincipalMoments::new(i2, i3, i1));
            let motion = or_refused!(FreeBody::new(moments, attitude, rates));
            let other =
                or_refused!(FreeBody::new(renamed, attitude * third, BodyVector::new(b, c, a)));
            let off = (other.attitude(t) * third.inverse()).angle_to(&motion.attitude(t));
            let condition = or_refused!(motion.condition(t));
            within!(off, K * EPS * (1.0 + condition), "attitude");
            Ok(Held::Yes)
        },
    );
}

/// Powers of two as units of moment and time: the arithmetic is the same.
#[test]
fn units_do_not_matter() {
    let inputs = (inputs(), -60..60_i32, -60..60_i32);
    holds(
        "free body: units",
        3000,
        0.03,
        inputs,
        |((moments, attitude, rates, radians), mass, second)| {
            let t = time(rates, radians);
            let [i1, i2, i3] = moments.to_array().map(|i| ldexp(i, mass));
            let other = or_refused!(PrincipalMoments::new(i1, i2, i3));
            let faster = BodyVector::from_array(rates.to_array().map(|w| ldexp(w, -second)));
            let motion = or_refused!(FreeBody::new(moments, attitude, rates));
            let scaled = or_refused!(FreeBody::new(other, attitude, faster));
            let off = scaled.attitude(ldexp(t, second)).angle_to(&motion.attitude(t));
            let condition = or_refused!(motion.condition(t));
            within!(off, K * EPS * (1.0 + condition), "attitude");
            Ok(Held::Yes)
        },
    );
}

#[test]
fn there_and_back() {
    holds(
        "free body: there and back",
        2000,
        0.03,
        inputs(),
        |(moments, attitude, rates, radians)| {
            let t = time(rates, radians);
            let motion = or_refused!(FreeBody::new(moments, attitude, rates));
            let there = or_refused!(motion.try_kinematics(t));
            let back = or_refused!(FreeBody::new(moments, there.attitude, there.angular_velocity));
            let condition = or_refused!(motion.condition(t)) + or_refused!(back.condition(-t));
            // An error made on the way there may grow on the way back: for motions that are not wild.
            if condition < 1e9 {
                within!(
                    back.attitude(-t).angle_to(&attitude),
                    K * EPS * (1.0 + condition),
                    "attitude"
                );
            }
            Ok(Held::Yes)
        },
    );
}

/// Two methods: the closed form, and `solve`'s stepping with the same scene.
#[test]
fn stepping_agrees() {
    let inputs = (drawn::moments(), drawn::attitude(), drawn::rates(), 0.1..30.0);
    holds("free body: stepped", 60, 0.2, inputs, |(moments, attitude, rates, radians)| {
        let t = time(rates, radians);
        let body = RigidBody::new(moments);
        let start = or_refused!(body.state(attitude, rates));
        let motion = or_refused!(FreeBody::new(moments, attitude, rates));
        let solved = or_refused!(
            rotation_dynamics::scene::Scene::new(body).solve_by_stepping(&start, t, 1e-8)
        );
        within!(solved.state.attitude.angle_to(&motion.attitude(t)), 1e-8, "attitude");
        Ok(Held::Yes)
    });
}
