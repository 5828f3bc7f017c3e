//! What the five measures see.

use rotation_dynamics::accuracy::{Errors, Measure};
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::body::{Kinematics, RigidBody, State};
use rotation_dynamics::effects::{Effect, GravityAtLever};
use rotation_dynamics::exact::free_body::FreeBody;
use rotation_dynamics::exact::heavy_top::{HeavyTop, ReducedTop, Start};
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::math::EPS;
use rotation_dynamics::scene::Scene;
use support::{Errors as Judge, assert_error, assert_largest};

type Gravity = ((), GravityAtLever);

fn tumbling() -> (Scene<()>, State) {
    let body = RigidBody::new(PrincipalMoments::new(1.0, 2.0, 2.5).unwrap());
    let tilted = Attitude::from_euler(EulerAngles { phi: 0.3, theta: 0.7, zeta: -0.4 });
    let state = body.state(tilted.unwrap(), BodyVector::new(0.8, 0.4, 0.3375));
    (Scene::new(body), state.unwrap())
}

fn notes_top() -> (Scene<Gravity>, HeavyTop) {
    let body = RigidBody::new(PrincipalMoments::symmetric(1.0, 2.0).unwrap());
    let scene = Scene::new(body).with(GravityAtLever::new(0.2, 1.0).unwrap());
    let top = ReducedTop::new(2.0, 1.2, 0.2).unwrap();
    let motion = HeavyTop::from_energy(top, 0.55, Start::ThetaMin, 0.0, 0.0).unwrap();
    (scene, motion)
}

fn at<E: Effect>(scene: &Scene<E>, now: Kinematics) -> State {
    let state = scene.body().state(now.attitude, now.angular_velocity);
    state.unwrap()
}

/// A known change of the state is seen as what it is, in its own measure and in the
/// others that it touches.
#[test]
fn a_known_difference_is_seen() {
    let (scene, state) = tumbling();
    let none = Errors::between(&scene, &state, &state);
    assert!(Measure::ALL.iter().all(|m| none.get(*m) == 0.0));

    // Turned in space about L: attitude, and nothing else, since L stays.
    let l = state.angular_momentum;
    let turn = |angle: f64| Attitude::from_rotation_vector(l * (angle / l.norm())).unwrap();
    let mut others = Judge::in_units_of(EPS, "rates and energy");
    let mut angles = Judge::in_units_of(EPS, "angle turned");
    for angle in [1e-12, 1e-6, 0.5] {
        let reached = State { attitude: turn(angle) * state.attitude, ..state };
        let errors = Errors::between(&scene, &reached, &state);
        angles.push_at(errors.attitude - angle, angle);
        others.push_at(errors.rates, angle);
        others.push_at(errors.energy, angle);
        assert_eq!(errors.momentum, 0.0);
    }
    assert_largest!(angles, 3, @"2");
    assert_largest!(others, 6, @"0.523");
    // Faster by one part in a thousand: rates and L by that, the energy by twice that.
    let faster = State { angular_momentum: l * 1.001, ..state };
    let errors = Errors::between(&scene, &faster, &state);
    assert_eq!(errors.attitude, 0.0);
    assert_error!(errors.rates - 1e-3, 1.4e-16);
    assert_error!(errors.momentum - 1e-3, 7.3e-17);
    assert_error!(errors.energy - 2.001e-3, 3.8e-16);
    // Energy is the largest error of an invariant here.
    assert_eq!(errors.invariants, errors.energy);
}

/// A heavy top keeps L_Z and not L_X: only the first is an error of an invariant.
#[test]
fn invariants_are_those_of_the_scene() {
    let (scene, motion) = notes_top();
    let state = at(&scene, motion.kinematics(0.0));
    let pushed = |by: SpaceVector| State { angular_momentum: state.angular_momentum + by, ..state };
    let length = state.angular_momentum.norm();
    // A push across the axis in the vertical plane's normal: no L_Z, no L_z.
    let axis = state.attitude.axis();
    let across = SpaceVector::new(0.0, 0.0, 1.0).cross(&axis);
    let across = across * (1e-6 / across.norm());
    let errors = Errors::between(&scene, &pushed(across), &state);
    assert_error!(errors.momentum - 1e-6 / length, 0.0);
    assert_eq!(errors.invariants, errors.energy);
    let up = Errors::between(&scene, &pushed(SpaceVector::new(0.0, 0.0, 1e-6)), &state);
    assert!(up.invariants >= 1e-6 / length * (1.0 - 1e-9), "{up:?}");
    // The damaged twin: a scene without gravity would call the push across an error
    // of an invariant.
    let free = Scene::new(*scene.body());
    let wrong = Errors::between(&free, &pushed(across), &state);
    assert!(wrong.invariants > 1e3 * errors.invariants, "{wrong:?}");
}

/// The measures see nothing but round-off between two exact states of one motion: the
/// closed form's, and the same turned about by one composition.
#[test]
fn what_is_seen_of_round_off() {
    let (scene, motion) = notes_top();
    let (free, start) = tumbling();
    let rates = free.body().angular_velocity(&start);
    let body = FreeBody::new(free.body().moments(), start.attitude, rates).unwrap();
    let mut worst = Errors::between(&free, &start, &start);
    let mut cases = 0;
    for k in 0..200 {
        let t = 0.37 * f64::from(k);
        let exact = at(&scene, motion.kinematics(t));
        let angles = exact.attitude.euler_angles();
        let again = State::new(Attitude::from_euler(angles).unwrap(), motion.angular_momentum(t));
        worst = worst.or_worse(&Errors::between(&scene, &again.unwrap(), &exact));
        // L is constant: the closed form's own momentum against that of the start.
        let exact = at(&free, body.kinematics(t));
        let again = State { angular_momentum: start.angular_momentum, ..exact };
        worst = worst.or_worse(&Errors::between(&free, &again, &exact));
        cases += 2;
    }
    assert_eq!(cases, 400);
    assert_error!(worst.attitude, 4.07 eps);
    assert_error!(worst.rates, 12.17 eps);
    assert_error!(worst.momentum, 10.06 eps);
    assert_error!(worst.energy, 17.67 eps);
    // The damaged twin: a momentum that is off in its 14th digit is seen.
    let off = State { angular_momentum: start.angular_momentum * (1.0 + 1e-14), ..start };
    assert!(Errors::between(&free, &off, &start).momentum > 80.0 * EPS);
}

/// A body at rest for an instant has finite errors where torques set a scale, and a
/// body at rest without torque has none or infinitely many times its own rate.
#[test]
fn at_rest() {
    let (scene, _) = notes_top();
    let tilted = EulerAngles { phi: 0.0, theta: 1.0, zeta: 0.0 };
    let rest = State::new(Attitude::from_euler(tilted).unwrap(), SpaceVector::zero()).unwrap();
    let moving = State { angular_momentum: SpaceVector::new(1e-6, 0.0, 0.0), ..rest };
    let errors = Errors::between(&scene, &moving, &rest);
    assert!(errors.is_finite() && errors.rates > 1e-7, "{errors:?}");
    let free = Scene::new(*scene.body());
    assert_eq!(Errors::between(&free, &rest, &rest).rates, 0.0);
    assert_eq!(Errors::between(&free, &moving, &rest).rates, f64::INFINITY);
}
