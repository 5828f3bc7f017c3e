//! An effect that a program decides on while it runs.

use super::erased::functions;
use super::{Effect, Feature, IntegrableCase, Part, Properties, Resistance};
use crate::body::{RigidBody, State};
use crate::error::Result;
use crate::frame::SpaceVector;
use crate::math::Lane;

macro_rules! optional {
    ($( $name:ident($($argument:ident: $type:ty),*) -> $result:ty; )*) => {
        /// An effect that is there or not, as a flag says. `None` is no effect: a scene of one known effect
        /// and of others that are `None` has its closed form. But the type no longer tells which effects
        /// act, so each torque asks whether it is there. A scene then promises
        /// ([`Scene::invariants`](crate::scene::Scene::invariants)) only what holds if the effect is there.
        /// Where the effects are known, leave out what is not there.
        ///
        /// ```
        /// use rotation_dynamics::attitude::{Attitude, EulerAngles};
        /// use rotation_dynamics::body::RigidBody;
        /// use rotation_dynamics::effects::{GravityAtLever, ViscousFriction};
        /// use rotation_dynamics::frame::BodyVector;
        /// use rotation_dynamics::inertia::PrincipalMoments;
        /// use rotation_dynamics::scene::Scene;
        /// # fn main() -> rotation_dynamics::Result<()> {
        /// let body = RigidBody::new(PrincipalMoments::symmetric(5.45e-3, 9.0e-4)?);
        /// let tilted = Attitude::from_euler(EulerAngles { phi: 0.0, theta: 1.0, zeta: 0.0 })?;
        /// let start = body.state(tilted, BodyVector::new(0.0, 0.0, 314.0))?;
        /// let gravity = GravityAtLever::new(4.9, 0.1)?;
        /// let with = |bearing: Option<ViscousFriction>| {
        ///     Scene::new(body).with(gravity).with(bearing).solve(&start, 1.0, 1e-9)
        /// };
        /// let bearing = ViscousFriction::about_axis(1e-6)?;
        /// assert_eq!(with(None)?.method, "closed form of the heavy top");
        /// assert_eq!(with(None)?.state, Scene::new(body).with(gravity).solve(&start, 1.0, 1e-9)?.state);
        /// assert!(with(Some(bearing))?.work.torques() > 0);
        /// # Ok(())
        /// # }
        /// ```
        impl<E: Effect> Effect for Option<E> {
            const PROPERTIES: Properties = E::PROPERTIES;

            fn name(&self) -> &'static str {
                self.as_ref().map_or("nothing", E::name)
            }

            #[inline(always)]
            fn torques_on_axis<L: Lane>(&self, body: &RigidBody, axis: [L; 3]) -> [L; 3] {
                match self {
                    Some(effect) => effect.torques_on_axis(body, axis),
                    None => ().torques_on_axis(body, axis),
                }
            }

            $(
                #[inline]
                fn $name(&self, $($argument: $type),*) -> $result {
                    match self {
                        Some(effect) => Effect::$name(effect, $($argument),*),
                        None => Effect::$name(&(), $($argument),*),
                    }
                }
            )*
        }
    };
}
functions!(optional);
