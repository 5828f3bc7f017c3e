//! What every example prints and draws, locked.
//!
//! The text of an example's report is `tests/snapshots/STEM.snap`, its figures are
//! `tests/snapshots/STEM/NAME.snap.svg`; the book's pages show these very files.

use insta::Settings;
use crate::answers::{root, with_report};
use kit::draw::{Display, PALETTE, Shape};
use kit::{Figure, Page, parse, rounded_up};
use pages::{ALL, WHOLE};
use std::collections::BTreeSet;
use std::fs::FileType;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

/// What is locked of an example.
struct Locked {
    stem: &'static str,
    flags: Vec<String>,
    text: String,
    figures: Vec<Figure>,
}

/// Every example, run once for all tests of this file, on as many threads as there are cores.
fn all() -> &'static [Locked] {
    static ALLS: OnceLock<Vec<Locked>> = OnceLock::new();
    ALLS.get_or_init(|| {
        let next = AtomicUsize::new(0);
        let worker = || -> Vec<(usize, Locked)> {
            let turn = || Some(next.fetch_add(1, Ordering::Relaxed)).filter(|n| *n < ALL.len());
            core::iter::from_fn(turn)
                .map(|n| (n, locked(ALL[n])))
                .collect()
        };
        let cores = thread::available_parallelism().map_or(1, usize::from);
        let mut done: Vec<(usize, Locked)> = thread::scope(|scope| {
            let workers: Vec<_> = (0..cores).map(|_| scope.spawn(worker)).collect();
            let results = workers.into_iter();
            results
                .flat_map(|w| w.join().expect("each example is sound"))
                .collect()
        });
        done.sort_by_key(|(n, _)| *n);
        done.into_iter().map(|(_, locked)| locked).collect()
    })
}

fn locked(page: &dyn Page) -> Locked {
    let sound = "the default output is sound";
    Locked {
        stem: page.stem(),
        flags: page.flags(),
        text: with_report(page, |report| report.text()).expect(sound),
        figures: page.figures().expect(sound),
    }
}

pub fn settings(path: &str) -> Settings {
    let path = root().join("tests").join(path);
    let mut settings = Settings::new();
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.set_snapshot_path(path);
    settings
}

fn entries(directory: &str, wanted: impl Fn(&FileType) -> bool) -> BTreeSet<String> {
    let entries = std::fs::read_dir(root().join(directory)).into_iter().flatten();
    entries
        .filter_map(|entry| {
            let entry = entry.expect("the directory can be read");
            let is_wanted = entry.file_type().is_ok_and(|kind| wanted(&kind));
            is_wanted.then(|| entry.file_name().to_string_lossy().into_owned())
        })
        .collect()
}

/// The files that are there, without those that insta puts beside what differs.
fn files(directory: &str) -> BTreeSet<String> {
    let mut files = entries(directory, FileType::is_file);
    files.retain(|name| !name.contains(".snap.new") && name != "rustfmt.toml");
    files
}

#[test]
fn examples_are_locked() {
    let all = all();
    for example in all {
        settings("snapshots").bind(|| insta::assert_snapshot!(example.stem, example.text));
        settings(&format!("snapshots/{}", example.stem)).bind(|| {
            for figure in &example.figures {
                let name = format!("{}.svg", figure.name);
                insta::assert_binary_snapshot!(&name, figure.svg().into_bytes());
            }
        });
    }
    assert_eq!(WHOLE, all.len() == files("examples").len());
}

#[test]
fn nothing_is_locked_twice_or_without_an_example() {
    let all = all();
    let stems: BTreeSet<String> = all.iter().map(|e| format!("{}.rs", e.stem)).collect();
    let texts: BTreeSet<String> = all.iter().map(|e| format!("{}.snap", e.stem)).collect();
    if WHOLE {
        assert_eq!(
            stems,
            files("examples"),
            "the files in examples/ are those listed here"
        );
        assert_eq!(texts, files("tests/snapshots"));
    }
    for example in all {
        let mut figures = BTreeSet::new();
        for figure in &example.figures {
            for extension in ["snap", "snap.svg"] {
                let name = format!("{}.{extension}", figure.name);
                assert!(figures.insert(name), "{} is drawn twice", figure.name);
            }
        }
        assert_eq!(figures, files(&format!("tests/snapshots/{}", example.stem)));
    }
    if WHOLE {
        let directories = all.iter().map(|e| e.stem.to_owned());
        let directories: BTreeSet<String> = directories.chain(["commands".to_owned()]).collect();
        assert_eq!(directories, entries("tests/snapshots", FileType::is_dir));
    }
}

