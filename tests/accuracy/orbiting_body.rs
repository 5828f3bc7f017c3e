//! A body on a given Kepler orbit: the orbit against 32 digits, the torque against what is
//! known, claims, the passage of a pericentre, the mean.

use super::effects::tilted;
use super::twin::{KEEPS_ENERGY, NOT_ON_TIME, Twin, refused};
use core::f64::consts::{PI, TAU};
use rotation_dynamics::Result;
use rotation_dynamics::accuracy::Limits;
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::{
    Effect, Feature, GravityGradient, KeplerOrbit, OrbitingBody, Properties, check,
};
use rotation_dynamics::frame::SpaceVector;
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::{Dop853, Integrator, ode, size_or};
use rotation_dynamics::math::{EPS, cos, sin, sincos};
use rotation_dynamics::motion::Motion;
use rotation_dynamics::scene::Scene;
use support::{Errors, assert_error, assert_largest, derivative};

/// Eccentricity, time, x and y, in units of the pericentre and its rate (tests/data/kepler.py).
fn reference() -> Vec<[f64; 4]> {
    let lines = include_str!("../data/kepler.txt").lines();
    let row = |line: &str| {
        let mut numbers = line.split(' ').map(|n| n.parse().expect("a number"));
        core::array::from_fn(|_| numbers.next().expect("four numbers"))
    };
    lines.map(row).collect()
}

/// Errors of places over their distance and what an eps of the time moves the body, in eps.
fn against_reference(place: impl Fn(f64, f64) -> [f64; 2]) -> Errors {
    let mut errors = Errors::in_units_of(EPS, "place");
    for [e, tau, x, y] in reference() {
        let [a, b] = place(e, tau);
        let r = x.hypot(y);
        let speed = (2.0 / r - (1.0 - e)).max(0.0).sqrt();
        errors.push_at((a - x).hypot(b - y) / (r + speed * tau.abs()), (e, tau));
    }
    errors
}

#[test]
fn keplers_equation_is_solved_to_rounding_for_every_eccentricity() {
    let ours = against_reference(|e, tau| {
        let orbit = KeplerOrbit::about(1.0, 1.0, e).expect("an orbit");
        let place = orbit.place(tau);
        assert_eq!(place.z(), 0.0);
        [place.x(), place.y()]
    });
    assert_largest!(ours, 252, @"7.87");
    // The classical form on ellipses and hyperbolas: good away from the parabola only.
    let classical = against_reference(|e, tau| {
        let size = (1.0 - e).abs();
        let mean = tau * size * size.sqrt();
        let mut at = if e < 1.0 { mean + e * sin(mean) } else { (mean / e).asinh() };
        for _ in 0..60 {
            let (f, slope) = if e < 1.0 {
                (at - e * sin(at) - mean, 1.0 - e * cos(at))
            } else {
                (e * at.sinh() - at - mean, e * at.cosh() - 1.0)
            };
            at -= f / slope;
        }
        let across = ((1.0 - e) * (1.0 + e)).abs().sqrt();
        if e < 1.0 {
            [(cos(at) - e) / size, across * sin(at) / size]
        } else {
            [(e - at.cosh()) / size, across * at.sinh() / size]
        }
    });
    let worst = classical.largest();
    assert!(worst.is_nan() || worst > 1e6, "{worst:e}");
}

/// Ellipses come again: for a hundred thousand periods the place is that of the remainder.
#[test]
fn a_closed_orbit_comes_again() {
    let mut errors = Errors::of("place after many periods");
    for e in [0.0, 0.3, 0.9, 0.999] {
        let orbit = KeplerOrbit::elliptic(2.0, 8.0, e).expect("an orbit");
        // The times are exact.
        for t in [0.0, 1.0, 3.0, 7.0] {
            let later = 8.0 * 100_000.0;
            errors.push((orbit.place(t + later) - orbit.place(t)).norm());
            errors.push((orbit.place(t - later) - orbit.place(t)).norm());
        }
    }
    assert_largest!(errors, 32, @"0");
}

