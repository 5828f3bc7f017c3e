//! A scene that calls for few effects: the precession of the equinoxes, from the turning Earth
//! in minutes to the round of the pole in 26 000 years.

#[path = "effects_4_equinoxes/figures.rs"]
mod figures;
#[path = "effects_4_equinoxes/levels.rs"]
pub mod levels;
#[path = "effects_4_equinoxes/nutation.rs"]
pub mod nutation;
#[path = "effects_4_equinoxes/sky.rs"]
pub mod sky;

use core::f64::consts::{PI, TAU};
use kit::prelude::*;
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::{KeplerOrbit, OrbitingBody};
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::{Dop853, Ode, Solution, ode, size_or};

/// One second of arc (rad), a day and a Julian year (s).
pub const ARCSEC: f64 = PI / 648_000.0;
pub const DAY: f64 = 86_400.0;
pub const YEAR: f64 = 365.25 * DAY;

parameters! {
    /// Earth, Sun and Moon at the epoch J2000.
    pub struct Parameters {
        /// (C - A)/C of the Earth
        ellipticity: number(3.273_794_92e-3, "-", from_to(1e-4, 0.01).because("a rounder Earth does not precess in the time simulated, a flatter one is not a fast top").usually(0.002, 0.005)).open("(C - A)/C of the Earth", "nearly round", "flat");
        /// one turn against the stars
        day: number(86_164.098_9, "s", from_to(5e4, 1.5e5).because("the laws are those of a fast top that is nearly a sphere").usually(7e4, 1e5));
        /// tilt of the equator to the ecliptic
        obliquity: number(0.409_092_600_6, "rad", from_to(0.1, 0.7).because("towards 0 the axis has no direction to go round in, towards pi/2 squares of the nutation count").usually(0.38, 0.43)).open("tilt of the equator", "small", "large");
        /// eccentricity of the Sun's orbit, seen from the Earth
        sun_eccentricity: number(0.016_708_6, "-", from_to(0.0, 0.1).because("the nutation is that of nearly circular orbits").usually(0.0, 0.06));
        /// mean distance of the Moon
        moon_distance: number(3.843_99e8, "m", from_to(3e8, 6e8).because("nearer its nutation is not small, farther the Sun outdoes it").usually(3.5e8, 4.2e8));
        /// eccentricity of its orbit
        moon_eccentricity: number(0.0549, "-", from_to(0.0, 0.1).because("the nutation is that of nearly circular orbits").usually(0.0, 0.1));
        /// inclination of its orbit to the ecliptic
        moon_inclination: number(0.089_804_1, "rad", from_to(0.0, 0.15).because("the nutation is that of a small inclination").usually(0.0, 0.12));
        /// time in which its node goes once round
        node_period: number(18.5996, "a", from_to(12.0, 30.0).because("a node goes back, as the Sun makes it: in years, and in less than a round of the equinoxes").usually(15.0, 22.0));
        /// length of the simulation of the full body
        days: number(30.0, "d", from_to(5.0, 100.0).because("more days of the whole body take too long to simulate").usually(10.0, 60.0));
        /// error of a step of the axis
        tolerance: number(1e-11, "-", from_to(1e-14, 1e-10));
    }
}

/// G m of Sun and Moon (m^3/s^2), the astronomical unit (m), the periods of their
/// perigees and of the Moon's apsides (d).
const SUN: f64 = 1.327_124_400_18e20;
const MOON: f64 = 4.902_800e12;
pub const AU: f64 = 1.495_978_707e11;
const ANOMALISTIC_YEAR: f64 = 365.259_636;
const ANOMALISTIC_MONTH: f64 = 27.554_55;
const APSIDES: f64 = 3232.6;

/// The normal of the ecliptic.
pub const UP: SpaceVector = SpaceVector::new(0.0, 0.0, 1.0);

// ANCHOR: bodies
/// The Sun on its ellipse; X is the equinox of the epoch.
pub fn sun(p: &Parameters) -> rotation_dynamics::Result<OrbitingBody> {
    let period = ANOMALISTIC_YEAR * DAY;
    let orbit = KeplerOrbit::elliptic(AU, period, p.sun_eccentricity)?
        .oriented(0.0, 0.0, 282.937_f64.to_radians())?
        .passing_at((1.0 - 357.529 / 360.0) * period)?;
    OrbitingBody::new(SUN, orbit)
}

