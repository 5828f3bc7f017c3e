//! One nod of a gyroscope in gimbals without friction, by quadrature.

use super::{Gimbals, Pose};
use core::f64::consts::{PI, TAU};
use rotation_dynamics::error::{Error, Result};
use rotation_dynamics::math::{EPS, acos, atan2, cos, sin, sincos};

/// One nod: the tilts between which the axis goes, and the motion in the time.
///
/// With w = cos theta_0 - cos theta, counted from the present tilt, P N theta'^2 = G(w) is a cubic.
/// Its coefficients come from the rates without cancellation; a release at rest has w as a factor.
/// The turning points are its roots next to 0, and
///
/// dt = sqrt(P N/G) dtheta,  dphi = phi' dt,  phi' = (N_0 phi_0' + L_z w)/N,
///
/// are integrated over an angle in which both turning points are smooth. The integrand is then
/// periodic and the trapezoidal rule converges faster than any power of the number of points.
///
/// An axis with energy enough passes through the vertical (the fork's inertia keeps phi' finite
/// there). Then the tilts are on both sides of it, `theta_min` is negative or `theta_max` greater
/// than pi, or the axis goes right round and they are 2 pi apart.
///
/// Accuracy, as measured: without gimbals within 5.2 eps of
/// [`HeavyTop`](rotation_dynamics::exact::heavy_top::HeavyTop) (advances over 1/sin^2 of the closest
/// approach to the vertical); with gimbals, through the vertical and right round, within 9e-14
/// of DOP853 at 1e-14. Cost: some dozens of
/// points, more near a separatrix.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NutationCycle {
    /// The smallest tilt, rad.
    pub theta_min: f64,
    /// The greatest tilt, rad.
    pub theta_max: f64,
    /// The time from one of them back to it, s.
    pub period: f64,
    /// Advance of phi in that time, rad.
    pub precession: f64,
    /// Advance of zeta in that time, rad.
    pub spin: f64,
}

/// The shape of the motion between the turning points.
enum Way {
    /// Between two tilts: the values of w.
    Between(f64, f64),
    /// Through theta = 0, down to this w on either side.
    OverTop(f64),
    /// Through theta = pi, up to this w on either side.
    UnderBottom(f64),
    /// Through both.
    Round,
}

/// G(w) = g0 + g1 w + g2 w^2 + g3 w^3.
struct Cubic([f64; 4]);

impl Cubic {
    fn at(&self, w: f64) -> f64 {
        let [g0, g1, g2, g3] = self.0;
        g0 + w * (g1 + w * (g2 + w * g3))
    }

    /// G without the factor w, for a start at which G vanishes.
    const fn without_start(&self) -> Self {
        let [_, g1, g2, g3] = self.0;
        Self([g1, g2, g3, 0.0])
    }

    /// The root between 0, where it is not negative, and `end` that is nearest to 0; none if
    /// it is positive all the way.
    fn root_towards(&self, end: f64) -> Option<f64> {
        let [_, g1, g2, g3] = self.0;
        // Between its extremes a cubic has one root at most.
        let square = g2 * g2 - 3.0 * g1 * g3;
        let mut marks = [end; 3];
        if square >= 0.0 {
            let q = -(g2 + g2.signum() * square.sqrt());
            let within = |w: f64| w * end > 0.0 && w.abs() < end.abs();
            marks = [q / (3.0 * g3), g1 / q, end].map(|w| if within(w) { w } else { end });
            if marks[0].abs() > marks[1].abs() {
                marks.swap(0, 1);
            }
        }
        let mut inside = 0.0;
        for mut outside in marks {
            if self.at(outside) > 0.0 {
                inside = outside;
                continue;
            }
            loop {
                let middle = 0.5 * (inside + outside);
                if middle == inside || middle == outside {
                    return Some(outside);
                }
                if self.at(middle) >= 0.0 {
                    inside = middle;
                } else {
                    outside = middle;
                }
            }
        }
        None
    }
}

