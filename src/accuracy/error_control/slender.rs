//! Slender bodies: which variables, and which rates.
//!
//! A body is slender where one moment is far below the others and the motion does not turn mostly
//! about that axis. Then L on the fixed axes blurs the rate about the thin axis
//! ([`BodyFixed`](crate::integrators::BodyFixed)), and the energy allows a rate sqrt(2 E / I_min)
//! that the body never reaches. So the momentum is stepped on the body's axes, by DOP853, and steps
//! are chosen by the rates of a trial run.

use super::changed::{ALL_ROWS, signs};
use super::constants::{SLENDER, TRIAL, TRIAL_PART, TUMBLING};
use super::problem::Problem;
use crate::accuracy::larger;
use crate::body::State;
use crate::error::{Error, Result};
use crate::frame::BodyVector;
use crate::integrators::{Dop853, Integrator, Work};
use crate::math::order_of_three;

/// The result of a trial run of a slender body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Slender {
    /// The fastest rate (rad/s).
    pub rate: f64,
    /// How many times eps of the rate about the thin axis is lost in a [`State`] on the way:
    /// |L| / (I_min rate); 0 where none is asked for.
    pub held: f64,
    /// The same for the momentum that a torque on the fixed axes brings.
    pub brought: f64,
}

impl Slender {
    /// The result of the trial, if the body is slender and its motion too. `None` also where it
    /// comes to no end within its part of this budget of torques.
    pub(super) fn of(problem: &Problem, budget: u64, work: &mut Work) -> Result<Option<Self>> {
        let moments = problem.body.moments().to_array();
        let [least, most] = [f64::min, f64::max].map(|of| moments.into_iter().fold(moments[0], of));
        if most <= SLENDER * least || problem.span() == 0.0 || problem.is_spin_free() {
            return Ok(None);
        }
        let steps = (budget / TRIAL_PART / 12).max(1);
        let method = Dop853::new(TRIAL)?.with_step_limit(steps)?;
        let [rate, momentum] = match fastest(problem, &method, work) {
            Err(error @ Error::Contradiction { .. }) => return Err(error),
            Err(_) => return Ok(None),
            Ok(fastest) => fastest,
        };
        let natural = least * rate;
        let slender = Self {
            rate,
            held: momentum / natural,
            brought: problem.torque * problem.span().abs() / natural,
        };
        Ok((problem.fastest() > TUMBLING * rate && natural > 0.0).then_some(slender))
    }
}

/// The fastest rate and the largest momentum at the steps of a run.
fn fastest(problem: &Problem, method: &Dop853, work: &mut Work) -> Result<[f64; 2]> {
    let [mut rate, mut momentum] = [0.0; 2];
    let (mut state, mut on_body) = (problem.start, None);
    for piece in problem.pieces([problem.t_start, problem.t_end]).windows(2) {
        let (end, components) =
            problem.on_body_axes([piece[0], piece[1]], (&state, on_body), |fixed, start| {
                let mut see = |y: &[f64; 7]| {
                    let [.., a, b, c] = *y;
                    rate = larger(rate, fixed.rates(y).norm());
                    momentum = larger(momentum, BodyVector::new(a, b, c).norm());
                };
                see(&start);
                method.advance_watched(fixed, [0.0, piece[1] - piece[0]], &start, work, see)
            })?;
        (state, on_body) = (end, Some(components));
    }
    Ok([rate, momentum])
}

/// Two rows of the design that push the rates about the outer axes with equal and with opposite
/// signs. Beside the middle axis of a plate one of the two dies away where the other grows.
pub(super) fn opposite_rows(moments: [f64; 3]) -> [usize; 2] {
    let axes = order_of_three(moments);
    let with = |sign: f64| {
        let is = |row: &usize| {
            let [_, _, _, push @ ..] = signs(*row);
            push[axes[0]] * push[axes[2]] == sign
        };
        (0..ALL_ROWS).find(is).unwrap_or(0)
    };
    [with(1.0), with(-1.0)]
}

/// A run between two times without a jump, from a state or from its components on the body's axes;
/// both at its end.
pub(super) fn carried(
    problem: &Problem,
    method: &Dop853,
    [from, to]: [f64; 2],
    start: &State,
    on_body: Option<[f64; 7]>,
    work: &mut Work,
) -> Result<(State, [f64; 7])> {
    problem.on_body_axes([from, to], (start, on_body), |fixed, start| {
        method.advance_counting(fixed, 0.0, &start, to - from, work)
    })
}
