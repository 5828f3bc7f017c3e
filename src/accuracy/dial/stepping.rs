//! The dial of what must be stepped: choose, refine, verify.

use super::choice::{AIM, Candidate, Candidates};
use super::limits::Limits;
use super::method::{Fine, LEVEL, Method, Runs, Steps};
use super::probes::{Begun, Felt};
use super::problem::{Acting, Apart, Problem};
use super::slender::opposite_rows;
use super::two_runs::TwoRuns;
use super::verdict::{Gap, Verdict};
use crate::accuracy::larger;
use crate::body::State;
use crate::error::{Error, Result};
use crate::integrators::Work;
use crate::math::{EPS, log, sort_by_number};

/// The angle (rad) turned at the slowest candidate's rate on which a method shows what it does.
const STRETCH: f64 = core::f64::consts::TAU;

/// What follows is cut into so many legs at most, so that runs are compared on the way and the
/// coarser can be moved there.
const LEGS: f64 = 4.0;

/// A larger part of the span is all of it.
const SHORT: f64 = 0.6;

/// Runs whose predicted errors (rad) are larger than this may agree by chance.
const LINEAR: f64 = 0.5;

/// Runs that are so many times further apart than their errors on the stretch and the
/// condition of the motion predict are no runs of that motion.
const UNLIKE: f64 = 10.0;

/// By how much the inputs of two runs of a slender body are changed: by so little that an adaptive
/// method takes the same steps, and its error is in both.
const SLENDER_CHANGE: f64 = 1e-8;

/// The part of its order by which DOP853 is expected to fall: from 1e-8 to 1e-14 for a step it fell by
/// 1.0 to 1.1 of it on needles under a motor and the gravity gradient; a level too coarse costs a run.
const SLENDER_FALLS: f64 = 0.9;

/// The part of what is asked that the error of the coarser of two runs of a slender body is to be:
/// a level further on it is a part of 40^(0.33 0.7) = 2.3 of that at most.
const SLENDER_AIM: f64 = 0.5;

/// Runs further apart than this (rad) are none on which a condition may be felt.
const ELSEWHERE: f64 = 0.2;

/// The part of the error asked for that the sweeps of Gauss-Legendre may leave.
pub(super) const SWEEPS: f64 = 0.1;

/// What the sweeps leave of n steps is the condition times n times this, in units of the
/// precision: it is mostly on one side. Measured on 600 free bodies and tops over 30 to 30 000
/// steps: 0.0038 at most, whatever their number.
const SWEPT: f64 = 0.004;

/// What rounding adds to the attitude in a step of DOP853, in units of eps. Measured on
/// runs of up to a million steps: 0.15.
pub(super) const ROUNDED: f64 = 0.5;

/// An error that is reached, and no more than so many times the floor, is round-off.
const ROUND_OFF: f64 = 16.0;

/// Where a run was at the places looked at, at which level, and what it cost.
pub(super) struct Run {
    pub level: f64,
    pub places: Vec<State>,
    /// What it took on the pieces of the way to each place.
    pub steps: Vec<Vec<Steps>>,
    pub work: Work,
    longest_step: f64,
    /// Where it was between two pieces, and at the end.
    pub passed: Vec<(f64, State)>,
    /// The end as a slender body is stepped.
    on_body: Option<[f64; 7]>,
}

impl Default for Run {
    /// None yet.
    fn default() -> Self {
        Self {
            level: f64::INFINITY,
            places: Vec::new(),
            steps: Vec::new(),
            work: Work::default(),
            longest_step: 0.0,
            passed: Vec::new(),
            on_body: None,
        }
    }
}

/// What a run delivers.
pub(super) struct Delivered {
    pub method: Method,
    pub level: f64,
    pub precision: f64,
    /// The ends of its pieces.
    pub passed: Vec<(f64, State)>,
    pub steps: Vec<Vec<Steps>>,
    pub run: Work,
    pub work: Work,
    pub choice: Work,
    pub probes: Work,
    pub price: f64,
    /// Upper estimates of the three errors, at the place where each is largest.
    pub estimate: Apart,
    pub condition: Apart,
    pub longest_step: f64,
}

