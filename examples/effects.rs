//! Only the effects that a scene calls for: which matter, what the absent ones cost, and before
//! which digit a model must be better.

#[path = "effects/desk.rs"]
pub mod desk;
#[path = "effects/digits.rs"]
pub mod digits;
#[path = "effects/figures.rs"]
mod figures;
#[path = "effects/kept.rs"]
pub mod kept;
#[path = "effects/methods.rs"]
pub mod methods;
#[path = "effects/weigh.rs"]
pub mod weigh;

use desk::*;
use digits::Case;
use kit::prelude::*;
use kit::{Prepared, rounded_up, short};
use models::heavy_top::direction;
use rotation_dynamics::accuracy::{Limits, NeglectedEffects, Problem, largest};
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::{Effect, GravityAtLever, GravityGradient};
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::{Dop853, ode, size_or};
use rotation_dynamics::motion::Motion;
use rotation_dynamics::scene::Scene;
use std::sync::Arc;
use weigh::{Question, angle};

parameters! {
    /// A half-kilogram gyroscope on a desk.
    pub struct Parameters {
        /// spin at the start
        spin: number(314.16, "rad/s", any().usually(250.0, 600.0)).open("spin of the rotor", "walks quickly", "walks slowly");
        /// friction torque of the vertical pivot
        pivot: number(1e-4, "N m", from_to(0.0, 3e-4).because("with more friction the axis sinks too far for a linear response"));
        /// time for which the axis is followed
        seconds: number(10.0, "s", from_to(0.1, 20.0).because("a longer motion takes too long to weigh"));
        /// error asked of the direction of the axis
        tolerance: number(1e-3, "rad", from_to(1e-9, 0.1));
    }
}

/// The weight alone.
type Weight = ((), GravityAtLever);

/// The gyroscope's axis for the time asked for.
pub fn question(p: &Parameters) -> Result<Question<Weight>> {
    allowed! {
        "size of the spin": p.spin.abs(), from_to(250.0, 1000.0),
            "a slower one nods too widely for a linear response, a faster one takes too long";
    }?;
    let (scene, start) = gyroscope(p).scene()?;
    Ok(Question::new(scene, start, p.seconds).of_axis())
}

/// The six motions, with the usual gyroscope: computed once, whatever the flags.
pub fn cases() -> Result<Arc<Vec<Case>>> {
    static CASES: Prepared<(), Vec<Case>> = Prepared::new();
    CASES.get(&(), |()| digits::all(&Parameters::default()))
}

/// How far the axis is from where it would be, at most, if this torque acts along it: by the
/// equations of the notes, 16.2 (2) and (3), in theta and phi, with L_z and L_Z as it makes them.
fn by_angles(p: &Parameters, looks: &[f64], torque: impl Fn(f64) -> f64) -> Result<f64> {
    let rotor = gyroscope(p);
    let ([i1, i3], weight) = (rotor.moments, rotor.weight());
    let axis = |strength: f64| {
        let torque = &torque;
        let law = ode(move |_t, &[theta, rate, _, axial, vertical]: &[f64; 5]| {
            let (s, c) = sincos(theta);
            let precession = (vertical - axial * c) / (i1 * s * s);
            let pull = weight * s - precession * s * (axial - i1 * precession * c);
            let brake = strength * torque(axial / i3);
            [rate, pull / i1, precession, brake, brake * c]
        })
        .scaled(size_or([1.0; 5]));
        let (theta, axial) = (rotor.tilt, rotor.momentum());
        let start = [theta, 0.0, 0.0, axial, axial * cos(theta)];
        Dop853::new(1e-12)?.solve(&law, 0.0, &start, p.seconds, &[])
    };
    let (with, without) = (axis(1.0)?, axis(0.0)?);
    Ok(largest(sampled(looks.iter().copied(), |t| {
        Ok(angle([with.at(t)?, without.at(t)?].map(|[theta, _, phi, ..]| direction(theta, phi))))
    })?))
}

/// What leaving an effect out costs, by the linear response and by two simulations.
fn weighed(q: &Question<Weight>, effect: impl Effect) -> Result<(f64, f64)> {
    Ok((q.predicted(&effect)?.predicted, q.simulated(effect, 1e-8)?))
}

fn claims(p: &Parameters, report: &mut Report) -> Result<()> {
    let (rotor, asked) = (gyroscope(p), question(p)?);
    // To second order the prediction is off by about its square.
    // The response is stepped to a hundredth, and over more than 1e4 rad of spin that adds up.
    let stepped = 0.02 * (p.spin.abs() * p.seconds / 1e4).max(1.0);
    let within = |x: f64| stepped * x + 2.0 * x * x + 3e-8;
    let (drag, bearing) = (rotor.air()?, rotor.bearing);
    let air = asked.simulated(drag, 1e-8)?;
    let dry = weighed(&asked, rotor.dry()?)?;
    let pivot = weighed(&asked, rotor.pivot())?;
    let lift = weighed(&asked, rotor.buoyancy())?;
    let room = weighed(&asked, on_the_earth())?;
    let above = weighed(&asked, gradient()?)?;
    let by_air = by_angles(p, &asked.looks(&drag)?, |spin| drag.axial_torque(spin))?;
    let by_dry = by_angles(p, &asked.looks(&rotor.dry()?)?, |spin| -bearing * spin.signum())?;
    claims! { report,
        /// how far the axis is from where it would be without the air, at most
        air: air, "rad", "DOP853 on (2), (3), L_z falling" => by_air, within 1e-7,
        in "The desk":
            1e-9 => "the rotor slows down, and a slower rotor precesses faster",
            0.5 * air => "both the lead and the nods count: look at the whole way";
        /// bearing of the axle, predicted
        bearing: dry.0, "rad", "simulated with it and without" => dry.1, within within(dry.0);
        /// bearing, simulated
        bearing_simulated: dry.1, "rad", "DOP853 on (2), (3), L_z falling" => by_dry, within 1e-7;
        /// pivot, predicted
        pivot: pivot.0, "rad", "simulated with it and without" => pivot.1, within within(pivot.0);
        /// weight of the air that is displaced, predicted
        buoyancy: lift.0, "rad", "simulated with it and without" => lift.1, within within(lift.0);
        /// rotation of the Earth, predicted
        room: room.0, "rad", "simulated with it and without" => room.1, within within(room.0);
        /// gravity is weaker above, predicted
        above: above.0, "rad", "simulated with it and without" => above.1, within within(above.0);
    }
}

