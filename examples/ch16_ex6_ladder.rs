//! Exercise 16.6: a ladder slides down a smooth wall and, too early for most solvers, leaves it.

#[path = "ch16_ex6_ladder/figures.rs"]
mod figures;
#[path = "ch16_ex6_ladder/physics.rs"]
pub mod physics;

use core::f64::consts::FRAC_PI_2;
use kit::prelude::*;
use kit::supported_digits;
use models::ladder::{Ladder as Exact, Phase};
use physics::*;
use rotation_dynamics::accuracy::largest;
use rotation_dynamics::math::{EPS, acosh};
use rotation_dynamics::planar::contact::{MechanismState, kept_within, motion_within};

parameters! {
    /// The ladder of the exercise; the notes leave all three numbers open.
    pub struct Parameters {
        /// length of the ladder
        length: number(3.0, "m", above(0.0).usually(1.0, 6.0)).drawn(2.0, 6.0, 0.1);
        gravity: gravity(above(0.0).usually(1.0, 25.0));
        /// angle from the wall at the start
        angle: number(0.25, "rad", from_to(1e-9, 1.570_796_325).because("upright it stands for ever, flat it lies: of less, rounding leaves too few digits").usually(0.01, 1.5)).drawn(0.15, 0.60, 0.05).open("angle from the wall at the start", "nearly upright", "nearly flat");
        /// relative error asked for, at every event: from 3.2e-14 to 0.1
        tolerance: number(1e-12, "-", from_to(3.2e-14, 0.1));
    }
}

fn claims(p: &Parameters, report: &mut Report) -> Result<()> {
    let Solved { exact, ladder, run, naive } = solve(p)?;
    let (l, g, start) = (p.length, p.gravity, cos(p.angle));
    let (released, landed) = (exact.release(), exact.landing());
    let (lets_go, lands) = (run.event("wall lets go")?, run.event("lands")?);
    let flat = naive.event("lands")?;
    let (rate, kept) = ((1.5 * g / l).sqrt(), (3.0 * g * start / l).sqrt());
    // The simulation was asked for an error relative to these sizes.
    let error = p.tolerance + rounding(p);
    let (time, force) = (error * exact.landing_time(), 4.0 * error);
    let (angle, spin) = (error * released.theta, error * rate * FRAC_PI_2);
    claims! { report,
        /// angle from the wall at which the top leaves it
        theta_release: released.theta, "rad", "located event" => lets_go.before.q[2], within angle, in "where the top leaves the wall":
            FRAC_PI_2 - released.theta => "that is the angle from the floor; measure from the wall",
            acos(start / 3.0) => "the top falls by one third of its height, not to one third",
            acos(2.0 / 3.0) => "that is for a start upright; the height to compare with is that of the release",
            p.angle * 1.5 => "it is the height of the top that scales, not the angle";
        /// time from the release to the moment when the wall lets go
        t_release: exact.release_time(), "s", "located event" => lets_go.t, within time, in "where the top leaves the wall":
            acosh(released.theta / p.angle) / rate => "that takes sin theta = theta all the way; the angles are not small",
            exact.landing_time() => "that is when it lands; the wall lets go earlier";
        /// angular velocity when the wall lets go
        omega_release: released.omega, "rad/s", "located event" => lets_go.before.v[2], within spin, in "where the top leaves the wall":
            2.0 * released.omega => "the ladder does not only turn about its middle: the middle moves too",
            2.0 / 3.0_f64.sqrt() * released.omega => "the middle does not only move: the ladder turns as well";
        /// horizontal velocity of the centre, from then on constant
        vx_release: released.vx_cm, "m/s", "located event" => lets_go.before.v[0], within spin * l, in "where the top leaves the wall":
            2.0 * released.vx_cm => "that is the velocity of the foot; the centre has half of it";
        /// force of the floor over the weight when the wall lets go
        n_floor_release: released.floor_force, "-", "located event" => lets_go.force[1].normal / g, within force, in "where the top leaves the wall":
            1.0 => "the centre accelerates downward, so the floor carries less";
        /// time at which the ladder lies on the floor
        t_floor: exact.landing_time(), "s", "located event" => lands.t, within time, in "at the floor":
            exact.held_landing_time() => "that keeps the wall: it cannot pull the top";
        /// angular velocity with which it meets the floor
        omega_floor: landed.omega, "rad/s", "simulation" => lands.before.v[2], within spin, in "at the floor":
            kept => "that turns all the energy into rotation; some of it slides away with the centre";
        /// distance of the top from the wall when it meets the floor
        x_top_floor: landed.x_top, "m", "simulation" => ladder.top_gap(&lands.before), within error * landed.x_cm;
        /// wrong: pull of a wall that is kept to the floor, over the weight
        naive_pull: 1.5 * start, "-", "simulation" => -flat.force[0].normal / g, within force;
        /// wrong: time of the fall with the wall kept
        naive_t_floor: exact.held_landing_time(), "s", "simulation" => flat.t, within time;
        /// wrong: angular velocity at the floor with the wall kept
        naive_omega_floor: kept, "rad/s", "simulation" => flat.before.v[2], within spin;
    }
}

