//! The physical pendulum at any time, without stepping: swings of any size, the
//! separatrix, and turning over.
//!
//! Not for: friction or a moving pivot; those scenes are integrated.
//!
//! A rigid body on a smooth horizontal axis, `theta` from the hanging position:
//!
//! ```text
//! theta'' = -W^2 sin(theta),   W^2 = m g d/I,
//! k^2 = sin^2(theta0/2) + (omega0/2W)^2   (energy over that of the upright position).
//!
//! k < 1:  sin(theta/2) = k sn(W t + u0 | k^2),      theta' = 2 W k cn
//! k > 1:  theta/2 = am(k W t + u0 | 1/k^2),         theta' = 2 W k dn
//! k = 1:  the same with tanh and sech.
//! ```
//!
//! `1 - k^2` is formed in double-double arithmetic, and so are the phase and the
//! start's distance from the nearest turning point or lowest point. Below an
//! amplitude of 2e-18 the motion is harmonic to 37 digits.
//!
//! Sources: the notes, 16.7; L. D. Landau, E. M. Lifshitz, *Mechanics*, 11;
//! DLMF 22.19(i).

use super::phase::Phase;
use crate::error::{Error, Result, finite, known};
use crate::math::{DoubleDouble as Dd, atan2, latest, ldexp};
use crate::motion::{Kept, Motion, condition_of_each};

/// A rigid body on a fixed horizontal axis.
///
/// Each number must lie between 1e-60 and 1e60.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Suspension {
    /// Moment of inertia about the axis, kg m^2.
    pub moment: f64,
    /// Mass, kg.
    pub mass: f64,
    /// Acceleration of gravity, m/s^2.
    pub gravity: f64,
    /// Distance of the centre of mass from the axis, m.
    pub lever: f64,
}

/// The kind of motion of the pendulum.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PendulumKind {
    /// It hangs still.
    Rest,
    /// It swings to and fro.
    Oscillation,
    /// Exactly enough energy for the upright position, which it approaches for ever.
    Separatrix,
    /// It turns over and over.
    Rotation,
}

/// Angle and rate at one time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PendulumState {
    /// Angle from the hanging position, rad, continuous: whole turns are kept.
    pub theta: f64,
    /// Its rate, rad/s.
    pub omega: f64,
}

/// The whole motion of a physical pendulum.
///
/// ```
/// use rotation_dynamics::exact::pendulum::{Pendulum, Suspension};
/// let rod = Suspension { moment: 1.0 / 3.0, mass: 1.0, gravity: 9.80665, lever: 0.5 };
/// let pendulum = Pendulum::new(rod, 1.0, 0.0)?;
/// assert_eq!(pendulum.period(), 1.7468968348539393);
/// let back = pendulum.at(1e6 * pendulum.period())?;
/// assert!((back.theta - 1.0).abs() < 1e-15);
/// # Ok::<(), rotation_dynamics::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct Pendulum {
    suspension: Suspension,
    theta0: f64,
    omega0: f64,
    /// W.
    rate: Dd,
    k2: Dd,
    /// 1 - k^2, exactly 0 on the separatrix.
    gap: Dd,
    /// Whole turns of theta0.
    turns: f64,
    motion: Course,
}

#[derive(Debug, Clone)]
enum Course {
    Rest,
    /// theta/2 = (half cos W t + swing sin W t) / scale.
    Harmonic {
        half: Dd,
        swing: Dd,
        scale: f64,
    },
    Oscillation {
        k: f64,
        k1: f64,
        /// 2 W k.
        speed: f64,
        phase: Phase,
    },
    /// Also the separatrix.
    Rotation {
        /// +1 for growing theta, else -1.
        sense: f64,
        m: f64,
        speed: f64,
        phase: Phase,
    },
}

