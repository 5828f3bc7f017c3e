//! Attitude, moments of inertia and the body: against references with many digits,
//! against what must hold for any body, and what is refused.
//!
//! Errors are in eps = 2^-53 unless a test says otherwise.

mod attitude;
mod frames;
mod inertia;
mod print;
mod refusals;
