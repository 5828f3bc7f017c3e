//! Numbers, units and plain text as HTML and as TeX.

use std::fmt::Write;

/// Text with the characters that HTML reserves replaced.
pub fn escape(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '"' => escaped.push_str("&quot;"),
            c => escaped.push(c),
        }
    }
    escaped
}

/// The digits and the exponent of a printed number, if it is one.
fn split_number(cell: &str) -> Option<(&str, Option<i32>)> {
    let number = cell.strip_prefix(['<', '-', '+']).unwrap_or(cell);
    let number = number.strip_prefix('-').unwrap_or(number);
    if !number.starts_with(|c: char| c.is_ascii_digit()) {
        return None;
    }
    number.parse::<f64>().ok()?;
    match cell.split_once(['e', 'E']) {
        None => Some((cell, None)),
        Some((digits, exponent)) => Some((digits, Some(exponent.parse().ok()?))),
    }
}

/// A printed number as HTML: a true minus sign, and powers of ten. `None` if `cell` is none.
pub fn number_html(cell: &str) -> Option<String> {
    let (digits, exponent) = split_number(cell)?;
    let mut html = escape(digits).replace('-', "\u{2212}");
    if html.starts_with("&lt;") {
        html.insert(4, '\u{2009}');
    }
    if let Some(exponent) = exponent {
        let sign = if exponent < 0 { "\u{2212}" } else { "" };
        let power = format!("10<sup>{sign}{}</sup>", exponent.abs());
        html = match html.strip_suffix('1') {
            // "1e-15" is a power of ten, not one times it.
            Some(sign) if !sign.ends_with(|c: char| c.is_ascii_digit() || c == '.') => {
                format!("{sign}{power}")
            }
            _ => format!("{html}\u{202f}\u{d7}\u{202f}{power}"),
        };
    }
    Some(html)
}

/// A printed number rounded to fewer significant digits. `None` if it has not so many, and if a 5
/// alone would be dropped: the number was rounded to it, which way is no longer known.
pub fn shortened(cell: &str, digits: usize) -> Option<String> {
    let (mantissa, exponent) = split_number(cell)?;
    let figures: String = mantissa.chars().filter(char::is_ascii_digit).collect();
    if digits == 0 || figures.trim_start_matches('0').len() < digits {
        return None;
    }
    let dropped = &figures.trim_start_matches('0')[digits..];
    if dropped.trim_end_matches('0') == "5" {
        return None;
    }
    let value: f64 = mantissa.parse().ok()?;
    let rounded = format!("{:.*e}", digits - 1, value);
    let (_, power) = rounded.split_once('e')?;
    let decimals = digits as i32 - 1 - power.parse::<i32>().ok()?;
    let short = format!("{value:.*}", usize::try_from(decimals).ok()?);
    Some(match exponent {
        None => short,
        Some(exponent) => format!("{short}e{exponent}"),
    })
}

/// A printed number as TeX.
pub fn number_tex(cell: &str) -> String {
    match split_number(cell) {
        Some(("1", Some(exponent))) => format!("{{10^{{{exponent}}}}}"),
        Some((digits, Some(exponent))) => format!("{{{digits}\\times 10^{{{exponent}}}}}"),
        _ => format!("{{{cell}}}"),
    }
}

/// An equation's number as it is shown: the notes' "16.2 (4)" as it stands, ours in brackets.
pub fn tag_html(tag: &str) -> String {
    match tag.contains('(') {
        true => escape(tag),
        false => format!("({})", escape(tag)),
    }
}

/// A unit as HTML: `m/s^2` with its exponent raised, in one piece. `1/s` becomes a power, as a 1
/// after a number reads like a digit of it.
pub fn unit_html(unit: &str) -> String {
    if let Some(unit) = unit.strip_prefix("1/")
        && unit.chars().all(char::is_alphabetic)
    {
        return unit_html(&format!("{unit}^-1"));
    }
    raised(&escape(unit)).replace(' ', "\u{202f}")
}

