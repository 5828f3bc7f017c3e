//! Exercise 16.6: a ladder slides down a smooth wall and, too early for most
//! solvers, leaves it.
//!
//! ```text
//! cargo run --example ch16_ex6_ladder -- --angle 1.0 --check theta_release=1.2023
//! ```

#[path = "ch16_ex6_ladder/figures.rs"]
mod figures;
#[path = "ch16_ex6_ladder/variations.rs"]
mod variations;

use core::f64::consts::FRAC_PI_2;
use kit::prelude::*;
use models::ladder::Ladder as Exact;
use rotation_dynamics::accuracy::largest;
use rotation_dynamics::math::{EPS, acosh};
use rotation_dynamics::planar::contact::{
    Contact, ContactMotion, Mechanism, MechanismState, Surface, kept_within, motion_within,
};

parameters! {
    /// The ladder of the exercise; the notes leave all three numbers open.
    pub struct Parameters {
        /// length of the ladder
        length: number(3.0, "m", above(0.0).usually(1.0, 6.0)).drawn(2.0, 6.0, 0.1);
        gravity: gravity(above(0.0).usually(1.0, 25.0));
        /// angle from the wall at the start
        angle: number(0.25, "rad", between(0.0, FRAC_PI_2).because("upright it stands for ever, flat it lies").usually(0.01, 1.5)).drawn(0.15, 0.60, 0.05);
        /// relative error asked for, at every event: from 3.2e-14 to 0.1
        tolerance: number(1e-12, "-", from_to(3.2e-14, 0.1));
    }
}

/// A ladder between wall and floor, per unit mass.
///
/// Its coordinates are `[x, y, theta]`: its middle, and its angle from the wall.
#[derive(Debug, Clone, Copy)]
pub struct Ladder {
    pub length: f64,
    pub gravity: f64,
    /// Moment of inertia about the middle, over that of a uniform rod, m l^2/12.
    pub inertia: f64,
    /// Coefficient of friction at both ends.
    pub mu: f64,
}

// ANCHOR: scene
impl Mechanism<3, 2> for Ladder {
    fn mass(&self, _: &[f64; 3]) -> [[f64; 3]; 3] {
        let turning = self.inertia * self.length * self.length / 12.0;
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, turning]]
    }

    fn force(&self, _: &MechanismState<3>) -> [f64; 3] {
        [0.0, -self.gravity, 0.0]
    }

    fn contacts(&self, ladder: &MechanismState<3>) -> [Contact<3>; 2] {
        let ((s, c), half) = (sincos(ladder.q[2]), 0.5 * self.length);
        // The two ends, seen from the middle.
        let (top, foot) = ([-half * s, half * c], [half * s, -half * c]);
        let wall = Contact::corner("wall", ladder, top, Surface::WALL);
        let floor = Contact::corner("foot", ladder, foot, Surface::FLOOR);
        [wall.friction(self.mu), floor.friction(self.mu)]
    }

    fn end(&self, ladder: &MechanismState<3>) -> Option<(&'static str, f64)> {
        Some(("lands", FRAC_PI_2 - ladder.q[2]))
    }
    // ANCHOR_END: scene

    /// Errors count relative to each coordinate, so a start a hair off the wall is followed
    /// as closely as any other.
    fn scale(&self, ladder: &MechanismState<3>) -> MechanismState<3> {
        let rate = (1.5 * self.gravity / self.length).sqrt();
        let q = [ladder.q[0].abs(), self.length, ladder.q[2].abs()];
        let v = q.map(|size| rate * size);
        MechanismState { q, v }
    }
}

/// A motion of the ladder.
pub type Slide = ContactMotion<Ladder, 3, 2>;

impl Ladder {
    /// The uniform, smooth ladder of the exercise.
    pub fn smooth(p: &Parameters) -> Self {
        Self {
            length: p.length,
            gravity: p.gravity,
            inertia: 1.0,
            mu: 0.0,
        }
    }

