//! Three different moments: polhode and herpolhode, the middle axis, and a thrown book that
//! flips. The step beyond the notes' Chapter 15, Section 5.

#[path = "ch15_5_asymmetric/figures.rs"]
mod figures;
#[path = "ch15_5_asymmetric/left_out.rs"]
mod left_out;
#[path = "ch15_5_asymmetric/naive.rs"]
mod naive;
#[path = "ch15_5_asymmetric/tumbling.rs"]
mod tumbling;

pub use naive::NAIVE_TILT;

use core::f64::consts::{FRAC_PI_2, LN_10, PI, TAU};
use kit::prelude::*;
use kit::{short, supported_digits};
use rotation_dynamics::accuracy::Problem;
use rotation_dynamics::attitude::{Attitude, EulerAngles, unwrapped};
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::exact::Modulus;
use rotation_dynamics::exact::free_body::FreeBody;
use rotation_dynamics::exact::jacobi::Jacobi;
use rotation_dynamics::frame::DesignVector;
use rotation_dynamics::inertia::{PrincipalMoments, solids};
use rotation_dynamics::integrators::{
    Dop853, Integrator, LocatedEvent, Ode, Work, after, ode, small_frequency,
};
use rotation_dynamics::scene::Scene;

parameters! {
    /// A book, thrown with a turn about its middle axis; or a telephone, or a racket.
    pub struct Parameters {
        /// mass
        mass: number(0.5, "kg", above(0.0).usually(0.1, 2.0));
        /// longest edge
        length: number(0.21, "m", above(0.0).usually(0.1, 0.4));
        /// edge of middle length
        width: number(0.14, "m", above(0.0).usually(0.05, 0.3));
        /// shortest edge
        thickness: number(0.025, "m", at_least(0.0).usually(0.0, 0.1));
        /// angular momentum over the middle moment
        rate: number(12.0, "rad/s", above(0.0).because("the axis is counted to the side to which the body turns").usually(2.0, 30.0));
        /// angle between angular momentum and middle axis at the start
        aside: number(0.1, "rad", between(1e-6, 1.55).because("on an axis nothing tumbles; beyond, it is nearer to another one").usually(0.001, 1.5)).open("angle off the middle axis", "on it", "near another axis");
        /// to which axis it is off
        toward: choice("least", "largest").open("off towards the axis of the moment that is");
        /// air of a room, for the table of the flips in it: drag coefficient of the cover
        air: effect(1.2, "-", above_to(0.0, 10.0).because("no body has a larger drag coefficient"));
        /// error asked of the attitude at the end: above 0, at most pi
        tolerance: number(1e-9, "rad", above_to(0.0, PI));
    }
}

// ANCHOR: tumble
/// A body with the moments I1 < I2 < I3. At the start its angular momentum lies in the plane
/// of its middle axis and another, `about`, round which the polhode goes.
#[derive(Debug, Clone, Copy)]
pub struct Tumble {
    pub moments: [f64; 3],
    /// I_about and the rate about it at the start.
    pub about: usize,
    /// Angular velocity on the body's axes at the start.
    pub start: [f64; 3],
}

