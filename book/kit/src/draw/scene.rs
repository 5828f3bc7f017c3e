//! How a view is painted: what lies behind the sphere, its far side, what is inside, its
//! near side, what lies before it, and the labels.

use super::canvas::{Canvas, Frame, Paint, Point};
use super::display::{Dash, Stroke};
use super::ink::Ink;
use super::place::{GAP, Obstacles};
use super::solid::Solid;
use super::view::{Element, View};
use super::words::{Rect, Side, Words};
use crate::error::{Result, finite};
use core::f64::consts::PI;
use rotation_dynamics::frame::SpaceVector;

/// The light of bodies, and of arrows, whose colour says what they are and must be seen: in percent,
/// from the shade to the full light.
pub(super) const BODY: [f64; 2] = [0.0, 100.0];
const VECTOR: [f64; 2] = [12.0, 60.0];

/// The radius of a dot on a body, in px.
const SPOT: f64 = 3.2;

/// Where a part of a line lies relative to the sphere, from behind to the front.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Layer {
    Behind,
    Inside,
    Before,
}

/// What is painted together, in one layer.
pub(super) struct Part<'a> {
    layer: Layer,
    pub(crate) points: Vec<SpaceVector>,
    pub(crate) stroke: Stroke,
    /// Length of the head at its end, in px.
    pub(super) head: Option<f64>,
    element: &'a Element,
}

impl View {
    /// Its height when it is so wide, in px.
    pub(super) fn height(&self, width: f64) -> f64 {
        libm::round(width * f64::from(self.size.1) / f64::from(self.size.0))
    }

    pub(super) fn paint_into(&self, canvas: &Canvas, rect: Rect) -> Result<()> {
        crate::error::positive("the reach of a view", self.reach)?;
        let (width, height) = (rect.right - rect.left, rect.bottom - rect.top);
        let unit = width.min(height) / (2.0 * self.reach);
        let (cx, cy) = self.camera.project(self.centre);
        let (rx, ry) = (width / unit / 2.0, height / unit / 2.0);
        let frame = canvas.frame((cx - rx, cx + rx), (cy - ry, cy + ry), rect);
        self.paint_ground(&frame)?;
        for element in &self.elements {
            if let Element::Ghost(solid, ink) = element {
                self.paint_ghost(&frame, solid, *ink)?;
            }
        }
        self.paint_bands(&frame, false)?;
        let parts = self.parts();
        self.paint_glass(&frame)?;
        self.paint_layer(&frame, &parts, Layer::Behind, unit)?;
        self.paint_balls(&frame, true)?;
        if self.sphere {
            let outline = super::sketch::arc((0.0, 0.0), 1.0, (0.0, 2.0 * PI));
            frame.draw(&outline, &Paint::Fill(Ink::Frame, 0.07))?;
            frame.draw(&outline, &Paint::Loop(Stroke::new(Ink::Frame, 1.2)))?;
        }
        if self.globe {
            self.paint_globe(&frame)?;
        }
        for element in self.elements.iter().filter(|_| !self.globe) {
            if let Element::OnSphere(points, stroke) = element {
                let hidden =
                    Stroke { dash: Dash::Dashed, width: 0.75 * stroke.width, ..stroke.faint(0.5) };
                self.on_sphere(&frame, points, false, hidden)?;
            }
        }
        self.paint_balls(&frame, false)?;
        self.paint_layer(&frame, &parts, Layer::Inside, unit)?;
        for element in &self.elements {
            if let Element::OnSphere(points, stroke) = element {
                self.on_sphere(&frame, points, true, *stroke)?;
            }
        }
        self.paint_bands(&frame, true)?;
        self.paint_layer(&frame, &parts, Layer::Before, unit)?;
        for element in &self.elements {
            match element {
                Element::Within(ends, stroke, head) => {
                    let paint = Paint::Arrow(*stroke, *head, stroke.ink == Ink::Force);
                    frame.draw(&self.flat(ends), &paint)?;
                }
                Element::Dot(at, ink, radius, ring) => {
                    frame.draw(&[self.camera.project(*at)], &Paint::Dot(*ink, *radius, *ring))?;
                }
                Element::Spot(at, ink) if self.hides(*at) => {
                    let round =
                        super::sketch::arc(self.camera.project(*at), SPOT / unit, (0.0, 2.0 * PI));
                    frame.draw(&round, &Paint::Fill(*ink, 0.35))?;
                }
                Element::Spot(at, ink) => {
                    frame.draw(&[self.camera.project(*at)], &Paint::Dot(*ink, SPOT, false))?;
                }
                _ => {}
            }
        }
        if self.triad {
            self.paint_triad(canvas, rect)?;
        }
        self.paint_labels(canvas, &frame, rect)
    }

