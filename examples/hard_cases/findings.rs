//! What an attack on the library found, each as it was found: scenes that were once promised
//! too much, ran for ever, or gave no number.

use super::motions::DOP853;
use super::naive::{on_euler_angles, on_quaternion};
use super::rotations::start;
use super::*;
use rotation_dynamics::effects::{Properties, check};

/// What everyone does first, and where it gets to.
type Simple = (&'static str, fn(&Motion) -> Option<Attitude>);

/// Nobody asks whether it can be right.
const BELIEVED: Simple =
    ("one run of DOP853 at 1e-15, believed", |motion| motion.reached(DOP853, QUATERNION, 0.0).ok());
const ON_ANGLES: Simple = ("RK4 on Euler angles, 2000 steps", |m| on_euler_angles(m, 2000));
const COARSE: Simple = ("RK4 on quaternion and rates, 100 steps", |m| on_quaternion(m, 100));

/// A motion with a closed form, of which this error is asked.
fn asked(motion: Motion, by: By, tolerance: f64, (method, naive): Simple) -> Result<Answered> {
    let plain = motion.truth_as_given(QUATERNION)?;
    let error = naive(&motion).map_or(f64::NAN, |end| plain.angle_to(&end));
    let answers = FORMS.map(|form| {
        // What is refused needs no truth.
        let off = |end| Ok(motion.truth_as_given(form)?.angle_to(&end));
        (motion.reached(by, form, tolerance).and_then(off), tolerance)
    });
    let condition = motion.conditions()?[1];
    Ok(Answered(condition, (method, error), answers.into()))
}

/// Torques after which a scene without end is given up, and what the others may take.
const ENDLESS: u64 = 200_000;
const ENOUGH: u64 = 1_000_000;

/// Any other scene: a start, an end, the error asked for, with so many torques at most.
#[derive(Clone, Copy)]
struct Task(Attitude, BodyVector, f64, f64, u64);

impl Task {
    fn new(phi: f64, end: f64, tolerance: f64, budget: u64) -> Solved<Self> {
        let rates = BodyVector::new(0.3, 0.2, 1.0);
        Ok(Self(turned(phi, 0.8, 0.2)?, rates, end, tolerance, budget))
    }

    /// What `solve` makes of it in this scene.
    fn of<E: Effect>(self, scene: &Scene<E>, truth: End, naive: Naive) -> Result<Answered> {
        let Self(attitude, rates, end, tolerance, budget) = self;
        let limits = Limits { budget, ..Limits::default() };
        let mut condition = f64::NAN;
        let answers = in_each_form(attitude, truth, tolerance, |from| {
            let start = scene.body().state(from, rates)?;
            let solved = scene.solve_with(&start, end, tolerance, &limits)?;
            condition = solved.condition;
            Ok(solved.state.attitude)
        });
        Ok(Answered(condition, naive, answers.into()))
    }

    /// The same, beside RK4.
    fn beside_rk4<E: Effect>(self, effect: E, truth: End) -> Result<Answered> {
        let Self(attitude, rates, end, ..) = self;
        let scene = free()?.with(effect);
        let steps = Stepper::new(Method::Rk4, Resolution::Steps(1000))?;
        let start = scene.body().state(attitude, rates)?;
        let plain = steps.advance_as_usual(&scene, [0.0, end], &start);
        let off = |(truth, (end, _)): (Attitude, (State, _))| truth.angle_to(&end.attitude);
        let error = truth.zip(plain.ok()).map_or(f64::NAN, off);
        self.of(&scene, truth, ("RK4, 1000 steps", error))
    }
}

/// Where it ends, if that is known.
type End = Option<Attitude>;

fn free_for(moments: [f64; 3], rates: [f64; 3], end: f64) -> Solved<Motion> {
    Ok(Motion::free(moments, start()?, rates, end))
}

/// About the middle axis for 100 s, but for so much.
pub fn off_the_middle(off: f64) -> Solved<Motion> {
    free_for([1.0, 2.0, 2.5], [off, 1.0, 0.0], 100.0)
}

/// Exactly about it.
pub fn on_the_middle(end: f64) -> Solved<Motion> {
    let from = turned(1.0, 0.5, 2.0)?;
    Ok(Motion::free([1.0, 2.0, 2.5], from, [0.0, 1.0, 0.0], end))
}

/// A top without spin whose push just lifts it to the vertical.
pub fn gets_up() -> Solved<Motion> {
    let (rate, (s, c)) = (2.0 * sin(1.25), sincos(1.0));
    let (tilted, rates) = (turned(0.3, 2.5, 1.0)?, [rate * c, -rate * s, 0.0]);
    Ok(Motion::top([1.0, 0.5], 1.0, tilted, rates, 80.0))
}

/// Released upside down at rest: taken for the motion that never leaves, and then no number.
fn inverted(moments: [f64; 2], pull: f64, end: f64) -> Solved<Motion> {
    let down = turned(0.597, PI, -7.354)?;
    Ok(Motion::top(moments, pull, down, [0.0; 3], end))
}

/// A weight times its lever (N m).
const STRONG: f64 = -46.246_407_947_939_46 * 0.043_441_341_552_221_39;

fn moments() -> Solved<PrincipalMoments> {
    PrincipalMoments::new(1.0, 1.3, 1.7)
}

fn free() -> Solved<Scene<()>> {
    Ok(Scene::new(RigidBody::new(moments()?)))
}

/// L grows as exp(p t): a free motion in the time (exp(p t) - 1)/p.
fn grown(Task(attitude, rates, end, ..): Task, rate: f64) -> Solved<Attitude> {
    let body = FreeBody::new(moments()?, attitude, rates)?;
    Ok(body.attitude(expm1(rate * end) / rate))
}

fn driven() -> Result<Answered> {
    let rate = log(300.0) / 10.0;
    let task = Task::new(0.3, 10.0, 1e-8, ENOUGH)?;
    let drive = Torque::on_space("drive", move |_, _: &RigidBody, state: &State| {
        state.angular_momentum * rate
    });
    task.beside_rk4(drive.smooth(), Some(grown(task, rate)?))
}

type Drive = fn(f64, SpaceVector) -> SpaceVector;

/// A torque in space, of the time and L, for which no end is known.
fn endless(name: &'static str, end: f64, torque: Drive) -> Result<Answered> {
    let torque = Torque::on_space(name, move |t, _: &RigidBody, state: &State| {
        torque(t, state.angular_momentum)
    });
    Task::new(0.3, end, 1e-6, ENDLESS)?.beside_rk4(torque, None)
}

/// Gravity that gives its torque and no more: it sees the axis alone, and says so.
struct Plain(GravityAtLever);

impl Effect for Plain {
    const PROPERTIES: Properties = GravityAtLever::PROPERTIES;
    fn name(&self) -> &'static str {
        "plain gravity"
    }
    fn torque(&self, t: f64, body: &RigidBody, state: &State) -> SpaceVector {
        self.0.torque(t, body, state)
    }
    fn potential_energy(&self, t: f64, body: &RigidBody, state: &State) -> f64 {
        self.0.potential_energy(t, body, state)
    }
}

