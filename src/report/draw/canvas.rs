//! What the kinds of figures share: marks, drawn through plotters' coordinates.

use super::ink::Ink;
use super::label::{Label, SIZE};
use super::svg::{Anchor, Dash, Stroke, Svg, UNITS};
use crate::error::{Error, Result, finite};
use crate::math::{atan2, hypot, sincos};
use crate::report::Figure;
use core::convert::Infallible;
use plotters::coord::{Shift, types::RangedCoordf64};
use plotters::element::{Drawable, PointCollection};
use plotters::prelude::{Cartesian2d, DrawingArea, IntoDrawingArea};
use plotters_backend::{BackendCoord, DrawingErrorKind};

/// A point in the coordinates of its figure.
pub(super) type Point = (f64, f64);

/// A rectangle in px; `top < bottom`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Rect {
    pub left: f64,
    pub right: f64,
    pub top: f64,
    pub bottom: f64,
}

impl Rect {
    pub(super) fn overlaps(&self, other: &Self) -> bool {
        self.left < other.right
            && other.left < self.right
            && self.top < other.bottom
            && other.top < self.bottom
    }

    pub(super) fn contains(&self, (x, y): Point) -> bool {
        (self.left..=self.right).contains(&x) && (self.top..=self.bottom).contains(&y)
    }

    /// The distance of a point; 0 inside.
    pub(super) fn distance(&self, (x, y): Point) -> f64 {
        let outside = |low: f64, value: f64, high: f64| (low - value).max(value - high).max(0.0);
        hypot(
            outside(self.left, x, self.right),
            outside(self.top, y, self.bottom),
        )
    }

    pub(super) fn grown(&self, by: f64) -> Self {
        Self {
            left: self.left - by,
            right: self.right + by,
            top: self.top - by,
            bottom: self.bottom + by,
        }
    }
}

/// On which side of its point a label lies.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// Above it, centred.
    Above,
    /// Below it, centred.
    Below,
    /// To its left.
    Left,
    /// To its right.
    Right,
    /// Above and to the left.
    AboveLeft,
    /// Above and to the right.
    AboveRight,
    /// Below and to the left.
    BelowLeft,
    /// Below and to the right.
    BelowRight,
    /// On it.
    Centre,
}

/// A text with its place: the box it fills is known before it is drawn.
#[derive(Debug, Clone)]
pub(super) struct Text {
    pub label: Label,
    pub size: f64,
    pub ink: Ink,
    anchor: Anchor,
    shift: Point,
}

impl Text {
    /// `text` on this side of its point, `gap` px away from it.
    pub(super) fn new(text: &str, ink: Ink, side: Side, gap: f64) -> Self {
        let size = SIZE;
        // Letters reach about 0.72 above and 0.22 below the baseline.
        let (above, middle, below) = (-gap - 0.12 * size, 0.34 * size, gap + 0.74 * size);
        let (anchor, dx, dy) = match side {
            Side::Above => (Anchor::Middle, 0.0, above),
            Side::Below => (Anchor::Middle, 0.0, below),
            Side::Left => (Anchor::End, -gap, middle),
            Side::Right => (Anchor::Start, gap, middle),
            Side::AboveLeft => (Anchor::End, -0.7 * gap, above + 0.3 * gap),
            Side::AboveRight => (Anchor::Start, 0.7 * gap, above + 0.3 * gap),
            Side::BelowLeft => (Anchor::End, -0.7 * gap, below - 0.3 * gap),
            Side::BelowRight => (Anchor::Start, 0.7 * gap, below - 0.3 * gap),
            Side::Centre => (Anchor::Middle, 0.0, middle),
        };
        Self {
            label: Label::new(text),
            size,
            ink,
            anchor,
            shift: (dx, dy),
        }
    }

    /// The box it fills when drawn at `at` (px).
    pub(super) fn rect(&self, at: Point) -> Rect {
        let width = self.label.width(self.size);
        let x = at.0 + self.shift.0;
        let left = match self.anchor {
            Anchor::Start => x,
            Anchor::Middle => x - width / 2.0,
            Anchor::End => x - width,
        };
        let baseline = at.1 + self.shift.1;
        Rect {
            left,
            right: left + width,
            top: baseline - 0.78 * self.size,
            bottom: baseline + 0.26 * self.size,
        }
    }
}