/// A run that delivered, or the least error that was reached; or runs that differ more than
/// the condition lets them.
enum Outcome {
    Delivered(Box<Delivered>),
    Reached(f64),
    Unlike,
}

pub(super) struct Stepping<'p> {
    pub problem: &'p Problem<'p>,
    pub tolerance: f64,
    limits: &'p Limits<'p>,
    /// Where the motion is looked at, from the start to the end.
    pub times: Vec<f64>,
    /// On so many legs between these a method shows what it does, and they are this part of
    /// the span.
    pub stretch: usize,
    pub part: f64,
    /// The motion is looked at all along, not at its end alone.
    pub everywhere: bool,
    pub work: Work,
    /// What of that went into the choice of the method, and into the condition.
    pub choice: Work,
    pub probes: Work,
    /// What all of it cost, in units of one derivative of DOP853.
    pub cost: f64,
}

impl<'p> Stepping<'p> {
    /// With the motion looked at in so many places, of equal distances; the end is the last.
    pub fn new(
        problem: &'p Problem<'p>,
        tolerance: f64,
        limits: &'p Limits<'p>,
        places: usize,
        trial: Work,
    ) -> Self {
        let slowest = (Method::candidates(problem).iter())
            .map(|method| method.rate(problem))
            .fold(f64::INFINITY, f64::min);
        let part = (STRETCH / (slowest * problem.span().abs())).min(1.0);
        let mut times: Vec<f64> = (0..=places).map(|n| problem.at_leg(n, places)).collect();
        let everywhere = places > 1;
        let (stretch, part) = if everywhere {
            let legs = (part * places as f64).ceil().clamp(1.0, places as f64);
            (legs as usize, legs / places as f64)
        } else if part < SHORT {
            let rest = (0.5 * (1.0 - part) / part).clamp(1.0, LEGS) as usize;
            times = vec![problem.t_start];
            for leg in 0..rest {
                let part = part + (1.0 - part) * leg as f64 / rest as f64;
                times.push(problem.t_start + part * problem.span());
            }
            times.push(problem.t_end);
            (1, part)
        } else {
            (1, 1.0)
        };
        Self {
            problem,
            tolerance,
            limits,
            times,
            stretch,
            part,
            everywhere,
            work: trial,
            choice: trial,
            probes: Work::default(),
            cost: trial.torques() as f64,
        }
    }

    /// Solves by two runs if they do, else by the cheapest candidate with the condition felt
    /// roughly, and else with all care. What few changes of the inputs put far out of reach is refused before.
    pub fn solve(mut self) -> Result<Delivered> {
        self.affordable()?;
        if self.problem.slender.is_some()
            && let Some(delivered) = self.slender_delivered()?
        {
            return Ok(self.paid(delivered));
        }
        let delivered = match self.two_runs()? {
            TwoRuns::Delivered(delivered) => Some(*delivered),
            TwoRuns::Begun {
                candidate,
                begun,
                ahead,
            } => self.roughly_delivered(&candidate, *begun, self.part, Some(ahead))?,
            TwoRuns::Unknown => None,
        };
        if let Some(delivered) = delivered {
            return Ok(self.paid(delivered));
        }
        let before = self.work;
        let candidates = self.candidates()?;
        self.choice += self.work.since(&before);
        let best = candidates.all[0];
        if let Some(begun) = self.begin(&best, candidates.wanted, candidates.part)?
            && let Some(delivered) = self.roughly_delivered(&best, begun, candidates.part, None)?
        {
            return Ok(self.paid(delivered));
        }
        self.carefully(candidates)
    }

