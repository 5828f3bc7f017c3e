//! What can be asked of a motion.

use super::motion::{Motion, Place};
use super::series::Pair;
use super::{Course, HeavyTop, ReducedTop, SymmetricTop, Turns};
use crate::attitude::{Attitude, EulerAngles};
use crate::frame::{BodyVector, SpaceVector};
use crate::math::{self, DoubleDouble as Dd, EPS};
use nalgebra::Complex;

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

/// Both Cayley-Klein parameters at a time, up to a common positive factor.
struct Sample {
    alpha: Complex<f64>,
    beta: Complex<f64>,
    /// |alpha|^2 + |beta|^2.
    norm: f64,
}

impl HeavyTop {
    /// The Euler angles at time `t`: phi and zeta continuous, not reduced modulo 2 pi.
    ///
    /// theta is in [0, pi]. Where the axis passes a pole exactly, phi jumps by pi
    /// there and zeta with it; the attitude does not.
    pub fn angles(&self, t: f64) -> EulerAngles {
        let (motion, _) = match &self.course {
            Course::Fixed { theta } => {
                return EulerAngles {
                    phi: self.phi0,
                    theta: *theta,
                    zeta: self.zeta0 + (self.omega3 * t).to_f64(),
                };
            }
            Course::Moving { motion, turns } => (motion, turns),
        };
        let place = motion.place(t);
        let pair = motion.pair(&place);
        let arguments = motion.arguments(&place, &pair);
        let half_turns = motion.half_turns(&place);
        let [a, b] = [0, 1].map(|i| {
            let channel = &motion.channels[i];
            let turns = half_turns[i] - channel.initial_half_turns;
            let even = channel.rate * t - channel.step * place.count + Dd::PI * turns;
            (even, arguments[i] - channel.initial)
        });
        let phi = (a.0 + b.0) + (a.1 + b.1) + self.phi0;
        let difference = ((a.0 - b.0) + (a.1 - b.1)) * self.flip;
        let zeta = difference + self.free_spin * t + self.zeta0;
        let (sin, cos) = self.half_angle(pair.a, pair.b);
        EulerAngles {
            phi: phi.to_f64(),
            theta: 2.0 * math::atan2(sin, cos),
            zeta: zeta.to_f64(),
        }
    }

    /// The attitude at time `t`.
    pub fn attitude(&self, t: f64) -> Attitude {
        match &self.course {
            Course::Fixed { .. } => self.fixed_attitude(t),
            Course::Moving { motion, turns } => attitude_of(&self.sample(motion, turns, t)),
        }
    }

    /// cos(theta) at time `t`.
    pub fn cos_theta(&self, t: f64) -> f64 {
        match &self.course {
            Course::Fixed { theta } => math::cos(*theta),
            Course::Moving { motion, .. } => {
                let pair = motion.pair(&motion.place(t));
                let (a, b) = (pair.a.norm_sqr(), pair.b.norm_sqr());
                self.flip * (a - b) / (a + b)
            }
        }
    }

    /// The body axis e3 at time `t`, on the fixed axes.
    pub fn axis(&self, t: f64) -> SpaceVector {
        self.attitude(t).axis()
    }

    /// theta' at time `t`. At the instant of a passage through a pole it is the rate at
    /// which the axis leaves it.
    pub fn theta_rate(&self, t: f64) -> f64 {
        match &self.course {
            Course::Fixed { .. } => 0.0,
            Course::Moving { motion, .. } => {
                let place = motion.place(t);
                let [alpha, beta, transverse] = self.transverse(motion, &place);
                let norm = alpha.norm_sqr() + beta.norm_sqr();
                // e^{i zeta} is alpha conj(beta) over its size.
                let product = alpha * beta.conj();
                let size = math::hypot(product.re, product.im);
                if size > 0.0 {
                    (transverse * product).re / (size * norm)
                } else {
                    math::hypot(transverse.re, transverse.im) / norm
                }
            }
        }
    }

