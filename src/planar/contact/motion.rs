//! The motion of a mechanism, with the events and forces of its contacts.

use super::declare::{MechanismState, Mode, Press};
use super::modal::{Modal, entry};
use super::{Force, Mechanism, Modes};
use crate::accuracy::larger;
use crate::error::{Error, Result};
use crate::integrators::{Dop853, Work};
use crate::math::sort_by_number;
use crate::planar::run::whole;
use crate::planar::{Bilateral, Rest, Run, Transition, simulate_so_far, simulate_within};
use core::fmt;

/// Something that happened to a contact, or the end of the scene.
#[derive(Debug, Clone, PartialEq)]
pub struct ContactEvent<const N: usize, const C: usize> {
    /// The name of the contact and its change: "floor touches", "floor bounces", "floor rests",
    /// "floor sticks", "floor slips", "floor reverses", "floor lets go". For a [rolling
    /// resistance](super::Contact::rolling) it is "wheel stops", "wheel starts", "wheel reverses";
    /// at the end, the name of the end. "sticks" is the end of a slip in contact: a slip that ends
    /// within an impact has no event of its own, and [`ContactMotion::modes`] tell what follows.
    pub name: String,
    /// When.
    pub t: f64,
    /// Just before.
    pub before: MechanismState<N>,
    /// Just after; other velocities if there was an impact.
    pub after: MechanismState<N>,
    /// The forces just before.
    pub force: [Force; C],
}

/// A motion through modes.
///
/// A body that bounces ever lower rests after infinitely many bounces. The first that is no higher
/// than 1e-12 of the size of its gap ([`Mechanism::scale`]) is the event "floor touches". All that
/// follow are taken together with it; "floor rests" is the event at the time when they are over.
/// (An impact that does not bounce, as with the restitution 0, is "floor touches" alone.) A body
/// with the restitution e leaves this impact at `t` with the speed u and is brought back by the
/// acceleration a. For it that time is
///
/// ```text
/// t + 2 u/(a (1 - e)).
/// ```
///
/// Between the two the velocity is not resolved: the given velocity is for a body that rests
/// on the contact already. The true one is within u of it, some 4e-6 m/s for a gap of the size 1 m.
/// From then on state and forces are as accurate as elsewhere, but for 1e-12 of the size of the
/// gap. A run that ends between the two is refused.
///
/// Accuracy: the state after to 16 eps, whatever bounced and slipped before. The time of rest to
/// 1e-13 of itself where the coordinate is the gap, for e up to 0.99. For a ball of 0.1 m, whose
/// height is rounded to its own digits, it is to 1.4e-11 (9e-11 in 400 throws from 1 mm to 10 m),
/// and for one of 1 m to 2.1e-9. Where contacts hit in turn and keep the same part of the speed
/// each time, as the corners of a rocking block, to 1e-9 s; for a rod whose ends rattle, to 2.4e-15
/// s (`tests/planar/rest.rs`). Where contacts hit in turn to the end and the part changes from hit
/// to hit, it may be off by some of the last 1e-6 s. [`motion_within`] refuses an error below that
/// to which the times are rounded.
///
/// ```
/// use rotation_dynamics::planar::contact::{Contact, Mechanism, MechanismState, motion_within};
///
/// /// A ball that is dropped, and returns half of its speed; g = 10 m/s^2.
/// struct Ball;
/// impl Mechanism<1, 1> for Ball {
///     fn mass(&self, _: &[f64; 1]) -> [[f64; 1]; 1] {
///         [[1.0]]
///     }
///     fn force(&self, _: &MechanismState<1>) -> [f64; 1] {
///         [-10.0]
///     }
///     fn contacts(&self, ball: &MechanismState<1>) -> [Contact<1>; 1] {
///         [Contact::new("floor", ball.q[0], [1.0], 0.0).restitution(0.5)]
///     }
/// }
/// # fn main() -> rotation_dynamics::Result<()> {
/// let motion = motion_within(&Ball, 1e-12, MechanismState::rest([5.0]), 4.0)?;
/// // sqrt(2 h/g) (1 + e)/(1 - e)
/// assert!((motion.event("floor rests")?.t - 3.0).abs() < 1e-14);
/// assert_eq!(motion.at(4.0)?, MechanismState::rest([0.0]));
/// # Ok(())
/// # }
/// ```
pub struct ContactMotion<M, const N: usize, const C: usize> {
    mechanism: M,
    done: Done<N, C>,
}

