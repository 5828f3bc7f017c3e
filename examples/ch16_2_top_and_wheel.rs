//! The top on its tip and the bicycle wheel hung by its axle: the notes, Chapter
//! 16, Section 2, "Other types of gyroscopes".
//!
//! The equations are the gyroscope's, with I1' = I1 + m l^2 for I1. Without flags:
//! both bodies. With `--body` or any other flag: that body as you want it; with
//! `--with air`, `--without gravity`: with what acts on it, stepped where no closed form knows it.

#[path = "ch16_2_top_and_wheel/figures.rs"]
mod figures;
#[path = "ch16_2_top_and_wheel/left_out.rs"]
mod left_out;
#[path = "ch16_2_top_and_wheel/limits.rs"]
mod limits;
#[path = "ch16_2_top_and_wheel/sleeping.rs"]
mod sleeping;
#[path = "ch16_2_top_and_wheel/waking.rs"]
mod waking;

use core::f64::consts::{FRAC_PI_2, PI, TAU};
use kit::prelude::*;
use kit::{Claim, EffectLine};
use models::heavy_top::{Added, Equations, Motion, Newton, Nod, Steady, Stepped};
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::body::RigidBody;
use rotation_dynamics::effects::GravityAtLever;
use rotation_dynamics::exact::heavy_top::{HeavyTop, SymmetricTop};
use rotation_dynamics::frame::DesignVector;
use rotation_dynamics::inertia::{InertiaTensor, MassProperties, PrincipalMoments};
use rotation_dynamics::integrators::Dop853;

// ANCHOR: body
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
// ANCHOR_END: body

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

    /// 2 sqrt(I1' m g l)/I3, rad/s: slower than this, an upright top falls.
    pub fn critical_spin(&self) -> f64 {
        2.0 * (self.moment() * self.weight_moment()).sqrt() / self.i3
    }

    /// Its motion in closed form: the gyroscope's, with I1' for I1.
    pub fn motion(&self, name: &'static str) -> rotation_dynamics::Result<Motion> {
        let (mass, gravity, lever) = (self.mass, self.gravity, self.length);
        let top = SymmetricTop::from_mass(self.moment(), self.i3, mass, gravity, lever)?;
        Motion::new(name, HeavyTop::from_body(top, self.tilted(), self.rates())?)
    }

    /// Where it starts.
    pub const fn tilted(&self) -> EulerAngles {
        EulerAngles { phi: 0.0, theta: self.theta, zeta: 0.0 }
    }

    /// How it starts to turn: along the line of nodes, at right angles to it, along the axis.
    pub fn rates(&self) -> BodyVector {
        BodyVector::new(self.nutation, self.precession * sin(self.theta), self.spin)
    }
}
// ANCHOR_END: fixed_point

impl Body {
    /// As a rigid body that turns about its fixed point.
    fn rigid(&self) -> Result<RigidBody> {
        Ok(RigidBody::new(PrincipalMoments::symmetric(self.moment(), self.i3)?))
    }

    fn weight(&self) -> Result<GravityAtLever> {
        Ok(GravityAtLever::new(self.mass * self.gravity, self.length)?)
    }

    /// I1' as a claim, against the tensor of the displaced body.
    fn moment_claim(&self, name: &str) -> Result<Claim> {
        let tensor = InertiaTensor::diagonal([self.i1, self.i1, self.i3])?;
        let centre = DesignVector::new(0.0, 0.0, self.length);
        let moved = MassProperties::new(self.mass, centre, tensor)?.about(DesignVector::zero())?;
        let across = moved.moment_about(DesignVector::new(1.0, 0.0, 0.0))?;
        let meaning = format!("{name}: I1', across the axis about the fixed point");
        let claim = claim(format!("{name}_moment"), meaning, self.moment(), "kg m^2");
        Ok(claim
            .agrees_with("tensor of the displaced body", across, 1e-15 * self.moment())
            .slip(self.i1, "that is about the centre of mass, which moves")
            .answer("About the fixed point"))
    }
}

