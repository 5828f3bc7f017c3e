//! What the sweeps say: conditions, floors, prices, and the cheapest method.

use super::*;
use kit::draw::Method as Look;
use kit::{Claim, Result};
use lines::{FLOW, Line, SIZE};
use rotation_dynamics::accuracy::DigitPrice;
use rotation_dynamics::math::log10;

/// The price of a digit on a curve: fitted where the steps are short and round-off is far.
fn fitted(curve: &WorkPrecision, line: &Line, coarsest: f64) -> Option<DigitPrice> {
    curve.price_of_a_digit(30.0 * line.attitude.floor()?.error, coarsest)
}

/// What a digit costs by this line.
pub fn price(line: &Line) -> Option<DigitPrice> {
    fitted(&line.attitude, line, 1e-3)
}

/// Adds the tables.
pub fn tables(p: &Parameters, report: &mut Report) -> Result<()> {
    let all = &prepared(p)?[..];
    report.add(vec![
        methods()?,
        choices(all)?,
        conditions(all)?,
        floors(all, "floors", Measure::Attitude)?,
        floors(all, "floors_of_invariants", Measure::Invariants)?,
        measures(&all[1])?,
        prices(all)?,
        sweeps(&all[0])?,
    ])
}

/// The card of methods.
fn methods() -> Result<Table> {
    let columns = ["method", "order", "idea", "keeps", "source"];
    Table::of("methods", columns, Method::ALL, |method| {
        let about = method.about();
        let order = about.order.to_string();
        Ok([about.name, &order, about.idea, about.conserved, about.source].map(str::to_owned))
    })
}

/// For each motion and error the method with the fewest evaluations, and how many.
fn choices(all: &[Measured]) -> Result<Table> {
    let asked = ASKED.map(|e| format!("{} rad", rounded_up(e)));
    let columns = [vec!["motion".to_owned()], asked.to_vec()].concat();
    Table::of("choices", columns, all, |measured| {
        let cells = ASKED.map(|error| match measured.first(error) {
            Some((work, name)) => format!("{name}: {work:.0}"),
            None => "-".to_owned(),
        });
        Ok([vec![measured.motion.name.to_owned()], cells.to_vec()].concat())
    })
}

/// Two digits, as a power of ten from ten thousand on.
fn rounded(condition: f64) -> String {
    if condition < 1e4 {
        return short(condition, 2);
    }
    let exponent = log10(condition).floor();
    format!("{}e{exponent}", short(condition / pow(10.0, exponent), 2))
}

/// What the motion itself does to errors, and the smallest error that any method reached.
fn conditions(all: &[Measured]) -> Result<Table> {
    let columns = ["motion", "start", "path", "eps x path", "reached", "by"];
    Table::of("conditions", columns, all, |measured| {
        let best = measured.best(|line| Some(line.attitude.floor()?.error));
        Ok([
            measured.motion.name.to_owned(),
            rounded(measured.start_condition),
            rounded(measured.path_condition.1),
            short(EPS * measured.path_condition.1, 2),
            best.map_or("-".into(), |(error, _)| short(error, 2)),
            best.map_or("-".into(), |(_, name)| Look::named(name).label().into()),
        ])
    })
}

/// The lines of all motions: one of each key, with its name, as they come.
fn every(all: &[Measured]) -> Vec<&Line> {
    let mut lines: Vec<&Line> = Vec::new();
    for line in all.iter().flat_map(|m| &m.lines) {
        if !lines.iter().any(|l| l.key == line.key) {
            // A splitting stands before DOP853, wherever it was met first.
            let at = lines.iter().position(|l| l.method > line.method);
            lines.insert(at.unwrap_or(lines.len()), line);
        }
    }
    lines
}

