//! Steps that collapse where the torque jumps with the state.

use super::constants::{BESIDE, JUMP, SOME_JUMPS, STAND, WATCHED, WATCHED_STEPS};
use super::problem::{Acting, Problem};
use crate::body::{RigidBody, State};
use crate::effects::erased::AnyEffect;
use crate::effects::{Effect, Properties};
use crate::error::Error;
use crate::frame::SpaceVector;
use crate::integrators::{Dop853, Integrator, Work};
use crate::scene::Scene;
use core::cell::Cell;

/// Torques in an accepted step, and one less in a rejected one.
const TORQUES: u64 = 12;

/// A torque that counts how often it jumps from one call to the next, at one time, and notes the time
/// in the middle of its calls.
struct Watched<'e> {
    effects: &'e dyn AnyEffect,
    momentum: f64,
    before: Cell<State>,
    jumps: Cell<u64>,
    calls: Cell<u64>,
    middle: u64,
    time_in_middle: Cell<f64>,
}

impl Effect for Watched<'_> {
    const PROPERTIES: Properties = Properties::ANYTHING;

    fn name(&self) -> &'static str {
        "watched"
    }

    fn torque(&self, t: f64, body: &RigidBody, state: &State) -> SpaceVector {
        self.calls.set(self.calls.get() + 1);
        if self.calls.get() == self.middle {
            self.time_in_middle.set(t);
        }
        let before = self.before.replace(*state);
        let torque = self.effects.torque(t, body, state);
        let pushed = (state.angular_momentum - before.angular_momentum).norm();
        if state.attitude.angle_to(&before.attitude) < BESIDE && pushed < BESIDE * self.momentum {
            let beside = self.effects.torque(t, body, &before);
            if (torque - beside).norm() > JUMP * torque.norm().max(beside.norm()) {
                self.jumps.set(self.jumps.get() + 1);
            }
        }
        torque
    }
}

impl Problem<'_> {
    /// About the time at which the motion begins to slide along a jump of the torque with the state,
    /// which then is between two stages of every step. (Measured on switches of four kinds: 2 to 6 times
    /// in a step of the whole run; on a jump that is crossed once in a turn, never.)
    pub(super) fn slides(&self, budget: u64) -> Option<f64> {
        let Acting::Anything(effects) = self.acting else {
            return None;
        };
        if effects.properties().slips || self.has_laws() {
            return None;
        }
        let limit = (budget / 24).clamp(1, WATCHED_STEPS);
        let watched = Watched {
            effects,
            momentum: self.momentum_scale(&self.start),
            before: Cell::new(self.start),
            jumps: Cell::new(0),
            calls: Cell::new(0),
            middle: limit * TORQUES / 2,
            time_in_middle: Cell::new(f64::NAN),
        };
        let scene = Scene::new(self.body).with(watched);
        let method = Dop853::new(WATCHED).ok()?;
        let method = method.with_step_limit(limit).ok()?;
        let mut work = Work::default();
        let end =
            method.advance_counting(&scene, self.t_start, &self.start, self.span(), &mut work);
        let (Err(Error::LimitReached { t, .. }) | Err(Error::StepUnderflow { t, clock: None, .. })) =
            end
        else {
            return None;
        };
        let watched = &scene.effects().1;
        let jumps_in_step = watched.jumps.get() as f64 / (work.steps + work.rejected) as f64;
        let middle = watched.time_in_middle.get();
        let stands = (t - middle).abs() < STAND * (middle - self.t_start).abs();
        (jumps_in_step > 1.0 || jumps_in_step > SOME_JUMPS && stands).then_some(t)
    }
}
