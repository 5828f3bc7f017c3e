//! The record of the races.
//!
//! The record has the grammar of a report ([`kit`]):
//! `conditions`, a table of times per problem, `dense_…`, `ratios`, `targets`, and
//! `runs`, from which every line can be run again ([`again`]).

use crate::contest::{Setting, contestants};
use crate::dense::{self, PER_PERIOD, PERIODS, samplers};
use crate::problem::{PROBLEMS, Problem};
use crate::race::{Line, Race, TARGETS};
use benches::record::conditions;
use kit::{Parsed, Report, Table, rounded_up, short};

/// The command that writes the record.
pub const COMMAND: &str = "cargo run --release --manifest-path benches/peers/Cargo.toml";

/// The problems of which dense output is asked.
pub const DENSE: [&str; 2] = ["free_body", "heavy_top"];

/// The peers, as this crate's lock file names them.
pub(crate) const PEERS: [&str; 6] =
    ["numeris", "ode_solvers", "differential-equations", "ivp", "diffsol", "rapier3d"];

/// The version of a crate in the lock file.
fn version(name: &str) -> Option<&'static str> {
    const LOCK: &str = include_str!("../Cargo.lock");
    let entry = format!("name = \"{name}\"\nversion = \"");
    let (_, rest) = LOCK.split_once(&entry)?;
    rest.split('"').next()
}

/// All races, with what is measured besides.
pub struct Races {
    /// To the end of each of [`PROBLEMS`].
    pub ends: Vec<Race>,
    /// Dense output of each of [`DENSE`].
    pub dense: Vec<Race>,
    /// One sample of the heavy top after 1e6 periods, in units of one after 1 period.
    pub late: f64,
}

pub(crate) type Outcome<T> = Result<T, String>;

pub(crate) fn in_words(error: impl Into<kit::Error>) -> String {
    error.into().to_string()
}

/// An error as the head of a column: `1e-9`.
pub(crate) fn head(error: f64) -> String {
    format!("{error:e}")
}

/// The text of the record.
///
/// # Errors
/// A cell that does not fit a table.
pub fn text(races: &Races) -> Outcome<String> {
    let mut report = Report::new(
        "Races against other crates",
        format!(
            "Milliseconds of processor time to the end of each problem, to the same measured \
             error in rad; ns per sample for dense output. Medians of rounds in which all run in \
             turn; measured, not locked. Measure again: {COMMAND}"
        ),
    )
    .map_err(in_words)?;
    let all = races.ends.iter().chain(&races.dense);
    let mut tables = vec![condition_table(&PEERS, all)?];
    for (problem, race) in PROBLEMS.iter().zip(&races.ends) {
        let times = |line: &Line| short(1e3 * line.seconds, 2);
        tables.push(times_table(problem.key, race, TARGETS, times)?);
    }
    for (key, race) in DENSE.iter().zip(&races.dense) {
        let samples = (PERIODS * PER_PERIOD + 1) as f64;
        let times = |line: &Line| short(1e9 * line.seconds / samples, 2);
        tables.push(times_table(&format!("dense_{key}"), race, dense::TARGETS, times)?);
    }
    tables.push(ratio_table(races)?);
    tables.push(target_table(races)?);
    tables.push(run_table(races)?);
    for table in tables {
        report.add(table).map_err(in_words)?;
    }
    report.text().map_err(in_words)
}

pub(crate) fn table<const N: usize>(name: &str, columns: [&str; N]) -> Outcome<Table> {
    Table::new(name, columns).map_err(in_words)
}

pub(crate) fn condition_table<'r>(
    peers: &[&str],
    races: impl Iterator<Item = &'r Race>,
) -> Outcome<Table> {
    let mut table = conditions().map_err(|e| e.to_string())?;
    for &peer in peers {
        let version = version(peer).ok_or(format!("{peer} is not in the lock file"))?;
        table.push([peer, version]).map_err(in_words)?;
    }
    let rounds = races.map(|race| race.rounds);
    let (least, most) = rounds.fold((usize::MAX, 0), |(a, b), n| (a.min(n), b.max(n)));
    let rounds = format!("{least} to {most}");
    table.push(["rounds", &rounds]).map_err(in_words)?;
    Ok(table)
}

/// A line per name, a column per error, and why a place is empty.
pub(crate) fn times_table(
    name: &str,
    race: &Race,
    targets: [f64; 4],
    time: impl Fn(&Line) -> String,
) -> Outcome<Table> {
    let heads = targets.map(head);
    let [a, b, c, d] = &heads;
    let mut table = table(name, ["method", a, b, c, d, "at best"])?;
    for name in &race.names {
        let mut cells = vec![name.clone()];
        for target in 0..targets.len() {
            let line = race.line(name, target);
            cells.push(line.map_or("-".into(), &time));
        }
        let failure = race.failures.iter().find(|failure| &failure.name == name);
        cells.push(failure.map_or("-".into(), |failure| {
            if !failure.least.is_finite() {
                return "none".into();
            }
            let least = rounded_up(failure.least);
            match failure.impatient {
                true => format!("{least} (slow)"),
                false => least,
            }
        }));
        table.push(cells).map_err(in_words)?;
    }
    Ok(table)
}

