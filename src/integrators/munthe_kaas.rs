//! The Runge-Kutta-Munthe-Kaas method: Runge-Kutta on the group of rotations.
//!
//! A step does not add to the quaternion, it turns it: R = exp(theta) R_0, and the
//! classical Runge-Kutta method carries the rotation vector theta over the step,
//!
//! ```text
//! theta' = omega - theta x omega / 2 + theta x (theta x omega) / 12,   theta = 0 at first,
//! ```
//!
//! where the terms left out are beyond order 4. The attitude stays a rotation by
//! construction, however long the step.
//!
//! Not for: many digits; order 4 is dear there.

use super::compensated::Compensated;
use super::explicit::{increment, mean_increment, no_steps, node};
use super::ode::{check_span, finite_derivative};
use super::scene::{components, state};
use super::{Integrator, Rk4, Work};
use crate::attitude::Attitude;
use crate::attitude::product::{stretched_and, vector_times};
use crate::body::State;
use crate::effects::erased::AnyEffect;
use crate::error::Result;
use crate::frame::SpaceVector;
use crate::math::sincos;
use crate::scene::Scene;

/// The Runge-Kutta-Munthe-Kaas method of order 4 on attitude and momentum, with
/// the coefficients of [`Rk4`] and equal steps.
///
/// L_Z and other linear invariants are kept to round-off, the length of the
/// quaternion by construction; energy is not kept.
///
/// Accuracy, as measured on the notes' top (16.2, fig. 3) over 20 time units: 3.1e-8
/// with 800 steps, 1.2e-10 with 3200; [`Rk4`], which adds to the quaternion, is off
/// by 8.5e-8 with 800. The length of the quaternion is 1 to one eps after 1e5 steps.
///
/// Source: H. Munthe-Kaas, Appl. Numer. Math. 29, 115 (1999); E. Hairer,
/// C. Lubich, G. Wanner, *Geometric Numerical Integration*, IV.8.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MuntheKaas4 {
    steps: u64,
}

impl MuntheKaas4 {
    /// The method with this many equal steps over the whole run.
    ///
    /// Errors: no steps.
    pub fn new(steps: u64) -> Result<Self> {
        if steps == 0 {
            return Err(no_steps());
        }
        Ok(Self { steps })
    }
}

/// theta' for the angular velocity omega, both on the fixed axes, to order 4.
fn rotation_vector_rate(theta: SpaceVector, omega: SpaceVector) -> SpaceVector {
    let across = theta.cross(&omega);
    omega - across * 0.5 + theta.cross(&across) * (1.0 / 12.0)
}

/// exp(theta) q - q: small for small angles, so that its rounding is too.
fn turning(theta: SpaceVector, quaternion: [f64; 4]) -> [f64; 4] {
    let angle = theta.norm();
    // cos(angle/2) - 1 = -2 sin^2(angle/4) does not cancel.
    let (s, c) = sincos(0.25 * angle);
    let less = -2.0 * s * s;
    let rate = if angle > 0.0 { 2.0 * s * c / angle } else { 0.5 };
    let turn = vector_times(theta.to_array().map(|v| rate * v), quaternion);
    stretched_and(less, quaternion, turn)
}

fn sum(a: [f64; 4], b: [f64; 4]) -> [f64; 4] {
    core::array::from_fn(|i| a[i] + b[i])
}

impl<E: AnyEffect + ?Sized> Integrator<Scene<E>, State> for MuntheKaas4 {
    fn advance(
        &self,
        scene: &Scene<E>,
        t: f64,
        start: &State,
        t_end: f64,
    ) -> Result<(State, Work)> {
        let [w, x, y, z, lx, ly, lz] = components(start);
        check_span(t, &components(start), t_end)?;
        let mut work = Work::default();
        if t == t_end {
            return Ok((*start, work));
        }
        let h = (t_end - t) / self.steps as f64;
        let tableau = Rk4::TABLEAU;
        let mut q = Compensated::new([w, x, y, z]);
        let mut l = Compensated::new([lx, ly, lz]);
        // Rates of theta and of L.
        let mut k = [[0.0; 6]; 4];
        for step in 0..self.steps {
            let now = node(t, t_end, step, self.steps);
            for i in 0..4 {
                let at = now + tableau.c[i] * h;
                let [a, b, c, lx, ly, lz] = increment(h, tableau.a[i], &k);
                let theta = SpaceVector::new(a, b, c);
                let [x, y, z] = l.value;
                let stage = State {
                    attitude: Attitude::from_unit(sum(q.value, turning(theta, q.value))),
                    angular_momentum: SpaceVector::new(x + lx, y + ly, z + lz),
                };
                let omega = stage.attitude.to_space(scene.angular_velocity(at, &stage));
                let [a, b, c] = rotation_vector_rate(theta, omega).to_array();
                let [tx, ty, tz] = scene.torque(at, &stage).to_array();
                k[i] = finite_derivative(at, &components(&stage), [a, b, c, tx, ty, tz, 0.0])
                    .map(|[a, b, c, x, y, z, _]| [a, b, c, x, y, z])?;
            }
            let [a, b, c, lx, ly, lz] = mean_increment(h, tableau.b, &k);
            q = q.plus(&turning(SpaceVector::new(a, b, c), q.value));
            // What rounding has done to the length is undone along q itself.
            let excess = q.value.iter().map(|c| c * c).sum::<f64>() - 1.0;
            q = q.plus(&q.value.map(|c| -0.5 * excess * c));
            l = l.plus(&[lx, ly, lz]);
        }
        work.steps = self.steps;
        work.derivatives = 4 * self.steps;
        let [w, x, y, z] = q.value;
        let [lx, ly, lz] = l.value;
        Ok((state(&[w, x, y, z, lx, ly, lz])?, work))
    }
}