/// The part of a motion that is known beside its mechanism.
pub struct Done<const N: usize, const C: usize> {
    run: Box<dyn AnyRun<N, C>>,
    events: Vec<ContactEvent<N, C>>,
    estimate: Option<f64>,
    work: Work,
}

/// A run, however many numbers its states have.
trait AnyRun<const N: usize, const C: usize>: Send + Sync {
    fn end_time(&self) -> f64;
    fn at(&self, t: f64) -> Result<(Modes<C>, MechanismState<N>)>;
    /// Shows what is at the ends of its steps.
    fn steps(&self, see: &mut dyn FnMut(&Modes<C>, &MechanismState<N>)) -> Result<()>;
}

impl<const N: usize, const S: usize, const C: usize> AnyRun<N, C> for Run<Modes<C>, S> {
    fn end_time(&self) -> f64 {
        self.end_time()
    }

    fn at(&self, t: f64) -> Result<(Modes<C>, MechanismState<N>)> {
        let (modes, numbers) = self.at(t)?;
        Ok((modes, MechanismState::from_array(&numbers)))
    }

    fn steps(&self, see: &mut dyn FnMut(&Modes<C>, &MechanismState<N>)) -> Result<()> {
        for piece in self.pieces() {
            for t in piece.solution.step_times() {
                let numbers = piece.solution.at(t)?;
                see(&piece.phase, &MechanismState::from_array(&numbers));
            }
        }
        Ok(())
    }
}

/// Marks a number of coordinates.
#[derive(Debug, Clone, Copy)]
pub struct Coordinates<const N: usize>;

/// Of how many coordinates motions can be solved: 1 to 14.
///
/// A state has 2 N numbers, which Rust cannot say of every N.
pub trait Solvable<const N: usize> {
    /// The motion as far as it goes, and the refusal that ended it.
    #[doc(hidden)]
    fn solved<const C: usize>(
        mechanism: &AnyMechanism<'_, N, C>,
        how: How<'_>,
        start: MechanismState<N>,
        t_end: f64,
    ) -> (Done<N, C>, Option<Error>);
}

macro_rules! solvable {
    ($($coordinates:literal)+) => { $(
        impl Solvable<$coordinates> for Coordinates<$coordinates> {
            fn solved<const C: usize>(
                mechanism: &AnyMechanism<'_, $coordinates, C>,
                how: How<'_>,
                start: MechanismState<$coordinates>,
                t_end: f64,
            ) -> (Done<$coordinates, C>, Option<Error>) {
                solved::<$coordinates, { 2 * $coordinates }, C>(mechanism, how, start, t_end)
            }
        }
    )+ };
}

solvable!(1 2 3 4 5 6 7 8 9 10 11 12 13 14);

/// A mechanism of any type: the code that solves it is compiled once for all of its size.
type AnyMechanism<'m, const N: usize, const C: usize> = dyn Mechanism<N, C> + 'm;

/// How a motion is solved.
pub enum How<'h> {
    By(&'h Dop853),
    Within(f64),
    KeptWithin(f64),
}

impl<M, const N: usize, const C: usize> fmt::Debug for ContactMotion<M, N, C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("ContactMotion")
            .field("end_time", &self.done.run.end_time())
            .field("events", &self.done.events)
            .finish_non_exhaustive()
    }
}

/// The motion of `mechanism` from `start` at time 0 to `t_end`, by `method`.
///
/// # Errors
/// Those of [`entry`], at the start or where the modes change, and of
/// [`simulate`](crate::planar::simulate). [`motion_so_far`] has the motion up to there.
pub fn motion<M: Mechanism<N, C>, const N: usize, const C: usize>(
    mechanism: M,
    method: &Dop853,
    start: MechanismState<N>,
    t_end: f64,
) -> Result<ContactMotion<M, N, C>>
where
    Coordinates<N>: Solvable<N>,
{
    whole(told(mechanism, How::By(method), start, t_end))
}

/// The motion as [`motion`] has it, as far as it goes, and the refusal that ended it, if one did.
///
/// The error of the part is not estimated: [`motion_within`] up to a time within it does that. A start
/// that is refused leaves no state at all.
pub fn motion_so_far<M: Mechanism<N, C>, const N: usize, const C: usize>(
    mechanism: M,
    method: &Dop853,
    start: MechanismState<N>,
    t_end: f64,
) -> (ContactMotion<M, N, C>, Option<Error>)
where
    Coordinates<N>: Solvable<N>,
{
    told(mechanism, How::By(method), start, t_end)
}