/// The fastest peer, the fastest stepping of ours, and the closed form.
pub(crate) struct Rivals<'r> {
    pub(crate) peer: Option<&'r Line>,
    pub(crate) stepping: Option<&'r Line>,
    exact: Option<&'r Line>,
}

impl<'r> Rivals<'r> {
    pub(crate) fn of(race: &'r Race, target: usize) -> Self {
        Self {
            peer: race.fastest(target, |line| !line.is_ours()),
            stepping: race.fastest(target, |line| line.is_ours() && !line.is_exact()),
            exact: race.fastest(target, Line::is_exact),
        }
    }

    /// How many times faster our stepping is than the fastest peer.
    pub(crate) fn gain(&self) -> Option<f64> {
        Some(self.peer?.ratio / self.stepping?.ratio)
    }

    /// How many times faster the closed form is than the fastest peer.
    fn exact_gain(&self) -> Option<f64> {
        Some(self.peer?.ratio / self.exact?.ratio)
    }
}

const RATIOS: [&str; 9] = [
    "problem",
    "error",
    "fastest peer",
    "peer / ms",
    "our stepping",
    "ours / ms",
    "faster",
    "closed form / ms",
    "closed form faster",
];

fn ratio_table(races: &Races) -> Outcome<Table> {
    let mut table = table("ratios", RATIOS)?;
    for (problem, race) in PROBLEMS.iter().zip(&races.ends) {
        for (target, &error) in TARGETS.iter().enumerate() {
            let rivals = Rivals::of(race, target);
            let name = |line: Option<&Line>| line.map_or("-".into(), |line| line.name.clone());
            let time =
                |line: Option<&Line>| line.map_or("-".into(), |line| short(1e3 * line.seconds, 2));
            let times = |gain: Option<f64>| gain.map_or("-".into(), |gain| short(gain, 2));
            let cells = [
                problem.key.to_owned(),
                head(error),
                name(rivals.peer),
                time(rivals.peer),
                name(rivals.stepping),
                time(rivals.stepping),
                times(rivals.gain()),
                time(rivals.exact),
                times(rivals.exact_gain()),
            ];
            table.push(cells).map_err(in_words)?;
        }
    }
    Ok(table)
}

