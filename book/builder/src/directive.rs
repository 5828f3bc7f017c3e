//! The directives of a page: what they may say, and what becomes of them.
//!
//! | directive | gives |
//! |---|---|
//! | `{{num STEM:KEY}}` | a claim's value from the locked output |
//! | `{{num STEM:KEY rad/s}}` | the same with its unit, which must be this one (or: `unit`) |
//! | `{{num STEM:KEY@4 rad/s}}` | the same to 4 significant digits, where prose wants no more |
//! | `{{param STEM:NAME}}`, `{{param STEM:NAME@3 unit}}` | the value of a parameter (its flag is `--NAME`), written as `num` is |
//! | `{{given 9.81}}` | a number that is given, not computed |
//! | `{{figure STEM:NAME NAME …}}` | locked figures side by side; the next paragraph is their caption |
//! | `{{stills STEM}}` | the locked frames `STEM/frame_*` of a moving figure as a strip that moves when it is touched; a caption as for `figure` |
//! | `{{figure measured:RECORD-TABLE}}` | error against time, drawn from a table of `benches/record/RECORD.txt` |
//! | `{{listing STEM:ANCHOR}}` | the lines between the anchors in `examples/STEM.rs`; `STEM/FILE:ANCHOR` in `examples/STEM/FILE.rs` |
//! | `{{output STEM}}` | the locked output with its command, folded |
//! | `{{output STEM:SECTION}}` | one section of it |
//! | `{{table STEM:SECTION}}` | a section of the locked output as a table; `accuracy` as two lines and a fold, with its times |
//! | `{{measured RECORD:TABLE}}` | a table of `benches/record/RECORD.txt`, and under it on what it was measured |
//! | `{{check STEM}}` | the answer box |
//! | `{{recording STEM FLAG FLAG …}}` | the field for a reader's own recording, with these flags; nothing where the page does not live |
//! | `{{exercise LEVEL \| SOLVED \| EVENTS \| TEACHES}}` | what the page's exercise is; see [`Exercise`] |
//! | `{{pages STEM:NAME STEM:NAME …}}` | pages as cards: a locked figure, the title, the minutes that it takes |
//! | `{{exercises GROUP}}` | the table of the exercises whose stems begin so |
//! | `{{test FILE::NAME}}` | a link to the test, which must exist |

use crate::check;
use crate::contents;
use crate::exercises::{self, Exercise};
use crate::expand::Page;
use crate::figure;
use crate::measured;
use crate::notation;
use crate::project::{Claim, Project};
use crate::splice::Splice;
use crate::table;
use crate::text::{escape, number_html, number_tex, shortened, unit_html};
use crate::times;
use kit::for_reading;

/// A directive, read but not resolved.
#[derive(Debug, Clone, PartialEq)]
pub enum Directive {
    /// A claim's value; with its unit if the word `unit` or the unit itself follows.
    Num { stem: String, key: String, digits: Option<usize>, unit: Option<String> },
    /// The value of a parameter; digits and unit as for `Num`.
    Param { stem: String, name: String, digits: Option<usize>, unit: Option<String> },
    /// A number that is given.
    Given(String),
    /// Figures, side by side.
    Figure(Vec<(String, String)>),
    /// Pages as cards, each with a figure.
    Pages(Vec<(String, String)>),
    /// The frames of a moving figure.
    Stills { stem: String },
    /// Lines of an example: in its file, or in one of its directory (`STEM/FILE`).
    Listing { file: String, anchor: String },
    /// The locked output, or one section of it.
    Output { stem: String, section: Option<String> },
    /// A section as a table.
    Table { stem: String, section: String },
    /// A table of a record of measurements.
    Measured { record: String, table: String },
    /// The answer box.
    Check { stem: String },
    /// The field for a reader's own recording.
    Recording { stem: String, flags: String },
    /// What the page's exercise is.
    Exercise(Exercise),
    /// The table of the exercises whose stems begin so.
    Exercises { group: String },
    /// A link to a test.
    Test { file: String, name: String },
}

fn is_name(word: &str) -> bool {
    !word.is_empty() && word.bytes().all(|b| b.is_ascii_alphanumeric() || b == b'_' || b == b'-')
}

