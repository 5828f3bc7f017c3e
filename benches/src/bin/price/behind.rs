//! An effect behind a pointer: every method is compiled once for all of them.

use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::{Effect, IntegrableCase, Properties, Resistance};
use rotation_dynamics::frame::SpaceVector;
use rotation_dynamics::math::Lane;
use rotation_dynamics::math::lane::WIDEST;

/// What a run asks of an effect, whatever its type.
pub trait AnyEffect {
    fn properties(&self) -> Properties;
    fn torque(&self, t: f64, body: &RigidBody, state: &State) -> SpaceVector;
    fn torque_on_axis(&self, body: &RigidBody, axis: [f64; 3]) -> [f64; 3];
    fn resistance(&self, t: f64, body: &RigidBody) -> Option<Resistance>;
    fn torque_scale(&self, t: f64, body: &RigidBody, state: &State) -> f64;
    fn integrable_case(&self) -> IntegrableCase;
}

impl<E: Effect> AnyEffect for E {
    fn properties(&self) -> Properties {
        E::PROPERTIES
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

    fn torque_scale(&self, t: f64, body: &RigidBody, state: &State) -> f64 {
        Effect::torque_scale(self, t, body, state)
    }

    fn integrable_case(&self) -> IntegrableCase {
        Effect::integrable_case(self)
    }
}

/// It, from the first to the last time of a piece.
pub struct Behind<'e> {
    pub effects: &'e dyn AnyEffect,
    pub piece: [f64; 2],
}

impl Behind<'_> {
    fn time(&self, t: f64) -> f64 {
        t.max(self.piece[0]).min(self.piece[1])
    }
}

impl Effect for Behind<'_> {
    const PROPERTIES: Properties = Properties::ANYTHING;

    fn name(&self) -> &'static str {
        "effects"
    }

    fn torque(&self, t: f64, body: &RigidBody, state: &State) -> SpaceVector {
        self.effects.torque(self.time(t), body, state)
    }

    fn torques_on_axis<L: Lane>(&self, body: &RigidBody, axis: [L; 3]) -> [L; 3] {
        let mut lanes = [[0.0; WIDEST]; 3];
        for (lanes, component) in lanes.iter_mut().zip(axis) {
            component.store(lanes);
        }
        for n in 0..L::WIDTH {
            let torque = self.effects.torque_on_axis(body, lanes.map(|lane| lane[n]));
            for (lane, component) in lanes.iter_mut().zip(torque) {
                lane[n] = component;
            }
        }
        lanes.map(|lane| L::load(&lane))
    }

    fn resistance(&self, t: f64, body: &RigidBody) -> Option<Resistance> {
        self.effects.resistance(self.time(t), body)
    }

    fn torque_scale(&self, t: f64, body: &RigidBody, state: &State) -> f64 {
        self.effects.torque_scale(t, body, state)
    }
}
