//! Effects that are chosen at run time.

use super::erased::AnyEffect;
use super::{Feature, IntegrableCase, Part, Properties, Resistance};
use crate::body::{RigidBody, State};
use crate::error::{Error, Result};
use crate::frame::SpaceVector;
use core::fmt;

/// Any number of effects behind pointers: from a file, a form, the command line.
///
/// A scene on it ([`Scene::with_list`](crate::scene::Scene::with_list)) solves by the same code as
/// one whose effects are part of its type, to the same bits. A list costs a call through a pointer
/// for each torque. It cannot be copied or compared; its effects are `Send + Sync` and own what
/// they use. A second gravity is refused when the list is made, not when it is built. A list may
/// contain another.
///
/// ```
/// use rotation_dynamics::attitude::Attitude;
/// use rotation_dynamics::body::RigidBody;
/// use rotation_dynamics::effects::{BoxedEffect, EffectList, GravityAtLever, ViscousFriction};
/// use rotation_dynamics::frame::BodyVector;
/// use rotation_dynamics::inertia::PrincipalMoments;
/// use rotation_dynamics::scene::Scene;
/// # fn main() -> rotation_dynamics::Result<()> {
/// let mut chosen: Vec<BoxedEffect> = Vec::new();
/// for name in ["gravity", "friction"] {
///     chosen.push(match name {
///         "gravity" => Box::new(GravityAtLever::new(4.9, 0.1)?),
///         _ => Box::new(ViscousFriction::about_axis(1e-5)?),
///     });
/// }
/// let body = RigidBody::new(PrincipalMoments::symmetric(5.45e-3, 9.0e-4)?);
/// let start = body.state(Attitude::IDENTITY, BodyVector::new(0.3, 0.0, 300.0))?;
/// let listed = Scene::new(body).with_list(EffectList::new(chosen)?);
/// let typed = Scene::new(body)
///     .with(GravityAtLever::new(4.9, 0.1)?)
///     .with(ViscousFriction::about_axis(1e-5)?);
/// assert_eq!(listed.solve(&start, 1.0, 1e-9)?, typed.solve(&start, 1.0, 1e-9)?);
/// # Ok(())
/// # }
/// ```
#[derive(Default)]
pub struct EffectList(Vec<BoxedEffect>);

/// An effect behind a pointer.
pub type BoxedEffect = Box<dyn AnyEffect + Send + Sync>;

impl EffectList {
    /// These effects together, in this order.
    ///
    /// # Errors
    /// [`Error::Incompatible`]: a body has one weight.
    pub fn new(effects: Vec<BoxedEffect>) -> Result<Self> {
        let list = Self(effects);
        let weights = list.0.iter().filter(|effect| effect.properties().weight);
        if weights.count() > 1 {
            return Err(Error::two_gravities(list.names().join(", ")));
        }
        Ok(list)
    }

    fn sum<T: core::ops::Add<Output = T>>(&self, zero: T, term: impl Fn(&BoxedEffect) -> T) -> T {
        self.0.iter().map(term).fold(zero, |sum, term| sum + term)
    }

    fn all<'e, T>(&'e self, of: impl Fn(&'e BoxedEffect) -> Vec<T>) -> Vec<T> {
        self.0.iter().flat_map(of).collect()
    }
}

impl fmt::Debug for EffectList {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("EffectList").field(&self.names()).finish()
    }
}

/// As pairs are effects, one after the other.
impl AnyEffect for EffectList {
    fn properties(&self) -> Properties {
        let natures = self.0.iter().map(|effect| effect.properties());
        natures.fold(Properties::NOTHING, Properties::and)
    }

    fn torque(&self, t: f64, body: &RigidBody, state: &State) -> SpaceVector {
        self.sum(SpaceVector::zero(), |effect| effect.torque(t, body, state))
    }

    fn torque_on_axis(&self, body: &RigidBody, axis: [f64; 3]) -> [f64; 3] {
        self.0.iter().fold([0.0; 3], |[a, b, c], effect| {
            let [d, e, f] = effect.torque_on_axis(body, axis);
            [a + d, b + e, c + f]
        })
    }

    fn resistance(&self, t: f64, body: &RigidBody) -> Option<Resistance> {
        self.0.iter().try_fold(Resistance::NONE, |all, effect| all.and(effect.resistance(t, body)?))
    }

    fn slip(&self, t: f64, body: &RigidBody, state: &State) -> SpaceVector {
        let slipping = self.0.iter().filter(|effect| effect.properties().slips);
        let slips = slipping.map(|effect| effect.slip(t, body, state));
        slips.reduce(|sum, slip| sum + slip).unwrap_or_else(SpaceVector::zero)
    }

    fn potential_energy(&self, t: f64, body: &RigidBody, state: &State) -> f64 {
        self.sum(0.0, |effect| effect.potential_energy(t, body, state))
    }

    fn power(&self, t: f64, body: &RigidBody, state: &State) -> f64 {
        self.sum(0.0, |effect| effect.power(t, body, state))
    }

    fn torque_scale(&self, t: f64, body: &RigidBody, state: &State) -> f64 {
        self.sum(0.0, |effect| effect.torque_scale(t, body, state))
    }

    fn torque_size(&self, t: f64, body: &RigidBody, state: &State) -> f64 {
        self.sum(0.0, |effect| effect.torque_size(t, body, state))
    }

    fn break_points(&self) -> Vec<f64> {
        self.all(|effect| effect.break_points())
    }

    fn narrowest(&self) -> Option<Feature> {
        (self.0.iter()).try_fold(Feature::WIDE, |all, effect| Some(all.and(effect.narrowest()?)))
    }

    fn integrable_case(&self) -> IntegrableCase {
        self.0.iter().fold(IntegrableCase::Free, |all, effect| all.and(effect.integrable_case()))
    }

    fn parts(&self) -> Vec<Part<'_>> {
        self.all(|effect| effect.parts())
    }

    fn names(&self) -> Vec<&'static str> {
        self.all(|effect| effect.names())
    }

    fn about_axis(&self) -> Vec<&'static str> {
        self.all(|effect| effect.about_axis())
    }

    fn holds_from(
        &self,
        t: f64,
        body: &RigidBody,
        start: &State,
        about_axis: &[&'static str],
    ) -> Result<()> {
        let holds = |effect: &BoxedEffect| effect.holds_from(t, body, start, about_axis);
        self.0.iter().try_for_each(holds)
    }
}
