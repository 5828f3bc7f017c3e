//! The motion as a whole: its kind, turning points, period, advances, conserved quantities.

use super::{Course, HeavyTop, ReducedTop, SymmetricTop};
use crate::math::{self, DoubleDouble as Dd, EPS};

/// The kinds of motion, by what the axis draws on the sphere.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Regime {
    /// Steady precession: theta constant (to what rounding the energy allows).
    Steady,
    /// phi' keeps its sign: a wave.
    Waves,
    /// phi' vanishes at a turning point: cusps.
    Cusps,
    /// phi' changes its sign: loops.
    Loops,
    /// The axis stays vertical, or everything is at rest.
    Sleeping,
    /// Leaves the upright position or returns to it in infinite time.
    Homoclinic,
    /// The axis passes the vertical.
    PassesPole,
    /// L = 0 about the vertical and about the axis: a pendulum in a plane.
    Planar,
}

/// Turning points closer than this (rad) are a steady precession: the square root of
/// what rounding the energy does.
const STEADY_WITHIN: f64 = 1e-7;

impl HeavyTop {
    /// The kind of motion.
    pub fn regime(&self) -> Regime {
        let Course::Moving { motion, .. } = &self.course else {
            return Regime::Sleeping;
        };
        let roots = &motion.roots;
        if motion.m1 == 0.0 {
            return Regime::Homoclinic;
        }
        if self.difference == 0.0 && self.sum == 0.0 {
            return Regime::Planar;
        }
        if motion.channels.iter().any(|channel| channel.reached) {
            return Regime::PassesPole;
        }
        if self.theta_max() - self.theta_min() <= STEADY_WITHIN {
            return Regime::Steady;
        }
        // A - B v at both turning points: the sign of phi'.
        let (difference, sum) = self.in_v();
        let spin = self.spin * self.flip;
        let precession = |x: Dd, y: Dd| {
            if x <= y { difference + spin * x } else { sum - spin * y }
        };
        let at = [precession(roots.x1, roots.y1).to_f64(), precession(roots.x2, roots.y2).to_f64()];
        let rounding = 32.0 * EPS * (sum.abs() + difference.abs()).to_f64();
        if at.iter().any(|rate| rate.abs() <= rounding) {
            Regime::Cusps
        } else if (at[0] < 0.0) != (at[1] < 0.0) {
            Regime::Loops
        } else {
            Regime::Waves
        }
    }

    /// True if the axis passes the vertical exactly, or tends to it: phi and zeta then
    /// jump, and only attitude and theta mean something there.
    pub fn passes_pole(&self) -> bool {
        match &self.course {
            Course::Fixed { theta } => math::sin(*theta).abs() < 1e-15,
            Course::Moving { motion, .. } => {
                motion.m1 == 0.0 || motion.channels.iter().any(|channel| channel.reached)
            }
        }
    }

    /// The smallest theta (rad).
    pub fn theta_min(&self) -> f64 {
        self.turning_points()[0]
    }

    /// The largest theta (rad).
    pub fn theta_max(&self) -> f64 {
        self.turning_points()[1]
    }

    fn turning_points(&self) -> [f64; 2] {
        match &self.course {
            Course::Fixed { theta } => [*theta; 2],
            Course::Moving { motion, .. } => {
                let r = &motion.roots;
                let angle = |x: Dd, y: Dd| x.sqrt().atan2(y.sqrt()).scaled(2.0).to_f64();
                if self.flip > 0.0 {
                    [angle(r.x2, r.y2), angle(r.x1, r.y1)]
                } else {
                    [angle(r.y1, r.x1), angle(r.y2, r.x2)]
                }
            }
        }
    }

    /// The period of theta; infinite for a homoclinic motion and for an axis at rest. For
    /// a steady precession the period of small nutations about it.
    pub fn nutation_period(&self) -> f64 {
        match &self.course {
            Course::Fixed { .. } => f64::INFINITY,
            Course::Moving { motion, .. } => motion.half_period.scaled(2.0).to_f64(),
        }
    }

    /// The advance of phi in one nutation period (rad); 0 without a period.
    pub fn precession_per_period(&self) -> f64 {
        self.advances()[0].to_f64()
    }

