//! Whether a mechanism says the truth about its contacts.

use super::declare::dot;
use super::{Mechanism, MechanismState};
use crate::accuracy::largest;

/// How far what `mechanism` declares in `state` is from differences of it along the motion
/// at constant velocities, relative: the speed of each gap from its gap, the bias of each
/// row from its speed.
///
/// A slip of the pen gives an error of order 1, correct rows one of order 1e-10. The state should move in all its
/// coordinates; surfaces that move along the normal are left out.
pub fn misdeclared<M: Mechanism<N, C>, const N: usize, const C: usize>(
    mechanism: &M,
    state: &MechanismState<N>,
) -> f64 {
    let sizes = mechanism.scale(state).q;
    let rates = (0..N).map(|j| (state.v[j] / sizes[j]).abs());
    let h = 1e-3 / rates.fold(f64::MIN_POSITIVE, f64::max);
    let at = |t: f64| {
        let q = core::array::from_fn(|j| state.q[j] + t * state.v[j]);
        mechanism.contacts(&MechanismState { q, v: state.v })
    };
    let around = [-2.0, -1.0, 1.0, 2.0].map(|k| at(k * h));
    // Fourth-order central differences.
    let rate = |f: [f64; 4]| (8.0 * (f[2] - f[1]) - (f[3] - f[0])) / (12.0 * h);
    let errors = mechanism.contacts(state).into_iter().enumerate().flat_map(|(i, c)| {
        let gap = rate(around.each_ref().map(|near| near[i].gap));
        let normal = rate(around.each_ref().map(|near| dot(&near[i].normal.along, &state.v)));
        let slip = rate(around.each_ref().map(|near| dot(&near[i].tangent.along, &state.v)));
        let (speed, along) =
            (c.normal.size(&state.v.map(f64::abs)), c.tangent.size(&state.v.map(f64::abs)));
        let still = c.normal.surface == 0.0;
        let relative = |difference: f64, size: f64| {
            if difference == 0.0 { 0.0 } else { difference / size }
        };
        [
            if still { relative(gap - dot(&c.normal.along, &state.v), speed) } else { 0.0 },
            if still { relative(h * (normal - c.normal.bias), 1e-3 * speed) } else { 0.0 },
            relative(h * (slip - c.tangent.bias), 1e-3 * along),
        ]
    });
    largest(errors)
}
