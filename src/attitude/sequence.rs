//! The twelve sequences of three turns about axes, and their equivalents.
//!
//! All twelve are two: renaming the axes (and turning one of them round where the three
//! are not in cyclic order) leads to z-x'-z'' or to x-y'-z'', exactly.

use super::Attitude;
use super::euler::{twice_argument, zxz_angles, zxz_quaternion};
use super::{norm, scale_for_squares};
use crate::error::{Result, finite};
use crate::math::{self, DoubleDouble, EPS};
use core::f64::consts::FRAC_1_SQRT_2;

/// Three turns one after the other, each about an axis that the turns before it have
/// carried along (intrinsic); [`Sequence::Zyx`] is z-y'-x'', R = Rz(a) Ry(b) Rx(c).
///
/// The same three turns about fixed axes (extrinsic) come in the opposite order: the turn known as
/// extrinsic x-y-z with angles (c, b, a) is `Zyx` with (a, b, c).
///
/// The first six return to the axis they began with (proper Euler angles); they lock where
/// the angle in the middle is a multiple of pi. The others turn about three axes
/// (Tait-Bryan, Cardan) and lock at odd multiples of pi/2. At a lock the first and the last
/// turn are about one line, and only their sum or difference has a meaning.
///
/// ```
/// use rotation_dynamics::attitude::{Attitude, Sequence};
/// # fn main() -> rotation_dynamics::Result<()> {
/// let attitude = Attitude::from_sequence(Sequence::Yxz, [0.5, -0.25, 1.5])?;
/// for (got, given) in attitude.angles(Sequence::Yxz).into_iter().zip([0.5, -0.25, 1.5]) {
///     assert!((got - given).abs() <= 5e-16);
/// }
/// // The notes' angles are one of the twelve.
/// let notes = attitude.euler_angles();
/// assert_eq!(attitude.angles(Sequence::Zxz), [notes.phi, notes.theta, notes.zeta]);
/// # Ok(())
/// # }
/// ```
///
/// Sources: J. Diebel, Representing Attitude (Stanford, 2006), 8; M. D. Shuster,
/// J. Astronaut. Sci. 41, 439 (1993); for all twelve from a quaternion, E. Bernardes,
/// S. Viollet, PLoS ONE 17, e0276302 (2022).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sequence {
    /// x-y'-x''.
    Xyx,
    /// x-z'-x''.
    Xzx,
    /// y-x'-y''.
    Yxy,
    /// y-z'-y''.
    Yzy,
    /// z-x'-z''.
    Zxz,
    /// z-y'-z''.
    Zyz,
    /// x-y'-z''.
    Xyz,
    /// x-z'-y''.
    Xzy,
    /// y-x'-z''.
    Yxz,
    /// y-z'-x''.
    Yzx,
    /// z-x'-y''.
    Zxy,
    /// z-y'-x''.
    Zyx,
}

impl Sequence {
    /// All twelve.
    pub const ALL: [Self; 12] = [
        Self::Xyx,
        Self::Xzx,
        Self::Yxy,
        Self::Yzy,
        Self::Zxz,
        Self::Zyz,
        Self::Xyz,
        Self::Xzy,
        Self::Yxz,
        Self::Yzx,
        Self::Zxy,
        Self::Zyx,
    ];

    /// The axes of the three turns, in order; 0, 1, 2 are x, y, z.
    pub const fn axes(self) -> [usize; 3] {
        match self {
            Self::Xyx => [0, 1, 0],
            Self::Xzx => [0, 2, 0],
            Self::Yxy => [1, 0, 1],
            Self::Yzy => [1, 2, 1],
            Self::Zxz => [2, 0, 2],
            Self::Zyz => [2, 1, 2],
            Self::Xyz => [0, 1, 2],
            Self::Xzy => [0, 2, 1],
            Self::Yxz => [1, 0, 2],
            Self::Yzx => [1, 2, 0],
            Self::Zxy => [2, 0, 1],
            Self::Zyx => [2, 1, 0],
        }
    }

    /// True if the last axis is the first: proper Euler angles.
    pub const fn is_proper(self) -> bool {
        let [first, _, last] = self.axes();
        first == last
    }

    /// Whether this second angle is the double nearest to one at which the sequence locks.
    pub(super) fn locks_at(self, second: f64) -> bool {
        let (sin, cos) = math::sincos(second);
        let off = if self.is_proper() { sin } else { cos };
        // Half a unit of its last place.
        off.abs() <= math::ldexp(EPS, math::ilogb(second))
    }

    /// The first and second axis, the third direction, and its sign that makes them
    /// right-handed.
    pub(super) const fn right_handed(self) -> ([usize; 3], f64) {
        let [i, j, _] = self.axes();
        let hand = if (i + 1) % 3 == j { 1.0 } else { -1.0 };
        ([i, j, 3 - i - j], hand)
    }

    /// As it is written: "z-y'-x''".
    pub(super) const fn name(self) -> &'static str {
        match self {
            Self::Xyx => "x-y'-x''",
            Self::Xzx => "x-z'-x''",
            Self::Yxy => "y-x'-y''",
            Self::Yzy => "y-z'-y''",
            Self::Zxz => "z-x'-z''",
            Self::Zyz => "z-y'-z''",
            Self::Xyz => "x-y'-z''",
            Self::Xzy => "x-z'-y''",
            Self::Yxz => "y-x'-z''",
            Self::Yzx => "y-z'-x''",
            Self::Zxy => "z-x'-y''",
            Self::Zyx => "z-y'-x''",
        }
    }
}

