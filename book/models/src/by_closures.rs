//! Small motions in a plane, written as closures: for pages and tests that need many.

use core::fmt::Debug;
use rotation_dynamics::integrators::size_or;
use rotation_dynamics::planar::contact::{Contact, Mechanism, MechanismState};
use rotation_dynamics::planar::{Condition, Phased};

/// A flow: its derivative in each phase, the conditions that end the phase, and the least size of
/// each number against which its error counts.
#[derive(Debug)]
pub struct Flow<const N: usize, P>(
    pub fn(P, &[f64; N]) -> [f64; N],
    pub fn(P) -> Vec<Condition<'static, P, N>>,
    pub [f64; N],
);

impl<const N: usize, P: Copy + PartialEq + Debug> Phased<N> for Flow<N, P> {
    type Phase = P;
    fn derivative(&self, phase: P, state: &[f64; N]) -> [f64; N] {
        self.0(phase, state)
    }
    fn conditions(&self, phase: P) -> Vec<Condition<'_, P, N>> {
        self.1(phase)
    }
    fn scale(&self, state: &[f64; N]) -> [f64; N] {
        size_or(self.2)(state)
    }
}

/// Bodies, each with one coordinate: their masses (or moments), the constant forces on them, and
/// their contacts.
#[derive(Debug)]
pub struct Bodies<const N: usize, const C: usize, K: Fn(&MechanismState<N>) -> [Contact<N>; C]>(
    pub [f64; N],
    pub [f64; N],
    pub K,
);

impl<const N: usize, const C: usize, K> Mechanism<N, C> for Bodies<N, C, K>
where
    K: Fn(&MechanismState<N>) -> [Contact<N>; C],
{
    fn mass(&self, _: &[f64; N]) -> [[f64; N]; N] {
        let row = |i| core::array::from_fn(|j| if i == j { self.0[i] } else { 0.0 });
        core::array::from_fn(row)
    }
    fn force(&self, _: &MechanismState<N>) -> [f64; N] {
        self.1
    }
    fn contacts(&self, state: &MechanismState<N>) -> [Contact<N>; C] {
        self.2(state)
    }
}
