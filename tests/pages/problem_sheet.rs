//! What problem sheets must hold: numbers that the examples accept, answers that are theirs,
//! the same sheet for the same seed, and an address that the page's answer box understands.

#[path = "../../examples/problem_sheet/sheet.rs"]
#[allow(dead_code, reason = "a program of its own, whose main is not called here")]
mod sheet;

use crate::answers::thinned;
use kit::cli::joined;
use kit::{Answer, Claim, Grid, Page};
use serde_json::{Value, json};
use sheet::draw::{Drawn, computed, draw};
use sheet::exercise::{Exercise, all, asked};
use sheet::statement::{Setting, stated};
use sheet::{Asked, Sheet, address, answers_path, command, paper, run, written};
use std::collections::BTreeSet;
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;
use std::{fs, slice};

/// Those whose reports take long: drawn often they would cost more than all others together.
const SLOW: [&str; 3] = ["ch15_ex8_string", "further_3_euler_disc", "further_6_turntable"];

fn data(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../data").join(name)
}

fn offered() -> &'static [Exercise] {
    static OFFERED: LazyLock<Vec<Exercise>> =
        LazyLock::new(|| all().expect("every exercise on offer states its problem"));
    &OFFERED
}

/// The exercise with this number, unless it is left out by `PAGES`.
fn exercise(number: &str) -> Option<&'static Exercise> {
    offered().iter().find(|exercise| exercise.number == number)
}

/// All problems on a sheet without a name, drawn once for all tests.
const SHEET: u64 = 2;
fn sheet_of_all() -> &'static Sheet<'static> {
    static DRAWN: LazyLock<Vec<Sheet<'static>>> =
        LazyLock::new(|| sheet::drawn(&asked_for(SHEET, &[], &[""]), offered()).expect("a set for each is found"));
    &DRAWN[0]
}

fn asked_for(seed: u64, problems: &[&str], students: &[&str]) -> Asked {
    let owned = |names: &[&str]| names.iter().map(|name| (*name).to_owned()).collect();
    Asked {
        seed,
        problems: owned(problems),
        students: owned(students),
        title: "A sheet".into(),
        book: "http://localhost:3000/".into(),
    }
}

/// Whether `typed` is one of the values of the grid, written as the grid writes it.
fn on(grid: &Grid, typed: &str) -> bool {
    (0..grid.count()).any(|n| grid.typed(n) == typed)
}

/// The claims that the example prints for these flags with `--json`.
fn by_command(drawn: &Drawn) -> Vec<Value> {
    let page: &dyn Page = drawn.exercise.page;
    let told = page.answer(&format!("{} --json", drawn.typed()));
    assert_eq!((told.code, told.stderr.as_str()), (0, ""), "{}", drawn.typed());
    let json: Value = serde_json::from_str(&told.stdout).expect("JSON");
    json["claims"].as_array().expect("claims").clone()
}

/// Whether the sheet's answer is what the command prints, rounded to the digits of the answer.
fn is_answer(answer: &str, claim: &Claim, command: &[Value]) -> bool {
    let found = command.iter().find(|json| json["key"] == claim.key);
    let printed = found.and_then(|json| json["printed"].as_str()).unwrap_or("none");
    let mantissa = answer.split('e').next().unwrap_or("").trim_start_matches(['-', '0', '.']);
    let digits = mantissa.bytes().filter(u8::is_ascii_digit).count();
    let rounded = |text: &str| text.parse::<f64>().map(|x| format!("{:.*e}", digits.max(1) - 1, x));
    rounded(answer).is_ok() && rounded(answer) == rounded(printed)
}

