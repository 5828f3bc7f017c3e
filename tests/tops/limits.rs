//! Ends of the model where the motion is known.

use super::{G, apart, others, toy};
use core::f64::consts::{FRAC_PI_2, PI};
use models::tops::*;
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::exact::heavy_top::{HeavyTop, SymmetricTop};
use rotation_dynamics::frame::BodyVector;
use rotation_dynamics::math::{cos, hypot, log, sin, sincos};
use support::{Errors, assert_largest};

/// A sharp tip that does not slip is the heavy top with a fixed point.
#[test]
fn a_sharp_tip_that_holds_is_the_heavy_top() {
    let (mut errors, mut damaged) = (Errors::of("axis"), Errors::of("a tip of a millimetre"));
    for (tilt, spin, precession) in [(0.4, 150.0, 0.0), (1.0, 300.0, 5.0), (0.2, 90.0, -3.0)] {
        let moment = 4e-5 + 0.1 * 0.04 * 0.04;
        let exact = SymmetricTop::from_mass(moment, 4e-5, 0.1, G, 0.04).unwrap();
        // Leaning towards X without a turn about the own axis.
        let start = EulerAngles { phi: FRAC_PI_2, theta: tilt, zeta: -FRAC_PI_2 };
        let start = Attitude::from_euler(start).unwrap();
        let omega = BodyVector::new(-precession * sin(tilt), 0.0, spin);
        let exact = HeavyTop::new(exact, start, omega).unwrap();
        let off = |tip: f64, errors: &mut Errors| {
            let throw = Throw::spinning(tilt, spin).precessing(precession);
            let top = Top::new(toy(tip), G).unwrap().on(NoSlip);
            let run = top.simulate(&throw, 3.0, 1e-13).unwrap();
            for t in [0.5, 1.7, 3.0] {
                let turned = top.attitude(&run.coordinates(t).unwrap());
                errors.push_at(
                    apart(run.configuration(t).unwrap().axis, exact.attitude(t).axis()),
                    tilt,
                );
                errors.push_at(turned.angle_to(&exact.attitude(t)), tilt);
            }
        };
        off(0.0, &mut errors);
        off(1e-3, &mut damaged);
    }
    assert_largest!(errors, 18, @"5.04e-11");
    damaged.exceed(1e-3, 18);
}

/// On a smooth floor the centre of mass stays above one point: the half period of the nutation
/// is an integral.
#[test]
fn on_a_smooth_floor_the_nutation_is_an_integral() {
    let (mut errors, mut damaged) = (Errors::of("half period"), Errors::of("tip held"));
    for shape in [toy(0.005), others()[0], others()[1]] {
        let ([i1, i3], l, m) = (shape.moments(), shape.lever(), shape.mass());
        let (tilt, spin) = (0.4, 1.3 * 2.0 * (i1 * m * G * l).sqrt() / i3);
        let l3 = i3 * spin;
        let lz = l3 * cos(tilt);
        let turning = |theta: f64| {
            let (s, c) = sincos(theta);
            m * G * l * (cos(tilt) - c) - (lz - l3 * c) * (lz - l3 * c) / (2.0 * i1 * s * s)
        };
        let (mut low, mut high) = (tilt + 1e-4, 3.0);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if turning(middle) > 0.0 { low = middle } else { high = middle }
        }
        let (middle, half) = (0.5 * (tilt + low), 0.5 * (low - tilt));
        let inertia = |theta: f64, held: f64| i1 + m * l * l * (sin(theta) * sin(theta)).max(held);
        let period = |held: f64| {
            // Midpoints: neither end is touched.
            let n = 2000;
            let part = PI / f64::from(n);
            let terms = (0..n).map(|i| {
                let (s, c) = sincos(part * (f64::from(i) + 0.5));
                let theta = middle - half * c;
                half * s * (0.5 * inertia(theta, held) / turning(theta)).sqrt()
            });
            terms.sum::<f64>() * part
        };
        let top = Top::new(shape, G).unwrap();
        let top = top.passing("outer", 0.0, |at, _| -at.angular_velocity.cross(&at.axis).z());
        let run = top.simulate(&Throw::spinning(tilt, spin), 10.0, 1e-13).unwrap();
        let met = run.event("outer").unwrap();
        errors.push(met.t / period(0.0) - 1.0);
        errors.push(run.configuration_at(met).tilt() - low);
        damaged.push(met.t / period(1.0) - 1.0);
    }
    assert_largest!(errors, 6, @"2.81e-12");
    damaged.exceed(0.05, 3);
}

/// The spin with which a top that rolls goes round steadily at this tilt and precession.
fn steady(shape: &Shape, tilt: f64, precession: f64) -> f64 {
    let ([i1, i3], l, m, r) = (shape.moments(), shape.lever(), shape.mass(), shape.tip());
    let (c, p) = (cos(tilt), precession);
    let high = l * c + r;
    (m * G * l + i1 * p * p * c + high * m * p * p * (r * c + l)) / (p * (i3 + high * m * r))
}

