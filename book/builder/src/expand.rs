//! A page's Markdown with its directives and formulas turned into what mdBook can
//! read: plain Markdown, HTML, and marks ([`Splice`]) to be filled later.
//!
//! It walks the text once and knows only what it must: fenced code, code spans,
//! comments, `$…$`, `$$…$$`, `\eqref{…}` and `{{…}}`. Everything else is copied.

use crate::directive::{self, Directive};
use crate::figure::{self, Row};
use crate::lint;
use crate::maths::{self, Refused};
use crate::problem::Problem;
use crate::project::Project;
use crate::splice::Splice;
use crate::spoken;
use crate::text;
use std::collections::BTreeMap;

/// Where a labelled equation stands.
#[derive(Debug, Clone, PartialEq)]
pub struct Target {
    /// The page's address, relative to the root of the book.
    pub page: String,
    /// Its number.
    pub tag: String,
    /// File and line of the label.
    pub place: (String, usize),
}

/// The labelled equations of all pages.
pub type Labels = BTreeMap<String, Target>;

/// The identifier of the equation labelled `label`.
pub fn equation_id(label: &str) -> String {
    label.replace([':', ' '], "-")
}

/// A page being expanded.
pub struct Page<'a> {
    /// The files that directives name.
    pub project: &'a Project,
    /// The source, relative to the project's root.
    pub file: &'a str,
    /// The page's address.
    pub address: &'a str,
    /// The equations that `\eqref` can name.
    pub labels: &'a Labels,
    /// The equations found on this page.
    pub found: Labels,
    /// The examples whose figures, numbers or code the page uses.
    pub stems: Vec<String>,
    /// The files that tests are linked to.
    pub sources: Vec<String>,
    /// How many figures there are so far.
    figures: usize,
    /// How many numbers and ticks open a proof so far.
    proofs: usize,
    /// What is wrong.
    pub problems: Vec<Problem>,
}

impl<'a> Page<'a> {
    /// The page `file`, to be shown at `address`.
    pub fn new(project: &'a Project, file: &'a str, address: &'a str, labels: &'a Labels) -> Self {
        Self {
            project,
            file,
            address,
            labels,
            found: Labels::new(),
            stems: Vec::new(),
            sources: Vec::new(),
            figures: 0,
            proofs: 0,
            problems: Vec::new(),
        }
    }

    /// Notes a problem.
    pub fn problem(&mut self, line: usize, message: impl Into<String>) {
        self.problems.push(Problem::new(self.file, line, message));
    }

    /// What shows `html` and opens `proof`, a mark; `kind` is its class.
    pub fn proof(&mut self, kind: &str, html: String, proof: String) -> String {
        self.proofs += 1;
        let page = self.address.trim_end_matches(".html").replace('/', "-");
        let text = match kind {
            "num" => text::without_tags(&html),
            _ => String::new(),
        };
        Splice::Proof {
            kind: kind.into(),
            id: format!("proof-{page}-{}", self.proofs),
            html,
            proof,
        }
        .mark(&text)
    }

    /// The next figure of the page; `player`: whose moving figure it is, the mark of
    /// what plays it.
    pub fn row(
        &mut self,
        panels: &[(String, String)],
        player: Option<(&str, &str)>,
        caption: &str,
        indent: &str,
        id: &str,
    ) -> String {
        self.figures += 1;
        figure::row(&Row { number: self.figures, panels, player, caption, indent, id })
    }

    /// The Markdown for mdBook; `first` is the number of its first line.
    pub fn expand(&mut self, source: &str, first: usize) -> String {
        let mut walk = Walk {
            source,
            at: 0,
            first,
            out: String::with_capacity(2 * source.len()),
            prose: String::with_capacity(source.len()),
        };
        while walk.at < source.len() {
            self.step(&mut walk);
        }
        for (line, number) in lint::bare_numbers(&walk.prose) {
            self.problem(
                first + line,
                format!(
                    "{number} is typed, not computed: use {{{{num STEM:KEY}}}} for a result, \
                     {{{{given {number}}}}} for what is given"
                ),
            );
        }
        walk.out
    }

    fn step(&mut self, walk: &mut Walk) {
        if walk.at_line_start() && (self.fence(walk) || self.block(walk)) {
            return;
        }
        let rest = walk.rest();
        if rest.starts_with("<!--") {
            let length = rest.find("-->").map_or(rest.len(), |end| end + 3);
            walk.copy(length);
        } else if rest.starts_with('`') {
            self.code_span(walk);
        } else if rest.starts_with("\\$") {
            self.problem(walk.line_number(), "a dollar sign is a formula's; write the word");
            walk.skip(2);
        } else if rest.starts_with("\\eqref{") {
            self.reference(walk);
        } else if rest.starts_with("$$") {
            self.display(walk);
        } else if rest.starts_with('$') {
            self.inline(walk);
        } else if rest.starts_with("{{") {
            self.within_line(walk);
        } else if let Some(c) = rest.chars().next() {
            walk.out.push(c);
            walk.prose.push(c);
            walk.at += c.len_utf8();
        }
    }

