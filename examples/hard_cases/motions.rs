//! A motion as a case: its truth, its condition, and every method in every representation.

use super::forms::Form;
use super::table::{Cell, Naive, Row, bound};
use super::truth::{Place, Truth};
use kit::Prepared;
use rotation_dynamics::Result;
use rotation_dynamics::accuracy::{Resolution, Stepper};
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::{Kinematics, RigidBody, State};
use rotation_dynamics::effects::{Effect, GravityAtLever};
use rotation_dynamics::exact::free_body::FreeBody;
use rotation_dynamics::exact::heavy_top::{HeavyTop, SymmetricTop};
use rotation_dynamics::frame::BodyVector;
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::{Dop853, Method};
use rotation_dynamics::math::DoubleDouble;
use rotation_dynamics::motion::Motion as _;
use rotation_dynamics::scene::Scene;

/// How a motion is carried to its end.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum By {
    ClosedForm,
    /// An error is asked for; the scene has a closed form, and that answers.
    Request,
    /// The same, answered by stepping all the same.
    Solve,
    Steps(Method),
}

impl By {
    /// For a body on which nothing acts.
    pub const FREE: [Self; 5] = [
        Self::ClosedForm,
        Self::Solve,
        Self::Steps(Method::GaussLegendre16),
        Self::Steps(Method::Dop853),
        Self::Steps(Method::Rk4),
    ];
    /// For a symmetric top: a splitting too.
    pub const TOP: [Self; 6] = [
        Self::ClosedForm,
        Self::Solve,
        Self::Steps(Method::Srkn14),
        Self::Steps(Method::GaussLegendre16),
        Self::Steps(Method::Dop853),
        Self::Steps(Method::Rk4),
    ];

    /// Without steps: what a request to `solve` is answered with too.
    pub const CLOSED: [Self; 2] = [Self::ClosedForm, Self::Request];

    /// Whether no step is made, so that only the start's own rounding is felt.
    const fn is_closed(self) -> bool {
        matches!(self, Self::ClosedForm | Self::Request)
    }

    pub const fn name(self) -> &'static str {
        match self {
            Self::ClosedForm => "closed form",
            Self::Request => "solve",
            Self::Solve => "solve, stepping",
            Self::Steps(method) => method.name(),
        }
    }

    /// The names of some.
    pub const fn names<const N: usize>(all: [Self; N]) -> [&'static str; N] {
        let mut names = [""; N];
        let mut i = 0;
        while i < N {
            names[i] = all[i].name();
            i += 1;
        }
        names
    }

    /// The K of its bound, K eps times the condition: one for all cases.
    pub const fn k(self) -> f64 {
        match self {
            Self::ClosedForm => 2.0,
            // What is asked for, and must be proved.
            Self::Request | Self::Solve => 4096.0,
            Self::Steps(Method::GaussLegendre16 | Method::Srkn14) => 8.0,
            Self::Steps(Method::Dop853) => 32.0,
            Self::Steps(_) => 64.0,
        }
    }

    /// The angle (rad) that the fastest rotation makes in a step.
    const fn angle(self) -> f64 {
        match self {
            Self::Steps(Method::GaussLegendre16) => 1.0,
            Self::Steps(Method::Srkn14) => 0.08,
            _ => 0.001,
        }
    }
}

/// A start and an end.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Motion {
    pub moments: [f64; 3],
    /// Weight (N) and lever (m) of a top; none of a free body.
    pub gravity: Option<[f64; 2]>,
    pub attitude: Attitude,
    pub rates: [f64; 3],
    pub end: f64,
}

/// Its closed form.
enum Closed {
    Free(Box<FreeBody>),
    Top(Box<HeavyTop>),
}

impl Closed {
    fn kinematics(&self, t: f64) -> Kinematics {
        match self {
            Self::Free(motion) => motion.kinematics(t),
            Self::Top(motion) => motion.kinematics(t),
        }
    }
    fn condition(&self, t: f64) -> Result<f64> {
        match self {
            Self::Free(motion) => motion.condition(t),
            Self::Top(motion) => motion.condition(t),
        }
    }
}

/// The points of a path at which a disturbance is followed to the end.
const PLACES: u32 = 8;

/// The times at which a path is looked at for its fastest rate.
const SEEN: u32 = 64;

/// Steps that DOP853 is allowed: those that reach the end take at most a tenth of it.
const STEPS_ALLOWED: u64 = 20_000;

/// After so many periods the truth takes the rotation of one to a power.
const MANY: f64 = 50.0;