#[test]
fn a_rolling_top_goes_round_steadily() {
    let (mut errors, mut damaged) =
        (Errors::of("tilt, precession, force"), Errors::of("other spin"));
    for shape in [toy(0.005), toy(0.0), others()[0], others()[1]] {
        for (tilt, precession) in [(0.3, 4.0), (1.0, 3.0), (0.6, 6.0)] {
            let spin = steady(&shape, tilt, precession);
            let run = |spin: f64| {
                let throw = Throw::spinning(tilt, spin).precessing(precession).rolling();
                let top = Top::new(shape, G).unwrap().on(NoSlip);
                let run = top.simulate(&throw, 2.0, 1e-13).unwrap();
                let (at, forces) = run.forces(1.7).unwrap();
                let (s, c) = sincos(tilt);
                let slips = shape.tip() * (spin - precession * c) - shape.lever() * precession;
                let inward = shape.mass() * precession * s * slips.abs();
                let pull = hypot(forces.friction.x(), forces.friction.y());
                [at.tilt() - tilt, at.precession() / precession - 1.0, pull - inward]
            };
            run(spin).into_iter().for_each(|e| errors.push_at(e, (tilt, precession)));
            damaged.push(run(0.95 * spin)[0]);
        }
    }
    assert_largest!(errors, 36, @"3.44e-12");
    damaged.exceed(1e-4, 12);
}

/// How fast a small tilt grows, from its size at two times.
fn growth<F: TipFriction>(top: &Top<F>, throw: &Throw, [from, to]: [f64; 2]) -> f64 {
    let run = top.simulate(throw, to, 1e-13).unwrap();
    let size = |t: f64| {
        let at = run.configuration(t).unwrap();
        log(hypot(at.axis.x(), at.axis.y()))
    };
    (size(to) - size(from)) / (to - from)
}

/// A tip that rolls lets an upright top fall below 2 sqrt(I1' m g l)/(I3 + m r (l + r)), with
/// I1' = I1 + m (l + r)^2; with a sharp tip this is the limit of the notes.
#[test]
fn a_rolling_tip_lets_a_top_sleep_at_a_lower_spin() {
    let (mut errors, mut damaged) = (Errors::of("growth"), Errors::of("sharp tip"));
    for shape in [toy(0.0), toy(0.005), others()[0], others()[1]] {
        let ([i1, i3], l, m, r) = (shape.moments(), shape.lever(), shape.mass(), shape.tip());
        let moment = i1 + m * (l + r) * (l + r);
        let geared = i3 + m * r * (l + r);
        let critical = 2.0 * (moment * m * G * l).sqrt() / geared;
        for part in [0.5, 0.9] {
            let spin = part * critical;
            let rate = (m * G * l / moment).sqrt() * (1.0 - part * part).sqrt();
            let span = [12.0 / rate, 15.0 / rate];
            let top = Top::new(shape, G).unwrap().on(NoSlip);
            let throw = Throw::spinning(1e-9, spin).rolling();
            errors.push_at(growth(&top, &throw, span) / rate - 1.0, part);
            let sharp = 0.5 * (spin * i3) / (m * G * l * (i1 + m * l * l)).sqrt();
            let other =
                (m * G * l / (i1 + m * l * l)).sqrt() * (1.0 - sharp * sharp).max(0.0).sqrt();
            if r > 0.0 {
                damaged.push(other / rate - 1.0);
            }
        }
        // A little faster it does not grow.
        let top = Top::new(shape, G).unwrap().on(NoSlip);
        let run =
            top.simulate(&Throw::spinning(1e-6, 1.01 * critical).rolling(), 20.0, 1e-12).unwrap();
        assert!((0..200).all(|i| run.configuration(0.1 * f64::from(i)).unwrap().tilt() < 2e-5));
    }
    assert_largest!(errors, 8, @"2.12e-6");
    damaged.exceed(0.01, 6);
}

/// A tip that creeps lets it fall already below the spin with which the precession axis passes
/// through the centre of mass.
#[test]
fn a_creeping_tip_lets_it_fall_earlier() {
    let mut found = 0;
    for shape in [toy(0.005), toy(0.008), others()[0]] {
        let ([i1, i3], l, m, r) = (shape.moments(), shape.lever(), shape.mass(), shape.tip());
        let limit = (l + r) * (m * G * l / (r * (i3 * (l + r) - i1 * r))).sqrt();
        let top = || Top::new(shape, G).unwrap().on(Patch::new(0.03, 1e-4).unwrap());
        let grows =
            |part: f64| growth(&top(), &Throw::spinning(1e-6, part * limit).rolling(), [6.0, 12.0]);
        // Drilling takes a little spin in the meantime.
        let [slower, faster] = [0.98, 1.03].map(grows);
        assert!(slower > 1e-3 && faster < -1e-3, "{slower} {faster}");
        found += 1;
    }
    assert_eq!(found, 3);
}
