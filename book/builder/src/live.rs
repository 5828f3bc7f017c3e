//! What moves in a page: the markup of players, Run buttons and the bench of methods, and the
//! modules beside the pages.
//!
//! The modules and their index (`book/modules`, made by `book/live/modules.mjs`) hold the code of the
//! examples; `theme/live.js` and its kin load them when they are touched. A page without them, or
//! in a browser that cannot run them, is as it was: nothing of this is shown.

use crate::modules;
use crate::notation;
use crate::project::Project;
use crate::text::{escape, number_html, unescape, unit_html};
use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use kit::{STEPPING, Table};
use serde_json::{Map, Value, json};
use std::collections::{BTreeMap, BTreeSet};

/// What compiles modules and calls them, in a worker. A page that is opened as a file may start no
/// worker from one: the source comes as a text.
const SOURCE: &str = "book/theme/module.js";

/// What runs commands, loaded when the first is run, and what reads recordings, loaded by the pages that
/// have a field for them.
const LATER: [&str; 2] = ["run", "recording"];

/// How a command begins that runs an example.
const COMMAND: &str = "cargo run --example ";

/// Shows the controls where they can work, before anything is laid out.
const ABLE: &str = "<script>if(window.WebAssembly&&window.DecompressionStream&&window.Worker)\
    document.documentElement.classList.add('live')</script>";

/// The modules that there are: `{"pages": {STEM: {"module", "page", "declared"}}, "palette":
/// [{"name"}]}`: the file of the page's part of the book, and the page's number in it.
pub struct Modules {
    index: Value,
    /// The bytes of each, by the names of the files.
    files: BTreeMap<String, Vec<u8>>,
}

impl Modules {
    /// Those of the project; `None` before they are made.
    ///
    /// # Errors
    /// An index, or a module that it names, that cannot be read.
    pub fn of(project: &Project) -> Result<Option<Self>, String> {
        let directory = modules::directory(project);
        let file = format!("{directory}/index.json");
        if !project.path(&file).is_file() {
            return Ok(None);
        }
        let index = serde_json::from_str(&project.read(&file)?);
        let index: Value = index.map_err(|e| format!("{file}: {e}"))?;
        let (Some(pages), true) = (index["pages"].as_object(), index["palette"].is_array()) else {
            return Err(format!("{file} must hold \"pages\" and \"palette\""));
        };
        let names = pages.values().filter_map(|page| page["module"].as_str());
        let names: BTreeSet<String> = names.map(str::to_owned).collect();
        let files = names.into_iter().map(|name| {
            let file = format!("{directory}/{name}");
            let bytes = std::fs::read(project.path(&file));
            Ok((name, bytes.map_err(|e| format!("cannot read {file}: {e}"))?))
        });
        let files = files.collect::<Result<_, String>>()?;
        Ok(Some(Self { index, files }))
    }

    pub(crate) fn page(&self, stem: &str) -> Option<&Map<String, Value>> {
        self.index["pages"].get(stem)?.as_object()
    }

    pub(crate) fn flags(&self, stem: &str) -> &[Value] {
        let declared = self.page(stem).and_then(|page| page.get("declared"));
        let flags = declared.and_then(|declared| declared["flags"].as_array());
        flags.map_or(&[], Vec::as_slice)
    }

    /// What plays the moving picture of `stem`: its bar, and the controls of the parameters that it
    /// shows, two or three open, the others in a fold. Nothing if it does not move.
    pub fn player(&self, stem: &str, prefix: &str) -> String {
        let declared = self.page(stem).map_or(&Value::Null, |page| &page["declared"]);
        if declared["moves"] != true {
            return String::new();
        }
        let shown = |flag: &&Value| {
            let seen = declared["seen"].as_array().is_some_and(|seen| seen.contains(&flag["name"]));
            // A control begins at what the picture has; an effect may be out.
            seen && (flag["kind"] == "effect" || flag["shown"].is_string())
        };
        let flags = self.flags(stem).iter().filter(shown);
        let (open, more): (Vec<_>, Vec<_>) = flags.partition(|flag| flag["title"].is_string());
        let knobs = |flags: &[&Value]| {
            let knobs: String = flags.iter().map(|flag| knob(flag, prefix)).collect();
            if knobs.is_empty() { knobs } else { format!("<div class=\"knobs\">{knobs}</div>") }
        };
        let (open, more) = (knobs(&open), knobs(&more));
        let fold = match more.is_empty() {
            true => String::new(),
            false => format!(
                "<details class=\"fold\"><summary>More parameters</summary>{more}</details>"
            ),
        };
        let turns = if declared["turns"] == true { " turns" } else { "" };
        format!(
            "<div class=\"player{turns}\" role=\"group\" aria-label=\"Moving picture\" data-stem=\"{stem}\">\
             {BAR}<p class=\"refusal\" role=\"status\"></p>{open}{fold}</div><p class=\"runs\"><button \
             type=\"button\" class=\"run\" data-stem=\"{stem}\" data-arguments=\"\" data-state>Run the example \
             with these parameters</button></p>"
        )
    }

