//! A time that is none gives no place: NaN and infinite times, and times so late that no digit of
//! the phase is left.

use core::f64::consts::TAU;
use models::by_closures::{Bodies, Flow};
use models::gimbals::{Bearings, GimbalMotion, Gimbals};
use models::ladder::Ladder;
use models::plank::Plank;
use models::tops::{Shape, Throw, Top};
use rotation_dynamics::accuracy::{ExactMotion, Limits};
use rotation_dynamics::attitude::{Arcs, Attitude, Sequence};
use rotation_dynamics::body::{Kinematics, RigidBody, State};
use rotation_dynamics::effects::*;
use rotation_dynamics::exact::free_body::{FreeBodies, FreeBody, FreeFlow};
use rotation_dynamics::exact::heavy_top::{HeavyTop, HeavyTops, ReducedTop, Start, SymmetricTop};
use rotation_dynamics::exact::pendulum::{Pendulum, Suspension};
use rotation_dynamics::fit::{Fit, Flight, Swing, SwingFit};
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::{
    Dop853, GaussLegendre, Integrator, MuntheKaas4, Resisted, Rk4, Scheme, SpinFree, Splitting,
    second_order,
};
use rotation_dynamics::math::{DoubleDouble, EPS};
use rotation_dynamics::motion::Motion;
use rotation_dynamics::planar::contact::{self, Contact};
use rotation_dynamics::planar::{Condition, Next, simulate};
use rotation_dynamics::scene::Scene;
use rotation_dynamics::{Error, Result};
use std::collections::BTreeSet;
use std::path::Path;
use support::{Errors, assert_largest};

/// What is asked: the file and the name of a function of a time, and its numbers.
struct Row<'a> {
    place: &'static str,
    asked: Box<dyn Fn(f64) -> Result<Vec<f64>> + 'a>,
    /// What is known at times of the size 1e300.
    known: Option<Vec<f64>>,
}

fn row<'a>(place: &'static str, asked: impl Fn(f64) -> Result<Vec<f64>> + 'a) -> Row<'a> {
    Row { place, asked: Box::new(asked), known: None }
}

impl Row<'_> {
    fn known(self, numbers: &[f64]) -> Self {
        Self { known: Some(numbers.to_vec()), ..self }
    }

    /// Whether it gives no place at this time.
    fn gives_none(&self, t: f64) -> bool {
        match (self.asked)(t) {
            Err(error) => {
                let text = error.to_string();
                assert!(text.len() < 400, "{}: {text}", self.place);
                true
            }
            Ok(numbers) if t.is_finite() && self.known.is_some() => {
                let known = self.known.as_ref();
                known.is_some_and(|known| {
                    let off = numbers.iter().zip(known).map(|(a, b)| (a - b).abs());
                    numbers.len() == known.len() && off.fold(0.0, f64::max) <= 1e-12
                })
            }
            Ok(numbers) => !numbers.is_empty() && numbers.iter().all(|x| x.is_nan()),
        }
    }
}

fn of_attitude(attitude: Attitude) -> Vec<f64> {
    attitude.quaternion().to_vec()
}

fn of_kinematics(now: Kinematics) -> Vec<f64> {
    [of_attitude(now.attitude), now.angular_velocity.to_array().to_vec()].concat()
}

fn of_state(now: State) -> Vec<f64> {
    [of_attitude(now.attitude), now.angular_momentum.to_array().to_vec()].concat()
}

fn free(moments: [f64; 3], rates: [f64; 3]) -> Result<FreeBody> {
    let [i1, i2, i3] = moments;
    let start = Attitude::from_rotation_vector(SpaceVector::new(0.3, -1.1, 0.7))?;
    let moments = PrincipalMoments::new(i1, i2, i3)?;
    FreeBody::new(moments, start, BodyVector::from_array(rates))
}

/// Tumbling about either axis, beside the separatrix and on it, symmetric, steady.
fn free_bodies() -> Result<Vec<FreeBody>> {
    [
        ([1.0, 2.0, 8.0 / 3.0], [0.8, 0.4, 0.3375]),
        ([8.0 / 3.0, 1.0, 2.0], [0.9, -0.7, -0.1]),
        ([1.0, 2.0, 2.5], [1e-9, 1.3, 2e-9]),
        ([1.0, 2.5, 3.0], [0.75, -0.5, 0.75]),
        ([1.0, 1.0, 1.9], [1.0, 0.5, -0.2]),
        ([1.0, 2.0, 2.5], [0.0, -1.5, 0.0]),
    ]
    .into_iter()
    .map(|(moments, rates)| free(moments, rates))
    .collect()
}

/// In waves, beside the homoclinic motion and on it, asleep.
fn tops() -> Result<Vec<HeavyTop>> {
    let body = SymmetricTop::new(1.0, 0.4, 2.0, 1.0)?;
    Ok(vec![
        HeavyTop::from_angles(ReducedTop::new(2.0, 1.2, 0.2)?, 0.5, 0.1, 0.3, 0.4)?,
        HeavyTop::from_angles(ReducedTop::new(2.0, 1.0001, 1.3)?, 0.02, 0.0, 0.3, 0.4)?,
        HeavyTop::from_energy(ReducedTop::new(2.0, 1.0, 1.25)?, 0.0, Start::ThetaMax, 0.0, 0.0)?,
        HeavyTop::new(body, Attitude::IDENTITY, BodyVector::new(0.0, 0.0, 3.0))?,
    ])
}

