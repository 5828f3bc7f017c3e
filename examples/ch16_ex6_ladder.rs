//! Exercise 16.6: a ladder slides down a smooth wall and, too early for most
//! solvers, leaves it.
//!
//! ```text
//! cargo run --example ch16_ex6_ladder
//! cargo run --example ch16_ex6_ladder -- --angle 1.0 --check theta_release=1.2023
//! ```

#[path = "ch16_ex6_ladder/figures.rs"]
mod figures;
#[path = "ch16_ex6_ladder/variations.rs"]
mod variations;

use core::f64::consts::FRAC_PI_2;
use rotation_dynamics::exact::ladder::Ladder;
use rotation_dynamics::integrators::Dop853;
use rotation_dynamics::math::{EPS, acos, acosh, cos, log, sin, sincos, tan};
use rotation_dynamics::planar::{
    Bilateral, Condition, Next, Phased, Run, simulate, simulate_within,
};
use rotation_dynamics::report::{
    Claim, ClosedForm, Computation, Example, Limit, Oracle, Price, Report, Trajectory,
};
use rotation_dynamics::{Error, Result};
use std::process::ExitCode;

// ANCHOR: parameters
rotation_dynamics::parameters! {
    /// The ladder of the exercise; the notes leave all three numbers open.
    pub struct Parameters {
        /// length of the ladder
        length: number(3.0, "m", above(0.0).usually(1.0, 6.0));
        /// acceleration of gravity
        gravity: number(9.80665, "m/s^2", above(0.0).usually(1.0, 25.0));
        /// angle from the wall at the start
        angle: number(0.25, "rad", between(0.0, FRAC_PI_2).usually(0.01, 1.5));
        /// relative error asked for, at every event: from 3.2e-14 to 0.1
        tolerance: number(1e-12, "-", from_to(3.2e-14, 0.1));
    }
}
// ANCHOR_END: parameters

/// Newton's laws for a uniform ladder between smooth surfaces, all per unit mass.
///
/// The state is `[theta, theta', x, x']`: the angle from the wall, and how far the
/// centre of mass is from it.
#[derive(Debug, Clone, Copy)]
pub struct Sliding {
    pub length: f64,
    pub gravity: f64,
    /// Moment of inertia about the middle, over that of a uniform rod, m l^2/12.
    pub inertia: f64,
}

/// What touches the ladder besides the floor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Wall {
    Touches,
    Free,
}

/// Forces per unit mass, m/s^2, and the angular acceleration, rad/s^2.
pub struct Forces {
    pub wall: f64,
    pub floor: f64,
    pub angular_acceleration: f64,
}

// ANCHOR: newton
impl Sliding {
    /// What the surfaces push with, and how the ladder turns.
    pub fn forces(&self, wall: Wall, state: &[f64; 4]) -> Forces {
        let (l, g, i) = (self.length, self.gravity, self.inertia);
        let [theta, omega, ..] = *state;
        let (s, c) = sincos(theta);
        // Acceleration of the middle towards the corner.
        let inward = 0.5 * l * omega * omega;
        match wall {
            // x = (l/2) sin theta and y = (l/2) cos theta: the forces
            // are what these accelerations need.
            Wall::Touches => {
                let alpha = 6.0 / (3.0 + i) * g / l * s;
                Forces {
                    wall: 0.5 * l * c * alpha - s * inward,
                    floor: g - 0.5 * l * s * alpha - c * inward,
                    angular_acceleration: alpha,
                }
            }
            // Only y is held; the floor alone turns the ladder:
            // i l^2/12 alpha = (l/2) s floor.
            Wall::Free => {
                let floor = (g - c * inward) / (1.0 + 3.0 / i * s * s);
                Forces {
                    wall: 0.0,
                    floor,
                    angular_acceleration: 6.0 / i * s / l * floor,
                }
            }
        }
    }
}
// ANCHOR_END: newton

