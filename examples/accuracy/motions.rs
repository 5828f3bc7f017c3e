//! The motions: five with closed forms, from easy to hard, a heavy body with three
//! different moments, and a body pushed for a while.

use super::*;
use block::{coasting, generic_rates, over, tilted};
use rotation_dynamics::accuracy::{Errors, Resolution, applies};
use rotation_dynamics::exact::heavy_top::{HeavyTop, ReducedTop, Start};
use rotation_dynamics::integrators::{ode, size_or};
use rotation_dynamics::scene::Invariant;

/// What is asked of a problem, whatever acts in it.
pub trait Raced: Send + Sync {
    fn applies(&self, method: Method) -> bool;
    /// A method in the variables that suit it best.
    fn run(&self, method: Method, setting: f64) -> Result<(State, Work)>;
    fn errors(&self, reached: &State) -> Errors;
    fn solved(&self, tolerance: f64) -> Result<Solved>;
    fn add_strip(&self, report: &mut Report, tolerance: f64) -> kit::Result<()>;
}

impl<E: Effect + Clone + Send + Sync + 'static> Raced for Problem<E> {
    fn applies(&self, method: Method) -> bool {
        applies::<E>(method)
    }

    fn run(&self, method: Method, setting: f64) -> Result<(State, Work)> {
        let variables = Variables::best(method, &self.scene);
        Problem::run(self, method, variables, Resolution::of(method, setting))
    }

    fn errors(&self, reached: &State) -> Errors {
        Problem::errors(self, reached)
    }

    fn solved(&self, tolerance: f64) -> Result<Solved> {
        super::solved(self, tolerance)
    }

    fn add_strip(&self, report: &mut Report, tolerance: f64) -> kit::Result<()> {
        report.strip(self, &[tolerance])
    }
}

/// A key, and a name in tables.
pub type Names = (&'static str, &'static str);
type StateAt = Box<dyn Fn(f64) -> Result<State> + Send + Sync>;
type Continued = Box<dyn Fn(&State, f64) -> Result<Attitude> + Send + Sync>;
type ByTolerance = Box<dyn Fn(f64) -> Result<(State, Work)> + Send + Sync>;

/// A motion, with all that is asked of it.
pub struct Motion {
    pub key: &'static str,
    pub name: &'static str,
    pub end: f64,
    /// The end in periods; in units of four seconds where there is no period.
    pub periods: f64,
    pub problem: Box<dyn Raced>,
    /// The state at a time.
    state: StateAt,
    /// The attitude at the end of a motion that is in a state at a time.
    continued: Continued,
    /// Its end by DOP853 in the angles of the notes, with a tolerance: of a top.
    pub in_angles: Option<ByTolerance>,
    /// Whether there is a closed form.
    exact: bool,
}

/// 1e-4 rad off the axis of the intermediate moment.
const NEAR_MIDDLE: BodyVector = BodyVector::new(0.0, 1.0, 1e-4);

/// What is added to a whole number of periods: at the whole number, where the motion is
/// symmetric in time, a symmetric method's error of the energy vanishes by luck.
pub const THIRD: f64 = 1.0 / 3.0;

/// All of them, over so many periods (of the rates, or of the nods).
pub fn all(p: &Parameters) -> Result<Vec<Motion>> {
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
    // From 1e-4 off the intermediate axis: two flips a period. It ends in the middle of a
    // flip, where the attitude is most sensitive.
    let half = 0.5 * p.periods - 0.25;
    let flips = free_problem(p, NEAR_MIDDLE, half)?;
    let longer = p.periods + THIRD;
    Ok(vec![
        free(("free", "free body"), tumbling(p)?, longer),
        top(("top", "heavy top"), notes, longer)?,
        top(("fast", "fast top"), cusps, 10.0 * p.periods + THIRD)?,
        free(("flips", "flips"), flips, half),
        top(("pole", "past the pole"), passing, longer)?,
        rough::lopsided(p.periods)?,
        rough::pushed(p)?,
    ])
}

