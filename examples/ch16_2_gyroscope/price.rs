//! What accuracy costs here: five methods against the closed form.

use super::motions::Motion;
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::GravityAtLever;
use rotation_dynamics::frame::BodyVector;
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::splitting::Scheme;
use rotation_dynamics::integrators::{Dop853, Integrator, Rk4, Splitting, Work};
use rotation_dynamics::math::{exp2, sincos};
use rotation_dynamics::report::draw::{Axis, Curve, Ink, Panel};
use rotation_dynamics::report::{Figure, Price, Report};
use rotation_dynamics::scene::Scene;
use rotation_dynamics::{Error, Result};

/// A heavy symmetric body: the effects of a scene are part of its type.
type Top = Scene<((), GravityAtLever)>;

// ANCHOR: scene
/// The motion as a scene in units of t': I1 = 1, I3 = a, m g l = c, L_z = sqrt(a).
fn scene(motion: &Motion) -> Result<(Top, State)> {
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

const METHODS: [&str; 5] = [
    "RK4",
    "Strang splitting",
    "SRKN 6b splitting",
    "SRKN 14a splitting",
    "DOP853",
];

/// One run of a method, coarser or finer by `level`: its error and its work.
fn run(
    method: &str,
    level: u32,
    (scene, start): &(Top, State),
    motion: &Motion,
) -> Result<(f64, Work)> {
    let end = motion.end / motion.unit;
    // Steps and tolerances grow finer by factors of 2^(1/4) in work and of 2 in error.
    let steps = (8.0 * exp2(0.25 * f64::from(level))) as u64;
    let by = |scheme: Scheme| Splitting::new(scheme, steps)?.advance(scene, 0.0, start, end);
    let (state, work) = match method {
        "RK4" => Rk4::new(steps)?.advance(scene, 0.0, start, end)?,
        "Strang splitting" => by(Scheme::STRANG)?,
        "SRKN 6b splitting" => by(Scheme::SRKN6)?,
        "SRKN 14a splitting" => by(Scheme::SRKN14)?,
        _ => Dop853::new((0.1 * exp2(-f64::from(level))).max(1e-15))?
            .advance(scene, 0.0, start, end)?,
    };
    Ok((
        motion.exact.attitude(motion.end).angle_to(&state.attitude),
        work,
    ))
}

/// The last level worth trying: beyond it a run costs more than half a million torques.
fn finest(method: &str) -> u32 {
    match method {
        "DOP853" => 46,
        "SRKN 14a splitting" => 48,
        "SRKN 6b splitting" => 52,
        _ => 56,
    }
}

/// The least work with which a method delivers the error asked for, if it does.
fn least(
    method: &'static str,
    asked: f64,
    problem: &(Top, State),
    motion: &Motion,
) -> Result<Option<(f64, Work)>> {
    for level in 0..=finest(method) {
        let (error, work) = run(method, level, problem, motion)?;
        if error <= asked {
            return Ok(Some((error, work)));
        }
    }
    Ok(None)
}

/// Adds the accuracy strip for the motion that nods (or the only one).
pub fn add(report: &mut Report, motions: &[Motion], tolerance: f64) -> Result<()> {
    if !(1e-13..=1.0).contains(&tolerance) {
        return Err(Error::OutOfRange {
            name: "tolerance",
            value: tolerance,
            allowed: "from 1e-13 to 1 rad: less is lost in round-off",
        });
    }
    let motion = motions.get(1).unwrap_or(&motions[0]);
    if motion.top.c() == 0.0 || !motion.clear_of_poles() {
        return Ok(());
    }
    let problem = scene(motion)?;
    let mut price = |method: &str, asked: f64, delivered: f64, work: String| {
        report.add_price(Price {
            method: method.into(),
            requested: Some(asked),
            delivered,
            work,
        });
    };
    for method in METHODS {
        if let Some((error, work)) = least(method, tolerance, &problem, motion)? {
            price(method, tolerance, error, work.to_string());
        }
    }
    for asked in [1e-3, 1e-6, 1e-12] {
        let mut best: Option<(&str, f64, Work)> = None;
        for method in METHODS {
            if let Some((error, work)) = least(method, asked, &problem, motion)?
                && best.is_none_or(|(_, _, b)| work.torques() < b.torques())
            {
                best = Some((method, error, work));
            }
        }
        if let Some((method, error, work)) = best {
            price(
                &format!("cheapest: {method}"),
                asked,
                error,
                work.to_string(),
            );
        }
    }
    Ok(())
}

/// Error of the attitude against torques, for every method.
pub fn figure(motion: &Motion) -> Result<Figure> {
    let problem = scene(motion)?;
    let inks = [
        Ink::Velocity,
        Ink::Energy,
        Ink::Momentum,
        Ink::Body,
        Ink::Ink,
    ];
    let names = ["RK4", "order 2", "order 4", "order 6", "DOP853"];
    let mut panel = Panel::new(
        "work",
        "Error of the attitude against torques evaluated, on logarithmic axes: the splittings of order 4 and 6 \
         and DOP853 reach 1e-13, RK4 and the splitting of order 2 need far more work",
    )
    .size(340, 300)
    .x(Axis::log("torques evaluated"))
    .y(Axis::log("error of the attitude / rad").range(1e-15, 1.0));
    for ((method, name), ink) in METHODS.into_iter().zip(names).zip(inks) {
        let mut points = Vec::new();
        for level in (0..=finest(method)).step_by(2) {
            let (error, work) = run(method, level, &problem, motion)?;
            if error < 0.5 && error > 1e-15 {
                points.push((work.torques() as f64, error));
            }
        }
        panel = panel.curve(Curve::new(points, ink).label(name));
    }
    panel.figure()
}
