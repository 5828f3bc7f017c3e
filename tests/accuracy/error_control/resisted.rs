//! Scenes that resist the rotation: what `solve` makes of them, what it made of them before it
//! knew how, and within which limits.

use rotation_dynamics::accuracy::{Limits, Solved};
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::{
    CoulombBearing, DiscDrag, Effect, Feature, Gravity, GravityAtLever, IntegrableCase, Properties,
    Resistance, ViscousFriction, check,
};
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::{Integrator, Resisted, Scheme, Splitting};
use rotation_dynamics::math::{Lane, exp};
use rotation_dynamics::motion::Motion;
use rotation_dynamics::scene::Scene;
use rotation_dynamics::{Error, Result};
use std::sync::atomic::AtomicBool;
use support::{Errors, assert_largest};

/// The same effects, which may say nothing of what resists, or not that they are smooth.
#[derive(Clone, Copy)]
struct Said<E, const RESISTS: bool, const SMOOTH: bool>(E);

/// They say nothing of what resists.
const fn silent<E>(effects: E) -> Said<E, false, true> {
    Said(effects)
}

/// They do not say that they are smooth.
const fn unsaid<E>(effects: E) -> Said<E, true, false> {
    Said(effects)
}

impl<E: Effect, const RESISTS: bool, const SMOOTH: bool> Effect for Said<E, RESISTS, SMOOTH> {
    const PROPERTIES: Properties =
        Properties { smooth: E::PROPERTIES.smooth && SMOOTH, ..E::PROPERTIES };

    fn name(&self) -> &'static str {
        self.0.name()
    }

    fn torque(&self, t: f64, body: &RigidBody, state: &State) -> SpaceVector {
        self.0.torque(t, body, state)
    }

    fn torques_on_axis<L: Lane>(&self, body: &RigidBody, axis: [L; 3]) -> [L; 3] {
        self.0.torques_on_axis(body, axis)
    }

    fn resistance(&self, t: f64, body: &RigidBody) -> Option<Resistance> {
        self.0.resistance(t, body).filter(|_| RESISTS)
    }

    fn potential_energy(&self, t: f64, body: &RigidBody, state: &State) -> f64 {
        self.0.potential_energy(t, body, state)
    }

    fn power(&self, t: f64, body: &RigidBody, state: &State) -> f64 {
        self.0.power(t, body, state)
    }

    fn torque_scale(&self, t: f64, body: &RigidBody, state: &State) -> f64 {
        self.0.torque_scale(t, body, state)
    }

    fn torque_size(&self, t: f64, body: &RigidBody, state: &State) -> f64 {
        self.0.torque_size(t, body, state)
    }

    fn break_points(&self) -> Vec<f64> {
        self.0.break_points()
    }

    fn narrowest(&self) -> Option<Feature> {
        self.0.narrowest()
    }

    fn integrable_case(&self) -> IntegrableCase {
        self.0.integrable_case()
    }

    fn holds_from(
        &self,
        t: f64,
        body: &RigidBody,
        start: &State,
        about_axis: &[&'static str],
    ) -> Result<()> {
        self.0.holds_from(t, body, start, about_axis)
    }

    fn about_axis(&self) -> Vec<&'static str> {
        self.0.about_axis()
    }

    fn names(&self) -> Vec<&'static str> {
        self.0.names()
    }
}

fn tilted(body: &RigidBody, rates: [f64; 3]) -> State {
    let (phi, theta, zeta) = (0.4, 1.0, -0.3);
    let attitude = Attitude::from_euler(EulerAngles { phi, theta, zeta }).expect("angles");
    (body.state(attitude, BodyVector::from_array(rates))).expect("a state")
}

fn symmetric(i1: f64, i3: f64) -> RigidBody {
    RigidBody::new(PrincipalMoments::symmetric(i1, i3).expect("a body"))
}

/// What `solve` pays for a scene, and what it would pay if nothing were said of what resists.
struct Prices {
    lines: Vec<String>,
    /// Evaluations of the run that is returned, of both.
    run: [u64; 2],
    apart: Errors,
}

