//! The directives of a page: what they may say, and what becomes of them.
//!
//! | directive | gives |
//! |---|---|
//! | `{{num STEM:KEY}}` | a claim's value from the locked output |
//! | `{{num STEM:KEY rad/s}}` | the same with its unit, which must be this one (or: `unit`) |
//! | `{{num STEM:KEY@4 rad/s}}` | the same to 4 significant digits, where prose wants no more |
//! | `{{given 9.81}}` | a number that is given, not computed |
//! | `{{figure STEM:NAME NAME …}}` | locked figures side by side; the next paragraph is their caption |
//! | `{{figure measured:RECORD-TABLE}}` | error against time, drawn from a table of `benches/record/RECORD.txt` |
//! | `{{listing STEM:ANCHOR}}` | the lines between the anchors in `examples/STEM.rs` |
//! | `{{output STEM}}`, `{{output STEM:SECTION}}` | the locked output, or one section of it, with the command |
//! | `{{table STEM:SECTION}}` | a section of the locked output as a table; `accuracy` with its times |
//! | `{{measured RECORD:TABLE}}` | a table of `benches/record/RECORD.txt`, and under it on what it was measured |
//! | `{{check STEM}}` | the answer box |
//! | `{{test FILE::NAME}}` | a link to the test, which must exist |

use crate::check;
use crate::expand::Page;
use crate::figure;
use crate::measured;
use crate::project::{Claim, Project};
use crate::splice::Splice;
use crate::table;
use crate::text::{escape, number_html, number_tex, shortened, unit_html};
use crate::times;
use rotation_dynamics::report::for_reading;

/// A directive, read but not resolved.
#[derive(Debug, Clone, PartialEq)]
pub enum Directive {
    /// A claim's value; with its unit if the word `unit` or the unit itself follows.
    Num {
        stem: String,
        key: String,
        digits: Option<usize>,
        unit: Option<String>,
    },
    /// A number that is given.
    Given(String),
    /// Figures, side by side.
    Figure(Vec<(String, String)>),
    /// Lines of an example.
    Listing { stem: String, anchor: String },
    /// The locked output, or one section of it.
    Output {
        stem: String,
        section: Option<String>,
    },
    /// A section as a table.
    Table { stem: String, section: String },
    /// A table of a record of measurements.
    Measured { record: String, table: String },
    /// The answer box.
    Check { stem: String },
    /// A link to a test.
    Test { file: String, name: String },
}

fn is_name(word: &str) -> bool {
    !word.is_empty()
        && word
            .bytes()
            .all(|b| b.is_ascii_alphanumeric() || b == b'_' || b == b'-')
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
            ("num", [word, unit @ ..]) => {
                let (word, digits) = match word.split_once('@') {
                    None => (*word, None),
                    Some((word, digits)) => match digits.parse::<usize>() {
                        Ok(digits @ 1..=15) => (word, Some(digits)),
                        _ => return Err(wrong("num STEM:KEY@DIGITS, from 1 to 15")),
                    },
                };
                let (stem, key) =
                    pair(word).ok_or_else(|| wrong("num STEM:KEY}} or {{num STEM:KEY unit"))?;
                let unit = (!unit.is_empty()).then(|| unit.join(" "));
                Ok(Self::Num {
                    stem,
                    key,
                    digits,
                    unit,
                })
            }
            ("num", _) => Err(wrong("num STEM:KEY}} or {{num STEM:KEY unit")),
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
            ("listing", [word]) => {
                let (stem, anchor) = pair(word).ok_or_else(|| wrong("listing STEM:ANCHOR"))?;
                Ok(Self::Listing { stem, anchor })
            }
            ("listing", _) => Err(wrong("listing STEM:ANCHOR")),
            ("output", [word]) if is_name(word) => Ok(Self::Output {
                stem: (*word).to_owned(),
                section: None,
            }),
            ("output", [word]) => {
                let (stem, section) = pair(word).ok_or_else(|| wrong("output STEM:SECTION"))?;
                Ok(Self::Output {
                    stem,
                    section: Some(section),
                })
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
            ("check", [stem]) if is_name(stem) => Ok(Self::Check {
                stem: (*stem).to_owned(),
            }),
            ("check", _) => Err(wrong("check STEM")),
            ("test", [word]) => {
                let (file, name) = word
                    .split_once("::")
                    .ok_or_else(|| wrong("test FILE::NAME"))?;
                // `src/a.rs::tests::name` names the same function.
                let name = name.rsplit("::").next().unwrap_or(name);
                if file.contains("..") || file.is_empty() || !is_name(name) {
                    return Err(wrong("test FILE::NAME"));
                }
                Ok(Self::Test {
                    file: file.to_owned(),
                    name: name.to_owned(),
                })
            }
            ("test", _) => Err(wrong("test FILE::NAME")),
            _ => Err(format!(
                "unknown directive {{{{{inner}}}}}; there are num, given, figure, listing, output, \
                 table, measured, check, test"
            )),
        }
    }

    /// Whether it has its line for itself.
    pub fn is_block(&self) -> bool {
        !matches!(self, Self::Num { .. } | Self::Given(_) | Self::Test { .. })
    }
}

