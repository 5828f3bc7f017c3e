//! Scenes of eleven kinds, each with its end and the cheapest runs as hindsight knows them.

use crate::ladder::{Motion, Way, cheapest};
use benches::attack::truth::{self, Law, Resisting};
use benches::honesty::Dice;
use rotation_dynamics::Result;
use rotation_dynamics::accuracy::{Resolution, Solved, Variables};
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::{
    CoulombBearing, DiscDrag, Effect, FlowRegime, GravityAtLever, Torque, ViscousFriction,
};
use rotation_dynamics::exact::free_body::FreeBody;
use rotation_dynamics::exact::heavy_top::{HeavyTop, SymmetricTop};
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::Method;
use rotation_dynamics::math::{cos, exp, expm1};
use rotation_dynamics::scene::Scene;

use core::f64::consts::TAU;

/// A scene, what `solve` makes of it, its true end, and what hindsight would have taken.
pub struct Case {
    pub kind: &'static str,
    pub solve: Box<dyn Fn(f64) -> Result<Solved>>,
    /// None if two routes to the end do not agree.
    pub exact: Option<Attitude>,
    /// The cost of the cheapest run that errs by a tolerance at most: of all methods, and of
    /// that with this name; by the time its torques take, in units of one of the method named, or
    /// by their number.
    pub least: Box<Least>,
}

/// What the cheapest run of a tolerance costs, of all methods and of the one with this name.
pub type Least = dyn Fn(f64, &str, Counted) -> [Option<f64>; 2];

/// How the cost of a run is counted.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Counted {
    Time,
    Torques,
}

pub const KINDS: [&str; 11] = [
    "heavy, three moments",
    "top, stepped",
    "free, stepped",
    "long",
    "in oil",
    "in air",
    "dry, to the stop",
    "driven, resonant",
    "own drag",
    "jumps",
    "air, three moments",
];

/// The n-th scene of a kind.
pub fn case(kind: usize, n: u64) -> Result<Case> {
    let mut dice = Dice(10_000 * (kind as u64 + 400) + n);
    dice.part();
    match kind {
        0 => heavy(&mut dice),
        1 => top(&mut dice),
        2 => free(2, dice.scale(1.0, 30.0), &mut dice),
        3 => free(3, dice.scale(30.0, 300.0), &mut dice),
        4 => in_oil(&mut dice),
        5 => in_air(&mut dice),
        6 => to_the_stop(&mut dice),
        7 => driven(&mut dice),
        8 => own_drag(&mut dice),
        9 => jumps(&mut dice),
        _ => in_air_tumbling(&mut dice),
    }
}

/// The end by the fine runs of two methods, if they agree.
fn by_two_routes(motion: &Motion, turned: f64) -> Result<Option<Attitude>> {
    let steps = Resolution::Steps((2.0 * turned).ceil() as u64 + 8);
    let (exact, _) = motion.run(motion.gauss(), steps)?;
    let adaptive = Way::Plain(Method::Dop853, Variables::Space);
    let (other, _) = motion.run(adaptive, Resolution::Tolerance(1e-15))?;
    Ok((exact.angle_to(&other) < 1e-10).then_some(exact))
}

fn known<E: Effect + Clone + 'static>(
    kind: usize,
    scene: Scene<E>,
    start: State,
    t_end: f64,
    exact: Option<Attitude>,
) -> Result<Case> {
    let mut times = vec![0.0];
    let breaks = scene.effects().break_points();
    times.extend(breaks.into_iter().filter(|t| 0.0 < *t && *t < t_end));
    times.push(t_end);
    let body = *scene.body();
    let [i1, i2, i3] = body.moments().to_array();
    let torque = scene.effects().torque_scale(0.0, &body, &start);
    let energy = body.kinetic_energy(&start);
    let turned = ((2.0 * energy + 4.0 * torque) / i1.min(i2).min(i3)).sqrt() * t_end;
    let motion = Motion { body, effects: Box::new(scene.effects().clone()), start, times };
    let exact = match exact {
        None => by_two_routes(&motion, turned)?,
        exact => exact,
    };
    Ok(Case {
        kind: KINDS[kind],
        solve: Box::new(move |tolerance| scene.solve_by_stepping(&start, t_end, tolerance)),
        exact,
        least: Box::new(move |tolerance, name, counted| match exact {
            Some(exact) => least(&motion, turned, &exact, tolerance, name, counted),
            None => [None; 2],
        }),
    })
}

