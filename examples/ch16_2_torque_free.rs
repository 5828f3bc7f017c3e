//! Section 16.2 (2): the free symmetric top by Lagrange's equations, with the vertical along its
//! angular momentum and with the vertical anywhere else.
//!
//! ```text
//! cargo run --example ch16_2_torque_free -- --lean 0.2 --check theta_min=0.15
//! ```

#[path = "ch16_2_torque_free/figures.rs"]
mod figures;

use core::f64::consts::{PI, TAU};
use kit::prelude::*;
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::body::RigidBody;
use rotation_dynamics::effects::GravityGradient;
use rotation_dynamics::exact::free_body::FreeBody;
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::{Dop853, LocatedEvent, Ode, Solution, Work, ode, size_or};
use rotation_dynamics::scene::Scene;

parameters! {
    /// The cylinder of section 15.5; the notes leave all numbers open.
    pub struct Parameters {
        /// mass
        mass: number(1.2, "kg", above(0.0).usually(0.1, 5.0));
        /// radius
        radius: number(0.05, "m", above(0.0).usually(0.01, 0.2));
        /// height along the axis
        height: number(0.15, "m", at_least(0.0).usually(0.0, 0.4)).open("height of the cylinder", "a disc", "a rod");
        /// angular velocity along the axis
        omega_z: number(20.0, "rad/s", any().usually(1.0, 100.0));
        /// angular velocity across the axis, for the small wobble
        omega_y: number(1.0, "rad/s", any().usually(0.1, 10.0));
        /// angle between L and the axis, for the wide wobble
        cone: number(0.35, "rad", from_to(1e-3, 1.57).because("nearer to 0 it hardly wobbles, to pi/2 it hardly spins").usually(0.05, 1.0)).open("angle between L and the axis", "narrow", "wide");
        /// angle between L and Z
        lean: number(0.6, "rad", from_to(1e-3, 3.1).because("nearer to 0 or pi, along L, it hardly nods").usually(0.01, 1.2)).open("angle between L and the vertical", "hardly nods", "nods widely");
        tolerance: step(1e-13, 1e-3);
    }
}

/// A free symmetric top, L leaning from Z away from the axis at the start.
#[derive(Debug, Clone, Copy)]
pub struct Top {
    pub i1: f64,
    pub i3: f64,
    /// Angular velocity along the axis.
    pub along: f64,
    /// Angle between L and the axis.
    pub cone: f64,
    /// Angle between L and Z.
    pub lean: f64,
}

impl Top {
    /// The wide wobble.
    pub fn new(p: &Parameters) -> Self {
        let square = p.radius * p.radius;
        let i1 = p.mass * (3.0 * square + p.height * p.height) / 12.0;
        Self { i1, i3: 0.5 * p.mass * square, along: p.omega_z, cone: p.cone, lean: p.lean }
    }

    /// The small wobble, Z along L.
    pub fn small(p: &Parameters) -> Self {
        let top = Self::new(p);
        let cone = atan2(top.i1 * p.omega_y.abs(), top.i3 * top.along);
        top.but(|top| (top.cone, top.lean) = (cone, 0.0))
    }

    // ANCHOR: momenta
    /// L_z, along the axis.
    pub fn spin_momentum(&self) -> f64 {
        self.i3 * self.along
    }

    /// L; negative where it points away from the axis.
    pub fn momentum(&self) -> f64 {
        self.spin_momentum() / cos(self.cone)
    }

    /// L_Z, along the vertical.
    pub fn vertical_momentum(&self) -> f64 {
        self.momentum() * cos(self.lean)
    }

    /// phi' at a tilt.
    pub fn precession(&self, theta: f64) -> f64 {
        let (s, c) = sincos(theta);
        (self.vertical_momentum() - self.spin_momentum() * c) / (self.i1 * s * s)
    }

    /// The effective potential.
    pub fn potential(&self, theta: f64) -> f64 {
        let turn = self.precession(theta) * sin(theta);
        0.5 * self.i1 * turn * turn
    }
    // ANCHOR_END: momenta

    /// The energy that theta has: all of the kinetic energy but L_z^2/(2 I3).
    pub fn energy(&self) -> f64 {
        let across = self.momentum() * sin(self.cone);
        across * across / (2.0 * self.i1)
    }

    /// The time of a nod: the axis has gone once round L.
    pub fn nod(&self) -> f64 {
        TAU * self.i1 / self.momentum().abs()
    }

