//! Measures of error and work-precision curves, on states and runs whose answer is known.

#[path = "accuracy/measures.rs"]
mod measures;
#[path = "accuracy/sweep.rs"]
mod sweep;
