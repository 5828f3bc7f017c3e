//! The heavy top's hard cases against the plain formulas that everyone writes first:
//! each row names the formula, and shows it broken where the closed form holds.

use super::case::{self, Case, EPS};
use super::top;
use models::naive::{quarter_period, runge_kutta, turning_point};
use rotation_dynamics::exact::heavy_top::HeavyTop;
use rotation_dynamics::math::{acos, cos, sin};
use support::{Errors, assert_largest, attained};

struct Row {
    case: &'static str,
    plain: &'static str,
    /// The quantity, by the plain formula and by the library.
    both: fn(&Case, &HeavyTop) -> (f64, f64),
    /// The reference and its scale, |value| + condition.
    want: fn(&Case) -> (f64, f64),
    /// The factor K of the plain formula, as printed.
    broken: &'static str,
}

const ROWS: &[Row] = &[
    Row {
        case: "sleepish-1",
        plain: "theta from acos(cos theta)",
        both: |_, motion| (acos(cos(motion.theta_min())), motion.theta_min()),
        want: |case| derived(case, "theta_min"),
        broken: "2.0e15", // nothing is left
    },
    Row {
        case: "near-homo-0",
        plain: "1 - m by subtraction",
        both: |_, motion| {
            let period = motion.nutation_period();
            let plain = quarter_period(1.0 - motion.parameter());
            let exact = quarter_period(motion.complementary_parameter());
            (period * plain / exact, period)
        },
        want: |case| derived(case, "T_nut"),
        broken: "4.7e6",
    },
    Row {
        case: "near-steady-0",
        plain: "roots of the cubic by the trigonometric formula",
        both: |case, motion| (theta_min_by_formula(case, motion), motion.theta_min()),
        want: |case| derived(case, "theta_min"),
        broken: "3.8e7",
    },
    Row {
        case: "near1-0",
        plain: "Runge-Kutta steps of (4) past the pole, 2000 a period",
        both: |case, motion| {
            let t = second_time(case);
            (theta_by_steps(case, motion, t), motion.angles(t).theta)
        },
        want: |case| {
            let sample = case.samples().nth(1).expect("a second sample");
            let want = sample.value("theta").expect("theta").to_f64();
            (want, want.abs() + sample.condition("theta").expect("a condition"))
        },
        broken: "1.2e13",
    },
];

fn input(case: &Case, name: &str) -> f64 {
    case.input(name).expect("the repository's own case")
}

fn second_time(case: &Case) -> f64 {
    case.samples().nth(1).expect("a second sample").t()
}

fn derived(case: &Case, name: &str) -> (f64, f64) {
    let want = case.derived(name).expect("the value").to_f64();
    (want, want.abs())
}

/// The smaller turning point from the coefficients of the cubic in cos theta.
fn theta_min_by_formula(case: &Case, motion: &HeavyTop) -> f64 {
    let energy = motion.energy_reduced().expect("a dimensionless top");
    turning_point(["a", "b", "c"].map(|name| input(case, name)), energy)
}

/// theta by the classical Runge-Kutta method on the notes' equation (4).
fn theta_by_steps(case: &Case, motion: &HeavyTop, t: f64) -> f64 {
    let [a, b, c] = ["a", "b", "c"].map(|name| input(case, name));
    let slope = |&[theta, rate]: &[f64; 2]| {
        let (s, u) = (sin(theta), cos(theta));
        [rate, c * s - a * (b - u) * (1.0 - b * u) / (s * s * s)]
    };
    let steps = (2000.0 * t / motion.nutation_period()).ceil() as u32;
    let start = ["theta0", "dtheta0"].map(|name| input(case, name));
    let [theta, _] = runge_kutta(slope, start, t, steps).last().expect("a step");
    theta
}

#[test]
fn plain_formulas_break_where_the_closed_form_holds() {
    let cases: Vec<Case> = case::own_files().iter().flat_map(|file| case::read(file)).collect();
    let mut held = Errors::of("closed form");
    for row in ROWS {
        let case = cases
            .iter()
            .find(|case| case.id == row.case)
            .expect("the case is among the repository's own");
        let motion = top::from_parameters(case, 1.0).expect("a motion");
        let (want, scale) = (row.want)(case);
        let (plain, ours) = (row.both)(case, &motion);
        let factor = |got: f64| (got - want).abs() / (EPS * scale);
        println!(
            "{:<14} {:<54} K = {:>8.1e}   closed form {:.2}",
            row.case,
            row.plain,
            factor(plain),
            factor(ours)
        );
        held.push_at(factor(ours), row.case);
        attained(factor(plain), row.broken, row.plain);
    }
    assert_largest!(held, 4, @"7.36e-3");
}
