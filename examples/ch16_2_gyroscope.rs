//! The gyroscope: equations (4) to (6) of the notes, Chapter 16, Section 2 (3).
//!
//! Without flags: the five motions of the notes' figures 3 and 4. With `--a`,
//! `--b`, `--c`, `--energy`, `--start`: the motion you ask for, in the notes'
//! dimensionless time t'. With `--i1`, `--i3`, `--mass`, ...: a gyroscope in SI
//! units, time in seconds, and `--with friction`, `--without gravity` for what acts on it.

#[path = "ch16_2_gyroscope/driven.rs"]
mod driven;
#[path = "ch16_2_gyroscope/fast.rs"]
mod fast;
#[path = "ch16_2_gyroscope/figures.rs"]
mod figures;
#[path = "ch16_2_gyroscope/friction.rs"]
mod friction;
#[path = "ch16_2_gyroscope/left_out.rs"]
mod left_out;
#[path = "ch16_2_gyroscope/limits.rs"]
mod limits;
#[path = "ch16_2_gyroscope/picture.rs"]
mod picture;
#[path = "ch16_2_gyroscope/rotor.rs"]
mod rotor;

use kit::{Claim, Report, Result, Trajectory, claim};
use models::heavy_top::{Motion, Nod, trajectory};
use rotation_dynamics::exact::heavy_top::{ReducedTop, Start};
use rotation_dynamics::integrators::{Ode, size_or};
use rotation_dynamics::math::sincos;

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

    fn scale(&self, y: &[f64; 4]) -> [f64; 4] {
        size_or([1.0; 4])(y)
    }
}
// ANCHOR_END: equations

impl Equations {
    /// The equations of this top, without friction.
    pub fn of(top: &ReducedTop) -> Self {
        Self { a: top.a(), b: top.b(), c: top.c(), friction: 0.0 }
    }
}

/// The five motions of figures 3 and 4: at the bottom of the valley and above
/// it for b > 1; loops, cusps and waves for b < 1.
pub fn of_the_notes() -> Result<[Motion; 5]> {
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
    Ok(motions.map(|motion| match motion.name {
        "steady" => motion.answers("Steady precession, b = 1.2"),
        "nutating" => motion.answers("Nods, b = 1.2"),
        "loops" => motion.answers("Loops, b = 0.6"),
        "cusps" => motion.answers("Cusps, b = 0.6"),
        _ => motion,
    }))
}

/// The motion on show, of which flags change a part: a, b, c and the energy. Released at rest, b < 1.
const CUSPS: [f64; 4] = [2.0, 0.6, 0.2, -0.08];

kit::parameters! {
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
    let reduced = [p.a, p.b, p.c, p.energy].iter().any(Option::is_some) || p.start != "theta_min";
    match (reduced, rotor::asked_for(p)) {
        (true, Some(_)) => Err(kit::Error::Text {
            text: "dimensionless and SI flags together".into(),
            allowed: "give either --a, --b, --c, --energy, --start or --i1, --i3, --mass, \
                      --length, --theta, --spin, --precession, --nutation, --with, --without",
        }),
        (true, None) => {
            let given = [p.a, p.b, p.c, p.energy];
            let [a, b, c, energy] = core::array::from_fn(|i| given[i].unwrap_or(CUSPS[i]));
            let start = match p.start {
                "theta_max" => Start::ThetaMax,
                _ => Start::ThetaMin,
            };
            let top = ReducedTop::new(a, b, c)?;
            Ok(vec![Motion::with_energy("", top, energy, start)?])
        }
        (false, Some(rotor)) => Ok(vec![rotor.motion()?]),
        (false, None) => Ok(of_the_notes()?.into()),
    }
}

/// The advance of phi a hair below the cusps, for the page's last section.
fn near_the_cusps() -> Result<Claim> {
    let (top, energy) = (ReducedTop::new(2.0, 0.6, 0.2)?, -0.0801);
    let waves = Motion::with_energy("hair", top, energy, Start::ThetaMin)?;
    let meaning = "advance of phi in one nod at E~ = -0.0801";
    let advance = waves.exact.precession_per_period();
    let nod = Nod::by_quadrature(&top, energy);
    Ok(claim("hair_precession", meaning, advance, "rad")
        .within(1e-12)
        .against("quadrature over one nod", nod.precession))
}

fn report(p: &Parameters) -> Result<Report> {
    let motions = motions(p)?;
    if driven::is_asked_for(p) {
        return driven::report(p);
    }
    let description = match motions.as_slice() {
        [one] => one.description(),
        _ => {
            "five motions of a symmetric rotor about a fixed point; time in sqrt(I1 I3)/L_z".into()
        }
    };
    let mut report = Report::new("The gyroscope", description)?;
    for motion in &motions {
        report.add(motion.claims(&Equations::of(&motion.top))?)?;
    }
    if let [_, nutating, loops, ..] = motions.as_slice() {
        report.add(near_the_cusps()?)?;
        limits::add(&mut report, loops)?;
        friction::add(&mut report)?;
        fast::add(&mut report)?;
        rotor::add(&mut report)?;
        left_out::add(&mut report)?;
        nutating.strip(&mut report, p.tolerance)?;
    } else {
        motions[0].strip(&mut report, p.tolerance)?;
    }
    Ok(report)
}

/// The motion, or the motions, for `--csv`.
fn samples(p: &Parameters) -> Result<Trajectory> {
    let motions = motions(p)?;
    match driven::is_asked_for(p) {
        true => driven::rotor(p)?.trajectory(),
        false => trajectory(&motions),
    }
}

kit::example! {
    ch16_2_gyroscope:
        "The gyroscope: precession and nutation, in closed form and by equations (4) to (6)";
    report, figures::all, samples, picture::moving
}
