//! Exercise 16.1: Atwood's machine with a heavy pulley.

#[path = "ch16_ex1_atwood/figures.rs"]
mod figures;
#[path = "ch16_ex1_atwood/machine.rs"]
pub mod machine;

use core::f64::consts::PI;
use kit::prelude::*;
use kit::{driven_in_air, taken_by_air};
use machine::{Forces, Grip, Machine, capstan};
use rotation_dynamics::math::asinh;
use rotation_dynamics::planar::{Run, Transition};

parameters! {
    /// The machine of the exercise; the notes leave all numbers open, and the radius of the pulley.
    pub struct Parameters {
        /// the mass on the left
        m1: number(3.0, "kg", above(0.0).usually(2.1, 5.0)).drawn(2.5, 4.0, 0.1);
        /// the mass on the right
        m2: number(2.0, "kg", above(0.0).usually(0.5, 2.9)).drawn(1.0, 2.4, 0.1);
        /// moment of inertia of the pulley
        inertia: number(0.02, "kg m^2", at_least(0.0).usually(0.001, 0.1)).drawn(0.005, 0.030, 0.005);
        /// radius of the pulley
        radius: number(0.1, "m", above(0.0).usually(0.05, 0.2)).drawn(0.08, 0.15, 0.01);
        gravity: gravity(above(0.0).usually(1.0, 25.0));
        /// how far both masses hang below the axle
        height: number(1.0, "m", above(0.0).usually(0.3, 3.0)).drawn(0.5, 2.0, 0.1);
        /// coefficient of friction between rope and pulley
        friction: number(0.2, "-", from_to(0.0, 10.0).because("rougher than any rope").usually(0.0, 0.5)).drawn(0.10, 0.30, 0.05);
        /// mass of a metre of the heavy rope
        rope: number(0.1, "kg/m", at_least(0.0).usually(0.01, 0.5));
        /// angular velocity of a pulley that spins already
        spin: number(40.0, "rad/s", any().usually(5.0, 80.0));
        /// C S of both masses in air, for the claims about it
        air: effect(0.02, "m^2", above_to(0.0, 10.0).because("more is a parachute"));
        tolerance: step(1e-13, 1e-3);
    }
}

/// The grip of a rope that is glued.
pub const FIRM: f64 = 1e9;

/// The machine of these parameters, with a rope without mass.
pub fn machine(p: &Parameters) -> Result<Machine> {
    let (heavier, lighter, rope) = (p.m1.max(p.m2), p.m1.min(p.m2), 0.0);
    let (pulley, apart) = (p.inertia / (p.radius * p.radius), heavier - lighter);
    allowed! {
        "lighter mass/heavier mass": lighter / heavier, from_to(1e-9, 1.0), "a lighter one is not felt";
        "(m1 - m2)/m": if apart == 0.0 { 1.0 } else { apart / heavier },
            from_to(1e-12, 1.0), "less is lost in the rounding of the masses";
        "I/(m R^2) with the heavier mass m": pulley / heavier, from_to(0.0, 1e6), "a heavier pulley hardly turns";
        "mass of the rope/heavier mass": 2.0 * p.rope * p.height / heavier,
            from_to(0.0, 1e6), "beside a heavier rope the masses are not felt";
    }?;
    let (masses, gravity, height, grip) = ([p.m1, p.m2], p.gravity, p.height, exp(p.friction * PI));
    Ok(Machine {
        masses,
        pulley,
        gravity,
        grip,
        rope,
        height,
    })
}

/// The smallest coefficient that holds, between those that do and do not.
fn least_friction(m: Machine) -> Result<f64> {
    let [one, other] = m.forces(Grip::Holds, 0.0).tensions;
    let (first, second) = (one.max(other), one.min(other));
    let slips = |friction| Ok::<_, kit::Error>(first > capstan(friction)? * second);
    Ok(try_bisect([0.0, 10.0], 1e-12, slips)?[1])
}

