//! A thing that was thrown with a gyroscope on it: which free body it was, by its recording.
//!
//! The sensor's axes are those of a phone: x along the short edge, y along the long one, z out of the
//! screen. A principal axis is named by the axis of the sensor that it is nearest to.

mod coarse;
mod figures;
mod found;
pub mod made;
mod phone;

use kit::recording::Recording;
use kit::{Asked, Decided, Found, Recorded, Report, Result, Table, Trajectory};
pub use phone::{camera, phone};
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::fit::{Correction, Estimate, Fit, Flight};
use rotation_dynamics::frame::{DesignVector, SpaceVector};
use rotation_dynamics::math::hypot;

/// The names of the axes.
const AXES: [&str; 3] = ["x", "y", "z"];

/// A flight of a recording, fitted.
pub struct Thrown {
    /// What was found in the file.
    notes: Vec<String>,
    /// Over the whole file: time (s), and the greatest |omega| about it (rad/s).
    course: Vec<(f64, f64)>,
    /// The flights that were found: first and last sample, and how many.
    flights: Vec<([f64; 2], usize)>,
    /// Which of them this is, from 1; `None` for a piece that the reader chose.
    number: Option<usize>,
    times: Vec<f64>,
    /// As the sensor shows them, rad/s.
    rates: Vec<[f64; 3]>,
    /// The body that fits them.
    pub fit: Fit,
}

/// A uniform box: its lengths along the sensor's axes (m).
pub type Lengths = [f64; 3];

const fn triple(estimate: Estimate) -> [f64; 3] {
    [estimate.value, estimate.from, estimate.to]
}

/// |omega|
fn size(w: &[f64; 3]) -> f64 {
    hypot(hypot(w[0], w[1]), w[2])
}

impl Thrown {
    /// The flight that is asked for, of a file with this name: if none is, the first of those that are nearly as long
    /// as the longest.
    ///
    /// # Errors
    /// Those of [`Recording::read`] and its parts, and of [`Flight::fit`]; a number that no flight has.
    pub fn read(name: &str, bytes: &[u8], asked: &Asked) -> Result<Self> {
        let recording = Recording::read(name, bytes)?;
        let times = recording.times();
        let found = recording.flights();
        let by_hand = asked.from.is_some() || asked.to.is_some();
        let pieces = found.as_deref().unwrap_or_default().iter();
        let pieces: Vec<_> = pieces.map(|flight| flight.samples.clone()).collect();
        let (samples, number) = if by_hand {
            (recording.between(asked.from, asked.to)?, None)
        } else {
            let pieces = found.map(|_| &pieces)?;
            let longest = pieces.iter().map(|piece| piece.len()).max().unwrap_or(0);
            // Of flights of nearly the same length the first.
            let first = pieces.iter().position(|piece| 10 * piece.len() >= 9 * longest);
            let number = asked.throw.unwrap_or(first.unwrap_or(0) + 1);
            let piece = number.checked_sub(1).and_then(|at| pieces.get(at));
            let known = pieces.len();
            let none = || kit::Error::UnknownKey {
                key: format!("throw {number}"),
                known: if known == 1 { "throw 1".into() } else { format!("throws 1 to {known}") },
            };
            (piece.cloned().ok_or_else(none)?, Some(number))
        };
        let span = |samples: &core::ops::Range<usize>| {
            ([times[samples.start], times[samples.end - 1]], samples.len())
        };
        let all = recording.rates();
        let fastest = |part: &[[f64; 3]]| part.iter().map(size).fold(0.0, f64::max);
        let parts = all.chunks(all.len().div_ceil(figures::COURSE));
        let course = times.chunks(all.len().div_ceil(figures::COURSE)).zip(parts);
        let course = course.map(|(times, part)| (times[0], fastest(part))).collect();
        let begin = samples.start;
        let (times, rates) = (times[samples.clone()].to_vec(), &all[samples]);
        let vectors = rates.iter().map(|rates| DesignVector::from(*rates)).collect();
        let placed = |error: rotation_dynamics::Error| match error {
            rotation_dynamics::Error::AtIndex { index, reason, .. } => kit::Error::Recording {
                line: None,
                column: None,
                reason: format!("{}: {reason}", recording.place(begin + index)),
            },
            other => other.into(),
        };
        let flight = Flight::new(times.clone(), vectors).map_err(placed)?;
        Ok(Self {
            notes: recording.notes().to_vec(),
            course,
            flights: pieces.iter().map(span).collect(),
            number,
            fit: flight.fit(&Correction::ALL)?,
            times,
            rates: rates.to_vec(),
        })
    }

    /// The standard deviation of the noise, from third differences: of a smooth motion they are small. The median
    /// of their sizes leaves out the few at a flip. For normal noise it is 0.6745 sqrt(20) deviations.
    fn noise(&self) -> f64 {
        let third = |axis: usize| {
            self.rates
                .windows(4)
                .map(move |w| (w[3][axis] - 3.0 * w[2][axis] + 3.0 * w[1][axis] - w[0][axis]).abs())
        };
        let mut sizes: Vec<f64> = (0..3).flat_map(third).collect();
        sizes.sort_unstable_by(f64::total_cmp);
        sizes[sizes.len() / 2] / (0.6745 * 20.0_f64.sqrt())
    }