fn moon() -> KeplerOrbit {
    KeplerOrbit::elliptic(3.0, 7.0, 0.4)
        .and_then(|orbit| orbit.oriented(0.7, 0.5, -1.1))
        .and_then(|orbit| orbit.turning(-0.05, 0.08))
        .and_then(|orbit| orbit.passing_at(1.3))
        .expect("an orbit")
}

fn flyby() -> KeplerOrbit {
    KeplerOrbit::about(2.0, 1.2, 1.5)
        .and_then(|orbit| orbit.oriented(2.0, 1.1, 0.3))
        .and_then(|orbit| orbit.passing_at(5.0))
        .expect("an orbit")
}

/// The velocity is the derivative of the place, the acceleration Kepler's.
#[test]
fn the_velocity_is_the_derivative_of_the_place() {
    let (mut errors, mut forces) = (Errors::of("velocity"), Errors::of("acceleration"));
    let mut damaged = Errors::of("without the turning");
    for i in 0..40 {
        let (t, h) = (0.37 * f64::from(i), 1e-3);
        for (orbit, gm) in [(moon(), None), (flyby(), Some(2.0))] {
            let at = |k: f64| orbit.place(t + k * h);
            let slope = ((at(1.0) - at(-1.0)) * 8.0 - (at(2.0) - at(-2.0))) / (12.0 * h);
            let size = orbit.velocity(t).norm();
            errors.push((orbit.velocity(t) - slope).norm() / size);
            if let Some(gm) = gm {
                let v = |k: f64| orbit.velocity(t + k * h);
                let force = ((v(1.0) - v(-1.0)) * 8.0 - (v(2.0) - v(-2.0))) / (12.0 * h);
                let place = orbit.place(t);
                let r = place.norm();
                forces.push((force + place * (gm / (r * r * r))).norm() * r * r / gm);
            } else {
                let still = orbit.turning(0.0, 0.0).expect("rates");
                let at = |k: f64| still.place(t + k * h);
                let slope = ((at(1.0) - at(-1.0)) * 8.0 - (at(2.0) - at(-2.0))) / (12.0 * h);
                damaged.push((orbit.velocity(t).norm() - slope.norm()) / size);
            }
        }
    }
    assert_largest!(errors, 80, @"3.17e-12");
    assert_largest!(forces, 40, @"1.63e-11");
    damaged.exceed(1e-5, 40);
}

fn body() -> RigidBody {
    super::effects::body(1.0, 1.5, 0.8)
}

/// On a circle: the gravity gradient, torque, potential, power and scale.
#[test]
fn a_circle_is_the_gravity_gradient() {
    let (n, node, inclination, argument) = (0.37, 0.7, 1.1, -0.4);
    let (axis, period) = (2.5, TAU / n);
    let orbit = KeplerOrbit::elliptic(axis, period, 0.0)
        .and_then(|orbit| orbit.oriented(node, inclination, argument))
        .expect("an orbit");
    let ours = OrbitingBody::new(n * n * axis * axis * axis, orbit).expect("a body");
    let ((s, c), (si, ci)) = (sincos(node), sincos(inclination));
    let normal = SpaceVector::new(si * s, -si * c, ci);
    let known = GravityGradient::on_orbit(n, normal, orbit.place(0.0)).expect("an orbit");
    let body = body();
    let state = tilted(&body, [0.3, 0.1, 2.0]);
    let scale = known.torque_scale(0.0, &body, &state);
    assert_error!(ours.torque_scale(0.0, &body, &state), scale, 1.7 eps);
    let [width, known_width] =
        [ours.narrowest(), known.narrowest()].map(|w| w.expect("named").time);
    assert_error!(width, known_width, 0.0 eps);
    let mut errors = Errors::in_units_of(EPS, "against the gravity gradient");
    for i in 0..200 {
        let t = 0.1 * f64::from(i) - 5.0;
        // What an eps of the angle moves it.
        let slack = scale * (1.0 + n * t.abs());
        let off = ours.torque(t, &body, &state) - known.torque(t, &body, &state);
        errors.push(off.norm() / slack);
        let u = ours.potential_energy(t, &body, &state);
        errors.add(u, known.potential_energy(t, &body, &state), slack);
        errors.add(ours.power(t, &body, &state), known.power(t, &body, &state), n * slack);
    }
    errors.attain(3.0..=4.0, 600);
}

