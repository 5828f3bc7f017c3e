//! A motion as a case: its truth, its condition, and every method in every representation.

use super::truth::{Place, Truth};
use super::*;

/// A representation: an attitude written as numbers, and read back.
pub type Form = fn(Attitude) -> Solved<Attitude>;
pub const QUATERNION: Form = |a| Attitude::from_quaternion(a.quaternion());
pub const MATRIX: Form = |a| Attitude::from_matrix(a.matrix());
const EULER: Form = |a| Attitude::from_euler(a.euler_angles());
const YAW: Form = |a| Attitude::from_yaw_pitch_roll(a.yaw_pitch_roll());
const VECTOR: Form = |a| Attitude::from_rotation_vector(a.rotation_vector());
/// All of them, and their names.
pub const FORMS: [Form; 5] = [QUATERNION, MATRIX, EULER, YAW, VECTOR];
pub const NAMES: [&str; 5] =
    ["quaternion", "matrix", "Euler angles", "yaw, pitch, roll", "rotation vector"];

/// The attitude with these Euler angles (rad).
pub fn turned(phi: f64, theta: f64, zeta: f64) -> Solved<Attitude> {
    Attitude::from_euler(EulerAngles { phi, theta, zeta })
}

/// What is carried from here to its end, in each form: how far that is from the truth, if there is
/// one, and the bound. Forms that give one start share a run.
pub fn in_each_form(
    from: Attitude,
    truth: Option<Attitude>,
    bound: f64,
    mut carried: impl FnMut(Attitude) -> Solved<Attitude>,
) -> [(Solved<f64>, f64); 5] {
    let mut runs: Vec<(Attitude, Solved<Attitude>)> = Vec::new();
    let mut off = |form: Form| {
        let start = form(from)?;
        let known = runs.iter().find(|(from, _)| *from == start);
        let end = known.map_or_else(|| carried(start), |(_, end)| end.clone());
        runs.push((start, end.clone()));
        let end = form(end?)?;
        Ok(truth.map_or(f64::NAN, |truth| truth.angle_to(&end)))
    };
    FORMS.map(|form| (off(form), bound))
}

/// How a case is carried to its end.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum By {
    ClosedForm,
    /// An error is asked for; the scene has a closed form, and that answers.
    Request,
    /// The same, answered by stepping all the same.
    Solve,
    Steps(Method),
    /// Gauss-Legendre, started anew where a torque jumps.
    Pieces,
    /// DOP853 that locates events, bodies that collide, and what theory says of a method.
    Events,
    Contacts,
    Foretold,
}

const GAUSS: By = By::Steps(Method::GaussLegendre16);
const SPLIT: By = By::Steps(Method::Srkn14);
pub const DOP853: By = By::Steps(Method::Dop853);
const RK4: By = By::Steps(Method::Rk4);

impl By {
    /// For a body on which nothing acts.
    pub const FREE: [Self; 5] = [Self::ClosedForm, Self::Solve, GAUSS, DOP853, RK4];
    /// For a symmetric top: a splitting too.
    pub const TOP: [Self; 6] = [Self::ClosedForm, Self::Solve, SPLIT, GAUSS, DOP853, RK4];
    /// Without steps: what a request to `solve` is answered with too.
    pub const CLOSED: [Self; 2] = [Self::ClosedForm, Self::Request];

