//! Contacts that graze, come two at a time or at a step's end, stick, stop, and never stop
//! bouncing; and impacts of two bodies on a line, one of them up to 1e12 times the other.

use super::*;
use models::by_closures::{Bodies, Flow};
use rotation_dynamics::accuracy::largest;
use rotation_dynamics::planar::contact::{Contact, MechanismState, motion};
use rotation_dynamics::planar::{Condition, Next, simulate};

const G: f64 = 10.0;
const LOCATED: By = By("DOP853 with located events", 32.0, How::Own);
const CONTACTS: By = By("contact solver", 8.0, How::Own);

/// A case of a method: a run, two errors that are asked of it, usually that of the time of an
/// event and that of the state at the end, with their conditions; and the naive method.
fn asked<R>(
    by: By,
    conditions: [f64; 2],
    run: Solved<R>,
    first: impl Fn(&R) -> Solved<f64>,
    second: impl Fn(&R) -> Solved<f64>,
    naive: Naive,
) -> Result<Answered> {
    let run = run.as_ref().map_err(Clone::clone);
    let answers = [run.clone().and_then(first), run.and_then(second)];
    let cells = conditions.into_iter().zip(answers).map(|(felt, answer)| by.cell(felt, answer));
    let condition = conditions[0].max(conditions[1]);
    Ok(Answered { condition, naive, cells: cells.collect() })
}

/// The largest of some differences; NaN if one is.
fn off<const N: usize>(found: [f64; N], truth: [f64; N]) -> f64 {
    largest((0..N).map(|i| (found[i] - truth[i]).abs()))
}

fn tightest() -> Solved<Dop853> {
    Dop853::new(1e-15)
}

/// A ball in a plane that is looked at dt later.
fn later([x, y, u, v]: [f64; 4], dt: f64) -> [f64; 4] {
    [x + dt * u, y + dt * v - 0.5 * G * dt * dt, u, v - G * dt]
}

/// The same that is looked at so often until `end`, and then does what its walls say.
fn looked(ball: [f64; 4], end: f64, looks: u32, walls: impl Fn([f64; 4]) -> [f64; 4]) -> [f64; 4] {
    (0..looks).fold(ball, |ball, _| walls(later(ball, end / f64::from(looks))))
}

/// A ball thrown up below a ceiling 5 m high, which returns it with its whole speed.
const THROWN: Flow<2, ()> = Flow(
    |(), [_, speed]| [*speed, -G],
    |()| {
        let back = Next::jump((), |&[y, speed]: &[f64; 2]| [y, -speed]);
        vec![Condition::gap("ceiling", |y| CEILING - y[0], back)]
    },
    [1.0; 2],
);
const CEILING: f64 = 5.0;

/// Thrown with 10 + `excess` m/s, which is `excess` of height too much.
pub fn graze(excess: f64) -> Result<Answered> {
    let (start, end) = (10.0 + excess, 1.9);
    let excess = start - 10.0;
    // The speed at the ceiling, without a difference of squares.
    let left = (excess.max(0.0) * (20.0 + excess)).sqrt();
    let touches = 2.0 * CEILING / (start + left);
    let rest = end - touches;
    // The state at the end; how far a time of contact moves with the speed, and the end with that;
    // and the looks. Above the ceiling between two looks, it is not seen; and what is called
    // touching when it is near has touched where it was only near.
    let (after, moved, (method, looks, near)) = if excess > 0.0 {
        let height = CEILING - left * rest - 0.5 * G * rest * rest;
        let moved = start / G * (1.0 + start / left);
        ([height, -left - G * rest], moved, ("looked at every 0.03 s", 63, 0.0))
    } else {
        let looked = ("looked at every 0.1 s, a micrometre is touching", 19, 1e-6);
        ([start * end - 0.5 * G * end * end, start - G * end], start, looked)
    };
    let naive = looked([0.0, 0.0, 0.0, start], end, looks, |[x, y, u, v]| {
        if y > CEILING - near { [x, CEILING, u, -v] } else { [x, y, u, v] }
    });
    asked(
        LOCATED,
        [moved, start * end + 2.0 * G * moved],
        simulate(&THROWN, &tightest()?, (), [0.0, start], end),
        |run| Ok((run.transition("ceiling")?.t - touches).abs()),
        |run| Ok(off(run.at(end)?.1, after)),
        (method, off([naive[1], naive[3]], after)),
    )
}

/// Two walls for a ball in a plane: x = 1 and y = 0.
const CORNER: Flow<4, ()> = Flow(
    |(), [_, _, u, v]| [*u, *v, 0.0, -G],
    |()| {
        let wall = Next::jump((), |&[_, y, u, v]: &[f64; 4]| [1.0, y, -u, v]);
        let floor = Next::jump((), |&[x, _, u, v]: &[f64; 4]| [x, 0.0, u, -v]);
        let wall = Condition::gap("wall", |y| 1.0 - y[0], wall);
        vec![wall, Condition::gap("floor", |y| y[1], floor)]
    },
    [1.0; 4],
);