/// What was wanted of the races before they were run, and what came out.
fn target_table(races: &Races) -> Outcome<Table> {
    let mut table = table("targets", ["target", "wanted", "measured", "verdict"])?;
    let mut add = |target: &str, wanted: f64, measured: Option<f64>, at_least: bool| {
        let met = measured.is_some_and(|measured| match at_least {
            true => measured >= wanted,
            false => measured <= wanted,
        });
        let sign = if at_least { ">=" } else { "<=" };
        let cells = [
            target.to_owned(),
            format!("{sign} {}", if wanted < 1e-3 { head(wanted) } else { wanted.to_string() }),
            measured.map_or("-".into(), |measured| short(measured, 2)),
            if met { "met" } else { "missed" }.to_owned(),
        ];
        table.push(cells).map_err(in_words)
    };
    let race = |key: &str| {
        let at = PROBLEMS.iter().position(|problem| problem.key == key);
        at.and_then(|at| races.ends.get(at))
    };
    for (key, name) in [("free_body", "free body"), ("heavy_top", "heavy top")] {
        let rivals = |target| race(key).map(|race| Rivals::of(race, target));
        let gain = |target| rivals(target).and_then(|rivals| rivals.gain());
        add(
            &format!("{name}: one state in closed form against the fastest peer at 1e-9"),
            200.0,
            rivals(2).and_then(|rivals| rivals.exact_gain()),
            true,
        )?;
        add(
            &format!("{name}: the same against our own stepping"),
            200.0,
            rivals(2).and_then(|r| Some(r.stepping?.ratio / r.exact?.ratio)),
            true,
        )?;
        for (target, error, wanted) in [(1, "1e-6", 3.0), (2, "1e-9", 5.0)] {
            add(
                &format!("{name}: stepping against the fastest peer at {error}"),
                wanted,
                gain(target),
                true,
            )?;
        }
        let at = |target: usize, ours: bool| {
            let line = race(key)?.fastest(target, |l| l.is_ours() == ours && !l.is_exact())?;
            Some(line.error)
        };
        add(&format!("{name}: error that our stepping reaches / rad"), 1e-11, at(3, true), false)?;
    }
    add(
        "heavy top: one sample after 1e6 periods, in units of one after 1",
        1.1,
        Some(races.late),
        false,
    )?;
    let samples = (PERIODS * PER_PERIOD + 1) as f64;
    for (n, (name, [single, batch])) in
        [("free body", [70.0, 25.0]), ("heavy top", [32.0, 12.0])].into_iter().enumerate()
    {
        let Some(race) = races.dense.get(n) else {
            continue;
        };
        let time = |part: &str| {
            let counts = |line: &Line| line.is_exact() && line.name.ends_with(part);
            Some(1e9 * race.fastest(0, counts)?.seconds / samples)
        };
        add(&format!("{name}: ns per sample, one by one"), single, time("one by one"), false)?;
        add(&format!("{name}: ns per sample, in a batch"), batch, time("batch"), false)?;
        let peer = race.fastest(0, |line| !line.is_ours());
        let exact = race.fastest(0, Line::is_exact);
        add(
            &format!("{name}: samples in closed form against the fastest peer at 1e-3"),
            1.0,
            peer.zip(exact).map(|(peer, exact)| peer.ratio / exact.ratio),
            true,
        )?;
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
    "in units of the closed form",
    "quartiles",
];

fn run_table(races: &Races) -> Outcome<Table> {
    let mut table = table("runs", RUNS)?;
    let ends = PROBLEMS.iter().map(|problem| problem.key.to_owned());
    let dense = DENSE.iter().map(|key| format!("dense_{key}"));
    let keys = ends.zip(&races.ends).map(|(key, race)| (key, race, TARGETS));
    let dense = dense.zip(&races.dense);
    let dense = dense.map(|(key, race)| (key, race, dense::TARGETS));
    for (key, race, targets) in keys.chain(dense) {
        for line in &race.lines {
            table.push(run_cells(&key, line, targets)).map_err(in_words)?;
        }
    }
    Ok(table)
}

/// A line of a race as a row of the table of runs.
pub(crate) fn run_cells(key: &str, line: &Line, targets: [f64; 4]) -> [String; 8] {
    let [lower, upper] = line.quartiles.map(|quartile| short(quartile, 2));
    [
        key.to_owned(),
        head(targets[line.target]),
        line.name.clone(),
        line.form.to_owned(),
        line.setting.to_string(),
        rounded_up(line.error),
        short(line.ratio, 2),
        format!("{lower} to {upper}"),
    ]
}

/// A line of the record, to be run again.
#[derive(Debug, Clone, PartialEq)]
pub struct Claim {
    /// The problem, or `dense_` and the problem.
    pub key: String,
    /// The error that is claimed (rad).
    pub error: f64,
    /// The crate and its method.
    pub name: String,
    /// The variables.
    pub form: String,
    /// The setting.
    pub setting: Setting,
}

/// The claims of a record.
///
/// # Errors
/// A line that cannot be read.
pub fn claims(record: &Parsed) -> Outcome<Vec<Claim>> {
    let runs = record.table("table runs").ok_or("no table of runs")?;
    let claim = |row: &Vec<String>| {
        let [key, error, name, form, setting, ..] = row.as_slice() else {
            return Err(format!("a short line: {row:?}"));
        };
        Ok(Claim {
            key: key.clone(),
            error: error.parse().map_err(|e| format!("{error}: {e}"))?,
            name: name.clone(),
            form: form.clone(),
            setting: setting.parse()?,
        })
    };
    runs.rows().iter().map(claim).collect()
}

/// The error of each claim on the problem `key`, run again: measured, and claimed.
///
/// # Errors
/// A claim about nobody; a run that fails.
pub fn again(key: &str, claims: &[Claim]) -> Outcome<Vec<(f64, Claim)>> {
    let mut delivered = Vec::new();
    let claims = claims.iter().filter(|claim| claim.key == key);
    if let Some(key) = key.strip_prefix("dense_") {
        let problem = Problem::named(key).ok_or(format!("no problem {key}"))?;
        let all = samplers(problem).map_err(in_words)?;
        for claim in claims {
            let same = |s: &&dense::Sampler| s.name() == claim.name && s.form == claim.form;
            let sampler = all.iter().find(same);
            let sampler = sampler.ok_or_else(|| format!("nobody does {claim:?}"))?;
            (sampler.run)(claim.setting)?;
            delivered.push(((sampler.error)()?, claim.clone()));
        }
    } else {
        let problem = Problem::named(key).ok_or(format!("no problem {key}"))?;
        let all = contestants(problem).map_err(in_words)?;
        for claim in claims {
            let contestant = all.iter().find(|c| c.name() == claim.name && c.form == claim.form);
            let contestant = contestant.ok_or_else(|| format!("nobody does {claim:?}"))?;
            let end = (contestant.run)(claim.setting)?;
            delivered.push((problem.error(&end).map_err(in_words)?, claim.clone()));
        }
    }
    Ok(delivered)
}
