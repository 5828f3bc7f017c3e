//! The book as a whole: it builds, every stem is complete, and whatever is damaged
//! stops the build at its file and line. The pages themselves are checked by the
//! builder (`book/builder`), which is run here as a reader runs it.

mod inventory;
mod prose;
mod readme;
mod sample;

use kit::parse;
use rotation_dynamics::math::pow;
use sample::{RECORD, Sample, book, read};
use serde_json::{Value, json};
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

fn root() -> PathBuf {
    let builder = Path::new(env!("CARGO_MANIFEST_DIR"));
    builder.ancestors().nth(2).expect("two levels up").to_owned()
}

/// The names in `directory` that end with `suffix`, without it.
fn names(directory: &str, suffix: &str) -> BTreeSet<String> {
    let entries = fs::read_dir(root().join(directory)).into_iter().flatten();
    entries
        .filter_map(|entry| entry.ok()?.file_name().into_string().ok())
        .filter_map(|name| name.strip_suffix(suffix).map(Into::into))
        .collect()
}

/// The entries of the summary: title, and file if it is written.
fn summary() -> Vec<(String, Option<String>)> {
    let text = read(&root().join("book/src/SUMMARY.md"));
    let entry = |line: &str| {
        let line = line.trim_start_matches([' ', '-']).strip_prefix('[')?;
        let (title, file) = line.split_once("](")?;
        let file = file.strip_suffix(')')?;
        Some((title.to_owned(), (!file.is_empty()).then(|| file.to_owned())))
    };
    text.lines().filter_map(entry).collect()
}

/// Sections 12, exercises 9; sections 6, exercises 8; further problems 6; closing chapters 7;
/// the front page; the effects 6; pages that go on with another one; how it is computed.
const ENTRIES: usize = 12 + 9 + 6 + 8 + 6 + 7 + CONTINUED.len() + 1 + 6 + DERIVED.len();

/// Pages that go on with the page of an example, and have none of their own.
const CONTINUED: [&str; 14] = [
    "accuracy_errors",
    "ch15_1_gimbal_lock",
    "ch15_2_gimbals",
    "ch15_2_wheel_on_shaft",
    "ch15_3_two_plates",
    "ch15_4_worked_examples",
    "ch15_5_two_cones",
    "ch16_2_fast_gyroscope",
    "ch16_2_motions",
    "effects_2_sleep",
    "effects_4_levels",
    "effects_price",
    "hard_cases_sizes",
    "hard_cases_steps",
];

/// Pages that derive what a module computes: what an example is to others, its tests are to them.
const DERIVED: [(&str, &str); 7] = [
    ("how_heavy_top", "src/exact/heavy_top/mod.rs"),
    ("how_free_body", "src/exact/free_body/mod.rs"),
    ("how_double_double", "src/math/double_double.rs"),
    ("how_gauss_legendre", "src/integrators/gauss_legendre/mod.rs"),
    ("how_error_control", "src/accuracy/error_control/mod.rs"),
    ("how_events", "src/integrators/dop853/mod.rs"),
    ("how_contacts", "src/planar/contact/mod.rs"),
];

#[test]
fn the_book_is_built_and_every_page_is_in_it() {
    let entries = summary();
    assert_eq!(entries.len(), ENTRIES);
    let out = Sample::directory("whole");
    let built = book(&root(), &["--out", &out.to_string_lossy()], "");
    assert!(built.ok, "{}", built.stderr);
    // The sidebar and a page call it by one name; the sidebar may put the section before it.
    let called = |title: &str, page: &str| {
        let name = page.lines().next().and_then(|line| line.strip_prefix("# "));
        let section = title.split_once(' ').filter(|(n, _)| n.contains('.'));
        name.is_some_and(|name| name == title || section.is_some_and(|(_, rest)| rest == name))
    };
    for (title, file) in &entries {
        let file = file.as_ref().expect("no page is a draft");
        let page = read(&root().join("book/src").join(file));
        assert!(called(title, &page), "{file} is not called {title}");
        assert!(!called(&format!("The {title}"), &page), "{file}");
    }
    let mut written = 0;
    for file in entries.iter().filter_map(|(_, file)| file.as_ref()) {
        let html = read(&out.join(file).with_extension("html"));
        assert!(html.contains("<main id=\"main\""), "{file}");
        assert!(!html.contains("data-splice"), "{file}");
        written += 1;
    }
    assert_eq!(written, names("book/src", ".md").len() - 1, "pages but SUMMARY");
    // Listings come coloured; what mdBook colours them with is not in the book.
    assert!(read(&out.join("library.html")).contains("<span class=\"keyword\">fn</span>"));
    for end in [".js", ".css"] {
        let files = names(&out.to_string_lossy(), end);
        assert!(!files.iter().any(|name| name.contains("highlight")));
    }
    // The figures on the pages are the locked ones.
    let pages = names("book/src", ".md");
    for stem in names("examples", ".rs") {
        let directory = format!("tests/snapshots/{stem}");
        for figure in names(&directory, ".snap.svg") {
            let svg = read(&root().join(format!("{directory}/{figure}.snap.svg")));
            let path = svg.split(" d=\"").nth(1).and_then(|rest| rest.split('"').next());
            let on_page = |stem: &String| {
                let page = out.join(format!("{stem}.html"));
                path.is_none_or(|path| page.is_file() && read(&page).contains(path))
            };
            assert!(on_page(&stem) || pages.iter().any(on_page), "{stem}: {figure} is on no page");
        }
    }
}

