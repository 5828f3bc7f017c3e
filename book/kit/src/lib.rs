//! What the pages are made of: claims, tables, figures, and the command line of the examples.
//!
//! A [`Report`] is what an example says: claims that an independent route
//! confirms, limits, the effects in and out, what accuracy costs. Its text is the
//! locked snapshot and the source of every number on the example's page; the
//! example prints it, all but what the answer box needs. This crate does no physics,
//! and but for [`cli`] it reads and writes nothing.
//!
//! What an example is made of: its [`parameters!`](crate::parameters); a [`Report`] with
//! its [`claims!`](crate::claims), its [`limits!`](crate::limits) and its card of
//! [`effect_card!`](crate::effect_card); [`figures!`](crate::figures) by [`draw`], a
//! [`MovingPicture`], and [`times`] and [`sampled`] to sample a motion; [`allowed!`](crate::allowed) and [`require`] to refuse what the page cannot take; all that by [`prelude`]; at the end [`example!`](crate::example), which makes an
//! [`Example`] of them.
//!
//! # The text of a report
//! ```text
//! report      = title NEWLINE [ description NEWLINE ] { NEWLINE section }
//! section     = heading NEWLINE columns { row }
//! heading     = "parameters" | "claims" | "limits" | "effects" | "accuracy"
//!             | "table " NAME | "checks" | "slips"
//! columns,row = cell { two or more spaces, cell } NEWLINE
//! ```
//! A blank line stands before every section and nowhere else. A cell is never
//! empty (`-` stands for nothing) and never holds two spaces in a row; the columns
//! are aligned, the first starts at the margin. [`parse`] reads it back.
//!
//! | section | columns |
//! |---|---|
//! | `parameters` | `flag`, `value`, `unit`, `meaning` |
//! | `claims` | `key`, `value`, `unit`, `bound`, `checked against`, `differs by` |
//! | `limits` | `limit`, `must give`, `gives`, `within`, `because` |
//! | `effects` | `effect`, `number`, `value`, `error if left out`, `measured`, `cost: without, with`, `here`, `at ACCURACY` |
//! | `accuracy` | `method`, `requested`, `delivered`, `work`, `relative time` |
//! | `checks` | `key`, `within`, `meaning`, `group` |
//! | `slips` | `key`, `value`, `hint` |
//!
//! `measured` and `cost: without, with` stand in `effects` where a line has them. `here` says
//! whether the scene has the effect `in` or `left out`, the last column whether the accuracy in its
//! head ([`Report::ask`]) calls for it: `in` or `out`, with the tolerance where that is neither a
//! part nor in radians.
//!
//! A claim's value shows only the digits its bound supports ([`supported_digits`]). The column `bound`
//! is that of the value as it is printed: it includes what the rounding took away.
//! `within` in `checks` is the relative tolerance of [`Claim::verdict`], which is
//! also the rule of the page's answer box. With a column `group` the box offers the
//! claims that have one, under it; `-` is for those that a reader does not compute.

mod air;
mod answer;
mod card;
mod claim;
pub mod cli;
mod computation;
pub mod draw;
mod entries;
pub mod error;
mod example;
mod expression;
mod files;
pub mod interval;
mod json;
mod lab;
mod lines;
mod live;
mod moving;
mod number;
mod numeric;
mod parameters;
pub mod prelude;
mod prepared;
mod recorded;
pub mod recording;
mod sampling;
mod sections;
mod seen;
mod strip;
mod table;
mod trajectory;

pub use air::{driven_in_air, taken_by_air};
pub use answer::{Answer, Verdict, digits_asked};
pub use card::EffectEntry;
pub use claim::{Claim, Oracle, Slip, claim};
pub use computation::{ClosedForm, Computation};
pub use entries::{CardLine, EffectLine, Entry, effect};
pub use error::{Error, Result};
pub use example::{Example, Page};
pub use json::quoted;
pub use lab::{Lab, Tried};
pub use live::Moves;
pub use moving::MovingPicture;
pub use number::{below, decimals, exactly, rounded_up, short, supported_digits};
pub use numeric::{But, bisect, require, simpson, solved, try_bisect, when};
pub use parameters::{Flag, Grid, ParameterSet, Settings, Value, name_of_flag};
pub use prepared::Prepared;
pub use recorded::{Asked, Decided, Found, Recorded, Recordings, with_interval};
pub use sampling::{sampled, times};
pub use sections::{Limit, Price, Report, for_reading, limit};
pub use seen::seen;
pub use strip::STEPPING;
pub use table::{Parsed, Table, parse};
pub use trajectory::Trajectory;

/// A finished drawing.
#[derive(Debug, Clone, PartialEq)]
pub struct Figure {
    /// Its name within the example, `[a-z0-9_]+`.
    pub name: String,
    /// What is to be seen, for those who do not see it (also in the SVG, as its label).
    pub alt: String,
    /// What is drawn.
    pub display: draw::Display,
}
