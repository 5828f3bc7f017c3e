//! Long runs: how errors drift.

use super::drift::{Curve as Drift, Kind, Method, Point, curves};
use rotation_dynamics::Result;
use rotation_dynamics::report::draw::{Axis, Curve, Ink, Panel};
use rotation_dynamics::report::{Claim, Figure, Oracle, Report, Table, short};

/// Starts whose errors are averaged, and periods of the longest run.
const STARTS: usize = 4;
const PERIODS: f64 = 10_000.0;

/// Powers are fitted from here on, where rounding has had time to add up.
const FROM: f64 = 100.0;

/// The curves of every method on the heavy top.
fn all() -> Result<Vec<Drift>> {
    curves(Kind::Top, STARTS, PERIODS)
}

/// Adds the powers of the time, and claims for those that truncation fixes.
pub fn add(report: &mut Report) -> Result<()> {
    let columns = [
        "method",
        "power of the phase",
        "power of what is kept",
        "phase / rad",
        "what is kept",
    ];
    let mut table = Table::new("drift", columns)?;
    for drift in all()? {
        let (phase, kept) = powers(&drift);
        let last = drift.points.last();
        table.push([
            drift.method.names().1.to_owned(),
            short(phase, 2),
            short(kept, 2),
            last.map_or("-".into(), |p| short(p.phase, 1)),
            last.map_or("-".into(), |p| short(p.invariants, 1)),
        ])?;
        let names = drift.method.names();
        // What truncation does is the same on every start; rounding walks at random.
        let fixed = match drift.method {
            Method::Dop853 => vec![("phase", phase, 2.0), ("kept", kept, 1.0)],
            Method::Rk4 => vec![("kept", kept, 1.0)],
            Method::Splitting => vec![("phase", phase, 1.0)],
            _ => Vec::new(),
        };
        for (name, power, must) in fixed {
            report.add_claim(
                Claim::new(
                    format!("drift_{}_{name}", names.0),
                    format!("{}: power of the time in the error: {name}", names.1),
                    power,
                    "-",
                    0.09,
                    Oracle::new("a rate that is off by so much, or more and more", must),
                )?
                .judged_within(0.1),
            )?;
        }
    }
    report.add_table(table)
}

fn powers(drift: &Drift) -> (f64, f64) {
    (
        drift.exponent(FROM, |p| p.phase),
        drift.exponent(FROM, |p| p.invariants),
    )
}

/// The phase, and what is kept, against the number of periods.
pub fn figures() -> Result<Vec<Figure>> {
    let all = all()?;
    let phase = |p: &Point| p.phase;
    let kept = |p: &Point| p.invariants;
    Ok(vec![
        panel(
            &all,
            "drift_phase",
            "error of the attitude / rad",
            phase,
            (1e-15, 1.0),
        )?,
        panel(
            &all,
            "drift_kept",
            "error of what is kept",
            kept,
            (1e-16, 1e-4),
        )?,
    ])
}

fn panel(
    all: &[Drift],
    name: &str,
    axis: &str,
    error: impl Fn(&Point) -> f64,
    (low, high): (f64, f64),
) -> Result<Figure> {
    let alt = format!(
        "The heavy top, {axis} against the number of periods, on logarithmic axes: the methods that lose \
         energy climb steeply, those that keep it slowly, and the one that brings it back least"
    );
    let mut panel = Panel::new(name, &alt)
        .size(340, 300)
        .x(Axis::log("periods"))
        .y(Axis::log(axis).range(low, high));
    for drift in all {
        let points = drift.points.iter().map(|p| (p.periods, error(p).max(low)));
        let (ink, label) = match drift.method {
            Method::Gauss => (Ink::Ink, "Gauss 16"),
            Method::GaussProjected => (Ink::Ink, "brought back"),
            Method::Splitting => (Ink::Body, "order 6"),
            Method::Rk4 => (Ink::Energy, "RK4"),
            Method::Dop853 => (Ink::Velocity, "DOP853"),
        };
        let curve = Curve::new(points, ink).label(label);
        panel = panel.curve(match drift.method {
            Method::GaussProjected => curve.dashed(),
            _ => curve,
        });
    }
    panel.figure()
}
