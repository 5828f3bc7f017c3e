//! What a body looks like: seen through, painted, or a round ball in the light.

use super::canvas::{Frame, Paint, Point};
use super::display::Stroke;
use super::ink::Ink;
use super::solid::{Solid, across};
use super::view::{Element, View};
use crate::error::Result;
use core::f64::consts::PI;
use rotation_dynamics::frame::SpaceVector;
use rotation_dynamics::math::{acos, atan2, order_of, sincos};

/// How much of a body that is seen through is paper: what it holds is drawn in full and must
/// stand out from it.
const VEIL: f64 = 0.55;

/// Where the light comes from, along the eye's right, up and towards it: from above the left
/// shoulder, so that a round body is darkest at its lower right.
pub(super) const LIGHT: [f64; 3] = [-0.3, 0.45, 0.85];

/// Percents of light are rounded to these: few steps of light keep a picture small.
const STEP: u32 = 4;

/// A number from -1, away from the light, to 1 as percents of light.
pub(super) fn percent(towards: f64) -> u32 {
    STEP * libm::round(50.0 * (1.0 + towards) / f64::from(STEP)) as u32
}

impl View {
    /// Adds a convex body that is seen through, of parts in their inks: it is pale, and all that
    /// is not such a body is drawn over it.
    #[must_use]
    pub fn ghost(mut self, parts: impl IntoIterator<Item = (Solid, Ink)>) -> Self {
        self.elements.push(Element::Ghost(parts.into_iter().collect()));
        self
    }

    /// Adds a flat patch on a body, counterclockwise seen from outside, with so many percent of
    /// light wherever it faces: a screen, a label. It is seen from outside alone.
    #[must_use]
    pub fn patch(
        mut self,
        outline: impl IntoIterator<Item = SpaceVector>,
        ink: Ink,
        light: u32,
    ) -> Self {
        self.elements.push(Element::Patch(outline.into_iter().collect(), ink, light));
        self
    }

    /// Adds the unit ball about the origin in the light, pale, so that [`Self::trace`] is seen
    /// on its far side too.
    #[must_use]
    pub fn globe(mut self, ink: Ink) -> Self {
        self.elements.push(Element::Globe(ink));
        self
    }

    pub(super) fn paint_ghosts(&self, frame: &Frame<'_>) -> Result<()> {
        for element in &self.elements {
            let Element::Ghost(parts) = element else { continue };
            let mut items = Vec::new();
            for (solid, ink) in parts {
                self.faces(solid, *ink, &mut items)?;
            }
            let mut places = Vec::new();
            for item in &items {
                let flat = self.flat(&item.points);
                frame.draw(&flat, &item.paint)?;
                places.extend(flat);
            }
            frame.draw(&hull(&places), &Paint::Fill(Ink::Paper, VEIL))?;
        }
        Ok(())
    }

    pub(super) fn paint_globes(&self, frame: &Frame<'_>) -> Result<()> {
        for element in &self.elements {
            let Element::Globe(ink) = element else { continue };
            for (outline, light) in bands() {
                frame.draw(&outline, &Paint::Face(*ink, light))?;
            }
            let rim = super::sketch::arc((0.0, 0.0), 1.0, (0.0, 2.0 * PI));
            frame.draw(&rim, &Paint::Fill(Ink::Paper, VEIL))?;
            frame.draw(&rim, &Paint::Loop(Stroke::new(Ink::Frame, 1.0)))?;
        }
        Ok(())
    }
}

/// The visible parts of the unit ball that have at least so many percent of light, the largest
/// first.
fn bands() -> Vec<(Vec<Point>, u32)> {
    const SIDES: u32 = 72;
    let [x, y, z] = LIGHT;
    let light = SpaceVector::new(x, y, z);
    let light = light / light.norm();
    let (u, v) = across(light);
    // On the rim, opposite to the light.
    let least = -(1.0 - light.z() * light.z()).sqrt();
    let band = |percent: u32| {
        let towards = (f64::from(percent) - 0.5 * f64::from(STEP)) / 50.0 - 1.0;
        let wide = acos(towards.clamp(-1.0, 1.0));
        let outline = (0..SIDES).map(|i| {
            let (s, c) = sincos(2.0 * PI * f64::from(i) / f64::from(SIDES));
            let out = u * c + v * s;
            // No farther than to the rim.
            let (s, c) = sincos(wide.min(atan2(light.z(), -out.z())));
            let place = light * c + out * s;
            (place.x(), place.y())
        });
        (outline.collect(), percent)
    };
    (percent(least)..=100).step_by(STEP as usize).map(band).collect()
}

/// The corners of the convex hull, counterclockwise (Andrew, 1979).
pub(super) fn hull(points: &[Point]) -> Vec<Point> {
    let ordered = order_of(&points.iter().map(|p| p.0).collect::<Vec<_>>());
    let left_turn =
        |a: Point, b: Point, c: Point| (b.0 - a.0) * (c.1 - b.1) - (b.1 - a.1) * (c.0 - b.0) > 0.0;
    let half = |order: &mut dyn Iterator<Item = usize>| {
        let mut chain: Vec<Point> = Vec::new();
        for i in order {
            while let [.., a, b] = chain[..]
                && !left_turn(a, b, points[i])
            {
                chain.pop();
            }
            chain.push(points[i]);
        }
        chain.pop();
        chain
    };
    let mut outline = half(&mut ordered.iter().copied());
    outline.extend(half(&mut ordered.iter().rev().copied()));
    outline
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_hull_has_the_outer_points_alone() {
        let square = [(0.0, 0.0), (1.0, 1.0), (0.5, 0.5), (1.0, 0.0), (0.0, 1.0), (0.2, 0.9)];
        assert_eq!(hull(&square), [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]);
        assert!(hull(&[]).is_empty());
    }

    /// The twenty bands of the ball lie in its outline, each within the one before, and the
    /// first is all of it.
    #[test]
    fn the_bands_of_a_ball_lie_in_each_other() {
        let area = |outline: &[Point]| {
            let next = outline.iter().cycle().skip(1);
            let sum = outline.iter().zip(next).map(|(a, b)| a.0 * b.1 - a.1 * b.0);
            0.5 * sum.sum::<f64>().abs()
        };
        let bands = bands();
        assert_eq!(bands.len(), 20);
        assert!((area(&bands[0].0) / PI - 1.0).abs() < 0.01);
        for pair in bands.windows(2) {
            assert!(area(&pair[1].0) < area(&pair[0].0));
            assert_eq!(pair[1].1, pair[0].1 + 4);
        }
    }
}
