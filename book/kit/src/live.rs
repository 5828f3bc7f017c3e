//! What a page asks that moves by itself: its parameters' one declaration, a moving picture
//! for those that the reader chose, the methods at the reader's own choice.

use super::answer::Answer;
use super::example::Run;
use super::json::quoted;
use super::parameters::{Settings, check};
use super::{Example, Flag, MovingPicture, ParameterSet};
use crate::error::{Error, Result};
use core::fmt::Write;

/// The part of an example that moves; apart from [`Page`](super::Page), so that a module of
/// pictures alone is small.
///
/// ```
/// use kit::draw::{Ink, Side, Sketch};
/// use kit::{Example, Moves, MovingPicture, Report, Trajectory};
/// kit::parameters! {
///     /// A clock.
///     pub struct Parameters {
///         /// length of the hand
///         length: number(1.0, "m", above(0.0).usually(0.5, 1.0));
///     }
/// }
/// const EXAMPLE: Example<Parameters> = Example {
///     stem: "clock",
///     about: "A clock",
///     report: |_| Report::new("A clock", "a hand that turns"),
///     figures: |_| Ok(Vec::new()),
///     trajectory: |_| Trajectory::new(["t [s]"]),
///     moving_picture: Some(|p: &Parameters| {
///         let l = p.length;
///         MovingPicture::new(0.0..=6.0, [0.0], move |t| {
///             Sketch::new("clock", "the hand of a clock turns").window((-1.0, 1.0), (-1.0, 1.0))
///                 .arrow((0.0, 0.0), (l * t.sin(), l * t.cos()), Ink::Body, "", Side::Right)
///                 .figure()
///         })
///     }),
///     recordings: None,
/// };
/// let picture = EXAMPLE.opened("length=0.5\n")?.expect("it moves");
/// assert_ne!(picture.frame(0.0)?, EXAMPLE.opened("")?.expect("it moves").frame(0.0)?);
/// let refused = EXAMPLE.opened("length=-1").map(|_| ()).unwrap_err();
/// assert_eq!(refused.to_string(), "length = -1 is not allowed: it must be greater than 0");
/// # Ok::<(), kit::Error>(())
/// ```
pub trait Moves: Sync {
    /// The moving picture with what these lines set, `NAME=VALUE` each; an effect without a
    /// value is left out. `None` if nothing moves.
    ///
    /// # Errors
    /// [`Error::UnknownKey`] for a name that is none, [`Error::Text`] for a value that is no
    /// number or none of the words, [`Error::Parameter`] for one that is not allowed; those of the example.
    fn opened(&self, settings: &str) -> Result<Option<MovingPicture>>;
}

impl<P: ParameterSet> Moves for Example<P> {
    fn opened(&self, settings: &str) -> Result<Option<MovingPicture>> {
        let Some(picture) = self.moving_picture else {
            return Ok(None);
        };
        picture(&read(settings)?).map(Some)
    }
}

/// The parameters with what these lines set, checked.
pub(super) fn read<P: ParameterSet>(settings: &str) -> Result<P> {
    let mut parameters = P::default();
    set_lines(&mut parameters, settings)?;
    Ok(parameters)
}

/// Sets what these lines say, and checks all.
pub(super) fn set_lines(parameters: &mut dyn Settings, settings: &str) -> Result<()> {
    for line in settings.lines().filter(|line| !line.trim().is_empty()) {
        let (name, value) = line.split_once('=').unwrap_or((line, ""));
        set(parameters, name.trim(), value.trim())?;
    }
    check(parameters)
}

fn set(parameters: &mut dyn Settings, name: &str, value: &str) -> Result<()> {
    let refused = |allowed| Error::Text { text: format!("{name}={value}"), allowed };
    let flags = parameters.flags();
    let flag = flags.iter().find(|flag| flag.name() == name);
    let flag = flag.ok_or_else(|| Error::UnknownKey {
        key: name.to_owned(),
        known: flags.iter().map(Flag::name).collect::<Vec<_>>().join(", "),
    })?;
    if value.is_empty() && flag.usual().is_some() {
        flag.leave_out(parameters);
    } else if flag.words().is_empty() {
        // As it is typed after a flag: 0.3, 3/4, pi/6, 30 deg.
        let number = Answer::read(value).map_err(refused)?.in_unit(flag.unit());
        flag.set_number(parameters, number.map_err(|_| refused("that is in another unit"))?);
    } else if flag.words().contains(&value) {
        flag.set_word(parameters, value);
    } else {
        return Err(refused("one of the words that --help lists"));
    }
    Ok(())
}

