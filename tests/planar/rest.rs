//! Bodies that bounce to rest: infinitely many bounces in a finite time.

use super::G;
use rotation_dynamics::integrators::Dop853;
use rotation_dynamics::math::{atan, sincos};
use rotation_dynamics::planar::contact::{
    Contact, Mechanism, MechanismState, Mode, Surface, motion, motion_within,
};
use support::{EPS, Errors, Random, assert_largest};

fn method() -> Dop853 {
    Dop853::new(1e-12).unwrap()
}

/// A particle between a floor and a ceiling, by its height.
struct Particle {
    restitution: f64,
    ceiling: f64,
}

impl Mechanism<1, 2> for Particle {
    fn mass(&self, _: &[f64; 1]) -> [[f64; 1]; 1] {
        [[1.0]]
    }
    fn force(&self, _: &MechanismState<1>) -> [f64; 1] {
        [-G]
    }
    fn contacts(&self, particle: &MechanismState<1>) -> [Contact<1>; 2] {
        let [y] = particle.q;
        [
            Contact::new("floor", y, [1.0], 0.0),
            Contact::new("ceiling", self.ceiling - y, [-1.0], 0.0),
        ]
        .map(|plate| plate.restitution(self.restitution))
    }
    fn phase_limit(&self) -> usize {
        2000
    }
}

/// A uniform sphere on an incline: x down the slope, y off it.
struct Ball {
    radius: f64,
    /// Its moment of inertia over m R^2.
    shape: f64,
    mu: f64,
    restitution: f64,
    slope: f64,
}

impl Ball {
    const fn new(radius: f64, mu: f64, restitution: f64) -> Self {
        Self { radius, shape: 0.4, mu, restitution, slope: 0.0 }
    }
}

impl Mechanism<3, 1> for Ball {
    fn mass(&self, _: &[f64; 3]) -> [[f64; 3]; 3] {
        let inertia = self.shape * self.radius * self.radius;
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, inertia]]
    }
    fn force(&self, _: &MechanismState<3>) -> [f64; 3] {
        let (s, c) = sincos(self.slope);
        [G * s, -G * c, 0.0]
    }
    fn contacts(&self, ball: &MechanismState<3>) -> [Contact<3>; 1] {
        let floor = Contact::rim("floor", ball, self.radius, Surface::FLOOR);
        [floor.friction(self.mu).restitution(self.restitution)]
    }
    fn phase_limit(&self) -> usize {
        2000
    }
}

/// Errors of the time of rest after a fall from rest, if the restitution is off by the part
/// `damage`: of a particle whose coordinate is its gap, and of balls.
fn limits(restitutions: &[f64], damage: f64) -> [Errors; 3] {
    let mut particle = Errors::in_units_of(EPS, "limit time of a particle");
    let mut small = Errors::of("limit time of a ball of 0.1 m");
    let mut large = Errors::of("limit time of a ball of 1 m");
    for &restitution in restitutions {
        for height in [0.3, 1.0, 4.0] {
            let fall = f64::sqrt(2.0 * height / G);
            let limit = fall * (1.0 + restitution) / (1.0 - restitution);
            let off = restitution * (1.0 + damage);
            let plates = Particle { restitution: off, ceiling: 10.0 };
            let rests =
                motion(&plates, &method(), MechanismState::rest([height]), 1.1 * limit).unwrap();
            particle.add(rests.event("floor rests").unwrap().t, limit, limit);
            assert_eq!(rests.at(1.1 * limit).unwrap(), MechanismState::rest([0.0]));
            for (radius, errors) in [(0.1, &mut small), (1.0, &mut large)] {
                let ball = Ball::new(radius, 0.2, off);
                let start = MechanismState::rest([0.0, radius + height, 0.0]);
                let rests = motion(ball, &method(), start, 1.1 * limit).unwrap();
                let [.., touches, rest] = rests.events() else { panic!("{:?}", rests.events()) };
                assert_eq!([&touches.name, &rest.name], ["floor touches", "floor rests"]);
                assert!(touches.t < rest.t);
                errors.add(rest.t, limit, limit);
            }
        }
    }
    [particle, small, large]
}

