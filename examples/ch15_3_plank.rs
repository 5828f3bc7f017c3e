//! Section 15.3, example 3: a plank that stands upright on a frictionless floor and falls.

#[path = "ch15_3_plank/figures.rs"]
mod figures;
#[path = "ch15_3_plank/variations.rs"]
mod variations;

pub use variations::rubbing;

use core::f64::consts::FRAC_PI_2;
use kit::prelude::*;
use models::ladder::Ladder;
use models::plank::Plank as Exact;
use rotation_dynamics::accuracy::largest;
use rotation_dynamics::integrators::{Dop853, LocatedEvent, Ode, ode};
use rotation_dynamics::math::{acosh, asinh, cosh, sinh};
use rotation_dynamics::planar::contact::{
    Contact, ContactMotion, Mechanism, MechanismState, Surface, motion_within,
};

parameters! {
    /// The plank of the example; the notes leave all numbers open.
    pub struct Parameters {
        /// mass of the plank
        mass: number(1.0, "kg", from_to(1e-9, 1e9).usually(0.1, 10.0));
        /// length of the plank
        length: number(1.0, "m", from_to(1e-9, 1e9).usually(0.2, 4.0));
        gravity: gravity(from_to(1e-9, 1e9).usually(1.0, 25.0));
        /// angle from the vertical at which it is released at rest
        angle: number(0.01, "rad", from_to(1e-30, 1.5).because("counted to the side to which it falls; upright it stays for ever").usually(1e-6, 1.0)).open("angle at the release", "nearly upright", "far over");
        /// angle at which the rate is asked for, on the way from upright
        look: number(0.5, "rad", from_to(1e-3, 1.57).because("counted to the side to which it falls, until it lies").usually(0.1, 1.5));
        /// angle from which the time to the floor is asked for, on the same way
        from: number(0.1, "rad", from_to(1e-6, 1.5).because("counted to the side to which it falls; upright it stays for ever").usually(0.01, 1.0));
        /// relative error asked for, at every event: from 1e-13 to 0.01
        tolerance: number(1e-12, "-", from_to(1e-13, 0.01));
    }
}

/// A plank on a floor, per unit mass.
///
/// Its coordinates are `[x, y, theta]`: its middle, and its angle from the vertical. It falls to
/// the left; a foot that moves to the right slips backwards.
#[derive(Debug, Clone, Copy)]
pub struct Plank {
    pub length: f64,
    pub gravity: f64,
    pub mu: f64,    // coefficient of friction of the floor
    pub drag: f64,  // rho C w/(2 m): air over mass, for a unit of length and speed, 1/m^2
    pub until: f64, // the angle at which the scene ends
}

// ANCHOR: scene
impl Mechanism<3, 1> for Plank {
    fn mass(&self, _: &[f64; 3]) -> [[f64; 3]; 3] {
        let turning = self.length * self.length / 12.0;
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, turning]]
    }

    fn force(&self, plank: &MechanismState<3>) -> [f64; 3] {
        let [x, y, moment] = self.air(plank);
        [x, y - self.gravity, moment]
    }

    fn contacts(&self, plank: &MechanismState<3>) -> [Contact<3>; 1] {
        let ((s, c), half) = (sincos(plank.q[2]), 0.5 * self.length);
        let foot = Contact::corner("foot", plank, [half * s, -half * c], Surface::FLOOR);
        [foot.friction(self.mu)]
    }

    fn end(&self, plank: &MechanismState<3>) -> Option<(&'static str, f64)> {
        Some(("arrives", self.until - plank.q[2]))
    }
    // ANCHOR_END: scene

    /// Errors count relative to the angle, so a start a hair off upright is followed as closely
    /// as any other.
    fn scale(&self, plank: &MechanismState<3>) -> MechanismState<3> {
        let rate = (6.0 * self.gravity / self.length).sqrt();
        let q = [self.length, self.length, plank.q[2].abs().max(1e-300)];
        MechanismState { q, v: q.map(|size| rate * size) }
    }
}

/// A motion of the plank.
pub type Fall = ContactMotion<Plank, 3, 1>;

impl Plank {
    /// The smooth plank in no air, until it lies on the floor.
    pub fn smooth(p: &Parameters) -> Self {
        Self { length: p.length, gravity: p.gravity, mu: 0.0, drag: 0.0, until: FRAC_PI_2 }
    }