/// The floor at 1 s, the wall so much later; steps of at most `longest`.
fn corner(later_by: f64, longest: f64) -> Result<Answered> {
    let (end, speed) = (1.5, 1.0 / (1.0 + later_by));
    let truth = [2.0 - speed * end, G * 0.5 - 0.5 * G * 0.5 * 0.5];
    // One event a step, the first in the list; the other is not looked at again.
    let start = [0.0, 5.0, speed, 0.0];
    let naive = looked(start, end, 1500, |ball| match ball {
        [x, y, u, v] if x > 1.0 => [1.0, y, -u, v],
        [x, y, u, v] if y < 0.0 => [x, 0.0, u, -v],
        _ => ball,
    });
    let method = tightest()?.with_longest_step(longest)?;
    asked(
        LOCATED,
        [2.0, 2.0 * G * end],
        simulate(&CORNER, &method, (), start, end),
        |run| {
            let found = [run.transition("wall")?.t, run.transition("floor")?.t];
            Ok(off(found, [1.0 / speed, 1.0]))
        },
        |run| Ok(off([run.at(end)?.1[0], run.at(end)?.1[1]], truth)),
        ("one event at the end of each 0.001 s", off([naive[0], naive[1]], truth)),
    )
}

/// A block of 1 kg on a belt, held by a spring of 1 N/m: it sticks up to 1 N, slips at 0.6 N. Its
/// phase is whether it sticks.
const BLOCK_ON_BELT: Flow<2, bool> = Flow(
    |sticks, &[x, speed]| match sticks {
        true => [BELT, 0.0],
        false => [speed, RUBS - x],
    },
    |sticks| {
        let sticking = Next::jump(true, |&[x, _]: &[f64; 2]| [x, BELT]);
        vec![match sticks {
            true => Condition::gap("slips", |y| HOLDS - y[0], Next::Enter(false)),
            false => Condition::opening_gap("sticks", |y| BELT - y[1], sticking),
        }]
    },
    [1.0; 2],
);
const BELT: f64 = 0.5;
const HOLDS: f64 = 1.0;
const RUBS: f64 = 0.6;
const CYCLES: u32 = 10_000;

/// The time and the state after all cycles, in runs of 400, one after the other.
fn all_cycles(period: f64) -> Solved<(f64, [f64; 2])> {
    let (mut t, mut state) = (0.0, [HOLDS, BELT]);
    for _ in 0..CYCLES / 400 {
        let run = simulate(&BLOCK_ON_BELT, &tightest()?, false, state, 400.5 * period)?;
        let last = run.transitions().iter().filter(|at| at.name == "slips").nth(399);
        (t, state) = last.map_or((f64::NAN, state), |last| (t + last.t, last.after));
    }
    Ok((t, state))
}

/// A disc that settles in the air under it: its inclination falls as -k/theta^2, while its
/// contact runs round at 2/sqrt(theta) (Moffatt; in units of sqrt(R/g)). Its phase is the
/// inclination at which it ends.
const DISC: Flow<2, f64> = Flow(
    |_, [tilt, _]| [-AIR / (tilt * tilt), 2.0 / tilt.sqrt()],
    |to| vec![Condition::gap("settled", move |y| y[0] - to, Next::End)],
    [0.0, 1.0],
);
const AIR: f64 = 1e-4;
const START: [f64; 2] = [0.1, 0.0];

