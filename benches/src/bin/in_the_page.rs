//! What the report of each page takes in its module, in units of what it takes as a program:
//! `benches/record/in_the_page.txt`.
//!
//! ```text
//! cargo run --release -p benches --bin in_the_page
//! ```
//!
//! Processor time, the least of some runs of each, a page's both one after the other: that is why
//! criterion does not measure it. The engine is node's, and has compiled what it will before it is
//! timed.

use benches::record::{Outcome, conditions, save};
use benches::timing::now;
use kit::cli::alive;
use kit::{Page, Report, Table, short};
use pages::ALL;
use std::hint::black_box;
use std::path::Path;
use std::process::Command;

/// So long are reports of a page repeated, s; three of the longest are enough.
const SPAN: f64 = 0.5;

fn main() -> Outcome<()> {
    alive(record)
}

fn record() -> Outcome<()> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut ratios = Table::new("ratios", ["page", "times native"])?;
    let (mut all, mut sums) = (Vec::new(), [0.0, 0.0]);
    for page in ALL {
        let (native, rounds) = native(*page)?;
        let told = Command::new("node")
            .arg(root.join("tests/same_bits/pace.mjs"))
            .args([page.stem(), &rounds.to_string()])
            .output()?;
        if !told.status.success() {
            return Err(String::from_utf8_lossy(&told.stderr).into());
        }
        let module: f64 = String::from_utf8(told.stdout)?.trim().parse()?;
        eprintln!("{}: {native} s, {module} s", page.stem());
        ratios.push([page.stem(), &short(module / native, 2)])?;
        all.push(module / native);
        sums = [sums[0] + module, sums[1] + native];
    }
    all.sort_by(f64::total_cmp);
    let mut pages = Table::new("pages", ["of the pages", "times native"])?;
    for (name, ratio) in [
        ("least", all[0]),
        ("median", all[all.len() / 2]),
        ("largest", all[all.len() - 1]),
        ("all together", sums[0] / sums[1]),
    ] {
        pages.push([name, &short(ratio, 3)])?;
    }
    let mut report = Report::new(
        "Times in the page",
        "Processor time of each page's report in its module, by node, in units of the same as a \
         program; the least of at least three runs of each; measured, not locked. Measure again: \
         cargo run --release -p benches --bin in_the_page",
    )?;
    report.add(conditions()?)?;
    report.add(pages)?;
    report.add(ratios)?;
    save("in_the_page", &report)
}

/// The least processor time of a report, s, and of how many.
fn native(page: &dyn Page) -> Outcome<(f64, usize)> {
    let (mut least, mut span, mut rounds) = (f64::INFINITY, 0.0, 0);
    while span < SPAN || rounds < 3 {
        let start = now();
        black_box(page.report()?);
        let seconds = now() - start;
        least = least.min(seconds);
        span += seconds;
        rounds += 1;
    }
    Ok((least, rounds))
}
