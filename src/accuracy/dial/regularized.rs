//! Pieces of a motion in a time in which a root of the time is smooth.

use crate::body::State;
use crate::effects::AnyEffect;
use crate::error::Result;
use crate::integrators::scene::{components, state};
use crate::integrators::{Dop853, Integrator, Ode, Work};
use crate::scene::Scene;

/// The time s in which a piece is stepped, from 0 to `span` like the time t of the motion.
///
/// It is t itself, or beside a singular end its square: with u = s/span
///
/// ```text
/// t/span = u^2 (start),   1 - (1 - u)^2 (end),   u^2 (3 - 2 u) (both).
/// ```
///
/// What goes like a power n/2 of the time beside such an end goes like a whole power of s, so a method
/// has its order again; what goes like another power p goes like 2 p, and has twice the order it had. Source: the substitution by which quadrature takes singularities at an end
/// (P. J. Davis and P. Rabinowitz, Methods of Numerical Integration, chapter 2).
#[derive(Debug, Clone, Copy)]
pub(super) struct Regularized {
    pub span: f64,
    /// The start, and the end, beside which the torque goes like a root of the time.
    pub singular: [bool; 2],
}

/// A system in that time.
struct InItsTime<'o, O> {
    piece: Regularized,
    ode: &'o O,
}

impl Regularized {
    /// t, and dt/ds.
    fn time(&self, s: f64) -> [f64; 2] {
        let u = s / self.span;
        let [part, rate] = match self.singular {
            [false, false] => return [s, 1.0],
            [true, false] => [u * u, 2.0 * u],
            [false, true] => [u * (2.0 - u), 2.0 * (1.0 - u)],
            [true, true] => [u * u * (3.0 - 2.0 * u), 6.0 * u * (1.0 - u)],
        };
        [self.span * part, rate]
    }

    /// The most that dt/ds is.
    pub const fn fastest(&self) -> f64 {
        match self.singular {
            [false, false] => 1.0,
            [true, true] => 1.5,
            _ => 2.0,
        }
    }

    /// The state at the end of the piece.
    ///
    /// # Errors
    /// What the method refuses.
    pub fn advance<E: AnyEffect>(
        self,
        method: &Dop853,
        scene: &Scene<E>,
        start: &State,
        work: &mut Work,
    ) -> Result<State> {
        state(&self.end(method, scene, &components(start), work)?)
    }

    /// The same of any system by its components.
    ///
    /// # Errors
    /// What the method refuses.
    pub fn end<const N: usize>(
        self,
        method: &Dop853,
        ode: &impl Ode<N>,
        start: &[f64; N],
        work: &mut Work,
    ) -> Result<[f64; N]> {
        let system = InItsTime { piece: self, ode };
        method.advance_counting(&system, 0.0, start, self.span, work)
    }
}

impl<const N: usize, O: Ode<N>> Ode<N> for InItsTime<'_, O> {
    fn derivative(&self, s: f64, y: &[f64; N]) -> [f64; N] {
        let [t, fast] = self.piece.time(s);
        self.ode.derivative(t, y).map(|rate| fast * rate)
    }

    fn scale(&self, y: &[f64; N]) -> [f64; N] {
        self.ode.scale(y)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::integrators::ode;
    use crate::math::{exp, log};
    use support::Errors;

    const EVERY: [[bool; 2]; 4] = [[false, false], [true, false], [false, true], [true, true]];

    const STRENGTH: f64 = 5.0;

    /// t runs from 0 to the span, forwards or backwards, with dt/ds as its slope and no faster than
    /// is said.
    #[test]
    fn the_time_is_that_of_the_motion() {
        let mut slopes = Errors::of("dt/ds");
        for (span, singular) in [2.0, -3.0]
            .iter()
            .flat_map(|span| EVERY.map(|s| (*span, s)))
        {
            let piece = Regularized { span, singular };
            assert_eq!(piece.time(0.0)[0], 0.0);
            assert_eq!(piece.time(span)[0], span);
            let mut fastest = 0.0_f64;
            for n in 0..=100 {
                let s = span * f64::from(n) / 100.0;
                let rate = piece.time(s)[1];
                let slope = support::derivative(|s| piece.time(s)[0], s, 1e-3);
                slopes.push_at(rate - slope, (span, singular, n));
                fastest = fastest.max(rate);
            }
            assert_eq!(fastest, piece.fastest());
        }
        slopes.attain(6.2e-13..=6.3e-13, 2 * 4 * 101);
    }

    /// The power of the length of the steps with which the error falls, of y' = 5 y times the root of
    /// the distance to each singular end: in the time s, and in that of the motion.
    fn orders(singular: [bool; 2]) -> [f64; 2] {
        let exact = match singular {
            [true, true] => core::f64::consts::PI / 8.0,
            _ => 2.0 / 3.0,
        };
        let error = |taken: [bool; 2], steps: f64| {
            let root = |n: usize, distance: f64| if singular[n] { distance.sqrt() } else { 1.0 };
            let growth = |t: f64| STRENGTH * root(0, t) * root(1, 1.0 - t);
            let ode = ode(|t, [y]: &[f64; 1]| [y * growth(t)]);
            let method = Dop853::new(0.1).and_then(|m| m.with_longest_step(1.0 / steps));
            let piece = Regularized {
                span: 1.0,
                singular: taken,
            };
            let end = method.and_then(|m| piece.end(&m, &ode, &[1.0], &mut Work::default()));
            let [end] = end.expect("a motion without a step too many");
            (end / exp(STRENGTH * exact) - 1.0).abs()
        };
        [singular, [false; 2]]
            .map(|taken| log(error(taken, 16.0) / error(taken, 32.0)) / core::f64::consts::LN_2)
    }

    /// DOP853 has its order of 8, as nearly as steps show it that are alike but for the first; the
    /// damaged twin, in the time of the motion, has one and a half at most.
    #[test]
    fn a_root_at_an_end_takes_no_order() {
        let mut ran = 0;
        for (singular, measured) in EVERY[1..].iter().zip([8.12, 7.04, 7.79]) {
            let [order, damaged] = orders(*singular);
            assert!((order - measured).abs() < 0.05, "{singular:?}: {order}");
            assert!(damaged < 1.51, "{singular:?}: {damaged}");
            ran += 1;
        }
        assert_eq!(ran, 3);
    }
}