impl Directive {
    /// Reads what stands between the braces.
    ///
    /// # Errors
    /// An unknown directive, or one that is not written as the module's table says.
    pub fn read(inner: &str) -> Result<Self, String> {
        let mut words = inner.split_whitespace();
        let kind = words.next().unwrap_or("");
        let words: Vec<&str> = words.collect();
        let wrong = |form: &str| format!("{{{{{inner}}}}} must be written {{{{{form}}}}}");
        let pair = |word: &str| -> Option<(String, String)> {
            let (stem, name) = word.split_once(':')?;
            (is_name(stem) && is_name(name)).then(|| (stem.to_owned(), name.to_owned()))
        };
        match (kind, words.as_slice()) {
            ("num" | "param", [word, unit @ ..]) => {
                let form = match kind {
                    "num" => "num STEM:KEY}} or {{num STEM:KEY@DIGITS unit",
                    _ => "param STEM:NAME}} or {{param STEM:NAME@DIGITS unit",
                };
                let (word, digits) = match word.split_once('@') {
                    None => (*word, None),
                    Some((word, digits)) => match digits.parse::<usize>() {
                        Ok(digits @ 1..=15) => (word, Some(digits)),
                        _ => return Err(wrong("num STEM:KEY@DIGITS, from 1 to 15")),
                    },
                };
                let (stem, name) = pair(word).ok_or_else(|| wrong(form))?;
                let unit = (!unit.is_empty()).then(|| unit.join(" "));
                Ok(match kind {
                    "num" => Self::Num { stem, key: name, digits, unit },
                    _ => Self::Param { stem, name, digits, unit },
                })
            }
            ("num", _) => Err(wrong("num STEM:KEY}} or {{num STEM:KEY unit")),
            ("param", _) => Err(wrong("param STEM:NAME}} or {{param STEM:NAME unit")),
            ("stills", [stem]) if is_name(stem) => Ok(Self::Stills { stem: (*stem).to_owned() }),
            ("stills", _) => Err(wrong("stills STEM")),
            ("given", [number]) if number_html(number).is_some() => {
                Ok(Self::Given((*number).to_owned()))
            }
            ("given", _) => Err(wrong("given NUMBER")),
            ("figure", [first, more @ ..]) => {
                let (stem, name) = pair(first).ok_or_else(|| wrong("figure STEM:NAME NAME …"))?;
                let mut figures = vec![(stem.clone(), name)];
                for word in more {
                    let figure = match word.contains(':') {
                        true => pair(word),
                        false => is_name(word).then(|| (stem.clone(), (*word).to_owned())),
                    };
                    figures.push(figure.ok_or_else(|| wrong("figure STEM:NAME NAME …"))?);
                }
                Ok(Self::Figure(figures))
            }
            ("figure", _) => Err(wrong("figure STEM:NAME NAME …")),
            ("pages", [_, ..]) => {
                let pages = words.iter().map(|word| pair(word)).collect();
                let pages: Option<Vec<_>> = pages;
                let form = "pages STEM:NAME STEM:NAME …";
                pages.map(Self::Pages).ok_or_else(|| wrong(form))
            }
            ("listing", [word]) => {
                let found = word.split_once(':').filter(|(file, anchor)| {
                    let parts: Vec<&str> = file.split('/').collect();
                    parts.len() <= 2 && parts.into_iter().all(is_name) && is_name(anchor)
                });
                let (file, anchor) = found.ok_or_else(|| wrong("listing STEM:ANCHOR"))?;
                let (file, anchor) = (file.to_owned(), anchor.to_owned());
                Ok(Self::Listing { file, anchor })
            }
            ("listing", _) => Err(wrong("listing STEM:ANCHOR")),
            ("output", [word]) if is_name(word) => {
                Ok(Self::Output { stem: (*word).to_owned(), section: None })
            }
            ("output", [word]) => {
                let (stem, section) = pair(word).ok_or_else(|| wrong("output STEM:SECTION"))?;
                Ok(Self::Output { stem, section: Some(section) })
            }
            ("output", _) => Err(wrong("output STEM")),
            ("table", [word]) => {
                let (stem, section) = pair(word).ok_or_else(|| wrong("table STEM:SECTION"))?;
                Ok(Self::Table { stem, section })
            }
            ("table", _) => Err(wrong("table STEM:SECTION")),
            ("measured", [word]) => {
                let (record, table) = pair(word).ok_or_else(|| wrong("measured RECORD:TABLE"))?;
                Ok(Self::Measured { record, table })
            }
            ("measured", _) => Err(wrong("measured RECORD:TABLE")),
            ("check", [stem]) if is_name(stem) => Ok(Self::Check { stem: (*stem).to_owned() }),
            ("check", _) => Err(wrong("check STEM")),
            ("recording", [stem, flags @ ..])
                if is_name(stem) && flags.iter().all(|f| is_name(f)) =>
            {
                Ok(Self::Recording { stem: (*stem).to_owned(), flags: flags.join(" ") })
            }
            ("recording", _) => Err(wrong("recording STEM FLAG FLAG …")),
            ("exercise", _) => {
                let said = inner.trim_start().trim_start_matches("exercise");
                Exercise::read(said).map(Self::Exercise)
            }
            ("exercises", [group]) if is_name(group) => {
                Ok(Self::Exercises { group: (*group).to_owned() })
            }
            ("exercises", _) => Err(wrong("exercises GROUP")),
            ("test", [word]) => {
                let (file, name) = word.split_once("::").ok_or_else(|| wrong("test FILE::NAME"))?;
                // `src/a.rs::tests::name` names the same function.
                let name = name.rsplit("::").next().unwrap_or(name);
                if file.contains("..") || file.is_empty() || !is_name(name) {
                    return Err(wrong("test FILE::NAME"));
                }
                Ok(Self::Test { file: file.to_owned(), name: name.to_owned() })
            }
            ("test", _) => Err(wrong("test FILE::NAME")),
            _ => Err(format!(
                "unknown directive {{{{{inner}}}}}; there are num, param, given, figure, stills, \
                 listing, output, table, measured, check, recording, exercise, exercises, pages, test"
            )),
        }
    }

