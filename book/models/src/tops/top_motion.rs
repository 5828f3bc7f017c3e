//! From a throw to the end.

use super::configuration::Coordinates;
use super::motion::{Scene, checked};
use super::{Configuration, ContactMode, Forces, Phase, ResistingMoment, TipFriction, Top};
use rotation_dynamics::effects::Effect;
use rotation_dynamics::error::Result;
use rotation_dynamics::frame::SpaceVector;
use rotation_dynamics::integrators::{Dop853, Work};
use rotation_dynamics::math::{hypot, sincos};
use rotation_dynamics::planar::{Run, Transition, simulate};

/// How a top starts, leaning towards X: angles in rad, rates in rad/s.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Throw {
    /// The tilt of its axis.
    pub tilt: f64,
    /// The angular velocity along the axis.
    pub spin: f64,
    /// The rate at which the axis goes round the vertical.
    pub precession: f64,
    /// The rate at which the tilt grows.
    pub nutation: f64,
    /// The velocity of the centre of mass over the floor (m/s); `None`: the tip rolls.
    pub velocity: Option<[f64; 2]>,
}

impl Throw {
    /// With this tilt and this spin, and otherwise at rest.
    pub const fn spinning(tilt: f64, spin: f64) -> Self {
        Self { tilt, spin, precession: 0.0, nutation: 0.0, velocity: Some([0.0; 2]) }
    }

    /// The same with this precession (rad/s).
    #[must_use]
    pub const fn precessing(self, precession: f64) -> Self {
        Self { precession, ..self }
    }

    /// The same with a tip that rolls from the start.
    #[must_use]
    pub const fn rolling(self) -> Self {
        Self { velocity: None, ..self }
    }
}

/// The motion of a top from its throw on.
#[derive(Debug, Clone)]
pub struct TopMotion<F, R, E> {
    top: Top<F, R, E>,
    run: Run<Phase, 14>,
}

impl<F: TipFriction, R: ResistingMoment, E: Effect + Clone> Top<F, R, E> {
    /// The motion from this throw, until `t_end` (s) or until it falls or lifts off; the error
    /// of a step is held to `tolerance`, from 1e-15 to 0.1.
    ///
    /// The events are `grips` (the tip stops sliding and rolls), `slips` (friction no longer holds
    /// it), `falls` (the rim touches), `lifts off` (the floor would have to pull) and the marks of
    /// [`Top::passing`]. All are located by real steps, as accurately as the motion. A tip counts
    /// as stopped when it is slower than 10 tolerances of sqrt(g (l + r)), and begins to slip with
    /// 1e-8 of that speed or 100 tolerances.
    ///
    /// Accuracy, as measured at tolerance 1e-13: 5e-11 rad after 3 s of nutation, against the heavy
    /// top in closed form. Jellett's integral, energy and momenta, where they are kept, are within
    /// 1.2e-14 of themselves over 2 s. After a slip from rest 2e-7 of the time of the fall, by the
    /// speed with which it begins.
    ///
    /// Cost: about 15 derivatives a step, and steps that follow the nutation, whose rate is
    /// I3 omega/I1, even where there is none to be seen. A tip on [`Dry`](super::Dry) friction
    /// that slides for long with a slip close to zero makes the equations stiff, and may need
    /// more steps than the method allows; a [`Patch`](super::Patch) creeps there instead.
    ///
    /// # Errors
    /// A throw that is not finite; a start that the floor would have to hold down or with the rim
    /// in the floor ([`CannotHold`](rotation_dynamics::Error::CannotHold)); the errors of [`simulate`].
    pub fn simulate(
        &self,
        throw: &Throw,
        t_end: f64,
        tolerance: f64,
    ) -> Result<TopMotion<F, R, E>> {
        let method = Dop853::new(tolerance)?;
        let scene = Scene { top: self, step: tolerance };
        let (phase, start) = self.start(&scene, throw)?;
        let run = simulate(&scene, &method, phase, start, t_end)?;
        Ok(TopMotion { top: self.clone(), run })
    }

