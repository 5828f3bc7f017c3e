//! The condition: by how much the motion moves per relative change of the inputs.

use super::constants::{CHANGED, COMPARED, FAR_BELOW, FINE_ENOUGH, MOST_COMPARED, REGULAR, ROWS};
use super::method::Method;
use super::problem::{Distances, Problem};
use super::refine::Refinement;
use super::run::{Fine, Run, Steps, Stop};
use crate::accuracy::larger;
use crate::body::State;
use crate::error::Result;
use crate::integrators::Work;
use crate::math::EPS;

/// How the condition is measured.
pub(super) struct Probe {
    /// Relative changes that are tried, one after the other, until the end moves by
    /// little: a change that grows beyond that is no measure of a slope.
    pub changes: &'static [f64],
    /// An end moved by more than this (rad) has left the linear regime.
    pub linear: f64,
    /// Within it, the slope is measured again with a change as small as this.
    pub again: Option<f64>,
}

impl Probe {
    /// For closed forms, whose rounding is all that blurs a small change.
    pub(super) const EXACT: Self =
        Self { changes: &[1e-9, 1e-12, 8.0 * EPS], linear: 1e-4, again: None };
    /// The same near a separatrix.
    pub(super) const STEEP: Self = Self { again: Some(16.0 * EPS), ..Self::EXACT };
    /// For stepping.
    pub(super) const STEPPED: Self =
        Self { changes: &[1e-6, 1e-9, 1e-12, 64.0 * EPS], linear: 3e-3, again: None };
}

impl Problem<'_> {
    /// The condition of the motion: the change per relative change of the inputs, as the root of
    /// the sum of squares over all of them and the time. It is taken at the place looked at where
    /// the motion changes most. `motions` tells where the motion is at those places, and where it
    /// is with all inputs changed by so much, up or down by the signs of some rows.
    ///
    /// Infinite if the smallest change that doubles hold is one too many, or does not account for how far
    /// the one before went.
    pub(super) fn condition(
        &self,
        probe: &Probe,
        mut motions: impl FnMut(f64) -> Result<(Vec<State>, Vec<Vec<State>>)>,
    ) -> Result<Distances> {
        let mut slopes_of = |by: f64| {
            let (places, changed) = motions(by)?;
            Ok(self.slopes(by, &places, &changed))
        };
        // A change may leave the end where all motions wait for a while, as a top does that has all but
        // stopped on the vertical: they gather there, and part again. So where a change went too far, the
        // next two are to tell the slopes, or the last if it accounts for half of how far that one went.
        let (mut too_far, mut waiting): (Option<f64>, Option<Distances>) = (None, None);
        for (n, &by) in probe.changes.iter().enumerate() {
            let (slopes, farthest) = slopes_of(by)?;
            if farthest.is_nan() || farthest > probe.linear {
                (too_far, waiting) = (Some(by), None);
                continue;
            }
            let is_last = n + 1 == probe.changes.len();
            let slopes = match (too_far, waiting) {
                (None, _) => slopes,
                (_, Some(waiting)) => larger_of(slopes, waiting),
                (Some(before), None) if is_last && 2.0 * farthest * before >= probe.linear * by => {
                    slopes
                }
                _ => {
                    waiting = Some(slopes);
                    continue;
                }
            };
            return match probe.again.filter(|again| *again < by) {
                // Near a separatrix a change may carry the motion past its own steepness.
                Some(again) => Ok(larger_of(slopes, slopes_of(again)?.0)),
                None => Ok(slopes),
            };
        }
        Ok([f64::INFINITY; 3])
    }
}

fn larger_of(a: Distances, b: Distances) -> Distances {
    [0, 1, 2].map(|n| larger(a[n], b[n]))
}