/// What an example and its parameters are, for the controls of its page, as JSON:
/// `{"stem", "about", "moves", "flags": [{"name", "unit", "meaning", "kind", "default", "shown",
/// "usual", "allowed", "from", "to", "words", "title", "ends"}]}`. `kind` is `number`, `optional`,
/// `choice` or `effect`; `default` is as it is typed, `null` for what is not set; `shown` is what the
/// moving picture has then; `usual` is the strength of an effect, `from` and `to` are the part in which
/// a reader will want to move; `title` and `ends` are those of an open control.
pub(super) fn declared(run: &dyn Run) -> String {
    let or_null = |text: Option<String>| text.map_or("null".into(), |text| quoted(&text));
    let defaults = run.parameters();
    let mut flags = String::new();
    for flag in defaults.flags() {
        let default = flag.printed(defaults);
        let kind = match (flag.usual(), flag.words(), &default) {
            (Some(_), ..) => "effect",
            (None, [_, ..], _) => "choice",
            (None, [], None) => "optional",
            (None, [], Some(_)) => "number",
        };
        let range = flag.allowed().and_then(|allowed| allowed.usual());
        let [from, to] =
            range.map_or(["null".into(), "null".into()], |r| r.map(|x| format!("{x:?}")));
        let list = |words: &[&str]| {
            let words: Vec<String> = words.iter().map(|word| quoted(word)).collect();
            words.join(", ")
        };
        let open = flag.opened();
        let comma = if flags.is_empty() { "" } else { ", " };
        // Writing to a string cannot fail.
        let _ = write!(
            flags,
            "{comma}{{\"name\": {}, \"unit\": {}, \"meaning\": {}, \"kind\": \"{kind}\", \"default\": {}, \
             \"shown\": {}, \"usual\": {}, \"allowed\": {}, \"from\": {from}, \"to\": {to}, \"words\": [{}], \
             \"title\": {}, \"ends\": [{}]}}",
            quoted(&flag.name()),
            quoted(flag.unit()),
            quoted(flag.meaning()),
            or_null(default),
            or_null(flag.on_show(defaults)),
            or_null(flag.usual().map(super::number::exactly)),
            or_null(flag.allowed_words()),
            list(flag.words()),
            or_null(open.map(|open| open.title.to_owned())),
            list(open.map_or(&[], |open| open.ends)),
        );
    }
    format!(
        "{{\"stem\": {}, \"about\": {}, \"moves\": {}, \"flags\": [{flags}]}}",
        quoted(run.stem()),
        quoted(run.about()),
        run.moves(),
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Report, Trajectory};

    crate::parameters! {
        /// A rod.
        pub struct Parameters {
            /// length of the rod
            length: number(3.0, "m", above(0.0).usually(0.5, 5.0)).open("length", "quick", "slow");
            /// mass, if it matters
            mass: optional("kg", above(0.0)).shown(2.0);
            /// how it starts
            start: choice("rest", "turning");
            /// friction of the hinge
            friction: effect(0.02, "N m s", above(0.0));
        }
    }

    #[test]
    fn lines_set_parameters_and_are_refused_by_name() {
        let p: Parameters =
            read("length=4/2\n\nmass=4\nstart=turning\nfriction=0.5").expect("they are allowed");
        let expected =
            Parameters { length: 2.0, mass: Some(4.0), start: "turning", friction: Some(0.5) };
        assert_eq!(p, expected);
        let out: Parameters = read("friction=0.5\nfriction=").expect("it is left out again");
        assert_eq!(out, Parameters::default());
        let refused = |lines| read::<Parameters>(lines).unwrap_err().to_string();
        let cases = [
            ("width=2", "there is no"),
            ("length=", "not a number"),
            ("length=inf", "not a number"),
            ("length=1/0", "not a finite number"),
            ("length=1,000,2", "decimals come after a point"),
            ("length=3 kg", "in another unit"),
            ("start=flying", "one of the words"),
            ("length=-1", "greater than 0"),
        ];
        for (lines, said) in cases {
            let told = refused(lines);
            assert!(told.contains(said) || told.contains("known"), "{lines}: {told}");
        }
    }

    #[test]
    fn the_declaration_is_told_once() {
        let example: Example<Parameters> = Example {
            stem: "rod",
            about: "A \"rod\"",
            report: |_| Report::new("A rod", "a thin rod"),
            figures: |_| Ok(Vec::new()),
            trajectory: |_| Trajectory::new(["t [s]"]),
            moving_picture: None,
            recordings: None,
        };
        let told = declared(&example.run());
        assert!(told.starts_with(r#"{"stem": "rod", "about": "A \"rod\"", "moves": false, "flags": [{"name": "length", "#), "{told}");
        assert!(told.contains(r#""from": 0.5, "to": 5.0"#), "{told}");
        assert!(told.contains(r#""title": "length", "ends": ["quick", "slow"]"#), "{told}");
        assert!(
            told.contains(r#""kind": "choice", "default": "rest", "shown": "rest", "usual": null, "allowed": null, "from": null, "to": null, "words": ["rest", "turning"], "title": null, "ends": []"#),
            "{told}"
        );
        assert!(
            told.contains(r#""kind": "effect", "default": null, "shown": null, "usual": "0.02""#),
            "{told}"
        );
        assert!(told.contains(r#""kind": "optional", "default": null, "shown": "2""#), "{told}");
    }
}
