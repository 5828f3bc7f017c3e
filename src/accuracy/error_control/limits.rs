//! The limits of a solution, beside its scene, start, end and tolerance.

use super::constants::{STEPS_IN_PULSE, STEPS_OVER_JUMPS};
use crate::effects::erased::AnyEffect;
use crate::effects::{Checked, UNNAMED, is_same};
use crate::error::{Error, Result, finite, positive};
use crate::frame::SpaceVector;
use crate::math::sort_by_number;
use core::sync::atomic::{AtomicBool, Ordering};

/// Where a solution begins, which times it must not step over, and its largest cost.
///
/// ```
/// use rotation_dynamics::accuracy::Limits;
/// let limits = Limits { t_start: 2.0, budget: 1_000_000, ..Limits::default() };
/// assert_eq!(limits.longest_step, f64::INFINITY);
/// ```
#[derive(Debug, Clone, Copy)]
pub struct Limits<'a> {
    /// The time of the start (s): 0.
    pub t_start: f64,
    /// Times (s, rising, inside the span) at which the torque jumps, beside those that the
    /// effects name: none. Runs are cut there. They do not help an effect that is called smooth
    /// and jumps: smooth is what it is between the break points that it names itself.
    pub break_points: &'a [f64],
    /// No step is longer than this (s): infinite.
    pub longest_step: f64,
    /// The most torques that all runs together may take: 5e7, some seconds.
    pub budget: u64,
    /// Looked at before every run: once it is true, the solution ends with
    /// [`Error::Cancelled`].
    pub cancel: Option<&'a AtomicBool>,
}

impl Default for Limits<'_> {
    fn default() -> Self {
        Self {
            t_start: 0.0,
            break_points: &[],
            longest_step: f64::INFINITY,
            budget: 50_000_000,
            cancel: None,
        }
    }
}

impl Limits<'_> {
    /// The limits, if they are numbers and belong to a solution that ends at `t_end`.
    pub(in crate::accuracy) fn checked(&self, t_end: f64) -> Result<()> {
        finite("start time", self.t_start)?;
        finite("end time", t_end)?;
        finite("end time - start time", t_end - self.t_start)?;
        if self.longest_step != f64::INFINITY {
            positive("longest step", self.longest_step)?;
        }
        if self.budget == 0 {
            return Err(Error::out_of_range("budget", 0.0, "at least 1 torque"));
        }
        crate::effects::rising("break point", self.break_points)?;
        let (first, last) = (self.t_start.min(t_end), self.t_start.max(t_end));
        match self.break_points.iter().find(|t| !(first..=last).contains(t)) {
            None => Ok(()),
            Some(&t) => Err(Error::OutsideRun { t, start: first, end: last }),
        }
    }

    /// The rest of the budget after so many torques, if the solution may go on.
    pub(super) fn left(&self, torques: u64) -> Result<u64> {
        if (self.cancel).is_some_and(|cancel| cancel.load(Ordering::Relaxed)) {
            return Err(Error::Cancelled { torques });
        }
        Ok(self.budget.saturating_sub(torques))
    }

    /// All times inside the span at which the torque jumps, in the order of the motion.
    pub(in crate::accuracy) fn breaks(&self, effects: &dyn AnyEffect, t_end: f64) -> Vec<f64> {
        let mut all = effects.break_points();
        all.extend(self.break_points);
        self.sorted(all, t_end)
    }

    /// Those of these times that are inside the span, in the order of the motion.
    pub(super) fn sorted(&self, mut all: Vec<f64>, t_end: f64) -> Vec<f64> {
        let (first, last) = (self.t_start.min(t_end), self.t_start.max(t_end));
        let is_end = |t: f64| is_same(first, t) || is_same(last, t);
        all.retain(|t| first < *t && *t < last && !is_end(*t));
        sort_by_number(&mut all, |t| *t);
        all.dedup_by(|t, before| is_same(*before, *t));
        if t_end < self.t_start {
            all.reverse();
        }
        all
    }

    /// The longest step that passes over no feature that is named, nor a pulse that was
    /// seen; `rate` (rad/s) bounds how fast the body turns.
    pub(super) fn longest_step(
        &self,
        effects: &dyn AnyEffect,
        checked: &Checked,
        seen: &[SpaceVector],
        rate: f64,
        t_end: f64,
    ) -> f64 {
        let mut longest = self.longest_step;
        match effects.narrowest() {
            Some(width) => {
                longest = longest.min(width.time / STEPS_IN_PULSE);
                if rate > 0.0 {
                    longest = longest.min(width.angle / rate / STEPS_IN_PULSE);
                }
            }
            None if effects.properties().on_time => {
                let span = (t_end - self.t_start).abs();
                if let Some(looks) = checked.looks_in_step(seen) {
                    longest = longest.min(span / UNNAMED * looks as f64);
                }
                if !effects.properties().smooth {
                    longest = longest.min(span / STEPS_OVER_JUMPS);
                }
            }
            None => {}
        }
        longest
    }
}