impl Refinement<'_> {
    /// True near a separatrix, as the closed form knows: there a change of the start may die away that
    /// would grow if it came later.
    pub(super) fn is_steep(&self) -> bool {
        let exact = self.problem.exact_motion();
        exact.is_some_and(|motion| motion.is_near_separatrix())
    }

    /// True if the floor is so far below the tolerance that the condition need not be known well: so
    /// much farther as the motion may pass a saddle.
    pub(super) fn is_far_below(&self, method: Method, condition: f64) -> bool {
        let saddle = (condition / (REGULAR * (1.0 + self.angle_turned()))).max(1.0);
        FAR_BELOW * saddle * self.floor(method, condition) < self.tolerance
    }

    /// The condition: by one change of all inputs in the steps of this run, or with care where the
    /// floor that this puts is neither far below the tolerance nor far above.
    pub(super) fn condition(&mut self, method: Method, run: &Run) -> Result<Distances> {
        if !self.is_steep() {
            let before = self.work;
            let slopes = self.slopes_by_one(method, run)?;
            self.probes += self.work.since(&before);
            // The push of a slender body about its thin axis outweighs all others.
            let is_known = |slopes: &Distances| {
                self.problem.is_slender()
                    || self.is_far_below(method, slopes[0])
                    || self.floor(method, slopes[0]) > FAR_BELOW * self.tolerance
            };
            if let Some(slopes) = slopes.filter(is_known) {
                return Ok(slopes);
            }
        }
        self.condition_with_care(method, run)
    }

    /// The slopes that one change of all inputs shows in the steps of this run, unless the motion goes too
    /// far by any.
    fn slopes_by_one(&mut self, method: Method, run: &Run) -> Result<Option<Distances>> {
        let row = self.problem.most_sensitive_row()?;
        let fewest: Vec<Steps> = run.steps.iter().map(|steps| steps.again(method)).collect();
        let level = if method.is_adaptive() { run.level } else { method.coarsest };
        for &by in &Probe::STEPPED.changes[1..] {
            let precision = CHANGED * by;
            let fine = Fine { level, precision, fewest: &fewest, budget: self.limits.budget };
            let changed = self.run(&self.problem.changed(row, by)?, method, fine)?;
            // Nor may they part on the way and meet again.
            let farthest = (run.passed.iter().zip(&changed.passed))
                .map(|(a, b)| self.problem.apart(&a.1.state, &b.1.state)[0])
                .fold(0.0, larger);
            if farthest <= Probe::STEPPED.linear {
                let changed = [self.places(&changed)];
                return Ok(Some(self.problem.slopes(by, &self.places(run), &changed).0));
            }
        }
        Ok(None)
    }

    /// The condition by some changes, with the state moved on the way as rounding does.
    fn condition_with_care(&mut self, method: Method, run: &Run) -> Result<Distances> {
        let problem = self.problem;
        // A motion a level coarser has the same condition.
        let level = if method.is_adaptive() { run.level.max(FINE_ENOUGH) } else { run.level - 1.0 };
        let turned = method.turned(problem, problem.span());
        let intervals = (turned / COMPARED).clamp(1.0, MOST_COMPARED) as usize;
        let mut work = Work::default();
        let condition = problem.condition(&Probe::STEPPED, |by| {
            // What the sweeps leave must not be mistaken for a change.
            let fine = Fine { level, precision: CHANGED * by, fewest: &[], budget: 0 };
            let places = self.moved(method, (0, 0.0), intervals, fine, &mut work)?;
            let changed =
                (0..ROWS).map(|row| self.moved(method, (row, by), intervals, fine, &mut work));
            Ok((places, changed.collect::<Result<_>>()?))
        });
        self.work += work;
        self.probes += work;
        condition
    }

    /// Where the motion is at the places looked at, its inputs changed by this row and so much, and
    /// its state moved before each of so many intervals of equal time.
    fn moved(
        &self,
        method: Method,
        (row, by): (usize, f64),
        intervals: usize,
        fine: Fine,
        work: &mut Work,
    ) -> Result<Vec<State>> {
        let problem = self.problem.changed(row, by)?;
        let mut stop = Stop::at(problem.start);
        let mut passed = Vec::with_capacity(intervals);
        for k in 0..intervals {
            if k > 0 {
                stop.state = problem.moved_before(&stop.state, [k, intervals], row, by)?;
            }
            let span = [k, k + 1].map(|k| problem.time_at(k, intervals));
            let budget = self.limits.left(self.work.torques() + work.torques())?;
            let run = method.run(&problem, span, &stop, Fine { budget, ..fine }, work);
            stop = run.map_err(|error| self.of_whole_span(error))?.end();
            passed.push(stop.state);
        }
        let is_everywhere = self.times.len() > 1;
        Ok(passed.split_off(if is_everywhere { 0 } else { intervals - 1 }))
    }
}
