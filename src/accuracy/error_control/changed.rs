//! A problem with every input a little changed, and how far that moves its motion.

use super::problem::{Distances, Problem};
use crate::accuracy::larger;
use crate::body::{RigidBody, State};
use crate::error::Result;
use crate::frame::{BodyVector, SpaceVector};
use crate::inertia::PrincipalMoments;
use crate::math::hypot;

/// Inputs that are changed: three of the attitude, three of the momentum, the strength
/// of the torque and three moments of inertia.
const INPUTS: usize = 10;

/// Signs with which the inputs are changed, run by run: the twelve rows of a design in which every
/// two columns are orthogonal. So the mean square of the changes that the rows make is the sum of
/// squares over the inputs, each changed alone. The mean over some of the rows is an estimate of
/// it.
///
/// R. L. Plackett, J. P. Burman, Biometrika 33, 305 (1946); for the estimate M. F.
/// Hutchinson, Commun. Stat. Simul. Comput. 19, 433 (1990).
pub(super) fn signs(row: usize) -> [f64; INPUTS] {
    const FIRST: [f64; 11] = [1.0, 1.0, -1.0, 1.0, 1.0, 1.0, -1.0, -1.0, -1.0, 1.0, -1.0];
    core::array::from_fn(|column| match row % ALL_ROWS {
        11 => -1.0,
        row => FIRST[(column + 11 - row) % 11],
    })
}

/// All rows: the sum of squares itself.
pub(super) const ALL_ROWS: usize = 12;

impl Problem<'_> {
    /// The row of the design whose push turns the body fastest. In a single change of all inputs,
    /// the effects of the three pushes, large for a small moment of inertia, must not cancel.
    pub(super) fn most_sensitive_row(&self) -> Result<usize> {
        let mut most = (0, 0.0);
        for row in 0..ALL_ROWS {
            let [_, _, _, x, y, z, ..] = signs(row);
            let pushed = State::new(self.start.attitude, SpaceVector::new(x, y, z))?;
            let rate = self.body.angular_velocity(&pushed).norm();
            if rate > most.1 {
                most = (row, rate);
            }
        }
        Ok(most.0)
    }

    /// Every input changed by `by`, up or down.
    pub(super) fn changed(&self, row: usize, by: f64) -> Result<Self> {
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
            PrincipalMoments::new(i1 * (1.0 + s1 * by), i2 * (1.0 + s2 * by), i3 * (1.0 + s3 * by))
        };
        // A flat body has no neighbours on one side, a thin one hardly any but larger and
        // smaller ones.
        let new = scaled(moments, by)
            .or_else(|_| scaled(moments, -by))
            .or_else(|_| scaled([moments[0]; 3], by))?;
        Ok(Self {
            body: RigidBody::new(new),
            strength: self.strength * (1.0 + strength * by),
            start: self.moved(&self.start, [a, b, c, x, y, z], by)?,
            ..*self
        })
    }

    /// A state turned about the body's axes by `by` (rad), and its momentum pushed by as much of
    /// its scale.
    pub(super) fn moved(
        &self,
        state: &State,
        [a, b, c, x, y, z]: [f64; 6],
        by: f64,
    ) -> Result<State> {
        let attitude = (state.attitude).turned_in_body(BodyVector::new(a, b, c) * by)?;
        State::new(
            attitude,
            state.angular_momentum
                + SpaceVector::new(x, y, z) * (by * self.momentum_scale(&self.start)),
        )
    }

    /// A state moved before an interval, by its number and the number of all.
    pub(super) fn moved_before(
        &self,
        state: &State,
        [interval, intervals]: [usize; 2],
        row: usize,
        by: f64,
    ) -> Result<State> {
        // So much less that on a regular motion all of them together count as much as
        // the change of the start.
        let on_the_way = 2.0 * by / (intervals as f64).sqrt();
        // Other signs every time, so that nothing is undone by the next.
        let [a, b, c, x, y, z, ..] = signs((row + 5 * interval) % ALL_ROWS);
        self.moved(state, [a, b, c, x, y, z], on_the_way)
    }

    /// By how much the places move per change of the inputs, and how far (rad) the attitude
    /// moved farthest.
    pub(super) fn slopes(
        &self,
        by: f64,
        places: &[State],
        changed: &[Vec<State>],
    ) -> (Distances, f64) {
        let mut slopes = [0.0; 3];
        let mut farthest: f64 = 0.0;
        for (n, place) in places.iter().enumerate() {
            let mut sum = [0.0; 3];
            for neighbour in changed {
                let apart = self.apart(place, &neighbour[n]);
                farthest = larger(farthest, apart[0]);
                for (sum, apart) in sum.iter_mut().zip(apart) {
                    *sum += (apart / by) * (apart / by);
                }
            }
            let late =
                self.body.angular_velocity(place).norm() * self.t_end.abs().max(self.t_start.abs());
            let rows = changed.len() as f64;
            for (slope, sum) in slopes.iter_mut().zip(sum) {
                *slope = larger(*slope, hypot((sum / rows).sqrt(), late));
            }
        }
        (slopes, farthest)
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
