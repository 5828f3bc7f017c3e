//! The problem of a page, set for paper: the Markdown that pages use to state problems, with the
//! numbers of a student in place of the page's own.

use typeset::text::{escape, number_html, number_tex, unit_html};
use typeset::{figure, maths};

/// What a statement is set with.
pub struct Setting<'s> {
    pub stem: &'s str,
    /// Name, value, unit and meaning of each parameter.
    pub parameters: &'s [[String; 4]],
    /// The drawing of this name.
    pub figure: &'s dyn Fn(&str) -> Option<String>,
    /// Begins the identifiers in drawings, so that two sheets do not share them.
    pub prefix: &'s str,
    /// Where the book is.
    pub book: &'s str,
}

impl Setting<'_> {
    /// The statement as HTML.
    ///
    /// # Errors
    /// What cannot be set, in words.
    pub fn html(&self, problem: &str) -> Result<String, String> {
        let mut html = String::new();
        let mut blocks = problem.split("\n\n").map(str::trim).filter(|block| !block.is_empty());
        while let Some(block) = blocks.next() {
            if let Some(names) = directive(block, "figure") {
                let caption = blocks.next().ok_or("a figure has no caption")?;
                html += &self.figures(names, caption)?;
            } else if let Some(tex) = block.strip_prefix("$$") {
                html += &self.display(tex.trim_end_matches("$$"))?;
            } else if block.starts_with("> ") || block.starts_with("[^") || is_test(block) {
                // Where the notes slip, footnotes and tests are for the book's readers.
            } else if let Some(items) = list(block, |line| {
                let (number, item) = line.split_once(". ")?;
                number.bytes().all(|b| b.is_ascii_digit()).then_some(item)
            }) {
                html += &self.items("ol", &items)?;
            } else if let Some(items) = list(block, |line| line.strip_prefix("- ")) {
                html += &self.items("ul", &items)?;
            } else if block.starts_with(['#', '|', '<']) {
                let line = block.lines().next().unwrap_or("");
                return Err(format!("a problem sheet cannot set this: {line}"));
            } else {
                html += &format!("<p>{}</p>\n", self.line(block)?);
            }
        }
        Ok(html)
    }

    fn items(&self, tag: &str, items: &[&str]) -> Result<String, String> {
        let set = items.iter().map(|item| Ok(format!("<li>{}</li>", self.line(item)?)));
        let set: String = set.collect::<Result<_, String>>()?;
        Ok(format!("<{tag}>{set}</{tag}>\n"))
    }

    /// `STEM:NAME NAME …` and the paragraph below it.
    fn figures(&self, names: &str, caption: &str) -> Result<String, String> {
        let mut panels = String::new();
        for name in names.split_whitespace() {
            let own = name.strip_prefix(self.stem);
            let name = own.map_or(name, |name| name.trim_start_matches(':'));
            let svg = (self.figure)(name).ok_or(format!("{} draws no figure {name}", self.stem))?;
            panels += &figure::inline(&svg, &format!("{}-{name}-", self.prefix))?;
        }
        let caption = self.line(caption)?;
        Ok(format!(
            "<figure><div class=\"panels\">{panels}</div><figcaption>{caption}</figcaption></figure>\n"
        ))
    }

    fn display(&self, tex: &str) -> Result<String, String> {
        let tex = maths::prepare(&self.tex(tex)?)?.tex;
        Ok(format!("<p class=\"display\">{}</p>\n", mathml(&tex, true)?))
    }

    /// Text within a paragraph.
    fn line(&self, text: &str) -> Result<String, String> {
        let (mut html, mut rest, mut before) = (String::new(), text, ' ');
        while let Some(first) = rest.chars().next() {
            let mut taken = |open: &str, close: &str| {
                let inner = rest.strip_prefix(open)?;
                let end = inner.find(close).filter(|end| *end > 0)?;
                rest = &inner[end + close.len()..];
                Some(&inner[..end])
            };
            if let Some(tex) = taken("$", "$") {
                let set = mathml(&self.tex(tex)?, false)?;
                // What follows a formula closely stays with it.
                let after = rest.trim_start_matches([',', '.', ';', ':', '?', ')']);
                let close = &rest[..rest.len() - after.len()];
                html += &format!("<span class=\"glued\">{set}{close}</span>");
                (rest, before) = (after, ')');
            } else if let Some(inner) = taken("{{", "}}") {
                html += &self.number(inner, number_html)?;
                before = ')';
            } else if let Some(strong) = taken("**", "**") {
                html += &format!("<strong>{}</strong>", self.line(strong)?);
            } else if let Some(code) = taken("`", "`") {
                html += &format!("<code>{}</code>", escape(code));
            } else if let Some(stressed) = taken("*", "*") {
                html += &format!("<em>{}</em>", self.line(stressed)?);
            } else if taken("[^", "]").is_some() {
            } else if rest.starts_with('[')
                && let Some((text, after)) = rest[1..].split_once("](")
                && let Some((to, after)) = after.split_once(')')
            {
                html += &format!("<a href=\"{}\">{}</a>", escape(&self.link(to)), self.line(text)?);
                (rest, before) = (after, ')');
            } else {
                html += &match (first, before) {
                    ('"', ' ' | '\n' | '(') => "\u{201c}".into(),
                    ('"', _) => "\u{201d}".into(),
                    ('\'', _) => "\u{2019}".into(),
                    (other, _) => escape(&other.to_string()),
                };
                before = first;
                rest = &rest[first.len_utf8()..];
            }
        }
        Ok(html)
    }

    /// `16_2.md#part` is a page of the book.
    fn link(&self, to: &str) -> String {
        match to.split_once(".md") {
            Some((page, part)) if !to.contains("://") => format!("{}{page}.html{part}", self.book),
            _ if to.starts_with('#') => format!("{}{}.html{to}", self.book, self.stem),
            _ => to.to_owned(),
        }
    }

    /// TeX with its numbers put in.
    fn tex(&self, tex: &str) -> Result<String, String> {
        let (mut done, mut rest) = (String::new(), tex);
        while let Some((before, after)) = rest.split_once("{{") {
            let (inner, after) = after.split_once("}}").ok_or("{{ is not closed")?;
            done += before;
            match ["param ", "given ", "num "].iter().any(|kind| inner.starts_with(kind)) {
                true => done += &self.number(inner, |cell| Some(number_tex(cell)))?,
                // A group in a group is TeX's own.
                false => done += &format!("{{{{{inner}}}}}"),
            }
            rest = after;
        }
        Ok(done + rest)
    }

    /// `param STEM:NAME unit`, `given NUMBER`; a test says nothing on paper.
    fn number(&self, inner: &str, set: impl Fn(&str) -> Option<String>) -> Result<String, String> {
        let mut words = inner.split_whitespace();
        let kind = words.next().unwrap_or("");
        let (what, with_unit) = (words.next().unwrap_or(""), words.next().is_some());
        let wrong = || format!("a problem sheet cannot set {{{{{inner}}}}} of {}", self.stem);
        match kind {
            "test" => Ok(String::new()),
            "given" => set(what).ok_or_else(wrong),
            "param" => {
                let name = what.strip_prefix(self.stem).and_then(|name| name.strip_prefix(':'));
                let name = name.ok_or_else(wrong)?.split('@').next().unwrap_or("");
                let own = self.parameters.iter().find(|[own, ..]| own == name);
                let [_, value, unit, _] = own.ok_or_else(wrong)?;
                let value = set(value).unwrap_or_else(|| escape(value));
                if !with_unit {
                    return Ok(value);
                }
                Ok(format!("<span class=\"glued\">{value}\u{202f}{}</span>", unit_html(unit)))
            }
            // A result has no place in a problem.
            _ => Err(wrong()),
        }
    }
}

fn mathml(tex: &str, display: bool) -> Result<String, String> {
    maths::mathml(tex, display).map_err(|e| format!("TeX: {} in {tex}", e.reason))
}

/// What stands in a block `{{kind …}}`.
fn directive<'b>(block: &'b str, kind: &str) -> Option<&'b str> {
    let inner = block.strip_prefix("{{")?.strip_suffix("}}")?;
    inner.strip_prefix(kind).filter(|rest| rest.starts_with(' '))
}

fn is_test(block: &str) -> bool {
    directive(block, "test").is_some_and(|inner| !inner.contains("{{"))
}

/// The items of a list, one a line.
fn list<'b>(block: &'b str, item: impl Fn(&'b str) -> Option<&'b str>) -> Option<Vec<&'b str>> {
    block.lines().map(item).collect()
}

/// The names of the parameters that a problem states.
pub fn stated(problem: &str, stem: &str) -> Vec<String> {
    let open = format!("{{{{param {stem}:");
    let name = |piece: &str| piece.split(['}', ' ', '@']).next().unwrap_or("").to_owned();
    problem.split(&*open).skip(1).map(name).collect()
}
