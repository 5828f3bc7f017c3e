//! A drawing that moves.

use super::Figure;
use super::draw::{Panel, Scene, Stack, Turn, plain, turned};
use crate::error::{Result, finite};
use core::ops::RangeInclusive;
use rotation_dynamics::Error;

/// A drawing at any time of a motion, in the language of the figures.
///
/// What all frames share (a closed form, a solved trajectory) is prepared once and kept
/// in the function that draws, so that a frame costs milliseconds. Some frames are locked
/// like every figure: the stills.
///
/// ```
/// use kit::MovingPicture;
/// use kit::draw::{Ink, Side, Sketch};
/// let hand = |t: f64| {
///     Sketch::new("clock", "the hand of a clock turns once an hour")
///         .window((-1.0, 1.0), (-1.0, 1.0))
///         .arrow((0.0, 0.0), (t.sin(), t.cos()), Ink::Body, "", Side::Right)
///         .figure()
/// };
/// let picture = MovingPicture::new(0.0..=6.28, [0.0, 1.57, 3.14], hand)?;
/// assert_eq!(picture.stills()?[2].name, "frame_3");
/// assert!(picture.frame(7.0).is_err());
/// # Ok::<(), kit::Error>(())
/// ```
pub struct MovingPicture {
    span: RangeInclusive<f64>,
    stills: Vec<f64>,
    time: String,
    draw: Box<Draw>,
}

/// The drawing at a time.
type Draw = dyn Fn(f64) -> Result<Figure> + Send + Sync;

/// A scene at a time, with what is to be seen in words.
type Seen = dyn Fn(f64) -> Result<(String, Scene)> + Send + Sync;

impl MovingPicture {
    /// What `draw` draws at a time of `span`; `stills` are the times of the frames that
    /// stand on paper.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for a span that is not finite, [`Error::OutsideRun`] for a still outside it.
    pub fn new(
        span: RangeInclusive<f64>,
        stills: impl Into<Vec<f64>>,
        draw: impl Fn(f64) -> Result<Figure> + Send + Sync + 'static,
    ) -> Result<Self> {
        Self::boxed(span, stills.into(), Box::new(draw))
    }

    fn boxed(span: RangeInclusive<f64>, stills: Vec<f64>, draw: Box<Draw>) -> Result<Self> {
        finite("start of a moving picture", *span.start())?;
        finite("end of a moving picture", *span.end())?;
        let picture = Self { span, stills, time: "$t$ / s".into(), draw };
        for &t in &picture.stills {
            picture.check(t)?;
        }
        Ok(picture)
    }

    /// The usual picture: `scene` is what it looks like at a time, with what is to be seen
    /// in words; below it stands `graph`, with a mark at that time.
    ///
    /// ```
    /// use rotation_dynamics::math::cos;
    /// use kit::draw::{Curve, Ink, Panel, Sketch};
    /// use kit::{MovingPicture, times};
    /// let graph = Panel::over_axes("$t$ / s", "$x$ / m");
    /// let graph = graph.curve(Curve::of(times(0.0, 6.0, 60), cos, Ink::Body));
    /// let picture = MovingPicture::above(graph, 0.0..=6.0, [0.0, 3.0], |t| {
    ///     let ball = Sketch::within((-1.3, 1.3), (-0.2, 0.6)).disc((cos(t), 0.2), 0.2, Ink::Body, 0.3);
    ///     Ok((format!("a ball after {t} s of swinging; below it its place against time"), ball))
    /// })?;
    /// assert_eq!(picture.stills()?.len(), 2);
    /// # Ok::<(), kit::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`MovingPicture::new`].
    pub fn above<S: Into<Scene>>(
        graph: Panel,
        span: RangeInclusive<f64>,
        stills: impl Into<Vec<f64>>,
        scene: impl Fn(f64) -> Result<(String, S)> + Send + Sync + 'static,
    ) -> Result<Self> {
        let seen = move |t| scene(t).map(|(alt, scene)| (alt, scene.into()));
        Self::above_boxed(graph, span, stills.into(), Box::new(seen))
    }

