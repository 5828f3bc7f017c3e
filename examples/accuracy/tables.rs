//! What the sweeps say: prices, floors, and what to choose.

use super::measured::{Line, Measured, SIZE, evaluations};
use super::methods::METHODS;
use super::problems;
use rotation_dynamics::Result;
use rotation_dynamics::accuracy::{DigitPrice, Measure};
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::math::{EPS, exp2, log10, pow};
use rotation_dynamics::report::{Claim, Oracle, Report, Table, rounded_up, short};

/// The errors asked for in the table of choices, in rad.
pub const ASKED: [f64; 4] = [1e-3, 1e-6, 1e-9, 1e-12];

/// What a digit costs by this line: fitted where the steps are short and round-off is far.
pub fn price(line: &Line) -> Option<DigitPrice> {
    let floor = line.attitude.floor()?.error;
    line.attitude.price_of_a_digit(30.0 * floor, 1e-3)
}

fn count(evaluations: f64) -> String {
    format!("{evaluations:.0}")
}

/// Adds the tables, and the claims that have a second route.
pub fn add(
    report: &mut Report,
    all: &[Measured],
    moments: PrincipalMoments,
    claims: bool,
) -> Result<()> {
    report.add_table(choices(all)?)?;
    report.add_table(conditions(all)?)?;
    report.add_table(floors(all, "floors", Measure::Attitude)?)?;
    report.add_table(floors(all, "floors_of_rates", Measure::Rates)?)?;
    report.add_table(floors(all, "floors_of_invariants", Measure::Invariants)?)?;
    report.add_table(prices(all)?)?;
    report.add_table(sweeps(&all[0])?)?;
    report.add_table(long(moments)?)?;
    if claims {
        add_claims(report, all)?;
    }
    Ok(())
}