/// sqrt(2 h/g) (1 + 2 e + 2 e^2 + ...) = sqrt(2 h/g) (1 + e)/(1 - e).
#[test]
fn a_fall_ends_at_the_limit_of_its_bounces() {
    let [particle, small, large] = limits(&[0.01, 0.1, 0.3, 0.5, 0.7, 0.9, 0.99], 0.0);
    assert_largest!(particle, 21, @"358");
    assert_largest!(small, 21, @"1.37e-11");
    assert_largest!(large, 21, @"2.06e-9");
    for damaged in limits(&[0.5], 1e-6) {
        damaged.exceed(1e-8, 3);
    }
}

/// Errors of the time of rest in parts of the error that was asked for, if the restitution is off by
/// the part `damage`; and of the speed after.
fn promised(damage: f64) -> [Errors; 2] {
    let mut times = Errors::of("limit time, in parts of the tolerance");
    let mut speeds = Errors::of("speed after it, in parts of the tolerance");
    for tolerance in [1e-3, 1e-6, 1e-9] {
        for restitution in [0.1, 0.5, 0.9] {
            let fall = f64::sqrt(2.0 / G);
            let limit = fall * (1.0 + restitution) / (1.0 - restitution);
            let start = MechanismState { q: [0.0, 1.1, 0.0], v: [2.0, 0.0, 0.0] };
            let ball = Ball::new(0.1, 0.05, restitution * (1.0 + damage));
            let found = motion_within(ball, tolerance, start, 2.0 * limit + 2.0).unwrap();
            let (rest, end) = (found.event("floor rests").unwrap(), found.end_time());
            times.push((rest.t - limit) / end / tolerance);
            speeds.push((found.at(end).unwrap().v[0] - 10.0 / 7.0) / tolerance);
        }
    }
    [times, speeds]
}

#[test]
fn what_is_promised_is_kept() {
    let [times, speeds] = promised(0.0);
    assert_largest!(times, 9, @"8.56e-4");
    assert_largest!(speeds, 9, @"2.22e-7");
    let [times, speeds] = promised(-0.09);
    times.exceed(1.0, 9);
    // The speed depends on no restitution.
    assert!(speeds.largest() < 1e-6);
}

/// Place and speed of a ball that falls from `height` and rolls in the end, at `t_end`: bounce after
/// bounce with the impulses of Coulomb, per unit mass.
fn bounced(ball: &Ball, [height, mut v, mut slip]: [f64; 3], t_end: f64) -> [f64; 2] {
    let mut down = (2.0 * G * height).sqrt();
    let (mut t, mut x) = (down / G, v * down / G);
    let rub = |v: &mut f64, slip: &mut f64, most: f64| {
        // The slip changes by 1 + m R^2/I = 7/2 of the speed.
        let change = -f64::copysign(most.min(2.0 / 7.0 * slip.abs()), *slip);
        *v += change;
        *slip += 3.5 * change;
    };
    while down > 1e-20 {
        rub(&mut v, &mut slip, ball.mu * (1.0 + ball.restitution) * down);
        down *= ball.restitution;
        (t, x) = (t + 2.0 * down / G, x + v * 2.0 * down / G);
    }
    let slides = slip.abs() / (3.5 * ball.mu * G);
    let before = v;
    rub(&mut v, &mut slip, f64::INFINITY);
    assert!(t + slides < t_end);
    [x + 0.5 * (before + v) * slides + v * (t_end - t - slides), v]
}

/// Speed and place of so many balls that roll in the end, if their inertia is off by the part
/// `damage`.
fn rolled(balls: usize, damage: f64) -> [Errors; 2] {
    let mut speeds = Errors::in_units_of(EPS, "speed of a ball that rolls after a fall");
    let mut places = Errors::in_units_of(EPS, "its place");
    let mut random = Random(5);
    let mut slid = 0;
    for _ in 0..balls {
        let ball = Ball {
            shape: 0.4 * (1.0 + damage),
            ..Ball::new(random.size(0.03, 3.0), random.size(0.01, 1.0), random.between(0.0, 0.95))
        };
        let [height, v] = [random.size(0.01, 3.0), random.between(-3.0, 3.0)];
        let turns = random.between(-3.0, 3.0);
        let start = MechanismState {
            q: [0.0, ball.radius + height, 0.0],
            v: [v, 0.0, turns / ball.radius],
        };
        let bounces =
            (2.0 * height / G).sqrt() * (1.0 + ball.restitution) / (1.0 - ball.restitution);
        let end = bounces + (v + turns).abs() / (3.5 * ball.mu * G) + 0.1;
        let found = motion(&ball, &method(), start, end).unwrap();
        let last = found.at(end).unwrap();
        let [x, rolls] = bounced(&ball, [height, v, v + turns], end);
        let size = v.abs() + turns.abs();
        // About the point of contact nothing turns it.
        speeds.add(last.v[0], 5.0 / 7.0 * v - 2.0 / 7.0 * turns, size);
        speeds.add(rolls, 5.0 / 7.0 * v - 2.0 / 7.0 * turns, size);
        places.add(last.q[0], x, 1.0 + size * end);
        assert_eq!(found.modes(end).unwrap(), [Mode::Stick]);
        slid += usize::from(found.events().last().unwrap().name == "floor sticks");
    }
    assert!((balls / 6..balls * 5 / 6).contains(&slid), "{slid} of {balls}");
    [speeds, places]
}