    /// The bench beside the table of what accuracy costs: any method at any step, where the
    /// table tells of a problem that has been stepped.
    pub fn bench(&self, stem: &str, accuracy: &Table) -> String {
        let stepped = |row: &Vec<String>| row[0].starts_with(STEPPING);
        match self.page(stem).is_some() && accuracy.rows().iter().any(stepped) {
            false => String::new(),
            true => format!(
                "<div class=\"bench\" role=\"group\" aria-label=\"Try a method\" data-stem=\"{stem}\">\
                 <button type=\"button\">Try a method yourself</button></div>"
            ),
        }
    }

    /// The page with a button behind every command that runs an example, but where its output
    /// stands already. Where one is to predict first, the button asks for it.
    pub fn runs(&self, html: &str) -> String {
        const MARKS: [&str; 7] =
            ["<h2", "<h3", "<summary", "</summary", "Predict first", "<pre><code", "<code>"];
        let next = |rest: &str| {
            let found = MARKS.iter().filter_map(|mark| Some((rest.find(mark)?, *mark)));
            found.min_by_key(|(at, mark)| (*at, MARKS.iter().position(|m| m == mark)))
        };
        let mut done = String::with_capacity(html.len());
        let (mut rest, mut predict, mut summary) = (html, false, false);
        while let Some((at, mark)) = next(rest) {
            let after = at + mark.len();
            match mark {
                "<summary" => summary = true,
                "</summary" => summary = false,
                "Predict first" => predict = true,
                "<h2" | "<h3" => predict = false,
                _ => {
                    let close = if mark == "<code>" { "</code>" } else { "</pre>" };
                    let Some(length) = rest[after..].find(close) else {
                        break;
                    };
                    let end = after + length + close.len();
                    done.push_str(&rest[..end]);
                    let code = &rest[after..after + length];
                    let code = code.split_once("</code>").map_or(code, |(code, _)| code);
                    let code = code
                        .split_once('>')
                        .filter(|_| mark != "<code>")
                        .map_or(code, |(_, code)| code);
                    if !summary {
                        let several =
                            code.lines().filter(|line| line.contains(COMMAND)).count() > 1;
                        let buttons =
                            code.lines().filter_map(|line| self.button(line, predict, several));
                        let buttons: String = buttons.collect();
                        done += &match (mark, buttons.is_empty()) {
                            (_, true) | ("<code>", _) => buttons,
                            _ => format!("<div class=\"runs\">{buttons}</div>"),
                        };
                    }
                    rest = &rest[end..];
                    continue;
                }
            }
            done.push_str(&rest[..after]);
            rest = &rest[after..];
        }
        done + rest
    }

    /// The button of a command, if it runs an example that has a module; one of several says what
    /// it runs.
    fn button(&self, command: &str, predict: bool, several: bool) -> Option<String> {
        let command = unescape(command);
        let rest = command.trim().strip_prefix(COMMAND)?;
        let (stem, arguments) = rest.split_once(' ').unwrap_or((rest, ""));
        self.page(stem)?;
        let arguments = arguments.trim_start();
        let arguments = escape(arguments.strip_prefix("--").unwrap_or(arguments).trim());
        let predict = if predict { " data-predict" } else { "" };
        let command = escape(command.trim());
        let (what, label) = match &*arguments {
            _ if !several => (String::new(), "Run here".into()),
            "" => (" as it is".into(), "Run as it is".into()),
            words => (format!(" <code>{words}</code>"), format!("Run {words}")),
        };
        Some(format!(
            "<button type=\"button\" class=\"run\" data-stem=\"{stem}\" data-arguments=\"{arguments}\"{predict} \
             aria-label=\"{label}: {command}\">Run{what}</button>"
        ))
    }

