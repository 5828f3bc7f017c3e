//! Torque-free motion of any rigid body in closed form (Euler-Poinsot): body
//! rates and attitude at any time, without stepping.
//!
//! Not for: bodies under a torque; the heavy top has its own module.
//!
//! With the third axis along L, the attitude is Rz(2 nu t) times a *periodic*
//! rotation whose Cayley-Klein parameters are theta functions of nome q^2,
//!
//!   alpha = cos(theta/2) e^{i(phi+zeta)/2} ~ theta_4(z + iy | q^2) e^{i nu t},
//!   beta  = sin(theta/2) e^{i(phi-zeta)/2} ~ theta_1(z + iy | q^2) e^{i nu t},
//!
//! z = pi tau/2K, because 1 -+ L_3/L = 1 -+ c dn(tau) has one pair of zeros in a
//! cell 2K by 4iK'. Both are regular where the axis passes L, so nothing is
//! special there, and no third-kind integral is formed. The set-up is done in
//! double-double arithmetic; a sample takes two sine-cosine pairs,
//! the first of them hyperbolic near the middle axis.
//!
//! How it is derived, and which differences are not formed: `book/src/how_free_body.md`.
//!
//! Sources: the notes, 15.5; L. D. Landau, E. M. Lifshitz, *Mechanics*, 37;
//! R. van Zon, J. Schofield, J. Comput. Phys. 225, 145 (2007) for the theta
//! functions in the rotation matrix; the doubled period is ours.

use crate::attitude::Attitude;
use crate::body::{Kinematics, State};
use crate::error::{Error, Result, finite, known};
use crate::exact::batch::{Branchless, Sampled};
use crate::exact::check_times;
use crate::frame::{BodyVector, SpaceVector};
use crate::inertia::PrincipalMoments;
use crate::math::DoubleDouble as Dd;

mod as_motion;
mod asymmetric;
mod bodies;
mod flow;
mod hyperbolic;
mod periods;
mod sample;
mod series;
mod symmetric;

pub(in crate::exact) use as_motion::first_bad;
use asymmetric::Asymmetric;
pub use bodies::FreeBodies;
pub use flow::FreeFlow;
use symmetric::Symmetric;

/// A rigid body on which nothing acts: the whole motion, at any time.
///
/// Accuracy: with inputs and time taken as the doubles that they are, the attitude stays within 8.7
/// eps rad up to 1e12 periods of the rates, the rates within 3.4 eps of themselves
/// (`tests/exact/late.rs`). Later than 2^48 turns [nothing is known](crate::exact#how-late).
///
/// ```
/// use rotation_dynamics::{attitude::Attitude, exact::free_body::FreeBody};
/// use rotation_dynamics::{frame::BodyVector, inertia::PrincipalMoments};
/// let moments = PrincipalMoments::new(1.0, 2.0, 8.0 / 3.0)?;
/// let motion = FreeBody::new(moments, Attitude::IDENTITY, BodyVector::new(0.8, 0.4, 0.3375))?;
/// let late = motion.kinematics(1e6);
/// let momentum = late.attitude.to_space(motion.body_momentum(late.angular_velocity));
/// assert!((momentum - motion.angular_momentum()).norm() < 1e-14);
/// # Ok::<(), rotation_dynamics::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct FreeBody {
    moments: [f64; 3],
    angular_velocity: BodyVector,
    attitude: Attitude,
    motion: Motion,
}

/// Which of the solutions applies.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// Rotation about a principal axis (or of a spherical body): steady.
    Steady,
    /// Two equal moments: the axis precesses about L, the body spins about the axis.
    Symmetric,
    /// Three different moments.
    Asymmetric,
    /// Three different moments and L^2 = 2 E I_mid exactly: one flip, no period.
    Separatrix,
}

/// The smallest I_min/I_max of three different moments.
const THINNEST: f64 = 1e-120;

#[derive(Debug, Clone)]
enum Motion {
    Steady(Symmetric),
    Symmetric(Symmetric),
    Asymmetric(Box<Asymmetric>),
}

