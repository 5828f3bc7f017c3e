//! Angular velocity: equations (1) to (6) and the theorem, by where points and bodies are a
//! little earlier and later; what the notes leave open or misstate.

use crate::answers::{confirmed, ledger, value};
use kit::prelude::*;
use pages::ch15_2_angular_velocity::{filmed as pictured, *};
use rotation_dynamics::attitude::Attitude;
use std::f64::consts::PI;
use support::{Errors, assert_error, assert_largest, beside_twins};

/// Angular velocities, with three points of a body each.
fn bodies() -> impl Iterator<Item = (SpaceVector, [SpaceVector; 3])> {
    let part = |seed: u32, k: u32| sin(f64::from(7 * seed * seed + 31 * k * seed + 5 * k));
    let v = move |seed| SpaceVector::from([1, 2, 3].map(|k| part(seed, k)));
    (0..8).map(move |i| (v(i) * 2.0, [v(i + 11), v(i + 3), v(i + 29)]))
}

/// The velocity of the point `r` of a body that turns about the origin and drifts, from where
/// it is a little earlier and later.
fn watched(omega: SpaceVector, r: SpaceVector) -> SpaceVector {
    let drift = SpaceVector::new(0.3, -0.2, 0.9);
    derivative(1e-3, |t| Ok(turned(omega, r, t)? + drift * t)).unwrap()
}

/// By how much the first of each three vectors misses the third, beside the second, a damaged twin.
#[track_caller]
fn judged<V: Into<SpaceVector>>(cases: impl IntoIterator<Item = [V; 3]>, twin: f64, count: usize) -> Errors {
    let cases = cases.into_iter().map(|case| {
        let [right, wrong, wanted] = case.map(Into::<SpaceVector>::into);
        [right, wrong].map(|found| (found - wanted).norm())
    });
    beside_twins(cases, twin, count)
}

/// The twin: the line from where one point was to another is no line of the body.
#[test]
fn line_15_2_every_line_of_the_body_turns_alike() {
    let cases = bodies().map(|(omega, [r, s, _])| {
        let omega = UP * omega.x();
        let place = |r: SpaceVector, t| turned(omega, r - UP * r.z(), t).unwrap();
        let (line, now) = (|t| place(r, t) - place(s, t), place(r, 0.1));
        let rate = |last| UP * (angle_between(line(0.0), last) / 0.1);
        [rate(line(0.1)), rate(now - place(s, 0.0)), omega]
    });
    assert_largest!(judged(cases, 1e-3, 8), 8, @"5.11e-15");
}

/// The twin: r x Omega.
#[test]
fn eq_15_2_1_velocity_of_a_point() {
    let moved = |omega, r| derivative(1e-3, |t| turned(omega, r, t)).unwrap();
    let of = |omega, r| [velocity(omega, r), velocity(r, omega), moved(omega, r)];
    let cases = bodies().flat_map(|(omega, points)| points.map(|r| of(omega, r)));
    assert_largest!(judged(cases, 0.1, 24), 24, @"7.47e-13");
}

/// Velocities of A and of O', neither at rest. The twin: r for r'.
#[test]
fn eq_15_2_2_by_way_of_another_point() {
    let cases = bodies().map(|(omega, [a, o, _])| {
        let by_way = |r| watched(omega, o) + velocity(omega, r);
        [by_way(a - o), by_way(a), watched(omega, a)]
    });
    assert_largest!(judged(cases, 0.1, 8), 8, @"1.02e-12");
}

/// The angular velocity about O', from two points about it, makes (3) right for a third. The
/// twin: half of it.
#[test]
fn eq_15_2_3_about_another_point() {
    let cases = bodies().map(|(omega, [o, r, s])| {
        let about = |r| watched(omega, r) - watched(omega, o);
        let own = from_two_points(about(r), about(s), s - o);
        let a = SpaceVector::new(0.4, 1.3, -0.6);
        [velocity(own, a - o), velocity(own * 0.5, a - o), about(a)]
    });
    assert_largest!(judged(cases, 0.1, 8), 8, @"1.08e-12");
}

