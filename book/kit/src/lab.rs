//! The methods of a problem at a reader's own choice: what this step, this tolerance costs.

use super::json::quoted;
use crate::error::Result;
use core::fmt;
use rotation_dynamics::Error;
use rotation_dynamics::accuracy::{Errors, Problem, Resolution, applies};
use rotation_dynamics::body::State;
use rotation_dynamics::effects::Effect;
use rotation_dynamics::integrators::{Method, Work};
use rotation_dynamics::scene::Scene;
use std::sync::{Arc, OnceLock};

/// What a run of a reader's choice delivered and paid.
#[derive(Debug, Clone, PartialEq)]
pub struct Tried {
    /// The method: the one chosen, or the one that `solve` chose.
    pub method: &'static str,
    /// How far its end is from the exact one, or from what stands for it.
    pub errors: Errors,
    /// What it cost, all runs together.
    pub(crate) work: Work,
    /// The error (rad) asked of `solve` whose end stands for the exact one; `None` if that is known.
    pub against: Option<f64>,
}

impl Tried {
    /// `{"method", "attitude", "rates", "momentum", "energy", "against", "torques", "work"}`: the
    /// errors (rad; relative), `null` for one that is not finite, what they are measured against
    /// (`null` for the exact end), and the work, counted and in words.
    pub fn json(&self) -> String {
        let number = |x: f64| match x.is_finite() {
            true => format!("{x:?}"),
            false => "null".into(),
        };
        let Errors { attitude, rates, momentum, energy, .. } = self.errors;
        let [attitude, rates, momentum, energy] = [attitude, rates, momentum, energy].map(number);
        let against = self.against.map_or("null".into(), number);
        format!(
            "{{\"method\": {}, \"attitude\": {attitude}, \"rates\": {rates}, \"momentum\": {momentum}, \
             \"energy\": {energy}, \"against\": {against}, \"torques\": {}, \"work\": {}}}",
            quoted(self.method),
            self.work.torques(),
            quoted(&self.work.to_string()),
        )
    }
}

type Try = dyn Fn(Option<Method>, f64) -> Result<Tried> + Send + Sync;

/// A problem whose methods a reader may run.
///
/// ```
/// use rotation_dynamics::accuracy::Problem;
/// use rotation_dynamics::attitude::Attitude;
/// use rotation_dynamics::body::RigidBody;
/// use rotation_dynamics::exact::free_body::FreeBody;
/// use rotation_dynamics::frame::BodyVector;
/// use rotation_dynamics::inertia::PrincipalMoments;
/// use rotation_dynamics::integrators::Method;
/// use kit::Lab;
/// use rotation_dynamics::scene::Scene;
/// let moments = PrincipalMoments::new(1.0, 2.0, 2.5)?;
/// let rates = BodyVector::new(0.8, 0.4, 0.3375);
/// let scene = Scene::new(RigidBody::new(moments));
/// let start = scene.body().state(Attitude::IDENTITY, rates)?;
/// let exact = FreeBody::new(moments, Attitude::IDENTITY, rates)?.state(10.0);
/// let lab = Lab::new(&Problem::new(scene, start, 10.0, exact));
/// let [coarse, fine] = [100.0, 200.0].map(|steps| lab.run(Method::Rk4, steps));
/// let gain = coarse?.errors.attitude / fine?.errors.attitude;
/// assert!((gain.log2() - 4.0).abs() < 0.1); // a method of order 4
/// assert!(lab.solve(1e-9)?.errors.attitude <= 1e-9);
/// # Ok::<(), kit::Error>(())
/// ```
#[derive(Clone)]
pub struct Lab {
    methods: Vec<Method>,
    span: f64,
    run: Arc<Try>,
}

/// What a run is judged by: the end, and the error asked of `solve` that gave it, if it did.
type Judge = (State, Option<f64>);

impl Lab {
    /// The methods that apply to this problem, with `solve`.
    pub fn new<E>(problem: &Problem<E>) -> Self
    where
        E: Effect + Clone + Send + Sync + 'static,
    {
        Self::judged(problem.clone(), |problem| Ok((problem.exact, None)))
    }

