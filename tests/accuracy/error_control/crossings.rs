//! Where a function of the state goes through zero along a solved motion.

use core::f64::consts::TAU;
use rotation_dynamics::accuracy::{Crossing, Limits};
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::{GravityGradient, Torque};
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::scene::{components, state};
use rotation_dynamics::integrators::{Dop853, Event};
use rotation_dynamics::math::{acos, atan2};
use rotation_dynamics::scene::Scene;
use rotation_dynamics::{Error, Result};
use support::{Errors, Random, assert_largest};

/// A symmetric body without torque, whose axis goes round L, and a direction across which it is met:
/// axis.towards - level = middle + size cos(rate t - phase).
struct Round {
    body: RigidBody,
    start: State,
    towards: SpaceVector,
    middle: f64,
    size: f64,
    rate: f64,
    phase: f64,
}

impl Round {
    fn draw(random: &mut Random) -> Self {
        let across = random.size(0.3, 3.0);
        let moments = PrincipalMoments::new(across, across, across * random.between(0.1, 1.9));
        let body = RigidBody::new(moments.expect("a body"));
        let momentum = SpaceVector::from_array(random.vector()) * across;
        let turn = SpaceVector::from_array(random.vector());
        let attitude = Attitude::from_rotation_vector(turn).expect("an attitude");
        let towards = SpaceVector::from_array(random.vector());
        let start = State::new(attitude, momentum).expect("finite");
        // Turned by the angle a about l, e becomes (e.l) l + cos a (e - (e.l) l) + sin a (l x e).
        let (l, e) = (momentum / momentum.norm(), attitude.axis());
        let middle = e.dot(&l) * l.dot(&towards);
        let (even, odd) = (e.dot(&towards) - middle, l.cross(&e).dot(&towards));
        Self {
            body,
            start,
            towards,
            middle,
            size: even.hypot(odd),
            rate: momentum.norm() / across,
            phase: atan2(odd, even),
        }
    }

    /// The first `count` times after 0, forward or backward, at which the axis meets a level, and
    /// whether the function rises along the motion.
    fn times(&self, level: f64, count: usize, onward: f64) -> Vec<(f64, bool)> {
        let half = acos((level - self.middle) / self.size);
        let mut all: Vec<_> = (-20..20)
            .flat_map(|n| {
                [(-half, onward > 0.0), (half, onward < 0.0)].map(|(at, rising)| {
                    ((self.phase + at + TAU * f64::from(n)) / self.rate, rising)
                })
            })
            .filter(|(t, _)| t * onward > 0.0)
            .collect();
        all.sort_by(|(a, _), (b, _)| a.abs().total_cmp(&b.abs()));
        all.truncate(count);
        all
    }

    /// The crossings of the level by `solve_along`: of the closed form, or of the motion in steps.
    fn crossings(
        &self,
        level: f64,
        t_end: f64,
        tolerance: f64,
        steps: bool,
    ) -> Result<Vec<Crossing>> {
        let limits = Limits::default();
        let function = |_: f64, state: &State| state.attitude.axis().dot(&self.towards) - level;
        if !steps {
            let scene = Scene::new(self.body);
            let motion = scene.solve_along(&self.start, t_end, tolerance, &limits)?;
            return motion.crossings("level", function);
        }
        let nothing =
            Torque::on_space("nothing", |_, _: &RigidBody, _: &State| SpaceVector::zero());
        let scene = Scene::new(self.body).with(nothing.smooth());
        let motion = scene.solve_along(&self.start, t_end, tolerance, &limits)?;
        motion.crossings("level", function)
    }
}

