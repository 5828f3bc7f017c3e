//! Every closed form is a motion: the same questions, the same answers by either door, and a
//! condition that holds next to a separatrix.

use core::f64::consts::PI;
use models::ladder::Ladder;
use models::plank::Plank;
use rotation_dynamics::Error;
use rotation_dynamics::accuracy::ExactMotion;
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::exact::free_body::FreeBody;
use rotation_dynamics::exact::heavy_top::{HeavyTop, ReducedTop, Start, SymmetricTop};
use rotation_dynamics::exact::pendulum::{Pendulum, Suspension};
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::math::{EPS, exp, log, sin};
use rotation_dynamics::motion::{Kept, Motion};
use support::{Errors, assert_largest};

fn free(moments: [f64; 3], omega: [f64; 3]) -> FreeBody {
    let [i1, i2, i3] = moments;
    let moments = PrincipalMoments::new(i1, i2, i3).expect("a body");
    FreeBody::new(moments, Attitude::IDENTITY, BodyVector::from_array(omega)).expect("a motion")
}

fn body() -> SymmetricTop {
    SymmetricTop::new(1.0, 0.4, 2.0, 1.0).expect("a top")
}

fn top() -> HeavyTop {
    let tilted = Attitude::from_rotation_vector(SpaceVector::new(0.3, -0.6, 0.2)).expect("finite");
    HeavyTop::new(body(), tilted, BodyVector::new(0.3, -0.2, 6.0)).expect("a motion")
}

fn reduced(energy: f64) -> HeavyTop {
    ReducedTop::new(2.0, 1.2, 0.2)
        .and_then(|top| HeavyTop::from_energy(top, energy, Start::ThetaMin, 0.3, -0.4))
        .expect("a motion")
}

fn pendulum(theta0: f64, omega0: f64) -> Pendulum {
    let suspension = Suspension { moment: 1.0, mass: 1.0, gravity: 1.0, lever: 1.0 };
    Pendulum::new(suspension, theta0, omega0).expect("a pendulum")
}

/// Motions of bodies are one list.
#[test]
fn many_states_are_single_states_and_the_first_bad_time_is_named() {
    let body = RigidBody::new(PrincipalMoments::new(1.0, 2.0, 2.5).expect("a body"));
    let own = free([1.0, 2.0, 2.5], [0.8, 0.4, 0.3]);
    let closure =
        ExactMotion::new("mine", move |t| body.state(own.attitude(t), BodyVector::zero()));
    let motions: [Box<dyn Motion<State = State>>; 5] = [
        Box::new(free([1.0, 2.0, 2.5], [0.8, 0.4, 0.3])),
        Box::new(free([1.0, 1.0, 1.5], [0.8, 0.4, 0.3])),
        Box::new(top()),
        Box::new(reduced(0.55)),
        Box::new(closure),
    ];
    let times = [3.0, 0.0, -1e4, 0.25];
    let mut compared = 0;
    for motion in &motions {
        let many = motion.try_states(&times).expect("finite times");
        for (t, state) in times.into_iter().zip(many) {
            assert_eq!(Ok(state), motion.try_state(t), "{} at {t}", motion.name());
            compared += 1;
        }
        let error = motion.try_states(&[0.0, 1.0, f64::NAN, f64::INFINITY]);
        let message = error.expect_err("NaN").to_string();
        assert_eq!(message, "times[2]: t = NaN is not a finite number");
    }
    assert_eq!(compared, 20);
    let unknown = motions[4].condition(1.0).expect_err("a closure");
    assert!(matches!(unknown, Error::ConditionUnknown { name: "mine" }));
    let ladder = Ladder::new(3.0, 9.8, 0.25).expect("a ladder");
    let late = ladder.try_states(&[0.5, 9.0]).expect_err("landed");
    assert!(late.to_string().starts_with("times[1]: t = 9 is outside"), "{late}");
}

