//! What the orbit of two bodies and a steady turn leave out: predicted by one step from the
//! closed form, measured in simulated years with it and without it.

use super::orbit::Seen;
use super::*;
use rotation_dynamics::effects::KeplerOrbit;
use rotation_dynamics::integrators::after;

/// How far the Earth circles the centre that it has in common with the Moon, over the distance of
/// the Sun.
const MOON: f64 = 4_671.0 / 149_597_871.0;

/// Seen from the Earth, the Sun circles with the Moon.
pub fn by_the_moon(t: f64, [x, y, ..]: [f64; 4]) -> [f64; 2] {
    let (s, c) = sincos(TAU * t / 27.321_661);
    [x + MOON * c, y + MOON * s]
}

/// Light takes the time `lag`, in days, for the mean distance, and the Sun is seen where it was.
pub fn by_light(lag: f64) -> impl Fn(f64, [f64; 4]) -> [f64; 2] {
    move |_, [x, y, u, v]| {
        let late = lag * (x * x + y * y).sqrt();
        [x - late * u, y - late * v]
    }
}

/// The orbit, its place and velocity by the library.
fn on_orbit(p: &Parameters) -> Result<impl Fn(f64) -> [f64; 4] + use<>> {
    let passed = (p.perigee - p.mean_longitude) * p.year / TAU;
    let orbit = KeplerOrbit::elliptic(1.0, p.year, p.eccentricity)?;
    let orbit = orbit.oriented(0.0, 0.0, p.perigee)?.passing_at(passed)?;
    Ok(move |t| {
        let (place, velocity) = (orbit.place(t), orbit.velocity(t));
        [place.x(), place.y(), velocity.x(), velocity.y()]
    })
}

/// By how much noon comes later on each day of the year, in seconds, to first order: how far
/// past the meridian the Sun is seen at the noon that the closed form gives, over its rate.
pub fn later(p: &Parameters, seen: Seen<'_>) -> Result<Vec<f64>> {
    let at = on_orbit(p)?;
    let past = |t: f64| past_meridian(p, t, [at(t)[0], at(t)[1]]);
    let late = |t: f64| {
        let rate = (past(t + 1e-4) - past(t - 1e-4)) / 2e-4;
        -past_meridian(p, t, seen(t, at(t))) / rate * p.day
    };
    Ok(noons(p).into_iter().map(late).collect())
}

/// By how much these noons come later than those of a simulated year, in seconds.
fn compared(p: &Parameters, noons: &[f64]) -> Result<Vec<f64>> {
    let (without, _) = orbit::noons(p, 1e-13)?;
    Ok(noons.iter().zip(without).map(|(a, b)| (a - b) * p.day).collect())
}

/// The same as [`later`] from two simulated years, and the work of the second.
pub fn simulated(p: &Parameters, seen: Seen<'_>) -> Result<(Vec<f64>, Work)> {
    let (with, work) = orbit::noons_seen(p, 1e-13, seen)?;
    Ok((compared(p, &with)?, work))
}

/// The largest deviation from the mean: a clock is set by the mean.
pub fn spread(seconds: &[f64]) -> f64 {
    let mean = seconds.iter().sum::<f64>() / seconds.len() as f64;
    largest(seconds.iter().map(|x| x - mean))
}

/// The most by which Jupiter moves the Earth along its orbit (rad), both on circles but for that:
/// with this mass in Suns, from one time at which Jupiter is opposite to the Sun to the next.
pub fn by_jupiter(mass: f64) -> Result<(f64, Work)> {
    // Seen from the Sun, in a frame that turns with Jupiter; the Earth's distance, the Sun's mass
    // and a year over 2 pi are 1.
    let far = 5.2026_f64;
    let rate = ((1.0 + mass) / (far * far * far)).sqrt();
    let earth = ode(|_, [x, y, u, v]: &[f64; 4]| {
        let cube = |x: f64, y: f64| (x * x + y * y) * (x * x + y * y).sqrt();
        let (sun, planet) = (rate * rate - 1.0 / cube(*x, *y), mass / cube(far - x, *y));
        let along = sun * x + planet * (far - x) - mass / (far * far) + 2.0 * rate * v;
        [*u, *v, along, (sun - planet) * y - 2.0 * rate * u]
    })
    .scaled(size_or([1.0; 4]));
    // It crosses the line from the Sun to Jupiter at right angles, and must do so again half a
    // round later: then it comes back to the same.
    let method = Dop853::new(1e-13)?;
    let half = |v: f64| method.zero(&earth, [1.0, 0.0, 0.0, v - rate], 1, 9.0, |y| y[1]);
    let (mut v, mut work) = (1.0, Work::default());
    for _ in 0..3 {
        let ((here, one), (there, two)) = (half(v)?, half(v + 1e-5)?);
        v -= 1e-5 * here.state[2] / (there.state[2] - here.state[2]);
        work += one + two;
    }
    let end = half(v)?.0.t;
    let off = sampled((1..60).map(|k| end * f64::from(k) / 60.0), |t| {
        let [x, y, ..] = after(t, &earth, &[1.0, 0.0, 0.0, v - rate], 1e-13)?;
        Ok(atan2(y, x) - PI * t / end)
    })?;
    Ok((largest(off), work))
}

/// The card of effects, for the Earth.
pub fn effects(p: &Parameters, report: &mut Report) -> Result<()> {
    let (second, lag) = (p.day / TAU, 499.004_784 / p.day);
    let (_, work) = orbit::noons(p, 1e-13)?;
    let counted = |with: Work| format!("{}, {} derivatives", work.derivatives, with.derivatives);
    let (light, circled) = (by_light(lag), simulated(p, &by_the_moon)?);
    // The perihelion moves against the equinox by 61.9 arcsec a year (Simon et al. 1994).
    let perihelion = 61.9 / TURN * TAU;
    let moved = p.but(|p| p.perigee += perihelion);
    let (turned, place) = (orbit::noons(&moved, 1e-13)?, on_orbit(&moved)?);
    let by_turn = later(p, &|t, _| [place(t)[0], place(t)[1]])?;
    // The largest term of Newcomb's; there are smaller ones.
    let (jupiter, (pulled, rounds)) = (7.2 / TURN * TAU, by_jupiter(1.0 / 1047.35)?);
    let (tides, near) = (2.4e-3 / 86_400.0, 1e-10 * p.day);
    effect_card! { report,
        "Moon: the Earth circles the common centre": "r/au" = MOON, costs spread(&later(p, &by_the_moon)?), "s of E, to first order", beside "earliest",
            measured spread(&circled.0), within near, at_cost counted(circled.1);
        "planets, most of all Jupiter": "change of longitude" = jupiter, costs jupiter * second, "s of E, by its largest term", beside "earliest",
            measured pulled * second, at_cost format!("none, {} derivatives", rounds.derivatives);
    }?;
    // In a year of nine hours the Earth would have a tenth of the speed of light.
    let speed = TAU * lag / p.year;
    if speed < 0.1 {
        let delayed = simulated(p, &light)?;
        effect_card! { report,
            "aberration of light": "v/c" = speed, costs spread(&later(p, &light)?), "s of E, to first order", beside "earliest",
                measured spread(&delayed.0), within near, at_cost counted(delayed.1);
        }?;
    }
    effect_card! { report,
        "motion of the perihelion": "angle a year" = perihelion, costs spread(&by_turn), "s of E a year, to first order", beside "earliest",
            measured spread(&compared(p, &turned.0)?), within near, at_cost counted(turned.1);
        "tides brake the Earth": "change of the day a century" = tides, costs tides * p.day, "s of a day", beside "mean_sidereal";
    }
}
