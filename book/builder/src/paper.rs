//! The edition on paper: Chromium prints it, twice. It cannot say on which page something is, so the
//! second time has the page numbers of the first.

use crate::edition::{Pages, edition};
use crate::project::Project;
use std::collections::BTreeMap;
use std::error::Error;
use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Chromium sets running heads and page numbers since this version.
const CHROMIUM: u32 = 131;

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
