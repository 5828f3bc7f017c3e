//! A top on which more acts than its weight: stepped, and told by two routes.

use super::Pose;
use super::moving::{Drawn, Moment, reduced_beside};
use core::f64::consts::TAU;
use kit::Result;
use kit::draw::{Axis, Camera, Curve, Ink, Panel, Side, Stack, View};
use kit::exactly;
use kit::{CardLine, Claim, EffectLine, Figure, Lab, MovingPicture, Report, Trajectory};
use kit::{claim, times};
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::{
    Conserved, CoulombBearing, DiscDrag, Effect, Feature, GravityAtLever, Properties,
};
use rotation_dynamics::error::not_negative;
use rotation_dynamics::frame::SpaceVector;
use rotation_dynamics::integrators::scene::{components, state};
use rotation_dynamics::integrators::{Dop853, Ode, Solution, size_or};
use rotation_dynamics::math::{atan2, hypot};
use rotation_dynamics::scene::Scene;

const ROUTE: &str = "DOP853 on dL/dt, de/dt";

/// What acts on a top beside its weight; what is `None` is left out.
#[derive(Debug, Clone, Copy, Default)]
pub struct Added {
    /// The bearing about which the axis nods: torque over dtheta/dt (N m s).
    pub nodes: Option<f64>,
    /// The air about it, as about a disc.
    pub air: Option<DiscDrag>,
    /// Dry friction against the spin: its torque (N m).
    pub dry: Option<f64>,
}

impl Added {
    /// With the air about a disc of this radius (m) that spins at this rate (rad/s), if a density
    /// (kg/m^3) is given: what is thinner is as viscous, so that nu goes with 1/density.
    ///
    /// # Errors
    /// Those of [`DiscDrag::new`].
    pub fn in_air(self, density: Option<f64>, radius: f64, spin: f64) -> Result<Self> {
        let about = |density| {
            let viscosity = DiscDrag::AIR_VISCOSITY * (DiscDrag::AIR_DENSITY / density);
            DiscDrag::new(radius, density, viscosity, spin)
        };
        let air = density.map(about).transpose()?;
        Ok(Self { air, ..self })
    }
}

/// The bearing of the line of nodes: -friction dtheta/dt.
#[derive(Debug, Clone, Copy)]
struct Nodes {
    friction: f64,
}

impl Effect for Nodes {
    /// It acts along the line of nodes: neither about the vertical nor about the axis.
    const PROPERTIES: Properties = Properties {
        on_time: false,
        conserved: Conserved {
            energy: false,
            momentum: [false, false, true],
            axial_momentum: true,
        },
        ..Properties::ANYTHING
    };

    fn name(&self) -> &'static str {
        "bearing of the line of nodes"
    }

    fn torque(&self, _t: f64, body: &RigidBody, state: &State) -> SpaceVector {
        let omega = state.attitude.to_space(body.angular_velocity(state));
        let nodes = UP.cross(&state.attitude.axis());
        along(nodes, -self.friction * omega.dot(&nodes))
    }

    /// No nod is faster than |L|/I1; at a turning point the torque itself is 0.
    fn torque_scale(&self, _t: f64, body: &RigidBody, state: &State) -> f64 {
        self.friction * state.angular_momentum.norm() / body.moments().i1()
    }

    fn narrowest(&self) -> Option<Feature> {
        Some(Feature::WIDE)
    }
}

const UP: SpaceVector = SpaceVector::new(0.0, 0.0, 1.0);

/// What has the scalar product `product` with this vector, and its direction; 0 at the poles,
/// where there is no line of nodes.
fn along(vector: SpaceVector, product: f64) -> SpaceVector {
    let square = vector.dot(&vector);
    if square > 0.0 { vector * (product / square) } else { SpaceVector::zero() }
}

type Weight = ((), Option<GravityAtLever>);
type Acting = (((Weight, Option<Nodes>), Option<DiscDrag>), Option<CoulombBearing>);

/// A symmetric body about a fixed point under its weight and what is added, followed for a time.
///
/// The first route is the library's `solve`, on attitudes; the second the law of the angular
/// momentum L and of the axis e alone, dL/dt = torque, de/dt = L x e/I1, with the torque said
/// again, of L and e.
#[derive(Debug, Clone)]
pub struct Stepped {
    plain: Scene<Weight>,
    scene: Scene<Acting>,
    start: State,
    end: f64,
    added: Added,
    /// When dry friction has stopped the spin (s).
    stop: f64,
}

