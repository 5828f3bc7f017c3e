//! Refusals say what is wrong, in few digits.