/// An orbiting body that errs about what its distance does: the power is that of a circle, or
/// the potential falls with the square of the distance.
struct Erring<const SQUARED: bool>(OrbitingBody);

impl<const SQUARED: bool> Effect for Erring<SQUARED> {
    const PROPERTIES: Properties = OrbitingBody::<false>::PROPERTIES;
    fn name(&self) -> &'static str {
        "erring"
    }
    fn torque(&self, t: f64, body: &RigidBody, state: &State) -> SpaceVector {
        self.0.torque(t, body, state)
    }
    fn potential_energy(&self, t: f64, body: &RigidBody, state: &State) -> f64 {
        let part = if SQUARED {
            self.0.orbit().place(t).norm() / self.0.orbit().pericentre()
        } else {
            1.0
        };
        part * self.0.potential_energy(t, body, state)
    }
    fn power(&self, t: f64, body: &RigidBody, state: &State) -> f64 {
        if SQUARED {
            return self.0.power(t, body, state);
        }
        // Without what the distance changes.
        let h = 1e-4;
        let (orbit, r) = (self.0.orbit(), self.0.orbit().place(t).norm());
        let there = |t: f64| {
            let far = orbit.place(t).norm();
            self.0.potential_energy(t, body, state) * (far / r) * (far / r) * (far / r)
        };
        (there(t + h) - there(t - h)) / (2.0 * h)
    }
    fn narrowest(&self) -> Option<Feature> {
        self.0.narrowest()
    }
    fn torque_scale(&self, t: f64, body: &RigidBody, state: &State) -> f64 {
        self.0.torque_scale(t, body, state)
    }
}

#[test]
fn its_claims_hold_and_damaged_ones_do_not() {
    let eccentricities = [0.0, 0.3, 0.9, 0.99, 1.0, 1.0 + 1e-12, 2.0, 30.0];
    let bodies = [
        PrincipalMoments::new(1.0, 1.5, 0.8),
        PrincipalMoments::symmetric(3.0, 1.0),
        PrincipalMoments::symmetric(1.0, 1.0),
    ];
    let mut ran = 0;
    for moments in bodies {
        let body = RigidBody::new(moments.expect("a body"));
        let state = tilted(&body, [0.3, 0.1, 2.0]);
        for e in eccentricities {
            let orbit = KeplerOrbit::about(1.0, 1.3, e)
                .and_then(|orbit| orbit.oriented(0.3, 0.8, 1.9))
                .and_then(|orbit| orbit.turning(-0.02, 0.03))
                .and_then(|orbit| orbit.passing_at(4.0))
                .expect("an orbit");
            let direct = OrbitingBody::new(0.7, orbit).expect("a body");
            check(&direct, &body, [0.0, 10.0], &state).expect("direct");
            ran += 1;
            if e < 1.0 {
                let mean = direct.averaged().expect("a mean");
                check(&mean, &body, [0.0, 10.0], &state).expect("averaged");
                ran += 1;
            } else {
                assert!(direct.averaged().is_err());
            }
        }
    }
    assert_eq!(ran, 3 * (8 + 4));
    let (body, span) = (body(), [0.0, 10.0]);
    let state = tilted(&body, [0.3, 0.1, 2.0]);
    let planet = OrbitingBody::new(0.7, flyby()).expect("a body");
    let power = "says at what power it changes the energy";
    refused([
        (check(&Erring::<false>(planet), &body, span, &state), power),
        (check(&Erring::<true>(planet), &body, span, &state), power),
        (check(&Twin(&planet, KEEPS_ENERGY), &body, span, &state), "says that it keeps the energy"),
        (check(&Twin(&planet, NOT_ON_TIME), &body, span, &state), "does not depend on the time"),
    ]);
}

