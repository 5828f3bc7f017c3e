//! Every example in a module that has no platform around it: what a page calls when it moves.
//!
//! Plain exports, no binding generator. A text or a list of bytes is left in memory, its
//! length is returned, [`output`] says where it lies; a text for a call is written to where
//! [`input`] says. A page is a number, its place among the stems in their order. `open` and
//! `frame` need none of the rest: a module of moving pictures alone is small.

mod answers;

use every_example::{ALL, MOVING};
use kit::draw::Turn;
use kit::{Lab, MovingPicture, Page};
use std::sync::{Mutex, MutexGuard, PoisonError};

/// What is kept from one call to the next.
struct Kept {
    input: Vec<u8>,
    output: Vec<u8>,
    failure: String,
    alt: String,
    picture: Option<MovingPicture>,
    /// What moves of the last recording.
    recorded: Vec<MovingPicture>,
    /// Of which page, for which settings.
    lab: Option<(usize, String, Option<Lab>)>,
}

static KEPT: Mutex<Kept> = Mutex::new(Kept {
    input: Vec::new(),
    output: Vec::new(),
    failure: String::new(),
    alt: String::new(),
    picture: None,
    recorded: Vec::new(),
    lab: None,
});

fn kept() -> MutexGuard<'static, Kept> {
    KEPT.lock().unwrap_or_else(PoisonError::into_inner)
}

fn leave(bytes: impl Into<Vec<u8>>) -> usize {
    let mut kept = kept();
    kept.output = bytes.into();
    kept.output.len()
}

/// What the caller wrote; once.
fn written() -> Vec<u8> {
    core::mem::take(&mut kept().input)
}

/// The text that the caller wrote; once.
fn taken() -> String {
    String::from_utf8_lossy(&written()).into_owned()
}

/// Arguments that are parted by NUL.
fn parted(text: &str) -> Vec<String> {
    if text.is_empty() {
        return Vec::new();
    }
    text.split('\0').map(str::to_owned).collect()
}

fn page(n: usize) -> &'static dyn Page {
    ALL[n]
}

/// Room for a text of this length, which the next call reads.
#[unsafe(no_mangle)]
pub extern "C" fn input(length: usize) -> *mut u8 {
    let mut kept = kept();
    kept.input = vec![0; length];
    kept.input.as_mut_ptr()
}

/// Where the bytes lie that were left last.
#[unsafe(no_mangle)]
pub extern "C" fn output() -> *const u8 {
    kept().output.as_ptr()
}

/// Prepares the moving picture of a page for the settings that were written, lines of
/// `NAME=VALUE`. Leaves `{"span", "time", "stills"}` or `{"error"}`.
#[unsafe(no_mangle)]
pub extern "C" fn open(n: usize) -> usize {
    let settings = taken();
    kept().picture = None;
    let told = MOVING[n].opened(&settings).and_then(|picture| {
        let picture = picture.ok_or(kit::Error::Text {
            text: "a moving picture".into(),
            allowed: "this page has none",
        })?;
        let told = answers::opened(&picture)?;
        kept().picture = Some(picture);
        Ok(told)
    });
    leave(told.unwrap_or_else(|error| answers::error(&error)))
}

/// Leaves the display list of the picture that is open, at a time, seen from elsewhere by so
/// much (rad). Its length; 0 if it cannot be drawn, then [`failure`] says why.
#[unsafe(no_mangle)]
pub extern "C" fn frame(t: f64, about: f64, up: f64) -> usize {
    let picture = kept().picture.take();
    let length = drawn(picture.as_ref(), t, Turn { about, up });
    kept().picture = picture;
    length
}

/// The same of a picture of the last recording.
#[unsafe(no_mangle)]
pub extern "C" fn shown(k: usize, t: f64, about: f64, up: f64) -> usize {
    let pictures = core::mem::take(&mut kept().recorded);
    let length = drawn(pictures.get(k), t, Turn { about, up });
    kept().recorded = pictures;
    length
}

fn drawn(picture: Option<&MovingPicture>, t: f64, turn: Turn) -> usize {
    let drawn = match picture {
        None => Err("no moving picture is open".into()),
        Some(picture) => picture.seen(t, turn).map_err(|e| e.to_string()),
    };
    match drawn {
        Ok((figure, _)) => {
            kept().alt = figure.alt;
            leave(figure.display.encoded())
        }
        Err(reason) => {
            kept().failure = reason;
            0
        }
    }
}

/// Leaves why the last frame could not be drawn.
#[unsafe(no_mangle)]
pub extern "C" fn failure() -> usize {
    let reason = core::mem::take(&mut kept().failure);
    leave(reason)
}

/// Leaves what is to be seen in the last frame, in words.
#[unsafe(no_mangle)]
pub extern "C" fn alt() -> usize {
    let words = core::mem::take(&mut kept().alt);
    leave(words)
}