impl Tumble {
    /// How fast the elliptic functions run: p of (7), in rad/s.
    pub fn pace(&self) -> f64 {
        let (a, o, [_, middle, _]) = (self.about, 2 - self.about, self.moments);
        let (near, far) = (self.moments[a], self.moments[o]);
        ((near - middle) * self.above(o) / (near * middle * far)).sqrt()
    }
    /// L^2 - 2 E I_o, for the axis about which nothing turns at the start.
    fn above(&self, o: usize) -> f64 {
        let term = |i: usize| {
            let (own, rate) = (self.moments[i], self.start[i]);
            own * (own - self.moments[o]) * rate * rate
        };
        term(self.about) + term(1)
    }
    /// 1 - k^2 of (7), without a difference of large numbers; 0 on the separatrix.
    pub fn complement(&self) -> f64 {
        let (a, o, [_, middle, _]) = (self.about, 2 - self.about, self.moments);
        let (near, far) = (self.moments[a], self.moments[o]);
        let across = middle * (middle - far) * self.start[1] * self.start[1];
        let along = near * (near - far) * self.start[a] * self.start[a];
        1.0 / (1.0 + across / along)
    }
    fn jacobi(&self) -> Result<Jacobi> {
        Ok(Jacobi::new(Modulus::from_m1(self.complement())?))
    }
    /// Time from one flip to the next: half a period of the rates.
    pub fn between_flips(&self) -> Result<f64> {
        Ok(2.0 * self.jacobi()?.quarter_period() / self.pace())
    }
    /// The angular velocity on the body's axes at the time t, by (6).
    pub fn rates(&self, t: f64) -> Result<[f64; 3]> {
        let (a, o, pace) = (self.about, 2 - self.about, self.pace());
        let (sn, cn, dn) = self.jacobi()?.sn_cn_dn(pace * t)?;
        let first = euler(self.moments).derivative(0.0, &self.start)[o];
        let mut rates = [0.0; 3];
        rates[a] = self.start[a] / dn;
        rates[1] = self.start[1] * cn / dn;
        rates[o] = first / pace * sn / dn;
        Ok(rates)
    }
}
// ANCHOR_END: tumble

// ANCHOR: euler
/// Euler's equations of a free body.
pub fn euler([i1, i2, i3]: [f64; 3]) -> impl Ode<3> {
    ode(move |_, &[p, q, r]: &[f64; 3]| {
        [(i2 - i3) / i1 * q * r, (i3 - i1) / i2 * r * p, (i1 - i2) / i3 * p * q]
    })
    .scaled(|rates| [length(*rates).max(f64::MIN_POSITIVE); 3])
}
// ANCHOR_END: euler

// ANCHOR: naive
/// Euler's explicit method: rate plus slope times step.
pub struct Naive {
    pub moments: [f64; 3],
    pub rates: [f64; 3],
    pub step: f64,
}

impl Iterator for Naive {
    type Item = [f64; 3];
    fn next(&mut self) -> Option<[f64; 3]> {
        let slope = euler(self.moments).derivative(0.0, &self.rates);
        self.rates = [0, 1, 2].map(|i| self.rates[i] + self.step * slope[i]);
        Some(self.rates)
    }
}
// ANCHOR_END: naive

fn length([x, y, z]: [f64; 3]) -> f64 {
    hypot(hypot(x, y), z)
}

/// A box's moments about its longest, middle and shortest edge: the least, the middle and
/// the largest.
pub fn box_moments(mass: f64, [a, b, c]: [f64; 3]) -> [f64; 3] {
    [b * b + c * c, a * a + c * c, a * a + b * b].map(|sum| mass * sum / 12.0)
}

