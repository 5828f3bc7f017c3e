//! What the table must be: whole, within meaningful bounds, and above every naive method.

use crate::answers::root;
use crate::sources::rust_files;
use kit::Error;
use pages::hard_cases::report::name_of;
use pages::hard_cases::{Cell, Computed, Parameters, computed, figures, findings, rotations};
use rotation_dynamics::math::{DoubleDouble, hypot, ldexp, sincos};
use std::collections::BTreeMap;
use std::fs::read_to_string;
use std::sync::Arc;
use support::{Errors, assert_table};

fn all() -> Vec<Arc<Computed>> {
    computed(&Parameters::default()).expect("every cell holds or is refused by name")
}

/// Family by family: rows, cells, those that hold, those that are refused.
const COUNTS: [(&str, [usize; 4]); 14] = [
    ("poles", [8, 240, 235, 5]),
    ("threshold", [7, 210, 210, 0]),
    ("separatrix", [8, 200, 200, 0]),
    ("flips", [3, 30, 30, 0]),
    ("shapes", [9, 225, 205, 20]),
    ("tops", [6, 180, 180, 0]),
    ("turns", [11, 275, 255, 20]),
    ("scales", [8, 200, 200, 0]),
    ("long", [3, 30, 15, 15]),
    ("torques", [7, 70, 70, 0]),
    ("findings", [9, 45, 8, 37]),
    ("events", [13, 26, 23, 3]),
    ("impacts", [7, 14, 14, 0]),
    ("stability", [6, 6, 6, 0]),
];

#[test]
fn the_table_is_whole() {
    let all = all();
    let counted = all.iter().map(|one| (one.family.key, one.count()));
    assert_eq!(counted.collect::<Vec<_>>(), COUNTS);
    for one in all.iter() {
        // Each method in each representation once.
        let due = one.family.methods.len() * one.family.forms.len();
        for (case, answered) in &one.rows {
            assert_eq!(answered.cells.len(), due, "{}", case.0);
        }
    }
}

/// A family that no section of the page shows would be computed in silence.
#[test]
fn the_page_shows_every_family() {
    let page = concat!(
        include_str!("../../book/src/hard_cases.md"),
        include_str!("../../book/src/hard_cases_sizes.md"),
        include_str!("../../book/src/hard_cases_steps.md"),
    );
    let mut sections = 0;
    for one in all().iter() {
        let key = one.family.key;
        let [.., refusals] = one.count();
        let refused = refusals > 0;
        for (table, due) in [("_naive", true), ("", true), ("_refusals", refused)] {
            let there = page.contains(&format!("{{{{table hard_cases:{key}{table}}}}}"));
            assert_eq!(there, due, "{key}{table}");
        }
        assert!(page.contains(&format!("## {}\n", one.family.title)), "{key}");
        sections += 1;
    }
    assert_eq!(sections, COUNTS.len());
}

/// The naive method of each case is at least this far beyond the bound that others keep.
const BROKEN: f64 = 10.0;

#[test]
fn every_naive_method_is_broken() {
    let all = all();
    let mut broken = Errors::of("naive error over the row's smallest bound");
    let mut rows = 0;
    for (case, answered) in all.iter().flat_map(|one| &one.rows) {
        broken.push_at(answered.broken(), case.0);
        rows += 1;
    }
    broken.exceed(BROKEN, rows);
    assert_eq!(
        rows,
        COUNTS.iter().map(|(_, [rows, ..])| rows).sum::<usize>()
    );
}

/// A bound says something: no angle is called held that might be anything.
#[test]
fn every_bound_means_something() {
    let mut cells = 0;
    for Cell { method, answer, bound } in all().iter().flat_map(|one| one.cells()) {
        if answer.is_ok() {
            assert!(*bound <= 1e-2, "{method}: {bound:e}");
            cells += 1;
        }
    }
    assert!(cells > 1500, "{cells}");
}