impl FreeBody {
    /// The motion of this attitude and these body rates at t = 0.
    ///
    /// `moments`: principal moments (kg m^2) about the centre of mass or a fixed
    /// point; `attitude`: body -> space; `angular_velocity`: on the principal axes, in rad/s.
    ///
    /// # Errors
    /// `NotFinite` for a NaN or infinite rate, or an energy beyond `f64`;
    /// `OutOfRange` for a fastest rate outside 1e-230 to 1e230 rad/s (but 0: rest), while
    /// the others may be as small as doubles are, and for a needle of three different moments
    /// with I_min/I_max below 1e-120, or a thinner symmetric one that doubles do not hold.
    pub fn new(
        moments: PrincipalMoments,
        attitude: Attitude,
        angular_velocity: BodyVector,
    ) -> Result<Self> {
        let moments = moments.to_array();
        let omega = angular_velocity.to_array();
        if let Some(&value) = omega.iter().find(|w| !w.is_finite()) {
            return Err(Error::NotFinite { name: "angular_velocity", value });
        }
        let fastest = omega.iter().fold(0.0_f64, |most, w| most.max(w.abs()));
        if fastest > 0.0 && !(1e-230..=1e230).contains(&fastest) {
            return Err(Error::out_of_range(
                "fastest rate",
                fastest,
                "0, or from 1e-230 to 1e230 rad/s",
            ));
        }
        for (moment, rate) in moments.iter().zip(omega) {
            finite("I omega^2", moment * rate * rate)?;
            finite("I omega", moment * rate)?;
        }
        let [least, most] =
            [f64::min, f64::max].map(|of| of(of(moments[0], moments[1]), moments[2]));
        let equal = [0, 1, 2].map(|i| moments[(i + 1) % 3] == moments[(i + 2) % 3]);
        let motion = if omega.iter().filter(|w| **w != 0.0).count() <= 1 || (equal[0] && equal[1]) {
            Motion::Steady(Symmetric::steady(omega, attitude))
        } else if let Some(axis) = equal.iter().position(|e| *e) {
            Motion::Symmetric(Symmetric::new(moments, omega, axis, attitude))
        } else {
            if least < THINNEST * most {
                return Err(Error::out_of_range(
                    "I_min/I_max",
                    least / most,
                    "at least 1e-120 for three different moments",
                ));
            }
            Motion::Asymmetric(Box::new(Asymmetric::new(moments, omega, attitude)))
        };
        let made = Self { moments, angular_velocity, attitude, motion };
        // Three moments within their range are held: only a needle of two can be too thin.
        if least / most < 1e-120 && !made.kinematics(0.0).is_finite() {
            return Err(Error::out_of_range(
                "I_min/I_max",
                least / most,
                "a ratio whose products with the rates doubles hold",
            ));
        }
        Ok(made)
    }

    /// Which of the solutions applies.
    pub fn kind(&self) -> Kind {
        match &self.motion {
            Motion::Steady(_) => Kind::Steady,
            Motion::Symmetric(_) => Kind::Symmetric,
            Motion::Asymmetric(motion) if motion.half_period.is_none() => Kind::Separatrix,
            Motion::Asymmetric(_) => Kind::Asymmetric,
        }
    }

    /// The greatest |t| (s) at which the phases are known.
    fn latest(&self) -> f64 {
        match &self.motion {
            Motion::Steady(motion) | Motion::Symmetric(motion) => motion.until(),
            Motion::Asymmetric(motion) => motion.latest(),
        }
    }

    /// Attitude at time `t` (s); NaN at a time that [`FreeBody::try_attitude`] refuses.
    pub fn attitude(&self, t: f64) -> Attitude {
        match &self.motion {
            Motion::Steady(motion) | Motion::Symmetric(motion) => motion.kinematics(t).attitude,
            Motion::Asymmetric(motion) => motion.attitude(t),
        }
    }

    /// The same as [`FreeBody::attitude`].
    ///
    /// # Errors
    /// `NotFinite` for a time that is not finite; `PhaseLost` for one so late that the phase is
    /// lost ([how late](crate::exact#how-late)).
    pub fn try_attitude(&self, t: f64) -> Result<Attitude> {
        Ok(self.attitude(known(t, self.latest())?))
    }

    /// Angular velocity on the body axes at time `t` (rad/s).
    pub fn angular_velocity(&self, t: f64) -> BodyVector {
        self.kinematics(t).angular_velocity
    }

    /// Attitude and body rates at time `t` (s), for the price of one.
    ///
    /// NaN at a time that [`FreeBody::try_kinematics`] refuses.
    pub fn kinematics(&self, t: f64) -> Kinematics {
        match &self.motion {
            Motion::Steady(motion) | Motion::Symmetric(motion) => motion.kinematics(t),
            Motion::Asymmetric(motion) => motion.kinematics(t),
        }
    }

    /// The same as [`FreeBody::kinematics`].
    ///
    /// # Errors
    /// `NotFinite` for a time that is not finite; `PhaseLost` for one so late that the phase is
    /// lost ([how late](crate::exact#how-late)).
    pub fn try_kinematics(&self, t: f64) -> Result<Kinematics> {
        Ok(self.kinematics(known(t, self.latest())?))
    }

    /// Attitude and angular momentum at time `t` (s); the momentum has the same bits at
    /// all times.
    ///
    /// The attitude is NaN at a time that [`FreeBody::try_state`] refuses.
    pub fn state(&self, t: f64) -> State {
        State { attitude: self.attitude(t), angular_momentum: self.angular_momentum() }
    }