/// A motion from rest whose acceleration, `a` at first, grows with the way by `k2`: the time and
/// the speed at its end, from `way = (a/k2) (cosh(k t) - 1)`.
pub fn growing(a: f64, k2: f64, way: f64) -> [f64; 2] {
    let x = k2 * way / a;
    if x == 0.0 {
        return [(2.0 * way / a).sqrt(), (2.0 * way * a).sqrt()];
    }
    let time = 2.0 * asinh((0.5 * x).sqrt()) / k2.sqrt();
    [time, (a * way * (2.0 + x)).sqrt()]
}

/// The motion of a rope of some mass that holds: its acceleration at the start, and how it grows
/// with the way.
fn heavy(m: &Machine, rope: f64) -> [f64; 2] {
    let sum = m.masses[0] + m.masses[1] + m.pulley + 2.0 * rope * m.height;
    let driven = (m.masses[0] - m.masses[1]).abs();
    [driven * m.gravity / sum, 2.0 * rope * m.gravity / sum]
}

fn claims(p: &Parameters, report: &mut Report) -> Result<()> {
    let m = machine(p)?;
    let ([m1, m2], g, h, held, a) = (
        m.masses,
        m.gravity,
        m.height,
        Forces::held(&m),
        Forces::new(&m),
    );
    let (whole, bound) = (m1 + m2 + m.pulley, 1e2 * p.tolerance.max(1e-14));
    // Nearly equal masses: a difference drives them, and has lost digits.
    let (heavier, driven, side) = (m1.max(m2), (m1 - m2).abs(), (m1 - m2).signum());
    let close = (1e-4 * whole / driven).max(1.0);
    let grip = capstan(p.friction)?;
    let simulated = m.but(|m| m.grip = grip);
    let found = simulated.forces(a.grip, 0.0);
    let [t1, t2] = a.tensions;
    let ratio = held.tensions[0].max(held.tensions[1]) / held.tensions[0].min(held.tensions[1]);
    let (moves, size) = (m1 != m2, a.acceleration.abs());
    let (time, fall) = ((2.0 * h / size).sqrt(), (2.0 * h * size).sqrt());
    let ends = |machine: Machine, rim: f64, name, end: f64| -> Result<Transition<Grip, 4>> {
        let run = machine.run(rim, p.tolerance, end)?;
        Ok(run.transition(name)?.clone())
    };
    let arrives = || ends(simulated, 0.0, "arrives", 2.0 * time);
    // A rope of some mass, that holds.
    let [first, grows] = heavy(&m, p.rope);
    let [longer, faster] = growing(first, grows, h);
    // An early error grows with the way.
    let sum = whole + 2.0 * p.rope * h;
    let late = 10.0 * (1.0 + p.rope * h / driven) * (1e-4 * sum / driven).max(1.0);
    let roped = m.but(|m| (m.rope, m.grip) = (p.rope, FIRM));
    let weighed = || ends(roped, 0.0, "arrives", 2.0 * longer);
    // The pulley spins, and the rope is behind; against the sense of m1, it is ahead.
    let k = if p.spin < 0.0 { 1.0 / m.grip } else { m.grip };
    let part = g / (k * m1 + m2);
    let drawn = (k * m1 - m2) * part;
    let braked = 2.0 * m1 * m2 * part * (k - 1.0) / m.pulley;
    let catch = p.spin * p.radius / (drawn + braked);
    let until = 2.0 * (h / drawn.abs()).sqrt().min(1e3 * catch) + 2.0 * catch;
    let caught = || ends(simulated, p.spin * p.radius, "catches", until);
    let holds = catch > 0.0 && m.grip > 1.0 && a.grip == Grip::Holds;
    let reached = 0.5 * drawn.abs() * catch * catch < 0.99 * h && holds;
    let one = 2.0 * m1 * m2 * g / (m1 + m2);
    let light = m.but(|m| (m.pulley, m.grip) = (0.0, FIRM));
    let light = light.forces(Grip::Holds, 0.0);
    claims! { report,
        /// acceleration of the masses
        a: a.acceleration, "m/s^2", "Newton for each body" => found.acceleration, within bound * g,
        in "The acceleration":
            (m1 - m2) * g / (m1 + m2) => "the pulley has to be turned as well",
            (m1 - m2) * g / (m1 + m2 + p.inertia) => "kilograms and kg m^2 cannot be added",
            (m1 - m2) * g / (m1 + m2 + 0.5 * m.pulley) => "I is given; it is no disc of that mass";
        /// angular acceleration of the pulley
        alpha: a.rim / p.radius, "rad/s^2", "Newton for each body" => found.rim / p.radius, within bound * g * (1.0 + heavier / m.pulley.max(1e-6 * heavier)) / p.radius,
        in "The acceleration":
            a.rim * p.radius => "a rim runs at R times the angular velocity";
        /// tension on the side of m1
        t1: t1, "N", "Newton for each body" => found.tensions[0], within bound * heavier * g, in "The tensions":
            one => "with one tension nothing would turn the pulley",
            m1 * g => "that mass is accelerated",
            m1 * (g + a.acceleration) => "which way is it accelerated?",
            t2 => "that is the other side";
        /// tension on the side of m2
        t2: t2, "N", "Newton for each body" => found.tensions[1], within bound * heavier * g, in "The tensions":
            one => "with one tension nothing would turn the pulley",
            m2 * g => "that mass is accelerated",
            t1 => "that is the other side";
        /// load on the axle, without the weight of the pulley
        load: t1 + t2, "N", "Newton for each body" => found.tensions[0] + found.tensions[1], within 2.0 * bound * heavier * g, in "The tensions":
            (m1 + m2) * g => "the centre of mass is accelerated";
        /// friction that holds the rope, at least
        mu_least: log(ratio) / PI, "-", "pieces of rope, bisected" => least_friction(m)?, within 1e-11,
        in "The rope":
            (ratio - 1.0) / PI => "the tension grows along the rope",
            log(ratio) / (2.0 * PI) => "it lies on half of the rim";
        /// time until the lighter mass is level with the axle
        time: time, "s", "located event" => arrives()?.t, within 10.0 * bound * close * time, if moves, in "The rope":
            (2.0 * h / g).sqrt() => "they do not fall freely";
        /// speed then
        speed: fall, "m/s", "simulated" => side * arrives()?.before[1], within 10.0 * bound * close * fall, if moves, in "The rope":
            (2.0 * h * g).sqrt() => "they do not fall freely";
        /// the same time with the heavy rope
        heavy_time: longer, "s", "located event" => weighed()?.t, within late * bound * longer, if moves;
        /// speed then
        heavy_speed: faster, "m/s", "simulated" => side * weighed()?.before[1], within late * bound * faster, if moves;
        /// when the rope holds on a pulley that spun
        catch: catch, "s", "located event" => caught()?.t, within 10.0 * bound * (catch + 1.0), if reached;
        /// speed then
        catch_speed: drawn * catch, "m/s", "simulated" => caught()?.before[1], within 10.0 * bound * (g * catch + 1.0), if reached;
        /// wrong: acceleration with one tension
        naive_a: (m1 - m2) * g / (m1 + m2), "m/s^2", "Newton, no pulley" => light.acceleration, within bound * g;
        /// wrong: that tension
        naive_tension: one, "N", "Newton, no pulley" => light.tensions[0], within bound * heavier * g;
    }
}

