//! Effects that go on in pieces: the values that a run holds of them from one time to the next.

use super::erased::AnyEffect;
use super::{Effect, Properties};
use crate::body::{RigidBody, State};
use crate::error::{Error, FINITE, Result};
use crate::frame::SpaceVector;
use core::ops::Deref;

/// An effect that goes on in pieces, each of them smooth: a command that is sampled and held, a
/// torque that switches with the state.
///
/// A run asks at its start for the values that are [`held`](Self::held), and again at every break
/// point and every [sample](Self::next_sample), also at those of other effects and the times of
/// `solve_at`. So a law that counts its samples looks at the time. Between them it steps the torque
/// of what is held, until the [`margin`](Self::margin) falls below 0. That time is located, and the
/// values [`beyond`](Self::beyond) it are held from there on. A run holds three numbers of the
/// law's own; the run remembers them, the law does not.
///
/// An [`Effect`] that is a law says so in [`Effect::parts`]. Its properties hold for the torque
/// while something is held; its own `torque` is what a sample or a switch just there would give.
pub trait Law {
    /// The values held from `t` (s) on, after `before`; at the start of a run `before` is `None`.
    fn held(&self, before: Option<[f64; 3]>, t: f64, body: &RigidBody, state: &State) -> [f64; 3];

    /// The torque on the fixed axes (N m) while this is held.
    fn torque_held(&self, held: [f64; 3], t: f64, body: &RigidBody, state: &State) -> SpaceVector;

    /// The time (s) of the first sample after `t`; infinite if there is none.
    fn next_sample(&self, _t: f64) -> f64 {
        f64::INFINITY
    }

    /// A function that is positive or zero as long as this is held; infinite if it is held to
    /// the next sample whatever happens.
    fn margin(&self, _held: [f64; 3], _t: f64, _body: &RigidBody, _state: &State) -> f64 {
        f64::INFINITY
    }

    /// The values held after this, where the margin has come to zero.
    fn beyond(&self, held: [f64; 3], _t: f64, _body: &RigidBody, _state: &State) -> [f64; 3] {
        held
    }
}

/// One of the effects that an effect is made of, and its law if it has one.
#[derive(Clone, Copy)]
pub struct Part<'e> {
    /// The effect.
    pub effect: &'e dyn AnyEffect,
    /// How it goes on in pieces.
    pub law: Option<&'e dyn Law>,
}

impl<'e> Part<'e> {
    /// An effect without a law.
    pub(crate) fn without_law(effect: &'e dyn AnyEffect) -> Self {
        Self { effect, law: None }
    }

    /// An effect that is a law.
    pub fn of<E: Effect + Law>(effect: &'e E) -> Self {
        Self { effect, law: Some(effect) }
    }
}

/// Effects on one piece of a run: their laws hold what they hold.
#[derive(Clone)]
pub(crate) struct Holding<'e> {
    whole: &'e dyn AnyEffect,
    /// None if there is no law among them.
    parts: Vec<Part<'e>>,
    /// For each part, if anything is held yet.
    pub(crate) held: Vec<[f64; 3]>,
}

impl<'e> Holding<'e> {
    pub(crate) fn new(whole: &'e dyn AnyEffect) -> Self {
        let mut parts = whole.parts();
        if parts.iter().all(|part| part.law.is_none()) {
            parts.clear();
        }
        Self { whole, parts, held: Vec::new() }
    }

    /// The laws, with their numbers among the parts.
    pub(crate) fn laws(&self) -> impl Iterator<Item = (usize, &'e dyn Law)> + '_ {
        (self.parts.iter().enumerate()).filter_map(|(n, part)| Some((n, part.law?)))
    }

    pub(crate) fn has_laws(&self) -> bool {
        !self.parts.is_empty()
    }

    /// The name of the part of this number.
    pub(crate) fn name_of(&self, part: usize) -> String {
        self.parts[part].effect.names().join(" and ")
    }

    /// The first name of that part.
    pub(crate) fn first_name(&self, part: usize) -> &'static str {
        self.parts[part].effect.names().first().copied().unwrap_or("law")
    }

    /// The first sample after `t`.
    pub(crate) fn next_sample(&self, t: f64) -> f64 {
        let samples = self.laws().map(|(_, law)| law.next_sample(t));
        samples.fold(f64::INFINITY, f64::min)
    }