impl Prices {
    fn of<E: Effect + Copy>(&mut self, name: &str, scene: &Scene<E>, start: &State, end: f64) {
        let silent = Scene::new(*scene.body()).with(silent(*scene.effects()));
        for tolerance in [1e-3, 1e-6, 1e-9] {
            let now = scene.solve(start, end, tolerance).expect("solved");
            let was = silent.solve(start, end, tolerance).expect("solved");
            let told =
                |s: &Solved| format!("{} {}/{}", s.method, s.run.torques(), s.work.torques());
            let line = format!("{name} {tolerance:e}: {}; {}", told(&now), told(&was));
            self.lines.push(line);
            self.run[0] += now.run.torques();
            self.run[1] += was.run.torques();
            let apart = now.state.attitude.angle_to(&was.state.attitude);
            self.apart.push_at(apart / tolerance, (name, tolerance));
        }
    }
}

/// The evaluations of the run that is returned, and of all runs: with what is said of the
/// resistance, and without. The two answers are within the tolerance of each other.
#[test]
fn what_resists_weakly_is_cheap() {
    let mut prices = Prices {
        lines: Vec::new(),
        run: [0, 0],
        apart: Errors::of("distance of the two answers over the tolerance"),
    };
    let gyroscope = symmetric(5.45e-3, 9e-4);
    let (start, slowly) =
        (tilted(&gyroscope, [0.0, 0.0, 314.16]), tilted(&gyroscope, [0.0, 0.0, 60.0]));
    let heavy = Scene::new(gyroscope).with(GravityAtLever::new(4.9, 0.1).expect("gravity"));
    let oil = ViscousFriction::new(2e-5, 2e-6).expect("friction");
    let drag = DiscDrag::new(0.06, 1.204, 1.51e-5, 314.16).expect("drag");
    let dry = CoulombBearing::new(1e-4, &gyroscope, &start, 0.0).expect("friction");
    let stopped = CoulombBearing::new(2e-2, &gyroscope, &slowly, 0.0).expect("friction");
    prices.of("gyroscope in oil", &heavy.with(oil), &start, 10.0);
    prices.of("gyroscope in air", &heavy.with(drag), &start, 10.0);
    prices.of("gyroscope, dry", &heavy.with(dry), &start, 10.0);
    prices.of("gyroscope, to the stop", &heavy.with(stopped), &slowly, 5.0);
    let toy = symmetric(1.0, 0.6);
    let heavy = Scene::new(toy).with(GravityAtLever::new(1.0, 0.8).expect("gravity"));
    let start = tilted(&toy, [0.3, -0.2, 5.0]);
    let oil = ViscousFriction::new(0.03, 0.015).expect("friction");
    prices.of("toy top in oil", &heavy.with(oil), &start, 20.0);
    let brick = RigidBody::new(PrincipalMoments::new(1.0, 1.5, 0.8).expect("a body"));
    let start = tilted(&brick, [0.3, 0.1, 2.0]);
    let oil = ViscousFriction::isotropic(1e-2).expect("friction");
    prices.of("brick in oil", &Scene::new(brick).with(oil), &start, 20.0);
    let honey = ViscousFriction::isotropic(20.0).expect("friction");
    prices.of("brick in honey", &Scene::new(brick).with(honey), &start, 20.0);
    println!("{}\n{:?}", prices.lines.join("\n"), prices.run);
    let expected = [
        "gyroscope in oil 1e-3: SRKN 14a, resisted 3584/5488; DOP853 55480/90584",
        "gyroscope in oil 1e-6: SRKN 14a, resisted 6272/9632; DOP853 189568/309236",
        "gyroscope in oil 1e-9: SRKN 14a, resisted 19488/30016; Gauss-Legendre 16 177760/428768",
        "gyroscope in air 1e-3: SRKN 14a, resisted 3584/5488; DOP853 87712/178272",
        "gyroscope in air 1e-6: SRKN 14a, resisted 6272/9632; DOP853 192208/441336",
        "gyroscope in air 1e-9: SRKN 14a, resisted 19488/30016; DOP853 192208/633544",
        "gyroscope, dry 1e-3: SRKN 14a, resisted 3584/5488; DOP853 55984/91448",
        "gyroscope, dry 1e-6: SRKN 14a, resisted 6272/9632; DOP853 191332/312116",
        "gyroscope, dry 1e-9: SRKN 14a, resisted 19488/49504; Gauss-Legendre 16 177128/428136",
        "gyroscope, to the stop 1e-3: SRKN 14a, resisted 1694/3066; DOP853 3126/6593",
        "gyroscope, to the stop 1e-6: SRKN 14a, resisted 3136/5740; DOP853 6138/10128",
        "gyroscope, to the stop 1e-9: SRKN 14a, resisted 5054/7756; Gauss-Legendre 16 14352/25808",
        "toy top in oil 1e-3: SRKN 14a, resisted 504/756; DOP853 882/1878",
        "toy top in oil 1e-6: SRKN 14a, resisted 882/1344; DOP853 1626/2700",
        "toy top in oil 1e-9: SRKN 14a, resisted 2730/4200; Gauss-Legendre 16 4568/8280",
        "brick in oil 1e-3: SRKN 14a, resisted 210/322; DOP853 290/618",
        "brick in oil 1e-6: SRKN 14a, resisted 238/364; DOP853 518/856",
        "brick in oil 1e-9: SRKN 14a, resisted 728/1120; Gauss-Legendre 16 1760/3192",
        "brick in honey 1e-3: DOP853 1420/2677; DOP853 1420/2677",
        "brick in honey 1e-6: DOP853 1780/3195; DOP853 1780/3195",
        "brick in honey 1e-9: Gauss-Legendre 16 10328/20840; Gauss-Legendre 16 10328/20840",
    ];
    assert_eq!(prices.lines, expected);
    assert_largest!(prices.apart, 21, @"9.17e-3");
}

