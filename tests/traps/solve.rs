//! Global error control: time without bound, reasons that are not the reason.

use rotation_dynamics::accuracy::{Limits, Solved};
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::{Effect, Properties, Torque, ViscousFriction};
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::{Dop853, Integrator};
use rotation_dynamics::math::{cos, pow, sin};
use rotation_dynamics::motion::Motion;
use rotation_dynamics::scene::Scene;
use rotation_dynamics::{Error, Result};
use std::cell::{Cell, RefCell};
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering::Relaxed};
use support::EPS;

/// The n-th of a sequence that fills 0 to 1 evenly.
fn part(n: usize) -> f64 {
    (n as f64 * 0.618_033_988_749_894_9).fract()
}

fn body() -> Result<RigidBody> {
    Ok(RigidBody::new(PrincipalMoments::new(1.0, 1.3, 1.7)?))
}

fn turning(body: &RigidBody) -> Result<State> {
    body.state(Attitude::IDENTITY, BodyVector::new(0.3, 0.2, 1.0))
}

/// The weight of a top whose centre of mass is on e3, as a user writes it.
fn weight(strength: f64) -> impl Fn(f64, &RigidBody, &State) -> SpaceVector {
    move |_, _, state| {
        let [x, y, _] = state.attitude.axis().to_array();
        SpaceVector::new(y * strength, -x * strength, 0.0)
    }
}

/// States cost the steps of the run once, and some steps for each: not the number of times with the
/// length of the run. They are as good as the end, and the same in any order and alone.
#[test]
fn many_states_cost_the_run_and_some_steps_each() -> Result<()> {
    let (calls, body) = (AtomicU64::new(0), body()?);
    let start = turning(&body)?;
    let torque = weight(0.05);
    let counted = Torque::on_space("counted weight", |t, body: &RigidBody, state: &State| {
        calls.fetch_add(1, Relaxed);
        torque(t, body, state)
    })
    .smooth();
    let scene = Scene::new(body).with(counted);
    let mut ran = 0;
    for turns in [10.0, 100.0, 1000.0] {
        let (t_end, tolerance) = (turns * core::f64::consts::TAU, 1e-6);
        let motion = scene.solve_along(&start, t_end, tolerance, &Limits::default())?;
        let run = motion.solved().run.torques();
        for count in [100, 1000, 10_000] {
            // In no order.
            let times: Vec<f64> = (0..count).map(|n| t_end * part(n)).collect();
            calls.store(0, Relaxed);
            let states = motion.try_states(&times)?;
            // Parts of 8 steps at most, of some 50 torques each (Gauss-Legendre: 8 stages, and
            // their sweeps).
            let most = 2 * run + 8 * 60 * count as u64;
            assert!(
                calls.load(Relaxed) <= most,
                "{turns} {count}: {} of {most}",
                calls.load(Relaxed)
            );
            for n in (0..count).step_by(count / 5) {
                assert_eq!(motion.try_state(times[n])?, states[n], "{turns} {n}");
                if turns < 50.0 {
                    let alone = scene.solve(&start, times[n], 1e-10)?.state;
                    let off = alone.attitude.angle_to(&states[n].attitude);
                    assert!(off <= tolerance, "{turns} {n}: {off:e}");
                }
            }
            ran += 1;
        }
    }
    assert_eq!(ran, 9);
    Ok(())
}

/// Budget and cancel hold for states as for runs.
#[test]
fn states_are_within_the_budget_and_can_be_cancelled() -> Result<()> {
    let body = body()?;
    let start = turning(&body)?;
    let scene = Scene::new(body).with(Torque::on_space("weight", weight(0.05)).smooth());
    let times: Vec<f64> = (1..=1000).map(f64::from).collect();
    let needed = scene.solve_along(&start, 1000.0, 1e-6, &Limits::default())?;
    let work = needed.solved().work.torques();
    let limits = Limits { budget: work + 5000, ..Limits::default() };
    let over = scene.solve_at(&start, &times, 1e-6, &limits);
    assert!(
        matches!(over, Err(Error::LimitReached { what: "torques", limit, .. }) if limit == work + 5000)
    );
    // The same budget is enough for the run, and for one state.
    let motion = scene.solve_along(&start, 1000.0, 1e-6, &limits)?;
    motion.try_state(1.0)?;
    let cancel = AtomicBool::new(false);
    let limits = Limits { cancel: Some(&cancel), ..Limits::default() };
    let motion = scene.solve_along(&start, 1000.0, 1e-6, &limits)?;
    motion.try_states(&times)?;
    cancel.store(true, std::sync::atomic::Ordering::Relaxed);
    let cancelled = motion.try_states(&times);
    assert!(matches!(cancelled, Err(Error::Cancelled { .. })), "{cancelled:?}");
    Ok(())
}

