//! The same attack where something resists the rotation: in oil, in air, in a dry bearing, from
//! hardly at all to so strongly that all is over at once. The truth shares nothing with the
//! splittings that `solve` then takes.

use super::truth::{Law, Resisting, resisted};
use super::{Case, Dice};
use rotation_dynamics::Result;
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::{
    CoulombBearing, DiscDrag, Effect, FlowRegime, GravityAtLever, ViscousFriction,
};
use rotation_dynamics::exact::free_body::FreeBody;
use rotation_dynamics::frame::BodyVector;
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::math::expm1;
use rotation_dynamics::scene::Scene;
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::rc::Rc;

/// As many kinds.
pub const KINDS: u64 = 6;

/// How often each method was chosen.
pub type Chosen = Rc<RefCell<BTreeMap<&'static str, usize>>>;

/// The n-th scene; the kinds come in turn.
pub fn case(n: u64, chosen: &Chosen) -> Result<Case> {
    let mut dice = Dice(n + 2_000_000);
    dice.part();
    match n % KINDS {
        0 => like_a_clock(&mut dice, chosen),
        1 => in_oil("a top in oil", &mut dice, true, chosen),
        2 => in_oil("a brick in oil", &mut dice, false, chosen),
        3 => backwards(&mut dice, chosen),
        4 => in_air(&mut dice, chosen),
        _ => to_the_stop(&mut dice, chosen),
    }
}

/// A scene whose end is known.
fn known<E: Effect + 'static>(
    kind: &'static str,
    scene: Scene<E>,
    start: State,
    t_end: f64,
    exact: Attitude,
    chosen: &Chosen,
) -> Case {
    let chosen = chosen.clone();
    Case {
        kind,
        text: format!("{:?} {start:?} {t_end}", scene.body().moments()),
        exact,
        solve: Box::new(move |tolerance| {
            let solved = scene.solve(&start, t_end, tolerance)?;
            *chosen.borrow_mut().entry(solved.method).or_default() += 1;
            Ok(solved)
        }),
    }
}

/// A symmetric body, its weight and its start; the rate (1/s) at which its axis turns.
fn top(dice: &mut Dice) -> Result<(RigidBody, GravityAtLever, State, f64)> {
    let (i1, i3) = (1.0, dice.scale(0.05, 1.9));
    let body = RigidBody::new(PrincipalMoments::symmetric(i1, i3)?);
    let gravity = GravityAtLever::new(dice.scale(1e-2, 2.0), dice.between(0.3, 1.0))?;
    let small = dice.vector() * 0.5;
    let spin = dice.scale(0.3, 30.0) / i3;
    let rates = BodyVector::new(small.x(), small.y(), spin);
    let start = body.state(Attitude::from_euler(dice.attitude())?, rates)?;
    let turning = start.angular_momentum.norm() / i1 + gravity.moment().sqrt();
    Ok((body, gravity, start, turning))
}

/// With the same rate in all directions the motion is the free one at another time: long, and
/// down to e^-6 of L.
fn like_a_clock(dice: &mut Dice, chosen: &Chosen) -> Result<Case> {
    let (i1, i3) = (1.0, dice.scale(0.05, 1.9));
    let body = RigidBody::new(PrincipalMoments::symmetric(i1, i3)?);
    let rates = dice.vector() * dice.scale(0.3, 30.0);
    let start = body.state(Attitude::from_euler(dice.attitude())?, rates)?;
    let t_end = dice.scale(3.0, 3000.0) / rates.norm();
    let k = dice.scale(1e-6, 6.0) / t_end;
    let friction = ViscousFriction::new(k * i1, k * i3)?;
    let free = FreeBody::new(body.moments(), start.attitude, body.angular_velocity(&start))?;
    let exact = free.attitude(-expm1(-k * t_end) / k);
    let scene = Scene::new(body).with(friction);
    Ok(known("like a clock", scene, start, t_end, exact, chosen))
}