impl Pendulum {
    /// The motion that starts at `theta0` (rad, |theta0| <= 1e15) with the rate
    /// `omega0` (rad/s, at most 1e60 W).
    ///
    /// The inputs are taken as exact: pi as an `f64` is 1.2e-16 short of upright, so a
    /// pendulum released there at rest falls.
    ///
    /// # Errors
    /// `NotFinite`, and `OutOfRange` outside the ranges above.
    pub fn new(suspension: Suspension, theta0: f64, omega0: f64) -> Result<Self> {
        let Suspension { moment, mass, gravity, lever } = suspension;
        for (name, value) in
            [("moment", moment), ("mass", mass), ("gravity", gravity), ("lever", lever)]
        {
            let allowed = "it must be positive, between 1e-60 and 1e60";
            in_range(name, value, (1e-60..=1e60).contains(&value), allowed)?;
        }
        let allowed = "its size must not exceed 1e15 rad";
        in_range("theta0", theta0, theta0.abs() <= 1e15, allowed)?;
        let torque = Dd::product(mass, gravity) * lever;
        let rate = (torque / moment).sqrt();
        let allowed = "its size must not exceed 1e60 times sqrt(m g d/I)";
        let small_enough = omega0.abs() <= 1e60 * rate.to_f64();
        in_range("omega0", omega0, small_enough, allowed)?;

        // theta0/2 less whole half turns; the sign of the cosine decides the last one.
        let mut turns = (theta0 / core::f64::consts::TAU).round();
        let (sin, cos) = Dd::from(0.5 * theta0).sin_cos();
        let flip = if turns.rem_euclid(2.0) == 0.0 { 1.0 } else { -1.0 };
        let (mut sin, mut cos) = (sin * flip, cos * flip);
        if cos < 0.0 {
            turns += if sin > 0.0 { 1.0 } else { -1.0 };
            (sin, cos) = (-sin, -cos);
        }

        // Tiny numbers are scaled up, so that the pairs keep their digits.
        let scale = if sin.abs().to_f64().max(omega0.abs() / rate.to_f64()) < 1e-100 {
            ldexp(1.0, 500)
        } else {
            1.0
        };
        let swing = Dd::from(omega0) * scale / rate.scaled(2.0);
        let half = sin.scaled(scale);
        // Exact but for one rounding where the products are in range.
        let kinetic = if scale == 1.0 && (1e-100..=1e100).contains(&omega0.abs()) {
            Dd::product(omega0, omega0) * moment / torque.scaled(4.0)
        } else {
            swing.square()
        };
        let k2 = (half.square() + kinetic).scaled(1.0 / scale).scaled(1.0 / scale);
        let gap = cos.square() - kinetic.scaled(1.0 / scale).scaled(1.0 / scale);
        // cos(theta0/2) is transcendental unless theta0 = 0, so only there can the
        // separatrix be met exactly. A gap that 106 bits do not resolve counts as none.
        let exact = theta0 == 0.0
            && gap.abs() < 1e-28
            && equal_products([omega0, omega0, moment], [mass, gravity, 4.0 * lever]);
        let gap = if exact { Dd::ZERO } else { gap };

        let motion = if theta0 == 0.0 && omega0 == 0.0 {
            Course::Rest
        } else if k2 < 1e-36 {
            Course::Harmonic { half, swing, scale }
        } else if gap > 0.0 {
            let k = k2.sqrt();
            Course::Oscillation {
                k: k.to_f64(),
                k1: gap.sqrt().to_f64(),
                speed: (rate * k).scaled(2.0).to_f64(),
                phase: Phase::new(sin, swing, k2, gap, rate),
            }
        } else {
            let k = k2.sqrt();
            let sense = if omega0 < 0.0 { -1.0 } else { 1.0 };
            let (m, m1) = (k2.recip(), -gap / k2);
            Course::Rotation {
                sense,
                m: m.to_f64(),
                speed: (rate * k).scaled(2.0 * sense).to_f64(),
                phase: Phase::new(sin * sense, cos, m, m1, rate * k),
            }
        };
        Ok(Self { suspension, theta0, omega0, rate, k2, gap, turns, motion })
    }

    /// The body and its axis.
    pub fn suspension(&self) -> Suspension {
        self.suspension
    }

    /// The state at t = 0.
    pub fn start(&self) -> PendulumState {
        PendulumState { theta: self.theta0, omega: self.omega0 }
    }

