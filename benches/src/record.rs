//! Records of times: criterion measures, and what it estimates is written into
//! `benches/record/NAME.txt`, with the machine, the compiler and the date.

use crate::timing::now;
use criterion::Criterion;
use criterion::measurement::{Measurement, ValueFormatter, WallTime};
use kit::{ClosedForm, Report, Table};
use serde_json::Value;
use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::LazyLock;
use std::time::{Duration, SystemTime};
use std::{env, error, fs};

pub type Outcome<T> = Result<T, Box<dyn error::Error>>;

/// When this run began: estimates of earlier runs are not recorded.
static BEGUN: LazyLock<SystemTime> = LazyLock::new(SystemTime::now);

/// Samples of a closed form in one run of a bench; the mean of one is the unit of times.
pub const SAMPLES: u32 = 64;

/// Samples at times spread evenly over the motion.
///
/// # Errors
/// Those of the closed form.
pub fn sample(form: &ClosedForm) -> kit::Result<()> {
    (0..SAMPLES).try_for_each(|n| form.sample((f64::from(n) + 0.5) / f64::from(SAMPLES)))
}

/// The time that this thread had a processor, by which criterion measures, since a machine has
/// other things to do.
pub struct ProcessorTime;

impl Measurement for ProcessorTime {
    type Intermediate = f64;
    type Value = f64;

    fn start(&self) -> f64 {
        now()
    }

    fn end(&self, start: f64) -> f64 {
        now() - start
    }

    fn add(&self, one: &f64, other: &f64) -> f64 {
        one + other
    }

    fn zero(&self) -> f64 {
        0.0
    }

    fn to_f64(&self, seconds: &f64) -> f64 {
        1e9 * seconds
    }

    fn formatter(&self) -> &dyn ValueFormatter {
        WallTime.formatter()
    }
}

/// Criterion, set so that some hundred benches take minutes.
pub fn criterion() -> Criterion<ProcessorTime> {
    LazyLock::force(&BEGUN);
    Criterion::default()
        .sample_size(20)
        .warm_up_time(Duration::from_millis(100))
        .measurement_time(Duration::from_millis(500))
        .nresamples(2000)
        .without_plots()
        .with_measurement(ProcessorTime)
        .output_directory(&home())
        .configure_from_args()
}

/// Where the estimates are: `criterion` in the directory for which this program was built.
fn home() -> PathBuf {
    let program = env::current_exe().unwrap_or_default();
    program.ancestors().nth(3).map_or("criterion".into(), |target| target.join("criterion"))
}

/// The time of one run as criterion estimates it, ns.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Time {
    /// The median of the samples.
    pub median: f64,
    /// In which the median is, with a confidence of 95 %.
    pub interval: [f64; 2],
}

impl Time {
    /// The time in these units (ns).
    pub fn per(self, unit: f64) -> Self {
        Self { median: self.median / unit, interval: self.interval.map(|end| end / unit) }
    }
}

/// The estimates of this run.
pub struct Times(HashMap<String, Time>);

impl Times {
    /// Those below `home` that were written after `begun`.
    fn read(home: &Path, begun: SystemTime) -> Outcome<Self> {
        let (mut times, mut left) = (HashMap::new(), vec![home.to_owned()]);
        while let Some(directory) = left.pop() {
            let json = |name: &str| -> Outcome<Value> {
                Ok(serde_json::from_str(&fs::read_to_string(directory.join(name))?)?)
            };
            let found = directory.join("estimates.json");
            if directory.ends_with("new") && fs::metadata(found)?.modified()? >= begun {
                let median = &json("estimates.json")?["median"];
                let number = |value: &Value| value.as_f64().ok_or("criterion's file has changed");
                let interval = &median["confidence_interval"];
                let [lower, upper] = [&interval["lower_bound"], &interval["upper_bound"]];
                let time = Time {
                    median: number(&median["point_estimate"])?,
                    interval: [number(lower)?, number(upper)?],
                };
                let name = json("benchmark.json")?["full_id"].take();
                times.insert(name.as_str().unwrap_or_default().to_owned(), time);
            }
            for entry in fs::read_dir(&directory).into_iter().flatten() {
                left.extend(Some(entry?.path()).filter(|path| path.is_dir()));
            }
        }
        Ok(Self(times))
    }

    /// The time of a bench, by its full name: `group/function/parameter`.
    ///
    /// # Errors
    /// This run has not measured it.
    pub fn of(&self, bench: &str) -> Outcome<Time> {
        let time = self.0.get(bench).copied();
        Ok(time.ok_or_else(|| format!("'{bench}' was not measured in this run"))?)
    }
}

