//! The files that pages include: examples, snapshots, figures, tests.

use crate::race;
use kit::{Parsed, Table, name_of_flag, parse};
use std::fs;
use std::path::{Path, PathBuf};

/// The root of the project, with readers for what a directive can name.
///
/// Every reader says in words what is missing and what there is instead.
#[derive(Debug, Clone)]
pub struct Project {
    root: PathBuf,
}

/// A function in a source file.
pub struct TestSource {
    /// Relative to the root, with forward slashes.
    pub file: String,
    /// The line of its `fn`, from 1.
    pub line: usize,
}

impl Project {
    /// The project whose `book` directory is `root/book`.
    pub fn new(root: impl Into<PathBuf>) -> Self {
        Self { root: root.into() }
    }

    /// The nearest directory at or above `start` that holds `book/book.toml`.
    pub fn above(start: &Path) -> Option<Self> {
        start.ancestors().find(|dir| dir.join("book/book.toml").is_file()).map(Self::new)
    }

    /// A path in the project.
    pub fn path(&self, relative: &str) -> PathBuf {
        self.root.join(relative)
    }

    /// The text of a file, with line feeds only.
    pub fn read(&self, relative: &str) -> Result<String, String> {
        fs::read_to_string(self.path(relative))
            .map(|text| text.replace("\r\n", "\n"))
            .map_err(|e| format!("cannot read {relative}: {e}"))
    }

    /// The names (without directory) of the files in `directory` that end with `suffix`, sorted.
    pub fn names(&self, directory: &str, suffix: &str) -> Vec<String> {
        let mut names: Vec<String> = fs::read_dir(self.path(directory))
            .into_iter()
            .flatten()
            .flatten()
            .filter(|entry| entry.path().is_file())
            .filter_map(|entry| entry.file_name().into_string().ok())
            .filter_map(|name| name.strip_suffix(suffix).map(Into::into))
            .collect();
        names.sort();
        names
    }

    /// The directories in `directory`, each with a slash at its end, sorted.
    pub fn groups(&self, directory: &str) -> Vec<String> {
        let entries = fs::read_dir(self.path(directory)).into_iter().flatten();
        let mut groups: Vec<String> = entries
            .flatten()
            .filter(|entry| entry.path().is_dir())
            .filter_map(|entry| entry.file_name().into_string().ok())
            .map(|name| name + "/")
            .collect();
        groups.sort();
        groups
    }

    /// The locked output of an example: what stands after insta's header.
    pub fn output(&self, stem: &str) -> Result<String, String> {
        let file = format!("tests/snapshots/{stem}.snap");
        if !self.path(&file).is_file() {
            let known = self.names("tests/snapshots", ".snap").join(", ");
            return Err(format!("there is no {file}; locked are: {known}"));
        }
        let text = self.read(&file)?;
        let body = text
            .strip_prefix("---\n")
            .and_then(|rest| rest.split_once("\n---\n"))
            .map(|(_, body)| body)
            .ok_or(format!("{file} does not begin with insta's header"))?;
        Ok(body.trim_end().to_owned() + "\n")
    }

    /// The locked output, read into its sections.
    pub fn report(&self, stem: &str) -> Result<Parsed, String> {
        parse(&self.output(stem)?).map_err(|e| format!("tests/snapshots/{stem}.snap: {e}"))
    }

    /// A section of the locked output; `section` is `claims`, `limits`, … or the name of a table,
    /// not both.
    pub fn table(&self, stem: &str, section: &str) -> Result<Table, String> {
        let report = self.report(stem)?;
        let named = format!("table {section}");
        match (report.table(section), report.table(&named)) {
            (Some(_), Some(_)) => Err(format!(
                "'{section}' is a section of the output of {stem} and the name of a table in it"
            )),
            (Some(found), None) | (None, Some(found)) => Ok(found.clone()),
            (None, None) => {
                let known: Vec<&str> = report.tables.iter().map(Table::heading).collect();
                Err(format!(
                    "the output of {stem} has no section '{section}'; it has: {}",
                    known.join(", ")
                ))
            }
        }
    }

    /// A claim of an example: the cells of its row, by the names of the columns.
    pub fn claim(&self, stem: &str, key: &str) -> Result<Claim, String> {
        let table = self.table(stem, "claims")?;
        let row = table.rows().iter().find(|row| row[0] == key).ok_or_else(|| {
            let known: Vec<&str> = table.rows().iter().map(|row| row[0].as_str()).collect();
            format!("{stem} claims no '{key}'; its keys are: {}", known.join(", "))
        })?;
        let cell = |name: &str| -> Result<String, String> {
            let at = table.columns().iter().position(|column| column == name);
            at.map(|n| row[n].clone())
                .ok_or(format!("the claims of {stem} have no column '{name}'"))
        };
        Ok(Claim {
            value: cell("value")?,
            unit: cell("unit")?,
            bound: cell("bound")?,
            oracle: cell("checked against")?,
        })
    }

