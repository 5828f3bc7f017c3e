//! Runs the races and writes `benches/record/peers.txt`, from which pages and the README
//! take their tables.
//!
//! ```text
//! cargo run --release --manifest-path benches/peers/Cargo.toml -- --date 2026-11-21
//! ```

use benches::conditions::Conditions;
use benches::readme::{RECORD, path, tables, with_tables};
use benches::timing::{Clock, Task, interleaved_by};
use peers::problem::{PROBLEMS, Problem};
use peers::race::{along_the_way, to_the_end};
use peers::record::{DENSE, Races, text};
use rotation_dynamics::report::parse;
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
    let conditions = Conditions::read("peers", env::args().skip(1)).map_err(|e| e.to_string())?;
    let mut races = Races {
        ends: Vec::new(),
        dense: Vec::new(),
        late: late()?,
    };
    for problem in &PROBLEMS {
        eprintln!("{}: {}", problem.key, problem.title);
        races.ends.push(to_the_end(problem)?);
    }
    for key in DENSE {
        eprintln!("dense output: {key}");
        let problem = Problem::named(key).ok_or(format!("no problem {key}"))?;
        races.dense.push(along_the_way(problem)?);
    }
    let text = text(&conditions, &races)?;
    write(RECORD, &text)?;
    print!("{text}");
    let parsed = parse(&text).map_err(|e| e.to_string())?;
    let old = fs::read_to_string(path("README.md")).map_err(|e| e.to_string())?;
    write("README.md", &with_tables(&old, &tables(&parsed)?)?)
}

fn write(file: &str, text: &str) -> Result<(), String> {
    fs::write(path(file), text).map_err(|e| format!("{file}: {e}"))
}

/// One sample of the heavy top after 1e6 periods, in units of one after 1 period.
fn late() -> Result<f64, String> {
    let problem = Problem::named("heavy_top").ok_or("no heavy top")?;
    let exact = problem.exact().map_err(|e| e.to_string())?;
    let sample = |periods: f64| {
        // Times that differ, so that no branch is learnt by heart.
        for n in 0..64 {
            let t = (periods + f64::from(n) / 64.0) * problem.period;
            black_box(exact.attitude(black_box(t)));
        }
        Ok(())
    };
    let (early, late) = (|| sample(1.0), || sample(1e6));
    let tasks: [Task; 2] = [&early, &late];
    let measured = interleaved_by(Clock::Thread, &tasks, 501).map_err(|e| e.to_string())?;
    Ok(measured[1].ratio)
}
