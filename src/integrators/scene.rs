//! Scenes as problems for the general methods.
//!
//! The variables are the attitude quaternion q and the momentum L on the fixed
//! axes; without torque L is constant, and the integrator cannot spoil it:
//!
//! ```text
//! q' = q (0, omega) / 2,   omega = I^-1 R^T L,   L' = torque(t, q, L).
//! ```
//!
//! (with what effects add to omega that slip, [`Scene::angular_velocity`]).
//!
//! *The length of q.* The derivative is the rate of q/|q|, times |q|: it is homogeneous of degree
//! one. So |q| has no influence on the motion, is not corrected on the way (which would break steps
//! and interpolants), and is divided out once, when the state is read.

use super::{Dop853, Integrator, Ode, Rk4, Work, advance_by_counting};
use crate::attitude::Attitude;
use crate::body::State;
use crate::effects::erased::AnyEffect;
use crate::error::Result;
use crate::frame::SpaceVector;
use crate::scene::Scene;

/// The state as the general methods carry it: w, x, y, z, L_X, L_Y, L_Z.
pub fn components(state: &State) -> [f64; 7] {
    let [w, x, y, z] = state.attitude.quaternion();
    let [lx, ly, lz] = state.angular_momentum.to_array();
    [w, x, y, z, lx, ly, lz]
}

/// The state that these components describe; the quaternion is normalised.
///
/// Errors: a component that is not finite; a quaternion of length 0.
pub fn state([w, x, y, z, lx, ly, lz]: &[f64; 7]) -> Result<State> {
    State::new(Attitude::from_quaternion([*w, *x, *y, *z])?, SpaceVector::new(*lx, *ly, *lz))
}

impl<E: AnyEffect + ?Sized> Ode<7> for Scene<E> {
    fn derivative(&self, t: f64, &[w, x, y, z, lx, ly, lz]: &[f64; 7]) -> [f64; 7] {
        let norm = (w * w + x * x + y * y + z * z).sqrt();
        let state = State {
            attitude: Attitude::from_unit([w / norm, x / norm, y / norm, z / norm]),
            angular_momentum: SpaceVector::new(lx, ly, lz),
        };
        let [p, q, r] = self.angular_velocity(t, &state).to_array();
        let [tx, ty, tz] = self.torque(t, &state).to_array();
        [
            0.5 * (-x * p - y * q - z * r),
            0.5 * (w * p + y * r - z * q),
            0.5 * (w * q + z * p - x * r),
            0.5 * (w * r + x * q - y * p),
            tx,
            ty,
            tz,
        ]
    }

    /// The length of the quaternion; the length of the momentum, or the momentum
    /// that the torques build up in the body's own time if that is more. A torque of which no
    /// scale is stated counts as at the time 0.
    fn scale(&self, &[w, x, y, z, lx, ly, lz]: &[f64; 7]) -> [f64; 7] {
        let q = (w * w + x * x + y * y + z * z).sqrt();
        let state = State {
            attitude: Attitude::from_unit([w / q, x / q, y / q, z / q]),
            angular_momentum: SpaceVector::new(lx, ly, lz),
        };
        let [i1, i2, i3] = self.body().moments().to_array();
        let torque = self.effects().torque_scale(0.0, self.body(), &state);
        let built_up = (i1.max(i2).max(i3) * torque).sqrt();
        let l = SpaceVector::new(lx, ly, lz).norm();
        let l = l.max(built_up).max(f64::MIN_POSITIVE);
        [q, q, q, q, l, l, l]
    }
}

/// The general methods carry a [`State`] by its components.
macro_rules! carries_states {
    ($method:ty) => {
        impl<E: AnyEffect + ?Sized> Integrator<Scene<E>, State> for $method {
            advance_by_counting!(Scene<E>, State);

            fn advance_counting(
                &self,
                scene: &Scene<E>,
                t: f64,
                start: &State,
                t_end: f64,
                work: &mut Work,
            ) -> Result<State> {
                let end = self.advance_counting(scene, t, &components(start), t_end, work)?;
                state(&end)
            }
        }
    };
}

carries_states!(Rk4);
carries_states!(Dop853);
