//! The command line of the examples, the same for all.
//!
//! [`Example::main`] is the `main` of an [`Example`]; [`Example::answer`] does the
//! same without touching the terminal, for tests. This is the only part of the
//! library that prints.

use super::example::{Run, figures, report};
pub use super::files::write_whole;
use super::files::{Directories, failure};
use super::number::exactly;
use super::parameters::Settings;
use super::recorded::{Asked, Recorded, recorded};
use super::{Answer, Claim, Example, Figure, Flag, ParameterSet, Report, Trajectory, Verdict};
use crate::error::{Error, Result};
use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::parser::ValueSource;
use clap::{Arg, ArgAction, ArgMatches, Command, value_parser};
use std::ffi::OsString;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// What a flag may be, in brackets: its default, its unit and its range, as far as it has them and its
/// meaning does not tell.
fn brackets(flag: &Flag, default: Option<&str>) -> String {
    let unit = match flag.unit() {
        "-" => String::new(),
        unit => format!(" {unit}"),
    };
    let range = flag.allowed_words().filter(|_| !flag.meaning().contains(": from "));
    let range = range.map(|range| {
        let short = range.strip_prefix("it must be ").map(str::to_owned);
        short.unwrap_or(range)
    });
    match (default, range) {
        (Some(default), Some(range)) => format!(" [{default}{unit}; {range}]"),
        (Some(default), None) => format!(" [{default}{unit}]"),
        (None, Some(range)) if unit.is_empty() => format!(" [{range}]"),
        (None, Some(range)) => format!(", in{unit} [{range}]"),
        (None, None) if unit.is_empty() => unit,
        (None, None) => format!(", in{unit}"),
    }
}

fn arg(flag: &Flag, defaults: &dyn Settings) -> Arg {
    let brackets = brackets(flag, flag.printed(defaults).as_deref());
    let arg = Arg::new(flag.name()).long(flag.name()).help(format!("{}{brackets}", flag.meaning()));
    if flag.words().is_empty() {
        let unit = flag.unit();
        arg.value_name("NUMBER").value_parser(move |text: &str| number(text, unit))
    } else {
        arg.value_name("WORD").value_parser(clap::builder::PossibleValuesParser::new(flag.words()))
    }
}

/// The effects of an example, of which `--with` puts in and `--without` leaves out.
fn effects(flags: &[Flag]) -> impl Iterator<Item = &Flag> {
    flags.iter().filter(|flag| flag.usual().is_some())
}

/// The other flags.
fn parameters(flags: &[Flag]) -> impl Iterator<Item = &Flag> {
    flags.iter().filter(|flag| flag.usual().is_none())
}

/// `--with` and `--without`, with a line for each effect; out of sight if there is none.
fn effect_args(defaults: &dyn Settings) -> [Arg; 2] {
    let (mut list, mut present) = (String::new(), Vec::new());
    for flag in effects(defaults.flags()) {
        let usual = exactly(flag.usual().unwrap_or_default());
        let (name, meaning, brackets) = (flag.name(), flag.meaning(), brackets(flag, Some(&usual)));
        list += &format!("\n  {name}: {meaning}{brackets}");
        if flag.printed(defaults).is_some() {
            present.push(name);
        }
    }
    let out = match present.is_empty() {
        true => "Leave an effect out".into(),
        false => format!("Leave an effect out; in without this: {}", present.join(", ")),
    };
    let arg = |name: &'static str, value: &'static str, help: String| {
        let arg = Arg::new(name).long(name).value_name(value).help(help);
        arg.action(ArgAction::Append).hide(list.is_empty())
    };
    let put = format!("Put an effect in, with its usual strength or with VALUE:{list}");
    [arg(WITH, "NAME[=VALUE]", put), arg(WITHOUT, "NAME", out)]
}

const WITH: &str = "with";
const WITHOUT: &str = "without";

