//! The error control of what must be stepped: a run with its inputs a little changed, then finer runs, until
//! the distance of the last two is small enough.
//!
//! The numbers in [`Refinement::refine`] are those of the page `book/src/how_error_control.md`.

use super::constants::{CHANGED, FAR_BELOW, KINKED, LEVEL, MOST_LEVELS, SAFETY, STUCK};
use super::limits::Limits;
use super::method::Method;
use super::problem::{Acting, Distances, Problem};
use super::run::{Fine, Run, Steps, Stop};
use crate::accuracy::larger;
use crate::body::State;
use crate::error::{Error, Result};
use crate::integrators::Work;
use crate::math::{EPS, exp, expm1, log};

/// The result of a run.
pub(super) struct Delivered {
    pub method: Method,
    pub run: Run,
    pub work: Work,
    pub probes: Work,
    /// Upper estimates of the three errors, at the place where each is largest.
    pub estimate: Distances,
    pub condition: Distances,
}

/// The runs of one solution.
pub(super) struct Refinement<'p> {
    pub problem: &'p Problem<'p>,
    pub tolerance: f64,
    pub limits: &'p Limits<'p>,
    /// Where runs are compared: among the ends of their pieces, and the end.
    pub times: &'p [f64],
    pub work: Work,
    /// The part of it for the condition.
    pub probes: Work,
}

impl<'p> Refinement<'p> {
    /// Nothing has been run.
    pub(super) fn new(
        problem: &'p Problem<'p>,
        tolerance: f64,
        limits: &'p Limits<'p>,
        times: &'p [f64],
    ) -> Self {
        Self { problem, tolerance, limits, times, work: Work::default(), probes: Work::default() }
    }

    /// The run of the first method that delivers.
    ///
    /// # Errors
    /// A fault that no method mends; else the least error that was reached, or why the last came to
    /// no end.
    pub(super) fn solve(mut self) -> Result<Delivered> {
        let methods = Method::candidates(self.problem, self.tolerance);
        self.affordable(methods)?;
        let (mut best, mut why) = (f64::INFINITY, None);
        for method in methods {
            match self.refine(*method) {
                Err(error) if stops(&error) => return Err(error),
                Err(error @ Error::NotDelivered { best: reached, .. }) => {
                    if why.is_none() || reached < best {
                        (best, why) = (reached, Some(error));
                    }
                }
                Err(error) => why = why.or(Some(error)),
                delivered => return delivered,
            }
        }
        Err(why.unwrap_or(self.not_delivered(best)))
    }

    /// Refuses before any run what takes more torques than are allowed even in the longest steps
    /// that are.
    fn affordable(&self, methods: &[Method]) -> Result<()> {
        let problem = self.problem;
        let samples = problem.checked.holding().samples([problem.t_start, problem.t_end]);
        let steps = (problem.span() / problem.longest_step).abs().max(samples);
        let cheapest = (methods.iter()).map(|method| method.torques());
        let cheapest = cheapest.fold(f64::INFINITY, f64::min);
        if steps * cheapest > self.limits.budget as f64 {
            return Err(self.over_budget());
        }
        Ok(())
    }

    /// The angle (rad) turned at the fastest rate: by so much a relative change of the time moves the
    /// end.
    pub(super) fn angle_turned(&self) -> f64 {
        self.problem.fastest() * self.problem.span().abs()
    }

    /// The least error that a motion of this condition leaves.
    pub(super) fn floor(&self, method: Method, condition: f64) -> f64 {
        method.floor * EPS * (1.0 + condition)
    }

