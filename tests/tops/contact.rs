//! The laws of friction and resistance, and balls on a floor.

use super::{G, toy};
use core::f64::consts::{PI, TAU};
use models::tops::*;
use rotation_dynamics::Error;
use rotation_dynamics::effects::{DiscDrag, GravityAtLever};
use rotation_dynamics::frame::SpaceVector;
use rotation_dynamics::math::{hypot, sincos};
use support::{EPS, Errors, assert_largest};

/// Force and torque of a patch of radius 1 with mu = 1 that slips by `slip` and pivots at 1:
/// summed in rings and around, pressed as Hertz says.
fn summed(slip: f64) -> [f64; 2] {
    let (rings, parts) = (400, 400);
    let mut sum = [0.0; 2];
    for i in 0..rings {
        // Midpoints in the angle whose sine is the radius: the pressure is its cosine.
        let (radius, pressure) = sincos(0.5 * PI * (f64::from(i) + 0.5) / f64::from(rings));
        let weight = 1.5 / PI * pressure * radius * pressure * (0.5 * PI / f64::from(rings));
        for j in 0..parts {
            let (s, c) = sincos(TAU * (f64::from(j) + 0.5) / f64::from(parts));
            let (vx, vy) = (slip - radius * s, radius * c);
            let speed = hypot(vx, vy);
            let part = weight * TAU / f64::from(parts) / speed;
            sum[0] += part * vx;
            sum[1] += part * radius * (c * vy - s * vx);
        }
    }
    sum
}

#[test]
fn a_patch_rubs_as_the_sum_of_its_pieces() {
    let patch = Patch::new(1.0, 1.0).unwrap();
    let mut errors = Errors::of("closed form less sum");
    let mut damaged = Errors::of("the law of fractions");
    for slip in [0.05, 0.4, 0.9, 1.1, 1.7, 2.2, 6.0] {
        let grip = patch.sliding(SpaceVector::new(0.0, slip, 0.0), 1.0);
        let [force, torque] = summed(slip);
        errors.push_at(-grip.force.y() - force, slip);
        errors.push_at(-grip.torque - torque, slip);
        // Zhuravlev's simplest fraction has both ends right.
        damaged.push(slip / (slip + 8.0 / (3.0 * PI)) - force);
    }
    assert_largest!(errors, 14, @"4.12e-6");
    damaged.exceed(1e-3, 7);
}

/// Where its three forms meet, and its ends.
#[test]
fn a_patch_has_no_seam() {
    let patch = Patch::new(1.0, 1.0).unwrap();
    let at = |slip: f64| {
        let grip = patch.sliding(SpaceVector::new(slip, 0.0, 0.0), -1.0);
        [-grip.force.x(), grip.torque]
    };
    let mut errors = Errors::in_units_of(EPS, "seam");
    for seam in [1.0, 2.0] {
        let ([f, g], [h, k]) = (at(seam * (1.0 - 2.0 * EPS)), at(seam * (1.0 + 4.0 * EPS)));
        errors.push_at(f - h, seam);
        errors.push_at(g - k, seam);
    }
    assert_largest!(errors, 4, @"2");
    let ends = [at(0.0)[1] - 3.0 * PI / 16.0, at(1e9)[0] - 1.0, at(1e6)[1] * 5e6 - 1.0];
    assert!(ends.iter().all(|e| e.abs() < 1e-11), "{ends:?}");
    let resting = patch.sliding(SpaceVector::zero(), 0.0);
    assert_eq!(resting, Grip { force: SpaceVector::zero(), torque: 0.0 });
    let straight = patch.sliding(SpaceVector::new(3.0, 4.0, 0.0), 0.0);
    assert!((straight.force.x() + 0.6).abs() < 4.0 * EPS && straight.torque == 0.0);
    // A steel ball of 5 mm under 1 N on steel, 1.1e11 Pa: a few hundredths of a millimetre.
    let radius = Patch::hertz_radius(1.0, 0.005, 1.1e11).unwrap();
    assert!((4.0 * 1.1e11 * radius.powi(3) / (3.0 * 0.005) - 1.0).abs() < 1e-14);
}

/// A ball: slides, and grips after 2 v/(7 mu g) with 5/7 of its speed.
#[test]
fn a_ball_slides_then_rolls() {
    let (mut errors, mut damaged) = (Errors::of("ball"), Errors::of("a hollow ball"));
    for (mass, radius, mu, speed) in
        [(0.1, 0.02, 0.3, 1.0), (3.0, 0.1, 0.05, 2.0), (1e-3, 0.005, 0.5, 0.4)]
    {
        let run = |shape: f64| {
            let inertia = shape * mass * radius * radius;
            let ball = Shape::new(mass, inertia, inertia, 0.0, radius).unwrap();
            let top = Top::new(ball, G).unwrap().on(Dry::new(mu).unwrap());
            let throw =
                Throw { velocity: Some([0.6 * speed, 0.8 * speed]), ..Throw::spinning(0.0, 0.0) };
            let rolled = top.simulate(&throw, 10.0 * speed / (mu * G), 1e-13).unwrap();
            let grips = rolled.event("grips").unwrap().t;
            let end = rolled.configuration(rolled.end_time()).unwrap();
            [
                grips * 3.5 * mu * G / speed - 1.0,
                end.velocity.norm() * 1.4 / speed - 1.0,
                end.slip.norm(),
            ]
        };
        run(0.4).into_iter().for_each(|e| errors.push(e));
        damaged.push(run(2.0 / 3.0)[0]);
    }
    assert_largest!(errors, 9, @"2.62e-11");
    damaged.exceed(0.1, 3);
}

