//! What is asked of the dial, checked, and handed on.
//!
//! The dial is compiled once, for effects behind a pointer: a program that solves ten scenes
//! of its own compiles none of it.

use super::along::Form;
use super::limits::{LOOKS, Limits};
use super::method::{Fine, Method, Runs};
use super::problem::{ALL_ROWS, Acting, Apart, Feeler, Problem};
use super::slender::Slender;
use super::stepping::Stepping;
use super::{ExactMotion, Solved};
use crate::body::{RigidBody, State};
use crate::effects::{AnyEffect, Checked, NEAR};
use crate::error::{Error, Result, finite};
use crate::integrators::Work;
use crate::math::EPS;

/// The error of a closed form, in units of eps (1 + condition). Measured over the reference
/// cases: 5.6, of which the rates cost most, read from a state that holds L in space.
const CLOSED_FORM: f64 = 8.0;

/// The angle (rad) that a body turns at most between two places where its effects are tried, of
/// which there are no more than so many.
const CUT: f64 = 30.0;
const MOST_CUTS: f64 = 8.0;

/// Where the promise is to hold.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Places {
    /// At the end.
    End,
    /// All along: at so many places, one for as many radians that the body turns.
    Along { most: usize, apart: f64 },
}

/// What was solved, and what is needed to find any state on the way.
pub(super) struct Answer {
    pub solved: Solved,
    pub form: Form,
}

/// What is asked: a scene, its start, its end, and within which limits.
pub(super) struct Given<'s> {
    effects: &'s dyn AnyEffect,
    body: RigidBody,
    start: State,
    t_end: f64,
    tolerance: f64,
    limits: &'s Limits<'s>,
    checked: Checked<'s>,
    /// What the torque may be as large as, and where it jumps.
    pub torque: f64,
    pub breaks: Vec<f64>,
    /// Those of them, and of the ends, beside which it goes like a root of the time.
    pub singular: Vec<f64>,
    pub longest_step: f64,
    /// What a trial run shows of a slender body, and what it took.
    pub slender: Option<Slender>,
    trial: Work,
}

impl<'s> Given<'s> {
    pub fn new(
        effects: &'s dyn AnyEffect,
        body: &RigidBody,
        start: &State,
        t_end: f64,
        tolerance: f64,
        limits: &'s Limits<'s>,
    ) -> Result<Self> {
        finite("tolerance", tolerance)?;
        if !(tolerance > 0.0 && tolerance <= core::f64::consts::PI) {
            return Err(Error::OutOfRange {
                name: "tolerance",
                value: tolerance,
                allowed: "above 0 and at most pi",
            });
        }
        limits.checked(t_end)?;
        State::new(start.attitude, start.angular_momentum)?;
        let checked = Checked::new(effects, body, [limits.t_start, t_end], start)?;
        let mut given = Self {
            effects,
            body: *body,
            start: *start,
            t_end,
            tolerance,
            limits,
            torque: effects
                .torque_scale(limits.t_start, body, start)
                .max(checked.at_start()),
            breaks: limits.breaks(effects, t_end),
            singular: Vec::new(),
            longest_step: limits.longest_step,
            checked,
            slender: None,
            trial: Work::default(),
        };
        finite("kinetic energy of the start", body.kinetic_energy(start))?;
        let nature = effects.nature();
        finite(
            "the fastest rate that the energy allows",
            given.problem().fastest(),
        )?;
        let seen = if nature.on_time && t_end != limits.t_start {
            given.checked.looked(LOOKS as usize)
        } else {
            Vec::new()
        };
        if !nature.smooth && !seen.is_empty() {
            let jumps = given.checked.jumps(&seen);
            let kinks = given.checked.kinks(&seen, &given.breaks);
            let singular = kinks.iter().filter(|kink| kink.is_singular);
            given.singular = singular.map(|kink| kink.at).collect();
            let found = jumps.into_iter().chain(kinks.iter().map(|kink| kink.at));
            given.breaks.extend(found);
            given.breaks = limits.sorted(given.breaks, t_end);
        }
        if given.problem().exact_motion().is_none() {
            (given.slender, given.trial) = given.slender()?;
        }
        let rate = given.problem().fastest();
        given.longest_step = limits.longest_step(effects, &given.checked, &seen, rate, t_end);
        if given.problem().exact_motion().is_none() {
            // Runs are cut there too, and what effects say of themselves is tried.
            let cuts = (rate * (t_end - limits.t_start).abs() / CUT).clamp(1.0, MOST_CUTS) as usize;
            let problem = given.problem();
            let near = NEAR / LOOKS * (t_end - limits.t_start).abs();
            let apart = |cut: &f64| given.breaks.iter().all(|t| (t - cut).abs() > near);
            let cuts: Vec<f64> = (1..cuts)
                .map(|n| problem.at_leg(n, cuts))
                .filter(apart)
                .collect();
            given.breaks = limits.sorted([given.breaks, cuts].concat(), t_end);
        }
        Ok(given)
    }

    /// What a trial shows of a slender body, and what it took.
    fn slender(&self) -> Result<(Option<Slender>, Work)> {
        let mut trial = Work::default();
        let slender = Slender::of(&self.problem(), self.limits.budget, &mut trial)?;
        Ok((slender, trial))
    }

