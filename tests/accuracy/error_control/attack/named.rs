//! The inputs by which `solve` was broken once, one by one.

use super::truth;
use rotation_dynamics::accuracy::Limits;
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::{Conserved, Effect, Feature, GravityAtLever, Properties, Torque};
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::math::{exp, log};
use rotation_dynamics::scene::Scene;
use rotation_dynamics::{Error, Result};

fn turned(phi: f64, theta: f64, zeta: f64) -> Attitude {
    Attitude::from_euler(EulerAngles { phi, theta, zeta }).expect("angles")
}

/// A motion that doubles do not determine is refused, or what is granted of it is right;
/// where its beginning is asked for, that is granted.
#[test]
fn on_a_separatrix_nothing_is_promised() {
    let free = |moments: [f64; 3], attitude: Attitude, rates: [f64; 3]| {
        let [a, b, c] = moments;
        let body = RigidBody::new(PrincipalMoments::new(a, b, c).expect("a body"));
        let start = body.state(attitude, BodyVector::from_array(rates)).expect("a state");
        (body, start)
    };
    let tilted = turned(0.3, 0.8, 0.2);
    let mut refused = 0;
    for (moments, attitude, rates, t_end) in [
        ([1.0, 2.0, 2.5], turned(1.0, 0.5, 2.0), [0.0, 1.0, 0.0], 100.0),
        ([1.0, 2.0, 2.5], tilted, [5e-15, 1.0, 0.0], 100.0),
        ([1.0, 1.5, 2.0], tilted, [0.0, 1.0, 0.0], 200.0),
    ] {
        let (body, start) = free(moments, attitude, rates);
        let scene = Scene::new(body);
        let exact = truth::attitude(&body, 0.0, &start, t_end);
        for tolerance in [1e-1, 3e-3, 4e-5, 1e-10] {
            for stepped in [false, true] {
                let solved = if stepped {
                    scene.solve_by_stepping(&start, t_end, tolerance)
                } else {
                    scene.solve(&start, t_end, tolerance)
                };
                match solved {
                    Err(Error::NotDelivered { best: attainable, condition: Some(_), .. }) => {
                        assert!(attainable > tolerance);
                        refused += 1;
                    }
                    Ok(solved) => {
                        let error = exact.angle_to(&solved.state.attitude);
                        assert!(error <= tolerance, "{rates:?} {tolerance:e}: {error:e}");
                    }
                    other => panic!("{moments:?} {rates:?} {tolerance:e}: {other:?}"),
                }
            }
        }
        let early = scene.solve(&start, 10.0, 1e-9).expect("not yet");
        let exact = truth::attitude(&body, 0.0, &start, 10.0);
        assert!(exact.angle_to(&early.state.attitude) <= 1e-9);
    }
    // The others are granted: one flip is over, and the next far away.
    assert_eq!(refused, 16);
    // A top that swings up to the vertical, where it would stay.
    let gravity = GravityAtLever::new(1.0, 1.0).expect("gravity");
    let body = RigidBody::new(PrincipalMoments::symmetric(1.0, 0.5).expect("a body"));
    let rate = 2.0 * rotation_dynamics::math::sin(1.25);
    let (s, c) = rotation_dynamics::math::sincos(1.0);
    let rates = BodyVector::new(rate * c, -rate * s, 0.0);
    let start = body.state(turned(0.3, 2.5, 1.0), rates).expect("a state");
    let scene = Scene::new(body).with(gravity);
    for tolerance in [1e-1, 1e-3, 1e-6] {
        let solved = scene.solve(&start, 80.0, tolerance);
        assert!(
            matches!(solved, Err(Error::NotDelivered { condition: Some(_), .. })),
            "{tolerance:e}: {solved:?}"
        );
    }
}

fn tumbling() -> (RigidBody, State) {
    let body = RigidBody::new(PrincipalMoments::new(1.0, 1.5, 0.8).expect("a body"));
    let start = body.state(Attitude::IDENTITY, BodyVector::new(0.03, 0.01, 0.2)).expect("a state");
    (body, start)
}

