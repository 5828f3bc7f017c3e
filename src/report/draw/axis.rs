//! Axes: a label, a range that defaults to the data's, and where the ticks stand.

use crate::error::{Error, Result, finite};
use crate::math::log10;
use core::f64::consts::PI;

#[derive(Debug, Clone, Copy, PartialEq)]
enum Scale {
    Linear,
    /// Ticks at fractions and multiples of pi.
    Angle,
    Log,
}

/// An axis of a [`super::Panel`].
#[derive(Debug, Clone, PartialEq)]
pub struct Axis {
    pub(super) label: String,
    scale: Scale,
    range: Option<(f64, f64)>,
    ticks: Option<Vec<(f64, String)>>,
}

impl Axis {
    fn new(label: &str, scale: Scale) -> Self {
        Self {
            label: label.into(),
            scale,
            range: None,
            ticks: None,
        }
    }

    /// A linear axis; the label holds the unit, as in `"$t$ / s"`.
    pub fn linear(label: &str) -> Self {
        Self::new(label, Scale::Linear)
    }

    /// A linear axis for an angle in radians, with ticks at simple parts of pi.
    pub fn angle(label: &str) -> Self {
        Self::new(label, Scale::Angle)
    }

    /// A logarithmic axis, with ticks at powers of ten.
    pub fn log(label: &str) -> Self {
        Self::new(label, Scale::Log)
    }

    /// The axis goes from `from` to `to`; without this, from the least to the
    /// greatest value drawn.
    #[must_use]
    pub fn range(mut self, from: f64, to: f64) -> Self {
        self.range = Some((from, to));
        self
    }

    /// Ticks stand at these places, labelled so; without this, at round values.
    #[must_use]
    pub fn ticks<S: Into<String>>(mut self, ticks: impl IntoIterator<Item = (f64, S)>) -> Self {
        self.ticks = Some(ticks.into_iter().map(|(x, s)| (x, s.into())).collect());
        self
    }

    /// The place of `value` on the axis: itself, or its decimal logarithm.
    pub(super) fn place(&self, value: f64) -> Result<f64> {
        finite("a value in a figure", value)?;
        match self.scale {
            Scale::Log if value <= 0.0 => Err(Error::OutOfRange {
                name: "a value on a logarithmic axis",
                value,
                allowed: "it must be greater than 0",
            }),
            Scale::Log => Ok(log10(value)),
            _ => Ok(value),
        }
    }

    /// The range in places, given the places of the data.
    pub(super) fn extent(&self, places: impl Iterator<Item = f64>) -> Result<(f64, f64)> {
        let (low, high) = match self.range {
            Some((from, to)) => (self.place(from)?, self.place(to)?),
            None => places.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| {
                (a.min(x), b.max(x))
            }),
        };
        if low < high {
            Ok((low, high))
        } else {
            Err(Error::OutOfRange {
                name: "the length of an axis",
                value: high - low,
                allowed: "it must be greater than 0: give the axis a range",
            })
        }
    }

    /// The places and labels of the ticks within an extent; at most about `most`.
    pub(super) fn marks(&self, (low, high): (f64, f64), most: usize) -> Result<Vec<(f64, String)>> {
        if let Some(ticks) = &self.ticks {
            return ticks
                .iter()
                .map(|(value, label)| Ok((self.place(*value)?, label.clone())))
                .collect();
        }
        Ok(match self.scale {
            Scale::Linear => decimal_ticks(low, high, most),
            Scale::Angle => angle_ticks(low, high, most),
            Scale::Log => decade_ticks(low, high, most),
        })
    }
}

/// The multiples of `step` in the range, by their integer factors.
fn multiples(low: f64, high: f64, step: f64) -> core::ops::RangeInclusive<i64> {
    // Data that all but reach a round value get its tick: it stands at most a pixel outside.
    let slack = 0.004 * (high - low) / step;
    libm::ceil(low / step - slack) as i64..=libm::floor(high / step + slack) as i64
}

fn count(low: f64, high: f64, step: f64) -> usize {
    multiples(low, high, step).count()
}

