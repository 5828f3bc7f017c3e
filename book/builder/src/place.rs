//! Where a page belongs: the line under its title, and the pages before and after it by name.

use crate::text::escape;
use mdbook_preprocessor::book::{Book, BookItem, Chapter};
use std::collections::BTreeMap;

/// The place of a page in the book, as HTML.
#[derive(Debug, Default, Clone, PartialEq)]
pub struct Place {
    /// Its chapter, and the page that it belongs to or follows.
    pub line: String,
    /// Links to the pages before and after it.
    pub turn: String,
}

/// A page in the order of the summary.
struct Entry<'b> {
    chapter: &'b Chapter,
    part: &'b str,
    /// How its page stands to another one, and to which.
    after: Option<(&'static str, &'b Chapter)>,
}

fn address(chapter: &Chapter) -> Option<String> {
    let path = chapter.path.as_ref()?.with_extension("html");
    Some(path.to_string_lossy().replace('\\', "/"))
}

fn walk<'b>(
    items: &'b [BookItem],
    parent: Option<&'b Chapter>,
    mut part: &'b str,
    entries: &mut Vec<Entry<'b>>,
) {
    let mut before = None;
    for item in items {
        match item {
            BookItem::PartTitle(title) => part = title,
            // A draft has no page.
            BookItem::Chapter(chapter) if chapter.path.is_some() => {
                let owner = parent.map(|parent| ("belongs to", parent));
                let after = owner.or(before.map(|before| ("comes after", before)));
                entries.push(Entry { chapter, part, after });
                before = Some(chapter);
                walk(&chapter.sub_items, before, part, entries);
            }
            _ => {}
        }
    }
}

/// The places of all pages, by their addresses. A page before the first part has no line.
pub fn places(book: &Book) -> BTreeMap<String, Place> {
    let mut entries = Vec::new();
    walk(&book.items, None, "", &mut entries);
    let link = |chapter: &Chapter, attributes: &str| {
        let address = address(chapter).unwrap_or_default();
        let name = escape(&chapter.name);
        format!("<a{attributes} href=\"{address}\">{name}</a>")
    };
    let place = |n: usize| {
        let entry = &entries[n];
        let line = match entry.part {
            "" => String::new(),
            part => {
                let after = entry.after.map(|(how, other)| {
                    let other = link(other, "");
                    format!(" <span>{how} {other}</span>")
                });
                format!(
                    "<nav class=\"place\" aria-label=\"Place in the book\"><span>{}</span>{}</nav>",
                    escape(part),
                    after.unwrap_or_default()
                )
            }
        };
        let turned = |entry: Option<&Entry>, rel: &str| {
            entry.map_or(String::new(), |entry| link(entry.chapter, &format!(" rel=\"{rel}\"")))
        };
        let before = n.checked_sub(1).and_then(|n| entries.get(n));
        let turn = format!(
            "<nav class=\"turn\" aria-label=\"Previous and next page\">{}{}</nav>",
            turned(before, "prev"),
            turned(entries.get(n + 1), "next")
        );
        Some((address(entry.chapter)?, Place { line, turn }))
    };
    (0..entries.len()).filter_map(place).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_page_names_its_chapter_and_its_neighbours() {
        let chapter = |name: &str, inner: Vec<Chapter>| {
            let mut chapter = Chapter::new(name, String::new(), format!("{name}.md"), vec![]);
            chapter.sub_items = inner.into_iter().map(BookItem::Chapter).collect();
            chapter
        };
        let book = Book::new_with_items(vec![
            BookItem::Chapter(chapter("start", vec![])),
            BookItem::PartTitle("Tops & wheels".into()),
            BookItem::Chapter(chapter("top", vec![chapter("nods", vec![])])),
            BookItem::Chapter(chapter("wheel", vec![])),
        ]);
        let places = places(&book);
        assert_eq!(places.len(), 4);
        assert_eq!(places["start.html"].line, "");
        for (page, line, turn) in [
            (
                "top",
                "comes after <a href=\"start.html\">start</a>",
                "prev\" href=\"start.html\">start</a><a rel=\"next\" href=\"nods",
            ),
            (
                "nods",
                "belongs to <a href=\"top.html\">top</a>",
                "prev\" href=\"top.html\">top</a><a rel=\"next\" href=\"wheel",
            ),
            (
                "wheel",
                "comes after <a href=\"top.html\">top</a>",
                "prev\" href=\"nods.html\">nods</a></nav>",
            ),
        ] {
            let place = &places[&format!("{page}.html")];
            assert!(place.line.contains("Tops &amp; wheels"), "{place:?}");
            assert!(place.line.contains(line), "{place:?}");
            assert!(place.turn.contains(turn), "{place:?}");
        }
    }
}
