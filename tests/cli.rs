//! The command line that all examples share, driven in process with an example of
//! its own: a rod on a pivot. Nothing here depends on what the book's examples compute.

use kit::cli::Outcome;
use kit::draw::{Curve, Ink, Panel};
use kit::{
    Decided, Error, Example, Figure, Found, MovingPicture, Recorded, Recordings, Report, Result,
    Trajectory, claim, parse,
};
use std::fs;
use std::path::PathBuf;

kit::parameters! {
    /// A rod, not yet told where its pivot is.
    pub struct Parameters {
        /// length of the rod
        length: number(3.0, "m", above(0.0));
        /// pivot from the middle
        offset: number(0.0, "m", any());
        /// mass, if it matters
        mass: optional("kg", any());
        /// how it starts
        start: choice("rest", "turning", "broken");
    }
}

fn report(p: &Parameters) -> Result<Report> {
    let mut report = Report::new("A rod on a pivot", "a thin rod turns about a point of itself")?;
    let inertia = p.length * p.length / 12.0 + p.offset * p.offset;
    let halves = [p.length / 2.0 - p.offset, p.length / 2.0 + p.offset];
    let by_halves = halves.map(|l| l * l * l / 3.0).iter().sum::<f64>() / p.length;
    let length = p.length;
    report.add(
        claim("inertia", "moment of inertia over mass", inertia, "m^2")
            .agrees_with("two halves", by_halves, 1e-12)
            .slip(length * length / 3.0, "that is about the end of the rod"),
    )?;
    let mass = p.mass.unwrap_or(1.0);
    report.add(claim("mass", "mass", mass, "kg").agrees_with("itself", mass, 0.0))?;
    Ok(report)
}

fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let mut samples = Trajectory::new(["t [s]", "angle [rad]"])?;
    for i in 0..5 {
        // A motion that breaks down half-way, on demand.
        let broken = p.start == "broken" && i == 3;
        samples.push([0.1 * f64::from(i), if broken { f64::NAN } else { p.offset }])?;
    }
    Ok(samples)
}

fn figures(p: &Parameters) -> Result<Vec<Figure>> {
    let line = Curve::new([(0.0, 0.0), (1.0, p.length)], Ink::Body);
    let panel = Panel::new("line", "a straight line that ends at the rod's length");
    Ok(vec![panel.curve(line).figure()?])
}

const EXAMPLE: Example<Parameters> = Example {
    stem: "rod",
    about: "A rod on a pivot",
    report,
    figures,
    trajectory,
    moving_picture: None,
    recordings: None,
};

fn answer(arguments: &str) -> Outcome {
    EXAMPLE.answer(arguments.split_whitespace())
}

/// A fresh empty directory that is removed at the end.
struct Scratch(PathBuf);

impl Scratch {
    fn new(name: &str) -> Self {
        let path = std::env::temp_dir().join(format!("rod-{name}-{}", std::process::id()));
        let _ = fs::remove_dir_all(&path);
        fs::create_dir_all(&path).expect("a temporary directory");
        Self(path)
    }

