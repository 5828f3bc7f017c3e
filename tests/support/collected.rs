//! The errors of many cases.

use crate::locked::{locked, three_digits};
use crate::relative;
use core::cell::Cell;
use core::fmt::Debug;
use core::ops::RangeInclusive;

/// Asserts how many errors there are and the largest, to three digits; fewer digits mean that it
/// is exactly that: `assert_largest!(errors, 20, @"2.37e-14")`.
///
/// The text is an inline snapshot of insta's; `cargo insta` writes another number there.
#[macro_export]
macro_rules! assert_largest {
    ($errors:expr, $cases:expr, @$largest:literal) => {
        $errors.largest_is($cases, $largest)
    };
}

/// Asserts a table of errors: what they are of, the largest as in [`assert_largest!`], and how many
/// they are.
#[macro_export]
macro_rules! assert_table {
    ($errors:expr, @$table:literal) => {
        $crate::table_is($errors, $table)
    };
}

/// What [`assert_table!`] calls.
#[doc(hidden)]
#[track_caller]
pub fn table_is<'a>(all: impl IntoIterator<Item = &'a Errors>, printed: &str) {
    let mut table = String::new();
    for errors in all {
        let (what, cases) = (&errors.what, errors.cases);
        table += &format!("{what}: {} of {cases}\n", errors.measured(cases));
    }
    locked(&table, printed, "the largest errors");
}

/// The errors of many cases, of which the largest is asserted.
///
/// It must be judged, by [`assert_largest!`](crate::assert_largest), [`attain`](Self::attain),
/// [`exceed`](Self::exceed) or by reading [`largest`](Self::largest): one that is dropped
/// without fails the test.
#[derive(Debug)]
pub struct Errors {
    what: String,
    unit: f64,
    cases: usize,
    largest: f64,
    smallest: f64,
    /// Where the largest is.
    at: String,
    judged: Cell<bool>,
}

impl Errors {
    /// No errors yet, of what is named.
    #[track_caller]
    pub fn of(what: impl Into<String>) -> Self {
        Self::in_units_of(1.0, what)
    }

    /// No errors yet; those that come are divided by `unit`, such as eps.
    #[track_caller]
    pub fn in_units_of(unit: f64, what: impl Into<String>) -> Self {
        assert!(unit > 0.0 && unit.is_finite(), "{unit} is no unit of errors");
        Self {
            what: what.into(),
            unit,
            cases: 0,
            largest: 0.0,
            smallest: f64::INFINITY,
            at: "no case".to_owned(),
            judged: Cell::new(false),
        }
    }

    /// Adds |got - want|/scale.
    pub fn add(&mut self, got: f64, want: f64, scale: f64) {
        self.push(relative(got, want, scale));
    }

    /// Adds the size of a measured error.
    pub fn push(&mut self, error: f64) {
        self.push_at(error, self.cases);
    }

    /// Adds the size of a measured error, and where it is.
    pub fn push_at(&mut self, error: f64, case: impl Debug) {
        let error = error.abs() / self.unit;
        self.cases += 1;
        // Unlike `f64::max` this keeps a NaN, the first one.
        if !self.largest.is_nan() && (error.is_nan() || error > self.largest) {
            self.largest = error;
            self.at = format!("{case:?}");
        }
        if !self.smallest.is_nan() && (error.is_nan() || error < self.smallest) {
            self.smallest = error;
        }
    }

    /// The largest error in its unit; NaN if any is.
    pub fn largest(&self) -> f64 {
        self.judged.set(true);
        self.largest
    }

    /// The smallest error in its unit; NaN if any is.
    pub fn smallest(&self) -> f64 {
        self.judged.set(true);
        self.smallest
    }

    /// What [`assert_largest!`](crate::assert_largest) calls.
    #[doc(hidden)]
    #[track_caller]
    pub fn largest_is(&self, cases: usize, printed: &str) {
        let origin = format!("{}, at {}", self.what, self.at);
        locked(&self.measured(cases), printed, &origin);
    }

    #[track_caller]
    fn measured(&self, cases: usize) -> String {
        self.count(cases);
        let (what, largest, at) = (&self.what, self.largest(), &self.at);
        assert!(largest.is_finite(), "{what}: the largest of {cases} errors is {largest}, at {at}");
        three_digits(largest)
    }

    /// Asserts that there are this many errors and that the largest lies in the range: for
    /// ranges that have a reason. What is only measured is for
    /// [`assert_largest!`](crate::assert_largest).
    #[track_caller]
    pub fn attain(&self, range: RangeInclusive<f64>, cases: usize) {
        let (low, high) = (*range.start(), *range.end());
        assert!(
            0.0 <= low && low <= high && high <= 1.5 * low.max(f64::MIN_POSITIVE),
            "{}: {low:e}..={high:e} is not what was measured but a guess",
            self.what
        );
        self.count(cases);
        let (what, largest, at) = (&self.what, self.largest(), &self.at);
        assert!(
            range.contains(&largest),
            "{what}: the largest of {cases} errors is {largest:.3e}, at {at}; \
             written down is {low:.3e}..={high:.3e}"
        );
    }

    /// Asserts that there are this many errors and that even the smallest is larger
    /// than this: what a damaged twin must do.
    #[track_caller]
    pub fn exceed(&self, bound: f64, cases: usize) {
        self.count(cases);
        let (what, smallest) = (&self.what, self.smallest());
        assert!(
            smallest > bound,
            "{what}: the smallest of {cases} errors is {smallest:.3e}, not above {bound:.3e}"
        );
    }

    #[track_caller]
    fn count(&self, cases: usize) {
        self.judged.set(true);
        let (what, ran) = (&self.what, self.cases);
        assert!(ran == cases && ran > 0, "{what}: {ran} cases ran, not {cases}");
    }
}

/// The errors of so many cases, each beside the error of a damaged twin, of which even the smallest
/// must be larger than `twin`.
#[track_caller]
pub fn beside_twins(cases: impl IntoIterator<Item = [f64; 2]>, twin: f64, count: usize) -> Errors {
    let (mut errors, mut damaged) = (Errors::of("right"), Errors::of("damaged twin"));
    for [error, damage] in cases {
        errors.push(error);
        damaged.push(damage);
    }
    damaged.exceed(twin, count);
    errors
}

impl Drop for Errors {
    fn drop(&mut self) {
        let forgotten = !self.judged.get() && !std::thread::panicking();
        assert!(!forgotten, "{}: measured and never judged", self.what);
    }
}
