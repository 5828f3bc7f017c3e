//! Three dimensions, orthographic: the sphere with the trace of an axis, arrows, solids.

use super::canvas::{Canvas, Frame, Paint, Point, Rect, Side, Text, figure};
use super::ink::Ink;
use super::place::GAP;
use super::solid::{Camera, Solid, normal};
use super::svg::{Dash, Stroke};
use crate::error::{Result, finite, positive};
use crate::frame::SpaceVector;
use crate::math::sincos;
use crate::report::Figure;
use core::f64::consts::PI;

#[derive(Debug, Clone)]
enum Element {
    Line(Vec<SpaceVector>, Stroke),
    /// A line on the sphere: lighter and dashed where the sphere hides it.
    OnSphere(Vec<SpaceVector>, Stroke),
    Arrow(SpaceVector, SpaceVector, Ink),
    Heading(Vec<SpaceVector>, Ink),
    Solid(Solid, Ink),
    Dot(SpaceVector, Ink, bool),
}

/// A picture of three dimensions, seen by one [`Camera`].
///
/// ```
/// use rotation_dynamics::frame::SpaceVector;
/// use rotation_dynamics::report::draw::{Ink, Side, View};
/// let trace = (0..=100).map(|i| {
///     let (s, c) = rotation_dynamics::math::sincos(0.06 * f64::from(i));
///     SpaceVector::new(0.6 * c, 0.6 * s, 0.8)
/// });
/// let figure = View::new("trace", "the axis draws a circle of latitude on the sphere")
///     .sphere()
///     .trace(trace, Ink::Body)
///     .arrow(SpaceVector::zero(), SpaceVector::new(0.6, 0.0, 0.8), Ink::Body, "$e_3$", Side::Right)
///     .triad()
///     .figure()?;
/// # assert!(figure.svg.contains("<path"));
/// # Ok::<(), rotation_dynamics::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct View {
    name: String,
    alt: String,
    size: (u32, u32),
    camera: Camera,
    reach: f64,
    centre: SpaceVector,
    sphere: bool,
    triad: bool,
    elements: Vec<Element>,
    texts: Vec<(SpaceVector, String, Ink, Side)>,
}

impl View {
    /// An empty view of the unit sphere's surroundings; `alt` says in a sentence what
    /// is to be seen.
    pub fn new(name: &str, alt: &str) -> Self {
        Self {
            name: name.into(),
            alt: alt.into(),
            size: (340, 300),
            camera: Camera::default(),
            reach: 1.12,
            centre: SpaceVector::zero(),
            sphere: false,
            triad: false,
            elements: Vec::new(),
            texts: Vec::new(),
        }
    }

    /// Sets the size in px (340 by 300 if never set).
    #[must_use]
    pub fn size(mut self, width: u32, height: u32) -> Self {
        self.size = (width, height);
        self
    }

    /// Sets the camera; one for a chapter.
    #[must_use]
    pub fn camera(mut self, camera: Camera) -> Self {
        self.camera = camera;
        self
    }

    /// Sets what is shown: at least `reach` to every side of `centre`.
    #[must_use]
    pub fn around(mut self, centre: SpaceVector, reach: f64) -> Self {
        (self.centre, self.reach) = (centre, reach);
        self
    }

    /// Adds the unit sphere about the origin: outline, equator, and the meridian through X.
    #[must_use]
    pub fn sphere(mut self) -> Self {
        self.sphere = true;
        let (x, y, z) = (
            SpaceVector::new(1.0, 0.0, 0.0),
            SpaceVector::new(0.0, 1.0, 0.0),
            SpaceVector::new(0.0, 0.0, 1.0),
        );
        let thin = Stroke {
            opacity: 0.55,
            ..Stroke::new(Ink::Frame, 0.8)
        };
        for (u, v) in [(x, y), (x, z)] {
            self.elements
                .push(Element::OnSphere(circle(SpaceVector::zero(), u, v), thin));
        }
        self
    }

    /// Adds a small triad of the axes X, Y, Z in the lower left corner.
    #[must_use]
    pub fn triad(mut self) -> Self {
        self.triad = true;
        self
    }

    /// Adds a curve on the unit sphere, lighter and dashed where the sphere hides it.
    #[must_use]
    pub fn trace(mut self, points: impl IntoIterator<Item = SpaceVector>, ink: Ink) -> Self {
        let points = points.into_iter().collect();
        self.elements
            .push(Element::OnSphere(points, Stroke::new(ink, 1.8)));
        self
    }

