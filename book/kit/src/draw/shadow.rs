//! What bodies cast on the ground, and their silhouettes.

use super::canvas::{Frame, Paint, Point};
use super::clip::clipped_polygon;
use super::display::Stroke;
use super::ink::Ink;
use super::solid::{Camera, Solid, normal};
use super::view::{Element, View, circle};
use crate::error::{Result, finite};
use core::f64::consts::TAU;
use rotation_dynamics::frame::SpaceVector;
use rotation_dynamics::math::{atan2, hypot, sincos};
use std::collections::BTreeMap;

const UP: SpaceVector = SpaceVector::new(0.0, 0.0, 1.0);
/// Places of the lamp that throw a shadow each: the edge of all is soft.
const LAMPS: u32 = 4;
/// How dark one of them is.
const SHADE: f64 = 0.08;
/// Half the width of the lamp over its distance: the edge is the softer the higher the body is.
const WIDTH: f64 = 0.04;

/// A piece of a plane: a disc, or the rectangle of which `along` and `across` are half the edges.
#[derive(Debug, Clone, Copy)]
pub(super) struct Ground {
    pub(super) at: SpaceVector,
    pub(super) along: SpaceVector,
    pub(super) across: SpaceVector,
    pub(super) round: bool,
    /// 0 for a floor; a table's top has an edge.
    pub(super) thickness: f64,
}

impl Camera {
    /// Where the light of the faces comes from: from the upper left, not of length 1.
    pub(super) fn light(&self) -> SpaceVector {
        self.eye * 0.85 + self.up * 0.45 - self.right * 0.3
    }

    /// How far the shadow of a point lies from the foot of its height above a plane with this
    /// normal, for each unit of the height: on the side of the light of the faces, which is raised,
    /// so that shadows stay near their bodies.
    fn cast(&self, normal: SpaceVector) -> SpaceVector {
        let light = self.light() + normal;
        // Seen from below the light would come along the ground.
        let high = light.dot(&normal);
        (light - normal * high) * (-1.0 / high.max(0.7))
    }
}

impl View {
    /// The ground, and on it the shadows of all bodies.
    pub(super) fn paint_ground(&self, frame: &Frame<'_>) -> Result<()> {
        let grounds = self.elements.iter().filter_map(|element| match element {
            Element::Ground(ground) => Some(ground),
            _ => None,
        });
        for ground in grounds {
            frame.draw(&self.flat(&ground.rim()), &Paint::Fill(Ink::Frame, 0.14))?;
            if ground.thickness > 0.0 {
                self.paint_edge(frame, ground)?;
            }
            self.paint_shadows(frame, ground)?;
        }
        Ok(())
    }

    /// The edge of a table, on the side of the eye.
    fn paint_edge(&self, frame: &Frame<'_>, ground: &Ground) -> Result<()> {
        let level = hypot(self.camera.eye.x(), self.camera.eye.y());
        if level < 1e-6 {
            return Ok(());
        }
        let radius = ground.along.norm();
        let front = (self.camera.eye - UP * self.camera.eye.z()) * (radius / level);
        let aside = self.camera.right * radius;
        let top: Vec<SpaceVector> = (0..=32)
            .map(|i| {
                let (s, c) = sincos(TAU * (f64::from(i) / 64.0 - 0.25));
                ground.at + front * c + aside * s
            })
            .collect();
        let bottom = top.iter().rev().map(|&p| p - UP * ground.thickness);
        let edge: Vec<SpaceVector> = top.iter().copied().chain(bottom).collect();
        frame.draw(&self.flat(&edge), &Paint::Fill(Ink::Frame, 0.4))
    }

    fn paint_shadows(&self, frame: &Frame<'_>, ground: &Ground) -> Result<()> {
        let normal = ground.normal();
        let light = self.camera.light() + normal;
        let mut loops = Vec::new();
        for element in &self.elements {
            if let Element::Solid(solid, _) = element {
                loops.extend(outlines(solid, light));
            }
        }
        let cast = self.camera.cast(normal);
        let [along, across] = [ground.along, ground.across].map(|edge| edge / edge.norm());
        for lamp in 0..LAMPS {
            let (s, c) = sincos(TAU * f64::from(lamp) / f64::from(LAMPS));
            let cast = cast + (along * c + across * s) * WIDTH;
            let mut shadow = Vec::new();
            for outline in &loops {
                shadow.push(ground.shadow(outline, cast)?);
            }
            shadow.retain(|outline| !outline.is_empty());
            let shadow: Vec<Point> = joined(&shadow)
                .into_iter()
                .map(|(x, y)| self.camera.project(ground.at + ground.along * x + ground.across * y))
                .collect();
            frame.draw(&shadow, &Paint::Fill(Ink::Shadow, SHADE))?;
        }
        Ok(())
    }

    /// What a closed body covers in the picture.
    pub(super) fn silhouette(&self, solid: &Solid) -> Vec<Point> {
        let outlines = outlines(solid, self.camera.eye);
        joined(&outlines.iter().map(|outline| self.flat(outline)).collect::<Vec<_>>())
    }

