//! How errors grow with the time: powers, decade by decade, and two pictures.

use super::drift::{Curve, Method, Point};
use kit::draw::{Axis, Method as Look, Panel};
use kit::{Figure, Report, Result, Table, claim, rounded_up};

/// Powers are fitted from here on, where rounding has had time to add up.
const FROM: f64 = 100.0;

fn phase(point: &Point) -> f64 {
    point.phase
}

fn kept(point: &Point) -> f64 {
    point.invariants
}

/// Adds the powers of the time, and claims for those that truncation fixes.
pub fn add(report: &mut Report, all: &[Curve]) -> Result<()> {
    let columns = [
        "method",
        "10 to 100",
        "100 to 1000",
        "1000 on",
        "of what is kept",
        "phase / rad",
        "what is kept",
    ];
    let mut table = Table::new("drift", columns)?;
    for drift in all {
        let decade = |from, to| {
            let power = drift.exponent_between(from, to, phase);
            match power.is_nan() {
                true => "-".to_owned(),
                false => format!("{power:.2}"),
            }
        };
        let last = drift.points.last();
        table.push([
            Look::named(drift.method.names().1).label().to_owned(),
            decade(10.0, 100.0),
            decade(100.0, 1000.0),
            decade(1000.0, f64::INFINITY),
            format!("{:.2}", drift.exponent(FROM, kept)),
            last.map_or("-".into(), |p| rounded_up(p.phase)),
            last.map_or("-".into(), |p| rounded_up(p.invariants)),
        ])?;
    }
    report.add(table)?;
    for drift in all {
        add_claims(report, drift)?;
    }
    Ok(())
}

/// What truncation does is the same on every start; rounding walks at random.
fn add_claims(report: &mut Report, drift: &Curve) -> Result<()> {
    let (key, name) = drift.method.names();
    let of_phase = ("phase", drift.exponent(FROM, phase));
    let of_kept = ("kept", drift.exponent(FROM, kept));
    let fixed = match drift.method {
        Method::Dop853 => vec![(of_phase, 2.0), (of_kept, 1.0)],
        Method::Rk4 => vec![(of_kept, 1.0)],
        Method::Splitting => vec![(of_phase, 1.0)],
        _ => Vec::new(),
    };
    for ((what, power), must) in fixed {
        report.add(
            claim(
                format!("drift_{key}_{what}"),
                format!("{name}: power of the time in the error: {what}"),
                power,
                "-",
            )
            .within(0.09)
            .against("a rate that is off by so much, or more and more", must)
            .judged_within(0.1)
            .answer("powers of the time"),
        )?;
    }
    Ok(())
}

/// The phase, and what is kept, against the number of periods.
pub fn figures(all: &[Curve]) -> Result<Vec<Figure>> {
    Ok(vec![
        panel(all, "drift_phase", "error of the attitude / rad", phase, 1e-15)?,
        panel(all, "drift_kept", "error of what is kept", kept, 1e-16)?,
    ])
}

fn panel(
    all: &[Curve],
    name: &str,
    axis: &str,
    error: fn(&Point) -> f64,
    low: f64,
) -> Result<Figure> {
    let ends: Vec<String> = (all.iter())
        .filter_map(|drift| {
            let end = drift.points.last()?;
            Some(format!("{} {}", drift.method.names().1, rounded_up(error(end))))
        })
        .collect();
    let alt = format!(
        "The heavy top, {axis} against the number of periods, both logarithmic. At the end: {}",
        ends.join(", ")
    );
    let mut panel = Panel::new(name, &alt)
        .size(340, 300)
        .x(Axis::log("periods"))
        .y(Axis::log(axis).range(low, 1.0));
    for drift in all {
        let points = drift.points.iter().map(|p| (p.periods, error(p).max(low)));
        let look = Look::named(drift.method.names().1);
        panel = panel.curve(look.curve(points).label(look.label()));
    }
    panel.figure()
}
