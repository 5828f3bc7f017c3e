//! An effect behind a pointer: what is written for it is compiled once for all effects.

use super::{Effect, Feature, Keeps, Known, Nature, Resistance, each};
use crate::body::{RigidBody, State};
use crate::error::Result;
use crate::frame::SpaceVector;
use crate::math::Lane;

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

/// Effects behind a pointer as an effect again, so that methods are compiled once for all that
/// see the axis only (and, if `VERTICAL`, leave L_Z alone), for all that slip, and for all others.
/// On lanes one torque after the other: the same bits.
pub(crate) struct Behind<'e, const AXIS_ONLY: bool, const SLIPS: bool, const VERTICAL: bool>(
    pub &'e dyn AnyEffect,
);

impl<const AXIS_ONLY: bool, const SLIPS: bool, const VERTICAL: bool> Effect
    for Behind<'_, AXIS_ONLY, SLIPS, VERTICAL>
{
    const NATURE: Nature = Nature {
        axis_only: AXIS_ONLY,
        slips: SLIPS,
        keeps: Keeps {
            momentum: [false, false, VERTICAL],
            ..Keeps::NONE
        },
        ..Nature::ANYTHING
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

    fn slip(&self, t: f64, body: &RigidBody, state: &State) -> SpaceVector {
        self.0.slip(t, body, state)
    }

    fn torque_scale(&self, t: f64, body: &RigidBody, state: &State) -> f64 {
        self.0.torque_scale(t, body, state)
    }

    fn names(&self) -> Vec<&'static str> {
        self.0.names()
    }
}
