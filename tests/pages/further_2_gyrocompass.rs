//! A further problem, the gyrocompass. That simulations confirm the formulas is part of the
//! report; here they are asked far from the numbers of a ship, and damaged twins miss.

use crate::answers::{confirmed, refused};
use pages::further_2_gyrocompass::*;
use rotation_dynamics::integrators::{Dop853, Ode, after};
use rotation_dynamics::math::{cos, exp, log, pow, sin, tan};
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use support::{Errors, assert_largest};

#[test]
fn formulas_and_simulations_agree_for_every_compass() {
    let latitudes = [-1.4, -0.3, 0.0, 0.6, 1.3].into_iter();
    let built = |at| {
        ["--spin=300 --tuning=0.3", "--tuning=3 --release=3", "--offset=0.05 --speed=-30"]
            .map(|flags| format!("--latitude={at} {flags}"))
    };
    confirmed(&EXAMPLE, latitudes.flat_map(built), 15);
    let coarse = ["--tolerance=1e-6", "--latitude=0.05 --offset=0.2", "--latitude=1.5", "--latitude=-1.5 --speed=50", "--tuning=0.1 --spin=50000"];
    confirmed(&EXAMPLE, coarse, 5);
    confirmed(&EXAMPLE, [
        "--spin=-1500", "--spin=100000", "--release=-0.5", "--release=3.13", "--release=1e-3",
        "--offset=0", "--offset=0.5", "--latitude=1.5 --offset=0", "--latitude=-1.5 --offset=0.01",
        "--tuning=0.01", "--speed=8000", "--speed=-8000", "--gravity=1", "--latitude=0 --offset=2",
    ], 14);
}

#[test]
fn what_is_no_compass_is_refused() {
    refused(&EXAMPLE, [
        ("--spin=0", "a wheel at rest does not feel the Earth turn"),
        ("--latitude=1.5707963267948966", "no direction is north"),
        ("--latitude=-1.6", "no direction is north"),
        ("--gravity=0.01", "does not hold the axle near the horizon"),
        ("--offset=-0.01", "it feeds the swing"),
        ("--release=0", "it hardly moves"),
        ("--spin=1e7", "its rounding drowns the swing"),
        ("--transverse=0.005", "from 0.5 to 1000"),
        ("--spin=10", "(Foucault's period over the compass's)^2"),
        ("--latitude=1.5 --offset=0.1", "offset times tan(latitude)"),
    ]);
}

/// A wheel with L/I_t = 1 on an Earth that turns at `earth`.
fn wheel(earth: f64, latitude: f64, pendulosity: f64) -> Compass {
    Compass::bare([1.0, 1.0, pendulosity], horizon(earth, latitude, 0.0))
}

/// Foucault's compass on an Earth that turns as fast as a tenth of the nutation.
#[test]
fn eq_1_foucault() {
    let (mut errors, mut damaged) = (Errors::of("rate"), Errors::of("the whole of Omega"));
    for (earth, latitude) in [(0.1, 0.3), (0.1, -1.2), (1e-3, 0.8), (1e-4, 1.4)] {
        let c = wheel(earth, latitude, 0.0);
        let measured = measured_held(c).unwrap();
        errors.push(c.foucault_rate() / measured - 1.0);
        damaged.push((earth * (1.0 - earth)).sqrt() / measured - 1.0);
    }
    assert_largest!(errors, 4, @"2.18e-10");
    damaged.exceed(0.01, 4);
    // At the pole the axle stays wherever it is put; a little off it does not.
    let turned = |latitude| {
        let c = wheel(1e-3, latitude, 0.0);
        let end = after(500.0, &c.held(), &c.start([1.0, 0.0], 0.0), 1e-13).unwrap();
        angles([end[0], end[1], end[2]])[0] - 1.0
    };
    assert!(turned(FRAC_PI_2).abs() < 1e-9);
    assert!(turned(1.47).abs() > 1.0);
}