    /// From the first sample to the last (s).
    fn duration(&self) -> f64 {
        self.times[self.times.len() - 1] - self.times[0]
    }

    /// How the sensor has turned in space since the first sample, `t` later (s).
    fn turned(&self, t: f64) -> Result<Attitude> {
        Ok(self.fit.attitude((self.times[0] + t).min(self.times[self.times.len() - 1]))?)
    }

    /// Where L points, on the sensor's axes at the first sample.
    fn momentum(&self) -> SpaceVector {
        let momentum = self.fit.motion().angular_momentum();
        momentum / momentum.norm()
    }

    /// Rates of the sensor on the principal axes, without its offset.
    fn principal(&self, rates: [f64; 3]) -> [f64; 3] {
        let offset = self.fit.correction(Correction::Offset);
        let shown = |i: usize| rates[i] - offset.get(i).map_or(0.0, |offset| offset.value);
        let axes = self.fit.motion().attitude(0.0);
        axes.to_body(SpaceVector::from([0, 1, 2].map(shown))).to_array()
    }

    fn recording_table(&self) -> Result<Table> {
        Table::of("recording", ["the file"], &self.notes, |note| Ok([note.clone()]))
    }

    fn flights_table(&self) -> Result<Table> {
        let columns = ["throw", "from", "to", "samples", "here"];
        Table::of("throws", columns, (1..).zip(&self.flights), |(n, ([from, to], samples))| {
            let here = if self.number == Some(n) { "fitted" } else { "-" };
            let seconds = |t: &f64| format!("{t:.3} s");
            Ok([n.to_string(), seconds(from), seconds(to), samples.to_string(), here.into()])
        })
    }

    /// What was tried, whether the recording calls for it, and what it came to.
    fn decided(&self) -> Vec<Decided> {
        let decided = self.fit.decisions().iter().map(|decision| {
            let (name, unit) = match decision.correction {
                Correction::Axes => {
                    ("principal axes turned against the phone's", "rad about x, y, z")
                }
                Correction::Offset => ("offset of the sensor", "rad/s on x, y, z"),
                Correction::Filter => ("filter of the sensor: its time, squared", "s^2"),
                Correction::Drag => ("drag of the air", "1/s"),
            };
            Decided {
                name,
                unit,
                needed: decision.needed,
                improvement: decision.improvement,
                threshold: decision.threshold,
                values: self.fit.correction(decision.correction).into_iter().map(triple).collect(),
            }
        });
        decided.collect()
    }

    /// What was measured, what was fitted.
    fn trajectory(&self) -> Result<Trajectory> {
        let measured = AXES.map(|axis| format!("omega_{axis} [rad/s]"));
        let fitted = AXES.map(|axis| format!("fitted omega_{axis} [rad/s]"));
        let columns = ["t [s]".to_owned()].into_iter().chain(measured).chain(fitted);
        let mut samples = Trajectory::new(columns)?;
        for (t, rates) in self.times.iter().zip(&self.rates) {
            let fitted = self.fit.rates(*t)?.to_array();
            samples.push([&[*t], rates.as_slice(), fitted.as_slice()].concat())?;
        }
        Ok(samples)
    }

    /// All that the flight says, compared with a uniform box if one is given.
    ///
    /// # Errors
    /// Those of the library and of the drawings.
    pub fn recorded(&self, compared: Option<Lengths>) -> Result<Recorded> {
        let (found, decided) = (self.found(compared)?, self.decided());
        let which = self.number.map_or("a piece of it".into(), |n| format!("throw {n}"));
        let mut report =
            Report::new("Your own recording", format!("a free body fitted to {which}"))?;
        for table in [
            self.recording_table()?,
            self.flights_table()?,
            Found::table(&found)?,
            Decided::table(&decided)?,
        ] {
            report.add(table)?;
        }
        Ok(Recorded {
            report,
            found,
            decided,
            figures: vec![self.rates_figure()?, self.file_figure()?],
            trajectory: self.trajectory()?,
            // Without moments there is no ellipsoid.
            pictures: match self.fit.moments() {
                Some(_) => vec![("recorded_polhode", self.polhode()?)],
                None => Vec::new(),
            },
            captions: vec![
                (
                    "recorded_rates",
                    "The rates that were recorded (dots) and those of the free body that fits them \
                    best (lines), on the axes of the phone; below, what the fit leaves.",
                ),
                (
                    "recorded_file",
                    "The whole recording: size of the angular velocity. Shaded: the flights that were found, or the \
                    piece that was chosen.",
                ),
                (
                    "recorded_polhode",
                    "The polhode: the path of the angular velocity on the ellipsoid of energy. \
                    Dots: recorded.",
                ),
                (
                    "recorded_throw",
                    "The throw once more, by the fit. Which way was up is not recorded, so the \
                    phone begins flat; heights are drawn much reduced.",
                ),
            ],
        })
    }
}
