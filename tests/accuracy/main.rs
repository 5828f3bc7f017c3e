//! Measures of error, work-precision curves, long-time drift, and the dial.

mod dial;
mod drift;
mod measures;
mod sweep;