/// However it falls, a uniform sphere rolls at 5/7 of its speed, and 2/7 of that of its rim.
#[test]
fn after_any_fall_a_ball_rolls_at_five_sevenths() {
    let [speeds, places] = rolled(300, 0.0);
    assert_largest!(speeds, 600, @"5.95");
    assert_largest!(places, 300, @"13.3");
    let [speeds, places] = rolled(30, 1e-6);
    assert!(speeds.largest() > 1e6 && places.largest() > 1e6);
}

/// Errors of the times at a floor and a ceiling, where the particle returns too much by the part
/// `damage`.
fn between_plates(damage: f64) -> Errors {
    let mut errors = Errors::in_units_of(EPS, "times between two plates");
    let (ceiling, e) = (1.0, 0.9);
    let plates = Particle { restitution: e * (1.0 + damage), ceiling };
    let start = MechanismState { q: [0.0], v: [10.0] };
    let found = motion(&plates, &method(), start, 20.0).unwrap();
    let (mut t, mut up) = (0.0, 10.0);
    let mut events = found.events().iter();
    while up * up > 2.0 * G * ceiling {
        let top = f64::sqrt(up * up - 2.0 * G * ceiling);
        let down = f64::sqrt(e * e * top * top + 2.0 * G * ceiling);
        for (name, lasts) in [
            ("ceiling bounces", 2.0 * ceiling / (up + top)),
            ("floor bounces", 2.0 * ceiling / (down + e * top)),
        ] {
            t += lasts;
            let event = events.next().unwrap();
            assert_eq!(event.name, name);
            errors.add(event.t, t, t);
        }
        up = e * down;
    }
    let limit = t + 2.0 * up / (G * (1.0 - e));
    let rests = found.events().last().unwrap();
    assert_eq!(rests.name, "floor rests");
    errors.add(rests.t, limit, limit);
    errors
}

#[test]
fn a_ball_between_two_plates_ends_on_the_lower_one() {
    assert_largest!(between_plates(0.0), 13, @"10.4");
    assert!(between_plates(1e-12).largest() > 1e2);
}

/// Speeds and spins of a superball after two bounces, the first of which slips and the second of which
/// does not, with an inertia off by the part `damage`.
fn superball(damage: f64) -> Errors {
    let mut errors = Errors::in_units_of(EPS, "superball");
    for (mu, slip) in [(0.1, 4.0), (0.15, -6.0), (0.3, 12.0)] {
        let down = f64::sqrt(2.0 * G);
        let ball = Ball { shape: 0.4 * (1.0 + damage), ..Ball::new(0.1, mu, 1.0) };
        let start = MechanismState { q: [0.0, 1.1, 0.0], v: [1.0, 0.0, (slip - 1.0) / 0.1] };
        let fall = down / G;
        let found = motion(&ball, &method(), start, 4.0 * fall).unwrap();
        let [first, second] = found.events() else { panic!("{:?}", found.events()) };
        errors.add(second.t, 3.0 * fall, 3.0 * fall);
        // Friction gives all it can, 2 mu times the speed of the fall; then the rest of the slip is
        // too little for it, and 2/7 of that is taken.
        let given = -f64::copysign(2.0 * mu * down, slip);
        let left = slip + 3.5 * given;
        assert!(left * slip > 0.0 && 2.0 / 7.0 * left.abs() < 2.0 * mu * down);
        let sticks = given - 2.0 / 7.0 * left;
        for (event, change) in [(first, given), (second, sticks)] {
            let want = [1.0 + change, down, start.v[2] + change * 0.1 / 0.004];
            for (got, want) in event.after.v.into_iter().zip(want) {
                errors.add(got, want, 1.0 + want.abs());
            }
        }
    }
    errors
}

