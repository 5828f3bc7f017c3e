//! DOP853 is of order 8(5,3), with an interpolant of order 7.

use super::kepler::{Kepler, distance, exact};
use super::trees::{Method, up_to};
use crate::slope::assert_slope;
use rotation_dynamics::Error;
use rotation_dynamics::integrators::dop853::coefficients::{
    A, ALL_STAGES, C, ERROR_5, ORDER_3, STAGES,
};
use rotation_dynamics::integrators::{Dop853, Integrator, Ode, Work, ode, size_or};
use rotation_dynamics::math::cos;
use support::{Errors, assert_error, assert_largest, attained};

fn method() -> Method {
    Method { a: A[..STAGES].iter().map(|row| row.to_vec()).collect(), b: A[STAGES].to_vec() }
}

/// The step minus the error estimate: the embedded method of order 5.
fn embedded_5() -> Method {
    let mut embedded = method();
    for &(i, e) in ERROR_5 {
        match embedded.b.iter_mut().find(|(j, _)| *j == i) {
            Some((_, b)) => *b -= e,
            None => embedded.b.push((i, -e)),
        }
    }
    embedded
}

#[test]
fn order_conditions() {
    let trees = up_to(9);
    let good = method();
    let [mut defects, mut of_fifth, mut of_third] =
        ["order 8", "order 5", "order 3"].map(Errors::of);
    let mut checked = 0;
    for nodes in 1..=8 {
        defects.push(good.defect(&trees, nodes));
        checked += trees.iter().filter(|t| t.nodes == nodes).count();
    }
    // At order 8; terms up to 43 cancel.
    assert_largest!(defects, 8, @"1.63e-13");
    assert_eq!(checked, 200);
    // One order more fails: measured 2.7e-2, 1.7e-2, 0.10.
    assert!(good.defect(&trees, 9) > 0.02);
    let (fifth, third) = (embedded_5(), Method { b: ORDER_3.to_vec(), ..method() });
    for nodes in 1..=5 {
        of_fifth.push(fifth.defect(&trees, nodes));
    }
    for nodes in 1..=3 {
        of_third.push(third.defect(&trees, nodes));
    }
    assert_largest!(of_fifth, 5, @"8.56e-14");
    assert_largest!(of_third, 3, @"2.15e-14");
    assert!(fifth.defect(&trees, 6) > 0.01 && third.defect(&trees, 4) > 0.1);
}

#[test]
fn every_coefficient_matters() {
    let trees = up_to(8);
    let good = method();
    let worst = |m: &Method| {
        let mut defects = Errors::of("order 8");
        (1..=8).for_each(|n| defects.push(m.defect(&trees, n)));
        defects.largest()
    };
    let mut damaged = Errors::of("order 8, a coefficient off by 1e-6");
    for i in 0..STAGES {
        for j in 0..good.a[i].len() {
            let mut bad = good.clone();
            bad.a[i][j].1 += 1e-6;
            damaged.push_at(worst(&bad), (i, j));
        }
    }
    for j in 0..good.b.len() {
        let mut bad = good.clone();
        bad.b[j].1 += 1e-6;
        damaged.push_at(worst(&bad), j);
    }
    // Measured: 9.9e-7 in the least sensitive one, five million times the bound above.
    damaged.exceed(9e-7, 58);
}

#[test]
fn row_sums() {
    let mut sums = Errors::of("sum of a row");
    for i in 0..ALL_STAGES {
        let sum: f64 = A[i].iter().map(|(_, a)| a).sum();
        sums.push_at(sum - C[i], i);
    }
    // In row 9, with terms up to 33.
    assert_largest!(sums, 16, @"6.11e-15");
}

/// Steps of equal length: any error is tolerated, and none may be longer.
fn fixed(steps: u32, t_end: f64) -> Dop853 {
    Dop853::new(0.1)
        .and_then(|m| m.with_longest_step(t_end / f64::from(steps)))
        .expect("a valid method")
}

#[test]
fn slope_of_steps_and_of_the_interpolant() {
    let t_end = 2.0;
    let (mut ends, mut between) = (Vec::new(), Vec::new());
    for steps in [16, 20, 25, 32, 40, 50] {
        let run = fixed(steps, t_end)
            .solve(&Kepler, 0.0, &exact(0.0), t_end, &[])
            .expect("a smooth orbit");
        let h = t_end / run.work().steps as f64;
        let expected = Work {
            derivatives: 2 + 15 * u64::from(steps),
            steps: u64::from(steps),
            ..Work::default()
        };
        assert_eq!(run.work(), expected);
        ends.push((h, distance(run.end_state(), &exact(t_end))));
        let mut errors = Errors::of("between the steps");
        for i in 0..200 {
            let t = t_end * (f64::from(i) + 0.37) / 200.0;
            errors.push(distance(&run.at(t).expect("within the run"), &exact(t)));
        }
        between.push((h, errors.largest()));
    }
    // Over errors from 1.0e-8 to 9.4e-13, round-off being 2e-16.
    assert_slope(&ends, "8.09", "0.19");
    // The interpolant's own error is of order 8 in one step.
    assert_slope(&between, "7.96", "0.087");
}

