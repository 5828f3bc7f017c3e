//! Rolling resistance, and drag on translation and rotation.

use super::G;
use super::rolling::Round;
use rotation_dynamics::Error;
use rotation_dynamics::math::{cos, exp, sin};
use rotation_dynamics::planar::contact::{
    Contact, LinearDrag, LinearSpinDrag, Load, Mechanism, MechanismState, Mode, QuadraticDrag,
    QuadraticSpinDrag, Surface, entry, motion_within,
};
use support::{EPS, Errors, assert_largest, derivative};

/// A round body on a slope, with rolling resistance; coordinates along and across it.
struct Resisted {
    round: Round,
    slope: f64,
    resistance: f64,
}

impl Mechanism<3, 2> for Resisted {
    fn mass(&self, q: &[f64; 3]) -> [[f64; 3]; 3] {
        self.round.mass(q)
    }
    fn force(&self, _: &MechanismState<3>) -> [f64; 3] {
        let weight = self.round.mass * G;
        [-weight * sin(self.slope), -weight * cos(self.slope), 0.0]
    }
    fn contacts(&self, body: &MechanismState<3>) -> [Contact<3>; 2] {
        let [rim] = self.round.contacts(body);
        [rim, Contact::rolling("body", 0, self.round.radius, self.resistance)]
    }
}

fn resisted(shape: f64, mass: f64, slope: f64, resistance: f64) -> Resisted {
    let round = Round { mass, shape, radius: 0.1, mu: 0.6 };
    Resisted { round, slope, resistance }
}

fn rolling(speed: f64) -> MechanismState<3> {
    MechanismState { q: [0.0, 0.1, 0.0], v: [speed, 0.0, -10.0 * speed] }
}

/// On the level: C_rr g/(1 + k) until it stops, at v^2/2a; and then nothing happens any more.
fn stops(damage: f64) -> Errors {
    let mut errors = Errors::in_units_of(EPS, "stop of a rolling body");
    for mass in [1e-6, 1.0, 1e6] {
        for (shape, speed, resistance) in [(0.4, 2.0, 0.01), (0.5, -0.3, 0.002), (1.0, 5.0, 0.05)] {
            let body = resisted(shape, mass, 0.0, resistance * (1.0 + damage));
            let rate = resistance * G / (1.0 + shape);
            let (stop, way) = (f64::abs(speed) / rate, 0.5 * speed * f64::abs(speed) / rate);
            let motion = motion_within(&body, 1e-12, rolling(speed), 2.0 * stop).unwrap();
            assert_eq!(motion.events().len(), 1, "{:?}", motion.events());
            let end = motion.event("body stops").unwrap();
            errors.add(end.t, stop, stop);
            errors.add(end.before.q[0], way, way.abs());
            let rest = motion.at(2.0 * stop).unwrap();
            errors.add(rest.q[0], way, way.abs());
            assert!(rest.v.iter().all(|v| v.abs() < 1e-14 * speed.abs()));
            assert_eq!(motion.modes(2.0 * stop).unwrap(), [Mode::Stick; 2]);
            // Energy: what is gone is C_rr N over the way.
            let lost = 0.5 * mass * (1.0 + shape) * speed * speed;
            errors.add(resistance * mass * G * end.before.q[0].abs(), lost, lost);
        }
    }
    errors
}

#[test]
fn a_rolling_body_slows_down_evenly_and_stops() {
    assert_largest!(stops(0.0), 36, @"3.00");
    assert!(stops(1e-9).largest() > 1e5);
}

