//! Every method on every motion, coarser and finer.

use super::Parameters;
use super::motions::{self, Motion};
use kit::{Result, Trajectory, rounded_up};
use rotation_dynamics::Error;
use rotation_dynamics::accuracy::{Errors, Measure, Point, Run, Sweep, WorkPrecision};
use rotation_dynamics::integrators::{Method, Work};
use rotation_dynamics::math::{exp2, pow};

/// A method on a motion.
pub struct Line {
    pub method: Method,
    pub key: &'static str,
    pub name: &'static str,
    pub sweep: Sweep,
    /// Error of the attitude against evaluations.
    pub attitude: WorkPrecision,
}

/// Evaluations that a run may cost, in powers of two: from, to, and to for the foils,
/// which are slow and gain nothing more.
const FROM: f64 = 5.0;
const TO: f64 = 17.0;
const TO_FOILS: f64 = 14.0;

/// The exact flow: without torque a splitting is nothing else. No truncation, and the
/// closed form under another name, so it competes with nobody.
pub const FLOW: &str = "flow";

/// Evaluations in a step.
fn in_a_step(method: Method) -> f64 {
    match (method, method.scheme()) {
        (_, Some(scheme)) => scheme.kicks() as f64,
        (Method::Rk4 | Method::MuntheKaas4, _) => 4.0,
        (Method::GaussLegendre16, _) => 120.0,
        _ => 1.0,
    }
}

/// The settings of a sweep, from coarse to fine.
pub fn settings(method: Method) -> Vec<f64> {
    if method == Method::Dop853 {
        return (3..=45).map(|k| pow(10.0, -f64::from(k) / 3.0)).collect();
    }
    // The error falls by a factor of about 4 from one to the next.
    let finer = 2.0 / f64::from(method.order().max(4));
    let to = if method.order() == 1 { TO_FOILS } else { TO };
    let count = (to - FROM) / finer;
    let mut settings: Vec<f64> = (0..=count as u32)
        .map(|k| (exp2(FROM + finer * f64::from(k)) / in_a_step(method)).floor())
        .filter(|n| *n >= 1.0)
        .collect();
    settings.dedup();
    settings
}

/// What is counted: evaluations of the derivative or the kick, each with one torque.
pub fn evaluations(work: &Work) -> u64 {
    work.torques()
}

impl Line {
    fn new(method: Method, sweep: Sweep) -> Result<Self> {
        Ok(Self {
            method,
            key: method.key(),
            name: method.name(),
            attitude: sweep.curve(Measure::Attitude, evaluations)?,
            sweep,
        })
    }

    /// What no method of the list is: the exact flow, DOP853 on the Euler angles.
    fn called(mut self, key: &'static str, name: &'static str) -> Self {
        (self.key, self.name) = (key, name);
        self
    }

    /// The floor, if the method has come to it: the last doubling of the work gained less
    /// than half the digits that the order promises.
    pub fn reached(&self, measure: Measure) -> Result<Option<Point>> {
        let curve = self.sweep.curve(measure, evaluations)?;
        let half = 0.5 * curve.points().last().map_or(0.0, |p| p.work);
        let least = |dear: bool| {
            let points = curve.points().iter().filter(|p| (p.work > half) == dear);
            points.map(|p| p.error).fold(f64::INFINITY, f64::min)
        };
        let gain = exp2(0.5 * f64::from(self.method.order()));
        let gaining = self.method != Method::Dop853 && gain * least(true) < least(false);
        // A method that has not come below a thousandth has not begun.
        Ok(curve.floor().filter(|p| p.error < 1e-3 && !gaining))
    }

    /// The cheapest run that delivers the error asked for, not by luck alone.
    pub fn least(&self, asked: f64) -> Option<&Run> {
        let least = self.attitude.least_work(asked)?;
        (self.sweep.runs().iter()).find(|run| {
            evaluations(&run.work) as f64 == least.work && run.errors.attitude == least.error
        })
    }
}

/// A motion with all methods that apply to it.
pub struct Measured {
    pub motion: Motion,
    /// The condition of the start, and the largest on the path with its time.
    pub start_condition: f64,
    pub path_condition: (f64, f64),
    pub lines: Vec<Line>,
}

/// A disturbance so small that nothing bends, and so large that round-off is small in it.
pub const SIZE: f64 = 1e-11;

/// All of them.
pub fn all(p: &Parameters) -> Result<Vec<Measured>> {
    (motions::all(p.moments()?, p.periods)?.into_iter())
        .map(Measured::new)
        .collect()
}

impl Measured {
    fn new(motion: Motion) -> Result<Self> {
        let mut lines = Vec::new();
        for method in Method::ALL {
            let sweep = || motion.problem.sweep(method, &settings(method));
            // Free rotation of three different moments is dear: weak kicks are raced elsewhere.
            let left_out = motion.key == "lopsided"
                && matches!(method, Method::Aba82 | Method::Aba104 | Method::Aba1064);
            if motion.problem.applies(method) && !left_out {
                lines.push(Line::new(method, sweep())?);
            } else if method == Method::Strang && ["free", "flips"].contains(&motion.key) {
                let flow = |steps: f64| motion.problem.run(method, steps);
                let coarse = settings(Method::SemiImplicitEuler);
                let sweep = over(&motion, &coarse, flow);
                lines.push(Line::new(method, sweep)?.called(FLOW, "exact flow"));
            }
            if let (Method::Aba1064, Some(angles)) = (method, &motion.angles) {
                let in_angles = |tolerance: f64| angles.run(tolerance, motion.end);
                let sweep = over(&motion, &settings(Method::Dop853), in_angles);
                let line = Line::new(Method::Dop853, sweep)?;
                lines.push(line.called("angles", "DOP853 on angles"));
            }
        }
        Ok(Self {
            start_condition: motion.condition(0.0, SIZE)?,
            path_condition: motion.path_condition(SIZE)?,
            motion,
            lines,
        })
    }

    /// The methods that can be compared.
    pub fn contestants(&self) -> impl Iterator<Item = &Line> {
        self.lines.iter().filter(|line| line.key != FLOW)
    }

    /// The line of a method, by its key.
    pub fn line(&self, key: &str) -> Option<&Line> {
        self.lines.iter().find(|line| line.key == key)
    }
}

fn over(
    motion: &Motion,
    settings: &[f64],
    run: impl Fn(f64) -> rotation_dynamics::Result<(rotation_dynamics::body::State, Work)>,
) -> Sweep {
    Sweep::over(settings.iter().copied(), |setting| {
        let (reached, work) = run(setting)?;
        Ok::<(Errors, Work), Error>((motion.problem.errors(&reached), work))
    })
}

/// Every run as a line of numbers.
pub fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let mut rows = Trajectory::new([
        "problem",
        "method",
        "evaluations",
        "attitude [rad]",
        "rates",
        "momentum",
        "energy",
        "invariants",
    ])?;
    for (i, measured) in super::prepared(p)?.iter().enumerate() {
        for line in &measured.lines {
            let method = Method::ALL.iter().position(|m| *m == line.method);
            for run in line.sweep.runs() {
                let numbers = [
                    (i + 1) as f64,
                    method.map_or(0.0, |m| (m + 1) as f64),
                    evaluations(&run.work) as f64,
                ];
                let errors = Measure::ALL.map(|m| run.errors.get(m));
                rows.push([numbers.as_slice(), &errors].concat())?;
            }
        }
    }
    Ok(rows)
}

/// One digit and a power of ten, whatever the number; `-` for none.
pub fn power(x: Option<f64>) -> String {
    x.map_or("-".into(), rounded_up)
}