/// A torque that sees the axis alone, and says so.
struct Pulled;
impl Effect for Pulled {
    const PROPERTIES: Properties = Properties {
        axis_only: true,
        on_rates: false,
        on_time: false,
        smooth: true,
        ..Properties::ANYTHING
    };
    fn name(&self) -> &'static str {
        "pulled"
    }
    fn torque(&self, _: f64, _: &RigidBody, state: &State) -> SpaceVector {
        let axis = state.attitude.axis();
        axis.cross(&SpaceVector::new(0.3, -0.2 * axis.z(), 0.4))
    }
}

/// Short motions, of which the places that were compared are few and not alike: states between them
/// are where they are.
#[test]
fn states_of_short_motions_are_where_they_are() -> Result<()> {
    let (mut ran, mut most) = (0, 0.0_f64);
    for n in 0..60 {
        let [a, b, c] = [3 * n + 1, 3 * n + 2, 3 * n + 3].map(part);
        let moments = PrincipalMoments::symmetric(0.6 + 0.8 * a, 1.1)?;
        let body = RigidBody::new(moments);
        let start = body.state(Attitude::IDENTITY, BodyVector::new(b, 0.3, 2.0 * c - 1.0))?;
        let scene = Scene::new(body).with(Pulled);
        let t_end = 1.0 + 5.0 * part(7 * n);
        let times: Vec<f64> = (1..=7).map(|n| t_end * f64::from(n) / 7.0).collect();
        let states = scene.solve_at(&start, &times, 1e-8, &Limits::default())?;
        for (t, state) in times.iter().zip(&states) {
            let alone = scene.solve(&start, *t, 1e-10)?.state;
            most = most.max(alone.attitude.angle_to(&state.attitude));
            ran += 1;
        }
    }
    assert!(most <= 1e-8, "{most:e}");
    assert_eq!(ran, 420);
    Ok(())
}

/// A table of a torque, straight between its knots, that counts how often its list is asked for.
struct Table {
    step: f64,
    knots: usize,
    asked: Cell<usize>,
}
impl Effect for Table {
    const PROPERTIES: Properties =
        Properties { smooth: true, on_rates: false, ..Properties::ANYTHING };
    fn name(&self) -> &'static str {
        "table"
    }
    fn torque(&self, t: f64, _: &RigidBody, _: &State) -> SpaceVector {
        let knot = (t / self.step).floor();
        let at = |n: f64| 0.01 * sin(1.7 * n * n);
        let share = t / self.step - knot;
        SpaceVector::new(0.0, 0.0, at(knot) * (1.0 - share) + at(knot + 1.0) * share)
    }
    fn break_points(&self) -> Vec<f64> {
        self.asked.set(self.asked.get() + 1);
        (1..self.knots).map(|n| n as f64 * self.step).collect()
    }
}

/// However many break points there are, their list is not made anew for each.
#[test]
fn break_points_are_asked_for_a_few_times() -> Result<()> {
    let body = RigidBody::new(PrincipalMoments::symmetric(1.0, 2.0)?);
    let start = body.state(Attitude::IDENTITY, BodyVector::new(0.0, 0.0, 0.5))?;
    let mut asked = Vec::new();
    for knots in [10, 100, 1000, 20_000] {
        let table = Table { step: 0.01, knots, asked: Cell::new(0) };
        let scene = Scene::new(body).with(table);
        let t_end = 0.01 * knots as f64;
        let end = scene.solve(&start, t_end, 1e-6)?;
        // Each knot adds its momentum times what is left.
        let mut angle = 0.5 * t_end;
        for n in 0..=knots {
            let torque = 0.01 * sin(1.7 * (n * n) as f64);
            let left = (knots - n) as f64;
            let weight = match n {
                0 => 0.5 * left - 1.0 / 6.0,
                _ if n == knots => 1.0 / 6.0,
                _ => left,
            };
            angle += torque / 2.0 * weight * 1e-4;
        }
        let exact = Attitude::about_body_axis(BodyVector::new(0.0, 0.0, 1.0), angle)?;
        let off = exact.angle_to(&end.state.attitude);
        assert!(off <= 1e-6, "{knots}: {off:e}");
        asked.push(scene.effects().1.asked.get());
    }
    assert!(asked.iter().all(|asked| *asked <= asked_at_most()), "{asked:?}");
    assert_eq!(asked.len(), 4);
    Ok(())
}

