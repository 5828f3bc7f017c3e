//! What is to be solved, as given and with every input a little changed.

use super::Solvable;
use crate::body::{RigidBody, State};
use crate::effects::{Effect, Keeps};
use crate::error::Result;
use crate::frame::{BodyVector, SpaceVector};
use crate::inertia::PrincipalMoments;
use crate::math::{Lane, hypot};
use crate::scene::Scene;

/// A scene, its start and the end asked for.
pub(super) struct Problem<'e, E> {
    pub body: RigidBody,
    pub effects: &'e E,
    /// What multiplies the torque: 1, but for a change of it.
    pub strength: f64,
    pub start: State,
    pub t_end: f64,
}

/// The same effect with its torque multiplied.
pub(super) struct Strengthened<'e, E> {
    effects: &'e E,
    strength: f64,
}

impl<E: Solvable> Effect for Strengthened<'_, E> {
    const KEEPS: Keeps = E::KEEPS;

    #[inline]
    fn torque(&self, t: f64, body: &RigidBody, state: &State) -> SpaceVector {
        self.effects.torque(t, body, state) * self.strength
    }

    #[inline]
    fn potential_energy(&self, state: &State) -> f64 {
        self.effects.potential_energy(state) * self.strength
    }

    #[inline]
    fn torque_scale(&self) -> f64 {
        self.effects.torque_scale() * self.strength
    }
}

impl<E: Solvable> Solvable for Strengthened<'_, E> {
    const TORQUE_FREE: bool = E::TORQUE_FREE;
    const AXIS_ONLY: bool = E::AXIS_ONLY;
    const ANALYTIC: bool = E::ANALYTIC;

    #[inline(always)]
    fn torque_on_axis<L: Lane>(&self, axis: [L; 3]) -> [L; 3] {
        self.effects.torque_on_axis(axis).map(|m| m * self.strength)
    }
}

/// Inputs that are changed: three of the attitude, three of the momentum, the strength
/// of the torque and three moments of inertia.
const INPUTS: usize = 10;

/// Signs with which the inputs are changed, run by run: the twelve rows of a design in
/// which every two columns are orthogonal. So the mean square of the changes that the
/// rows make is the sum of the squares of those that each input would make alone; the
/// mean over some of the rows is an estimate of it.
///
/// R. L. Plackett, J. P. Burman, Biometrika 33, 305 (1946); for the estimate M. F.
/// Hutchinson, Commun. Stat. Simul. Comput. 19, 433 (1990).
fn signs(row: usize) -> [f64; INPUTS] {
    const FIRST: [f64; 11] = [1.0, 1.0, -1.0, 1.0, 1.0, 1.0, -1.0, -1.0, -1.0, 1.0, -1.0];
    core::array::from_fn(|column| {
        if row == 11 {
            -1.0
        } else {
            FIRST[(column + 11 - row) % 11]
        }
    })
}

/// The torque over the kinetic energy, below which a body is fast.
const FAST: f64 = 0.05;

/// All rows: the sum of squares itself.
pub(super) const ALL_ROWS: usize = 12;

/// How the condition is felt.
pub(super) struct Feeler {
    /// Relative changes that are tried, one after the other, until the end moves by
    /// little: a change that grows beyond that is no measure of a slope.
    pub changes: &'static [f64],
    /// An end moved by more than this (rad) has left the linear regime.
    pub linear: f64,
}

impl Feeler {
    /// For closed forms, whose rounding is all that blurs a small change.
    pub const EXACT: Self = Self {
        changes: &[1e-9, 1e-12],
        linear: 1e-4,
    };
    /// For stepping.
    pub const STEPPED: Self = Self {
        changes: &[1e-6, 1e-9, 1e-12],
        linear: 3e-3,
    };
}

impl<'e, E: Solvable> Problem<'e, E> {
    pub fn new(scene: &'e Scene<E>, start: &State, t_end: f64) -> Self {
        Self {
            body: *scene.body(),
            effects: scene.effects(),
            strength: 1.0,
            start: *start,
            t_end,
        }
    }

    /// The scene as the integrators see it.
    pub fn scene(&self) -> Scene<((), Strengthened<'e, E>)> {
        Scene::new(self.body).with(Strengthened {
            effects: self.effects,
            strength: self.strength,
        })
    }

    /// True if the torque changes little of the momentum in the time of a turn: then
    /// splittings for weak kicks are worth a try.
    pub fn is_fast(&self) -> bool {
        let turning = self.body.kinetic_energy(&self.start);
        self.effects.torque_scale() < FAST * turning
    }

