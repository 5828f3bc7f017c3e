//! A claim: a number, its error bound, and the independent route that confirms it.

use super::answer::{self, Answer, Verdict};
use super::number::{below, rounded_up, supported_digits, taken_away};
use super::table::check_cell;
use crate::error::{Error, Result, finite};
use rotation_dynamics::math::EPS;

/// The independent route that a claim was compared with.
#[derive(Debug, Clone, PartialEq)]
pub struct Oracle {
    /// What it is, in a few words: `"closed form"`, `"DOP853 at 1e-13"`.
    pub name: String,
    /// The value it gives, in the claim's unit.
    pub value: f64,
}

/// A wrong answer that people give, and what to tell them.
#[derive(Debug, Clone, PartialEq)]
pub struct Slip {
    /// The wrong value, in the claim's unit.
    pub value: f64,
    /// One sentence that helps without giving the answer away.
    pub hint: String,
}

/// A number, its bound, and a second route that agrees within it. It needs
/// [`within`](Claim::within) and [`against`](Claim::against), and is checked as
/// [`Report::add`](super::Report::add) adds it.
///
/// ```
/// use kit::{Report, claim};
/// let angle = claim("angle", "angle of release", 0.863_154_1, "rad")
///     .within(1e-6)
///     .against("located event", 0.863_154_3)
///     .slip(0.707_6, "that is measured from the floor");
/// assert_eq!(angle.printed(), "0.863154");
/// // 1e-6, and the tenth of it that is not printed.
/// assert_eq!(angle.printed_bound(), "2e-6");
/// let mut report = Report::new("A ladder", "it slides down a wall")?;
/// report.add(angle.clone())?;
/// // A value that its oracle contradicts is refused.
/// assert!(report.add(angle.against("by hand", 0.9)).is_err());
/// # Ok::<(), kit::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
#[must_use = "it is added by Report::add"]
pub struct Claim {
    /// The key, unique in its report.
    pub key: String,
    /// What the number is, in a few words.
    pub meaning: String,
    /// The number.
    pub value: f64,
    /// Its unit, `"-"` if it has none.
    pub unit: String,
    /// The bound on its absolute error.
    pub bound: f64,
    /// The independent route.
    pub oracle: Oracle,
    /// The relative error that says how many digits an answer must have.
    pub judged_within: f64,
    /// The wrong answers that are recognised by name.
    pub slips: Vec<Slip>,
    /// The heading under which the answer box offers it, if it does.
    pub group: Option<String>,
}

/// The claim that `meaning` is `value`, in `unit` (`"-"` if it has none); `key` (`[a-z0-9_]+`) names
/// it everywhere.
pub fn claim(
    key: impl Into<String>,
    meaning: impl Into<String>,
    value: f64,
    unit: impl Into<String>,
) -> Claim {
    Claim {
        key: key.into(),
        meaning: meaning.into(),
        value,
        unit: unit.into(),
        bound: f64::NAN,
        oracle: Oracle { name: "nothing".into(), value: f64::NAN },
        judged_within: 1e-3,
        slips: Vec::new(),
        group: None,
    }
}

impl Claim {
    /// The bound on its absolute error: of a part of a negative number its size; 0 claims equal bits.
    pub fn within(mut self, bound: f64) -> Self {
        self.bound = bound.abs();
        self
    }

    /// The independent route called `oracle`, and what it gives.
    pub fn against(mut self, oracle: &str, value: f64) -> Self {
        let name = oracle.into();
        self.oracle = Oracle { name, value };
        self
    }

    /// [`against`](Self::against) and [`within`](Self::within) in one line.
    pub fn agrees_with(self, oracle: &str, value: f64, bound: f64) -> Self {
        self.against(oracle, value).within(bound)
    }

    /// A wrong answer that people give, and a hint that does not give the right one away.
    pub fn slip(mut self, value: f64, hint: impl Into<String>) -> Self {
        let hint = hint.into();
        self.slips.push(Slip { value, hint });
        self
    }

