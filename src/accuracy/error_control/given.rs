//! The request to `solve`, checked, and handed on.
//!
//! `solve` is compiled once, for effects behind a pointer: a program that solves ten scenes
//! of its own compiles none of it.

use super::along::Form;
use super::changed::ALL_ROWS;
use super::condition::Probe;
use super::constants::{CLOSED_FORM, COMPARED, CUT, MOST_COMPARED, MOST_CUTS};
use super::limits::Limits;
use super::problem::{Acting, Distances, Problem};
use super::refine::Refinement;
use super::run::Stop;
use super::{ExactMotion, Solved};
use crate::accuracy::tolerance_of_attitude;
use crate::body::{RigidBody, State};
use crate::effects::erased::AnyEffect;
use crate::effects::{Checked, NEAR, UNNAMED};
use crate::error::{Error, Result, finite};
use crate::integrators::Work;
use crate::math::EPS;
use crate::scene::Scene;

/// Where the promise is to hold.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Places {
    /// At the end.
    End,
    /// All along.
    Along,
}

/// The solution, and all that is needed to find any state on the way.
pub(super) struct Answer {
    pub solved: Solved,
    pub form: Form,
}

/// The request: a scene, its start, its end, and its limits.
pub(super) struct Given<'s> {
    effects: &'s dyn AnyEffect,
    body: RigidBody,
    pub start: State,
    t_end: f64,
    tolerance: f64,
    pub limits: Limits<'s>,
    checked: Checked<'s>,
    acting: Acting<'s>,
    damping: f64,
    /// The largest torque, and where it jumps.
    torque: f64,
    breaks: Vec<f64>,
    longest_step: f64,
}

impl<'s> Given<'s> {
    pub(super) fn new(
        scene: &'s Scene<dyn AnyEffect + 's>,
        start: &State,
        t_end: f64,
        tolerance: f64,
        limits: &Limits<'s>,
    ) -> Result<Self> {
        let (body, effects) = (scene.body(), scene.effects());
        tolerance_of_attitude(tolerance)?;
        limits.checked(t_end)?;
        State::new(start.attitude, start.angular_momentum)?;
        let checked = Checked::new(effects, body, [limits.t_start, t_end], start)?;
        let is_sampled = checked.holding().next_sample(limits.t_start) < f64::INFINITY;
        if is_sampled && t_end < limits.t_start {
            return Err(Error::OutOfRange {
                name: "end time - start time",
                value: t_end - limits.t_start,
                allowed: "at least 0: a control that is sampled and held has no way back".into(),
            });
        }
        let mut given = Self {
            effects,
            body: *body,
            start: *start,
            t_end,
            tolerance,
            limits: *limits,
            acting: Acting::of(effects),
            damping: 0.0,
            torque: effects.torque_scale(limits.t_start, body, start).max(checked.at_start()),
            breaks: limits.breaks(effects, t_end),
            longest_step: limits.longest_step,
            checked,
        };
        finite("kinetic energy of the start", body.kinetic_energy(start))?;
        let properties = effects.properties();
        let bound =
            finite("the fastest rate that the energy allows", given.problem().bound_on_rate())?;
        let seen = if properties.on_time && t_end != limits.t_start {
            given.checked.looked(UNNAMED as usize)
        } else {
            Vec::new()
        };
        if !properties.smooth && !seen.is_empty() {
            let jumps = given.checked.jumps(&seen);
            let kinks = given.checked.kinks(&seen, &given.breaks);
            given.breaks.extend(jumps.into_iter().chain(kinks));
            given.breaks = limits.sorted(given.breaks, t_end);
        }
        given.longest_step = limits.longest_step(effects, &given.checked, &seen, bound, t_end);
        if given.problem().exact_motion().is_none() {
            // Runs are cut there too, and what effects say of themselves is tried.
            let rate = given.problem().fastest();
            let cuts = (rate * (t_end - limits.t_start).abs() / CUT).clamp(1.0, MOST_CUTS) as usize;
            let problem = given.problem();
            let near = NEAR / UNNAMED * (t_end - limits.t_start).abs();
            let apart = |cut: &f64| given.breaks.iter().all(|t| (t - cut).abs() > near);
            let cuts: Vec<f64> =
                (1..cuts).map(|n| problem.time_at(n, cuts)).filter(apart).collect();
            given.breaks = limits.sorted([given.breaks, cuts].concat(), t_end);
        }
        if let Acting::Anything(effects) = given.acting
            && given.problem().stays_smooth()
        {
            given.acting = Acting::Smooth(effects);
        }
        given.damping = given.problem().fastest_damping();
        Ok(given)
    }

    pub(super) const fn body(&self) -> &RigidBody {
        &self.body
    }

    /// The times of the start and of the end (s).
    pub(super) const fn span(&self) -> [f64; 2] {
        [self.limits.t_start, self.t_end]
    }

