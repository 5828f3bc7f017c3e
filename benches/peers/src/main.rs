//! Runs the races and writes `benches/record/peers.txt` and `peers_open.txt`, from which pages
//! take their tables; with `closed` or `open` one of them, with the name of a
//! problem none: then its table is printed.
//!
//! ```text
//! cargo run --release --manifest-path benches/peers/Cargo.toml -- open
//! ```

use benches::timing::{Task, interleaved};
use benches::{OPEN_RECORD, RECORD, path};
use peers::open::OPEN;
use peers::open_record;
use peers::problem::{PROBLEMS, Problem};
use peers::race::{Race, along_the_way, to_the_end};
use peers::record::{DENSE, Races, text};
use std::hint::black_box;
use std::process::ExitCode;
use std::{env, fs};

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}

fn run() -> Result<(), String> {
    match env::args().nth(1).as_deref() {
        None => {
            closed()?;
            open()?;
        }
        Some("closed") => closed()?,
        Some("open") => open()?,
        Some(key) => {
            let problem = Problem::named(key).ok_or(format!("no problem {key}"))?;
            print!("{}", open_record::of_one(problem, &to_the_end(problem)?)?);
            return Ok(());
        }
    }
    Ok(())
}

/// The races on motions with a closed form.
fn closed() -> Result<(), String> {
    let mut races = Races { ends: Vec::new(), dense: Vec::new(), late: late()? };
    for problem in &PROBLEMS {
        races.ends.push(run_to_the_end(problem)?);
    }
    for key in DENSE {
        eprintln!("dense output: {key}");
        let problem = Problem::named(key).ok_or(format!("no problem {key}"))?;
        races.dense.push(along_the_way(problem)?);
    }
    write(RECORD, &text(&races)?)
}

/// The races on motions without one.
fn open() -> Result<(), String> {
    let mut races = Vec::new();
    for problem in &OPEN {
        let race = run_to_the_end(problem)?;
        eprint!("{}", open_record::of_one(problem, &race)?);
        races.push(race);
    }
    write(OPEN_RECORD, &open_record::text(&races)?)
}

fn run_to_the_end(problem: &'static Problem) -> Result<Race, String> {
    eprintln!("{}: {}", problem.key, problem.title);
    to_the_end(problem)
}

fn write(file: &str, text: &str) -> Result<(), String> {
    fs::write(path(file), text).map_err(|e| format!("{file}: {e}"))
}

/// One sample of the heavy top after 1e6 periods, in units of one after 1 period.
fn late() -> Result<f64, String> {
    let problem = Problem::named("heavy_top").ok_or("no heavy top")?;
    let exact = &problem.exact().map_err(|e| e.to_string())?;
    // One closure for both numbers: compiled for each, the two would differ by up to a third.
    let samples = [1.0, 1e6].map(|periods| {
        move || {
            // Times that differ, so that no branch is learnt by heart.
            for n in 0..64 {
                let t = (periods + f64::from(n) / 64.0) * problem.period;
                black_box(exact.attitude(black_box(t)));
            }
            Ok(())
        }
    });
    let tasks = samples.each_ref().map(|task| task as Task);
    let measured = interleaved(&tasks, 501).map_err(|e| e.to_string())?;
    Ok(measured[1].ratio)
}
