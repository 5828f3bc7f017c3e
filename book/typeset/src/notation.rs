//! Formulas in the cells of tables: what a report prints in plain letters, `m g l/L_z^2` or
//! `sqrt(a)`, is set as a formula on the page.
//!
//! A symbol is a Greek letter by its name (`theta`), a letter that stands alone (but not the
//! article, `a` or at the beginning `A`, nor `s`, the second), either with an index (`I1`,
//! `t_release`), primes or a tilde (`E~`), a differential (`dphi`), or a function (`sin`, `sqrt`).
//! The name of a test (`a_full_disk`) and a flag (`--csv`) are prose.
//! A formula is the longest row of symbols, numbers, signs and closed brackets that holds a symbol;
//! the rest is prose.

use crate::maths;
use crate::text::without_tags;
use crate::token::{Kind, Token, small, tokens};

/// A stroke in prose, with a space behind it or none, where the line is not broken.
const STROKES: [&str; 2] = ["/\u{a0}", "/"];

/// A cell of words as HTML, its formulas as MathML.
pub fn words(cell: &str) -> String {
    let tokens = tokens(cell, Kind::Space);
    let mut html = String::new();
    let mut at = 0;
    while at < tokens.len() {
        let end = formula_end(&tokens[at..]);
        let tex: String = tokens[at..at + end].iter().map(|t| t.tex.as_str()).collect();
        match maths::mathml(tex.trim(), false) {
            Ok(mathml) if end > 0 => {
                at += end;
                // A browser would break the line before a formula and before a comma.
                let comma = tokens.get(at).filter(|t| ",:;.".contains(&t.tex));
                let comma = comma.map_or("", |comma| &comma.html);
                at += usize::from(!comma.is_empty());
                let stroke = STROKES.into_iter().find(|stroke| html.ends_with(stroke));
                let sign = stroke.unwrap_or("");
                html.truncate(html.len() - sign.len());
                html += &match sign.len() + comma.len() {
                    0 => mathml,
                    _ => format!("<span class=\"glued\">{sign}{mathml}{comma}</span>"),
                };
            }
            _ => {
                html += &tokens[at].html;
                at += 1;
            }
        }
    }
    html
}

/// A cell of words as plain text, where no formula may stand: `phi at t' = 20` is `φ at t′ = 20`.
pub fn symbols(cell: &str) -> String {
    let tokens = tokens(cell, Kind::Space);
    let mut text = String::new();
    for (n, token) in tokens.iter().enumerate() {
        let plain = without_tags(&token.html).replace('\u{a0}', " ");
        text += &match n > 0 && tokens[n - 1].tex == "^" {
            true => small(&plain, "⁰¹²³⁴⁵⁶⁷⁸⁹").unwrap_or(format!("^{plain}")),
            false => plain,
        };
    }
    text
}

