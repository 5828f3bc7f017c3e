//! The worked examples: a closed form each, and the same body as a swarm.

use super::swarm::{Grain, Swarm, ball, chord, cuboid, cylinder, step};
use super::{Parameters, Shaft, euler, turning};
use core::f64::consts::{FRAC_PI_2, TAU};
use kit::interval::from_to;
use kit::{Report, Result};
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::math::sincos;

const ORIGIN: SpaceVector = SpaceVector::new(0.0, 0.0, 0.0);

/// Six particles on the axes, two of 1/2 kg on each, with these principal moments.
pub fn on_axes([a, b, c]: [f64; 3]) -> Vec<Grain> {
    let far = [b + c - a, c + a - b, a + b - c].map(|sum| (0.5 * sum).sqrt());
    let mut grains = Vec::new();
    for (axis, far) in far.into_iter().enumerate() {
        for side in [-far, far] {
            let mut place = [0.0; 3];
            place[axis] = side;
            grains.push((0.5, BodyVector::from_array(place)));
        }
    }
    grains
}

/// A wheel that rolls along x on the floor y = 0, clockwise; its centre starts above the origin.
pub fn rolling(p: &Parameters) -> Swarm<impl Fn(f64, BodyVector) -> SpaceVector> {
    let (radius, rate) = (p.wheel_radius, p.wheel_rate);
    let place = move |t, grain: BodyVector| {
        let (s, c) = sincos(rate * t);
        let turned =
            SpaceVector::new(c * grain.x() + s * grain.y(), c * grain.y() - s * grain.x(), 0.0);
        SpaceVector::new(radius * rate * t, radius, 0.0) + turned
    };
    let grains = cylinder(p.wheel_mass, radius, 0.0);
    Swarm { grains, place, step: step(rate) }
}

/// A coin that rolls round another of its size: once round the orbit it turns twice.
pub fn coin(p: &Parameters) -> Swarm<impl Fn(f64, BodyVector) -> SpaceVector> {
    let (radius, rate) = (p.coin_radius, p.coin_rate);
    let place = move |t, grain| {
        let (s, c) = sincos(rate * t);
        let centre = SpaceVector::new(2.0 * radius * c, 2.0 * radius * s, 0.0);
        centre + euler(2.0 * rate * t, 0.0, 0.0).to_space(grain)
    };
    let grains = cylinder(p.coin_mass, radius, 0.0);
    Swarm { grains, place, step: step(2.0 * rate) }
}

/// A uniform ball that goes round the Sun and turns. SI units; days of 86400 s.
pub struct Earth {
    pub mass: f64,
    pub distance: f64,
    pub radius: f64,
}

/// The Earth: mass, mean distance from the Sun, mean radius.
pub const EARTH: Earth = Earth { mass: 5.9722e24, distance: 1.495978707e11, radius: 6.371e6 };

impl Earth {
    /// Once round in a year of 365.25 days, rad/s.
    pub const ORBIT: f64 = TAU / (365.25 * 86400.0);
    /// Once round in a day, as seen from the Sun, rad/s.
    pub const SPIN: f64 = TAU / 86400.0;

    fn inertia(&self) -> f64 {
        0.4 * self.mass * self.radius * self.radius
    }

    /// m R_ES^2 Omega.
    pub fn orbital(&self) -> f64 {
        self.mass * self.distance * self.distance * Self::ORBIT
    }

    /// 2/5 m R_E^2 Omega_S.
    pub fn spin(&self) -> f64 {
        self.inertia() * Self::SPIN
    }

    /// 2/5 m R_E^2 Omega.
    pub fn third(&self) -> f64 {
        self.inertia() * Self::ORBIT
    }

    /// L about its own centre, turning at this rate: a swarm.
    fn swarm(&self, rate: f64) -> f64 {
        let omega = SpaceVector::new(0.0, 0.0, rate);
        let swarm = turning(ball(self.mass, self.radius), omega, ORIGIN);
        swarm.angular_momentum(ORIGIN).z()
    }

