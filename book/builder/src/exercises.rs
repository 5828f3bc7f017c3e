//! What a page says of its exercise, and the table of all exercises that is made of it.
//!
//! A page says how hard its exercise is, how it is solved, which events there are and what it
//! teaches: `{{exercise 2 | closed form | the wall lets go | a contact that cannot pull}}`. Its title
//! is that of the page, its effects are those of the locked output; nothing else lists it.

use crate::directive::Directive;
use crate::notation;
use crate::project::Project;
use crate::text::escape;

/// How an exercise is solved.
const SOLVED: [&str; 3] = ["closed form", "closed form in part", "simulation"];

/// What a page says of its exercise.
#[derive(Debug, Clone, PartialEq)]
pub struct Exercise {
    /// How hard it is, from 1 to 3.
    level: usize,
    /// One of [`SOLVED`].
    solved: String,
    /// What happens on the way; `None` if nothing does.
    events: Option<String>,
    /// What it teaches, in a few words.
    teaches: String,
}

impl Exercise {
    /// Reads what stands behind the name of the directive.
    ///
    /// # Errors
    /// What it must look like.
    pub fn read(text: &str) -> Result<Self, String> {
        let fields: Vec<&str> = text.split('|').map(str::trim).collect();
        let [level, solved, events, teaches] = fields.as_slice() else {
            return Err("write {{exercise LEVEL | SOLVED | EVENTS | TEACHES}}".into());
        };
        let level = match level.parse() {
            Ok(level @ 1..=3) => level,
            _ => {
                return Err(format!("an exercise has the level 1, 2 or 3, not '{level}'"));
            }
        };
        if !SOLVED.contains(solved) {
            return Err(format!(
                "an exercise is solved by one of: {}; not '{solved}'",
                SOLVED.join(", ")
            ));
        }
        if events.is_empty() || teaches.is_empty() {
            return Err("an exercise says what it teaches, and its events or 'none'".into());
        }
        Ok(Self {
            level,
            solved: (*solved).into(),
            events: (*events != "none").then(|| (*events).into()),
            teaches: (*teaches).into(),
        })
    }

    /// Three dots, so many of them full.
    fn dots(&self) -> String {
        let dot = |n| {
            if n < self.level { "<i></i>" } else { "<i class=\"off\"></i>" }
        };
        let dots: String = (0..3).map(dot).collect();
        let level = self.level;
        format!(
            "<span class=\"dots\" role=\"img\" aria-label=\"difficulty {level} of 3\">{dots}</span>"
        )
    }

    /// The line on the page of the exercise.
    pub fn html(&self) -> String {
        let events = match &self.events {
            Some(events) => format!("Events: {}.", notation::words(events)),
            None => "No events.".into(),
        };
        let solved = capital(&self.solved);
        format!(
            "<p class=\"exercise\">{} {solved}. {events} <a href=\"exercises.html\">All the exercises</a></p>",
            self.dots()
        )
    }
}

fn capital(text: &str) -> String {
    let mut letters = text.chars();
    let first = letters.next().map(|c| c.to_uppercase().to_string());
    first.unwrap_or_default() + letters.as_str()
}

/// `16.6` and `The ladder` of the page's title; `F1` and the title where the notes have no number.
fn title(stem: &str, page: &str) -> Option<(String, String)> {
    let title = page.lines().next()?.strip_prefix("# ")?.trim();
    Some(match title.strip_prefix("Exercise ").and_then(|rest| rest.split_once(": ")) {
        Some((number, name)) => (number.into(), name.into()),
        None => {
            let number = stem.trim_start_matches("further_").split('_').next()?;
            (format!("F{number}"), title.into())
        }
    })
}

/// The effects in and left out, by their names in the locked output.
fn effects(project: &Project, stem: &str) -> Result<String, String> {
    let table = project.table(stem, "effects")?;
    let column = table.columns().iter().position(|column| column == "here");
    let column = column.ok_or(format!("the card of {stem} does not say what is here"))?;
    let mut html = String::new();
    for (here, word) in [("in", "Counts"), ("left out", "Leaves out")] {
        let of = table.rows().iter().filter(|row| row[column] == here);
        let names: Vec<String> = of.map(|row| notation::words(&row[0])).collect();
        if !names.is_empty() {
            html += &format!("<p><b>{word}</b> {}</p>", names.join("; "));
        }
    }
    Ok(html)
}

