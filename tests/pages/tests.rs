//! The tests of the pages, one binary: what all must hold (`snapshots`, …), and for each
//! stem what is special to it, in the file of that name.

include!(concat!(env!("OUT_DIR"), "/tests.rs"));
