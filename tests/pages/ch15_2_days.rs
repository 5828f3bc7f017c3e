//! The day and the stars: the notes' numbers by a turning arrow, the equation of time by an
//! orbit that is integrated, and what the notes slip in or leave out.

use crate::answers::{confirmed, ledger, value};
use kit::prelude::*;
use pages::ch15_2_days::left_out::{by_jupiter, by_light, by_the_moon, later, simulated, spread};
use pages::ch15_2_days::*;
use rotation_dynamics::accuracy::largest;
use std::f64::consts::{PI, TAU};
use support::{Errors, assert_error, assert_largest, beside_twins};

/// Days in some years.
const YEARS: [f64; 4] = [2.5, 20.0, 365.24, 686.98];

/// The Earth's year with this eccentricity and tilt.
fn year(eccentricity: f64, obliquity: f64) -> Parameters {
    with(&Parameters::default(), eccentricity, obliquity)
}

/// The largest difference of two lists of times.
fn apart(a: &[f64], b: &[f64]) -> f64 {
    largest(a.iter().zip(b).map(|(a, b)| a - b))
}

/// P faces the Sun again after a day of 1, whatever the year; with 2 pi alone it would not yet.
#[test]
fn eq_15_5_11_turn_from_noon_to_noon() {
    let late = |year, rate| orbit::facing(rate, TAU / year, 1e-15).unwrap()[0] - 1.0;
    let cases = YEARS.map(|year| [late(year, turn(year)), late(year, TAU)]);
    assert_largest!(beside_twins(cases, 1e-3, 4), 4, @"4.44e-16");
    assert_error!(value(&EXAMPLE, "turn"), 6.300_388_202_008_14, 5.1 eps);
}

/// The rate that the IAU adopted in 2000, to what 365.24 for 365.2422 leaves. The twin: a turn in 24
/// hours.
#[test]
fn ex3b_angular_velocity_of_the_earth() {
    let adopted = TAU * 1.002_737_811_911_354_5 / 86_400.0;
    assert_error!(value(&EXAMPLE, "omega") / adopted - 1.0, 1.14e-7);
    assert_error!(value(&EXAMPLE, "omega"), 7.292_115_974_546_45e-5, 5.0 eps);
    assert!((TAU / 86_400.0 / adopted - 1.0).abs() > 1e-3);
}

/// At the right rate P faces the Sun after a day; at the printed one, in which two years are
/// mixed, it comes late.
#[test]
fn e07_two_years_in_one_quotient() {
    let [right, printed] = ["omega", "omega_printed"].map(|key| value(&EXAMPLE, key));
    let day = |omega: f64| orbit::facing(omega * 86_400.0, TAU / 365.24, 1e-15).unwrap()[0];
    assert_error!((day(right) - 1.0) * 86_400.0, 3.8369e-11);
    assert_error!((day(printed) - 1.0) * 86_400.0, 2.3720);
    assert_error!(printed, 7.291_916_327_291_85e-5, 3.3 eps);
}

/// OP points at the same star again. The twin: the other quotient.
#[test]
fn ex3c_sidereal_day() {
    let cases = YEARS.map(|year| {
        let once = orbit::facing(turn(year), TAU / year, 1e-15).unwrap()[1];
        [once - sidereal(year), once - year / (year - 1.0)]
    });
    assert_largest!(beside_twins(cases, 1e-3, 4), 4, @"1.11e-16");
    assert_error!(value(&EXAMPLE, "sidereal"), 86_164.089_121_887_3, 1.5 eps);
    assert_error!(value(&EXAMPLE, "sidereal_seconds"), 4.089_121_887_287, 2.80e3 eps);
}

/// Turns and years as NASA prints them give the solar days that it prints, in hours. The twin: they
/// turn the other way.
#[test]
fn solar_days_of_others() {
    let bodies = [
        (58.6462, 87.969, 4222.6), (-243.0226, 224.701, 2802.0),
        (1.025_957, 686.980, 24.6597), (27.3217, 365.256, 708.7),
    ];
    let off = |stars, year, hours| solar_day(stars, year).abs() * 24.0 / hours - 1.0;
    let cases = bodies.map(|(stars, year, hours)| [off(stars, year, hours), off(-stars, year, hours)]);
    assert_largest!(beside_twins(cases, 2e-3, 4), 4, @"4.98e-5");
}

