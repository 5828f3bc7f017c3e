//! The numbers of one sensor, as a table gives them.

use super::columns::Sensor;
use super::middle;
use crate::number::short;
use core::ops::Range;
use csv::StringRecord;

/// A column, and what is wrong there.
pub(super) type Wrong = (usize, String);

/// The samples of a sensor.
pub(super) struct Series {
    pub(super) sensor: Sensor,
    /// In the unit of the table, less the origin.
    pub(super) times: Vec<f64>,
    pub(super) values: Vec<[f64; 3]>,
    /// In which line of the file each is.
    pub(super) lines: Vec<usize>,
    /// What midnights add to the times of a clock (s).
    days: f64,
    by_clock: bool,
}

impl Series {
    pub(super) fn new(sensor: &Sensor) -> Self {
        Self {
            sensor: sensor.clone(),
            times: Vec::new(),
            values: Vec::new(),
            lines: Vec::new(),
            days: 0.0,
            by_clock: false,
        }
    }

    /// Takes a line in; whether it has numbers of this sensor. `origin` is a whole number from which
    /// times count: those since 1970 in ns have more digits than an `f64`.
    pub(super) fn take(
        &mut self,
        record: &StringRecord,
        line: usize,
        origin: &mut Option<i64>,
    ) -> Result<bool, Wrong> {
        let cells = self.sensor.axes.map(|n| record.get(n).unwrap_or("").trim());
        if cells.iter().all(|cell| cell.is_empty() || cell.eq_ignore_ascii_case("nan")) {
            return Ok(false);
        }
        let mut value = [0.0; 3];
        for ((value, cell), n) in value.iter_mut().zip(cells).zip(self.sensor.axes) {
            *value = measured(cell).map_err(|reason| (n, reason))?;
        }
        let cell = record.get(self.sensor.time).unwrap_or("").trim();
        let t = self.time(cell, origin).map_err(|reason| (self.sensor.time, reason))?;
        if self.times.last().is_some_and(|last| t < *last) {
            let cell = brief(cell);
            let reason =
                format!("the time {cell} is before that of a line above: times must ascend");
            return Err((self.sensor.time, reason));
        }
        self.times.push(t);
        self.values.push(value);
        self.lines.push(line);
        Ok(true)
    }

    /// Makes times that repeat ascend: how many repeat, and what was done.
    ///
    /// Where n lines have one time and the next time follows after n usual steps, samples came regularly and their
    /// stamps did not: they are spread evenly. Else, or where all values repeat as well, they are averaged.
    pub(super) fn settle(&mut self) -> Option<(usize, &'static str)> {
        let groups: Vec<_> = self.times.chunk_by(|a, b| a == b).map(<[f64]>::len).collect();
        let repeated = self.times.len() - groups.len();
        if repeated == 0 {
            return None;
        }
        let ends = groups.iter().scan(0, |end, count| {
            *end += count;
            Some(*end)
        });
        let groups: Vec<_> = ends.zip(&groups).map(|(end, count)| end - count..end).collect();
        let step = |group: &Range<usize>| {
            let next = self.times.get(group.end);
            next.map(|next| (next - self.times[group.start]) / group.len() as f64)
        };
        let usual = middle(groups.iter().filter_map(step).collect());
        let many = groups.iter().filter(|group| group.len() > 1);
        let off = many.clone().filter_map(step).map(|step| (step / usual - 1.0).abs()).collect();
        let differ = many
            .clone()
            .any(|group| self.values[group.clone()].windows(2).any(|pair| pair[0] != pair[1]));
        // Two lines for one step are off by a half.
        if differ && middle(off) < 0.25 {
            let times = groups.iter().flat_map(|group| {
                let step = step(group).map_or(usual, |step| step.min(usual));
                let first = self.times[group.start];
                (0..group.len()).map(move |n| first + step * n as f64)
            });
            self.times = times.collect();
            return Some((repeated, "samples come regularly, so they were spread evenly"));
        }
        let mean = |group: &Range<usize>| {
            let sum =
                |k: usize| self.values[group.clone()].iter().map(|value| value[k]).sum::<f64>();
            [0, 1, 2].map(|k| sum(k) / group.len() as f64)
        };
        self.values = groups.iter().map(mean).collect();
        self.times = groups.iter().map(|group| self.times[group.start]).collect();
        self.lines = groups.iter().map(|group| self.lines[group.start]).collect();
        Some((repeated, "they were averaged"))
    }

