//! A motion as a case: its truth, its condition, and every method in every representation.

use super::truth::Truth;
use super::*;

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

/// The end of a start that is given and delivered in each form: how far it is off the truth, and
/// the bound. Forms that give one start share a run.
pub fn in_each_form(
    from: Attitude,
    truth: Attitude,
    bound: f64,
    mut carried: impl FnMut(Attitude) -> Solved<Attitude>,
) -> [(Solved<f64>, f64); 5] {
    let mut runs: Vec<(Attitude, Solved<Attitude>)> = Vec::new();
    let mut off = |form: Form| {
        let start = form(from)?;
        let known = runs.iter().find(|(from, _)| *from == start);
        let end = known.map_or_else(|| carried(start), |(_, end)| end.clone());
        runs.push((start, end.clone()));
        Ok(truth.angle_to(&form(end?)?))
    };
    FORMS.map(|form| (off(form), bound))
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
}

/// A start and an end.
#[derive(Clone, Copy, PartialEq)]
pub struct Motion {
    pub moments: [f64; 3],
    /// Weight (N) and lever (m) of a top; none of a free body.
    pub gravity: Option<[f64; 2]>,
    pub attitude: Attitude,
    pub rates: [f64; 3],
    pub end: f64,
}

/// Its closed form.
trait Closed {
    fn kinematics(&self, t: f64) -> Kinematics;
    fn condition(&self, t: f64) -> Solved<f64>;
}