    /// What the scripts need to know of the modules that `html` names, for its head; `None` if
    /// it names none.
    pub fn head(&self, html: &str) -> Option<String> {
        let stems: BTreeSet<&str> = (html.split(" data-stem=\"").skip(1))
            .filter_map(|rest| rest.split('"').next())
            .filter(|stem| self.page(stem).is_some())
            .collect();
        let live = ["player", "run", "bench", "recording"].map(|kind| format!("class=\"{kind}\""));
        if stems.is_empty() || !live.iter().any(|class| html.contains(class.as_str())) {
            return None;
        }
        let pages: Map<String, Value> = stems
            .into_iter()
            .filter_map(|stem| {
                let page = self.page(stem)?;
                let [module, number] = [page.get("module")?, page.get("page")?];
                let size = self.files.get(module.as_str()?)?.len();
                let names = |wanted: fn(&&Value) -> bool| -> Vec<&Value> {
                    let flags = self.flags(stem).iter().filter(wanted);
                    flags.map(|flag| &flag["name"]).collect()
                };
                let effects = names(|flag| flag["kind"] == "effect");
                let page = json!({"module": module, "page": number, "size": size,
                    "flags": names(|_| true), "effects": effects});
                Some((stem.to_owned(), page))
            })
            .collect();
        let palette = self.index["palette"].as_array().into_iter().flatten();
        let inks: Vec<&Value> = palette.map(|colour| &colour["name"]).collect();
        let data = json!({"pages": pages, "inks": inks}).to_string().replace("</", "<\\/");
        Some(format!("{ABLE}<script type=\"application/json\" id=\"live\">{data}</script>"))
    }

    /// The files that the pages load later, with their places in the book: three scripts, and each
    /// module as it is and as a script for pages that are opened as files, where nothing can be fetched.
    ///
    /// # Errors
    /// A script that is not there.
    pub fn files(&self, project: &Project) -> Result<Vec<(String, Vec<u8>)>, String> {
        let source = json!(project.read(SOURCE)?);
        let source = format!("Live.packed(\"module\",{source})\n");
        let mut files = vec![("modules/module.js".to_owned(), source.into_bytes())];
        for name in LATER {
            let script = project.read(&format!("book/theme/{name}.js"))?;
            files.push((format!("modules/{name}.js"), script.into_bytes()));
        }
        for (name, bytes) in &self.files {
            let script = format!("Live.packed(\"{name}\",\"{}\")\n", BASE64_STANDARD.encode(bytes));
            files.push((format!("modules/{name}.js"), script.into_bytes()));
            files.push((format!("modules/{name}"), bytes.clone()));
        }
        Ok(files)
    }
}

/// What every player has: play, steps, time, speed, everything as it was.
const BAR: &str = "<div class=\"bar\">\
    <button type=\"button\" class=\"play\" aria-pressed=\"false\"><svg viewBox=\"0 0 12 12\" aria-hidden=\"true\">\
    <path class=\"go\" d=\"M2 1l9 5-9 5z\"/><path class=\"halt\" d=\"M2 1h3v10H2zM7 1h3v10H7z\"/></svg><span>Play</span></button>\
    <button type=\"button\" class=\"step\" data-by=\"-1\" aria-label=\"A step back\"><svg viewBox=\"0 0 12 12\" aria-hidden=\"true\">\
    <path d=\"M10 1L4 6l6 5zM2 1h1.5v10H2z\"/></svg></button>\
    <button type=\"button\" class=\"step\" data-by=\"1\" aria-label=\"A step on\"><svg viewBox=\"0 0 12 12\" aria-hidden=\"true\">\
    <path d=\"M2 1l6 5-6 5zM8.5 1H10v10H8.5z\"/></svg></button>\
    <input type=\"range\" class=\"time\" min=\"0\" max=\"1000\" value=\"0\" aria-label=\"Time\">\
    <output class=\"now\"></output>\
    <label class=\"speed\">Speed <select><option value=\"0.125\">1/8</option><option value=\"0.25\">1/4</option>\
    <option value=\"0.5\">1/2</option><option value=\"1\" selected>1</option><option value=\"2\">2</option>\
    <option value=\"4\">4</option></select></label>\
    <button type=\"button\" class=\"whole\">Reset</button></div>";

fn text(flag: &Value, key: &str) -> String {
    escape(flag[key].as_str().unwrap_or_default())
}