/// Once compiled, and integrated without its torque.
fn plain_gravity() -> Result<Answered> {
    let (tilted, rates) = (turned(0.1, 0.8, 0.2)?, [0.3, 0.1, 2.0]);
    let top = Motion::top([1.0, 0.5], 0.4, tilted, rates, 20.0);
    let bare = Motion::free(top.moments, tilted, rates, top.end);
    let gravity = Plain(GravityAtLever::new(0.4, 1.0)?);
    let heavy = Scene::new(RigidBody::new(top.body()?)).with(gravity);
    let error = top.off(Some(bare.truth()?));
    let naive = ("what has no form on the axis has no torque", error);
    let task = Task(top.attitude, top.rates(), top.end, 1e-9, ENOUGH);
    task.of(&heavy, Some(top.truth()?), naive)
}

/// A push along L, and the size that it says it has. It counts how often it is asked.
struct Pushes<'a> {
    scale: f64,
    asked: &'a core::cell::Cell<u64>,
}

/// A part of L a second.
const PUSH: f64 = 0.5;

impl Effect for Pushes<'_> {
    const PROPERTIES: Properties =
        Properties { on_time: false, smooth: true, ..Properties::ANYTHING };
    fn name(&self) -> &'static str {
        "push"
    }
    fn torque(&self, _t: f64, _: &RigidBody, state: &State) -> SpaceVector {
        self.asked.set(self.asked.get() + 1);
        state.angular_momentum * PUSH
    }
    fn torque_scale(&self, _t: f64, _: &RigidBody, state: &State) -> f64 {
        self.scale * state.angular_momentum.norm()
    }
}