#[test]
fn what_cannot_print_says_so_before_the_book_is_built() {
    let out = Sample::directory("unprinted");
    for (pdf, words) in
        [("book.pdf", "no-such-browser (named by CHROMIUM)"), ("none/book.pdf", "no directory")]
    {
        let run = std::process::Command::new(env!("CARGO_BIN_EXE_book"))
            .arg("--root")
            .arg(root())
            .arg("--out")
            .arg(&out)
            .args(["--pdf", pdf])
            .env("CHROMIUM", "no-such-browser")
            .output()
            .expect("the builder runs");
        let told = String::from_utf8_lossy(&run.stderr);
        assert!(!run.status.success() && told.contains(words), "{told}");
        assert!(!out.join("index.html").exists());
    }
}

#[test]
fn every_stem_is_complete() {
    let examples = names("examples", ".rs");
    let pages = names("book/src", ".md");
    let locked = names("tests/snapshots", ".snap");
    assert_eq!(examples, locked, "examples and locked outputs");
    let drawn = |stem: &String| !names(&format!("tests/snapshots/{stem}"), ".snap.svg").is_empty();
    assert!(examples.iter().all(drawn), "every example has a locked figure");
    let stems: BTreeSet<String> = pages
        .into_iter()
        .filter(|name| {
            let others = ["SUMMARY", "index", "errata", "exercises", "notation"];
            !others.iter().chain(&CONTINUED).any(|other| other == name)
                && !DERIVED.iter().any(|(page, _)| page == name)
        })
        .collect();
    assert_eq!(examples, stems, "examples and pages");
}

/// Each page names the head of its module, that links the page, and has a file of tests.
#[test]
fn a_derivation_and_its_module_name_each_other() {
    let linked = |page: &str, module: &str, tests: &str| {
        let head = read(&root().join(module));
        let head = head.lines().take_while(|line| line.starts_with("//!"));
        let head: String = head.collect();
        let text = read(&root().join(format!("book/src/{page}.md")));
        head.contains(&format!("book/src/{page}.md"))
            && text.contains(&format!("(source/{module}.html)"))
            && text.contains(&format!("{{{{test derivations/{tests}::"))
    };
    for (page, module) in DERIVED {
        let tests = page.trim_start_matches("how_");
        assert!(linked(page, module, tests), "{page} and {module}");
        // The damaged twins: another module, other tests.
        assert!(!linked(page, "src/exact/mod.rs", tests));
        assert!(!linked(page, module, "theta"));
    }
}

#[test]
fn what_the_notes_compute_has_a_page_a_check_and_a_figure() {
    inventory::check(&root());
}

#[test]
fn the_errata_name_their_proofs() {
    prose::check_errata(&root());
}

#[test]
fn every_exercise_is_in_the_table_and_tells_of_its_events() {
    prose::check_exercises(&root());
}

#[test]
fn the_notation_names_what_the_library_has() {
    prose::check_notation(&root());
}

