//! What browsers do not take from a mathematics font, worked around in the MathML.

use crate::fonts;

/// Works around what browsers do not take from a mathematics font.
///
/// - Primes: the variants for superscripts are ignored; they get a class for the style sheet.
/// - Greek: one shape of each letter, in formulas as in text and figures.
/// - Script letters: the font has one shape, so the selector of a shape is dropped.
/// - Roots: the sign is as low as its content; a strut makes all of one line equally high.
/// - Accents: the point of attachment is ignored, so a dot over a slanted letter sits
///   too far left; it is moved by what the font says, and a dot lifted off its letter.
/// - Powers of a slanted letter run into it, and so does a function's name behind it: it gets the
///   width that the font gives it for them.
/// - Powers of an accented letter are raised by the accent; they belong where the letter's are.
/// - Fences: a stretchy one gets the width of its largest variant; around content
///   that is one line high it need not stretch.
pub fn mend(mathml: &str) -> String {
    let mut mended = mathml.replace('ϕ', "φ").replace('ϵ', "ε").replace('\u{fe00}', "");
    for prime in ['\u{2032}', '\u{2033}', '\u{2034}'] {
        mended = mended
            .replace(&format!("<mo>{prime}</mo>"), &format!("<mo class=\"prime\">{prime}</mo>"));
    }
    let mended = mended.replace("<msqrt>", &format!("<msqrt>{STRUT}"));
    powers(&leaning(&functions(&dots(&accents(&fences(&mended))))))
}

/// As high as a capital and as deep as a letter with a foot.
const STRUT: &str = "<mspace width=\"0\" height=\".76em\" depth=\".2em\"/>";

/// How far a dot is lifted, in em: at the font's own height it touches a theta.
const LIFT: f64 = 0.09;

/// Where the element ends with whose start tag `html` begins, called `tag`.
fn element_end(html: &str, tag: &str) -> Option<usize> {
    let (open, close) = (format!("<{tag}"), format!("</{tag}>"));
    let (mut depth, mut at) = (0, 0);
    loop {
        let next = html[at..].find(&close)?;
        depth += html[at..at + next].matches(&open).count();
        at += next + close.len();
        depth -= 1;
        if depth == 0 {
            return Some(at);
        }
    }
}

fn accents(mathml: &str) -> String {
    const OPEN: &str = "<mover accent=\"true\"><mi";
    let mut done = String::with_capacity(mathml.len());
    let mut rest = mathml;
    while let Some(at) = rest.find(OPEN) {
        let base = at + OPEN.len();
        done.push_str(&rest[..base]);
        rest = &rest[base..];
        // The rest of `<mi>`, the letter, and the accent's `<mo`.
        let Some((attributes, after)) = rest.split_once('>') else {
            break;
        };
        let Some((letter, accent)) = after.split_once("</mi><mo") else {
            break;
        };
        let mut letters = letter.chars();
        if let (Some(c), None) = (letters.next(), letters.next()) {
            let c = if attributes.is_empty() { italic(c) } else { c };
            let skew = fonts::skew(c).filter(|skew| skew.abs() > 0.005);
            done.push_str(&format!("{attributes}>{letter}</mi><mo"));
            if let Some(skew) = skew {
                done.push_str(&format!(" style=\"transform:translate({skew:.3}em)\""));
            }
            rest = accent;
        }
    }
    done + rest
}

/// Lifts the dots, those that are moved already and the others.
fn dots(mathml: &str) -> String {
    let mut done = mathml.to_owned();
    for dot in ['˙', '¨'] {
        let plain = format!("<mo>{dot}</mo></mover>");
        let lifted = format!("<mo style=\"transform:translate(0,-{LIFT}em)\">{dot}</mo></mover>");
        let moved = format!("em)\">{dot}</mo></mover>");
        let both = format!("em,-{LIFT}em)\">{dot}</mo></mover>");
        done = done.replace(&moved, &both).replace(&plain, &lifted);
    }
    done
}