    /// Whether it has its line for itself.
    pub fn is_block(&self) -> bool {
        !matches!(self, Self::Num { .. } | Self::Param { .. } | Self::Given(_) | Self::Test { .. })
    }

    /// Whether the next paragraph is its caption.
    pub fn has_caption(&self) -> bool {
        matches!(self, Self::Figure(_) | Self::Stills { .. })
    }
}

/// The address of a source file in the book.
pub fn source_address(file: &str) -> String {
    format!("source/{file}.html")
}

/// What a `num` or a `param` shows: the number, its unit if it is to follow, and the claim.
struct Shown {
    value: String,
    unit: Option<String>,
    claim: Option<Claim>,
}

/// Reads a `num` or a `param`; `None` for other directives.
fn shown(page: &mut Page, directive: &Directive) -> Result<Option<Shown>, String> {
    let (stem, name, digits, asked) = match directive {
        Directive::Num { stem, key, digits, unit } => (stem, key, digits, unit),
        Directive::Param { stem, name, digits, unit } => (stem, name, digits, unit),
        _ => return Ok(None),
    };
    page.stems.push(stem.to_owned());
    let is_claim = matches!(directive, Directive::Num { .. });
    let claim = match is_claim {
        true => page.project.claim(stem, name)?,
        false => page.project.parameter(stem, name)?,
    };
    let value = match digits {
        None => claim.value.clone(),
        Some(digits) => shortened(&claim.value, *digits).ok_or_else(|| {
            let value = &claim.value;
            format!("{stem}:{name} = {value} cannot be rounded to {digits} digits")
        })?,
    };
    let unit = match asked.as_deref() {
        None => None,
        Some(_) if claim.unit == "-" => return Err(format!("{stem}:{name} has no unit")),
        Some(unit) if unit != "unit" && unit != claim.unit => {
            let own = &claim.unit;
            return Err(format!("the unit of {stem}:{name} is {own}, not {unit}"));
        }
        Some(_) => Some(claim.unit.clone()),
    };
    Ok(Some(Shown { value, unit, claim: is_claim.then_some(claim) }))
}

/// A number or a word with its unit, as HTML.
fn with_unit(value: &str, unit: Option<&str>) -> String {
    let value = number_html(value).unwrap_or_else(|| escape(value));
    match unit {
        None | Some("-") => value,
        Some(unit) => format!("{value}\u{202f}{}", unit_html(unit)),
    }
}

/// The sign of what a test checks.
const TICK: &str =
    "<svg viewBox=\"0 0 12 12\" aria-hidden=\"true\"><path d=\"M1.5 6.5l3 3.5 6-8\"/></svg>";

