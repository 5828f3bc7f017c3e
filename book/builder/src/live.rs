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
use std::fmt;

/// What compiles modules and calls them, in a worker. A page that is opened as a file may start no
/// worker from one: the source comes as a text.
const SOURCE: &str = "book/theme/module.js";

/// What runs commands, loaded when the first is run.
const RUNS: &str = "book/theme/run.js";

/// Shows the controls where they can work, before anything is laid out.
const ABLE: &str = "<script>if(window.WebAssembly&&window.DecompressionStream&&window.Worker)\
    document.documentElement.classList.add('live')</script>";

/// What a moving figure is told: a parameter, its value, and the range of a slider if the reader
/// may change it. Written `NAME=VALUE` or `NAME=VALUE:FROM..TO`.
#[derive(Debug, Clone, PartialEq)]
pub struct Setting {
    /// Its name.
    pub name: String,
    /// Its value at first, as it is typed.
    pub value: String,
    /// From where to where the slider goes.
    pub range: Option<[f64; 2]>,
}

impl Setting {
    /// Reads a setting; `None` if it is not written so.
    pub fn read(word: &str) -> Option<Self> {
        let (name, rest) = word.split_once('=')?;
        let (value, range) = match rest.split_once(':') {
            None => (rest, None),
            Some((value, range)) => {
                let (from, to) = range.split_once("..")?;
                let ends: [f64; 2] = [from.parse().ok()?, to.parse().ok()?];
                (value, Some(ends).filter(|[from, to]| from < to).map(Some)?)
            }
        };
        let named = |text: &str| !text.is_empty() && !text.contains(['"', '<', '&', ' ']);
        (named(name) && named(value)).then(|| Self {
            name: name.into(),
            value: value.into(),
            range,
        })
    }
}

