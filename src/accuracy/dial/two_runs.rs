//! Two runs that mostly say everything: a coarse one with all inputs a little changed, and the
//! one that is returned.

use super::choice::Candidate;
use super::method::{LEVEL, Method, Steps};
use super::probes::{Begun, Felt, MOVED};
use super::problem::Problem;
use super::stepping::{Delivered, ROUNDED, Run, Stepping, is_final};
use super::verdict::{Gap, KINKED, OVER_KINKS, Verdict};
use crate::accuracy::larger;
use crate::error::Result;
use crate::integrators::{Method as Named, Work};
use crate::math::{EPS, exp, log};

/// The sweeps of the coarser may leave so many times as much.
const LOOSELY: f64 = 15.0;

/// The part of the error asked for that the sweeps of the finer may leave.
const LEFT: f64 = 0.1;

/// A floor that is bounded by two runs is below the tolerance by this factor.
const FAR_FROM: f64 = 20.0;

/// And that of a motion that is only late by this.
const FARTHER: f64 = 300.0;

/// Two runs that are allowed may be apart by little more than this part of what is allowed, in
/// units of what a change makes of a motion that is only late: such a motion passes no saddle.
const BOUNDED: f64 = 1.2;

/// By so many times that where finer runs follow: three say by themselves how the error falls, and
/// the condition need only leave the floor far below.
const WIDER: f64 = 30.0;

/// A change of the inputs makes no more on the stretch than so many times what it makes of a
/// motion that is only late.
const CHANGED: f64 = 2.0;

/// So many runs in the longest steps allowed must be affordable: what is done with all care, if a
/// pair says too little, is not to be refused for the sake of the pair.
const DEAR: f64 = 10.0;

/// So many pairs are begun.
const TRIES: usize = 4;

/// Beginning again has to save more than it takes by this factor.
const WORTH: f64 = 1.2;

/// Another method is taken where it is predicted to take less than this part.
const OTHER: f64 = 0.7;

/// What comes of two runs.
pub(super) enum TwoRuns {
    /// All that is asked.
    Delivered(Box<Delivered>),
    /// The finer one, from which to go on by so many levels.
    Begun {
        candidate: Candidate,
        begun: Box<Begun>,
        ahead: f64,
    },
    /// More has to be known.
    Unknown,
}

/// A pair on the stretch.
struct Pair {
    coarse: Run,
    fine: Run,
    precision: f64,
    /// The distance of the two there (rad).
    apart: f64,
}

/// A method, the level of its coarser run, and what both are predicted to cost.
#[derive(Clone, Copy)]
struct Guess {
    method: Method,
    level: f64,
    /// By how many levels the finer one is finer.
    behind: f64,
    cost: f64,
}

