//! The cheapest single run as hindsight knows it: every method on a fine ladder of its steps.

use crate::behind::{AnyEffect, Behind};
use rotation_dynamics::accuracy::{Resolution, Stepper, Variables};
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::IntegrableCase;
use rotation_dynamics::integrators::gauss_legendre::{BodyAxes, FreeRotation};
use rotation_dynamics::integrators::{Dop853, Integrator, Method, Resisted, SpinFree, Work};
use rotation_dynamics::math::pow;
use rotation_dynamics::scene::Scene;
use rotation_dynamics::{Error, Result};

/// A rung has so many times the steps of the one before.
const RUNG: f64 = 1.12;

/// A method and what it steps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Way {
    Plain(Method, Variables),
    Resisted(Method),
}

impl Way {
    /// The name that `solve` gives it.
    pub fn name(self) -> String {
        match self {
            Self::Plain(method, Variables::SpinFree) => format!("{}, spin-free", method.name()),
            Self::Plain(method, _) => method.name().to_owned(),
            Self::Resisted(method) => format!("{}, resisted", method.name()),
        }
    }

    fn method(self) -> Method {
        match self {
            Self::Plain(method, _) | Self::Resisted(method) => method,
        }
    }

    /// What a torque takes, in units of one derivative of DOP853: measured, as times of one run of 50
    /// turns after the other, optimised and with AVX-512.
    pub fn weight(self, motion: &Motion) -> f64 {
        let symmetric = motion.is_symmetric();
        let of = |round: f64, other: f64| if symmetric { round } else { other };
        match self {
            Self::Plain(Method::Dop853, Variables::SpinFree) => 0.62,
            Self::Plain(Method::Dop853, _) => 1.0,
            Self::Plain(Method::GaussLegendre16, Variables::SpinFree) => 0.07,
            Self::Plain(Method::GaussLegendre16, Variables::Body) => {
                match motion.effects.integrable_case() {
                    IntegrableCase::Free => 0.09,
                    _ => 0.12,
                }
            }
            Self::Plain(Method::GaussLegendre16, _) => 0.84,
            Self::Plain(..) => of(0.57, 1.50),
            Self::Resisted(_) => of(1.2, 2.2),
        }
    }
}

/// The splittings that `solve` chooses from.
const SPLITTINGS: [Method; 4] = [Method::Srkn6, Method::Srkn14, Method::Aba104, Method::Aba1064];

/// A body, what acts on it, and its way through these times: from the start by the jumps to the end.
pub struct Motion {
    pub body: RigidBody,
    pub effects: Box<dyn AnyEffect>,
    pub start: State,
    pub times: Vec<f64>,
}

impl Motion {
    fn is_symmetric(&self) -> bool {
        self.body.moments().is_symmetric()
    }

    /// What acts, on a piece of the time.
    fn on(&self, piece: [f64; 2]) -> Scene<((), Behind<'_>)> {
        let effects = &*self.effects;
        Scene::new(self.body).with(Behind { effects, piece })
    }

    /// Gauss-Legendre in the variables in which it takes the fewest steps.
    pub fn gauss(&self) -> Way {
        let variables = match self.effects.integrable_case() {
            IntegrableCase::HeavyTop(_) if self.is_symmetric() => Variables::SpinFree,
            IntegrableCase::HeavyTop(_) => Variables::Body,
            _ => Variables::Space,
        };
        Way::Plain(Method::GaussLegendre16, variables)
    }

    /// All ways that apply.
    pub fn ways(&self) -> Vec<Way> {
        let symmetric = self.is_symmetric();
        let mut all = vec![Way::Plain(Method::Dop853, Variables::Space)];
        match self.effects.integrable_case() {
            IntegrableCase::Free => all.push(Way::Plain(Method::GaussLegendre16, Variables::Body)),
            IntegrableCase::HeavyTop(_) => {
                all.extend(SPLITTINGS.map(|method| Way::Plain(method, Variables::Space)));
                all.push(self.gauss());
                if symmetric {
                    all.push(Way::Plain(Method::Dop853, Variables::SpinFree));
                }
            }
            IntegrableCase::None => {
                // On a symmetric body what resists is smooth along the motion.
                let scene = self.on(EVER);
                let resisted = Resisted::new(&scene, 0.0)
                    .is_ok_and(|r| symmetric || r.resistance().is_linear());
                if self.effects.properties().smooth || resisted {
                    all.push(self.gauss());
                }
                if resisted {
                    all.extend(SPLITTINGS.map(Way::Resisted));
                }
            }
        }
        all
    }