    /// A slender body: runs that are each a level finer until two are of one motion, two more in the
    /// steps of the coarser with the start and the torque a little changed, which show the condition,
    /// and from there as few runs as deliver.
    fn slender_delivered(&mut self) -> Result<Option<Delivered>> {
        let method = Method::candidates(self.problem)[0];
        if !method.is_adaptive() {
            return Ok(None);
        }
        let times = self.times.clone();
        let before = self.work;
        let mut last = self.first(method, 0.0, 0.0)?;
        let (next, apart) = loop {
            let next = self.next(method, &times, &last, 1.0, 0.0)?;
            let apart = self.distance(&last, &next);
            if apart[0] < ELSEWHERE {
                break (next, apart);
            }
            if next.level + 1.0 > method.finest() {
                return Ok(None);
            }
            last = next;
        };
        self.choice += self.work.since(&before);
        let condition = self.slender_condition(method, &last)?;
        let floor = method.floor(self.problem) * EPS * (1.0 + condition[0]);
        if floor.is_nan() || floor >= self.tolerance {
            return Err(self.beyond(floor, condition[0]));
        }
        // The error of the coarser is the distance; that of the first run from here is to be this.
        let aim = SLENDER_AIM * (self.tolerance - floor);
        let level = last.level + log(apart[0].max(EPS) / aim) / (LEVEL * SLENDER_FALLS);
        let felt = Felt {
            condition,
            part: 1.0,
            finely: false,
            roughly: true,
        };
        let begin = |run, bounded| Begun {
            run,
            precision: 0.0,
            bounded,
        };
        let (first, error, begun) = if level <= next.level {
            let step = next.level - last.level;
            let gaps = apart.map(|apart| Gap { apart, step });
            let estimate = [0, 1, 2].map(|n| {
                let left = method.floor(self.problem) * (1.0 + condition[n]);
                let rounded = ROUNDED * next.work.steps as f64;
                Verdict::of(method.trust(), &gaps[n..=n], None).estimate + EPS * (left + rounded)
            });
            if estimate[0] <= self.tolerance && !self.problem.is_abrupt() {
                for (t, state) in &next.passed {
                    self.problem.checked.at(*t, state)?;
                }
                let delivered = self.delivered(method, 0.0, next, estimate, condition);
                return Ok(Some(delivered));
            }
            (last.level, apart[0], begin(next, Some((felt, gaps))))
        } else {
            let level = level.min(method.finest() - 1.0);
            (level, aim, begin(self.first(method, level, 0.0)?, None))
        };
        let candidate = Candidate {
            method,
            level: first,
            error: error.max(EPS),
            cost: method.cost(self.problem, &begun.run.work),
        };
        match self.deliver(&candidate, aim, &felt, Some(begun), Some(1.0))? {
            Outcome::Delivered(delivered) => Ok(Some(*delivered)),
            Outcome::Reached(reached) if reached < ROUND_OFF * floor => {
                Err(self.beyond(reached, condition[0]))
            }
            Outcome::Reached(reached) => Err(Error::NotDelivered {
                requested: self.tolerance,
                reached,
            }),
            Outcome::Unlike => Ok(None),
        }
    }

    /// The condition of a slender body's motion, by two runs in the steps of this one.
    fn slender_condition(&mut self, method: Method, run: &Run) -> Result<Apart> {
        let again = |leg: &Vec<Steps>| leg.iter().map(|steps| steps.again(method)).collect();
        let fewest: Vec<Vec<Steps>> = run.steps.iter().map(again).collect();
        let before = self.work;
        let mut changed = Vec::new();
        for row in opposite_rows(self.problem.body.moments().to_array()) {
            let problem = self.problem.changed(row, SLENDER_CHANGE)?;
            let times = self.times.clone();
            let run = self.run_of(&problem, method, &times, run.level, &fewest, 0.0)?;
            changed.push(run.places);
        }
        self.probes += self.work.since(&before);
        Ok((self.problem)
            .slopes(SLENDER_CHANGE, (run.places.clone(), changed))
            .0)
    }

