//! What accuracy costs here: the dial, and what it chose from, against the closed form.

use super::motions::Motion;
use rotation_dynamics::Result;
use rotation_dynamics::accuracy::{Problem, Variables};
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::GravityAtLever;
use rotation_dynamics::frame::BodyVector;
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::Method;
use rotation_dynamics::math::{exp2, sincos};
use rotation_dynamics::report::draw::{Axis, Curve, Ink, Panel};
use rotation_dynamics::report::{Figure, Report};
use rotation_dynamics::scene::Scene;

/// Gravity, and no other effect.
type Gravity = ((), GravityAtLever);

// ANCHOR: scene
/// The motion as a scene in units of t': I1 = 1, I3 = a, m g l = c, L_z = sqrt(a).
fn scene(motion: &Motion) -> Result<(Scene<Gravity>, State)> {
    let (a, b, c) = (motion.top.a(), motion.top.b(), motion.top.c());
    let body = RigidBody::new(PrincipalMoments::symmetric(1.0, a)?);
    let scene = Scene::new(body).with(GravityAtLever::new(c.abs(), c.signum())?);
    let [theta, nutation, ..] = motion.start();
    let (s, u) = sincos(theta);
    // phi' sin(theta) along y, and 1/sqrt(a) along the axis; zeta = 0 at the start.
    let omega = BodyVector::new(nutation, a.sqrt() * (b - u) / s, 1.0 / a.sqrt());
    let start = body.state(motion.exact.attitude(0.0), omega)?;
    Ok((scene, start))
}
// ANCHOR_END: scene

/// The motion as the methods are given it, and its exact answer.
fn problem(motion: &Motion) -> Result<Problem<Gravity>> {
    let (scene, start) = scene(motion)?;
    let exact = motion.exact.clone();
    let end = State::new(
        exact.attitude(motion.end),
        exact.angular_momentum(motion.end),
    )?;
    let unit = motion.unit;
    let problem = Problem::new(scene, start, motion.end / unit, end);
    Ok(problem.in_closed_form(move |t| exact.attitude(t * unit)))
}

// ANCHOR: dial
/// Adds the accuracy strip for the motion that nods (or the only one).
pub fn add(report: &mut Report, motions: &[Motion], tolerance: f64) -> Result<()> {
    let motion = motions.get(1).unwrap_or(&motions[0]);
    if motion.top.c() == 0.0 || !motion.clear_of_poles() {
        return Ok(());
    }
    report.strip(&problem(motion)?, &[tolerance, 1e-3, 1e-6, 1e-12])
}
// ANCHOR_END: dial

/// The methods that are drawn, and their lines.
const DRAWN: [(Method, &str, Ink); 5] = [
    (Method::Rk4, "RK4", Ink::Velocity),
    (Method::Strang, "order 2", Ink::Energy),
    (Method::Srkn6, "order 4", Ink::Momentum),
    (Method::Srkn14, "order 6", Ink::Body),
    (Method::Dop853, "DOP853", Ink::Ink),
];

/// Coarser and finer by factors of 2^(1/2) in the steps, of 4 in the tolerance.
fn settings(method: Method) -> Vec<f64> {
    let by = |factor: f64, half: i32| (0..=half).map(move |k| exp2(factor * f64::from(k)));
    match method {
        Method::Dop853 => by(-2.0, 23).map(|x| (0.1 * x).max(1e-15)).collect(),
        Method::Srkn14 => by(0.5, 24).map(|x| (8.0 * x).floor()).collect(),
        Method::Srkn6 => by(0.5, 26).map(|x| (8.0 * x).floor()).collect(),
        _ => by(0.5, 28).map(|x| (8.0 * x).floor()).collect(),
    }
}

/// Error of the attitude against torques, for every method.
pub fn figure(motion: &Motion) -> Result<Figure> {
    let problem = problem(motion)?;
    let mut panel = Panel::new(
        "work",
        "Error of the attitude against torques evaluated, on logarithmic axes: the splittings of order 4 and 6 \
         and DOP853 reach 1e-13, RK4 and the splitting of order 2 need far more work",
    )
    .size(340, 300)
    .x(Axis::log("torques evaluated"))
    .y(Axis::log("error of the attitude / rad").range(1e-15, 1.0));
    for (method, name, ink) in DRAWN {
        let sweep = problem.sweep(method, Variables::Space, settings(method));
        let points = (sweep.runs().iter())
            .map(|run| (run.work.torques() as f64, run.errors.attitude))
            .filter(|(_, error)| *error < 0.5 && *error > 1e-15);
        panel = panel.curve(Curve::new(points, ink).label(name));
    }
    panel.figure()
}
