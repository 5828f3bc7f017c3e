//! What leaving an effect out is predicted to cost, against what it costs.

use rotation_dynamics::accuracy::{Limits, PredictedError};
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::{
    Effect, ElasticYielding, GravityAtLever, GravityGradient, InternalDissipation, Torque,
};
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::math::{log, sin};
use rotation_dynamics::motion::Motion;
use rotation_dynamics::scene::Scene;
use support::{Errors, assert_largest};

/// Times at which the motions are compared.
const TIMES: i32 = 200;

/// A prediction, the largest angle between the simulated motions, and the torques that the
/// simulation took over those of the prediction.
struct Held {
    what: &'static str,
    weighed: PredictedError,
    simulated: f64,
    price: f64,
}

fn held<E: Effect + Clone, C: Effect>(
    what: &'static str,
    scene: &Scene<E>,
    effect: C,
    start: &State,
    t_end: f64,
) -> Held {
    let rows = (scene.neglected_effects(start, t_end, 1e-3))
        .and_then(|called| called.candidate(&effect, 0.0))
        .expect("weighed");
    let weighed = rows.rows()[0];
    let tolerance = (1e-3 * weighed.predicted).min(1e-6);
    let with = scene.clone().with(effect);
    let limits = Limits::default();
    let with = (with.solve_along(start, t_end, tolerance, &limits)).expect("with it");
    let without = (scene.solve_along(start, t_end, tolerance, &limits)).expect("without it");
    let mut simulated: f64 = 0.0;
    for i in 1..=TIMES {
        let t = t_end * f64::from(i) / f64::from(TIMES);
        let [a, b] = [with.try_state(t), without.try_state(t)].map(|state| state.expect("a state"));
        simulated = simulated.max(a.attitude.angle_to(&b.attitude));
    }
    // Each derivative of the prediction asks for three torques of the scene, one of the effect.
    let price = with.solved().work.torques() as f64 / (4 * weighed.work.derivatives) as f64;
    Held { what, weighed, simulated, price }
}

fn tilted(body: &RigidBody, rates: [f64; 3]) -> State {
    let angles = EulerAngles { phi: 0.3, theta: 1.0, zeta: 0.2 };
    let attitude = Attitude::from_euler(angles).expect("angles");
    (body.state(attitude, BodyVector::from_array(rates))).expect("a state")
}

fn gyroscope() -> RigidBody {
    RigidBody::new(PrincipalMoments::symmetric(5.45e-3, 9.0e-4).expect("a body"))
}

fn odd() -> RigidBody {
    RigidBody::new(PrincipalMoments::new(1.0, 1.5, 0.8).expect("a body"))
}

/// Seven kinds of effect, each so strong.
fn all(strength: f64) -> Vec<Held> {
    let gravity = GravityAtLever::new(4.9, 0.1).expect("gravity");
    let bearing = Torque::on_space("bearing", move |_, _, state: &State| {
        let axis = state.attitude.axis();
        axis * (-1e-4 * strength * state.angular_momentum.dot(&axis))
    })
    .smooth();
    let body = gyroscope();
    let start = tilted(&body, [0.1, 0.0, 150.0]);
    let top = Scene::new(body).with(gravity);
    let mut all = vec![held("friction of a top", &top, bearing, &start, 2.0)];

    let satellite = RigidBody::new(PrincipalMoments::new(20.0, 90.0, 100.0).expect("a body"));
    let n0 = 1.1e-3 * strength.sqrt();
    let (normal, down) = (SpaceVector::new(0.0, 0.0, 1.0), SpaceVector::new(1.0, 0.0, 0.0));
    let gradient = GravityGradient::on_orbit(n0, normal, down).expect("an orbit");
    let start = tilted(&satellite, [0.05, 0.01, 0.02]);
    let free = Scene::new(satellite);
    all.push(held("gradient on a satellite", &free, gradient, &start, 600.0));

    let start = tilted(&body, [0.0, 0.0, 3000.0]);
    let weight = GravityAtLever::new(4.9 * strength, 0.1).expect("gravity");
    let free = Scene::new(body);
    all.push(held("gravity on a fast gyroscope", &free, weight, &start, 0.2));

    let body = odd();
    let start = tilted(&body, [0.5, 0.2, 2.0]);
    let heavy = Scene::new(body).with(GravityAtLever::new(1.0, 0.4).expect("gravity"));
    let general = Torque::on_body("general", move |t, _, state: &State| {
        let up = state.attitude.vertical();
        BodyVector::new(sin(1.3 * t), up.x(), -0.5 * up.y()) * (3e-4 * strength)
    })
    .smooth();
    all.push(held("a torque of time and attitude", &heavy, general, &start, 10.0));

    let thruster = Torque::on_body("thruster", move |t, _, _: &State| {
        let push = if (4.0..5.0).contains(&t) { 1e-3 } else { 0.0 };
        BodyVector::new(push * strength, 0.0, 0.0)
    })
    .smooth()
    .with_break_points(&[4.0, 5.0])
    .expect("rising");
    all.push(held("a thruster for a second", &heavy, thruster, &start, 10.0));

    let loss = InternalDissipation::new(3e-4 * strength).expect("a coefficient");
    let free = Scene::new(body);
    all.push(held("energy lost inside", &free, loss, &start, 10.0));

    let yielding = ElasticYielding::new(1e-4 * strength, 2.0).expect("a compliance");
    all.push(held("a body that yields", &free, yielding, &start, 10.0));
    all
}