    /// Refuses before any run what takes more torques than are allowed even in the longest steps
    /// that are.
    fn affordable(&self) -> Result<()> {
        let Problem {
            t_start: t,
            t_end,
            longest_step,
            ..
        } = *self.problem;
        let steps = (self.problem.span() / longest_step).abs();
        let cheapest = (Method::candidates(self.problem).iter())
            .map(|method| method.torques())
            .fold(f64::INFINITY, f64::min);
        let budget = self.limits.budget;
        if steps * cheapest > budget as f64 {
            return Err(Error::OverBudget { t, t_end, budget });
        }
        Ok(())
    }

    /// What a candidate delivers by few runs from the first on, with the condition felt on that
    /// unless it is known; `None` if more has to be known.
    fn roughly_delivered(
        &mut self,
        candidate: &Candidate,
        begun: Begun,
        part: f64,
        ahead: Option<f64>,
    ) -> Result<Option<Delivered>> {
        let felt = match begun.bounded {
            Some((felt, _)) => Some(felt),
            None => self.roughly(candidate.method, &begun, part)?,
        };
        let Some(felt) = felt else {
            return Ok(None);
        };
        let wanted = AIM * self.tolerance * part;
        match self.deliver(candidate, wanted, &felt, Some(begun), ahead) {
            Ok(Outcome::Delivered(delivered)) => Ok(Some(*delivered)),
            Err(error) if is_final(&error) => Err(error),
            _ => Ok(None),
        }
    }

    /// All candidates in turn, with the condition felt in many legs, each verified by three runs
    /// or more.
    fn carefully(&mut self, candidates: Candidates) -> Result<Delivered> {
        if !self.everywhere {
            // Where runs are near again at the end, how far they part on the way is known by the
            // condition.
            self.times = vec![self.problem.t_start, self.problem.t_end];
        }
        let before = self.work;
        let Candidates {
            all: mut candidates,
            untried,
            part,
            wanted,
            lowest,
        } = candidates;
        for method in untried {
            match self.tried(method, part) {
                Ok(candidate) => candidates.push(candidate),
                Err(error) if is_final(&error) => return Err(error),
                Err(_) => {}
            }
        }
        self.choice += self.work.since(&before);
        sort_by_number(&mut candidates, |candidate| candidate.cost(wanted));
        let mut felt = self.feel(&candidates, part, lowest)?;
        let (mut reached, mut last) = (f64::INFINITY, None);
        let mut untried = candidates.iter();
        let mut next = untried.next();
        while let Some(candidate) = next {
            let floor = lowest * EPS * (1.0 + felt.condition[0]);
            if floor.is_nan() || floor >= self.tolerance {
                return Err(self.beyond(floor, felt.condition[0]));
            }
            match self.deliver(candidate, wanted, &felt, None, None) {
                Ok(Outcome::Delivered(delivered)) => return Ok(self.paid(*delivered)),
                Ok(Outcome::Unlike) => {
                    felt = self.feel_finely(&candidates, part)?;
                    continue;
                }
                Ok(Outcome::Reached(error)) => {
                    reached = reached.min(error);
                    // They come to no end where they should.
                    if !felt.finely {
                        felt = self.feel_finely(&candidates, part)?;
                    }
                }
                Err(error) if is_final(&error) => return Err(error),
                Err(error) => last = Some(error),
            }
            next = untried.next();
        }
        let floor = lowest * EPS * (1.0 + felt.condition[0]);
        if floor.is_nan() || floor >= self.tolerance {
            return Err(self.beyond(floor, felt.condition[0]));
        }
        match last {
            // Near the floor, what runs differ by is round-off.
            _ if reached < ROUND_OFF * floor => Err(self.beyond(reached, felt.condition[0])),
            Some(error) if reached == f64::INFINITY => Err(error),
            _ => Err(Error::NotDelivered {
                requested: self.tolerance,
                reached,
            }),
        }
    }

