//! Pages that show a source file, for the links "checked by" and for listings.

use crate::colour;
use crate::project::Project;
use crate::text::escape;
use std::collections::BTreeMap;
use std::fmt::Write;

/// The pages for all source files that `written` links to.
///
/// # Errors
/// A file that cannot be read.
pub fn pages(
    project: &Project,
    written: &BTreeMap<String, String>,
) -> Result<Vec<(String, String)>, String> {
    // File, and its lines with those who link to them: address and title.
    let mut wanted: BTreeMap<String, Vec<Back>> = BTreeMap::new();
    for (page, html) in written {
        for (at, key) in html.match_indices("href=\"source/") {
            let address = &html[at + key.len()..];
            let end = address.find(".html").ok_or("a damaged link to a source")?;
            let backs = wanted.entry(address[..end].to_owned()).or_default();
            let line = address[end..].strip_prefix(".html#L").and_then(|line| {
                let digits = line.find(|c: char| !c.is_ascii_digit())?;
                line[..digits].parse().ok()
            });
            // A tick names itself just before its link.
            let from = html[..at].strip_suffix("\" ").and_then(|before| {
                let (_, from) = before.rsplit_once("data-from=\"")?;
                Some(from)
            });
            if let (Some(line), Some(from)) = (line, from)
                && page != "print.html"
            {
                backs.push(Back { line, link: format!("{page}#{from}"), title: title(html) });
            }
        }
    }
    wanted
        .into_iter()
        .map(|(file, mut backs)| {
            // The first page may stand twice, the second time as the index.
            backs.sort_by_key(|back| back.link.starts_with("index.html#"));
            Ok((format!("source/{file}.html"), page(&file, &project.read(&file)?, &backs)))
        })
        .collect()
}

/// A place in a page that names a line of a source.
struct Back {
    line: usize,
    link: String,
    title: String,
}

/// What a page is called.
fn title(html: &str) -> String {
    let title = html
        .split_once("<title>")
        .and_then(|(_, rest)| rest.split_once("</title>"))
        .map_or("the page", |(title, _)| title);
    title.split(" - ").next().unwrap_or(title).to_owned()
}

fn page(file: &str, text: &str, backs: &[Back]) -> String {
    let up = "../".repeat(file.matches('/').count() + 1);
    let mut lines = String::new();
    let coloured = match file.ends_with(".rs") {
        true => colour::rust(text),
        false => escape(text),
    };
    for (n, line) in coloured.lines().enumerate() {
        let n = n + 1;
        let mut shown: Vec<&str> = Vec::new();
        for back in backs.iter().filter(|back| back.line == n) {
            if shown.contains(&back.title.as_str()) {
                continue;
            }
            shown.push(&back.title);
            let _ = writeln!(
                lines,
                "      <a class=\"back\" href=\"{up}{}\">↩ {}</a>",
                back.link, back.title
            );
        }
        let _ = writeln!(lines, "<span id=\"L{n}\"><a href=\"#L{n}\">{n:>4}</a>  {line}</span>");
    }
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"UTF-8\"><title>{file}</title>\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\
         <style>:root{{color-scheme:light dark}}body{{margin:1rem;font-family:sans-serif}}\
         pre{{font:0.85rem/1.45 ui-monospace,Menlo,Consolas,monospace}}\
         pre a{{color:light-dark(#666,#999);text-decoration:none;user-select:none}}\
         pre a.back{{color:LinkText;text-decoration:underline}}\
         .comment{{color:light-dark(#565c63,#a8aeb5)}}.keyword{{color:light-dark(#00558f,#7dbbf0)}}\
         .string{{color:light-dark(#007a59,#34c495)}}.number{{color:light-dark(#b84e00,#f08a45)}}\
         pre span:target,pre span:target *{{background:Mark;color:MarkText}}</style></head>\
         <body><main><h1 style=\"font-size:1rem\"><a href=\"{up}index.html\">The book</a> / {file}</h1>\
         <pre tabindex=\"0\" role=\"group\" aria-label=\"{file}\">{lines}</pre></main></body></html>\n"
    )
}
