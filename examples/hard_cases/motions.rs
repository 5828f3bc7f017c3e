//! A motion as a case: its truth, its condition, and every method in every representation.

use super::*;
use models::truth::Truth;

/// A representation: an attitude written as numbers, and read back.
pub type Form = fn(Attitude) -> Solved<Attitude>;
pub const QUATERNION: Form = |a| Attitude::from_quaternion(a.quaternion());
pub const MATRIX: Form = |a| Attitude::from_matrix(a.matrix());
/// All of them, and their names.
pub const FORMS: [Form; 5] = [
    QUATERNION,
    MATRIX,
    |a| Attitude::from_euler(a.euler_angles()),
    |a| Attitude::from_yaw_pitch_roll(a.yaw_pitch_roll()),
    |a| Attitude::from_rotation_vector(a.rotation_vector()),
];
#[rustfmt::skip]
pub const NAMES: [&str; 5] = ["quaternion", "matrix", "Euler angles", "yaw, pitch, roll", "rotation vector"];

/// The attitude with these Euler angles (rad).
pub fn turned(phi: f64, theta: f64, zeta: f64) -> Solved<Attitude> {
    Attitude::from_euler(EulerAngles { phi, theta, zeta })
}

/// The cells of a method whose start is given and whose end is delivered in each form: how far the
/// end is off the truth. Forms that give one start share a run.
pub fn in_each_form(
    (by, condition): (By, f64),
    [from, truth]: [Attitude; 2],
    mut carried: impl FnMut(Attitude) -> Solved<Attitude>,
) -> [Cell; 5] {
    let mut runs: Vec<(Attitude, Solved<Attitude>)> = Vec::new();
    let mut off = |form: Form| {
        let start = form(from)?;
        let known = runs.iter().find(|(from, _)| *from == start);
        let end = known.map_or_else(|| carried(start), |(_, end)| end.clone());
        runs.push((start, end.clone()));
        Ok(truth.angle_to(&form(end?)?))
    };
    FORMS.map(|form| by.cell(condition, off(form)))
}

/// The way from the start to the end.
#[derive(Clone, Copy, PartialEq)]
pub enum How {
    ClosedForm,
    /// An error is asked for; the scene has a closed form, which answers.
    Request,
    /// The same, answered by stepping all the same.
    Solve,
    /// Steps in which the fastest rotation turns by this angle (rad).
    Steps(Method, f64),
    Dop853,
    /// The family has its own.
    Own,
}