    /// At rest at this angle, both ends touching.
    pub fn at_rest(&self, angle: f64) -> MechanismState<3> {
        let half = 0.5 * self.length;
        MechanismState::rest([half * sin(angle), half * cos(angle), angle])
    }

    /// How far the top is from the wall.
    pub fn top_gap(&self, ladder: &MechanismState<3>) -> f64 {
        ladder.q[0] - 0.5 * self.length * sin(ladder.q[2])
    }

    /// The energy over `m g l/2`, counted from the floor.
    fn energy(&self, ladder: &MechanismState<3>) -> f64 {
        let ([_, y, _], [vx, vy, omega]) = (ladder.q, ladder.v);
        let turning = self.inertia * self.length * self.length / 12.0 * omega * omega;
        2.0 * y / self.length + (vx * vx + vy * vy + turning) / (self.gravity * self.length)
    }
}

/// The exact motion, the simulated one, and the one of a solver that keeps the wall.
struct Solved {
    exact: Exact,
    ladder: Ladder,
    run: Slide,
    naive: Slide,
}

// ANCHOR: solve
fn solve(p: &Parameters) -> Result<Solved> {
    let exact = Exact::new(p.length, p.gravity, p.angle)?;
    let told = "the ladder all but lies: within 5e-15 rad of pi/2 rounding leaves no digit of \
                its elevation";
    require(rounding(p) <= 0.1, "angle", p.angle, told)?;
    let ladder = Ladder::smooth(p);
    let start = ladder.at_rest(p.angle);
    let end = 2.0 * exact.landing_time();
    let tolerance = rounding(p).clamp(p.tolerance, 0.1);
    Ok(Solved {
        exact,
        ladder,
        run: motion_within(ladder, tolerance, start, end)?,
        naive: kept_within(ladder, tolerance, start, end)?,
    })
}
// ANCHOR_END: solve

/// Every number of the page.
fn report(p: &Parameters) -> Result<Report> {
    let solved = solve(p)?;
    let scene = "A uniform ladder between a smooth wall and a smooth floor, released at rest.";
    let mut report = Report::new("The ladder that leaves the wall", scene)?;
    claims(p, &solved, &mut report)?;
    limits(p, &solved, &mut report)?;
    variations::effects(p, &solved, &mut report)?;
    strip(p, &solved, &mut report)?;
    for table in [variations::mass, variations::friction, variations::tries] {
        report.add(table(p)?)?;
    }
    Ok(report)
}

