//! Three different moments. That stepped motions confirm the formulas is part of the report;
//! here for other bodies, with what the page says of the curves and of the naive solver.

use crate::answers::{cell, confirmed, measured, number, refused, value};
use pages::ch15_5_asymmetric::*;
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::RigidBody;
use rotation_dynamics::effects::Torque;
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::{Dop853, Integrator, Ode};
use rotation_dynamics::math::{DoubleDouble, atan2, exp};
use rotation_dynamics::scene::Scene;
use std::f64::consts::TAU;
use support::{Errors, assert_largest, derivative};

const BODIES: [[f64; 3]; 4] = [[1.0, 2.0, 2.5], [0.3, 0.5, 0.79], [2.0, 2.1, 4.0], [1.0, 5.0, 5.1]];

/// These bodies with starts of both kinds, near and far from the middle axis.
fn tumbles() -> impl Iterator<Item = Tumble> {
    let starts = [(0.003, 0), (0.8, 0), (0.003, 2), (0.8, 2), (1.4, 0), (1.4, 2)];
    let of = move |moments| starts.map(|(aside, about)| Tumble::new(moments, 1.5, aside, about));
    BODIES.into_iter().flat_map(of)
}

/// All of them at these times.
fn at<const N: usize>(times: [f64; N]) -> impl Iterator<Item = (Tumble, f64)> {
    tumbles().flat_map(move |tumble| times.map(|t| (tumble, t)))
}

/// What is measured in each case: errors, the last of them of a damaged twin if there is one.
fn measured_in<C, const N: usize>(cases: impl IntoIterator<Item = C>, errors: impl Fn(C) -> [f64; N]) -> [Errors; N] {
    let mut all = std::array::from_fn(|k| Errors::of(format!("error {k}")));
    for case in cases {
        all.iter_mut().zip(errors(case)).for_each(|(all, error)| all.push(error));
    }
    all
}

fn sum(terms: impl Fn(usize) -> f64) -> f64 {
    terms(0) + terms(1) + terms(2)
}

/// Twice the energy.
fn energy(i: [f64; 3], w: [f64; 3]) -> f64 {
    sum(|k| i[k] * w[k] * w[k])
}

/// Equation (1) says that L stands still in space: so do the slopes of the rates of the
/// library's motion, whose L keeps its bits. The twin has the other sign.
#[test]
fn eulers_equations_are_a_momentum_at_rest() {
    let [right, wrong] = measured_in(at([0.2, 1.1, 3.7]), |(tumble, t)| {
        let motion = tumble.free_body().unwrap();
        let rates = |by: f64| motion.angular_velocity(t + by).to_array();
        let law = euler(tumble.moments).derivative(t, &rates(0.0));
        let found = [0, 1, 2].map(|i| derivative(|by| rates(by)[i], 0.0, 2e-3));
        [1.0, -1.0].map(|sign| sum(|i| (found[i] - sign * law[i]).abs()))
    });
    assert_largest!(right, 72, @"1.35e-9");
    wrong.exceed(4e-4, 72);
}

/// The tip of L stays on the sphere and on the ellipsoid; the twin, with I1 and I2 exchanged,
/// leaves one of them.
#[test]
fn the_tip_stays_on_sphere_and_ellipsoid() {
    let [kept, damaged] = measured_in(at([0.4, 2.0, 7.0]), |(tumble, t)| {
        let i = tumble.moments;
        let size = |w: [f64; 3]| [sum(|k| i[k] * i[k] * w[k] * w[k]), energy(i, w)];
        let ([l, e], [p, q, r]) = (size(tumble.start), tumble.rates(t).unwrap());
        [[p, q, r], [q, p, r]].map(size).map(|[now_l, now_e]| (now_l / l - 1.0).abs() + (now_e / e - 1.0).abs())
    });
    assert_largest!(kept, 72, @"6.66e-16");
    damaged.exceed(1e-3, 72);
}

