//! Exercise 16.4: a disc falls and unwinds from a string, to the end of the string and over it.

#[path = "ch16_ex4_unwinding_disc/figures.rs"]
mod figures;
#[path = "ch16_ex4_unwinding_disc/physics.rs"]
pub mod physics;

use core::f64::consts::{FRAC_PI_2, PI};
use kit::interval::above_to;
use kit::prelude::*;
use kit::{driven_in_air, taken_by_air};
use physics::*;
use rotation_dynamics::exact::{Modulus, legendre};
use rotation_dynamics::planar::Run;

parameters! {
    /// The disc of the exercise; the notes leave all numbers open.
    pub struct Parameters {
        /// mass of the disc
        mass: number(3.0, "kg", above(0.0).usually(0.5, 5.0)).drawn(1.0, 5.0, 0.5);
        /// its radius, on which the string is wound
        radius: number(0.2, "m", above(0.0).usually(0.05, 0.25)).drawn(0.10, 0.25, 0.01);
        /// its moment of inertia over M R^2: 1/2 for a disc, 1 for a hoop
        shape: number(0.5, "-", above(0.0).usually(0.3, 2.0)).open("shape: I/(M R^2)", "mass at the middle", "mass at the rim");
        /// length of the string that is wound up
        wound: number(1.0, "m", above(0.0).usually(0.9, 3.0)).drawn(0.8, 2.0, 0.1).open("length of the wound string", "short", "long");
        /// length between the roof and the disc at the start
        free: number(0.3, "m", above(0.0).usually(0.25, 2.0));
        /// when the velocities are asked for
        time: number(0.5, "s", above(0.0).usually(0.1, 0.55)).drawn(0.20, 0.45, 0.05);
        /// E A of a string that gives: of nylon, 2 mm thick
        stiffness: number(9400.0, "N", above(0.0).usually(1000.0, 50000.0));
        gravity: gravity(above(0.0).usually(1.0, 11.0));
        /// drag coefficient of a disc of steel in air, for the claims about it
        air: effect(1.0, "-", above_to(0.0, 1e3).because("more is a parachute"));
        tolerance: step(1e-14, 1e-6);
    }
}

/// The disc in units of its radius, and of its mass and g.
pub fn disc(p: &Parameters) -> Result<Disc> {
    let (wound, free, shape) = (p.wound / p.radius, p.free / p.radius, p.shape);
    allowed! {
        "wound/radius": wound, from_to(0.5, 1e6), "with less string it is not wound up again on the other side";
        "free/radius": free, above_to(1.0, 1e6), "at 1 the disc touches the roof";
        "time": p.time, from_to(0.0, unwound(p, p.wound)), "then no string is left to unwind";
        "shape": shape, from_to(1e-3, 1e3), "all mass near the axis falls, far from it hangs";
    }?;
    Ok(Disc { shape, wound, free })
}

/// The largest tension over the weight if the string is so long that it stays vertical.
pub fn long_peak(d: &Disc) -> f64 {
    1.0 + 2.0 * (d.wound + 1.0) / d.shape
}

