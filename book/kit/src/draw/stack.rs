//! Pictures one above the other in one figure.

use super::canvas::{Canvas, Point, figure};
use super::panel::Panel;
use super::sketch::Sketch;
use super::view::View;
use super::words::Rect;
use crate::Figure;
use crate::error::{Error, Result};

/// What stands above the panels of a [`Stack`].
#[derive(Debug, Clone)]
pub enum Scene {
    /// Three dimensions.
    View(View),
    /// A mechanism.
    Sketch(Sketch),
}

impl From<View> for Scene {
    fn from(view: View) -> Self {
        Self::View(view)
    }
}

impl From<Sketch> for Scene {
    fn from(sketch: Sketch) -> Self {
        Self::Sketch(sketch)
    }
}

impl Scene {
    /// Its height when it is so wide, in px.
    fn height(&self, width: f64) -> Result<f64> {
        match self {
            Self::View(view) => Ok(view.height(width)),
            Self::Sketch(sketch) => sketch.height(width),
        }
    }

    fn paint(&self, canvas: &Canvas, rect: Rect) -> Result<()> {
        match self {
            Self::View(view) => view.furnished().paint_into(canvas, rect),
            Self::Sketch(sketch) => sketch.paint_into(canvas, rect),
        }
    }
}

/// Scenes, and below them panels over one horizontal axis: several quantities against
/// time; one moment of a motion with its graph.
///
/// ```
/// use kit::draw::{Curve, Ink, Panel, Sketch, Stack};
/// use kit::times;
/// let x = |t: f64| 0.5 * rotation_dynamics::math::cos(t);
/// let graph = Panel::new("graph", "").over("$t$ / s", "$x$ / m");
/// let graph = graph.curve(Curve::of(times(0.0, 6.0, 60), x, Ink::Body));
/// let frame = |t: f64| {
///     let ball = Sketch::new("scene", "").window((-1.0, 1.0), (-0.2, 0.6)).disc((x(t), 0.2), 0.2, Ink::Body, 0.3);
///     Stack::frame("a ball swings to and fro; below it its place against time", ball, &graph, t)
/// };
/// assert_eq!(frame(1.0)?.display.size, (340, 302));
/// # Ok::<(), kit::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct Stack {
    name: String,
    alt: String,
    width: u32,
    row: u32,
    scenes: Vec<Scene>,
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
            scenes: Vec::new(),
            panels: Vec::new(),
        }
    }

    /// The usual frame of a moving picture: a scene above a graph over time, at the time `t`.
    ///
    /// # Errors
    /// As [`Stack::figure`].
    pub fn frame(alt: &str, scene: impl Into<Scene>, graph: &Panel, t: f64) -> Result<Figure> {
        let stack = Self::new("frame", alt).row_height(graph.row).scene(scene);
        stack.panel(graph.clone().now(t)).figure()
    }

    pub(super) fn called(mut self, name: &str, alt: &str) -> Self {
        (self.name, self.alt) = (name.into(), alt.into());
        self
    }

    /// Sets the height of a panel's row, in px (130 if never set).
    #[must_use]
    pub fn row_height(mut self, height: u32) -> Self {
        self.row = height;
        self
    }

    /// Adds a scene, below those before it and above all panels; its name and alternative
    /// text are not used, its size only in proportion.
    #[must_use]
    pub fn scene(mut self, scene: impl Into<Scene>) -> Self {
        self.scenes.push(scene.into());
        self
    }

    /// Adds a panel below; its name, alternative text and size are not used.
    #[must_use]
    pub fn panel(mut self, panel: Panel) -> Self {
        self.panels.push(panel);
        self
    }

    /// The common horizontal extent, the left margin, and the vertical extents.
    fn shared(&self) -> Result<(Point, f64, Vec<Point>)> {
        let mut x = (f64::INFINITY, f64::NEG_INFINITY);
        let (mut ys, mut left) = (Vec::new(), 0.0_f64);
        for panel in &self.panels {
            let (own, y) = panel.extents()?;
            x = (x.0.min(own.0), x.1.max(own.1));
            left = left.max(panel.left_margin(y, f64::from(self.row) - 45.0)?);
            ys.push(y);
        }
        Ok((x, left, ys))
    }

    /// Draws it; the horizontal axis is the last panel's.
    ///
    /// # Errors
    /// As [`Panel::figure`], [`View::figure`] and [`Sketch::figure`]; [`Error::Text`] if
    /// there is no panel.
    pub fn figure(&self) -> Result<Figure> {
        let Some(last) = self.panels.len().checked_sub(1) else {
            return Err(Error::Text {
                text: self.name.clone(),
                allowed: "a stack has at least one panel",
            });
        };
        let width = f64::from(self.width);
        let heights = self.scenes.iter().map(|scene| scene.height(width));
        let heights: Vec<f64> = heights.collect::<Result<_>>()?;
        let (x, left, ys) = self.shared()?;
        // The last row is taller by the labels of its axis.
        let rows = u32::try_from(last).unwrap_or(u32::MAX).saturating_add(1);
        let above = heights.iter().sum::<f64>() as u32;
        let below = self.row.saturating_mul(rows).saturating_add(36);
        figure(&self.name, &self.alt, (self.width, above.saturating_add(below)), |canvas| {
            let whole = canvas.rect();
            let mut rect = Rect { bottom: 0.0, ..whole };
            for (scene, height) in self.scenes.iter().zip(heights) {
                rect.bottom = rect.top + height;
                scene.paint(canvas, rect)?;
                rect.top = rect.bottom;
            }
            for (i, (panel, y)) in self.panels.iter().zip(ys).enumerate() {
                rect.bottom = if i == last { whole.bottom } else { rect.top + f64::from(self.row) };
                panel.paint(canvas, rect, left, x, y, i == last)?;
                rect.top = rect.bottom;
            }
            Ok(())
        })
    }
}
