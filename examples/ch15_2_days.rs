//! The day and the stars, notes, Chapter 15, Section 2, example 3: how far the Earth turns from
//! noon to noon, and why the noons of a sundial are not 24 hours apart.

#[path = "ch15_2_days/figures.rs"]
mod figures;
#[path = "ch15_2_days/left_out.rs"]
pub mod left_out;
#[path = "ch15_2_days/orbit.rs"]
pub mod orbit;
#[path = "ch15_2_days/year.rs"]
mod year;

use core::f64::consts::{PI, TAU};
use kit::prelude::*;
use kit::short;
use rotation_dynamics::accuracy::largest;
use rotation_dynamics::integrators::{Dop853, Event, Integrator, Ode, Work, ode, size_or};
pub use year::{Extremes, date, extremes};

parameters! {
    /// The notes' year and day; the Earth's orbit and axis at the epoch J2000.
    pub struct Parameters {
        /// solar days in a year
        year: number(365.24, "d", from_to(20.0, 2000.0).because("the Sun is followed day by day through one year").usually(20.0, 500.0));
        /// length of the mean solar day
        day: number(86400.0, "s", from_to(1.0, 1e9).usually(3600.0, 200000.0));
        /// eccentricity of the orbit
        eccentricity: number(0.0167086342, "-", from_to(0.0, 0.3).because("on a longer ellipse the days differ too much to be counted so").usually(0.0, 0.1));
        /// tilt of the axis, from the normal of the orbit
        obliquity: number(0.409_092_600_600_583, "rad", from_to(0.0, 1.4).because("with its pole in the plane of the orbit a planet has no regular solar day").usually(0.0, 0.8));
        /// longitude at which the Sun is seen when it is nearest
        perigee: number(4.938_188_300_857_257, "rad", from_to(0.0, TAU).because("a full turn"));
        /// mean longitude of the Sun at noon of 1 January 2000
        mean_longitude: number(4.895_063_113_086_038, "rad", from_to(0.0, TAU).because("a full turn"));
        /// days in the year of the moving picture
        picture_year: number(6.0, "d", from_to(2.0, 20.0).because("more days cannot be seen in a picture").usually(2.0, 12.0)).open("length of the year", "a day is no turn", "a day is nearly a turn");
        /// error of a step of the runs
        tolerance: number(1e-13, "-", from_to(1e-15, 1e-6));
    }
}

// ANCHOR: days
/// The angle by which OP turns from noon to noon, in a year of so many days:
/// equation (15.5.11).
pub fn turn(year: f64) -> f64 {
    TAU + TAU / year
}

/// Time in which OP turns by 2 pi, over the solar day.
pub fn sidereal(year: f64) -> f64 {
    year / (year + 1.0)
}
// ANCHOR_END: days

// ANCHOR: equation
/// The Sun as it is seen, and a sundial as it goes, at a mean longitude `mean` (rad).
#[derive(Clone, Copy)]
pub struct Sun {
    /// By how much the true Sun is ahead of the mean one along the ecliptic.
    pub centre: f64,
    /// By how much its right ascension lags behind its longitude.
    pub reduction: f64,
    pub declination: f64,
}

impl Sun {
    pub fn at(mean: f64, p: &Parameters) -> Self {
        let e = p.eccentricity;
        let (s, c) = sincos(eccentric_anomaly(mean - p.perigee, e));
        // From the mean over the eccentric to the true anomaly, each step exact.
        let b = e / (1.0 + ((1.0 - e) * (1.0 + e)).sqrt());
        let centre = e * s + 2.0 * atan2(b * s, 1.0 - b * c);
        let longitude = mean + centre;
        let (half, (s, c)) = (tan(0.5 * p.obliquity), sincos(2.0 * longitude));
        let y = half * half;
        let reduction = atan2(y * s, 1.0 + y * c);
        let declination = asin(sin(p.obliquity) * sin(longitude));
        Self { centre, reduction, declination }
    }

    /// Sundial less clock, as an angle of the turning Earth (rad).
    pub fn equation_of_time(&self) -> f64 {
        self.reduction - self.centre
    }
}

