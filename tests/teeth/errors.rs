//! The judges themselves: each damaged collection of errors must fail its assertion.

use insta::{Comparator, Settings, Snapshot};
use rotation_dynamics::math;
use std::panic::{AssertUnwindSafe, catch_unwind};
use support::{
    EPS, Errors, assert_error, assert_largest, assert_table, attained, beside_twins, relative,
    three_digits,
};

/// What the assertion says when it fails; none if it passes.
fn complaint(judge: impl FnOnce()) -> Option<String> {
    let payload = catch_unwind(AssertUnwindSafe(judge)).err()?;
    let text = payload.downcast_ref::<String>().cloned();
    Some(text.unwrap_or_else(|| "an assertion without a number".to_owned()))
}

fn of(errors: &[f64]) -> Errors {
    let mut collected = Errors::of("the twin");
    for error in errors {
        collected.push(*error);
    }
    collected
}

#[test]
fn one_unit_of_round_off() {
    assert_eq!(EPS.to_bits(), math::EPS.to_bits());
}

#[test]
fn what_is_measured_passes() {
    of(&[1e-3, 2.34, 0.0]).attain(2.3..=2.4, 3);
    of(&[-2.34]).attain(2.3..=2.4, 1);
    of(&[0.0]).attain(0.0..=0.0, 1);
    of(&[7.0, 5.0, f64::INFINITY]).exceed(4.9, 3);
    assert_largest!(of(&[1e-3, -2.344, 0.0]), 3, @"2.34");
    let mut errors = Errors::in_units_of(EPS, "the twin");
    errors.add(1.0 + 4.0 * EPS, 1.0, 2.0);
    errors.add(0.0, 0.0, 0.0);
    errors.attain(2.0..=2.0, 2);
    assert_largest!(errors, 2, @"2");
    assert_eq!(of(&[3.0, 4.0]).largest(), 4.0);
    assert_eq!(of(&[3.0, 4.0]).smallest(), 3.0);
}

#[test]
fn a_damaged_collection_fails() {
    let nan = f64::NAN;
    type Judge = Box<dyn FnOnce()>;
    let twins: Vec<(&str, Judge)> = vec![
        // A NaN, wherever it stands, also as the only case.
        ("NaN", Box::new(move || of(&[nan, 2.34]).attain(2.3..=2.4, 2))),
        ("NaN", Box::new(move || of(&[2.34, nan]).attain(2.3..=2.4, 2))),
        ("NaN", Box::new(move || of(&[nan]).attain(0.0..=0.0, 1))),
        ("NaN", Box::new(move || assert_largest!(of(&[2.34, nan]), 2, @"NaN"))),
        ("NaN", Box::new(move || of(&[9.0, nan]).exceed(5.0, 2))),
        ("NaN", Box::new(move || of(&[nan, 9.0]).exceed(5.0, 2))),
        // A loop that does not run, or not as often.
        ("0 cases ran", Box::new(|| of(&[]).attain(0.0..=0.0, 0))),
        ("0 cases ran", Box::new(|| of(&[]).attain(0.0..=0.0, 3))),
        ("0 cases ran", Box::new(|| assert_largest!(of(&[]), 0, @"0"))),
        ("0 cases ran", Box::new(|| assert_table!(&[of(&[])], @""))),
        ("NaN", Box::new(move || assert_table!(&[of(&[nan])], @""))),
        ("0 cases ran", Box::new(|| of(&[]).exceed(5.0, 0))),
        ("1 cases ran", Box::new(|| of(&[2.34]).attain(2.3..=2.4, 2))),
        ("3 cases ran", Box::new(|| of(&[2.34; 3]).attain(2.3..=2.4, 2))),
        ("2 cases ran", Box::new(|| assert_largest!(of(&[2.34, 1.0]), 1, @"2.34"))),
        // Too large an error, and too small a one.
        ("2.410e0", Box::new(|| of(&[2.41, 1.0]).attain(2.3..=2.4, 2))),
        ("2.290e0", Box::new(|| of(&[2.29, 1.0]).attain(2.3..=2.4, 2))),
        ("4.941e-324", Box::new(|| of(&[5e-324]).attain(0.0..=0.0, 1))),
        ("inf", Box::new(|| of(&[f64::INFINITY]).attain(2.3..=2.4, 1))),
        ("inf", Box::new(|| assert_largest!(of(&[f64::INFINITY]), 1, @"inf"))),
        // A range that any small error would do for, and no range at all.
        ("a guess", Box::new(|| of(&[2.34]).attain(0.0..=2.4, 1))),
        ("a guess", Box::new(|| of(&[2.34]).attain(1.5..=2.4, 1))),
        ("a guess", Box::new(|| of(&[2.34]).attain(2.4..=2.3, 1))),
        ("a guess", Box::new(move || of(&[2.34]).attain(nan..=2.4, 1))),
        ("a guess", Box::new(move || of(&[2.34]).attain(2.3..=nan, 1))),
        // A twin that is not noticed.
        ("not above", Box::new(|| of(&[9.0, 4.9]).exceed(5.0, 2))),
        ("not above", Box::new(|| of(&[5.0]).exceed(5.0, 1))),
        ("not above", Box::new(|| drop(beside_twins([[0.0, 9.0], [0.0, 4.9]], 5.0, 2)))),
        // Errors that nobody looks at, and units that are none.
        ("never judged", Box::new(|| drop(of(&[2.34])))),
        ("never judged", Box::new(|| drop(beside_twins([[0.0, 9.0]], 5.0, 1)))),
        ("no unit", Box::new(|| drop(Errors::in_units_of(0.0, "the twin")))),
        ("no unit", Box::new(move || drop(Errors::in_units_of(nan, "the twin")))),
    ];
    let mut failed = 0;
    for (i, (words, judge)) in twins.into_iter().enumerate() {
        let told = complaint(judge).unwrap_or_else(|| panic!("twin {i} passes: {words}"));
        assert!(told.contains(words), "twin {i}: {told}");
        failed += 1;
    }
    assert_eq!(failed, 32);
}