    /// The advance of zeta in one nutation period (rad); 0 without a period.
    pub fn spin_per_period(&self) -> f64 {
        self.advances()[1].to_f64()
    }

    fn advances(&self) -> [Dd; 2] {
        let Course::Moving { motion, .. } = &self.course else {
            return [Dd::ZERO; 2];
        };
        if motion.m1 == 0.0 {
            return [Dd::ZERO; 2];
        }
        let period = motion.half_period.scaled(2.0);
        let [a, b] =
            motion.channels.map(|c| c.rate * period - c.step.scaled(2.0) + Dd::PI * c.sign);
        [a + b, (a - b) * self.flip + self.free_spin * period]
    }

    /// The parameter m of the elliptic functions, in [0, 1].
    pub fn parameter(&self) -> f64 {
        match &self.course {
            Course::Fixed { .. } => 0.0,
            Course::Moving { motion, .. } => motion.m.to_f64(),
        }
    }

    /// 1 - m, formed without cancellation.
    pub fn complementary_parameter(&self) -> f64 {
        match &self.course {
            Course::Fixed { .. } => 1.0,
            Course::Moving { motion, .. } => motion.m1.to_f64(),
        }
    }

    /// The dimensionless energy E~; `None` if L_z = 0, which has no such units.
    pub fn energy_reduced(&self) -> Option<f64> {
        if self.body.is_none() {
            return Some(self.excess.scaled(0.5).to_f64());
        }
        // E~ = (alpha - beta) t_unit^2/2, t_unit^2 = (I3/I1)/B^2.
        (self.spin != 0.0)
            .then(|| (self.excess.scaled(0.5) * self.ratio() / self.spin.square()).to_f64())
    }

    /// The dimensionless parameters; `None` if L_z = 0.
    pub fn reduced(&self) -> Option<ReducedTop> {
        if self.reduced.is_some() {
            return self.reduced;
        }
        let body = self.body?;
        if self.spin == 0.0 {
            return None;
        }
        let a = self.ratio();
        // A/B from the sum of A - B and A + B.
        let b = (self.difference + self.sum).scaled(0.5) / self.spin;
        let c = body.moment() / body.i1() * a / self.spin.square();
        ReducedTop::formal(a.to_f64(), b.to_f64(), c.to_f64()).ok()
    }

    /// The unit of time sqrt(I1 I3)/L_z (s), with the sign of L_z; 1 for a dimensionless
    /// top, `None` if L_z = 0.
    pub fn time_unit(&self) -> Option<f64> {
        if self.body.is_none() {
            return Some(1.0);
        }
        (self.spin != 0.0).then(|| (self.ratio().sqrt() / self.spin).to_f64())
    }

    /// The body, if the motion was made from one.
    pub const fn body(&self) -> Option<SymmetricTop> {
        self.body
    }

    /// The momenta L_Z about the vertical and L_z about the axis; for a dimensionless top
    /// in units with I1 = 1, I3 = a.
    pub fn momenta(&self) -> (f64, f64) {
        let i1 = self.moments[0];
        let vertical = (self.difference + self.sum).scaled(0.5) * i1;
        (vertical.to_f64(), (self.spin * i1).to_f64())
    }

    /// Energy T + U (J), U = m g l cos(theta); for a dimensionless top in units with
    /// I1 = 1, I3 = a, m g l = c.
    pub fn energy(&self) -> f64 {
        let [i1, i3] = self.moments;
        let moment = match (&self.body, &self.reduced) {
            (Some(body), _) => body.moment(),
            (None, Some(top)) => Dd::from(top.c()),
            (None, None) => Dd::ZERO,
        };
        // I1 (alpha - beta)/2 = T_transverse - m g l (1 - cos).
        let energy = self.excess * i1 + self.omega3.square() * i3;
        (energy.scaled(0.5) + moment).to_f64()
    }

    /// I3/I1.
    fn ratio(&self) -> Dd {
        Dd::from(self.moments[1]) / self.moments[0]
    }

    /// A - B and A + B in v.
    fn in_v(&self) -> (Dd, Dd) {
        if self.flip > 0.0 { (self.difference, self.sum) } else { (self.sum, self.difference) }
    }
}