// ANCHOR: phases
impl Phased<4> for Sliding {
    type Phase = Wall;

    fn derivative(&self, wall: Wall, state: &[f64; 4]) -> [f64; 4] {
        let forces = self.forces(wall, state);
        [state[1], forces.angular_acceleration, state[3], forces.wall]
    }

    fn conditions(&self, wall: Wall) -> Vec<Condition<'_, Wall, 4>> {
        use Wall::{Free, Touches};
        let push = |y: &[f64; 4]| self.forces(Touches, y).wall;
        let lift = move |y: &[f64; 4]| self.forces(wall, y).floor;
        let gap = |y: &[f64; 4]| self.top_gap(y);
        let tilt = |y: &[f64; 4]| FRAC_PI_2 - y[0];
        let free = Next::Enter(Free);
        let wall = match wall {
            Touches => Condition::contact("wall lets go", push, free),
            Free => Condition::opening_gap("top is back", gap, Next::End),
        };
        let floor = Condition::contact("floor lets go", lift, Next::End);
        let lands = Condition::gap("lands", tilt, Next::End);
        vec![wall, floor, lands]
    }

    // ANCHOR_END: phases

    /// Errors count relative to each coordinate, so a start a hair off the wall is followed
    /// as closely as any other.
    fn scale(&self, [theta, _, x, _]: &[f64; 4]) -> [f64; 4] {
        let rate = (1.5 * self.gravity / self.length).sqrt();
        [theta.abs(), rate * theta.abs(), x.abs(), rate * x.abs()]
    }
}

impl Sliding {
    /// How far the top is from the wall.
    pub fn top_gap(&self, [theta, _, x, _]: &[f64; 4]) -> f64 {
        x - 0.5 * self.length * sin(*theta)
    }

    /// The energy over `m g l/2`, counted from the floor.
    pub fn energy(&self, [theta, omega, _, vx]: &[f64; 4]) -> f64 {
        let (s, c) = sincos(*theta);
        let vy = -0.5 * self.length * s * omega;
        let turning = self.inertia * self.length * self.length / 12.0 * omega * omega;
        c + (vx * vx + vy * vy + turning) / (self.gravity * self.length)
    }

    /// The state at rest at this angle, both ends touching.
    pub fn at_rest(&self, angle: f64) -> [f64; 4] {
        [angle, 0.0, 0.5 * self.length * sin(angle), 0.0]
    }
}

/// The exact motion, the simulated one, and the one of a solver that keeps the wall.
struct Solved {
    exact: Ladder,
    scene: Sliding,
    run: Run<Wall, 4>,
    naive: Run<Wall, 4>,
}

// ANCHOR: solve
fn solve(p: &Parameters) -> Result<Solved> {
    let exact = Ladder::new(p.length, p.gravity, p.angle)?;
    let scene = uniform(p);
    let start = scene.at_rest(p.angle);
    let end = 2.0 * exact.landing_time();
    let run = simulate_within(&scene, p.tolerance, Wall::Touches, start, end)?.run;
    let naive = simulate_within(&Bilateral(&scene), p.tolerance, Wall::Touches, start, end)?.run;
    Ok(Solved {
        exact,
        scene,
        run,
        naive,
    })
}
// ANCHOR_END: solve

fn uniform(p: &Parameters) -> Sliding {
    Sliding {
        length: p.length,
        gravity: p.gravity,
        inertia: 1.0,
    }
}

/// Every number of the page.
pub fn report(p: &Parameters) -> Result<Report> {
    let solved = solve(p)?;
    let mut report = Report::new(
        "The ladder that leaves the wall",
        "A uniform ladder between a smooth wall and a smooth floor, released at rest.",
    )?;
    claims(p, &solved, &mut report)?;
    limits(p, &solved, &mut report)?;
    variations::effects(p, &solved, &mut report)?;
    strip(p, &solved, &mut report)?;
    report.add_table(variations::mass(p)?)?;
    report.add_table(variations::friction(p)?)?;
    Ok(report)
}

