//! The printed edition: the page that holds all pages, arranged for paper, and printed by Chromium.
//!
//! Each page of the book begins a chapter with a running head of its own. Folds are open, but for
//! answers and solutions, which stand at the end, and for what only repeats on a screen
//! ([`LEFT_OUT`]).

use crate::text::{escape, unescape, without_tags};
use std::collections::BTreeMap;

const STYLE: &str = include_str!("edition.css");

/// Folds that are not printed: outputs of programs, whole sources, and all cases of a table whose
/// result the text states.
const LEFT_OUT: [&str; 4] = [
    "All methods and errors",
    "All cells of this family",
    "The results, each by two routes",
    "The whole physics of the program",
];

/// Folds whose content is at the end of the edition wherever they are.
const ANSWERS: [&str; 4] = ["Answer", "The answer", "Before you", "A hint"];

/// What a page has that is an exercise: all its folds are at the end.
const EXERCISE: &str = "<p class=\"exercise\">";

/// Page numbers by what is on them.
pub type Pages = BTreeMap<String, usize>;

/// A line of the contents.
enum Entry {
    Part(String),
    Page { depth: usize, title: String, stem: String },
}

/// The summary, line by line.
fn entries(summary: &str) -> Vec<Entry> {
    let entry = |line: &str| {
        if let Some(part) = line.strip_prefix("# ") {
            return (part != "Summary").then(|| Entry::Part(part.into()));
        }
        let depth = (line.len() - line.trim_start().len()) / 2;
        let link = line.trim_start_matches([' ', '-']).strip_prefix('[')?;
        let (title, file) = link.split_once("](")?;
        let stem = file.strip_suffix(".md)")?.into();
        Some(Entry::Page { depth, title: title.into(), stem })
    };
    summary.lines().filter_map(entry).collect()
}

/// A chapter of the edition: its address, its title in the contents, its HTML.
struct Chapter {
    id: String,
    title: String,
    html: String,
}

/// The chapters of the page that holds all pages, and the first heading of each page.
fn chapters(
    html: &str,
    entries: &[Entry],
) -> Result<(Vec<Chapter>, BTreeMap<String, String>), String> {
    let main = html.split_once("<main").and_then(|(_, rest)| rest.split_once('>'));
    let main = main.and_then(|(_, rest)| rest.split_once("</main>"));
    let (main, _) = main.ok_or("print.html has no <main>")?;
    let pages: Vec<(&String, &String)> = entries
        .iter()
        .filter_map(|entry| match entry {
            Entry::Page { title, stem, .. } => Some((title, stem)),
            Entry::Part(_) => None,
        })
        .collect();
    let pieces: Vec<&str> = main.split("<h1 id=\"").skip(1).collect();
    if pieces.len() != pages.len() {
        let (found, listed) = (pieces.len(), pages.len());
        return Err(format!("print.html has {found} chapters, the summary {listed}"));
    }
    let mut ids = BTreeMap::new();
    let mut chapters = Vec::new();
    for (piece, (title, stem)) in pieces.into_iter().zip(pages) {
        let (id, _) = piece.split_once('"').ok_or("a heading without an end")?;
        // What separates the pages is before the next heading.
        let end = piece.rfind("<div style=\"break-before").unwrap_or(piece.len());
        ids.insert(stem.clone(), id.to_owned());
        chapters.push(Chapter {
            id: id.into(),
            title: title.clone(),
            html: format!("<h1 id=\"{}", &piece[..end]),
        });
    }
    Ok((chapters, ids))
}

/// The page number of something, as a link to it.
fn page_of(id: &str, pages: &Pages) -> String {
    // Of the same width before it is known.
    let number = pages.get(id).map_or("000".into(), usize::to_string);
    format!("<a href=\"#{id}\">{number}</a>")
}

/// Answers that were taken out of a chapter, and how many there were before.
struct Moved<'p> {
    pages: &'p Pages,
    count: usize,
    html: String,
}

impl Moved<'_> {
    /// Takes a fold; what stands in its place.
    fn take(&mut self, summary: &str, body: &str) -> String {
        self.count += 1;
        let id = format!("at-the-end-{}", self.count);
        let body = folds(body, false, None);
        self.html +=
            &format!("<div class=\"fold\" id=\"{id}\"><h3 class=\"of\">{summary}</h3>{body}</div>");
        format!("<p class=\"moved\">{summary} (page {})</p>", page_of(&id, self.pages))
    }
}

