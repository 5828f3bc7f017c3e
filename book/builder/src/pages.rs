//! The lint of finished pages: nothing left over, nothing pointing nowhere, nothing from outside.

use crate::build::bar;
use crate::coverage::{self, Missing};
use crate::problem::{Problem, Problems};
use crate::text::unescape;
use std::collections::{BTreeMap, BTreeSet};

/// A start tag: its name and its attributes.
struct Tag<'h> {
    name: &'h str,
    attributes: Vec<(&'h str, String)>,
    line: usize,
}

impl Tag<'_> {
    fn get(&self, name: &str) -> Option<&str> {
        let found = self.attributes.iter().find(|(n, _)| *n == name);
        found.map(|(_, value)| value.as_str())
    }
}

/// The start tags of a page, and its text outside of scripts, styles and code.
fn read(html: &str) -> (Vec<Tag<'_>>, String) {
    let mut tags = Vec::new();
    let mut text = String::new();
    let mut rest = html;
    let mut line = 1;
    let mut quiet: Vec<&str> = Vec::new();
    while let Some(at) = rest.find('<') {
        let (before, tag) = rest.split_at(at);
        line += before.matches('\n').count();
        if quiet.is_empty() {
            text.push_str(before);
        } else {
            text.push_str(&"\n".repeat(before.matches('\n').count()));
        }
        if tag.starts_with("<!--") {
            let end = tag.find("-->").map_or(tag.len(), |end| end + 3);
            let feeds = tag[..end].matches('\n').count();
            line += feeds;
            text.push_str(&"\n".repeat(feeds));
            rest = &tag[end..];
            continue;
        }
        let end = end_of_tag(tag);
        let inner = &tag[1..end];
        let name_end = inner
            .find(|c: char| c.is_whitespace() || c == '/' && !inner.starts_with('/'))
            .unwrap_or(inner.len());
        let name = &inner[..name_end];
        if let Some(closed) = name.strip_prefix('/') {
            if quiet.last() == Some(&closed) {
                quiet.pop();
            }
        } else if name.starts_with(|c: char| c.is_ascii_alphabetic()) {
            tags.push(Tag { name, attributes: attributes(&inner[name_end..]), line });
            if matches!(name, "script" | "style" | "code" | "pre" | "textarea") {
                quiet.push(name);
            }
            // The text of these is not HTML.
            if matches!(name, "script" | "style") {
                let close = format!("</{name}");
                let skip = tag[end..].find(&close).map_or(tag.len(), |n| end + n);
                let feeds = tag[..skip].matches('\n').count();
                line += feeds;
                text.push_str(&"\n".repeat(feeds));
                rest = &tag[skip..];
                continue;
            }
        }
        let feeds = tag[..end].matches('\n').count();
        line += feeds;
        text.push_str(&"\n".repeat(feeds));
        rest = tag.get(end + 1..).unwrap_or("");
    }
    text.push_str(rest);
    (tags, text)
}

fn end_of_tag(tag: &str) -> usize {
    let mut quote = None;
    for (n, c) in tag.char_indices() {
        match (quote, c) {
            (None, '>') => return n,
            (None, '"' | '\'') => quote = Some(c),
            (Some(open), c) if c == open => quote = None,
            _ => {}
        }
    }
    tag.len()
}

fn attributes(text: &str) -> Vec<(&str, String)> {
    let mut found = Vec::new();
    let mut rest = text.trim_start_matches([' ', '\n', '\t', '/']);
    while !rest.is_empty() {
        let end =
            rest.find(|c: char| c.is_whitespace() || c == '=' || c == '/').unwrap_or(rest.len());
        let name = &rest[..end];
        rest = rest[end..].trim_start();
        let mut value = String::new();
        if let Some(after) = rest.strip_prefix('=') {
            let after = after.trim_start();
            let quoted = after.chars().next().filter(|&c| c == '"' || c == '\'');
            let (raw, remaining) = match quoted {
                Some(quote) => after[1..].split_once(quote).unwrap_or((&after[1..], "")),
                None => {
                    let end = after.find(char::is_whitespace).unwrap_or(after.len());
                    after.split_at(end)
                }
            };
            value = unescape(raw);
            rest = remaining;
        } else if end == 0 {
            rest = rest.get(1..).unwrap_or("");
        }
        if !name.is_empty() {
            found.push((name, value));
        }
        rest = rest.trim_start_matches([' ', '\n', '\t', '/']);
    }
    found
}

