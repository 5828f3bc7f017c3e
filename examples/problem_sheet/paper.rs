//! The two files: the sheets, a page or more for each student, and the answers.

use super::address::{self, base64};
use super::draw::{Drawn, numbers};
use super::exercise::asked;
use super::statement::{Setting, stated};
use super::{Asked, Sheet};
use kit::{Claim, digits_asked};
use typeset::notation::words;
use typeset::text::{escape, number_html, shortened, unit_html};

/// The book's fonts, so that formulas look the same everywhere, without a network.
const FONTS: [(&str, &str, &[u8]); 4] = [
    ("Book Serif", "", include_bytes!("../../book/theme/fonts/serif.woff2")),
    ("Book Serif", "font-style: italic;", ITALIC),
    ("Book Serif", "font-weight: 600 700;", BOLD),
    ("Book Maths", "", include_bytes!("../../book/theme/fonts/maths.woff2")),
];
const ITALIC: &[u8] = include_bytes!("../../book/theme/fonts/serif-italic.woff2");
const BOLD: &[u8] = include_bytes!("../../book/theme/fonts/serif-semibold.woff2");

fn document(title: &str, more: &str, body: &str) -> String {
    let font = |(family, style, file): &(&str, &str, &[u8])| {
        let file = base64(file);
        format!(
            "@font-face {{ font-family: \"{family}\"; {style} src: url(\"data:font/woff2;base64,{file}\") format(\"woff2\"); }}\n"
        )
    };
    let fonts: String = FONTS.iter().map(font).collect();
    let (title, style) = (escape(title), include_str!("sheet.css"));
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <title>{title}</title>\n<style>\n{fonts}{style}{more}</style>\n</head>\n<body>\n{body}</body>\n</html>\n"
    )
}

/// The sheets.
///
/// # Errors
/// A statement that cannot be set, a set-up that cannot be drawn.
pub fn sheets(asked: &Asked, sheets: &[Sheet]) -> Result<String, String> {
    let mut body = String::new();
    for (s, sheet) in sheets.iter().enumerate() {
        let name = match &*sheet.student {
            "" => "<p class=\"student\">Name: <span class=\"line\"></span></p>".into(),
            name => format!("<p class=\"student\">{}</p>", escape(name)),
        };
        let title = escape(&asked.title);
        body += &format!("<main>\n<header><h1>{title}</h1>{name}</header>\n");
        for (n, drawn) in sheet.problems.iter().enumerate() {
            let place = format!("s{s}p{n}");
            body += &problem(asked, drawn, n + 1, &place)
                .map_err(|e| format!("{}: {e}", drawn.exercise.number))?;
        }
        body += &format!(
            "<footer>Numbers drawn with the seed {}. A link \u{201c}judge my answers\u{201d} opens the \
             page of the book with the numbers of this sheet: it carries the answers in a form that \
             cannot be read at a glance, but is no secret.</footer>\n</main>\n",
            asked.seed
        );
    }
    Ok(document(&asked.title, "", &body))
}

fn problem(asked: &Asked, drawn: &Drawn, n: usize, place: &str) -> Result<String, String> {
    let (exercise, stem) = (drawn.exercise, drawn.exercise.page.stem());
    let figures = exercise.page.figures_with(&numbers(&drawn.flags)?);
    let figures = figures.map_err(|e| e.to_string())?;
    let setting = Setting {
        stem,
        parameters: &address::parameters(drawn)?,
        figure: &|name| figures.iter().find(|f| f.name == name).map(|f| f.svg()),
        prefix: place,
        book: &asked.book,
    };
    let statement = setting.html(&exercise.problem)?;
    let besides = besides(drawn, setting.parameters);
    let link = escape(&format!("{}{}", asked.book, address::of(drawn)?));
    let title = escape(&exercise.title);
    let (questions, key) = questions(drawn);
    // Lines of it are broken before a flag.
    let command = format!("cargo run --example {stem} -- {} --check {key}=VALUE", drawn.typed());
    let command =
        command.replace(" --", "\n--").replace("\n-- ", " -- ").replace("\n--", "</span> <span>--");
    let command = format!("<span>{command}</span>");
    Ok(format!(
        "<section>\n<h2><span class=\"n\">{n}</span> {title}</h2>\n{statement}\
         <div class=\"asked\"><p><b>Give</b> (in brackets: how many digits)</p>\n{questions}{besides}\
         <p class=\"how\"><b>Check it.</b> <a href=\"{link}\">Judge my answers</a> in the book, or<br>\
         <code>{command}</code></p></div>\n</section>\n"
    ))
}

