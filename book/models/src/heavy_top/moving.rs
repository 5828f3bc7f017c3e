//! A top in space with what moves it: its weight, the torque, the angular momentum; at one
//! moment, and moving.

use super::{Motion, direction};
use kit::Result;
use kit::draw::{Axis, Curve, Ink, Panel, Side, View};
use kit::{MovingPicture, sampled, times};
use rotation_dynamics::frame::SpaceVector;
use rotation_dynamics::math::{acos, sincos};
use std::sync::Arc;

const UP: SpaceVector = SpaceVector::new(0.0, 0.0, 1.0);
/// Length of the longest arrow of L, of the torque on a level axis, and of dL over the torque.
const MOMENTUM: f64 = 1.3;
const TORQUE: f64 = 0.62;
const CHANGE: f64 = 0.6;

/// A motion as its picture needs it.
pub(super) struct Drawn {
    /// How far it is shown.
    pub(super) end: f64,
    /// The times of the stills.
    pub(super) stills: [f64; 3],
    /// Whether times are in seconds, not in t'.
    pub(super) seconds: bool,
    /// 1, -1 for a centre of mass on the other side, 0 without weight.
    pub(crate) sense: f64,
    pub(super) at: At,
}

/// What there is at a time.
type At = Box<dyn Fn(f64) -> Result<Moment> + Send + Sync>;

/// A top at one time.
pub(super) struct Moment {
    pub(crate) pose: Pose,
    pub(super) axis: SpaceVector,
    pub(super) momentum: SpaceVector,
}

impl Drawn {
    /// The moving picture: `body` draws the body and what holds it, with its centre of mass at
    /// `hub` along an axis of length 1, whose end draws on a sphere; below, what `panel` makes
    /// of the tilt against time.
    pub(super) fn moving(
        self,
        panel: impl FnOnce(Vec<(f64, f64)>) -> Panel,
        hub: f64,
        body: impl Fn(&Pose) -> View + Send + Sync + 'static,
    ) -> Result<MovingPicture> {
        let moments = sampled(times(0.0, self.end, 600), |t| Ok((t, (self.at)(t)?)))?;
        // A gyroscope whose spin runs against z has L along -z.
        let longest = moments.iter().map(|(_, now)| now.momentum.norm());
        let scale = MOMENTUM / longest.fold(0.0, f64::max);
        let tilt = |(t, now): &(f64, Moment)| (*t, acos(now.axis.z().clamp(-1.0, 1.0)));
        let panel = panel(moments.iter().map(tilt).collect());
        let path: Vec<_> = moments.into_iter().map(|(t, now)| (t, now.axis)).collect();
        MovingPicture::above(panel, 0.0..=self.end, self.stills, move |t| {
            let Moment { pose, axis, momentum } = (self.at)(t)?;
            let time = if self.seconds { format!("t = {t:.3} s") } else { format!("t' = {t:.2}") };
            let alt = format!(
                "The body at {time}: its axis leans at {:.2} rad and has gone {:.2} rad round the vertical; \
                 arrows show L, the level torque of the weight, and at the tip of L its change, along the torque; \
                 the end of the axis has drawn its path on a sphere; below, the tilt against time",
                pose.theta, pose.phi
            );
            let drawn = path.iter().take_while(|(s, _)| *s < t);
            let drawn = drawn.map(|(_, axis)| *axis).chain([axis]);
            let view = body(&pose).sphere().trace(drawn, Ink::Body);
            let view = pose.with_cause(view, hub, self.sense, momentum * scale);
            Ok((alt, view.dot(axis, Ink::Body, "", Side::Right)))
        })
    }
}

/// Where a top is, its fixed point at the origin: tilt, precession and spin (rad).
#[derive(Debug, Clone, Copy)]
pub struct Pose {
    /// Tilt of the axis from the vertical.
    pub theta: f64,
    /// Angle of the line of nodes from X.
    pub phi: f64,
    /// Angle of a mark on the body from the line of nodes.
    pub zeta: f64,
}

impl Pose {
    /// The unit vector along the axis.
    pub fn axis(&self) -> SpaceVector {
        direction(self.theta, self.phi)
    }

