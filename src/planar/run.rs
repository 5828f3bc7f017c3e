//! The motion of a scene from phase to phase.

use super::{Condition, Entry, Kind, Next, Phased};
use crate::error::{Error, Result};
use crate::integrators::{Dop853, Event, Ode, Solution, Work};
use crate::math::EPS;
use core::fmt::Debug;

/// How often a phase is solved again with shorter steps.
const SHORTENINGS: u32 = 30;
/// Within so many times its round-off a margin that leaves zero slowly has no sign.
const FLICKER: f64 = 4.0;
/// A margin this much below zero, relative to its largest value, is round-off.
const ROUND_OFF: f64 = 1e-9;
/// Round-off of a state where a phase begins, in parts of its scale, and of the time.
const AT_ENTRY: f64 = 64.0 * EPS;

/// The motion within one phase.
#[derive(Debug, Clone)]
pub struct PhaseRun<P, const N: usize> {
    /// The phase.
    pub phase: P,
    /// The state at any time of the phase.
    pub solution: Solution<N>,
}

/// A change of phase, or the end of the scene.
#[derive(Debug, Clone, PartialEq)]
pub struct Transition<P, const N: usize> {
    /// The condition that failed.
    pub name: &'static str,
    /// When, located to the accuracy of the run.
    pub t: f64,
    /// The phase that ends.
    pub from: P,
    /// The phase that begins; `None` where the scene ends.
    pub to: Option<P>,
    /// The state in which the condition failed.
    pub before: [f64; N],
    /// The state with which the next phase begins; other than `before` after an impact.
    pub after: [f64; N],
    /// The infinitely many bounces that begin here, if they do.
    pub rest: Option<Rest>,
}

/// Infinitely many bounces that are too low to be resolved, taken as one plastic impact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rest {
    /// The contact that bounces.
    pub contact: &'static str,
    /// How high the first of them is (m).
    pub height: f64,
    /// When they are all over (s).
    pub t: f64,
}

/// A motion through phases.
#[derive(Debug, Clone)]
pub struct Run<P, const N: usize> {
    pieces: Vec<PhaseRun<P, N>>,
    transitions: Vec<Transition<P, N>>,
    work: Work,
}

/// A scene of any type: the code that runs it is compiled once for all with its phases.
pub(super) type Scene<'s, P, const N: usize> = dyn Phased<N, Phase = P> + 's;

/// A scene held in one phase.
struct InPhase<'s, P, const N: usize>(&'s Scene<'s, P, N>, P);

impl<P: Copy + PartialEq + Debug, const N: usize> Ode<N> for InPhase<'_, P, N> {
    fn derivative(&self, _t: f64, state: &[f64; N]) -> [f64; N] {
        self.0.derivative(self.1, state)
    }
    fn scale(&self, state: &[f64; N]) -> [f64; N] {
        self.0.scale(state)
    }
    fn drift(&self, _t: f64, state: &[f64; N], within: f64) -> Option<[f64; N]> {
        self.0.drift(self.1, state, within)
    }
}

/// The motion of `scene` from `start` in `phase`, from time 0 to `t_end` or to the end
/// of the scene. `t_end` may be negative where `phase` has no conditions.
///
/// Accuracy: the accuracy of `method`; events are located by real steps, as accurately as
/// the motion itself.
///
/// # Errors
/// [`Error::CannotHold`] if a phase begins although one of its conditions is negative by
/// more than round-off, or if one fails at once for the second time in an instant (the first time
/// it is an event), [`Error::LimitReached`] after [`Phased::phase_limit`] changes of phase,
/// [`Error::BouncesUnresolved`] for a run that ends before bounces that are summed are over,
/// [`Error::OutOfRange`] for a negative `t_end` of a phase with conditions, and those of
/// [`Dop853::solve`]. [`simulate_so_far`] has the motion up to there.
pub fn simulate<const N: usize, S: Phased<N>>(
    scene: &S,
    method: &Dop853,
    phase: S::Phase,
    start: [f64; N],
    t_end: f64,
) -> Result<Run<S::Phase, N>> {
    whole(run(scene, method, phase, start, t_end))
}

