//! Double-double arithmetic (to be written).

/// An unevaluated sum of two doubles.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DoubleDouble {
    pub hi: f64,
    pub lo: f64,
}