/// Tests are found by no directory: a file that its package does not name never runs.
#[test]
fn every_test_is_run() {
    let listed = |manifest: &str| -> BTreeSet<String> {
        let text = read(&root().join(manifest));
        let paths = text.split("[[test]]").skip(1).map(|target| {
            let path = target.split("path = \"").nth(1);
            let path = path.and_then(|rest| rest.split('"').next());
            path.expect("a test has a path").to_owned()
        });
        paths.collect()
    };
    let mut found: BTreeSet<String> = names("tests", "").into_iter().collect();
    found.retain(|name| name.ends_with(".rs"));
    for directory in names("tests", "") {
        let main = format!("{directory}/main.rs");
        if root().join("tests").join(&main).is_file() {
            found.insert(main);
        }
    }
    let mut run = listed("tests/Cargo.toml");
    assert!(found != run, "the damaged twin: this file is not in that package");
    run.insert("book/main.rs".to_owned());
    assert_eq!(listed("book/builder/Cargo.toml").len(), 1);
    assert_eq!(found, run);
    assert_eq!(found.len(), 19);
}

/// Each damage: the file, what is replaced by what, and how the message begins.
const DAMAGES: [(&str, &str, &str, &str); 31] = [
    (
        "book/src/one.md",
        "param sample:length",
        "param sample:width",
        "book/src/one.md:35: sample has no parameter 'width'; it has: length",
    ),
    (
        "book/src/one.md",
        "param sample:length m",
        "param sample:length kg",
        "book/src/one.md:35: the unit of sample:length is m, not kg",
    ),
    (
        "book/src/one.md",
        "stills sample",
        "stills simple",
        "book/src/one.md:37: there is no figure tests/snapshots/simple/frame_*.snap.svg",
    ),
    (
        "book/src/one.md",
        "**It swings.**",
        "It swings.",
        "book/src/one.md:19: a caption begins with what the figure shows, in bold",
    ),
    (
        "book/src/one.md",
        "**Two stills.** Up and down.",
        "",
        "book/src/one.md:40: a figure is followed by a paragraph, its caption",
    ),
    (
        "book/src/one.md",
        "sample:period",
        "sample:perod",
        "book/src/one.md:5: sample claims no 'perod'",
    ),
    (
        "book/src/one.md",
        "{{num sample:period s}}",
        "{{num sample:period m}}",
        "book/src/one.md:5: the unit of sample:period is s, not m",
    ),
    (
        "book/src/one.md",
        "{{num sample:period s}}",
        "{{numb sample:period}}",
        "book/src/one.md:5: unknown directive",
    ),
    (
        "book/src/one.md",
        "{{num sample:period s}}",
        "2.0064",
        "book/src/one.md:5: 2.0064 is typed, not computed",
    ),
    (
        "book/src/one.md",
        "a swing $\\theta$",
        "a swing $\\theta",
        "book/src/one.md:7: a formula that $ opens is not closed",
    ),
    (
        "book/src/one.md",
        "\\ddot\\theta = -\\sin",
        "\\ddot\\theta = -\\sen",
        "book/src/one.md:10: TeX:",
    ),
    ("book/src/one.md", "\\frac{T}{4}", "\\frac{T}{4", "book/src/one.md:"),
    (
        "book/src/one.md",
        "\\frac{T}{4}",
        "\\frac{dT}{4}",
        "book/src/one.md:14: the d of a differential stands upright",
    ),
    // Each character must be in the font of its place: text, formula, code.
    (
        "book/src/one.md",
        "is a quarter",
        "is \u{6f22} a quarter",
        "book/src/one.md:14: the book's font Serif has no '\u{6f22}'",
    ),
    ("examples/sample.rs", "9.8;", "9.8; // \u{6f22}", "the book's font Mono has no '\u{6f22}'"),
    (
        "book/src/one.md",
        "sample:swing",
        "sample:sway",
        "book/src/one.md:17: there is no figure tests/snapshots/sample/sway.snap.svg; sample has: frame_1, frame_2, swing",
    ),
    (
        "book/src/one.md",
        "sample:physics",
        "sample:physic",
        "book/src/one.md:21: examples/sample.rs must hold '// ANCHOR: physic'",
    ),
    (
        "book/src/one.md",
        "{{listing sample:physics}}",
        "{{#include ../sample.rs:physics}}",
        "book/src/one.md:21: unknown directive",
    ),
    (
        "book/src/one.md",
        "sample:limits",
        "sample:limit",
        "book/src/one.md:25: the output of sample has no section 'limit'",
    ),
    (
        "book/src/one.md",
        "measured races:ratios",
        "measured race:ratios",
        "book/src/one.md:33: there is no benches/record/race.txt; recorded are: races",
    ),
    (
        "book/src/one.md",
        "measured races:ratios",
        "measured races:ratio",
        "book/src/one.md:33: benches/record/races.txt has no table 'ratio'; it has: conditions, ratios",
    ),
    (
        "benches/record/races.txt",
        "processor  Abacus 2",
        "abacus     2",
        "book/src/one.md:33: benches/record/races.txt does not say on what it was measured",
    ),
    (
        "book/src/one.md",
        "sample_tests::it_swings",
        "sample_tests::it_sways",
        "book/src/one.md:29: tests/sample_tests.rs has no test 'it_sways'",
    ),
    (
        "book/src/two.md",
        "\\eqref{eq:swing}",
        "\\eqref{eq:sway}",
        "book/src/two.md:3: no equation is labelled 'eq:sway'",
    ),
    (
        "book/src/two.md",
        "one.md#the-period",
        "one.md#the-perod",
        "book/src/two.md:5: the link one.html#the-perod leads to no place in one.html",
    ),
    (
        "book/src/two.md",
        "one.md#the-period",
        "won.md",
        "book/src/two.md:5: the link won.html leads nowhere",
    ),
    (
        "book/src/two.md",
        "# Two",
        "# Two\n\n![](https://example.org/a.png)",
        "book/src/two.md:3: a picture without alternative text",
    ),
    (
        "book/src/SUMMARY.md",
        "- [Two](two.md)",
        "",
        "book/src/two.md:1: SUMMARY.md does not name this page",
    ),
    (
        "examples/sample.rs",
        "// ANCHOR_END: physics",
        "",
        "book/src/one.md:21: examples/sample.rs must hold",
    ),
    (
        "tests/snapshots/sample.snap",
        "period  2.0064",
        "period  2.0064  x",
        "book/src/one.md:5: tests/snapshots/sample.snap:",
    ),
    (
        "tests/snapshots/sample/swing.snap.svg",
        " aria-label=\"A curve that swings\"",
        "",
        "book/src/one.md:17: tests/snapshots/sample/swing.snap.svg: the figure does not say",
    ),
];