impl Tumble {
    /// With the angular momentum I2 `rate`, `aside` from the middle axis.
    pub fn new(moments: [f64; 3], rate: f64, aside: f64, about: usize) -> Self {
        let mut start = [0.0, rate * cos(aside), 0.0];
        start[about] = moments[1] * rate * sin(aside) / moments[about];
        Self { moments, about, start }
    }
    /// L on the body's axes for these rates.
    pub fn carried(&self, rates: [f64; 3]) -> [f64; 3] {
        [0, 1, 2].map(|i| self.moments[i] * rates[i])
    }
    /// The length of L.
    pub fn momentum(&self) -> f64 {
        length(self.carried(self.start))
    }
    /// Twice the energy over L: the part of the angular velocity along L.
    pub fn height(&self) -> f64 {
        let carried = self.carried(self.start);
        let twice: f64 = (0..3).map(|i| carried[i] * self.start[i]).sum();
        twice / self.momentum()
    }
    /// The part of the angular velocity across L for these rates.
    pub fn across(&self, rates: [f64; 3]) -> f64 {
        let [of_l, rates] = [self.carried(rates), rates].map(BodyVector::from_array);
        length(rates.cross(&of_l).to_array()) / self.momentum()
    }
    /// The attitude at the start: L is vertical.
    pub fn upright(&self) -> rotation_dynamics::Result<Attitude> {
        let [sideways, along, up] = self.carried(self.start);
        let (lying, zeta) = (atan2(hypot(sideways, along), up), atan2(sideways, along));
        // The cover towards the reader.
        Attitude::from_euler(EulerAngles { phi: 2.5, theta: lying, zeta })
    }
    fn body(&self) -> rotation_dynamics::Result<RigidBody> {
        let [i1, i2, i3] = self.moments;
        Ok(RigidBody::new(PrincipalMoments::new(i1, i2, i3)?))
    }
    fn state(&self) -> rotation_dynamics::Result<State> {
        self.body()?.state(self.upright()?, BodyVector::from_array(self.start))
    }
    /// The library's closed form, of rates and attitude.
    pub fn free_body(&self) -> rotation_dynamics::Result<FreeBody> {
        let rates = BodyVector::from_array(self.start);
        FreeBody::new(self.body()?.moments(), self.upright()?, rates)
    }
    /// Flip number `count`, by Euler's equations in steps: the rate about the middle axis is 0.
    fn flip(&self, count: u32) -> Result<(LocatedEvent<3>, Work)> {
        let (law, until) = (euler(self.moments), 1e4 / self.pace());
        Ok(Dop853::new(1e-15)?.zero(&law, self.start, count, until, |y| y[1])?)
    }
    /// Turns about L between two flips.
    fn turns(&self) -> Result<f64> {
        Ok(self.free_body()?.precession_per_period().abs() / (2.0 * TAU))
    }
    /// The same, counted on the stepped motion in small pieces.
    fn turns_counted(&self) -> Result<f64> {
        let (scene, mut state) = (Scene::new(self.body()?), self.state()?);
        let (method, end) = (Dop853::new(1e-14)?, 2.0 * self.between_flips()?);
        let azimuth = |state: &State| {
            let axis = state.attitude.to_space(unit(self.about));
            atan2(axis.y(), axis.x())
        };
        let pieces = 20 + (8.0 * end * self.momentum() / self.moments[0]) as u32;
        let (mut read, mut from) = (vec![azimuth(&state)], 0.0);
        for t in times(0.0, end, pieces).skip(1) {
            state = method.advance(&scene, from, &state, t)?.0;
            read.push(azimuth(&state));
            from = t;
        }
        let counted = unwrapped(&read)?;
        Ok((counted[counted.len() - 1] - counted[0]).abs() / (2.0 * TAU))
    }
}

/// A direction of the body's axes.
pub fn unit(axis: usize) -> BodyVector {
    BodyVector::from_array([0.0; 3].but(|components| components[axis] = 1.0))
}

/// The rate at which a small error grows when the body turns at `rate` about its middle
/// axis, and those at which it sways about the least and the largest.
pub fn small_motions([i1, i2, i3]: [f64; 3], rate: f64) -> [f64; 3] {
    [
        rate * ((i2 - i1) * (i3 - i1) / (i2 * i3)).sqrt(),
        rate * ((i2 - i1) * (i3 - i2) / (i1 * i3)).sqrt(),
        rate * ((i3 - i1) * (i3 - i2) / (i1 * i2)).sqrt(),
    ]
}

/// The same, simulated: frequencies from two sizes of the sway, the growth from the cosh
/// with which a small error grows.
pub fn small_motions_measured(moments: [f64; 3], rate: f64) -> Result<[f64; 3]> {
    let sways = |axis: usize| {
        let start = |size: f64| [0.0, size, 0.0].but(|start| start[axis] = 1.0);
        small_frequency(&euler(moments), start, 1e4, |y| y[2 - axis])
    };
    let (size, time) = (1e-7, 2.0 / small_motions(moments, 1.0)[1]);
    let grown = after(time, &euler(moments), &[size, 1.0, 0.0], 1e-15)?[0] / size;
    let growth = log(grown + ((grown - 1.0) * (grown + 1.0)).sqrt()) / time;
    Ok([rate * sways(0)?, rate * growth, rate * sways(2)?])
}