/// The page's rates by elliptic functions, the library's, and those of Euler's equations in
/// steps, through two flips. The twin is half a period late.
#[test]
fn three_routes_give_one_motion() {
    let [library, steps, damaged] = measured_in(at([0.31, 0.5, 1.2, 1.9]), |(tumble, part)| {
        let (motion, flips) = (tumble.free_body().unwrap(), tumble.between_flips().unwrap());
        let method = Dop853::new(1e-15).unwrap();
        let run = method.solve(&euler(tumble.moments), 0.0, &tumble.start, 2.0 * flips, &[]).unwrap();
        let (t, rates) = (part * flips, |t| tumble.rates(t).unwrap());
        let others = [motion.angular_velocity(t).to_array(), run.at(t).unwrap(), rates(t + flips)];
        others.map(|other| sum(|i| (rates(t)[i] - other[i]).abs()) / 1.5)
    });
    assert_largest!(library, 96, @"1.41e-15");
    assert_largest!(steps, 96, @"5.72e-13");
    damaged.exceed(1e-3, 96);
}

/// Poinsot: the ellipsoid's lowest point stays on its plane, the plane is tangent there, and
/// the two curves run through the point of contact at the same speed: no slipping. The twin is a
/// body at rest.
#[test]
fn the_ellipsoid_rolls_on_its_plane() {
    let [height, arcs, damaged] = measured_in(at([0.3, 1.3, 4.4]), |(tumble, t)| {
        let motion = tumble.free_body().unwrap();
        let at = |by: f64| motion.kinematics(t + by);
        let contact = |by: f64| at(by).attitude.to_space(at(by).angular_velocity);
        let up = motion.angular_momentum() / tumble.momentum();
        let speed = |v: &dyn Fn(f64) -> [f64; 3]| [0, 1, 2].map(|i| derivative(|by| v(by)[i], 0.0, 2e-3));
        let on_plane = SpaceVector::from_array(speed(&|by| contact(by).to_array()));
        let on_body = BodyVector::from_array(speed(&|by| at(by).angular_velocity.to_array()));
        // The normal of the ellipsoid at Omega is I Omega, which is L.
        let normal = at(0.0).attitude.to_space(motion.body_momentum(at(0.0).angular_velocity));
        let off = contact(0.0).dot(&up) / tumble.height() - 1.0;
        [
            off.abs().max(normal.cross(&up).norm() / normal.norm()),
            (at(0.0).attitude.to_space(on_body) - on_plane).norm(),
            (SpaceVector::from_array(on_body.to_array()) - on_plane).norm(),
        ]
    });
    assert_largest!(height, 72, @"1.33e-15");
    assert_largest!(arcs, 72, @"1.08e-9");
    damaged.exceed(1e-4, 72);
}

/// On the separatrix the rate about the middle axis is -Omega tanh(lambda t) about a flip; the twin
/// flips half as fast.
#[test]
fn the_separatrix_is_a_hyperbolic_tangent() {
    let cases = BODIES[..3].iter().flat_map(|moments| [-3.0, -1.0, 0.5, 2.0].map(|x| (*moments, x)));
    let [errors, damaged] = measured_in(cases, |(moments, x)| {
        let tumble = Tumble::new(moments, 1.0, 1e-8, 2);
        let (flip, growth) = (0.5 * tumble.between_flips().unwrap(), small_motions(moments, 1.0)[1]);
        let tanh = |x: f64| (exp(2.0 * x) - 1.0) / (exp(2.0 * x) + 1.0);
        let rate = tumble.rates(flip + x / growth).unwrap()[1];
        [rate + tanh(x), rate + tanh(0.5 * x)]
    });
    assert_largest!(errors, 12, @"3.44e-15");
    damaged.exceed(0.05, 12);
}

/// Montgomery: in a period of the rates the body turns about L by 2 E T/L less the solid angle
/// that the tip of L goes round in the body, up to whole turns. The twin leaves that angle out.
#[test]
fn the_turn_is_energy_and_solid_angle() {
    let [errors, damaged] = measured_in(tumbles(), |tumble| {
        let (period, count, a) = (2.0 * tumble.between_flips().unwrap(), 4000_u32, tumble.about);
        let tip = |k: u32| {
            let l = tumble.carried(tumble.rates(period * f64::from(k) / f64::from(count)).unwrap());
            [l[a], l[(a + 1) % 3], l[(a + 2) % 3]].map(|x| x / tumble.momentum())
        };
        // Of a curve about the axis the area is the integral of (1 - cos) over the azimuth.
        let piece = |k: u32| {
            let ([h, x, y], [g, u, v]) = (tip(k), tip(k + 1));
            (1.0 - 0.5 * (h.abs() + g.abs())) * atan2(x * v - y * u, x * u + y * v)
        };
        let area: f64 = (0..count).map(piece).sum();
        let turned = tumble.free_body().unwrap().precession_per_period() - tumble.height() * period;
        [turned + area, turned].map(|angle| (angle / TAU - (angle / TAU).round()) * TAU)
    });
    assert_largest!(errors, 24, @"4.74e-5");
    damaged.exceed(1e-3, 24);
}