/// The address of a source file in the book.
pub fn source_address(file: &str) -> String {
    format!("source/{file}.html")
}

/// The claim of a `num`, and its unit if it is to follow.
fn claimed(
    page: &mut Page,
    stem: &str,
    key: &str,
    digits: Option<usize>,
    unit: Option<&str>,
) -> Result<(Claim, Option<String>), String> {
    page.stems.push(stem.to_owned());
    let mut claim = page.project.claim(stem, key)?;
    if let Some(digits) = digits {
        claim.value = shortened(&claim.value, digits).ok_or_else(|| {
            format!(
                "{stem}:{key} = {} cannot be rounded to {digits} digits",
                claim.value
            )
        })?;
    }
    let shown = match unit {
        None => None,
        Some(_) if claim.unit == "-" => {
            return Err(format!("{stem}:{key} has no unit"));
        }
        Some(unit) if unit != "unit" && unit != claim.unit => {
            return Err(format!(
                "the unit of {stem}:{key} is {}, not {unit}",
                claim.unit
            ));
        }
        Some(_) => Some(claim.unit.clone()),
    };
    Ok((claim, shown))
}

/// A directive within a line, as HTML.
///
/// # Errors
/// What is missing, or that the directive needs a line of its own.
pub fn inline(page: &mut Page, directive: &Directive) -> Result<String, String> {
    match directive {
        Directive::Num {
            stem,
            key,
            digits,
            unit,
        } => {
            let (claim, unit) = claimed(page, stem, key, *digits, unit.as_deref())?;
            let mut value = number_html(&claim.value).unwrap_or_else(|| escape(&claim.value));
            if let Some(unit) = unit {
                value += &format!("\u{202f}{}", unit_html(&unit));
            }
            let bound = match number_html(&claim.bound) {
                Some(_) if claim.bound != "0" => format!("error below {}; ", claim.bound),
                _ => String::new(),
            };
            // The bound is that of all digits, which the reader sees by pointing at the number.
            let all = match digits {
                Some(_) => format!("{}, ", page.project.claim(stem, key)?.value),
                None => String::new(),
            };
            Ok(format!(
                "<span class=\"num\" title=\"{}{}checked against {}\">{value}</span>",
                escape(&all),
                escape(&bound),
                escape(&claim.oracle)
            ))
        }
        Directive::Given(number) => number_html(number).ok_or_else(|| "not a number".into()),
        Directive::Test { file, name } => {
            let test = page.project.test(file, name)?;
            page.sources.push(test.file.clone());
            Ok(format!(
                "<a class=\"test\" href=\"{}#L{}\" title=\"{}\">checked by <code>{}</code></a>",
                source_address(&test.file),
                test.line,
                escape(&test.file),
                escape(name)
            ))
        }
        _ => Err("this directive must have its line for itself".into()),
    }
}

/// A directive in a formula, as TeX.
///
/// # Errors
/// What is missing.
pub fn tex(page: &mut Page, directive: &Directive) -> Result<String, String> {
    match directive {
        Directive::Num {
            stem,
            key,
            digits,
            unit,
        } => {
            let (claim, unit) = claimed(page, stem, key, *digits, unit.as_deref())?;
            let mut tex = number_tex(&claim.value);
            if let Some(unit) = unit {
                tex += &format!("\\,\\mathrm{{{}}}", unit.replace(' ', "\\,"));
            }
            Ok(tex)
        }
        Directive::Given(number) => Ok(number_tex(number)),
        _ => Err("only {{num …}} and {{given …}} may stand in a formula".into()),
    }
}

