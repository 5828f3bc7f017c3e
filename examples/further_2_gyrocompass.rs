//! A further problem: the gyrocompass, a spinning wheel that the turning Earth points north.

#[path = "further_2_gyrocompass/figures.rs"]
mod figures;

use core::f64::consts::PI;
use kit::prelude::*;
use rotation_dynamics::exact::carlson;
use rotation_dynamics::integrators::{Dop853, LocatedEvent, Ode, Solution, Work, size_or};
use rotation_dynamics::integrators::{after, newton, ode, place_and_velocity, small_frequency};

/// Angular velocity of the Earth against the stars, rad/s.
const EARTH: f64 = 7.292_115e-5;
/// Mean radius of the Earth, m.
const RADIUS: f64 = 6.371e6;

parameters! {
    /// A compass with numbers that are typical of one on a ship.
    pub struct Parameters {
        /// moment of inertia of the wheel about its axle
        axial: number(0.012, "kg m^2", above(0.0).usually(0.005, 0.016)).drawn(0.008, 0.016, 0.001);
        /// the same across the axle, of all that turns with it
        transverse: number(0.008, "kg m^2", above(0.0).usually(0.006, 0.1));
        /// spin
        spin: number(1500.0, "rad/s", any().usually(300.0, 2500.0)).drawn(1000.0, 2000.0, 100.0);
        /// latitude, negative south of the equator
        latitude: number(0.9, "rad", from_to(-1.5, 1.5).because("at a pole the Earth turns about the vertical, and no direction is north; near it the compass is too slow").usually(0.0, 1.2)).drawn(0.3, 1.1, 0.1).open("latitude", "at the equator", "far north");
        /// pendulosity over the one of question 3
        tuning: number(1.0, "-", above(0.0).usually(0.3, 3.0));
        /// damping torque about the vertical over the torque of the bob
        offset: number(0.03, "rad", at_least(0.0).because("below 0 it feeds the swing").usually(0.01, 0.06)).drawn(0.02, 0.05, 0.01).open("damping torque over that of the bob", "swings long", "comes to rest soon");
        /// speed of the ship towards the north
        speed: number(10.0, "m/s", any().usually(-50.0, 50.0)).drawn(4.0, 14.0, 1.0);
        /// azimuth of the axle when it is let go
        release: number(0.5, "rad", between(-PI, PI).because("towards the south it is at rest, too, and stays").usually(0.05, 1.5)).open("azimuth at the release", "nearly north", "nearly east");
        gravity: gravity(above(0.0).usually(9.7, 9.9));
        /// error of a step of the simulations: from 1e-14 to 1e-6
        tolerance: number(1e-13, "-", from_to(1e-14, 1e-6));
    }
}

/// A wheel on an axle, on the turning Earth. Axes: east, north, up.
#[derive(Debug, Clone, Copy)]
pub struct Compass {
    /// moment of inertia across the axle, kg m^2
    pub transverse: f64,
    /// angular momentum along the axle, N m s
    pub momentum: f64,
    /// weight of the bob times its distance from the pivot, N m
    pub pendulosity: f64,
    /// angular velocity of the horizon: of the Earth, with that of a ship, rad/s
    pub horizon: SpaceVector,
    /// torque about the vertical over that of the bob
    pub offset: f64,
    /// torque that lowers the north end, whatever the tilt, N m
    pub rider: f64,
    /// viscous torque about the vertical over momentum and rate of azimuth
    pub pivot: f64,
}

/// Angular velocity of the horizon on a ship that goes north at so many m/s.
pub fn horizon(earth: f64, latitude: f64, speed: f64) -> SpaceVector {
    let (s, c) = sincos(latitude);
    SpaceVector::new(-speed / RADIUS, earth * c, earth * s)
}

const UP: SpaceVector = SpaceVector::new(0.0, 0.0, 1.0);

