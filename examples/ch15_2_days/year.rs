//! The true noons of a year: the largest and the smallest of their hours and of their days.

use super::*;

/// What a year of sundial noons comes to, seconds; each with its day.
#[derive(Clone, Copy)]
pub struct Extremes {
    /// The sundial's largest lag behind the clock, and its largest lead.
    pub latest: (f64, usize),
    pub earliest: (f64, usize),
    /// The shortest and the longest day from noon to noon, less 24 hours.
    pub shortest_on: (f64, usize),
    pub longest_on: (f64, usize),
    pub shortest: f64,
    pub longest: f64,
}

/// The least and the greatest, with their places.
fn least_and_greatest(values: &[f64]) -> [(f64, usize); 2] {
    let mut found = [(f64::INFINITY, 0), (f64::NEG_INFINITY, 0)];
    for (k, &value) in values.iter().enumerate() {
        if value < found[0].0 {
            found[0] = (value, k);
        }
        if value > found[1].0 {
            found[1] = (value, k);
        }
    }
    found
}

impl Extremes {
    /// From the noons of a year, in mean days.
    pub fn of(noons: &[f64], day: f64) -> Self {
        let leads: Vec<f64> = (0..).zip(noons).map(|(k, t)| (f64::from(k) - t) * day).collect();
        let days: Vec<f64> = noons.windows(2).map(|pair| (pair[1] - pair[0] - 1.0) * day).collect();
        let [latest, earliest] = least_and_greatest(&leads[..days.len()]);
        let [shortest_on, longest_on] = least_and_greatest(&days);
        Self {
            latest,
            earliest,
            shortest_on,
            longest_on,
            shortest: shortest_on.0,
            longest: longest_on.0,
        }
    }
}

/// The same by the closed form.
pub fn extremes(p: &Parameters) -> Extremes {
    Extremes::of(&noons(p), p.day)
}

/// The date of day `k` after 1 January 2000, if the year is the Earth's.
pub fn date(p: &Parameters, k: usize) -> String {
    const MONTHS: [(&str, usize); 12] = [
        ("January", 31),
        ("February", 29),
        ("March", 31),
        ("April", 30),
        ("May", 31),
        ("June", 30),
        ("July", 31),
        ("August", 31),
        ("September", 30),
        ("October", 31),
        ("November", 30),
        ("December", 31),
    ];
    if !(365.0..366.5).contains(&p.year) {
        return format!("day {k}");
    }
    let mut left = k;
    for (month, days) in MONTHS {
        if left < days {
            return format!("{} {month}", left + 1);
        }
        left -= days;
    }
    format!("{} January", left + 1)
}

/// Adds the claims on the true noons, and the table of the days on which they are extreme.
pub fn add(p: &Parameters, report: &mut Report) -> Result<()> {
    let both = |p: &Parameters| {
        let found = orbit::noons(p, p.tolerance)?.0;
        Ok::<_, kit::Error>((extremes(p), Extremes::of(&found, p.day)))
    };
    let (a, b) = both(p)?;
    let (tilt, tilt_found) = both(&with(p, 0.0, p.obliquity))?;
    let (oval, oval_found) = both(&with(p, p.eccentricity, 0.0))?;
    let near = (1e-11 + 10.0 * p.tolerance) * p.day;
    kit::claims! { report,
        /// largest lag of the sundial
        latest: a.latest.0, "s", "located events" => b.latest.0, within near, in "The year";
        /// largest lead of the sundial
        earliest: a.earliest.0, "s", "located events" => b.earliest.0, within near, in "The year";
        /// shortest true day, less the mean one
        shortest: a.shortest, "s", "located events" => b.shortest, within near, in "The year";
        /// longest true day, less the mean one
        longest: a.longest, "s", "located events" => b.longest, within near, in "The year":
            tilt.longest + oval.longest => "their longest days are not the same";
        /// largest lead by the tilt alone
        tilt_earliest: tilt.earliest.0, "s", "located events" => tilt_found.earliest.0, within near;
        /// shortest day by the tilt alone
        tilt_shortest: tilt.shortest, "s", "located events" => tilt_found.shortest, within near;
        /// longest day by the tilt alone
        tilt_longest: tilt.longest, "s", "located events" => tilt_found.longest, within near;
        /// largest lead by the eccentricity alone
        oval_earliest: oval.earliest.0, "s", "located events" => oval_found.earliest.0, within near;
        /// shortest day by the eccentricity alone
        oval_shortest: oval.shortest, "s", "located events" => oval_found.shortest, within near;
        /// longest day by the eccentricity alone
        oval_longest: oval.longest, "s", "located events" => oval_found.longest, within near;
    }?;
    let mut table = Table::new("extremes", ["what", "on", "seconds"])?;
    for (what, (value, k)) in [
        ("sundial most behind the clock", a.latest),
        ("sundial most ahead of it", a.earliest),
        ("shortest day less the mean", a.shortest_on),
        ("longest day less the mean", a.longest_on),
    ] {
        table.push([what.into(), date(p, k), short(value, 4)])?;
    }
    report.add(table)
}
