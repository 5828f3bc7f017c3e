//! Benchmarks and the accuracy kit.

pub mod conditions;
pub mod ensemble;
pub mod kit;
pub mod readme;
pub mod throughput;
pub mod timing;
