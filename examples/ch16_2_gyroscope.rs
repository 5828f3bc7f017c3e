//! The gyroscope: equations (4) to (6) of the notes, Chapter 16, Section 2 (3).
//!
//! Without flags: the five motions of the notes' figures 3 and 4. With `--a`,
//! `--b`, `--c`, `--energy`, `--start`: the motion you ask for, in the notes'
//! dimensionless time t'. With `--i1`, `--i3`, `--mass`, ...: a gyroscope in SI
//! units, time in seconds.

#[path = "ch16_2_gyroscope/figures.rs"]
mod figures;
#[path = "ch16_2_gyroscope/limits.rs"]
mod limits;
#[path = "ch16_2_gyroscope/motions.rs"]
pub mod motions;
#[path = "ch16_2_gyroscope/picture.rs"]
pub mod picture;
#[path = "ch16_2_gyroscope/price.rs"]
pub mod price;
#[path = "ch16_2_gyroscope/rotor.rs"]
mod rotor;
#[path = "ch16_2_gyroscope/routes.rs"]
pub mod routes;

use motions::Motion;
use rotation_dynamics::exact::heavy_top::{ReducedTop, Start};
use rotation_dynamics::integrators::Ode;
use rotation_dynamics::math::sincos;
use rotation_dynamics::report::cli::{Example, Flag};
use rotation_dynamics::report::{Report, Trajectory};
use rotation_dynamics::{Error, Result};

// ANCHOR: equations
/// Equations (4) to (6). The state is theta, dtheta/dt', phi, zeta.
pub struct Equations {
    pub a: f64,
    pub b: f64,
    pub c: f64,
    /// Torque of a bearing, -friction dtheta/dt'; 0 in the notes.
    pub friction: f64,
}

impl Ode<4> for Equations {
    fn derivative(&self, _t: f64, &[theta, nutation, _, _]: &[f64; 4]) -> [f64; 4] {
        let Self { a, b, c, friction } = *self;
        let (s, u) = sincos(theta);
        let precession = a.sqrt() * (b - u) / (s * s); // (5)
        [
            nutation,
            // (4), solved for the second derivative
            c * s - a * (b - u) * (1.0 - b * u) / (s * s * s) - friction * nutation,
            precession,
            1.0 / a.sqrt() - precession * u, // (6)
        ]
    }
}
// ANCHOR_END: equations

/// The five motions of figures 3 and 4: at the bottom of the valley and above
/// it for b > 1; loops, cusps and waves for b < 1.
pub fn of_the_notes() -> Result<Vec<Motion>> {
    // ANCHOR: motions
    let steep = ReducedTop::new(2.0, 1.2, 0.2)?; // a, b, c of figure 3
    let gentle = ReducedTop::new(2.0, 0.6, 0.2)?; // and of figure 4
    let (bottom, _) = steep.minimum();
    Ok(vec![
        Motion::at_rest_in_theta("steady", steep, bottom)?,
        Motion::with_energy("nutating", steep, 0.55, Start::ThetaMin)?,
        Motion::with_energy("loops", gentle, 0.11, Start::ThetaMin)?,
        Motion::with_energy("cusps", gentle, -0.08, Start::ThetaMin)?,
        Motion::with_energy("waves", gentle, -0.085, Start::ThetaMin)?,
    ])
    // ANCHOR_END: motions
}

/// What can be set on the command line; `None` where the notes' value is meant.
#[derive(Debug, Clone)]
pub struct Parameters {
    /// I3/I1, L_Z/L_z, m g l I3/L_z^2, and E~: the notes' dimensionless numbers.
    pub reduced: [Option<f64>; 4],
    /// `theta_min` or `theta_max`: the turning point at which the motion starts.
    pub start: &'static str,
    /// I1, I3, mass, gravity, length, theta, spin, precession, nutation, in SI units.
    pub body: [Option<f64>; 9],
    /// The error of the attitude at the end that the dial is asked for, rad.
    pub tolerance: f64,
}

impl Default for Parameters {
    fn default() -> Self {
        Self {
            reduced: [None; 4],
            start: "theta_min",
            body: [None; 9],
            tolerance: 1e-9,
        }
    }
}