    /// The relative error that says how many digits a reader's answer must have, as
    /// [`digits_asked`](super::digits_asked) counts them (0.001 if never set, and so 4 digits).
    pub fn judged_within(mut self, relative: f64) -> Self {
        self.judged_within = relative;
        self
    }

    /// Offers it in the page's answer box, under this heading: something a student would compute.
    pub fn answer(mut self, group: impl Into<String>) -> Self {
        self.group = Some(group.into());
        self
    }

    /// Refuses a number that its oracle contradicts, or text and numbers that no report can hold.
    pub(super) fn check(&self) -> Result<()> {
        let plain = |b: u8| b.is_ascii_lowercase() || b.is_ascii_digit() || b == b'_';
        if self.key.is_empty() || !self.key.bytes().all(plain) {
            return Err(Error::Text {
                text: self.key.clone(),
                allowed: "a key has only a-z, 0-9 and _",
            });
        }
        for cell in [&self.meaning, &self.unit, &self.oracle.name] {
            check_cell(cell)?;
        }
        // Positive conditions, so that a NaN anywhere fails them.
        let agrees = self.difference() <= self.bound;
        if !(agrees && self.bound.is_finite() && self.value.is_finite()) {
            return Err(Error::Contradicted {
                key: self.key.clone(),
                value: self.value,
                oracle: self.oracle.name.clone(),
                oracle_value: self.oracle.value,
                bound: self.bound,
            });
        }
        let tolerance = self.judged_within;
        if !(0.0 < tolerance && tolerance < 1.0) {
            return Err(rotation_dynamics::Error::out_of_range(
                "the relative tolerance of a check",
                tolerance,
                "it must lie between 0 and 1",
            )
            .into());
        }
        for slip in &self.slips {
            finite("a slip", slip.value)?;
            check_cell(&slip.hint)?;
        }
        Ok(())
    }

    /// How far the two routes are apart.
    pub fn difference(&self) -> f64 {
        (self.value - self.oracle.value).abs()
    }

    /// The value with the digits that its bound supports.
    pub fn printed(&self) -> String {
        supported_digits(self.value, self.bound)
    }

    /// The bound on the error of the printed value: that of the value, and what printing took
    /// away, rounded up to one digit.
    pub fn printed_bound(&self) -> String {
        rounded_up(self.bound + taken_away(self.value, &self.printed()))
    }

    pub(super) fn cells(&self) -> [String; 6] {
        [
            self.key.clone(),
            self.printed(),
            self.unit.clone(),
            self.printed_bound(),
            self.oracle.name.clone(),
            below(self.difference(), EPS * self.value.abs().max(self.oracle.value.abs())),
        ]
    }

    /// Judges a reader's answer `x` against the value `v`, by these rules in this order:
    ///
    /// 1. another unit, if one is given and it is not the claim's (radians count as 1);
    /// 2. right, if `x` has the `N` digits that the claim's tolerance `r` asks for
    ///    ([`digits_asked`](super::digits_asked)): `|x - v| <= max(10^(e+1-N) / 2, bound)` with
    ///    `10^e <= |v| < 10^(e+1)` (`max(r, bound)` if `v = 0`);
    /// 3. a slip listed by the claim, if `x` is within `r` of the slip's value;
    /// 4. right as far as it goes, if `x` was typed with fewer than `N` digits and is `v`
    ///    rounded to them;
    /// 5. right to `n >= 2` digits, if `|x - v| <= 10^(e+1-n) / 2`;
    /// 6. a usual slip (a sign, a factor of 2 or 2 pi, degrees) for the claim's unit (or the
    ///    reciprocal), if `x` is that close to it;
    /// 7. wrong.
    pub fn verdict(&self, answer: impl Into<Answer>) -> Verdict {
        answer::judge(self, &answer.into())
    }
}