/// The control of a parameter, from its one declaration.
fn knob(flag: &Value, prefix: &str) -> String {
    let [name, kind] = ["name", "kind"].map(|key| text(flag, key));
    let words = ["title", "meaning"].into_iter().find_map(|key| flag[key].as_str());
    let words = words.unwrap_or_default();
    let unit = flag["unit"].as_str().filter(|unit| *unit != "-").unwrap_or_default();
    let spoken = match unit {
        "" => escape(&notation::symbols(words)),
        unit => format!("{}, in {}", escape(&notation::symbols(words)), escape(unit)),
    };
    let shown = notation::words(words);
    let (id, told) = (format!("{prefix}{name}"), format!("{prefix}{name}-told"));
    let set = flag["shown"].as_str().unwrap_or_default();
    let typed = match (set, flag["usual"].as_str()) {
        ("", Some(usual)) => usual,
        (set, _) => set,
    };
    let typed = escape(typed);
    let label = match &*kind {
        "effect" => {
            let checked = if set.is_empty() { "" } else { " checked" };
            format!("<label><input type=\"checkbox\"{checked}> {shown}</label>")
        }
        _ => format!("<label for=\"{id}\">{shown}</label>"),
    };
    let entry = match flag["words"].as_array().filter(|words| !words.is_empty()) {
        Some(words) => {
            let option = |word: &Value| {
                let word = escape(word.as_str().unwrap_or_default());
                let chosen = if word == typed { " selected" } else { "" };
                format!("<option{chosen}>{word}</option>")
            };
            let options: String = words.iter().map(option).collect();
            format!(
                "<select id=\"{id}\" class=\"value\" aria-describedby=\"{told}\">{options}</select>"
            )
        }
        None => {
            let named = match &*kind {
                "effect" => format!(" aria-label=\"strength: {spoken}\""),
                _ => String::new(),
            };
            format!(
                "<input id=\"{id}\" class=\"value\" inputmode=\"decimal\" value=\"{typed}\"{named} size=\"9\" \
                 autocomplete=\"off\" spellcheck=\"false\" aria-describedby=\"{told}\">"
            )
        }
    };
    let slider = slider(flag, &typed, &spoken);
    let unit = unit_html(unit);
    format!(
        "<div class=\"knob {kind}\" data-name=\"{name}\" data-default=\"{}\">{label}\
         <span class=\"entry\">{entry}<span class=\"unit\">{unit}</span>\
         <button type=\"button\" class=\"back\" disabled aria-label=\"Reset {spoken}\">Reset</button></span>{slider}\
         <span class=\"told\" id=\"{told}\" role=\"status\"></span></div>",
        escape(set),
    )
}

/// The slider over the usual range of a parameter, if it has one: in even steps, or by powers
/// where the range spans more than a factor of 200. Its ends say what happens there, or else how much
/// it is.
fn slider(flag: &Value, typed: &str, spoken: &str) -> String {
    let [Some(from), Some(to)] = ["from", "to"].map(|end| flag[end].as_f64()) else {
        return String::new();
    };
    let named = flag["ends"].as_array().filter(|ends| ends.len() == 2);
    let [low, high] = match named {
        Some(ends) => [0, 1].map(|end| notation::words(ends[end].as_str().unwrap_or_default())),
        None => [from, to].map(short),
    };
    let ends = format!(
        "<span class=\"ends\" aria-hidden=\"true\"><span>{low}</span><span>{high}</span></span>"
    );
    let head = format!("<span class=\"slide\"><input type=\"range\" aria-label=\"{spoken}\"");
    // An effect that is left out stands at the low end.
    let value: f64 = flag["shown"].as_str().and_then(|_| typed.parse().ok()).unwrap_or(from);
    if from > 0.0 && to > 200.0 * from {
        const STEPS: f64 = 300.0;
        let at = STEPS * ((value / from).ln() / (to / from).ln()).clamp(0.0, 1.0);
        return format!(
            "{head} min=\"0\" max=\"{STEPS}\" value=\"{at:.0}\" data-from=\"{from}\" data-to=\"{to}\">{ends}</span>"
        );
    }
    let least = (to - from) / 200.0;
    let even = (least.log10().floor() as i32..)
        .flat_map(|power| [1, 2, 5].map(|digit| (digit, power)))
        .find(|(digit, power)| f64::from(*digit) * 10_f64.powi(*power) >= least);
    // Typed digit by digit, so that 10^-3 is 0.001 and no neighbour of it.
    let step = match even.unwrap_or((1, 0)) {
        (digit, power @ ..=-1) => format!("0.{digit:0>0$}", power.unsigned_abs() as usize),
        (digit, power) => format!("{digit}{}", "0".repeat(power as usize)),
    };
    format!("{head} min=\"{from}\" max=\"{to}\" step=\"{step}\" value=\"{value}\">{ends}</span>")
}

