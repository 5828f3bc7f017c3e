//! Rates of the angles of a sequence, and the angular velocity they make.

use super::sequence::{ANGLES, Sequence, named_finite};
use crate::error::{Error, Result, finite};
use crate::frame::BodyVector;
use crate::math;

impl Sequence {
    /// Angular velocity on the body's axes (rad/s), of these angles (rad) that change at
    /// these rates (rad/s): the sum of the three turns.
    ///
    /// Accuracy: 1.4 eps of the sum of the rates, measured in `tests/bodies/attitude`.
    /// Source: Diebel, 8.
    pub fn angular_velocity(self, angles: [f64; 3], rates: [f64; 3]) -> BodyVector {
        let ([across, middle, last], sign) = self.roles();
        let (off, along) = self.first_axis(angles[1]);
        let (sin, cos) = math::sincos(angles[2]);
        let first = rates[0] * off;
        let mut components = [0.0; 3];
        components[across] = first * cos + sign * rates[1] * sin;
        components[middle] = rates[1] * cos - sign * first * sin;
        components[last] = rates[2] + rates[0] * along;
        BodyVector::from_array(components)
    }

    /// The rates of these angles (rad/s) for an angular velocity on the body's axes (rad/s).
    ///
    /// Errors: [`Error::GimbalLock`] where the second angle is at the lock, to the last bit; angles
    /// or components that are not finite; rates beyond `f64`. Accuracy: 3.5 eps over the sine
    /// (proper) or cosine of the second angle, which is the condition, for rates up to 1 rad/s;
    /// measured in `tests/bodies/attitude`.
    pub fn rates(self, angles: [f64; 3], angular_velocity: BodyVector) -> Result<[f64; 3]> {
        let [_, second, third] = named_finite(ANGLES, angles)?;
        let names = ["omega_1", "omega_2", "omega_3"];
        let w = named_finite(names, angular_velocity.to_array())?;
        if self.locks_at(second) {
            return Err(Error::GimbalLock {
                sequence: self.name(),
                angle: second,
                locked: if self.is_proper() {
                    "a multiple of pi"
                } else {
                    "an odd multiple of pi/2"
                },
            });
        }
        let ([across, middle, last], sign) = self.roles();
        let (off, along) = self.first_axis(second);
        let (sin, cos) = math::sincos(third);
        let first = (w[across] * cos - sign * w[middle] * sin) / off;
        let first = finite("rate of the first angle", first)?;
        Ok([
            first,
            w[middle] * cos + sign * w[across] * sin,
            finite("rate of the third angle", w[last] - first * along)?,
        ])
    }

    /// The axis across both others, the middle one and the last, and the sense in which
    /// the last turn leads from the middle one to that across.
    const fn roles(self) -> ([usize; 3], f64) {
        let ([i, j, k], hand) = self.right_handed();
        if self.is_proper() { ([k, j, i], -hand) } else { ([i, j, k], hand) }
    }

    /// The first axis before the last turn: its components across and along the last.
    fn first_axis(self, second: f64) -> (f64, f64) {
        let (sin, cos) = math::sincos(second);
        let (_, hand) = self.right_handed();
        if self.is_proper() { (hand * sin, cos) } else { (cos, hand * sin) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::attitude::Attitude;

    /// The angular velocity is how the attitude of the moving angles changes, and leads back.
    #[test]
    fn rates_turn_the_attitude() {
        let (angles, rates, h) = ([0.4, 0.7, -1.1], [0.3, -0.5, 0.8], 1e-4);
        for sequence in Sequence::ALL {
            let at = |t: f64| {
                let moved = [0, 1, 2].map(|i| angles[i] + rates[i] * t);
                Attitude::from_sequence(sequence, moved).expect("finite angles")
            };
            let turn = (at(-h).inverse() * at(h)).rotation_vector();
            let omega = sequence.angular_velocity(angles, rates).to_array();
            let back = sequence.rates(angles, BodyVector::from_array(omega));
            let back = back.expect("no lock");
            for i in 0..3 {
                let seen = turn.to_array()[i] / (2.0 * h);
                assert!((seen - omega[i]).abs() < 1e-8, "{sequence:?}");
                assert!((back[i] - rates[i]).abs() < 1e-15, "{sequence:?}");
            }
        }
    }
}
