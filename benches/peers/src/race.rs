//! A race: every contestant's cheapest settings, timed in turn.

use crate::contest::{Ladder, OURS, Setting, contestants};
use crate::dense::{self, samplers};
use crate::problem::Problem;
use crate::search::{Outcome, search};
use benches::timing::{Task, interleaved};
use rotation_dynamics::attitude::Attitude;
use std::hint::black_box;

/// The errors to be reached at the end (rad).
pub const TARGETS: [f64; 4] = [1e-3, 1e-6, 1e-9, 1e-11];

/// Variables in which a method takes this much longer than in its best are not timed again.
const HOPELESS: f64 = 1.6;

/// Time for one race (s).
const BUDGET: f64 = 6.0;

/// A line of a race: a method at an error.
#[derive(Debug, Clone, PartialEq)]
pub struct Line {
    /// The crate; `-` for this library.
    pub peer: &'static str,
    /// The crate and its method.
    pub name: String,
    /// The variables.
    pub form: &'static str,
    /// Which of the targets.
    pub target: usize,
    /// The setting.
    pub setting: Setting,
    /// The error delivered (rad).
    pub error: f64,
    /// The median time of a run (s).
    pub seconds: f64,
    /// The median of its ratio to the closed form in the same round, or to our fastest run at
    /// the largest error where there is no closed form.
    pub ratio: f64,
    /// The quartiles of that ratio.
    pub quartiles: [f64; 2],
}

impl Line {
    /// Whether it is this library's.
    pub fn is_ours(&self) -> bool {
        self.peer == OURS
    }

    /// Whether it is the closed form.
    pub fn is_exact(&self) -> bool {
        self.setting == Setting::Exact
    }
}

/// Who never reached a target, and how near they came.
#[derive(Debug, Clone, PartialEq)]
pub struct Failure {
    /// The crate and its method.
    pub name: String,
    /// The largest target that was not reached.
    pub target: usize,
    /// The least error seen (rad).
    pub least: f64,
    /// Whether it was the time that ended the search.
    pub impatient: bool,
}

/// A race, run.
#[derive(Debug, Clone, PartialEq)]
pub struct Race {
    /// The names in order, this library's first.
    pub names: Vec<String>,
    /// The fastest line of each name and target.
    pub lines: Vec<Line>,
    /// Those who failed somewhere.
    pub failures: Vec<Failure>,
    /// How many rounds there were.
    pub rounds: usize,
}

impl Race {
    /// The line of `name` at a target.
    pub fn line(&self, name: &str, target: usize) -> Option<&Line> {
        let mut lines = self.lines.iter();
        lines.find(|line| line.name == name && line.target == target)
    }

    /// The fastest of those lines at `target` for which `counts` holds.
    pub fn fastest(&self, target: usize, counts: impl Fn(&Line) -> bool) -> Option<&Line> {
        let lines = self.lines.iter().filter(|line| line.target == target);
        let counted = lines.filter(|line| counts(line));
        counted.min_by(|one, other| one.ratio.total_cmp(&other.ratio))
    }
}

/// One who races: what it is, and how to run it.
struct Runner {
    peer: &'static str,
    name: String,
    form: &'static str,
    ladder: Ladder,
    run: Box<dyn Fn(Setting) -> Result<(), String>>,
    measure: Box<dyn Fn(Setting) -> Result<f64, String>>,
}

/// The race to the end of `problem`.
///
/// # Errors
/// A closed form that misses a target; a run that fails the second time.
pub fn to_the_end(problem: &'static Problem) -> Result<Race, String> {
    let all = contestants(problem).map_err(|e| e.to_string())?;
    let runners = all.into_iter().map(|contestant| {
        let name = contestant.name();
        let run = std::rc::Rc::new(contestant.run);
        let same = run.clone();
        Runner {
            peer: contestant.peer,
            name,
            form: contestant.form,
            ladder: contestant.ladder,
            run: Box::new(move |setting| {
                let end: Attitude = run(setting)?;
                black_box(end);
                Ok(())
            }),
            measure: Box::new(move |setting| {
                let end = same(setting)?;
                problem.error(&end).map_err(|e| e.to_string())
            }),
        }
    });
    race(&runners.collect::<Vec<_>>(), problem, TARGETS)
}

