//! The cost of a run, in deterministic counts.

use core::fmt;
use core::ops::{Add, AddAssign};

/// The cost of a run. The counts are the same on every machine; time is not.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Work {
    /// Evaluations of the derivative, each with one of the torque.
    pub derivatives: u64,
    /// Accepted steps.
    pub steps: u64,
    /// Steps tried and thrown away.
    pub rejected: u64,
    /// Evaluations of an exact flow (free rotation).
    pub flows: u64,
    /// Kicks, each with one evaluation of the torque.
    pub kicks: u64,
    /// Motions in closed form, set up and evaluated.
    pub samples: u64,
}

impl Work {
    /// Evaluations of the torque: those in derivatives and those in kicks.
    pub const fn torques(&self) -> u64 {
        self.derivatives + self.kicks
    }

    /// The work beyond `before`.
    pub(crate) const fn since(&self, before: &Self) -> Self {
        Self {
            derivatives: self.derivatives - before.derivatives,
            steps: self.steps - before.steps,
            rejected: self.rejected - before.rejected,
            flows: self.flows - before.flows,
            kicks: self.kicks - before.kicks,
            samples: self.samples - before.samples,
        }
    }
}

impl Add for Work {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self {
            derivatives: self.derivatives + other.derivatives,
            steps: self.steps + other.steps,
            rejected: self.rejected + other.rejected,
            flows: self.flows + other.flows,
            kicks: self.kicks + other.kicks,
            samples: self.samples + other.samples,
        }
    }
}

impl AddAssign for Work {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl fmt::Display for Work {
    /// The counts that are not zero: `38 steps, 4 rejected, 480 derivatives`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let counts = [
            (self.steps, "steps"),
            (self.rejected, "rejected"),
            (self.derivatives, "derivatives"),
            (self.flows, "exact flows"),
            (self.kicks, "kicks"),
            (self.samples, "closed forms"),
        ];
        let mut empty = true;
        for (count, name) in counts {
            if count > 0 {
                let comma = if empty { "" } else { ", " };
                write!(f, "{comma}{count} {name}")?;
                empty = false;
            }
        }
        if empty {
            write!(f, "no work")?;
        }
        Ok(())
    }
}