/// A body at rest begins to roll where tan(slope) exceeds C_rr, and not below; up a slope it
/// stops and, where that is steep enough, comes back.
#[test]
fn it_holds_on_a_gentle_slope() {
    let mut errors = Errors::in_units_of(EPS, "up and down a slope");
    for shape in [0.4, 1.0] {
        for resistance in [0.01, 0.1] {
            for (part, rolls) in [(0.999_999, false), (1.000_001, true), (3.0, true)] {
                let slope = rotation_dynamics::math::atan2(part * resistance, 1.0);
                let body = resisted(shape, 2.0, slope, resistance);
                let held = entry(&body, MechanismState::rest([0.0, 0.1, 0.0])).unwrap().0[1]
                    == Mode::Stick;
                assert_eq!(held, !rolls, "{shape} {resistance} {part}");
                let up = (sin(slope) + resistance * cos(slope)) * G / (1.0 + shape);
                let motion = motion_within(&body, 1e-12, rolling(1.0), 3.0 / up).unwrap();
                let names: Vec<_> = motion.events().iter().map(|e| e.name.as_str()).collect();
                assert_eq!(names, [if rolls { "body reverses" } else { "body stops" }]);
                errors.add(motion.events()[0].t, 1.0 / up, 1.0 / up);
                let down = (sin(slope) - resistance * cos(slope)).max(0.0) * G / (1.0 + shape);
                let back = if rolls { -2.0 * down / up } else { 0.0 };
                errors.push(motion.at(3.0 / up).unwrap().v[0] - back);
            }
        }
    }
    assert_largest!(errors, 24, @"4");
}

/// A ball set down spinning slips, rolls and stops: friction and resistance together.
#[test]
fn it_slips_then_rolls_then_stops() {
    let (shape, resistance, spin) = (0.4, 0.02, -70.0);
    let body = resisted(shape, 1.0, 0.0, resistance);
    let start = MechanismState { q: [0.0, 0.1, 0.0], v: [0.0, 0.0, spin] };
    let motion = motion_within(&body, 1e-12, start, 60.0).unwrap();
    let names: Vec<_> = motion.events().iter().map(|e| e.name.as_str()).collect();
    assert_eq!(names, ["floor sticks", "body stops"]);
    // Slipping: R omega falls by (mu + C_rr) g/k, v grows by mu g.
    let slip = 7.0 / (0.6 * G + (0.6 + resistance) * G / shape);
    let stop = slip + 0.6 * G * slip * (1.0 + shape) / (resistance * G);
    let mut errors = Errors::in_units_of(EPS, "times of both");
    errors.add(motion.event("floor sticks").unwrap().t, slip, slip);
    errors.add(motion.event("body stops").unwrap().t, stop, stop);
    assert_largest!(errors, 2, @"2.24");
}

/// A ball that jumps has no rolling resistance in the air; where it lands it has.
#[test]
fn in_the_air_it_resists_nothing() {
    let body = resisted(0.4, 1.0, 0.0, 0.05);
    let start = MechanismState { q: [0.0, 0.1 + 0.5 * G, 0.0], v: [0.0, 0.0, -3.0] };
    let motion = motion_within(&body, 1e-12, start, 2.0).unwrap();
    assert_eq!(motion.modes(0.5).unwrap(), [Mode::Open; 2]);
    let lands = motion.event("floor touches").unwrap();
    support::assert_error!(lands.t, 1.0, 0.0 eps);
    assert_eq!(lands.before.v[2], -3.0);
    assert!(motion.at(2.0).unwrap().v[2].abs() < 1e-12, "it has stopped");
}