impl Stepping<'_> {
    /// Two runs of the span, the coarser of a problem with all inputs a little changed. Their
    /// distance holds the error of the coarser and what the change has made, and so bounds the
    /// error of the finer and the condition at once.
    ///
    /// A method and a level are taken from what methods did on many motions; both runs show on
    /// the first stretch whether that holds here, and go on from there if it does.
    pub(super) fn two_runs(&mut self) -> Result<TwoRuns> {
        // There a change may carry the motion past its own steepness, and a body that waits on its
        // axis, or on the upright, waits there after another number of turns as well.
        let exact = self.problem.exact_motion();
        if exact.is_some_and(|motion| motion.is_near_separatrix()) {
            return Ok(TwoRuns::Unknown);
        }
        let mut guesses = self.guesses();
        for left in (0..TRIES).rev() {
            guesses.sort_by(|a, b| a.cost.total_cmp(&b.cost));
            let Guess {
                method,
                level,
                behind,
                cost,
            } = guesses[0];
            let floor = method.floor(self.problem) * EPS * (1.0 + self.late());
            let least = method.torques() * (self.problem.span() / self.problem.longest_step).abs();
            let dear = DEAR * least > self.left(&Work::default())? as f64;
            if FARTHER * floor > self.tolerance || !cost.is_finite() || dear {
                return Ok(TwoRuns::Unknown);
            }
            let before = (self.work, self.cost);
            let pair = match self.pair(method, level, behind) {
                Err(error) if is_final(&error) => return Err(error),
                Err(_) => {
                    self.choice += self.work.since(&before.0);
                    guesses[0].cost = f64::INFINITY;
                    continue;
                }
                Ok(pair) => pair,
            };
            // What the runs are predicted to be apart at the end, and may be.
            let predicted = self.predicted(method, [level, behind], pair.apart.max(EPS));
            let aimed = method.aimed() * self.allowed(method, behind);
            let off = log(predicted / aimed) / (LEVEL * method.falls());
            let wanted = (level + off).max(method.coarsest_resolved(self.problem));
            let by = wanted - level;
            // As measured.
            let rest = (1.0 - self.part) / self.part * (self.cost - before.1);
            guesses[0].level = wanted;
            guesses[0].cost = (rest + self.cost - before.1) * method.dearer(by);
            let other = guesses[1..]
                .iter()
                .any(|guess| guess.cost < OTHER * guesses[0].cost);
            let again = predicted > 2.0 * aimed
                || other
                || rest * (1.0 - method.dearer(by))
                    > WORTH * (self.cost - before.1) * method.dearer(by);
            if again && left > 0 {
                self.choice += self.work.since(&before.0);
                continue;
            }
            return self.both_to_the_end(method, [level, behind], pair);
        }
        Ok(TwoRuns::Unknown)
    }

    /// How far two runs may be apart: where a third has to follow, by as much more as that is
    /// nearer.
    fn allowed(&self, method: Method, behind: f64) -> f64 {
        let factor = Verdict::factor(method.trust(), behind);
        let third = if self.may_have_kinks(method) {
            exp(OVER_KINKS * LEVEL * behind) / KINKED
        } else if self.problem.is_abrupt() {
            exp(method.falls() * LEVEL * behind)
        } else {
            1.0
        };
        (0.9 * self.tolerance / factor * third).min(MOVED)
    }

    /// How far two runs will be apart at the end that are so far apart on the stretch. What the
    /// change of the inputs makes grows with the time, whatever the method does; an error that it
    /// hides is what is expected, or less.
    fn predicted(&self, method: Method, [level, behind]: [f64; 2], apart: f64) -> f64 {
        if !method.is_adaptive() {
            return apart / self.part;
        }
        let late = 1.0 + self.part * self.late();
        let changed = apart.min(CHANGED * self.change(method, behind) * late);
        let mut error = apart - changed;
        if error < changed {
            error = method.expected_error(self.problem, level).min(changed);
        }
        (changed + error / method.grown(self.part)) / self.part
    }

    /// What the methods are predicted to cost.
    fn guesses(&self) -> Vec<Guess> {
        let turned = |method: Method| method.turned(self.problem, self.problem.span());
        let guess = |method: Method| {
            let (mut behind, mut level, mut aimed);
            behind = Method::BEHIND;
            let coarsest = method.coarsest_resolved(self.problem);
            loop {
                aimed = method.aimed()
                    * self.allowed(method, behind)
                    * self.part
                    * method.grown(self.part);
                level = method.expected_level(self.problem, aimed);
                // The coarsest may do, and then the finer one need not be much finer.
                if level >= coarsest || behind - 0.1 < method.least_behind() {
                    break;
                }
                behind -= 0.1;
            }
            let level = level.min(method.finest() - 2.0).max(coarsest);
            let digits = log(1.0 / (1e-2 * aimed)) / core::f64::consts::LN_10;
            let per_turned = |level| method.expected_cost(self.problem, level, digits);
            let cost = if coarsest > method.finest() - 2.0 {
                f64::INFINITY
            } else {
                turned(method) * (per_turned(level) + per_turned(level + behind))
            };
            Guess {
                method,
                level,
                behind,
                cost,
            }
        };
        Method::candidates(self.problem)
            .into_iter()
            .map(guess)
            .collect()
    }

    /// Both runs on the stretch.
    fn pair(&mut self, method: Method, level: f64, behind: f64) -> Result<Pair> {
        let precision = if method.sweeps() {
            let kept = self.swept(method, level + behind) * (1.0 + self.late());
            (LEFT * self.tolerance / kept).min(1e-4)
        } else {
            0.0
        };
        let times = self.times[..=self.stretch].to_vec();
        let by = self.change(method, behind);
        let row = self.problem.telling_row()?;
        let changed = self.problem.changed(row, by)?;
        let mut coarse = Run::default();
        let loosely = LOOSELY * precision;
        self.go_on(
            &changed,
            method,
            &mut coarse,
            &times,
            level,
            &[],
            loosely,
            Some((row, by)),
        )?;
        let finer = |leg: &Vec<Steps>| -> Vec<Steps> {
            leg.iter()
                .map(|steps| steps.finer(method, behind))
                .collect()
        };
        let fewest: Vec<Vec<Steps>> = coarse.steps.iter().map(finer).collect();
        let fine = self.run(method, &times, level + behind, &fewest, precision)?;
        let apart = self.distance(&coarse, &fine)[0];
        Ok(Pair {
            coarse,
            fine,
            precision,
            apart,
        })
    }

    /// By how much the inputs of the coarser one are changed.
    fn change(&self, method: Method, behind: f64) -> f64 {
        (method.change() * self.allowed(method, behind) / (1.0 + self.late())).min(1e-4)
    }

    /// Both runs through the whole span.
    fn both_to_the_end(
        &mut self,
        method: Method,
        [level, behind]: [f64; 2],
        pair: Pair,
    ) -> Result<TwoRuns> {
        let Pair {
            coarse,
            mut fine,
            precision,
            apart: on_stretch,
        } = pair;
        let late = self.late();
        let by = self.change(method, behind);
        if by < 64.0 * EPS {
            return Ok(TwoRuns::Unknown);
        }
        let candidate = Candidate {
            method,
            level: coarse.level,
            error: on_stretch.max(EPS) / method.grown(self.part),
            cost: method.cost(self.problem, &coarse.work),
        };
        let row = self.problem.telling_row()?;
        let changed = self.problem.changed(row, by)?;
        let times = self.times.clone();
        let rest = &times[self.stretch..];
        let both = || {
            let mut coarse = coarse;
            let loosely = LOOSELY * precision;
            self.go_on(
                &changed,
                method,
                &mut coarse,
                rest,
                level,
                &[],
                loosely,
                Some((row, by)),
            )?;
            let finer = |leg: &Vec<Steps>| -> Vec<Steps> {
                leg.iter()
                    .map(|steps| steps.finer(method, behind))
                    .collect()
            };
            let fewest: Vec<Vec<Steps>> = coarse.steps[self.stretch..].iter().map(finer).collect();
            // Steps are whole: the finer one is to be as much finer as was meant.
            let level = level.max(coarse.level) + behind;
            self.go_on(
                self.problem,
                method,
                &mut fine,
                rest,
                level,
                &fewest,
                precision,
                None,
            )?;
            Ok(coarse)
        };
        let coarse = match both() {
            Err(error) if is_final(&error) => return Err(error),
            Err(_) => return Ok(TwoRuns::Unknown),
            Ok(coarse) => coarse,
        };
        for (t, state) in &fine.passed {
            self.problem.checked.at(*t, state)?;
        }
        let step = fine.level - coarse.level;
        let apart = self.distance(&coarse, &fine);
        let expected = Some(on_stretch / self.part);
        let gaps = apart.map(|apart| Gap { apart, step });
        let verdict = |n: usize| Verdict::of(method.trust(), &gaps[n..=n], expected);
        let (conditions, farthest) =
            (self.problem).slopes(by, (fine.places.clone(), vec![coarse.places]));
        // Nor may they part on the way and meet again.
        let farthest = (fine.passed.iter().zip(&coarse.passed)).fold(farthest, |most, (a, b)| {
            larger(most, self.problem.apart(&a.1, &b.1)[0])
        });
        let sweeps = precision * self.swept(method, fine.level);
        let mut estimate = [0, 1, 2].map(|n| {
            verdict(n).estimate
                + (method.floor(self.problem) * EPS + sweeps) * (1.0 + conditions[n])
        });
        if method.is_adaptive() {
            estimate[0] += ROUNDED * EPS * fine.work.steps as f64;
        }
        let floor = method.floor(self.problem) * EPS * (1.0 + conditions[0]);
        let one_motion = farthest <= MOVED;
        let tame = |most: f64| {
            conditions[0] * method.change() <= most * (1.0 + late)
                && FAR_FROM * floor <= self.tolerance
        };
        let three = self.problem.is_abrupt();
        if one_motion && tame(BOUNDED) && !three && estimate[0] <= self.tolerance {
            let delivered = self.delivered(method, precision, fine, estimate, conditions);
            return Ok(TwoRuns::Delivered(Box::new(delivered)));
        }
        if !one_motion {
            return Ok(TwoRuns::Unknown);
        }
        let ahead = verdict(0).ahead(self.tolerance);
        let felt = Felt {
            condition: conditions,
            part: self.part,
            finely: false,
            roughly: true,
        };
        let begun = Box::new(Begun {
            run: fine,
            precision,
            bounded: tame(WIDER).then_some((felt, gaps)),
        });
        Ok(TwoRuns::Begun {
            candidate,
            begun,
            ahead,
        })
    }
}

