//! What the module tells, as JSON.

use kit::cli::{Leaf, Outcome};
use kit::draw::{PALETTE, Turn};
use kit::{Answer, Error, Figure, Lab, MovingPicture, Recorded, Result, Verdict, claim, quoted};
use rotation_dynamics::integrators::Method;

/// `{"error": …}`.
pub fn error(error: &dyn core::fmt::Display) -> String {
    format!("{{\"error\": {}}}", quoted(&error.to_string()))
}

fn list(items: impl IntoIterator<Item = String>) -> String {
    let items: Vec<String> = items.into_iter().collect();
    format!("[{}]", items.join(", "))
}

/// What there is to know of a picture before it moves.
pub fn opened(picture: &MovingPicture) -> Result<String> {
    let span = picture.span();
    // A picture that cannot be drawn is refused before it begins.
    picture.frame(*span.start())?;
    let stills = list(picture.still_times().iter().map(|t| format!("{t:?}")));
    Ok(format!(
        "{{\"span\": [{:?}, {:?}], \"time\": {}, \"stills\": {stills}}}",
        span.start(),
        span.end(),
        quoted(&picture.time()),
    ))
}

/// Every ink: its CSS variable, and the light theme's colours.
pub fn palette() -> String {
    list(PALETTE.iter().map(|colour| {
        format!(
            "{{\"name\": \"{}\", \"line\": \"#{:06X}\", \"text\": \"#{:06X}\"}}",
            colour.name, colour.line, colour.text
        )
    }))
}

/// What a terminal would show, and the files.
pub fn outcome(outcome: &Outcome, files: &[Leaf]) -> String {
    let files = files.iter().map(|(path, text)| {
        let name = quoted(&path.display().to_string());
        format!("{{\"name\": {name}, \"text\": {}}}", quoted(text))
    });
    format!(
        "{{\"stdout\": {}, \"stderr\": {}, \"code\": {}, \"files\": {}}}",
        quoted(&outcome.stdout),
        quoted(&outcome.stderr),
        outcome.code,
        list(files)
    )
}

/// The drawings, or what is said instead.
pub fn figures(drawn: core::result::Result<Vec<Figure>, Outcome>) -> String {
    match drawn {
        Err(told) => error(&format!("{}{}", told.stdout, told.stderr)),
        Ok(figures) => format!(
            "{{\"figures\": {}}}",
            list(figures.iter().map(|one| format!("{{{}}}", drawing(one))))
        ),
    }
}

/// The entries of a figure.
fn drawing(figure: &Figure) -> String {
    let svg = figure.svg();
    let [name, alt, svg] = [&figure.name, &figure.alt, &svg].map(|s| quoted(s));
    format!("\"name\": {name}, \"alt\": {alt}, \"svg\": {svg}")
}

/// What a recording says.
pub fn recorded(stem: &str, told: &Recorded) -> Result<String> {
    let pictures = told.pictures.iter().map(|(name, picture)| {
        let (opened, caption) = (opened(picture)?, quoted(told.caption(name)));
        let (_, turns) = picture.seen(*picture.span().start(), Turn::default())?;
        Ok(format!("{{\"caption\": {caption}, \"turns\": {turns}, {}", &opened[1..]))
    });
    let pictures: Vec<String> = pictures.collect::<Result<_>>()?;
    let figures = told.figures.iter().map(|figure| {
        format!("{{\"caption\": {}, {}}}", quoted(told.caption(&figure.name)), drawing(figure))
    });
    Ok(format!(
        "{{\"told\": {}, \"text\": {}, \"figures\": {}, \"pictures\": {}}}",
        told.json(stem)?,
        quoted(&told.report.output()?),
        list(figures),
        list(pictures)
    ))
}

/// What a reader asks of a page's methods.
pub struct Asked {
    /// The lines that set the page's parameters.
    pub settings: String,
    method: Option<String>,
    setting: Option<f64>,
    solve: Option<f64>,
}

impl Asked {
    /// Reads the lines; what is no number stands for none.
    pub fn read(text: &str) -> Self {
        let mut asked = Self { settings: String::new(), method: None, setting: None, solve: None };
        for line in text.lines() {
            match line.split_once('=') {
                Some(("method", name)) => asked.method = Some(name.into()),
                Some(("setting", value)) => asked.setting = value.parse().ok(),
                Some(("solve", value)) => asked.solve = value.parse().ok(),
                _ => asked.settings += &format!("{line}\n"),
            }
        }
        asked
    }

    /// What the run delivered, what there is to choose from, or what is wrong.
    pub fn answer(&self, lab: Option<&Lab>) -> String {
        let Some(lab) = lab else {
            return "{\"methods\": []}".into();
        };
        let tried = match (&self.method, self.setting, self.solve) {
            (None, _, Some(tolerance)) => lab.solve(tolerance),
            (Some(name), Some(setting), _) => {
                let known = lab.methods().iter().find(|method| method.name() == name);
                match known {
                    Some(method) => lab.run(*method, setting),
                    None => Err(Error::UnknownKey {
                        key: name.clone(),
                        known: lab
                            .methods()
                            .iter()
                            .map(|m| m.name())
                            .collect::<Vec<_>>()
                            .join(", "),
                    }),
                }
            }
            _ => return choices(lab),
        };
        tried.map_or_else(|refusal| error(&refusal), |tried| tried.json())
    }
}

fn choices(lab: &Lab) -> String {
    let methods = lab.methods().iter().map(|method| {
        let setting = match method {
            Method::Dop853 => "tolerance",
            _ => "steps",
        };
        format!(
            "{{\"name\": {}, \"order\": {}, \"setting\": \"{setting}\"}}",
            quoted(method.name()),
            method.order()
        )
    });
    format!("{{\"methods\": {}, \"span\": {:?}}}", list(methods), lab.span())
}

/// What became of a reader's answer: its kind, and what to say. The lines are the answer, then of
/// the claim its value, its unit, its bound and the relative error within which it is judged, then
/// a value and a hint for each slip.
pub fn judged(lines: &str) -> String {
    let mut lines = lines.lines();
    let mut line = || lines.next().unwrap_or_default();
    let (text, value, unit, bound, within) = (line(), line(), line(), line(), line());
    let number = |text: &str| text.parse().unwrap_or(f64::NAN);
    let mut claim =
        claim("", "", number(value), unit).within(number(bound)).judged_within(number(within));
    while let (Some(value), Some(hint)) = (lines.next(), lines.next()) {
        claim = claim.slip(number(value), hint);
    }
    let (kind, words) = match Answer::read(text) {
        Err(words) => ("refused", words.to_owned()),
        Ok(answer) => {
            let verdict = claim.verdict(answer);
            let kind = match verdict {
                Verdict::Right => "right",
                Verdict::AsFarAsItGoes(..) | Verdict::RightTo(..) => "nearly",
                Verdict::Slip(_) => "slip",
                Verdict::Unit(..) => "unit",
                Verdict::Wrong => "wrong",
            };
            (kind, verdict.words())
        }
    };
    format!("{{\"kind\": \"{kind}\", \"words\": {}}}", quoted(&words))
}
