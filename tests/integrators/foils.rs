//! How the methods that everyone writes first fail, with numbers.

use crate::slope::fitted;
use rotation_dynamics::Error;
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::exact::free_body::FreeBody;
use rotation_dynamics::frame::BodyVector;
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::foils::{EulerOnAngles, SemiImplicitEuler};
use rotation_dynamics::integrators::gauss_legendre::FreeRotation;
use rotation_dynamics::integrators::{GaussLegendre, Integrator};
use rotation_dynamics::scene::Scene;
use support::{Errors, assert_error, assert_largest};

fn tumbling(theta: f64) -> (Scene<()>, State, FreeBody) {
    let moments = PrincipalMoments::new(1.0, 2.0, 8.0 / 3.0).expect("a body");
    let rates = BodyVector::new(0.8, 0.4, 0.3375);
    let attitude =
        Attitude::from_euler(EulerAngles { phi: 0.0, theta, zeta: 0.0 }).expect("angles");
    let scene = Scene::new(RigidBody::new(moments));
    let start = scene.body().state(attitude, rates).expect("finite");
    let exact = FreeBody::new(moments, attitude, rates).expect("a motion");
    (scene, start, exact)
}

fn semi_implicit(steps: u64) -> SemiImplicitEuler {
    SemiImplicitEuler::new(steps).expect("some steps")
}

fn on_angles(steps: u64) -> EulerOnAngles {
    EulerOnAngles::new(steps).expect("some steps")
}

/// Far from the pole, over a short time, both are what they claim: order 1.
#[test]
fn both_are_of_order_one() {
    let (scene, start, exact) = tumbling(1.5);
    let want = exact.attitude(1.0);
    let methods: [&dyn Fn(u64) -> State; 2] =
        [&|n| on_angles(n).advance(&scene, 0.0, &start, 1.0).expect("no pole").0, &|n| {
            semi_implicit(n).advance(&scene, 0.0, &start, 1.0).expect("finite").0
        }];
    let [mut orders, mut off] = ["order less 1", "distance from the line"].map(Errors::of);
    for advance in methods {
        let points: Vec<(f64, f64)> = [1000, 2000, 4000, 8000]
            .into_iter()
            .map(|n| (1.0 / n as f64, advance(n).attitude.angle_to(&want)))
            .collect();
        let (slope, scatter) = fitted(&points);
        orders.push(slope - 1.0);
        off.push(scatter);
    }
    assert_largest!(orders, 2, @"2.30e-5");
    assert_largest!(off, 2, @"6.23e-6");
}

/// A body that tumbles once in a few seconds, stepped sixty times a second.
#[test]
fn the_game_engine_gains_energy() {
    let (scene, start, exact) = tumbling(1.5);
    let gain = |end: &State| scene.energy(end) / scene.energy(&start) - 1.0;
    let mut ran = 0;
    // Measured: 11.2 % in a minute and 389 % in ten; the attitude is lost.
    for (seconds, steps, least, lost) in [(60.0, 3600, 0.112, 1.3), (600.0, 36_000, 3.88, 2.5)] {
        let (end, _) = semi_implicit(steps).advance(&scene, 0.0, &start, seconds).expect("finite");
        let off = end.attitude.angle_to(&exact.attitude(seconds));
        assert!(gain(&end) > least && off > lost, "{} {off}", gain(&end));
        ran += 1;
    }
    assert_eq!(ran, 2);
    // The angles do no better. Measured: 11.2 % in a minute.
    let (end, _) = on_angles(3600).advance(&scene, 0.0, &start, 60.0).expect("finite");
    assert!(gain(&end) > 0.112, "{}", gain(&end));
    // At ten turns a second, near the middle axis, it flies apart within the minute.
    let rates = BodyVector::new(0.5, 60.0, 0.5);
    let fast = scene.body().state(Attitude::IDENTITY, rates).expect("finite");
    let refused = semi_implicit(3600).advance(&scene, 0.0, &fast, 60.0);
    assert!(matches!(refused, Err(Error::NotFinite { .. })), "{refused:?}");
    // What a sound method does with a tenth of the steps.
    let (end, _) = GaussLegendre::new(3600)
        .and_then(|m| m.advance(&FreeRotation::new(&scene), 0.0, &start, 600.0))
        .expect("smooth");
    assert_error!(gain(&end), 0.0);
    assert_error!(end.attitude.angle_to(&exact.attitude(600.0)), 1.0e-13);
}

/// A body whose axis passes the vertical at a distance near the length of a step.
#[test]
fn the_angles_fail_at_the_pole() {
    let moments = PrincipalMoments::new(1.0, 2.0, 8.0 / 3.0).expect("a body");
    let scene = Scene::new(RigidBody::new(moments));
    let angles = EulerAngles { phi: 0.0, theta: 0.5, zeta: 0.0 };
    let attitude = Attitude::from_euler(angles).expect("angles");
    let [mut with_angles, mut with_quaternion] = ["angles", "quaternion"].map(Errors::of);
    for i in 0..200 {
        // Towards the vertical at 1 rad/s, and past it at about a quarter of this.
        let sideways = 1e-3 + 0.1 * f64::from(i) / 200.0;
        let rates = BodyVector::new(-1.0, 0.5 * sideways, 0.0);
        let start = scene.body().state(attitude, rates).expect("finite");
        let want = FreeBody::new(moments, attitude, rates).expect("a motion").attitude(1.0);
        let (a, _) = on_angles(1000).advance(&scene, 0.0, &start, 1.0).expect("finite");
        let (q, _) = semi_implicit(1000).advance(&scene, 0.0, &start, 1.0).expect("finite");
        with_angles.push(a.attitude.angle_to(&want));
        with_quaternion.push(q.attitude.angle_to(&want));
    }
    assert_largest!(with_angles, 200, @"6.11e-3");
    assert_largest!(with_quaternion, 200, @"9.54e-6");
    // Upright, the rates of the angles do not exist.
    let (scene, start, _) = tumbling(0.0);
    let refused = on_angles(10).advance(&scene, 0.0, &start, 1.0);
    assert!(matches!(refused, Err(Error::GimbalLock { angle: 0.0, .. })), "{refused:?}");
    assert!(semi_implicit(10).advance(&scene, 0.0, &start, 1.0).is_ok());
}

#[test]
fn no_steps_is_refused() {
    assert!(matches!(EulerOnAngles::new(0), Err(Error::OutOfRange { name: "steps", .. })));
    assert!(matches!(SemiImplicitEuler::new(0), Err(Error::OutOfRange { name: "steps", .. })));
}
