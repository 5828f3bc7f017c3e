//! Two motions without a closed form, and how their ends are known all the same: two
//! methods that share nothing but the scene agree there.

use super::motions::{Motion, THIRD, free_problem, generic_rates, tilted, unpushed};
use kit::Report;
use rotation_dynamics::Result;
use rotation_dynamics::accuracy::Problem;
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::{Conserved, Effect, GravityAtLever, Properties};
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::gauss_legendre::BodyAxes;
use rotation_dynamics::integrators::{Dop853, GaussLegendre, Integrator, Scheme, Splitting};
use rotation_dynamics::scene::Scene;

/// Gravity, and no other effect.
pub type Gravity = ((), GravityAtLever);

/// Steps of Gauss-Legendre in a second: many more than any method in a race needs.
const STEPS: f64 = 8.0;

/// Gauss-Legendre in steps so short that only rounding is left.
fn fine([from, to]: [f64; 2]) -> Result<GaussLegendre> {
    GaussLegendre::new(((to - from).abs() * STEPS).ceil().max(1.0) as u64)
}

/// The heavy body on its own axes.
fn carried(scene: &Scene<Gravity>, state: &State, [from, to]: [f64; 2]) -> Result<State> {
    let axes = BodyAxes::new(scene)?;
    Ok(fine([from, to])?.advance(&axes, from, state, to)?.0)
}

/// The heavy body of three different moments, and how it starts.
pub fn heavy() -> kit::Result<(Scene<Gravity>, State)> {
    let (body, start) = tilted(
        PrincipalMoments::new(1.0, 1.5, 0.8)?,
        BodyVector::new(0.3, 0.1, 2.0),
    )?;
    Ok((Scene::new(body).with(GravityAtLever::new(1.0, 0.4)?), start))
}

/// A heavy body with three different moments, for four seconds a period.
pub fn lopsided(periods: f64) -> kit::Result<Motion> {
    let (scene, start) = heavy()?;
    let end = 4.0 * periods;
    let onward = move |state: &State, t, to| carried(&scene, state, [t, to]);
    let problem = Problem::new(scene, start, end, onward(&start, 0.0, end)?);
    let name = ("lopsided", "heavy, three moments");
    Ok(Motion::stepped(name, problem, periods, onward))
}

// ANCHOR: push
/// A torque along Z that is switched on and off.
#[derive(Clone, Copy)]
pub struct Push {
    torque: f64,
    on: f64,
    off: f64,
}

impl Effect for Push {
    const PROPERTIES: Properties = Properties {
        on_rates: false,
        smooth: true, // but for its jumps
        conserved: Conserved {
            momentum: [true, true, false],
            ..Conserved::NONE
        },
        ..Properties::ANYTHING
    };

    fn name(&self) -> &'static str {
        "push"
    }

    fn torque(&self, t: f64, _body: &RigidBody, _state: &State) -> SpaceVector {
        let now = if (self.on..self.off).contains(&t) {
            self.torque
        } else {
            0.0
        };
        SpaceVector::new(0.0, 0.0, now)
    }

    fn break_points(&self) -> Vec<f64> {
        vec![self.on, self.off]
    }
    // ANCHOR_END: push

    fn torque_scale(&self, _t: f64, _body: &RigidBody, _state: &State) -> f64 {
        self.torque
    }
}

/// The same torque all the time, smooth.
#[derive(Clone, Copy)]
struct Steady(Push);

impl Effect for Steady {
    const PROPERTIES: Properties = Properties {
        on_time: false,
        smooth: true,
        ..Push::PROPERTIES
    };

    fn name(&self) -> &'static str {
        "steady push"
    }

    fn torque(&self, _t: f64, _body: &RigidBody, _state: &State) -> SpaceVector {
        SpaceVector::new(0.0, 0.0, self.0.torque)
    }

    fn torque_scale(&self, _t: f64, _body: &RigidBody, _state: &State) -> f64 {
        self.0.torque
    }
}

