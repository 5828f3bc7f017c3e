//! A rotor in gimbals: the quadrature against the closed form without gimbals and against
//! DOP853 with them, the equations against the angular velocities of three bodies, and friction
//! against power balance, Coulomb's law and linear theory.

use core::f64::consts::{FRAC_PI_2, PI, TAU};
use models::gimbals::{Bearing, Bearings, Decay, GimbalMotion, Gimbals, Hold, NutationCycle, Pose};
use rotation_dynamics::Error;
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::effects::DiscDrag;
use rotation_dynamics::exact::heavy_top::{HeavyTop, SymmetricTop};
use rotation_dynamics::exact::pendulum::{Pendulum, Suspension};
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::integrators::{Dop853, Integrator, Ode, small_frequency};
use rotation_dynamics::math::{EPS, cos, log, sin, sincos};
use support::{Errors, assert_error, assert_largest};

fn rotor() -> SymmetricTop {
    SymmetricTop::new(5.45e-3, 9e-4, 4.903325, 0.1).expect("a rotor")
}

fn with(ring: [f64; 3], fork: f64) -> Gimbals {
    Gimbals::new(rotor(), ring, fork).expect("gimbals")
}

/// Light gimbals, and gimbals as heavy as the rotor.
fn both() -> [Gimbals; 2] {
    [with([1.5e-4, 1.5e-4, 2e-5], 2e-4), with([4e-3, 5e-3, 3e-3], 6e-3)]
}

fn pose(g: &Gimbals, theta: f64, rates: [f64; 2], spin: f64) -> Pose {
    let [theta_rate, phi_rate] = rates;
    Pose { theta_rate, phi_rate, ..g.released(theta, spin) }
}

fn nod(g: &Gimbals, at: &Pose) -> NutationCycle {
    NutationCycle::of(g, at).unwrap_or_else(|e| panic!("{at:?}: {e}"))
}

#[test]
fn without_gimbals_a_nod_is_that_of_the_heavy_top() {
    let g = with([0.0; 3], 0.0);
    let mut errors = Errors::in_units_of(EPS, "period, advances, tilts");
    let mut damaged = Errors::of("with a fork of a thousandth");
    for theta in [0.4, 1.0, 1.7, 2.6] {
        for spin in [150.0, 314.0, 2000.0, -400.0] {
            for rates in [[0.0, 0.0], [0.0, 3.0], [1.5, -2.0], [-4.0, 9.0]] {
                let at = pose(&g, theta, rates, spin);
                let (s, c) = sincos(theta);
                // L_z is I3 times the component along the axle.
                let omega = BodyVector::new(rates[0], rates[1] * s, spin);
                let angles = EulerAngles { phi: 0.0, theta, zeta: 0.0 };
                let exact = HeavyTop::from_body(rotor(), angles, omega).expect("a top");
                let got = nod(&g, &at);
                // Near the vertical the walk magnifies what the start is off by rounding.
                let close = 1.0 / (sin(got.theta_min) * sin(got.theta_max)).abs();
                for (got, want, scale) in [
                    (got.period, exact.nutation_period(), got.period),
                    (got.precession, exact.precession_per_period(), close),
                    (got.spin, exact.spin_per_period(), close + got.spin.abs()),
                    (got.theta_min, exact.theta_min(), 1.0),
                    (got.theta_max, exact.theta_max(), 1.0),
                ] {
                    errors.add(got, want, scale);
                }
                let heavier = nod(&with([0.0; 3], 5.45e-6), &at);
                damaged.push(heavier.period / exact.nutation_period() - 1.0);
                assert!(c.abs() < 1.0);
            }
        }
    }
    assert_largest!(errors, 320, @"5.12");
    damaged.exceed(1e-6, 64);
}