/// The motion as [`simulate`] has it, as far as it goes, and the refusal that ended it, if one did.
///
/// A refusal within a phase leaves the motion up to the start of that phase.
///
/// ```
/// # use rotation_dynamics::Error;
/// # use rotation_dynamics::integrators::{Dop853, size_or};
/// # use rotation_dynamics::planar::{Condition, Next, Phased, simulate_so_far};
/// # struct Ball;
/// # impl Phased<2> for Ball {
/// #     type Phase = ();
/// #     fn derivative(&self, _: (), [_, speed]: &[f64; 2]) -> [f64; 2] { [*speed, -10.0] }
/// #     fn conditions(&self, _: ()) -> Vec<Condition<'_, (), 2>> {
/// #         let rebound = Next::jump((), |[_, speed]: &[f64; 2]| [0.0, -0.5 * speed]);
/// #         vec![Condition::gap("height", |y| y[0], rebound)]
/// #     }
/// #     fn scale(&self, y: &[f64; 2]) -> [f64; 2] { size_or([1.0; 2])(y) }
/// # }
/// // A ball that returns half of its speed rests after 3 s and infinitely many bounces.
/// let (run, refused) = simulate_so_far(&Ball, &Dop853::new(1e-12)?, (), [5.0, 0.0], 4.0);
/// assert!(matches!(refused, Some(Error::LimitReached { limit: 1000, .. })));
/// // Bounces that are shorter than the clock shows take two roundings of the time each, 8.9e-16 s.
/// assert!((run.end_time() - 3.0).abs() < 1000.0 * 8.9e-16);
/// # Ok::<(), Error>(())
/// ```
pub fn simulate_so_far<const N: usize, S: Phased<N>>(
    scene: &S,
    method: &Dop853,
    phase: S::Phase,
    start: [f64; N],
    t_end: f64,
) -> (Run<S::Phase, N>, Option<Error>) {
    run(scene, method, phase, start, t_end)
}

/// The run if it is whole, else the refusal alone.
pub(super) fn whole<R>((run, refused): (R, Option<Error>)) -> Result<R> {
    refused.map_or(Ok(run), Err)
}

/// [`simulate_so_far`] of a scene behind a pointer.
pub(super) fn run<P: Copy + PartialEq + Debug, const N: usize>(
    scene: &Scene<'_, P, N>,
    method: &Dop853,
    phase: P,
    start: [f64; N],
    t_end: f64,
) -> (Run<P, N>, Option<Error>) {
    let mut run = Run::empty();
    let done = go(&mut run, scene, method, phase, start, t_end);
    (run, done.err())
}

/// Goes on with an empty run to the end.
fn go<P: Copy + PartialEq + Debug, const N: usize>(
    run: &mut Run<P, N>,
    scene: &Scene<'_, P, N>,
    method: &Dop853,
    phase: P,
    start: [f64; N],
    t_end: f64,
) -> Result<()> {
    if t_end < 0.0 && !scene.conditions(phase).is_empty() {
        return Err(Error::out_of_range(
            "t_end",
            t_end,
            "contacts, and whatever else ends a phase, cannot be run backward: it must \
                      not be negative",
        ));
    }
    through_phases(run, scene, method, phase, start, t_end)?;
    let end = run.end_time();
    for Transition { t, rest, .. } in &run.transitions {
        if let Some(rest) = rest.filter(|rest| rest.t > end) {
            return Err(Error::BouncesUnresolved {
                contact: rest.contact,
                height: rest.height,
                t: *t,
                until: rest.t,
            });
        }
    }
    Ok(())
}