/// The mean of torque and potential over an orbit, evenly in time, is that of the ring.
#[test]
fn the_mean_over_an_orbit_is_the_ring() {
    let body = body();
    let state = tilted(&body, [0.3, 0.1, 2.0]);
    let (mut errors, mut damaged) = (Errors::of("mean"), Errors::of("without eccentricity"));
    for e in [0.0, 0.1, 0.4, 0.7] {
        let orbit = KeplerOrbit::elliptic(2.0, 10.0, e)
            .and_then(|orbit| orbit.oriented(0.3, 0.8, 1.9))
            .expect("an orbit");
        let direct = OrbitingBody::new(3.0, orbit).expect("a body");
        let ring = direct.averaged().expect("a mean");
        let count = 1024;
        let (mut torque, mut energy) = (SpaceVector::zero(), 0.0);
        for k in 0..count {
            let t = 10.0 * f64::from(k) / f64::from(count);
            torque += direct.torque(t, &body, &state) / f64::from(count);
            energy += direct.potential_energy(t, &body, &state) / f64::from(count);
        }
        let known = ring.torque(0.0, &body, &state);
        errors.push((torque - known).norm() / known.norm());
        errors.add(energy, ring.potential_energy(0.0, &body, &state), energy.abs());
        if e > 0.0 {
            let stretched = (1.0_f64 - e * e).powf(1.5);
            damaged.push((torque - known * stretched).norm() / known.norm());
        }
    }
    assert_largest!(errors, 8, @"3.65e-15");
    damaged.exceed(0.01, 3);
}

/// A flyby a five-hundredth as long as the span: `solve` does not step over it. Another route:
/// Euler's equations, the path by its own numerical orbit.
#[test]
fn a_short_passage_is_met() {
    let body = body();
    let [a, b, c] = body.moments().to_array();
    let rates = [0.02, 0.01, 0.015];
    let start = tilted(&body, rates);
    let (gm, q, e, when) = (50.0, 1.0, 1.2, 123.45);
    let orbit =
        KeplerOrbit::about(gm, q, e).and_then(|orbit| orbit.passing_at(when)).expect("an orbit");
    let planet = OrbitingBody::new(0.001 * gm, orbit).expect("a body");
    let end = 200.0;
    let solved = Scene::new(body).with(planet).solve(&start, end, 1e-7).expect("solved");
    assert!(solved.longest_step <= 0.5 * planet.narrowest().expect("named").time);

    let begin = [orbit.place(0.0), orbit.velocity(0.0)].map(SpaceVector::to_array);
    let [w, x, y, z] = start.attitude.quaternion();
    let law = ode(|_, s: &[f64; 13]| {
        let place = SpaceVector::new(s[7], s[8], s[9]);
        let r = place.norm();
        let attitude = Attitude::from_quaternion([s[3], s[4], s[5], s[6]]).expect("an attitude");
        let [l, m, n] = attitude.to_body(place / r).to_array();
        let pull = 3.0 * 0.001 * gm / (r * r * r);
        let force = place * (-gm / (r * r * r));
        let (p, q, k) = (s[0], s[1], s[2]);
        [
            ((b - c) * q * k + pull * (c - b) * m * n) / a,
            ((c - a) * k * p + pull * (a - c) * n * l) / b,
            ((a - b) * p * q + pull * (b - a) * l * m) / c,
            -0.5 * (s[4] * p + s[5] * q + s[6] * k),
            0.5 * (s[3] * p + s[5] * k - s[6] * q),
            0.5 * (s[3] * q + s[6] * p - s[4] * k),
            0.5 * (s[3] * k + s[4] * q - s[5] * p),
            s[10],
            s[11],
            s[12],
            force.x(),
            force.y(),
            force.z(),
        ]
    })
    .scaled(size_or([1.0; 13]));
    let from = [
        rates[0],
        rates[1],
        rates[2],
        w,
        x,
        y,
        z,
        begin[0][0],
        begin[0][1],
        begin[0][2],
        begin[1][0],
        begin[1][1],
        begin[1][2],
    ];
    let (there, _) =
        (Dop853::new(1e-13).expect("a method")).advance(&law, 0.0, &from, end).expect("advanced");
    let attitude = Attitude::from_quaternion([there[3], there[4], there[5], there[6]]);
    let off = attitude.expect("an attitude").angle_to(&solved.state.attitude);
    assert!(off < 1e-7, "{off:e}");
    // Without the passage it would end elsewhere.
    let free = Scene::new(body).solve(&start, end, 1e-7).expect("solved");
    assert!(free.state.attitude.angle_to(&solved.state.attitude) > 0.1);
}