/// What is said to be kept, from states along the way.
#[test]
fn what_is_kept_stays() {
    let mut errors = Errors::in_units_of(EPS, "what is kept");
    let mut damaged = Errors::in_units_of(EPS, "what is kept, off by 1e-12");
    let mut compare = |kept: Vec<Kept>, now: &[f64]| {
        assert_eq!(kept.len(), now.len());
        for (kept, now) in kept.iter().zip(now) {
            errors.push_at((kept.value - now) / (1.0 + kept.value.abs()), kept.name);
            damaged.push(kept.value * (1.0 + 1e-12) - now);
        }
    };
    for t in [0.0, 0.37, 55.5] {
        let motion = free([1.0, 2.0, 2.5], [0.8, 0.4, 0.3]);
        let now = motion.kinematics(t);
        let own = motion.body_momentum(now.angular_velocity);
        let [x, y, z] = now.attitude.to_space(own).to_array();
        compare(motion.kept(), &[x, y, z, 0.5 * own.dot(&now.angular_velocity)]);
        let motion = top();
        let (state, rates) = (motion.state(t), motion.angular_velocity(t));
        let own = state.attitude.to_body(state.angular_momentum);
        let energy = 0.5 * own.dot(&rates) + 2.0 * motion.cos_theta(t);
        compare(motion.kept(), &[state.angular_momentum.z(), own.z(), energy]);
        let motion = pendulum(1.0, 0.3);
        let state = motion.try_state(t).expect("a time");
        let rise = 2.0 * sin(0.5 * state.theta) * sin(0.5 * state.theta);
        compare(motion.kept(), &[0.5 * state.omega * state.omega + rise]);
    }
    assert_largest!(errors, 24, @"2.29");
    damaged.exceed(1e2, 24);
}

/// A sphere turns steadily, and every part of its condition is known.
#[test]
fn the_condition_of_a_sphere() {
    let motion = free([2.0; 3], [0.0, 0.0, 0.7]);
    for (t, error) in [(3.0, 0.0), (40.0, 0.0), (-1e3, 0.0)] {
        // Three turns, the time, a push along the axis, two across it.
        let turned = 0.7 * t;
        let across = 2.0 * sin(0.5 * turned);
        let want = (3.0 + 2.0 * turned * turned + 2.0 * across * across).sqrt();
        let got = motion.condition(t).expect("known");
        assert!((got / want - 1.0).abs() < 1e-6 + error, "{got} {want}");
    }
}

/// On the middle axis itself a push grows as exp(t/sqrt(5)): at any time, however late.
#[test]
fn the_condition_on_a_separatrix_is_that_of_its_growth() {
    let mut errors = Errors::of("growth of the condition over ten seconds");
    let rate = 0.2_f64.sqrt();
    for (distance, times) in
        [(0.0, [60.0, 100.0, 200.0, 400.0]), (1e-180, [60.0, 100.0, 200.0, 400.0])]
    {
        let motion = free([1.0, 2.0, 2.5], [distance, 1.0, 0.0]);
        for t in times {
            let [now, later] = [t, t + 10.0].map(|t| motion.condition(t).expect("known"));
            errors.push_at(log(later / now) / (10.0 * rate) - 1.0, t);
            assert!(now > 0.1 * exp(rate * t), "{now:e} at {t}");
        }
    }
    assert_largest!(errors, 8, @"1.17e-8");
    // A steady rotation about the largest moment is tame.
    let tame = free([1.0, 2.0, 2.5], [0.0, 0.0, 1.0]).condition(400.0).expect("known");
    assert!(tame < 3e3, "{tame}");
}

