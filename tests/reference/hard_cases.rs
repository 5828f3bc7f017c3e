//! The heavy top's hard cases against the plain formulas that everyone writes first:
//! each row names the formula, and shows it broken where the closed form holds.

use super::case::{self, Case, EPS};
use super::top;
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

/// K by the arithmetic-geometric mean.
fn quarter_period(m1: f64) -> f64 {
    let (mut a, mut b) = (1.0, m1.sqrt());
    for _ in 0..60 {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    core::f64::consts::FRAC_PI_2 / a
}

/// The smaller turning point from the coefficients of the cubic in cos theta.
fn theta_min_by_formula(case: &Case, motion: &HeavyTop) -> f64 {
    let (a, b, c) = (input(case, "a"), input(case, "b"), input(case, "c"));
    let energy = motion.energy_reduced().expect("a dimensionless top");
    let (p, q, r) = (
        -(2.0 * energy + 2.0 * c + a) / (2.0 * c),
        (2.0 * a * b - 2.0 * c) / (2.0 * c),
        (2.0 * energy + 2.0 * c - a * b * b) / (2.0 * c),
    );
    let shift = -p / 3.0;
    let linear = q - p * p / 3.0;
    let constant = 2.0 * p * p * p / 27.0 - p * q / 3.0 + r;
    let size = (-linear / 3.0).sqrt();
    let angle = acos((-constant / (2.0 * size * size * size)).clamp(-1.0, 1.0)) / 3.0;
    let third = core::f64::consts::TAU / 3.0;
    let mut roots = [0.0, 1.0, 2.0].map(|k| shift + 2.0 * size * cos(angle - k * third));
    roots.sort_by(f64::total_cmp);
    acos(roots[1])
}

/// theta by the classical Runge-Kutta method on the notes' equation (4).
fn theta_by_steps(case: &Case, motion: &HeavyTop, t: f64) -> f64 {
    let (a, b, c) = (input(case, "a"), input(case, "b"), input(case, "c"));
    let acceleration = |theta: f64| {
        let (s, u) = (sin(theta), cos(theta));
        c * s - a * (b - u) * (1.0 - b * u) / (s * s * s)
    };
    let steps = (2000.0 * t / motion.nutation_period()).ceil();
    let h = t / steps;
    let (mut theta, mut rate) = (input(case, "theta0"), input(case, "dtheta0"));
    for _ in 0..steps as usize {
        let k1 = (rate, acceleration(theta));
        let k2 = (rate + 0.5 * h * k1.1, acceleration(theta + 0.5 * h * k1.0));
        let k3 = (rate + 0.5 * h * k2.1, acceleration(theta + 0.5 * h * k2.0));
        let k4 = (rate + h * k3.1, acceleration(theta + h * k3.0));
        theta += h / 6.0 * (k1.0 + 2.0 * k2.0 + 2.0 * k3.0 + k4.0);
        rate += h / 6.0 * (k1.1 + 2.0 * k2.1 + 2.0 * k3.1 + k4.1);
    }
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