/// L on X, Y, Z, the axis e, and the work done by what is no weight (J).
impl Ode<7> for Stepped {
    fn derivative(&self, t: f64, &[lx, ly, lz, ex, ey, ez, _]: &[f64; 7]) -> [f64; 7] {
        let ([i1, i3], w) = (self.moments(), self.weight());
        let (momentum, axis) = (SpaceVector::new(lx, ly, lz), SpaceVector::new(ex, ey, ez));
        let (spin, nodes) = (momentum.dot(&axis) / i3, UP.cross(&axis));
        let air = self.added.air.map_or(0.0, |air| air.axial_torque(spin));
        let dry = self.added.dry.filter(|_| t < self.stop).unwrap_or(0.0);
        let nods = -self.added.nodes.unwrap_or(0.0) * momentum.dot(&nodes) / i1;
        let added = axis * (air - dry * spin.signum()) + along(nodes, nods);
        let rates = momentum / i1 + axis * (spin * (1.0 - i3 / i1));
        let [tx, ty, tz] = added.to_array();
        let [dx, dy, dz] = (momentum.cross(&axis) / i1).to_array();
        [tx - w * ey, ty + w * ex, tz, dx, dy, dz, added.dot(&rates)]
    }

    fn scale(&self, y: &[f64; 7]) -> [f64; 7] {
        size_or([1.0; 7])(y)
    }
}

impl Stepped {
    /// This body from this start to `end` (s).
    ///
    /// # Errors
    /// A strength that is negative or not finite, a body that is not symmetric.
    pub fn new(
        body: RigidBody,
        gravity: Option<GravityAtLever>,
        added: Added,
        start: State,
        end: f64,
    ) -> Result<Self> {
        let plain = Scene::new(body).with(gravity);
        let dry = |torque| CoulombBearing::new(torque, &body, &start, 0.0);
        let dry = added.dry.map(dry).transpose()?;
        let nodes = |friction| not_negative("friction", friction);
        let nodes = added.nodes.map(nodes).transpose()?;
        let nodes = nodes.map(|friction| Nodes { friction });
        Ok(Self {
            plain,
            scene: plain.with(nodes).with(added.air).with(dry),
            start,
            end,
            added,
            stop: body.angular_momentum(&start).z().abs() / added.dry.unwrap_or(0.0),
        })
    }

    /// I1 and I3.
    fn moments(&self) -> [f64; 2] {
        let moments = self.scene.body().moments();
        [moments.i1(), moments.i3()]
    }

    /// m g l (N m).
    fn weight(&self) -> f64 {
        let ((), gravity) = self.plain.effects();
        gravity.map_or(0.0, |gravity| gravity.moment())
    }

    /// The unit of t' at the start, sqrt(I1 I3)/L_z (s).
    fn unit(&self) -> f64 {
        let [i1, i3] = self.moments();
        (i1 * i3).sqrt() / self.scene.body().angular_momentum(&self.start).z().abs()
    }

    /// By the second route, from the start to the end.
    fn vectors(&self) -> rotation_dynamics::Result<Solution<7>> {
        let [lx, ly, lz] = self.start.angular_momentum.to_array();
        let [ex, ey, ez] = self.start.attitude.axis().to_array();
        let start = [lx, ly, lz, ex, ey, ez, 0.0];
        Dop853::new(1e-13)?.solve(self, 0.0, &start, self.end, &[])
    }

    /// A line of the card for each effect that is added, called so: what it does to the axis
    /// beside the weight, and whether the tolerance (rad) needs it.
    ///
    /// # Errors
    /// As [`NeglectedEffects::line`](rotation_dynamics::accuracy::NeglectedEffects::line).
    pub(crate) fn ledger(
        &self,
        tolerance: f64,
        [nodes, air, dry]: [&str; 3],
    ) -> Result<Vec<EffectLine>> {
        let candidates =
            (self.plain.neglected_effects(&self.start, self.end, tolerance)?).of_axis();
        let ([i1, _], body) = (self.moments(), self.scene.body());
        let momentum = body.angular_momentum(&self.start).z().abs();
        let of = format!("rad in {} s, of the axis", exactly(self.end));
        let braked = format!("torque x {} s / L_z", exactly(self.end));
        let ((((_, bearing), drag), dry_bearing), mut lines) = (self.scene.effects(), Vec::new());
        if let Some(bearing) = bearing {
            // The nods have died by exp(-number).
            let (number, formula) = (0.5 * bearing.friction * self.end / i1, "c t / 2 I1");
            lines.push(candidates.line(nodes, formula, number, bearing, &of)?);
        }
        if let Some(drag) = drag {
            let spin = body.angular_velocity(&self.start).z();
            let number = drag.axial_torque(spin).abs() * self.end / momentum;
            lines.push(candidates.line(air, &braked, number, drag, &of)?);
        }
        if let (Some(bearing), Some(torque)) = (dry_bearing, self.added.dry) {
            let number = torque * self.end / momentum;
            lines.push(candidates.line(dry, &braked, number, bearing, &of)?);
        }
        Ok(lines.into_iter().map(EffectLine::included).collect())
    }