    /// The fall from this angle and rate, its middle above the origin, within this error.
    pub fn fall(self, tolerance: f64, angle: f64, rate: f64) -> rotation_dynamics::Result<Fall> {
        let (half, (s, c)) = (0.5 * self.length, sincos(angle));
        let start = MechanismState { q: [0.0, half * c, angle], v: [0.0, -half * s * rate, rate] };
        // Friction may double the time, and then some.
        let unit = (self.length / self.gravity).sqrt();
        let longest = unit * (20.0 + 4.0 * log(1.0 / angle.clamp(1e-300, 1.0)));
        motion_within(self, tolerance, start, longest)
    }

    /// Force and moment of the air over the mass, by the pieces of the plank: each is pushed at
    /// right angles to the plank, with the square of its speed in that direction.
    fn air(&self, plank: &MechanismState<3>) -> [f64; 3] {
        if self.drag == 0.0 {
            return [0.0; 3];
        }
        let ((s, c), [vx, vy, rate]) = (sincos(plank.q[2]), plank.v);
        let across = -(vx * c + vy * s);
        let (mut force, mut moment) = (0.0, 0.0);
        for at in times(-39.0 / 80.0 * self.length, 39.0 / 80.0 * self.length, 39) {
            let speed = across + rate * at;
            let push = -self.drag * speed * speed.abs() * self.length / 40.0;
            (force, moment) = (force + push, moment + push * at);
        }
        // The top moves to the left and down.
        [-force * c, -force * s, moment]
    }
}

/// lambda = sqrt(6 g/l), the rate at which a small tilt grows.
pub fn growth(p: &Parameters) -> f64 {
    (6.0 * p.gravity / p.length).sqrt()
}

// ANCHOR: rates
/// Equation (2): the rate at `angle`, on the way from upright.
pub fn rate_from_upright(p: &Parameters, angle: f64) -> f64 {
    2.0 * growth(p) * sin(0.5 * angle) / stretch(angle)
}

/// The rate at `angle` after a release at rest at `start`.
pub fn rate_released(p: &Parameters, angle: f64, start: f64) -> f64 {
    // sin^2(angle/2) - sin^2(start/2), without their difference
    let fallen = sin(0.5 * (angle - start)) * sin(0.5 * (angle + start));
    2.0 * growth(p) * fallen.sqrt() / stretch(angle)
}

/// sqrt(1 + 3 sin^2(angle)).
fn stretch(angle: f64) -> f64 {
    (1.0 + 3.0 * sin(angle) * sin(angle)).sqrt()
}
// ANCHOR_END: rates

/// The time of the fall by quadrature, in the variable of which the integrand knows no end.
pub fn time_by_quadrature(p: &Parameters, start: f64) -> f64 {
    let half = sin(0.5 * start);
    let width = acosh(0.5_f64.sqrt() / half) / 400.0;
    let slope = |w: f64| {
        let sine = half * cosh(w);
        let square = (1.0 - sine) * (1.0 + sine);
        ((1.0 + 12.0 * sine * sine * square) / square).sqrt()
    };
    // Gauss's rule with four points, on each of 400 panels.
    let (outer, inner) = (0.861_136_311_594_052_6, 0.339_981_043_584_856_26);
    let (less, more) = (0.347_854_845_137_453_85, 0.652_145_154_862_546_2);
    let mut sum = 0.0;
    for n in 0..400 {
        for (x, weight) in [(-outer, less), (outer, less), (-inner, more), (inner, more)] {
            sum += 0.5 * width * weight * slope(width * (f64::from(n) + 0.5 + 0.5 * x));
        }
    }
    sum / growth(p)
}

/// A rod of the same length, hinged at its foot: `[theta, theta']`.
fn hinged(p: &Parameters) -> impl Ode<2> {
    let square = 1.5 * p.gravity / p.length;
    ode(move |_, [angle, rate]: &[f64; 2]| [*rate, square * sin(*angle)])
        .scaled(move |[angle, _]| [angle.abs(), square.sqrt() * angle.abs()])
}

/// When and how the hinged rod comes from rest at `start` to the angle `end`.
pub fn hinged_fall(p: &Parameters, start: f64, end: f64) -> Result<LocatedEvent<2>> {
    let (method, longest) = (Dop853::new(1e-15)?, 1e9 * (p.length / p.gravity).sqrt());
    Ok(method.zero(&hinged(p), [start, 0.0], 1, longest, |y| y[0] - end)?.0)
}

