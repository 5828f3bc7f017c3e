//! What is left when the mean precession is taken off: in closed form to first order, and as
//! found in a simulated motion of the axis.

use super::*;

/// Rates of the mean longitudes of Sun and Moon against the stars, rad/s, and at the epoch.
fn longitudes() -> [[f64; 2]; 2] {
    let sun = [TAU / (ANOMALISTIC_YEAR * DAY), (282.937_f64 + 357.529).to_radians()];
    let month = TAU / (ANOMALISTIC_MONTH * DAY) + TAU / (APSIDES * DAY);
    [sun, [month, (125.044_52_f64 + 318.308_7 + 134.9634).to_radians()]]
}

/// Time of the node from one meeting with the equinox to the next, s: both go backward.
pub fn node_round(p: &Parameters) -> f64 {
    TAU / (TAU / (p.node_period * YEAR) - rate(p).abs())
}

/// The three arguments at a time, counted from the equinox: of the node, twice the mean
/// longitude of the Sun, twice that of the Moon.
fn arguments(p: &Parameters, t: f64) -> [f64; 3] {
    let [sun, moon] = longitudes().map(|[n, at]| 2.0 * (at + (n - rate(p)) * t));
    [125.044_52_f64.to_radians() - TAU * t / node_round(p), sun, moon]
}

// ANCHOR: first_order
/// The sizes of three terms to first order, in longitude (of a sine) and in the tilt (of a
/// cosine), seconds of arc: of the Moon's node, of half a year, of half a month.
pub fn first_order(p: &Parameters) -> rotation_dynamics::Result<[[f64; 2]; 3]> {
    let by = 1.5 * p.ellipticity / spin(p) / ARCSEC;
    let ((s, c), (si, ci)) = (sincos(p.obliquity), sincos(p.moon_inclination));
    // The Moon's ring tilts the normal by i; its node turns against the equinox.
    let ring = by * MOON * moon(p)?.orbit().mean_inverse_cube();
    let node = ring * si * ci * node_round(p) / TAU;
    // The part of 1/r^3 that goes round twice with the mean longitude (Hansen's coefficient).
    let twice = |mass: f64, axis: f64, n: f64| by * mass / pow(axis, 3.0) / (2.0 * (n - rate(p)));
    let hansen = |e: f64| 1.0 - 2.5 * e * e + 13.0 / 16.0 * e * e * e * e;
    let [[n, _], [m, _]] = longitudes();
    let year = twice(SUN, AU, n);
    let inclined = 0.25 * (1.0 + ci) * (1.0 + ci);
    let month = twice(MOON, p.moon_distance, m) * inclined * hansen(p.moon_eccentricity);
    // The Sun's perigee stands still: twice from perigee to perigee is half a year, too.
    let e = p.sun_eccentricity;
    let nearer = e * e * (4.5 + 3.5 * e * e) * cos(2.0 * 282.937_f64.to_radians());
    Ok([
        [node * cos(2.0 * p.obliquity) / s, node * c],
        [year * c * (hansen(e) - nearer), year * s * hansen(e)],
        [month * c, month * s],
    ])
}
// ANCHOR_END: first_order

/// The first so many of the terms at a time, together, in longitude and tilt, rad.
pub fn at(p: &Parameters, t: f64, terms: usize) -> rotation_dynamics::Result<[f64; 2]> {
    let mut sum = [0.0; 2];
    for ([longitude, tilt], x) in first_order(p)?.into_iter().zip(arguments(p, t)).take(terms) {
        let (s, c) = sincos(x);
        sum = [sum[0] + longitude * ARCSEC * s, sum[1] + tilt * ARCSEC * c];
    }
    Ok(sum)
}

/// The mean of the products of two nutations of the node, arcsec a year: with the longitude
/// a sin(x) and the tilt b cos(x), the rate F(tilt) cos(x) of the longitude is felt at another
/// tilt and another x, which leaves (F' b + F a)/2.
pub fn crossed(p: &Parameters) -> Result<f64> {
    let ([a, b], rate) = (first_order(p)?[0], TAU * YEAR / node_round(p));
    let s = sin(p.obliquity);
    let steep = b * rate * (4.0 + cos(2.0 * p.obliquity) / (s * s));
    Ok(0.5 * ARCSEC * (steep * b - a * a * rate))
}

