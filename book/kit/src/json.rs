//! The claims of a report as JSON.

use super::Report;
use core::fmt::Write;

/// A JSON string literal.
///
/// ```
/// use kit::quoted;
/// assert_eq!(quoted("a \"b\"\n"), r#""a \"b\"\u000a""#);
/// ```
pub fn quoted(text: &str) -> String {
    let mut out = String::from("\"");
    for c in text.chars() {
        match c {
            '"' => out.push_str("\\\""),
            '\\' => out.push_str("\\\\"),
            c if (c as u32) < 0x20 => {
                // Writing to a string cannot fail.
                let _ = write!(out, "\\u{:04x}", c as u32);
            }
            c => out.push(c),
        }
    }
    out.push('"');
    out
}

/// `{"stem", "title", "claims": [{"key", "meaning", "value", "printed", "unit",
/// "bound", "oracle", "oracle_value", "error"}]}`; numbers read back to the same bits.
pub(super) fn claims(stem: &str, report: &Report) -> String {
    let entries: Vec<String> = report
        .claims()
        .iter()
        .map(|c| {
            // `{:?}` writes every finite f64 as valid JSON, shortest form that reads back.
            format!(
                "    {{\"key\": {}, \"meaning\": {}, \"value\": {:?}, \"printed\": {}, \"unit\": {}, \
                 \"bound\": {:?}, \"oracle\": {}, \"oracle_value\": {:?}, \"error\": {:?}}}",
                quoted(&c.key),
                quoted(&c.meaning),
                c.value,
                quoted(&c.printed()),
                quoted(&c.unit),
                c.bound,
                quoted(&c.oracle.name),
                c.oracle.value,
                c.difference(),
            )
        })
        .collect();
    format!(
        "{{\n  \"stem\": {},\n  \"title\": {},\n  \"claims\": [\n{}\n  ]\n}}\n",
        quoted(stem),
        quoted(report.title()),
        entries.join(",\n")
    )
}
