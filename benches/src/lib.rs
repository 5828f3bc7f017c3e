//! Benchmarks and the accuracy kit.

pub mod kit;
pub mod timing;
