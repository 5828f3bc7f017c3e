//! Contacts with friction that leave a choice, or change two at a time; and a disc that settles
//! faster and faster, to an end that no clock passes.

use super::events::{G, row, tightest};
use super::ladder::{LENGTH, Ladder};
use super::table::Row;
use core::f64::consts::{FRAC_PI_2, PI};
use kit::Result;
use rotation_dynamics::Error;
use rotation_dynamics::exact::pendulum::{Pendulum, Suspension};
use rotation_dynamics::math::{cos, pow, tan};
use rotation_dynamics::planar::contact::{Contact, Mechanism, MechanismState, motion};
use rotation_dynamics::planar::{Condition, Next, Phased, simulate};

/// How far the wall leans over the ladder: 20 degrees.
const OVERHANG: f64 = PI / 9.0;
/// Its angle from the vertical at the start (rad).
const LEANS: f64 = 1.4;

/// It turns about its foot, which holds: a rod on a pivot, to the floor. Friction of 1.13 could
/// also hold it where it is, wedged between wall and floor; then nothing in the laws of dry
/// friction says which.
fn overhang(words: [&'static str; 2], mu: f64, naive: &'static str) -> Result<Row> {
    let rod = Suspension {
        moment: LENGTH * LENGTH / 3.0,
        mass: 1.0,
        gravity: G,
        lever: 0.5 * LENGTH,
    };
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
    let ladder = Ladder {
        gravity: G,
        overhang: OVERHANG,
        mu,
    };
    let found = motion(&ladder, &tightest()?, ladder.at_rest(LEANS), 1.0);
    let time = found
        .as_ref()
        .map_err(Clone::clone)
        .and_then(|found| Ok((found.event("lands")?.t - lands).abs()));
    let state = found.and_then(|found| Ok((found.event("lands")?.before.v[2] - rate).abs()));
    // Either way it stays where it is.
    let naive = (naive, FRAC_PI_2 - LEANS);
    // The time goes as the root of what is left to fall, which is cos(theta_0).
    let moved = LEANS * tan(LEANS);
    row(words, [lands * moved, rate * moved], [time, state], naive)
}

/// Two blocks of 1 kg that slide up an incline on a string of 1 m: the lower one rubs and is
/// pulled. Positions along the incline.
struct Towed;
/// g sin(alpha), and mu g cos(alpha) of the lower block.
const DOWN: f64 = 6.0;
const BRAKE: f64 = 8.0;

impl Mechanism<2, 2> for Towed {
    fn mass(&self, _: &[f64; 2]) -> [[f64; 2]; 2] {
        [[1.0, 0.0], [0.0, 1.0]]
    }
    fn force(&self, _: &MechanismState<2>) -> [f64; 2] {
        [-DOWN, -DOWN]
    }
    fn contacts(&self, blocks: &MechanismState<2>) -> [Contact<2>; 2] {
        let [lower, upper] = blocks.q;
        [
            Contact::new("string", 1.0 - (upper - lower), [1.0, -1.0], 0.0),
            Contact::pressed("block", BRAKE)
                .tangent([1.0, 0.0], 0.0)
                .friction(1.0),
        ]
    }
}

/// Both slow down by 6 + 8/2 = 10 m/s^2. Where they come to rest the lower one sticks and the
/// upper one turns back at 6 m/s^2, so the string lets go in the same instant.
fn towed() -> Result<Row> {
    let (speed, end) = (5.0, 0.9);
    let start = MechanismState {
        q: [0.0, 1.0],
        v: [speed; 2],
    };
    let stop: f64 = speed / 10.0;
    let place = 0.5 * speed * stop;
    let back = 0.5 * DOWN * (end - stop) * (end - stop);
    let found = motion(&Towed, &tightest()?, start, end);
    let time = found.as_ref().map_err(Clone::clone).and_then(|found| {
        let at = found.events().first().ok_or(Error::NotReached {
            name: "block sticks",
            until: end,
        })?;
        Ok((at.t - stop).abs())
    });
    let state = found.and_then(|found| {
        let [lower, upper] = found.at(end)?.q;
        let off = (upper - (1.0 + place - back)).abs();
        Ok(off.max((lower - place).abs()))
    });
    row(
        [
            "a release and a stop at once",
            "what sticks is settled first, and the string is kept as it was",
        ],
        [2.0 * stop, 1.0 + 2.0 * place + 4.0 * back],
        [time, state],
        ("one contact an event", back),
    )
}

/// A block that slides to a stop on one floor, and one that is lifted off another by a force
/// that grows with the time, which is the third coordinate.
struct Apart;
const LIFT: f64 = 10.0;

impl Mechanism<3, 2> for Apart {
    fn mass(&self, _: &[f64; 3]) -> [[f64; 3]; 3] {
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
    }
    fn force(&self, both: &MechanismState<3>) -> [f64; 3] {
        [0.0, LIFT * (both.q[2] - 0.6), 0.0]
    }
    fn contacts(&self, both: &MechanismState<3>) -> [Contact<3>; 2] {
        [
            Contact::pressed("block", 5.0)
                .tangent([1.0, 0.0, 0.0], 0.0)
                .friction(1.0),
            Contact::new("shelf", both.q[1], [0.0, 1.0, 0.0], 0.0),
        ]
    }
}

/// 3 m/s against 5 m/s^2, and 6 N against 10 N/s: both at 0.6 s, to the last bit or two.
fn apart() -> Result<Row> {
    let (both, end) = (0.6, 1.6);
    let start = MechanismState {
        q: [0.0; 3],
        v: [3.0, 0.0, 1.0],
    };
    let rise = |since: f64| LIFT * since * since * since / 6.0;
    let found = motion(&Apart, &tightest()?, start, end);
    let time = found.as_ref().map_err(Clone::clone).and_then(|found| {
        let [stops, lifts] = [found.event("block sticks")?, found.event("shelf lets go")?];
        Ok((stops.t - both).abs().max((lifts.t - both).abs()))
    });
    let state = found.and_then(|found| {
        let [x, y, _] = found.at(end)?.q;
        Ok((x - 0.9).abs().max((y - rise(end - both)).abs()))
    });
    // The stop is met at the end of the step to 0.75 s, the release at that of the next.
    let (late, left) = (1.0, end - 1.0);
    let rises =
        rise(end - both) - rise(late - both) - 0.5 * LIFT * (late - both) * (late - both) * left;
    row(
        [
            "a release and a stop, apart but at once",
            "an event that is met ends the search for others",
        ],
        [3.0 * both, 0.9 * 2.0 + 4.0 * rise(end)],
        [time, state],
        (
            "one event at the end of each 0.25 s",
            rise(end - both) - rises,
        ),
    )
}

/// A disc that settles in the air under it: its inclination falls as -k/theta^2, while its
/// contact runs round at 2/sqrt(theta) (Moffatt; in units of sqrt(R/g)).
struct Settles;
const AIR: f64 = 1e-4;
const FILM: f64 = 1e-3;
const INCLINED: f64 = 0.1;

impl Phased<2> for Settles {
    type Phase = ();
    fn derivative(&self, (): (), [inclination, _]: &[f64; 2]) -> [f64; 2] {
        [-AIR / (inclination * inclination), 2.0 / inclination.sqrt()]
    }
    fn conditions(&self, (): ()) -> Vec<Condition<'_, (), 2>> {
        vec![Condition::gap("film", |y| y[0] - FILM, Next::End)]
    }
    fn scale(&self, [inclination, turned]: &[f64; 2]) -> [f64; 2] {
        [*inclination, turned.abs().max(1.0)]
    }
}

