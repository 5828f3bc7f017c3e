//! Benchmarks and the accuracy kit.