/// Where the first run has its inputs changed nothing is spent on the condition alone.
#[test]
fn two_runs_tell_error_and_condition() -> Result<()> {
    let body = symmetric(5.45e-3, 9e-4);
    let gravity = GravityAtLever::new(4.9, 0.1)?;
    let [fast, slow] = [314.16, 60.0].map(|spin| tilted(&body, [0.0, 0.0, spin]));
    let oil = Scene::new(body).with(gravity).with(ViscousFriction::new(2e-5, 2e-6)?);
    let two = oil.solve(&fast, 10.0, 1e-6)?;
    let stopped = CoulombBearing::new(2e-2, &body, &slow, 0.0)?;
    let dry = Scene::new(body).with(gravity).with(stopped);
    let three = dry.solve(&slow, 5.0, 1e-6)?;
    // Two runs of order six cost one and a half times the second: 1.54 here. Three: 1.83.
    assert!((1.5..1.6).contains(&two.price), "{}", two.price);
    assert!((1.8..1.9).contains(&three.price), "{}", three.price);
    assert_eq!([two, three].map(|s| s.probes.torques()), [0, 0]);
    // By another method, of which nothing is said of what resists.
    let other = Scene::new(body).with(silent(*dry.effects())).solve(&slow, 5.0, 1e-9)?;
    assert_ne!(other.method, three.method);
    let mut off = Errors::of("distance of the two answers over the tolerance");
    off.push(other.state.attitude.angle_to(&three.state.attitude) / 1e-6);
    assert_largest!(off, 1, @"8.06e-5");
    Ok(())
}