/// Moves a power off the slanted letter that leans into it.
fn leaning(mathml: &str) -> String {
    const OPEN: &str = "<msup><mi>";
    let mut pieces = mathml.split(OPEN);
    let mut done = pieces.next().unwrap_or("").to_owned();
    for piece in pieces {
        let base = piece.split_once("</mi>");
        let single = base.and_then(|(base, rest)| Some((base.parse::<char>().ok()?, rest)));
        let lean = single.and_then(|(c, _)| fonts::overhang(italic(c)));
        match (single, lean) {
            (Some((c, rest)), Some(lean)) if lean > 0.02 => {
                let space = format!("<mspace width=\"{lean:.3}em\"/>");
                done += &format!("<msup><mrow><mi>{c}</mi>{space}</mrow>{rest}");
            }
            _ => done += &format!("{OPEN}{piece}"),
        }
    }
    done
}

/// Takes the accent out of the height that decides where a power stands.
fn powers(mathml: &str) -> String {
    let mut done = mathml.to_owned();
    for script in ["<msup>", "<msubsup>"] {
        let accented = format!("{script}<mover accent=\"true\">");
        let mut from = 0;
        while let Some(at) = done[from..].find(&accented) {
            let base = from + at + script.len();
            let Some(end) = element_end(&done[base..], "mover") else {
                break;
            };
            done.insert_str(base + end, "</mpadded>");
            done.insert_str(base, "<mpadded height=\".7em\">");
            from = base;
        }
    }
    done
}

/// Moves the name of a function off the slanted letter that leans into it: `T cos`.
fn functions(mathml: &str) -> String {
    const NAME: &str = "</mi><mo lspace=\"0.1667em\"";
    let mut pieces = mathml.split(NAME).peekable();
    let mut done = String::with_capacity(mathml.len());
    while let Some(piece) = pieces.next() {
        done += piece;
        if pieces.peek().is_none() {
            break;
        }
        let base = piece.rsplit_once("<mi>").map(|(_, base)| base);
        let lean = base
            .and_then(|base| base.parse::<char>().ok())
            .and_then(|c| fonts::overhang(italic(c)))
            .filter(|lean| *lean > 0.02);
        done += &match lean {
            Some(lean) => NAME.replacen("><", &format!("><mspace width=\"{lean:.3}em\"/><"), 1),
            None => NAME.to_owned(),
        };
    }
    done
}

/// The slanted letter that a browser shows for a single one in `<mi>`.
pub fn italic(c: char) -> char {
    let at = |first: u32, letter: char| char::from_u32(first + u32::from(c) - u32::from(letter));
    let slanted = match c {
        'h' => Some('\u{210e}'),
        'a'..='z' => at(0x1d44e, 'a'),
        'A'..='Z' => at(0x1d434, 'A'),
        'α'..='ω' => at(0x1d6fc, 'α'),
        'Α'..='Ω' => at(0x1d6e2, 'Α'),
        'ϵ' => Some('\u{1d716}'),
        'ϑ' => Some('\u{1d717}'),
        'ϕ' => Some('\u{1d719}'),
        _ => None,
    };
    slanted.unwrap_or(c)
}

