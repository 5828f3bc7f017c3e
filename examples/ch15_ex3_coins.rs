//! Exercise 15.3: a coin that rolls around a fixed coin of another size.

#[path = "ch15_ex3_coins/figures.rs"]
mod figures;
#[path = "ch15_ex3_coins/physics.rs"]
pub mod physics;

use kit::prelude::*;
use physics::*;
use rotation_dynamics::integrators::{Dop853, Ode, Solution, ode, size_or};

parameters! {
    /// The coins of the exercise; the notes leave all numbers open.
    pub struct Parameters {
        /// mass of the rolling coin
        mass: number(0.01, "kg", from_to(1e-9, 1e9).usually(0.001, 0.05)).drawn(0.005, 0.020, 0.001);
        /// radius of the fixed coin
        inner: number(0.02, "m", from_to(1e-9, 1e9).usually(0.005, 0.05)).drawn(0.018, 0.030, 0.002);
        /// radius of the rolling coin
        outer: number(0.012, "m", from_to(1e-9, 1e9).usually(0.005, 0.05)).drawn(0.006, 0.014, 0.002).open("radius of the rolling coin", "many turns", "few turns");
        /// rate at which the line of centres turns
        rate: number(2.0, "rad/s", from_to(-1e6, 1e6).but_zero("at rest nothing rolls").usually(0.5, 10.0)).drawn(1.0, 5.0, 0.5);
        /// where it rolls: around the fixed coin, or inside a fixed ring of that radius
        side: choice("outside", "inside").open("side of the fixed rim");
        /// coefficient of friction of coin and table, for the claims about it
        table: effect(0.2, "-", above_to(0.0, 1e6));
        /// error of a step of the simulations
        tolerance: number(1e-13, "-", from_to(1e-15, 1e-6));
    }
}

fn claims(p: &Parameters, report: &mut Report) -> Result<()> {
    let (r, rate, unit) = (ratio(p)?, p.rate, p.mass * p.inner * p.inner * p.rate);
    let (net, l, t) = (angular_velocity(r), angular_momentum(r), kinetic_energy(r));
    let bound = 100.0 * p.tolerance * (1.0 + net.abs());
    let turned = r.signum() * rolled(r, TAU, p.tolerance)?.end_time() / TAU;
    let [momentum, energy, force] = particles(r);
    // From contact to contact: an arch, for which the line of centres turns by 2 pi r.
    let arch = rolled(r, TAU * r.abs(), p.tolerance)?.end_state()[5];
    let speed = p.inner * rate * (1.0 + r);
    claims! { report,
        /// angular velocity of the rolling coin
        omega: rate * net, "rad/s", "rolled about the contact" => rate * turned, within rate * bound, in "The motion":
            rate * (net - 1.0) => "that is relative to the line of centres",
            rate * (1.0 + r) => "which of the two radii is it divided by?";
        /// how often it turns in a circuit
        turns: net, "-", "rolled about the contact" => turned, within bound, in "The motion":
            net - 1.0 => "the line of centres turns as well";
        /// angular momentum about the middle of the fixed coin
        momentum: unit * l, "kg m^2/s", "four particles" => unit * momentum, within 1e-11 * unit * (1.0 + r) * (1.0 + r).max(1.0),
        in "The motion":
            unit * (1.0 + r) * (1.0 + r) => "the coin also turns about its own middle",
            unit * 0.5 * r * r * net => "that is about the middle of the coin",
            unit * ((1.0 + r) * (1.0 + r) + 0.5 * r * r * (net - 1.0)) => "take the rate in the laboratory, not that seen from the line of centres";
        /// kinetic energy
        energy: unit * rate * t, "J", "four particles" => unit * rate * energy, within 1e-11 * unit * rate * t, in "The motion":
            unit * rate * t / 1.5 => "the coin also turns";
        /// force that keeps its middle on the circle
        force: p.mass * speed * rate, "N", "four particles" => p.mass * p.inner * rate * rate * force, within 1e-10 * (1.0 + net * net) * p.mass * speed * rate;
        /// path of a point of the rim, from contact to contact
        arch: 8.0 * p.inner * (r * (1.0 + r)).abs(), "m", "rolled about the contact" => p.inner * arch, within p.inner * bound * (10.0 + 8.0 * r * r);
    }
}

/// Large coins and small ones, outside and inside.
fn limits(_: &Parameters, report: &mut Report) -> Result<()> {
    limits! { report,
        /// equal coins: two turns, as in section 15.2
        "R1 = R2: turns": angular_velocity(1.0) => 2.0, within 1e-15;
        /// equal coins: 5 M R^2 Omega, as in section 15.4
        "R1 = R2: L/(M R^2 Omega)": particles(1.0)[0] => 5.0, within 1e-11;
        /// about a point it only turns, with 3/2 M R2^2 about its rim
        "R2 = 100 R1: L/(M R2^2 Omega)": angular_momentum(1e2) / 1e4 => 1.5, within 0.03;
        /// a straight road: once for each length of the rim, and once for the bend
        "R1 = 100 R2: turns": angular_velocity(0.01) => 101.0, within 1e-12;
        /// inside a ring of 3/2 of its radius: the spin takes what the circling gives
        "inside, R1 = 3/2 R2: L/(M R1^2 Omega)": particles(-2.0 / 3.0)[0] => 0.0, within 1e-12;
        /// inside a ring of its own size it cannot roll at all
        "inside, R1 = R2: turns": angular_velocity(-1.0) => 0.0, within 1e-15;
    }
}