/// HTML whose folds are open, left out, or moved to the end.
fn folds(html: &str, exercise: bool, mut moved: Option<&mut Moved<'_>>) -> String {
    let mut done = String::with_capacity(html.len());
    let mut rest = html;
    while let Some(at) = rest.find("<details") {
        done.push_str(&rest[..at]);
        let fold = &rest[at..];
        let end = end_of_fold(fold);
        let (head, body) = fold[..end].split_once("</summary>").unwrap_or((&fold[..end], ""));
        let body = body.strip_suffix("</details>").unwrap_or(body);
        let (tag, summary) = head.split_once("<summary>").unwrap_or((head, ""));
        let text = unescape(&without_tags(summary));
        let starts = |list: &[&str]| list.iter().any(|begin| text.starts_with(begin));
        if tag.contains("class=\"output\"") || starts(&LEFT_OUT) {
            // Not on paper.
        } else if let Some(moved) = &mut moved
            && (exercise || starts(&ANSWERS))
        {
            done += &moved.take(summary, body);
        } else {
            let body = folds(body, exercise, moved.as_deref_mut());
            done += &format!("<div class=\"fold\"><p class=\"summary\">{summary}</p>{body}</div>");
        }
        rest = &fold[end..];
    }
    done + rest
}

/// Where the fold at the beginning of this ends, folds within it included.
fn end_of_fold(html: &str) -> usize {
    let (mut depth, mut at) = (0_usize, 0);
    while let Some(next) =
        html[at..].find("<details").into_iter().chain(html[at..].find("</details>")).min()
    {
        at += next;
        if html[at..].starts_with("</") {
            at += "</details>".len();
            depth -= 1;
            if depth == 0 {
                return at;
            }
        } else {
            depth += 1;
            at += "<details".len();
        }
    }
    html.len()
}

/// Links for paper: within the edition to what is in it, to the web as they are, to nothing else.
fn links(html: &str, ids: &BTreeMap<String, String>) -> String {
    let mut done = String::with_capacity(html.len());
    let mut rest = html;
    while let Some(at) = rest.find(" href=\"") {
        done.push_str(&rest[..at]);
        let value = &rest[at + " href=\"".len()..];
        let end = value.find('"').unwrap_or(value.len());
        let target = &value[..end];
        let inside = match target.split_once(".html") {
            Some((stem, "")) => ids.get(stem).map(|id| format!("#{id}")),
            Some((stem, part)) => ids.contains_key(stem).then(|| part.into()),
            None => (target.starts_with('#') || target.starts_with("http")).then(|| target.into()),
        };
        if let Some(target) = inside {
            done += &format!(" href=\"{target}\"");
        }
        rest = value.get(end + 1..).unwrap_or("");
    }
    done + rest
}

/// Without its scripts.
fn unscripted(html: &str) -> String {
    let mut done = String::with_capacity(html.len());
    let mut rest = html;
    while let Some(at) = rest.find("<script") {
        done.push_str(&rest[..at]);
        rest = rest[at..].split_once("</script>").map_or("", |(_, after)| after);
    }
    done + rest
}

