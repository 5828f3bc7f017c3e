//! A motion as a scene for the methods that step, with its exact answer.

use super::Motion;
use kit::{Report, Result};
use rotation_dynamics::accuracy::Problem;
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::GravityAtLever;
use rotation_dynamics::frame::BodyVector;
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::math::sincos;
use rotation_dynamics::scene::Scene;

/// The effects of a heavy top: gravity, and no other.
pub type Gravity = ((), GravityAtLever);

impl Motion {
    /// The motion as a scene in units of t': I1 = 1, I3 = a, m g l = c, L_z = sqrt(a).
    ///
    /// # Errors
    /// None for a motion with weight whose start is clear of the poles.
    pub fn problem(&self) -> Result<Problem<Gravity>> {
        let (a, b, c) = (self.top.a(), self.top.b(), self.top.c());
        let body = RigidBody::new(PrincipalMoments::symmetric(1.0, a)?);
        let scene = Scene::new(body).with(GravityAtLever::new(c.abs(), c.signum())?);
        let [theta, nutation, ..] = self.start();
        let (s, u) = sincos(theta);
        // phi' sin(theta) along y, and 1/sqrt(a) along the axis; zeta = 0 at the start.
        let omega = BodyVector::new(nutation, a.sqrt() * (b - u) / s, 1.0 / a.sqrt());
        let start = body.state(self.exact.attitude(0.0), omega)?;
        let (exact, unit, end) = (self.exact.clone(), self.unit, self.end);
        let reached = State::new(exact.attitude(end), exact.angular_momentum(end))?;
        let problem = Problem::new(scene, start, self.end_reduced(), reached);
        Ok(problem.in_closed_form(move |t| exact.attitude(t * unit)))
    }

    /// Adds the accuracy strip for `tolerance` (rad) and three others; nothing for a motion
    /// without weight or close to a pole, which the strip's plain start would not resolve.
    ///
    /// # Errors
    /// As [`Report::strip`].
    pub fn strip(&self, report: &mut Report, tolerance: f64) -> Result<()> {
        if self.top.c() == 0.0 || !self.clear_of_poles() {
            return Ok(());
        }
        let problem = self.problem()?;
        report.strip(&problem, &[tolerance, 1e-3, 1e-6, 1e-12])
    }
}
