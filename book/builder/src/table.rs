//! Sections of the locked output as tables of a page.

use crate::text::{escape, number_html, raised, unit_html};
use rotation_dynamics::report::Table;

/// Greek letters as reports spell them.
const GREEK: [(&str, char); 18] = [
    ("alpha", 'α'),
    ("beta", 'β'),
    ("gamma", 'γ'),
    ("delta", 'δ'),
    ("epsilon", 'ε'),
    ("zeta", 'ζ'),
    ("theta", 'θ'),
    ("kappa", 'κ'),
    ("lambda", 'λ'),
    ("mu", 'μ'),
    ("nu", 'ν'),
    ("rho", 'ρ'),
    ("sigma", 'σ'),
    ("tau", 'τ'),
    ("phi", 'φ'),
    ("omega", 'ω'),
    ("pi", 'π'),
    ("Omega", 'Ω'),
];

/// The most characters of a cell that is not broken: "height_ratio_release".
const LONGEST_SHORT: usize = 20;

/// The text of all cells, for the search index.
pub fn plain(table: &Table) -> String {
    let rows: Vec<String> = table.rows().iter().map(|row| row.join(" ")).collect();
    format!("{} {}", table.columns().join(" "), rows.join(" "))
}

/// A cell of words: arrows, numbers, roots, Greek letters, indices, primes and powers are set as
/// such.
fn words(cell: &str) -> String {
    let cell = cell
        .replace("->", "→")
        .replace("<=", "≤")
        .replace(">=", "≥")
        .replace(" x ", " × ");
    raised(&pieces(&cell))
}

/// [`words`] but for the powers.
fn pieces(cell: &str) -> String {
    let mut html = String::new();
    let mut before = ' ';
    let mut rest = cell;
    while let Some(c) = rest.chars().next() {
        let (done, after) = if c.is_ascii_digit() {
            let (number, after) = rest.split_at(number_end(rest));
            (number_html(number).unwrap_or(number.into()), after)
        } else if c.is_ascii_alphabetic() {
            name(rest)
        } else {
            let after = &rest[c.len_utf8()..];
            let opens = matches!(before, ' ' | '(' | '=' | '/');
            let prime = before.is_alphanumeric() || matches!(before, '\'' | ')');
            let done = match c {
                '-' if opens => "\u{2212}".into(),
                '\'' if prime => "\u{2032}".into(),
                c => escape(&c.to_string()),
            };
            (done, after)
        };
        before = rest[..rest.len() - after.len()]
            .chars()
            .next_back()
            .unwrap_or(' ');
        html += &done;
        rest = after;
    }
    html
}

/// Where the number ends with which `text` begins: `0.25`, `1e-6`; not the `e` of `2 e`.
fn number_end(text: &str) -> usize {
    let digits = |from: usize| {
        let tail = &text[from..];
        from + tail.len() - tail.trim_start_matches(|c: char| c.is_ascii_digit()).len()
    };
    let mut end = digits(0);
    if text[end..].starts_with('.') && digits(end + 1) > end + 1 {
        end = digits(end + 1);
    }
    if let Some(exponent) = text[end..].strip_prefix('e') {
        let from = end + 1 + usize::from(exponent.starts_with('-'));
        if digits(from) > from {
            end = digits(from);
        }
    }
    end
}

/// The word with which `text` begins, set, and what follows it: `t_release` and `theta0` are
/// letters with an index, `dphi` a differential, `sqrt(a)` and `sqrt 6` roots, `E~` has a tilde.
fn name(text: &str) -> (String, &str) {
    let end = text
        .find(|c: char| !c.is_ascii_alphabetic())
        .unwrap_or(text.len());
    let (word, after) = text.split_at(end);
    if word == "sqrt" {
        if let Some((inside, after)) = after.strip_prefix('(').and_then(|t| t.split_once(')'))
            && inside.chars().all(|c| c.is_ascii_alphanumeric())
        {
            return (format!("√{}", pieces(inside)), after);
        }
        return ("√".into(), after.strip_prefix(' ').unwrap_or(after));
    }
    let greek = |word: &str| {
        let letter = GREEK.iter().find(|(name, _)| *name == word);
        letter.map(|(_, letter)| letter.to_string())
    };
    let differential = || Some(format!("d{}", greek(word.strip_prefix('d')?)?));
    let letter = greek(word).or_else(differential);
    let is_letter = letter.is_some() || word.len() == 1;
    let base = letter.unwrap_or(word.into());
    if !is_letter {
        return (base, after);
    }
    if let Some(after) = after.strip_prefix('~') {
        return (format!("{base}\u{303}"), after);
    }
    let index = after.strip_prefix('_').unwrap_or(after);
    let end = match index.len() < after.len() {
        true => index.find(|c: char| !c.is_ascii_alphanumeric()),
        false => index.find(|c: char| !c.is_ascii_digit()),
    };
    match index.split_at(end.unwrap_or(index.len())) {
        ("", _) => (base, after),
        (index, after) => (format!("{base}<sub>{index}</sub>"), after),
    }
}