/// A directive within a line, as Markdown that may hold a mark.
///
/// # Errors
/// What is missing, or that the directive needs a line of its own.
pub fn inline(page: &mut Page, directive: &Directive) -> Result<String, String> {
    if let Some(shown) = shown(page, directive)? {
        let html = with_unit(&shown.value, shown.unit.as_deref());
        let Some(claim) = shown.claim else {
            return Ok(html);
        };
        // The bound is that of all digits.
        let mut proof = format!("<b>{}</b>", with_unit(&claim.value, Some(&claim.unit)));
        if let Some(bound) = number_html(&claim.bound).filter(|_| claim.bound != "0") {
            proof += &format!("<br>error below {bound}");
        }
        proof += &format!("<br>checked against: {}", notation::words(&claim.oracle));
        return Ok(page.proof("num", html, proof));
    }
    match directive {
        Directive::Given(number) => number_html(number).ok_or_else(|| "not a number".into()),
        Directive::Test { file, name } => {
            let test = page.project.test(file, name)?;
            page.sources.push(test.file.clone());
            let proof = format!(
                "checked by <a href=\"{}#L{}\">{}</a><br>in {}",
                source_address(&test.file),
                test.line,
                escape(&name.replace('_', " ")),
                escape(&test.file)
            );
            Ok(page.proof("tick", TICK.into(), proof))
        }
        _ => Err("this directive must have its line for itself".into()),
    }
}

/// A directive in a formula, as TeX.
///
/// # Errors
/// What is missing.
pub fn tex(page: &mut Page, directive: &Directive) -> Result<String, String> {
    if let Some(shown) = shown(page, directive)? {
        let mut tex = number_tex(&shown.value);
        if let Some(unit) = shown.unit {
            tex += &format!("\\,\\mathrm{{{}}}", unit.replace(' ', "\\,"));
        }
        return Ok(tex);
    }
    match directive {
        Directive::Given(number) => Ok(number_tex(number)),
        _ => Err("only {{num …}}, {{param …}} and {{given …}} may stand in a formula".into()),
    }
}

/// A directive in code, as plain text.
///
/// # Errors
/// What is missing.
pub fn plain(page: &mut Page, directive: &Directive) -> Result<String, String> {
    match shown(page, directive)? {
        Some(Shown { value, unit: Some(unit), .. }) => Ok(format!("{value} {unit}")),
        Some(shown) => Ok(shown.value),
        None => Err("only {{num …}} and {{param …}} may stand in code".into()),
    }
}

