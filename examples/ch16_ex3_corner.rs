//! Exercise 16.3: a spinning cylinder is set down in a corner.

#[path = "ch16_ex3_corner/figures.rs"]
mod figures;
#[path = "ch16_ex3_corner/physics.rs"]
pub mod physics;

use core::f64::consts::{SQRT_2, TAU};
use kit::prelude::*;
use physics::*;
use rotation_dynamics::planar::contact::MechanismState;

parameters! {
    /// The cylinder of the exercise; the notes leave all numbers open.
    pub struct Parameters {
        /// radius of the cylinder
        radius: number(0.1, "m", above(0.0).usually(0.02, 0.5)).drawn(0.05, 0.20, 0.01);
        /// its mass
        mass: number(3.0, "kg", above(0.0).usually(0.1, 10.0)).drawn(1.0, 5.0, 0.5);
        /// coefficient of friction, on the floor and on the wall
        friction: number(0.25, "-", from_to(1e-9, 1e6).because("less is none, and then it spins for ever; more jams it").usually(0.05, 3.0)).drawn(0.15, 0.40, 0.05).open("coefficient of friction", "spins long", "stops at once");
        /// angular velocity at the start
        spin: number(60.0, "rad/s", any().usually(5.0, 100.0)).drawn(30.0, 80.0, 5.0);
        gravity: gravity(above(0.0).usually(1.0, 25.0));
        /// what changes: how friction falls with the slip speed s, as 1/(1 + fading s)
        fading: number(0.05, "s/m", at_least(0.0).usually(0.01, 0.5));
        /// the moving picture: the sense that presses it to the wall, or the other one
        sense: choice("pressed", "away").open("sense of the spin");
        /// angle by which the wall leans back, for the claims about it
        lean: effect(0.0175, "rad", above_to(0.0, 1.5).because("backward, and not down to the floor"));
        tolerance: step(1e-13, 1e-3);
    }
}

/// What the page computes with: the size of the spin, whose sign says on which side the wall is
/// to which it is pressed, in units of sqrt(g/R), and units of time, force, speed.
fn units(p: &Parameters) -> Result<[f64; 4]> {
    let time = (p.radius / p.gravity).sqrt();
    let spin = p.spin.abs() * time;
    let still = "without spin the cylinder stays at rest where it is set down";
    require(spin != 0.0, "spin", p.spin, still)?;
    allowed! {
        "spin sqrt(R/g)": spin, from_to(1e-9, 1e9), "the turn in rad while a stone falls by R/2";
        "fading*spin*radius": p.fading * p.spin.abs() * p.radius, from_to(0.0, 1e4), "beyond it a ten-thousandth of friction is left";
    }?;
    Ok([spin, time, p.mass * p.gravity, p.radius / time])
}

/// The cylinder of the page if its friction fades, and the time to its stop.
fn fading(p: &Parameters) -> Result<(Cylinder, f64)> {
    let [spin, _, _, speed] = units(p)?;
    let cylinder = Cylinder { fading: p.fading * speed, ..Cylinder::alike(p.friction) };
    Ok((cylinder, faded(p.friction, cylinder.fading, spin)))
}

/// Both senses, each to twice the time after which nothing changes any more.
fn senses(p: &Parameters) -> Result<[Ride; 2]> {
    let (cylinder, [w, ..]) = (Cylinder::alike(p.friction), units(p)?);
    let to = |spin: f64, until: f64| set_down(cylinder, spin, 2.0 * until, p.tolerance);
    Ok([to(w, w / cylinder.braking())?, to(-w, w / (3.0 * p.friction))?])
}

