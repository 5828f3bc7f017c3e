//! Two motions without a closed form, and how their ends are known all the same: two
//! methods that share nothing but the scene agree there.

use super::*;
use block::{coasting, tilted};
use motions::{Motion, THIRD, tumbling};
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
    let carry = move |state: &State, span: [f64; 2]| {
        let axes = BodyAxes::new(&scene)?;
        Ok(fine(span)?.advance(&axes, span[0], state, span[1])?.0)
    };
    let problem = Problem::new(scene, start, end, carry(&start, [0.0, end])?);
    let names = ("lopsided", "heavy, three moments");
    Ok(Motion::carried(names, problem, periods, carry))
}

/// A torque of 0.02 along Z, from a time on and until another.
#[derive(Clone, Copy)]
pub struct Push([f64; 2]);

impl Push {
    const TORQUE: f64 = 0.02;
    const ALWAYS: Self = Self([f64::NEG_INFINITY, f64::INFINITY]);
}

impl Effect for Push {
    const PROPERTIES: Properties = Properties {
        on_rates: false,
        smooth: true, // but for its jumps
        conserved: Conserved { momentum: [true, true, false], ..Conserved::NONE },
        ..Properties::ANYTHING
    };

    fn name(&self) -> &'static str {
        "push"
    }

    fn torque(&self, t: f64, _body: &RigidBody, _state: &State) -> SpaceVector {
        let Self([on, off]) = *self;
        let acts = (on..off).contains(&t);
        SpaceVector::new(0.0, 0.0, if acts { Self::TORQUE } else { 0.0 })
    }

    fn break_points(&self) -> Vec<f64> {
        self.0.to_vec()
    }

    fn torque_scale(&self, _t: f64, _body: &RigidBody, _state: &State) -> f64 {
        Self::TORQUE
    }
}

/// The state at `to` of a body that is pushed: piece by piece between the jumps, by a method where
/// there is a torque, and in closed form where there is none.
fn piecewise<M: Integrator<Scene<((), Push)>, State>>(
    body: &RigidBody,
    Push([on, off]): Push,
    state: &State,
    [from, to]: [f64; 2],
    method: impl Fn([f64; 2]) -> Result<M>,
) -> Result<State> {
    let coast = |state: State, time: f64| match time > 0.0 {
        true => coasting(body, &state, time),
        false => Ok(state),
    };
    let mut state = coast(*state, to.min(on) - from)?;
    let (start, end) = (from.max(on), to.min(off));
    if start < end {
        let scene = Scene::new(*body).with(Push::ALWAYS);
        (state, _) = method([start, end])?.advance(&scene, start, &state, end)?;
    }
    coast(state, to - from.max(off))
}

/// The free body of the page, and what pushes it: from 23 % to 61 % of the time.
fn thrust(p: &Parameters) -> Result<(Problem<()>, Push)> {
    let free = tumbling(p)?;
    let push = Push([0.23 * free.end, 0.61 * free.end]);
    Ok((free, push))
}

/// The free body, pushed for a while.
pub fn pushed(p: &Parameters) -> Result<Motion> {
    let (free, push) = thrust(p)?;
    let (body, start, end) = (*free.scene.body(), free.start, free.end);
    let carry = move |state: &State, span| piecewise(&body, push, state, span, fine);
    let problem = Problem::new(free.scene.with(push), start, end, carry(&start, [0.0, end])?);
    let names = ("pushed", "pushed for a while");
    Ok(Motion::carried(names, problem, p.periods + THIRD, carry))
}

/// Error of a step of DOP853 where the body is pushed.
const STEP: f64 = 1e-14;

/// How many errors of a step add up in a period, at most, before the path magnifies them.
/// Measured: 0.016 for the page's body, from 7e-6 to 0.13 for I1 from 1.5 to 4.1, and 0.08
/// over a hundred periods.
const STEPS_ASTRAY: f64 = 1.6;

/// The second routes to the two ends.
pub fn limits(p: &Parameters, report: &mut Report) -> kit::Result<()> {
    let all = prepared(p)?;
    let [lopsided, pushed] = ["lopsided", "pushed"].map(|key| lines::of(&all, key));
    let (Some(lopsided), Some(pushed)) = (lopsided, pushed) else { return Ok(()) };
    let heavy = &lopsided.motion;
    let (split, _) = heavy.problem.run(Method::KahanLi17, 20.0 * heavy.end)?;
    let (free, push) = thrust(p)?;
    let (body, span) = (free.scene.body(), [0.0, free.end]);
    let dop = piecewise(body, push, &free.start, span, |_| Dop853::new(STEP))?;
    let bound = STEPS_ASTRAY * p.periods * STEP * pushed.path_condition.1;
    limits! { report,
        /// two methods that share nothing but the scene
        "heavy, three moments: Gauss-Legendre and Kahan-Li, apart in rad":
            heavy.problem.errors(&split).attitude => 0.0, within 1e-12;
        /// two methods on pieces that are smooth
        "pushed for a while: Gauss-Legendre and DOP853, started anew at each jump, apart in rad":
            pushed.motion.problem.errors(&dop).attitude => 0.0, within bound;
    }
}
