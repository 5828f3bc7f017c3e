//! A spin that is braked: the sleeping top that wakes, and what friction costs.

use super::{Body, Parameters, TOP};
use rotation_dynamics::Result;
use rotation_dynamics::frame::SpaceVector;
use rotation_dynamics::integrators::{Dop853, Integrator, Ode, Solution};
use rotation_dynamics::math::{acos, atan2, cos, pow, sin, sincos};
use rotation_dynamics::report::draw::{Axis, Curve, Ink, Panel, Side, Solid, Stack, View};
use rotation_dynamics::report::heavy_top::Newton;
use rotation_dynamics::report::{MovingPicture, sampled, times};

use core::f64::consts::TAU;

// ANCHOR: braked
/// Newton's law in vectors, L and then the axis, with a torque against the spin.
#[derive(Debug, Clone, Copy)]
struct Braked {
    free: Newton,
    /// Along the axis, N m.
    brake: f64,
}

impl Ode<6> for Braked {
    fn derivative(&self, t: f64, state: &[f64; 6]) -> [f64; 6] {
        let mut rates = self.free.derivative(t, state);
        for k in 0..3 {
            rates[k] -= self.brake * state[3 + k];
        }
        rates
    }
}
// ANCHOR_END: braked

/// The same by (2) and (3) of the notes: theta, theta', phi, L_z, L_Z.
struct BrakedAngles(Braked);

impl Ode<5> for BrakedAngles {
    fn derivative(&self, _t: f64, &[theta, nutation, _, spin, vertical]: &[f64; 5]) -> [f64; 5] {
        let (Newton { i1, weight_moment }, brake) = (self.0.free, self.0.brake);
        let (s, c) = sincos(theta);
        let rate = (vertical - spin * c) / (i1 * s * s);
        let pull = weight_moment * s - rate * s * (spin - i1 * rate * c);
        [nutation, pull / i1, rate, -brake, -brake * c]
    }
}

impl Body {
    fn braked(&self, brake: f64) -> Braked {
        let (i1, weight_moment) = (self.moment(), self.weight_moment());
        let free = Newton { i1, weight_moment };
        Braked { free, brake }
    }

