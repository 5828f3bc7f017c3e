//! No effect, and two effects together.

use super::{Effect, Feature, IntegrableCase, Part, Properties, Resistance};
use crate::body::{RigidBody, State};
use crate::error::Result;
use crate::frame::SpaceVector;
use crate::math::Lane;

/// No effect.
impl Effect for () {
    const PROPERTIES: Properties = Properties::NOTHING;

    fn name(&self) -> &'static str {
        "nothing"
    }

    #[inline]
    fn torque(&self, _t: f64, _body: &RigidBody, _state: &State) -> SpaceVector {
        SpaceVector::zero()
    }

    #[inline(always)]
    fn torques_on_axis<L: Lane>(&self, _body: &RigidBody, _axis: [L; 3]) -> [L; 3] {
        [L::of(0.0); 3]
    }

    #[inline]
    fn torque_scale(&self, _t: f64, _body: &RigidBody, _state: &State) -> f64 {
        0.0
    }

    fn narrowest(&self) -> Option<Feature> {
        Some(Feature::WIDE)
    }

    fn integrable_case(&self) -> IntegrableCase {
        IntegrableCase::Free
    }

    fn parts(&self) -> Vec<Part<'_>> {
        Vec::new()
    }

    fn names(&self) -> Vec<&'static str> {
        Vec::new()
    }
}

/// Two effects together.
impl<A: Effect, B: Effect> Effect for (A, B) {
    const PROPERTIES: Properties = A::PROPERTIES.and(B::PROPERTIES);

    fn name(&self) -> &'static str {
        "two effects"
    }

    #[inline]
    fn torque(&self, t: f64, body: &RigidBody, state: &State) -> SpaceVector {
        self.0.torque(t, body, state) + self.1.torque(t, body, state)
    }

    #[inline(always)]
    fn torques_on_axis<L: Lane>(&self, body: &RigidBody, axis: [L; 3]) -> [L; 3] {
        let [a, b, c] = self.0.torques_on_axis(body, axis);
        let [d, e, f] = self.1.torques_on_axis(body, axis);
        [a + d, b + e, c + f]
    }

    /// Known if both are and their closed forms go together.
    fn resistance(&self, t: f64, body: &RigidBody) -> Option<Resistance> {
        (self.0.resistance(t, body)?).and(self.1.resistance(t, body)?)
    }

    #[inline(always)]
    fn slip(&self, t: f64, body: &RigidBody, state: &State) -> SpaceVector {
        match (A::PROPERTIES.slips, B::PROPERTIES.slips) {
            (false, false) => SpaceVector::zero(),
            (true, false) => self.0.slip(t, body, state),
            (false, true) => self.1.slip(t, body, state),
            (true, true) => self.0.slip(t, body, state) + self.1.slip(t, body, state),
        }
    }

    #[inline]
    fn potential_energy(&self, t: f64, body: &RigidBody, state: &State) -> f64 {
        self.0.potential_energy(t, body, state) + self.1.potential_energy(t, body, state)
    }

    fn power(&self, t: f64, body: &RigidBody, state: &State) -> f64 {
        self.0.power(t, body, state) + self.1.power(t, body, state)
    }

    #[inline]
    fn torque_scale(&self, t: f64, body: &RigidBody, state: &State) -> f64 {
        self.0.torque_scale(t, body, state) + self.1.torque_scale(t, body, state)
    }

    fn torque_size(&self, t: f64, body: &RigidBody, state: &State) -> f64 {
        self.0.torque_size(t, body, state) + self.1.torque_size(t, body, state)
    }

    fn break_points(&self) -> Vec<f64> {
        let mut all = self.0.break_points();
        all.extend(self.1.break_points());
        all
    }

    /// Known if both are.
    fn narrowest(&self) -> Option<Feature> {
        Some(self.0.narrowest()?.and(self.1.narrowest()?))
    }

    fn integrable_case(&self) -> IntegrableCase {
        self.0.integrable_case().and(self.1.integrable_case())
    }

    fn holds_from(
        &self,
        t: f64,
        body: &RigidBody,
        start: &State,
        about_axis: &[&'static str],
    ) -> Result<()> {
        self.0.holds_from(t, body, start, about_axis)?;
        self.1.holds_from(t, body, start, about_axis)
    }

    fn about_axis(&self) -> Vec<&'static str> {
        let mut all = self.0.about_axis();
        all.extend(self.1.about_axis());
        all
    }

    fn parts(&self) -> Vec<Part<'_>> {
        let mut all = self.0.parts();
        all.extend(self.1.parts());
        all
    }

    fn names(&self) -> Vec<&'static str> {
        let mut all = self.0.names();
        all.extend(self.1.names());
        all
    }
}
