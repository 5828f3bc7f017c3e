//! The motion at a given time: angles, attitude, rates.

use super::construct::UP;
use super::motion::{Motion, Place};
use super::series::Pair;
use super::{Course, Form, HeavyTop};
use crate::attitude::{Attitude, EulerAngles};
use crate::body::{Kinematics, State};
use crate::error::{Result, known};
use crate::exact::batch::{LOST, Sampled};
use crate::frame::{BodyVector, SpaceVector};
use crate::math::{self, DoubleDouble as Dd};
use nalgebra::Complex;

impl HeavyTop {
    /// The Euler angles at time `t`: phi and zeta continuous, not reduced modulo 2 pi.
    ///
    /// theta is in [0, pi]. Where the axis passes a pole exactly, phi jumps by pi
    /// there and zeta with it; the attitude does not. `t`: in t' or seconds. NaN at a time that
    /// [`HeavyTop::try_angles`] refuses.
    ///
    /// Accuracy: K = 1.9 for phi and zeta, 1.2 for theta; see [`HeavyTop`].
    /// Source: the notes, 16.2 (4)-(6), solved.
    pub fn angles(&self, t: f64) -> EulerAngles {
        if !self.is_known(t) {
            return EulerAngles { phi: f64::NAN, theta: f64::NAN, zeta: f64::NAN };
        }
        let motion = match &self.course {
            Course::Fixed { theta } => {
                return EulerAngles {
                    phi: self.phi0,
                    theta: *theta,
                    zeta: self.zeta0 + self.spun(t).to_f64(),
                };
            }
            Course::Moving { motion, .. } => motion,
        };
        let place = motion.place(t);
        let pair = motion.pair(&place);
        let (sin, cos) = self.half_angle(pair.a, pair.b);
        let theta = 2.0 * math::atan2(sin, cos);
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
        EulerAngles { phi: phi.to_f64(), theta, zeta: zeta.to_f64() }
    }

    /// The same as [`HeavyTop::angles`].
    ///
    /// # Errors
    /// As [`HeavyTop::try_attitude`].
    pub fn try_angles(&self, t: f64) -> Result<EulerAngles> {
        Ok(self.angles(known(t, self.latest)?))
    }

    /// True if the phases are known at this time.
    #[inline]
    fn is_known(&self, t: f64) -> bool {
        t.abs() <= self.latest
    }

    /// The attitude at time `t`; the quaternion is continuous in time.
    ///
    /// NaN at a time that [`HeavyTop::try_attitude`] refuses.
    ///
    /// Accuracy: K = 1.5 for the elements of the matrix; see [`HeavyTop`].
    pub fn attitude(&self, t: f64) -> Attitude {
        match &self.course {
            Course::Fixed { .. } => self.kinematics(t).attitude,
            Course::Moving { form, .. } => match form {
                Form::Trigonometric(sampler) => sampler.attitude(t),
                Form::Hyperbolic(late) => late.attitude(t),
            },
        }
    }

    /// The same as [`HeavyTop::attitude`].
    ///
    /// # Errors
    /// `NotFinite` for a time that is not finite; `PhaseLost` for one so late that the phase is
    /// lost ([how late](crate::exact#how-late)).
    pub fn try_attitude(&self, t: f64) -> Result<Attitude> {
        Ok(self.attitude(known(t, self.latest)?))
    }

    /// cos(theta) at time `t`; NaN, as the rates that follow, where the phases are not known.
    pub fn cos_theta(&self, t: f64) -> f64 {
        if !self.is_known(t) {
            return f64::NAN;
        }
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
        if !self.is_known(t) {
            return f64::NAN;
        }
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
        if !self.is_known(t) {
            return f64::NAN;
        }
        let Course::Moving { motion, .. } = &self.course else {
            return 0.0;
        };
        let pair = motion.pair(&motion.place(t));
        self.phi_rate_of(pair.a, pair.b)
    }

    /// zeta' at time `t`.
    pub fn zeta_rate(&self, t: f64) -> f64 {
        if !self.is_known(t) {
            return f64::NAN;
        }
        let Course::Moving { motion, .. } = &self.course else {
            return self.omega3.to_f64();
        };
        let pair = motion.pair(&motion.place(t));
        let (a, b) = (pair.a.norm_sqr(), pair.b.norm_sqr());
        let cos = self.flip * (a - b) / (a + b);
        self.omega3.to_f64() - self.phi_rate_of(pair.a, pair.b) * cos
    }

