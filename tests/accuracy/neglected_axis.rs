//! What leaving an effect out is predicted to cost of the direction of the axis, against
//! runs with the effect and without.

use models::heavy_top::Steady;
use rotation_dynamics::accuracy::Limits;
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::{CoulombBearing, DiscDrag, Effect, GravityAtLever, Torque};
use rotation_dynamics::frame::BodyVector;
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::math::{asin, sin};
use rotation_dynamics::motion::Motion;
use rotation_dynamics::scene::Scene;
use support::{Errors, assert_largest};

/// A gyroscope in steady precession at this tilt.
fn gyroscope(theta: f64, spin: f64) -> Steady {
    let body = RigidBody::new(PrincipalMoments::symmetric(5.45e-3, 9.0e-4).expect("a body"));
    let gravity = GravityAtLever::new(4.9, 0.1).expect("gravity");
    Steady::new(body, gravity, theta, spin).expect("held")
}

/// The largest angle between the axes with the effect and without it, over the prediction,
/// and that between the attitudes over it.
fn over_prediction(steady: &Steady, effect: impl Effect) -> [f64; 2] {
    let weighed = steady.left_out().and_then(|left| left.predict(&effect, 0.0));
    let predicted = weighed.expect("weighed").predicted;
    let (limits, scene) = (Limits::default(), &steady.scene);
    let with = scene.with(effect);
    let with = with.solve_along(&steady.start, steady.turn, 1e-9, &limits).expect("with it");
    let plain = scene.solve_along(&steady.start, steady.turn, 1e-9, &limits).expect("without");
    let (mut of_axis, mut of_all) = (0.0_f64, 0.0_f64);
    for i in 1..=200 {
        let t = steady.turn * (f64::from(i) / 200.0);
        let [a, b] = [with.try_state(t), plain.try_state(t)].map(|state| state.expect("a state"));
        let apart = (a.attitude.axis() - b.attitude.axis()).norm();
        of_axis = of_axis.max(2.0 * asin(0.5 * apart));
        of_all = of_all.max(a.attitude.angle_to(&b.attitude));
    }
    [of_axis / predicted, of_all / predicted]
}

#[test]
fn the_axis_turns_as_far_as_predicted() {
    let mut errors = Errors::of("simulated over predicted, less one");
    let mut damaged = Errors::of("attitude over what is predicted for the axis, less one");
    let mut held = |steady: &Steady, [axis, all]: [f64; 2]| {
        errors.push_at(axis - 1.0, format!("{:?}", steady.start));
        damaged.push(all - 1.0);
    };
    for (theta, spin) in [(0.4, 314.0), (1.0, 314.0), (1.0, -500.0), (1.9, 200.0)] {
        let steady = gyroscope(theta, spin);
        let (body, start) = (steady.scene.body(), &steady.start);
        let bearing = CoulombBearing::new(3e-6, body, start, 0.0).expect("a bearing");
        held(&steady, over_prediction(&steady, bearing));
        let (density, viscosity) = (0.01 * DiscDrag::AIR_DENSITY, 1e2 * DiscDrag::AIR_VISCOSITY);
        let air = DiscDrag::new(0.06, density, viscosity, spin).expect("air");
        held(&steady, over_prediction(&steady, air));
        let drift =
            Torque::on_body("drift", |t, _, _: &State| BodyVector::new(0.0, 0.0, 2e-6 * sin(t)));
        held(&steady, over_prediction(&steady, drift.smooth()));
    }
    assert_largest!(errors, 12, @"3.11e-4");
    damaged.exceed(1.0, 12);
}

/// What only spins the body about its axis does not count.
#[test]
fn the_spin_alone_does_not_count() {
    let body = RigidBody::new(PrincipalMoments::symmetric(1.0, 0.5).expect("a body"));
    let start = body.state(Attitude::IDENTITY, BodyVector::new(0.0, 0.0, 4.0));
    let (start, scene) = (start.expect("a start"), Scene::new(body));
    let bearing = CoulombBearing::new(1e-4, &body, &start, 0.0).expect("a bearing");
    let candidates = scene.neglected_effects(&start, 10.0, 1e-3).expect("candidates");
    let [all, axis] = [candidates.clone(), candidates.of_axis()]
        .map(|c| c.predict(&bearing, 0.0).expect("weighed"));
    assert!(all.called_for && !axis.called_for && axis.predicted == 0.0, "{axis:?}");
}

