//! The tensor of inertia about a point.

use super::{PrincipalAxes, is_triangle};
use crate::error::{Error, Result, finite};
use crate::frame::DesignVector;
use crate::math::EPS;

/// The tensor of inertia of a body about a point, on the axes of the drawing (kg m^2).
///
/// I_ij = sum m (r^2 delta_ij - r_i r_j): the products of inertia carry the
/// minus sign, L = I omega. The tensor is symmetric, its principal moments are
/// not negative and satisfy the triangle inequality. A thin rod has one moment
/// equal to zero, which is allowed here (and not for a free body).
///
/// Source: notes 15.3.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct InertiaTensor {
    matrix: [[f64; 3]; 3],
}

/// How far principal moments may violate what a body's moments satisfy, relative
/// to the largest: what rounding of six elements and the diagonalisation make.
const PHYSICAL_WITHIN: f64 = 32.0 * EPS;

impl InertiaTensor {
    /// The tensor with these elements, which must be those of some body.
    ///
    /// Errors: an element that is not finite; [`Error::NotSymmetric`] if
    /// elements across the diagonal differ by more than 4 eps of the largest
    /// element; a principal moment below zero or [`Error::TriangleInequality`],
    /// beyond 32 eps of the largest moment.
    pub fn new(matrix: [[f64; 3]; 3]) -> Result<Self> {
        for row in matrix {
            for element in row {
                finite("element of the inertia tensor", element)?;
            }
        }
        let largest = matrix
            .as_flattened()
            .iter()
            .fold(0.0, |m: f64, e| m.max(e.abs()));
        let mut symmetric = matrix;
        for i in 0..3 {
            for j in 0..i {
                let difference = (matrix[i][j] - matrix[j][i]).abs();
                if difference > 4.0 * EPS * largest {
                    return Err(Error::NotSymmetric { difference });
                }
                let mean = 0.5 * matrix[i][j] + 0.5 * matrix[j][i];
                symmetric[i][j] = mean;
                symmetric[j][i] = mean;
            }
        }
        let tensor = Self { matrix: symmetric };
        let moments = tensor.principal_axes().moments();
        for moment in moments {
            finite("principal moment of the inertia tensor", moment)?;
        }
        let slack = PHYSICAL_WITHIN * moments[2].abs();
        if moments[0] < -slack {
            return Err(Error::OutOfRange {
                name: "smallest principal moment of the inertia tensor",
                value: moments[0],
                allowed: "it must not be negative",
            });
        }
        if !is_triangle([moments[0] + slack, moments[1], moments[2]], 0.0) {
            return Err(Error::TriangleInequality { moments });
        }
        Ok(tensor)
    }

    /// The tensor of a body whose principal axes are those of the drawing.
    ///
    /// Errors: as [`InertiaTensor::new`].
    pub fn diagonal(moments: [f64; 3]) -> Result<Self> {
        let [a, b, c] = moments;
        Self::new([[a, 0.0, 0.0], [0.0, b, 0.0], [0.0, 0.0, c]])
    }

    /// From elements that are those of a body by construction.
    pub(super) const fn from_elements(matrix: [[f64; 3]; 3]) -> Self {
        Self { matrix }
    }

    /// The sum of two tensors about the same point, on the same axes; what it may
    /// overflow to is for the caller to check.
    pub(super) fn plus(&self, other: &Self) -> Self {
        let mut matrix = self.matrix;
        for (row, other_row) in matrix.iter_mut().zip(other.matrix) {
            for (element, other_element) in row.iter_mut().zip(other_row) {
                *element += other_element;
            }
        }
        Self { matrix }
    }

    /// The elements I_ij.
    #[inline]
    pub const fn matrix(&self) -> [[f64; 3]; 3] {
        self.matrix
    }

    /// Angular momentum I omega (kg m^2/s) for an angular velocity in rad/s.
    ///
    /// Source: notes 15.4.
    #[inline]
    pub fn angular_momentum(&self, angular_velocity: DesignVector) -> DesignVector {
        let w = angular_velocity.to_array();
        DesignVector::from_array(
            self.matrix
                .map(|row| row[0] * w[0] + row[1] * w[1] + row[2] * w[2]),
        )
    }

    /// Rotational kinetic energy omega . I omega / 2 (J).
    ///
    /// Source: notes 15.3.
    #[inline]
    pub fn kinetic_energy(&self, angular_velocity: DesignVector) -> f64 {
        0.5 * angular_velocity.dot(&self.angular_momentum(angular_velocity))
    }

    /// The moment about the axis through the reference point with this
    /// direction: n . I n / n . n (kg m^2).
    ///
    /// Errors: a direction of length zero, or not finite.
    pub fn moment_about(&self, direction: DesignVector) -> Result<f64> {
        let length = finite("length of the direction", direction.norm())?;
        if length == 0.0 {
            return Err(Error::OutOfRange {
                name: "length of the direction",
                value: 0.0,
                allowed: "it must be greater than 0",
            });
        }
        let unit = direction / length;
        Ok(unit.dot(&self.angular_momentum(unit)) / unit.dot(&unit))
    }

    /// Principal moments and axes.
    pub fn principal_axes(&self) -> PrincipalAxes {
        PrincipalAxes::of(self.matrix)
    }
}
