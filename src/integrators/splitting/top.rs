//! The symmetric body under effects that see only its axis.
//!
//! The free rotation of a symmetric body is R(t) = exp(t L/I1) R(0) exp(t Omega_S e3)
//! with Omega_S = L_z (1/I3 - 1/I1). The second factor, the spin, commutes with
//! everything here: an effect that sees only the axis does not change L_z. So the
//! point carries only the first factor, and the spin is applied once at the end:
//! it costs no steps and no accuracy, however fast it is.

use super::Separable;
use crate::attitude::Attitude;
use crate::body::State;
use crate::effects::AxisEffect;
use crate::error::{Error, Result};
use crate::frame::SpaceVector;
use crate::integrators::compensated::Compensated;
use crate::math::sincos;
use crate::scene::Scene;

/// The attitude without the spin, the momentum, and the rate of the spin.
#[derive(Debug, Clone, Copy)]
pub struct TopPoint {
    quaternion: Compensated<4>,
    momentum: Compensated<3>,
    spin: f64,
}

impl TopPoint {
    /// The quaternion as it is carried, of unit length but for round-off.
    pub const fn quaternion(&self) -> [f64; 4] {
        self.quaternion.value
    }
}

impl<E: AxisEffect> Separable for Scene<E> {
    type State = State;
    type Point = TopPoint;

    fn enter(&self, state: &State) -> Result<TopPoint> {
        let moments = self.body().moments();
        if !moments.is_symmetric() {
            return Err(Error::OutOfRange {
                name: "I1 - I2",
                value: moments.i1() - moments.i2(),
                allowed: "0: only a symmetric body splits into free rotation and kick",
            });
        }
        let (i1, i3) = (moments.i1(), moments.i3());
        let axial = self.body().angular_momentum(state).z();
        Ok(TopPoint {
            quaternion: Compensated::new(state.attitude.quaternion()),
            momentum: Compensated::new(state.angular_momentum.to_array()),
            // (I1 - I3)/I1 does not cancel as 1/I3 - 1/I1 would near a sphere.
            spin: axial / i3 * ((i1 - i3) / i1),
        })
    }

    fn leave(&self, point: &TopPoint, elapsed: f64) -> Result<State> {
        let (s, c) = sincos(0.5 * (point.spin * elapsed));
        let [w, x, y, z] = point.quaternion.value;
        State::new(
            Attitude::from_quaternion([
                w * c - z * s,
                x * c + y * s,
                y * c - x * s,
                z * c + w * s,
            ])?,
            SpaceVector::from_array(point.momentum.value),
        )
    }

    /// The axis turns about L, by the angle |L| dt / I1.
    fn flow(&self, point: &mut TopPoint, dt: f64) {
        let half = 0.5 * dt / self.body().moments().i1();
        let [a, b, c] = point.momentum.value.map(|l| half * l);
        let angle = (a * a + b * b + c * c).sqrt();
        // What is added to q is q (cos - 1) + sin (n q): small for small angles,
        // so that its rounding is too. From half the angle: cos - 1 = -2 sin^2.
        let (s, co) = sincos(0.5 * angle);
        let less = -2.0 * s * s;
        // sin(angle)/angle; a vanishing momentum turns nothing.
        let rate = if angle > 0.0 {
            2.0 * s * co / angle
        } else {
            1.0
        };
        let (a, b, c) = (rate * a, rate * b, rate * c);
        let [w, x, y, z] = point.quaternion.value;
        point.quaternion = point.quaternion.plus(&[
            less * w - (a * x + b * y + c * z),
            less * x + (a * w + b * z - c * y),
            less * y + (b * w + c * x - a * z),
            less * z + (c * w + a * y - b * x),
        ]);
    }

    /// The momentum changes by the torque times dt; nothing moves.
    fn kick(&self, point: &mut TopPoint, dt: f64) {
        let axis = Attitude::from_unit(point.quaternion.value).axis();
        let torque = self.effects().axis_torque(axis).to_array();
        point.momentum = point.momentum.plus(&torque.map(|m| dt * m));
    }

    /// The quaternion is brought back to unit length: along itself, so that the
    /// attitude and what its rounding has left out are not touched.
    fn settle(&self, point: &mut TopPoint) {
        let q = point.quaternion.value;
        let excess = q.iter().map(|c| c * c).sum::<f64>() - 1.0;
        point.quaternion = point.quaternion.plus(&q.map(|c| -0.5 * excess * c));
    }
}
