//! Measures of error, work-precision curves, long-time drift, and the dial.

mod called_for;
mod dial;
mod drift;
mod gravity_gradient;
mod internal_dissipation;
mod measures;
mod sweep;