// ANCHOR: motions
impl Compass {
    /// The torque of the bob and of the rider; `up` is away from where the bob hangs to.
    fn torque(&self, axle: SpaceVector, up: SpaceVector) -> SpaceVector {
        let level = axle.cross(&up);
        level * (-(self.pendulosity * axle.dot(&up) + self.rider) / level.norm())
    }

    /// The axle alone, which goes where the torques send the angular momentum that lies
    /// along it; `push` is the acceleration of the ship towards the north over g.
    pub fn slow(self, ship: impl Fn(f64) -> (SpaceVector, f64)) -> impl Ode<3> {
        ode(move |t, &y: &[f64; 3]| {
            let (axle, (horizon, push)) = (SpaceVector::from_array(y), ship(t));
            let up = UP + SpaceVector::new(0.0, push, 0.0);
            let drift = self.torque(axle, up) / self.momentum - horizon.cross(&axle);
            // What acts about the vertical lowers or raises the axle.
            let [x, y, _] = y;
            let rate = (drift.x() * y - drift.y() * x) / (x * x + y * y);
            let raised = UP - axle * axle.z();
            let sinking = self.offset * self.pendulosity / self.momentum * axle.dot(&up);
            (drift + raised * ((self.pivot * rate - sinking) / raised.norm())).to_array()
        })
        .scaled(size_or([1.0; 3]))
    }

    /// The whole body, nutation and all: its axle and the part of its angular velocity
    /// across it; the angular momentum is L axle + I_t across.
    pub fn whole(self) -> impl Ode<6> {
        self.turning(move |axle, _, _| self.torque(axle, UP))
    }

    /// The same without a bob, the axle held level by a frame that is free to turn about
    /// the vertical: the torque of the frame keeps the axle from rising.
    pub fn held(self) -> impl Ode<6> {
        self.turning(move |axle, across, gained| {
            let turned = (across - self.horizon).cross(&axle);
            let rises = gained.cross(&axle) + (across - self.horizon).cross(&turned);
            axle.cross(&UP) * (-self.transverse * rises.z())
        })
    }

    fn turning(
        self,
        torque: impl Fn(SpaceVector, SpaceVector, SpaceVector) -> SpaceVector,
    ) -> impl Ode<6> {
        let rate = self.foucault_rate();
        ode(move |_, state: &[f64; 6]| {
            let [axle, across] = place_and_velocity(state);
            let turned = (across - self.horizon).cross(&axle);
            let gyroscopic = across.cross(&axle) * (-self.momentum / self.transverse);
            let gained = gyroscopic - self.horizon.cross(&across);
            let torque = torque(axle, across, gained);
            joined(turned, gained + torque / self.transverse)
        })
        .scaled(move |_| [1.0, 1.0, 1.0, rate, rate, rate])
    }
}
// ANCHOR_END: motions

fn joined(a: SpaceVector, b: SpaceVector) -> [f64; 6] {
    let ([a, b, c], [d, e, f]) = (a.to_array(), b.to_array());
    [a, b, c, d, e, f]
}

/// The axle at this azimuth, east of north, and tilt.
pub fn axle(azimuth: f64, tilt: f64) -> SpaceVector {
    let ((s, c), (up, level)) = (sincos(azimuth), sincos(tilt));
    SpaceVector::new(s * level, c * level, up)
}

/// Azimuth and tilt of the axle.
pub fn angles([x, y, z]: [f64; 3]) -> [f64; 2] {
    [atan2(x, y), atan2(z, hypot(x, y))]
}

impl Compass {
    /// With these moments and this pendulosity; without damping, rider and friction.
    pub fn bare([transverse, momentum, pendulosity]: [f64; 3], horizon: SpaceVector) -> Self {
        Self { transverse, momentum, pendulosity, horizon, offset: 0.0, rider: 0.0, pivot: 0.0 }
    }

