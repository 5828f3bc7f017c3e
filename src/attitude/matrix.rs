//! The rotation matrix R, body -> space, row-major.

use super::Attitude;
use crate::error::{Error, Result, finite};
use crate::math::DoubleDouble;
use nalgebra::{Matrix3, Rotation3};

/// How far R^T R may be from 1: a product of thousands of rotations in double
/// precision stays within it, a matrix typed with ten digits does not.
const ORTHONORMAL_WITHIN: f64 = 1e-12;

impl Attitude {
    /// The matrix R with v_space = R v_body, row-major; its columns are the body
    /// axes on the fixed axes.
    ///
    /// Accuracy: 2.0 eps absolute in every element, measured in
    /// `tests/bodies/attitude`. Source: notes 15.1.
    pub fn matrix(&self) -> [[f64; 3]; 3] {
        let [w, x, y, z] = self.quaternion();
        let (ww, xx, yy, zz) = (w * w, x * x, y * y, z * z);
        [
            [(ww + xx) - (yy + zz), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
            [2.0 * (x * y + w * z), (ww + yy) - (xx + zz), 2.0 * (y * z - w * x)],
            [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), (ww + zz) - (xx + yy)],
        ]
    }

    /// The attitude of a rotation matrix R, row-major, body -> space.
    ///
    /// Errors: an element that is not finite; [`Error::NotRotation`] if R^T R
    /// is off 1 by more than 1e-12, or if R is a reflection; [`Attitude::nearest`] takes
    /// matrices that are further off, and says how far.
    /// Accuracy: rotation error 1.7 eps for matrices rounded from exact
    /// ones, measured in `tests/bodies/attitude`.
    /// Source: S. W. Shepperd, J. Guidance and Control 1, 223 (1978): of four
    /// forms the one that divides by the largest component.
    pub fn from_matrix(matrix: [[f64; 3]; 3]) -> Result<Self> {
        for row in matrix {
            for element in row {
                finite("element of the matrix", element)?;
            }
        }
        let m = matrix;
        let mut deviation: f64 = 0.0;
        for i in 0..3 {
            for j in i..3 {
                let product = m[0][i] * m[0][j] + m[1][i] * m[1][j] + m[2][i] * m[2][j];
                let wanted = if i == j { 1.0 } else { 0.0 };
                deviation = deviation.max((product - wanted).abs());
            }
        }
        let determinant = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1])
            + m[0][1] * (m[1][2] * m[2][0] - m[1][0] * m[2][2])
            + m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
        if deviation > ORTHONORMAL_WITHIN || determinant <= 0.0 {
            return Err(Error::NotRotation { deviation, determinant });
        }
        // Four times the squares of w, x, y, z.
        let sum =
            |a: f64, b: f64, c: f64| (DoubleDouble::sum(a, b) + DoubleDouble::sum(c, 1.0)).to_f64();
        let squares = [
            sum(m[0][0], m[1][1], m[2][2]),
            sum(m[0][0], -m[1][1], -m[2][2]),
            sum(-m[0][0], m[1][1], -m[2][2]),
            sum(-m[0][0], -m[1][1], m[2][2]),
        ];
        let mut largest = 0;
        for i in 1..4 {
            if squares[i] > squares[largest] {
                largest = i;
            }
        }
        let (wx, wy, wz) = (m[2][1] - m[1][2], m[0][2] - m[2][0], m[1][0] - m[0][1]);
        let (xy, xz, yz) = (m[1][0] + m[0][1], m[0][2] + m[2][0], m[2][1] + m[1][2]);
        // A row of 4 q q^T: proportional to q.
        Self::from_quaternion(match largest {
            0 => [squares[0], wx, wy, wz],
            1 => [wx, squares[1], xy, xz],
            2 => [wy, xy, squares[2], yz],
            _ => [wz, xz, yz, squares[3]],
        })
    }
}

impl From<Attitude> for Rotation3<f64> {
    /// The same matrix, body -> space.
    fn from(attitude: Attitude) -> Self {
        Self::from_matrix_unchecked(Matrix3::from(attitude.matrix()).transpose())
    }
}

impl TryFrom<Rotation3<f64>> for Attitude {
    type Error = Error;

    /// Errors and accuracy: as [`Attitude::from_matrix`] (unchecked ones can be no rotation).
    fn try_from(rotation: Rotation3<f64>) -> Result<Self> {
        Self::from_matrix(rotation.into_inner().transpose().into())
    }
}