/// Light pulleys and heavy ones.
fn limits(p: &Parameters, report: &mut Report) -> Result<()> {
    let (m, unit) = (machine(p)?, machine(&Parameters::default())?);
    let with = |pulley: f64, m2: f64| {
        let of = |m: &mut Machine| (m.masses, m.pulley, m.gravity) = ([1.0, m2], pulley, 1.0);
        Forces::held(&unit.but(of))
    };
    let (light, heavy, alone) = (with(0.0, 0.5), with(1e9, 0.5), with(0.5, 1e-9));
    // A rope without friction does not know the pulley.
    let m1 = if p.m1 == p.m2 { 2.0 * p.m2 } else { p.m1 };
    let smooth = Forces::new(&m.but(|m| (m.grip, m.masses) = (1.0, [m1, p.m2])));
    let one = (m1 - p.m2) * p.gravity / (m1 + p.m2);
    limits! { report,
        /// one tension, 2 m1 m2 g/(m1 + m2)
        "I = 0: T1/T2": light.tensions[0] / light.tensions[1] => 1.0, within 1e-15;
        /// nothing moves, the rope carries the weight
        "I = 1/x: T1/(m1 g)": heavy.tensions[0] => 1.0, within 1e-9;
        /// and on the other side
        "I = 1/x: T2/(m2 g)": heavy.tensions[1] / 0.5 => 1.0, within 1e-8;
        /// a weight that unwinds from a disc of mass m1: 2/3 g
        "m2 = 0, I = m1 R^2/2: a/g": alone.acceleration => 2.0 / 3.0, within 1e-8;
        /// a smooth pulley does not turn
        "mu = 0: a (m1 + m2)/((m1 - m2) g)": smooth.acceleration / one => 1.0, within 1e-15;
    }
}

