//! Dense output: the attitude 256 times a period, over 100 periods.

use crate::contest::{OURS, Setting};
use crate::contestants::{differential_equations, ivp, numeris, ode_solvers, ours};
use crate::form::{Form, FreeMomentum, Own, TopMomentum, TopWithoutSpin};
use crate::problem::{Exact, Motion, Problem};
use core::cell::RefCell;
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::Kinematics;

/// Samples in a period.
pub const PER_PERIOD: usize = 256;

/// Periods.
pub const PERIODS: usize = 100;

/// The errors to be kept at all samples (rad).
pub const TARGETS: [f64; 4] = [1e-3, 1e-6, 1e-9, 1e-12];

/// Samples asked for in one call of a batch form.
const BATCH: usize = 256;

type Run = Box<dyn Fn(Setting) -> Result<(), String>>;
/// Fills quaternions at times, to a tolerance.
type Solver<F> = fn(F, &[f64], &mut [[f64; 4]], f64) -> Result<(), String>;
/// Fills samples at times.
type Sample<S> = fn(&Exact, &[f64], &mut [S]) -> Result<(), String>;
type Quaternions = RefCell<Vec<[f64; 4]>>;

/// A way to dense output.
pub struct Sampler {
    /// The crate; `-` for this library.
    pub peer: &'static str,
    /// The method.
    pub method: &'static str,
    /// The variables.
    pub form: &'static str,
    /// Whether it takes a tolerance.
    pub adaptive: bool,
    /// Fills its samples.
    pub run: Run,
    /// The largest error of the samples it filled last (rad).
    pub error: Box<dyn Fn() -> Result<f64, String>>,
}

impl Sampler {
    /// The name in the record.
    pub fn name(&self) -> String {
        match self.peer {
            OURS => self.method.to_owned(),
            peer => format!("{peer} {}", self.method),
        }
    }
}

/// The times of the samples: evenly spaced from 0.
pub fn times(problem: &Problem) -> Vec<f64> {
    let step = problem.period / PER_PERIOD as f64;
    (0..=PERIODS * PER_PERIOD).map(|n| n as f64 * step).collect()
}

fn in_words(error: rotation_dynamics::Error) -> String {
    error.to_string()
}

/// The samples that are to be met.
fn wanted(problem: &Problem) -> rotation_dynamics::Result<Vec<Attitude>> {
    let exact = problem.exact()?;
    Ok(times(problem).iter().map(|&t| exact.attitude(t)).collect())
}

fn largest(
    samples: impl Iterator<Item = Result<Attitude, String>>,
    wanted: &[Attitude],
) -> Result<f64, String> {
    let mut largest = 0.0_f64;
    for (sample, wanted) in samples.zip(wanted) {
        let error = sample?.angle_to(wanted);
        if error.is_nan() {
            return Ok(f64::INFINITY);
        }
        largest = largest.max(error);
    }
    Ok(largest)
}

/// A sampler that writes quaternions.
fn stepping<const N: usize, F: Form<N>>(
    (peer, method): (&'static str, &'static str),
    form: F,
    problem: &'static Problem,
    solver: Solver<F>,
) -> rotation_dynamics::Result<Sampler> {
    let times = times(problem);
    let wanted = wanted(problem)?;
    let out: Quaternions = RefCell::new(vec![[0.0; 4]; times.len()]);
    let out = std::rc::Rc::new(out);
    let filled = out.clone();
    Ok(Sampler {
        peer,
        method,
        form: F::NAME,
        adaptive: true,
        run: Box::new(move |setting| match setting {
            Setting::Tolerance(tolerance) => solver(form, &times, &mut out.borrow_mut(), tolerance),
            _ => Err(format!("not told so: {setting}")),
        }),
        error: Box::new(move || {
            let filled = filled.borrow();
            let attitudes = filled.iter().map(|q| Attitude::from_quaternion(*q).map_err(in_words));
            largest(attitudes, &wanted)
        }),
    })
}

/// A sampler of a closed form, which it has set up before.
fn exact<S: Clone + 'static>(
    method: &'static str,
    problem: &'static Problem,
    none: S,
    attitude: fn(&S) -> Attitude,
    sample: Sample<S>,
) -> rotation_dynamics::Result<Sampler> {
    let times = times(problem);
    let motion = problem.exact()?;
    let wanted = wanted(problem)?;
    let out = std::rc::Rc::new(RefCell::new(vec![none; times.len()]));
    let filled = out.clone();
    Ok(Sampler {
        peer: OURS,
        method,
        form: "-",
        adaptive: false,
        run: Box::new(move |_| {
            let mut out = out.borrow_mut();
            for (times, out) in times.chunks(BATCH).zip(out.chunks_mut(BATCH)) {
                sample(&motion, times, out)?;
            }
            Ok(())
        }),
        error: Box::new(move || {
            let filled = filled.borrow();
            largest(filled.iter().map(|sample| Ok(attitude(sample))), &wanted)
        }),
    })
}

fn peers<const N: usize, F: Form<N>>(
    form: F,
    problem: &'static Problem,
) -> rotation_dynamics::Result<Vec<Sampler>> {
    Ok(vec![
        stepping((OURS, "DOP853"), form, problem, own_dop853)?,
        stepping(("numeris", "RKV98"), form, problem, numeris::rkv98_dense)?,
        stepping(("ode_solvers", "Dop853"), form, problem, ode_solvers::dop853_dense)?,
        stepping(
            ("differential-equations", "DOP853"),
            form,
            problem,
            differential_equations::dop853_dense,
        )?,
        stepping(("ivp", "DOP853"), form, problem, ivp::dop853_dense)?,
    ])
}

fn own_dop853<const N: usize, F: Form<N>>(
    form: F,
    times: &[f64],
    out: &mut [[f64; 4]],
    tolerance: f64,
) -> Result<(), String> {
    let run = || -> rotation_dynamics::Result<()> {
        let end = times.last().copied().unwrap_or(0.0);
        let method = ours::dop853(tolerance)?;
        let solution = method.solve(&Own(form), 0.0, &form.start(), end, &[])?;
        for (&t, out) in times.iter().zip(out) {
            *out = form.quaternion(t, &solution.at(t)?);
        }
        Ok(())
    };
    run().map_err(in_words)
}

/// Every way to dense output of `problem`.
///
/// # Errors
/// None for the problems of this crate.
pub fn samplers(problem: &'static Problem) -> rotation_dynamics::Result<Vec<Sampler>> {
    let alone = |attitude: &Attitude| *attitude;
    let mut all = vec![exact(
        "closed form, one by one",
        problem,
        Attitude::IDENTITY,
        alone,
        |exact, times, out| {
            for (&t, out) in times.iter().zip(out) {
                *out = exact.attitude(t);
            }
            Ok(())
        },
    )?];
    all.push(exact(
        "closed form, batch",
        problem,
        Kinematics::REST,
        |sample| sample.attitude,
        |exact, times, out| match exact {
            Exact::Free(body) => body.kinematics_at(times, out).map_err(in_words),
            Exact::Top(top) => top.kinematics_at(times, out).map_err(in_words),
        },
    )?);
    match problem.motion {
        Motion::Open { .. } => {}
        Motion::Free { .. } => all.extend(peers(FreeMomentum::new(problem)?, problem)?),
        Motion::Top { .. } => {
            all.extend(peers(TopWithoutSpin::new(problem)?, problem)?);
            all.extend(peers(TopMomentum::new(problem)?, problem)?);
        }
    }
    Ok(all)
}
