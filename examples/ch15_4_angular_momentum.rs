//! Angular momentum of a rigid body: the notes, Chapter 15, Section 4, with its examples.
//!
//! The flags without a prefix are the cylinder on a slanting shaft; those of the other
//! examples begin with the name of theirs.

#[path = "ch15_4_angular_momentum/figures.rs"]
mod figures;
#[path = "ch15_2_rolling/hoop.rs"]
mod hoop;
#[path = "ch15_4_angular_momentum/left_out.rs"]
pub mod left_out;
#[path = "ch15_4_angular_momentum/swarm.rs"]
pub mod swarm;
#[path = "ch15_4_angular_momentum/worked.rs"]
pub mod worked;

use core::f64::consts::{FRAC_PI_2, PI, TAU};
use kit::prelude::*;
use kit::short;
use rotation_dynamics::accuracy::Problem;
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::body::RigidBody;
use rotation_dynamics::effects::{Effect, Torque};
use rotation_dynamics::frame::DesignVector;
use rotation_dynamics::inertia::{InertiaTensor, MassProperties, PrincipalMoments, solids};
use rotation_dynamics::scene::Scene;
use swarm::{ORIGIN, Swarm, angle, cylinder, on_axes};

parameters! {
    /// The cylinder of the notes' fifth example, and the bodies of the others.
    pub struct Parameters {
        /// mass of the cylinder
        mass: number(2.0, "kg", above(0.0).usually(0.5, 5.0));
        /// radius of the cylinder
        radius: number(0.05, "m", above(0.0).usually(0.02, 0.3));
        /// height of the cylinder
        height: number(0.3, "m", above(0.0).usually(0.02, 0.5)).open("height of the cylinder", "a disc", "a rod");
        /// angle between the cylinder and the shaft
        tilt: number(0.5, "rad", from_to(0.0, FRAC_PI_2).because("the smaller angle between two lines").usually(0.0, FRAC_PI_2)).open("angle between cylinder and shaft", "along the shaft", "across it");
        /// angular velocity of the shaft
        rate: number(10.0, "rad/s", any().but_zero("at rest L has no direction").usually(2.0, 20.0));
        /// mass of the rolling wheel
        wheel_mass: number(2.0, "kg", above(0.0));
        /// radius of the rolling wheel
        wheel_radius: number(0.35, "m", above(0.0));
        /// angular velocity of the rolling wheel
        wheel_rate: number(20.0, "rad/s", any().but_zero("at rest nothing rolls"));
        /// mass of the coin
        coin_mass: number(0.0057, "kg", above(0.0));
        /// radius of the coin, and of the fixed one
        coin_radius: number(0.0121, "m", above(0.0));
        /// angular velocity of the line of centres
        coin_rate: number(2.0, "rad/s", any().but_zero("at rest nothing rolls"));
        /// mass of the wheel on the shaft
        runner_mass: number(1.5, "kg", above(0.0));
        /// radius of the wheel on the shaft
        runner_radius: number(0.3, "m", above(0.0));
        /// length of the shaft
        runner_shaft: number(0.5, "m", above(0.0));
        /// angular velocity of the shaft about the vertical
        runner_rate: number(2.0, "rad/s", from_to(-1e6, 1e6).but_zero("at rest nothing rolls"));
        gravity: gravity(at_least(0.0));
        /// mass of the square plate
        plate_mass: number(1.5, "kg", above(0.0));
        /// side of the plate
        plate_side: number(0.4, "m", above(0.0));
        /// angular velocity of the plate about an edge
        plate_rate: number(3.0, "rad/s", any().but_zero("at rest L has no direction"));
        /// drag coefficient of the cylinder in air, for the claims about it
        air: effect(1.2, "-", above_to(0.0, 1e6));
        /// error asked of the cylinder's attitude after ten turns: above 0, at most pi
        tolerance: number(1e-9, "rad", any());
    }
}

/// Four masses, rigidly joined by rods without mass: kg, m.
pub const FOUR: [(f64, [f64; 3]); 4] = [
    (1.0, [0.1, 0.2, 0.3]),
    (2.0, [-0.4, 0.5, 0.0]),
    (1.5, [0.3, -0.2, 0.6]),
    (0.5, [0.0, 0.7, -0.4]),
];
/// How they turn (rad/s), and how fast their origin moves (m/s) where it does.
pub const TURNING: [f64; 3] = [0.4, -0.3, 2.0];
pub const MOVING: [f64; 3] = [0.5, -0.2, 0.1];

// ANCHOR: tensor
/// I about the point `about`, from masses and places.
pub fn tensor_of_four(about: DesignVector) -> rotation_dynamics::Result<InertiaTensor> {
    let points = FOUR.map(|(mass, place)| (mass, DesignVector::from_array(place)));
    MassProperties::of_points(&points)?.about(about)
}
// ANCHOR_END: tensor

