//! The price of accuracy: how far a run ends from the truth, and its cost.
//!
//! | part | what it holds |
//! |---|---|
//! | [`Problem`] | a motion with a start, an end and the exact answer: what a method is judged by |
//! | [`Stepper`] | a method made as fine as it is to run, and what it carries of a scene |
//! | [`Errors`] | how far a state is from the exact one, measured in five ways |
//! | [`Sweep`] | a method run coarser and finer: what each run cost and delivered |
//! | [`error_control`] | [`Scene::solve`](crate::scene::Scene::solve): an error asked for at the end, delivered or refused |
//! | [`NeglectedEffects`] | which effects a scene calls for: the predicted error of leaving each out |
//! | [`WorkPrecision`] | such runs in one measure: least work, price of a digit, floor, Pareto front |
//!
//! Not for: the exact solutions that errors are measured against
//! ([`crate::exact`]), and time, which this library never reads; work is counted
//! ([`Work`](crate::integrators::Work)).

mod as_motion;
pub mod error_control;
mod measures;
mod neglected;
mod problem;
mod stepper;
mod sweep;

pub(crate) use crate::math::larger;
pub use error_control::{Crossing, ExactMotion, Limits, Solved, SolvedMotion};
pub use measures::{Errors, Measure, largest};
pub use neglected::{MARGIN, Measured, NeglectedEffects, PredictedError};
pub use problem::Problem;
pub use stepper::{Resolution, Stepper, Variables, applies};
pub use sweep::{DigitPrice, Point, Run, Sweep, WorkPrecision, front};

use crate::error::{Error, Result, finite};

/// Checks an error asked of an attitude (rad).
fn tolerance_of_attitude(tolerance: f64) -> Result<()> {
    finite("tolerance", tolerance)?;
    if tolerance > 0.0 && tolerance <= core::f64::consts::PI {
        return Ok(());
    }
    let allowed = "above 0 and at most pi";
    Err(Error::out_of_range("tolerance", tolerance, allowed))
}
