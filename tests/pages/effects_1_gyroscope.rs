//! The damped gyroscope: its formulas hold for other gyroscopes too, within what they leave
//! out, and damaged twins of them do not.

use crate::answers::{answer, confirmed, refused};
use kit::{But, parse};
use pages::effects_1_gyroscope::*;
use models::gimbals::{Bearing, Bearings, Decay, NutationCycle, Pose};
use rotation_dynamics::math::{cos, log, pow, sin};
use support::{Errors, assert_error, assert_largest};

fn with(change: impl Fn(&mut Parameters)) -> Gyroscope {
    Gyroscope::new(&Parameters::default().but(change)).expect("a gyroscope")
}

#[test]
fn every_gyroscope_is_confirmed() {
    let heavy = "--ring=5e-3 --ring-along=5e-3 --fork=5e-3";
    confirmed(&EXAMPLE, [
        "--rpm=2000", "--rpm=10000", "--theta=0.5", "--theta=1.6", "--theta=0.3", "--theta=1.65",
        "--tilt-dry=0", "--tilt-dry=0.03 --tilt-viscous=0.02", "--tilt-viscous=1e-5",
        "--pivot-dry=2e-3", "--pivot-viscous=1e-3 --rpm=2000",
        "--axle-dry=2e-4 --rpm=2000 --pivot-dry=5e-5", "--stop=2.8", "--stop=1.7 --tolerance=1e-8",
        "--tolerance=1e-13", "--fork=0 --ring=0 --ring-along=0",
        "--theta=0.5 --rpm=2000 --pivot-dry=2e-3",
        "--rpm=2000 --theta=1.6 --stop=1.7 --pivot-dry=2e-3",
    ], 18);
    let slow = ["--rpm=2000 --theta=0.5", "--theta=1.6 --tilt-dry=0.03 --pivot-viscous=1e-3 --axle-dry=2e-4", "--theta=1.6 --rpm=2000 --tilt-viscous=0.02"];
    confirmed(&EXAMPLE, slow.map(|flags| format!("{heavy} {flags}")), 3);
}

#[test]
fn what_is_no_gyroscope_is_refused() {
    refused(&EXAMPLE, [
        ("--ring-along=1e-3", "belong to no body"),
        ("--fork=-1e-4", "fork = -0.0001 is not allowed"),
        ("--rpm=100", "from 2000 to 10000"),
        ("--tilt-dry=0 --tilt-viscous=1e-5", "nods until friction has taken them"),
        ("--theta=0", "theta = 0 is not allowed"),
        ("--stop=1", "from 1.7 to 2.8"),
        ("--tolerance=0", "tolerance = 0"),
        ("--pivot-dry=nan", "pivot-dry"),
    ]);
}

const FAST: [f64; 4] = [4000.0, 5600.0, 8000.0, 10000.0];

/// What a formula leaves out falls with the square of the spin.
fn falls_with_the_square(left_out: impl Fn(f64) -> f64) {
    let logs = FAST.map(|rpm| [log(rpm), log(left_out(rpm).abs())]);
    for pair in logs.windows(2) {
        let order = (pair[1][1] - pair[0][1]) / (pair[1][0] - pair[0][0]);
        assert!((-2.1..-1.9).contains(&order), "{order}: {logs:?}");
    }
}

/// Dip, frequency, and half of the fall: what they leave out falls with the square of the
/// spin. The damaged twins take the rotor's moment alone.
#[test]
fn eq_3_a_fast_rotor_in_gimbals() {
    let off = |rpm: f64, which: usize, bare: bool| {
        let y = with(|p| p.rpm = rpm);
        let nod = NutationCycle::of(&y.gimbals, &y.start).unwrap();
        let (axial, s) = (y.start.axial_momentum, sin(y.start.theta));
        let (p, n) = if bare { (5.45e-3, 5.45e-3 * s * s) } else { (y.gimbals.tilting(), y.gimbals.turning(y.start.theta)) };
        let dip = 2.0 * y.gimbals.weight_moment() * n / (axial * axial * s);
        let period = core::f64::consts::TAU * (p * n).sqrt() / (axial * s);
        match which {
            0 => dip / (nod.theta_max - nod.theta_min) - 1.0,
            1 => period / nod.period - 1.0,
            _ => y.gimbals.weight_moment() / axial * nod.period / nod.precession - 1.0,
        }
    };
    (0..3).for_each(|i| falls_with_the_square(|rpm| off(rpm, i, false)));
    let mut damaged = Errors::of("the rotor alone");
    FAST.iter().for_each(|rpm| (0..2).for_each(|i| damaged.push(off(*rpm, i, true))));
    damaged.exceed(0.04, 8);
}

/// Half of what the fall gives becomes heat.
#[test]
fn eq_4_half_of_the_fall() {
    falls_with_the_square(|rpm| {
        let y = with(|p| p.rpm = rpm);
        let (tilt, heat) = measured::damped(&y, 1e-12).unwrap();
        heat / (y.gimbals.weight_moment() * (cos(y.start.theta) - cos(tilt))) - 0.5
    });
}