/// The relative error that the rounding of theta makes: nearly flat the elevation is what is
/// left of it.
fn rounding(p: &Parameters) -> f64 {
    2.0 * EPS * tan(p.angle)
}

fn limits(p: &Parameters, report: &mut Report) -> Result<()> {
    let (l, g, rate) = (p.length, p.gravity, (1.5 * p.gravity / p.length).sqrt());
    let MechanismState { q: [_, y, _], v: [vx, vy, omega] } = solve(p)?.run.event("lands")?.before;
    let moving = vx * vx + vy * vy + l * l / 12.0 * omega * omega;
    let hair = Exact::new(l, g, 1e-9)?;
    let upright = log(8.0 / (6.0_f64.sqrt() + 5.0_f64.sqrt()));
    // Nearly flat, the ladder turns with the constant acceleration W^2.
    let rise = 1e-6;
    let (flat, unit) = (Exact::new(l, g, FRAC_PI_2 - rise)?, rise.sqrt() / rate);
    limits! { report,
        /// nothing rubs: it is what it was at the start, in units of m g l/2
        "energy at the floor": 2.0 * y / l + moving / (g * l) => cos(p.angle), within 8.0 * (p.tolerance + rounding(p));
        /// arccos(2/3), whatever length and gravity
        "upright start: angle of release": hair.release().theta => acos(2.0 / 3.0), within 1e-15;
        /// ln(8/(sqrt 6 + sqrt 5)): each factor ten nearer to upright costs ln(10)/W
        "upright start: W t_release - ln(1/theta0)": rate * hair.release_time() - log(1e9) => upright, within 1e-13;
        /// a third of the small height is fallen with the acceleration W^2
        "flat start: W t_release / sqrt(elevation)": flat.release_time() / unit => (2.0_f64 / 3.0).sqrt(), within 1e-10;
        /// all of it, with the same acceleration
        "flat start: W t_floor / sqrt(elevation)": flat.landing_time() / unit => 2.0_f64.sqrt(), within 1e-10;
    }
}

const REQUESTED: [f64; 6] = [1e-3, 1e-5, 1e-7, 1e-9, 1e-11, 1e-13];

/// What accuracy costs: the error asked for, the error found, the work.
fn strip(p: &Parameters, report: &mut Report) -> Result<()> {
    let Solved { exact, ladder, .. } = solve(p)?;
    let (start, end) = (ladder.at_rest(p.angle), 2.0 * exact.landing_time());
    let run = move |tolerance| motion_within(ladder, tolerance, start, end);
    let asked = REQUESTED.into_iter().chain([p.tolerance]);
    let found = move |run: &Slide| error(&exact, run);
    report.controlled("solve: DOP853, contact released", asked, run, Slide::work, found)?;
    report.set_closed_form(ClosedForm::new(move |part| exact.at(part * exact.landing_time())));
    let kept = move |tolerance| kept_within(ladder, tolerance, start, end);
    let found = move |run: &Slide| landing_error(&exact, run);
    report.controlled("wrong: wall kept", [p.tolerance], kept, Slide::work, found)
}