/// A number as the end of a range.
fn short(value: f64) -> String {
    let text = match value.abs() {
        0.0 => "0".into(),
        size if (1e-3..1e5).contains(&size) => format!("{value}"),
        _ => format!("{value:e}"),
    };
    number_html(&text).unwrap_or(text)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn modules() -> Modules {
        let flag = |name: &str, kind: &str, more: Value| {
            let mut flag = json!({"name": name, "unit": "rad/s^2", "meaning": "angle theta", "kind": kind,
                "default": null, "shown": null, "usual": null, "from": null, "to": null, "words": [], "title": null, "ends": []});
            for (key, value) in more.as_object().into_iter().flatten() {
                flag[key] = value.clone();
            }
            flag
        };
        let flags = json!([
            flag(
                "angle",
                "number",
                json!({"default": "0.25", "shown": "0.25", "from": 0.01, "to": 1.5, "title": "tilt theta", "ends": ["upright", "flat"]})
            ),
            flag("mass", "optional", json!({"unit": "-", "shown": "2", "from": 0.1, "to": 100.0})),
            flag(
                "start",
                "choice",
                json!({"default": "rest", "shown": "rest", "words": ["rest", "turning"]})
            ),
            flag("friction", "effect", json!({"usual": "0.02"})),
            // What the picture has no value of, and what it does not show.
            flag("charge", "optional", json!({})),
            flag("tolerance", "number", json!({"default": "1e-9", "shown": "1e-9"})),
        ]);
        let seen = json!(["angle", "mass", "start", "friction", "charge"]);
        let page = |n: u32, moves: bool| {
            json!({"module": "a.gz", "page": n,
            "declared": {"moves": moves, "turns": true, "seen": seen, "flags": flags}})
        };
        let pages = json!({"rod": page(3, true), "table": page(4, false)});
        Modules {
            index: json!({"pages": pages, "palette": [{"name": "fig-ink"}, {"name": "fig-axis"}]}),
            files: [("a.gz".to_owned(), vec![0; 5])].into(),
        }
    }

    #[test]
    fn a_player_has_a_control_for_each_parameter() {
        let html = modules().player("rod", "p1-");
        for part in [
            "<div class=\"player turns\" role=\"group\" aria-label=\"Moving picture\" data-stem=\"rod\">",
            "<p class=\"refusal\" role=\"status\"></p><div class=\"knobs\"><div class=\"knob number\" data-name=\"angle\"",
            "data-name=\"angle\" data-default=\"0.25\"><label for=\"p1-angle\">tilt <math",
            "</div><details class=\"fold\"><summary>More parameters</summary><div class=\"knobs\"><div class=\"knob optional\"",
            "<input id=\"p1-angle\" class=\"value\" inputmode=\"decimal\" value=\"0.25\" size",
            "<span class=\"unit\">rad/s<sup>2</sup></span>",
            "aria-label=\"Reset tilt θ, in rad/s^2\"",
            "min=\"0.01\" max=\"1.5\" step=\"0.01\" value=\"0.25\"",
            "<span>upright</span><span>flat</span>",
            // More than a factor of 200: by powers.
            "min=\"0\" max=\"300\" value=\"130\" data-from=\"0.1\" data-to=\"100\"",
            "<span>0.1</span><span>100</span>",
            "<option selected>rest</option><option>turning</option>",
            "<div class=\"knob effect\" data-name=\"friction\" data-default=\"\"><label><input type=\"checkbox\"> ",
            "value=\"0.02\" aria-label=\"strength: angle θ, in rad/s^2\"",
            "data-stem=\"rod\" data-arguments=\"\" data-state",
        ] {
            assert!(html.contains(part), "{part}\n{html}");
        }
        assert_eq!(html.matches("class=\"knob ").count(), 4);
        assert!(!html.contains("charge") && !html.contains("tolerance"), "{html}");
        // The damaged twins: what does not move has no player, what is unknown nothing.
        assert_eq!(modules().player("table", ""), "");
        assert_eq!(modules().player("other", ""), "");
    }

    #[test]
    fn a_bench_stands_where_a_problem_is_stepped() {
        let table = |method: &str| {
            let mut table = Table::new("accuracy", ["method", "work"]).expect("a table");
            table.push([method, "1 step"]).expect("a row");
            table
        };
        let bench = |stem, method| modules().bench(stem, &table(method));
        assert!(bench("rod", "solve, stepping: DOP853").contains(" data-stem=\"rod\">"));
        // The damaged twins: no module, no problem.
        assert_eq!(bench("other", "solve, stepping: DOP853"), "");
        assert_eq!(bench("rod", "solve: DOP853"), "");
    }

    #[test]
    fn a_recording_has_a_field_with_its_flags() {
        let html = modules().recording("rod", "from angle", "r1-");
        for part in [
            "<div class=\"recording\" role=\"group\" aria-label=\"Your own recording\" data-stem=\"rod\">",
            "<label for=\"r1-file\">A recording from your phone</label><input type=\"file\" id=\"r1-file\"",
            "<label for=\"r1-from\">from</label>",
            "data-flag=\"from\" inputmode=\"decimal\"",
            "<label for=\"r1-angle\">angle <math",
            "<span class=\"unit\">rad/s<sup>2</sup></span>",
            "nothing leaves your device",
        ] {
            assert!(html.contains(part), "{part}\n{html}");
        }
        assert_eq!(html.matches("data-flag").count(), 2);
        // The damaged twin: no module.
        assert_eq!(modules().recording("other", "from", ""), "");
    }

    #[test]
    fn commands_get_buttons_where_they_can_run() {
        let button = |stem: &str, arguments: &str, predict: &str, label: &str| {
            format!(
                "<button type=\"button\" class=\"run\" data-stem=\"{stem}\" data-arguments=\"{arguments}\"{predict} \
                 aria-label=\"Run here: {label}\">Run</button>"
            )
        };
        let rod = "cargo run --example rod";
        let cases = [
            (
                format!("<p><code>{rod}</code> x"),
                format!("<p><code>{rod}</code>{} x", button("rod", "", "", rod)),
            ),
            (
                format!(
                    "<h2>Try</h2><p>Predict first.</p><code>{rod} -- --angle &quot;1&quot;</code><h2>Y</h2><code>{rod}</code>"
                ),
                format!(
                    "<h2>Try</h2><p>Predict first.</p><code>{rod} -- --angle &quot;1&quot;</code>{}<h2>Y</h2><code>{rod}</code>{}",
                    button(
                        "rod",
                        "--angle &quot;1&quot;",
                        " data-predict",
                        &format!("{rod} -- --angle &quot;1&quot;")
                    ),
                    button("rod", "", "", rod)
                ),
            ),
            (
                format!(
                    "<pre><code class=\"language-console\">{rod} -- --b 2\n{rod}\n</code></pre>x"
                ),
                format!(
                    "<pre><code class=\"language-console\">{rod} -- --b 2\n{rod}\n</code></pre><div class=\"runs\">{}{}</div>x",
                    button("rod", "--b 2", "", &format!("{rod} -- --b 2"))
                        .replace("Run<", "Run <code>--b 2</code><")
                        .replace("Run here", "Run --b 2"),
                    button("rod", "", "", rod)
                        .replace("Run<", "Run as it is<")
                        .replace("Run here", "Run as it is")
                ),
            ),
        ];
        for (html, want) in cases {
            assert_eq!(modules().runs(&html), want);
        }
        // The damaged twins: nothing to run.
        for html in [
            format!(
                "<summary>What <code>{rod}</code> prints</summary><pre><code class=\"x\">$ {rod}\n</code></pre>"
            ),
            "<code>cargo run --example other</code>".into(),
            "<code>cargo test</code><code>".into(),
        ] {
            assert_eq!(modules().runs(&html), html);
        }
    }

    #[test]
    fn the_head_names_what_the_page_uses() {
        let head =
            modules().head("<div class=\"player\" data-stem=\"rod\"><p data-stem=\"other\">");
        let head = head.expect("a player");
        let data =
            head.split("id=\"live\">").nth(1).and_then(|rest| rest.strip_suffix("</script>"));
        let data: Value = serde_json::from_str(data.expect("data")).expect("JSON");
        let page = json!({"module": "a.gz", "page": 3, "size": 5,
            "flags": ["angle", "mass", "start", "friction", "charge", "tolerance"], "effects": ["friction"]});
        assert_eq!(data, json!({"pages": {"rod": page}, "inks": ["fig-ink", "fig-axis"]}));
        // The damaged twins: no module, or nothing that uses it.
        assert_eq!(modules().head("<div class=\"player\" data-stem=\"other\">"), None);
        assert_eq!(modules().head("<form data-stem=\"rod\">"), None);
    }
}