    /// What the end of the run is, with an attitude off by `tolerance` (rad) or less, against
    /// the second route.
    ///
    /// # Errors
    /// Those of [`Scene::solve`] and of the run.
    pub fn claims(&self, tolerance: f64) -> Result<Vec<Claim>> {
        let solved = self.scene.solve(&self.start, self.end, tolerance)?;
        let (body, end) = (self.scene.body(), &solved.state);
        let [lx, ly, lz, x, y, z, work] = *self.vectors()?.end_state();
        let (axis, along) = (end.attitude.axis(), body.angular_velocity(end).z());
        let [tilt, other] = [axis.to_array(), [x, y, z]].map(|[x, y, z]| atan2(hypot(x, y), z));
        let azimuth = |[x, y]: [f64; 2]| atan2(x, -y);
        let (phi, beyond) =
            (azimuth([axis.x(), axis.y()]), azimuth([x, y]) - azimuth([axis.x(), axis.y()]));
        let beyond = beyond - TAU * (beyond / TAU).round();
        let (start, i3) = (&self.start, body.moments().i3());
        let momentum = start.angular_momentum.norm();
        // The route's own error is that of its steps, over many turns.
        let angle = tolerance + 1e-9;
        let part = angle + 2.0 * (solved.momentum_estimate + solved.rates_estimate);
        let lost = self.scene.energy(start) - self.scene.energy(end);
        let size = momentum * body.angular_velocity(start).norm() + 2.0 * self.weight().abs();
        let spin = (lx * x + ly * y + lz * z) / i3;
        let mut claims = vec![
            (claim("theta_end", "tilt at the end", tilt, "rad").within(angle))
                .against(ROUTE, other),
            (claim("spin_end", "angular velocity along the axis at the end", along, "rad/s"))
                .within(part * momentum / i3)
                .against(ROUTE, spin),
            (claim("energy_lost", "energy that it has lost at the end", lost, "J"))
                .within(part * size)
                .against("power, summed along the second route", -work),
        ];
        // Near the vertical it is not determined so well.
        let level = hypot(axis.x(), axis.y());
        if level > 0.02 {
            let meaning = "phi at the end, less whole turns";
            let phi_end = claim("phi_end", meaning, phi, "rad").within(angle / level);
            claims.insert(1, phi_end.against(ROUTE, phi + beyond));
        }
        Ok(claims)
    }

    /// A report under this title about `what` is followed: where it ends, and what each effect has
    /// done, the bearing, the air and the dry friction called so.
    ///
    /// # Errors
    /// Those of [`Stepped::claims`] and its ledger.
    pub fn report(
        &self,
        [title, what]: [&str; 2],
        tolerance: f64,
        names: [&str; 3],
    ) -> Result<Report> {
        let description = format!(
            "{what} with what --with puts in, for a second: stepped; nods, turning points and the \
             strip, which need the closed form, are left out"
        );
        let mut report = Report::new(title, description)?;
        report.add(self.claims(tolerance)?)?;
        report.add(self.ledger(tolerance, names)?)?;
        report.add(Lab::against_error_control(self.scene, self.start, self.end))?;
        Ok(report)
    }

    /// The motion at every time, as a drawing needs it.
    fn motion(&self) -> rotation_dynamics::Result<Solution<7>> {
        let start = components(&self.start);
        Dop853::new(1e-10)?.solve(&self.scene, 0.0, &start, self.end, &[])
    }

    /// Tilt, azimuth (rad, without jumps) and angular velocity along the axis (rad/s) at 200
    /// times of the run.
    ///
    /// # Errors
    /// Those of the run.
    pub fn trajectory(&self) -> Result<Trajectory> {
        let motion = self.motion()?;
        let columns =
            ["t [s]", "theta [rad]", "phi [rad]", "spin [rad/s]", "axis X", "axis Y", "axis Z"];
        let (body, mut before) = (self.scene.body(), 0.0);
        Trajectory::sampled(columns, times(0.0, self.end, 200), |t| {
            let now = state(&motion.at(t)?)?;
            let axis = now.attitude.axis();
            let ([x, y, z], spin) = (axis.to_array(), body.angular_velocity(&now).z());
            let phi = atan2(x, -y);
            before = phi + TAU * ((before - phi) / TAU).round();
            Ok([t, atan2(hypot(x, y), z), before, spin, x, y, z])
        })
    }