/// Pulses of a fiftieth of a second in a minute: named by their jumps or their width they
/// are met; unnamed, the one that lasts longer than a 4096th of the span is seen.
#[test]
fn narrow_pulses_are_seen() -> Result<()> {
    let (body, start) = tumbling();
    let push = |t: f64| {
        if (30.0..30.02).contains(&t) { 50.0 } else { 0.0 }
    };
    let pulse = move |t: f64, _: &RigidBody, _: &State| SpaceVector::new(push(t), 0.0, 0.0);
    let named = Torque::on_space("pulse", pulse).smooth().with_break_points(&[30.0, 30.02])?;
    let solved = Scene::new(body).with(named).solve(&start, 60.0, 1e-9)?;
    // Piece by piece: free, pushed, free.
    let free = Scene::new(body);
    let steady =
        Torque::on_space("steady", |_, _: &RigidBody, _: &State| SpaceVector::new(50.0, 0.0, 0.0))
            .smooth();
    let pushed = Scene::new(body).with(steady);
    let before = free.solve(&start, 30.0, 1e-12)?.state;
    let after = pushed.solve(&before, 30.02 - 30.0, 1e-12)?.state;
    let end = free.solve(&after, 60.0 - 30.02, 1e-11)?.state;
    let error = end.attitude.angle_to(&solved.state.attitude);
    assert!(error <= 1e-9, "{error:e}");
    // In the damaged twin the pulse is a break point late.
    let late = Torque::on_space("late", pulse).smooth().with_break_points(&[30.01, 30.02])?;
    let refused = Scene::new(body).with(late).solve(&start, 60.0, 1e-9);
    assert!(matches!(refused, Err(Error::Contradiction { .. })), "{refused:?}");
    // Without a name it is seen all the same.
    let unnamed = Torque::on_space("unnamed", pulse);
    match Scene::new(body).with(unnamed).solve(&start, 60.0, 1e-6) {
        Ok(solved) => assert!(end.attitude.angle_to(&solved.state.attitude) <= 1e-6),
        Err(error) => {
            assert!(matches!(error, Error::NotDelivered { condition: None, .. }), "{error}")
        }
    }
    // A smooth one, its width named.
    let bump = move |t: f64, _: &RigidBody, _: &State| {
        let x = (t - 30.0) / 0.01;
        SpaceVector::new(50.0 * exp(-x * x), 0.0, 0.0)
    };
    let smooth = Torque::on_space("bump", bump)
        .smooth()
        .with_narrowest(Feature { time: 0.01, angle: f64::INFINITY })?;
    let scene = Scene::new(body).with(smooth);
    let [loose, tight] = [1e-6, 1e-11].map(|tolerance| scene.solve(&start, 60.0, tolerance));
    let apart = loose?.state.attitude.angle_to(&tight?.state.attitude);
    assert!(apart <= 1e-6, "{apart:e}");
    Ok(())
}

/// An effect that sees only the axis and gives no form on lanes: its torque is used.
#[test]
fn no_torque_is_forgotten() -> Result<()> {
    #[derive(Clone, Copy)]
    struct Plain(GravityAtLever);
    impl Effect for Plain {
        const PROPERTIES: Properties = GravityAtLever::PROPERTIES;
        fn name(&self) -> &'static str {
            "plain"
        }
        fn torque(&self, t: f64, body: &RigidBody, state: &State) -> SpaceVector {
            self.0.torque(t, body, state)
        }
        fn potential_energy(&self, t: f64, body: &RigidBody, state: &State) -> f64 {
            self.0.potential_energy(t, body, state)
        }
    }
    let gravity = GravityAtLever::new(1.0, 0.4)?;
    let body = RigidBody::new(PrincipalMoments::new(1.0, 1.5, 0.8)?);
    let start = body.state(turned(0.1, 0.8, 0.2), BodyVector::new(0.3, 0.1, 2.0))?;
    let plain = Scene::new(body).with(Plain(gravity)).solve(&start, 20.0, 1e-9)?;
    let own = Scene::new(body).with(gravity).solve(&start, 20.0, 1e-11)?;
    let apart = plain.state.attitude.angle_to(&own.state.attitude);
    assert!(apart <= 1e-9, "{apart:e}");
    Ok(())
}

/// L grows 300 times: true of its smoothness, and answered all the same.
#[test]
fn the_truth_costs_no_answer() -> Result<()> {
    let rate = log(300.0) / 10.0;
    let body = RigidBody::new(PrincipalMoments::new(1.0, 1.3, 1.7)?);
    let start = body.state(Attitude::IDENTITY, BodyVector::new(0.3, 0.2, 1.0))?;
    let driven = Torque::on_space("drive", move |_, _: &RigidBody, state: &State| {
        state.angular_momentum * rate
    });
    let inner = rotation_dynamics::math::expm1(rate * 10.0) / rate;
    let free = Scene::new(body).solve(&start, inner, 1e-9)?.state;
    let mut answered = 0;
    for tolerance in [1e-6, 1e-8] {
        let plain = Scene::new(body).with(driven.clone()).solve(&start, 10.0, tolerance)?;
        let smooth = Scene::new(body).with(driven.clone().smooth());
        let smooth = smooth.solve(&start, 10.0, tolerance)?;
        for solved in [plain, smooth] {
            let error = free.attitude.angle_to(&solved.state.attitude);
            assert!(error <= tolerance, "{error:e}, {solved:?}");
            answered += 1;
        }
    }
    assert_eq!(answered, 4);
    Ok(())
}