/// By the check (the list, and whether it is named), and by the limits.
const fn asked_at_most() -> usize {
    4
}

/// Spins that are next to nothing, with everything that may act, and bodies that are braked to
/// rest: the answer is that they rest.
#[test]
fn a_body_at_rest_is_no_error() -> Result<()> {
    let body = RigidBody::new(PrincipalMoments::new(6.0, 13.4, 8.0)?);
    let mut ran = 0;
    for exponent in -324..=-140 {
        let spin = pow(10.0, f64::from(exponent));
        let rates = BodyVector::new(0.3 * spin, 0.0, spin);
        let start = body.state(Attitude::IDENTITY, rates)?;
        let mut rests = |solved: Result<Solved>| {
            let name = format!("1e{exponent}, {ran}");
            ran += 1;
            let solved = solved.unwrap_or_else(|error| panic!("{name}: {error}"));
            let off = solved.state.attitude.angle_to(&start.attitude);
            assert!(off <= 4.0 * EPS, "{name}: {off:e}");
        };
        let scene = Scene::new(body);
        rests(scene.solve(&start, 1.0, 1e-6));
        rests((scene.with(ViscousFriction::new(0.3, 0.2)?)).solve(&start, 1.0, 1e-6));
        let brake = |_: f64, body: &RigidBody, state: &State| body.angular_velocity(state) * -2.0;
        rests((scene.with(Torque::on_body("brake", brake))).solve(&start, 1.0, 1e-6));
        let smooth = Torque::on_body("brake", brake).smooth();
        rests((scene.with(smooth)).solve(&start, 1.0, 1e-6));
        let none = |_: f64, _: &RigidBody, _: &State| BodyVector::zero();
        rests((scene.with(Torque::on_body("none", none))).solve(&start, 1.0, 1e-6));
    }
    assert_eq!(ran, 5 * 185);
    // Braked, the body turns by I omega / c and rests: at once where c is large.
    let mut braked = 0;
    for n in 0..40 {
        let strength = 200.0 * (1.0 + 49.0 * part(n));
        let brake = Torque::on_body("brake", |_: f64, body: &RigidBody, state: &State| {
            body.angular_velocity(state) * -strength
        })
        .smooth();
        let start = body.state(Attitude::IDENTITY, BodyVector::new(0.0, 0.0, 1.0))?;
        let t_end = 1.0 + 2.0 * part(2 * n);
        let end = Scene::new(body).with(brake).solve(&start, t_end, 1e-7);
        let end = end.unwrap_or_else(|error| panic!("{strength} for {t_end}: {error}"));
        let axis = BodyVector::new(0.0, 0.0, 1.0);
        let exact = Attitude::about_body_axis(axis, 8.0 / strength)?;
        let off = exact.angle_to(&end.state.attitude);
        assert!(off <= 1e-7, "{strength}: {off:e}");
        braked += 1;
    }
    assert_eq!(braked, 40);
    Ok(())
}

