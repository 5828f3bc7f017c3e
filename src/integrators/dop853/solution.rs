//! The result of [`Dop853::solve`](super::Dop853::solve).

use super::event::LocatedEvent;
use super::segment::Segment;
use crate::error::{Error, Result, finite};
use crate::integrators::Work;

/// A solution over a span of time, known at every time in it.
///
/// Accuracy: between steps no worse than at the end of the run, measured at 500
/// times over ten Kepler orbits of eccentricity 0.5, for tolerances from 1e-4 to
/// 1e-15 (`tests/integrators/convergence/dop853.rs`).
#[derive(Debug, Clone)]
pub struct Solution<const N: usize> {
    start_time: f64,
    start: [f64; N],
    segments: Vec<Segment<N>>,
    pub(super) end: [f64; N],
    pub(super) events: Vec<LocatedEvent<N>>,
    pub(super) stopped: bool,
    pub(super) work: Work,
}

impl<const N: usize> Solution<N> {
    pub(super) const fn new(start_time: f64, start: [f64; N]) -> Self {
        Self {
            start_time,
            start,
            segments: Vec::new(),
            end: start,
            events: Vec::new(),
            stopped: false,
            work: Work { derivatives: 0, steps: 0, rejected: 0, flows: 0, kicks: 0, samples: 0 },
        }
    }

    /// Adds a step. One without length (an event at the very start of a step) holds
    /// no time that the steps before it do not.
    pub(super) fn push(&mut self, segment: Segment<N>) {
        if segment.t_end != segment.t {
            self.segments.push(segment);
        }
    }

    /// Where the run began.
    pub const fn start_time(&self) -> f64 {
        self.start_time
    }

    /// The state the run began with.
    pub const fn start_state(&self) -> &[f64; N] {
        &self.start
    }

    /// Where the run ended: the time asked for, or the time of a terminal event.
    pub fn end_time(&self) -> f64 {
        self.segments.last().map_or(self.start_time, |s| s.t_end)
    }

    /// The state at the end of the run.
    pub const fn end_state(&self) -> &[f64; N] {
        &self.end
    }

    /// The state at `t`, anywhere between start and end.
    ///
    /// Errors: a time outside the run, with both its ends.
    pub fn at(&self, t: f64) -> Result<[f64; N]> {
        finite("time", t)?;
        let (start, end) = (self.start_time, self.end_time());
        if t < start.min(end) || t > start.max(end) {
            return Err(Error::OutsideRun { t, start, end });
        }
        let forward = end >= start;
        let ahead = |s: &Segment<N>| if forward { s.t_end < t } else { s.t_end > t };
        let index = self.segments.partition_point(ahead);
        Ok(self.segments.get(index).map_or(self.end, |s| s.at(t)))
    }

    /// The events met, in the order in which the run met them.
    pub fn events(&self) -> &[LocatedEvent<N>] {
        &self.events
    }

    /// The terminal event that ended the run, if one did.
    pub fn stopped_by(&self) -> Option<&LocatedEvent<N>> {
        self.events.last().filter(|_| self.stopped)
    }

    /// The times at which steps ended, the last one included.
    pub fn step_times(&self) -> impl Iterator<Item = f64> + '_ {
        self.segments.iter().map(|s| s.t_end)
    }

    /// The cost of the run, interpolant and events included.
    pub const fn work(&self) -> Work {
        self.work
    }
}