    /// The attitude at the end and the torques taken, of a run by `resolution` (steps over the whole,
    /// or a tolerance).
    pub fn run(&self, way: Way, resolution: Resolution) -> Result<(Attitude, u64)> {
        let times = &self.times;
        let whole = times[times.len() - 1] - times[0];
        let (mut state, mut torques) = (self.start, 0);
        for span in times.windows(2) {
            let span = [span[0], span[1]];
            let part =
                |steps: u64| ((steps as f64 * (span[1] - span[0]) / whole).ceil() as u64).max(1);
            let resolution = match resolution {
                Resolution::Steps(steps) => Resolution::Steps(part(steps)),
                Resolution::Stages(steps, precision) => Resolution::Stages(part(steps), precision),
                tolerance => tolerance,
            };
            // At a jump, what acts on this side.
            let piece =
                if times.len() == 2 { EVER } else { [span[0].next_up(), span[1].next_down()] };
            let stepper = Stepper::new(way.method(), resolution)?;
            let (end, work) = self.carried(way, &stepper, &self.on(piece), span, &state)?;
            state = end;
            torques += work.torques();
        }
        Ok((state.attitude, torques))
    }

    fn carried(
        &self,
        way: Way,
        stepper: &Stepper,
        scene: &Scene<((), Behind)>,
        [t, t_end]: [f64; 2],
        start: &State,
    ) -> Result<(State, Work)> {
        match (way, stepper, self.effects.integrable_case()) {
            (Way::Plain(_, Variables::Space), Stepper::Dop853(m), _) => {
                m.advance(scene, t, start, t_end)
            }
            (Way::Plain(_, Variables::Space), Stepper::GaussLegendre(m), _) => {
                m.advance(scene, t, start, t_end)
            }
            (Way::Resisted(_), Stepper::Splitting(m), _) => {
                m.advance(&Resisted::new(scene, t)?, t, start, t_end)
            }
            (_, Stepper::GaussLegendre(m), IntegrableCase::Free) => {
                m.advance(&FreeRotation::new(&Scene::new(self.body)), t, start, t_end)
            }
            (Way::Plain(_, variables), _, IntegrableCase::HeavyTop(gravity)) => {
                let scene = Scene::new(self.body).with(gravity);
                match (stepper, variables) {
                    (Stepper::Splitting(m), Variables::Space) => m.advance(&scene, t, start, t_end),
                    (Stepper::GaussLegendre(m), Variables::Body) => {
                        m.advance(&BodyAxes::new(&scene)?, t, start, t_end)
                    }
                    (Stepper::GaussLegendre(m), Variables::SpinFree) => {
                        m.advance(&SpinFree::new(&scene)?, t, start, t_end)
                    }
                    (Stepper::Dop853(m), Variables::SpinFree) => {
                        m.advance(&SpinFree::new(&scene)?, t, start, t_end)
                    }
                    _ => Err(no_such_way()),
                }
            }
            _ => Err(no_such_way()),
        }
    }
}

/// All times.
const EVER: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];

fn no_such_way() -> Error {
    Error::Incompatible { effects: "effects".into(), reason: "no such way".into() }
}

/// The cost of the cheapest run of a way whose error is `tolerance` at most on this rung and
/// the next, if it is cheaper than `most`; `error` tells error and cost of a run.
pub fn cheapest(
    way: Way,
    turned: f64,
    tolerance: f64,
    most: f64,
    mut error: impl FnMut(Resolution) -> Option<(f64, f64)>,
) -> Option<f64> {
    let precisions: &[f64] = match way.method() {
        Method::GaussLegendre16 => &[1e-2, 1e-4],
        _ => &[1.0],
    };
    let mut best: Option<f64> = None;
    for part in precisions {
        let mut before: Option<f64> = None;
        let mut last = 0;
        for rung in 0..160 {
            let resolution = match way.method() {
                Method::Dop853 => {
                    let local = 0.1 * pow(RUNG, -8.0 * f64::from(rung));
                    if local < Dop853::SMALLEST_TOLERANCE {
                        break;
                    }
                    Resolution::Tolerance(local)
                }
                method => {
                    let steps = (turned / 12.0).max(1.0) * pow(RUNG, f64::from(rung));
                    let steps = steps.ceil() as u64;
                    if steps == last {
                        continue;
                    }
                    last = steps;
                    if method == Method::GaussLegendre16 {
                        Resolution::Stages(steps, part * tolerance)
                    } else {
                        Resolution::Steps(steps)
                    }
                }
            };
            let Some((error, cost)) = error(resolution) else {
                before = None;
                continue;
            };
            if error > tolerance {
                before = None;
                if cost > best.unwrap_or(most) {
                    break;
                }
            } else if let Some(cost) = before {
                best = Some(best.map_or(cost, |b| b.min(cost)));
                break;
            } else {
                before = Some(cost);
            }
        }
    }
    best.filter(|cost| *cost <= most)
}