/// The nods, also through the vertical and right round, against DOP853: the time at which the
/// rate of the tilt is zero the second time, or the tilt has gone a turn.
#[test]
fn with_gimbals_a_nod_is_that_of_the_equations() {
    let mut errors = Errors::of("period, advances of phi and zeta over zeta");
    let mut damaged = Errors::of("ring not moved");
    let mut ways = [0; 4];
    for g in both() {
        for (theta, rates, spin) in [
            (1.0, [0.0, 0.0], 314.0),
            (0.5, [0.0, 8.0], 60.0),
            (2.0, [0.0, -3.0], 100.0),
            (0.05, [0.0, 0.0], 200.0),
            (0.8, [12.0, 0.0], 5.0),
            (2.2, [0.0, 0.0], 3.0),
            (0.6, [40.0, 0.0], 2.0),
            (0.3, [9.0, 0.0], 80.0),
            (0.2, [10.0, 0.0], -90.0),
        ] {
            let at = pose(&g, theta, rates, spin);
            let exact = nod(&g, &at);
            let way = match (exact.theta_min > 0.0, exact.theta_max < PI) {
                (true, true) => 0,
                (false, true) => 1,
                (true, false) => 2,
                (false, false) => 3,
            };
            ways[way] += 1;
            let until = 1.5 * exact.period;
            let method = Dop853::new(1e-14).expect("a method");
            let event = if way == 3 {
                method.zero(&g, at.to_array(), 1, until, |y| y[0] - theta - TAU)
            } else if rates[0] == 0.0 {
                method.zero(&g, at.to_array(), 2, until, |y| y[1])
            } else {
                // Back to the tilt, the same way.
                method.zero(&g, at.to_array(), 2, until, |y| y[0] - theta)
            };
            let (back, _) = event.unwrap_or_else(|e| panic!("{at:?}: {e}"));
            errors.push_at(exact.period / back.t - 1.0, (way, at));
            errors.push_at(exact.precession - back.state[2], (way, at));
            damaged.push(exact.period * (5.45e-3 / g.tilting()).sqrt() / back.t - 1.0);
            errors.push_at((exact.spin - back.state[4]) / (1.0 + exact.spin.abs()), (way, at));
        }
    }
    assert!(ways.iter().all(|&count| count > 0), "{ways:?}");
    assert_largest!(errors, 3 * 18, @"9.41e-14");
    damaged.exceed(1e-3, 18);
}

/// A fork too heavy to turn leaves a pendulum, which may swing through the bottom.
#[test]
fn a_heavy_fork_leaves_a_pendulum() {
    let g = with([0.0; 3], 1e18);
    let swing = nod(&g, &g.released(1.0, 314.0));
    let (mass, gravity, lever) = (1.0, 4.903325, 0.1);
    let suspension = Suspension { moment: 5.45e-3, mass, gravity, lever };
    let exact = Pendulum::new(suspension, PI - 1.0, 0.0).expect("a pendulum");
    assert_error!(swing.period, exact.period(), 0.0 eps);
    assert_error!(swing.theta_max, TAU - 1.0, 0.0 eps);
}

/// Kinetic energy and momenta from the vectors of three bodies.
#[test]
fn energy_and_momenta_are_those_of_rotor_ring_and_fork() {
    let (mut errors, mut damaged) =
        (Errors::in_units_of(EPS, "T, L_Z"), Errors::of("ring unturned"));
    let (ring, fork) = ([4e-3, 5e-3, 3e-3], 6e-3);
    let g = with(ring, fork);
    for (theta, [tilt, walk], spin) in
        [(0.7, [3.0, 2.0], 50.0), (1.9, [-1.0, 4.0], -20.0), (2.8, [0.3, -5.0], 7.0)]
    {
        let at = pose(&g, theta, [tilt, walk], spin);
        let (phi, zeta) = (0.4, 0.9);
        let euler =
            |zeta: f64| Attitude::from_euler(EulerAngles { phi, theta, zeta }).expect("angles");
        let up = SpaceVector::new(0.0, 0.0, 1.0);
        let node = SpaceVector::new(cos(phi), sin(phi), 0.0);
        let of_ring = up * walk + node * tilt;
        let of_rotor = of_ring + euler(0.0).axis() * g.spin_in_ring(&at);
        let on = |zeta: f64, omega: SpaceVector| euler(zeta).to_body(omega).to_array();
        let twice = |moments: [f64; 3], omega: [f64; 3]| -> f64 {
            (0..3).map(|i| moments[i] * omega[i] * omega[i]).sum()
        };
        let rotor = twice([5.45e-3, 5.45e-3, 9e-4], on(zeta, of_rotor));
        let kinetic = |ring_at: [f64; 3]| 0.5 * (rotor + twice(ring, ring_at) + fork * walk * walk);
        let own = g.axis_energy(&at) - 0.4903325 * cos(theta) + g.spin_energy(&at);
        errors.add(own, kinetic(on(0.0, of_ring)), own);
        damaged.push(kinetic(on(0.5, of_ring)) / own - 1.0);
        // dT/dphi' by differences of a quadratic: exact but for rounding.
        let with_walk = |walk: f64| {
            let ring = up * walk + node * tilt;
            let rotor = ring + euler(0.0).axis() * g.spin_in_ring(&at);
            0.5 * (twice([5.45e-3, 5.45e-3, 9e-4], on(zeta, rotor))
                + twice([4e-3, 5e-3, 3e-3], on(0.0, ring))
                + fork * walk * walk)
        };
        let vertical = 0.5 * (with_walk(walk + 1.0) - with_walk(walk - 1.0));
        errors.add(g.vertical_momentum(&at), vertical, kinetic(on(0.0, of_ring)));
    }
    assert_largest!(errors, 6, @"4.84");
    damaged.exceed(1e-6, 3);
}