/// The free body of the page.
pub fn tumbling(p: &Parameters) -> Result<Problem<()>> {
    free_problem(p, generic_rates(p.moments()?), p.periods + THIRD)
}

/// The free body with these rates for so many of their periods, or why it has none.
fn free_problem(p: &Parameters, rates: BodyVector, periods: f64) -> Result<Problem<()>> {
    let (body, start) = tilted(p.moments()?, rates)?;
    let exact = Scene::new(body).exact(&start)?;
    if !exact.rate_period().is_finite() {
        let allowed = "between I1 and I3, and equal to neither: the body must tumble";
        return Err(Error::out_of_range("I2", p.i2, allowed));
    }
    over(periods, body, start, exact)
}

fn free(names: Names, problem: Problem<()>, periods: f64) -> Motion {
    let body = *problem.scene.body();
    let carry = move |state: &State, [from, to]: [f64; 2]| coasting(&body, state, to - from);
    Motion::carried(names, problem, periods, carry)
}

/// In units of t': I1 = 1, I3 = a, m g l = c, L_z = sqrt(a).
fn top(names: Names, (top, energy, at): (ReducedTop, f64, Start), periods: f64) -> Result<Motion> {
    let exact = HeavyTop::from_energy(top, energy, at, 0.0, 0.0)?;
    let body = RigidBody::new(PrincipalMoments::symmetric(1.0, top.a())?);
    let scene = Scene::new(body).with(GravityAtLever::new(top.c(), 1.0)?);
    let end = periods * exact.nutation_period();
    let in_angles = Some(in_angles(top, &exact, body, end));
    let problem = Problem::new(scene, exact.state(0.0), end, exact.try_state(end)?);
    let sampled = exact.clone();
    let problem = problem.in_closed_form(move |t| sampled.attitude(t));
    let continued = move |from: &State, t: f64| {
        // The notes' numbers of this state, and its own unit of time.
        let angles = from.attitude.euler_angles();
        let rates = angles.rates(body.angular_velocity(from))?;
        let axial = scene.value(Invariant::AxialMomentum, from);
        let vertical = scene.value(Invariant::MomentumZ, from);
        let unit = top.a().sqrt() / axial;
        let own = ReducedTop::new(top.a(), vertical / axial, top.c() * (unit * unit))?;
        let EulerAngles { phi, theta, zeta } = angles;
        let motion = HeavyTop::from_angles(own, theta, rates.theta * unit, phi, zeta)?;
        Ok(motion.attitude((end - t) / unit))
    };
    let state = move |t| exact.try_state(t);
    let motion = Motion::new(names, problem, periods, state, continued);
    Ok(Motion { in_angles, ..motion })
}

/// Equations (4) to (6) of the notes, 16.2, for theta, its rate, phi and zeta. The state has no
/// pole, the angles do.
fn in_angles(top: ReducedTop, exact: &HeavyTop, body: RigidBody, end: f64) -> ByTolerance {
    let (a, b, c) = (top.a(), top.b(), top.c());
    let EulerAngles { phi, theta, zeta } = exact.angles(0.0);
    let start = [theta, exact.theta_rate(0.0), phi, zeta];
    let motion = ode(move |_, &[theta, rate, _, _]: &[f64; 4]| {
        let (s, u) = sincos(theta);
        let precession = a.sqrt() * (b - u) / (s * s);
        let torque = c * s - a * (b - u) * (1.0 - b * u) / (s * s * s);
        [rate, torque, precession, 1.0 / a.sqrt() - precession * u]
    });
    let motion = motion.scaled(size_or([1.0; 4]));
    Box::new(move |tolerance| {
        let (end, work) = Dop853::new(tolerance)?.advance(&motion, 0.0, &start, end)?;
        let [theta, rate, phi, zeta] = end;
        let ((s, u), (sin, cos)) = (sincos(theta), sincos(zeta));
        let across = a.sqrt() * (b - u) / s;
        let rates = [rate * cos + across * sin, across * cos - rate * sin, 1.0 / a.sqrt()];
        let attitude = Attitude::from_euler(EulerAngles { phi, theta, zeta })?;
        Ok((body.state(attitude, BodyVector::from_array(rates))?, work))
    })
}