/// The Moon on an inclined ellipse whose node goes backward and whose apsides go forward.
pub fn moon(p: &Parameters) -> rotation_dynamics::Result<OrbitingBody> {
    let (period, node) = (ANOMALISTIC_MONTH * DAY, -TAU / (p.node_period * YEAR));
    let [at_node, argument] = [125.044_52, 318.308_7].map(f64::to_radians);
    let orbit = KeplerOrbit::elliptic(p.moon_distance, period, p.moon_eccentricity)?
        .oriented(at_node, p.moon_inclination, argument)?
        .turning(node, TAU / (APSIDES * DAY) - node)?
        .passing_at(-134.9634 / 360.0 * period)?;
    OrbitingBody::new(MOON, orbit)
}
// ANCHOR_END: bodies

/// The rate of the daily turn, rad/s.
pub fn spin(p: &Parameters) -> f64 {
    TAU / p.day
}

// ANCHOR: axis
/// A direction n and a strength g = G m/r^3, as an attracting body has them.
pub type Pull = (SpaceVector, f64);

/// The axis s of a fast top: its angular momentum C Omega s follows the torques
/// 3 g n x (I n) = 3 g (C - A) (n s) n x s.
pub fn axis<const N: usize>(p: &Parameters, pulls: impl Fn(f64) -> [Pull; N]) -> impl Ode<3> {
    let factor = 3.0 * p.ellipticity / spin(p);
    ode(move |t, y: &[f64; 3]| {
        let s = SpaceVector::from_array(*y);
        let mut rate = SpaceVector::zero();
        for (n, g) in pulls(t) {
            rate += n.cross(&s) * (factor * g * n.dot(&s));
        }
        rate.to_array()
    })
    .scaled(size_or([1.0; 3]))
}

/// Under Sun and Moon where they are, at every time.
pub fn in_orbit(p: &Parameters) -> Result<impl Ode<3>> {
    let (sun, moon) = (sun(p)?, moon(p)?);
    Ok(axis(p, move |t| [sun.pull(t), moon.pull(t)]))
}

/// Each averaged over its orbit: the normal of the orbit, and a strength that is negative.
pub fn as_rings(p: &Parameters) -> Result<impl Ode<3>> {
    let (sun, moon) = (sun(p)?.averaged()?, moon(p)?.averaged()?);
    Ok(axis(p, move |t| [sun.pull(t), moon.pull(t)]))
}

/// The Moon's ring averaged over the round of its node, too: all about one normal.
pub fn as_one(p: &Parameters) -> Result<impl Ode<3>> {
    let (sun, moon) = (sun(p)?.averaged()?.pull(0.0).1, moon(p)?.averaged()?.pull(0.0).1);
    let s = sin(p.moon_inclination);
    Ok(axis(p, move |_| [(UP, sun + moon * (1.0 - 1.5 * s * s))]))
}
// ANCHOR_END: axis

/// The precession (rad, negative: against the way of the Sun) and the tilt of an axis; the
/// mean axis of the epoch has the precession 0.
pub fn angles([x, y, z]: [f64; 3]) -> [f64; 2] {
    [atan2(-x, y), atan2(hypot(x, y), z)]
}

/// The axis with these angles.
pub fn pole([precession, tilt]: [f64; 2]) -> [f64; 3] {
    let ((s, c), (si, ci)) = (sincos(precession), sincos(tilt));
    [-si * s, si * c, ci]
}

// ANCHOR: formulas
/// The mean rates of precession by Sun and Moon in closed form, rad/s.
pub fn rates(p: &Parameters) -> [f64; 2] {
    let mean = |mass: f64, axis: f64, e: f64| mass / pow(axis * (1.0 - e * e).sqrt(), 3.0);
    let s = sin(p.moon_inclination);
    let by = -1.5 * cos(p.obliquity) * p.ellipticity / spin(p);
    [
        by * mean(SUN, AU, p.sun_eccentricity),
        by * mean(MOON, p.moon_distance, p.moon_eccentricity) * (1.0 - 1.5 * s * s),
    ]
}
// ANCHOR_END: formulas

/// Both together.
pub fn rate(p: &Parameters) -> f64 {
    rates(p).into_iter().sum()
}

