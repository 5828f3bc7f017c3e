//! The one error type of the library.
//!
//! Every variant carries the numbers that offend and says what is allowed, so
//! that a message can be acted on without reading code.

use core::fmt;

/// What can go wrong, with the numbers that went wrong.
#[non_exhaustive]
#[derive(Debug, Clone, PartialEq)]
pub enum Error {
    /// An input is NaN or infinite.
    NotFinite { name: &'static str, value: f64 },
    /// An input lies outside the range in which it means something.
    OutOfRange {
        name: &'static str,
        value: f64,
        allowed: &'static str,
    },
    /// No motion of a heavy top has this energy.
    NoMotion { energy: f64, minimum: f64 },
    /// The rates of a motion are too fast, too slow, or too far apart for doubles.
    RatesTooFarApart { fastest: f64 },
    /// A derivative is NaN or infinite at this time and state.
    DerivativeNotFinite {
        t: f64,
        state: Vec<f64>,
        derivative: Vec<f64>,
    },
    /// A torque is NaN or infinite at this time and state (quaternion, momentum).
    TorqueNotFinite {
        effect: String,
        t: f64,
        state: [f64; 7],
        torque: [f64; 3],
    },
    /// A torque that is finite, but whose power is not, at the rate (rad/s) that it may give the
    /// body.
    TorqueTooLarge {
        effect: String,
        t: f64,
        torque: f64,
        rate: f64,
    },
    /// An effect says something of itself that its torque contradicts.
    Contradiction {
        effect: String,
        claim: &'static str,
        t: f64,
        off: f64,
        allowed: f64,
    },
    /// A torque that is another one when it is asked for again at the same time and state.
    NotAFunction {
        effect: String,
        t: f64,
        first: [f64; 3],
        again: [f64; 3],
    },
    /// Steps that collapse where the torque jumps with the state, to and fro: sliding motion.
    Sliding { effect: String, t: f64 },
    /// Runs that do not agree, over a torque that depends on the time and was looked at once in so
    /// many seconds.
    Unseen {
        effect: String,
        requested: f64,
        every: f64,
    },
    /// Effects that see more than the body's axis, where only the axis is carried.
    SeesMore { effects: String },
    /// Effects that turn the body beyond I^-1 L, where only that is carried.
    Slips { effects: String },
    /// A scene in which gravity stands twice.
    TwoGravities { effects: String },
    /// An effect that must have the body's axis to itself, among others with a torque there.
    NotAlone {
        effect: &'static str,
        others: String,
    },
    /// An effect that was made for one motion, in a scene that starts another.
    OtherMotion {
        effect: &'static str,
        name: &'static str,
        t: f64,
        value: f64,
        expected: f64,
    },
    /// A list of times, or the like, in which one does not come after the one before it.
    NotRising {
        name: &'static str,
        index: usize,
        before: f64,
        value: f64,
    },
    /// A solution that would cost more torques than it was allowed.
    OverBudget { t: f64, t_end: f64, budget: u64 },
    /// A solution that was cancelled.
    Cancelled { torques: u64 },
    /// An event function is NaN or infinite.
    EventNotFinite {
        name: &'static str,
        t: f64,
        value: f64,
    },
    /// No step is short enough for the tolerance.
    StepUnderflow { t: f64, step: f64, state: Vec<f64> },
    /// The steps of a run are as short as what doubles tell apart at this time.
    ClockTooCoarse { t: f64, step: f64 },
    /// A run needs more steps than it was allowed.
    TooManySteps { t: f64, t_end: f64, limit: u64 },
    /// The stage equations of an implicit step do not contract.
    NoConvergence { t: f64, h: f64, change: f64 },
    /// A time so late or so early that its last bit leaves the phase of the motion open.
    PhaseLost { t: f64, latest: f64 },
    /// A time at which a solution is not known.
    OutsideRun { t: f64, start: f64, end: f64 },
    /// A 3x3 matrix is not a rotation: R^T R is off 1, or R is a reflection.
    NotRotation { deviation: f64, determinant: f64 },
    /// The rates of the Euler angles are asked for with the body axis vertical.
    AtPole { theta: f64 },
    /// The rates of three angles are asked for where two of the turns are about one line.
    GimbalLock {
        sequence: &'static str,
        angle: f64,
        locked: &'static str,
    },
    /// One moment of inertia exceeds the sum of the other two by this much, and by more than
    /// rounding makes, the `slack` (kg m^2).
    TriangleInequality {
        moments: [f64; 3],
        excess: f64,
        slack: f64,
    },
    /// The moments of a rod, or of a point mass, where each must be greater than zero; rounding
    /// hides what is not above `known_within` (kg m^2).
    OnALine {
        moments: [f64; 3],
        known_within: f64,
    },
    /// A tensor that must be symmetric is not: its largest |I_ij - I_ji|.
    NotSymmetric { difference: f64 },
    /// A phase is entered whose own condition does not hold.
    ConditionBroken {
        name: &'static str,
        value: f64,
        t: f64,
    },
    /// A scene changes its phase again and again without getting on.
    TooManyPhases { t: f64, limit: usize },
    /// A contact whose gap is negative or closing at the start.
    CannotHold {
        contact: &'static str,
        t: f64,
        gap: f64,
        speed: f64,
    },
    /// A mass matrix, row after row, that is not symmetric and positive definite.
    MassNotPositive {
        t: f64,
        coordinates: Vec<f64>,
        mass: Vec<f64>,
    },
    /// The forces on a mechanism are NaN or infinite at this time and state.
    ForceNotFinite {
        t: f64,
        state: Vec<f64>,
        force: Vec<f64>,
    },
    /// Dry friction and one-sided contacts allow no motion from here (Painlevé).
    NoContactForces {
        t: f64,
        state: Vec<f64>,
        tried: usize,
    },
    /// Dry friction and one-sided contacts allow more than one motion from here (Painlevé).
    SeveralMotions {
        t: f64,
        state: Vec<f64>,
        first: String,
        second: String,
    },
    /// An impact with restitution and friction that would end with more energy.
    ImpactGainsEnergy { t: f64, before: f64, after: f64 },
    /// Bounces that have become lower than doubles resolve: they would go on for ever.
    BouncesUnresolved {
        contact: &'static str,
        t: f64,
        height: f64,
    },
    /// A change of phase was waited for and did not come.
    NotReached { name: &'static str, until: f64 },
    /// A start so fast that a body would leave the floor at once.
    FloorWouldPull { rate: f64, limit: f64 },
    /// Two lists that belong together have different lengths.
    Lengths {
        name: &'static str,
        found: usize,
        expected: usize,
    },
    /// One of a list is refused.
    AtIndex {
        name: &'static str,
        index: usize,
        reason: Box<Error>,
    },
    /// A motion whose inputs are not known has no condition.
    ConditionUnknown { name: &'static str },
    /// The error asked for at the end cannot be reached with doubles.
    NotDelivered { requested: f64, reached: f64 },
    /// The inputs, as doubles, do not determine the end as closely as is asked for; if
    /// `attainable` (rad) is half a turn or more, not at all.
    BeyondCondition {
        requested: f64,
        attainable: f64,
        condition: f64,
    },
}

/// `Result` with this crate's [`Error`].
pub type Result<T> = core::result::Result<T, Error>;

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotFinite { name, value } => {
                write!(f, "{name} = {} is not a finite number", plain(*value))
            }
            Self::OutOfRange {
                name,
                value,
                allowed,
            } => write!(f, "{name} = {} is not allowed: {allowed}", plain(*value)),
            Self::NoMotion { energy, minimum } => {
                // Six places, or all of them if six do not show the difference.
                let short = format!("{minimum:.6}");
                let rounded = short.parse::<f64>().unwrap_or(f64::NAN);
                let seen = (rounded - minimum).abs() < 0.1 * (minimum - energy);
                let minimum = match seen && minimum.abs() < MANY {
                    true => short,
                    false => plain(*minimum),
                };
                // Two places at least: the notes write 0.40.
                let places = format!("{energy:.2}");
                let exact = places.parse::<f64>().is_ok_and(|e| e == *energy);
                let energy = match exact && energy.abs() < MANY {
                    true => places,
                    false => plain(*energy),
                };
                write!(f, "no motion: E~ = {energy} is below U_min = {minimum}")
            }
            Self::Lengths {
                name,
                found,
                expected,
            } => write!(f, "{name}: {found} given where there must be {expected}"),
            Self::AtIndex {
                name,
                index,
                reason,
            } => write!(f, "{name}[{index}]: {reason}"),
            Self::ConditionUnknown { name } => write!(
                f,
                "the condition of \"{name}\" is not known: what it was made from is not"
            ),
            Self::RatesTooFarApart { fastest } => write!(
                f,
                "the rates of this motion are too large, too small or too far apart (the fastest \
                 is {}): their squares, and the products and quotients that are formed of these, \
                 must stay within doubles, from 1e-308 to 1e299",
                if fastest.is_finite() {
                    plain(*fastest)
                } else {
                    "beyond 1e150".into()
                }
            ),
            Self::DerivativeNotFinite {
                t,
                state,
                derivative,
            } => write!(
                f,
                "the derivative at t = {}, y = {state:?} is {derivative:?}; it must be finite",
                plain(*t)
            ),
            Self::TorqueNotFinite {
                effect,
                t,
                state,
                torque,
            } => write!(
                f,
                "the torque of \"{effect}\" at t = {}, quaternion and momentum {state:?}, is \
                 {torque:?}; it must be finite",
                plain(*t)
            ),
            Self::TorqueTooLarge {
                effect,
                t,
                torque,
                rate,
            } => write!(
                f,
                "the torque of \"{effect}\" at t = {} is {torque:.3e} N m, on a body that may turn at \
                 {rate:.3e} rad/s: its power must be a finite number, at most 1.8e308 W",
                plain(*t)
            ),
            Self::Contradiction {
                effect,
                claim,
                t,
                off,
                ..
            } if off.is_nan() => write!(
                f,
                "\"{effect}\" says {claim}, and at t = {} what it says is no number",
                plain(*t)
            ),
            Self::Contradiction {
                effect,
                claim,
                t,
                off,
                allowed,
            } => write!(
                f,
                "\"{effect}\" says {}, and at t = {} its torque is off that by {off:.3e} \
                 (at most {allowed:.1e} is allowed)",
                claim,
                plain(*t)
            ),
            Self::NotAFunction {
                effect,
                t,
                first,
                again,
            } => write!(
                f,
                "the torque of \"{effect}\" at t = {} is {first:?} N m, and {again:?} when it is asked \
                 for again in the same state: it must be a function of time and state that remembers \
                 nothing; solve a torque that is held between samples from one sample to the next",
                plain(*t)
            ),
            Self::Sliding { effect, t } => write!(
                f,
                "sliding motion at a jump of \"{effect}\" near t = {}: the torque jumps with the \
                 state, back and forth in every step, and the steps collapse; let it pass from one \
                 value to the other over a small width, as tanh does, or end the motion there",
                brief(*t)
            ),
            Self::Unseen {
                effect,
                requested,
                every,
            } => write!(
                f,
                "an error of {requested:e} is asked for, and runs do not agree: the torque of \
                 \"{effect}\" was looked at every {} s, and what is shorter may be unseen; \
                 name its break points, or its narrowest feature",
                brief(*every)
            ),
            Self::SeesMore { effects } => write!(
                f,
                "splittings, and variables other than those in space, see the body's axis only: \
                 an effect that sees more ({effects}) is not allowed there"
            ),
            Self::Slips { effects } => write!(
                f,
                "a method that steps the angular velocity turns the body by that alone: an effect \
                 that turns it further ({effects}) is not allowed there"
            ),
            Self::TwoGravities { effects } => write!(
                f,
                "gravity acts twice in this scene ({effects}): one weight at one place is allowed"
            ),
            Self::NotAlone { effect, others } => write!(
                f,
                "\"{effect}\" must be the only torque about the body's axis; here are also: {others}"
            ),
            Self::OtherMotion {
                effect,
                name,
                t,
                value,
                expected,
            } => write!(
                f,
                "\"{effect}\" was made for a motion in which {name} is {} at t = {}, and here it \
                 is {}: make it anew from this body and this start",
                plain(*expected),
                plain(*t),
                plain(*value)
            ),
            Self::NotRising {
                name,
                index,
                before,
                value,
            } => write!(
                f,
                "{name} {index} is {}, and the one before it {}: they must rise",
                plain(*value),
                plain(*before)
            ),
            Self::OverBudget { t, t_end, budget } => write!(
                f,
                "from t = {} to {} this takes more than the {budget} torques that are allowed: \
                 allow more of them, a larger error, longer steps or a shorter time; \
                 or name the times at which a torque jumps or has a kink",
                plain(*t),
                plain(*t_end)
            ),
            Self::Cancelled { torques } => {
                write!(f, "cancelled, after {torques} torques")
            }
            Self::EventNotFinite { name, t, value } => write!(
                f,
                "the function of the event \"{name}\" is {} at t = {}; it must be finite",
                plain(*value),
                plain(*t)
            ),
            Self::StepUnderflow { t, step, state } => write!(
                f,
                "at t = {}, y = {state:?} even a step of {} misses the tolerance: \
                 the system is singular there, or the tolerance too small",
                plain(*t),
                plain(*step)
            ),
            Self::ClockTooCoarse { t, step } => write!(
                f,
                "at t = {} the clock is too coarse: it shows no time shorter than {:.1e}, and steps \
                 of {step:.1e} are needed; count the time from 0 at the start of the run",
                plain(*t),
                t.abs().next_up() - t.abs()
            ),
            Self::NoConvergence { t, h, change } => write!(
                f,
                "the stages of the step from t = {} by {} do not converge (the last sweep \
                 changed them by {change:.1e}): take more steps",
                plain(*t),
                plain(*h)
            ),
            Self::TooManySteps { t, t_end, limit } => write!(
                f,
                "after {limit} steps the run has come to t = {} of {}: \
                 allow more steps or a larger tolerance",
                plain(*t),
                plain(*t_end)
            ),
            Self::PhaseLost { t, latest } => write!(
                f,
                "at t = {} the phase of the motion is lost: beyond {latest:.3e} the last bit of the \
                 time is a 32nd of a turn or more",
                plain(*t)
            ),
            Self::OutsideRun { t, start, end } => write!(
                f,
                "t = {} is outside the run, which goes from {} to {}",
                plain(*t),
                plain(*start),
                plain(*end)
            ),
            Self::NotRotation {
                deviation,
                determinant,
            } => write!(
                f,
                "the matrix is not a rotation: R^T R is off 1 by {deviation:.3e} (at most 1e-12 is \
                 allowed) and its determinant is {} (it must be +1)",
                plain(*determinant)
            ),
            Self::AtPole { theta } => write!(
                f,
                "theta = {}: the body axis is vertical, so precession and spin are about the \
                 same line and their rates are not defined; theta must not be a multiple of pi",
                plain(*theta)
            ),
            Self::GimbalLock {
                sequence,
                angle,
                locked,
            } => write!(
                f,
                "second angle = {} of {sequence}: the first and the third turn are about the \
                 same line and their rates are not defined; it must not be {locked}",
                plain(*angle)
            ),
            Self::TriangleInequality {
                moments,
                excess,
                slack,
            } => write!(
                f,
                "the moments of inertia ({}) belong to no body: none may exceed the sum \
                 of the other two, and the largest does by {} (rounding explains {})",
                moments.map(plain).join(", "),
                brief(*excess),
                brief(*slack)
            ),
            Self::OnALine {
                moments,
                known_within,
            } => {
                let (body, axis) = match moments.iter().any(|m| *m > 0.0) {
                    true => ("rod", "its own axis"),
                    false => ("point mass", "any axis"),
                };
                write!(
                    f,
                    "the moments of inertia ({}) are those of a {body}: it has no moment about {axis}",
                    moments.map(plain).join(", ")
                )?;
                if *known_within > 0.0 {
                    write!(
                        f,
                        ", or none above what rounding hides, {}",
                        brief(*known_within)
                    )?;
                }
                write!(f, "; a body that turns freely needs each greater than 0")
            }
            Self::NotSymmetric { difference } => write!(
                f,
                "the tensor is not symmetric: elements across the diagonal differ by {difference:e}"
            ),
            Self::ConditionBroken { name, value, t } => write!(
                f,
                "at t = {} a phase begins in which \"{name}\" must not be negative, but it is {} or \
                 becomes so at once (a gap that is shut there and opens is an `opening_gap`)",
                plain(*t),
                plain(*value)
            ),
            Self::TooManyPhases { t, limit } => write!(
                f,
                "after {limit} changes of phase the scene has only come to t = {}",
                plain(*t)
            ),
            Self::CannotHold {
                contact,
                t,
                gap,
                speed,
            } => write!(
                f,
                "\"{contact}\" cannot hold at t = {}: its gap is {} and opens at {} a second; \
                 neither may be negative (a joint needs both to be 0, a force that presses \
                 must not be negative)",
                plain(*t),
                plain(*gap),
                plain(*speed)
            ),
            Self::MassNotPositive {
                t,
                coordinates,
                mass,
            } => write!(
                f,
                "the mass matrix at t = {}, coordinates {coordinates:?}, is {mass:?}, row after row; \
                 it must be symmetric and positive definite",
                plain(*t)
            ),
            Self::ForceNotFinite { t, state, force } => write!(
                f,
                "the forces at t = {}, coordinates and velocities {state:?}, are {force:?}; they \
                 must be finite",
                plain(*t)
            ),
            Self::NoContactForces { t, state, tried } => write!(
                f,
                "at t = {}, coordinates and velocities {state:?}, no contact forces obey the laws \
                 of dry friction (Painlev\u{e9}): {tried} sets of modes were tried; less friction helps, \
                 or a unit of length in which lengths are near 1",
                plain(*t)
            ),
            Self::SeveralMotions {
                t,
                state,
                first,
                second,
            } => write!(
                f,
                "at t = {}, coordinates and velocities {state:?}, dry friction allows two motions \
                 (Painlev\u{e9}): {first}; or {second}",
                plain(*t)
            ),
            Self::ImpactGainsEnergy { t, before, after } => write!(
                f,
                "the impact at t = {} would raise the kinetic energy from {} to {}: \
                 Newton's restitution contradicts this friction; take a smaller one of the two",
                plain(*t),
                plain(*before),
                plain(*after)
            ),
            Self::BouncesUnresolved { contact, t, height } => write!(
                f,
                "at t = {} the bounces of \"{contact}\" are {height:.1e} high, which doubles do not \
                 resolve, and there would be infinitely many more: end before, or take a restitution of 0",
                plain(*t)
            ),
            Self::NotReached { name, until } => {
                write!(f, "\"{name}\" does not happen until t = {}", plain(*until))
            }
            Self::FloorWouldPull { rate, limit } => write!(
                f,
                "at {} rad/s the floor would have to pull to keep the foot down: at this angle \
                 at most {} rad/s",
                plain(*rate),
                plain(*limit)
            ),
            Self::NotDelivered { requested, reached } if !reached.is_finite() => write!(
                f,
                "an error of {requested:e} is asked for, and finer and finer runs do not even agree \
                 on what happens: the start is too near a limit for doubles"
            ),
            Self::BeyondCondition {
                requested,
                attainable,
                ..
            } if attainable.is_nan() || *attainable >= core::f64::consts::PI => write!(
                f,
                "an error of {requested:e} rad is asked for, and nothing can be promised: as on a \
                 separatrix, a change of the inputs in their last digits leads to any other \
                 attitude at the end"
            ),
            Self::BeyondCondition {
                requested,
                attainable,
                condition,
            } => write!(
                f,
                "an error of {requested:e} rad is asked for, and doubles allow {attainable:.1e} \
                 at best: a small relative change of the inputs is {} times as much (in rad) at \
                 the end",
                if condition.abs() < 1e4 {
                    format!("{condition:.0}")
                } else {
                    format!("{condition:.1e}")
                }
            ),
            Self::NotDelivered { requested, reached } => write!(
                f,
                "an error of {requested:e} is asked for, and the runs that were made bear out none \
                 below {reached:.1e}"
            ),
        }
    }
}

