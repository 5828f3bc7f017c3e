//! Exercise 16.1: Atwood's machine with a heavy pulley.

#[path = "ch16_ex1_atwood/figures.rs"]
mod figures;
#[path = "ch16_ex1_atwood/physics.rs"]
pub mod physics;

use core::f64::consts::PI;
use kit::prelude::*;
use kit::{driven_in_air, taken_by_air};
use physics::{Grip, Machine, capstan};
use rotation_dynamics::math::asinh;
use rotation_dynamics::planar::{Run, Transition};

parameters! {
    /// The machine of the exercise; the notes leave all numbers open, and the radius of the pulley.
    pub struct Parameters {
        /// the mass on the left
        m1: number(3.0, "kg", above(0.0).usually(2.1, 5.0)).drawn(2.5, 4.0, 0.1).open("mass on the left", "nearly balanced", "heavy");
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
        friction: number(0.2, "-", from_to(0.0, 10.0).because("rougher than any rope").usually(0.0, 0.5)).drawn(0.10, 0.30, 0.05).open("friction of rope and pulley", "slips long", "holds soon");
        /// mass of a metre of the heavy rope
        rope: number(0.1, "kg/m", above(0.0).usually(0.01, 0.5));
        /// angular velocity of a pulley that spins already
        spin: number(40.0, "rad/s", at_least(0.0).because("for the other sense exchange the masses").usually(5.0, 80.0)).open("spin of the pulley at the start", "slow", "fast");
        /// C S of both masses in air, for the claims about it
        air: effect(0.02, "m^2", above_to(0.0, 10.0).because("more is a parachute"));
        tolerance: step(1e-13, 1e-3);
    }
}

/// The grip of a rope that is glued.
pub const FIRM: f64 = 1e9;

/// The machine of these parameters, with a rope without mass.
pub fn machine(p: &Parameters) -> Result<Machine> {
    let (heavier, lighter, pulley) =
        (p.m1.max(p.m2), p.m1.min(p.m2), p.inertia / (p.radius * p.radius));
    allowed! {
        "lighter mass/heavier mass": lighter / heavier, from_to(1e-9, 1.0), "a lighter one is not felt";
        "(m1 - m2)/m": (heavier - lighter) / heavier, from_to(1e-12, 1.0), "equal masses rest, and less is lost in their rounding";
        "I/(m R^2) with the heavier mass m": pulley / heavier, from_to(0.0, 1e6), "a heavier pulley hardly turns";
        "mass of the rope/heavier mass": 2.0 * p.rope * p.height / heavier, from_to(0.0, 1e6), "beside a heavier rope the masses are not felt";
    }?;
    let (masses, gravity, height, grip) = ([p.m1, p.m2], p.gravity, p.height, exp(p.friction * PI));
    Ok(Machine { masses, pulley, gravity, grip, rope: 0.0, height })
}

/// A motion from rest whose acceleration, `a` at first, grows with the way by `k2`: the time and
/// the speed at its end, from `way = (a/k2) (cosh(k t) - 1)`.
pub fn growing([a, k2]: [f64; 2], way: f64) -> [f64; 2] {
    let x = k2 * way / a;
    [2.0 * asinh((0.5 * x).sqrt()) / k2.sqrt(), (a * way * (2.0 + x)).sqrt()]
}

/// The machine with the heavy rope, which holds; its acceleration at the start, and how that grows
/// with the way.
fn heavy(p: &Parameters) -> Result<(Machine, [f64; 2])> {
    let m = machine(p)?.but(|m| (m.rope, m.grip) = (p.rope, FIRM));
    let sum = p.m1 + p.m2 + m.pulley + 2.0 * p.rope * p.height;
    let drive = [(p.m1 - p.m2).abs(), 2.0 * p.rope];
    Ok((m, drive.map(|mass| mass * p.gravity / sum)))
}