/// What is sampled and held, as a user writes it: `floor(t/dt)` with break points `k*dt`, of which some
/// are a unit in the last place beside the jump.
#[test]
fn a_sampled_torque_is_answered_between_its_samples() -> Result<()> {
    let body = body()?;
    let start = turning(&body)?;
    let (mut ran, mut most) = (0, 0.0_f64);
    for (dt, samples) in [(0.001, 1000), (0.1, 60), (0.01, 200), (1.0 / 3.0, 40)] {
        let held = |k: f64| BodyVector::new(0.3 * sin(3.7 * k), 0.2 * cos(1.9 * k), 0.1);
        let breaks: Vec<f64> = (1..samples).map(|k| f64::from(k) * dt).collect();
        let sampled =
            Torque::on_body("sampled", |t: f64, _: &RigidBody, _: &State| held((t / dt).floor()))
                .smooth()
                .with_break_points(&breaks)?;
        let t_end = f64::from(samples) * dt;
        let mut exact = start;
        for k in 0..samples {
            let constant =
                Torque::on_body("held", move |_: f64, _: &RigidBody, _: &State| held(f64::from(k)));
            let scene = Scene::new(body).with(constant);
            (exact, _) = Dop853::new(1e-14)?.advance(&scene, 0.0, &exact, dt)?;
        }
        let scene = Scene::new(body).with(sampled);
        for tolerance in [1e-3, 1e-6, 1e-9] {
            let end = scene.solve(&start, t_end, tolerance)?.state;
            most = most.max(end.attitude.angle_to(&exact.attitude) / tolerance);
            ran += 1;
        }
    }
    assert!(most <= 1.0, "{most}");
    assert_eq!(ran, 12);
    Ok(())
}

/// Samples from before the time 0 to after it, on whose break point no piece ends beyond it; and where
/// the break points are formed by adding up, the refusal says what is wrong with them.
#[test]
fn a_sampled_torque_may_pass_the_time_zero() -> Result<()> {
    let body = body()?;
    let start = turning(&body)?;
    let (mut answered, mut refused) = (0, 0);
    for (dt, first) in [(0.01, -100), (0.003, -70), (0.25, -13), (1.0 / 3.0, -31)] {
        let held = |k: f64| BodyVector::new(0.3 * sin(3.7 * k), 0.2 * cos(1.9 * k), 0.1);
        let sampled =
            Torque::on_body("sampled", |t: f64, _: &RigidBody, _: &State| held((t / dt).floor()))
                .smooth();
        let breaks: Vec<f64> = (first + 1..90).map(|k| f64::from(k) * dt).collect();
        let mut sums = vec![f64::from(first) * dt];
        for n in 1..150 {
            sums.push(sums[n - 1] + dt);
        }
        let limits = Limits { t_start: f64::from(first) * dt, ..Limits::default() };
        let solve = |breaks: &[f64]| -> Result<State> {
            let scene = Scene::new(body).with(sampled.clone().with_break_points(breaks)?);
            Ok(scene.solve_with(&start, 90.0 * dt, 1e-9, &limits)?.state)
        };
        let mut exact = start;
        for k in first..90 {
            let constant =
                Torque::on_body("held", move |_, _: &RigidBody, _: &State| held(f64::from(k)));
            let scene = Scene::new(body).with(constant);
            (exact, _) = Dop853::new(1e-14)?.advance(&scene, 0.0, &exact, dt)?;
        }
        let end = solve(&breaks)?;
        assert!(end.attitude.angle_to(&exact.attitude) <= 1e-9);
        answered += 1;
        if let Err(error) = solve(&sums) {
            let error = error.to_string();
            assert!(error.contains("form both in the same way"), "{error}");
            refused += 1;
        }
    }
    // A quarter is added up exactly.
    assert_eq!((answered, refused), (4, 3));
    Ok(())
}

/// A jump of an attitude is told at the time at which it was looked for, which no angle is.
#[test]
fn a_jump_of_an_attitude_is_told_with_its_time() -> Result<()> {
    let body = body()?;
    let plate = Torque::on_body("plate", |_, _: &RigidBody, state: &State| {
        BodyVector::new(0.1 * state.attitude.axis().y().signum(), 0.0, 0.0)
    });
    let limits = Limits { t_start: 5.0, ..Limits::default() };
    let scene = Scene::new(body).with(plate.smooth());
    let error = scene.solve_with(&turning(&body)?, 6.0, 1e-6, &limits);
    let Err(Error::Contradiction { effect, t, .. }) = &error else {
        panic!("{error:?}");
    };
    assert_eq!((effect.as_str(), *t), ("plate", 5.0));
    Ok(())
}

