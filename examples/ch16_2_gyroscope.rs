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
#[path = "ch16_2_gyroscope/price.rs"]
mod price;
#[path = "ch16_2_gyroscope/rotor.rs"]
mod rotor;

use rotation_dynamics::exact::heavy_top::{ReducedTop, Start};
use rotation_dynamics::integrators::Ode;
use rotation_dynamics::math::sincos;
use rotation_dynamics::report::heavy_top::{self, Motion};
use rotation_dynamics::report::{Example, Report, Trajectory};
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

impl Equations {
    /// The equations of this top, without friction.
    pub fn of(top: &ReducedTop) -> Self {
        Self {
            a: top.a(),
            b: top.b(),
            c: top.c(),
            friction: 0.0,
        }
    }
}

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

rotation_dynamics::parameters! {
    /// The notes' motions, unless something is set: then the motion asked for.
    pub struct Parameters {
        /// I3/I1, the shape: above 0, at most 2
        a: optional("-", any().usually(0.1, 2.0));
        /// L_Z/L_z, vertical over axial angular momentum
        b: optional("-", any());
        /// m g l I3/L_z^2, weight against spin
        c: optional("-", any());
        /// E~, at least the minimum of U_eff
        energy: optional("-", any());
        /// turning point at t' = 0
        start: choice("theta_min", "theta_max");
        /// moment of inertia across the axis, about the pivot
        i1: optional("kg m^2", any());
        /// moment of inertia about the axis
        i3: optional("kg m^2", any());
        /// mass
        mass: optional("kg", above(0.0));
        /// acceleration of gravity
        gravity: optional("m/s^2", any());
        /// from the pivot to the centre of mass
        length: optional("m", any());
        /// tilt of the axis at the start
        theta: optional("rad", any());
        /// angular velocity along the axis
        spin: optional("rad/s", any());
        /// rate of phi at the start
        precession: optional("rad/s", any());
        /// rate of theta at the start
        nutation: optional("rad/s", any());
        /// error asked of the attitude at the end: above 0, at most pi
        tolerance: number(1e-9, "rad", any());
    }
}

impl Parameters {
    /// I1, I3, mass, gravity, length, theta, spin, precession, nutation, in SI units.
    fn body(&self) -> [Option<f64>; 9] {
        [
            self.i1,
            self.i3,
            self.mass,
            self.gravity,
            self.length,
            self.theta,
            self.spin,
            self.precession,
            self.nutation,
        ]
    }
}

/// The motions that these parameters ask for.
fn motions(p: &Parameters) -> Result<Vec<Motion>> {
    let reduced = [p.a, p.b, p.c, p.energy].iter().any(Option::is_some) || p.start != "theta_min";
    let body = p.body().iter().any(Option::is_some);
    match (reduced, body) {
        (true, true) => Err(Error::Text {
            text: "dimensionless and SI flags together".into(),
            allowed: "give either --a, --b, --c, --energy, --start \
                      or --i1, --i3, --mass, --gravity, --length, --theta, --spin, --precession, --nutation",
        }),
        (true, false) => {
            let top = ReducedTop::new(p.a.unwrap_or(2.0), p.b.unwrap_or(1.2), p.c.unwrap_or(0.2))?;
            let start = match p.start {
                "theta_max" => Start::ThetaMax,
                _ => Start::ThetaMin,
            };
            let energy = p.energy.unwrap_or(0.55);
            Ok(vec![Motion::with_energy("", top, energy, start)?])
        }
        (false, true) => Ok(vec![rotor::motion(&p.body())?]),
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
        report.add(motion.claims(&Equations::of(&motion.top))?)?;
    }
    if motions.len() > 1 {
        limits::add(&mut report)?;
        rotor::add(&mut report)?;
    }
    // The motion that nods, or the only one.
    motions
        .get(1)
        .unwrap_or(&motions[0])
        .strip(&mut report, p.tolerance)?;
    Ok(report)
}

fn trajectory(p: &Parameters) -> Result<Trajectory> {
    heavy_top::trajectory(&motions(p)?)
}

/// The example: name, flags and functions.
pub const EXAMPLE: Example<Parameters> = Example {
    stem: "ch16_2_gyroscope",
    about: "The gyroscope: precession and nutation, in closed form and by equations (4) to (6)",
    report,
    figures: figures::all,
    trajectory,
    moving_picture: None,
};

fn main() -> std::process::ExitCode {
    EXAMPLE.main()
}
