//! Labels: words, and between dollar signs a little TeX.
//!
//! In `$…$` letters are slanted, digits and signs upright, `-` is a minus sign, `'`
//! a prime; there are Greek letters (`\theta`), `_x`, `^{-3}`, `_{eff}` (a word: upright), `\tilde E`,
//! `\dot\phi`, `\mathrm{d}`, `\times`, `\cdot`, `\cos`, thin space `\,`. Outside,
//! text is text.

use super::display::Run;
use super::widths::thousandths;

/// Size of the text of labels, in px.
pub(super) const SIZE: f64 = 14.0;
/// Size of sub- and superscripts relative to the text: never below 11 px.
const SMALL: f64 = 0.79;
/// Size of slanted letters, which have a face of their own that runs smaller.
const SLANTED: f64 = 1.08;

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Level {
    Base,
    Sub,
    Sup,
}

#[derive(Debug, Clone, PartialEq)]
struct Span {
    text: String,
    slanted: bool,
    level: Level,
}

impl Span {
    /// The size of its letters, that of the text being 1.
    fn scale(&self) -> f64 {
        let scale = if self.level == Level::Base { 1.0 } else { SMALL };
        if self.slanted { SLANTED * scale } else { scale }
    }
}

/// A parsed label.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Label {
    spans: Vec<Span>,
}

const NAMES: [(&str, &str); 40] = [
    ("alpha", "α"),
    ("beta", "β"),
    ("gamma", "γ"),
    ("delta", "δ"),
    ("epsilon", "ε"),
    ("zeta", "ζ"),
    ("eta", "η"),
    ("theta", "θ"),
    ("kappa", "κ"),
    ("lambda", "λ"),
    ("mu", "μ"),
    ("nu", "ν"),
    ("xi", "ξ"),
    ("pi", "π"),
    ("rho", "ρ"),
    ("sigma", "σ"),
    ("tau", "τ"),
    ("phi", "φ"),
    ("chi", "χ"),
    ("psi", "ψ"),
    ("omega", "ω"),
    ("Gamma", "Γ"),
    ("Delta", "Δ"),
    ("Theta", "Θ"),
    ("Lambda", "Λ"),
    ("Phi", "Φ"),
    ("Psi", "Ψ"),
    ("Omega", "Ω"),
    ("times", "×"),
    ("cdot", "·"),
    ("approx", "≈"),
    ("le", "≤"),
    ("ge", "≥"),
    ("to", "→"),
    ("infty", "∞"),
    ("pm", "±"),
    ("degree", "°"),
    ("sqrt", "√"),
    ("varepsilon", "ε"),
    ("ell", "ℓ"),
];

impl Label {
    pub(super) fn new(text: &str) -> Self {
        let mut label = Self { spans: Vec::new() };
        for (i, part) in text.split('$').enumerate() {
            if i % 2 == 0 {
                label.push(part, false, Level::Base);
            } else {
                label.formula(&mut part.chars().peekable(), Level::Base, false);
            }
        }
        label
    }

    pub(super) fn is_empty(&self) -> bool {
        self.spans.is_empty()
    }

    fn push(&mut self, text: &str, slanted: bool, level: Level) {
        if text.is_empty() {
            return;
        }
        if let Some(last) = self.spans.last_mut()
            && last.slanted == slanted
            && last.level == level
        {
            last.text.push_str(text);
            return;
        }
        self.spans.push(Span { text: text.into(), slanted, level });
    }

