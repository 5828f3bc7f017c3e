//! What an attack on the library found, each as it was found: scenes that were once promised
//! too much, ran for ever, or gave no number.

use super::forms::Form;
use super::motions::{By, Motion};
use super::naive::{on_euler_angles, on_quaternion};
use super::table::{Cell, Family, Naive, Row};
use kit::{Report, Result, Table};
use rotation_dynamics::accuracy::{Limits, Resolution, Stepper};
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::{Effect, GravityAtLever, Properties, Torque, check};
use rotation_dynamics::exact::free_body::FreeBody;
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::Method;
use rotation_dynamics::math::{exp, expm1, log, sin, sincos};
use rotation_dynamics::scene::Scene;

pub const FAMILY: Family = Family {
    key: "findings",
    title: "Found by attack",
    cure: "solve measures the condition on changes down to the smallest that doubles have, counts its torques, and says no",
    methods: &["solve"],
    forms: &Form::NAMES,
    rows,
};

pub fn turned(phi: f64, theta: f64, zeta: f64) -> rotation_dynamics::Result<Attitude> {
    Attitude::from_euler(EulerAngles { phi, theta, zeta })
}

/// What everyone does first, and where it gets to.
type Simple = fn(&Motion) -> (&'static str, Option<Attitude>);

/// A run of DOP853 at its tightest, and nobody asks whether it can be right.
fn believed(motion: &Motion) -> (&'static str, Option<Attitude>) {
    let end = motion.reached(By::Steps(Method::Dop853), Form::Quaternion, 0.0);
    ("one run of DOP853 at 1e-15, believed", end.ok())
}

fn on_angles(motion: &Motion) -> (&'static str, Option<Attitude>) {
    (
        "RK4 on Euler angles, 2000 steps",
        on_euler_angles(motion, 2000),
    )
}

fn coarse(motion: &Motion) -> (&'static str, Option<Attitude>) {
    (
        "RK4 on quaternion and rates, 100 steps",
        on_quaternion(motion, 100),
    )
}

/// A motion with a closed form, of which this error is asked.
fn asked(
    [case, wrong]: [&'static str; 2],
    by: By,
    (motion, naive): (&Motion, Simple),
    tolerance: f64,
) -> Result<Row> {
    let plain = motion.truth_as_given(Form::Quaternion)?;
    let (method, reached) = naive(motion);
    let mut cells = Vec::new();
    for form in Form::ALL {
        // What is refused needs no truth.
        let off = |end| Ok(motion.truth_as_given(form)?.angle_to(&end));
        let answer = motion.reached(by, form, tolerance).and_then(off);
        cells.push(Cell::of((case, "solve", form.name()), answer, tolerance)?);
    }
    let naive = Naive {
        method,
        error: reached.map_or(f64::NAN, |end| plain.angle_to(&end)),
    };
    let condition = motion.conditions()?[1];
    Ok(Row {
        case,
        wrong,
        condition,
        naive,
        cells,
    })
}

/// Any other scene, with so many torques at most. The naive method is RK4 if none is given.
fn scene<E: Effect>(
    [case, wrong]: [&'static str; 2],
    scene: &Scene<E>,
    (attitude, rates): (Attitude, BodyVector),
    (end, tolerance, budget): (f64, f64, u64),
    truth: Option<Attitude>,
    naive: Option<Naive>,
) -> Result<Row> {
    let limits = Limits {
        budget,
        ..Limits::default()
    };
    let off = |end: &State| truth.map_or(f64::NAN, |truth| truth.angle_to(&end.attitude));
    let mut condition = f64::NAN;
    let mut cells = Vec::new();
    for form in Form::ALL {
        let start = scene.body().state(form.through(attitude)?, rates)?;
        let solved = scene.solve_with(&start, end, tolerance, &limits);
        if let Ok(solved) = &solved {
            condition = solved.condition;
        }
        let delivered = solved.and_then(|solved| form.through(solved.state.attitude));
        let answer = delivered.map(|end| truth.map_or(f64::NAN, |truth| truth.angle_to(&end)));
        cells.push(Cell::of((case, "solve", form.name()), answer, tolerance)?);
    }
    let steps = Stepper::new(Method::Rk4, Resolution::Steps(1000))?;
    let start = scene.body().state(attitude, rates)?;
    let plain = || {
        let plain = steps.advance_as_usual(scene, [0.0, end], &start);
        Naive {
            method: "RK4, 1000 steps",
            error: plain.map_or(f64::NAN, |(end, _)| off(&end)),
        }
    };
    Ok(Row {
        case,
        wrong,
        condition,
        naive: naive.unwrap_or_else(plain),
        cells,
    })
}

fn rows() -> Result<Vec<Row>> {
    let mut rows = Vec::new();
    separatrices(&mut rows)?;
    inverted(&mut rows)?;
    endless(&mut rows)?;
    told(&mut rows)?;
    Ok(rows)
}

/// About the middle axis for 100 s, but for so much.
pub fn off_the_middle(off: f64) -> rotation_dynamics::Result<Motion> {
    let tilted = turned(0.3, 0.8, 0.2)?;
    Ok(Motion::free(
        [1.0, 2.0, 2.5],
        tilted,
        [off, 1.0, 0.0],
        100.0,
    ))
}

/// A top without spin whose push just lifts it to the vertical.
pub fn gets_up() -> rotation_dynamics::Result<Motion> {
    let (rate, (s, c)) = (2.0 * sin(1.25), sincos(1.0));
    let attitude = turned(0.3, 2.5, 1.0)?;
    let rates = [rate * c, -rate * s, 0.0];
    Ok(Motion::top([1.0, 0.5], 1.0, attitude, rates, 80.0))
}

/// Granted once 4e-5, 1e-10, 3e-3 and 1e-3 rad, and off by 0.046, 1.4e-6, 3.14 and 1.83.
fn separatrices(rows: &mut Vec<Row>) -> Result<()> {
    let tilted = turned(0.3, 0.8, 0.2)?;
    let middle = Motion::free(
        [1.0, 2.0, 2.5],
        turned(1.0, 0.5, 2.0)?,
        [0.0, 1.0, 0.0],
        100.0,
    );
    let off = off_the_middle(5e-15)?;
    let longer = Motion::free([1.0, 1.5, 2.0], tilted, [0.0, 1.0, 0.0], 200.0);
    let up = gets_up()?;
    let felt = "a condition felt on changes of 1e-12 is that of a tame motion";
    for (case, by, motion, tolerance) in [
        ("middle axis, 100 s", By::Request, &middle, 4e-5),
        ("middle axis, 100 s, stepped", By::Solve, &middle, 4e-5),
        ("5e-15 off the middle axis, 100 s", By::Request, &off, 1e-10),
        ("middle axis of another, 200 s", By::Request, &longer, 3e-3),
        ("a top that just gets up, 80 s", By::Request, &up, 1e-3),
        ("the same, stepped", By::Solve, &up, 1e-3),
    ] {
        rows.push(asked([case, felt], by, (motion, believed), tolerance)?);
    }
    // A set-up that did not return.
    let tiny = Motion::free([1.0, 2.0, 2.5], tilted, [4e-81, 4e-81, 1.0], 30.0);
    let words = [
        "rates of 4e-81 beside one of 1 rad/s",
        "an argument beside 1e-81 was halved for ever",
    ];
    rows.push(asked(words, By::Request, (&tiny, coarse), 1e-9)?);
    Ok(())
}

/// Released upside down at rest: taken for the motion that never leaves, and then no number.
fn inverted(rows: &mut Vec<Row>) -> Result<()> {
    let down = turned(0.597, core::f64::consts::PI, -7.354)?;
    let moment = -46.246_407_947_939_46 * 0.043_441_341_552_221_39;
    let wrong = "pi as a double is 6e-17 off, which is a fall";
    let weak = Motion::top([0.3, 0.5], -0.00981, down, [0.0; 3], 200.0);
    let strong = Motion::top([1.0, 1.0], moment, down, [0.0; 3], 1000.0);
    for (case, motion, tolerance) in [
        ("inverted at rest, a weak weight, 200 s", &weak, 1e-6),
        ("inverted at rest, 1000 s", &strong, 1e-6),
    ] {
        rows.push(asked(
            [case, wrong],
            By::Request,
            (motion, on_angles),
            tolerance,
        )?);
    }
    Ok(())
}

/// Torques after which a scene without end is given up, and what the others may take.
const ENDLESS: u64 = 200_000;
const ENOUGH: u64 = 1_000_000;

/// Scenes that ran without end, and one in which the truth cost the answer.
fn endless(rows: &mut Vec<Row>) -> Result<()> {
    let moments = PrincipalMoments::new(1.0, 1.3, 1.7)?;
    let free = Scene::new(RigidBody::new(moments));
    let rates = BodyVector::new(0.3, 0.2, 1.0);
    let start = (turned(0.3, 0.8, 0.2)?, rates);

    let rate = log(300.0) / 10.0;
    let driven = Torque::on_space("drive", move |_, _: &RigidBody, state: &State| {
        state.angular_momentum * rate
    });
    // L grows as exp(p t): a free motion in the time (exp(p t) - 1)/p.
    let inner = expm1(rate * 10.0) / rate;
    let truth = FreeBody::new(moments, start.0, rates)?.attitude(inner);
    let words = [
        "momentum that grows 300 times",
        "a probe that fails must not end the answer",
    ];
    rows.push(scene(
        words,
        &free.with(driven.smooth()),
        start,
        (10.0, 1e-8, ENOUGH),
        Some(truth),
        None,
    )?);

    let friction = Torque::on_space("dry friction", |_, _: &RigidBody, state: &State| {
        let l = state.angular_momentum;
        l * (-0.1 / l.norm().max(1e-300))
    });
    let words = [
        "dry friction on L, to a stop",
        "the torque turns about within a rounding of L",
    ];
    rows.push(scene(
        words,
        &free.with(friction),
        start,
        (40.0, 1e-6, ENDLESS),
        None,
        None,
    )?);

    let brake = Torque::on_space("brake", |_, _: &RigidBody, state: &State| {
        state.angular_momentum * -1e7
    });
    let words = ["a brake of 1e7/s for 100 s", "a billion stable steps"];
    rows.push(scene(
        words,
        &free.with(brake),
        start,
        (100.0, 1e-6, ENDLESS),
        None,
        None,
    )?);

    let wrong = Torque::on_space("no number", |t, _: &RigidBody, _: &State| {
        SpaceVector::new(0.0, 0.0, if t > 0.5 { f64::NAN } else { 1.0 })
    });
    let words = ["a torque that is no number", "NaN compares as nothing"];
    rows.push(scene(
        words,
        &free.with(wrong),
        start,
        (1.0, 1e-6, ENDLESS),
        None,
        None,
    )?);
    Ok(())
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

/// How often something was asked.
type Counter = core::cell::Cell<u64>;

/// A push along L, and the size that it says it has. It counts how often it is asked.
struct Pushes<'a> {
    scale: f64,
    asked: &'a Counter,
}

/// A part of L a second.
const PUSH: f64 = 0.5;

impl Effect for Pushes<'_> {
    const PROPERTIES: Properties = Properties {
        on_time: false,
        smooth: true,
        ..Properties::ANYTHING
    };
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

/// What effects say of themselves, and what `solve` says of its work.
fn told(rows: &mut Vec<Row>) -> Result<()> {
    // Once compiled, and integrated without its torque.
    let (tilted, rates) = (turned(0.1, 0.8, 0.2)?, [0.3, 0.1, 2.0]);
    let top = Motion::top([1.0, 0.5], 0.4, tilted, rates, 20.0);
    let heavy = Scene::new(RigidBody::new(top.body()?)).with(Plain(GravityAtLever::new(0.4, 1.0)?));
    let bare = Motion {
        gravity: None,
        ..top
    };
    let naive = Naive {
        method: "what has no form on the axis has no torque",
        error: top.off(Some(bare.truth()?)),
    };
    rows.push(scene(
        [
            "it sees the axis, and has no form for that",
            "a default that stands for none",
        ],
        &heavy,
        (tilted, BodyVector::from_array(rates)),
        (top.end, 1e-9, ENOUGH),
        Some(top.truth()?),
        Some(naive),
    )?);

    let moments = PrincipalMoments::new(1.0, 1.3, 1.7)?;
    let free = Scene::new(RigidBody::new(moments));
    let (end, rates) = (10.0, BodyVector::new(0.3, 0.2, 1.0));
    let truth = FreeBody::new(moments, tilted, rates)?.attitude(expm1(PUSH * end) / PUSH);
    let asked = Counter::new(0);
    for (case, scale) in [
        ("a torque whose scale is no number", f64::NAN),
        ("a torque whose scale is negative", -1.0),
    ] {
        let pushes = Pushes {
            scale,
            asked: &asked,
        };
        let naive = Naive {
            method: "steps halved until the error is within that scale",
            error: held_to(scale).map_or(f64::NAN, |grown| (grown - exp(PUSH * end)).abs()),
        };
        let words = [case, "an error is never less than a part of it"];
        rows.push(scene(
            words,
            &free.with(pushes),
            (tilted, rates),
            (end, 1e-6, ENOUGH),
            Some(truth),
            Some(naive),
        )?);
    }
    rows.push(counted(&free, (tilted, rates), end, &asked)?);
    Ok(())
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

/// The torques that `solve` says its runs took, against those that were asked for: once a
/// tenth was left out, those of runs that failed. Before any run an effect is looked at, to see
/// whether it is what it says; those looks are no work of a run, nor are a few along the way.
fn counted(
    free: &Scene<()>,
    (attitude, rates): (Attitude, BodyVector),
    end: f64,
    asked: &Counter,
) -> Result<Row> {
    let case = "the torques that it took, counted";
    let pushed = free.with(Pushes { scale: PUSH, asked });
    let mut cells = Vec::new();
    let mut run = 0.0;
    for form in Form::ALL {
        let start = pushed.body().state(form.through(attitude)?, rates)?;
        asked.set(0);
        check(pushed.effects(), pushed.body(), [0.0, end], &start)?;
        let looks = asked.replace(0);
        let solved = pushed.solve(&start, end, 1e-9)?;
        let counted = (asked.get() - looks) as f64;
        let off = (counted - solved.work.torques() as f64).abs() / counted;
        run = 1.0 - solved.run.torques() as f64 / counted;
        cells.push(Cell::of((case, "solve", form.name()), Ok(off), LOOKS)?);
    }
    Ok(Row {
        case,
        wrong: "a run that fails has cost something too",
        condition: f64::NAN,
        naive: Naive {
            method: "the work of the run that is given",
            error: run,
        },
        cells,
    })
}

/// The looks along the way, as a part of all torques: a hundredth at most.
const LOOKS: f64 = 1e-2;

/// Findings that are no error of a motion: what was found, and the test that sees it now.
pub const ELSEWHERE: [[&str; 4]; 12] = [
    [
        "2",
        "pulses narrower than a step, unnamed",
        "tests/accuracy/error_control/attack/named.rs",
        "narrow_pulses_are_seen",
    ],
    [
        "5",
        "a start at rest, a million turns, without end",
        "tests/accuracy/error_control/attack/named.rs",
        "no_run_without_end",
    ],
    [
        "7",
        "angles of so many turns that they are no number",
        "tests/exact/far_from_one/heavy_top.rs",
        "angles_of_too_many_turns_are_refused",
    ],
    [
        "8",
        "--csv put a file in the place of a device, a pipe, a link",
        "tests/cli.rs",
        "links_and_pipes_are_written_through_and_devices_refused",
    ],
    [
        "8",
        "a full disk, and an exit status of 0",
        "book/kit/src/cli.rs",
        "a_full_disk_is_an_error_and_a_reader_gone_is_none",
    ],
    [
        "9",
        "jumps without a name, refused with a wrong reason",
        "tests/accuracy/error_control/causes.rs",
        "jumps_without_a_name_are_found",
    ],
    [
        "9",
        "least tilt and period left out beside a pole",
        "tests/pages/ch16_2_gyroscope.rs",
        "near_a_pole_nothing_is_left_out",
    ],
    [
        "10",
        "up to 262 times the torques of the cheapest method",
        "tests/accuracy/error_control/causes.rs",
        "the_price_of_not_knowing_is_bounded",
    ],
    [
        "10",
        "the torques of a run that failed",
        "tests/accuracy/error_control/causes.rs",
        "work_that_came_to_nothing_is_counted",
    ],
    [
        "11",
        "an error control of scenes in phases that takes 16 times the error",
        "tests/planar/error_control.rs",
        "two_runs_agree_within_half_the_tolerance",
    ],
    [
        "11",
        "one that does not look at the states at events",
        "tests/planar/error_control.rs",
        "states_at_events_are_compared",
    ],
    [
        "11",
        "a pendulum that is harmonic up to k^2 = 1e-9",
        "tests/exact/pendulum.rs",
        "small_swings_are_not_harmonic",
    ],
];

/// The table of those.
pub fn elsewhere(report: &mut Report) -> Result<()> {
    let mut table = Table::new(
        "findings_elsewhere",
        ["finding", "what was found", "the test that sees it"],
    )?;
    for [number, found, _, test] in ELSEWHERE {
        table.push([number, found, test].map(str::to_owned))?;
    }
    report.add(table)
}