/// A pendulum that was recorded.
fn swung() -> Result<SwingFit> {
    let pendulum = &pendulums()?[0];
    let times: Vec<f64> = (0..200).map(|k| 0.05 * f64::from(k)).collect();
    let rates = times.iter().map(|t| Ok(pendulum.at(*t)?.omega)).collect::<Result<Vec<_>>>()?;
    Swing::new(times, rates)?.fit()
}

/// The fit of a flight without noise.
fn fitted() -> Result<Fit> {
    let body = free([1.0, 4.0, 4.8], [0.4, 9.0, 0.5])?;
    let times: Vec<f64> = (0..40).map(|k| 0.02 * f64::from(k)).collect();
    let rates = times.iter().map(|t| body.angular_velocity(*t).to_array().into()).collect();
    Flight::new(times, rates)?.fit(&[])
}

fn pendulums() -> Result<Vec<Pendulum>> {
    let rod = Suspension { moment: 1.0 / 3.0, mass: 1.0, gravity: 9.80665, lever: 0.5 };
    [(1.0, 0.3), (1e-19, 0.0), (0.5, 9.0), (0.0, 0.0)]
        .into_iter()
        .map(|(theta, omega)| Pendulum::new(rod, theta, omega))
        .collect()
}

/// A ball that falls for ever.
const FALLING: Flow<2, ()> = Flow(
    |(), [_, speed]| [*speed, -10.0],
    |()| {
        let rebound = Next::jump((), |[_, v]: &[f64; 2]| [0.0, -v]);
        vec![Condition::gap("height", |y| y[0], rebound)]
    },
    [1.0; 2],
);

/// It slips as time goes by.
struct Swaying;

impl Effect for Swaying {
    const PROPERTIES: Properties = Properties { slips: true, ..Properties::ANYTHING };
    fn name(&self) -> &'static str {
        "swaying"
    }
    fn torque(&self, t: f64, _: &RigidBody, _: &State) -> SpaceVector {
        SpaceVector::new(0.1, 0.2, 0.3) * rotation_dynamics::math::sin(t)
    }
    fn slip(&self, t: f64, _: &RigidBody, _: &State) -> SpaceVector {
        SpaceVector::new(0.1, 0.2, 0.3) * rotation_dynamics::math::sin(t)
    }
}

const NONE: [f64; 5] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e300, -1e300];

/// Asks every row; returns how many answers there were.
fn asked(rows: &[Row], times: &[f64]) -> usize {
    for row in rows {
        assert!((row.asked)(0.25).is_ok(), "{}", row.place);
        let found = (row.asked)(0.25).unwrap_or_default();
        assert!(found.iter().all(|x| x.is_finite()), "{}", row.place);
        for &t in times {
            let answer = (row.asked)(t);
            assert!(row.gives_none(t), "{} at {t}: {answer:?}", row.place);
        }
    }
    rows.len() * times.len()
}

/// The functions of closed forms.
fn closed_forms<'a>(
    bodies: &'a [FreeBody],
    tops: &'a [HeavyTop],
    together: &'a (FreeBodies<'a>, HeavyTops<'a>),
) -> Vec<Row<'a>> {
    let mut rows = Vec::new();
    for body in bodies {
        rows.extend([
            row("exact/free_body/mod.rs attitude", |t| Ok(of_attitude(body.attitude(t)))),
            row("exact/free_body/mod.rs try_attitude", |t| body.try_attitude(t).map(of_attitude)),
            row("exact/free_body/mod.rs angular_velocity", |t| {
                Ok(body.angular_velocity(t).to_array().to_vec())
            }),
            row("exact/free_body/mod.rs kinematics", |t| Ok(of_kinematics(body.kinematics(t)))),
            row("exact/free_body/mod.rs try_kinematics", |t| {
                body.try_kinematics(t).map(of_kinematics)
            }),
            row("exact/free_body/mod.rs state", |t| Ok(of_attitude(body.state(t).attitude))),
            row("exact/free_body/mod.rs try_state", |t| body.try_state(t).map(of_state)),
            row("exact/free_body/mod.rs kinematics_at", |t| {
                let mut states = [Kinematics::REST; 9];
                let times = [0.0, 1.0, 2.0, t, 4.0, 5.0, 6.0, 7.0, t];
                body.kinematics_at(&times, &mut states)?;
                Ok(of_kinematics(states[3]))
            }),
            row("motion.rs try_state", |t| Motion::try_state(body, t).map(of_state)),
            row("motion.rs try_states", |t| Ok(of_state(body.try_states(&[0.0, t])?[1]))),
            row("motion.rs condition", |t| Ok(vec![body.condition(t)?])),
        ]);
    }
    for top in tops {
        rows.extend([
            row("exact/heavy_top/queries.rs angles", |t| {
                let angles = top.angles(t);
                Ok(vec![angles.phi, angles.theta, angles.zeta])
            }),
            row("exact/heavy_top/queries.rs try_angles", |t| {
                let angles = top.try_angles(t)?;
                Ok(vec![angles.phi, angles.theta, angles.zeta])
            }),
            row("exact/heavy_top/queries.rs attitude", |t| Ok(of_attitude(top.attitude(t)))),
            row("exact/heavy_top/queries.rs try_attitude", |t| {
                top.try_attitude(t).map(of_attitude)
            }),
            row("exact/heavy_top/queries.rs cos_theta", |t| Ok(vec![top.cos_theta(t)])),
            row("exact/heavy_top/queries.rs axis", |t| Ok(top.axis(t).to_array().to_vec())),
            row("exact/heavy_top/queries.rs theta_rate", |t| Ok(vec![top.theta_rate(t)])),
            row("exact/heavy_top/queries.rs phi_rate", |t| Ok(vec![top.phi_rate(t)])),
            row("exact/heavy_top/queries.rs zeta_rate", |t| Ok(vec![top.zeta_rate(t)])),
            row("exact/heavy_top/queries.rs angular_velocity", |t| {
                Ok(top.angular_velocity(t).to_array().to_vec())
            }),
            row("exact/heavy_top/queries.rs kinematics", |t| Ok(of_kinematics(top.kinematics(t)))),
            row("exact/heavy_top/queries.rs try_kinematics", |t| {
                top.try_kinematics(t).map(of_kinematics)
            }),
            row("exact/heavy_top/queries.rs state", |t| Ok(of_state(top.state(t)))),
            row("exact/heavy_top/queries.rs try_state", |t| top.try_state(t).map(of_state)),
            row("exact/heavy_top/queries.rs angular_momentum", |t| {
                Ok(top.angular_momentum(t).to_array().to_vec())
            }),
            row("exact/heavy_top/batch.rs kinematics_at", |t| {
                let mut states = [Kinematics::REST; 3];
                top.kinematics_at(&[0.0, t, 1.0], &mut states)?;
                Ok(of_kinematics(states[1]))
            }),
            row("motion.rs try_states", |t| Ok(of_state(top.try_states(&[0.0, t])?[1]))),
            row("motion.rs condition", |t| Ok(vec![top.condition(t)?])),
        ]);
    }
    let (free, heavy) = together;
    rows.extend([
        row("exact/free_body/bodies.rs kinematics", |t| {
            let mut states = vec![Kinematics::REST; free.bodies().len()];
            free.kinematics(t, &mut states)?;
            Ok(states.into_iter().flat_map(of_kinematics).collect())
        }),
        row("exact/heavy_top/tops.rs kinematics", |t| {
            let mut states = vec![Kinematics::REST; heavy.tops().len()];
            heavy.kinematics(t, &mut states)?;
            Ok(states.into_iter().flat_map(of_kinematics).collect())
        }),
    ]);
    rows
}