fn tumble(p: &Parameters) -> Result<Tumble> {
    let moments = box_moments(p.mass, [p.length, p.width, p.thickness]);
    allowed! {
        "I2": moments[1], from_to(1e-15, 1e15), "products of rates and moments must stay within doubles";
        "rate": p.rate, from_to(1e-15, 1e15), "products of rates and moments must stay within doubles";
    }?;
    let gaps = [moments[0] / moments[1], moments[1] / moments[2]];
    let differ = gaps.iter().all(|ratio| (1e-3..=1.0 - 1e-3).contains(ratio));
    let words = "from 0.001 to 0.999: length, width and thickness must differ, in this order";
    require(differ, "I1/I2 or I2/I3, the larger of the two,", gaps[0].max(gaps[1]), words)?;
    let about = if p.toward == "largest" { 2 } else { 0 };
    Ok(Tumble::new(moments, p.rate, p.aside, about))
}

fn claims(p: &Parameters, report: &mut Report) -> Result<()> {
    let tumble = tumble(p)?;
    let solid = match p.thickness > 0.0 {
        true => solids::cuboid(p.mass, p.length, p.width, p.thickness)?,
        false => solids::plate(p.mass, p.length, p.width)?,
    };
    let library = |i: usize| {
        let axis = DesignVector::from_array(unit(i).to_array());
        solid.about_centre_of_mass().moment_about(axis)
    };
    let ([i1, i2, i3], flips) = (tumble.moments, tumble.between_flips()?);
    let [least, growth, largest] = small_motions(tumble.moments, p.rate);
    let measured = small_motions_measured(tumble.moments, p.rate)?;
    let ((first, _), (second, _)) = (tumble.flip(1)?, tumble.flip(2)?);
    let tiny = |aside| Tumble::new(tumble.moments, p.rate, aside, tumble.about);
    let (decade, per_turn) = (2.0 * LN_10 / growth, p.rate / TAU);
    let waited = tiny(1e-8).flip(1)?.0.t - tiny(1e-7).flip(1)?.0.t;
    let exactly = tiny(1e-9);
    let asymptote = 2.0 * log(4.0 / exactly.complement().sqrt()) / exactly.pace();
    // A hair beside the separatrix a rounded step shifts the flip.
    let slack = 1e-12 * flips + 1e-14 / (p.aside * growth);
    // Near the other end of the axis the same error counts against the square.
    let late = slack + 1e-15 / (p.aside * p.aside * growth);
    let at = tumble.free_body()?.kinematics(0.3 * flips);
    let spun = at.attitude.to_space(at.angular_velocity);
    let (rim, half) = (tumble.across(tumble.start), tumble.rates(0.5 * flips)?);
    let (law, later) = (euler(tumble.moments), second.t + 0.5 * flips);
    let (back, _) = Dop853::new(1e-15)?.advance(&law, second.t, &second.state, later)?;
    let rough = 1e-11 * p.rate / p.aside.min(1.0);
    let (turned, counted) = (tumble.turns()?, tumble.turns_counted()?);
    claims! { report,
        /// least moment, about the longest edge
        i1: i1, "kg m^2", "library's cuboid" => library(0)?, within 1e-14 * i1, in "The body":
            4.0 * i1 => "through the centre, not along an edge";
        /// middle moment, about the edge of middle length
        i2: i2, "kg m^2", "library's cuboid" => library(1)?, within 1e-14 * i2, in "The body":
            i1 => "that is about the longest edge", i3 => "that is about the shortest edge";
        /// largest moment, about the shortest edge
        i3: i3, "kg m^2", "library's cuboid" => library(2)?, within 1e-14 * i3, in "The body":
            i2 => "that is about the edge of middle length";
        /// rate at which an error grows about the middle axis
        growth: growth, "1/s", "growth of 1e-7, stepped" => measured[1], within 1e-9 * growth.max(0.5 * p.rate),
        in "Small errors":
            least => "that is about the least axis", largest => "that is about the largest axis";
        /// angular frequency of the sway about the least axis, at this rate
        sway_least: least, "rad/s", "simulated" => measured[0], within 1e-9 * least, in "Small errors":
            growth => "that is about the middle axis";
        /// the same about the largest
        sway_largest: largest, "rad/s", "simulated" => measured[2], within 1e-9 * largest, in "Small errors":
            growth => "that is about the middle axis";
        /// time from the start to the first flip
        first_flip: 0.5 * flips, "s", "located event" => first.t, within slack;
        /// time between two flips
        between_flips: flips, "s", "located events" => second.t - first.t, within late, in "The flips":
            0.5 * flips => "that is from the start to the first", 2.0 * flips => "that is a whole period, two flips";
        /// turns about L between two flips, of the axis that the polhode surrounds
        turns: turned, "-", "counted, stepped" => counted, within 1e-10 + p.rate * late, in "The flips":
            2.0 * turned => "that is in a whole period";
        /// a start ten times nearer to the axis: so much longer between flips
        decade: decade, "s", "from 1e-7 and 1e-8 rad, stepped" => 2.0 * waited, within 1e-5 * decade, in "The flips":
            LN_10 / growth => "to the first flip; between two it counts twice", 2.0 / growth => "that is e times nearer";
        /// turns at this rate between flips, from a billionth of a radian
        billionth: per_turn * exactly.between_flips()?, "-", "logarithm of (8)" => per_turn * asymptote,
            within 1e-12 * per_turn * asymptote;
        /// part of the angular velocity along L
        height: tumble.height(), "rad/s", "free body, later" => spun.z(), within 1e-13 * length(tumble.start);
        /// herpolhode: part across L at the start
        rim_start: rim, "rad/s", "second flip and a half, stepped" => tumble.across(back), within rough;
        /// herpolhode: part across L at a flip
        rim_flip: tumble.across(half), "rad/s", "located event" => tumble.across(first.state), within rough;
    }
}

