//! Exercise 15.1: a disc falls on another that turns about the same axis, and rubs on it until
//! both turn alike.

#[path = "ch15_ex1_two_discs/figures.rs"]
mod figures;
#[path = "ch15_ex1_two_discs/physics.rs"]
pub mod physics;

use kit::prelude::*;
use physics::*;
use rotation_dynamics::Error;
use rotation_dynamics::integrators::{Dop853, Event, Integrator, ode, size_or};

parameters! {
    /// The discs of the exercise; the notes leave all numbers open.
    pub struct Parameters {
        /// moment of inertia of the upper disc
        upper: number(0.03, "kg m^2", from_to(1e-9, 1e9).usually(0.01, 0.1)).drawn(0.01, 0.08, 0.01);
        /// moment of inertia of the lower disc
        lower: number(0.05, "kg m^2", from_to(1e-9, 1e9).usually(0.01, 0.1)).drawn(0.02, 0.10, 0.01);
        /// angular velocity of the upper disc before
        upper_rate: number(40.0, "rad/s", from_to(-1e6, 1e6).usually(-50.0, 50.0)).drawn(20.0, 60.0, 2.0).open("rate of the upper disc", "clockwise", "counterclockwise");
        /// angular velocity of the lower disc before
        lower_rate: number(-10.0, "rad/s", from_to(-1e6, 1e6).usually(-50.0, 50.0)).drawn(-30.0, -6.0, 2.0).open("rate of the lower disc", "clockwise", "counterclockwise");
        /// torque of the friction while one slips on the other
        friction: number(0.5, "N m", from_to(1e-9, 1e9).usually(0.1, 2.0)).drawn(0.2, 1.0, 0.1).open("friction while they slip", "slips long", "holds soon");
        /// height of the fall
        drop: number(0.2, "m", at_least(0.0).usually(0.0, 1.0));
        gravity: gravity(from_to(1e-6, 1e6).usually(1.0, 25.0));
        /// friction of the bearing of the lower disc, for the claims about it
        bearing: effect(0.05, "N m", above_to(0.0, 1e6));
        /// relative error of the simulations
        tolerance: number(1e-12, "-", from_to(1e-13, 1e-3));
    }
}

/// The laws of the page over their parameters: dry friction, friction that weakens with the
/// slip, a film of oil; each has the torque of the page at the first slip.
pub fn torque(p: &Parameters, law: &str, slip: f64) -> f64 {
    let first = Answer::new(p).relative;
    let (part, size) = (slip / first, p.friction * first.signum());
    match law {
        "dry" => size,
        "weakening" => size * (1.0 + exp(-5.0 * part)) / (1.0 + exp(-5.0)),
        _ => size * part,
    }
}

/// The largest slip in the last quarter of a run.
pub fn left_over(slips: &[(f64, f64)]) -> f64 {
    slips[slips.len() * 3 / 4..].iter().fold(0.0, |most, (_, w)| w.abs().max(most))
}