    /// The compass of the problem, without damping, on a ship in port.
    fn of(p: &Parameters) -> Result<Self> {
        allowed! { "size of the spin": p.spin.abs(), above(0.0), "a wheel at rest does not feel the Earth turn"; }?;
        // The axle points along its angular momentum: spun the other way, its other end goes north.
        let (momentum, north) = (p.axial * p.spin.abs(), EARTH * cos(p.latitude));
        let pendulosity = p.tuning * momentum * p.gravity / (RADIUS * north);
        Ok(Self::bare([p.transverse, momentum, pendulosity], horizon(EARTH, p.latitude, 0.0)))
    }

    /// The same, if the laws of the page hold for it.
    pub fn new(p: &Parameters) -> Result<Self> {
        let compass = Self::of(p)?;
        let momentum = compass.momentum;
        let nods = momentum / (p.transverse * compass.foucault_rate());
        let stiff = compass.pendulosity * p.transverse / (momentum * momentum);
        allowed! {
            "moment across the axle over that about it": p.transverse / p.axial, from_to(0.5, 1e3), "no body has less; of one with more the nodding is slow";
            "(Foucault's period over the compass's)^2": stiff, from_to(0.0, 1e-3), "beyond it the moment across the axle counts: spin faster, or take a lighter bob";
            "nodding of the wheel over Foucault's swing": nods, from_to(0.0, 6e4), "its rounding drowns the swing";
            "tilt at rest": compass.rest()[1], from_to(-0.3, 0.3), "a weaker bob does not hold the axle near the horizon";
            "offset times tan(latitude)": p.offset * tan(p.latitude), from_to(-0.9, 0.9), "from 1 on the damper is too strong for the Earth, and the axle does not rest";
        }?;
        Ok(compass)
    }

    /// Foucault's compass, let go at that azimuth, until it is back there.
    fn turned(&self, release: f64, step: f64) -> Result<(LocatedEvent<6>, Work)> {
        let start = self.start([release, 0.0], 0.0);
        let end = 9.0 * self.foucault_period(release)?;
        Ok(Dop853::new(step)?.zero(&self.held(), start, 2, end, move |y| y[5] - start[5])?)
    }

    /// The axle alone of a compass in port.
    pub fn port(self) -> impl Ode<3> {
        self.slow(move |_| (self.horizon, 0.0))
    }

    fn north(&self) -> f64 {
        self.horizon.y()
    }

    /// Angular frequency of Foucault's compass, small swings.
    pub fn foucault_rate(&self) -> f64 {
        let north = self.north();
        (north * (self.momentum / self.transverse - north)).sqrt()
    }

    /// Period of Foucault's compass from rest at `azimuth`.
    pub fn foucault_period(&self, azimuth: f64) -> rotation_dynamics::Result<f64> {
        let rate = (self.north() * self.momentum / self.transverse).sqrt();
        let small = self.transverse * self.north() / self.momentum;
        let h = sin(0.5 * azimuth) * sin(0.5 * azimuth);
        let less = 1.0 - small * (1.0 - h);
        Ok(4.0 / (rate * less.sqrt()) * carlson::rf(0.0, 1.0 - h, 1.0 + small * h / less)?)
    }

    /// Where the axle rests: azimuth and tilt.
    pub fn rest(&self) -> [f64; 2] {
        let (rate, north) = (self.pendulosity / self.momentum, self.north());
        let up = self.horizon.z() - self.rider / self.momentum;
        let mut at = [0.0; 2];
        for _ in 0..100 {
            let tilt = atan2(up, north * cos(at[0]) + rate);
            at = [asin(self.offset * rate * sin(tilt) / north), tilt];
        }
        at
    }

    /// Minus half the trace, and the determinant, of the linear motion about rest.
    pub fn linear(&self) -> [f64; 2] {
        let (rate, north) = (self.pendulosity / self.momentum, self.north());
        let [(s, c), (raised, level)] = self.rest().map(sincos);
        let damping = self.offset * rate * level;
        let across = (north * c + rate) / (level * level);
        let along = north * s * raised / level;
        [0.5 * (damping - along), north * c * across - along * damping]
    }

