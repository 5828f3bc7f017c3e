//! Three dimensions, orthographic: the sphere with the trace of an axis, arrows, solids.

use super::canvas::figure;
use super::display::{Dash, Stroke};
use super::globe::graticule;
use super::ink::Ink;
use super::shadow::Ground;
use super::solid::{Camera, Solid, across};
use super::words::Side;
use crate::Figure;
use crate::error::{Result, positive};
use core::f64::consts::PI;
use rotation_dynamics::frame::SpaceVector;
use rotation_dynamics::math::sincos;

#[derive(Debug, Clone)]
pub(super) enum Element {
    Line(Vec<SpaceVector>, Stroke),
    /// A line on the sphere: lighter and dashed where the sphere hides it.
    OnSphere(Vec<SpaceVector>, Stroke),
    /// A line with a head of this length (px) at its end.
    Arrow(Vec<SpaceVector>, Stroke, f64),
    Solid(Solid, Ink),
    /// A body that is seen through, and what is painted on it.
    Glass(Vec<(Solid, Ink)>),
    /// An arrow that begins within a body, over all bodies.
    Within([SpaceVector; 2], Stroke, f64),
    /// A flat patch on a body, with so many percent of light.
    Patch(Vec<SpaceVector>, Ink, u32),
    /// The unit ball in the light, and whether it is seen through.
    Ball(Ink, bool),
    /// A place, its ink, its radius (px), and whether it is a ring.
    Dot(SpaceVector, Ink, f64, bool),
    /// A dot on a body, faint where it is hidden.
    Spot(SpaceVector, Ink),
    /// A lit arrow from one place to another.
    Vector([SpaceVector; 2], Ink),
    /// Ground below everything else.
    Ground(Ground),
    /// The silhouette of a body that is not there, behind all bodies.
    Ghost(Solid, Ink),
    /// The part of the unit sphere between two tilts from Z.
    Band([f64; 2]),
}

