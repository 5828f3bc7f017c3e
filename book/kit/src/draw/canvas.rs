//! A sheet of paper: marks in the coordinates of a figure become a display list.

use super::backend::{Mark, Scale, Sheet};
use super::display::{Dash, Display, NEAR, Place, Shape, Stroke, Text, UNITS, thinned};
use super::ink::Ink;
use super::label::SIZE;
use super::method::Marker;
use super::words::{Rect, Words};
use crate::Figure;
use crate::error::{Error, Result, finite};
use crate::number::without_minus_nought;
use core::cell::RefCell;
use core::f64::consts::PI;
use plotters::coord::Shift;
use plotters::drawing::{DrawingArea, IntoDrawingArea};
use plotters::prelude::Cartesian2d;
use rotation_dynamics::math::{atan2, hypot, sincos};

/// A point in the coordinates of its figure.
pub(super) type Point = (f64, f64);

/// What a mark is made of.
#[derive(Debug, Clone)]
pub(super) enum Paint {
    Line(Stroke),
    Loop(Stroke),
    Fill(Ink, f64),
    /// An opaque face with so many percent of light.
    Face(Ink, u32),
    /// Radius in px, and whether only its rim is drawn.
    Dot(Ink, f64, bool),
    Mark(Ink, Marker),
    Text(Words),
    /// A line that ends in a head of this length (px); open or solid.
    Arrow(Stroke, f64, bool),
    /// Only the head, of this length (px), of an arrow along the line.
    Head(Ink, f64),
    /// An arrow with a head at both ends.
    Dimension(Stroke),
}

impl Display {
    fn line(&mut self, points: &[Place], closed: bool, stroke: Stroke) {
        if points.len() >= 2 {
            self.shapes.push(Shape::Line(thinned(points, NEAR), closed, stroke));
        }
    }

    fn area(&mut self, points: &[Place], ink: Ink, opacity: f64) {
        if points.len() >= 3 {
            // The edge of a shadow is soft.
            let near = if ink == Ink::Shadow { 20.0 * NEAR } else { NEAR };
            self.shapes.push(Shape::Area(thinned(points, near), ink, opacity));
        }
    }

    pub(super) fn mark(&mut self, mut points: Vec<Place>, paint: &Paint) {
        match paint {
            Paint::Line(stroke) => self.line(&points, false, *stroke),
            Paint::Loop(stroke) => self.line(&points, true, *stroke),
            Paint::Fill(ink, alpha) => self.area(&points, *ink, *alpha),
            Paint::Face(ink, light) => {
                self.shapes.push(Shape::Face(thinned(&points, NEAR), *ink, *light));
            }
            Paint::Dot(ink, radius, ring) => {
                let dots = points.iter().map(|&p| Shape::Dot(p, *radius, *ink, *ring));
                self.shapes.extend(dots);
            }
            Paint::Mark(ink, marker) => {
                for at in points {
                    self.marker(at, *ink, *marker);
                }
            }
            Paint::Text(words) if words.label.is_empty() => {}
            Paint::Text(words) => {
                let text = |&(x, y): &Place| Text {
                    at: (x + units(words.shift.0), y + units(words.shift.1)),
                    anchor: words.anchor,
                    ink: words.ink,
                    halo: words.halo,
                    runs: words.label.runs(SIZE),
                };
                self.texts.extend(points.iter().map(text));
            }
            Paint::Arrow(stroke, head, open) => {
                let tip = head_at_end(&mut points, *head, *open);
                self.line(&points, false, *stroke);
                self.head(&tip, *stroke, *open);
            }
            Paint::Head(ink, length) => {
                let head = head_at_end(&mut points, *length, false);
                self.head(&head, Stroke::new(*ink, 1.0), false);
            }
            Paint::Dimension(stroke) => {
                let end = head_at_end(&mut points, 8.0, false);
                points.reverse();
                let start = head_at_end(&mut points, 8.0, false);
                self.line(&points, false, *stroke);
                self.head(&end, *stroke, false);
                self.head(&start, *stroke, false);
            }
        }
    }

    /// All markers cover about the same area.
    fn marker(&mut self, at: Place, ink: Ink, marker: Marker) {
        let (radius, corners, turn) = match marker {
            Marker::Disc => return self.shapes.push(Shape::Dot(at, 2.6, ink, false)),
            Marker::Ring => return self.shapes.push(Shape::Dot(at, 2.4, ink, true)),
            Marker::Square => (3.3, 4, PI / 4.0),
            Marker::Diamond => (3.5, 4, 0.0),
            Marker::Triangle => (3.9, 3, -PI / 2.0),
        };
        let corner = |i: u32| {
            let (s, c) = sincos(turn + 2.0 * PI * f64::from(i) / f64::from(corners));
            (at.0 + units(radius * c), at.1 + units(radius * s))
        };
        let outline: Vec<Place> = (0..corners).map(corner).collect();
        self.area(&outline, ink, 1.0);
    }