fn told<M: Mechanism<N, C>, const N: usize, const C: usize>(
    mechanism: M,
    how: How<'_>,
    start: MechanismState<N>,
    t_end: f64,
) -> (ContactMotion<M, N, C>, Option<Error>)
where
    Coordinates<N>: Solvable<N>,
{
    let (done, refused) = Coordinates::<N>::solved(&mechanism, how, start, t_end);
    (ContactMotion { mechanism, done }, refused)
}

/// The same with an error of at most `tolerance` at every event and at the end, as
/// [`simulate_within`] measures it.
///
/// # Errors
/// Those of [`motion`] and of [`simulate_within`].
pub fn motion_within<M: Mechanism<N, C>, const N: usize, const C: usize>(
    mechanism: M,
    tolerance: f64,
    start: MechanismState<N>,
    t_end: f64,
) -> Result<ContactMotion<M, N, C>>
where
    Coordinates<N>: Solvable<N>,
{
    whole(told(mechanism, How::Within(tolerance), start, t_end))
}

/// The same with contacts that never let go and pull instead: the usual mistake.
///
/// # Errors
/// Those of [`motion_within`].
pub fn kept_within<M: Mechanism<N, C>, const N: usize, const C: usize>(
    mechanism: M,
    tolerance: f64,
    start: MechanismState<N>,
    t_end: f64,
) -> Result<ContactMotion<M, N, C>>
where
    Coordinates<N>: Solvable<N>,
{
    whole(told(mechanism, How::KeptWithin(tolerance), start, t_end))
}

fn solved<const N: usize, const S: usize, const C: usize>(
    mechanism: &AnyMechanism<'_, N, C>,
    how: How<'_>,
    start: MechanismState<N>,
    t_end: f64,
) -> (Done<N, C>, Option<Error>) {
    let done = |run| Done::new::<S>(mechanism, run);
    let refused = |error| (done(Run::empty()), Some(error));
    let scene = Modal(mechanism);
    let (modes, state) = match entry(&mechanism, start) {
        Ok((modes, state)) => (modes, state.to_array()),
        Err(error) => return refused(error),
    };
    let within = match how {
        How::By(method) => {
            let (run, refused) = simulate_so_far(&scene, method, modes, state, t_end);
            return (done(run), refused);
        }
        How::Within(tolerance) => simulate_within(&scene, tolerance, modes, state, t_end),
        How::KeptWithin(tolerance) => {
            simulate_within(&Bilateral(&scene), tolerance, modes, state, t_end)
        }
    };
    match within {
        Ok(within) => {
            let mut done = done(within.run);
            (done.estimate, done.work) = (Some(within.estimate), within.work);
            (done, None)
        }
        Err(error) => refused(error),
    }
}

impl<const N: usize, const C: usize> Done<N, C> {
    fn new<const S: usize>(mechanism: &AnyMechanism<'_, N, C>, run: Run<Modes<C>, S>) -> Self {
        let transitions = run.transitions().iter();
        let changes = transitions.clone().flat_map(|at| events(mechanism, at));
        let rests = transitions.filter_map(|at| rests(mechanism, &run, at.rest?));
        let mut events: Vec<_> = changes.chain(rests).collect();
        sort_by_number(&mut events, |event| event.t);
        Self { events, estimate: None, work: run.work(), run: Box::new(run) }
    }

    fn drift(&self, mechanism: &AnyMechanism<'_, N, C>) -> Result<(f64, f64)> {
        let (mut gap, mut slip) = (0.0, 0.0);
        self.run.steps(&mut |modes, state| {
            for (contact, mode) in mechanism.contacts(state).iter().zip(modes) {
                if *mode != Mode::Open {
                    gap = larger(gap, contact.gap.abs());
                }
                if *mode == Mode::Stick {
                    slip = larger(slip, contact.tangent.speed(&state.v).abs());
                }
            }
        })?;
        Ok((gap, slip))
    }
}

impl<M: Mechanism<N, C>, const N: usize, const C: usize> ContactMotion<M, N, C> {
    /// The events, in order.
    pub fn events(&self) -> &[ContactEvent<N, C>] {
        &self.done.events
    }