/// The power is what the energy changes by, along a motion.
#[test]
fn the_power_is_the_change_of_the_energy() {
    let body = body();
    let planet = OrbitingBody::new(0.3, moon()).expect("a body");
    let ring = planet.averaged().expect("a mean");
    let start = tilted(&body, [0.3, 0.1, 0.5]);
    let (mut errors, mut damaged) = (Errors::of("power"), Errors::of("no power"));
    let h = 0.004;
    let mut judge = |energy: &dyn Fn(f64) -> f64, power: &dyn Fn(f64) -> f64| {
        for i in 1..20 {
            let t = f64::from(i);
            let slope = derivative(energy, t, h);
            errors.push(slope - power(t));
            damaged.push(slope);
        }
    };
    let scene = Scene::new(body).with(planet);
    let motion = scene.solve_along(&start, 21.0, 1e-11, &Limits::default()).expect("solved");
    let state = |t: f64| motion.try_state(t).expect("a state");
    judge(&|t| scene.energy_at(t, &state(t)), &|t| scene.power(t, &state(t)));
    let scene = Scene::new(body).with(ring);
    let motion = scene.solve_along(&start, 21.0, 1e-11, &Limits::default()).expect("solved");
    let state = |t: f64| motion.try_state(t).expect("a state");
    judge(&|t| scene.energy_at(t, &state(t)), &|t| scene.power(t, &state(t)));
    assert_largest!(errors, 38, @"8.80e-10");
    assert!(damaged.largest() > 1e-3);
}

#[test]
fn bad_input() {
    let told = |refused: Result<KeplerOrbit>| refused.expect_err("refused").to_string();
    let elliptic = |a, p, e| told(KeplerOrbit::elliptic(a, p, e));
    assert_eq!(
        elliptic(0.0, 1.0, 0.1),
        "semi-major axis = 0 is not allowed: it must be greater than 0"
    );
    assert_eq!(elliptic(1.0, f64::NAN, 0.1), "period = NaN is not a finite number");
    assert!(elliptic(1.0, 1.0, -0.1).contains("0 for a circle, or more"));
    assert!(elliptic(1.0, 1.0, 1.0).contains("less than 1: other orbits have no period"));
    assert!(elliptic(1.0, 1e-200, 0.1).contains("rate at the pericentre squared = inf"));
    assert!(elliptic(1.0, 1e-309, 0.1).contains("inf"));
    assert!(elliptic(1e-320, 1.0, 0.999_999).contains("pericentre"));
    let about = |gm, q, e| told(KeplerOrbit::about(gm, q, e));
    assert!(about(-1.0, 1.0, 0.0).contains("gravitational parameter = -1"));
    assert!(about(1.0, f64::INFINITY, 0.0).contains("pericentre distance = inf"));
    assert!(about(1.0, 1.0, f64::NAN).contains("eccentricity = NaN"));
    let orbit = moon();
    assert!(told(orbit.oriented(f64::NAN, 0.0, 0.0)).contains("node = NaN"));
    assert!(told(orbit.oriented(0.0, f64::INFINITY, 0.0)).contains("inclination = inf"));
    assert!(told(orbit.turning(0.0, f64::NAN)).contains("rate of the argument of pericentre"));
    assert!(told(orbit.passing_at(f64::NAN)).contains("time of the passage = NaN"));
    let close = KeplerOrbit::about(1.0, 1e-3, 0.0).expect("an orbit");
    let body = |gm, orbit| OrbitingBody::new(gm, orbit).expect_err("refused").to_string();
    assert!(body(0.0, orbit).contains("gravitational parameter = 0"));
    assert!(body(f64::MAX, close).contains("G m/r^3 at the pericentre = inf"));
    let open = OrbitingBody::new(1.0, flyby()).expect("a body").averaged().expect_err("refused");
    assert!(open.to_string().contains("eccentricity = 1.5"));
    assert_eq!(flyby().mean_inverse_cube(), 0.0);
    assert!(
        (KeplerOrbit::about(1.0, 1.0, 0.0).expect("a circle").period() / (2.0 * PI) - 1.0).abs()
            < 1e-15
    );
}