    /// A parameter of an example, whose flag is `--NAME`, or of an effect that is in: its value and unit, as for a claim.
    pub fn parameter(&self, stem: &str, name: &str) -> Result<Claim, String> {
        let table = self.table(stem, "parameters")?;
        let mut rows = table.rows().iter();
        let row = rows.find(|row| name_of_flag(&row[0]) == name);
        let row = row.ok_or_else(|| {
            let known = table.rows().iter().map(|row| name_of_flag(&row[0]));
            let known: Vec<&str> = known.collect();
            format!("{stem} has no parameter '{name}'; it has: {}", known.join(", "))
        })?;
        let [_, value, unit, ..] = row.as_slice() else {
            return Err(format!("the parameters of {stem} have no value and unit"));
        };
        Ok(Claim {
            value: value.clone(),
            unit: unit.clone(),
            bound: "0".into(),
            oracle: "-".into(),
        })
    }

    /// The file of a locked figure.
    pub fn figure_file(stem: &str, name: &str) -> String {
        format!("tests/snapshots/{stem}/{name}.snap.svg")
    }

    /// The names of the locked figures of an example, sorted.
    pub fn figures(&self, stem: &str) -> Vec<String> {
        self.names(&format!("tests/snapshots/{stem}"), ".snap.svg")
    }

    /// A locked figure, or one drawn from a record of measurements.
    pub fn figure(&self, stem: &str, name: &str) -> Result<String, String> {
        if stem == race::STEM {
            return race::svg(self, name);
        }
        let file = Self::figure_file(stem, name);
        if !self.path(&file).is_file() {
            let known = self.figures(stem).join(", ");
            return Err(format!("there is no figure {file}; {stem} has: {known}"));
        }
        self.read(&file)
    }

    /// The lines of `file` between `// ANCHOR: name` and `// ANCHOR_END: name`, dedented, without
    /// other anchors, with the number of the first.
    pub fn listing(&self, file: &str, anchor: &str) -> Result<(String, usize), String> {
        let text = self.read(file)?;
        let mark = |line: &str, kind: &str| -> Option<String> {
            let comment = line.trim().strip_prefix("//")?.trim_start();
            comment.strip_prefix(kind).map(|name| name.trim().to_owned())
        };
        let find = |kind: &str| -> Vec<usize> {
            text.lines()
                .enumerate()
                .filter(|(_, line)| mark(line, kind).as_deref() == Some(anchor))
                .map(|(n, _)| n)
                .collect()
        };
        let (starts, ends) = (find("ANCHOR:"), find("ANCHOR_END:"));
        let (&[start], &[end]) = (starts.as_slice(), ends.as_slice()) else {
            let known: Vec<String> = text.lines().filter_map(|l| mark(l, "ANCHOR:")).collect();
            return Err(format!(
                "{file} must hold '// ANCHOR: {anchor}' and '// ANCHOR_END: {anchor}' once each \
                 (found {} and {}); its anchors are: {}",
                starts.len(),
                ends.len(),
                known.join(", ")
            ));
        };
        let lines: Vec<&str> = text
            .lines()
            .take(end)
            .skip(start + 1)
            .filter(|line| mark(line, "ANCHOR:").is_none() && mark(line, "ANCHOR_END:").is_none())
            .collect();
        let indent = lines
            .iter()
            .filter(|line| !line.trim().is_empty())
            .map(|line| line.len() - line.trim_start().len())
            .min()
            .ok_or(format!("the listing {file}:{anchor} is empty"))?;
        let dedented: Vec<&str> =
            lines.iter().map(|line| line.get(indent..).unwrap_or("")).collect();
        Ok((dedented.join("\n").trim_matches('\n').to_owned(), start + 2))
    }

    /// The function `name` in `file`, which may be given without `tests/`, without the
    /// directory of its group, and without `.rs`.
    pub fn test(&self, file: &str, name: &str) -> Result<TestSource, String> {
        let mut candidates = vec![file.to_owned(), format!("{file}.rs")];
        for group in core::iter::once(String::new()).chain(self.groups("tests")) {
            for end in ["", ".rs", "/main.rs", "/mod.rs"] {
                candidates.push(format!("tests/{group}{file}{end}"));
            }
        }
        let found = candidates.iter().find(|f| self.path(f).is_file());
        let file = found.ok_or(format!("there is no test file '{file}'"))?;
        let text = self.read(file)?;
        let line = text.lines().position(|line| {
            let line = line.trim_start().trim_start_matches("pub ");
            line.strip_prefix("fn ")
                .and_then(|rest| rest.strip_prefix(name))
                .is_some_and(|rest| rest.starts_with(['(', '<']))
        });
        line.map(|line| TestSource { file: file.clone(), line: line + 1 })
            .ok_or(format!("{file} has no test '{name}'"))
    }
}

/// A claim as the page needs it.
pub struct Claim {
    /// The printed value.
    pub value: String,
    /// Its unit, `-` if it has none.
    pub unit: String,
    /// The bound on the error of what is printed.
    pub bound: String,
    /// The independent route.
    pub oracle: String,
}
