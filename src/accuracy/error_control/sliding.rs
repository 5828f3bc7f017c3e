//! Steps that collapse where the torque jumps with the state.

use super::problem::{Acting, Problem};
use crate::body::{RigidBody, State};
use crate::effects::erased::AnyEffect;
use crate::effects::{Effect, Properties};
use crate::error::Error;
use crate::frame::SpaceVector;
use crate::integrators::{Dop853, Integrator, Work};
use crate::scene::Scene;
use core::cell::Cell;

/// The tolerance of the run that is watched, and the most steps of it.
const TOLERANCE: f64 = 1e-9;
const STEPS: u64 = 20_000;

/// Torques in an accepted step, and one less in a rejected one.
const TORQUES: u64 = 12;

/// Jumps in a step of the whole run from which on the motion slides. It counts as sliding, too, if
/// it comes to rest: if the second half of the steps covers less than this part of the time that
/// the first half covers. (Measured: at least 0.27 jumps in a step where a motion slides late, and
/// up to 0.28 where jumps are crossed a hundred times in a turn: the number alone does not tell.)
const SOME: f64 = 0.1;
const STAND: f64 = 0.1;

/// Two states nearer than this (rad, and as a part of the momentum) whose torques differ by more
/// than this part are on two sides of a jump.
const BESIDE: f64 = 1e-6;
const JUMP: f64 = 1e-3;

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
        let limit = (budget / 24).clamp(1, STEPS);
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
        let method = Dop853::new(TOLERANCE).ok()?;
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
        (jumps_in_step > 1.0 || jumps_in_step > SOME && stands).then_some(t)
    }
}