fn claims(p: &Parameters, report: &mut Report) -> Result<()> {
    let ([spin, time, weight, speed], mu) = (units(p)?, p.friction);
    let (unit, [pressed, away], exact) = (p.gravity / p.radius, senses(p)?, 1e-12);
    let (stops, rolls) = (pressed.event("floor sticks")?, away.event("floor sticks")?);
    let (halfway, MechanismState { v: [along, _, turning], .. }) = (0.5 * stops.t, rolls.after);
    let ([floor, wall], end) = (pressed.forces(halfway)?, pressed.at(pressed.end_time())?);
    let rubbed = [floor, wall].map(|force| -force.tangential * end.q[2]);
    let (n_floor, n_wall) = (weight / (1.0 + mu * mu), mu * weight / (1.0 + mu * mu));
    let alpha = 2.0 * mu * (1.0 + mu) / (1.0 + mu * mu) * unit;
    let fast = p.spin.abs();
    let (stop, roll) = (fast / alpha, fast * p.radius / (3.0 * mu * p.gravity));
    let (turns, v_roll) = (0.5 * stop * fast / TAU, fast * p.radius / 3.0);
    let heat = 0.25 * p.mass * p.radius * p.radius * p.spin * p.spin;
    let (slower, fade) = fading(p)?;
    claims! { report,
        /// force of the floor
        n_floor: n_floor, "N", "contact forces" => floor.normal * weight, within exact * n_floor, in "Pressed to the wall":
            weight => "the wall rubs as well: which way?",
            weight / (1.0 - mu * mu).abs().max(1e-3) => "which way does the surface slip along the wall?",
            n_wall => "that is the other one";
        /// force of the wall
        n_wall: n_wall, "N", "contact forces" => wall.normal * weight, within exact * n_wall, in "Pressed to the wall":
            mu * weight => "the floor does not carry the whole weight", mu * n_wall => "that is the friction on the wall";
        /// angular deceleration
        alpha: alpha, "rad/s^2", "simulated" => (spin - pressed.at(halfway)?.v[2]) / halfway * unit,
        within 10.0 * exact * alpha, in "Pressed to the wall":
            0.5 * alpha => "that is for a thin tube", 2.0 * mu * unit => "two surfaces rub",
            4.0 * mu * unit => "neither force is the weight",
            2.0 * mu * (1.0 + mu) * unit => "the floor does not carry the whole weight";
        /// time to the stop
        t_stop: stop, "s", "located event" => stops.t * time, within exact * stop, in "Pressed to the wall":
            2.0 * stop => "that is for a thin tube", 0.5 * fast / (mu * unit) => "two surfaces rub";
        /// turns until then
        turns: turns, "-", "simulated" => end.q[2] / TAU, within exact * turns, in "Pressed to the wall":
            2.0 * turns => "it slows down on the way", turns * TAU => "that is in radians";
        /// heat
        heat: heat, "J", "friction times slip" => (rubbed[0] + rubbed[1]) * (weight * p.radius), within exact * heat,
        in "Pressed to the wall":
            2.0 * heat => "a uniform cylinder has half of that moment of inertia";
        /// part of it that the wall gets
        wall_share: mu / (1.0 + mu), "-", "friction times slip" => rubbed[1] / (rubbed[0] + rubbed[1]),
        within exact, in "Pressed to the wall":
            mu => "that is the wall's part over the floor's", 1.0 / (1.0 + mu) => "that is the floor's part";
        /// the other sense: when it rolls
        t_roll: roll, "s", "located event" => rolls.t * time, within exact * roll, in "The other sense":
            1.5 * roll => "it has only to roll, not to stop turning",
            3.0 * roll => "while it gets faster it also turns slower", stop => "nothing presses it to the wall";
        /// at this speed
        v_roll: v_roll, "m/s", "simulated" => along * speed, within exact * v_roll, in "The other sense":
            3.0 * v_roll => "while it gets faster it also turns slower",
            1.5 * v_roll => "a uniform cylinder has half of that moment of inertia";
        /// how far from the corner
        way: 0.5 * v_roll * roll, "m", "simulated" => rolls.after.q[0] * p.radius, within exact * v_roll * roll,
        in "The other sense":
            v_roll * roll => "it starts from rest";
        /// part of the energy that is left
        kept: 1.0 / 3.0, "-", "simulated" => (2.0 * along * along + turning * turning) / (spin * spin), within exact, in "The other sense":
            2.0 / 3.0 => "that is the part that is lost", 1.0 / 9.0 => "it also moves along";
        /// pressed, friction that fades: time to the stop
        t_fading: fade * time, "s", "located event" => stopped(slower, spin, fade, p.tolerance)? * time, within (exact + 100.0 * p.tolerance) * (fade * time);
    }
}

