//! Times of the lines of the pages' accuracy strips, a group for each page, and their records
//! `benches/record/strips/STEM.txt`, from which the book takes the column "time".
//!
//! ```text
//! PAGES=STEM cargo bench -p benches --bench strips
//! ```
//!
//! Without `PAGES`, all pages. The unit is one sample of the scene's closed form: the mean over
//! times spread evenly over the motion. A line is not timed before it is shown to deliver the
//! error of the strip.

use benches::record::{self, Outcome, ProcessorTime, SAMPLES, sample};
use criterion::Criterion;
use kit::{Computation, Page, Price, Table, rounded_up, short};

/// Intervals of confidence that are wider than this tell of a machine with other things to do.
const UNQUIET: f64 = 1.2;

const UNIT: &str = "one sample of the closed form";

fn main() -> Outcome<()> {
    let mut criterion = record::criterion();
    for page in pages::ALL {
        strip(&mut criterion, *page)?;
    }
    criterion.final_summary();
    Ok(())
}

/// A line's name in its group.
fn name(price: &Price) -> String {
    let requested = price.requested.map_or("-".into(), rounded_up);
    format!("{}/{requested}", price.method)
}

/// Times the strip of a page and writes its record.
fn strip(criterion: &mut Criterion<ProcessorTime>, page: &dyn Page) -> Outcome<()> {
    let (stem, report) = (page.stem(), page.report()?);
    // A line that is read off a run of another kind has a dash for its time.
    let lines: Vec<(&Price, &Computation)> = (report.prices()?.into_iter())
        .filter_map(|price| Some((price, price.again.as_ref()?)))
        .collect();
    let Some(closed_form) = report.closed_form().filter(|_| !lines.is_empty()) else {
        eprintln!("{stem}: no closed form to be the unit, or no line that can be run again");
        return Ok(());
    };
    for (price, again) in &lines {
        let (error, claimed, line) = (again.error()?, price.delivered, name(price));
        if error != claimed {
            Err(format!("{stem}: {line} delivers {error:e}, not the {claimed:e} of its strip"))?;
        }
    }

    let mut group = criterion.benchmark_group(stem);
    group.bench_function(UNIT, |b| b.iter(|| sample(closed_form)));
    for (price, again) in &lines {
        group.bench_function(name(price), |b| b.iter(|| again.run()));
    }
    group.finish();

    let about = [
        &format!("Times of the accuracy strip of {stem}"),
        "In units of one sample of the scene's closed form, with intervals of 95 % confidence",
        &format!("PAGES={stem} cargo bench -p benches --bench strips"),
    ];
    record::write(&format!("strips/{stem}"), about, |times| {
        let unit = times.of(&format!("{stem}/{UNIT}"))?.median / f64::from(SAMPLES);
        let columns = "method, requested, delivered, work, time, interval";
        let mut strip = Table::new("strip", columns.split(", "))?;
        for (price, _) in &lines {
            let line = name(price);
            let time = times.of(&format!("{stem}/{line}"))?.per(unit);
            let [lower, upper] = time.interval;
            if upper > UNQUIET * lower {
                let interval = format!("{lower:.3e} to {upper:.3e} samples");
                Err(format!("'{line}' takes {interval}; measure on a quieter machine"))?;
            }
            strip.push([
                price.method.clone(),
                price.requested.map_or("-".into(), rounded_up),
                rounded_up(price.delivered),
                price.work.clone(),
                short(time.median, 2),
                format!("{} to {}", short(lower, 2), short(upper, 2)),
            ])?;
        }
        let one = Table::new("unit", ["what", "ns"])?.row([UNIT, &short(unit, 2)])?;
        Ok(vec![one, strip])
    })
}
