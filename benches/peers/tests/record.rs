//! Every line of `benches/record/peers.txt` and `peers_open.txt` claims an error: each is run again here, and
//! must reach it. Nothing is timed.

use benches::{OPEN_RECORD, RECORD, path};
use kit::{Parsed, parse};
use peers::contest::Setting;
use peers::open::OPEN;
use peers::problem::PROBLEMS;
use peers::record::{Claim, DENSE, again, claims};
use std::fs;

fn read(file: &str) -> Parsed {
    let text = fs::read_to_string(path(file)).expect("there is a record");
    parse(&text).expect("a record is a report")
}

/// The lines of both records.
fn lines() -> Vec<Claim> {
    let both = [RECORD, OPEN_RECORD].map(|file| claims(&read(file)).expect("lines can be read"));
    both.concat()
}

/// Runs all claims on `key` again; gives how many there were.
fn checked(key: &str) -> usize {
    let delivered = again(key, &lines()).expect("every line can be run again");
    for (error, claim) in &delivered {
        assert!(error <= &claim.error, "{error:e} is delivered by {claim:?}");
    }
    delivered.len()
}

macro_rules! reached {
    ($($name:ident),*) => {
        $(#[test]
        fn $name() {
            // The closed form at each error or ours, and at least one of the others at one.
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
    heavy_body,
    damped_top,
    satellite,
    driven_body,
    dense_free_body,
    dense_heavy_top
);

#[test]
fn every_line_is_checked() {
    let ends = PROBLEMS.iter().chain(&OPEN).map(|problem| problem.key.to_owned());
    let all: Vec<String> = ends.chain(DENSE.map(|key| format!("dense_{key}"))).collect();
    assert_eq!(all, CHECKED);
    for claim in lines() {
        assert!(CHECKED.contains(&claim.key.as_str()), "{claim:?}");
    }
}

/// The damaged twin: with a tolerance a thousand times as large, no claim is reached.
#[test]
fn a_damaged_setting_is_found() {
    for key in ["flips", "satellite"] {
        let mut damaged: Vec<Claim> = Vec::new();
        for claim in lines().iter().filter(|claim| claim.key == key) {
            if let Setting::Tolerance(tolerance) = claim.setting {
                let setting = Setting::Tolerance(1e3 * tolerance);
                damaged.push(Claim { setting, ..claim.clone() });
            }
        }
        let delivered = again(key, &damaged).expect("they run");
        assert_eq!(delivered.len(), damaged.len());
        assert!(damaged.len() > 8);
        for (error, claim) in delivered {
            assert!(error > claim.error, "{error:e} is delivered by {claim:?}");
        }
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
