//! The same attack where the torque has kinks, cusps and jumps that nothing names: at times, where the
//! it looks for them, and at attitudes, where it cannot.

use super::hostile::{along, solver};
use super::truth::{Switched, switched};
use super::{Case, Dice};
use rotation_dynamics::Result;
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::Torque;
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::gauss_legendre::coefficients::{NODES, WEIGHTS};
use rotation_dynamics::math::{exp, pow, sin};
use std::f64::consts::PI;

/// As many kinds.
pub const KINDS: u64 = 6;

/// The n-th scene; the kinds come in turn.
pub fn case(n: u64) -> Result<Case> {
    let mut dice = Dice(n + 3_000_000);
    dice.part();
    match n % KINDS {
        0 => powers("cusps in time", &mut dice, 0.5),
        1 => powers("kinks in time", &mut dice, 1.0),
        2 => powers("3/2 in time", &mut dice, 1.5),
        3 => wave("triangles in time", &mut dice, |u| (u - 2.0 * (0.5 * u).round()).abs() - 0.5),
        4 => at_an_attitude(&mut dice, true),
        _ => at_an_attitude(&mut dice, false),
    }
}

/// The n-th scene with as many cusps.
pub fn dozens(n: u64) -> Result<Case> {
    let mut dice = Dice(n + 4_000_000);
    dice.part();
    wave("dozens of cusps", &mut dice, |u| sin(PI * u).abs().sqrt())
}

/// One to six times at which p has such a power of the distance to them.
fn powers(kind: &'static str, dice: &mut Dice, power: f64) -> Result<Case> {
    let t_end = dice.scale(1.0, 20.0);
    let count = 1 + (dice.part() * 6.0) as usize;
    let times: Vec<f64> = (0..count).map(|_| t_end * dice.between(0.02, 0.98)).collect();
    let sizes: Vec<f64> = (0..count).map(|_| dice.between(-3.0, 3.0) / t_end).collect();
    let at = times.clone();
    let p = move |t: f64| -> f64 {
        let one = |(at, size): (&f64, &f64)| size * pow((t - at).abs() / t_end, power);
        at.iter().zip(&sizes).map(one).sum()
    };
    scene(kind, dice, t_end, times, p)
}

/// A wave with 2 to 60 kinks, where its argument is a whole number.
fn wave(
    kind: &'static str,
    dice: &mut Dice,
    shape: impl Fn(f64) -> f64 + Clone + Send + Sync + 'static,
) -> Result<Case> {
    let t_end = dice.scale(1.0, 20.0);
    let (count, early) = (dice.scale(2.0, 60.0), dice.part());
    let size = dice.between(-3.0, 3.0) / t_end;
    let times = (1..=count as usize + 1)
        .map(|n| (n as f64 - early) * t_end / count)
        .filter(|t| *t < t_end)
        .collect();
    let p = move |t: f64| size * shape(count * t / t_end + early);
    scene(kind, dice, t_end, times, p)
}

/// The torque p(t) L, whose p is smooth between these times.
fn scene(
    kind: &'static str,
    dice: &mut Dice,
    t_end: f64,
    mut times: Vec<f64>,
    p: impl Fn(f64) -> f64 + Clone + Send + Sync + 'static,
) -> Result<Case> {
    times.sort_by(f64::total_cmp);
    let text = format!("{times:?}");
    let torque = {
        let p = p.clone();
        Torque::on_space("kinked", move |t, _body: &RigidBody, state: &State| {
            state.angular_momentum * p(t)
        })
    };
    let inner = move |t: f64| {
        let ends = times.iter().copied().chain([t]);
        let (mut from, mut grown, mut sum) = (0.0, 0.0, 0.0);
        for to in ends {
            let (more, time) = between([from, to], &p);
            sum += exp(grown) * time;
            (from, grown) = (to, grown + more);
        }
        sum
    };
    along(kind, dice, inner, t_end, solver(torque, t_end), text)
}

/// The integrals of p and of its exponential over a piece at whose ends p may have a root: with
/// t = s^2 (3 - 2 s) it has none.
fn between([from, to]: [f64; 2], p: &impl Fn(f64) -> f64) -> (f64, f64) {
    const PIECES: usize = 64;
    let h = 1.0 / PIECES as f64;
    let slope = |s: f64| 6.0 * s * (1.0 - s) * (to - from);
    let at = |s: f64| from + (to - from) * s * s * (3.0 - 2.0 * s);
    let growth = |s: f64, length: f64| -> f64 {
        let one = |(c, b): (&f64, &f64)| b * length * p(at(s + c * length)) * slope(s + c * length);
        NODES.iter().zip(&WEIGHTS).map(one).sum()
    };
    let (mut grown, mut sum) = (0.0, 0.0);
    for piece in 0..PIECES {
        let s = piece as f64 * h;
        for (c, b) in NODES.iter().zip(&WEIGHTS) {
            sum += b * h * slope(s + c * h) * exp(grown + growth(s, c * h));
        }
        grown += growth(s, h);
    }
    (grown, sum)
}

/// A torque like gravity's whose size has a kink, or jumps, where the axis passes one tilt.
fn at_an_attitude(dice: &mut Dice, kink: bool) -> Result<Case> {
    let moments = if dice.part() < 0.5 {
        PrincipalMoments::symmetric(1.0, dice.between(0.2, 1.8))?
    } else {
        dice.moments()?
    };
    let body = RigidBody::new(moments);
    let rates = dice.vector() * dice.scale(0.3, 3.0);
    let start = body.state(Attitude::from_euler(dice.attitude())?, rates)?;
    let weight = body.kinetic_energy(&start) * dice.scale(0.1, 10.0);
    let [below, above] = [0; 2].map(|_| weight * dice.between(-1.0, 1.0));
    let value = weight * dice.between(-1.0, 1.0);
    let torque = Switched {
        at: dice.between(-0.8, 0.8),
        sides: if kink { [[value, below], [value, above]] } else { [[below, 0.0], [above, 0.0]] },
    };
    let fastest = (body.kinetic_energy(&start) + weight).sqrt();
    let least = moments.to_array().into_iter().fold(f64::INFINITY, f64::min);
    let t_end = dice.scale(3.0, 30.0) / (fastest / least.sqrt());
    let effect = Torque::on_body("switched", move |_t, _body: &RigidBody, state: &State| {
        let vertical = state.attitude.to_body(SpaceVector::new(0.0, 0.0, 1.0));
        BodyVector::new(vertical.y(), -vertical.x(), 0.0) * torque.moment(vertical.z())
    });
    let solve = solver(effect, t_end);
    Ok(Case {
        kind: if kink { "kink in space" } else { "jump in space" },
        text: format!("{moments:?} {torque:?} {start:?} {t_end}"),
        exact: switched(&body, &torque, &start, t_end),
        solve: Box::new(move |tolerance| solve(&body, &start, tolerance)),
    })
}
