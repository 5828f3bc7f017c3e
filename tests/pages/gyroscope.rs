//! The command lines of the gyroscope and of the top and wheel: any motion asked
//! for is either confirmed by a second route or refused in words.

use pages::{ch16_2_gyroscope as gyroscope, ch16_2_top_and_wheel as top_and_wheel};
use rotation_dynamics::report::cli::Outcome;

fn gyroscope(flags: &str) -> Outcome {
    gyroscope::EXAMPLE.answer(flags.split_whitespace())
}

fn top_and_wheel(flags: &str) -> Outcome {
    top_and_wheel::EXAMPLE.answer(flags.split_whitespace())
}

/// A claim is printed only if its oracle agrees; so what is printed is confirmed.
#[test]
fn every_motion_asked_for_is_confirmed() {
    let mut ran = 0;
    for a in [0.1, 2.0] {
        for b in [-1.0, -0.4, 0.7, 1.0, 1.5] {
            for c in [-0.3, 0.0, 0.01, 0.4] {
                for above in [1e-6, 0.05, 2.0] {
                    let top = rotation_dynamics::exact::heavy_top::ReducedTop::new(a, b, c)
                        .expect("a top");
                    let energy = top.minimum().1 + above;
                    let flags = format!("--a {a} --b {b} --c {c} --energy {energy}");
                    let told = gyroscope(&flags);
                    assert_eq!((told.code, told.stderr.as_str()), (0, ""), "{flags}");
                    assert!(told.stdout.contains("\nclaims\n"), "{flags}");
                    ran += 1;
                }
            }
        }
    }
    assert_eq!(ran, 2 * 5 * 4 * 3);
}

#[test]
fn bodies_in_si_units_are_confirmed() {
    let flags = [
        "--spin 628.3",
        "--precession 1.8",
        "--spin -300 --theta 2",
        "--length -0.1 --theta 0.3 --spin 50",
        "--theta 0 --nutation 0.01",
        "--gravity 1.62",
        "--theta 1e-4",
    ];
    for flags in flags {
        let told = gyroscope(flags);
        assert_eq!((told.code, told.stderr.as_str()), (0, ""), "{flags}");
        let told = top_and_wheel(flags);
        assert_eq!((told.code, told.stderr.as_str()), (0, ""), "{flags}");
    }
    let others = [
        "--body wheel --length 0.3",
        "--body wheel --precession 0.6754",
        "--spin 139 --theta 1e-6",
    ];
    for flags in others {
        let told = top_and_wheel(flags);
        assert_eq!((told.code, told.stderr.as_str()), (0, ""), "{flags}");
    }
}

#[test]
fn what_cannot_be_is_refused_in_words() {
    for (flags, words) in [
        (
            "--energy 0.40",
            "no motion: E~ = 0.40 is below U_min = 0.404262",
        ),
        ("--a 2.5", "no body has I3 > 2 I1"),
        ("--a 0", "a = 0"),
        ("--a 1 --mass 2", "dimensionless and SI flags together"),
        ("--i3 1", "I3 <= 2 I1"),
        ("--i1 -1", "I1 = -1"),
        ("--mass -0.5", "mass = -0.5"),
        ("--spin 0", "L_z = 0"),
        ("--tolerance 0", "tolerance = 0"),
        ("--tolerance 4", "above 0 and at most pi"),
        ("--tolerance 1e-20", "doubles allow 4.3e-14 at best"),
        ("--energy nan", "not a finite number"),
        ("--i1 inf", "not a finite number"),
        ("--start top", "invalid value"),
        ("--momentum 3", "unexpected argument"),
    ] {
        let told = gyroscope(flags);
        assert_eq!((told.code, told.stdout.as_str()), (2, ""), "{flags}");
        assert!(told.stderr.contains(words), "{flags}: {}", told.stderr);
    }
    for (flags, words) in [
        ("--mass 0", "mass = 0"),
        ("--i3 -1", "I3 = -1"),
        ("--body chair", "invalid value"),
        ("--spin 0", "L_z = 0"),
    ] {
        let told = top_and_wheel(flags);
        assert_eq!((told.code, told.stdout.as_str()), (2, ""), "{flags}");
        assert!(told.stderr.contains(words), "{flags}: {}", told.stderr);
    }
}