impl fmt::Display for Setting {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { name, value, range } = self;
        match range {
            None => write!(f, "{name}={value}"),
            Some([from, to]) => write!(f, "{name}={value}:{from}..{to}"),
        }
    }
}

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

    fn page(&self, stem: &str) -> Option<&Map<String, Value>> {
        self.index["pages"].get(stem)?.as_object()
    }

    fn flags(&self, stem: &str) -> &[Value] {
        let declared = self.page(stem).and_then(|page| page.get("declared"));
        let flags = declared.and_then(|declared| declared["flags"].as_array());
        flags.map_or(&[], Vec::as_slice)
    }

    /// What plays the moving picture of `stem`: its bar, and the controls of its parameters. With
    /// `settings` it plays by itself, with these values and controls only for those with a range.
    /// Nothing if it does not move.
    pub fn player(&self, stem: &str, settings: &[Setting], prefix: &str) -> String {
        let page = self.page(stem);
        let moves = page.is_some_and(|page| page["declared"]["moves"] == true);
        if !moves {
            return String::new();
        }
        let shown = |flag: &Value| {
            let setting = settings.iter().find(|setting| flag["name"] == *setting.name);
            match setting {
                None => settings.is_empty().then(|| flag.clone()),
                Some(Setting { value, range, .. }) => range.map(|[from, to]| {
                    let mut flag = flag.clone();
                    flag["default"] = json!(value);
                    [flag["from"], flag["to"]] = [json!(from), json!(to)];
                    flag
                }),
            }
        };
        let flags: Vec<Value> = self.flags(stem).iter().filter_map(shown).collect();
        let knobs: String = flags.iter().map(|flag| knob(flag, prefix)).collect();
        let names = flags.iter().map(|flag| format!("<span>{}</span>", text(flag, "name")));
        let names: Vec<String> = names.collect();
        let knobs = match (knobs.is_empty(), settings.is_empty()) {
            (true, _) => String::new(),
            (_, false) => format!("<div class=\"knobs\">{knobs}</div>"),
            (_, true) => format!(
                "<details class=\"fold\"><summary>Change it <span class=\"names\">{}</span></summary>\
                 <div class=\"knobs\">{knobs}</div><p class=\"runs\"><button type=\"button\" class=\"run\" \
                 data-stem=\"{stem}\" data-arguments=\"\" data-state aria-label=\"Run the example with these parameters\">\
                 Run the example with these</button></p></details>",
                names.join(" ")
            ),
        };
        let fixed: Vec<String> =
            settings.iter().map(|Setting { name, value, .. }| format!("{name}={value}")).collect();
        let plays = match fixed.is_empty() {
            true => String::new(),
            false => format!(" data-plays=\"{}\"", fixed.join(" ")),
        };
        format!(
            "<div class=\"player\" role=\"group\" aria-label=\"Moving picture\" data-stem=\"{stem}\"{plays}>\
             {BAR}<p class=\"refusal\" role=\"status\"></p>{knobs}</div>"
        )
    }

    /// What the answer box of `stem` must know of its parameters, as attributes.
    pub fn answered(&self, stem: &str) -> String {
        let names = |wanted: fn(&Value) -> bool| {
            let flags = self.flags(stem).iter().filter(|flag| wanted(flag));
            let names: Vec<String> = flags.map(|flag| text(flag, "name")).collect();
            names.join(" ")
        };
        let unset = names(|flag| flag["default"].is_null());
        let effects = names(|flag| flag["kind"] == "effect");
        format!(" data-unset=\"{unset}\" data-effects=\"{effects}\"")
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
                        let buttons: String =
                            code.lines().filter_map(|line| self.button(line, predict)).collect();
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

    /// The button of a command, if it runs an example that has a module.
    fn button(&self, command: &str, predict: bool) -> Option<String> {
        let command = unescape(command);
        let rest = command.trim().strip_prefix("cargo run --example ")?;
        let (stem, arguments) = rest.split_once(' ').unwrap_or((rest, ""));
        self.page(stem)?;
        let arguments = arguments.trim_start();
        let arguments = escape(arguments.strip_prefix("--").unwrap_or(arguments).trim());
        let predict = if predict { " data-predict" } else { "" };
        let label = escape(command.trim());
        Some(format!(
            "<button type=\"button\" class=\"run\" data-stem=\"{stem}\" data-arguments=\"{arguments}\"{predict} \
             aria-label=\"Run here: {label}\">Run</button>"
        ))
    }

    /// What the scripts need to know of the modules that `html` names, for its head; `None` if
    /// it names none.
    pub fn head(&self, html: &str) -> Option<String> {
        let stems: BTreeSet<&str> = (html.split(" data-stem=\"").skip(1))
            .filter_map(|rest| rest.split('"').next())
            .filter(|stem| self.page(stem).is_some())
            .collect();
        let live = ["class=\"player\"", "class=\"run\"", "class=\"bench\""];
        if stems.is_empty() || !live.iter().any(|class| html.contains(class)) {
            return None;
        }
        let pages: Map<String, Value> = stems
            .into_iter()
            .filter_map(|stem| {
                let page = self.page(stem)?;
                let [module, number] = [page.get("module")?, page.get("page")?];
                let size = self.files.get(module.as_str()?)?.len();
                Some((stem.to_owned(), json!({"module": module, "page": number, "size": size})))
            })
            .collect();
        let palette = self.index["palette"].as_array().into_iter().flatten();
        let inks: Vec<&Value> = palette.map(|colour| &colour["name"]).collect();
        let data = json!({"pages": pages, "inks": inks}).to_string().replace("</", "<\\/");
        Some(format!("{ABLE}<script type=\"application/json\" id=\"live\">{data}</script>"))
    }

    /// The files that the pages load later, with their places in the book: two scripts, and each
    /// module as it is and as a script for pages that are opened as files, where nothing can be fetched.
    ///
    /// # Errors
    /// A script that is not there.
    pub fn files(&self, project: &Project) -> Result<Vec<(String, Vec<u8>)>, String> {
        let source = json!(project.read(SOURCE)?);
        let source = format!("Live.packed(\"module\",{source})\n");
        let mut files = vec![
            ("modules/module.js".to_owned(), source.into_bytes()),
            ("modules/run.js".to_owned(), project.read(RUNS)?.into_bytes()),
        ];
        for (name, bytes) in &self.files {
            let script = format!("Live.packed(\"{name}\",\"{}\")\n", BASE64_STANDARD.encode(bytes));
            files.push((format!("modules/{name}.js"), script.into_bytes()));
            files.push((format!("modules/{name}"), bytes.clone()));
        }
        Ok(files)
    }
}

