//! The gyroscope's report far from the notes' parameters: sound numbers, or a reason.
//!
//! Each line once made a bound that did not follow the conditioning refuse a right
//! number, or a route lose more digits than it said.

use pages::ch16_2_gyroscope as gyroscope;

const SOUND: &[&str] = &[
    // Close passages by the poles.
    "--a=1 --b=0.9646696516635528 --c=0.09456625415753794 --energy=0.5070211393342967 --start=theta_max",
    "--a=1e-6 --b=0.999999999995916 --c=2.479545711689449 --energy=-2.4763961121417832",
    "--a=0.0012 --b=1.2 --c=0.2 --energy=0.5535151071433231",
    "--a=1e-20",
    // No weight: thousands of equal terms to sum.
    "--a=1.9302412042847925 --b=0.8963056118753858 --c=0 --energy=0.35021288327062244",
    // A start next to the pole, given by an energy.
    "--a=1e-6 --b=-0.2156873134986519 --c=0.2 --energy=60.52874008892845 --start=theta_max",
    "--a=2 --b=0.9999733224702964 --c=0.2 --energy=16.99168787696426",
    // Fast: long steps overflow in the accuracy strip.
    "--a=2 --b=39.95210577961625 --c=-0.20061855862624917 --energy=92885.61526620826",
    // Spin the other way round: t' runs backwards.
    "--i1=0.008 --i3=0.0003 --mass=0.08 --length=0 --theta=0.3 --spin=-6.5 --precession=28",
    // b = 1 or -1 but for what rounding took.
    "--i1=0.0035 --i3=0.0011 --mass=0.2 --length=0 --theta=3.141592652589793 --spin=4282.5 --precession=0.8",
    "--i1=0.2 --i3=0.3 --mass=1 --length=0 --theta=1e-9 --spin=-847 --precession=-0.05",
    "--i1=0.038 --i3=0.038 --mass=0.3 --length=0 --theta=1e-4 --spin=-15.4",
    // A hair off the vertical, far below the critical spin: no run in steps can follow.
    "--i1=1.54e-5 --i3=1.28e-5 --mass=14.8 --length=0.074 --theta=1e-9 --spin=-624 --precession=7",
];

const REFUSED: &[(&str, &str)] = &[
    ("--a=1e-300", "too far apart"),
    ("--b=1e308", "too far apart"),
    ("--energy=1e308", "too far apart"),
    ("--a=1e308", "a = 1e308 is not allowed"),
    (
        "--tolerance=1e-300",
        "1e-300 rad is asked for, and doubles allow",
    ),
    ("--spin=0", "the axis must spin"),
    (
        "--energy=0.40",
        "no motion: E~ = 0.40 is below U_min = 0.404262",
    ),
    ("--a=0,5", "decimals come after a point"),
    ("--check==1", "write KEY=VALUE"),
    ("--a=1 --i1=2", "dimensionless and SI flags together"),
];

#[test]
fn sound_far_from_the_notes() {
    for line in SOUND {
        let outcome = gyroscope::EXAMPLE.answer(line.split(' '));
        assert_eq!(outcome.code, 0, "{line}: {}", outcome.stderr);
        for word in outcome.stdout.split_whitespace() {
            assert!(!["NaN", "inf", "-inf"].contains(&word), "{line}: {word}");
        }
    }
    assert_eq!(SOUND.len(), 13);
}

#[test]
fn refused_with_a_reason_one_can_act_on() {
    for (line, reason) in REFUSED {
        let outcome = gyroscope::EXAMPLE.answer(line.split(' '));
        assert_eq!((outcome.code, outcome.stdout.as_str()), (2, ""), "{line}");
        assert!(
            outcome.stderr.contains(reason),
            "{line}: {}",
            outcome.stderr
        );
        assert!(outcome.stderr.len() < 400, "{line}: {}", outcome.stderr);
    }
    assert_eq!(REFUSED.len(), 10);
}