fn claims(p: &Parameters, report: &mut Report) -> Result<()> {
    let (d, [a, pull], bound) = (disc(p)?, fall(p), 1e3 * p.tolerance);
    let (g, weight, k) = (p.gravity, p.mass * p.gravity, p.shape);
    let (second, speed) = ((p.radius / g).sqrt(), (p.radius * g).sqrt());
    let run = d.run(p.tolerance)?;
    let [_, _, _, _, fall, spin] = run.at(p.time / second)?.1;
    let ends = run.transition("all unwound")?;
    let taut = d.taut(Leaves::Unwinding, &ends.before);
    let (v, w) = (a * p.time, a * p.time / p.radius);
    let end = unwound(p, p.wound);
    let last = a * end;
    // What follows, by two routes.
    let over = run.transition("winds up")?;
    let (peak, [turn, largest, wound_up, rises]) = (d.peak(&run)?, d.by_angles(1e-14)?);
    let firm = p.stiffness / weight;
    // A string that gives by a radius or more, or hardly at all, is not followed.
    let gives = peak * d.length() / firm < 1.0 && firm < 1e7;
    let [soft, stored] = if gives { d.softly(&ends.before, firm, 1e-14)? } else { [1.0; 2] };
    let climbed = run.transition("top").map(|top| {
        [p.radius * d.taut(Leaves::Winding, &top.before).margin, (top.t - over.t) * second]
    });
    let (climbs, [climb, rise]) = (climbed.is_ok(), climbed.unwrap_or([0.0; 2]));
    let (long, upright) = (long_peak(&d), long_string(k, d.wound, 1e-14)?[0]);
    claims! { report,
        /// acceleration of the centre, downward
        a: a, "m/s^2", "simulated" => -g * taut.acceleration[1], within bound * g, in "While the string unwinds":
            g => "the string pulls as well", g / k => "the weight has no moment about the centre; which force turns the disc?",
            weight * k / (1.0 + k) / p.mass => "that is the tension over the mass";
        /// tension
        tension: pull, "N", "simulated" => weight * taut.tension, within bound * weight, in "While the string unwinds":
            weight => "then the disc would not fall",
            weight / (1.0 + k) => "that is the mass times the acceleration, and the string pulls upward";
        /// velocity of the centre at that time
        v: v, "m/s", "simulated" => -speed * fall, within bound * v, in "While the string unwinds":
            g * p.time => "the string pulls as well";
        /// angular velocity at that time
        omega: w, "rad/s", "simulated" => spin / second, within bound * w, in "While the string unwinds":
            v => "divide by the radius", g * p.time / p.radius => "the string pulls as well",
            w / (2.0 * PI) => "not turns but radians a second";
        /// part of the kinetic energy that is in the rotation
        rotation: k / (1.0 + k), "-", "simulated" => k * spin * spin / (fall * fall + k * spin * spin), within bound,
        in "While the string unwinds":
            k => "that is its ratio to the other part";
        /// when all string is unwound
        t_end: end, "s", "located event" => ends.t * second, within bound * end, in "At the end of the string":
            (2.0 * p.wound / g).sqrt() => "it does not fall freely";
        /// velocity then
        v_end: last, "m/s", "located event" => -speed * ends.before[4], within bound * last, in "At the end of the string":
            (2.0 * g * p.wound).sqrt() => "part of the energy is in the rotation";
        /// angular velocity then
        omega_end: last / p.radius, "rad/s", "located event" => ends.before[5] / second, within bound * last / p.radius,
        in "At the end of the string":
            (2.0 * g * p.wound).sqrt() / p.radius => "part of the energy is in the falling, part in the rotation";
        /// time in which the disc turns over the knot
        turn: (over.t - ends.t) * second, "s", "Lagrange, in angles" => turn * second, within 10.0 * bound * second;
        /// largest tension on the way
        peak: weight * peak, "N", "Lagrange, in angles" => weight * largest, within 10.0 * bound * weight * peak;
        /// the same over the weight
        peak_weights: peak, "-", "Lagrange, in angles" => largest, within 10.0 * bound * peak;
        /// the same on a very long string
        peak_long: long, "-", "upright string, simulated" => upright, within bound * long, in "At the end of the string":
            1.0 + 2.0 * d.wound / (1.0 + k) => "at its lowest point the disc turns faster than before";
        /// largest tension of a string that gives
        peak_soft: weight * soft, "N", "energy stored in it" => weight * stored, within 1e-9 * weight * soft, if gives;
        /// string that is wound up again at the top
        climb: climb, "m", "Lagrange, in angles" => p.radius * wound_up, within 1e2 * bound * p.wound, if climbs;
        /// the time this takes
        rise: rise, "s", "Lagrange, in angles" => rises * second, within 1e2 * bound * rise, if climbs;
    }
}

fn limits(_: &Parameters, report: &mut Report) -> Result<()> {
    let rest = Parameters::default();
    let over_g = |shape| fall(&rest.but(|p| (p.shape, p.gravity) = (shape, 1.0)))[0];
    let long = Disc { shape: 0.5, wound: 5.0, free: 1e6 };
    let (run, [_, _, climb, _]) = (long.run(1e-14)?, long.by_angles(1e-14)?);
    let quarter = legendre::e(FRAC_PI_2, Modulus::from_k((1.0_f64 / 1.5).sqrt())?)?;
    let swift = long_string(0.5, 1e6, 1e-14)?[1] * (2.0 * 1e6_f64 / 1.5).sqrt();
    limits! { report,
        /// all mass at the rim: M g s = M v^2
        "hoop: a/g": over_g(1.0) => 0.5, within 1e-15;
        /// a point on a thread falls freely
        "I/(M R^2) = x: a/g": over_g(1e-9) => 1.0, within 1e-8;
        /// it hangs still
        "I/(M R^2) = 1/x: a/g": over_g(1e9) => 0.0, within 1e-8;
        /// nothing pulls sideways: 1 + 2 (s_0 + R) M R/I
        "string of 1e6 R: peak/(M g)": long.peak(&run)? => 25.0, within 1e-4;
        /// and the disc comes back to where it started
        "string of 1e6 R: part wound up again": climb / 5.0 => 1.0, within 1e-6;
        /// no gravity in the turn: 2 E(1/(1 + k)), an elliptic integral
        "1e6 R wound up: turn v/R": swift => 2.0 * quarter, within 2e-6;
    }
}

