//! Sections of the locked output as tables of a page.

use crate::notation::{symbols, words};
use crate::text::{escape, number_html, unit_html};
use crate::token;
use kit::Table;

/// Sections whose rows are quantities of different kinds.
const MIXED: [&str; 4] = ["parameters", "claims", "limits", "effects"];

/// The section whose rows are cards on a phone.
const CARDS: &str = "effects";

/// What a card's last column says, under the card.
const CARD_LEGEND: &str = "\u{201c}In\u{201d} means that leaving the effect out costs more than half the \
     tolerance: the fraction in the heading (of the quantity, or of a radian for an angle), or the \
     value beside the word. <a href=\"effects.html#how-to-read-the-table\">How to read this \
     table</a>.";

/// The most characters of a cell that is not broken.
const LONGEST_SHORT: usize = 20;

/// The text of all cells, for the search index.
pub fn plain(table: &Table) -> String {
    let rows: Vec<String> = table.rows().iter().map(|row| row.join(" ")).collect();
    format!("{} {}", table.columns().join(" "), rows.join(" "))
}

/// The table as HTML. What a card leaves out though it is called for stands out.
pub fn html(table: &Table) -> String {
    if table.heading() != CARDS {
        return html_with(table, |_, _| false);
    }
    let last = table.columns().len() - 1;
    html_with(table, |line, column| {
        let row = &table.rows()[line];
        column == last && row.contains(&"left out".into()) && row[last].starts_with("in")
    })
}

/// A section of a page, in a box that scrolls if it must.
pub fn section(table: &Table) -> String {
    let legend = match table.heading() {
        CARDS => format!("<p class=\"measured\">{CARD_LEGEND}</p>"),
        _ => String::new(),
    };
    format!("<div class=\"scroll\">{}</div>{legend}", html(table))
}

/// The table as HTML; the cells for which `strong` holds, by row and column, stand out.
pub fn html_with(table: &Table, strong: impl Fn(usize, usize) -> bool) -> String {
    let name = table.heading().trim_start_matches("table ");
    // A table whose cells are blocks on a phone must say what they are.
    let cards = table.heading() == CARDS;
    let role = |role: &str| match cards {
        true => format!(" role=\"{role}\""),
        false => String::new(),
    };
    let (of_row, of_head, of_cell) = (role("row"), role("columnheader"), role("cell"));
    let mut html = format!(
        "<table class=\"section {}\"{}><thead{}><tr{of_row}>",
        escape(name),
        role("table"),
        role("rowgroup")
    );
    // A column is numeric if most of what it holds is; one without content is left out.
    let column = |n: usize| table.rows().iter().map(move |row| row[n].as_str());
    let numeric: Vec<bool> = (0..table.columns().len())
        .map(|n| {
            let held = column(n).filter(|cell| *cell != "-");
            let numbers = held.clone().filter(|cell| number_html(cell).is_some());
            2 * numbers.count() > held.count()
        })
        .collect();
    // Where all rows are of one kind, so are the numbers of a column: powers of ten or none.
    let uniform = !MIXED.contains(&table.heading());
    let powers: Vec<bool> = (0..numeric.len())
        .map(|n| uniform && numeric[n] && column(n).any(|cell| cell.contains('e')))
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
        let head = words(&table.columns()[n]);
        // Not every reader of screens takes a formula for text.
        let label = format!("<math aria-label=\"{}\">", escape(&symbols(&table.columns()[n])));
        let alone = head.starts_with("<math>") && head.find("</math>") == head.rfind("</math>");
        let head = match alone && head.ends_with("</math>") {
            true => head.replacen("<math>", &label, 1),
            false => head,
        };
        html += &format!("<th scope=\"col\"{of_head}{}>{head}</th>", class(n));
    }
    html += &format!("</tr></thead><tbody{}>", role("rowgroup"));
    for (line, row) in table.rows().iter().enumerate() {
        html += &format!("<tr{of_row}>");
        for n in (0..numeric.len()).filter(shown) {
            let cell = &row[n];
            let column = table.columns()[n].as_str();
            let content = match (cell.as_str(), column) {
                ("-", _) => "–".into(),
                (cell, "key" | "flag") => format!("<code>{}</code>", escape(cell)),
                (cell, "unit") => unit_html(cell),
                // A formula, though it may begin as a quantity does: 4 m d^2/I.
                (cell, "number") if cards => words(cell),
                (cell, _) if cards && cell.contains(", ") && column.starts_with("at ") => {
                    let (word, tolerance) = cell.split_once(", ").unwrap_or((cell, ""));
                    let tolerance = quantity(tolerance).unwrap_or_else(|| words(tolerance));
                    format!("{word}, <span class=\"glued\">{tolerance}</span>")
                }
                (cell, _) if powers[n] => {
                    number_html(&with_power(cell)).unwrap_or_else(|| words(cell))
                }
                (cell, _) => {
                    number_html(cell).or_else(|| quantity(cell)).unwrap_or_else(|| words(cell))
                }
            };
            let content = match strong(line, n) {
                true => format!("<strong>{content}</strong>"),
                false => content,
            };
            let label = match cards && n > 0 {
                true if cell == "-" => " data-none".into(),
                true => format!(" data-label=\"{}\"", escape(&label(column))),
                false => String::new(),
            };
            html += &format!("<td{of_cell}{}{label}>{content}</td>", class(n));
        }
        html += "</tr>";
    }
    html + "</tbody></table>"
}

