//! The accuracy strip: what `solve` delivers and pays, and what each method would.

use super::{ClosedForm, Computation, Lab, Price, Report};
use crate::error::{Result, positive};
use core::fmt;
use rotation_dynamics::Error;
use rotation_dynamics::accuracy::{Problem, Resolution, Solved, applies, largest};
use rotation_dynamics::effects::Effect;
#[cfg(doc)]
use rotation_dynamics::integrators::Dop853;
use rotation_dynamics::integrators::{LocatedEvent, Method, Work};
use rotation_dynamics::math::sort_by_number;
use std::sync::{Arc, OnceLock};

/// The methods whose least work is shown, where they apply.
const SHOWN: [Method; 6] = [
    Method::Rk4,
    Method::Strang,
    Method::Srkn6,
    Method::Srkn14,
    Method::Dop853,
    Method::GaussLegendre16,
];

/// The label of `solve` where it takes the closed form.
const CLOSED_FORM: &str = "solve";

/// The label of `solve` where it steps: the report then has a [`Lab`], too.
pub const STEPPING: &str = "solve, stepping";

/// In place of the work of a run that was refused.
const REFUSED: &str = "refused";

type Solve<E> = fn(&Problem<E>, f64) -> rotation_dynamics::Result<Solved>;

/// From the largest to the smallest, each once.
fn descending(mut tolerances: Vec<f64>) -> Result<Vec<f64>> {
    for &tolerance in &tolerances {
        positive("tolerance", tolerance)?;
    }
    sort_by_number(&mut tolerances, |tolerance| -tolerance);
    tolerances.dedup();
    Ok(tolerances)
}

type Compute = dyn Fn() -> Result<Vec<Price>> + Send + Sync;

/// Lines of the accuracy strip, computed when they are first read.
#[derive(Clone)]
pub(super) struct Lines {
    compute: Arc<Compute>,
    known: Arc<OnceLock<Vec<Price>>>,
}

impl Lines {
    /// What `compute` gives.
    pub(super) fn new(compute: impl Fn() -> Result<Vec<Price>> + Send + Sync + 'static) -> Self {
        Self { compute: Arc::new(compute), known: Arc::default() }
    }

    /// The lines, as they were computed or computed now.
    pub(super) fn get(&self) -> Result<&[Price]> {
        if let Some(known) = self.known.get() {
            return Ok(known);
        }
        let lines = (self.compute)()?;
        Ok(self.known.get_or_init(|| lines))
    }
}

impl fmt::Debug for Lines {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Lines({:?})", self.known.get())
    }
}

impl Report {
    /// Adds the accuracy strip of a problem, from the largest error to the smallest.
    ///
    /// For each of `tolerances` (rad) a line for `solve`, stepping, with all its runs. For
    /// the first, which is the page's own, also `solve` as it is, where that takes the
    /// closed form, and the least work of each method, as hindsight knows it. Every line can
    /// be run again by those who measure time; the unit is a sample of the closed form. The
    /// problem is then the report's [`Lab`], too.
    ///
    /// The lines are computed when they are read ([`Report::prices`]), which is refused for a
    /// tolerance that the page's own lines cannot have, and where a method refuses.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for a tolerance that is not above 0 and finite.
    pub fn strip<E>(&mut self, problem: &Problem<E>, tolerances: &[f64]) -> Result<()>
    where
        E: Effect + Clone + Send + Sync + 'static,
    {
        let Some(&own) = tolerances.first() else {
            return Ok(());
        };
        let of = problem.clone();
        let tolerances = descending(tolerances.to_vec())?;
        self.add_lines(move || strip(&of, own, &tolerances));
        self.set_lab(Lab::new(problem));
        if let Some(attitude) = problem.closed_form().cloned() {
            let end = problem.end;
            self.set_closed_form(ClosedForm::new(move |part| Ok(attitude(part * end))));
        }
        Ok(())
    }

    /// Adds a line for each of `tolerances`, from the largest to the smallest: what `run`
    /// delivers for it, as `error` judges, and its work; or that it refuses, where it does with
    /// [`Error::NotDelivered`]. The lines are computed when they are read ([`Report::prices`]),
    /// which is refused where `run` refuses otherwise, or `error` does.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for a tolerance that is not above 0 and finite.
    pub fn controlled<T, E, W>(
        &mut self,
        method: &str,
        tolerances: impl IntoIterator<Item = f64>,
        run: impl Fn(f64) -> core::result::Result<T, E> + Clone + Send + Sync + 'static,
        work: fn(&T) -> W,
        error: impl Fn(&T) -> Result<f64> + Clone + Send + Sync + 'static,
    ) -> Result<()>
    where
        T: 'static,
        E: Into<crate::Error> + 'static,
        W: fmt::Display + 'static,
    {
        let method = method.to_owned();
        let tolerances = descending(tolerances.into_iter().collect())?;
        self.add_lines(move || {
            let line = |&requested: &f64| {
                let (delivered, work, again) = match run(requested).map_err(Into::into) {
                    Ok(done) => {
                        let run = run.clone();
                        let again = Computation::new(
                            move || run(requested).map_err(Into::into),
                            error.clone(),
                        );
                        (error(&done)?, work(&done).to_string(), Some(again))
                    }
                    Err(crate::Error::Library(Error::NotDelivered {
                        best,
                        condition: None,
                        ..
                    })) => (best, REFUSED.into(), None),
                    Err(other) => return Err(other),
                };
                let (method, requested) = (method.clone(), Some(requested));
                Ok(Price { method, requested, delivered, work, again })
            };
            tolerances.iter().map(line).collect()
        });
        Ok(())
    }

