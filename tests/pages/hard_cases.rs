//! The table of hard cases; its parts are in `tests/hard_cases`.

#[path = "../hard_cases/table.rs"]
mod table;
#[path = "../hard_cases/torques.rs"]
mod torques;
