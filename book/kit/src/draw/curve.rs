//! Curves, and how they are drawn.

use super::canvas::{Frame, Paint, Point};
use super::display::{Dash, Stroke};
use super::ink::Ink;
use super::method::Marker;
use super::words::Side;
use crate::error::Result;
use crate::sampled;

/// Width of curves and of axes, in px.
pub(super) const CURVE: f64 = 1.8;
pub(super) const AXIS: f64 = 1.0;

#[derive(Debug, Clone, PartialEq)]
pub(super) enum LabelPlace {
    Found,
    End,
    At(Point, Side),
}

/// A curve or a set of dots in a [`Panel`](super::Panel).
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    pub(super) points: Vec<Point>,
    pub(super) ink: Ink,
    pub(super) width: f64,
    pub(super) opacity: f64,
    pub(super) dash: Dash,
    pub(super) line: bool,
    pub(super) dots: bool,
    pub(super) marker: Marker,
    pub(super) arrows: Vec<f64>,
    pub(super) label: Option<(String, LabelPlace)>,
}

impl Curve {
    /// The curve through these points.
    pub fn new(points: impl IntoIterator<Item = (f64, f64)>, ink: Ink) -> Self {
        Self {
            points: points.into_iter().collect(),
            ink,
            width: CURVE,
            opacity: 1.0,
            dash: Dash::Solid,
            line: true,
            dots: false,
            marker: Marker::Disc,
            arrows: Vec::new(),
            label: None,
        }
    }

    /// The curve of the function `y` over these `x`.
    pub fn of(x: impl IntoIterator<Item = f64>, y: impl Fn(f64) -> f64, ink: Ink) -> Self {
        Self::new(x.into_iter().map(|x| (x, y(x))), ink)
    }

    /// The curve of a function that may refuse.
    ///
    /// # Errors
    /// The first of `y`.
    pub fn sampled(
        x: impl IntoIterator<Item = f64>,
        y: impl Fn(f64) -> Result<f64>,
        ink: Ink,
    ) -> Result<Self> {
        Ok(Self::new(sampled(x, |x| Ok((x, y(x)?)))?, ink))
    }

    /// Drawn with dashes.
    #[must_use]
    pub fn dashed(mut self) -> Self {
        self.dash = Dash::Dashed;
        self
    }

    /// Drawn with dots, as a guide rather than a result.
    #[must_use]
    pub fn dotted(mut self) -> Self {
        self.dash = Dash::Dotted;
        self
    }

    /// Drawn faintly: 1 is full, 0 is nothing.
    #[must_use]
    pub fn faint(mut self, opacity: f64) -> Self {
        self.opacity = opacity;
        self
    }

    /// Drawn with this width, in px (1.8 if never set).
    #[must_use]
    pub fn width(mut self, px: f64) -> Self {
        self.width = px;
        self
    }

    /// Drawn as thin as an axis.
    #[must_use]
    pub fn thin(mut self) -> Self {
        self.width = AXIS;
        self
    }

    /// Its dots have this shape.
    #[must_use]
    pub fn marker(mut self, marker: Marker) -> Self {
        self.marker = marker;
        self
    }

    /// Its points as dots, without a line: simulated values on an exact curve.
    #[must_use]
    pub fn dots(mut self) -> Self {
        self.dots = true;
        self.line = false;
        self
    }

    /// Its points as dots on the line: measurements.
    #[must_use]
    pub fn with_dots(mut self) -> Self {
        self.dots = true;
        self
    }

    /// With an arrow head at this part of its points, 0 to 1: which way it goes.
    #[must_use]
    pub fn arrow(mut self, at: f64) -> Self {
        self.arrows.push(at);
        self
    }

    /// With a label, at the best place beside the curve.
    #[must_use]
    pub fn label(mut self, text: &str) -> Self {
        self.label = Some((text.into(), LabelPlace::Found));
        self
    }

    /// With a label to the right of its last point, beyond the axes.
    #[must_use]
    pub fn label_end(mut self, text: &str) -> Self {
        self.label = Some((text.into(), LabelPlace::End));
        self
    }

    /// With a label on this side of the point `(x, y)`.
    #[must_use]
    pub fn label_at(mut self, text: &str, x: f64, y: f64, side: Side) -> Self {
        self.label = Some((text.into(), LabelPlace::At((x, y), side)));
        self
    }
}

impl Curve {
    /// Whether it runs from left to right, as what depends on time does.
    pub(super) fn runs_on(&self) -> bool {
        self.points.windows(2).all(|w| w[0].0 <= w[1].0)
    }

    /// Draws its parts that lie within `x` and `y`.
    pub(super) fn paint(
        &self,
        frame: &Frame<'_>,
        parts: &[Vec<Point>],
        x: Point,
        y: Point,
    ) -> Result<()> {
        let inside = |p: &&Point| (x.0..=x.1).contains(&p.0) && (y.0..=y.1).contains(&p.1);
        let stroke =
            Stroke { dash: self.dash, opacity: self.opacity, ..Stroke::new(self.ink, self.width) };
        if self.line {
            for part in parts {
                frame.draw(part, &Paint::Line(stroke))?;
            }
        }
        if self.dots {
            let seen: Vec<Point> = self.points.iter().filter(inside).copied().collect();
            frame.draw(&seen, &Paint::Mark(self.ink, self.marker))?;
        }
        for &at in &self.arrows {
            let count = at.clamp(0.0, 1.0) * self.points.len() as f64;
            let run = self.points.iter().take(count as usize).filter(inside);
            frame.draw(&run.copied().collect::<Vec<_>>(), &Paint::Head(self.ink, 8.0))?;
        }
        Ok(())
    }

    /// Draws all of it.
    pub(super) fn paint_whole(&self, frame: &Frame<'_>) -> Result<()> {
        let all = (f64::NEG_INFINITY, f64::INFINITY);
        self.paint(frame, core::slice::from_ref(&self.points), all, all)
    }
}
