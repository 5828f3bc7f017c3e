//! Locked figures, made part of a page.
//!
//! A figure is drawn with the variables of the palette, so that it follows the
//! theme once it stands in the page itself; as a picture file it would not.

use std::collections::BTreeSet;

/// What a figure shows, in words.
///
/// # Errors
/// If it does not say so (`aria-label`), or has no `viewBox`: then it could not be scaled.
pub fn alternative(svg: &str) -> Result<&str, String> {
    if !svg.contains(" viewBox=\"") {
        return Err("the figure has no viewBox".into());
    }
    svg.split_once(" aria-label=\"")
        .and_then(|(_, rest)| rest.split_once('"'))
        .map(|(alt, _)| alt.trim())
        .filter(|alt| !alt.is_empty())
        .ok_or("the figure does not say what is to be seen (aria-label)".into())
}

/// The figure as part of a page; its identifiers begin with `prefix`, so that two
/// figures of a page cannot use each other's clip paths.
///
/// # Errors
/// As [`alternative`].
pub fn inline(svg: &str, prefix: &str) -> Result<String, String> {
    alternative(svg)?;
    let start = svg.find("<svg").ok_or("the figure is not an SVG")?;
    let mut svg = svg[start..].trim_end().to_owned();
    let ids: BTreeSet<String> = svg
        .match_indices(" id=\"")
        .filter_map(|(at, key)| {
            let value = &svg[at + key.len()..];
            Some(value[..value.find('"')?].to_owned())
        })
        .collect();
    for id in ids {
        for (open, close) in [(" id=\"", "\""), ("url(#", ")"), ("href=\"#", "\"")] {
            svg = svg.replace(&format!("{open}{id}{close}"), &format!("{open}{prefix}{id}{close}"));
        }
    }
    Ok(svg)
}

/// A figure of a page: a row of panels with their caption below.
pub struct Row<'a> {
    /// Its number on the page.
    pub number: usize,
    /// The panels: the name of each (`STEM:NAME`) and the mark that holds its place.
    pub panels: &'a [(String, String)],
    /// Of a moving figure: whose it is, and the mark of what plays it.
    pub player: Option<(&'a str, &'a str)>,
    /// What the reader is told.
    pub caption: &'a str,
    /// What stands before each line: within a list or a quotation.
    pub indent: &'a str,
    /// Its identifier.
    pub id: &'a str,
}

/// The figure as Markdown that holds HTML.
pub fn row(row: &Row) -> String {
    let panel = |(name, mark): &(String, String)| {
        format!("<div class=\"panel\" data-figure=\"{name}\">{mark}</div>")
    };
    let panels: String = row.panels.iter().map(panel).collect();
    let (class, frame, player) = match row.player {
        Some((stem, mark)) => ("panels stills", format!(" data-frame=\"{stem}\""), mark),
        None => ("panels", String::new(), ""),
    };
    let Row { number, caption, indent, id, .. } = row;
    let lines = [
        &format!("<figure id=\"{id}\"{frame}>"),
        &format!("<div class=\"{class}\">{panels}</div>{player}"),
        "<figcaption>",
        "",
        &format!("<span class=\"number\">Figure {number}.</span> {caption}"),
        "",
        "</figcaption>",
        "</figure>",
        "",
        "",
    ];
    let indented: Vec<String> = lines
        .iter()
        .map(|line| if line.is_empty() { String::new() } else { format!("{indent}{line}") })
        .collect();
    indented.join("\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    const SVG: &str = "<?xml version=\"1.0\"?>\n<svg viewBox=\"0 0 340 260\" aria-label=\"A line that falls\">\
        <clipPath id=\"c\"/><path clip-path=\"url(#c)\"/></svg>\n";

    #[test]
    fn a_figure_keeps_to_itself() {
        assert_eq!(
            inline(SVG, "f1-").as_deref(),
            Ok("<svg viewBox=\"0 0 340 260\" aria-label=\"A line that falls\">\
                <clipPath id=\"f1-c\"/><path clip-path=\"url(#f1-c)\"/></svg>")
        );
        // The damaged twins.
        assert!(inline(&SVG.replace("A line that falls", " "), "").is_err());
        assert!(inline(&SVG.replace("viewBox", "viewbox"), "").is_err());
    }
}