#[test]
fn damage_stops_the_build_at_its_line_and_the_old_book_stays() {
    let sample = Sample::new("damage");
    let out = sample.root.join("out");
    let arguments = ["--out".to_owned(), out.to_string_lossy().into_owned()];
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let built = book(&sample.root, &arguments, "");
    assert!(built.ok, "{}", built.stderr);
    let page = read(&out.join("one.html"));
    let mut found = 0;
    for (file, from, to, message) in DAMAGES {
        let path = sample.root.join(file);
        let sound = read(&path);
        assert!(sound.contains(from), "{file} has no {from}");
        fs::write(&path, sound.replacen(from, to, 1)).expect("the copy can be written");
        let built = book(&sample.root, &arguments, "");
        fs::write(&path, sound).expect("the copy can be written");
        assert!(!built.ok, "not found: {message}");
        assert!(built.stderr.contains(message), "expected {message}\nfound {}", built.stderr);
        assert!(read(&out.join("one.html")) == page, "the old book has changed");
        assert!(!sample.root.join("out.new").exists());
        found += 1;
    }
    assert_eq!(found, 31);

    // Orphans: files that nothing shows.
    let orphans = [
        ("book/src/three.md", "book/src/three.md:1: SUMMARY.md does not name this page"),
        ("examples/other.rs", "examples/other.rs:1: no page uses this example"),
        (
            "tests/snapshots/other.snap",
            "tests/snapshots/other.snap:1: there is no examples/other.rs",
        ),
        (
            "tests/snapshots/sample/other.snap.svg",
            "tests/snapshots/sample/other.snap.svg:1: no page shows this figure",
        ),
    ];
    for (file, message) in orphans {
        fs::write(sample.root.join(file), "x\n").expect("the copy can be written");
        let built = book(&sample.root, &arguments, "");
        fs::remove_file(sample.root.join(file)).expect("the copy can be removed");
        assert!(!built.ok && built.stderr.contains(message), "{}", built.stderr);
    }

    // A directory that is no book is not overwritten.
    let other = sample.root.join("examples");
    let built = book(&sample.root, &["--out", &other.to_string_lossy()], "");
    assert!(!built.ok && built.stderr.contains("not a book"), "{}", built.stderr);
    assert!(other.join("sample.rs").is_file());
}