/// The table as HTML.
pub fn html(table: &Table) -> String {
    html_with(table, |_, _| false)
}

/// The table as HTML; the cells for which `strong` holds, by row and column, stand out.
pub fn html_with(table: &Table, strong: impl Fn(usize, usize) -> bool) -> String {
    let name = table.heading().trim_start_matches("table ");
    let mut html = format!("<table class=\"section {}\"><thead><tr>", escape(name));
    // A column is numeric if most of its cells are; one without content is left out.
    let column = |n: usize| table.rows().iter().map(move |row| row[n].as_str());
    let numeric: Vec<bool> = (0..table.columns().len())
        .map(|n| {
            2 * column(n).filter(|cell| number_html(cell).is_some()).count() > table.rows().len()
        })
        .collect();
    let shown = |n: &usize| column(*n).any(|cell| cell != "-");
    // One of short words stays on one line.
    let short = |n: usize| column(n).all(|cell| cell.len() <= LONGEST_SHORT);
    let class = |n: usize| match numeric[n] {
        true => " class=\"n\"",
        false if short(n) => " class=\"short\"",
        false => "",
    };
    for n in (0..numeric.len()).filter(shown) {
        html += &format!("<th{}>{}</th>", class(n), words(&table.columns()[n]));
    }
    html += "</tr></thead><tbody>";
    for (line, row) in table.rows().iter().enumerate() {
        html += "<tr>";
        for n in (0..numeric.len()).filter(shown) {
            let cell = &row[n];
            let column = table.columns()[n].as_str();
            let content = match (cell.as_str(), column) {
                ("-", _) => "–".into(),
                (cell, "key" | "flag") => format!("<code>{}</code>", escape(cell)),
                (cell, "unit") => unit_html(cell),
                (cell, _) => number_html(cell)
                    .or_else(|| quantity(cell))
                    .unwrap_or_else(|| words(cell)),
            };
            let content = match strong(line, n) {
                true => format!("<strong>{content}</strong>"),
                false => content,
            };
            html += &format!("<td{}>{content}</td>", class(n));
        }
        html += "</tr>";
    }
    html + "</tbody></table>"
}

/// A number with its unit, or with what it counts: `1.2e-5 rad`, `0.031 of t_floor`. The first
/// word stays with the number.
fn quantity(cell: &str) -> Option<String> {
    let (number, unit) = cell.split_once(' ')?;
    Some(format!("{}\u{202f}{}", number_html(number)?, words(unit)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_a_column_of_long_words_is_broken() {
        let locked = "Sample\n\nlimits\nlimit                  gives  here\n\
                      a limit of many words  0.5    left out\n";
        let tables = rotation_dynamics::report::parse(locked)
            .expect("it is a table")
            .tables;
        let html = html(&tables[0]);
        assert!(html.contains("<td>a limit of many words</td>"), "{html}");
        assert!(html.contains("<td class=\"short\">left out</td>"), "{html}");
        assert!(html.contains("<td class=\"n\">0.5</td>"), "{html}");
    }

    #[test]
    fn cells_are_set_like_formulas() {
        assert_eq!(words("t_release/s"), "t<sub>release</sub>/s");
        assert_eq!(
            words("theta0 -> 0, a < b^2"),
            "θ<sub>0</sub> → 0, a &lt; b<sup>2</sup>"
        );
        assert_eq!(
            quantity("1.2e-5 rad").as_deref(),
            Some("1.2\u{202f}×\u{202f}10<sup>\u{2212}5</sup>\u{202f}rad")
        );
        assert_eq!(
            quantity("0.031 of t_floor").as_deref(),
            Some("0.031\u{202f}of t<sub>floor</sub>")
        );
        let cases = [
            (
                "level at 1e4 rad/s: m g l/L_z",
                "level at 10<sup>4</sup> rad/s: m g l/L<sub>z</sub>",
            ),
            (
                "c/a = 1e-6: over c/sqrt(a)",
                "c/a = 10<sup>\u{2212}6</sup>: over c/√a",
            ),
            ("ln(8/(sqrt 6 + sqrt 5))", "ln(8/(√6 + √5))"),
            (
                "dphi/dt' at E~ - U_eff",
                "dφ/dt′ at E\u{303} \u{2212} U<sub>eff</sub>",
            ),
            ("b to -b, one-sided, U''", "b to \u{2212}b, one-sided, U′′"),
            (
                "torque x turn / 3.5 I1",
                "torque × turn / 3.5 I<sub>1</sub>",
            ),
            (
                "sqrt(1 - m), DOP853, SRKN 14a",
                "√(1 \u{2212} m), DOP853, SRKN 14a",
            ),
            ("at the end 2. Then", "at the end 2. Then"),
        ];
        for (cell, html) in cases {
            assert_eq!(words(cell), html, "{cell}");
        }
    }
}