/// The largest relative error of times and rates at the release and at the floor.
fn error(exact: &Exact, run: &Slide) -> Result<f64> {
    let (lets_go, released) = (run.event("wall lets go")?, exact.release());
    let MechanismState { q, v } = lets_go.before;
    Ok(largest([
        lets_go.t / exact.release_time() - 1.0,
        q[2] / released.theta - 1.0,
        v[2] / released.omega - 1.0,
        v[0] / released.vx_cm - 1.0,
        landing_error(exact, run)?,
    ]))
}

fn landing_error(exact: &Exact, run: &Slide) -> Result<f64> {
    let lands = run.event("lands")?;
    let in_rate = lands.before.v[2] / exact.landing().omega - 1.0;
    Ok(largest([lands.t / exact.landing_time() - 1.0, in_rate]))
}

// What changes if an assumption goes: the mass is spread differently, the surfaces rub, the air drags.

/// The motion of another ladder from the same start, to nine digits where theta has them.
fn slide(p: &Parameters, ladder: Ladder) -> Result<Slide> {
    let (start, within) = (ladder.at_rest(p.angle), rounding(p).max(1e-9));
    let end = 100.0 * Exact::new(p.length, p.gravity, p.angle)?.landing_time();
    Ok(motion_within(ladder, within, start, end)?)
}

fn digits(value: f64) -> String {
    supported_digits(value, 1e-7)
}

/// What the page asks its reader: the mass spread differently, with the centre in the middle still;
/// dry friction at both ends; other starts, in closed form.
fn tables(p: &Parameters, report: &mut Report) -> Result<()> {
    let columns = "mass, inertia, height ratio, t_release, omega_floor".split(", ");
    let spreads = [(0.3, "mostly in the middle"), (1.0, "uniform"), (3.0, "at both ends")];
    report.add(Table::of("mass", columns, spreads, |(inertia, name)| {
        let run = slide(p, Ladder { inertia, ..Ladder::smooth(p) })?;
        let lets_go = run.event("wall lets go")?;
        let ratio = cos(lets_go.before.q[2]) / cos(p.angle);
        let numbers = [ratio, lets_go.t, run.event("lands")?.before.v[2]].map(digits);
        Ok([name.into(), inertia.to_string()].into_iter().chain(numbers))
    })?)?;
    let columns = "mu, mu/tan(theta0/2), height ratio, t_release/s, t_floor/s".split(", ");
    report.add(Table::of("friction", columns, [0.0, 0.1, 0.3, 0.6, 0.9, 1.0], |part| {
        let run = rubbing(p, part)?;
        let told = |number: Option<f64>, none: &str| number.map_or(none.to_owned(), digits);
        let after = |event| told(run.event(event).ok().map(|event| event.t), "it stays");
        let release = run.event("wall lets go").ok();
        let height = release.map(|event| cos(event.before.q[2]) / cos(p.angle));
        let mu = supported_digits(part * holding_friction(p), 1e-6);
        let [release, landing] = ["wall lets go", "lands"].map(after);
        Ok([mu, part.to_string(), told(height, "-"), release, landing])
    })?)?;
    let columns = "start, theta_release, t_release, omega_floor, kept wall too fast by";
    let starts = [
        ("as above", p.gravity, p.angle),
        ("a tenth of the angle", p.gravity, 0.1 * p.angle),
        ("on the Moon", 1.62, p.angle),
        ("nearly flat", p.gravity, 1.5),
    ];
    report.add(Table::of("try", columns.split(", "), starts, |(start, gravity, angle)| {
        let exact = Exact::new(p.length, gravity, angle)?;
        let (release, omega) = (exact.release(), exact.landing().omega);
        let excess = (3.0 * gravity * cos(angle) / p.length).sqrt() / omega - 1.0;
        let numbers = [release.theta, exact.release_time(), omega, excess].map(digits);
        Ok([start.into()].into_iter().chain(numbers))
    })?)
}

/// The ladder stays where it is put if `mu` is at least this: tan(theta0/2).
fn holding_friction(p: &Parameters) -> f64 {
    tan(0.5 * p.angle)
}

/// How the motion goes with this part of the friction that would hold the ladder.
fn rubbing(p: &Parameters, part: f64) -> Result<Slide> {
    slide(p, Ladder { mu: part * holding_friction(p), ..Ladder::smooth(p) })
}