/// Near a stable axis, near the middle one, a plate, two moments equal.
fn limits(_: &Parameters, report: &mut Report) -> Result<()> {
    let book = box_moments(0.5, [0.21, 0.14, 0.025]);
    let i2 = book[1];
    let close = |about: usize| Tumble::new(book, 1.0, FRAC_PI_2 - 1e-4, about);
    let sway = |about: usize| -> Result<f64> {
        let small = small_motions(book, i2 / book[about])[about];
        Ok(PI / close(about).between_flips()? / small)
    };
    let near = Tumble::new(book, 1.0, 1e-6, 2);
    let plate = box_moments(1.0, [2.0, 1.0, 0.0]);
    let twins = Tumble::new([1.0, 1.0 + 1e-9, 1.5], 1.0, 1.0, 2);
    let spin = 0.5 * twins.start[2];
    let after = near.rates(0.5 * near.between_flips()? + 1.0 / near.pace())?;
    limits! { report,
        /// nearly about the least axis, the rates go as sine and cosine
        "aside -> pi/2, toward least: frequency over (5)": sway(0)? => 1.0, within 1e-7;
        /// and nearly about the largest
        "aside -> pi/2, toward largest: frequency over (5)": sway(2)? => 1.0, within 1e-7;
        /// nearly about the middle axis, the pace is the rate of growth
        "aside = 1e-6: p/lambda": near.pace() / small_motions(book, 1.0)[1] => 1.0, within 1e-11;
        /// on the separatrix the flip is a hyperbolic tangent
        "aside = 1e-6: Omega_2 at 1/lambda after a flip": -after[1] => (exp(2.0) - 1.0) / (exp(2.0) + 1.0), within 1e-11;
        /// a plate has I3 = I1 + I2; this one is twice as long as wide
        "plate: lambda^2/Omega^2": small_motions(plate, 1.0)[1] * small_motions(plate, 1.0)[1]
            => (plate[1] - plate[0]) / (plate[1] + plate[0]), within 1e-15;
        /// two equal moments: the steady circuit of the symmetric top
        "I1 = I2: p/Omega_S": twins.pace() / spin => 1.0, within 1e-8;
        /// on the separatrix the energy is that of the middle axis
        "aside = 1e-6: 2 E I2/L^2": near.height() * i2 / near.momentum() => 1.0, within 1e-11;
    }
}