/// Those of flows, pendulums, ladder and plank.
fn simple_forms() -> Result<Vec<Row<'static>>> {
    let mut rows = Vec::new();
    for moments in [[1.0, 2.0, 2.5], [1.0, 1.0, 1.0]] {
        let [i1, i2, i3] = moments;
        let flow = FreeFlow::new(PrincipalMoments::new(i1, i2, i3)?);
        rows.push(row("exact/free_body/flow.rs turn", move |t| {
            Ok(of_attitude(flow.turn(BodyVector::new(0.8, 0.4, 0.3), t)))
        }));
    }
    for pendulum in pendulums()? {
        let other = pendulum.clone();
        rows.push(row("exact/pendulum.rs at", move |t| {
            pendulum.at(t).map(|now| vec![now.theta, now.omega])
        }));
        rows.push(row("motion.rs condition", move |t| Ok(vec![other.condition(t)?])));
    }
    let (ladder, plank) = (Ladder::new(3.0, 9.8, 0.25)?, Plank::new(1.0, 9.8, 0.01, 0.0)?);
    let other = plank.clone();
    rows.extend([
        row("ladder.rs at", move |t| ladder.at(t).map(|now| vec![now.theta, now.omega])),
        row("plank.rs at", move |t| plank.at(t).map(|now| vec![now.theta, now.omega])),
        row("motion.rs condition", move |t| Ok(vec![ladder.condition(t)?])),
        row("motion.rs condition", move |t| Ok(vec![other.condition(t)?])),
    ]);
    let flow = FreeFlow::new(PrincipalMoments::new(1.0, 2.0, 2.5)?);
    let still = move |t| Ok(of_attitude(flow.turn(BodyVector::zero(), t)));
    let fit = fitted()?;
    rows.push(row("fit/mod.rs rates", {
        let fit = fit.clone();
        move |t| Ok(fit.rates(t)?.to_array().to_vec())
    }));
    rows.push(row("fit/mod.rs attitude", move |t| fit.attitude(t).map(of_attitude)));
    let swing = swung()?;
    rows.push(row("fit/swing/found.rs rate", {
        let swing = swing.clone();
        move |t| Ok(vec![swing.rate(t)?])
    }));
    rows.push(row("fit/swing/found.rs angle", move |t| Ok(vec![swing.angle(t)?])));
    rows.push(row("exact/free_body/flow.rs turn", still).known(&[1.0, 0.0, 0.0, 0.0]));
    // What is at rest is known at all times.
    let rest = free([1.0, 2.0, 2.5], [0.0; 3])?;
    let start = of_kinematics(rest.kinematics(0.0));
    rows.push(
        row("exact/free_body/mod.rs try_kinematics", move |t| {
            rest.try_kinematics(t).map(of_kinematics)
        })
        .known(&start),
    );
    Ok(rows)
}