/// The table of the exercises whose stems begin with `group`, in the order of the stems.
///
/// # Errors
/// A page without a title or without a card of effects, a line on an exercise that is not whole.
pub fn html(project: &Project, group: &str) -> Result<String, String> {
    let stems = project.names("book/src", ".md");
    let mut rows = String::new();
    for stem in stems.iter().filter(|stem| stem.starts_with(group)) {
        let file = format!("book/src/{stem}.md");
        let page = project.read(&file)?;
        let (number, name) = title(stem, &page).ok_or(format!("{file} has no title"))?;
        let said = page.lines().find_map(|line| {
            line.strip_prefix("{{")?.strip_suffix("}}").filter(|line| line.starts_with("exercise "))
        });
        // A page that is just being written may not say it yet; a test asks it of all.
        let exercise = match said.map(Directive::read).transpose()? {
            Some(Directive::Exercise(exercise)) => Some(exercise),
            _ => None,
        };
        let said = |what: fn(&Exercise) -> String| exercise.as_ref().map_or("–".into(), what);
        rows += &format!(
            "<tr role=\"row\"><th scope=\"row\" role=\"rowheader\"><a href=\"{stem}.html\">\
             <span class=\"number\">{number}</span> {}</a><span class=\"solved\">{}</span></th>\
             <td role=\"cell\">{}</td>\
             <td role=\"cell\" data-label=\"Events\">{}</td>\
             <td role=\"cell\" class=\"effects\" data-label=\"Effects\">{}</td></tr>",
            escape(&name),
            said(|exercise| format!("{} {}", exercise.dots(), exercise.solved)),
            said(|exercise| notation::words(&exercise.teaches)),
            said(|exercise| notation::words(exercise.events.as_deref().unwrap_or("none"))),
            effects(project, stem)?
        );
    }
    if rows.is_empty() {
        return Ok("<p>To be written.</p>".into());
    }
    let heads = ["Exercise", "What it teaches", "Events", "Effects"];
    let heads = heads.map(|head| format!("<th scope=\"col\" role=\"columnheader\">{head}</th>"));
    Ok(format!(
        "<table class=\"exercises\" role=\"table\"><thead role=\"rowgroup\"><tr role=\"row\">{}</tr></thead>\
         <tbody role=\"rowgroup\">{rows}</tbody></table>",
        heads.concat()
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_on_an_exercise_is_whole_or_refused() {
        let read = |line: &str| Exercise::read(line).map(|exercise| exercise.html());
        let html = read("2 | closed form | the wall lets go | a contact").expect("it is whole");
        assert!(html.contains("difficulty 2 of 3\"><i></i><i></i><i class=\"off\"></i></span> Closed form. Events: the wall lets go."), "{html}");
        assert!(
            read("1 | simulation | none | chaos").is_ok_and(|html| html.contains("No events."))
        );
        for (line, words) in [
            ("4 | closed form | none | a", "1, 2 or 3"),
            ("1 | guessed | none | a", "closed form, closed form in part, simulation"),
            ("1 | simulation | | a", "or 'none'"),
            ("1 | simulation | none |", "teaches"),
            ("1 | simulation | none", "LEVEL | SOLVED"),
        ] {
            assert!(read(line).is_err_and(|error| error.contains(words)), "{line}");
        }
    }

    #[test]
    fn a_page_gives_its_number_and_its_name() {
        let of = |stem, page| title(stem, page).map(|(number, name)| number + "|" + &name);
        assert_eq!(
            of("ch16_ex6_ladder", "# Exercise 16.6: The ladder\n").as_deref(),
            Some("16.6|The ladder")
        );
        assert_eq!(
            of("further_2_gyrocompass", "# The gyrocompass").as_deref(),
            Some("F2|The gyrocompass")
        );
        assert_eq!(of("further_2_gyrocompass", "The gyrocompass"), None);
    }
}