/// A row for each method of which `cell` says something on some motion, and a column for each
/// motion, after those that say of a method what it is on any.
fn by_method<const N: usize>(
    all: &[Measured],
    name: &str,
    heads: [&str; N],
    head: impl Fn(&Line) -> Result<[String; N]>,
    cell: impl Fn(&Line) -> Result<Option<String>>,
) -> Result<Table> {
    let motions = all.iter().map(|measured| measured.motion.name);
    let mut table = Table::new(name, heads.into_iter().chain(motions))?;
    for each in every(all) {
        let of_motion = |measured: &Measured| measured.line(each.key).map_or(Ok(None), &cell);
        let cells = all.iter().map(of_motion).collect::<Result<Vec<_>>>()?;
        if cells.iter().any(Option::is_some) {
            let cells = cells.into_iter().map(|cell| cell.unwrap_or("-".into()));
            table.push(head(each)?.into_iter().chain(cells))?;
        }
    }
    Ok(table)
}

/// The smallest error of each method on each motion, in one measure; a dash where the
/// dearest runs are still gaining.
fn floors(all: &[Measured], name: &str, measure: Measure) -> Result<Table> {
    let head = |line: &Line| Ok([line.name.to_owned()]);
    by_method(all, name, ["method"], head, |line| {
        Ok(line.reached(measure)?.map(|floor| rounded_up(floor.error)))
    })
}

/// The factor in evaluations for one more digit, on each motion.
fn prices(all: &[Measured]) -> Result<Table> {
    let head = |line: &Line| {
        let predicted = DigitPrice::predicted(line.method.order())?;
        Ok([line.name.to_owned(), short(predicted, 3)])
    };
    by_method(all, "prices", ["method", "by the order"], head, |line| {
        let price = price(line).filter(|_| line.key != FLOW);
        Ok(price.map(|price| short(price.factor, 3)))
    })
}

/// The same runs in three measures, for methods of about the same work.
fn measures(top: &Measured) -> Result<Table> {
    let columns = ["method", "evaluations", "attitude", "rates", "what is kept"];
    let near = |key| {
        let line = top.line(key)?;
        let runs = line.sweep.runs().iter();
        let run = runs.min_by_key(|run| run.work.torques().abs_diff(4096))?;
        Some((line.name, run))
    };
    let keys = ["semi", "rk4", "srkn6", "srkn14", "dop853", "gauss"];
    let found = keys.into_iter().filter_map(near);
    Table::of("measures", columns, found, |(name, run)| {
        let errors = [run.errors.attitude, run.errors.rates, run.errors.invariants];
        let [attitude, rates, kept] = errors.map(rounded_up);
        let evaluations = run.work.torques().to_string();
        Ok([name.to_owned(), evaluations, attitude, rates, kept])
    })
}

/// Why Gauss-Legendre's line is upright: shorter steps need fewer sweeps.
fn sweeps(free: &Measured) -> Result<Table> {
    let columns = "steps a period, sweeps a step, evaluations a period, error / rad";
    let periods = free.motion.periods;
    let a_period = [4.0, 5.0, 6.0, 7.0, 8.0, 10.0, 12.0, 16.0];
    let steps = a_period.map(|steps: f64| (steps * periods).round());
    // Steps too long to converge are refused.
    let gauss = |steps| free.motion.problem.run(Method::GaussLegendre16, steps);
    let sweep = free.motion.sweep(steps, gauss);
    Table::of("sweeps", columns.split(", "), sweep.runs(), |run| {
        let (steps, evaluations) = (run.work.steps as f64, run.work.derivatives as f64);
        Ok([
            short(steps / periods, 3),
            short(evaluations / 8.0 / steps, 3),
            short(evaluations / periods, 3),
            rounded_up(run.errors.attitude),
        ])
    })
}

/// Which digits of the heavy top are claimed, and how well they are known.
const DIGITS: [(&[&str], f64); 2] =
    [(&["strang", "rk4"], 0.01), (&["mk4", "srkn6", "srkn14", "dop853"], 0.1)];

/// Which work is claimed to be more, and than which: a motion, and two methods on it.
const RATIOS: [[&str; 3]; 3] =
    [["top", "rk4", "dop853"], ["top", "rk4", "srkn14"], ["pole", "angles", "dop853"]];