/// Closed forms and motions in steps, forward and backward: every crossing is there, on the far side of
/// zero, and as near to its time as its estimate says.
#[test]
fn the_axis_of_a_free_body_crosses_a_level() -> Result<()> {
    let mut random = Random(343);
    let mut over = Errors::of("error of the time over its estimate");
    let mut twin = Errors::of("the same of a body that starts thirty tolerances off");
    let (mut motions, mut met) = (0, 0);
    for _ in 0..60 {
        let round = Round::draw(&mut random);
        let level = round.middle + round.size * random.between(-0.9, 0.9);
        let onward = [1.0, -1.0][(2.0 * random.unit()) as usize];
        let tolerance = [1e-3, 1e-6, 1e-10][(3.0 * random.unit()) as usize];
        let mut exact = round.times(level, 8, onward);
        let t_end = 0.5 * (exact[6].0 + exact[7].0);
        exact.truncate(7);
        for steps in [false, true] {
            let crossings = round.crossings(level, t_end, tolerance, steps)?;
            assert_eq!(crossings.len(), 7, "{steps} {tolerance}");
            for (crossing, (t, rising)) in crossings.iter().zip(&exact) {
                assert_eq!(crossing.rising, *rising);
                let value = crossing.state.attitude.axis().dot(&round.towards) - level;
                assert!(if *rising { value >= 0.0 } else { value <= 0.0 }, "{value:e}");
                over.push((crossing.t - t).abs() / crossing.t_estimate);
                met += 1;
            }
            motions += 1;
        }
        let turn = BodyVector::new(30.0, 30.0, 30.0) * tolerance;
        let start = State { attitude: round.start.attitude.turned_in_body(turn)?, ..round.start };
        let off = Round { start, ..round };
        let crossings = off.crossings(level, t_end, tolerance, true)?;
        twin.push((crossings[0].t - exact[0].0).abs() / crossings[0].t_estimate);
    }
    assert_eq!((motions, met), (120, 840));
    assert_largest!(over, 840, @"0.189");
    twin.exceed(1.0, 60);
    Ok(())
}

/// Levels near the highest that the axis reaches, down to a graze as deep as the error: both crossings,
/// or none, and estimates that grow as the condition does.
#[test]
fn grazes() -> Result<()> {
    let mut random = Random(344);
    let mut over = Errors::of("error of the time over its estimate");
    let (mut met, mut undecided, mut unseen) = (0, 0, 0);
    for _ in 0..20 {
        let round = Round::draw(&mut random);
        for depth in [1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12] {
            let level = round.middle + round.size * (1.0 - depth);
            let exact = round.times(level, 3, 1.0);
            let t_end = exact[2].0 - 1e-3 / round.rate;
            let crossings = round.crossings(level, t_end, 1e-9, true)?;
            if crossings.is_empty() {
                assert!(depth < 1e-7, "{depth}");
                unseen += 1;
                continue;
            }
            for (crossing, (t, rising)) in crossings.iter().zip(&exact) {
                assert_eq!(crossing.rising, *rising);
                if crossing.t_estimate.is_finite() {
                    over.push((crossing.t - t).abs() / crossing.t_estimate);
                    met += 1;
                } else {
                    undecided += 1;
                }
            }
        }
    }
    assert_largest!(over, met, @"4.35e-4");
    assert_eq!((met, undecided, unseen), (170, 0, 35));
    Ok(())
}

/// A satellite hangs by the gravity gradient and swings across the plane of its orbit: the times are
/// those of DOP853 with events of its own, and of going on from crossing to crossing.
#[test]
fn a_satellite_is_stopped_where_its_axis_crosses_the_plane_of_its_orbit() -> Result<()> {
    let (normal, towards) = (SpaceVector::new(0.0, 0.0, 1.0), SpaceVector::new(1.0, 0.0, 0.0));
    let body = RigidBody::new(PrincipalMoments::new(80.0, 100.0, 30.0)?);
    let scene = Scene::new(body).with(GravityGradient::on_orbit(1.1e-3, normal, towards)?);
    let turn = Attitude::from_rotation_vector(SpaceVector::new(0.0, 1.3, 0.2))?;
    let start = body.state(turn, BodyVector::new(2e-4, 1e-3, -1e-4))?;
    let height = |state: &State| state.attitude.axis().z();
    let t_end = 20_000.0;
    let method = Dop853::new(1e-14)?;
    let event = Event::crossing("plane", |_, y: &[f64; 7]| height(&state(y).expect("a state")));
    let run = method.solve(&scene, 0.0, &components(&start), t_end, &[event])?;
    let motion = scene.solve_along(&start, t_end, 1e-9, &Limits::default())?;
    let crossings = motion.crossings("plane", |_, state| height(state))?;
    let mut apart = Errors::of("error of the time over its estimate");
    let others = run.events();
    assert_eq!(crossings.len(), others.len());
    for (crossing, other) in crossings.iter().zip(others) {
        assert_eq!(crossing.rising, other.rising);
        apart.push((crossing.t - other.t).abs() / crossing.t_estimate);
    }
    assert_largest!(apart, 10, @"0.117");
    // From stop to stop: the start of each motion is no crossing of it.
    let (mut t_start, mut from, mut stops) = (0.0, start, Vec::new());
    loop {
        let limits = Limits { t_start, ..Limits::default() };
        let motion = scene.solve_along(&from, t_end, 1e-9, &limits)?;
        let Some(next) = motion.crossings("plane", |_, state| height(state))?.into_iter().next()
        else {
            break;
        };
        (t_start, from) = (next.t, next.state);
        stops.push(next.t);
    }
    assert_eq!(stops.len(), crossings.len());
    let mut apart = Errors::of("distance of the stops over the estimate");
    for (stop, crossing) in stops.iter().zip(&crossings) {
        apart.push((stop - crossing.t).abs() / crossing.t_estimate);
    }
    assert_largest!(apart, 10, @"0.0122");
    Ok(())
}