    fn head(&mut self, head: &[Place], stroke: Stroke, open: bool) {
        if open {
            let solid = Stroke { dash: Dash::Solid, ..stroke };
            self.line(head, false, solid);
        } else {
            self.area(head, stroke.ink, stroke.opacity);
        }
    }
}

pub(super) fn units(px: f64) -> i32 {
    libm::round(px * UNITS) as i32
}

/// The head of an arrow along the end of `points`: barb, tip, barb. A solid head
/// shortens the line, so that its end does not blunt the tip.
pub(super) fn head_at_end(points: &mut [Place], length: f64, open: bool) -> Vec<Place> {
    let Some((&tip, before)) = points.split_last() else {
        return Vec::new();
    };
    let far = |p: &&Place| hypot(f64::from(p.0 - tip.0), f64::from(p.1 - tip.1)) >= length * UNITS;
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
        let end = (tip.0 - units(0.8 * length * c), tip.1 - units(0.8 * length * s));
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

/// A part of the sheet with its own coordinates.
pub(super) struct Frame<'a>(pub(super) DrawingArea<Sheet<'a>, Cartesian2d<Scale, Scale>>);

impl Frame<'_> {
    /// Draws `paint` at `points`.
    pub(super) fn draw(&self, points: &[Point], paint: &Paint) -> Result<()> {
        let (across, up) = (self.0.get_x_range(), self.0.get_y_range());
        for &(x, y) in points {
            for (name, value, range) in [("x in a figure", x, &across), ("y in a figure", y, &up)] {
                finite(name, value)?;
                // Far outside the sheet the whole numbers would overflow.
                if ((value - range.start) / (range.end - range.start)).abs() > 100.0 {
                    let allowed = "it must not lie far outside the figure";
                    return Err(rotation_dynamics::Error::out_of_range(name, value, allowed).into());
                }
            }
        }
        drawn(self.0.draw(&Mark(points, paint)));
        Ok(())
    }

    /// Where `point` comes to lie, in px.
    pub(super) fn px(&self, point: Point) -> Point {
        let (x, y) = self.0.map_coordinate(&point);
        (f64::from(x) / UNITS, f64::from(y) / UNITS)
    }
}

/// What plotters answers: a display list takes all that is drawn.
pub(super) fn drawn<T, E: core::fmt::Debug>(answer: core::result::Result<T, E>) -> T {
    answer.expect("nothing else draws on the sheet meanwhile")
}

/// A sheet of paper.
pub(super) struct Canvas {
    pub(super) display: RefCell<Display>,
}

impl Canvas {
    /// An empty one, of this width and height in px.
    pub(super) fn new(size: (u32, u32)) -> Self {
        let (shapes, texts) = (Vec::new(), Vec::new());
        let display = RefCell::new(Display { size, shapes, texts });
        Self { display }
    }

    /// All of it, in plotters' pixels.
    pub(super) fn area(&self) -> DrawingArea<Sheet<'_>, Shift> {
        Sheet(&self.display).into_drawing_area()
    }

    /// Coordinates in which `x` and `y`, from first to second, fill `rect` from left
    /// to right and from bottom to top.
    pub(super) fn frame(&self, x: Point, y: Point, rect: Rect) -> Frame<'_> {
        let across = units(rect.left)..units(rect.right);
        let up = units(rect.bottom)..units(rect.top);
        let scale = |range| Scale::new(range, 0, Vec::new());
        let coordinates = Cartesian2d::new(scale(x), scale(y), (across, up));
        Frame(self.area().apply_coord_spec(coordinates))
    }

    /// Coordinates in px, from the upper left corner.
    pub(super) fn sheet(&self) -> Frame<'_> {
        let rect = self.rect();
        self.frame((0.0, rect.right), (rect.bottom, 0.0), rect)
    }

    /// The whole sheet.
    pub(super) fn rect(&self) -> Rect {
        let (width, height) = self.display.borrow().size;
        Rect { left: 0.0, right: f64::from(width), top: 0.0, bottom: f64::from(height) }
    }

    /// Adds what was drawn elsewhere.
    pub(super) fn again(&self, drawn: &Display) {
        let mut display = self.display.borrow_mut();
        display.shapes.extend_from_slice(&drawn.shapes);
        display.texts.extend_from_slice(&drawn.texts);
    }
}

/// A figure of `size` px with what `draw` draws on it.
pub(super) fn figure(
    name: &str,
    alt: &str,
    size: (u32, u32),
    draw: impl FnOnce(&Canvas) -> Result<()>,
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
    let canvas = Canvas::new(size);
    draw(&canvas)?;
    Ok(Figure {
        name: name.into(),
        alt: without_minus_nought(alt),
        display: canvas.display.into_inner(),
    })
}
