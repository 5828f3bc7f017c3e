//! A small project with one of everything a page can name, to be damaged.

use serde_json::{Value, json};
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// A project of two pages, one example, its locked output and figure, and a test.
pub struct Sample {
    pub root: PathBuf,
}

/// What a run of the builder gave.
pub struct Run {
    pub ok: bool,
    pub stdout: String,
    pub stderr: String,
}

pub fn read(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

/// Runs the builder, as `cargo book` does, on the project at `root`.
pub fn book(root: &Path, arguments: &[&str], input: &str) -> Run {
    let mut command = Command::new(env!("CARGO_BIN_EXE_book"));
    command
        .arg("--root")
        .arg(root)
        .args(arguments)
        .current_dir(root)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped());
    let mut child = command.spawn().expect("the builder runs");
    if let Some(mut stdin) = child.stdin.take() {
        // A refusal may close the pipe before all is read.
        let _ = stdin.write_all(input.as_bytes());
    }
    let output = child.wait_with_output().expect("the builder ends");
    Run {
        ok: output.status.success(),
        stdout: String::from_utf8_lossy(&output.stdout).into_owned(),
        stderr: String::from_utf8_lossy(&output.stderr).into_owned(),
    }
}

const SETTINGS: &str = "\
[book]
title = \"Sample\"

[build]
create-missing = false
use-default-preprocessors = false

[preprocessor.directives]
command = \"unused\"

[output.pages]
command = \"unused\"

[output.pages.html]
no-section-label = true
";

/// The same settings as mdbook sends them.
pub fn config() -> Value {
    json!({
        "book": {"title": "Sample", "src": "src", "language": "en", "authors": []},
        "build": {"create-missing": false, "use-default-preprocessors": false},
        "preprocessor": {"directives": {"command": "unused"}},
        "output": {"pages": {"command": "unused", "html": {"no-section-label": true}}},
    })
}

const ONE: &str = r"# One

## The period

The period is {{num sample:period s}}, as $T = {{num sample:period}}\,\mathrm{s}$ says.

It is a swing $\theta$ with `--length {{num sample:period}}`, where

$$
\ddot\theta = -\sin\theta
\tag{1.1 (1)} \label{eq:swing}
$$

and $\frac{T}{4}$ is a quarter of it, also in a table: | a | $|x|$ |.

<!-- a comment with $ and {{ -->
{{figure sample:swing}}

**It swings.** The caption holds $\theta$.

{{listing sample:physics}}

{{output sample}}

{{table sample:limits}}

{{check sample}}

{{test sample_tests::it_swings}}

{{table sample:accuracy}}

{{measured races:ratios}}

The length is {{param sample:length m}}.

{{stills sample}}

**Two stills.** Up and down.
";

const TWO: &str = r"# Two

By \eqref{eq:swing} it swings.

See [the period](one.md#the-period).
";

const OUTPUT: &str = "\
---
source: tests/pages/snapshots.rs
---
Sample
A pendulum.

parameters
flag      value  unit  meaning
--length  1.5    m     length of the rod

claims
key     value   unit  bound  checked against  differs by
period  2.0064  s     5e-5   closed form      <1e-15

limits
limit        must give  gives   within  because
theta0 -> 0  2.0061     2.0061  1e-4    small swings take the same time

accuracy
method  requested  delivered  work       relative time
RK4     1e-9       7e-10      400 steps  -
DOP853  1e-9       5e-10      30 steps   -
Verlet  1e-9       9e-10      900 steps  -

checks
key     within  meaning
period  0.001   the period

slips
key     value   hint
period  1.0032  that is half a swing
";

/// Times of the strip; the second was measured when it took 28 steps.
pub const RECORD: &str = "\
Times of the accuracy strip of sample
Measured.

table conditions
condition  value
processor  Abacus 2
compiler   rustc 1.92.0

table unit
what        ns
one sample  75

table strip
method  requested  delivered  work       time  interval 
RK4     1e-9       7e-10      400 steps  5123  5100 to 5200
DOP853  1e-9       5e-10      28 steps   271   270 to 280
Verlet  1e-9       9e-10      900 steps  6789  6700 to 6900
gone    1e-9       9e-10      900 steps  999   990 to 1100
";

/// Who was how fast.
const RACES: &str = "\
Races
Measured.

table conditions
condition  value
processor  Abacus 2
compiler   rustc 1.92.0
date       1823-06-14

table ratios
problem  peer      faster
swing    hourglass  17.5
";

const FIGURE: &str = "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"fig\" viewBox=\"0 0 340 260\" \
    width=\"340\" height=\"260\" role=\"img\" aria-label=\"A curve that swings\">\n\
    <path d=\"M0,0L9,9\"/>\n</svg>\n";

const EXAMPLE: &str =
    "fn main() {\n    // ANCHOR: physics\n    let g = 9.8;\n    // ANCHOR_END: physics\n}\n";

impl Sample {
    /// A new directory of this name for the run.
    pub fn directory(name: &str) -> PathBuf {
        let directory = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("book_{name}"));
        if directory.exists() {
            fs::remove_dir_all(&directory).expect("the old copy can be removed");
        }
        directory
    }

    /// The project, written to a directory of its own.
    pub fn new(name: &str) -> Self {
        let root = Self::directory(name);
        let files = [
            ("book/book.toml", SETTINGS),
            ("book/src/SUMMARY.md", "# Summary\n\n- [One](one.md)\n- [Two](two.md)\n- [Three]()\n"),
            ("book/src/one.md", ONE),
            ("book/src/two.md", TWO),
            ("examples/sample.rs", EXAMPLE),
            ("tests/snapshots/sample.snap", OUTPUT),
            ("tests/snapshots/sample/swing.snap.svg", FIGURE),
            ("tests/snapshots/sample/frame_1.snap.svg", FIGURE),
            ("tests/snapshots/sample/frame_2.snap.svg", FIGURE),
            ("benches/record/races.txt", RACES),
            ("tests/sample_tests.rs", "#[test]\nfn it_swings() {}\n"),
        ];
        for (file, text) in files {
            let path = root.join(file);
            if let Some(parent) = path.parent() {
                fs::create_dir_all(parent).expect("the copy can be made");
            }
            fs::write(path, text).expect("the copy can be written");
        }
        Self { root }
    }
}