/// What the cheapest run costs, of all methods and of the one with this name.
fn least(
    motion: &Motion,
    turned: f64,
    exact: &Attitude,
    tolerance: f64,
    name: &str,
    counted: Counted,
) -> [Option<f64>; 2] {
    let mut best: [Option<f64>; 2] = [None; 2];
    let mut unit = f64::NAN;
    let mut all = motion.ways();
    all.sort_by_key(|way| way.name() != name);
    for way in all {
        // What `solve` chose is known to the end, the others after it while they may win.
        let chosen = way.name() == name;
        let most = if chosen { f64::INFINITY } else { best[0].unwrap_or(f64::INFINITY) };
        let weight = match counted {
            Counted::Time => way.weight(motion),
            Counted::Torques => 1.0,
        };
        if chosen {
            unit = weight;
        }
        let found = cheapest(way, turned, tolerance, most, |resolution| {
            let (end, torques) = motion.run(way, resolution).ok()?;
            Some((exact.angle_to(&end), weight * torques as f64))
        });
        if let Some(found) = found {
            best[0] = Some(best[0].map_or(found, |least| least.min(found)));
            if chosen {
                best[1] = Some(found);
            }
        }
    }
    best.map(|cost| cost.map(|cost| cost / unit))
}

/// Three different moments and a weight on e3, from a light one to one that rules.
fn heavy(dice: &mut Dice) -> Result<Case> {
    let body = RigidBody::new(dice.moments()?);
    let rates = dice.vector() * dice.scale(0.3, 3.0);
    let start = body.state(Attitude::from_euler(dice.attitude())?, rates)?;
    let moment = body.kinetic_energy(&start) * dice.scale(0.03, 3.0);
    let gravity = GravityAtLever::new(moment, 1.0)?;
    let t_end = dice.scale(1.0, 30.0) * TAU / rates.norm();
    known(0, Scene::new(body).with(gravity), start, t_end, None)
}

/// A symmetric body, its weight and its start, for some turns of its axis.
fn throw(dice: &mut Dice) -> Result<(RigidBody, GravityAtLever, State, f64)> {
    let (i1, i3) = (1.0, dice.scale(0.05, 1.9));
    let body = RigidBody::new(PrincipalMoments::symmetric(i1, i3)?);
    let gravity = GravityAtLever::new(dice.scale(1e-2, 2.0), dice.between(0.3, 1.0))?;
    let small = dice.vector() * 0.5;
    let rates = BodyVector::new(small.x(), small.y(), dice.scale(0.3, 30.0) / i3);
    let start = body.state(Attitude::from_euler(dice.attitude())?, rates)?;
    let turning = start.angular_momentum.norm() / i1 + gravity.moment().sqrt();
    Ok((body, gravity, start, turning))
}

fn top(dice: &mut Dice) -> Result<Case> {
    let (body, gravity, start, turning) = throw(dice)?;
    let t_end = dice.scale(1.0, 30.0) * TAU / turning;
    let (i1, i3) = (body.moments().i1(), body.moments().i3());
    let top = SymmetricTop::new(i1, i3, gravity.weight(), gravity.lever())?;
    let motion =
        HeavyTop::from_body(top, start.attitude.euler_angles(), body.angular_velocity(&start))?;
    let exact = motion.attitude(t_end);
    known(1, Scene::new(body).with(gravity), start, t_end, Some(exact))
}

fn free(kind: usize, turns: f64, dice: &mut Dice) -> Result<Case> {
    let moments = dice.moments()?;
    let rates = dice.vector() * dice.scale(0.3, 3.0);
    let attitude = Attitude::from_euler(dice.attitude())?;
    let t_end = turns * TAU / rates.norm();
    let scene = Scene::new(RigidBody::new(moments));
    let start = scene.body().state(attitude, rates)?;
    let exact = FreeBody::new(moments, attitude, rates)?.attitude(t_end);
    known(kind, scene, start, t_end, Some(exact))
}