fn claims(p: &Parameters, report: &mut Report) -> Result<()> {
    let (a, size) = (Answer::new(p), rate(p));
    allowed! {
        "the larger of the two rates": size, above(0.0), "one of them must turn";
        "|O1 - O2| over the larger rate,": a.relative.abs() / size, from_to(1e-3, 2.0), "discs of equal rates do not slip";
        "drop, with time left to slip,": p.drop, from_to(0.0, 0.45 * p.gravity * a.time * a.time),
            "the disc must land before twice the time of the slip is over";
    }?;
    let run = fallen(p, 0.0, 2.0, p.tolerance)?;
    let (sticks, end) = (run.event("discs sticks")?, run.at(run.end_time())?);
    let momentum = |[upper, lower]: [f64; 2]| p.upper * upper + p.lower * lower;
    let (first, last) = ([p.upper_rate, p.lower_rate], [end.v[1], end.v[2]]);
    let before = kinetic_energy(p, first);
    let oil = rubbed(p, 1e-9, |slip| torque(p, "oil", slip))?;
    let dry = rubbed(p, 0.0, |slip| torque(p, "dry", slip))?;
    let (bound, whole, both) =
        (100.0 * p.tolerance, p.upper + p.lower, p.upper_rate + p.lower_rate);
    let (near, square) = (bound * whole * size, bound * whole * size * size);
    let time = bound * a.time * size / a.relative.abs();
    claims! { report,
        /// the rate at which both turn in the end
        common: a.common, "rad/s", "discs simulated" => end.v[1], within bound * size, in "The common rate":
            0.5 * both => "the discs are not equal",
            momentum(first.map(f64::abs)) / whole => "rates have signs",
            (2.0 * before / whole).sqrt() => "energy is not kept: the discs rub";
        /// kinetic energy lost
        lost: a.lost, "J", "discs simulated" => before - kinetic_energy(p, last), within square, in "The energy":
            0.5 * whole * a.relative * a.relative => "not both turn at that rate: which inertia belongs to the slip?",
            0.5 * a.reduced * both * both => "the slip is the difference of the rates, signs included",
            before => "they still turn in the end", before - a.lost => "that is what is left";
        /// part of it
        share: a.lost / before, "-", "heat of an oil film" => oil.end_state()[2] / before, within square / before + 1e-9;
        /// angular momentum of both, before and after
        momentum: momentum(first), "kg m^2/s", "discs simulated, after" => momentum(last), within near;
        /// how long they slip, without a fall
        time: a.time, "s", "located event" => dry.end_time(), within time, in "The time":
            p.upper * a.relative.abs() / p.friction => "the lower disc gets faster meanwhile",
            p.lower * a.relative.abs() / p.friction => "the upper disc gets slower meanwhile",
            whole * a.relative.abs() / p.friction => "which inertia belongs to the slip?",
            2.0 * a.time => "the slip becomes slower, but the torque does not";
        /// time from the release to the common rate, with the fall
        released: a.time, "s", "located event" => sticks.t, within time;
        /// angle by which one disc slips on the other
        slipped: 0.5 * a.relative * a.time, "rad", "discs simulated, heat over torque" => a.relative.signum() * dry.end_state()[2] / p.friction, within time * size;
    }
}

/// Light and heavy discs, equal ones, and those that stop each other.
fn limits(p: &Parameters, report: &mut Report) -> Result<()> {
    // Over the moment of inertia and the rate of the upper disc.
    let of = |lower: f64, lower_rate: f64| {
        let p = &Parameters { upper: 1.0, upper_rate: 1.0, lower, lower_rate, ..p.clone() };
        let a = Answer::new(p);
        (a.common, a.lost / kinetic_energy(p, [1.0, lower_rate]))
    };
    let ((heavy, all), (light, _), (like, half)) = (of(1e12, 0.0), of(1e-12, -1.0), of(1.0, 0.0));
    limits! { report,
        /// a heavy disc keeps its rate
        "I2 to infinity: (Omega - Omega2)/Omega1": heavy => 0.0, within 1e-11;
        /// and takes all energy of the slip
        "I2 to infinity, Omega2 = 0: lost/before": all => 1.0, within 1e-11;
        /// a light one is carried along
        "I2 to 0: Omega/Omega1": light => 1.0, within 1e-11;
        /// the mean
        "I1 = I2, Omega2 = 0: Omega/Omega1": like => 0.5, within 1e-15;
        /// half of the energy, as when a body hits its like and sticks
        "I1 = I2, Omega2 = 0: lost/before": half => 0.5, within 1e-15;
        /// angular momenta that cancel: both stop
        "I1 Omega1 = -I2 Omega2: lost/before": of(2.0, -0.5).1 => 1.0, within 1e-15;
        /// nothing slips
        "Omega1 = Omega2: lost/before": of(3.0, 1.0).1 => 0.0, within 1e-15;
    }
}