/// Puts in and leaves out the effects that are named, each once.
fn put_in(matches: &ArgMatches, parameters: &mut dyn Settings) -> core::result::Result<(), String> {
    let flags = parameters.flags();
    let mut named: Vec<(&str, &str)> = Vec::new();
    let typed = |how| matches.get_many::<String>(how).into_iter().flatten();
    let put = typed(WITH).map(|effect| match effect.split_once('=') {
        None => (&**effect, WITH, None),
        Some((name, strength)) => (name, WITH, Some(strength)),
    });
    let left = typed(WITHOUT).map(|name| (&**name, WITHOUT, None));
    for (name, how, strength) in put.chain(left) {
        let effect = effects(flags).find(|flag| flag.name() == name);
        let flag = effect.ok_or_else(|| no_effect(flags, name))?;
        match named.iter().find(|(known, _)| *known == name) {
            Some((_, other)) if *other == how => {
                return Err(format!("the effect {name} stands twice after --{how}"));
            }
            Some(_) => {
                return Err(format!(
                    "the effect {name} stands after --{WITH} and after --{WITHOUT}: is it in or out?"
                ));
            }
            None => named.push((name, how)),
        }
        let strength = match strength {
            Some(text) => {
                number(text, flag.unit()).map_err(|why| format!("--{WITH} {name}={text}: {why}"))?
            }
            None => flag.usual().unwrap_or_default(),
        };
        match how {
            WITH => flag.set_number(parameters, strength),
            _ => flag.leave_out(parameters),
        }
    }
    Ok(())
}

/// What is said to an effect that the example does not have.
fn no_effect(flags: &[Flag], name: &str) -> String {
    let known: Vec<String> = effects(flags).map(Flag::name).collect();
    if known.is_empty() {
        return format!(
            "there is no effect '{name}': this example has none to put in or leave out"
        );
    }
    let near = known.iter().map(|known| (changes(name, known), known)).min();
    let near = near.filter(|(changes, _)| *changes <= 1 + name.len() / 3);
    let near = near.map_or(String::new(), |(_, known)| format!("; do you mean {known}?"));
    format!("there is no effect '{name}'; there are: {}{near}", known.join(", "))
}

/// How many letters one adds, drops or exchanges to make one word of the other (Levenshtein).
fn changes(word: &str, other: &str) -> usize {
    let other: Vec<char> = other.chars().collect();
    let mut row: Vec<usize> = (0..=other.len()).collect();
    for (i, a) in word.chars().enumerate() {
        let mut diagonal = core::mem::replace(&mut row[0], i + 1);
        for (j, b) in other.iter().enumerate() {
            let exchanged = diagonal + usize::from(a != *b);
            diagonal = row[j + 1];
            row[j + 1] = exchanged.min(diagonal + 1).min(row[j] + 1);
        }
    }
    row[other.len()]
}

/// Sets the flag to what is typed for it, if anything is.
fn set_typed(flag: &Flag, matches: &ArgMatches, parameters: &mut dyn Settings) {
    let name = flag.name();
    if flag.words().is_empty() {
        if let Some(number) = matches.get_one::<f64>(&name) {
            flag.set_number(parameters, *number);
        }
    } else if let Some(word) = matches.get_one::<String>(&name) {
        flag.set_word(parameters, word);
    }
}

/// A number as a reader gives it, in the unit of its flag.
fn number(text: &str, unit: &str) -> core::result::Result<f64, String> {
    // Written out, as programs do.
    if let Ok(value) = text.parse::<f64>()
        && !value.is_finite()
    {
        return Err(format!("{value} is not a finite number"));
    }
    Answer::read(text)?.in_unit(unit)
}

