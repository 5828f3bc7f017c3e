//! Sine and cosine in turns against double-double values.

use rotation_dynamics::math::{DoubleDouble, EPS, round_even, sincos_turns};
use support::{Errors, assert_largest};

/// Deterministic arguments: small, near every eighth, large.
fn arguments() -> impl Iterator<Item = f64> {
    let mut seed = 0x9e37_79b9_7f4a_7c15_u64;
    (0..40_000).map(move |k| {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        let unit = (seed >> 11) as f64 / (1u64 << 53) as f64 - 0.5;
        match k % 4 {
            0 => 2.0 * unit,
            1 => f64::from(k % 17 - 8) / 8.0 + unit * 1e-9,
            2 => unit * 1e9,
            _ => unit * DoubleDouble::from(-unit.abs() * 600.0).exp().to_f64(),
        }
    })
}

/// The relative errors of sine and cosine.
fn errors(damage: f64) -> [Errors; 2] {
    let mut errors = ["sine", "cosine"].map(|name| Errors::in_units_of(EPS, name));
    for t in arguments() {
        let whole = t.round();
        let angle = DoubleDouble::TWO_PI * DoubleDouble::sum(t, -whole);
        let (sin, cos) = angle.sin_cos();
        let (s, c) = sincos_turns(t * (1.0 + damage));
        for (errors, (got, want)) in errors.iter_mut().zip([(s, sin), (c, cos)]) {
            errors.push_at(if want == 0.0 { got } else { ((want - got) / want).to_f64() }, t);
        }
    }
    errors
}

#[test]
fn sine_and_cosine_to_their_last_bit() {
    let [sin, cos] = errors(0.0);
    assert_largest!(sin, 40_000, @"1.63");
    assert_largest!(cos, 40_000, @"1.62");
    for damaged in errors(1e-14) {
        assert!(damaged.largest() > 50.0);
    }
}

#[test]
fn quarters_are_exact_and_rounding_is_to_even() {
    let mut seen = 0;
    for k in -40_i32..=40 {
        let (s, c) = sincos_turns(f64::from(k) / 4.0);
        let want = [(0.0, 1.0), (1.0, 0.0), (0.0, -1.0), (-1.0, 0.0)];
        assert_eq!((s, c), want[(k + 40) as usize % 4], "{k}");
        seen += 1;
    }
    assert_eq!(seen, 81);
    assert_eq!([-2.5, -0.5, 0.5, 1.5, 2.5].map(round_even), [-2.0, 0.0, 0.0, 2.0, 2.0]);
}
