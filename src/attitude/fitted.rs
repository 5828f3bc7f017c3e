//! The attitude that fits best: to a matrix, to directions seen, to other attitudes.
//!
//! All three make a sum q^T K q largest over unit quaternions q: the answer is the
//! eigenvector of the largest eigenvalue of a symmetric 4x4 matrix K (Davenport's q-method),
//! by nalgebra. The lead of this eigenvalue over the next is the condition: an error of K over
//! the lead is the error of the attitude. A singular value decomposition solves the same problem,
//! but nalgebra's of a 3x3 matrix starts from the square of the matrix and loses half the digits
//! where there are two directions only (`tests/bodies/attitude`).

use super::rotation_vector::scaled;
use super::{Attitude, at, norm, scale_for_squares};
use crate::error::{Error, Result, finite, not_negative};
use crate::frame::{BodyVector, SpaceVector};
use crate::math::{self, DoubleDouble, EPS, sort_by_number};
use nalgebra::{Matrix3, Matrix4, Rotation3, Vector3, Vector4};

/// The best attitude is refused if it leads over the next by no more than this part, or if one of
/// two directions is this close to the line of the other (rad).
const NO_LEAD: f64 = 1e-12;
/// Two directions this close to one line (rad) have a lead of twice [`NO_LEAD`].
const ONE_LINE: f64 = 2e-6;

impl Attitude {
    /// The rotation R nearest to a matrix M, row-major, body -> space, and how far the matrix
    /// was: |M - R|, the root of the sum of the squares of all nine differences.
    ///
    /// For matrices that are measured, typed with a few digits or stored as `f32`
    /// (`matrix.map(|row| row.map(f64::from))`). [`Attitude::from_matrix`] refuses what is off by
    /// more than 1e-12, and says so. A matrix of columns, or space -> body, is the transpose: as good
    /// a rotation, so it is not refused, and gives the [inverse](Attitude::inverse). A factor of
    /// the whole matrix changes nothing but the distance.
    ///
    /// Errors: an element that is not finite; [`Error::OutOfRange`] with the smallest singular
    /// value. That is returned if the value is not above 16 eps of the largest (a singular matrix),
    /// or is negative (a reflection: it has the sign of the determinant), or if with the middle one
    /// it is too small for one rotation to be nearer than all others. Accuracy: rotation error 5.9
    /// eps for matrices up to 0.45 off, and the distance to 16 eps, measured against polar
    /// iteration and singular values in `tests/bodies/attitude`. Source: G. Wahba, SIAM Review 7,
    /// 409 (1965); J. Keat, CSC/TM-77/6034 (1977), for the matrix of P. Davenport.
    ///
    /// ```
    /// use rotation_dynamics::attitude::Attitude;
    /// // Typed with three digits.
    /// let typed = [[0.866, -0.5, 0.0], [0.5, 0.866, 0.0], [0.0, 0.0, 1.0]];
    /// assert!(Attitude::from_matrix(typed).is_err());
    /// let (attitude, off) = Attitude::nearest(typed)?;
    /// assert!((attitude.rotation_vector().z() - std::f64::consts::FRAC_PI_6).abs() < 1e-4);
    /// assert!((off - 3.1e-5).abs() < 1e-5);
    /// # Ok::<(), rotation_dynamics::Error>(())
    /// ```
    pub fn nearest(matrix: [[f64; 3]; 3]) -> Result<(Self, f64)> {
        let mut largest: f64 = 0.0;
        for element in matrix.as_flattened() {
            largest = largest.max(finite("element of the matrix", *element)?.abs());
        }
        let scale = scale_for_squares(largest);
        let m = Matrix3::from_fn(|i, j| matrix[i][j] * scale);
        let (attitude, [first, second, _, fourth]) = best(profile(&m))?;
        // The eigenvalues are a + b + c, a - b - c, b - a - c and c - a - b.
        let (smallest, greatest) = (0.5 * (first + fourth), 0.5 * (first + second));
        if smallest <= 16.0 * EPS * greatest {
            return Err(Error::out_of_range(
                "smallest singular value of the matrix",
                smallest / scale,
                "it must be greater than 0 by more than rounding (negative: a reflection)",
            ));
        }
        leads("the nearest rotation", first, second)?;
        let rotation = attitude.matrix();
        let off: [f64; 9] = core::array::from_fn(|i| matrix[i / 3][i % 3] - rotation[i / 3][i % 3]);
        let distance = finite("distance of the matrix", norm(off).to_f64())?;
        Ok((attitude, distance))
    }