#[test]
fn the_tolerance_is_obeyed() {
    // Ten orbits: the error at the end against the tolerance per step.
    let t_end = 20.0 * core::f64::consts::PI;
    let mut ratios = Errors::of("error between the steps over that at the end");
    // Error at the end over the tolerance: from 1600 at 1e-4 to 6500 at 1e-6.
    for (tolerance, printed, derivatives) in [
        (1e-4, "0.16", 1449),
        (1e-6, "6.5e-3", 2253),
        (1e-8, "4.9e-5", 3681),
        (1e-10, "4.7e-7", 5590),
        (1e-12, "3.7e-9", 8416),
        (1e-14, "2.2e-11", 14750),
        (1e-15, "3.3e-12", 19694),
    ] {
        let method = Dop853::new(tolerance).expect("a valid tolerance");
        let (end, work) = method.advance(&Kepler, 0.0, &exact(0.0), t_end).expect("a smooth orbit");
        let delivered = distance(&end, &exact(t_end));
        attained(delivered, printed, "error at the end");
        assert_eq!(work.derivatives, derivatives);
        let run = method.solve(&Kepler, 0.0, &exact(0.0), t_end, &[]).expect("again");
        assert_eq!(run.end_state(), &end, "watching changes nothing");
        assert_eq!(run.work().derivatives, work.derivatives + 3 * work.steps);
        assert_eq!(
            work.derivatives,
            2 + 12 * work.steps + 11 * work.rejected,
            "every evaluation is accounted for"
        );
        let mut errors = Errors::of("between the steps");
        for i in 0..500 {
            let t = t_end * (f64::from(i) + 0.5) / 500.0;
            errors.push(distance(&run.at(t).expect("within the run"), &exact(t)));
        }
        ratios.push_at(errors.largest() / delivered, tolerance);
    }
    // The interpolant adds nothing to be seen.
    assert_largest!(ratios, 7, @"0.986");
}

#[test]
fn backwards_is_the_way_back() {
    let method = Dop853::new(1e-14).expect("a valid tolerance");
    let there = method.solve(&Kepler, 0.0, &exact(0.0), 7.0, &[]).expect("forwards");
    let back = method.solve(&Kepler, 7.0, there.end_state(), 0.0, &[]).expect("backwards");
    let mut errors = Errors::of("there and back");
    for i in 0..=70 {
        let t = 7.0 * f64::from(i) / 70.0;
        let (a, b) = (back.at(t), there.at(t));
        errors.push_at(distance(&a.expect("within"), &b.expect("within")), t);
    }
    assert_largest!(errors, 71, @"7.58e-13");
}

struct Growth;
impl Ode<1> for Growth {
    fn derivative(&self, _t: f64, [y]: &[f64; 1]) -> [f64; 1] {
        [y * y]
    }

    fn scale(&self, y: &[f64; 1]) -> [f64; 1] {
        size_or([1.0; 1])(y)
    }
}

struct Root;
impl Ode<1> for Root {
    fn derivative(&self, _t: f64, [y]: &[f64; 1]) -> [f64; 1] {
        [-y.sqrt() - 1.0]
    }

    fn scale(&self, y: &[f64; 1]) -> [f64; 1] {
        size_or([1.0; 1])(y)
    }
}

#[test]
fn bad_input_and_singularities() {
    let message = |r: rotation_dynamics::Result<Dop853>| r.expect_err("refused").to_string();
    assert_eq!(message(Dop853::new(f64::NAN)), "tolerance = NaN is not a finite number");
    for (bad, written) in [(0.0, "0"), (-1e-9, "-1e-9"), (1e-16, "1e-16"), (0.2, "0.2")] {
        let expected = format!("tolerance = {written} is not allowed: from 1e-15 to 0.1");
        assert_eq!(message(Dop853::new(bad)), expected);
    }
    let method = Dop853::new(1e-9).expect("valid");
    assert_eq!(message(method.with_step_limit(0)), "steps = 0 is not allowed: at least 1 step");
    assert_eq!(
        message(method.with_longest_step(0.0)),
        "longest step = 0 is not allowed: it must be greater than 0"
    );
    let run = |m: Dop853, t_end: f64| Integrator::advance(&m, &Growth, 0.0, &[1.0], t_end);
    assert_eq!(
        run(method, f64::NAN).expect_err("refused").to_string(),
        "end time = NaN is not a finite number"
    );
    // y = 1/(1-t): no step leads past t = 1.
    let error = run(method, 2.0).expect_err("refused");
    assert!(
        matches!(error, Error::StepUnderflow { t, step, .. } if (t - 1.0).abs() < 1e-9 && step < 1e-15),
        "{error}"
    );
    let short = method.with_step_limit(20).expect("valid");
    let error = run(short, 2.0).expect_err("refused");
    assert!(
        matches!(error, Error::LimitReached { what: "steps", t, limit: 20, .. } if t > 0.8 && t < 1.0),
        "{error}"
    );
    // sqrt of a negative number beyond y = 0.
    let fall = Integrator::advance(&method, &Root, 0.0, &[1.0], 5.0);
    let error = fall.expect_err("refused");
    // y reaches 0 at t = 2 - 2 ln 2.
    assert!(
        matches!(error, Error::FunctionOutOfRange { t, .. } if (t - 0.613_705_638_880_109_4).abs() < 1e-9),
        "{error}"
    );
    let still = method.solve(&Growth, 3.0, &[1.0], 3.0, &[]).expect("no time passes");
    assert_eq!(still.work(), Work::default());
    assert_eq!(still.at(3.0).expect("the one time"), [1.0]);
    assert_eq!(
        still.at(4.0).expect_err("outside").to_string(),
        "t = 4 is outside the run, which goes from 3 to 3"
    );
}

