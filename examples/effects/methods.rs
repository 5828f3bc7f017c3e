//! What is there picks the method: a scene of each kind, what `solve` chose, and what others
//! would have paid.

use super::*;
use rotation_dynamics::Result;
use rotation_dynamics::effects::{InternalDissipation, PrescribedTorque, Profile, ViscousFriction};
use rotation_dynamics::integrators::{Integrator, Resisted, Scheme, Splitting, Work};

/// The error for which prices are compared, rad.
const PRICED: f64 = 1e-6;

/// What acts, the scene, what `solve` chose, and the evaluations for an error of [`PRICED`]: its
/// own, and those of DOP853 and of a splitting where they come so near.
fn paid<E: Effect>(
    [kind, name]: [&str; 2],
    scene: &Scene<E>,
    start: &State,
    end: f64,
) -> Result<[String; 6]> {
    let solved = scene.solve(start, end, PRICED)?;
    let exact = scene.solve(start, end, 1e-8)?.state.attitude;
    let dop853 = least(&exact, |level| {
        let method = Dop853::new(1e-3 * pow(10.0, -0.25 * level))?;
        method.advance(scene, 0.0, start, end)
    });
    let splits = !E::PROPERTIES.torque_free && Resisted::new(scene, 0.0).is_ok();
    let steps = |level| split(scene, start, end, 10.0 * pow(1.15, level));
    let split = splits.then(|| least(&exact, steps)).flatten();
    let run = Some(solved.run.torques()).filter(|torques| *torques > 0);
    let told = |evaluations: Option<u64>| evaluations.map_or("-".to_owned(), |n| n.to_string());
    let [run, dop853, split] = [run, dop853, split].map(told);
    let [kind, name, chosen] = [kind, name, solved.method].map(str::to_owned);
    Ok([kind, name, chosen, run, dop853, split])
}

// ANCHOR: split
/// So many steps of a splitting with the resistance in its kick, cut where dry
/// friction stops the spin.
fn split(scene: &Scene<impl Effect>, start: &State, end: f64, steps: f64) -> Result<(State, Work)> {
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
    let near = |level: u32| {
        let (end, work) = run(f64::from(level)).ok()?;
        (end.attitude.angle_to(exact) <= PRICED).then(|| work.torques())
    };
    (0..55).find_map(|level| near(level).filter(|_| near(level + 1).is_some()))
}

/// A scene of each kind, with what is paid for it.
pub fn table(p: &Parameters) -> kit::Result<Table> {
    let rotor = gyroscope(p);
    let (top, start) = rotor.scene()?;
    let brick = RigidBody::new(PrincipalMoments::new(1.0, 1.5, 0.8)?);
    let tossed = brick.state(Attitude::IDENTITY, BodyVector::new(0.3, 0.1, 2.0))?;
    let free = Scene::new(brick);
    let weight = GravityAtLever::new(1.0, 0.4)?;
    // The same axle in oil, and the vertical pivot too.
    let oil = ViscousFriction::new(2e-5, 2e-6)?;
    let slow = Spinner { spin: 60.0, bearing: 2e-2, ..rotor };
    let (dry, slowly) = slow.scene()?;
    let dry = dry.with(slow.dry()?);
    let creaks = InternalDissipation::new(0.02)?;
    let thruster = Profile::steps(&[(2.0, 1.0), (5.0, -1.0), (8.0, 0.0)])?;
    let thruster = PrescribedTorque::on_body(BodyVector::new(0.02, 0.0, 0.0), thruster)?;
    let orbit = GravityGradient::on_orbit(0.05, UP, ASIDE)?;
    let columns = "what acts, scene, solve chose, evaluations, DOP853, SRKN 14a";
    let rows = [
        paid(["nothing", "a brick"], &free, &tossed, 20.0)?,
        paid(["keeps the energy", "the gyroscope"], &top, &start, 10.0)?,
        paid(["keeps the energy", "a heavy brick"], &free.with(weight), &tossed, 20.0)?,
        paid(["resists, weakly", "the gyroscope in oil"], &top.with(oil), &start, 10.0)?,
        paid(["resists, weakly", "the gyroscope in air"], &top.with(rotor.air()?), &start, 10.0)?,
        paid(["resists, to the stop", "the gyroscope, dry and slow"], &dry, &slowly, 5.0)?,
        paid(["loses energy inside", "a brick that creaks"], &free.with(creaks), &tossed, 20.0)?,
        paid(["goes with the time", "a brick on an orbit"], &free.with(orbit), &tossed, 20.0)?,
        paid(["jumps", "a brick with a thruster"], &free.with(thruster), &tossed, 20.0)?,
    ];
    Table::of("methods", columns.split(", "), rows, Ok)
}