/// Measured about each of three points of the same body, it is the same vector. The twin: a
/// body that swells, and so is not rigid, has no such vector.
#[test]
fn theorem_15_2_one_angular_velocity() {
    let cases = bodies().flat_map(|(omega, points)| {
        [0, 1, 2].map(|k| {
            let [o, r, s] = [0, 1, 2].map(|i| points[(i + k) % 3]);
            let found = |swelling: f64| {
                let about = |r| watched(omega, r) - watched(omega, o) + (r - o) * swelling;
                from_two_points(about(r), about(s), s - o)
            };
            [found(0.0), found(0.3), omega]
        })
    });
    assert_largest!(judged(cases, 1e-2, 24), 24, @"2.65e-12");
}

/// One point A does not tell two angular velocities apart that differ along r'; a second, in
/// another direction, does. In the plane of a disc one is enough.
#[test]
fn e02_one_point_is_not_enough() {
    let cases = bodies().map(|(omega, [o, a, b])| {
        let by = |omega: SpaceVector, r| velocity(omega + (a - o) * 0.7, r) - velocity(omega, r);
        [by(omega, a - o), by(omega, b - o), SpaceVector::zero()]
    });
    assert_largest!(judged(cases, 0.05, 8), 8, @"4.97e-16");
    let flat = velocity(UP * 0.7, A - O_PRIME).norm() / (A - O_PRIME).norm();
    assert_error!(flat, 0.7, 0.0 eps);
}

/// Gyroscopes in many poses, with their rates.
fn gyroscopes() -> impl Iterator<Item = Gyroscope> {
    bodies().zip(1..).map(|((turn, [pose, ..]), i)| {
        let ([phi, _, zeta], [p, n, s]) = ((pose * 3.0).to_array(), turn.to_array());
        Gyroscope { angles: [phi, 0.33 * f64::from(i), zeta], rates: [p, n, 3.0 * s] }
    })
}

/// The attitude a little later, of the rotor or (without spin) of the triad.
fn later(g: &Gyroscope, t: f64, spin: f64) -> Attitude {
    g.after(t).but(|g| g.angles[2] *= spin).attitude().unwrap()
}

/// The angular velocity of the rotor from its attitudes before and after.
fn filmed(g: &Gyroscope) -> SpaceVector {
    let now = later(g, 0.0, 1.0).inverse();
    derivative(1e-3, |t| Ok(now.then(&later(g, t, 1.0)).rotation_vector())).unwrap()
}

/// The twin: the axes 1, 2, 3 of the rotor for x, y, z.
#[test]
fn eq_15_2_4_components_add_as_vectors() {
    let cases = gyroscopes().map(|g| {
        let sum = |[a, b, c]: [f64; 3]| g.triad()[0] * a + g.triad()[1] * b + g.triad()[2] * c;
        [sum(g.nodal()), sum(g.on_body()), filmed(&g)]
    });
    assert_largest!(judged(cases, 1e-2, 8), 8, @"1.75e-12");
}

/// The twin: the precession along the axle.
#[test]
fn eq_15_2_5_three_rates() {
    let cases = gyroscopes().map(|g| {
        let ([x, _, z], [phi, theta, zeta]) = (g.triad(), g.rates);
        [g.angular_velocity(), z * (phi + zeta) + x * theta, filmed(&g)]
    });
    assert_largest!(judged(cases, 0.05, 8), 8, @"1.75e-12");
}

/// The components that the triad and the rotor see, and the rates from them. The twins: sine
/// and cosine exchanged, axes that do not follow the spin, components taken for rates.
#[test]
fn eq_15_2_6_on_the_nodal_axes() {
    let seen = |g: &Gyroscope, spin| later(g, 0.0, spin).to_body(filmed(g)).to_array();
    let triad = gyroscopes().map(|g| {
        let ([x, y, z], [.., spin]) = (g.nodal(), g.rates);
        [g.nodal(), [x, z - spin, y + spin], seen(&g, 0.0)]
    });
    assert_largest!(judged(triad, 1e-2, 8), 8, @"1.75e-12");
    let rotor = gyroscopes().map(|g| [g.on_body(), g.nodal(), seen(&g, 1.0)]);
    assert_largest!(judged(rotor, 1e-3, 8), 8, @"1.75e-12");
    let back = gyroscopes().map(|g| [rates(seen(&g, 0.0), g.angles[1]), seen(&g, 0.0), g.rates]);
    assert_largest!(judged(back, 1e-3, 8), 8, @"1.79e-12");
}

