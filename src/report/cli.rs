//! The command line of the examples, the same for all.
//!
//! An example is an [`Example`]: a stem, a title, flags, and three functions of
//! its parameters. [`Example::main`] is its `main`; [`Example::answer`] does the
//! same without touching the terminal, for tests. This is the only part of the
//! library that prints.

use super::files::{Directories, Trajectory, failure, write_whole};
use super::{Claim, Figure, Report, Table, Verdict, json, rounded_up};
use crate::error::{Error, Result};
use clap::{Arg, ArgAction, ArgMatches, Command, error::ErrorKind, value_parser};
use std::ffi::OsString;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// A parameter that can be set on the command line.
pub struct Flag<P: 'static> {
    name: &'static str,
    unit: &'static str,
    meaning: &'static str,
    kind: Kind<P>,
}

enum Kind<P: 'static> {
    Number {
        get: fn(&P) -> Option<f64>,
        set: fn(&mut P, f64),
    },
    Choice {
        among: &'static [&'static str],
        get: fn(&P) -> &'static str,
        set: fn(&mut P, &'static str),
    },
}

impl<P> Flag<P> {
    /// `--name NUMBER`, in `unit` (`"-"` if it has none). `get` returns `None` for a
    /// parameter that is not set. NaN and infinities never reach `set`; any other
    /// check belongs to the example's `report`.
    pub const fn number(
        name: &'static str,
        unit: &'static str,
        meaning: &'static str,
        get: fn(&P) -> Option<f64>,
        set: fn(&mut P, f64),
    ) -> Self {
        Self {
            name,
            unit,
            meaning,
            kind: Kind::Number { get, set },
        }
    }

    /// `--name WORD`, one of the words in `among`.
    pub const fn choice(
        name: &'static str,
        meaning: &'static str,
        among: &'static [&'static str],
        get: fn(&P) -> &'static str,
        set: fn(&mut P, &'static str),
    ) -> Self {
        Self {
            name,
            unit: "-",
            meaning,
            kind: Kind::Choice { among, get, set },
        }
    }

    /// The name, without the dashes.
    pub fn name(&self) -> &'static str {
        self.name
    }

    fn printed(&self, parameters: &P) -> String {
        match &self.kind {
            Kind::Number { get, .. } => get(parameters).map_or("-".into(), super::number::exactly),
            Kind::Choice { get, .. } => get(parameters).into(),
        }
    }

    fn arg(&self, defaults: &P) -> Arg {
        let default = self.printed(defaults);
        let unit = match (self.unit, default.as_str()) {
            ("-", "-") => String::new(),
            ("-", _) => format!(" [{default}]"),
            (unit, "-") => format!(", in {unit}"),
            (unit, _) => format!(" [{default} {unit}]"),
        };
        let arg = Arg::new(self.name)
            .long(self.name)
            .help(format!("{}{unit}", self.meaning));
        match &self.kind {
            Kind::Number { .. } => arg.value_name("NUMBER").value_parser(number),
            Kind::Choice { among, .. } => arg
                .value_name("WORD")
                .value_parser(clap::builder::PossibleValuesParser::new(*among)),
        }
    }

    fn apply(&self, matches: &ArgMatches, parameters: &mut P) {
        match &self.kind {
            Kind::Number { set, .. } => {
                if let Some(&value) = matches.get_one::<f64>(self.name) {
                    set(parameters, value);
                }
            }
            Kind::Choice { among, set, .. } => {
                let word = matches.get_one::<String>(self.name);
                if let Some(word) = among.iter().find(|w| word.is_some_and(|given| given == *w)) {
                    set(parameters, word);
                }
            }
        }
    }
}

fn number(text: &str) -> core::result::Result<f64, String> {
    match text.parse::<f64>() {
        Ok(value) if value.is_finite() => Ok(value),
        Ok(value) => Err(format!("{value} is not a finite number")),
        Err(_) if text.contains(',') => {
            Err("it is not a number: decimals come after a point, thousands are not parted".into())
        }
        Err(_) => Err("it is not a number".into()),
    }
}

/// Joins a negative number to the flag before it: clap would take `-5.0e-1` for a flag.
fn joined(arguments: impl Iterator<Item = OsString>) -> Vec<OsString> {
    let mut all: Vec<OsString> = Vec::new();
    for argument in arguments {
        let text = argument.to_str().unwrap_or("");
        let negative = text.starts_with('-') && text.parse::<f64>().is_ok();
        let flag = |last: &&mut OsString| {
            last.to_str()
                .is_some_and(|l| l.starts_with("--") && !l.contains('='))
        };
        match all.last_mut().filter(flag) {
            Some(last) if negative => {
                last.push("=");
                last.push(argument);
            }
            _ => all.push(argument),
        }
    }
    all
}

/// `KEY=VALUE`, a reader's answer.
fn key_and_number(text: &str) -> core::result::Result<(String, f64), String> {
    let (key, value) = (text.split_once('='))
        .filter(|(key, _)| !key.trim().is_empty())
        .ok_or("write KEY=VALUE")?;
    Ok((key.trim().into(), number(value.trim())?))
}

