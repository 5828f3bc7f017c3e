//! Scenes whose type says that their motion has a closed form.
//!
//! `exact` is there for these types alone: for a scene with another effect the compiler finds
//! none, so no program that asks for it exists. [`Scene::solve`] takes the same closed forms;
//! since it takes every scene, it asks the effects themselves, once a solution
//! ([`Effect::integrable_case`](crate::effects::Effect::integrable_case)).

use super::free_body::FreeBody;
use super::heavy_top::{HeavyTop, SymmetricTop};
use crate::body::State;
use crate::effects::GravityAtLever;
use crate::error::{Error, Result};
use crate::scene::Scene;

impl Scene<()> {
    /// The free motion from `start` at t = 0, in closed form.
    ///
    /// ```
    /// # use rotation_dynamics::{attitude::Attitude, body::RigidBody, frame::BodyVector};
    /// # use rotation_dynamics::{inertia::PrincipalMoments, scene::Scene};
    /// # fn main() -> rotation_dynamics::Result<()> {
    /// let body = RigidBody::new(PrincipalMoments::new(1.0, 1.5, 0.8)?);
    /// let start = body.state(Attitude::IDENTITY, BodyVector::new(0.3, 0.1, 2.0))?;
    /// let motion = Scene::new(body).exact(&start)?;
    /// let stepped = Scene::new(body).solve_by_stepping(&start, 50.0, 1e-9)?;
    /// assert!(motion.attitude(50.0).angle_to(&stepped.state.attitude) < 1e-9);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// With friction there is nothing to ask for:
    ///
    /// ```compile_fail,E0599
    /// # use rotation_dynamics::{attitude::Attitude, body::RigidBody, frame::BodyVector};
    /// # use rotation_dynamics::{inertia::PrincipalMoments, scene::Scene};
    /// # use rotation_dynamics::effects::ViscousFriction;
    /// # fn main() -> rotation_dynamics::Result<()> {
    /// # let body = RigidBody::new(PrincipalMoments::new(1.0, 1.5, 0.8)?);
    /// # let start = body.state(Attitude::IDENTITY, BodyVector::new(0.3, 0.1, 2.0))?;
    /// let motion = Scene::new(body).with(ViscousFriction::isotropic(0.1)?).exact(&start)?;
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// Those of [`FreeBody::new`].
    pub fn exact(&self, start: &State) -> Result<FreeBody> {
        let rates = self.body().angular_velocity(start);
        FreeBody::new(self.body().moments(), start.attitude, rates)
    }
}

impl Scene<((), GravityAtLever)> {
    /// The motion of the heavy top from `start` at t = 0, in closed form.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for a body that is not symmetric, which has none; the errors of
    /// [`HeavyTop::from_body`].
    pub fn exact(&self, start: &State) -> Result<HeavyTop> {
        let (moments, gravity) = (self.body().moments(), self.effects().1);
        if !moments.is_symmetric() {
            return Err(Error::out_of_range(
                "I2 - I1",
                moments.i2() - moments.i1(),
                "0: the heavy top has a closed form if it is symmetric",
            ));
        }
        let (weight, lever) = (gravity.weight(), gravity.lever());
        let top = SymmetricTop::formal(moments.i1(), moments.i3(), weight, lever)?;
        let rates = self.body().angular_velocity(start);
        HeavyTop::from_body(top, start.attitude.euler_angles(), rates)
    }
}
