//! `solve` on the motions, and how honest it is on random ones.

use super::honesty::{Spread, cases, spreads};
use super::*;
use kit::Result;
use rough::heavy;

/// Random scenes; each is solved at eleven tolerances.
const SCENES: u64 = 204;

/// Adds what `solve` chose, and what it delivers on random scenes.
pub fn tables(p: &Parameters, report: &mut Report) -> Result<()> {
    let all = prepared(p)?;
    report.add(chosen(&all)?)?;
    if let Some(lopsided) = lines::of(&all, "lopsided") {
        report.add(two_runs(lopsided)?)?;
    }
    report.add(honesty()?)
}

/// What `solve` chose on each motion, and what that delivered and cost.
fn chosen(all: &[Measured]) -> Result<Table> {
    let columns = "motion, requested, chosen, delivered, estimate, run, all runs";
    let motions = all.iter().map(|measured| &measured.motion);
    let requests = motions.flat_map(|motion| ASKED.map(|asked| (motion, asked)));
    Table::of("solve", columns.split(", "), requests, |(motion, asked)| {
        let told = match motion.problem.solved(asked) {
            Ok(solved) => [
                solved.method.to_owned(),
                rounded_up(motion.problem.errors(&solved.state).attitude),
                rounded_up(solved.estimate),
                solved.run.torques().to_string(),
                solved.work.torques().to_string(),
            ],
            Err(Error::NotDelivered { best, .. }) => {
                let refused = format!("refused: at best {}", rounded_up(best));
                [&refused, "-", "-", "-", "-"].map(str::to_owned)
            }
            Err(other) => return Err(other.into()),
        };
        let request = [motion.name.to_owned(), rounded_up(asked)];
        Ok(request.into_iter().chain(told))
    })
}

/// What two runs of one motion say, number by number.
fn two_runs(Measured { motion, .. }: &Measured) -> Result<Table> {
    let (tolerance, end, (scene, start)) = (1e-6, motion.end, heavy()?);
    let solved = motion.problem.solved(tolerance)?;
    let body = scene.body();
    let torque = scene.effects().torque_scale(0.0, body, &start);
    let [i1, i2, i3] = body.moments().to_array();
    let energy = body.kinetic_energy(&start) + 2.0 * torque;
    let fastest = (2.0 * energy / i1.min(i2).min(i3)).sqrt();
    // The condition is what the change made of the end, and what a late end makes.
    let change = 0.05 * tolerance / (1.0 + fastest * end);
    let late = body.angular_velocity(&solved.state).norm() * end;
    let moved = solved.condition * solved.condition - late * late;
    let distance = change * moved.sqrt();
    let floor = 8.0 * EPS * (1.0 + solved.condition);
    let rows = [
        ("error requested / rad", rounded_up(tolerance)),
        ("change of the inputs of the first run", short(change, 2)),
        ("steps of the first run", (solved.work.steps - solved.run.steps).to_string()),
        ("steps of the second", solved.run.steps.to_string()),
        ("distance of the two / rad", short(distance, 3)),
        ("condition", short(solved.condition, 3)),
        ("floor / rad", short(floor, 2)),
        ("estimate / rad", short(solved.estimate, 3)),
        ("true error / rad", rounded_up(motion.problem.errors(&solved.state).attitude)),
        ("work of both over that of the second", short(solved.price, 3)),
    ];
    let cells = |(quantity, value): (&str, String)| Ok([quantity.to_owned(), value]);
    Table::of("two_runs", ["quantity", "value"], rows, cells)
}

/// What `solve` delivers on random scenes.
fn honesty() -> Result<Table> {
    let columns = "requested, delivered, a quarter below, half below, three quarters, largest, \
                   refused, price";
    let spreads = random()?;
    Table::of("honesty", columns.split(", "), spreads.iter(), |spread| {
        let at = |part| rounded_up(spread.quantile(part));
        Ok([
            rounded_up(spread.tolerance),
            spread.ratios.len().to_string(),
            at(0.25),
            at(0.5),
            at(0.75),
            at(1.0),
            spread.refused.to_string(),
            short(spread.price, 2),
        ])
    })
}

/// The random scenes, judged once.
fn random() -> rotation_dynamics::Result<Arc<Vec<Spread>>> {
    static JUDGED: Prepared<u64, Vec<Spread>> = Prepared::new();
    JUDGED.get(&SCENES, |count| spreads(&cases(*count)?))
}

/// A quantile of a spread: of its errors, or of its estimates.
type Quantile = fn(&Spread, f64) -> f64;

/// The quantile that belongs to a part, against the request.
fn line(spreads: &[Spread], of: Quantile, part: f64) -> Vec<(f64, f64)> {
    spreads.iter().map(|spread| (spread.tolerance, of(spread, part).max(1e-6))).collect()
}

/// What lies between the quartiles.
fn band(spreads: &[Spread], of: Quantile) -> Vec<(f64, f64)> {
    let [low, mut high] = [0.25, 0.75].map(|part| line(spreads, of, part));
    high.reverse();
    [low, high].concat()
}

/// The errors over the request, with their median, and the promise.
fn errors(spreads: &[Spread], y: &str, median: &str) -> Panel {
    let errors = Curve::new(line(spreads, Spread::quantile, 0.5), Ink::Ink);
    let requested = Axis::log("error requested / rad");
    Panel::over_axes(requested, Axis::log(y).range(1e-6, 10.0))
        .size(340, 300)
        .level(1.0, Ink::Wrong, "broken promise")
        .area(band(spreads, Spread::quantile), Ink::Frame)
        .curve(errors.with_dots().label(median))
}

figures! { _: &Parameters, spreads = random()?;
    /// Error delivered over error requested against the request, from 1e-3 to 1e-13, for two
    /// hundred random scenes: the largest stays below one everywhere, the median lies below a
    /// thousandth and rises towards the smallest requests
    honesty: errors(&spreads, "delivered over requested", "median")
        .curve(Curve::new(line(&spreads, Spread::quantile, 1.0), Ink::Ink)
            .dashed().label("largest"))
        .note(1e-12, 2e-3, Ink::Frame, "quartiles", Side::Below);

    /// Estimate and error over the error requested against the request, from 1e-3 to 1e-13, for
    /// two hundred random scenes: the median of the estimates lies near a tenth, that of the
    /// errors a hundred times and more below, but for the smallest requests
    estimates: errors(&spreads, "over the error requested", "error")
        .area(band(&spreads, Spread::estimate), Ink::Frame)
        .curve(Curve::new(line(&spreads, Spread::estimate, 0.5), Ink::Ink)
            .dashed().with_dots().label("estimate"));
}