/// What is refused, and how often.
#[test]
fn refusals_are_those_that_are_named() {
    let mut named = BTreeMap::<String, usize>::new();
    for cell in all().iter().flat_map(|one| one.cells()) {
        if let Err(error) = &cell.answer {
            *named.entry(name_of(error)).or_default() += 1;
        }
    }
    let due = [
        ("FunctionOutOfRange", 10),
        ("LimitReached", 10),
        ("NotDelivered", 57),
        ("NotFinite", 10),
        ("NotReached", 1),
        ("OutOfRange", 10),
        ("StepUnderflow", 2),
    ];
    assert!(
        named.iter().map(|(name, n)| (name.as_str(), *n)).eq(due),
        "{named:?}"
    );
}

/// The largest error over its bound, by method: what the K of each has to spare.
#[test]
fn the_bounds_are_attained_to_some_part() {
    let mut parts = BTreeMap::<&str, Errors>::new();
    for cell in all().iter().flat_map(|one| one.cells()) {
        if let Some(part) = cell.part() {
            let of_method = parts.entry(cell.method).or_insert_with(|| Errors::of(cell.method));
            of_method.push(part);
        }
    }
    assert_table!(parts.values(), @"
    DOP853: 0.324 of 275
    DOP853 with located events: 0.345 of 23
    Gauss-Legendre 16: 0.347 of 285
    Gauss-Legendre 16, piece by piece: 0.455 of 35
    RK4: 0.738 of 275
    SRKN 14a: 0.211 of 105
    closed form: 0.318 of 300
    contact solver: 0.0625 of 14
    foretold by the method's own polynomial or solution: 0.0331 of 6
    solve: 0.0174 of 58
    solve, stepping: 9.03e-3 of 275
    ");
}

/// The damaged twins: an error beyond its bound, or none at all, makes no cell.
#[test]
fn nothing_but_what_holds_is_a_cell() {
    let made = |measured: f64| Cell { method: "method", answer: Ok(measured), bound: 1e-12 };
    assert_eq!(made(1e-13).part(), Some(0.1));
    made(1e-13).judge("case").expect("it holds");
    for measured in [1.1e-12, f64::INFINITY, f64::NAN] {
        let refused = made(measured).judge("case").err();
        assert!(
            matches!(refused, Some(Error::Contradicted { .. })),
            "{refused:?}"
        );
    }
}

/// However short the step of RK4 is, a rounding grows and the book flips.
#[test]
fn no_step_keeps_the_book_on_its_axis() {
    let mut flips = 0;
    for step in [0.02, 0.05, 0.1, 0.2, 0.5] {
        let flip = figures::first_flip(step).expect("a path");
        assert!((60.0..100.0).contains(&flip), "{step}: {flip}");
        flips += 1;
    }
    assert_eq!(flips, 5);
}

/// What the table of findings says that a test sees, one does.
#[test]
fn findings_of_other_kinds_have_their_tests() {
    let mut files = Vec::new();
    for place in ["tests", "book/kit/src"] {
        rust_files(&root().join(place), &mut files);
    }
    let tests: String = files.iter().map(|file| read_to_string(file).expect("a text")).collect();
    let there = |test: &str| {
        ["", "    "].iter().any(|inside| tests.contains(&format!("#[test]\n{inside}fn {test}(")))
    };
    for [found, test] in findings::ELSEWHERE {
        assert!(there(test), "{found}: no test {test}");
    }
    // The damaged twin.
    assert!(!there("what_nobody_tests"));
}

/// The remainder of 1e32 by 2 pi once more: 1e32 is a whole number below 2^53 times 2^54, so
/// e^(i phi) is that of this number, squared 54 times. Each squaring doubles what is off.
#[test]
fn the_azimuth_of_many_turns_is_what_it_says() {
    let [azimuth, rest] = rotations::AZIMUTH;
    let whole = azimuth * ldexp(1.0, -54);
    assert!(whole < 1.0 / f64::EPSILON * 2.0 && whole.fract() == 0.0);
    let (mut sin, mut cos) = DoubleDouble::from(whole).sin_cos();
    for _ in 0..54 {
        (sin, cos) = ((sin * cos) * 2.0, cos.square() - sin.square());
    }
    let off = |rest: f64| {
        let (s, c) = sincos(rest);
        hypot(s - sin.to_f64(), c - cos.to_f64())
    };
    assert_eq!(off(rest), 0.0);
    // The damaged twin.
    assert!(off(rest + 1e-12) > 9e-13);
}