    /// L about the Sun of a ball that is carried round without turning.
    fn carried(&self) -> f64 {
        let far = self.distance;
        let place = move |t, grain: BodyVector| {
            let (s, c) = sincos(Self::ORBIT * t);
            SpaceVector::new(far * c, far * s, 0.0) + SpaceVector::from_array(grain.to_array())
        };
        let (grains, step) = (ball(self.mass, self.radius), step(Self::ORBIT));
        Swarm { grains, place, step }.angular_momentum(ORIGIN).z()
    }
}
/// A disc that rolls at the end of a level shaft, whose other end is hinged on a vertical rod.
#[derive(Debug, Clone, Copy)]
pub struct Runner {
    pub mass: f64,
    pub radius: f64,
    pub shaft: f64,
    /// Of the shaft about the vertical.
    pub rate: f64,
}

impl Runner {
    /// L about the hinge: along the shaft (rho) and along the vertical.
    pub fn momentum(&self) -> [f64; 2] {
        let Self { mass, radius, shaft, rate } = *self;
        let along = -0.5 * mass * radius * shaft * rate;
        [along, mass * (shaft * shaft + 0.25 * radius * radius) * rate]
    }

    /// The force of the floor.
    pub fn force(&self, gravity: f64) -> f64 {
        self.mass * (gravity + 0.5 * self.radius * self.rate * self.rate)
    }

    /// Kinetic energy.
    pub fn energy(&self) -> f64 {
        let square = 0.75 * self.shaft * self.shaft + 0.125 * self.radius * self.radius;
        self.mass * self.rate * self.rate * square
    }
}

/// That disc as grains; the hinge is the origin, and the shaft lies along X at t = 0.
pub fn runner(r: Runner) -> Swarm<impl Fn(f64, BodyVector) -> SpaceVector> {
    let spin = r.rate * r.shaft / r.radius;
    let out = BodyVector::new(0.0, 0.0, -r.shaft);
    // The shaft is the axis of the disc: whatever turns the one carries the other.
    let place =
        move |t, grain| euler(r.rate * t - FRAC_PI_2, FRAC_PI_2, spin * t).to_space(grain + out);
    let grains = cylinder(r.mass, r.radius, 0.0);
    Swarm { grains, place, step: step(r.rate + spin) }
}

/// The runner of these parameters.
pub fn runner_of(p: &Parameters) -> Runner {
    Runner {
        mass: p.runner_mass,
        radius: p.runner_radius,
        shaft: p.runner_shaft,
        rate: p.runner_rate,
    }
}

/// The cylinder on its shaft as grains.
pub fn on_shaft(p: &Parameters) -> Swarm<impl Fn(f64, BodyVector) -> SpaceVector> {
    let (tilt, rate) = (p.tilt, p.rate);
    let place = move |t, grain| euler(rate * t, tilt, 0.0).to_space(grain);
    let grains = cylinder(p.mass, p.radius, p.height);
    Swarm { grains, place, step: step(rate) }
}

/// A square plate that turns about an edge, which is the Y axis; its corner is the origin.
pub fn plate(p: &Parameters) -> Swarm<impl Fn(f64, BodyVector) -> SpaceVector> {
    let half = BodyVector::new(0.5 * p.plate_side, 0.5 * p.plate_side, 0.0);
    let mut grains = cuboid(p.plate_mass, [p.plate_side, p.plate_side, 0.0]);
    for (_, place) in &mut grains {
        *place += half;
    }
    turning(grains, SpaceVector::new(0.0, p.plate_rate, 0.0), ORIGIN)
}

/// The numbers of the examples.
pub fn claims(p: &Parameters, report: &mut Report) -> Result<()> {
    round(p, report)?;
    earth(report)?;
    edge_runner(p, report)?;
    askew(p, report)
}