    pub const fn name(self) -> &'static str {
        match self {
            Self::ClosedForm => "closed form",
            Self::Request => "solve",
            Self::Solve => "solve, stepping",
            Self::Steps(method) => method.name(),
            Self::Pieces => "Gauss-Legendre 16, piece by piece",
            Self::Events => "DOP853 with located events",
            Self::Contacts => "contact solver",
            Self::Foretold => "foretold by the method's own polynomial or solution",
        }
    }

    /// K eps times the condition, with one K for all cases.
    pub fn bound(self, condition: f64) -> f64 {
        let k = match self {
            Self::ClosedForm => 2.0,
            // What is asked for, and must be proved.
            Self::Request | Self::Solve => 4096.0,
            GAUSS | SPLIT | Self::Pieces | Self::Contacts => 8.0,
            DOP853 | Self::Events => 32.0,
            // Of RK4 per step, of what a step is given.
            Self::Steps(_) | Self::Foretold => 64.0,
        };
        k * EPS * condition
    }

    /// The angle (rad) that the fastest rotation makes in a step.
    fn angle(self) -> f64 {
        match self {
            GAUSS => 1.0,
            SPLIT => 0.08,
            _ => 0.001,
        }
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

/// A plain method that everyone writes first, and its error on a motion.
pub type Plain = (&'static str, fn(&Motion) -> Solved<f64>);

/// A motion as it is asked: what the naive method made of it, its conditions, and its end.
pub struct Asked(pub Motion, pub Naive, pub [f64; 2], pub Attitude);

impl Asked {
    /// Each method in each representation.
    pub fn by(self, methods: &[By]) -> Result<Answered> {
        let Self(motion, naive, [condition, path], truth) = self;
        let mut answers = Vec::new();
        for by in methods {
            // Where no step is made only the start's own rounding is felt.
            let closed = By::CLOSED.contains(by);
            let bound = by.bound(if closed { condition } else { path });
            let carried = |from| motion.carried(*by, from, bound);
            answers.extend(in_each_form(motion.attitude, Some(truth), bound, carried));
        }
        Ok(Answered(condition, naive, answers))
    }
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

/// The points of a path at which a disturbance is followed to the end.
const PLACES: u32 = 8;

/// The times at which a path is looked at for its fastest rate.
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
        let ([i1, i3], gravity) = (moments, Some([pull.abs(), 1_f64.copysign(pull)]));
        Self { gravity, ..Self::free([i1, i1, i3], from, rates, end) }
    }

    /// The same to another end.
    pub fn until(&self, end: f64) -> Self {
        Self { end, ..*self }
    }

    /// As a case, beside this naive method.
    pub fn against(&self, plain: Plain) -> Solved<Asked> {
        self.beside((plain.0, plain.1(self)?))
    }

    /// The same beside one whose error is known.
    pub fn beside(&self, naive: Naive) -> Solved<Asked> {
        Ok(Asked(*self, naive, self.conditions()?, self.truth()?))
    }

    /// The same with a condition that is known.
    pub fn of_condition(&self, condition: f64, plain: Plain) -> Solved<Asked> {
        let naive = (plain.0, plain.1(self)?);
        Ok(Asked(*self, naive, [condition; 2], self.truth()?))
    }

    pub fn body(&self) -> Solved<PrincipalMoments> {
        let [i1, i2, i3] = self.moments;
        PrincipalMoments::new(i1, i2, i3)
    }

    pub fn rates(&self) -> BodyVector {
        BodyVector::from_array(self.rates)
    }

    /// The angular momentum on the body's axes with these rates.
    pub fn momentum(&self, rates: [f64; 3]) -> BodyVector {
        let [i1, i2, i3] = self.moments;
        BodyVector::new(i1 * rates[0], i2 * rates[1], i3 * rates[2])
    }

    /// The closed form of a body on which nothing acts.
    pub fn free_body(&self) -> Solved<FreeBody> {
        FreeBody::new(self.body()?, self.attitude, self.rates())
    }

    fn closed(&self, from: Kinematics) -> Solved<Box<dyn Closed>> {
        let (attitude, rates) = (from.attitude, from.angular_velocity);
        let Some([weight, lever]) = self.gravity else {
            return Ok(Box::new(FreeBody::new(self.body()?, attitude, rates)?));
        };
        let top = SymmetricTop::new(self.moments[0], self.moments[2], weight, lever)?;
        Ok(Box::new(HeavyTop::new(top, attitude, rates)?))
    }

    fn closed_from(&self, attitude: Attitude) -> Solved<Box<dyn Closed>> {
        self.closed(Kinematics::new(attitude, self.rates()))
    }

    /// The attitude at the end, by series; kept until another motion's is asked for.
    pub fn truth(&self) -> Solved<Attitude> {
        static KEPT: Prepared<Motion, Attitude> = Prepared::new();
        KEPT.get(self, Self::by_series).map(|truth| *truth)
    }

    fn by_series(&self) -> Solved<Attitude> {
        let (truth, start) = self.series()?;
        if let (None, Ok(motion)) = (self.gravity, self.free_body()) {
            let period = motion.rate_period();
            if self.end.abs() > MANY * period {
                return truth.late(&start, period, self.end);
            }
        }
        truth.after(&start, self.end.into()).attitude()
    }

    /// The attitude at the end of the motion that really begins when this one is given in a
    /// representation and as an angular momentum in space: both are rounded, and where the
    /// condition is large that is another motion.
    pub fn truth_as_given(&self, form: Form) -> Solved<Attitude> {
        let body = RigidBody::new(self.body()?);
        let start = body.state(form(self.attitude)?, self.rates())?;
        let (truth, _) = self.series()?;
        let start = truth.place_of(&start);
        truth.after(&start, self.end.into()).attitude()
    }

    /// The rates at the end, in a unit of their own.
    pub fn true_rates(&self) -> Solved<[f64; 3]> {
        let (truth, start) = self.series()?;
        Ok(truth.after(&start, self.end.into()).rates())
    }

    fn series(&self) -> Solved<(Truth, Place)> {
        let moments = self.body()?.to_array();
        let truth = Truth::new(moments, self.gravity.unwrap_or([0.0; 2]), self.rates);
        let start = truth.place(self.attitude, self.rates);
        Ok((truth, start))
    }

    /// The change of the end per relative change of the inputs, and the largest per relative
    /// change at some point of the path: what a method in steps is disturbed by.
    pub fn conditions(&self) -> Solved<[f64; 2]> {
        let closed = self.closed_from(self.attitude)?;
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
    pub fn reached(&self, by: By, form: Form, asked: f64) -> Solved<Attitude> {
        form(self.carried(by, form(self.attitude)?, asked)?)
    }

    /// The closed form at the end, given and delivered as a quaternion.
    pub fn in_closed_form(&self) -> Solved<Attitude> {
        self.reached(By::ClosedForm, QUATERNION, 0.0)
    }

    fn carried(&self, by: By, from: Attitude, asked: f64) -> Solved<Attitude> {
        if by == By::ClosedForm {
            return Ok(self.closed_from(from)?.kinematics(self.end).attitude);
        }
        let scene = Scene::new(RigidBody::new(self.body()?));
        let end = match self.gravity {
            None => self.stepped(&scene, from, by, asked)?,
            Some([weight, lever]) => {
                let scene = scene.with(GravityAtLever::new(weight, lever)?);
                self.stepped(&scene, from, by, asked)?
            }
        };
        Ok(end.attitude)
    }

    fn stepped<E: Effect>(
        &self,
        scene: &Scene<E>,
        from: Attitude,
        by: By,
        asked: f64,
    ) -> Solved<State> {
        let start = scene.body().state(from, self.rates())?;
        let stepper = match by {
            DOP853 => Stepper::Dop853(Dop853::new(1e-15)?.with_step_limit(STEPS_ALLOWED)?),
            By::Steps(method) => Stepper::new(method, Resolution::Steps(self.steps(by)))?,
            By::Request => return Ok(scene.solve(&start, self.end, asked)?.state),
            _ => return Ok(scene.solve_by_stepping(&start, self.end, asked)?.state),
        };
        let run = stepper.advance_as_usual(scene, [0.0, self.end], &start);
        run.map(|(end, _)| end)
    }

    /// Steps in which the fastest rotation turns by the method's angle.
    fn steps(&self, by: By) -> u64 {
        let largest = |most: f64, rates: [f64; 3]| rates.iter().fold(most, |m, w| m.max(w.abs()));
        let pulled = self
            .gravity
            .map_or(0.0, |[weight, lever]| 2.0 * (weight * lever.abs() / self.moments[0]).sqrt());
        let mut fastest = largest(pulled, self.rates);
        if let Ok(exact) = self.closed_from(self.attitude) {
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
        let both = self.truth().ok().zip(reached);
        both.map_or(f64::NAN, |(truth, reached)| truth.angle_to(&reached))
    }
}