/// Every exercise on offer is drawn for eight seeds, for two of them unless `PROPERTY_CASES`
/// is set, and compared with `--json` for the first two.
#[test]
fn every_draw_is_accepted_in_its_range_and_has_the_answers_of_the_command() {
    let (mut drawn_sets, mut wanted, mut compared, offered) = (0, 0, 0, offered());
    for (place, exercise) in offered.iter().enumerate() {
        let grids = exercise.page.drawn();
        let stated = stated(&exercise.problem, exercise.page.stem());
        for (flag, grid) in &grids {
            assert!(stated.contains(flag), "{}: --{flag} is drawn, but not stated", exercise.number);
            assert!(on(grid, &grid.typed(grid.count() - 1)) && grid.count() > 1, "{flag}");
            let last: f64 = grid.typed(grid.count() - 1).parse().expect("a number");
            assert!((last - grid.to).abs() < 1e-9 * grid.step, "{}: --{flag}", exercise.number);
        }
        let (mut seen, slow) = (BTreeSet::new(), SLOW.contains(&exercise.page.stem()));
        let seeds = if slow { thinned(4, 2) } else { thinned(8, 4) };
        for seed in 0..seeds {
            let drawn = match seed {
                SHEET => &sheet_of_all().problems[place],
                _ => &draw(exercise, seed, "").expect("a set is found"),
            };
            for ((flag, value), (name, grid)) in drawn.flags.iter().zip(&grids) {
                assert!(flag == name && on(grid, value), "{}: --{flag} {value}", exercise.number);
            }
            seen.insert(drawn.typed());
            drawn_sets += 1;
            let command = if seed < 2 { by_command(drawn) } else { continue };
            for claim in asked(&drawn.report) {
                let answer = paper::answer(claim);
                assert!(is_answer(&answer, claim, &command), "{}: {answer}", drawn.typed());
                compared += 1;
            }
        }
        wanted += seeds;
        assert!(seen.len() as u64 * 2 > seeds, "{}: few sets are drawn: {seen:?}", exercise.number);
    }
    assert_eq!(drawn_sets, wanted);
    assert!(compared >= 3 * offered.len(), "{compared} answers");
    for page in pages::ALL.iter().filter(|page| page.stem().starts_with("ch") && page.stem().contains("_ex")) {
        assert!(!page.drawn().is_empty(), "{}: say in parameters! what is drawn", page.stem());
    }
}

#[test]
fn a_set_that_cannot_be_used_is_noticed() {
    let mut ran = 0;
    for (number, (flag, value), words) in [
        ("16.6", ("angle", "3.0"), "upright it stands for ever"),
        ("16.6", ("slope", "1.0"), "slope"),
        // Two gears whose angular momenta cancel, two discs whose do.
        ("15.2", ("inertia-b", "0.010"), "momentum comes out right by mistake, or is zero"),
        ("15.1", ("lower-rate", "-24"), "common comes out right by mistake, or is zero"),
    ] {
        let Some(exercise) = exercise(number) else { continue };
        let refused = computed(exercise, &[(flag.into(), value.into())]).expect_err(value);
        assert!(refused.contains(words), "{flag}: {refused}");
        ran += 1;
    }
    assert!(ran == 4 || !pages::WHOLE);
    // The twins: an answer off by one in its last digit, a value between those of the grid.
    if let Some(ladder) = exercise("16.6") {
        let drawn = draw(ladder, 7, "").expect("a set is found");
        let (command, claim) = (by_command(&drawn), asked(&drawn.report)[0]);
        let answer = paper::answer(claim);
        let (head, last) = answer.split_at(answer.len() - 1);
        let off = format!("{head}{}", if last == "9" { "8" } else { "9" });
        assert!(is_answer(&answer, claim, &command) && !is_answer(&off, claim, &command), "{answer}");
    }
    let grid = Grid { from: 0.1, to: 0.5, step: 0.05 };
    assert!(on(&grid, "0.15") && !on(&grid, "0.17") && !on(&grid, "0.150") && !on(&grid, "0.55"));
}

#[test]
fn a_seed_gives_one_sheet_and_each_student_and_problem_numbers_of_their_own() {
    let all = offered();
    let Some(exercise) = all.first() else { return };
    let number = exercise.number.as_str();
    let made = |seed, students: &[&str]| written(&asked_for(seed, &[number], students), all).expect("a sheet");
    assert_eq!(made(7, &["Ada"]), made(7, &["Ada"]));
    assert_ne!(made(7, &["Ada"]), made(8, &["Ada"]));
    let flags = |seed, student| draw(exercise, seed, student).expect("a set is found").typed();
    assert_ne!(flags(7, "Ada"), flags(7, "Emmy"));
    // Who else is on the list changes nothing.
    assert!(made(7, &["Emmy", "Ada"])[0].contains(&flags(7, "Ada").replace(" --", "</span> <span>--")));
}

