//! Long-time drift: how the errors of phase and invariants grow with the number of
//! periods, averaged over several starts.
//!
//! Rounding moves an invariant in a random walk, by t^(1/2), and the phase with the
//! integral of that walk, by t^(3/2): Brouwer's law. A method that loses energy steadily
//! has t in the invariants and t^2 in the phase. Projected onto what the motion keeps,
//! the invariants stay where they are and the phase is off by t at most.
//!
//! For a figure: [`curves`] gives, for every method, the root mean square over the starts
//! at times that grow geometrically, and [`Curve::exponent`] the fitted powers. The
//! default, 4 starts and 10 000 periods, takes a second; a million periods by 8 starts are
//! in `benches/record/drift.txt` (tables `top`, `free`, `top_powers`,
//! `free_powers`).

use rotation_dynamics::Result;
use rotation_dynamics::accuracy::{Errors, Resolution, Stepper, Variables};
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::GravityAtLever;
use rotation_dynamics::exact::free_body::FreeBody;
use rotation_dynamics::exact::heavy_top::{HeavyTop, SymmetricTop};
use rotation_dynamics::frame::BodyVector;
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::gauss_legendre::FreeRotation;
use rotation_dynamics::integrators::{
    GaussLegendre, Integrator, Method as Named, Projected, SpinFree,
};
use rotation_dynamics::math::{log, pow};
use rotation_dynamics::scene::Scene;

/// What moves.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// A heavy top that nods and precesses; I1 = 1, I3 = 1.9, m g l = 0.2.
    Top,
    /// A tumbling body, I = 1, 2, 8/3.
    Free,
}

pub type Gravity = ((), GravityAtLever);

/// One start, with its exact motion and the period of nods or of the rates.
pub enum Subject {
    Top { scene: Scene<Gravity>, start: State, exact: Box<HeavyTop> },
    Free { scene: Scene<()>, start: State, exact: Box<FreeBody> },
}

impl Subject {
    /// Start number `n`.
    pub fn new(kind: Kind, n: usize) -> Result<Self> {
        let shift = n as f64;
        match kind {
            Kind::Top => {
                let angles = EulerAngles { phi: 0.0, theta: 0.4 + 0.1 * shift, zeta: 0.0 };
                let rates = BodyVector::new(0.1, 0.3, 0.7);
                let body = RigidBody::new(PrincipalMoments::symmetric(1.0, 1.9)?);
                let scene = Scene::new(body).with(GravityAtLever::new(0.2, 1.0)?);
                let start = body.state(Attitude::from_euler(angles)?, rates)?;
                let top = SymmetricTop::new(1.0, 1.9, 0.2, 1.0)?;
                let exact = Box::new(HeavyTop::from_body(top, angles, rates)?);
                Ok(Self::Top { scene, start, exact })
            }
            Kind::Free => {
                let moments = PrincipalMoments::new(1.0, 2.0, 8.0 / 3.0)?;
                let rates = BodyVector::new(0.8 + 0.02 * shift, 0.4, 0.34);
                let scene = Scene::new(RigidBody::new(moments));
                let start = scene.body().state(Attitude::IDENTITY, rates)?;
                let exact = Box::new(FreeBody::new(moments, Attitude::IDENTITY, rates)?);
                Ok(Self::Free { scene, start, exact })
            }
        }
    }

    pub fn period(&self) -> f64 {
        match self {
            Self::Top { exact, .. } => exact.nutation_period(),
            Self::Free { exact, .. } => exact.rate_period(),
        }
    }

    pub fn start(&self) -> &State {
        match self {
            Self::Top { start, .. } | Self::Free { start, .. } => start,
        }
    }

    /// Phase: the angle between the attitudes; invariants: energy and momenta against
    /// those of the start.
    pub fn errors(&self, state: &State, t: f64) -> (f64, f64) {
        let (attitude, kept) = match self {
            Self::Top { scene, start, exact } => {
                (exact.attitude(t), Errors::between(scene, state, start))
            }
            Self::Free { scene, start, exact } => {
                (exact.attitude(t), Errors::between(scene, state, start))
            }
        };
        (state.attitude.angle_to(&attitude), kept.invariants)
    }
}

/// A method, with steps enough for its truncation to be small or, for the last two, to be
/// seen.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Method {
    /// Gauss-Legendre 16.
    Gauss,
    /// The same, projected onto the invariants every 1000 steps.
    GaussProjected,
    /// SRKN 14a; the top only.
    Splitting,
    /// Runge-Kutta 4.
    Rk4,
    /// DOP853, tolerance 1e-10.
    Dop853,
}

impl Method {
    pub const ALL: [Self; 5] =
        [Self::Gauss, Self::GaussProjected, Self::Splitting, Self::Rk4, Self::Dop853];

    /// For keys, and for people.
    pub const fn names(self) -> (&'static str, &'static str) {
        match self {
            Self::Gauss => ("gauss", Named::GaussLegendre16.name()),
            Self::GaussProjected => ("gauss_projected", "Gauss-Legendre 16, projected"),
            Self::Splitting => ("srkn14", Named::Srkn14.name()),
            Self::Rk4 => ("rk4", Named::Rk4.name()),
            Self::Dop853 => ("dop853", Named::Dop853.name()),
        }
    }