    /// The attitude that carries two directions on the body's axes to where they are on the
    /// fixed axes, and by how much (rad, root mean square) it misses them.
    ///
    /// The first is met, the second as far as the angle between the two allows (TRIAD); the
    /// lengths of the vectors do not matter. Where both are as good,
    /// [`Attitude::from_directions`] shares the fault between them.
    ///
    /// Errors: a vector that is zero or not finite; [`Error::OutOfRange`] with the angle
    /// between two vectors that are along one line within 1e-12 rad.
    /// Accuracy: 6.0 eps over the sine of the angle between the two, measured in
    /// `tests/bodies/attitude`. Source: H. D. Black, AIAA Journal 2, 1350 (1964).
    ///
    /// ```
    /// use rotation_dynamics::attitude::Attitude;
    /// use rotation_dynamics::frame::{BodyVector, SpaceVector};
    /// // A phone on the table: gravity along its -z, and the magnet's north along its y.
    /// let down = (BodyVector::new(0.0, 0.0, -9.81), SpaceVector::new(0.0, 0.0, -1.0));
    /// let north = (BodyVector::new(0.0, 20.0, -43.0), SpaceVector::new(20.0, 0.0, -43.0));
    /// let (attitude, missed) = Attitude::from_two_directions(down, north)?;
    /// assert!((attitude.yaw_pitch_roll().yaw.to_degrees() + 90.0).abs() < 1e-13);
    /// assert!(missed < 1e-15);
    /// # Ok::<(), rotation_dynamics::Error>(())
    /// ```
    pub fn from_two_directions(
        first: (BodyVector, SpaceVector),
        second: (BodyVector, SpaceVector),
    ) -> Result<(Self, f64)> {
        let (a, b) = (directions(first)?, directions(second)?);
        let on_body = axes("angle of the two vectors on the body", [a.0, b.0])?;
        let in_space = axes("angle of the two vectors in space", [a.1, b.1])?;
        let attitude = Self::try_from(in_space)? * Self::try_from(on_body)?.inverse();
        Ok((attitude, missed(attitude, &[(a, 1.0), (b, 1.0)])))
    }

    /// The attitude that carries directions on the body's axes to where they are on the fixed
    /// axes, as well as may be (Wahba's problem): (on the body, in space, weight), and by how
    /// much (rad, root mean square with the weights) it misses them.
    ///
    /// It makes the sum of w |s - R b|^2 least over unit vectors b and s; for measured directions w
    /// is one over the square of their standard deviation. A vector of weight zero is left out.
    ///
    /// Errors: a vector that is zero or not finite, or a weight that is negative or not finite,
    /// with its index; weights that are all zero. [`Error::OutOfRange`] with the angle where all
    /// vectors are along one line within 2e-6 rad, or with the lead of the best attitude over the
    /// next where it is 1e-12 or less (mirrored directions). Accuracy: 8.3 eps over the lead,
    /// measured in `tests/bodies/attitude`; of two directions the lead is half the square of the
    /// angle, and [`Attitude::from_two_directions`] does better. Source: as [`Attitude::nearest`].
    ///
    /// ```
    /// use rotation_dynamics::attitude::Attitude;
    /// use rotation_dynamics::frame::SpaceVector;
    /// let [x, y, z] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    /// let stars = [(x, [0.0, 1.0, 0.001], 1.0), (y, [-1.0, 0.0, 0.0], 1.0), (z, z, 1.0)];
    /// let stars = stars.map(|(body, space, weight)| (body.into(), space.into(), weight));
    /// let (attitude, missed) = Attitude::from_directions(&stars)?;
    /// let quarter = Attitude::about_space_axis(SpaceVector::from(z), 1.5708)?;
    /// assert!(attitude.angle_to(&quarter) < 1e-3 && (1e-4..1e-3).contains(&missed));
    /// # Ok::<(), rotation_dynamics::Error>(())
    /// ```
    pub fn from_directions(seen: &[(BodyVector, SpaceVector, f64)]) -> Result<(Self, f64)> {
        let weights = weights(seen.iter().map(|(_, _, weight)| *weight))?;
        let mut pairs = Vec::with_capacity(seen.len());
        for (index, ((body, space, _), weight)) in seen.iter().zip(weights).enumerate() {
            let pair = directions((*body, *space)).map_err(at("directions", index))?;
            if weight > 0.0 {
                pairs.push((pair, weight));
            }
        }
        let off =
            |a: Vector3<f64>, b: &Vector3<f64>| math::atan2(a.cross(b).norm(), a.dot(b).abs());
        let ((body, space), _) = pairs[0];
        let (mut on_body, mut in_space) = (0.0_f64, 0.0_f64);
        for ((b, s), _) in &pairs {
            on_body = on_body.max(off(body, b));
            in_space = in_space.max(off(space, s));
        }
        if on_body.min(in_space) <= ONE_LINE {
            return Err(Error::out_of_range(
                "largest angle of the directions off one line",
                on_body.min(in_space),
                "it must be greater than 2e-6: a turn about that line is free",
            ));
        }
        let sum = |sum, ((b, s), weight): &(Pair, f64)| sum + *weight * *s * b.transpose();
        let (attitude, [first, second, ..]) =
            best(profile(&pairs.iter().fold(Matrix3::zeros(), sum)))?;
        leads("the best attitude", first, second)?;
        Ok((attitude, missed(attitude, &pairs)))
    }