    /// Adds the circle of latitude at this angle from Z, thin: a turning point.
    #[must_use]
    pub fn latitude(mut self, theta: f64) -> Self {
        let (s, c) = sincos(theta);
        let circle = circle(
            SpaceVector::new(0.0, 0.0, c),
            SpaceVector::new(s, 0.0, 0.0),
            SpaceVector::new(0.0, s, 0.0),
        );
        self.elements
            .push(Element::OnSphere(circle, Stroke::new(Ink::Frame, 1.0)));
        self
    }

    /// Adds a line anywhere in space; nothing hides it.
    #[must_use]
    pub fn line(mut self, points: impl IntoIterator<Item = SpaceVector>, ink: Ink) -> Self {
        let points = points.into_iter().collect();
        self.elements
            .push(Element::Line(points, Stroke::new(ink, 1.2)));
        self
    }

    /// Adds a dashed line anywhere in space: an axis, a construction line.
    #[must_use]
    pub fn dashed(mut self, points: impl IntoIterator<Item = SpaceVector>, ink: Ink) -> Self {
        let stroke = Stroke {
            dash: Dash::Dashed,
            ..Stroke::new(ink, 1.0)
        };
        self.elements
            .push(Element::Line(points.into_iter().collect(), stroke));
        self
    }

    /// Adds an arrow with a label at its tip. A force or torque has an open head, the
    /// body axis and space axes are thinner.
    #[must_use]
    pub fn arrow(
        mut self,
        from: SpaceVector,
        to: SpaceVector,
        ink: Ink,
        label: &str,
        side: Side,
    ) -> Self {
        self.elements.push(Element::Arrow(from, to, ink));
        self.text(to, label, ink, side)
    }

    /// Adds an arrow along a curve: which way something turns.
    #[must_use]
    pub fn turn(mut self, points: impl IntoIterator<Item = SpaceVector>, ink: Ink) -> Self {
        self.elements
            .push(Element::Heading(points.into_iter().collect(), ink));
        self
    }

    /// Adds a solid, flat-shaded.
    #[must_use]
    pub fn solid(mut self, solid: Solid, ink: Ink) -> Self {
        self.elements.push(Element::Solid(solid, ink));
        self
    }

    /// Adds a dot; `label` may be empty.
    #[must_use]
    pub fn dot(mut self, at: SpaceVector, ink: Ink, label: &str, side: Side) -> Self {
        self.elements.push(Element::Dot(at, ink, false));
        self.text(at, label, ink, side)
    }

    /// Adds a ring; `label` may be empty.
    #[must_use]
    pub fn ring(mut self, at: SpaceVector, ink: Ink, label: &str, side: Side) -> Self {
        self.elements.push(Element::Dot(at, ink, true));
        self.text(at, label, ink, side)
    }

    /// Adds a text beside a point; an empty one adds nothing.
    #[must_use]
    pub fn text(mut self, at: SpaceVector, text: &str, ink: Ink, side: Side) -> Self {
        if !text.is_empty() {
            self.texts.push((at, text.into(), ink, side));
        }
        self
    }

    /// Draws it.
    ///
    /// # Errors
    /// [`crate::Error::NotFinite`] for NaN and infinities, [`crate::Error::OutOfRange`] for a reach
    /// that is not positive or a point far outside the picture, [`crate::Error::Text`] for a
    /// bad name or a missing alternative text.
    pub fn figure(&self) -> Result<Figure> {
        positive("the reach of a view", self.reach)?;
        figure(&self.name, &self.alt, self.size, |canvas| {
            let rect = canvas.rect();
            let unit = rect.right.min(rect.bottom) / (2.0 * self.reach);
            let (cx, cy) = self.camera.project(self.centre);
            let (rx, ry) = (rect.right / unit / 2.0, rect.bottom / unit / 2.0);
            let frame = canvas.frame((cx - rx, cx + rx), (cy - ry, cy + ry), rect);
            if self.sphere {
                let outline = super::sketch::arc((0.0, 0.0), 1.0, (0.0, 2.0 * PI));
                frame.draw(&outline, Paint::Fill(Ink::Frame, 0.07))?;
                frame.draw(&outline, Paint::Loop(Stroke::new(Ink::Frame, 1.0)))?;
            }
            // What the sphere hides comes first.
            for element in &self.elements {
                if let Element::OnSphere(points, stroke) = element {
                    let hidden = Stroke {
                        dash: Dash::Dashed,
                        opacity: 0.45 * stroke.opacity,
                        width: 0.75 * stroke.width,
                        ..*stroke
                    };
                    self.on_sphere(&frame, points, false, hidden)?;
                }
            }
            for element in &self.elements {
                self.paint(&frame, element)?;
            }
            if self.triad {
                self.paint_triad(canvas)?;
            }
            for (at, text, ink, side) in &self.texts {
                let text = Text::new(text, *ink, *side, GAP);
                frame.draw(&[self.camera.project(*at)], Paint::Text(text))?;
            }
            Ok(())
        })
    }

