//! Exercise 16.6: a ladder slides down a smooth wall and, too early for most
//! solvers, leaves it.
//!
//! ```text
//! cargo run --example ch16_ex6_ladder -- --angle 1.0 --check theta_release=1.2023
//! ```

#[path = "ch16_ex6_ladder/figures.rs"]
mod figures;
#[path = "ch16_ex6_ladder/physics.rs"]
pub mod physics;
#[path = "ch16_ex6_ladder/variations.rs"]
mod variations;

use core::f64::consts::FRAC_PI_2;
use kit::prelude::*;
use models::ladder::Ladder as Exact;
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

/// The closed form, each number confirmed by the simulation.
fn claims(p: &Parameters, report: &mut Report) -> Result<()> {
    let Solved { exact, ladder, run, naive } = solve(p)?;
    let (l, g, start) = (p.length, p.gravity, cos(p.angle));
    let (released, landed) = (exact.release(), exact.landing());
    let (lets_go, lands, flat) =
        (run.event("wall lets go")?, run.event("lands")?, naive.event("lands")?);
    let (rate, kept) = ((1.5 * g / l).sqrt(), (3.0 * g * start / l).sqrt());
    // The simulation was asked for an error relative to these sizes.
    let error = attainable(p);
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

/// The relative error to expect: the one asked for, and that of rounding theta.
fn attainable(p: &Parameters) -> f64 {
    p.tolerance + rounding(p)
}

/// The relative error that the rounding of theta makes: nearly flat the elevation is what is
/// left of it.
fn rounding(p: &Parameters) -> f64 {
    2.0 * EPS * tan(p.angle)
}

fn limits(p: &Parameters, report: &mut Report) -> Result<()> {
    let (l, g, rate) = (p.length, p.gravity, (1.5 * p.gravity / p.length).sqrt());
    let Solved { ladder, run, .. } = solve(p)?;
    let landed = ladder.energy(&run.event("lands")?.before);
    let hair = Exact::new(l, g, 1e-9)?;
    let upright = log(8.0 / (6.0_f64.sqrt() + 5.0_f64.sqrt()));
    // Nearly flat, the ladder turns with the constant acceleration W^2.
    let rise = 1e-6;
    let (flat, unit) = (Exact::new(l, g, FRAC_PI_2 - rise)?, rise.sqrt() / rate);
    limits! { report,
        /// nothing rubs: it is what it was at the start, in units of m g l/2
        "energy at the floor": landed => cos(p.angle), within 8.0 * attainable(p);
        /// arccos(2/3), whatever length and gravity
        "upright start: angle of release": hair.release().theta => acos(2.0 / 3.0), within 1e-15;
        /// ln(8/(sqrt 6 + sqrt 5)): each factor ten nearer to upright costs ln(10)/W
        "upright start: W t_release - ln(1/theta0)":
            rate * hair.release_time() - log(1e9) => upright, within 1e-13;
        /// a third of the small height is fallen with the acceleration W^2
        "flat start: W t_release / sqrt(elevation)":
            flat.release_time() / unit => (2.0_f64 / 3.0).sqrt(), within 1e-10;
        /// all of it, with the same acceleration
        "flat start: W t_floor / sqrt(elevation)": flat.landing_time() / unit => 2.0_f64.sqrt(), within 1e-10;
    }
}

/// What accuracy costs: the error asked for, the error found, the work.
fn strip(p: &Parameters, report: &mut Report) -> Result<()> {
    let Solved { exact, ladder, .. } = solve(p)?;
    let (start, end) = (ladder.at_rest(p.angle), 2.0 * exact.landing_time());
    let run = move |tolerance| motion_within(ladder, tolerance, start, end);
    let asked = REQUESTED.into_iter().chain([p.tolerance]);
    report.controlled("solve: DOP853, contact released", asked, run, Slide::work, move |run| {
        error(&exact, run)
    })?;
    report.set_closed_form(ClosedForm::new(move |part| exact.at(part * exact.landing_time())));
    let kept = move |tolerance| kept_within(ladder, tolerance, start, end);
    report.controlled("wrong: wall kept", [p.tolerance], kept, Slide::work, move |run| {
        landing_error(&exact, run)
    })
}

/// What the page asks its reader: the mass spread differently, friction, other starts.
fn tables(p: &Parameters, report: &mut Report) -> Result<()> {
    report.add(vec![variations::mass(p)?, variations::friction(p)?, variations::tries(p)?])
}

const REQUESTED: [f64; 6] = [1e-3, 1e-5, 1e-7, 1e-9, 1e-11, 1e-13];

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

fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let exact = Exact::new(p.length, p.gravity, p.angle)?;
    let columns = "t [s], theta [rad], omega [rad/s], x_cm [m], y_cm [m], x_top [m], \
                   vx_cm [m/s], N_floor/mg, N_wall/mg";
    let all = times(0.0, exact.landing_time(), 200);
    Trajectory::sampled(columns.split(", "), all, |t| {
        let s = exact.at(t)?;
        let places = [t, s.theta, s.omega, s.x_cm, s.y_cm, s.x_top];
        Ok([&places[..], &[s.vx_cm, s.floor_force, s.wall_force]].concat())
    })
}

example! {
    ch16_ex6_ladder: "Exercise 16.6: a ladder slides down a smooth wall and leaves it";
    "The ladder that leaves the wall",
    "A uniform ladder between a smooth wall and a smooth floor, released at rest.",
    [claims, limits, variations::effects, strip, tables];
    figures::figures, trajectory, figures::moving_picture
}