/// What the equations keep, they keep; with their Lagrangian tested above this is all they say.
#[test]
fn without_friction_energy_and_momentum_stay() {
    let (mut errors, mut damaged) = (Errors::of("energy, L_Z"), Errors::of("without the fork"));
    for g in both() {
        let at = pose(&g, 0.9, [2.0, -1.0], 150.0);
        let (end, _) = Dop853::new(1e-14).unwrap().advance(&g, 0.0, &at.to_array(), 5.0).unwrap();
        let end = Pose::from_array(end);
        errors.add(g.axis_energy(&end), g.axis_energy(&at), g.axis_energy(&at));
        errors.add(g.vertical_momentum(&end), g.vertical_momentum(&at), g.vertical_momentum(&at));
        let bare = with([0.0; 3], 0.0);
        damaged.add(
            bare.vertical_momentum(&end),
            bare.vertical_momentum(&at),
            g.vertical_momentum(&at),
        );
    }
    assert_largest!(errors, 4, @"1.70e-14");
    damaged.exceed(1e-3, 2);
}

#[test]
fn small_nods_have_the_frequency_of_the_formula() {
    let (mut errors, mut damaged) = (Errors::of("frequency"), Errors::of("L sin/sqrt(P N)"));
    for g in both() {
        for (theta, spin) in [(0.6, 200.0), (1.2, 314.0), (2.0, 120.0)] {
            let axial = 9e-4 * spin;
            let phi_rate = g.steady_rate(theta, axial, 0.0).unwrap();
            let rate = g.nodding(theta, axial, phi_rate);
            let kicked =
                |size: f64| pose(&g, theta, [0.1 * size * rate, phi_rate], spin).to_array();
            let measured = small_frequency(&g, kicked, 20.0 / rate, |y| y[0] - theta).unwrap();
            errors.push(rate / measured - 1.0);
            let fast = axial * sin(theta) / (g.tilting() * g.turning(theta)).sqrt();
            damaged.push(fast / measured - 1.0);
        }
    }
    assert_largest!(errors, 6, @"1.30e-12");
    damaged.exceed(1e-3, 6);
}

fn rubbing(tilt: [f64; 2], azimuth: [f64; 2], axle: [f64; 2], air: bool) -> Bearings {
    let bearing = |[viscous, dry]: [f64; 2]| Bearing::new(viscous, dry).expect("a bearing");
    let drag = DiscDrag::new(0.06, DiscDrag::AIR_DENSITY, DiscDrag::AIR_VISCOSITY, 314.0);
    Bearings {
        tilt: bearing(tilt),
        azimuth: bearing(azimuth),
        axle: bearing(axle),
        air: air.then(|| drag.expect("a drag")),
    }
}

