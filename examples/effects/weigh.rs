//! One effect after the other: what leaving it out costs, predicted and simulated.

use rotation_dynamics::Result;
use rotation_dynamics::accuracy::{Limits, PredictedError};
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::State;
use rotation_dynamics::effects::Effect;
use rotation_dynamics::integrators::{Dop853, Integrator};
use rotation_dynamics::math::{atan2, log10, pow};
use rotation_dynamics::motion::Motion;
use rotation_dynamics::scene::Scene;

/// Places at which two motions are compared.
const PLACES: u32 = 400;

/// An effect that a scene leaves out.
#[derive(Debug, Clone)]
pub struct LeftOut {
    pub name: &'static str,
    /// The error of leaving it out, rad: predicted if that is linear, else simulated.
    pub error: f64,
    pub how: &'static str,
}

impl LeftOut {
    pub fn new(name: &'static str, error: f64, how: &'static str) -> Self {
        Self { name, error, how }
    }

    /// Decimal digits of a radian that are worth having without this effect.
    pub fn digits(&self) -> f64 {
        -log10(self.error)
    }
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
    /// The angle between two attitudes as far as it is asked for, rad.
    pub fn apart(&self, a: &Attitude, b: &Attitude) -> f64 {
        if self.of_axis {
            let (a, b) = (a.axis(), b.axis());
            atan2(a.cross(&b).norm(), a.dot(&b))
        } else {
            a.angle_to(b)
        }
    }

    // ANCHOR: weigh
    /// What leaving out `effect` costs, by the linear response of the motion to it.
    pub fn predicted(&self, effect: &impl Effect) -> Result<PredictedError> {
        let asked = self.scene.neglected_effects(&self.start, self.end, 1e-3)?;
        let asked = if self.of_axis { asked.of_axis() } else { asked };
        asked.predict(effect, 0.0)
    }

    /// The same by two simulations, with it and without.
    pub fn simulated(&self, effect: impl Effect, tolerance: f64) -> Result<f64> {
        let limits = Limits::default();
        let with = self.scene.clone().with(effect);
        let with = with.solve_along(&self.start, self.end, tolerance, &limits)?;
        let without = (self.scene).solve_along(&self.start, self.end, tolerance, &limits)?;
        let mut largest = 0.0_f64;
        for n in 1..=PLACES {
            let t = self.end * (f64::from(n) / f64::from(PLACES));
            let (a, b) = (with.try_state(t)?, without.try_state(t)?);
            largest = largest.max(self.apart(&a.attitude, &b.attitude));
        }
        Ok(largest)
    }
    // ANCHOR_END: weigh

    /// Predicted where that can be believed, else simulated.
    pub fn left_out(&self, name: &'static str, effect: impl Effect) -> Result<LeftOut> {
        let predicted = self.predicted(&effect)?;
        if predicted.linear {
            return Ok(LeftOut::new(name, predicted.predicted, "predicted"));
        }
        let error = self.simulated(effect, 1e-6)?;
        Ok(LeftOut::new(name, error, "simulated"))
    }

    /// Runs of DOP853, coarse to fine: evaluations of the torque, and how far each ends from
    /// `exact`, rad.
    pub fn runs(&self, exact: &Attitude) -> kit::Result<Vec<(f64, f64)>> {
        let mut runs = Vec::new();
        for n in 0..12 {
            let method = Dop853::new(1e-2 * pow(10.0, -f64::from(n)))?;
            let (end, work) = method.advance(&self.scene, 0.0, &self.start, self.end)?;
            let off = self.apart(&end.attitude, exact).max(1e-15);
            runs.push((work.torques() as f64, off));
        }
        Ok(runs)
    }
}
