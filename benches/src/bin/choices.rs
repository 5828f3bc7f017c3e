//! Which method delivers an error in the least time, motion by motion: the table with
//! which the page `accuracy` begins, `benches/record/choices.txt`.
//!
//! ```text
//! cargo run --release -p benches --bin choices -- --date 2026-11-22
//! ```
//!
//! Every method is timed at the coarsest setting with which it delivers, as the example's
//! sweeps know it. The unit is one sample of the closed form of the heavy top, in the same
//! rounds.

use benches::conditions::Conditions;
use benches::timing::{Task, interleaved};
use kit::cli::alive;
use kit::draw::Method;
use kit::{ClosedForm, Report, Table, rounded_up, short};
use pages::accuracy::lines::{Line, Measured};
use pages::accuracy::{ASKED, EXAMPLE, Parameters, prepared};
use std::error::Error;
use std::hint::black_box;
use std::path::Path;
use std::process::ExitCode;
use std::{env, fs};

/// Rounds in which everything is timed once.
const ROUNDS: usize = 101;

/// Samples of the closed form in one timed run.
const SAMPLES: u32 = 64;

type Outcome<T> = Result<T, Box<dyn Error>>;

fn main() -> ExitCode {
    match Conditions::read("choices", env::args().skip(1)).and_then(|c| alive(|| record(&c))) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}

fn record(conditions: &Conditions) -> Outcome<()> {
    let parameters = Parameters::default();
    let example = EXAMPLE.report(&parameters)?;
    let unit = example.closed_form().ok_or("no closed form")?;
    let mut report = Report::new(
        "Who is fastest",
        format!(
            "Time to the end of each motion within an error of the attitude, in samples of the \
             closed form of the heavy top; medians of {ROUNDS} rounds; measured, not locked. \
             Measure again: cargo run --release -p benches --bin choices"
        ),
    )?;
    report.add_table(conditions.table()?)?;
    let asked = ASKED.map(|e| format!("{} rad", rounded_up(e)));
    let [a, b, c, d] = asked.each_ref().map(String::as_str);
    let mut choices = Table::new("choices", ["motion", "closed form", a, b, c, d])?;
    let mut times = Vec::new();
    for measured in prepared(&parameters)?.iter() {
        eprintln!("{}", measured.motion.name);
        let of_motion = timed(measured, unit)?;
        let exact = of_motion.exact.map_or("-".into(), |t| short(t, 2));
        let mut row = vec![measured.motion.name.to_owned(), exact];
        for target in 0..ASKED.len() {
            let found = of_motion.lines.iter().filter_map(|(line, times)| {
                let time = times[target]?;
                Some((time, line.name))
            });
            let best = found.min_by(|x, y| x.0.total_cmp(&y.0));
            row.push(best.map_or("-".into(), |(time, name)| {
                format!("{}: {}", Method::named(name).label(), short(time, 2))
            }));
        }
        choices.push(row)?;
        let mut table = Table::new(
            &format!("times_{}", measured.motion.key),
            ["method", a, b, c, d],
        )?;
        for (line, times) in &of_motion.lines {
            let cells = times.map(|t| t.map_or("-".into(), |t| short(t, 2)));
            table.push([vec![line.name.to_owned()], cells.to_vec()].concat())?;
        }
        times.push(table);
    }
    report.add_table(choices)?;
    for table in times {
        report.add_table(table)?;
    }
    let text = report.text()?;
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("record/choices.txt");
    fs::write(file, &text)?;
    print!("{text}");
    Ok(())
}

/// What the methods take on a motion, in samples.
struct Timed<'m> {
    lines: Vec<(&'m Line, [Option<f64>; 4])>,
    /// The closed form, set up and sampled once.
    exact: Option<f64>,
}

fn timed<'m>(measured: &'m Measured, unit: &ClosedForm) -> Outcome<Timed<'m>> {
    let motion = &measured.motion;
    let sample =
        || (0..SAMPLES).try_for_each(|n| unit.sample((f64::from(n) + 0.5) / f64::from(SAMPLES)));
    let exact = || {
        black_box(motion.in_closed_form().transpose()?);
        Ok(())
    };
    // Those of the list; what is drawn beside them (the Euler angles) does not compete.
    let lines: Vec<&Line> = (measured.contestants())
        .filter(|line| line.key == line.method.key())
        .collect();
    let mut runs = Vec::new();
    for (l, line) in lines.iter().enumerate() {
        for (target, &error) in ASKED.iter().enumerate() {
            if let Some(run) = line.least(error) {
                let (method, setting) = (line.method, run.setting);
                let again = move || {
                    black_box(motion.problem.run(method, setting)?);
                    Ok(())
                };
                runs.push((l, target, again));
            }
        }
    }
    let mut tasks: Vec<Task> = vec![&sample, &exact];
    tasks.extend(runs.iter().map(|(_, _, run)| run as Task));
    let times = interleaved(&tasks, ROUNDS)?;
    let in_samples = |n: usize| f64::from(SAMPLES) * times[n].ratio;
    let mut all: Vec<_> = lines.into_iter().map(|line| (line, [None; 4])).collect();
    for (n, (line, target, _)) in runs.iter().enumerate() {
        all[*line].1[*target] = Some(in_samples(n + 2));
    }
    all.retain(|(_, times)| times.iter().any(Option::is_some));
    Ok(Timed {
        lines: all,
        exact: motion.in_closed_form().map(|_| in_samples(1)),
    })
}