#[test]
fn three_digits_and_fewer_where_it_is_exact() {
    let mut ran = 0;
    for (number, text) in [
        (0.0, "0"),
        (2.0, "2"),
        (2.0 + 4.0 * EPS, "2.00"),
        (0.25, "0.25"),
        (0.009_996, "0.0100"),
        (9.994, "9.99"),
        (9.996, "10.0"),
        (77.0, "77"),
        (999.6, "1.00e3"),
        (4e14, "4e14"),
        (2.366e-14, "2.37e-14"),
        (5e-324, "5e-324"),
    ] {
        assert_eq!(three_digits(number), text);
        ran += 1;
    }
    assert_eq!(ran, 12);
}

/// In place of insta's comparison: it stops before anything is written beside this file.
#[derive(Clone)]
struct Stops;

impl Comparator for Stops {
    fn matches(&self, locked: &Snapshot, measured: &Snapshot) -> bool {
        let (locked, measured) = (locked.contents(), measured.contents());
        assert!(locked == measured, "{measured:?} is measured, {locked:?} locked");
        true
    }

    fn dyn_clone(&self) -> Box<dyn Comparator> {
        Box::new(self.clone())
    }
}

#[test]
fn a_wrong_last_digit_is_seen() {
    let mut settings = Settings::new();
    settings.set_comparator(Box::new(Stops));
    settings.bind(|| {
        assert_largest!(of(&[2.34]), 1, @"2.34");
        let two = || [of(&[2.344, 1.0]), of(&[7.0])];
        assert_table!(&two(), @"
        the twin: 2.34 of 2
        the twin: 7 of 1
        ");
        let twins: [fn(); 7] = [
            || assert_table!(&[of(&[2.34])], @"the twin: 2.35 of 1"),
            || assert_table!(&[of(&[2.34])], @"the twin: 2.34 of 2"),
            || assert_table!(&[of(&[2.34]), of(&[7.0])], @"the twin: 2.34 of 1"),
            || assert_largest!(of(&[2.34]), 1, @"2.35"),
            || assert_largest!(of(&[2.34]), 1, @"2.33"),
            || assert_largest!(of(&[2.0 + EPS * 4.0]), 1, @"2"),
            || assert_largest!(of(&[5e-324]), 1, @"0"),
        ];
        for twin in twins {
            let told = complaint(twin).expect("another digit fails");
            assert!(told.contains("locked"), "{told}");
        }
    });
}

#[test]
fn a_comparison_that_says_nothing_is_no_number() {
    let (nan, inf) = (f64::NAN, f64::INFINITY);
    assert_eq!(relative(2.0, 1.0, 4.0), 0.25);
    assert_eq!(relative(0.0, -0.0, 0.0), 0.0);
    assert_eq!(relative(1.0, 0.0, 0.0), inf);
    let mut ran = 0;
    for (got, want, scale) in [
        (nan, 1.0, 1.0),
        (1.0, nan, 1.0),
        (1.0, 1.0, nan),
        (1.0, 2.0, inf),
        (1.0, 2.0, -1.0),
        (inf, inf, 1.0),
    ] {
        assert!(relative(got, want, scale).is_nan());
        ran += 1;
    }
    assert_eq!(ran, 6);
}

#[test]
fn a_single_error_is_what_is_printed() {
    let third = 1.0 + 6.0 * EPS;
    assert_error!(third, 1.0, 6.0 eps);
    assert_error!(third - 1.0, 6.00 eps);
    assert_error!(-2.46e-17, 2.5e-17);
    assert_error!(2.0, 1.0, 1.0);
    assert_error!(0.0, 0.0);
    let mut failed = 0;
    for (error, printed) in [
        (f64::NAN, "3.0"),
        (f64::NAN, "0.0"),
        (f64::INFINITY, "3.0"),
        (3.06, "3.0"),
        (2.94, "3.0"),
        (0.0, "3.0"),
        (5e-324, "0.0"),
        (2.44e-17, "2.5e-17"),
        (2.4994e-17, "2.500e-17"),
    ] {
        let told = complaint(|| attained(error, printed, "the twin"));
        assert!(told.is_some_and(|t| t.contains("measured")), "{error} {printed}");
        failed += 1;
    }
    assert_eq!(failed, 9);
}