    // ANCHOR: triangle
    /// (phi, theta, zeta) at a time, by the spherical triangle of Z, L and the axis.
    pub fn angles(&self, t: f64) -> Result<EulerAngles> {
        let about_l = EulerAngles {
            phi: self.momentum() / self.i1 * t,
            theta: self.cone,
            zeta: (1.0 - self.i3 / self.i1) * self.along * t,
        };
        let x = SpaceVector::new(1.0, 0.0, 0.0);
        let leaning = Attitude::from_euler(about_l)?.turned_in_space(x * self.lean)?;
        Ok(leaning.euler_angles())
    }
    // ANCHOR_END: triangle

    // ANCHOR: lagrange
    /// Lagrange's equations: `[theta, phi, zeta, theta', phi', zeta']`.
    pub fn equations(&self) -> impl Ode<6> {
        let Self { i1, i3, .. } = *self;
        ode(move |_, &[theta, _, _, nod, turn, spin]: &[f64; 6]| {
            let ((s, c), along) = (sincos(theta), i3 * (spin + turn * cos(theta)));
            let theta2 = (turn * s * c) * turn - along * turn * s / i1;
            let phi2 = nod * (along / (i1 * s) - 2.0 * turn * c / s);
            // I3 (zeta' + phi' cos theta) has no derivative.
            let zeta2 = turn * nod * s - phi2 * c;
            [nod, turn, spin, theta2, phi2, zeta2]
        })
        .scaled(size_or([1.0; 6]))
    }
    // ANCHOR_END: lagrange

    /// At the greatest tilt.
    pub fn start(&self) -> [f64; 6] {
        let theta = self.lean + self.cone;
        let turn = self.momentum() * sin(self.cone) / (self.i1 * sin(theta));
        [theta, 0.0, 0.0, 0.0, turn, self.along - turn * cos(theta)]
    }

    /// The motion from there, stepped.
    pub fn stepped(&self, end: f64, step: f64) -> Result<Solution<6>> {
        Ok(Dop853::new(step)?.solve(&self.equations(), 0.0, &self.start(), end, &[])?)
    }

    /// Turning point number `n` of theta.
    fn turning(&self, n: u32, step: f64) -> Result<(LocatedEvent<6>, Work)> {
        let until = 10.0 * self.nod();
        Ok(Dop853::new(step)?.zero(&self.equations(), self.start(), n, until, |y| y[3])?)
    }

    /// The same motion by the library, which knows no Euler angles.
    pub fn free_body(&self) -> Result<FreeBody> {
        let [theta, ..] = self.start();
        let attitude = Attitude::from_euler(EulerAngles { phi: 0.0, theta, zeta: 0.0 })?;
        let across = self.momentum() * sin(self.cone) / self.i1;
        let omega = BodyVector::new(0.0, across, self.along);
        Ok(FreeBody::new(PrincipalMoments::symmetric(self.i1, self.i3)?, attitude, omega)?)
    }
}

/// The wide wobble, if its axis keeps clear of Z.
pub fn wide(p: &Parameters) -> Result<Top> {
    let (top, small) = (Top::new(p), Top::small(p));
    allowed! {
        "|lean - cone|": (p.lean - p.cone).abs(), from_to(5e-3, PI), "at 0 the axis meets Z, and Euler angles fail";
        "pi - lean - cone": PI - p.lean - p.cone, from_to(5e-3, PI), "at 0 the axis meets Z, and Euler angles fail";
        "angle of the small wobble from the axis": sin(small.cone), from_to(1e-6, PI),
            "at 0 it does not wobble, and without spin it only tumbles";
        "its cosine": cos(small.cone).abs(), from_to(1e-6, PI), "at 0 it does not wobble, and without spin it only tumbles";
        "I3/I1": top.i3 / top.i1, from_to(1e-6, 2.0), "a thinner needle has no spin, and 2 is a disc";
    }?;
    Ok(top)
}