/// Things one can throw: edges or moments, and how soon they flip.
fn bodies(_: &Parameters, report: &mut Report) -> Result<()> {
    let columns = "thrown;I2/I1;I3/I1;lambda/Omega;turns between flips, off by 0.1 rad;by 0.01 rad"
        .split(';');
    let boxes = [
        ("book, 21 by 14 by 2.5 cm", box_moments(0.5, [0.21, 0.14, 0.025])),
        ("telephone, 147 by 72 by 8 mm", box_moments(0.17, [0.147, 0.072, 0.008])),
        ("brick, 24 by 11.5 by 7.1 cm", box_moments(3.0, [0.24, 0.115, 0.071])),
        ("box of matches, 53 by 36 by 15 mm", box_moments(0.02, [0.053, 0.036, 0.015])),
    ];
    report.add(Table::of("bodies", columns, boxes, |(name, moments)| {
        let [i1, i2, i3] = moments;
        let turns = |aside| -> Result<String> {
            let tumble = Tumble::new(moments, 1.0, aside, 0);
            let (turned, counted) = (tumble.turns()?, tumble.turns_counted()?);
            Ok(supported_digits(turned, 1e-3_f64.max((turned - counted).abs())))
        };
        let ratios = [i2 / i1, i3 / i1, small_motions(moments, 1.0)[1]];
        let [middle, largest, growth] = ratios.map(|x| supported_digits(x, 1e-3));
        Ok([name.to_string(), middle, largest, growth, turns(0.1)?, turns(0.01)?])
    })?)
}

fn accuracy(p: &Parameters, report: &mut Report) -> Result<()> {
    let tumble = tumble(p)?;
    // Three flips and a third: not a whole number, where errors might cancel.
    let end = 10.0 / 3.0 * tumble.between_flips()?;
    let (motion, scene) = (tumble.free_body()?, Scene::new(tumble.body()?));
    let problem = Problem::new(scene, tumble.state()?, end, motion.state(end));
    let problem = problem.in_closed_form(move |t| motion.attitude(t));
    report.strip(&problem, &[p.tolerance, 1e-3, 1e-6, 1e-10])
}

fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let tumble = tumble(p)?;
    let (motion, end) = (tumble.free_body()?, 4.0 * tumble.between_flips()?);
    let columns = ["t [s]", "Omega_1 [rad/s]", "Omega_2 [rad/s]", "Omega_3 [rad/s]", "e2_Z [-]"];
    Trajectory::sampled(columns, times(0.0, end, 600), |t| {
        let at = motion.kinematics(t);
        let [p, q, r] = at.angular_velocity.to_array();
        Ok([t, p, q, r, at.attitude.to_space(unit(1)).z()])
    })
}

example! {
    ch15_5_asymmetric: "A free body with three different moments: polhodes, and flips about the middle axis";
    "Three different moments", "A book thrown with a turn about its middle axis; nothing acts on it.",
    [claims, naive::claims, limits, left_out::effects, left_out::flips_in_air, bodies, accuracy];
    figures::figures, trajectory, tumbling::moving_picture
}
