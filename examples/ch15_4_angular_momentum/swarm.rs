//! The other route to every number of the page: a body as a swarm of grains. All that is
//! known of a grain is its mass and where it is at any time; its velocity comes from there.

use core::f64::consts::TAU;
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::math::{sin, sincos};

/// Mass (kg) and place on the axes of the body (m).
pub type Grain = (f64, BodyVector);

/// Gauss's three points for a mean over -1 to 1, with their weights: a part of mass and place.
const POINTS: [(f64, f64); 3] = [
    (-0.774_596_669_241_483_4, 5.0 / 18.0),
    (0.0, 8.0 / 18.0),
    (0.774_596_669_241_483_4, 5.0 / 18.0),
];
/// Grains on a circle.
const AROUND: u32 = 8;

/// A uniform cylinder about e3; a disc if it has no length.
pub fn cylinder(mass: f64, radius: f64, length: f64) -> Vec<Grain> {
    let mut grains = Vec::new();
    for (u, part) in POINTS {
        // Rings of equal mass are equally far apart in the square of the radius.
        let r = radius * (0.5 * (1.0 + u)).sqrt();
        for (z, share) in POINTS {
            for k in 0..AROUND {
                let (s, c) = sincos(TAU * f64::from(k) / f64::from(AROUND));
                let place = BodyVector::new(r * c, r * s, 0.5 * length * z);
                grains.push((mass * part * share / f64::from(AROUND), place));
            }
        }
    }
    grains
}

/// A uniform box about its centre; a plate if it has no thickness.
pub fn cuboid(mass: f64, [a, b, c]: [f64; 3]) -> Vec<Grain> {
    let mut grains = Vec::new();
    for (x, p) in POINTS {
        for (y, q) in POINTS {
            for (z, r) in POINTS {
                let place = BodyVector::new(0.5 * a * x, 0.5 * b * y, 0.5 * c * z);
                grains.push((mass * p * q * r, place));
            }
        }
    }
    grains
}

/// A uniform ball about its centre.
pub fn ball(mass: f64, radius: f64) -> Vec<Grain> {
    let mut grains = Vec::new();
    for (u, part) in POINTS {
        let r = 0.5 * (1.0 + u);
        for (z, share) in POINTS {
            let across = ((1.0 - z) * (1.0 + z)).sqrt();
            for k in 0..AROUND {
                let (s, c) = sincos(TAU * f64::from(k) / f64::from(AROUND));
                let place = BodyVector::new(across * c, across * s, z) * (radius * r);
                grains.push((mass * 3.0 * r * r * part * share / f64::from(AROUND), place));
            }
        }
    }
    grains
}

/// How fast a vector changes, by its values at eight times nearby, `step` apart.
pub fn rate(of: impl Fn(f64) -> SpaceVector, t: f64, step: f64) -> SpaceVector {
    let pairs = [0.8, -0.2, 4.0 / 105.0, -1.0 / 280.0].into_iter().zip(1..=4);
    let differences = pairs.map(|(weight, k)| {
        let away = f64::from(k) * step;
        (of(t + away) - of(t - away)) * (weight / step)
    });
    differences.fold(SpaceVector::zero(), |sum, term| sum + term)
}
/// Grains, and where each of them is at a time.
pub struct Swarm<F: Fn(f64, BodyVector) -> SpaceVector> {
    pub grains: Vec<Grain>,
    pub place: F,
    /// Between two looks, s.
    pub step: f64,
}

impl<F: Fn(f64, BodyVector) -> SpaceVector> Swarm<F> {
    /// Sum of (r - about) x m (v - carried): the reference point may be carried along.
    pub fn momentum_about(&self, t: f64, about: SpaceVector, carried: SpaceVector) -> SpaceVector {
        let mut sum = SpaceVector::zero();
        for &(mass, grain) in &self.grains {
            let place = |t| (self.place)(t, grain);
            let velocity = rate(place, t, self.step);
            sum += (place(t) - about).cross(&((velocity - carried) * mass));
        }
        sum
    }

    /// The same about a point at rest.
    pub fn angular_momentum(&self, about: SpaceVector) -> SpaceVector {
        self.momentum_about(0.0, about, SpaceVector::zero())
    }

    /// Sum of m v.
    pub fn linear_momentum(&self) -> SpaceVector {
        let velocities = self.velocities();
        velocities.fold(SpaceVector::zero(), |sum, (m, v)| sum + v * m)
    }

    /// Sum of m v^2/2, J.
    pub fn kinetic_energy(&self) -> f64 {
        self.velocities().map(|(m, v)| 0.5 * m * v.dot(&v)).sum()
    }

    /// dL/dt about the origin, N m.
    pub fn torque(&self, t: f64) -> SpaceVector {
        let (origin, rest) = (SpaceVector::zero(), SpaceVector::zero());
        rate(|t| self.momentum_about(t, origin, rest), t, self.step)
    }

    fn velocities(&self) -> impl Iterator<Item = (f64, SpaceVector)> {
        let velocity = move |grain| rate(move |t| (self.place)(t, grain), 0.0, self.step);
        self.grains.iter().map(move |&(mass, grain)| (mass, velocity(grain)))
    }
}

/// The angle between two vectors, without loss where it is small, rad.
pub fn angle(a: SpaceVector, b: SpaceVector) -> f64 {
    rotation_dynamics::math::atan2(a.cross(&b).norm(), a.dot(&b))
}

/// The time between two looks at something that turns so fast, s.
pub fn step(angular_velocity: f64) -> f64 {
    0.04 / angular_velocity.abs()
}

/// The chord of an angle on the unit circle.
pub fn chord(angle: f64) -> f64 {
    2.0 * sin(0.5 * angle)
}
