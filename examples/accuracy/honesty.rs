//! Is `solve` honest? Random scenes whose ends are known exactly, solved by stepping
//! alone at one tolerance after the other, and judged.

use rotation_dynamics::accuracy::Solved;
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::{Effect, GravityAtLever, Properties};
use rotation_dynamics::exact::free_body::FreeBody;
use rotation_dynamics::exact::heavy_top::{HeavyTop, SymmetricTop};
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::Work;
use rotation_dynamics::math::{cos, exp, expm1, log, sin, sort_by_number};
use rotation_dynamics::scene::Scene;
use rotation_dynamics::{Error, Result};

use core::f64::consts::{PI, TAU};

/// Tolerances from 1e-3 to 1e-13 (rad).
pub const TOLERANCES: [f64; 11] =
    [1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13];

/// A scene to be solved, and the attitude at its end.
pub struct Case {
    /// What kind of scene it is.
    pub kind: &'static str,
    /// Solves it to a tolerance, by stepping.
    pub solve: Box<dyn Fn(f64) -> Result<Solved>>,
    /// The exact attitude at the end.
    pub exact: Attitude,
}

impl Case {
    fn new<E: Effect + 'static>(
        kind: &'static str,
        scene: Scene<E>,
        start: State,
        t_end: f64,
        exact: Attitude,
    ) -> Self {
        let solve = move |tolerance| scene.solve_by_stepping(&start, t_end, tolerance);
        Self { kind, solve: Box::new(solve), exact }
    }
}

/// Numbers that look random and are the same everywhere (splitmix64, G. L. Steele,
/// D. Lea, C. H. Flood, OOPSLA 2014).
pub struct Dice(pub u64);

impl Dice {
    /// Between 0 and 1.
    pub fn part(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / 9_007_199_254_740_992.0
    }

    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.part()
    }

    /// Between the two, evenly in the logarithm.
    pub fn scale(&mut self, low: f64, high: f64) -> f64 {
        let (low, high) = (log(low), log(high));
        exp(self.between(low, high))
    }

    pub fn vector(&mut self) -> BodyVector {
        BodyVector::from_array([0; 3].map(|_| self.between(-1.0, 1.0)))
    }

    pub fn attitude(&mut self) -> EulerAngles {
        EulerAngles {
            phi: self.between(-PI, PI),
            theta: self.between(0.05, PI - 0.05),
            zeta: self.between(-PI, PI),
        }
    }

    /// Three moments of a body, in the order of the axes: of the extents of a cuboid.
    pub fn moments(&mut self) -> Result<PrincipalMoments> {
        let [a, b, c] = [0; 3].map(|_| self.scale(0.2, 1.0));
        PrincipalMoments::new(b * b + c * c, c * c + a * a, a * a + b * b)
    }
}

/// An effect of one's own: a torque along L whose strength depends on the time, so that
/// L = f(t) L(0). It is damped or driven, and still exact: the body moves as a free one
/// does in the time that f integrates to.
#[derive(Clone, Copy)]
struct Governor {
    /// f = exp(-decay t) + swing sin(t), times a constant.
    decay: f64,
    swing: f64,
}

impl Effect for Governor {
    const PROPERTIES: Properties = Properties { smooth: true, ..Properties::ANYTHING };

    fn name(&self) -> &'static str {
        "governor"
    }

    fn torque(&self, t: f64, _body: &RigidBody, state: &State) -> SpaceVector {
        let f = exp(-self.decay * t) + self.swing * sin(t);
        let slope = -self.decay * exp(-self.decay * t) + self.swing * cos(t);
        state.angular_momentum * (slope / f)
    }
}

impl Governor {
    /// The time in which the free body moves.
    fn inner_time(&self, t: f64) -> f64 {
        let half = sin(0.5 * t);
        -expm1(-self.decay * t) / self.decay + self.swing * 2.0 * half * half
    }
}

/// Kinds of scenes in turn, `count` in all.
pub fn cases(count: u64) -> Result<Vec<Case>> {
    (0..count).map(|n| case(n % KINDS, &mut Dice(n))).collect()
}

