//! The display list: what a drawing consists of, before it is written down.
//!
//! The locked SVG ([`super::svg`]) is one way to write it down, a painter on a canvas
//! another. Lengths are px, places whole hundredths of a px from the upper left corner,
//! so that the same drawing is the same list on every machine.

use super::ink::Ink;
use super::place::distance_squared;

/// Units of a place in a pixel.
pub(super) const UNITS: f64 = 100.0;

/// A place: to the right and down, in hundredths of a px.
pub type Place = (i32, i32);

/// How a line is broken.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Dash {
    /// Not at all.
    Solid,
    /// Dashes.
    Dashed,
    /// Dots.
    Dotted,
}

impl Dash {
    /// Lengths of ink and gap in px; the dots are round ends of nearly nothing.
    pub(crate) fn pattern(self) -> Option<[f64; 2]> {
        match self {
            Self::Solid => None,
            Self::Dashed => Some([6.0, 4.0]),
            Self::Dotted => Some([0.1, 4.0]),
        }
    }
}

/// How a line is drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stroke {
    /// Its colour.
    pub ink: Ink,
    /// Its width in px.
    pub width: f64,
    /// How it is broken.
    pub(crate) dash: Dash,
    /// 1 is full, 0 is nothing.
    pub(crate) opacity: f64,
}

impl Stroke {
    pub(super) const fn new(ink: Ink, width: f64) -> Self {
        Self { ink, width, dash: Dash::Solid, opacity: 1.0 }
    }

    /// So much fainter.
    pub(super) const fn faint(self, opacity: f64) -> Self {
        Self { opacity: self.opacity * opacity, ..self }
    }
}

/// What is drawn, later over earlier.
#[derive(Debug, Clone, PartialEq)]
pub enum Shape {
    /// A line through these places, with round corners; a closed one returns to its first.
    Line(Vec<Place>, bool, Stroke),
    /// An area with this outline, in this ink with this opacity.
    Area(Vec<Place>, Ink, f64),
    /// An opaque face of a body; its light in percent, 0 in the shade. A rim of 1 px in
    /// the same colour closes the seams between neighbours.
    Face(Vec<Place>, Ink, u32),
    /// A dot of this radius in px; a ring is filled with paper and has a rim of 1.5 px.
    Dot(Place, f64, Ink, bool),
}

impl Shape {
    /// Its ink.
    pub(super) fn ink(&self) -> Ink {
        match self {
            Self::Line(_, _, Stroke { ink, .. })
            | Self::Area(_, ink, _)
            | Self::Face(_, ink, _)
            | Self::Dot(_, _, ink, _) => *ink,
        }
    }
}

/// Where a text lies relative to its place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Anchor {
    /// It begins there.
    Start,
    /// It is centred there.
    Middle,
    /// It ends there.
    End,
}

/// Letters of one size, face and height in a [`Text`].
#[derive(Debug, Clone, PartialEq)]
pub struct Run {
    /// What it says.
    pub text: String,
    /// A variable: in the slanted face.
    pub(crate) slanted: bool,
    /// Size of the letters in px.
    pub size: f64,
    /// Distance of its baseline below that of the text, in px.
    pub(crate) drop: f64,
}

/// A label.
#[derive(Debug, Clone, PartialEq)]
pub struct Text {
    /// A point of its baseline.
    pub at: Place,
    /// Which point.
    pub(crate) anchor: Anchor,
    /// Its colour, as text.
    pub ink: Ink,
    /// Whether a rim of paper, 2 px wide, keeps what is drawn off its letters.
    pub(crate) halo: bool,
    /// What it says.
    pub runs: Vec<Run>,
}

/// A drawing: the shapes in their order, over them the halos of all texts, over these the
/// texts. So no halo lies over a letter.
#[derive(Debug, Clone, PartialEq)]
pub struct Display {
    /// Width and height in px.
    pub size: (u32, u32),
    /// Lines, areas, faces, dots.
    pub shapes: Vec<Shape>,
    /// Labels.
    pub texts: Vec<Text>,
}

impl Display {
    /// How many places the shapes have: what drawing it costs.
    pub fn places(&self) -> usize {
        let count = |shape: &Shape| match shape {
            Shape::Line(points, ..) | Shape::Area(points, ..) | Shape::Face(points, ..) => {
                points.len()
            }
            Shape::Dot(..) => 1,
        };
        self.shapes.iter().map(count).sum()
    }
}

/// From how far a point is kept: 0.04 px.
pub(super) const NEAR: f64 = 4.0;

/// Drops points that lie within `near` of the line through those kept
/// (Douglas and Peucker, 1973).
pub(super) fn thinned(points: &[Place], near: f64) -> Vec<Place> {
    let Some(last) = points.len().checked_sub(1) else {
        return Vec::new();
    };
    let at = |i: usize| (f64::from(points[i].0), f64::from(points[i].1));
    let mut keep = vec![false; points.len()];
    keep[0] = true;
    keep[last] = true;
    let mut spans = vec![(0, last)];
    while let Some((a, b)) = spans.pop() {
        let farthest = (a + 1..b)
            .map(|i| (i, distance_squared([at(a), at(b)], at(i))))
            .fold((a, near * near), |best, next| if next.1 > best.1 { next } else { best });
        if farthest.0 != a {
            keep[farthest.0] = true;
            spans.push((a, farthest.0));
            spans.push((farthest.0, b));
        }
    }
    let kept = points.iter().zip(keep);
    kept.filter_map(|(p, keep)| keep.then_some(*p)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_straight_line_is_thinned_to_its_ends_and_a_corner_is_kept() {
        let straight: Vec<Place> = (0..=100).map(|i| (30 * i, 7 * i)).collect();
        assert_eq!(thinned(&straight, NEAR), [(0, 0), (3000, 700)]);
        assert_eq!(thinned(&[(0, 0), (50, 5), (100, 0)], NEAR).len(), 3);
        assert_eq!(thinned(&[(0, 0), (50, 4), (100, 0)], NEAR).len(), 2);
        assert!(thinned(&[], NEAR).is_empty());
    }
}