/// The time to the floor from rest at this angle with the foot held, in closed form.
fn held_time(p: &Parameters, angle: f64) -> Result<f64> {
    Ok(Ladder::new(p.length, p.gravity, angle)?.held_landing_time())
}

/// The angle at which the floor pushes least, on the way from upright, and with how much of the
/// weight: N/mg = (4 - 6 c + 3 c^2)/(4 - 3 c^2)^2 with c its cosine, least where
/// 3 c^3 - 9 c^2 + 12 c - 4 = 0.
pub fn least_force() -> [f64; 2] {
    let c = 1.0 - 2.0 / 3.0_f64.sqrt() * sinh(asinh(3.0_f64.sqrt()) / 3.0);
    let below = 4.0 - 3.0 * c * c;
    [acos(c), (1.0 + 3.0 * (1.0 - c) * (1.0 - c)) / (below * below)]
}

// ANCHOR: solve
/// The plank released at rest at this angle, in closed form.
pub fn exact(p: &Parameters, angle: f64) -> Result<Exact> {
    Ok(Exact::new(p.length, p.gravity, angle, 0.0)?)
}

/// The same by simulation, within the tolerance, as `p` releases it.
fn simulated(p: &Parameters) -> Result<Fall> {
    Ok(Plank::smooth(p).fall(p.tolerance, p.angle, 0.0)?)
}
// ANCHOR_END: solve

/// A start as near upright as makes no difference to fifteen digits.
const HAIR: f64 = 1e-9;

/// On the way from upright, where the energy is m g l/2.
fn upright(p: &Parameters, report: &mut Report) -> Result<()> {
    let (l, g, lambda) = (p.length, p.gravity, growth(p));
    let smooth = Plank::smooth(p);
    let to = |until: f64| -> Result<_> {
        let run = Plank { until, ..smooth }.fall(p.tolerance, HAIR, 0.0)?;
        Ok(run.event("arrives")?.clone())
    };
    let ([lowest, least], start) = (least_force(), rate_from_upright(p, p.from));
    let (doubled, looked, pushed, floor) =
        (to(2.0 * HAIR)?, to(p.look)?, to(lowest)?, to(FRAC_PI_2)?);
    let (looked, floor) = (looked.before.v[2], floor.before.v[2]);
    let passing = smooth.fall(p.tolerance, p.from, start)?;
    let slow = hinged_fall(p, HAIR, 2.0 * HAIR)?;
    let rate = rate_from_upright(p, p.look);
    let (bound, energy) = (4.0 * p.tolerance, 0.5 * p.mass * g * l);
    let time = Exact::new(l, g, p.from, start)?.landing_time();
    let pivoted = (1.5 * g / l).sqrt();
    claims! { report,
        /// energy of the plank upright, counted from the floor
        energy: energy, "J", "at the floor" => p.mass * l * l / 6.0 * floor * floor, within bound * energy;
        /// rate at which a small tilt grows
        growth: lambda, "1/s", "time of doubling" => acosh(2.0) / doubled.t, within bound * lambda, in "Near upright":
            pivoted => "that is for a foot that is held", (g / l).sqrt() => "the moment of inertia counts too";
        /// the same with the foot held
        growth_held: pivoted, "1/s", "time of doubling" => acosh(2.0) / slow.t, within 1e-12 * pivoted, in "Near upright":
            lambda => "that is for a foot that slides";
        /// angular velocity at the angle asked for
        rate_look: rate, "rad/s", "simulation from 1e-9 rad" => looked, within bound * lambda, in "From upright":
            lambda * p.look => "the angle is not small",
            (3.0 * g / l * (1.0 - cos(p.look))).sqrt() => "that is for a foot that is held";
        /// angular velocity at the floor
        rate_floor: (3.0 * g / l).sqrt(), "rad/s", "simulation from 1e-9 rad" => floor, within bound * lambda, in "From upright":
            (12.0 * g / l).sqrt() => "the middle takes part of the energy";
        /// time to the floor from the second angle
        time_from: time, "s", "located event" => passing.end_time(), within bound / lambda, in "From upright":
            exact(p, p.from)?.landing_time() => "it passes that angle moving";
        /// angle at which the floor pushes least
        theta_least: lowest, "rad", "least of the simulated forces" => variations::lowest(&smooth)?, within 1e-8;
        /// least force of the floor over the weight
        n_least: least, "-", "simulation from 1e-9 rad" => pushed.force[0].normal / g, within bound;
    }
}