/// Writes the record of this name with these tables, and prints it; `again` is the command that
/// does so. Leaves the record as it was, and says why, if `tables` fails: a bench that it asks for
/// was not measured, or not well. Says nothing if no bench was.
///
/// # Errors
/// A file that cannot be read or written, a machine that does not say what it is.
pub fn write(
    name: &str,
    [title, description, again]: [&str; 3],
    tables: impl FnOnce(&Times) -> Outcome<Vec<Table>>,
) -> Outcome<()> {
    let times = Times::read(&home(), *BEGUN)?;
    if times.0.is_empty() {
        return Ok(());
    }
    let tables = match tables(&times) {
        Ok(tables) => tables,
        Err(error) => {
            eprintln!("the record {name} stays as it was: {error}");
            return Ok(());
        }
    };
    let quick = match env::args().any(|argument| argument == "--quick") {
        true => ", of two samples (--quick)",
        false => "",
    };
    let description = format!(
        "{description}; medians by criterion{quick}; measured, not locked. Measure again: {again}"
    );
    let mut report = Report::new(title, description)?;
    report.add(conditions()?)?;
    for table in tables {
        report.add(table)?;
    }
    save(name, &report)
}

/// Writes a report as the record of this name, and prints it.
///
/// # Errors
/// A file that cannot be written.
pub fn save(name: &str, report: &Report) -> Outcome<()> {
    let (text, record) = (report.text()?, concat!(env!("CARGO_MANIFEST_DIR"), "/record"));
    fs::write(format!("{record}/{name}.txt"), &text)?;
    print!("{text}");
    Ok(())
}

/// The table `conditions` of a record: processor, compiler and date.
///
/// # Errors
/// A machine that does not say what it is.
pub fn conditions() -> Outcome<Table> {
    let mut table = Table::new("conditions", ["condition", "value"])?;
    for (condition, value) in
        [("processor", processor()), ("compiler", compiler()), ("date", said_by("date", &["+%F"]))]
    {
        let value = value.ok_or(format!("the machine does not tell its {condition}"))?;
        table.push([condition, &value])?;
    }
    Ok(table)
}

fn said_by(command: &str, arguments: &[&str]) -> Option<String> {
    let said = Command::new(command).args(arguments).output().ok()?;
    let said = String::from_utf8(said.stdout).ok()?;
    (!said.trim().is_empty()).then(|| said.trim().to_owned())
}

/// The processor's model, without marks of trade.
fn processor() -> Option<String> {
    let model = match fs::read_to_string("/proc/cpuinfo") {
        Ok(text) => {
            let line = text.lines().find(|line| line.starts_with("model name"))?;
            line.split_once(':')?.1.to_owned()
        }
        Err(_) => said_by("sysctl", &["-n", "machdep.cpu.brand_string"])?,
    };
    let plain = model.replace("(R)", "").replace("(TM)", "");
    Some(plain.split_whitespace().collect::<Vec<_>>().join(" "))
}

/// `rustc 1.95.0`, without commit and date.
fn compiler() -> Option<String> {
    let version = said_by("rustc", &["--version"])?;
    let mut words = version.split(' ');
    Some(format!("{} {}", words.next()?, words.next()?))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// As criterion writes them: one bench of this run, one of an earlier run.
    #[test]
    fn estimates_of_this_run_are_read_and_no_others() {
        let home = env::temp_dir().join(format!("estimates-{}", std::process::id()));
        let begun = SystemTime::now() - Duration::from_secs(60);
        for (name, age) in [("one", 0), ("two", 120)] {
            let new = home.join("group").join(name).join("new");
            fs::create_dir_all(&new).expect("a directory");
            let id = format!(r#"{{"group_id":"group","full_id":"group/{name}"}}"#);
            fs::write(new.join("benchmark.json"), id).expect("a file");
            let estimates = r#"{"median":{"confidence_interval":{"confidence_level":0.95,
                "lower_bound":190.0,"upper_bound":230.0},"point_estimate":200.0}}"#;
            let file = new.join("estimates.json");
            fs::write(&file, estimates).expect("a file");
            let written = SystemTime::now() - Duration::from_secs(age);
            let file = fs::File::options().write(true).open(file).expect("a file");
            file.set_modified(written).expect("a time");
        }
        let times = Times::read(&home, begun).expect("estimates");
        fs::remove_dir_all(&home).expect("it was there");
        let time = times.of("group/one").expect("a time").per(100.0);
        let (median, interval) = (2.0, [1.9, 2.3]);
        assert_eq!(time, Time { median, interval });
        let missing = times.of("group/two").expect_err("an earlier run");
        assert!(missing.to_string().contains("group/two"));
    }
}
