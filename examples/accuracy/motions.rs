//! The motions: five with closed forms, from easy to hard, a heavy body with three
//! different moments, and a body pushed for a while.

use kit::Report;
use rotation_dynamics::accuracy::{Errors, Problem, Resolution, Solved, Sweep, Variables, applies};
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::{Effect, GravityAtLever};
use rotation_dynamics::exact::free_body::FreeBody;
use rotation_dynamics::exact::heavy_top::{HeavyTop, ReducedTop, Start};
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::{Method, Work};
use rotation_dynamics::math::sincos;
use rotation_dynamics::scene::{Invariant, Scene};
use rotation_dynamics::{Error, Result};

use super::angles::Angles;
use super::rough;

/// What is asked of a problem, whatever acts in it.
pub trait Raced: Send + Sync {
    fn applies(&self, method: Method) -> bool;
    /// A method in the variables that suit it best.
    fn run(&self, method: Method, setting: f64) -> Result<(State, Work)>;
    fn sweep(&self, method: Method, settings: &[f64]) -> Sweep;
    fn errors(&self, reached: &State) -> Errors;
    fn solved(&self, tolerance: f64) -> Result<Solved>;
    fn add_strip(&self, report: &mut Report, tolerances: &[f64]) -> kit::Result<()>;
}

impl<E: Effect + Clone + Send + Sync + 'static> Raced for Problem<E> {
    fn applies(&self, method: Method) -> bool {
        applies::<E>(method)
    }

    fn run(&self, method: Method, setting: f64) -> Result<(State, Work)> {
        let variables = Variables::best(method, &self.scene);
        Problem::run(self, method, variables, Resolution::of(method, setting))
    }

    fn sweep(&self, method: Method, settings: &[f64]) -> Sweep {
        let variables = Variables::best(method, &self.scene);
        Problem::sweep(self, method, variables, settings.iter().copied())
    }

    fn errors(&self, reached: &State) -> Errors {
        Problem::errors(self, reached)
    }

    fn solved(&self, tolerance: f64) -> Result<Solved> {
        super::solved(self, tolerance)
    }

    fn add_strip(&self, report: &mut Report, tolerances: &[f64]) -> kit::Result<()> {
        report.strip(self, tolerances)
    }
}

type StateAt = Box<dyn Fn(f64) -> Result<State> + Send + Sync>;
type Continued = Box<dyn Fn(&State, f64) -> Result<Attitude> + Send + Sync>;

/// A motion, with all that is asked of it.
pub struct Motion {
    /// For keys.
    pub key: &'static str,
    /// For tables.
    pub name: &'static str,
    pub end: f64,
    /// The end in periods; in units of four seconds where there is no period.
    pub periods: f64,
    pub problem: Box<dyn Raced>,
    /// The state at a time.
    state: StateAt,
    /// The attitude at the end of a motion that is in a state at a time.
    continued: Continued,
    /// The top in the notes' angles.
    pub angles: Option<Angles>,
    /// Whether there is a closed form.
    exact: bool,
    /// At how many points of the path it is disturbed.
    nodes: u32,
}

/// 1e-4 rad off the axis of the intermediate moment.
const NEAR_MIDDLE: BodyVector = BodyVector::new(0.0, 1.0, 1e-4);

/// What is added to a whole number of periods: at the whole number, where the motion is
/// symmetric in time, a symmetric method's error of the energy vanishes by luck.
pub const THIRD: f64 = 1.0 / 3.0;