    /// The same for a motion that nothing knows exactly, of `scene` from `start` to `end` (s):
    /// runs are judged by `solve` at the least error that it grants, from 1e-12 rad upwards in
    /// powers of ten, which is asked when the first is judged.
    ///
    /// ```
    /// use rotation_dynamics::attitude::Attitude;
    /// use rotation_dynamics::body::RigidBody;
    /// use rotation_dynamics::effects::{GravityAtLever, ViscousFriction};
    /// use rotation_dynamics::frame::BodyVector;
    /// use rotation_dynamics::inertia::PrincipalMoments;
    /// use rotation_dynamics::integrators::Method;
    /// use kit::Lab;
    /// use rotation_dynamics::scene::Scene;
    /// let body = RigidBody::new(PrincipalMoments::symmetric(1.0, 0.5)?);
    /// let start = body.state(Attitude::IDENTITY, BodyVector::new(0.3, 0.0, 4.0))?;
    /// let scene = Scene::new(body).with(GravityAtLever::new(1.0, 0.4)?);
    /// let scene = scene.with(ViscousFriction::about_axis(0.05)?);
    /// let lab = Lab::against_error_control(scene, start, 5.0);
    /// let [coarse, fine] = [100.0, 200.0].map(|steps| lab.run(Method::Rk4, steps));
    /// let (coarse, fine) = (coarse?, fine?);
    /// assert_eq!(coarse.against, Some(1e-12));
    /// assert!(((coarse.errors.attitude / fine.errors.attitude).log2() - 4.0).abs() < 0.2);
    /// # Ok::<(), kit::Error>(())
    /// ```
    pub fn against_error_control<E>(scene: Scene<E>, start: State, end: f64) -> Self
    where
        E: Effect + Clone + Send + Sync + 'static,
    {
        let known = OnceLock::new();
        Self::judged(Problem::new(scene, start, end, start), move |problem| {
            if let Some(judge) = known.get() {
                return Ok(*judge);
            }
            let judge = tightest(problem)?;
            Ok(*known.get_or_init(|| judge))
        })
    }

    fn judged<E>(
        problem: Problem<E>,
        judge: impl Fn(&Problem<E>) -> Result<Judge> + Send + Sync + 'static,
    ) -> Self
    where
        E: Effect + Clone + Send + Sync + 'static,
    {
        let all = Method::ALL.into_iter();
        Self {
            methods: all.filter(|method| applies::<E>(*method)).collect(),
            span: problem.end,
            run: Arc::new(move |method, setting| {
                let (method, reached, work) = match method {
                    Some(method) => {
                        let resolution = Resolution::of(method, setting);
                        let (reached, work) = problem.run_as_usual(method, resolution)?;
                        (method.name(), reached, work)
                    }
                    None => {
                        let (scene, start) = (&problem.scene, &problem.start);
                        let solved = scene.solve_by_stepping(start, problem.end, setting)?;
                        (solved.method, solved.state, solved.work)
                    }
                };
                let (end, against) = judge(&problem)?;
                Ok(Tried {
                    method,
                    errors: Errors::between(&problem.scene, &reached, &end),
                    work,
                    against,
                })
            }),
        }
    }

    /// The methods that apply.
    pub fn methods(&self) -> &[Method] {
        &self.methods
    }

    /// The time (s) at whose end the errors are found.
    pub fn span(&self) -> f64 {
        self.span
    }

    /// A run of a method with so many steps; of DOP853, with this tolerance of a step.
    ///
    /// # Errors
    /// What the method refuses.
    pub fn run(&self, method: Method, setting: f64) -> Result<Tried> {
        (self.run)(Some(method), setting)
    }

    /// `solve`, stepping: an attitude asked for within so many rad at the end.
    ///
    /// # Errors
    /// As [`Scene::solve_by_stepping`](rotation_dynamics::scene::Scene::solve_by_stepping).
    pub fn solve(&self, tolerance: f64) -> Result<Tried> {
        (self.run)(None, tolerance)
    }
}

/// The end by `solve` at the least error that it grants.
fn tightest<E: Effect>(problem: &Problem<E>) -> rotation_dynamics::Result<Judge> {
    let by = |tolerance| {
        let solved = (problem.scene).solve_by_stepping(&problem.start, problem.end, tolerance)?;
        Ok((solved.state, Some(tolerance)))
    };
    for tolerance in [1e-12, 1e-11, 1e-10, 1e-9, 1e-8, 1e-7] {
        match by(tolerance) {
            Err(Error::NotDelivered { .. }) => {}
            told => return told,
        }
    }
    by(1e-6)
}

impl fmt::Debug for Lab {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Lab({:?} over {} s)", self.methods, self.span)
    }
}
