//! TeX to MathML, at build time.

use crate::mend::mend;
use crate::text;
use math_core::{LatexToMathML, MathCoreConfig, MathDisplay};

/// A display formula with what belongs to its place, not to its content, taken off.
#[derive(Debug, Default, PartialEq)]
pub struct Prepared {
    /// The content.
    pub tex: String,
    /// `\tag{…}`: the number at the right.
    pub tag: Option<String>,
    /// `\label{…}`: the name for `\eqref`.
    pub label: Option<String>,
    /// Whether `\boxed{…}` stood around all of it.
    pub boxed: bool,
}

/// The argument of the command at `at` in `tex`, and where it ends.
fn argument(tex: &str, at: usize, command: &str) -> Option<(String, usize)> {
    let open = at + command.len();
    let mut depth = 0;
    for (n, c) in tex.get(open..)?.char_indices() {
        match c {
            '{' => depth += 1,
            '}' => depth -= 1,
            _ if depth == 0 => return None,
            _ => {}
        }
        if depth == 0 {
            return Some((tex[open + 1..open + n].to_owned(), open + n + 1));
        }
    }
    None
}

/// Takes `\tag`, `\label` and an outer `\boxed` off a display formula. What is taken
/// leaves its line feeds behind, so that positions keep their lines.
///
/// # Errors
/// A command given twice, or without its braces.
pub fn prepare(tex: &str) -> Result<Prepared, String> {
    let mut prepared = Prepared { tex: tex.to_owned(), ..Prepared::default() };
    let mut take = |command: &str| -> Result<Option<String>, String> {
        let mut taken = None;
        while let Some(at) = prepared.tex.find(command) {
            let (content, end) = argument(&prepared.tex, at, command)
                .ok_or(format!("{command} must be followed by {{…}}"))?;
            if taken.is_some() {
                return Err(format!("{command} stands twice in one formula"));
            }
            prepared.tex.replace_range(at..end, "");
            taken = Some(content);
        }
        Ok(taken)
    };
    let tag = take("\\tag")?;
    let label = take("\\label")?;
    prepared.tag = tag;
    prepared.label = label;
    let trimmed = prepared.tex.trim();
    if trimmed.starts_with("\\boxed")
        && let Some((content, end)) = argument(trimmed, 0, "\\boxed")
        && trimmed[end..].trim().is_empty()
    {
        prepared.boxed = true;
        prepared.tex = content;
    }
    Ok(prepared)
}

/// A formula that TeX refuses: where, in bytes from its start, and why.
#[derive(Debug)]
pub struct Refused {
    /// The position in the formula.
    pub at: usize,
    /// The reason.
    pub reason: String,
}

/// The MathML of a formula.
///
/// # Errors
/// Anything that is not understood; nothing is passed through as red text.
pub fn mathml(tex: &str, display: bool) -> Result<String, Refused> {
    let config = MathCoreConfig {
        // For \widetilde: it stretches over one letter well enough.
        allow_unreliable_rendering: true,
        ..MathCoreConfig::default()
    };
    let converter =
        LatexToMathML::new(config).map_err(|(e, ..)| Refused { at: 0, reason: e.to_string() })?;
    if tex.trim().is_empty() {
        return Err(Refused { at: 0, reason: "the formula is empty".into() });
    }
    let mode = if display { MathDisplay::Block } else { MathDisplay::Inline };
    let converted = converter
        .convert_with_local_state(tex, mode)
        .map_err(|e| Refused { at: e.0.start, reason: e.to_string() })?;
    Ok(mend(&converted.mathml))
}

/// Where outside of all groups something stands that `found` knows the length of, and that length.
fn outside_of_groups(tex: &str, found: impl Fn(&str) -> Option<usize>) -> Vec<(usize, usize)> {
    let mut places = Vec::new();
    let (mut depth, mut at) = (0_i32, 0);
    while at < tex.len() {
        let rest = &tex[at..];
        let length = if depth == 0 { found(rest) } else { None };
        let is = |command: &str, other: &str| rest.starts_with(command) && !rest.starts_with(other);
        if rest.starts_with('{') || rest.starts_with("\\begin{") || is("\\left", "\\leftarrow") {
            depth += 1;
        } else if rest.starts_with('}')
            || rest.starts_with("\\end{")
            || is("\\right", "\\rightarrow")
        {
            depth -= 1;
        }
        if let Some(length) = length {
            places.push((at, length));
            at += length;
            continue;
        }
        // A command is read as a whole, an escaped brace is no group.
        let letters = |after: &str| after.find(|c: char| !c.is_ascii_alphabetic());
        at += match rest.strip_prefix('\\') {
            None => rest.chars().next().map_or(1, char::len_utf8),
            Some(after) => match letters(after).unwrap_or(after.len()) {
                0 => 1 + after.chars().next().map_or(0, char::len_utf8),
                // What \begin and \end open and close is counted above.
                letters if rest.starts_with("\\begin{") || rest.starts_with("\\end{") => {
                    rest.find('}').map_or(1 + letters, |end| end + 1)
                }
                letters => 1 + letters,
            },
        };
    }
    places
}

/// Whether `rest` begins with the command `name` and not with a longer one.
fn is_command(rest: &str, name: &str) -> bool {
    let after = rest.strip_prefix('\\').and_then(|rest| rest.strip_prefix(name));
    after.is_some_and(|after| !after.starts_with(|c: char| c.is_ascii_alphabetic()))
}

/// The parts of a display formula that `\qquad` separates outside of all groups: set
/// side by side where there is room, below each other where there is not.
pub fn parts(tex: &str) -> Vec<&str> {
    let separators = outside_of_groups(tex, |rest| is_command(rest, "qquad").then_some(6));
    let mut parts = Vec::new();
    let mut start = 0;
    for (at, length) in separators {
        parts.push(&tex[start..at]);
        start = at + length;
    }
    parts.push(&tex[start..]);
    if parts.iter().any(|part| part.trim().is_empty()) {
        return vec![tex];
    }
    parts
}

