//! What mdBook's page frame lacks, put into its HTML: a sidebar button that the keyboard
//! reaches, a skip link, one heading of the first level, a description, a title and a place for
//! each page, a fold "On this page", and a 404 page that finds its style sheets at any address. What
//! mdBook colours listings with goes: `colour` has done it.
//!
//! Every place is looked for by name; if a new mdBook words it otherwise, the build says so.

use crate::place::Place;
use crate::text::{escape, unescape, without_tags};

/// Where the 404 page finds the root of the book: the nearest directory above the address
/// asked for that holds `toc.html`.
const ROOT: &str = "<script>for(let d=location.pathname.replace(/[^\\/]*$/,'');d;\
    d=d.replace(/[^\\/]*\\/$/,'')){const r=new XMLHttpRequest();r.open('HEAD',d+'toc.html',false);\
    try{r.send()}catch(e){}if(r.status===200){document.write('<base href=\"'+d+'\">');break}}</script>";

/// How the files of mdBook's that colour listings begin.
pub const COLOURING: [&str; 3] = ["highlight", "tomorrow-night", "ayu-highlight"];

/// mdBook's sign of a fold in the sidebar, which the book's fonts lack, and ours.
pub const FOLD: [&str; 2] = ["\u{2771}", "\u{2192}"];

/// What mdBook's script asks of the one that colours.
const UNCOLOURED: &str = "<script>const hljs={configure(){},highlightBlock(){}}</script>";

/// The longest description, in characters.
const DESCRIPTION: usize = 240;

/// The page with its frame mended; its marks may still be there.
///
/// # Errors
/// A place in mdBook's frame that is not there.
pub fn page(html: &str, address: &str, place: &Place) -> Result<String, String> {
    let mut page = Page(html.to_owned());
    if let Some(stray) = page.0.find("<h1 class=\"menu-title\">") {
        // A redirect page has no frame.
        page.element(stray, "h1", "div")?;
    } else {
        return Ok(page.0);
    }
    let label = page.find("<label id=\"mdbook-sidebar-toggle\"")?;
    page.element(label, "label", "button")?;
    page.replace(
        "<button id=\"mdbook-sidebar-toggle\"",
        "<button type=\"button\" id=\"mdbook-sidebar-toggle\"",
    )?;
    page.replace(" for=\"mdbook-sidebar-toggle-anchor\"", "")?;
    page.replace("<body>", "<body><a class=\"skip\" href=\"#main\">Skip to the text</a>")?;
    page.replace("<main>", "<main id=\"main\" tabindex=\"-1\">")?;
    page.replace("<div id=\"mdbook-menu-bar\"", "<div role=\"banner\" id=\"mdbook-menu-bar\"")?;
    page.whole("<nav class=\"nav-wrapper\"", "</nav>", &place.turn)?;
    page.colouring()?;
    page.themes();
    page.title();
    page.empty_heads();
    page.quiet_folded_headings();
    page.keep_flags_whole();
    match address {
        "404.html" => page.replace("<base href=\"/\">", ROOT)?,
        "print.html" => {}
        _ => {
            page.description();
            page.under_title(&place.line);
        }
    }
    Ok(page.0)
}

/// The HTML of a page.
struct Page(String);

impl Page {
    fn find(&self, what: &str) -> Result<usize, String> {
        let missing = || format!("mdBook's frame no longer holds {what}");
        self.0.find(what).ok_or_else(missing)
    }

    fn replace(&mut self, from: &str, to: &str) -> Result<(), String> {
        let at = self.find(from)?;
        self.0.replace_range(at..at + from.len(), to);
        Ok(())
    }

    /// Gives the element that begins at `at` another name.
    fn element(&mut self, at: usize, from: &str, to: &str) -> Result<(), String> {
        let close = format!("</{from}>");
        let end = self.0[at..].find(&close).map(|end| at + end);
        let end = end.ok_or_else(|| format!("mdBook's frame holds no {close}"))?;
        self.0.replace_range(end..end + close.len(), &format!("</{to}>"));
        self.0.replace_range(at + 1..at + 1 + from.len(), to);
        Ok(())
    }

