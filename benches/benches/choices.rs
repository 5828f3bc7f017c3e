//! Which method delivers an error in the least time, motion by motion: the table with which the
//! page `accuracy` begins, `benches/record/choices.txt`.
//!
//! Every method is timed at the coarsest setting with which it delivers, as the example's sweeps
//! know it; that it does is shown once more before it is timed. The unit is one sample of the
//! closed form of the heavy top.

use benches::record::{self, Outcome, ProcessorTime, SAMPLES, sample};
use criterion::{BenchmarkId, Criterion};
use kit::draw::Method;
use kit::{ClosedForm, Table, rounded_up, short};
use pages::accuracy::lines::{Line, Measured};
use pages::accuracy::{ASKED, EXAMPLE, Parameters, prepared};

const UNIT: &str = "one sample of the heavy top";
const EXACT: &str = "closed form";

fn main() -> Outcome<()> {
    let parameters = Parameters::default();
    let example = EXAMPLE.report(&parameters)?;
    let unit = example.closed_form().ok_or("no closed form")?;
    let all = prepared(&parameters)?;
    let mut criterion = record::criterion();
    for measured in all.iter() {
        time(&mut criterion, measured, unit)?;
    }
    criterion.final_summary();
    let description = "Time to the end of each motion within an error of the attitude, in samples \
        of the closed form of the heavy top";
    let again = "cargo bench -p benches --bench choices";
    record::write("choices", ["Who is fastest", description, again], |times| {
        let asked = ASKED.map(|error| format!("{} rad", rounded_up(error)));
        let heads = |first: &'static str| first.split(", ").chain(asked.iter().map(String::as_str));
        let mut choices = Table::new("choices", heads("motion, closed form"))?;
        let mut tables = Vec::new();
        for measured in all.iter() {
            let (name, key) = (measured.motion.name, measured.motion.key);
            let unit = times.of(&format!("{name}/{UNIT}"))?.median / f64::from(SAMPLES);
            let in_samples = |bench: &str| -> Outcome<f64> {
                Ok(times.of(&format!("{name}/{bench}"))?.per(unit).median)
            };
            let mut best: [Option<(f64, &str)>; 4] = [None; 4];
            let mut table = Table::new(&format!("times_{key}"), heads("method"))?;
            for line in competing(measured) {
                let mut row = vec![line.name.to_owned()];
                for (asked, best) in ASKED.into_iter().zip(&mut best) {
                    let cell = match line.least(asked) {
                        Some(_) => {
                            let time = in_samples(&format!("{}/{asked:e}", line.name))?;
                            if best.is_none_or(|(least, _)| time < least) {
                                *best = Some((time, line.name));
                            }
                            short(time, 2)
                        }
                        None => "-".into(),
                    };
                    row.push(cell);
                }
                if row[1..].iter().any(|cell| cell != "-") {
                    table.push(row)?;
                }
            }
            let exact = match measured.motion.in_closed_form() {
                Some(_) => short(in_samples(EXACT)?, 2),
                None => "-".into(),
            };
            let best = best.map(|best| match best {
                Some((time, name)) => {
                    format!("{}: {}", Method::named(name).label(), short(time, 2))
                }
                None => "-".into(),
            });
            choices.push([&[name.to_owned(), exact][..], &best].concat())?;
            tables.push(table);
        }
        tables.insert(0, choices);
        Ok(tables)
    })
}

/// Those of the list; what is drawn beside them (the Euler angles) does not compete.
fn competing(measured: &Measured) -> impl Iterator<Item = &Line> {
    (measured.contestants()).filter(|line| line.key == line.method.key())
}

/// Times the unit, the closed form, set up and sampled once, and every method at every error.
fn time(
    criterion: &mut Criterion<ProcessorTime>,
    measured: &Measured,
    unit: &ClosedForm,
) -> Outcome<()> {
    let motion = &measured.motion;
    let mut group = criterion.benchmark_group(motion.name);
    group.bench_function(UNIT, |b| b.iter(|| sample(unit)));
    if motion.in_closed_form().transpose()?.is_some() {
        group.bench_function(EXACT, |b| b.iter(|| motion.in_closed_form()));
    }
    for line in competing(measured) {
        for asked in ASKED {
            let Some(run) = line.least(asked) else {
                continue;
            };
            let again = |setting| motion.problem.run(line.method, setting);
            let shown = motion.sweep([run.setting], again);
            let error = shown.runs().first().map_or(f64::NAN, |run| run.errors.attitude);
            if error.is_nan() || error > asked {
                Err(format!("{}: {} delivers {error:e}, not {asked:e}", motion.name, line.name))?;
            }
            let id = BenchmarkId::new(line.name, format!("{asked:e}"));
            group.bench_function(id, |b| b.iter(|| again(run.setting)));
        }
    }
    group.finish();
    Ok(())
}