/// The race to dense output of `problem`.
///
/// # Errors
/// As [`to_the_end`].
pub fn along_the_way(problem: &'static Problem) -> Result<Race, String> {
    let all = samplers(problem).map_err(|e| e.to_string())?;
    let runners = all.into_iter().map(|sampler| {
        let name = sampler.name();
        let (run, error) = (std::rc::Rc::new(sampler.run), sampler.error);
        let same = run.clone();
        Runner {
            peer: sampler.peer,
            name,
            form: sampler.form,
            ladder: match sampler.adaptive {
                true => Ladder::Tolerances,
                false => Ladder::Exact,
            },
            run: Box::new(move |setting| run(setting)),
            measure: Box::new(move |setting| same(setting).and_then(|()| error())),
        }
    });
    race(&runners.collect::<Vec<_>>(), problem, dense::TARGETS)
}

/// What all times are compared with: the closed form, or where there is none our fastest run
/// that reaches the largest error.
fn base(runners: &[Runner], outcomes: &[Outcome]) -> Result<(usize, Setting, f64), String> {
    if runners.first().is_some_and(|first| first.ladder == Ladder::Exact) {
        return Ok((0, Setting::Exact, 0.0));
    }
    let ours = (0..runners.len()).filter(|&n| runners[n].peer == OURS);
    let reached = ours.filter_map(|n| {
        let found = outcomes[n].found[0]?;
        Some((n, found.setting, found.seconds))
    });
    let fastest = reached.min_by(|one, other| one.2.total_cmp(&other.2));
    fastest.ok_or_else(|| "none of ours reaches the largest error".to_owned())
}

fn race(runners: &[Runner], problem: &Problem, targets: [f64; 4]) -> Result<Race, String> {
    let mut names: Vec<String> = Vec::new();
    for runner in runners {
        if !names.contains(&runner.name) {
            names.push(runner.name.clone());
        }
    }
    let outcomes: Vec<Outcome> = runners
        .iter()
        .map(|runner| search(runner.ladder, problem, targets, &*runner.measure))
        .collect();

    // What is timed: first what all are compared with, then whatever may be the fastest of its
    // name at some target.
    let mut timed: Vec<(usize, Setting, f64)> = vec![base(runners, &outcomes)?];
    for target in 0..targets.len() {
        for name in &names {
            let of_name = || (0..runners.len()).filter(|&n| &runners[n].name == name);
            let found = |n: usize| outcomes[n].found[target];
            let least =
                of_name().filter_map(|n| Some(found(n)?.seconds)).fold(f64::INFINITY, f64::min);
            for n in of_name() {
                let Some(found) = found(n).filter(|f| f.seconds <= HOPELESS * least) else {
                    continue;
                };
                if !timed.iter().any(|t| (t.0, t.1) == (n, found.setting)) {
                    timed.push((n, found.setting, found.seconds));
                }
            }
        }
    }

    // Nothing is timed whose error is not shown once more.
    let mut errors = Vec::new();
    for (n, setting, _) in &timed {
        errors.push((runners[*n].measure)(*setting)?);
    }
    let round: f64 = timed.iter().map(|t| t.2.max(4e-4)).sum();
    let rounds = ((BUDGET / round) as usize).clamp(5, 101);
    let tasks: Vec<_> = timed
        .iter()
        .map(|&(n, setting, _)| {
            move || {
                // An error was shown to be reached: a failure now would show in the time.
                let _ = black_box((runners[n].run)(setting));
                Ok(())
            }
        })
        .collect();
    let tasks: Vec<Task> = tasks.iter().map(|task| task as Task).collect();
    let measured = interleaved(&tasks, rounds).map_err(|e| e.to_string())?;

    let mut race = Race { names, lines: Vec::new(), failures: Vec::new(), rounds };
    for (target, &bound) in targets.iter().enumerate() {
        for name in &race.names {
            // A setting found for a smaller error may well be the faster one.
            let lines = (0..timed.len())
                .filter(|&t| &runners[timed[t].0].name == name && errors[t] <= bound);
            let best = lines.min_by(|&a, &b| measured[a].ratio.total_cmp(&measured[b].ratio));
            match best {
                Some(t) => race.lines.push(Line {
                    peer: runners[timed[t].0].peer,
                    name: name.clone(),
                    form: runners[timed[t].0].form,
                    target,
                    setting: timed[t].1,
                    error: errors[t],
                    seconds: measured[t].seconds,
                    ratio: measured[t].ratio,
                    quartiles: measured[t].quartiles,
                }),
                None if race.failures.iter().any(|failure| &failure.name == name) => {}
                None => {
                    let of_name = (0..runners.len()).filter(|&n| &runners[n].name == name);
                    let least = of_name.clone().map(|n| outcomes[n].least);
                    race.failures.push(Failure {
                        name: name.clone(),
                        target,
                        least: least.fold(f64::INFINITY, f64::min),
                        impatient: of_name.clone().any(|n| outcomes[n].impatient),
                    });
                }
            }
        }
    }
    Ok(race)
}