/// Those of effects.
fn of_effects<'a>(body: &'a RigidBody, state: &'a State) -> Result<Vec<Row<'a>>> {
    let gradient = GravityGradient::on_orbit(
        1.1e-3,
        SpaceVector::new(0.0, 0.0, 1.0),
        SpaceVector::new(1.0, 0.0, 0.0),
    )?;
    let still = GravityGradient::fixed(1.1e-3, SpaceVector::new(1.0, 0.0, 0.0))?;
    let mut rows = vec![
        row("effects/gravity_gradient.rs direction", move |t| {
            Ok(gradient.direction(t).to_array().to_vec())
        }),
        row("effects/gravity_gradient.rs direction", move |t| {
            Ok(still.direction(t).to_array().to_vec())
        })
        .known(&[1.0, 0.0, 0.0]),
    ];
    let closed = |e: f64| KeplerOrbit::about(1.0, 1.0, e);
    let orbits = [
        closed(0.0)?,
        closed(0.3)?,
        closed(0.3)?.turning(1e-3, 0.0)?.oriented(0.1, 0.2, 0.3)?,
        closed(1.0)?.turning(0.0, 1e-3)?,
        closed(2.0)?.turning(1e-3, 1e-3)?,
    ];
    for orbit in orbits {
        let body = OrbitingBody::new(1.0, orbit)?;
        rows.extend([
            row("effects/kepler_orbit.rs place", move |t| Ok(orbit.place(t).to_array().to_vec())),
            row("effects/kepler_orbit.rs velocity", move |t| {
                Ok(orbit.velocity(t).to_array().to_vec())
            }),
            row("effects/orbiting_body.rs pull", move |t| {
                let (direction, strength) = body.pull(t);
                Ok([direction.to_array().to_vec(), vec![strength]].concat())
            }),
        ]);
    }
    // The plane of an orbit that does not turn, and the way out of a hyperbola that does not.
    let (turning, open) = (orbits[2], closed(2.0)?);
    let level = orbits[1];
    let mean = OrbitingBody::new(1.0, turning)?.averaged()?;
    rows.extend([
        row("effects/kepler_orbit.rs normal", move |t| Ok(turning.normal(t).to_array().to_vec())),
        row("effects/orbiting_body.rs pull", move |t| Ok(mean.pull(t).0.to_array().to_vec())),
        row("effects/kepler_orbit.rs normal", move |t| Ok(level.normal(t).to_array().to_vec()))
            .known(&[0.0, 0.0, 1.0]),
        row("effects/kepler_orbit.rs place", move |t| {
            let place = open.place(t);
            Ok(vec![place.x() / place.norm(), (place.y() / place.norm()).abs()])
        })
        .known(&[-0.5, 0.75_f64.sqrt()]),
        row("effects/kepler_orbit.rs velocity", move |t| Ok(vec![open.velocity(t).norm()]))
            .known(&[1.0]),
    ]);
    for profile in [
        Profile::steps(&[(0.0, 2.0), (1.0, 0.0)])?,
        Profile::lines(&[(0.0, 2.0), (1.0, 3.0)])?,
        Profile::cubic(&[(0.0, 2.0), (1.0, 3.0)])?,
        Profile::pulse(0.3, 0.2)?,
    ] {
        let torque = PrescribedTorque::on_space(SpaceVector::new(0.1, 0.2, 0.3), profile.clone())?;
        let scene = Scene::new(*body).with(torque);
        rows.extend([
            row("effects/prescribed.rs at", move |t| Ok(vec![profile.at(t)])).known(&[0.0]),
            row("scene.rs torque", move |t| Ok(scene.torque(t, state).to_array().to_vec()))
                .known(&[0.0; 3]),
        ]);
    }
    let [scene, other, third] = [0; 3].map(|_| Scene::new(*body).with(gradient).with(Swaying));
    rows.extend([
        row("scene.rs energy_at", move |t| Ok(vec![scene.energy_at(t, state)])),
        row("scene.rs power", move |t| Ok(vec![other.power(t, state)])),
        row("scene.rs torque", move |t| Ok(third.torque(t, state).to_array().to_vec())),
    ]);
    Ok(rows)
}

/// Those whose numbers go on growing, or are functions of the one who asks: infinite times are
/// none, 1e300 is one.
fn of_any_size<'a>(body: &'a RigidBody, state: &'a State) -> Result<Vec<Row<'a>>> {
    let round = RigidBody::new(PrincipalMoments::symmetric(1.0, 0.5)?);
    let bearing = CoulombBearing::new(0.1, &round, state, 0.0)?;
    let scene = Scene::new(*body).with(Swaying);
    let braked = Scene::new(round).with(bearing);
    Ok(vec![
        row("effects/coulomb.rs axial_momentum", move |t| Ok(vec![bearing.axial_momentum(t)])),
        row("scene.rs torque", move |t| Ok(braked.torque(t, state).to_array().to_vec())),
        row("scene.rs angular_velocity", move |t| {
            Ok(scene.angular_velocity(t, state).to_array().to_vec())
        }),
        row("integrators/splitting/resisted.rs new", move |t| {
            Resisted::new(&braked, t).map(|_| vec![0.0])
        }),
    ])
}

