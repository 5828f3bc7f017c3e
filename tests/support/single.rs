//! One error, asserted to the digits that are written down.

/// Asserts one error: `assert_error!(got, want, 3.1 eps)` for |got - want|/|want|, or
/// `assert_error!(error, 2.4e-17)` for an error that is measured already.
///
/// The error must be the number to its last printed digit. Without `eps` the unit is 1.
#[macro_export]
macro_rules! assert_error {
    ($error:expr, $printed:literal eps) => {
        $crate::attained($error / $crate::EPS, stringify!($printed), stringify!($error in eps))
    };
    ($error:expr, $printed:literal) => {
        $crate::attained($error, stringify!($printed), stringify!($error))
    };
    ($got:expr, $want:expr, $printed:literal eps) => {{
        let (got, want): (f64, f64) = ($got, $want);
        let error = $crate::relative(got, want, want.abs()) / $crate::EPS;
        $crate::attained(error, stringify!($printed), stringify!($got in eps))
    }};
    ($got:expr, $want:expr, $printed:literal) => {{
        let (got, want): (f64, f64) = ($got, $want);
        let error = $crate::relative(got, want, want.abs());
        $crate::attained(error, stringify!($printed), stringify!($got))
    }};
}

/// Asserts that an error's size is `printed`, to half a unit of its last digit.
#[track_caller]
pub fn attained(error: f64, printed: &str, what: &str) {
    let value: f64 = printed.parse().expect("a number as it is printed");
    let error = error.abs();
    // A hair more than a half, for a value that lies on the edge in decimal.
    let allowed = 0.500001 * last_digit(printed);
    assert!(
        (error - value).abs() <= allowed,
        "{what}: {error:.4e} is measured, {printed} is written down"
    );
}

/// The unit of the last printed digit: 0.1 for `3.0`, 1e-18 for `2.4e-17`.
fn last_digit(printed: &str) -> f64 {
    let (mantissa, exponent) = printed.split_once(['e', 'E']).unwrap_or((printed, "0"));
    let decimals = mantissa.split_once('.').map_or(0, |(_, d)| d.len());
    let exponent: i32 = exponent.parse().expect("an exponent");
    // An error of exactly 0 is written `0.0`, and is exactly 0.
    if mantissa.bytes().all(|b| matches!(b, b'0' | b'.')) {
        return 0.0;
    }
    let power = exponent - i32::try_from(decimals).expect("few digits");
    format!("1e{power}").parse().expect("a power of ten")
}
