//! What a page tells, held against what is locked.

use crate::locked::Locked;
use crate::page::Modules;
use serde::Deserialize;
use std::collections::{BTreeMap, BTreeSet};
use wasmtime::Result;

/// What was compared.
#[derive(Default)]
pub struct Held {
    pub compared: usize,
    /// The names of what differs.
    pub differ: Vec<String>,
}

impl Held {
    fn hold(&mut self, name: &str, same: bool) {
        self.compared += 1;
        if !same {
            self.differ.push(name.to_owned());
        }
    }

    /// Adds a page's. One that breaks off differs.
    pub fn add(&mut self, stem: &str, page: Result<Self>) {
        match page {
            Ok(page) => {
                self.compared += page.compared;
                self.differ.extend(page.differ);
            }
            Err(error) => self.differ.push(format!("{stem}: {error:#}")),
        }
    }
}

#[derive(Deserialize)]
struct Figures {
    figures: Vec<Figure>,
}

#[derive(Deserialize)]
struct Figure {
    name: String,
    svg: String,
}

#[derive(Deserialize)]
struct Outcome {
    stdout: String,
    stderr: String,
    code: u8,
    files: Vec<Written>,
}

#[derive(Deserialize)]
struct Written {
    text: String,
}

#[derive(Deserialize)]
struct Opened {
    span: [f64; 2],
    stills: Vec<f64>,
}

/// FNV-1a, as `tests/pages/commands.rs` has it.
fn digest(texts: impl Iterator<Item = String>) -> u64 {
    let step = |hash: u64, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
    texts.flat_map(String::into_bytes).fold(0xcbf2_9ce4_8422_2325, step)
}

impl Outcome {
    fn ended(self) -> String {
        let files = self.files.into_iter().map(|file| file.text);
        let told = digest([self.stdout, self.stderr].into_iter().chain(files));
        format!("{} {told:016x}", self.code)
    }
}

/// Report, figures and commands.
pub fn told(modules: &Modules, stem: &str, locked: &Locked) -> Result<Held> {
    let mut held = Held::default();
    let mut page = modules.page(stem)?;

    let report = String::from_utf8(page.ask("report", "")?)?;
    let expected = locked.reports.get(stem).map(|text| text.trim_end());
    held.hold(stem, Some(report.trim_end()) == expected);

    let told: Figures = serde_json::from_slice(&page.ask("figures", "")?)?;
    let told = told.figures.into_iter();
    let told: BTreeMap<_, _> =
        told.map(|figure| (format!("{stem}__{}", figure.name), figure.svg)).collect();
    let own = format!("{stem}__");
    let expected = locked.figures.keys().filter(|name| name.starts_with(&own));
    for name in expected.chain(told.keys()).collect::<BTreeSet<_>>() {
        held.hold(name, told.get(name) == locked.figures.get(name));
    }

    for command in locked.commands.iter().filter(|given| given.stem == stem) {
        let told = page.ask("run", &command.arguments.join("\0"))?;
        let told: Outcome = serde_json::from_slice(&told)?;
        let name = format!("{stem} {}", command.arguments.join(" "));
        held.hold(&name, told.ended() == command.ended);
    }
    Ok(held)
}

/// What moves opens and is drawn, from both sides.
pub fn moved(modules: &Modules, stem: &str) -> Result<Held> {
    let mut held = Held::default();
    let mut page = modules.page(stem)?;
    let Opened { span, stills } = serde_json::from_slice(&page.ask("open", "")?)?;
    held.hold(&format!("{stem}, opened"), true);
    for t in span.into_iter().chain(stills) {
        for about in [0.0, 0.5] {
            held.hold(&format!("{stem} at {t}"), page.frame(t, about).is_ok());
        }
    }
    Ok(held)
}