fn finely(scene: &Scene<((), Steady)>, state: &State, [from, to]: [f64; 2]) -> Result<State> {
    Ok(fine([from, to])?.advance(scene, from, state, to)?.0)
}

/// The state at `to` of a body that is pushed: piece by piece between the jumps, in closed
/// form where there is no torque.
fn piecewise(
    body: &RigidBody,
    push: Push,
    state: &State,
    [from, to]: [f64; 2],
    pushed: impl Fn(&Scene<((), Steady)>, &State, [f64; 2]) -> Result<State>,
) -> Result<State> {
    let coast = |state: State, dt: f64| -> Result<State> {
        if dt <= 0.0 {
            return Ok(state);
        }
        let attitude = unpushed(body, &state)?.attitude(dt);
        State::new(attitude, state.angular_momentum)
    };
    let scene = Scene::new(*body).with(Steady(push));
    let mut state = coast(*state, to.min(push.on) - from)?;
    let (on, off) = (from.max(push.on), to.min(push.off));
    if on < off {
        state = pushed(&scene, &state, [on, off])?;
    }
    coast(state, to - from.max(push.off))
}

/// The body, its start, what pushes it, and the end.
fn thrust(moments: PrincipalMoments, periods: f64) -> Result<(RigidBody, State, Push, f64)> {
    let end = free_problem(moments, generic_rates(moments), periods)?.end;
    let (body, start) = tilted(moments, generic_rates(moments))?;
    let push = Push {
        torque: 0.02,
        on: 0.23 * end,
        off: 0.61 * end,
    };
    Ok((body, start, push, end))
}

/// The free body, pushed from 23 % to 61 % of the time.
pub fn pushed(moments: PrincipalMoments, periods: f64) -> Result<Motion> {
    let (body, start, push, t_end) = thrust(moments, periods)?;
    let onward = move |state: &State, t, to| piecewise(&body, push, state, [t, to], finely);
    let end = onward(&start, 0.0, t_end)?;
    let problem = Problem::new(Scene::new(body).with(push), start, t_end, end);
    let name = ("pushed", "pushed for a while");
    Ok(Motion::stepped(name, problem, periods, onward))
}

/// Error of a step of DOP853 where the body is pushed.
const STEP: f64 = 1e-14;

/// How many errors of a step add up in a period, at most, before the path magnifies them.
/// Measured: 0.016 for the page's body, from 7e-6 to 0.13 for I1 from 1.5 to 4.1, and 0.08
/// over a hundred periods.
const STEPS_ASTRAY: f64 = 1.6;

/// The second routes to the two ends; `condition` is the path condition of the pushed body.
pub fn add(
    report: &mut Report,
    (moments, periods): (PrincipalMoments, f64),
    condition: f64,
) -> kit::Result<()> {
    let (scene, start) = heavy()?;
    let end = 4.0 * periods;
    let gauss = carried(&scene, &start, [0.0, end])?;
    let splitting = Splitting::new(Scheme::KAHAN_LI17, (20.0 * end) as u64)?;
    let (split, _) = splitting.advance(&scene, 0.0, &start, end)?;
    let apart = gauss.attitude.angle_to(&split.attitude);
    kit::limits! { report,
        /// two methods that share nothing but the scene
        "heavy, three moments: Gauss-Legendre and Kahan-Li, apart in rad":
            apart => 0.0, within 1e-12;
    }?;
    let (body, start, push, end) = thrust(moments, periods + THIRD)?;
    let span = [0.0, end];
    let gauss = piecewise(&body, push, &start, span, finely)?;
    let dop = piecewise(&body, push, &start, span, |scene, state, [from, to]| {
        Ok(Dop853::new(STEP)?.advance(scene, from, state, to)?.0)
    })?;
    let apart = gauss.attitude.angle_to(&dop.attitude);
    let bound = STEPS_ASTRAY * periods * STEP * condition;
    kit::limits! { report,
        /// two methods on pieces that are smooth
        "pushed for a while: Gauss-Legendre and DOP853, started anew at each jump, apart in rad":
            apart => 0.0, within bound;
    }
}
