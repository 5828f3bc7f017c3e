//! Where the ticks of an axis stand, and what they say.

use core::f64::consts::PI;
use rotation_dynamics::math::log10;
use rotation_dynamics::{Error, Result};

/// The distance of ticks.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Step {
    Of(f64),
    /// Pi over this.
    Pi(u32),
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

pub(super) fn decimal_ticks(low: f64, high: f64, most: usize) -> Vec<(f64, String)> {
    let start = libm::floor(log10(high - low)) as i32 - 2;
    let steps = (start..start + 4).flat_map(|e| [1.0, 2.0, 5.0].map(|factor| (factor, e)));
    let value = |(factor, e): (f64, i32)| factor * rotation_dynamics::math::pow(10.0, f64::from(e));
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

pub(super) fn stepped_ticks(low: f64, high: f64, step: Step) -> Result<Vec<(f64, String)>> {
    let length = match step {
        Step::Of(length) => length,
        Step::Pi(denominator) => PI / f64::from(denominator),
    };
    // Also what is not a number is not within the bounds.
    if !(length > 0.0 && (high - low) / length <= 100.0) {
        return Err(Error::out_of_range(
            "the step of the ticks of an axis",
            length,
            "it must be greater than 0, and at least a hundredth of the axis",
        ));
    }
    let digits = |d: &i32| {
        let scaled = length * rotation_dynamics::math::pow(10.0, f64::from(*d));
        (scaled - libm::round(scaled)).abs() < 1e-6 * scaled
    };
    let decimals = (0..12).find(digits).unwrap_or(12) as usize;
    let label = |i: i64| match step {
        Step::Of(_) => format!("${:.decimals$}$", i as f64 * length),
        Step::Pi(denominator) => part_of_pi(i, i64::from(denominator)),
    };
    Ok(multiples(low, high, length)
        .map(|i| (i as f64 * length, label(i)))
        .collect())
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

pub(super) fn angle_ticks(low: f64, high: f64, most: usize) -> Vec<(f64, String)> {
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

pub(super) fn decade_ticks(low: f64, high: f64, most: usize) -> Vec<(f64, String)> {
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
