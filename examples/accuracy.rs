//! What accuracy costs: every method on five motions whose answer is known.

#[path = "accuracy/dial.rs"]
mod dial;
#[path = "accuracy/drift.rs"]
#[allow(dead_code, reason = "the tests of long runs ask for the free body too")]
mod drift;
#[path = "accuracy/figures.rs"]
mod figures;
#[path = "accuracy/honesty.rs"]
#[allow(
    dead_code,
    reason = "the tests of the dial ask more of each case than this page"
)]
mod honesty;
#[path = "accuracy/limits.rs"]
mod limits;
#[path = "accuracy/long.rs"]
mod long;
#[path = "accuracy/measured.rs"]
pub mod measured;
#[path = "accuracy/methods.rs"]
pub mod methods;
#[path = "accuracy/problems.rs"]
pub mod problems;
#[path = "accuracy/strip.rs"]
mod strip;
#[path = "accuracy/tables.rs"]
mod tables;

use problems::{Free, Kind, Problem};
use rotation_dynamics::Result;
use rotation_dynamics::accuracy::{Errors, Measure, Solved, Sweep, WorkPrecision};
use rotation_dynamics::body::State;
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::{Integrator, Rk4, Work};
use rotation_dynamics::math::exp2;
use rotation_dynamics::report::{Claim, Example, Oracle, Report};

rotation_dynamics::parameters! {
    /// The free body that is raced, and how long.
    pub struct Parameters {
        /// first principal moment of the free body
        i1: number(1.0, "kg m^2", above(0.0));
        /// second principal moment
        i2: number(2.0, "kg m^2", above(0.0));
        /// third principal moment
        i3: number(8.0 / 3.0, "kg m^2", above(0.0));
        /// length of the runs, in periods of the motion
        periods: number(10.0, "-", any());
        /// error asked for in the accuracy strip
        tolerance: optional("rad", any());
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

// ANCHOR: sweep
/// RK4 on a tumbling body: what a run costs, and how far off it ends.
fn rk4(scene: &Free, start: &State, exact: &State, end: f64) -> Result<WorkPrecision> {
    let steps = (18..=33).map(|k| exp2(0.5 * f64::from(k)));
    let sweep = Sweep::over(steps, |steps| {
        let (reached, work) = Rk4::new(steps as u64)?.advance(scene, 0.0, start, end)?;
        Ok((Errors::between(scene, &reached, exact), work))
    });
    sweep.curve(Measure::Attitude, Work::torques)
}
// ANCHOR_END: sweep

// ANCHOR: dial
/// The end of a motion, off by `tolerance` or less. By stepping, though there is
/// a closed form: so the closed form can judge.
fn solved(problem: &Problem, tolerance: f64) -> Result<Solved> {
    let (start, end) = (&problem.start, problem.end);
    match &problem.kind {
        Kind::Free { scene, .. } => scene.solve_by_stepping(start, end, tolerance),
        Kind::Top { scene, .. } => scene.solve_by_stepping(start, end, tolerance),
    }
}
// ANCHOR_END: dial

/// Adds what RK4 pays for a digit.
fn add_rk4(report: &mut Report, free: &Problem) -> Result<()> {
    let Kind::Free { scene, .. } = &free.kind else {
        return Ok(());
    };
    let curve = rk4(scene, &free.start, &free.answer, free.end)?;
    let Some(price) = curve.price_of_a_digit(1e-10, 1e-6) else {
        return Ok(());
    };
    report.add_claim(
        Claim::new(
            "rk4_order",
            "order of RK4 on the free body, from the slope of error against work",
            price.order,
            "-",
            0.1,
            Oracle::new("its order", 4.0),
        )?
        .judged_within(0.05),
    )
}

fn report(p: &Parameters) -> Result<Report> {
    strip::check(p.tolerance)?;
    let all = measured::all(p)?;
    let mut report = Report::new(
        "What accuracy costs",
        format!(
            "{} methods on five motions with known answers; errors of the attitude in rad",
            methods::METHODS.len()
        ),
    )?;
    if p.are_default() {
        add_rk4(&mut report, &all[0].problem)?;
    }
    tables::add(&mut report, &all, p.moments()?, p.are_default())?;
    long::add(&mut report)?;
    dial::add(&mut report, &all)?;
    limits::add(&mut report)?;
    strip::add(&mut report, &all[1], p.tolerance)?;
    Ok(report)
}

/// The example: name, flags and functions.
pub const EXAMPLE: Example<Parameters> = Example {
    stem: "accuracy",
    about: "What accuracy costs: work against error, method by method",
    report,
    figures: figures::all,
    trajectory: measured::trajectory,
    moving_picture: None,
};

fn main() -> std::process::ExitCode {
    EXAMPLE.main()
}
