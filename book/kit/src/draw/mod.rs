//! Figures in one visual language.
//!
//! | figure | for |
//! |---|---|
//! | [`Panel`] | curves over two axes: time series, potentials, phase portraits, work against error |
//! | [`Sketch`] | set-ups and mechanisms: lines, arrows, springs, rollers, hatched walls, labels |
//! | [`View`] | three dimensions: the sphere with a trace, arrows, solids that hide each other |
//! | [`Sweep`] | makes panels over one parameter, with exact lines and simulated dots |
//! | [`Stack`] | scenes above panels over one time axis; with [`Panel::now`] one moment of a motion |
//!
//! [`figures!`](crate::figures) makes a page's figures of them, with their names and what is
//! to be seen in them.
//!
//! Colours have meanings ([`Ink`]), methods of integration look the same everywhere
//! ([`Method`]), lines are labelled directly, labels speak a little TeX (`"$U_{eff}$"`),
//! coordinates are finer than pixels, and the same input gives the same bytes on every
//! machine. A figure is a list ([`Display`]) of strokes, areas, faces, dots and texts;
//! its SVG is one way to write that down. Plotters draws the list: it lays out the axes of a
//! panel, and maps coordinates to places. Where ticks and labels go is decided here, and
//! [`Display::crowded`] names the labels that cannot be read.

mod axis;
mod backend;
mod band;
mod bodies;
mod canvas;
mod clip;
mod crowded;
mod curve;
mod depth;
mod display;
mod drawing;
mod encoded;
mod globe;
mod hidden;
mod ink;
mod label;
mod material;
mod mechanism;
mod method;
mod paint;
mod panel;
mod place;
mod scene;
mod shadow;
mod sketch;
mod solid;
mod stack;
mod stations;
mod svg;
mod sweep;
#[cfg(test)]
mod tests;
mod ticks;
mod turned;
mod view;
mod widths;
mod words;

pub use axis::Axis;
pub use curve::Curve;
pub use display::{Anchor, Dash, Display, Place, Run, Shape, Stroke, Text};
pub use drawing::Drawing;
pub use ink::{Colour, Ink, PALETTE, css_variables};
pub(crate) use label::plain;
pub use method::{Marker, Method};
pub use panel::Panel;
pub use sketch::Sketch;
pub use solid::{Camera, Solid, smooth};
pub use stack::{Scene, Stack};
pub use sweep::Sweep;
pub use turned::Turn;
pub(crate) use turned::turned;
pub use view::View;
pub use words::Side;
