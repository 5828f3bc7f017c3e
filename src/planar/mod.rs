//! Scenes that move through phases: contacts that let go, gaps that close,
//! friction that stops.
//!
//! Between two such events the motion is smooth; at them the equations change.
//! A scene says which equations hold in which [phase](Phased::Phase) and under
//! which [`Condition`]s the phase lasts: a contact that must push, a gap that must
//! stay open. [`simulate`] integrates each phase with
//! [`Dop853`](crate::integrators::Dop853), locates the
//! moment when the first condition fails, and enters the next phase there.
//!
//! | item | what it is |
//! |---|---|
//! | [`Phased`] | a scene: phases, equations, conditions |
//! | [`Condition`], [`Next`] | what a phase needs, and what follows when it fails |
//! | [`simulate`], [`Run`] | the motion, with its events, from phase to phase |
//! | [`simulate_so_far`] | the motion up to where it is refused |
//! | [`simulate_within`] | the motion with a bound on the error at every event and at the end |
//! | [`Bilateral`] | the same scene with contacts that may pull: the usual mistake |
//!
//! Where several contacts act at once and rub, which of them do what is itself a problem to
//! be solved: [`contact`].
//!
//! Not for: rotation in three dimensions ([`crate::scene`]).

mod as_motion;
mod bilateral;
pub mod contact;
mod error_control;
mod run;

use crate::error::Result;

pub use as_motion::Moment;
pub use bilateral::Bilateral;
pub use error_control::{Delivered, simulate_within};
pub use run::{PhaseRun, Rest, Run, Transition, simulate, simulate_so_far};

/// A scene with `N` coordinates and velocities that moves through phases.
///
/// The equations must not depend on time; a scene that is driven carries its
/// clock as a coordinate.
///
/// ```
/// use rotation_dynamics::integrators::{Dop853, size_or};
/// use rotation_dynamics::planar::{Condition, Next, Phased, simulate};
///
/// /// A ball dropped on a floor, from which it rebounds with half its speed.
/// struct Ball;
/// impl Phased<2> for Ball {
///     type Phase = ();
///     fn derivative(&self, _: (), [_, speed]: &[f64; 2]) -> [f64; 2] {
///         [*speed, -10.0]
///     }
///     fn conditions(&self, _: ()) -> Vec<Condition<'_, (), 2>> {
///         let rebound = Next::jump((), |[_, speed]: &[f64; 2]| [0.0, -0.5 * speed]);
///         vec![Condition::gap("height", |y| y[0], rebound)]
///     }
///     fn scale(&self, y: &[f64; 2]) -> [f64; 2] {
///         size_or([1.0; 2])(y)
///     }
/// }
/// # fn main() -> rotation_dynamics::Result<()> {
/// let run = simulate(&Ball, &Dop853::new(1e-12)?, (), [5.0, 0.0], 1.5)?;
/// let bounce = run.transition("height")?;
/// assert!((bounce.t - 1.0).abs() < 1e-14);
/// assert_eq!(bounce.after, [0.0, -0.5 * bounce.before[1]]);
/// # Ok(())
/// # }
/// ```
pub trait Phased<const N: usize> {
    /// The type that tells the phases apart.
    type Phase: Copy + PartialEq + core::fmt::Debug;

    /// The rates of coordinates and velocities in `phase`.
    fn derivative(&self, phase: Self::Phase, state: &[f64; N]) -> [f64; N];

    /// Under which conditions `phase` lasts; none if it lasts for ever.
    fn conditions(&self, phase: Self::Phase) -> Vec<Condition<'_, Self::Phase, N>>;

    /// The size against which errors count, as [`crate::integrators::Ode::scale`].
    fn scale(&self, state: &[f64; N]) -> [f64; N];

    /// How far a state is off what `phase` keeps, such as a shut gap, as
    /// [`crate::integrators::Ode::drift`].
    fn drift(&self, _phase: Self::Phase, _state: &[f64; N], _within: f64) -> Option<[f64; N]> {
        None
    }

    /// After how many changes of phase a run is refused: 1000 unless the scene says otherwise.
    fn phase_limit(&self) -> usize {
        1000
    }
}

impl<const N: usize, S: Phased<N> + ?Sized> Phased<N> for &S {
    type Phase = S::Phase;
    fn derivative(&self, phase: S::Phase, state: &[f64; N]) -> [f64; N] {
        (**self).derivative(phase, state)
    }
    fn conditions(&self, phase: S::Phase) -> Vec<Condition<'_, S::Phase, N>> {
        (**self).conditions(phase)
    }
    fn scale(&self, state: &[f64; N]) -> [f64; N] {
        (**self).scale(state)
    }
    fn drift(&self, phase: S::Phase, state: &[f64; N], within: f64) -> Option<[f64; N]> {
        (**self).drift(phase, state, within)
    }
    fn phase_limit(&self) -> usize {
        (**self).phase_limit()
    }
}