/// The rate at which both turn in the end if something brakes the two discs from outside (N m,
/// of their rates).
fn braked(p: &Parameters, brake: impl Fn([f64; 2]) -> [f64; 2]) -> Result<f64> {
    let a = Answer::new(p);
    let rubs = p.friction * a.relative.signum();
    let law = ode(|_, rates: &[f64; 2]| {
        let [upper, lower] = brake(*rates);
        [-(rubs + upper) / p.upper, (rubs - lower) / p.lower]
    })
    .scaled(size_or([1.0; 2]));
    let over = Event::falling("over", |_, y: &[f64; 2]| (y[0] - y[1]) / a.relative).terminal();
    let start = [p.upper_rate, p.lower_rate];
    let run = Dop853::new(1e-11)?.solve(&law, 0.0, &start, 1e3 * a.time, &[over])?;
    Ok(run.end_state()[0])
}

/// What `--with bearing` adds: the rate at which they turn alike, and when. The lower disc may turn
/// one way and then the other, and what brakes it turns round with it.
fn rough(p: &Parameters, report: &mut Report) -> Result<()> {
    let Some(bearing) = p.bearing else { return Ok(()) };
    allowed! {
        "bearing over the friction of the discs": bearing / p.friction, between(0.0, 0.99), "or the bearing holds the lower disc";
    }?;
    let (a, rubs) = (Answer::new(p), p.friction * Answer::new(p).relative.signum());
    let (fast, slow) = (-rubs / p.upper, |brake: f64| (rubs - brake * rubs.signum()) / p.lower);
    // Until the lower disc stops, if it turns against the friction; then it is driven on.
    let (against, held) = (p.lower_rate * rubs < 0.0, slow(-bearing));
    let wait = -p.lower_rate / held;
    let turned = against && wait < a.relative / (held - fast);
    let (wait, lower) = if turned { (wait, 0.0) } else { (0.0, p.lower_rate) };
    let (upper, way) = (p.upper_rate + fast * wait, if against && !turned { -1.0 } else { 1.0 });
    let time = (upper - lower) / (slow(way * bearing) - fast);
    let found = braked(p, |[_, lower]| [0.0, bearing * lower.signum()])?;
    claims! { report,
        /// with a bearing that rubs: common angular velocity
        rough_common: upper + fast * time, "rad/s", "simulated" => found, within 1e-8 * rate(p);
        /// and how long they slip
        rough_time: wait + time, "s", "simulated" => (found - p.upper_rate) / fast, within 1e-8 * (rate(p) / fast).abs();
    }
}

/// The card of effects: steel discs with a radius of 0.2 m, a ball bearing of 1 cm.
fn effects(p: &Parameters, report: &mut Report) -> Result<()> {
    let (a, whole, radius, size) = (Answer::new(p), p.upper + p.lower, 0.2, rate(p));
    let bearing = 1.5e-3 * 2.0 * whole / (radius * radius) * p.gravity * 0.01;
    // Two faces, one of each disc: 3.87/sqrt(Re) of rho w^2 R^5/2, laminar.
    let reynolds = size * radius * radius / 1.5e-5;
    let air = 3.87 / reynolds.sqrt() * 0.5 * 1.204 * size * size * radius.powi(5);
    // What brakes a disc turns round with it: over the slip, the rate changes evenly.
    let mean = |from: f64, power: f64| {
        let grown = pow(a.common.abs(), power + 1.0) - pow(from.abs(), power + 1.0);
        if a.common == from { 0.0 } else { grown / ((power + 1.0) * (a.common - from)) }
    };
    let by_bearing = bearing * mean(p.lower_rate, 0.0) * a.time / whole;
    let blown = mean(p.upper_rate, 1.5) + mean(p.lower_rate, 1.5);
    let by_air = 0.5 * air / pow(size, 1.5) * blown * a.time / whole;
    let dry = |[_, lower]: [f64; 2]| [0.0, bearing * lower.signum()];
    let wind = |rate: f64| 0.5 * air * rate / size * (rate.abs() / size).sqrt();
    // What brakes more than the discs rub stops both, and tells nothing of the slip.
    let dried = when(bearing < 0.3 * p.friction, || braked(p, dry))?;
    let blown = when(air < 0.3 * p.friction, || braked(p, |rates| rates.map(wind)))?;
    // Where the two halves cancel, what is left is of second order.
    let second = |torque: f64| 4.0 * size * pow(torque / p.friction, 2.0) + 1e-9 * size;
    let beside = 1e-6 / (radius * radius);
    effect_card! { report,
        "friction of the bearing, 1 cm": "tau_b/tau" = bearing / p.friction, costs by_bearing, "rad/s",
            measured dried.map(|rate| a.common - rate), within second(bearing);
        "air on the outer faces": "tau_a/tau" = air / p.friction, costs by_air, "rad/s",
            measured blown.map(|rate| a.common - rate), within second(air);
        "it lands 1 mm beside the axis": "e^2/R^2" = beside, costs 2.0 * p.upper * beside * size / whole, "rad/s, at most";
        "the fall": "t_f/T" = (2.0 * p.drop / p.gravity).sqrt() / a.time, costs 0.0, "s of the time from the release", included;
    }
}