/// The closed form, each number confirmed by the simulation.
fn claims(p: &Parameters, solved: &Solved, report: &mut Report) -> Result<()> {
    let Solved {
        exact,
        scene,
        run,
        naive,
    } = solved;
    let (l, g) = (p.length, p.gravity);
    let (start, released, landed) = (cos(p.angle), exact.release(), exact.landing());
    let let_go = run.transition("wall lets go")?;
    let lands = run.transition("lands")?;
    let at_release = scene.forces(Wall::Touches, &let_go.before);
    let ratio = |theta: f64| cos(theta) / start;
    let rate = (1.5 * g / l).sqrt();

    // The simulation was asked for an error relative to these sizes.
    let error = attainable(p);
    let time = error * exact.landing_time();
    let angle = error * released.theta;
    let spin = error * rate * FRAC_PI_2;
    let place = error * landed.x_cm;
    let force = 4.0 * error;

    let located = |value| Oracle::new("located event", value);
    let simulated = |value| Oracle::new("simulation", value);

    report.add_claim(
        Claim::new(
            "theta_release",
            "angle from the wall at which the top leaves it",
            released.theta,
            "rad",
            angle,
            located(let_go.before[0]),
        )?
        .slip(
            FRAC_PI_2 - released.theta,
            "that is the angle from the floor; measure from the wall",
        )
        .slip(
            acos(start / 3.0),
            "the top falls by one third of its height, not to one third",
        )
        .slip(
            acos(2.0 / 3.0),
            "that is for a start upright; the height to compare with is that of the release",
        )
        .slip(
            p.angle * 1.5,
            "it is the height of the top that scales, not the angle",
        ),
    )?;
    report.add_claim(Claim::new(
        "height_ratio_release",
        "height of the top when it leaves, over its height at the start",
        2.0 / 3.0,
        "-",
        angle * sin(released.theta) / start,
        located(ratio(let_go.before[0])),
    )?)?;
    report.add_claim(
        Claim::new(
            "t_release",
            "time from the release to the moment when the wall lets go",
            exact.release_time(),
            "s",
            time,
            located(let_go.t),
        )?
        .slip(
            acosh(released.theta / p.angle) / rate,
            "that takes sin theta = theta all the way; the angles are not small",
        )
        .slip(
            exact.landing_time(),
            "that is when it lands; the wall lets go earlier",
        ),
    )?;
    report.add_claim(
        Claim::new(
            "omega_release",
            "angular velocity when the wall lets go",
            released.omega,
            "rad/s",
            spin,
            located(let_go.before[1]),
        )?
        .slip(
            2.0 * released.omega,
            "the ladder does not only turn about its middle: the middle moves too",
        )
        .slip(
            2.0 / 3.0_f64.sqrt() * released.omega,
            "the middle does not only move: the ladder turns as well",
        ),
    )?;
    report.add_claim(
        Claim::new(
            "vx_release",
            "horizontal velocity of the centre, from then on constant",
            released.vx_cm,
            "m/s",
            spin * l,
            located(let_go.before[3]),
        )?
        .slip(
            2.0 * released.vx_cm,
            "that is the velocity of the foot; the centre has half of it",
        ),
    )?;
    report.add_claim(
        Claim::new(
            "n_floor_release",
            "force of the floor over the weight when the wall lets go",
            released.floor_force,
            "-",
            force,
            located(at_release.floor / g),
        )?
        .slip(
            1.0,
            "the centre accelerates downward, so the floor carries less",
        ),
    )?;
    report.add_claim(
        Claim::new(
            "t_floor",
            "time at which the ladder lies on the floor",
            exact.landing_time(),
            "s",
            time,
            located(lands.t),
        )?
        .slip(
            exact.held_landing_time(),
            "that keeps the wall: it cannot pull the top",
        ),
    )?;
    report.add_claim(
        Claim::new(
            "omega_floor",
            "angular velocity with which it meets the floor",
            landed.omega,
            "rad/s",
            spin,
            simulated(lands.before[1]),
        )?
        .slip(
            (3.0 * g * start / l).sqrt(),
            "that turns all the energy into rotation; some of it slides away with the centre",
        ),
    )?;
    report.add_claim(Claim::new(
        "x_top_floor",
        "distance of the top from the wall when it meets the floor",
        landed.x_top,
        "m",
        place,
        simulated(scene.top_gap(&lands.before)),
    )?)?;

    // ANCHOR: naive
    let flat = naive.transition("lands")?;
    let pull = -scene.forces(Wall::Touches, &flat.before).wall / g;
    // ANCHOR_END: naive
    report.add_claim(Claim::new(
        "naive_pull",
        "wrong: pull of a wall that is kept to the floor, over the weight",
        1.5 * start,
        "-",
        force,
        simulated(pull),
    )?)?;
    report.add_claim(Claim::new(
        "naive_t_floor",
        "wrong: time of the fall with the wall kept",
        exact.held_landing_time(),
        "s",
        time,
        simulated(flat.t),
    )?)?;
    report.add_claim(Claim::new(
        "naive_omega_floor",
        "wrong: angular velocity at the floor with the wall kept",
        (3.0 * g * start / l).sqrt(),
        "rad/s",
        spin,
        simulated(flat.before[1]),
    )?)
}