    /// A body that is not there: its silhouette.
    pub(super) fn paint_ghost(&self, frame: &Frame<'_>, solid: &Solid, ink: Ink) -> Result<()> {
        let loops: Vec<Vec<Point>> =
            outlines(solid, self.camera.eye).iter().map(|outline| self.flat(outline)).collect();
        frame.draw(&joined(&loops), &Paint::Fill(ink, 0.16))?;
        for outline in &loops {
            frame.draw(outline, &Paint::Loop(Stroke::new(ink, 0.8).faint(0.5)))?;
        }
        Ok(())
    }
}

impl Ground {
    /// A level disc.
    pub(super) fn level(at: SpaceVector, radius: f64, thickness: f64) -> Self {
        let (along, across) =
            (SpaceVector::new(radius, 0.0, 0.0), SpaceVector::new(0.0, radius, 0.0));
        Self { at, along, across, round: true, thickness }
    }

    fn normal(&self) -> SpaceVector {
        let normal = self.along.cross(&self.across);
        normal / normal.norm()
    }

    fn rim(&self) -> Vec<SpaceVector> {
        if self.round {
            return circle(self.at, self.along, self.across);
        }
        let corners = [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)];
        corners.map(|(x, y)| self.at + self.along * x + self.across * y).into()
    }

    /// The shadow of an outline, in parts of the half edges; what falls beside a disc is pulled to
    /// its rim.
    fn shadow(&self, outline: &[SpaceVector], cast: SpaceVector) -> Result<Vec<Point>> {
        let (normal, mut points) = (self.normal(), Vec::with_capacity(outline.len()));
        let part = |p: SpaceVector, edge: SpaceVector| p.dot(&edge) / edge.dot(&edge);
        for &p in outline {
            let from = p - self.at;
            let height = finite("height above the ground", from.dot(&normal))?.max(0.0);
            let foot = from + cast * height;
            points.push((part(foot, self.along), part(foot, self.across)));
        }
        Ok(if self.round {
            within_disc(&points)
        } else {
            clipped_polygon(&points, (-1.0, 1.0), (-1.0, 1.0))
        })
    }
}

/// The nearest place in the unit disc.
fn pulled((x, y): Point) -> Point {
    let pulled = 1.0 / hypot(x, y).max(1.0);
    (x * pulled, y * pulled)
}

/// An outline, but along the rim of the unit disc where it lies beside.
fn within_disc(points: &[Point]) -> Vec<Point> {
    let mut inside = Vec::with_capacity(points.len());
    for (i, &(ax, ay)) in points.iter().enumerate() {
        let (bx, by) = points[(i + 1) % points.len()];
        let (dx, dy) = (bx - ax, by - ay);
        let at = |s: f64| (ax + s * dx, ay + s * dy);
        // Where the edge from a to b passes the rim.
        let (square, half) = (dx * dx + dy * dy, ax * dx + ay * dy);
        let root = (half * half - square * (ax * ax + ay * ay - 1.0)).max(0.0).sqrt();
        let crossings = [-root, root].map(|root| (root - half) / square);
        let mut cuts = vec![0.0];
        cuts.extend(crossings.into_iter().filter(|&s| s > 0.0 && s < 1.0));
        cuts.push(1.0);
        for cut in cuts.windows(2) {
            let (from, to, middle) = (at(cut[0]), at(cut[1]), at(0.5 * (cut[0] + cut[1])));
            let beside = hypot(middle.0, middle.1) > 1.0;
            let turn = atan2(from.0 * to.1 - from.1 * to.0, from.0 * to.0 + from.1 * to.1);
            let steps = if beside { 1 + (turn.abs() / 0.15) as u32 } else { 1 };
            inside.extend((0..steps).map(|step| {
                let part = f64::from(step) / f64::from(steps);
                pulled(at(cut[0] + part * (cut[1] - cut[0])))
            }));
        }
    }
    inside
}

/// The bits of a point: faces share their corners exactly.
fn key(p: SpaceVector) -> [u64; 3] {
    // -0 and 0 are one place.
    p.to_array().map(|x| (x + 0.0).to_bits())
}

/// The outlines of what is seen of a closed body from far away in the direction `eye`. Around each
/// place they run as often as faces that look at the eye lie over it, all in one sense:
/// filled with the nonzero rule they are its silhouette.
fn outlines(solid: &Solid, eye: SpaceVector) -> Vec<Vec<SpaceVector>> {
    // Edges between two such faces cancel; from each corner the others go on to these.
    let mut edges: BTreeMap<[u64; 3], Vec<SpaceVector>> = BTreeMap::new();
    let facing = |face: &&Vec<SpaceVector>| normal(face).is_some_and(|n| n.dot(&eye) > 0.0);
    for face in solid.faces.iter().filter(facing) {
        for (i, &from) in face.iter().enumerate() {
            let to = face[(i + 1) % face.len()];
            if key(from) == key(to) {
                continue;
            }
            let back = edges.entry(key(to)).or_default();
            match back.iter().position(|&p| key(p) == key(from)) {
                Some(place) => drop(back.swap_remove(place)),
                None => edges.entry(key(from)).or_default().push(to),
            }
        }
    }
    let mut loops = Vec::new();
    while let Some((start, mut ends)) = edges.pop_first() {
        while let Some(mut at) = ends.pop() {
            let mut outline = vec![at];
            while key(at) != start {
                // As many edges leave a corner as arrive there.
                let Some(next) = edges.get_mut(&key(at)).and_then(Vec::pop) else {
                    break;
                };
                outline.push(next);
                at = next;
            }
            loops.push(outline);
        }
    }
    loops
}