    /// A fenced code block, copied with the numbers in it.
    fn fence(&mut self, walk: &mut Walk) -> bool {
        let line = walk.line();
        let marker = line.trim_start_matches([' ', '>']);
        let Some(kind) = marker.chars().next().filter(|&c| c == '`' || c == '~') else {
            return false;
        };
        let width = marker.len() - marker.trim_start_matches(kind).len();
        if width < 3 {
            return false;
        }
        let mut end = line.len() + 1;
        for inner in walk.rest().split_inclusive('\n').skip(1) {
            end += inner.len();
            let mark = inner.trim_start_matches([' ', '>']).trim_end();
            if mark.len() >= width && mark.chars().all(|c| c == kind) {
                break;
            }
        }
        let end = end.min(walk.rest().len());
        let code = walk.rest()[..end].to_owned();
        let code = self.numbers_in_code(&code, walk.line_number());
        walk.replace(end, &code);
        true
    }

    /// A directive that has its line for itself.
    fn block(&mut self, walk: &mut Walk) -> bool {
        let line = walk.line().to_owned();
        let trimmed = line.trim_start_matches([' ', '>']);
        let indent = line[..line.len() - trimmed.len()].to_owned();
        let number = walk.line_number();
        let Some(inner) = trimmed
            .trim_end()
            .strip_prefix("{{")
            .and_then(|rest| rest.strip_suffix("}}"))
            .filter(|inner| !inner.contains("}}"))
        else {
            return false;
        };
        let directive = match Directive::read(inner) {
            Ok(directive) if directive.is_block() => directive,
            Ok(_) => return false,
            Err(message) => {
                self.problem(number, message);
                walk.skip(line.len());
                return true;
            }
        };
        walk.skip(line.len());
        let caption = directive.has_caption().then(|| walk.take_paragraph());
        if let Some((caption_line, text)) = &caption {
            let text = text.trim_start_matches([' ', '>']);
            if text.is_empty() || text.starts_with(['#', '|']) || text.starts_with("{{") {
                self.problem(*caption_line, "a figure is followed by a paragraph, its caption");
            } else if !text.starts_with("**") {
                self.problem(
                    *caption_line,
                    "a caption begins with what the figure shows, in bold: **…**",
                );
            }
        }
        let caption = caption.map(|(line, text)| self.expand(&text, line));
        let caption = caption.unwrap_or_default();
        match directive::block(self, &directive, caption.trim(), &indent) {
            Ok(markdown) => walk.out.push_str(&markdown),
            Err(message) => self.problem(number, message),
        }
        true
    }

    fn code_span(&mut self, walk: &mut Walk) {
        let rest = walk.rest();
        let width = rest.len() - rest.trim_start_matches('`').len();
        let ticks = &rest[..width];
        let mut from = width;
        while let Some(close) = rest[from..].find(ticks) {
            let close = from + close;
            let run = rest[close..].len() - rest[close..].trim_start_matches('`').len();
            if run == width {
                let code = rest[..close + width].to_owned();
                let length = code.len();
                let code = self.numbers_in_code(&code, walk.line_number());
                walk.replace(length, &code);
                return;
            }
            from = close + run;
        }
        walk.copy(width);
    }

    /// Code with each `{{num …}}` and `{{param …}}` replaced; other braces are the code's own.
    fn numbers_in_code(&mut self, code: &str, line: usize) -> String {
        let mut done = String::new();
        let mut rest = code;
        let next =
            |text: &str| [text.find("{{num "), text.find("{{param ")].into_iter().flatten().min();
        while let Some(at) = next(rest) {
            // What is not closed is the code's own.
            let Some(end) = rest[at..].find("}}") else {
                break;
            };
            done.push_str(&rest[..at]);
            let inner = &rest[at + 2..at + end];
            let line = line + code[..code.len() - rest.len() + at].matches('\n').count();
            match Directive::read(inner).and_then(|d| directive::plain(self, &d)) {
                Ok(value) => done.push_str(&value),
                Err(message) => self.problem(line, message),
            }
            rest = &rest[at + end + 2..];
        }
        done + rest
    }

    fn reference(&mut self, walk: &mut Walk) {
        let line = walk.line_number();
        let rest = walk.rest();
        let Some(end) = rest.find('}') else {
            self.problem(line, "\\eqref{ is not closed");
            walk.copy("\\eqref{".len());
            return;
        };
        let label = rest["\\eqref{".len()..end].to_owned();
        let link = self.equation_link(&label, line);
        walk.replace(end + 1, &link);
    }

