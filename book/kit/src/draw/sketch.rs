//! Drawings of set-ups, and strobe pictures.

use super::canvas::{Canvas, Frame, Paint, Point, figure};
use super::curve::{AXIS, CURVE, Curve, LabelPlace};
use super::display::Stroke;
use super::ink::Ink;
use super::place::{GAP, Obstacles};
use super::words::{Rect, Side, Words};
use crate::Figure;
use crate::error::Result;
use rotation_dynamics::math::{hypot, sincos};

/// Length of the head of an arrow, in px.
const HEAD: f64 = 9.0;

#[derive(Debug, Clone)]
pub(super) enum Element {
    Curve(Curve),
    Arrow(Vec<Point>, Ink),
    Dimension(Point, Point),
    Wall(Point, Point),
    Solid(Vec<Point>, Ink, f64),
    Dot(Point, Ink, bool),
    /// Faint copies: all of these, with so much of their ink.
    Ghost(Vec<Self>, f64),
}

impl Element {
    fn mirror(&mut self) {
        let turn = |point: &mut Point| point.0 = -point.0;
        match self {
            Self::Curve(curve) => curve.points.iter_mut().for_each(turn),
            Self::Arrow(points, _) | Self::Solid(points, ..) => points.iter_mut().for_each(turn),
            Self::Dimension(from, to) | Self::Wall(from, to) => {
                [from, to].into_iter().for_each(turn)
            }
            Self::Dot(point, ..) => turn(point),
            Self::Ghost(all, _) => all.iter_mut().for_each(Self::mirror),
        }
    }
}

/// A drawing in its own units, equal on both axes: `x` to the right, `y` up.
///
/// Elements are painted in the order in which they are added, labels last.
///
/// ```
/// use kit::draw::{Curve, Ink, Side, Sketch};
/// let figure = Sketch::new("setup", "a ladder between a wall and the floor")
///     .window((-0.4, 2.6), (-0.4, 3.2))
///     .wall((0.0, 3.1), (0.0, 0.0))
///     .wall((0.0, 0.0), (2.5, 0.0))
///     .curve(Curve::new([(0.0, 2.6), (1.5, 0.0)], Ink::Body).width(4.0))
///     .angle((0.0, 2.6), 0.7, (-1.5708, -1.0472), r"$\theta$")
///     .arrow((0.75, 1.3), (0.75, 0.5), Ink::Force, "$mg$", Side::Right)
///     .figure()?;
/// # assert!(figure.svg().contains("mg") || figure.svg().contains(">m"));
/// # Ok::<(), kit::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct Sketch {
    name: String,
    alt: String,
    width: u32,
    pub(super) x: Point,
    pub(super) y: Point,
    pub(super) elements: Vec<Element>,
    pub(super) texts: Vec<(Point, String, Ink, Side, f64)>,
}

impl Sketch {
    /// An empty sketch of the unit square; `alt` says in a sentence what is to be seen.
    pub fn new(name: &str, alt: &str) -> Self {
        Self {
            name: name.into(),
            alt: alt.into(),
            width: 340,
            x: (0.0, 1.0),
            y: (0.0, 1.0),
            elements: Vec::new(),
            texts: Vec::new(),
        }
    }

    /// An empty sketch that shows this, for [`figures!`](crate::figures), which names it and
    /// says what is to be seen.
    pub fn within(x: (f64, f64), y: (f64, f64)) -> Self {
        Self::new("", "").window(x, y)
    }

    pub(super) fn called(mut self, name: &str, alt: &str) -> Self {
        (self.name, self.alt) = (name.into(), alt.into());
        self
    }

    /// Sets what is shown: from left to right, from bottom to top.
    #[must_use]
    pub fn window(mut self, x: (f64, f64), y: (f64, f64)) -> Self {
        (self.x, self.y) = (x, y);
        self
    }

    /// With what `draw` adds, if it is `shown`.
    #[must_use]
    pub fn only_if(self, shown: bool, draw: impl FnOnce(Self) -> Self) -> Self {
        if shown { draw(self) } else { self }
    }

    /// The mirrored scene if `mirrored`: left and right are exchanged, and every sense of turning.
    #[must_use]
    pub fn mirrored_if(mut self, mirrored: bool) -> Self {
        if mirrored {
            self.x = (-self.x.1, -self.x.0);
            self.elements.iter_mut().for_each(Element::mirror);
            for (at, _, _, side, _) in &mut self.texts {
                (at.0, *side) = (-at.0, side.mirrored());
            }
        }
        self
    }

    /// Sets the width in px (340 if never set); the height follows from the window.
    #[must_use]
    pub fn width(mut self, px: u32) -> Self {
        self.width = px;
        self
    }

