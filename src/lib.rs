//! Rigid-body rotation, executable.
//!
//! The modules, bottom to top; each depends only on those above it in this list.
//!
//! | module | what it holds |
//! |---|---|
//! | [`math`] | the only door to elementary functions (`libm`), and double-double arithmetic |
//! | [`interval`] | which values a parameter may take |
//! | [`error`] | one error type; every variant carries the offending numbers |
//! | [`frame`] | space-fixed and body-fixed vectors as types |
//! | [`attitude`] | unit quaternion, Euler angles z-x'-z'', rotation vector |
//! | [`inertia`] | principal moments, parallel axes |
//! | [`body`] | a rigid body and its state |
//! | [`effects`] | what acts on a body, one file per effect |
//! | [`scene`] | body, effects and initial state together |
//! | [`exact`] | elliptic functions and closed-form solutions |
//! | [`integrators`] | one method per file, coefficients as data |
//! | [`accuracy`] | errors against the exact motion, and what they cost |
//! | [`planar`] | one-axis scenes with contacts and located events |
//! | [`report`] | claims, tables, figures and the command line of the examples (features `report` and `cli`) |

pub mod accuracy;
pub mod attitude;
pub mod body;
pub mod effects;
pub mod error;
pub mod exact;
pub mod frame;
pub mod inertia;
pub mod integrators;
pub mod interval;
pub mod math;
pub mod planar;
#[cfg(feature = "report")]
pub mod report;
pub mod scene;

pub use error::{Error, Result};