/// Confirms that these are parameters of an example, if it has a module.
///
/// # Errors
/// One that is not.
pub fn known(project: &Project, stem: &str, settings: &[Setting]) -> Result<(), String> {
    let Some(modules) = Modules::of(project)? else {
        return Ok(());
    };
    let flags = modules.flags(stem);
    for Setting { name, .. } in settings {
        if !flags.iter().any(|flag| flag["name"] == **name) {
            let known: Vec<String> = flags.iter().map(|flag| text(flag, "name")).collect();
            let known = known.join(", ");
            return Err(format!("{stem} has no parameter '{name}'; it has: {known}"));
        }
    }
    Ok(())
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
    let [name, kind, allowed] = ["name", "kind", "allowed"].map(|key| text(flag, key));
    let meaning = flag["meaning"].as_str().unwrap_or_default();
    let unit = flag["unit"].as_str().filter(|unit| *unit != "-").unwrap_or_default();
    let spoken = match unit {
        "" => escape(&notation::symbols(meaning)),
        unit => format!("{}, in {}", escape(&notation::symbols(meaning)), escape(unit)),
    };
    let shown = notation::words(meaning);
    let (id, told) = (format!("{prefix}{name}"), format!("{prefix}{name}-told"));
    let set = flag["default"].as_str().unwrap_or_default();
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
            let open = if kind == "optional" { " placeholder=\"not set\"" } else { "" };
            format!(
                "<input id=\"{id}\" class=\"value\" inputmode=\"decimal\" value=\"{typed}\"{open}{named} size=\"9\" \
                 autocomplete=\"off\" spellcheck=\"false\" aria-describedby=\"{told}\">"
            )
        }
    };
    let slider = slider(flag, &typed, &spoken);
    let unit = unit_html(unit);
    let name_of_flag = match &*kind {
        "effect" => format!("--with {name}"),
        _ => format!("--{name}"),
    };
    format!(
        "<div class=\"knob {kind}\" data-name=\"{name}\" data-default=\"{}\">{label}\
         <span class=\"entry\">{entry}<span class=\"unit\">{unit}</span>\
         <button type=\"button\" class=\"back\" disabled aria-label=\"Reset {spoken}\">Reset</button></span>{slider}\
         <span class=\"told\" id=\"{told}\"><code>{name_of_flag}</code> {allowed}</span></div>",
        escape(set),
    )
}

