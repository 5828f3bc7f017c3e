//! The published attitudes, and the clock.

use super::*;

/// A day on which the attitude was measured.
#[derive(Debug, Clone, Copy)]
pub struct Observed {
    pub date: &'static str,
    /// s after the epoch.
    pub t: f64,
    pub attitude: Attitude,
    /// rad/s.
    pub angular_velocity: BodyVector,
}

const DATA: &str = include_str!("toutatis.csv");

/// The measured days, in order; the last is the one of 2008.
pub fn observed() -> Result<Vec<Observed>> {
    let rows = DATA.lines().filter(|line| line.starts_with(|c: char| c.is_ascii_digit()));
    rows.map(|row| {
        let mut cells = row.split(',');
        let date = cells.next().unwrap_or("");
        let mut number =
            || cells.next().and_then(|cell| cell.trim().parse().ok()).unwrap_or(f64::NAN);
        let [alpha, beta, gamma, x, y, z] = [0; 6].map(|_| number());
        Ok(Observed {
            date,
            t: seconds(date) - seconds(EPOCH),
            attitude: attitude([alpha, beta, gamma])?,
            angular_velocity: rates([x, y, z]),
        })
    })
    .collect()
}

/// The attitude of three angles z-x'-z'', degrees.
pub fn attitude(degrees: [f64; 3]) -> rotation_dynamics::Result<Attitude> {
    let [phi, theta, zeta] = degrees.map(f64::to_radians);
    Attitude::from_euler(EulerAngles { phi, theta, zeta })
}

/// Degrees a day as rad/s.
pub fn rates(degrees: [f64; 3]) -> BodyVector {
    BodyVector::from_array(degrees.map(|rate| rate.to_radians() / DAY))
}

/// Seconds since the year 0 of a date like `1992-11-09T17:49:47`.
pub fn seconds(date: &str) -> f64 {
    let number = |from: usize, to: usize| {
        date.get(from..to).and_then(|s| s.parse::<f64>().ok()).unwrap_or(f64::NAN)
    };
    let (year, month, day) = (number(0, 4), number(5, 7), number(8, 10));
    // March is the first month of a year that ends with its leap day.
    let shifted = year - if month < 3.0 { 1.0 } else { 0.0 };
    let months = (month + 9.0) % 12.0;
    let leap = (shifted / 4.0).floor() - (shifted / 100.0).floor() + (shifted / 400.0).floor();
    let days = 365.0 * shifted + leap + ((153.0 * months + 2.0) / 5.0).floor() + day;
    ((days * 24.0 + number(11, 13)) * 60.0 + number(14, 16)) * 60.0 + number(17, 19)
}