/// The rates of azimuth and tilt for small angles: what is left out falls with their square. The damaged twin lets the
/// bob push its end of the axle to the east.
#[test]
fn eq_2_small_angles() {
    let (earth, latitude, pull) = (0.1, 0.4, 0.3);
    let c = wheel(earth, latitude, pull);
    let (north, up) = (earth * cos(latitude), earth * sin(latitude));
    let off = |size: f64, pull: f64| {
        let [azimuth, tilt] = [size, 0.7 * size];
        let at = axle(azimuth, tilt).to_array();
        let ([x, y, _], [vx, vy, vz]) = (at, c.port().derivative(0.0, &at));
        let turned = (vx * y - vy * x) / (x * x + y * y) - (up - (pull + north) * tilt);
        turned.abs() + (vz / cos(tilt) - north * azimuth).abs()
    };
    let orders = slopes(&[1e-3, 2e-3, 4e-3], |size| off(size, pull));
    assert!(orders.iter().all(|k| *k > 1.9), "{orders:?}");
    let damaged = slopes(&[1e-3, 2e-3, 4e-3], |size| off(size, -pull));
    assert!(damaged.iter().all(|k| *k < 1.1), "{damaged:?}");
}

/// The slope of the logarithm of `error` over that of its argument, between neighbours.
fn slopes(at: &[f64], error: impl Fn(f64) -> f64) -> Vec<f64> {
    let logs: Vec<[f64; 2]> = at.iter().map(|x| [log(*x), log(error(*x))]).collect();
    logs.windows(2).map(|w| (w[1][1] - w[0][1]) / (w[1][0] - w[0][0])).collect()
}

/// The whole body: its two frequencies on an equator; the squares of the periods add up but for what falls with the
/// rate of the Earth; the amplitude counts by its square.
#[test]
fn eq_4_the_whole_body() {
    let (mut errors, mut damaged) = (Errors::of("whole body"), Errors::of("axle alone"));
    for stiffness in [0.1, 1.0, 10.0, 100.0] {
        let c = wheel(1e-3, 0.0, stiffness);
        let whole = measured_whole(c).unwrap();
        errors.push(c.both()[0] / whole - 1.0);
        damaged.push(c.linear()[1].sqrt() / whole - 1.0);
    }
    assert_largest!(errors, 4, @"6.91e-13");
    damaged.exceed(0.03, 4);

    let off = |stiffness| {
        let c = wheel(1e-6, 0.0, stiffness);
        c.linear()[1].sqrt() / measured_whole(c).unwrap() - 1.0
    };
    let orders = slopes(&[1e-3, 2e-3, 4e-3], off);
    assert!(orders.iter().all(|k| (0.99..1.01).contains(k)), "{orders:?}");
    let added = |c: Compass| {
        let [slow, held] = [c.linear()[1], pow(c.foucault_rate(), 2.0)];
        (1.0 / slow + 1.0 / held) * pow(measured_whole(c).unwrap(), 2.0) - 1.0
    };
    let orders = slopes(&[1e-4, 2e-4, 4e-4], |earth| added(wheel(earth, 0.0, 1.0)).abs());
    assert!(orders.iter().all(|k| (0.98..1.02).contains(k)), "{orders:?}");

    let c = wheel(1e-4, 0.0, 0.1);
    let wide = |size: f64| {
        let (start, method) = (axle(size, 0.0).to_array(), Dop853::new(1e-14).unwrap());
        let back = method.zero(&c.port(), start, 2, 1e6, |y| y[2]).unwrap().0.t;
        back * c.linear()[1].sqrt() / TAU - 1.0
    };
    let orders = slopes(&[0.02, 0.04, 0.08], wide);
    assert!(orders.iter().all(|k| (1.99..2.01).contains(k)), "{orders:?}");
    assert!((wide(0.02) / 2.5e-5 - 1.0).abs() < 1e-2);
}

/// Damping: what is left after half a period, and the azimuth at rest; the formula of the page, offset times tangent,
/// is right to the tilt.
#[test]
fn eq_6_damping() {
    let mut errors = Errors::of("offset tan(latitude)");
    for latitude in [-1.0, -0.4, 0.4, 0.9] {
        let p = Parameters { latitude, ..Parameters::default() };
        let c = Compass { offset: p.offset, ..Compass::new(&p).unwrap() };
        let settled = c.settled(1e-13).unwrap();
        errors.push((p.offset * tan(latitude) - settled[0]) / settled[1]);
        assert!(settled[0] * latitude > 0.0);
    }
    assert_largest!(errors, 4, @"0.0297");
    let p = Parameters::default();
    let c = Compass { offset: p.offset, ..Compass::new(&p).unwrap() };
    let ratio = 0.5 * p.offset * c.linear()[1].sqrt() / c.horizon.y();
    let left = |z: f64| exp(-PI * z / (1.0 - z * z).sqrt());
    let [_, factor] = shrinking(c).unwrap();
    support::assert_error!((left(ratio) - factor).abs(), 2.58e-4);
    assert!((left(2.0 * ratio) - factor).abs() > 0.1);
}
