//! Torque-free motion of a symmetric top: equations (1) to (17) of the notes, Chapter 15,
//! Section 5. The default is the notes' cylinder, with a disc beside it.

#[path = "ch15_5_torque_free/cones.rs"]
mod cones;
#[path = "ch15_5_torque_free/figures.rs"]
mod figures;
#[path = "ch15_5_torque_free/left_out.rs"]
mod left_out;
pub use left_out::gradient_rate;

use core::f64::consts::{PI, TAU};
use kit::prelude::*;
use kit::supported_digits;
use rotation_dynamics::accuracy::Problem;
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::exact::free_body::FreeBody;
use rotation_dynamics::frame::DesignVector;
use rotation_dynamics::inertia::{PrincipalMoments, solids};
use rotation_dynamics::integrators::{Dop853, Integrator, Ode, Solution, ode, size_or};
use rotation_dynamics::scene::Scene;

parameters! {
    /// A solid cylinder that moves freely; the notes' instance.
    pub struct Parameters {
        /// mass
        mass: number(1.2, "kg", from_to(1e-9, 1e9).usually(0.1, 5.0));
        /// radius
        radius: number(0.05, "m", from_to(1e-6, 1e6).usually(0.01, 0.2));
        /// height along the axis; 0 is a thin disc
        height: number(0.15, "m", from_to(0.0, 1e6).usually(0.0, 0.4)).open("height of the can", "flat: cone in cone", "tall: cone on cone");
        /// angular velocity along the axis
        omega_z: number(20.0, "rad/s", from_to(1e-9, 1e9).because("the axis is counted to the side to which the body spins").usually(1.0, 100.0));
        /// angular velocity across the axis
        omega_y: number(1.0, "rad/s", from_to(1e-9, 1e9).because("y is counted to the side of L; without this part nothing wobbles").usually(0.1, 40.0));
        /// tilt of the axis in the drawings of the cones
        drawn_tilt: number(0.5, "rad", between(0.05, 1.5).because("wider or narrower cones cannot be told apart in the drawing").usually(0.1, 0.65)).open("tilt of the axis", "narrow cones", "wide cones");
        /// error asked of the attitude at the end: above 0, at most pi
        tolerance: number(1e-9, "rad", above_to(0.0, PI));
    }
}

// ANCHOR: top
/// A symmetric top on which nothing acts, at a moment when its angular velocity is
/// omega_y along y and omega_z along z: z is its axis, y across it, in the plane of L.
#[derive(Debug, Clone, Copy)]
pub struct Top {
    pub i1: f64,
    pub i3: f64,
    pub omega_y: f64,
    pub omega_z: f64,
}

impl Top {
    /// L, by (5) and (6).
    pub fn momentum(&self) -> f64 {
        hypot(self.i1 * self.omega_y, self.i3 * self.omega_z)
    }
    /// theta, the angle between L and the axis.
    pub fn tilt(&self) -> f64 {
        atan2(self.i1 * self.omega_y, self.i3 * self.omega_z)
    }
    /// alpha, the angle between the angular velocity and the axis, by (13).
    pub fn lean(&self) -> f64 {
        atan2(self.omega_y, self.omega_z)
    }
    /// Omega_P, the rate at which the axis goes round L, by (9).
    pub fn precession(&self) -> f64 {
        self.momentum() / self.i1
    }
    /// Omega_S, the rate at which the body turns about its axis besides, by (10).
    pub fn spin(&self) -> f64 {
        self.omega_z * ((self.i1 - self.i3) / self.i1)
    }
    /// Where the body is at the time t: precession, tilt, spin.
    pub fn attitude(&self, t: f64) -> rotation_dynamics::Result<Attitude> {
        Attitude::from_euler(EulerAngles {
            phi: self.precession() * t,
            theta: self.tilt(),
            zeta: self.spin() * t,
        })
    }
}
// ANCHOR_END: top