impl Motion {
    /// The motion of a problem, by its state at a time, and by what becomes until the end of a
    /// state at a time.
    fn new<E: Effect + Clone + Send + Sync + 'static>(
        (key, name): Names,
        problem: Problem<E>,
        periods: f64,
        state: impl Fn(f64) -> Result<State> + Send + Sync + 'static,
        continued: impl Fn(&State, f64) -> Result<Attitude> + Send + Sync + 'static,
    ) -> Self {
        Self {
            key,
            name,
            end: problem.end,
            periods,
            exact: problem.closed_form().is_some(),
            problem: Box::new(problem),
            state: Box::new(state),
            continued: Box::new(continued),
            in_angles: None,
        }
    }

    /// The same by what carries any state from one time to another.
    pub fn carried<E: Effect + Clone + Send + Sync + 'static>(
        names: Names,
        problem: Problem<E>,
        periods: f64,
        carry: impl Fn(&State, [f64; 2]) -> Result<State> + Clone + Send + Sync + 'static,
    ) -> Self {
        let (start, end, onward) = (problem.start, problem.end, carry.clone());
        let state = move |t| carry(&start, [0.0, t]);
        let continued = move |state: &State, t| Ok(onward(state, [t, end])?.attitude);
        Self::new(names, problem, periods, state, continued)
    }

    /// Runs with these settings, from coarse to fine, each judged by its end.
    pub fn sweep(
        &self,
        settings: impl IntoIterator<Item = f64>,
        run: impl Fn(f64) -> Result<(State, Work)>,
    ) -> Sweep {
        Sweep::over(settings, |setting| {
            let (reached, work) = run(setting)?;
            Ok((self.problem.errors(&reached), work))
        })
    }

    /// The attitude at the end in closed form, set up anew; `None` if it is stepped.
    pub fn in_closed_form(&self) -> Option<Result<Attitude>> {
        self.exact.then(|| (self.continued)(&(self.state)(0.0)?, 0.0))
    }

    /// By how much a disturbance of the state at time `t`, of relative size `size`, is
    /// magnified until the end: the sum over six directions, three in L and three in
    /// the attitude.
    pub fn condition(&self, t: f64, size: f64) -> Result<f64> {
        let state = (self.state)(t)?;
        let (attitude, momentum) = (state.attitude, state.angular_momentum);
        let end = |attitude, momentum| (self.continued)(&State::new(attitude, momentum)?, t);
        let mut sum = 0.0;
        for axis in [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]] {
            let axis = SpaceVector::from_array(axis);
            let pushed = |by: f64| end(attitude, momentum + axis * (by * momentum.norm()));
            let turned = |by: f64| end(attitude.turned_in_space(axis * by)?, momentum);
            // Two-sided: the second order drops out.
            sum += pushed(size)?.angle_to(&pushed(-size)?) / (2.0 * size);
            sum += turned(size)?.angle_to(&turned(-size)?) / (2.0 * size);
        }
        Ok(sum)
    }

    /// The largest condition from a point of the path, the start included: what
    /// round-off on the way is magnified by. And the time of that point.
    pub fn path_condition(&self, size: f64) -> Result<(f64, f64)> {
        // Without a closed form a point costs more than a dozen runs.
        let points: u8 = if self.exact { 96 } else { 12 };
        let mut largest = (0.0, 0.0);
        for t in times(0.0, self.end, points.into()).take(points.into()) {
            let condition = self.condition(t, size)?;
            if condition > largest.1 {
                largest = (t, condition);
            }
        }
        Ok(largest)
    }
}
