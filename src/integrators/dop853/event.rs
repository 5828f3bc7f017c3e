//! Events: places where a function of time and state goes through zero.
//!
//! A crossing is found by the sign of the function at the ends of a step, at seven times between
//! and where it comes nearest to zero, on the interpolant. Its time is then polished with real
//! steps from the start of the step, so that it has the accuracy of the run and not of the
//! interpolant. It is taken on the far side of zero, so that a run that goes on from there does not
//! meet it again.

use super::segment::Segment;
use super::system::System;
use super::trial::Trial;
use crate::error::{Error, FINITE, Result};
use crate::integrators::Work;
use crate::math::bracket::{least, zero};
use crate::math::{EPS, sort_by_number};

/// Which crossings count, as the run meets them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Direction {
    /// From negative to positive.
    Rising,
    /// From positive to negative.
    Falling,
    /// Both.
    Either,
}

type Function<'f, const N: usize> = dyn Fn(f64, &[f64; N]) -> f64 + 'f;

/// A function of time and state whose zeros are to be located.
///
/// An event is a change of sign between two of nine equidistant times in a step, or between one of
/// them and the point where the function comes nearest to zero. So a graze of the interpolant that
/// is deeper than round-off is met. One that goes beyond zero by less than the interpolant errs, or
/// only touches it, may be found or missed, depending on round-off and the interpolant. Of three
/// zeros within an eighth of a step two hide each other:
/// [`Dop853::with_longest_step`](super::Dop853::with_longest_step).
///
/// A located event lies on its far side: the function is zero there or has the sign it came to,
/// unless no step that was tried goes beyond zero. So a run may go on from there, whatever is done
/// to the state. A function that is zero at the very start of a run has no event there. One that
/// may cross either way has none either where it comes to zero within a round-off of the time.
///
/// Accuracy: but for such a graze the state at the located time satisfies the event to its rounding
/// (3.9e-15 measured on speeds of order 1), and the time is as good as the run: off by 6.2e-11 at
/// tolerance 1e-12 where the run itself is off by 6.7e-11, 6.4e-14 at 1e-15
/// (`tests/integrators/convergence/events.rs`).
///
/// Solve, handle, solve on:
///
/// ```
/// use rotation_dynamics::integrators::{Dop853, Event, second_order};
/// let swing = second_order(|_t, x, _v| -x);
/// let (mut t, mut state, mut stops) = (0.0, [1.0, 0.0], 0);
/// while stops < 1000 {
///     let middle = Event::crossing("middle", |_t, [x, _]: &[f64; 2]| *x).terminal();
///     let run = Dop853::new(1e-9)?.solve(&swing, t, &state, f64::MAX, &[middle])?;
///     let Some(event) = run.stopped_by() else { break };
///     // Here the state may be changed, by a push for example.
///     (t, state, stops) = (event.t, event.state, stops + 1);
/// }
/// // At pi/2, 3 pi/2, ...
/// assert!((t - 999.5 * core::f64::consts::PI).abs() < 1e-7);
/// # Ok::<(), rotation_dynamics::Error>(())
/// ```
pub struct Event<'f, const N: usize> {
    name: &'static str,
    function: Box<Function<'f, N>>,
    direction: Direction,
    terminal: bool,
    nearest: bool,
    round_off: Option<Box<Function<'f, N>>>,
}

impl<'f, const N: usize> Event<'f, N> {
    /// The event that `function(t, y)` goes through zero in this direction.
    pub fn new(
        name: &'static str,
        direction: Direction,
        function: impl Fn(f64, &[f64; N]) -> f64 + 'f,
    ) -> Self {
        Self {
            name,
            function: Box::new(function),
            direction,
            terminal: false,
            nearest: false,
            round_off: None,
        }
    }

    /// The event that `function(t, y)` goes from negative to positive.
    pub fn rising(name: &'static str, function: impl Fn(f64, &[f64; N]) -> f64 + 'f) -> Self {
        Self::new(name, Direction::Rising, function)
    }

    /// The event that `function(t, y)` goes from positive to negative.
    pub fn falling(name: &'static str, function: impl Fn(f64, &[f64; N]) -> f64 + 'f) -> Self {
        Self::new(name, Direction::Falling, function)
    }