    /// The slow swing of the whole body about a level rest: its angular frequency, and its
    /// tilt over its rate of azimuth.
    pub fn both(&self) -> [f64; 2] {
        let (i, l, north) = (self.transverse, self.momentum, self.north());
        let up = self.horizon.z();
        let a = north * (l - i * north);
        let b = self.pendulosity + l * north - i * (north * north - up * up);
        let l = l - 2.0 * i * north;
        let sum = i * (a + b) + l * l;
        let square = 2.0 * a * b / (sum + (sum * sum - 4.0 * i * i * a * b).sqrt());
        [square.sqrt(), -l / (b - i * square)]
    }

    /// The whole body with its axle there, its azimuth changing at this rate, its tilt at rest.
    pub fn start(&self, [azimuth, tilt]: [f64; 2], rate: f64) -> [f64; 6] {
        let axle = axle(azimuth, tilt);
        let moved = axle.cross(&UP) * rate + self.horizon.cross(&axle);
        joined(axle, axle.cross(&moved))
    }

    /// The axle from this azimuth and tilt on, in port.
    pub fn run(self, [azimuth, tilt]: [f64; 2], end: f64, step: f64) -> Result<Solution<3>> {
        let start = axle(azimuth, tilt).to_array();
        Ok(Dop853::new(step)?.solve(&self.port(), 0.0, &start, end, &[])?)
    }

    /// Where it comes to rest: viscous friction of the vertical pivot, as much as makes the
    /// swing die fastest, does not act on what rests.
    pub fn settled(self, step: f64) -> Result<[f64; 2]> {
        let ([decay, stiff], mut slowest) = (self.linear(), self.linear()[1].sqrt());
        let most = 2.0 * slowest * self.momentum / self.pendulosity;
        if decay > slowest {
            slowest = stiff / (decay + (decay * decay - stiff).sqrt());
        }
        let pivot = (most - self.offset).max(0.0);
        let run = Self { pivot, ..self }.run([0.01, 0.0], 60.0 / slowest, step)?;
        Ok(angles(*run.end_state()))
    }
}

/// The ship speeds up to `speed` within `within` seconds: horizon and push, for [`Compass::slow`].
fn ship(p: &Parameters, speed: f64, within: f64) -> impl Fn(f64) -> (SpaceVector, f64) + Copy {
    let (latitude, g) = (p.latitude, p.gravity);
    move |t| {
        let x = (t / within).min(1.0);
        let push = 6.0 * x * (1.0 - x) * speed / (within * g);
        (horizon(EARTH, latitude, speed * x * x * (3.0 - 2.0 * x)), push)
    }
}

/// The zero of a nearly straight function, by secants.
fn secant(mut a: f64, mut b: f64, f: impl Fn(f64) -> Result<f64>) -> Result<f64> {
    let (mut at_a, mut at_b) = (f(a)?, f(b)?);
    for _ in 0..6 {
        if at_b == at_a {
            break;
        }
        (a, b) = (b, b - at_b * (b - a) / (at_b - at_a));
        (at_a, at_b) = (at_b, f(b)?);
    }
    Ok(b)
}

/// The pendulosity with which a ship that speeds up does not set the compass swinging.
pub fn quiet(p: &Parameters) -> Result<f64> {
    let (compass, speed) = (Compass::new(p)?, 0.01);
    let own = compass.pendulosity / p.tuning;
    secant(0.7 * own, 1.2 * own, |k| {
        let tried = compass.but(|compass| compass.pendulosity = k);
        let start = axle(0.0, tried.rest()[1]).to_array();
        let end = after(900.0, &tried.slow(ship(p, speed, 900.0)), &start, 1e-14)?;
        let there = atan2(-speed / RADIUS, compass.north());
        Ok((angles(end)[0] - there) / there)
    })
}

