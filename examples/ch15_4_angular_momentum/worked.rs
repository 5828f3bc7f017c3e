//! The worked examples: a closed form each, and the same body as a swarm.

use super::swarm::{Grain, ORIGIN, Swarm, angle, ball, cuboid, cylinder};
use super::{Parameters, Shaft, euler};
use core::f64::consts::{FRAC_PI_2, TAU};
use kit::prelude::*;

/// A wheel that rolls along x on the floor y = 0, clockwise; its centre starts above the origin.
pub fn rolling(p: &Parameters) -> Swarm {
    let (radius, rate) = (p.wheel_radius, p.wheel_rate);
    Swarm::new(cylinder(p.wheel_mass, radius, 0.0), rate, move |t, grain| {
        let ((s, c), centre) = (sincos(rate * t), SpaceVector::new(radius * rate * t, radius, 0.0));
        let (x, y) = (grain.x(), grain.y());
        centre + SpaceVector::new(c * x + s * y, c * y - s * x, 0.0)
    })
}

/// A coin that rolls round another of its size: once round the orbit it turns twice.
fn coin(p: &Parameters) -> Swarm {
    let (radius, rate) = (p.coin_radius, p.coin_rate);
    Swarm::new(cylinder(p.coin_mass, radius, 0.0), 2.0 * rate, move |t, grain| {
        let (s, c) = sincos(rate * t);
        let centre = SpaceVector::new(2.0 * radius * c, 2.0 * radius * s, 0.0);
        centre + euler(2.0 * rate * t, 0.0, 0.0).to_space(grain)
    })
}

/// What turns about an axis that keeps its direction: the rolling wheel and the coin.
pub fn round(p: &Parameters, report: &mut Report) -> Result<()> {
    let (m, r) = (p.wheel_mass, p.wheel_radius);
    let (wheel, unit) = (rolling(p), m * r * r * p.wheel_rate);
    // Clockwise counts, as the wheel turns.
    let about = |x: f64, y: f64| -wheel.angular_momentum(SpaceVector::new(x, y, 0.0)).z();
    let coins = p.coin_mass * p.coin_radius * p.coin_radius * p.coin_rate;
    let rolled = coin(p).angular_momentum(ORIGIN).z();
    let (sums, bound) = ("sum of r x m v", 1e-12 * unit);
    claims! { report,
        /// rolling wheel: L about its centre
        wheel_centre: 0.5 * unit, "kg m^2/s", sums => about(0.0, r), within bound, in "A rolling wheel":
            unit => "that is a hoop";
        /// about a point of the floor ten radii behind
        wheel_floor: 1.5 * unit, "kg m^2/s", sums => about(-10.0 * r, 0.0), within bound, in "A rolling wheel":
            0.5 * unit => "add what the centre carries";
        /// about the point of contact
        wheel_contact: 1.5 * unit, "kg m^2/s", sums => about(0.0, 0.0), within bound;
        /// about the top of the rim
        wheel_top: -0.5 * unit, "kg m^2/s", sums => about(0.0, 2.0 * r), within bound, in "A rolling wheel":
            1.5 * unit => "that is I Omega; but this point moves", 0.5 * unit => "look at the sign";
        /// coin on coin: L about the centre of the fixed one
        coin: 5.0 * coins, "kg m^2/s", sums => rolled, within 1e-12 * coins, in "Coin on coin":
            4.5 * coins => "how often does the coin turn in an orbit?", 6.0 * coins => "a disc, not a hoop";
    }
}

/// The Earth, a uniform ball: mass, mean distance from the Sun, mean radius, moment; SI units.
const MASS: f64 = 5.9722e24;
const DISTANCE: f64 = 1.495978707e11;
const RADIUS: f64 = 6.371e6;
const INERTIA: f64 = 0.4 * MASS * RADIUS * RADIUS;

/// It goes once round in a year of 365.25 days of 86400 s, and turns once in a day as seen from
/// the Sun: rad/s.
pub const ORBIT: f64 = TAU / (365.25 * 86400.0);
pub const SPIN: f64 = TAU / 86400.0;

/// Its L in three terms: m R_ES^2 Omega, 2/5 m R_E^2 Omega_S and 2/5 m R_E^2 Omega.
pub const EARTH: [f64; 3] = [MASS * DISTANCE * DISTANCE * ORBIT, INERTIA * SPIN, INERTIA * ORBIT];