#[test]
fn what_resists_nothing_that_pushes_is_refused() {
    struct Wrong(usize, f64);
    impl Mechanism<3, 2> for Wrong {
        fn mass(&self, _: &[f64; 3]) -> [[f64; 3]; 3] {
            [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 0.004]]
        }
        fn force(&self, _: &MechanismState<3>) -> [f64; 3] {
            [0.0, -G, 0.0]
        }
        fn contacts(&self, body: &MechanismState<3>) -> [Contact<3>; 2] {
            let rim = Contact::rim("floor", body, 0.1, Surface::FLOOR);
            [rim, Contact::rolling("ball", self.0, 0.1, self.1)]
        }
    }
    let told = |by, coefficient| {
        let start = MechanismState::rest([0.0, 0.1, 0.0]);
        entry(&Wrong(by, coefficient), start).map(|_| ())
    };
    told(0, 0.0).expect("no resistance");
    for by in [1, 2, 100] {
        let error = told(by, 0.01).unwrap_err();
        assert!(error.to_string().contains("place of the contact that presses"), "{error}");
    }
    for coefficient in [-0.01, f64::NAN, f64::INFINITY] {
        assert!(told(0, coefficient).is_err());
    }
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(LinearDrag::new(bad).is_err() && QuadraticDrag::new(bad).is_err());
        assert!(LinearSpinDrag::new(bad).is_err() && QuadraticSpinDrag::new(bad).is_err());
        assert!(QuadraticDrag::in_air(1.2, bad, 0.1).is_err());
    }
    let error = QuadraticDrag::in_air(1.2, 0.5, -0.1).unwrap_err();
    assert!(matches!(error, Error::OutOfRange { name: "frontal area", .. }), "{error}");
}

/// A stone in free fall.
#[derive(Clone, Copy)]
struct Stone;

impl Mechanism<3, 0> for Stone {
    fn mass(&self, _: &[f64; 3]) -> [[f64; 3]; 3] {
        [[2.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 0.3]]
    }
    fn force(&self, _: &MechanismState<3>) -> [f64; 3] {
        [0.0, -2.0 * G, 0.0]
    }
    fn contacts(&self, _: &MechanismState<3>) -> [Contact<3>; 0] {
        []
    }
}

fn tanh(x: f64) -> f64 {
    let e = exp(2.0 * x);
    (e - 1.0) / (e + 1.0)
}

/// Falls and turns with each drag, in closed form; the damaged twin has a little more of it.
fn drags(damage: f64) -> Errors {
    let mut errors = Errors::in_units_of(EPS, "speeds with drag");
    let more = 1.0 + damage;
    for c in [0.01, 0.3, 4.0] {
        for t in [0.1, 1.0, 5.0] {
            let start = MechanismState { q: [0.0; 3], v: [0.0, 0.0, 7.0] };
            let falls = Stone.with(QuadraticDrag::new(c * more).unwrap());
            let last = (2.0 * G / c).sqrt();
            let end = motion_within(&falls, 1e-13, start, t).unwrap().at(t).unwrap();
            errors.add(end.v[1], -last * tanh(G * t / last), last);
            assert_eq!(end.v[2], 7.0);
            let sinks = Stone.with(LinearDrag::new(c * more).unwrap());
            let end = motion_within(&sinks, 1e-13, start, t).unwrap().at(t).unwrap();
            let want = -2.0 * G / c * (1.0 - exp(-0.5 * c * t));
            errors.add(end.v[1], want, want.abs());
            let turns = Stone.with(LinearSpinDrag::new(c * more).unwrap());
            let end = motion_within(&turns, 1e-13, start, t).unwrap().at(t).unwrap();
            errors.add(end.v[2], 7.0 * exp(-c / 0.3 * t), 7.0);
            let paddles = Stone.with(QuadraticSpinDrag::new(c * more).unwrap());
            let end = motion_within(&paddles, 1e-13, start, t).unwrap().at(t).unwrap();
            errors.add(end.v[2], 7.0 / (1.0 + 7.0 * c / 0.3 * t), 7.0);
        }
    }
    errors
}

/// Time and speed at the end of a way through air, from the law of the time, v = w tanh(a t/w) with
/// the last speed w; the twin meets a little more drag.
fn driven(damage: f64) -> Errors {
    let mut errors = Errors::in_units_of(EPS, "time and speed at the end of a way");
    for c in [1e-9, 0.01, 0.3, 4.0] {
        for part in [1e-6, 1e-3, 0.1, 1.0, 5.0] {
            let (drag, last) =
                (QuadraticDrag::new(c * (1.0 + damage)).unwrap(), (2.0 * G / c).sqrt());
            let half = rotation_dynamics::math::sinh(0.5 * part);
            let way = last * last / G * rotation_dynamics::math::log1p(2.0 * half * half);
            let [time, speed] = drag.driven(G, 2.0, way);
            let (at, fast) = (part * last / G, last * rotation_dynamics::math::tanh(part));
            errors.add(time, at, at);
            errors.add(speed, fast, fast);
        }
    }
    errors
}