impl Method {
    /// The part of its order by which its error falls with a level, as measured (`expected`).
    const fn falls(self) -> f64 {
        if self.is_adaptive() { 0.7 } else { 1.0 }
    }

    /// The part of the distance of two runs that is allowed, which the error of the coarser is to
    /// take: what a splitting does on the first turn tells best what it will do.
    const fn aimed(self) -> f64 {
        match self {
            Self::Split(_) | Self::Resisted(_) => 0.5,
            _ => 0.4,
        }
    }

    /// The part of the distance of two runs that a change of the inputs is to make, on a motion
    /// that is only late. The other part must not be as large, or the two may cancel: the error of
    /// Gauss-Legendre is mostly nothing, that of others is [`Method::aimed`].
    const fn change(self) -> f64 {
        if self.sweeps() { 0.1 } else { 0.01 }
    }

    /// By so many levels two runs are apart at least: more than what leaves half of the distance,
    /// since errors may pass through zero where the method comes into its order. (From level 1.0
    /// to 1.6 the error of SRKN 6b fell by 1.8 on one random top, where its order has 9.1.)
    const fn least_behind(self) -> f64 {
        match self {
            Self::Split(_) | Self::Resisted(_) => 0.9,
            Self::Adaptive | Self::SpinFreeAdaptive => 0.65,
            _ => 1.0,
        }
    }