    /// The size against which a change of the momentum counts: its length, or what the
    /// torques build up in the body's own time.
    fn momentum_scale(&self) -> f64 {
        let [i1, i2, i3] = self.body.moments().to_array();
        let built_up = (i1.max(i2).max(i3) * self.effects.torque_scale()).sqrt();
        self.start.angular_momentum.norm().max(built_up)
    }

    /// Every input changed by `by`, up or down.
    pub fn changed(&self, row: usize, by: f64) -> Result<Self> {
        self.changed_by(signs(row), by)
    }

    fn changed_by(
        &self,
        [a, b, c, x, y, z, strength, moments @ ..]: [f64; INPUTS],
        by: f64,
    ) -> Result<Self> {
        let old = self.body.moments();
        let scaled = |[s1, s2, s3]: [f64; 3], by: f64| {
            // A symmetric body stays one.
            let s2 = if old.is_symmetric() { s1 } else { s2 };
            let [i1, i2, i3] = old.to_array();
            PrincipalMoments::new(
                i1 * (1.0 + s1 * by),
                i2 * (1.0 + s2 * by),
                i3 * (1.0 + s3 * by),
            )
        };
        // A flat body has no neighbours on one side, a thin one hardly any but larger and
        // smaller ones.
        let new = scaled(moments, by)
            .or_else(|_| scaled(moments, -by))
            .or_else(|_| scaled([moments[0]; 3], by))?;
        Ok(Self {
            body: RigidBody::new(new),
            effects: self.effects,
            strength: self.strength * (1.0 + strength * by),
            start: self.moved(&self.start, [a, b, c, x, y, z], by)?,
            t_end: self.t_end,
        })
    }

    /// A state turned about the body's axes by `by` (rad), and its momentum pushed by as
    /// much of its scale.
    fn moved(&self, state: &State, [a, b, c, x, y, z]: [f64; 6], by: f64) -> Result<State> {
        State::new(
            (state.attitude).turned_in_body(BodyVector::new(a, b, c) * by)?,
            state.angular_momentum + SpaceVector::new(x, y, z) * (by * self.momentum_scale()),
        )
    }

    /// The motion in legs of equal time by `leg` (from a time and state to a time), with
    /// the state moved before each of them: what rounding does on the way.
    ///
    /// Moved by 0 it is the motion itself.
    pub fn in_legs(
        &self,
        row: usize,
        by: f64,
        legs: usize,
        mut leg: impl FnMut(&Self, f64, &State, f64) -> Result<State>,
    ) -> Result<State> {
        let problem = self.changed(row, by)?;
        let mut state = problem.start;
        // So much less that on a regular motion all of them together count as much as
        // the change of the start.
        let on_the_way = 2.0 * by / (legs as f64).sqrt();
        for k in 0..legs {
            if k > 0 {
                // Other signs every time, so that nothing is undone by the next.
                let [a, b, c, x, y, z, ..] = signs((row + 5 * k) % ALL_ROWS);
                state = problem.moved(&state, [a, b, c, x, y, z], on_the_way)?;
            }
            let (from, to) = (k as f64 / legs as f64, (k + 1) as f64 / legs as f64);
            state = leg(&problem, from * self.t_end, &state, to * self.t_end)?;
        }
        Ok(state)
    }

    /// The condition of the attitude at the end: by how much it changes (rad) per
    /// relative change of the inputs, as the root of the sum of squares over all of
    /// them and the time. `ends` tells where the motion ends, and where it ends with all
    /// inputs changed by so much, up or down by the signs of some rows.
    pub fn condition(
        &self,
        feeler: &Feeler,
        mut ends: impl FnMut(f64) -> Result<(State, Vec<State>)>,
    ) -> Result<f64> {
        let (mut slope, mut rate) = (f64::INFINITY, 0.0);
        for &by in feeler.changes {
            let (end, changed) = ends(by)?;
            let angles: Vec<f64> = (changed.iter())
                .map(|state| end.attitude.angle_to(&state.attitude))
                .collect();
            let sum: f64 = angles.iter().map(|angle| (angle / by) * (angle / by)).sum();
            slope = (sum / angles.len() as f64).sqrt();
            rate = self.body.angular_velocity(&end).norm();
            if angles.iter().all(|angle| *angle <= feeler.linear) {
                break;
            }
        }
        Ok(hypot(slope, rate * self.t_end))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_two_columns_of_the_design_are_orthogonal() {
        let mut pairs = 0;
        for i in 0..INPUTS {
            for j in 0..=i {
                let product: f64 = (0..ALL_ROWS).map(|row| signs(row)[i] * signs(row)[j]).sum();
                assert_eq!(product, if i == j { 12.0 } else { 0.0 }, "{i}, {j}");
                pairs += 1;
            }
        }
        assert_eq!(pairs, 55);
    }
}