    /// The first event with this name.
    ///
    /// # Errors
    /// [`Error::NotReached`] if there was none.
    pub fn event(&self, name: &'static str) -> Result<&ContactEvent<N, C>> {
        let until = self.end_time();
        let found = self.done.events.iter().find(|event| event.name == name);
        found.ok_or(Error::NotReached { name, until })
    }

    /// When the run ended.
    pub fn end_time(&self) -> f64 {
        self.done.run.end_time()
    }

    /// The state at `t`; at an event, that before it.
    ///
    /// # Errors
    /// [`Error::OutsideRun`] for a time before the start or after the end.
    pub fn at(&self, t: f64) -> Result<MechanismState<N>> {
        Ok(self.done.run.at(t)?.1)
    }

    /// The mode of each contact at `t`; at an event, the mode before.
    ///
    /// # Errors
    /// Those of [`at`](Self::at).
    pub fn modes(&self, t: f64) -> Result<Modes<C>> {
        Ok(self.done.run.at(t)?.0)
    }

    /// The force of each contact at `t`; at an event, that before it.
    ///
    /// # Errors
    /// Those of [`at`](Self::at).
    pub fn forces(&self, t: f64) -> Result<[Force; C]> {
        let (modes, state) = self.done.run.at(t)?;
        Ok(Modal(&self.mechanism as &AnyMechanism<'_, N, C>).forces(&modes, &state))
    }

    /// How far the integration has drifted off the contacts, at most, at the ends of its steps: the
    /// largest gap of a shut contact and the largest slip speed of a sticking one. Beyond a tenth
    /// of the error of a step it is put back.
    ///
    /// # Errors
    /// None that the run has not met before.
    pub fn drift(&self) -> Result<(f64, f64)> {
        self.done.drift(&self.mechanism)
    }

    /// The estimate of the error, where one was asked for.
    pub fn estimate(&self) -> Option<f64> {
        self.done.estimate
    }

    /// The cost of all of it.
    pub fn work(&self) -> Work {
        self.done.work
    }
}

/// The change of the contacts at a change of modes.
fn events<const N: usize, const S: usize, const C: usize>(
    mechanism: &AnyMechanism<'_, N, C>,
    at: &Transition<Modes<C>, S>,
) -> Vec<ContactEvent<N, C>> {
    let [before, after] = [&at.before, &at.after].map(MechanismState::from_array);
    let event = |name| ContactEvent {
        name,
        t: at.t,
        before,
        after,
        force: Modal(mechanism).forces(&at.from, &before),
    };
    let Some(to) = at.to else {
        return vec![event(at.name.into())];
    };
    let contacts = mechanism.contacts(&after);
    let did = (0..C).filter_map(|i| {
        let name = contacts[i].name;
        let rides = matches!(contacts[i].press, Press::By(_));
        let what = match (at.from[i], to[i]) {
            // What presses it is said of the contact that does.
            (Mode::Open, _) | (_, Mode::Open) if rides => return None,
            (a, b) if rides && a != b => match (a, b) {
                (_, Mode::Stick) => "stops",
                (Mode::Stick, _) => "starts",
                _ => "reverses",
            },
            (Mode::Open, Mode::Open) if at.name == name => "bounces",
            (a, b) if a == b => return None,
            (Mode::Open, _) => "touches",
            (_, Mode::Open) => "lets go",
            (_, Mode::Stick) => "sticks",
            (Mode::Stick, _) => "slips",
            _ => "reverses",
        };
        Some(event(format!("{name} {what}")))
    });
    did.collect()
}

/// The event that the bounces of a contact are over, if the run goes on to it and the contact is shut
/// there.
fn rests<const N: usize, const C: usize>(
    mechanism: &AnyMechanism<'_, N, C>,
    run: &dyn AnyRun<N, C>,
    Rest { contact, t, .. }: Rest,
) -> Option<ContactEvent<N, C>> {
    let (modes, state) = run.at(t).ok()?;
    let contacts = mechanism.contacts(&state);
    let mut contacts = contacts.iter().zip(modes);
    let shut = contacts.any(|(c, mode)| c.name == contact && mode != Mode::Open);
    shut.then(|| ContactEvent {
        name: format!("{contact} rests"),
        t,
        before: state,
        after: state,
        force: Modal(mechanism).forces(&modes, &state),
    })
}