    /// The logarithm to the base of 40 of the error (rad) that is expected on the first turn at
    /// level 0, and by how much more it falls with a level below 1: fits to 3042 trials on 300
    /// random motions of ten kinds, with the torque over the energy. They leave a standard deviation
    /// of 0.2 to 0.8 levels; for Gauss-Legendre, whose error is mostly nothing, of 1, and for DOP853
    /// in space on symmetric bodies, which follows the spin, of 1.2. The errors of DOP853 fall by
    /// seven tenths of a level.
    fn expected(self, problem: &Problem) -> [f64; 2] {
        let symmetric = problem.body.moments().is_symmetric();
        let torque = problem.torque / problem.body.kinetic_energy(&problem.start).max(1e-300);
        let torque = log(torque.clamp(1e-6, 1e3)) / LEVEL;
        let [at, with, bent] = match self {
            Self::FreeGauss | Self::Gauss | Self::SpinFreeGauss | Self::BodyGauss => {
                [-8.5, 0.0, 0.0]
            }
            Self::Adaptive if symmetric => [-2.9, 0.0, 0.0],
            Self::Adaptive => [-3.3, 0.0, 0.0],
            Self::SpinFreeAdaptive => [-3.5, 0.0, 0.0],
            Self::Split(named) | Self::Resisted(named) => match named {
                Named::Srkn6 if symmetric => [-2.6, 0.95, 0.7],
                Named::Srkn6 => [-2.9, 0.4, 0.6],
                Named::Srkn14 if symmetric => [-3.7, 0.85, 0.0],
                Named::Srkn14 => [-4.05, 0.0, 0.0],
                Named::Aba104 => [-1.7, 1.7, 0.25],
                _ => [-2.6, 1.55, 0.3],
            },
        };
        [at + with * torque, bent]
    }

    /// The level at which this error (rad) is expected on the first turn.
    fn expected_level(self, problem: &Problem, error: f64) -> f64 {
        let [at, bent] = self.expected(problem);
        let level = at - log(error) / LEVEL;
        if self.is_adaptive() {
            level / self.falls()
        } else if level < 1.0 {
            (level + bent) / (1.0 + bent)
        } else {
            level
        }
    }

    /// The error (rad) that is expected of an adaptive method on the first turn at this level.
    fn expected_error(self, problem: &Problem, level: f64) -> f64 {
        let [at, _] = self.expected(problem);
        exp(LEVEL * (at - self.falls() * level))
    }

    /// What a run is expected to cost per angle turned.
    fn expected_cost(self, problem: &Problem, level: f64, digits: f64) -> f64 {
        let torques = match self {
            Self::FreeGauss | Self::Gauss | Self::SpinFreeGauss | Self::BodyGauss => {
                5.6 * digits.max(4.0) / self.angle() * self.dearer(level)
            }
            Self::Split(named) | Self::Resisted(named) => {
                let kicks = named.scheme().map_or(7, |scheme| scheme.kicks()) as f64;
                kicks / self.angle() * self.dearer(level)
            }
            Self::Adaptive | Self::SpinFreeAdaptive => 8.0 * exp(level * LEVEL / 13.0),
        };
        let kicks = (1e6 * torques) as u64;
        1e-6 * self.cost(
            problem,
            &Work {
                kicks,
                ..Work::default()
            },
        )
    }
}
