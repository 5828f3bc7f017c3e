//! Any body under effects that see only its axis.
//!
//! The parts are the free rotation, exact, and the kick of the torque. From a symmetric body the
//! spin is taken out, as in [`SpinFree`](crate::integrators::SpinFree), and applied once at the
//! end; the rest of the free rotation is a turn about L. Any other body turns by [`FreeFlow`]. An
//! effect that sees more than the axis (a drag, a torque about the axis) is refused by its type.

use super::Separable;
use crate::attitude::Attitude;
use crate::attitude::product::{stretched_and, times_vector, vector_times};
use crate::body::{RigidBody, State};
use crate::effects::Effect;
use crate::error::Result;
use crate::exact::free_body::FreeFlow;
use crate::frame::SpaceVector;
use crate::integrators::compensated::Compensated;
use crate::integrators::spin_free::{axis_only, spin_rate, spun};
use crate::math::sinc_versine;
use crate::scene::Scene;

/// The attitude (without the spin, if the body is symmetric) and the momentum in
/// space, both with compensated sums.
#[derive(Debug, Clone, Copy)]
pub struct BodyPoint {
    pub(super) quaternion: Compensated<4>,
    pub(super) momentum: Compensated<3>,
    pub(super) free: Free,
}

/// The free rotation of the body.
#[derive(Debug, Clone, Copy)]
pub(super) enum Free {
    /// Two equal moments: a turn about L, and a steady spin about the axis (rad/s).
    Symmetric { spin: f64 },
    /// Three different moments.
    Asymmetric(FreeFlow),
}

impl BodyPoint {
    /// The point of this state.
    pub(super) fn new(body: &RigidBody, state: &State) -> Self {
        let free = if body.moments().is_symmetric() {
            Free::Symmetric { spin: spin_rate(body, state) }
        } else {
            Free::Asymmetric(FreeFlow::new(body.moments()))
        };
        Self {
            quaternion: Compensated::new(state.attitude.quaternion()),
            momentum: Compensated::new(state.angular_momentum.to_array()),
            free,
        }
    }

    /// The quaternion as it is carried, of unit length but for round-off.
    pub const fn quaternion(&self) -> [f64; 4] {
        self.quaternion.value
    }

    /// The momentum as it is carried, on the fixed axes (kg m^2/s).
    pub const fn momentum(&self) -> [f64; 3] {
        self.momentum.value
    }

    /// Free rotation for the time `dt`.
    #[inline(always)]
    pub(super) fn turn_freely(&mut self, body: &RigidBody, dt: f64) {
        let quaternion = self.quaternion.value;
        let momentum = self.momentum.value;
        let increment = match &self.free {
            Free::Symmetric { .. } => turned_about(momentum, dt / body.moments().i1(), quaternion),
            Free::Asymmetric(flow) => {
                let attitude = Attitude::from_unit(quaternion);
                let momentum = attitude.to_body(SpaceVector::from_array(momentum));
                let [less, a, b, c] = flow.increment(momentum.to_array(), dt);
                stretched_and(less, quaternion, times_vector(quaternion, [a, b, c]))
            }
        };
        self.quaternion = self.quaternion.plus(&increment);
    }

    /// The quaternion is brought back to unit length: along itself, so that the
    /// attitude and what its rounding has left out are not touched.
    #[inline(always)]
    pub(super) fn settle(&mut self) {
        let q = self.quaternion.value;
        let excess = q.iter().map(|c| c * c).sum::<f64>() - 1.0;
        self.quaternion = self.quaternion.plus(&q.map(|c| -0.5 * excess * c));
    }
}

impl<E: Effect> Separable for Scene<E> {
    type State = State;
    type Point = BodyPoint;

    fn enter(&self, state: &State) -> Result<BodyPoint> {
        axis_only(self.effects())?;
        Ok(BodyPoint::new(self.body(), state))
    }

    fn leave(&self, point: &BodyPoint, elapsed: f64) -> Result<State> {
        let spin = match point.free {
            Free::Symmetric { spin } => spin * elapsed,
            Free::Asymmetric(_) => 0.0,
        };
        spun(point.quaternion.value, spin, point.momentum.value)
    }

    fn flow(&self, point: &mut BodyPoint, dt: f64) {
        point.turn_freely(self.body(), dt);
    }

    /// The momentum changes by the torque times dt; nothing moves.
    fn kick(&self, point: &mut BodyPoint, dt: f64) {
        if const { E::PROPERTIES.torque_free } {
            return;
        }
        let axis = Attitude::from_unit(point.quaternion.value).axis();
        let torque = (self.effects()).torques_on_axis(self.body(), axis.to_array());
        point.momentum = point.momentum.plus(&torque.map(|m| dt * m));
    }

    fn settle(&self, point: &mut BodyPoint) {
        point.settle();
    }
}

/// The change of q by a turn about L, by the angle |L| `per_moment`.
fn turned_about(momentum: [f64; 3], per_moment: f64, quaternion: [f64; 4]) -> [f64; 4] {
    let [a, b, c] = momentum.map(|l| 0.5 * per_moment * l);
    let square = a * a + b * b + c * c;
    // What is added to q is q (cos - 1) + sin (n q): small for small angles,
    // so that its rounding is too.
    let (rate, versine) = sinc_versine(square);
    let less = -square * versine;
    let turn = vector_times([rate * a, rate * b, rate * c], quaternion);
    stretched_and(less, quaternion, turn)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A turn about L by |L|/I dt, and nothing else.
    #[test]
    fn a_turn_is_a_rotation_by_its_angle() {
        let momentum = SpaceVector::new(0.6, -1.1, 0.4);
        for per_moment in [1e-9, 0.3, -2.0] {
            let more = turned_about(momentum.to_array(), per_moment, [0.5, -0.5, 0.5, 0.5]);
            let q = [0, 1, 2, 3].map(|i| [0.5, -0.5, 0.5, 0.5][i] + more[i]);
            let square: f64 = q.iter().map(|c| c * c).sum();
            assert!((square - 1.0).abs() < 1e-15, "{square}");
            let start = Attitude::from_unit([0.5, -0.5, 0.5, 0.5]);
            let turn = (Attitude::from_unit(q) * start.inverse()).rotation_vector();
            assert!((turn - momentum * per_moment).norm() < 2e-15, "{turn:?}");
        }
    }
}
