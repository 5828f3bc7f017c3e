//! The law of an effect that resists a body's rotation, where its effect at a fixed attitude has a
//! closed form.

use crate::body::RigidBody;
use crate::frame::BodyVector;
use crate::math::{expm1, larger, log1p, pow};

/// How a body that is held at its attitude loses its angular momentum, in closed form.
///
/// On the body's axes, with l the momentum there,
///
/// ```text
/// l_i' = -k_i l_i,   and besides   l_3' = law(l_3),
/// ```
///
/// where the law is none, dry friction (constant, until l_3 = 0) or a power of l_3. So a
/// splitting can turn the body freely and let it lose momentum in turn, each exactly
/// ([`Resisted`](crate::integrators::Resisted)); [`Scene::solve`](crate::scene::Scene::solve)
/// tries it where it applies.
///
/// ```
/// use rotation_dynamics::body::RigidBody;
/// use rotation_dynamics::effects::{Effect, ViscousFriction};
/// use rotation_dynamics::frame::BodyVector;
/// use rotation_dynamics::inertia::PrincipalMoments;
/// # fn main() -> rotation_dynamics::Result<()> {
/// let body = RigidBody::new(PrincipalMoments::symmetric(1.0, 0.5)?);
/// let friction = ViscousFriction::about_axis(0.1)?.resistance(0.0, &body).expect("linear");
/// // l_3' = -(0.1/0.5) l_3.
/// let torque = friction.torque(BodyVector::new(0.3, 0.0, 2.0)).expect("a torque");
/// assert_eq!(torque.to_array(), [0.0, 0.0, -0.4]);
/// # Ok(())
/// # }
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Resistance {
    rates: [f64; 3],
    law: Law,
}

/// The law along e3 beside the linear part.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Law {
    None,
    /// This torque (N m), until l_3 is 0.
    Dry(f64),
    /// l_3' = -factor |l_3|^power l_3.
    Power {
        factor: f64,
        power: f64,
    },
}

impl Resistance {
    /// Nothing resists.
    pub const NONE: Self = Self { rates: [0.0; 3], law: Law::None };

    /// l_i' = -k_i l_i, with the rates k_i (1/s).
    pub const fn linear(rates: [f64; 3]) -> Self {
        Self { rates, law: Law::None }
    }

    /// This torque along e3 (N m), against l_3, until l_3 is 0.
    pub const fn dry(torque: f64) -> Self {
        Self { rates: [0.0; 3], law: Law::Dry(torque) }
    }

    /// The torque -factor |omega_3|^power omega_3 along e3, the power between 0 and 1.
    pub fn power(factor: f64, power: f64, body: &RigidBody) -> Self {
        let factor = factor / pow(body.moments().i3(), 1.0 + power);
        Self { rates: [0.0; 3], law: Law::Power { factor, power } }
    }

    /// Both together; `None` if what acts along e3 has no closed form together.
    pub fn and(self, other: Self) -> Option<Self> {
        let law = match (self.law, other.law) {
            (law, Law::None) | (Law::None, law) => law,
            _ => return None,
        };
        let rates: [f64; 3] = core::array::from_fn(|i| self.rates[i] + other.rates[i]);
        (law == Law::None || rates[2] == 0.0).then_some(Self { rates, law })
    }

    /// True if it is the same in all directions across the axis.
    pub(crate) fn is_round(&self) -> bool {
        self.rates[0] == self.rates[1]
    }

    /// The fastest rate (1/s) at which it takes momentum of itself, by its linear part.
    pub(crate) fn fastest(&self) -> f64 {
        self.rates.iter().fold(0.0, |most, rate| larger(most, rate.abs()))
    }

    /// True if it has no law along e3 beside the linear one.
    pub fn is_linear(&self) -> bool {
        self.law == Law::None
    }

    /// True if dry friction acts along e3.
    pub(crate) fn is_dry(&self) -> bool {
        matches!(self.law, Law::Dry(_))
    }

    /// The same with its torque multiplied by `strength`.
    #[must_use]
    pub fn times(self, strength: f64) -> Self {
        Self {
            rates: self.rates.map(|k| k * strength),
            law: match self.law {
                Law::None => Law::None,
                Law::Dry(torque) => Law::Dry(torque * strength),
                Law::Power { factor, power } => Law::Power { factor: factor * strength, power },
            },
        }
    }

    /// The torque on the body's axes at this momentum on those axes; `None` where dry friction
    /// does not tell: at rest, and at a spin other than the one for which it was made.
    pub fn torque(&self, momentum: BodyVector) -> Option<BodyVector> {
        let [a, b, c] = momentum.to_array();
        let [ka, kb, kc] = self.rates;
        let along = match self.law {
            Law::None => 0.0,
            Law::Dry(torque) if torque * c < 0.0 => torque,
            Law::Dry(_) => return None,
            Law::Power { factor, power } => -factor * pow(c.abs(), power) * c,
        };
        Some(BodyVector::new(-ka * a, -kb * b, along - kc * c))
    }

    /// The gain of the momentum l on the body's axes in the time `dt` (s) at a fixed attitude,
    /// while `torque` (N m, on those axes, none along e3) acts as well.
    #[inline]
    pub(crate) fn gained(&self, l: [f64; 3], torque: [f64; 3], dt: f64) -> [f64; 3] {
        let part = |k: f64| expm1(-k * dt);
        let gained = |i: usize, part: f64| match self.rates[i] {
            0.0 => torque[i] * dt,
            k => l[i] * part - torque[i] / k * part,
        };
        let [ka, kb, kc] = self.rates;
        let a = part(ka);
        // The same across the axis of a symmetric body.
        let b = if kb == ka { a } else { part(kb) };
        let along = if self.law == Law::None { gained(2, part(kc)) } else { self.lost(l[2], dt) };
        [gained(0, a), gained(1, b), along]
    }

    /// The gain of l_3 by the law.
    fn lost(&self, l: f64, dt: f64) -> f64 {
        match self.law {
            Law::None => 0.0,
            Law::Dry(torque) if dt > 0.0 && (l * torque >= 0.0 || (l + torque * dt) * l <= 0.0) => {
                -l
            }
            Law::Dry(torque) => torque * dt,
            Law::Power { factor, power } => {
                let x = power * factor * pow(l.abs(), power) * dt;
                l * expm1(-log1p(x) / power)
            }
        }
    }

    /// The integral (kg m^2) of l_3 over the time `dt` (s), from `l`.
    pub(crate) fn axial_integral(&self, l: f64, dt: f64) -> f64 {
        match self.law {
            Law::None => {
                let x = self.rates[2] * dt;
                if x == 0.0 { l * dt } else { -l * dt * expm1(-x) / x }
            }
            Law::Dry(torque) if dt > 0.0 && l * torque >= 0.0 => 0.0,
            Law::Dry(torque) => {
                // Until it stops.
                let dt = if dt > 0.0 { dt.min(-l / torque) } else { dt };
                dt * (l + 0.5 * torque * dt)
            }
            Law::Power { factor, power } => {
                let x = power * factor * pow(l.abs(), power) * dt;
                let rest = 1.0 / power - 1.0;
                if x == 0.0 {
                    return l * dt;
                }
                -l * dt * expm1(-rest * log1p(x)) / (rest * x)
            }
        }
    }
}
