//! What a page becomes, and what is said of a damaged one.

mod damaged;
mod sound;

use super::*;
use crate::splice::fill;
use std::fs;
use std::path::PathBuf;

const SNAP: &str = "\
---
source: x
---
S
A pendulum.

parameters
flag      value  unit  meaning
--length  1.5    m     length of the rod

claims
key     value   unit  bound  checked against  differs by
period  2.0064  s     5e-5   closed form      <1e-15
turns   3       -     0      counting         0

limits
limit        must give  gives   within  because
theta0 -> 0  2.0061     2.0061  1e-4    small swings take the same time

accuracy
method  requested  delivered  work       relative time
RK4     1e-9       7e-10      400 steps  -

checks
key     within  meaning
period  0.001   the period
";

/// A table with the name of a section.
const TWICE: &str =
    "---\nsource: x\n---\nS\nA pendulum.\n\nlimits\nlimit\nx\n\ntable limits\ncase\ny\n";

const FIGURE: &str = "<svg class=\"fig\" viewBox=\"0 0 340 260\" aria-label=\"It swings\"></svg>\n";

const EXAMPLE: &str =
    "fn main() {\n    // ANCHOR: physics\n    let g = 9.8;\n    // ANCHOR_END: physics\n}\n";

const TEST: &str = "#[test]\nfn it_swings() {}\n";

/// A project of one example, gone when the test ends.
struct Sample(PathBuf);

impl Sample {
    fn new(name: &str) -> Self {
        let root = std::env::temp_dir().join(format!("book-{name}-{}", std::process::id()));
        for (file, text) in [
            ("tests/snapshots/s.snap", SNAP),
            ("tests/snapshots/twice.snap", TWICE),
            ("tests/snapshots/s/swing.snap.svg", FIGURE),
            ("tests/snapshots/s/frame_1.snap.svg", FIGURE),
            ("tests/snapshots/s/frame_2.snap.svg", FIGURE),
            ("tests/snapshots/sx/frame_1.snap.svg", FIGURE),
            ("examples/s.rs", EXAMPLE),
            ("tests/t.rs", TEST),
        ] {
            let path = root.join(file);
            fs::create_dir_all(path.parent().expect("a directory")).expect("a place to write");
            fs::write(path, text).expect("a file");
        }
        Self(root)
    }

    /// The page `a/b.html` from `source`, whose first line is line 5 of `a/b.md`; formulas
    /// as «TeX», what is filled in later as «…» too.
    fn page(&self, source: &str) -> Expanded {
        let project = Project::new(&self.0);
        let mut labels = Labels::new();
        for (label, page) in [("eq:here", "a/b.html"), ("eq:there", "c.html")] {
            let target =
                Target { page: page.into(), tag: "1.1 (2)".into(), place: ("c.md".into(), 1) };
            labels.insert(label.into(), target);
        }
        let mut page = Page::new(&project, "a/b.md", "a/b.html", &labels);
        let raw = page.expand(source, 5);
        let html = fill(&raw, |splice| {
            Ok(match splice {
                Splice::Inline { tex } => format!("«{tex}»"),
                Splice::Display { tex, tag, id, boxed } => {
                    format!("«{}|{tag:?}|{id:?}|{boxed}»", tex.trim())
                }
                Splice::Proof { kind, id, html, proof } if kind == "num" => {
                    format!("«{kind} {id} {html} {proof}»")
                }
                Splice::Proof { kind, id, proof, .. } => format!("«{kind} {id} {proof}»"),
                Splice::Figure { stem, name } => format!("«{stem}:{name}»"),
                Splice::Player { stem } => format!("«player {stem}»"),
                Splice::Table { stem, section } => format!("«table {stem}:{section}»"),
                other => format!("«{other:?}»"),
            })
        });
        Expanded {
            html: html.expect("marks that can be read"),
            raw,
            problems: page.problems.iter().map(|p| p.to_string()).collect(),
            stems: page.stems,
            sources: page.sources,
            found: page.found,
        }
    }
}

impl Drop for Sample {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

struct Expanded {
    html: String,
    /// With its marks.
    raw: String,
    problems: Vec<String>,
    stems: Vec<String>,
    sources: Vec<String>,
    found: Labels,
}