impl Motion {
    pub fn free(moments: [f64; 3], attitude: Attitude, rates: [f64; 3], end: f64) -> Self {
        Self {
            moments,
            gravity: None,
            attitude,
            rates,
            end,
        }
    }

    pub fn top(
        [i1, i3]: [f64; 2],
        moment: f64,
        attitude: Attitude,
        rates: [f64; 3],
        end: f64,
    ) -> Self {
        Self {
            moments: [i1, i1, i3],
            gravity: Some([moment.abs(), 1_f64.copysign(moment)]),
            attitude,
            rates,
            end,
        }
    }

    pub fn body(&self) -> Result<PrincipalMoments> {
        let [i1, i2, i3] = self.moments;
        PrincipalMoments::new(i1, i2, i3)
    }

    fn closed(&self, from: Kinematics) -> Result<Closed> {
        let Kinematics {
            attitude,
            angular_velocity: rates,
        } = from;
        Ok(match self.gravity {
            None => Closed::Free(Box::new(FreeBody::new(self.body()?, attitude, rates)?)),
            Some([weight, lever]) => {
                let [i1, _, i3] = self.moments;
                let top = SymmetricTop::new(i1, i3, weight, lever)?;
                Closed::Top(Box::new(HeavyTop::new(top, attitude, rates)?))
            }
        })
    }

    fn start(&self, attitude: Attitude) -> Kinematics {
        Kinematics::new(attitude, BodyVector::from_array(self.rates))
    }

    /// The attitude at the end, by series; kept until another motion's is asked for.
    pub fn truth(&self) -> Result<Attitude> {
        static KEPT: Prepared<Motion, Attitude> = Prepared::new();
        KEPT.get(self, Self::by_series).map(|truth| *truth)
    }

    fn by_series(&self) -> Result<Attitude> {
        let (truth, start) = self.series()?;
        if let Ok(Closed::Free(motion)) = self.closed(self.start(self.attitude)) {
            let period = motion.rate_period();
            if self.end.abs() > MANY * period {
                return truth.late(&start, period, self.end);
            }
        }
        truth.after(&start, DoubleDouble::from(self.end)).attitude()
    }

    /// The attitude at the end of the motion that really begins when this one is given in a
    /// representation and as an angular momentum in space: both are rounded, and where the
    /// condition is large that is another motion.
    pub fn truth_as_given(&self, form: Form) -> Result<Attitude> {
        let body = RigidBody::new(self.body()?);
        let rates = BodyVector::from_array(self.rates);
        let start = body.state(form.through(self.attitude)?, rates)?;
        let (truth, _) = self.series()?;
        let end = DoubleDouble::from(self.end);
        truth.after(&truth.place_of(&start), end).attitude()
    }

    /// The rates at the end, in a unit of their own.
    pub fn true_rates(&self) -> Result<[f64; 3]> {
        let (truth, start) = self.series()?;
        Ok(truth.after(&start, DoubleDouble::from(self.end)).rates())
    }

    fn series(&self) -> Result<(Truth, Place)> {
        let [weight, lever] = self.gravity.unwrap_or([0.0, 0.0]);
        let rates = BodyVector::from_array(self.rates);
        let truth = Truth::new(self.body()?, weight, lever, rates);
        let start = truth.place(self.attitude, rates);
        Ok((truth, start))
    }

    /// The change of the end per relative change of the inputs, and the largest per relative
    /// change at some point of the path: what a method in steps is disturbed by.
    pub fn conditions(&self) -> Result<[f64; 2]> {
        let closed = self.closed(self.start(self.attitude))?;
        let at_start = closed.condition(self.end)?;
        let mut largest = at_start;
        for k in 1..PLACES {
            let t = self.end * f64::from(k) / f64::from(PLACES);
            let there = self.closed(closed.kinematics(t))?;
            largest = largest.max(there.condition(self.end - t)?);
        }
        Ok([at_start, largest])
    }

    /// The attitude at the end, started and delivered in this representation.
    pub fn reached(&self, by: By, form: Form, asked: f64) -> Result<Attitude> {
        let start = form.through(self.attitude)?;
        form.through(self.carried(by, start, asked)?)
    }