    /// Shows more to the left and right, or above and below, until it is so many px high.
    #[must_use]
    pub fn high(mut self, px: u32) -> Self {
        let (across, up) = (self.x.1 - self.x.0, self.y.1 - self.y.0);
        let (width, px) = (f64::from(self.width), f64::from(px));
        if libm::round(width * up / across) == px {
            return self;
        }
        let grown = |(low, high): Point, by: f64| (low - 0.5 * by, high + 0.5 * by);
        let unit = (across / width).max(up / px);
        self.x = grown(self.x, unit * width - across);
        self.y = grown(self.y, unit * px - up);
        self
    }

    /// Shows more, at the size it has, until about this box there are so many px: to its left and
    /// right, below and above it.
    #[must_use]
    pub fn clear(
        mut self,
        x: (f64, f64),
        y: (f64, f64),
        [left, right, below, above]: [f64; 4],
    ) -> Self {
        let (width, height) = (f64::from(self.width), (self.y.1 - self.y.0) / self.px());
        let needed = |shown: Point, (low, high): Point, size: f64, [before, after]: [f64; 2]| {
            ((high - low) / (size - before - after))
                .max((shown.1 - low) / (size - before))
                .max((high - shown.0) / (size - after))
        };
        let unit = self.px().max(needed(self.x, x, width, [left, right])).max(needed(
            self.y,
            y,
            height,
            [below, above],
        ));
        let about = |shown: Point, (low, high): Point, size: f64, [before, after]: [f64; 2]| {
            let first = 0.5 * (shown.0 + shown.1 - size * unit);
            let first = first.max(shown.1.max(high + after * unit) - size * unit);
            let first = first.min(shown.0.min(low - before * unit));
            (first, first + size * unit)
        };
        self.x = about(self.x, x, width, [left, right]);
        self.y = about(self.y, y, height, [below, above]);
        self
    }

    /// Adds a line; its dots, arrows and label count as in a panel.
    #[must_use]
    pub fn curve(mut self, curve: Curve) -> Self {
        self.elements.push(Element::Curve(curve));
        self
    }

    /// Adds a thin dashed line: an axis, a path, the edge that one does not see.
    #[must_use]
    pub fn guide(self, points: impl IntoIterator<Item = (f64, f64)>) -> Self {
        self.curve(Curve::new(points, Ink::Frame).thin().dashed())
    }

    /// Adds a string or a thin rod, with a label beside its middle.
    #[must_use]
    pub fn string(self, from: (f64, f64), to: (f64, f64), label: &str, side: Side) -> Self {
        let middle = ((from.0 + to.0) / 2.0, (from.1 + to.1) / 2.0);
        self.curve(Curve::new([from, to], Ink::Ink)).text(middle, label, Ink::Ink, side)
    }

    /// Adds a round weight, with a label to its right.
    #[must_use]
    pub fn weight(self, centre: (f64, f64), radius: f64, label: &str) -> Self {
        let beside = (centre.0 + radius, centre.1);
        self.disc(centre, radius, Ink::Body, 1.0).text(beside, label, Ink::Body, Side::Right)
    }

    /// Adds the arrow that says which way the acceleration of gravity points, so long.
    #[must_use]
    pub fn gravity(self, from: (f64, f64), length: f64) -> Self {
        let to = (from.0, from.1 - length);
        self.arrow(from, to, Ink::Frame, "$g$", Side::Left)
    }

    /// Adds an arrow with a label beside its middle. A force or torque has an open head.
    #[must_use]
    pub fn arrow(
        self,
        from: (f64, f64),
        to: (f64, f64),
        ink: Ink,
        label: &str,
        side: Side,
    ) -> Self {
        let middle = ((from.0 + to.0) / 2.0, (from.1 + to.1) / 2.0);
        self.arrow_along([from, to], ink).text(middle, label, ink, side)
    }

    /// Adds an arrow with a label beside its tip.
    #[must_use]
    pub fn arrow_to(
        self,
        from: (f64, f64),
        tip: (f64, f64),
        ink: Ink,
        label: &str,
        side: Side,
    ) -> Self {
        self.arrow_along([from, tip], ink).text(tip, label, ink, side)
    }

    /// Adds an arrow along a curve.
    #[must_use]
    pub fn arrow_along(mut self, points: impl IntoIterator<Item = (f64, f64)>, ink: Ink) -> Self {
        self.elements.push(Element::Arrow(points.into_iter().collect(), ink));
        self
    }

