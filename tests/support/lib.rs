//! Errors as the tests judge them: a NaN is kept, cases are counted, and what is
//! written down is what is measured.
//!
//! Bits are equal on every machine, so an error has one value. A test says it to a few digits,
//! and fails when the error grows and when it shrinks:
//!
//! ```ignore
//! assert_error!(got, want, 3.1 eps); // one value: |got - want|/|want|, as printed
//! assert_error!(defect, 2.4e-17); // one error, however it was measured
//!
//! let mut errors = Errors::in_units_of(EPS, "length of a turned vector");
//! for case in cases {
//!     errors.add(got, want, scale); // |got - want|/scale
//! }
//! assert_largest!(errors, 3000, @"4.16"); // the largest of 3000 errors
//! ```
//!
//! The last of these numbers is an inline snapshot: `cargo insta` writes it when it has changed.
//! `assert_table!` asserts many such errors, a row each.
//!
//! Damaged twins of all of this are in `tests/teeth/errors.rs`.

mod collected;
mod locked;
mod random;
mod single;

pub use collected::{Errors, beside_twins, table_is};
pub use locked::three_digits;
pub use random::Random;
pub use single::attained;

/// The unit round-off, 2^-53.
pub const EPS: f64 = 0.5 * f64::EPSILON;

/// |got - want|/scale, where no difference is no error whatever the scale.
///
/// NaN if anything is NaN, if the scale is negative or infinite, or if both values
/// are the same infinity: no such comparison says anything.
pub fn relative(got: f64, want: f64, scale: f64) -> f64 {
    let difference = (got - want).abs();
    if !(0.0..f64::INFINITY).contains(&scale) {
        f64::NAN
    } else if difference == 0.0 {
        0.0
    } else {
        difference / scale
    }
}

/// The derivative of `f` at `t` by four values, `h` and 2 `h` to either side; off by h^4/30 of
/// the fifth.
pub fn derivative(f: impl Fn(f64) -> f64, t: f64, h: f64) -> f64 {
    (8.0 * (f(t + h) - f(t - h)) - (f(t + 2.0 * h) - f(t - 2.0 * h))) / (12.0 * h)
}

/// The second derivative of `f` at `t`, component by component, by five values `h` apart;
/// off by about h^4/90 of the sixth.
pub fn second_derivative<const N: usize>(f: impl Fn(f64) -> [f64; N], t: f64, h: f64) -> [f64; N] {
    let [a, b, c, d, e] = [-2.0, -1.0, 0.0, 1.0, 2.0].map(|k: f64| f(t + k * h));
    let over = |i: usize| 16.0 * (b[i] + d[i]) - 30.0 * c[i] - (a[i] + e[i]);
    core::array::from_fn(|i| over(i) / (12.0 * h * h))
}
