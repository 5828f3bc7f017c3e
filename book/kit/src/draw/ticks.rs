//! Where the ticks of an axis stand, and what they say.

use super::canvas::Point;
use core::f64::consts::PI;
use rotation_dynamics::math::{log10, pow};
use rotation_dynamics::{Error, Result};

/// The distance of ticks.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Step {
    Of(f64),
    /// A part of pi: numerator and denominator.
    Pi(i64, i64),
    /// So many powers of ten.
    Decades(i64),
}

impl Step {
    /// The finest decimal step with at most so many ticks. One tick says nothing about the scale:
    /// then rather a few more.
    pub(super) fn decimal(range: Point, most: usize) -> Self {
        let start = libm::floor(log10(range.1 - range.0)) as i32 - 2;
        let step = |e: i32| [1.0, 2.0, 5.0].map(|n| Self::Of(n * pow(10.0, f64::from(e))));
        let steps = (start..start + 4).flat_map(step);
        let steps = steps.take_while(|step| step.count(range) >= 2);
        let chosen = steps.clone().find(|step| step.count(range) <= most);
        let finest = Self::Of(pow(10.0, f64::from(start)));
        chosen.or_else(|| steps.last()).unwrap_or(finest)
    }

    /// The finest simple part of pi with at most so many ticks; a decimal step where these are
    /// not three.
    pub(super) fn angle(range: Point, most: usize) -> Self {
        let parts = [24, 12, 8, 6, 4, 2, 1].map(|d| Self::Pi(1, d));
        let turns = [2, 5, 10, 20, 50].map(|n| Self::Pi(n, 1));
        let mut steps = parts.into_iter().chain(turns);
        let step = steps.find(|step| step.count(range) <= most);
        step.filter(|step| step.count(range) >= 3).unwrap_or_else(|| Self::decimal(range, most))
    }

    /// The fewest decades with at most so many ticks.
    pub(super) fn decades(range: Point, most: usize) -> Self {
        let mut steps = [1, 2, 3, 4, 5, 10, 20, 50, 100].map(Self::Decades).into_iter();
        let step = steps.find(|step| step.count(range) <= most);
        step.unwrap_or(Self::Decades(100))
    }

    fn length(self) -> f64 {
        match self {
            Self::Of(length) => length,
            Self::Pi(n, d) => PI * n as f64 / d as f64,
            Self::Decades(n) => n as f64,
        }
    }

    /// Its multiples in the range, by their factors.
    fn multiples(self, (low, high): Point) -> core::ops::RangeInclusive<i64> {
        let step = self.length();
        // Data that all but reach a round value get its tick: it stands at most a pixel outside.
        let slack = 0.004 * (high - low) / step;
        libm::ceil(low / step - slack) as i64..=libm::floor(high / step + slack) as i64
    }

    fn count(self, range: Point) -> usize {
        self.multiples(range).count()
    }

    /// Places and labels of the ticks within the range.
    pub(super) fn ticks(self, range: Point) -> Result<Vec<(f64, String)>> {
        let length = self.length();
        // Also what is not a number is not within the bounds.
        if !(length > 0.0 && (range.1 - range.0) / length <= 100.0) {
            return Err(Error::out_of_range(
                "the step of the ticks of an axis",
                length,
                "it must be greater than 0, and at least a hundredth of the axis",
            ));
        }
        let ticks = self.multiples(range).map(|i| i as f64 * length);
        Ok(ticks.map(|place| (place, self.label(place))).collect())
    }

    fn label(self, place: f64) -> String {
        let length = self.length();
        let whole = |d: &i32| {
            let scaled = length * pow(10.0, f64::from(*d));
            (scaled - libm::round(scaled)).abs() < 1e-6 * scaled
        };
        match self {
            Self::Of(_) => {
                let decimals = (0..12).find(whole).unwrap_or(12) as usize;
                format!("${place:.decimals$}$")
            }
            Self::Pi(n, d) => part_of_pi(n * libm::round(place / length) as i64, d),
            Self::Decades(_) => match place as i64 {
                0 => "$1$".into(),
                1 => "$10$".into(),
                e => format!("$10^{{{e}}}$"),
            },
        }
    }
}

/// `n pi / d` as a label, in lowest terms.
fn part_of_pi(n: i64, d: i64) -> String {
    let (mut a, mut b) = (n.abs(), d);
    while b != 0 {
        (a, b) = (b, a % b);
    }
    let top = match n / a {
        0 => return "$0$".into(),
        1 => String::new(),
        -1 => "-".into(),
        n => n.to_string(),
    };
    match d / a {
        1 => format!("${top}\\pi$"),
        d => format!("${top}\\pi/{d}$"),
    }
}