/// The slider over the usual range of a parameter, if it has one: in even steps, or by powers
/// where the range spans more than a factor of 200.
fn slider(flag: &Value, typed: &str, spoken: &str) -> String {
    let [Some(from), Some(to)] = ["from", "to"].map(|end| flag[end].as_f64()) else {
        return String::new();
    };
    let ends = format!(
        "<span class=\"ends\" aria-hidden=\"true\">{} to {}</span>",
        short(from),
        short(to)
    );
    let head = format!("<span class=\"slide\"><input type=\"range\" aria-label=\"{spoken}\"");
    if from > 0.0 && to > 200.0 * from {
        const STEPS: f64 = 300.0;
        let value: f64 = typed.parse().unwrap_or((from * to).sqrt());
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
    let value = if typed.is_empty() { format!("{}", 0.5 * (from + to)) } else { typed.to_owned() };
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
                "default": null, "usual": null, "allowed": "it must be > 0", "from": null, "to": null, "words": []});
            for (key, value) in more.as_object().into_iter().flatten() {
                flag[key] = value.clone();
            }
            flag
        };
        let flags = json!([
            flag("angle", "number", json!({"default": "0.25", "from": 0.01, "to": 1.5})),
            flag("mass", "optional", json!({"unit": "-", "from": 0.1, "to": 100.0})),
            flag(
                "start",
                "choice",
                json!({"default": "rest", "allowed": null, "words": ["rest", "turning"]})
            ),
            flag("friction", "effect", json!({"usual": "0.02"})),
        ]);
        let page = |n: u32, moves: bool| json!({"module": "a.gz", "page": n, "declared": {"moves": moves, "flags": flags}});
        let pages = json!({"rod": page(3, true), "table": page(4, false)});
        Modules {
            index: json!({"pages": pages, "palette": [{"name": "fig-ink"}, {"name": "fig-axis"}]}),
            files: [("a.gz".to_owned(), vec![0; 5])].into(),
        }
    }

    #[test]
    fn a_player_has_a_control_for_each_parameter() {
        let html = modules().player("rod", &[], "p1-");
        for part in [
            "data-stem=\"rod\">",
            "<details class=\"fold\">",
            "<div class=\"knob number\" data-name=\"angle\" data-default=\"0.25\"><label for=\"p1-angle\">angle <math",
            "<input id=\"p1-angle\" class=\"value\" inputmode=\"decimal\" value=\"0.25\" size",
            "<span class=\"unit\">rad/s<sup>2</sup></span>",
            "aria-label=\"Reset angle θ, in rad/s^2\"",
            "min=\"0.01\" max=\"1.5\" step=\"0.01\" value=\"0.25\"",
            "<code>--angle</code> it must be &gt; 0",
            // More than a factor of 200: by powers, from the middle.
            "min=\"0\" max=\"300\" value=\"150\" data-from=\"0.1\" data-to=\"100\"",
            "placeholder=\"not set\"",
            "<option selected>rest</option><option>turning</option>",
            "<div class=\"knob effect\" data-name=\"friction\" data-default=\"\"><label><input type=\"checkbox\"> ",
            "value=\"0.02\" aria-label=\"strength: angle θ, in rad/s^2\"",
            "<code>--with friction</code>",
            "data-stem=\"rod\" data-arguments=\"\" data-state",
        ] {
            assert!(html.contains(part), "{part}\n{html}");
        }
        assert_eq!(html.matches("class=\"knob ").count(), 4);
        let opening = modules().player(
            "rod",
            &["angle=0.5", "mass=2:1..3"].map(|word| Setting::read(word).expect(word)),
            "p1-",
        );
        assert_eq!(opening.matches("class=\"knob ").count(), 1);
        for part in
            [" data-plays=\"angle=0.5 mass=2\">", "min=\"1\" max=\"3\" step=\"0.01\" value=\"2\""]
        {
            assert!(opening.contains(part), "{part}\n{opening}");
        }
        assert!(!opening.contains("<details"));
        // The damaged twins: what does not move has no player, what is unknown nothing.
        assert_eq!(modules().player("table", &[], ""), "");
        assert_eq!(modules().player("other", &[], ""), "");
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
                    button("rod", "--b 2", "", &format!("{rod} -- --b 2")),
                    button("rod", "", "", rod)
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
        let page = json!({"module": "a.gz", "page": 3, "size": 5});
        assert_eq!(data, json!({"pages": {"rod": page}, "inks": ["fig-ink", "fig-axis"]}));
        // The damaged twins: no module, or nothing that uses it.
        assert_eq!(modules().head("<div class=\"player\" data-stem=\"other\">"), None);
        assert_eq!(modules().head("<form data-stem=\"rod\">"), None);
    }
}
