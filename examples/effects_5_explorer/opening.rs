//! The satellite: a symmetric body whose axis leaves L, or comes to it, in closed form.

use super::*;
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::InternalDissipation;
use rotation_dynamics::integrators::scene::{components, state};
use rotation_dynamics::scene::Scene;

/// L upright, the axis at a nutation angle whose tangent is that of the start times e^(t/tau).
#[derive(Debug, Clone, Copy)]
pub struct Opening {
    pub axial: f64,
    pub transverse: f64,
    /// |L|.
    pub momentum: f64,
    /// Nutation angle at the start.
    pub nutation: f64,
    /// 1/tau: positive for a thin body, negative for a flat one.
    pub rate: f64,
}

/// Where a simulation of the satellite ends.
pub struct Reached {
    pub state: State,
    /// The angle between e3 and L.
    pub angle: f64,
    /// The size of its angular velocity.
    pub rate: f64,
    pub energy: f64,
    pub work: Work,
}

impl Opening {
    /// The uniform cylinder of these parameters.
    pub fn new(p: &Parameters) -> Result<Self> {
        let (r, l) = (0.5 * p.diameter, p.length);
        let (axial, transverse) = (0.5 * p.mass * r * r, p.mass * (r * r / 4.0 + l * l / 12.0));
        let ratio = transverse / axial;
        let allowed = if ratio < 1.0 { from_to(0.5, 0.98) } else { from_to(1.02, 1e3) };
        allowed! {
            "size of the spin": p.spin.abs(), above(0.0), "what does not turn has no axis to leave";
            "moment across the axis over that about it": ratio, allowed,
                "at 1 no axis is special, and a needle has no moment about its own";
        }?;
        let sign = if ratio > 1.0 { 1.0 } else { -1.0 };
        Ok(Self {
            axial,
            transverse,
            momentum: axial * p.spin.abs() / cos(p.nutation),
            nutation: p.nutation,
            rate: sign / p.growth,
        })
    }

    /// Longer than wide.
    pub fn thin(&self) -> bool {
        self.transverse > self.axial
    }

    pub fn tau(&self) -> f64 {
        1.0 / self.rate.abs()
    }

    /// a |L|, of the rate.
    pub fn loss(&self) -> f64 {
        self.rate / (self.momentum * self.gap())
    }

    /// 1/I about the axis less 1/I across it.
    fn gap(&self) -> f64 {
        1.0 / self.axial - 1.0 / self.transverse
    }

    /// The same with so much loss that the tangent grows by e within thirty radians, at most,
    /// of the body's turning about its axis.
    pub fn quickened(self) -> Self {
        Self { rate: 0.03 * self.momentum * self.gap(), ..self }
    }

    // ANCHOR: opening
    /// The nutation angle at the time t.
    pub fn angle(&self, t: f64) -> f64 {
        atan2(sin(self.nutation) * exp(self.rate * t), cos(self.nutation))
    }

    /// The angles at the time t: steady precession L/It, and the integral of the spin.
    pub fn angles(&self, t: f64) -> EulerAngles {
        let theta = self.angle(t);
        // The integral of cos(theta) is that of du/(u sqrt(1 + u^2)) in u = tan(theta).
        let reached = |theta: f64| log(tan(0.5 * theta));
        let turned = (reached(theta) - reached(self.nutation)) / self.rate;
        EulerAngles {
            phi: self.momentum / self.transverse * t,
            theta,
            zeta: self.momentum * self.gap() * turned,
        }
    }
    // ANCHOR_END: opening

    /// Attitude and momentum at the time t.
    pub fn state(&self, t: f64) -> Result<State> {
        let up = SpaceVector::new(0.0, 0.0, self.momentum);
        Ok(State::new(Attitude::from_euler(self.angles(t))?, up)?)
    }

    /// The kinetic energy at this nutation angle.
    pub fn energy(&self, theta: f64) -> f64 {
        let (s, c) = (sin(theta), cos(theta));
        0.5 * self.momentum * self.momentum * (c * c / self.axial + s * s / self.transverse)
    }

    /// The body with its loss, and how it starts.
    pub fn scene(&self) -> Result<(Scene<((), InternalDissipation)>, State)> {
        let body = RigidBody::new(PrincipalMoments::symmetric(self.transverse, self.axial)?);
        let loss = InternalDissipation::new(self.loss() / self.momentum)?;
        Ok((Scene::new(body).with(loss), self.state(0.0)?))
    }

    /// By which time the rest is less than a millionth.
    pub fn settled(&self) -> f64 {
        (self.to_go().max(0.0) + 7.0 + log(self.transverse / self.axial).abs()) * self.tau()
    }

    /// The logarithm of what tan(theta) must grow (or fall) by until it is 1.
    pub fn to_go(&self) -> f64 {
        let tangent = tan(self.nutation);
        log(if self.thin() { 1.0 / tangent } else { tangent })
    }

    /// Simulated to the time `end`, by DOP853 with this error of a step.
    pub fn run(&self, end: f64, step: f64) -> Result<Reached> {
        let (scene, start) = self.scene()?;
        let (state, work) = Dop853::new(step)?.advance(&scene, 0.0, &start, end)?;
        let body = scene.body();
        let [x, y, z] = body.angular_momentum(&state).to_array();
        let (angle, rate) = (atan2(hypot(x, y), z), body.angular_velocity(&state).norm());
        Ok(Reached { state, angle, rate, energy: scene.energy(&state), work })
    }

    /// When tan(theta) is this, in the simulation.
    pub fn reaches(&self, tangent: f64) -> Result<f64> {
        let (scene, start) = self.scene()?;
        let body = *scene.body();
        let off = move |y: &[f64; 7]| {
            state(y).map_or(f64::NAN, |state| {
                let [x, y, z] = body.angular_momentum(&state).to_array();
                log(hypot(x, y) / (z * tangent))
            })
        };
        let until = 40.0 * self.tau();
        Ok(Dop853::new(1e-13)?.zero(&scene, components(&start), 1, until, off)?.0.t)
    }
}
