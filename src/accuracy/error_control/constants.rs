//! The tuned constants of the error control, each with its purpose, and with what it was derived from or
//! measured on where that is known.
//!
//! What a method does on a turn is a row of its own, in `method`; what the search for crossings
//! takes is in `crossings`, the search for jumps and kinks in `effects::check`. What a change does
//! to thousands of scenes, and to the work:
//!
//! ```text
//! cargo run --release -p benches --bin attack
//! cargo run --release -p benches --bin price
//! ```

#![warn(clippy::missing_docs_in_private_items)]

// Which method comes first.

/// Under smooth torques that see more than the axis Gauss-Legendre of order 16 costs less than DOP853
/// below this error: measured on satellites, motors and magnets.
pub(super) const ORDER_SIXTEEN: f64 = 1e-8;

// The distance of two runs.

/// ln 40: a level is a factor of 40 in the error.
pub(super) const LEVEL: f64 = 3.688_879_454_113_936;

/// An error is estimated as so many times the distance of two runs. The second is 40 times finer
/// (DOP853: 13 times): where errors fall as they should the distance is 13 to 40 times the error.
pub(super) const SAFETY: f64 = 2.0;

/// Over kinks that nothing names, the error of a run depends on where its steps happen to fall, and
/// two runs may agree by chance. The distance of the last two counts as no less than the distance
/// of the two before, fallen by this a level, and all of it [`SAFETY`] times. Over what is smooth
/// DOP853 falls by 13 a level; with 8 one of 36 100 answers over kinks, cusps and jumps is above
/// its request.
pub(super) const KINKED: f64 = 8.0;

/// Levels from a run to the next, at most. One more is left to a run whose steps were short from the first:
/// with as many, one of 2000 pulses that nothing names was above 1e-12.
pub(super) const MOST_LEVELS: f64 = 3.0;

/// A method ends where so many distances in a row stay above half the smallest.
pub(super) const STUCK: u32 = 3;

/// The error allowed for a step of DOP853 at level 0.
pub(super) const OF_A_STEP: f64 = 1e-3;

/// More steps of a piece than these are refined by the error allowed for each. A stretch between two
/// known states is stepped in parts of so many, of which every state is found from the last before it.
pub(super) const FEW: u64 = 8;

// The condition, as the distance of two runs shows it.

/// The change of the inputs of the first run, as a part of the tolerance, for each radian that a
/// motion is late. It moves the end of one that is only late by some hundredths of the tolerance.
pub(super) const CHANGED: f64 = 0.05;

/// A floor that is so many times below the tolerance need not be known well, nor one that is as far
/// above. A single change of all inputs moves the end by a sum with signs. In one direction that is below
/// 1/30 of its root mean square in 27 cases of a thousand, in three alike in one of 20 000 (a normal
/// distribution). A distance that runs do not get below, and no more than so many floors, is round-off.
pub(super) const FAR_BELOW: f64 = 30.0;

/// A motion whose condition is at most this many times the condition of a motion that is only late
/// counts as passing no saddle.
pub(super) const REGULAR: f64 = 6.0;

// The condition, as runs of its own show it.

/// Where the floor is neither far below the tolerance nor far above, so many changes are made, each with
/// the state moved on the way too, as often as runs are compared where every state is asked for
/// ([`COMPARED`]): what passes a saddle must be moved on its way there.
pub(super) const ROWS: usize = 5;

/// The level of DOP853 there, at least. It answers a small change with a small jump, of its error: at
/// this level of some 1e-11 a step.
pub(super) const FINE_ENOUGH: f64 = 5.0;

// Closed forms.

/// The error of a closed form, in units of eps (1 + condition). Measured over the reference
/// cases: 5.6, of which the rates cost most, read from a state that holds L in space.
pub(super) const CLOSED_FORM: f64 = 8.0;

/// 1 - m below which a motion is near a separatrix (m: the parameter of its elliptic functions).
pub(super) const NEAR_SEPARATRIX: f64 = 1e-6;

// Where runs are cut, compared and gone on from.

/// The angle (rad) that a body turns at most between two places where its effects are tried,
pub(super) const CUT: f64 = 30.0;
/// of which there are no more than so many.
pub(super) const MOST_CUTS: f64 = 8.0;

/// Where every state is asked for, runs are compared once in so many radians that the body turns,
pub(super) const COMPARED: f64 = 3.0;
/// at so many places at most.
pub(super) const MOST_COMPARED: f64 = 128.0;

// Features in time that nothing names, and pulses.

/// A pulse whose width is named is taken in so many steps at least.
pub(super) const STEPS_IN_PULSE: f64 = 2.0;

/// A jump that nothing names is met by a step that is not too long: two steps over a whole
/// span may leave it between them. With 64 none of 11 478 answers of `attack -- kinked` was above its
/// request, with 16 one of 11 485, for a quarter of the work over short spans.
pub(super) const STEPS_OVER_JUMPS: f64 = 16.0;

// Slender bodies.

/// Moments further apart than this by a factor make a slender body. Tumbling under the gravity
/// gradient and a motor was tried to 1e-3, 1e-6 and 1e-9. With L on the fixed axes DOP853 took more
/// derivatives than on the body's: 1.3 to 2.0 times where moments are 2 to 8 apart, 2.2 to 3.9
/// times at 16, 6 to 17 times at 64.
pub(super) const SLENDER: f64 = 16.0;

/// A motion whose energy allows no rate that is so many times the one that occurs is stepped with L on
/// the fixed axes: it turns mostly about the thin axis. (A cone that rolls has 4.9.)
pub(super) const TUMBLING: f64 = 5.0;

// Motion that slides along a switch.

/// A switch that comes after less than this part of a step is one back at once. On a surface on which
/// the motion slides it comes after roundings of the time, or, where the torque does not change the
/// rate of the signal itself, after the root of a rounding.
pub(super) const AT_ONCE: f64 = 1e-6;

/// So many in a row are no graze, which is two: the motion slides.
pub(super) const SLIDES: u32 = 8;