    /// Adds the arc of an angle about `centre`, between two directions in radians
    /// counted from the x axis, with a label outside its middle.
    #[must_use]
    pub fn angle(self, centre: (f64, f64), radius: f64, between: (f64, f64), label: &str) -> Self {
        let (s, c) = sincos((between.0 + between.1) / 2.0);
        // The label sits on the ray through the middle, beyond the arc.
        let beyond = radius + 13.0 * (self.x.1 - self.x.0) / f64::from(self.width);
        let at = (centre.0 + beyond * c, centre.1 + beyond * s);
        self.curve(Curve::new(arc(centre, radius, between), Ink::Ink).thin()).text(
            at,
            label,
            Ink::Ink,
            Side::Centre,
        )
    }

    /// Adds an arrow along an arc: which way something turns.
    #[must_use]
    pub fn turn(self, centre: (f64, f64), radius: f64, between: (f64, f64), ink: Ink) -> Self {
        self.arrow_along(arc(centre, radius, between), ink)
    }

    /// Adds a dimension line with heads at both ends and a label beside its middle.
    #[must_use]
    pub fn dimension(mut self, from: (f64, f64), to: (f64, f64), label: &str, side: Side) -> Self {
        self.elements.push(Element::Dimension(from, to));
        let middle = ((from.0 + to.0) / 2.0, (from.1 + to.1) / 2.0);
        self.text(middle, label, Ink::Ink, side)
    }

    /// Adds a fixed surface, hatched on the right as one goes from `from` to `to`.
    #[must_use]
    pub fn wall(mut self, from: (f64, f64), to: (f64, f64)) -> Self {
        self.elements.push(Element::Wall(from, to));
        self
    }

    /// Adds a body with this outline, filled faintly or (`fill` = 1) fully.
    #[must_use]
    pub fn body(
        mut self,
        outline: impl IntoIterator<Item = (f64, f64)>,
        ink: Ink,
        fill: f64,
    ) -> Self {
        let outline = outline.into_iter().collect();
        self.elements.push(Element::Solid(outline, ink, fill));
        self
    }

    /// Adds a round body.
    #[must_use]
    pub fn disc(self, centre: (f64, f64), radius: f64, ink: Ink, fill: f64) -> Self {
        let rim = arc(centre, radius, (0.0, 2.0 * core::f64::consts::PI));
        self.body(rim, ink, fill)
    }

    /// Adds a dot.
    #[must_use]
    pub fn dot(mut self, at: (f64, f64), ink: Ink, label: &str, side: Side) -> Self {
        self.elements.push(Element::Dot(at, ink, false));
        self.text(at, label, ink, side)
    }

    /// Adds a ring: a hinge, or a point that something leaves.
    #[must_use]
    pub fn ring(mut self, at: (f64, f64), ink: Ink, label: &str, side: Side) -> Self {
        self.elements.push(Element::Dot(at, ink, true));
        self.text(at, label, ink, side)
    }

    /// Adds a text beside the point `at`; an empty one adds nothing.
    #[must_use]
    pub fn text(mut self, at: (f64, f64), text: &str, ink: Ink, side: Side) -> Self {
        if !text.is_empty() {
            self.texts.push((at, text.into(), ink, side, GAP));
        }
        self
    }

    /// Draws it.
    ///
    /// # Errors
    /// [`Error::OutOfRange`](rotation_dynamics::Error::OutOfRange) for a window without area or
    /// too tall (more than three times its width) or a point far outside it,
    /// [`Error::NotFinite`](rotation_dynamics::Error::NotFinite) for NaN and infinities,
    /// [`Error::Text`](crate::Error::Text) for a bad name or a missing alternative text.
    pub fn figure(&self) -> Result<Figure> {
        let width = f64::from(self.width);
        let size = (self.width, self.height(width)? as u32);
        figure(&self.name, &self.alt, size, |canvas| self.paint_into(canvas, canvas.rect()))
    }

    /// Its height when it is so wide, in px.
    pub(super) fn height(&self, width: f64) -> Result<f64> {
        let (across, up) = (self.x.1 - self.x.0, self.y.1 - self.y.0);
        let aspect = up / across;
        if !(across > 0.0 && aspect > 0.0 && aspect <= 3.0) {
            return Err(rotation_dynamics::Error::out_of_range(
                "height of the window over its width",
                aspect,
                "it must be greater than 0 and at most 3",
            )
            .into());
        }
        Ok(libm::round(width * aspect).max(20.0))
    }

    /// One px of the figure, in its own units.
    pub(super) fn px(&self) -> f64 {
        (self.x.1 - self.x.0) / f64::from(self.width)
    }

    pub(super) fn paint_into(&self, canvas: &Canvas, rect: Rect) -> Result<()> {
        let frame = canvas.frame(self.x, self.y, rect);
        for element in &self.elements {
            self.paint(&frame, element, 1.0)?;
        }
        self.paint_labels(canvas, &frame, rect)
    }

