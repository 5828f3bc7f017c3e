//! Another start, many times, break points, a longest step, a budget, a way to cancel.

use core::sync::atomic::{AtomicU64, Ordering::Relaxed};
use rotation_dynamics::accuracy::Limits;
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::{GravityAtLever, Torque};
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::math::{cos, sin};
use rotation_dynamics::motion::Motion;
use rotation_dynamics::scene::Scene;
use rotation_dynamics::{Error, Result};
use std::sync::atomic::AtomicBool;
use support::{Errors, assert_largest};

fn heavy() -> Result<(Scene<((), GravityAtLever)>, State)> {
    let body = RigidBody::new(PrincipalMoments::new(1.0, 1.5, 0.8)?);
    let start = body.state(Attitude::IDENTITY, BodyVector::new(0.3, 0.1, 2.0))?;
    Ok((Scene::new(body).with(GravityAtLever::new(1.0, 0.4)?), start))
}

/// A torque that depends on the time, begun at 0 and begun anew at 3.
#[test]
fn a_start_at_another_time() -> Result<()> {
    let (heavy, start) = heavy()?;
    let swing = Torque::on_space("swing", |t, _: &RigidBody, _: &State| {
        SpaceVector::new(0.2 * sin(t), 0.1 * cos(3.0 * t), 0.0)
    })
    .smooth();
    let scene = Scene::new(*heavy.body()).with(swing);
    let whole = scene.solve(&start, 8.0, 1e-11)?.state;
    let first = scene.solve(&start, 3.0, 1e-12)?.state;
    let from = |t_start| Limits { t_start, ..Limits::default() };
    let second = scene.solve_with(&first, 8.0, 1e-11, &from(3.0))?.state;
    let apart = whole.attitude.angle_to(&second.attitude);
    assert!(apart <= 3e-11, "{apart:e}");
    // The damaged twin begins at 0 again.
    let wrong = scene.solve_with(&first, 5.0, 1e-11, &from(0.0))?.state;
    assert!(whole.attitude.angle_to(&wrong.attitude) > 0.01);
    // And back.
    let back = scene.solve_with(&second, 0.0, 1e-10, &from(8.0))?.state;
    let apart = back.attitude.angle_to(&start.attitude);
    assert!(apart <= 3e-10, "{apart:e}");
    Ok(())
}

/// At 101 times the attitude is within the tolerance, and momentum and rates within what
/// is said of them.
#[test]
fn all_along_the_way() -> Result<()> {
    let (scene, start) = heavy()?;
    let mut over = Errors::of("error over tolerance");
    let mut others = Errors::of("errors of momentum and rates over their estimates");
    for tolerance in [1e-4, 1e-8] {
        let motion = scene.solve_along(&start, 30.0, tolerance, &Limits::default())?;
        let solved = motion.solved();
        assert!(solved.estimate <= tolerance);
        for n in 0..=100 {
            let t = 0.3 * f64::from(n);
            let here = motion.try_state(t)?;
            let exact = scene.solve(&start, t, 1e-12)?.state;
            let errors = rotation_dynamics::accuracy::Errors::between(&scene, &here, &exact);
            over.push_at(errors.attitude / tolerance, t);
            others.push_at(errors.momentum / solved.momentum_estimate, t);
            others.push_at(errors.rates / solved.rates_estimate, t);
        }
    }
    assert_largest!(over, 202, @"1.55e-5");
    assert_largest!(others, 404, @"2.48e-4");
    // The same times as a list, forwards and backwards.
    let times: Vec<f64> = (1..=20).map(|n| 1.5 * f64::from(n)).collect();
    let states = scene.solve_at(&start, &times, 1e-8, &Limits::default())?;
    let motion = scene.solve_along(&start, 30.0, 1e-8, &Limits::default())?;
    for (t, state) in times.iter().zip(&states) {
        assert_eq!(motion.try_state(*t)?, *state);
    }
    let back: Vec<f64> = times.iter().map(|t| -t).collect();
    assert_eq!(scene.solve_at(&start, &back, 1e-8, &Limits::default())?.len(), 20);
    Ok(())
}