/// How much later the ladder lands with the friction `mu`, over the time of the smooth one.
///
/// To first order friction takes work and horizontal speed along the exact motion, which then
/// turns more slowly at each angle. Nearly flat that vanishes and the square counts: the floor's
/// friction presses the top against the wall, `N_wall = mu N_floor`, and the ladder turns with
/// `W^2 (1 - mu^2)/(1 - mu^2/2)`, so later by the part `mu^2/4`.
fn later(p: &Parameters, exact: &Exact, mu: f64) -> Result<f64> {
    let (l, g, landed) = (p.length, p.gravity, exact.landing_time());
    let dt = landed / 2000.0;
    // What is lost of the energy and of the horizontal speed, per unit mass, and of the time.
    let (mut work, mut speed, mut delay) = (0.0, 0.0, 0.0);
    for t in times(0.5 * dt, landed - 0.5 * dt, 1999) {
        let state = exact.at(t)?;
        let (s, c) = sincos(state.theta);
        let foot = state.vx_cm + 0.5 * l * c * state.omega;
        let (floor, wall) = (mu * g * state.floor_force, mu * g * state.wall_force);
        let half = 0.5 * dt * (floor * foot + wall * l * s * state.omega);
        work += half;
        let slower = if state.phase == Phase::OnWall {
            let slower = 3.0 * work / (l * l * state.omega);
            speed = 0.5 * l * c * slower;
            slower
        } else {
            speed += floor * dt;
            (work - state.vx_cm * speed) / (l * l * (1.0 / 12.0 + 0.25 * s * s) * state.omega)
        };
        delay += dt * slower / state.omega;
        work += half;
    }
    Ok(delay / landed + 0.25 * mu * mu)
}

/// Air on a light ladder: rho C w l^2/m with its density (kg/m^3), the drag coefficient of
/// a flat plate, solid width (m) of stiles and rungs and mass (kg); and the part of the
/// fall's energy that it would take, by the work of the drag along the exact motion.
fn air(p: &Parameters, exact: &Exact) -> Result<[f64; 2]> {
    let (l, per_area, mass) = (p.length, 1.204 * 1.2 * 0.08, 4.0 * p.length);
    let dt = exact.landing_time() / 400.0;
    let mut work = 0.0;
    for t in times(0.5 * dt, exact.landing_time() - 0.5 * dt, 399) {
        let state = exact.at(t)?;
        let (s, c) = sincos(state.theta);
        let across = -c * state.vx_cm + s * (0.5 * l * s * state.omega);
        for from_middle in times(-39.0 / 80.0 * l, 39.0 / 80.0 * l, 39) {
            let speed = (across + state.omega * from_middle).abs();
            work += 0.5 * per_area * speed * speed * speed * l / 40.0 * dt;
        }
    }
    Ok([per_area * l * l / mass, work / (mass * p.gravity * 0.5 * l * cos(p.angle))])
}

fn effects(p: &Parameters, report: &mut Report) -> Result<()> {
    let Solved { exact, naive, .. } = &solve(p)?;
    let rubs = later(p, exact, 0.1 * holding_friction(p))?;
    let found = rubbing(p, 0.1)?.end_time() / exact.landing_time() - 1.0;
    let ([drag, lost], kept) = (air(p, exact)?, landing_error(exact, naive)?);
    effect_card! { report,
        "friction, a tenth of what would hold the ladder":
            "mu / tan(theta0/2)" = 0.1, costs rubs, "of t_floor", measured found;
        "air drag on a light ladder (4 kg/m, 8 cm solid width)":
            "rho C w l^2 / m" = drag, costs 0.5 * lost, "of omega_floor";
        "one-sided contact of the wall":
            "pull / (m g) at the floor, if kept" = 1.5 * cos(p.angle), costs kept, "of omega_floor", included;
    }
}

example! {
    ch16_ex6_ladder: "Exercise 16.6: a ladder slides down a smooth wall and leaves it";
    "The ladder that leaves the wall",
    "A uniform ladder between a smooth wall and a smooth floor, released at rest.",
    [claims, limits, effects, strip, tables];
    figures::figures, figures::trajectory, figures::moving_picture
}
