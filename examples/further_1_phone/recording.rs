//! A reader's own throw: the recording of a phone's gyroscope, fitted and re-enacted.

use super::{Parameters, Result};
use kit::{Asked, Recorded, Recordings};
use models::throws::{Thrown, made};

/// What the page does with a recording.
pub const RECORDINGS: Recordings<Parameters> =
    Recordings { throws: true, made: made::made, recorded };

fn recorded(p: &Parameters, name: &str, bytes: &[u8], asked: &Asked) -> Result<Recorded> {
    let thrown = Thrown::read(name, bytes, asked)?;
    let size = |flag: &String| ["length", "width", "thickness"].contains(&&**flag);
    let boxed = asked.given.iter().any(size).then_some([p.width, p.length, p.thickness]);
    let mut recorded = thrown.recorded(boxed)?;
    let again = thrown.again([p.length, p.width, p.thickness], p.gravity)?;
    recorded.pictures.insert(0, ("recorded_throw", again));
    Ok(recorded)
}
