//! TeX to MathML, at build time.

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
    let mut prepared = Prepared {
        tex: tex.to_owned(),
        ..Prepared::default()
    };
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
    let converter = LatexToMathML::new(config).map_err(|(e, ..)| Refused {
        at: 0,
        reason: e.to_string(),
    })?;
    if tex.trim().is_empty() {
        return Err(Refused {
            at: 0,
            reason: "the formula is empty".into(),
        });
    }
    let mode = if display {
        MathDisplay::Block
    } else {
        MathDisplay::Inline
    };
    let converted = converter
        .convert_with_local_state(tex, mode)
        .map_err(|e| Refused {
            at: e.0.start,
            reason: e.to_string(),
        })?;
    // Chromium ignores the font's raised variants of primes: they get a class to be
    // set by the style sheet.
    let mut mathml = converted.mathml;
    for prime in ['\u{2032}', '\u{2033}', '\u{2034}'] {
        mathml = mathml.replace(
            &format!("<mo>{prime}</mo>"),
            &format!("<mo class=\"prime\">{prime}</mo>"),
        );
    }
    Ok(mathml)
}

/// The formula as plain text, for the search index.
pub fn plain(mathml: &str) -> String {
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
        assert_eq!(
            mathml(r"x + \nonsense", false).map_err(|e| e.at).err(),
            Some(4)
        );
    }
}