/// A number from here on is written with an exponent.
const MANY: f64 = 1e15;

/// `value` as people write it: 0.25 and 45, but 1e308 and not three hundred zeros.
pub fn plain(value: f64) -> String {
    let size = value.abs();
    if size == 0.0 || (1e-4..MANY).contains(&size) || !value.is_finite() {
        value.to_string()
    } else {
        format!("{value:e}")
    }
}

/// Three digits of a number whose size alone matters.
fn brief(value: f64) -> String {
    plain(format!("{value:.2e}").parse().unwrap_or(value))
}

impl std::error::Error for Error {}

/// Returns `value` if it is finite.
///
/// # Errors
/// [`Error::NotFinite`], with this name, if it is not.
pub fn finite(name: &'static str, value: f64) -> Result<f64> {
    if value.is_finite() {
        Ok(value)
    } else {
        Err(Error::NotFinite { name, value })
    }
}

/// Returns the time if it is finite and the phase is known there.
pub(crate) fn known(t: f64, latest: f64) -> Result<f64> {
    if finite("t", t)?.abs() <= latest {
        Ok(t)
    } else {
        Err(Error::PhaseLost { t, latest })
    }
}

/// Returns `value` if it is finite and greater than zero.
///
/// # Errors
/// [`Error::NotFinite`] or [`Error::OutOfRange`], with this name, if it is not.
pub fn positive(name: &'static str, value: f64) -> Result<f64> {
    finite(name, value)?;
    if value > 0.0 {
        Ok(value)
    } else {
        Err(Error::OutOfRange {
            name,
            value,
            allowed: "it must be greater than 0",
        })
    }
}

/// Returns `value` if it is finite and not less than zero.
///
/// # Errors
/// As [`positive`].
pub fn not_negative(name: &'static str, value: f64) -> Result<f64> {
    finite(name, value)?;
    if value >= 0.0 {
        Ok(value)
    } else {
        Err(Error::OutOfRange {
            name,
            value,
            allowed: "it must not be negative",
        })
    }
}
