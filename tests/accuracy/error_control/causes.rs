//! Why `solve` was wrong where it was: each cause by itself, without `solve`, and what it
//! says now.

use super::attack::truth;
use rotation_dynamics::accuracy::{Limits, Problem};
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::{GravityAtLever, Torque};
use rotation_dynamics::exact::heavy_top::{HeavyTop, SymmetricTop};
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::gauss_legendre::FreeRotation;
use rotation_dynamics::integrators::{
    Dop853, GaussLegendre, Integrator, Method, Scheme, Splitting, Work,
};
use rotation_dynamics::math::{cos, exp, log, pow, sin};
use rotation_dynamics::motion::Motion;
use rotation_dynamics::scene::Scene;
use rotation_dynamics::{Error, Result};
use support::{Errors, assert_largest};

/// Two runs that cross a short pulse in one step each agree on it to every bit, and both are
/// wrong. `solve` refines every piece between two jumps.
#[test]
fn runs_that_take_the_same_step_say_nothing_of_it() -> Result<()> {
    let body = RigidBody::new(PrincipalMoments::new(0.5428, 0.4713, 0.3577)?);
    let start = body.state(Attitude::IDENTITY, BodyVector::new(-0.35, 0.33, -0.63))?;
    let (from, to, rate) = (0.58, 0.5801, -5900.0);
    let torque = move |t: f64, _: &RigidBody, state: &State| {
        state.angular_momentum * if (from..to).contains(&t) { rate } else { 0.0 }
    };
    let steady = Torque::on_space("steady", move |_, _: &RigidBody, state: &State| {
        state.angular_momentum * rate
    });
    let scene = Scene::new(body).with(steady.smooth());
    let grown = |state: &State| state.angular_momentum.norm() / start.angular_momentum.norm();
    let exact = exp(rate * (to - from));
    let in_steps = |steps: u64| -> Result<f64> {
        // So loose that the step is as long as it may be.
        let method = Dop853::new(0.1)?.with_longest_step((to - from) / steps as f64)?;
        let mut work = Work::default();
        let end = method.advance_counting(&scene, 0.0, &start, to - from, &mut work)?;
        Ok(grown(&end) / exact - 1.0)
    };
    let few = [in_steps(1)?, in_steps(1)?];
    assert!(few[0] == few[1] && few[0].abs() > 1e-12, "{few:?}");
    // Finer steps would have told.
    assert!(in_steps(4)?.abs() < 1e-3 * few[0].abs());
    let named = Torque::on_space("pulse", torque).smooth().with_break_points(&[from, to])?;
    let solved = Scene::new(body).with(named).solve(&start, 1.8, 1e-12)?;
    let error = (grown(&solved.state) / exact - 1.0).abs();
    assert!(error <= 1e-13, "{error:e}");
    Ok(())
}

/// Jumps that nothing names are found, each to the last bit, and steps end there: the answer
/// is that of the jumps with their names, for up to four and a half times the work. Two that are nearer to each other
/// than a 4096th of the span are not seen.
#[test]
fn jumps_without_a_name_are_found() -> Result<()> {
    let body = RigidBody::new(PrincipalMoments::new(1.0, 1.5, 0.8)?);
    let start = body.state(Attitude::IDENTITY, BodyVector::new(0.3, 0.1, 2.0))?;
    let push = |times: [f64; 3]| {
        Torque::on_space("push", move |t, _: &RigidBody, _: &State| {
            let passed = times.iter().filter(|jump| **jump <= t).count();
            SpaceVector::new(0.0, if passed % 2 == 0 { 0.0 } else { 0.3 }, 0.0)
        })
    };
    let mut over = Errors::of("distance from the answer with names over the tolerance");
    let mut price = Errors::of("work over that with names");
    for (t_start, t_end) in [(0.0, 20.0), (20.0, 0.0)] {
        let limits = Limits { t_start, ..Limits::default() };
        let solve = |times: [f64; 3], named: bool, tolerance| {
            if named {
                let push = push(times).smooth().with_break_points(&times)?;
                (Scene::new(body).with(push)).solve_with(&start, t_end, tolerance, &limits)
            } else {
                (Scene::new(body).with(push(times))).solve_with(&start, t_end, tolerance, &limits)
            }
        };
        let times = [3.3, 7.1, 15.9];
        for tolerance in [1e-4, 1e-8, 1e-11] {
            let [found, named] = [solve(times, false, tolerance)?, solve(times, true, tolerance)?];
            let best = solve(times, true, 1e-12)?.state.attitude;
            let apart = best.angle_to(&found.state.attitude);
            over.push_at(apart / tolerance, (t_end, tolerance));
            let torques = [found, named].map(|solved| solved.work.torques() as f64);
            price.push_at(torques[0] / torques[1], (t_end, tolerance));
        }
        // The damaged twin: gone again before the next look.
        let [unseen, named] =
            [false, true].map(|named| solve([3.3012, 3.301_202, 30.0], named, 1e-8));
        let apart = named?.state.attitude.angle_to(&unseen?.state.attitude);
        assert!(apart > 1e-7, "{apart:e}");
    }
    assert_largest!(over, 6, @"9.57e-4");
    assert_largest!(price, 6, @"3.30");
    Ok(())
}