    /// About how many samples there are between two times.
    pub(crate) fn samples(&self, [from, to]: [f64; 2]) -> f64 {
        let of_law = |(_, law): (usize, &dyn Law)| {
            let first = law.next_sample(from);
            let dt = law.next_sample(first) - first;
            if first < f64::INFINITY { (to - from).abs() / dt } else { 0.0 }
        };
        self.laws().map(of_law).sum()
    }

    /// Holds what every law holds from `t` on.
    pub(crate) fn hold(&mut self, t: f64, body: &RigidBody, state: &State) -> Result<()> {
        let before = core::mem::replace(&mut self.held, vec![[0.0; 3]; self.parts.len()]);
        for (n, part) in self.parts.iter().enumerate() {
            let Some(law) = part.law else { continue };
            let held = law.held(before.get(n).copied(), t, body, state);
            self.held[n] = held;
            if !held.iter().all(|h| h.is_finite()) {
                let state = [&state.attitude.quaternion()[..], &state.angular_momentum.to_array()];
                return Err(Error::of_function(
                    format!("torque of \"{}\"", self.name_of(n)),
                    t,
                    ("quaternion and momentum", state.concat()),
                    &held,
                    FINITE,
                ));
            }
        }
        Ok(())
    }

    /// The torque on the fixed axes (N m), of each law as it is held.
    pub(crate) fn torque(&self, t: f64, body: &RigidBody, state: &State) -> SpaceVector {
        if !self.has_laws() {
            return self.whole.torque(t, body, state);
        }
        let terms = self.parts.iter().zip(&self.held);
        terms.fold(SpaceVector::zero(), |sum, (part, held)| {
            sum + match part.law {
                Some(law) => law.torque_held(*held, t, body, state),
                None => part.effect.torque(t, body, state),
            }
        })
    }

    /// The rate at which that torque changes the energy (W).
    pub(crate) fn power(&self, t: f64, body: &RigidBody, state: &State) -> f64 {
        let omega = state.attitude.to_space(body.angular_velocity(state));
        let of = |effect: &dyn AnyEffect| effect.power(t, body, state);
        self.sum(t, body, state, of, |torque| torque.dot(&omega))
    }

    /// Its scale (N m).
    pub(crate) fn torque_scale(&self, t: f64, body: &RigidBody, state: &State) -> f64 {
        let of = |effect: &dyn AnyEffect| effect.torque_scale(t, body, state);
        self.sum(t, body, state, of, |torque| torque.norm())
    }

    /// The size that its rounding is a part of (N m).
    pub(crate) fn torque_size(&self, t: f64, body: &RigidBody, state: &State) -> f64 {
        let of = |effect: &dyn AnyEffect| effect.torque_size(t, body, state);
        self.sum(t, body, state, of, |torque| torque.norm())
    }

    /// The claims of effects; for laws, the claims of the torque that each holds.
    fn sum(
        &self,
        t: f64,
        body: &RigidBody,
        state: &State,
        of: impl Fn(&dyn AnyEffect) -> f64,
        of_held: impl Fn(SpaceVector) -> f64,
    ) -> f64 {
        if !self.has_laws() {
            return of(self.whole);
        }
        let terms = self.parts.iter().zip(&self.held);
        terms.fold(0.0, |sum, (part, held)| {
            sum + match part.law {
                Some(law) => of_held(law.torque_held(*held, t, body, state)),
                None => of(part.effect),
            }
        })
    }
}

/// All that the laws do not change is what the effects say.
impl<'e> Deref for Holding<'e> {
    type Target = dyn AnyEffect + 'e;
    fn deref(&self) -> &Self::Target {
        self.whole
    }
}

/// The held values, as an effect that can be stepped.
pub(crate) struct Held<'h, 'e>(pub &'h Holding<'e>);

impl Effect for Held<'_, '_> {
    const PROPERTIES: Properties = Properties { slips: true, ..Properties::ANYTHING };

    fn name(&self) -> &'static str {
        "effects"
    }

    fn torque(&self, t: f64, body: &RigidBody, state: &State) -> SpaceVector {
        self.0.torque(t, body, state)
    }

    fn slip(&self, t: f64, body: &RigidBody, state: &State) -> SpaceVector {
        self.0.slip(t, body, state)
    }
}
