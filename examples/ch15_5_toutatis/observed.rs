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

/// The measured days of December 1992, in order, and the one of 2008.
pub fn observed() -> Result<(Vec<Observed>, Observed)> {
    let data = include_str!("toutatis.csv");
    let rows = data.lines().filter(|line| line.starts_with(|c: char| c.is_ascii_digit()));
    let day = |row: &'static str| {
        let mut cells = row.split(',');
        let date = cells.next().unwrap_or("");
        let mut number =
            || cells.next().and_then(|cell| cell.trim().parse().ok()).unwrap_or(f64::NAN);
        let (attitude, angular_velocity) = turning([0; 6].map(|_| number()))?;
        Ok(Observed { date, t: since_epoch(date), attitude, angular_velocity })
    };
    let mut days = rows.map(day).collect::<Result<Vec<_>>>()?;
    let none = kit::Error::Text { text: "toutatis.csv".into(), allowed: "a row a day" };
    let last = days.pop().ok_or(none)?;
    Ok((days, last))
}

/// The attitude of three angles z-x'-z'', degrees; and rates, degrees a day, as rad/s.
pub fn turning(numbers: [f64; 6]) -> rotation_dynamics::Result<(Attitude, BodyVector)> {
    let [phi, theta, zeta, x, y, z] = numbers.map(f64::to_radians);
    let rates = [x, y, z].map(|rate| rate / DAY);
    Ok((Attitude::from_euler(EulerAngles { phi, theta, zeta })?, BodyVector::from_array(rates)))
}

/// Seconds since the epoch.
pub fn since_epoch(date: &str) -> f64 {
    seconds(date) - seconds(EPOCH)
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
