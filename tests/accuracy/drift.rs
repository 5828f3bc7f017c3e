//! Long-time drift: with which power of the time errors grow, method by method.
//!
//! Root mean squares over eight starts: one random walk proves nothing. A million periods
//! are in `benches/record/drift.txt`, whose first rows are computed again here.

#[path = "../../examples/accuracy_races/drift.rs"]
#[allow(dead_code, reason = "the names of the methods are for figures and records")]
mod curves;

use curves::{Curve, Gravity, Kind, Method, Point, Subject, curve, times};
use rotation_dynamics::accuracy::Errors;
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::State;
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::integrators::gauss_legendre::LaneByLane;
use rotation_dynamics::integrators::gauss_legendre::coefficients::{NODES, STAGES, WEIGHTS};
use rotation_dynamics::integrators::scene::components;
use rotation_dynamics::integrators::{
    FirstIntegrals, GaussLegendre, Integrator, Ode, Projected, Rk4, SpinFree, Work,
};
use rotation_dynamics::math::EPS;
use support::{Errors as Judge, assert_error, assert_largest, attained};

const STARTS: usize = 8;

fn grown(method: Method, kind: Kind, periods: f64) -> Curve {
    let curve = curve(method, kind, STARTS, periods).expect("smooth motions");
    assert_eq!(curve.points.len(), times(periods).len());
    curve
}

/// The exponents of phase and invariants.
fn exponents(curve: &Curve, from: f64) -> [f64; 2] {
    [curve.exponent(from, |point| point.phase), curve.exponent(from, |point| point.invariants)]
}

fn last(curve: &Curve) -> Point {
    *curve.points.last().expect("points")
}

/// Exponents as printed.
#[track_caller]
fn assert_exponents(got: [f64; 2], printed: [&str; 2]) {
    for (got, (printed, what)) in got.into_iter().zip(printed.into_iter().zip(["phase", "kept"])) {
        attained(got, printed, what);
    }
}

#[test]
fn brouwers_law_without_projection_and_a_straight_line_with_it() {
    let mut ran = 0;
    // The walk of the free body is not quite one: some 1e-19 of the energy a step always
    // to the same side. The exponents of the walk and of the line, and the line's phase a
    // period and invariants at its end.
    for (kind, walking, along, ends) in [
        (Kind::Top, ["1.55", "0.55"], ["1.13", "0.08"], ["3.6e-15", "8.9e-16"]),
        (Kind::Free, ["1.55", "0.70"], ["1.26", "0.16"], ["6.6e-15", "5.8e-16"]),
    ] {
        let walk = grown(Method::Gauss, kind, 6e3);
        let line = grown(Method::GaussProjected, kind, 6e3);
        assert_exponents(exponents(&walk, 100.0), walking);
        assert_exponents(exponents(&line, 100.0), along);
        let end = last(&line);
        attained(end.phase / end.periods, ends[0], "phase a period");
        attained(end.invariants, ends[1], "invariants");
        // The walk has left by then. Measured: 2.2 and 9.8 times as far.
        assert!(last(&walk).invariants > 2.0 * end.invariants);
        ran += 1;
    }
    assert_eq!(ran, 2);
}

#[test]
fn a_splitting_drifts_in_phase_as_t_and_in_invariants_as_its_root() {
    let curve = grown(Method::Splitting, Kind::Top, 2e3);
    // The phase is truncation, 1.1e-13 rad a period.
    assert_exponents(exponents(&curve, 10.0), ["1.000", "0.41"]);
}

#[test]
fn a_method_that_loses_energy_drifts_as_t_and_t_squared() {
    let mut ran = 0;
    for (kind, printed) in [(Kind::Top, ["2.02", "1.01"]), (Kind::Free, ["2.00", "1.00"])] {
        let curve = grown(Method::Dop853, kind, 1e3);
        assert_exponents(exponents(&curve, 100.0), printed);
        ran += 1;
    }
    let curve = grown(Method::Rk4, Kind::Top, 1e3);
    // The phase has its own linear part, ten times as large at first.
    assert_error!(exponents(&curve, 100.0)[1], 1.00);
    assert_eq!(ran, 2);
}

/// Gauss-Legendre as one writes it first: rounded coefficients, plain sums.
fn plain(problem: &impl Ode<7>, y: &mut [f64; 7], h: f64, steps: u64) {
    for _ in 0..steps {
        let mut slopes = [problem.derivative(0.0, y); 8];
        for _ in 0..24 {
            let stages: [[f64; 7]; 8] = core::array::from_fn(|i| {
                core::array::from_fn(|k| {
                    let sum: f64 = (0..8).map(|j| STAGES[j][i] * slopes[j][k]).sum();
                    y[k] + h * sum
                })
            });
            slopes = core::array::from_fn(|i| problem.derivative(h * NODES[i], &stages[i]));
        }
        for (k, component) in y.iter_mut().enumerate() {
            let sum: f64 = (0..8).map(|j| WEIGHTS[j] * slopes[j][k]).sum();
            *component += h * sum;
        }
    }
}