/// What a mark is made of.
#[derive(Debug, Clone)]
pub(super) enum Paint {
    Line(Stroke),
    Loop(Stroke),
    Fill(Ink, f64),
    /// An opaque face: so many percent of ink on paper.
    Face(Ink, u32),
    /// Radius in px, and whether only its rim is drawn.
    Dot(Ink, f64, bool),
    Text(Text),
    /// A line that ends in a head of this length (px); open or solid.
    Arrow(Stroke, f64, bool),
    /// Only the head, of this length (px), of an arrow along the line.
    Head(Ink, f64),
    /// An arrow with a head at both ends.
    Dimension(Stroke),
}

/// A drawing element: points in the figure's coordinates, and what to make of them.
#[derive(Debug, Clone)]
pub(super) struct Mark {
    pub points: Vec<Point>,
    pub paint: Paint,
}

impl<'a> PointCollection<'a, Point> for &'a Mark {
    type Point = &'a Point;
    type IntoIter = core::slice::Iter<'a, Point>;
    fn point_iter(self) -> Self::IntoIter {
        self.points.iter()
    }
}

impl Drawable<Svg<'_>> for Mark {
    fn draw<I: Iterator<Item = BackendCoord>>(
        &self,
        points: I,
        svg: &mut Svg<'_>,
        _: (u32, u32),
    ) -> core::result::Result<(), DrawingErrorKind<Infallible>> {
        let mut points: Vec<BackendCoord> = points.collect();
        match &self.paint {
            Paint::Line(stroke) => svg.line(&points, *stroke, false),
            Paint::Loop(stroke) => svg.line(&points, *stroke, true),
            Paint::Fill(ink, alpha) => svg.fill(&points, *ink, *alpha),
            Paint::Face(ink, percent) => svg.face(&points, *ink, *percent),
            Paint::Dot(ink, radius, ring) => {
                for &point in &points {
                    svg.dot(point, *radius, *ink, *ring);
                }
            }
            Paint::Text(text) if text.label.is_empty() => {}
            Paint::Text(text) => {
                for &(x, y) in &points {
                    let at = (x + units(text.shift.0), y + units(text.shift.1));
                    svg.text(at, &text.label, text.size, text.anchor, text.ink);
                }
            }
            Paint::Arrow(stroke, head, open) => {
                let tip = head_at_end(&mut points, *head, *open);
                svg.line(&points, *stroke, false);
                draw_head(svg, &tip, *stroke, *open);
            }
            Paint::Head(ink, length) => {
                let head = head_at_end(&mut points, *length, false);
                draw_head(svg, &head, Stroke::new(*ink, 1.0), false);
            }
            Paint::Dimension(stroke) => {
                let end = head_at_end(&mut points, 8.0, false);
                points.reverse();
                let start = head_at_end(&mut points, 8.0, false);
                svg.line(&points, *stroke, false);
                draw_head(svg, &end, *stroke, false);
                draw_head(svg, &start, *stroke, false);
            }
        }
        Ok(())
    }
}

fn units(px: f64) -> i32 {
    libm::round(px * UNITS) as i32
}

/// The head of an arrow along the end of `points`: barb, tip, barb. A solid head
/// shortens the line, so that its end does not blunt the tip.
fn head_at_end(points: &mut [BackendCoord], length: f64, open: bool) -> Vec<BackendCoord> {
    let Some((&tip, before)) = points.split_last() else {
        return Vec::new();
    };
    let far =
        |p: &&BackendCoord| hypot(f64::from(p.0 - tip.0), f64::from(p.1 - tip.1)) >= length * UNITS;
    // The direction is taken over the length of the head, so that it follows a curve.
    let Some(&from) = before.iter().rev().find(far).or(before.first()) else {
        return Vec::new();
    };
    let direction = atan2(f64::from(tip.1 - from.1), f64::from(tip.0 - from.0));
    let barb = |turn: f64| {
        let (s, c) = sincos(direction + turn);
        (tip.0 - units(length * c), tip.1 - units(length * s))
    };
    let head = vec![barb(0.36), tip, barb(-0.36)];
    if !open {
        let (s, c) = sincos(direction);
        let end = (
            tip.0 - units(0.8 * length * c),
            tip.1 - units(0.8 * length * s),
        );
        for p in points.iter_mut().rev() {
            let inside =
                hypot(f64::from(p.0 - tip.0), f64::from(p.1 - tip.1)) < 0.8 * length * UNITS;
            if !inside {
                break;
            }
            *p = end;
        }
    }
    head
}