    /// The event that `function(t, y)` goes through zero either way.
    pub fn crossing(name: &'static str, function: impl Fn(f64, &[f64; N]) -> f64 + 'f) -> Self {
        Self::new(name, Direction::Either, function)
    }

    /// The same event, but the run ends where it happens.
    #[must_use]
    pub fn terminal(self) -> Self {
        Self { terminal: true, ..self }
    }

    /// The same event at the place nearest to zero, on either side: for a run that knows from which
    /// event it goes on.
    #[must_use]
    pub(crate) fn nearest(self) -> Self {
        Self { nearest: true, ..self }
    }

    /// The same event of a function whose values err by up to `round_off(t, y)`: a change of sign
    /// within that is none, until the function is beyond it.
    ///
    /// Where a function leaves zero slowly, as the gap of a contact does whose force has faded, its
    /// sign is round-off for a while.
    #[must_use]
    pub fn beyond(self, round_off: impl Fn(f64, &[f64; N]) -> f64 + 'f) -> Self {
        Self { round_off: Some(Box::new(round_off)), ..self }
    }

    fn value(&self, t: f64, y: &[f64; N]) -> Result<f64> {
        let value = (self.function)(t, y);
        if value.is_finite() {
            Ok(value)
        } else {
            Err(Error::of_function(
                format!("function of the event \"{}\"", self.name),
                t,
                ("y", y.to_vec()),
                &[value],
                FINITE,
            ))
        }
    }

    /// True if a change of sign from `a` to `b`, near this time, says nothing.
    fn is_round_off(&self, a: f64, b: f64, t: f64, segment: &Segment<N>) -> bool {
        let within =
            |round_off: &Function<'f, N>| a.abs().max(b.abs()) <= round_off(t, &segment.at(t));
        a * b <= 0.0 && self.round_off.as_deref().is_some_and(within)
    }

    /// Some(rising) if the step from value `a` to value `b` counts.
    fn counts(&self, a: f64, b: f64) -> Option<bool> {
        let rising = a < 0.0 && b >= 0.0;
        let falling = a > 0.0 && b <= 0.0;
        match self.direction {
            Direction::Rising => rising.then_some(true),
            Direction::Falling => falling.then_some(false),
            Direction::Either => (rising || falling).then_some(rising),
        }
    }
}

/// An event that has happened.
#[derive(Debug, Clone, PartialEq)]
pub struct LocatedEvent<const N: usize> {
    /// Its place in the list of events given.
    pub index: usize,
    /// Its name.
    pub name: &'static str,
    /// When: just beyond the zero.
    pub t: f64,
    /// The state there, by a real step.
    pub state: [f64; N],
    /// True if the function went from negative to positive.
    pub rising: bool,
}

/// Parts of a step between which the sign of an event function is compared.
const PARTS: u32 = 8;
/// Times between the ends of a step.
const BETWEEN: usize = PARTS as usize - 1;
/// A graze of less than this part of the function's size nearby is round-off.
const GRAZE: f64 = 16.0 * EPS;
/// Corrections of an event's time by real steps, at most.
const CORRECTIONS: u32 = 6;
/// A function that after all corrections stays above this part of what it is a thousandth of a step
/// beside its zero jumps there. For smooth functions the corrections leave less: some on the book's
/// pages leave 1e-9, none this much.
const JUMP: f64 = 1e-6;
/// From stride to stride towards the far side of a zero.
const LONGER: f64 = 4.0;
/// Times that differ by less than this part of the time, or of 64 steps, differ by round-off: a
/// first step is some hundredth of what the motion takes to change by its own size.
const AT_ONCE: f64 = 64.0 * EPS;

/// The events of a run and the values they had at the end of the last step.
pub(super) struct Watch<'e, 'f, const N: usize> {
    events: &'e [Event<'f, N>],
    values: Vec<f64>,
    start: f64,
}

/// The events met in a step, and the step cut short at a terminal one.
type Met<const N: usize> = (Vec<LocatedEvent<N>>, Option<Trial<N>>);

