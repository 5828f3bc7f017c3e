//! Double-double arithmetic against 80-digit values (tests/data/double_double.txt).

use rotation_dynamics::math::DoubleDouble;
use std::collections::BTreeMap;
use support::{Errors, assert_table};

/// The unit of the errors below: 2^-106.
const UNIT: f64 = 1.232_595_164_407_831e-32;

/// The largest errors of each operation, in units of 2^-106 of the result.
fn errors(damage: f64) -> BTreeMap<String, Errors> {
    let mut errors: BTreeMap<String, Errors> = BTreeMap::new();
    for line in include_str!("../data/double_double.txt").lines().skip(1) {
        let mut columns = line.split(' ');
        let op = columns.next().expect("an operation");
        let numbers: Vec<f64> = columns.map(|c| c.parse().expect("a number")).collect();
        let [a, b, want] = [0, 2, 4].map(|i| DoubleDouble::sum(numbers[i], numbers[i + 1]));
        let a = a * (1.0 + damage);
        let got = match op {
            "exp" => a.exp(),
            "exp_m1" => a.exp_m1(),
            "ln" => (b * (1.0 + damage)).ln(),
            "ln_1p" => a.ln_1p(),
            "sin" => a.sin(),
            "cos" => a.cos(),
            "sinh" => a.sinh_cosh().0,
            "atan2" => a.atan2(b),
            "sqrt" => (b * (1.0 + damage)).sqrt(),
            "add" => a + b,
            "mul" => a * b,
            "div" => a / b,
            other => panic!("unknown operation {other}"),
        };
        let error = ((got - want) / want).abs().to_f64();
        // The condition of the argument's own last bit: |x f'/f| for the periodic ones.
        let condition = match op {
            "sin" | "cos" => 1.0 + (1.0 / want.to_f64()).abs(),
            _ => 1.0,
        };
        let of_this = errors.entry(op.to_owned());
        of_this.or_insert_with(|| Errors::in_units_of(UNIT, op)).push_at(error / condition, line);
    }
    errors
}

#[test]
fn every_operation_keeps_106_bits() {
    assert_table!(errors(0.0).values(), @"
    add: 0.976 of 33
    atan2: 0.657 of 33
    cos: 0.181 of 34
    div: 0.997 of 33
    exp: 0.612 of 34
    exp_m1: 1.82 of 33
    ln: 6.57 of 34
    ln_1p: 1.98 of 33
    mul: 0.810 of 33
    sin: 0.260 of 34
    sinh: 2.99 of 33
    sqrt: 0.994 of 33
    ");
}

#[test]
fn a_relative_change_of_1e_14_is_seen_by_every_operation() {
    let errors = errors(1e-14);
    for (op, errors) in &errors {
        assert!(errors.largest() > 1e10, "{op}");
    }
    assert_eq!(errors.len(), 12);
}

#[test]
fn ties_round_by_their_low_part() {
    let tie = DoubleDouble::from_parts(2.5, -1e-20);
    assert_eq!(tie.round(), 2.0);
    assert_eq!(DoubleDouble::from_parts(2.5, 1e-20).round(), 3.0);
    assert_eq!(DoubleDouble::from_parts(-7.0, 1e-17).round(), -7.0);
}
