//! Every effect alone: what its properties says it keeps is kept at every moment to a few eps a
//! step, and where it keeps no energy, the energy changes by the work that is done, to the
//! error of the method.

use super::pairs::{ALL, WithWork, air, anywhere, creaks, held, lever, motor, oil, on_orbit, push};
use super::{body, tilted};
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::erased::AnyEffect;
use rotation_dynamics::effects::{
    BoxedEffect, Conserved, CoulombBearing, Effect, EffectList, ElasticYielding, KeplerOrbit,
    OrbitingBody, PrescribedTorque, Profile, Properties, check,
};
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::integrators::scene::{components, state};
use rotation_dynamics::integrators::{Dop853, Integrator, Ode};
use rotation_dynamics::math::log;
use rotation_dynamics::scene::{Invariant, Scene};
use std::collections::BTreeSet;
use support::{EPS, Errors, assert_largest, attained};

const END: f64 = 5.0;

/// Places at which a run is looked at.
const PLACES: u32 = 50;

/// The steps (s) of the runs whose balance shows its order.
const STEPS: [f64; 4] = [END / 8.0, END / 10.0, END / 13.0, END / 16.0];

/// A little momentum leaks in, though it says that it keeps everything.
struct Leak;

impl Effect for Leak {
    const PROPERTIES: Properties = Properties { conserved: Conserved::ALL, ..Properties::ANYTHING };

    fn name(&self) -> &'static str {
        "leak"
    }

    fn torque(&self, _t: f64, _body: &RigidBody, _state: &State) -> SpaceVector {
        SpaceVector::new(1e-10, 2e-10, -1e-10)
    }
}

/// A place of a run: the state, the energy gained less the work done, and the steps so far.
struct Place {
    state: State,
    balance: f64,
    gained: f64,
    steps: u64,
}

/// A run through equal places, cut where the torque jumps: a piece ends before the jump.
fn run(
    scene: &Scene<EffectList>,
    start: &State,
    method: &Dop853,
    places: u32,
    part: f64,
) -> Vec<Place> {
    let size = scene.body().kinetic_energy(start);
    let problem: &dyn Ode<8> = &WithWork { scene, part };
    let [w, x, y, z, l, m, n] = components(start);
    let mut now = [w, x, y, z, l, m, n, 0.0];
    let (mut t, mut steps) = (0.0, 0);
    let mut all = Vec::new();
    for place in 1..=places {
        let end = END * f64::from(place) / f64::from(places);
        let mut times = scene.effects().break_points();
        times.retain(|jump| t < *jump && *jump < end);
        times.push(end);
        for to in times {
            let (there, work) = (method.advance(problem, t, &now, to.next_down())).expect("smooth");
            (now, t, steps) = (there, to, steps + work.steps);
        }
        let [w, x, y, z, l, m, n, done] = now;
        let state = state(&[w, x, y, z, l, m, n]).expect("a state");
        let gained = scene.energy_at(t.next_down(), &state) - scene.energy_at(0.0, start);
        all.push(Place { state, balance: (gained - done) / size, gained: gained / size, steps });
    }
    all
}

/// The largest drift of each quantity that is said to be kept, in eps a step: of |L|, of the
/// kinetic energy at the start.
fn drifts(scene: &Scene<EffectList>, start: &State, places: &[Place]) -> Vec<(Invariant, f64)> {
    let kept: Vec<Invariant> = scene.invariants().collect();
    let said = ALL.into_iter().filter(|quantity| kept.contains(quantity));
    let drift = |quantity| {
        let changes = places.iter().map(|place| {
            let change = if quantity == Invariant::Energy {
                place.gained
            } else {
                let [before, now] = [start, &place.state].map(|s| scene.value(quantity, s));
                (now - before) / start.angular_momentum.norm()
            };
            change.abs() / (EPS * place.steps as f64)
        });
        changes.fold(0.0, f64::max)
    };
    said.map(|quantity| (quantity, drift(quantity))).collect()
}