    /// The lines of [`controlled`](Self::controlled) for a simulation by DOP853 with this error of a
    /// step.
    ///
    /// # Errors
    /// As [`controlled`](Self::controlled).
    pub fn stepped<T, E>(
        &mut self,
        steps: impl IntoIterator<Item = f64>,
        run: impl Fn(f64) -> core::result::Result<T, E> + Clone + Send + Sync + 'static,
        work: fn(&T) -> Work,
        error: impl Fn(&T) -> Result<f64> + Clone + Send + Sync + 'static,
    ) -> Result<()>
    where
        T: 'static,
        E: Into<crate::Error> + 'static,
    {
        self.controlled("DOP853, error of a step", steps, run, work, error)
    }

    /// The lines of [`stepped`](Self::stepped), on a motion that
    /// comes back: `back` finds that event (as [`Dop853::zero`] does), which is known to be at
    /// the time `period`, with `place` as the first of its components. The larger of the
    /// relative error of the time and the error of the place counts.
    ///
    /// ```
    /// use rotation_dynamics::integrators::{Dop853, second_order};
    /// use kit::Report;
    /// let mut report = Report::new("A spring", "a weight on a spring, for a swing")?;
    /// let swing = |step| {
    ///     Dop853::new(step)?.zero(&second_order(|_, x, _| -x), [1.0, 0.0], 2, 10.0, |y| y[1])
    /// };
    /// report.dial_of_return([1e-3, 1e-6, 1e-9], swing, core::f64::consts::TAU, 1.0)?;
    /// assert!(report.prices()?[2].delivered < 1e-9);
    /// # Ok::<(), kit::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`controlled`](Self::controlled).
    pub fn dial_of_return<E: Into<crate::Error> + 'static, const N: usize>(
        &mut self,
        tolerances: impl IntoIterator<Item = f64>,
        back: impl Fn(f64) -> core::result::Result<(LocatedEvent<N>, Work), E>
        + Clone
        + Send
        + Sync
        + 'static,
        period: f64,
        place: f64,
    ) -> Result<()> {
        let error = move |(back, _): &(LocatedEvent<N>, Work)| {
            Ok(largest([back.t / period - 1.0, back.state[0] - place]))
        };
        self.stepped(tolerances, back, |run| run.1, error)
    }
}

/// The lines of the strip; `own` is the page's own tolerance.
fn strip<E>(problem: &Problem<E>, own: f64, tolerances: &[f64]) -> Result<Vec<Price>>
where
    E: Effect + Clone + Send + Sync + 'static,
{
    let solve: Solve<E> = |p, error| p.scene.solve(&p.start, p.end, error);
    let step: Solve<E> = |p, error| p.scene.solve_by_stepping(&p.start, p.end, error);
    let mut lines = Vec::new();
    for &tolerance in tolerances {
        if tolerance == own && problem.closed_form().is_some() {
            lines.push(solved(problem, CLOSED_FORM, tolerance, solve)?);
        }
        lines.push(solved(problem, STEPPING, tolerance, step)?);
        if tolerance == own {
            for method in SHOWN.into_iter().filter(|method| applies::<E>(*method)) {
                lines.extend(least(problem, method, tolerance)?);
            }
        }
    }
    Ok(lines)
}

/// What `solve` delivers, or that it refuses and the least it could.
fn solved<E>(problem: &Problem<E>, label: &str, requested: f64, solve: Solve<E>) -> Result<Price>
where
    E: Effect + Clone + Send + Sync + 'static,
{
    let (method, delivered, work, again) = match solve(problem, requested) {
        Ok(solved) => {
            let (run, judge) = (problem.clone(), problem.clone());
            let again = Computation::new(
                move || Ok(solve(&run, requested)?),
                move |solved| Ok(judge.error(&solved.state)),
            );
            let error = problem.error(&solved.state);
            (solved.method, error, solved.work.to_string(), Some(again))
        }
        // What the reader asked for and cannot have is an error, with its reason.
        Err(Error::NotDelivered { best, condition: Some(_), .. })
            if label != CLOSED_FORM && best.is_finite() =>
        {
            ("-", best, REFUSED.into(), None)
        }
        Err(other) => return Err(other.into()),
    };
    Ok(Price {
        method: format!("{label}: {method}"),
        requested: Some(requested),
        delivered,
        work,
        again,
    })
}

/// The least work with which a method delivers, if it does.
fn least<E>(problem: &Problem<E>, method: Method, requested: f64) -> Result<Option<Price>>
where
    E: Effect + Clone + Send + Sync + 'static,
{
    let Some(run) = problem.least(method, requested)? else {
        return Ok(None);
    };
    let (runner, judge) = (problem.clone(), problem.clone());
    let setting = run.setting;
    let again = Computation::new(
        move || Ok(runner.run_as_usual(method, Resolution::of(method, setting))?),
        move |(reached, _)| Ok(judge.error(reached)),
    );
    Ok(Some(Price {
        method: format!("least: {}", method.name()),
        requested: Some(requested),
        delivered: run.errors.attitude,
        work: run.work.to_string(),
        again: Some(again),
    }))
}