/// Those of motions that were solved: beside the run there is nothing.
fn of_runs() -> Result<Vec<Row<'static>>> {
    let method = Dop853::new(1e-9)?;
    let spring = second_order(|_, x, _| -x);
    let solution = method.solve(&spring, 0.0, &[1.0, 0.0], 1.0, &[])?;
    let run = simulate(&FALLING, &method, (), [1e3, 0.0], 1.0)?;
    let [a, b, c] = [0; 3].map(|_| {
        let ball = Bodies([2.0], [-20.0], |ball| [Contact::new("floor", ball.q[0], [1.0], 0.0)]);
        contact::motion_within(ball, 1e-9, contact::MechanismState::rest([1e3]), 1.0)
    });
    let (a, b, c) = (a?, b?, c?);
    let shape = Shape::new(0.1, 1e-4, 5e-5, 0.02, 0.005)?;
    let top = Top::new(shape, 9.81)?.simulate(&Throw::spinning(0.3, 150.0), 0.5, 1e-9)?;
    let tops = [top.clone(), top.clone(), top.clone()];
    let [second, third, fourth] = tops;
    let rotor = SymmetricTop::new(5.45e-3, 9.0e-4, 4.9, 0.1)?;
    let gimbals = Gimbals::new(rotor, [1.5e-4, 1.5e-4, 2e-5], 2e-4)?;
    let start = gimbals.released(1.0, 314.0);
    let course = GimbalMotion::new(gimbals, Bearings::SMOOTH, start, None, 0.5, 1e-9)?;
    let (more, most) = (course.clone(), course.clone());
    let given = free([1.0, 2.0, 2.5], [0.8, 0.4, 0.3])?;
    let exact = ExactMotion::new("given", move |t| given.try_state(t));
    let quarter = Attitude::about_space_axis(SpaceVector::new(0.0, 0.0, 1.0), 1.5)?;
    let arcs = Arcs::through(&[(0.0, Attitude::IDENTITY), (1.0, quarter)])?;
    Ok(vec![
        row("integrators/dop853/solution.rs at", move |t| Ok(solution.at(t)?.to_vec())),
        row("planar/run.rs at", move |t| Ok(run.at(t)?.1.to_vec())),
        row("planar/contact/motion.rs at", move |t| Ok(a.at(t)?.q.to_vec())),
        row("planar/contact/motion.rs modes", move |t| b.modes(t).map(|_| vec![0.0])),
        row("planar/contact/motion.rs forces", move |t| Ok(vec![c.forces(t)?[0].normal])),
        row("tops/top_motion.rs phase", move |t| Ok(vec![top.phase(t)?.passed as f64])),
        row("tops/top_motion.rs coordinates", move |t| Ok(second.coordinates(t)?.to_vec())),
        row("tops/top_motion.rs configuration", move |t| {
            Ok(third.configuration(t)?.axis.to_array().to_vec())
        }),
        row("tops/top_motion.rs forces", move |t| Ok(vec![fourth.forces(t)?.1.normal])),
        row("gimbals/motion.rs at", move |t| Ok(course.at(t)?.to_array().to_vec())),
        row("gimbals/motion.rs holds", move |t| more.holds(t).map(|_| vec![0.0])),
        row("gimbals/motion.rs heat", move |t| Ok(most.heat(t)?.to_vec())),
        row("accuracy/error_control/exact_motion.rs at", move |t| exact.at(t).map(of_state)),
        row("attitude/arcs.rs at", move |t| arcs.at(t).map(of_attitude)),
    ])
}

/// Every function of a time, at times that are none.
#[test]
fn a_time_that_is_none_gives_no_place() {
    let body = RigidBody::new(PrincipalMoments::new(1.0, 1.5, 0.8).expect("a body"));
    let tilted = Attitude::from_rotation_vector(SpaceVector::new(0.3, 0.2, 0.1)).expect("finite");
    let state = body.state(tilted, BodyVector::new(0.3, 0.1, 2.0)).expect("a state");
    let (bodies, tops) = (free_bodies().expect("bodies"), tops().expect("tops"));
    let together = (FreeBodies::new(&bodies), HeavyTops::new(&tops));
    let mut rows = closed_forms(&bodies, &tops, &together);
    rows.extend(simple_forms().expect("motions"));
    rows.extend(of_effects(&body, &state).expect("effects"));
    rows.extend(of_runs().expect("runs"));
    let grown = of_any_size(&body, &state).expect("effects");
    assert_eq!((rows.len(), grown.len()), (207, 4));
    assert_eq!(asked(&rows, &NONE), 5 * rows.len());
    assert_eq!(asked(&grown, &NONE[..3]), 12);
    // No function of a time is left out: the sources have these, and some inside.
    let asked: BTreeSet<String> = rows.iter().chain(&grown).map(|row| row.place.into()).collect();
    let mut found = BTreeSet::new();
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    for sources in ["../src", "../book/models/src"] {
        functions_of_a_time(&here.join(sources), "", &mut found);
    }
    let is_inside = |name: &String| INSIDE.iter().any(|inside| name.starts_with(inside));
    let missing: Vec<_> = found.difference(&asked).filter(|name| !is_inside(name)).collect();
    assert!(missing.is_empty(), "not asked: {missing:?}");
    assert!(found.len() > 55, "{}", found.len());
}

/// Where only the library asks, or as the other test does, or for what is no motion.
const INSIDE: [&str; 14] = [
    "effects/law.rs",
    "effects/sampled.rs sampled",
    "accuracy/error_control/along.rs solve_at",
    "accuracy/error_control/stepping.rs",
    "effects/check.rs",
    "effects/closure.rs with_break_points",
    "exact/batch.rs",
    "exact/free_body/hyperbolic.rs",
    "exact/free_body/sample.rs",
    "exact/heavy_top/hyperbolic.rs",
    "exact/heavy_top/motion.rs",
    "exact/heavy_top/sample.rs",
    "heavy_top/",
    "integrators/dop853/segment.rs",
];

