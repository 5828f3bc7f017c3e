//! A problem: a motion from a start to an end whose answer is known.

use super::{Errors, Resolution, Run, Stepper, Sweep, Variables};
use crate::attitude::Attitude;
use crate::body::State;
use crate::effects::erased::AnyEffect;
use crate::error::{Error, Result, positive};
use crate::integrators::{Method, Work};
use crate::math::{exp2, log2};
use crate::scene::Scene;
use std::sync::Arc;

type ClosedForm = Arc<dyn Fn(f64) -> Attitude + Send + Sync>;

/// A scene, its start, a time and the exact state then: a method is judged by them.
///
/// ```
/// use rotation_dynamics::accuracy::Problem;
/// use rotation_dynamics::attitude::Attitude;
/// use rotation_dynamics::body::{RigidBody, State};
/// use rotation_dynamics::exact::free_body::FreeBody;
/// use rotation_dynamics::frame::BodyVector;
/// use rotation_dynamics::inertia::PrincipalMoments;
/// use rotation_dynamics::integrators::Method;
/// use rotation_dynamics::scene::Scene;
/// # fn main() -> rotation_dynamics::Result<()> {
/// let moments = PrincipalMoments::new(1.0, 2.0, 2.5)?;
/// let rates = BodyVector::new(0.8, 0.4, 0.3375);
/// let scene = Scene::new(RigidBody::new(moments));
/// let start = scene.body().state(Attitude::IDENTITY, rates)?;
/// let motion = FreeBody::new(moments, Attitude::IDENTITY, rates)?;
/// let exact = motion.state(10.0);
/// let problem = Problem::new(scene, start, 10.0, exact);
///
/// let rk4 = problem.least(Method::Rk4, 1e-9)?.expect("RK4 gets there");
/// let gauss = problem.least(Method::GaussLegendre16, 1e-9)?.expect("and so does this");
/// assert!(rk4.errors.attitude <= 1e-9 && gauss.errors.attitude <= 1e-9);
/// assert!(rk4.work.steps > 100 * gauss.work.steps);
/// # Ok(())
/// # }
/// ```
#[derive(Clone)]
pub struct Problem<E> {
    /// What moves.
    pub scene: Scene<E>,
    /// Its state at t = 0.
    pub start: State,
    /// The time (s) at which the answer is asked for.
    pub end: f64,
    /// The exact state then.
    pub exact: State,
    closed_form: Option<ClosedForm>,
}

impl<E: AnyEffect> Problem<E> {
    /// The motion of `scene` from `start` at t = 0 to `end` (s), where it is at `exact`.
    pub const fn new(scene: Scene<E>, start: State, end: f64, exact: State) -> Self {
        Self { scene, start, end, exact, closed_form: None }
    }

    /// The same with its closed form, the attitude at a time (s): one sample of it is the
    /// unit in which times are measured.
    #[must_use]
    pub fn in_closed_form(
        mut self,
        attitude: impl Fn(f64) -> Attitude + Send + Sync + 'static,
    ) -> Self {
        self.closed_form = Some(Arc::new(attitude));
        self
    }

    /// The closed form, if there is one.
    pub const fn closed_form(&self) -> Option<&ClosedForm> {
        self.closed_form.as_ref()
    }

    /// The angle (rad) between the attitude of `reached` and the exact one.
    pub fn error(&self, reached: &State) -> f64 {
        self.exact.attitude.angle_to(&reached.attitude)
    }

    /// All errors of `reached`.
    pub fn errors(&self, reached: &State) -> Errors {
        Errors::between(&self.scene, reached, &self.exact)
    }

    /// A run of a method, from the start to the end.
    ///
    /// # Errors
    /// A refusal of the method.
    pub fn run(
        &self,
        method: Method,
        variables: Variables,
        resolution: Resolution,
    ) -> Result<(State, Work)> {
        let stepper = Stepper::new(method, resolution)?;
        stepper.advance(&self.scene, variables, [0.0, self.end], &self.start)
    }

