//! Races: long runs, and how errors grow in them. The races against other crates and over
//! many bodies are measured by `benches`, and the page shows their records.

#[path = "accuracy_races/drift.rs"]
mod drift;
#[path = "accuracy_races/growth.rs"]
mod growth;
#[path = "accuracy_races/long.rs"]
mod long;

use drift::{Curve, Kind, curves};
use kit::{Prepared, Report, Result, Trajectory};
use std::sync::Arc;

kit::parameters! {
    /// The long runs.
    pub struct Parameters {
        /// periods of the longest run of the heavy top
        periods: number(10_000.0, "-", from_to(1000.0, 100_000.0).because("fewer tell nothing of growth, more take too long"));
        /// starts whose errors are averaged
        starts: number(4.0, "-", from_to(1.0, 16.0).because("more take too long"));
        /// error asked for in the accuracy strip, after a hundred periods
        tolerance: number(1e-9, "rad", from_to(1e-11, 1.0));
    }
}

/// How the errors of every method grow on the heavy top.
pub fn prepared(p: &Parameters) -> rotation_dynamics::Result<Arc<Vec<Curve>>> {
    static GROWN: Prepared<[f64; 2], Vec<Curve>> = Prepared::new();
    GROWN.get(&[p.periods, p.starts], |[periods, starts]| {
        curves(Kind::Top, starts.round() as usize, *periods)
    })
}

fn report(p: &Parameters) -> Result<Report> {
    let mut report = Report::new(
        "Races",
        "long runs, free and heavy; errors of the attitude in rad, of what is kept relative",
    )?;
    growth::add(&mut report, &prepared(p)?)?;
    long::add(&mut report, p.tolerance)?;
    Ok(report)
}

fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let mut rows = Trajectory::new(["method", "periods", "phase [rad]", "invariants"])?;
    for (i, curve) in prepared(p)?.iter().enumerate() {
        for point in &curve.points {
            rows.push([(i + 1) as f64, point.periods, point.phase, point.invariants])?;
        }
    }
    Ok(rows)
}

kit::example! {
    accuracy_races: "Long runs: closed form or steps, and how errors grow";
    report, |p| growth::figures(&prepared(p)?), trajectory
}
