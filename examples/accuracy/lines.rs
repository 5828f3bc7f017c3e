//! Every method on every motion, coarser and finer.

use super::*;
use kit::Result;
use motions::{Motion, Names};
use rotation_dynamics::accuracy::{Point, Run};

/// A method on a motion.
pub struct Line {
    pub method: Method,
    pub key: &'static str,
    pub name: &'static str,
    pub sweep: Sweep,
    /// Error of the attitude against evaluations: of the derivative or the kick, each with one
    /// torque.
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
fn settings(method: Method) -> Vec<f64> {
    if method == Method::Dop853 {
        return (3..=45).map(|k| pow(10.0, -f64::from(k) / 3.0)).collect();
    }
    // The error falls by a factor of about 4 from one to the next.
    let finer = 2.0 / f64::from(method.order().max(4));
    let to = if method.order() == 1 { TO_FOILS } else { TO };
    let evaluations = (0..=((to - FROM) / finer) as u32).map(|k| exp2(FROM + finer * f64::from(k)));
    let steps = evaluations.map(|count| (count / in_a_step(method)).floor());
    let mut settings: Vec<f64> = steps.filter(|n| *n >= 1.0).collect();
    settings.dedup();
    settings
}

impl Line {
    /// A method's runs, under its own key and name or under others.
    fn new(method: Method, (key, name): Names, sweep: Sweep) -> Result<Self> {
        let attitude = sweep.curve(Measure::Attitude, Work::torques)?;
        Ok(Self { method, key, name, sweep, attitude })
    }

    /// The floor, if the method has come to it: the last doubling of the work gained less
    /// than half the digits that the order promises.
    pub fn reached(&self, measure: Measure) -> Result<Option<Point>> {
        let curve = self.sweep.curve(measure, Work::torques)?;
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
            run.work.torques() as f64 == least.work && run.errors.attitude == least.error
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
    (motions::all(p)?.into_iter()).map(Measured::new).collect()
}

/// The one with this key.
pub fn of<'m>(all: &'m [Measured], key: &str) -> Option<&'m Measured> {
    all.iter().find(|measured| measured.motion.key == key)
}

impl Measured {
    fn new(motion: Motion) -> Result<Self> {
        let mut lines = Vec::new();
        for method in Method::ALL {
            let run = |setting| motion.problem.run(method, setting);
            // Free rotation of three different moments is dear: weak kicks are raced elsewhere.
            let left_out = motion.key == "lopsided"
                && matches!(method, Method::Aba82 | Method::Aba104 | Method::Aba1064);
            if motion.problem.applies(method) && !left_out {
                let (names, settings) = ((method.key(), method.name()), settings(method));
                lines.push(Line::new(method, names, motion.sweep(settings, run))?);
            } else if method == Method::Strang && ["free", "flips"].contains(&motion.key) {
                let sweep = motion.sweep(settings(Method::SemiImplicitEuler), run);
                lines.push(Line::new(method, (FLOW, "exact flow"), sweep)?);
            }
            if let (Method::Aba1064, Some(in_angles)) = (method, &motion.in_angles) {
                let sweep = motion.sweep(settings(Method::Dop853), in_angles);
                let names = ("angles", "DOP853 on angles");
                lines.push(Line::new(Method::Dop853, names, sweep)?);
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

    /// The least that a contestant has, of those that have any, and its name.
    pub fn best(&self, of: impl Fn(&Line) -> Option<f64>) -> Option<(f64, &'static str)> {
        let those = self.contestants();
        let all = those.filter_map(|line| Some((of(line)?, line.name)));
        all.min_by(|a, b| a.0.total_cmp(&b.0))
    }

    /// The contestant that delivers this error with the fewest evaluations, and how many.
    pub fn first(&self, error: f64) -> Option<(f64, &'static str)> {
        self.best(|line| Some(line.attitude.least_work(error)?.work))
    }

    /// The line of a method, by its key.
    pub fn line(&self, key: &str) -> Option<&Line> {
        self.lines.iter().find(|line| line.key == key)
    }
}

/// Every run as a line of numbers.
pub fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let columns =
        "problem, method, evaluations, attitude [rad], rates, momentum, energy, invariants";
    let mut rows = Trajectory::new(columns.split(", "))?;
    for (motion, measured) in (1..).zip(super::prepared(p)?.iter()) {
        for line in &measured.lines {
            // Its place in the list of methods.
            let method = 1 + line.method as u8;
            for run in line.sweep.runs() {
                let numbers = [f64::from(motion), method.into(), run.work.torques() as f64];
                let errors = Measure::ALL.map(|measure| run.errors.get(measure));
                rows.push([&numbers[..], &errors].concat())?;
            }
        }
    }
    Ok(rows)
}
