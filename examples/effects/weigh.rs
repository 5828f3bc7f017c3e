//! One effect after the other: what leaving it out costs, predicted and simulated.

use super::*;
use rotation_dynamics::Result;
use rotation_dynamics::accuracy::PredictedError;
use rotation_dynamics::integrators::Integrator;

/// The angle between two axes, rad.
pub fn angle([a, b]: [SpaceVector; 2]) -> f64 {
    atan2(a.cross(&b).norm(), a.dot(&b))
}

/// A motion, and what of it is asked for.
pub struct Question<E> {
    pub scene: Scene<E>,
    pub start: State,
    pub end: f64,
    /// Only where the axis e3 points, not how far the body has spun about it.
    pub of_axis: bool,
}

impl<E: Effect + Clone> Question<E> {
    /// The whole attitude of a scene from a start at t = 0 to an end.
    pub fn new(scene: Scene<E>, start: State, end: f64) -> Self {
        Self { scene, start, end, of_axis: false }
    }

    /// Only where the axis e3 points, not how far the body has spun about it.
    pub fn of_axis(mut self) -> Self {
        self.of_axis = true;
        self
    }

    /// The angle between two attitudes as far as it is asked for, rad.
    pub fn apart(&self, [a, b]: [Attitude; 2]) -> f64 {
        match self.of_axis {
            true => angle([a.axis(), b.axis()]),
            false => a.angle_to(&b),
        }
    }

    // ANCHOR: weigh
    /// Which effects it calls for, if it is wanted to this tolerance.
    pub fn asked(&self, tolerance: f64) -> Result<NeglectedEffects<'_, E>> {
        let asked = (self.scene).neglected_effects(&self.start, self.end, tolerance)?;
        Ok(if self.of_axis { asked.of_axis() } else { asked })
    }

    /// What leaving out `effect` costs, by the linear response of the motion to it.
    pub fn predicted(&self, effect: &impl Effect) -> Result<PredictedError> {
        self.asked(1e-3)?.predict(effect, 0.0)
    }

    /// The attitudes without an effect and with it, at these times.
    pub fn both(
        &self,
        effect: impl Effect,
        tolerance: f64,
        times: impl Iterator<Item = f64>,
    ) -> kit::Result<Vec<(f64, [Attitude; 2])>> {
        let along = Limits::default();
        let scene = self.scene.clone().with(effect);
        let with = scene.solve_along(&self.start, self.end, tolerance, &along)?;
        let without = (self.scene).solve_along(&self.start, self.end, tolerance, &along)?;
        sampled(times, |t| {
            let [a, b] = [without.try_state(t)?, with.try_state(t)?];
            Ok((t, [a.attitude, b.attitude]))
        })
    }

    /// 400 times of the motion, and that at which leaving it out is predicted to cost most.
    pub fn looks(&self, effect: &impl Effect) -> kit::Result<Vec<f64>> {
        let most = self.predicted(effect)?.time;
        Ok(times(0.0, self.end, 400).chain([most]).collect())
    }

    /// What leaving it out costs by these two simulations.
    pub fn simulated(&self, effect: impl Effect, tolerance: f64) -> kit::Result<f64> {
        let looks = self.looks(&effect)?;
        let both = self.both(effect, tolerance, looks.into_iter())?;
        Ok(largest(both.into_iter().map(|(_, attitudes)| self.apart(attitudes))))
    }
    // ANCHOR_END: weigh

    /// What leaving it out costs, and how that is known: predicted where the response is linear, else
    /// simulated.
    pub fn error_without(&self, effect: impl Effect) -> kit::Result<(f64, &'static str)> {
        let predicted = self.predicted(&effect)?;
        match predicted.linear {
            true => Ok((predicted.predicted, "predicted")),
            false => Ok((self.simulated(effect, 1e-6)?, "simulated")),
        }
    }

    /// Runs of DOP853, coarse to fine: evaluations of the torque, and how far each ends from
    /// `exact`, rad.
    pub fn runs(&self, exact: &Attitude) -> kit::Result<Vec<(f64, f64)>> {
        sampled((0..12).map(f64::from), |n| {
            let method = Dop853::new(1e-2 * pow(10.0, -n))?;
            let (end, work) = method.advance(&self.scene, 0.0, &self.start, self.end)?;
            Ok((work.torques() as f64, self.apart([end.attitude, *exact]).max(1e-15)))
        })
    }
}