fn claims(p: &Parameters, report: &mut Report) -> Result<()> {
    let (small, top) = (Top::small(p), wide(p)?);
    let (bound, nod, l) = (1e3 * p.tolerance, top.nod(), top.momentum());
    let second = small.nod();
    let steady = small.stepped(second, p.tolerance)?;
    let ([least, turn, ..], free) = (*steady.end_state(), top.free_body()?);
    let rate = small.spin_momentum() / (small.i1 * cos(small.cone));
    let far = top.turning(1, p.tolerance)?.0.state;
    let back = top.turning(2, p.tolerance)?.0;
    let after = free.state(0.4 * nod);
    let omega = free.angular_velocity(0.4 * nod);
    let (max, min) = (top.lean + top.cone, (top.lean - top.cone).abs());
    let outside = top.lean > top.cone;
    let spin = (1.0 - top.i3 / top.i1) * top.along * nod;
    let around = TAU * top.along.signum();
    let fastest = top.precession(min).abs().max(1.0 / nod);
    claims! { report,
        /// small wobble, Z along L: tilt
        theta: small.cone, "rad", "a turn, stepped" => least, within bound, in "Z along L":
            atan2(p.omega_y, p.omega_z) => "that is the angle of the angular velocity";
        /// the same: rate of precession
        phi_rate: rate, "rad/s", "a turn, stepped" => turn / second, within bound * rate, in "Z along L":
            p.omega_z => "compare the moments",
            small.spin_momentum() * cos(small.cone) / small.i1 => "divide by the cosine";
        /// the same: rate of spin
        zeta_rate: p.omega_z - rate * cos(small.cone), "rad/s", "a turn, stepped" => steady.end_state()[2] / second, within bound * (rate + p.omega_z.abs()),
        in "Z along L":
            p.omega_z => "a part of that is the precession, seen along the axis";
        /// wide wobble: angular momentum along the axis
        spin_momentum: top.spin_momentum(), "kg m^2/s", "library, 0.4 nods later" => top.i3 * omega.z(), within 1e-13 * l;
        /// the same: along the vertical
        vertical_momentum: top.vertical_momentum(), "kg m^2/s", "library, 0.4 nods later" => after.angular_momentum.z(), within 1e-13 * l;
        /// the same: greatest tilt from Z
        theta_max: max, "rad", "located event" => back.state[0], within bound, in "Z elsewhere":
            top.cone => "that is the angle from L";
        /// least tilt from Z
        theta_min: min, "rad", "located event" => far[0], within bound, in "Z elsewhere":
            top.lean => "that is where L points";
        /// time of a nod
        nod: nod, "s", "located event" => back.t, within bound * nod, in "Z elsewhere":
            TAU / top.along => "the axis circles L at L/I1";
        /// rate of precession at the greatest tilt
        phi_rate_max: top.precession(max), "rad/s", "located event" => back.state[4], within bound * fastest;
        /// the same at the least tilt
        phi_rate_min: top.precession(min), "rad/s", "located event" => far[4], within 10.0 * bound * fastest / min;
        /// advance of phi in a nod
        phi_advance: if outside { 0.0 } else { around }, "rad", "located event" => back.state[1], within bound / min, in "Z elsewhere":
            if outside { around } else { 0.0 } => "is Z inside the cone of the axis?";
        /// advance of zeta in a nod
        zeta_advance: if outside { spin + around } else { spin }, "rad", "located event" => back.state[2], within bound * (1.0 + spin.abs()) / min;
        /// energy of the nodding
        energy: top.energy(), "J", "potential at the least tilt" => top.potential(min), within 1e-10 * top.energy() / min;
    }
}

/// Z all but along L, all but on the cone, and at right angles; a sphere and a disc.
fn limits(p: &Parameters, report: &mut Report) -> Result<()> {
    let (top, small) = (wide(p)?, Top::small(p));
    let at = |lean, cone| Top { lean, cone, ..top };
    let around = TAU * top.along.signum();
    let turned = |top: Top| Ok::<_, kit::Error>(top.turning(2, 1e-14)?.0);
    let [_, steady, ..] = *small.stepped(1.0, 1e-14)?.end_state();
    limits! { report,
        /// Chapter 15: L/I1, all of it about L
        "Z along L: phi'/(L/I1)": steady / (small.momentum() / small.i1) => 1.0, within 1e-11;
        /// it nods by what Z leans
        "lean = 1e-3: half the range of theta over lean":
            (at(1e-3, 0.4).start()[0] - at(1e-3, 0.4).turning(1, 1e-14)?.0.state[0]) / 2e-3 => 1.0, within 1e-8;
        /// just inside the cone the line of nodes goes round
        "lean = cone - 0.02: advance of phi over 2 pi": turned(at(0.38, 0.4))?.state[1] / around => 1.0, within 1e-9;
        /// just outside it does not
        "lean = cone + 0.02: advance of phi over 2 pi": turned(at(0.42, 0.4))?.state[1] / around => 0.0, within 1e-9;
        /// I1 = I3: there is no spin; Z lies within the cone
        "sphere, lean 0.2: advance of zeta": turned(Top { i1: top.i3, ..at(0.2, 0.4) })?.state[2] => 0.0, within 1e-9;
        /// I3 = 2 I1, a narrow cone: two nods in a turn about the axis
        "disc, cone 1e-3: Omega_z times a nod over 2 pi":
            turned(Top { i1: 0.5 * top.i3, ..at(0.6, 1e-3) })?.t * top.along.abs() / TAU => 0.5, within 1e-6;
    }
}