impl Top {
    /// A solid cylinder, or a thin disc.
    pub fn cylinder(p: &Parameters) -> Self {
        let (r, h) = (p.radius, p.height);
        Self {
            i1: p.mass * (3.0 * r * r + h * h) / 12.0,
            i3: 0.5 * p.mass * r * r,
            omega_y: p.omega_y,
            omega_z: p.omega_z,
        }
    }
    /// The same body and the same rate along the axis, with another tilt.
    pub fn tilted(self, theta: f64) -> Self {
        let omega_y = self.i3 * self.omega_z * (sin(theta) / cos(theta)) / self.i1;
        Self { omega_y, ..self }
    }
    /// Turns of a line OP across the axis in one turn of the axis about L.
    pub fn line_turns(&self) -> f64 {
        1.0 + self.spin() / self.precession()
    }
    /// Time of one turn of the axis about L.
    pub fn round(&self) -> f64 {
        TAU / self.precession()
    }
    /// The direction of the angular velocity at the time t: that of L for alpha = theta.
    pub fn pole(&self, t: f64) -> SpaceVector {
        let between = self.tilt() - self.lean();
        let (s, c) = (sin(between), cos(between));
        let phi = self.precession() * t;
        SpaceVector::new(s * sin(phi), -s * cos(phi), c)
    }
    /// The length of the angular velocity.
    fn rate(&self) -> f64 {
        hypot(self.omega_y, self.omega_z)
    }
    fn rates(&self) -> BodyVector {
        BodyVector::new(0.0, self.omega_y, self.omega_z)
    }
    pub fn body(&self) -> rotation_dynamics::Result<RigidBody> {
        Ok(RigidBody::new(PrincipalMoments::symmetric(self.i1, self.i3)?))
    }
    pub fn state(&self) -> rotation_dynamics::Result<State> {
        self.body()?.state(self.attitude(0.0)?, self.rates())
    }
    /// The library's closed form, in which nothing of this page occurs.
    pub fn free_body(&self) -> rotation_dynamics::Result<FreeBody> {
        FreeBody::new(self.body()?.moments(), self.attitude(0.0)?, self.rates())
    }
}

/// The notes' cylinder, and their disc: 0.2 kg, radius 0.1 m, thin.
pub fn of_the_notes() -> [Top; 2] {
    let cylinder = Parameters::default();
    let disc = cylinder.but(|p| {
        (p.mass, p.radius, p.height) = (0.2, 0.1, 0.0);
        (p.omega_z, p.omega_y) = (10.0, 0.5);
    });
    [cylinder, disc].map(|p| Top::cylinder(&p))
}

// ANCHOR: euler
/// Newton's law for a body of any shape: Euler's equations for the rates on its own axes,
/// and how these turn the quaternion w, x, y, z of its attitude.
pub fn newton([i1, i2, i3]: [f64; 3]) -> impl Ode<7> {
    ode(move |_, &[p, q, r, w, x, y, z]: &[f64; 7]| {
        [
            (i2 - i3) / i1 * q * r,
            (i3 - i1) / i2 * r * p,
            (i1 - i2) / i3 * p * q,
            0.5 * (-x * p - y * q - z * r),
            0.5 * (w * p + y * r - z * q),
            0.5 * (w * q + z * p - x * r),
            0.5 * (w * r + x * q - y * p),
        ]
    })
    .scaled(size_or([1.0; 7]))
}
// ANCHOR_END: euler

/// A top followed by [`newton`], in steps of its own choice; rates in that of the start.
pub struct Stepped {
    rate: f64,
    run: Solution<7>,
}

impl Stepped {
    /// The motion up to the time `end`.
    pub fn until(top: &Top, end: f64) -> Result<Self> {
        let (rate, start) = (top.rate(), top.start()?);
        let run = Dop853::new(1e-14)?.solve(&top.law(), 0.0, &start, end * rate, &[])?;
        Ok(Self { rate, run })
    }
    /// Attitude and rates at a time of it.
    pub fn at(&self, t: f64) -> Result<(Attitude, BodyVector)> {
        let [p, q, r, quaternion @ ..] = self.run.at(t * self.rate)?;
        Ok((Attitude::from_quaternion(quaternion)?, BodyVector::new(p, q, r) * self.rate))
    }
}

