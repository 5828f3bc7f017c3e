//! What is there picks the method: a scene of each kind, what `solve` chose, and what others
//! would have paid.

use super::Parameters;
use super::desk::{Spinner, UP, gyroscope};
use kit::{Result, Table};
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::{
    DiscDrag, Effect, GravityAtLever, GravityGradient, InternalDissipation, PrescribedTorque,
    Profile, ViscousFriction,
};
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::{Dop853, Integrator, Resisted, Scheme, Splitting, Work};
use rotation_dynamics::math::pow;
use rotation_dynamics::scene::Scene;

/// The error for which prices are compared, rad.
pub const PRICED: f64 = 1e-6;

/// Evaluations for an error of [`PRICED`].
pub struct Paid {
    pub kind: &'static str,
    pub scene: &'static str,
    pub chosen: &'static str,
    pub run: Work,
    pub dop853: Option<u64>,
    pub split: Option<u64>,
}

impl Paid {
    fn of<E: Effect>(
        [kind, name]: [&'static str; 2],
        scene: &Scene<E>,
        start: &State,
        end: f64,
    ) -> Result<Self> {
        let solved = scene.solve(start, end, PRICED)?;
        let exact = scene.solve(start, end, 1e-8)?.state.attitude;
        let dop853 = least(&exact, |level| {
            let method = Dop853::new(1e-3 * pow(10.0, -0.25 * level))?;
            Ok(method.advance(scene, 0.0, start, end)?)
        });
        let split = if E::PROPERTIES.torque_free || Resisted::new(scene, 0.0).is_err() {
            None
        } else {
            least(&exact, |level| {
                split(scene, start, end, 10.0 * pow(1.15, level))
            })
        };
        Ok(Self {
            kind,
            scene: name,
            chosen: solved.method,
            run: solved.run,
            dop853,
            split,
        })
    }
}

// ANCHOR: split
/// So many steps of a splitting with the resistance in its kick, cut where dry
/// friction stops the spin.
fn split<E: Effect>(
    scene: &Scene<E>,
    start: &State,
    end: f64,
    steps: f64,
) -> Result<(State, Work)> {
    let mut times = scene.effects().break_points();
    times.retain(|t| 0.0 < *t && *t < end);
    times.push(end);
    let (mut from, mut state, mut all) = (0.0, *start, Work::default());
    for to in times {
        let steps = (steps * (to - from) / end) as u64 + 1;
        let method = Splitting::new(Scheme::SRKN14, steps)?;
        let problem = Resisted::new(scene, from)?;
        let (reached, work) = method.advance(&problem, from, &state, to)?;
        (from, state, all) = (to, reached, all + work);
    }
    Ok((state, all))
}
// ANCHOR_END: split

/// The evaluations of the coarsest run from which on two in a row are near enough.
fn least(exact: &Attitude, run: impl Fn(f64) -> Result<(State, Work)>) -> Option<u64> {
    let mut before: Option<u64> = None;
    for level in 0..56 {
        let Ok((end, work)) = run(f64::from(level)) else {
            before = None;
            continue;
        };
        if end.attitude.angle_to(exact) > PRICED {
            before = None;
        } else if before.is_some() {
            return before;
        } else {
            before = Some(work.torques());
        }
    }
    None
}

/// A scene of each kind.
pub fn all(p: &Parameters) -> Result<Vec<Paid>> {
    let rotor = gyroscope(p);
    let (top, start) = rotor.scene()?;
    let brick = RigidBody::new(PrincipalMoments::new(1.0, 1.5, 0.8)?);
    let tossed = brick.state(Attitude::IDENTITY, BodyVector::new(0.3, 0.1, 2.0))?;
    let weight = GravityAtLever::new(1.0, 0.4)?;
    // The same axle in oil, and the vertical pivot too.
    let oil = ViscousFriction::new(2e-5, 2e-6)?;
    let slow = Spinner {
        spin: 60.0,
        bearing: 2e-2,
        ..rotor
    };
    let (stopped, slowly) = slow.scene()?;
    let thruster = Profile::steps(&[(2.0, 1.0), (5.0, -1.0), (8.0, 0.0)])?;
    let thruster = PrescribedTorque::on_body(BodyVector::new(0.02, 0.0, 0.0), thruster)?;
    let orbit = GravityGradient::on_orbit(0.05, UP, SpaceVector::new(1.0, 0.0, 0.0))?;
    let drag = DiscDrag::new(
        0.06,
        DiscDrag::AIR_DENSITY,
        DiscDrag::AIR_VISCOSITY,
        rotor.spin,
    )?;
    Ok(vec![
        Paid::of(["nothing", "a brick"], &Scene::new(brick), &tossed, 20.0)?,
        Paid::of(["keeps the energy", "the gyroscope"], &top, &start, 10.0)?,
        Paid::of(
            ["keeps the energy", "a heavy brick"],
            &Scene::new(brick).with(weight),
            &tossed,
            20.0,
        )?,
        Paid::of(
            ["resists, weakly", "the gyroscope in oil"],
            &top.with(oil),
            &start,
            10.0,
        )?,
        Paid::of(
            ["resists, weakly", "the gyroscope in air"],
            &top.with(drag),
            &start,
            10.0,
        )?,
        Paid::of(
            ["resists, to the stop", "the gyroscope, dry and slow"],
            &stopped.with(slow.dry()?),
            &slowly,
            5.0,
        )?,
        Paid::of(
            ["loses energy inside", "a brick that creaks"],
            &Scene::new(brick).with(InternalDissipation::new(0.02)?),
            &tossed,
            20.0,
        )?,
        Paid::of(
            ["goes with the time", "a brick on an orbit"],
            &Scene::new(brick).with(orbit),
            &tossed,
            20.0,
        )?,
        Paid::of(
            ["jumps", "a brick with a thruster"],
            &Scene::new(brick).with(thruster),
            &tossed,
            20.0,
        )?,
    ])
}

/// As a table.
pub fn table(all: &[Paid]) -> Result<Table> {
    let columns = [
        "what acts",
        "scene",
        "solve chose",
        "evaluations",
        "DOP853",
        "SRKN 14a",
    ];
    let mut table = Table::new("methods", columns)?;
    for paid in all {
        let told = |work: Option<u64>| work.map_or("-".to_owned(), |n| n.to_string());
        let run = match paid.run.torques() {
            0 => "-".to_owned(),
            n => n.to_string(),
        };
        table.push([
            paid.kind.to_owned(),
            paid.scene.to_owned(),
            paid.chosen.to_owned(),
            run,
            told(paid.dop853),
            told(paid.split),
        ])?;
    }
    Ok(table)
}
