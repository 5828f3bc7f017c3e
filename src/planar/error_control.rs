//! `solve`: ask for an error at the end, get it, see the price.

use super::run::{Scene, run, whole};
use super::{Phased, Run};
use crate::accuracy::larger;
use crate::error::{Error, Result, finite};
use crate::integrators::{Dop853, Work};
use core::fmt::Debug;

/// Between two runs that are compared, the error of a step differs by this factor.
const STRIDE: f64 = 32.0;

/// A run whose error was asked for.
#[derive(Debug, Clone)]
pub struct Delivered<P, const N: usize> {
    /// The motion.
    pub run: Run<P, N>,
    /// How far it is from the run before it, which was made with larger steps:
    /// an upper estimate of its error. The time at which bounces are over may be off by more, but not
    /// by more than was asked for: of 400 falls two were, by up to 11 times the estimate.
    pub estimate: f64,
    /// The error of a step, as [`Dop853::new`] takes it, with which it was made.
    pub step_error: f64,
    /// The cost of all runs together.
    pub work: Work,
}

/// The motion of `scene` with an error of at most `tolerance` at every event and at the end.
///
/// Errors are relative: of times to the time of the end, of coordinates and velocities to
/// [`Phased::scale`]. The scene is simulated twice, the second time with the error of a step 32
/// times smaller. The second run is returned when the two agree within half the tolerance; else the
/// comparison goes on with smaller errors of the step. An error that the two have in common is not
/// seen, such as the rounding of a coordinate that the scene is sensitive to.
///
/// # Errors
/// [`Error::OutOfRange`] for a tolerance below 3.2e-14 or above 0.1, [`Error::NotDelivered`] if
/// doubles cannot hold the motion that closely; the errors of [`simulate`](super::simulate).
pub fn simulate_within<const N: usize, S: Phased<N>>(
    scene: &S,
    tolerance: f64,
    phase: S::Phase,
    start: [f64; N],
    t_end: f64,
) -> Result<Delivered<S::Phase, N>> {
    within(scene, tolerance, phase, start, t_end)
}

fn within<P: Copy + PartialEq + Debug, const N: usize>(
    scene: &Scene<'_, P, N>,
    tolerance: f64,
    phase: P,
    start: [f64; N],
    t_end: f64,
) -> Result<Delivered<P, N>> {
    finite("tolerance", tolerance)?;
    if !(STRIDE * Dop853::SMALLEST_TOLERANCE..=Dop853::LARGEST_TOLERANCE).contains(&tolerance) {
        return Err(Error::out_of_range("tolerance", tolerance, "from 3.2e-14 to 0.1"));
    }
    let run = |step_error: f64| whole(run(scene, &Dop853::new(step_error)?, phase, start, t_end));
    let mut step_error = tolerance;
    let mut coarse = run(step_error)?;
    let mut work = coarse.work();
    // The tolerance that the runs so far would have borne out.
    let mut reached = f64::INFINITY;
    loop {
        step_error /= STRIDE;
        if step_error < Dop853::SMALLEST_TOLERANCE {
            return Err(Error::NotDelivered {
                requested: tolerance,
                best: reached,
                condition: None,
            });
        }
        let fine = run(step_error)?;
        work += fine.work();
        let estimate = distance(scene, &coarse, &fine);
        if estimate <= 0.5 * tolerance {
            return Ok(Delivered { run: fine, estimate, step_error, work });
        }
        reached = reached.min(2.0 * estimate);
        coarse = fine;
    }
}

/// The largest relative difference of two runs at their events and ends; infinite if
/// they pass through different phases.
fn distance<P: Copy + PartialEq + Debug, const N: usize>(
    scene: &Scene<'_, P, N>,
    a: &Run<P, N>,
    b: &Run<P, N>,
) -> f64 {
    let (events_a, events_b) = (a.transitions(), b.transitions());
    let pairs = || events_a.iter().zip(events_b);
    let same = events_a.len() == events_b.len() && pairs().all(|(x, y)| x.to == y.to);
    if !same {
        return f64::INFINITY;
    }
    let span = b.end_time().abs();
    // A run of no length has no times that could differ.
    let late = |x: f64, y: f64| if x == y { 0.0 } else { (x - y).abs() / span };
    let apart = |x: &[f64; N], y: &[f64; N]| {
        let size = scene.scale(y);
        (0..N).fold(0.0, |most, i| larger(most, (x[i] - y[i]).abs() / size[i]))
    };
    let mut most = late(a.end_time(), b.end_time());
    for (x, y) in pairs() {
        most = larger(most, late(x.t, y.t));
        if let (Some(x), Some(y)) = (x.rest, y.rest) {
            most = larger(most, late(x.t, y.t));
        }
        most = larger(most, apart(&x.before, &y.before));
        // Of conditions that fail together either may be met first: what counts is what follows.
        if x.name != y.name {
            most = larger(most, apart(&x.after, &y.after));
        }
    }
    match (a.end_state(), b.end_state()) {
        (Some(x), Some(y)) => larger(most, apart(x, y)),
        _ => most,
    }
}