/// What is measured on the stepped motion.
impl Top {
    fn law(&self) -> impl Ode<7> + use<> {
        newton([self.i1, self.i1, self.i3])
    }
    fn start(&self) -> Result<[f64; 7]> {
        let [w, x, y, z] = self.attitude(0.0)?.quaternion();
        Ok([0.0, self.omega_y / self.rate(), self.omega_z / self.rate(), w, x, y, z])
    }
    /// Time of the second zero of `f`, as a rate in turns.
    fn rate_of(&self, f: impl Fn(&[f64; 7]) -> f64) -> Result<f64> {
        let (event, _) = Dop853::new(1e-14)?.zero(&self.law(), self.start()?, 2, 1e9, f)?;
        Ok(TAU * self.rate() / event.t)
    }
    /// Omega_P: the axis comes back to where it was, after two zeros of its X.
    fn precession_stepped(&self) -> Result<f64> {
        self.rate_of(|&[_, _, _, w, x, y, z]| x * z + w * y)
    }
    /// Omega_S: in the body, the angular velocity comes back; its sign is that of the first move.
    fn spin_stepped(&self) -> Result<f64> {
        let sense = self.law().derivative(0.0, &self.start()?)[0];
        Ok(self.rate_of(|y| y[0])?.copysign(sense))
    }
    /// How often the line OP has turned at the end of each of so many pieces.
    fn line_turned(&self, end: f64, pieces: u32) -> Result<Vec<f64>> {
        let stepped = Stepped::until(self, end)?;
        let (mut turned, mut last) = (0.0, 0.0);
        sampled(times(0.0, end, pieces), |t| {
            let angles = stepped.at(t)?.0.euler_angles();
            let now = angles.phi + angles.zeta;
            // A piece is far less than half a turn.
            turned += atan2(sin(now - last), cos(now - last));
            last = now;
            Ok(turned / TAU)
        })
    }
    /// The same in one turn of the axis, counted in small pieces.
    pub fn line_turns_stepped(&self) -> Result<f64> {
        let pieces = 60 + (4.0 * self.rate() * self.round()) as u32;
        let turned = self.line_turned(self.round(), pieces)?;
        Ok(turned[turned.len() - 1])
    }
}

/// What is seen of a stepped motion at the time t: |Omega|, |L|, and the angles between the
/// axis and L, the axis and Omega, L and Omega.
pub fn seen(top: Top, t: f64) -> Result<[f64; 5]> {
    let (attitude, rates) = Stepped::until(&top, t)?.at(t)?;
    let [p, q, r] = rates.to_array();
    let momentum = attitude.to_space(BodyVector::new(top.i1 * p, top.i1 * q, top.i3 * r));
    let (axis, omega) = (attitude.axis(), attitude.to_space(rates));
    let angle = |a: &SpaceVector, b: &SpaceVector| atan2(a.cross(b).norm(), a.dot(b));
    let angles = [angle(&axis, &momentum), angle(&axis, &omega), angle(&momentum, &omega)];
    Ok([omega.norm(), momentum.norm(), angles[0], angles[1], angles[2]])
}

/// The height at which a cylinder of this radius is neither thin nor flat, by bisection on
/// the library's moments.
fn round_height(mass: f64, radius: f64) -> Result<f64> {
    let flat =
        |height| library_moments(mass, radius, height).map(|[across, along]| across <= along);
    let [low, high] = try_bisect([0.5 * radius, 4.0 * radius], 0.0, flat)?;
    Ok(0.5 * (low + high))
}

/// The library's moments of a cylinder, across the axis and along it.
fn library_moments(mass: f64, radius: f64, height: f64) -> Result<[f64; 2]> {
    let solid = match height > 0.0 {
        true => solids::cylinder(mass, radius, height)?,
        false => solids::disc(mass, radius)?,
    };
    let about = |axis| solid.about_centre_of_mass().moment_about(DesignVector::from_array(axis));
    Ok([about([1.0, 0.0, 0.0])?, about([0.0, 0.0, 1.0])?])
}

fn top(p: &Parameters) -> Result<Top> {
    let top = Top::cylinder(p);
    // 2 is that of a disc without thickness, and rounding may add a digit.
    allowed! {
        "I3/I1": top.i3 / top.i1, from_to(1e-6, 2.0 + 1e-15), "from a needle to a disc";
        "omega_y/omega_z": top.omega_y / top.omega_z, from_to(1e-6, 1e6), "one part is lost beside the other";
    }?;
    let part = top.spin() / top.rate();
    let words = "at least 0.001 in size: three equal moments do not wobble, and what tumbles end over \
                 end does not spin";
    require(top.spin().abs() >= 1e-3 * top.rate(), "Omega_S/Omega", part, words)?;
    Ok(top)
}

