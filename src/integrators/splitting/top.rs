//! The symmetric body under effects that see only its axis.
//!
//! The parts are the free rotation and the kick of the torque. The spin is taken
//! out, as in [`SpinFree`](crate::integrators::SpinFree), and applied once at the end.

use super::Separable;
use crate::attitude::Attitude;
use crate::body::State;
use crate::effects::AxisEffect;
use crate::error::Result;
use crate::integrators::compensated::Compensated;
use crate::integrators::spin_free::{spin_rate, spun, symmetric};
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
        symmetric(self.body())?;
        Ok(TopPoint {
            quaternion: Compensated::new(state.attitude.quaternion()),
            momentum: Compensated::new(state.angular_momentum.to_array()),
            spin: spin_rate(self.body(), state),
        })
    }

    fn leave(&self, point: &TopPoint, elapsed: f64) -> Result<State> {
        let spin = point.spin * elapsed;
        spun(point.quaternion.value, spin, point.momentum.value)
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
