//! The kinds of motion.

use super::motions::{by_angles, by_body, by_energy};
use rotation_dynamics::exact::heavy_top::{ReducedTop, Regime, Start};
use support::{Errors, assert_largest};

#[test]
fn each_regime_is_recognised() {
    use Start::{ThetaMax, ThetaMin};
    let steady = |b: f64| {
        let top = ReducedTop::new(2.0, b, 0.2).expect("a top");
        by_energy(2.0, b, 0.2, top.minimum().1, ThetaMin)
    };
    let cases = [
        (steady(1.2), Regime::Steady),
        (steady(0.6), Regime::Steady),
        (by_energy(2.0, 1.2, 0.2, 0.55, ThetaMin), Regime::Waves),
        (by_energy(2.0, 0.6, 0.2, 0.11, ThetaMin), Regime::Loops),
        (by_energy(2.0, 0.6, 0.2, -0.08, ThetaMin), Regime::Cusps),
        (by_energy(1.5, 0.5, 0.25, -0.125, ThetaMax), Regime::Cusps),
        (by_energy(2.0, 0.6, 0.2, -0.085, ThetaMax), Regime::Waves),
        (by_energy(1.0, 1.0, 0.5, 0.0, ThetaMin), Regime::Sleeping),
        (by_energy(1.0, 1.0, 0.2, 0.0, ThetaMax), Regime::Sleeping),
        (by_energy(1.0, 1.0, 0.5, 0.0, ThetaMax), Regime::Homoclinic),
        (by_angles(1.0, 1.0, 0.5, 0.0, 1e-3), Regime::PassesPole),
        (by_angles(1.0, 1.0, 0.5, 0.0, 0.0), Regime::Sleeping),
        (by_angles(1.0, -1.0, 0.5, 1.0, 0.9), Regime::PassesPole),
        (by_body(2.0, [0.0, 1.0, 0.0], [0.4, 0.0, 0.0]), Regime::Planar),
        (by_body(2.0, [0.3, 0.0, 0.2], [0.0, 0.0, 3.0]), Regime::Sleeping),
    ];
    for (i, (motion, regime)) in cases.iter().enumerate() {
        assert_eq!(motion.regime(), *regime, "case {i}");
    }
    assert_eq!(cases.len(), 15);
}

/// phi' at the turning points decides: the angles themselves tell the same story.
#[test]
fn the_path_goes_back_only_in_loops() {
    for (energy, backwards) in [(0.11, true), (-0.085, false)] {
        let motion = by_energy(2.0, 0.6, 0.2, energy, Start::ThetaMin);
        let period = motion.nutation_period();
        let phi: Vec<f64> =
            (0..=200).map(|i| motion.angles(f64::from(i) * period / 200.0).phi).collect();
        let falls = phi.windows(2).filter(|w| w[1] < w[0]).count();
        let rises = phi.windows(2).filter(|w| w[1] > w[0]).count();
        assert_eq!(falls > 0 && rises > 0, backwards, "{falls} {rises}");
    }
}

/// Upright with b = 1, a = 1 the critical c is 1/4. A kick of 1e-9 stays 1e-9/sqrt(a/4 - c)
/// below it; above it the axis falls to cos = a/(2c) - 1.
#[test]
fn the_sleeping_top_wakes_at_the_critical_spin() {
    let kick = 1e-9;
    let mut errors = Errors::of("largest tilt");
    for c in [0.1, 0.2, 0.2499] {
        let reached = by_angles(1.0, 1.0, c, 0.0, kick).theta_max();
        let linear = kick / (0.25_f64 - c).sqrt();
        errors.push_at(reached / linear - 1.0, c);
    }
    for c in [0.2501, 0.3, 0.5, 2.0] {
        let reached = by_angles(1.0, 1.0, c, 0.0, kick).theta_max();
        let fall = rotation_dynamics::math::acos(0.5 / c - 1.0);
        errors.push_at(reached / fall - 1.0, c);
    }
    assert_largest!(errors, 3 + 4, @"3.12e-12");
}

/// Exactly upright without a transverse rate it sleeps for ever, stable or not.
#[test]
fn exactly_upright_stays_upright() {
    for c in [0.1, 0.3, 50.0] {
        let motion = by_angles(1.0, 1.0, c, 0.0, 0.0);
        for t in [0.0, 1.0, 1e3, 1e9] {
            assert_eq!(motion.angles(t).theta, 0.0);
            assert_eq!(motion.axis(t).to_array(), [0.0, 0.0, 1.0]);
        }
    }
}