/// Something that must not be negative while a phase lasts.
pub struct Condition<'s, P, const N: usize> {
    name: &'static str,
    kind: Kind,
    margin: Margin<'s, N>,
    next: Next<'s, P, N>,
    /// The round-off of the margin, where the scene itself decides whether it holds at entry.
    noise: Option<Margin<'s, N>>,
    /// Whether a change of sign within a few times that is none.
    flickers: bool,
}

/// A function of the state.
type Margin<'s, const N: usize> = Box<dyn Fn(&[f64; N]) -> f64 + 's>;

/// How a condition behaves where its phase begins, and its meaning.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    /// The force of a contact that can push and not pull.
    Contact,
    /// The distance of things that cannot pass through one another, or anything
    /// else that must hold.
    Gap,
    /// A gap that is shut where the phase begins, and opens.
    Opening,
}

impl<'s, P, const N: usize> Condition<'s, P, N> {
    /// The contact pushes with `force`; when it would have to pull, `next` follows.
    pub fn contact(
        name: &'static str,
        force: impl Fn(&[f64; N]) -> f64 + 's,
        next: Next<'s, P, N>,
    ) -> Self {
        Self::new(name, Kind::Contact, force, next)
    }

    /// The `gap` stays open; when it closes, `next` follows. (Also for anything
    /// else that must not become negative, such as a sliding speed.)
    pub fn gap(
        name: &'static str,
        gap: impl Fn(&[f64; N]) -> f64 + 's,
        next: Next<'s, P, N>,
    ) -> Self {
        Self::new(name, Kind::Gap, gap, next)
    }

    /// The `gap` is shut at the beginning of the phase (its sign is round-off there),
    /// opens, and stays open; when it closes again, `next` follows.
    pub fn opening_gap(
        name: &'static str,
        gap: impl Fn(&[f64; N]) -> f64 + 's,
        next: Next<'s, P, N>,
    ) -> Self {
        Self::new(name, Kind::Opening, gap, next)
    }

    fn new(
        name: &'static str,
        kind: Kind,
        margin: impl Fn(&[f64; N]) -> f64 + 's,
        next: Next<'s, P, N>,
    ) -> Self {
        Self { name, kind, margin: Box::new(margin), next, noise: None, flickers: false }
    }

    /// The scene has decided that the condition holds at entry, where its sign may be
    /// round-off; anywhere a margin below zero by no more than `noise` is none.
    fn decided(self, noise: impl Fn(&[f64; N]) -> f64 + 's) -> Self {
        Self { noise: Some(Box::new(noise)), ..self }
    }

    /// The same of a margin that may leave zero so slowly that its sign is round-off for a while.
    fn flickering(self, noise: impl Fn(&[f64; N]) -> f64 + 's) -> Self {
        Self { flickers: true, ..self.decided(noise) }
    }

    /// Its name, which is also the name of the event when it fails.
    pub fn name(&self) -> &'static str {
        self.name
    }
}

/// The next step when a condition fails.
pub enum Next<'s, P, const N: usize> {
    /// This phase, with the state as it is.
    Enter(P),
    /// This phase, with the state that an impact leaves.
    Jump(P, Impact<'s, N>),
    /// The decision of the scene from time and state: phase and state after.
    Decide(Decision<'s, P, N>),
    /// Nothing: the scene ends.
    End,
}

/// Phase and state that follow, from the time and the state before.
type Decision<'s, P, const N: usize> = Box<dyn Fn(f64, &[f64; N]) -> Result<Entry<P, N>> + 's>;

/// How a phase begins.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Entry<P, const N: usize> {
    /// The phase.
    pub phase: P,
    /// The state.
    pub state: [f64; N],
    /// The infinitely many bounces that the phase replaces, if it does.
    pub rest: Option<Rest>,
}

impl<P, const N: usize> From<(P, [f64; N])> for Entry<P, N> {
    fn from((phase, state): (P, [f64; N])) -> Self {
        let rest = None;
        Self { phase, state, rest }
    }
}

/// The state after an impact as a function of the state before.
type Impact<'s, const N: usize> = Box<dyn Fn(&[f64; N]) -> [f64; N] + 's>;

impl<'s, P, const N: usize> Next<'s, P, N> {
    /// The phase `phase` after an impact that changes the state by `impact`.
    pub fn jump(phase: P, impact: impl Fn(&[f64; N]) -> [f64; N] + 's) -> Self {
        Self::Jump(phase, Box::new(impact))
    }

    /// The phase and the state that `decision` finds: a pair of them, or an [`Entry`].
    pub fn decide<E: Into<Entry<P, N>>>(
        decision: impl Fn(f64, &[f64; N]) -> Result<E> + 's,
    ) -> Self {
        Self::Decide(Box::new(move |t, state| Ok(decision(t, state)?.into())))
    }
}