fn claims(p: &Parameters, report: &mut Report) -> Result<()> {
    let top = top(p)?;
    let rate = top.rate();
    let [omega, momentum, tilt, lean, between] = seen(top, 0.4 * top.round())?;
    let [across, along] = library_moments(p.mass, p.radius, p.height)?;
    let (spin, precession) = (top.spin(), top.precession());
    let flat = 3.0_f64.sqrt() * p.radius;
    // What a period that ends at a shallow zero allows.
    let slow = 1e-10 * rate * (rate / spin.abs());
    claims! { report,
        /// moment of inertia across the axis
        i1: top.i1, "kg m^2", "library's cylinder" => across, within 1e-14 * top.i1, in "The body":
            p.mass * (3.0 * p.radius * p.radius + 4.0 * p.height * p.height) / 12.0
                => "that is about an axis through the end face",
            0.25 * p.mass * p.radius * p.radius => "the height counts too";
        /// moment of inertia about the axis
        i3: top.i3, "kg m^2", "library's cylinder" => along, within 1e-14 * top.i3, in "The body":
            2.0 * top.i3 => "that is a hoop";
        /// height above which this radius makes a thin top
        thin_above: flat, "m", "bisection" => round_height(p.mass, p.radius)?, within 1e-13 * flat, in "The body":
            2.0 * p.radius => "as high as wide is still thin: compare the moments";
        /// length of the angular velocity
        omega: rate, "rad/s", "0.4 turns later, stepped" => omega, within 1e-11 * rate, in "The motion":
            top.omega_y + top.omega_z => "the two are at right angles";
        /// angular momentum
        momentum: top.momentum(), "kg m^2/s", "0.4 turns later, stepped" => momentum,
            within 1e-11 * top.momentum(), in "The motion":
            top.i3 * rate => "the moment differs along and across",
            top.i1 * top.omega_y + top.i3 * top.omega_z => "the two parts are at right angles";
        /// angle between L and the axis
        theta: top.tilt(), "rad", "0.4 turns later, stepped" => tilt, within 1e-11, in "The motion":
            top.lean() => "that is the angle of the angular velocity";
        /// angle between the angular velocity and the axis
        alpha: top.lean(), "rad", "0.4 turns later, stepped" => lean, within 1e-11, in "The motion":
            top.tilt() => "that is the angle of L";
        /// rate at which the axis goes round L
        omega_p: precession, "rad/s", "return of the axis, stepped" => top.precession_stepped()?,
            within 1e-10 * rate * (rate / precession), in "The motion":
            spin => "that is the rate about the axis", top.momentum() / top.i3 => "look at the moment";
        /// rate about the axis besides
        omega_s: spin, "rad/s", "return of the rates in the body" => top.spin_stepped()?, within slow, in "The motion":
            top.omega_z => "a part of that is the precession, seen along the axis",
            top.omega_z - precession => "the precession is not along the axis";
        /// turns of the line OP in one turn of the axis
        op_turns: top.line_turns(), "-", "counted, stepped" => top.line_turns_stepped()?, within 1e-10, in "The line OP":
            spin / precession => "that is counted from the line of nodes";
        /// half-angle of the cone that the angular velocity draws about L
        space_cone: (top.tilt() - top.lean()).abs(), "rad", "0.4 turns later, stepped" => between, within 1e-11;
    }
}

fn disc(_: &Parameters, report: &mut Report) -> Result<()> {
    let [_, disc] = of_the_notes();
    let [_, _, tilt, lean, _] = seen(disc, 0.4 * disc.round())?;
    let (spin, precession) = (disc.spin(), disc.precession());
    let counted = disc.line_turns_stepped()?;
    claims! { report,
        /// the disc: rate at which its axis goes round L
        disc_omega_p: precession, "rad/s", "return of the axis, stepped" => disc.precession_stepped()?,
            within 1e-10, in "The disc":
            0.5 * disc.omega_z => "the wobble is faster than the rotation, not slower",
            disc.omega_z => "look at the ratio of the moments";
        /// the disc: rate about the axis besides
        disc_omega_s: spin, "rad/s", "return of the rates in the body" => disc.spin_stepped()?, within 1e-9, in "The disc":
            -spin => "look at the sign";
        /// the disc: turns of OP in one turn of the axis
        disc_op_turns: disc.line_turns(), "-", "counted, stepped" => counted, within 1e-10, in "The disc":
            1.0 / disc.line_turns() => "that is the wobbles in one turn";
        /// the disc: wobbles in one turn of OP
        disc_wobbles: 1.0 / disc.line_turns(), "-", "counted, stepped" => 1.0 / counted, within 1e-9;
        /// the disc: angle between L and the axis
        disc_theta: disc.tilt(), "rad", "0.4 turns later, stepped" => tilt, within 1e-11;
        /// the disc: angle between the angular velocity and the axis
        disc_alpha: disc.lean(), "rad", "0.4 turns later, stepped" => lean, within 1e-11;
    }
}