fn draw_head(svg: &mut Svg<'_>, head: &[BackendCoord], stroke: Stroke, open: bool) {
    if open {
        let solid = Stroke {
            dash: Dash::Solid,
            ..stroke
        };
        svg.line(head, solid, false);
    } else {
        svg.fill(head, stroke.ink, stroke.opacity);
    }
}

/// A part of the canvas with its own coordinates.
pub(super) struct Frame<'a> {
    area: DrawingArea<Svg<'a>, Cartesian2d<RangedCoordf64, RangedCoordf64>>,
    x: Point,
    y: Point,
}

impl Frame<'_> {
    /// Draws `paint` at `points`.
    pub(super) fn draw(&self, points: &[Point], paint: Paint) -> Result<()> {
        self.mark(&Mark {
            points: points.to_vec(),
            paint,
        })
    }

    pub(super) fn mark(&self, mark: &Mark) -> Result<()> {
        for &(x, y) in &mark.points {
            // Far outside the sheet the backend's integers would overflow.
            for (name, value, (from, to)) in
                [("x in a figure", x, self.x), ("y in a figure", y, self.y)]
            {
                finite(name, value)?;
                if ((value - from) / (to - from)).abs() > 100.0 {
                    return Err(Error::OutOfRange {
                        name,
                        value,
                        allowed: "it must not lie far outside the figure",
                    });
                }
            }
        }
        self.area.draw(mark).map_err(|e| Error::Text {
            text: e.to_string(),
            allowed: "drawing cannot fail",
        })
    }

    /// Where `point` comes to lie, in px.
    pub(super) fn px(&self, point: Point) -> Point {
        let (x, y) = self.area.map_coordinate(&point);
        (f64::from(x) / UNITS, f64::from(y) / UNITS)
    }
}

/// A sheet of paper.
pub(super) struct Canvas<'a> {
    area: DrawingArea<Svg<'a>, Shift>,
    width: f64,
    height: f64,
}

impl<'a> Canvas<'a> {
    /// Coordinates in which `x` and `y`, from first to second, fill `rect` from left
    /// to right and from bottom to top.
    pub(super) fn frame(&self, x: Point, y: Point, rect: Rect) -> Frame<'a> {
        let across = units(rect.left)..units(rect.right);
        let up = units(rect.bottom)..units(rect.top);
        let spec =
            Cartesian2d::<RangedCoordf64, RangedCoordf64>::new(x.0..x.1, y.0..y.1, (across, up));
        Frame {
            area: self.area.apply_coord_spec(spec),
            x,
            y,
        }
    }

    /// Coordinates in px, from the upper left corner.
    pub(super) fn sheet(&self) -> Frame<'a> {
        self.frame((0.0, self.width), (self.height, 0.0), self.rect())
    }

    /// The whole sheet.
    pub(super) fn rect(&self) -> Rect {
        Rect {
            left: 0.0,
            right: self.width,
            top: 0.0,
            bottom: self.height,
        }
    }
}

/// A figure of `size` px with what `draw` draws on it.
pub(super) fn figure(
    name: &str,
    alt: &str,
    size: (u32, u32),
    draw: impl FnOnce(&Canvas<'_>) -> Result<()>,
) -> Result<Figure> {
    let plain = |b: u8| b.is_ascii_lowercase() || b.is_ascii_digit() || b == b'_';
    if name.is_empty() || !name.bytes().all(plain) {
        return Err(Error::Text {
            text: name.into(),
            allowed: "the name of a figure has only a-z, 0-9 and _",
        });
    }
    if alt.trim().len() < 20 {
        return Err(Error::Text {
            text: alt.into(),
            allowed: "the alternative text of a figure says in a sentence what is to be seen",
        });
    }
    let mut svg = String::new();
    let canvas = Canvas {
        area: Svg::open(&mut svg, size, alt).into_drawing_area(),
        width: f64::from(size.0),
        height: f64::from(size.1),
    };
    draw(&canvas)?;
    canvas.area.present().map_err(|e| Error::Text {
        text: e.to_string(),
        allowed: "drawing cannot fail",
    })?;
    drop(canvas);
    Ok(Figure {
        name: name.into(),
        svg,
        alt: alt.into(),
    })
}
