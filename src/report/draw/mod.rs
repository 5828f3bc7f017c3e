//! Figures in one visual language.
//!
//! | figure | for |
//! |---|---|
//! | [`Panel`] | curves over two axes: time series, potentials, phase portraits, work against error |
//! | [`Stack`] | several panels over one time axis |
//! | [`Sketch`] | set-ups: lines, arrows, arcs, hatched walls, labels; strobe drawings |
//! | [`View`] | three dimensions: the sphere with a trace, arrows, solids |
//!
//! Colours have meanings ([`Ink`]), lines are labelled directly, labels speak a
//! little TeX (`"$U_{eff}$"`), coordinates are finer than pixels, and the same
//! input gives the same bytes on every machine. The drawing is plotters' through
//! a backend of our own; this module is not a general plotting library.

mod axis;
mod canvas;
mod ink;
mod label;
mod paint;
mod panel;
mod place;
mod sketch;
mod solid;
mod svg;
mod view;

pub use axis::Axis;
pub use canvas::Side;
pub use ink::{Colour, Ink, PALETTE, css_variables};
pub use panel::{Curve, Panel, Stack};
pub use sketch::Sketch;
pub use solid::{Camera, Solid};
pub use svg::Dash;
pub use view::View;