fn decimal_ticks(low: f64, high: f64, most: usize) -> Vec<(f64, String)> {
    let start = libm::floor(log10(high - low)) as i32 - 2;
    let steps = (start..start + 4).flat_map(|e| [1.0, 2.0, 5.0].map(|factor| (factor, e)));
    let value = |(factor, e): (f64, i32)| factor * crate::math::pow(10.0, f64::from(e));
    let mut chosen = (1.0, start);
    for step in steps {
        let count = count(low, high, value(step));
        // One tick says nothing about the scale: then rather a few more.
        if count >= 2 {
            chosen = step;
        }
        if count <= most {
            break;
        }
    }
    let (step, decimals) = (value(chosen), (-chosen.1).max(0) as usize);
    multiples(low, high, step)
        .map(|i| {
            let at = i as f64 * step;
            (at, format!("${at:.decimals$}$"))
        })
        .collect()
}

/// Parts of pi that make a good step: numerator and denominator.
const PARTS: [(i64, i64); 12] = [
    (1, 24),
    (1, 12),
    (1, 8),
    (1, 6),
    (1, 4),
    (1, 2),
    (1, 1),
    (2, 1),
    (5, 1),
    (10, 1),
    (20, 1),
    (50, 1),
];

fn angle_ticks(low: f64, high: f64, most: usize) -> Vec<(f64, String)> {
    let step = |(n, d): (i64, i64)| PI * n as f64 / d as f64;
    let Some(part) = PARTS
        .into_iter()
        .find(|&p| count(low, high, step(p)) <= most)
    else {
        return decimal_ticks(low, high, most);
    };
    if count(low, high, step(part)) < 3 {
        return decimal_ticks(low, high, most);
    }
    multiples(low, high, step(part))
        .map(|i| (i as f64 * step(part), part_of_pi(i * part.0, part.1)))
        .collect()
}

/// `n pi / d` as a label, in lowest terms.
fn part_of_pi(n: i64, d: i64) -> String {
    if n == 0 {
        return "$0$".into();
    }
    let (mut a, mut b) = (n.abs(), d);
    while b != 0 {
        (a, b) = (b, a % b);
    }
    let (n, d) = (n / a, d / a);
    let top = match n {
        1 => String::new(),
        -1 => "-".into(),
        n => n.to_string(),
    };
    if d == 1 {
        format!("${top}\\pi$")
    } else {
        format!("${top}\\pi/{d}$")
    }
}

fn decade_ticks(low: f64, high: f64, most: usize) -> Vec<(f64, String)> {
    let step = [1.0, 2.0, 3.0, 4.0, 5.0, 10.0, 20.0, 50.0, 100.0]
        .into_iter()
        .find(|&s| count(low, high, s) <= most)
        .unwrap_or(100.0);
    multiples(low, high, step)
        .map(|i| {
            let place = i as f64 * step;
            let label = match place as i64 {
                0 => "$1$".into(),
                1 => "$10$".into(),
                e => format!("$10^{{{e}}}$"),
            };
            (place, label)
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(axis: &Axis, extent: (f64, f64)) -> Vec<String> {
        let ticks = axis.marks(extent, 6).expect("the ticks are the axis's own");
        ticks
            .into_iter()
            .map(|(_, label)| label.replace('$', ""))
            .collect()
    }

    #[test]
    fn ticks_are_round_and_inside() {
        let axis = Axis::linear("x");
        assert_eq!(labels(&axis, (0.0, 10.0)), ["0", "2", "4", "6", "8", "10"]);
        assert_eq!(labels(&axis, (0.62, 1.36)), ["0.8", "1.0", "1.2"]);
        assert_eq!(labels(&axis, (-0.3, 0.3)), ["-0.2", "0.0", "0.2"]);
        let angle = Axis::angle("x");
        assert_eq!(
            labels(&angle, (0.0, PI)),
            ["0", "\\pi/4", "\\pi/2", "3\\pi/4", "\\pi"]
        );
        assert_eq!(
            labels(&angle, (-PI, PI)),
            ["-\\pi", "-\\pi/2", "0", "\\pi/2", "\\pi"]
        );
        let log = Axis::log("x");
        assert_eq!(
            labels(&log, (-12.0, -2.0)),
            [
                "10^{-12}", "10^{-10}", "10^{-8}", "10^{-6}", "10^{-4}", "10^{-2}"
            ]
        );
    }

    #[test]
    fn an_axis_refuses_what_it_cannot_show() {
        assert!(Axis::log("x").place(0.0).is_err());
        assert!(Axis::linear("x").place(f64::NAN).is_err());
        assert!(
            Axis::linear("x")
                .range(1.0, 1.0)
                .extent(core::iter::empty())
                .is_err()
        );
        assert!(Axis::linear("x").extent(core::iter::empty()).is_err());
    }
}