/// What a simulated motion is made of: the mean precession (rad/s), and longitude and tilt of the
/// three terms, as [`first_order`] has them. Of the axis under Sun and Moon in their orbits, through
/// a window of two rounds of the node, 1 - cos: terms that fit twice or more into it do not see
/// each other.
pub fn spectrum(p: &Parameters) -> Result<(f64, [[f64; 2]; 3])> {
    let (end, count) = (2.0 * node_round(p), 16_384_u32);
    let run = run(p, &in_orbit(p)?, 3, end)?;
    let weight = |t: f64| 1.0 - cos(TAU * t / end);
    let path = sampled(times(0.0, end, count), |t| Ok((t, angles(run.at(t)?))))?;
    // By parts: the mean of the rate is that of the angle with the window's own rate.
    let mean = |f: &dyn Fn(f64, [f64; 2]) -> f64| {
        path.iter().skip(1).map(|(t, at)| f(*t, *at)).sum::<f64>() / f64::from(count)
    };
    let steep = |t: f64| -(TAU / end) * sin(TAU * t / end);
    let rate = mean(&|t, [precession, _]| steep(t) * precession);
    let [off, tilt] =
        [0, 1].map(|i| mean(&|t, at| weight(t) * (at[i] - if i == 0 { rate * t } else { 0.0 })));
    let terms = [0, 1, 2].map(|k| {
        let longitude = mean(&|t, [precession, _]| {
            2.0 * weight(t) * sin(arguments(p, t)[k]) * (precession - rate * t - off)
        });
        let tilt = mean(&|t, [_, at]| 2.0 * weight(t) * cos(arguments(p, t)[k]) * (at - tilt));
        [longitude / ARCSEC, tilt / ARCSEC]
    });
    Ok((rate, terms))
}

/// The three terms, and what is known of them: of a rigid Earth by theory (Woolard 1953), of
/// the real one (Mathews, Herring and Buffett 2002, adopted as IAU 2000A); seconds of arc.
const KNOWN: [[[f64; 2]; 2]; 3] = [
    [[17.2327, 9.2100], [17.2064, 9.2052]],
    [[1.2729, 0.5522], [1.3171, 0.5730]],
    [[0.2037, 0.0884], [0.2276, 0.0978]],
];

pub fn claims(p: &Parameters, report: &mut Report) -> Result<()> {
    let (formula, found) = (first_order(p)?, spectrum(p)?.1);
    // The first order leaves out parts of the size of one precession over the other.
    let slow = rate(p).abs() * node_round(p) / TAU;
    let off = |[longitude, tilt]: [f64; 2]| slow * (longitude + tilt) + 1e-5;
    // A pole that is moved along its circle has the same tilt.
    let off_tilt = |term: [f64; 2]| 0.05 * off(term) + 1e-5;
    let [node, year, month] = formula;
    let [by_node, by_year, by_month] = found;
    claims! { report,
        /// nutation of the Moon's node in longitude
        node_longitude: node[0], "arcsec", "in the simulated axis" => by_node[0], within off(node);
        /// the same in the tilt
        node_tilt: node[1], "arcsec", "in the simulated axis" => by_node[1], within off_tilt(node), in "The nutation":
            2.0 * node[1] => "that is from end to end";
        /// nutation of half a year in longitude
        year_longitude: year[0], "arcsec", "in the simulated axis" => by_year[0], within off(year), in "The nutation":
            2.0 * year[0] => "the torque goes round twice in a year";
        /// the same in the tilt
        year_tilt: year[1], "arcsec", "in the simulated axis" => by_year[1], within off_tilt(year);
        /// nutation of half a month in longitude
        month_longitude: month[0], "arcsec", "in the simulated axis" => by_month[0], within off(month);
        /// the same in the tilt
        month_tilt: month[1], "arcsec", "in the simulated axis" => by_month[1], within off_tilt(month);
    }?;
    let columns = ["term", "period", "here", "rigid, by theory", "observed"];
    let rows = (0..6).map(|row| (row / 2, row % 2));
    report.add(Table::of("nutation", columns, rows, |(k, i)| {
        let years = TAU / (arguments(p, YEAR)[k] - arguments(p, 0.0)[k]).abs();
        let (name, period) = match k {
            0 => ("the Moon’s node", format!("{years:.2} a")),
            1 => ("half a year", format!("{:.2} d", years * 365.25)),
            _ => ("half a month", format!("{:.2} d", years * 365.25)),
        };
        let [rigid, real] = KNOWN[k].map(|known| format!("{:.4}", known[i]));
        let which = ["in longitude", "in the tilt"][i];
        Ok([format!("{name}, {which}"), period, format!("{:.4}", found[k][i]), rigid, real])
    })?)
}