/// The most characters of a formula in a line that is kept in one piece.
const LONG: usize = 14;

/// The pieces of a long formula in a line, each but the last ended by a relation: behind it the
/// line may be broken, as TeX does it. Browsers break no line within a formula.
pub fn pieces(tex: &str) -> Vec<&str> {
    const RELATIONS: [&str; 12] =
        ["approx", "le", "ge", "ll", "gg", "equiv", "to", "propto", "sim", "simeq", "ne", "neq"];
    let whole = mathml(tex, false).map(|mathml| plain(&mathml).chars().count());
    if whole.unwrap_or(0) <= LONG {
        return vec![tex];
    }
    let relations = outside_of_groups(tex, |rest| {
        let command = RELATIONS.iter().find(|name| is_command(rest, name));
        let sign = rest.starts_with(['=', '<', '>']).then_some(1);
        sign.or(command.map(|name| 1 + name.len()))
    });
    let mut pieces = Vec::new();
    let mut start = 0;
    for (at, length) in relations {
        // A relation at the very start, or behind another, ends nothing.
        if !tex[start..at].trim().is_empty() {
            pieces.push(&tex[start..at + length]);
            start = at + length;
        }
    }
    if tex[start..].trim().is_empty() {
        return vec![tex];
    }
    pieces.push(&tex[start..]);
    pieces
}

/// The characters of a formula, to measure how long it is.
fn plain(mathml: &str) -> String {
    let text: String = text::without_tags(mathml)
        .chars()
        .filter(|c| !matches!(c, '\u{2061}'..='\u{2064}'))
        .collect();
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tags_labels_and_boxes_are_taken_off() {
        let prepared = prepare("\\boxed{x = \\frac{1}{2}}\n\\tag{16.2 (4)} \\label{eq:u}");
        assert_eq!(
            prepared,
            Ok(Prepared {
                tex: "x = \\frac{1}{2}".into(),
                tag: Some("16.2 (4)".into()),
                label: Some("eq:u".into()),
                boxed: true,
            })
        );
        assert!(prepare("x \\tag{1} \\tag{2}").is_err());
        assert!(prepare("x \\tag 1").is_err());
    }

    #[test]
    fn formulas_part_where_there_is_room() {
        let cases = [
            (r"a = 1, \qquad b = \frac{1}{2}", 2),
            (r"\left( a \qquad b \right)", 1),
            (r"\begin{cases} a \qquad b \end{cases}", 1),
            (r"\text{a \qquad b} \qquad \{ c", 2),
            (r"\qquad a", 1),
            (r"\leftarrow \qquad \rightarrow \\ \qquad x", 3),
            (r"\alpha \qquad {b}", 2),
            (r"\{ a \qquad b \}", 2),
            (r"60° \qquad φ", 2),
        ];
        for (tex, count) in cases {
            assert_eq!(parts(tex).len(), count, "{tex}: {:?}", parts(tex));
        }
    }

    #[test]
    fn a_long_formula_may_be_broken_behind_a_relation() {
        let cases = [
            (r"a = b", vec![r"a = b"]),
            (r"a(b-u)(1-bu) = c(1-u^2)^2 \le d", vec![r"a(b-u)(1-bu) =", r" c(1-u^2)^2 \le", " d"]),
            (
                r"\left(a = b\right)^2 - f(x, y, z, t, u)",
                vec![r"\left(a = b\right)^2 - f(x, y, z, t, u)"],
            ),
            (
                r"= \sqrt{x = 1} + \leftarrow aaaaaaaaaaaa",
                vec![r"= \sqrt{x = 1} + \leftarrow aaaaaaaaaaaa"],
            ),
            (r"a \le b + c + d + e + f + g + h =", vec![r"a \le b + c + d + e + f + g + h ="]),
        ];
        for (tex, expected) in cases {
            assert_eq!(pieces(tex), expected, "{tex}");
        }
    }

    #[test]
    fn the_book_s_vocabulary_is_understood() {
        let formulas = [
            r"\dot\phi = \frac{b - u}{1-u^2}",
            r"\ddot\theta + \tfrac{1}{2}\sqrt{a-b} = 0",
            r"\hat{e}_3 \times \dot{\vec L}",
            r"\begin{cases} x & y>0\\ -x & \text{otherwise}\end{cases}",
            r"\begin{aligned} I_1\dot\theta^2 &= 2E - U_{\mathrm{eff}}\\ &= a\left(\frac{1}{b}\right)^2\end{aligned}",
            r"\lvert\boldsymbol{L}\rvert \le \lVert x \rVert",
            r"\widetilde{E} = \frac{E'}{L_z^2/I_3}",
            r"\int_0^{2\pi} f\,\mathrm{d}t \approx 10^{-3}\,\mathrm{s}",
            r"\operatorname{sn}(u \mid m),\quad \underbrace{a+b}_{c}",
            r"\begin{pmatrix} 1 & 0 \\ 0 & 1 \end{pmatrix}",
        ];
        for tex in formulas {
            let html = mathml(tex, true).map_err(|e| e.reason);
            assert!(html.is_ok(), "{tex}: {html:?}");
        }
        // The damaged twins: each is refused, with its place.
        let damaged = [r"\frac{1}{2", r"\dotphi", r"\left( x", r"x^2^3", "  "];
        for tex in damaged {
            assert!(mathml(tex, true).is_err(), "{tex}");
        }
        assert_eq!(mathml(r"x + \nonsense", false).map_err(|e| e.at).err(), Some(4));
    }
}