/// The Earth about the Sun.
pub fn earth(_: &Parameters, report: &mut Report) -> Result<()> {
    let ([orbit, spin, third], grains) = (EARTH, || ball(MASS, RADIUS));
    // A ball that is carried round without turning, and one that turns on the spot.
    let carried = Swarm::new(grains(), ORBIT, |t, grain| {
        let (s, c) = sincos(ORBIT * t);
        SpaceVector::new(DISTANCE * c, DISTANCE * s, 0.0) + grain.to_array().into()
    });
    let carried = carried.angular_momentum(ORIGIN).z();
    let spinning = |rate| Swarm::turning(grains(), SpaceVector::new(0.0, 0.0, rate), ORIGIN);
    let turning = |rate| spinning(rate).angular_momentum(ORIGIN).z();
    // The pole stands at 23.44 degrees; the printed third term does not point there.
    let chord = 2.0 * sin(0.5 * 23.44_f64.to_radians());
    claims! { report,
        /// the Earth about the Sun: its orbit
        earth_orbit: orbit, "kg m^2/s", "a ball carried round" => carried, within 1e-12 * orbit, in "The Earth";
        /// its spin, as a uniform ball
        earth_spin: spin, "kg m^2/s", "sum of r x m v" => turning(SPIN), within 1e-12 * spin, in "The Earth";
        /// the turn a year that is not seen from the Sun
        earth_third: third, "kg m^2/s", "turn faster by that" => turning(SPIN + ORBIT) - spin, within 1e-10 * third;
        /// error of the printed third term over the spin
        erratum_e18: third * chord / (spin + third), "-", "two rates" => chord / 366.25, within 1e-14;
    }
}

/// A disc that rolls at the end of a level shaft, whose other end is hinged on a vertical rod: L
/// about the hinge, along the shaft (rho) and along the vertical.
pub fn runner_momentum(p: &Parameters) -> [f64; 2] {
    let (mass, radius, shaft) = (p.runner_mass, p.runner_radius, p.runner_shaft);
    let along = -0.5 * mass * radius * shaft * p.runner_rate;
    [along, mass * (shaft * shaft + 0.25 * radius * radius) * p.runner_rate]
}

/// The force of the floor on it.
pub fn runner_force(p: &Parameters) -> f64 {
    p.runner_mass * (p.gravity + 0.5 * p.runner_radius * p.runner_rate * p.runner_rate)
}

/// That disc as grains; the hinge is the origin, and the shaft lies along X at t = 0.
pub fn runner(p: &Parameters) -> Swarm {
    let (radius, shaft, rate) = (p.runner_radius, p.runner_shaft, p.runner_rate);
    let (spin, out) = (rate * shaft / radius, BodyVector::new(0.0, 0.0, -shaft));
    // The shaft is the axis of the disc: whatever turns the one carries the other.
    Swarm::new(cylinder(p.runner_mass, radius, 0.0), rate + spin, move |t, grain| {
        euler(rate * t - FRAC_PI_2, FRAC_PI_2, spin * t).to_space(grain + out)
    })
}

/// The wheel on a shaft.
pub fn edge_runner(p: &Parameters, report: &mut Report) -> Result<()> {
    let (mass, r, shaft, rate) = (p.runner_mass, p.runner_radius, p.runner_shaft, p.runner_rate);
    let (n, weight) = (runner_force(p), mass * p.gravity);
    allowed! {
        "runner_shaft/runner_radius": shaft / r, from_to(1e-3, 1e3), "beyond it the grains lose their digits";
        "(N - M g)/N": (n - weight) / n, from_to(1e-8, 1.0), "slower, what the turning adds is lost beside the weight";
    }?;
    let ([along, up], swarm) = (runner_momentum(p), runner(p));
    let energy = mass * rate * rate * (0.75 * shaft * shaft + 0.125 * r * r);
    let momentum = swarm.angular_momentum(ORIGIN);
    let double = (2.0 * p.gravity / r).sqrt();
    // Weight and floor must have, about the hinge, the torque that turns L.
    let needed = weight - swarm.torque().y() / shaft;
    // The faster it spins, the shorter is the step between two looks; the torque needs two steps.
    let turns = rate.abs() * (1.0 + shaft / r);
    let bound = 4e-13 * turns / rate.abs();
    let off = 1e-11 * n + 3e-12 * up.abs() * turns / shaft * (turns / rate.abs());
    // What is added to the weight grows with the square of the rate.
    let added = needed - weight;
    let sums = "sum of r x m v";
    claims! { report,
        /// wheel on a shaft: L about the hinge, along the shaft outward
        runner_along: along, "kg m^2/s", sums => momentum.x(), within bound * up, in "A wheel on a shaft":
            -along => "which way does it turn, seen from the hinge?", along / rate => "that has no 1/s";
        /// and along the vertical
        runner_up: up, "kg m^2/s", sums => momentum.z(), within bound * up, in "A wheel on a shaft":
            mass * shaft * shaft * rate => "the wheel also turns about its own diameter",
            mass * (shaft * shaft + 0.5 * r * r) * rate => "about a diameter, not about the axle";
        /// force of the floor
        runner_force: n, "N", "dL/dt of the grains" => needed, within off, in "A wheel on a shaft":
            weight => "that is the weight only", 2.0 * weight - n => "the torque has the other sign";
        /// angular velocity at which it is twice the weight
        runner_double: double, "rad/s", "the same, scaled" => rate.abs() * (weight / added).sqrt(),
        within double * (1e-12 + off / (n - weight));
        /// kinetic energy
        runner_energy: energy, "J", "sum of m v^2/2" => swarm.kinetic_energy(), within bound * energy, in "A wheel on a shaft";
    }
}