/// How wide the disc is, of steel.
fn width(p: &Parameters) -> f64 {
    p.mass / (7850.0 * PI * p.radius * p.radius)
}

/// What `--with air` adds: it takes longer, and ends slower.
fn blown(p: &Parameters, report: &mut Report) -> Result<()> {
    let Some(drag) = p.air else { return Ok(()) };
    let driven = [fall(p)[0], p.mass * (1.0 + p.shape), p.wound];
    driven_in_air(report, [drag, 2.0 * p.radius * width(p)], driven)
}

/// A nylon line of 2 mm (3 GPa: E A = 9400 N; 1150 kg/m^3), a disc of steel, the air.
fn effects(p: &Parameters, report: &mut Report) -> Result<()> {
    let (d, [a, pull], weight) = (disc(p)?, fall(p), p.mass * p.gravity);
    let (k, area, thick, hangs) = (p.shape, 1e-6 * PI, 1e-3 / p.radius, pull / p.stiffness);
    let string = 1150.0 * area * p.wound / p.mass;
    let run = d.run(p.tolerance)?;
    let (start, peak) = (run.transition("all unwound")?.before, d.peak(&run)?);
    let firm = p.stiffness / weight;
    let jerked = peak * d.length() / firm;
    // If it gives by a radius or more, the turn is another; if hardly at all, it is the same.
    let spared = match (jerked < 1.0, firm < 1e7) {
        (true, true) => (1.0 - d.softly(&start, firm, 1e-12)?[0] / peak).abs(),
        (true, false) => 0.0,
        (false, _) => 1.0,
    };
    let last = a * unwound(p, p.wound);
    let air = 0.5 * 1.204 * 2.0 * p.radius * width(p) * last * last / weight;
    effect_card! { report,
        "stretch of the string, at the turn": "T_max l/(R E A)" = jerked, costs spared, "of T_max";
        "thickness of the string": "d/(2 R)" = thick, costs 2.0 * thick * k / (1.0 + k), "of a";
        "mass of the string": "m/M" = string, costs string * (1.0 - k).abs() / (1.0 + k), "of a, at the start";
        "stretch of the string, in the fall": "T/(E A)" = hangs, costs hangs, "of the way";
        "air drag, at the end": "rho C S v^2/(2 M g)" = air, costs air, "of a, at the end", measured taken_by_air(air)?;
    }
}

/// The accuracy strip: the string that is wound up at the top, by Newton's law.
fn accuracy(p: &Parameters, report: &mut Report) -> Result<()> {
    let (d, [a, _], end, radius) = (disc(p)?, fall(p), unwound(p, p.wound), p.radius);
    let [_, _, climb, _] = d.by_angles(1e-15)?;
    let error = move |run: &Run<Leaves, 6>| {
        let start = run.pieces()[0].solution.end_state();
        let last = run.transitions().last().map_or(start, |event| &event.before);
        Ok(d.taut(Leaves::Winding, last).margin / climb - 1.0)
    };
    report.in_closed_form(move |part| [a * (part * end), a * (part * end) / radius]);
    let asked = [p.tolerance, 1e-6, 1e-8, 1e-10, 1e-12, 1e-15];
    report.stepped(asked, move |step| d.run(step), Run::work, error)
}

example! {
    ch16_ex4_unwinding_disc: "Exercise 16.4: a disc falls and unwinds from a string";
    "A disc on a string", "A disc falls and unwinds from a string, to the end of the string and over it.",
    [claims, blown, limits, effects, accuracy];
    figures::figures, figures::trajectory, figures::moving_picture
}
