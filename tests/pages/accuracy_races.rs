//! Long runs: the card of effects. What the methods do is held by the locked report.

use crate::steel_block::judged;
use pages::accuracy_races::EXAMPLE;

#[test]
fn the_model_is_worse_than_the_method() {
    judged(&EXAMPLE, 1000.0 + 1.0 / 3.0, 3.10e-2..=3.11e-2);
}