/// Joins a negative number to the flag before it: clap would take `-5.0e-1` for a flag.
pub fn joined(arguments: impl IntoIterator<Item = OsString>) -> Vec<OsString> {
    let mut all: Vec<OsString> = Vec::new();
    for argument in arguments {
        let text = argument.to_str().unwrap_or("");
        let number = || text.parse::<f64>().is_ok() || Answer::read(text).is_ok();
        let negative = text.starts_with('-') && !text.starts_with("--") && number();
        let flag = |last: &&mut OsString| {
            last.to_str().is_some_and(|l| l.starts_with("--") && !l.contains('='))
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

/// How to name an effect, to those who typed it as a flag of its own.
fn hint(error: &clap::Error, flags: &[Flag]) -> String {
    let Some(ContextValue::String(typed)) = error.get(ContextKind::InvalidArg) else {
        return String::new();
    };
    if typed.trim_start_matches("--") == RECORDING {
        return "\nthis example reads no recordings\n".into();
    }
    let named = effects(flags).find(|flag| typed.trim_start_matches("--") == flag.name());
    named.map_or(String::new(), |flag| {
        let name = flag.name();
        format!("\n{name} is an effect: --{WITH} {name}=VALUE or --{WITHOUT} {name}\n")
    })
}

const RECORDING: &str = "recording";

/// The flags of an example that reads recordings; `throws`: of several pieces one can be named.
fn recording_args(throws: bool) -> Vec<Arg> {
    let file = |name: &'static str, help: &'static str| {
        Arg::new(name).long(name).value_name("FILE").help(help).value_parser(value_parser!(PathBuf))
    };
    let seconds = |name: &'static str, help: &'static str| {
        let arg = Arg::new(name).long(name).value_name("SECONDS").help(help).requires(RECORDING);
        arg.value_parser(|text: &str| number(text, "s"))
    };
    let throw = Arg::new("throw")
        .long("throw")
        .value_name("N")
        .help("Which of its throws [the first that is nearly as long as the longest]");
    let throw = throw.value_parser(value_parser!(usize)).requires(RECORDING);
    let mut args = vec![
        file(
            RECORDING,
            "Read what a phone's gyroscope recorded: a table with times and three rates",
        )
        .conflicts_with("check"),
        seconds("from", "Where the piece of it begins that is fitted"),
        seconds("to", "Where it ends"),
        file("made-up", "Write a made-up recording to try that with"),
    ];
    if throws {
        args.push(throw.conflicts_with_all(["from", "to"]));
    }
    args
}

/// The value of a flag that not all examples have.
fn optional<'m, T: Clone + Send + Sync + 'static>(
    matches: &'m ArgMatches,
    name: &str,
) -> Option<&'m T> {
    matches.try_get_one::<T>(name).ok().flatten()
}

/// What is asked of a recording.
fn asked(run: &dyn Run, matches: &ArgMatches) -> Asked {
    let typed = |flag: &&Flag| matches.value_source(&flag.name()) == Some(ValueSource::CommandLine);
    let flags = run.parameters().flags();
    Asked {
        from: optional(matches, "from").copied(),
        to: optional(matches, "to").copied(),
        throw: optional(matches, "throw").copied(),
        given: parameters(flags).filter(typed).map(Flag::name).collect(),
    }
}

/// What the example makes of these bytes, the file that `--recording` names; or what is printed instead.
pub(super) fn recorded_for(
    run: &mut dyn Run,
    arguments: Vec<OsString>,
    bytes: &[u8],
) -> core::result::Result<Recorded, Outcome> {
    let matches = set_up(run, arguments)?;
    let file = optional::<PathBuf>(&matches, RECORDING).cloned().unwrap_or_default();
    recorded(run, &file.to_string_lossy(), bytes, &asked(run, &matches)).map_err(Outcome::refused)
}

/// Prints what a recording says, with the files that are asked for.
fn told_of(run: &dyn Run, path: &Path, matches: &ArgMatches, keep: Keep<'_>) -> Result<Outcome> {
    let name = path.display().to_string();
    let read = std::fs::read(path);
    let bytes = read.map_err(|e| Error::Unread { path: name.clone(), reason: e.to_string() })?;
    let told = recorded(run, &name, &bytes, &asked(run, matches))?;
    let stdout = match matches.get_flag("json") {
        true => told.json(run.stem())?,
        false => told.report.output()?,
    };
    let figures = || told.all_figures();
    let stderr = write_files(run.stem(), matches, &|| Ok(told.trajectory.clone()), &figures, keep)?;
    Ok(Outcome { stdout, stderr, code: 0 })
}

/// `KEY=VALUE`, a reader's answer.
fn key_and_answer(text: &str) -> core::result::Result<(String, Answer), String> {
    let (key, value) = (text.split_once('='))
        .filter(|(key, _)| !key.trim().is_empty())
        .ok_or("write KEY=VALUE")?;
    Ok((key.trim().into(), Answer::read(value)?))
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
        Self { stdout: String::new(), stderr: format!("error: {reason}\n"), code: 2 }
    }
}

/// A file of a run: where it goes, and what is in it.
pub type Leaf = (PathBuf, String);

/// What becomes of the files of a run, all of them and the directory of the figures if one is
/// asked for; returns how many were there before.
type Keep<'k> = &'k mut dyn FnMut(Option<&Path>, Vec<Leaf>) -> Result<usize>;

impl<P: ParameterSet> Example<P> {
    /// Runs the example with the arguments of the process.
    pub fn main(&self) -> ExitCode {
        let outcome = alive(|| self.answer(std::env::args_os().skip(1)));
        let code = delivered(&outcome, &mut std::io::stdout(), &mut std::io::stderr());
        ExitCode::from(code)
    }

    /// What the example prints for these arguments (without the program's name).
    /// Files asked for with `--csv` and `--svg` are written, all whole or none.
    pub fn answer<A: Into<OsString> + Clone>(
        &self,
        arguments: impl IntoIterator<Item = A>,
    ) -> Outcome {
        let arguments = arguments.into_iter().map(Into::into).collect();
        answer(&mut self.run(), arguments)
    }
}

/// Shows on a terminal how long the work has been going on, elsewhere nothing. For work that
/// prints nothing until it is done.
#[cfg(not(target_arch = "wasm32"))]
pub fn alive<T>(work: impl FnOnce() -> T) -> T {
    let sign = indicatif::ProgressBar::no_length();
    sign.set_style(
        indicatif::ProgressStyle::with_template("computing, {elapsed}")
            .unwrap_or_else(|_| indicatif::ProgressStyle::default_spinner()),
    );
    sign.enable_steady_tick(core::time::Duration::from_secs(1));
    let done = work();
    sign.finish_and_clear();
    done
}

#[cfg(target_arch = "wasm32")]
pub fn alive<T>(work: impl FnOnce() -> T) -> T {
    work()
}

/// What a program says that `cargo test` compiled: no code was made for its example.
pub fn only_checked() -> ExitCode {
    eprintln!(
        "compiled without optimisation, as by `cargo test`, this program is only checked: \
         cargo run --example runs it"
    );
    ExitCode::FAILURE
}

/// What the example prints for these arguments; its files are written.
pub(super) fn answer(run: &mut dyn Run, arguments: Vec<OsString>) -> Outcome {
    answer_keeping(run, arguments, &mut on_disk)
}

/// What it prints, and the files that it would write.
pub(super) fn answer_with_files(
    run: &mut dyn Run,
    arguments: Vec<OsString>,
) -> (Outcome, Vec<Leaf>) {
    let mut files = Vec::new();
    let outcome = answer_keeping(run, arguments, &mut |_, written| {
        files = written;
        Ok(0)
    });
    (outcome, files)
}

/// The drawings for these arguments, with the stills; or what is printed instead.
pub(super) fn figures_for(
    run: &mut dyn Run,
    arguments: Vec<OsString>,
) -> core::result::Result<Vec<Figure>, Outcome> {
    set_up(run, arguments)?;
    figures(run).map_err(Outcome::refused)
}

/// The numbers for these arguments, of which nothing is printed yet; or what is printed instead.
pub(super) fn report_for(
    run: &mut dyn Run,
    arguments: Vec<OsString>,
) -> core::result::Result<Report, Outcome> {
    set_up(run, arguments)?;
    report(run).map_err(Outcome::refused)
}

fn answer_keeping(run: &mut dyn Run, arguments: Vec<OsString>, keep: Keep<'_>) -> Outcome {
    match set_up(run, arguments) {
        Ok(matches) => outcome(run, &matches, keep).unwrap_or_else(Outcome::refused),
        Err(told) => told,
    }
}

/// Sets the parameters; what is said instead of running, if anything is.
fn set_up(
    run: &mut dyn Run,
    arguments: Vec<OsString>,
) -> core::result::Result<ArgMatches, Outcome> {
    let flags = run.parameters().flags();
    let arguments = joined(arguments);
    let name = core::iter::once(OsString::from(run.stem()));
    let matches = match command(run).try_get_matches_from(name.chain(arguments)) {
        Ok(matches) => matches,
        Err(told) if told.kind() == ErrorKind::DisplayHelp => {
            return Err(Outcome {
                stdout: told.render().to_string(),
                stderr: String::new(),
                code: 0,
            });
        }
        Err(error) => {
            return Err(Outcome {
                stdout: String::new(),
                stderr: error.render().to_string() + &hint(&error, flags),
                code: 2,
            });
        }
    };
    for flag in parameters(flags) {
        set_typed(flag, &matches, run.parameters_mut());
    }
    put_in(&matches, run.parameters_mut()).map_err(Outcome::refused)?;
    Ok(matches)
}

fn command(run: &dyn Run) -> Command {
    let defaults = run.parameters();
    Command::new(run.stem())
        .bin_name(format!("cargo run --example {} --", run.stem()))
        .about(run.about())
        .disable_version_flag(true)
        .next_help_heading("Parameters")
        .args(parameters(defaults.flags()).map(|flag| arg(flag, defaults)))
        .next_help_heading("Effects")
        .args(effect_args(defaults))
        .next_help_heading("Your own recording")
        .args(run.reads().map(recording_args).unwrap_or_default())
        .next_help_heading("Output")
        .arg(
            Arg::new("check")
                .long("check")
                .value_name("KEY=VALUE")
                .help("Judge your answer (may be given several times)")
                .action(ArgAction::Append)
                .value_parser(key_and_answer),
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

fn outcome(run: &dyn Run, matches: &ArgMatches, keep: Keep<'_>) -> Result<Outcome> {
    if let Some(path) = optional::<PathBuf>(matches, RECORDING) {
        return told_of(run, path, matches, keep);
    }
    let mut outcome = Outcome { stdout: String::new(), stderr: String::new(), code: 0 };
    if let (Some(path), Some(made)) = (optional::<PathBuf>(matches, "made-up"), run.made()) {
        outcome.stdout = format!("a made-up recording is written to {}\n", path.display());
        keep(None, vec![(path.clone(), made)])?;
        return Ok(outcome);
    }
    let report = report(run)?;
    if let Some(answers) = matches.get_many::<(String, Answer)>("check") {
        for (key, value) in answers {
            let (line, right) = judged(&report, key, value)?;
            outcome.stdout += &line;
            outcome.code |= u8::from(!right);
        }
    } else if matches.get_flag("json") {
        outcome.stdout = report.json(run.stem());
    } else {
        outcome.stdout = report.output()?;
    }
    let (motion, drawn) = (|| run.trajectory(), || figures(run));
    outcome.stderr = write_files(run.stem(), matches, &motion, &drawn, keep)?;
    Ok(outcome)
}

/// Makes the files that `--csv` and `--svg` ask for and hands them on; returns a line for each.
fn write_files(
    stem: &str,
    matches: &ArgMatches,
    trajectory: &dyn Fn() -> Result<Trajectory>,
    figures: &dyn Fn() -> Result<Vec<Figure>>,
    keep: Keep<'_>,
) -> Result<String> {
    let (mut files, mut told) = (Vec::new(), String::new());
    if let Some(path) = matches.get_one::<PathBuf>("csv") {
        let trajectory = trajectory()?;
        let (rows, shown) = (trajectory.rows().len(), path.display());
        told += &format!("wrote {rows} samples to {shown}\n");
        files.push((path.clone(), trajectory.csv()));
    }
    let directory = matches.get_one::<PathBuf>("svg");
    if let Some(directory) = directory {
        let figures = figures()?;
        let (count, shown) = (figures.len(), directory.display());
        told += &format!("wrote {count} figures to {shown}\n");
        for figure in figures {
            // As in the locked figures.
            let name = format!("{stem}__{}.svg", figure.name);
            files.push((directory.join(name), figure.svg()));
        }
    }
    let replaced = keep(directory.map(PathBuf::as_path), files)?;
    if replaced > 0 {
        told += &format!("{replaced} of these files were there before and are replaced\n");
    }
    Ok(told)
}

/// Writes the files, all whole or none.
fn on_disk(directory: Option<&Path>, files: Vec<Leaf>) -> Result<usize> {
    let mut made = Directories::default();
    if let Some(directory) = directory {
        made = Directories::missing(directory);
        std::fs::create_dir_all(directory).map_err(|e| failure(directory, &e))?;
    }
    let files: Vec<(PathBuf, &str)> = files.iter().map(|(p, c)| (p.clone(), &**c)).collect();
    let replaced = write_whole(&files)?;
    made.keep();
    Ok(replaced)
}

/// Writes what there is to say; the exit code. A reader that has gone away (`| head`) is
/// no failure of ours, a full disk is.
fn delivered(outcome: &Outcome, out: &mut dyn Write, err: &mut dyn Write) -> u8 {
    let written = out.write_all(outcome.stdout.as_bytes());
    let written = written.and_then(|()| out.flush());
    // Nothing can be told where the errors cannot be written.
    let _ = err.write_all(outcome.stderr.as_bytes());
    match written {
        Err(e) if e.kind() != std::io::ErrorKind::BrokenPipe => {
            let _ = writeln!(err, "error: the output cannot be written: {e}");
            2
        }
        _ => outcome.code,
    }
}

fn judged(report: &Report, key: &str, answer: &Answer) -> Result<(String, bool)> {
    let claim: &Claim = report.claim(key).ok_or_else(|| {
        let keys: Vec<&str> = report.claims().iter().map(|c| c.key.as_str()).collect();
        Error::UnknownKey { key: key.into(), known: keys.join(", ") }
    })?;
    let unit = match claim.unit.as_str() {
        "-" => String::new(),
        unit => format!(" {unit}"),
    };
    let verdict = claim.verdict(answer.clone());
    let words = verdict.words();
    let line = match verdict {
        Verdict::Right => format!("right: {key} = {}{unit}\n", claim.printed()),
        Verdict::AsFarAsItGoes(..) | Verdict::RightTo(..) => {
            format!("nearly: your {key} is {words}\n")
        }
        Verdict::Slip(_) | Verdict::Unit(..) => {
            format!("not yet: your {key} is not right: {words}\n")
        }
        Verdict::Wrong => format!("not yet: your {key} is not right\n"),
    };
    Ok((line, verdict == Verdict::Right))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::{Error, ErrorKind};

    struct Failing(ErrorKind);

    impl Write for Failing {
        fn write(&mut self, _: &[u8]) -> std::io::Result<usize> {
            Err(Error::from(self.0))
        }
        fn flush(&mut self) -> std::io::Result<()> {
            Ok(())
        }
    }

    #[test]
    fn a_full_disk_is_an_error_and_a_reader_gone_is_none() {
        let outcome = Outcome { stdout: "a report".into(), stderr: "a word\n".into(), code: 0 };
        let told = |kind| {
            let mut err = Vec::new();
            let code = delivered(&outcome, &mut Failing(kind), &mut err);
            (code, String::from_utf8(err).unwrap_or_default())
        };
        assert_eq!(told(ErrorKind::BrokenPipe), (0, "a word\n".into()));
        let (code, err) = told(ErrorKind::StorageFull);
        assert_eq!(code, 2);
        assert!(err.contains("the output cannot be written"), "{err}");
        assert_eq!(delivered(&outcome, &mut Vec::new(), &mut Vec::new()), 0);
    }

    #[test]
    fn a_negative_number_alone_is_joined_to_its_flag() {
        let arguments = "ladder --theta0 -5.0e-1 --turn -pi/2 --length 3 --json -x word -1 --a=2 -3 --b -4 -5 --c --6";
        let all = joined(arguments.split(' ').map(OsString::from));
        let all: Vec<&str> = all.iter().filter_map(|a| a.to_str()).collect();
        let expected = "ladder --theta0=-5.0e-1 --turn=-pi/2 --length 3 --json -x word -1 --a=2 -3 --b=-4 -5 --c --6";
        assert_eq!(all.join(" "), expected);
    }
}