/// Adds numbers that a second route confirms: of the page's own body.
pub fn claims(p: &Parameters, report: &mut Report) -> Result<()> {
    if !p.are_default() {
        return Ok(());
    }
    let (all, rk4) = (prepared(p)?, rk4(&motions::tumbling(p)?)?);
    if let Some(price) = rk4.price_of_a_digit(1e-10, 1e-6) {
        claims! { report,
            /// order of RK4 on the free body, from the slope of error against work
            rk4_order: price.order, "-", "its order" => 4.0, within 0.1, judged 0.05, in "the free body";
        }?;
    }
    let line = |motion, method| lines::of(&all, motion)?.line(method);
    for (methods, bound) in DIGITS {
        let lines = methods.iter().filter_map(|method| line("top", method));
        report.add(lines.filter_map(|line| digit(line, bound)).collect::<Vec<_>>())?;
    }
    if let Some(order) = line("top", "gauss").and_then(order_in_steps) {
        claims! { report,
            /// order of Gauss-Legendre in its steps, on the heavy top
            top_gauss_order: order, "-", "its order" => 16.0, within 0.9, judged 0.05;
        }?;
    }
    for [motion, dear, cheap] in RATIOS {
        if let (Some(dear), Some(cheap)) = (line(motion, dear), line(motion, cheap)) {
            report.add(Vec::from_iter(ratio(motion, dear, cheap)))?;
        }
    }
    (all.iter()).try_for_each(|measured| report.add(condition(measured)?))
}

/// What one more digit costs on the heavy top.
fn digit(line: &Line, bound: f64) -> Option<Claim> {
    let (key, order) = (format!("top_{}_digit", line.key), line.method.order());
    let meaning = format!("{}: factor in work for one more digit", line.name);
    let predicted = DigitPrice::predicted(order).ok()?;
    let halved = exp2(f64::from(order));
    Some(
        claim(key, meaning, price(line)?.factor, "-")
            .agrees_with(&format!("10^(1/{order})"), predicted, bound)
            .judged_within(0.05)
            .answer("the heavy top: work for one more digit")
            .slip(halved, "that is what half the step takes off the error"),
    )
}

/// The order of a method in its steps.
fn order_in_steps(line: &Line) -> Option<f64> {
    let in_steps = (line.sweep).curve(Measure::Attitude, |work| work.steps).ok()?;
    Some(fitted(&in_steps, line, 1e-8)?.order)
}

/// By how much one method works more than another for 1e-9 rad.
fn ratio(motion: &str, dear: &Line, cheap: &Line) -> Option<Claim> {
    const ERROR: f64 = 1e-9;
    // Between two runs, as if the error went by a power of the work.
    let least = |line: &Line| {
        let reached = line.attitude.least_work(ERROR)?;
        let runs = line.attitude.points();
        let at = runs.iter().position(|run| *run == reached)?;
        let before = runs.get(at.checked_sub(1)?)?;
        let part = log(before.error / ERROR) / log(before.error / reached.error);
        Some(before.work * pow(reached.work / before.work, part))
    };
    let by_fit = |line| price(line)?.work_for(ERROR).ok();
    let key = format!("{motion}_{}_over_{}", dear.key, cheap.key);
    let [much, little] = [dear.name, cheap.name];
    let meaning = format!("work of {much} over that of {little} for 1e-9 rad");
    let claim = claim(key, meaning, least(dear)? / least(cheap)?, "-")
        .agrees_with("the fitted lines", by_fit(dear)? / by_fit(cheap)?, 1.0)
        .judged_within(0.2);
    Some(claim)
}

/// What the path of a motion magnifies an error by.
fn condition(measured: &Measured) -> Result<Claim> {
    let (motion, (t, path)) = (&measured.motion, measured.path_condition);
    let key = format!("{}_condition", motion.key);
    let meaning = format!("{}: what the path magnifies an error by", motion.name);
    // On the way through a flip even this disturbance bends the path a little.
    let part = if motion.key == "flips" { 0.05 } else { 0.005 };
    let larger = motion.condition(t, 8.0 * SIZE)?;
    Ok(claim(key, meaning, path, "-")
        .agrees_with("a disturbance 8 times as large", larger, part * path)
        .judged_within(0.3))
}