    /// The kind of motion of the pendulum.
    pub fn kind(&self) -> PendulumKind {
        match &self.motion {
            Course::Rest => PendulumKind::Rest,
            Course::Harmonic { .. } | Course::Oscillation { .. } => PendulumKind::Oscillation,
            Course::Rotation { .. } if self.gap == 0.0 => PendulumKind::Separatrix,
            Course::Rotation { .. } => PendulumKind::Rotation,
        }
    }

    /// W = sqrt(m g d/I), the angular frequency of small swings, rad/s.
    pub fn small_swing_frequency(&self) -> f64 {
        self.rate.to_f64()
    }

    /// k^2, the energy (from the hanging position) divided by the energy of the upright one.
    pub fn energy_ratio(&self) -> f64 {
        self.k2.to_f64()
    }

    /// The period, s: T = 4 K(k)/W of a swing, 2 K(1/k)/(k W) of a turn, 2 pi/W of the
    /// smallest swings (and at rest); infinite on the separatrix.
    ///
    /// Accuracy: rounded once. Relative error in eps, median / P99 / max over the kit's
    /// family D: 0.36 / 0.91 / 0.99 for amplitudes pi - 1e-1 to pi - 1e-15 (best elsewhere
    /// 0.48 / 1.7 / 1.9), 0.32 / 0.88 / 0.99 for 0.01 to 3; seed 7 the same to 0.04.
    pub fn period(&self) -> f64 {
        match &self.motion {
            Course::Rest | Course::Harmonic { .. } => (Dd::TWO_PI / self.rate).to_f64(),
            Course::Oscillation { phase, .. } => (phase.quarter.scaled(4.0) / self.rate).to_f64(),
            Course::Rotation { .. } if self.gap == 0.0 => f64::INFINITY,
            Course::Rotation { phase, .. } => {
                (phase.quarter.scaled(2.0) / (self.rate * self.k2.sqrt())).to_f64()
            }
        }
    }

    /// The largest angle from the hanging position, rad: 2 asin k; pi on the
    /// separatrix, where it is approached; none for a rotation.
    pub fn amplitude(&self) -> Option<f64> {
        match &self.motion {
            Course::Rest => Some(0.0),
            Course::Harmonic { half, swing, scale } => {
                let size = (half.square() + swing.square()).sqrt();
                Some(2.0 * size.to_f64() / scale)
            }
            Course::Oscillation { k, k1, .. } => Some(2.0 * atan2(*k, *k1)),
            Course::Rotation { .. } if self.gap == 0.0 => Some(core::f64::consts::PI),
            Course::Rotation { .. } => None,
        }
    }