/// The slope of the line through these points, on logarithmic axes.
fn slope(points: &[(f64, f64)]) -> f64 {
    let n = points.len() as f64;
    let logs: Vec<_> = points.iter().map(|(h, e)| (log(*h), log(*e))).collect();
    let mean = |f: fn(&(f64, f64)) -> f64| logs.iter().map(f).sum::<f64>() / n;
    let (mx, my) = (mean(|p| p.0), mean(|p| p.1));
    let over: f64 = logs.iter().map(|(x, y)| (x - mx) * (y - my)).sum();
    over / logs.iter().map(|(x, _)| (x - mx) * (x - mx)).sum::<f64>()
}

/// What the effects did.
struct Book {
    body: RigidBody,
    start: State,
    drift: Errors,
    /// The same when momentum leaks in: the damaged twin.
    leaked: Errors,
    kept: usize,
    /// Of those that keep no energy: the balance at its worst, that of a power which is a
    /// millionth too small, how much is gained, and the order of the balance.
    balance: Errors,
    twin: Errors,
    gained: Errors,
    orders: Vec<(&'static str, f64)>,
    ran: BTreeSet<&'static str>,
    forms: usize,
}

impl Book {
    fn of(body: RigidBody) -> Self {
        Self {
            start: tilted(&body, [0.7, -0.4, 2.0]),
            body,
            drift: Errors::of("drift of what is kept, eps a step"),
            leaked: Errors::of("twin: momentum leaks in"),
            kept: 0,
            balance: Errors::of("energy less work"),
            twin: Errors::of("twin: a millionth less work"),
            gained: Errors::of("energy gained"),
            orders: Vec::new(),
            ran: BTreeSet::new(),
            forms: 0,
        }
    }

    /// An effect by the name of its type.
    fn alone<E: Effect + Clone + Send + Sync + 'static>(&mut self, name: &'static str, effect: E) {
        assert!(core::any::type_name::<E>().contains(name), "{name}");
        self.judge(name, [Box::new(effect.clone()), Box::new(effect)]);
    }

    /// Two of the same effect: alone, and beside a leak.
    fn judge(&mut self, name: &'static str, [effect, other]: [BoxedEffect; 2]) {
        let (body, start) = (self.body, self.start);
        check(&*effect, &body, [0.0, END], &start).expect("true claims");
        let keeps_energy = effect.properties().conserved.energy;
        let of =
            |effects| Scene::new(body).with_list(EffectList::new(effects).expect("one weight"));
        self.ran.insert(name);
        self.forms += 1;
        let scene = of(vec![effect]);
        let fine = Dop853::new(1e-15).and_then(|method| method.with_longest_step(0.05));
        let fine = fine.expect("a method");
        let places = run(&scene, &start, &fine, PLACES, 1.0);
        for (quantity, drift) in drifts(&scene, &start, &places) {
            self.drift.push_at(drift, (name, quantity));
            self.kept += 1;
        }
        let leaky = of(vec![other, Box::new(Leak)]);
        let leaked = run(&leaky, &start, &fine, PLACES, 1.0);
        for (quantity, drift) in drifts(&leaky, &start, &leaked) {
            self.leaked.push_at(drift, (name, quantity));
        }
        if keeps_energy {
            return;
        }
        let worst = |places: &[Place]| places.iter().map(|p| p.balance.abs()).fold(0.0, f64::max);
        self.balance.push_at(worst(&places), name);
        let less = run(&scene, &start, &fine, PLACES, 1.0 - 1e-6);
        self.twin.push_at(worst(&less), name);
        let gained = places.iter().map(|p| p.gained.abs()).fold(0.0, f64::max);
        self.gained.push_at(gained, name);
        let points = STEPS.map(|step| {
            // So loose that every step is as long as it may be.
            let equal = Dop853::new(0.1).and_then(|method| method.with_longest_step(step));
            let places = run(&scene, &start, &equal.expect("a method"), 1, 1.0);
            (step, worst(&places))
        });
        self.orders.push((name, slope(&points)));
    }

