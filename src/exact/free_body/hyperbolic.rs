//! The sample near the separatrix, where the hyperbolic series converges and a period
//! is long: it counts whole periods and takes its series from the nearest turning point.

use super::sample::Rates;
use super::series::Hyperbolic;
use crate::attitude::Attitude;
use crate::attitude::product::product;
use crate::body::Kinematics;
use crate::frame::BodyVector;
use crate::math::{DoubleDouble as Dd, known, sincos_turns};

/// A motion near the separatrix or on it.
#[derive(Debug, Clone)]
pub(super) struct Late {
    pub series: Hyperbolic,
    pub rates: Rates,
    /// +1 if J3 < J1, else -1: the sense in which the theta functions turn.
    pub sense: f64,
    /// Time from the turning point of the first component to t = 0.
    pub start: Dd,
    /// 2K in time and its reciprocal; None on the separatrix.
    pub half_period: Option<(Dd, f64)>,
    /// Turns gained in `half_period` beyond whole ones, and turns per second inside it.
    pub advance: Dd,
    pub local_rate: Dd,
    /// From the frame along L to space, and from the body to the ordered axes.
    pub outer: [f64; 4],
    pub inner: [f64; 4],
}

impl Late {
    #[inline]
    pub fn kinematics(&self, t: f64) -> Kinematics {
        let since = self.start + known(t, self.series.rate);
        let (rest, phase, parity) = match self.half_period {
            Some((half, per_half)) => {
                let n = (since.hi() * per_half).round();
                // A time whose last bit is many periods falls anywhere: on this side.
                let reach = 0.5 * half.hi();
                let mut rest = since - half * n;
                if rest.hi().abs() > reach {
                    rest = Dd::from(rest.hi().max(-reach).min(reach));
                }
                // Both parts of `rest`: beside a body that is nearly symmetric half a period is
                // many turns long, and its last bit would be felt in the phase.
                let phase = fraction(self.local_rate * rest) + fraction(self.advance * n);
                // theta_1 changes sign over 2K: -1 for odd n.
                (rest.hi(), phase, 1.0 - 2.0 * (n % 2.0).abs())
            }
            None => (since.hi(), fraction(self.local_rate * since), 1.0),
        };
        let ([ar, ai], [br, bi]) = self.series.sum(rest);
        // The constant phase of beta puts l1 > 0 at tau = 0.
        let flip = parity * -self.sense;
        let (ai, br, bi) = (ai * self.sense, br * flip, bi * flip * self.sense);
        let scale = 1.0 / (ar * ar + ai * ai + (br * br + bi * bi)).sqrt();
        let (sin, cos) = sincos_turns(phase);
        let (sin, cos) = (sin * scale, cos * scale);
        let quaternion = [
            ar * cos - ai * sin,
            br * cos - bi * sin,
            br * sin + bi * cos,
            ar * sin + ai * cos,
        ];
        // 2 alpha conj(beta) = l2 + i l1.
        let twice = scale * scale * 2.0;
        let rates = self
            .rates
            .of((ai * br - ar * bi) * twice, (ar * br + ai * bi) * twice);
        Kinematics::new(
            Attitude::from_unit(product(product(self.outer, quaternion), self.inner)),
            BodyVector::from_array(rates),
        )
    }
}

/// The turns beyond whole ones, within [-1/2, 1/2].
fn fraction(turns: Dd) -> f64 {
    // Twice: beyond 2^53 turns the first leaves the trailing part.
    let turns = turns - turns.hi().round();
    (turns - turns.hi().round()).hi()
}
