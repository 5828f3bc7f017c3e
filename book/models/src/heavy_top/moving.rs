//! A top in space with what moves it: its weight, the torque, the angular momentum; at one
//! moment, and moving.

use super::falling::Falling;
use super::{Motion, direction};
use kit::Result;
use kit::draw::{Axis, Curve, Ink, Panel, Side, Solid, View};
use kit::{MovingPicture, sampled, times};
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::math::{acos, atan2, hypot, sincos};
use std::sync::Arc;

const UP: SpaceVector = SpaceVector::new(0.0, 0.0, 1.0);
/// Lengths of the longest arrows of L and of the angular velocity, of the torque on a level axis,
/// and of dL.
const MOMENTUM: f64 = 1.15;
const VELOCITY: f64 = 0.8;
const TORQUE: f64 = 0.62;
const CHANGE: f64 = 0.36;

/// A motion as its picture needs it.
pub(super) struct Drawn {
    /// How far it is shown.
    pub(super) end: f64,
    /// The times of the stills.
    pub(super) stills: [f64; 3],
    /// What the clock shows at a time, and in words.
    pub(super) clock: fn(f64, f64) -> [String; 2],
    /// The other unit of time in that of the motion.
    pub(super) unit: f64,
    /// How long the end of the axis is followed back.
    pub(super) past: f64,
    /// m g l in the motion's units, below 0 for a centre of mass on the other side.
    pub(super) weight: f64,
    /// The two tilts between which the axis nods, if it keeps them.
    pub(super) band: Option<[f64; 2]>,
    /// What the body without spin looks like at a time, so long as it falls.
    pub(super) ghost: Box<dyn Fn(f64) -> Option<Solid> + Send + Sync>,
    pub(super) at: At,
}

/// A time in t', and in seconds beside it, if t' has a `unit` in seconds.
fn seconds_beside(t: f64, unit: f64) -> [String; 2] {
    if unit == 0.0 {
        return [format!("$t'=${t:.1}"), format!("t' = {t:.1}")];
    }
    let seconds = t * unit;
    [format!("$t'=${t:.1}, {seconds:.2} s"), format!("t' = {t:.1}, {seconds:.2} s")]
}

/// A time in seconds, and in t' beside it.
pub(super) fn reduced_beside(t: f64, unit: f64) -> [String; 2] {
    let reduced = t / unit;
    [format!("{t:.3} s, $t'=${reduced:.1}"), format!("{t:.3} s, t' = {reduced:.1}")]
}

/// What there is at a time.
type At = Box<dyn Fn(f64) -> Result<Moment> + Send + Sync>;

/// A top at one time.
pub(super) struct Moment {
    pub(crate) pose: Pose,
    pub(super) axis: SpaceVector,
    pub(super) momentum: SpaceVector,
    pub(super) velocity: SpaceVector,
}