// ANCHOR: motions
/// All of them, over so many periods (of the rates, or of the nods).
pub fn all(moments: PrincipalMoments, periods: f64) -> kit::Result<Vec<Motion>> {
    // Figure 3 of the notes: a = 2, b = 1.2, c = 0.2, E~ = 0.55.
    let notes = (ReducedTop::new(2.0, 1.2, 0.2)?, 0.55, Start::ThetaMin);
    // A fast top released at rest: cusps, ten thousand nods in one round.
    let fast = ReducedTop::new(2.0, 0.6, 1e-4)?;
    let cusps = (fast, fast.cusp_energy().unwrap_or(0.0), Start::ThetaMin);
    // A top thrown so that its axis passes the vertical at 1e-4 rad.
    let (sin, cos) = sincos(1e-4);
    let energy: f64 = 0.55;
    let passing = ReducedTop::new(2.0, cos + sin * energy.sqrt(), 0.2)?;
    let passing = (passing, energy, Start::ThetaMax);
    Ok(vec![
        free(
            "free",
            "free body",
            moments,
            generic_rates(moments),
            periods + THIRD,
        )?,
        top("top", "heavy top", notes, periods + THIRD)?,
        top("fast", "fast top", cusps, 10.0 * periods + THIRD)?,
        // From 1e-4 off the intermediate axis: two flips a period. It ends in the middle of a
        // flip, where the attitude is most sensitive.
        free("flips", "flips", moments, NEAR_MIDDLE, 0.5 * periods - 0.25)?,
        top("pole", "past the pole", passing, periods + THIRD)?,
        rough::lopsided(periods)?,
        rough::pushed(moments, periods + THIRD)?,
    ])
}
// ANCHOR_END: motions

/// A body tilted as the free ones are, with these rates.
pub fn tilted(moments: PrincipalMoments, rates: BodyVector) -> Result<(RigidBody, State)> {
    let body = RigidBody::new(moments);
    let attitude = Attitude::from_euler(EulerAngles {
        phi: 0.3,
        theta: 0.7,
        zeta: -0.4,
    })?;
    Ok((body, body.state(attitude, rates)?))
}

/// The motion without torque from a state.
pub fn unpushed(body: &RigidBody, state: &State) -> Result<FreeBody> {
    FreeBody::new(body.moments(), state.attitude, body.angular_velocity(state))
}

/// L = (0.8, 0.8, 0.9) on the body axes.
pub fn generic_rates(moments: PrincipalMoments) -> BodyVector {
    let [i1, i2, i3] = moments.to_array();
    BodyVector::new(0.8 / i1, 0.8 / i2, 0.9 / i3)
}

/// A free body for so many periods of its rates, or why it has none.
pub fn free_problem(
    moments: PrincipalMoments,
    rates: BodyVector,
    periods: f64,
) -> Result<Problem<()>> {
    let (body, start) = tilted(moments, rates)?;
    let exact = unpushed(&body, &start)?;
    let period = exact.rate_period();
    if !period.is_finite() {
        return Err(Error::out_of_range(
            "I2",
            moments.i2(),
            "between I1 and I3, and equal to neither: the body must tumble",
        ));
    }
    let end = periods * period;
    let answer = State::new(exact.attitude(end), start.angular_momentum)?;
    let problem = Problem::new(Scene::new(body), start, end, answer);
    Ok(problem.in_closed_form(move |t| exact.attitude(t)))
}

fn free(
    key: &'static str,
    name: &'static str,
    moments: PrincipalMoments,
    rates: BodyVector,
    periods: f64,
) -> kit::Result<Motion> {
    let problem = free_problem(moments, rates, periods)?;
    let (body, start, end) = (*problem.scene.body(), problem.start, problem.end);
    let exact = unpushed(&body, &start)?;
    let state = move |t: f64| State::new(exact.attitude(t), start.angular_momentum);
    Ok(Motion {
        key,
        name,
        end,
        periods,
        problem: Box::new(problem),
        state: Box::new(state),
        continued: Box::new(move |from, t| Ok(unpushed(&body, from)?.attitude(end - t))),
        angles: None,
        exact: true,
        nodes: 96,
    })
}

