//! Every method on every problem, coarser and finer.

use super::Parameters;
use super::methods::{Dial, FLOW, METHODS, Method};
use super::problems::{self, Problem};
use rotation_dynamics::accuracy::{Measure, Point, Run, Sweep, WorkPrecision};
use rotation_dynamics::integrators::Work;
use rotation_dynamics::math::exp2;
use rotation_dynamics::report::Trajectory;
use rotation_dynamics::{Error, Result};
use std::sync::Arc;

/// A method on a problem.
pub struct Line {
    pub method: &'static Method,
    pub sweep: Sweep,
    /// Error of the attitude against evaluations.
    pub attitude: WorkPrecision,
}

impl Line {
    /// The floor, if the method has come to it: the last doubling of the work gained less
    /// than half the digits that the order promises.
    pub fn reached(&self, measure: Measure) -> Result<Option<Point>> {
        let curve = self.sweep.curve(measure, evaluations)?;
        let half = 0.5 * curve.points().last().map_or(0.0, |p| p.work);
        let least = |dear: bool| {
            let points = curve.points().iter().filter(|p| (p.work > half) == dear);
            points.map(|p| p.error).fold(f64::INFINITY, f64::min)
        };
        let gain = exp2(0.5 * f64::from(self.method.order));
        let gaining =
            matches!(self.method.dial, Dial::Steps(_)) && gain * least(true) < least(false);
        // A method that has not come below a thousandth has not begun.
        let floor = curve.floor().filter(|p| p.error < 1e-3 && !gaining);
        Ok(floor)
    }

    /// The cheapest run that delivers the error asked for, not by luck alone.
    pub fn least(&self, asked: f64) -> Option<&Run> {
        let least = self.attitude.least_work(asked)?;
        (self.sweep.runs().iter()).find(|run| {
            evaluations(&run.work) as f64 == least.work && run.errors.attitude == least.error
        })
    }
}

/// A problem with all methods that apply to it.
pub struct Measured {
    pub problem: Arc<Problem>,
    /// The condition of the start, and the largest on the path with its time.
    pub start_condition: f64,
    pub path_condition: (f64, f64),
    pub lines: Vec<Line>,
}

/// A disturbance so small that nothing bends, and so large that round-off is small in it.
pub const SIZE: f64 = 1e-11;

/// What is counted: evaluations of the derivative or the kick, each with one torque.
pub fn evaluations(work: &Work) -> u64 {
    work.torques()
}

/// All of them.
pub fn all(p: &Parameters) -> Result<Vec<Measured>> {
    if !(1.0..=1000.0).contains(&p.periods) {
        return Err(Error::OutOfRange {
            name: "periods",
            value: p.periods,
            allowed: "from 1 to 1000",
        });
    }
    (problems::all(p.moments()?, p.periods)?.into_iter())
        .map(Measured::new)
        .collect()
}

impl Measured {
    fn new(problem: Problem) -> Result<Self> {
        let mut lines = Vec::new();
        for method in METHODS {
            let Some(sweep) = method.sweep(&problem) else {
                continue;
            };
            let attitude = sweep.curve(Measure::Attitude, evaluations)?;
            lines.push(Line {
                method,
                sweep,
                attitude,
            });
        }
        Ok(Self {
            start_condition: problem.condition(0.0, SIZE)?,
            path_condition: problem.path_condition(SIZE)?,
            problem: Arc::new(problem),
            lines,
        })
    }

    /// The methods that can be compared.
    pub fn contestants(&self) -> impl Iterator<Item = &Line> {
        self.lines.iter().filter(|line| line.method.key != FLOW)
    }

    /// The line of a method, by its key.
    pub fn line(&self, key: &str) -> Option<&Line> {
        self.lines.iter().find(|line| line.method.key == key)
    }
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
    for (i, measured) in all(p)?.iter().enumerate() {
        for line in &measured.lines {
            let method = METHODS.iter().position(|m| m.key == line.method.key);
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