/// A kink in time that nothing names is found, and steps end there. Over kinks, three runs whose
/// steps end elsewhere agree by chance, now and then: so it is where the torque on the body as it
/// starts has none.
#[test]
fn kinks_without_a_name_are_found() -> Result<()> {
    const SCENES: usize = 200;
    let body = RigidBody::new(PrincipalMoments::symmetric(1.0, 2.0)?);
    let t_end = 10.0;
    let part = |n: usize, irrational: f64| (0.5 + n as f64 * irrational).fract();
    // Delivered over requested, of torques amp |t - t1|^power about the axis of spin.
    let ratios = |powers: &[f64], hidden: bool| -> Result<(Vec<f64>, u64)> {
        let (mut ratios, mut torques) = (Vec::new(), 0);
        for n in 1..=SCENES {
            let power = powers[n % powers.len()];
            let t1 = 1.0 + 8.0 * part(n, 0.618_033_988_749_894_9);
            let amp = exp(log(10.0) * (-1.0 + 2.5 * part(n, 0.414_213_562_373_095_1)));
            let tolerance = exp(-log(10.0) * (3.0 + 5.0 * part(n, 0.732_050_807_568_877_2)));
            let spin = 2.0 * part(n, 0.236_067_977_499_789_7);
            let start = body.state(Attitude::IDENTITY, BodyVector::new(0.0, 0.0, spin))?;
            let faster = start.angular_momentum.z() + 1e-3;
            let kink = Torque::on_body("kink", move |t: f64, _: &RigidBody, state: &State| {
                let to_go = t1 - t;
                // Seen only on a body that has been pushed, and before its time the same.
                let unseen = hidden && state.angular_momentum.z() < faster;
                let size = if unseen { to_go } else { pow(to_go.abs(), power) };
                BodyVector::new(0.0, 0.0, amp * size)
            });
            let after = t_end - t1;
            let (one, two) = (power + 1.0, power + 2.0);
            let pushed =
                after * pow(t1, one) / one + pow(t1, two) / two + pow(after, two) / (one * two);
            let exact = Attitude::about_body_axis(
                BodyVector::new(0.0, 0.0, 1.0),
                spin * t_end + 0.5 * amp * pushed,
            )?;
            if let Ok(solved) = Scene::new(body).with(kink).solve(&start, t_end, tolerance) {
                ratios.push(exact.angle_to(&solved.state.attitude) / tolerance);
                torques += solved.work.torques();
            }
        }
        Ok((ratios, torques))
    };
    let most = |ratios: &[f64]| ratios.iter().copied().fold(0.0, f64::max);
    let (found, _) = ratios(&[0.5, 1.0, 1.5], false)?;
    assert_eq!(found.len(), SCENES);
    // Measured: 0.1131.
    assert!((0.113..=0.114).contains(&most(&found)), "{}", most(&found));
    // The damaged twin, not seen: one is refused, none is above its request, and all take twice the
    // work.
    let ((found, work), (unseen, more)) = (ratios(&[1.0], false)?, ratios(&[1.0], true)?);
    let above = |ratios: &[f64]| ratios.iter().filter(|ratio| **ratio > 1.0).count();
    let counts = [found.len(), above(&found), unseen.len(), above(&unseen)];
    assert_eq!(counts, [200, 0, 199, 0]);
    assert!((0.32..=0.33).contains(&most(&unseen)), "{}", most(&unseen));
    let times = more as f64 / work as f64;
    assert!((1.8..=1.9).contains(&times), "{times}");
    Ok(())
}

