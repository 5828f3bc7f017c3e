//! The other route to every number of the page: a body as a swarm of grains. All that is
//! known of a grain is its mass and where it is at any time; its velocity comes from there.

use core::f64::consts::TAU;
use kit::prelude::*;
use rotation_dynamics::attitude::Attitude;

pub const ORIGIN: SpaceVector = SpaceVector::zero();

/// Mass (kg) and place on the axes of the body (m).
pub type Grain = (f64, BodyVector);

/// Gauss's three points for a mean over -1 to 1, with their weights: a part of mass and place.
const POINTS: [(f64, f64); 3] = [
    (-0.774_596_669_241_483_4, 5.0 / 18.0),
    (0.0, 8.0 / 18.0),
    (0.774_596_669_241_483_4, 5.0 / 18.0),
];

/// Eight grains on a circle about e3.
fn ring(mass: f64, radius: f64, height: f64) -> impl Iterator<Item = Grain> {
    (0..8).map(move |k| {
        let (s, c) = sincos(TAU * f64::from(k) / 8.0);
        (mass / 8.0, BodyVector::new(radius * c, radius * s, height))
    })
}

/// All pairs of these points.
fn pairs() -> impl Iterator<Item = [(f64, f64); 2]> {
    POINTS.into_iter().flat_map(|a| POINTS.map(|b| [a, b]))
}

/// A uniform cylinder about e3; a disc if it has no length.
pub fn cylinder(mass: f64, radius: f64, length: f64) -> Vec<Grain> {
    let rings = pairs().flat_map(|[(u, part), (z, share)]| {
        // Rings of equal mass are equally far apart in the square of the radius.
        let r = radius * (0.5 * (1.0 + u)).sqrt();
        ring(mass * part * share, r, 0.5 * length * z)
    });
    rings.collect()
}

/// A uniform ball about its centre.
pub fn ball(mass: f64, radius: f64) -> Vec<Grain> {
    let rings = pairs().flat_map(|[(u, part), (z, share)]| {
        let r = 0.5 * (1.0 + u);
        let unit = ring(mass * 3.0 * r * r * part * share, ((1.0 - z) * (1.0 + z)).sqrt(), z);
        unit.map(move |(mass, place)| (mass, place * (radius * r)))
    });
    rings.collect()
}

/// A uniform box; a plate if it has no thickness.
pub fn cuboid(mass: f64, [a, b, c]: [f64; 3], centre: BodyVector) -> Vec<Grain> {
    let rows = pairs().flat_map(|[(x, p), (y, q)]| {
        let place = move |z: f64| BodyVector::new(0.5 * a * x, 0.5 * b * y, 0.5 * c * z) + centre;
        POINTS.map(|(z, r)| (mass * p * q * r, place(z)))
    });
    rows.collect()
}

/// Six particles on the axes, two of 1/2 kg on each, with these principal moments.
pub fn on_axes([a, b, c]: [f64; 3]) -> Vec<Grain> {
    let [x, y, z] = [b + c - a, c + a - b, a + b - c].map(|sum| (0.5 * sum).sqrt());
    let far = [[x, 0.0, 0.0], [0.0, y, 0.0], [0.0, 0.0, z]].map(BodyVector::from_array);
    far.into_iter().flat_map(|far| [(0.5, -far), (0.5, far)]).collect()
}

/// How fast a vector changes, by its values at eight times nearby, `step` apart.
pub fn rate(of: impl Fn(f64) -> SpaceVector, t: f64, step: f64) -> SpaceVector {
    let pairs = [0.8, -0.2, 4.0 / 105.0, -1.0 / 280.0].into_iter().zip(1..=4);
    let differences = pairs.map(|(weight, k)| {
        let away = f64::from(k) * step;
        (of(t + away) - of(t - away)) * (weight / step)
    });
    differences.sum()
}

/// The time between two looks at something that turns so fast, s.
pub fn step(angular_velocity: f64) -> f64 {
    0.04 / angular_velocity.abs()
}

/// Grains, and where each of them is at a time.
pub struct Swarm {
    pub grains: Vec<Grain>,
    pub place: Box<dyn Fn(f64, BodyVector) -> SpaceVector>,
    /// Between two looks, s.
    pub step: f64,
}

impl Swarm {
    /// Grains that turn at most this fast (rad/s), and their places.
    pub fn new(
        grains: Vec<Grain>,
        angular_velocity: f64,
        place: impl Fn(f64, BodyVector) -> SpaceVector + 'static,
    ) -> Self {
        Self { grains, place: Box::new(place), step: step(angular_velocity) }
    }

    /// A body that turns about its origin at this rate, the origin moving at this velocity.
    pub fn turning(grains: Vec<Grain>, omega: SpaceVector, velocity: SpaceVector) -> Self {
        Self::new(grains, omega.norm(), move |t, grain| {
            let turned = Attitude::from_rotation_vector(omega * t).unwrap_or(Attitude::IDENTITY);
            velocity * t + turned.to_space(grain)
        })
    }

    fn velocity(&self, t: f64, grain: BodyVector) -> SpaceVector {
        rate(|t| (self.place)(t, grain), t, self.step)
    }

    /// Sum of (r - about) x m (v - carried): the reference point may be carried along.
    pub fn momentum_about(&self, t: f64, about: SpaceVector, carried: SpaceVector) -> SpaceVector {
        let moment = |&(mass, grain): &Grain| {
            let velocity = self.velocity(t, grain) - carried;
            ((self.place)(t, grain) - about).cross(&(velocity * mass))
        };
        self.grains.iter().map(moment).sum()
    }

    /// The same about a point at rest.
    pub fn angular_momentum(&self, about: SpaceVector) -> SpaceVector {
        self.momentum_about(0.0, about, SpaceVector::zero())
    }

    /// Sum of m v.
    pub fn linear_momentum(&self) -> SpaceVector {
        self.grains.iter().map(|&(mass, grain)| self.velocity(0.0, grain) * mass).sum()
    }

    /// Sum of m v^2/2, J.
    pub fn kinetic_energy(&self) -> f64 {
        let square = |v: SpaceVector| v.dot(&v);
        self.grains.iter().map(|&(m, grain)| 0.5 * m * square(self.velocity(0.0, grain))).sum()
    }

    /// dL/dt about the origin, N m.
    pub fn torque(&self) -> SpaceVector {
        rate(|t| self.momentum_about(t, ORIGIN, SpaceVector::zero()), 0.0, self.step)
    }
}

/// The angle between two vectors, without loss where it is small, rad.
pub fn angle(a: SpaceVector, b: SpaceVector) -> f64 {
    atan2(a.cross(&b).norm(), a.dot(&b))
}
