//! What accuracy costs: the card of effects. What the methods do is held by the locked report
//! and by the tests of the library.

use crate::steel_block::judged;
use pages::accuracy::EXAMPLE;
use support::assert_largest;

#[test]
fn the_model_is_worse_than_the_method() {
    assert_largest!(judged(&EXAMPLE, 10.0), 2, @"0.0262");
}
