//! The colours of listings: spans of four classes, which the style sheets colour.

use crate::text::{escape, unescape};
use ra_ap_rustc_lexer::{FrontmatterAllowed, LiteralKind, TokenKind, tokenize};

/// How mdBook begins a listing; its language follows.
const LISTING: &str = "<pre><code class=\"language-";

/// Rust's keywords and plain types.
const KEYWORDS: [&str; 53] = [
    "as", "async", "await", "bool", "break", "char", "const", "continue", "crate", "dyn", "else",
    "enum", "extern", "f32", "f64", "fn", "for", "i8", "i16", "i32", "i64", "i128", "if", "impl",
    "in", "isize", "let", "loop", "match", "mod", "move", "mut", "pub", "ref", "return", "self",
    "Self", "static", "str", "struct", "super", "trait", "type", "u8", "u16", "u32", "u64", "u128",
    "unsafe", "use", "usize", "where", "while",
];

/// A page with its listings coloured.
pub fn listings(html: &str) -> String {
    let mut parts = html.split(LISTING);
    let mut done = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        done += LISTING;
        let end = part.find("</code>").unwrap_or(part.len());
        let (listing, rest) = part.split_at(end);
        done += &coloured(listing).unwrap_or_else(|| listing.to_owned());
        done += rest;
    }
    done
}

/// A listing from its language on; `None` if it stays plain.
fn coloured(listing: &str) -> Option<String> {
    let (classes, code) = listing.split_once('>')?;
    let language = classes.split([' ', '"']).next()?;
    let colour = match language {
        "rust" => rust,
        "sh" | "bash" | "toml" => shell,
        "console" => console,
        _ => return None,
    };
    // mdBook's own tags hide lines.
    let plain = !code.contains('<');
    plain.then(|| format!("{classes}>{}", colour(&unescape(code))))
}

/// Rust as HTML. No span goes beyond a line, so that lines may be numbered one by one.
pub fn rust(code: &str) -> String {
    spans(code, |kind, text| match kind {
        TokenKind::LineComment { .. } | TokenKind::BlockComment { .. } => "comment",
        TokenKind::Ident if KEYWORDS.contains(&text) => "keyword",
        _ => literal(kind, text),
    })
}

/// Commands and settings: their literals are written as in Rust, their comments begin with `#`.
fn shell(code: &str) -> String {
    let line = |line: &str| {
        let comment = match line.starts_with('#') {
            true => Some(0),
            false => line.find(" #"),
        };
        let (before, comment) = line.split_at(comment.unwrap_or(line.len()));
        spans(before, literal) + &span("comment", comment)
    };
    code.split_inclusive('\n').map(line).collect()
}

/// What a terminal shows: only behind a prompt is a command, all else is output.
fn console(text: &str) -> String {
    let line = |line: &str| match line.strip_prefix("$ ") {
        Some(command) => span("comment", "$ ") + &shell(command),
        None => escape(line),
    };
    text.split_inclusive('\n').map(line).collect()
}

fn literal(kind: TokenKind, text: &str) -> &'static str {
    match kind {
        TokenKind::Literal {
            kind: LiteralKind::Int { .. } | LiteralKind::Float { .. }, ..
        } => "number",
        TokenKind::Literal { .. } => "string",
        TokenKind::Ident if matches!(text, "true" | "false") => "number",
        _ => "",
    }
}

/// The tokens of `code`, each of the class that `class` gives.
fn spans(code: &str, class: impl Fn(TokenKind, &str) -> &'static str) -> String {
    let mut html = String::new();
    let mut rest = code;
    for token in tokenize(code, FrontmatterAllowed::No) {
        let (text, after) = rest.split_at(token.len as usize);
        html += &span(class(token.kind, text), text);
        rest = after;
    }
    html
}

/// `text` in spans of one class, one for each of its lines.
fn span(class: &str, text: &str) -> String {
    let line = |line: &str| {
        let (line, end) = line.split_at(line.trim_end_matches('\n').len());
        match class.is_empty() || line.is_empty() {
            true => escape(line) + end,
            false => format!("<span class=\"{class}\">{}</span>{end}", escape(line)),
        }
    };
    text.split_inclusive('\n').map(line).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::text::without_tags;
    use std::fs;
    use std::path::{Path, PathBuf};

    fn sources(directory: &Path) -> Vec<PathBuf> {
        let entries = fs::read_dir(directory).expect("a directory").flatten();
        let paths = entries.flat_map(|entry| match entry.path() {
            path if path.is_dir() => sources(&path),
            path => vec![path],
        });
        paths.filter(|path| path.extension().is_some_and(|end| end == "rs")).collect()
    }

    /// Whether the HTML of a source says what it says, each line of it by itself.
    fn whole(html: &str, source: &str) -> bool {
        let closed = |line: &str| line.matches("<span").count() == line.matches("</span>").count();
        without_tags(html) == source && html.lines().all(closed)
    }

    #[test]
    fn every_example_keeps_its_text() {
        let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
        let sources = sources(&examples);
        assert!(sources.len() > 50);
        for path in sources {
            let source = fs::read_to_string(&path).expect("a source");
            assert!(whole(&rust(&source), &source), "{}", path.display());
        }
        // Parts of sources are listings, too.
        for part in ["/* a\nb", "\"a\n\"b", "r#\"a\n", "'", "#![", "é≤'ab \0"] {
            assert!(whole(&rust(part), part), "{part}");
        }
        // The damaged twins: a bracket that is not escaped, a span over two lines.
        assert!(!whole("Vec<f64>", "Vec<f64>"));
        assert!(!whole("<span class=\"string\">a\nb</span>", "a\nb"));
    }

    #[test]
    fn tokens_have_their_classes() {
        let of = |html: &str, text: &str| {
            let (before, _) = html.split_once(&format!(">{text}</span>"))?;
            let (_, class) = before.rsplit_once("<span class=\"")?;
            Some(class.trim_end_matches('"').to_owned())
        };
        let page = |language: &str, code: &str| {
            let code = escape(code);
            let page = format!("{LISTING}{language} x\">{code}</code></pre><code>let</code>");
            listings(&page)
        };
        let code = "/// Of 'a.\nlet s: &str = \"let 1\"; s == 1.5e-3_f64 && true";
        let html = page("rust", code);
        for (text, class) in [
            ("/// Of 'a.", "comment"),
            ("let", "keyword"),
            ("str", "keyword"),
            ("&quot;let 1&quot;", "string"),
            ("1.5e-3_f64", "number"),
            ("true", "number"),
        ] {
            assert_eq!(of(&html, text).as_deref(), Some(class), "{text}: {html}");
        }
        assert_eq!(of(&html, "s"), None);
        let shell = page("sh", "let --b -0.8 'x' \"y\" a#1 # 2");
        assert_eq!(of(&shell, "let"), None);
        assert_eq!(of(&shell, "0.8").as_deref(), Some("number"));
        assert_eq!(of(&shell, "&quot;y&quot;").as_deref(), Some("string"));
        assert_eq!(of(&shell, " # 2").as_deref(), Some("comment"));
        let told = page("console", "$ cargo test 2\n2 passed");
        assert_eq!(of(&told, "$ ").as_deref(), Some("comment"));
        assert_eq!(told.matches("number").count(), 1);
        // The damaged twins: another language, hidden lines.
        for (language, code) in [("text", "let x = 1;"), ("rust", "<span>let</span>")] {
            let page = format!("{LISTING}{language}\">{code}</code></pre>");
            assert_eq!(listings(&page), page);
        }
    }
}