fn through_phases<P: Copy + PartialEq + Debug, const N: usize>(
    run: &mut Run<P, N>,
    scene: &Scene<'_, P, N>,
    method: &Dop853,
    phase: P,
    start: [f64; N],
    t_end: f64,
) -> Result<()> {
    let limit = scene.phase_limit();
    let (mut t, mut phase, mut state, mut first) = (0.0, phase, start, true);
    while run.transitions.len() < limit {
        let conditions = scene.conditions(phase);
        // What ends the scene may come together with what begins a phase.
        let over =
            |c: &&Condition<'_, P, N>| matches!(c.next, Next::End) && (c.margin)(&state) <= 0.0;
        if let Some(end) = conditions.iter().find(over).filter(|_| !run.pieces.is_empty()) {
            run.transitions.push(Transition {
                name: end.name,
                t,
                from: phase,
                to: None,
                before: state,
                after: state,
                rest: None,
            });
            return Ok(());
        }
        let noises = noises(scene, &conditions, run.pieces.last(), &state);
        check_entry(&conditions, &noises, t, &state)?;
        let events: Vec<_> = conditions
            .iter()
            .map(|c| {
                let fails = Event::falling(c.name, |_t, y: &[f64; N]| (c.margin)(y));
                let fails = fails.terminal().nearest();
                match c.noise.as_ref().filter(|_| c.flickers) {
                    Some(noise) => fails.beyond(move |_t, y| FLICKER * noise(y)),
                    None => fails,
                }
            })
            .collect();
        let lasts = within_conditions(&conditions, method, t_end, &|method, t_end| {
            method.solve(&InPhase(scene, phase), t, &state, t_end, &events)
        })?;
        let (index, when, before) = match lasts {
            Lasts::Until(solution) => {
                run.work += solution.work();
                let failed = solution.stopped_by().map(|event| (event.index, event.t, event.state));
                run.pieces.push(PhaseRun { phase, solution });
                let Some(failed) = failed else {
                    return Ok(());
                };
                failed
            }
            Lasts::NoTime(index, broken) => {
                // Decided by a round-off, it fails after all; but not twice in an instant.
                let Condition { name, margin, .. } = &conditions[index];
                let mut here = run.transitions.iter().rev().take_while(|x| x.t == t);
                let again = here.any(|x| x.from == phase && x.name == *name);
                if again || margin(&state).abs() > noises[index] {
                    return Err(broken);
                }
                (index, t, state)
            }
        };
        let (to, after, rest) = match &conditions[index].next {
            Next::Enter(to) => (Some(*to), before, None),
            Next::Jump(to, impact) => (Some(*to), impact(&before), None),
            Next::Decide(decide) => {
                let Entry { phase, state, rest } = decide(when, &before)?;
                (Some(phase), state, rest)
            }
            Next::End => (None, before, None),
        };
        // Modes that are over at once, where a motion goes on from an event, were none.
        let is_decided = matches!(conditions[index].next, Next::Decide(_)) && before == after;
        let is_none = first && when == 0.0 && is_decided;
        first = false;
        if !is_none {
            run.transitions.push(Transition {
                name: conditions[index].name,
                t: when,
                from: phase,
                to,
                before,
                after,
                rest,
            });
        }
        let Some(to) = to.filter(|_| when < t_end) else {
            return Ok(());
        };
        (t, phase, state) = (when, to, after);
    }
    Err(Error::LimitReached { what: "changes of phase", t, t_end, limit: limit as u64 })
}

/// The refusal of a phase that begins with this margin of a condition.
fn cannot_hold<P, const N: usize>(of: &Condition<'_, P, N>, t: f64, value: f64) -> Error {
    Error::CannotHold { name: of.name, t, value, rate: None }
}

/// How long a phase lasts.
enum Lasts<const N: usize> {
    /// As long as its solution.
    Until(Solution<N>),
    /// The condition at this place fails at once.
    NoTime(usize, Error),
}

