//! Contacts with friction that leave a choice, or change two at a time; and a disc that settles
//! faster and faster, to an end that no clock passes.

use super::events::{Bodies, G, asked, missing, moving, off, tightest};
use super::ladder::{LENGTH, Ladder};
use super::*;
use rotation_dynamics::exact::pendulum::{Pendulum, Suspension};
use rotation_dynamics::planar::contact::{Contact, MechanismState, motion};
use rotation_dynamics::planar::{Condition, Next, Phased, simulate};

/// How far the wall leans over the ladder: 20 degrees.
const OVERHANG: f64 = PI / 9.0;
/// Its angle from the vertical at the start (rad).
const LEANS: f64 = 1.4;

/// It turns about its foot, which holds: a rod on a pivot, to the floor. Friction of 1.13 could
/// also hold it where it is, wedged between wall and floor; then nothing in the laws of dry
/// friction says which.
pub fn overhang(mu: f64, naive: &'static str) -> Result<Answered> {
    let (moment, lever) = (LENGTH * LENGTH / 3.0, 0.5 * LENGTH);
    let rod = Suspension { moment, mass: 1.0, gravity: G, lever };
    // Counted from the hanging position.
    let falls = Pendulum::new(rod, PI - LEANS, 0.0)?;
    let (mut before, mut lands) = (0.0, 1.0);
    for _ in 0..60 {
        let middle = 0.5 * (before + lands);
        match falls.at(middle)?.theta > FRAC_PI_2 {
            true => before = middle,
            false => lands = middle,
        }
    }
    // By the energy: L theta'^2 = 3 g cos(theta_0).
    let rate = (3.0 * G * cos(LEANS) / LENGTH).sqrt();
    let ladder = Ladder { gravity: G, overhang: OVERHANG, mu };
    // The time goes as the root of what is left to fall, which is cos(theta_0).
    let moved = LEANS * tan(LEANS);
    asked(
        [lands * moved, rate * moved],
        motion(&ladder, &tightest()?, ladder.at_rest(LEANS), 1.0),
        |found| Ok((found.event("lands")?.t - lands).abs()),
        |found| Ok((found.event("lands")?.before.v[2] - rate).abs()),
        // Either way it stays where it is.
        (naive, FRAC_PI_2 - LEANS),
    )
}

/// g sin(alpha) on two blocks of 1 kg, and mu g cos(alpha) of the lower one.
const DOWN: f64 = 6.0;
const BRAKE: f64 = 8.0;

/// They slide up an incline on a string of 1 m, and the lower one, which rubs, is pulled; positions
/// along the incline. Both slow down by 6 + 8/2 = 10 m/s^2. Where they come to rest the lower one
/// sticks and the upper one turns back at 6 m/s^2, so the string lets go in the same instant.
pub fn towed() -> Result<Answered> {
    let down = |_: &MechanismState<2>| [-DOWN, -DOWN];
    let towed = Bodies([1.0; 2], down, |blocks| {
        let [lower, upper] = blocks.q;
        let block = Contact::pressed("block", BRAKE).tangent([1.0, 0.0], 0.0);
        let string = Contact::new("string", 1.0 - (upper - lower), [1.0, -1.0], 0.0);
        [string, block.friction(1.0)]
    });
    let (speed, end) = (5.0, 0.9);
    let start = moving([0.0, 1.0], [speed; 2]);
    let stop: f64 = speed / 10.0;
    let place = 0.5 * speed * stop;
    let back = 0.5 * DOWN * (end - stop) * (end - stop);
    asked(
        [2.0 * stop, 1.0 + 2.0 * place + 4.0 * back],
        motion(&towed, &tightest()?, start, end),
        |found| {
            let at = found.events().first().ok_or(missing("block sticks", end))?;
            Ok((at.t - stop).abs())
        },
        |found| Ok(off(found.at(end)?.q, [place, 1.0 + place - back])),
        ("one contact an event", back),
    )
}

/// A force that grows with the time (N/s).
const LIFT: f64 = 10.0;