/// Elastic, and rough: it keeps its height, and rolls off its second bounce.
#[test]
fn a_superball_slips_once() {
    assert_largest!(superball(0.0), 21, @"5.74");
    assert!(superball(1e-9).largest() > 1e5);
}

/// Speed and place of balls that roll down an incline after a fall onto it, with an inertia off by the
/// part `damage`.
fn inclined(damage: f64) -> Errors {
    let mut errors = Errors::in_units_of(EPS, "speed down the incline");
    for restitution in [0.1, 0.5, 0.8] {
        for slope in [0.1, 0.3, 0.5] {
            for v in [-2.0, 0.0, 3.0] {
                let ball =
                    Ball { shape: 0.4 * (1.0 + damage), slope, ..Ball::new(0.1, 0.5, restitution) };
                let start = MechanismState { q: [0.0, 0.6, 0.0], v: [v, 0.0, 5.0] };
                let found = motion(&ball, &method(), start, 8.0).unwrap();
                assert!(found.event("floor rests").is_ok());
                assert_eq!(found.modes(8.0).unwrap(), [Mode::Stick]);
                // v - (2/5) R omega grows as g sin(slope) t, whatever touches.
                let want = 5.0 / 7.0 * (v - 0.4 * 0.1 * 5.0 + G * sincos(slope).0 * 8.0);
                errors.add(found.at(8.0).unwrap().v[0], want, want.abs());
            }
        }
    }
    errors
}

#[test]
fn a_ball_thrown_on_an_incline_rolls_down() {
    assert_largest!(inclined(0.0), 27, @"15.5");
    inclined(1e-9).exceed(1e5, 27);
}

/// A flat rod of 2 m and 1 kg whose two ends meet a floor.
struct Rod {
    mu: f64,
    restitution: f64,
    /// The least size of its coordinates (m), by which bounces count as too low to be seen.
    size: f64,
}

impl Mechanism<3, 2> for Rod {
    fn mass(&self, _: &[f64; 3]) -> [[f64; 3]; 3] {
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0 / 3.0]]
    }
    fn force(&self, _: &MechanismState<3>) -> [f64; 3] {
        [0.0, -G, 0.0]
    }
    fn contacts(&self, rod: &MechanismState<3>) -> [Contact<3>; 2] {
        let (s, c) = sincos(rod.q[2]);
        [("left", [-c, -s]), ("right", [c, s])].map(|(name, arm)| {
            Contact::corner(name, rod, arm, Surface::FLOOR)
                .friction(self.mu)
                .restitution(self.restitution)
        })
    }
    fn scale(&self, state: &MechanismState<3>) -> MechanismState<3> {
        MechanismState {
            q: [1.0f64.max(state.q[0].abs()), self.size, self.size],
            v: state.v.map(|v| v.abs().max(1.0)),
        }
    }
}

/// Speed and place of rods that have come to lie flat and slide, with friction off by the part
/// `damage`.
fn rattled(damage: f64) -> Errors {
    let mut errors = Errors::in_units_of(EPS, "speed and place of a rod that has rattled to rest");
    for restitution in [0.0, 0.2, 0.5, 0.7] {
        for tilt in [0.01, 0.1, 0.3] {
            let mu = 0.1;
            let rod = Rod { mu: mu * (1.0 + damage), restitution, size: 1.0 };
            let start = MechanismState { q: [0.0, 1.0, tilt], v: [20.0, 0.0, 0.0] };
            let end = 6.0;
            let found = motion(&rod, &method(), start, end).unwrap();
            let rests = found.events().last().unwrap();
            let name = if restitution > 0.0 { "rests" } else { "touches" };
            assert!(rests.name.ends_with(name), "{rests:?}");
            let last = found.at(end).unwrap();
            // All of friction is mu times all of the push: x'' = -mu (y'' + g).
            let speed = 20.0 - mu * G * end;
            let place = 20.0 * end - mu * (0.5 * G * end * end - 1.0);
            errors.add(last.v[0], speed, 20.0);
            errors.add(last.q[0], place, 20.0 * end);
            for off in [last.q[1], last.q[2], last.v[1], last.v[2]] {
                errors.push(off);
            }
        }
    }
    errors
}