    /// The same in each representation; those that give one start share a run.
    fn reached_in_each(&self, by: By, asked: f64) -> Vec<Result<Attitude>> {
        let mut runs: Vec<(Attitude, Result<Attitude>)> = Vec::new();
        let mut reached = |form: Form| {
            let start = form.through(self.attitude)?;
            let known = runs.iter().find(|(from, _)| *from == start);
            let end = match known {
                Some((_, end)) => end.clone(),
                None => self.carried(by, start, asked),
            };
            runs.push((start, end.clone()));
            form.through(end?)
        };
        Form::ALL.map(&mut reached).into()
    }

    fn carried(&self, by: By, attitude: Attitude, asked: f64) -> Result<Attitude> {
        if by == By::ClosedForm {
            let closed = self.closed(self.start(attitude))?;
            return Ok(closed.kinematics(self.end).attitude);
        }
        let scene = Scene::new(RigidBody::new(self.body()?));
        let end = match self.gravity {
            None => self.stepped(&scene, attitude, by, asked)?,
            Some([weight, lever]) => {
                let gravity = GravityAtLever::new(weight, lever)?;
                self.stepped(&scene.with(gravity), attitude, by, asked)?
            }
        };
        Ok(end.attitude)
    }

    fn stepped<E: Effect>(
        &self,
        scene: &Scene<E>,
        attitude: Attitude,
        by: By,
        asked: f64,
    ) -> Result<State> {
        let start = scene
            .body()
            .state(attitude, BodyVector::from_array(self.rates))?;
        match by {
            By::Steps(method) => {
                let stepper = match method {
                    Method::Dop853 => {
                        Stepper::Dop853(Dop853::new(1e-15)?.with_step_limit(STEPS_ALLOWED)?)
                    }
                    _ => Stepper::new(method, Resolution::Steps(self.steps(by)))?,
                };
                Ok(stepper.advance_as_usual(scene, [0.0, self.end], &start)?.0)
            }
            By::Request => Ok(scene.solve(&start, self.end, asked)?.state),
            _ => Ok(scene.solve_by_stepping(&start, self.end, asked)?.state),
        }
    }

    /// Steps in which the fastest rotation turns by the method's angle.
    fn steps(&self, by: By) -> u64 {
        let largest = |most: f64, rates: [f64; 3]| rates.iter().fold(most, |m, w| m.max(w.abs()));
        let pulled = self.gravity.map_or(0.0, |[weight, lever]| {
            2.0 * (weight * lever.abs() / self.moments[0]).sqrt()
        });
        let mut fastest = largest(pulled, self.rates);
        if let Ok(exact) = self.closed(self.start(self.attitude)) {
            for k in 1..=SEEN {
                let t = self.end * f64::from(k) / f64::from(SEEN);
                fastest = largest(fastest, exact.kinematics(t).angular_velocity.to_array());
            }
        }
        let angle = 3_f64.sqrt() * fastest * self.end.abs();
        (angle / by.angle()).ceil().max(1.0) as u64
    }

    /// How far from the truth this attitude is (rad); NaN for none.
    pub fn off(&self, reached: Option<Attitude>) -> f64 {
        match (self.truth(), reached) {
            (Ok(truth), Some(reached)) => truth.angle_to(&reached),
            _ => f64::NAN,
        }
    }

    /// The row of this case: all cells, and the naive method with its error.
    pub fn row(
        &self,
        [case, wrong]: [&'static str; 2],
        methods: &[By],
        naive: Naive,
    ) -> kit::Result<Row> {
        self.row_of_condition([case, wrong], methods, naive, self.conditions()?)
    }

    /// The same with conditions that are known otherwise.
    pub fn row_of_condition(
        &self,
        words: [&'static str; 2],
        methods: &[By],
        naive: Naive,
        conditions: [f64; 2],
    ) -> kit::Result<Row> {
        self.row_of_truth(words, methods, naive, conditions, self.truth()?)
    }

    /// The same with an end that is known otherwise.
    pub fn row_of_truth(
        &self,
        [case, wrong]: [&'static str; 2],
        methods: &[By],
        naive: Naive,
        [condition, path]: [f64; 2],
        truth: Attitude,
    ) -> kit::Result<Row> {
        let mut cells = Vec::new();
        for by in methods {
            let of = if by.is_closed() { condition } else { path };
            let held = bound(by.k(), of);
            for (form, end) in Form::ALL.iter().zip(self.reached_in_each(*by, held)) {
                let answer = end.map(|end| truth.angle_to(&end));
                cells.push(Cell::of((case, by.name(), form.name()), answer, held)?);
            }
        }
        Ok(Row {
            case,
            wrong,
            condition,
            naive,
            cells,
        })
    }
}
