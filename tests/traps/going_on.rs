//! Going on from a located event: a start that is on it is not the next one.