    /// phi' at time `t`; infinite at a pole only if the axis stays there.
    pub fn phi_rate(&self, t: f64) -> f64 {
        let Course::Moving { motion, .. } = &self.course else {
            return 0.0;
        };
        let pair = motion.pair(&motion.place(t));
        self.phi_rate_of(pair.a, pair.b)
    }

    /// zeta' at time `t`.
    pub fn zeta_rate(&self, t: f64) -> f64 {
        let Course::Moving { motion, .. } = &self.course else {
            return self.omega3.to_f64();
        };
        let pair = motion.pair(&motion.place(t));
        let (a, b) = (pair.a.norm_sqr(), pair.b.norm_sqr());
        let cos = self.flip * (a - b) / (a + b);
        self.omega3.to_f64() - self.phi_rate_of(pair.a, pair.b) * cos
    }

    /// The angular velocity at time `t`, on the body axes.
    pub fn angular_velocity(&self, t: f64) -> BodyVector {
        match &self.course {
            Course::Fixed { .. } => BodyVector::new(0.0, 0.0, self.omega3.to_f64()),
            Course::Moving { motion, turns } => self.rates_at(motion, turns, t).1,
        }
    }

    /// Attitude and angular velocity at time `t`, for little more than the price of one.
    pub fn state(&self, t: f64) -> (Attitude, BodyVector) {
        match &self.course {
            Course::Fixed { .. } => (self.fixed_attitude(t), self.angular_velocity(t)),
            Course::Moving { motion, turns } => {
                let (sample, omega) = self.rates_at(motion, turns, t);
                (attitude_of(&sample), omega)
            }
        }
    }