/// A condition is what a change of the inputs does: of each, in turn, by another size.
#[test]
fn conditions_are_felt_changes() {
    let mut shares = Errors::of("the largest change over the condition");
    let mut push = |changes: &[f64], condition: f64| {
        let most = changes.iter().fold(0.0_f64, |most, c| most.max(c.abs()));
        shares.push(most / condition);
        assert!(most <= condition && condition <= 4.0 * most, "{changes:?} {condition}");
    };
    let by = 3e-8;
    for (theta0, omega0, t) in [(1.0, 0.3, 20.0), (0.0, 2.0 * (1.0 - 1e-9), 30.0), (3.0, 1.0, 20.0)]
    {
        let motion = pendulum(theta0, omega0);
        let here = motion.at(t).expect("a time");
        let changes = [
            (pendulum(theta0 * (1.0 + by), omega0).at(t).expect("a time").theta - here.theta) / by,
            (pendulum(theta0, omega0 * (1.0 + by * 1e-4)).at(t).expect("a time").theta
                - here.theta)
                / (by * 1e-4),
            here.omega * t,
        ];
        push(&changes, motion.condition(t).expect("known"));
    }
    for (length, theta0) in [(1.0, 0.01), (3.0, 0.7)] {
        let motion = Plank::new(length, 9.8, theta0, 0.0).expect("a plank");
        let t = 0.9 * motion.landing_time();
        let here = motion.at(t).expect("a time");
        let other = Plank::new(length, 9.8, theta0 * (1.0 + by), 0.0).expect("a plank");
        let change = (other.at(t).expect("a time").theta - here.theta) / by;
        push(&[change, here.omega * t], motion.condition(t).expect("known"));
        let motion = Ladder::new(length, 9.8, theta0).expect("a ladder");
        let t = 0.9 * motion.landing_time();
        let here = motion.at(t).expect("a time");
        let other = Ladder::new(length, 9.8, theta0 * (1.0 + by)).expect("a ladder");
        let change = (other.at(t).expect("a time").theta - here.theta) / by;
        push(&[change, here.omega * t], motion.condition(t).expect("known"));
    }
    let (motion, t) = (top(), 40.0);
    let other =
        HeavyTop::new(body(), motion.attitude(0.0), BodyVector::new(0.3, -0.2, 6.0 * (1.0 + by)));
    let spun = other.expect("a motion").attitude(t).angle_to(&motion.attitude(t)) / by;
    let turned = motion.angular_velocity(t).norm() * t;
    push(&[spun, turned], motion.condition(t).expect("known"));
    let motion = reduced(0.55);
    let moved = reduced(0.55 * (1.0 + by)).attitude(t).angle_to(&motion.attitude(t)) / by;
    let turned = motion.angular_velocity(t).norm() * t;
    push(&[moved, turned], motion.condition(t).expect("known"));
    assert_largest!(shares, 9, @"0.834");
}

/// An attitude keeps its distance from either pole, and exactly upright stays so.
#[test]
fn a_top_starts_at_an_attitude() {
    let hung = SymmetricTop::new(1.0, 0.4, 2.0, -1.0).expect("a top");
    let mut starts = Errors::in_units_of(EPS, "start");
    let mut periods = Errors::in_units_of(EPS, "growth of the period");
    for (top, axis) in [(body(), 0.0), (hung, 1.0)] {
        // About Y: exactly up, or exactly down.
        let start = Attitude::from_quaternion([1.0 - axis, 0.0, axis, 0.0]).expect("a rotation");
        let sleeping = HeavyTop::new(top, start, BodyVector::new(0.0, 0.0, 0.3)).expect("a motion");
        let theta = PI * axis;
        for t in [0.0, 1e3, 1e9] {
            assert_eq!(sleeping.angles(t).theta, theta);
        }
        // Pushed, it leaves the pole and starts as it was put.
        let rates = BodyVector::new(0.3, -0.4, 0.2);
        let pushed = HeavyTop::new(top, start, rates).expect("a motion");
        let now = pushed.kinematics(0.0);
        starts.push(now.attitude.angle_to(&start));
        starts.push((now.angular_velocity - rates).norm());
        // The nearer to upright, the later: by the logarithm.
        let fall = |tilt: f64| {
            let start = Attitude::from_quaternion([
                1.0 - axis + tilt * axis,
                0.0,
                axis + tilt * (1.0 - axis),
                0.0,
            ]);
            let start = start.expect("a rotation");
            HeavyTop::new(top, start, BodyVector::zero()).expect("a motion").nutation_period()
        };
        let grown = (fall(1e-60) - fall(1e-20)) / log(1e40);
        // Two passages, at the rate sqrt(m g l/I1).
        periods.push(grown * 2.0_f64.sqrt() / 2.0 - 1.0);
    }
    assert_largest!(starts, 4, @"2.10");
    assert_largest!(periods, 2, @"0");
}
