//! The preprocessor: every page expanded, every file of a stem accounted for.

use crate::build;
use crate::expand::{Labels, Page};
use crate::problem::{Problem, Problems};
use crate::project::Project;
use crate::render;
use crate::splice;
use mdbook_preprocessor::book::{Book, BookItem, Chapter};
use mdbook_preprocessor::errors::{Error, Result};
use mdbook_preprocessor::{MDBOOK_VERSION, Preprocessor, PreprocessorContext};
use std::collections::BTreeSet;

/// Our preprocessor, under the name that `book.toml` gives it.
pub struct Directives;

/// The name in `book.toml`.
pub const NAME: &str = "directives";

/// Checks that the `mdbook` that calls speaks our version's protocol.
///
/// # Errors
/// If its minor version is another than the library's.
pub fn same_protocol(version: &str) -> Result<()> {
    let minor =
        |version: &str| -> Vec<String> { version.split('.').take(2).map(Into::into).collect() };
    if minor(version) == minor(MDBOOK_VERSION) {
        Ok(())
    } else {
        Err(Error::msg(format!(
            "this book is built with mdBook {MDBOOK_VERSION}, but mdbook {version} calls it"
        )))
    }
}

/// The sources of a chapter, its file relative to the project and its address.
fn place(chapter: &Chapter) -> Option<(String, String)> {
    let path = chapter.source_path.as_ref()?;
    let path = path.to_string_lossy().replace('\\', "/");
    let address = chapter.path.as_ref()?.with_extension("html");
    let address = address.to_string_lossy().replace('\\', "/");
    Some((format!("book/src/{path}"), address))
}

impl Preprocessor for Directives {
    fn name(&self) -> &str {
        NAME
    }

    fn supports_renderer(&self, renderer: &str) -> Result<bool> {
        Ok(renderer == render::NAME || renderer == "html")
    }

    fn run(&self, ctx: &PreprocessorContext, mut book: Book) -> Result<Book> {
        same_protocol(&ctx.mdbook_version)?;
        let root = ctx.root.canonicalize().ok().and_then(|root| root.parent().map(Project::new));
        let project = root.ok_or(Error::msg("the book's directory has no parent"))?;

        // Labels first: an equation may be named on an earlier page.
        let mut labels = Labels::new();
        let mut problems = Vec::new();
        let bar = build::bar("reading", 2 * book.chapters().count());
        for chapter in book.chapters() {
            bar.inc(1);
            let Some((file, address)) = place(chapter) else {
                continue;
            };
            let none = Labels::new();
            let mut page = Page::new(&project, &file, &address, &none);
            page.expand(&chapter.content.replace("\r\n", "\n"), 1);
            for (label, target) in page.found {
                let (file, line) = target.place.clone();
                if let Some(other) = labels.insert(label.clone(), target) {
                    let (taken, at) = other.place;
                    problems.push(Problem::new(
                        file,
                        line,
                        format!("the label '{label}' is taken at {taken}:{at}"),
                    ));
                }
            }
        }

        let mut stems = BTreeSet::new();
        let mut pages = BTreeSet::new();
        let mut figures = BTreeSet::new();
        let fill_now = ctx.renderer != render::NAME;
        book.for_each_chapter_mut(|chapter| {
            bar.inc(1);
            let Some((file, address)) = place(chapter) else {
                return;
            };
            let source = chapter.content.replace("\r\n", "\n");
            let mut page = Page::new(&project, &file, &address, &labels);
            let expanded = page.expand(&source, 1);
            problems.append(&mut page.problems);
            stems.extend(page.stems);
            let mut number = 0;
            let filled = splice::fill(&expanded, |splice| {
                if let splice::Splice::Figure { stem, name } = splice {
                    figures.insert(Project::figure_file(stem, name));
                }
                render::html_of(&project, splice, &mut number)
            });
            match filled {
                Ok(filled) if fill_now => chapter.content = filled,
                Ok(_) => chapter.content = expanded,
                Err(message) => problems.push(Problem::new(&file, 1, message)),
            }
            pages.insert(file);
        });
        problems.extend(orphans(&project, &pages, &stems, &figures));
        Problems::none_of(problems).map_err(Error::new)?;
        debug_assert!(book.iter().all(|item| !matches!(item, BookItem::Chapter(c)
            if c.content.contains("{{num"))));
        Ok(book)
    }
}

/// Files of a stem that nothing shows, and pages that the summary does not name.
fn orphans(
    project: &Project,
    pages: &BTreeSet<String>,
    stems: &BTreeSet<String>,
    figures: &BTreeSet<String>,
) -> Vec<Problem> {
    let mut problems = Vec::new();
    let mut orphan = |file: String, why: String| problems.push(Problem::new(file, 1, why));
    for name in project.names("book/src", ".md") {
        let file = format!("book/src/{name}.md");
        if name != "SUMMARY" && !pages.contains(&file) {
            orphan(file, "SUMMARY.md does not name this page".into());
        }
    }
    let examples = project.names("examples", ".rs");
    for stem in &examples {
        let file = format!("examples/{stem}.rs");
        if !stems.contains(stem) {
            orphan(file.clone(), "no page uses this example".into());
        }
        if !project.path(&format!("tests/snapshots/{stem}.snap")).is_file() {
            orphan(
                file,
                format!("its output is not locked: there is no tests/snapshots/{stem}.snap"),
            );
        }
    }
    for stem in project.names("tests/snapshots", ".snap") {
        if !examples.contains(&stem) {
            orphan(
                format!("tests/snapshots/{stem}.snap"),
                format!("there is no examples/{stem}.rs"),
            );
        }
    }
    for group in project.groups("tests/snapshots") {
        let stem = group.trim_end_matches('/');
        for name in project.figures(stem) {
            let file = Project::figure_file(stem, &name);
            if !figures.contains(&file) {
                orphan(file, "no page shows this figure".into());
            }
        }
    }
    problems
}
