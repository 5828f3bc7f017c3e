//! Long runs: the card of effects. What the methods do is held by the locked report.

use crate::steel_block::judged;
use pages::accuracy_races::EXAMPLE;
use support::assert_largest;

#[test]
fn the_model_is_worse_than_the_method() {
    assert_largest!(judged(&EXAMPLE, 1000.0 + 1.0 / 3.0), 2, @"0.0311");
}
