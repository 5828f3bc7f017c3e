//! The dial on the five motions, and how honest it is on random ones.

use super::honesty::{Spread, cases, spreads};
use super::measured::Measured;
use super::solved;
use super::tables::ASKED;
use rotation_dynamics::math::{log10, pow};
use rotation_dynamics::report::draw::{Axis, Curve, Ink, Panel, Side};
use rotation_dynamics::report::{Figure, Report, Table, rounded_up, short};
use rotation_dynamics::{Error, Result};

/// Random scenes; each is solved at eleven tolerances.
const SCENES: u64 = 204;

/// Adds what the dial chose, and what it delivers on random scenes.
pub fn add(report: &mut Report, all: &[Measured]) -> Result<()> {
    let columns = [
        "motion",
        "requested",
        "chosen",
        "delivered",
        "estimate",
        "run",
        "all runs",
    ];
    let mut table = Table::new("dial", columns)?;
    for measured in all {
        for asked in ASKED {
            let mut row = vec![measured.problem.name.to_owned(), rounded_up(asked)];
            match solved(&measured.problem, asked) {
                Ok(solved) => row.extend([
                    short_name(solved.method).to_owned(),
                    rounded_up(measured.problem.errors(&solved.state).attitude),
                    rounded_up(solved.estimate),
                    solved.run.torques().to_string(),
                    solved.work.torques().to_string(),
                ]),
                Err(Error::BeyondCondition { attainable, .. }) => row.extend([
                    format!("refused: at best {}", rounded_up(attainable)),
                    "-".into(),
                    "-".into(),
                    "-".into(),
                    "-".into(),
                ]),
                Err(other) => return Err(other),
            }
            table.push(row)?;
        }
    }
    report.add_table(table)?;

    let columns = [
        "requested",
        "a quarter below",
        "half below",
        "three quarters",
        "largest",
        "refused",
        "price",
    ];
    let mut table = Table::new("honesty", columns)?;
    for spread in spreads(&cases(SCENES)?)? {
        let at = |part| one_digit(spread.quantile(part));
        table.push([
            rounded_up(spread.tolerance),
            at(0.25),
            at(0.5),
            at(0.75),
            at(1.0),
            spread.refused.to_string(),
            short(spread.price, 2),
        ])?;
    }
    report.add_table(table)
}

/// Delivered over requested: the median, the quartiles, the largest.
pub fn figure() -> Result<Figure> {
    let spreads = spreads(&cases(SCENES)?)?;
    let line = |part: f64| -> Vec<(f64, f64)> {
        let value = |s: &Spread| (s.tolerance, s.quantile(part).max(1e-6));
        spreads.iter().map(value).collect()
    };
    let band = line(0.25).into_iter().chain(line(0.75).into_iter().rev());
    Panel::new(
        "honesty",
        "Error delivered over error requested against the request, from 1e-3 to 1e-13, for two hundred \
         random scenes: the largest stays below one everywhere, the median lies near a thousandth and rises \
         towards the smallest requests",
    )
    .size(340, 300)
    .x(Axis::log("error requested / rad"))
    .y(Axis::log("delivered over requested").range(1e-5, 10.0))
    .level(1.0, Ink::Wrong, "broken promise")
    .area(band, Ink::Momentum)
    .curve(Curve::new(line(0.5), Ink::Momentum).with_dots().label("median"))
    .curve(Curve::new(line(1.0), Ink::Ink).dashed().label("largest"))
    .note(1e-12, 2e-3, Ink::Momentum, "quartiles", Side::Below)
    .figure()
}

/// A name as this chapter writes it.
pub fn short_name(method: &str) -> &str {
    let names = ["Blanes-Moan ", "Blanes et al. ", "McLachlan "];
    let name = names.iter().find_map(|name| method.strip_prefix(name));
    name.unwrap_or(method)
}

/// One digit and a power of ten.
fn one_digit(x: f64) -> String {
    if x <= 0.0 {
        return "0".into();
    }
    let exponent = log10(x).floor();
    let digit = (x / pow(10.0, exponent)).round();
    if digit < 10.0 {
        format!("{digit}e{exponent}")
    } else {
        format!("1e{}", exponent + 1.0)
    }
}
