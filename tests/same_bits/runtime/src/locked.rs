//! What is locked: reports, figures, and how the commands ended that a reader is given.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use wasmtime::{Error, Result};

pub struct Locked {
    /// By the stems of the pages.
    pub reports: BTreeMap<String, String>,
    /// By their names, `STEM__NAME`.
    pub figures: BTreeMap<String, String>,
    pub commands: Vec<Command>,
}

pub struct Command {
    pub stem: String,
    pub arguments: Vec<String>,
    /// The exit code and the digest of what it told.
    pub ended: String,
}

/// The files of a directory whose names end so, by the rest of their names.
fn texts(directory: &Path, ending: &str) -> Result<BTreeMap<String, String>> {
    let mut texts = BTreeMap::new();
    for entry in fs::read_dir(directory)? {
        let entry = entry?;
        let name = entry.file_name().into_string().unwrap_or_default();
        if let Some(name) = name.strip_suffix(ending) {
            texts.insert(name.to_owned(), fs::read_to_string(entry.path())?);
        }
    }
    Ok(texts)
}

/// The text after the head, which stands between two lines of dashes.
fn body(text: &str) -> &str {
    text.splitn(3, "---\n").nth(2).unwrap_or_default()
}

fn command(line: &str) -> Option<Command> {
    let mut words = line.split_whitespace();
    let ended = format!("{} {}", words.next()?, words.next()?);
    Some(Command {
        stem: words.next()?.to_owned(),
        arguments: words.map(str::to_owned).collect(),
        ended,
    })
}

impl Locked {
    pub fn read(snapshots: &Path) -> Result<Self> {
        let mut reports = texts(snapshots, ".snap")?;
        for report in reports.values_mut() {
            *report = body(report).to_owned();
        }
        let mut figures = BTreeMap::new();
        for stem in reports.keys() {
            for (name, svg) in texts(&snapshots.join(stem), ".snap.svg")? {
                figures.insert(format!("{stem}__{name}"), svg);
            }
        }
        let commands = texts(&snapshots.join("commands"), ".snap")?;
        let lines = commands.values().flat_map(|text| body(text).lines());
        let commands: Option<_> = lines.map(command).collect();
        Ok(Self {
            reports,
            figures,
            commands: commands.ok_or_else(|| Error::msg("a locked command is no command"))?,
        })
    }

    /// How many answers there are.
    pub fn count(&self) -> usize {
        self.reports.len() + self.figures.len() + self.commands.len()
    }
}