/// Collects file and name of every function that takes a time.
fn functions_of_a_time(folder: &Path, name: &str, found: &mut BTreeSet<String>) {
    for entry in std::fs::read_dir(folder).expect("the sources") {
        let path = entry.expect("a file").path();
        let inner = path.file_name().and_then(|name| name.to_str()).expect("a name");
        let file = format!("{name}{inner}");
        if path.is_dir() {
            functions_of_a_time(&path, &format!("{file}/"), found);
        } else if file.ends_with(".rs") {
            let text = std::fs::read_to_string(&path).expect("a source");
            for signature in text.split("pub fn ").skip(1) {
                let Some((head, _)) = signature.split_once(')') else {
                    continue;
                };
                let (called, arguments) = head.split_once('(').unwrap_or((head, ""));
                let times = [" t: f64", " times: &[f64]", " dt: f64"];
                if arguments.contains("self") && times.iter().any(|time| arguments.contains(time)) {
                    let called = called.split('<').next().unwrap_or(called);
                    found.insert(format!("{file} {called}"));
                }
            }
        }
    }
}

/// Runs whose start or end is no time are refused.
#[test]
fn a_run_to_no_time_is_refused() {
    let body = RigidBody::new(PrincipalMoments::symmetric(1.0, 0.5).expect("a body"));
    let gravity = GravityAtLever::new(2.0, 0.4).expect("a weight");
    let scene = Scene::new(body).with(gravity);
    let tilted = Attitude::from_rotation_vector(SpaceVector::new(0.3, 0.2, 0.1)).expect("finite");
    let start = body.state(tilted, BodyVector::new(0.3, 0.1, 2.0)).expect("a state");
    let spring = second_order(|_, x, _| -x);
    let dop = Dop853::new(1e-9).expect("a method");
    let rk = Rk4::new(10).expect("steps");
    let gauss: GaussLegendre = GaussLegendre::new(10).expect("steps");
    let lie = MuntheKaas4::new(10).expect("steps");
    let split = Splitting::new(Scheme::STRANG, 10).expect("steps");
    let spun = SpinFree::new(&scene).expect("symmetric");
    let top = Top::new(Shape::new(0.1, 1e-4, 5e-5, 0.02, 0.005).expect("a shape"), 9.81);
    let top = top.expect("a top");
    let rotor = SymmetricTop::new(5.45e-3, 9.0e-4, 4.9, 0.1).expect("a rotor");
    let gimbals = Gimbals::new(rotor, [1.5e-4, 1.5e-4, 2e-5], 2e-4).expect("gimbals");
    let mut refused = 0;
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let limits = Limits { t_start: bad, ..Limits::default() };
        let ends: [(&str, bool); 16] = [
            ("solve", scene.solve(&start, bad, 1e-6).is_ok()),
            ("solve from", scene.solve_with(&start, 1.0, 1e-6, &limits).is_ok()),
            ("by stepping", scene.solve_by_stepping(&start, bad, 1e-6).is_ok()),
            ("along", scene.solve_along(&start, bad, 1e-6, &Limits::default()).is_ok()),
            ("at", scene.solve_at(&start, &[1.0, bad], 1e-6, &Limits::default()).is_ok()),
            ("dop", dop.solve(&spring, 0.0, &[1.0, 0.0], bad, &[]).is_ok()),
            ("dop from", dop.solve(&spring, bad, &[1.0, 0.0], 1.0, &[]).is_ok()),
            ("dop end", dop.advance(&spring, bad, &[1.0, 0.0], 1.0).is_ok()),
            ("rk", rk.advance(&scene, 0.0, &start, bad).is_ok()),
            ("gauss", gauss.advance(&scene, bad, &start, 1.0).is_ok()),
            ("lie", lie.advance(&scene, bad, &start, 1.0).is_ok()),
            ("split", split.advance(&scene, 0.0, &start, bad).is_ok()),
            ("spin-free", dop.advance(&spun, 0.0, &start, bad).is_ok()),
            ("planar", simulate(&FALLING, &dop, (), [1.0, 0.0], bad).is_ok()),
            ("top", top.simulate(&Throw::spinning(0.3, 150.0), bad, 1e-9).is_ok()),
            ("gimbals", {
                let start = gimbals.released(1.0, 314.0);
                GimbalMotion::new(gimbals, Bearings::SMOOTH, start, None, bad, 1e-9).is_ok()
            }),
        ];
        for (name, ran) in ends {
            assert!(!ran, "{name} at {bad}");
            refused += 1;
        }
    }
    assert_eq!(refused, 48);
    let motion = scene.solve_along(&start, 1.0, 1e-6, &Limits::default()).expect("a motion");
    for bad in NONE {
        assert!(motion.try_state(bad).is_err() && motion.try_states(&[0.5, bad]).is_err());
    }
    // In closed form, later than the phase is known.
    let late = scene.solve(&start, 1e17, 1.0).expect_err("no phase");
    assert!(matches!(late, Error::PhaseLost { .. }), "{late}");
    let alone = Scene::new(body).solve(&start, -1e100, 1.0).expect_err("no phase");
    assert!(matches!(alone, Error::PhaseLost { .. }), "{alone}");
    assert_eq!(
        free([1.0, 2.0, 2.5], [0.8, 0.4, 0.3])
            .and_then(|motion| motion.try_kinematics(1e100))
            .expect_err("no phase")
            .to_string(),
        "at t = 1e100 the phase of the motion is lost: beyond 3.364e15 the last bit of the time is \
         a 32nd of a turn or more"
    );
}

/// A generator of its own, so that the cases are the same everywhere.
struct Random(u64);

impl Random {
    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn between(&mut self, least: f64, most: f64) -> f64 {
        least + (most - least) * self.unit()
    }
}

/// The latest time at which a motion is known, as its refusal tells.
fn latest<T>(asked: Result<T>) -> f64 {
    match asked.err() {
        Some(Error::PhaseLost { latest, .. }) => latest,
        other => panic!("{other:?}"),
    }
}

