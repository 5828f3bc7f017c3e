//! The accuracy strip: the heavy top by the dial and by six methods.

use super::dial::short_name;
use super::measured::Measured;
use super::problems::Kind;
use super::tables::ASKED;
use rotation_dynamics::report::{ClosedForm, Computation, Price, Report};
use rotation_dynamics::{Error, Result};
use std::sync::Arc;

/// The methods that are timed.
const SHOWN: [&str; 6] = ["rk4", "srkn6", "srkn14", "kl17", "dop853", "gauss"];

/// Refuses a tolerance that no method delivers.
pub fn check(tolerance: Option<f64>) -> Result<()> {
    if let Some(value) = tolerance.filter(|t| !(1e-14..=1.0).contains(t)) {
        return Err(Error::OutOfRange {
            name: "tolerance",
            value,
            allowed: "from 1e-14 to 1 rad: less is lost in round-off",
        });
    }
    Ok(())
}

/// Adds what the dial takes, all its runs counted, unless it refuses.
fn add_dial(report: &mut Report, top: &Measured, tolerance: f64) -> Result<()> {
    let solved = match super::solved(&top.problem, tolerance) {
        Err(Error::BeyondCondition { .. }) => return Ok(()),
        solved => solved?,
    };
    let (problem, judge) = (Arc::clone(&top.problem), Arc::clone(&top.problem));
    report.add_price(Price {
        method: format!("dial: {}", short_name(solved.method)),
        requested: Some(tolerance),
        delivered: top.problem.errors(&solved.state).attitude,
        work: solved.work.to_string(),
        again: Some(Computation::new(
            move || super::solved(&problem, tolerance),
            move |solved| Ok(judge.errors(&solved.state).attitude),
        )),
    });
    Ok(())
}

/// Adds the dial's line and those of six methods for each error asked for: one, or four.
pub fn add(report: &mut Report, top: &Measured, tolerance: Option<f64>) -> Result<()> {
    let asked = tolerance.map_or(ASKED.to_vec(), |one| vec![one]);
    for error in asked {
        add_dial(report, top, error)?;
        for line in top.lines.iter().filter(|l| SHOWN.contains(&l.method.key)) {
            let Some(run) = line.least(error) else {
                continue;
            };
            let (method, setting) = (line.method, run.setting);
            let (problem, judge) = (Arc::clone(&top.problem), Arc::clone(&top.problem));
            let again = Computation::new(
                move || {
                    let run = method.run(&problem, setting);
                    run.unwrap_or(Ok((problem.start, Default::default())))
                },
                move |(reached, _)| Ok(judge.errors(reached).attitude),
            );
            report.add_price(Price {
                method: method.name.into(),
                requested: Some(error),
                delivered: run.errors.attitude,
                work: run.work.to_string(),
                again: Some(again),
            });
        }
    }
    let problem = Arc::clone(&top.problem);
    report.set_closed_form(ClosedForm::new(move |part| {
        Ok(match &problem.kind {
            Kind::Free { exact, .. } => exact.attitude_at(part * problem.end),
            Kind::Top { exact, .. } => exact.attitude(part * problem.end),
        })
    }));
    Ok(())
}