/// A step along the tangent adds its own square to the energy, to round-off.
#[test]
fn the_naive_step_adds_the_square_of_its_slope() {
    let [errors] = measured_in(tumbles(), |tumble| {
        let (i, whole) = (tumble.moments, energy(tumble.moments, tumble.start));
        let mut run = Naive { moments: i, rates: tumble.start, step: 0.05 };
        let slope = euler(i).derivative(0.0, &run.rates);
        let gain = energy(i, run.next().unwrap()) - whole;
        assert!(gain > 0.0);
        [(gain - 0.05 * 0.05 * energy(i, slope)) / whole]
    });
    assert_largest!(errors, 24, @"1.48e-16");
    // And it ends with a book that turns over: the true one never does.
    let book = Tumble::new(Naive::of_the_page(60.0).moments, 12.0, NAIVE_TILT, 2);
    let least = (0..4000).map(|k| book.rates(0.01 * f64::from(k)).unwrap()[2]);
    assert!(least.fold(f64::INFINITY, f64::min) > 0.9 * book.start[2]);
    assert!(Naive::of_the_page(60.0).take(260).any(|rates| rates[2] < 0.0));
}

/// Equation (12), to round-off; the twin has I2 instead of I1.
#[test]
fn a_naive_step_multiplies_the_difference() {
    let [errors, damaged] = measured_in(tumbles(), |tumble| {
        let [i1, i2, i3] = tumble.moments;
        let terms = |[p, _, r]: [f64; 3]| [i3 * (i3 - i2) * r * r, i1 * (i2 - i1) * p * p];
        let mut run = Naive { moments: tumble.moments, rates: tumble.start, step: 0.05 };
        // A step away from the start, where one of the rates is zero.
        let before = run.next().unwrap();
        let ([largest, least], [later, less]) = (terms(before), terms(run.next().unwrap()));
        let (was, is) = (largest - least, later - less);
        let by = |other: f64| 1.0 - (i2 - i1) * (i3 - i2) / (other * i3) * (0.05 * before[1]).powi(2);
        [(is - by(i1) * was) / (largest + least), (is - by(i2) * was) / was]
    });
    assert_largest!(errors, 24, @"3.34e-16");
    damaged.exceed(1e-7, 24);
}

/// With 120 and with 200 digits (mpmath) the plain recursion (1) crosses in step 4311, where the
/// difference over 2 E I2 goes from 5.0e-64 to -7.0e-64. So does the page's; doubles, and pairs of
/// them, cross before, at their own rounding.
#[test]
fn rounding_does_not_decide_when_it_crosses() {
    let step = |key| (240.0 * value(&EXAMPLE, key)).round();
    let (exact, rounded) = (step("naive_crosses_later"), step("naive_rounded"));
    let run = Naive::of_the_page(240.0);
    let ([i1, i2, i3], mut rates) = (run.moments.map(DoubleDouble::from), run.rates.map(DoubleDouble::from));
    let in_pairs = (1..10_000).find(|_| {
        let [p, q, r] = rates;
        let slopes = [(i2 - i3) / i1 * q * r, (i3 - i1) / i2 * r * p, (i1 - i2) / i3 * p * q];
        rates = [0, 1, 2].map(|i| rates[i] + slopes[i] / 240.0);
        i3 * (i3 - i2) * rates[2].square() <= i1 * (i2 - i1) * rates[0].square()
    });
    assert_eq!(exact, 4311.0);
    assert!(4150.0 < rounded && rounded < 4200.0, "{rounded}");
    assert!(in_pairs.is_some_and(|step| 4250 < step && step < 4300), "{in_pairs:?}");
}