#[test]
fn bad_limits_are_named() -> Result<()> {
    let (scene, start) = heavy()?;
    let refused = |limits: &Limits| {
        let solved = scene.solve_with(&start, 5.0, 1e-6, limits);
        solved.expect_err("refused").to_string()
    };
    let limits = Limits::default();
    let mut ran = 0;
    let mut says = |limits: Limits, text: &str| {
        let error = refused(&limits);
        assert!(error.contains(text), "{error}");
        ran += 1;
    };
    says(Limits { t_start: f64::NAN, ..limits }, "start time = NaN is not a finite number");
    says(Limits { longest_step: 0.0, ..limits }, "longest step = 0 is not allowed");
    says(Limits { longest_step: f64::NAN, ..limits }, "longest step = NaN");
    says(Limits { budget: 0, ..limits }, "budget = 0 is not allowed");
    says(Limits { break_points: &[1.0, 6.0], ..limits }, "t = 6 is outside the run");
    says(
        Limits { break_points: &[2.0, 1.0], ..limits },
        "break point[1]: value = 1 is not allowed: the one before it is 2",
    );
    says(
        Limits { break_points: &[f64::NAN], ..limits },
        "break point[0]: value = NaN is not a finite number",
    );
    says(Limits { budget: 250, ..limits }, "more than the 250 torques that are allowed");
    let cancel = AtomicBool::new(true);
    says(Limits { cancel: Some(&cancel), ..limits }, "cancelled, after 0 torques");
    assert_eq!(ran, 9);
    let times = |times: &[f64]| scene.solve_at(&start, times, 1e-6, &Limits::default());
    assert!(matches!(times(&[]), Err(Error::Lengths { found: 0, .. })));
    let error = times(&[1.0, 3.0, 2.0, 4.0]).expect_err("out of order").to_string();
    assert_eq!(
        error,
        "times[2]: value = 2 is not allowed: the one before it is 3, and they must rise"
    );
    let motion = scene.solve_along(&start, 5.0, 1e-6, &Limits::default())?;
    assert!(matches!(motion.try_state(5.1), Err(Error::OutsideRun { .. })));
    assert!(matches!(motion.try_state(f64::NAN), Err(Error::NotFinite { .. })));
    Ok(())
}

/// A longest step is kept, and finer runs are finer.
#[test]
fn a_longest_step() -> Result<()> {
    let (scene, start) = heavy()?;
    let limits = Limits { longest_step: 0.01, ..Limits::default() };
    let solved = scene.solve_with(&start, 5.0, 1e-6, &limits)?;
    assert!(solved.longest_step <= 0.01 && solved.run.steps >= 500, "{solved:?}");
    let free = scene.solve(&start, 5.0, 1e-6)?;
    assert!(free.longest_step > 0.01 && free.run.steps < 500, "{free:?}");
    Ok(())
}

/// What no run could do within its limits is told before any run: steps so short that they take
/// more torques than are allowed, a span that no step can be a part of, an energy that no double
/// holds.
#[test]
fn what_cannot_be_stepped_is_told_before_a_run() -> Result<()> {
    let (scene, start) = heavy()?;
    let torques = AtomicU64::new(0);
    let counted = Scene::new(*scene.body()).with(
        Torque::on_space("counted", |_, _: &RigidBody, _: &State| {
            torques.fetch_add(1, Relaxed);
            SpaceVector::new(0.1, 0.0, 0.0)
        })
        .smooth(),
    );
    let of = |longest_step: f64, budget: u64| Limits { longest_step, budget, ..Limits::default() };
    // 12 torques a step: one more step than the budget has room for, and as many as it has.
    let mut taken = Vec::new();
    for steps in [1001.0, 1000.0] {
        torques.store(0, Relaxed);
        let refused = counted.solve_with(&start, 20.0, 1e-8, &of(20.0 / steps, 12_000));
        assert!(matches!(refused, Err(Error::LimitReached { what: "torques", .. })), "{refused:?}");
        taken.push(torques.load(Relaxed));
    }
    // What looks at the torque before any run took 5246, and the twin went on to runs: 17 262.
    assert!(taken[0] < 5250 && taken[1] > 17_000, "{taken:?}");
    let text = |solved: Result<rotation_dynamics::accuracy::Solved>| match solved {
        Ok(solved) => format!("{:e}", solved.estimate),
        Err(error) => error.to_string(),
    };
    let endless = text(scene.solve_with(&start, 5000.0, 1e-8, &of(1e-10, 50_000_000)));
    assert_eq!(
        endless,
        "from t = 0 to 5000 this takes more than the 50000000 torques that are allowed: allow more \
         of them, a larger error, longer steps or a shorter time; or name the times at which a torque \
         jumps or has a kink"
    );
    for span in [5e-324, -5e-324, 2e-308] {
        assert_eq!(
            text(scene.solve(&start, span, 1e-8)),
            format!(
                "end time - start time = {span:e} is not allowed: 0, or 2.3e-308 s at least, of \
                 which a step can be a part"
            )
        );
    }
    assert!(scene.solve(&start, 2.3e-308, 1e-8)?.estimate <= 1e-8);
    let body = *scene.body();
    for free in [true, false] {
        let fast = |rate: f64| {
            let start = body.state(Attitude::IDENTITY, BodyVector::new(0.1 * rate, 0.0, rate))?;
            match free {
                true => Scene::new(body).solve(&start, 1.0 / rate, 1e-8),
                false => scene.solve(&start, 1.0 / rate, 1e-8),
            }
        };
        assert_eq!(text(fast(1e159)), "kinetic energy of the start = inf is not a finite number");
        assert!(fast(1e150)?.estimate <= 1e-8);
    }
    Ok(())
}
