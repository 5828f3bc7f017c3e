//! The dial on the motions, and how honest it is on random ones.

use super::ASKED;
use super::honesty::{Spread, cases, spreads};
use super::lines::{Measured, power};
use kit::draw::{Axis, Curve, Ink, Panel, Side};
use kit::{Figure, Prepared, Report, Result, Table, rounded_up, short};
use rotation_dynamics::Error;
use std::sync::Arc;

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
        let motion = &measured.motion;
        for asked in ASKED {
            let mut row = vec![motion.name.to_owned(), rounded_up(asked)];
            match motion.problem.solved(asked) {
                Ok(solved) => row.extend([
                    solved.method.to_owned(),
                    rounded_up(motion.problem.errors(&solved.state).attitude),
                    rounded_up(solved.estimate),
                    solved.run.torques().to_string(),
                    solved.work.torques().to_string(),
                ]),
                Err(
                    Error::BeyondCondition { attainable, .. }
                    | Error::NotDelivered {
                        reached: attainable,
                        ..
                    },
                ) => {
                    row.push(format!("refused: at best {}", rounded_up(attainable)));
                    row.resize(7, "-".into());
                }
                Err(other) => return Err(other.into()),
            }
            table.push(row)?;
        }
    }
    report.add(table)?;

    let columns = [
        "requested",
        "delivered",
        "a quarter below",
        "half below",
        "three quarters",
        "largest",
        "refused",
        "price",
    ];
    let mut table = Table::new("honesty", columns)?;
    for spread in random()?.iter() {
        let at = |part| power(Some(spread.quantile(part)));
        table.push([
            rounded_up(spread.tolerance),
            spread.ratios.len().to_string(),
            at(0.25),
            at(0.5),
            at(0.75),
            at(1.0),
            spread.refused.to_string(),
            short(spread.price, 2),
        ])?;
    }
    report.add(table)
}

/// The random scenes, judged once.
fn random() -> rotation_dynamics::Result<Arc<Vec<Spread>>> {
    static JUDGED: Prepared<u64, Vec<Spread>> = Prepared::new();
    JUDGED.get(&SCENES, |count| spreads(&cases(*count)?))
}

/// Delivered over requested: the median, the quartiles, the largest.
pub fn figure() -> Result<Figure> {
    let spreads = random()?;
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
    .area(band, Ink::Frame)
    .curve(Curve::new(line(0.5), Ink::Ink).with_dots().label("median"))
    .curve(Curve::new(line(1.0), Ink::Ink).dashed().label("largest"))
    .note(1e-12, 2e-3, Ink::Frame, "quartiles", Side::Below)
    .figure()
}