/// The same motion in other units: as many steps, the same error.
#[test]
fn units_do_not_matter() {
    struct Oscillator {
        unit: f64,
        time: f64,
    }
    impl Ode<2> for Oscillator {
        fn derivative(&self, _t: f64, &[x, v]: &[f64; 2]) -> [f64; 2] {
            [v / self.time, -x / self.time]
        }
        fn scale(&self, _y: &[f64; 2]) -> [f64; 2] {
            [self.unit; 2]
        }
    }
    // Powers of two: nothing is rounded, so the runs must be equal bit for bit.
    let run = |unit: f64, time: f64| {
        let method = Dop853::new(1e-10).expect("valid");
        let ode = Oscillator { unit, time };
        let (end, work) = method.advance(&ode, 0.0, &[unit, 0.0], 20.0 * time).expect("smooth");
        (end.map(|c| c / unit), work)
    };
    let reference = run(1.0, 1.0);
    assert_eq!(reference, run(0.000_030_517_578_125, 1.0));
    assert_eq!(reference, run(1.0, 1024.0));
    assert_eq!(reference, run(1_048_576.0, 0.125));
    // A scale must be positive.
    let zero = Oscillator { unit: 0.0, time: 1.0 };
    let method = Dop853::new(1e-10).expect("valid");
    let error = Integrator::advance(&method, &zero, 0.0, &[1.0, 0.0], 1.0);
    assert_eq!(
        error.expect_err("refused").to_string(),
        "scale of a component = 0 is not allowed: it must be greater than 0"
    );
}

/// An oscillation of amplitude 1e-6 over 20 rad: what it keeps where errors count against its own
/// size, and what it loses where they count against 1.
#[test]
fn a_scale_far_above_the_state_costs_its_digits() {
    let method = Dop853::new(1e-12).expect("valid");
    let off = |least: f64| {
        let spring = ode(|_, &[x, v]: &[f64; 2]| [v, -x]).scaled(size_or([least; 2]));
        let (end, _) = method.advance(&spring, 0.0, &[1e-6, 0.0], 20.0).expect("smooth");
        (1e6 * end[0] - cos(20.0)).abs()
    };
    assert_error!(off(1e-6), 5.2e-13);
    assert_error!(off(1.0), 4.2e-7);
}

/// What the solution keeps and the method does not is put back at the end of each step; between
/// them the interpolant goes to where it was put, in one piece.
#[test]
fn what_drifts_is_put_back() {
    struct Circle {
        kept: bool,
    }
    impl Ode<2> for Circle {
        fn derivative(&self, _t: f64, &[x, y]: &[f64; 2]) -> [f64; 2] {
            [-y, x]
        }
        fn drift(&self, _t: f64, y: &[f64; 2], within: f64) -> Option<[f64; 2]> {
            let beyond = 0.5 * (y[0] * y[0] + y[1] * y[1] - 1.0);
            (self.kept && beyond.abs() > within).then(|| y.map(|c| beyond * c))
        }

        fn scale(&self, y: &[f64; 2]) -> [f64; 2] {
            size_or([1.0; 2])(y)
        }
    }
    let run = |kept| {
        let method = Dop853::new(1e-6).expect("valid");
        let run = method.solve(&Circle { kept }, 0.0, &[1.0, 0.0], 500.0, &[]);
        run.expect("smooth")
    };
    let off = |[x, y]: [f64; 2]| x * x + y * y - 1.0;
    let (kept, lost) = (run(true), run(false));
    let mut ends = Errors::of("squared radius at the ends of steps");
    let mut jumps = Errors::of("jumps in the middle of steps");
    let mut from = 0.0;
    for to in kept.step_times() {
        ends.push(off(kept.at(to).expect("inside")));
        let middle = 0.5 * (from + to);
        let [before, after] = [middle, middle * (1.0 + 1e-15)].map(|t| kept.at(t).expect("inside"));
        jumps.push(before[0] - after[0]);
        from = to;
    }
    let steps = kept.step_times().count();
    assert_largest!(ends, steps, @"2.00e-7");
    assert_largest!(jumps, steps, @"5.65e-13");
    // The damaged twin ends fifty times as far off.
    let lost = off(*lost.end_state()).abs();
    assert!((9.9e-6..=1e-5).contains(&lost), "{lost:e}");
}
