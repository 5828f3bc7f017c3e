//! Closed forms: motions that are known at any time without stepping.
//!
//! | module | what it holds |
//! |---|---|
//! | [`free_body`] | torque-free rotation of any body (Euler-Poinsot) |
//! | [`ladder`] | the sliding ladder of exercise 16.6 |
//!
//! Not for: motions that must be stepped; see [`crate::integrators`].

mod extended;
pub mod free_body;
pub mod ladder;