    /// mdBook's script switches the three sheets by their names, so empty ones stay.
    fn colouring(&mut self) -> Result<(), String> {
        for name in COLOURING {
            let id = format!("id=\"mdbook-{name}-css\"");
            let link = format!("<link rel=\"stylesheet\" {id}");
            self.whole(&link, ">", &format!("<style {id}></style>"))?;
        }
        self.whole("<script src=\"highlight", "</script>", UNCOLOURED)
    }

    /// Puts `instead` in the place of what begins with `from` and ends with `to`.
    fn whole(&mut self, from: &str, to: &str, instead: &str) -> Result<(), String> {
        let at = self.find(from)?;
        let end = self.0[at..].find(to).map(|end| at + end + to.len());
        let end = end.ok_or_else(|| format!("mdBook's frame holds no {to}"))?;
        self.0.replace_range(at..end, instead);
        Ok(())
    }

    /// Two themes, each with its own contrast measured, instead of mdBook's five.
    fn themes(&mut self) {
        for theme in ["rust", "navy", "ayu"] {
            let from = format!(
                "<li role=\"none\"><button role=\"menuitem\" class=\"theme\" id=\"mdbook-theme-{theme}\">"
            );
            if let Some(at) = self.0.find(&from)
                && let Some(end) = self.0[at..].find("</li>")
            {
                self.0.replace_range(at..at + end + "</li>".len(), "");
            }
        }
        let coal = "id=\"mdbook-theme-coal\">Coal<";
        self.0 = self.0.replace(coal, "id=\"mdbook-theme-coal\">Dark<");
    }

    /// "A - A" is A.
    fn title(&mut self) {
        if let Some((at, title)) = between(&self.0, 0, "<title>", "</title>")
            && let Some((page, book)) = title.split_once(" - ")
            && page == book
        {
            let page = page.to_owned();
            self.0.replace_range(at..at + title.len(), &page);
        }
    }

    /// The first sentence describes the page.
    fn description(&mut self) {
        let main = self.0.find("<main").unwrap_or(0);
        let Some((_, paragraph)) = between(&self.0, main, "<p>", "</p>") else {
            return;
        };
        let text = unescape(&without_tags(paragraph));
        let words: Vec<&str> = text.split_whitespace().collect();
        let text = words.join(" ");
        let end = text.find(". ").or(text.find("? ")).map_or(text.len(), |end| end + 1);
        let sentence: String = text[..end].chars().take(DESCRIPTION).collect();
        let place = "<meta name=\"description\" content=\"";
        if let Some((at, old)) = between(&self.0, 0, place, "\"") {
            let range = at..at + old.len();
            self.0.replace_range(range, &escape(&sentence));
        }
    }

    /// The headings in folds lose the link by which mdBook's script finds them: the list at
    /// the side would give solutions away.
    fn quiet_folded_headings(&mut self) {
        let mut done = String::with_capacity(self.0.len());
        let mut depth = 0_usize;
        let mut rest = self.0.as_str();
        let mut inside = false;
        while let Some(at) = rest.find('<') {
            done.push_str(&rest[..at]);
            rest = &rest[at..];
            let end = rest.find('>').map_or(rest.len(), |end| end + 1);
            let tag = &rest[..end];
            if tag.starts_with("<details") {
                depth += 1;
            } else if tag.starts_with("</details") {
                depth = depth.saturating_sub(1);
            }
            let opens = depth > 0 && tag.starts_with("<a class=\"header\"");
            let closes = inside && tag == "</a>";
            inside = (inside || opens) && !closes;
            if !opens && !closes {
                done.push_str(tag);
            }
            rest = &rest[end..];
        }
        done.push_str(rest);
        self.0 = done;
    }

    /// A head without a word heads nothing: the corner of a table is a cell.
    fn empty_heads(&mut self) {
        self.0 = self.0.replace("<th></th>", "<td></td>");
    }

    /// A line may not break within `--angle`, nor within the `--` before it.
    fn keep_flags_whole(&mut self) {
        let mut done = String::with_capacity(self.0.len());
        let mut rest = self.0.as_str();
        // Code with a class is a block of its own.
        while let Some((at, code)) = between(rest, 0, "<code>", "</code>") {
            done.push_str(&rest[..at]);
            for word in code.split_inclusive(' ') {
                let flag = word.trim_end();
                match flag.starts_with("--") {
                    true => {
                        let space = &word[flag.len()..];
                        done += &format!("<span class=\"flag\">{flag}</span>{space}");
                    }
                    false => done.push_str(word),
                }
            }
            rest = &rest[at + code.len()..];
        }
        done.push_str(rest);
        self.0 = done;
    }