    /// Runs of one method, finer and finer until one delivers.
    fn refine(&mut self, method: Method) -> Result<Delivered> {
        // 1. The first run, its inputs a little changed.
        let mut change = self.first_change(method);
        let mut coarse = self.first(method, change)?;
        // Where steps are short for another reason than the rotation, their order begins later.
        let later = if method.is_adaptive() { 0.0 } else { coarse.level + MOST_LEVELS + 1.0 };
        let finest = method.finest.max(later);
        let (mut condition, mut before): (Option<Distances>, Option<Distances>) = (None, None);
        let (mut ahead, mut stuck) = (1.0, 0);
        let (mut nearest, mut reached) = (f64::INFINITY, f64::INFINITY);
        loop {
            // 2. A finer run.
            let fine = self.finer(method, &coarse, ahead)?;
            // 3. Their distance.
            let apart = self.distance(&coarse, &fine);
            if let Some(by) = change.take() {
                let (slopes, _) =
                    self.problem.slopes(by, &self.places(&fine), &[self.places(&coarse)]);
                condition = self.is_far_below(method, slopes[0]).then_some(slopes);
            }
            let step = fine.level - coarse.level;
            let counted = self.counted(method.falls, apart, before, step);
            let error = counted.map_or([f64::INFINITY; 3], |all| all.map(|n| SAFETY * n));
            // 4. The condition, where the distance does not show it.
            if condition.is_none() && error[0] <= self.tolerance {
                condition = Some(self.condition(method, &fine)?);
            }
            // 5. The floor, and what else no finer run takes away.
            let left = match condition {
                Some(condition) => self.left(method, &fine, condition)?,
                None => [0.0; 3],
            };
            // 6. The estimate.
            let estimate = [0, 1, 2].map(|n| error[n] + left[n]);
            if let Some(condition) = condition
                && estimate[0] <= self.tolerance
            {
                return self.delivered(method, fine, estimate, condition);
            }
            reached = reached.min(estimate[0]);
            // 7. Finer.
            stuck = if apart[0] < 0.5 * nearest { 0 } else { stuck + 1 };
            nearest = nearest.min(apart[0]);
            if stuck == STUCK || fine.level + 0.1 >= finest {
                return Err(self.refused(method, &fine, condition, reached));
            }
            let budget = 0.5 * (self.tolerance - left[0]).max(EPS);
            let wanted = log(SAFETY * apart[0] / budget) / (LEVEL * method.falls);
            // Where three runs count, one more is to have room.
            let room = (finest - fine.level) / if self.may_have_kinks() { 2.0 } else { 1.0 };
            ahead = wanted.clamp(1.0, MOST_LEVELS).min(room.max(0.0));
            (coarse, before) = (fine, Some(apart));
        }
    }

    /// A relative change of the inputs that moves the end of a motion that is only late by some hundredths
    /// of the tolerance.
    fn small_change(&self) -> f64 {
        CHANGED * self.tolerance / (1.0 + self.angle_turned())
    }

    /// The change of the inputs of the first run, where its distance from the second can show both the
    /// error and the condition.
    fn first_change(&self, method: Method) -> Option<f64> {
        let by = self.small_change();
        let floor = self.floor(method, 0.5 * self.tolerance / by);
        (!self.is_steep() && FAR_BELOW * floor < self.tolerance).then_some(by)
    }

    /// The error of rounding, whatever the distance of two runs is.
    fn left(&self, method: Method, run: &Run, condition: Distances) -> Result<Distances> {
        let floor = self.floor(method, condition[0]);
        if floor.is_nan() || floor >= self.tolerance {
            return Err(self.beyond(floor, condition[0]));
        }
        let rounded = method.rounded * EPS * run.work.steps as f64;
        Ok(condition.map(|condition| self.floor(method, condition) + rounded))
    }

    /// Why finer runs come no nearer: the condition, which is measured if it is not known, or the method.
    fn refused(
        &mut self,
        method: Method,
        run: &Run,
        known: Option<Distances>,
        reached: f64,
    ) -> Error {
        let condition = match known.map_or_else(|| self.condition(method, run), Ok) {
            Ok([condition, ..]) => condition,
            Err(error) if stops(&error) => return error,
            Err(_) => return self.not_delivered(reached),
        };
        let floor = self.floor(method, condition);
        if floor >= self.tolerance {
            self.beyond(floor, condition)
        } else if reached < FAR_BELOW * floor {
            self.beyond(reached, condition)
        } else {
            self.not_delivered(if known.is_some() { reached } else { reached + floor })
        }
    }

    /// The distance of two runs as it counts, the second finer by so many levels. If an error falls
    /// by x, its rest is x/(1 - x) of the distance: all of it at most where x is a half. Over what
    /// may have kinks, with the distance of the two before.
    fn counted(
        &self,
        falls: f64,
        apart: Distances,
        before: Option<Distances>,
        levels: f64,
    ) -> Option<Distances> {
        let left = (1.0 / expm1(falls * levels * LEVEL)).max(1.0);
        if !self.may_have_kinks() {
            return Some(apart.map(|apart| left * apart));
        }
        let (before, fallen) = (before?, exp(log(KINKED) * levels));
        Some([0, 1, 2].map(|n| SAFETY * larger(left * apart[n], before[n] / fallen)))
    }

    /// True if nothing is said of how smooth the torque is.
    const fn may_have_kinks(&self) -> bool {
        matches!(self.problem.acting, Acting::Anything(_))
    }

