//! The tensor of inertia about a point.

use super::{PrincipalAxes, ROUNDING, possible};
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
/// A tensor knows how far rounding may have moved its moments, and tensors that are computed
/// pass it on, [`InertiaTensor::known_within`]. Two tensors are equal if their elements are.
///
/// Source: notes 15.3.
#[derive(Debug, Clone, Copy)]
pub struct InertiaTensor {
    matrix: [[f64; 3]; 3],
    known_within: f64,
}

impl PartialEq for InertiaTensor {
    fn eq(&self, other: &Self) -> bool {
        self.matrix == other.matrix
    }
}

impl InertiaTensor {
    /// The tensor with these elements, which must belong to some body.
    ///
    /// Errors: an element that is not finite; [`Error::OutOfRange`] if elements across the diagonal
    /// differ by more than 4 eps of the largest element. [`Error::NotABody`] for principal moments
    /// of no body, which exceed the sum of the others, or are negative, by more than 32 eps of the
    /// largest.
    pub fn new(matrix: [[f64; 3]; 3]) -> Result<Self> {
        let largest = matrix.as_flattened().iter().fold(0.0, |m: f64, e| m.max(e.abs()));
        let mut symmetric = matrix;
        for i in 0..3 {
            for j in 0..i {
                let difference = (matrix[i][j] - matrix[j][i]).abs();
                if difference > 4.0 * EPS * largest {
                    return Err(Error::out_of_range(
                        "difference of elements across the diagonal",
                        difference,
                        "the tensor must be symmetric",
                    ));
                }
                let mean = 0.5 * matrix[i][j] + 0.5 * matrix[j][i];
                symmetric[i][j] = mean;
                symmetric[j][i] = mean;
            }
        }
        let moments = diagonalised(symmetric)?.moments();
        let slack = ROUNDING * moments[2].abs();
        let excess = possible(moments, slack)?;
        let [[_, xy, xz], [_, _, yz], _] = symmetric;
        let known_within = match [xy, xz, yz] == [0.0; 3] {
            true => excess.max(0.0),
            false => slack,
        };
        Ok(Self { matrix: symmetric, known_within })
    }

    /// The tensor of a body whose principal axes are the axes of the drawing.
    ///
    /// Errors: as [`InertiaTensor::new`].
    pub fn diagonal(moments: [f64; 3]) -> Result<Self> {
        let [a, b, c] = moments;
        Self::new([[a, 0.0, 0.0], [0.0, b, 0.0], [0.0, 0.0, c]])
    }

    /// From computed elements, whose rounding moves the moments by at most `known_within`.
    ///
    /// Moments of no body that rounding explains are replaced by the nearest that a body has. The
    /// matrix with these and with the same axes is the nearest of all bodies' in the norm of
    /// Frobenius, which no turn changes. A difference that the rounding of the elements themselves
    /// explains is left as it is.
    pub(super) fn computed(mut matrix: [[f64; 3]; 3], known_within: f64) -> Result<Self> {
        finite("rounding of the inertia tensor", known_within)?;
        let found = diagonalised(matrix)?;
        let moments = found.moments();
        possible(moments, known_within)?;
        if possible(moments, ROUNDING * moments[2].abs()).is_err() {
            let (nearest, v) = (found.nearest_possible(), found.axes().map(DesignVector::to_array));
            let element = |i, j| (0..3).map(|k| nearest[k] * (v[k][i] * v[k][j])).sum();
            matrix = [0, 1, 2].map(|i| [0, 1, 2].map(|j| element(i, j)));
        }
        Ok(Self { matrix, known_within })
    }

    /// sum m r^2 (kg m^2), from the largest moment to 3/2 of it.
    pub(super) fn size(&self) -> f64 {
        let [[xx, ..], [_, yy, _], [.., zz]] = self.matrix;
        0.5 * xx + 0.5 * yy + 0.5 * zz
    }

    /// How far rounding may have moved the principal moments (kg m^2).
    ///
    /// 32 eps of what was added and subtracted: of the tensors, and of m d (a + b) for a
    /// step d from a point at a distance a from the origin to one at b. For a diagonal tensor that
    /// is given it is zero, or the excess of the largest moment over the sum of the others.
    ///
    /// A moment that is not above it is zero, as for a rod. Moments that differ by no more are made
    /// equal in a [`crate::body::DesignedBody`].
    ///
    /// ```
    /// use rotation_dynamics::frame::DesignVector;
    /// use rotation_dynamics::inertia::{MassProperties, solids};
    /// # fn main() -> rotation_dynamics::Result<()> {
    /// let rod = solids::rod(1.0, 1.0)?;
    /// let (centre, far) = (rod.centre_of_mass(), DesignVector::new(10.0, 0.0, 0.0));
    /// let back = MassProperties::from_tensor_about(far, 1.0, centre, rod.about(far)?)?;
    /// // Of 100 kg m^2 a twelfth is left, with the rounding of 100.
    /// let tensor = back.about_centre_of_mass();
    /// assert_eq!(format!("{:.1e}", tensor.known_within()), "1.1e-12");
    /// let refused = tensor.principal_axes().principal_moments().unwrap_err();
    /// assert!(refused.to_string().contains("those of a rod"));
    /// # Ok(())
    /// # }
    /// ```
    pub const fn known_within(&self) -> f64 {
        self.known_within
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
            self.matrix.map(|row| row[0] * w[0] + row[1] * w[1] + row[2] * w[2]),
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
            return Err(Error::out_of_range(
                "length of the direction",
                0.0,
                "it must be greater than 0",
            ));
        }
        let unit = direction / length;
        Ok(unit.dot(&self.angular_momentum(unit)) / unit.dot(&unit))
    }

    /// Principal moments and axes.
    pub fn principal_axes(&self) -> PrincipalAxes {
        PrincipalAxes::of(self.matrix).known_within(self.known_within)
    }
}

/// Moments and axes of a symmetric matrix, all of them finite.
fn diagonalised(matrix: [[f64; 3]; 3]) -> Result<PrincipalAxes> {
    for element in matrix.as_flattened() {
        finite("element of the inertia tensor", *element)?;
    }
    let found = PrincipalAxes::of(matrix);
    for moment in found.moments() {
        finite("principal moment of the inertia tensor", moment)?;
    }
    Ok(found)
}