/// How many pages there are.
#[unsafe(no_mangle)]
pub extern "C" fn pages() -> usize {
    ALL.len()
}

/// Leaves the stem of a page.
#[unsafe(no_mangle)]
pub extern "C" fn stem(n: usize) -> usize {
    leave(page(n).stem())
}

/// Leaves what a page and its parameters are.
#[unsafe(no_mangle)]
pub extern "C" fn declared(n: usize) -> usize {
    leave(page(n).declared())
}

/// Leaves which parameters of a page its moving picture shows, and whether it can be turned:
/// `{"turns", "seen": [names]}` or `{"error"}`.
#[unsafe(no_mangle)]
pub extern "C" fn seen(n: usize) -> usize {
    leave(kit::seen(page(n), MOVING[n]).unwrap_or_else(|error| answers::error(&error)))
}

/// Leaves the inks, `[{"name", "line", "text", "lit", "shade"}]`, in the order of their numbers.
#[unsafe(no_mangle)]
pub extern "C" fn palette() -> usize {
    leave(answers::palette())
}

/// Leaves what the example prints without arguments, with all its sections, as the tests lock it; or the error.
#[unsafe(no_mangle)]
pub extern "C" fn report(n: usize) -> usize {
    let text = page(n).report().and_then(|report| report.text());
    leave(text.unwrap_or_else(|error| format!("error: {error}")))
}

/// Judges an answer by the numbers that were written, line by line: see `answers::judged`. Leaves
/// `{"kind", "words"}`.
#[unsafe(no_mangle)]
pub extern "C" fn judged() -> usize {
    let lines = taken();
    leave(answers::judged(&lines))
}

/// Runs the example with the arguments that were written, parted by NUL, as a terminal would.
/// Leaves `{"stdout", "stderr", "code", "files": [{"name", "text"}]}`.
#[unsafe(no_mangle)]
pub extern "C" fn run(n: usize) -> usize {
    let (outcome, files) = page(n).answer_with_files(parted(&taken()));
    leave(answers::outcome(&outcome, &files))
}

/// Draws all figures for the arguments that were written. Leaves `{"figures": [{"name", "alt",
/// "svg"}]}` or `{"error"}`.
#[unsafe(no_mangle)]
pub extern "C" fn figures(n: usize) -> usize {
    leave(answers::figures(page(n).figures_for(parted(&taken()))))
}

/// Leaves a made-up recording, for a page that reads them.
#[unsafe(no_mangle)]
pub extern "C" fn made(n: usize) -> usize {
    leave(page(n).made().unwrap_or_default())
}

/// What a page makes of a recording. What was written are arguments, parted by NUL, of this length, and then
/// the bytes of the file that `--recording` names. Leaves `{"told", "text", "figures":
/// [{"caption", "name", "alt", "svg"}], "pictures": [{"caption", "turns", "span", "time", "stills"}]}`, `told` as
/// `kit::Recorded::json` has it, or `{"error"}`; the pictures are those that [`shown`] draws.
#[unsafe(no_mangle)]
pub extern "C" fn recorded(n: usize, head: usize) -> usize {
    let input = written();
    let (arguments, bytes) = input.split_at(head.min(input.len()));
    let arguments = parted(&String::from_utf8_lossy(arguments));
    kept().recorded.clear();
    let told = page(n).recorded_for(arguments, bytes).map_err(|told| told.stdout + &told.stderr);
    let told = told.and_then(|recorded| {
        let text = answers::recorded(page(n).stem(), &recorded).map_err(|e| e.to_string())?;
        kept().recorded = recorded.pictures.into_iter().map(|(_, picture)| picture).collect();
        Ok(text)
    });
    leave(told.unwrap_or_else(|reason| answers::error(&reason)))
}

/// What accuracy costs, by the reader's choice: lines of settings, and of `method=NAME` with
/// `setting=VALUE` (steps; of DOP853 a tolerance), or of `solve=TOLERANCE`. Leaves what the run
/// delivered and paid; without a choice `{"methods": [{"name", "order", "setting"}], "span"}`;
/// or `{"error"}`.
#[unsafe(no_mangle)]
pub extern "C" fn lab(n: usize) -> usize {
    let asked = answers::Asked::read(&taken());
    let known = kept().lab.take();
    let known = known.filter(|(of, settings, _)| *of == n && *settings == asked.settings);
    let told = match known {
        Some((.., lab)) => Ok(lab),
        None => page(n).lab(&asked.settings),
    };
    let told = told.map(|lab| {
        let told = asked.answer(lab.as_ref());
        kept().lab = Some((n, asked.settings.clone(), lab));
        told
    });
    leave(told.unwrap_or_else(|error| answers::error(&error)))
}