    /// The page's place under its title, and its sections as a fold, for narrow screens.
    fn under_title(&mut self, place: &str) {
        let main = self.0.find("<main").unwrap_or(0);
        let mut items = String::new();
        let mut from = main;
        while let Some((at, id)) = between(&self.0, from, "<h2 id=\"", "\"") {
            let Some((_, title)) = between(&self.0, at, "<a class=\"header\"", "</a>") else {
                break;
            };
            let title = title.split_once('>').map_or("", |(_, title)| title);
            items += &format!("<li><a href=\"#{id}\">{title}</a></li>");
            from = at;
        }
        let Some(end) = self.0[main..].find("</h1>").map(|end| main + end + "</h1>".len()) else {
            return;
        };
        let fold = match items.is_empty() {
            true => String::new(),
            false => format!(
                "<details class=\"contents\"><summary>On this page</summary><ul>{items}</ul></details>"
            ),
        };
        self.0.insert_str(end, &format!("{place}{fold}"));
    }
}

/// What stands between `open` and `close`, from `from` on, and where it begins.
fn between<'h>(html: &'h str, from: usize, open: &str, close: &str) -> Option<(usize, &'h str)> {
    let at = from + html[from..].find(open)? + open.len();
    let end = at + html[at..].find(close)?;
    Some((at, &html[at..end]))
}

#[cfg(test)]
mod tests {
    use super::*;

    const FRAME: &str = "<title>B - B</title><meta name=\"description\" content=\"of the book\">\
        <link rel=\"stylesheet\" id=\"mdbook-highlight-css\" href=\"highlight-1.css\">\
        <link rel=\"stylesheet\" id=\"mdbook-tomorrow-night-css\" href=\"tomorrow-night-1.css\">\
        <link rel=\"stylesheet\" id=\"mdbook-ayu-highlight-css\" href=\"ayu-highlight-1.css\">\
        <script src=\"highlight-1.js\"></script>\
        <body><label id=\"mdbook-sidebar-toggle\" class=\"x\" for=\"mdbook-sidebar-toggle-anchor\">=</label>\
        <div id=\"mdbook-menu-bar\"><h1 class=\"menu-title\">B</h1></div><main>\n<h1 id=\"b\">B</h1>\n<p>It <em>turns</em>. Why?</p><code>x -- --tilt 2</code><th></th><th>n</th>\
        <h2 id=\"s\"><a class=\"header\" href=\"#s\">S</a></h2>\
        <details><h3 id=\"t\"><a class=\"header\" href=\"#t\">T</a></h3><a href=\"#s\">s</a></details></main>\
        <nav class=\"nav-wrapper\"><a>bare</a></nav>";

    #[test]
    fn the_frame_is_mended() {
        let place = Place { line: "<nav>after A</nav>".into(), turn: "<nav>C</nav>".into() };
        let done = page(FRAME, "b.html", &place).expect("a frame");
        for part in [
            "<title>B</title>",
            "content=\"It turns.\"",
            "<a class=\"skip\" href=\"#main\">",
            "<button type=\"button\" id=\"mdbook-sidebar-toggle\" class=\"x\">=</button>",
            "<div class=\"menu-title\">B</div>",
            "<code>x <span class=\"flag\">--</span> <span class=\"flag\">--tilt</span> 2</code>",
            "<td></td><th>n</th>",
            "<h3 id=\"t\">T</h3><a href=\"#s\">s</a>",
            "</main><nav>C</nav>",
            "</h1><nav>after A</nav><details class=\"contents\"><summary>On this page</summary>\
             <ul><li><a href=\"#s\">S</a></li></ul></details>",
        ] {
            assert!(done.contains(part), "{part}\n{done}");
        }
        assert_eq!(done.matches("<h1").count(), 1);
        assert_eq!(done.matches("css\"></style>").count(), 3);
        assert!(done.contains(UNCOLOURED) && !done.contains("-1."));
        // The damaged twin: another frame is refused, a page without one left alone.
        assert!(page(&FRAME.replace("<main>", "<div>"), "b.html", &place).is_err());
        assert_eq!(page("<p>moved</p>", "b.html", &place).as_deref(), Ok("<p>moved</p>"));
    }
}
