//! What the sweeps say: conditions, floors, prices, and the cheapest method.

use super::ASKED;
use super::lines::{FLOW, Line, Measured, SIZE, power};
use kit::draw::Method as Look;
use kit::{Report, Result, Table, claim, rounded_up, short};
use rotation_dynamics::accuracy::{DigitPrice, Measure};
use rotation_dynamics::integrators::Method;
use rotation_dynamics::math::{EPS, exp2, log, log10, pow};

/// What a digit costs by this line: fitted where the steps are short and round-off is far.
pub fn price(line: &Line) -> Option<DigitPrice> {
    let floor = line.attitude.floor()?.error;
    line.attitude.price_of_a_digit(30.0 * floor, 1e-3)
}

/// Adds the tables.
pub fn add(report: &mut Report, all: &[Measured]) -> Result<()> {
    report.add(methods()?)?;
    report.add(choices(all)?)?;
    report.add(conditions(all)?)?;
    report.add(floors(all, "floors", Measure::Attitude)?)?;
    report.add(floors(all, "floors_of_invariants", Measure::Invariants)?)?;
    report.add(measures(&all[1])?)?;
    report.add(prices(all)?)?;
    report.add(sweeps(&all[0])?)
}

/// The card of methods.
fn methods() -> Result<Table> {
    let columns = ["method", "order", "idea", "keeps", "source"];
    let mut table = Table::new("methods", columns)?;
    for method in Method::ALL {
        let about = method.about();
        table.push([
            about.name.to_owned(),
            about.order.to_string(),
            about.idea.to_owned(),
            about.conserved.to_owned(),
            about.source.to_owned(),
        ])?;
    }
    Ok(table)
}