/// How many kinds there are.
pub const KINDS: u64 = 12;

fn case(kind: u64, dice: &mut Dice) -> Result<Case> {
    // The first number of neighbouring seeds is not yet apart.
    dice.part();
    let size = dice.scale(0.1, 10.0);
    let [i1, i3] = [1.0, dice.between(0.1, 1.9)].map(|i| i * size);
    let lever = dice.between(0.3, 1.0) * size;
    let angles = dice.attitude();
    let small = dice.vector() * 0.3;
    match kind {
        0..=4 => free(kind, [i1, i3], dice),
        _ => top(kind, [i1, i3], lever, angles, small, dice),
    }
}

/// A free body and its end.
fn free(kind: u64, [i1, i3]: [f64; 2], dice: &mut Dice) -> Result<Case> {
    let (kind, moments, rates) = match kind {
        0 => ("free body", dice.moments()?, dice.vector() * dice.scale(0.1, 10.0)),
        1 => {
            // Near the axis of the middle moment, which is no stable one.
            let moments = PrincipalMoments::new(1.0, dice.between(1.2, 1.8), 2.2)?;
            let [x, _, z] = (dice.vector() * dice.scale(1e-6, 1e-2)).to_array();
            ("near the separatrix", moments, BodyVector::new(x, 1.0, z))
        }
        2 => {
            let thin = dice.scale(1e-3, 1e-1);
            let moments = PrincipalMoments::new(1.0, 1.0 + dice.between(0.0, 0.9) * thin, thin)?;
            let [x, y, z] = dice.vector().to_array();
            ("needle", moments, BodyVector::new(x, y, z / thin))
        }
        3 => ("symmetric free body", PrincipalMoments::symmetric(i1, i3)?, dice.vector()),
        _ => ("own effect", dice.moments()?, dice.vector() * dice.scale(0.3, 3.0)),
    };
    let governed = kind == "own effect";
    let attitude = Attitude::from_euler(dice.attitude())?;
    let scene = Scene::new(RigidBody::new(moments));
    let start = scene.body().state(attitude, rates)?;
    let motion = FreeBody::new(moments, attitude, rates)?;
    let turns = dice.scale(1.0, if governed { 10.0 } else { 30.0 });
    let t_end = turns * TAU / rates.norm();
    if !governed {
        return Ok(Case::new(kind, scene, start, t_end, motion.attitude(t_end)));
    }
    let (decay, swing) = (dice.between(-0.5, 1.0) / t_end, dice.between(0.0, 0.3));
    let governor = Governor { decay, swing };
    let exact = motion.attitude(governor.inner_time(t_end));
    Ok(Case::new(kind, scene.with(governor), start, t_end, exact))
}

/// A heavy top for some turns of its axis, and its end.
fn top(
    kind: u64,
    [i1, mut i3]: [f64; 2],
    mut lever: f64,
    mut angles: EulerAngles,
    small: BodyVector,
    dice: &mut Dice,
) -> Result<Case> {
    let spin = |z: f64| BodyVector::new(small.x(), small.y(), z);
    let (kind, rates) = match kind {
        5 => ("top", spin(dice.between(-3.0, 3.0))),
        6 => ("fast top", spin(dice.scale(10.0, 100.0))),
        7 => ("slow top", spin(dice.between(-0.1, 0.1))),
        8 => {
            // A kick from near the vertical: the axis comes near it again and again.
            angles.theta = dice.scale(1e-8, 1e-2);
            ("near the pole", spin(dice.between(1.0, 5.0)))
        }
        9 => {
            angles.theta = 0.0;
            let critical = 2.0 * (i1 * lever).sqrt() / i3;
            let (kick, spin) = (dice.scale(1e-4, 0.1), critical * dice.between(0.5, 2.0));
            ("upright, kicked", BodyVector::new(kick, 0.0, spin))
        }
        10 => {
            (angles.theta, lever) = (dice.scale(1e-6, 1.0), -lever);
            ("hanging", spin(dice.between(-1.0, 1.0)))
        }
        _ => {
            // A needle spinning fast about its axis.
            i3 = i1 * dice.scale(1e-3, 1e-1);
            ("spinning needle", spin(dice.between(5.0, 20.0) * i1 / i3))
        }
    };
    let weight = dice.scale(0.5, 2.0);
    let moment = (weight * lever).abs();
    let across = rates.x() * rates.x() + rates.y() * rates.y();
    let slow = (moment / i1).sqrt() + across.sqrt() + (i3 * rates.z() / i1).abs();
    let t_end = dice.scale(1.0, 30.0) * TAU / slow;
    let scene = Scene::new(RigidBody::new(PrincipalMoments::symmetric(i1, i3)?))
        .with(GravityAtLever::new(weight, lever)?);
    let start = scene.body().state(Attitude::from_euler(angles)?, rates)?;
    let body = SymmetricTop::new(i1, i3, weight, lever)?;
    let exact = HeavyTop::from_body(body, angles, rates)?.attitude(t_end);
    Ok(Case::new(kind, scene, start, t_end, exact))
}

