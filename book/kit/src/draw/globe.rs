//! The unit sphere as a body: the Earth.

use super::canvas::{Frame, Paint, Point};
use super::display::Stroke;
use super::ink::Ink;
use super::solid::{Camera, across};
use super::view::View;
use crate::error::Result;
use core::f64::consts::{PI, TAU};
use rotation_dynamics::math::{atan2, sincos};

/// How far the shade reaches from the place that is farthest from the light, in degrees: each
/// reach darkens a little more, so that the shade is soft.
const REACHES: [f64; 9] = [62.0, 68.0, 74.0, 80.0, 86.0, 92.0, 98.0, 104.0, 110.0];
/// How dark one of them is.
const SHADE: f64 = 0.05;

impl View {
    pub(super) fn paint_globe(&self, frame: &Frame<'_>) -> Result<()> {
        let outline = super::sketch::arc((0.0, 0.0), 1.0, (0.0, TAU));
        frame.draw(&outline, &Paint::Fill(Ink::Paper, 1.0))?;
        frame.draw(&outline, &Paint::Fill(Ink::Frame, 0.18))?;
        for reach in REACHES {
            frame
                .draw(&shade(&self.camera, reach.to_radians()), &Paint::Fill(Ink::Shadow, SHADE))?;
        }
        frame.draw(&outline, &Paint::Loop(Stroke::new(Ink::Frame, 1.0)))
    }
}

/// The outline of what is seen of the cap of this radius (rad) that lies opposite the light.
fn shade(camera: &Camera, radius: f64) -> Vec<Point> {
    let middle = camera.light() / -camera.light().norm();
    let (u, v) = across(middle);
    // It begins at its farthest place, so that what is seen of it is one piece.
    let far = atan2(-camera.depth(v), -camera.depth(u));
    let (sin, cos) = sincos(radius);
    let edge = (0..=120).map(|i| {
        let (s, c) = sincos(far + TAU * f64::from(i) / 120.0);
        middle * cos + (u * c + v * s) * sin
    });
    let seen = edge.filter(|&p| camera.depth(p) >= 0.0);
    let mut outline: Vec<Point> = seen.map(|p| camera.project(p)).collect();
    // Back along the rim on the side of the shade.
    let (x, y) = camera.project(middle);
    let towards = atan2(y, x);
    let beside = |&(x, y): &Point| {
        let angle = atan2(y, x) - towards;
        angle - TAU * libm::round(angle / TAU)
    };
    if let (Some(first), Some(last)) = (outline.first().map(beside), outline.last().map(beside)) {
        outline.extend((0..=40).map(|i| {
            let (s, c) = sincos(towards + last + (first - last) * f64::from(i) / 40.0);
            (c, s)
        }));
    }
    outline
}

/// The angles of meridians from the first, for each half a circle, and of parallels from the pole.
pub(super) fn graticule() -> (impl Iterator<Item = f64>, [f64; 5]) {
    (
        (0..12).map(|i| PI * f64::from(i) / 6.0),
        [30.0, 60.0, 90.0, 120.0, 150.0].map(f64::to_radians),
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use rotation_dynamics::math::hypot;

    /// The shade grows with its reach, lies on the globe, and is on the side away from the light.
    #[test]
    fn the_shade_lies_opposite_the_light() {
        for camera in [Camera::default(), Camera::new(-1.6, 1.3)] {
            let light = camera.project(camera.light());
            let mut before = 0.0;
            for reach in REACHES {
                let outline = shade(&camera, reach.to_radians());
                assert!(outline.iter().all(|&(x, y)| hypot(x, y) < 1.0 + 1e-12));
                let (mut area, mut moment) = (0.0, 0.0);
                for (i, &(ax, ay)) in outline.iter().enumerate() {
                    let (bx, by) = outline[(i + 1) % outline.len()];
                    let part = 0.5 * (ax * by - ay * bx);
                    area += part;
                    moment += part * ((ax + bx) * light.0 + (ay + by) * light.1) / 3.0;
                }
                assert!(area.abs() > before && area.abs() < PI, "{reach}: {area}");
                assert!(moment / area < 0.0, "{reach}: {moment}");
                before = area.abs();
            }
        }
    }
}
