//! The heavy top as a [`Motion`].

use super::{Given, HeavyTop, ReducedTop, SymmetricTop};
use crate::attitude::Attitude;
use crate::body::{Kinematics, State};
use crate::error::Result;
use crate::exact::free_body::first_bad;
use crate::frame::{BodyVector, SpaceVector};
use crate::motion::{Kept, Motion, condition_by_difference, condition_of_each, pushed};

/// The inputs of the condition are, for a body, three turns of the start (per rad), three pushes
/// (per |L|: each rate changed by a part of |L|/I), both moments, the torque of gravity, and the
/// time. For a dimensionless top they are a, b, c, the energy or the start in theta, phi0 and zeta0
/// (per rad), and the time.
impl Motion for HeavyTop {
    type State = State;

    fn name(&self) -> &'static str {
        "closed form of the heavy top"
    }

    fn try_state(&self, t: f64) -> Result<State> {
        Self::try_state(self, t)
    }

    fn try_states(&self, times: &[f64]) -> Result<Vec<State>> {
        let mut samples = vec![Kinematics::REST; times.len()];
        self.kinematics_at(times, &mut samples)
            .map_err(|reason| first_bad(times, self.latest, reason))?;
        Ok(samples.into_iter().map(|now| self.with_momentum(now)).collect())
    }

    fn kept(&self) -> Vec<Kept> {
        let (vertical, own) = self.momenta();
        let (momentum, energy) = if self.body.is_some() { ("kg m^2/s", "J") } else { ("", "") };
        vec![
            Kept::new("L_Z", momentum, vertical),
            Kept::new("L_z", momentum, own),
            Kept::new("energy", energy, self.energy()),
        ]
    }

    fn condition(&self, t: f64) -> Result<f64> {
        let turned = self.try_kinematics(t)?.angular_velocity.norm() * t;
        let square = match self.given {
            Given::Body { body, omega_body } => self.of_start(body, omega_body, t)?,
            Given::Energy { top, energy, start } => {
                let inputs = [top.a(), top.b(), top.c(), energy];
                // phi0 and zeta0 turn the whole motion.
                2.0 + self.of_numbers(inputs, t, |[a, b, c, energy]| {
                    let top = ReducedTop::formal(a, b, c)?;
                    Self::from_energy(top, energy, start, self.phi0, self.zeta0)
                })?
            }
            Given::Angles { top, theta0, theta_rate0 } => {
                let inputs = [top.a(), top.b(), top.c(), theta0, theta_rate0];
                2.0 + self.of_numbers(inputs, t, |[a, b, c, theta0, rate]| {
                    let top = ReducedTop::formal(a, b, c)?;
                    Self::from_angles(top, theta0, rate, self.phi0, self.zeta0)
                })?
            }
        };
        Ok((square + turned * turned).sqrt())
    }
}

impl HeavyTop {
    /// The sum of squares over numbers, each changed by a part of itself.
    fn of_numbers<const N: usize>(
        &self,
        inputs: [f64; N],
        t: f64,
        make: impl Fn([f64; N]) -> Result<Self>,
    ) -> Result<f64> {
        let here = self.try_attitude(t)?;
        condition_of_each(0.0, inputs, |inputs| Ok(make(inputs)?.try_attitude(t)?.angle_to(&here)))
    }

    /// The sum of squares over the inputs of a body.
    fn of_start(&self, body: SymmetricTop, omega_body: BodyVector, t: f64) -> Result<f64> {
        let start = self.attitude(0.0);
        let make = |body: SymmetricTop, attitude: Attitude, omega: [f64; 3]| {
            Self::new(body, attitude, BodyVector::from_array(omega))
        };
        let omega = omega_body.to_array();
        let base = make(body, start, omega)?;
        let here = base.try_attitude(t)?;
        let numbers = [body.i1(), body.i3(), body.weight()];
        let mut square = base.of_numbers(numbers, t, |[i1, i3, weight]| {
            let body = SymmetricTop::formal(i1, i3, weight, body.lever())?;
            make(body, start, omega)
        })?;
        let momentum = base.angular_momentum(0.0).norm();
        for i in 0..3 {
            let by_turn = condition_by_difference(|by| {
                let mut axis = [0.0; 3];
                axis[i] = by;
                let turn = Attitude::from_rotation_vector(SpaceVector::from_array(axis))?;
                let other = turn * start;
                // No double may be that near.
                if (other.angle_to(&start) - by.abs()).abs() > 0.1 * by.abs() {
                    return Ok(None);
                }
                Ok(Some(make(body, other, omega)?.try_attitude(t)?.angle_to(&here)))
            })?;
            let size = momentum / if i == 2 { body.i3() } else { body.i1() };
            let by_push = condition_by_difference(|by| match pushed(omega[i], by * size) {
                Some(rate) if size > 0.0 => {
                    let mut omega = omega;
                    omega[i] = rate;
                    Ok(Some(make(body, start, omega)?.try_attitude(t)?.angle_to(&here)))
                }
                _ => Ok(None),
            })?;
            square += by_turn * by_turn + by_push * by_push;
        }
        Ok(square)
    }
}