    fn all(&mut self) {
        self.alone("GravityAtLever", lever());
        self.alone("Gravity", anywhere());
        self.alone("GravityGradient", held());
        self.alone("GravityGradient", on_orbit());
        self.alone("OrbitingBody", planet());
        self.alone("OrbitingBody", planet().averaged().expect("it closes"));
        self.alone("ViscousFriction", oil());
        self.alone("DiscDrag", air());
        self.alone("PrescribedTorque", push());
        self.alone("PrescribedTorque", thruster());
        self.alone("Torque", motor());
        self.alone("InternalDissipation", creaks());
        self.alone("ElasticYielding", yielding());
        if self.body.moments().is_symmetric() {
            let torque = self.body.angular_momentum(&self.start).z().abs() / 3.3;
            let bearing = CoulombBearing::new(torque, &self.body, &self.start, 0.0);
            self.alone("CoulombBearing", bearing.expect("friction"));
        }
    }
}

fn planet() -> OrbitingBody {
    let orbit = KeplerOrbit::about(2.0, 2.0, 0.4)
        .and_then(|orbit| orbit.oriented(0.3, 0.8, 1.9))
        .and_then(|orbit| orbit.turning(-0.2, 0.3))
        .expect("an orbit");
    OrbitingBody::new(2.0, orbit).expect("a body")
}

fn thruster() -> PrescribedTorque {
    let steps = Profile::steps(&[(1.03, 1.0), (3.07, -0.5), (4.51, 0.0)]).expect("steps");
    PrescribedTorque::on_body(BodyVector::new(0.2, -0.1, 0.3), steps).expect("a torque")
}

fn yielding() -> ElasticYielding {
    ElasticYielding::new(0.02, 2.0).expect("yielding")
}

/// The effects that the library lists, in the order of their names.
fn listed() -> BTreeSet<&'static str> {
    let rows = include_str!("../../../src/effects/mod.rs").lines();
    let names = rows.filter_map(|row| row.strip_prefix("//! | [`")?.split_once('`'));
    names.map(|(name, _)| name).collect()
}

#[test]
fn every_effect_keeps_what_it_says_and_does_the_work_it_says() {
    let mut books = [body(1.0, 1.0, 0.6), body(1.0, 1.4, 0.6)].map(Book::of);
    for book in &mut books {
        book.all();
    }
    let [round, brick] = books;
    assert_eq!(listed().len(), 11);
    assert_eq!(round.ran, listed());
    let mut but_one = listed();
    assert!(but_one.remove("CoulombBearing"));
    assert_eq!(brick.ran, but_one);
    assert_eq!((round.forms, brick.forms), (14, 13));
    assert_eq!((round.kept, brick.kept), (14, 12));
    assert_largest!(round.drift, 14, @"0.656");
    assert_largest!(brick.drift, 12, @"0.963");
    round.leaked.exceed(1e4, 14);
    brick.leaked.exceed(1e4, 12);
    assert_largest!(round.balance, 10, @"3.20e-15");
    assert_largest!(brick.balance, 9, @"4.06e-15");
    round.twin.exceed(1e-9, 10);
    brick.twin.exceed(1e-9, 9);
    // Of order 8, as the method; in some the first term is small.
    let orders: Vec<f64> =
        (round.orders.iter().chain(&brick.orders)).map(|(_, order)| *order).collect();
    assert_eq!(orders.len(), 19);
    let [least, most] =
        [f64::min, f64::max].map(|f| orders.iter().copied().reduce(f).expect("some"));
    attained(least, "7.885", "least order of the balance");
    attained(most, "11.94", "largest order of the balance");
    round.gained.exceed(1e-3, 10);
    brick.gained.exceed(1e-3, 9);
}