/// Kepler's equation E - e sin E = M, by Newton's method.
pub fn eccentric_anomaly(mean: f64, e: f64) -> f64 {
    let mut x = mean + e * sin(mean);
    for _ in 0..8 {
        let (s, c) = sincos(x);
        x -= (x - e * s - mean) / (1.0 - e * c);
    }
    x
}
// ANCHOR_END: equation

// ANCHOR: orbit
/// The Sun about the Earth, x and y in the plane of the orbit, x towards the equinox:
/// `[x, y, x', y']` in units of the mean distance, time in days.
fn path(year: f64) -> impl Ode<4> {
    let pull = TAU / year * (TAU / year);
    ode(move |_, [x, y, u, v]: &[f64; 4]| {
        let square = x * x + y * y;
        let by_cube = pull / (square * square.sqrt());
        [*u, *v, -by_cube * x, -by_cube * y]
    })
    .scaled(size_or([1.0; 4]))
}

/// How far the Sun stands past the meridian of P: positive after noon, negative before.
fn past_meridian(p: &Parameters, t: f64, [x, y]: [f64; 2]) -> f64 {
    // The meridian turns evenly, (15.5.11) in a day, and shows the mean Sun at t = 0.
    let turned = p.mean_longitude + turn(p.year) * t;
    let ((s, c), across) = (sincos(turned), y * sincos(p.obliquity).1);
    s * x - c * across
}
// ANCHOR_END: orbit

/// The Sun `t` mean days after the epoch.
pub fn sun(p: &Parameters, t: f64) -> Sun {
    Sun::at(p.mean_longitude + TAU * t / p.year, p)
}

/// When the Sun passes the meridian on day `k`, in mean days: the clock shows noon at k.
pub fn noon(p: &Parameters, k: u32) -> f64 {
    let mut t = f64::from(k);
    for _ in 0..30 {
        t = f64::from(k) - sun(p, t).equation_of_time() / TAU;
    }
    t
}

/// The noons of a year and of the day after.
pub fn noons(p: &Parameters) -> Vec<f64> {
    (0..=p.year as u32 + 1).map(|k| noon(p, k)).collect()
}

/// The same orbit and axis, without one of the two causes.
pub fn with(p: &Parameters, eccentricity: f64, obliquity: f64) -> Parameters {
    Parameters { eccentricity, obliquity, ..p.clone() }
}

/// The notes' example: a circle, and an axis at right angles to it.
fn mean_days(p: &Parameters, report: &mut Report) -> Result<()> {
    let (y, day) = (p.year, p.day);
    let [noon, once] = orbit::facing(turn(y), TAU / y, p.tolerance)?;
    let (omega, stars, whole) = (turn(y) / day, sidereal(y) * day, turn(y) * noon);
    // The printed formula has 365.25 in the denominator, whatever the year.
    let printed = TAU * (y + 1.0) / (365.25 * day);
    let (minutes, bound) = ((stars / 60.0).floor() * 60.0, 1e-12 + 10.0 * p.tolerance);
    claims! { report,
        /// turn of OP in a solar day
        turn: turn(y), "rad", "P faces the Sun again" => whole, within bound, in "The mean day":
            TAU => "then P would face the same star, and not the Sun",
            TAU - TAU / y => "the Earth goes round the Sun the way it turns";
        /// angular velocity of the Earth
        omega: omega, "rad/s", "P faces the Sun again" => whole / day, within bound * omega, judged 1e-5, in "The mean day":
            TAU / day => "that is the Sun in the sky, not the Earth",
            printed => "two different years are in that quotient";
        /// the same as printed in the notes
        omega_printed: printed, "rad/s", "from the right one" => omega * y / 365.25, within 1e-14 * omega;
        /// relative error of the printed value
        printed_error: y / 365.25 - 1.0, "-", "the two rates" => printed / omega - 1.0, within 1e-12;
        /// by how much noon would be late, day after day, at the printed rate
        printed_late: TAU / (printed - TAU / (y * day)) - day, "s", "P faces the Sun again" =>
        (orbit::facing(printed * day, TAU / y, p.tolerance)?[0] - 1.0) * day, within bound * day * turn(y) * omega / printed;
        /// sidereal day
        sidereal: stars, "s", "OP points at the same star again" => once * day, within bound * day, in "The mean day":
            day * y / (y - 1.0) => "the stars come round sooner than the Sun";
        /// its seconds beyond whole minutes
        sidereal_seconds: stars - minutes, "s", "OP points at the same star again" => once * day - minutes, within bound * day;
        /// by how much it is shorter than the solar day
        gain: day / (y + 1.0), "s", "OP points at the same star again" => day - once * day, within bound * day, in "The mean day";
        /// turns in a year
        turns: y + 1.0, "-", "angle of OP after a year" => omega * day * y / TAU, within 1e-13 * y, in "The mean day":
            y => "those are the noons";
    }
}

