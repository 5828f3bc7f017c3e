//! Recordings of a phone's gyroscope: read from the tables that apps export, searched for free flights.
//!
//! [`Recording::read`] takes the tables of phyphox, Physics Toolbox, Sensor Logger, AndroSensor and MATLAB
//! Mobile, and others whose header names a time and three rates with their units; also four columns
//! without a header. [`made`] makes such tables of motions that are known.
//!
//! ```
//! use kit::recording::{Recording, made::{Format, Made}};
//! # fn main() -> kit::Result<()> {
//! let text = Made::default().text(Format::Phyphox)?;
//! let recording = Recording::read("Gyroscope.csv", text.as_bytes())?;
//! let flights = recording.flights()?;
//! assert_eq!(flights.len(), 1);
//! let flight = flights[0].samples.clone();
//! println!("{} rates in flight", recording.rates()[flight].len());
//! # Ok(())
//! # }
//! ```

mod columns;
mod flights;
pub mod made;
mod read;
mod series;
mod torque;

use crate::error::{Error, Result};
use crate::number::short;
use core::cmp::Ordering;
use core::ops::Range;
pub use flights::Flight;
use rotation_dynamics::error::plain;

/// The fewest samples that a fit of the library takes.
const FEWEST: usize = 13;

/// Where phones' sensors end (degrees per second): at 250 and its doubles, or at 2^15 steps of 8.75 thousandths and
/// its doubles.
const RANGES: [f64; 10] =
    [250.0, 500.0, 1000.0, 2000.0, 4000.0, 286.7, 573.4, 1146.9, 2293.8, 4587.5];

/// Rates about three axes, as a sensor recorded them.
#[derive(Debug, Clone, PartialEq)]
pub struct Recording {
    times: Vec<f64>,
    rates: Vec<[f64; 3]>,
    accelerations: Option<Vec<[f64; 3]>>,
    notes: Vec<String>,
    /// In which line of the file each sample is.
    lines: Vec<usize>,
}

impl Recording {
    /// Reads a table: UTF-8 with or without a mark, UTF-16 with one, or Latin-1; columns apart by commas,
    /// semicolons, tabs or spaces; decimal points or commas. The file's `name` tells sensors apart
    /// where the header does not ("Accelerometer.csv").
    ///
    /// # Errors
    /// [`Error::Recording`], with line and column: no text, no table, no column for the time or a rate, an
    /// unknown unit, a cell that is no finite number, times that run backwards, an axis that shows one value
    /// alone, a rate above 100 rad/s, fewer than 1 or more than 20,000 samples a second, fewer than 13 samples.
    pub fn read(name: &str, bytes: &[u8]) -> Result<Self> {
        read::recording(name, bytes)
    }

    /// When each sample was taken (s), ascending.
    pub fn times(&self) -> &[f64] {
        &self.times
    }

    /// The rates on the sensor's axes (rad/s).
    pub fn rates(&self) -> &[[f64; 3]] {
        &self.rates
    }

    /// The accelerations on the sensor's axes (m/s^2) at the same times, if the table has them.
    pub fn accelerations(&self) -> Option<&[[f64; 3]]> {
        self.accelerations.as_deref()
    }

    /// What was recognised, converted, merged or left out, a sentence each.
    pub fn notes(&self) -> &[String] {
        &self.notes
    }

    /// Where a sample is in the file: `line 251, t = 2.49 s`.
    pub fn place(&self, sample: usize) -> String {
        match (self.lines.get(sample), self.times.get(sample)) {
            (Some(line), Some(t)) => format!("line {line}, t = {} s", short(*t, 6)),
            _ => format!("sample {sample}, of {}", self.times.len()),
        }
    }

