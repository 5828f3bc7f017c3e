//! Every case of the reference files, held to `K eps (|value| + max(sens_norm, sens_path))`.
//!
//! `REFERENCE_CASES=FILE cargo test --test reference -- --nocapture` runs the cases
//! of another file of the same schema instead. One line is printed per case, with
//! the factor K reached; a case that a method cannot judge is named with what it lacks. A
//! refusal fails unless the case's own condition leaves nothing to be known.

mod case;
mod free_body;
mod hard_cases;
mod heavy_asymmetric;
mod integrators;
mod ladder;
mod pendulum;
mod plank_fall;
mod roller_plank;
mod top;

use case::{Case, Outcome, Trouble};
use core::ops::RangeInclusive;
use std::collections::BTreeMap;
use std::path::PathBuf;
use support::{Errors, assert_largest};

/// A kind of case and the method that answers it.
struct Method {
    kind: &'static str,
    name: &'static str,
    /// The largest factor K of the repository's cases, and how many those are.
    measured: RangeInclusive<f64>,
    cases: usize,
    /// The factor K promised for any other case of the schema.
    promised: f64,
    run: fn(&Case) -> case::Result<Outcome>,
}

const METHODS: [Method; 7] = [
    Method {
        kind: "free_body",
        name: "exact::free_body",
        measured: 2.8..=2.9,
        cases: 49,
        promised: 64.0,
        run: free_body::closed_form,
    },
    Method {
        kind: "ladder",
        name: "models::ladder",
        measured: 4.8..=4.9,
        cases: 25,
        promised: 64.0,
        run: ladder::closed_form,
    },
    Method {
        kind: "top_nd",
        name: "exact::heavy_top",
        measured: 2.4..=2.5,
        cases: 48,
        promised: 64.0,
        run: top::dimensionless,
    },
    Method {
        kind: "top_si",
        name: "exact::heavy_top",
        measured: 1.8..=1.9,
        cases: 16,
        promised: 64.0,
        run: top::dimensional,
    },
    Method {
        kind: "pendulum",
        name: "exact::pendulum",
        measured: 1.8..=1.9,
        cases: 49,
        promised: 64.0,
        run: pendulum::closed_form,
    },
    Method {
        kind: "plank_fall",
        name: "models::plank",
        measured: 4.7..=4.8,
        cases: 29,
        promised: 64.0,
        run: plank_fall::closed_form,
    },
    Method {
        kind: "roller_plank",
        name: "planar::contact",
        measured: 6.0..=6.1,
        cases: 7,
        promised: 1000.0,
        run: roller_plank::contacts,
    },
];

/// Kinds that have no solver here, and how many cases of each are in the repository: `static`
/// are exercises with a page each, which `tests/pages/reference_statics.rs` asks.
const NOT_COVERED: [(&str, usize); 1] = [("static", 16)];

/// How many of the repository's cases the library refuses, where nothing is lost: a pendulum
/// after 1e16 radians.
const REFUSED: usize = 1;

#[test]
fn every_case_within_its_condition() {
    let (files, own) = case::files();
    let mut factors = METHODS.each_ref().map(|method| Errors::of(method.kind));
    let mut not_run = BTreeMap::<String, usize>::new();
    let (mut failures, mut refused) = (Vec::new(), 0);
    let cases = files.iter().flat_map(|file| case::read(file));
    // Those without a closed form have a test of their own.
    let cases: Vec<Case> = cases.filter(|case| case.kind != heavy_asymmetric::KIND).collect();
    for case in &cases {
        let Some(i) = METHODS.iter().position(|method| method.kind == case.kind) else {
            *not_run.entry(case.kind.clone()).or_default() += 1;
            continue;
        };
        let method = &METHODS[i];
        match (method.run)(case) {
            Ok(outcome) if outcome.compared > 0 => {
                let allowed = if own { *method.measured.end() } else { method.promised };
                outcome.print(case, method.name, allowed);
                factors[i].push_at(outcome.factor, &case.id);
                if !outcome.within(allowed) {
                    failures.push(format!("{} by {}: {outcome:?}", case.id, method.name));
                }
            }
            Err(Trouble::Refused(error)) if case.is_meaningless() => {
                println!("{:<28} {:<16} refused, as it may: {error}", case.id, method.name);
                refused += 1;
            }
            Err(Trouble::Refused(error)) => {
                failures.push(format!("{} by {}: {error}", case.id, method.name));
            }
            // It lacks an input, or holds nothing that can be judged.
            lacking => {
                case::print_not_run(case, method.name, &lacking);
                *not_run.entry(case.kind.clone()).or_default() += 1;
            }
        }
    }
    for (kind, count) in &not_run {
        println!("not run: {count} of kind {kind}");
    }
    let ran = cases.len() - refused - not_run.values().sum::<usize>();
    println!("{ran} of {} cases ran, {refused} refused", cases.len());
    assert!(failures.is_empty(), "{}", failures.join("\n"));
    for (factors, method) in factors.iter().zip(&METHODS) {
        if own {
            factors.attain(method.measured.clone(), method.cases);
        } else {
            println!("{}: largest K {:.2}", method.kind, factors.largest());
        }
    }
    if own {
        assert_eq!(refused, REFUSED);
        assert!(not_run.iter().map(|(kind, n)| (kind.as_str(), *n)).eq(NOT_COVERED));
    }
}