    /// The same in the variables of [`Problem::usual`].
    ///
    /// # Errors
    /// A refusal of the method.
    pub fn run_as_usual(&self, method: Method, resolution: Resolution) -> Result<(State, Work)> {
        let stepper = Stepper::new(method, resolution)?;
        stepper.advance_as_usual(&self.scene, [0.0, self.end], &self.start)
    }

    /// A method with each setting ([`Resolution::of`]), in the order given.
    pub fn sweep(
        &self,
        method: Method,
        variables: Variables,
        settings: impl IntoIterator<Item = f64>,
    ) -> Sweep {
        Sweep::over(settings, |setting| {
            let (reached, work) = self.run(method, variables, Resolution::of(method, setting))?;
            Ok((self.errors(&reached), work))
        })
    }

    /// The least work with which a method delivers an attitude within `tolerance` (rad),
    /// as hindsight knows it; `None` if it does not, with half a million torques.
    ///
    /// Steps grow by factors of 2^(1/4) (2^(1/16) for Gauss-Legendre, which carries the
    /// scene in its best variables); all others carry attitude and momentum in space. Rungs are left
    /// out on which the error would have to fall with more than twice the method's order.
    ///
    /// # Errors
    /// A tolerance that is not positive; a method that does not apply.
    pub fn least(&self, method: Method, tolerance: f64) -> Result<Option<Run>> {
        positive("tolerance", tolerance)?;
        let mut level = 0_u32;
        while level <= finest(method) {
            let setting = at(method, level);
            let run = self.run_as_usual(method, Resolution::of(method, setting));
            let rungs = match run {
                // Steps far too long for a fast motion overflow, or their stages have no
                // solution: not delivered.
                Err(Error::FunctionOutOfRange { .. } | Error::NoConvergence { .. }) => 1,
                // More steps than a run may take, and a finer one would take more still.
                Err(Error::LimitReached { .. }) => return Ok(None),
                run => {
                    let (reached, work) = run?;
                    let error = self.error(&reached);
                    if error <= tolerance {
                        return Ok(Some(Run { setting, work, errors: self.errors(&reached) }));
                    }
                    // A run that is lost says nothing of the next.
                    if error > LOST { 1 } else { rungs_to_skip(method, error / tolerance) }
                }
            };
            level = level.saturating_add(rungs);
        }
        Ok(None)
    }

    /// The variables of [`Problem::least`].
    pub fn usual(&self, method: Method) -> Variables {
        match method {
            Method::GaussLegendre16 => Variables::best(method, &self.scene),
            _ => Variables::Space,
        }
    }
}

/// An error (rad) above which a run is not in its order.
const LOST: f64 = 0.1;

/// A rung of the ladder that [`Problem::least`] climbs.
fn at(method: Method, level: u32) -> f64 {
    match method {
        Method::Dop853 => (0.1 * exp2(-f64::from(level))).max(1e-15),
        Method::GaussLegendre16 => (6.0 * exp2(f64::from(level) / 16.0)).floor(),
        _ => (8.0 * exp2(0.25 * f64::from(level))).floor(),
    }
}

/// Rungs to the next that may deliver, where a run is off by so many times too much: on those
/// between the error would have to fall as twice the order promises.
fn rungs_to_skip(method: Method, times: f64) -> u32 {
    let halvings = match method {
        Method::Dop853 => 2.0,
        Method::GaussLegendre16 => 2.0 * f64::from(method.order()) / 16.0,
        _ => 2.0 * f64::from(method.order()) / 4.0,
    };
    (log2(times) / halvings).max(1.0) as u32
}

/// The last rung worth trying: beyond it a run costs more than half a million torques.
fn finest(method: Method) -> u32 {
    match method {
        Method::Dop853 => 46,
        Method::Srkn14 | Method::KahanLi17 => 48,
        Method::GaussLegendre16 => 152,
        Method::Rk4 | Method::MuntheKaas4 | Method::Strang => 56,
        _ => 52,
    }
}
