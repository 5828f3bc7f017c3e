//! A spin that is braked: the sleeping top that wakes, and what friction costs.

use super::{Body, Parameters, TOP, WHEEL, driven};
use kit::draw::{Curve, Ink, Panel, Side, Solid, View};
use kit::{MovingPicture, Result, sampled, times};
use models::heavy_top::{Pose, Steady};
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::RigidBody;
use rotation_dynamics::effects::{CoulombBearing, GravityAtLever};
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::scene::{components, state};
use rotation_dynamics::integrators::{Dop853, Solution, after, ode, size_or};
use rotation_dynamics::math::{acos, cos, pow, sin, sincos};
use rotation_dynamics::scene::Scene;

use core::f64::consts::TAU;

impl Body {
    /// As a rigid body that turns about its fixed point, and its weight.
    pub fn parts(&self) -> rotation_dynamics::Result<(RigidBody, GravityAtLever)> {
        let body = RigidBody::new(PrincipalMoments::symmetric(self.moment(), self.i3)?);
        let gravity = GravityAtLever::new(self.mass * self.gravity, self.length)?;
        Ok((body, gravity))
    }

    /// In slow steady precession at its tilt.
    pub fn steady(&self) -> rotation_dynamics::Result<Steady> {
        let (body, gravity) = self.parts()?;
        Steady::new(body, gravity, self.theta, self.spin)
    }

    /// The slow root of I1' cos(theta) p^2 - L_z p + m g l = 0, rad/s.
    pub fn steady_rate(&self) -> f64 {
        let momentum = self.i3 * self.spin;
        let root = (momentum * momentum - self.four_terms()).sqrt();
        2.0 * self.weight_moment() / (momentum + root)
    }

    /// 4 I1' m g l cos(theta): L_z^2 must be greater for a steady precession.
    fn four_terms(&self) -> f64 {
        4.0 * self.moment() * self.weight_moment() * cos(self.theta)
    }
}

/// By how much a braked body is ahead in steady precession, after the time that a turn takes
/// without the brake, rad: by (2) and (3) of the notes, in theta, theta', phi, L_z, L_Z.
/// `torque` is the brake's along the axis (N m), of the spin.
pub fn lead_by_angles(body: &Body, torque: impl Fn(f64) -> f64) -> Result<f64> {
    let (i1, weight_moment, rate) = (body.moment(), body.weight_moment(), body.steady_rate());
    let law = ode(move |_, &[theta, nutation, _, momentum, vertical]: &[f64; 5]| {
        let ((s, c), brake) = (sincos(theta), torque(momentum / body.i3));
        let rate = (vertical - momentum * c) / (i1 * s * s);
        let pull = weight_moment * s - rate * s * (momentum - i1 * rate * c);
        [nutation, pull / i1, rate, brake, brake * c]
    })
    .scaled(size_or([1.0; 5]));
    let momentum = body.i3 * body.spin;
    let vertical = momentum * cos(body.theta) + i1 * rate * pow(sin(body.theta), 2.0);
    let start = [body.theta, 0.0, 0.0, momentum, vertical];
    let [_, _, azimuth, ..] = after(TAU / rate, &law, &start, 1e-12)?;
    Ok(azimuth - TAU)
}

/// From what to what part of the critical spin the top is braked, and how long that
/// takes in units of sqrt(I1'/m g l).
const FROM: f64 = 1.05;
const TO: f64 = 0.85;
const UNITS: f64 = 50.0;

/// A top set upright with a touch, while a brake takes its spin through the critical one.
struct Waking {
    body: Body,
    end: f64,
    run: Solution<7>,
}

/// One moment of it.
struct Moment {
    momentum: SpaceVector,
    axis: SpaceVector,
    /// Angular velocity along the axis over the critical one.
    ratio: f64,
    /// How far the mark on the body has turned.
    turned: f64,
}

impl Waking {
    fn new(body: Body) -> Result<Self> {
        let unit = (body.moment() / body.weight_moment()).sqrt();
        let (end, critical) = (UNITS * unit, body.critical_spin());
        let upright = Body {
            theta: 0.0,
            spin: FROM * critical,
            precession: 0.0,
            nutation: 0.004 / unit,
            ..body
        };
        let (rigid, gravity) = body.parts()?;
        let touch = BodyVector::new(upright.nutation, 0.0, upright.spin);
        let start = rigid.state(Attitude::IDENTITY, touch)?;
        let torque = body.i3 * critical * (FROM - TO) / end;
        let brake = CoulombBearing::new(torque, &rigid, &start, 0.0)?;
        let scene = Scene::new(rigid).with(gravity).with(brake);
        let run = Dop853::new(1e-10)?.solve(&scene, 0.0, &components(&start), end, &[])?;
        Ok(Self { body, end, run })
    }

    fn at(&self, t: f64) -> Result<Moment> {
        let state = state(&self.run.at(t)?)?;
        let (momentum, axis) = (state.angular_momentum, state.attitude.axis());
        let critical = self.body.critical_spin();
        let slope = (FROM - TO) / self.end;
        Ok(Moment {
            momentum: momentum / (self.body.i3 * critical),
            axis,
            ratio: momentum.dot(&axis) / (self.body.i3 * critical),
            turned: critical * t * (FROM - 0.5 * slope * t),
        })
    }
}

impl Moment {
    /// The torque of the weight to scale, if it is long enough to be drawn.
    fn torque(&self) -> Option<SpaceVector> {
        let torque = UP.cross(&self.axis) * 0.95;
        (torque.norm() >= 0.05).then_some(torque)
    }

