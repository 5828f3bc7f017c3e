//! Pages as cards: a locked figure, the title, and the time that reading takes.

use crate::project::Project;
use crate::splice::Splice;
use crate::text::escape;

/// Words that are read in a minute: half the 238 that adults read of plain prose (M. Brysbaert,
/// *Journal of Memory and Language* **109**, 104047, 2019), as each formula is to be worked out.
const WORDS: usize = 119;

/// The minutes that a page takes with its folds closed, to five.
pub fn minutes(markdown: &str) -> usize {
    let (mut folds, mut code, mut words) = (0_usize, false, 0);
    for line in markdown.lines() {
        code ^= line.starts_with("```");
        folds += line.matches("<details").count();
        if folds == 0 && !code {
            words += line.split_whitespace().count();
        }
        folds = folds.saturating_sub(line.matches("</details").count());
    }
    (words.div_ceil(WORDS)).div_ceil(5) * 5
}

/// The cards of the pages `STEM`, each with the figure `STEM:FIGURE`.
///
/// # Errors
/// A page or a figure that is not there.
pub fn html(project: &Project, pages: &[(String, String)]) -> Result<String, String> {
    let mut html = String::from("<div class=\"pages\">");
    for (stem, figure) in pages {
        let file = format!("book/src/{stem}.md");
        let page = project.read(&file)?;
        let title = page.lines().next().and_then(|line| line.strip_prefix("# "));
        let title = title.ok_or(format!("{file} has no title"))?;
        project.figure(stem, figure)?;
        let figure = Splice::Figure { stem: stem.clone(), name: figure.clone() };
        html += &format!(
            "<a href=\"{stem}.html\"><span class=\"thumb\" aria-hidden=\"true\">{}</span>\
             <b>{}</b> <span class=\"minutes\">{} min</span></a>",
            figure.mark(""),
            escape(title.trim()),
            minutes(&page)
        );
    }
    Ok(html + "</div>")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_what_is_open_takes_time() {
        let words = |n: usize| "word ".repeat(n);
        assert_eq!(minutes(&words(WORDS)), 5);
        assert_eq!(minutes(&words(5 * WORDS)), 5);
        assert_eq!(minutes(&words(5 * WORDS + 1)), 10);
        let folded = format!(
            "{}\n<details>\n<details>\n{}\n</details>\n{}\n</details>\n```text\n{}\n```\n",
            words(10),
            words(900),
            words(900),
            words(900)
        );
        assert_eq!(minutes(&folded), 5);
        assert_eq!(minutes(&folded.replace("details", "div")), 20);
    }
}