/// Where the answer is known without a simulation.
fn limits(p: &Parameters, report: &mut Report) -> Result<()> {
    let q = question(p)?;
    // No pivot, no sag; a room that does not turn, no drift.
    let still = Turning { rate: SpaceVector::zero() };
    let smooth = Spinner { pivot: 0.0, ..gyroscope(p) };
    // A free rotor in a turning room: its axis is left behind by the angle of the room.
    let upright = (q.scene.body()).state(Attitude::IDENTITY, BodyVector::new(0.0, 0.0, p.spin))?;
    let free = Question::new(Scene::new(*q.scene.body()), upright, q.end).of_axis();
    let turning = Turning { rate: ASIDE * 1e-4 };
    let behind = free.predicted(&turning)?.predicted;
    limits! { report,
        /// nothing holds the pivot back
        "a pivot without friction, rad": q.predicted(&smooth.pivot())?.predicted => 0.0, within 1e-12;
        /// the stars go round no more
        "a room that does not turn, rad": q.predicted(&still)?.predicted => 0.0, within 1e-12;
        /// the axis keeps its direction among the stars, and the room turns by rate times time
        "a free rotor in a turning room: angle over rate x time": behind / (1e-4 * q.end) => 1.0, within 1e-4;
    }
}

/// The card: what acts on the desk beside the weight.
fn effects(p: &Parameters, report: &mut Report) -> Result<()> {
    let (rotor, q) = (gyroscope(p), question(p)?);
    let (asked, drag) = (q.asked(p.tolerance)?, rotor.air()?);
    let (l, t, weight) = (rotor.momentum(), q.end, rotor.weight());
    let rate = weight / l;
    let slowed = -drag.axial_torque(p.spin) * t / l;
    let of = "rad, of the axis";
    report.add(vec![
        asked.line("air on the rotor", "torque t / L_z", slowed, &drag, of)?,
        asked.line(
            "bearing of the axle",
            "torque t / L_z",
            rotor.bearing * t / l,
            &rotor.dry()?,
            of,
        )?,
        asked.line(
            "friction of the pivot",
            "torque / m g l",
            rotor.pivot / weight,
            &rotor.pivot(),
            of,
        )?,
        asked.line(
            "weight of the air displaced",
            "rho_air / rho_steel",
            rotor.lifted(),
            &rotor.buoyancy(),
            of,
        )?,
        asked.line("the Earth turns", "Omega_E / (dphi/dt)", EARTH / rate, &on_the_earth(), of)?,
        asked.line(
            "gravity is weaker above",
            "l / R_E",
            rotor.lever / EARTH_RADIUS,
            &gradient()?,
            of,
        )?,
        effect("weight")
            .number("m g l I1 / L_z^2", weight * rotor.moments[0] / (l * l))
            .costs(rate * t, "rad of precession")
            .included(),
    ])
}

fn accuracy(p: &Parameters, report: &mut Report) -> Result<()> {
    let q = question(p)?;
    let motion = q.scene.exact(&q.start)?;
    let problem = Problem::new(q.scene, q.start, q.end, motion.try_state(q.end)?);
    let problem = problem.in_closed_form(move |t| motion.attitude(t));
    report.strip(&problem, &[p.tolerance, 1e-6, 1e-9])
}

/// What the page's tries give, whatever the flags.
fn tries() -> Result<Table> {
    let page = Parameters::default();
    let runs = [
        ("as it is", page.clone()),
        ("--spin 628", page.but(|p| p.spin = 628.0)),
        ("--seconds 1", page.but(|p| p.seconds = 1.0)),
        ("--pivot 0", page.but(|p| p.pivot = 0.0)),
    ];
    let columns = "run, air, bearing, pivot, buoyancy, the Earth turns";
    Table::of("tries", columns.split(", "), runs, |(run, p)| {
        let acting = digits::acting(&question(&p)?, &gyroscope(&p), "bearing")?;
        let told = acting.iter().take(5).map(|(_, (error, _))| format!("{} rad", short(*error, 2)));
        Ok([run.to_owned()].into_iter().chain(told).collect::<Vec<_>>())
    })
}

/// The tables of the page that do not depend on the flags.
fn tables(_: &Parameters, report: &mut Report) -> Result<()> {
    static TABLES: Prepared<(), Vec<Table>> = Prepared::new();
    let tables = TABLES.get(&(), |()| -> Result<_> {
        let methods = methods::table(&Parameters::default())?;
        Ok(vec![tries()?, methods, digits::table(&cases()?)?, kept::table()?])
    })?;
    report.add(tables.to_vec())
}

example! {
    effects: "Only the effects that a scene calls for: a gyroscope on a desk, and before which digit its model must be better";
    "Only the effects that are called for", "a gyroscope on a desk, what acts on it, and what leaving it out costs",
    [claims, limits, effects, accuracy, tables];
    figures::figures, figures::trajectory, figures::moving_picture
}