    /// The answer, unless an effect was seen to be another than it says.
    fn delivered(
        &self,
        method: Method,
        run: Run,
        estimate: Distances,
        condition: Distances,
    ) -> Result<Delivered> {
        let checked = self.problem.checked;
        let passed: Vec<_> = (run.passed.iter().map(|(t, stop)| (*t, stop.state))).collect();
        for (t, state) in &passed {
            checked.at(*t, state)?;
        }
        checked.remembers_nothing(&passed)?;
        Ok(Delivered { method, work: self.work, probes: self.probes, run, estimate, condition })
    }

    fn not_delivered(&self, reached: f64) -> Error {
        Error::NotDelivered { requested: self.tolerance, best: reached, condition: None }
    }

    fn beyond(&self, attainable: f64, condition: f64) -> Error {
        Error::NotDelivered {
            requested: self.tolerance,
            best: attainable,
            condition: Some(condition),
        }
    }

    fn over_budget(&self) -> Error {
        Error::LimitReached {
            what: "torques",
            t: self.problem.t_start,
            t_end: self.problem.t_end,
            limit: self.limits.budget,
        }
    }

    /// A budget that is used up is told as it was given, for the whole span.
    pub(super) fn of_whole_span(&self, error: Error) -> Error {
        match error {
            Error::LimitReached { .. } => self.over_budget(),
            error => error,
        }
    }

    /// The first run, its inputs changed if that is asked for: as fine as is expected to do, or at the
    /// first finer level that comes to its end.
    fn first(&mut self, method: Method, change: Option<f64>) -> Result<Run> {
        let problem = match change {
            Some(by) => &self.problem.changed(self.problem.most_sensitive_row()?, by)?,
            None => self.problem,
        };
        let most = method.finest - if self.may_have_kinks() { 2.0 } else { 1.0 };
        let level = method.level_for(self.problem, self.tolerance / SAFETY);
        let mut level = level.min(most);
        // What the sweeps leave is then below what the change of the inputs does.
        let precision = self.small_change();
        loop {
            let fine = Fine { level, fewest: &[], precision, budget: self.limits.budget };
            match self.run(problem, method, fine) {
                Err(error) if !stops(&error) && level + 1.0 < method.finest => level += 1.0,
                run => return run,
            }
        }
    }

    /// A run finer by so many levels, and by one step at least on every piece.
    fn finer(&mut self, method: Method, coarse: &Run, ahead: f64) -> Result<Run> {
        let finer = |steps: &Steps| steps.finer(method, ahead);
        let fewest: Vec<Steps> = coarse.steps.iter().map(finer).collect();
        let (level, budget) = (coarse.level + ahead, self.limits.budget);
        // So what the sweeps leave falls as the rest of the error does, and the distance shows both.
        let precision = coarse.precision * exp(-LEVEL * ahead);
        self.run(self.problem, method, Fine { level, fewest: &fewest, precision, budget })
    }

    /// A run of the whole span within what is left of the budget; its work is counted.
    pub(super) fn run(&mut self, problem: &Problem, method: Method, fine: Fine) -> Result<Run> {
        let budget = self.limits.left(self.work.torques())?;
        let (span, start) = ([problem.t_start, problem.t_end], Stop::at(problem.start));
        let run = method.run(problem, span, &start, Fine { budget, ..fine }, &mut self.work);
        run.map_err(|error| self.of_whole_span(error))
    }

    /// Where a run was at the places where runs are compared.
    pub(super) fn places(&self, run: &Run) -> Vec<State> {
        let is_compared = |(t, _): &&(f64, Stop)| self.times.contains(t);
        run.passed.iter().filter(is_compared).map(|(_, stop)| stop.state).collect()
    }

    /// How far two runs are apart, each measure at the place where it is largest.
    fn distance(&self, a: &Run, b: &Run) -> Distances {
        let mut most = [0.0; 3];
        for (a, b) in self.places(a).iter().zip(&self.places(b)) {
            for (most, apart) in most.iter_mut().zip(self.problem.apart(a, b)) {
                *most = larger(*most, apart);
            }
        }
        most
    }
}

/// True of errors that no finer run and no other method would mend.
pub(super) const fn stops(error: &Error) -> bool {
    matches!(
        error,
        Error::Cancelled { .. }
            | Error::Contradiction { .. }
            | Error::LimitReached { .. }
            | Error::NotDelivered { condition: Some(_), .. }
    )
}
