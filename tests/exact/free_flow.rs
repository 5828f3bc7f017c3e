//! The exact free rotation over a step: against 25-digit values (tests/data/free_flow.txt,
//! written by free_flow.py), against the closed form, and over many steps.

use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::RigidBody;
use rotation_dynamics::exact::free_body::{FreeBody, FreeFlow};
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::Separable;
use rotation_dynamics::math::EPS;
use rotation_dynamics::scene::Scene;
use support::{Errors, assert_error, assert_largest};

struct Case {
    kind: String,
    moments: PrincipalMoments,
    momentum: BodyVector,
    dt: f64,
    /// The quaternion less 1.
    want: [f64; 4],
}

fn cases() -> Vec<Case> {
    let lines = include_str!("../data/free_flow.txt").lines();
    lines
        .map(|line| {
            let (kind, numbers) = line.split_once(' ').expect("a kind and numbers");
            let v: Vec<f64> = numbers.split(' ').map(|x| x.parse().expect("a number")).collect();
            Case {
                kind: kind.to_owned(),
                moments: PrincipalMoments::new(v[0], v[1], v[2]).expect("a body"),
                momentum: BodyVector::new(v[3], v[4], v[5]),
                dt: v[6],
                want: [v[7], v[8], v[9], v[10]],
            }
        })
        .collect()
}

/// The largest error in eps of the largest component of the increment. A step that
/// is not short is seen through its attitude.
fn error(case: &Case, damage: f64) -> f64 {
    let flow = FreeFlow::new(case.moments);
    let [w, x, y, z] = flow.turn(case.momentum, case.dt * (1.0 + damage)).quaternion();
    let [less, a, b, c] = case.want;
    let [mut size, mut off] = ["increment", "its error"].map(Errors::of);
    case.want.iter().for_each(|v| size.push(*v));
    [x - a, y - b, z - c].into_iter().for_each(|v| off.push(v));
    // Its scalar part ends in an eps of 1.
    let along = ((w - 1.0) - less).abs() - EPS;
    if along.is_nan() || along > 0.0 {
        off.push(along);
    }
    off.largest() / (size.largest() * EPS)
}

#[test]
fn a_step_is_right_to_a_few_eps_of_itself() {
    // Needle 12.25, long 11.4 (20 rad), step 6.7, disc 5.8, short 4.8,
    // near-symmetric 4.8, axis 2.8, near-sphere 2.6, separatrix 1.3, half-turn 1.2.
    let mut errors = Errors::of("steps");
    let mut damaged = Errors::of("steps too long by 1e-14");
    for case in cases() {
        errors.push_at(error(&case, 0.0), &case.kind);
        damaged.push_at(error(&case, 1e-14), &case.kind);
    }
    assert_largest!(errors, 78, @"12.3");
    damaged.exceed(12.3, 78);
}

/// A rotation too long for the series goes by the closed form: no seam between them.
#[test]
fn long_steps_join_the_closed_form() {
    let moments = PrincipalMoments::new(1.0, 2.0, 2.5).expect("a body");
    let momentum = BodyVector::new(0.8, -0.5, 0.6);
    let rates = BodyVector::new(0.8, -0.25, 0.24);
    let exact = FreeBody::new(moments, Attitude::IDENTITY, rates).expect("a motion");
    let flow = FreeFlow::new(moments);
    let mut errors = Errors::in_units_of(EPS, "a long step");
    for k in 1..=200 {
        for dt in [0.5 * f64::from(k), -0.5 * f64::from(k)] {
            let turn = flow.turn(momentum, dt);
            errors.add(turn.angle_to(&exact.attitude(dt)), 0.0, dt.abs().max(1.0));
        }
    }
    // Per time unit, in which the body turns by 0.9 rad.
    assert_largest!(errors, 400, @"8.70");
}

/// What cannot turn does not; what is not finite is not hidden.
#[test]
fn limits() {
    let flow = FreeFlow::new(PrincipalMoments::new(1.0, 2.0, 2.5).expect("a body"));
    let (rest, moving) = (BodyVector::zero(), BodyVector::new(0.8, -0.5, 0.6));
    assert_eq!(flow.turn(rest, 1e9), Attitude::IDENTITY);
    assert_eq!(flow.turn(moving, 0.0), Attitude::IDENTITY);
    assert!(flow.turn(moving, f64::NAN).quaternion()[0].is_nan());
    assert!(flow.turn(moving, f64::INFINITY).quaternion()[0].is_nan());
    // The way back is the way there.
    let there = flow.turn(moving, 0.3);
    let back = flow.turn(there.to_body(space(moving)), -0.3);
    let off = (there * back).angle_to(&Attitude::IDENTITY);
    assert_error!(off, 0.28 eps);
}

fn space(v: BodyVector) -> SpaceVector {
    SpaceVector::from_array(v.to_array())
}

/// A million flows, each set up anew: the energy walks at random, L stays to the bit.
#[test]
fn a_million_steps() {
    let moments = PrincipalMoments::new(1.0, 2.0, 2.5).expect("a body");
    let rates = BodyVector::new(0.8, -0.25, 0.24);
    let scene = Scene::new(RigidBody::new(moments));
    let start = scene.body().state(Attitude::IDENTITY, rates).expect("finite");
    let exact = FreeBody::new(moments, Attitude::IDENTITY, rates).expect("a motion");
    let mut point = scene.enter(&start).expect("any body");
    let (dt, mut angle) = (0.3, f64::NAN);
    let mut energy = ["energy, early", "energy, late"].map(|half| Errors::in_units_of(EPS, half));
    for step in 1..=1_000_000_u32 {
        scene.flow(&mut point, dt);
        scene.settle(&mut point);
        if step % 10_000 == 0 {
            let t = dt * f64::from(step);
            let state = scene.leave(&point, t).expect("finite");
            let half = usize::from(step > 500_000);
            energy[half].push(scene.energy(&state) / scene.energy(&start) - 1.0);
            assert_eq!(state.angular_momentum, start.angular_momentum);
            angle = state.attitude.angle_to(&exact.attitude(t)) / t;
        }
    }
    // 0.23 eps sqrt(steps), and a phase that is off by 1.4e-14 of itself.
    let [early, late] = energy;
    assert_largest!(early, 50, @"226");
    assert_largest!(late, 50, @"228");
    assert_error!(angle, 1.3e-14);
}
