//! The cheapest single run as hindsight knows it: every method on a fine ladder of its steps.

use rotation_dynamics::accuracy::{Carrier, Fineness, Variables, applies};
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::{Effect, Nature, Resistance};
use rotation_dynamics::frame::SpaceVector;
use rotation_dynamics::integrators::{Dop853, Integrator, Method, Resisted, Splitting};
use rotation_dynamics::math::{Lane, pow};
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
    /// The name that the dial gives it.
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

    /// What a torque takes, in units of one derivative of DOP853: the times of `Method::cost` in
    /// the dial, by which it chooses.
    pub fn weight<E: Effect>(self, scene: &Scene<E>) -> f64 {
        let symmetric = scene.body().moments().is_symmetric();
        let of = |round: f64, other: f64| if symmetric { round } else { other };
        match self {
            Self::Plain(Method::Dop853, Variables::SpinFree) => 0.62,
            Self::Plain(Method::Dop853, _) => 1.0,
            Self::Plain(Method::GaussLegendre16, Variables::SpinFree) => 0.07,
            Self::Plain(Method::GaussLegendre16, Variables::Body) => {
                if E::NATURE.torque_free {
                    0.09
                } else {
                    0.12
                }
            }
            Self::Plain(Method::GaussLegendre16, _) => 0.84,
            Self::Plain(..) => of(0.57, 1.50),
            Self::Resisted(_) => of(1.2, 2.2),
        }
    }
}

/// The splittings that the dial chooses from.
const SPLITTINGS: [Method; 4] = [
    Method::Srkn6,
    Method::Srkn14,
    Method::Aba104,
    Method::Aba1064,
];

/// All ways that apply to a scene.
pub fn ways<E: Effect>(scene: &Scene<E>) -> Vec<Way> {
    let nature = E::NATURE;
    let symmetric = scene.body().moments().is_symmetric();
    let mut all = vec![Way::Plain(Method::Dop853, Variables::Space)];
    if nature.torque_free {
        all.push(Way::Plain(Method::GaussLegendre16, Variables::Body));
    } else if nature.axis_only {
        let of = |method: &Method| Way::Plain(*method, Variables::Space);
        all.extend(SPLITTINGS.iter().filter(|m| applies::<E>(**m)).map(of));
        if symmetric {
            all.push(Way::Plain(Method::GaussLegendre16, Variables::SpinFree));
            all.push(Way::Plain(Method::Dop853, Variables::SpinFree));
        } else {
            all.push(Way::Plain(Method::GaussLegendre16, Variables::Body));
        }
    } else {
        // On a symmetric body what resists is smooth along the motion.
        let resisted =
            Resisted::new(scene, 0.0).is_ok_and(|r| symmetric || r.resistance().is_linear());
        if nature.smooth || resisted {
            all.push(Way::Plain(Method::GaussLegendre16, Variables::Space));
        }
        if resisted {
            all.extend(SPLITTINGS.map(Way::Resisted));
        }
    }
    all
}

/// An effect on a piece of the time: at a jump, what it is on this side.
#[derive(Clone)]
struct Within<E> {
    effect: E,
    piece: [f64; 2],
}

impl<E> Within<E> {
    fn time(&self, t: f64) -> f64 {
        t.max(self.piece[0].next_up())
            .min(self.piece[1].next_down())
    }
}

impl<E: Effect> Effect for Within<E> {
    const NATURE: Nature = Nature {
        smooth: true,
        ..E::NATURE
    };

    fn name(&self) -> &'static str {
        self.effect.name()
    }

    fn torque(&self, t: f64, body: &RigidBody, state: &State) -> SpaceVector {
        self.effect.torque(self.time(t), body, state)
    }

    fn torques_on_axis<L: Lane>(&self, body: &RigidBody, axis: [L; 3]) -> [L; 3] {
        self.effect.torques_on_axis(body, axis)
    }

    fn resistance(&self, t: f64, body: &RigidBody) -> Option<Resistance> {
        self.effect.resistance(self.time(t), body)
    }

    fn torque_scale(&self, t: f64, body: &RigidBody, state: &State) -> f64 {
        self.effect.torque_scale(t, body, state)
    }
}

/// The attitude at the end and the torques taken, of a run through these times by `fineness`
/// (steps over the whole, or a tolerance).
pub fn run<E: Effect + Clone>(
    scene: &Scene<E>,
    start: &State,
    times: &[f64],
    way: Way,
    fineness: Fineness,
) -> Result<(Attitude, u64)> {
    let whole = times[times.len() - 1] - times[0];
    let (mut state, mut torques) = (*start, 0);
    for piece in times.windows(2) {
        let span = [piece[0], piece[1]];
        let part = |steps: u64| ((steps as f64 * (span[1] - span[0]) / whole).ceil() as u64).max(1);
        let fineness = match fineness {
            Fineness::Steps(steps) => Fineness::Steps(part(steps)),
            Fineness::Stages(steps, precision) => Fineness::Stages(part(steps), precision),
            tolerance => tolerance,
        };
        let carrier = Carrier::new(way.method(), fineness)?;
        let effect = Within {
            effect: scene.effects().clone(),
            piece: span,
        };
        let on_piece = Scene::new(*scene.body()).with(effect);
        let (end, work) = match way {
            Way::Plain(_, variables) if times.len() == 2 => {
                carrier.advance(scene, variables, span, &state)?
            }
            Way::Plain(_, variables) => carrier.advance(&on_piece, variables, span, &state)?,
            Way::Resisted(method) => {
                let Fineness::Steps(steps) = fineness else {
                    return Err(Error::NotDelivered {
                        requested: 0.0,
                        reached: 0.0,
                    });
                };
                let scheme = method.scheme().expect("a splitting");
                let resisted = Resisted::new(&on_piece, span[0])?;
                Splitting::new(scheme, steps)?.advance(&resisted, span[0], &state, span[1])?
            }
        };
        state = end;
        torques += work.torques();
    }
    Ok((state.attitude, torques))
}

/// The cost of the cheapest run of a way whose error is `tolerance` at most on this rung and
/// the next, if it is cheaper than `most`; `error` tells error and cost of a run.
pub fn cheapest(
    way: Way,
    turned: f64,
    tolerance: f64,
    most: f64,
    mut error: impl FnMut(Fineness) -> Option<(f64, f64)>,
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
            let fineness = match way.method() {
                Method::Dop853 => {
                    let local = 0.1 * pow(RUNG, -8.0 * f64::from(rung));
                    if local < Dop853::SMALLEST_TOLERANCE {
                        break;
                    }
                    Fineness::Tolerance(local)
                }
                method => {
                    let steps = (turned / 12.0).max(1.0) * pow(RUNG, f64::from(rung));
                    let steps = steps.ceil() as u64;
                    if steps == last {
                        continue;
                    }
                    last = steps;
                    if method == Method::GaussLegendre16 {
                        Fineness::Stages(steps, part * tolerance)
                    } else {
                        Fineness::Steps(steps)
                    }
                }
            };
            let Some((error, cost)) = error(fineness) else {
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