/// The relative error to expect: the one asked for, and that of rounding theta, which
/// weighs more the flatter the ladder starts.
fn attainable(p: &Parameters) -> f64 {
    p.tolerance + 2.0 * EPS * tan(p.angle)
}

fn limits(p: &Parameters, solved: &Solved, report: &mut Report) -> Result<()> {
    let (l, g) = (p.length, p.gravity);
    let rate = (1.5 * g / l).sqrt();
    let lands = solved.run.transition("lands")?;
    report.add_limit(Limit::new(
        "energy at the floor",
        "nothing rubs: it is what it was at the start, in units of m g l/2",
        cos(p.angle),
        solved.scene.energy(&lands.before),
        8.0 * attainable(p),
    )?);

    let hair = Ladder::new(l, g, 1e-9)?;
    report.add_limit(Limit::new(
        "upright start: angle of release",
        "arccos(2/3), whatever length and gravity",
        acos(2.0 / 3.0),
        hair.release().theta,
        1e-15,
    )?);
    report.add_limit(Limit::new(
        "upright start: W t_release - ln(1/theta0)",
        "ln(8/(sqrt 6 + sqrt 5)): each factor ten nearer to upright costs ln(10)/W",
        log(8.0 / (6.0_f64.sqrt() + 5.0_f64.sqrt())),
        rate * hair.release_time() - log(1e9),
        1e-13,
    )?);

    // Nearly flat, the ladder turns with the constant acceleration W^2.
    let rise = 1e-6;
    let flat = Ladder::new(l, g, FRAC_PI_2 - rise)?;
    let unit = rise.sqrt() / rate;
    report.add_limit(Limit::new(
        "flat start: W t_release / sqrt(elevation)",
        "a third of the small height is fallen with the acceleration W^2",
        (2.0_f64 / 3.0).sqrt(),
        flat.release_time() / unit,
        1e-10,
    )?);
    report.add_limit(Limit::new(
        "flat start: W t_floor / sqrt(elevation)",
        "all of it, with the same acceleration",
        2.0_f64.sqrt(),
        flat.landing_time() / unit,
        1e-10,
    )?);
    Ok(())
}

