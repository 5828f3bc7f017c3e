//! Contacts that graze, come two at a time or at a step's end, stick, stop, and never stop
//! bouncing.

use super::contacts::{apart, beyond, overhang, to_film, towed};
use super::ladder::{LENGTH, Ladder};
use super::*;
use rotation_dynamics::exact::ladder::Ladder as Exact;
use rotation_dynamics::integrators::size_or;
use rotation_dynamics::planar::contact::{
    Contact, Mechanism, MechanismState, motion, motion_within,
};
use rotation_dynamics::planar::{Condition, Next, Phased, simulate};

pub const G: f64 = 10.0;

/// A case of the family: the conditions of the time and of the state, the run, how far off the
/// time of its event is and how far the state at its end, and the naive method.
pub fn asked<R>(
    conditions: [f64; 2],
    run: Solved<R>,
    time: impl Fn(&R) -> Solved<f64>,
    state: impl Fn(&R) -> Solved<f64>,
    naive: Naive,
) -> Result<Answered> {
    let run = run.as_ref().map_err(Clone::clone);
    let answers = [run.clone().and_then(time), run.and_then(state)].into_iter();
    let bounds = conditions.map(|condition| By::Events.bound(condition));
    let condition = conditions[0].max(conditions[1]);
    Ok(Answered(condition, naive, answers.zip(bounds).collect()))
}

/// The largest of some differences.
pub fn off<const N: usize>(found: [f64; N], truth: [f64; N]) -> f64 {
    let off = found.into_iter().zip(truth);
    let off = off.map(|(found, truth): (f64, f64)| (found - truth).abs());
    off.fold(f64::NAN, f64::max)
}

pub fn tightest() -> Solved<Dop853> {
    Dop853::new(1e-15)
}

/// What is missing in a run until this time.
pub const fn missing(name: &'static str, until: f64) -> Error {
    Error::NotReached { name, until }
}

/// What moves: its derivative in each phase, and what ends the phase.
struct Flow<const N: usize, P>(
    fn(P, &[f64; N]) -> [f64; N],
    fn(P) -> Vec<Condition<'static, P, N>>,
);

impl<const N: usize, P: Copy + PartialEq + core::fmt::Debug> Phased<N> for Flow<N, P> {
    type Phase = P;
    fn derivative(&self, phase: P, state: &[f64; N]) -> [f64; N] {
        self.0(phase, state)
    }
    fn conditions(&self, phase: P) -> Vec<Condition<'_, P, N>> {
        self.1(phase)
    }
    fn scale(&self, state: &[f64; N]) -> [f64; N] {
        size_or([1.0; N])(state)
    }
}

/// Bodies of these masses, with forces and contacts.
pub struct Bodies<const N: usize, const C: usize, K: Fn(&MechanismState<N>) -> [Contact<N>; C]>(
    pub [f64; N],
    pub fn(&MechanismState<N>) -> [f64; N],
    pub K,
);

impl<const N: usize, const C: usize, K> Mechanism<N, C> for Bodies<N, C, K>
where
    K: Fn(&MechanismState<N>) -> [Contact<N>; C],
{
    fn mass(&self, _: &[f64; N]) -> [[f64; N]; N] {
        let row = |i| core::array::from_fn(|j| if i == j { self.0[i] } else { 0.0 });
        core::array::from_fn(row)
    }
    fn force(&self, state: &MechanismState<N>) -> [f64; N] {
        self.1(state)
    }
    fn contacts(&self, state: &MechanismState<N>) -> [Contact<N>; C] {
        self.2(state)
    }
}

pub const fn moving<const N: usize>(q: [f64; N], v: [f64; N]) -> MechanismState<N> {
    MechanismState { q, v }
}

/// A ball thrown up below a ceiling 5 m high, which returns it with its whole speed.
const THROWN: Flow<2, ()> = Flow(
    |(), [_, speed]| [*speed, -G],
    |()| {
        let back = Next::jump((), |&[y, speed]: &[f64; 2]| [y, -speed]);
        vec![Condition::gap("ceiling", |y| CEILING - y[0], back)]
    },
);
const CEILING: f64 = 5.0;

