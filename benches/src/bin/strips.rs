//! Times every line of the pages' accuracy strips and writes a record for each stem,
//! `benches/record/strips/STEM.txt`, from which the book takes the column "time".
//!
//! ```text
//! cargo run --release -p benches --bin strips -- [STEM ...] [--date 2026-11-21]
//! ```
//!
//! Without a stem, all are timed. The unit is one sample of the scene's closed form: the
//! mean over times spread evenly over the motion, measured in the same rounds. A record has
//! the grammar of a report ([`kit`]).

use benches::conditions::Conditions;
use benches::timing::{Measured, Task, interleaved};
use kit::cli::alive;
use kit::{Computation, Page, Report, Table, rounded_up, short};
use std::error::Error;
use std::path::Path;
use std::process::ExitCode;
use std::{env, fs};

/// Rounds in which everything is timed once.
const ROUNDS: usize = 501;

/// Quartiles further apart than this tell of a machine with other things to do.
const UNQUIET: f64 = 1.2;

/// Samples of the closed form in one timed run.
const SAMPLES: u32 = 64;

type Outcome<T> = Result<T, Box<dyn Error>>;

fn main() -> ExitCode {
    let (stems, flags) = parted(env::args().skip(1));
    let done = Conditions::read("strips [STEM ...]", flags.into_iter())
        .and_then(|conditions| alive(|| timed(&stems, &conditions)));
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}

/// The stems among the arguments, and the flags with their values.
fn parted(mut arguments: impl Iterator<Item = String>) -> (Vec<String>, Vec<String>) {
    let (mut stems, mut flags) = (Vec::new(), Vec::new());
    while let Some(argument) = arguments.next() {
        if argument.starts_with("--") {
            flags.push(argument);
            flags.extend(arguments.next());
        } else {
            stems.push(argument);
        }
    }
    (stems, flags)
}

/// Times the strips of `stems`, of all pages if it names none.
fn timed(stems: &[String], conditions: &Conditions) -> Outcome<()> {
    let known: Vec<&str> = pages::ALL.iter().map(|page| page.stem()).collect();
    if let Some(stem) = stems.iter().find(|stem| !known.contains(&stem.as_str())) {
        Err(format!(
            "there is no page '{stem}'; there are: {}",
            known.join(", ")
        ))?;
    }
    let asked = |page: &&&dyn Page| stems.is_empty() || stems.iter().any(|s| s == page.stem());
    let (mut asked_for, mut failed) = (0, Vec::new());
    for page in pages::ALL.iter().filter(asked) {
        asked_for += 1;
        // What one page lacks, or a noisy minute, costs no other its record.
        if let Err(error) = record(*page, conditions) {
            failed.push(error.to_string());
        }
    }
    if failed.is_empty() {
        return Ok(());
    }
    Err(format!(
        "{} of {asked_for} pages have no new record:\n{}",
        failed.len(),
        failed.join("\n")
    ))?
}

/// Times the strip of a page and writes its record.
fn record(page: &dyn Page, conditions: &Conditions) -> Outcome<()> {
    let stem = page.stem();
    let mut report = Report::new(
        format!("Times of the accuracy strip of {stem}"),
        format!(
            "In units of one sample of the scene's closed form; medians of {ROUNDS} rounds, with \
             their quartiles; measured, not locked. \
             Measure again: cargo run --release -p benches --bin strips -- {stem}"
        ),
    )?;
    report.add_table(conditions.table()?)?;
    let (unit, strip) = strip(page)?;
    let one = Table::new("unit", ["what", "ns"])?.row(["one sample of the closed form", &unit])?;
    report.add_table(one)?;
    report.add_table(strip)?;
    let text = report.text()?;
    let directory = Path::new(env!("CARGO_MANIFEST_DIR")).join("record/strips");
    fs::create_dir_all(&directory)?;
    fs::write(directory.join(format!("{stem}.txt")), &text)?;
    print!("{text}");
    Ok(())
}

/// The time of one sample of the closed form in ns, and the times of the strip in its units.
fn strip(page: &dyn Page) -> Outcome<(String, Table)> {
    let stem = page.stem();
    let report = page.report()?;
    // A line that is read off a run of another kind has a dash for its time.
    let (prices, computations): (Vec<_>, Vec<&Computation>) = report
        .prices()?
        .into_iter()
        .filter_map(|price| Some((price, price.again.as_ref()?)))
        .unzip();
    if prices.is_empty() {
        Err(format!("{stem}: no line of its strip can be run again"))?;
    }
    for (price, computation) in prices.iter().zip(&computations) {
        let error = computation.error()?;
        if error != price.delivered {
            let claimed = price.delivered;
            Err(format!(
                "{stem}: {} delivers {error:e}, not the {claimed:e} of its strip",
                price.method
            ))?;
        }
    }

    let closed_form = report
        .closed_form()
        .ok_or_else(|| format!("{stem} has no closed form to be the unit"))?;
    let unit = || (0..SAMPLES).try_for_each(|n| closed_form.sample(middle(n)));
    let runs: Vec<_> = computations.iter().map(|c| || c.run()).collect();
    let mut tasks: Vec<Task> = vec![&unit];
    tasks.extend(runs.iter().map(|run| run as Task));
    let measured = interleaved(&tasks, ROUNDS)?;

    let samples = f64::from(SAMPLES);
    let unit = short(1e9 * measured[0].seconds / samples, 2);
    let columns = [
        "method",
        "requested",
        "delivered",
        "work",
        "time",
        "quartiles",
    ];
    let mut table = Table::new("strip", columns)?;
    for (
        price,
        Measured {
            ratio, quartiles, ..
        },
    ) in prices.iter().zip(&measured[1..])
    {
        if quartiles[1] > UNQUIET * quartiles[0] {
            Err(format!(
                "{stem}: the times of {} scatter from {:.3} to {:.3} of their median, which is \
                 more than a factor {UNQUIET}; measure on a quieter machine. Nothing is written.",
                price.method,
                quartiles[0] / ratio,
                quartiles[1] / ratio,
            ))?;
        }
        let [lower, upper] = quartiles.map(|quartile| short(samples * quartile, 2));
        table.push([
            price.method.clone(),
            price.requested.map_or("-".into(), rounded_up),
            rounded_up(price.delivered),
            price.work.clone(),
            short(samples * ratio, 2),
            format!("{lower} to {upper}"),
        ])?;
    }
    Ok((unit, table))
}

/// The middle of the n-th of equal parts.
fn middle(n: u32) -> f64 {
    (f64::from(n) + 0.5) / f64::from(SAMPLES)
}