    /// The angular velocity at time `t`, on the body axes.
    ///
    /// omega_1 + i omega_2 = 2 (conj(alpha) beta' - beta conj(alpha)'), regular at the poles.
    /// Accuracy: K = 2.5; see [`HeavyTop`].
    pub fn angular_velocity(&self, t: f64) -> BodyVector {
        self.kinematics(t).angular_velocity
    }

    /// Attitude and angular velocity at time `t`, for little more than the price of one.
    ///
    /// NaN at a time that [`HeavyTop::try_kinematics`] refuses.
    pub fn kinematics(&self, t: f64) -> Kinematics {
        match &self.course {
            Course::Fixed { .. } if !self.is_known(t) => {
                Kinematics::new(Attitude::from_unit(LOST.0), BodyVector::from_array(LOST.1))
            }
            Course::Fixed { .. } => {
                let rates = BodyVector::new(0.0, 0.0, self.omega3.to_f64());
                Kinematics::new(self.fixed_attitude(t), rates)
            }
            Course::Moving { form, .. } => match form {
                Form::Trigonometric(sampler) => sampler.kinematics(t),
                Form::Hyperbolic(late) => late.kinematics(t),
            },
        }
    }

    /// The same as [`HeavyTop::kinematics`].
    ///
    /// # Errors
    /// `NotFinite` for a time that is not finite; `PhaseLost` for one so late that the phase is
    /// lost ([how late](crate::exact#how-late)).
    pub fn try_kinematics(&self, t: f64) -> Result<Kinematics> {
        Ok(self.kinematics(known(t, self.latest)?))
    }

    /// Attitude and angular momentum about the pivot at time `t`; for a dimensionless top
    /// in units with I1 = 1, I3 = a.
    ///
    /// NaN at a time that [`HeavyTop::try_state`] refuses.
    pub fn state(&self, t: f64) -> State {
        self.with_momentum(self.kinematics(t))
    }

    pub(super) fn with_momentum(&self, now: Kinematics) -> State {
        let Kinematics { attitude, angular_velocity: omega } = now;
        let [i1, i3] = self.moments;
        let own = BodyVector::new(i1 * omega.x(), i1 * omega.y(), i3 * omega.z());
        State { attitude, angular_momentum: attitude.to_space(own) }
    }

    /// The same as [`HeavyTop::state`].
    ///
    /// # Errors
    /// `NotFinite` for a time that is not finite; `PhaseLost` for one so late that the phase is
    /// lost ([how late](crate::exact#how-late)).
    pub fn try_state(&self, t: f64) -> Result<State> {
        Ok(self.state(known(t, self.latest)?))
    }

    /// The angular momentum about the pivot at time `t`, on the fixed axes.
    ///
    /// For a dimensionless top in units with I1 = 1, I3 = a.
    pub fn angular_momentum(&self, t: f64) -> SpaceVector {
        self.state(t).angular_momentum
    }

    /// omega_3 t.
    fn spun(&self, t: f64) -> Dd {
        // So late a time leaves the range of pairs, however slow the spin.
        if t.abs() > 1e250 { self.omega3.scaled(UP) * (t / UP) } else { self.omega3 * t }
    }

    fn fixed_attitude(&self, t: f64) -> Attitude {
        let EulerAngles { phi, theta, .. } = self.angles(0.0);
        let turn = self.spun(t) / Dd::TWO_PI;
        // Twice: beyond 2^53 turns the first leaves the trailing part.
        let turn = turn - turn.round();
        let turn = turn - turn.round();
        let zeta = turn * Dd::TWO_PI + self.zeta0;
        let (sin, cos) = math::sincos(0.5 * theta);
        // Exactly at a pole the zero component stays zero.
        let sin = if theta == 0.0 { 0.0 } else { sin };
        let cos = if theta == core::f64::consts::PI { 0.0 } else { cos };
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
            if momentum == 0.0 { 0.0 } else { momentum / part }
        };
        if beta <= alpha {
            (per(self.difference.to_f64(), beta) + spin) / (4.0 * alpha)
        } else {
            (per(self.sum.to_f64(), alpha) - spin) / (4.0 * beta)
        }
    }

    /// alpha and beta from the parameters in v.
    #[inline]
    fn ordered(&self, pair: Pair) -> (Complex<f64>, Complex<f64>) {
        if self.flip > 0.0 { (pair.a, pair.b) } else { (pair.b, pair.a) }
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
        [alpha, beta, (wronskian * motion.rate.hi() + phases) * 2.0]
    }
}
