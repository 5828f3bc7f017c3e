//! Scenes with effects drawn at random, through `solve`: an answer with a promise, or a
//! reason; never a panic, a NaN or a run without end.

use crate::{Held, drawn, holds, or_refused, within};
use proptest::prelude::*;
use rotation_dynamics::accuracy::Limits;
use rotation_dynamics::body::RigidBody;
use rotation_dynamics::effects::{
    GravityAtLever, GravityGradient, InternalDissipation, ViscousFriction,
};
use rotation_dynamics::frame::SpaceVector;
use rotation_dynamics::scene::Scene;

#[test]
fn what_is_granted_is_finite_and_keeps_what_it_must() {
    let effects = (drawn::decades(-6.0..1.0), drawn::decades(-6.0..0.0), 0..4_usize);
    let inputs =
        (drawn::moments(), drawn::attitude(), drawn::rates(), effects, 0.1..20.0, 2.0..9.0_f64);
    holds(
        "scenes",
        60,
        0.5,
        inputs,
        |(moments, attitude, rates, (strong, weak, which), radians, digits)| {
            let body = RigidBody::new(moments);
            let start = or_refused!(body.state(attitude, rates));
            let rate = rates.norm();
            let [i1, i2, i3] = moments.to_array();
            let most = i1.max(i2).max(i3);
            let tolerance = rotation_dynamics::math::exp(-digits * core::f64::consts::LN_10);
            let limits = Limits { budget: 300_000, ..Limits::default() };
            let (t, scene) = (radians / rate, Scene::new(body));
            let weight = strong * most * rate * rate;
            let solved = match which {
                0 => scene
                    .with(or_refused!(GravityAtLever::new(weight, 1.0)))
                    .solve_with(&start, t, tolerance, &limits),
                1 => scene
                    .with(or_refused!(ViscousFriction::about_axis(weak * most * rate)))
                    .solve_with(&start, t, tolerance, &limits),
                2 => {
                    let down = SpaceVector::new(1.0, 0.0, 0.0);
                    scene
                        .with(or_refused!(GravityGradient::fixed(weak * rate, down)))
                        .solve_with(&start, t, tolerance, &limits)
                }
                _ => {
                    let size = start.angular_momentum.norm();
                    scene
                        .with(or_refused!(InternalDissipation::new(weak / size)))
                        .solve_with(&start, t, tolerance, &limits)
                }
            };
            let solved = or_refused!(solved);
            prop_assert!(solved.state.angular_momentum.is_finite());
            within!(solved.estimate, tolerance, "estimate");
            if which == 3 {
                prop_assert_eq!(solved.state.angular_momentum, start.angular_momentum);
            }
            Ok(Held::Yes)
        },
    );
}