/// Tops thrown exactly onto the upright: the tenth of the digits that decides when they leave
/// it is not in the start. Runs of them agree by chance, 1.7 rad from the truth; `solve`
/// refuses, because it feels the condition on a motion that is near enough to be this one.
/// Thrown a hundredth short they are granted.
#[test]
fn runs_agree_by_chance_beside_the_upright() -> Result<()> {
    let gravity = GravityAtLever::new(1.0, 0.394_292_785_436_176_1)?;
    let body = RigidBody::new(PrincipalMoments::symmetric(1.0, 0.828_074_070_230_384_4)?);
    let angles = EulerAngles {
        phi: -0.787_838_259_203_413_2,
        theta: 1.479_849_285_157_081_7,
        zeta: -0.787_055_783_499_795_3,
    };
    let t_end = 65.153_073_205_715_15;
    let thrown = |short: f64| {
        let rate = 2.0 * gravity.moment().sqrt() * sin(0.5 * angles.theta) * (1.0 - short);
        let rates = BodyVector::new(rate * cos(angles.zeta), -rate * sin(angles.zeta), 0.0);
        body.state(Attitude::from_euler(angles)?, rates)
    };
    let scene = Scene::new(body).with(gravity);
    let start = thrown(0.0)?;
    let exact = truth::attitude(&body, gravity.moment(), &start, t_end);
    let run = |steps| {
        let method = Splitting::new(Scheme::SRKN14, steps)?;
        Ok::<_, Error>(method.advance(&scene, 0.0, &start, t_end)?.0.attitude)
    };
    let [coarse, fine] = [run(104)?, run(356)?];
    let (apart, off) = (coarse.angle_to(&fine), exact.angle_to(&fine));
    assert!(apart < 0.02 && off > 1.0, "{apart:e} {off:e}");
    let refused = scene.solve_by_stepping(&start, t_end, 1e-2);
    assert!(matches!(refused, Err(Error::NotDelivered { condition: Some(_), .. })), "{refused:?}");
    let start = thrown(1e-2)?;
    let exact = truth::attitude(&body, gravity.moment(), &start, t_end);
    let solved = scene.solve_by_stepping(&start, t_end, 1e-2)?;
    assert!(exact.angle_to(&solved.state.attitude) <= 1e-2);
    Ok(())
}

/// A root of the time is found like a kink, be it inside the span or at an end, and steps end there: so
/// 1e-11 is delivered for less work than where it is not seen to be one on the body as it starts.
#[test]
fn roots_of_the_time_are_found() -> Result<()> {
    let body = RigidBody::new(PrincipalMoments::symmetric(1.0, 2.0)?);
    let (t_end, spin, tolerance) = (10.0, 0.8, 1e-11);
    let start = body.state(Attitude::IDENTITY, BodyVector::new(0.0, 0.0, spin))?;
    let faster = start.angular_momentum.z() + 1e-3;
    let mut over = Errors::of("delivered over requested");
    let mut costlier = Errors::of("work where it is not seen over work where it is");
    for power in [0.5, 1.5] {
        for t1 in [0.0, 3.7, t_end] {
            let solve = |hidden: bool| {
                let root = Torque::on_body("root", move |t: f64, _: &RigidBody, state: &State| {
                    let unseen = hidden && state.angular_momentum.z() < faster;
                    let size = pow((t - t1).abs(), if unseen { 1.0 } else { power });
                    BodyVector::new(0.0, 0.0, 0.1 * size)
                });
                let scene = Scene::new(body).with(root);
                scene.solve(&start, t_end, tolerance)
            };
            let (one, two) = (power + 1.0, power + 2.0);
            let after = t_end - t1;
            let pushed =
                after * pow(t1, one) / one + pow(t1, two) / two + pow(after, two) / (one * two);
            let angle = spin * t_end + 0.05 * pushed;
            let exact = Attitude::about_body_axis(BodyVector::new(0.0, 0.0, 1.0), angle)?;
            let seen = solve(false)?;
            over.push_at(exact.angle_to(&seen.state.attitude) / tolerance, (power, t1));
            let unseen = solve(true)?;
            let torques = [unseen, seen].map(|solved| solved.work.torques() as f64);
            costlier.push_at(torques[0] / torques[1], (power, t1));
        }
    }
    assert_largest!(over, 6, @"0.0228");
    assert_largest!(costlier, 6, @"1.99");
    Ok(())
}