/// HTML with what follows each `^` raised: digits and a sign.
pub fn raised(html: &str) -> String {
    let mut pieces = html.split('^');
    let mut done = pieces.next().unwrap_or("").to_owned();
    for piece in pieces {
        let end = piece.find(|c: char| !(c.is_ascii_digit() || c == '-')).unwrap_or(piece.len());
        let exponent = piece[..end].replace('-', "\u{2212}");
        let _ = write!(done, "<sup>{exponent}</sup>{}", &piece[end..]);
    }
    done
}

/// The text of some HTML, without its tags.
pub fn without_tags(html: &str) -> String {
    let mut text = String::new();
    let mut inside = false;
    for c in html.chars() {
        match c {
            '<' => inside = true,
            '>' => inside = false,
            c if !inside => text.push(c),
            _ => {}
        }
    }
    unescape(&text)
}

/// The inverse of [`escape`], with numeric references as well.
pub fn unescape(text: &str) -> String {
    let mut plain = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(at) = rest.find('&') {
        plain.push_str(&rest[..at]);
        rest = &rest[at..];
        let end = rest.find(';').filter(|&end| end < 10);
        let c = end.and_then(|end| match &rest[1..end] {
            "amp" => Some('&'),
            "lt" => Some('<'),
            "gt" => Some('>'),
            "quot" => Some('"'),
            "apos" => Some('\''),
            "nbsp" => Some('\u{a0}'),
            name => {
                let number = name.strip_prefix('#')?;
                let code = match number.strip_prefix(['x', 'X']) {
                    Some(hex) => u32::from_str_radix(hex, 16).ok()?,
                    None => number.parse().ok()?,
                };
                char::from_u32(code)
            }
        });
        match (c, end) {
            (Some(c), Some(end)) => {
                plain.push(c);
                rest = &rest[end + 1..];
            }
            _ => {
                plain.push('&');
                rest = &rest[1..];
            }
        }
    }
    plain.push_str(rest);
    plain
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_shortened_by_rounding_and_never_lengthened() {
        let short = |cell, digits| shortened(cell, digits);
        assert_eq!(short("0.630629186649", 4).as_deref(), Some("0.6306"));
        assert_eq!(short("-2.3108429238573", 3).as_deref(), Some("-2.31"));
        assert_eq!(short("34.6472408054", 4).as_deref(), Some("34.65"));
        assert_eq!(short("9.99996", 4).as_deref(), Some("10.00"));
        assert_eq!(short("6.02e-7", 2).as_deref(), Some("6.0e-7"));
        // Not more digits than there are, nor zeros in the place of digits.
        assert_eq!(short("0.027", 3), None);
        assert_eq!(short("1430.5", 2), None);
        // 140.05 may have been 140.0475.
        assert_eq!(short("140.05", 4), None);
        assert_eq!(short("140.050", 4), None);
        assert_eq!(short("140.051", 4).as_deref(), Some("140.1"));
        assert_eq!(short("text", 2), None);
    }

    #[test]
    fn numbers_are_set_as_numbers() {
        let cases = [
            ("0.40426", "0.40426"),
            ("-0.08", "\u{2212}0.08"),
            ("1e-15", "10<sup>\u{2212}15</sup>"),
            ("<1e-15", "&lt;\u{2009}10<sup>\u{2212}15</sup>"),
            ("2.5e10", "2.5\u{202f}\u{d7}\u{202f}10<sup>10</sup>"),
            ("11e3", "11\u{202f}\u{d7}\u{202f}10<sup>3</sup>"),
        ];
        for (cell, html) in cases {
            assert_eq!(number_html(cell).as_deref(), Some(html), "{cell}");
        }
        assert_eq!(number_html("closed form"), None);
        assert_eq!(number_html("-"), None);
        assert_eq!(number_tex("2.5e-3"), r"{2.5\times 10^{-3}}");
        assert_eq!(number_tex("1e-3"), r"{10^{-3}}");
        assert_eq!(unit_html("m/s^2"), "m/s<sup>2</sup>");
        assert_eq!(unit_html("1/s"), "s<sup>\u{2212}1</sup>");
        assert_eq!(unescape("&#124;&amp;&x"), "|&&x");
    }
}
