//! Pages that show a source file, for the links "checked by" and for listings.

use crate::project::Project;
use crate::text::escape;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;

/// The pages for all source files that `written` links to.
///
/// # Errors
/// A file that cannot be read.
pub fn pages(
    project: &Project,
    written: &BTreeMap<String, String>,
) -> Result<Vec<(String, String)>, String> {
    let mut wanted = BTreeSet::new();
    for html in written.values() {
        for (at, key) in html.match_indices("href=\"source/") {
            let address = &html[at + key.len()..];
            let end = address.find(".html").ok_or("a damaged link to a source")?;
            wanted.insert(address[..end].to_owned());
        }
    }
    wanted
        .into_iter()
        .map(|file| {
            Ok((
                format!("source/{file}.html"),
                page(&file, &project.read(&file)?),
            ))
        })
        .collect()
}

fn page(file: &str, text: &str) -> String {
    let up = "../".repeat(file.matches('/').count() + 1);
    let mut lines = String::new();
    for (n, line) in text.lines().enumerate() {
        let n = n + 1;
        let _ = writeln!(
            lines,
            "<span id=\"L{n}\"><a href=\"#L{n}\">{n:>4}</a>  {}</span>",
            escape(line)
        );
    }
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"UTF-8\"><title>{file}</title>\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\
         <style>:root{{color-scheme:light dark}}body{{margin:1rem;font-family:sans-serif}}\
         pre{{font:0.85rem/1.45 ui-monospace,Menlo,Consolas,monospace}}\
         pre a{{color:GrayText;text-decoration:none;user-select:none}}\
         pre span:target{{background:Mark;color:MarkText}}</style></head>\
         <body><p><a href=\"{up}index.html\">The book</a> / {file}</p><pre>{lines}</pre></body></html>\n"
    )
}