    /// Reads a formula up to its end or to the brace that closes it.
    fn formula(
        &mut self,
        input: &mut core::iter::Peekable<core::str::Chars<'_>>,
        level: Level,
        upright: bool,
    ) {
        // A combining mark follows the letter that it stands on.
        let mut mark = "";
        while let Some(c) = input.next() {
            let mut text = match c {
                '}' => return,
                '{' => {
                    self.formula(input, level, upright);
                    continue;
                }
                '_' | '^' => {
                    let level = if c == '_' { Level::Sub } else { Level::Sup };
                    if input.next_if_eq(&'{').is_some() {
                        // A subscript that is a word is not a product of variables.
                        let word = input.clone().take_while(|c| *c != '}');
                        let word = word.clone().count() > 1
                            && word.clone().all(|c| c.is_ascii_alphabetic());
                        self.formula(input, level, upright || word);
                    } else if let Some(one) = input.next() {
                        self.formula(&mut one.to_string().chars().peekable(), level, upright);
                    }
                    continue;
                }
                '\\' => {
                    let mut name = String::new();
                    while let Some(letter) = input.next_if(char::is_ascii_alphabetic) {
                        name.push(letter);
                    }
                    if !name.is_empty() {
                        input.next_if_eq(&' ');
                    }
                    match name.as_str() {
                        "" => {
                            input.next();
                            "\u{2009}".to_string()
                        }
                        "mathrm" | "text" => {
                            input.next_if_eq(&'{');
                            self.formula(input, level, true);
                            continue;
                        }
                        "dot" => {
                            mark = "\u{307}";
                            continue;
                        }
                        "ddot" => {
                            mark = "\u{308}";
                            continue;
                        }
                        "tilde" => {
                            mark = "\u{303}";
                            continue;
                        }
                        "hat" => {
                            mark = "\u{302}";
                            continue;
                        }
                        "sin" | "cos" | "tan" | "ln" | "exp" | "max" | "min" => {
                            // Between thin spaces; a parenthesis follows closely.
                            let before = self.spans.last().and_then(|s| s.text.chars().last());
                            let mark = |c| ('\u{300}'..='\u{36f}').contains(&c);
                            if before.is_some_and(|c| c.is_alphanumeric() || mark(c)) {
                                self.push("\u{2009}", false, level);
                            }
                            self.push(&name, false, level);
                            let ahead: String = input.clone().take(2).collect();
                            if !ahead.is_empty()
                                && !ahead.starts_with(['(', '^', '_', '{'])
                                && ahead != r"\,"
                            {
                                self.push("\u{2009}", false, level);
                            }
                            continue;
                        }
                        _ => NAMES
                            .iter()
                            .find(|(n, _)| *n == name)
                            .map_or(name.clone(), |(_, glyph)| (*glyph).into()),
                    }
                }
                '-' => "\u{2212}".into(),
                // A slanted letter leans on a prime that follows closely.
                '\'' if self.spans.last().is_some_and(|s| s.slanted) => "\u{200a}\u{200a}′".into(),
                '\'' => "′".into(),
                ',' => ",\u{2009}".into(),
                // The same with a slash, which leans on an index.
                '/' if self.spans.last().is_some_and(|s| s.slanted || s.level != level) => {
                    "\u{200a}/".into()
                }
                ' ' if !upright => continue,
                '=' | '<' | '>' | '+' if level == Level::Base => format!("\u{2009}{c}\u{2009}"),
                c => c.to_string(),
            };
            let letter = text.chars().next().is_some_and(char::is_alphabetic);
            let capital_greek = text.chars().next().is_some_and(|c| ('Α'..='Ω').contains(&c));
            text.push_str(core::mem::take(&mut mark));
            self.push(&text, letter && !upright && !capital_greek, level);
        }
    }

    /// Width in px.
    pub(super) fn width(&self, size: f64) -> f64 {
        self.spans.iter().map(|span| width(&span.text, span.slanted) * span.scale() * size).sum()
    }

    /// What is drawn, in text of this size.
    pub(super) fn runs(&self, size: f64) -> Vec<Run> {
        let run = |span: &Span| {
            let drop = match span.level {
                Level::Base => 0.0,
                Level::Sub => 0.24 * size,
                Level::Sup => -0.36 * size,
            };
            Run { text: span.text.clone(), slanted: span.slanted, size: span.scale() * size, drop }
        };
        self.spans.iter().map(run).collect()
    }
}

/// The letters of a label, one after the other.
pub(crate) fn plain(text: &str) -> String {
    let label = Label::new(text);
    let spans = label.spans.iter().map(|span| &*span.text);
    spans.collect::<String>().replace('\u{2009}', " ").replace('\u{200a}', "")
}

/// Width of a text, parts of its size.
pub(super) fn width(text: &str, slanted: bool) -> f64 {
    let letters = text.chars().map(|c| u32::from(thousandths(c, slanted)));
    f64::from(letters.sum::<u32>()) / 1000.0
}

#[cfg(test)]
mod tests {
    use super::*;

    fn plain(label: &str) -> String {
        Label::new(label).spans.iter().map(|s| s.text.as_str()).collect()
    }

    #[test]
    fn formulas_become_glyphs() {
        assert_eq!(plain(r"$\theta$ / rad"), "θ / rad");
        assert_eq!(plain(r"$10^{-3}$"), "10\u{2212}3");
        assert_eq!(plain(r"$U_{\mathrm{eff}}(\theta)$"), "Ueff(θ)");
        assert_eq!(Label::new("$U_{eff}$"), Label::new(r"$U_{\mathrm{eff}}$"));
        assert_ne!(Label::new("$U_{1x}$"), Label::new(r"$U_{\mathrm{1x}}$"));
        assert_eq!(plain(r"$\tilde E$"), "E\u{303}");
        assert_eq!(plain(r"$\dot\phi$"), "φ\u{307}");
        assert_eq!(plain(r"$t'$"), "t\u{200a}\u{200a}′");
        assert_eq!(plain("a - b"), "a - b");
        assert_eq!(plain(r"$\cos\theta=b$"), "cos\u{2009}θ\u{2009}=\u{2009}b");
        assert_eq!(plain(r"$2h\tan\,x$"), "2h\u{2009}tan\u{2009}x");
        assert_eq!(plain(r"$\ell/2$"), "ℓ\u{200a}/2");
    }

    #[test]
    fn small_text_is_not_below_eleven_px() {
        const { assert!(SMALL * SIZE >= 11.0) };
    }
}
