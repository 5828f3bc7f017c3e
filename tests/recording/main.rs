//! Recordings of a phone's sensors: read, searched for flights, made.

mod bad;
mod flights;
mod formats;
