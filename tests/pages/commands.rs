//! Every command that a reader is given, on a page or in the README, is run as it is typed:
//! its end and what it prints are locked, so a command that has grown old is seen. The list is
//! also what the modules of the pages are held to. The pages whose reports take longest are left to the
//! gate, which sets `PROPERTY_CASES`.

use crate::snapshots::settings;
use crate::answers::{asked, root};
use pages::{WHOLE, page};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use std::sync::Mutex;
use std::{fs, thread};

const COMMAND: &str = "cargo run --example ";

/// The commands in a text: up to the end of the line, of the code or of a remark.
fn commands(text: &str) -> impl Iterator<Item = &str> {
    text.match_indices(COMMAND).map(|(at, _)| {
        let rest = &text[at + COMMAND.len()..];
        let end = rest.find(['`', '\n', '#']).unwrap_or(rest.len());
        rest[..end].trim()
    })
}

/// FNV-1a: short, the same everywhere, in a line of any language.
fn digest(bytes: impl IntoIterator<Item = u8>) -> u64 {
    let step = |hash: u64, byte: u8| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
    bytes.into_iter().fold(0xcbf2_9ce4_8422_2325, step)
}

/// The code with which the command ends, and the digest of what it prints and writes.
fn told(stem: &str, arguments: &str) -> Option<(u8, u64)> {
    let arguments = arguments.split_whitespace().map(str::to_owned).collect();
    let (outcome, files) = page(stem)?.answer_with_files(arguments);
    let written = files.iter().flat_map(|(_, text)| text.bytes());
    let all = outcome.stdout.bytes().chain(outcome.stderr.bytes());
    Some((outcome.code, digest(all.chain(written))))
}

/// An example and its arguments.
type Command = (String, String);

/// The commands of the README and of all pages, and those of the README alone.
fn given() -> (BTreeSet<Command>, BTreeSet<Command>) {
    let mut texts = vec![root().join("README.md")];
    let pages = fs::read_dir(root().join("book/src")).expect("the pages can be read");
    texts.extend(pages.map(|page| page.expect("an entry").path()));
    let (mut given, mut by_readme) = (BTreeSet::new(), BTreeSet::new());
    for path in texts {
        let text = fs::read_to_string(&path).expect("a text");
        for command in commands(&text) {
            let (stem, arguments) = command.split_once(" -- ").unwrap_or((command, ""));
            let command = (stem.to_owned(), arguments.to_owned());
            if path.ends_with("README.md") {
                by_readme.insert(command.clone());
            }
            given.insert(command);
        }
    }
    (given, by_readme)
}

/// Groups whose few commands take as long as those of all other pages.
const LONG: [&str; 5] = ["accuracy_races", "accuracy", "effects_", "effects", "hard_cases"];

/// Locks how the commands of this group end and what they print.
fn run(group: &str) {
    if !WHOLE || (LONG.contains(&group) && asked("PROPERTY_CASES").is_none()) {
        return;
    }
    let (given, by_readme) = given();
    let of_group = |(stem, _): &&Command| {
        GROUPS.iter().find(|begins| stem.starts_with(**begins)) == Some(&group)
    };
    let mut all: BTreeMap<_, _> = given.iter().filter(of_group).map(|c| (c, None)).collect();
    // Each thread takes the next command, for a few take as long as all others.
    let queue = Mutex::new(all.iter_mut());
    let next = || queue.lock().expect("no thread has failed").next();
    thread::scope(|scope| {
        for _ in 0..2 {
            scope.spawn(|| {
                while let Some(((stem, arguments), ended)) = next() {
                    *ended = told(stem, arguments);
                }
            });
        }
    });
    let mut list = String::new();
    for (command, ended) in &all {
        let (stem, arguments) = command;
        let Some((code, digest)) = ended else {
            assert_eq!(stem, "problem_sheet", "there is no example {stem}");
            continue;
        };
        // A page may ask what a program will refuse; the README invites.
        let refused = *code > 1 && by_readme.contains(command);
        assert!(!refused, "the README's {stem} {arguments} is refused");
        let line = format!("{code} {digest:016x} {stem} {arguments}");
        let _ = writeln!(list, "{}", line.trim_end());
    }
    let file = if group.is_empty() { "others" } else { group };
    settings("snapshots/commands").bind(|| insta::assert_snapshot!(file, list));
}

/// The groups of pages whose commands are locked in one file each, and a test for each.
macro_rules! groups {
    ($($name:ident $begins:literal;)*) => {
        /// With what the names of their pages begin; a page is of the first group that fits.
        const GROUPS: &[&str] = &[$($begins),*];

        /// Every command that a reader is given runs.
        mod every_command_runs {
            $(
                #[test]
                fn $name() {
                    super::run($begins);
                }
            )*
        }
    };
}

groups! {
    accuracy_races "accuracy_races";
    accuracy "accuracy";
    ch15 "ch15";
    ch16 "ch16";
    effects_studies "effects_";
    effects "effects";
    further "further";
    hard_cases "hard_cases";
    others "";
}

#[test]
fn commands_are_found() {
    let (given, by_readme) = given();
    assert!(by_readme.len() > 5 && given.len() > 200, "{} commands", given.len());
}

/// The damaged twin: a command that has grown old is refused, another output is another line.
#[test]
fn a_command_that_has_grown_old_is_seen() {
    if !WHOLE {
        return;
    }
    let told = |arguments| told("ch16_ex6_ladder", arguments).expect("there is a ladder");
    assert_eq!(told("--angel 0.5").0, 2);
    assert_ne!(told("--angle 0.5"), told("--angle 0.25"));
    assert_eq!(told("--check t_release=0.8761").0, 0);
    let text = "`cargo run --example a -- --b 1` and\ncargo run --example c   # d\n";
    assert_eq!(commands(text).collect::<Vec<_>>(), ["a -- --b 1", "c"]);
}
