//! Mass, centre of mass and the tensor about it; the parallel-axis theorem.

use super::{InertiaTensor, ROUNDING};
use crate::attitude::Attitude;
use crate::error::{Result, finite, positive};
use crate::frame::DesignVector;
use crate::math::DoubleDouble;

/// Mass, centre of mass, and the tensor of inertia about the centre of mass,
/// on the axes of the drawing, with some origin O.
///
/// ```
/// use rotation_dynamics::frame::DesignVector;
/// use rotation_dynamics::inertia::{MassProperties, solids};
/// # fn main() -> rotation_dynamics::Result<()> {
/// // A rod along e3, about its centre and about its end.
/// let rod = solids::rod(3.0, 2.0)?;
/// let end = DesignVector::new(0.0, 0.0, -1.0);
/// assert_eq!(rod.about_centre_of_mass().matrix()[0][0], 1.0);
/// assert_eq!(rod.about(end)?.matrix()[0][0], 4.0);
/// # Ok(())
/// # }
/// ```
///
/// Source: notes 15.3.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MassProperties {
    mass: f64,
    centre_of_mass: DesignVector,
    tensor: InertiaTensor,
}

impl MassProperties {
    /// From mass (kg), centre of mass (m) and the tensor about it (kg m^2).
    ///
    /// Errors: a mass that is not positive and finite, a centre that is not finite.
    pub fn new(mass: f64, centre_of_mass: DesignVector, tensor: InertiaTensor) -> Result<Self> {
        positive("mass", mass)?;
        point("centre of mass", centre_of_mass)?;
        Ok(Self { mass, centre_of_mass, tensor })
    }

    /// From mass, centre of mass and the tensor about another point.
    ///
    /// The parallel-axis theorem backwards: I_cm = I_P - m (d^2 1 - d d^T).
    ///
    /// Errors: as [`MassProperties::new`]; [`Error::NotABody`](crate::Error) if no body has this
    /// tensor about that point. The rest about the centre of mass is then not a body's, by more
    /// than rounding of the terms that cancel, [`InertiaTensor::known_within`]. Accuracy: moments
    /// within a twentieth of that, measured in `tests/traps/cancellation`.
    pub fn from_tensor_about(
        reference: DesignVector,
        mass: f64,
        centre_of_mass: DesignVector,
        tensor: InertiaTensor,
    ) -> Result<Self> {
        positive("mass", mass)?;
        point("centre of mass", centre_of_mass)?;
        point("reference point", reference)?;
        let about_centre = shifted(&tensor, -mass, reference, centre_of_mass)?;
        Self::new(mass, centre_of_mass, about_centre)
    }

    /// Of point masses (kg) at points (m) fixed in the body.
    ///
    /// I_ij = sum m (r^2 delta_ij - r_i r_j) about the centre of mass.
    ///
    /// Errors: no points; a mass that is not positive and finite; a position that is not finite.
    /// Accuracy: elements within 0.7 eps of the largest moment, measured in `tests/bodies/inertia`.
    /// Positions are taken relative to the centre of mass before they are squared, so a distant
    /// origin costs nothing but the rounding of the positions themselves. Source: notes 15.3.
    pub fn of_points(points: &[(f64, DesignVector)]) -> Result<Self> {
        Self::joined(points, &[])
    }

    /// Of point masses, and of bodies that have these tensors about such points.
    fn joined(points: &[(f64, DesignVector)], tensors: &[InertiaTensor]) -> Result<Self> {
        let mut mass = DoubleDouble::ZERO;
        let mut moment = [DoubleDouble::ZERO; 3];
        for (m, r) in points {
            positive("mass of a point", *m)?;
            point("position of a point", *r)?;
            mass = mass + *m;
            for (sum, c) in moment.iter_mut().zip(r.to_array()) {
                *sum += DoubleDouble::product(*m, c);
            }
        }
        positive("total mass", mass.to_f64())?;
        let exact_centre = moment.map(|sum| sum / mass);
        let centre = DesignVector::from_array(exact_centre.map(DoubleDouble::to_f64));
        point("centre of mass", centre)?;
        let mut known_within = 0.0;
        // Twice the digits: many small terms must not add up to many roundings.
        let mut sum = [[DoubleDouble::ZERO; 3]; 3];
        let mut add = |matrix: Matrix| {
            let elements = sum.as_flattened_mut().iter_mut();
            elements.zip(matrix.as_flattened()).for_each(|(sum, e)| *sum = *sum + *e);
        };
        for (m, r) in points {
            let place = r.to_array();
            let d = [0, 1, 2].map(|i| (DoubleDouble::from(place[i]) - exact_centre[i]).to_f64());
            let d = DesignVector::from_array(d);
            add(point_mass(*m, d));
            known_within += ROUNDING * step_terms(*m, d, *r, centre);
        }
        for tensor in tensors {
            add(tensor.matrix());
            known_within += tensor.known_within() + ROUNDING * tensor.size();
        }
        let matrix = sum.map(|row| row.map(DoubleDouble::to_f64));
        let tensor = InertiaTensor::computed(matrix, known_within)?;
        Self::new(mass.to_f64(), centre, tensor)
    }