/// Several outlines as one, over ways to and fro that enclose nothing.
fn joined(loops: &[Vec<Point>]) -> Vec<Point> {
    let Some(&base) = loops.first().and_then(|outline| outline.first()) else {
        return Vec::new();
    };
    let mut all = Vec::new();
    for outline in loops {
        all.extend_from_slice(outline);
        all.extend(outline.first());
        all.push(base);
    }
    all
}

#[cfg(test)]
mod tests {
    use super::super::display::Shape;
    use super::*;
    use core::f64::consts::PI;

    fn area(outline: &[Point]) -> f64 {
        let turn = |i: usize| {
            let ((ax, ay), (bx, by)) = (outline[i], outline[(i + 1) % outline.len()]);
            0.5 * (ax * by - ay * bx)
        };
        (0..outline.len()).map(turn).sum()
    }

    fn from_above(solid: &Solid) -> Vec<Vec<Point>> {
        let flat = |outline: Vec<SpaceVector>| outline.iter().map(|p| (p.x(), p.y())).collect();
        outlines(solid, UP).into_iter().map(flat).collect()
    }

    /// A ring from above has two outlines, a rod that leans one, and what they enclose is known.
    #[test]
    fn a_silhouette_encloses_what_is_seen() {
        let share = |n: f64| rotation_dynamics::math::sin(2.0 * PI / n) / (2.0 * PI / n);
        let ring = from_above(&Solid::ring(UP, UP, 2.0, 0.1));
        assert_eq!(ring.len(), 2);
        let found: f64 = ring.iter().map(|outline| area(outline)).sum();
        // Its section is a hexagon, 0.866 as wide as it is high.
        let expected = PI * 4.0 * 2.0 * 0.0866 * share(32.0);
        assert!((found / expected - 1.0).abs() < 1e-12, "{found} {expected}");
        let box_edges = [(2.0, 0.0, 0.0), (0.0, 3.0, 0.0), (0.0, 0.0, 1.0)];
        let edges = box_edges.map(|(x, y, z)| SpaceVector::new(x, y, z));
        let both = Solid::cuboid(UP, edges).with(Solid::cuboid(UP * 5.0, edges));
        let outlines = from_above(&both);
        // Two boxes, one above the other: both are there, the nonzero rule makes one of them.
        assert_eq!(outlines.iter().map(|outline| area(outline)).collect::<Vec<_>>(), [6.0, 6.0]);
        assert!((area(&joined(&outlines)) - 12.0).abs() < 1e-12);
    }

    #[test]
    fn a_shadow_ends_at_the_rim_of_the_ground() -> Result<()> {
        let ground = Ground::level(UP * -1.0, 1.0, 0.0);
        // A square over the middle, and one of which three quarters fall beside.
        let square = |x: f64, y: f64, half: f64| {
            [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)]
                .map(|(a, b)| SpaceVector::new(x + half * a, y + half * b, 0.0))
        };
        let within = ground.shadow(&square(0.3, 0.0, 0.2), SpaceVector::new(-0.3, 0.0, 0.0))?;
        assert!((area(&within) - 0.16).abs() < 1e-12);
        let all = ground.shadow(&square(1.0, 1.0, 1.0), SpaceVector::zero())?;
        // A quarter of the disc, its rim in chords.
        assert!(all.iter().all(|&(x, y)| hypot(x, y) < 1.0 + 1e-12));
        assert!((area(&all) / (0.25 * PI) - 1.0).abs() < 0.01, "{}", area(&all));
        // What lies below the ground throws none upwards.
        let below = ground.shadow(
            &square(0.0, 0.0, 0.2).map(|p| p - UP * 2.0),
            SpaceVector::new(0.5, 0.5, 0.0),
        )?;
        assert!((area(&below) - 0.16).abs() < 1e-12);
        Ok(())
    }

    #[test]
    fn only_bodies_over_ground_have_shadows() -> Result<()> {
        let ball = View::new("ball", "a ball that floats over a table")
            .solid(Solid::ball(SpaceVector::zero(), 0.3), Ink::Body);
        let shadows = |view: &View| -> Result<usize> {
            let shapes = view.figure()?.display.shapes;
            let dark = |shape: &&Shape| matches!(shape, Shape::Area(_, Ink::Shadow, _));
            Ok(shapes.iter().filter(dark).count())
        };
        assert_eq!(shadows(&ball)?, 0);
        assert_eq!(shadows(&ball.clone().table(UP * -0.5, 1.0))?, LAMPS as usize);
        assert_eq!(shadows(&View::new("bare", "a table without a body").table(UP, 1.0))?, 0);
        Ok(())
    }
}