/// To an inclination in a run to `end`; Heun's method goes to another end in so many steps, and
/// its i-th number counts.
fn settled(
    to: f64,
    [end, heun_end]: [f64; 2],
    (method, steps, i): (&'static str, u32, usize),
) -> Result<Answered> {
    // 4/5k of the loss of theta^(5/2) has the contact turned until then.
    let turned = |to: f64| 0.8 / AIR * (pow(START[0], 2.5) - pow(to, 2.5));
    let h = heun_end / f64::from(steps);
    let heun = (0..steps).fold(START, |y, _| {
        let a = DISC.0(to, &y);
        let b = DISC.0(to, &[0, 1].map(|i| y[i] + h * a[i]));
        [0, 1].map(|i| y[i] + 0.5 * h * (a[i] + b[i]))
    });
    asked(
        LOCATED,
        [9.0 * settles(0.0), 7.5 * turned(0.0)],
        simulate(&DISC, &tightest()?, to, START, end),
        |run| Ok((run.transition("settled")?.t - settles(to)).abs()),
        |run| Ok((run.transition("settled")?.before[1] - turned(to)).abs()),
        (method, (heun[i] - [to, turned(to)][i]).abs()),
    )
}

/// The time to an inclination: theta^3 falls steadily, so it is (theta_0^3 - theta^3)/3k.
fn settles(to: f64) -> f64 {
    let cube = |x: f64| x * x * x;
    cube(START[0]) / (3.0 * AIR) - cube(to) / (3.0 * AIR)
}

family! { EVENTS, "events": "Grazes, ties, stops and bounces without end",
    |_| [LOCATED], in ["time of the event", "state at the end"];
    "a graze 1e-2 deep", "both ends of a step are on the same side": graze(1e-2);
    "a graze 1e-6 deep", "both ends of a step are on the same side": graze(1e-6);
    "a graze 1e-8 deep", "both ends of a step are on the same side": graze(1e-8);
    "a miss by 1e-8", "what is nearly touched is not touched": graze(-1e-8);
    "two events 1e-9 s apart", "they are within one step": corner(1e-9, 10.0);
    "two events at once", "one is found, the other is already past": corner(0.0, 10.0);
    "two events at a step's end", "the sign changes between two steps": corner(0.0, 0.25);
    "10 000 cycles of stick and slip", "each event is late by part of a step, always late": {
        let over = HOLDS - RUBS;
        let period = TAU - 2.0 * atan2(over, BELT) + 2.0 * over / BELT;
        let end = f64::from(CYCLES) * period;
        // The sign of the slip as it is at each step of a hundredth.
        let (mut x, mut v, mut seen, mut sticks, mut steps, dt) = (HOLDS, BELT, 0, false, 0_u32, 0.01);
        while seen < CYCLES && steps < 20_000_000 {
            steps += 1;
            if sticks {
                x += BELT * dt;
                if x >= HOLDS { (sticks, seen) = (false, seen + 1); }
            } else {
                v += (RUBS - x) * dt;
                x += v * dt;
                if v >= BELT && x < RUBS { (sticks, v) = (true, BELT); }
            }
        }
        // Where a block on the belt is, a time of a run of 400 knows to eps of that run.
        asked(LOCATED, [end, 2.0 * HOLDS + BELT * 400.0 * period], all_cycles(period), |(t, _)| Ok((t - end).abs()),
            |(_, state)| Ok((state[0] - HOLDS).abs()), ("looked at every 0.01 s", (f64::from(steps) * dt - end).abs()))
    };
    // A block of 1 kg slides on a floor, mu = 0.5: 3 m/s against 5 m/s^2, so 0.6 s and 0.9 m, one event.
    "a Coulomb stop, and 1000 s of rest", "the sign of a speed that is nearly 0 is noise": {
        let block = Bodies([1.0; 3], [0.0, -G, 0.0], |block| {
            [Contact::new("floor", block.q[1], [0.0, 1.0, 0.0], 0.0).tangent([1.0, 0.0, 0.0], 0.0).friction(0.5)]
        });
        // The speed goes to and fro about nothing, and the block walks.
        let (mut x, mut v, dt) = (0.0, 3.0_f64, 0.001_f64);
        for _ in 0..1_000_000 {
            let slower = v - 5.0 * dt.copysign(v);
            (x, v) = (x + 0.5 * dt * (v + slower), slower);
        }
        asked(LOCATED, [3.0, 3.0], motion(&block, &tightest()?, MechanismState { q: [0.0; 3], v: [3.0, 0.0, 0.0] }, 1000.0),
            |found| Ok(if let [stop] = found.events() { (stop.t - 0.6).abs() } else { f64::NAN }),
            |found| Ok(off([found.at(1000.0)?.q[0], found.at(1000.0)?.v[0]], [0.9, 0.0])),
            ("-mu N sign(v), steps of 0.001 s", off([x, v], [0.9, 0.0])))
    };
    // A ball that returns half of its speed: bounce n is at 3 - 4/2^n s, and it is at rest after all of them.
    "bounces without end", "infinitely many events in three seconds": {
        let ball = Bodies([1.0], [-G], |ball| [Contact::new("floor", ball.q[0], [1.0], 0.0).restitution(0.5)]);
        let bounce = 3.0 - 4.0 / 1_048_576.0;
        let (mut naive, mut bounces, mut steps) = ([0.0, 5.0, 0.0, 0.0], 0, 0_u32);
        while bounces < 20 {
            steps += 1;
            naive = later(naive, 0.001);
            if naive[1] < 0.0 {
                (naive, bounces) = ([0.0, 0.0, 0.0, -0.5 * naive[3]], bounces + 1);
            }
        }
        let late = (f64::from(steps) * 0.001 - bounce).abs();
        asked(LOCATED, [6.0, 6.0], motion(&ball, &tightest()?, MechanismState::rest([5.0]), 4.0),
            |found| {
                let twentieth = found.events().get(19).map_or(f64::NAN, |bounce| bounce.t);
                Ok(off([twentieth, found.event("floor rests")?.t], [bounce, 3.0]))
            },
            |found| Ok(off([found.at(4.0)?.q[0], found.at(4.0)?.v[0]], [0.0; 2])),
            ("looked at every 0.001 s: bounce 20", late))
    };
    // Two blocks of 1 kg slide up an incline, g sin(alpha) = 6 m/s^2, on a string of 1 m; the lower one, which rubs with
    // 8 N, is pulled. Both slow down by 6 + 8/2 = 10 m/s^2. Where they come to rest the lower one sticks and the upper
    // one turns back at 6 m/s^2, so the string lets go in the same instant.
    "a release and a stop at once", "what sticks is settled first, and the string is kept as it was": {
        let towed = Bodies([1.0; 2], [-6.0; 2], |blocks| {
            let string = Contact::new("string", 1.0 - (blocks.q[1] - blocks.q[0]), [1.0, -1.0], 0.0);
            [string, Contact::pressed("block", 8.0).tangent([1.0, 0.0], 0.0).friction(1.0)]
        });
        let (stop, place, end) = (0.5_f64, 1.25, 0.9);
        let back = 3.0 * (end - stop) * (end - stop);
        asked(LOCATED, [2.0 * stop, 1.0 + 2.0 * place + 4.0 * back],
            motion(&towed, &tightest()?, MechanismState { q: [0.0, 1.0], v: [5.0; 2] }, end),
            |found| Ok((found.event("block sticks")?.t - stop).abs()),
            |found| Ok(off(found.at(end)?.q, [place, 1.0 + place - back])), ("one contact an event", back))
    };
    "a disc that settles, to its film of air", "it falls a hundred thousand times faster than it began":
        settled(1e-3, [2.0 * settles(0.0), settles(1e-3)], ("1000 steps of Heun: inclination", 1000, 0));
    // Without a film it is flat at a time of its own, turning infinitely fast, and after that there is nothing.
    "a disc that settles, and beyond", "its rate is infinite in a finite time":
        settled(0.0, [1.5 * settles(0.0); 2], ("1500 steps of Heun: turned", 1500, 1));
}

/// Of the mass that hits (m/s): at 1 m/s the energies of a heavy mass are whole numbers, and
/// their difference is exact by luck.
const SPEED: f64 = 1.7;

/// A mass that hits another of 1 kg, which is at rest 1 m on: both speeds, each relative to itself.
fn hit(m: f64, e: f64) -> Result<Answered> {
    let truth = [(m - e) / (m + 1.0), m * (1.0 + e) / (m + 1.0)].map(|part| part * SPEED);
    let pair = Bodies([m, 1.0], [0.0; 2], |pair| {
        [Contact::new("they meet", pair.q[1] - pair.q[0], [-1.0, 1.0], 0.0).restitution(e)]
    });
    let found = motion(&pair, &tightest()?, MechanismState { q: [0.0, 1.0], v: [SPEED, 0.0] }, 2.0);
    let after = found.map(|found| found.events().first().map_or([f64::NAN; 2], |hit| hit.after.v));
    // The speed of the one that is hit, from what the energy lacks.
    let first = SPEED * (m - e) / (m + 1.0);
    let lost = 0.5 * (1.0 - e * e) * m / (1.0 + m) * SPEED * SPEED;
    let left = 0.5 * m * SPEED * SPEED - lost - 0.5 * m * first * first;
    let error = ((2.0 * left.max(0.0)).sqrt() / truth[1] - 1.0).abs();
    asked(
        CONTACTS,
        // A product and a sum of the inputs.
        [4.0; 2],
        after,
        |speeds| Ok((speeds[0] / truth[0] - 1.0).abs()),
        |speeds| Ok((speeds[1] / truth[1] - 1.0).abs()),
        ("the second speed from what is left of the energy", error),
    )
}

family! { IMPACTS, "impacts": "Impacts of a trillion to one",
    |_| [CONTACTS], in ["speed of the one that hits", "speed of the one that is hit"];
    "1e-12 hits 1, elastic", "what the heavy one gets is lost in the energy of the light one": hit(1e-12, 1.0);
    "1e-8 hits 1, elastic", "what the heavy one gets is lost in the energy of the light one": hit(1e-8, 1.0);
    "1e-6 hits 1, half elastic", "what the heavy one gets is lost in the energy of the light one": hit(1e-6, 0.5);
    "1e6 hits 1, half elastic", "what the light one gets is lost in the energy of the heavy one": hit(1e6, 0.5);
    "1e8 hits 1, elastic", "what the light one gets is lost in the energy of the heavy one": hit(1e8, 1.0);
    "1e12 hits 1, elastic", "what the light one gets is lost in the energy of the heavy one": hit(1e12, 1.0);
    "1e12 hits 1, plastic", "what the light one gets is lost in the energy of the heavy one": hit(1e12, 0.0);
}
