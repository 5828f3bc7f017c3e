//! The gyroscope: equations (4) to (6) of the notes, Chapter 16, Section 2 (3).
//!
//! Without flags: the five motions of the notes' figures 3 and 4. With `--a`,
//! `--b`, `--c`, `--energy`, `--start`: the motion you ask for, in the notes'
//! dimensionless time t'. With `--i1`, `--i3`, `--mass`, ...: a gyroscope in SI
//! units, time in seconds, and `--with friction`, `--without gravity` for what acts on it.

#[path = "ch16_2_gyroscope/fast.rs"]
pub mod fast;
#[path = "ch16_2_gyroscope/figures.rs"]
mod figures;
#[path = "ch16_2_gyroscope/friction.rs"]
mod friction;
#[path = "ch16_2_gyroscope/left_out.rs"]
mod left_out;
#[path = "ch16_2_gyroscope/limits.rs"]
mod limits;
#[path = "ch16_2_gyroscope/rotor.rs"]
mod rotor;

use core::f64::consts::{PI, TAU};
use kit::prelude::*;
use models::heavy_top::{Motion, Nod, Steady};
use rotation_dynamics::exact::heavy_top::{HeavyTop, ReducedTop, Start};
use rotation_dynamics::integrators::{Ode, ode, size_or};

// ANCHOR: equations
/// Equations (4) to (6), of theta, dtheta/dt', phi, zeta. A bearing may add the torque
/// -friction dtheta/dt'; in the notes it is 0.
fn equations(top: ReducedTop, friction: f64) -> impl Ode<4> {
    let (a, b, c) = (top.a(), top.b(), top.c());
    ode(move |_, &[theta, nutation, _, _]: &[f64; 4]| {
        let (s, u) = sincos(theta);
        let precession = a.sqrt() * (b - u) / (s * s); // (5)
        // (4), solved for the second derivative
        let nods = c * s - a * (b - u) * (1.0 - b * u) / (s * s * s) - friction * nutation;
        let spin = 1.0 / a.sqrt() - precession * u; // (6)
        [nutation, nods, precession, spin]
    })
    .scaled(size_or([1.0; 4]))
}
// ANCHOR_END: equations

/// The five motions of figures 3 and 4: at the bottom of the valley and above
/// it for b > 1; loops, cusps and waves for b < 1.
fn of_the_notes() -> Result<Vec<Motion>> {
    // ANCHOR: motions
    let steep = ReducedTop::new(2.0, 1.2, 0.2)?; // a, b, c of the notes' figure 3
    let gentle = ReducedTop::new(2.0, 0.6, 0.2)?; // and of their figure 4
    let (bottom, _) = steep.minimum();
    let motions = [
        Motion::at_rest_in_theta("steady", steep, bottom)?,
        Motion::with_energy("nutating", steep, 0.55, Start::ThetaMin)?,
        Motion::with_energy("loops", gentle, 0.11, Start::ThetaMin)?,
        Motion::with_energy("cusps", gentle, -0.08, Start::ThetaMin)?,
        Motion::with_energy("waves", gentle, -0.085, Start::ThetaMin)?,
    ];
    // ANCHOR_END: motions
    let answers =
        ["Steady precession, b = 1.2", "Nods, b = 1.2", "Loops, b = 0.6", "Cusps, b = 0.6", ""];
    Ok(motions.into_iter().zip(answers).map(|(motion, heading)| motion.answers(heading)).collect())
}

/// The motion on show, of which flags change a part: a, b, c and the energy. Released at rest, b < 1.
const CUSPS: [f64; 4] = [2.0, 0.6, 0.2, -0.08];