fn claims(p: &Parameters, report: &mut Report) -> Result<()> {
    let m = machine(p)?;
    let ([m1, m2], g, h) = (m.masses, m.gravity, m.height);
    let (whole, bound) = (m1 + m2 + m.pulley, 1e2 * p.tolerance.max(1e-14));
    let (heavier, driven) = (m1.max(m2), (m1 - m2).abs());
    let firm = m.but(|m| m.grip = FIRM);
    let ((grip, [a, rim, t1, t2]), (_, [.., one, other])) = (m.closed_form(), firm.closed_form());
    // The friction that is enough: in closed form, and by pieces of rope.
    let ratio = one.max(other) / one.min(other);
    let [.., one, other] = firm.forces(Grip::Holds, 0.0);
    let slips = |mu| Ok::<_, kit::Error>(one.max(other) > capstan(mu)? * one.min(other));
    let simulated = Machine { grip: capstan(p.friction)?, ..m };
    let found = simulated.forces(grip, 0.0);
    let ends = |machine: Machine, rim: f64, name, end: f64| -> Result<Transition<Grip, 4>> {
        Ok(machine.run(rim, p.tolerance, end)?.transition(name)?.clone())
    };
    let (time, fall) = ((2.0 * h / a.abs()).sqrt(), (2.0 * h * a.abs()).sqrt());
    let arrives = ends(simulated, 0.0, "arrives", 2.0 * time)?;
    let (roped, drive) = heavy(p)?;
    let [long, fast] = growing(drive, h);
    let weighed = ends(roped, 0.0, "arrives", 2.0 * long)?;
    // Nearly equal masses: a difference drives them, and has lost digits. An early error grows.
    let late = |rope: f64| (1.0 + rope / driven) * (1e-4 * (whole + 2.0 * rope) / driven).max(1.0);
    let [close, late] = [0.0, p.rope * h].map(|rope| 10.0 * bound * late(rope));
    // The pulley spins, and the rope is behind.
    let (k, part) = (m.grip, g / (m.grip * m1 + m2));
    let drawn = (k * m1 - m2) * part;
    let braked = 2.0 * m1 * m2 * part * (k - 1.0) / m.pulley;
    let catch = p.spin * p.radius / (drawn + braked);
    let until = 2.0 * (h / drawn.abs()).sqrt().min(1e3 * catch) + 2.0 * catch;
    let caught = || ends(simulated, p.spin * p.radius, "catches", until);
    let early = catch > 0.0 && 0.5 * drawn.abs() * catch * catch < 0.99 * h;
    let reached = early && k > 1.0 && grip == Grip::Holds;
    // Wrong: one tension.
    let (naive, one) = ((m1 - m2) * g / (m1 + m2), 2.0 * m1 * m2 * g / (m1 + m2));
    let light = firm.but(|m| m.pulley = 0.0).forces(Grip::Holds, 0.0);
    claims! { report,
        /// acceleration of the masses
        a: a, "m/s^2", "Newton for each body" => found[0], within bound * g, in "The acceleration":
            naive => "the pulley has to be turned as well",
            (m1 - m2) * g / (m1 + m2 + p.inertia) => "kilograms and kg m^2 cannot be added",
            (m1 - m2) * g / (m1 + m2 + 0.5 * m.pulley) => "I is given; it is no disc of that mass";
        /// angular acceleration of the pulley
        alpha: rim / p.radius, "rad/s^2", "Newton for each body" => found[1] / p.radius, within bound * g * (1.0 + heavier / m.pulley.max(1e-6 * heavier)) / p.radius,
        in "The acceleration":
            rim * p.radius => "a rim runs at R times the angular velocity";
        /// tension on the side of m1
        t1: t1, "N", "Newton for each body" => found[2], within bound * heavier * g, in "The tensions":
            one => "with one tension nothing would turn the pulley", m1 * g => "that mass is accelerated",
            m1 * (g + a) => "which way is it accelerated?", t2 => "that is the other side";
        /// tension on the side of m2
        t2: t2, "N", "Newton for each body" => found[3], within bound * heavier * g, in "The tensions":
            one => "with one tension nothing would turn the pulley", m2 * g => "that mass is accelerated",
            t1 => "that is the other side";
        /// load on the axle, without the weight of the pulley
        load: t1 + t2, "N", "Newton for each body" => found[2] + found[3], within 2.0 * bound * heavier * g, in "The tensions":
            (m1 + m2) * g => "the centre of mass is accelerated";
        /// friction that holds the rope, at least
        mu_least: log(ratio) / PI, "-", "pieces of rope, bisected" => try_bisect([0.0, 10.0], 1e-12, slips)?[1], within 1e-11, in "The rope":
            (ratio - 1.0) / PI => "the tension grows along the rope", log(ratio) / (2.0 * PI) => "it lies on half of the rim";
        /// time until the lighter mass is level with the axle
        time: time, "s", "located event" => arrives.t, within close * time, in "The rope":
            (2.0 * h / g).sqrt() => "they do not fall freely";
        /// speed then
        speed: fall, "m/s", "simulated" => arrives.before[1].abs(), within close * fall, in "The rope":
            (2.0 * h * g).sqrt() => "they do not fall freely";
        /// the same time with the heavy rope
        heavy_time: long, "s", "located event" => weighed.t, within late * long;
        /// speed then
        heavy_speed: fast, "m/s", "simulated" => weighed.before[1].abs(), within late * fast;
        /// when the rope holds on a pulley that spun
        catch: catch, "s", "located event" => caught()?.t, within 10.0 * bound * (catch + 1.0), if reached;
        /// speed then
        catch_speed: drawn * catch, "m/s", "simulated" => caught()?.before[1], within 10.0 * bound * (g * catch + 1.0), if reached;
        /// wrong: acceleration with one tension
        naive_a: naive, "m/s^2", "Newton, no pulley" => light[0], within bound * g;
        /// wrong: that tension
        naive_tension: one, "N", "Newton, no pulley" => light[2], within bound * heavier * g;
    }
}

