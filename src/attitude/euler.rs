//! Euler angles z-x'-z'' and their rates (notes 15.1, 15.2).

use super::{Attitude, norm, scale_for_squares};
use crate::error::{Error, Result, finite};
use crate::frame::BodyVector;
use crate::math::{self, DoubleDouble, EPS};

/// The notes' Euler angles: R = Rz(phi) Rx(theta) Rz(zeta), in radians.
///
/// `phi` turns about the fixed Z, `theta` about the line of nodes x, `zeta` about the body axis z.
/// Any finite values are an attitude; the result of [`Attitude::euler_angles`] has theta in [0, pi]
/// and the others in [-pi, pi].
///
/// Source: notes 15.1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EulerAngles {
    /// Precession about the fixed vertical Z (rad).
    pub phi: f64,
    /// Inclination of the body axis z from Z (rad).
    pub theta: f64,
    /// Spin about the body axis z (rad).
    pub zeta: f64,
}

/// The time derivatives of the Euler angles, in rad/s.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EulerRates {
    /// Rate of precession phi' (rad/s).
    pub phi: f64,
    /// Rate of nutation theta' (rad/s).
    pub theta: f64,
    /// Rate of spin zeta' (rad/s).
    pub zeta: f64,
}

impl Attitude {
    /// The attitude with these Euler angles, of any finite size.
    ///
    /// q = (c cos s, k cos d, k sin d, c sin s) with c, k = cos, sin theta/2,
    /// s, d = (phi +- zeta)/2. The sums s and d are kept exactly, so angles of
    /// many turns lose nothing.
    ///
    /// Errors: an angle that is not finite.
    /// Accuracy: rotation error 3.2 eps; components within 1.9 eps of themselves
    /// for angles up to 1e15 rad, measured in `tests/bodies/attitude`.
    /// Source: notes 15.1.
    pub fn from_euler(angles: EulerAngles) -> Result<Self> {
        let phi = finite("phi", angles.phi)?;
        let theta = finite("theta", angles.theta)?;
        let zeta = finite("zeta", angles.zeta)?;
        Ok(Self::from_unit(zxz_quaternion([phi, theta, zeta])))
    }

    /// The Euler angles: theta in [0, pi], phi and zeta in [-pi, pi].
    ///
    /// theta = 2 atan2(|(x, y)|, |(w, z)|),
    /// phi = arg (w + iz)(x + iy), zeta = arg (w + iz)(x - iy).
    ///
    /// Accuracy, measured with the accuracy kit over 2000 attitudes per family
    /// (two seeds), in eps, median / P99 / max of the rotation angle between the
    /// attitude and the exact rotation of the angles returned:
    ///
    /// | theta | rotation error | relative error of theta |
    /// |---|---|---|
    /// | 0.1 ... pi - 0.1 | 0.40 / 1.1 / 1.4 | |
    /// | 1e-20 ... 0.1 | 0.19 / 1.1 / 1.3 | 0.32 / 0.85 / 0.96 |
    /// | 1e-300 ... 1e-20 | 0.20 / 1.1 / 1.5 | 0.32 / 0.85 / 0.96 |
    /// | 0 | 0.25 / 2.0 / 2.0 | 0 |
    /// | pi - 0.1 ... pi - 1e-20 | 1.1 / 2.1 / 2.3 | |
    /// | pi - 1e-20 ... pi - 1e-300 | 1.1 / 1.5 / 1.7 | |
    /// | pi | 1.2 / 2.3 / 2.3 | |
    ///
    /// These are the figures of the exact angles rounded to doubles (at 0 and pi
    /// better: one angle is rounded, not two). No attitude does worse than 4.5:
    /// half an ulp of pi in phi and in zeta, and of theta. Over 32 000 random
    /// attitudes the largest is 2.7 (`tests/bodies/attitude`).
    ///
    /// Cost: three arc tangents to 100 bits, about 40 times [`Attitude::from_euler`]
    /// and 200 compositions. It is for output, not for the inside of a step.
    ///
    /// Special cases: for tiny theta > 0 all three angles are the true ones. At
    /// theta = 0 exactly only phi + zeta has a meaning, at theta = pi exactly
    /// only phi - zeta; then zeta = 0 and phi carries it.
    ///
    /// ```
    /// use rotation_dynamics::attitude::{Attitude, EulerAngles};
    /// # fn main() -> rotation_dynamics::Result<()> {
    /// let upright = EulerAngles { phi: 0.5, theta: 0.0, zeta: 0.25 };
    /// let back = Attitude::from_euler(upright)?.euler_angles();
    /// assert_eq!((back.phi, back.theta, back.zeta), (0.75, 0.0, 0.0));
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// Source: notes 15.1; the products of Cayley and Klein's parameters.
    pub fn euler_angles(&self) -> EulerAngles {
        let [phi, theta, zeta] = zxz_angles(self.quaternion());
        EulerAngles { phi, theta, zeta }
    }
}

impl EulerAngles {
    /// Angular velocity on the nodal axes (x, y, z) of the notes, in rad/s:
    /// (theta', phi' sin theta, zeta' + phi' cos theta).
    ///
    /// x is the line of nodes, z the body axis; these axes follow the body but
    /// do not spin with it, so the result is a bare array and not a vector of
    /// either frame.
    ///
    /// Accuracy: 1.6 eps of |phi'| + |theta'| + |zeta'|. Source: notes 15.2 (6).
    fn nodal_angular_velocity(&self, rates: EulerRates) -> [f64; 3] {
        let (sin_theta, cos_theta) = math::sincos(self.theta);
        [rates.theta, rates.phi * sin_theta, rates.zeta + rates.phi * cos_theta]
    }