/// The closed form, each number confirmed by the simulation.
#[rustfmt::skip]
fn claims(p: &Parameters, solved: &Solved, report: &mut Report) -> Result<()> {
    let (exact, l, g, start) = (&solved.exact, p.length, p.gravity, cos(p.angle));
    let (released, landed) = (exact.release(), exact.landing());
    let (lets_go, lands) = (solved.run.event("wall lets go")?, solved.run.event("lands")?);
    let (rate, kept) = ((1.5 * g / l).sqrt(), (3.0 * g * start / l).sqrt());
    // The simulation was asked for an error relative to these sizes.
    let error = attainable(p);
    let (time, force) = (error * exact.landing_time(), 4.0 * error);
    let (angle, spin) = (error * released.theta, error * rate * FRAC_PI_2);
    let (top, floor, event) = ("where the top leaves the wall", "at the floor", "located event");
    report.add(vec![
        claim("theta_release", "angle from the wall at which the top leaves it", released.theta, "rad")
            .within(angle).against(event, lets_go.before.q[2]).answer(top)
            .slip(FRAC_PI_2 - released.theta, "that is the angle from the floor; measure from the wall")
            .slip(acos(start / 3.0), "the top falls by one third of its height, not to one third")
            .slip(acos(2.0 / 3.0), "that is for a start upright; the height to compare with is that of the release")
            .slip(p.angle * 1.5, "it is the height of the top that scales, not the angle"),
        claim("height_ratio_release", "height of the top when it leaves, over its height at the start", 2.0 / 3.0, "-")
            .within(angle * sin(released.theta) / start).against(event, cos(lets_go.before.q[2]) / start),
        claim("t_release", "time from the release to the moment when the wall lets go", exact.release_time(), "s")
            .within(time).against(event, lets_go.t).answer(top)
            .slip(acosh(released.theta / p.angle) / rate, "that takes sin theta = theta all the way; the angles are not small")
            .slip(exact.landing_time(), "that is when it lands; the wall lets go earlier"),
        claim("omega_release", "angular velocity when the wall lets go", released.omega, "rad/s")
            .within(spin).against(event, lets_go.before.v[2]).answer(top)
            .slip(2.0 * released.omega, "the ladder does not only turn about its middle: the middle moves too")
            .slip(2.0 / 3.0_f64.sqrt() * released.omega, "the middle does not only move: the ladder turns as well"),
        claim("vx_release", "horizontal velocity of the centre, from then on constant", released.vx_cm, "m/s")
            .within(spin * l).against(event, lets_go.before.v[0]).answer(top)
            .slip(2.0 * released.vx_cm, "that is the velocity of the foot; the centre has half of it"),
        claim("n_floor_release", "force of the floor over the weight when the wall lets go", released.floor_force, "-")
            .within(force).against(event, lets_go.force[1].normal / g).answer(top)
            .slip(1.0, "the centre accelerates downward, so the floor carries less"),
        claim("t_floor", "time at which the ladder lies on the floor", exact.landing_time(), "s")
            .within(time).against(event, lands.t).answer(floor)
            .slip(exact.held_landing_time(), "that keeps the wall: it cannot pull the top"),
        claim("omega_floor", "angular velocity with which it meets the floor", landed.omega, "rad/s")
            .within(spin).against("simulation", lands.before.v[2]).answer(floor)
            .slip(kept, "that turns all the energy into rotation; some of it slides away with the centre"),
        claim("x_top_floor", "distance of the top from the wall when it meets the floor", landed.x_top, "m")
            .within(error * landed.x_cm).against("simulation", solved.ladder.top_gap(&lands.before)),
    ])?;
    let flat = solved.naive.event("lands")?;
    let pull = -flat.force[0].normal / g;
    report.add(vec![
        claim("naive_pull", "wrong: pull of a wall that is kept to the floor, over the weight", 1.5 * start, "-")
            .within(force).against("simulation", pull),
        claim("naive_t_floor", "wrong: time of the fall with the wall kept", exact.held_landing_time(), "s")
            .within(time).against("simulation", flat.t),
        claim("naive_omega_floor", "wrong: angular velocity at the floor with the wall kept", kept, "rad/s")
            .within(spin).against("simulation", flat.before.v[2]),
    ])
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

fn limits(p: &Parameters, solved: &Solved, report: &mut Report) -> Result<()> {
    let (l, g, rate) = (p.length, p.gravity, (1.5 * p.gravity / p.length).sqrt());
    let landed = solved.ladder.energy(&solved.run.event("lands")?.before);
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
        "flat start: W t_floor / sqrt(elevation)":
            flat.landing_time() / unit => 2.0_f64.sqrt(), within 1e-10;
    }
}

/// What accuracy costs: the error asked for, the error found, the work.
fn strip(p: &Parameters, solved: &Solved, report: &mut Report) -> Result<()> {
    let (exact, ladder) = (solved.exact, solved.ladder);
    let (start, end) = (ladder.at_rest(p.angle), 2.0 * exact.landing_time());
    report.controlled(
        "solve: DOP853, contact released",
        REQUESTED.into_iter().chain([p.tolerance]),
        move |tolerance| motion_within(ladder, tolerance, start, end),
        Slide::work,
        move |run| error(&exact, run),
    )?;
    let sample = move |part: f64| exact.at(part * exact.landing_time());
    report.set_closed_form(ClosedForm::new(sample));
    report.controlled(
        "wrong: wall kept",
        [p.tolerance],
        move |tolerance| kept_within(ladder, tolerance, start, end),
        Slide::work,
        move |run| landing_error(&exact, run),
    )
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
    report, figures::figures, trajectory, figures::moving_picture
}