/// In seconds of arc a year.
pub fn yearly(rate: f64) -> f64 {
    rate * YEAR / ARCSEC
}

/// The axis of the epoch: the mean one, with so many terms of the nutation. In its orbits it
/// has three, as the ring of the Moon one, that of the node.
pub fn start(p: &Parameters, terms: usize) -> rotation_dynamics::Result<[f64; 3]> {
    let [precession, tilt] = nutation::at(p, 0.0, terms)?;
    Ok(pole([precession, p.obliquity + tilt]))
}

/// The axis by this law from the epoch, begun with so many terms, to `end` (s).
pub fn run(p: &Parameters, law: &impl Ode<3>, terms: usize, end: f64) -> Result<Solution<3>> {
    Ok(Dop853::new(p.tolerance)?.solve(law, 0.0, &start(p, terms)?, end, &[])?)
}

/// By what angle it goes round in that time.
pub fn gone_round(p: &Parameters, law: &impl Ode<3>, terms: usize, end: f64) -> Result<f64> {
    let run = run(p, law, terms, end)?;
    Ok(angles(*run.end_state())[0] - angles(start(p, terms)?)[0])
}

/// The Earth with its three axes, C = 1, and its state at the epoch: it turns about `axis`.
pub fn earth(p: &Parameters, axis: [f64; 3]) -> Result<(RigidBody, State)> {
    let body = RigidBody::new(PrincipalMoments::symmetric(1.0 - p.ellipticity, 1.0)?);
    let [precession, tilt] = angles(axis);
    let x = SpaceVector::new(1.0, 0.0, 0.0);
    let attitude =
        Attitude::about_space_axis(UP, precession)? * Attitude::about_space_axis(x, -tilt)?;
    let state = body.state(attitude, BodyVector::new(0.0, 0.0, spin(p)))?;
    Ok((body, state))
}

/// The angle between two directions, seconds of arc.
pub fn apart(a: SpaceVector, b: SpaceVector) -> f64 {
    atan2(a.cross(&b).norm(), a.dot(&b)) / ARCSEC
}

fn precession(p: &Parameters, report: &mut Report) -> Result<()> {
    let ([sun_rate, moon_rate], both) = (rates(p), rate(p));
    // The Sun alone, from one perigee to the next: all that is not the mean comes back.
    let (own, year) = (sun(p)?, ANOMALISTIC_YEAR * DAY);
    let by_sun = gone_round(p, &axis(p, |t| [own.pull(t)]), 0, year)? / year;
    // The Moon's ring while its node goes from the equinox to the equinox.
    let ring = moon(p)?.averaged()?;
    let round = TAU / (TAU / (p.node_period * YEAR) + moon_rate);
    let by_moon = gone_round(p, &axis(p, |t| [ring.pull(t)]), 1, round)? / round;
    let by_both = nutation::spectrum(p)?.0;
    // In a year the equinox has moved, and with it the phase of the half-yearly nutation.
    let [longitude, tilt] = nutation::first_order(p)?[1];
    let phase = 3.0 * (longitude + 2.0 * tilt) * (sun_rate * year).abs();
    // Products of two nutations of the node have a mean, which the first order leaves out.
    let second = nutation::crossed(p)?;
    let crossed = 2.0 * second.abs() + 1e-6 * yearly(both).abs();
    let halves = 3.0 * TAU * ARCSEC * (longitude + tilt) * (longitude + tilt);
    // The nutation of the node is taken off, to first order: a part of the precession in a round
    // of the node is left of it.
    let great = TAU / both.abs() / YEAR;
    let [begins, ends] = [0.0, great * YEAR].map(|t| nutation::at(p, t, 1));
    let left = gone_round(p, &as_rings(p)?, 1, great * YEAR)? - ends?[0] + begins?[0];
    let node = nutation::first_order(p)?[0][0] * TAU / great * nutation::node_round(p) / YEAR;
    claims! { report,
        /// precession by the Sun, a year
        sun: yearly(sun_rate), "arcsec", "its orbit, simulated" => yearly(by_sun), within phase, in "The mean precession":
            2.0 * yearly(sun_rate) => "the torque is greatest at the solstices and nothing at the equinoxes",
            -yearly(sun_rate) => "which way does the equinox go?";
        /// precession by the Moon, a year
        moon: yearly(moon_rate), "arcsec", "its ring, simulated" => yearly(by_moon), within crossed, in "The mean precession":
            yearly(moon_rate) / MOON * 4.035_032e14 => "that is the mass of the Earth and the Moon";
        /// precession by both, a year
        both: yearly(both), "arcsec", "both in their orbits, simulated" => yearly(by_both), within crossed + halves,
        in "The mean precession";
        /// what the nutation of the node adds in the mean, by its square
        crossed: 1e3 * second, "mas", "the Moon's ring, simulated" => 1e3 * yearly(by_moon - moon_rate), within 40.0 * second.abs() + 5e-3;
        /// one round of the equinoxes
        great_year: great, "a", "both rings, simulated" => great * TAU / (TAU - left), within (great * crossed + 2.0 * node) / yearly(both).abs(),
        in "The mean precession":
            TAU / ARCSEC / yearly(sun_rate).abs() => "the Moon does two thirds of it";
    }
}