    fn tilt(&self) -> f64 {
        acos(self.axis.z().clamp(-1.0, 1.0))
    }
}

const UP: SpaceVector = SpaceVector::new(0.0, 0.0, 1.0);

/// The top that is asked for, or the page's, as its spin goes through the critical one.
pub fn moving_picture(p: &Parameters) -> Result<MovingPicture> {
    p.motions()?;
    if driven::is_asked_for(p) {
        let body = driven::body(p)?;
        return if p.body == "wheel" {
            body.moving(LEVER, hanging)
        } else {
            body.moving(CENTRE, leaning)
        };
    }
    let mut bodies = p.bodies().into_iter();
    let asked = bodies.find(|(name, body)| *name == "top" && body.weight_moment() > 0.0);
    let waking = Waking::new(asked.map_or(TOP, |(_, body)| body))?;
    let end = waking.end;
    let moments = sampled(times(0.0, end, 700), |t| Ok((t, waking.at(t)?)))?;
    let path: Vec<_> = moments.iter().map(|(t, m)| (*t, m.axis)).collect();
    let tilts = moments.iter().map(|(t, m)| (*t, m.tilt()));
    // The brake's torque is constant.
    let critical = end * (FROM - 1.0) / (FROM - TO);
    let graph = Panel::over_axes("$t$ / s", r"tilt $\theta$ / rad")
        .upright(critical, Ink::Frame, "critical spin")
        .curve(Curve::new(tilts, Ink::Body))
        .low();
    let stills = [0.2, 0.71, 0.81].map(|part| part * end);
    MovingPicture::above(graph, 0.0..=end, stills, move |t| {
        let moment = waking.at(t)?;
        let alt = format!(
            "A top on its tip at t = {t:.2} s, at {:.2} of the critical spin: its axis leans at {:.2} rad; \
             arrows show its angular momentum, its weight{}; a fading ribbon shows where the upper end of \
             the axis has been; below, the tilt against time, with a line where the spin is critical",
            moment.ratio,
            moment.tilt(),
            match moment.torque() {
                Some(_) => ", the torque of the weight and the change that this makes",
                None => ", whose torque is too small to be drawn",
            }
        );
        let now = moment.axis;
        let view = scene(&moment).followed(&path, [t, 0.3 * end], now, Ink::Body);
        Ok((alt, view.corner(&format!("spin / critical $=$ {:.2}", moment.ratio))))
    })
}

/// From the tip of a top of height 1 to its centre of mass.
const CENTRE: f64 = 1.0 / 1.7;

/// A top that leans.
fn leaning(pose: &Pose) -> View {
    let view = View::of(UP * 0.45, 1.1).size(340, 280).table(SpaceVector::zero(), 1.0);
    marked(view, pose.axis(), pose.spoke(0.0))
}

/// With the top, a mark on its shoulder along the spoke.
fn marked(view: View, axis: SpaceVector, spoke: SpaceVector) -> View {
    let mark = [(1.19, 0.3), (1.09, 0.72)].map(|(h, r)| (axis * h + spoke * r) * CENTRE);
    view.solid(Solid::top(axis * CENTRE, axis, CENTRE, 0.0), Ink::Body).line(mark, Ink::Paper)
}

/// From the rope to the hub of the wheel; its radius is to scale.
const LEVER: f64 = 0.33;

/// The wheel hung by one end of its axle.
fn hanging(pose: &Pose) -> View {
    let (axis, origin) = (pose.axis(), SpaceVector::zero());
    let (hub, radius) = (axis * LEVER, LEVER * 0.33 / WHEEL.length);
    let spokes = (0..8).map(|i| {
        let out = pose.spoke(TAU * f64::from(i) / 8.0);
        Solid::rod(hub, hub + out * radius, 0.01)
    });
    let rim = Solid::ring(hub, axis, radius, 0.03);
    let wheel = spokes.fold(rim.with(Solid::rod(origin, axis, 0.02)), Solid::with);
    View::new("scene", "scene")
        .around(UP * 0.2, 1.25)
        .size(340, 320)
        .line([origin, UP], Ink::Ink)
        .solid(wheel, Ink::Body)
}

/// The top with the vectors that move it.
fn scene(moment: &Moment) -> View {
    let (axis, origin) = (moment.axis, SpaceVector::zero());
    // A mark on the shoulder, turned from the side that faces X.
    let (x, (s, c)) = (SpaceVector::new(1.0, 0.0, 0.0), sincos(moment.turned));
    let side = x - axis * x.dot(&axis);
    let side = side / side.norm().max(1e-9);
    let spoke = side * c + axis.cross(&side) * s;
    let (centre, momentum) = (axis * CENTRE, moment.momentum * 1.25);
    let view = View::of(UP * 0.58, 0.84)
        .size(340, 270)
        .table(origin, 0.9)
        .dashed([origin, UP * 1.45], Ink::Frame);
    // At the tip the arrow of L is thicker than the body, and is left out.
    let view = marked(view, axis, spoke)
        .vector(momentum * 0.2, momentum, Ink::Momentum, "$L$", Side::Left)
        .arrow_from_within(centre, centre - UP * 0.4, Ink::Force, "$mg$", Side::Left);
    let Some(torque) = moment.torque() else {
        return view;
    };
    view.arrow(origin, torque, Ink::Force, "torque", Side::Below).vector(
        momentum,
        momentum + torque * 0.6,
        Ink::Momentum,
        "$\\mathrm{d}L$",
        Side::Right,
    )
}
