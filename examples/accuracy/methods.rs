//! The methods, one line each. To add one, add its line.

use super::problems::{Free, Gravity, Kind, Problem, Top};
use rotation_dynamics::Result;
use rotation_dynamics::accuracy::Sweep;
use rotation_dynamics::body::State;
use rotation_dynamics::integrators::foils::{EulerOnAngles, SemiImplicitEuler};
use rotation_dynamics::integrators::gauss_legendre::FreeRotation;
use rotation_dynamics::integrators::{
    Dop853, GaussLegendre, Integrator, MuntheKaas4, Rk4, Scheme, SpinFree, Splitting, Work,
};
use rotation_dynamics::math::{exp2, pow};

/// How a method is made coarser and finer.
#[derive(Debug, Clone, Copy)]
pub enum Dial {
    /// Equal steps, each with about so many evaluations.
    Steps(f64),
    /// A tolerance for each step.
    Tolerance,
}

pub type Outcome = Result<(State, Work)>;

/// A method, as it is run on a free body and on a top; the number is that of the steps,
/// or the tolerance.
pub struct Method {
    /// For the keys of claims.
    pub key: &'static str,
    pub name: &'static str,
    pub order: u32,
    pub dial: Dial,
    pub free: Option<fn(&Run<'_, Free>, f64) -> Outcome>,
    pub top: Option<fn(&Run<'_, Top>, f64) -> Outcome>,
}

/// What a method is given.
pub struct Run<'p, S> {
    scene: &'p S,
    problem: &'p Problem,
}

impl<S> Run<'_, S> {
    fn by<M: Integrator<S, State>>(&self, method: M) -> Outcome {
        method.advance(self.scene, 0.0, &self.problem.start, self.problem.end)
    }
}

impl Run<'_, Free> {
    /// In the body's own momentum.
    fn bodily<M: Integrator<FreeRotation, State>>(&self, method: M) -> Outcome {
        let rotation = FreeRotation::new(self.scene);
        method.advance(&rotation, 0.0, &self.problem.start, self.problem.end)
    }
}

impl<'p> Run<'p, Top> {
    /// With the spin taken out.
    fn spinless<M>(&self, method: M) -> Outcome
    where
        M: Integrator<SpinFree<'p, Gravity>, State>,
    {
        let problem = SpinFree::new(self.scene)?;
        method.advance(&problem, 0.0, &self.problem.start, self.problem.end)
    }

    /// In the Euler angles.
    fn in_angles<M: Integrator<super::problems::Angles, [f64; 4]>>(&self, method: M) -> Outcome {
        let Some((equations, start)) = self.problem.in_angles() else {
            return Ok((self.problem.start, Work::default()));
        };
        let (end, work) = method.advance(&equations, 0.0, &start, self.problem.end)?;
        Ok((equations.state(self.scene, &end)?, work))
    }
}

