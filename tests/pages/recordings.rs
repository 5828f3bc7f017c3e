//! The pages that read a reader's own recording: what they say of the one that they make up, and what
//! they refuse. That fits find what is true is seen in `tests/fit`, that files are read in `tests/recording`.

use kit::cli::Outcome;
use kit::recording::made::{Format, Made, Motion};
use kit::{Page, Recorded, parse};
use pages::{ALL, WHOLE, page};
use serde_json::Value;

type Told = Result<Recorded, Outcome>;

fn read(page: &dyn Page, flags: &str, bytes: &[u8]) -> Told {
    let words = flags.split_whitespace().map(str::to_owned);
    page.recorded_for(["--recording=made.csv".to_owned()].into_iter().chain(words).collect(), bytes)
}

/// The value and the interval of a quantity, if it is told.
fn found(told: &Recorded, key: &str) -> Option<[f64; 3]> {
    let json: Value = serde_json::from_str(&told.json("page").expect("it is told")).expect("JSON");
    let entry = json["found"].as_array()?.iter().find(|entry| entry["key"] == key)?;
    Some([entry["value"].as_f64()?, entry["from"].as_f64()?, entry["to"].as_f64()?])
}

fn holds([value, from, to]: [f64; 3], truth: f64) -> bool {
    from < value && value < to && (from..=to).contains(&truth) && to - from < 0.02 * value
}

/// Each page that reads recordings reads its own, draws it, and refuses what is none.
#[test]
fn made_up_recordings_are_read() {
    let mut seen = 0;
    for page in ALL {
        let Some(made) = page.made() else { continue };
        let told = read(*page, "", made.as_bytes()).unwrap_or_else(|told| panic!("{}: {}", page.stem(), told.stderr));
        let text = told.report.output().expect("it is told");
        assert!(parse(&text).expect("its grammar").table("table corrections").is_some(), "{text}");
        for figure in told.all_figures().expect("drawings") {
            assert_eq!(figure.display.crowded(), Vec::<String>::new(), "{} {}", page.stem(), figure.name);
            assert!(figure.name == "recorded_rates" || figure.name.starts_with("recorded_"), "{}", figure.name);
        }
        assert!(told.trajectory.rows().len() > 100 && !told.pictures.is_empty());
        for bytes in [&b""[..], b"\x89PNG\r\n\x1a\n\x00\x00", b"a,b\n1,2\n"] {
            let refused = read(*page, "", bytes).map(|_| ()).expect_err("it is no recording");
            assert!(refused.code == 2 && refused.stderr.starts_with("error: "), "{}", refused.stderr);
        }
        seen += 1;
    }
    assert!(!WHOLE || seen == 2, "{seen} pages");
}

#[test]
fn a_thrown_phone_is_told() {
    let Some(page) = page("further_1_phone") else { return };
    let made = page.made().expect("it makes one");
    let read = |flags: &str| read(page, flags, made.as_bytes());
    for flags in ["", "--throw 1", "--from 1.25 --to 1.85"] {
        let told = read(flags).unwrap_or_else(|told| panic!("{flags}: {}", told.stderr));
        let ratio = found(&told, "I_x/I_z").expect("it is determined");
        assert!(holds(ratio, 4.1 / 4.9), "{flags}: {ratio:?}");
        // The damaged twin: the ratio upside down.
        assert!(!holds(ratio, 4.9 / 4.1));
        assert!(found(&told, "box I_x/I_z").is_none());
    }
    // With the phone's size it is compared with a box.
    let told = read("--length 0.15").unwrap_or_else(|told| panic!("{}", told.stderr));
    let text = told.report.output().expect("it is told");
    let parsed = parse(&text).expect("its grammar");
    let rows = parsed.table("table found").expect("it is there").rows();
    let boxed = rows.iter().find(|row| row[0] == "box I_x/I_z").expect("it is compared");
    assert!((boxed[1].parse::<f64>().expect("a number") - (0.15 * 0.15 + 0.0078 * 0.0078) / (0.15 * 0.15 + 0.071 * 0.071)).abs() < 1e-4);
    let refusals = [
        ("--throw 3", "there is no throw 3; there are: throws 1 to 2"),
        ("--throw 0", "there is no throw 0"),
        ("--from 2 --to 1", "error: "),
        ("--length 0", "length = 0 is not allowed"),
    ];
    for (flags, said) in refusals {
        let refused = read(flags).map(|_| ()).expect_err(flags);
        assert!(refused.code == 2 && refused.stderr.contains(said), "{flags}: {}", refused.stderr);
    }
}

#[test]
fn a_swing_is_told() {
    let Some(page) = page("ch16_ex7_rod_and_disc") else { return };
    let made = page.made().expect("it makes one");
    let told = read(page, "", made.as_bytes()).unwrap_or_else(|told| panic!("{}", told.stderr));
    let of = |key| found(&told, key).expect("it is told");
    assert!(holds(of("length"), 0.94) && (of("amplitude")[0] - 0.8).abs() < 2e-3);
    // On the Moon the same swing is that of a shorter pendulum.
    let moon = read(page, "--gravity 1.62", made.as_bytes()).unwrap_or_else(|told| panic!("{}", told.stderr));
    assert!(holds(found(&moon, "length").expect("it is told"), 0.94 * 1.62 / 9.806_65));
}

/// A steady spin tells no ratio: no number is printed, no ellipsoid drawn.
#[test]
fn what_a_flight_does_not_determine_is_not_told() {
    let Some(page) = page("further_1_phone") else { return };
    let motion = Motion::Throws { moments: [4.1, 1.0, 4.9], releases: vec![[0.0, 0.0, 12.0]], flight: 0.8, drag: 0.0 };
    let made = Made { motion, ..Made::default() }.text(Format::Phyphox).expect("it is made");
    let told = read(page, "", made.as_bytes()).unwrap_or_else(|told| panic!("{}", told.stderr));
    let text = told.report.output().expect("it is told");
    assert_eq!(text.matches("not determined").count(), 4 + 1, "{text}");
    assert!(["I_x/I_z", "I_y/I_z", "I_x/I_y"].iter().all(|key| found(&told, key).is_none()));
    assert!(told.pictures.iter().all(|(name, _)| *name == "recorded_throw"));
}
