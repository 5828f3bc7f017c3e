//! What `figures!` draws.

use super::{Panel, Sketch, Stack, View};
use crate::Figure;
use crate::error::Result;

/// A picture that becomes a figure once it has a name and says what is to be seen.
pub trait Drawing {
    /// The figure `name`; `alt` says in a sentence what is to be seen.
    ///
    /// # Errors
    /// Those of the picture's own `figure`.
    fn drawn(self, name: &str, alt: &str) -> Result<Figure>;
}

macro_rules! drawings {
    ($($picture:ident)+) => { $(
        impl Drawing for $picture {
            fn drawn(self, name: &str, alt: &str) -> Result<Figure> {
                self.called(name, alt).figure()
            }
        }
    )+ };
}
drawings! { Panel Sketch Stack View }