/// With modules beside it the sample's figure plays, its command runs; without them nothing of
/// this is there, and damage to them is named.
#[test]
fn what_moves_is_made_where_there_are_modules() {
    let sample = Sample::new("moving");
    let out = sample.root.join("out");
    let build = || book(&sample.root, &["--out", &out.to_string_lossy()], "");
    let write = |file: &str, text: &str| {
        let path = sample.root.join(file);
        fs::create_dir_all(path.parent().expect("a directory")).expect("it can be made");
        fs::write(path, text).expect("the copy can be written");
    };
    let opening = "# Two\n\n{{stills sample}}\n\n**It moves.**\n\n\
        `cargo run --example sample -- --length 2`";
    let two = read(&sample.root.join("book/src/two.md")).replacen("# Two", opening, 1);
    write("book/src/two.md", &two);
    let live = ["class=\"player\"", "class=\"run\"", "id=\"live\"", "class=\"knob "];
    let built = build();
    assert!(built.ok, "{}", built.stderr);
    let html = read(&out.join("two.html"));
    assert_eq!(live.map(|part| html.contains(part)), [false; 4], "{html}");
    assert!(!out.join("modules").exists());

    let flag = json!({"name": "length", "unit": "m", "meaning": "length of the rod", "kind": "number",
        "default": "1.5", "shown": "1.5", "usual": null, "from": null, "to": null, "words": [],
        "title": null, "ends": []});
    let declared = json!({"moves": true, "turns": false, "seen": ["length"], "flags": [flag]});
    let page = json!({"module": "a.gz", "page": 0, "declared": declared});
    let index = json!({"pages": {"sample": page}, "palette": [{"name": "fig-ink"}]}).to_string();
    write("book/modules/index.json", &index);
    write("book/modules/a.gz", "abc");
    write("book/theme/module.js", "\"joins\"\n");
    write("book/theme/run.js", "runs\n");
    write("book/theme/recording.js", "reads\n");
    let built = build();
    assert!(built.ok, "{}", built.stderr);
    let html = read(&out.join("two.html"));
    assert_eq!(live.map(|part| html.contains(part)), [true; 4], "{html}");
    let paper = read(&out.join("print.html"));
    assert_eq!(live.map(|part| paper.contains(part)), [false; 4]);
    for (file, text) in [
        ("a.gz", "abc"),
        ("a.gz.js", "Live.packed(\"a.gz\",\"YWJj\")\n"),
        ("module.js", "Live.packed(\"module\",\"\\\"joins\\\"\\n\")\n"),
        ("run.js", "runs\n"),
        ("recording.js", "reads\n"),
    ] {
        assert_eq!(read(&out.join("modules").join(file)), text, "{file}");
    }

    // The damaged twins.
    let damages = [
        (
            "book/modules/index.json",
            index.replace("palette", "colours"),
            "must hold \"pages\" and \"palette\"",
        ),
        ("book/modules/index.json", index.replace("a.gz", "c.gz"), "cannot read book/modules/c.gz"),
    ];
    let mut found = 0;
    for (file, damaged, message) in damages {
        let sound = read(&sample.root.join(file));
        write(file, &damaged);
        let built = build();
        write(file, &sound);
        assert!(!built.ok && built.stderr.contains(message), "{message}\n{}", built.stderr);
        found += 1;
    }
    assert_eq!(found, 2);
}

