//! Which registers a run may use, in a build with `--cfg registers`: the environment says it, and
//! `.ci/same_bits` compares what narrower ones give. No other build asks.

use std::sync::OnceLock;

/// How many doubles a register may hold at most.
pub(super) fn widest() -> usize {
    static WIDEST: OnceLock<usize> = OnceLock::new();
    *WIDEST.get_or_init(|| match std::env::var("REGISTERS").as_deref() {
        Ok("avx512") => 8,
        Ok("avx2") => 4,
        Ok("plain") => 1,
        other => panic!("REGISTERS is {other:?}, neither avx512, avx2 nor plain"),
    })
}
