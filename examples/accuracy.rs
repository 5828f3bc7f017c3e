//! What accuracy costs: every method on seven motions whose end is known.

#[path = "accuracy/block.rs"]
mod block;
#[path = "accuracy/error_control.rs"]
mod error_control;
#[path = "accuracy/figures.rs"]
mod figures;
#[path = "accuracy/honesty.rs"]
#[allow(dead_code, reason = "the tests of the error control ask more of each case than this page")]
mod honesty;
#[path = "accuracy/limits.rs"]
mod limits;
#[path = "accuracy/lines.rs"]
pub mod lines;
#[path = "accuracy/motions.rs"]
pub mod motions;
#[path = "accuracy/rough.rs"]
mod rough;
#[path = "accuracy/tables.rs"]
mod tables;

use kit::prelude::*;
use kit::{Prepared, rounded_up, short};
use lines::Measured;
use rotation_dynamics::accuracy::{Measure, Problem, Solved, Sweep, Variables, WorkPrecision};
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::{Effect, GravityAtLever};
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::{
    Dop853, GaussLegendre, Integrator, Method, Scheme, Splitting, Work,
};
use rotation_dynamics::math::{EPS, exp2};
use rotation_dynamics::scene::Scene;
use rotation_dynamics::{Error, Result};
use std::sync::Arc;

parameters! {
    /// The free body that is raced, and how long.
    pub struct Parameters {
        /// first principal moment of the free body
        i1: number(1.0, "kg m^2", above(0.0));
        /// second principal moment
        i2: number(2.0, "kg m^2", above(0.0));
        /// third principal moment
        i3: number(8.0 / 3.0, "kg m^2", above(0.0));
        /// length of the runs, in periods of the motion
        periods: number(10.0, "-", from_to(1.0, 1000.0).because("more of them take too long: the page on races has more"));
        /// error asked for in the accuracy strip; four of them if none is given
        tolerance: optional("rad", from_to(1e-14, 1.0).because("a double knows no angle better"));
    }
}

impl Parameters {
    fn moments(&self) -> Result<PrincipalMoments> {
        PrincipalMoments::new(self.i1, self.i2, self.i3)
    }

    /// Whether these are the page's own.
    fn are_default(&self) -> bool {
        let default = Self::default();
        [self.i1, self.i2, self.i3, self.periods]
            == [default.i1, default.i2, default.i3, default.periods]
    }
}

/// The errors asked for in tables, in rad.
pub const ASKED: [f64; 4] = [1e-3, 1e-6, 1e-9, 1e-12];

/// Every method on every motion, run once for the report, the figures and the table of runs.
pub fn prepared(p: &Parameters) -> kit::Result<Arc<Vec<Measured>>> {
    static MEASURED: Prepared<[f64; 4], Vec<Measured>> = Prepared::new();
    MEASURED.get(&[p.i1, p.i2, p.i3, p.periods], |_| lines::all(p))
}

// ANCHOR: sweep
/// RK4 on a free body: what a run costs, and how far off it ends.
fn rk4(problem: &Problem<()>) -> Result<WorkPrecision> {
    let steps = (18..=33).map(|k| exp2(0.5 * f64::from(k)).floor());
    let sweep = problem.sweep(Method::Rk4, Variables::Space, steps);
    sweep.curve(Measure::Attitude, Work::torques)
}
// ANCHOR_END: sweep

// ANCHOR: error_control
/// The end of a motion, off by `tolerance` (rad) or less. By stepping, though there may be
/// a closed form: so the closed form can judge.
fn solved<E: Effect>(problem: &Problem<E>, tolerance: f64) -> Result<Solved> {
    let Problem { scene, start, end, .. } = problem;
    scene.solve_by_stepping(start, *end, tolerance)
}
// ANCHOR_END: error_control

/// The accuracy strips of the heavy top.
fn strips(p: &Parameters, report: &mut Report) -> kit::Result<()> {
    let all = prepared(p)?;
    let mut asked = p.tolerance.map_or(ASKED.to_vec(), |one| vec![one]).into_iter();
    asked.try_for_each(|error| all[1].motion.problem.add_strip(report, error))
}

fn report(p: &Parameters) -> kit::Result<Report> {
    let methods = Method::ALL.len();
    let told = "methods on seven motions whose end is known; errors of the attitude in rad";
    let mut report = Report::new("What accuracy costs", format!("{methods} {told}"))?;
    let sections = [
        tables::claims,
        tables::tables,
        error_control::tables,
        limits::limits,
        limits::effects,
        rough::limits,
        strips,
    ];
    sections.iter().try_for_each(|add| add(p, &mut report))?;
    Ok(report)
}

example! {
    accuracy: "What accuracy costs: work against error, method by method";
    report, figures::all, lines::trajectory
}
