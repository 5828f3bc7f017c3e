//! Measures of error, work-precision curves, long-time drift, `solve`, and effects that it
//! solves.

mod drift;
mod effects;
mod elastic_yielding;
mod error_control;
mod gravity_gradient;
mod internal_dissipation;
mod measures;
mod neglected;
mod neglected_axis;
mod orbiting_body;
mod sweep;
mod twin;