/// The same, with nothing that ends it.
struct Unending;

impl Phased<2> for Unending {
    type Phase = ();
    fn derivative(&self, (): (), state: &[f64; 2]) -> [f64; 2] {
        Settles.derivative((), state)
    }
    fn conditions(&self, (): ()) -> Vec<Condition<'_, (), 2>> {
        vec![Condition::gap("flat", |y| y[0], Next::End)]
    }
    fn scale(&self, state: &[f64; 2]) -> [f64; 2] {
        Settles.scale(state)
    }
}

/// theta^3 falls steadily: (theta_0^3 - film^3)/3k to the film, and 4/5k of what theta^(5/2)
/// loses has the contact turned until then. Without a film it is flat at a time of its own,
/// turning infinitely fast, and after that there is nothing.
fn disc() -> Result<[Row; 2]> {
    let cube = |x: f64| x * x * x;
    let last = cube(INCLINED) / (3.0 * AIR);
    let film = last - cube(FILM) / (3.0 * AIR);
    let turned = |to: f64| 0.8 / AIR * (pow(INCLINED, 2.5) - pow(to, 2.5));
    let start = [INCLINED, 0.0];
    // Heun's method, with the step that served in the beginning.
    let heun = |end: f64, steps: u32| {
        let h = end / f64::from(steps);
        let mut y = start;
        for _ in 0..steps {
            let a = Settles.derivative((), &y);
            let b = Settles.derivative((), &[y[0] + h * a[0], y[1] + h * a[1]]);
            y = [
                y[0] + 0.5 * h * (a[0] + b[0]),
                y[1] + 0.5 * h * (a[1] + b[1]),
            ];
        }
        y
    };
    let found = simulate(&Settles, &tightest()?, (), start, 2.0 * last);
    let time = found
        .as_ref()
        .map_err(Clone::clone)
        .and_then(|run| Ok((run.transition("film")?.t - film).abs()));
    let state = found.and_then(|run| Ok((run.transition("film")?.before[1] - turned(FILM)).abs()));
    let [tilt, _] = heun(film, 1000);
    let to_film = row(
        [
            "a disc that settles, to its film of air",
            "it falls a hundred thousand times faster than it began",
        ],
        [3.0 * 3.0 * last, 3.0 * 2.5 * turned(0.0)],
        [time, state],
        ("1000 steps of Heun: inclination", (tilt - FILM).abs()),
    )?;
    let beyond = simulate(&Unending, &tightest()?, (), start, 1.5 * last);
    let time = beyond
        .as_ref()
        .map_err(Clone::clone)
        .and_then(|run| Ok((run.transition("flat")?.t - last).abs()));
    let state = beyond.and_then(|run| Ok((run.at(1.5 * last)?.1[1] - turned(0.0)).abs()));
    let [_, goes_on] = heun(1.5 * last, 1500);
    let to_end = row(
        [
            "a disc that settles, and beyond",
            "its rate is infinite in a finite time",
        ],
        [3.0 * 3.0 * last, 3.0 * 2.5 * turned(0.0)],
        [time, state],
        ("1500 steps of Heun: turned", (goes_on - turned(0.0)).abs()),
    )?;
    Ok([to_film, to_end])
}

pub fn rows() -> Result<Vec<Row>> {
    let mut rows = vec![
        overhang(
            [
                "a ladder under an overhang, mu = 1.1",
                "four sets of modes are tried, one of them is true",
            ],
            1.1,
            "a wall that is kept, as if it could pull",
        )?,
        overhang(
            [
                "the same, mu = 3: wedged, or falls",
                "two sets of modes are true",
            ],
            3.0,
            "the first set of modes that agrees",
        )?,
        towed()?,
        apart()?,
    ];
    rows.extend(disc()?);
    Ok(rows)
}
