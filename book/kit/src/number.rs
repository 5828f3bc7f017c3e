//! How a number is written: only the digits its error bound supports.
//!
//! Everything here works on Rust's exact decimal conversion of an `f64`, so no
//! logarithm is rounded and a power of ten falls on the right side.

/// Significant digits are never more than this: what an `f64` always holds.
const MOST_DIGITS: i32 = 15;

/// The decimal exponent of a finite number other than 0, `10^e <= |x| < 10^(e+1)`,
/// and whether `|x|` is exactly (as printed) the power of ten.
fn exponent(x: f64) -> (i32, bool) {
    let text = format!("{:e}", x.abs());
    let (mantissa, e) = text.split_once('e').unwrap_or((&text, "0"));
    (e.parse().unwrap_or(0), mantissa == "1")
}

/// `value` with the digits that `bound` supports: the last one printed is worth
/// at least `bound`, and there are at most 15. A value below its own bound is `0`.
///
/// ```
/// use kit::supported_digits;
/// assert_eq!(supported_digits(0.863_154_127_6, 2e-6), "0.86315");
/// assert_eq!(supported_digits(123.456, 10.0), "120");
/// assert_eq!(supported_digits(1.0 / 3.0, 0.0), "0.333333333333333");
/// assert_eq!(supported_digits(3e-17, 1e-15), "0");
/// ```
pub fn supported_digits(value: f64, bound: f64) -> String {
    if value == 0.0 || !value.is_finite() {
        return if value == 0.0 { "0".into() } else { value.to_string() };
    }
    let (top, _) = exponent(value);
    let mut last = top - (MOST_DIGITS - 1);
    if bound > 0.0 {
        let (e, power) = exponent(bound);
        last = last.max(if power { e } else { e + 1 });
    }
    if last > top {
        return "0".into();
    }
    rounded(value, top, last)
}

/// `value` with `digits` significant digits.
///
/// ```
/// use kit::short;
/// assert_eq!(short(0.012_34, 2), "0.012");
/// assert_eq!(short(6.02e23, 2), "6.0e23");
/// ```
pub fn short(value: f64, digits: u32) -> String {
    if value == 0.0 || !value.is_finite() {
        return supported_digits(value, 0.0);
    }
    let (top, _) = exponent(value);
    rounded(value, top, top - (digits.clamp(1, 15) as i32 - 1))
}

/// `value` with as many digits as it takes to read the same bits back.
pub fn exactly(value: f64) -> String {
    if value == 0.0 || (1e-4..1e7).contains(&value.abs()) {
        value.to_string()
    } else {
        format!("{value:e}")
    }
}

/// `value` with so many decimals: after an exponent where it is large, or where they would show
/// nothing of it.
pub fn decimals(value: f64, places: usize) -> String {
    let plain = format!("{value:.places$}");
    let seen = value == 0.0 || plain.parse::<f64>() != Ok(0.0);
    if seen && value.abs() < 1e15 { plain } else { format!("{value:.places$e}") }
}

/// A text without the minus of numbers that were rounded to nought.
pub(crate) fn without_minus_nought(text: &str) -> String {
    let plain = |word: &str| {
        let positive = word.strip_prefix('-').filter(|rest| {
            let digits = rest.trim_end_matches(['.', ',', ';', ':', ')']);
            digits.starts_with('0') && digits.parse() == Ok(0.0)
        });
        positive.unwrap_or(word).to_owned()
    };
    text.split(' ').map(plain).collect::<Vec<_>>().join(" ")
}