    /// With what all runs cost.
    fn paid(&self, delivered: Delivered) -> Delivered {
        Delivered {
            work: self.work,
            choice: self.choice,
            probes: self.probes,
            price: self.cost / delivered.method.cost(self.problem, &delivered.run),
            ..delivered
        }
    }

    /// What a run delivers.
    pub fn delivered(
        &self,
        method: Method,
        precision: f64,
        run: Run,
        estimate: Apart,
        condition: Apart,
    ) -> Delivered {
        Delivered {
            method,
            level: run.level,
            precision,
            passed: run.passed,
            steps: run.steps,
            run: run.work,
            work: self.work,
            choice: self.choice,
            probes: self.probes,
            price: 1.0,
            estimate,
            condition,
            longest_step: run.longest_step,
        }
    }

    pub fn beyond(&self, attainable: f64, condition: f64) -> Error {
        Error::BeyondCondition {
            requested: self.tolerance,
            attainable,
            condition,
        }
    }

    /// What is left of the budget after all runs so far and this work, if the solution may go
    /// on.
    pub fn left(&self, more: &Work) -> Result<u64> {
        self.limits.left(self.work.torques() + more.torques())
    }

    /// One run through these times, with so many steps on each leg at least; its work is
    /// counted.
    pub fn run(
        &mut self,
        method: Method,
        times: &[f64],
        level: f64,
        fewest: &[Vec<Steps>],
        precision: f64,
    ) -> Result<Run> {
        self.run_of(self.problem, method, times, level, fewest, precision)
    }

    /// The same of a problem that is a little changed.
    pub fn run_of(
        &mut self,
        problem: &Problem,
        method: Method,
        times: &[f64],
        level: f64,
        fewest: &[Vec<Steps>],
        precision: f64,
    ) -> Result<Run> {
        let mut run = Run::default();
        self.go_on(
            problem, method, &mut run, times, level, fewest, precision, None,
        )?;
        Ok(run)
    }

    /// The same from where a run has come to, through the times after the first; `moved` before
    /// every leg, by a row of the design and so much.
    #[allow(clippy::too_many_arguments, reason = "a run and all that it is to be")]
    pub fn go_on(
        &mut self,
        problem: &Problem,
        method: Method,
        run: &mut Run,
        times: &[f64],
        level: f64,
        fewest: &[Vec<Steps>],
        precision: f64,
        moved: Option<(usize, f64)>,
    ) -> Result<()> {
        let mut state = *run.places.last().unwrap_or(&problem.start);
        for (n, leg) in times.windows(2).enumerate() {
            let gone = run.places.len();
            if let Some((row, by)) = moved
                && gone > 0
            {
                state = problem.moved_before(&state, [gone, self.times.len() - 1], row, by)?;
                run.on_body = None;
            }
            let fine = Fine {
                level,
                fewest: fewest.get(n).map_or(&[], Vec::as_slice),
                precision,
                budget: self.left(&Work::default())?,
            };
            let mut runs = Runs::default();
            let passed = method.run(
                problem,
                [leg[0], leg[1]],
                &state,
                run.on_body,
                fine,
                &mut runs,
            );
            self.work += runs.work;
            self.cost += method.cost(problem, &runs.work);
            let passed = passed.map_err(|error| self.over_budget(error))?;
            run.steps.push(runs.pieces);
            run.passed.append(&mut runs.passed);
            run.work += passed.work;
            run.level = run.level.min(passed.level);
            run.longest_step = run.longest_step.max(passed.longest_step);
            (state, run.on_body) = (passed.state, passed.on_body);
            run.places.push(state);
        }
        Ok(())
    }

    /// A budget that is used up is told as it was given, for the whole span.
    pub fn over_budget(&self, error: Error) -> Error {
        match error {
            Error::OverBudget { .. } => Error::OverBudget {
                t: self.problem.t_start,
                t_end: self.problem.t_end,
                budget: self.limits.budget,
            },
            error => error,
        }
    }