/// What the answers assume and the problem does not state.
fn besides(drawn: &Drawn, parameters: &[[String; 4]]) -> String {
    let stated = stated(&drawn.exercise.problem, drawn.exercise.page.stem());
    let unstated = parameters.iter().filter(|[name, ..]| !stated.contains(name));
    let item = |[_, value, unit, meaning]: &[String; 4]| {
        let (value, meaning, unit) =
            (number_html(value)?, words(meaning), with(["\u{202f}", ""], unit));
        Some(format!("{meaning}: <span class=\"glued\">{value}{unit}</span>"))
    };
    let items = unstated.filter_map(item).collect::<Vec<_>>().join("; ");
    match items.as_str() {
        "" => items,
        _ => format!("<p class=\"besides\">Taken besides, where it matters: {items}.</p>"),
    }
}

/// A unit, if it is one, between these.
fn with([open, close]: [&str; 2], unit: &str) -> String {
    if unit == "-" { String::new() } else { format!("{open}{}{close}", unit_html(unit)) }
}

/// The quantities asked for, under their groups, and the key of the first.
fn questions(drawn: &Drawn) -> (String, String) {
    let claims = asked(&drawn.report);
    let key = claims.first().map_or("KEY", |claim| &claim.key).to_owned();
    let mut groups: Vec<Option<&str>> = Vec::new();
    for claim in &claims {
        if !groups.contains(&claim.group.as_deref()) {
            groups.push(claim.group.as_deref());
        }
    }
    let mut html = String::new();
    for group in groups {
        let of = claims.iter().filter(|claim| claim.group.as_deref() == group);
        let item = |claim: &&Claim| {
            let (what, key, unit) =
                (words(&claim.meaning), &claim.key, with([" in ", ""], &claim.unit));
            let digits = digits_asked(claim.judged_within);
            format!("<li>{what}{unit} ({digits}) <code>{key}</code></li>")
        };
        let items: String = of.map(item).collect();
        let name = group.map(|name| format!("<p class=\"group\">{}</p>", words(name)));
        html += &format!("<div>{}<ul>{items}</ul></div>\n", name.unwrap_or_default());
    }
    (format!("<div class=\"groups\">{html}</div>"), key)
}

/// A value with two digits more than are asked for, or all that its bound supports.
pub fn answer(claim: &Claim) -> String {
    let printed = claim.printed();
    let digits = digits_asked(claim.judged_within) as usize + 2;
    // One that ends in a 5 is not rounded there, but a digit later.
    (digits..16).find_map(|digits| shortened(&printed, digits)).unwrap_or(printed)
}

/// The answers: for each problem a table with a row for each student.
pub fn answers(asked_for: &Asked, sheets: &[Sheet]) -> String {
    let title = format!("{}: answers", asked_for.title);
    let number = |text: &str| number_html(text).unwrap_or_else(|| escape(text));
    let mut body = format!(
        "<main>\n<header><h1>{}</h1></header>\n<p>Numbers drawn with the seed {}. Each answer was \
         confirmed by a second route, as on the page of its exercise.</p>\n",
        escape(&title),
        asked_for.seed
    );
    let count = sheets.first().map_or(0, |sheet| sheet.problems.len());
    for n in 0..count {
        let exercise = sheets[0].problems[n].exercise;
        let claims = asked(exercise.usual());
        let flags = sheets[0].problems[n].flags.iter();
        let given: String = flags.map(|(flag, _)| format!("<th>{flag}</th>")).collect();
        let head = |claim: &&Claim| {
            let unit = with(["<br><small>", "</small>"], &claim.unit);
            let key = claim.key.replace('_', "_<wbr>");
            format!("<th class=\"a\"><code>{key}</code>{unit}</th>")
        };
        let heads: String = claims.iter().map(head).collect();
        let mut rows = String::new();
        for sheet in sheets {
            let drawn = &sheet.problems[n];
            let value = |(_, value): &(_, String)| format!("<td>{}</td>", number(value));
            let found = |claim| format!("<td class=\"a\">{}</td>", number(&answer(claim)));
            let values: String = drawn.flags.iter().map(value).collect();
            let found: String = asked(&drawn.report).into_iter().map(found).collect();
            rows += &format!("<tr><th>{}</th>{values}{found}</tr>\n", escape(&sheet.student));
        }
        let meaning = |c: &&Claim| format!("<code>{}</code> {}", c.key, words(&c.meaning));
        body += &format!(
            "<section>\n<h2><span class=\"n\">{}</span> {}</h2>\n<div class=\"wide\"><table>\n\
             <tr><th></th>{given}{heads}</tr>\n{rows}</table></div>\n<p class=\"legend\">{}</p>\n</section>\n",
            n + 1,
            escape(&exercise.title),
            claims.iter().map(meaning).collect::<Vec<_>>().join("; ")
        );
    }
    // Wide tables want a wide paper.
    let landscape = "@page { size: A4 landscape; }\nmain { max-width: none; }\n";
    document(&title, landscape, &(body + "</main>\n"))
}
