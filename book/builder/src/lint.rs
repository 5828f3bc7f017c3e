//! Typed results: numbers in prose that no run has produced.

/// The decimals with three or more significant digits in `prose`, with their lines from 0.
///
/// The notes' own section and exercise numbers (15.5, 16.2.4) are no results, nor are
/// versions and addresses.
pub fn bare_numbers(prose: &str) -> Vec<(usize, String)> {
    let mut found = Vec::new();
    for (line, text) in prose.lines().enumerate() {
        let bytes = text.as_bytes();
        let mut at = 0;
        while at < bytes.len() {
            if !bytes[at].is_ascii_digit() {
                at += 1;
                continue;
            }
            let start = at;
            while at < bytes.len() && (bytes[at].is_ascii_digit() || bytes[at] == b'.') {
                at += 1;
            }
            let number = text[start..at].trim_end_matches('.');
            let part_of_word = start > 0
                && (bytes[start - 1].is_ascii_alphabetic() || b"_/#&-".contains(&bytes[start - 1]))
                && bytes[start - 1] != b'-';
            if is_result(number) && !part_of_word {
                found.push((line, number.to_owned()));
            }
        }
    }
    found
}

/// The first slanted differential in a formula: a letter d on its own in front of a letter, a
/// command or a power, where a fraction, a stroke or a space that keeps terms apart begins it.
pub fn slanted_differential(tex: &str) -> Option<&str> {
    const BEGIN: [&str; 11] =
        ["\\frac{", "\\tfrac{", "\\dfrac{", "}{", "/", "\\,", "\\;", "(", "-", "+", "="];
    tex.match_indices('d').find_map(|(at, _)| {
        let (before, after) = (&tex[..at], &tex[at + 1..]);
        let begins = at == 0 || BEGIN.iter().any(|begin| before.trim_end().ends_with(begin));
        let letter = after.starts_with(|c: char| c.is_ascii_alphabetic());
        let of_word =
            after.len() > 1 && letter && after[1..].starts_with(|c: char| c.is_ascii_alphabetic());
        let of = letter && !of_word || after.starts_with('\\') || after.starts_with("^2\\");
        let end = tex[at..].char_indices().nth(8).map_or(tex.len(), |(n, _)| at + n);
        (begins && of).then(|| &tex[at..end])
    })
}

fn is_result(number: &str) -> bool {
    let mut parts = number.split('.');
    let (Some(whole), Some(fraction), None) = (parts.next(), parts.next(), parts.next()) else {
        return false;
    };
    if matches!(whole, "15" | "16") && fraction.len() <= 2 {
        return false;
    }
    let digits = [whole, fraction].concat();
    digits.trim_start_matches('0').len() >= 3
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_differential_stands_upright() {
        let slanted = [
            (r"\frac{d\theta}{\mathrm{d}t'}", r"d\theta}"),
            (r"\frac{\mathrm{d}u}{dt'}", "dt'}"),
            (r"d\phi/\mathrm{d}t", r"d\phi/\m"),
            (r"p = \mathrm{d}u/dt'", "dt'"),
            (r"\int f\,du", "du"),
            (r"\frac{d}{dt} x", "dt} x"),
            (r"\frac{d^2\theta}{2}", r"d^2\thet"),
            (r"(d\theta)", r"d\theta)"),
            (r"f = -dU/\mathrm{d}x", r"dU/\math"),
        ];
        for (tex, found) in slanted {
            assert_eq!(slanted_differential(tex), Some(found), "{tex}");
        }
        // A distance, a modulus, and words.
        let upright = [
            r"\frac{\mathrm{d}\theta}{\mathrm{d}t} + d^2 - 2d",
            r"\frac{d}{2}",
            r"(d + 1)/d",
            r"\operatorname{dn}(u) + \text{a distance d}",
            r"x_{\mathrm{down}}",
            r"1 - d^2",
        ];
        for tex in upright {
            assert_eq!(slanted_differential(tex), None, "{tex}");
        }
    }

    #[test]
    fn results_are_told_from_section_numbers() {
        let prose = "Section 16.2, ex. 16.6\nU = 0.404 and -3.14159, a = 1.2, eq. 15.5.11\nv1.251.";
        assert_eq!(bare_numbers(prose), [(1, "0.404".into()), (1, "3.14159".into())]);
    }
}