/// Where this is zero for the n-th time, after the axle is let go in port at this azimuth and tilt.
fn crossing(
    c: Compass,
    [azimuth, tilt]: [f64; 2],
    n: u32,
    of: impl Fn(&[f64; 3]) -> f64,
) -> Result<LocatedEvent<3>> {
    let start = axle(azimuth, tilt).to_array();
    Ok(Dop853::new(1e-14)?.zero(&c.port(), start, n, 1e8, of)?.0)
}

/// Half a period of a small damped swing, and by which factor it shrinks in that time.
pub fn shrinking(c: Compass) -> Result<[f64; 2]> {
    let (rest, mut half, mut factor) = (c.rest(), 0.0, 1.0);
    for size in [1e-4, -1e-4] {
        let zero = |n| crossing(c, [rest[0] + size, rest[1]], n, |y| angles(*y)[0] - rest[0]);
        let [first, second] = [zero(1)?, zero(2)?];
        half += 0.5 * (second.t - first.t);
        let tilt = |event: &LocatedEvent<3>| angles(event.state)[1] - rest[1];
        factor *= (-tilt(&second) / tilt(&first)).sqrt();
    }
    Ok([half, factor])
}

/// Tilt over azimuth of a small swing: what it has of each at its widest.
fn flatness(c: Compass) -> Result<f64> {
    let (size, [_, rest]) = (1e-4, c.rest());
    let north = |n| crossing(c, [size, rest], n, |y| y[0]);
    let [there, back] = [north(1)?, north(2)?].map(|event| angles(event.state)[1]);
    Ok(0.5 * (there - back) / size)
}

/// Angular frequency of the smallest swings of the axle alone, simulated.
pub fn measured(c: Compass) -> rotation_dynamics::Result<f64> {
    let flat = c.north() / c.linear()[1].sqrt();
    let start = |size| axle(0.0, c.rest()[1] + flat * size).to_array();
    small_frequency(&c.port(), start, 1e8, |y| y[0])
}

/// The same of the whole body.
pub fn measured_whole(c: Compass) -> rotation_dynamics::Result<f64> {
    let [rate, tilt] = c.both();
    let start = |size| c.start([0.0, c.rest()[1] + size * rate * tilt], size * rate);
    small_frequency(&c.whole(), start, 20.0 / rate, |y| y[0])
}

/// The same in a frame that holds it level.
pub fn measured_held(c: Compass) -> rotation_dynamics::Result<f64> {
    let rate = c.foucault_rate();
    let start = |size| c.start([0.0; 2], size * rate);
    small_frequency(&c.held(), start, 20.0 / rate, |y| y[0])
}