/// A head as plain text: `at 1e-2` is `at 10⁻²`.
fn label(column: &str) -> String {
    let Some(exponent) = column.strip_prefix("at 1e-") else {
        return symbols(column);
    };
    let digits =
        exponent.chars().filter_map(|digit| "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().nth(digit.to_digit(10)? as usize));
    format!("at 10⁻{}", digits.collect::<String>())
}

/// A number with its unit, or with what it counts: `1.2e-5 rad`, `0.031 of t_floor`. The first
/// word stays with the number.
fn quantity(cell: &str) -> Option<String> {
    let (number, after) = cell.split_once(' ')?;
    let number = number_html(number)?;
    let word = |text: &str| text.find([' ', ',', ':']).unwrap_or(text.len());
    let mut end = word(after);
    // Newtons and kilograms go on: `N m s`, `kg m^2/s`.
    if ["N", "kg"].contains(&&after[..end]) {
        let goes_on =
            |next: &&str| ["m", "s", "m/s", "m^2", "m^2/s"].contains(&&next[..word(next)]);
        while let Some(next) = after[end..].strip_prefix(' ').filter(goes_on) {
            end += 1 + word(next);
        }
    }
    let (unit, after) = after.split_at(end);
    let plain = |c: char| c.is_ascii_alphanumeric() || "/^- ".contains(c);
    let is_unit = unit.chars().all(plain) && !token::is_greek(unit) && !after.starts_with(" (");
    Some(match is_unit {
        true => format!("{number}\u{202f}{}{}", unit_html(unit), words(after)),
        false => words(cell),
    })
}

/// A large or small number with a power of ten, its digits kept: `7100000` is `7.1e6`. Zeros
/// at the end of a whole number stand for digits that are not known.
fn with_power(cell: &str) -> String {
    let Ok(value) = cell.parse::<f64>() else {
        return cell.into();
    };
    let size = value.abs();
    if cell.contains('e') || value == 0.0 || (0.1..1e3).contains(&size) {
        return cell.into();
    }
    let digits: String = cell.chars().filter(char::is_ascii_digit).collect();
    let digits = digits.trim_start_matches('0');
    let known = match cell.contains('.') {
        true => digits,
        false => digits.trim_end_matches('0'),
    };
    format!("{value:.*e}", known.len().saturating_sub(1))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_column_has_one_format_and_dashes_do_not_count() {
        let locked = "Sample\n\ntable costs\nmethod  torques  here\n\
                      a       7100000  1\nb       1.3e7    -\nc       420      -\n";
        let tables = kit::parse(locked).expect("it is a table").tables;
        let html = html(&tables[0]);
        for cell in [
            "<td class=\"n\">7.1\u{202f}\u{d7}\u{202f}10<sup>6</sup></td>",
            "<td class=\"n\">420</td>",
            "<td class=\"n\">1</td>",
        ] {
            assert!(html.contains(cell), "{cell}\n{html}");
        }
        assert_eq!(with_power("0.012"), "1.2e-2");
        assert_eq!(with_power("12345"), "1.2345e4");
    }

    #[test]
    fn a_head_that_is_a_formula_says_what_it_is() {
        let locked = "Sample\n\ntable mass\nmass  omega_floor  t_release in s\n1  2  3\n";
        let tables = kit::parse(locked).expect("it is a table").tables;
        let html = html(&tables[0]);
        assert!(html.contains("><math aria-label=\"ω_floor\"><msub>"), "{html}");
        assert_eq!(html.matches("aria-label").count(), 1, "{html}");
    }

    #[test]
    fn a_card_says_what_its_cells_are_and_what_it_lacks() {
        let locked = "Sample\n\neffects\n\
             effect    number       value  error if left out  here      at 1e-2\n\
             antennas  4 m d^2/I_a  0.72   0.72 of the rate   left out  in\n\
             weight    2^-53        1.0    6.3 rad            in        in, 0.063 rad/s\n";
        let parsed = kit::parse(locked).expect("it is a table");
        let html = section(&parsed.tables[0]);
        for part in [
            "<table class=\"section effects\" role=\"table\">",
            "<td role=\"cell\" class=\"short\">antennas</td>",
            "data-label=\"number\"><math><mn>4</mn><mi>m</mi>",
            "data-label=\"at 10⁻²\"><strong>in</strong></td>",
            "data-label=\"at 10⁻²\">in, <span class=\"glued\">0.063\u{202f}rad/s</span></td>",
            ">at 10<sup>\u{2212}2</sup></th>",
        ] {
            assert!(html.contains(part), "{part}\n{html}");
        }
        assert!(html.ends_with(&format!("</div><p class=\"measured\">{CARD_LEGEND}</p>")));
        assert_eq!(html.matches("<strong>").count(), 1, "{html}");
    }

    #[test]
    fn only_a_column_of_long_words_is_broken() {
        let locked = "Sample\n\nlimits\nlimit                  gives  here\n\
                      a limit of many words  0.5    left out\n";
        let tables = kit::parse(locked).expect("it is a table").tables;
        let html = html(&tables[0]);
        assert!(html.contains("<td>a limit of many words</td>"), "{html}");
        assert!(html.contains("<td class=\"short\">left out</td>"), "{html}");
        assert!(html.contains("<td class=\"n\">0.5</td>"), "{html}");
    }

    #[test]
    fn a_number_keeps_its_unit() {
        let cases = [
            ("1.2e-5 rad", "1.2\u{202f}×\u{202f}10<sup>\u{2212}5</sup>\u{202f}rad"),
            ("3 m/s^2, upwards", "3\u{202f}m/s<sup>2</sup>, upwards"),
            ("0.5 of it", "0.5\u{202f}of it"),
            ("0.2 N m of it", "0.2\u{202f}N\u{202f}m of it"),
            ("3 kg m^2/s", "3\u{202f}kg\u{202f}m<sup>2</sup>/s"),
            ("7 (at most)", "7 (at most)"),
        ];
        // These are formulas.
        for cell in ["2 pi I1", "3 g (b - c)"] {
            assert_eq!(quantity(cell), Some(words(cell)), "{cell}");
            assert!(words(cell).starts_with("<math><mn>"), "{cell}");
        }
        for (cell, html) in cases {
            assert_eq!(quantity(cell).as_deref(), Some(html), "{cell}");
        }
        assert_eq!(quantity("left out"), None);
    }
}