/// |ln(predicted/simulated)| is below ln 2, far below for small effects.
#[test]
fn predictions_hold_for_small_effects() {
    let mut ratios = Errors::of("ln(predicted/simulated)");
    let mut twins = Errors::of("the same of a prediction for three times the effect");
    let mut prices: Vec<f64> = Vec::new();
    for strength in [1.0, 0.1, 0.01] {
        for case in all(strength) {
            let Held { what, weighed, simulated, price } = case;
            let ratio = weighed.predicted / simulated;
            println!(
                "{what} x {strength}: {:.2e} rad predicted, {simulated:.2e} simulated, ratio \
                 {ratio:.5}; simulation over prediction {price:.1} torques",
                weighed.predicted
            );
            assert!(weighed.linear, "{what}: {weighed:?}");
            ratios.push_at(log(ratio), (what, strength));
            twins.push_at(log(3.0 * ratio), (what, strength));
            prices.push(price);
        }
    }
    assert_largest!(ratios, 21, @"3.54e-3");
    twins.exceed(log(2.0), 21);
    prices.sort_by(f64::total_cmp);
    println!("simulation over prediction: median {:.1}", prices[prices.len() / 2]);
    assert_eq!(prices.len(), 21);
}

/// A hundred times stronger none is small, and every row says so.
#[test]
fn what_is_not_small_is_called_for_whatever_the_tolerance() {
    let mut ran = 0;
    for case in all(100.0) {
        println!("{}: {:?}, simulated {:.2}", case.what, case.weighed, case.simulated);
        assert!(!case.weighed.linear && case.weighed.called_for, "{}", case.what);
        ran += 1;
    }
    assert_eq!(ran, 7);
}

/// A body at rest on which nothing else acts: a torque about e3 turns it by torque t^2/(2 I3),
/// and one that begins later by as much less, though at the start it is 0.
#[test]
fn a_body_at_rest_has_a_response() {
    let body = gyroscope();
    let i3 = body.moments().i3();
    let start = tilted(&body, [0.0; 3]);
    let scene = Scene::new(body);
    let mut errors = Errors::of("the angle from rest");
    for from in [0.0, 6.0] {
        let push = Torque::on_body("push", move |t, _, _: &State| {
            BodyVector::new(0.0, 0.0, if t < from { 0.0 } else { 1e-9 })
        })
        .smooth()
        .with_break_points(&[from])
        .expect("rising");
        let called = scene.neglected_effects(&start, 10.0, 1e-3).expect("posed");
        let called = called.candidate(&push, f64::INFINITY).expect("weighed");
        let time: f64 = 10.0 - from;
        let angle = 0.5e-9 * time * time / i3;
        errors.add(called.rows()[0].predicted, angle, angle);
        assert!(called.rows()[0].linear && !called.rows()[0].called_for);
    }
    assert_largest!(errors, 2, @"2.10e-15");
}