/// The number of half nods is a ratio of two torques, whatever the spin and the gimbals; by
/// work and energy it is the very number that is simulated.
#[test]
fn eq_5_half_nods() {
    let (mut errors, mut damaged) = (Errors::of("over m g l sin/2 tau"), Errors::of("m g l sin/tau"));
    for (rpm, dry, fork) in [(3000.0, 3e-3, 2e-4), (6000.0, 3e-3, 2e-3), (10000.0, 2e-3, 0.0), (10000.0, 1e-2, 5e-3)] {
        let y = with(|p| (p.rpm, p.tilt_dry, p.fork) = (rpm, dry, fork));
        let counted = measured::half_nods(&y, 1e-10).unwrap().unwrap();
        assert_eq!(counted, f64::from(ledger::half_nods(&y)));
        let formula = 0.5 * y.pull() / dry;
        errors.push((counted - formula) / (1.0 + formula * y.slowness()));
        damaged.push(counted / (2.0 * formula) - 1.0);
    }
    assert_largest!(errors, 4, @"0.218");
    damaged.exceed(0.4, 4);
}

/// Each bearing alone: a dry pivot lets the nods be, the bearing of the tilt takes them.
#[test]
fn a_dry_pivot_does_not_take_the_nods() {
    let y = with(|_| ());
    let b = Bearings::SMOOTH;
    let left = |bearings: Bearings| {
        let course = y.with(bearings).run(None, 3.0, 1e-10).unwrap();
        let turns = course.turning_points();
        let width = |k: usize| (turns[k + 1].1.theta - 0.5 * (turns[k].1.theta + turns[k + 2].1.theta)).abs();
        width(turns.len() - 3) / width(0)
    };
    let dry = |tau: f64| Bearing::new(0.0, tau).unwrap();
    assert_error!(left(Bearings { azimuth: dry(5e-3), ..b }) - 1.0, 2.49e-3);
    assert!(left(Bearings { tilt: dry(3e-3), ..b }) < 0.4);
}

/// The sag: to first order the torques about the vertical over L_z sin; what is left out falls
/// with the square of the spin. The damaged twin lets friction of the axle lower the axis.
#[test]
fn eq_6_the_sag() {
    let off = |rpm: f64, sign: f64| {
        let y = with(|p| p.rpm = rpm);
        let bearings = Bearings { tilt: Bearing::SMOOTH, air: None, ..y.bearings };
        let axial = y.start.axial_momentum;
        let theory = Decay::of(&y.gimbals, &bearings, 1.0, axial).unwrap();
        let (pivot, axle) = (bearings.azimuth, bearings.axle.dry());
        let about = pivot.dry() + pivot.viscous() * theory.precession - sign * axle * cos(1.0);
        about / (axial * sin(1.0)) / theory.sag - 1.0
    };
    falls_with_the_square(|rpm| off(rpm, 1.0));
    assert!(off(10000.0, -1.0) > 0.1);
}

/// The closed form of the whole sag, and what the air alone does: the fall pays for the kinetic
/// energy of the faster precession.
#[test]
fn eq_7_to_the_stop() {
    let y = with(|p| p.axle_dry = 0.0);
    let course = y.run(Some(2.0), 4000.0, 1e-9).unwrap();
    let end = course.end_time();
    let mut errors = Errors::of("tilt");
    for part in [0.1, 0.3, 0.5, 0.7, 0.9] {
        errors.push(y.sunk(part * end).unwrap() - course.at(part * end).unwrap().theta);
    }
    assert_largest!(errors, 5, @"0.0292");
    // The damaged twin brakes the rotor by its bearings, which push the fork.
    let paid = |bearings: Bearings| {
        let (at, g) = (measured::steady(&y).unwrap().0, &y.gimbals);
        let course = Gyroscope { start: at, ..y.with(bearings) }.run(None, 100.0, 1e-10).unwrap();
        let late = course.at(100.0).unwrap();
        let walks = |at: &Pose| 0.5 * g.turning(at.theta) * pow(at.phi_rate, 2.0);
        let fallen = g.weight_moment() * (cos(at.theta) - cos(late.theta));
        fallen / (walks(&late) - walks(&at)) - 1.0
    };
    assert_error!(paid(Bearings { air: y.bearings.air, ..Bearings::SMOOTH }), 1.39e-9);
    let axle = Bearing::new(0.0, 1e-4).unwrap();
    assert!(paid(Bearings { axle, ..Bearings::SMOOTH }).abs() > 0.5);
}

/// Each line of the ledger, for gyroscopes of all kinds: predicted and measured.
#[test]
fn the_ledger_predicts_what_is_measured() {
    let flags = ["", "--rpm=2000", "--rpm=8000 --theta=1.3", "--fork=2e-3 --ring=1e-3", "--pivot-dry=1e-3 --axle-dry=1e-4"];
    let mut errors = Errors::of("predicted over measured");
    for flags in flags {
        let told = parse(&answer(&EXAMPLE, flags).stdout).expect("a report");
        for row in told.table("table ledger").expect("a ledger").rows() {
            let [predicted, measured] = [3, 4].map(|i| row[i].parse::<f64>().expect("a number"));
            errors.push_at(predicted / measured - 1.0, (flags, &row[0]));
        }
    }
    assert_largest!(errors, 30, @"0.0290");
}
