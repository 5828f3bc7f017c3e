//! Where the torque on the body as it starts has a kink in time.

use super::{Checked, ROUNDING};
use crate::frame::SpaceVector;

/// After so many halvings of the time between two looks, by so many more it shows what bends the
/// torque: a kink is then bent less by 2^8, a power 3/2 by 2^12, what is smooth by 2^16, and what
/// jumps by no factor.
const BEFORE: usize = 2;
const HALVINGS: usize = 8;

/// What is bent less by so much, at the least and at the most, is a kink or a cusp. (In the middle of
/// a piece it is bent twice as much as at its quarter.)
const LEAST: f64 = 2.0;
const MOST: f64 = 16_384.0;

/// A piece of time that is halved, with the torque at both ends and in the middle.
#[derive(Clone, Copy)]
struct Piece {
    times: [f64; 3],
    torques: [SpaceVector; 3],
}

impl Piece {
    /// How far the middle is off the chord: the second difference.
    fn bend(&self) -> f64 {
        let [low, middle, high] = self.torques;
        (low - middle * 2.0 + high).norm()
    }

    /// Of its two halves, and the one in its middle, that which is bent most; none where doubles
    /// hold no times between.
    fn halved(&self, torque: impl Fn(f64) -> SpaceVector) -> Option<Self> {
        let [a, m, b] = self.times;
        let [low, middle, high] = self.torques;
        let (before, after) = (0.5 * (a + m), 0.5 * (m + b));
        if before == a || before == m || after == m || after == b {
            return None;
        }
        let (below, above) = (torque(before), torque(after));
        let halves = [
            ([a, before, m], [low, below, middle]),
            ([before, m, after], [below, middle, above]),
            ([m, after, b], [middle, above, high]),
        ];
        halves
            .map(|(times, torques)| Self { times, torques })
            .into_iter()
            .max_by(|one, other| one.bend().total_cmp(&other.bend()))
    }
}

impl Checked<'_> {
    /// The times at which the torque that was [looked at](Self::looked) has a kink, in the order of
    /// the motion.
    pub fn kinks(&self, seen: &[SpaceVector]) -> Vec<f64> {
        let looks = seen.len() - 1;
        let size = seen.iter().map(SpaceVector::norm).fold(0.0, f64::max);
        let piece = |n: usize| Piece {
            times: [n - 1, n, n + 1].map(|n| self.look(n, looks)),
            torques: [seen[n - 1], seen[n], seen[n + 1]],
        };
        let inside = 1..looks;
        let bend = |n: usize| {
            if inside.contains(&n) {
                piece(n).bend()
            } else {
                0.0
            }
        };
        let most = |n: &usize| {
            let here = bend(*n);
            here > bend(n - 1) && here >= bend(n + 1) && here > ROUNDING * size
        };
        (1..looks)
            .filter(most)
            .filter_map(|n| self.kink(piece(n), ROUNDING * size))
            .collect()
    }

    /// Halves the piece, towards what is bent most, until rounding is all that bends it: if it was
    /// bent less by about half each time, that is a kink.
    fn kink(&self, mut piece: Piece, rounding: f64) -> Option<f64> {
        let (mut first, mut halvings) = (piece.bend(), 0);
        while let Some(half) = piece.halved(|t| self.torque_at_start(t)) {
            let bend = half.bend();
            if bend <= rounding {
                break;
            }
            (piece, halvings) = (half, halvings + 1);
            if halvings == BEFORE {
                first = bend;
            }
            if halvings == BEFORE + HALVINGS && !(LEAST..=MOST).contains(&(first / bend)) {
                return None;
            }
        }
        (halvings >= BEFORE + HALVINGS).then_some(piece.times[1])
    }
}