/// What turns about an axis that keeps its direction: the rolling wheel and the coin.
fn round(p: &Parameters, report: &mut Report) -> Result<()> {
    let (m, r) = (p.wheel_mass, p.wheel_radius);
    let (wheel, unit) = (rolling(p), m * r * r * p.wheel_rate);
    // Clockwise counts, as the wheel turns.
    let about = |x: f64, y: f64| -wheel.angular_momentum(SpaceVector::new(x, y, 0.0)).z();
    let coins = p.coin_mass * p.coin_radius * p.coin_radius * p.coin_rate;
    let rolled = coin(p).angular_momentum(ORIGIN).z();
    kit::claims! { report,
        /// rolling wheel: L about its centre
        wheel_centre: 0.5 * unit, "kg m^2/s", "sum of r x m v" => about(0.0, r), within 1e-12 * unit,
        in "A rolling wheel":
            unit => "that is a hoop";
        /// about a point of the floor ten radii behind
        wheel_floor: 1.5 * unit, "kg m^2/s", "sum of r x m v" => about(-10.0 * r, 0.0), within 1e-12 * unit,
        in "A rolling wheel":
            0.5 * unit => "add what the centre carries";
        /// about the point of contact
        wheel_contact: 1.5 * unit, "kg m^2/s", "sum of r x m v" => about(0.0, 0.0), within 1e-12 * unit;
        /// about the top of the rim
        wheel_top: -0.5 * unit, "kg m^2/s", "sum of r x m v" => about(0.0, 2.0 * r), within 1e-12 * unit,
        in "A rolling wheel":
            1.5 * unit => "that is I Omega; but this point moves",
            0.5 * unit => "look at the sign";
        /// coin on coin: L about the centre of the fixed one
        coin: 5.0 * coins, "kg m^2/s", "sum of r x m v" => rolled, within 1e-12 * coins,
        in "Coin on coin":
            4.5 * coins => "how often does the coin turn in an orbit?",
            6.0 * coins => "a disc, not a hoop";
    }
}

/// The Earth about the Sun.
fn earth(report: &mut Report) -> Result<()> {
    let (e, total) = (EARTH, Earth::SPIN + Earth::ORBIT);
    // The pole stands at 23.44 degrees; the printed third term does not point there.
    let astray = e.third() * chord(23.44_f64.to_radians());
    kit::claims! { report,
        /// the Earth about the Sun: its orbit
        earth_orbit: e.orbital(), "kg m^2/s", "a ball carried round" => e.carried(), within 1e-12 * e.orbital(),
        in "The Earth";
        /// its spin, as a uniform ball
        earth_spin: e.spin(), "kg m^2/s", "sum of r x m v" => e.swarm(Earth::SPIN), within 1e-12 * e.spin(),
        in "The Earth";
        /// the turn a year that is not seen from the Sun
        earth_third: e.third(), "kg m^2/s", "turn faster by that" => e.swarm(total) - e.spin(), within 1e-10 * e.third();
        /// error of the printed third term over the spin
        erratum_e18: astray / (e.spin() + e.third()), "-", "two rates" => chord(23.44_f64.to_radians()) / 366.25, within 1e-14;
    }
}