/// Small and large tilts, needles and round bodies; the cones and the stepped motion.
fn limits(_: &Parameters, report: &mut Report) -> Result<()> {
    let cylinder = Top { i1: 2.0, i3: 1.0, omega_y: 1.0, omega_z: 20.0 };
    let shaped = |ratio: f64| Top { i3: 2.0 * ratio, ..cylinder };
    let (disc, needle, round) = (shaped(2.0), shaped(1e-6), shaped(1.0 - 1e-6));
    let level = |top: Top| top.tilted(0.5 * PI - 1e-6);
    limits! { report,
        /// nearly along one line, rates add as numbers: (1 + cos(theta))
        "I1 = 2 I3, theta = 0.001: turns of OP": cylinder.tilted(1e-3).line_turns() => 2.0, within 1e-6;
        /// the same with -1/2 cos(theta) for the disc
        "I3 = 2 I1, theta = 0.001: turns of OP": disc.tilted(1e-3).line_turns() => 0.5, within 1e-6;
        /// L is across the axis, and what spins has no part in it
        "I3 = I1/10^6: Omega_P/Omega_y": needle.precession() / needle.omega_y => 1.0, within 1e-9;
        /// three equal moments: L and Omega are parallel
        "I3 = I1: alpha/theta": round.lean() / round.tilt() => 1.0, within 2e-6;
        /// and nothing turns in the body
        "I3 = I1: Omega_S/Omega_z": round.spin() / round.omega_z => 0.0, within 2e-6;
        /// end over end: OP is carried round as the axis is
        "theta = pi/2: turns of OP": level(cylinder).line_turns() => 1.0, within 1e-5;
    }
}

/// The runs that the page asks the reader to predict.
fn tries(_: &Parameters, report: &mut Report) -> Result<()> {
    let columns = ["run", "theta", "alpha", "Omega_P", "Omega_S", "turns of OP"];
    let ours = Parameters::default();
    let runs = [
        ("as it is", ours.clone()),
        ("shorter", ours.but(|p| p.height = 0.08)),
        ("tumbling", ours.but(|p| p.omega_y = 40.0)),
        ("faster along", ours.but(|p| p.omega_z = 40.0)),
    ];
    report.add(Table::of("tries", columns, runs, |(name, run)| {
        let top = top(&run)?;
        let turns = top.line_turns();
        // The bound under the printed digits: the count of the stepped motion.
        let within = 1e-10_f64.max((top.line_turns_stepped()? - turns).abs());
        let numbers = [top.tilt(), top.lean(), top.precession(), top.spin(), turns];
        let cells = numbers.map(|x| supported_digits(x, within.max(1e-5)));
        Ok([[name.to_string()].as_slice(), &cells].concat())
    })?)
}

fn accuracy(p: &Parameters, report: &mut Report) -> Result<()> {
    let top = top(p)?;
    // Ten turns of the axis and a third: not a whole number, where errors might cancel.
    let end = 31.0 / 3.0 * top.round();
    let (motion, start) = (top.free_body()?, top.state()?);
    let exact = State::new(top.attitude(end)?, start.angular_momentum)?;
    let problem = Problem::new(Scene::new(top.body()?), start, end, exact);
    let problem = problem.in_closed_form(move |t| motion.attitude(t));
    report.strip(&problem, &[p.tolerance, 1e-3, 1e-6, 1e-12])
}

fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let (top, columns) = (top(p)?, "t [s],z_X [-],z_Y [-],z_Z [-],OP_X [-],OP_Y [-],OP_Z [-]");
    Trajectory::sampled(columns.split(','), times(0.0, 2.0 * top.round(), 400), |t| {
        let attitude = top.attitude(t)?;
        let (axis, line) = (attitude.axis().to_array(), attitude.to_space(LINE).to_array());
        Ok([[t].as_slice(), &axis, &line].concat())
    })
}

/// The direction of the line OP, in the body.
pub const LINE: BodyVector = BodyVector::new(1.0, 0.0, 0.0);

example! {
    ch15_5_torque_free: "Torque-free motion of a symmetric top: precession, spin, and the two cones";
    "Torque-free motion of a symmetric top", "A solid cylinder that spins and wobbles freely, and a thin disc that does.",
    [claims, disc, limits, left_out::effects, tries, accuracy];
    figures::figures, trajectory, cones::moving_picture
}