    /// The first run of the whole span, at this level or at the first finer one that
    /// comes to its end.
    pub fn first(&mut self, method: Method, level: f64, precision: f64) -> Result<Run> {
        self.first_of(self.problem, method, level, precision)
    }

    /// The same of a problem that is a little changed.
    pub fn first_of(
        &mut self,
        problem: &Problem,
        method: Method,
        level: f64,
        precision: f64,
    ) -> Result<Run> {
        let mut level = level;
        loop {
            match self.run_of(problem, method, &self.times.clone(), level, &[], precision) {
                Ok(run) => return Ok(run),
                Err(error) if stops(&error) => return Err(error),
                Err(error) if level + 1.0 > method.finest() => return Err(error),
                Err(_) => level += 1.0,
            }
        }
    }

    /// How far two runs are apart, each measure at the place where it is largest.
    pub fn distance(&self, a: &Run, b: &Run) -> Apart {
        let mut most = [0.0; 3];
        for (a, b) in a.places.iter().zip(&b.places) {
            for (most, apart) in most.iter_mut().zip(self.problem.apart(a, b)) {
                *most = larger(*most, apart);
            }
        }
        most
    }

    /// Refines until the runs agree as they must, or as they can. The error `wanted` on the
    /// stretch is predicted to deliver.
    fn deliver(
        &mut self,
        candidate: &Candidate,
        wanted: f64,
        felt: &Felt,
        begun: Option<Begun>,
        next: Option<f64>,
    ) -> Result<Outcome> {
        let (method, level) = (candidate.method, candidate.level(wanted));
        let highest = method.finest();
        let conditions = felt.condition;
        let condition = conditions[0];
        let floors =
            conditions.map(|condition| method.floor(self.problem) * EPS * (1.0 + condition));
        let floor = floors[0];
        if floor.is_nan() || floor >= self.tolerance {
            return Ok(Outcome::Reached(floor));
        }
        // What the sweeps leave of a step grows like any error, and those of many steps add
        // up: it must stay far below.
        let swept = self.swept(method, level);
        let mut precision = if method.sweeps() {
            (SWEEPS * (self.tolerance - floor) / (swept * (1.0 + condition))).min(1e-6)
        } else {
            0.0
        };
        let left = |precision: f64| floor + precision * swept * (1.0 + condition);
        let mut budget = self.tolerance - left(precision);
        let linear = candidate.level(LINEAR / (1.0 + condition));
        // Three runs, unless the condition is felt on the first of two.
        let behind = if felt.roughly { Method::BEHIND } else { 2.0 };
        let coarse = (level - behind).max(linear);
        let coarse = coarse.clamp(method.coarsest(), highest - 2.0);
        let mut next = next.filter(|_| begun.is_some());
        let mut gaps = [const { Vec::new() }; 3];
        let first = match begun {
            Some(begun)
                if begun.bounded.is_some()
                    || begun.run.level >= linear && begun.precision <= 2.0 * precision =>
            {
                // Of two that are followed at once the distance holds what their sweeps left, and
                // the third has smaller ones where these were too large.
                if begun.precision <= 2.0 * precision {
                    precision = begun.precision;
                    budget = self.tolerance - left(precision);
                }
                if let Some((_, apart)) = begun.bounded {
                    gaps = apart.map(|gap| vec![gap]);
                }
                begun.run
            }
            _ => {
                next = None;
                self.first(method, coarse, precision)?
            }
        };
        let mut runs = vec![first];
        // Two runs may do, of what is smooth and does not wait for its time.
        let two = felt.roughly && !self.problem.is_abrupt();
        let expected = two.then(|| candidate.error(runs[0].level) / felt.part);
        let more = if two { 0.0 } else { 1.0 };
        let ahead = (level - more - runs[0].level).clamp(0.5, 2.0);
        let mut ahead = next.unwrap_or(ahead);
        let (mut best, mut stuck) = (f64::INFINITY, 0);
        loop {
            let last = &runs[runs.len() - 1];
            if stuck > 1 && precision > 0.0 {
                // It may be the sweeps that differ.
                (precision, stuck) = (0.0, 0);
                budget = self.tolerance - left(precision);
            } else if last.level + 0.1 >= highest || stuck > 2 {
                // What the sweeps left of the best may be gone now; what was not verified is not
                // said to be reached.
                return Ok(Outcome::Reached((best + floor).max(self.tolerance)));
            }
            // Two runs may be near by chance, however far their distance is below what is asked.
            let (enough, room) = if two || !gaps[0].is_empty() {
                (true, highest - last.level)
            } else {
                (false, 0.5 * (highest - last.level))
            };
            ahead = ahead.min(room);
            let next = self.next(method, &self.times.clone(), last, ahead, precision)?;
            let step = next.level - last.level;
            let apart = self.distance(last, &next);
            let stretches = candidate.error(last.level) / felt.part;
            let predicted = left(precision) + stretches * (1.0 + condition);
            // A torque that depends on the time may not have been there on the stretch.
            let told = !felt.finely && !self.problem.acting.on_time();
            let elsewhere = felt.roughly && apart[0] > ELSEWHERE;
            if elsewhere || told && apart[0] > UNLIKE * predicted {
                return Ok(Outcome::Unlike);
            }
            for (gaps, apart) in gaps.iter_mut().zip(apart) {
                gaps.push(Gap { apart, step });
            }
            runs.push(next);
            let verdict_on = if self.may_have_kinks(method) {
                Verdict::over_kinks
            } else {
                Verdict::of
            };
            let mut verdict = verdict_on(method.trust(), &gaps[0], expected);
            let steps = runs[runs.len() - 1].work.steps as f64;
            if method.is_adaptive() {
                verdict.estimate += ROUNDED * EPS * steps;
            }
            if enough && verdict.estimate <= budget {
                let run = runs.swap_remove(runs.len() - 1);
                let [_, momentum, rates] = [0, 1, 2].map(|n| {
                    verdict_on(method.trust(), &gaps[n], expected).estimate
                        + floors[n]
                        + precision * swept * (1.0 + conditions[n])
                });
                let estimate = [verdict.estimate + left(precision), momentum, rates];
                let delivered = self.delivered(method, precision, run, estimate, conditions);
                return Ok(Outcome::Delivered(Box::new(delivered)));
            }
            if enough {
                stuck = if verdict.estimate < 0.5 * best {
                    0
                } else {
                    stuck + 1
                };
                best = best.min(verdict.estimate);
            }
            ahead = verdict.ahead(budget);
        }
    }