/// A torque by time and state, of a controller that may remember.
type Law<'l> = dyn Fn(f64, &State) -> SpaceVector + 'l;
struct Controller<'l>(&'l Law<'l>);
impl Effect for Controller<'_> {
    const PROPERTIES: Properties = Properties::ANYTHING;
    fn name(&self) -> &'static str {
        "controller"
    }
    fn torque(&self, t: f64, _: &RigidBody, state: &State) -> SpaceVector {
        (self.0)(t, state)
    }
}

/// A torque that remembers is refused by its name, however it remembers; one that counts its calls and
/// gives the same torque is not.
#[test]
fn a_torque_that_remembers_is_refused() -> Result<()> {
    let body = body()?;
    let start = turning(&body)?;
    let brake = |state: &State| state.angular_momentum * -0.1;
    let solve = |torque: &Law<'_>, tolerance: f64| {
        let scene = Scene::new(body).with(Controller(torque));
        scene.solve(&start, 3.0, tolerance)
    };
    let mut refused = 0;
    for n in 0..40 {
        let dt = pow(10.0, -4.0 + 3.5 * part(n));
        let tolerance = pow(10.0, -2.0 - 6.0 * part(3 * n));
        let (sample, last) = (Cell::new(f64::NAN), Cell::new(SpaceVector::zero()));
        let by_number = |t: f64, state: &State| {
            let now = (t / dt).floor();
            if now != sample.replace(now) {
                last.set(brake(state));
            }
            last.get()
        };
        let (next, kept) = (Cell::new(0.0), Cell::new(SpaceVector::zero()));
        let by_clock = |t: f64, state: &State| {
            if t >= next.get() {
                next.set(t + dt);
                kept.set(brake(state));
            }
            kept.get()
        };
        let sum = RefCell::new(SpaceVector::zero());
        let by_sum = |_: f64, state: &State| {
            let mut sum = sum.borrow_mut();
            *sum += state.angular_momentum * (1e-3 * dt);
            brake(state) - *sum
        };
        let before = Cell::new(0.0);
        let by_difference = |_: f64, state: &State| {
            let now = state.angular_momentum.x();
            SpaceVector::new(before.replace(now) - now, 0.0, 0.0)
        };
        // These show it late, or between two places only.
        let (pulled, on) = (SpaceVector::new(0.0, 0.0, -0.2), Cell::new(false));
        let latched = |_: f64, state: &State| {
            on.set(on.get() || state.attitude.axis().x() > 0.9);
            if on.get() { pulled } else { brake(state) }
        };
        let late = Cell::new(0.0);
        let by_late_sum = |t: f64, state: &State| {
            late.set(late.get() + if t > 2.0 { 1e-3 * dt } else { 0.0 });
            brake(state) * (1.0 + late.get())
        };
        let far = Cell::new(1.0);
        let with_hysteresis = |_: f64, state: &State| {
            let x = state.attitude.axis().x();
            if x.abs() > 0.6 {
                far.set(x.signum());
            }
            pulled * (0.1 * far.get())
        };
        let all: [&Law<'_>; 7] = [
            &by_number,
            &by_clock,
            &by_sum,
            &by_difference,
            &latched,
            &by_late_sum,
            &with_hysteresis,
        ];
        for torque in all {
            let error = solve(torque, tolerance).expect_err("it remembers").to_string();
            let named = error.contains("\"controller\"") && error.contains("remembers nothing");
            assert!(named, "{n}: {error}");
            refused += 1;
        }
    }
    assert_eq!(refused, 280);
    let calls = Cell::new(0);
    let counts = |_: f64, state: &State| {
        calls.set(calls.get() + 1);
        brake(state)
    };
    solve(&counts, 1e-6)?;
    assert!(calls.get() > 0);
    Ok(())
}