    fn names(&self) -> Vec<String> {
        let entries = fs::read_dir(&self.0).expect("the directory is there");
        let mut names: Vec<String> = entries
            .map(|e| e.expect("an entry").file_name().to_string_lossy().into_owned())
            .collect();
        names.sort();
        names
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

#[test]
fn the_default_output_reads_back_as_written() {
    let outcome = answer("");
    assert_eq!((outcome.code, outcome.stderr.as_str()), (0, ""));
    // What is locked holds the answer box's data too; what is printed does not.
    let report = EXAMPLE.page().report().expect("the example is sound");
    let locked = report.text().expect("it can be printed");
    assert!(locked.starts_with(&outcome.stdout) && !outcome.stdout.contains("\nchecks\n"));
    let parsed = parse(&locked).expect("the text follows its grammar");
    assert_eq!(parsed.title, "A rod on a pivot");
    let headings: Vec<&str> = parsed.tables.iter().map(|t| t.heading()).collect();
    assert_eq!(headings, ["parameters", "claims", "checks", "slips"]);
    let claims = parsed.table("claims").expect("there are claims");
    assert_eq!(claims.rows()[0][..3], ["inertia", "0.750000000000", "m^2"]);
    let parameters = parsed.table("parameters").expect("there are parameters");
    // The mass is not set, and so not listed.
    assert!(parameters.rows().iter().all(|row| row[0] != "--mass"));
    // Writing it again gives the same text.
    let again: String = parsed.tables.iter().map(|t| format!("\n{t}")).collect();
    assert_eq!(format!("{}\n{}\n{again}", parsed.title, parsed.description), locked);
}

#[test]
fn flags_set_parameters_and_negative_numbers_are_numbers() {
    for (arguments, inertia) in [
        ("--length 6", "3.000000000000"),
        ("--offset -0.5", "1.000000000000"),
        ("--offset=-5e-1", "1.000000000000"),
        ("--offset -5.0e-1 --length 3", "1.000000000000"),
        ("--offset -.5", "1.000000000000"),
        // As the answers of `--check` are read.
        ("--offset \u{2212}0,5", "1.000000000000"),
        ("--offset -1/2", "1.000000000000"),
        ("--offset -5x10^-1", "1.000000000000"),
        ("--offset=-0.5m", "1.000000000000"),
        ("--offset -sqrt(1/4)", "1.000000000000"),
    ] {
        let outcome = answer(arguments);
        assert_eq!(outcome.code, 0, "{arguments}: {}", outcome.stderr);
        assert!(outcome.stdout.contains(&format!("inertia  {inertia}")), "{arguments}");
    }
    assert!(answer("--mass 2").stdout.contains("--mass    2"));
    // A column with a negative number keeps its digits below each other, and reads back.
    let text = answer("--offset -0.5 --mass 2").stdout;
    assert!(text.contains("--length   3 ") && text.contains("--offset  -0.5 "), "{text}");
    let parsed = parse(&text).expect("the text follows its grammar");
    let again: String = parsed.tables.iter().map(|t| format!("\n{t}")).collect();
    assert!(text.ends_with(&again));
}

#[test]
fn bad_input_is_refused_with_its_reason() {
    for (arguments, told) in [
        ("--lenght 3", "--length"),
        ("--length", "a value is required"),
        ("--length three", "that is not a number"),
        ("--length NaN", "NaN is not a finite number"),
        ("--length 1e400", "inf is not a finite number"),
        ("--length 1/0", "that is not a finite number"),
        ("--length -inf", "-inf is not a finite number"),
        ("--length 3s", "the unit is m, not s"),
        ("--length 30°", "the unit is m, not deg"),
        ("--length 1,234.5", "decimals come after a point"),
        ("--length --offset 1", "a value is required for '--length"),
        ("--length 0", "length = 0 is not allowed: it must be greater than 0"),
        ("--length -3", "length = -3 is not allowed"),
        ("--length 1 --length 2", "cannot be used multiple times"),
        ("--start asleep", "possible values: rest, turning, broken"),
        ("--check", "a value is required"),
        ("--check inertia", "write KEY=VALUE"),
        ("--check inertia=NaN", "that is not a number"),
        ("--check inertia=1e999", "that is not a finite number"),
        ("--check inertia=log(2)", "that function is not known; there are"),
        ("--check inertia=1,234.5", "decimals come after a point"),
        ("--check inerta=3", "there is no inerta; there are: inertia, mass"),
        ("--check inertia=3 --json", "cannot be used with"),
        ("stray", "unexpected argument"),
    ] {
        let outcome = answer(arguments);
        assert_eq!(outcome.code, 2, "{arguments}");
        assert_eq!(outcome.stdout, "", "{arguments}");
        assert!(outcome.stderr.contains(told), "{arguments}: {}", outcome.stderr);
    }
}

#[test]
fn help_names_every_flag_with_its_default() {
    let help = answer("--help");
    assert_eq!((help.code, help.stderr.as_str()), (0, ""));
    for part in [
        "--length <NUMBER>",
        "length of the rod [3 m; greater than 0]",
        "pivot from the middle [0 m]",
        "--mass <NUMBER>",
        "mass, if it matters, in kg",
        "--start <WORD>",
        "[rest]",
        "--check <KEY=VALUE>",
        "--json",
        "--csv <FILE>",
        "--svg <DIR>",
    ] {
        assert!(help.stdout.contains(part), "{part} in {}", help.stdout);
    }
}

#[test]
fn json_holds_the_same_bits() {
    let outcome = answer("--json --length 0.7 --offset 0.1");
    let json: serde_json::Value = serde_json::from_str(&outcome.stdout).expect("valid JSON");
    assert_eq!(json["stem"], "rod");
    let claim = &json["claims"][0];
    assert_eq!(claim["key"], "inertia");
    assert_eq!(claim["value"].as_f64(), Some(0.7 * 0.7 / 12.0 + 0.1 * 0.1));
    assert_eq!(claim["oracle"], "two halves");
    assert_eq!(claim["bound"].as_f64(), Some(1e-12));
    assert!(claim["error"].as_f64().is_some_and(|e| e < 1e-16));
}

#[test]
fn an_answer_is_judged() {
    let cases = [
        ("inertia=0.75", 0, "right: inertia = 0.750000000000 m^2"),
        ("inertia=0.7507", 1, "nearly: your inertia is right to 2 digits; give 4"),
        ("inertia=0.7508", 1, "nearly: your inertia is right to 2 digits"),
        ("inertia=3", 1, "that is about the end of the rod"),
        ("inertia=-0.75", 1, "the sign is not"),
        ("inertia=1.5", 1, "too large by a factor 2"),
        ("inertia=0.375", 1, "too small by a factor 2"),
        ("inertia=3/4", 0, "right: inertia"),
        ("inertia=cos(pi/6)^2", 0, "right: inertia"),
        ("inertia=sin(pi/6)^2", 1, "not yet: your inertia is not right\n"),
        ("inertia=0.75 s", 1, "not right: the unit is"),
        ("inertia=1.33333", 1, "one over the value"),
        ("inertia=0.7", 1, "not yet: your inertia is not right\n"),
    ];
    for (given, code, told) in cases {
        let outcome = EXAMPLE.answer(["--check", given]);
        assert_eq!(outcome.code, code, "{given}: {}", outcome.stdout);
        assert!(outcome.stdout.contains(told), "{given}: {}", outcome.stdout);
    }
    let both = answer("--check inertia=0.75 --check mass=2");
    assert_eq!((both.code, both.stdout.lines().count()), (1, 2));
}

#[test]
fn files_are_written_whole() {
    let scratch = Scratch::new("whole");
    let csv = scratch.0.join("rod.csv");
    let svg = scratch.0.join("figures");
    let outcome = EXAMPLE.answer([
        "--csv".as_ref(),
        csv.as_os_str(),
        "--svg".as_ref(),
        svg.as_os_str(),
        "--offset".as_ref(),
        "0.1".as_ref(),
    ]);
    assert_eq!(outcome.code, 0, "{}", outcome.stderr);
    let text = fs::read_to_string(&csv).expect("the file is there");
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!((lines[0], lines[3], lines.len()), ("t [s],angle [rad]", "0.2,0.1", 6));
    assert_eq!(scratch.names(), ["figures", "rod.csv"]);
    let figure = fs::read_to_string(svg.join("rod__line.svg")).expect("the figure is there");
    assert!(figure.ends_with("</svg>\n"));
}

#[test]
fn a_failure_leaves_the_old_file_and_nothing_else() {
    let scratch = Scratch::new("failure");
    let csv = scratch.0.join("rod.csv");
    fs::write(&csv, "old\n").expect("writable");
    let refused = |arguments: &[&std::ffi::OsStr]| {
        let outcome = EXAMPLE.answer(arguments);
        assert_eq!((outcome.code, outcome.stdout.as_str()), (2, ""), "{arguments:?}");
        assert!(!outcome.stderr.is_empty(), "{arguments:?}");
        assert_eq!(fs::read_to_string(&csv).expect("still there"), "old\n");
    };
    let (flag, path) = ("--csv".as_ref(), csv.as_os_str());
    // The motion breaks down; the parameters are refused; the answer has no such key.
    refused(&[flag, path, "--start".as_ref(), "broken".as_ref()]);
    refused(&[flag, path, "--length".as_ref(), "-1".as_ref()]);
    refused(&[flag, path, "--check".as_ref(), "weight=1".as_ref()]);
    // The figures cannot be written, for their directory is a file.
    refused(&[flag, path, "--svg".as_ref(), path]);
    // The file's directory does not exist, or the file is a directory.
    let nowhere = scratch.0.join("no").join("rod.csv");
    refused(&[flag, nowhere.as_os_str()]);
    refused(&[flag, scratch.0.as_os_str()]);
    // Directories made for the figures go again when the file cannot be written.
    let figures = scratch.0.join("new").join("figures");
    let svg = "--svg".as_ref();
    refused(&[flag, nowhere.as_os_str(), svg, figures.as_os_str()]);
    assert_eq!(scratch.names(), ["rod.csv"]);
}

#[cfg(unix)]
#[test]
fn links_and_pipes_are_written_through_and_devices_refused() {
    use std::os::unix::fs::{PermissionsExt, symlink};
    let scratch = Scratch::new("links");
    let (file, link, dangling) =
        (scratch.0.join("rod.csv"), scratch.0.join("link.csv"), scratch.0.join("dangling.csv"));
    let csv = |path: &std::path::Path| EXAMPLE.answer(["--csv".as_ref(), path.as_os_str()]);
    fs::write(&file, "old\n").expect("writable");
    fs::set_permissions(&file, fs::Permissions::from_mode(0o640)).expect("ours");
    symlink("rod.csv", &link).expect("a link");
    let outcome = csv(&link);
    assert_eq!(outcome.code, 0, "{}", outcome.stderr);
    assert!(outcome.stderr.contains("1 of these files were there before"));
    assert!(link.is_symlink(), "the link stays a link");
    let text = fs::read_to_string(&file).expect("written through");
    assert!(text.starts_with("t [s]"), "{text}");
    let mode = fs::metadata(&file).expect("there").permissions().mode();
    assert_eq!(mode & 0o777, 0o640, "permissions are kept");

    symlink("new.csv", &dangling).expect("a link");
    let outcome = csv(&dangling);
    assert_eq!(outcome.code, 0, "{}", outcome.stderr);
    assert!(!outcome.stderr.contains("before"), "{}", outcome.stderr);
    assert!(scratch.0.join("new.csv").is_file() && dangling.is_symlink());

    // A link to itself, a device, a file that is protected: nothing is written.
    let circle = scratch.0.join("circle.csv");
    symlink("circle.csv", &circle).expect("a link");
    let mut refused = 0;
    fs::set_permissions(&file, fs::Permissions::from_mode(0o440)).expect("ours");
    for (path, reason) in [
        (circle.as_path(), "circle"),
        ("/dev/null".as_ref(), "it is a device"),
        ("/dev/full".as_ref(), "it is a device"),
        (file.as_path(), "it is write-protected"),
    ] {
        let outcome = csv(path);
        assert_eq!((outcome.code, outcome.stdout.as_str()), (2, ""), "{path:?}");
        let told = &outcome.stderr;
        assert!(told.contains(reason) || !path.exists(), "{path:?}: {told}");
        refused += 1;
    }
    assert_eq!(refused, 4);
    assert_eq!(fs::read_to_string(&file).expect("there"), text);

    // A pipe gets the whole, and stays a pipe.
    let pipe = scratch.0.join("pipe");
    let made = std::process::Command::new("mkfifo").arg(&pipe).status();
    assert!(made.is_ok_and(|status| status.success()));
    let reader = {
        let pipe = pipe.clone();
        std::thread::spawn(move || fs::read_to_string(pipe))
    };
    assert_eq!(csv(&pipe).code, 0);
    let read = reader.join().expect("no panic").expect("readable");
    assert_eq!(read, text);
    let names = scratch.names();
    assert!(names.iter().all(|name| !name.ends_with(".tmp")), "{names:?}");
}

/// Once for real, as the program that a reader runs: the ladder, with its output going to a pipe that nobody
/// reads, and to one that is read; and its figures in files.
#[test]
#[ignore = "compiles an example as a program: a part of the gate"]
fn a_real_example_survives_a_closed_pipe_and_refuses_bad_input() {
    use std::process::{Command, Stdio};
    // With the kit that the tests have compiled; examples are only checked there, unless they are to be fast.
    let profile = ["--profile", "test", "--config", "profile.test.package.examples.opt-level=1"];
    let run = |arguments: &[&str]| {
        let mut command = Command::new(env!("CARGO"));
        command.args(["run", "--quiet", "--offline", "--example", "ch16_ex6_ladder"]);
        command
            .args(profile)
            .arg("--")
            .current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/.."))
            .args(arguments)
            .stdout(Stdio::piped())
            .stderr(Stdio::piped());
        command.spawn().expect("cargo runs")
    };
    let mut unread = run(&[]);
    drop(unread.stdout.take());
    let unread = unread.wait_with_output().expect("it ends");
    let told = String::from_utf8_lossy(&unread.stderr);
    assert!(unread.status.success(), "{told}");
    assert!(!told.contains("panicked"), "{told}");

    let read = run(&["--check", "t_release=1e9"]).wait_with_output().expect("it ends");
    assert_eq!(read.status.code(), Some(1));
    assert_eq!(String::from_utf8_lossy(&read.stdout), "not yet: your t_release is not right\n");

    let refused = run(&["--length", "-3"]).wait_with_output().expect("it ends");
    assert_eq!((refused.status.code(), refused.stdout.len()), (Some(2), 0));
    assert!(String::from_utf8_lossy(&refused.stderr).starts_with("error: length = -3"));

    let folder = std::env::temp_dir().join(format!("ladder-{}", std::process::id()));
    let drawn =
        run(&["--svg", folder.to_str().expect("a name")]).wait_with_output().expect("it ends");
    assert!(drawn.status.success());
    let figure =
        std::fs::read_to_string(folder.join("ch16_ex6_ladder__setup.svg")).expect("a figure");
    assert!(figure.trim_end().ends_with("</svg>"));
    std::fs::remove_dir_all(folder).expect("its own folder");
}

kit::parameters! {
    /// A pendulum, whose weight is in and whose friction is not.
    pub struct Swing {
        /// length
        length: number(1.0, "m", above(0.0));
        /// friction of the hinge
        friction: effect(0.02, "N m s", above(0.0));
        /// density of the air
        air_drag: effect(1.2, "kg/m^3", from_to(0.0, 2.0));
        /// weight
        gravity: effect(9.81, "m/s^2", any()).present();
    }
}

/// The decay of the swing, and its period where there is weight.
fn swinging(p: &Swing) -> Result<Report> {
    let mut report = Report::new("A pendulum", "a weight on a string")?;
    let decay = 0.5 * (p.friction.unwrap_or(0.0) + p.air_drag.unwrap_or(0.0)) / p.length;
    let gravity = p.gravity.unwrap_or(0.0);
    kit::claims! { report,
        /// rate at which a swing dies
        decay: decay, "1/s", "itself" => decay, within 1e-3;
        /// square of the rate of the swings
        square: gravity / p.length, "1/s^2", "itself" => gravity / p.length, within 1e-3,
            if p.gravity.is_some();
    }?;
    Ok(report)
}

const SWING: Example<Swing> = Example {
    stem: "swing",
    about: "A pendulum",
    report: swinging,
    figures: |_| Ok(Vec::new()),
    trajectory: |_| Trajectory::new(["t [s]"]),
    moving_picture: None,
    recordings: None,
};

fn swing(arguments: &str) -> Outcome {
    SWING.answer(arguments.split_whitespace())
}

/// The rows of the effects that are in, as `name value unit`.
fn effects_in(arguments: &str) -> Vec<String> {
    let outcome = swing(arguments);
    assert_eq!((outcome.code, outcome.stderr.as_str()), (0, ""), "{arguments}");
    let parsed = parse(&outcome.stdout).expect("the text follows its grammar");
    let table = parsed.table("parameters").expect("there are parameters");
    let effect = |row: &Vec<String>| {
        Some(format!("{} {} {}", row[0].strip_prefix("--with ")?, row[1], row[2]))
    };
    table.rows().iter().filter_map(effect).collect()
}

#[test]
fn effects_are_put_in_and_left_out_by_name() {
    let weight = "gravity 9.81 m/s^2";
    let cases: [(&str, &[&str]); 8] = [
        ("", &[weight]),
        ("--with friction", &["friction 0.02 N m s", weight]),
        ("--with friction=0.03 --length 2", &["friction 0.03 N m s", weight]),
        (
            "--with=friction=3e-2 --with air-drag=0",
            &["friction 0.03 N m s", "air-drag 0 kg/m^3", weight],
        ),
        ("--without gravity", &[]),
        ("--without gravity --with air-drag", &["air-drag 1.2 kg/m^3"]),
        ("--with gravity=-1.62", &["gravity -1.62 m/s^2"]),
        // It is out already.
        ("--without friction", &[weight]),
    ];
    for (arguments, expected) in cases {
        assert_eq!(effects_in(arguments), expected, "{arguments}");
    }
    // What a reader answers, what is read by machines, and what sheets set sees them too.
    let judged = swing("--with friction=0.03 --check decay=0.015");
    assert_eq!((judged.code, judged.stdout.as_str()), (0, "right: decay = 0.015 1/s\n"));
    assert!(swing("--json --with friction").stdout.contains("\"value\": 0.01,"));
    assert!(!swing("--json --without gravity").stdout.contains("square"));
    let set = SWING.page().report_with(&[("friction", 0.5), ("air-drag", 0.1)]).expect("sound");
    assert_eq!(set.claim("decay").map(|claim| claim.value), Some(0.3));
}

#[test]
fn effects_that_cannot_be_are_refused_by_name() {
    let cases = [
        (
            "--with frction",
            "there is no effect 'frction'; there are: friction, air-drag, gravity; do you mean friction?",
        ),
        ("--without grvty", "do you mean gravity?"),
        ("--with length", "there is no effect 'length'; there are: friction, air-drag, gravity\n"),
        ("--with magnetism=2", "there are: friction, air-drag, gravity\n"),
        ("--with friction=-3", "friction = -3 is not allowed: it must be greater than 0"),
        ("--with air-drag=2.5", "air_drag = 2.5 is not allowed: it must be from 0 to 2"),
        ("--with friction=strong", "--with friction=strong: that is not a number"),
        ("--with friction=", "that is not a number"),
        ("--with friction=nan", "NaN is not a finite number"),
        ("--with friction=1,5,2", "decimals come after a point"),
        ("--with friction --with friction=1", "the effect friction stands twice after --with"),
        ("--without gravity --without gravity", "the effect gravity stands twice after --without"),
        (
            "--without friction --with friction",
            "the effect friction stands after --with and after --without: is it in or out?",
        ),
        ("--without friction=1", "there is no effect 'friction=1'"),
        ("--with", "a value is required"),
        ("--friction 0.02", "friction is an effect: --with friction=VALUE or --without friction"),
        ("--fricton 0.02", "unexpected argument"),
    ];
    for (arguments, told) in cases {
        let outcome = swing(arguments);
        assert_eq!((outcome.code, outcome.stdout.as_str()), (2, ""), "{arguments}");
        assert!(outcome.stderr.contains(told), "{arguments}: {}", outcome.stderr);
    }
    assert_eq!(cases.len(), 17);
    // An example without effects says so, and does not offer the flags.
    let none = answer("--with friction");
    assert_eq!(none.code, 2);
    assert!(
        none.stderr.contains("this example has none to put in or leave out"),
        "{}",
        none.stderr
    );
    assert!(!answer("--help").stdout.contains("--with"));
}

#[test]
fn help_lists_the_effects_with_unit_range_and_strength() {
    let help = swing("--help").stdout;
    for part in [
        "Effects:",
        "--with <NAME[=VALUE]>",
        "friction: friction of the hinge [0.02 N m s; greater than 0]",
        "air-drag: density of the air [1.2 kg/m^3; from 0 to 2]",
        "--without <NAME>",
        "in without this: gravity",
    ] {
        assert!(help.contains(part), "{part} in {help}");
    }
    assert!(!help.contains("--friction"), "{help}");
}

/// A rod that says how many bytes a recording has, unless it is empty.
const READS: Example<Parameters> = Example {
    recordings: Some(Recordings {
        throws: true,
        made: || "1,2,3".into(),
        recorded: |p, name, bytes, asked| {
            let mut report = Report::new("A recording", format!("the file {name}"))?;
            let empty = Error::Text { text: name.into(), allowed: "an empty file has no rates" };
            let count = (!bytes.is_empty()).then_some(bytes.len() as f64).ok_or(empty)?;
            let piece = [asked.from, asked.to, asked.throw.map(|n| n as f64)];
            let found = vec![
                Found::number("bytes", "how many", "-", count, 6),
                Found::estimate(
                    "length",
                    "of the rod",
                    "m",
                    [p.length, p.length - 0.02, p.length + 0.02],
                ),
                Found::word("piece", "what is asked for", format!("{piece:?} {:?}", asked.given)),
                Found::open("mass", "of the rod", "nothing tells it"),
            ];
            report.add(Found::table(&found)?)?;
            let decided = vec![Decided {
                name: "offset",
                needed: true,
                improvement: 20.0,
                threshold: 10.83,
                values: vec![[0.0123, 0.0102, 0.0144]],
                unit: "m",
            }];
            report.add(Decided::table(&decided)?)?;
            let trajectory = trajectory(p)?;
            let still = MovingPicture::new(0.0..=1.0, [1.0], |_| {
                Ok(figures(&Parameters::default())?.remove(0))
            })?;
            let (pictures, captions) = (vec![("recorded", still)], vec![("line", "A line.")]);
            let figures = figures(p)?;
            Ok(Recorded { report, found, decided, figures, trajectory, pictures, captions })
        },
    }),
    ..EXAMPLE
};

#[test]
fn a_recording_is_read_and_told() {
    let scratch = Scratch::new("recording");
    let path = |name: &str| scratch.0.join(name).display().to_string();
    let told = |words: &str| READS.answer(words.split_whitespace());
    let (file, none) = (path("throw.csv"), path("none.csv"));
    assert_eq!(told(&format!("--made-up {file}")).code, 0);
    assert_eq!(fs::read_to_string(&file).expect("it is written"), "1,2,3");
    let read = told(&format!("--recording {file} --from 1 --to 1.5 --length 2"));
    let parsed = parse(&read.stdout).expect("the text follows its grammar");
    let rows = parsed.table("table found").expect("it is told").rows();
    assert_eq!(rows[0][..3], ["bytes", "5", "-"]);
    assert_eq!(rows[1][..4], ["length", "2.000", "1.980", "2.020"]);
    assert_eq!(rows[2][1], "[Some(1.0), Some(1.5), None] [\"length\"]");
    assert_eq!([&rows[3][1], &rows[3][5]], ["not determined", "of the rod: nothing tells it"]);
    let rows = parsed.table("table corrections").expect("it is told").rows();
    assert_eq!(rows[0], ["offset", "called for", "20.0", "10.8", "0.0123 ± 0.0021, m"]);
    // As JSON, with files.
    let (svg, csv) = (path("svg"), path("rates.csv"));
    let json = told(&format!("--recording {file} --throw 2 --json --csv {csv} --svg {svg}"));
    let value: serde_json::Value = serde_json::from_str(&json.stdout).expect("JSON");
    assert_eq!(
        (value["found"][1]["from"].as_f64(), value["found"][3]["value"].is_null()),
        (Some(2.98), true)
    );
    let offset = &value["corrections"][0];
    assert_eq!(
        (offset["needed"].as_bool(), offset["values"][0]["to"].as_f64()),
        (Some(true), Some(0.0144))
    );
    assert_eq!(value["tables"][0]["rows"][2][1], "[None, None, Some(2.0)] []");
    assert_eq!(fs::read_dir(&svg).expect("figures").count(), 2);
    assert!(fs::read_to_string(&csv).expect("a file").starts_with("t [s],"));
    // What is refused, each with its reason; the last is a page that reads nothing.
    fs::write(path("empty.csv"), "").expect("a file");
    let refusals = [
        (READS.answer(["--recording", &none]), "none.csv cannot be read"),
        (READS.answer(["--recording", &path("empty.csv")]), "an empty file has no rates"),
        (
            READS.answer(["--recording", &file, "--throw", "1", "--from", "2"]),
            "cannot be used with",
        ),
        (READS.answer(["--from", "2"]), "--recording"),
        (READS.answer(["--recording", &file, "--check", "inertia=2"]), "cannot be used with"),
        (READS.answer(["--recording", &file, "--length", "-2"]), "length = -2 is not allowed"),
        (EXAMPLE.answer(["--recording", &file]), "this example reads no recordings"),
    ];
    for (outcome, said) in refusals {
        assert_eq!((outcome.code, outcome.stdout.as_str()), (2, ""), "{said}");
        assert!(outcome.stderr.contains(said), "{said}: {}", outcome.stderr);
    }
}