/// A file without what is long and locked elsewhere: fonts, drawings, and the style sheet.
fn bare(html: &str) -> String {
    let mut text = html.replace(include_str!("../../examples/problem_sheet/sheet.css"), "…\n");
    for (open, close) in [("@font-face", ");\u{20}}\n"), ("<svg", "</svg>")] {
        while let Some(at) = text.find(open) {
            let end = text[at..].find(close).expect("it ends") + close.len();
            text.replace_range(at..at + end, "");
        }
    }
    text
}

#[test]
fn a_sheet_and_its_answers_are_locked() {
    let offered = offered();
    // Every exercise can be set and drawn, whatever is locked of it.
    let (asked, sheet) = (asked_for(SHEET, &[], &[""]), sheet_of_all());
    let whole = paper::sheets(&asked, slice::from_ref(sheet)).expect("a sheet of all");
    for drawn in &sheet.problems {
        let flags = drawn.typed().replace(" --", "</span> <span>--");
        assert!(whole.contains(&flags) && !whole.contains("{{"), "{}", drawn.exercise.number);
    }
    let answers = paper::answers(&asked, slice::from_ref(sheet));
    assert!(sheet.problems.len() == offered.len() && !answers.contains("{{"));
    if !pages::WHOLE {
        return;
    }
    let files = written(&asked_for(7, &["15.4", "16.6"], &["Ada", "Emmy"]), offered).expect("a sheet");
    // One student's sheet shows all there is.
    let [sheet, answers] = files.map(|file| bare(&file));
    let (ada, _) = sheet.split_once("</main>").expect("two sheets");
    let mut settings = insta::Settings::new();
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.set_snapshot_path(data(""));
    settings.bind(|| insta::assert_snapshot!("problem_sheet", format!("{ada}</main>\n\n{answers}")));
}

#[test]
fn the_address_is_the_one_that_the_script_is_tried_with() {
    let Some(ladder) = exercise("16.6") else { return };
    let drawn = draw(ladder, 7, "Ada").expect("a set is found");
    let check = |claim: &&Claim| {
        let slip = |slip: &kit::Slip| json!({"value": slip.value, "hint": slip.hint});
        let slips: Vec<Value> = claim.slips.iter().map(slip).collect();
        json!({
            "key": claim.key, "value": claim.value, "unit": claim.unit,
            "bound": claim.bound, "within": claim.judged_within, "slips": slips,
        })
    };
    // The page as it stands, and what must be said to answers on the sheet.
    let usual = asked(ladder.usual());
    let mut judged = Vec::new();
    for (claim, usual) in asked(&drawn.report).into_iter().zip(&usual) {
        let slips = claim.slips.iter().map(|slip| format!("{:.7}", slip.value));
        for text in [paper::answer(claim), format!("{:.6}", usual.value)].into_iter().chain(slips) {
            let said = claim.verdict(Answer::read(&text).expect("an answer")).words();
            judged.push(json!([claim.key, text, said]));
        }
    }
    // The floor carries a quarter of the weight whatever the numbers; all others change.
    let rights = judged.iter().filter(|case| case[2] == "right").count();
    assert_eq!(rights, usual.len() + 1, "the numbers of the page are not right on the sheet");
    let plain = Drawn { exercise: ladder, flags: Vec::new(), report: ladder.usual().clone() };
    let own = address::parameters(&plain).expect("parameters");
    let own: Vec<Value> = own.into_iter().map(|[name, value, ..]| json!([name, value])).collect();
    let made = json!({
        "stem": ladder.page.stem(),
        "address": address::of(&drawn).expect("an address"),
        "values": drawn.flags,
        "own": own,
        "checks": usual.iter().map(check).collect::<Vec<_>>(),
        "judged": judged,
    });
    let made = serde_json::to_string_pretty(&made).expect("JSON") + "\n";
    let file = data("sheet_address.json");
    if std::env::var("INSTA_UPDATE").is_ok_and(|update| update == "always") {
        fs::write(&file, &made).expect("the file can be written");
    }
    assert_eq!(fs::read_to_string(&file).unwrap_or_default(), made, "INSTA_UPDATE=always writes it");
}