/// What became of one request.
#[derive(Debug, Clone)]
pub enum Outcome {
    /// Solved: the error delivered (rad), and what `solve` said of itself.
    Delivered { error: f64, solved: Box<Solved> },
    /// Refused: the smallest error that the condition allows.
    Refused { attainable: f64, condition: f64 },
}

/// Solves a case to a tolerance and judges the answer.
///
/// # Errors
/// Those of `solve`, but for a request beyond the condition.
pub fn judge(case: &Case, tolerance: f64) -> Result<Outcome> {
    match (case.solve)(tolerance) {
        Ok(solved) => Ok(Outcome::Delivered {
            error: case.exact.angle_to(&solved.state.attitude),
            solved: Box::new(solved),
        }),
        Err(Error::NotDelivered { best: attainable, condition: Some(condition), .. }) => {
            Ok(Outcome::Refused { attainable, condition })
        }
        Err(other) => Err(other),
    }
}

/// What became of all requests at one tolerance.
#[derive(Debug, Clone)]
pub struct Spread {
    /// The error asked for (rad).
    pub tolerance: f64,
    /// The errors delivered, in units of the request, from the least to the largest.
    pub ratios: Vec<f64>,
    /// The estimates that came with them, in the same units and order of size.
    pub estimates: Vec<f64>,
    /// How many requests were refused as beyond the condition.
    pub refused: usize,
    /// The work of all runs over that of the run returned: the median.
    pub price: f64,
}

impl Spread {
    /// The ratio below which this part of all lie: 0.5 for the median.
    pub fn quantile(&self, part: f64) -> f64 {
        quantile(&self.ratios, part)
    }

    /// The same of the estimates.
    pub fn estimate(&self, part: f64) -> f64 {
        quantile(&self.estimates, part)
    }
}

fn quantile(sorted: &[f64], part: f64) -> f64 {
    let last = sorted.len().saturating_sub(1);
    let at = (part * last as f64).round() as usize;
    sorted.get(at).copied().unwrap_or(0.0)
}

/// Delivered over requested, for every tolerance.
///
/// # Errors
/// Those of [`judge`].
pub fn spreads(cases: &[Case]) -> Result<Vec<Spread>> {
    let spread = |&tolerance: &f64| {
        let [mut ratios, mut estimates, mut prices] = [const { Vec::new() }; 3];
        let mut refused = 0;
        for case in cases {
            match judge(case, tolerance)? {
                Outcome::Delivered { error, solved } => {
                    ratios.push(error / tolerance);
                    estimates.push(solved.estimate / tolerance);
                    let torques = |work: Work| work.torques() as f64;
                    prices.push(torques(solved.work) / torques(solved.run));
                }
                Outcome::Refused { .. } => refused += 1,
            }
        }
        for sorted in [&mut ratios, &mut estimates, &mut prices] {
            sort_by_number(sorted, |x| *x);
        }
        Ok(Spread { tolerance, ratios, estimates, refused, price: quantile(&prices, 0.5) })
    };
    TOLERANCES.iter().map(spread).collect()
}
