//! An effect behind a pointer: code written for it is compiled once for all effects.

use super::{Effect, Feature, IntegrableCase, Part, Properties, Resistance, each};
use crate::body::{RigidBody, State};
use crate::error::Result;
use crate::frame::SpaceVector;
use crate::math::Lane;

/// Gives a macro the functions of [`Effect`] that are the same behind a pointer.
macro_rules! functions {
    ($of:ident) => {
        $of! {
            torque(t: f64, body: &RigidBody, state: &State) -> SpaceVector;
            resistance(t: f64, body: &RigidBody) -> Option<Resistance>;
            slip(t: f64, body: &RigidBody, state: &State) -> SpaceVector;
            potential_energy(t: f64, body: &RigidBody, state: &State) -> f64;
            power(t: f64, body: &RigidBody, state: &State) -> f64;
            torque_scale(t: f64, body: &RigidBody, state: &State) -> f64;
            torque_size(t: f64, body: &RigidBody, state: &State) -> f64;
            break_points() -> Vec<f64>;
            narrowest() -> Option<Feature>;
            integrable_case() -> IntegrableCase;
            parts() -> Vec<Part<'_>>;
            names() -> Vec<&'static str>;
            about_axis() -> Vec<&'static str>;
            holds_from(t: f64, body: &RigidBody, start: &State, about_axis: &[&'static str])
                -> Result<()>;
        }
    };
}
pub(super) use functions;

macro_rules! declared {
    ($( $name:ident($($argument:ident: $type:ty),*) -> $result:ty; )*) => {
        /// An [`Effect`] whose type is not asked for: it is behind a pointer where the effects are chosen
        /// at run time ([`EffectList`](super::EffectList)). Every `Effect` is one; write an `Effect`, and
        /// box it. The result of each function is said there. This trait is not among the names of
        /// `effects`, since its functions have the same names as the functions of `Effect`: a
        /// `use effects::*` brings one kind alone:
        ///
        /// ```
        /// use rotation_dynamics::attitude::Attitude;
        /// use rotation_dynamics::body::{RigidBody, State};
        /// use rotation_dynamics::effects::*;
        /// use rotation_dynamics::{frame::SpaceVector, inertia::PrincipalMoments};
        /// let body = RigidBody::new(PrincipalMoments::symmetric(1.0, 0.5)?);
        /// let start = State::new(Attitude::IDENTITY, SpaceVector::new(0.0, 0.0, 2.0))?;
        /// let torque = ViscousFriction::about_axis(0.1)?.torque(0.0, &body, &start);
        /// assert!((torque.z() + 0.1 * 4.0).abs() < 1e-15);
        /// # Ok::<(), rotation_dynamics::Error>(())
        /// ```
        pub trait AnyEffect {
            /// [`Effect::PROPERTIES`].
            fn properties(&self) -> Properties;
            /// [`Effect::torques_on_axis`] of one axis.
            fn torque_on_axis(&self, body: &RigidBody, axis: [f64; 3]) -> [f64; 3];
            $(
                #[doc = concat!("[`Effect::", stringify!($name), "`].")]
                #[allow(clippy::missing_errors_doc, reason = "they are said there")]
                fn $name(&self, $($argument: $type),*) -> $result;
            )*
        }

        impl<E: Effect> AnyEffect for E {
            #[inline]
            fn properties(&self) -> Properties {
                E::PROPERTIES
            }
            fn torque_on_axis(&self, body: &RigidBody, axis: [f64; 3]) -> [f64; 3] {
                Effect::torques_on_axis(self, body, axis)
            }
            $(
                #[inline]
                fn $name(&self, $($argument: $type),*) -> $result {
                    Effect::$name(self, $($argument),*)
                }
            )*
        }
    };
}
functions!(declared);

/// Effects that see the axis alone, behind a pointer, as an effect again: methods that make use of
/// that are compiled once for all of them. On lanes one torque after the other: the same bits.
pub(crate) struct AxisOnly<'e>(pub &'e dyn AnyEffect);

impl Effect for AxisOnly<'_> {
    const PROPERTIES: Properties = Properties { axis_only: true, ..Properties::ANYTHING };

    fn name(&self) -> &'static str {
        "effects"
    }

    fn torque(&self, t: f64, body: &RigidBody, state: &State) -> SpaceVector {
        self.0.torque(t, body, state)
    }

    #[inline(always)]
    fn torques_on_axis<L: Lane>(&self, body: &RigidBody, axis: [L; 3]) -> [L; 3] {
        each(axis, |axis| self.0.torque_on_axis(body, axis))
    }

    fn torque_scale(&self, t: f64, body: &RigidBody, state: &State) -> f64 {
        self.0.torque_scale(t, body, state)
    }

    fn names(&self) -> Vec<&'static str> {
        self.0.names()
    }
}