/// The wheel on a shaft.
fn edge_runner(p: &Parameters, report: &mut Report) -> Result<()> {
    let (r, swarm) = (runner_of(p), runner(runner_of(p)));
    let sizes = from_to(1e-3, 1e3).because("beyond it the grains lose their digits");
    sizes.check("runner_shaft/runner_radius", r.shaft / r.radius)?;
    let ([along, up], weight) = (r.momentum(), p.runner_mass * p.gravity);
    let n = r.force(p.gravity);
    let energy = r.energy();
    let momentum = swarm.angular_momentum(ORIGIN);
    let turning =
        from_to(1e-8, 1.0).because("slower, what the turning adds is lost beside the weight");
    turning.check("(N - M g)/N", (n - weight) / n)?;
    let double = (2.0 * p.gravity / r.radius).sqrt();
    // Weight and floor must have, about the hinge, the torque that turns L.
    let needed = weight - swarm.torque(0.0).y() / p.runner_shaft;
    // The faster it spins, the shorter is the step between two looks; the torque needs two steps.
    let rate = r.rate.abs();
    let turns = rate * (1.0 + r.shaft / r.radius);
    let bound = 4e-13 * turns / rate;
    let off = 1e-11 * n + 3e-12 * up.abs() * turns / r.shaft * (turns / rate);
    // What is added to the weight grows with the square of the rate.
    let added = needed - weight;
    kit::claims! { report,
        /// wheel on a shaft: L about the hinge, along the shaft outward
        runner_along: along, "kg m^2/s", "sum of r x m v" => momentum.x(), within bound * up,
        in "A wheel on a shaft":
            -along => "which way does it turn, seen from the hinge?",
            along / r.rate => "that has no 1/s";
        /// and along the vertical
        runner_up: up, "kg m^2/s", "sum of r x m v" => momentum.z(), within bound * up,
        in "A wheel on a shaft":
            r.mass * r.shaft * r.shaft * r.rate => "the wheel also turns about its own diameter",
            r.mass * (r.shaft * r.shaft + 0.5 * r.radius * r.radius) * r.rate => "about a diameter, not about the axle";
        /// force of the floor
        runner_force: n, "N", "dL/dt of the grains" => needed, within off,
        in "A wheel on a shaft":
            weight => "that is the weight only",
            2.0 * weight - n => "the torque has the other sign";
        /// angular velocity at which it is twice the weight
        runner_double: double, "rad/s", "the same, scaled" => rate * (weight / added).sqrt(),
        within double * (1e-12 + off / (n - weight));
        /// kinetic energy
        runner_energy: energy, "J", "sum of m v^2/2" => swarm.kinetic_energy(), within bound * energy,
        in "A wheel on a shaft";
    }
}

/// The cylinder and the plate.
fn askew(p: &Parameters, report: &mut Report) -> Result<()> {
    let (shaft, swarm) = (Shaft::of(p)?, on_shaft(p));
    let (momentum, unit) = (shaft.momentum(), (shaft.i1 + shaft.i3) * p.rate);
    let sum = swarm.angular_momentum(ORIGIN);
    let omega = SpaceVector::new(0.0, 0.0, p.rate);
    let on_body = shaft.attitude(0.0).to_body(sum);
    let torque = shaft.torque().x();
    let (m, a, w) = (p.plate_mass, p.plate_side, p.plate_rate);
    let (square, edge) = (m * a * a * w, plate(p).angular_momentum(ORIGIN));
    let (x, y) = (-square / 4.0, square / 3.0);
    let half = 0.5_f64.sqrt();
    kit::claims! { report,
        /// inclined cylinder: L along y
        cylinder_y: momentum.y(), "kg m^2/s", "sum of r x m v" => on_body.y(), within 1e-12 * unit,
        in "The inclined cylinder";
        /// along its own axis
        cylinder_z: momentum.z(), "kg m^2/s", "sum of r x m v" => on_body.z(), within 1e-12 * unit,
        in "The inclined cylinder";
        /// angle from Omega to L
        cylinder_angle: shaft.angle(), "rad", "sum of r x m v" => super::angle(sum, omega), within 1e-11,
        in "The inclined cylinder":
            FRAC_PI_2 - p.tilt => "that is for a needle";
        /// torque of the bearings along x
        cylinder_torque: torque, "N m", "dL/dt of the grains" => swarm.torque(0.0).x(), within 1e-11 * unit * p.rate,
        in "The inclined cylinder":
            -torque => "that is the torque on the bearings",
            0.0 => "L is as long as before, but it turns";
        /// square plate: L about its corner along x
        plate_x: x, "kg m^2/s", "sum of r x m v" => edge.x(), within 1e-12 * square,
        in "The square plate":
            -x => "a product of inertia has a minus",
            0.0 => "L is not along Omega";
        /// along y
        plate_y: y, "kg m^2/s", "sum of r x m v" => edge.y(), within 1e-12 * square,
        in "The square plate":
            square / 12.0 => "that is about the middle";
        /// the same along the diagonal x'
        plate_diagonal: square / 12.0 * half, "kg m^2/s", "turned by 45 degrees" => half * (edge.x() + edge.y()), within 1e-12 * square;
        /// and square to it, along y'
        plate_across: 7.0 * square / 12.0 * half, "kg m^2/s", "turned by 45 degrees" => half * (edge.y() - edge.x()), within 1e-12 * square;
    }
}
