//! Measures of error, work-precision curves, long-time drift, the dial, and effects that it
//! solves.

mod called_for;
mod dial;
mod drift;
mod gravity_gradient;
mod internal_dissipation;
mod effects;
mod measures;
mod sweep;