/// For each problem and error the method with the fewest evaluations, and how many.
fn choices(all: &[Measured]) -> Result<Table> {
    let asked = ASKED.map(|e| format!("{} rad", rounded_up(e)));
    let columns = core::iter::once("motion".to_owned()).chain(asked);
    let mut table = Table::new("choices", columns)?;
    for measured in all {
        let mut row = vec![measured.problem.name.to_owned()];
        for error in ASKED {
            let delivering = measured.contestants().filter_map(|line| {
                let least = line.attitude.least_work(error)?;
                Some((least.work, line.method.name))
            });
            let best = delivering.min_by(|a, b| a.0.total_cmp(&b.0));
            row.push(best.map_or("-".into(), |(work, name)| {
                format!("{name}: {}", count(work))
            }));
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

/// What the problem itself does to errors, and the smallest error that any method reached.
fn conditions(all: &[Measured]) -> Result<Table> {
    let columns = ["motion", "start", "path", "eps x path", "reached", "by"];
    let mut table = Table::new("conditions", columns)?;
    for measured in all {
        let floors = measured.contestants().filter_map(|line| {
            let floor = line.attitude.floor()?;
            Some((floor.error, line.method.name))
        });
        let best = floors.min_by(|a, b| a.0.total_cmp(&b.0));
        table.push([
            measured.problem.name.to_owned(),
            rounded(measured.start_condition),
            rounded(measured.path_condition.1),
            short(EPS * measured.path_condition.1, 2),
            best.map_or("-".into(), |b| short(b.0, 2)),
            best.map_or("-".into(), |b| b.1.to_owned()),
        ])?;
    }
    Ok(table)
}

/// The smallest error of each method on each motion, in one measure; a dash where the
/// dearest runs are still gaining.
fn floors(all: &[Measured], name: &str, measure: Measure) -> Result<Table> {
    let names = all.iter().map(|m| m.problem.name.to_owned());
    let mut table = Table::new(name, core::iter::once("method".to_owned()).chain(names))?;
    for method in METHODS {
        let mut row = vec![method.name.to_owned()];
        for measured in all {
            let floor = match measured.line(method.key) {
                Some(line) => line.reached(measure)?,
                None => None,
            };
            row.push(floor.map_or("-".into(), |p| short(p.error, 2)));
        }
        if row[1..].iter().any(|cell| cell != "-") {
            table.push(row)?;
        }
    }
    Ok(table)
}

/// The factor in evaluations for one more digit, on each problem.
fn prices(all: &[Measured]) -> Result<Table> {
    let names = all.iter().map(|m| m.problem.name.to_owned());
    let columns = ["method".to_owned(), "by the order".to_owned()].into_iter();
    let mut table = Table::new("prices", columns.chain(names))?;
    for method in METHODS {
        let mut row = vec![
            method.name.to_owned(),
            short(DigitPrice::predicted(method.order)?, 3),
        ];
        for measured in all {
            let price = measured.line(method.key).and_then(price);
            row.push(price.map_or("-".into(), |p| short(p.factor, 3)));
        }
        if row[2..].iter().any(|cell| cell != "-") {
            table.push(row)?;
        }
    }
    Ok(table)
}

/// The free body for longer and longer: evaluations for an error of 1e-9 rad.
fn long(moments: PrincipalMoments) -> Result<Table> {
    let columns = ["periods", "DOP853", "Gauss-Legendre 16", "closed form"];
    let mut table = Table::new("long", columns)?;
    for periods in [10.0, 100.0, 1000.0] {
        let problem = problems::generic(moments, periods)?;
        let mut row = vec![count(periods)];
        // From coarse to fine, around the setting that delivers.
        let tolerances = (9..=14).map(|k| pow(10.0, -f64::from(k)));
        let steps = (9..=16).map(|k| 0.5 * f64::from(k) * periods);
        for (key, settings) in [
            ("dop853", tolerances.collect()),
            ("gauss", steps.collect::<Vec<f64>>()),
        ] {
            let least = METHODS.iter().find(|m| m.key == key).and_then(|method| {
                let sweep = method.sweep_over(&problem, settings)?;
                let curve = sweep.curve(Measure::Attitude, evaluations).ok()?;
                curve.least_work(1e-9)
            });
            row.push(least.map_or("-".into(), |p| count(p.work)));
        }
        row.push("one sample".into());
        table.push(row)?;
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
    let Some(method) = METHODS.iter().find(|m| m.key == "gauss") else {
        return Ok(table);
    };
    let periods = free.problem.periods;
    for a_period in [4.0, 5.0, 6.0, 7.0, 8.0, 10.0, 12.0, 16.0] {
        let sweep = method.sweep_over(&free.problem, vec![(a_period * periods).round()]);
        // Steps too long to converge are refused.
        let Some(run) = sweep.as_ref().and_then(|s| s.runs().first()) else {
            continue;
        };
        let evaluations = run.work.derivatives as f64;
        table.push([
            short(run.work.steps as f64 / periods, 3),
            short(evaluations / 8.0 / run.work.steps as f64, 3),
            short(evaluations / periods, 3),
            short(run.errors.attitude, 2),
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
fn add_claims(report: &mut Report, all: &[Measured]) -> Result<()> {
    let named = |key: &str| all.iter().find(|m| m.problem.key == key);
    for (problem, method, bound) in [
        ("top", "strang", 0.01),
        ("top", "rk4", 0.01),
        ("top", "mk4", 0.1),
        ("top", "srkn6", 0.1),
        ("top", "srkn14", 0.1),
        ("top", "dop853", 0.1),
    ] {
        let Some(line) = named(problem).and_then(|m| m.line(method)) else {
            continue;
        };
        let Some(price) = price(line) else { continue };
        report.add_claim(
            Claim::new(
                format!("{problem}_{method}_digit"),
                format!("{}: factor in work for one more digit", line.method.name),
                price.factor,
                "-",
                bound,
                Oracle::new(
                    format!("10^(1/{})", line.method.order),
                    DigitPrice::predicted(line.method.order)?,
                ),
            )?
            .judged_within(0.05)
            .slip(
                exp2(f64::from(line.method.order)),
                "that is what half the step takes off the error",
            ),
        )?;
    }
    if let Some(line) = named("top").and_then(|m| m.line("gauss"))
        && let Some(price) = order_in_steps(line)?
    {
        report.add_claim(
            Claim::new(
                "top_gauss_order",
                "order of Gauss-Legendre in its steps, on the heavy top",
                price.order,
                "-",
                0.9,
                Oracle::new("its order", 16.0),
            )?
            .judged_within(0.05),
        )?;
    }
    for (problem, dear, cheap) in [
        ("top", "rk4", "dop853"),
        ("top", "rk4", "srkn14"),
        ("pole", "angles", "dop853"),
    ] {
        let lines = named(problem).and_then(|m| Some([m.line(dear)?, m.line(cheap)?]));
        let Some([dear, cheap]) = lines else { continue };
        let least = |line: &Line| line.attitude.least_work(1e-9).map(|p| p.work);
        let (Some(a), Some(b), Some(c), Some(d)) =
            (least(dear), least(cheap), price(dear), price(cheap))
        else {
            continue;
        };
        let ratio = a / b;
        report.add_claim(
            Claim::new(
                format!("{problem}_{}_over_{}", dear.method.key, cheap.method.key),
                format!(
                    "work of {} over that of {} for 1e-9 rad",
                    dear.method.name, cheap.method.name
                ),
                ratio,
                "-",
                1.0,
                Oracle::new("the fitted lines", c.work_for(1e-9)? / d.work_for(1e-9)?),
            )?
            .judged_within(0.2),
        )?;
    }
    for measured in all {
        let problem = &measured.problem;
        let (t, path) = measured.path_condition;
        let second = problem.condition(t, 8.0 * SIZE)?;
        report.add_claim(
            Claim::new(
                format!("{}_condition", problem.key),
                format!("{}: what the path magnifies an error by", problem.name),
                path,
                "-",
                // On the way through a flip even this disturbance bends the path a little.
                if problem.key == "flips" {
                    0.05 * path
                } else {
                    0.005 * path
                },
                Oracle::new("a disturbance 8 times as large", second),
            )?
            .judged_within(0.3),
        )?;
    }
    Ok(())
}
