//! Numbers far from one: what is accepted is right, and what is not is refused. Nothing runs
//! for ever and nothing is NaN.

mod free_body;
mod heavy_top;
mod pendulum;