/// What is solved by a splitting that takes what resists, and by which method otherwise.
#[test]
fn a_splitting_takes_what_it_can() {
    let (round, brick) = (
        symmetric(1.0, 0.6),
        RigidBody::new(PrincipalMoments::new(1.0, 1.4, 0.6).expect("a body")),
    );
    let lever = GravityAtLever::new(0.5, 0.8).expect("gravity");
    let on_axis = Gravity::new(0.5, BodyVector::new(0.0, 0.0, 0.8)).expect("gravity");
    let beside = Gravity::new(0.5, BodyVector::new(0.1, 0.0, 0.8)).expect("gravity");
    let oil = ViscousFriction::new(1e-3, 2e-3).expect("friction");
    let across = ViscousFriction::new(1e-3, 0.0).expect("friction");
    let air = DiscDrag::new(0.3, 1.2, 1.5e-5, 20.0).expect("drag");
    fn by<E: Effect>(body: &RigidBody, effects: E) -> bool {
        let start = tilted(body, [0.3, -0.2, 20.0]);
        let solved = Scene::new(*body).with(effects).solve(&start, 10.0, 1e-6);
        solved.expect("solved").method.ends_with(", resisted")
    }
    let taken = [
        by(&round, (lever, oil)),
        by(&round, (on_axis, oil)),
        by(&round, (lever, air)),
        by(&round, (air, across)),
        by(&round, (lever, Some(oil))),
        by(&round, (Some(air), None::<ViscousFriction>)),
        by(&brick, (lever, oil)),
        by(&brick, oil),
    ];
    assert_eq!(taken, [true; 8]);
    let left = [
        // Each is known, both together are not.
        by(&round, (air, oil)),
        // It sees more than the axis.
        by(&round, (beside, oil)),
        // l_3 passes through 0.
        by(&brick, air),
        by(&round, silent((lever, oil))),
        // The closed form.
        by(&round, (lever, None::<ViscousFriction>)),
    ];
    assert_eq!(left, [false; 5]);
}

/// Drag has its kink where the body does not spin, and never brings the spin of a symmetric body
/// there: two runs suffice, as with friction that is smooth everywhere. Where nothing tells that
/// the kink is not met there are three.
#[test]
fn drag_is_smooth_where_it_stops_no_spin() -> Result<()> {
    let round = symmetric(1.0, 0.6);
    let brick = RigidBody::new(PrincipalMoments::new(1.0, 1.4, 0.6)?);
    let oil = ViscousFriction::new(1e-3, 2e-3)?;
    let air = DiscDrag::new(0.3, 1.2, 1.5e-5, 20.0)?;
    fn price<E: Effect>(body: &RigidBody, effect: E) -> Result<f64> {
        let lever = GravityAtLever::new(0.5, 0.8)?;
        let start = tilted(body, [0.3, -0.2, 20.0]);
        let scene = Scene::new(*body).with(lever).with(effect);
        Ok(scene.solve(&start, 10.0, 1e-6)?.price)
    }
    let smooth = [
        price(&round, oil)?,
        price(&round, air)?,
        price(&round, unsaid(oil))?,
        price(&brick, unsaid(oil))?,
    ];
    let dry = CoulombBearing::new(0.1, &round, &tilted(&round, [0.3, -0.2, 20.0]), 0.0)?;
    let not_known = [
        // Its spin passes through 0.
        price(&brick, air)?,
        // Dry friction has its kink at the stop.
        price(&round, unsaid(dry))?,
        price(&round, silent(air))?,
    ];
    // Two runs, and three, whose second costs half of all.
    assert!(smooth.iter().all(|price| *price < 1.85), "{smooth:?}");
    assert!(not_known[0] > 2.0 && not_known[2] > 2.0, "{not_known:?}");
    Ok(())
}

/// Rates across the axis of a symmetric body that are not the same: the body's own axes count.
#[derive(Clone, Copy)]
struct Uneven;

impl Effect for Uneven {
    const PROPERTIES: Properties = ViscousFriction::PROPERTIES;

    fn name(&self) -> &'static str {
        "uneven"
    }

    fn torque(&self, _t: f64, body: &RigidBody, state: &State) -> SpaceVector {
        let [l1, l2, l3] = body.angular_momentum(state).to_array();
        (state.attitude).to_space(BodyVector::new(-0.3 * l1, -0.1 * l2, -0.2 * l3))
    }

    fn resistance(&self, _t: f64, _body: &RigidBody) -> Option<Resistance> {
        Some(Resistance::linear([0.3, 0.1, 0.2]))
    }
}