/// How many tokens from the first on are a formula; 0 if none.
fn formula_end(tokens: &[Token]) -> usize {
    let begins =
        |kind: Kind| matches!(kind, Kind::Symbol | Kind::Function | Kind::Number | Kind::Open);
    let starts = |token: &Token| match token.kind {
        kind if begins(kind) => true,
        Kind::Sign => token.tex == "-" && tokens.get(1).is_some_and(|t| begins(t.kind)),
        _ => false,
    };
    if !tokens.first().is_some_and(starts) {
        return 0;
    }
    let (mut depth, mut symbols, mut end) = (0, 0, 0);
    for (n, token) in tokens.iter().enumerate() {
        match token.kind {
            Kind::Open => depth += 1,
            Kind::Close if depth == 0 => break,
            Kind::Close => depth -= 1,
            Kind::Prose if token.tex != "," || depth == 0 => break,
            Kind::Symbol | Kind::Function => symbols += 1,
            _ => {}
        }
        let whole = matches!(token.kind, Kind::Symbol | Kind::Number | Kind::Close);
        if whole && depth == 0 && symbols > 0 {
            end = n + 1;
        }
    }
    end
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The formulas of a cell as TeX between bars, the prose as it is.
    fn read(cell: &str) -> String {
        let tokens = tokens(cell, Kind::Space);
        let (mut read, mut at) = (String::new(), 0);
        while at < tokens.len() {
            let end = formula_end(&tokens[at..]);
            let tex = |token: &Token| token.tex.replace(['{', '}', ' '], "");
            let formula: String = tokens[at..at + end].iter().map(tex).collect();
            read += &match end {
                0 => tokens[at].html.replace('\u{a0}', " "),
                _ => format!("|{}|", formula),
            };
            at += end.max(1);
        }
        read
    }

    #[test]
    fn formulas_are_told_from_prose() {
        let cases = [
            ("m g l/L_z", "|mgl/L_z|"),
            ("level at 1e4 rad/s: m g l/L_z", "level at 10<sup>4</sup> rad/s: |mgl/L_z|"),
            ("t_release/s", "|t_\\mathrmrelease|/s"),
            ("c/a = 1e-6: over c/sqrt(a)", "|c/a=10^-6|: over |c/\\sqrta|"),
            ("a thin disc, a = 2: a nod", "a thin disc, |a=2|: a nod"),
            (
                "A disc: rate of gear A, if A: a disc at A",
                "A disc: rate of gear |A|, if |A|: a disc at |A|",
            ),
            ("C = 2 A: E A of a", "|C=2A|: |EA| of a"),
            ("C - A of both", "|C-A| of both"),
            ("theta0 -> 0, a < b^2", "|\\theta_0\\to0|, |a<b^2|"),
            ("b to -b, one-sided, U''", "|b| to |-b|, one-sided, |U''|"),
            ("(b - cos(theta))/c", "|(b-\\cos(\\theta))/c|"),
            ("I_fork / I1 sin^2 theta", "|I_\\mathrmfork/I_1\\sin^2\\theta|"),
            ("torque x turn / L_z", "torque × turn / |L_z|"),
            ("mu m g l x turn", "|\\mumgl| × turn"),
            ("pull / (m g) at the floor", "pull / |(mg)| at the floor"),
            ("ln(8/(sqrt 6 + sqrt 5)): each", "|\\ln(8/(\\sqrt6+\\sqrt5))|: each"),
            ("W t_floor / sqrt(elevation)", "|Wt_\\mathrmfloor/\\sqrt\\textelevation|"),
            ("Omega_E / (dphi/dt)", "|\\Omega_E/(\\mathrmd\\phi/\\mathrmdt)|"),
            ("E~ - U_eff in φ", "|\\widetildeE-U_\\mathrmeff| in |\\phi|"),
            ("arccos(2/3), whatever", "|\\arccos(2/3)|, whatever"),
            (
                "the step's phase lacks (angle/2)^5/120",
                "the step’s phase lacks (angle/2)<sup>5</sup>/120",
            ),
            ("R.-C. Li, J. Phys. of L", "R.-C. Li, J. Phys. of |L|"),
            ("2^-53, below it", "2<sup>\u{2212}</sup><sup>53</sup>, below it"),
            ("SRKN 14a, RK4, ABA(10,4), spin-free", "SRKN 14a, RK4, ABA(10,4), spin-free"),
            ("4 kg/m, 100 s, 1.0 to -2", "4 kg/m, 100 s, 1.0 to −2"),
            (
                "1e-46 kg m^2, is 5e29 J, m = 2",
                "10<sup>−46</sup> kg m<sup>2</sup>, is 5\u{202f}×\u{202f}10<sup>29</sup> J, |m=2|",
            ),
            ("a tanh of 0.1 m/s, 3 m/n", "a tanh of 0.1 m/s, |3m/n|"),
            ("-(1 + b)/c, -2 cos(a), -3 at", "|-(1+b)/c|, |-2\\cos(a)|, −3 at"),
            ("at the end 2. Then (b", "at the end 2. Then (|b|"),
            ("heavy_top: x < 5", "heavy_top: |x<5|"),
            ("a_full_disk of a_disk", "a_full_disk of |a_\\mathrmdisk|"),
            ("--csv put a file (--half-angle)", "--csv put a file (--half-angle)"),
            ("b) + (c", "|b|) + (|c|"),
            ("4-5 to 6, a = 2. Then", "4-5 to 6, |a=2|. Then"),
        ];
        for (cell, expected) in cases {
            assert_eq!(read(cell), expected, "{cell}");
        }
    }

    #[test]
    fn symbols_are_written_where_no_formula_may_stand() {
        let cases = [
            ("phi at t' = 20, E~ < 3", "φ at t′ = 20, Ẽ < 3"),
            ("error of 2 (c/a) sin(theta0)", "error of 2 (c/a) sin(θ₀)"),
            ("delta, dphi/dt' of L_z^2/I12", "δ, dφ/dt′ of L_z²/I₁₂"),
            ("sqrt 6 + sqrt(5) of a", "√6 + √5 of a"),
            ("tanh^x(t) / sqrt(a), 1e-6", "tanh^x(t) / √a, 10−6"),
        ];
        for (cell, text) in cases {
            assert_eq!(symbols(cell), text.replace("Ẽ", "E\u{303}"), "{cell}");
        }
    }

    #[test]
    fn formulas_of_cells_are_understood() {
        let html = words("no weight: over c/sqrt(a), sin^2(theta) of 1e6");
        assert!(html.starts_with("no weight: over <span class=\"glued\"><math>"), "{html}");
        assert!(html.contains("<msqrt>") && html.contains("θ</mi>"), "{html}");
        assert!(html.ends_with("</math> of 10<sup>6</sup>"), "{html}");
        // Bars belong to what is between them.
        for bars in ["3 |I3 - I1| g/b", "|mu'|/lambda", "|L|"] {
            let html = words(bars);
            assert!(html.starts_with("<math>") && html.ends_with("</math>"), "{html}");
        }
        let html = words("year/|Omega|, |F_h| / mu N of |x");
        assert!(
            html.starts_with("year<span class=\"glued\">/<math>")
                && html.ends_with("|<math><mi>x</mi></math>"),
            "{html}"
        );
        // What stands under a root without brackets.
        let html = words("sqrt 6 b");
        assert!(html.contains("<mn>6</mn></msqrt>"), "{html}");
        let html = words("torque / m g l");
        assert!(html.starts_with("torque <span class=\"glued\">/\u{a0}<math>"), "{html}");
    }
}
