//! The pieces of a cell of a table: symbols, numbers, signs, brackets and prose.

use crate::text::{escape, number_html, number_tex};

/// Greek letters as reports spell them; TeX spells them alike.
const GREEK: [(&str, char); 23] = [
    ("alpha", 'α'),
    ("beta", 'β'),
    ("gamma", 'γ'),
    ("delta", 'δ'),
    ("epsilon", 'ε'),
    ("zeta", 'ζ'),
    ("eta", 'η'),
    ("theta", 'θ'),
    ("kappa", 'κ'),
    ("lambda", 'λ'),
    ("mu", 'μ'),
    ("nu", 'ν'),
    ("xi", 'ξ'),
    ("rho", 'ρ'),
    ("sigma", 'σ'),
    ("tau", 'τ'),
    ("phi", 'φ'),
    ("chi", 'χ'),
    ("psi", 'ψ'),
    ("omega", 'ω'),
    ("pi", 'π'),
    ("Delta", 'Δ'),
    ("Omega", 'Ω'),
];

const FUNCTIONS: [&str; 9] =
    ["sin", "cos", "tan", "ln", "exp", "arcsin", "arccos", "arctan", "sqrt"];

/// Signs of more than one character, and `x` between spaces, with their shape and their TeX.
const SIGNS: [(&str, &str, &str); 4] =
    [("->", "→", "\\to "), ("<=", "≤", "\\le "), (">=", "≥", "\\ge "), ("x ", "× ", "\\times ")];

/// What a token may be part of.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Kind {
    /// A letter with what belongs to it.
    Symbol,
    /// A function's name, without its argument.
    Function,
    /// A number.
    Number,
    /// An operator or a relation.
    Sign,
    /// An opening bracket.
    Open,
    /// A closing bracket.
    Close,
    /// A space.
    Space,
    /// Anything else.
    Prose,
}

/// A piece of a cell: as it stands in a formula and as it stands in prose.
pub struct Token {
    /// What it may be part of.
    pub kind: Kind,
    /// As TeX.
    pub tex: String,
    /// As HTML in prose.
    pub html: String,
}

/// The tokens of a cell; `first` is what stands before it.
pub fn tokens(cell: &str, first: Kind) -> Vec<Token> {
    let mut tokens: Vec<Token> = Vec::new();
    let mut rest = cell;
    while let Some(c) = rest.chars().next() {
        let before = tokens.last().map_or(first, |token| token.kind);
        let sign = SIGNS.iter().find(|(sign, ..)| {
            rest.starts_with(sign)
                && (c != 'x'
                    || before == Kind::Space
                        && !tokens.is_empty()
                        && rest[1..].trim_start().starts_with(char::is_alphabetic)
                        // The axes x and z.
                        && !rest[1..].trim_start().starts_with("and "))
        });
        let (token, length) = if let Some((sign, html, tex)) = sign {
            (token(Kind::Sign, tex, (*html).into()), sign.len())
        } else if let Some(flag) = flag(rest, before) {
            (token(Kind::Prose, flag, escape(flag)), flag.len())
        } else if c.is_ascii_digit() {
            number(rest)
        } else if c.is_alphabetic() {
            let said = cell[..cell.len() - rest.len()].trim_end();
            let inside = said.ends_with(|c: char| c.is_alphanumeric() || c == '-');
            name(rest, before, inside)
        } else {
            let opens = matches!(before, Kind::Space | Kind::Open | Kind::Sign);
            let (kind, html) = match c {
                ' ' => (Kind::Space, " ".into()),
                '(' => (Kind::Open, "(".into()),
                ')' => (Kind::Close, ")".into()),
                // Bars stand in pairs.
                '|' if tokens.iter().filter(|token| token.tex == "|").count() % 2 == 0 => {
                    (Kind::Open, "|".into())
                }
                '|' => (Kind::Close, "|".into()),
                '-' if opens => (Kind::Sign, "\u{2212}".into()),
                '^' => (Kind::Sign, String::new()),
                '+' | '-' | '=' | '<' | '>' | '/' => (Kind::Sign, escape(&c.to_string())),
                '\'' => (Kind::Prose, "\u{2019}".into()),
                c => (Kind::Prose, escape(&c.to_string())),
            };
            (token(kind, &c.to_string(), html), c.len_utf8())
        };
        tokens.push(token);
        rest = &rest[length..];
    }
    // In prose a power is raised, and a line does not end with a stroke.
    for n in 1..tokens.len() {
        let after = &tokens[n - 1];
        let raised = after.tex == "^" || after.tex == "-" && n > 1 && tokens[n - 2].tex == "^";
        tokens[n].html = match tokens[n].kind {
            Kind::Number if raised => format!("<sup>{}</sup>", tokens[n].html),
            Kind::Sign if raised => format!("<sup>{}</sup>", tokens[n].html),
            Kind::Space if after.tex == "/" => "\u{a0}".into(),
            _ => continue,
        };
    }
    // The metre of `kg m^2` and of `0.1 m/s`, the joule of `5e29 J`.
    for n in 2..tokens.len() {
        let (before, spaced) = (&tokens[n - 2], tokens[n - 1].kind == Kind::Space);
        let unit = match tokens[n].tex.as_str() {
            "m " if before.kind == Kind::Number => {
                let after = tokens[n + 1..].iter().map(|token| token.tex.as_str());
                after.take(2).eq(["/", "s"])
            }
            "m " => before.tex == "kg",
            "J " => before.kind == Kind::Number,
            _ => false,
        };
        if spaced && unit {
            tokens[n].kind = Kind::Prose;
        }
    }
    tokens
}

