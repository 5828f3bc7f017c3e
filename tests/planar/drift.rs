//! What rounding moves off the contacts is put back at the end of each step, and only that.

use super::G;
use super::rod::Bead;
use super::rollers::plank::Plank;
use rotation_dynamics::integrators::Dop853;
use rotation_dynamics::math::sincos;
use rotation_dynamics::planar::contact::{Mechanism, MechanismState, Modal, Modes, entry, motion};
use rotation_dynamics::planar::{Condition, Phased, Run, simulate};
use support::{EPS, Errors, assert_error, assert_largest};

/// The same scene, never put back: the damaged twin.
pub struct Adrift<S>(pub S);

impl<const N: usize, S: Phased<N>> Phased<N> for Adrift<S> {
    type Phase = S::Phase;
    fn derivative(&self, phase: S::Phase, state: &[f64; N]) -> [f64; N] {
        self.0.derivative(phase, state)
    }
    fn conditions(&self, phase: S::Phase) -> Vec<Condition<'_, S::Phase, N>> {
        self.0.conditions(phase)
    }
    fn scale(&self, state: &[f64; N]) -> [f64; N] {
        self.0.scale(state)
    }
}

/// The run of a mechanism that is never put back.
pub fn adrift<M: Mechanism<N, C>, const N: usize, const S: usize, const C: usize>(
    mechanism: &M,
    method: &Dop853,
    start: MechanismState<N>,
    t_end: f64,
) -> Run<Modes<C>, S> {
    let (modes, state) = entry(mechanism, start).unwrap();
    let scene = Adrift(Modal(mechanism));
    simulate(&scene, method, modes, state.to_array(), t_end).unwrap()
}

fn tightest() -> Dop853 {
    Dop853::new(1e-15).unwrap()
}

/// A plank that swings between rollers too fast to catch it: nothing happens.
const SWINGS: Plank = Plank { a: 1.2, g: G, kinetic: 0.3, holding: 0.3, speed: 2.0 };
const OFF: f64 = 0.3;

/// Errors of its place over a thousand seconds, where `at` says what it is, in eps of what an
/// eps of the rate does to it.
fn silence(at: impl Fn(f64) -> f64) -> Errors {
    let mut errors = Errors::in_units_of(EPS, "a plank to which nothing happens");
    let rate = (2.0 * SWINGS.kinetic * G / SWINGS.a).sqrt();
    for i in 1..=500 {
        let t = 2.0 * f64::from(i);
        let (_, cos) = sincos(rate * t);
        errors.push_at((at(t) - OFF * cos) / (OFF * (1.0 + rate * t)), t);
    }
    errors
}

#[test]
fn silence_does_not_drift() {
    let start = MechanismState::rest([OFF, 0.0, 0.0]);
    let kept = motion(&SWINGS, &tightest(), start, 1000.0).unwrap();
    assert!(kept.events().is_empty());
    assert_largest!(silence(|t| kept.at(t).unwrap().q[0]), 500, @"1.40");
    let lost: Run<_, 6> = adrift(&SWINGS, &tightest(), start, 1000.0);
    // The damaged twin.
    assert_largest!(silence(|t| lost.at(t).unwrap().1[0]), 500, @"324");
}

/// How much energy a bead on a rod has gained at most in 200 s, 100 swings, and how much it has
/// lost, in parts of what it had.
fn energy(at: impl Fn(f64) -> [f64; 4]) -> [f64; 2] {
    let of = |[_, y, u, v]: [f64; 4]| 0.5 * (u * u + v * v) + G * (1.0 + y);
    let parts = (0..=2000).map(|i| of(at(0.1 * f64::from(i))) / of(at(0.0)) - 1.0);
    parts.fold([0.0, 0.0], |[gained, lost], part| [part.max(gained), part.min(lost)])
}

/// A bead that is put back onto its rod gains round-off, or about its error of a step; without,
/// more than a thousand times as much.
#[test]
fn no_energy_is_gained() {
    let rod = Bead { string: false };
    let start = MechanismState { q: [0.0, -1.0], v: [2.0, 0.0] };
    let energies = |tolerance| {
        let method = Dop853::new(tolerance).unwrap();
        let kept = motion(&rod, &method, start, 200.0).unwrap();
        let lost = adrift(&rod, &method, start, 200.0);
        let kept = energy(|t| {
            let MechanismState { q, v } = kept.at(t).unwrap();
            [q[0], q[1], v[0], v[1]]
        });
        [kept, energy(|t| lost.at(t).unwrap().1)]
    };
    let [[gained, lost], [adrift, _]] = energies(1e-15);
    assert_error!(gained, 3.6e-15);
    assert_error!(lost, 2.8e-14);
    assert!(adrift > 1e3 * gained);
    let [[gained, lost], [adrift, _]] = energies(1e-9);
    assert_error!(gained, 1.1e-9);
    assert_error!(lost, 2.5e-8);
    assert!(adrift > 1e3 * gained);
}