    pub(super) fn flat(&self, points: &[SpaceVector]) -> Vec<Point> {
        points.iter().map(|&p| self.camera.project(p)).collect()
    }

    /// Lines and arrows, cut where they pass through the sphere.
    fn parts(&self) -> Vec<Part<'_>> {
        let mut parts = Vec::new();
        for element in &self.elements {
            let (points, stroke, head) = match element {
                Element::Line(points, stroke) => (points, *stroke, None),
                Element::Arrow(points, stroke, head) => (points, *stroke, Some(*head)),
                _ => continue,
            };
            let pieces = self.layered(points);
            let last = pieces.len();
            for (i, (layer, points)) in pieces.into_iter().enumerate() {
                parts.push(Part {
                    layer,
                    points,
                    stroke,
                    head: head.filter(|_| i + 1 == last),
                    element,
                });
            }
        }
        parts
    }

    fn layered(&self, points: &[SpaceVector]) -> Vec<(Layer, Vec<SpaceVector>)> {
        if !self.sphere && !self.globe {
            return vec![(Layer::Inside, points.to_vec())];
        }
        let mut found: Vec<(Layer, Vec<SpaceVector>)> = Vec::new();
        for pair in points.windows(2) {
            let (a, b) = (pair[0], pair[1]);
            let mut cuts = vec![0.0];
            cuts.extend(crossings(a, b));
            cuts.push(1.0);
            for cut in cuts.windows(2) {
                let at = |s: f64| if s == 1.0 { b } else { a + (b - a) * s };
                let middle = at((cut[0] + cut[1]) / 2.0);
                let layer = if middle.norm() <= 1.0 {
                    Layer::Inside
                } else if self.camera.depth(middle) < 0.0 {
                    Layer::Behind
                } else {
                    Layer::Before
                };
                match found.last_mut() {
                    Some((last, part)) if *last == layer => part.push(at(cut[1])),
                    _ => found.push((layer, vec![at(cut[0]), at(cut[1])])),
                }
            }
        }
        found
    }

    /// Where a body is: a globe is before it or behind, and it is within any other sphere.
    fn layer_of(&self, points: impl IntoIterator<Item = SpaceVector>) -> Layer {
        if !self.globe {
            return Layer::Inside;
        }
        let depth: f64 = points.into_iter().map(|p| self.camera.depth(p)).sum();
        if depth < 0.0 { Layer::Behind } else { Layer::Before }
    }

    /// That a face is before the sphere, if a band of it is drawn and the face is outside on the near side.
    fn before_bands(&self, face: &[SpaceVector]) -> Option<Layer> {
        let banded = self.elements.iter().any(|element| matches!(element, Element::Band(_)));
        let outside = |p: &SpaceVector| p.norm() > 1.0 && self.camera.depth(*p) > 0.0;
        (banded && face.iter().all(outside)).then_some(Layer::Before)
    }

    /// Lines, arrows and bodies of a layer.
    fn paint_layer(
        &self,
        frame: &Frame<'_>,
        parts: &[Part<'_>],
        layer: Layer,
        unit: f64,
    ) -> Result<()> {
        let parts: Vec<&Part<'_>> = parts.iter().filter(|p| p.layer == layer).collect();
        let mut items = Vec::new();
        for element in &self.elements {
            match element {
                Element::Solid(solid, ink)
                    if self.layer_of(solid.faces.iter().flatten().copied()) == layer =>
                {
                    self.faces(solid, *ink, BODY, &mut items)?;
                }
                Element::Patch(outline, ink, light)
                    if self.layer_of(outline.iter().copied()) == layer =>
                {
                    self.patched(outline, *ink, *light, &mut items)?;
                }
                Element::Vector([from, to], ink) => {
                    // The angular velocity may lie along L.
                    let (size, along) = if self.slim { (0.6, 0.9) } else { (1.0, 1.45) };
                    let thick = if *ink == Ink::Velocity { along } else { 1.0 };
                    let mut arrow = Solid::arrow(*from, *to, size * self.reach, thick);
                    let whole = self.layer_of([*from, *to]);
                    arrow.faces.retain(|face| self.before_bands(face).unwrap_or(whole) == layer);
                    self.faces(&arrow, *ink, VECTOR, &mut items)?;
                }
                _ => {}
            }
        }
        if items.is_empty() {
            for part in parts {
                let flat = self.flat(&part.points);
                frame.draw(&flat, &self.paint_of(part))?;
            }
            return Ok(());
        }
        for part in &parts {
            self.pieces(part, unit, &mut items)?;
        }
        self.paint_items(frame, &items)?;
        // Where a body hides an arrow, a trace of it remains.
        for part in parts {
            if let Element::Arrow(..) = part.element {
                let stroke = Stroke { width: 0.7 * part.stroke.width, ..part.stroke.faint(0.35) };
                frame.draw(&self.flat(&part.points), &Paint::Line(stroke))?;
            }
        }
        Ok(())
    }

    pub(super) fn paint_of(&self, part: &Part<'_>) -> Paint {
        match part.head {
            Some(head) => Paint::Arrow(part.stroke, head, part.stroke.ink == Ink::Force),
            None => Paint::Line(part.stroke),
        }
    }

    /// Draws the parts of a curve on the near side of the sphere, or on the far side.
    fn on_sphere(
        &self,
        frame: &Frame<'_>,
        points: &[SpaceVector],
        near: bool,
        stroke: Stroke,
    ) -> Result<()> {
        let sign = if near { 1.0 } else { -1.0 };
        let mut part: Vec<Point> = Vec::new();
        for (i, &p) in points.iter().enumerate() {
            let depth = finite("depth in a view", sign * self.camera.depth(p))?;
            if let Some(&before) = i.checked_sub(1).and_then(|k| points.get(k)) {
                let last = sign * self.camera.depth(before);
                if (last < 0.0) != (depth < 0.0) {
                    // Both halves end at the point where the curve passes the rim.
                    let rim = before + (p - before) * (last / (last - depth));
                    part.push(self.camera.project(rim));
                    if depth < 0.0 {
                        frame.draw(&part, &Paint::Line(stroke))?;
                        part.clear();
                    }
                }
            }
            if depth >= 0.0 {
                part.push(self.camera.project(p));
            }
        }
        frame.draw(&part, &Paint::Line(stroke))
    }

    fn triad_rect(rect: Rect) -> Rect {
        Rect {
            left: rect.left + 4.0,
            right: rect.left + 64.0,
            top: rect.bottom - 62.0,
            bottom: rect.bottom - 2.0,
        }
    }

    fn paint_triad(&self, canvas: &Canvas, rect: Rect) -> Result<()> {
        let frame = canvas.frame((-1.3, 1.3), (-1.2, 1.4), Self::triad_rect(rect));
        for (axis, name) in [
            (SpaceVector::new(1.0, 0.0, 0.0), "$X$"),
            (SpaceVector::new(0.0, 1.0, 0.0), "$Y$"),
            (SpaceVector::new(0.0, 0.0, 1.0), "$Z$"),
        ] {
            let tip = self.camera.project(axis);
            let stroke = Stroke::new(Ink::Frame, 1.0);
            frame.draw(&[(0.0, 0.0), tip], &Paint::Arrow(stroke, 5.0, false))?;
            let words = Words::new(name, Ink::Frame, Side::Centre, 0.0);
            let beyond = 1.0 + 0.45 / rotation_dynamics::math::hypot(tip.0, tip.1).max(0.4);
            frame.draw(&[(tip.0 * beyond, tip.1 * beyond)], &Paint::Text(words))?;
        }
        Ok(())
    }

    fn paint_labels(&self, canvas: &Canvas, frame: &Frame<'_>, rect: Rect) -> Result<()> {
        let mut obstacles = Obstacles::new(rect.grown(-2.0));
        if self.triad {
            obstacles.take(Self::triad_rect(rect));
        }
        let ball = self.elements.iter().any(|element| matches!(element, Element::Ball(..)));
        if self.sphere || self.globe || ball {
            let outline = super::sketch::arc((0.0, 0.0), 1.0, (0.0, 2.0 * PI));
            let outline: Vec<Point> = outline.into_iter().map(|p| frame.px(p)).collect();
            obstacles.add_line(Obstacles::NOBODY, &outline);
        }
        for element in &self.elements {
            match element {
                // Thin lines and hidden ones may pass below a label.
                Element::Line(points, stroke)
                | Element::OnSphere(points, stroke)
                | Element::Arrow(points, stroke, _)
                    if stroke.width >= 1.0 =>
                {
                    let px: Vec<Point> =
                        self.flat(points).into_iter().map(|p| frame.px(p)).collect();
                    obstacles.add_line(Obstacles::NOBODY, &px);
                    if let Element::Arrow(_, _, head) = element {
                        obstacles.add_head(&px, *head);
                    }
                }
                Element::Vector(ends, _) | Element::Within(ends, ..) => {
                    let px: Vec<Point> = self.flat(ends).into_iter().map(|p| frame.px(p)).collect();
                    obstacles.add_line(Obstacles::NOBODY, &px);
                }
                Element::Dot(at, _, radius, _) => {
                    obstacles.take(Rect::about(frame.px(self.camera.project(*at)), *radius));
                }
                Element::Spot(at, _) => {
                    obstacles.take(Rect::about(frame.px(self.camera.project(*at)), SPOT));
                }
                _ => {}
            }
        }
        let sheet = canvas.sheet();
        if let Some(text) = &self.corner {
            let at = (rect.left + 6.0, rect.top + 14.0);
            if let Some(placed) = obstacles
                .place_at(at, Side::Right, 0.0, |side, gap| Words::new(text, Ink::Ink, side, gap))
            {
                placed.paint(&sheet)?;
            }
        }
        for (at, text, ink, side) in &self.texts {
            let at = frame.px(self.camera.project(*at));
            let words = |side, gap| Words::new(text, *ink, side, gap);
            if let Some(placed) = obstacles.place_at(at, *side, GAP, words) {
                placed.paint(&sheet)?;
            }
        }
        Ok(())
    }
}

/// Where the way from `a` to `b` passes through the unit sphere, as parts of it.
fn crossings(a: SpaceVector, b: SpaceVector) -> Vec<f64> {
    let along = b - a;
    let (square, half, rest) = (along.dot(&along), a.dot(&along), a.dot(&a) - 1.0);
    let root = (half * half - square * rest).max(0.0).sqrt();
    // What begins or ends on the sphere is not cut there.
    [-half - root, -half + root]
        .into_iter()
        .map(|s| s / square)
        .filter(|s| (1e-3..=1.0 - 1e-3).contains(s))
        .collect()
}
