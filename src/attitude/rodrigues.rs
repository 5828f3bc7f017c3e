//! Modified Rodrigues parameters, and attitudes at random.

use super::Attitude;
use crate::error::{Error, Result, finite};
use crate::math;
use core::f64::consts::TAU;

impl Attitude {
    /// The attitude of modified Rodrigues parameters: axis times tan(angle/4), of any finite
    /// size; sigma and its shadow -sigma/|sigma|^2 are one attitude.
    ///
    /// q = (1 - |sigma|^2, 2 sigma)/(1 + |sigma|^2).
    ///
    /// Errors: a parameter that is not finite.
    /// Accuracy: rotation error 3.1 eps, measured in `tests/bodies/attitude`.
    /// Source: M. D. Shuster, J. Astronaut. Sci. 41, 439 (1993).
    pub fn from_modified_rodrigues(sigma: [f64; 3]) -> Result<Self> {
        let mut largest: f64 = 1.0;
        for (name, value) in ["sigma_1", "sigma_2", "sigma_3"].into_iter().zip(sigma) {
            largest = largest.max(finite(name, value)?.abs());
        }
        let unit = largest.recip();
        let [x, y, z] = sigma.map(|c| c / largest);
        let w = unit * unit - (x * x + y * y + z * z);
        Self::from_quaternion([w, 2.0 * unit * x, 2.0 * unit * y, 2.0 * unit * z])
    }

    /// The modified Rodrigues parameters: axis times tan(angle/4), angle in [0, pi]: of the two
    /// sets that which is no longer than 1, to rounding.
    ///
    /// (x, y, z)/(1 + w) with w >= 0.
    ///
    /// Accuracy: 3.8 eps of their length. Special cases: at half a turn both sets have length 1,
    /// and the sign is taken from the stored quaternion. Source: as the way there.
    ///
    /// ```
    /// use rotation_dynamics::attitude::Attitude;
    /// // More than half a turn about z is less than half a turn back.
    /// let attitude = Attitude::from_modified_rodrigues([0.0, 0.0, 2.0])?;
    /// assert_eq!(attitude.modified_rodrigues(), [0.0, 0.0, -0.5]);
    /// # Ok::<(), rotation_dynamics::Error>(())
    /// ```
    pub fn modified_rodrigues(&self) -> [f64; 3] {
        let [w, x, y, z] = self.quaternion();
        let divisor = 1.0 + w.abs();
        let divisor = if w < 0.0 { -divisor } else { divisor };
        [x, y, z].map(|c| c / divisor + 0.0)
    }

    /// An attitude at random from three random numbers: uniform over all attitudes if they are
    /// independent and uniform in 0..=1, from any generator.
    ///
    /// q = (sqrt(1 - a) (sin 2 pi b, cos 2 pi b), sqrt(a) (sin 2 pi c, cos 2 pi c)), as
    /// (x, y, z, w).
    ///
    /// Errors: a number that is not in 0..=1.
    /// Source: K. Shoemake, Graphics Gems III, 124 (1992).
    ///
    /// ```
    /// use rotation_dynamics::attitude::Attitude;
    /// let attitude = Attitude::from_uniform([0.5, 0.25, 0.125])?; // say, `rng.random()`
    /// assert!(attitude.axis().z() < 1e-15);
    /// # Ok::<(), rotation_dynamics::Error>(())
    /// ```
    pub fn from_uniform(numbers: [f64; 3]) -> Result<Self> {
        for value in numbers {
            finite("random number", value)?;
            if !(0.0..=1.0).contains(&value) {
                let allowed = "it must be in 0..=1";
                return Err(Error::out_of_range("random number", value, allowed));
            }
        }
        let [a, b, c] = numbers;
        let (sin_b, cos_b) = math::sincos(TAU * b);
        let (sin_c, cos_c) = math::sincos(TAU * c);
        let (one, other) = ((1.0 - a).sqrt(), a.sqrt());
        Self::from_xyzw([one * sin_b, one * cos_b, other * sin_c, other * cos_c])
    }
}