/// In units of t': I1 = 1, I3 = a, m g l = c, L_z = sqrt(a).
fn top(
    key: &'static str,
    name: &'static str,
    (top, energy, at): (ReducedTop, f64, Start),
    periods: f64,
) -> kit::Result<Motion> {
    let exact = HeavyTop::from_energy(top, energy, at, 0.0, 0.0)?;
    let body = RigidBody::new(PrincipalMoments::symmetric(1.0, top.a())?);
    let scene = Scene::new(body).with(GravityAtLever::new(top.c(), 1.0)?);
    let start = exact.state(0.0);
    let end = periods * exact.nutation_period();
    let angles = Angles::new(top, &exact, body);
    let sampled = exact.clone();
    let state = move |t: f64| exact.try_state(t);
    let problem =
        Problem::new(scene, start, end, state(end)?).in_closed_form(move |t| sampled.attitude(t));
    let continued = move |from: &State, t: f64| {
        // The notes' numbers of this state, and its own unit of time.
        let EulerAngles { phi, theta, zeta } = from.attitude.euler_angles();
        let rates = EulerAngles { phi, theta, zeta }.rates(body.angular_velocity(from))?;
        let axial = scene.value(Invariant::AxialMomentum, from);
        let vertical = scene.value(Invariant::MomentumZ, from);
        let unit = top.a().sqrt() / axial;
        let own = ReducedTop::new(top.a(), vertical / axial, top.c() * (unit * unit))?;
        let motion = HeavyTop::from_angles(own, theta, rates.theta * unit, phi, zeta)?;
        Ok(motion.attitude((end - t) / unit))
    };
    Ok(Motion {
        key,
        name,
        end,
        periods,
        problem: Box::new(problem),
        state: Box::new(state),
        continued: Box::new(continued),
        angles: Some(angles),
        exact: true,
        nodes: 96,
    })
}

impl Motion {
    /// A motion without a closed form, by what carries it between two times.
    pub fn stepped<E: Effect + Clone + Send + Sync + 'static>(
        (key, name): (&'static str, &'static str),
        problem: Problem<E>,
        periods: f64,
        carried: impl Fn(&State, f64, f64) -> Result<State> + Clone + Send + Sync + 'static,
    ) -> Self {
        let (start, end) = (problem.start, problem.end);
        let onward = carried.clone();
        Self {
            key,
            name,
            end,
            periods,
            problem: Box::new(problem),
            state: Box::new(move |t| carried(&start, 0.0, t)),
            continued: Box::new(move |state, t| Ok(onward(state, t, end)?.attitude)),
            angles: None,
            exact: false,
            nodes: 12,
        }
    }

    /// The attitude at the end in closed form, set up anew; `None` if it is stepped.
    pub fn in_closed_form(&self) -> Option<Result<Attitude>> {
        self.exact
            .then(|| (self.continued)(&(self.state)(0.0)?, 0.0))
    }

    /// By how much a disturbance of the state at time `t`, of relative size `size`, is
    /// magnified until the end: the sum over six directions, three in L and three in
    /// the attitude.
    pub fn condition(&self, t: f64, size: f64) -> kit::Result<f64> {
        let state = (self.state)(t)?;
        let length = state.angular_momentum.norm();
        let unit = |i: usize, by: f64| {
            SpaceVector::from_array(core::array::from_fn(|j| if i == j { by } else { 0.0 }))
        };
        let mut sum = 0.0;
        for i in 0..3 {
            let pushed = |by: f64| -> Result<Attitude> {
                let momentum = state.angular_momentum + unit(i, by * length);
                (self.continued)(&State::new(state.attitude, momentum)?, t)
            };
            let turned = |by: f64| -> Result<Attitude> {
                let turn = Attitude::from_rotation_vector(unit(i, by))?;
                let state = State::new(turn * state.attitude, state.angular_momentum)?;
                (self.continued)(&state, t)
            };
            // Two-sided: the second order drops out.
            sum += pushed(size)?.angle_to(&pushed(-size)?) / (2.0 * size);
            sum += turned(size)?.angle_to(&turned(-size)?) / (2.0 * size);
        }
        Ok(sum)
    }

    /// The largest condition from a point of the path, the start included: what
    /// round-off on the way is magnified by. And the time of that point.
    pub fn path_condition(&self, size: f64) -> kit::Result<(f64, f64)> {
        let mut largest = (0.0, self.condition(0.0, size)?);
        for k in 1..self.nodes {
            let t = self.end * f64::from(k) / f64::from(self.nodes);
            let condition = self.condition(t, size)?;
            if condition > largest.1 {
                largest = (t, condition);
            }
        }
        Ok(largest)
    }
}