/// A directive that has its line for itself, as Markdown.
///
/// # Errors
/// What is missing.
pub fn block(
    page: &mut Page,
    directive: &Directive,
    caption: &str,
    indent: &str,
) -> Result<String, String> {
    let project: &Project = page.project;
    match directive {
        Directive::Figure(figures) => {
            let id = format!("fig-{}", figures[0].1);
            let marks = panels(page, figures)?;
            Ok(page.row(&marks, None, caption, indent, &id))
        }
        Directive::Pages(pages) => Ok(format!("{indent}{}\n\n", contents::html(project, pages)?)),
        Directive::Stills { stem } => {
            let mut names = project.figures(stem);
            names.retain(|name| name.starts_with("frame_"));
            if names.is_empty() {
                let file = Project::figure_file(stem, "frame_*");
                return Err(format!("there is no figure {file}"));
            }
            let frames: Vec<(String, String)> =
                names.into_iter().map(|name| (stem.clone(), name)).collect();
            let marks = panels(page, &frames)?;
            let player = Splice::Player { stem: stem.clone() };
            Ok(page.row(&marks, Some((stem, &player.mark(""))), caption, indent, "fig-frames"))
        }
        Directive::Listing { file, anchor } => {
            let stem = file.split_once('/').map_or(file.as_str(), |(stem, _)| stem);
            page.stems.push(stem.to_owned());
            let file = format!("examples/{file}.rs");
            let (code, line) = project.listing(&file, anchor)?;
            page.sources.push(file.clone());
            let head = format!(
                "<div class=\"code\"><div class=\"listing\"><a href=\"{}#L{line}\">{file}</a></div>",
                source_address(&file)
            );
            let code = fence("rust,noplayground", &code);
            Ok(indented(&format!("{head}\n\n{code}\n</div>\n\n"), indent))
        }
        Directive::Output { stem, section } => {
            page.stems.push(stem.clone());
            let command = format!("cargo run --example {stem}");
            let text = match section {
                None => for_reading(&project.output(stem)?).to_owned(),
                Some(section) => project.table(stem, section)?.to_string(),
            };
            let text = fence("console", &format!("$ {command}\n{}", text.trim_end()));
            let markdown = match section {
                Some(_) => format!("{text}\n"),
                None => format!(
                    "<details class=\"output\">\n<summary>What <code>{command}</code> prints</summary>\n\n\
                     {text}\n</details>\n\n"
                ),
            };
            Ok(indented(&markdown, indent))
        }
        Directive::Table { stem, section } => {
            page.stems.push(stem.clone());
            let mut found = project.table(stem, section)?;
            if section == times::SECTION {
                found = times::of(project, stem, &found)?.table;
            }
            let text = table::plain(&found);
            let mark = Splice::Table { stem: stem.clone(), section: section.clone() }.mark(&text);
            Ok(format!("{indent}<div class=\"box\">{mark}</div>\n\n"))
        }
        Directive::Measured { record, table } => {
            let (found, _) = measured::of(project, record, table)?;
            let mark = Splice::Measured { record: record.clone(), table: table.clone() }
                .mark(&table::plain(&found));
            Ok(format!("{indent}<div class=\"box\">{mark}</div>\n\n"))
        }
        Directive::Check { stem } => {
            page.stems.push(stem.clone());
            check::html(project, stem)?;
            let mark = Splice::Check { stem: stem.clone() }.mark("");
            Ok(format!("{indent}<div class=\"check\">{mark}</div>\n\n"))
        }
        Directive::Recording { stem, flags } => {
            page.stems.push(stem.clone());
            let mark = Splice::Recording { stem: stem.clone(), flags: flags.clone() }.mark("");
            Ok(format!("{indent}<div class=\"recordings\">{mark}</div>\n\n"))
        }
        Directive::Exercise(exercise) => Ok(format!("{indent}{}\n\n", exercise.html())),
        Directive::Exercises { group } => {
            exercises::html(project, group)?;
            let mark = Splice::Exercises { group: group.clone() }.mark("");
            Ok(format!("{indent}<div class=\"exercises\">{mark}</div>\n\n"))
        }
        Directive::Num { .. }
        | Directive::Param { .. }
        | Directive::Given(_)
        | Directive::Test { .. } => inline(page, directive),
    }
}

/// The names of some figures and their marks.
fn panels(page: &mut Page, figures: &[(String, String)]) -> Result<Vec<(String, String)>, String> {
    let mut marks = Vec::new();
    for (stem, name) in figures {
        page.stems.push(stem.clone());
        let svg = page.project.figure(stem, name)?;
        let alt = figure::alternative(&svg)
            .map_err(|e| format!("{}: {e}", Project::figure_file(stem, name)))?;
        let splice = Splice::Figure { stem: stem.clone(), name: name.clone() };
        let mark = splice.mark(&crate::text::unescape(alt));
        marks.push((format!("{stem}:{name}"), mark));
    }
    Ok(marks)
}

fn fence(language: &str, code: &str) -> String {
    // One tick more than the longest run inside.
    let longest = code.split(|c| c != '`').map(str::len).max().unwrap_or_default();
    let ticks = "`".repeat(longest.max(2) + 1);
    format!("{ticks}{language}\n{code}\n{ticks}\n")
}