#[test]
fn numbers_ticks_stills_and_the_answer_box_are_made() {
    let sample = Sample::new("parts");
    let out = sample.root.join("out");
    let built = book(&sample.root, &["--out", &out.to_string_lossy()], "");
    assert!(built.ok, "{}", built.stderr);
    let html = read(&out.join("one.html"));
    let proof = "<b>2.0064\u{202f}s</b><br>error below 5\u{202f}\u{d7}\u{202f}10<sup>\u{2212}5</sup>\
                 <br>checked against: closed form</span>";
    for shown in [
        "popovertarget=\"proof-one-1\">2.0064\u{202f}s</button>",
        proof,
        "aria-label=\"checked by a test\"",
        "The length is 1.5\u{202f}m.",
        "<figure id=\"fig-frames\" data-frame=\"sample\">",
        "<span class=\"number\">Figure 2.</span> <strong>Two stills.</strong>",
        "<option value=\"period\">the period (s)</option>",
        "<li data-name=\"length\" data-value=\"1.5\">length of the rod: <span>1.5</span>\u{202f}m</li>",
        "<form class=\"answer\" data-stem=\"sample\" ",
        "<details class=\"output\">",
        "<meta name=\"description\" content=\"The period is 2.0064 s, as T = 2.0064 s says.\">",
    ] {
        assert!(html.contains(shown), "{shown}\n{html}");
    }
    assert_eq!(html.matches("<h1").count(), 1);
    // The source leads back to the tick.
    let source = read(&out.join("source/tests/sample_tests.rs.html"));
    let tick = html.split("<button type=\"button\" class=\"tick\" id=\"").nth(1);
    let tick = tick.and_then(|rest| rest.split('"').next()).expect("a tick");
    assert!(source.contains(&format!("one.html#{tick}\"")), "{source}");

    // With groups, only what has one is offered.
    let snap = sample.root.join("tests/snapshots/sample.snap");
    let grouped = read(&snap)
        .replace("key     within  meaning", "key     within  meaning     group")
        .replace(
            "period  0.001   the period",
            "period  0.001   the period  Times\nhalf    0.001   a half      -",
        )
        .replace("\n\nlimits", "\nhalf    1.0032  s     5e-5   closed form      <1e-15\n\nlimits");
    fs::write(&snap, grouped).expect("the copy can be written");
    let built = book(&sample.root, &["--out", &out.to_string_lossy()], "");
    assert!(built.ok, "{}", built.stderr);
    let html = read(&out.join("one.html"));
    let options = "<select name=\"key\"><optgroup label=\"Times\">\
                   <option value=\"period\">the period (s)</option></optgroup></select>";
    assert!(html.contains(options), "{html}");
}

#[test]
fn a_record_is_shown_with_what_it_was_measured_on() {
    let sample = Sample::new("measured");
    let out = sample.root.join("out");
    let built = book(&sample.root, &["--out", &out.to_string_lossy()], "");
    assert!(built.ok, "{}", built.stderr);
    let html = read(&out.join("one.html"));
    for shown in [
        "<td class=\"n\">17.5</td>",
        "Medians measured on Abacus 2, rustc 1.92.0, 1823-06-14; not locked.",
    ] {
        assert!(html.contains(shown), "{shown}\n{html}");
    }
}

/// A record is of an example, was measured under named conditions, and holds times. Whether a
/// line of the strip has one is not asked: a missing time is a dash.
#[test]
fn the_records_of_the_strips_are_whole() {
    let examples = names("examples", ".rs");
    let (mut records, mut timed) = (0, 0);
    for stem in names("benches/record/strips", ".txt") {
        assert!(examples.contains(&stem), "there is no example {stem}");
        let text = read(&root().join(format!("benches/record/strips/{stem}.txt")));
        let record = parse(&text).expect("a record");
        let rows = |name: &str| {
            let table = record.table(name);
            let table = table.unwrap_or_else(|| panic!("{stem} has no {name}"));
            table.rows().to_vec()
        };
        let conditions: Vec<String> = rows("table conditions").concat();
        for condition in ["processor", "compiler", "date"] {
            assert!(conditions.iter().any(|c| c == condition), "{stem}: {condition}");
        }
        let strip = record.table("table strip").expect("a strip");
        assert_eq!(
            strip.columns(),
            ["method", "requested", "delivered", "work", "time", "interval"],
            "{stem}"
        );
        for (cell, row) in [(1, rows("table unit"))]
            .into_iter()
            .chain([(4, strip.rows().to_vec())])
            .flat_map(|(at, rows)| rows.into_iter().map(move |row| (row[at].clone(), row)))
        {
            let time: f64 = cell.parse().expect("a number");
            assert!(time > 0.0 && time.is_finite(), "{stem}: {row:?}");
            timed += 1;
        }
        records += 1;
    }
    assert!(records > 0 && timed > records, "{records} records, {timed} times");
}