    /// True if steps of this method may pass over kinks of the torque: others are taken only where it
    /// is smooth between break points.
    pub fn may_have_kinks(&self, method: Method) -> bool {
        matches!(self.problem.acting, Acting::Anything(_)) && method.is_adaptive()
    }

    /// What the sweeps of a run of this level leave, in units of the precision.
    pub fn swept(&self, method: Method, level: f64) -> f64 {
        1.0 + SWEPT * method.steps(self.problem, self.problem.span(), level)
    }

    /// A run finer by so many levels, and by one step at least on every piece.
    pub fn next(
        &mut self,
        method: Method,
        times: &[f64],
        last: &Run,
        ahead: f64,
        precision: f64,
    ) -> Result<Run> {
        let finer = |leg: &Vec<Steps>| leg.iter().map(|steps| steps.finer(method, ahead)).collect();
        let fewest: Vec<Vec<Steps>> = last.steps.iter().map(finer).collect();
        self.run(method, times, last.level + ahead, &fewest, precision)
    }
}

/// True of errors that no other method would mend.
pub(super) const fn is_final(error: &Error) -> bool {
    matches!(
        error,
        Error::Cancelled { .. } | Error::Contradiction { .. } | Error::NotAFunction { .. }
    )
}

/// True of errors that no finer run would mend.
pub(super) const fn stops(error: &Error) -> bool {
    is_final(error) || matches!(error, Error::OverBudget { .. })
}
