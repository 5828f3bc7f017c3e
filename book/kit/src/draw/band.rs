//! The band of the unit sphere between two tilts: where an axis may go.

use super::canvas::{Frame, Paint, Point};
use super::ink::Ink;
use super::solid::Camera;
use super::view::{Element, View};
use crate::error::Result;
use core::f64::consts::{PI, TAU};
use rotation_dynamics::frame::SpaceVector;
use rotation_dynamics::math::{atan2, sincos};

/// Steps of azimuth around a band.
const STEPS: u32 = 120;

impl View {
    /// The near halves of all bands, or the far ones.
    pub(super) fn paint_bands(&self, frame: &Frame<'_>, near: bool) -> Result<()> {
        for element in &self.elements {
            if let Element::Band(tilts) = element {
                for outline in half(&self.camera, *tilts, near) {
                    let opacity = if near { 0.16 } else { 0.08 };
                    frame.draw(&outline, &Paint::Fill(Ink::Frame, opacity))?;
                }
            }
        }
        Ok(())
    }
}

/// The outlines of what looks at the eye, or away from it, of a band.
fn half(camera: &Camera, [from, to]: [f64; 2], near: bool) -> Vec<Vec<Point>> {
    // Each half is cut on its other side, where it is not.
    let eye = atan2(camera.eye.y(), camera.eye.x()) + if near { PI } else { 0.0 };
    let at = |tilt: f64, step: f64| {
        let ((s, c), (y, x)) = (sincos(tilt), sincos(eye + TAU * step / f64::from(STEPS)));
        SpaceVector::new(s * x, s * y, c)
    };
    let belongs = |i: u32| {
        let depth = camera.depth(at(0.5 * (from + to), f64::from(i) + 0.5));
        (depth >= 0.0) == near
    };
    let mut outlines = Vec::new();
    let mut first = 0;
    for i in 0..=STEPS {
        if i < STEPS && belongs(i) {
            continue;
        }
        if first < i {
            let along = |tilt: f64| (first..=i).map(move |k| at(tilt, f64::from(k)));
            let outline = along(from).chain(along(to).rev());
            outlines.push(outline.map(|p| camera.project(p)).collect());
        }
        first = i + 1;
    }
    outlines
}

#[cfg(test)]
mod tests {
    use super::*;

    fn area(outline: &[Point]) -> f64 {
        let turn = |i: usize| {
            let ((ax, ay), (bx, by)) = (outline[i], outline[(i + 1) % outline.len()]);
            0.5 * (ax * by - ay * bx)
        };
        (0..outline.len()).map(turn).sum::<f64>().abs()
    }

    /// From above a band is a ring, all of it near; from the side its halves cover each other.
    #[test]
    fn a_band_has_a_near_half_and_a_far_one() {
        let above = Camera::new(0.3, 0.5 * PI);
        let ring = half(&above, [PI / 6.0, PI / 2.0 - 1e-6], true);
        assert_eq!([ring.len(), half(&above, [PI / 6.0, 1.5], false).len()], [1, 0]);
        assert!((area(&ring[0]) / (0.75 * PI) - 1.0).abs() < 1e-3, "{}", area(&ring[0]));
        let level = Camera::new(0.3, 0.0);
        let [near, far] = [true, false].map(|near| half(&level, [1.2, 1.4], near));
        assert_eq!([near.len(), far.len()], [1, 1]);
        assert!((area(&near[0]) - area(&far[0])).abs() < 1e-12);
    }

    /// What is outside the sphere on the near side is drawn after the band; the damaged twin ends inside.
    #[test]
    fn an_arrow_that_comes_out_through_a_band_is_before_it() {
        use super::super::display::Shape;
        let after = |length: f64| {
            let tip = SpaceVector::new(0.0, -length, 0.0);
            let view =
                View::new("band", "an arrow comes out through a band of the sphere").band(1.2, 1.9);
            let view = view.camera(Camera::new(-0.5 * PI, 0.0));
            let figure =
                view.vector(tip * 0.1, tip, Ink::Momentum, "", super::super::Side::Left).figure();
            let shapes = figure.expect("it can be drawn").display.shapes;
            let band = shapes.iter().rposition(|shape| matches!(shape, Shape::Area(..)));
            let arrow = shapes.iter().rposition(|shape| matches!(shape, Shape::Face(..)));
            arrow > band
        };
        assert!(after(1.3) && !after(0.9));
    }
}
