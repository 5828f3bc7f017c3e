//! Panels: curves over two axes.

use super::axis::Axis;
use super::canvas::{Point, Side, figure};
use super::ink::Ink;
use super::svg::Dash;
use crate::error::{Error, Result};
use crate::report::Figure;

/// Width of curves and of axes, in px.
pub(super) const CURVE: f64 = 1.8;
pub(super) const AXIS: f64 = 1.0;

#[derive(Debug, Clone, PartialEq)]
pub(super) enum LabelPlace {
    Found,
    End,
    At(Point, Side),
}

/// A curve or a set of dots in a [`Panel`].
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    pub(super) points: Vec<Point>,
    pub(super) ink: Ink,
    pub(super) width: f64,
    pub(super) opacity: f64,
    pub(super) dash: Dash,
    pub(super) line: bool,
    pub(super) dots: bool,
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
            arrows: Vec::new(),
            label: None,
        }
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
/// use rotation_dynamics::report::draw::{Axis, Curve, Ink, Panel};
/// let figure = Panel::new("fall", "height against time: a parabola that ends on the floor")
///     .x(Axis::linear("$t$ / s"))
///     .y(Axis::linear("$h$ / m"))
///     .curve(Curve::new((0..=50).map(|i| {
///         let t = 0.02 * f64::from(i);
///         (t, 5.0 * (1.0 - t * t))
///     }), Ink::Body).label("$h(t)$"))
///     .figure()?;
/// assert!(figure.svg.starts_with("<svg"));
/// # Ok::<(), rotation_dynamics::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Panel {
    pub(super) name: String,
    pub(super) alt: String,
    pub(super) size: (u32, u32),
    pub(super) x: Axis,
    pub(super) y: Axis,
    pub(super) equal: bool,
    pub(super) areas: Vec<(Vec<Point>, Ink, f64)>,
    pub(super) rules: Vec<(Rule, Ink, String)>,
    pub(super) curves: Vec<Curve>,
    pub(super) notes: Vec<Note>,
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
        }
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
        self.areas.push((outline.into_iter().collect(), ink, 0.18));
        self
    }

    /// Adds a faint area between a curve and the level `base`.
    #[must_use]
    pub fn area_to(self, curve: impl IntoIterator<Item = (f64, f64)>, base: f64, ink: Ink) -> Self {
        let mut outline: Vec<Point> = curve.into_iter().collect();
        if let (Some(&first), Some(&last)) = (outline.first(), outline.last()) {
            outline.extend([(last.0, base), (first.0, base)]);
        }
        self.area(outline, ink)
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

    /// Adds a dot with a label; the label may be empty.
    #[must_use]
    pub fn dot(mut self, x: f64, y: f64, ink: Ink, label: &str, side: Side) -> Self {
        self.notes.push(Note {
            at: (x, y),
            text: label.into(),
            ink,
            side,
            dot: Some(false),
        });
        self
    }

    /// Adds a ring with a label: a point that is not reached, or the start.
    #[must_use]
    pub fn ring(mut self, x: f64, y: f64, ink: Ink, label: &str, side: Side) -> Self {
        self.notes.push(Note {
            at: (x, y),
            text: label.into(),
            ink,
            side,
            dot: Some(true),
        });
        self
    }

    /// Adds a text beside the point `(x, y)`.
    #[must_use]
    pub fn note(mut self, x: f64, y: f64, ink: Ink, text: &str, side: Side) -> Self {
        self.notes.push(Note {
            at: (x, y),
            text: text.into(),
            ink,
            side,
            dot: None,
        });
        self
    }

    /// Draws it.
    ///
    /// # Errors
    /// [`crate::Error::NotFinite`] for NaN and infinities,
    /// [`crate::Error::OutOfRange`] for an axis without length or a logarithm of what is
    /// not positive, [`crate::Error::Text`] for a bad name or a missing alternative text.
    pub fn figure(&self) -> Result<Figure> {
        let (x, y) = self.extents()?;
        let left = self.left_margin(y, f64::from(self.size.1) - 70.0)?;
        let size = self.fitted_size(left, x, y);
        figure(&self.name, &self.alt, size, |canvas| {
            self.paint(canvas, canvas.rect(), left, x, y, true)
        })
    }
}

/// Panels one above the other over one horizontal axis: several quantities against time.
#[derive(Debug, Clone, PartialEq)]
pub struct Stack {
    name: String,
    alt: String,
    width: u32,
    row: u32,
    panels: Vec<Panel>,
}

impl Stack {
    /// An empty stack; `alt` says in a sentence what is to be seen.
    pub fn new(name: &str, alt: &str) -> Self {
        Self {
            name: name.into(),
            alt: alt.into(),
            width: 340,
            row: 130,
            panels: Vec::new(),
        }
    }

    /// Sets the height of a row, in px (130 if never set).
    #[must_use]
    pub fn row_height(mut self, height: u32) -> Self {
        self.row = height;
        self
    }

    /// Adds a panel below; its name, alternative text and size are not used.
    #[must_use]
    pub fn panel(mut self, panel: Panel) -> Self {
        self.panels.push(panel);
        self
    }

    /// Draws it; the horizontal axis is the last panel's.
    ///
    /// # Errors
    /// As [`Panel::figure`]; [`Error::Text`] if there is no panel.
    pub fn figure(&self) -> Result<Figure> {
        let Some(last) = self.panels.len().checked_sub(1) else {
            return Err(Error::Text {
                text: self.name.clone(),
                allowed: "a stack has at least one panel",
            });
        };
        let mut x = (f64::INFINITY, f64::NEG_INFINITY);
        let (mut ys, mut left) = (Vec::new(), 0.0_f64);
        for panel in &self.panels {
            let (own, y) = panel.extents()?;
            x = (x.0.min(own.0), x.1.max(own.1));
            left = left.max(panel.left_margin(y, f64::from(self.row) - 45.0)?);
            ys.push(y);
        }
        // The last row is taller by the labels of its axis.
        let rows = u32::try_from(last).unwrap_or(u32::MAX).saturating_add(1);
        let size = (self.width, self.row.saturating_mul(rows).saturating_add(36));
        figure(&self.name, &self.alt, size, |canvas| {
            let mut rect = canvas.rect();
            for (i, (panel, y)) in self.panels.iter().zip(ys).enumerate() {
                rect.bottom = if i == last {
                    canvas.rect().bottom
                } else {
                    rect.top + f64::from(self.row)
                };
                panel.paint(canvas, rect, left, x, y, i == last)?;
                rect.top = rect.bottom;
            }
            Ok(())
        })
    }
}