/// Rz(`precession`) Rx(theta) Rz(`spin`), both angles reduced as pairs.
fn turned(precession: DoubleDouble, theta: f64, spin: DoubleDouble) -> Attitude {
    let (sin_sum, cos_sum) = (precession + spin).scaled(0.5).sin_cos();
    let (sin_difference, cos_difference) = (precession - spin).scaled(0.5).sin_cos();
    let (sin, cos) = DoubleDouble::from(0.5 * theta).sin_cos();
    let [w, x, y, z] = [cos * cos_sum, sin * cos_difference, sin * sin_difference, cos * sin_sum];
    Attitude::from_quaternion([w, x, y, z].map(|c| c.to_f64())).expect("a rotation")
}

/// Regular precession is two steady turns, which pairs of doubles follow: to the last time at
/// which it is known the closed form is right, and beyond there is none.
#[test]
fn near_the_last_time_the_phase_is_right_and_beyond_it_is_refused() {
    let mut random = Random(31);
    let mut errors = Errors::in_units_of(EPS, "attitude to a quarter of the time, rad");
    let mut lasts = Errors::in_units_of(EPS, "attitude to the last, rad");
    let mut damaged = Errors::in_units_of(EPS, "with a time that is an ulp later");
    let (mut refused, mut near) = (0, 0);
    for _ in 0..400 {
        let [across, along] = [random.between(0.5, 2.0), random.between(0.2, 3.0)];
        let along = along.min(1.9 * across);
        let theta = random.between(0.1, 3.0);
        let size = rotation_dynamics::math::exp(random.between(-60.0, 60.0));
        // L about Z: omega on the axes by which it is tilted.
        let momentum = random.between(0.5, 2.0) * size;
        let (sin, cos) = rotation_dynamics::math::sincos(theta);
        let rates = BodyVector::new(0.0, momentum * sin / across, momentum * cos / along);
        let moments = PrincipalMoments::symmetric(across, along).expect("a body");
        let angle = DoubleDouble::from(0.0);
        let start = turned(angle, theta, angle);
        let motion = FreeBody::new(moments, start, rates).expect("a motion");
        // What the rates that are doubles make of it.
        let pairs = |t: f64| {
            let [_, y, z] = rates.to_array();
            let transverse = DoubleDouble::from(y);
            let own = DoubleDouble::product(along, z) / across;
            let turn = (transverse.square() + own.square()).sqrt();
            let spin = DoubleDouble::from(z) - own;
            let tilt = transverse.atan2(own).to_f64();
            // About L, then about the own axis, seen from the start.
            let from = turned(angle, tilt, angle).inverse() * turned(turn * t, tilt, spin * t);
            start * from
        };
        let last = latest(motion.try_kinematics(1e300));
        for part in [random.between(0.5, 1.0), -random.between(0.9, 1.0), 1.0] {
            let t = part * last;
            let got = motion.try_attitude(t).expect("a time that is known");
            lasts.push(got.angle_to(&pairs(t)));
            damaged.push(got.angle_to(&pairs(t.next_up())));
            let got = motion.try_attitude(0.25 * t).expect("a time that is known");
            errors.push(got.angle_to(&pairs(0.25 * t)));
            near += 1;
        }
        for part in [1.0 + 2.0 * EPS, random.between(1.0, 4.0), -random.between(1.1, 1e9)] {
            let t = part * last * (1.0 + 2.0 * EPS);
            assert_eq!(latest(motion.try_attitude(t)), last);
            let plain = motion.kinematics(t);
            assert!(of_kinematics(plain).iter().all(|x| x.is_nan()));
            refused += 1;
        }
    }
    assert_eq!((near, refused), (1200, 1200));
    assert_largest!(errors, near, @"6.05");
    assert_largest!(lasts, near, @"452");
    damaged.exceed(1e12, near);
}

/// A sphere flows by one turn, and as long.
#[test]
fn a_flow_is_known_as_long() {
    let mut random = Random(5);
    let (mut known, mut lost) = (0, 0);
    for _ in 0..400 {
        let inertia = random.between(0.1, 10.0);
        let sphere = PrincipalMoments::new(inertia, inertia, inertia).expect("a sphere");
        let flow = FreeFlow::new(sphere);
        let momentum = BodyVector::new(random.unit(), random.unit(), 0.1 + random.unit());
        let last = 2.0_f64.powi(48) * TAU * inertia / momentum.norm();
        let turned = |t: f64| of_attitude(flow.turn(momentum, t));
        known += usize::from(turned(random.between(-0.999, 0.999) * last)[0].is_finite());
        let late = turned(random.between(1.001, 1e3) * last);
        lost += usize::from(late.iter().all(|x| x.is_nan()));
    }
    assert_eq!((known, lost), (400, 400));
}

/// Small swings are harmonic, and known as long.
#[test]
fn a_pendulum_is_known_as_long() {
    let mut random = Random(16);
    let mut errors = Errors::in_units_of(EPS, "theta over theta0");
    let mut refused = 0;
    for _ in 0..400 {
        let rate = random.between(0.1, 10.0);
        let suspension = Suspension { moment: 1.0, mass: 1.0, gravity: rate, lever: 1.0 };
        let pendulum = Pendulum::new(suspension, 1e-19, 0.0).expect("a pendulum");
        let last = latest(pendulum.at(1e300));
        let turns = last * pendulum.small_swing_frequency() / TAU;
        assert!((turns / 2.0_f64.powi(48) - 1.0).abs() < 1e-12, "{turns}");
        let t = random.between(0.5, 1.0) * last;
        let phase = DoubleDouble::from(rate).sqrt() * t;
        let got = pendulum.at(t).expect("a time").theta / 1e-19;
        errors.push(got - phase.cos().to_f64());
        assert_eq!(latest(pendulum.at(random.between(1.01, 3.0) * last)), last);
        refused += 1;
    }
    assert_eq!(refused, 400);
    assert_largest!(errors, 400, @"1");
}