/// The numbers that have the value and the bound in a row of the claims, as it is printed, hold
/// those that have the claim's own; the twin is the bound of the value before it was rounded.
#[test]
fn a_printed_bound_holds_for_the_printed_value() {
    let (mut seen, mut damaged) = (0, 0);
    for (page, example) in ALL.iter().zip(all()) {
        let parsed = parse(&example.text).expect("the text follows its grammar");
        let rows = parsed.table("claims").expect("it is printed").rows();
        with_report(*page, |report| {
            assert_eq!(rows.len(), report.claims().len(), "{}", example.stem);
            for (row, claim) in rows.iter().zip(report.claims()) {
                let number = |text: &str| text.parse::<f64>().expect("a number");
                let needed = (number(&row[1]) - claim.value).abs() + claim.bound;
                let what = format!("{} {}: {needed:e}, {row:?}", example.stem, claim.key);
                assert!(claim.key == row[0] && needed <= number(&row[3]), "{what}");
                damaged += usize::from(needed > number(&rounded_up(claim.bound)));
                seen += 1;
            }
        });
    }
    assert!(!WHOLE || seen > 800, "{seen} claims");
    assert!(!WHOLE || 2 * damaged > seen, "the twin is seen in {damaged} of {seen}");
}

/// A wrong answer that counts as right is never told its hint.
#[test]
fn every_slip_is_far_enough_from_the_answer() {
    let mut slips = 0;
    for example in all() {
        let parsed = parse(&example.text).expect("the text follows its grammar");
        let number = |section: &str, key: &str| -> f64 {
            let table = parsed.table(section).expect("it is printed");
            let row = table.rows().iter().find(|row| row[0] == key);
            row.and_then(|row| row[1].parse().ok()).expect("a number")
        };
        for slip in parsed.table("slips").map_or(&[][..], |table| table.rows()) {
            let (key, wrong): (_, f64) = (&slip[0], slip[1].parse().expect("a number"));
            let (right, within) = (number("claims", key), number("checks", key));
            let counts = within * if right == 0.0 { 1.0 } else { right.abs() };
            assert!((wrong - right).abs() > counts, "{} {key}: {wrong}", example.stem);
            slips += 1;
        }
    }
    assert!(!WHOLE || slips > 100, "{slips} slips");
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
            example.flags.iter().any(|flag| flag == "tolerance"),
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
            let svg = figure.svg();
            assert!(!svg.contains("NaN"), "{what}");
            for (at, _) in svg.match_indices("var(--fig-") {
                let name = &svg[at + 6..];
                let name = name.split([',', ')']).next().unwrap_or("");
                let name = ["-text", "-lit", "-shade"]
                    .iter()
                    .find_map(|end| name.strip_suffix(end))
                    .unwrap_or(name);
                let known = name == "fig-math" || PALETTE.iter().any(|c| c.name == name);
                assert!(known, "{what}: {name}");
            }
        }
    }
}

/// The drawing with its second label on the first, with its first on a line, and with primes at
/// their letters.
fn damaged(display: &Display) -> [Option<Display>; 3] {
    let onto = |i: usize, at: (i32, i32)| {
        let mut damaged = display.clone();
        damaged.texts.get_mut(i)?.at = at;
        Some(damaged)
    };
    let first = display.texts.first().map(|text| text.at);
    let place = display.shapes.iter().find_map(|shape| match shape {
        Shape::Line(points, _, stroke) if stroke.width > 1.5 => points.get(points.len() / 2),
        _ => None,
    });
    let mut primes = display.clone();
    let mut seen = false;
    for run in primes.texts.iter_mut().flat_map(|text| &mut text.runs) {
        seen |= run.text.contains("\u{200a}′");
        run.text = run.text.replace("\u{200a}′", "′");
    }
    [first.and_then(|at| onto(1, at)), place.and_then(|at| onto(0, *at)), seen.then_some(primes)]
}

#[test]
fn labels_in_figures_are_whole_apart_and_clear_of_lines() {
    let (mut wrong, mut labels, mut twins) = (Vec::new(), 0, [[0; 2]; 3]);
    for example in all() {
        for figure in &example.figures {
            let found = figure.display.crowded();
            wrong.extend(found.iter().map(|fault| format!("{}/{}: {fault}", example.stem, figure.name)));
            labels += figure.display.texts.len();
            for (twin, [seen, all]) in damaged(&figure.display).iter().zip(&mut twins) {
                let Some(damaged) = twin else { continue };
                *all += 1;
                *seen += usize::from(damaged.crowded().len() > found.len());
            }
        }
    }
    assert!(wrong.is_empty(), "{} labels cannot be read:\n{}", wrong.len(), wrong.join("\n"));
    let figures: usize = all().iter().map(|e| e.figures.len()).sum();
    assert!(figures > 0 && labels >= 5 * figures, "only {labels} labels seen");
    let [[onto, all_onto], [on_line, all_on_line], [primes, all_primes]] = twins;
    assert_eq!((onto, primes), (all_onto, all_primes), "a label on another, a prime on its letter");
    // A label on a line that a body hides is not found.
    assert!(!WHOLE || 10 * on_line > 9 * all_on_line, "{on_line} of {all_on_line} labels on a line");
}