/// A state between two places is as good as they are also just before a root of the time.
#[test]
fn states_before_a_root_are_as_good_as_others() -> Result<()> {
    let body = RigidBody::new(PrincipalMoments::symmetric(1.0, 2.0)?);
    let (t_end, spin, t1, tolerance) = (10.0, 0.8, 3.7, 1e-11);
    let start = body.state(Attitude::IDENTITY, BodyVector::new(0.0, 0.0, spin))?;
    let root = Torque::on_body("root", move |t: f64, _: &RigidBody, _: &State| {
        BodyVector::new(0.0, 0.0, 0.1 * (t - t1).abs().sqrt())
    });
    let scene = Scene::new(body).with(root);
    let motion = scene.solve_along(&start, t_end, tolerance, &Limits::default())?;
    let mut over = Errors::of("delivered over requested");
    for n in 0..=500 {
        let t =
            if n < 250 { t1 - pow(10.0, 0.5 - 0.05 * f64::from(n)) } else { 0.02 * f64::from(n) };
        let (past, after) = (t1.min(t), (t - t1).max(0.0));
        let left = |to_go: f64| pow(to_go, 2.5) / 3.75;
        let pushed = pow(t1, 1.5) / 1.5 * t - left(t1) + left(t1 - past) + left(after);
        let angle = spin * t + 0.05 * pushed;
        let exact = Attitude::about_body_axis(BodyVector::new(0.0, 0.0, 1.0), angle)?;
        let state = motion.try_state(t)?;
        over.push_at(exact.angle_to(&state.attitude) / tolerance, t);
    }
    assert_largest!(over, 501, @"0.0198");
    Ok(())
}

/// What the sweeps leave of the steps is mostly on one side: with the condition it grows with their
/// number. A law of what is thrown at random, by which `solve` once went, is too small for long
/// runs.
#[test]
fn what_sweeps_leave_adds_up() -> Result<()> {
    let moments = PrincipalMoments::new(1.0, 2.0, 3.0)?;
    let rates = BodyVector::new(0.3, 1.0, -0.8);
    let scene = Scene::new(RigidBody::new(moments));
    let start = scene.body().state(Attitude::IDENTITY, rates)?;
    let free = FreeRotation::new(&scene);
    let mut covered = Errors::of("what the sweeps leave over what they are said to");
    let mut twin = Errors::of("twin: as if thrown at random");
    let mut power = Errors::of("power of the number of steps");
    for precision in [1e-7, 1e-9, 1e-11] {
        let mut left = Vec::new();
        for steps in [100_u64, 1000, 10_000, 100_000] {
            let t_end = steps as f64 / rates.norm();
            let condition = scene.solve(&start, t_end, 1e-2)?.condition;
            let end = |method: GaussLegendre| method.advance(&free, 0.0, &start, t_end);
            let (solved, _) = end(GaussLegendre::new(steps)?)?;
            let (loose, _) = end(GaussLegendre::with_precision(steps, precision)?)?;
            let apart = loose.attitude.angle_to(&solved.attitude);
            let apart = apart / (precision * (1.0 + condition));
            covered.push_at(apart / (1.0 + 0.004 * steps as f64), (precision, steps));
            if (steps, precision) == (100_000, 1e-11) {
                twin.push(apart / (1.0 + 0.25 * (steps as f64).sqrt()));
            }
            left.push(apart);
        }
        // From a thousand steps to a hundred thousand.
        power.push_at(log(left[3] / left[1]) / log(100.0), precision);
    }
    assert_largest!(covered, 12, @"0.626");
    assert_largest!(power, 3, @"1.02");
    assert!(power.smallest() > 0.9, "{}", power.smallest());
    twin.exceed(3.1, 1);
    Ok(())
}

