//! What every example prints and draws, locked.
//!
//! The text of an example's report is `tests/snapshots/STEM.snap`, its figures are
//! `tests/snapshots/figures/STEM__NAME.snap.svg`; the book's pages show these very
//! files. To lock a change on purpose, run with `INSTA_UPDATE=always` and read the
//! difference before you commit it.
//!
//! A new example: a module below, its line in [`all`], and the two counts.

#[path = "../examples/ch16_ex6_ladder.rs"]
mod ch16_ex6_ladder;

use insta::Settings;
use rotation_dynamics::report::cli::Example;
use rotation_dynamics::report::draw::PALETTE;
use rotation_dynamics::report::{Figure, parse};
use std::collections::BTreeSet;
use std::path::Path;

/// What is locked of an example.
struct Locked {
    stem: &'static str,
    flags: Vec<&'static str>,
    text: String,
    figures: Vec<Figure>,
}

/// How many examples there are, and how many figures they draw.
const EXAMPLES: usize = 1;
const FIGURES: usize = 8;

fn all() -> Vec<Locked> {
    vec![locked(&ch16_ex6_ladder::EXAMPLE)]
}

fn locked<P: Default>(example: &Example<P>) -> Locked {
    let (text, figures) = example.locked().expect("the default output is sound");
    Locked {
        stem: example.stem,
        flags: example.flags.iter().map(|flag| flag.name()).collect(),
        text,
        figures,
    }
}

fn settings(path: &str) -> Settings {
    let mut settings = Settings::new();
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.set_snapshot_path(path);
    settings
}

fn files(directory: &str) -> BTreeSet<String> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join(directory);
    let entries = std::fs::read_dir(&root).into_iter().flatten();
    entries
        .filter_map(|entry| {
            let entry = entry.expect("the directory can be read");
            let is_file = entry.file_type().is_ok_and(|kind| kind.is_file());
            is_file.then(|| entry.file_name().to_string_lossy().into_owned())
        })
        .collect()
}

#[test]
fn examples_are_locked() {
    let all = all();
    for example in &all {
        settings("snapshots").bind(|| insta::assert_snapshot!(example.stem, example.text));
        settings("snapshots/figures").bind(|| {
            for figure in &example.figures {
                let name = format!("{}__{}.svg", example.stem, figure.name);
                insta::assert_binary_snapshot!(&name, figure.svg.clone().into_bytes());
            }
        });
    }
    assert_eq!(all.len(), EXAMPLES);
    assert_eq!(all.iter().map(|e| e.figures.len()).sum::<usize>(), FIGURES);
}

#[test]
fn nothing_is_locked_twice_or_without_an_example() {
    let all = all();
    let stems: BTreeSet<String> = all.iter().map(|e| format!("{}.rs", e.stem)).collect();
    assert_eq!(
        stems,
        files("examples"),
        "the files in examples/ are those listed here"
    );
    let texts: BTreeSet<String> = all.iter().map(|e| format!("{}.snap", e.stem)).collect();
    assert_eq!(texts, files("tests/snapshots"));
    let mut figures = BTreeSet::new();
    for example in &all {
        for figure in &example.figures {
            for extension in ["snap", "snap.svg"] {
                let name = format!("{}__{}.{extension}", example.stem, figure.name);
                assert!(figures.insert(name.clone()), "{name} is drawn twice");
            }
        }
    }
    assert_eq!(figures, files("tests/snapshots/figures"));
}

#[test]
fn reports_read_back_and_have_their_sections() {
    for example in all() {
        let parsed = parse(&example.text).expect("the text follows its grammar");
        for heading in [
            "parameters",
            "claims",
            "limits",
            "effects",
            "accuracy",
            "checks",
        ] {
            assert!(
                parsed.table(heading).is_some(),
                "{} has no {heading}",
                example.stem
            );
        }
        assert!(
            example.flags.contains(&"tolerance"),
            "{} has no --tolerance",
            example.stem
        );
    }
}

#[test]
fn figures_say_what_is_to_be_seen_in_colours_of_the_palette() {
    for example in all() {
        let mut seen = BTreeSet::new();
        for figure in &example.figures {
            let what = format!("{}__{}", example.stem, figure.name);
            assert!(
                figure.alt.split_whitespace().count() >= 6,
                "{what}: {}",
                figure.alt
            );
            assert!(
                seen.insert(figure.alt.clone()),
                "{what} repeats an alternative text"
            );
            assert!(!figure.svg.contains("NaN"), "{what}");
            for (at, _) in figure.svg.match_indices("var(--fig-") {
                let name = &figure.svg[at + 6..];
                let name = name.split([',', ')']).next().unwrap_or("");
                let name = name.trim_end_matches("-text");
                let known = name == "fig-math" || PALETTE.iter().any(|c| c.name == name);
                assert!(known, "{what}: {name}");
            }
        }
    }
}
