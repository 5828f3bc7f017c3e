//! The exercises on offer: the pages whose parameters say what is drawn.

use kit::{Claim, Page, Report};
use std::path::Path;
use std::sync::OnceLock;

/// An exercise, as its page states it.
pub struct Exercise {
    pub page: &'static dyn Page,
    /// `16.6`; `F1` for the further problem `further_1_…`, which the notes have not.
    pub number: String,
    /// The title of its page.
    pub title: String,
    /// The Markdown that states the problem.
    pub problem: String,
    usual: OnceLock<Report>,
}

impl Exercise {
    /// The numbers of the page itself.
    pub fn usual(&self) -> &Report {
        let sound = || self.page.report().expect("the defaults of a page are sound");
        self.usual.get_or_init(sound)
    }
}

/// The Markdown of a page from the heading of its problem up to what helps to solve it.
fn problem(page: &str) -> Option<&str> {
    let (_, from) = page.split_once("\n## The problem\n")?;
    let ends = ["\n## ", "\n<details>", "\n**Before you read on.**"];
    let end = ends.iter().filter_map(|end| from.find(end)).min()?;
    Some(from[..end].trim())
}

/// Every exercise on offer, in the order of the book.
pub fn all() -> Result<Vec<Exercise>, String> {
    let offered = pages::ALL.iter().filter(|page| !page.drawn().is_empty());
    offered.map(|page| read(*page)).collect()
}

fn read(page: &'static dyn Page) -> Result<Exercise, String> {
    let stem = page.stem();
    let file = format!("book/src/{stem}.md");
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(&file);
    let text = std::fs::read_to_string(path).map_err(|e| format!("cannot read {file}: {e}"))?;
    let text = text.replace("\r\n", "\n");
    let title = text.strip_prefix("# ").and_then(|text| text.lines().next());
    let (Some(title), Some(problem)) = (title, problem(&text)) else {
        return Err(format!("{file} has no title, or no section 'The problem' with an end"));
    };
    let numbered = title.strip_prefix("Exercise ").and_then(|rest| rest.split_once(':'));
    let further = stem.trim_start_matches("further_").split('_').next().unwrap_or(stem);
    let number = numbered.map_or(format!("F{further}"), |(number, _)| number.to_owned());
    let (title, problem) = (title.to_owned(), problem.to_owned());
    Ok(Exercise { page, number, title, problem, usual: OnceLock::new() })
}

/// Those with these numbers, in this order; all of them if none is named.
pub fn chosen<'e>(all: &'e [Exercise], numbers: &[String]) -> Result<Vec<&'e Exercise>, String> {
    let mut chosen: Vec<&Exercise> = Vec::new();
    for number in numbers {
        let found = all.iter().find(|exercise| exercise.number == *number);
        let Some(found) = found else {
            let known: Vec<&str> = all.iter().map(|exercise| exercise.number.as_str()).collect();
            return Err(format!("there is no problem '{number}'; there are: {}", known.join(", ")));
        };
        if chosen.iter().any(|exercise| exercise.number == *number) {
            return Err(format!("problem {number} stands twice"));
        }
        chosen.push(found);
    }
    Ok(if numbers.is_empty() { all.iter().collect() } else { chosen })
}

/// What the answer box asks for: the claims with a group, or all if none has one.
pub fn asked(report: &Report) -> Vec<&Claim> {
    let grouped = report.claims().iter().any(|claim| claim.group.is_some());
    let claims = report.claims().iter();
    claims.filter(|claim| !grouped || claim.group.is_some()).collect()
}