/// The axes y and z move as phi' Z + theta' x says (x, which is level, does not tell it from
/// phi' Z). With phi' Z alone, as printed, the axle would keep its tilt for ever.
#[test]
fn e03_the_triad_turns_about_two_axes() {
    let cases = gyroscopes().flat_map(|g| {
        [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|unit| {
            let axis = |t| Ok(later(&g, t, 0.0).to_space(unit.into()));
            let (now, moves) = (axis(0.0).unwrap(), derivative(1e-3, axis).unwrap());
            [velocity(g.of_triad(), now), velocity(UP * g.rates[0], now), moves]
        })
    });
    assert_largest!(judged(cases, 0.05, 16), 16, @"9.51e-13");
}

/// Seen from a frame that turns, a body turns with Omega less that of the frame; the printed
/// statement, that it turns the same, holds for none of these.
#[test]
fn e05_a_turning_frame_sees_the_difference() {
    let cases = bodies().map(|(omega, [r, ..])| {
        let frame = 0.3 + r.x().abs();
        [omega - UP * frame, omega, seen_from(frame, omega).unwrap()]
    });
    assert_largest!(judged(cases, 0.2, 8), 8, @"2.78e-15");
}

/// Turns about X and Z differ by their order as the formula says; of half the turn a quarter
/// of the difference is left, so that of the rates nothing is. The twins: the formula for
/// small turns, and large turns.
#[test]
fn turns_do_not_add_and_rates_do() {
    let gap_of = |x| measured_gap(x).unwrap();
    let sizes = (1..=19).map(|k| 0.1 * f64::from(k));
    let formula = sizes.map(|x| [gap(x), x * x, gap_of(x)].map(|gap| UP * gap));
    assert_largest!(judged(formula, 1e-7, 19), 19, @"4.44e-16");
    let part = |x| UP * (4.0 * gap_of(0.5 * x) / gap_of(x));
    let halved = [1e-3, 2e-3, 3e-3].map(|x| [part(x), part(500.0 * x), UP]);
    assert_largest!(judged(halved, 9e-3, 3), 3, @"5.62e-7");
}

/// A tilt at the edge of what is allowed, an axle that would be led through a pole, nothing that
/// turns; and the instances of the inventory, rounded from 25 digits.
#[test]
fn every_instance_is_confirmed() {
    let poses = [(0.001, 30.0), (0.5, -3000.0), (2.9, 0.0), (3.13, 5.0)];
    let gyroscopes = poses.map(|(theta, spin)| format!("--theta={theta} --spin={spin} --phi=40"));
    let frames = [0.0, -5000.0, 2e-3].map(|w| format!("--frame={w} --omega-z={w} --disc={w}"));
    let edges = [
        "--theta=3.1415916535 --omega-x=-1", "--omega-x=-1 --omega-y=0 --omega-z=0 --phi=0",
        "--line-before=-1.5 --line-after=1.5 --interval=1000000",
        "--omega-x=0 --omega-y=0 --omega-z=0 --precession=0 --nutation=0 --spin=0",
    ];
    confirmed(&EXAMPLE, gyroscopes.into_iter().chain(frames).chain(edges.map(String::from)), 11);
    let mut errors = Errors::of("instances");
    for (key, wanted) in [
        ("size", 31.130150605228), ("space_y", -23.968_877_986_492_6), ("space_z", 18.209_069_176_044_2),
        ("omega_y", 1.682_941_969_615_79), ("v_x", -0.49),
    ] {
        errors.add(value(&EXAMPLE, key), wanted, wanted.abs());
    }
    assert_largest!(errors, 5, @"1.85e-15");
}

