//! The top and the wheel: any motion asked for is either confirmed by a second route or
//! refused in words.

use pages::ch16_2_top_and_wheel as top_and_wheel;
use rotation_dynamics::report::cli::Outcome;

fn told(flags: &str) -> Outcome {
    top_and_wheel::EXAMPLE.answer(flags.split_whitespace())
}

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