/// A picture of three dimensions, seen by one [`Camera`].
///
/// ```
/// use rotation_dynamics::frame::SpaceVector;
/// use kit::draw::{Ink, Side, View};
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
/// # assert!(figure.svg().contains("<path"));
/// # Ok::<(), kit::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct View {
    name: String,
    alt: String,
    pub(super) size: (u32, u32),
    pub(super) camera: Camera,
    pub(super) reach: f64,
    pub(super) centre: SpaceVector,
    pub(super) sphere: bool,
    pub(super) globe: bool,
    pub(super) triad: bool,
    pub(super) slim: bool,
    pub(super) elements: Vec<Element>,
    pub(super) texts: Vec<(SpaceVector, String, Ink, Side)>,
    pub(super) corner: Option<String>,
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
            globe: false,
            triad: false,
            slim: false,
            elements: Vec::new(),
            texts: Vec::new(),
            corner: None,
        }
    }

    /// An empty view of at least `reach` to every side of `centre`, for
    /// [`figures!`](crate::figures), which names it and says what is to be seen, and as a scene.
    pub fn of(centre: SpaceVector, reach: f64) -> Self {
        Self::new("", "").around(centre, reach)
    }

    pub(super) fn called(mut self, name: &str, alt: &str) -> Self {
        (self.name, self.alt) = (name.into(), alt.into());
        self
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

    /// Adds the unit sphere about the origin: outline, equator, the meridian through X, the
    /// centre, and the Z axis through the pole.
    #[must_use]
    pub fn sphere(mut self) -> Self {
        self.sphere = true;
        self
    }

    /// Adds the unit sphere about the origin as a lit body that hides what is behind it: the Earth
    /// with its parallels, and its meridians turned about Z by `turn` (rad).
    #[must_use]
    pub fn globe(mut self, turn: f64) -> Self {
        self.globe = true;
        let thin = Stroke::new(Ink::Frame, 0.8).faint(0.6);
        let (meridians, parallels) = graticule();
        let up = SpaceVector::new(0.0, 0.0, 1.0);
        for meridian in meridians {
            let (s, c) = sincos(turn + meridian);
            let half = super::sketch::arc((0.0, 0.0), 1.0, (0.0, PI)).into_iter();
            let points = half.map(|(z, out)| SpaceVector::new(c * out, s * out, 0.0) + up * z);
            self.elements.push(Element::OnSphere(points.collect(), thin));
        }
        for tilt in parallels {
            let (s, c) = sincos(tilt);
            let (x, y) = (SpaceVector::new(s, 0.0, 0.0), SpaceVector::new(0.0, s, 0.0));
            self.elements.push(Element::OnSphere(circle(up * c, x, y), thin));
        }
        self
    }

    /// As it is seen: the camera as the reader turned it, and with the lines of the sphere,
    /// which depend on the camera.
    pub(super) fn furnished(&self) -> Self {
        let mut view = self.clone();
        view.camera = self.camera.as_turned();
        if !self.sphere {
            return view;
        }
        let (x, y, z) = (
            SpaceVector::new(1.0, 0.0, 0.0),
            SpaceVector::new(0.0, 1.0, 0.0),
            SpaceVector::new(0.0, 0.0, 1.0),
        );
        let thin = Stroke::new(Ink::Frame, 0.8).faint(0.55);
        let great = |u, v| Element::OnSphere(circle(SpaceVector::zero(), u, v), thin);
        let within = Stroke { dash: Dash::Dashed, ..thin };
        // The axis ends outside the outline, so long as that is not far away.
        let (right, up) = view.camera.project(z);
        let seen = rotation_dynamics::math::hypot(right, up);
        let end = (1.08 / seen.max(0.1)).clamp(1.14, 1.6);
        let above = Stroke::new(Ink::Frame, 1.0);
        let lines = [
            great(x, y),
            great(x, z),
            Element::Line(vec![SpaceVector::zero(), z], within),
            Element::Arrow(vec![z, z * end], above, 6.0),
        ];
        view.elements.splice(0..0, lines);
        let centre = Element::Dot(SpaceVector::zero(), Ink::Frame, 1.8, false);
        view.elements.push(centre);
        view.text(z * (end - 0.03), "$Z$", Ink::Frame, Side::Right)
    }

    /// Adds a piece of level ground about the point `at`, round, below everything else. Bodies
    /// throw soft shadows on it.
    #[must_use]
    pub fn ground(mut self, at: SpaceVector, radius: f64) -> Self {
        self.elements.push(Element::Ground(Ground::level(at, radius, 0.0)));
        self
    }

    /// Adds a round table whose top lies about the point `at`: ground with an edge.
    #[must_use]
    pub fn table(mut self, at: SpaceVector, radius: f64) -> Self {
        self.elements.push(Element::Ground(Ground::level(at, radius, 0.05 * radius)));
        self
    }

    /// Adds a rectangle of ground about the point `at` that need not be level: half its edges are
    /// these vectors, at right angles, and it is the side to which `along` x `across` points.
    #[must_use]
    pub fn slope(mut self, at: SpaceVector, along: SpaceVector, across: SpaceVector) -> Self {
        let slope = Ground { at, along, across, round: false, thickness: 0.0 };
        self.elements.push(Element::Ground(slope));
        self
    }

    /// Writes a text into the upper left corner: the time, or what is set.
    #[must_use]
    pub fn corner(mut self, text: &str) -> Self {
        self.corner = Some(text.into());
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
        self.elements.push(Element::OnSphere(points, Stroke::new(ink, 1.8)));
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
        self.elements.push(Element::OnSphere(circle, Stroke::new(Ink::Frame, 0.8)));
        self
    }

    /// Adds the band of the unit sphere between two angles from Z: where an axis may go. It is
    /// translucent, its far half fainter.
    #[must_use]
    pub fn band(mut self, from: f64, to: f64) -> Self {
        self.elements.push(Element::Band([from, to]));
        self.latitude(from).latitude(to)
    }

    /// Adds a path along which something went, as a ribbon that fades towards its old end. The
    /// points are equal times apart. Bodies hide it.
    #[must_use]
    pub fn trail(mut self, points: impl IntoIterator<Item = SpaceVector>, ink: Ink) -> Self {
        /// So many widths and opacities; more are not told apart.
        const STEPS: usize = 16;
        let points: Vec<SpaceVector> = points.into_iter().collect();
        let last = points.len().saturating_sub(1);
        for k in 1..=STEPS {
            let (from, to) = (last * (k - 1) / STEPS, last * k / STEPS);
            let part = k as f64 / STEPS as f64;
            if from < to {
                let stroke = Stroke::new(ink, 1.0 + 2.2 * part).faint(0.08 + 0.92 * part);
                self.elements.push(Element::Line(points[from..=to].to_vec(), stroke));
            }
        }
        self
    }

    /// Adds the trail of the last `past` up to the time `t`, along a path of `(time, place)`, equal
    /// times apart, to the place `now`.
    #[must_use]
    pub fn followed(
        self,
        path: &[(f64, SpaceVector)],
        [t, past]: [f64; 2],
        now: SpaceVector,
        ink: Ink,
    ) -> Self {
        let [from, to] = [t - past, t].map(|t| path.partition_point(|(s, _)| *s < t));
        let been = path.iter().take(to).skip(from).map(|(_, place)| *place);
        self.trail(been.chain([now]), ink)
    }

    /// Adds a line anywhere in space: a rope, an edge, a path. Bodies hide it.
    #[must_use]
    pub fn line(mut self, points: impl IntoIterator<Item = SpaceVector>, ink: Ink) -> Self {
        let points = points.into_iter().collect();
        self.elements.push(Element::Line(points, Stroke::new(ink, 1.2)));
        self
    }

    /// Adds a thin circle about `centre` at right angles to the unit vector `axis`: a rim, an equator.
    #[must_use]
    pub fn circle(self, centre: SpaceVector, axis: SpaceVector, radius: f64, ink: Ink) -> Self {
        let (u, v) = across(axis);
        self.line(circle(centre, u * radius, v * radius), ink)
    }

    /// With what `draw` adds, if it is `shown`.
    #[must_use]
    pub fn only_if(self, shown: bool, draw: impl FnOnce(Self) -> Self) -> Self {
        if shown { draw(self) } else { self }
    }

    /// Adds a dashed line anywhere in space: an axis, a construction line.
    #[must_use]
    pub fn dashed(mut self, points: impl IntoIterator<Item = SpaceVector>, ink: Ink) -> Self {
        let stroke = Stroke { dash: Dash::Dashed, ..Stroke::new(ink, 1.0) };
        self.elements.push(Element::Line(points.into_iter().collect(), stroke));
        self
    }

    /// Adds an arrow with a label at its tip; where a body hides it, it is faint. A force or torque has an open head, the
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
        let thin = matches!(ink, Ink::Body | Ink::Frame | Ink::Ink);
        let stroke = Stroke::new(ink, if thin { 1.4 } else { 2.2 });
        self.elements.push(Element::Arrow(vec![from, to], stroke, 9.0));
        self.text(to, label, ink, side)
    }

    /// Adds a thinner arrow with a label at its tip: a part of another.
    #[must_use]
    pub fn component(
        mut self,
        from: SpaceVector,
        to: SpaceVector,
        ink: Ink,
        label: &str,
        side: Side,
    ) -> Self {
        self.elements.push(Element::Arrow(vec![from, to], Stroke::new(ink, 1.4), 8.0));
        self.text(to, label, ink, side)
    }

    /// Adds a lit arrow with a label at its tip, a body like others: for the vectors that a picture
    /// is about, not for forces, whose heads are open.
    #[must_use]
    pub fn vector(
        mut self,
        from: SpaceVector,
        to: SpaceVector,
        ink: Ink,
        label: &str,
        side: Side,
    ) -> Self {
        self.elements.push(Element::Vector([from, to], ink));
        self.text(to, label, ink, side)
    }

    /// Adds the silhouette of a body that is not there, faint and behind all bodies.
    #[must_use]
    pub fn ghost(mut self, solid: Solid, ink: Ink) -> Self {
        self.elements.push(Element::Ghost(solid, ink));
        self
    }

    /// Adds an arrow along a curve: which way something turns.
    #[must_use]
    pub fn turn(mut self, points: impl IntoIterator<Item = SpaceVector>, ink: Ink) -> Self {
        let points = points.into_iter().collect();
        self.elements.push(Element::Arrow(points, Stroke::new(ink, 1.8), 8.0));
        self
    }

    /// Adds a solid, flat-shaded; of several the nearer hides the farther.
    #[must_use]
    pub fn solid(mut self, solid: Solid, ink: Ink) -> Self {
        self.elements.push(Element::Solid(solid, ink));
        self
    }

    /// Adds a dot; `label` may be empty.
    #[must_use]
    pub fn dot(mut self, at: SpaceVector, ink: Ink, label: &str, side: Side) -> Self {
        self.elements.push(Element::Dot(at, ink, 3.2, false));
        self.text(at, label, ink, side)
    }

    /// Adds a dot on a body or on the sphere, faint where a body hides it or it is on the far side.
    #[must_use]
    pub fn spot(mut self, at: SpaceVector, ink: Ink) -> Self {
        self.elements.push(Element::Spot(at, ink));
        self
    }

    /// Adds a ring; `label` may be empty.
    #[must_use]
    pub fn ring(mut self, at: SpaceVector, ink: Ink, label: &str, side: Side) -> Self {
        self.elements.push(Element::Dot(at, ink, 3.2, true));
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
    /// [`Error::NotFinite`](rotation_dynamics::Error::NotFinite) for NaN and infinities,
    /// [`Error::OutOfRange`](rotation_dynamics::Error::OutOfRange) for a reach that is not
    /// positive or a point far outside the picture, [`crate::Error::Text`] for a bad name or a
    /// missing alternative text.
    pub fn figure(&self) -> Result<Figure> {
        positive("the reach of a view", self.reach)?;
        figure(&self.name, &self.alt, self.size, |canvas| {
            self.furnished().paint_into(canvas, canvas.rect())
        })
    }
}

/// A closed circle about `centre` through `centre + u` and `centre + v`.
pub(super) fn circle(centre: SpaceVector, u: SpaceVector, v: SpaceVector) -> Vec<SpaceVector> {
    super::sketch::arc((0.0, 0.0), 1.0, (0.0, 2.0 * PI))
        .into_iter()
        .map(|(c, s)| centre + u * c + v * s)
        .collect()
}
