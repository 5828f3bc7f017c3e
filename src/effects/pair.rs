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

macro_rules! sums {
    ($($name:ident -> $result:ty);+) => { $(
        #[inline]
        fn $name(&self, t: f64, body: &RigidBody, state: &State) -> $result {
            self.0.$name(t, body, state) + self.1.$name(t, body, state)
        }
    )+ };
}

macro_rules! joined {
    ($($name:ident -> $result:ty);+) => { $(
        fn $name(&self) -> $result {
            let mut all = self.0.$name();
            all.extend(self.1.$name());
            all
        }
    )+ };
}

/// Two effects together.
impl<A: Effect, B: Effect> Effect for (A, B) {
    const PROPERTIES: Properties = A::PROPERTIES.and(B::PROPERTIES);

    fn name(&self) -> &'static str {
        "two effects"
    }

    sums! { torque -> SpaceVector; potential_energy -> f64; power -> f64; torque_scale -> f64; torque_size -> f64 }
    joined! { break_points -> Vec<f64>; about_axis -> Vec<&'static str>; parts -> Vec<Part<'_>>; names -> Vec<&'static str> }

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
}