/// What `--with air` adds: it takes longer, and ends slower.
fn blown(p: &Parameters, report: &mut Report) -> Result<()> {
    let Some(area) = p.air else { return Ok(()) };
    let (m, a) = (machine(p)?, Forces::new(&machine(p)?));
    let told = "the claims about the air are for a rope that holds and moves: more friction, \
                a lighter pulley, or unequal masses";
    let name = "the acceleration of a rope that slips or rests, with air";
    let moves = a.grip == Grip::Holds && p.m1 != p.m2;
    require(moves, name, a.acceleration, told)?;
    let driven = [a.acceleration.abs(), p.m1 + p.m2 + m.pulley, p.height];
    driven_in_air(report, [1.0, area], driven)
}

/// A rope 8 mm thick, a bearing that rubs, the air.
fn effects(p: &Parameters, report: &mut Report) -> Result<()> {
    let m = machine(p)?;
    let (a, whole) = (Forces::new(&m), p.m1 + p.m2 + m.pulley);
    if p.m1 == p.m2 {
        return Ok(()); // nothing moves
    }
    let driving = (p.m1 - p.m2).abs() * p.gravity;
    let speed = (2.0 * p.height * a.acceleration.abs()).sqrt();
    let rope = 2.0 * p.rope * p.height / whole;
    // An axle of 5 mm that rubs with 0.1 under the load and the weight of a disc.
    let load = a.tensions[0] + a.tensions[1] + 2.0 * m.pulley * p.gravity;
    let bearing = 0.1 * 0.005 / p.radius * load / driving;
    let air = 0.5 * 1.204 * 0.02 * speed * speed / driving;
    let thick = 0.004 / p.radius;
    let stretch = a.tensions[0] / (1e9 * 1.6e-5 * PI);
    effect_card! { report,
        "mass of the rope": "2 lambda h/M" = rope, costs rope, "of a, at the start";
        "friction of the bearing": "mu_b r F/(R (m1 - m2) g)" = bearing, costs bearing, "of a";
        "thickness of the rope": "d/(2 R)" = thick, costs 2.0 * thick * m.pulley / whole, "of a";
        "air drag, at the end": "rho C S v^2/(2 (m1 - m2) g)" = air, costs air, "of a, at the end", measured taken_by_air(air)?;
        "stretch of the rope": "T1/(E A)" = stretch, costs stretch, "of the way";
    }
}

/// The accuracy strip: when the heavy rope is through.
fn accuracy(p: &Parameters, report: &mut Report) -> Result<()> {
    let m = machine(p)?;
    if p.m1 == p.m2 {
        return Ok(()); // nothing moves
    }
    let ([a, k2], h) = (heavy(&m, p.rope), p.height);
    let roped = m.but(|m| (m.rope, m.grip) = (p.rope, FIRM));
    let time = growing(a, k2, h)[0];
    let asked = [p.tolerance, 1e-3, 1e-6, 1e-9, 1e-12, 1e-15];
    report.in_closed_form(move |part| growing(a, k2, part * h));
    let error = move |run: &Run<Grip, 4>| Ok(run.transition("arrives")?.t / time - 1.0);
    let run = move |step| roped.run(0.0, step, 2.0 * time);
    report.stepped(asked, run, Run::work, error)
}

example! {
    ch16_ex1_atwood: "Exercise 16.1: Atwood's machine with a heavy pulley";
    "Atwood's machine", "Two masses hang on a rope over a pulley that has a moment of inertia.",
    [claims, blown, limits, effects, accuracy];
    figures::figures, figures::trajectory, figures::moving_picture
}