/// Past a pole the angles take ever more steps, the quaternion does not know of it; both arrive.
#[test]
fn angles_pay_for_a_pole_and_quaternions_do_not() {
    let steps = |tilt: f64| {
        [by_angles, by_quaternion].map(|way| way(passing(tilt).unwrap(), 1.7, 1e-12).unwrap().1.steps)
    };
    let ([far, few], [near, same]) = (steps(0.5), steps(1e-5));
    assert_eq!((few, same), (8, 8));
    assert!(near > 5 * far, "{near} {far}");
}

/// The body of the strip keeps its axle clear of the poles, whichever way its vector points.
#[test]
fn the_strip_stays_clear_of_the_poles() {
    let mut cases = 0;
    for omega in bodies().flat_map(|(omega, [r, ..])| [omega, r, UP, -UP, UP * 1e-9]) {
        let start = clear_of_poles(omega).unwrap();
        for k in 0..60 {
            let turn = omega * (0.1 * f64::from(k) / omega.norm());
            let tilt = start.turned_in_space(turn).unwrap().euler_angles().theta;
            assert!((0.49..=PI - 0.49).contains(&tilt), "{omega:?} {tilt}");
            cases += 1;
        }
    }
    assert_eq!(cases, 2400);
}

/// At rest, and fast, and next to a pole, each figure and each still can be drawn.
#[test]
fn drawn_for_any_rates() {
    for [precession, nutation, spin, theta] in
        [[0.0, 0.0, 0.0, 1.0], [-1e4, 1e4, 1e4, 1.0], [2.0, 0.0, -30.0, 1e-6]]
    {
        let p = Parameters { precession, nutation, spin, theta, ..Parameters::default() };
        assert_eq!(EXAMPLE.figures(&p).unwrap().len(), 12);
    }
}

/// The card: of a steady precession the turn between two pictures is three turns one after the
/// other, half of the precession, the spin, the other half: by half angles. What the prediction
/// leaves falls with the square of the time; the twin is that for twice the time.
#[test]
fn two_pictures_miss_what_they_must() {
    assert_eq!(ledger(&EXAMPLE, "").len(), 3);
    let (mut exact, mut first) = (Errors::of("filmed"), Errors::of("first order, over dt^2"));
    let mut damaged = Errors::of("twice the time");
    for (theta, precession, spin) in [(1.0, 2.0, 30.0), (0.1, -7.0, 3.0), (2.5, 1.0, -10.0)] {
        let g = Gyroscope { angles: [0.3, theta, -0.4], rates: [precession, 0.0, spin] };
        for time in [1e-2, 1e-3] {
            let ((a, b), c) = ((0.5 * precession * time, 0.5 * spin * time), cos(theta));
            // Twice the vector part over its sine: along z across Z, and along Z.
            let up = sin(a) * cos(b) + cos(a) * sin(b) * c;
            let across = sin(b) * sin(theta);
            let angle = 2.0 * atan2(hypot(up, across), cos(a) * cos(b) - sin(a) * sin(b) * c);
            let part = angle / hypot(up, across) / time;
            let off = hypot(part * up - precession - spin * c, part * across - spin * sin(theta));
            exact.push(pictured(&g, time).unwrap() / off - 1.0);
            first.push((missed(&g, time) / off - 1.0) / (time * time));
            damaged.push(missed(&g, 2.0 * time) / off - 1.0);
        }
    }
    assert_largest!(exact, 6, @"6.86e-8");
    assert_largest!(first, 6, @"17.0");
    damaged.exceed(2.0, 6);
    // With all three rates, the ratio of what the prediction leaves at 10 and 1 ms is 100.
    let g = Gyroscope::of(&Parameters::default(), 1.0);
    let left = |time| missed(&g, time) / pictured(&g, time).unwrap() - 1.0;
    assert_error!(left(1e-2) / left(1e-3) / 100.0 - 1.0, 5.843e-4);
}

/// A spinning disc swells by (1 - nu)/4 of rho Omega^2 R^2/E at its rim; the twin: a ring, by 1.
#[test]
fn a_rotor_swells_as_elasticity_says() {
    let cases = [0.0, 0.3, 0.45].map(|nu| {
        let (rim, _) = swollen(nu).unwrap();
        [rim - 0.25 * (1.0 - nu), rim - 1.0]
    });
    assert_largest!(beside_twins(cases, 0.7, 3), 3, @"2.50e-9");
}