/// However its ends bounce, one after the other.
#[test]
fn a_rod_rattles_to_rest() {
    assert_largest!(rattled(0.0), 72, @"12.8");
    assert!(rattled(1e-9).largest() > 1e5);
}

/// Where the bounces are taken together, below 1e-12 or 1e-14 m, does not move the time of rest.
#[test]
fn the_time_of_rest_is_that_of_bounces_a_hundred_times_lower() {
    let mut rests = Errors::of("time of rest (s)");
    let mut touches = Errors::of("time of the last touch (s)");
    for restitution in [0.2, 0.5, 0.7] {
        for tilt in [0.01, 0.1, 0.3] {
            let times = |size| {
                let rod = Rod { mu: 0.1, restitution, size };
                let start = MechanismState { q: [0.0, 1.0, tilt], v: [20.0, 0.0, 0.0] };
                let found = motion(&rod, &method(), start, 6.0).unwrap();
                ["rests", "touches"].map(|what| {
                    let mut events = found.events().iter().rev();
                    events.find(|e| e.name.ends_with(what)).unwrap().t
                })
            };
            let [[rest, touch], [later_rest, later_touch]] = [1.0, 0.01].map(times);
            rests.push_at(rest - later_rest, (restitution, tilt));
            touches.push(touch - later_touch);
        }
    }
    assert_largest!(rests, 9, @"2.44e-15");
    // The damaged twin: without the sum of what follows.
    touches.exceed(1e-7, 9);
}

/// A block on a rough floor, as high as 4 and as wide as 1 m; it rocks on its corners.
struct Block;
const ACROSS: [f64; 2] = [0.5, 2.0];

impl Mechanism<3, 2> for Block {
    fn mass(&self, _: &[f64; 3]) -> [[f64; 3]; 3] {
        let [b, h] = ACROSS;
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, (b * b + h * h) / 3.0]]
    }
    fn force(&self, _: &MechanismState<3>) -> [f64; 3] {
        [0.0, -G, 0.0]
    }
    fn contacts(&self, block: &MechanismState<3>) -> [Contact<3>; 2] {
        let ((s, c), [b, h]) = (sincos(block.q[2]), ACROSS);
        [("left", -b), ("right", b)].map(|(name, x)| {
            let arm = [c * x + s * h, s * x - c * h];
            Contact::corner(name, block, arm, Surface::FLOOR).friction(0.9)
        })
    }
}

/// From corner to corner the rate of a block falls by 1 - (3/2) sin^2 of the angle of its diagonal, and
/// the times between by the same part in the end: it comes to rest where they sum to.
#[test]
fn a_block_rocks_to_rest() {
    let [b, h] = ACROSS;
    let (tilt, (s, c)) = (0.05, sincos(0.05));
    // On its right corner, which is at 0.
    let start = MechanismState::rest([-c * b + s * h, s * b + c * h, -tilt]);
    let found = motion(&Block, &method(), start, 20.0).unwrap();
    let (diagonal, _) = sincos(atan(b / h));
    let part = 1.0 - 1.5 * diagonal * diagonal;
    let touches: Vec<_> =
        found.events().iter().filter(|event| event.name.ends_with("touches")).collect();
    let mut rates = Errors::in_units_of(EPS, "rate after a corner touches");
    let mut wider = Errors::in_units_of(EPS, "the rate of a block that is a little wider");
    let last = touches.len() - 1;
    for touch in &touches[..last] {
        let want = part * touch.before.v[2];
        rates.add(touch.after.v[2], want, want.abs());
        wider.add(touch.after.v[2], want * (1.0 + 1e-10), want.abs());
    }
    assert_largest!(rates, 127, @"294");
    wider.exceed(1e5, 127);
    // The last touch is that from which it does not get up; after it the times go on as before.
    let step = touches[last].t - touches[last - 1].t;
    let want = touches[last].t + step * part / (1.0 - part);
    let rests = found.events().last().unwrap();
    assert!(rests.name == "left rests" || rests.name == "right rests");
    assert!((rests.t - want).abs() < 1e-9);
    // The damaged twin: each corner for itself, as if it touched no more.
    assert!((touches[last].t + step - want).abs() > 1e-6);
    assert_eq!(found.modes(20.0).unwrap(), [Mode::Stick; 2]);
    let end = found.at(20.0).unwrap();
    assert!(end.q[2].abs() < 1e-15 && (end.q[1] - h).abs() < 1e-14, "{end:?}");
    assert_eq!(end.v, [0.0; 3]);
}