    /// Tilt, azimuth and spin against time, the second route as dots, and the path of the axis.
    ///
    /// # Errors
    /// Those of the run and of the drawing.
    pub fn figures(&self, camera: Camera) -> Result<Vec<Figure>> {
        let (trajectory, other, i3) =
            (self.trajectory()?, self.vectors()?, self.scene.body().moments().i3());
        let mut dots: [Vec<(f64, f64)>; 3] = Default::default();
        for row in trajectory.rows().iter().skip(4).step_by(8) {
            let [lx, ly, lz, x, y, z, _] = other.at(row[0])?;
            let phi = atan2(x, -y);
            let phi = phi + TAU * ((row[2] - phi) / TAU).round();
            let spin = (lx * x + ly * y + lz * z) / i3;
            for (dots, value) in dots.iter_mut().zip([atan2(hypot(x, y), z), phi, spin]) {
                dots.push((row[0], value));
            }
        }
        let (first, last) = (&trajectory.rows()[0], &trajectory.rows()[200]);
        let alt = format!(
            "Tilt, precession and spin against time: the tilt goes from {:.2} to {:.2} rad, phi to {:.2} rad, \
             the spin from {:.0} to {:.0} rad/s; on the lines dots by the second route",
            first[1], last[1], last[2], first[3], last[3],
        );
        let labels = ["$\\theta$ / rad", "$\\phi$ / rad", "spin / (rad/s)"];
        let mut stack = Stack::new("motion_angles", &alt).row_height(100);
        for (n, (dots, label)) in dots.into_iter().zip(labels).enumerate() {
            let line: Vec<_> = trajectory.rows().iter().map(|row| (row[0], row[n + 1])).collect();
            let (low, high) = room(&line);
            let panel = Panel::new("row", "row")
                .x(Axis::linear("$t$ / s"))
                .y(Axis::linear(label).range(low, high))
                .curve(Curve::new(line, Ink::Ink))
                .curve(Curve::new(dots, Ink::Body).dots());
            stack = stack.panel(panel);
        }
        let motion = self.motion()?;
        let path = times(0.0, self.end, 2000).map(|t| direction_of(&motion, t));
        let path: Vec<SpaceVector> = path.collect::<Result<_>>()?;
        let start = self.start.attitude.axis();
        let trace = View::new(
            "motion_trace",
            &format!(
                "The path of the end of the axis on a sphere, from {:.2} to {:.2} rad from the pole",
                first[1], last[1]
            ),
        )
        .camera(camera)
        .sphere();
        // An axis that stands still goes in no direction.
        let goes = (path[919] - path[900]).norm() > 1e-4;
        let trace = if goes { trace.turn(path[900..920].to_vec(), Ink::Body) } else { trace };
        let trace = trace
            .trace(path, Ink::Body)
            .arrow(SpaceVector::zero(), start, Ink::Body, "", Side::Left)
            .dot(start, Ink::Body, "start", Side::Left)
            .triad();
        Ok(vec![stack.figure()?, trace.figure()?])
    }

    /// The moving picture, as that of a motion in closed form
    /// ([`Motion::moving`](super::Motion::moving)).
    ///
    /// # Errors
    /// Those of the run and of the drawing.
    pub fn moving(
        &self,
        hub: f64,
        body: impl Fn(&Pose) -> View + Send + Sync + 'static,
    ) -> Result<MovingPicture> {
        let (motion, end, rigid) = (self.motion()?, self.end, *self.scene.body());
        let drawn = Drawn {
            end,
            stills: [0.0, 0.5 * end, end],
            clock: reduced_beside,
            unit: self.unit(),
            past: 0.4 * end,
            weight: self.weight(),
            band: None,
            ghost: Box::new(|_| None),
            at: Box::new(move |t| {
                let now = state(&motion.at(t)?)?;
                let angles = now.attitude.euler_angles();
                let pose = Pose { theta: angles.theta, phi: angles.phi, zeta: angles.zeta };
                let velocity = now.attitude.to_space(rigid.angular_velocity(&now));
                let (axis, momentum) = (now.attitude.axis(), now.angular_momentum);
                Ok(Moment { pose, axis, momentum, velocity })
            }),
        };
        let panel = |tilt: Vec<(f64, f64)>| {
            let (low, high) = room(&tilt);
            Panel::new("tilt", "tilt")
                .x(Axis::linear("$t$ / s"))
                .y(Axis::linear("tilt $\\theta$ / rad").range(low, high))
                .curve(Curve::new(tilt, Ink::Ink))
        };
        drawn.moving(panel, hub, body)
    }
}

/// From where to where a line is drawn: what stands still is no zigzag of rounding.
fn room(line: &[(f64, f64)]) -> (f64, f64) {
    let values = || line.iter().map(|(_, value)| *value);
    let (low, high) =
        (values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max));
    let margin = (0.08 * (high - low)).max(1e-3 * high.abs()).max(1e-6);
    (low - margin, high + margin)
}

/// The direction of the axis at a time of a run.
fn direction_of(motion: &Solution<7>, t: f64) -> Result<SpaceVector> {
    Ok(state(&motion.at(t)?)?.attitude.axis())
}