/// An orbit that closes is known as long, or to the half of its first turn; of the turning of its
/// plane the same holds. A circle is where its angle is.
#[test]
fn an_orbit_is_known_as_long() {
    let mut random = Random(9);
    let mut errors = Errors::in_units_of(EPS, "place on a circle, over the last bit of the time");
    let mut refused = 0;
    for _ in 0..200 {
        let parameter = random.between(0.1, 10.0);
        let orbit = KeplerOrbit::about(parameter, 1.0, 0.0).expect("an orbit");
        let rate = DoubleDouble::from(parameter).sqrt();
        let last = 2.0_f64.powi(48) * TAU / rate.to_f64();
        let t = random.between(0.5, 0.999) * last;
        let (sin, cos) = (rate * t).sin_cos();
        let place = orbit.place(t);
        let off = (place - SpaceVector::new(cos.to_f64(), sin.to_f64(), 0.0)).norm();
        errors.push(off / (rate.to_f64() * t));
        let eccentric = KeplerOrbit::about(parameter, 1.0, 0.9).expect("an orbit");
        for late in [
            orbit.place(1.001 * last),
            orbit.velocity(-random.between(1.1, 1e9) * last),
            eccentric.place(1.1 * last),
            orbit.passing_at(-1.1 * last).expect("a time").place(0.0),
            orbit.turning(0.0, 1e3 * rate.to_f64()).expect("a rate").place(0.01 * last),
        ] {
            assert!(late.to_array().iter().all(|x| x.is_nan()), "{late:?}");
            refused += 1;
        }
        // So long an ellipse that its first half outlasts that.
        let long = KeplerOrbit::about(parameter, 1.0, 1.0 - 1e-13).expect("an orbit");
        assert!(long.period() > 10.0 * last);
        assert!((long.place(0.5 * long.period()).x() * 1e-13 / 2.0 + 1.0).abs() < 1e-3);
        assert!(long.place(0.51 * long.period()).x().is_nan());
    }
    assert_eq!(refused, 1000);
    assert_largest!(errors, 200, @"1.75");
}

/// What is asked of an attitude that is lost shows that it is.
#[test]
fn a_lost_attitude_reads_as_none() {
    let mut read = 0;
    for body in free_bodies().expect("bodies") {
        for t in NONE {
            let lost = body.attitude(t);
            let (angles, turn) = (lost.euler_angles(), lost.yaw_pitch_roll());
            let along = BodyVector::new(0.1, 0.2, 0.3);
            let mut numbers = vec![
                angles.phi,
                angles.theta,
                angles.zeta,
                turn.yaw,
                turn.pitch,
                turn.roll,
                lost.angle_to(&Attitude::IDENTITY),
                Attitude::IDENTITY.angle_to(&lost),
            ];
            numbers.extend(lost.matrix().concat());
            numbers.extend(lost.rotation_vector().to_array());
            numbers.extend(lost.to_space(along).to_array());
            numbers.extend(lost.axis().to_array());
            numbers.extend(lost.vertical().to_array());
            numbers.extend((lost * Attitude::IDENTITY).quaternion());
            numbers.extend((Attitude::IDENTITY * lost.inverse()).quaternion());
            let turned = lost.turned_in_space(SpaceVector::new(0.1, 0.2, 0.3));
            numbers.extend(turned.expect("a turn").quaternion());
            for sequence in Sequence::ALL {
                numbers.extend(lost.angles(sequence));
            }
            assert!(numbers.iter().all(|x| x.is_nan()), "{numbers:?}");
            read += numbers.len();
        }
    }
    assert_eq!(read, 6 * 5 * 77);
}

/// It has no width, and says so in the middle of others.
struct Widthless;

impl Effect for Widthless {
    const PROPERTIES: Properties = Properties::ANYTHING;
    fn name(&self) -> &'static str {
        "widthless"
    }
    fn torque(&self, _: f64, _: &RigidBody, _: &State) -> SpaceVector {
        SpaceVector::new(0.1, 0.2, 0.3)
    }
    fn narrowest(&self) -> Option<Feature> {
        Some(Feature { time: f64::NAN, ..Feature::WIDE })
    }
}

/// A width that is NaN is not passed over for that of another effect, on either side of it.
#[test]
fn a_width_that_is_none_is_refused() {
    let body = RigidBody::new(PrincipalMoments::new(1.0, 1.5, 0.8).expect("a body"));
    let start = body.state(Attitude::IDENTITY, BodyVector::new(0.3, 0.1, 2.0)).expect("a state");
    let wide = GravityAtLever::new(2.0, 0.4).expect("a weight");
    let gradient = GravityGradient::fixed(0.1, SpaceVector::new(1.0, 0.0, 0.0)).expect("a rate");
    let scene = Scene::new(body);
    for error in [
        scene.with(Widthless).solve(&start, 1.0, 1e-6),
        scene.with(Widthless).with(gradient).with(wide).solve(&start, 1.0, 1e-6),
        scene.with(wide).with(gradient).with(Widthless).solve(&start, 1.0, 1e-6),
    ] {
        let text = error.expect_err("no width").to_string();
        assert_eq!(text, "narrowest time = NaN is not a finite number");
    }
}