    fn paint(&self, frame: &Frame<'_>, element: &Element, opacity: f64) -> Result<()> {
        let line = |ink, width| Stroke::new(ink, width).faint(opacity);
        match element {
            Element::Curve(curve) if opacity == 1.0 => curve.paint_whole(frame),
            Element::Curve(curve) => {
                curve.clone().faint(opacity * curve.opacity).paint_whole(frame)
            }
            Element::Arrow(points, ink) => {
                let open = *ink == Ink::Force;
                frame.draw(points, &Paint::Arrow(line(*ink, CURVE), HEAD, open))
            }
            Element::Dimension(from, to) => {
                frame.draw(&[*from, *to], &Paint::Dimension(line(Ink::Ink, AXIS)))
            }
            Element::Wall(from, to) => {
                let (dx, dy) = (to.0 - from.0, to.1 - from.1);
                let (length, px) = (hypot(dx, dy), self.px());
                let (ex, ey) = (dx / length, dy / length);
                let strokes = (length / (8.0 * px)) as usize;
                for i in 0..strokes {
                    let s = (i as f64 + 0.9) * length / strokes as f64;
                    let on = (from.0 + s * ex, from.1 + s * ey);
                    let back = 7.0 * px;
                    let off = (on.0 + back * (ey - ex), on.1 + back * (-ex - ey));
                    frame.draw(&[on, off], &Paint::Line(line(Ink::Frame, 0.8)))?;
                }
                frame.draw(&[*from, *to], &Paint::Line(line(Ink::Ink, 1.4)))
            }
            Element::Solid(outline, ink, fill) => {
                // What is behind a body does not show through it.
                if opacity == 1.0 {
                    frame.draw(outline, &Paint::Fill(Ink::Paper, 1.0))?;
                }
                frame.draw(outline, &Paint::Fill(*ink, fill * opacity))?;
                frame.draw(outline, &Paint::Loop(line(*ink, 1.4)))
            }
            Element::Dot(at, ink, ring) => frame.draw(&[*at], &Paint::Dot(*ink, 3.5, *ring)),
            Element::Ghost(elements, much) => {
                for element in elements {
                    self.paint(frame, element, opacity * much)?;
                }
                Ok(())
            }
        }
    }

    fn paint_labels(&self, canvas: &Canvas, frame: &Frame<'_>, rect: Rect) -> Result<()> {
        let sheet = canvas.sheet();
        let mut obstacles =
            Obstacles::new(Rect { left: rect.left + 2.0, right: rect.right - 2.0, ..rect });
        let mut wanted = Vec::new();
        for (i, element) in self.elements.iter().enumerate() {
            let points: Vec<Point> = match element {
                Element::Curve(curve) => curve.points.clone(),
                Element::Arrow(points, _) => points.clone(),
                Element::Solid(points, ..) => {
                    points.iter().chain(points.first()).copied().collect()
                }
                Element::Dimension(from, to) | Element::Wall(from, to) => vec![*from, *to],
                Element::Dot(at, ..) => {
                    obstacles.take(Rect::about(frame.px(*at), 3.5));
                    continue;
                }
                Element::Ghost(..) => continue,
            };
            let px: Vec<Point> = points.iter().map(|&p| frame.px(p)).collect();
            obstacles.add_line(i, &px);
            if let Element::Arrow(..) = element {
                obstacles.add_head(&px, HEAD);
            }
            if let Element::Curve(curve) = element
                && let Some((text, place)) = &curve.label
            {
                wanted.push((i, px, text, place, curve.ink));
            }
        }
        for (at, text, ink, side, gap) in &self.texts {
            let words = |side, gap| Words::new(text, *ink, side, gap);
            if let Some(placed) = obstacles.place_at(frame.px(*at), *side, *gap, words) {
                placed.paint(&sheet)?;
            }
        }
        for (i, px, text, place, ink) in wanted {
            let words = |side, gap| Words::new(text, ink, side, gap);
            let last = px.last().copied().unwrap_or_default();
            let placed = match place {
                LabelPlace::At(at, side) => obstacles.place_at(frame.px(*at), *side, GAP, words),
                LabelPlace::End => obstacles.place_at(last, Side::Right, GAP, words),
                LabelPlace::Found => obstacles.place(i, &px, words),
            };
            if let Some(placed) = placed {
                placed.paint(&sheet)?;
            }
        }
        Ok(())
    }
}

/// Points of an arc, 3 degrees apart or closer.
pub(super) fn arc(centre: Point, radius: f64, (from, to): (f64, f64)) -> Vec<Point> {
    let steps = libm::ceil((to - from).abs() / 0.05).clamp(1.0, 1000.0) as usize;
    (0..=steps)
        .map(|i| {
            let (s, c) = sincos(from + (to - from) * i as f64 / steps as f64);
            (centre.0 + radius * c, centre.1 + radius * s)
        })
        .collect()
}