    pub fn applies_to(self, kind: Kind) -> bool {
        self != Self::Splitting || kind == Kind::Top
    }

    /// The most periods for which it is worth running: the others are lost before.
    pub const fn most_periods(self) -> f64 {
        match self {
            Self::Gauss | Self::GaussProjected | Self::Splitting => 1e6,
            Self::Rk4 | Self::Dop853 => 1e4,
        }
    }

    /// The state at `to` from that at `from`, in the variables that suit the method.
    pub fn carried(self, subject: &Subject, from: f64, state: &State, to: f64) -> Result<State> {
        // Periods of the top are shorter, in its own time, than those of the free body.
        let denser = if matches!(subject, Subject::Top { .. }) { 1.0 } else { 2.0 };
        let periods = (to - from) / subject.period();
        let steps = |per_period: f64| (periods * (denser * per_period)).round().max(1.0) as u64;
        let (method, resolution) = match self {
            Self::GaussProjected => {
                let blocks = steps(6.0).div_ceil(1000);
                let each = GaussLegendre::new(steps(6.0).div_ceil(blocks))?;
                let method = Projected::new(each, blocks)?;
                return Ok(match subject {
                    Subject::Top { scene, .. } => {
                        method.advance(&SpinFree::new(scene)?, from, state, to)?.0
                    }
                    Subject::Free { scene, .. } => {
                        method.advance(&FreeRotation::new(scene), from, state, to)?.0
                    }
                });
            }
            Self::Gauss => (Named::GaussLegendre16, Resolution::Steps(steps(6.0))),
            Self::Splitting => (Named::Srkn14, Resolution::Steps(steps(24.0))),
            Self::Rk4 => (Named::Rk4, Resolution::Steps(steps(150.0))),
            Self::Dop853 => (Named::Dop853, Resolution::Tolerance(1e-10)),
        };
        let (stepper, span) = (Stepper::new(method, resolution)?, [from, to]);
        Ok(match subject {
            Subject::Top { scene, .. } => {
                stepper.advance(scene, Variables::best(method, scene), span, state)?.0
            }
            Subject::Free { scene, .. } => {
                stepper.advance(scene, Variables::best(method, scene), span, state)?.0
            }
        })
    }
}

/// Errors after some periods: root mean squares over the starts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Point {
    pub periods: f64,
    /// The angle between the attitudes (rad).
    pub phase: f64,
    /// The largest of energy and momenta, relative.
    pub invariants: f64,
}

/// How the errors of a method grow.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    pub method: Method,
    pub kind: Kind,
    pub points: Vec<Point>,
}

/// Whole numbers of periods, four to a decade, from 10 on.
pub fn times(most: f64) -> Vec<f64> {
    (4..)
        .map(|k| pow(10.0, f64::from(k) / 4.0).round())
        .take_while(|periods| *periods <= most)
        .collect()
}

/// The curve of one method: `starts` starts over up to `periods` periods.
pub fn curve(method: Method, kind: Kind, starts: usize, periods: f64) -> Result<Curve> {
    let times = times(periods.min(method.most_periods()));
    let mut squares = vec![[0.0; 2]; times.len()];
    for n in 0..starts {
        let subject = Subject::new(kind, n)?;
        let (mut state, mut t) = (*subject.start(), 0.0);
        for (sum, periods) in squares.iter_mut().zip(&times) {
            let to = periods * subject.period();
            state = method.carried(&subject, t, &state, to)?;
            t = to;
            let (phase, invariants) = subject.errors(&state, t);
            sum[0] += phase * phase;
            sum[1] += invariants * invariants;
        }
    }
    let points = times.iter().zip(squares).map(|(periods, sum)| {
        let [phase, invariants] = sum.map(|square| (square / starts as f64).sqrt());
        Point { periods: *periods, phase, invariants }
    });
    Ok(Curve { method, kind, points: points.collect() })
}

/// The curves of all methods that apply.
pub fn curves(kind: Kind, starts: usize, periods: f64) -> Result<Vec<Curve>> {
    Method::ALL
        .into_iter()
        .filter(|method| method.applies_to(kind))
        .map(|method| curve(method, kind, starts, periods))
        .collect()
}

impl Curve {
    /// The power of t with which an error grows from `from` periods on: the least-squares
    /// slope on logarithmic axes.
    pub fn exponent(&self, from: f64, error: impl Fn(&Point) -> f64) -> f64 {
        self.exponent_between(from, f64::INFINITY, error)
    }

    /// The same between two numbers of periods, both included.
    pub fn exponent_between(&self, from: f64, to: f64, error: impl Fn(&Point) -> f64) -> f64 {
        let logs: Vec<(f64, f64)> = self
            .points
            .iter()
            .filter(|point| (from..=to).contains(&point.periods))
            .map(|point| (log(point.periods), log(error(point))))
            .collect();
        let count = logs.len() as f64;
        let x0: f64 = logs.iter().map(|(x, _)| x / count).sum();
        let y0: f64 = logs.iter().map(|(_, y)| y / count).sum();
        let across: f64 = logs.iter().map(|(x, y)| (x - x0) * (y - y0)).sum();
        let along: f64 = logs.iter().map(|(x, _)| (x - x0) * (x - x0)).sum();
        across / along
    }
}
