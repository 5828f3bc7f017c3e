//! Problem sheets: every student gets other numbers, and the teacher their answers.
//!
//! ```text
//! cargo run --example problem_sheet -- --seed 7 --problems 16.6,15.8 --students Ada,Emmy
//! ```
//! An exercise is on offer as soon as its `parameters!` say what is drawn (`.drawn(1.0, 6.0, 0.5)`).
//! Its text is that of its page, its answers are those of its answer box.

#[path = "address.rs"]
pub mod address;
#[path = "draw.rs"]
pub mod draw;
#[path = "exercise.rs"]
pub mod exercise;
#[path = "paper.rs"]
pub mod paper;
#[path = "statement.rs"]
pub mod statement;

use clap::{Arg, ArgMatches, Command, value_parser};
use draw::{Drawn, draw};
use exercise::Exercise;
use kit::Answer;
use kit::cli::{joined, write_whole};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// What is asked for.
pub struct Asked {
    pub seed: u64,
    /// Numbers of problems; none for all.
    pub problems: Vec<String>,
    /// One sheet each; a single empty name for a sheet without one.
    pub students: Vec<String>,
    pub title: String,
    /// Where the book is, with a slash at its end.
    pub book: String,
}

/// A student and the problems drawn for them.
pub struct Sheet<'e> {
    pub student: String,
    pub problems: Vec<Drawn<'e>>,
}

/// What each student gets.
pub fn drawn<'e>(asked: &Asked, all: &'e [Exercise]) -> Result<Vec<Sheet<'e>>, String> {
    let chosen = exercise::chosen(all, &asked.problems)?;
    let sheet = |student: &String| {
        let drawn = chosen.iter().map(|exercise| draw(exercise, asked.seed, student));
        let (student, problems) = (student.clone(), drawn.collect::<Result<_, _>>()?);
        Ok(Sheet { student, problems })
    };
    asked.students.iter().map(sheet).collect()
}

/// The sheets and the answers, as HTML.
pub fn written(asked: &Asked, all: &[Exercise]) -> Result<[String; 2], String> {
    let sheets = drawn(asked, all)?;
    Ok([paper::sheets(asked, &sheets)?, paper::answers(asked, &sheets)])
}

/// `sheet.html` has its answers in `sheet.answers.html`.
pub fn answers_path(out: &Path) -> PathBuf {
    match out.extension() {
        Some(extension) => out.with_extension(format!("answers.{}", extension.display())),
        None => out.with_extension("answers"),
    }
}

/// A whole number; all seeds are as good.
pub fn seed(text: &str) -> Result<u64, String> {
    (text.trim().parse()).map_err(|_| format!("a seed is a whole number from 0 to {}", u64::MAX))
}

/// Names parted by commas, or how many students there are.
pub fn students(text: &str) -> Result<Vec<String>, String> {
    // A comma in a number may part decimals or thousands: neither counts students.
    if Answer::read(&text.replace(',', ".")).is_ok_and(|number| number.unit.is_empty()) {
        return match text.trim().parse() {
            Ok(count @ 1..=500) => Ok((1..=count).map(|n: u16| format!("Student {n}")).collect()),
            _ => Err("there must be from 1 to 500 students, a whole number".into()),
        };
    }
    let names: Vec<String> = text.split(',').map(|name| name.trim().to_owned()).collect();
    for (n, name) in names.iter().enumerate() {
        if name.is_empty() {
            return Err("a name is empty; write names parted by commas, or a number".into());
        }
        if names[..n].contains(name) {
            return Err(format!("{name} stands twice, and would get the same numbers twice"));
        }
    }
    Ok(names)
}

/// Where `cargo book` builds the book, beside a sheet in the project's root.
const BUILT: &str = "book/book/";

fn address(text: &str) -> Result<String, String> {
    let known = ["http://", "https://", "file:///", BUILT];
    let begins = known.iter().any(|scheme| text.starts_with(scheme));
    if !begins || text.contains(['?', '#', '"', ' ']) {
        return Err("write http://…, https://… or file:///…, without ? and #".into());
    }
    Ok(text.trim_end_matches('/').to_owned() + "/")
}

pub fn command() -> Command {
    let arg = |name: &'static str, value: &'static str, help: &'static str| {
        Arg::new(name).long(name).value_name(value).help(help)
    };
    let seeds = arg("seed", "NUMBER", "The same seed gives the same sheet");
    let problems = arg("problems", "LIST", "Numbers of exercises, parted by commas, or all");
    let names = arg("students", "LIST", "Names, parted by commas, or how many: a sheet for each");
    let title = arg("title", "TEXT", "Stands at the head of each sheet");
    let book = arg("book", "ADDRESS", "Where the book is; as it stands, what `cargo book` builds");
    let out = arg("out", "FILE", "The sheet; the answers go beside it, to FILE with .answers");
    Command::new("problem_sheet")
        .bin_name("cargo run --example problem_sheet --")
        .about("Problem sheets on which every student has other numbers, and their answers")
        .disable_version_flag(true)
        .arg(seeds.default_value("1").value_parser(seed))
        .arg(problems.default_value("all"))
        .arg(names.value_parser(students))
        .arg(title.default_value("Problem sheet"))
        .arg(book.default_value(BUILT).value_parser(address))
        .arg(out.default_value("sheet.html").value_parser(value_parser!(PathBuf)))
}

/// Writes the two files; what there is to say.
pub fn run(matches: &ArgMatches) -> Result<String, String> {
    let text = |name: &str| matches.get_one::<String>(name).cloned().unwrap_or_default();
    let problems = match text("problems").trim() {
        "all" => Vec::new(),
        list => list.split(',').map(|number| number.trim().to_owned()).collect(),
    };
    let students = matches.get_one::<Vec<String>>("students").cloned();
    let asked = Asked {
        seed: matches.get_one("seed").copied().unwrap_or(1),
        problems,
        students: students.unwrap_or_else(|| vec![String::new()]),
        title: text("title"),
        book: text("book"),
    };
    let out = matches.get_one::<PathBuf>("out").cloned().unwrap_or_default();
    let [sheet, answers] = written(&asked, &exercise::all()?)?;
    let files = [(out.clone(), &*sheet), (answers_path(&out), &*answers)];
    let replaced = write_whole(&files).map_err(|e| e.to_string())?;
    let [sheet, answers] = files.map(|(path, _)| path.display().to_string());
    let before = match replaced {
        0 => String::new(),
        _ => format!("{replaced} of these files were there before and are replaced\n"),
    };
    Ok(format!("wrote {sheet}, and the answers to {answers}\n{before}"))
}

fn main() -> ExitCode {
    match run(&command().get_matches_from(joined(std::env::args_os()))) {
        Ok(told) => {
            eprint!("{told}");
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::from(2)
        }
    }
}
