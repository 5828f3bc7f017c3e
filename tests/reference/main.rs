//! Every case of the reference files, held to `K eps (|value| + max(sens_norm, sens_path))`.
//!
//! `REFERENCE_CASES=FILE cargo test --test reference -- --nocapture` runs the cases
//! of another file of the same schema instead. One line is printed per case, with
//! the factor K reached.

mod case;
mod free_body;
mod hard_cases;
mod heavy_asymmetric;
mod integrators;
mod ladder;
mod pendulum;
mod plank_fall;
mod top;

use case::{Case, Outcome};

/// A kind of case and the method that answers it.
struct Method {
    kind: &'static str,
    name: &'static str,
    /// The factor K no case of the repository exceeds: just above the measured one.
    bound: f64,
    /// The factor K promised for any other case of the schema.
    promised: f64,
    run: fn(&Case) -> Outcome,
}

const METHODS: &[Method] = &[
    Method {
        kind: "free_body",
        name: "exact::free_body",
        bound: free_body::BOUND,
        promised: 64.0,
        run: free_body::closed_form,
    },
    Method {
        kind: "ladder",
        name: "exact::ladder",
        bound: ladder::BOUND,
        promised: 64.0,
        run: ladder::closed_form,
    },
    Method {
        kind: "top_nd",
        name: "exact::heavy_top",
        bound: top::BOUND,
        promised: 64.0,
        run: top::dimensionless,
    },
    Method {
        kind: "top_si",
        name: "exact::heavy_top",
        bound: top::BOUND,
        promised: 64.0,
        run: top::dimensional,
    },
    Method {
        kind: "pendulum",
        name: "exact::pendulum",
        bound: pendulum::BOUND,
        promised: 64.0,
        run: pendulum::closed_form,
    },
    Method {
        kind: "plank_fall",
        name: "exact::plank",
        bound: plank_fall::BOUND,
        promised: 64.0,
        run: plank_fall::closed_form,
    },
];

#[test]
fn every_case_within_its_condition() {
    let (files, own) = case::files();
    let mut ran = 0;
    let mut failures = Vec::new();
    let mut uncovered = std::collections::BTreeMap::<String, usize>::new();
    for case in files.iter().flat_map(|file| case::read(file)) {
        let methods: Vec<_> = METHODS.iter().filter(|m| m.kind == case.kind).collect();
        if methods.is_empty() {
            *uncovered.entry(case.kind.clone()).or_default() += 1;
        }
        for method in methods {
            // A case that is refused or malformed fails on its own; the rest still run.
            let run = std::panic::AssertUnwindSafe(|| (method.run)(&case));
            let Ok(outcome) = std::panic::catch_unwind(run) else {
                failures.push(format!(
                    "{} by {}: see the message above",
                    case.id, method.name
                ));
                continue;
            };
            let allowed = if own { method.bound } else { method.promised };
            ran += 1;
            println!(
                "{:<28} {:<16} K = {:>6.2} of {} ({}, {} values)",
                case.id, method.name, outcome.factor, allowed, outcome.worst, outcome.compared
            );
            // Not `>`: a factor that is not a number must fail.
            if outcome.compared == 0 || !matches!(outcome.factor, k if k <= allowed) {
                failures.push(format!("{} by {}: {outcome:?}", case.id, method.name));
            }
        }
    }
    for (kind, count) in &uncovered {
        println!("not yet covered: {kind} ({count} cases)");
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
    if own {
        assert!(ran > 0, "no case ran");
    }
}

/// The harness itself must see an error: a length 200 eps off is refused.
#[test]
fn a_damaged_value_is_seen() {
    let case = case::own_files()
        .iter()
        .flat_map(|file| case::read(file))
        .find(|case| case.id == "ladder-15deg")
        .expect("the notes' own instance is among the cases");
    let damaged = ladder::closed_form_with_length(&case, 1.0 + 200.0 * case::EPS);
    assert!(damaged.factor > ladder::BOUND, "{damaged:?}");
}

/// A rate off by 1e-13 is refused in every asymmetric case of the notes.
#[test]
fn a_damaged_rate_is_seen() {
    let cases = case::read(&case::own_files()[0]);
    let free = cases.iter().filter(|case| case.id.starts_with("free-asym"));
    let factors: Vec<f64> = free
        .map(|case| free_body::closed_form_with_rate(case, 1.0 + 1e-13).factor)
        .collect();
    assert_eq!(factors.len(), 2);
    assert!(factors.iter().all(|k| *k > free_body::BOUND), "{factors:?}");
}

/// A gravity off by 1e-9 is refused in every case in which gravity is not tiny.
#[test]
fn a_damaged_gravity_is_seen() {
    let files = case::own_files();
    let cases = files.iter().flat_map(|file| case::read(file));
    let tops = cases.filter(|case| case.kind == "top_nd" && case.input("c").abs() > 1e-5);
    let factors: Vec<(String, f64)> = tops
        .map(|case| {
            // Refused is seen too: the energy may then be below the minimum.
            let factor = top::from_parameters(&case, 1.0 + 1e-9)
                .map_or(f64::INFINITY, |motion| top::compare(&case, &motion).factor);
            (case.id, factor)
        })
        .collect();
    assert!(factors.len() >= 35, "{}", factors.len());
    for (id, factor) in factors {
        assert!(!matches!(factor, k if k <= top::BOUND), "{id}: {factor}");
    }
}

/// A second route: a top without spin that swings in a plane is a pendulum.
#[test]
fn a_planar_top_is_a_pendulum() {
    let cases = case::read(&case::own_files()[0]);
    let factors: Vec<f64> = (cases.iter().filter(|case| case.kind == "pendulum"))
        .map(|case| top::pendulum(case).factor)
        .collect();
    assert_eq!(factors.len(), 3);
    assert!(factors.iter().all(|k| *k <= top::BOUND), "{factors:?}");
}

/// Gravity off by 1e-13 is refused in every case of the pendulum that swings or turns.
#[test]
fn a_damaged_pendulum_is_seen() {
    let cases = case::read(&case::own_files()[0]);
    let mut ran = 0;
    for case in &cases {
        if case.kind == "pendulum" && case.derived("T").is_some() {
            let damaged = pendulum::closed_form_with_gravity(case, 1.0 + 1e-13);
            assert!(damaged.factor > pendulum::BOUND, "{}: {damaged:?}", case.id);
            ran += 1;
        }
    }
    assert_eq!(ran, 2);
}

/// A length off by 1e-13 is refused in both planks.
#[test]
fn a_damaged_plank_is_seen() {
    let cases = case::read(&case::own_files()[0]);
    let planks = cases.iter().filter(|case| case.kind == "plank_fall");
    let factors: Vec<f64> = planks
        .map(|case| plank_fall::closed_form_with_length(case, 1.0 + 1e-13).factor)
        .collect();
    assert_eq!(factors.len(), 2);
    assert!(
        factors.iter().all(|k| *k > plank_fall::BOUND),
        "{factors:?}"
    );
}
