//! How errors grow with the time: powers, decade by decade, and two pictures.

use super::drift::{Curve, Method};
use super::*;
use kit::draw::Method as Look;

/// Powers are fitted from here on, where rounding has had time to add up.
const FROM: f64 = 100.0;

/// An error at a point.
type Error = fn(&Point) -> f64;
const PHASE: Error = |point| point.phase;
const KEPT: Error = |point| point.invariants;

/// Adds the powers of the time, and claims for those that truncation fixes.
pub fn powers(p: &Parameters, report: &mut Report) -> Result<()> {
    let all = prepared(p)?;
    let columns =
        "method, 10 to 100, 100 to 1000, 1000 on, of what is kept, phase / rad, what is kept";
    report.add(Table::of("drift", columns.split(", "), all.iter(), |drift| {
        let power = |from, to| match drift.exponent_between(from, to, PHASE) {
            power if power.is_nan() => "-".to_owned(),
            power => format!("{power:.2}"),
        };
        let last = |error: Error| drift.points.last().map_or("-".into(), |p| rounded_up(error(p)));
        Ok([
            Look::named(drift.method.names().1).label().to_owned(),
            power(10.0, 100.0),
            power(100.0, 1000.0),
            power(1000.0, f64::INFINITY),
            format!("{:.2}", drift.exponent(FROM, KEPT)),
            last(PHASE),
            last(KEPT),
        ])
    })?)?;
    for drift in all.iter() {
        // What truncation does is the same on every start; rounding walks at random.
        let fixed: &[(&str, Error, f64)] = match drift.method {
            Method::Dop853 => &[("phase", PHASE, 2.0), ("kept", KEPT, 1.0)],
            Method::Rk4 => &[("kept", KEPT, 1.0)],
            Method::Splitting => &[("phase", PHASE, 1.0)],
            _ => &[],
        };
        let (key, name) = drift.method.names();
        for &(what, error, must) in fixed {
            let meaning = format!("{name}: power of the time in the error: {what}");
            let power = drift.exponent(FROM, error);
            report.add(
                claim(format!("drift_{key}_{what}"), meaning, power, "-")
                    .agrees_with("a rate that is off by so much, or more and more", must, 0.09)
                    .judged_within(0.1)
                    .answer("powers of the time"),
            )?;
        }
    }
    Ok(())
}

figures! { p: &Parameters, all = prepared(p)?;
    /// The heavy top, error of the attitude / rad against the number of periods, both logarithmic.
    drift_phase(at_the_end(&all, PHASE)): over_periods(&all, "error of the attitude / rad", PHASE, 1e-15);

    /// The heavy top, error of what is kept against the number of periods, both logarithmic.
    drift_kept(at_the_end(&all, KEPT)): over_periods(&all, "error of what is kept", KEPT, 1e-16);
}

fn at_the_end(all: &[Curve], error: Error) -> String {
    let end = |drift: &Curve| {
        let name = drift.method.names().1;
        Some(format!("{name} {}", rounded_up(error(drift.points.last()?))))
    };
    let ends: Vec<String> = all.iter().filter_map(end).collect();
    format!(" At the end: {}", ends.join(", "))
}

fn over_periods(all: &[Curve], axis: &str, error: Error, low: f64) -> Panel {
    let panel = Panel::over_axes(Axis::log("periods"), Axis::log(axis).range(low, 1.0));
    all.iter().fold(panel.size(340, 300), |panel, drift| {
        let points = drift.points.iter().map(|p| (p.periods, error(p).max(low)));
        let look = Look::named(drift.method.names().1);
        panel.curve(look.curve(points).label(look.label()))
    })
}