/// A method: its name; its K, one for all cases; and the way.
#[derive(Clone, Copy)]
pub struct By(pub &'static str, pub f64, pub How);

const CLOSED_FORM: By = By("closed form", 2.0, How::ClosedForm);
// A request must be proved.
pub const SOLVE: By = By("solve", 4096.0, How::Request);
const STEPPING: By = By("solve, stepping", 4096.0, How::Solve);
const GAUSS: By = By("Gauss-Legendre 16", 8.0, How::Steps(Method::GaussLegendre16, 1.0));
const SPLIT: By = By("SRKN 14a", 8.0, How::Steps(Method::Srkn14, 0.08));
const DOP853: By = By("DOP853", 32.0, How::Dop853);
const RK4: By = By("RK4", 64.0, How::Steps(Method::Rk4, 0.001));

/// For a body on which nothing acts; for a symmetric top, with a splitting; and without steps.
pub const FREE: [By; 5] = [CLOSED_FORM, STEPPING, GAUSS, DOP853, RK4];
pub const TOP: [By; 6] = [CLOSED_FORM, STEPPING, SPLIT, GAUSS, DOP853, RK4];
pub const CLOSED: [By; 2] = [CLOSED_FORM, SOLVE];

impl By {
    /// K eps times the condition.
    pub fn bound(self, condition: f64) -> f64 {
        self.1 * EPS * condition
    }

    /// The cell of an answer.
    pub fn cell(self, condition: f64, answer: Solved<f64>) -> Cell {
        Cell { method: self.0, answer, bound: self.bound(condition) }
    }
}

/// A start and an end.
#[derive(Clone, Copy)]
pub struct Motion {
    pub moments: [f64; 3],
    /// Weight (N) and lever (m) of a top; 0 of a free body.
    pub gravity: [f64; 2],
    pub attitude: Attitude,
    pub rates: [f64; 3],
    pub end: f64,
}

/// Its closed form.
trait Closed: Exact<State = State> {
    fn at(&self, t: f64) -> Kinematics;
}

macro_rules! closed {
    ($($form:ty),+) => {
        $( impl Closed for $form { fn at(&self, t: f64) -> Kinematics { self.kinematics(t) } } )+
    };
}
closed!(FreeBody, HeavyTop);

/// The points of a path at which a disturbance is followed to the end, and at which its fastest
/// rate is looked for.
const PLACES: u32 = 8;
const SEEN: u32 = 64;
/// Steps that DOP853 is allowed: those that reach the end take at most a tenth of it.
const STEPS_ALLOWED: u64 = 20_000;
/// After so many periods the truth takes the rotation of one to a power.
const MANY: f64 = 50.0;

impl Motion {
    pub const fn free(moments: [f64; 3], attitude: Attitude, rates: [f64; 3], end: f64) -> Self {
        Self { moments, gravity: [0.0; 2], attitude, rates, end }
    }

    /// Of moments across and along, with this torque of gravity on its lying axis (N m).
    pub fn top([i1, i3]: [f64; 2], pull: f64, from: Attitude, rates: [f64; 3], end: f64) -> Self {
        let gravity = [pull.abs(), 1_f64.copysign(pull)];
        Self { gravity, ..Self::free([i1, i1, i3], from, rates, end) }
    }

    /// The same to another end.
    pub fn until(&self, end: f64) -> Self {
        Self { end, ..*self }
    }

    /// As a case, beside a plain method.
    pub fn against(&self, methods: &[By], plain: Plain) -> Result<Answered> {
        let truth = self.truth()?;
        self.answered(methods, (plain.0, plain.1(self, truth)?), self.conditions()?, truth)
    }

    /// The same with a condition that is known.
    pub fn of_condition(&self, methods: &[By], known: f64, plain: Plain) -> Result<Answered> {
        let truth = self.truth()?;
        self.answered(methods, (plain.0, plain.1(self, truth)?), [known; 2], truth)
    }

    /// Each method in each representation, by the conditions from the start and along the path.
    pub fn answered(
        &self,
        methods: &[By],
        naive: Naive,
        [condition, path]: [f64; 2],
        truth: Attitude,
    ) -> Result<Answered> {
        let cells = methods.iter().flat_map(|&by| {
            // Where no step is made only the start's own rounding is felt.
            let closed = matches!(by.2, How::ClosedForm | How::Request);
            let felt = if closed { condition } else { path };
            let carried = |from| self.carried(by.2, from, by.bound(felt));
            in_each_form((by, felt), [self.attitude, truth], carried)
        });
        Ok(Answered { condition, naive, cells: cells.collect() })
    }

    /// As a case of which this error is asked, in each form; the truth is of the motion that is
    /// really given.
    pub fn promised(&self, how: How, bound: f64, plain: Plain) -> Result<Answered> {
        let cells = FORMS.map(|form| {
            // A refusal needs no truth.
            let off = |end| Ok(self.truth_as_given(form)?.angle_to(&end));
            Cell { method: SOLVE.0, answer: self.reached(how, form, bound).and_then(off), bound }
        });
        let (condition, truth) = (self.conditions()?[1], self.truth_as_given(QUATERNION)?);
        Ok(Answered { condition, naive: (plain.0, plain.1(self, truth)?), cells: cells.into() })
    }

    pub fn body(&self) -> Solved<PrincipalMoments> {
        let [i1, i2, i3] = self.moments;
        PrincipalMoments::new(i1, i2, i3)
    }

    fn omega(&self) -> BodyVector {
        BodyVector::from_array(self.rates)
    }

    /// The angular momentum on the body's axes with these rates.
    pub fn momentum(&self, rates: [f64; 3]) -> BodyVector {
        BodyVector::from_array([0, 1, 2].map(|i| self.moments[i] * rates[i]))
    }

    /// The closed form of a body on which nothing acts.
    pub fn free_body(&self) -> Solved<FreeBody> {
        FreeBody::new(self.body()?, self.attitude, self.omega())
    }

    fn closed(&self, attitude: Attitude, omega: BodyVector) -> Solved<Box<dyn Closed>> {
        let [weight, lever] = self.gravity;
        if weight == 0.0 {
            return Ok(Box::new(FreeBody::new(self.body()?, attitude, omega)?));
        }
        let top = SymmetricTop::new(self.moments[0], self.moments[2], weight, lever)?;
        Ok(Box::new(HeavyTop::new(top, attitude, omega)?))
    }

    fn series(&self, from: Attitude) -> Truth {
        Truth::new(self.moments, self.gravity, from, self.rates)
    }

    /// The attitude at the end, by series.
    pub fn truth(&self) -> Solved<Attitude> {
        let (truth, end) = (self.series(self.attitude), self.end);
        match self.free_body().map(|body| body.rate_period()) {
            Ok(period) if self.gravity == [0.0; 2] && end.abs() > MANY * period => {
                truth.late(period, end.into())
            }
            _ => truth.after(end.into()).attitude(),
        }
    }

    /// The attitude at the end of the motion that really begins when this one is given in a
    /// representation and as an angular momentum in space: both are rounded, and where the
    /// condition is large the rounded start is another motion.
    pub fn truth_as_given(&self, form: Form) -> Solved<Attitude> {
        let start = RigidBody::new(self.body()?).state(form(self.attitude)?, self.omega())?;
        let truth = self.series(start.attitude).with_momentum(start.angular_momentum);
        truth.after(self.end.into()).attitude()
    }

    /// The rates at the end, in a unit of their own.
    pub fn true_rates(&self) -> [f64; 3] {
        self.series(self.attitude).after(self.end.into()).rates()
    }

    /// The change of the end per relative change of the inputs, and the largest per relative
    /// change at some point of the path, which is how a method in steps is disturbed.
    pub fn conditions(&self) -> Solved<[f64; 2]> {
        let closed = self.closed(self.attitude, self.omega())?;
        let at_start = closed.condition(self.end)?;
        let mut largest = at_start;
        for k in 1..PLACES {
            let t = self.end * f64::from(k) / f64::from(PLACES);
            let there = closed.at(t);
            let from_there = self.closed(there.attitude, there.angular_velocity)?;
            largest = largest.max(from_there.condition(self.end - t)?);
        }
        Ok([at_start, largest])
    }

    /// The attitude at the end, started and delivered in this representation.
    pub fn reached(&self, how: How, form: Form, asked: f64) -> Solved<Attitude> {
        form(self.carried(how, form(self.attitude)?, asked)?)
    }

    /// The closed form at the end, given and delivered as a quaternion.
    pub fn in_closed_form(&self) -> Solved<Attitude> {
        self.reached(How::ClosedForm, QUATERNION, 0.0)
    }

    fn carried(&self, how: How, from: Attitude, asked: f64) -> Solved<Attitude> {
        let body = RigidBody::new(self.body()?);
        let mut effects: Vec<BoxedEffect> = Vec::new();
        let [weight, lever] = self.gravity;
        if weight > 0.0 {
            effects.push(Box::new(GravityAtLever::new(weight, lever)?));
        }
        let scene = Scene::new(body).with_list(EffectList::new(effects)?);
        let (start, end) = (|| body.state(from, self.omega()), self.end);
        let stepper = match how {
            How::Request => return Ok(scene.solve(&start()?, end, asked)?.state.attitude),
            How::Solve => {
                return Ok(scene.solve_by_stepping(&start()?, end, asked)?.state.attitude);
            }
            How::Steps(method, angle) => {
                Stepper::new(method, Resolution::Steps(self.steps(angle)))?
            }
            How::Dop853 => Stepper::Dop853(Dop853::new(1e-15)?.with_step_limit(STEPS_ALLOWED)?),
            _ => return Ok(self.closed(from, self.omega())?.at(end).attitude),
        };
        Ok(stepper.advance_as_usual(&scene, [0.0, end], &start()?)?.0.attitude)
    }

    /// Steps in which the fastest rotation turns by an angle.
    fn steps(&self, angle: f64) -> u64 {
        let [weight, lever] = self.gravity;
        let mut fastest = 2.0 * (weight * lever.abs() / self.moments[0]).sqrt();
        let mut seen = vec![self.rates];
        if let Ok(exact) = self.closed(self.attitude, self.omega()) {
            let at = |k: u32| exact.at(self.end * f64::from(k) / f64::from(SEEN));
            seen.extend((1..=SEEN).map(|k| at(k).angular_velocity.to_array()));
        }
        for rate in seen.into_iter().flatten() {
            fastest = rate.abs().max(fastest);
        }
        let turned = 3_f64.sqrt() * fastest * self.end.abs();
        (turned / angle).ceil().max(1.0) as u64
    }
}