/// The solution of a phase in which no condition fails unseen.
///
/// A gap that is shut at the start and closes again within the first step was never
/// seen open: its event is missed. Then the stretch until it is seen violated is
/// solved again in sixteen steps or more, until the event shows.
fn within_conditions<P, const N: usize>(
    conditions: &[Condition<'_, P, N>],
    method: &Dop853,
    t_end: f64,
    solve: &dyn Fn(&Dop853, f64) -> Result<Solution<N>>,
) -> Result<Lasts<N>> {
    let (mut method, mut end) = (*method, t_end);
    let mut broken = None;
    for _ in 0..SHORTENINGS {
        let solution = match solve(&method, end) {
            // Shorter than the clock shows.
            Err(Error::StepUnderflow { clock: Some(_), .. }) if broken.is_some() => break,
            solution => solution?,
        };
        let Some((index, value, when)) = failed_unseen(conditions, &solution)? else {
            if end == t_end || solution.stopped_by().is_some() {
                return Ok(Lasts::Until(solution));
            }
            break;
        };
        let t = solution.start_time();
        broken = Some((index, cannot_hold(&conditions[index], t, value)));
        method = method.with_longest_step((when - t) / 16.0)?;
        end = when;
    }
    Ok(match broken {
        Some((index, broken)) => Lasts::NoTime(index, broken),
        None => Lasts::Until(solve(&method, t_end)?),
    })
}

/// The condition that fails at the end of a step without an event, its lowest margin and
/// the time when it is first negative. Round-off does not count: a margin that falls below zero by less than
/// [`ROUND_OFF`] of what it reaches elsewhere.
fn failed_unseen<P, const N: usize>(
    conditions: &[Condition<'_, P, N>],
    solution: &Solution<N>,
) -> Result<Option<(usize, f64, f64)>> {
    let stopped = solution.stopped_by().map(|event| event.index);
    for (i, condition) in (0..).zip(conditions).filter(|(i, _)| Some(*i) != stopped) {
        let (mut lowest, mut highest, mut first) = (0.0_f64, 0.0_f64, None);
        let mut largest_noise = 0.0_f64;
        for t in solution.step_times() {
            let state = solution.at(t)?;
            let margin = (condition.margin)(&state);
            highest = highest.max(margin);
            if let Some(noise) = &condition.noise {
                largest_noise = largest_noise.max(noise(&state));
            }
            lowest = lowest.min(margin);
            if margin < 0.0 {
                first = first.or(Some(t));
            }
        }
        if let Some(t) = first
            && lowest < -(ROUND_OFF * highest).max(largest_noise)
        {
            return Ok(Some((i, lowest, t)));
        }
    }
    Ok(None)
}

/// The round-off of the margin of each condition where a phase begins: from the state, and from the
/// time at which the phase before it ended.
fn noises<P: Copy + PartialEq + Debug, const N: usize>(
    scene: &Scene<'_, P, N>,
    conditions: &[Condition<'_, P, N>],
    before: Option<&PhaseRun<P, N>>,
    state: &[f64; N],
) -> Vec<f64> {
    let size = scene.scale(state);
    let earlier = before.and_then(|PhaseRun { solution, .. }| {
        let end = solution.end_time();
        let t = (end - AT_ENTRY * end.abs()).max(solution.start_time());
        Some([*solution.end_state(), solution.at(t).ok()?])
    });
    let noise = |condition: &Condition<'_, P, N>| {
        if let Some(noise) = &condition.noise {
            return noise(state);
        }
        let change =
            |a: &[f64; N], b: &[f64; N]| ((condition.margin)(a) - (condition.margin)(b)).abs();
        let of_state = (0..N).map(|i| {
            let mut moved = *state;
            moved[i] += AT_ENTRY * size[i];
            change(&moved, state)
        });
        let of_time = earlier.map_or(0.0, |[a, b]| change(&a, &b));
        of_state.sum::<f64>() + of_time
    };
    conditions.iter().map(noise).collect()
}

fn check_entry<P, const N: usize>(
    conditions: &[Condition<'_, P, N>],
    noises: &[f64],
    t: f64,
    state: &[f64; N],
) -> Result<()> {
    for (condition, noise) in conditions.iter().zip(noises) {
        let must_hold = condition.kind != Kind::Opening && condition.noise.is_none();
        let value = (condition.margin)(state);
        // What is not a number does not hold either.
        if must_hold && !(value >= 0.0 || value >= -noise) {
            return Err(cannot_hold(condition, t, value));
        }
    }
    Ok(())
}

impl<P, const N: usize> Run<P, N> {
    /// No motion yet.
    pub(super) fn empty() -> Self {
        Self { pieces: Vec::new(), transitions: Vec::new(), work: Work::default() }
    }
}

impl<P: Copy, const N: usize> Run<P, N> {
    /// The phases in order, each with its motion.
    pub fn pieces(&self) -> &[PhaseRun<P, N>] {
        &self.pieces
    }

    /// The changes of phase in order, the end of the scene included.
    pub fn transitions(&self) -> &[Transition<P, N>] {
        &self.transitions
    }

    /// The first change of phase by the condition with this name.
    ///
    /// # Errors
    /// [`Error::NotReached`] if there was none.
    pub fn transition(&self, name: &'static str) -> Result<&Transition<P, N>> {
        let found = self.transitions.iter().find(|t| t.name == name);
        found.ok_or_else(|| Error::NotReached { name, until: self.end_time() })
    }

    /// When the run ended.
    pub fn end_time(&self) -> f64 {
        self.pieces.last().map_or(0.0, |piece| piece.solution.end_time())
    }

    /// Phase and state at `t`; at a change of phase, those before it.
    ///
    /// # Errors
    /// [`Error::OutsideRun`] for a time before the start or after the end.
    pub fn at(&self, t: f64) -> Result<(P, [f64; N])> {
        let outside = || Error::OutsideRun { t, start: 0.0, end: self.end_time() };
        let holds = |piece: &&PhaseRun<P, N>| t <= piece.solution.end_time();
        let piece = self.pieces.iter().find(holds).ok_or_else(outside)?;
        let state = piece.solution.at(t).map_err(|_| outside())?;
        Ok((piece.phase, state))
    }

    /// The state at the end of the run.
    pub fn end_state(&self) -> Option<&[f64; N]> {
        self.pieces.last().map(|piece| piece.solution.end_state())
    }

    /// The cost of the run.
    pub fn work(&self) -> Work {
        self.work
    }
}