/// The same ball rolls with a resistance: the time to a third of its rate, in closed form.
#[test]
fn a_ball_rolls_to_rest() {
    let (mass, radius, arm) = (0.1_f64, 0.02, 1e-4);
    let inertia = 0.4 * mass * radius * radius;
    let ball = Shape::new(mass, inertia, inertia, 0.0, radius).unwrap();
    let slowing = mass * G * arm / (inertia + mass * radius * radius);
    let (mut errors, mut damaged) = (Errors::of("time"), Errors::of("dry for ever"));
    for rate in [0.1, 5.0, 200.0] {
        let top = Top::new(ball, G).unwrap().on(NoSlip);
        let top = top.resisted_by(RollingResistance::new(arm, rate).unwrap());
        let top = top.passing("third", 20.0, |at, w| {
            hypot(at.angular_velocity.x(), at.angular_velocity.y()) - w
        });
        // Nothing but a nutation rate turns it: it rolls towards X.
        let throw = Throw { nutation: 60.0, ..Throw::spinning(0.0, 0.0) }.rolling();
        let met = top.simulate(&throw, 1e3, 1e-13).unwrap().event("third").unwrap().t;
        let left = |w: f64| {
            let q = hypot(w, rate);
            q + rate * ((q - rate) / w).ln()
        };
        errors.push_at(met * slowing / (left(60.0) - left(20.0)) - 1.0, rate);
        damaged.push(met * slowing / 40.0 - 1.0);
    }
    assert_largest!(errors, 3, @"5.00e-15");
    damaged.exceed(1e-6, 3);
}

/// Upright, what brakes the spin: drilling linearly, a patch the same, air as its law says.
#[test]
fn an_upright_top_runs_down() {
    let (shape, spin, t) = (toy(0.005), 200.0, 20.0);
    let [_, axial] = shape.moments();
    let drilled = 3.0 * PI / 16.0 * 0.2 * 1e-4 * 0.1 * G / axial * t;
    let upright = Throw::spinning(0.0, spin);
    let top = || Top::new(shape, G).unwrap();
    let air = DiscDrag::new(0.03, 1.2, 1.5e-5, spin).unwrap();
    let lost = |end: Configuration| spin - end.spin();
    let by_air = {
        let rate = -air.axial_torque(1.0) / axial;
        let root = 1.0 / spin.sqrt() + 0.5 * rate * t;
        spin - 1.0 / (root * root)
    };
    let ends = [
        lost(
            top()
                .resisted_by(Drilling::new(0.2, 1e-4).unwrap())
                .simulate(&upright, t, 1e-12)
                .unwrap()
                .configuration(t)
                .unwrap(),
        ) - drilled,
        lost(
            top()
                .on(Patch::new(0.2, 1e-4).unwrap())
                .simulate(&upright, t, 1e-12)
                .unwrap()
                .configuration(t)
                .unwrap(),
        ) - drilled,
        lost(
            top()
                .in_effect(air)
                .unwrap()
                .simulate(&upright, t, 1e-12)
                .unwrap()
                .configuration(t)
                .unwrap(),
        ) - by_air,
    ];
    let mut errors = Errors::of("spin lost");
    ends.into_iter().for_each(|e| errors.push(e));
    assert_largest!(errors, 3, @"5.68e-14");
    assert!(drilled > 1.0 && by_air > 1.0);
}

#[test]
fn what_is_no_top_is_refused() {
    let said = |error: Result<(), Error>| error.unwrap_err().to_string();
    let shape = |m, a, l, r| said(Shape::new(m, 4e-5, a, l, r).map(|_| ()));
    assert!(shape(0.0, 4e-5, 0.04, 0.001).contains("mass = 0 is not allowed"));
    assert!(shape(0.1, 9e-5, 0.04, 0.001).contains("none may exceed"));
    assert!(shape(0.1, 4e-5, -0.04, 0.001).contains("lever + tip radius"));
    assert!(shape(0.1, 4e-5, f64::NAN, 0.001).contains("not a finite number"));
    assert!(said(toy(0.005).with_rim(0.03, -0.05).map(|_| ())).contains("above the floor"));
    assert!(said(Dry::new(0.0).map(|_| ())).contains("coefficient of friction = 0"));
    assert!(said(Patch::new(0.1, -1.0).map(|_| ())).contains("contact patch = -1"));
    assert!(said(RollingResistance::new(1e-4, 0.0).map(|_| ())).contains("rate of the rolling"));
    let top = || Top::new(toy(0.005).with_rim(0.03, 0.0).unwrap(), G).unwrap();
    assert!(said(Top::new(toy(0.005), -1.0).map(|_| ())).contains("gravity = -1"));
    assert!(said(top().sloping(1.2).map(|_| ())).contains("slope = 1.2"));
    let weight = GravityAtLever::new(1.0, 0.1).unwrap();
    assert!(said(top().in_effect(weight).map(|_| ())).contains("takes energy"));
    let throw = |throw: Throw, step| said(top().simulate(&throw, 1.0, step).map(|_| ()));
    assert!(throw(Throw::spinning(1.4, 100.0), 1e-9).contains("falls"));
    assert!(throw(Throw::spinning(0.3, f64::NAN), 1e-9).contains("not a finite number"));
    assert!(throw(Throw::spinning(0.3, 100.0), 1.0).contains("tolerance = 1"));
    assert!(throw(Throw::spinning(0.3, 100.0).precessing(200.0), 1e-9).contains("lifts off"));
}
