//! Two motions without a closed form, and how their ends are known all the same: two
//! methods that share nothing but the scene agree there.

use super::*;
use motions::{Motion, THIRD, coasting, free_problem, generic_rates, tilted};
use rotation_dynamics::effects::{Conserved, Properties};
use rotation_dynamics::integrators::gauss_legendre::BodyAxes;

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
pub fn heavy() -> Result<(Scene<Gravity>, State)> {
    let moments = PrincipalMoments::new(1.0, 1.5, 0.8)?;
    let (body, start) = tilted(moments, BodyVector::new(0.3, 0.1, 2.0))?;
    Ok((Scene::new(body).with(GravityAtLever::new(1.0, 0.4)?), start))
}

/// A heavy body with three different moments, for four seconds a period.
pub fn lopsided(periods: f64) -> Result<Motion> {
    let (scene, start) = heavy()?;
    let end = 4.0 * periods;
    let answer = carried(&scene, &start, [0.0, end])?;
    let problem = Problem::new(scene, start, end, answer);
    let carry = move |state: &State, span| carried(&scene, state, span);
    let names = ("lopsided", "heavy, three moments");
    Ok(Motion::carried(names, problem, periods, carry))
}

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
        let acts = (self.on..self.off).contains(&t);
        SpaceVector::new(0.0, 0.0, if acts { self.torque } else { 0.0 })
    }

    fn break_points(&self) -> Vec<f64> {
        vec![self.on, self.off]
    }

    fn torque_scale(&self, _t: f64, _body: &RigidBody, _state: &State) -> f64 {
        self.torque
    }
}

impl Push {
    /// The same torque at all times.
    fn steady(self) -> Self {
        let (on, off) = (f64::NEG_INFINITY, f64::INFINITY);
        Self { on, off, ..self }
    }
}

type Pushed = Scene<((), Push)>;

fn finely(scene: &Pushed, state: &State, [from, to]: [f64; 2]) -> Result<State> {
    Ok(fine([from, to])?.advance(scene, from, state, to)?.0)
}

/// The state at `to` of a body that is pushed: piece by piece between the jumps, in closed
/// form where there is no torque.
fn piecewise(
    body: &RigidBody,
    push: Push,
    state: &State,
    [from, to]: [f64; 2],
    pushed: impl Fn(&Pushed, &State, [f64; 2]) -> Result<State>,
) -> Result<State> {
    let coast = |state: State, time: f64| match time > 0.0 {
        true => coasting(body, &state, time),
        false => Ok(state),
    };
    let mut state = coast(*state, to.min(push.on) - from)?;
    let (on, off) = (from.max(push.on), to.min(push.off));
    if on < off {
        state = pushed(&Scene::new(*body).with(push.steady()), &state, [on, off])?;
    }
    coast(state, to - from.max(push.off))
}

/// The free body with what pushes it, from 23 % to 61 % of the time.
fn thrust(moments: PrincipalMoments, periods: f64) -> Result<(Problem<()>, Push)> {
    let free = free_problem(moments, generic_rates(moments), periods)?;
    let push = Push {
        torque: 0.02,
        on: 0.23 * free.end,
        off: 0.61 * free.end,
    };
    Ok((free, push))
}

/// The free body, pushed for a while.
pub fn pushed(moments: PrincipalMoments, periods: f64) -> Result<Motion> {
    let (
        Problem {
            scene, start, end, ..
        },
        push,
    ) = thrust(moments, periods)?;
    let body = *scene.body();
    let carry = move |state: &State, span| piecewise(&body, push, state, span, finely);
    let problem = Problem::new(scene.with(push), start, end, carry(&start, [0.0, end])?);
    let names = ("pushed", "pushed for a while");
    Ok(Motion::carried(names, problem, periods, carry))
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
    let heavy = gauss.attitude.angle_to(&split.attitude);

    let (free, push) = thrust(moments, periods + THIRD)?;
    let (body, span) = (free.scene.body(), [0.0, free.end]);
    let gauss = piecewise(body, push, &free.start, span, finely)?;
    let dop = piecewise(body, push, &free.start, span, |scene, state, [from, to]| {
        Ok(Dop853::new(STEP)?.advance(scene, from, state, to)?.0)
    })?;
    let pushed = gauss.attitude.angle_to(&dop.attitude);
    let bound = STEPS_ASTRAY * periods * STEP * condition;
    limits! { report,
        /// two methods that share nothing but the scene
        "heavy, three moments: Gauss-Legendre and Kahan-Li, apart in rad":
            heavy => 0.0, within 1e-12;
        /// two methods on pieces that are smooth
        "pushed for a while: Gauss-Legendre and DOP853, started anew at each jump, apart in rad":
            pushed => 0.0, within bound;
    }
}
