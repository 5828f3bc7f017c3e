//! Every line of `benches/record/peers.txt` claims an error: each is run again here, and
//! must reach it. Nothing is timed.

use benches::readme::{RECORD, path};
use peers::contest::Setting;
use peers::problem::PROBLEMS;
use peers::record::{Claim, DENSE, again, claims};
use rotation_dynamics::report::{Parsed, parse};
use std::fs;

fn record() -> Parsed {
    let text = fs::read_to_string(path(RECORD)).expect("there is a record");
    parse(&text).expect("a record is a report")
}

/// Runs all claims on `key` again; gives how many there were.
fn checked(key: &str) -> usize {
    let claims = claims(&record()).expect("the runs can be read");
    let delivered = again(key, &claims).expect("every line can be run again");
    for (error, claim) in &delivered {
        assert!(error <= &claim.error, "{error:e} is delivered by {claim:?}");
    }
    delivered.len()
}

macro_rules! reached {
    ($($name:ident),*) => {
        $(#[test]
        fn $name() {
            // The closed form at each error, and at least one of the others at one.
            assert!(checked(stringify!($name)) > 4);
        })*

        const CHECKED: &[&str] = &[$(stringify!($name)),*];
    };
}

reached!(
    free_body,
    heavy_top,
    heavy_top_angles,
    fast_top,
    pole,
    pole_angles,
    flips,
    dense_free_body,
    dense_heavy_top
);

#[test]
fn every_line_is_checked() {
    let ends = PROBLEMS.iter().map(|problem| problem.key.to_owned());
    let all: Vec<String> = ends
        .chain(DENSE.map(|key| format!("dense_{key}")))
        .collect();
    assert_eq!(all, CHECKED);
    for claim in claims(&record()).expect("the runs can be read") {
        assert!(CHECKED.contains(&claim.key.as_str()), "{claim:?}");
    }
}

/// The damaged twin: with a tolerance a thousand times as large, no claim is reached.
#[test]
fn a_damaged_setting_is_found() {
    let all = claims(&record()).expect("the runs can be read");
    let mut damaged: Vec<Claim> = Vec::new();
    for claim in all.iter().filter(|claim| claim.key == "flips") {
        if let Setting::Tolerance(tolerance) = claim.setting {
            let setting = Setting::Tolerance(1e3 * tolerance);
            damaged.push(Claim {
                setting,
                ..claim.clone()
            });
        }
    }
    let delivered = again("flips", &damaged).expect("they run");
    assert_eq!(delivered.len(), damaged.len());
    assert!(damaged.len() > 8);
    for (error, claim) in delivered {
        assert!(error > claim.error, "{error:e} is delivered by {claim:?}");
    }
}

#[test]
fn settings_are_read_as_they_are_written() {
    for setting in [
        Setting::Exact,
        Setting::Tolerance(1.25e-13),
        Setting::Steps(17),
        Setting::Stages(17, 1e-9),
    ] {
        assert_eq!(setting.to_string().parse(), Ok(setting));
    }
    for damaged in ["", "17", "17 step", "tolerance", "tolerance x", "- -"] {
        assert!(damaged.parse::<Setting>().is_err(), "{damaged}");
    }
}