/// y' = y/2 by Euler's steps, halved until two halves differ from the whole by a millionth of
/// the scale; nothing if that has not come to the end after a million tries.
fn held_to(scale: f64) -> Option<f64> {
    let (mut t, mut y, mut h) = (0.0, 1.0, 0.1);
    for _ in 0..1_000_000 {
        let whole = y * (1.0 + PUSH * h);
        let halves = y * (1.0 + 0.5 * PUSH * h) * (1.0 + 0.5 * PUSH * h);
        if (whole - halves).abs() <= 1e-6 * scale {
            (t, y) = (t + h, halves);
        } else {
            h *= 0.5;
        }
        if t >= 10.0 {
            return Some(y);
        }
    }
    None
}

/// A torque that says this of its size.
fn of_scale(scale: f64) -> Result<Answered> {
    let task = Task::new(0.1, 10.0, 1e-6, ENOUGH)?;
    let (truth, asked) = (grown(task, PUSH)?, &Default::default());
    let grown = held_to(scale).map_or(f64::NAN, |grown| (grown - exp(PUSH * 10.0)).abs());
    let naive = ("steps halved until the error is within that scale", grown);
    task.of(&free()?.with(Pushes { scale, asked }), Some(truth), naive)
}

/// The looks along the way, as a part of all torques: a hundredth at most.
const LOOKS: f64 = 1e-2;

/// The torques that `solve` says its runs took, against those that were asked for: once a
/// tenth was left out, those of runs that failed. Before any run an effect is looked at, to see
/// whether it is what it says; those looks are no work of a run, nor are a few along the way.
fn counted() -> Result<Answered> {
    let Task(attitude, rates, end, tolerance, _) = Task::new(0.1, 10.0, 1e-9, ENOUGH)?;
    let asked = &core::cell::Cell::new(0);
    let pushed = free()?.with(Pushes { scale: PUSH, asked });
    let (mut answers, mut run) = (Vec::new(), 0.0);
    for form in FORMS {
        let start = pushed.body().state(form(attitude)?, rates)?;
        asked.set(0);
        check(pushed.effects(), pushed.body(), [0.0, end], &start)?;
        let looks = asked.replace(0);
        let solved = pushed.solve(&start, end, tolerance)?;
        let counted = (asked.get() - looks) as f64;
        let off = (counted - solved.work.torques() as f64).abs() / counted;
        run = 1.0 - solved.run.torques() as f64 / counted;
        answers.push((Ok(off), LOOKS));
    }
    let naive = ("the work of the run that is given", run);
    Ok(Answered(f64::NAN, naive, answers))
}