/// Seconds of arc in a whole turn, and days in a Julian century.
const TURN: f64 = 1_296_000.0;
const CENTURY: f64 = 36_525.0;

/// A turn relative to the equinox, and one relative to the stars.
fn two_kinds_of_star_days(_: &Parameters, report: &mut Report) -> Result<()> {
    // The tropical year at J2000 (Simon et al. 1994), days; precession of the equinox along the
    // equator (Capitaine et al. 2003), seconds of arc a Julian century.
    let (tropical, precession) = (365.242_189_67, 4_612.156_534);
    let equinox = sidereal(tropical) * 86_400.0;
    let star = 86_400.0 / (86_400.0 / equinox - precession / TURN / CENTURY);
    // Turns a day: Aoki et al. 1982; IAU resolution B1.8 of 2000.
    let [mean_sidereal, stellar] = [1.002_737_909_350_795, 1.002_737_811_911_354_5];
    let adopted = [86_400.0 / mean_sidereal, 86_400.0 / stellar];
    claims! { report,
        /// mean sidereal day, from the tropical year
        mean_sidereal: equinox, "s", "Aoki et al. 1982" => adopted[0], within 2e-6;
        /// stellar day
        stellar: star, "s", "IAU resolution B1.8 (2000)" => adopted[1], within 2e-6;
        /// the second less the first
        star_gap: star - equinox, "s", "the two standards" => adopted[1] - adopted[0], within 1e-6;
        /// angular velocity relative to the stars
        omega_stars: TAU / star, "rad/s", "IAU resolution B1.8 (2000)" => TAU / adopted[1], within 2e-15;
    }
}

/// Round orbits, upright axes, the first terms of the series, and other bodies.
fn limits(p: &Parameters, report: &mut Report) -> Result<()> {
    // Spread evenly over a year.
    let points = 1461;
    let year = (0..points).map(|k| p.year / f64::from(points) * f64::from(k));
    let most =
        |e, tilt| largest(year.clone().map(|t| sun(&with(p, e, tilt), t).equation_of_time()));
    // The first terms of the series, with the sizes of the first left out.
    let ((e, y), half) = ((p.eccentricity, tan(0.5 * p.obliquity)), 0.5 * p.obliquity);
    let y = y * y;
    let series = |t: f64| {
        let l = p.mean_longitude + TAU * t / p.year;
        let m = l - p.perigee;
        let first = y * sin(2.0 * l) - 2.0 * e * sin(m);
        let second = 4.0 * e * y * sin(m) * cos(2.0 * l) - 0.5 * y * y * sin(4.0 * l);
        first + second - 1.25 * e * e * sin(2.0 * m)
    };
    let off = largest(year.clone().map(|t| series(t) - sun(p, t).equation_of_time()));
    let third = (e + y) * (e + y) * (e + y) / (cos(half) * cos(half));
    let mean = year.clone().map(|t| sun(&with(p, e, 0.0), t).centre).sum::<f64>();
    limits! { report,
        /// the sundial keeps the time of the clock
        "round orbit, upright axis: E": most(0.0, 0.0) => 0.0, within 1e-14;
        /// 2 e sin M, Kepler's second law to first order
        "e = 1e-5, upright axis: largest E/2e": most(1e-5, 0.0) / 2e-5 => 1.0, within 1e-4;
        /// tan^2(tilt/2) sin 2L, a circle seen from the side
        "round orbit, tilt 0.001: largest E/tan^2": most(0.0, 1e-3) / (tan(5e-4) * tan(5e-4)) => 1.0, within 1e-4;
        /// a circle takes the Sun round evenly on the average
        "mean over a year of the first part": mean / f64::from(points) => 0.0, within 1e-14;
        /// Smart's series; what it leaves out is of third order
        "E less the series to second order": off => 0.0, within 3.0 * third;
        /// it shows one face to the Sun, as the Moon to the Earth
        "one turn in a year: noons in a year": 365.24 / solar_day(365.24, 365.24) => 0.0, within 1e-15;
        /// three turns less two round the Sun: one noon in two years
        "Mercury, three turns in two years: day over year": solar_day(2.0, 3.0) / 3.0 => 2.0, within 1e-14;
    }
}

