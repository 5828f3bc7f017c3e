//! The free body as a [`Motion`].

use super::FreeBody;
use crate::body::{Kinematics, State};
use crate::error::{Error, Result, known};
use crate::frame::BodyVector;
use crate::inertia::PrincipalMoments;
use crate::motion::{Kept, Motion, changed, condition_by_difference, pushed};

/// The inputs of the condition are three turns of the start (per rad), three pushes (per |L|:
/// each rate changed by a part of |L|/I), three moments, and the time.
impl Motion for FreeBody {
    type State = State;

    fn name(&self) -> &'static str {
        "closed form of the free body"
    }

    fn try_state(&self, t: f64) -> Result<State> {
        Self::try_state(self, t)
    }

    fn try_states(&self, times: &[f64]) -> Result<Vec<State>> {
        let mut samples = vec![Kinematics::REST; times.len()];
        self.kinematics_at(times, &mut samples)
            .map_err(|reason| first_bad(times, self.latest(), reason))?;
        let angular_momentum = self.angular_momentum();
        let state = |sample: Kinematics| State { attitude: sample.attitude, angular_momentum };
        Ok(samples.into_iter().map(state).collect())
    }

    fn kept(&self) -> Vec<Kept> {
        let [x, y, z] = self.angular_momentum().to_array();
        vec![
            Kept::new("L_X", "kg m^2/s", x),
            Kept::new("L_Y", "kg m^2/s", y),
            Kept::new("L_Z", "kg m^2/s", z),
            Kept::new("kinetic energy", "J", self.kinetic_energy()),
        ]
    }

    fn condition(&self, t: f64) -> Result<f64> {
        let here = self.try_attitude(t)?;
        let rates = self.angular_velocity.to_array();
        let momentum = self.angular_momentum().norm();
        let moved = |moments: [f64; 3], rates: [f64; 3]| -> Result<Option<f64>> {
            let [i1, i2, i3] = moments;
            let moments = PrincipalMoments::new(i1, i2, i3)?;
            let other = Self::new(moments, self.attitude, BodyVector::from_array(rates))?;
            Ok(Some(other.try_attitude(t)?.angle_to(&here)))
        };
        // A turn of the start turns the whole motion.
        let mut square = 3.0;
        let turned = self.angular_velocity(t).norm() * t;
        square += turned * turned;
        for i in 0..3 {
            let by_moment = condition_by_difference(|by| match changed(self.moments[i], by) {
                Some(moment) => moved(with(self.moments, i, moment), rates),
                None => Ok(None),
            })?;
            let size = momentum / self.moments[i];
            let by_push = condition_by_difference(|by| match pushed(rates[i], by * size) {
                Some(rate) if size > 0.0 => moved(self.moments, with(rates, i, rate)),
                _ => Ok(None),
            })?;
            square += by_moment * by_moment + by_push * by_push;
        }
        Ok(square.sqrt())
    }
}

/// The numbers with one of them replaced.
fn with(mut numbers: [f64; 3], i: usize, value: f64) -> [f64; 3] {
    numbers[i] = value;
    numbers
}

/// The fault of the first of the times that is not known; else the reason as it is.
pub(crate) fn first_bad(times: &[f64], latest: f64, reason: Error) -> Error {
    let bad = |(index, t): (usize, &f64)| known(*t, latest).err().map(|error| (index, error));
    match times.iter().enumerate().find_map(bad) {
        Some((index, error)) => Error::AtIndex { name: "times", index, reason: Box::new(error) },
        None => reason,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::attitude::Attitude;

    /// Soon after the start a turn moves it by itself, a push of a part of |L| on one axis by
    /// |L| t/I, a moment by t^2 only.
    #[test]
    fn the_condition_begins_as_its_inputs_say() {
        let inertia = [1.0, 2.0, 2.5];
        let moments = PrincipalMoments::new(1.0, 2.0, 2.5).expect("a body");
        let rates = BodyVector::new(0.8, 0.4, 0.3);
        let motion = FreeBody::new(moments, Attitude::IDENTITY, rates).expect("a motion");
        let momentum = motion.angular_momentum().norm();
        for t in [1e-3, -1e-2] {
            let pushes: f64 = inertia.iter().map(|i| (momentum / i * t).powi(2)).sum();
            let want = 3.0 + (rates.norm() * t).powi(2) + pushes;
            let got = motion.condition(t).expect("a time").powi(2);
            assert!((got - want).abs() < 1e-3 * (want - 3.0), "{got} {want}");
        }
    }
}