    /// Angular velocity on the body's axes, in rad/s:
    /// phi' Z + theta' x + zeta' z with Z and x resolved on the body.
    ///
    /// w1 = theta' cos zeta + phi' sin theta sin zeta,
    /// w2 = -theta' sin zeta + phi' sin theta cos zeta, w3 = zeta' + phi' cos theta.
    ///
    /// Accuracy: 1.6 eps of |phi'| + |theta'| + |zeta'|, measured in
    /// `tests/bodies/attitude`. Source: notes 15.2 (5).
    pub fn angular_velocity(&self, rates: EulerRates) -> BodyVector {
        let [along_node, across, along_axis] = self.nodal_angular_velocity(rates);
        let (sin_zeta, cos_zeta) = math::sincos(self.zeta);
        BodyVector::new(
            along_node * cos_zeta + across * sin_zeta,
            across * cos_zeta - along_node * sin_zeta,
            along_axis,
        )
    }

    /// The rates of the Euler angles for an angular velocity on the body's axes.
    ///
    /// phi' = (w1 sin zeta + w2 cos zeta)/sin theta,
    /// theta' = w1 cos zeta - w2 sin zeta, zeta' = w3 - phi' cos theta.
    ///
    /// Errors: [`Error::GimbalLock`] when theta is a multiple of pi to the last bit: the body axis
    /// is vertical, precession and spin are about one line and cannot be told apart. Also angles or
    /// components that are not finite, and rates beyond the range of `f64`. Accuracy: 2.3 eps/sin
    /// theta, the condition of the problem, for rates up to 1 rad/s; measured in
    /// `tests/bodies/attitude`. Source: notes 15.2 (6), inverted.
    pub fn rates(&self, angular_velocity: BodyVector) -> Result<EulerRates> {
        finite("theta", self.theta)?;
        finite("zeta", self.zeta)?;
        for (name, value) in
            ["omega_1", "omega_2", "omega_3"].into_iter().zip(angular_velocity.to_array())
        {
            finite(name, value)?;
        }
        let (sin_theta, cos_theta) = math::sincos(self.theta);
        // The double nearest a multiple of pi stands for it.
        if sin_theta.abs() <= EPS * self.theta.abs() {
            return Err(Error::GimbalLock {
                sequence: "phi, theta, zeta",
                angle: self.theta,
                locked: "a multiple of pi, where the body axis is vertical",
            });
        }
        let (sin_zeta, cos_zeta) = math::sincos(self.zeta);
        let [w1, w2, w3] = angular_velocity.to_array();
        let phi = finite("phi'", (w1 * sin_zeta + w2 * cos_zeta) / sin_theta)?;
        Ok(EulerRates {
            phi,
            theta: w1 * cos_zeta - w2 * sin_zeta,
            zeta: finite("zeta'", w3 - phi * cos_theta)?,
        })
    }
}

/// The quaternion of three finite angles.
pub(super) fn zxz_quaternion([phi, theta, zeta]: [f64; 3]) -> [f64; 4] {
    let (sin_theta, cos_theta) = math::sincos(theta / 2.0);
    // Halves first: the sum of two huge angles must not overflow.
    let (sin_sum, cos_sum) = sin_cos_of_sum(phi / 2.0, zeta / 2.0);
    let (sin_difference, cos_difference) = sin_cos_of_sum(phi / 2.0, -zeta / 2.0);
    [
        cos_theta * cos_sum,
        sin_theta * cos_difference,
        sin_theta * sin_difference,
        cos_theta * sin_sum,
    ]
}

/// The angles (phi, theta, zeta) of a quaternion.
pub(super) fn zxz_angles([w, x, y, z]: [f64; 4]) -> [f64; 3] {
    let (sin_half, cos_half) = (norm([x, y]), norm([w, z]));
    let theta = sin_half.atan2(cos_half).scaled(2.0).to_f64();
    if sin_half == 0.0 {
        return [twice_argument(w, z), theta, 0.0];
    }
    if cos_half == 0.0 {
        return [twice_argument(x, y), theta, 0.0];
    }
    // One atan2 of a product, not a sum of two, and that to 100 bits: each
    // angle is then rounded once.
    let scale = scale_for_squares(x.abs().max(y.abs()));
    let (x, y) = (x * scale, y * scale);
    let scale = scale_for_squares(w.abs().max(z.abs()));
    let (w, z) = (w * scale, z * scale);
    [argument([w, z], [x, y]), theta, argument([w, z], [x, -y])]
}

/// sin and cos of a + b, where a + b is not rounded first.
fn sin_cos_of_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = DoubleDouble::sum(a, b);
    let (sin, cos) = math::sincos(sum.hi());
    let (sin_rest, cos_rest) = math::sincos(sum.lo());
    (sin * cos_rest + cos * sin_rest, cos * cos_rest - sin * sin_rest)
}

/// Twice the argument of `re + i im`, in [-pi, pi]; the sign of both is free.
pub(super) fn twice_argument(re: f64, im: f64) -> f64 {
    // Choosing the sign first spares a reduction by 2 pi, which would round.
    let flip = re < 0.0 || (re == 0.0 && im < 0.0);
    let im = if flip { -im } else { im };
    let argument = DoubleDouble::from(im + 0.0).atan2(DoubleDouble::from(re.abs()));
    argument.scaled(2.0).to_f64()
}

/// The argument of (a + ib)(c + id), in [-pi, pi], correctly rounded but for 1e-14 ulp.
fn argument([a, b]: [f64; 2], [c, d]: [f64; 2]) -> f64 {
    let re = DoubleDouble::product(a, c) - DoubleDouble::product(b, d);
    let im = DoubleDouble::product(a, d) + DoubleDouble::product(b, c);
    // Adding 0 makes a zero positive: the angle is then pi, not -pi.
    (im + 0.0).atan2(re).to_f64()
}