fn limits(p: &Parameters, report: &mut Report) -> Result<()> {
    let (m, unit) = (machine(p)?, machine(&Parameters::default())?);
    let with = |pulley: f64, m2: f64| {
        Machine { masses: [1.0, m2], pulley, gravity: 1.0, grip: FIRM, ..unit }.closed_form().1
    };
    let ([.., l1, l2], [.., h1, h2]) = (with(0.0, 0.5), with(1e9, 0.5));
    // A rope without friction does not know the pulley.
    let (_, [smooth, ..]) = m.but(|m| m.grip = 1.0).closed_form();
    let one = (p.m1 - p.m2) * p.gravity / (p.m1 + p.m2);
    limits! { report,
        /// one tension, 2 m1 m2 g/(m1 + m2)
        "I = 0: T1/T2": l1 / l2 => 1.0, within 1e-15;
        /// nothing moves, the rope carries the weight
        "I = 1/x: T1/(m1 g)": h1 => 1.0, within 1e-9;
        /// and on the other side
        "I = 1/x: T2/(m2 g)": h2 / 0.5 => 1.0, within 1e-8;
        /// a weight that unwinds from a disc of mass m1: 2/3 g
        "m2 = 0, I = m1 R^2/2: a/g": with(0.5, 1e-9)[0] => 2.0 / 3.0, within 1e-8;
        /// a smooth pulley does not turn
        "mu = 0: a (m1 + m2)/((m1 - m2) g)": smooth / one => 1.0, within 1e-15;
    }
}

/// What `--with air` adds: it takes longer, and ends slower.
fn blown(p: &Parameters, report: &mut Report) -> Result<()> {
    let (Some(area), m) = (p.air, machine(p)?) else { return Ok(()) };
    let (grip, [a, ..]) = m.closed_form();
    let told =
        "the claims about the air are for a rope that holds: more friction, or a lighter pulley";
    require(grip == Grip::Holds, "the acceleration of a rope that slips, with air", a, told)?;
    driven_in_air(report, [1.0, area], [a.abs(), p.m1 + p.m2 + m.pulley, p.height])
}

/// A rope 8 mm thick, a bearing that rubs, the air.
fn effects(p: &Parameters, report: &mut Report) -> Result<()> {
    let m = machine(p)?;
    let (_, [a, _, t1, t2]) = m.closed_form();
    let (whole, driving) = (p.m1 + p.m2 + m.pulley, (p.m1 - p.m2).abs() * p.gravity);
    let rope = 2.0 * p.rope * p.height / whole;
    // An axle of 5 mm that rubs with 0.1 under the load and the weight of a disc.
    let load = t1 + t2 + 2.0 * m.pulley * p.gravity;
    let bearing = 0.1 * 0.005 / p.radius * load / driving;
    let speed = (2.0 * p.height * a.abs()).sqrt();
    let air = 0.5 * 1.204 * 0.02 * speed * speed / driving;
    let (thick, stretch) = (0.004 / p.radius, t1 / (1e9 * 1.6e-5 * PI));
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
    let ((roped, drive), h) = (heavy(p)?, p.height);
    let [time, _] = growing(drive, h);
    let asked = [p.tolerance, 1e-3, 1e-6, 1e-9, 1e-12, 1e-15];
    report.in_closed_form(move |part| growing(drive, part * h));
    let error = move |run: &Run<Grip, 4>| Ok(run.transition("arrives")?.t / time - 1.0);
    report.stepped(asked, move |step| roped.run(0.0, step, 2.0 * time), Run::work, error)
}

example! {
    ch16_ex1_atwood: "Exercise 16.1: Atwood's machine with a heavy pulley";
    "Atwood's machine", "Two masses hang on a rope over a pulley that has a moment of inertia.",
    [claims, blown, limits, effects, accuracy];
    figures::figures, figures::trajectory, figures::moving_picture
}