/// After the release at rest.
fn released(p: &Parameters, report: &mut Report) -> Result<()> {
    let (l, g, lambda, run) = (p.length, p.gravity, growth(p), simulated(p)?);
    let (lands, fall) = (run.event("arrives")?, exact(p, p.angle)?);
    let (time, landed) = (fall.landing_time(), fall.landing());
    let (bound, held) = (4.0 * p.tolerance, held_time(p, p.angle)?);
    let fixed = hinged_fall(p, p.angle, FRAC_PI_2)?;
    let rate = (3.0 * g * cos(p.angle) / l).sqrt();
    claims! { report,
        /// time at which the plank lies on the floor
        t_floor: time, "s", "located event" => lands.t, within bound / lambda, in "Released at rest":
            held => "that is for a foot that is held",
            acosh(FRAC_PI_2 / p.angle) / lambda => "that takes all angles as small";
        /// angular velocity at the floor
        omega_floor: landed.omega, "rad/s", "located event" => lands.before.v[2], within bound * lambda, in "Released at rest":
            (12.0 * g * cos(p.angle) / l).sqrt() => "the middle takes part of the energy";
        /// velocity of the middle at the floor
        v_floor: landed.vy_cm, "m/s", "located event" => lands.before.v[1], within bound * lambda * l, in "Released at rest":
            -landed.vy_cm => "it goes down",
            -(g * l * cos(p.angle)).sqrt() => "that is a free fall; part of the energy is in the rotation";
        /// force of the floor over the weight, just before the plank lies on it
        n_floor: landed.floor_force, "-", "simulation" => lands.force[0].normal / g, within bound, in "Released at rest":
            1.0 => "the middle accelerates downwards";
        /// time with the foot held
        t_held: held, "s", "hinged rod, simulated" => fixed.t, within 1e-12 / lambda, in "With the foot held":
            time => "that is for a foot that slides";
        /// angular velocity at the floor with the foot held
        omega_held: rate, "rad/s", "hinged rod, simulated" => fixed.state[1], within 1e-12 * lambda, in "With the foot held";
    }
}

fn limits(p: &Parameters, report: &mut Report) -> Result<()> {
    let time = |angle| Ok::<_, kit::Error>(exact(p, angle)?.landing_time());
    let digit = time(1e-9)? - time(1e-8)?;
    let double = (held_time(p, 1e-9)? - held_time(p, 1e-8)?) / digit;
    let flat = time(FRAC_PI_2 - 1e-6)? * (0.75 * p.gravity / (p.length * 1e-6)).sqrt();
    limits! { report,
        /// exp(lambda t) must make up for a factor of ten
        "nearly upright: time of a factor ten, lambda t - ln 10": growth(p) * digit - log(10.0) => 0.0, within 1e-12;
        /// half the rate, twice the time
        "nearly upright: foot held, over foot free": double => 2.0, within 1e-12;
        /// the middle does not accelerate yet
        "nearly upright: N/(m g) at the start": exact(p, 1e-9)?.start().floor_force => 1.0, within 1e-15;
        /// the height is fallen with the acceleration 3 g/4, since the floor bears a quarter
        "nearly flat: t sqrt(3 g/(4 l x))": flat => 1.0, within 1e-9;
        /// quadrature and closed form are one
        "0.5 rad: time by quadrature, over the closed form": time_by_quadrature(p, 0.5) / time(0.5)? => 1.0, within 1e-14;
    }
}

/// What accuracy costs: the error asked for, the error found, the work.
fn accuracy(p: &Parameters, report: &mut Report) -> Result<()> {
    let (fall, plank, start) = (exact(p, p.angle)?, Plank::smooth(p), p.angle);
    let (time, landed) = (fall.landing_time(), fall.landing());
    report.in_closed_form(move |part| fall.at(part * time));
    let asked = [1e-3, 1e-5, 1e-7, 1e-9, 1e-11, p.tolerance];
    let run = move |tolerance| plank.fall(tolerance, start, 0.0);
    report.controlled("solve: DOP853 on the contact", asked, run, Fall::work, move |run| {
        let lands = run.event("arrives")?;
        Ok(largest([lands.t / time - 1.0, lands.before.v[2] / landed.omega - 1.0]))
    })
}

example! {
    ch15_3_plank: "Section 15.3, example 3: a plank falls over on a frictionless floor";
    "The falling plank", "A plank on a frictionless floor, released at rest near the vertical.",
    [upright, released, limits, variations::effects, accuracy, variations::starts, variations::rough];
    figures::figures, figures::trajectory, figures::moving_picture
}