/// In or out by the tolerance, in the order in which they are given.
#[test]
fn the_tolerance_decides() {
    let body = odd();
    let start = tilted(&body, [0.5, 0.2, 2.0]);
    let scene = Scene::new(body);
    let loss = InternalDissipation::new(1e-5).expect("a coefficient");
    let push = Torque::on_space("push", |_, _, _| SpaceVector::new(1e-8, 0.0, 0.0)).smooth();
    let table = |tolerance: f64| {
        let called = scene.neglected_effects(&start, 10.0, tolerance)?;
        let called = called.candidate(&loss, loss.number(&body, &start))?;
        Ok::<_, rotation_dynamics::Error>(called.candidate(&push, 1e-8)?.rows().to_vec())
    };
    let inside = |tolerance: f64| {
        let rows = table(tolerance).expect("weighed");
        assert_eq!([rows[0].name, rows[1].name], ["internal dissipation", "push"]);
        [rows[0].called_for, rows[1].called_for]
    };
    let [loss_error, push_error] = {
        let rows = table(1e-3).expect("weighed");
        [rows[0].predicted, rows[1].predicted]
    };
    assert!(loss_error > 10.0 * push_error && push_error > 0.0);
    assert_eq!(inside(3.0 * loss_error), [false, false]);
    // Within the margin of a factor 2.
    assert_eq!(inside(1.5 * loss_error), [true, false]);
    assert_eq!(inside(0.5 * push_error), [true, true]);
    // Nothing happens in no time, and backwards it is a motion like any other.
    let still = scene.neglected_effects(&start, 0.0, 1e-9).expect("posed");
    let still = still.candidate(&push, 1e-8).expect("weighed");
    assert_eq!(still.rows()[0].predicted, 0.0);
    let back = scene.neglected_effects(&start, -10.0, 1e-3).expect("posed");
    let back = back.candidate(&push, 1e-8).expect("weighed");
    assert!(back.rows()[0].predicted > 0.1 * push_error);
    for tolerance in [0.0, -1.0, f64::NAN, 4.0] {
        assert!(scene.neglected_effects(&start, 1.0, tolerance).is_err());
    }
    assert!(scene.neglected_effects(&start, f64::NAN, 1e-3).is_err());
    let called = scene.neglected_effects(&start, 1.0, 1e-3).expect("posed");
    assert!(called.candidate(&push, f64::NAN).is_err());
}

/// A push that begins late, weighed from a late start: from 0 it is another.
#[test]
fn a_start_at_another_time_and_limits() {
    let body = RigidBody::new(PrincipalMoments::new(1.0, 1.3, 1.7).expect("a body"));
    let start = tilted(&body, [0.3, 0.2, 1.0]);
    let scene = Scene::new(body);
    let push = |from: f64| {
        Torque::on_space("push", move |t, _: &RigidBody, _: &State| {
            let on = t >= from;
            SpaceVector::new(0.0, if on { 1e-5 * sin(t - from) } else { 0.0 }, 0.0)
        })
        .with_break_points(&[from])
        .expect("a time")
    };
    let weighed = |t_start: f64, t_end: f64, from: f64, limits: Limits| {
        let limits = Limits { t_start, ..limits };
        (scene.neglected_effects_with(&start, t_end, 1e-3, &limits))
            .and_then(|called| called.candidate(&push(from), 0.0))
            .map(|called| called.rows()[0])
    };
    let limits = Limits::default();
    let whole = weighed(0.0, 10.0, 4.0, limits).expect("weighed").predicted;
    let later = weighed(5.0, 15.0, 9.0, limits).expect("weighed").predicted;
    assert!((later / whole - 1.0).abs() < 1e-9, "{later:e} {whole:e}");
    let plain = (scene.neglected_effects(&start, 10.0, 1e-3))
        .and_then(|called| called.candidate(&push(4.0), 0.0))
        .expect("weighed");
    assert_eq!(plain.rows()[0].predicted, whole);
    // The damaged twin starts at 0.
    let twin = weighed(0.0, 15.0, 9.0, limits).expect("weighed").predicted;
    assert!((twin / whole - 1.0).abs() > 1e-3, "{twin:e}");
    // And back in time.
    assert!(weighed(15.0, 5.0, 9.0, limits).expect("weighed").predicted > 0.0);
    let told = |limits: Limits| {
        let refused = weighed(0.0, 10.0, 4.0, limits);
        refused.expect_err("refused").to_string()
    };
    let cancel = std::sync::atomic::AtomicBool::new(true);
    let mut ran = 0;
    for (limits, text) in [
        (Limits { budget: 500, ..limits }, "more than the 500 torques that are allowed"),
        (Limits { cancel: Some(&cancel), ..limits }, "cancelled, after 0 torques"),
        (Limits { break_points: &[11.0], ..limits }, "t = 11 is outside the run"),
    ] {
        let error = told(limits);
        assert!(error.contains(text), "{error}");
        ran += 1;
    }
    assert_eq!(ran, 3);
    // A longest step costs more, and says the same.
    let short = Limits { longest_step: 0.05, ..limits };
    let short = weighed(0.0, 10.0, 4.0, short).expect("weighed");
    assert!(short.work.steps >= 200 && (short.predicted / whole - 1.0).abs() < 1e-5);
}