/// Thrown with 10 + `excess` m/s, which is `excess` of height too much.
pub fn graze(excess: f64) -> Result<Answered> {
    let end = 1.9;
    let start = 10.0 + excess;
    let excess = start - 10.0;
    // The speed at the ceiling, without a difference of squares.
    let left = (excess.max(0.0) * (20.0 + excess)).sqrt();
    let touches = 2.0 * CEILING / (start + left);
    let rest = end - touches;
    let bounced = CEILING - left * rest - 0.5 * G * rest * rest;
    let after = match excess > 0.0 {
        true => [bounced, -left - G * rest],
        false => [start * end - 0.5 * G * end * end, start - G * end],
    };
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
        y = match next[0] > CEILING - near {
            true => [CEILING, -next[1]],
            false => next,
        };
    }
    // How far a time of contact moves with the speed, and the end with that.
    let moved = match excess > 0.0 {
        true => start / G * (1.0 + start / left),
        false => start,
    };
    asked(
        [moved, start * end + 2.0 * G * moved],
        simulate(&THROWN, &tightest()?, (), [0.0, start], end),
        |run| Ok((run.transition("ceiling")?.t - touches).abs()),
        |run| Ok(off(run.at(end)?.1, after)),
        (method, off(y, after)),
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
);

/// The floor at 1 s, the wall so much later; steps of at most `longest`.
fn corner(later: f64, longest: f64) -> Result<Answered> {
    let end = 1.5;
    let speed = 1.0 / (1.0 + later);
    let after = end - 1.0;
    let truth = [2.0 - speed * end, G * after - 0.5 * G * after * after];
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
    let method = tightest()?.with_longest_step(longest)?;
    asked(
        [2.0, 2.0 * G * end],
        simulate(&CORNER, &method, (), [0.0, 5.0, speed, 0.0], end),
        |run| {
            let found = [run.transition("wall")?.t, run.transition("floor")?.t];
            Ok(off(found, [1.0 / speed, 1.0]))
        },
        |run| {
            let [x, y, ..] = run.at(end)?.1;
            Ok(off([x, y], truth))
        },
        ("one event at the end of each 0.001 s", off([a, b], truth)),
    )
}