/// `value`, of decimal exponent `top`, rounded to a multiple of `10^last`, `last <= top`.
fn rounded(value: f64, top: i32, last: i32) -> String {
    let scientific = |x: f64, digits: i32| format!("{x:.*e}", digits.max(0) as usize);
    let mut text = scientific(value, top - last);
    let mut top = top;
    // Rounding up to the next power of ten gains a digit: 9.996 to two decimals is 10.00.
    let grown = text.split_once('e').and_then(|(_, e)| e.parse().ok()) == Some(top + 1);
    if let (true, Ok(power)) = (grown, text.parse()) {
        top += 1;
        text = scientific(power, top - last);
    }
    if (-4..7).contains(&top) && last <= 0 {
        format!("{:.*}", (-last) as usize, value)
    } else if (0..7).contains(&top) {
        // Zeros stand for the digits that are not known.
        let unit = 10_i64.pow(last as u32);
        let digits: String =
            text.split('e').next().unwrap_or("").chars().filter(|c| *c != '.').collect();
        digits.parse::<i64>().map_or(text, |d| (d * unit).to_string())
    } else {
        text
    }
}

/// `x >= 0` rounded up to one significant digit: how bounds and errors are printed.
///
/// ```
/// use kit::rounded_up;
/// assert_eq!(rounded_up(2.1e-13), "3e-13");
/// assert_eq!(rounded_up(9.5e-13), "1e-12");
/// assert_eq!(rounded_up(0.0), "0");
/// ```
pub fn rounded_up(x: f64) -> String {
    if x == 0.0 || !x.is_finite() {
        return supported_digits(x, 0.0);
    }
    let text = format!("{:e}", x.abs());
    let (mantissa, e) = text.split_once('e').unwrap_or((&text, "0"));
    let lead: u32 = mantissa[..1].parse().unwrap_or(9);
    let up = lead + u32::from(mantissa.len() > 1);
    let e: i32 = e.parse().unwrap_or(0);
    if up == 10 { format!("1e{}", e + 1) } else { format!("{up}e{e}") }
}

/// How far `text`, which is `value` printed, reads from it.
pub(super) fn taken_away(value: f64, text: &str) -> f64 {
    // What is printed reads back; a NaN would be seen in the sum.
    (text.parse().unwrap_or(f64::NAN) - value).abs()
}

