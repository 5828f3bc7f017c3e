//! The answer box: a form that judges a reader's number as `--check` does.

use crate::notation;
use crate::project::Project;
use crate::text::{escape, number_html, unit_html};
use kit::{Table, digits_asked, name_of_flag};
use serde_json::{Value, json};

/// A claim that a reader can answer.
struct Question {
    label: String,
    group: Option<String>,
    data: Value,
}

/// The box for an example. The script `theme/check.js` gives its data and the answer to the page's
/// module, which judges by `Claim::verdict`.
///
/// # Errors
/// If the locked output has no `checks`, or a check without its claim.
pub fn html(project: &Project, stem: &str) -> Result<String, String> {
    let questions = questions(project, stem)?;
    let checks: Vec<&Value> = questions.iter().map(|question| &question.data).collect();
    let data = json!({"checks": checks});
    // In a script element only `</` could end it.
    let data = data.to_string().replace("</", "<\\/");
    let first = questions.first().map(|q| &q.data);
    let digits = first.and_then(|data| data["digits"].as_u64()).unwrap_or(4);
    Ok(format!(
        "<form class=\"answer\" data-stem=\"{stem}\" autocomplete=\"off\" aria-label=\"Check your answer: {stem}\">\
         <p class=\"head\">Check your answer</p>{}\
         <label>I computed <select name=\"key\">{}</select></label>\
         <label>and found <input name=\"value\" type=\"text\" spellcheck=\"false\" \
         placeholder=\"2/3, 1.5e-5, acos(0.4), 0.88 s\" required></label>\
         <button type=\"submit\">Check</button>\
         <p class=\"asked\">Give {digits} digits.</p>\
         <output aria-live=\"polite\"></output>\
         <script type=\"application/json\">{data}</script>\
         <noscript>This box needs scripts; the command line does the same: \
         <code>cargo run --example {stem} -- --check KEY=VALUE</code>.</noscript></form>",
        assumed(project, stem),
        options(&questions),
    ))
}

/// What the answers assume: the parameters of the locked run, without the error asked for.
fn assumed(project: &Project, stem: &str) -> String {
    let Ok(parameters) = project.table(stem, "parameters") else {
        return String::new();
    };
    let one = |row: &Vec<String>| {
        let [flag, value, unit, meaning] = row.as_slice() else {
            return None;
        };
        // The script puts the numbers of a problem sheet in their places.
        let (name, typed) = (name_of_flag(flag), escape(value));
        let value = number_html(value).unwrap_or_else(|| typed.clone());
        let unit = match unit.as_str() {
            "-" => String::new(),
            unit => format!("\u{202f}{}", unit_html(unit)),
        };
        let meaning = notation::words(meaning);
        let item = || {
            format!(
                "<li data-name=\"{name}\" data-value=\"{typed}\">{meaning}: <span>{value}</span>{unit}</li>"
            )
        };
        (flag != "--tolerance").then(item)
    };
    let all: Vec<String> = parameters.rows().iter().filter_map(one).collect();
    format!(
        "<details class=\"assumed\"><summary>For these parameters</summary><ul>{}</ul></details>",
        all.concat()
    )
}

/// The claims that a reader would compute: those with a group, or all if none has one.
fn questions(project: &Project, stem: &str) -> Result<Vec<Question>, String> {
    let checks = project.table(stem, "checks")?;
    let slips = project.table(stem, "slips").ok();
    let column = |name: &str| {
        let at = checks.columns().iter().position(|column| column == name);
        at.ok_or(format!("the checks of {stem} have no column '{name}'"))
    };
    let (key, within, meaning) = (column("key")?, column("within")?, column("meaning")?);
    let group = column("group").ok();
    let group_of = |row: &[String]| {
        let name = group.map(|at| row[at].as_str());
        name.filter(|name| *name != "-").map(str::to_owned)
    };
    let grouped = checks.rows().iter().any(|row| group_of(row).is_some());
    let mut questions = Vec::new();
    for row in checks.rows() {
        let group = group_of(row);
        if grouped && group.is_none() {
            continue;
        }
        let (unit, data) = data(project, stem, &row[key], &row[within], slips.as_ref())?;
        let unit = match unit.as_str() {
            "-" => String::new(),
            unit => format!(" ({})", notation::symbols(unit)),
        };
        questions.push(Question { label: notation::symbols(&row[meaning]) + &unit, group, data });
    }
    Ok(questions)
}

/// The unit of a claim, and what the script needs to judge an answer.
fn data(
    project: &Project,
    stem: &str,
    key: &str,
    within: &str,
    slips: Option<&Table>,
) -> Result<(String, Value), String> {
    let claim = project.claim(stem, key)?;
    let number = |name: &str, text: &str| -> Result<f64, String> {
        text.parse().map_err(|_| format!("{stem}: the {name} of {key} is no number: {text}"))
    };
    let known: Result<Vec<_>, String> = slips
        .iter()
        .flat_map(|table| table.rows())
        .filter(|slip| slip[0] == *key)
        .map(|slip| Ok(json!({"value": number("slip", &slip[1])?, "hint": slip[2]})))
        .collect();
    let within = number("tolerance", within)?;
    let data = json!({
        "key": key,
        "value": number("value", &claim.value)?,
        "printed": claim.value,
        "unit": claim.unit,
        "bound": number("bound", &claim.bound)?,
        "within": within,
        "digits": digits_asked(within),
        "slips": known?,
    });
    Ok((claim.unit, data))
}

/// The questions as options, those of a group under its name.
fn options(questions: &[Question]) -> String {
    let option = |question: &Question| {
        let key = question.data["key"].as_str().unwrap_or("");
        format!("<option value=\"{key}\">{}</option>", escape(&question.label))
    };
    let mut groups: Vec<Option<&str>> = Vec::new();
    for question in questions {
        if !groups.contains(&question.group.as_deref()) {
            groups.push(question.group.as_deref());
        }
    }
    let mut html = String::new();
    for group in groups {
        let of = questions.iter().filter(|q| q.group.as_deref() == group);
        let options: Vec<String> = of.map(option).collect();
        html += &match group {
            None => options.concat(),
            Some(name) => format!(
                "<optgroup label=\"{}\">{}</optgroup>",
                escape(&notation::symbols(name)),
                options.concat()
            ),
        };
    }
    html
}