fn token(kind: Kind, tex: &str, html: String) -> Token {
    Token { kind, tex: tex.to_owned(), html }
}

/// The flag of a program with which `text` begins: `--csv`.
fn flag(text: &str, before: Kind) -> Option<&str> {
    let name = text.strip_prefix("--")?;
    let inside = |c: char| c.is_alphanumeric() || c == '-';
    let end = name.find(|c: char| !inside(c)).unwrap_or(name.len());
    let opens = matches!(before, Kind::Space | Kind::Open);
    (opens && name.starts_with(char::is_alphabetic)).then(|| &text[..2 + end])
}

/// The number with which `text` begins: `0.25`, `1e-6`; not the `e` of `2 e`. With a letter behind
/// it, it is a word: `14a`.
fn number(text: &str) -> (Token, usize) {
    let digits = |from: usize| {
        let tail = &text[from..];
        from + tail.len() - tail.trim_start_matches(|c: char| c.is_ascii_digit()).len()
    };
    let mut end = digits(0);
    if text[end..].starts_with('.') && digits(end + 1) > end + 1 {
        end = digits(end + 1);
    }
    if let Some(exponent) = text[end..].strip_prefix('e') {
        let from = end + 1 + usize::from(exponent.starts_with('-'));
        if digits(from) > from {
            end = digits(from);
        }
    }
    let letters = text[end..].find(|c: char| !c.is_alphanumeric());
    let letters = letters.unwrap_or(text.len() - end);
    let word = &text[..end + letters];
    if letters > 0 {
        return (token(Kind::Prose, word, escape(word)), word.len());
    }
    let html = number_html(word).unwrap_or_else(|| escape(word));
    (token(Kind::Number, &number_tex(word), html), end)
}

/// The word with which `text` begins, and what belongs to it; `inside` a sentence, as it stands
/// after a word or a minus.
fn name(text: &str, before: Kind, inside: bool) -> (Token, usize) {
    let letters = text.find(|c: char| !c.is_alphabetic()).unwrap_or(text.len());
    let (word, after) = text.split_at(letters);
    // What has two strokes is the name of a test: `a_full_disk`.
    let end = text.find(|c: char| !c.is_alphanumeric() && c != '_');
    let named = text[..end.unwrap_or(text.len())].matches('_').count() > 1;
    if FUNCTIONS.contains(&word) && !named {
        return function(word, after);
    }
    let Some(letter) = letter(word, after, before, inside).filter(|_| !named) else {
        // A word keeps its hyphens, digits and strokes: `spin-free`, `RK4`, `heavy_top`, `kg/m`.
        let joined = |(n, c): (usize, char)| {
            let more = after[n + c.len_utf8()..].starts_with(char::is_alphabetic);
            !(c.is_alphanumeric() || c == '_' || matches!(c, '-' | '/' | '\'') && more)
        };
        let end = after.char_indices().find(|&at| joined(at));
        let end = letters + end.map_or(after.len(), |(n, _)| n);
        let word = &text[..end];
        let html = escape(word).replace('\'', "\u{2019}");
        return (token(Kind::Prose, word, html), end);
    };
    let mut tex = letter;
    let (d, after_d) = word.split_at(usize::from(word.starts_with('d')));
    let greek = |word: &str| GREEK.iter().find(|(name, _)| *name == word);
    let mut html = match (greek(word), greek(after_d)) {
        (Some((_, c)), _) => c.to_string(),
        (None, Some((_, c))) => format!("{d}{c}"),
        (None, None) => word.to_owned(),
    };
    let mut rest = after;
    if let Some(after) = rest.strip_prefix('~') {
        tex = format!("\\widetilde{{{tex}}}");
        html.push('\u{303}');
        rest = after;
    }
    let index = rest.strip_prefix('_').unwrap_or(rest);
    let end = match index.len() < rest.len() {
        true => index.find(|c: char| !c.is_alphanumeric()),
        false => index.find(|c: char| !c.is_ascii_digit()),
    };
    let (index, after) = index.split_at(end.unwrap_or(index.len()));
    if !index.is_empty() {
        tex += &match index.chars().count() {
            1 => format!("_{index}"),
            _ => format!("_{{\\mathrm{{{index}}}}}"),
        };
        html += &small(index, "₀₁₂₃₄₅₆₇₈₉").unwrap_or(format!("_{index}"));
        rest = after;
    }
    let primes = rest.len() - rest.trim_start_matches('\'').len();
    tex += &"'".repeat(primes);
    html += &"\u{2032}".repeat(primes);
    let length = text.len() - rest.len() + primes;
    // The space ends a command before the next letter.
    (token(Kind::Symbol, &format!("{tex} "), html), length)
}

