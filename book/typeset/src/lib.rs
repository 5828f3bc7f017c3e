//! How the book sets formulas, numbers, units and figures, as HTML and MathML.
//!
//! The builder sets the pages with it, and the problem sheets are set as the pages are.

pub mod figure;
pub mod fonts;
pub mod maths;
pub mod mend;
pub mod notation;
pub mod text;
pub mod token;