    fn equation_link(&mut self, label: &str, line: usize) -> String {
        let Some(target) = self.labels.get(label) else {
            let known: Vec<&str> = self.labels.keys().map(String::as_str).collect();
            self.problem(
                line,
                format!("no equation is labelled '{label}'; labelled are: {}", known.join(", ")),
            );
            return String::new();
        };
        let page = if target.page == self.address { "" } else { &target.page };
        format!(
            "<a class=\"eqref\" href=\"{page}#{}\">{}</a>",
            equation_id(label),
            text::tag_html(&target.tag)
        )
    }

    /// TeX with its directives replaced, and linted for typed results.
    fn tex(&mut self, tex: &str, line: usize) -> String {
        for (n, number) in lint::bare_numbers(&without_directives(tex)) {
            self.problem(
                line + n,
                format!(
                    "{number} is typed in a formula, not computed: use {{{{num STEM:KEY}}}} for a \
                     result, {{{{given {number}}}}} for what is given"
                ),
            );
        }
        if let Some(d) = lint::slanted_differential(tex) {
            self.problem(
                line,
                format!("the d of a differential stands upright: \\mathrm{{d}}, not {d}"),
            );
        }
        let mut done = String::new();
        let mut rest = tex;
        while let Some(at) = rest.find("{{") {
            // A group in a group is TeX's own.
            let end = rest[at..].find("}}");
            let inner = end.map(|end| &rest[at + 2..at + end]);
            let directive = inner.filter(|i| is_number(i));
            let (Some(end), Some(inner)) = (end, directive) else {
                done.push_str(&rest[..at + 1]);
                rest = &rest[at + 1..];
                continue;
            };
            done.push_str(&rest[..at]);
            match Directive::read(inner).and_then(|d| directive::tex(self, &d)) {
                Ok(value) => done.push_str(&value),
                Err(message) => self.problem(line, message),
            }
            rest = &rest[at + end + 2..];
        }
        done + rest
    }

    fn refused(&mut self, tex: &str, refused: &Refused, line: usize) {
        let before = tex.get(..refused.at).unwrap_or(tex);
        let line = line + before.matches('\n').count();
        let near: String = tex[before.len()..].trim_start().chars().take(24).collect();
        self.problem(line, format!("TeX: {} Near: {near}", refused.reason.trim_end()));
    }

    fn display(&mut self, walk: &mut Walk) {
        let line = walk.line_number();
        let indent = walk.indent().to_owned();
        let rest = walk.rest();
        let Some(end) = rest[2..].find("$$") else {
            self.problem(line, "$$ is not closed");
            walk.skip(rest.len());
            return;
        };
        let mut tex = rest[2..2 + end].to_owned();
        let length = end + 4;
        if !indent.trim().is_empty() {
            // In a quotation every line begins with `>`.
            tex = tex.replace(&format!("\n{}", indent.trim_end()), "\n");
        }
        if tex.contains("\n\n") {
            self.problem(line, "a blank line inside $$…$$");
        }
        let tex = self.tex(&tex, line);
        walk.prose.push_str(&"\n".repeat(tex.matches('\n').count()));
        walk.at += length;
        let prepared = match maths::prepare(&tex) {
            Ok(prepared) => prepared,
            Err(message) => return self.problem(line, message),
        };
        if let Err(refused) = maths::mathml(&prepared.tex, true) {
            return self.refused(&prepared.tex, &refused, line);
        }
        let text_form = spoken::text(&prepared.tex);
        if let Some(label) = &prepared.label {
            match &prepared.tag {
                None => self.problem(line, format!("\\label{{{label}}} needs a \\tag{{…}}")),
                Some(tag) => {
                    let target = Target {
                        page: self.address.to_owned(),
                        tag: tag.clone(),
                        place: (self.file.to_owned(), line),
                    };
                    if let Some(other) = self.found.insert(label.clone(), target) {
                        let (file, other) = other.place;
                        self.problem(
                            line,
                            format!("the label '{label}' is taken at {file}:{other}"),
                        );
                    }
                }
            }
        }
        let splice = Splice::Display {
            tex: prepared.tex,
            tag: prepared.tag,
            id: prepared.label.map(|label| equation_id(&label)),
            boxed: prepared.boxed,
        };
        walk.out.push_str(&splice.mark(&text_form));
    }