/// An example: its name everywhere, what it can be told, and what it computes.
///
/// ```
/// use rotation_dynamics::report::{cli::{Example, Flag}, Claim, Oracle, Report, Trajectory};
/// use rotation_dynamics::{Error, Result};
///
/// #[derive(Clone)]
/// struct Parameters { length: f64 }
/// impl Default for Parameters {
///     fn default() -> Self { Self { length: 3.0 } }
/// }
/// fn report(p: &Parameters) -> Result<Report> {
///     if p.length <= 0.0 {
///         return Err(Error::OutOfRange { name: "length", value: p.length, allowed: "it must be greater than 0" });
///     }
///     let mut report = Report::new("A rod", "a thin rod about its middle")?;
///     let i = p.length * p.length / 12.0;
///     report.add_claim(Claim::new("inertia", "moment of inertia over mass", i, "m^2", 1e-15,
///         Oracle::new("end, moved to the middle", p.length * p.length / 3.0 - p.length * p.length / 4.0))?)?;
///     Ok(report)
/// }
/// const EXAMPLE: Example<Parameters> = Example {
///     stem: "rod",
///     about: "A thin rod about its middle",
///     flags: &[Flag::number("length", "m", "length of the rod", |p| Some(p.length), |p, x| p.length = x)],
///     report,
///     figures: |_| Ok(Vec::new()),
///     trajectory: |_| Trajectory::new(["t [s]"]),
/// };
/// let outcome = EXAMPLE.answer(["--length", "6", "--check", "inertia=3.0"]);
/// assert_eq!((outcome.code, outcome.stdout.as_str()), (0, "right: inertia = 3.00000000000000 m^2\n"));
/// assert_eq!(EXAMPLE.answer(["--length", "-6"]).code, 2);
/// ```
pub struct Example<P: 'static> {
    /// The stem that names the page, the example and the snapshot.
    pub stem: &'static str,
    /// One line for `--help`.
    pub about: &'static str,
    /// The parameters that can be set, in the order in which they are listed.
    pub flags: &'static [Flag<P>],
    /// The numbers. Checks the parameters: it runs before anything else.
    pub report: fn(&P) -> Result<Report>,
    /// The drawings.
    pub figures: fn(&P) -> Result<Vec<Figure>>,
    /// The motion, for `--csv`.
    pub trajectory: fn(&P) -> Result<Trajectory>,
}

/// What a run would print and return.
#[derive(Debug, Clone, PartialEq)]
pub struct Outcome {
    /// For standard output.
    pub stdout: String,
    /// For standard error.
    pub stderr: String,
    /// The exit code: 0, 1 for an answer judged not right, 2 for an error.
    pub code: u8,
}

impl Outcome {
    fn refused(reason: impl core::fmt::Display) -> Self {
        Self {
            stdout: String::new(),
            stderr: format!("error: {reason}\n"),
            code: 2,
        }
    }
}

impl<P: Default> Example<P> {
    /// Runs the example with the arguments of the process.
    pub fn main(&self) -> ExitCode {
        let outcome = self.answer(std::env::args_os().skip(1));
        // A reader that has gone away (`| head`) is no failure of ours.
        let _ = std::io::stdout().write_all(outcome.stdout.as_bytes());
        let _ = std::io::stdout().flush();
        let _ = std::io::stderr().write_all(outcome.stderr.as_bytes());
        ExitCode::from(outcome.code)
    }

    /// The default output and the answer box's data, which the snapshot locks, and the figures.
    ///
    /// # Errors
    /// Those of the example's functions; none for a sound example.
    pub fn locked(&self) -> Result<(String, Vec<Figure>)> {
        let parameters = P::default();
        let text = self.report_with_parameters(&parameters)?.text()?;
        Ok((text, (self.figures)(&parameters)?))
    }

    /// What the example prints for these arguments (without the program's name).
    /// Files asked for with `--csv` and `--svg` are written, all whole or none.
    pub fn answer<A: Into<OsString> + Clone>(
        &self,
        arguments: impl IntoIterator<Item = A>,
    ) -> Outcome {
        let arguments = joined(arguments.into_iter().map(Into::into));
        let name = core::iter::once(OsString::from(self.stem));
        let matches = match self.command().try_get_matches_from(name.chain(arguments)) {
            Ok(matches) => matches,
            Err(told) if told.kind() == ErrorKind::DisplayHelp => {
                return Outcome {
                    stdout: told.render().to_string(),
                    stderr: String::new(),
                    code: 0,
                };
            }
            Err(error) => {
                return Outcome {
                    stdout: String::new(),
                    stderr: error.render().to_string(),
                    code: 2,
                };
            }
        };
        let mut parameters = P::default();
        for flag in self.flags {
            flag.apply(&matches, &mut parameters);
        }
        self.run(&parameters, &matches)
            .unwrap_or_else(Outcome::refused)
    }

