//! Rigid-body rotation, executable.
//!
//! The modules, bottom to top; each depends only on those above it in this list.
//!
//! | module | what it holds |
//! |---|---|
//! | [`math`] | the only door to elementary functions (`libm`), and double-double arithmetic |
//! | [`interval`] | which values a parameter may take |
//! | [`error`] | one error type; every variant carries the offending numbers |
//! | [`frame`] | vectors on space-fixed, body-fixed and design axes as types |
//! | [`attitude`] | unit quaternion, Euler angles z-x'-z'' and the other conventions, rotation vector |
//! | [`inertia`] | tensor, principal moments and axes, parallel axes, solids |
//! | [`body`] | a rigid body and its state, on principal axes or on those of its drawing |
//! | `documents` | values to and from documents (feature `serde`) |
//! | [`motion`] | what every motion can be asked, closed form or solved |
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
#[cfg(feature = "serde")]
pub mod documents;
pub mod effects;
pub mod error;
pub mod exact;
pub mod frame;
pub mod inertia;
pub mod integrators;
pub mod interval;
pub mod math;
pub mod motion;
pub mod planar;
#[cfg(feature = "report")]
pub mod report;
pub mod scene;

pub use error::{Error, Result};
