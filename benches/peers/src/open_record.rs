//! What is written down of the races without a closed form: a record of its own, since it is
//! measured apart, with the grammar of the other ([`crate::record`]).

use crate::open::OPEN;
use crate::problem::Problem;
use crate::race::{Line, Race, TARGETS};
use crate::record::{
    Outcome, PEERS, Rivals, condition_table, head, in_words, run_cells, table, times_table,
};
use kit::{Report, Table, short};

/// The command that writes the record.
pub const COMMAND: &str = "cargo run --release --manifest-path benches/peers/Cargo.toml -- open";

/// The text of the record.
///
/// # Errors
/// A cell that does not fit a table.
pub fn text(races: &[Race]) -> Outcome<String> {
    let mut report = Report::new(
        "Races of motions without a closed form",
        format!(
            "Milliseconds of processor time to the end of each problem, to the same error in rad \
             against a Taylor series at 50 digits. Medians of rounds in which all run in turn; \
             measured, not locked. Measure again: {COMMAND}"
        ),
    )
    .map_err(in_words)?;
    // The game engine reaches none of these errors and is not asked.
    let carrying: Vec<&str> = (PEERS.into_iter()).filter(|peer| *peer != "rapier3d").collect();
    let mut tables = vec![condition_table(&carrying, races.iter())?];
    for (problem, race) in OPEN.iter().zip(races) {
        tables.push(problem_table(problem.key, race)?);
    }
    tables.push(ratio_table(races)?);
    tables.push(target_table(races)?);
    tables.push(run_table(races)?);
    for table in tables {
        report.add(table).map_err(in_words)?;
    }
    report.text().map_err(in_words)
}

/// The times and runs of one problem, to be read and not kept.
///
/// # Errors
/// A cell that does not fit a table.
pub fn of_one(problem: &Problem, race: &Race) -> Outcome<String> {
    let mut report = Report::new(problem.key, problem.title).map_err(in_words)?;
    let mut runs = table("runs", RUNS)?;
    push_runs(&mut runs, problem.key, race)?;
    for table in [problem_table(problem.key, race)?, runs] {
        report.add(table).map_err(in_words)?;
    }
    report.text().map_err(in_words)
}

fn problem_table(key: &str, race: &Race) -> Outcome<Table> {
    times_table(key, race, TARGETS, |line| short(1e3 * line.seconds, 2))
}

/// How many times faster our DOP853 is than that of `ode_solvers`, both in the best of the same
/// variables.
fn dop853(race: &Race, target: usize) -> Option<f64> {
    let theirs = race.line("ode_solvers Dop853", target)?;
    Some(theirs.ratio / race.line("DOP853", target)?.ratio)
}

fn ratio_table(races: &[Race]) -> Outcome<Table> {
    let columns = [
        "problem",
        "error",
        "fastest peer",
        "peer / ms",
        "our stepping",
        "ours / ms",
        "faster",
        "DOP853",
    ];
    let mut table = table("ratios", columns)?;
    for (problem, race) in OPEN.iter().zip(races) {
        for (target, &error) in TARGETS.iter().enumerate() {
            let rivals = Rivals::of(race, target);
            let name = |line: Option<&Line>| line.map_or("-".into(), |line| line.name.clone());
            let number = |value: Option<f64>| value.map_or("-".into(), |value| short(value, 2));
            let time = |line: Option<&Line>| number(line.map(|line| 1e3 * line.seconds));
            let cells = [
                problem.key.to_owned(),
                head(error),
                name(rivals.peer),
                time(rivals.peer),
                name(rivals.stepping),
                time(rivals.stepping),
                number(rivals.gain()),
                number(dop853(race, target)),
            ];
            table.push(cells).map_err(in_words)?;
        }
    }
    Ok(table)
}

/// What was wanted before the races were run, and what came out.
fn target_table(races: &[Race]) -> Outcome<Table> {
    let mut table = table("targets", ["target", "wanted", "measured", "verdict"])?;
    let mut add = |target: String, wanted: &str, measured: Option<f64>, met: bool| {
        let cells = [
            target,
            wanted.to_owned(),
            measured.map_or("-".into(), |measured| short(measured, 2)),
            if met { "met" } else { "missed" }.to_owned(),
        ];
        table.push(cells).map_err(in_words)
    };
    for (problem, race) in OPEN.iter().zip(races) {
        let name = problem.key.replace('_', " ");
        for (target, wanted) in [(1, 3.0), (2, 5.0)] {
            let gain = Rivals::of(race, target).gain();
            add(
                format!("{name}: stepping against the fastest peer at {}", head(TARGETS[target])),
                &format!(">= {wanted}"),
                gain,
                gain.is_some_and(|gain| gain >= wanted),
            )?;
        }
        let finest = Rivals::of(race, 3).stepping.map(|line| line.error);
        add(
            format!("{name}: error that our stepping reaches / rad"),
            "<= 1e-11",
            finest,
            finest.is_some_and(|error| error <= TARGETS[3]),
        )?;
        for target in [1, 2] {
            let gain = dop853(race, target);
            add(
                format!("{name}: DOP853 against that of ode_solvers at {}", head(TARGETS[target])),
                ">= 1",
                gain,
                gain.is_some_and(|gain| gain >= 1.0),
            )?;
        }
    }
    Ok(table)
}

const RUNS: [&str; 8] = [
    "problem",
    "error",
    "method",
    "variables",
    "setting",
    "delivered",
    "in units of our fastest at 1e-3",
    "quartiles",
];

fn run_table(races: &[Race]) -> Outcome<Table> {
    let mut table = table("runs", RUNS)?;
    for (problem, race) in OPEN.iter().zip(races) {
        push_runs(&mut table, problem.key, race)?;
    }
    Ok(table)
}

fn push_runs(table: &mut Table, key: &str, race: &Race) -> Outcome<()> {
    for line in &race.lines {
        table.push(run_cells(key, line, TARGETS)).map_err(in_words)?;
    }
    Ok(())
}