    /// The unit vector along the line of nodes.
    pub fn node(&self) -> SpaceVector {
        let (s, c) = sincos(self.phi);
        SpaceVector::new(c, s, 0.0)
    }

    /// The unit vector at right angles to the axis, `turn` (rad) beyond the mark.
    pub fn spoke(&self, turn: f64) -> SpaceVector {
        let (s, c) = sincos(self.zeta + turn);
        self.node() * c + self.axis().cross(&self.node()) * s
    }

    /// The tip of an arrow of L that lies along the axis.
    pub fn along(&self) -> SpaceVector {
        self.axis() * MOMENTUM
    }

    /// Adds the weight, which acts at `hub` along the axis, its torque about the origin, L
    /// with its tip at `momentum`, and the change that the torque makes of it in a short
    /// time. `sense`: 1, -1 for a centre of mass on the other side, 0 without weight.
    #[must_use]
    pub fn with_cause(&self, view: View, hub: f64, sense: f64, momentum: SpaceVector) -> View {
        let origin = SpaceVector::zero();
        let view = view.arrow(origin, momentum, Ink::Momentum, "$L$", Side::AboveLeft);
        let torque = UP.cross(&self.axis()) * (TORQUE * sense);
        if torque.norm() < 1e-3 {
            return view;
        }
        let (centre, tip) = (self.axis() * hub, momentum + torque * CHANGE);
        view.arrow(centre, centre - UP * (0.55 * sense.abs()), Ink::Force, "$mg$", Side::Right)
            .arrow(origin, torque, Ink::Force, "torque", Side::Below)
            .arrow(momentum, tip, Ink::Momentum, "$\\mathrm{d}L$", Side::Right)
    }
}

impl Motion {
    /// Where it is at time `t`.
    pub(crate) fn pose(&self, t: f64) -> Pose {
        let angles = self.exact.angles(t);
        Pose { theta: angles.theta, phi: angles.phi, zeta: angles.zeta }
    }

    /// The moving picture: `body` draws the body and what holds it, with its centre of mass
    /// at `hub` along an axis of length 1, whose end draws on a sphere; below, the tilt
    /// against time. The stills: the start, the first turning back, and two nods later.
    ///
    /// # Errors
    /// Those of the drawing.
    pub fn moving(
        self,
        hub: f64,
        body: impl Fn(&Pose) -> View + Send + Sync + 'static,
    ) -> Result<MovingPicture> {
        let (end, period) = (self.shown(), self.exact.nutation_period());
        let stills = if 2.0 * period <= end {
            [0.0, 0.5 * period, 2.0 * period]
        } else {
            [0.0, 0.5 * end, end]
        };
        let c = self.top.c();
        let shared = Arc::new(self);
        let motion = Arc::clone(&shared);
        let drawn = Drawn {
            end,
            stills,
            seconds: shared.in_seconds(),
            sense: if c == 0.0 { 0.0 } else { c.signum() },
            at: Box::new(move |t| {
                Ok(Moment {
                    pose: motion.pose(t),
                    axis: motion.exact.axis(t),
                    momentum: motion.exact.angular_momentum(t),
                })
            }),
        };
        drawn.moving(|tilt| shared.tilts(tilt), hub, body)
    }

    /// The tilt against time, with the tilt at which the precession reverses, if it does.
    fn tilts(&self, tilt: Vec<(f64, f64)>) -> Panel {
        let [(low, high), ..] = self.extents();
        let time = if self.in_seconds() { "$t$ / s" } else { "$t'$" };
        let panel = Panel::new("tilt", "tilt").x(Axis::linear(time));
        let axis = Axis::linear("tilt $\\theta$ / rad");
        let (b, end) = (self.top.b(), self.shown());
        if b.abs() < 1.0 && (low..=high).contains(&acos(b)) {
            let low = low.min(acos(b) - 0.22 * (high - low));
            panel
                .y(axis.range(low, high))
                .level(acos(b), Ink::Frame, "")
                .note(end, acos(b), Ink::Frame, "$\\cos\\theta=b$", Side::BelowLeft)
                .curve(Curve::new(tilt, Ink::Ink))
        } else {
            panel.y(axis.range(low, high)).curve(Curve::new(tilt, Ink::Ink))
        }
    }
}
