//! Faces, and lines as pieces short enough to be hidden or shown.

use super::canvas::{Frame, Paint, Point};
use super::depth::{Item, from_behind};
use super::display::{Dash, Stroke};
use super::ink::Ink;
use super::material::stepped;
use super::scene::Part;
use super::solid::{Solid, normal};
use super::view::{Element, View};
use crate::error::{Result, finite};
use rotation_dynamics::frame::SpaceVector;

/// Length of the pieces into which a line is cut where bodies may hide it, in px.
const PIECE: f64 = 6.0;

impl View {
    /// The faces that look at the eye, lighter as they turn to the light: from `least` to `most` percent.
    pub(super) fn faces(
        &self,
        solid: &Solid,
        ink: Ink,
        [least, most]: [f64; 2],
        items: &mut Vec<Item>,
    ) -> Result<()> {
        let camera = &self.camera;
        let light = camera.light() / camera.light().norm();
        for face in &solid.faces {
            if let Some(normal) = self.looks_here(face)? {
                let lit = least + 0.5 * (most - least) * (1.0 + normal.dot(&light));
                let paint = Paint::Face(ink, stepped(lit));
                items.push(Item { points: face.clone(), paint, goes_on: false });
            }
        }
        Ok(())
    }

    /// A patch, if it looks at the eye.
    pub(super) fn patched(
        &self,
        outline: &[SpaceVector],
        ink: Ink,
        light: u32,
        items: &mut Vec<Item>,
    ) -> Result<()> {
        if self.looks_here(outline)?.is_some() {
            let paint = Paint::Face(ink, light.min(100));
            items.push(Item { points: outline.to_vec(), paint, goes_on: false });
        }
        Ok(())
    }

    /// The normal of a face that looks at the eye.
    fn looks_here(&self, face: &[SpaceVector]) -> Result<Option<SpaceVector>> {
        for &p in face {
            finite("depth in a view", self.camera.depth(p))?;
        }
        Ok(normal(face).filter(|&n| self.camera.depth(n) > 1e-9))
    }

    /// A line as short pieces, its dashes as pieces of their own, its head as the last.
    pub(super) fn pieces(&self, part: &Part<'_>, unit: f64, items: &mut Vec<Item>) -> Result<()> {
        let (on, off) = match part.stroke.dash {
            Dash::Solid => (PIECE, 0.0),
            Dash::Dashed => (6.0, 4.0),
            Dash::Dotted => (1.5, 3.0),
        };
        let length = |a: SpaceVector, b: SpaceVector| {
            let ((ax, ay), (bx, by)) = (self.camera.project(a), self.camera.project(b));
            unit * rotation_dynamics::math::hypot(bx - ax, by - ay)
        };
        // How long the line is up to each of its points but the first.
        let reached: Vec<f64> = (part.points.windows(2))
            .scan(0.0, |behind, w| {
                *behind += length(w[0], w[1]);
                Some(*behind)
            })
            .collect();
        let whole = reached.last().copied().unwrap_or(0.0);
        let whole = finite("length of a line in a view", whole)?;
        let shaft = whole - part.head.map_or(0.0, |head| 1.5 * head);
        let at = |wanted: f64| {
            let first = reached.partition_point(|next| *next < wanted.max(f64::MIN_POSITIVE));
            let Some(&next) = reached.get(first) else {
                return part.points.last().copied().unwrap_or(SpaceVector::zero());
            };
            let behind = first.checked_sub(1).map_or(0.0, |before| reached[before]);
            let (from, to) = (part.points[first], part.points[first + 1]);
            from + (to - from) * ((wanted - behind) / (next - behind))
        };
        let plain = Stroke { dash: Dash::Solid, ..part.stroke };
        let mut from = 0.0;
        while from < shaft {
            let to = (from + on).min(shaft);
            items.push(Item {
                points: vec![at(from), at(to)],
                paint: Paint::Line(plain),
                goes_on: from > 0.0 && off == 0.0,
            });
            from += on + off;
        }
        if part.head.is_some() {
            items.push(Item {
                points: vec![at(shaft.max(0.0)), at(whole)],
                paint: self.paint_of(part),
                goes_on: false,
            });
        }
        Ok(())
    }

    /// Whether a body hides this point, or it is on the far side of the sphere.
    pub(super) fn hides(&self, at: SpaceVector) -> bool {
        /// A point on a body is not hidden by the face it lies on; part of the reach.
        const ON: f64 = 5e-3;
        let eye = self.camera.eye;
        let before = |face: &Vec<SpaceVector>| {
            let Some(n) = normal(face).filter(|n| n.dot(&eye) > 1e-9) else { return false };
            // From the point towards the eye as far as to the plane of the face.
            let away = (face[0] - at).dot(&n) / n.dot(&eye);
            let met = at + eye * away;
            let inside = |i: usize| {
                let (a, b) = (face[i], face[(i + 1) % face.len()]);
                (b - a).cross(&(met - a)).dot(&n) >= 0.0
            };
            away > ON * self.reach && (0..face.len()).all(inside)
        };
        let ball = self.sphere || self.globe;
        self.elements.iter().any(|element| match element {
            Element::Solid(solid, _) => solid.faces.iter().any(before),
            Element::Ball(..) => self.camera.depth(at) < 0.0 && at.norm() < 1.0 + ON,
            _ => ball && self.camera.depth(at) < 0.0 && at.norm() < 1.0 + ON,
        })
    }

    pub(super) fn paint_items(&self, frame: &Frame<'_>, items: &[Item]) -> Result<()> {
        let mut line: Option<(usize, Vec<Point>)> = None;
        for i in from_behind(&self.camera, items) {
            let item = &items[i];
            let mut flat = self.flat(&item.points);
            match &mut line {
                Some((last, points)) if item.goes_on && *last + 1 == i => {
                    points.extend(flat.split_off(1));
                    *last = i;
                    continue;
                }
                _ => {}
            }
            if let Some((last, points)) = line.take() {
                frame.draw(&points, &items[last].paint)?;
            }
            if let Paint::Line(_) = item.paint {
                line = Some((i, flat));
            } else {
                frame.draw(&flat, &item.paint)?;
            }
        }
        if let Some((last, points)) = line {
            frame.draw(&points, &items[last].paint)?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::super::solid::Camera;
    use super::*;

    #[test]
    fn a_body_hides_what_is_behind_it_and_a_ball_its_far_side() {
        let at = SpaceVector::new;
        let edges = [at(0.2, 0.0, 0.0), at(0.0, 1.0, 0.0), at(0.0, 0.0, 1.0)];
        // The eye looks along -X.
        let view = View::of(SpaceVector::zero(), 1.0).camera(Camera::new(0.0, 0.0));
        let plate = view.clone().solid(Solid::cuboid(SpaceVector::zero(), edges), Ink::Body);
        assert!(plate.hides(at(-0.5, 0.3, 0.3)));
        assert!(!plate.hides(at(0.1, 0.3, 0.3)), "on the face towards the eye");
        assert!(!plate.hides(at(-0.5, 0.6, 0.3)), "beside the plate");
        let ball = view.ball(Ink::Body);
        assert!(ball.hides(at(-1.0, 0.0, 0.0)) && !ball.hides(at(1.0, 0.0, 0.0)));
    }
}