impl<'e, 'f, const N: usize> Watch<'e, 'f, N> {
    pub(super) fn new(events: &'e [Event<'f, N>], t: f64, y: &[f64; N]) -> Result<Self> {
        let values = events.iter().map(|e| e.value(t, y)).collect::<Result<_>>()?;
        Ok(Self { events, values, start: t })
    }

    /// The events within an accepted step, in the order in which they happen,
    /// up to the first terminal one.
    pub(super) fn crossings(
        &mut self,
        ode: &dyn System<N>,
        step: &Trial<N>,
        segment: &Segment<N>,
        work: &mut Work,
    ) -> Result<Met<N>> {
        if self.events.is_empty() {
            return Ok((Vec::new(), None));
        }
        let mut found: Vec<(LocatedEvent<N>, Trial<N>)> = Vec::new();
        // The places between the ends, the same for all events.
        let between = core::array::from_fn::<_, BETWEEN, _>(|part| {
            let s = (part + 1) as f64 / f64::from(PARTS);
            let t = step.t + s * (step.t_end - step.t);
            (t, segment.at(t))
        });
        for (index, event) in self.events.iter().enumerate() {
            let mut seen = vec![(step.t, self.values[index])];
            for (t, y) in &between {
                seen.push((*t, event.value(*t, y)?));
            }
            let last = event.value(step.t_end, &step.end.value)?;
            seen.push((step.t_end, last));
            let mut seen = with_grazes(event, segment, &seen)?;
            for n in 1..seen.len() {
                let ((t_a, a), (t_b, b)) = (seen[n - 1], seen[n]);
                if event.is_round_off(a, b, t_b, segment) {
                    // On the side where it was, until it is beyond.
                    seen[n].1 = a;
                    continue;
                }
                if let Some(rising) = event.counts(a, b) {
                    let guess = zero(|t| event.value(t, &segment.at(t)), (t_a, a), (t_b, b))?;
                    let at_start = step.t == self.start && is_round_off(step, self.start, guess);
                    if event.direction == Direction::Either && at_start {
                        continue;
                    }
                    let reach = (t_b - t_a).abs();
                    let there = polish(ode, event, step, segment, [guess, reach], rising, work)?;
                    let located = LocatedEvent {
                        index,
                        name: event.name,
                        t: there.t_end,
                        state: there.end.value,
                        rising,
                    };
                    found.push((located, there));
                }
            }
            self.values[index] = seen[seen.len() - 1].1;
        }
        let since_start = |e: &LocatedEvent<N>| (e.t - step.t).abs();
        sort_by_number(&mut found, |(e, _)| since_start(e));
        let terminal = found.iter().position(|(e, _)| self.events[e.index].terminal);
        let later = terminal.map_or_else(Vec::new, |last| found.split_off(last + 1));
        let stopped = terminal.and_then(|_| found.pop());
        let mut met: Vec<_> = found.into_iter().map(|(e, _)| e).collect();
        let Some((end, stopped)) = stopped else {
            return Ok((met, None));
        };
        // What a rounding of the time puts behind the end, and is over there, has happened too.
        for (other, _) in later {
            let value = self.events[other.index].value(end.t, &end.state)?;
            let here = is_round_off(step, end.t, other.t) && !is_before(value, other.rising);
            met.extend(here.then_some(LocatedEvent { t: end.t, state: end.state, ..other }));
        }
        met.push(end);
        Ok((met, Some(stopped)))
    }
}

/// Whether two times in this step differ by round-off.
fn is_round_off<const N: usize>(step: &Trial<N>, a: f64, b: f64) -> bool {
    let steps = 64.0 * (step.t_end - step.t).abs();
    (a - b).abs() <= AT_ONCE * b.abs().max(steps)
}

/// Whether a function that goes through zero, rising or falling, has still the sign before it.
fn is_before(value: f64, rising: bool) -> bool {
    if rising { value < 0.0 } else { value > 0.0 }
}