/// Viscous friction; the loss of L over the whole time from 1e-4 to e^-10.
fn in_oil(dice: &mut Dice) -> Result<Case> {
    let (body, gravity, start, turning) = throw(dice)?;
    let t_end = dice.scale(1.0, 15.0) * TAU / turning;
    let [across, along] = [0; 2].map(|_| dice.scale(1e-4, 10.0) / t_end);
    let friction = ViscousFriction::new(across * body.moments().i1(), along * body.moments().i3())?;
    let resisting = Resisting { rates: [across, across, along], law: Law::None };
    let exact = truth::resisted(&body, gravity.moment(), &resisting, &start, t_end);
    let scene = Scene::new(body).with(gravity).with(friction);
    known(4, scene, start, t_end, Some(exact))
}

/// The drag of the air on a disc, beside oil in the pivot.
fn in_air(dice: &mut Dice) -> Result<Case> {
    let (body, gravity, start, turning) = throw(dice)?;
    let t_end = dice.scale(1.0, 15.0) * TAU / turning;
    let i3 = body.moments().i3();
    let spin = body.angular_velocity(&start).z();
    let (radius, viscosity) = (0.3, dice.scale(1e-7, 1e-3));
    let lost = dice.scale(1e-3, 10.0) / t_end;
    let of_unit = DiscDrag::new(radius, 1.0, viscosity, spin)?.axial_torque(spin);
    let density = lost * i3 * (spin / of_unit).abs();
    let drag = DiscDrag::new(radius, density, viscosity, spin)?;
    let power = match drag.regime() {
        FlowRegime::Laminar => 0.5,
        FlowRegime::Turbulent => 0.8,
    };
    let across = dice.scale(1e-4, 3.0) / t_end;
    let resisting =
        Resisting { rates: [across, across, 0.0], law: Law::Power(-drag.axial_torque(1.0), power) };
    let exact = truth::resisted(&body, gravity.moment(), &resisting, &start, t_end);
    let oil = ViscousFriction::new(across * body.moments().i1(), 0.0)?;
    let scene = Scene::new(body).with(drag).with(gravity).with(oil);
    known(5, scene, start, t_end, Some(exact))
}

/// The drag of the air on the disc of a body with three moments, whose spin goes to and fro: the
/// torque has a kink wherever it passes through 0.
fn in_air_tumbling(dice: &mut Dice) -> Result<Case> {
    let body = RigidBody::new(dice.moments()?);
    let rates = dice.vector() * dice.scale(0.3, 3.0);
    let start = body.state(Attitude::from_euler(dice.attitude())?, rates)?;
    let t_end = dice.scale(1.0, 15.0) * TAU / rates.norm();
    let (radius, spin) = (0.3, rates.norm());
    let viscosity = dice.scale(1e-7, 1e-3);
    let lost = dice.scale(1e-3, 3.0) / t_end;
    let of_unit = DiscDrag::new(radius, 1.0, viscosity, spin)?.axial_torque(spin);
    let density = lost * body.moments().i3() * (spin / of_unit).abs();
    let drag = DiscDrag::new(radius, density, viscosity, spin)?;
    let gravity = GravityAtLever::new(body.kinetic_energy(&start) * dice.scale(0.01, 1.0), 1.0)?;
    let scene = Scene::new(body).with(drag).with(gravity);
    known(10, scene, start, t_end, None)
}

/// Dry friction about the axis, to between a third of the way to the stop and three times beyond.
fn to_the_stop(dice: &mut Dice) -> Result<Case> {
    let (body, gravity, start, turning) = throw(dice)?;
    let t_end = dice.scale(1.0, 15.0) * TAU / turning;
    let torque = body.angular_momentum(&start).z().abs() / t_end * dice.scale(0.3, 3.0);
    let bearing = CoulombBearing::new(torque, &body, &start, 0.0)?;
    let resisting = Resisting { rates: [0.0; 3], law: Law::Dry(torque) };
    let exact = truth::resisted(&body, gravity.moment(), &resisting, &start, t_end);
    let scene = Scene::new(body).with(gravity).with(bearing);
    known(6, scene, start, t_end, Some(exact))
}