/// For each motion and error the method with the fewest evaluations, and how many.
fn choices(all: &[Measured]) -> Result<Table> {
    let asked = ASKED.map(|e| format!("{} rad", rounded_up(e)));
    let columns = core::iter::once("motion".to_owned()).chain(asked);
    let mut table = Table::new("choices", columns)?;
    for measured in all {
        let mut row = vec![measured.motion.name.to_owned()];
        for error in ASKED {
            let delivering = measured.contestants().filter_map(|line| {
                let least = line.attitude.least_work(error)?;
                Some((least.work, line.name))
            });
            let best = delivering.min_by(|a, b| a.0.total_cmp(&b.0));
            row.push(best.map_or("-".into(), |(work, name)| format!("{name}: {work:.0}")));
        }
        table.push(row)?;
    }
    Ok(table)
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
    let mut table = Table::new("conditions", columns)?;
    for measured in all {
        let floors = measured.contestants().filter_map(|line| {
            let floor = line.attitude.floor()?;
            Some((floor.error, line.name))
        });
        let best = floors.min_by(|a, b| a.0.total_cmp(&b.0));
        table.push([
            measured.motion.name.to_owned(),
            rounded(measured.start_condition),
            rounded(measured.path_condition.1),
            short(EPS * measured.path_condition.1, 2),
            best.map_or("-".into(), |b| short(b.0, 2)),
            best.map_or("-".into(), |b| Look::named(b.1).label().to_owned()),
        ])?;
    }
    Ok(table)
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

/// The smallest error of each method on each motion, in one measure; a dash where the
/// dearest runs are still gaining.
fn floors(all: &[Measured], name: &str, measure: Measure) -> Result<Table> {
    let names = all.iter().map(|m| m.motion.name.to_owned());
    let mut table = Table::new(name, core::iter::once("method".to_owned()).chain(names))?;
    for each in every(all) {
        let mut row = vec![each.name.to_owned()];
        for measured in all {
            let floor = match measured.line(each.key) {
                Some(line) => line.reached(measure)?,
                None => None,
            };
            row.push(power(floor.map(|p| p.error)));
        }
        if row[1..].iter().any(|cell| cell != "-") {
            table.push(row)?;
        }
    }
    Ok(table)
}

/// The same runs in three measures, for methods of about the same work.
fn measures(top: &Measured) -> Result<Table> {
    let columns = ["method", "evaluations", "attitude", "rates", "what is kept"];
    let mut table = Table::new("measures", columns)?;
    for key in ["semi", "rk4", "srkn6", "srkn14", "dop853", "gauss"] {
        let Some(line) = top.line(key) else { continue };
        let near = |work: f64| (work - 4096.0).abs();
        let runs = line.sweep.runs().iter();
        let run = runs.min_by(|a, b| {
            let work = |run: &rotation_dynamics::accuracy::Run| near(run.work.torques() as f64);
            work(a).total_cmp(&work(b))
        });
        let Some(run) = run else { continue };
        table.push([
            line.name.to_owned(),
            run.work.torques().to_string(),
            rounded_up(run.errors.attitude),
            rounded_up(run.errors.rates),
            rounded_up(run.errors.invariants),
        ])?;
    }
    Ok(table)
}

/// The factor in evaluations for one more digit, on each motion.
fn prices(all: &[Measured]) -> Result<Table> {
    let names = all.iter().map(|m| m.motion.name.to_owned());
    let columns = ["method".to_owned(), "by the order".to_owned()].into_iter();
    let mut table = Table::new("prices", columns.chain(names))?;
    for each in every(all).into_iter().filter(|line| line.key != FLOW) {
        let mut row = vec![
            each.name.to_owned(),
            short(DigitPrice::predicted(each.method.order())?, 3),
        ];
        for measured in all {
            let price = measured.line(each.key).and_then(price);
            row.push(price.map_or("-".into(), |p| short(p.factor, 3)));
        }
        if row[2..].iter().any(|cell| cell != "-") {
            table.push(row)?;
        }
    }
    Ok(table)
}

/// Why Gauss-Legendre's line is upright: shorter steps need fewer sweeps.
fn sweeps(free: &Measured) -> Result<Table> {
    let columns = [
        "steps a period",
        "sweeps a step",
        "evaluations a period",
        "error / rad",
    ];
    let mut table = Table::new("sweeps", columns)?;
    let periods = free.motion.periods;
    for a_period in [4.0, 5.0, 6.0, 7.0, 8.0, 10.0, 12.0, 16.0] {
        let steps = [(a_period * periods).round()];
        let sweep = free.motion.problem.sweep(Method::GaussLegendre16, &steps);
        // Steps too long to converge are refused.
        let Some(run) = sweep.runs().first() else {
            continue;
        };
        let evaluations = run.work.derivatives as f64;
        table.push([
            short(run.work.steps as f64 / periods, 3),
            short(evaluations / 8.0 / run.work.steps as f64, 3),
            short(evaluations / periods, 3),
            rounded_up(run.errors.attitude),
        ])?;
    }
    Ok(table)
}

/// The order of Gauss-Legendre in its steps, on the heavy top.
fn order_in_steps(line: &Line) -> Result<Option<DigitPrice>> {
    let Some(floor) = line.attitude.floor() else {
        return Ok(None);
    };
    let curve = line.sweep.curve(Measure::Attitude, |work| work.steps)?;
    Ok(curve.price_of_a_digit(30.0 * floor.error, 1e-8))
}

/// Numbers that a second route confirms.
pub fn add_claims(report: &mut Report, all: &[Measured]) -> Result<()> {
    let line = |motion: &str, method: &str| {
        let measured = all.iter().find(|m| m.motion.key == motion)?;
        measured.line(method)
    };
    for (method, bound) in [
        ("strang", 0.01),
        ("rk4", 0.01),
        ("mk4", 0.1),
        ("srkn6", 0.1),
        ("srkn14", 0.1),
        ("dop853", 0.1),
    ] {
        let Some(line) = line("top", method) else {
            continue;
        };
        let Some(price) = price(line) else { continue };
        let order = line.method.order();
        report.add(
            claim(
                format!("top_{method}_digit"),
                format!("{}: factor in work for one more digit", line.name),
                price.factor,
                "-",
            )
            .within(bound)
            .against(&format!("10^(1/{order})"), DigitPrice::predicted(order)?)
            .judged_within(0.05)
            .answer("the heavy top: work for one more digit")
            .slip(
                exp2(f64::from(order)),
                "that is what half the step takes off the error",
            ),
        )?;
    }
    if let Some(gauss) = line("top", "gauss")
        && let Some(price) = order_in_steps(gauss)?
    {
        let meaning = "order of Gauss-Legendre in its steps, on the heavy top";
        report.add(
            claim("top_gauss_order", meaning, price.order, "-")
                .within(0.9)
                .against("its order", 16.0)
                .judged_within(0.05),
        )?;
    }
    for (motion, dear, cheap) in [
        ("top", "rk4", "dop853"),
        ("top", "rk4", "srkn14"),
        ("pole", "angles", "dop853"),
    ] {
        let (Some(dear), Some(cheap)) = (line(motion, dear), line(motion, cheap)) else {
            continue;
        };
        // Between two runs, as if the error went by a power of the work.
        let least = |line: &Line| {
            let reached = line.attitude.least_work(1e-9)?;
            let runs = line.attitude.points();
            let at = runs.iter().position(|run| *run == reached)?;
            let before = runs.get(at.checked_sub(1)?)?;
            let part = log(before.error / 1e-9) / log(before.error / reached.error);
            Some(before.work * pow(reached.work / before.work, part))
        };
        let (Some(a), Some(b), Some(c), Some(d)) =
            (least(dear), least(cheap), price(dear), price(cheap))
        else {
            continue;
        };
        report.add(
            claim(
                format!("{motion}_{}_over_{}", dear.key, cheap.key),
                format!(
                    "work of {} over that of {} for 1e-9 rad",
                    dear.name, cheap.name
                ),
                a / b,
                "-",
            )
            .within(1.0)
            .against("the fitted lines", c.work_for(1e-9)? / d.work_for(1e-9)?)
            .judged_within(0.2),
        )?;
    }
    for measured in all {
        let motion = &measured.motion;
        let (t, path) = measured.path_condition;
        // On the way through a flip even this disturbance bends the path a little.
        let part = if motion.key == "flips" { 0.05 } else { 0.005 };
        report.add(
            claim(
                format!("{}_condition", motion.key),
                format!("{}: what the path magnifies an error by", motion.name),
                path,
                "-",
            )
            .within(part * path)
            .against(
                "a disturbance 8 times as large",
                motion.condition(t, 8.0 * SIZE)?,
            )
            .judged_within(0.3),
        )?;
    }
    Ok(())
}