    /// The time of a cell, in its unit, less the origin.
    fn time(&mut self, cell: &str, origin: &mut Option<i64>) -> Result<f64, String> {
        if cell.contains(':') {
            let t = of_the_day(cell).filter(|t| t.is_finite());
            let t = t.ok_or_else(|| format!("{:?} is neither a number nor a time", brief(cell)))?;
            self.by_clock = true;
            if self.times.last().is_some_and(|last| t + self.days < last - 43_200.0) {
                self.days += 86_400.0;
            }
            return Ok(t + self.days);
        }
        let cell = cell.trim_end_matches("sec").trim_end();
        let whole = || cell.parse::<i64>().ok();
        let origin = *origin.get_or_insert_with(|| whole().filter(|t| *t > 1 << 53).unwrap_or(0));
        match whole().filter(|_| origin != 0) {
            Some(t) => Ok(t.saturating_sub(origin) as f64),
            None => Ok(measured(cell)? - origin as f64),
        }
    }

    /// What is to be said of the times, the unit, and the origin that they are to have.
    pub(super) fn clock(&self, origin: i64, notes: &mut Vec<String>) -> (f64, f64) {
        let first = self.times[0];
        let unit = match self.sensor.time_unit {
            _ if self.by_clock => 1.0,
            Some(unit) => unit,
            // A phone takes between 10 and 10,000 samples a second, so that a step tells the unit.
            None => {
                let step = middle(self.times.windows(2).map(|pair| pair[1] - pair[0]).collect());
                let units = [(1e5, 1e-9, "ns"), (1e2, 1e-6, "us"), (0.1, 1e-3, "ms")];
                let found = units.into_iter().find(|(least, _, _)| step > *least);
                let (_, unit, name) = found.unwrap_or((0.0, 1.0, "s"));
                let step = short(step, 4);
                notes.push(format!(
                    "The times have no unit: by their steps of {step} they are in {name}."
                ));
                unit
            }
        };
        // A date, as seconds since 1970.
        if self.by_clock || unit * (first + origin as f64) > 1e8 {
            notes.push("Times count from the first sample.".into());
            return (unit, first);
        }
        (unit, -(origin as f64))
    }

    /// The value at a time, by straight lines between samples; beyond the first and the last, theirs.
    pub(super) fn at(&self, t: f64) -> [f64; 3] {
        let after = self.times.partition_point(|other| *other < t);
        if after == 0 || after == self.times.len() {
            return self.values[after.min(self.times.len() - 1)];
        }
        let [a, b] = [after - 1, after].map(|n| self.times[n]);
        let part = (t - a) / (b - a);
        let [a, b] = [after - 1, after].map(|n| self.values[n]);
        [0, 1, 2].map(|k| a[k] + part * (b[k] - a[k]))
    }
}

/// A number, with a decimal point or comma.
pub(super) fn number(cell: &str) -> Option<f64> {
    let cell = cell.trim();
    match cell.parse() {
        Ok(value) => Some(value),
        Err(_) if cell.contains(',') => cell.replacen(',', ".", 1).parse().ok(),
        Err(_) => None,
    }
}

/// As much of a cell as a message can have.
pub(super) fn brief(cell: &str) -> String {
    cell.chars().take(40).collect()
}

/// A finite number.
fn measured(cell: &str) -> Result<f64, String> {
    match number(cell) {
        _ if cell.is_empty() => Err("the cell is empty: expected a number".into()),
        None => Err(format!("{:?} is not a number", brief(cell))),
        Some(value) if !value.is_finite() => {
            Err(format!("{:?} is not a finite number", brief(cell)))
        }
        Some(value) => Ok(value),
    }
}

/// Seconds of the day at a time such as `2018-10-03 17:23:55.464`, `17:23:55:464`, `05:23:55 PM`.
fn of_the_day(cell: &str) -> Option<f64> {
    let clock = cell.split(['T', ' ']).rfind(|part| part.contains(':'))?;
    let clock = clock.split(['+', '-', 'Z']).next()?;
    let mut parts = clock.split(':').map(number);
    let [hours, minutes, seconds] = [parts.next()??, parts.next()??, parts.next()??];
    let thousandths = parts.next().unwrap_or(Some(0.0))?;
    let afternoon = if cell.contains("PM") && hours < 12.0 { 12.0 } else { 0.0 };
    Some(3600.0 * (hours + afternoon) + 60.0 * minutes + seconds + 1e-3 * thousandths)
}