fn fences(mathml: &str) -> String {
    const TALL: [&str; 6] = ["<mfrac", "<mtable", "<munder", "<msqrt", "<mroot", "largeop"];
    const SMALL: &str = "<mfrac displaystyle=\"false\">";
    let mut done = mathml.to_owned();
    let mut from = 0;
    while let Some(at) = done[from..].find("<mrow><mo>") {
        let row = from + at;
        let open = row + "<mrow>".len();
        from = open;
        let Some(length) = element_end(&done[row..], "mrow") else {
            return done;
        };
        let content = &done[open..row + length - "</mrow>".len()];
        let Some(last) = content.rfind("<mo>").filter(|&last| last > 0) else {
            continue;
        };
        if !content.ends_with("</mo>") {
            continue;
        }
        let tall = |content: &str| TALL.iter().any(|tag| content.contains(tag));
        let round = content.starts_with("<mo>(") && content.ends_with("<mo>)</mo>");
        let with = match (tall(content), tall(&content.replace(SMALL, ""))) {
            (false, _) => "<mo stretchy=\"false\">",
            (true, false) if round => "<mo class=\"fence small\">",
            (true, true) if round => "<mo class=\"fence\">",
            _ => continue,
        };
        done.replace_range(open + last..open + last + "<mo>".len(), with);
        done.replace_range(open..open + "<mo>".len(), with);
    }
    done
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::maths;

    #[test]
    fn browsers_are_helped() {
        let html = |tex: &str| maths::mathml(tex, false).map_err(|e| e.reason).unwrap_or_default();
        // The font attaches an accent of a slanted theta 0.0755 em right of its middle.
        let theta = html(r"\dot\theta");
        assert!(theta.contains("<mi>θ</mi><mo style=\"transform:translate(0.07"), "{theta}");
        let bold = html(r"\dot{\boldsymbol\omega}");
        assert!(bold.contains("translate(0.039em,-0.09em)"), "{bold}");
        let omega = html(r"\dot\Omega");
        assert!(omega.contains("translate(0,-0.09em)"), "{omega}");
        let hat = html(r"\hat\Omega");
        assert!(!hat.contains("translate"), "{hat}");
        for tex in [r"\dot\theta^2", r"\dot{\vec L}_1^2"] {
            let power = html(tex);
            let padded = "<mpadded height=\".7em\"><mover accent=\"true\">";
            assert!(power.contains(padded) && power.contains("</mover></mpadded>"), "{power}");
        }
        assert!(!html(r"\dot\theta + x^2").contains("mpadded"));
        // The font lets a slanted W lean out by 0.138 em, an x not at all.
        let power = html("W^2 + x^2");
        let led = "<msup><mrow><mi>W</mi><mspace width=\"0.1";
        assert!(power.contains(led) && power.contains("<msup><mi>x</mi>"), "{power}");
        let product = html(r"T \cos x + x \cos x");
        assert!(
            product.contains("<mi>T</mi><mspace width=\"0.1")
                && product.contains("<mi>x</mi><mo lspace=\"0.1667em\""),
            "{product}"
        );
        let script = html(r"\frac{\partial\mathcal L}{\partial x}");
        assert!(script.contains("<mi>ℒ</mi>"), "{script}");
        let root = html(r"\sqrt{\phi}");
        assert!(root.contains(&format!("<msqrt>{STRUT}<mi>φ</mi>")), "{root}");
        let low = html(r"\left(b - \left[c\right]\right)^2");
        assert_eq!(low.matches("<mo stretchy=\"false\">").count(), 4, "{low}");
        // A stretched one of round brackets has its width mended, by what it holds.
        let fences = [
            (r"\left(\frac{b}{c}\right)", "<mo class=\"fence\">"),
            (r"\left(\tfrac{b}{c}\right)", "<mo class=\"fence small\">"),
            (r"\left[\frac{b}{c}\right]", "<mo>"),
        ];
        for (tex, fence) in fences {
            let tall = html(tex);
            assert_eq!(tall.matches(fence).count(), 2, "{tall}");
            assert!(!tall.contains("stretchy"), "{tall}");
        }
    }

    #[test]
    fn a_sign_on_its_own_is_no_fence() {
        for alone in ["<mrow><mo>(</mo></mrow>", "<mrow><mo>(</mo><mi>x</mi></mrow>"] {
            assert_eq!(fences(alone), alone);
        }
    }

    #[test]
    fn single_letters_are_slanted() {
        let pairs = [
            ('a', '\u{1d44e}'),
            ('h', '\u{210e}'),
            ('z', '\u{1d467}'),
            ('A', '\u{1d434}'),
            ('Z', '\u{1d44d}'),
            ('α', '\u{1d6fc}'),
            ('ω', '\u{1d714}'),
            ('Α', '\u{1d6e2}'),
            ('Ω', '\u{1d6fa}'),
            ('ϵ', '\u{1d716}'),
            ('ϑ', '\u{1d717}'),
            ('ϕ', '\u{1d719}'),
            // What is no letter stays.
            ('1', '1'),
            ('+', '+'),
        ];
        for (upright, slanted) in pairs {
            assert_eq!(italic(upright), slanted, "{upright}");
        }
    }
}