fn claims(p: &Parameters, report: &mut Report) -> Result<()> {
    allowed! { "size of the release": p.release.abs(), from_to(1e-4, 3.13), "let go nearer to north or south it hardly moves"; }?;
    let c = Compass::new(p)?;
    let (l, north, up) = (c.momentum, c.north(), c.horizon.z());
    let damped = c.but(|c| c.offset = p.offset);
    let (small, wide) = (2.0 * PI / c.foucault_rate(), c.foucault_period(p.release)?);
    let (tilt, rate) = (c.rest()[1], c.linear()[1].sqrt());
    // An error across the axle comes back so much larger about the vertical.
    let noise = 3e-12 * l / (c.transverse * c.foucault_rate());
    let flat = north / rate;
    let tuned = l * p.gravity / (RADIUS * north);
    let [decay, stiff] = damped.linear();
    let swings = stiff > decay * decay;
    let beat = (stiff - decay * decay).max(0.0).sqrt();
    let [half, factor] = if swings { shrinking(damped)? } else { [0.0; 2] };
    let error = damped.rest()[0];
    // What is not damped does not settle.
    let damps = swings && decay > 1e-3 * rate;
    let settles = |rider: f64| -> Result<f64> {
        let run = Compass { rider, ..damped }.run([0.0; 2], 200.0 / decay.min(rate), 1e-14)?;
        Ok(run.end_state()[0])
    };
    let off = -atan2(p.speed / RADIUS, north);
    let sailing = c.but(|c| c.horizon = horizon(EARTH, p.latitude, p.speed));
    let falls = newton(|_, [r, _]| r * (-p.gravity / RADIUS * r.norm().powi(-3)));
    let thrown = [1.0, 0.0, 0.0, 0.0, (p.gravity / RADIUS).sqrt(), 0.0];
    let stone = falls.scaled(size_or([1.0; 6]));
    let (round, _) = Dop853::new(1e-14)?.zero(&stone, thrown, 2, 1e7, |y| y[1])?;
    let schuler = 2.0 * PI * (RADIUS / p.gravity).sqrt() / 60.0;
    let bound = 100.0 * p.tolerance;
    claims! { report,
        /// Foucault: small swings
        foucault: small, "s", "whole body" => 2.0 * PI / measured_held(c)?, within noise * small, in "Foucault's compass: period":
            small * cos(p.latitude).sqrt() => "that is at the equator; only a part of the Earth's rotation counts",
            small / (2.0 * PI) => "look at the factor 2 pi",
            small * (p.axial / p.transverse).sqrt() => "two different moments of inertia occur";
        /// Foucault: from the release
        wide: wide, "s", "located event" => c.turned(p.release, p.tolerance)?.0.t,
        within (noise + 10.0 * bound) * wide / pow(cos(0.5 * p.release), 4.0), in "Foucault's compass: period":
            small => "that is for small swings";
        /// tilt at rest
        tilt: tilt, "rad", "where it settles" => c.settled(p.tolerance)?[1], within 1e-11 + bound, in "The pendulous compass";
        /// period of small swings
        period: 2.0 * PI / rate, "s", "simulated" => 2.0 * PI / measured(c)?, within 1e-8 / rate, in "The pendulous compass";
        /// tilt over azimuth of a swing
        flatness: flat, "-", "simulated" => flatness(c)?, within 1e-6 * flat, in "The pendulous compass":
            1.0 / flat => "turn it over";
        /// a stone that circles the Earth at the ground
        schuler: schuler, "min", "simulated" => round.t / 60.0, within 1e-10 * schuler;
        /// pendulosity that is not disturbed
        tuned: tuned, "N m", "ships that speed up" => quiet(p)?, within 1e-5 * tuned, in "The pendulous compass":
            tuned * cos(p.latitude) => "only the part of the Earth's rotation that lies in the horizon counts";
        /// half a period, damped
        half: PI / beat, "s", "located events" => half, within 1e-6 / beat, if swings;
        /// part of the swing left after it
        left: exp(-PI * decay / beat), "-", "located events" => factor, within 1e-6, if swings, in "Damped";
        /// azimuth at rest, damped
        latitude_error: error, "rad", "where it settles" => damped.settled(p.tolerance)?[0], within 1e-9 + bound, in "Damped":
            -error => "the other side",
            p.offset => "that is the ratio of the torques; at the equator the azimuth is zero";
        /// torque of a rider that takes this away
        rider: l * up, "N m", "settles north" => secant(0.9 * l * up, 1.1 * l * up, settles)?, within 1e-9 * l * EARTH, if damps && p.latitude.abs() > 1e-3,
        in "Damped":
            l * north => "the tilt at rest comes from the vertical part of the Earth's rotation";
        /// azimuth at rest on the ship
        speed_error: off, "rad", "where it settles" => sailing.settled(p.tolerance)?[0], within 1e-9 + bound, in "The ship":
            -off => "the other side",
            -p.speed / (RADIUS * EARTH) => "that is at the equator";
    }
}