    /// Where a rate stays at its largest: the axis, and which samples. A turn passes its largest rate, a sensor stays
    /// at its limit: it shows the same number for five samples, and more often than numbers up to 2 % below; and
    /// that is the end of a usual range, but for an offset of 0.5 %.
    fn limited(&self) -> Vec<(usize, Range<usize>)> {
        let mut all = Vec::new();
        for (axis, sign) in [0, 1, 2].into_iter().flat_map(|axis| [(axis, 1.0), (axis, -1.0)]) {
            let values: Vec<f64> = self.rates.iter().map(|w| sign * w[axis]).collect();
            let most = values.iter().copied().fold(0.0, f64::max);
            let above = |least: f64| values.iter().filter(|value| **value >= least).count();
            let ends = |range: &f64| (most / range.to_radians() - 1.0).abs() < 0.005;
            if !RANGES.iter().any(ends) || 2 * above(most) <= above(0.98 * most) {
                continue;
            }
            let mut first = 0;
            for run in values.chunk_by(|a, b| a == b) {
                if run[0] == most && run.len() >= 5 {
                    all.push((axis, first..first + run.len()));
                }
                first += run.len();
            }
        }
        all
    }

    /// What to say of that.
    fn at_its_limit(&self) -> Option<String> {
        let limited = self.limited();
        let (axis, samples) = limited.first()?;
        let [from, to] = [samples.start, samples.end - 1].map(|n| short(self.times[n], 5));
        let most = short(self.rates[samples.start][*axis].abs(), 4);
        let axis = ["x", "y", "z"][*axis];
        let more = match limited.len() - 1 {
            0 => String::new(),
            more => format!(" (pieces like this: {})", more + 1),
        };
        Some(format!(
            "from {from} s to {to} s{more} the rate about {axis} stays at {most} rad/s, the end of the sensor's \
             range: throw more slowly"
        ))
    }

    /// The pieces in free flight, in order: by the rates, which one tensor must explain, and by
    /// accelerations with gravity, if there are some.
    ///
    /// Accuracy: of 100 throws of 0.2 to 1.5 s that were made at 100 to 400 samples a second, all were found and
    /// nothing else. Pieces began 4 ms before to 25 ms after the release (16 ms before, with noise of 0.02 to 0.05
    /// rad/s, in which a hand's last torque cannot be seen), and ended 7 to 25 ms before the catch
    /// (`tests/recording`). In about one of 300 others, a short spin about the axis of the least moment, a piece
    /// began 60 ms before the release. At 50 samples a second a flight of 0.2 s is too short to be found.
    ///
    /// # Errors
    /// [`Error::Recording`] if there is none: with what was looked for, and the fastest rate.
    pub fn flights(&self) -> Result<Vec<Flight>> {
        flights::find(self)
    }

    /// The samples from one time to another (s), both included; `None`, or a time outside, is the beginning or the
    /// end.
    ///
    /// # Errors
    /// [`Error::Recording`] for a piece that lies outside the recording, for times in the wrong order, and for
    /// fewer than 13 samples.
    pub fn between(&self, from: Option<f64>, to: Option<f64>) -> Result<Range<usize>> {
        let [begin, end] = [self.times[0], self.times[self.times.len() - 1]];
        let [from, to] = [from.unwrap_or(begin), to.unwrap_or(end)];
        let said = || format!("from {} s to {} s", plain(from), plain(to));
        if from.partial_cmp(&to) != Some(Ordering::Less) {
            return Err(refused(format!("{}: the end must be later", said())));
        }
        if from > end || to < begin {
            let [begin, end] = [begin, end].map(plain);
            let reason = format!("{}: the recording is from {begin} s to {end} s", said());
            return Err(refused(reason));
        }
        let first = self.times.partition_point(|t| *t < from);
        let after = self.times.partition_point(|t| *t <= to);
        match after - first {
            FEWEST.. => Ok(first..after),
            few => {
                let reason = format!("{few} samples; a fit needs {FEWEST} or more");
                Err(refused(format!("{} there are {reason}", said())))
            }
        }
    }

    /// The middle one of the steps of time (s).
    fn step(&self) -> f64 {
        middle(self.times.windows(2).map(|pair| pair[1] - pair[0]).collect())
    }
}

fn refused(reason: String) -> Error {
    Error::Recording { line: None, column: None, reason }
}

/// The middle one by size; 0 of none.
fn middle(mut values: Vec<f64>) -> f64 {
    let half = values.len() / 2;
    match values.is_empty() {
        true => 0.0,
        false => *values.select_nth_unstable_by(half, f64::total_cmp).1,
    }
}