    fn paint(&self, frame: &Frame<'_>, element: &Element) -> Result<()> {
        let flat = |points: &[SpaceVector]| -> Vec<Point> {
            points.iter().map(|&p| self.camera.project(p)).collect()
        };
        match element {
            Element::Line(points, stroke) => frame.draw(&flat(points), Paint::Line(*stroke)),
            Element::OnSphere(points, stroke) => self.on_sphere(frame, points, true, *stroke),
            Element::Arrow(from, to, ink) => {
                let thin = matches!(ink, Ink::Body | Ink::Frame | Ink::Ink);
                let stroke = Stroke::new(*ink, if thin { 1.4 } else { 2.2 });
                let open = *ink == Ink::Force;
                frame.draw(&flat(&[*from, *to]), Paint::Arrow(stroke, 9.0, open))
            }
            Element::Heading(points, ink) => {
                let stroke = Stroke::new(*ink, 1.8);
                frame.draw(&flat(points), Paint::Arrow(stroke, 8.0, false))
            }
            Element::Solid(solid, ink) => self.paint_solid(frame, solid, *ink),
            Element::Dot(at, ink, ring) => {
                frame.draw(&[self.camera.project(*at)], Paint::Dot(*ink, 3.2, *ring))
            }
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
                    part.push(
                        self.camera
                            .project(before + (p - before) * (last / (last - depth))),
                    );
                    if depth < 0.0 {
                        frame.draw(&part, Paint::Line(stroke))?;
                        part.clear();
                    }
                }
            }
            if depth >= 0.0 {
                part.push(self.camera.project(p));
            }
        }
        frame.draw(&part, Paint::Line(stroke))
    }

    /// The faces that look at the eye, from far to near, darker as they turn from the light.
    fn paint_solid(&self, frame: &Frame<'_>, solid: &Solid, ink: Ink) -> Result<()> {
        let light = self.camera.eye * 0.6 + self.camera.up * 0.7 - self.camera.right * 0.4;
        let light = light / light.norm();
        let mut seen: Vec<(f64, Vec<Point>, f64)> = Vec::new();
        for face in &solid.faces {
            let Some(normal) = normal(face) else {
                continue;
            };
            if self.camera.depth(normal) <= 0.0 {
                continue;
            }
            let depth: f64 =
                face.iter().map(|&p| self.camera.depth(p)).sum::<f64>() / face.len() as f64;
            let shade = 0.5 - 0.36 * normal.dot(&light);
            let outline = face.iter().map(|&p| self.camera.project(p)).collect();
            seen.push((finite("depth in a view", depth)?, outline, shade));
        }
        seen.sort_by(|a, b| a.0.total_cmp(&b.0));
        for (_, outline, shade) in seen {
            // Whole percents keep the text short.
            let percent = libm::round(shade * 100.0) as u32;
            frame.draw(&outline, Paint::Face(ink, percent))?;
        }
        Ok(())
    }

    fn paint_triad(&self, canvas: &Canvas<'_>) -> Result<()> {
        let rect = Rect {
            left: 4.0,
            right: 64.0,
            top: canvas.rect().bottom - 62.0,
            bottom: canvas.rect().bottom - 2.0,
        };
        let frame = canvas.frame((-1.3, 1.3), (-1.2, 1.4), rect);
        for (axis, name) in [
            (SpaceVector::new(1.0, 0.0, 0.0), "$X$"),
            (SpaceVector::new(0.0, 1.0, 0.0), "$Y$"),
            (SpaceVector::new(0.0, 0.0, 1.0), "$Z$"),
        ] {
            let tip = self.camera.project(axis);
            let stroke = Stroke::new(Ink::Frame, 1.0);
            frame.draw(&[(0.0, 0.0), tip], Paint::Arrow(stroke, 5.0, false))?;
            let text = Text::new(name, Ink::Frame, Side::Centre, 0.0);
            let beyond = 1.0 + 0.4 / crate::math::hypot(tip.0, tip.1).max(0.4);
            frame.draw(&[(tip.0 * beyond, tip.1 * beyond)], Paint::Text(text))?;
        }
        Ok(())
    }
}

/// A closed circle about `centre` through `centre + u` and `centre + v`.
fn circle(centre: SpaceVector, u: SpaceVector, v: SpaceVector) -> Vec<SpaceVector> {
    super::sketch::arc((0.0, 0.0), 1.0, (0.0, 2.0 * PI))
        .into_iter()
        .map(|(c, s)| centre + u * c + v * s)
        .collect()
}
