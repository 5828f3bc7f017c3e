//! What users of rotation codes stumble over, kind by kind: reports about other programs, tried
//! here with the right value beside them, and a random sweep of each kind.

mod cancellation;
mod going_on;
mod messages;
mod no_time;
mod solve;
mod thin_bodies;