/// The four as grains that turn about the origin, which moves.
pub fn four(omega: [f64; 3], moving: [f64; 3]) -> Swarm {
    let grains = FOUR.map(|(mass, place)| (mass, BodyVector::from_array(place)));
    Swarm::turning(grains.into(), omega.into(), moving.into())
}

/// The attitude with these angles, z-x'-z''; those of the page are finite.
pub fn euler(phi: f64, theta: f64, zeta: f64) -> Attitude {
    let angles = EulerAngles { phi, theta, zeta };
    Attitude::from_euler(angles).unwrap_or(Attitude::IDENTITY)
}

/// The cylinder on its shaft: z along the cylinder, x level, y square to both.
pub struct Shaft {
    /// Moments across the cylinder and along it, kg m^2.
    pub i1: f64,
    pub i3: f64,
    pub tilt: f64,
    pub rate: f64,
}

impl Shaft {
    /// The shaft of these parameters.
    pub fn of(p: &Parameters) -> Result<Self> {
        let tensor = solids::cylinder(p.mass, p.radius, p.height)?.about_centre_of_mass();
        let [[i1, ..], _, [.., i3]] = tensor.matrix();
        Ok(Self { i1, i3, tilt: p.tilt, rate: p.rate })
    }

    // ANCHOR: cylinder
    /// Angular velocity along x, y and z.
    pub fn angular_velocity(&self) -> BodyVector {
        let (s, c) = sincos(self.tilt);
        BodyVector::new(0.0, self.rate * s, self.rate * c)
    }

    /// Each component times its own moment: L along x, y and z.
    pub fn momentum(&self) -> BodyVector {
        let omega = self.angular_velocity();
        BodyVector::new(0.0, self.i1 * omega.y(), self.i3 * omega.z())
    }

    /// What the bearings must exert, Omega x L, along x, y and z.
    pub fn torque(&self) -> BodyVector {
        self.angular_velocity().cross(&self.momentum())
    }
    // ANCHOR_END: cylinder

    /// How the cylinder stands at the time t.
    pub fn attitude(&self, t: f64) -> Attitude {
        euler(self.rate * t, self.tilt, 0.0)
    }

    /// The moment about the shaft.
    pub fn inertia(&self) -> f64 {
        let (s, c) = sincos(self.tilt);
        self.i1 * s * s + self.i3 * c * c
    }

    /// The angle from Omega to L, rad.
    pub fn angle(&self) -> f64 {
        let (omega, momentum) = (self.angular_velocity(), self.momentum());
        atan2(omega.cross(&momentum).norm(), omega.dot(&momentum))
    }

    /// The same body left to the equations of motion, with nothing but that torque: ten turns.
    pub fn driven(&self) -> Result<Problem<((), impl Effect + Clone + use<>)>> {
        let (torque, omega) = (self.torque(), self.angular_velocity());
        let bearings = Torque::on_body("bearings", move |_, _, _| torque).smooth();
        let body = RigidBody::new(PrincipalMoments::symmetric(self.i1, self.i3)?);
        let start = body.state(self.attitude(0.0), omega)?;
        let end = 10.0 * TAU / self.rate.abs();
        let reached = body.state(self.attitude(end), omega)?;
        let scene = Scene::new(body).with(bearings);
        let (tilt, rate) = (self.tilt, self.rate);
        let exact = move |t| euler(rate * t, tilt, 0.0);
        Ok(Problem::new(scene, start, end, reached).in_closed_form(exact))
    }
}

/// The four masses, and a body on its principal axes.
fn bodies(_: &Parameters, report: &mut Report) -> Result<()> {
    let tensor = tensor_of_four(DesignVector::zero())?;
    let [x, y, z] = tensor.angular_momentum(TURNING.into()).to_array();
    let [u, v, w] = tensor.angular_momentum(DesignVector::new(0.0, 0.0, 2.0)).to_array();
    let [sum, about_z] =
        [TURNING, [0.0, 0.0, 2.0]].map(|omega| four(omega, [0.0; 3]).angular_momentum(ORIGIN));
    // With the origin moving: about it, and about a point one metre to the side.
    let (moving, away) = (four(TURNING, MOVING), SpaceVector::new(1.0, 0.0, 0.0));
    let there = moving.angular_momentum(away);
    let shifted = moving.angular_momentum(ORIGIN) - away.cross(&moving.linear_momentum());
    let (momentum, omega) = (SpaceVector::new(0.02, 0.06, 0.12), SpaceVector::new(1.0, 2.0, 3.0));
    let pairs = Swarm::turning(on_axes([0.02, 0.03, 0.04]), omega, ORIGIN);
    claims! { report,
        /// four masses: I Omega, along x
        four_x: x, "kg m^2/s", "sum of r x m v" => sum.x(), within 1e-12;
        /// along y
        four_y: y, "kg m^2/s", "sum of r x m v" => sum.y(), within 1e-12;
        /// along z
        four_z: z, "kg m^2/s", "sum of r x m v" => sum.z(), within 1e-12;
        /// four masses, turning about z at 2 rad/s: L along x
        about_z_x: u, "kg m^2/s", "sum of r x m v" => about_z.x(), within 1e-12, in "Four masses":
            0.0 => "Omega has no such component, L has";
        /// along y
        about_z_y: v, "kg m^2/s", "sum of r x m v" => about_z.y(), within 1e-12;
        /// along z
        about_z_z: w, "kg m^2/s", "sum of r x m v" => about_z.z(), within 1e-12, in "Four masses";
        /// moments 0.02, 0.03, 0.04 kg m^2, Omega (1, 2, 3) rad/s: from L to Omega
        principal_angle: angle(momentum, omega), "rad", "six particles" => angle(pairs.angular_momentum(ORIGIN), omega),
        within 1e-12, in "Four masses";
        /// four masses, their origin moving: L about (1, 0, 0) m, along x
        shifted_x: shifted.x(), "kg m^2/s", "sum about that point" => there.x(), within 1e-12;
        /// along y
        shifted_y: shifted.y(), "kg m^2/s", "sum about that point" => there.y(), within 1e-12;
        /// along z
        shifted_z: shifted.z(), "kg m^2/s", "sum about that point" => there.z(), within 1e-12;
    }
}