family! { FAMILY, "findings": "Found by attack",
    by [By::Request], in NAMES, seen in stepped::risen;
    // Granted once 4e-5, 1e-10, 3e-3 and 1e-3 rad, and off by 0.046, 1.4e-6, 3.14 and 1.83.
    "middle axis, 100 s", "a condition felt on changes of 1e-12 is that of a tame motion":
        asked(on_the_middle(100.0)?, By::Request, 4e-5, BELIEVED);
    "middle axis, 100 s, stepped", "a condition felt on changes of 1e-12 is that of a tame motion":
        asked(on_the_middle(100.0)?, By::Solve, 4e-5, BELIEVED);
    "5e-15 off the middle axis, 100 s", "a condition felt on changes of 1e-12 is that of a tame motion":
        asked(off_the_middle(5e-15)?, By::Request, 1e-10, BELIEVED);
    "middle axis of another, 200 s", "a condition felt on changes of 1e-12 is that of a tame motion":
        asked(free_for([1.0, 1.5, 2.0], [0.0, 1.0, 0.0], 200.0)?, By::Request, 3e-3, BELIEVED);
    "a top that just gets up, 80 s", "a condition felt on changes of 1e-12 is that of a tame motion":
        asked(gets_up()?, By::Request, 1e-3, BELIEVED);
    "the same, stepped", "a condition felt on changes of 1e-12 is that of a tame motion":
        asked(gets_up()?, By::Solve, 1e-3, BELIEVED);
    "rates of 4e-81 beside one of 1 rad/s", "an argument beside 1e-81 was halved for ever":
        asked(free_for([1.0, 2.0, 2.5], [4e-81, 4e-81, 1.0], 30.0)?, By::Request, 1e-9, COARSE);
    "inverted at rest, a weak weight, 200 s", "pi as a double is 6e-17 off, which is a fall":
        asked(inverted([0.3, 0.5], -0.00981, 200.0)?, By::Request, 1e-6, ON_ANGLES);
    "inverted at rest, 1000 s", "pi as a double is 6e-17 off, which is a fall":
        asked(inverted([1.0, 1.0], STRONG, 1000.0)?, By::Request, 1e-6, ON_ANGLES);
    "momentum that grows 300 times", "a probe that fails must not end the answer": driven();
    "dry friction on L, to a stop", "the torque turns about within a rounding of L":
        endless("dry friction", 40.0, |_, l| l * (-0.1 / l.norm().max(1e-300)));
    "a brake of 1e7/s for 100 s", "a billion stable steps":
        endless("brake", 100.0, |_, l| l * -1e7);
    "a torque that is no number", "NaN compares as nothing":
        endless("no number", 1.0, |t, _| SpaceVector::new(0.0, 0.0, if t > 0.5 { f64::NAN } else { 1.0 }));
    "it sees the axis, and has no form for that", "a default that stands for none": plain_gravity();
    "a torque whose scale is no number", "an error is never less than a part of it":
        of_scale(f64::NAN);
    "a torque whose scale is negative", "an error is never less than a part of it": of_scale(-1.0);
    "the torques that it took, counted", "a run that fails has cost something too": counted();
}

/// Findings that are no error of a motion: what was found, and the file and the test that sees it
/// now; a finding an entry.
macro_rules! elsewhere {
    ($( $finding:literal: $found:literal, $file:literal $test:ident; )+) => {
        pub const ELSEWHERE: &[[&str; 4]] = &[ $( [$finding, $found, $file, stringify!($test)] ),+ ];
    };
}

elsewhere! {
    "2": "pulses narrower than a step, unnamed",
        "tests/accuracy/error_control/attack/named.rs" narrow_pulses_are_seen;
    "5": "a start at rest, a million turns, without end",
        "tests/accuracy/error_control/attack/named.rs" no_run_without_end;
    "7": "angles of so many turns that they are no number",
        "tests/exact/far_from_one/heavy_top.rs" angles_of_too_many_turns_are_refused;
    "8": "--csv put a file in the place of a device, a pipe, a link",
        "tests/cli.rs" links_and_pipes_are_written_through_and_devices_refused;
    "8": "a full disk, and an exit status of 0",
        "book/kit/src/cli.rs" a_full_disk_is_an_error_and_a_reader_gone_is_none;
    "9": "jumps without a name, refused with a wrong reason",
        "tests/accuracy/error_control/causes.rs" jumps_without_a_name_are_found;
    "9": "least tilt and period left out beside a pole",
        "tests/pages/ch16_2_gyroscope.rs" near_a_pole_nothing_is_left_out;
    "10": "up to 262 times the torques of the cheapest method",
        "tests/accuracy/error_control/causes.rs" the_price_of_not_knowing_is_bounded;
    "10": "the torques of a run that failed",
        "tests/accuracy/error_control/causes.rs" work_that_came_to_nothing_is_counted;
    "11": "an error control of scenes in phases that takes 16 times the error",
        "tests/planar/error_control.rs" two_runs_agree_within_half_the_tolerance;
    "11": "one that does not look at the states at events",
        "tests/planar/error_control.rs" states_at_events_are_compared;
    "11": "a pendulum that is harmonic up to k^2 = 1e-9",
        "tests/exact/pendulum.rs" small_swings_are_not_harmonic;
}