parameters! {
    /// The notes' motions, unless something is set: then the motion asked for.
    pub struct Parameters {
        /// I3/I1, the shape: above 0, at most 2
        a: optional("-", any().usually(0.3, 2.0)).shown(CUSPS[0]);
        /// L_Z/L_z, vertical over axial angular momentum
        b: optional("-", any().usually(-0.2, 0.64)).shown(CUSPS[1]);
        /// m g l I3/L_z^2, weight against spin
        c: optional("-", any().usually(0.19, 0.5)).shown(CUSPS[2]);
        /// E~, at least the minimum of U_eff
        energy: optional("-", any().usually(-0.087, -0.05)).shown(CUSPS[3]).open("push at release, as an energy", "forward: waves", "backward: loops");
        /// turning point at t' = 0
        start: choice("theta_min", "theta_max");
        /// moment of inertia across the axis, about the pivot
        i1: optional("kg m^2", any());
        /// moment of inertia about the axis
        i3: optional("kg m^2", any());
        /// mass
        mass: optional("kg", above(0.0));
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
        /// acceleration of gravity
        gravity: effect(9.80665, "m/s^2", above(0.0)).present();
        /// bearing about which the axis nods, torque over dtheta/dt
        friction: effect(0.02, "N m s", above(0.0));
        /// air about the rotor, a disc: its density
        air: effect(1.204, "kg/m^3", above(0.0));
        /// bearings of the axle, dry: their torque
        bearing: effect(1.5e-5, "N m", above(0.0));
        /// error asked of the attitude at the end: above 0, at most pi
        tolerance: number(1e-9, "rad", any());
    }
}

/// The motions that these parameters ask for.
fn motions(p: &Parameters) -> Result<Vec<Motion>> {
    let given = [p.a, p.b, p.c, p.energy];
    let reduced = given.iter().any(Option::is_some) || p.start != "theta_min";
    match (reduced, rotor::asked_for(p)) {
        (true, Some(_)) => Err(kit::Error::Text {
            text: "dimensionless and SI flags together".into(),
            allowed: "give either --a, --b, --c, --energy, --start or --i1, --i3, --mass, \
                      --length, --theta, --spin, --precession, --nutation, --with, --without",
        }),
        (true, None) => {
            let [a, b, c, energy] = core::array::from_fn(|i| given[i].unwrap_or(CUSPS[i]));
            let start = if p.start == "theta_max" { Start::ThetaMax } else { Start::ThetaMin };
            let top = ReducedTop::new(a, b, c)?;
            Ok(vec![Motion::with_energy("", top, energy, start)?])
        }
        (false, Some(rotor)) => Ok(vec![rotor.motion()?]),
        (false, None) => of_the_notes(),
    }
}

fn report(p: &Parameters) -> Result<Report> {
    let motions = motions(p)?;
    if rotor::is_driven(p) {
        let names = ["bearing of the line of nodes", "air on the rotor", "bearings of the axle"];
        return rotor::driven(p)?.report(["The gyroscope", "a rotor"], p.tolerance, names);
    }
    let description = match &motions[..] {
        [one] => one.description(),
        _ => {
            "five motions of a symmetric rotor about a fixed point; time in sqrt(I1 I3)/L_z".into()
        }
    };
    let mut report = Report::new("The gyroscope", description)?;
    for motion in &motions {
        report.add(motion.claims(&equations(motion.top, 0.0))?)?;
    }
    let [_, nutating, loops, ..] = &motions[..] else {
        motions[0].strip(&mut report, p.tolerance)?;
        return Ok(report);
    };
    limits::claims(loops, &mut report)?;
    limits::limits(&mut report)?;
    friction::claims(&mut report)?;
    fast::claims(&mut report)?;
    rotor::claims(&mut report)?;
    left_out::effects(&mut report)?;
    nutating.strip(&mut report, p.tolerance)?;
    Ok(report)
}

/// The motion, or the motions, for `--csv`.
fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let motions = motions(p)?;
    match rotor::is_driven(p) {
        true => rotor::driven(p)?.trajectory(),
        false => models::heavy_top::trajectory(&motions),
    }
}

example! {
    ch16_2_gyroscope:
        "The gyroscope: precession and nutation, in closed form and by equations (4) to (6)";
    report, figures::all, trajectory, figures::moving_picture
}
