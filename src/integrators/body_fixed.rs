//! A scene on the axes of its body.
//!
//! ```text
//! q' = q (0, omega) / 2,   l_1' = (1/I3 - 1/I2) l_2 l_3 + (l x R^T slip + R^T torque)_1, ...,
//! omega = I^-1 l + R^T slip.
//! ```
//!
//! With L on the fixed axes the rate about the thin axis of a slender body is (R^T L)_i / I_i: an
//! error of the attitude comes back in it, I_max/I_min times as large. With l on the body's axes
//! it does not. The price is that a motion without torque keeps L only as well as it is stepped.
//!
//! Not for: bodies with moments of similar size, which the variables of [`Scene`] carry as well.
//!
//! Source: Euler's equations, notes 15.5.

use super::Ode;
use super::gauss_legendre::{inverse_moments, momentum_on_body, rates_of};
use crate::attitude::Attitude;
use crate::body::State;
use crate::effects::Effect;
use crate::error::Result;
use crate::frame::BodyVector;
use crate::math::{ilogb, ldexp};
use crate::scene::Scene;

/// The scene with w, x, y, z and l_1, l_2, l_3 as components.
pub(crate) struct BodyFixed<'s, E> {
    scene: &'s Scene<E>,
    inverse: [[f64; 2]; 3],
    /// 1/I3 - 1/I2 and its cyclic kin.
    coupling: [f64; 3],
    slips: bool,
    /// The rate (rad/s) that the torque gives the body from rest in half a radian.
    built_up: f64,
}

impl<'s, E: Effect> BodyFixed<'s, E> {
    /// The scene, under torques of this size (N m); of effects that may slip, whether they do.
    pub(crate) fn new(scene: &'s Scene<E>, torque: f64, slips: bool) -> Self {
        let [i1, i2, i3] = scene.body().moments().to_array();
        Self {
            scene,
            inverse: inverse_moments(scene.body()),
            coupling: [(i2, i3), (i3, i1), (i1, i2)]
                .map(|(next, last)| (next - last) / next / last),
            slips,
            built_up: (torque / i1.max(i2).max(i3)).sqrt(),
        }
    }

    /// The state as it is carried; each l_i is R^T L of these doubles to eps of itself.
    pub(crate) fn components(&self, state: &State) -> [f64; 7] {
        let [w, x, y, z] = state.attitude.quaternion();
        let largest =
            (state.angular_momentum.to_array().iter()).fold(0.0_f64, |m, l| m.max(l.abs()));
        let exponent = if largest > 0.0 { ilogb(largest) } else { 0 };
        let [l1, l2, l3] = momentum_on_body(state, exponent).map(|l| ldexp(l.hi(), exponent));
        [w, x, y, z, l1, l2, l3]
    }

    /// The state that these components describe; the quaternion is normalised.
    ///
    /// # Errors
    /// A component that is not finite; a quaternion of length 0.
    pub(crate) fn state(&self, &[w, x, y, z, l1, l2, l3]: &[f64; 7]) -> Result<State> {
        let attitude = Attitude::from_quaternion([w, x, y, z])?;
        State::new(attitude, attitude.to_space(BodyVector::new(l1, l2, l3)))
    }

    /// The angular velocity I^-1 l (rad/s), without what slips.
    fn rates(&self, &[.., l1, l2, l3]: &[f64; 7]) -> BodyVector {
        BodyVector::from_array(rates_of(&self.inverse, [l1, l2, l3]))
    }
}

impl<E: Effect> Ode<7> for BodyFixed<'_, E> {
    fn derivative(&self, t: f64, y: &[f64; 7]) -> [f64; 7] {
        let &[w, x, y1, z, l1, l2, l3] = y;
        let length = (w * w + x * x + y1 * y1 + z * z).sqrt();
        let attitude = Attitude::from_unit([w / length, x / length, y1 / length, z / length]);
        let momentum = BodyVector::new(l1, l2, l3);
        let state = State { attitude, angular_momentum: attitude.to_space(momentum) };
        let torque = attitude.to_body(self.scene.torque(t, &state));
        let [k1, k2, k3] = self.coupling;
        let mut change = torque + BodyVector::new(k1 * l2 * l3, k2 * l3 * l1, k3 * l1 * l2);
        let mut omega = self.rates(y);
        if E::PROPERTIES.slips && self.slips {
            let slip = (self.scene.effects()).slip(t, self.scene.body(), &state);
            let slip = attitude.to_body(slip);
            omega += slip;
            change += momentum.cross(&slip);
        }
        let [p, q, r] = omega.to_array();
        let [a, b, c] = change.to_array();
        [
            0.5 * (-x * p - y1 * q - z * r),
            0.5 * (w * p + y1 * r - z * q),
            0.5 * (w * q + z * p - x * r),
            0.5 * (w * r + x * q - y1 * p),
            a,
            b,
            c,
        ]
    }

    /// The length of the quaternion; I_i times the rate of the body, or the rate that the torques
    /// build up if that is more.
    fn scale(&self, y: &[f64; 7]) -> [f64; 7] {
        let &[w, x, y1, z, ..] = y;
        let q = (w * w + x * x + y1 * y1 + z * z).sqrt();
        let rate = self.rates(y).norm().max(self.built_up);
        let [l1, l2, l3] = (self.scene.body().moments().to_array())
            .map(|moment| (moment * rate).max(f64::MIN_POSITIVE));
        [q, q, q, q, l1, l2, l3]
    }
}