    /// Several parts, rigidly joined, all given on the same axes and origin.
    ///
    /// Errors: no parts; sums beyond the range of `f64`.
    /// Source: notes 15.3, the parallel-axis theorem part by part.
    pub fn of_parts(parts: &[Self]) -> Result<Self> {
        let points: Vec<_> = parts.iter().map(|p| (p.mass, p.centre_of_mass)).collect();
        let tensors: Vec<_> = parts.iter().map(|p| p.tensor).collect();
        Self::joined(&points, &tensors)
    }

    /// The same body with its centre of mass moved by this much.
    ///
    /// Errors: a displacement that is not finite.
    pub fn displaced(&self, by: DesignVector) -> Result<Self> {
        Self::new(self.mass, self.centre_of_mass + by, self.tensor)
    }

    /// The same body turned about the origin of the drawing: a part that is mounted askew.
    ///
    /// I -> R I R^T, centre of mass c -> R c; the rotation carries the axes on which the
    /// part was given to where they lie on the drawing.
    ///
    /// Errors: moments beyond the range of `f64`.
    /// Accuracy: elements within 8.2 eps of the largest moment, the centre within 9.4, measured in
    /// `tests/bodies/inertia`.
    /// Source: notes 15.3.
    pub fn turned(&self, rotation: &Attitude) -> Result<Self> {
        // The drawing takes the place of space, the part's own axes that of the body.
        let turn = |v: [f64; 3]| rotation.to_space(v.into()).to_array();
        let transposed = |m: Matrix| [0, 1, 2].map(|j| [0, 1, 2].map(|i| m[i][j]));
        // Rows of I R^T, then of R (I R^T).
        let whole = transposed(self.tensor.matrix().map(turn)).map(turn);
        // Rounding makes it a little skew; half of it and of its transpose is not.
        let halves = |m: Matrix| m.map(|row| row.map(|e| 0.5 * e));
        let mean = plus(halves(whole), halves(transposed(whole)));
        let known_within = self.tensor.known_within() + ROUNDING * self.tensor.size();
        let tensor = InertiaTensor::computed(mean, known_within)?;
        let centre = turn(self.centre_of_mass.to_array()).into();
        Self::new(self.mass, centre, tensor)
    }

    /// Mass (kg).
    pub const fn mass(&self) -> f64 {
        self.mass
    }

    /// Centre of mass (m).
    pub const fn centre_of_mass(&self) -> DesignVector {
        self.centre_of_mass
    }

    /// The tensor about the centre of mass.
    pub const fn about_centre_of_mass(&self) -> InertiaTensor {
        self.tensor
    }

    /// The tensor about another point, on parallel axes (Steiner's theorem):
    /// I_P = I_cm + m (d^2 1 - d d^T), d from P to the centre of mass.
    ///
    /// The step always starts at the centre of mass. The notes speak of an axis
    /// parallel to "the symmetry axis"; it need not be one, but it must pass
    /// through the centre of mass.
    ///
    /// Errors: a point that is not finite; moments beyond the range of `f64`.
    /// Source: notes 15.3.
    pub fn about(&self, reference: DesignVector) -> Result<InertiaTensor> {
        point("reference point", reference)?;
        shifted(&self.tensor, self.mass, self.centre_of_mass, reference)
    }
}

fn point(name: &'static str, r: DesignVector) -> Result<()> {
    for value in r.to_array() {
        finite(name, value)?;
    }
    Ok(())
}

type Matrix = [[f64; 3]; 3];

/// The tensor plus m (d^2 1 - d d^T), d the step between the points.
fn shifted(
    tensor: &InertiaTensor,
    m: f64,
    from: DesignVector,
    to: DesignVector,
) -> Result<InertiaTensor> {
    let d = to - from;
    let terms = tensor.size() + step_terms(m.abs(), d, from, to);
    InertiaTensor::computed(
        plus(tensor.matrix(), point_mass(m, d)),
        tensor.known_within() + ROUNDING * terms,
    )
}

/// The size of what cancels in m (d^2 1 - d d^T) for a step d = b - a: the points are known
/// to a rounding of their own distance from the origin, which may be far.
fn step_terms(m: f64, d: DesignVector, a: DesignVector, b: DesignVector) -> f64 {
    m * d.norm() * (a.norm() + b.norm())
}

fn plus(a: Matrix, b: Matrix) -> Matrix {
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| a[i][j] + b[i][j]))
}

/// m (d^2 1 - d d^T)
fn point_mass(m: f64, d: DesignVector) -> Matrix {
    let [x, y, z] = d.to_array();
    let (xy, xz, yz) = (-m * x * y, -m * x * z, -m * y * z);
    [[m * (y * y + z * z), xy, xz], [xy, m * (x * x + z * z), yz], [xz, yz, m * (x * x + y * y)]]
}
