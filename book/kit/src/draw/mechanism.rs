//! Parts of mechanisms for a [`Sketch`].

use super::canvas::Point;
use super::curve::Curve;
use super::ink::Ink;
use super::sketch::{Element, Sketch, arc};
use super::words::Side;
use core::f64::consts::PI;
use rotation_dynamics::math::{atan2, hypot, sincos};

/// The point `(along, aside)` in the axes that point from `from` towards `to`.
fn beside(from: Point, to: Point, along: f64, aside: f64) -> Point {
    let length = hypot(to.0 - from.0, to.1 - from.1).max(f64::MIN_POSITIVE);
    let (ex, ey) = ((to.0 - from.0) / length, (to.1 - from.1) / length);
    (from.0 + along * ex - aside * ey, from.1 + along * ey + aside * ex)
}

impl Sketch {
    /// Adds a rope through these points.
    #[must_use]
    pub fn rope(self, points: impl IntoIterator<Item = (f64, f64)>) -> Self {
        self.curve(Curve::new(points, Ink::Ink).width(1.4))
    }

    /// Adds a disc with a spoke at `turn` (radians from the x axis), so that its turning
    /// is seen: a wheel, a roller, a coin.
    #[must_use]
    pub fn roller(self, centre: (f64, f64), radius: f64, turn: f64, ink: Ink) -> Self {
        let (s, c) = sincos(turn);
        let rim = (centre.0 + radius * c, centre.1 + radius * s);
        self.disc(centre, radius, ink, 0.15).curve(Curve::new([centre, rim], ink).width(1.4)).dot(
            centre,
            ink,
            "",
            Side::Above,
        )
    }

    /// Adds a pulley: a roller with a groove, hung from the point `from`.
    #[must_use]
    pub fn pulley(self, centre: (f64, f64), radius: f64, turn: f64, from: (f64, f64)) -> Self {
        let groove = arc(centre, 0.86 * radius, (0.0, 2.0 * PI));
        self.roller(centre, radius, turn, Ink::Frame)
            .curve(Curve::new(groove, Ink::Frame).thin())
            .curve(Curve::new([from, centre], Ink::Ink).width(2.4))
            .ring(centre, Ink::Ink, "", Side::Above)
    }

    /// Adds an inclined plane that rises from `foot` at `angle` (radians; beyond a right
    /// angle it rises to the left) over this length, with its ground hatched.
    #[must_use]
    pub fn incline(self, foot: (f64, f64), length: f64, angle: f64) -> Self {
        let (s, c) = sincos(angle);
        let top = (foot.0 + length * c, foot.1 + length * s);
        // The ground lies to the right of the way along which it is hatched.
        let (from, to) = if c >= 0.0 { (foot, top) } else { (top, foot) };
        let corner = (top.0, foot.1);
        self.curve(Curve::new([foot, corner, top], Ink::Frame).thin()).wall(from, to)
    }

    /// Adds a bar of this width with square ends: a plank, a ladder, a rod.
    #[must_use]
    pub fn bar(self, from: (f64, f64), to: (f64, f64), width: f64, ink: Ink) -> Self {
        let length = hypot(to.0 - from.0, to.1 - from.1);
        let corner = |along: f64, side: f64| beside(from, to, along, side * width / 2.0);
        let outline =
            [corner(0.0, 1.0), corner(length, 1.0), corner(length, -1.0), corner(0.0, -1.0)];
        self.body(outline, ink, 0.2)
    }

    /// Adds a block of these sides with its centre here, turned by `angle` (radians).
    #[must_use]
    pub fn block(self, centre: (f64, f64), sides: (f64, f64), angle: f64, ink: Ink) -> Self {
        let (s, c) = sincos(angle);
        let half = sides.0 / 2.0;
        let from = (centre.0 - half * c, centre.1 - half * s);
        let to = (centre.0 + half * c, centre.1 + half * s);
        self.bar(from, to, sides.1, ink)
    }

    /// Adds a pivot: a hinge at `at` held by a small hatched support, which lies in the
    /// direction `towards` (radians).
    #[must_use]
    pub fn pivot(self, at: (f64, f64), towards: f64) -> Self {
        let (s, c) = sincos(towards);
        let size = 14.0 * self.px();
        let foot = |aside: f64| (at.0 + size * c - aside * s, at.1 + size * s + aside * c);
        self.curve(Curve::new([foot(0.6 * size), at, foot(-0.6 * size)], Ink::Ink).thin())
            .wall(foot(-size), foot(size))
            .ring(at, Ink::Ink, "", Side::Above)
    }

    /// Adds the square of a right angle at `corner`, between the directions to two points.
    #[must_use]
    pub fn right_angle(self, corner: (f64, f64), a: (f64, f64), b: (f64, f64)) -> Self {
        let size = 9.0 * self.px();
        let (p, q) = (beside(corner, a, size, 0.0), beside(corner, b, size, 0.0));
        let far = (p.0 + q.0 - corner.0, p.1 + q.1 - corner.1);
        self.curve(Curve::new([p, far, q], Ink::Ink).thin())
    }

    /// Adds what `draw` adds, faintly and without its labels: where something was, or
    /// would be.
    #[must_use]
    pub fn ghost(mut self, draw: impl FnOnce(Self) -> Self) -> Self {
        let shown = self.elements.len();
        let texts = self.texts.clone();
        self = draw(self);
        let faint = self.elements.split_off(shown);
        self.elements.push(Element::Ghost(faint, 0.28));
        self.texts = texts;
        self
    }

    /// Adds a vector of this length in px per unit of `(x, y)`, from `at`, with its label
    /// at the tip. What is shorter than 3 px is left out.
    #[must_use]
    pub fn vector(
        self,
        at: (f64, f64),
        (x, y): (f64, f64),
        px_per_unit: f64,
        ink: Ink,
        label: &str,
    ) -> Self {
        let scale = px_per_unit * self.px();
        let tip = (at.0 + scale * x, at.1 + scale * y);
        if hypot(x, y) * px_per_unit < 3.0 {
            return self;
        }
        let eighth = libm::round(atan2(y, x) / (PI / 4.0)) as i32;
        let side = match eighth.rem_euclid(8) {
            0 => Side::Right,
            1 => Side::AboveRight,
            2 => Side::Above,
            3 => Side::AboveLeft,
            4 => Side::Left,
            5 => Side::BelowLeft,
            6 => Side::Below,
            _ => Side::BelowRight,
        };
        self.arrow_to(at, tip, ink, label, side)
    }
}