/// The solvers with the sign, over twice the time of the slip, and the one that stops at the event.
fn naive(p: &Parameters, report: &mut Report) -> Result<()> {
    let (start, time) = ([p.upper_rate, p.lower_rate, 0.0], Answer::new(p).time);
    let columns = ["solver", "steps", "comes to t/T", "slip left / rad/s"];
    let (mut rows, end) = (Vec::new(), 2.0 * time);
    for steps in [51, 501, 5001] {
        let slip = left_over(&chattering(p, steps, end));
        rows.push(("sign, equal steps".into(), steps.into(), end, Some(slip)));
    }
    for tolerance in [1e-6, 1e-9] {
        let method = Dop853::new(tolerance)?.with_step_limit(10_000)?;
        let (steps, t) = match method.advance(&sign(p), 0.0, &start, end) {
            Ok((_, work)) => (work.steps, end),
            Err(Error::LimitReached { t, limit, .. }) => (limit, t),
            Err(other) => return Err(other.into()),
        };
        rows.push((format!("sign, DOP853 with {tolerance:e}"), steps, t, None));
    }
    let run = fallen(p, 0.0, 2.0, p.tolerance)?;
    let [_, upper, lower] = run.at(end)?.v;
    rows.push(("stick located".into(), run.work().steps, end, Some((upper - lower).abs())));
    report.add(Table::of("naive", columns, rows, |(solver, steps, t, slip)| {
        let slip = slip.map_or("-".into(), |slip| format!("{slip:.3}"));
        Ok([solver, steps.to_string(), format!("{:.6}", t / time), slip])
    })?)
}

/// The accuracy strip: times and rates at the stick, after the fall.
fn accuracy(p: &Parameters, report: &mut Report) -> Result<()> {
    let (p, a, size) = (p.clone(), Answer::new(p), rate(p));
    let asked = [p.tolerance, 1e-3, 1e-6, 1e-9, 1e-13];
    let error = move |run: &Fall| {
        let sticks = run.event("discs sticks")?;
        let rate = (sticks.after.v[1] - a.common).abs() / size;
        Ok((sticks.t / a.time - 1.0).abs().max(rate))
    };
    report.in_closed_form(move |part| a.common + (1.0 - part) * a.relative);
    let run = move |step| fallen(&p, 0.0, 2.0, step);
    report.controlled("contacts by DOP853", asked, run, Fall::work, error)
}

example! {
    ch15_ex1_two_discs: "Exercise 15.1: two discs on one axis rub on each other until they turn alike";
    "Two discs", "A disc falls on another that turns about the same axis, and slips on it for a while.",
    [claims, rough, limits, effects, naive, accuracy];
    figures::figures, figures::trajectory, figures::moving_picture
}