/// A top pushed in time at the frequency with which it nods, or any body at that of its turns.
fn driven(dice: &mut Dice) -> Result<Case> {
    let (mut body, gravity, mut start, _) = throw(dice)?;
    if dice.part() < 0.5 {
        body = RigidBody::new(dice.moments()?);
        start = body.state(start.attitude, dice.vector() * dice.scale(0.3, 3.0))?;
    }
    let rate = start.angular_momentum.norm() / body.moments().i1();
    let size = body.kinetic_energy(&start) * dice.scale(1e-3, 0.3);
    let [phase, tilt] = [0; 2].map(|_| dice.between(0.0, TAU));
    let frequency = rate * dice.between(0.9, 1.1);
    let push = Torque::on_space("push", move |t, _: &RigidBody, _: &State| {
        let push = size * cos(frequency * t + phase);
        SpaceVector::new(push * cos(tilt), push, 0.0)
    })
    .smooth();
    let t_end = dice.scale(1.0, 15.0) * TAU / (rate + gravity.moment().sqrt());
    known(7, Scene::new(body).with(gravity).with(push), start, t_end, None)
}

/// A drag of one's own that grows with the square of the rate.
fn own_drag(dice: &mut Dice) -> Result<Case> {
    let body = RigidBody::new(dice.moments()?);
    let rates = dice.vector() * dice.scale(0.3, 3.0);
    let start = body.state(Attitude::from_euler(dice.attitude())?, rates)?;
    let t_end = dice.scale(1.0, 15.0) * TAU / rates.norm();
    let size = dice.scale(1e-3, 3.0) / (t_end * rates.norm()) * body.moments().i1();
    let drag = Torque::on_body("drag", move |_, body: &RigidBody, state: &State| {
        let omega = body.angular_velocity(state);
        omega * (-size * omega.norm())
    })
    .smooth();
    let gravity = GravityAtLever::new(body.kinetic_energy(&start) * dice.scale(0.01, 1.0), 1.0)?;
    known(8, Scene::new(body).with(gravity).with(drag), start, t_end, None)
}

/// A torque p(t) L with p constant between jumps that are named: free, in a time of its own.
fn jumps(dice: &mut Dice) -> Result<Case> {
    let moments = dice.moments()?;
    let rates = dice.vector() * dice.scale(0.3, 3.0);
    let attitude = Attitude::from_euler(dice.attitude())?;
    let body = RigidBody::new(moments);
    let start = body.state(attitude, rates)?;
    let t_end = dice.scale(1.0, 15.0) * TAU / rates.norm();
    let count = 1 + (dice.part() * 4.0) as usize;
    let mut times: Vec<f64> = (0..count).map(|_| t_end * dice.between(0.02, 0.98)).collect();
    times.sort_by(f64::total_cmp);
    let strength: Vec<f64> = (0..=count)
        .map(|n| if n % 2 == 0 { 0.0 } else { dice.between(-2.0, 2.0) / t_end })
        .collect();
    let (mut before, mut grown, mut inner) = (0.0, 0.0, 0.0);
    for (n, p) in strength.iter().enumerate() {
        let dt = times.get(n).copied().unwrap_or(t_end) - before;
        inner += exp(grown) * if *p == 0.0 { dt } else { expm1(p * dt) / p };
        grown += p * dt;
        before += dt;
    }
    let at = times.clone();
    let torque = Torque::on_space("jumps", move |t, _: &RigidBody, state: &State| {
        state.angular_momentum * strength[at.iter().filter(|jump| **jump <= t).count()]
    })
    .smooth()
    .with_break_points(&times)?;
    let exact = FreeBody::new(moments, attitude, rates)?.attitude(inner);
    known(9, Scene::new(body).with(torque), start, t_end, Some(exact))
}