// ANCHOR: strip
/// What accuracy costs: the error asked for, the error found, the work.
fn strip(p: &Parameters, solved: &Solved, report: &mut Report) -> Result<()> {
    let (exact, scene) = (solved.exact, solved.scene);
    let (start, end) = (scene.at_rest(p.angle), 2.0 * exact.landing_time());
    for requested in asked(p.tolerance, &REQUESTED) {
        let run = move || simulate_within(&scene, requested, Wall::Touches, start, end);
        let (delivered, work, again) = match run() {
            Ok(done) => (
                error(&exact, &done.run)?,
                done.work.to_string(),
                Some(Computation::new(run, move |done| error(&exact, &done.run))),
            ),
            Err(Error::NotDelivered { reached, .. }) => (reached, "refused".into(), None),
            Err(other) => return Err(other),
        };
        report.add_price(Price {
            method: "dial: DOP853, contact released".into(),
            requested: Some(requested),
            delivered,
            work,
            again,
        });
    }
    let kept = simulate_within(&Bilateral(&scene), p.tolerance, Wall::Touches, start, end)?;
    let run = move || {
        let method = Dop853::new(kept.step_error)?;
        simulate(&Bilateral(&scene), &method, Wall::Touches, start, end)
    };
    report.add_price(Price {
        method: "wrong: wall kept".into(),
        requested: Some(p.tolerance),
        delivered: landing_error(&exact, &kept.run)?,
        work: kept.run.work().to_string(),
        again: Some(Computation::new(run, move |run| landing_error(&exact, run))),
    });
    report.set_closed_form(ClosedForm::new(move |part| {
        exact.at(part * exact.landing_time())
    }));
    Ok(())
}
// ANCHOR_END: strip

/// The error asked for, and then the others.
fn asked(first: f64, others: &[f64]) -> Vec<f64> {
    let others = others.iter().copied().filter(|error| *error != first);
    core::iter::once(first).chain(others).collect()
}

const REQUESTED: [f64; 6] = [1e-3, 1e-5, 1e-7, 1e-9, 1e-11, 1e-13];

/// The largest relative error of times and rates at the release and at the floor.
fn error(exact: &Ladder, run: &Run<Wall, 4>) -> Result<f64> {
    let let_go = run.transition("wall lets go")?;
    let at_release = exact.release();
    let errors = [
        let_go.t / exact.release_time() - 1.0,
        let_go.before[0] / at_release.theta - 1.0,
        let_go.before[1] / at_release.omega - 1.0,
        let_go.before[3] / at_release.vx_cm - 1.0,
    ];
    let most = errors.iter().fold(0.0_f64, |most, e| most.max(e.abs()));
    Ok(most.max(landing_error(exact, run)?))
}

fn landing_error(exact: &Ladder, run: &Run<Wall, 4>) -> Result<f64> {
    let lands = run.transition("lands")?;
    let in_time = (lands.t / exact.landing_time() - 1.0).abs();
    let in_rate = (lands.before[1] / exact.landing().omega - 1.0).abs();
    Ok(in_time.max(in_rate))
}

/// The motion, for `--csv`.
fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let exact = Ladder::new(p.length, p.gravity, p.angle)?;
    let mut samples = Trajectory::new([
        "t [s]",
        "theta [rad]",
        "omega [rad/s]",
        "x_cm [m]",
        "y_cm [m]",
        "x_top [m]",
        "vx_cm [m/s]",
        "N_floor/mg",
        "N_wall/mg",
    ])?;
    for i in 0..=200 {
        let t = exact.landing_time() * f64::from(i) / 200.0;
        let s = exact.at(t)?;
        samples.push([
            t,
            s.theta,
            s.omega,
            s.x_cm,
            s.y_cm,
            s.x_top,
            s.vx_cm,
            s.floor_force,
            s.wall_force,
        ])?;
    }
    Ok(samples)
}

/// The example, as the command line, the tests and the book see it.
pub const EXAMPLE: Example<Parameters> = Example {
    stem: "ch16_ex6_ladder",
    about: "Exercise 16.6: a ladder slides down a smooth wall and leaves it",
    report,
    figures: figures::figures,
    trajectory,
    moving_picture: None,
};

fn main() -> ExitCode {
    EXAMPLE.main()
}