/// The day that follows from the tropical year is one against the equinox. The twin: precession along
/// the ecliptic, 50.29 arcsec a year, is not what counts.
#[test]
fn e06_the_equinox_is_no_star() {
    let [equinox, star, notes] = ["mean_sidereal", "stellar", "sidereal"].map(|key| value(&EXAMPLE, key));
    assert_error!(star - equinox, 8.372e-3);
    assert_error!(notes - equinox, 1.410e-3);
    assert_error!(notes - star, 9.783e-3);
    let ecliptic = 5_028.796_195 / 1_296_000.0 / 36_525.0 * equinox * equinox / 86_400.0;
    assert!((ecliptic - (star - equinox)).abs() > 5e-4);
}

/// On a circle with an upright axis every day has 24 hours; on the Earth's they differ.
#[test]
fn e04_the_true_day_is_not_the_mean_day() {
    let p = Parameters::default();
    let days = |e, tilt| Extremes::of(&orbit::noons(&year(e, tilt), 1e-13).unwrap().0, p.day);
    let (mean, real, tilt) = (days(0.0, 0.0), days(p.eccentricity, p.obliquity), days(0.0, p.obliquity));
    assert_error!(mean.longest.0 - mean.shortest.0, 1.7189e-8);
    assert_error!(real.shortest.0, 21.400);
    assert_error!(real.longest.0, 29.876);
    assert_error!(tilt.shortest.0, 19.515);
    assert_error!(tilt.longest.0, 21.280);
}

/// The true angle of the Sun, from the half angles, and Kepler's equation put in; it is not 2 e sin M
/// alone.
#[test]
fn the_orbit_is_keplers() {
    let (mut equation, mut angle) = (Errors::of("Kepler's equation"), Errors::of("angle"));
    let mut first = Errors::of("2 e sin M alone");
    for e in [1e-9, 0.0167, 0.1, 0.3] {
        for mean in (1..24).map(|k| 0.27 * f64::from(k)) {
            let x = eccentric_anomaly(mean, e);
            equation.push(x - e * sin(x) - mean);
            let stretched = ((1.0 + e) / (1.0 - e)).sqrt() * sin(0.5 * x);
            let wanted = 2.0 * atan2(stretched, cos(0.5 * x));
            let centre = Sun::at(mean, &year(e, 0.0).but(|p| p.perigee = 0.0)).centre;
            angle.push(sin(mean + centre - wanted));
            first.push(sin(mean + 2.0 * e * sin(mean) - wanted));
        }
    }
    assert_largest!(equation, 92, @"8.88e-16");
    assert_largest!(angle, 92, @"8.88e-16");
    assert!(first.largest() > 0.05);
}

/// The Sun's place along the equator, from its place in space; it is not y sin 2L alone.
#[test]
fn the_tilt_foreshortens() {
    let (mut errors, mut first) = (Errors::of("the exact form"), Errors::of("y sin 2L alone"));
    for tilt in [1e-6, 0.1, 0.409, 1.2] {
        for longitude in (0..24).map(|k| 0.27 * f64::from(k)) {
            let along = longitude - Sun::at(longitude, &year(0.0, tilt)).reduction;
            let (x, y) = (cos(longitude), cos(tilt) * sin(longitude));
            errors.push(sin(along - atan2(y, x)));
            let y2 = tan(0.5 * tilt) * tan(0.5 * tilt);
            first.push(sin(longitude - y2 * sin(2.0 * longitude) - atan2(y, x)));
        }
    }
    assert_largest!(errors, 96, @"6.43e-16");
    assert!(first.largest() > 0.05);
}

/// Noon after noon, for the Earth's orbit and for others, s; the twin: without the tilt.
#[test]
fn formulas_and_simulated_noons_agree() {
    let earth = Parameters::default().perigee;
    let orbits = [(0.016_708_6, 0.409_09, earth), (0.1, 0.7, 1.0), (0.3, 1.2, 3.0)];
    let cases = orbits.map(|(e, tilt, perigee)| {
        let p = year(e, tilt).but(|p| p.perigee = perigee);
        let (found, _) = orbit::noons(&p, 1e-15).unwrap();
        assert_eq!((found.len(), noons(&p).len()), (367, 367));
        [&p, &with(&p, e, 0.0)].map(|p| apart(&found, &noons(p)) * 86_400.0)
    });
    assert_largest!(beside_twins(cases, 500.0, 3), 3, @"9.82e-9");
}