macro_rules! closed {
    ($($form:ty),+) => { $( impl Closed for $form {
        fn kinematics(&self, t: f64) -> Kinematics { self.kinematics(t) }
        fn condition(&self, t: f64) -> Solved<f64> { rotation_dynamics::motion::Motion::condition(self, t) }
    } )+ };
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
        let gravity = None;
        Self { moments, gravity, attitude, rates, end }
    }

    /// Of moments across and along, with this torque of gravity on its lying axis (N m).
    pub fn top(moments: [f64; 2], pull: f64, from: Attitude, rates: [f64; 3], end: f64) -> Self {
        let mut top = Self::free([moments[0], moments[0], moments[1]], from, rates, end);
        top.gravity = Some([pull.abs(), 1_f64.copysign(pull)]);
        top
    }

    /// The same to another end.
    pub fn until(&self, end: f64) -> Self {
        Self { end, ..*self }
    }

    /// As a case, beside a plain method.
    pub fn against(&self, methods: &[By], plain: Plain) -> Result<Answered> {
        self.beside(methods, (plain.0, plain.1(self)?))
    }

    /// The same beside one whose error is known.
    pub fn beside(&self, methods: &[By], naive: Naive) -> Result<Answered> {
        self.answered(methods, naive, self.conditions()?, self.truth()?)
    }

    /// The same with a condition that is known.
    pub fn of_condition(&self, methods: &[By], known: f64, plain: Plain) -> Result<Answered> {
        let naive = (plain.0, plain.1(self)?);
        self.answered(methods, naive, [known; 2], self.truth()?)
    }

    /// Each method in each representation, by the conditions from the start and along the path.
    pub fn answered(
        &self,
        methods: &[By],
        naive: Naive,
        [condition, path]: [f64; 2],
        truth: Attitude,
    ) -> Result<Answered> {
        let mut answers = Vec::new();
        for by in methods {
            // Where no step is made only the start's own rounding is felt.
            let closed = matches!(by.2, How::ClosedForm | How::Request);
            let bound = by.bound(if closed { condition } else { path });
            let carried = |from| self.carried(by.2, from, bound);
            answers.extend(in_each_form(self.attitude, truth, bound, carried));
        }
        Ok(Answered(condition, naive, answers))
    }

    /// As a case of which this error is asked, in each form; the truth is of the motion that is
    /// really given.
    pub fn promised(&self, how: How, tolerance: f64, plain: Plain) -> Result<Answered> {
        let answers = FORMS.map(|form| {
            // A refusal needs no truth.
            let off = |end| Ok(self.truth_as_given(form)?.angle_to(&end));
            (self.reached(how, form, tolerance).and_then(off), tolerance)
        });
        let (condition, naive) = (self.conditions()?[1], (plain.0, plain.1(self)?));
        Ok(Answered(condition, naive, answers.into()))
    }

    pub fn body(&self) -> Solved<PrincipalMoments> {
        let [i1, i2, i3] = self.moments;
        PrincipalMoments::new(i1, i2, i3)
    }

    pub fn omega(&self) -> BodyVector {
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
        let Some([weight, lever]) = self.gravity else {
            return Ok(Box::new(FreeBody::new(self.body()?, attitude, omega)?));
        };
        let top = SymmetricTop::new(self.moments[0], self.moments[2], weight, lever)?;
        Ok(Box::new(HeavyTop::new(top, attitude, omega)?))
    }

    /// The attitude at the end, by series; kept until another motion's is asked for.
    pub fn truth(&self) -> Solved<Attitude> {
        static KEPT: Prepared<Motion, Attitude> = Prepared::new();
        let by_series = |motion: &Self| {
            let truth = Truth::new(motion, motion.attitude, None);
            let period = motion.free_body().map(|body| body.rate_period());
            match (motion.gravity, period) {
                (None, Ok(period)) if motion.end.abs() > MANY * period => {
                    truth.late(period, motion.end)
                }
                _ => truth.after(motion.end.into()).attitude(),
            }
        };
        KEPT.get(self, by_series).map(|truth| *truth)
    }

    /// The attitude at the end of the motion that really begins when this one is given in a
    /// representation and as an angular momentum in space: both are rounded, and where the
    /// condition is large the rounded start is another motion.
    pub fn truth_as_given(&self, form: Form) -> Solved<Attitude> {
        let start = RigidBody::new(self.body()?).state(form(self.attitude)?, self.omega())?;
        let truth = Truth::new(self, start.attitude, Some(start.angular_momentum));
        truth.after(self.end.into()).attitude()
    }

    /// The rates at the end, in a unit of their own.
    pub fn true_rates(&self) -> [f64; 3] {
        let truth = Truth::new(self, self.attitude, None);
        truth.after(self.end.into()).rates()
    }

    /// The change of the end per relative change of the inputs, and the largest per relative
    /// change at some point of the path, which is how a method in steps is disturbed.
    pub fn conditions(&self) -> Solved<[f64; 2]> {
        let closed = self.closed(self.attitude, self.omega())?;
        let at_start = closed.condition(self.end)?;
        let mut largest = at_start;
        for k in 1..PLACES {
            let t = self.end * f64::from(k) / f64::from(PLACES);
            let there = closed.kinematics(t);
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
        if let Some([weight, lever]) = self.gravity {
            effects.push(Box::new(GravityAtLever::new(weight, lever)?));
        }
        let scene = Scene::new(body).with_list(EffectList::new(effects)?);
        let start = || body.state(from, self.omega());
        let stepper = match how {
            How::Request => return Ok(scene.solve(&start()?, self.end, asked)?.state.attitude),
            How::Solve => {
                let solved = scene.solve_by_stepping(&start()?, self.end, asked)?;
                return Ok(solved.state.attitude);
            }
            How::Steps(method, angle) => {
                Stepper::new(method, Resolution::Steps(self.steps(angle)))?
            }
            How::Dop853 => Stepper::Dop853(Dop853::new(1e-15)?.with_step_limit(STEPS_ALLOWED)?),
            _ => {
                let closed = self.closed(from, self.omega())?;
                return Ok(closed.kinematics(self.end).attitude);
            }
        };
        let (end, _) = stepper.advance_as_usual(&scene, [0.0, self.end], &start()?)?;
        Ok(end.attitude)
    }

    /// Steps in which the fastest rotation turns by an angle.
    fn steps(&self, angle: f64) -> u64 {
        let mut fastest = self
            .gravity
            .map_or(0.0, |[weight, lever]| 2.0 * (weight * lever.abs() / self.moments[0]).sqrt());
        let mut seen = vec![self.rates];
        if let Ok(exact) = self.closed(self.attitude, self.omega()) {
            let at = |k: u32| exact.kinematics(self.end * f64::from(k) / f64::from(SEEN));
            seen.extend((1..=SEEN).map(|k| at(k).angular_velocity.to_array()));
        }
        for rate in seen.into_iter().flatten() {
            fastest = rate.abs().max(fastest);
        }
        let turned = 3_f64.sqrt() * fastest * self.end.abs();
        (turned / angle).ceil().max(1.0) as u64
    }

    /// How far from the truth this attitude is (rad); NaN for none.
    pub fn off(&self, reached: Option<Attitude>) -> f64 {
        let both = self.truth().ok().zip(reached);
        both.map_or(f64::NAN, |(truth, reached)| truth.angle_to(&reached))
    }
}
