//! DOP853: the adaptive method of order 8 by Dormand and Prince.
//!
//! Twelve derivatives a step, two embedded error estimates (orders 5 and 3)
//! that choose the step, an interpolant of order 7 for the time between steps,
//! and events located to the accuracy of the run itself. How, and how well:
//! `book/src/how_events.md`.

pub mod coefficients;
mod driver;
mod event;
mod pace;
mod segment;
mod solution;
mod system;
mod trial;
mod zero;

pub use event::{Direction, Event, LocatedEvent};
pub use solution::Solution;
pub use zero::{after, small_frequency};

use self::system::{ByRef, System};
use super::ode::check_span;
use super::{Integrator, Ode, Work, advance_by_counting};
use crate::error::{Error, Result, finite, positive};
use core::ops::ControlFlow;

/// The adaptive Runge-Kutta method of order 8(5,3) by Dormand and Prince.
///
/// The *tolerance* bounds the error made in one step, relative to
/// [`Ode::scale`]. The error at the end of a run is larger by the number of
/// steps and by what the system itself does to errors on the way.
///
/// A step in which the derivative is not finite is shortened like one whose
/// error is too large; if no short step helps, that derivative is the error
/// returned.
///
/// Accuracy, as measured: ten Kepler orbits of eccentricity 0.5, where errors grow
/// with the square of the time, and the notes' top (16.2, fig. 3) for 20 time units.
///
/// | tolerance | error, orbits | derivatives | error, top | derivatives |
/// |---|---|---|---|---|
/// | 1e-6 | 6.5e-3 | 2253 | 1.3e-5 | 266 |
/// | 1e-8 | 4.9e-5 | 3681 | 1.4e-7 | 446 |
/// | 1e-10 | 4.7e-7 | 5590 | 1.1e-9 | 758 |
/// | 1e-12 | 3.7e-9 | 8416 | 8.2e-12 | 1310 |
/// | 1e-14 | 2.2e-11 | 14750 | 7.3e-14 | 2306 |
/// | 1e-15 | 3.3e-12 | 19694 | 5.7e-15 | 3062 |
///
/// One more digit costs about 1.3 times the work. Sums are compensated and formed
/// about the first derivative of the step, so that tolerances down to 1e-15 mean
/// something. Over the reference cases of the tops at 1e-15: K <= 18 in units of
/// eps (|value| + condition).
///
/// Source: E. Hairer, S. P. Nørsett, G. Wanner, *Solving Ordinary Differential
/// Equations I*, 2nd ed. (1993), II.4 to II.6; step control II.4 and, with
/// memory of the last error (PI), *II*, IV.2.
///
/// ```
/// use rotation_dynamics::integrators::{Dop853, Event, Ode, size_or};
///
/// /// A stone thrown upwards: height and speed.
/// struct Stone;
/// impl Ode<2> for Stone {
///     fn derivative(&self, _t: f64, [_, speed]: &[f64; 2]) -> [f64; 2] {
///         [*speed, -9.81]
///     }
///     fn scale(&self, y: &[f64; 2]) -> [f64; 2] {
///         size_or([1.0; 2])(y)
///     }
/// }
///
/// # fn main() -> rotation_dynamics::Result<()> {
/// let ground = Event::falling("ground", |_t, y: &[f64; 2]| y[0]).terminal();
/// let flight = Dop853::new(1e-12)?.solve(&Stone, 0.0, &[0.0, 9.81], 10.0, &[ground])?;
/// assert!((flight.end_time() - 2.0).abs() < 1e-14);
/// assert!((flight.at(1.0)?[0] - 4.905).abs() < 1e-14);
/// # Ok(())
/// # }
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Dop853 {
    tolerance: f64,
    longest_step: f64,
    step_limit: u64,
    /// The step that is tried first; 0 if it is to be found.
    first_step: f64,
}

impl Dop853 {
    /// The smallest tolerance: below it the error estimates are round-off.
    pub const SMALLEST_TOLERANCE: f64 = 1e-15;
    /// The largest tolerance.
    pub(crate) const LARGEST_TOLERANCE: f64 = 0.1;

    /// The method that holds the error of each step to `tolerance`, from 1e-15
    /// to 0.1, relative to [`Ode::scale`].
    ///
    /// Errors: a tolerance outside that range.
    pub fn new(tolerance: f64) -> Result<Self> {
        finite("tolerance", tolerance)?;
        if !(Self::SMALLEST_TOLERANCE..=Self::LARGEST_TOLERANCE).contains(&tolerance) {
            return Err(Error::out_of_range("tolerance", tolerance, "from 1e-15 to 0.1"));
        }
        Ok(Self { tolerance, longest_step: f64::INFINITY, step_limit: 1_000_000, first_step: 0.0 })
    }

    /// The same method with no step longer than this (time units of the system).
    ///
    /// Needed only where an event could come and go twice within a step.
    /// Errors: a length that is not positive and finite.
    pub fn with_longest_step(self, longest_step: f64) -> Result<Self> {
        positive("longest step", longest_step)?;
        Ok(Self { longest_step, ..self })
    }