/// The mean distance of the places of a disc from a point of its rim, over its radius, from
/// pieces of equal width; it is 32/(9 pi).
pub fn mean_distance(pieces: u32) -> f64 {
    let (n, parts) = (f64::from(pieces), (0..pieces).map(|i| f64::from(i) + 0.5));
    let ring = |at: f64| {
        let from_rim = |k: u32| {
            let (s, c) = sincos(TAU * (f64::from(k) + 0.5) / n);
            hypot(1.0 - at / n * c, at / n * s)
        };
        2.0 * at / (n * n) * (0..pieces).map(from_rim).sum::<f64>() / n
    };
    parts.map(ring).sum()
}

/// What a table takes with this coefficient of friction, J a circuit, and the same from the ways of
/// the pieces of the coin.
fn rubbing(p: &Parameters, friction: f64) -> Result<[f64; 2]> {
    let (r, force) = (ratio(p)?, friction * p.mass * 9.80665);
    // A disc of weight 1 that turns about a point of its rim rubs 32/(9 pi) as much as one that slides.
    let way = TAU * p.inner * (1.0 + r) * (32.0 / (4.5 * TAU));
    // By the angle through which it turns about the contact.
    let ran = p.outer * mean_distance(40) * rolled(r, TAU, 1e-12)?.end_time();
    Ok([force * way, force * ran])
}

/// What `--with table` adds: the work of a circuit, and the power that holds the rate.
fn rubbed(p: &Parameters, report: &mut Report) -> Result<()> {
    let Some(friction) = p.table else { return Ok(()) };
    let [work, ran] = rubbing(p, friction)?;
    claims! { report,
        /// on a table that rubs: work of a circuit
        rubbed_work: work, "J", "ways of its pieces" => ran, within 1e-4 * work;
        /// and the power that it takes
        rubbed_power: work * p.rate / TAU, "W", "ways of its pieces" => ran * p.rate / TAU, within 1e-4 * work * p.rate;
    }
}

/// The card of effects, for coins that lie on a table.
fn effects(p: &Parameters, report: &mut Report) -> Result<()> {
    let r = ratio(p)?;
    let (distance, slip, edge) = (p.inner * (1.0 + r), 0.01, 1e-5 / p.outer);
    above(0.0).check("distance of the middles", distance)?;
    let energy = p.mass * p.inner * p.inner * p.rate * p.rate * kinetic_energy(r);
    let ([rubbed, ran], around) = (rubbing(p, 0.2)?, rolled(r, TAU, 1e-12)?);
    // If the rim at the contact moves, the middle moves so much more.
    let faster = 1.0 / (1.0 - slip / (1.0 + r));
    let slipping = ode(|t, y: &[f64; 6]| rolling(r).derivative(t, y).map(|rate| faster * rate))
        .scaled(size_or([1.0; 6]));
    let long = (1e3 / r.abs()).max(20.0);
    let slipped = when(faster > 0.0 && faster < 2.0, || {
        Dop853::new(1e-12)?.zero(&slipping, start(r), 1, long, |y| y[4] - TAU)
    })?;
    let worn =
        ratio(&p.but(|p| p.outer += 1e-5)).ok().map(|r| rolled(r, TAU, 1e-12)).transpose()?;
    let fewer = |end: f64| (around.end_time() - end) / TAU;
    effect_card! { report,
        "rubbing on the table; the rate is held": "W/T" = rubbed / energy, costs rubbed, "J to be given, a circuit",
            measured ran, within 1e-4 * rubbed, at_work around.work();
        "slip of a hundredth at the contact": "s" = slip, costs slip / r.abs(), "turns a circuit", beside "turns",
            measured slipped.as_ref().map(|(there, _)| fewer(there.t)), within 1e-9 * (1.0 + 1.0 / r.abs()),
            at_work slipped.as_ref().map(|(_, work)| *work);
        "a radius off by 0.01 mm": "dR/R2" = edge, costs edge / r.abs(), "turns a circuit", beside "turns",
            measured worn.as_ref().map(|run| fewer(run.end_time())), within 1e-9 * (1.0 + 1.0 / r.abs()),
            at_work worn.as_ref().map(Solution::work);
    }
}

/// The accuracy strip: where the mark of the coin is after a circuit.
fn accuracy(p: &Parameters, report: &mut Report) -> Result<()> {
    let (r, asked) = (ratio(p)?, [p.tolerance, 1e-6, 1e-8, 1e-10, 1e-12, 1e-15]);
    let at = move |part: f64| place(r, part * TAU, r, 0.0);
    let error = move |run: &Solution<6>| {
        let ([.., x, y, _, _], [u, v]) = (*run.end_state(), at(1.0));
        Ok(hypot(x - u, y - v))
    };
    report.in_closed_form(at);
    report.stepped(asked, move |step| rolled(r, TAU, step), Solution::work, error)
}

example! {
    ch15_ex3_coins: "Exercise 15.3: a coin that rolls around a fixed coin of another size";
    "Coins of two sizes", "A coin rolls without slipping around a fixed coin, or inside a fixed ring.",
    [claims, rubbed, limits, effects, accuracy];
    figures::figures, figures::trajectory, figures::moving_picture
}