#[test]
fn a_time_is_shown_beside_its_own_line_alone() {
    let sample = Sample::new("times");
    let out = sample.root.join("out");
    let built = || book(&sample.root, &["--out", &out.to_string_lossy()], "");
    let record = sample.root.join("benches/record/strips/sample.txt");
    let page = || read(&out.join("one.html"));

    // Without a record there is no column and no note.
    let bare = built();
    assert!(bare.ok, "{}", bare.stderr);
    assert!(!page().contains("<th scope=\"col\" class=\"n\">time</th>"));
    assert!(!page().contains("one sample of the closed form"));

    fs::create_dir_all(sample.root.join("benches/record/strips")).expect("the copy can be made");
    fs::write(&record, RECORD).expect("the copy can be written");
    let timed = built();
    assert!(timed.ok, "{}", timed.stderr);
    let html = page();
    for shown in [
        "<th scope=\"col\" class=\"n\">time</th>",
        "The cheapest method set by hand that delivered 10<sup>\u{2212}9</sup>, of those that are timed:",
        // Not the least: that of a rival is not known.
        "<td class=\"n\">5123</td>",
        "<td class=\"n\">6789</td>",
        "<td class=\"n\">–</td>",
        "one sample of the closed form (75\u{202f}ns), medians measured on Abacus 2, rustc 1.92.0; \
         not locked.",
    ] {
        assert!(html.contains(shown), "{shown}\n{html}");
    }
    for hidden in ["271", "999"] {
        assert!(!html.contains(&format!(">{hidden}<")), "{hidden}");
    }

    let whole = RECORD.replace("28 steps", "30 steps");
    fs::write(&record, whole).expect("the copy can be written");
    let timed = built();
    assert!(timed.ok, "{}", timed.stderr);
    assert!(page().contains("<td class=\"n\"><strong>271</strong></td>"));

    fs::write(&record, RECORD.replace("  6789", "")).expect("the copy can be written");
    let damaged = built();
    assert!(!damaged.ok, "a damaged record");
    let message = "benches/record/strips/sample.txt:";
    assert!(damaged.stderr.contains(message), "{}", damaged.stderr);
}

/// The JSON that mdbook sends for a chapter of the sample.
fn chapter(sample: &Sample, name: &str, file: &str, number: u32) -> Value {
    json!({"Chapter": {
        "name": name,
        "content": read(&sample.root.join("book/src").join(file)),
        "number": if number == 0 { Value::Null } else { json!([number]) },
        "sub_items": [],
        "path": file,
        "source_path": file,
        "parent_names": [],
    }})
}

#[test]
fn the_stock_mdbook_gets_the_same_pages() {
    let sample = Sample::new("stock");
    let ours = sample.root.join("ours");
    let built = book(&sample.root, &["--out", &ours.to_string_lossy()], "");
    assert!(built.ok, "{}", built.stderr);

    for (renderer, supported) in [("pages", true), ("html", true), ("epub", false)] {
        let answer = book(&sample.root, &["preprocess", "supports", renderer], "");
        assert_eq!(answer.ok, supported, "{renderer}");
    }

    let book_root = sample.root.join("book");
    let config = sample::config();
    let context = |version: &str| {
        json!({
            "root": book_root,
            "config": config,
            "renderer": "pages",
            "mdbook_version": version,
        })
    };
    let items = json!({"items": [
        chapter(&sample, "One", "one.md", 1),
        chapter(&sample, "Two", "two.md", 2),
        {"Chapter": {"name": "Three", "content": "", "number": [3], "sub_items": [],
            "path": null, "source_path": null, "parent_names": []}},
    ]});
    let sent = json!([context("0.5.4"), items]).to_string();
    let expanded = book(&sample.root, &["preprocess"], &sent);
    assert!(expanded.ok, "{}", expanded.stderr);
    let expanded: Value = serde_json::from_str(&expanded.stdout).expect("a book in JSON");

    let theirs = sample.root.join("theirs");
    let sent = json!({
        "version": "0.5.4",
        "root": book_root,
        "book": expanded,
        "config": config,
        "destination": theirs,
    });
    let rendered = book(&sample.root, &["render"], &sent.to_string());
    assert!(rendered.ok, "{}", rendered.stderr);
    for page in ["one.html", "two.html", "index.html", "print.html"] {
        assert!(read(&ours.join(page)) == read(&theirs.join(page)), "{page} differs");
    }

    // Another version of the protocol, and a damaged page, are refused.
    let old = json!([context("0.4.52"), items]).to_string();
    let refused = book(&sample.root, &["preprocess"], &old);
    assert!(!refused.ok && refused.stderr.contains("mdbook 0.4.52 calls it"));
    let damaged = sent_with(&context("0.5.4"), &items, "sample:period", "sample:perod");
    let refused = book(&sample.root, &["preprocess"], &damaged);
    assert!(!refused.ok && refused.stderr.contains("book/src/one.md:5:"));
}

fn sent_with(context: &Value, items: &Value, from: &str, to: &str) -> String {
    json!([context, items]).to_string().replace(from, to)
}

