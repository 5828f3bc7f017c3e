//! The true noons of a year: the largest and the smallest of their hours and of their days.

use super::*;

/// What a year of sundial noons comes to, seconds; each with its day.
#[derive(Clone, Copy)]
pub struct Extremes {
    /// The sundial's largest lag behind the clock, and its largest lead.
    pub latest: (f64, usize),
    pub earliest: (f64, usize),
    /// The shortest and the longest day from noon to noon, less 24 hours.
    pub shortest: (f64, usize),
    pub longest: (f64, usize),
}

impl Extremes {
    /// From the noons of a year, in mean days.
    pub fn of(noons: &[f64], day: f64) -> Self {
        let days: Vec<f64> = noons.windows(2).map(|pair| (pair[1] - pair[0] - 1.0) * day).collect();
        let leads = noons.iter().zip(0..days.len()).map(|(t, k)| (k as f64 - t) * day).collect();
        let ([latest, earliest], [shortest, longest]) = (ends(leads), ends(days));
        Self { latest, earliest, shortest, longest }
    }
}

/// The least and the greatest, with their places.
fn ends(values: Vec<f64>) -> [(f64, usize); 2] {
    let least = |sign: f64| {
        let places = (0..values.len()).map(|k| (sign * values[k], k));
        let (value, k) = places.min_by(|a, b| a.0.total_cmp(&b.0)).unwrap_or_default();
        (sign * value, k)
    };
    [least(1.0), least(-1.0)]
}

/// The same by the closed form.
pub fn extremes(p: &Parameters) -> Extremes {
    Extremes::of(&noons(p), p.day)
}

/// Whether the year is the Earth's.
pub fn is_of_the_earth(p: &Parameters) -> bool {
    (365.0..366.5).contains(&p.year)
}

/// The date of day `k` after 1 January 2000, if the year is the Earth's.
pub fn date(p: &Parameters, k: usize) -> String {
    if !is_of_the_earth(p) {
        return format!("day {k}");
    }
    let months = "January February March April May June July August September October November";
    let lengths = [31, 29, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31, 31];
    let mut left = k;
    for (month, days) in months.split(' ').chain(["December", "January"]).zip(lengths) {
        if left < days {
            return format!("{} {month}", left + 1);
        }
        left -= days;
    }
    format!("day {k}")
}

/// The claims on the true noons, and the table of the days on which they are extreme.
pub fn claims(p: &Parameters, report: &mut Report) -> Result<()> {
    let both = |p: &Parameters| -> Result<_> {
        Ok((extremes(p), Extremes::of(&orbit::noons(p, p.tolerance)?.0, p.day)))
    };
    let (a, b) = both(p)?;
    let (tilt, tilt_found) = both(&with(p, 0.0, p.obliquity))?;
    let (oval, oval_found) = both(&with(p, p.eccentricity, 0.0))?;
    let near = (1e-11 + 10.0 * p.tolerance) * p.day;
    claims! { report,
        /// largest lag of the sundial
        latest: a.latest.0, "s", "located events" => b.latest.0, within near, in "The year";
        /// largest lead of the sundial
        earliest: a.earliest.0, "s", "located events" => b.earliest.0, within near, in "The year";
        /// shortest true day, less the mean one
        shortest: a.shortest.0, "s", "located events" => b.shortest.0, within near, in "The year";
        /// longest true day, less the mean one
        longest: a.longest.0, "s", "located events" => b.longest.0, within near, in "The year":
            tilt.longest.0 + oval.longest.0 => "their longest days are not the same";
        /// largest lead by the tilt alone
        tilt_earliest: tilt.earliest.0, "s", "located events" => tilt_found.earliest.0, within near;
        /// shortest day by the tilt alone
        tilt_shortest: tilt.shortest.0, "s", "located events" => tilt_found.shortest.0, within near;
        /// longest day by the tilt alone
        tilt_longest: tilt.longest.0, "s", "located events" => tilt_found.longest.0, within near;
        /// largest lead by the eccentricity alone
        oval_earliest: oval.earliest.0, "s", "located events" => oval_found.earliest.0, within near;
        /// shortest day by the eccentricity alone
        oval_shortest: oval.shortest.0, "s", "located events" => oval_found.shortest.0, within near;
        /// longest day by the eccentricity alone
        oval_longest: oval.longest.0, "s", "located events" => oval_found.longest.0, within near;
    }?;
    let rows = [
        ("sundial most behind the clock", a.latest),
        ("sundial most ahead of it", a.earliest),
        ("shortest day less the mean", a.shortest),
        ("longest day less the mean", a.longest),
    ];
    report.add(Table::of("extremes", ["what", "on", "seconds"], rows, |(what, (value, k))| {
        Ok([what.into(), date(p, k), short(value, 4)])
    })?)
}