#[test]
fn what_is_driven_through_air_ends_as_the_law_of_the_time_says() {
    assert_largest!(driven(0.0), 40, @"2.31");
    assert!(driven(1e-9).largest() > 1e5);
}

#[test]
fn drags_follow_their_closed_forms() {
    assert_largest!(drags(0.0), 36, @"370");
    assert!(drags(1e-9).largest() > 1e5);
}

/// All four at once: the energy changes by their powers.
#[test]
fn the_energy_goes_where_the_power_says() {
    let c = [0.2, 0.05, 0.01, 0.02];
    let loads = Stone
        .with(LinearDrag::new(c[0]).unwrap())
        .with(QuadraticDrag::new(c[1]).unwrap())
        .with(LinearSpinDrag::new(c[2]).unwrap())
        .with(QuadraticSpinDrag::new(c[3]).unwrap());
    let start = MechanismState { q: [0.0; 3], v: [3.0, 4.0, -7.0] };
    let motion = motion_within(&loads, 1e-13, start, 2.0).unwrap();
    let energy = |t: f64| {
        let MechanismState { q, v } = motion.at(t).unwrap();
        v[0] * v[0] + v[1] * v[1] + 0.15 * v[2] * v[2] + 2.0 * G * q[1]
    };
    let power = |t: f64| {
        let state = motion.at(t).unwrap();
        let [vx, vy, rate] = state.v;
        let speed = rotation_dynamics::math::hypot(vx, vy);
        // As each law says it, by hand.
        let ours =
            -(c[0] + c[1] * speed) * speed * speed - (c[2] + c[3] * rate.abs()) * rate * rate;
        let theirs = loads.load().power(&state)
            + loads.mechanism().load().power(&state)
            + loads.mechanism().mechanism().load().power(&state)
            + loads.mechanism().mechanism().mechanism().load().power(&state);
        assert!((ours - theirs).abs() < 1e-12 * ours.abs());
        ours
    };
    let (mut errors, mut damaged) =
        (Errors::of("slope of the energy"), Errors::of("without a drag"));
    for t in [0.3, 0.9, 1.7] {
        let slope = derivative(energy, t, 1e-2);
        errors.add(slope, power(t), power(t).abs());
        let rate = motion.at(t).unwrap().v[2];
        damaged.add(slope, power(t) + c[2] * rate * rate, power(t).abs());
    }
    assert_largest!(errors, 3, @"6.39e-8");
    damaged.exceed(1e-4, 3);
}

/// A mechanism without a resistance has the bits it had: one with a resistance of 0 has them too,
/// where the resistance has its own equations.
#[test]
fn what_is_absent_changes_no_bit() {
    let start = MechanismState { q: [0.0, 0.1, 0.0], v: [1.0, 0.0, 50.0] };
    let round = || Round { mass: 1.0, shape: 0.4, radius: 0.1, mu: 0.6 };
    let plain = motion_within(round(), 1e-12, start, 1.0).unwrap();
    let none = motion_within(resisted(0.4, 1.0, 0.0, 0.0), 1e-12, start, 1.0).unwrap();
    let apart = |t: f64| {
        let (a, b) = (plain.at(t).unwrap(), none.at(t).unwrap());
        (0..3).map(|i| (a.v[i] - b.v[i]).abs()).fold(0.0, f64::max)
    };
    assert!(apart(0.2) < 1e-14 && apart(0.9) < 1e-14);
    // In size, too: the drag is a field of the type that has it.
    assert_eq!(size_of::<Stone>(), 0);
    assert_eq!(size_of_val(&Stone.with(LinearDrag::new(1.0).unwrap())), size_of::<f64>());
}