/// Meeus, example 28: 13 October 1992, 0 h. By his mean elements the series gives 13 min 42.7 s,
/// and the full theory, with the planets and the light's aberration, 13 min 42.6 s. The twin: the
/// series to first order.
#[test]
fn a_published_instant_is_met() {
    let degrees = PI / 180.0;
    let (mean, anomaly) = (201.807_20 * degrees, 278.993_96 * degrees);
    let p = year(0.016_711_651, 23.440_23 * degrees).but(|p| p.perigee = mean - anomaly + TAU);
    let seconds = Sun::at(mean, &p).equation_of_time() * 86_400.0 / TAU;
    assert_error!(seconds - 822.6, 0.47);
    let y = tan(0.5 * p.obliquity) * tan(0.5 * p.obliquity);
    let first = y * sin(2.0 * mean) - 2.0 * p.eccentricity * sin(anomaly);
    assert!((first * 86_400.0 / TAU - 822.6).abs() > 5.0);
}

#[test]
fn other_years_and_orbits_are_confirmed() {
    confirmed(&EXAMPLE, [
        "--year=20", "--eccentricity=0.3 --obliquity=1.4 --year=25",
        "--eccentricity=0 --obliquity=0", "--year=1500.5 --perigee=0",
        "--mean-longitude=0 --day=1 --tolerance=1e-6", "--day=1e9 --picture-year=20",
    ], 6);
    let p = Parameters::default();
    assert_eq!([42, 366].map(|day| date(&p, day)), ["12 February", "1 January"]);
    assert_eq!(date(&p.but(|p| p.year = 20.0), 3), "day 3");
}

/// A round orbit, an upright axis, long and short years: each figure and each still is drawn.
#[test]
fn drawn_for_any_orbit() {
    for (e, tilt, days) in [(0.0, 0.0, 365.24), (0.3, 1.4, 20.0), (0.1, 0.0, 700.0)] {
        let p = year(e, tilt).but(|p| p.year = days);
        assert_eq!(EXAMPLE.figures(&p).unwrap().len(), 9);
    }
}

/// The card, for the Earth and for other orbits: noons later by one step from the closed form,
/// against simulated years. In the damaged twin the Sun is seen on the other side.
#[test]
fn what_is_left_out_is_as_large_as_predicted() {
    assert_eq!(ledger(&EXAMPLE, "").len(), 4);
    let (p, light) = (Parameters::default(), by_light(499.0 / 86_400.0));
    let years = [p.clone(), year(0.1, 0.7), year(0.3, 1.2), p.but(|p| p.year = 30.5)];
    let cases = years.into_iter().flat_map(|p| {
        let pairs = [
            (later(&p, &by_the_moon).unwrap(), simulated(&p, &by_the_moon).unwrap().0),
            (later(&p, &light).unwrap(), simulated(&p, &light).unwrap().0),
        ];
        pairs.map(|(predicted, measured)| {
            assert_eq!(predicted.len(), measured.len());
            let opposite: Vec<f64> = measured.iter().map(|x| -x).collect();
            [&measured, &opposite].map(|shifts| apart(&predicted, shifts) / spread(&measured))
        })
    });
    assert_largest!(beside_twins(cases, 1.0, 8), 8, @"1.21e-3");
}

/// Newcomb's terms of the Earth's longitude by Jupiter are 7.208 and 2.731 arcsec, of the angle
/// from Jupiter and of twice that angle, with opposite signs: together 8.5. It goes with its mass. The
/// twin: its first term alone.
#[test]
fn jupiter_moves_the_earth_as_newcomb_has_it() {
    let arcsec = 1_296_000.0 / TAU;
    let newcomb = |x: f64| 7.208 * sin(x) - 2.731 * sin(2.0 * x);
    let most = (0..1000).map(|k| newcomb(PI * f64::from(k) / 1000.0)).fold(0.0, f64::max);
    let found = by_jupiter(1.0 / 1047.35).unwrap().0 * arcsec;
    assert_error!(found / most - 1.0, 1.73e-3);
    assert_error!(by_jupiter(1e-5).unwrap().0 * arcsec / found / 1047.35e-5 - 1.0, 1.04e-5);
    assert!((found / 7.208 - 1.0).abs() > 0.1);
}
