//! The usual mistake: contacts that are never allowed to let go.

use super::{Condition, Kind, Phased};

/// The scene with every contact kept for ever, pulling where it ought to let go.
///
/// This is what a solver does that treats a wall as a constraint. It is here to be
/// compared with the scene itself, not to be used.
#[derive(Debug, Clone, Copy)]
pub struct Bilateral<S>(pub S);

impl<const N: usize, S: Phased<N>> Phased<N> for Bilateral<S> {
    type Phase = S::Phase;

    fn derivative(&self, phase: S::Phase, state: &[f64; N]) -> [f64; N] {
        self.0.derivative(phase, state)
    }

    fn conditions(&self, phase: S::Phase) -> Vec<Condition<'_, S::Phase, N>> {
        let mut conditions = self.0.conditions(phase);
        conditions.retain(|condition| condition.kind != Kind::Contact);
        conditions
    }

    fn scale(&self, state: &[f64; N]) -> [f64; N] {
        self.0.scale(state)
    }

    fn drift(&self, phase: S::Phase, state: &[f64; N], within: f64) -> Option<[f64; N]> {
        self.0.drift(phase, state, within)
    }

    fn phase_limit(&self) -> usize {
        self.0.phase_limit()
    }
}