    fn problem(&self) -> Problem<'_> {
        let problem = Problem {
            body: self.body,
            acting: Acting::of(self.effects),
            strength: 1.0,
            torque: self.torque,
            start: self.start,
            t_start: self.limits.t_start,
            t_end: self.t_end,
            breaks: &self.breaks,
            singular: &self.singular,
            longest_step: self.longest_step,
            checked: &self.checked,
            known: self.effects.known(),
            slender: self.slender,
        };
        match problem.acting {
            Acting::Anything(effects) if problem.stays_smooth() => Problem {
                acting: Acting::Smooth(effects),
                ..problem
            },
            _ => problem,
        }
    }

    /// What is asked for, in closed form unless it is to be stepped.
    pub fn answer(&self, places: Places, step: bool) -> Result<Answer> {
        let (mut problem, mut trial) = (self.problem(), self.trial);
        if step && problem.exact_motion().is_some() {
            (problem.slender, trial) = self.slender()?;
        }
        if let (Places::End, Some(slender)) = (places, &mut problem.slender) {
            slender.held = 0.0;
        }
        let places = match places {
            Places::End => 1,
            Places::Along { most, apart } => {
                let turned = problem.fastest() * problem.span().abs() / apart;
                turned.clamp(1.0, most as f64) as usize
            }
        };
        if !step && let Some(motion) = problem.exact_motion() {
            return Ok(Answer {
                solved: by_closed_form(&problem, &motion, self.tolerance, places)?,
                form: Form::Exact(motion),
            });
        }
        if problem.span() == 0.0 {
            return Ok(Answer {
                solved: nothing_to_do(&problem)?,
                form: Form::Still(problem.start),
            });
        }
        let span = problem.span();
        if span.abs() < f64::MIN_POSITIVE {
            return Err(Error::OutOfRange {
                name: "end time - start time",
                value: span,
                allowed: "0, or 2.3e-308 s at least, of which a step can be a part",
            });
        }
        let delivered =
            Stepping::new(&problem, self.tolerance, self.limits, places, trial).solve()?;
        let solved = Solved::of(&delivered, &problem);
        let mut states = vec![problem.start];
        states.extend(delivered.places);
        Ok(Answer {
            solved,
            form: Form::Stepped {
                method: delivered.method,
                level: delivered.level,
                precision: delivered.precision,
                places: states,
                steps: delivered.steps,
            },
        })
    }
}

/// A run of one method from a state on the way to a time.
#[derive(Clone, Copy)]
pub(super) struct Onward<'s> {
    pub effects: &'s dyn AnyEffect,
    pub body: RigidBody,
    pub torque: f64,
    pub longest_step: f64,
    pub slender: Option<Slender>,
    pub span: [f64; 2],
}

impl Onward<'_> {
    pub fn state(
        &self,
        [breaks, singular]: [&[f64]; 2],
        method: Method,
        fine: Fine,
        [from, to]: [f64; 2],
        start: &State,
    ) -> Result<State> {
        let checked = Checked::unlooked(self.effects, &self.body, self.span, start);
        let limits = Limits {
            t_start: self.span[0],
            ..Limits::default()
        };
        let given = Given {
            effects: self.effects,
            body: self.body,
            start: *start,
            t_end: self.span[1],
            tolerance: 1.0,
            limits: &limits,
            torque: self.torque,
            breaks: breaks.to_vec(),
            singular: singular.to_vec(),
            longest_step: self.longest_step,
            checked,
            slender: self.slender,
            trial: Work::default(),
        };
        let mut runs = Runs::default();
        let passed = method.run(&given.problem(), [from, to], start, None, fine, &mut runs);
        Ok(passed?.state)
    }
}

fn nothing_to_do(problem: &Problem) -> Result<Solved> {
    let start = problem.start;
    let [condition, ..] = problem.condition(&Feeler::EXACT, |by| {
        let changed = (0..ALL_ROWS).map(|row| Ok(vec![problem.changed(row, by)?.start]));
        Ok((vec![start], changed.collect::<Result<_>>()?))
    })?;
    Ok(Solved {
        state: start,
        method: "nothing to do",
        run: Work::default(),
        work: Work::default(),
        choice: Work::default(),
        probes: Work::default(),
        price: 1.0,
        estimate: 0.0,
        momentum_estimate: 0.0,
        rates_estimate: 0.0,
        condition,
        longest_step: 0.0,
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
        (1..=places)
            .map(|n| motion.at(changed.at_leg(n, places) - changed.t_start))
            .collect()
    };
    let states = on_the_way(motion, problem)?;
    let mut work = Work {
        samples: 1,
        ..Work::default()
    };
    let run = work;
    let neighbour = |row, by| {
        let changed = problem.changed(row, by)?;
        // A neighbour without a closed form: the edge of what it can do.
        let motion = changed.exact_motion().ok_or(Error::NotDelivered {
            requested: tolerance,
            reached: f64::INFINITY,
        })?;
        on_the_way(&motion, &changed)
    };
    let feeler = if motion.is_near_separatrix() {
        Feeler::STEEP
    } else {
        Feeler::EXACT
    };
    let condition: Apart = problem.condition(&feeler, |by| {
        work.samples += ALL_ROWS as u64;
        let changed = (0..ALL_ROWS).map(|row| neighbour(row, by));
        Ok((states.clone(), changed.collect::<Result<_>>()?))
    })?;
    let [estimate, momentum_estimate, rates_estimate] =
        condition.map(|condition| CLOSED_FORM * EPS * (1.0 + condition));
    if estimate.is_nan() || estimate > tolerance {
        return Err(Error::BeyondCondition {
            requested: tolerance,
            attainable: estimate,
            condition: condition[0],
        });
    }
    Ok(Solved {
        state: states[places - 1],
        method: motion.name(),
        run,
        work,
        choice: Work::default(),
        probes: Work {
            samples: work.samples - 1,
            ..Work::default()
        },
        price: work.samples as f64,
        estimate,
        momentum_estimate,
        rates_estimate,
        condition: condition[0],
        longest_step: 0.0,
    })
}
