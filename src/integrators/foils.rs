//! Foils: the methods that everyone writes first, kept here to be measured.
//!
//! Not for use. They show what the other methods are for: one fails at the pole of
//! the Euler angles, both gain energy without bound, and both are of order 1. `tests/integrators/foils.rs` measures how they fail.

use super::explicit::{no_steps, node};
use super::scene::components;
use super::{Integrator, Work, ode::check_span};
use crate::attitude::{Attitude, EulerAngles};
use crate::body::State;
use crate::effects::erased::AnyEffect;
use crate::error::{Error, Result, finite};
use crate::frame::BodyVector;
use crate::scene::Scene;

/// Euler's explicit method on the Euler angles and the body rates.
///
/// ```text
/// phi, theta, zeta  by their rates (notes 15.2 (6), inverted),
/// I omega' = torque - omega x I omega.
/// ```
///
/// How it fails: the rates have 1/sin theta in them, so a passage near the pole
/// needs ever smaller steps, and a start on it is refused
/// ([`Error::GimbalLock`]). As measured, with steps of 1e-3 rad past
/// the pole: 6.1e-3 rad off, where [`SemiImplicitEuler`] is off by 9.5e-6.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EulerOnAngles {
    steps: u64,
}

/// Euler's semi-implicit method with a quaternion brought back to unit length, as
/// game engines step their bodies.
///
/// ```text
/// omega <- omega + h I^-1 (torque - omega x I omega),
/// q <- (q + h q (0, omega)/2) / |...|,   with the new omega.
/// ```
///
/// How it fails: "semi-implicit" is only the attitude; the gyroscopic term is
/// explicit, and a tumbling body gains energy until it flies apart. As measured, for
/// a body that tumbles at 1 rad/s, stepped sixty times a second: 11 % a minute, and
/// after ten minutes 4.9 times its energy.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SemiImplicitEuler {
    steps: u64,
}

impl EulerOnAngles {
    /// The foil with this many equal steps over the whole run.
    ///
    /// Errors: no steps.
    pub fn new(steps: u64) -> Result<Self> {
        if steps == 0 {
            return Err(no_steps());
        }
        Ok(Self { steps })
    }
}

impl SemiImplicitEuler {
    /// The foil with this many equal steps over the whole run.
    ///
    /// Errors: no steps.
    pub fn new(steps: u64) -> Result<Self> {
        if steps == 0 {
            return Err(no_steps());
        }
        Ok(Self { steps })
    }
}

/// I^-1 (torque - omega x I omega), on the body axes.
fn angular_acceleration<E: AnyEffect + ?Sized>(
    scene: &Scene<E>,
    t: f64,
    attitude: Attitude,
    omega: BodyVector,
) -> Result<[f64; 3]> {
    let state = scene.body().state(attitude, omega)?;
    let moments = scene.body().moments().to_array();
    let [w1, w2, w3] = omega.to_array();
    let momentum = BodyVector::new(moments[0] * w1, moments[1] * w2, moments[2] * w3);
    let torque = attitude.to_body(scene.torque(t, &state)) - omega.cross(&momentum);
    let torque = torque.to_array();
    Ok(core::array::from_fn(|i| torque[i] / moments[i]))
}

fn advanced(omega: BodyVector, h: f64, acceleration: [f64; 3]) -> BodyVector {
    let omega = omega.to_array();
    BodyVector::from_array(core::array::from_fn(|i| omega[i] + h * acceleration[i]))
}

fn euler_work(steps: u64) -> Work {
    Work { steps, derivatives: steps, ..Work::default() }
}

/// The scene of a rigid body: what is stepped is I^-1 L, and it alone turns the axes.
fn rigid<E: AnyEffect + ?Sized>(scene: &Scene<E>) -> Result<()> {
    if scene.effects().properties().slips {
        let effects = scene.effects().names().join(", ");
        let reason = format!(
            "a method that steps the angular velocity turns the body by that alone: an effect \
             that turns it further ({effects}) is not allowed there"
        );
        return Err(Error::incompatible(effects, reason));
    }
    Ok(())
}

impl<E: AnyEffect + ?Sized> Integrator<Scene<E>, State> for EulerOnAngles {
    fn advance(
        &self,
        scene: &Scene<E>,
        t: f64,
        start: &State,
        t_end: f64,
    ) -> Result<(State, Work)> {
        check_span(t, &components(start), t_end)?;
        rigid(scene)?;
        if t == t_end {
            return Ok((*start, Work::default()));
        }
        let h = (t_end - t) / self.steps as f64;
        let mut angles = start.attitude.euler_angles();
        let mut omega = scene.body().angular_velocity(start);
        for step in 0..self.steps {
            let now = node(t, t_end, step, self.steps);
            let attitude = Attitude::from_euler(angles)?;
            let acceleration = angular_acceleration(scene, now, attitude, omega)?;
            let rates = angles.rates(omega)?;
            angles = EulerAngles {
                phi: finite("phi", angles.phi + h * rates.phi)?,
                theta: finite("theta", angles.theta + h * rates.theta)?,
                zeta: finite("zeta", angles.zeta + h * rates.zeta)?,
            };
            omega = advanced(omega, h, acceleration);
        }
        let end = scene.body().state(Attitude::from_euler(angles)?, omega)?;
        Ok((end, euler_work(self.steps)))
    }
}

impl<E: AnyEffect + ?Sized> Integrator<Scene<E>, State> for SemiImplicitEuler {
    fn advance(
        &self,
        scene: &Scene<E>,
        t: f64,
        start: &State,
        t_end: f64,
    ) -> Result<(State, Work)> {
        check_span(t, &components(start), t_end)?;
        rigid(scene)?;
        if t == t_end {
            return Ok((*start, Work::default()));
        }
        let h = (t_end - t) / self.steps as f64;
        let mut attitude = start.attitude;
        let mut omega = scene.body().angular_velocity(start);
        for step in 0..self.steps {
            let now = node(t, t_end, step, self.steps);
            let acceleration = angular_acceleration(scene, now, attitude, omega)?;
            omega = advanced(omega, h, acceleration);
            let [w, x, y, z] = attitude.quaternion();
            let [p, q, r] = omega.to_array().map(|c| 0.5 * h * c);
            attitude = Attitude::from_quaternion([
                w - (x * p + y * q + z * r),
                x + (w * p + y * r - z * q),
                y + (w * q + z * p - x * r),
                z + (w * r + x * q - y * p),
            ])?;
        }
        Ok((scene.body().state(attitude, omega)?, euler_work(self.steps)))
    }
}
