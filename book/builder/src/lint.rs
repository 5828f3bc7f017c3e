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
    fn results_are_told_from_section_numbers() {
        let prose = "Section 16.2, ex. 16.6\nU = 0.404 and -3.14159, a = 1.2, eq. 15.5.11\nv1.251.";
        assert_eq!(
            bare_numbers(prose),
            [(1, "0.404".into()), (1, "3.14159".into())]
        );
    }
}
