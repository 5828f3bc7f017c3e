//! An attack on `solve`: what it grants must hold. Thousands of scenes more are a program,
//! `benches/src/bin/attack`.

mod caught;
mod named;
#[allow(dead_code, reason = "the program uses the rest")]
pub mod scenes;

use super::honesty::Dice;
pub use scenes::truth;