/// Bearings of all kinds, weak and strong.
fn frictions() -> [Bearings; 5] {
    [
        rubbing([0.0, 5e-3], [0.0; 2], [0.0; 2], false),
        rubbing([1e-3, 0.0], [1e-3, 0.0], [1e-4, 0.0], true),
        rubbing([0.0; 2], [0.0, 2e-2], [0.0; 2], false),
        rubbing([1e-3, 2e-2], [1e-4, 2e-2], [1e-5, 1e-2], true),
        rubbing([0.0, 0.3], [0.0, 0.1], [0.0, 0.3], false),
    ]
}

/// What the motion loses is heat of the bearings and work of the air.

#[test]
fn energy_lost_is_heat() {
    let off = |tolerance: f64, counted: f64| {
        let mut errors = Errors::of("power balance");
        for (g, b) in both().into_iter().flat_map(|g| frictions().map(|b| (g, b))) {
            let start = g.released(1.0, 314.0);
            let course = GimbalMotion::new(g, b, start, None, 1.0, tolerance).expect("a motion");
            let total = |at: &Pose| g.axis_energy(at) + g.spin_energy(at);
            for t in [0.1, 0.5, 1.0] {
                let at = course.at(t).unwrap();
                let heat: f64 = course.heat(t).unwrap().iter().sum();
                assert!(course.heat(t).unwrap().iter().all(|q| *q >= -1e-12));
                errors.push((total(&start) - total(&at) - counted * heat) / g.weight_moment());
            }
        }
        errors
    };
    assert_largest!(off(1e-12, 1.0), 30, @"5.87e-13");
    off(1e-12, 0.9).exceed(1e-5, 30);
}

/// No stop and no reversal hides in a long step: the changes are the same, one by one, at an
/// error of a step of 1e-8 and at 1e-13.
#[test]
fn no_reversal_is_missed() {
    let mut errors = Errors::of("times of the changes");
    let mut count = 0;
    for (g, b) in both().into_iter().flat_map(|g| frictions().map(|b| (g, b))) {
        let run = |step| GimbalMotion::new(g, b, g.released(1.0, 314.0), None, 2.0, step).unwrap();
        let [coarse, fine] = [run(1e-8), run(1e-13)];
        let names =
            |c: &GimbalMotion| c.changes().iter().map(|c| (c.name, c.to)).collect::<Vec<_>>();
        assert_eq!(names(&coarse), names(&fine));
        count += names(&fine).len();
        for (a, b) in coarse.changes().iter().zip(fine.changes()) {
            errors.push(a.t - b.t);
        }
    }
    assert_largest!(errors, 82, @"3.25e-13");
    assert_eq!(count, 82);
}

/// A bearing that sticks does not move, one that slips moves the way it says, and changes do
/// not chatter: two in succession are never closer than round-off of a nod.
#[test]
fn bearings_hold_and_slip_as_they_say() {
    let (mut held, mut slipped) = (0, 0);
    for (g, b) in both().into_iter().flat_map(|g| frictions().map(|b| (g, b))) {
        let course = GimbalMotion::new(g, b, g.released(1.0, 314.0), None, 2.0, 1e-10).unwrap();
        for k in 1..2000 {
            let t = f64::from(k) * 1e-3;
            let (at, holds) = (course.at(t).unwrap(), course.holds(t).unwrap());
            let rates = [at.theta_rate, at.phi_rate, g.spin_in_ring(&at)];
            for (i, bearing) in [b.tilt, b.azimuth, b.axle].into_iter().enumerate() {
                if bearing.dry() == 0.0 {
                    continue;
                }
                match holds[i] {
                    Hold::Sticks => {
                        assert!(rates[i].abs() < 1e-9, "{t}: {rates:?}");
                        held += 1;
                    }
                    Hold::Forward => assert!(rates[i] > -1e-9, "{t}: {rates:?}"),
                    Hold::Back => assert!(rates[i] < 1e-9, "{t}: {rates:?}"),
                }
                slipped += usize::from(holds[i] != Hold::Sticks);
            }
        }
        let times: Vec<f64> = course.changes().iter().map(|c| c.t).collect();
        assert!(times.windows(2).all(|w| w[0] <= w[1]));
        assert!(times.len() < 1000, "{} changes", times.len());
    }
    assert!(held > 1000 && slipped > 1000, "{held} {slipped}");
}

