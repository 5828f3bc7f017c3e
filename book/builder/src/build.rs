//! One build of the book.

use crate::preprocess::Directives;
use crate::project::Project;
use crate::render::Pages;
use crate::warnings;
use indicatif::{ProgressBar, ProgressStyle};
use mdbook_driver::MDBook;
use std::error::Error;
use std::path::Path;
use std::time::Instant;

/// An error in words, with its causes.
pub fn message(error: &(dyn Error + 'static)) -> String {
    let mut words = Vec::new();
    let mut cause = Some(error);
    while let Some(error) = cause {
        words.push(error.to_string());
        cause = error.source();
    }
    words.dedup();
    format!("error: {}", words.join(": "))
}

/// Shows how far some work on the pages is, on a terminal only.
pub fn bar(work: &'static str, steps: usize) -> ProgressBar {
    let style = ProgressStyle::with_template("{msg} {wide_bar} {pos}/{len}");
    ProgressBar::new(steps as u64)
        .with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
        .with_message(work)
}

/// Builds the book into `out`; what is there stays if anything is wrong.
///
/// # Errors
/// All problems found, each with its file and line.
pub fn build(project: &Project, out: &Path) -> Result<(), Box<dyn Error>> {
    let mut book = MDBook::load(project.path("book"))?;
    warnings::none()?;
    book.config.build.build_dir = out.to_owned();
    let repository = env!("CARGO_PKG_REPOSITORY");
    if !repository.is_empty() {
        book.config.set("output.pages.html.git-repository-url", repository)?;
    }
    book.with_preprocessor(Directives);
    book.execute_build_process(&Pages)?;
    Ok(warnings::none()?)
}

/// Builds the book and says how long it took.
///
/// # Errors
/// As [`build`].
pub fn once(project: &Project, out: &Path) -> Result<(), Box<dyn Error>> {
    let start = Instant::now();
    build(project, out)?;
    eprintln!("The book is in {} ({:.1} s).", out.display(), start.elapsed().as_secs_f64());
    Ok(())
}