    /// The same as [`FreeBody::state`].
    ///
    /// # Errors
    /// `NotFinite` for a time that is not finite; `PhaseLost` for one so late that the phase is
    /// lost ([how late](crate::exact#how-late)).
    pub fn try_state(&self, t: f64) -> Result<State> {
        Ok(self.state(known(t, self.latest())?))
    }

    /// Attitude and body rates at many times (s): the bits of [`FreeBody::kinematics`],
    /// in vector registers where the processor has them. Many bodies at one time:
    /// [`FreeBodies`].
    ///
    /// Nothing is allocated. Cost of a sample in sine-cosine pairs of `libm`: 0.4 with AVX-512,
    /// 0.8 with AVX2, 1.8 one by one; next to the separatrix 0.5, 0.9 and 2.2 (`benches`, binary
    /// `batch`).
    ///
    /// ```
    /// # use rotation_dynamics::{attitude::Attitude, body::Kinematics};
    /// # use rotation_dynamics::exact::free_body::FreeBody;
    /// # use rotation_dynamics::{frame::BodyVector, inertia::PrincipalMoments};
    /// # let moments = PrincipalMoments::new(1.0, 2.0, 8.0 / 3.0)?;
    /// # let start = BodyVector::new(0.8, 0.4, 0.3375);
    /// let motion = FreeBody::new(moments, Attitude::IDENTITY, start)?;
    /// let times: Vec<f64> = (0..1000).map(|k| 0.01 * f64::from(k)).collect();
    /// let mut samples = vec![Kinematics::REST; times.len()];
    /// motion.kinematics_at(&times, &mut samples)?;
    /// assert_eq!(samples[999], motion.kinematics(times[999]));
    /// # Ok::<(), rotation_dynamics::Error>(())
    /// ```
    ///
    /// # Errors
    /// `Lengths` if there are not as many samples as times; for a time as
    /// [`FreeBody::try_kinematics`]. No sample is touched then.
    pub fn kinematics_at(&self, times: &[f64], samples: &mut [Kinematics]) -> Result<()> {
        check_times("samples", samples.len(), times, self.latest())?;
        match &self.motion {
            Motion::Steady(motion) | Motion::Symmetric(motion) => motion.fill(times, samples),
            Motion::Asymmetric(motion) => motion.fill(times, samples),
        }
        Ok(())
    }

    /// The angular momentum (kg m^2/s), the same at all times.
    pub fn angular_momentum(&self) -> SpaceVector {
        self.attitude.to_space(self.body_momentum(self.angular_velocity))
    }

    /// The kinetic energy (J).
    pub fn kinetic_energy(&self) -> f64 {
        0.5 * self.body_momentum(self.angular_velocity).dot(&self.angular_velocity)
    }

    /// The period of the body rates (s); infinite on the separatrix and for steady rotation.
    pub fn rate_period(&self) -> f64 {
        match &self.motion {
            Motion::Steady(_) => f64::INFINITY,
            Motion::Symmetric(motion) => core::f64::consts::TAU / motion.body_rate.abs(),
            Motion::Asymmetric(motion) => {
                motion.half_period.map_or(f64::INFINITY, |half| 2.0 * half.to_f64())
            }
        }
    }

    /// The angle (rad) by which the body has turned about L after one
    /// [`FreeBody::rate_period`]; infinite where there is none. For three different
    /// moments it is counted on the axis whose rate keeps its sign.
    pub fn precession_per_period(&self) -> f64 {
        match &self.motion {
            Motion::Steady(_) => f64::INFINITY,
            Motion::Symmetric(motion) => motion.precession_rate * self.rate_period(),
            Motion::Asymmetric(motion) => motion.precession,
        }
    }

    /// The angular momentum on the body axes for these rates, I omega.
    pub fn body_momentum(&self, omega: BodyVector) -> BodyVector {
        let [i1, i2, i3] = self.moments;
        BodyVector::new(i1 * omega.x(), i2 * omega.y(), i3 * omega.z())
    }
}

/// The numbers in units of a power of two, such that the largest is between one and two,
/// and that unit.
fn near_one(values: [f64; 3]) -> ([f64; 3], f64) {
    const EXPONENT: u64 = 0x7ff << 52;
    let largest = values.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    let unit = f64::from_bits(largest.to_bits() & EXPONENT).max(f64::MIN_POSITIVE);
    (values.map(|x| x / unit), unit)
}

fn norm3(v: [Dd; 3]) -> Dd {
    let (_, unit) = near_one(v.map(|x| x.hi()));
    let [x, y, z] = v.map(|x| x.scaled(1.0 / unit));
    (x.square() + y.square() + z.square()).sqrt().scaled(unit)
}