/// The rotor locks in the ring, and nothing about the vertical has changed by that.
#[test]
fn a_locking_axle_leaves_the_vertical_momentum() {
    let g = both()[0];
    let b = rubbing([0.0; 2], [0.0; 2], [0.0, 0.5], false);
    let start = g.released(1.0, 100.0);
    let course = GimbalMotion::new(g, b, start, None, 1.0, 1e-12).unwrap();
    let locks = course.changes().iter().find(|c| c.name == "axle stops").expect("it locks");
    assert!((locks.t - 9e-4 * 100.0 / 0.5).abs() < 0.1 * locks.t, "{locks:?}");
    let (mut errors, mut damaged) = (Errors::of("L_Z"), Errors::of("L_z"));
    for t in [0.5 * locks.t, locks.t, 1.0] {
        let at = course.at(t).unwrap();
        errors.add(g.vertical_momentum(&at), g.vertical_momentum(&start), 9e-2);
        damaged.add(at.axial_momentum, start.axial_momentum, 9e-2);
    }
    assert_largest!(errors, 3, @"4.85e-14");
    damaged.exceed(0.1, 3);
    let at = course.at(1.0).unwrap();
    assert!(g.spin_in_ring(&at).abs() < 1e-9 && course.holds(1.0).unwrap()[2] == Hold::Sticks);
}

/// Viscous friction of either bearing: the decay of small swings about the steady precession.
#[test]
fn viscous_friction_takes_small_nods_as_linear_theory_says() {
    let (mut errors, mut damaged) = (Errors::of("decay"), Errors::of("tilt bearing alone"));
    for g in both() {
        for (tilt, azimuth) in [(2e-3, 0.0), (0.0, 1e-5), (2e-3, 1e-5), (2e-2, 1e-5)] {
            let b = rubbing([tilt, 0.0], [azimuth, 0.0], [0.0; 2], false);
            let (theta, axial) = (1.0, 0.9);
            let theory = Decay::of(&g, &b, theta, axial).unwrap();
            let start = Pose {
                theta_rate: 1e-3 * theory.frequency,
                phi_rate: theory.precession,
                ..g.released(theta, 1e3)
            };
            let course =
                GimbalMotion::new(g, b, start, None, 25.0 * PI / theory.frequency, 1e-13).unwrap();
            let turns = course.turning_points();
            let at = |k: usize| turns[k].1.theta;
            let width = |k: usize| at(k + 1) - 0.5 * (at(k) + at(k + 2));
            let measured = log(width(0) / width(20)) / (turns[21].0 - turns[1].0);
            errors.push(theory.decay / measured - 1.0);
            damaged.push(0.4 * tilt / g.tilting() / measured - 1.0);
        }
    }
    // What is left is the sinking of the axis, which changes the nods as it goes.
    assert_largest!(errors, 8, @"4.25e-3");
    damaged.exceed(0.1, 8);
}

/// Dry friction of the tilt: each turning point is nearer to the balance by the same amount,
/// and the last one sticks within half of it.
#[test]
fn dry_friction_takes_equal_steps() {
    let g = both()[0];
    let b = rubbing([0.0, 2e-3], [0.0; 2], [0.0; 2], false);
    let axial = 9e-4 * 3e3;
    let start = g.released(1.0, 3e3);
    // L_Z is kept: the bottom of the valley stays where it is.
    let vertical = g.vertical_momentum(&start);
    let nod = nod(&g, &start);
    let bottom = 0.5 * (nod.theta_min + nod.theta_max);
    let theory = Decay::of(&g, &b, bottom, axial).unwrap();
    let course = GimbalMotion::new(g, b, start, None, 1.0, 1e-13).unwrap();
    let stops: Vec<f64> =
        course.changes().iter().filter(|c| c.name == "tilt stops").map(|c| c.pose.theta).collect();
    let count = ((bottom - 1.0) / theory.shortening - 0.5).ceil();
    assert!((stops.len() as f64 - count).abs() <= 1.0, "{} {count}", stops.len());
    let (mut errors, mut damaged) = (Errors::of("shortening"), Errors::of("of the rotor alone"));
    let bare = Decay::of(&with([0.0; 3], 0.0), &b, bottom, axial).unwrap().shortening;
    for three in stops.windows(3).take(50) {
        let step = 0.5 * ((three[0] - three[1]).abs() - (three[1] - three[2]).abs());
        errors.push(step / theory.shortening - 1.0);
        damaged.push(step / bare - 1.0);
    }
    assert_largest!(errors, 50, @"1.87e-4");
    damaged.exceed(0.05, 50);
    let end = course.at(1.0).unwrap();
    assert!((end.theta - bottom).abs() < 0.6 * theory.shortening);
    assert!((g.vertical_momentum(&end) - vertical).abs() < 1e-10);
}

