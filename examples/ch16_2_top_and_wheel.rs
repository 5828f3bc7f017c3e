//! The top on its tip and the bicycle wheel hung by its axle: the notes, Chapter
//! 16, Section 2, "Other types of gyroscopes".
//!
//! The equations are the gyroscope's, with I1' = I1 + m l^2 for I1. Without flags:
//! both bodies. With `--body` or any other flag: that body as you want it.

#[path = "ch16_2_top_and_wheel/bodies.rs"]
mod bodies;
#[path = "ch16_2_top_and_wheel/figures.rs"]
mod figures;
#[path = "ch16_2_top_and_wheel/left_out.rs"]
mod left_out;
#[path = "ch16_2_top_and_wheel/sleeping.rs"]
mod sleeping;

use rotation_dynamics::Result;
use rotation_dynamics::report::heavy_top::{self, Motion};
use rotation_dynamics::report::{Example, Report, Trajectory};

use core::f64::consts::FRAC_PI_2;

/// A body that turns about a point of its axis, and how it starts. SI units.
#[derive(Debug, Clone, Copy)]
pub struct Body {
    pub mass: f64,
    /// From the fixed point to the centre of mass.
    pub length: f64,
    /// About the centre of mass, across the axis.
    pub i1: f64,
    pub i3: f64,
    pub gravity: f64,
    pub theta: f64,
    pub spin: f64,
    pub precession: f64,
    pub nutation: f64,
}

/// A wooden top: 100 g, its centre of mass 4 cm above the tip, 1430 turns a minute.
pub const TOP: Body = Body {
    mass: 0.1,
    length: 0.04,
    i1: 4e-5,
    i3: 4e-5,
    gravity: 9.80665,
    theta: 0.4,
    spin: 150.0,
    precession: 0.0,
    nutation: 0.0,
};

/// A bicycle wheel: 2 kg, all of it at 33 cm, hung by its axle 15 cm from the hub.
pub const WHEEL: Body = Body {
    mass: 2.0,
    length: 0.15,
    i1: 0.1089,
    i3: 0.2178,
    gravity: 9.80665,
    theta: FRAC_PI_2,
    spin: 20.0,
    precession: 0.0,
    nutation: 0.0,
};

// ANCHOR: fixed_point
impl Body {
    /// I1' = I1 + m l^2: the moment across the axis about the fixed point.
    pub fn moment(&self) -> f64 {
        self.i1 + self.mass * self.length * self.length
    }

    /// m g l, N m.
    pub fn weight_moment(&self) -> f64 {
        self.mass * self.gravity * self.length
    }
}

/// 2 sqrt(I1' m g l)/I3, rad/s: slower than this, an upright top falls.
pub fn critical_spin(body: &Body) -> f64 {
    2.0 * (body.moment() * body.weight_moment()).sqrt() / body.i3
}
// ANCHOR_END: fixed_point

rotation_dynamics::parameters! {
    /// Both bodies, unless something is set: then that body as it is asked for.
    pub struct Parameters {
        /// which body; the other flags change this one (both: the top)
        body: choice("both", "top", "wheel");
        /// mass
        mass: optional("kg", above(0.0));
        /// from the fixed point to the centre of mass
        length: optional("m", any());
        /// moment of inertia across the axis, about the centre of mass
        i1: optional("kg m^2", any());
        /// moment of inertia about the axis
        i3: optional("kg m^2", any());
        /// acceleration of gravity
        gravity: optional("m/s^2", any());
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
    /// Mass, length, I1 about the centre of mass, I3, gravity, tilt, spin, precession
    /// and nutation at the start, in SI units.
    fn given(&self) -> [Option<f64>; 9] {
        [
            self.mass,
            self.length,
            self.i1,
            self.i3,
            self.gravity,
            self.theta,
            self.spin,
            self.precession,
            self.nutation,
        ]
    }
}

/// The bodies asked for, with their names.
fn bodies(p: &Parameters) -> Vec<(&'static str, Body)> {
    let with = |body: Body| body.with(&p.given());
    match p.body {
        "wheel" => vec![("wheel", with(WHEEL))],
        "top" => vec![("top", with(TOP))],
        _ if p.given().iter().any(Option::is_some) => vec![("top", with(TOP))],
        _ => vec![("top", TOP), ("wheel", WHEEL)],
    }
}

fn motions(p: &Parameters) -> Result<Vec<Motion>> {
    let named = bodies(p);
    named.iter().map(|(name, body)| body.motion(name)).collect()
}

fn report(p: &Parameters) -> Result<Report> {
    let named = bodies(p);
    let motions = motions(p)?;
    let description = match motions.as_slice() {
        [one] => one.description(),
        _ => "a toy top on its tip and a bicycle wheel hung by its axle: gyroscopes whose centre of mass moves".into(),
    };
    let mut report = Report::new("The top and the bicycle wheel", description)?;
    for ((name, body), motion) in named.iter().zip(&motions) {
        body.add_moment(name, &mut report)?;
        report.add(motion.claims(&motion.top)?)?;
    }
    if motions.len() > 1 {
        sleeping::add(&mut report)?;
        bodies::add_limits(&mut report)?;
        left_out::add(&mut report);
    }
    motions[0].strip(&mut report, p.tolerance)?;
    Ok(report)
}

fn trajectory(p: &Parameters) -> Result<Trajectory> {
    heavy_top::trajectory(&motions(p)?)
}

/// The example: name, flags and functions.
pub const EXAMPLE: Example<Parameters> = Example {
    stem: "ch16_2_top_and_wheel",
    about: "The top on its tip and the bicycle wheel hung by its axle",
    report,
    figures: figures::all,
    trajectory,
    moving_picture: None,
};

fn main() -> std::process::ExitCode {
    EXAMPLE.main()
}
