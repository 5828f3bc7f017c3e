//! The closed forms and the functions under them: against references with many digits,
//! against laws and limits, and against plain formulas that look right.
//!
//! Errors are in eps = 2^-53 unless a test says otherwise.

mod batch;
mod double_double;
mod elliptic;
mod far_from_one;
mod free_body;
mod free_flow;
mod gimbals;
mod heavy_top;
mod late;
mod many;
mod motion;
mod pendulum;
mod plank;
mod scene;
mod sliding_ladder;
mod turns;

use rotation_dynamics::Error;

/// The latest time at which a motion is known, as the refusal of a later one tells it.
fn latest(refusal: Option<Error>) -> f64 {
    match refusal {
        Some(Error::PhaseLost { latest, .. }) => latest,
        other => panic!("{other:?}"),
    }
}