/// The times and values seen in a step, and between them those where the function comes
/// nearest to zero, if it is beyond zero there.
fn with_grazes<const N: usize>(
    event: &Event<'_, N>,
    segment: &Segment<N>,
    seen: &[(f64, f64)],
) -> Result<Vec<(f64, f64)>> {
    let mut all = seen[..1].to_vec();
    for (i, pair) in seen.windows(2).enumerate() {
        let ((t_a, a), (t_b, b)) = (pair[0], pair[1]);
        // Nearest to zero from the side on which both ends are.
        let side = if a > 0.0 { 1.0 } else { -1.0 };
        // A convex function stays above the secants on either side, drawn on.
        let above = |here: f64, beside: Option<&(f64, f64)>| {
            beside.is_some_and(|(_, beside)| side * (2.0 * here - beside) > 0.0)
        };
        let before = i.checked_sub(1).and_then(|j| seen.get(j));
        let both = side * a > 0.0 && side * b > 0.0;
        if both && !above(a, before) && !above(b, seen.get(i + 2)) {
            let (t, value) = least(|t| event.value(t, &segment.at(t)), side, [t_a, t_b])?;
            let size = a.abs().max(b.abs());
            if side * value < -GRAZE * size {
                all.push((t, value));
            }
        }
        all.push((t_b, b));
    }
    Ok(all)
}

/// The step from the same start to the zero itself. The time is corrected with real steps until the
/// event function no longer shrinks, then moved on by strides that start at round-off until the
/// function is zero or beyond. If it is not within `reach`, where it only touches zero, the nearest
/// is what there is. Where the function jumps over zero it does not shrink: there the time is
/// halved in, by real steps too.
fn polish<const N: usize>(
    ode: &dyn System<N>,
    event: &Event<'_, N>,
    step: &Trial<N>,
    segment: &Segment<N>,
    [guess, reach]: [f64; 2],
    rising: bool,
    work: &mut Work,
) -> Result<Trial<N>> {
    let within = |t: f64| t.clamp(step.t.min(step.t_end), step.t.max(step.t_end));
    let mut real = |t: f64| -> Result<(Trial<N>, f64)> {
        let there = if t == step.t_end { *step } else { step.shortened(ode, t, work)? };
        let value = event.value(t, &there.end.value)?;
        Ok((there, value))
    };
    let (mut best, mut value) = real(guess)?;
    // The slope of the function along the interpolant is good enough to start with.
    let about = 1e-3 * (step.t_end - step.t);
    let (t_a, t_b) = (within(guess - about), within(guess + about));
    let (a, b) = (event.value(t_a, &segment.at(t_a))?, event.value(t_b, &segment.at(t_b))?);
    let mut slope = (b - a) / (t_b - t_a);
    for _ in 0..CORRECTIONS {
        let t = within(best.t_end - value / slope);
        if value == 0.0 || !t.is_finite() || t == best.t_end {
            break;
        }
        let (next, next_value) = real(t)?;
        if next_value.abs() >= value.abs() {
            break;
        }
        slope = (next_value - value) / (next.t_end - best.t_end);
        (best, value) = (next, next_value);
    }
    let span = step.t_end - step.t;
    let first = EPS * best.t_end.abs().max(span.abs());
    let (mut stride, mut there) = (first, best);
    let reach = reach.max(LONGER * stride);
    let jumps = value.abs() > JUMP * a.abs().max(b.abs());
    while !event.nearest && is_before(value, rising) {
        if there.t_end == step.t_end || stride > reach {
            return Ok(best);
        }
        (there, value) = real(within(best.t_end + stride.copysign(span)))?;
        stride *= LONGER;
    }
    if event.nearest || !jumps {
        return Ok(there);
    }
    // A time before the jump, and the times between halved.
    let (mut before, mut stride) = (best.t_end, first);
    while !is_before(real(before)?.1, rising) {
        if before == step.t || stride > reach {
            return Ok(there);
        }
        before = within(best.t_end - stride.copysign(span));
        stride *= LONGER;
    }
    while (there.t_end - before).abs() > 2.0 * first {
        let (middle, value) = real(0.5 * (before + there.t_end))?;
        if is_before(value, rising) {
            before = middle.t_end;
        } else {
            there = middle;
        }
    }
    Ok(there)
}
