//! What a body looks like: seen through, painted, or a round ball in the light.

use super::canvas::{Frame, Paint, Point};
use super::display::Stroke;
use super::ink::Ink;
use super::scene::BODY;
use super::solid::{Solid, across, normal};
use super::view::{Element, View};
use super::words::Side;
use crate::error::Result;
use core::f64::consts::PI;
use rotation_dynamics::frame::SpaceVector;
use rotation_dynamics::math::{acos, atan2, sincos};

/// How much of a body that is seen through, or that lines are drawn on, is paper: the lines must
/// stand out from it, in both themes.
const VEIL: f64 = 0.55;

/// The light of what is painted on such a body, in percent: it is darker than the body.
const PAINT: [f64; 2] = [0.0, 40.0];

/// Percents of light are rounded to these: few steps of light keep a picture small.
const STEP: u32 = 4;

/// Percents of light, rounded.
pub(super) fn stepped(light: f64) -> u32 {
    STEP * libm::round(light / f64::from(STEP)) as u32
}

impl View {
    /// Adds a body that is seen through, and what is painted on it: pale, and all that is not such
    /// a body is drawn over it.
    #[must_use]
    pub fn glass(
        mut self,
        solid: Solid,
        ink: Ink,
        painted: impl IntoIterator<Item = (Solid, Ink)>,
    ) -> Self {
        let parts = [(solid, ink)].into_iter().chain(painted);
        self.elements.push(Element::Glass(parts.collect()));
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

    /// Adds a body with a day side, which looks along the unit vector `sun`, and a night side.
    #[must_use]
    pub fn sunlit(self, solid: Solid, ink: Ink, sun: SpaceVector) -> Self {
        solid.faces.into_iter().fold(self, |view, face| {
            let lit = normal(&face).map_or(0.0, |n| n.dot(&sun).max(0.0));
            view.patch(face, ink, stepped(24.0 + 68.0 * lit))
        })
    }

    /// Adds an arrow that begins within a body, as [`Self::arrow`], but drawn over all bodies: a
    /// weight at a centre of mass.
    #[must_use]
    pub fn arrow_from_within(
        mut self,
        from: SpaceVector,
        to: SpaceVector,
        ink: Ink,
        label: &str,
        side: Side,
    ) -> Self {
        self.elements.push(Element::Within([from, to], Stroke::new(ink, 2.2), 9.0));
        self.text(to, label, ink, side)
    }

    /// With lit arrows of 0.6 of the usual thickness, that of the angular velocity thinner than the
    /// others: for arrows that lie almost along one another, the thinner one longer.
    #[must_use]
    pub fn with_slim_vectors(mut self) -> Self {
        self.slim = true;
        self
    }

    /// Adds the unit ball about the origin in the light, pale, so that [`Self::trace`] is seen
    /// on its far side too.
    #[must_use]
    pub fn ball(mut self, ink: Ink) -> Self {
        self.elements.push(Element::Ball(ink, true));
        self
    }

    /// Adds the unit ball about the origin in the light, as pale, which hides its far side.
    #[must_use]
    pub fn solid_ball(mut self, ink: Ink) -> Self {
        self.elements.push(Element::Ball(ink, false));
        self
    }

    /// Adds a patch on a side of a box about `centre` with these edges: the end of edge number
    /// `k`, at `height` from the centre (1 is on the box, -1 on its other end). It is as long as
    /// the two ranges along the next two edges, all in parts of half the edges.
    #[must_use]
    pub fn patch_on(
        self,
        (centre, edges): (SpaceVector, [SpaceVector; 3]),
        (k, height): (usize, f64),
        [[a, b], [c, d]]: [[f64; 2]; 2],
        ink: Ink,
        light: u32,
    ) -> Self {
        let [out, u, v] = [0, 1, 2].map(|i| edges[(k + i) % 3] * 0.5);
        let mut corners = [[a, c], [b, c], [b, d], [a, d]];
        if (out * height).dot(&u.cross(&v)) < 0.0 {
            corners.reverse();
        }
        self.patch(corners.map(|[x, y]| centre + out * height + u * x + v * y), ink, light)
    }

    pub(super) fn paint_glass(&self, frame: &Frame<'_>) -> Result<()> {
        for element in &self.elements {
            let Element::Glass(parts) = element else { continue };
            let mut items = Vec::new();
            for (k, (solid, ink)) in parts.iter().enumerate() {
                self.faces(solid, *ink, if k == 0 { BODY } else { PAINT }, &mut items)?;
            }
            for item in &items {
                frame.draw(&self.flat(&item.points), &item.paint)?;
            }
            if let Some((solid, _)) = parts.first() {
                frame.draw(&self.silhouette(solid), &Paint::Fill(Ink::Paper, VEIL))?;
            }
        }
        Ok(())
    }

    /// The balls that are seen through, or those that are not.
    pub(super) fn paint_balls(&self, frame: &Frame<'_>, through: bool) -> Result<()> {
        for element in &self.elements {
            let Element::Ball(ink, seen_through) = element else { continue };
            if *seen_through != through {
                continue;
            }
            for (outline, light) in self.bands() {
                frame.draw(&outline, &Paint::Face(*ink, light))?;
            }
            let rim = super::sketch::arc((0.0, 0.0), 1.0, (0.0, 2.0 * PI));
            frame.draw(&rim, &Paint::Fill(Ink::Paper, VEIL))?;
            frame.draw(&rim, &Paint::Loop(Stroke::new(Ink::Frame, 1.0)))?;
        }
        Ok(())
    }

    /// The visible parts of the unit ball that have at least so many percent of light, the
    /// largest first.
    fn bands(&self) -> Vec<(Vec<Point>, u32)> {
        const SIDES: u32 = 72;
        let light = self.camera.light();
        let light = light / light.norm();
        let (u, v) = across(light);
        let toward_eye = self.camera.depth(light);
        // On the rim, opposite to the light.
        let least = -(1.0 - toward_eye * toward_eye).sqrt();
        let band = |percent: u32| {
            let towards = (f64::from(percent) - 0.5 * f64::from(STEP)) / 50.0 - 1.0;
            let wide = acos(towards.clamp(-1.0, 1.0));
            let outline = (0..SIDES).map(|i| {
                let (s, c) = sincos(2.0 * PI * f64::from(i) / f64::from(SIDES));
                let out = u * c + v * s;
                // No farther than to the rim.
                let (s, c) = sincos(wide.min(atan2(toward_eye, -self.camera.depth(out))));
                self.camera.project(light * c + out * s)
            });
            (outline.collect(), percent)
        };
        (stepped(50.0 * (1.0 + least))..=100).step_by(STEP as usize).map(band).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::super::display::Shape;
    use super::*;

    /// Of two screens on the sides of a box the one is seen that looks at the eye, with its own light.
    #[test]
    fn a_patch_is_seen_from_outside() -> Result<()> {
        let [x, y, z] = [(2.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 0.2)]
            .map(|(x, y, z)| SpaceVector::new(x, y, z));
        let all = [[-0.9, 0.9]; 2];
        let lights = |edges: [SpaceVector; 3]| -> Result<Vec<u32>> {
            let on = (SpaceVector::zero(), edges);
            let view = View::new("box", "a box with a screen above and another below")
                .solid(Solid::cuboid(on.0, edges), Ink::Body)
                .patch_on(on, (2, 1.1), all, Ink::Ink, 7)
                .patch_on(on, (2, -1.1), all, Ink::Ink, 9);
            let shapes = view.figure()?.display.shapes.into_iter();
            Ok(shapes.filter_map(|shape| screen(&shape)).collect())
        };
        assert_eq!(lights([x, y, z])?, [7]);
        assert_eq!(lights([x, y, z * -1.0])?, [9]);
        Ok(())
    }

    fn screen(shape: &Shape) -> Option<u32> {
        match shape {
            Shape::Face(_, Ink::Ink, light) => Some(*light),
            _ => None,
        }
    }

    /// What is in a glass is drawn after its veil.
    #[test]
    fn what_is_in_a_glass_is_drawn_over_it() -> Result<()> {
        let (origin, up) = (SpaceVector::zero(), SpaceVector::new(0.0, 0.0, 1.0));
        let view = View::new("glass", "a ball in a can that is seen through")
            .solid(Solid::ball(origin, 0.2), Ink::Frame)
            .glass(Solid::disc(origin, up, 0.5, 1.0), Ink::Body, []);
        let shapes = view.figure()?.display.shapes;
        let veil = shapes.iter().position(|shape| matches!(shape, Shape::Area(_, Ink::Paper, _)));
        let of = |ink: Ink| {
            shapes.iter().position(move |s| matches!(s, Shape::Face(_, i, _) if *i == ink))
        };
        assert!(of(Ink::Body) < veil && veil < of(Ink::Frame));
        assert!(of(Ink::Body).is_some());
        Ok(())
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
        let bands = View::new("", "").bands();
        assert_eq!(bands.len(), 20);
        assert!((area(&bands[0].0) / PI - 1.0).abs() < 0.01);
        for pair in bands.windows(2) {
            assert!(area(&pair[1].0) < area(&pair[0].0));
            assert_eq!(pair[1].1, pair[0].1 + 4);
        }
    }
}