    fn command(&self) -> Command {
        let defaults = P::default();
        let mut command = Command::new(self.stem)
            .bin_name(format!("cargo run --example {} --", self.stem))
            .about(self.about)
            .disable_version_flag(true)
            .next_help_heading("Parameters");
        for flag in self.flags {
            command = command.arg(flag.arg(&defaults));
        }
        command
            .next_help_heading("Output")
            .arg(
                Arg::new("check")
                    .long("check")
                    .value_name("KEY=VALUE")
                    .help("Judge your answer (may be given several times)")
                    .action(ArgAction::Append)
                    .value_parser(key_and_number),
            )
            .arg(
                Arg::new("json")
                    .long("json")
                    .help("Print the claims as JSON")
                    .action(ArgAction::SetTrue)
                    .conflicts_with("check"),
            )
            .arg(
                Arg::new("csv")
                    .long("csv")
                    .value_name("FILE")
                    .help("Write the motion as CSV")
                    .value_parser(value_parser!(PathBuf)),
            )
            .arg(
                Arg::new("svg")
                    .long("svg")
                    .value_name("DIR")
                    .help("Write the figures as SVG")
                    .value_parser(value_parser!(PathBuf)),
            )
    }

    fn report_with_parameters(&self, parameters: &P) -> Result<Report> {
        let mut report = (self.report)(parameters)?;
        let mut table = Table::headed("parameters", ["flag", "value", "unit", "meaning"])?;
        for flag in self.flags {
            // What is not set has no place among the numbers of this run; --help lists it.
            let value = flag.printed(parameters);
            if value == "-" {
                continue;
            }
            table.push([
                format!("--{}", flag.name),
                value,
                flag.unit.into(),
                flag.meaning.into(),
            ])?;
        }
        report.set_parameters(table);
        Ok(report)
    }

    fn run(&self, parameters: &P, matches: &ArgMatches) -> Result<Outcome> {
        let report = self.report_with_parameters(parameters)?;
        let mut outcome = Outcome {
            stdout: String::new(),
            stderr: String::new(),
            code: 0,
        };
        if let Some(answers) = matches.get_many::<(String, f64)>("check") {
            for (key, value) in answers {
                let (line, right) = judged(&report, key, *value)?;
                outcome.stdout += &line;
                outcome.code |= u8::from(!right);
            }
        } else if matches.get_flag("json") {
            outcome.stdout = json::claims(self.stem, &report);
        } else {
            outcome.stdout = report.output()?;
        }
        outcome.stderr = self.write_files(parameters, matches)?;
        Ok(outcome)
    }

    /// Writes what `--csv` and `--svg` ask for; returns a line for each.
    fn write_files(&self, parameters: &P, matches: &ArgMatches) -> Result<String> {
        let mut files = Vec::new();
        let mut told = String::new();
        let mut made = Directories::default();
        if let Some(path) = matches.get_one::<PathBuf>("csv") {
            let trajectory = (self.trajectory)(parameters)?;
            told += &format!(
                "wrote {} samples to {}\n",
                trajectory.rows().len(),
                path.display()
            );
            files.push((path.clone(), trajectory.csv()));
        }
        if let Some(directory) = matches.get_one::<PathBuf>("svg") {
            let figures = (self.figures)(parameters)?;
            made = Directories::missing(directory);
            std::fs::create_dir_all(directory).map_err(|e| failure(directory, &e))?;
            told += &format!(
                "wrote {} figures to {}\n",
                figures.len(),
                directory.display()
            );
            for figure in figures {
                files.push((self.figure_path(directory, &figure.name), figure.svg));
            }
        }
        let files: Vec<(PathBuf, &str)> = files.iter().map(|(p, c)| (p.clone(), &**c)).collect();
        write_whole(&files)?;
        made.keep();
        Ok(told)
    }

    /// `DIR/STEM__NAME.svg`, as in the locked figures.
    fn figure_path(&self, directory: &Path, name: &str) -> PathBuf {
        directory.join(format!("{}__{name}.svg", self.stem))
    }
}

fn judged(report: &Report, key: &str, answer: f64) -> Result<(String, bool)> {
    let claim: &Claim = report.claim(key).ok_or_else(|| {
        let keys: Vec<&str> = report.claims().iter().map(Claim::key).collect();
        Error::UnknownKey {
            key: key.into(),
            known: keys.join(", "),
        }
    })?;
    let unit = if claim.unit() == "-" {
        String::new()
    } else {
        format!(" {}", claim.unit())
    };
    Ok(match claim.verdict(answer) {
        Verdict::Right => (format!("right: {key} = {}{unit}\n", claim.printed()), true),
        Verdict::RightTo(n) => (
            format!(
                "nearly: your {key} is right to {n} digits; asked for is a relative error of {}\n",
                rounded_up(claim.tolerance())
            ),
            false,
        ),
        Verdict::Slip(hint) => (format!("not yet: your {key} is not right: {hint}\n"), false),
        Verdict::Wrong => (format!("not yet: your {key} is not right\n"), false),
    })
}