    /// The same method that gives up after this many steps, rejected ones
    /// included; without it, after a million.
    ///
    /// Errors: a limit of no steps.
    pub fn with_step_limit(self, step_limit: u64) -> Result<Self> {
        if step_limit == 0 {
            return Err(super::explicit::no_steps());
        }
        Ok(Self { step_limit, ..self })
    }

    /// The bound on the error of one step.
    pub const fn tolerance(&self) -> f64 {
        self.tolerance
    }

    /// The solution from `start` at `t` to `t_end` or to the first terminal
    /// event, at any time between, with the events met on the way.
    ///
    /// `t_end` may lie before `t`. The interpolant costs three more derivatives
    /// a step, an event found 20 to 40, and memory for 9 states a step; use
    /// [`Integrator::advance`] where only the end counts.
    ///
    /// Errors: a time or a start that is not finite; a derivative that is not
    /// finite; a step too short to change the time; more steps than the limit;
    /// a scale that is not positive; an event function that is not finite.
    pub fn solve<const N: usize>(
        &self,
        ode: &(impl Ode<N> + ?Sized),
        t: f64,
        start: &[f64; N],
        t_end: f64,
        events: &[Event<'_, N>],
    ) -> Result<Solution<N>> {
        self.solve_system(&ByRef(ode), t, start, t_end, events)
    }

    fn solve_system<const N: usize>(
        &self,
        ode: &dyn System<N>,
        t: f64,
        start: &[f64; N],
        t_end: f64,
        events: &[Event<'_, N>],
    ) -> Result<Solution<N>> {
        check_span(t, start, t_end)?;
        let mut solution = Solution::new(t, *start);
        let mut watch = event::Watch::new(events, t, start)?;
        let mut work = Work::default();
        let (end, _) = self.drive(ode, t, start, t_end, &mut work, &mut |trial, last, work| {
            let segment = trial.segment(ode, last, work)?;
            let (met, stopped) = watch.crossings(ode, trial, &segment, work)?;
            solution.events.extend(met);
            Ok(match stopped {
                None => {
                    solution.push(segment);
                    ControlFlow::Continue(())
                }
                Some(to_event) => {
                    let last = to_event.last(ode, work)?;
                    solution.push(to_event.segment(ode, last, work)?);
                    solution.stopped = true;
                    ControlFlow::Break(to_event.end.value)
                }
            })
        })?;
        solution.end = end;
        solution.work = work;
        Ok(solution)
    }
}

impl Dop853 {
    /// The same method that tries a step of this length first.
    pub(crate) const fn with_first_step(self, first_step: f64) -> Self {
        Self { first_step, ..self }
    }

    /// The longest step, and the most steps.
    pub(crate) const fn limits(&self) -> (f64, u64) {
        (self.longest_step, self.step_limit)
    }

    /// Carries `start` from `t` to `t_end` or to the first of these events, which all are terminal:
    /// that time, the state there, the events met at it, and the length of a step to go on with.
    pub(crate) fn advance_to_event<const N: usize>(
        &self,
        ode: &dyn Ode<N>,
        [t, t_end]: [f64; 2],
        start: &[f64; N],
        events: &[Event<'_, N>],
        work: &mut Work,
    ) -> Result<(f64, [f64; N], Vec<LocatedEvent<N>>, f64)> {
        let ode = ByRef(ode);
        let mut done = Work::default();
        let (mut to, mut all, mut longest) = (t_end, Vec::new(), 0.0_f64);
        let mut watch = event::Watch::new(events, t, start)?;
        let end = self.drive(&ode, t, start, t_end, &mut done, &mut |trial, last, work| {
            longest = longest.max((trial.t_end - trial.t).abs());
            if events.is_empty() {
                return Ok(ControlFlow::Continue(()));
            }
            let segment = trial.segment(&ode, last, work)?;
            let (met, stopped) = watch.crossings(&ode, trial, &segment, work)?;
            Ok(match stopped {
                None => ControlFlow::Continue(()),
                Some(stopped) => {
                    (to, all) = (stopped.t_end, met);
                    ControlFlow::Break(stopped.end.value)
                }
            })
        });
        *work += done;
        let (end, next) = end?;
        Ok((to, end, all, longest.max(next)))
    }
}

impl<const N: usize, O: Ode<N> + ?Sized> Integrator<O, [f64; N]> for Dop853 {
    advance_by_counting!(O, [f64; N]);

    fn advance_counting(
        &self,
        ode: &O,
        t: f64,
        start: &[f64; N],
        t_end: f64,
        work: &mut Work,
    ) -> Result<[f64; N]> {
        let mut done = Work::default();
        let end = self.drive(&ByRef(ode), t, start, t_end, &mut done, &mut |_, _, _| {
            Ok(ControlFlow::Continue(()))
        });
        *work += done;
        Ok(end?.0)
    }
}
