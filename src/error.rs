//! The one error type of the library.
//!
//! A variant is a kind of fault that a caller may want to handle in one way. It carries the numbers
//! that offend; its message says what is allowed, so that a user can act on it without reading code.
//! Times are in s, angles and errors of an attitude in rad, unless the scene has units of its own.

use core::f64::consts::PI;
use core::fmt;
use std::borrow::Cow;

/// The kinds of faults, with the numbers that went wrong.
///
/// An error that doubles cannot deliver is refused with the best that they can:
///
/// ```
/// use rotation_dynamics::attitude::Attitude;
/// use rotation_dynamics::body::{RigidBody, State};
/// use rotation_dynamics::frame::SpaceVector;
/// use rotation_dynamics::inertia::PrincipalMoments;
/// use rotation_dynamics::{Error, scene::Scene};
/// # fn main() -> rotation_dynamics::Result<()> {
/// let scene = Scene::new(RigidBody::new(PrincipalMoments::new(1.0, 2.0, 2.5)?));
/// let start = State::new(Attitude::IDENTITY, SpaceVector::new(0.8, 0.4, 0.3))?;
/// let solved = match scene.solve(&start, 1e5, 1e-14) {
///     Err(Error::NotDelivered { best, .. }) if best < 1e-6 => scene.solve(&start, 1e5, best),
///     solved => solved,
/// };
/// assert!((1e-14..1e-6).contains(&solved?.estimate));
/// # Ok(())
/// # }
/// ```
/// In all of them `name` is that of an input, an event or a contact, `value` is its value, `t` is a
/// time and `allowed` is what would be allowed.
#[non_exhaustive]
#[derive(Debug, Clone, PartialEq)]
#[expect(missing_docs, reason = "the line of a variant names its fields")]
pub enum Error {
    /// An input is NaN or infinite.
    NotFinite { name: &'static str, value: f64 },
    /// An input is outside the range in which it has a meaning: `allowed` names that range.
    OutOfRange { name: &'static str, value: f64, allowed: Cow<'static, str> },
    /// Two lists that belong together have different lengths.
    Lengths { name: &'static str, found: usize, expected: usize },
    /// One entry of a list is refused.
    AtIndex { name: &'static str, index: usize, reason: Box<Error> },
    /// A torque, force, derivative, event or mass matrix has a value that is not allowed (mostly NaN
    /// or infinity) at a time and a state, whose numbers are these `variables`.
    FunctionOutOfRange {
        what: String,
        t: f64,
        variables: &'static str,
        state: Vec<f64>,
        value: Vec<f64>,
        allowed: Cow<'static, str>,
    },
    /// An effect's torque is `off` its own `claim`, by more than is `allowed`: in a state of the motion,
    /// or at a `probe` of another attitude and momentum at the time `t`.
    Contradiction {
        effect: String,
        claim: &'static str,
        t: f64,
        probe: bool,
        off: f64,
        allowed: f64,
    },
    /// A declared law drives the motion back from both sides of the surface where it switches: the motion
    /// slides along that surface.
    Sliding { effect: String, t: f64 },
    /// Runs take more than this `limit` of torques, and effects are not called smooth and name no narrowest
    /// feature. The torque was looked at every `every` seconds.
    Undeclared { effect: String, requested: f64, every: f64, limit: u64 },
    /// The scene, the method or the start does not allow these effects.
    Incompatible { effects: String, reason: Cow<'static, str> },
    /// The way to `t_end` takes more "torques" (from `t` on), or more "steps" or "changes of phase"
    /// (by `t`), than the limit.
    LimitReached { what: &'static str, t: f64, t_end: f64, limit: u64 },
    /// The caller cancelled the solution.
    Cancelled { torques: u64 },
    /// No step is short enough for the tolerance; or none that doubles can add to `t`, where they are
    /// the time `clock` (s) apart.
    StepUnderflow { t: f64, step: f64, clock: Option<f64>, state: Vec<f64> },
    /// The equations for the stages of an implicit step (of the length `h`, in s) do not converge.
    NoConvergence { t: f64, h: f64, change: f64 },
    /// The time is so late or so early that its last bit leaves the phase of the motion open.
    PhaseLost { t: f64, latest: f64 },
    /// The solution is not known at this time.
    OutsideRun { t: f64, start: f64, end: f64 },
    /// A 3x3 matrix is not a rotation: R^T R differs from 1, or R is a reflection.
    NotRotation { deviation: f64, determinant: f64 },
    /// Two of three turns are about one line, and the rates of the angles are not defined.
    GimbalLock { sequence: &'static str, angle: f64, locked: &'static str },
    /// No body that turns freely has these moments (kg m^2). One exceeds the sum of the other two
    /// by `excess`, or they belong to a rod or point mass (`excess` = 0); rounding explains
    /// `slack`.
    NotABody { moments: [f64; 3], excess: f64, slack: f64 },
    /// A contact or phase begins whose own condition does not hold: its `value` is negative, or the
    /// `rate` (per s) of a contact's gap.
    CannotHold { name: &'static str, t: f64, value: f64, rate: Option<f64> },
    /// Dry friction and one-sided contacts allow no motion from here, or more than one (Painlevé).
    ContactsUndetermined { t: f64, state: Vec<f64>, tried: usize, motions: Vec<String> },
    /// An impact with restitution and friction would end with more energy (J).
    ImpactGainsEnergy { t: f64, before: f64, after: f64 },
    /// The run ends between `t` and `until`, while infinitely many bounces go on, too low (m) to be
    /// told from rest.
    BouncesUnresolved { contact: &'static str, height: f64, t: f64, until: f64 },
    /// An event did not come.
    NotReached { name: &'static str, until: f64 },
    /// The condition of a motion is not known, because its inputs are not.
    ConditionUnknown { name: &'static str },
    /// The error that was requested cannot be delivered. `best`: the error that was reached; with a
    /// `condition`, the error that the inputs, as doubles, allow (half a turn or more: none).
    NotDelivered { requested: f64, best: f64, condition: Option<f64> },
}

/// `Result` with this crate's [`Error`].
pub type Result<T> = core::result::Result<T, Error>;

impl Error {
    /// [`Error::OutOfRange`] of these.
    pub fn out_of_range(
        name: &'static str,
        value: f64,
        allowed: impl Into<Cow<'static, str>>,
    ) -> Self {
        let allowed = allowed.into();
        Self::OutOfRange { name, value, allowed }
    }

    /// [`Error::FunctionOutOfRange`] at a state with these variables.
    pub(crate) fn of_function(
        what: impl Into<String>,
        t: f64,
        (variables, state): (&'static str, Vec<f64>),
        value: &[f64],
        allowed: impl Into<Cow<'static, str>>,
    ) -> Self {
        Self::FunctionOutOfRange {
            what: what.into(),
            t,
            variables,
            state,
            value: value.to_vec(),
            allowed: allowed.into(),
        }
    }

    /// An effect that sees more than the body's axis, where only the axis is carried.
    pub(crate) fn sees_more(effects: String) -> Self {
        let reason = format!(
            "splittings, and variables other than those in space, see the body's axis only: \
             an effect that sees more ({effects}) is not allowed there"
        );
        Self::incompatible(effects, reason)
    }

    pub(crate) fn incompatible(effects: String, reason: impl Into<Cow<'static, str>>) -> Self {
        let reason = reason.into();
        Self::Incompatible { effects, reason }
    }

    /// [`Error::Incompatible`]: what was recorded, with a pendulum; for this reason.
    pub(crate) fn no_swing(reason: impl Into<Cow<'static, str>>) -> Self {
        Self::Incompatible { effects: "a pendulum".into(), reason: reason.into() }
    }

    /// Two weights on one body.
    pub(crate) fn two_gravities(effects: String) -> Self {
        let reason = format!(
            "gravity acts twice in this scene ({effects}): one weight at one place is allowed"
        );
        Self::incompatible(effects, reason)
    }

    /// The entry of a list that does not come after the one before it.
    pub(crate) fn not_rising(name: &'static str, index: usize, before: f64, value: f64) -> Self {
        let allowed = format!("the one before it is {}, and they must rise", plain(before));
        Self::at_index(name, index, Self::out_of_range("value", value, allowed))
    }

    /// [`Error::AtIndex`] of these.
    pub(crate) fn at_index(name: &'static str, index: usize, reason: Self) -> Self {
        Self::AtIndex { name, index, reason: Box::new(reason) }
    }

    /// A contradiction found at a probe.
    pub(crate) fn probed(mut self) -> Self {
        if let Self::Contradiction { probe, .. } = &mut self {
            *probe = true;
        }
        self
    }
}

/// The messages as a table: a variant with the fields that its message needs, and the message.
macro_rules! messages {
    ($error:ident, $f:ident; $(
        $variant:ident { $($field:tt)* } $(if $when:expr)? => $text:literal $(, $part:expr)*;
    )*) => {
        match $error {
            $(Self::$variant { $($field)* } $(if $when)? => write!($f, $text $(, $part)*),)*
        }
    };
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let n = |value: &f64| plain(*value);
        messages! { self, f;
            NotFinite { name, value } => "{name} = {} is not a finite number", n(value);
            OutOfRange { name, value, allowed } => "{name} = {} is not allowed: {allowed}", n(value);
            Lengths { name, found, expected } =>
                "{name}: {found} given where there must be {expected}";
            AtIndex { name, index, reason } => "{name}[{index}]: {reason}";
            FunctionOutOfRange { what, t, variables, state, value, allowed } =>
                "the {what} at t = {}, {variables} = {state:?} is {value:?}; {allowed}", n(t);
            Contradiction { effect, claim, t, probe, off, .. } if off.is_nan() =>
                "\"{effect}\" says {claim}, and {} what it says is no number", place(*t, *probe);
            Contradiction { effect, claim, t, probe, off, allowed } =>
                "\"{effect}\" says {claim}, and {} its torque is off that by {off:.3e} \
                 (at most {} is allowed)", place(*t, *probe), brief(*allowed);
            Sliding { effect, t } =>
                "sliding motion at a jump of \"{effect}\" near t = {}: the torque drives the motion \
                 back from both sides of the surface where it switches; let it pass from one value to \
                 the other over a small width, as tanh does, give it hysteresis, sample it at a rate \
                 (`Torque::sampled`), or end the motion there", brief(*t);
            Undeclared { effect, requested, every, limit } =>
                "an error of {requested:e} takes more than the {limit} torques that are allowed: nothing \
                 says that the torque of \"{effect}\" is smooth, and it was looked at only every {} s; \
                 where it jumps or bends with the time, name its break points or its narrowest feature; \
                 where it jumps with the state, make it a switch (`Switched`), sample it at a rate \
                 (`Torque::sampled`), or let it pass from one value to the other over a small width, as \
                 tanh does; or allow more torques, a larger error or a shorter time", brief(*every);
            Incompatible { reason, .. } => "{reason}";
            LimitReached { what: "torques", t, t_end, limit } =>
                "from t = {} to {} this takes more than the {limit} torques that are allowed: \
                 allow more of them, a larger error, longer steps or a shorter time; \
                 or name the times at which a torque jumps or has a kink", n(t), n(t_end);
            LimitReached { what: "steps", t, t_end, limit } =>
                "after {limit} steps the run has come to t = {} of {}: \
                 allow more steps or a larger tolerance; no number of them does where the derivative \
                 jumps with y and drives it back from both sides", n(t), n(t_end);
            LimitReached { what, t, t_end, limit } =>
                "after {limit} {what} the run has come only to t = {} of {}: allow more of them \
                 (`phase_limit` of the scene), or end the run before", n(t), n(t_end);
            Cancelled { torques } => "cancelled, after {torques} torques";
            StepUnderflow { t, step, clock: Some(clock), .. } =>
                "at t = {} the clock is too coarse: it shows no time shorter than {clock:.1e}, and \
                 steps of {step:.1e} are needed; count the time from 0 at the start of the run",
                n(t);
            StepUnderflow { t, step, state, .. } =>
                "at t = {}, y = {state:?} even a step of {} misses the tolerance: \
                 the system is singular there, the derivative jumps, or the tolerance is too small",
                n(t), n(step);
            NoConvergence { t, h, change } =>
                "the stages of the step from t = {} by {} do not converge (the last sweep \
                 changed them by {change:.1e}): take more steps", n(t), n(h);
            PhaseLost { t, latest } =>
                "at t = {} the phase of the motion is lost: beyond {latest:.3e} the last bit of the \
                 time is a 32nd of a turn or more", n(t);
            OutsideRun { t, start, end } =>
                "t = {} is outside the run, which goes from {} to {}", n(t), n(start), n(end);
            NotRotation { deviation, determinant } if *determinant > 0.0 =>
                "the matrix is not a rotation: R^T R is off 1 by {deviation:.3e} (at most 1e-12 is \
                 allowed) and its determinant is {} (it must be +1); `Attitude::nearest` finds the \
                 rotation nearest to it, and says how far it is off", n(determinant);
            NotRotation { deviation, determinant } =>
                "the matrix is not a rotation: R^T R is off 1 by {deviation:.3e} (at most 1e-12 is \
                 allowed) and its determinant is {} (it must be +1, of right-handed axes)",
                n(determinant);
            GimbalLock { sequence, angle, locked } =>
                "second angle = {} of {sequence}: the first and the third turn are about the \
                 same line and their rates are not defined; it must not be {locked}", n(angle);
            NotABody { moments, excess, slack } if *excess > 0.0 =>
                "the moments of inertia ({}) belong to no body: none may exceed the sum \
                 of the other two, and the largest does by {} (rounding explains {})",
                moments.map(plain).join(", "), brief(*excess), brief(*slack);
            NotABody { moments, slack, .. } =>
                "the moments of inertia ({}) are those of a {}{}; a body that turns freely needs \
                 each greater than 0", moments.map(plain).join(", "), thin(moments), hidden(*slack);
            CannotHold { name, t, value, rate: Some(rate) } =>
                "\"{name}\" cannot hold at t = {}: its gap is {} and opens at {} a second; \
                 neither may be negative (a joint needs both to be 0, a force that presses \
                 must not be negative); an impact needs a start before it or after it", n(t), n(value), n(rate);
            CannotHold { name, t, value, .. } =>
                "at t = {} a phase begins in which \"{name}\" must not be negative, but it is {} or \
                 becomes so at once (a gap that is shut there and opens is an `opening_gap`)",
                n(t), n(value);
            ContactsUndetermined { t, state, tried, motions } if motions.is_empty() =>
                "at t = {}, coordinates and velocities {state:?}, no contact forces obey the laws \
                 of dry friction (Painlev\u{e9}): {tried} sets of modes were tried; less friction \
                 helps, or a unit of length in which lengths are near 1", n(t);
            ContactsUndetermined { t, state, motions, .. } =>
                "at t = {}, coordinates and velocities {state:?}, dry friction allows two motions \
                 (Painlev\u{e9}): {}", n(t), motions.join("; or ");
            ImpactGainsEnergy { t, before, after } =>
                "the impact at t = {} would raise the kinetic energy from {} to {}: Newton's \
                 restitution contradicts this friction; take a smaller one of the two",
                n(t), n(before), n(after);
            BouncesUnresolved { contact, height, t, until } if until.is_infinite() =>
                "from t = {} on the bounces of \"{contact}\" are {height:.1e} high, too low \
                 to be told from rest, and they never end: end the run before, or take a restitution below 1",
                n(t);
            BouncesUnresolved { contact, height, t, until } =>
                "the run ends between t = {} and t = {}, while \"{contact}\" bounces infinitely often, \
                 up to {height:.1e} high, and its speed is not known; end the run before or after", n(t), n(until);
            NotReached { name, until } => "\"{name}\" has not happened by t = {}", n(until);
            ConditionUnknown { name } =>
                "the condition of \"{name}\" is not known, because its inputs are not";
            NotDelivered { requested, best, condition: Some(_) } if best.is_nan() || *best >= PI =>
                "an error of {requested:e} rad is asked for, and nothing can be promised: as on a \
                 separatrix, a change of the inputs in their last digits leads to any other \
                 attitude at the end";
            NotDelivered { requested, best, condition: Some(times) } =>
                "an error of {requested:e} rad is asked for, and doubles allow {best:.1e} at best: \
                 a small relative change of the inputs is {} times as much (in rad) at the end",
                match times.abs() < 1e4 {
                    true => format!("{times:.0}"),
                    false => format!("{times:.1e}"),
                };
            NotDelivered { requested, best, .. } if best.is_finite() =>
                "an error of {requested:e} is asked for; best error reached: {best:.1e}";
            NotDelivered { requested, .. } =>
                "an error of {requested:e} is asked for, and finer and finer runs do not agree: what \
                 happens depends on digits that doubles do not have, or on features of a torque that \
                 nothing declares";
        }
    }
}

/// Where a claim was tried.
fn place(t: f64, probe: bool) -> String {
    match probe {
        true => format!("probed at t = {}, at another attitude and momentum,", plain(t)),
        false => format!("at t = {}", plain(t)),
    }
}

/// The object that has these moments, though it is no body that turns freely.
fn thin(moments: &[f64; 3]) -> &'static str {
    match moments.iter().any(|m| *m > 0.0) {
        true => "rod: it has no moment about its own axis",
        false => "point mass: it has no moment about any axis",
    }
}

fn hidden(slack: f64) -> String {
    match slack > 0.0 {
        true => format!(", or none above what rounding hides, {}", brief(slack)),
        false => String::new(),
    }
}

/// The condition on a function's value, as a rule.
pub(crate) const FINITE: &str = "it must be finite";

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
    if value.is_finite() { Ok(value) } else { Err(Error::NotFinite { name, value }) }
}

/// Checks that every entry of a list is finite.
pub(crate) fn all_finite(name: &'static str, values: &[f64]) -> Result<()> {
    match values.iter().position(|value| !value.is_finite()) {
        None => Ok(()),
        Some(index) => finite("value", values[index])
            .map(|_| ())
            .map_err(|reason| Error::at_index(name, index, reason)),
    }
}

/// Returns the time if it is finite and the phase is known there.
pub(crate) fn known(t: f64, latest: f64) -> Result<f64> {
    if finite("t", t)?.abs() <= latest { Ok(t) } else { Err(Error::PhaseLost { t, latest }) }
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
        Err(Error::out_of_range(name, value, "it must be greater than 0"))
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
        Err(Error::out_of_range(name, value, "it must not be negative"))
    }
}