    pub(super) fn problem(&self) -> Problem<'_> {
        Problem {
            body: self.body,
            acting: self.acting,
            strength: 1.0,
            torque: self.torque,
            start: self.start,
            t_start: self.limits.t_start,
            t_end: self.t_end,
            breaks: &self.breaks,
            longest_step: self.longest_step,
            damping: self.damping,
            checked: &self.checked,
            known: self.effects.integrable_case(),
        }
    }

    /// The requested motion, in closed form unless it is to be stepped.
    pub(super) fn answer(&self, places: Places, step: bool) -> Result<Answer> {
        let mut problem = self.problem();
        let places = match places {
            Places::End => 1,
            Places::Along => {
                let turned = problem.fastest() * problem.span().abs();
                (turned / COMPARED).clamp(1.0, MOST_COMPARED) as usize
            }
        };
        if !step && let Some(motion) = problem.exact_motion() {
            match by_closed_form(&problem, &motion, self.tolerance, places) {
                // At the edge of what a closed form can do: neighbours have none.
                Err(Error::NotDelivered { condition: None, .. }) => {}
                solved => {
                    return Ok(Answer { solved: solved?, form: Form::Exact(motion) });
                }
            }
        }
        if problem.span() == 0.0 {
            return Ok(Answer {
                solved: nothing_to_do(&problem)?,
                form: Form::Still(problem.start),
            });
        }
        let span = problem.span();
        if span.abs() < f64::MIN_POSITIVE {
            return Err(Error::out_of_range(
                "end time - start time",
                span,
                "0, or 2.3e-308 s at least, of which a step can be a part",
            ));
        }
        let times: Vec<f64> = (1..=places).map(|n| problem.time_at(n, places)).collect();
        // Runs are cut where they are compared.
        let breaks = self.limits.sorted([&self.breaks[..], &times].concat(), self.t_end);
        problem.breaks = &breaks;
        let refinement = Refinement::new(&problem, self.tolerance, &self.limits, &times);
        let delivered = (refinement.solve()).map_err(|error| self.reason(error))?;
        let solved = Solved::of(&delivered, &problem, self.looked_every());
        let mut passed = vec![(problem.t_start, Stop::at(problem.start))];
        passed.extend(delivered.run.passed);
        Ok(Answer {
            solved,
            form: Form::Stepped {
                method: delivered.method,
                level: delivered.run.level,
                precision: delivered.run.precision,
                passed,
                steps: delivered.run.steps,
            },
        })
    }
}

impl Given<'_> {
    /// The time between two looks at the torque, if it may have features that nothing names.
    fn looked_every(&self) -> Option<f64> {
        let unnamed = self.effects.properties().on_time && self.effects.narrowest().is_none();
        unnamed.then(|| (self.t_end - self.limits.t_start).abs() / UNNAMED)
    }

    /// What to declare, where runs take too much over a torque that nothing declares.
    fn reason(&self, error: Error) -> Error {
        match (error, self.looked_every()) {
            (Error::LimitReached { limit, .. }, Some(every))
                if !self.effects.properties().smooth =>
            {
                let effect = self.effects.names().join(" and ");
                Error::Undeclared { effect, requested: self.tolerance, every, limit }
            }
            (error, _) => error,
        }
    }
}

fn nothing_to_do(problem: &Problem) -> Result<Solved> {
    let start = problem.start;
    let [condition, ..] = problem.condition(&Probe::EXACT, |by| {
        let changed = (0..ALL_ROWS).map(|row| Ok(vec![problem.changed(row, by)?.start]));
        Ok((vec![start], changed.collect::<Result<_>>()?))
    })?;
    Ok(Solved {
        state: start,
        method: "nothing to do",
        run: Work::default(),
        work: Work::default(),
        probes: Work::default(),
        price: 1.0,
        estimate: 0.0,
        momentum_estimate: 0.0,
        rates_estimate: 0.0,
        condition,
        longest_step: 0.0,
        looked_every: None,
    })
}

/// The state of a closed form, if its error is small enough at so many places on the way.
fn by_closed_form(
    problem: &Problem,
    motion: &ExactMotion,
    tolerance: f64,
    places: usize,
) -> Result<Solved> {
    let on_the_way = |motion: &ExactMotion, changed: &Problem| -> Result<Vec<State>> {
        (1..=places).map(|n| motion.at(changed.time_at(n, places) - changed.t_start)).collect()
    };
    let states = on_the_way(motion, problem)?;
    let mut work = Work { samples: 1, ..Work::default() };
    let run = work;
    let neighbour = |row, by| {
        let changed = problem.changed(row, by)?;
        let motion = changed.exact_motion().ok_or(Error::NotDelivered {
            requested: tolerance,
            best: f64::INFINITY,
            condition: None,
        })?;
        on_the_way(&motion, &changed)
    };
    let probe = if motion.is_near_separatrix() { Probe::STEEP } else { Probe::EXACT };
    let condition: Distances = problem.condition(&probe, |by| {
        work.samples += ALL_ROWS as u64;
        let changed = (0..ALL_ROWS).map(|row| neighbour(row, by));
        Ok((states.clone(), changed.collect::<Result<_>>()?))
    })?;
    let [estimate, momentum_estimate, rates_estimate] =
        condition.map(|condition| CLOSED_FORM * EPS * (1.0 + condition));
    if estimate.is_nan() || estimate > tolerance {
        return Err(Error::NotDelivered {
            requested: tolerance,
            best: estimate,
            condition: Some(condition[0]),
        });
    }
    Ok(Solved {
        state: states[places - 1],
        method: motion.name(),
        run,
        work,
        probes: Work { samples: work.samples - 1, ..Work::default() },
        price: work.samples as f64,
        estimate,
        momentum_estimate,
        rates_estimate,
        condition: condition[0],
        longest_step: 0.0,
        looked_every: None,
    })
}