/// The cylinder of these parameters with one of them changed: what the page asks for.
fn tries(p: &Parameters, report: &mut Report) -> Result<()> {
    let all = [
        ("none", p.clone()),
        ("--rate 20", p.but(|p| p.rate = 20.0)),
        ("--height 0.02", p.but(|p| p.height = 0.02)),
        ("--height 0.0866", p.but(|p| p.height = 0.0866)),
    ];
    let columns = ["flag", "from Omega to L", "torque along x", "unit"];
    report.add(Table::of("tries", columns, all, |(flag, changed)| {
        let shaft = Shaft::of(&changed)?;
        let [angle, torque] = [shaft.angle(), shaft.torque().x()].map(|x| short(x, 4));
        Ok([flag.into(), format!("{angle} rad"), torque, "N m".into()])
    })?)
}

/// A cylinder with these proportions at this tilt, of mass and angular velocity 1.
fn shape(height_over_radius: f64, tilt: f64) -> Shaft {
    let i1 = 0.25 + height_over_radius * height_over_radius / 12.0;
    Shaft { i1, i3: 0.5, tilt, rate: 1.0 }
}

/// Where the answer is known without the tensor.
fn limits(p: &Parameters, report: &mut Report) -> Result<()> {
    let disc = shape(0.0, 0.25 * PI).momentum();
    let small = p.but(|p| {
        (p.runner_mass, p.runner_radius, p.runner_shaft) = (1.0, 1e-9, 2.0);
        (p.runner_rate, p.gravity) = (3.0, 10.0);
    });
    limits! { report,
        /// along a principal axis L follows Omega
        "cylinder, theta = 0: angle from Omega to L": shape(6.0, 0.0).angle() => 0.0, within 1e-15;
        /// so it does across it
        "cylinder, theta = pi/2: the same": shape(6.0, FRAC_PI_2).angle() => 0.0, within 1e-15;
        /// three equal moments: any direction is a principal axis
        "cylinder, H = sqrt(3) R: the same": shape(3.0_f64.sqrt(), 0.7).angle() => 0.0, within 1e-15;
        /// a needle has no moment about itself: L is square to it
        "cylinder, R to 0: the same + theta": shape(1e6, 0.7).angle() + 0.7 => FRAC_PI_2, within 1e-10;
        /// a disc has twice the moment about its axis
        "cylinder, H = 0, theta = pi/4: L_z/L_y": disc.z() / disc.y() => 2.0, within 1e-15;
        /// a particle on a circle
        "wheel on a shaft, R to 0: L_Z/(M a^2 Omega)": worked::runner_momentum(&small)[1] / 12.0 => 1.0, within 1e-15;
        /// and nothing presses but its weight
        "wheel on a shaft, R to 0: N/(M g)": worked::runner_force(&small) / 10.0 => 1.0, within 1e-8;
    }
}

/// The accuracy strip: ten turns of the cylinder.
fn accuracy(p: &Parameters, report: &mut Report) -> Result<()> {
    report.strip(&Shaft::of(p)?.driven()?, &[p.tolerance, 1e-3, 1e-6, 1e-12])
}

example! {
    ch15_4_angular_momentum: "Angular momentum of a rigid body, and where it points";
    "Angular momentum", "Sums over the particles of a body, its tensor of inertia, and six examples.",
    [bodies, worked::round, worked::earth, worked::edge_runner, worked::askew, left_out::in_air, tries, limits,
     left_out::effects, accuracy];
    figures::figures, figures::trajectory, figures::moving_picture
}