    fn start(&self, scene: &Scene<'_, F, R, E>, throw: &Throw) -> Result<(Phase, Coordinates)> {
        let (s, c) = sincos(throw.tilt);
        let axis = SpaceVector::new(s, 0.0, c);
        // Z less its part along e3, so that the spin is the whole of what is along e3.
        let across = SpaceVector::new(-s * c, 0.0, s * s);
        let omega = axis * throw.spin
            + across * throw.precession
            + SpaceVector::new(0.0, throw.nutation, 0.0);
        let [l1, l2, l3] = self.momentum(axis, omega).to_array();
        let [w, x, y, z] = Self::leaning(throw.tilt);
        let shape = self.shape();
        let height = shape.tip() + shape.lever() * c;
        let [vx, vy] = throw.velocity.unwrap_or([0.0; 2]);
        let [px, py] = [vx, vy].map(|v| shape.mass() * v);
        let start = checked([w, x, y, z, 0.0, l1, l2, l3, 0.0, 0.0, height, px, py, 0.0])?;
        let [sliding, rolling] = [ContactMode::Sliding, ContactMode::Rolling]
            .map(|contact| Phase { contact, passed: 0 });
        let rolls = throw.velocity.is_none() || !F::SLIDES;
        let first = if rolls { rolling } else { sliding };
        let start = scene.settled(&self.configuration(first, &start), &start);
        let slip = self.configuration(sliding, &start).slip;
        let still = hypot(slip.x(), slip.y()) <= 1e-7 * scene.speed();
        Ok(match (F::STICKS, F::SLIDES) {
            (true, false) => (rolling, start),
            (true, true) if still => scene.stuck(0, &start),
            _ => (sliding, start),
        })
    }
}

impl<F: TipFriction, R: ResistingMoment, E: Effect> TopMotion<F, R, E> {
    /// The top.
    pub const fn top(&self) -> &Top<F, R, E> {
        &self.top
    }

    /// The motion as a run of phases.
    pub const fn run(&self) -> &Run<Phase, 14> {
        &self.run
    }

    /// When it ends (s).
    pub fn end_time(&self) -> f64 {
        self.run.end_time()
    }

    /// Its cost.
    pub fn work(&self) -> Work {
        self.run.work()
    }

    /// The first event with this name.
    ///
    /// # Errors
    /// [`NotReached`](rotation_dynamics::Error::NotReached) if there was none.
    pub fn event(&self, name: &'static str) -> Result<&Transition<Phase, 14>> {
        self.run.transition(name)
    }

    /// The top as it is when an event comes, before anything changes.
    pub fn configuration_at(&self, event: &Transition<Phase, 14>) -> Configuration {
        self.top.configuration(event.from, &event.before)
    }

    /// The phase at the time `t`.
    ///
    /// # Errors
    /// [`OutsideRun`](rotation_dynamics::Error::OutsideRun), as of all that follow.
    pub fn phase(&self, t: f64) -> Result<Phase> {
        Ok(self.run.at(t)?.0)
    }

    /// The coordinates at the time `t`, for [`Top::attitude`].
    pub fn coordinates(&self, t: f64) -> Result<Coordinates> {
        Ok(self.run.at(t)?.1)
    }

    /// The top at the time `t`.
    pub fn configuration(&self, t: f64) -> Result<Configuration> {
        let (phase, y) = self.run.at(t)?;
        Ok(self.top.configuration(phase, &y))
    }

    /// The top at the time `t`, and the forces of the floor on it.
    pub fn forces(&self, t: f64) -> Result<(Configuration, Forces)> {
        let (phase, y) = self.run.at(t)?;
        let at = self.top.configuration(phase, &y);
        Ok((at, self.top.forces(phase, &at, &y)))
    }
}
