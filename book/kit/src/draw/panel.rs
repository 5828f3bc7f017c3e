//! Panels: curves over two axes.

use super::axis::Axis;
use super::canvas::{Point, figure};
use super::curve::Curve;
use super::display::Display;
use super::ink::Ink;
use super::words::{Rect, Side};
use crate::Figure;
use crate::error::Result;
use std::sync::{Arc, OnceLock};

#[derive(Debug, Clone, PartialEq)]
pub(super) enum Rule {
    Across(f64),
    Up(f64),
}

#[derive(Debug, Clone, PartialEq)]
pub(super) struct Note {
    pub(super) at: Point,
    pub(super) text: String,
    pub(super) ink: Ink,
    pub(super) side: Side,
    pub(super) dot: Option<bool>,
}

/// Two axes and what is drawn over them: a figure of about 340 px by 250 px.
///
/// ```
/// use kit::draw::{Curve, Ink, Panel};
/// use kit::times;
/// let figure = Panel::new("fall", "height against time: a parabola that ends on the floor")
///     .over("$t$ / s", "$h$ / m")
///     .curve(Curve::of(times(0.0, 1.0, 50), |t| 5.0 * (1.0 - t * t), Ink::Body).label("$h(t)$"))
///     .figure()?;
/// assert!(figure.svg().starts_with("<svg"));
/// # Ok::<(), kit::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Panel {
    pub(super) name: String,
    pub(super) alt: String,
    pub(super) size: (u32, u32),
    pub(super) x: Axis,
    pub(super) y: Axis,
    pub(super) equal: bool,
    pub(super) areas: Vec<(Vec<Point>, Ink)>,
    pub(super) rules: Vec<(Rule, Ink, String)>,
    pub(super) curves: Vec<Curve>,
    pub(super) notes: Vec<Note>,
    pub(super) now: Option<f64>,
    /// Its height below a moving scene, in px.
    pub(super) row: u32,
    /// The labels with what they were placed in, if they are kept.
    pub(super) labels: Option<Arc<OnceLock<(Rect, Display)>>>,
}

impl Panel {
    /// An empty panel; `alt` says in a sentence what is to be seen.
    pub fn new(name: &str, alt: &str) -> Self {
        Self {
            name: name.into(),
            alt: alt.into(),
            size: (340, 250),
            x: Axis::linear(""),
            y: Axis::linear(""),
            equal: false,
            areas: Vec::new(),
            rules: Vec::new(),
            curves: Vec::new(),
            notes: Vec::new(),
            now: None,
            row: 130,
            labels: None,
        }
    }

    /// An empty panel over these axes, for [`figures!`](crate::figures), which names it and
    /// says what is to be seen, and as a graph below a scene. A text is a linear axis.
    ///
    /// ```
    /// use kit::draw::{Axis, Panel};
    /// let graph = Panel::over_axes("$t$ / s", Axis::angle(r"$\theta$ / rad").range(0.0, 1.6));
    /// ```
    pub fn over_axes(x: impl Into<Axis>, y: impl Into<Axis>) -> Self {
        Self::new("", "").x(x.into()).y(y.into())
    }

    /// The label of its horizontal axis.
    pub(crate) fn horizontal(&self) -> &str {
        &self.x.label
    }

    pub(super) fn called(mut self, name: &str, alt: &str) -> Self {
        (self.name, self.alt) = (name.into(), alt.into());
        self
    }

    /// Sets the size in px; the width should stay 340, which fits a phone.
    #[must_use]
    pub fn size(mut self, width: u32, height: u32) -> Self {
        self.size = (width, height);
        self
    }

    /// Sets the horizontal axis.
    #[must_use]
    pub fn x(mut self, axis: Axis) -> Self {
        self.x = axis;
        self
    }

    /// Sets the vertical axis.
    #[must_use]
    pub fn y(mut self, axis: Axis) -> Self {
        self.y = axis;
        self
    }

    /// Sets both axes, linear and as long as what is drawn, by their labels.
    #[must_use]
    pub fn over(self, x: &str, y: &str) -> Self {
        self.x(Axis::linear(x)).y(Axis::linear(y))
    }

    /// A unit is as long on both axes; the height follows.
    #[must_use]
    pub fn equal_aspect(mut self) -> Self {
        self.equal = true;
        self
    }

    /// Adds a curve.
    #[must_use]
    pub fn curve(mut self, curve: Curve) -> Self {
        self.curves.push(curve);
        self
    }

    /// Adds a faint area with this outline.
    #[must_use]
    pub fn area(mut self, outline: impl IntoIterator<Item = (f64, f64)>, ink: Ink) -> Self {
        self.areas.push((outline.into_iter().collect(), ink));
        self
    }

    /// Adds a thin line across the panel at height `y`; `label` may be empty.
    #[must_use]
    pub fn level(mut self, y: f64, ink: Ink, label: &str) -> Self {
        self.rules.push((Rule::Across(y), ink, label.into()));
        self
    }

    /// Adds a thin upright line at `x`; `label` may be empty.
    #[must_use]
    pub fn upright(mut self, x: f64, ink: Ink, label: &str) -> Self {
        self.rules.push((Rule::Up(x), ink, label.into()));
        self
    }

    fn noted(mut self, at: Point, ink: Ink, text: &str, side: Side, dot: Option<bool>) -> Self {
        let text = text.into();
        self.notes.push(Note { at, text, ink, side, dot });
        self
    }

    /// Adds a dot with a label; the label may be empty.
    #[must_use]
    pub fn dot(self, x: f64, y: f64, ink: Ink, label: &str, side: Side) -> Self {
        self.noted((x, y), ink, label, side, Some(false))
    }

    /// Adds a ring with a label: a point that is not reached, or the start.
    #[must_use]
    pub fn ring(self, x: f64, y: f64, ink: Ink, label: &str, side: Side) -> Self {
        self.noted((x, y), ink, label, side, Some(true))
    }

    /// Adds a text beside the point `(x, y)`.
    #[must_use]
    pub fn note(self, x: f64, y: f64, ink: Ink, text: &str, side: Side) -> Self {
        self.noted((x, y), ink, text, side, None)
    }

    /// Marks the present: curves are faint beyond `x`, with a dot where they pass it.
    #[must_use]
    pub fn now(mut self, x: f64) -> Self {
        self.now = Some(x);
        self
    }

    /// Is low below a moving scene: the scene is the picture.
    #[must_use]
    pub fn low(mut self) -> Self {
        self.row = 78;
        self
    }

    /// It is finished: places for its labels are searched once, for all of its clones.
    pub(crate) fn keeping_labels(mut self) -> Self {
        self.labels = Some(Arc::default());
        self
    }

    /// Draws it.
    ///
    /// # Errors
    /// [`Error::NotFinite`](rotation_dynamics::Error::NotFinite) for NaN and infinities,
    /// [`Error::OutOfRange`](rotation_dynamics::Error::OutOfRange) for an axis without length or
    /// a logarithm of what is not positive, [`crate::Error::Text`] for a bad name or a missing
    /// alternative text.
    pub fn figure(&self) -> Result<Figure> {
        let (x, y) = self.extents()?;
        let left = self.left_margin(y, f64::from(self.size.1) - 70.0)?;
        let size = self.fitted_size(left, x, y);
        figure(&self.name, &self.alt, size, |canvas| {
            self.paint(canvas, canvas.rect(), left, x, y, true)
        })
    }
}