/// A naive step after which the length of L is brought back; then 2 E I2/L^2 - 1, which is above 0
/// about the least axis and below 0 about the largest.
fn restored(run: &mut Naive) -> f64 {
    let whole = from_separatrix(run)[0].sqrt();
    run.next();
    let by = whole / from_separatrix(run)[0].sqrt();
    run.rates = run.rates.map(|rate| rate * by);
    from_separatrix(run)[1]
}

/// L^2, and 2 E I2/L^2 - 1.
fn from_separatrix(Naive { moments: i, rates: w, .. }: &Naive) -> [f64; 2] {
    let square = sum(|k| i[k] * i[k] * w[k] * w[k]);
    [square, sum(|k| i[k] * i[1] * w[k] * w[k]) / square - 1.0]
}

/// From polhodes about either stable axis the naive steps lead to the separatrix: the distance from
/// it after 6000 steps over that before.
#[test]
fn the_naive_path_leads_to_the_separatrix() {
    let far = tumbles().filter(|tumble| tumble.complement() > 0.1);
    let [shrunk] = measured_in(far, |Tumble { moments, start, .. }| {
        let mut run = Naive { moments, rates: start, step: 0.1 };
        let [_, before] = from_separatrix(&run);
        [(0..6000).map(|_| restored(&mut run)).last().unwrap() / before]
    });
    assert_largest!(shrunk, 16, @"0.524");
}

/// With the length of L brought back the tip winds towards the separatrix until doubles no longer
/// tell the two apart; then the book turns over, at a time that is a matter of rounding.
#[test]
fn a_restored_length_does_not_save_the_book() {
    let moments = Naive::of_the_page(60.0).moments;
    let [crossed, flipped] = measured_in([0.0, 1e-15, 1e-12, -1e-9, 1e-6, 1e-3, 0.01, -0.01], |off| {
        let Tumble { start, .. } = Tumble::new(moments, 12.0, NAIVE_TILT + off, 2);
        let mut run = Naive { moments, rates: start, step: 1.0 / 60.0 };
        let first = (1..20_000).find(|_| restored(&mut run) >= 0.0).unwrap();
        let more = (1..20_000).find(|_| {
            restored(&mut run);
            run.rates[2] < 0.0
        });
        [first, first + more.unwrap()].map(f64::from)
    });
    // Without it: 252 steps.
    crossed.exceed(2430.0, 8);
    assert_largest!(crossed, 8, @"2.45e3");
    flipped.exceed(2600.0, 8);
}

/// Among the numbers that are confirmed are the growth about the middle axis and the sway about the
/// others, (4) and (5), of each body, and the wait near that axis, (8), of each throw.
#[test]
fn every_throw_is_confirmed() {
    let asides = [2e-6, 0.01, 0.5, 1.5];
    let bodies = ["", "--thickness=0", "--length=0.147 --width=0.072 --thickness=0.008", "--length=0.3 --width=0.29", "--rate=500"];
    let flags = asides.into_iter().flat_map(|aside| bodies.map(|body| format!("--aside={aside} {body}")));
    let flags = flags.flat_map(|flags| ["least", "largest"].map(|way| format!("{flags} --toward={way}")));
    confirmed(&EXAMPLE, flags, 40);
    confirmed(&EXAMPLE, [
        "--with air", "--with air=0.001 --rate=300 --toward=largest", "--with air=10 --mass=0.001",
        "--rate=0.001", "--rate=1e-9 --aside=0.001", "--mass=0.0001 --rate=1000",
        "--length=12.61081 --width=2.412957 --thickness=2.305522 --rate=41.3 --aside=0.18 --toward=largest",
    ], 7);
}

/// What the page says of its runs: twice the rate, half the wait, the same turns.
#[test]
fn the_rate_is_only_a_clock() {
    let run = |key| number(&EXAMPLE, "--rate=24", key);
    assert!((run("between_flips") / value(&EXAMPLE, "between_flips") - 0.5).abs() < 1e-10);
    assert!((run("turns") / value(&EXAMPLE, "turns") - 1.0).abs() < 1e-8);
}

#[test]
fn what_does_not_tumble_is_refused() {
    refused(&EXAMPLE, [
        ("--width=0.21", "must differ"),
        ("--length=0.1", "must differ"),
        ("--aside=0", "aside = 0 is not allowed"),
        ("--aside=2", "aside = 2 is not allowed"),
        ("--mass=-1", "mass = -1 is not allowed"),
        ("--mass=1e300", "I2 = "),
        ("--length=1e200 --width=1e199", "I2 = inf is not"),
        ("--rate=1e200", "rate = 1e200 is not allowed"),
        ("--toward=middle", "invalid value"),
        ("--with air=-1", "air = -1 is not allowed"),
        ("--tolerance=1e-17", "doubles allow"),
    ]);
}

