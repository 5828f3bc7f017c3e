//! What accuracy costs here: the dial, and what it chose from, against the closed form.

use super::motions::Motion;
use rotation_dynamics::accuracy::Solved;
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::GravityAtLever;
use rotation_dynamics::exact::heavy_top::HeavyTop;
use rotation_dynamics::frame::BodyVector;
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::splitting::Scheme;
use rotation_dynamics::integrators::{
    Dop853, GaussLegendre, Integrator, Rk4, SpinFree, Splitting, Work,
};
use rotation_dynamics::math::{exp2, sincos};
use rotation_dynamics::report::draw::{Axis, Curve, Ink, Panel};
use rotation_dynamics::report::{ClosedForm, Computation, Figure, Price, Report};
use rotation_dynamics::scene::Scene;
use rotation_dynamics::{Error, Result};
use std::sync::Arc;

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

/// Too long a step to be drawn among the others, and too good to be left out.
const GAUSS: &str = "Gauss-Legendre 16";

/// The motion as the methods are given it, and its exact answer.
struct Problem {
    scene: Top,
    start: State,
    exact: HeavyTop,
    /// The end, and how much of it is one unit of t'.
    end: f64,
    unit: f64,
}

impl Problem {
    fn new(motion: &Motion) -> Result<Self> {
        let (scene, start) = scene(motion)?;
        Ok(Self {
            scene,
            start,
            exact: motion.exact.clone(),
            end: motion.end,
            unit: motion.unit,
        })
    }

    /// One run of a method, coarser or finer by `level`.
    fn run(&self, method: &str, level: u32) -> Result<(State, Work)> {
        let (scene, start, end) = (&self.scene, &self.start, self.end / self.unit);
        // Steps and tolerances grow finer by factors of 2^(1/4) in work and of 2 in error.
        let steps = (8.0 * exp2(0.25 * f64::from(level))) as u64;
        let by = |scheme: Scheme| Splitting::new(scheme, steps)?.advance(scene, 0.0, start, end);
        match method {
            "RK4" => Rk4::new(steps)?.advance(scene, 0.0, start, end),
            "Strang splitting" => by(Scheme::STRANG),
            "SRKN 6b splitting" => by(Scheme::SRKN6),
            "SRKN 14a splitting" => by(Scheme::SRKN14),
            GAUSS => {
                let steps = (6.0 * exp2(f64::from(level) / 16.0)) as u64;
                GaussLegendre::new(steps)?.advance(&SpinFree::new(scene)?, 0.0, start, end)
            }
            _ => Dop853::new((0.1 * exp2(-f64::from(level))).max(1e-15))?
                .advance(scene, 0.0, start, end),
        }
    }

    /// The angle between the attitude reached and the exact one.
    fn error(&self, reached: &State) -> f64 {
        self.exact.attitude(self.end).angle_to(&reached.attitude)
    }

    /// The least work with which a method delivers the error asked for, if it does.
    fn least(self: &Arc<Self>, method: &'static str, asked: f64) -> Result<Option<Run>> {
        for level in 0..=finest(method) {
            let (state, work) = match self.run(method, level) {
                // Steps far too long for a fast motion overflow, or their stages have no
                // solution: not delivered.
                Err(Error::DerivativeNotFinite { .. } | Error::NoConvergence { .. }) => continue,
                run => run?,
            };
            let error = self.error(&state);
            if error <= asked {
                let (problem, judge) = (Arc::clone(self), Arc::clone(self));
                let again = Computation::new(
                    move || problem.run(method, level),
                    move |(state, _)| Ok(judge.error(state)),
                );
                return Ok(Some(Run {
                    method,
                    error,
                    work,
                    again,
                }));
            }
        }
        Ok(None)
    }
}

/// A run that delivered what was asked for.
struct Run {
    method: &'static str,
    error: f64,
    work: Work,
    again: Computation,
}

/// The last level worth trying: beyond it a run costs more than half a million torques.
fn finest(method: &str) -> u32 {
    match method {
        "DOP853" => 46,
        "SRKN 14a splitting" => 48,
        "SRKN 6b splitting" => 52,
        GAUSS => 96,
        _ => 56,
    }
}

// ANCHOR: dial
/// Adds the accuracy strip for the motion that nods (or the only one): the dial, then
/// the least work of each method, known with hindsight.
pub fn add(report: &mut Report, motions: &[Motion], tolerance: f64) -> Result<()> {
    let motion = motions.get(1).unwrap_or(&motions[0]);
    if motion.top.c() == 0.0 || !motion.clear_of_poles() {
        return Ok(());
    }
    let problem = Arc::new(Problem::new(motion)?);
    // A closed form where the scene has one; without it, everything is stepped.
    add_dial(report, &problem, "dial: ", tolerance, |p, error| {
        p.scene.solve(&p.start, p.end / p.unit, error)
    })?;
    let others = [1e-3, 1e-6, 1e-12]
        .into_iter()
        .filter(|error| *error != tolerance);
    for error in [tolerance].into_iter().chain(others) {
        add_dial(report, &problem, "dial, stepping: ", error, |p, error| {
            p.scene.solve_by_stepping(&p.start, p.end / p.unit, error)
        })?;
    }
    // ANCHOR_END: dial
    for method in METHODS.into_iter().chain([GAUSS]) {
        if let Some(run) = problem.least(method, tolerance)? {
            report.add_price(Price {
                method: format!("least: {}", run.method),
                requested: Some(tolerance),
                delivered: run.error,
                work: run.work.to_string(),
                again: Some(run.again),
            });
        }
    }
    report.set_closed_form(ClosedForm::new(move |part| {
        Ok(problem.exact.attitude(part * problem.end))
    }));
    Ok(())
}

/// Adds what the dial delivers, or that it refuses and the least it could.
fn add_dial(
    report: &mut Report,
    problem: &Arc<Problem>,
    label: &str,
    requested: f64,
    solve: fn(&Problem, f64) -> Result<Solved>,
) -> Result<()> {
    let (method, delivered, work, again) = match solve(problem, requested) {
        Ok(solved) => {
            let (run, judge) = (Arc::clone(problem), Arc::clone(problem));
            let again = Computation::new(
                move || solve(&run, requested),
                move |solved| Ok(judge.error(&solved.state)),
            );
            let error = problem.error(&solved.state);
            (solved.method, error, solved.work.to_string(), Some(again))
        }
        Err(Error::BeyondCondition { attainable, .. }) if label != "dial: " => {
            ("-", attainable, "refused".into(), None)
        }
        Err(other) => return Err(other),
    };
    report.add_price(Price {
        method: format!("{label}{method}"),
        requested: Some(requested),
        delivered,
        work,
        again,
    });
    Ok(())
}

/// Error of the attitude against torques, for every method.
pub fn figure(motion: &Motion) -> Result<Figure> {
    let problem = Problem::new(motion)?;
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
            let (state, work) = problem.run(method, level)?;
            let error = problem.error(&state);
            if error < 0.5 && error > 1e-15 {
                points.push((work.torques() as f64, error));
            }
        }
        panel = panel.curve(Curve::new(points, ink).label(name));
    }
    panel.figure()
}
