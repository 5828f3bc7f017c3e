//! A reader's own swing: the recording of a phone's gyroscope, fitted by the exact pendulum.

use super::*;
use kit::{Asked, Recorded, Recordings};

/// What the page does with a recording.
pub const RECORDINGS: Recordings<Parameters> =
    Recordings { throws: false, made: models::swings::made, recorded };

fn recorded(p: &Parameters, name: &str, bytes: &[u8], asked: &Asked) -> Result<Recorded> {
    let m = Moments::new(p)?;
    let length = |moment: f64| moment * p.gravity / m.gravity;
    let own = [("disc fixed", length(m.carried + m.own)), ("disc free", length(m.carried))];
    models::swings::recorded(name, bytes, asked, p.gravity, &own)
}
