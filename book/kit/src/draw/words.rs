//! Boxes, and texts whose box is known before they are drawn.

use super::canvas::Point;
use super::display::Anchor;
use super::ink::Ink;
use super::label::{Label, SIZE};

/// A rectangle in px; `top < bottom`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Rect {
    pub(super) left: f64,
    pub(crate) right: f64,
    pub(super) top: f64,
    pub(crate) bottom: f64,
}

impl Rect {
    /// The square about a point.
    pub(super) fn about((x, y): Point, half: f64) -> Self {
        Self { left: x - half, right: x + half, top: y - half, bottom: y + half }
    }

    pub(super) fn overlaps(&self, other: &Self) -> bool {
        self.left < other.right
            && other.left < self.right
            && self.top < other.bottom
            && other.top < self.bottom
    }

    pub(super) fn contains(&self, (x, y): Point) -> bool {
        (self.left..=self.right).contains(&x) && (self.top..=self.bottom).contains(&y)
    }

    /// The square of the distance of a point; 0 inside.
    pub(super) fn squared_distance(&self, p: Point) -> f64 {
        let (x, y) = self.nearest(p);
        (p.0 - x) * (p.0 - x) + (p.1 - y) * (p.1 - y)
    }

    /// Its point nearest to a point.
    pub(super) fn nearest(&self, (x, y): Point) -> Point {
        (x.max(self.left).min(self.right), y.max(self.top).min(self.bottom))
    }

    pub(super) fn middle(&self) -> Point {
        ((self.left + self.right) / 2.0, (self.top + self.bottom) / 2.0)
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

impl Side {
    /// Left for right.
    pub(super) fn mirrored(self) -> Self {
        match self {
            Self::Left => Self::Right,
            Self::Right => Self::Left,
            Self::AboveLeft => Self::AboveRight,
            Self::AboveRight => Self::AboveLeft,
            Self::BelowLeft => Self::BelowRight,
            Self::BelowRight => Self::BelowLeft,
            side => side,
        }
    }
}

/// A text with its place: the box it fills is known before it is drawn.
#[derive(Debug, Clone)]
pub(super) struct Words {
    pub(crate) label: Label,
    pub(super) ink: Ink,
    pub(crate) halo: bool,
    pub(crate) anchor: Anchor,
    pub(super) shift: Point,
}

impl Words {
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
        Self { label: Label::new(text), ink, halo: true, anchor, shift: (dx, dy) }
    }

    /// Without a halo: where nothing else is drawn.
    pub(super) fn bare(self) -> Self {
        Self { halo: false, ..self }
    }

    /// The box it fills when drawn at `at` (px).
    pub(super) fn rect(&self, at: Point) -> Rect {
        let width = self.label.width(SIZE);
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
            top: baseline - 0.78 * SIZE,
            bottom: baseline + 0.26 * SIZE,
        }
    }
}
