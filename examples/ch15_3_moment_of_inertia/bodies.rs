//! Bodies of a few masses, other routes to their energy and velocity, other axes.

use super::{Mass, Rigid, velocity};
use core::array::from_fn;
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::frame::{BodyVector, DesignVector};
use rotation_dynamics::{Error, Result};

impl Rigid {
    /// The same motion, told by another point of the body.
    pub fn seen_from(&self, point: DesignVector) -> Self {
        Self { point, velocity: velocity(self, point), ..*self }
    }
}

/// A rotation about the origin, which is at rest.
pub fn about_origin(angular_velocity: DesignVector) -> Rigid {
    Rigid { point: DesignVector::zero(), velocity: DesignVector::zero(), angular_velocity }
}

/// The kinetic energy, by the speed of each mass.
pub fn kinetic_energy(masses: &[Mass], motion: &Rigid) -> f64 {
    let energy = |(m, r): &Mass| {
        let v = velocity(motion, *r);
        0.5 * m * v.dot(&v)
    };
    masses.iter().map(energy).sum()
}

/// The velocity at `place`, from where the point is a little before and after: the body is
/// really moved and turned. Three difference quotients, extrapolated.
pub fn displaced(motion: &Rigid, place: DesignVector) -> Result<DesignVector> {
    let omega = motion.angular_velocity.to_array();
    let from: BodyVector = (place - motion.point).to_array().into();
    let after = |t: f64| -> Result<DesignVector> {
        let turn = Attitude::from_rotation_vector(omega.map(|w| w * t).into())?;
        Ok(motion.velocity * t + turn.to_space(from).to_array().into())
    };
    let quotient = |dt: f64| Ok::<_, Error>((after(dt)? - after(-dt)?) / (2.0 * dt));
    let dt = 0.05 / (1.0 + motion.angular_velocity.norm());
    let [a, b, c] = [quotient(dt)?, quotient(0.5 * dt)?, quotient(0.25 * dt)?];
    let (first, second) = ((b * 4.0 - a) / 3.0, (c * 4.0 - b) / 3.0);
    Ok((second * 16.0 - first) / 15.0)
}

/// The whole mass.
pub fn whole(masses: &[Mass]) -> f64 {
    masses.iter().map(|(m, _)| m).sum()
}

pub fn centre_of_mass(masses: &[Mass]) -> DesignVector {
    masses.iter().map(|(m, r)| *r * *m).sum::<DesignVector>() / whole(masses)
}

/// The tensor on other axes by the tensor law, Q I Q^T: `axes` carries components on the new
/// axes to those on the old, so Q is its transpose.
pub fn on_axes(t: &[[f64; 3]; 3], axes: &Attitude) -> [[f64; 3]; 3] {
    let r = axes.matrix();
    let along = |k: usize, j: usize| (0..3).map(|l| t[k][l] * r[l][j]).sum::<f64>();
    from_fn(|i| from_fn(|j| (0..3).map(|k| r[k][i] * along(k, j)).sum()))
}

/// The same masses with their places on other axes, which `axes` carries to the old ones.
pub fn turned_masses(masses: &[Mass], axes: &Attitude) -> Vec<Mass> {
    let turned = |r: &DesignVector| axes.to_body(r.to_array().into()).to_array().into();
    masses.iter().map(|(m, r)| (*m, turned(r))).collect()
}

/// Four points that have all moments of a plate with these edges, its centre at `centre`.
pub fn plate_points(mass: f64, edges: [f64; 2], centre: [f64; 2]) -> [Mass; 4] {
    let off = 1.0 / 12.0_f64.sqrt();
    [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(x, y)| {
        let place = [centre[0] + x * off * edges[0], centre[1] + y * off * edges[1], 0.0];
        (0.25 * mass, place.into())
    })
}

/// A wheel of mass 1 and radius 1, a uniform disc, upright, its axle along z: a square with edges of
/// sqrt(3) has the same moments.
pub fn wheel() -> [Mass; 4] {
    plate_points(1.0, [3.0_f64.sqrt(); 2], [0.0, 0.0])
}

/// It rolls along x with the speed 1, and so turns clockwise.
pub fn rolling() -> Rigid {
    let clockwise = about_origin(DesignVector::new(0.0, 0.0, -1.0));
    Rigid { velocity: DesignVector::new(1.0, 0.0, 0.0), ..clockwise }
}

/// Points of the wheel, over its radius.
pub const WHEEL_POINTS: [(&str, [f64; 3]); 5] = [
    ("centre", [0.0, 0.0, 0.0]),
    ("contact", [0.0, -1.0, 0.0]),
    ("on the small circle", [0.5, -0.5, 0.0]),
    ("front of the rim", [1.0, 0.0, 0.0]),
    ("top", [0.0, 1.0, 0.0]),
];