#[test]
fn what_a_sheet_cannot_set_is_refused() {
    let parameters = [["length", "4.0", "m", "length"].map(str::to_owned)];
    let setting = Setting {
        stem: "rod",
        parameters: &parameters,
        figure: &|name| (name == "setup").then(|| "<svg viewBox=\"0 0 1 1\" aria-label=\"a rod\"></svg>".into()),
        prefix: "s",
        book: "b/",
    };
    let set = "A *rod* of `x` {{param rod:length unit}}, $l = {{param rod:length}}$.[^a]\n\n1. \"Why\"?\n2. [How](a.md#b) [here](#c)?\n\n\
               {{figure rod:setup}}\n\n**So.** Seen.\n\n> The notes slip.\n\n$$\nl^2\n$$\n\n- one";
    let html = setting.html(set).expect("it can be set");
    for part in [
        "A <em>rod</em> of <code>x</code> <span class=\"glued\">4.0\u{202f}m</span>, ",
        "<ol><li>\u{201c}Why\u{201d}?</li><li><a href=\"b/a.html#b\">How</a> <a href=\"b/rod.html#c\">here</a>?</li></ol>",
        "<figcaption><strong>So.</strong> Seen.</figcaption>",
        "<ul><li>one</li></ul>",
    ] {
        assert!(html.contains(part), "{part} in {html}");
    }
    assert!(!html.contains("slip") && html.matches("<math").count() == 2, "{html}");
    for (wrong, words) in [
        ("It takes {{num rod:time}}.", "cannot set {{num rod:time}}"),
        ("A rod of {{param rod:width}}.", "cannot set {{param rod:width}}"),
        ("A rod of {{param other:length}}.", "cannot set"),
        ("{{figure rod:motion}}\n\n**It moves.**", "draws no figure motion"),
        ("$l = \\lengthy$", "TeX"),
        ("| a | table |", "cannot set this: | a | table |"),
    ] {
        let refused = setting.html(wrong).expect_err(wrong);
        assert!(refused.contains(words), "{wrong}: {refused}");
    }
}

#[test]
fn the_command_line_says_what_is_allowed() {
    let told = |line: &str| {
        let words = std::iter::once("problem_sheet").chain(line.split_whitespace());
        match command().try_get_matches_from(joined(words.map(OsString::from))) {
            Ok(matches) => run(&matches),
            Err(refused) => Err(refused.to_string()),
        }
    };
    let room = std::env::temp_dir().join(format!("problem_sheet_{}", std::process::id()));
    fs::create_dir_all(&room).expect("a directory");
    let (all, file) = (offered(), room.join("a.html"));
    let Some(number) = all.first().map(|exercise| exercise.number.clone()) else { return };
    let out = file.display();
    for (line, words) in [
        ("--problems 17.1".into(), format!("there is no problem '17.1'; there are: {number}")),
        (format!("--problems {number},{number}"), "stands twice".into()),
        ("--students 0".into(), "from 1 to 500".into()),
        ("--students -3".into(), "from 1 to 500".into()),
        ("--students 1,000".into(), "from 1 to 500 students, a whole number".into()),
        ("--students 3.5".into(), "from 1 to 500 students, a whole number".into()),
        ("--students 501".into(), "from 1 to 500".into()),
        ("--students Ada,,Emmy".into(), "a name is empty".into()),
        ("--students Ada,Ada".into(), "Ada stands twice".into()),
        ("--seed seven".into(), "a seed is a whole number from 0 to 18446744073709551615".into()),
        ("--seed -1".into(), "a seed is a whole number from 0".into()),
        ("--seed 1.5".into(), "a seed is a whole number from 0".into()),
        ("--seed --students 2".into(), "a value is required for '--seed".into()),
        ("--book example.org".into(), "http://".into()),
        (format!("--problems {number} --out {}", room.display()), "it is a directory".into()),
        (format!("--problems {number} --out {out}/b.html"), "b.html".into()),
    ] {
        let refused = told(&line).expect_err(&line);
        assert!(refused.contains(&words), "{line}: {refused}");
    }
    let line = format!("--problems {number} --students 2 --out {out}");
    let (first, again) = (told(&line).expect("written"), told(&line).expect("written again"));
    assert!(!first.contains("replaced") && again.contains("2 of these files were there before"), "{again}");
    let sheet = fs::read_to_string(&file).expect("the sheet");
    assert!(sheet.contains("Student 2") && !sheet.contains("Student 3"));
    assert!(!sheet.contains("src=\"") && !sheet.contains("<link") && !sheet.contains("<script"));
    assert!(answers_path(&file).is_file() && answers_path(&file).ends_with("a.answers.html"));
    fs::remove_dir_all(&room).expect("it can be removed");
}
