//! The printed edition: the page that holds all pages, arranged for paper, and printed by Chromium.
//!
//! Each page of the book begins a chapter with a running head of its own. Folds are open, but for
//! answers and solutions, which stand at the end, and for what only repeats on a screen
//! ([`LEFT_OUT`]). Chromium cannot say on which page something is, so the edition is printed twice:
//! the second time with the page numbers of the first.

use crate::project::Project;
use crate::text::{escape, unescape, without_tags};
use std::collections::BTreeMap;
use std::error::Error;
use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

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

/// Chromium sets running heads and page numbers since this version.
const CHROMIUM: u32 = 131;

/// Page numbers by what is on them.
type Pages = BTreeMap<String, usize>;

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
fn edition(html: &str, summary: &str, pages: &Pages) -> Result<String, String> {
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

/// The page numbers of all that is linked to, as Chromium writes them: a table of names, and the
/// pages as a tree, in plain text.
fn pages_in(pdf: &[u8]) -> Option<Pages> {
    let last = String::from_utf8_lossy(&pdf[pdf.len().saturating_sub(64)..]);
    let table: usize = last.split_once("startxref\n")?.1.lines().next()?.parse().ok()?;
    let text = String::from_utf8_lossy(pdf.get(table..)?);
    let mut places = BTreeMap::new();
    for (number, row) in
        text.lines().skip(2).take_while(|row| !row.starts_with("trailer")).enumerate()
    {
        places.insert(number, row.split(' ').next()?.parse::<usize>().ok()?);
    }
    let object = |number: usize| {
        let from = &pdf[*places.get(&number)?..];
        let end = from.windows(6).position(|w| w == b"endobj")?;
        Some(String::from_utf8_lossy(&from[..end]).into_owned())
    };
    let reference = |text: &str, key: &str| -> Option<usize> {
        text.split_once(key)?.1.trim_start().split(' ').next()?.parse().ok()
    };
    let catalog = object(reference(&text, "/Root")?)?;
    let mut order = Vec::new();
    let mut open = vec![reference(&catalog, "/Pages")?];
    while let Some(node) = open.pop() {
        let found = object(node)?;
        match found.split_once("/Kids [") {
            None => order.push(node),
            Some((_, kids)) => {
                let kids = kids.split_once(']')?.0.replace(" 0 R", "");
                let kids = kids.split_whitespace().map(|kid| kid.parse().ok());
                open.extend(kids.collect::<Option<Vec<usize>>>()?.into_iter().rev());
            }
        }
    }
    let number = |page: usize| order.iter().position(|other| *other == page).map(|n| n + 1);
    let names = object(reference(&catalog, "/Dests")?)?;
    let named = names.split('/').filter_map(|entry| {
        let (name, place) = entry.split_once(" [")?;
        Some((name.to_owned(), number(place.split(' ').next()?.parse().ok()?)?))
    });
    Some(named.collect())
}

/// Where Chromium is: what `CHROMIUM` names, or the first that answers.
fn chromium() -> Result<OsString, String> {
    let named = std::env::var_os("CHROMIUM");
    let usual = [
        "chromium",
        "chromium-browser",
        "google-chrome",
        "/Applications/Chromium.app/Contents/MacOS/Chromium",
        "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome",
        "C:\\Program Files\\Google\\Chrome\\Application\\chrome.exe",
        "C:\\Program Files (x86)\\Microsoft\\Edge\\Application\\msedge.exe",
    ];
    let all = named.clone().map_or(usual.map(OsString::from).to_vec(), |named| vec![named]);
    for program in all {
        // On Windows it does not say its version.
        if cfg!(windows) && Path::new(&program).is_file() {
            return Ok(program);
        }
        let Ok(told) = Command::new(&program).arg("--version").output() else { continue };
        let told = String::from_utf8_lossy(&told.stdout).into_owned();
        let number = |word: &str| word.split('.').next()?.parse::<u32>().ok();
        let version = told.split_whitespace().find_map(number);
        return match version {
            Some(version) if version >= CHROMIUM => Ok(program),
            Some(version) => Err(format!(
                "Chromium is of version {version}; running heads and page numbers need {CHROMIUM} or later"
            )),
            None => continue,
        };
    }
    Err(match named {
        Some(named) => format!("{} (named by CHROMIUM) is no Chromium", named.display()),
        None => "--pdf prints through Chromium or Chrome, and none was found; install one \
                 (`apt-get install chromium`), or name its program in the variable CHROMIUM"
            .into(),
    })
}

/// The address of a file.
fn address(path: &Path) -> String {
    let path = path.to_string_lossy().replace('\\', "/");
    // How Windows writes a full path.
    let path = path.strip_prefix("//?/").unwrap_or(&path);
    let mut address = String::from(if path.starts_with('/') { "file://" } else { "file:///" });
    for byte in path.bytes() {
        match byte {
            b'/' | b':' | b'.' | b'-' | b'_' => address.push(byte.into()),
            _ if byte.is_ascii_alphanumeric() => address.push(byte.into()),
            _ => address += &format!("%{byte:02X}"),
        }
    }
    address
}

fn printed(
    program: &OsString,
    html: &Path,
    pdf: &Path,
    profile: &Path,
) -> Result<(), Box<dyn Error>> {
    let mut target = OsString::from("--print-to-pdf=");
    target.push(pdf);
    // A profile of its own: a browser that is open would take the page and print nothing.
    let mut own = OsString::from("--user-data-dir=");
    own.push(profile);
    let _ = fs::remove_file(pdf);
    let told = Command::new(program)
        // The page is our own, and without scripts; in a container there is no sandbox.
        .args(["--headless", "--no-sandbox", "--disable-gpu", "--no-pdf-header-footer"])
        .arg("--generate-pdf-document-outline")
        .args([&own, &target])
        .arg(address(html))
        .output()?;
    if pdf.is_file() {
        return Ok(());
    }
    Err(format!("Chromium printed nothing:\n{}", String::from_utf8_lossy(&told.stderr)).into())
}

/// What prints to `pdf`.
///
/// # Errors
/// No Chromium, or no place for the file.
pub fn printer(pdf: &Path) -> Result<OsString, String> {
    match pdf.parent() {
        Some(directory) if !directory.is_dir() => {
            Err(format!("--pdf: there is no directory {}", directory.display()))
        }
        _ if pdf.is_dir() => Err(format!("--pdf: {} is a directory", pdf.display())),
        _ => chromium(),
    }
}

/// Prints the book in `out` to `pdf`, through a [`printer`].
///
/// # Errors
/// A book that Chromium does not print.
pub fn print(
    program: &OsString,
    project: &Project,
    out: &Path,
    pdf: &Path,
) -> Result<(), Box<dyn Error>> {
    let html = fs::read_to_string(out.join("print.html"))?;
    let summary = project.read("book/src/SUMMARY.md")?;
    let out = out.canonicalize()?;
    let (page, profile) = (out.join("edition.html"), out.join("edition.profile"));
    let mut fresh = pdf.as_os_str().to_owned();
    fresh.push(".new");
    let fresh = PathBuf::from(fresh);
    let run = || -> Result<usize, Box<dyn Error>> {
        let mut pages = Pages::new();
        // With numbers instead of their places nothing moves as a rule; if it does, once more.
        for _ in 0..4 {
            fs::write(&page, edition(&html, &summary, &pages)?)?;
            printed(program, &page, &fresh, &profile)?;
            let found =
                pages_in(&fs::read(&fresh)?).ok_or("Chromium wrote a PDF of another form")?;
            if found == pages {
                return Ok(pages.len());
            }
            pages = found;
        }
        Err("the page numbers do not settle".into())
    };
    let done = run();
    let _ = fs::remove_file(&page);
    let _ = fs::remove_dir_all(&profile);
    done?;
    fs::rename(&fresh, pdf)?;
    eprintln!("The book is printed to {}.", pdf.display());
    Ok(())
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

    #[test]
    fn page_numbers_are_read_from_a_tree_of_pages() {
        let objects = [
            "<</Type /Catalog\n/Pages 2 0 R\n/Dests 6 0 R>>",
            "<</Type /Pages\n/Kids [3 0 R 5 0 R]>>",
            "<</Type /Pages\n/Kids [4 0 R]>>",
            "<</Type /Page>>",
            "<</Type /Page>>",
            "<</a [4 0 R /XYZ 1 2 0]\n/b-1 [5 0 R /XYZ 1 2 0]>>",
        ];
        let mut pdf = String::from("%PDF-1.4\n");
        let mut table = format!("xref\n0 {}\n0000000000 65535 f \n", objects.len() + 1);
        for (n, object) in objects.iter().enumerate() {
            table += &format!("{:010} 00000 n \n", pdf.len());
            pdf += &format!("{} 0 obj\n{object}\nendobj\n", n + 1);
        }
        let start = pdf.len();
        pdf += &format!("{table}trailer\n<</Size 7\n/Root 1 0 R>>\nstartxref\n{start}\n%%EOF\n");
        let pages = pages_in(pdf.as_bytes());
        assert_eq!(pages, Some(Pages::from([("a".into(), 1), ("b-1".into(), 2)])));
        // Damaged: a place that is elsewhere, a page that is in no tree.
        let broken = pdf.replace(&format!("startxref\n{start}"), "startxref\n7");
        assert_eq!(pages_in(broken.as_bytes()), None);
        let stray = pdf.replace("/b-1 [5", "/b-1 [6");
        assert_eq!(pages_in(stray.as_bytes()).map(|pages| pages.len()), Some(1));
    }

    #[test]
    fn an_address_holds_spaces_and_letters_beyond_ascii() {
        assert_eq!(address(Path::new("/tmp/a ü b/x.html")), "file:///tmp/a%20%C3%BC%20b/x.html");
        assert_eq!(address(Path::new("\\\\?\\C:\\b\\x.html")), "file:///C:/b/x.html");
    }
}