/// What the card measures, by other routes: the closed form of a throw that is off by more, and
/// the book with its attitude in a scene of the library, pressed piece by piece.
#[test]
fn what_the_card_measures() {
    let [thrown, air, twisted] = measured(&EXAMPLE);
    let p = Parameters::default();
    let tumble = |aside: f64| Tumble::new(box_moments(p.mass, [p.length, p.width, p.thickness]), p.rate, aside, 0);
    let (ours, wait) = (tumble(p.aside), |aside: f64| tumble(aside).between_flips().unwrap());
    let pieces = |length: f64| (0..12).map(move |k| length * ((f64::from(k) + 0.5) / 12.0 - 0.5));
    let pressed = Torque::on_body("air", |_, body: &RigidBody, state| {
        let (rates, mut torque) = (body.angular_velocity(state), BodyVector::zero());
        for (x, y) in pieces(0.21).flat_map(|x| pieces(0.14).map(move |y| (x, y))) {
            let place = BodyVector::new(x, y, 0.0);
            let speed = rates.cross(&place).z();
            let force = 0.5 * 1.204 * 1.2 * (0.21 * 0.14 / 144.0) * speed * speed.abs();
            torque += place.cross(&BodyVector::new(0.0, 0.0, -force));
        }
        torque
    });
    let [i1, i2, i3] = ours.moments;
    let body = RigidBody::new(PrincipalMoments::new(i1, i2, i3).unwrap());
    let start = body.state(Attitude::IDENTITY, BodyVector::from_array(ours.start)).unwrap();
    let scene = Scene::new(body).with(pressed);
    let (end, _) = Dop853::new(1e-12).unwrap().advance(&scene, 0.0, &start, wait(p.aside)).unwrap();
    let part = end.angular_momentum.norm() / start.angular_momentum.norm();
    let later = wait(p.aside) - wait(p.aside + 0.0175);
    let [errors] = measured_in([thrown[1] / later, air[1] / (1.0 - part)], |ratio| [ratio - 1.0]);
    assert_largest!(errors, 2, @"3.74e-9");
    let [errors] = measured_in([twisted], |[predicted, turned]| [turned / predicted - 1.0]);
    assert_largest!(errors, 1, @"7.49e-6");
    // What the table of the flips tells: there L is across the middle axis, and as long as it says.
    let told = ["1", "2", "3", "4"].map(|flip| {
        ["in air / s", "part of L left"].map(|column| cell(&EXAMPLE, "--with air", ["table air", flip, column]))
    });
    let mut errors = Errors::of("flips in air");
    for [t, left] in told {
        let (end, _) = Dop853::new(1e-12).unwrap().advance(&scene, 0.0, &start, t).unwrap();
        errors.push(body.angular_velocity(&end).y() / p.rate);
        errors.push(end.angular_momentum.norm() / start.angular_momentum.norm() - left);
    }
    assert_largest!(errors, 8, @"2.16e-3");
    // On one polhode a wait goes as one over L: these grow because the tip nears the separatrix.
    let waits = [1, 2, 3].map(|k| (told[k][0] - told[k - 1][0]) * told[k][1] / wait(p.aside));
    assert!(1.05 < waits[0] && 1.05 * waits[0] < waits[1] && 1.05 * waits[1] < waits[2], "{waits:?}");
    // The start nearer to the axis, a plate that turns about its middle edge all the time.
    let drag = 0.25 * 1.204 * 1.2 * p.width * p.rate * p.rate * (0.5 * p.length).powi(4);
    let gradient = 1.5 * 9.80665 / 6.371e6 * (i3 - i1);
    let others = [
        thrown[1] / (wait(p.aside - 0.0175) - wait(p.aside)),
        air[1] / (drag * wait(p.aside) / ours.momentum()),
        twisted[1] / (gradient / ours.momentum() * wait(p.aside)),
    ];
    let [damaged] = measured_in(others, |ratio| [ratio - 1.0]);
    damaged.exceed(0.1, 3);
}