/// A top that spins too slowly is not held at its tilt.
#[test]
fn a_slow_top_is_refused() {
    let body = RigidBody::new(PrincipalMoments::symmetric(5.45e-3, 9.0e-4).expect("a body"));
    let gravity = GravityAtLever::new(4.9, 0.1).expect("gravity");
    for (theta, spin) in [(0.4, 50.0), (1.0, 0.0), (1.9, f64::NAN)] {
        let said = Steady::new(body, gravity, theta, spin).expect_err("refused").to_string();
        assert!(said.contains("the weight lets the axis fall"), "{said}");
    }
}

/// What is measured is what the runs of [`over_prediction`] find, beside the prediction, and
/// has its price: without the effect there is a closed form.
#[test]
fn what_is_measured_is_what_was_predicted() {
    let mut errors = Errors::of("measured over predicted, less one");
    let mut damaged = Errors::of("the same of twice the effect");
    let steady = gyroscope(1.0, 314.0);
    let (body, start) = (steady.scene.body(), &steady.start);
    let candidates = steady.left_out().expect("candidates");
    for torque in [3e-6, 3e-7, 3e-8] {
        let bearing = |torque| CoulombBearing::new(torque, body, start, 0.0).expect("a bearing");
        let predicted = candidates.predict(&bearing(torque), 0.0).expect("weighed").predicted;
        let measured = candidates.measure(&bearing(torque)).expect("measured");
        errors.push_at(measured.error / predicted - 1.0, torque);
        let twice = candidates.measure(&bearing(2.0 * torque)).expect("measured");
        damaged.push(twice.error / predicted - 1.0);
        let [without, with] = measured.work.map(|work| work.torques());
        assert!(without == 0 && with > 100, "{without} {with}");
        assert!(measured.within <= 0.1 * predicted);
    }
    assert_largest!(errors, 3, @"2.68e-5");
    damaged.exceed(0.9, 3);
}

/// An effect that may be left out while the program runs: `None` is no effect, to the bit, and
/// `Some` is the effect, to the bit.
#[test]
fn an_optional_effect_is_the_effect_or_nothing() {
    let steady = gyroscope(1.0, 200.0);
    let (body, start) = (*steady.scene.body(), &steady.start);
    let bearing = CoulombBearing::new(3e-4, &body, start, 0.0).expect("a bearing");
    let solved =
        |scene: Result<_, _>| -> rotation_dynamics::accuracy::Solved { scene.expect("solved") };
    let plain = solved(steady.scene.solve(start, 1.0, 1e-9));
    let none = solved(steady.scene.with(None::<CoulombBearing>).solve(start, 1.0, 1e-9));
    assert_eq!((plain.state, plain.method, plain.work), (none.state, none.method, none.work));
    let with = solved(steady.scene.with(bearing).solve(start, 1.0, 1e-9));
    let some = solved(steady.scene.with(Some(bearing)).solve(start, 1.0, 1e-9));
    assert_eq!((with.state, with.method, with.work), (some.state, some.method, some.work));
    assert_ne!(with.state, plain.state);
    // The damaged twin: another strength is another motion.
    let other = CoulombBearing::new(2e-4, &body, start, 0.0).expect("a bearing");
    let other = solved(steady.scene.with(Some(other)).solve(start, 1.0, 1e-9));
    assert_ne!(with.state, other.state);
    // What one refuses, the other refuses.
    let twice = |a: Option<CoulombBearing>| {
        Scene::new(body).with(Some(bearing)).with(a).solve(start, 1.0, 1e-6)
    };
    let slowing =
        Torque::on_body("motor", |_, _, _: &State| BodyVector::new(0.0, 0.0, 1e-4)).smooth();
    let refused = Scene::new(body).with(Some(bearing)).with(Some(slowing)).solve(start, 1.0, 1e-6);
    let said = refused.expect_err("refused").to_string();
    assert!(
        said.contains("must be the only torque about the body's axis; here are also: motor"),
        "{said}"
    );
    assert!(twice(None).is_ok() && twice(Some(bearing)).is_err());
}