fn limits(p: &Parameters, report: &mut Report) -> Result<()> {
    let braking = |mu| Cylinder::alike(mu).braking();
    let (best, h) = (1.0 + SQRT_2, 1e-4);
    let slope = (1.0 / braking(best + h) - 1.0 / braking(best - h)) / (2.0 * h);
    let steady = faded(p.friction, 1e-6, 1.0) * braking(p.friction);
    limits! { report,
        /// the wall presses as little as the floor rubs: the brake of a floor alone
        "mu = x: alpha R/(2 mu g)": braking(1e-9) / 2e-9 => 1.0, within 1e-8;
        /// and here as well: what the wall adds it takes from the floor
        "mu = 1: alpha R/(2 mu g)": 0.5 * braking(1.0) => 1.0, within 1e-15;
        /// the friction of the wall carries the weight, with the lever R
        "mu = 1/x: alpha R/g": braking(1e9) => 2.0, within 1e-8;
        /// there it stops soonest
        "mu = 1 + sqrt 2: slope of t_stop over mu": slope => 0.0, within 1e-8;
        /// friction that does not fade
        "fading = x: t_fading/t_stop": steady => 1.0, within 1e-5;
    }
}

/// What `--with lean` adds: the wall presses less.
fn leaning(p: &Parameters, report: &mut Report) -> Result<()> {
    let Some(lean) = p.lean else { return Ok(()) };
    let ([spin, time, ..], cylinder) = (units(p)?, Cylinder::new([p.friction; 2], lean));
    let [floor, wall] = cylinder.pressed();
    let told = "at this wall no forces hold the axis at rest: the cylinder climbs out, is jammed, \
                or nothing rubs";
    require(floor > 0.0 && wall > 0.0, "lean", lean, told)?;
    let stop = spin / cylinder.braking();
    let found = stopped(cylinder, spin, stop, p.tolerance.min(1e-9))?;
    claims! { report,
        /// at a wall that leans back: time to the stop
        t_leaning: stop * time, "s", "located event" => found * time, within 1e-7 * stop * time;
    }
}

/// The card of effects; the air rubs at a wooden cylinder (700 kg/m^3) with 0.01 of rho v^2/2.
fn effects(p: &Parameters, report: &mut Report) -> Result<()> {
    let (mu, [spin, ..], cylinder) = (p.friction, units(p)?, Cylinder::alike(p.friction));
    let (alpha, rim) = (cylinder.braking(), p.spin.abs() * p.radius);
    let drop = (2.0 * 1e-3 / p.radius).sqrt() * alpha / spin;
    // Torque over that of the friction: the length of the cylinder follows from its mass.
    let air = 1.204 * 0.01 * rim * rim * 2.0 / (700.0 * p.radius * p.gravity * alpha);
    let yields = 1e-4 / (mu * p.radius);
    // How much later it stops, simulated.
    let later = |cylinder: Cylinder, about: f64| -> Result<f64> {
        Ok(stopped(cylinder, spin, about, p.tolerance.min(1e-9))? * alpha / spin - 1.0)
    };
    let (leaning, (slower, fading)) = (Cylinder::new([mu, mu], TAU / 360.0), fading(p)?);
    let (leans, faded) = (later(leaning, spin / leaning.braking())?, later(slower, fading)?);
    effect_card! { report,
        "friction that falls with the slip": "fading Omega R" = p.fading * rim, costs fading * alpha / spin - 1.0, "of t_stop", measured faded, within 1e-7;
        "a wall that leans back by one degree": "beta" = leaning.lean, costs alpha / leaning.braking() - 1.0, "of t_stop", measured leans, within 1e-7;
        "set down from 1 mm above": "sqrt(2 h/g)/t_stop" = drop, costs -drop, "of t_stop";
        "surfaces that yield, normal forces 0.1 mm ahead": "d/(mu R)" = yields, costs -yields, "of t_stop";
        "air": "torque over that of friction" = air, costs -air / 3.0, "of t_stop";
    }
}

