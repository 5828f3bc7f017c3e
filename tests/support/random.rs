//! Numbers that look random and are the same in every run.

use crate::EPS;

/// SplitMix64: G. L. Steele, D. Lea, C. H. Flood, OOPSLA 2014.
#[derive(Debug, Clone)]
pub struct Random(pub u64);

impl Random {
    /// In [0, 1).
    pub fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) >> 11) as f64 * EPS
    }

    /// In [a, b).
    pub fn between(&mut self, a: f64, b: f64) -> f64 {
        a + (b - a) * self.unit()
    }

    /// Its logarithm is spread evenly.
    pub fn size(&mut self, low: f64, high: f64) -> f64 {
        low * (high / low).powf(self.unit())
    }

    /// Components in [-1, 1).
    pub fn vector<const N: usize>(&mut self) -> [f64; N] {
        core::array::from_fn(|_| self.between(-1.0, 1.0))
    }
}