/// The factors of the cases of a kind that are chosen, as this judge has them.
fn factors(files: &[PathBuf], kind: &str, judge: impl Fn(&Case) -> Option<f64>) -> Errors {
    let mut factors = Errors::of(kind);
    for case in files.iter().flat_map(|file| case::read(file)) {
        if case.kind == kind
            && let Some(factor) = judge(&case)
        {
            factors.push_at(factor, &case.id);
        }
    }
    factors
}

/// The harness itself must see an error: a length 200 eps off is refused.
#[test]
fn a_damaged_value_is_seen() {
    let factors = factors(&case::own_files(), "ladder", |case| {
        let off = || ladder::closed_form_with_length(case, 1.0 + 200.0 * case::EPS);
        (case.id == "ladder-15deg").then(|| off().expect("runs").factor)
    });
    factors.exceed(ladder::BOUND, 1);
}

/// A rate off by 1e-13 is refused in every asymmetric case of the notes.
#[test]
fn a_damaged_rate_is_seen() {
    let factors = factors(&case::own_files(), "free_body", |case| {
        let off = || free_body::closed_form_with_rate(case, 1.0 + 1e-13);
        (case.id.starts_with("free-asym")).then(|| off().expect("runs").factor)
    });
    factors.exceed(free_body::BOUND, 2);
}

/// A gravity off by 1e-9 is refused in every case in which gravity is not tiny.
#[test]
fn a_damaged_gravity_is_seen() {
    let factors = factors(&case::own_files(), "top_nd", |case| {
        // Refused is seen too: the energy may then be below the minimum.
        let off = || {
            top::from_parameters(case, 1.0 + 1e-9)
                .map_or(f64::INFINITY, |motion| top::compare(case, &motion).factor)
        };
        (case.input("c").expect("c").abs() > 1e-5).then(off)
    });
    factors.exceed(top::BOUND, 44);
}

/// A second route: a top without spin that swings in a plane is a pendulum.
#[test]
fn a_planar_top_is_a_pendulum() {
    let factors = factors(&case::own_files()[..1], "pendulum", |case| {
        Some(top::pendulum(case).expect("runs").factor)
    });
    assert_largest!(factors, 3, @"0.342");
}

/// Gravity off by 1e-13 is refused in every case of the pendulum that swings or turns.
#[test]
fn a_damaged_pendulum_is_seen() {
    let factors = factors(&case::own_files()[..1], "pendulum", |case| {
        let off = || pendulum::closed_form_with_gravity(case, 1.0 + 1e-13);
        case.derived("T").is_some().then(|| off().expect("runs").factor)
    });
    factors.exceed(pendulum::BOUND, 2);
}

/// A length off by 1e-13 is refused in every plank.
#[test]
fn a_damaged_plank_is_seen() {
    let factors = factors(&case::own_files(), "plank_fall", |case| {
        let off = plank_fall::closed_form_with_length(case, 1.0 + 1e-13);
        Some(off.expect("runs").factor)
    });
    factors.exceed(plank_fall::BOUND, 29);
}

/// Friction off by 1e-9 is refused in every plank on rollers.
#[test]
fn a_damaged_friction_is_seen() {
    let factors = factors(&case::own_files()[..1], "roller_plank", |case| {
        let off = roller_plank::contacts_with_friction(case, 1.0 + 1e-9);
        Some(off.expect("runs").factor)
    });
    factors.exceed(1e4, 3);
}

/// A case is measured by what it holds, and what it lacks is said: a file from
/// elsewhere does not end in a panic.
#[test]
fn partial_cases_are_measured_by_what_they_hold() {
    let cases = case::read(&case::own_files()[0]);
    let whole = cases.iter().find(|case| case.id == "si-gyroscope");
    let whole = whole.expect("the notes' gyroscope");
    let run = METHODS.iter().find(|m| m.kind == "top_si").expect("tops").run;
    let compared = |case: &Case| run(case).expect("runs").compared;
    let samples = whole.samples().count();
    let mut fewer = Vec::new();
    // A passage through a pole has no theta; one sample may hold less than another.
    for field in ["theta", "phi", "R", "omega", "L_space", "t"] {
        fewer.push(compared(whole) - compared(&whole.without(field)));
    }
    let all = 5 + 9 + 3 + 3;
    assert_eq!(fewer, [1, 1, 9, 3, 3, all].map(|values| values * samples));
    // Without its conditions a value is counted and not judged.
    let blind = whole.without("sens_norm").without("sens_path");
    let outcome = run(&blind).expect("runs");
    assert_eq!(outcome.unjudged, all * samples);
    // Without inputs nothing runs.
    assert!(matches!(run(&whole.without("inputs")), Err(Trouble::Lacks(_))));
    // What stands there and is wrong counts, and is no panic.
    for wrong in ["asleep", "1e", ""] {
        let outcome = run(&whole.with_theta(wrong)).expect("runs");
        assert!(!outcome.within(1e300), "{wrong}: {outcome:?}");
    }
}
