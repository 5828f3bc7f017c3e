//! Another route to the least sum of squares: normal equations in other numbers, from the truth.

use super::throw::Throw;
use nalgebra::{DMatrix, DVector};
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::exact::free_body::FreeBody;
use rotation_dynamics::fit::Flight;
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::inertia::PrincipalMoments;

/// Two moments over their sum, angular momentum, turn, offset.
fn residuals(x: &[f64], flight: &Flight) -> Option<DVector<f64>> {
    let moments = [x[0], x[1], 1.0 - x[0] - x[1]];
    let start = BodyVector::from([0, 1, 2].map(|i| x[2 + i] / moments[i]));
    let turn = Attitude::from_rotation_vector(SpaceVector::new(x[5], x[6], x[7])).ok()?;
    // No body, but as good for the closed form: a flat one, with its excess taken off.
    let body = PrincipalMoments::new(moments[0], moments[1], moments[2]).ok()?;
    let motion = FreeBody::new(body, Attitude::IDENTITY, start).ok()?;
    let first = flight.times().next()?;
    let left = flight.times().zip(flight.rates()).flat_map(|(t, seen)| {
        let shown = turn.to_space(motion.angular_velocity(t - first));
        [0, 1, 2].map(|i| shown[i] + x[8 + i] - seen[i])
    });
    Some(DVector::from_vec(left.collect()))
}

/// The sum of squares that this route reaches, with the turn and the offset open or 0.
pub fn squares_from(flight: &Flight, throw: &Throw, [axes, offset]: [bool; 2]) -> f64 {
    let sum: f64 = throw.moments.iter().sum();
    let turn = if axes { throw.turn } else { [0.0; 3] };
    let beside = if offset { throw.offset } else { [0.0; 3] };
    let first = flight.rates().next().expect("a sample");
    let first = SpaceVector::from([0, 1, 2].map(|i| first[i] - beside[i]));
    let first = Attitude::from_rotation_vector(turn.into()).expect("a turn").to_body(first);
    let mut x = vec![throw.moments[0] / sum, throw.moments[1] / sum];
    x.extend((0..3).map(|i| first[i] * throw.moments[i] / sum));
    x.extend(turn.into_iter().chain(beside));
    let open: Vec<usize> = (0..5)
        .chain(if axes { 5..8 } else { 0..0 })
        .chain(if offset { 8..11 } else { 0..0 })
        .collect();
    let Some(mut now) = residuals(&x, flight) else { return f64::INFINITY };
    let mut damping = 1e-3;
    for _ in 0..60 {
        let column = |i: &usize| {
            let mut aside = x.clone();
            aside[*i] -= 1e-7;
            Some((&now - residuals(&aside, flight)?) / 1e-7)
        };
        let Some(columns) = open.iter().map(column).collect::<Option<Vec<_>>>() else { break };
        let jacobian = DMatrix::from_columns(&columns);
        let mut normal = jacobian.tr_mul(&jacobian);
        for i in 0..open.len() {
            normal[(i, i)] *= 1.0 + damping;
        }
        let Some(step) = normal.lu().solve(&jacobian.tr_mul(&now)) else { break };
        let mut tried = x.clone();
        open.iter().zip(step.iter()).for_each(|(i, step)| tried[*i] -= step);
        match residuals(&tried, flight) {
            Some(there) if there.norm_squared() < now.norm_squared() => {
                (x, now) = (tried, there);
                damping *= 0.2;
            }
            _ => damping *= 5.0,
        }
    }
    now.norm_squared()
}