impl NutationCycle {
    /// The nod on which `gimbals` are at this pose.
    ///
    /// # Errors
    /// A pose that is not finite; an axis at the vertical without anything to turn there
    /// (N = 0); [`Error::NotDelivered`] on a separatrix, where a nod takes for ever.
    pub fn of(gimbals: &Gimbals, at: &Pose) -> Result<Self> {
        at.check()?;
        let (s0, u0) = sincos(at.theta);
        let (p, d, weight) = (gimbals.tilting(), gimbals.excess(), gimbals.weight_moment());
        let (n0, axial) = (gimbals.turning(at.theta), at.axial_momentum);
        let walk = n0 * at.phi_rate;
        // Twice the kinetic energy of nod and walk.
        let nodding = p * at.theta_rate * at.theta_rate;
        let moving = nodding + walk * at.phi_rate;
        let cubic = Cubic([
            nodding * n0,
            2.0 * (moving * d * u0 + weight * n0 - walk * axial),
            4.0 * weight * d * u0 - moving * d - axial * axial,
            -2.0 * weight * d,
        ]);
        let [_, g1, g2, g3] = cubic.0;
        let (top, bottom) = (u0 - 1.0, u0 + 1.0);
        let [above, below] = if nodding > 0.0 {
            [cubic.root_towards(top), cubic.root_towards(bottom)]
        } else if g1 == 0.0 {
            [Some(0.0); 2]
        } else {
            let [g1, g2, g3, _] = cubic.without_start().0;
            let sign = g1.signum();
            let rest = Cubic([sign * g1, sign * g2, sign * g3, 0.0]);
            if g1 > 0.0 {
                [Some(0.0), rest.root_towards(bottom)]
            } else {
                [rest.root_towards(top), Some(0.0)]
            }
        };
        let way = match (above, below) {
            (Some(a), Some(b)) => Way::Between(a, b),
            (None, Some(b)) => Way::OverTop(b),
            (Some(a), None) => Way::UnderBottom(a),
            (None, None) => Way::Round,
        };
        let turning = |u: f64| gimbals.turning(0.0) + d * (1.0 - u) * (1.0 + u);
        // G without the factor (w_1 - w) or (w - w_1), up to sign.
        let without = |w1: f64, w: f64| {
            let b = g2 + g3 * w1;
            (g3 * w + b) * w + g1 + b * w1
        };
        let tilt = |w: f64| {
            // Of small w the difference of the tilts, not of their cosines.
            let (near, u) = (atan2(s0, u0), u0 - w);
            if w == 0.0 { near.abs() } else { acos(u.clamp(-1.0, 1.0)) }
        };
        // w and dt/dpsi, over a full turn of psi.
        let step = |psi: f64| match way {
            Way::Between(w1, w2) => {
                let w = 0.5 * (w1 + w2) - 0.5 * (w2 - w1) * cos(psi);
                let u = u0 - w;
                let left = -(g2 + g3 * (w1 + w2 + w));
                (w, (p * turning(u) / ((1.0 - u) * (1.0 + u) * left)).sqrt())
            }
            Way::OverTop(w1) => {
                let (half, c) = (0.5 * (1.0 - (u0 - w1)), sin(psi));
                let square = half * c * c;
                let w = u0 - 1.0 + 2.0 * square;
                let n = turning(u0 - w);
                (w, (2.0 * p * n / (-without(w1, w) * (1.0 - square))).sqrt())
            }
            Way::UnderBottom(w1) => {
                let (half, c) = (0.5 * (1.0 + (u0 - w1)), sin(psi));
                let square = half * c * c;
                let w = u0 + 1.0 - 2.0 * square;
                let n = turning(u0 - w);
                (w, (2.0 * p * n / (without(w1, w) * (1.0 - square))).sqrt())
            }
            Way::Round => {
                let w = u0 - cos(psi);
                (w, (p * turning(u0 - w) / cubic.at(w)).sqrt())
            }
        };
        let i3 = gimbals.rotor().i3();
        let [period, precession, spin] = around(|psi| {
            let (w, dt) = step(psi);
            let u = u0 - w;
            let rate = (walk + axial * w) / turning(u);
            [dt, rate * dt, (axial / i3 - rate * u) * dt]
        })?;
        let [theta_min, theta_max] = match way {
            Way::Between(w1, w2) => [tilt(w1), tilt(w2)],
            Way::OverTop(w1) => [-tilt(w1), tilt(w1)],
            Way::UnderBottom(w1) => [tilt(w1), TAU - tilt(w1)],
            Way::Round => [-PI, PI],
        };
        Ok(Self { theta_min, theta_max, period, precession, spin })
    }
}

/// The integral of a smooth periodic function over a turn.
fn around(f: impl Fn(f64) -> [f64; 3]) -> Result<[f64; 3]> {
    let sums = |points: u32| -> [f64; 3] {
        let (mut sums, mut lost) = ([0.0; 3], [0.0; 3]);
        let step = TAU / f64::from(points);
        for k in 0..points {
            let values = f(step * (f64::from(k) + 0.5));
            for i in 0..3 {
                // With what the additions have lost so far (Kahan).
                let term = values[i] * step - lost[i];
                let sum: f64 = sums[i] + term;
                lost[i] = (sum - sums[i]) - term;
                sums[i] = sum;
            }
        }
        sums
    };
    let (mut points, mut last, mut change) = (16, sums(16), f64::INFINITY);
    while points < 1 << 16 {
        points *= 2;
        let next = sums(points);
        let changes = (0..3).map(|i| ((next[i] - last[i]) / next[i].abs().max(next[0])).abs());
        let now = changes.fold(0.0, |a: f64, b| if b > a || b.is_nan() { b } else { a });
        let stalled = now >= change && change < 1e-12;
        (last, change) = (next, now);
        if stalled || change <= 4.0 * EPS {
            return Ok(last);
        }
    }
    Err(Error::NotDelivered { requested: 4.0 * EPS, best: change, condition: None })
}

#[cfg(test)]
mod tests {
    use super::*;
    use core::f64::consts::TAU;
    use rotation_dynamics::attitude::{Attitude, EulerAngles};
    use rotation_dynamics::exact::heavy_top::{HeavyTop, SymmetricTop};
    use rotation_dynamics::frame::BodyVector;

    /// Without ring and fork it is the nod of the heavy top.
    #[test]
    fn light_gimbals_nod_as_the_top() {
        let rotor = SymmetricTop::new(5.45e-3, 9.0e-4, 4.9, 0.1).expect("a rotor");
        let gimbals = Gimbals::new(rotor, [0.0; 3], 0.0).expect("gimbals");
        let (theta, spin) = (1.0, 300.0);
        let nod = NutationCycle::of(&gimbals, &gimbals.released(theta, spin)).expect("a nod");
        let start = EulerAngles { phi: 0.0, theta, zeta: 0.0 };
        let start = Attitude::from_euler(start).expect("an attitude");
        let top = HeavyTop::new(rotor, start, BodyVector::new(0.0, 0.0, spin)).expect("a top");
        let turned = (nod.precession - top.precession_per_period()) / TAU;
        assert!((turned - turned.round()).abs() < 1e-12, "{turned}");
        assert!((nod.period / top.nutation_period() - 1.0).abs() < 1e-10);
    }
}