/// Crossings beside the ends of a span that does not start at 0, where derivatives are differences to one
/// side: rounding does not lead out of the span.
#[test]
fn beside_the_ends_of_the_span() -> Result<()> {
    let round = Round::draw(&mut Random(346));
    let nothing = Torque::on_space("nothing", |_, _: &RigidBody, _: &State| SpaceVector::zero());
    let scene = Scene::new(round.body).with(nothing.smooth());
    let mut met = 0;
    for k in 1..100 {
        for onward in [1.0, -1.0] {
            let t_start = 0.1 * f64::from(k);
            let t_end = t_start + onward;
            let limits = Limits { t_start, ..Limits::default() };
            let motion = scene.solve_along(&round.start, t_end, 1e-6, &limits)?;
            for zero in [t_start + 1e-5 * onward, t_end - 1e-5 * onward] {
                let crossings = motion.crossings("beside", |t, _| t - zero)?;
                assert_eq!(crossings.len(), 1, "{t_start} {onward}");
                assert!((crossings[0].t - zero).abs() <= 2e-15);
                assert_eq!(crossings[0].t_estimate, 0.0);
                met += 1;
            }
        }
    }
    assert_eq!(met, 396);
    Ok(())
}

#[test]
fn what_is_no_number_and_what_is_over_budget() -> Result<()> {
    let round = Round::draw(&mut Random(345));
    let scene = Scene::new(round.body);
    let motion = scene.solve_along(&round.start, 3.0, 1e-6, &Limits::default())?;
    let error = motion.crossings("root", |t, _| (1.0 - t).sqrt()).unwrap_err();
    let Error::FunctionOutOfRange { what, t, .. } = &error else { panic!("{error}") };
    assert!(what.contains("\"root\"") && *t > 1.0, "{error}");
    // Nothing crosses, and a start at zero is none.
    assert_eq!(motion.crossings("above", |_, _| 1.0)?, []);
    assert_eq!(motion.crossings("zero", |_, _| 0.0)?, []);
    assert_eq!(motion.crossings("start", |t, _| t)?, []);
    // What leaves zero at the start and is back soon is met there; at a jump no rate tells of the time.
    let back = motion.crossings("back", |t, _| t * (t - 0.01))?;
    assert!(back.len() == 1 && back[0].rising && (back[0].t - 0.01).abs() < 1e-15);
    let jump = motion.crossings("jump", |t, _| if t < 1.5 { -1.0 } else { 1.0 })?;
    assert!(jump.len() == 1 && (jump[0].t - 1.5).abs() < 1e-15 && jump[0].t_estimate.is_infinite());
    let middle = &motion.crossings("middle", |t, _| t - 1.5)?;
    assert!(middle.len() == 1 && middle[0].rising && (middle[0].t - 1.5).abs() < 1e-15);
    let scene = scene.with(
        Torque::on_space("push", |t, _: &RigidBody, _: &State| SpaceVector::new(t, 0.0, 0.0))
            .smooth(),
    );
    let solved = scene.solve_along(&round.start, 30.0, 1e-6, &Limits::default())?.solved().work;
    let limits = Limits { budget: solved.torques() + 100, ..Limits::default() };
    let motion = scene.solve_along(&round.start, 30.0, 1e-6, &limits)?;
    let error = motion.crossings("X", |_, state| state.attitude.axis().x()).unwrap_err();
    assert!(matches!(error, Error::LimitReached { what: "torques", .. }), "{error}");
    Ok(())
}