fn indented(markdown: &str, indent: &str) -> String {
    markdown.split_inclusive('\n').map(|line| format!("{indent}{line}")).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn directives_are_read_strictly() {
        assert_eq!(
            Directive::read("num ch16_ex6_ladder:t_floor unit"),
            Ok(Directive::Num {
                stem: "ch16_ex6_ladder".into(),
                key: "t_floor".into(),
                digits: None,
                unit: Some("unit".into())
            })
        );
        assert_eq!(
            Directive::read("param a:spin-rate@3 rad/s"),
            Ok(Directive::Param {
                stem: "a".into(),
                name: "spin-rate".into(),
                digits: Some(3),
                unit: Some("rad/s".into())
            })
        );
        assert_eq!(
            Directive::read("figure a:x y b:z"),
            Ok(Directive::Figure(vec![
                ("a".into(), "x".into()),
                ("a".into(), "y".into()),
                ("b".into(), "z".into())
            ]))
        );
        assert_eq!(
            Directive::read("measured peers:ratios"),
            Ok(Directive::Measured { record: "peers".into(), table: "ratios".into() })
        );
        assert_eq!(
            Directive::read("test src/exact/ladder.rs::tests::at_release"),
            Ok(Directive::Test { file: "src/exact/ladder.rs".into(), name: "at_release".into() })
        );
        assert_eq!(
            Directive::read("test t::it"),
            Ok(Directive::Test { file: "t".into(), name: "it".into() })
        );
        // Each that is written wrongly, with how it must be written.
        let damaged = [
            ("num a", "num STEM:KEY}} or {{num STEM:KEY@DIGITS unit"),
            ("num a:", "num STEM:KEY}} or {{num STEM:KEY@DIGITS unit"),
            ("num a:b@0", "num STEM:KEY@DIGITS, from 1 to 15"),
            ("num a:b@16", "num STEM:KEY@DIGITS, from 1 to 15"),
            ("num a:b@x", "num STEM:KEY@DIGITS, from 1 to 15"),
            ("num", "num STEM:KEY}} or {{num STEM:KEY unit"),
            ("param a", "param STEM:NAME}} or {{param STEM:NAME@DIGITS unit"),
            ("param a:b@0", "num STEM:KEY@DIGITS, from 1 to 15"),
            ("param", "param STEM:NAME}} or {{param STEM:NAME unit"),
            ("stills", "stills STEM"),
            ("stills a:b", "stills STEM"),
            ("pages a:b c", "pages STEM:NAME STEM:NAME …"),
            ("given", "given NUMBER"),
            ("given pi", "given NUMBER"),
            ("given 1 2", "given NUMBER"),
            ("figure", "figure STEM:NAME NAME …"),
            ("figure a", "figure STEM:NAME NAME …"),
            ("figure a:b c:d:e", "figure STEM:NAME NAME …"),
            ("figure a:b ../c", "figure STEM:NAME NAME …"),
            ("listing a", "listing STEM:ANCHOR"),
            ("listing a:b c:d", "listing STEM:ANCHOR"),
            ("output", "output STEM"),
            ("output a b", "output STEM"),
            ("output a:", "output STEM:SECTION"),
            ("table a", "table STEM:SECTION"),
            ("table", "table STEM:SECTION"),
            ("check a:b", "check STEM"),
            ("check", "check STEM"),
            ("measured peers", "measured RECORD:TABLE"),
            ("recording", "recording STEM FLAG FLAG …"),
            ("recording a b:c", "recording STEM FLAG FLAG …"),
            ("measured", "measured RECORD:TABLE"),
            ("measured ../peers:ratios", "measured RECORD:TABLE"),
            ("test", "test FILE::NAME"),
            ("test x", "test FILE::NAME"),
            ("test ../x::y", "test FILE::NAME"),
            ("test ::y", "test FILE::NAME"),
            ("test x::", "test FILE::NAME"),
            ("test x::y z", "test FILE::NAME"),
        ];
        for (inner, form) in damaged {
            let message = format!("{{{{{inner}}}}} must be written {{{{{form}}}}}");
            assert_eq!(Directive::read(inner), Err(message), "{inner}");
        }
        for inner in ["nums a:b", "#include a.md", ""] {
            let message = Directive::read(inner).expect_err(inner);
            assert!(message.starts_with("unknown directive {{"), "{message}");
        }
        assert_eq!(Directive::read("num a:b@15").map(|d| d.is_block()), Ok(false));
        assert_eq!(Directive::read("check a").map(|d| d.is_block()), Ok(true));
    }

    #[test]
    fn a_fence_is_longer_than_what_it_holds() {
        assert_eq!(fence("x", "a"), "```x\na\n```\n");
        assert_eq!(fence("", "a `` b"), "```\na `` b\n```\n");
        assert_eq!(fence("", "``` b"), "````\n``` b\n````\n");
        assert_eq!(fence("", "b `````"), "``````\nb `````\n``````\n");
        assert_eq!(indented("a\n\nb", "> "), "> a\n> \n> b");
    }
}