/// Whether `word` is the name of a Greek letter.
pub fn is_greek(word: &str) -> bool {
    GREEK.iter().any(|(name, _)| *name == word)
}

/// The TeX of a word that is a letter: Greek, a differential, or one that stands alone.
fn letter(word: &str, after: &str, before: Kind, inside: bool) -> Option<String> {
    let greek = |word: &str| {
        let is = |(name, c): &&(&str, char)| *name == word || c.to_string() == word;
        GREEK.iter().find(is).map(|(name, _)| format!("\\{name}"))
    };
    let letters = word.chars().count();
    let differential = || match word.strip_prefix('d')? {
        "t" => Some("\\mathrm{d}t".to_owned()),
        letter => Some(format!("\\mathrm{{d}}{}", greek(letter)?)),
    };
    let sign = |c: char| "=/<>+^)".contains(c);
    let beside = matches!(before, Kind::Sign | Kind::Open)
        || after.trim_start().starts_with(sign)
        || after.starts_with(['_', '\'']);
    // The first letter of a name: `S. Blanes`, `R.-C. Li`.
    let next = after.strip_prefix(". ").or(after.strip_prefix(".-"));
    let initial = next.is_some_and(|next| next.starts_with(|c: char| c.is_ascii_uppercase()));
    let alone = match word {
        _ if initial => false,
        // The second, and the article, of which a capital one begins a sentence.
        "s" => false,
        "a" => beside,
        "A" => beside || inside,
        _ => letters == 1 && word.is_ascii(),
    };
    greek(word).or_else(differential).or_else(|| alone.then(|| word.to_owned()))
}

/// A function's name, a root with what is under it.
fn function(word: &str, after: &str) -> (Token, usize) {
    let tex = format!("\\{word}");
    if word != "sqrt" {
        let html = word.to_owned();
        return (token(Kind::Function, &tex, html), word.len());
    }
    let (inside, length) = match after.strip_prefix('(') {
        Some(inside) => match closing(inside) {
            Some(end) => (&inside[..end], end + 2),
            None => ("", 0),
        },
        None => {
            let inside = after.trim_start();
            let end = inside.find(|c: char| !c.is_alphanumeric());
            let inside = &inside[..end.unwrap_or(inside.len())];
            (inside, after.len() - after.trim_start().len() + inside.len())
        }
    };
    let under: String = tokens(inside, Kind::Open)
        .iter()
        .map(|token| match token.kind {
            Kind::Prose => format!("\\text{{{}}}", token.tex),
            _ => token.tex.clone(),
        })
        .collect();
    let html = format!("√{}", escape(inside));
    let tex = format!("\\sqrt{{{under}}}");
    (token(Kind::Symbol, &tex, html), word.len() + length)
}

/// Where the bracket is closed in which `text` begins.
fn closing(text: &str) -> Option<usize> {
    let mut depth = 1;
    text.char_indices().find_map(|(n, c)| {
        depth += i32::from(c == '(') - i32::from(c == ')');
        (depth == 0).then_some(n)
    })
}

/// Digits in another shape; `None` if there is something else among them.
pub fn small(text: &str, shapes: &str) -> Option<String> {
    let shape = |c: char| shapes.chars().nth(c.to_digit(10)? as usize);
    text.chars().map(shape).collect()
}
