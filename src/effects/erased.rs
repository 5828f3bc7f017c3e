//! An effect behind a pointer: what is written for it is compiled once for all effects.

use super::{Effect, Feature, Known, Nature, Resistance};
use crate::body::{RigidBody, State};
use crate::error::Result;
use crate::frame::SpaceVector;

/// What is asked of any effect, whatever its type.
pub(crate) trait AnyEffect {
    fn nature(&self) -> Nature;
    fn torque(&self, t: f64, body: &RigidBody, state: &State) -> SpaceVector;
    fn torque_on_axis(&self, body: &RigidBody, axis: [f64; 3]) -> [f64; 3];
    fn resistance(&self, t: f64, body: &RigidBody) -> Option<Resistance>;
    fn slip(&self, t: f64, body: &RigidBody, state: &State) -> SpaceVector;
    fn potential_energy(&self, t: f64, body: &RigidBody, state: &State) -> f64;
    fn power(&self, t: f64, body: &RigidBody, state: &State) -> f64;
    fn torque_scale(&self, t: f64, body: &RigidBody, state: &State) -> f64;
    fn torque_size(&self, t: f64, body: &RigidBody, state: &State) -> f64;
    fn break_points(&self) -> Vec<f64>;
    fn narrowest(&self) -> Option<Feature>;
    fn known(&self) -> Known;
    fn names(&self) -> Vec<&'static str>;
    fn holds_from(&self, t: f64, body: &RigidBody, start: &State) -> Result<()>;
}

impl<E: Effect> AnyEffect for E {
    fn nature(&self) -> Nature {
        E::NATURE
    }
    fn torque(&self, t: f64, body: &RigidBody, state: &State) -> SpaceVector {
        Effect::torque(self, t, body, state)
    }
    fn torque_on_axis(&self, body: &RigidBody, axis: [f64; 3]) -> [f64; 3] {
        self.torques_on_axis(body, axis)
    }
    fn resistance(&self, t: f64, body: &RigidBody) -> Option<Resistance> {
        Effect::resistance(self, t, body)
    }
    fn slip(&self, t: f64, body: &RigidBody, state: &State) -> SpaceVector {
        Effect::slip(self, t, body, state)
    }
    fn potential_energy(&self, t: f64, body: &RigidBody, state: &State) -> f64 {
        Effect::potential_energy(self, t, body, state)
    }
    fn power(&self, t: f64, body: &RigidBody, state: &State) -> f64 {
        Effect::power(self, t, body, state)
    }
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
    fn known(&self) -> Known {
        Effect::known(self)
    }
    fn names(&self) -> Vec<&'static str> {
        Effect::names(self)
    }
    /// Among all effects that this one is made of.
    fn holds_from(&self, t: f64, body: &RigidBody, start: &State) -> Result<()> {
        Effect::holds_from(self, t, body, start, &self.about_axis())
    }
}