/// `< 10^k` for the smallest such `k`, without a space: a difference at the level
/// of round-off must not be locked digit for digit. `floor` is the smallest
/// difference worth telling apart (0 if every one is).
///
/// ```
/// use kit::below;
/// assert_eq!(below(3.2e-16, 0.0), "<1e-15");
/// assert_eq!(below(0.0, 2e-16), "<1e-15");
/// assert_eq!(below(0.0, 0.0), "0");
/// ```
pub fn below(difference: f64, floor: f64) -> String {
    let d = difference.abs().max(floor);
    if d == 0.0 { "0".into() } else { format!("<1e{}", exponent(d).0 + 1) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rotation_dynamics::math::{EPS, pow, sin};

    /// What the last digit of a printed number is worth, read off the text alone;
    /// trailing zeros of a whole number do not count.
    fn worth_of_last_digit(text: &str) -> f64 {
        let (mantissa, e) = text.split_once('e').unwrap_or((text, "0"));
        let decimals = match mantissa.split_once('.') {
            Some((_, decimals)) => -(decimals.len() as i32),
            None => (mantissa.len() - mantissa.trim_end_matches('0').len()) as i32,
        };
        pow(10.0, f64::from(decimals + e.parse::<i32>().expect("an exponent")))
    }

    #[test]
    fn a_number_rounded_to_nought_has_no_minus() {
        let told = format!("{:.2} rad, {:.0}, -0.01, x-0", -0.001, -0.2);
        assert_eq!(without_minus_nought(&told), "0.00 rad, 0, -0.01, x-0");
    }

    /// Values and bounds over 40 decades: the printed number is a rounding of the
    /// value (up to the reading back), and its last digit is worth the bound or up to
    /// ten times as much.
    #[test]
    fn printed_digits_are_those_the_bound_supports() {
        let (mut printed, mut zeros) = (0, 0);
        for i in 0..4000 {
            let x = f64::from(i);
            let value = pow(10.0, 20.0 * sin(1.7 * x)) * if i % 2 == 0 { 1.0 } else { -1.0 };
            let bound = value.abs() * pow(10.0, -8.0 + 9.0 * sin(0.3 * x + 1.0));
            let text = supported_digits(value, bound);
            let back: f64 = text.parse().expect("it reads back");
            if back == 0.0 {
                // Only what is not ten times its bound can vanish.
                assert!(value.abs() < 10.0 * bound, "{value:e} {bound:e}");
                zeros += 1;
                continue;
            }
            let worth = worth_of_last_digit(&text);
            let slack = 1.0 + 1e-12;
            assert!(
                (back - value).abs() <= 0.5 * worth * slack + EPS * value.abs(),
                "{value:e} {bound:e}: {text}"
            );
            // A whole number may end in zeros that count: 1200 to the nearest 10.
            let whole = !text.contains(['.', 'e']);
            // Fifteen digits may be all there are, though the bound supports more.
            let fine = bound < 1e-14 * value.abs();
            assert!(bound <= worth * slack, "{value:e} {bound:e}: {text}");
            assert!(whole || fine || worth < 10.0 * bound * slack, "{value:e} {bound:e}: {text}");
            printed += 1;
        }
        assert_eq!((printed + zeros, zeros > 50), (4000, true));
    }

    #[test]
    fn rounding_that_gains_a_digit_keeps_its_place() {
        for (value, bound, text) in [
            (9.996, 0.01, "10.00"),
            (9.996, 0.001, "9.996"),
            (-9.996, 0.01, "-10.00"),
            (0.099_96, 1e-4, "0.1000"),
            (9_999_996.0, 10.0, "1.000000e7"),
            (1e-5, 1e-7, "1.00e-5"),
            (1234.0, 1.0, "1234"),
            (1234.0, 2.0, "1230"),
            (1234.0, 1000.0, "1000"),
            (1234.0, 1001.0, "0"),
            (0.25, 0.0, "0.250000000000000"),
        ] {
            assert_eq!(supported_digits(value, bound), text, "{value} {bound}");
        }
    }

    #[test]
    fn bounds_are_rounded_up_never_down() {
        let mut count = 0;
        for i in 1..2000 {
            let x = pow(10.0, 30.0 * sin(f64::from(i)));
            let up: f64 = rounded_up(x).parse().expect("it reads back");
            // The slack is for 3e-13, which as an f64 may lie below the x it came from.
            assert!(up >= x * (1.0 - 1e-15) && up < 2.0 * x * (1.0 + 1e-15), "{x:e} {up:e}");
            let power: f64 = below(x, 0.0)[1..].parse().expect("it reads back");
            assert!(
                power > x * (1.0 - 1e-15) && power <= 10.0 * x * (1.0 + 1e-15),
                "{x:e} {power:e}"
            );
            count += 1;
        }
        assert_eq!(count, 1999);
    }

    #[test]
    fn decimals_do_not_run_on_nor_hide_a_number() {
        for (value, text) in [
            (1.2, "1.200000"),
            (-0.08, "-0.080000"),
            (0.0, "0.000000"),
            (1e-6, "0.000001"),
            (1e-7, "1.000000e-7"),
            (-2.5e-30, "-2.500000e-30"),
            (123_456_789.25, "123456789.250000"),
            (1e30, "1.000000e30"),
            (f64::INFINITY, "inf"),
        ] {
            assert_eq!(decimals(value, 6), text, "{value:e}");
        }
        // The twin writes 31 digits.
        assert_eq!(format!("{:.6}", 1e30).len(), 38);
    }

    #[test]
    fn exact_numbers_read_back_to_the_same_bits() {
        for x in [0.0, 3.0, 0.1, 9.80665, 1e-12, -2.5e17, 1.0 / 3.0] {
            assert_eq!(exactly(x).parse::<f64>(), Ok(x));
        }
        assert_eq!(exactly(1e-12), "1e-12");
        assert_eq!(exactly(3.0), "3");
    }
}