/// From 1e-8 rad off the wall: half of the way in time nothing seems to happen.
fn ladder() -> Result<Answered> {
    let angle = 1e-8;
    let exact = Exact::new(LENGTH, G, angle)?;
    let smooth = Ladder { gravity: G, overhang: 0.0, mu: 0.0 };
    let (release, end) = (exact.release_time(), exact.release_time() + 0.2);
    let truth = exact.at(end)?.theta;
    // By the energy, from where it stands: the root of nothing is nothing.
    let mut theta: f64 = angle;
    for _ in 0..10_000 {
        let (s, _) = sincos(0.5 * (theta + angle));
        let (d, _) = sincos(0.5 * (theta - angle));
        theta += end / 1e4 * (6.0 * G / LENGTH * s * d).max(0.0).sqrt();
    }
    // A relative change of the state at any of the times before moves the time by 1/W.
    let rate = (1.5 * G / LENGTH).sqrt();
    let (moved, error) = (release * rate * 8.0, (theta - truth).abs());
    asked(
        [moved, moved * rate],
        motion_within(&smooth, 1e-12, smooth.at_rest(angle), end),
        |found| Ok((found.event("wall lets go")?.t - release).abs()),
        |found| Ok((found.at(end)?.q[2] - truth).abs()),
        ("theta' from the energy, 10 000 steps", error),
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
);
const BELT: f64 = 0.5;
const HOLDS: f64 = 1.0;
const RUBS: f64 = 0.6;

const CYCLES: u32 = 10_000;

/// The time and the state after all cycles, in runs of 400, one after the other.
fn all_cycles(period: f64) -> Solved<(f64, [f64; 2])> {
    let (mut t, mut state, mut left) = (0.0, [HOLDS, BELT], CYCLES);
    while left > 0 {
        let run = simulate(&BLOCK_ON_BELT, &tightest()?, false, state, 400.5 * period)?;
        let slipping = run.transitions().iter().filter(|at| at.name == "slips");
        let count = left.min(400);
        let last = slipping.take(count as usize).last();
        let last = last.ok_or(missing("slips", run.end_time()))?;
        (t, state, left) = (t + last.t, last.after, left - count);
    }
    Ok((t, state))
}

fn stick_slip() -> Result<Answered> {
    let over = HOLDS - RUBS;
    let slips = TAU - 2.0 * atan2(over, BELT);
    let period = slips + 2.0 * over / BELT;
    let end = f64::from(CYCLES) * period;
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
    let late = (f64::from(steps) * dt - end).abs();
    asked(
        // Where a block on the belt is, a time of a run of 400 knows to eps of that run.
        [end, 2.0 * HOLDS + BELT * 400.0 * period],
        all_cycles(period),
        |(t, _)| Ok((t - end).abs()),
        |(_, state)| Ok((state[0] - HOLDS).abs()),
        ("looked at every 0.01 s", late),
    )
}

/// A block of 1 kg that slides on a floor, mu = 0.5: 3 m/s against 5 m/s^2, so 0.6 s and 0.9 m to
/// its stop, then nothing for a thousand seconds, one event.
fn stop() -> Result<Answered> {
    let weight = |_: &MechanismState<3>| [0.0, -G, 0.0];
    let block = Bodies([1.0; 3], weight, |block| {
        let floor = Contact::new("floor", block.q[1], [0.0, 1.0, 0.0], 0.0);
        [floor.tangent([1.0, 0.0, 0.0], 0.0).friction(0.5)]
    });
    let (start, end) = (moving([0.0; 3], [3.0, 0.0, 0.0]), 1000.0);
    // The speed goes to and fro about nothing, and the block walks.
    let (mut x, mut v, dt) = (0.0, 3.0_f64, 0.001_f64);
    for _ in 0..1_000_000 {
        let slower = v - 5.0 * dt.copysign(v);
        (x, v) = (x + 0.5 * dt * (v + slower), slower);
    }
    asked(
        [3.0, 3.0],
        motion(&block, &tightest()?, start, end),
        |found| match found.events() {
            [one] => Ok((one.t - 0.6).abs()),
            _ => Err(missing("one stop", found.end_time())),
        },
        |found| {
            let at = found.at(end)?;
            Ok(off([at.q[0], at.v[0]], [0.9, 0.0]))
        },
        ("-mu N sign(v), steps of 0.001 s", off([x, v], [0.9, 0.0])),
    )
}

/// A ball that returns half of its speed: at rest after 3 s and infinitely many bounces.
/// Bounce n is at 3 - 4/2^n s: the twentieth, and the rest after all of them.
fn zeno() -> Result<Answered> {
    let weight = |_: &MechanismState<1>| [-G];
    let floor = |y: f64| [Contact::new("floor", y, [1.0], 0.0).restitution(0.5)];
    let ball = Bodies([1.0], weight, |ball| floor(ball.q[0]));
    let bounce = 3.0 - 4.0 / 1_048_576.0;
    let (mut y, mut v, mut bounces, mut steps, dt) = (5.0, 0.0, 0, 0_u32, 0.001);
    while bounces < 20 {
        steps += 1;
        (y, v) = (y + dt * v - 0.5 * G * dt * dt, v - G * dt);
        if y < 0.0 {
            (y, v, bounces) = (0.0, -0.5 * v, bounces + 1);
        }
    }
    let late = (f64::from(steps) * dt - bounce).abs();
    asked(
        [6.0, 6.0],
        motion(&ball, &tightest()?, MechanismState::rest([5.0]), 4.0),
        |found| {
            let (twentieth, rest) = (found.events().get(19), found.event("floor rests")?);
            let twentieth = twentieth.ok_or(missing("twenty bounces", found.end_time()))?;
            Ok(off([twentieth.t, rest.t], [bounce, 3.0]))
        },
        |found| {
            let MechanismState { q: [y], v: [v] } = found.at(4.0)?;
            Ok(off([y, v], [0.0; 2]))
        },
        ("looked at every 0.001 s: bounce 20", late),
    )
}

family! { FAMILY, "events": "Grazes, ties, stops and bounces without end",
    by [By::Events], in ["time of the event", "state at the end"], seen in stepped::bounces;
    "a graze 1e-2 deep", "both ends of a step are on the same side": graze(1e-2);
    "a graze 1e-6 deep", "both ends of a step are on the same side": graze(1e-6);
    "a graze 1e-8 deep", "both ends of a step are on the same side": graze(1e-8);
    "a miss by 1e-8", "what is nearly touched is not touched": graze(-1e-8);
    "two events 1e-9 s apart", "they are within one step": corner(1e-9, 10.0);
    "two events at once", "one is found, the other is already past": corner(0.0, 10.0);
    "two events at a step's end", "the sign changes between two steps": corner(0.0, 0.25);
    "a ladder from 1e-8 rad", "the root of an energy that is not there yet": ladder();
    "10 000 cycles of stick and slip", "each event is late by part of a step, always late": stick_slip();
    "a Coulomb stop, and 1000 s of rest", "the sign of a speed that is nearly 0 is noise": stop();
    "bounces without end", "infinitely many events in three seconds": zeno();
    "a ladder under an overhang, mu = 1.1", "four sets of modes are tried, one of them is true":
        overhang(1.1, "a wall that is kept, as if it could pull");
    "the same, mu = 3: wedged, or falls", "two sets of modes are true":
        overhang(3.0, "the first set of modes that agrees");
    "a release and a stop at once", "what sticks is settled first, and the string is kept as it was": towed();
    "a release and a stop, apart but at once", "an event that is met ends the search for others": apart();
    "a disc that settles, to its film of air", "it falls a hundred thousand times faster than it began":
        to_film();
    "a disc that settles, and beyond", "its rate is infinite in a finite time": beyond();
}