    fn inline(&mut self, walk: &mut Walk) {
        let line = walk.line_number();
        let rest = walk.rest();
        let paragraph = rest.find("\n\n").unwrap_or(rest.len());
        let Some(end) = rest[1..paragraph].find('$') else {
            self.problem(line, "a formula that $ opens is not closed in its paragraph");
            walk.skip(1);
            return;
        };
        let tex = rest[1..1 + end].to_owned();
        let feeds = tex.matches('\n').count();
        walk.at += end + 2;
        walk.prose.push_str(&"\n".repeat(feeds));
        let tex = self.tex(&tex, line);
        match maths::mathml(&tex, false) {
            Ok(_) => {
                let spoken = spoken::text(&tex);
                let mark = Splice::Inline { tex }.mark(&spoken);
                walk.glued(&mark);
            }
            Err(refused) => self.refused(&tex, &refused, line),
        }
    }

    /// A directive in a line of text.
    fn within_line(&mut self, walk: &mut Walk) {
        let line = walk.line_number();
        let rest = walk.rest();
        let Some(end) = rest.find("}}") else {
            self.problem(line, "{{ is not closed");
            walk.skip(2);
            return;
        };
        let inner = rest[2..end].to_owned();
        walk.at += end + 2;
        match Directive::read(&inner).and_then(|d| directive::inline(self, &d)) {
            Ok(html) if html.contains("data-splice") => walk.glued(&html),
            Ok(html) => walk.out.push_str(&html),
            Err(message) => self.problem(line, message),
        }
    }
}

/// Whether a directive gives a number that may stand in a formula.
fn is_number(inner: &str) -> bool {
    ["num ", "param ", "given "].iter().any(|kind| inner.starts_with(kind))
}

fn without_directives(tex: &str) -> String {
    let mut rest = tex;
    let mut kept = String::new();
    while let Some((before, after)) = rest.split_once("{{") {
        kept.push_str(before);
        match after.split_once("}}") {
            Some((inner, after)) if is_number(inner) => rest = after,
            _ => rest = after,
        }
    }
    // The notes' numbers of equations are not results.
    kept.push_str(rest);
    while let Some(at) = kept.find("\\tag{") {
        let end = kept[at..].find('}').map_or(kept.len(), |end| at + end + 1);
        kept.replace_range(at..end, "");
    }
    kept
}

/// A position in a page's source, and what has been written so far.
struct Walk<'s> {
    source: &'s str,
    at: usize,
    first: usize,
    out: String,
    /// The text that is neither code nor formula nor directive, with every line feed.
    prose: String,
}

impl<'s> Walk<'s> {
    fn rest(&self) -> &'s str {
        &self.source[self.at..]
    }

    fn line(&self) -> &'s str {
        self.rest().lines().next().unwrap_or("")
    }

    fn line_number(&self) -> usize {
        self.first + self.source[..self.at].matches('\n').count()
    }

    fn at_line_start(&self) -> bool {
        self.at == 0 || self.source.as_bytes()[self.at - 1] == b'\n'
    }

    /// What stands before the position in its line.
    fn indent(&self) -> &'s str {
        let start = self.source[..self.at].rfind('\n').map_or(0, |n| n + 1);
        let before = &self.source[start..self.at];
        if before.trim_start_matches([' ', '>']).is_empty() { before } else { "" }
    }

    /// Goes on without writing, but keeps the count of lines.
    fn skip(&mut self, length: usize) {
        let skipped = &self.rest()[..length];
        self.prose.push_str(&"\n".repeat(skipped.matches('\n').count()));
        self.at += length;
    }

    /// Writes as it stands what is not prose.
    fn copy(&mut self, length: usize) {
        let copied = &self.rest()[..length];
        self.out.push_str(copied);
        self.skip(length);
    }

    /// Writes what must not be parted from the punctuation around it: a browser may
    /// break a line before and after a formula.
    fn glued(&mut self, mark: &str) {
        let mut before = String::new();
        while let Some(c) = self.out.chars().last().filter(|&c| "([\u{201c}".contains(c)) {
            // `[` may open a link.
            if c == '[' {
                break;
            }
            self.out.pop();
            before.insert(0, c);
        }
        let rest = self.rest();
        let after = rest.len() - rest.trim_start_matches([',', '.', ';', ':', '!', '?', ')']).len();
        let after = &rest[..after];
        if before.is_empty() && after.is_empty() {
            self.out.push_str(mark);
        } else {
            self.out.push_str(&format!("<span class=\"glued\">{before}{mark}{after}</span>"));
        }
        self.at += after.len();
        self.prose.push_str(after);
    }

    fn replace(&mut self, length: usize, with: &str) {
        self.out.push_str(with);
        self.skip(length);
    }

    /// The next paragraph, taken out of the text, and the line where it begins.
    fn take_paragraph(&mut self) -> (usize, String) {
        let blank = self.rest().len() - self.rest().trim_start_matches('\n').len();
        self.skip(blank);
        let number = self.line_number();
        let length = self.rest().find("\n\n").unwrap_or(self.rest().len());
        let text = self.rest()[..length].to_owned();
        self.skip(length);
        (number, text)
    }
}

#[cfg(test)]
mod tests;
