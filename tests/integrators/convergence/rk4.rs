//! RK4 is of order 4.

use super::kepler::{Kepler, distance, exact};
use super::trees::{Method, up_to};
use crate::slope::{assert_slope, fitted};
use rotation_dynamics::integrators::{Integrator, Rk4, Tableau, Work};
use support::{Errors, assert_largest};

fn method(tableau: &Tableau<4>) -> Method {
    Method { a: tableau.a.iter().map(|row| row.to_vec()).collect(), b: tableau.b.to_vec() }
}

#[test]
fn order_conditions() {
    let trees = up_to(5);
    let good = method(&Rk4::TABLEAU);
    let mut defects = Errors::of("order 4");
    (1..=4).for_each(|nodes| defects.push(good.defect(&trees, nodes)));
    assert_largest!(defects, 4, @"1.11e-16");
    // One order more fails: measured 0.25.
    assert!(good.defect(&trees, 5) > 0.2);
    let mut damaged = good;
    damaged.b[1].1 += 1e-6;
    assert!(damaged.defect(&trees, 1) > 2.3e-16);
}

fn errors(tableau: &Tableau<4>) -> Vec<(f64, f64)> {
    let t_end = 2.0;
    [100u64, 200, 400, 800, 1600]
        .into_iter()
        .map(|steps| {
            let (end, work) =
                tableau.advance(&Kepler, 0.0, &exact(0.0), t_end, steps).expect("a smooth orbit");
            let expected = Work { derivatives: 4 * steps, steps, ..Work::default() };
            assert_eq!(work, expected);
            (t_end / steps as f64, distance(&end, &exact(t_end)))
        })
        .collect()
}

#[test]
fn slope() {
    // Errors from 4e-6 to 6e-11.
    assert_slope(&errors(&Rk4::TABLEAU), "4.030", "0.014");
    let mut damaged = Rk4::TABLEAU;
    damaged.b = &[(0, 1.0 / 6.0), (1, 1.0 / 3.0 + 1e-6), (2, 1.0 / 3.0), (3, 1.0 / 6.0)];
    let (slope, _) = fitted(&errors(&damaged));
    // Measured: 1.44.
    assert!((slope - 4.0).abs() > 0.1);
}

#[test]
fn nothing_to_do_and_bad_input() {
    let start = exact(0.0);
    let method = Rk4::new(10).expect("ten steps");
    let (end, work) = method.advance(&Kepler, 1.0, &start, 1.0).expect("no time passes");
    assert_eq!((end, work), (start, Work::default()));
    let refused = |message: &str, result: rotation_dynamics::Result<([f64; 4], Work)>| {
        assert_eq!(result.expect_err("refused").to_string(), message);
    };
    assert_eq!(
        Rk4::new(0).expect_err("refused").to_string(),
        "steps = 0 is not allowed: at least 1 step"
    );
    refused(
        "end time = NaN is not a finite number",
        method.advance(&Kepler, 0.0, &start, f64::NAN),
    );
    refused(
        "state = inf is not a finite number",
        method.advance(&Kepler, 0.0, &[0.0, f64::INFINITY, 0.0, 0.0], 1.0),
    );
    refused(
        "the derivative at t = 0, y = [0.0, 0.0, 1.0, 0.0] is [1.0, 0.0, NaN, NaN]; it must be finite",
        method.advance(&Kepler, 0.0, &[0.0, 0.0, 1.0, 0.0], 1.0),
    );
}

#[test]
fn methods_say_what_they_are_and_what_they_cost() {
    use rotation_dynamics::integrators::Method;
    let all = Method::ALL.map(Method::about);
    assert_eq!(all.map(|a| a.order), [1, 1, 4, 4, 2, 4, 6, 8, 2, 4, 4, 8, 16]);
    for (i, a) in all.iter().enumerate() {
        assert!(!a.source.is_empty() && !a.idea.is_empty());
        assert!(all[..i].iter().all(|b| b.name != a.name && b.key != a.key));
    }
    let work = Work { derivatives: 480, steps: 38, rejected: 4, ..Work::default() };
    assert_eq!(work.to_string(), "38 steps, 4 rejected, 480 derivatives");
    assert_eq!(Work::default().to_string(), "no work");
    let mut twice = work;
    twice += work;
    assert_eq!((twice.steps, twice.torques()), (76, 960));
}
