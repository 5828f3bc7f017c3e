//! The top and the wheel: any motion asked for is either confirmed by a second route or
//! refused in words; and what the page's tries say.

use pages::ch16_2_top_and_wheel as top_and_wheel;
use rotation_dynamics::report::cli::Outcome;
use rotation_dynamics::report::parse;

fn told(flags: &str) -> Outcome {
    top_and_wheel::EXAMPLE.answer(flags.split_whitespace())
}

/// A claim is printed only if its oracle agrees; so what is printed is confirmed.
#[test]
fn bodies_in_si_units_are_confirmed() {
    let all = [
        "--spin 628.3",
        "--precession 1.8",
        "--spin -300 --theta 2",
        "--length -0.1 --theta 0.3 --spin 50",
        "--theta 0 --nutation 0.01",
        "--gravity 1.62",
        "--theta 1e-4",
        "--body wheel --length 0.3",
        "--body wheel --precession 0.6754",
        "--spin 139 --theta 1e-6",
    ];
    for flags in all {
        let told = told(flags);
        assert_eq!((told.code, told.stderr.as_str()), (0, ""), "{flags}");
    }
    assert_eq!(all.len(), 10);
}

#[test]
fn what_cannot_be_is_refused_in_words() {
    let all = [
        ("--mass 0", "mass = 0"),
        ("--i3 -1", "I3 = -1"),
        ("--body chair", "invalid value"),
        ("--spin 0", "L_z = 0"),
    ];
    for (flags, words) in all {
        let told = told(flags);
        assert_eq!((told.code, told.stdout.as_str()), (2, ""), "{flags}");
        assert!(told.stderr.contains(words), "{flags}: {}", told.stderr);
    }
    assert_eq!(all.len(), 4);
}

/// The number that this run prints under `key`.
fn number(flags: &str, key: &str) -> f64 {
    let text = told(flags).stdout;
    let report = parse(&text).expect("the text follows its grammar");
    let claims = report.table("claims").expect("there are claims");
    let row = claims.rows().iter().find(|row| row[0] == key);
    let row = row.unwrap_or_else(|| panic!("{flags} has no {key}"));
    row[1].parse().expect("a number")
}

/// The commands of the page's tries print what their folded answers say.
#[test]
fn tries_give_what_the_page_says() {
    let below = number("--spin 139 --theta 1e-6", "top_theta_max");
    let above = number("--spin 141 --theta 1e-6", "top_theta_max");
    let depth = |flags: &str, body: &str| {
        number(flags, &format!("{body}_theta_max")) - number(flags, &format!("{body}_theta_min"))
    };
    let pushed = "--body wheel --precession 0.6754";
    let long = "--body wheel --length 0.3";
    let all = [
        (below, "try_below", 1e-9),
        (depth(pushed, "wheel"), "try_push", 1.5e-7),
        (depth(long, "wheel"), "try_lever_dip", 1e-11),
        (
            number(long, "wheel_precession_rate"),
            "try_lever_rate",
            1e-10,
        ),
        (depth("--spin 300", "top"), "try_fast_dip", 1e-11),
    ];
    for (found, key, within) in all {
        let said = number("", key);
        assert!((found - said).abs() <= within, "{key}: {found}, {said}");
    }
    assert_eq!(all.len(), 5);
    assert!((1e-6..1e-5).contains(&above), "{above}");
}

/// The errors that the card predicts for what brakes the spin, against runs with the
/// torque. Measured: run over prediction from 0.886 to 1.011; required within a factor 2.
#[test]
fn the_card_predicts_what_a_run_gives() {
    let text = told("").stdout;
    let report = parse(&text).expect("the text follows its grammar");
    let card = report.table("effects").expect("there is a card");
    let all = [
        ("top: air", "top_air_lead"),
        ("top: the tip drills", "top_drill_lead"),
        ("wheel: air", "wheel_air_lead"),
        ("wheel: bearings", "wheel_bearing_lead"),
    ];
    for (name, key) in all {
        let row = card.rows().iter().find(|row| row[0] == name);
        let row = row.unwrap_or_else(|| panic!("no {name}"));
        let predicted = row[3].split(' ').next().expect("a number");
        let ratio = number("", key) / predicted.parse::<f64>().expect("a number");
        assert!((0.5..2.0).contains(&ratio), "{name}: {ratio}");
    }
    assert_eq!(all.len(), 4);
}