/// A block that slides to a stop on one floor, and one that is lifted off another by that force;
/// the time is the third coordinate. 3 m/s against 5 m/s^2, and 6 N against 10 N/s: both at
/// 0.6 s, to the last bit or two.
pub fn apart() -> Result<Answered> {
    let lift = |both: &MechanismState<3>| [0.0, LIFT * (both.q[2] - 0.6), 0.0];
    let apart = Bodies([1.0; 3], lift, |both| {
        let block = Contact::pressed("block", 5.0).tangent([1.0, 0.0, 0.0], 0.0);
        let shelf = Contact::new("shelf", both.q[1], [0.0, 1.0, 0.0], 0.0);
        [block.friction(1.0), shelf]
    });
    let (both, end) = (0.6, 1.6);
    let start = moving([0.0; 3], [3.0, 0.0, 1.0]);
    let rise = |since: f64| LIFT * since * since * since / 6.0;
    // The stop is met at the end of the step to 0.75 s, the release at that of the next.
    let (late, left) = (1.0, end - 1.0);
    let speed = 0.5 * LIFT * (late - both) * (late - both);
    let missed = rise(end - both) - (rise(end - both) - rise(late - both) - speed * left);
    asked(
        [3.0 * both, 0.9 * 2.0 + 4.0 * rise(end)],
        motion(&apart, &tightest()?, start, end),
        |found| {
            let [stops, lifts] = [found.event("block sticks")?, found.event("shelf lets go")?];
            Ok(off([stops.t, lifts.t], [both; 2]))
        },
        |found| {
            let [x, y, _] = found.at(end)?.q;
            Ok(off([x, y], [0.9, rise(end - both)]))
        },
        ("one event at the end of each 0.25 s", missed),
    )
}

/// A disc that settles in the air under it: its inclination falls as -k/theta^2, while its
/// contact runs round at 2/sqrt(theta) (Moffatt; in units of sqrt(R/g)). Something ends it, at
/// an inclination.
struct Settles(&'static str, f64);
const AIR: f64 = 1e-4;
const FILM: f64 = 1e-3;
const START: [f64; 2] = [0.1, 0.0];

impl Phased<2> for Settles {
    type Phase = ();
    fn derivative(&self, (): (), [inclination, _]: &[f64; 2]) -> [f64; 2] {
        [-AIR / (inclination * inclination), 2.0 / inclination.sqrt()]
    }
    fn conditions(&self, (): ()) -> Vec<Condition<'_, (), 2>> {
        vec![Condition::gap(self.0, |y| y[0] - self.1, Next::End)]
    }
    fn scale(&self, [inclination, turned]: &[f64; 2]) -> [f64; 2] {
        [*inclination, turned.abs().max(1.0)]
    }
}

impl Settles {
    /// theta^3 falls steadily: (theta_0^3 - theta^3)/3k is the time to an inclination.
    fn time(to: f64) -> f64 {
        let cube = |x: f64| x * x * x;
        cube(START[0]) / (3.0 * AIR) - cube(to) / (3.0 * AIR)
    }

    /// 4/5k of what theta^(5/2) loses has the contact turned until then.
    fn turned(to: f64) -> f64 {
        0.8 / AIR * (pow(START[0], 2.5) - pow(to, 2.5))
    }

    /// By Heun's method, with the step that served in the beginning.
    fn heun(&self, end: f64, steps: u32) -> [f64; 2] {
        let h = end / f64::from(steps);
        (0..steps).fold(START, |y, _| {
            let a = self.derivative((), &y);
            let b = self.derivative((), &[0, 1].map(|i| y[i] + h * a[i]));
            [0, 1].map(|i| y[i] + 0.5 * h * (a[i] + b[i]))
        })
    }

    fn conditions_of_all() -> [f64; 2] {
        [3.0 * 3.0 * Self::time(0.0), 3.0 * 2.5 * Self::turned(0.0)]
    }
}

pub fn to_film() -> Result<Answered> {
    let disc = Settles("film", FILM);
    let (film, turned) = (Settles::time(FILM), Settles::turned(FILM));
    let [tilt, _] = disc.heun(film, 1000);
    asked(
        Settles::conditions_of_all(),
        simulate(&disc, &tightest()?, (), START, 2.0 * Settles::time(0.0)),
        |run| Ok((run.transition("film")?.t - film).abs()),
        |run| Ok((run.transition("film")?.before[1] - turned).abs()),
        ("1000 steps of Heun: inclination", (tilt - FILM).abs()),
    )
}

/// Without a film it is flat at a time of its own, turning infinitely fast, and after that there
/// is nothing.
pub fn beyond() -> Result<Answered> {
    let disc = Settles("flat", 0.0);
    let (last, turned) = (Settles::time(0.0), Settles::turned(0.0));
    let goes_on = disc.heun(1.5 * last, 1500)[1];
    asked(
        Settles::conditions_of_all(),
        simulate(&disc, &tightest()?, (), START, 1.5 * last),
        |run| Ok((run.transition("flat")?.t - last).abs()),
        |run| Ok((run.at(1.5 * last)?.1[1] - turned).abs()),
        ("1500 steps of Heun: turned", (goes_on - turned).abs()),
    )
}
