//! The effect of a problem on its span and on changed inputs.

use super::Limits;
use super::problem::{Acting, Problem};
use crate::attitude::Attitude;
use crate::body::{RigidBody, State};
use crate::effects::{Checked, IntegrableCase, Torque};
use crate::frame::BodyVector;
use crate::inertia::PrincipalMoments;

fn start(moments: PrincipalMoments) -> (RigidBody, State) {
    let body = RigidBody::new(moments);
    let start = body.state(Attitude::IDENTITY, BodyVector::new(0.1, 0.2, 0.3));
    (body, start.expect("a state"))
}

/// A span that is gone through backward is as long.
#[test]
fn steps_backward_are_as_long() {
    let (body, start) = start(PrincipalMoments::new(1.0, 2.0, 2.5).expect("a body"));
    let torque = Torque::on_body("torque", |_: f64, _: &RigidBody, _: &State| {
        BodyVector::new(0.3, -0.5, 0.8)
    });
    let longest = |t_end: f64| {
        let checked = Checked::unlooked(&torque, &body, [0.0, t_end], &start);
        Limits::default().longest_step(&torque, &checked, &[], 1.0, t_end)
    };
    assert_eq!([longest(12.8), longest(-12.8)], [0.8; 2]);
}

/// The inputs of a symmetric body change by what is said, and it stays symmetric.
#[test]
fn a_symmetric_body_stays_one() {
    let (body, start) = start(PrincipalMoments::symmetric(1.0, 0.5).expect("a body"));
    let checked = Checked::unlooked(&(), &body, [0.0, 1.0], &start);
    let problem = Problem {
        body,
        acting: Acting::of(&()),
        strength: 1.0,
        torque: 0.0,
        start,
        t_start: 0.0,
        t_end: 1.0,
        breaks: &[],
        longest_step: f64::INFINITY,
        checked: &checked,
        known: IntegrableCase::Free,
        damping: 0.0,
    };
    for row in 0..12 {
        let [i1, i2, i3] = problem.changed(row, 1e-6).expect("a body").body.moments().to_array();
        assert_eq!(i1, i2);
        for part in [i1, i3 / 0.5] {
            assert!(((part - 1.0).abs() - 1e-6).abs() < 1e-15, "{part}");
        }
    }
}
