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

/// The text of all cells, for the search index.
pub fn plain(table: &Table) -> String {
    let rows: Vec<String> = table.rows().iter().map(|row| row.join(" ")).collect();
    format!("{} {}", table.columns().join(" "), rows.join(" "))
}

/// A cell of words: arrows, Greek letters and powers are set as such.
fn words(cell: &str) -> String {
    let cell = cell
        .replace("->", "→")
        .replace("<=", "≤")
        .replace(">=", "≥");
    let mut html = String::new();
    let mut rest = cell.as_str();
    while let Some(c) = rest.chars().next() {
        if c.is_ascii_alphabetic() {
            let end = rest
                .find(|c: char| !c.is_ascii_alphabetic())
                .unwrap_or(rest.len());
            let (word, after) = rest.split_at(end);
            let letter = GREEK.iter().find(|(name, _)| *name == word);
            // `t_release` and `theta_0`: a letter with an index.
            if let Some(index) = after.strip_prefix('_')
                && (letter.is_some() || word.len() == 1)
            {
                let end = index
                    .find(|c: char| !c.is_ascii_alphanumeric())
                    .unwrap_or(index.len());
                let base = letter.map_or(word.to_owned(), |(_, letter)| letter.to_string());
                html += &format!("{base}<sub>{}</sub>", &index[..end]);
                rest = &index[end..];
                continue;
            }
            let digits = after.len() - after.trim_start_matches(|c: char| c.is_ascii_digit()).len();
            match letter {
                Some((_, letter)) => html.push(*letter),
                None => html.push_str(word),
            }
            if digits > 0 && (letter.is_some() || word.len() == 1) {
                html += &format!("<sub>{}</sub>", &after[..digits]);
            } else {
                html.push_str(&after[..digits]);
            }
            rest = &after[digits..];
        } else {
            html.push_str(&escape(&c.to_string()));
            rest = &rest[c.len_utf8()..];
        }
    }
    raised(&html)
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
    let class = |n: usize| if numeric[n] { " class=\"n\"" } else { "" };
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

/// A number with its unit: `1.2e-5 rad`.
fn quantity(cell: &str) -> Option<String> {
    let (number, unit) = cell.split_once(' ')?;
    Some(format!(
        "{}\u{202f}{}",
        number_html(number)?,
        unit_html(unit)
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

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
    }
}