/// A run that comes to no end has cost something, and it is counted; one that is not asked
/// for its work loses it with its error.
#[test]
fn work_that_came_to_nothing_is_counted() -> Result<()> {
    let moments = PrincipalMoments::new(1.0, 2.0, 2.5)?;
    let scene = Scene::new(RigidBody::new(moments));
    let start = scene.body().state(Attitude::IDENTITY, BodyVector::new(0.8, 0.4, 0.3))?;
    let mut work = Work::default();
    let free = FreeRotation::new(&scene);
    let failed = GaussLegendre::new(3)?.advance_counting(&free, 0.0, &start, 100.0, &mut work);
    assert!(matches!(failed, Err(Error::NoConvergence { .. })), "{failed:?}");
    // Eight for the slope at the start, and eight for each sweep of the step that failed.
    assert!(work.derivatives > 16 && work.derivatives % 8 == 0, "{work}");
    let before = work;
    let method = Dop853::new(1e-10)?.with_step_limit(10)?;
    let failed = method.advance_counting(&scene, 0.0, &start, 100.0, &mut work);
    assert!(matches!(failed, Err(Error::LimitReached { what: "steps", .. })), "{failed:?}");
    assert_eq!(work.steps + work.rejected, 10);
    assert!(work.derivatives >= before.derivatives + 10 * 11, "{work}");
    // What comes to its end counts as it says.
    let mut again = Work::default();
    let method = Dop853::new(1e-10)?;
    let end = method.advance_counting(&scene, 0.0, &start, 10.0, &mut again)?;
    assert_eq!((end, again), method.advance(&scene, 0.0, &start, 10.0)?);
    Ok(())
}

/// All torques that `solve` takes over those of the cheapest method as hindsight knows it, which
/// needs no second run, no estimate and no condition. It is dearest where little is asked for: the
/// condition has its price whatever the answer.
#[test]
fn the_price_of_not_knowing_is_bounded() -> Result<()> {
    let (mut loose, mut tight) = (Errors::of("price at 1e-3"), Errors::of("price at 1e-9"));
    let mut price = |problem: &Problem<((), GravityAtLever)>, case: f64| {
        for (tolerance, errors) in [(1e-3, &mut loose), (1e-9, &mut tight)] {
            let scene = &problem.scene;
            let solved = scene.solve_by_stepping(&problem.start, problem.end, tolerance)?;
            let runs = (Method::ALL.into_iter())
                .filter_map(|method| problem.least(method, tolerance).ok().flatten());
            let least = runs.map(|run| run.work.torques()).min();
            let least = least.expect("some method delivers") as f64;
            errors.push_at(solved.work.torques() as f64 / least, case);
        }
        Ok::<_, Error>(())
    };
    let angles = EulerAngles { phi: 0.3, theta: 0.8, zeta: 0.2 };
    for spin in [0.5, 2.0, 8.0] {
        for weight in [0.1, 1.0] {
            let gravity = GravityAtLever::new(weight, 1.0)?;
            let body = RigidBody::new(PrincipalMoments::symmetric(1.0, 0.6)?);
            let rates = BodyVector::new(0.3, 0.1, spin);
            let top = SymmetricTop::new(1.0, 0.6, weight, 1.0)?;
            let exact = HeavyTop::from_body(top, angles, rates)?.attitude(20.0);
            let start = body.state(Attitude::from_euler(angles)?, rates)?;
            let end = body.state(exact, rates)?;
            let scene = Scene::new(body).with(gravity);
            price(&Problem::new(scene, start, 20.0, end), spin)?;
        }
    }
    assert_largest!(loose, 6, @"67.9");
    assert_largest!(tight, 6, @"10.8");
    Ok(())
}