    /// The mean of attitudes with weights: the one for which the sum of w |R - R_i|^2 is
    /// least, which is the largest eigenvector of the sum of w q q^T. The signs of the quaternions
    /// do not matter.
    ///
    /// Errors: an empty list; a weight that is negative or not finite, with its index; weights that
    /// are all zero; [`Error::OutOfRange`] with the lead of the mean over the next
    /// best where it is 1e-12 or less (two attitudes half a turn apart).
    /// Accuracy: 6.6 eps for attitudes up to 1.4 rad off the middle, measured in
    /// `tests/bodies/attitude`. Source: F. L. Markley, Y. Cheng, J. L. Crassidis, Y. Oshman,
    /// J. Guidance, Control and Dynamics 30, 1193 (2007).
    ///
    /// ```
    /// use rotation_dynamics::attitude::Attitude;
    /// use rotation_dynamics::frame::SpaceVector;
    /// let about_z = |angle| Attitude::about_space_axis(SpaceVector::new(0.0, 0.0, 1.0), angle);
    /// let mean = Attitude::mean(&[(about_z(3.0)?, 1.0), (about_z(-3.0)?, 1.0)])?;
    /// assert!(mean.angle_to(&about_z(std::f64::consts::PI)?) < 1e-15); // not 0
    /// # Ok::<(), rotation_dynamics::Error>(())
    /// ```
    pub fn mean(attitudes: &[(Self, f64)]) -> Result<Self> {
        let weights = weights(attitudes.iter().map(|(_, weight)| *weight))?;
        let mut sum = Matrix4::zeros();
        for ((attitude, _), weight) in attitudes.iter().zip(weights) {
            let q = Vector4::from(attitude.quaternion());
            sum += weight * q * q.transpose();
        }
        let (attitude, [first, second, ..]) = best(sum)?;
        leads("the mean", first, second)?;
        Ok(attitude)
    }
}

/// K of the sum M of w s b^T: q^T K q is the trace of R^T M.
fn profile(m: &Matrix3<f64>) -> Matrix4<f64> {
    let (x, y, z) = (m[(0, 0)], m[(1, 1)], m[(2, 2)]);
    let odd = |i, j| m[(j, i)] - m[(i, j)];
    let even = |i, j| m[(j, i)] + m[(i, j)];
    let (wx, wy, wz) = (odd(1, 2), odd(2, 0), odd(0, 1));
    let (xy, xz, yz) = (even(0, 1), even(0, 2), even(1, 2));
    Matrix4::from([
        [x + y + z, wx, wy, wz],
        [wx, x - y - z, xy, xz],
        [wy, xy, y - x - z, yz],
        [wz, xz, yz, z - x - y],
    ])
}

