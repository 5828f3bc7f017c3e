//! Runs over effects that go on in pieces: sampled and held, or switched where a margin comes to zero.
//!
//! Between two samples and two switches the torque is smooth. The values held there are a part of
//! where a run goes on from ([`Stop`]), so that a run may be cut anywhere. A changed run meets its
//! own switches: the condition contains their shift.

use super::constants::{AT_ONCE, SLIDES};
use super::problem::Problem;
use super::run::{Stop, later};
use crate::body::State;
use crate::effects::{Held, Holding, Law, is_same, piece};
use crate::error::{Error, Result};
use crate::integrators::{Dop853, Event, Ode, Work, scene};

/// A run by DOP853 between two break points, with so many steps at least from each sample to the next.
pub(super) fn carried(
    problem: &Problem,
    method: Dop853,
    [t, t_end]: [f64; 2],
    start: &Stop,
    least: u64,
    work: &mut Work,
) -> Result<Stop> {
    let body = &problem.body;
    let mut holding = problem.checked.holding().clone();
    holding.held.clone_from(&start.held);
    let (mut now, mut state) = (t, start.state);
    let (longest, limit) = method.limits();
    let begun = work.steps + work.rejected;
    let mut step = 0.0;
    let mut back_at_once = vec![0; holding.held.len().max(1)];
    let (mut sample, mut is_sample) = (t, true);
    while now != t_end {
        if is_sample {
            holding.hold(now, body, &state)?;
            back_at_once.resize(holding.held.len(), 0);
            sample = holding.next_sample(now);
            if sample <= now {
                return Err(Error::StepUnderflow {
                    t: now,
                    step: sample - now,
                    clock: Some(now.abs().next_up() - now.abs()),
                    state: scene::components(&state).to_vec(),
                });
            }
        }
        is_sample = sample < t_end && !is_same(sample, t_end);
        let to = if is_sample { sample } else { t_end };
        let (s, y, met) = {
            let held = Held(&holding);
            let on_piece = problem.scene::<false, true>(&held, [now, to]);
            let ode: &dyn Ode<7> = &on_piece;
            let watched: Vec<_> = (holding.laws())
                .filter(|(n, law)| law.margin(holding.held[*n], now, body, &state) != f64::INFINITY)
                .collect();
            let events: Vec<_> = (watched.iter())
                .map(|(n, law)| margin(problem, *law, &holding, *n, [now, to]))
                .collect();
            let used = work.steps + work.rejected - begun;
            if used >= limit {
                return Err(Error::LimitReached { what: "steps", t: now, t_end, limit });
            }
            let method = method
                .with_longest_step(longest.min((to - now).abs() / least as f64))?
                .with_step_limit(limit - used)?
                .with_first_step(step);
            let y = scene::components(&state);
            let (s, y, met, next) = method
                .advance_to_event(ode, [0.0, to - now], &y, &events, work)
                .map_err(|error| later(error, now - t))?;
            step = next;
            let met: Vec<_> = met.iter().map(|event| watched[event.index]).collect();
            (s, y, met)
        };
        state = scene::state(&y)?;
        let there = now + s;
        let is_there = met.is_empty() || (to - there) * (to - now) <= 0.0;
        is_sample &= is_there;
        now = if is_there { to } else { there };
        for (n, law) in met {
            back_at_once[n] = if s.abs() <= AT_ONCE * step { back_at_once[n] + 1 } else { 0 };
            if back_at_once[n] >= SLIDES {
                return Err(Error::Sliding { effect: holding.name_of(n), t: now });
            }
            holding.held[n] = law.beyond(holding.held[n], now, body, &state);
        }
    }
    Ok(Stop { held: holding.held, ..Stop::at(state) })
}

/// The event that the margin of a law falls below 0. At the start of the piece it counts as above,
/// whatever rounding has left of it there.
fn margin<'l>(
    problem: &'l Problem,
    law: &'l dyn Law,
    holding: &Holding,
    part: usize,
    [from, to]: [f64; 2],
) -> Event<'l, 7> {
    let held = holding.held[part];
    let [first, last] = piece([from, to]);
    let function = move |s: f64, y: &[f64; 7]| {
        let t = (from + s).max(first).min(last);
        let margin = |state: State| law.margin(held, t, &problem.body, &state);
        let margin = scene::state(y).map_or(f64::NAN, margin);
        if margin == 0.0 || s == 0.0 && margin < 0.0 { f64::MIN_POSITIVE } else { margin }
    };
    let name = holding.first_name(part);
    Event::falling(name, function).terminal()
}