fn split<S>(run: &Run<'_, S>, scheme: Scheme, n: f64) -> Outcome
where
    Splitting: Integrator<S, State>,
{
    run.by(Splitting::new(scheme, n as u64)?)
}

/// Without torque a splitting is nothing but its exact flow: no truncation, and the
/// closed form under another name. It competes with nobody.
pub const FLOW: &str = "flow";

// ANCHOR: methods
/// From the simplest to the most accurate.
#[rustfmt::skip]
pub const METHODS: &[Method] = &[
    Method { key: "euler", name: "Euler on angles", order: 1, dial: Dial::Steps(1.0),
        free: Some(|p, n| p.by(EulerOnAngles::new(n as u64)?)), top: Some(|p, n| p.by(EulerOnAngles::new(n as u64)?)) },
    Method { key: "semi", name: "semi-implicit Euler", order: 1, dial: Dial::Steps(1.0),
        free: Some(|p, n| p.by(SemiImplicitEuler::new(n as u64)?)), top: Some(|p, n| p.by(SemiImplicitEuler::new(n as u64)?)) },
    Method { key: "rk4", name: "RK4", order: 4, dial: Dial::Steps(4.0),
        free: Some(|p, n| p.by(Rk4::new(n as u64)?)), top: Some(|p, n| p.spinless(Rk4::new(n as u64)?)) },
    Method { key: "mk4", name: "Munthe-Kaas 4", order: 4, dial: Dial::Steps(4.0),
        free: Some(|p, n| p.by(MuntheKaas4::new(n as u64)?)), top: Some(|p, n| p.by(MuntheKaas4::new(n as u64)?)) },
    Method { key: FLOW, name: "exact flow", order: 2, dial: Dial::Steps(1.0),
        free: Some(|p, n| split(p, Scheme::STRANG, n)), top: None },
    Method { key: "strang", name: "Strang", order: 2, dial: Dial::Steps(1.0),
        free: None, top: Some(|p, n| split(p, Scheme::STRANG, n)) },
    Method { key: "srkn6", name: "SRKN 6b", order: 4, dial: Dial::Steps(6.0),
        free: None, top: Some(|p, n| split(p, Scheme::SRKN6, n)) },
    Method { key: "srkn14", name: "SRKN 14a", order: 6, dial: Dial::Steps(14.0),
        free: None, top: Some(|p, n| split(p, Scheme::SRKN14, n)) },
    Method { key: "kl17", name: "Kahan-Li 17b", order: 8, dial: Dial::Steps(17.0),
        free: None, top: Some(|p, n| split(p, Scheme::KAHAN_LI17, n)) },
    Method { key: "aba82", name: "ABA(8,2)", order: 2, dial: Dial::Steps(4.0),
        free: None, top: Some(|p, n| split(p, Scheme::ABA82, n)) },
    Method { key: "aba104", name: "ABA(10,4)", order: 4, dial: Dial::Steps(7.0),
        free: None, top: Some(|p, n| split(p, Scheme::ABA104, n)) },
    Method { key: "aba1064", name: "ABA(10,6,4)", order: 4, dial: Dial::Steps(8.0),
        free: None, top: Some(|p, n| split(p, Scheme::ABA1064, n)) },
    Method { key: "angles", name: "DOP853 on angles", order: 8, dial: Dial::Tolerance,
        free: None, top: Some(|p, tol| p.in_angles(Dop853::new(tol)?)) },
    Method { key: "dop853", name: "DOP853", order: 8, dial: Dial::Tolerance,
        free: Some(|p, tol| p.by(Dop853::new(tol)?)), top: Some(|p, tol| p.spinless(Dop853::new(tol)?)) },
    Method { key: "gauss", name: "Gauss-Legendre 16", order: 16, dial: Dial::Steps(120.0),
        free: Some(|p, n| p.bodily(GaussLegendre::new(n as u64)?)), top: Some(|p, n| p.spinless(GaussLegendre::new(n as u64)?)) },
];
// ANCHOR_END: methods

/// Evaluations that a run may cost, in powers of two: from, to, and to for the foils,
/// which are slow and gain nothing more.
const FROM: f64 = 5.0;
const TO: f64 = 17.0;
const TO_FOILS: f64 = 14.0;

impl Method {
    /// The settings of a sweep, from coarse to fine.
    pub fn settings(&self) -> Vec<f64> {
        match self.dial {
            Dial::Steps(evaluations) => {
                // The error falls by a factor of about 4 from one to the next.
                let finer = 2.0 / f64::from(self.order.max(4));
                let to = if self.order == 1 { TO_FOILS } else { TO };
                let count = (to - FROM) / finer;
                let mut settings: Vec<f64> = (0..=count as u32)
                    .map(|k| (exp2(FROM + finer * f64::from(k)) / evaluations).floor())
                    .filter(|n| *n >= 1.0)
                    .collect();
                settings.dedup();
                settings
            }
            Dial::Tolerance => (3..=45).map(|k| pow(10.0, -f64::from(k) / 3.0)).collect(),
        }
    }

    /// One run, if the method applies to the problem.
    pub fn run(&self, problem: &Problem, setting: f64) -> Option<Outcome> {
        match &problem.kind {
            Kind::Free { scene, .. } => self.free.map(|by| by(&Run { scene, problem }, setting)),
            Kind::Top { scene, .. } => self.top.map(|by| by(&Run { scene, problem }, setting)),
        }
    }

    /// The method, coarser and finer, on a problem that it applies to.
    pub fn sweep(&self, problem: &Problem) -> Option<Sweep> {
        self.sweep_over(problem, self.settings())
    }

    /// The same with these settings.
    pub fn sweep_over(&self, problem: &Problem, settings: Vec<f64>) -> Option<Sweep> {
        let applies = match &problem.kind {
            Kind::Free { .. } => self.free.is_some(),
            Kind::Top { .. } => self.top.is_some(),
        };
        applies.then(|| {
            let run = |setting| {
                let run = self.run(problem, setting);
                let (reached, work) = run.unwrap_or(Ok((problem.start, Work::default())))?;
                Ok((problem.errors(&reached), work))
            };
            Sweep::over(settings, run)
        })
    }
}