/// The solar day of a body that turns once in `stars` and goes round the Sun in `year`.
pub fn solar_day(stars: f64, year: f64) -> f64 {
    1.0 / (1.0 / stars - 1.0 / year)
}

/// Solar days of other bodies, from their turns and years in days (NASA's planetary fact
/// sheets; negative: it turns against its orbit).
fn elsewhere(_: &Parameters, report: &mut Report) -> Result<()> {
    let bodies = [
        ("Mercury", 58.646, 87.969),
        ("Venus", -243.02, 224.701),
        ("Mars", 1.025_957, 686.98),
        ("Moon", 27.3217, 365.256),
    ];
    let columns = ["body", "days a turn", "days a year", "solar day in days"];
    report.add(Table::of("elsewhere", columns, bodies, |(body, stars, year)| {
        let day = short(solar_day(stars, year).abs(), 5);
        Ok([body.into(), stars.to_string(), year.to_string(), day])
    })?)
}

/// What the page asks its reader to try, one flag changed at a time.
fn variations(p: &Parameters, report: &mut Report) -> Result<()> {
    let [flat, round] = [with(p, p.eccentricity, 0.0), with(p, 0.0, p.obliquity)];
    let opposite = p.but(|p| p.perigee = 1.7966);
    let rows = [
        ("--eccentricity 0", "longest", extremes(&round).longest),
        ("--obliquity 0", "earliest", extremes(&flat).earliest),
        ("--perigee 1.7966", "earliest", extremes(&opposite).earliest),
        ("--perigee 1.7966", "longest", extremes(&opposite).longest),
    ];
    let columns = ["flag", "key", "value / s", "on"];
    let table = Table::of("variations", columns, rows, |(flag, key, (value, k))| {
        Ok([flag.to_owned(), key.into(), short(value, 4), date(p, k)])
    })?;
    report.add(table.row(["--year 20", "sidereal", &short(sidereal(20.0) * p.day, 6), "-"])?)
}

/// The accuracy strip: from a perigee, for the greater part of a year.
fn accuracy(p: &Parameters, report: &mut Report) -> Result<()> {
    let (orbit, part) = (p.clone(), 0.8);
    let wanted = p.perigee + TAU * part + Sun::at(p.perigee + TAU * part, p).centre;
    let asked = [1e-6, 1e-8, 1e-10, 1e-12, p.tolerance, 1e-15];
    let run = move |step| orbit::longitude(&orbit, part * orbit.year, step);
    report.stepped(asked, run, |run| run.1, move |run| Ok(sin(run.0 - wanted).abs()))?;
    let closed = p.clone();
    report.in_closed_form(move |part| sun(&closed, part * closed.year));
    Ok(())
}

example! {
    ch15_2_days: "The day and the stars: solar and sidereal day, and the equation of time";
    "The day and the stars", "The Earth turns once more in a year than it has noons, and its noons are uneven.",
    [mean_days, two_kinds_of_star_days, year::claims, limits, left_out::effects, elsewhere, variations, accuracy];
    figures::figures, figures::trajectory, figures::moving_picture
}