parameters! {
    /// Both bodies, unless something is set: then that body as it is asked for.
    pub struct Parameters {
        /// which body; the other flags change this one (both: the top)
        body: choice("both", "top", "wheel");
        /// mass
        mass: optional("kg", above(0.0).usually(0.02, 3.0)).shown(TOP.mass).open("mass of the top", "light", "heavy");
        /// from the fixed point to the centre of mass
        length: optional("m", any().usually(0.01, 0.3)).shown(TOP.length).open("from the tip to the centre of mass", "low", "high");
        /// moment of inertia across the axis, about the centre of mass
        i1: optional("kg m^2", any()).shown(TOP.i1);
        /// moment of inertia about the axis
        i3: optional("kg m^2", any()).shown(TOP.i3);
        /// tilt of the axis at the start
        theta: optional("rad", any().usually(0.01, 3.0)).shown(TOP.theta);
        /// angular velocity along the axis
        spin: optional("rad/s", any().usually(10.0, 400.0)).shown(TOP.spin);
        /// rate of phi at the start
        precession: optional("rad/s", any().usually(-10.0, 10.0)).shown(TOP.precession);
        /// rate of theta at the start
        nutation: optional("rad/s", any().usually(-10.0, 10.0)).shown(TOP.nutation);
        /// acceleration of gravity
        gravity: effect(9.80665, "m/s^2", above(0.0).usually(1.0, 25.0)).present();
        /// bearing about which the axis nods, torque over dtheta/dt
        friction: effect(1e-5, "N m s", above(0.0));
        /// air about the body, a disc: its density
        air: effect(1.204, "kg/m^3", above(0.0));
        /// dry friction against the spin, at the tip or in the bearings: its torque
        brake: effect(5e-6, "N m", above(0.0));
        /// error asked of the attitude at the end: above 0, at most pi
        tolerance: number(1e-9, "rad", any());
    }
}

impl Parameters {
    /// `body` with what is set.
    fn applied_to(&self, body: Body) -> Body {
        Body {
            mass: self.mass.unwrap_or(body.mass),
            length: self.length.unwrap_or(body.length),
            i1: self.i1.unwrap_or(body.i1),
            i3: self.i3.unwrap_or(body.i3),
            gravity: self.gravity.unwrap_or(0.0),
            theta: self.theta.unwrap_or(body.theta),
            spin: self.spin.unwrap_or(body.spin),
            precession: self.precession.unwrap_or(body.precession),
            nutation: self.nutation.unwrap_or(body.nutation),
        }
    }

    /// The bodies asked for, with their names.
    fn bodies(&self) -> Vec<(&'static str, Body)> {
        let plain = Self { tolerance: self.tolerance, ..Self::default() };
        match self.body {
            "wheel" => vec![("wheel", self.applied_to(WHEEL))],
            _ if *self == plain => vec![("top", TOP), ("wheel", WHEEL)],
            _ => vec![("top", self.applied_to(TOP))],
        }
    }

    fn motions(&self) -> Result<Vec<Motion>> {
        let heading = |name| if name == "top" { "The leaning top" } else { "The wheel" };
        let motion = |(name, body): (_, Body)| Ok(body.motion(name)?.answers(heading(name)));
        self.bodies().into_iter().map(motion).collect()
    }

    /// Whether something is put in that no closed form knows.
    fn is_driven(&self) -> bool {
        [self.friction, self.air, self.brake].iter().any(Option::is_some)
    }

    /// The body asked for with what is put in, stepped for a second.
    fn driven(&self) -> Result<Stepped> {
        let (body, radius) = match self.body {
            "wheel" => (self.applied_to(WHEEL), 0.35),
            _ => (self.applied_to(TOP), 0.0283),
        };
        let (rigid, gravity) = (body.rigid()?, self.gravity.map(|_| body.weight()).transpose()?);
        let start = rigid.state(Attitude::from_euler(body.tilted())?, body.rates())?;
        if let Some(brake) = self.brake {
            // The angular momentum along the axis, over the second.
            let most = body.i3 * body.spin.abs();
            allowed! { "brake": brake, between(0.0, most), "more stops the spin in the time that is looked at"; }?;
        }
        let added = Added { nodes: self.friction, dry: self.brake, ..Added::default() };
        let added = added.in_air(self.air, radius, body.spin)?;
        Stepped::new(rigid, gravity, added, start, 1.0)
    }
}

fn report(p: &Parameters) -> Result<Report> {
    let motions = p.motions()?;
    if p.is_driven() {
        let names = ["bearing of the line of nodes", "air", "dry friction against the spin"];
        let heads = ["The top and the bicycle wheel", "a body"];
        return p.driven()?.report(heads, p.tolerance, names);
    }
    let description = match &motions[..] {
        [one] => one.description(),
        _ => "a toy top on its tip and a bicycle wheel hung by its axle: gyroscopes whose centre of mass moves".into(),
    };
    let mut report = Report::new("The top and the bicycle wheel", description)?;
    for ((name, body), motion) in p.bodies().iter().zip(&motions) {
        report.add(body.moment_claim(name)?)?;
        report.add(motion.claims(&Equations(motion.top))?)?;
    }
    if motions.len() > 1 {
        sleeping::claims(&mut report)?;
        limits::tries(&mut report)?;
        limits::limits(&mut report)?;
        left_out::effects(&mut report)?;
    }
    motions[0].strip(&mut report, p.tolerance)?;
    Ok(report)
}

fn trajectory(p: &Parameters) -> Result<Trajectory> {
    if p.is_driven() {
        p.driven()?.trajectory()
    } else {
        models::heavy_top::trajectory(&p.motions()?)
    }
}

example! {
    ch16_2_top_and_wheel: "The top on its tip and the bicycle wheel hung by its axle";
    report, figures::all, trajectory, waking::moving_picture
}
