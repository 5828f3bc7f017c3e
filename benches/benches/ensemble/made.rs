//! The bodies of both ensembles, and some of them compared with an integrator.

use crate::BODIES;
use benches::ensemble::drawn;
use benches::record::Outcome;
use kit::{Table, rounded_up, short};
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::body::RigidBody;
use rotation_dynamics::effects::GravityAtLever;
use rotation_dynamics::exact::free_body::FreeBody;
use rotation_dynamics::exact::heavy_top::{HeavyTop, SymmetricTop};
use rotation_dynamics::frame::BodyVector;
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::gauss_legendre::FreeRotation;
use rotation_dynamics::integrators::{GaussLegendre, Integrator, SpinFree};
use rotation_dynamics::math::EPS;
use rotation_dynamics::scene::Scene;

/// Bodies compared with an integrator, of each kind.
const COMPARED: usize = 50;

/// How far each quantity of a body may lie from its nominal value, relatively.
const TOLERANCE: f64 = 0.01;

/// The nominal value, off by up to the tolerance.
fn about(nominal: f64, body: usize, index: usize) -> f64 {
    nominal * (1.0 + TOLERANCE * (2.0 * drawn(body, index) - 1.0))
}

/// What a gyroscope is made of: I1, I3, weight, lever, spin.
pub const GYROSCOPE: [f64; 5] = [5.45e-3, 9.0e-4, 4.9, 0.1, 300.0];
/// The tilt at which all are let go.
const TILT: f64 = 1.0;

pub fn gyroscope([i1, i3, weight, lever, spin]: [f64; 5]) -> rotation_dynamics::Result<HeavyTop> {
    let start = EulerAngles { phi: 0.0, theta: TILT, zeta: 0.0 };
    let body = SymmetricTop::new(i1, i3, weight, lever)?;
    HeavyTop::from_body(body, start, BodyVector::new(0.0, 0.0, spin))
}

/// What a tumbling body is made of: its moments, and its momenta at t = 0.
pub const TUMBLING: [f64; 6] = [1.0, 2.0, 8.0 / 3.0, 0.8, 0.8, 0.9];

pub fn tumbling([i1, i2, i3, l1, l2, l3]: [f64; 6]) -> rotation_dynamics::Result<FreeBody> {
    let rates = BodyVector::new(l1 / i1, l2 / i2, l3 / i3);
    FreeBody::new(PrincipalMoments::new(i1, i2, i3)?, Attitude::IDENTITY, rates)
}

/// The quantities of one body of an ensemble.
pub fn quantities<const N: usize>(nominal: [f64; N], body: usize) -> [f64; N] {
    core::array::from_fn(|index| about(nominal[index], body, index))
}

/// How much the attitude moves per relative change of the quantities, added up (rad).
fn condition<const N: usize>(
    quantities: [f64; N],
    attitude: impl Fn([f64; N]) -> rotation_dynamics::Result<Attitude>,
) -> rotation_dynamics::Result<f64> {
    const STEP: f64 = 1e-8;
    let here = attitude(quantities)?;
    let mut sum = 0.0;
    for index in 0..N {
        let mut moved = quantities;
        moved[index] *= 1.0 + STEP;
        sum += here.angle_to(&attitude(moved)?) / STEP;
    }
    Ok(sum)
}

/// The stepped attitude of a gyroscope.
fn stepped_gyroscope(
    [i1, i3, weight, lever, spin]: [f64; 5],
    t: f64,
    steps: u64,
) -> Outcome<Attitude> {
    let body = RigidBody::new(PrincipalMoments::symmetric(i1, i3)?);
    let scene = Scene::new(body).with(GravityAtLever::new(weight, lever)?);
    let tilted = Attitude::from_euler(EulerAngles { phi: 0.0, theta: TILT, zeta: 0.0 })?;
    let start = body.state(tilted, BodyVector::new(0.0, 0.0, spin))?;
    let (end, _) = GaussLegendre::new(steps)?.advance(&SpinFree::new(&scene)?, 0.0, &start, t)?;
    Ok(end.attitude)
}

/// The stepped attitude of a tumbling body.
fn stepped_tumbling([i1, i2, i3, l1, l2, l3]: [f64; 6], t: f64, steps: u64) -> Outcome<Attitude> {
    let scene = Scene::new(RigidBody::new(PrincipalMoments::new(i1, i2, i3)?));
    let rates = BodyVector::new(l1 / i1, l2 / i2, l3 / i3);
    let start = scene.body().state(Attitude::IDENTITY, rates)?;
    let free = FreeRotation::new(&scene);
    let (end, _) = GaussLegendre::new(steps)?.advance(&free, 0.0, &start, t)?;
    Ok(end.attitude)
}

/// What a difference may be, in eps (1 + condition): 7e-15 (1 + condition). Nearly all of
/// it is the integrator's round-off.
const LARGEST_K: f64 = 64.0;

/// A row of the table of errors; fails if one is larger than allowed.
fn compare(
    kind: &str,
    table: &mut Table,
    case: impl Fn(usize) -> Outcome<(f64, f64)>,
) -> Outcome<()> {
    let (mut largest, mut conditions, mut factor) = (0.0_f64, 0.0_f64, 0.0_f64);
    let mut compared = 0;
    for n in 0..COMPARED {
        let body = n * (BODIES / COMPARED) + n;
        let (error, condition) = case(body)?;
        let bound = LARGEST_K * EPS * (1.0 + condition);
        if error.is_nan() || error > bound {
            Err(format!("{kind} {body}: off by {error:e} rad, and {bound:e} is allowed"))?;
        }
        largest = largest.max(error);
        conditions = conditions.max(condition);
        factor = factor.max(error / (EPS * (1.0 + condition)));
        compared += 1;
    }
    table.push([
        kind.to_owned(),
        compared.to_string(),
        rounded_up(largest),
        short(conditions, 2),
        short(factor, 2),
    ])?;
    Ok(())
}

/// The closed forms of some bodies against Gauss-Legendre runs of a thousand periods.
///
/// # Errors
/// A difference larger than allowed.
pub fn accuracy() -> Outcome<Table> {
    let columns = ["bodies", "compared", "largest error / rad", "largest condition", "largest K"];
    let mut table = Table::new("accuracy", columns)?;
    compare("gyroscopes", &mut table, |body| {
        let made = quantities(GYROSCOPE, body);
        let motion = gyroscope(made)?;
        let t = 1000.0 * motion.nutation_period();
        let error = motion.attitude(t).angle_to(&stepped_gyroscope(made, t, 16_000)?);
        Ok((error, condition(made, |made| Ok(gyroscope(made)?.attitude(t)))?))
    })?;
    compare("tumbling bodies", &mut table, |body| {
        let made = quantities(TUMBLING, body);
        let motion = tumbling(made)?;
        let t = 1000.0 * motion.rate_period();
        let error = motion.attitude(t).angle_to(&stepped_tumbling(made, t, 16_000)?);
        Ok((error, condition(made, |made| Ok(tumbling(made)?.attitude(t)))?))
    })?;
    Ok(table)
}