/// The edition, with the page numbers that are known.
///
/// # Errors
/// Pages that do not fit the summary.
pub fn edition(html: &str, summary: &str, pages: &Pages) -> Result<String, String> {
    let html = unscripted(html);
    let head = html.split_once("</head>").ok_or("print.html has no head")?.0;
    let entries = entries(summary);
    let (chapters, ids) = chapters(&html, &entries)?;
    let mut style = STYLE.to_owned();
    let mut body = String::new();
    let mut answers = String::new();
    let mut count = 0;
    let head_of = |name: &str, title: &str| {
        let title = title.replace('\\', "\\\\").replace('"', "\\\"");
        format!(
            "@page {name}:right {{ @top-right {{ content: \"{title}\"; font: italic 9pt serif; }} }}\n"
        )
    };
    for (n, chapter) in chapters.iter().enumerate() {
        style += &head_of(&format!("c{n}"), &chapter.title);
        let mut moved = Moved { pages, count, html: String::new() };
        let exercise = chapter.html.contains(EXERCISE);
        let html = folds(&chapter.html, exercise, Some(&mut moved));
        count = moved.count;
        body += &format!("<main class=\"chapter\" style=\"page: c{n}\">{html}</main>");
        if !moved.html.is_empty() {
            let page = page_of(&chapter.id, pages);
            answers += &format!("<h2>{} (page {page})</h2>{}", escape(&chapter.title), moved.html);
        }
    }
    style += &head_of("entries", "Contents");
    style += &head_of("answers", "Hints, answers and solutions");
    let mut list = String::new();
    for entry in &entries {
        match entry {
            Entry::Part(title) => list += &format!("<p class=\"part\">{}</p>", escape(title)),
            Entry::Page { depth, title, stem } => {
                list += &line(*depth, title, &ids[stem], pages);
            }
        }
    }
    list += &line(0, "Hints, answers and solutions", "answers", pages);
    let version = env!("CARGO_PKG_VERSION");
    Ok(format!(
        "{head}<style>{style}</style></head><body><div class=\"content\">\
         <main class=\"cover\"><h1>Rotation Dynamics, executable</h1>\
         <p>Rigid-body rotation: every number run, locked and checked.</p>\
         <p>Version {version}. The pages in a browser also hold what programs print, whole sources, \
         tables of all cases, moving pictures, and boxes that judge an answer.</p></main>\
         <main class=\"entries\"><h1>Contents</h1>{list}</main>{body}\
         <main class=\"answers\" style=\"page: answers\"><h1 id=\"answers\">Hints, answers and solutions</h1>\
         {answers}</main></div></body></html>",
        body = links(&body, &ids),
        answers = links(&answers, &ids),
    ))
}

/// A line of the contents.
fn line(depth: usize, title: &str, id: &str, pages: &Pages) -> String {
    let number = pages.get(id).map_or("000".into(), usize::to_string);
    format!(
        "<p class=\"line\" style=\"padding-inline-start: {}mm\"><a href=\"#{id}\"><span>{}</span><b>{number}</b></a></p>",
        6 * depth,
        escape(title)
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    const SUMMARY: &str = "# Summary\n\n[Front](index.md)\n\n# One\n\n- [A](a.md)\n  - [B](b.md)\n";

    const PRINT: &str = "<html><head><script>x</script></head><body><main id=\"main\">\
        <h1 id=\"front\">Front</h1><a href=\"b.html\">b</a><a href=\"a.html#s\">s</a>\
        <a href=\"source/x.rs.html\">x</a><a href=\"https://w.org\">w</a>\
        <div style=\"break-before: page;\"></div><h1 id=\"a\">A</h1>\
        <details><summary>Answer</summary>42</details>\
        <details><summary>Why</summary><details class=\"output\"><summary>What</summary>long</details>since</details>\
        <div style=\"break-before: page;\"></div><h1 id=\"b\">B</h1><p class=\"exercise\">1</p>\
        <details><summary>The <i>solution</i></summary><details><summary>More</summary>in</details>it</details>\
        </main><script>y</script></body></html>";

    #[test]
    fn folds_are_open_left_out_or_at_the_end() {
        let pages = Pages::from([("b".into(), 7), ("at-the-end-2".into(), 9)]);
        let done = edition(PRINT, SUMMARY, &pages).expect("an edition");
        let (book, answers) = done.split_once("<h1 id=\"answers\">").expect("answers");
        for part in [
            "<a href=\"#b\">b</a><a href=\"#s\">s</a><a>x</a><a href=\"https://w.org\">w</a>",
            "<p class=\"moved\">Answer (page <a href=\"#at-the-end-1\">000</a>)</p>",
            "<div class=\"fold\"><p class=\"summary\">Why</p>since</div>",
            "<p class=\"moved\">The <i>solution</i> (page <a href=\"#at-the-end-2\">9</a>)</p>",
            "<p class=\"part\">One</p>",
            "6mm\"><a href=\"#b\"><span>B</span><b>7</b>",
            "@page c2:right { @top-right { content: \"B\";",
        ] {
            assert!(book.contains(part), "{part}\n{book}");
        }
        for part in [
            "<h2>A (page <a href=\"#a\">000</a>)</h2><div class=\"fold\" id=\"at-the-end-1\">\
             <h3 class=\"of\">Answer</h3>42</div><h2>B",
            "<p class=\"summary\">More</p>in</div>it</div>",
        ] {
            assert!(answers.contains(part), "{part}\n{answers}");
        }
        assert!(!book.contains("42") && !done.contains("long") && !done.contains("<script"));
        // Damaged: a page that the summary does not list.
        assert!(edition(PRINT, &SUMMARY.replace("  - [B](b.md)\n", ""), &pages).is_err());
    }
}