/// Foucault's compass and the ship's are the ends of one instrument.
fn limits(p: &Parameters, report: &mut Report) -> Result<()> {
    let c = Compass::new(p)?;
    let soft = c.but(|c| c.pendulosity = 1e-9 * c.momentum);
    let stiff = c.but(|c| c.pendulosity = 1e9 * c.momentum * c.momentum / c.transverse);
    let thin = Compass { transverse: 1e-6 * c.transverse, horizon: horizon(EARTH, 0.0, 0.0), ..c };
    let at = |latitude| Compass::of(&p.but(|p| (p.latitude, p.offset) = (latitude, 0.0)));
    let [near, level] = [at(1.5)?, at(0.0)?];
    let ratio = near.foucault_rate() / cos(1.5).sqrt() / level.foucault_rate();
    limits! { report,
        /// the frame holds the axle level
        "stiff bob: omega/omega_F": stiff.both()[0] / c.foucault_rate() => 1.0, within 1e-8;
        /// no moment across the axle: it follows the torque at once
        "I_t = 0: omega/omega_0": thin.both()[0] / thin.linear()[1].sqrt() => 1.0, within 1e-4;
        /// a free axle points to a star, and goes round once in a day
        "no bob: omega_0/Omega": soft.linear()[1].sqrt() / EARTH => 1.0, within 1e-3;
        /// only the part of the rotation in the horizon counts
        "near the pole: omega_F/sqrt(cos)": ratio => 1.0, within 1e-6;
        /// the horizon does not turn
        "equator: tilt at rest": level.rest()[1] => 0.0, within 1e-15;
    }
}

/// The card of effects, with dry friction of 1e-6 N m in the vertical bearing.
fn effects(p: &Parameters, report: &mut Report) -> Result<()> {
    let c = Compass::new(p)?;
    let (north, rate) = (c.north(), c.linear()[1].sqrt());
    let (grip, ratio) = (1e-6 / (c.momentum * north), rate / c.foucault_rate());
    let (way, sail) = (p.speed / RADIUS * 2.0 * PI / rate, p.speed / (RADIUS * north));
    let [way, sail] = [way, sail].map(f64::abs);
    let (wide, flattening) = (p.release * p.release / 16.0, 1.0 / 298.257);
    let swing = |release| Ok::<_, kit::Error>(c.turned(release, 1e-12)?.0.t);
    let longer = swing(p.release)? / swing(0.01 * p.release)? - 1.0;
    effect_card! { report,
        "dry friction about the vertical": "M_f/(L Omega cos)" = grip, costs grip, "rad of azimuth";
        "width of the swing": "alpha^2/16" = wide, costs wide, "of the period", measured longer, within 1e-7, included;
        "moment across the axle": "(omega_0/omega_F)^2" = ratio * ratio, costs 0.5 * ratio * ratio, "of the period";
        "latitude sailed in a period": "v T/R" = way, costs way * sail * tan(p.latitude).abs(),
            "rad of azimuth";
        "the same speed towards the east": "v/(R Omega cos)" = sail, costs 0.5 * sail, "of the period";
        "flattening of the Earth": "f" = flattening, costs 0.5 * flattening, "of 84 minutes";
    }
}

/// The accuracy strip: Foucault's compass, let go, until it is back.
fn accuracy(p: &Parameters, report: &mut Report) -> Result<()> {
    let (compass, release) = (Compass::new(p)?, p.release);
    let period = compass.foucault_period(release)?;
    let asked = [p.tolerance, 1e-6, 1e-8, 1e-10, 1e-12];
    report.set_closed_form(ClosedForm::new(move |_| compass.foucault_period(release)));
    report.dial_of_return(asked, move |step| compass.turned(release, step), period, sin(release))
}

example! {
    further_2_gyrocompass: "A further problem: the gyrocompass, which the turning Earth points north";
    "The gyrocompass", "A spinning wheel on a level or pendulous axle, on the turning Earth.",
    [claims, limits, effects, accuracy];
    figures::figures, figures::trajectory, figures::moving_picture
}
