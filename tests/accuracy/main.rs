//! Measures of error, work-precision curves, long-time drift, `solve`, and effects that it
//! solves.

mod called_for;
mod called_for_axis;
mod drift;
mod effects;
mod elastic_yielding;
mod error_control;
mod gravity_gradient;
mod internal_dissipation;
mod measures;
mod orbiting_body;
mod sweep;
mod twin;