pub(super) const ANGLES: [&str; 3] = ["first angle", "second angle", "third angle"];

pub(super) fn named_finite(names: [&'static str; 3], values: [f64; 3]) -> Result<[f64; 3]> {
    for (name, value) in names.into_iter().zip(values) {
        finite(name, value)?;
    }
    Ok(values)
}

impl Attitude {
    /// The attitude after these three turns (rad), of any finite size.
    ///
    /// The double nearest to the angle of a Tait-Bryan lock counts as the lock: the quaternion is
    /// then the quaternion of the lock, and [`Attitude::angles`] finds it again.
    ///
    /// Errors: an angle that is not finite.
    /// Cost: as [`Attitude::from_euler`].
    /// Accuracy: rotation error 4.4 eps (next to a lock; length of the quaternion 1.5 eps), measured in `tests/bodies/attitude`.
    pub fn from_sequence(sequence: Sequence, angles: [f64; 3]) -> Result<Self> {
        let [first, second, third] = named_finite(ANGLES, angles)?;
        let ([i, j, k], hand) = sequence.right_handed();
        // On axes named i, j, k in this order.
        let [w, x, y, z] = if sequence.is_proper() {
            let [w, y, z, x] = zxz_quaternion(angles);
            [w, x, y, z]
        } else {
            let (sin_a, cos_a) = math::sincos(first / 2.0);
            let (mut sin_b, mut cos_b) = math::sincos(second / 2.0);
            let (sin_c, cos_c) = math::sincos(hand * third / 2.0);
            if sequence.locks_at(second) {
                sin_b = FRAC_1_SQRT_2.copysign(sin_b);
                cos_b = FRAC_1_SQRT_2.copysign(cos_b);
            }
            let (cc, ss, sc, cs) = (cos_a * cos_c, sin_a * sin_c, sin_a * cos_c, cos_a * sin_c);
            // In pairs that are equal to the last bit at a lock.
            [
                cc * cos_b - ss * sin_b,
                sc * cos_b + cs * sin_b,
                cc * sin_b - ss * cos_b,
                cs * cos_b + sc * sin_b,
            ]
        };
        let mut quaternion = [w; 4];
        quaternion[1 + i] = x;
        quaternion[1 + j] = y;
        quaternion[1 + k] = hand * z;
        Ok(Self::brought_to_unit(quaternion))
    }

    /// The angles of the three turns of a sequence (rad): first and third in [-pi, pi], the
    /// second in [0, pi] if the sequence is proper and in [-pi/2, pi/2] if not.
    ///
    /// Accuracy: correctly rounded in all 720 references of `tests/bodies/attitude`, from
    /// 1e-300 rad off a lock or off zero: arguments are formed to 100 bits, without a
    /// cancellation that the quaternion itself does not have.
    ///
    /// Cost: as [`Attitude::euler_angles`].
    ///
    /// Special cases: at a lock exactly the third angle is zero and the first carries what
    /// has a meaning (the sum of both or their difference). A quaternion that is a rounding
    /// off the lock has angles of its own, the first and third each of any size; together
    /// they are the attitude to the same accuracy as anywhere.
    ///
    /// Source: Bernardes and Viollet; the sine and cosine of the second angle as products.
    pub fn angles(&self, sequence: Sequence) -> [f64; 3] {
        let q = self.quaternion();
        let ([i, j, k], hand) = sequence.right_handed();
        let [w, x, y, z] = [q[0], q[1 + i], q[1 + j], hand * q[1 + k]];
        if sequence.is_proper() {
            return zxz_angles([w, y, z, x]);
        }
        // (1 - sin b) and (1 + sin b) are sums of squares of these.
        let (a, b) = (DoubleDouble::sum(w, -y), DoubleDouble::sum(x, -z));
        let (c, d) = (DoubleDouble::sum(w, y), DoubleDouble::sum(x, z));
        let cos = norm([a, b]) * norm([c, d]);
        let sin = (DoubleDouble::product(w, y) + DoubleDouble::product(x, z)).scaled(2.0);
        let second = sin.atan2(cos).to_f64();
        if cos == 0.0 {
            return [twice_argument(w, x), second, 0.0];
        }
        // Products of (w, y) with (x, z) for the sines, and for the cosines products that
        // are small where both are; of either pair in range.
        let for_first = scale_for_squares(w.abs().max(y.abs()));
        let for_second = scale_for_squares(x.abs().max(z.abs()));
        let scale = for_first * for_second;
        let (p, r) = (w * for_first, y * for_first);
        let (u, v) = (x * for_second, z * for_second);
        let (ac, bd) = (a.scaled(scale) * c, b.scaled(scale) * d);
        let sine = |a, b, c, d| DoubleDouble::product(a, b) - DoubleDouble::product(c, d);
        // Adding 0 makes a zero positive: the angle is then pi, not -pi.
        let angle = |sin: DoubleDouble, cos| (sin.scaled(2.0) + 0.0).atan2(cos).to_f64();
        [angle(sine(p, u, r, v), ac - bd), second, angle(sine(p, v, r, u).scaled(hand), ac + bd)]
    }
}