    /// L and the axis at the start.
    fn vectors(&self) -> Result<[f64; 6]> {
        let motion = self.motion("")?.exact;
        let (momentum, axis) = (motion.angular_momentum(0.0), motion.axis(0.0));
        let ([a, b, c], [x, y, z]) = (momentum.to_array(), axis.to_array());
        Ok([a, b, c, x, y, z])
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

/// By how much a braked body is ahead after the time of one turn, rad.
pub struct Lead {
    pub in_vectors: f64,
    pub in_angles: f64,
    /// To first order in the torque and at the tilt of the start.
    pub estimated: f64,
}

/// In steady precession, with this torque (N m) against the spin.
pub fn lead(body: &Body, brake: f64) -> Result<Lead> {
    let (rate, momentum) = (body.steady_rate(), body.i3 * body.spin);
    let steady = Body {
        precession: rate,
        ..*body
    };
    let turn = TAU / rate;
    let run = Dop853::new(1e-12)?;
    let (end, _) = run.advance(&body.braked(brake), 0.0, &steady.vectors()?, turn)?;
    let vertical = momentum * cos(body.theta) + body.moment() * rate * pow(sin(body.theta), 2.0);
    let start = [body.theta, 0.0, 0.0, momentum, vertical];
    let (by_angles, _) = run.advance(&BrakedAngles(body.braked(brake)), 0.0, &start, turn)?;
    let faster = rate / (momentum * momentum - body.four_terms()).sqrt();
    Ok(Lead {
        in_vectors: atan2(end[3], -end[4]),
        in_angles: by_angles[2] - TAU,
        estimated: 0.5 * faster * brake * turn * turn,
    })
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
    run: Solution<6>,
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
        let brake = body.i3 * critical * (FROM - TO) / end;
        let start = upright.vectors()?;
        let run = Dop853::new(1e-10)?.solve(&body.braked(brake), 0.0, &start, end, &[])?;
        Ok(Self { body, end, run })
    }

    fn at(&self, t: f64) -> Result<Moment> {
        let [a, b, c, x, y, z] = self.run.at(t)?;
        let (momentum, axis) = (SpaceVector::new(a, b, c), SpaceVector::new(x, y, z));
        let critical = self.body.critical_spin();
        let slope = (FROM - TO) / self.end;
        Ok(Moment {
            momentum: momentum / (self.body.i3 * critical),
            axis: axis / axis.norm(),
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
    let mut bodies = p.bodies().into_iter();
    let asked = bodies.find(|(name, body)| *name == "top" && body.weight_moment() > 0.0);
    let waking = Waking::new(asked.map_or(TOP, |(_, body)| body))?;
    let end = waking.end;
    let moments = sampled(times(0.0, end, 700), |t| Ok((t, waking.at(t)?)))?;
    let path: Vec<_> = moments.iter().map(|(t, m)| (*t, m.axis)).collect();
    let tilts = moments.iter().map(|(t, m)| (*t, m.tilt()));
    let tilts = Panel::new("tilt", "tilt")
        .x(Axis::linear("$t$ / s"))
        .y(Axis::linear("tilt / rad"))
        .curve(Curve::new(tilts, Ink::Body).label_end("$\\theta$"));
    let spins = moments.iter().map(|(t, m)| (*t, m.ratio));
    let spins = Panel::new("spin", "spin")
        .x(Axis::linear("$t$ / s"))
        .y(Axis::linear("spin / critical")
            .range(TO - 0.02, FROM + 0.02)
            .step(0.1))
        .level(1.0, Ink::Frame, "")
        .curve(Curve::new(spins, Ink::Velocity).label_end("$\\omega$"));
    let stills = [0.2, 0.71, 0.81].map(|part| part * end);
    MovingPicture::new(0.0..=end, stills, move |t| {
        let moment = waking.at(t)?;
        let alt = format!(
            "A top on its tip at t = {t:.2} s, at {:.2} of the critical spin: its axis leans at {:.2} rad; \
             arrows show its angular momentum, its weight{}; \
             a line shows where the upper end of the axis has been; below, tilt and spin against time",
            moment.ratio,
            moment.tilt(),
            match moment.torque() {
                Some(_) => ", the torque of the weight and the change that this makes",
                None => ", whose torque is too small to be drawn",
            }
        );
        let been = path
            .iter()
            .take_while(|(s, _)| *s < t)
            .map(|(_, axis)| *axis);
        let been: Vec<_> = been
            .chain([moment.axis])
            .map(|axis| axis * HEIGHT)
            .collect();
        Stack::new("frame", &alt)
            .row_height(84)
            .scene(scene(&moment).line(been, Ink::Body))
            .panel(tilts.clone().now(t))
            .panel(spins.clone().now(t))
            .figure()
    })
}

/// Height of the top and the radius of its belly.
const HEIGHT: f64 = 1.0;
const BELLY: f64 = 0.42;

/// The top with the vectors that move it.
fn scene(moment: &Moment) -> View {
    let (axis, origin) = (moment.axis, SpaceVector::zero());
    // A mark on the shoulder, turned from the side that faces X.
    let x = SpaceVector::new(1.0, 0.0, 0.0);
    let side = x - axis * x.dot(&axis);
    let side = side / side.norm().max(1e-9);
    let (s, c) = sincos(moment.turned);
    let spoke = side * c + axis.cross(&side) * s;
    let mark =
        [(0.625, 0.1), (0.515, 0.97)].map(|(h, r)| axis * (h * HEIGHT) + spoke * (r * BELLY));
    let (centre, momentum) = (axis * 0.44, moment.momentum * 1.25);
    let view = View::new("scene", "scene")
        .around(UP * 0.6, 0.86)
        .size(340, 270)
        .ground(origin, 0.55)
        .dashed([origin, UP * 1.5], Ink::Frame)
        .text(UP * 1.5, "$Z$", Ink::Frame, Side::Right)
        .solid(Solid::top(origin, axis, HEIGHT, BELLY), Ink::Body)
        .line(mark, Ink::Paper)
        .arrow(origin, momentum, Ink::Momentum, "$L$", Side::Left)
        .arrow(centre, centre - UP * 0.4, Ink::Force, "$mg$", Side::Left);
    let Some(torque) = moment.torque() else {
        return view;
    };
    view.arrow(origin, torque, Ink::Force, "torque", Side::Below)
        .arrow(
            momentum,
            momentum + torque * 0.6,
            Ink::Momentum,
            "$\\mathrm{d}L$",
            Side::Right,
        )
}