/// From circles in the ecliptic to the orbits of this page, a line at a time; and from the
/// torque of Sun and Moon to what is observed.
fn ledgers(p: &Parameters, report: &mut Report) -> Result<()> {
    let by = |c: f64, h: f64, n: f64| yearly(-1.5 * c * h * n * n / spin(p));
    let mean_motion = |period: f64, mass: f64| TAU / (period * DAY) * mass.sqrt();
    let n = mean_motion(365.256_363, 1.0);
    let m = mean_motion(27.321_661, 0.012_150_5);
    // The moments of the notes.
    let (f, c) = (0.330_675 / 0.329_591 - 1.0, cos(p.obliquity));
    let circles = [n, m].map(|n| by(c, f / (1.0 + f), n));
    let measured = [n, m].map(|n| by(c, p.ellipticity, n));
    let e = [p.sun_eccentricity, p.moon_eccentricity];
    let stretched = [0, 1].map(|k| measured[k] / pow(1.0 - e[k] * e[k], 1.5));
    let s = sin(p.moon_inclination);
    let inclined = [stretched[0], stretched[1] * (1.0 - 1.5 * s * s)];
    let rows = [
        ("circles in the ecliptic, moments of the notes", circles),
        ("measured (C - A)/C", measured),
        ("ellipses", stretched),
        ("the Moon's orbit inclined", inclined),
        ("the Moon at its mean distance", rates(p).map(yearly)),
    ];
    let columns = ["put in", "by the Sun", "by the Moon", "both"];
    let refined = Table::of("refined", columns, rows, |(name, [sun, moon])| {
        let [sun, moon, both] = [sun, moon, sun + moon].map(|rate| format!("{rate:.3}"));
        Ok([name.into(), sun, moon, both])
    })?;
    let both = yearly(rate(p));
    let rows = [
        ("Sun and Moon, here", both),
        ("geodesic precession", geodesic()),
        ("planets turn the ecliptic", PLANETS),
        ("sum", both + geodesic() + PLANETS),
        ("observed (IAU 2006)", -50.287_961_95),
    ];
    let columns = ["part", "arcsec a year"];
    let told = |(name, rate): (&str, f64)| Ok([name.to_owned(), format!("{rate:.3}")]);
    report.add(vec![refined, Table::of("observed", columns, rows, told)?])
}

/// What the moving ecliptic takes off the precession, chi_A cos(eps) of Capitaine, Wallace and
/// Chapront (2003), arcsec a year.
const PLANETS: f64 = 0.105_564_03 * 0.917_482;

/// (v/c)^2 of the Earth.
const SLOWNESS: f64 = SUN / AU / (299_792_458.0 * 299_792_458.0);

/// The rate (3/2) (v/c)^2 n at which an orbit about the Sun turns a gyroscope, forward, arcsec
/// a year.
fn geodesic() -> f64 {
    1.5 * SLOWNESS * yearly(TAU / 365.256_363 / DAY)
}