    fn above_boxed(
        graph: Panel,
        span: RangeInclusive<f64>,
        stills: Vec<f64>,
        scene: Box<Seen>,
    ) -> Result<Self> {
        let (time, graph) = (graph.horizontal().to_owned(), graph.keeping_labels());
        let picture = Self::new(span, stills, move |t| {
            let (alt, scene) = scene(t)?;
            Stack::frame(&alt, scene, &graph, t)
        })?;
        Ok(picture.timed(&time))
    }

    /// Names what runs from frame to frame, as on an axis, `"days of the year"`. Unless it is
    /// named it is the horizontal axis of the graph below, else `"$t$ / s"`.
    #[must_use]
    pub fn timed(mut self, label: &str) -> Self {
        self.time = label.into();
        self
    }

    /// What runs from frame to frame, in plain letters, `"t / s"`.
    ///
    /// ```
    /// use kit::MovingPicture;
    /// use kit::draw::Sketch;
    /// let picture = MovingPicture::new(0.0..=1.0, [0.0], |_| Sketch::new("rest", "rest").figure())?;
    /// assert_eq!(picture.time(), "t / s");
    /// assert_eq!(picture.timed(r"$\theta_{0}$ / rad").time(), "θ0 / rad");
    /// # Ok::<(), kit::Error>(())
    /// ```
    pub fn time(&self) -> String {
        plain(&self.time)
    }

    fn check(&self, t: f64) -> rotation_dynamics::Result<()> {
        if self.span.contains(&t) {
            return Ok(());
        }
        Err(Error::OutsideRun { t, start: *self.span.start(), end: *self.span.end() })
    }

    /// From when to when it moves.
    pub fn span(&self) -> RangeInclusive<f64> {
        self.span.clone()
    }

    /// The drawing at `t`.
    ///
    /// # Errors
    /// [`Error::OutsideRun`] for a time outside the span; those of the drawing.
    pub fn frame(&self, t: f64) -> Result<Figure> {
        self.check(t)?;
        (self.draw)(t)
    }

    /// The drawing at `t` for a reader who turned the scene, and whether there is one to turn:
    /// a mechanism is flat.
    ///
    /// ```
    /// use rotation_dynamics::frame::SpaceVector;
    /// use kit::MovingPicture;
    /// use kit::draw::{Ink, Side, Turn, View};
    /// let picture = MovingPicture::new(0.0..=1.0, [0.0], |t| {
    ///     View::new("axis", "an axis that leans over more and more")
    ///         .arrow(SpaceVector::zero(), SpaceVector::new(t, 0.0, 1.0), Ink::Body, "", Side::Right)
    ///         .figure()
    /// })?;
    /// let turn = Turn { about: 0.5, up: -0.1 };
    /// let (turned, turns) = picture.seen(1.0, turn)?;
    /// assert!(turns && turned != picture.frame(1.0)?);
    /// assert_eq!(picture.seen(1.0, Turn::default())?.0, picture.frame(1.0)?);
    /// # Ok::<(), kit::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`MovingPicture::frame`]; [`Error::NotFinite`] for a turn that is not finite.
    pub fn seen(&self, t: f64, turn: Turn) -> Result<(Figure, bool)> {
        finite("turn of a camera", turn.about)?;
        finite("turn of a camera", turn.up)?;
        let (figure, turns) = turned(turn, || self.frame(t));
        Ok((figure?, turns))
    }

    /// The times of the frames that stand on paper.
    pub fn still_times(&self) -> &[f64] {
        &self.stills
    }

    /// The frames that stand on paper, named `frame_1`, `frame_2`, …
    ///
    /// # Errors
    /// Those of the drawing.
    pub fn stills(&self) -> Result<Vec<Figure>> {
        (1..)
            .zip(&self.stills)
            .map(|(n, &t)| {
                let name = format!("frame_{n}");
                Ok(Figure { name, ..self.frame(t)? })
            })
            .collect()
    }
}