/// A cylinder at this tilt on a shaft that turns at this rate, as grains.
pub fn on_shaft(cylinder: Vec<Grain>, tilt: f64, rate: f64) -> Swarm {
    Swarm::new(cylinder, rate, move |t, grain| euler(rate * t, tilt, 0.0).to_space(grain))
}

/// A square plate that turns about an edge, which is the Y axis; its corner is the origin.
pub fn plate(p: &Parameters) -> Swarm {
    let a = p.plate_side;
    let grains = cuboid(p.plate_mass, [a, a, 0.0], BodyVector::new(0.5 * a, 0.5 * a, 0.0));
    Swarm::turning(grains, SpaceVector::new(0.0, p.plate_rate, 0.0), ORIGIN)
}

/// The cylinder and the plate.
pub fn askew(p: &Parameters, report: &mut Report) -> Result<()> {
    let shaft = Shaft::of(p)?;
    let swarm = on_shaft(cylinder(p.mass, p.radius, p.height), p.tilt, p.rate);
    let (momentum, unit) = (shaft.momentum(), (shaft.i1 + shaft.i3) * p.rate);
    let sum = swarm.angular_momentum(ORIGIN);
    let omega = SpaceVector::new(0.0, 0.0, p.rate);
    let on_body = shaft.attitude(0.0).to_body(sum);
    let torque = shaft.torque().x();
    let (m, a, w) = (p.plate_mass, p.plate_side, p.plate_rate);
    let (square, edge) = (m * a * a * w, plate(p).angular_momentum(ORIGIN));
    let (x, y) = (-square / 4.0, square / 3.0);
    let half = 0.5_f64.sqrt();
    let (sums, bound) = ("sum of r x m v", 1e-12 * unit);
    claims! { report,
        /// inclined cylinder: L along y
        cylinder_y: momentum.y(), "kg m^2/s", sums => on_body.y(), within bound, in "The inclined cylinder";
        /// along its own axis
        cylinder_z: momentum.z(), "kg m^2/s", sums => on_body.z(), within bound, in "The inclined cylinder";
        /// angle from Omega to L
        cylinder_angle: shaft.angle(), "rad", sums => angle(sum, omega), within 1e-11, in "The inclined cylinder":
            FRAC_PI_2 - p.tilt => "that is for a needle";
        /// torque of the bearings along x
        cylinder_torque: torque, "N m", "dL/dt of the grains" => swarm.torque().x(), within 1e-11 * unit * p.rate,
        in "The inclined cylinder":
            -torque => "that is the torque on the bearings", 0.0 => "L is as long as before, but it turns";
        /// square plate: L about its corner along x
        plate_x: x, "kg m^2/s", sums => edge.x(), within 1e-12 * square, in "The square plate":
            -x => "a product of inertia has a minus", 0.0 => "L is not along Omega";
        /// along y
        plate_y: y, "kg m^2/s", sums => edge.y(), within 1e-12 * square, in "The square plate":
            square / 12.0 => "that is about the middle";
        /// the same along the diagonal x'
        plate_diagonal: square / 12.0 * half, "kg m^2/s", "turned by 45 degrees" => half * (edge.x() + edge.y()), within 1e-12 * square;
        /// and square to it, along y'
        plate_across: 7.0 * square / 12.0 * half, "kg m^2/s", "turned by 45 degrees" => half * (edge.y() - edge.x()), within 1e-12 * square;
    }
}