/// A torque that jumps with the state, back and forth, and what it is called.
fn switched(name: &'static str, kind: usize, size: f64) -> Torque<'static> {
    let sign = |x: f64| if x == 0.0 { 0.0 } else { 1f64.copysign(x) };
    Torque::on_body(name, move |_, body: &RigidBody, state: &State| {
        let [a, b, c] = body.angular_velocity(state).to_array();
        let [_, x, y, z] = state.attitude.quaternion();
        let errors = [a + x, b + y, c + z];
        let [u, v, w] = match kind {
            // A bearing that rubs, thrusters, the same with a deadband, a coarse converter.
            0 => [0.0, 0.0, -sign(c)],
            1 => errors.map(|error| -2.0 * sign(error)),
            2 => errors.map(|error| if error.abs() > 0.05 { -2.0 * sign(error) } else { 0.0 }),
            _ => errors.map(|error| -(error / 0.02).round()),
        };
        BodyVector::new(u, v, w) * size
    })
}

/// Where a motion slides along a jump of the torque that nothing declares, or takes too much over such
/// jumps, the refusal says what to declare; the same torque as a switch is told to slide.
#[test]
fn a_jump_with_the_state_is_to_be_declared() -> Result<()> {
    let body = body()?;
    let limits = Limits { budget: 1_000_000, ..Limits::default() };
    let mut ran = 0;
    for n in 0..12 {
        let (kind, size) = (n % 4, 0.03 + 0.03 * part(n));
        let rates = BodyVector::new(0.3 * part(3 * n), 0.2, 0.5 + 0.3 * part(5 * n));
        let start = body.state(Attitude::IDENTITY, rates)?;
        let law = switched("switching law", kind, size);
        let error = (Scene::new(body).with(law)).solve_with(&start, 100.0, 1e-7, &limits);
        let error = error.expect_err("it slides");
        let Error::Undeclared { effect, limit: 1_000_000, .. } = &error else {
            panic!("{n}: {error}");
        };
        assert_eq!(effect, "switching law");
        let said = error.to_string();
        assert!(
            said.contains("where it jumps with the state, make it a switch (`Switched`)"),
            "{said}"
        );
        ran += 1;
    }
    assert_eq!(ran, 12);
    // A hundred jumps in a turn, all of them crossed: too many for the budget.
    let wheel = Torque::on_body("toothed wheel", |_, _: &RigidBody, state: &State| {
        BodyVector::new(0.0, 0.0, 0.1 * sin(30.0 * state.attitude.axis().y()).signum())
    });
    let start = body.state(Attitude::IDENTITY, BodyVector::new(0.9, -0.2, 0.2))?;
    let crossed = (Scene::new(body).with(wheel)).solve_with(&start, 1e5, 1e-4, &limits);
    assert!(matches!(crossed, Err(Error::Undeclared { .. })), "{crossed:?}");
    // The twin: a budget too small for what is called smooth.
    let smooth = Torque::on_space("weight", weight(0.05)).smooth();
    let dear = Scene::new(body).with(smooth).solve_with(&start, 1e5, 1e-6, &limits);
    assert!(matches!(dear, Err(Error::LimitReached { what: "torques", .. })), "{dear:?}");
    Ok(())
}

/// A pulse that no look meets, and tables with more knots than looks: an answer within the request, or
/// one that says how far the looks are apart; no separatrix, and no step that is too short.
#[test]
fn what_looks_may_miss_is_said() -> Result<()> {
    let body = body()?;
    let limits = Limits { budget: 300_000, ..Limits::default() };
    let (mut said, mut over, mut refused) = (0, 0, 0);
    let day = 86_400.0;
    let slow = body.state(Attitude::IDENTITY, BodyVector::new(3e-4, 2e-4, 1e-3))?;
    for n in 0..24 {
        let tolerance = [1e-3, 1e-6, 1e-10, 1e-11][n % 4];
        let begun = day * part(n + 1);
        let firing = Torque::on_body("thruster", |t: f64, _: &RigidBody, _: &State| {
            let on = (begun..begun + 5.0).contains(&t);
            BodyVector::new(if on { 1e-3 } else { 0.0 }, 0.0, 0.0)
        });
        let knots = 4000.0 + 8000.0 * part(2 * n);
        let table = Torque::on_body("table", |t: f64, _: &RigidBody, _: &State| {
            let at = |k: f64| BodyVector::new(part(k as usize), 0.3, part(3 * k as usize)) * 1e-6;
            let (knot, share) = ((t / day * knots).floor(), (t / day * knots).fract());
            at(knot) * (1.0 - share) + at(knot + 1.0) * share
        });
        let scene = Scene::new(body);
        let fired = (scene.with(firing)).solve_with(&slow, day, tolerance, &limits);
        let read = (scene.with(table)).solve_with(&slow, day, tolerance, &limits);
        for (name, solved) in [("thruster", fired), ("table", read)] {
            match solved {
                Ok(solved) => {
                    assert_eq!(solved.looked_every, Some(day / 4096.0));
                    said += 1;
                }
                Err(Error::Undeclared { effect, every, .. }) => {
                    assert!(effect == name && every == day / 4096.0);
                    over += 1;
                }
                Err(Error::NotDelivered { condition: None, .. } | Error::StepUnderflow { .. }) => {
                    refused += 1;
                }
                Err(error) => panic!("{n} {name}: {error}"),
            }
        }
    }
    assert_eq!([said, over, refused], [18, 28, 2]);
    // Named, it is met; and where nothing depends on the time, nothing was looked for.
    let named = Torque::on_body("thruster", |t: f64, _: &RigidBody, _: &State| {
        BodyVector::new(if (1e3..1005.0).contains(&t) { 1e-4 } else { 0.0 }, 0.0, 0.0)
    })
    .with_break_points(&[1e3, 1005.0])?;
    let solved = Scene::new(body).with(named).solve(&slow, day, 1e-6)?;
    assert!(solved.looked_every.is_some());
    let still = Scene::new(body).with(Pulled).solve(&slow, 10.0, 1e-6)?;
    assert_eq!(still.looked_every, None);
    Ok(())
}

/// Where the floor is far above the request, a refusal costs little against an answer; and what it says
/// can be had is had.
#[test]
fn what_is_hopeless_is_refused_at_once() -> Result<()> {
    let (calls, mut ran) = (AtomicU64::new(0), 0);
    for n in 0..6 {
        let (a, b) = (part(3 * n + 1), part(3 * n + 2));
        let body = RigidBody::new(PrincipalMoments::new(1.0 + 0.5 * a, 1.0 + 0.5 * b, 1.6)?);
        let start = body.state(Attitude::IDENTITY, BodyVector::new(a - 0.5, b, 1.0))?;
        let torque = weight(0.05);
        let counted = Torque::on_space("swing", |t: f64, body: &RigidBody, state: &State| {
            calls.fetch_add(1, Relaxed);
            torque(t, body, state) + SpaceVector::new(0.05 * sin(t), 0.02 * cos(1.3 * t), 0.0)
        })
        .smooth();
        let scene = Scene::new(body).with(counted);
        let solve = |tolerance: f64| {
            calls.store(0, Relaxed);
            let solved = scene.solve(&start, 600.0, tolerance);
            (solved, calls.load(Relaxed))
        };
        let (refused, dear) = solve(1e-14);
        let error = refused.expect_err("hopeless");
        let Error::NotDelivered { best: attainable, condition: Some(_), .. } = error else {
            panic!("{n}: {error}");
        };
        let (solved, cheap) = solve(20.0 * attainable);
        solved?;
        assert!(dear < 3 * cheap, "{n}: {dear} against {cheap}");
        ran += 1;
    }
    assert_eq!(ran, 6);
    Ok(())
}

/// A motion that itself ends in finite time is no matter of steps: the time that is told is that of the
/// motion, not of the piece in which it is.
#[test]
fn a_motion_that_ends_is_told_with_its_time() -> Result<()> {
    let body = body()?;
    let mut ran = 0;
    for n in 0..10 {
        // dL/dt = L^2/(L_0 T) ends at T.
        let (spin, end) = (0.5 + part(n), 2.0 + 20.0 * part(3 * n));
        let start = body.state(Attitude::IDENTITY, BodyVector::new(0.0, 0.0, spin))?;
        let rate = 1.0 / (body.moments().i3() * spin * end);
        let driven = Torque::on_space("driven", |_, _: &RigidBody, state: &State| {
            let l = state.angular_momentum.z();
            SpaceVector::new(0.0, 0.0, l * l * rate)
        });
        let limits = Limits { budget: 2_000_000, ..Limits::default() };
        let solved = Scene::new(body).with(driven).solve_with(&start, 1.5 * end, 1e-6, &limits);
        match solved.expect_err("it ends") {
            Error::StepUnderflow { t, .. } | Error::FunctionOutOfRange { t, .. } => {
                assert!((t - end).abs() < 1e-3 * end, "{n}: {t} for {end}");
                ran += 1;
            }
            error => panic!("{n}: {error}"),
        }
    }
    assert_eq!(ran, 10);
    Ok(())
}