/// A directive in code, as plain text.
///
/// # Errors
/// What is missing.
pub fn plain(page: &mut Page, directive: &Directive) -> Result<String, String> {
    match directive {
        Directive::Num {
            stem,
            key,
            digits,
            unit,
        } => {
            let (claim, unit) = claimed(page, stem, key, *digits, unit.as_deref())?;
            Ok(match unit {
                Some(unit) => format!("{} {unit}", claim.value),
                None => claim.value,
            })
        }
        _ => Err("only {{num …}} may stand in code".into()),
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
            let mut marks = Vec::new();
            for (stem, name) in figures {
                page.stems.push(stem.clone());
                let svg = project.figure(stem, name)?;
                let alt = figure::alternative(&svg)
                    .map_err(|e| format!("{}: {e}", Project::figure_file(stem, name)))?;
                let splice = Splice::Figure {
                    stem: stem.clone(),
                    name: name.clone(),
                };
                marks.push(splice.mark(&crate::text::unescape(alt)));
            }
            let id = format!("fig-{}", figures[0].1);
            Ok(figure::row(&marks, caption, indent, &id))
        }
        Directive::Listing { stem, anchor } => {
            page.stems.push(stem.clone());
            let (code, line) = project.listing(stem, anchor)?;
            let file = format!("examples/{stem}.rs");
            page.sources.push(file.clone());
            let head = format!(
                "<div class=\"listing\"><a href=\"{}#L{line}\">{file}</a></div>",
                source_address(&file)
            );
            Ok(indented(
                &format!("{head}\n\n{}\n", fence("rust,noplayground", &code)),
                indent,
            ))
        }
        Directive::Output { stem, section } => {
            page.stems.push(stem.clone());
            let command = format!("cargo run --example {stem}");
            let text = match section {
                None => for_reading(&project.output(stem)?).to_owned(),
                Some(section) => project.table(stem, section)?.to_string(),
            };
            let text = format!("$ {command}\n{}", text.trim_end());
            Ok(indented(&format!("{}\n", fence("console", &text)), indent))
        }
        Directive::Table { stem, section } => {
            page.stems.push(stem.clone());
            let mut found = project.table(stem, section)?;
            if section == times::SECTION {
                found = times::of(project, stem, &found)?.table;
            }
            let text = table::plain(&found);
            let mark = Splice::Table {
                stem: stem.clone(),
                section: section.clone(),
            }
            .mark(&text);
            Ok(format!("{indent}<div class=\"scroll\">{mark}</div>\n\n"))
        }
        Directive::Measured { record, table } => {
            let (found, _) = measured::of(project, record, table)?;
            let mark = Splice::Measured {
                record: record.clone(),
                table: table.clone(),
            }
            .mark(&table::plain(&found));
            Ok(format!("{indent}<div class=\"scroll\">{mark}</div>\n\n"))
        }
        Directive::Check { stem } => {
            page.stems.push(stem.clone());
            check::html(project, stem)?;
            let mark = Splice::Check { stem: stem.clone() }.mark("");
            Ok(format!("{indent}<div class=\"check\">{mark}</div>\n\n"))
        }
        Directive::Num { .. } | Directive::Given(_) | Directive::Test { .. } => {
            inline(page, directive)
        }
    }
}

fn fence(language: &str, code: &str) -> String {
    // One tick more than the longest run inside.
    let longest = code
        .split(|c| c != '`')
        .map(str::len)
        .max()
        .unwrap_or_default();
    let ticks = "`".repeat(longest.max(2) + 1);
    format!("{ticks}{language}\n{code}\n{ticks}\n")
}

fn indented(markdown: &str, indent: &str) -> String {
    markdown
        .split_inclusive('\n')
        .map(|line| format!("{indent}{line}"))
        .collect()
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
            Directive::read("figure a:x y b:z"),
            Ok(Directive::Figure(vec![
                ("a".into(), "x".into()),
                ("a".into(), "y".into()),
                ("b".into(), "z".into())
            ]))
        );
        assert_eq!(
            Directive::read("measured peers:ratios"),
            Ok(Directive::Measured {
                record: "peers".into(),
                table: "ratios".into()
            })
        );
        assert_eq!(
            Directive::read("test src/exact/ladder.rs::tests::at_release"),
            Ok(Directive::Test {
                file: "src/exact/ladder.rs".into(),
                name: "at_release".into()
            })
        );
        let damaged = [
            "num a",
            "num a:b@0",
            "num a:b@x",
            "num",
            "nums a:b",
            "figure",
            "listing a",
            "check a:b",
            "measured peers",
            "measured ../peers:ratios",
            "test ../x::y",
            "given pi",
            "#include a.md",
        ];
        for inner in damaged {
            assert!(Directive::read(inner).is_err(), "{inner}");
        }
    }
}
