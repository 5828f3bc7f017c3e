//! Bodies of a few masses, other routes to their energy and velocity, other axes.

use super::{FOUR, Mass, Rigid, velocity};
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::frame::{BodyVector, DesignVector};
use rotation_dynamics::math::sincos;
use rotation_dynamics::{Error, Result};

/// [`FOUR`] with places as vectors.
pub fn four() -> Vec<Mass> {
    FOUR.map(|(m, r)| (m, r.into())).into()
}

impl Rigid {
    /// The same motion, told by another point of the body.
    pub fn seen_from(&self, point: DesignVector) -> Self {
        Self { point, velocity: velocity(self, point), ..*self }
    }
}

/// The kinetic energy, by the speed of each mass.
pub fn kinetic_energy(masses: &[Mass], motion: &Rigid) -> f64 {
    let energy = |(m, r): &Mass| {
        let v = velocity(motion, *r);
        0.5 * m * v.dot(&v)
    };
    masses.iter().map(energy).sum()
}

/// The kinetic energy of a rotation about the origin.
pub fn turning_energy(masses: &[Mass], angular_velocity: DesignVector) -> f64 {
    let (point, velocity) = (DesignVector::zero(), DesignVector::zero());
    kinetic_energy(masses, &Rigid { point, velocity, angular_velocity })
}

/// The velocity at `place`, from where the point is a little before and after: the body is
/// really moved and turned. Three difference quotients, extrapolated.
pub fn displaced(motion: &Rigid, place: DesignVector) -> Result<DesignVector> {
    let omega = motion.angular_velocity.to_array();
    let from = (place - motion.point).to_array();
    let after = |t: f64| -> Result<DesignVector> {
        let turn = Attitude::from_rotation_vector(omega.map(|w| w * t).into())?;
        let turned = turn.to_space(from.into()).to_array();
        Ok(motion.velocity * t + DesignVector::from(turned))
    };
    let quotient = |dt: f64| Ok::<_, Error>((after(dt)? - after(-dt)?) / (2.0 * dt));
    let dt = 0.05 / (1.0 + motion.angular_velocity.norm());
    let [a, b, c] = [quotient(dt)?, quotient(0.5 * dt)?, quotient(0.25 * dt)?];
    let (first, second) = ((b * 4.0 - a) / 3.0, (c * 4.0 - b) / 3.0);
    Ok((second * 16.0 - first) / 15.0)
}

/// The centre of mass.
pub fn centre_of_mass(masses: &[Mass]) -> DesignVector {
    let (mut mass, mut sum) = (0.0, DesignVector::zero());
    for (m, r) in masses {
        mass += m;
        sum += *r * *m;
    }
    sum / mass
}

/// A matrix times a vector.
pub fn on_vector(t: &[[f64; 3]; 3], v: DesignVector) -> DesignVector {
    t.map(|row| row[0] * v[0] + row[1] * v[1] + row[2] * v[2]).into()
}

/// The tensor on other axes by the tensor law, Q I Q^T: `axes` carries components on the new
/// axes to those on the old, so Q is its transpose.
pub fn on_axes(t: &[[f64; 3]; 3], axes: &Attitude) -> [[f64; 3]; 3] {
    let r = axes.matrix();
    let element = |i: usize, j: usize| {
        let along = |k: usize| (0..3).map(|l| t[k][l] * r[l][j]).sum::<f64>();
        (0..3).map(|k| r[k][i] * along(k)).sum()
    };
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| element(i, j)))
}

/// The same masses with their places on other axes, which `axes` carries to the old ones.
pub fn turned_masses(masses: &[Mass], axes: &Attitude) -> Vec<Mass> {
    let turned = |r: &DesignVector| -> BodyVector { axes.to_body(r.to_array().into()) };
    masses.iter().map(|(m, r)| (*m, turned(r).to_array().into())).collect()
}

/// Four points that have all moments of a plate with these edges, its centre at `centre`.
pub fn plate_points(mass: f64, edges: [f64; 2], centre: [f64; 2]) -> Vec<Mass> {
    let off = 1.0 / 12.0_f64.sqrt();
    let point = |(x, y): (f64, f64)| {
        let place = [centre[0] + x * off * edges[0], centre[1] + y * off * edges[1], 0.0];
        (0.25 * mass, place.into())
    };
    [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(point).into()
}

/// A wheel of mass 1 and radius 1 as two rings, upright, its axle along z: a uniform disc.
pub fn wheel() -> Vec<Mass> {
    let ring = |radius: f64, mass: f64| {
        (0..12).map(move |i| {
            let (s, c) = sincos(core::f64::consts::TAU * f64::from(i) / 12.0);
            (mass / 12.0, DesignVector::new(radius * c, radius * s, 0.0))
        })
    };
    // Half of the mass at sqrt(1/2 - d) and half at sqrt(1/2 + d): the mean square is a disc's.
    ring(0.25_f64.sqrt(), 0.5).chain(ring(0.75_f64.sqrt(), 0.5)).collect()
}

/// It rolls along x with the speed 1, and so turns clockwise.
pub fn rolling() -> Rigid {
    Rigid {
        point: DesignVector::zero(),
        velocity: DesignVector::new(1.0, 0.0, 0.0),
        angular_velocity: DesignVector::new(0.0, 0.0, -1.0),
    }
}

/// Points of the wheel, over its radius.
pub const WHEEL_POINTS: [(&str, [f64; 3]); 5] = [
    ("centre", [0.0, 0.0, 0.0]),
    ("contact", [0.0, -1.0, 0.0]),
    ("on the small circle", [0.5, -0.5, 0.0]),
    ("front of the rim", [1.0, 0.0, 0.0]),
    ("top", [0.0, 1.0, 0.0]),
];