/// It is stepped otherwise, and right: as when nothing is said of it.
#[test]
fn what_is_not_the_same_in_all_directions_is_stepped_otherwise() -> Result<()> {
    let scene = Scene::new(symmetric(1.0, 0.6)).with(Uneven);
    let start = tilted(scene.body(), [0.3, -0.2, 5.0]);
    assert!(matches!(Resisted::new(&scene, 0.0), Err(Error::Incompatible { .. })));
    let silent = Scene::new(*scene.body()).with(silent(Uneven));
    let [told, untold] = [scene.solve(&start, 10.0, 1e-8)?, silent.solve(&start, 10.0, 1e-8)?];
    assert_eq!(told, untold);
    // Of another body nothing is wrong with it.
    let brick = Scene::new(RigidBody::new(PrincipalMoments::new(1.0, 1.4, 0.6)?)).with(Uneven);
    let exact = brick.solve(&start, 10.0, 1e-11)?.state.attitude;
    let method = Splitting::new(Scheme::KAHAN_LI17, 400)?;
    let (end, _) = method.advance(&Resisted::new(&brick, 0.0)?, 0.0, &start, 10.0)?;
    let apart = exact.angle_to(&end.attitude);
    assert!(apart <= 1e-10, "{apart:e}");
    Ok(())
}

/// A brake that says it is steady, and wears off, or holds only on one side.
#[derive(Clone, Copy)]
struct Brake {
    fading: f64,
    one_sided: f64,
}

impl Effect for Brake {
    const PROPERTIES: Properties = Properties::ANYTHING;

    fn name(&self) -> &'static str {
        "brake"
    }

    fn torque(&self, t: f64, _body: &RigidBody, state: &State) -> SpaceVector {
        let axis = state.attitude.axis();
        let aside = if axis.x() > 0.1 { self.one_sided } else { 0.0 };
        state.angular_momentum * (-0.1 * exp(-self.fading * t))
            + SpaceVector::new(axis.y(), -axis.x(), 0.0) * aside
    }

    fn resistance(&self, t: f64, _body: &RigidBody) -> Option<Resistance> {
        Some(Resistance::linear([0.1 * exp(-self.fading * t); 3]))
    }
}

/// A resistance holds from one break point to the next, and what acts beside it has no jump:
/// whoever says otherwise is refused.
#[test]
fn what_is_said_of_the_resistance_must_hold_on_a_piece() {
    let body = symmetric(1.0, 0.6);
    let start = tilted(&body, [0.3, -0.2, 5.0]);
    let told = |fading, one_sided, span| {
        let brake = Brake { fading, one_sided };
        check(&brake, &body, span, &start).map_err(|error| error.to_string())
    };
    let mut ran = 0;
    for span in [[0.0, 10.0], [10.0, 0.0]] {
        assert_eq!(told(0.0, 0.0, span), Ok(()));
        for (fading, aside, words) in [
            (1e-3, 0.0, "says what of its torque resists the rotation"),
            (1e-12, 0.0, "says what of its torque resists the rotation"),
            (0.0, 0.1, "says that it is smooth between its break points"),
        ] {
            let refused = told(fading, aside, span).expect_err("refused");
            assert!(refused.contains(words), "{refused}");
            ran += 1;
        }
    }
    assert_eq!(ran, 6);
}

/// The weight, and the air.
type HeavyInAir = (((), GravityAtLever), DiscDrag);

/// The gyroscope in air, within limits.
fn in_air() -> (Scene<HeavyInAir>, State) {
    let body = symmetric(5.45e-3, 9e-4);
    let weight = GravityAtLever::new(4.9, 0.1).expect("gravity");
    let drag = DiscDrag::new(0.06, 1.204, 1.51e-5, 314.16).expect("drag");
    let start = tilted(&body, [0.0, 0.0, 314.16]);
    (Scene::new(body).with(weight).with(drag), start)
}