    /// The angular momentum about the pivot at time `t`, on the fixed axes.
    ///
    /// For a dimensionless top in units with I1 = 1, I3 = a.
    pub fn angular_momentum(&self, t: f64) -> SpaceVector {
        let (attitude, omega) = self.state(t);
        let [i1, i3] = self.moments;
        attitude.to_space(BodyVector::new(
            i1 * omega.x(),
            i1 * omega.y(),
            i3 * omega.z(),
        ))
    }

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
            if x <= y {
                difference + spin * x
            } else {
                sum - spin * y
            }
        };
        let at = [
            precession(roots.x1, roots.y1).to_f64(),
            precession(roots.x2, roots.y2).to_f64(),
        ];
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
        let [a, b] = motion
            .channels
            .map(|c| c.rate * period - c.step.scaled(2.0) + Dd::PI * c.sign);
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

    /// The unit of time sqrt(I1 I3)/L_z [s], with the sign of L_z; 1 for a dimensionless
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

    /// Energy T + U [J], U = m g l cos(theta); for a dimensionless top in units with
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
        if self.flip > 0.0 {
            (self.difference, self.sum)
        } else {
            (self.sum, self.difference)
        }
    }

    fn fixed_attitude(&self, t: f64) -> Attitude {
        let EulerAngles { phi, theta, .. } = self.angles(0.0);
        let turn = self.omega3 * t / Dd::TWO_PI;
        let turn = turn - turn.round();
        let zeta = turn * Dd::TWO_PI + self.zeta0;
        let (sin, cos) = math::sincos(0.5 * theta);
        // Exactly at a pole the zero component stays zero.
        let sin = if theta == 0.0 { 0.0 } else { sin };
        let cos = if theta == core::f64::consts::PI {
            0.0
        } else {
            cos
        };
        let (sin_sum, cos_sum) = (zeta + phi).scaled(0.5).sin_cos();
        let (sin_difference, cos_difference) = (-zeta + phi).scaled(0.5).sin_cos();
        Attitude::from_unit([
            cos * cos_sum.to_f64(),
            sin * cos_difference.to_f64(),
            sin * sin_difference.to_f64(),
            cos * sin_sum.to_f64(),
        ])
    }

    /// sin and cos of theta/2 up to a common factor.
    fn half_angle(&self, a: Complex<f64>, b: Complex<f64>) -> (f64, f64) {
        let (a, b) = (math::hypot(a.re, a.im), math::hypot(b.re, b.im));
        if self.flip > 0.0 { (b, a) } else { (a, b) }
    }

    /// (A - B u)/sin^2 from whichever pole is nearer.
    fn phi_rate_of(&self, a: Complex<f64>, b: Complex<f64>) -> f64 {
        let (a, b) = (a.norm_sqr(), b.norm_sqr());
        let (alpha, beta) = if self.flip > 0.0 { (a, b) } else { (b, a) };
        let norm = alpha + beta;
        let (alpha, beta) = (alpha / norm, beta / norm);
        let spin = 2.0 * self.spin.to_f64();
        let per = |momentum: f64, part: f64| {
            if momentum == 0.0 {
                0.0
            } else {
                momentum / part
            }
        };
        if beta <= alpha {
            (per(self.difference.to_f64(), beta) + spin) / (4.0 * alpha)
        } else {
            (per(self.sum.to_f64(), alpha) - spin) / (4.0 * beta)
        }
    }

    #[inline]
    fn sample(&self, motion: &Motion, turns: &[Turns; 2], t: f64) -> Sample {
        let place = motion.place(t);
        let (alpha, beta) = self.ordered(motion.pair(&place));
        let norm = alpha.norm_sqr() + beta.norm_sqr();
        let [turn_alpha, turn_beta] = factors(turns, &place, t);
        Sample {
            alpha: alpha * turn_alpha,
            beta: beta * turn_beta,
            norm,
        }
    }

    /// alpha and beta from the parameters in v.
    #[inline]
    fn ordered(&self, pair: Pair) -> (Complex<f64>, Complex<f64>) {
        if self.flip > 0.0 {
            (pair.a, pair.b)
        } else {
            (pair.b, pair.a)
        }
    }

    /// Before the phases: alpha, beta, and omega_1 + i omega_2 times |alpha|^2 + |beta|^2.
    #[inline]
    fn transverse(&self, motion: &Motion, place: &Place) -> [Complex<f64>; 3] {
        let (pair, slopes) = motion.pair_with_slopes(place);
        let [a, b] = &motion.channels;
        let (alpha, beta) = self.ordered(pair);
        let (d_alpha, d_beta) = self.ordered(slopes);
        // omega_1 + i omega_2 = 2 (conj(alpha) beta' - beta conj(alpha)').
        let wronskian = alpha.conj() * d_beta - beta * d_alpha.conj();
        let phases = Complex::new(0.0, a.rate.hi() + b.rate.hi()) * (alpha.conj() * beta);
        [alpha, beta, (wronskian * motion.rate + phases) * 2.0]
    }

    #[inline]
    fn rates_at(&self, motion: &Motion, turns: &[Turns; 2], t: f64) -> (Sample, BodyVector) {
        let place = motion.place(t);
        let [alpha, beta, transverse] = self.transverse(motion, &place);
        let norm = alpha.norm_sqr() + beta.norm_sqr();
        let [turn_alpha, turn_beta] = factors(turns, &place, t);
        let omega = transverse * (turn_alpha.conj() * turn_beta) / norm;
        let sample = Sample {
            alpha: alpha * turn_alpha,
            beta: beta * turn_beta,
            norm,
        };
        let omega = BodyVector::new(omega.re, omega.im, self.omega3.to_f64());
        (sample, omega)
    }
}

/// The phase factors of alpha and beta, with the sign that makes the quaternion continuous.
#[inline]
fn factors(turns: &[Turns; 2], place: &Place, t: f64) -> [Complex<f64>; 2] {
    let sign = if place.period & 1 == 0 { 1.0 } else { -1.0 };
    [&turns[0], &turns[1]].map(|turns| {
        let (sin, cos) = math::sincos(turns.phase(t, place.count));
        Complex::new(sign * cos, sign * sin)
    })
}

/// The unit quaternion (Re alpha, Re beta, Im beta, Im alpha).
#[inline]
fn attitude_of(sample: &Sample) -> Attitude {
    let scale = 1.0 / sample.norm.sqrt();
    Attitude::from_unit([
        sample.alpha.re * scale,
        sample.beta.re * scale,
        sample.beta.im * scale,
        sample.alpha.im * scale,
    ])
}
