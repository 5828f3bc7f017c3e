//! Principal moments and axes of a tensor: Jacobi's rotations.

use super::PrincipalMoments;
use crate::attitude::Attitude;
use crate::error::Result;
use crate::frame::DesignVector;
use crate::math::{self, EPS};

/// The principal moments of a tensor of inertia, ascending, and its principal
/// axes, a right-handed triad.
///
/// Accuracy: moments within 2.7 eps of the largest, axes orthonormal to 6.8 eps, measured in
/// `tests/bodies/inertia`. Where moments coincide the axes in their plane are a choice: the axes of
/// the given tensor if it is diagonal.
///
/// Source: C. G. J. Jacobi, J. reine angew. Math. 30, 51 (1846), in the cyclic
/// form with the stable rotation of G. Golub and C. Van Loan, Matrix
/// Computations, 8.5.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PrincipalAxes {
    moments: [f64; 3],
    known_within: f64,
    /// The columns are the axes.
    axes: [[f64; 3]; 3],
}

impl PrincipalAxes {
    /// Diagonalises a symmetric matrix of finite elements.
    pub(super) fn of(matrix: [[f64; 3]; 3]) -> Self {
        let mut a = matrix;
        let mut v = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        // Convergence is quadratic; six sweeps were the most seen, and the sweep
        // that finds nothing to do ends it.
        for _ in 0..30 {
            let mut rotated = false;
            for (p, q) in [(0, 1), (0, 2), (1, 2)] {
                rotated |= rotate(&mut a, &mut v, p, q);
            }
            if !rotated {
                break;
            }
        }
        let moments = [a[0][0], a[1][1], a[2][2]];
        let order = math::order_of_three(moments);
        let mut axes = v.map(|row| order.map(|i| row[i]));
        // An odd permutation turns the hand; the third axis has its sign free.
        if matches!(order, [0, 2, 1] | [1, 0, 2] | [2, 1, 0]) {
            for row in &mut axes {
                row[2] = -row[2];
            }
        }
        Self { moments: order.map(|i| moments[i]), known_within: 0.0, axes }
    }

    /// Where rounding hides the smallest moment it is zero: the body is a rod, or a point mass.
    pub(super) fn known_within(self, known_within: f64) -> Self {
        let [low, middle, high] = self.moments;
        let across = 0.5 * middle + 0.5 * high;
        let moments = if high <= known_within {
            [0.0; 3]
        } else if low <= known_within {
            [0.0, across, across]
        } else {
            self.moments
        };
        Self { moments, known_within, ..self }
    }

    /// The moments of a body that are nearest to these, by the sum of squares of what changes.
    ///
    /// Moments a <= b <= c are a body's if c <= a + b. If they are not, the nearest lie on the
    /// plane c = a + b, which is reached along its normal (1, 1, -1): a plate. A plate has no
    /// negative moment. If that point has one, the nearest lie on the edge (0, t, t), at t = (b +
    /// c)/2: a rod; and for negative t at the end of the edge, zero: a point mass.
    pub(super) fn nearest_possible(&self) -> [f64; 3] {
        let [a, b, c] = self.moments;
        let part = ((c - b) - a) / 3.0;
        if part <= 0.0 {
            self.moments
        } else if a + part >= 0.0 {
            [a + part, b + part, c - part]
        } else {
            let across = (0.5 * b + 0.5 * c).max(0.0);
            [0.0, across, across]
        }
    }

    /// The principal moments, ascending (kg m^2): (0, I, I) of a rod, (0, 0, 0) of a point
    /// mass.
    ///
    /// A moment is zero if it is not above
    /// [`InertiaTensor::known_within`](super::InertiaTensor::known_within).
    pub const fn moments(&self) -> [f64; 3] {
        self.moments
    }

    /// The principal axes as unit vectors on the axes of the tensor, in the
    /// order of the moments; right-handed.
    pub fn axes(&self) -> [DesignVector; 3] {
        let v = self.axes;
        [0, 1, 2].map(|i| DesignVector::new(v[0][i], v[1][i], v[2][i]))
    }

    /// The rotation that carries components on the principal axes to components
    /// on the axes of the tensor.
    pub fn attitude(&self) -> Result<Attitude> {
        Attitude::from_matrix(self.axes)
    }

    /// The moments, for a body whose axes are the principal axes.
    ///
    /// Errors: as [`PrincipalMoments::new`]; a thin rod has a moment of zero.
    pub fn principal_moments(&self) -> Result<PrincipalMoments> {
        PrincipalMoments::known_within(self.moments, self.known_within)
    }
}

/// One rotation in the plane (p, q) that makes a_pq zero; false if it is
/// negligible against both diagonal elements.
fn rotate(a: &mut [[f64; 3]; 3], v: &mut [[f64; 3]; 3], p: usize, q: usize) -> bool {
    let off = a[p][q];
    // Against the geometric mean: small moments keep their relative accuracy.
    let negligible = 0.25 * EPS * (a[p][p].abs().sqrt() * a[q][q].abs().sqrt());
    if off == 0.0 || off.abs() <= negligible {
        return false;
    }
    // tan of the smaller angle, from cot 2x, without cancellation.
    let half_difference = 0.5 * a[q][q] - 0.5 * a[p][p];
    let cot = half_difference / off;
    let tan = if cot.is_infinite() {
        0.5 * off / half_difference
    } else {
        1.0_f64.copysign(cot) / (cot.abs() + math::hypot(1.0, cot))
    };
    let cos = 1.0 / (1.0 + tan * tan).sqrt();
    let sin = tan * cos;
    a[p][p] -= tan * off;
    a[q][q] += tan * off;
    a[p][q] = 0.0;
    a[q][p] = 0.0;
    let r = 3 - p - q;
    let (rp, rq) = (a[r][p], a[r][q]);
    a[r][p] = cos * rp - sin * rq;
    a[r][q] = sin * rp + cos * rq;
    a[p][r] = a[r][p];
    a[q][r] = a[r][q];
    for row in v.iter_mut() {
        let (vp, vq) = (row[p], row[q]);
        row[p] = cos * vp - sin * vq;
        row[q] = sin * vp + cos * vq;
    }
    true
}