/// The accuracy strip: the stop if friction fades, where forces change on the way.
fn accuracy(p: &Parameters, report: &mut Report) -> Result<()> {
    let ([spin, ..], mu) = (units(p)?, p.friction);
    let (cylinder, stop) = fading(p)?;
    report.in_closed_form(move |part| faded(mu, cylinder.fading, part * spin));
    let run = move |step| set_down(cylinder, spin, 2.0 * stop, step);
    let error = move |ride: &Ride| Ok((ride.event("floor sticks")?.t / stop - 1.0).abs());
    report.stepped([p.tolerance, 1e-3, 1e-6, 1e-9, 1e-12, 1e-15], run, Ride::work, error)
}

/// Other surfaces: forces and time to the stop, and the same time simulated.
fn surfaces(p: &Parameters, report: &mut Report) -> Result<()> {
    let ([spin, time, ..], mu, lean) = (units(p)?, p.friction, 20.0 * TAU / 360.0);
    let all = [
        ("as above", [mu, mu], 0.0),
        ("a smooth wall", [mu, 0.0], 0.0),
        ("a wall twice as rough", [mu, 2.0 * mu], 0.0),
        ("a floor twice as rough", [2.0 * mu, mu], 0.0),
        ("a wall that leans back by 20 degrees", [mu, mu], lean),
        ("one that overhangs by 20 degrees", [mu, mu], -lean),
    ];
    let all = all.map(|(name, rough, lean)| (name, Cylinder::new(rough, lean)));
    // Without a force of the floor it climbs out.
    let held = all.into_iter().filter(|(_, cylinder)| cylinder.pressed()[0] > 0.0);
    let columns = "surfaces, N_floor/Mg, N_wall/Mg, t_stop / s, simulated / s";
    report.add(Table::of("surfaces", columns.split(", "), held, |(name, cylinder)| {
        let ([floor, wall], stop) = (cylinder.pressed(), spin / cylinder.braking());
        let found = stopped(cylinder, spin, stop, p.tolerance)?;
        let cells = [floor, wall, stop * time, found * time].map(|x| format!("{x:.7}"));
        Ok([name.into()].into_iter().chain(cells))
    })?)
}

fn signs(p: &Parameters, report: &mut Report) -> Result<()> {
    let ([w, ..], cylinder) = (units(p)?, Cylinder::alike(p.friction));
    let stop = w / cylinder.braking();
    let columns = "steps until t_stop, spin left / Omega, steps that change its sign";
    report.add(Table::of("signs", columns.split(", "), [100, 1000, 10_000], |steps| {
        // The stop comes within a step, as it does unless one is lucky.
        let end = 2.0 * stop * f64::from(steps) / (f64::from(steps) + 0.4);
        let all = by_sign(p.friction, w, false, end, 2 * steps);
        let after = &all[steps as usize + 1..];
        let left = after.iter().fold(0.0, |most: f64, [_, spin]| most.max(spin.abs()));
        let turns = |pair: &&[[f64; 2]]| pair[0][1] * pair[1][1] < 0.0;
        let changes = after.windows(2).filter(turns).count();
        let part = changes as f64 / (after.len() - 1) as f64;
        Ok([steps.to_string(), format!("{:.1e}", left / w), format!("{part:.2}")])
    })?)
}

example! {
    ch16_ex3_corner: "Exercise 16.3: a spinning cylinder is set down in a corner";
    "A spinning cylinder in a corner", "A cylinder that spins is set down between a floor and a wall.",
    [claims, leaning, limits, effects, accuracy, surfaces, signs];
    figures::figures, figures::trajectory, figures::moving_picture
}