impl Drawn {
    /// The moving picture: `body` draws the body and what holds it, with its centre of mass at
    /// `hub` along an axis of length 1, whose end leaves a trail; below, what `panel` makes of the
    /// tilt against time.
    pub(super) fn moving(
        self,
        panel: impl FnOnce(Vec<(f64, f64)>) -> Panel,
        hub: f64,
        body: impl Fn(&Pose) -> View + Send + Sync + 'static,
    ) -> Result<MovingPicture> {
        let moments = sampled(times(0.0, self.end, 600), |t| Ok((t, (self.at)(t)?)))?;
        // A gyroscope whose spin runs against z has L along -z.
        let longest = |of: fn(&Moment) -> SpaceVector| {
            moments.iter().map(|(_, now)| of(now).norm()).fold(0.0, f64::max)
        };
        let scale = MOMENTUM / longest(|now| now.momentum);
        let rates = VELOCITY / longest(|now| now.velocity);
        let tilt = |(t, now): &(f64, Moment)| (*t, acos(now.axis.z().clamp(-1.0, 1.0)));
        let graph = panel(moments.iter().map(tilt).collect()).low();
        let path: Vec<_> = moments.into_iter().map(|(t, now)| (t, now.axis)).collect();
        // In this time a level axis makes dL so long.
        let brief = if self.weight == 0.0 { 0.0 } else { CHANGE / (scale * self.weight.abs()) };
        MovingPicture::above(graph, 0.0..=self.end, self.stills, move |t| {
            let now = (self.at)(t)?;
            let Moment { pose, axis, .. } = now;
            let [clock, when] = (self.clock)(t, self.unit);
            let fallen = (self.ghost)(t);
            let alt = format!(
                "The body at {when}: its axis leans at {:.2} rad and has gone {:.2} rad round the vertical; \
                 solid arrows show L and the angular velocity{}{}{}{}{}; below, the tilt against time",
                pose.theta,
                pose.phi,
                match self.weight {
                    0.0 => "",
                    _ => ", others the weight and its level torque",
                },
                if t >= 0.1 * brief && brief > 0.0 {
                    ", and at the tip of L what the torque adds to it in a short time"
                } else {
                    ""
                },
                if t > 0.0 {
                    "; a fading ribbon shows where the end of the axis has been"
                } else {
                    ""
                },
                if self.band.is_some() {
                    "; a level band lies between the two turning tilts of the axis"
                } else {
                    ""
                },
                if fallen.is_some() && t > 0.0 {
                    "; a pale outline of the same body without spin falls"
                } else {
                    ""
                },
            );
            let view = body(&pose).corner(&clock);
            let view = view.followed(&path, [t, self.past], axis, Ink::Body);
            let view = match fallen {
                Some(fallen) => view.ghost(fallen, Ink::Frame),
                None => view,
            };
            let view = match self.band {
                Some([from, to]) => view.band(from, to),
                None => view,
            };
            let momentum = now.momentum * scale;
            // After the release it grows.
            let grown = if brief > 0.0 { (t / brief).min(1.0) } else { 0.0 };
            let view = pose.with_cause(view, hub, self.weight, momentum, grown);
            let at = axis * hub;
            let scene = view
                .vector(at, at + now.velocity * rates, Ink::Velocity, r"$\Omega$", Side::Right)
                .dot(axis, Ink::Body, "", Side::Right);
            Ok((alt, scene))
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
    /// With its axis along this vector, turned by `zeta` about it.
    pub fn of(axis: SpaceVector, zeta: f64) -> Self {
        let [x, y, z] = axis.to_array();
        Self { theta: atan2(hypot(x, y), z), phi: atan2(x, -y), zeta }
    }

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
    /// with its tip at `momentum`, and what the torque adds to it in a short time, `grown` so far.
    /// `weight`: below 0 for a centre of mass on the other side, 0 for none.
    #[must_use]
    pub fn with_cause(
        &self,
        view: View,
        hub: f64,
        weight: f64,
        momentum: SpaceVector,
        grown: f64,
    ) -> View {
        let origin = SpaceVector::zero();
        let view = view.vector(origin, momentum, Ink::Momentum, "$L$", Side::AboveLeft);
        let sense = if weight == 0.0 { 0.0 } else { 1.0_f64.copysign(weight) };
        let (centre, torque) = (self.axis() * hub, UP.cross(&self.axis()) * sense);
        if torque.norm() < 1e-3 {
            return view;
        }
        let view = view.arrow(centre, centre - UP * 0.55, Ink::Force, "$mg$", Side::Right).arrow(
            origin,
            torque * TORQUE,
            Ink::Force,
            "torque",
            Side::Below,
        );
        let tip = momentum + torque * (CHANGE * grown);
        if grown < 0.1 {
            return view;
        }
        view.vector(momentum, tip, Ink::Momentum, r"$\mathrm{d}L$", Side::Right)
    }
}

impl Motion {
    /// Where it is at time `t`.
    pub(crate) fn pose(&self, t: f64) -> Pose {
        let angles = self.exact.angles(t);
        Pose { theta: angles.theta, phi: angles.phi, zeta: angles.zeta }
    }

    /// The moving picture: `body` draws the body and what holds it, with its centre of mass
    /// at `hub` along an axis of length 1, whose end leaves a trail; below, the tilt
    /// against time. The stills: the start, the first turning back, and two nods later. `ghost`
    /// is the silhouette of the same body that falls because it does not spin, `None` where it
    /// meets what stops it. A motion whose time is t' is shown as that of the body with the moments
    /// i1 and i3 and this m g l: the axis knows only c/a, and at some spin the body has it.
    ///
    /// # Errors
    /// Those of the drawing.
    pub fn moving(
        self,
        hub: f64,
        [i1, i3, weight_moment]: [f64; 3],
        body: impl Fn(&Pose) -> View + Send + Sync + 'static,
        ghost: impl Fn(&Pose) -> Option<Solid> + Send + Sync + 'static,
    ) -> Result<MovingPicture> {
        let (end, period) = (self.shown(), self.exact.nutation_period());
        let stills = if 2.0 * period <= end {
            [0.0, 0.5 * period, 2.0 * period]
        } else {
            [0.0, 0.5 * end, end]
        };
        let fall = Falling::of(&self, |pose| ghost(pose).is_some())?;
        let shared = Arc::new(self);
        let motion = Arc::clone(&shared);
        let in_seconds = shared.in_seconds();
        let unit = (shared.top.c().abs() * i1 / weight_moment).sqrt();
        // The spin of that body over the spin of the motion.
        let faster = if in_seconds { 1.0 } else { shared.top.a() * i1 / i3 };
        let drawn = Drawn {
            end,
            stills,
            clock: if in_seconds { reduced_beside } else { seconds_beside },
            unit: if in_seconds { shared.unit } else { unit },
            past: 3.0 * period,
            weight: shared.exact.body().map_or(shared.top.c(), |body| body.weight() * body.lever()),
            band: Some([shared.exact.theta_min(), shared.exact.theta_max()]),
            ghost: Box::new(move |t| fall.as_ref()?.at(t).and_then(|pose| ghost(&pose))),
            at: Box::new(move |t| {
                let (pose, state) = (motion.pose(t), motion.exact.state(t));
                let [x, y, z] = motion.exact.angular_velocity(t).to_array();
                let rates = BodyVector::new(x, y, faster * z);
                Ok(Moment {
                    pose,
                    axis: state.attitude.axis(),
                    momentum: state.angular_momentum,
                    velocity: state.attitude.to_space(rates),
                })
            }),
        };
        drawn.moving(|tilt| shared.tilts(tilt), hub, body)
    }

    /// The tilt against time.
    fn tilts(&self, tilt: Vec<(f64, f64)>) -> Panel {
        let [(low, high), ..] = self.extents();
        let time = if self.in_seconds() { "$t$ / s" } else { "$t'$" };
        Panel::over_axes(time, Axis::linear(r"tilt $\theta$ / rad").range(low, high))
            .curve(Curve::new(tilt, Ink::Ink))
    }
}
