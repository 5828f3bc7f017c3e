//! The lint of characters: each one of a page is in the font that the style sheet gives it.

use crate::fonts::Family;
use crate::mend::italic;
use crate::text::unescape;
use std::collections::BTreeSet;

/// A character that its font lacks, and the line where it first stands, from 1.
#[derive(Debug, PartialEq)]
pub struct Missing {
    /// The character.
    pub c: char,
    /// Its font.
    pub family: Family,
    /// The line of the HTML.
    pub line: usize,
}

/// The elements that decide on the font of what is in them.
const DECIDE: [&str; 9] = ["math", "mtext", "mi", "code", "pre", "kbd", "script", "style", "title"];

/// The characters of a page that the book's fonts lack, each once.
///
/// `mtext` is set like text; a single letter in `mi` without attributes is slanted. What is in no
/// element of code or formulas is text: where the reader's own sans serif comes first, the serif
/// stands behind it.
pub fn missing(html: &str) -> Vec<Missing> {
    let mut found = Vec::new();
    let mut seen = BTreeSet::new();
    let mut open: Vec<&str> = Vec::new();
    let mut slanted = false;
    let mut line = 1;
    let mut rest = html;
    while !rest.is_empty() {
        let (text, after) = rest.split_at(rest.find('<').unwrap_or(rest.len()));
        let has = |names: &[&str]| open.iter().any(|name| names.contains(name));
        let family = match has(&["script", "style", "title"]) {
            true => None,
            false if has(&["mtext"]) => Some(Family::Serif),
            false if has(&["math"]) => Some(Family::Maths),
            false if has(&["code", "pre", "kbd"]) => Some(Family::Mono),
            false => Some(Family::Serif),
        };
        let plain = unescape(text);
        let single = slanted && plain.chars().count() == 1;
        for c in plain.chars() {
            let c = if single { italic(c) } else { c };
            if let Some(family) = family
                && seen.insert((family, c))
                && !c.is_control()
                && !family.covers(c)
            {
                found.push(Missing { c, family, line });
            }
            line += usize::from(c == '\n');
        }
        let end = match after.starts_with("<!--") {
            true => after.find("-->").map(|end| end + 2),
            false => after.find('>'),
        };
        let tag = &after[..end.map_or(after.len(), |end| end + 1)];
        line += tag.matches('\n').count();
        let inner = tag.trim_start_matches('<').trim_end_matches('>');
        let name = |tag: &'static str| tag == inner.split(char::is_whitespace).next().unwrap_or("");
        slanted = inner == "mi";
        if let Some(closed) = inner.strip_prefix('/') {
            if open.last() == Some(&closed) {
                open.pop();
            }
        } else if let Some(opened) = DECIDE.iter().find(|tag| name(tag)) {
            open.push(opened);
        }
        rest = &after[tag.len()..];
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_character_is_looked_up_in_its_own_font() {
        let sound = "<title>漢</title><p title=\"漢\">Ač &#8722;<!-- 漢 -->\n\
            <math><mi>φ</mi><mtext>č</mtext></math><code>├</code></p>";
        assert_eq!(missing(sound), []);
        let missing_in = |from: &str, to: &str| {
            let found = missing(&sound.replacen(from, to, 1));
            let [Missing { c, family, line }] = found[..] else {
                panic!("{to}: {found:?}");
            };
            (c, family, line)
        };
        assert_eq!(missing_in("Ač", "漢漢"), ('漢', Family::Serif, 1));
        assert_eq!(missing_in("&#8722;", "&#28450;"), ('漢', Family::Serif, 1));
        assert_eq!(missing_in("<mi>φ", "<mi>č"), ('č', Family::Maths, 2));
        assert_eq!(missing_in("<mtext>č", "<mtext>├"), ('├', Family::Serif, 2));
        assert_eq!(missing_in("├", "漢"), ('漢', Family::Mono, 2));
        // A letter on its own is slanted: the script h is not among the slanted ones.
        assert_eq!(missing("<math><mi>h</mi><mi>sin</mi></math>"), []);
    }
}