#[test]
fn limits_are_kept() -> Result<()> {
    let (scene, start) = in_air();
    let limits = Limits::default();
    let free = scene.solve(&start, 2.0, 1e-6)?;
    assert_eq!(free.method, "SRKN 14a, resisted");
    // No step is longer than the longest.
    let short = Limits { longest_step: 1e-3, ..limits };
    let solved = scene.solve_with(&start, 2.0, 1e-6, &short)?;
    assert!(free.longest_step > 1e-3, "{free:?}");
    assert!(solved.longest_step <= 1e-3 && solved.run.steps >= 2000);
    // Twice what was spent is enough, half of it is not.
    let spent = Limits { budget: 2 * free.work.torques(), ..limits };
    assert_eq!(scene.solve_with(&start, 2.0, 1e-6, &spent)?, free);
    let less = Limits { budget: free.work.torques() / 2, ..limits };
    let refused = scene.solve_with(&start, 2.0, 1e-6, &less);
    assert!(matches!(refused, Err(Error::LimitReached { what: "torques", .. })), "{refused:?}");
    let cancel = AtomicBool::new(true);
    let cancelled = Limits { cancel: Some(&cancel), ..limits };
    let refused = scene.solve_with(&start, 2.0, 1e-6, &cancelled);
    assert!(matches!(refused, Err(Error::Cancelled { torques: 0 })));
    // Break points cut the run; the answer is the same.
    let cut = Limits { break_points: &[0.3, 1.1], ..limits };
    let solved = scene.solve_with(&start, 2.0, 1e-6, &cut)?;
    let apart = solved.state.attitude.angle_to(&free.state.attitude);
    assert!(apart > 0.0 && apart <= 1e-6, "{apart:e}");
    // From the middle on, and back.
    let from = |t_start| Limits { t_start, ..limits };
    let middle = scene.solve(&start, 1.2, 1e-9)?.state;
    let end = scene.solve_with(&middle, 2.0, 1e-6, &from(1.2))?.state;
    assert!(end.attitude.angle_to(&free.state.attitude) <= 2e-6);
    let back = scene.solve_with(&end, 1.2, 1e-6, &from(2.0))?;
    assert_eq!(back.method, "SRKN 14a, resisted");
    assert!(back.state.attitude.angle_to(&middle.attitude) <= 2e-6);
    // Doubles end, in words.
    let refused = scene.solve(&start, 2.0, 1e-14);
    assert!(matches!(refused, Err(Error::NotDelivered { condition: Some(_), .. })));
    Ok(())
}

/// At 101 times on the way to the stop of a dry bearing, and beyond, the attitude is within
/// the tolerance.
#[test]
fn all_along_the_way_to_the_stop() -> Result<()> {
    let body = symmetric(5.45e-3, 9e-4);
    let start = tilted(&body, [0.0, 0.0, 60.0]);
    let bearing = CoulombBearing::new(2e-2, &body, &start, 0.0)?;
    let scene = Scene::new(body).with(GravityAtLever::new(4.9, 0.1)?).with(bearing);
    let silent = Scene::new(body).with(silent(*scene.effects()));
    let end = 4.0;
    let best = silent.solve_along(&start, end, 1e-11, &Limits::default())?;
    let mut over = Errors::of("error over tolerance");
    let mut twin = Errors::of("twin: the spin goes on");
    let free = Scene::new(body).with(GravityAtLever::new(4.9, 0.1)?);
    for tolerance in [1e-3, 1e-6, 1e-9] {
        let motion = scene.solve_along(&start, end, tolerance, &Limits::default())?;
        assert!(motion.solved().method.ends_with(", resisted"));
        for n in 0..=100 {
            let t = end * f64::from(n) / 100.0;
            let (here, exact) = (motion.try_state(t)?, best.try_state(t)?.attitude);
            over.push_at(here.attitude.angle_to(&exact) / tolerance, (tolerance, t));
            if n > 0 {
                let spun = free.solve(&start, t, 1e-9)?.state.attitude;
                twin.push_at(spun.angle_to(&exact) / tolerance, (tolerance, t));
            }
        }
    }
    assert_largest!(over, 303, @"6.68e-4");
    twin.exceed(1.0, 300);
    Ok(())
}