/// The colours of a theme in the style sheet: variable and value.
fn theme(css: &str, selector: &str) -> Vec<(String, u32)> {
    let start = css.find(selector).expect("the theme is in the style sheet");
    let block = &css[start..start + css[start..].find('}').expect("its end")];
    let colour = |line: &str| {
        let (name, value) = line.trim().split_once(": #")?;
        Some((name.to_owned(), u32::from_str_radix(value.trim_end_matches(';'), 16).ok()?))
    };
    block.lines().filter_map(colour).collect()
}

/// Contrast of two colours after WCAG 2.1, 1 to 21.
fn contrast(a: u32, b: u32) -> f64 {
    let luminance = |rgb: u32| -> f64 {
        let channel = |shift: u32| {
            let c = f64::from((rgb >> shift) & 255) / 255.0;
            if c <= 0.04045 { c / 12.92 } else { pow((c + 0.055) / 1.055, 2.4) }
        };
        0.2126 * channel(16) + 0.7152 * channel(8) + 0.0722 * channel(0)
    };
    let (a, b) = (luminance(a) + 0.05, luminance(b) + 0.05);
    if a > b { a / b } else { b / a }
}

#[test]
fn text_and_lines_have_contrast_in_both_themes() {
    let css = read(&root().join("book/theme/book.css"));
    let texts = ["--fg", "--quiet", "--links", "--slip", "--tip", "--note", "--inline-code-color"];
    let mut measured = 0;
    for selector in [".light, html", "\n.coal {"] {
        let colours = theme(&css, selector);
        let get = |name: &str| {
            let found = colours.iter().find(|(n, _)| n == name);
            found.unwrap_or_else(|| panic!("{selector} has no {name}")).1
        };
        for ground in ["--bg", "--panel"] {
            for text in texts {
                let c = contrast(get(text), get(ground));
                assert!(c >= 4.5, "{selector} {text} on {ground}: {c:.2}");
                measured += 1;
            }
        }
        for text in ["--sidebar-fg", "--sidebar-non-existant", "--sidebar-active"] {
            let c = contrast(get(text), get("--sidebar-bg"));
            assert!(c >= 4.5, "{selector} {text}: {c:.2}");
            measured += 1;
        }
        let c = contrast(get("--rule"), get("--bg"));
        assert!(c >= 3.0, "{selector} --rule: {c:.2}");
    }
    assert_eq!(measured, 34);
    // The damaged twin: mdBook's own grey for unwritten chapters fails.
    assert!(contrast(0x00AA_AAAA, 0x00FA_FAFA) < 4.5);
}

#[test]
fn nothing_in_the_theme_comes_from_outside() {
    let mut read_files = 0;
    for file in [
        "book/theme/book.css",
        "book/theme/formulas.css",
        "book/theme/parts.css",
        "book/theme/paper.css",
        "book/theme/answer.js",
        "book/theme/check.js",
        "book/theme/fonts/fonts.css",
    ] {
        let text = read(Path::new(&root().join(file)));
        assert!(!text.contains("://") && !text.contains("url(\"//"), "{file}");
        read_files += 1;
    }
    assert_eq!(read_files, 7);
}

#[test]
fn the_style_sheets_name_the_fonts_whose_characters_are_checked() {
    let css = |name: &str| read(&root().join("book/theme").join(name));
    let fonts = css("fonts/fonts.css");
    let mut named = BTreeSet::new();
    for face in fonts.split("@font-face").skip(1) {
        let file = face.split("resource \"").nth(1).and_then(|rest| rest.split('"').next());
        let file = file.expect("a font has a file");
        assert!(root().join("book/theme").join(file).is_file(), "{file}");
        assert!(face.contains("font-display: swap"), "{file}");
        named.insert(file.trim_start_matches("fonts/").trim_end_matches(".woff2").to_owned());
    }
    assert_eq!(named, names("book/theme/fonts", ".woff2"));
    assert_eq!(named.len(), 6);
    let book = css("book.css");
    for stack in [
        "--serif: \"Book Serif\", \"Book Maths\",",
        "--mono-font: \"Book Mono\", \"Book Maths\",",
        "sans-serif, \"Book Serif\", \"Book Maths\";",
    ] {
        assert!(book.contains(stack), "{stack}");
    }
    let formulas = css("formulas.css");
    assert!(formulas.contains("math { font-family: \"Book Maths\", math;"));
    assert!(formulas.contains("math mtext { font-family: var(--serif); }"));
}
