//! How errors grow over a million periods, method by method: `benches/record/drift.txt`.
//!
//! ```text
//! cargo run --release -p benches --bin drift
//! ```
//!
//! Nothing here is timed: the same bits, and so the same record, on every machine. It
//! takes some minutes; `tests/accuracy/drift.rs` computes the shorter times again.

#[path = "../../../examples/accuracy_races/drift.rs"]
#[allow(dead_code, reason = "the example draws what is tabulated here")]
mod drift;

use benches::record::{Outcome, save};
use drift::{Curve, Kind, Method, curve};
use kit::cli::alive;
use kit::{Report, Table, rounded_up};
use rayon::prelude::*;
use rotation_dynamics::Result;

const STARTS: usize = 8;
const PERIODS: f64 = 1e6;

/// Exponents are fitted from here on.
const FROM: f64 = 100.0;

fn main() -> Outcome<()> {
    alive(record)
}

fn record() -> Outcome<()> {
    let mut report = Report::new(
        "Long-time drift",
        format!(
            "Root mean squares over {STARTS} starts; exponents are fitted from {FROM} periods on; \
             deterministic. Compute again: cargo run --release -p benches --bin drift"
        ),
    )?;
    for (name, kind) in [("top", Kind::Top), ("free", Kind::Free)] {
        let methods: Vec<Method> =
            Method::ALL.into_iter().filter(|method| method.applies_to(kind)).collect();
        let curves: Vec<Curve> = methods
            .par_iter()
            .map(|method| curve(*method, kind, STARTS, PERIODS))
            .collect::<Result<_>>()?;
        let columns = ["method", "periods", "phase / rad", "invariants"];
        let mut grown = Table::new(name, columns)?;
        let columns = ["method", "of the phase", "of the invariants", "phase / rad per period"];
        let mut powers = Table::new(&format!("{name}_powers"), columns)?;
        for curve in &curves {
            let name = curve.method.names().1;
            // The decades, of four points each.
            for point in curve.points.iter().step_by(4) {
                grown.push([
                    name.to_owned(),
                    format!("{:e}", point.periods),
                    rounded_up(point.phase),
                    rounded_up(point.invariants),
                ])?;
            }
            let last = curve.points.last().ok_or("no points")?;
            powers.push([
                name.to_owned(),
                format!("{:.2}", curve.exponent(FROM, |point| point.phase)),
                format!("{:.2}", curve.exponent(FROM, |point| point.invariants)),
                rounded_up(last.phase / last.periods),
            ])?;
        }
        report.add(grown)?;
        report.add(powers)?;
    }
    save("drift", &report)
}