/// What the angle between L and the axis varies by, over its least value, if I2 = I1 (1 + d): to
/// first order, as the energy stays.
pub fn unequal(top: &Top, d: f64) -> f64 {
    0.5 * d * (top.i3 / (top.i1 - top.i3)).abs() * tan(top.cone) / top.cone
}

/// The same in closed form, as the library has it for three different moments; nothing for
/// moments that no body has.
pub fn squeezed(top: &Top, d: f64) -> Result<Option<f64>> {
    let Ok(moments) = PrincipalMoments::new(top.i1, top.i1 * (1.0 + d), top.i3) else {
        return Ok(None);
    };
    let start = top.free_body()?;
    let free = FreeBody::new(moments, start.attitude(0.0), start.angular_velocity(0.0))?;
    let l = free.angular_momentum();
    let cone = |t: f64| {
        let axis = free.attitude(t).axis();
        atan2(axis.cross(&l).norm(), axis.dot(&l).abs())
    };
    let cones = times(0.0, free.rate_period(), 400).map(cone);
    let (least, most) = cones.fold((PI, 0.0_f64), |(a, b), x| (a.min(x), b.max(x)));
    Ok(Some(most / least - 1.0))
}

fn effects(p: &Parameters, report: &mut Report) -> Result<()> {
    let (top, earth) = (wide(p)?, 7.292115e-5);
    let (free, round, predicted) = (top.free_body()?, top.nod(), unequal(&top, 0.01));
    // Else it need not even go round the same axis.
    let seen = when(predicted < 0.1, || squeezed(&top, 0.01))?.flatten();
    // Seen from a Z that has turned towards the axis, after a nod.
    let (s, c) = sincos(earth * round);
    let (axis, turned) = (free.attitude(round).axis(), SpaceVector::new(0.0, -s, c));
    let leans = top.lean + top.cone - atan2(axis.cross(&turned).norm(), axis.dot(&turned));
    effect_card! { report,
        "Z fixed to the turning Earth": "Omega_E T" = earth * round, costs earth * round, "rad of theta, a nod",
            measured leans, within 1e-12;
        "I1 and I2 differ by 1 %": "(I2 - I1)/I1" = 0.01, costs predicted.min(1.0), "of the cone, to first order",
            measured seen, within 1e-9;
    }?;
    // What pulls at the lower end more than at the upper one: 3 g/R_E.
    let weaker = 9.80665_f64 / 6.371e6;
    let pull = GravityGradient::fixed(weaker.sqrt(), SpaceVector::new(0.0, 0.0, -1.0))?;
    let number = 1.5 * 9.80665 / 6.371e6 * (top.i1 - top.i3).abs() / top.momentum().abs() * round;
    let scene = Scene::new(RigidBody::new(PrincipalMoments::symmetric(top.i1, top.i3)?));
    let (name, start) = ("gravity of the Earth weaker at the upper end", free.state(0.0));
    let candidates = scene.neglected_effects(&start, round, 1e-3)?.of_axis();
    report.add(candidates.line(
        name,
        "3 g (I1 - I3) T/(2 R_E L)",
        number,
        &pull,
        "rad of the axis, a nod",
    )?)
}

/// The accuracy strip: a nod by Lagrange's equations.
fn accuracy(p: &Parameters, report: &mut Report) -> Result<()> {
    let top = wide(p)?;
    let asked = [p.tolerance, 1e-3, 1e-5, 1e-7, 1e-9, 1e-11, 1e-15];
    report.in_closed_form(move |part| top.angles(part * top.nod()));
    report.dial_of_return(asked, move |step| top.turning(2, step), top.nod(), top.lean + top.cone)
}

example! {
    ch16_2_torque_free: "Section 16.2 (2): torque-free motion by Lagrange's equations";
    "Torque-free motion by Lagrange", "A free cylinder in Euler angles, counted from its L and from another axis.",
    [claims, limits, effects, accuracy];
    figures::figures, figures::trajectory, figures::moving_picture
}