/// Checks all pages (address to HTML) of a book that has the files `all`; `source`
/// gives the Markdown file of an address and its text.
///
/// # Errors
/// What is left over, points nowhere, has no alternative text, or loads from outside:
/// at the line of the Markdown that holds it, or else at the line of the HTML.
pub fn check(
    pages: &BTreeMap<String, String>,
    all: &[String],
    source: impl Fn(&str) -> Option<(String, String)>,
) -> Result<(), Problems> {
    let all: BTreeSet<&str> = all.iter().map(String::as_str).collect();
    let mut problems = Vec::new();
    let mut targets: BTreeMap<&str, BTreeSet<String>> = BTreeMap::new();
    let mut read_pages = Vec::new();
    let bar = bar("checking", 2 * pages.len());
    for (address, html) in pages {
        bar.inc(1);
        let (tags, text) = read(html);
        let mut ids = BTreeSet::new();
        for tag in &tags {
            for name in ["id", "name"] {
                let Some(id) = tag.get(name).filter(|_| name == "id" || tag.name == "a") else {
                    continue;
                };
                if !ids.insert(id.to_owned()) && name == "id" && address != "print.html" {
                    problems.push(Problem::new(
                        address,
                        tag.line,
                        format!("the id '{id}' stands twice in this page"),
                    ));
                }
            }
        }
        targets.insert(address, ids);
        read_pages.push((address.as_str(), tags, text));
    }
    for (address, tags, text) in &read_pages {
        bar.inc(1);
        let markdown = source(address);
        let mut problem = |line: usize, what: &str, message: String| {
            let what = what.replace(".html", ".md");
            let written = markdown.as_ref().and_then(|(file, text)| {
                let at = text.lines().position(|line| line.contains(&what))?;
                Some((file.as_str(), at + 1))
            });
            let (file, line) = written.unwrap_or((address, line));
            problems.push(Problem::new(file, line, message));
        };
        for (n, line) in text.lines().enumerate() {
            for left_over in ["{{", "}}", "$", "data-splice", "\\tag", "\\label", "\\eqref"] {
                if line.contains(left_over) {
                    problem(
                        n + 1,
                        line.trim(),
                        format!("'{left_over}' is left over: {}", line.trim()),
                    );
                }
            }
        }
        for Missing { c, family, line } in coverage::missing(&pages[*address]) {
            let code = u32::from(c);
            problem(
                line,
                &c.to_string(),
                format!(
                    "the book's font {family:?} has no '{c}' (U+{code:04X}); see book/builder/fonts/subset.py"
                ),
            );
        }
        for tag in tags {
            if tag.name == "svg" && tag.get("role") == Some("img") {
                let alt = tag.get("aria-label").unwrap_or("");
                if alt.trim().len() < 10 {
                    problem(tag.line, "{{figure", "a figure without alternative text".into());
                }
            }
            if tag.name == "img" && tag.get("alt").is_none_or(|alt| alt.trim().is_empty()) {
                problem(tag.line, "![](", "a picture without alternative text".into());
            }
            let loads = match tag.name {
                "script" | "img" | "iframe" | "source" | "audio" | "video" | "embed" => {
                    tag.get("src")
                }
                "link" => tag.get("href"),
                "object" => tag.get("data"),
                _ => None,
            };
            if let Some(url) = loads
                && (url.contains("://") || url.starts_with("//"))
            {
                problem(tag.line, url, format!("{url} loads from outside"));
            }
            let link = loads.or_else(|| tag.get("href").filter(|_| tag.name == "a"));
            if let Some(url) = link
                && let Err(message) = resolves(address, url, &all, &targets)
            {
                problem(tag.line, url, message);
            }
        }
    }
    // The print page repeats the others.
    if problems.iter().any(|problem| problem.file != "print.html") {
        problems.retain(|problem| problem.file != "print.html");
    }
    Problems::none_of(problems)
}

/// Whether a link within the book leads somewhere.
fn resolves(
    page: &str,
    url: &str,
    all: &BTreeSet<&str>,
    targets: &BTreeMap<&str, BTreeSet<String>>,
) -> Result<(), String> {
    let outside = ["http://", "https://", "mailto:", "data:"];
    // The 404 page is shown at any address, so its links begin at the site's root.
    if outside.iter().any(|scheme| url.starts_with(scheme)) || page == "404.html" {
        return Ok(());
    }
    let (path, fragment) = url.split_once('#').unwrap_or((url, ""));
    let mut parts: Vec<&str> = page.split('/').collect();
    parts.pop();
    if path.is_empty() {
        parts = page.split('/').collect();
    }
    for part in path.split('/').filter(|part| !part.is_empty() && *part != ".") {
        if part == ".." {
            parts.pop();
        } else {
            parts.push(part);
        }
    }
    let target = parts.join("/");
    if !all.contains(target.as_str()) {
        return Err(format!("the link {url} leads nowhere"));
    }
    let fragment = fragment.replace("%20", " ");
    match targets.get(target.as_str()) {
        Some(ids) if !fragment.is_empty() && !ids.contains(&fragment) => {
            Err(format!("the link {url} leads to no place in {target}"))
        }
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests;
