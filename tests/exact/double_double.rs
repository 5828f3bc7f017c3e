//! Double-double arithmetic against 80-digit values (tests/data/double_double.txt).

use rotation_dynamics::math::DoubleDouble;
use std::collections::BTreeMap;

/// The unit of the errors below: 2^-106.
const UNIT: f64 = 1.232_595_164_407_831e-32;

/// (operation, largest error allowed in units of 2^-106 of the result; just above the measured one)
const BOUNDS: [(&str, f64); 12] = [
    ("add", 1.00),    // measured 0.98
    ("mul", 0.83),    // measured 0.81
    ("div", 1.02),    // measured 1.00
    ("sqrt", 1.01),   // measured 0.99
    ("exp", 0.85),    // measured 0.83
    ("exp_m1", 3.94), // measured 3.92
    ("ln", 6.59),     // measured 6.57
    ("ln_1p", 4.78),  // measured 4.76
    ("sin", 0.28),    // measured 0.26
    ("cos", 0.20),    // measured 0.18
    ("sinh", 4.00),   // measured 3.98
    ("atan2", 0.68),  // measured 0.66
];

fn largest_errors(damage: f64) -> BTreeMap<String, (f64, usize)> {
    let mut worst: BTreeMap<String, (f64, usize)> = BTreeMap::new();
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
        let error = ((got - want) / want).abs().to_f64() / UNIT;
        // The condition of the argument's own last bit: |x f'/f| for the periodic ones.
        let condition = match op {
            "sin" | "cos" => 1.0 + (1.0 / want.to_f64()).abs(),
            _ => 1.0,
        };
        let entry = worst.entry(op.to_string()).or_default();
        assert!(error.is_finite(), "{line}");
        entry.0 = entry.0.max(error / condition);
        entry.1 += 1;
    }
    worst
}

#[test]
fn every_operation_keeps_106_bits() {
    let worst = largest_errors(0.0);
    for (op, bound) in BOUNDS {
        let (error, count) = worst[op];
        println!("{op:8} {count:4} rows, largest error {error:.2}");
        assert!(count >= 30, "{op}: only {count} rows");
        assert!(error <= bound, "{op}: {error} > {bound}");
    }
    assert_eq!(worst.len(), BOUNDS.len());
}

#[test]
fn a_relative_change_of_1e_14_is_seen_by_every_operation() {
    for (op, (error, _)) in largest_errors(1e-14) {
        assert!(error > 1e10, "{op}: {error}");
    }
}

#[test]
fn ties_round_by_their_low_part() {
    let tie = DoubleDouble::from_parts(2.5, -1e-20);
    assert_eq!(tie.round(), 2.0);
    assert_eq!(DoubleDouble::from_parts(2.5, 1e-20).round(), 3.0);
    assert_eq!(DoubleDouble::from_parts(-7.0, 1e-17).round(), -7.0);
}
