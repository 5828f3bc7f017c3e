//! Symmetric bodies without their spin.
//!
//! The free rotation of a symmetric body is R(t) = exp(t L/I1) R(0) exp(t Omega_S e3)
//! with Omega_S = L_z (1/I3 - 1/I1). An effect that sees only the axis e3, and has no
//! torque about it, changes neither L_z nor Omega_S; and it does not notice the last
//! factor, which leaves e3 where it is. So the motion is S(t) exp(t Omega_S e3), where
//! S turns with L/I1 alone:
//!
//! ```text
//! S' = (0, L/I1) S / 2,   L' = torque(e3),   e3 = S z.
//! ```
//!
//! However fast the spin is, it costs no steps and no accuracy. The derivation is in
//! `book/src/how_gauss_legendre.md`.

use super::scene::components;
use super::{Dop853, Integrator, Ode, Rk4, Work, advance_by_counting};
use crate::attitude::Attitude;
use crate::attitude::product::{self, vector_times};
use crate::body::{RigidBody, State};
use crate::effects::Effect;
use crate::error::{Error, Result};
use crate::frame::SpaceVector;
use crate::scene::Scene;

/// The scene of a symmetric body, as a problem from which the spin is taken out.
///
/// The general methods carry it in as few steps as the precession and nutation
/// need. Between the [`State`]s they take and return, and as an [`Ode`], the
/// components are w, x, y, z of S and L_X, L_Y, L_Z.
///
/// ```
/// use rotation_dynamics::attitude::{Attitude, EulerAngles};
/// use rotation_dynamics::body::RigidBody;
/// use rotation_dynamics::effects::GravityAtLever;
/// use rotation_dynamics::frame::BodyVector;
/// use rotation_dynamics::inertia::PrincipalMoments;
/// use rotation_dynamics::integrators::{Dop853, Integrator, SpinFree};
/// use rotation_dynamics::scene::Scene;
/// # fn main() -> rotation_dynamics::Result<()> {
/// // A gyroscope at 30000 turns a minute, for one second.
/// let body = RigidBody::new(PrincipalMoments::symmetric(5.45e-3, 9.0e-4)?);
/// let scene = Scene::new(body).with(GravityAtLever::new(4.9, 0.1)?);
/// let tilted = Attitude::from_euler(EulerAngles { phi: 0.0, theta: 1.0, zeta: 0.0 })?;
/// let start = body.state(tilted, BodyVector::new(0.0, 0.0, 3141.6))?;
/// let method = Dop853::new(1e-12)?;
/// let (plain, work) = method.advance(&scene, 0.0, &start, 1.0)?;
/// let (free, less) = method.advance(&SpinFree::new(&scene)?, 0.0, &start, 1.0)?;
/// assert!(free.attitude.angle_to(&plain.attitude) < 1e-9);
/// assert!(less.derivatives < work.derivatives / 2);
/// # Ok(())
/// # }
/// ```
///
/// Source: notes 15.5 (2) for the free body; notes 16.2 (3): omega_3 is constant.
#[derive(Debug, Clone, Copy)]
pub struct SpinFree<'s, E> {
    scene: &'s Scene<E>,
}

impl<'s, E: Effect> SpinFree<'s, E> {
    /// The scene without the spin of its body.
    ///
    /// Errors: a body that is not symmetric (I1 = I2 exactly), or effects that see more
    /// than its axis.
    pub fn new(scene: &'s Scene<E>) -> Result<Self> {
        axis_only(scene.effects())?;
        symmetric(scene.body())?;
        Ok(Self { scene })
    }

    /// The scene, with the spin.
    pub const fn scene(&self) -> &'s Scene<E> {
        self.scene
    }

    /// The rate Omega_S of the spin in this state (rad/s).
    ///
    /// Accuracy: a few eps |L|/I3, as for the axial momentum in a [`State`].
    pub fn spin_rate(&self, state: &State) -> f64 {
        spin_rate(self.scene.body(), state)
    }

    /// The state that these components and the angle of the spin describe.
    ///
    /// Errors: a component that is not finite; a quaternion of length 0.
    pub fn state(&self, components: &[f64; 7], spin: f64) -> Result<State> {
        let [w, x, y, z, lx, ly, lz] = *components;
        spun([w, x, y, z], spin, [lx, ly, lz])
    }
}

/// The body, if it is symmetric.
pub(super) fn symmetric(body: &RigidBody) -> Result<()> {
    let moments = body.moments();
    if moments.is_symmetric() {
        return Ok(());
    }
    Err(Error::out_of_range(
        "I1 - I2",
        moments.i1() - moments.i2(),
        "0: only the spin of a symmetric body can be taken out",
    ))
}

/// Effects, if they see nothing but the axis of the body.
pub(super) fn axis_only<E: Effect>(effects: &E) -> Result<()> {
    if E::PROPERTIES.axis_only {
        return Ok(());
    }
    Err(Error::sees_more(effects.names().join(", ")))
}

/// Omega_S = L_z (1/I3 - 1/I1) of a symmetric body.
pub(super) fn spin_rate(body: &RigidBody, state: &State) -> f64 {
    let (i1, i3) = (body.moments().i1(), body.moments().i3());
    // (I1 - I3)/I1 does not cancel as 1/I3 - 1/I1 would near a sphere.
    body.angular_velocity(state).z() * ((i1 - i3) / i1)
}

/// The state with the attitude S exp(spin e3).
pub(super) fn spun(quaternion: [f64; 4], spin: f64, momentum: [f64; 3]) -> Result<State> {
    State::new(
        Attitude::from_quaternion(product::spun(quaternion, spin))?,
        SpaceVector::from_array(momentum),
    )
}

impl<E: Effect> Ode<7> for SpinFree<'_, E> {
    fn derivative(&self, _t: f64, &[w, x, y, z, lx, ly, lz]: &[f64; 7]) -> [f64; 7] {
        let square = w * w + x * x + y * y + z * z;
        // The axis of S/|S|; the length of S itself has no influence.
        let axis = Attitude::from_unit([w, x, y, z]).axis() / square;
        let [tx, ty, tz] =
            (self.scene.effects()).torques_on_axis(self.scene.body(), axis.to_array());
        let half = 0.5 / self.scene.body().moments().i1();
        let [dw, dx, dy, dz] = vector_times([half * lx, half * ly, half * lz], [w, x, y, z]);
        [dw, dx, dy, dz, tx, ty, tz]
    }

    /// As for the scene itself.
    fn scale(&self, y: &[f64; 7]) -> [f64; 7] {
        self.scene.scale(y)
    }
}

/// The general methods carry a [`State`] by S and L, and add the spin at the end.
macro_rules! carries_states {
    ($method:ty) => {
        impl<'s, E: Effect> Integrator<SpinFree<'s, E>, State> for $method {
            advance_by_counting!(SpinFree<'s, E>, State);

            fn advance_counting(
                &self,
                problem: &SpinFree<'s, E>,
                t: f64,
                start: &State,
                t_end: f64,
                work: &mut Work,
            ) -> Result<State> {
                let end = self.advance_counting(problem, t, &components(start), t_end, work)?;
                let spin = problem.spin_rate(start) * (t_end - t);
                problem.state(&end, spin)
            }
        }
    };
}

carries_states!(Rk4);
carries_states!(Dop853);
