//! An effect behind a pointer: code written for it is compiled once for all effects.

use super::{Effect, Feature, IntegrableCase, Part, Properties, Resistance, each};
use crate::body::{RigidBody, State};
use crate::error::Result;
use crate::frame::SpaceVector;
use crate::math::Lane;

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
    /// [`Effect::torque`].
    fn torque(&self, t: f64, body: &RigidBody, state: &State) -> SpaceVector;
    /// [`Effect::torques_on_axis`] of one axis.
    fn torque_on_axis(&self, body: &RigidBody, axis: [f64; 3]) -> [f64; 3];
    /// [`Effect::resistance`].
    fn resistance(&self, t: f64, body: &RigidBody) -> Option<Resistance>;
    /// [`Effect::slip`].
    fn slip(&self, t: f64, body: &RigidBody, state: &State) -> SpaceVector;
    /// [`Effect::potential_energy`].
    fn potential_energy(&self, t: f64, body: &RigidBody, state: &State) -> f64;
    /// [`Effect::power`].
    fn power(&self, t: f64, body: &RigidBody, state: &State) -> f64;
    /// [`Effect::torque_scale`].
    fn torque_scale(&self, t: f64, body: &RigidBody, state: &State) -> f64;
    /// [`Effect::torque_size`].
    fn torque_size(&self, t: f64, body: &RigidBody, state: &State) -> f64;
    /// [`Effect::break_points`].
    fn break_points(&self) -> Vec<f64>;
    /// [`Effect::narrowest`].
    fn narrowest(&self) -> Option<Feature>;
    /// [`Effect::integrable_case`].
    fn integrable_case(&self) -> IntegrableCase;
    /// [`Effect::parts`].
    fn parts(&self) -> Vec<Part<'_>>;
    /// [`Effect::names`].
    fn names(&self) -> Vec<&'static str>;
    /// [`Effect::about_axis`].
    fn about_axis(&self) -> Vec<&'static str>;
    /// [`Effect::holds_from`].
    ///
    /// # Errors
    /// The claim that is not so, with the numbers.
    fn holds_from(
        &self,
        t: f64,
        body: &RigidBody,
        start: &State,
        about_axis: &[&'static str],
    ) -> Result<()>;
}

impl<E: Effect> AnyEffect for E {
    #[inline]
    fn properties(&self) -> Properties {
        E::PROPERTIES
    }
    #[inline]
    fn torque(&self, t: f64, body: &RigidBody, state: &State) -> SpaceVector {
        Effect::torque(self, t, body, state)
    }
    fn torque_on_axis(&self, body: &RigidBody, axis: [f64; 3]) -> [f64; 3] {
        Effect::torques_on_axis(self, body, axis)
    }
    fn resistance(&self, t: f64, body: &RigidBody) -> Option<Resistance> {
        Effect::resistance(self, t, body)
    }
    #[inline]
    fn slip(&self, t: f64, body: &RigidBody, state: &State) -> SpaceVector {
        Effect::slip(self, t, body, state)
    }
    #[inline]
    fn potential_energy(&self, t: f64, body: &RigidBody, state: &State) -> f64 {
        Effect::potential_energy(self, t, body, state)
    }
    fn power(&self, t: f64, body: &RigidBody, state: &State) -> f64 {
        Effect::power(self, t, body, state)
    }
    #[inline]
    fn torque_scale(&self, t: f64, body: &RigidBody, state: &State) -> f64 {
        Effect::torque_scale(self, t, body, state)
    }
    fn torque_size(&self, t: f64, body: &RigidBody, state: &State) -> f64 {
        Effect::torque_size(self, t, body, state)
    }
    fn break_points(&self) -> Vec<f64> {
        Effect::break_points(self)
    }
    fn narrowest(&self) -> Option<Feature> {
        Effect::narrowest(self)
    }
    fn integrable_case(&self) -> IntegrableCase {
        Effect::integrable_case(self)
    }
    fn parts(&self) -> Vec<Part<'_>> {
        Effect::parts(self)
    }
    fn names(&self) -> Vec<&'static str> {
        Effect::names(self)
    }
    fn about_axis(&self) -> Vec<&'static str> {
        Effect::about_axis(self)
    }
    fn holds_from(
        &self,
        t: f64,
        body: &RigidBody,
        start: &State,
        about_axis: &[&'static str],
    ) -> Result<()> {
        Effect::holds_from(self, t, body, start, about_axis)
    }
}

/// Effects that see the axis alone, behind a pointer, as an effect again: methods that make use of
/// that are compiled once for all of them. On lanes one torque after the other: the same bits.
pub(crate) struct AxisOnly<'e>(pub &'e dyn AnyEffect);

impl Effect for AxisOnly<'_> {
    const PROPERTIES: Properties = Properties {
        axis_only: true,
        ..Properties::ANYTHING
    };

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