    /// The state `t` seconds after the start; negative times are before it.
    ///
    /// # Errors
    /// `NotFinite`; `PhaseLost` where W t, or k W t when turning over, is beyond 2^48 turns
    /// ([how late](super#how-late)).
    ///
    /// # Accuracy
    /// Error over eps (|value| + sens), sens the change of the value when each input and `t` change
    /// by their own size: at most 2.04 over 271 cases (theta, omega, T, W, k^2) of every regime.
    /// The amplitudes go from 1e-300 to pi - 1e-15, 1 - k^2 from 1e-1 to 1e-15 on either side, and
    /// the phase to 1e9 radians.
    ///
    /// The kit's family D, W = 1, released at rest: error over eps (|theta| + |t omega|),
    /// median / P99 / max of 2000 rows:
    ///
    /// | theta0 | seed 0 | seed 7 | best elsewhere |
    /// |---|---|---|---|
    /// | pi - 1e-1 to pi - 1e-15 | 0.23 / 0.63 / 0.89 | 0.22 / 0.62 / 0.72 | 0.35 / 3.8 / 5.7 |
    /// | 0.01 to 3 | 0.18 / 1.8 / 3.1 | 0.18 / 1.8 / 3.7 | |
    ///
    /// Cost: a sine-cosine pair or two exponentials, an arc tangent, short polynomials.
    pub fn at(&self, t: f64) -> Result<PendulumState> {
        let speed = self.rate.to_f64() * self.k2.to_f64().max(1.0).sqrt();
        known(t, latest(speed))?;
        let (turns, angle, omega) = match &self.motion {
            Course::Rest => (0.0, 0.0, 0.0),
            Course::Harmonic { half, swing, scale } => {
                let (sin, cos) = (self.rate * t).sin_cos();
                let angle = *half * cos + *swing * sin;
                let rate = (*swing * cos - *half * sin) * self.rate;
                (0.0, 2.0 * angle.to_f64() / scale, 2.0 * rate.to_f64() / scale)
            }
            Course::Oscillation { k, speed, phase, .. } => {
                let s = phase.at(t);
                let (sn, cn, dn) = (s.sn / s.one, s.cn / s.one, s.dn / s.one);
                // The last digits of the phase enter to first order.
                let angle = 2.0 * atan2(k * s.sn, s.dn) + 2.0 * k * cn * s.rest;
                (0.0, angle, speed * (cn - sn * dn * s.rest))
            }
            Course::Rotation { sense, m, speed, phase } => {
                let s = phase.at(t);
                let (sn, cn, dn) = (s.sn / s.one, s.cn / s.one, s.dn / s.one);
                let (sin, cos) = s.amplitude_rest();
                let angle = sense * 2.0 * (atan2(sin, cos) + dn * s.rest);
                let omega = speed * (dn - m * sn * cn * s.rest);
                (0.5 * sense * s.quarters, angle, omega)
            }
        };
        let turns = self.turns + turns;
        let theta = if turns == 0.0 { angle } else { (Dd::TWO_PI * turns + angle).to_f64() };
        Ok(PendulumState { theta, omega })
    }
}

/// The inputs of the condition are moment, mass, gravity, lever, theta0, omega0 and the time; the
/// answer is theta.
impl Motion for Pendulum {
    type State = PendulumState;

    fn name(&self) -> &'static str {
        "closed form of the pendulum"
    }

    fn try_state(&self, t: f64) -> Result<PendulumState> {
        self.at(t)
    }

    fn kept(&self) -> Vec<Kept> {
        let energy = self.suspension.mass * self.suspension.gravity * self.suspension.lever;
        vec![Kept::new("energy above hanging", "J", 2.0 * energy * self.energy_ratio())]
    }

    fn condition(&self, t: f64) -> Result<f64> {
        let here = self.at(t)?;
        let inputs = [
            self.suspension.moment,
            self.suspension.mass,
            self.suspension.gravity,
            self.suspension.lever,
            self.theta0,
            self.omega0,
        ];
        let turned = here.omega * t;
        let square = condition_of_each(turned * turned, inputs, |inputs| {
            let [moment, mass, gravity, lever, theta0, omega0] = inputs;
            let other = Self::new(Suspension { moment, mass, gravity, lever }, theta0, omega0)?;
            Ok((other.at(t)?.theta - here.theta).abs())
        })?;
        Ok(square.sqrt())
    }
}

fn in_range(name: &'static str, value: f64, inside: bool, allowed: &'static str) -> Result<()> {
    finite(name, value)?;
    if inside { Ok(()) } else { Err(Error::out_of_range(name, value, allowed)) }
}

/// Whether two products of three positive numbers that agree to 90 bits are equal.
///
/// A product of odd whole numbers below 2^53 has at most 159 bits: its leading 90 and
/// its lowest 128 determine it.
fn equal_products(a: [f64; 3], b: [f64; 3]) -> bool {
    let odd_and_exponent = |factors: [f64; 3]| {
        factors.iter().fold((1_u128, 0), |(odd, exponent), x| {
            let bits = x.to_bits();
            let mantissa = (bits & ((1 << 52) - 1)) | (1 << 52);
            let zeros = mantissa.trailing_zeros();
            let power = ((bits >> 52) & 0x7ff) as u32 + zeros;
            (odd.wrapping_mul(u128::from(mantissa >> zeros)), exponent + power)
        })
    };
    odd_and_exponent(a) == odd_and_exponent(b)
}
