//! What can go wrong on a page.

pub use rotation_dynamics::error::{Error, Result};
pub(crate) use rotation_dynamics::error::{finite, not_negative, positive};
