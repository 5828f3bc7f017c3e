//! Sine and cosine in turns against double-double values.

use rotation_dynamics::math::{DoubleDouble, EPS, round_even, sincos_turns};

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

/// The largest relative errors of sine and cosine, in eps.
fn largest(damage: f64) -> (f64, f64) {
    arguments().fold((0.0, 0.0), |(sin_most, cos_most), t| {
        let whole = t.round();
        let angle = DoubleDouble::TWO_PI * DoubleDouble::sum(t, -whole);
        let (sin, cos) = angle.sin_cos();
        let (s, c) = sincos_turns(t * (1.0 + damage));
        let off = |got: f64, want: DoubleDouble| {
            if want == 0.0 {
                got.abs()
            } else {
                ((want - got) / want).abs().to_f64() / EPS
            }
        };
        (
            f64::max(sin_most, off(s, sin)),
            f64::max(cos_most, off(c, cos)),
        )
    })
}

#[test]
fn sine_and_cosine_to_their_last_bit() {
    let (sin, cos) = largest(0.0);
    println!("sine {sin:.3} eps, cosine {cos:.3} eps");
    assert!(sin <= 1.64 && cos <= 1.63); // measured 1.634, 1.624
    let (sin, cos) = largest(1e-14);
    assert!(sin > 50.0 && cos > 50.0);
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
    assert_eq!(
        [-2.5, -0.5, 0.5, 1.5, 2.5].map(round_even),
        [-2.0, 0.0, 0.0, 2.0, 2.0]
    );
}
