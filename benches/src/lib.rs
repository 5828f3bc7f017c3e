//! Benchmarks and the accuracy kit.

#[path = "../../tests/accuracy/error_control/attack/scenes/mod.rs"]
pub mod attack;
pub mod ensemble;
#[path = "../../examples/accuracy/honesty.rs"]
pub mod honesty;
pub mod kit;
pub mod readme;
pub mod record;
pub mod throughput;
pub mod timing;

use honesty::Dice;