/// The invariants of tops stepped sixty times a period, by the stepper given.
fn with_small_steps(carry: impl Fn(&SpinFree<'_, Gravity>, &mut [f64; 7], f64, u64)) -> Vec<f64> {
    let times = times(400.0);
    let mut squares = vec![0.0; times.len()];
    for n in 0..STARTS {
        let subject = Subject::new(Kind::Top, n).expect("a top");
        let Subject::Top { scene, start, .. } = &subject else {
            panic!("a top");
        };
        let problem = SpinFree::new(scene).expect("symmetric");
        let (mut y, mut done) = (components(start), 0.0);
        for (sum, periods) in squares.iter_mut().zip(&times) {
            let span = (periods - done) * subject.period();
            carry(&problem, &mut y, span, ((periods - done) * 60.0).round() as u64);
            done = *periods;
            let spin = problem.spin_rate(start) * done * subject.period();
            let state = problem.state(&y, spin).expect("finite");
            let kept = Errors::between(scene, &state, start).invariants;
            *sum += kept * kept / STARTS as f64;
        }
    }
    squares.into_iter().map(f64::sqrt).collect()
}

/// The damaged twin: without compensation and without what rounding the coefficients
/// leaves out.
#[test]
fn plain_sums_drift_more() {
    let own = with_small_steps(|problem, y, span, steps| {
        let method = GaussLegendre::new(steps).expect("steps");
        (*y, _) = method.advance(&LaneByLane(problem), 0.0, y, span).expect("smooth");
    });
    let twin = with_small_steps(|problem, y, span, steps| {
        plain(problem, y, span / steps as f64, steps);
    });
    assert_eq!((own.len(), twin.len()), (7, 7));
    // After 316 periods.
    assert_error!(own[6], 3.3 eps);
    assert_error!(twin[6], 20.8 eps);
}

/// The record's rows of a method, up to so many periods.
fn recorded(table: &str, method: &str, most: f64) -> Vec<[f64; 3]> {
    include_str!("../../benches/record/drift.txt")
        .lines()
        .skip_while(|line| *line != format!("table {table}"))
        .skip(2)
        .take_while(|line| !line.is_empty())
        .filter_map(|line| {
            let mut cells = line.split("  ").map(str::trim).filter(|cell| !cell.is_empty());
            (cells.next() == Some(method)).then(|| {
                let mut next = || cells.next().and_then(|cell| cell.parse().ok());
                [(); 3].map(|()| next().expect("a number"))
            })
        })
        .filter(|row| row[0] <= most)
        .collect()
}

/// The long record is what the methods do now: its first rows, computed again.
#[test]
fn the_record_is_of_these_methods() {
    let mut ran = 0;
    for (table, kind) in [("top", Kind::Top), ("free", Kind::Free)] {
        for method in [Method::Gauss, Method::GaussProjected, Method::Dop853] {
            let again = grown(method, kind, 100.0);
            for [periods, phase, invariants] in recorded(table, method.names().1, 100.0) {
                let point = again.points.iter().find(|point| point.periods == periods);
                let point = point.expect("the same periods");
                // Rounded up to a digit; round-off that changes with the code is not asked for.
                for (now, then) in [(point.phase, phase), (point.invariants, invariants)] {
                    assert!(now < 4.0 * then && then < 4.0 * now, "{table} {point:?}");
                }
                ran += 1;
            }
        }
    }
    assert_eq!(ran, 12);
}

fn moved(state: &State, by: f64) -> State {
    let turn = SpaceVector::new(0.3, -0.5, 0.8) * by;
    State {
        attitude: Attitude::from_rotation_vector(turn).expect("finite") * state.attitude,
        angular_momentum: state.angular_momentum + SpaceVector::new(0.7, 0.2, -0.4) * by,
    }
}

#[test]
fn projection_brings_back_what_is_kept_by_a_short_way() {
    let [mut once_left, mut way_back] = ["left after one step", "the way back"].map(Judge::of);
    let mut twice_left = Judge::in_units_of(EPS, "left after two steps");
    for n in 0..STARTS {
        let subject = Subject::new(Kind::Top, n).expect("a top");
        let Subject::Top { scene, start, .. } = &subject else {
            panic!("a top");
        };
        for by in [1e-4, 1e-9] {
            let away = moved(start, by);
            let once = scene.restored(&away, start).expect("finite");
            let twice = scene.restored(&once, start).expect("finite");
            let off = |state| Errors::between(scene, state, start).invariants;
            once_left.push_at(off(&once) / (by * by + 1e-15), by);
            twice_left.push_at(off(&twice), by);
            // Damaged twin: without projection the invariants are off by the way itself.
            assert!(off(&away) > 0.01 * by);
            let way = Errors::between(scene, &once, &away);
            way_back.push_at(way.attitude / by, by);
            way_back.push_at(way.momentum / by, by);
        }
    }
    // The square of the way, and round-off.
    assert_largest!(once_left, 16, @"0.429");
    assert_largest!(twice_left, 16, @"4.19");
    // No farther back than it was away.
    assert_largest!(way_back, 2 * 16, @"0.520");
}

#[test]
fn a_projected_run_refuses_what_it_cannot_do_and_counts_its_work() {
    let subject = Subject::new(Kind::Free, 0).expect("a body");
    let Subject::Free { scene, start, .. } = &subject else {
        panic!("a free body");
    };
    let step = Rk4::new(10).expect("steps");
    assert!(Projected::new(step, 0).is_err());
    let method = Projected::new(step, 3).expect("blocks");
    assert!(method.advance(scene, 0.0, start, f64::NAN).is_err());
    let (same, work) = method.advance(scene, 1.0, start, 1.0).expect("no time");
    assert_eq!((same, work), (*start, Work::default()));
    let (_, work) = method.advance(scene, 0.0, start, 1.0).expect("smooth");
    assert_eq!((work.steps, work.derivatives), (30, 120));
    // About one axis the energy follows from L: nothing to project, nothing spoilt.
    let body = scene.body();
    let spinning = body.state(Attitude::IDENTITY, BodyVector::new(0.0, 0.0, 1.0)).expect("finite");
    let (end, _) = method.advance(scene, 0.0, &spinning, 1.0).expect("smooth");
    assert_eq!(end.angular_momentum, spinning.angular_momentum);
}
