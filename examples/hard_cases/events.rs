//! Contacts that graze, come two at a time or at a step's end, stick, stop, and never stop
//! bouncing.

use super::contacts;
use super::ladder::{LENGTH, Ladder};
use super::table::{Cell, Family, Naive, Row, bound};
use kit::Result;
use rotation_dynamics::Error;
use rotation_dynamics::exact::ladder::Ladder as Exact;
use rotation_dynamics::integrators::{Dop853, size_or};
use rotation_dynamics::math::{atan2, sincos};
use rotation_dynamics::planar::contact::{
    Contact, Mechanism, MechanismState, motion, motion_within,
};
use rotation_dynamics::planar::{Condition, Next, Phased, simulate};

pub const FAMILY: Family = Family {
    key: "events",
    title: "Grazes, ties, stops and bounces without end",
    cure: "an event is looked for where its margin comes nearest to zero, located by real steps, and ends one set of equations",
    methods: &["DOP853 with located events"],
    forms: &["time of the event", "state at the end"],
    rows,
};

/// As of DOP853 elsewhere.
const K: f64 = 32.0;
pub const G: f64 = 10.0;

/// What a method found: when, and how far the end is off, both over their sizes.
type Found = [rotation_dynamics::Result<f64>; 2];

pub fn row(
    [case, wrong]: [&'static str; 2],
    conditions: [f64; 2],
    found: Found,
    naive: (&'static str, f64),
) -> Result<Row> {
    let mut cells = Vec::new();
    for ((form, answer), condition) in FAMILY.forms.iter().zip(found).zip(conditions) {
        let name = (case, FAMILY.methods[0], *form);
        cells.push(Cell::of(name, answer, bound(K, condition))?);
    }
    let (method, error) = naive;
    Ok(Row {
        case,
        wrong,
        condition: conditions[0].max(conditions[1]),
        naive: Naive { method, error },
        cells,
    })
}

pub fn tightest() -> rotation_dynamics::Result<Dop853> {
    Dop853::new(1e-15)
}

/// A ball thrown up below a ceiling 5 m high, which returns it with its whole speed.
struct Thrown;
const CEILING: f64 = 5.0;

impl Phased<2> for Thrown {
    type Phase = ();
    fn derivative(&self, (): (), [_, speed]: &[f64; 2]) -> [f64; 2] {
        [*speed, -G]
    }
    fn conditions(&self, (): ()) -> Vec<Condition<'_, (), 2>> {
        let back = Next::jump((), |&[y, speed]: &[f64; 2]| [y, -speed]);
        vec![Condition::gap("ceiling", |y| CEILING - y[0], back)]
    }

    fn scale(&self, y: &[f64; 2]) -> [f64; 2] {
        size_or([1.0; 2])(y)
    }
}

/// Thrown with 10 + `excess` m/s, which is `excess` of height too much.
fn graze(words: [&'static str; 2], excess: f64) -> Result<Row> {
    let end = 1.9;
    let start = 10.0 + excess;
    let excess = start - 10.0;
    // The speed at the ceiling, without a difference of squares.
    let left = (excess.max(0.0) * (20.0 + excess)).sqrt();
    let touches = 2.0 * CEILING / (start + left);
    let rest = end - touches;
    let after = if excess > 0.0 {
        [
            CEILING - left * rest - 0.5 * G * rest * rest,
            -left - G * rest,
        ]
    } else {
        [start * end - 0.5 * G * end * end, start - G * end]
    };
    let run = simulate(&Thrown, &tightest()?, (), [0.0, start], end);
    let off = |[y, speed]: [f64; 2]| (y - after[0]).abs().max((speed - after[1]).abs());
    let time = run
        .as_ref()
        .map_err(Clone::clone)
        .and_then(|run| Ok((run.transition("ceiling")?.t - touches).abs()));
    let state = run.and_then(|run| Ok(off(run.at(end)?.1)));
    // Above the ceiling between two looks, it is not seen; and what is called touching when it
    // is near has touched where it was only near.
    let (method, looks, near) = match excess > 0.0 {
        true => ("looked at every 0.03 s", 63, 0.0),
        false => ("looked at every 0.1 s, a micrometre is touching", 19, 1e-6),
    };
    let dt = end / f64::from(looks);
    let mut y = [0.0, start];
    for _ in 0..looks {
        let next = [y[0] + dt * y[1] - 0.5 * G * dt * dt, y[1] - G * dt];
        y = if next[0] > CEILING - near {
            [CEILING, -next[1]]
        } else {
            next
        };
    }
    // How far a time of contact moves with the speed, and the end with that.
    let moved = if excess > 0.0 {
        start / G * (1.0 + start / left)
    } else {
        start
    };
    let conditions = [moved, start * end + 2.0 * G * moved];
    row(words, conditions, [time, state], (method, off(y)))
}

/// A graze so deep: the state at the end by looks every 0.03 s, and by located events (m).
pub fn across_graze(excess: f64) -> Result<[f64; 2]> {
    let row = graze(["", ""], excess)?;
    let located = row.cells[1].part().unwrap_or(f64::NAN) * row.least_bound();
    Ok([row.naive.error, located])
}

/// Two walls for a ball in a plane: x = 1 and y = 0.
struct Corner;
impl Phased<4> for Corner {
    type Phase = ();
    fn derivative(&self, (): (), [_, _, u, v]: &[f64; 4]) -> [f64; 4] {
        [*u, *v, 0.0, -G]
    }
    fn conditions(&self, (): ()) -> Vec<Condition<'_, (), 4>> {
        let wall = Next::jump((), |&[_, y, u, v]: &[f64; 4]| [1.0, y, -u, v]);
        let floor = Next::jump((), |&[x, _, u, v]: &[f64; 4]| [x, 0.0, u, -v]);
        vec![
            Condition::gap("wall", |y| 1.0 - y[0], wall),
            Condition::gap("floor", |y| y[1], floor),
        ]
    }

    fn scale(&self, y: &[f64; 4]) -> [f64; 4] {
        size_or([1.0; 4])(y)
    }
}

/// The floor at 1 s, the wall so much later; steps of at most `longest`, to `end`.
fn corner(words: [&'static str; 2], later: f64, longest: f64, end: f64) -> Result<Row> {
    let speed = 1.0 / (1.0 + later);
    let wall = 1.0 / speed;
    let method = tightest()?.with_longest_step(longest)?;
    let run = simulate(&Corner, &method, (), [0.0, 5.0, speed, 0.0], end);
    let after = end - 1.0;
    let x = if end > wall {
        2.0 - speed * end
    } else {
        speed * end
    };
    let y = G * after - 0.5 * G * after * after;
    let time = run.as_ref().map_err(Clone::clone).and_then(|run| {
        let (wall_at, floor_at) = (run.transition("wall")?.t, run.transition("floor")?.t);
        Ok((wall_at - wall).abs().max((floor_at - 1.0).abs()))
    });
    let off = |x_end: f64, y_end: f64| (x_end - x).abs().max((y_end - y).abs());
    let state = run.and_then(|run| {
        let [x, y, ..] = run.at(end)?.1;
        Ok(off(x, y))
    });
    // One event a step, the first in the list; the other is not looked at again.
    let looks = 1500;
    let dt = end / f64::from(looks);
    let [mut a, mut b, mut u, mut v] = [0.0, 5.0, speed, 0.0];
    for _ in 0..looks {
        (a, b, v) = (a + dt * u, b + dt * v - 0.5 * G * dt * dt, v - G * dt);
        if a > 1.0 {
            (a, u) = (1.0, -u);
        } else if b < 0.0 {
            (b, v) = (0.0, -v);
        }
    }
    let naive = ("one event at the end of each 0.001 s", off(a, b));
    row(words, [2.0, 2.0 * G * end], [time, state], naive)
}

/// From 1e-8 rad off the wall: half of the way in time nothing seems to happen.
fn ladder() -> Result<Row> {
    let angle = 1e-8;
    let exact = Exact::new(LENGTH, G, angle)?;
    let smooth = Ladder {
        gravity: G,
        overhang: 0.0,
        mu: 0.0,
    };
    let (release, end) = (exact.release_time(), exact.release_time() + 0.2);
    let found = motion_within(&smooth, 1e-12, smooth.at_rest(angle), end);
    let time = found
        .as_ref()
        .map_err(Clone::clone)
        .and_then(|found| Ok((found.event("wall lets go")?.t - release).abs()));
    let truth = exact.at(end)?.theta;
    let state = found.and_then(|found| Ok((found.at(end)?.q[2] - truth).abs()));
    // By the energy, from where it stands: the root of nothing is nothing.
    let mut theta: f64 = angle;
    for _ in 0..10_000 {
        let (s, _) = sincos(0.5 * (theta + angle));
        let (d, _) = sincos(0.5 * (theta - angle));
        theta += end / 1e4 * (6.0 * G / LENGTH * s * d).max(0.0).sqrt();
    }
    // A relative change of the state at any of the times before moves the time by 1/W.
    let rate = (1.5 * G / LENGTH).sqrt();
    let moved = release * rate * 8.0;
    let naive = (
        "theta' from the energy, 10 000 steps",
        (theta - truth).abs(),
    );
    row(
        [
            "a ladder from 1e-8 rad",
            "the root of an energy that is not there yet",
        ],
        [moved, moved * rate],
        [time, state],
        naive,
    )
}

/// A block of 1 kg on a belt, held by a spring of 1 N/m: it sticks up to 1 N, slips at 0.6 N.
struct Belt;
const BELT: f64 = 0.5;
const HOLDS: f64 = 1.0;
const RUBS: f64 = 0.6;

impl Phased<2> for Belt {
    /// Whether it sticks.
    type Phase = bool;
    fn derivative(&self, sticks: bool, &[x, speed]: &[f64; 2]) -> [f64; 2] {
        if sticks {
            [BELT, 0.0]
        } else {
            [speed, RUBS - x]
        }
    }
    fn conditions(&self, sticks: bool) -> Vec<Condition<'_, bool, 2>> {
        let sticking = Next::jump(true, |&[x, _]: &[f64; 2]| [x, BELT]);
        vec![if sticks {
            Condition::gap("slips", |y| HOLDS - y[0], Next::Enter(false))
        } else {
            Condition::opening_gap("sticks", |y| BELT - y[1], sticking)
        }]
    }

    fn scale(&self, y: &[f64; 2]) -> [f64; 2] {
        size_or([1.0; 2])(y)
    }
}

const CYCLES: u32 = 10_000;

/// Runs of 400 cycles, one after the other.
fn stick_slip() -> Result<Row> {
    let over = HOLDS - RUBS;
    let slips = core::f64::consts::TAU - 2.0 * atan2(over, BELT);
    let period = slips + 2.0 * over / BELT;
    let end = f64::from(CYCLES) * period;
    let found = || -> rotation_dynamics::Result<[f64; 2]> {
        let (mut t, mut state, mut left) = (0.0, [HOLDS, BELT], CYCLES);
        while left > 0 {
            let run = simulate(&Belt, &tightest()?, false, state, 400.5 * period)?;
            let slipping = run.transitions().iter().filter(|at| at.name == "slips");
            let count = left.min(400);
            let last = slipping
                .take(count as usize)
                .last()
                .ok_or(Error::NotReached {
                    name: "slips",
                    until: run.end_time(),
                })?;
            (t, state, left) = (t + last.t, last.after, left - count);
        }
        Ok([(t - end).abs(), (state[0] - HOLDS).abs()])
    };
    // The sign of the slip as it is at each step of a hundredth.
    let (mut x, mut v, mut seen, mut sticks, dt) = (HOLDS, BELT, 0, false, 0.01);
    let mut steps = 0_u32;
    while seen < CYCLES && steps < 20_000_000 {
        steps += 1;
        if sticks {
            x += BELT * dt;
            if x >= HOLDS {
                (sticks, seen) = (false, seen + 1);
            }
        } else {
            v += (RUBS - x) * dt;
            x += v * dt;
            if v >= BELT && x < RUBS {
                (sticks, v) = (true, BELT);
            }
        }
    }
    let naive = (
        "looked at every 0.01 s",
        (f64::from(steps) * dt - end).abs(),
    );
    let [time, state] = match found() {
        Ok([time, state]) => [Ok(time), Ok(state)],
        Err(error) => [Err(error.clone()), Err(error)],
    };
    row(
        [
            "10 000 cycles of stick and slip",
            "each event is late by part of a step, always late",
        ],
        // Where a block on the belt is, a time of a run of 400 knows to eps of that run.
        [end, 2.0 * HOLDS + BELT * 400.0 * period],
        [time, state],
        naive,
    )
}

/// A block of 1 kg that slides on a floor, mu = 0.5, to its stop, and stays.
struct Block;
impl Mechanism<3, 1> for Block {
    fn mass(&self, _: &[f64; 3]) -> [[f64; 3]; 3] {
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
    }
    fn force(&self, _: &MechanismState<3>) -> [f64; 3] {
        [0.0, -G, 0.0]
    }
    fn contacts(&self, block: &MechanismState<3>) -> [Contact<3>; 1] {
        let [_, height, _] = block.q;
        let floor = Contact::new("floor", height, [0.0, 1.0, 0.0], 0.0);
        [floor.tangent([1.0, 0.0, 0.0], 0.0).friction(0.5)]
    }
}

/// 3 m/s against 5 m/s^2: 0.6 s and 0.9 m, then nothing for a thousand seconds, one event.
fn stop() -> Result<Row> {
    let (start, end) = (
        MechanismState {
            q: [0.0; 3],
            v: [3.0, 0.0, 0.0],
        },
        1000.0,
    );
    let found = motion(&Block, &tightest()?, start, end);
    let time = found.as_ref().map_err(Clone::clone).and_then(|found| {
        let [one] = found.events() else {
            return Err(Error::NotReached {
                name: "one stop",
                until: found.end_time(),
            });
        };
        Ok((one.t - 0.6).abs())
    });
    let state = found.and_then(|found| {
        let at = found.at(end)?;
        Ok((at.q[0] - 0.9).abs().max(at.v[0].abs()))
    });
    // The speed goes to and fro about nothing, and the block walks.
    let (mut x, mut v, dt) = (0.0, 3.0_f64, 0.001_f64);
    for _ in 0..1_000_000 {
        let slower = v - 5.0 * dt.copysign(v);
        (x, v) = (x + 0.5 * dt * (v + slower), slower);
    }
    row(
        [
            "a Coulomb stop, and 1000 s of rest",
            "the sign of a speed that is nearly 0 is noise",
        ],
        [3.0, 3.0],
        [time, state],
        (
            "-mu N sign(v), steps of 0.001 s",
            (x - 0.9).abs().max(v.abs()),
        ),
    )
}

/// A ball that returns half of its speed: at rest after 3 s and infinitely many bounces.
struct Ball;
impl Mechanism<1, 1> for Ball {
    fn mass(&self, _: &[f64; 1]) -> [[f64; 1]; 1] {
        [[1.0]]
    }
    fn force(&self, _: &MechanismState<1>) -> [f64; 1] {
        [-G]
    }
    fn contacts(&self, ball: &MechanismState<1>) -> [Contact<1>; 1] {
        [Contact::new("floor", ball.q[0], [1.0], 0.0).restitution(0.5)]
    }
}

/// Bounce n is at 3 - 4/2^n s: the twentieth, and the rest after all of them.
fn zeno() -> Result<Row> {
    let bounce = 3.0 - 4.0 / 1_048_576.0;
    let found = motion(&Ball, &tightest()?, MechanismState::rest([5.0]), 4.0);
    let time = found.as_ref().map_err(Clone::clone).and_then(|found| {
        let (name, until) = ("twenty bounces", found.end_time());
        let all = found.events();
        let twentieth = all.get(19).ok_or(Error::NotReached { name, until })?;
        let rest = found.event("floor rests")?;
        Ok((twentieth.t - bounce).abs().max((rest.t - 3.0).abs()))
    });
    let state = found.and_then(|found| {
        let MechanismState { q: [y], v: [v] } = found.at(4.0)?;
        Ok(y.abs().max(v.abs()))
    });
    let (mut y, mut v, mut bounces, mut steps, dt) = (5.0, 0.0, 0, 0_u32, 0.001);
    while bounces < 20 {
        steps += 1;
        (y, v) = (y + dt * v - 0.5 * G * dt * dt, v - G * dt);
        if y < 0.0 {
            (y, v, bounces) = (0.0, -0.5 * v, bounces + 1);
        }
    }
    row(
        [
            "bounces without end",
            "infinitely many events in three seconds",
        ],
        [6.0, 6.0],
        [time, state],
        (
            "looked at every 0.001 s: bounce 20",
            (f64::from(steps) * dt - bounce).abs(),
        ),
    )
}

fn rows() -> Result<Vec<Row>> {
    let seen = "both ends of a step are on the same side";
    let mut rows = vec![
        graze(["a graze 1e-2 deep", seen], 1e-2)?,
        graze(["a graze 1e-6 deep", seen], 1e-6)?,
        graze(["a graze 1e-8 deep", seen], 1e-8)?,
        graze(
            ["a miss by 1e-8", "what is nearly touched is not touched"],
            -1e-8,
        )?,
        corner(
            ["two events 1e-9 s apart", "they are within one step"],
            1e-9,
            10.0,
            1.5,
        )?,
        corner(
            [
                "two events at once",
                "one is found, the other is already past",
            ],
            0.0,
            10.0,
            1.5,
        )?,
        corner(
            [
                "two events at a step's end",
                "the sign changes between two steps",
            ],
            0.0,
            0.25,
            1.5,
        )?,
        ladder()?,
        stick_slip()?,
        stop()?,
        zeno()?,
    ];
    rows.extend(contacts::rows()?);
    Ok(rows)
}
