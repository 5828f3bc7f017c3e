//! Places in a page that are filled after mdBook has written its HTML.
//!
//! mdBook's tokenizer damages SVG and MathML (it lowercases `viewBox`, reads `_` as
//! emphasis). So the preprocessor leaves a mark that says what belongs there, and the
//! renderer fills it. The mark carries everything, so that the two may run in
//! different processes, as the stock `mdbook` does it.

use std::fmt::Write;

/// What belongs at a mark.
#[derive(Debug, Clone, PartialEq)]
pub enum Splice {
    /// A formula in a line.
    Inline { tex: String },
    /// A formula of its own.
    Display { tex: String, tag: Option<String>, id: Option<String>, boxed: bool },
    /// What opens a proof: a number (`num`) or a tick (`tick`), and the proof.
    Proof { kind: String, id: String, html: String, proof: String },
    /// A locked figure.
    Figure { stem: String, name: String },
    /// What plays a moving figure.
    Player { stem: String },
    /// The field for a reader's own recording, with the flags that can be set there.
    Recording { stem: String, flags: String },
    /// A section of the locked output.
    Table { stem: String, section: String },
    /// A table of a record of measurements.
    Measured { record: String, table: String },
    /// The answer box.
    Check { stem: String },
    /// The table of a group of exercises.
    Exercises { group: String },
}

const OPEN: &str = "<span data-splice=\"";
const MIDDLE: &str = "\">";
const CLOSE: &str = "</span>";

impl Splice {
    fn fields(&self) -> Vec<String> {
        let some = |field: &Option<String>| field.clone().unwrap_or_default();
        match self {
            Self::Inline { tex } => vec!["inline".into(), tex.clone()],
            Self::Display { tex, tag, id, boxed } => vec![
                "display".into(),
                tex.clone(),
                some(tag),
                some(id),
                if *boxed { "boxed" } else { "" }.into(),
            ],
            Self::Proof { kind, id, html, proof } => {
                vec!["proof".into(), kind.clone(), id.clone(), html.clone(), proof.clone()]
            }
            Self::Figure { stem, name } => vec!["figure".into(), stem.clone(), name.clone()],
            Self::Player { stem } => vec!["player".into(), stem.clone()],
            Self::Recording { stem, flags } => {
                vec!["recording".into(), stem.clone(), flags.clone()]
            }
            Self::Table { stem, section } => vec!["table".into(), stem.clone(), section.clone()],
            Self::Measured { record, table } => {
                vec!["measured".into(), record.clone(), table.clone()]
            }
            Self::Check { stem } => vec!["check".into(), stem.clone()],
            Self::Exercises { group } => vec!["exercises".into(), group.clone()],
        }
    }

    fn from_fields(fields: &[String]) -> Option<Self> {
        let some = |field: &String| (!field.is_empty()).then(|| field.clone());
        let words: Vec<&str> = fields.iter().map(String::as_str).collect();
        Some(match *words.as_slice() {
            ["inline", tex] => Self::Inline { tex: tex.into() },
            ["display", tex, _, _, boxed] => Self::Display {
                tex: tex.into(),
                tag: some(&fields[2]),
                id: some(&fields[3]),
                boxed: boxed == "boxed",
            },
            ["proof", kind, id, html, proof] => Self::Proof {
                kind: kind.into(),
                id: id.into(),
                html: html.into(),
                proof: proof.into(),
            },
            ["figure", stem, name] => Self::Figure { stem: stem.into(), name: name.into() },
            ["player", stem] => Self::Player { stem: stem.into() },
            ["recording", stem, flags] => {
                Self::Recording { stem: stem.into(), flags: flags.into() }
            }
            ["table", stem, section] => Self::Table { stem: stem.into(), section: section.into() },
            ["measured", record, table] => {
                Self::Measured { record: record.into(), table: table.into() }
            }
            ["check", stem] => Self::Check { stem: stem.into() },
            ["exercises", group] => Self::Exercises { group: group.into() },
            _ => return None,
        })
    }

    /// The mark, with `text` for those who search.
    ///
    /// Every character of `text` that Markdown could read is written as an entity.
    pub fn mark(&self, text: &str) -> String {
        let mut mark = String::from(OPEN);
        for (n, field) in self.fields().iter().enumerate() {
            if n > 0 {
                mark.push('.');
            }
            for byte in field.bytes() {
                let _ = write!(mark, "{byte:02x}");
            }
        }
        mark.push_str(MIDDLE);
        for c in text.chars() {
            if c.is_ascii_punctuation() {
                let _ = write!(mark, "&#{};", u32::from(c));
            } else {
                mark.push(c);
            }
        }
        mark.push_str(CLOSE);
        mark
    }
}

fn decode(field: &str) -> Option<String> {
    if !field.len().is_multiple_of(2) {
        return None;
    }
    let bytes: Option<Vec<u8>> = (0..field.len())
        .step_by(2)
        .map(|at| u8::from_str_radix(field.get(at..at + 2)?, 16).ok())
        .collect();
    String::from_utf8(bytes?).ok()
}

/// Replaces each mark in `html` with what `fill` gives for it.
///
/// # Errors
/// A mark that cannot be read, or the first error of `fill`.
pub fn fill(
    html: &str,
    mut fill: impl FnMut(&Splice) -> Result<String, String>,
) -> Result<String, String> {
    let mut filled = String::with_capacity(html.len());
    let mut rest = html;
    while let Some(at) = rest.find(OPEN) {
        let (before, mark) = rest.split_at(at);
        filled.push_str(before);
        let damaged = || format!("a damaged mark: {}", mark.get(..80).unwrap_or(mark));
        let (fields, after) = mark[OPEN.len()..].split_once(MIDDLE).ok_or_else(damaged)?;
        let (_, after) = after.split_once(CLOSE).ok_or_else(damaged)?;
        let fields: Option<Vec<String>> = fields.split('.').map(decode).collect();
        let splice = fields.and_then(|fields| Splice::from_fields(&fields)).ok_or_else(damaged)?;
        filled.push_str(&fill(&splice)?);
        rest = after;
    }
    filled.push_str(rest);
    Ok(filled)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn marks_come_back() {
        let splices = [
            Splice::Inline { tex: r"\dot\phi_1 * |x|".into() },
            Splice::Display {
                tex: "E=\n+ 1".into(),
                tag: Some("16.2 (4)".into()),
                id: None,
                boxed: true,
            },
            Splice::Figure { stem: "a".into(), name: "b".into() },
            Splice::Player { stem: "a".into() },
            Splice::Recording { stem: "a".into(), flags: "from to".into() },
            Splice::Table { stem: "a".into(), section: "limits".into() },
            Splice::Measured { record: "peers".into(), table: "ratios".into() },
            Splice::Check { stem: "a".into() },
            Splice::Exercises { group: "a".into() },
            Splice::Proof {
                kind: "num".into(),
                id: "p-1".into(),
                html: "2<sup>3</sup>".into(),
                proof: "error below <b>1</b>".into(),
            },
        ];
        let mut page = String::from("<p>");
        for splice in &splices {
            page += &splice.mark("a_b|c");
        }
        let mut seen = Vec::new();
        let filled = fill(&page, |splice| {
            seen.push(splice.clone());
            Ok("!".into())
        });
        assert_eq!(filled.as_deref(), Ok("<p>!!!!!!!!!!"));
        assert_eq!(seen, splices);
        // The damaged twin: a broken mark is an error, not text.
        assert!(fill("<span data-splice=\"zz\"></span>", |_| Ok(String::new())).is_err());
    }
}