fn limits(p: &Parameters, report: &mut Report) -> Result<()> {
    let circle = p.but(|p| p.sun_eccentricity = 0.0);
    let level = p.but(|p| p.moon_inclination = 0.0);
    let slow = p.but(|p| p.day *= 2.0);
    let far = p.but(|p| p.moon_distance = 6e8);
    let kepler = TAU / (ANOMALISTIC_YEAR * DAY);
    let by_hand = -1.5 * cos(p.obliquity) * p.ellipticity * kepler * kepler / spin(p);
    let straight = run(&level, &as_rings(&level)?, 1, 1000.0 * YEAR)?;
    let tilt = angles(*straight.end_state())[1];
    let once = TAU / rate(p).abs();
    let round = run(&level, &as_one(&level)?, 0, TAU / rate(&level).abs())?;
    let back = SpaceVector::from_array(*round.end_state());
    let begun = SpaceVector::from_array(start(&level, 0)?);
    let cube = pow(p.moon_distance / 6e8, 3.0);
    limits! { report,
        /// Kepler's third law: the strength is the square of the mean motion
        "circle: rate by the Sun": rates(&circle)[0] / by_hand => 1.0, within 1e-4;
        /// one torque, about one axis
        "Moon in the ecliptic: tilt after 1000 years": tilt / p.obliquity => 1.0, within 1e-11;
        /// the cone closes
        "the same: off the start after a round": (back - begun).norm() => 0.0, within 1e-8;
        /// the torque falls with the third power
        "Moon at 600000 km: its part": rates(&far)[1] / rates(p)[1] / cube => 1.0, within 1e-13;
        /// faster in proportion to how slowly the Earth turns
        "a day twice as long: round": TAU / rate(&slow).abs() / once => 0.5, within 1e-14;
    }
}

/// The part of the nutation of the node in the tilt by which a rigid Earth has it too large:
/// 9.2273 arcsec with the constants of the epoch, 9.2052 observed.
const CORE: f64 = 9.2273 / 9.2052 - 1.0;

/// The card: what is in, and what the rigid Earth on a fixed ecliptic leaves out.
fn effects(p: &Parameters, report: &mut Report) -> Result<()> {
    let [sun_part, moon_part] = rates(p).map(|rate| yearly(rate).abs());
    let both = sun_part + moon_part;
    let [e, f, i] = [p.sun_eccentricity, p.moon_eccentricity, p.moon_inclination];
    let ratio = 27.321_661 / 365.256_363_f64;
    let node = nutation::first_order(p)?[0];
    let triaxial = 0.0067;
    let quick = 0.5 * triaxial * rate(p).abs() * sin(p.obliquity) / (2.0 * spin(p)) / ARCSEC;
    effect_card! { report, asked 1e-3;
        "the Moon": "part of both" = moon_part / both, costs moon_part, "arcsec a year", beside "both", included;
        "ellipses": "(3/2) e^2 of the Moon's" = 1.5 * f * f,
            costs 1.5 * (e * e * sun_part + f * f * moon_part), "arcsec a year", beside "both", included;
        "inclination of the Moon's orbit": "(3/2) sin(i)^2" = 1.5 * sin(i) * sin(i),
            costs 1.5 * sin(i) * sin(i) * moon_part, "arcsec a year", beside "both", included;
        "the Sun narrows the Moon's orbit": "(1/2) (month/year)^2" = 0.5 * ratio * ratio,
            costs 0.5 * ratio * ratio * moon_part, "arcsec a year", beside "both", included;
        "planets turn the ecliptic": "planets over all" = PLANETS / 50.384_815_07, costs PLANETS, "arcsec a year", beside "both";
        "geodesic precession": "(3/2) (v/c)^2" = 1.5 * SLOWNESS, costs geodesic(), "arcsec a year", beside "both";
        "fluid core and yielding": "part of the nutation of the node" = CORE,
            costs CORE * node[1], "arcsec of the tilt", beside "node_tilt";
        "two different moments in the equator": "(B - A)/(C - A)" = triaxial, costs quick, "arcsec, twice a day", beside "both";
    }
}

example! {
    effects_4_equinoxes: "The precession of the equinoxes: Sun and Moon at the bulge of the Earth, from minutes to 26 000 years";
    "The precession of the equinoxes", "Sun and Moon pull at the bulge of the Earth, at four scales of time.",
    [precession, nutation::claims, levels::claims, sky::claims, ledgers, limits, effects, levels::accuracy];
    figures::figures, figures::trajectory, figures::moving_picture
}