/// What would never end is refused when its budget is used up, with the real reason.
#[test]
fn no_run_without_end() -> Result<()> {
    let body = RigidBody::new(PrincipalMoments::new(1.0, 1.3, 1.7)?);
    let start = body.state(Attitude::IDENTITY, BodyVector::new(0.3, 0.1, 0.5))?;
    let limits = Limits { budget: 1_000_000, ..Limits::default() };
    let friction = Torque::on_space("dry friction", |_, _: &RigidBody, state: &State| {
        let l = state.angular_momentum;
        l * (-0.1 / l.norm().max(1e-300))
    });
    let brake =
        Torque::on_space("brake", |_, _: &RigidBody, state: &State| state.angular_momentum * -1e7);
    let mut refused = 0;
    let mut over = |solved: Result<rotation_dynamics::accuracy::Solved>| match solved {
        Err(
            Error::LimitReached { what: "torques", limit: 1_000_000, .. }
            | Error::StepUnderflow { .. }
            | Error::Undeclared { limit: 1_000_000, .. }
            | Error::NotDelivered { condition: None, .. },
        ) => refused += 1,
        other => panic!("{other:?}"),
    };
    over(Scene::new(body).with(friction).solve_with(&start, 20.0, 1e-6, &limits));
    over(Scene::new(body).with(brake).solve_with(&start, 100.0, 1e-6, &limits));
    let gravity = GravityAtLever::new(1.0, 0.4)?;
    let heavy = Scene::new(body).with(gravity);
    over(heavy.solve_with(&start, 1e7, 1e-3, &limits));
    assert_eq!(refused, 3);
    // At rest, with a torque that has no scale of its own.
    let rest = body.state(Attitude::IDENTITY, BodyVector::zero())?;
    let later =
        Torque::on_space("later", |t, _: &RigidBody, _: &State| SpaceVector::new(0.0, 0.0, t));
    // L = t^2/2 about e3: an angle of t^3/6 over I3.
    let solved = Scene::new(body).with(later.smooth()).solve(&rest, 2.0, 1e-8)?;
    let angle = 8.0 / 6.0 / 1.7;
    let exact = Attitude::about_body_axis(BodyVector::new(0.0, 0.0, 1.0), angle)?;
    let error = exact.angle_to(&solved.state.attitude);
    assert!(error <= 1e-8, "{error:e}");
    Ok(())
}

/// A scale that is no scale, and a claim that is none, are named.
#[test]
fn contradictions_are_named() -> Result<()> {
    struct Scaled(f64);
    impl Effect for Scaled {
        const PROPERTIES: Properties = Properties::ANYTHING;
        fn name(&self) -> &'static str {
            "scaled"
        }
        fn torque(&self, _: f64, _: &RigidBody, _: &State) -> SpaceVector {
            SpaceVector::new(0.1, 0.0, 0.0)
        }
        fn torque_scale(&self, _t: f64, _: &RigidBody, _: &State) -> f64 {
            self.0
        }
    }
    let (body, start) = tumbling();
    let message = |scale: f64| {
        let refused = Scene::new(body).with(Scaled(scale)).solve(&start, 1.0, 1e-6);
        refused.expect_err("no scale").to_string()
    };
    assert_eq!(message(f64::NAN), "torque_scale = NaN is not a finite number");
    assert_eq!(message(f64::INFINITY), "torque_scale = inf is not a finite number");
    assert_eq!(message(-1.0), "torque_scale = -1 is not allowed: it must not be negative");
    assert!(message(1e12).contains("\"scaled\" says that its torque comes within a millionth"));
    assert!(message(1e-12).contains("\"scaled\" says that its torque is not a thousand times"));

    /// A torque, and what is claimed of it by a number.
    struct Claimed<const CLAIM: usize>;
    impl<const CLAIM: usize> Effect for Claimed<CLAIM> {
        const PROPERTIES: Properties = {
            let mut properties = Properties::ANYTHING;
            match CLAIM {
                0 => properties.torque_free = true,
                1 => properties.axis_only = true,
                2 => properties.on_rates = false,
                3 => properties.on_time = false,
                4 => properties.smooth = true,
                5 => properties.conserved.energy = true,
                6 => properties.conserved.momentum = [true, false, false],
                7 => properties.conserved.momentum = [false, true, false],
                8 => properties.conserved.momentum = [false, false, true],
                9 => properties.conserved.axial_momentum = true,
                _ => properties.conserved = Conserved::NONE,
            }
            properties
        };
        fn name(&self) -> &'static str {
            "claimed"
        }
        fn torque(&self, t: f64, _: &RigidBody, state: &State) -> SpaceVector {
            let [x, y, z] = state.angular_momentum.to_array();
            let jump = if t > 0.4 { 0.1 } else { 0.0 };
            SpaceVector::new(-0.1 * x, -0.1 * y + jump, -0.1 * z)
        }
    }
    let mut named = 0;
    let mut claim = |solved: Result<rotation_dynamics::accuracy::Solved>, claim: &str| {
        let error = solved.expect_err(claim).to_string();
        assert!(error.contains(claim), "{error}");
        named += 1;
    };
    macro_rules! claims {
        ($($number:literal $text:literal),*) => {$(
            claim(Scene::new(body).with(Claimed::<$number>).solve(&start, 1.0, 1e-6), $text);
        )*};
    }
    claims!(
        0 "there is no torque", 1 "sees the body's axis only",
        2 "does not depend on how the body turns", 3 "does not depend on the time",
        4 "smooth", 5 "keeps the energy", 6 "no torque about X", 7 "no torque about Y",
        8 "no torque about Z", 9 "no torque about the body's axis"
    );
    assert_eq!(named, 10);
    // And without a claim it is solved.
    Scene::new(body).with(Claimed::<10>).solve(&start, 1.0, 1e-6)?;
    Ok(())
}
