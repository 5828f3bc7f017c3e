//! The independent route: rotation matrices with their exact derivatives.

use rotation_dynamics::frame::SpaceVector;
use rotation_dynamics::math::sincos;
use rotation_dynamics::nalgebra::Matrix3;

/// A rotation matrix and its rate of change.
pub struct Turning {
    pub at: Matrix3<f64>,
    rate: Matrix3<f64>,
}

impl Turning {
    /// About the axis 0, 1 or 2, by an angle that changes at this rate.
    pub fn about(axis: usize, angle: f64, rate: f64) -> Self {
        let ((s, c), [i, j]) = (sincos(angle), [(axis + 1) % 3, (axis + 2) % 3]);
        let mut turning = Self { at: Matrix3::identity(), rate: Matrix3::zeros() };
        for (entry, value, slope) in
            [((i, i), c, -s), ((i, j), -s, -c), ((j, i), s, c), ((j, j), c, -s)]
        {
            turning.at[entry] = value;
            turning.rate[entry] = slope * rate;
        }
        turning
    }

    /// The product, its rate by the product rule.
    pub fn times(&self, next: &Self) -> Self {
        let rate = self.rate * next.at + self.at * next.rate;
        Self { at: self.at * next.at, rate }
    }

    /// The angular velocity in space: R' R^T is antisymmetric, and R' R^T r = Omega x r.
    pub fn in_space(&self) -> SpaceVector {
        SpaceVector::from_array(vector(self.rate * self.at.transpose()))
    }

    /// The same on the axes that turn: that of R^T R'.
    pub fn on_own_axes(&self) -> [f64; 3] {
        vector(self.at.transpose() * self.rate)
    }

    /// Its size: the squares of all rates of R add up to twice its square.
    pub fn size(&self) -> f64 {
        (0.5 * self.rate.norm_squared()).sqrt()
    }
}

/// The vector w of the antisymmetric matrix W that has W r = w x r.
fn vector(w: Matrix3<f64>) -> [f64; 3] {
    [w[(2, 1)], w[(0, 2)], w[(1, 0)]]
}
