//! The answer box: a form that judges a reader's number as `--check` does.

use crate::notation::symbols;
use crate::project::Project;
use crate::text::escape;
use rotation_dynamics::report::{RECIPROCAL, USUAL_SLIPS};
use serde_json::json;

/// The box for an example. The script in `theme/check.js` reads the data and judges by
/// the rules of `Claim::verdict`.
///
/// # Errors
/// If the locked output has no `checks`, or a check without its claim.
pub fn html(project: &Project, stem: &str) -> Result<String, String> {
    let checks = project.table(stem, "checks")?;
    let slips = project.table(stem, "slips").ok();
    let mut data = Vec::new();
    let mut options = String::new();
    for row in checks.rows() {
        let [key, within, meaning, ..] = row.as_slice() else {
            return Err(format!("the checks of {stem} must have three columns"));
        };
        let claim = project.claim(stem, key)?;
        let number = |name: &str, text: &str| -> Result<f64, String> {
            text.parse()
                .map_err(|_| format!("{stem}: the {name} of {key} is no number: {text}"))
        };
        let known: Result<Vec<_>, String> = slips
            .iter()
            .flat_map(|table| table.rows())
            .filter(|slip| slip[0] == *key)
            .map(|slip| Ok(json!({"value": number("slip", &slip[1])?, "hint": slip[2]})))
            .collect();
        data.push(json!({
            "key": key,
            "value": number("value", &claim.value)?,
            "bound": number("bound", &claim.bound)?,
            "within": number("tolerance", within)?,
            "slips": known?,
        }));
        let unit = match claim.unit.as_str() {
            "-" => String::new(),
            unit => format!(" ({unit})"),
        };
        options += &format!(
            "<option value=\"{key}\">{}{}</option>",
            escape(&symbols(meaning)),
            escape(&unit)
        );
    }
    let usual: Vec<_> = USUAL_SLIPS
        .iter()
        .map(|(factor, hint, _)| json!({"factor": factor, "hint": hint}))
        .collect();
    let data = json!({"checks": data, "usual": usual, "reciprocal": RECIPROCAL});
    // In a script element only `</` could end it.
    let data = data.to_string().replace("</", "<\\/");
    Ok(format!(
        "<form class=\"answer\" autocomplete=\"off\">\
         <label>I computed <select name=\"key\">{options}</select></label>\
         <label>and found <input name=\"value\" type=\"text\" inputmode=\"decimal\" \
         placeholder=\"a number\" required></label>\
         <button type=\"submit\">Check</button>\
         <output aria-live=\"polite\"></output>\
         <script type=\"application/json\">{data}</script>\
         <noscript>This box needs scripts; the command line does the same: \
         <code>cargo run --example {stem} -- --check KEY=VALUE</code>.</noscript></form>"
    ))
}
