//! Races: long runs, and how errors grow in them. The races against other crates and over
//! many bodies are measured by `benches`, and the page shows their records.

#[path = "accuracy/block.rs"]
mod block;
#[path = "accuracy_races/drift.rs"]
#[allow(dead_code, reason = "the tests of the drift run a free body, too")]
mod drift;
#[path = "accuracy_races/growth.rs"]
mod growth;
#[path = "accuracy_races/long.rs"]
mod long;

use drift::{Kind, Point, curves};
use kit::prelude::*;
use kit::{Prepared, rounded_up};
use std::sync::Arc;

parameters! {
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
fn prepared(p: &Parameters) -> Result<Arc<Vec<drift::Curve>>> {
    static GROWN: Prepared<[f64; 2], Vec<drift::Curve>> = Prepared::new();
    Ok(GROWN.get(&[p.periods, p.starts], |[periods, starts]| {
        curves(Kind::Top, starts.round() as usize, *periods)
    })?)
}

fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let mut rows = Trajectory::new(["method", "periods", "phase [rad]", "invariants"])?;
    for (method, curve) in (1..).zip(prepared(p)?.iter()) {
        for point in &curve.points {
            rows.push([f64::from(method), point.periods, point.phase, point.invariants])?;
        }
    }
    Ok(rows)
}

example! {
    accuracy_races: "Long runs: closed form or steps, and how errors grow";
    "Races", "long runs, free and heavy; errors of the attitude in rad, of what is kept relative",
    [growth::powers, long::work, long::limits, long::effects]; growth::figures, trajectory
}