/// Viscous friction, the loss of L over the whole time from 1e-4 to e^-30.
fn in_oil(kind: &'static str, dice: &mut Dice, symmetric: bool, chosen: &Chosen) -> Result<Case> {
    let (mut body, gravity, mut start, turning) = top(dice)?;
    if !symmetric {
        body = RigidBody::new(dice.moments()?);
        start = body.state(start.attitude, dice.vector() * dice.scale(0.3, 3.0))?;
    }
    let t_end = dice.scale(3.0, 100.0) / turning;
    let [across, along] = [0; 2].map(|_| dice.scale(1e-4, 30.0) / t_end);
    let [i1, i2, i3] = body.moments().to_array();
    let friction = ViscousFriction::new(across * i1, along * i3)?;
    let resisting = Resisting { rates: [across, across * i1 / i2, along], law: Law::None };
    let exact = resisted(&body, gravity.moment(), &resisting, &start, t_end);
    let scene = Scene::new(body).with(gravity).with(friction);
    Ok(known(kind, scene, start, t_end, exact, chosen))
}

/// A top in oil to a time before its start: L grows.
fn backwards(dice: &mut Dice, chosen: &Chosen) -> Result<Case> {
    let (body, gravity, start, turning) = top(dice)?;
    let t_end = -dice.scale(3.0, 60.0) / turning;
    let [across, along] = [0; 2].map(|_| dice.scale(1e-3, 2.0) / -t_end);
    let friction = ViscousFriction::new(across * body.moments().i1(), along * body.moments().i3())?;
    let resisting = Resisting { rates: [across, across, along], law: Law::None };
    let exact = resisted(&body, gravity.moment(), &resisting, &start, t_end);
    let scene = Scene::new(body).with(friction).with(gravity);
    Ok(known("backwards", scene, start, t_end, exact, chosen))
}

/// The drag of the air on a disc, beside oil in the pivot; the loss of spin from 1e-3 to all
/// but a thirtieth.
fn in_air(dice: &mut Dice, chosen: &Chosen) -> Result<Case> {
    let (body, gravity, start, turning) = top(dice)?;
    let t_end = dice.scale(3.0, 60.0) / turning;
    let i3 = body.moments().i3();
    let spin = body.angular_velocity(&start).z();
    // A disc in a fluid that is as dense as it takes.
    let (radius, viscosity) = (0.3, dice.scale(1e-7, 1e-3));
    let lost = dice.scale(1e-3, 30.0) / t_end;
    let of_unit = DiscDrag::new(radius, 1.0, viscosity, spin)?.axial_torque(spin).abs();
    let drag = DiscDrag::new(radius, lost * i3 * spin.abs() / of_unit, viscosity, spin)?;
    let power = match drag.regime() {
        FlowRegime::Laminar => 0.5,
        FlowRegime::Turbulent => 0.8,
    };
    let across = dice.scale(1e-4, 3.0) / t_end;
    let resisting =
        Resisting { rates: [across, across, 0.0], law: Law::Power(-drag.axial_torque(1.0), power) };
    let exact = resisted(&body, gravity.moment(), &resisting, &start, t_end);
    let oil = ViscousFriction::new(across * body.moments().i1(), 0.0)?;
    let scene = Scene::new(body).with(drag).with(gravity).with(oil);
    Ok(known("a top in air", scene, start, t_end, exact, chosen))
}

/// Dry friction about the axis, to between a tenth of the way to the stop and ten times beyond.
fn to_the_stop(dice: &mut Dice, chosen: &Chosen) -> Result<Case> {
    let (body, gravity, start, turning) = top(dice)?;
    let t_end = dice.scale(3.0, 60.0) / turning;
    let torque = body.angular_momentum(&start).z().abs() / t_end * dice.scale(0.1, 10.0);
    let bearing = CoulombBearing::new(torque, &body, &start, 0.0)?;
    let resisting = Resisting { rates: [0.0; 3], law: Law::Dry(torque) };
    let exact = resisted(&body, gravity.moment(), &resisting, &start, t_end);
    let scene = Scene::new(body).with(gravity).with(bearing);
    Ok(known("to the stop", scene, start, t_end, exact, chosen))
}

/// How many were solved by a splitting that takes what resists.
pub fn by_splitting(chosen: &Chosen) -> usize {
    let chosen = chosen.borrow();
    let resisted = |name: &&str| name.ends_with(", resisted");
    (chosen.iter().filter(|(name, _)| resisted(name))).map(|(_, n)| n).sum()
}
