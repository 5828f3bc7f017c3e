//! Benchmarks and the accuracy kit.

#[path = "../../tests/accuracy/error_control/attack/scenes/mod.rs"]
pub mod attack;
pub mod ensemble;
#[path = "../../examples/accuracy/honesty.rs"]
pub mod honesty;
pub mod kit;
pub mod record;
pub mod throughput;
pub mod timing;

use honesty::Dice;
use std::path::PathBuf;

/// The record of the races, relative to the project's root.
pub const RECORD: &str = "benches/record/peers.txt";

/// The record of the races of motions without a closed form.
pub const OPEN_RECORD: &str = "benches/record/peers_open.txt";

/// A path in the project.
pub fn path(relative: &str) -> PathBuf {
    PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/..")).join(relative)
}