/// The eigenvector of the largest eigenvalue, and all eigenvalues, descending.
fn best(k: Matrix4<f64>) -> Result<(Attitude, [f64; 4])> {
    let eigen = k.symmetric_eigen();
    let mut order = [0, 1, 2, 3];
    sort_by_number(&mut order, |i| -eigen.eigenvalues[*i]);
    let values = order.map(|i| eigen.eigenvalues[i]);
    let mut q = eigen.eigenvectors.column(order[0]).into_owned();
    // What the iteration left along the others, by perturbation of the first order.
    let rest = k * q - q * (q.dot(&(k * q)) / q.norm_squared());
    for (i, value) in order.into_iter().zip(values).skip(1) {
        let (other, lead) = (eigen.eigenvectors.column(i), values[0] - value);
        if lead > NO_LEAD * values[0] {
            q += other * (other.dot(&rest) / lead);
        }
    }
    let [w, x, y, z] = q.into();
    Ok((Attitude::from_quaternion([w, x, y, z])?, values))
}

/// Refuses a best attitude that is hardly better than the next, which is half a turn off.
fn leads(which: &'static str, first: f64, second: f64) -> Result<()> {
    let lead = (first - second) / first;
    if lead > NO_LEAD {
        return Ok(());
    }
    let allowed = format!("it must be greater than {NO_LEAD:e}, or {which} is not the only one");
    Err(Error::out_of_range("lead over the next best", lead, allowed))
}

/// Weights over the largest.
fn weights(given: impl Iterator<Item = f64> + Clone) -> Result<Vec<f64>> {
    for (index, weight) in given.clone().enumerate() {
        not_negative("weight", weight).map_err(at("weights", index))?;
    }
    if given.clone().next().is_none() {
        let allowed = "there must be at least one";
        return Err(Error::out_of_range("number of weights", 0.0, allowed));
    }
    let largest = given.clone().fold(0.0, f64::max);
    if largest > 0.0 {
        return Ok(given.map(|weight| weight / largest).collect());
    }
    let allowed = "one at least must be greater than 0";
    Err(Error::out_of_range("largest weight", largest, allowed))
}

/// A unit vector on the body's axes, and one on the fixed axes.
type Pair = (Vector3<f64>, Vector3<f64>);

fn directions((body, space): (BodyVector, SpaceVector)) -> Result<Pair> {
    let body = direction("length of the vector on the body", body.to_array())?;
    let space = direction("length of the vector in space", space.to_array())?;
    Ok((body, space))
}

fn direction(name: &'static str, vector: [f64; 3]) -> Result<Vector3<f64>> {
    for component in vector {
        finite("component of a direction", component)?;
    }
    let (vector, _) = scaled(vector);
    let length = norm(vector);
    if length == 0.0 {
        let allowed = "it must be greater than 0";
        return Err(Error::out_of_range(name, 0.0, allowed));
    }
    Ok(vector.map(|c| (DoubleDouble::from(c) / length).to_f64()).into())
}

/// Axes of which z is along the first vector, and y in the plane of both.
fn axes(name: &'static str, [first, second]: [Vector3<f64>; 2]) -> Result<Rotation3<f64>> {
    let sine = first.cross(&second).norm();
    if sine <= NO_LEAD {
        let allowed = "it must be neither 0 nor pi: a turn about that line is free";
        let angle = math::atan2(sine, first.dot(&second));
        return Err(Error::out_of_range(name, angle, allowed));
    }
    // What is left of the second beside the first; again, for the rounding of the first time.
    let beside = |v: Vector3<f64>| (v - first * first.dot(&v)).normalize();
    Ok(Rotation3::face_towards(&first, &beside(beside(second))))
}

/// The angles (rad, root mean square) by which an attitude misses directions.
fn missed(attitude: Attitude, pairs: &[(Pair, f64)]) -> f64 {
    let (mut sum, mut total) = (0.0, 0.0);
    for ((body, space), weight) in pairs {
        let there: Vector3<f64> = attitude.to_space((*body).into()).into();
        let angle = math::atan2(there.cross(space).norm(), there.dot(space));
        sum += weight * angle * angle;
        total += weight;
    }
    (sum / total).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Directions that an attitude gives lead back to it.
    #[test]
    fn directions_lead_back() {
        let attitude = Attitude::from_quaternion([0.3, -0.5, 0.2, 0.7]).expect("not zero");
        let seen = [[1.0, 0.2, -0.3], [0.1, -0.8, 0.4], [-0.2, 0.5, 0.9]].map(|v| {
            let v = BodyVector::from_array(v);
            (v, attitude.to_space(v), 1.0)
        });
        let (found, missed) = Attitude::from_directions(&seen).expect("an attitude");
        assert!(found.angle_to(&attitude) < 1e-14 && missed < 1e-7, "{found:?}");
    }
}