/// Sag: pivot down, axle up, air neither but for what slows the spin; the slow motion alone and
/// everything simulated, without nods, for half a minute.
#[test]
fn the_axis_sinks_and_rises_as_the_slow_motion_says() {
    let g = both()[0];
    let (mut errors, mut damaged) =
        (Errors::of("tilt"), Errors::of("torques about the vertical alone"));
    let mut senses = Vec::new();
    for b in [
        rubbing([1e-3, 0.0], [0.0, 2e-3], [0.0; 2], false),
        rubbing([1e-3, 2e-3], [1e-4, 1e-3], [0.0; 2], false),
        rubbing([1e-3, 0.0], [0.0; 2], [0.0, 2e-3], false),
        rubbing([1e-3, 0.0], [0.0; 2], [0.0; 2], true),
    ] {
        let axial = 9e-4 * 314.0;
        let phi_rate = g.steady_rate(1.0, axial, 0.0).unwrap();
        let start = Pose { phi_rate, ..g.released(1.0, 314.0) };
        let course = GimbalMotion::new(g, b, start, None, 30.0, 1e-11).unwrap();
        let slow = Decay::slow(g, b);
        let (end, _) =
            Dop853::new(1e-12).unwrap().advance(&slow, 0.0, &[1.0, 0.0, axial], 30.0).unwrap();
        let sank = course.at(30.0).unwrap().theta - 1.0;
        errors.push((end[0] - 1.0) / sank - 1.0);
        let about = b.azimuth.dry() + b.azimuth.viscous() * phi_rate - b.axle.dry() * cos(1.0);
        damaged.push(30.0 * about / (axial * sin(1.0)) / sank - 1.0);
        senses.push(sank > 0.0);
        assert!(slow.derivative(0.0, &[1.0, 0.0, axial])[0] * sank > 0.0);
    }
    assert_largest!(errors, 4, @"9.87e-4");
    damaged.exceed(0.01, 4);
    assert_eq!(senses, [true, true, false, true]);
}

#[test]
fn what_is_no_gyroscope_is_refused() {
    let refused =
        |ring: [f64; 3], fork: f64| Gimbals::new(rotor(), ring, fork).unwrap_err().to_string();
    assert!(
        refused([-1e-4, 0.0, 0.0], 0.0)
            .contains("moment of the ring about the line of nodes = -0.0001")
    );
    assert!(refused([1.0, 1.0, 3.0], 0.0).contains("belong to no body"));
    assert!(refused([0.0; 3], f64::NAN).contains("moment of the fork = NaN"));
    assert!(Bearing::new(-1.0, 0.0).unwrap_err().to_string().contains("viscous coefficient"));
    assert!(Bearing::new(0.0, -1.0).unwrap_err().to_string().contains("dry torque"));
    let g = both()[0];
    let slow = g.steady_rate(0.5, 1e-3, 0.0).unwrap_err().to_string();
    assert!(slow.contains("1 or more"), "{slow}");
    let bad = Pose { theta: f64::NAN, ..g.released(1.0, 1.0) };
    assert!(NutationCycle::of(&g, &bad).is_err());
    let run = |theta: f64, t: f64| {
        GimbalMotion::new(g, Bearings::SMOOTH, g.released(theta, 300.0), Some(2.0), t, 1e-9)
    };
    assert!(run(2.5, 1.0).unwrap_err().to_string().contains("less than the tilt at the stop"));
    let late = run(1.0, 0.5).unwrap().at(0.6).unwrap_err();
    assert!(matches!(late, Error::OutsideRun { .. }));
    // On the separatrix a nod takes for ever.
    let upright = nod(&g, &g.released(FRAC_PI_2, 300.0)).period;
    assert!(upright.is_finite());
}
