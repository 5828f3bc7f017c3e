//! The pole among the stars.

use super::*;

/// A star: its name, right ascension (h, min, s) and declination (degrees, min, s) at J2000; proper
/// motion is left out.
type Star = (&'static str, [f64; 3], [f64; 3]);

/// The stars of the map, among them those that the pole passes.
pub const STARS: [Star; 8] = [
    ("Polaris", [2.0, 31.0, 49.1], [89.0, 15.0, 51.0]),
    ("Thuban", [14.0, 4.0, 23.3], [64.0, 22.0, 33.0]),
    ("Vega", [18.0, 36.0, 56.3], [38.0, 47.0, 1.0]),
    ("Errai", [23.0, 39.0, 20.8], [77.0, 37.0, 56.0]),
    ("Alderamin", [21.0, 18.0, 34.8], [62.0, 35.0, 8.0]),
    ("Deneb", [20.0, 41.0, 25.9], [45.0, 16.0, 49.0]),
    ("Kochab", [14.0, 50.0, 42.3], [74.0, 9.0, 20.0]),
    ("Eltanin", [17.0, 56.0, 36.4], [51.0, 29.0, 20.0]),
];

/// The tilt of J2000, by which equatorial coordinates go over into those of the ecliptic.
const TILT: f64 = 84_381.406 * ARCSEC;

/// Where a star is, on the axes of the ecliptic.
pub fn direction((_, ascension, declination): &Star) -> SpaceVector {
    let whole = |[units, minutes, seconds]: &[f64; 3]| units + minutes / 60.0 + seconds / 3600.0;
    let degrees = [15.0 * whole(ascension), whole(declination)];
    let [(sa, ca), (sd, cd)] = degrees.map(|angle| sincos(angle.to_radians()));
    let (s, c) = sincos(TILT);
    let (y, z) = (cd * sa, sd);
    SpaceVector::new(cd * ca, y * c + z * s, z * c - y * s)
}

/// When the pole is closest to a star (years from the epoch, within half a round of `about`)
/// and how far it is then (degrees): where it has the star's longitude.
pub fn closest(p: &Parameters, star: &Star, about: f64) -> [f64; 2] {
    let at = direction(star);
    let round = TAU / rate(p).abs() / YEAR;
    let first = atan2(-at.x(), at.y()) / rate(p) / YEAR;
    let when = first + round * ((about - first) / round).round();
    let off = atan2(hypot(at.x(), at.y()), at.z()) - p.obliquity;
    [when, off.abs().to_degrees()]
}

/// The same by simulation of the one ring.
pub fn simulated(p: &Parameters, star: &Star, about: f64) -> Result<[f64; 2]> {
    let at = direction(star);
    let [when, _] = closest(p, star, about);
    let span = if when < 0.0 { when - 100.0 } else { when + 100.0 } * YEAR;
    let path = run(p, &as_one(p)?, 0, span)?;
    // The first maximum of the cosine, halved down: coarsely over the last two centuries.
    let near = |t: f64| -> Result<f64> { Ok(SpaceVector::from_array(path.at(t)?).dot(&at)) };
    let before = span - 200.0 * YEAR * span.signum();
    let mut around = [if before * span > 0.0 { before } else { 0.0 }, span];
    for _ in 0..60 {
        let [low, high] = around;
        let [a, b] = [low + (high - low) / 3.0, high - (high - low) / 3.0];
        around = if near(a)? < near(b)? { [a, high] } else { [low, b] };
    }
    let pole = SpaceVector::from_array(path.at(around[0])?);
    Ok([around[0] / YEAR, (apart(pole, at) * ARCSEC).to_degrees()])
}

pub fn claims(p: &Parameters, report: &mut Report) -> Result<()> {
    let [polaris, thuban, vega, ..] = &STARS;
    let found =
        |star, about| -> Result<_> { Ok((closest(p, star, about), simulated(p, star, about)?)) };
    let (next, by_polaris) = found(polaris, 0.0)?;
    let (past, by_thuban) = found(thuban, -5000.0)?;
    let (far, by_vega) = found(vega, 12_000.0)?;
    // A cosine is flat where it is largest.
    let (years, degrees) = (0.05, 1e-6);
    claims! { report,
        /// year in which the pole is closest to Polaris
        polaris: 2000.0 + next[0], "-", "one ring, simulated" => 2000.0 + by_polaris[0], within years, judged 2e-3, in "The sky";
        /// how close
        polaris_distance: next[1], "deg", "one ring, simulated" => by_polaris[1], within degrees;
        /// year in which it was closest to Thuban
        thuban: 2000.0 + past[0], "-", "one ring, simulated" => 2000.0 + by_thuban[0], within years, judged 2e-3, in "The sky";
        /// year in which it will be closest to Vega
        vega: 2000.0 + far[0], "-", "one ring, simulated" => 2000.0 + by_vega[0], within years, judged 2e-3, in "The sky";
        /// how close
        vega_distance: far[1], "deg", "one ring, simulated" => by_vega[1], within degrees;
    }
}