/// The motions that these parameters ask for.
fn motions(p: &Parameters) -> Result<Vec<Motion>> {
    let reduced = p.reduced.iter().any(Option::is_some) || p.start != "theta_min";
    let body = p.body.iter().any(Option::is_some);
    match (reduced, body) {
        (true, true) => Err(Error::Text {
            text: "dimensionless and SI flags together".into(),
            allowed: "give either --a, --b, --c, --energy, --start \
                      or --i1, --i3, --mass, --gravity, --length, --theta, --spin, --precession, --nutation",
        }),
        (true, false) => {
            let [a, b, c, energy] = p.reduced;
            Ok(vec![Motion::reduced(
                a.unwrap_or(2.0),
                b.unwrap_or(1.2),
                c.unwrap_or(0.2),
                energy.unwrap_or(0.55),
                p.start,
            )?])
        }
        (false, true) => Ok(vec![rotor::motion(&p.body)?]),
        (false, false) => of_the_notes(),
    }
}

fn report(p: &Parameters) -> Result<Report> {
    let motions = motions(p)?;
    let mut report = Report::new(
        "The gyroscope",
        match motions.as_slice() {
            [one] => one.description(),
            _ => "five motions of a symmetric rotor about a fixed point; time in sqrt(I1 I3)/L_z"
                .into(),
        },
    )?;
    for motion in &motions {
        motion.add_claims(&mut report)?;
    }
    if motions.len() > 1 {
        limits::add(&mut report)?;
        rotor::add(&mut report)?;
    }
    price::add(&mut report, &motions, p.tolerance)?;
    Ok(report)
}

fn trajectory(p: &Parameters) -> Result<Trajectory> {
    motions::trajectory(&motions(p)?)
}

/// The example: name, flags and functions.
pub const EXAMPLE: Example<Parameters> = Example {
    stem: "ch16_2_gyroscope",
    about: "The gyroscope: precession and nutation, in closed form and by equations (4) to (6)",
    flags: &[
        Flag::number(
            "a",
            "-",
            "I3/I1, the shape: above 0, at most 2",
            |p| p.reduced[0],
            |p, x| p.reduced[0] = Some(x),
        ),
        Flag::number(
            "b",
            "-",
            "L_Z/L_z, vertical over axial angular momentum",
            |p| p.reduced[1],
            |p, x| p.reduced[1] = Some(x),
        ),
        Flag::number(
            "c",
            "-",
            "m g l I3/L_z^2, weight against spin",
            |p| p.reduced[2],
            |p, x| p.reduced[2] = Some(x),
        ),
        Flag::number(
            "energy",
            "-",
            "E~, at least the minimum of U_eff",
            |p| p.reduced[3],
            |p, x| p.reduced[3] = Some(x),
        ),
        Flag::choice(
            "start",
            "turning point at t' = 0",
            &["theta_min", "theta_max"],
            |p| p.start,
            |p, x| p.start = x,
        ),
        Flag::number(
            "i1",
            "kg m^2",
            "moment of inertia across the axis, about the pivot",
            |p| p.body[0],
            |p, x| p.body[0] = Some(x),
        ),
        Flag::number(
            "i3",
            "kg m^2",
            "moment of inertia about the axis",
            |p| p.body[1],
            |p, x| p.body[1] = Some(x),
        ),
        Flag::number(
            "mass",
            "kg",
            "mass",
            |p| p.body[2],
            |p, x| p.body[2] = Some(x),
        ),
        Flag::number(
            "gravity",
            "m/s^2",
            "acceleration of gravity",
            |p| p.body[3],
            |p, x| p.body[3] = Some(x),
        ),
        Flag::number(
            "length",
            "m",
            "from the pivot to the centre of mass",
            |p| p.body[4],
            |p, x| p.body[4] = Some(x),
        ),
        Flag::number(
            "theta",
            "rad",
            "tilt of the axis at the start",
            |p| p.body[5],
            |p, x| p.body[5] = Some(x),
        ),
        Flag::number(
            "spin",
            "rad/s",
            "angular velocity along the axis",
            |p| p.body[6],
            |p, x| p.body[6] = Some(x),
        ),
        Flag::number(
            "precession",
            "rad/s",
            "rate of phi at the start",
            |p| p.body[7],
            |p, x| p.body[7] = Some(x),
        ),
        Flag::number(
            "nutation",
            "rad/s",
            "rate of theta at the start",
            |p| p.body[8],
            |p, x| p.body[8] = Some(x),
        ),
        Flag::number(
            "tolerance",
            "rad",
            "error asked of the attitude at the end: above 0, at most pi",
            |p| Some(p.tolerance),
            |p, x| p.tolerance = x,
        ),
    ],
    report,
    figures: figures::all,
    trajectory,
};

#[allow(
    dead_code,
    reason = "the tests include this file as a module and call EXAMPLE"
)]
fn main() -> std::process::ExitCode {
    EXAMPLE.main()
}
