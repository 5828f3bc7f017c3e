//! Measures of error, work-precision curves, long-time drift, the dial, and effects that it
//! solves.

mod called_for;
mod called_for_axis;
mod dial;
mod drift;
mod effects;
mod elastic_yielding;
mod gravity_gradient;
mod internal_dissipation;
mod measures;
mod orbiting_body;
mod sweep;
mod twin;
