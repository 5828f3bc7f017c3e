//! Who races: one file per crate, each written as its documentation advises.
//!
//! All peers hold the error of each component to an absolute tolerance, since every
//! variable is of order one or an angle. Where a default would stop them on the way
//! (step limits, shortest steps, stiffness tests), it is lifted. What they record of
//! the way is as little as they allow.

pub mod differential_equations;
pub mod diffsol;
pub mod ivp;
pub mod numeris;
pub mod ode_solvers;
pub mod ours;
pub mod rapier;

/// More steps than this are not waited for.
pub const MOST_STEPS: usize = 2_000_000;

/// A peer's reason in one line, without what it was doing.
fn reason(error: impl core::fmt::Debug) -> String {
    let text = format!("{error:?}");
    let end = text.find(['{', '(']).unwrap_or(text.len());
    text[..end].trim().to_owned()
}
