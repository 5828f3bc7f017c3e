//! What the file of a page names again and again: `use kit::prelude::*;`.
//!
//! The recipe only: the tables of a page, its figures and their drawing, elementary functions and
//! constants, vectors. What the page is about (bodies, effects, closed forms, methods) it names
//! itself.

pub use super::draw::{Axis, Curve, Ink, Panel, Side, Sketch, Solid, Stack, Sweep, View};
pub use super::{But, CardLine, ClosedForm, Figure, MovingPicture, Report, Table, Trajectory};
pub use super::{bisect, claim, effect, limit, require, sampled, times, try_bisect, when};
pub use crate::error::Result;
pub use crate::interval::{above, between, from_to};
pub use crate::{allowed, claims, effect_card, example, figures, limits, parameters};
pub use core::f64::consts::{FRAC_PI_2, PI, TAU};
pub use rotation_dynamics::frame::{BodyVector, SpaceVector};
pub use rotation_dynamics::math::{
    acos, asin, atan2, cbrt, cos, exp, hypot, log, pow, sin, sincos, tan,
};
