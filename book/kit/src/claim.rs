//! A claim: a number, its error bound, and the independent route that confirms it.

use super::answer::{self, Answer, Verdict};
use super::number::{below, rounded_up, supported_digits, taken_away};
use crate::error::{Error, Result};
use rotation_dynamics::math::EPS;

/// The independent route that a claim was compared with.
#[derive(Debug, Clone, PartialEq)]
pub struct Oracle {
    /// What it is, in a few words: `"closed form"`, `"DOP853 at 1e-13"`.
    pub name: String,
    /// The value it gives, in the claim's unit.
    pub value: f64,
}

impl Oracle {
    /// The route called `name`, which gives `value`.
    pub fn new(name: impl Into<String>, value: f64) -> Self {
        Self {
            name: name.into(),
            value,
        }
    }
}

/// A wrong answer that people give, and what to tell them.
#[derive(Debug, Clone, PartialEq)]
pub struct Slip {
    /// The wrong value, in the claim's unit.
    pub value: f64,
    /// One sentence that helps without giving the answer away.
    pub hint: String,
}

/// A number that may be printed: it has a bound, and a second route agrees within it.
///
/// ```
/// use kit::{Claim, Oracle};
/// let claim = Claim::new("angle", "angle of release", 0.863_154_1, "rad", 1e-6,
///     Oracle::new("located event", 0.863_154_3))?
///     .slip(0.707_6, "that is measured from the floor");
/// assert_eq!(claim.printed(), "0.863154");
/// // 1e-6, and the tenth of it that is not printed.
/// assert_eq!(claim.printed_bound(), "2e-6");
/// // A value that its oracle contradicts cannot be made into a claim.
/// assert!(Claim::new("angle", "angle of release", 0.9, "rad", 1e-6,
///     Oracle::new("located event", 0.863_154_3)).is_err());
/// # Ok::<(), kit::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Claim {
    key: String,
    meaning: String,
    value: f64,
    unit: String,
    bound: f64,
    oracle: Oracle,
    judged_within: f64,
    slips: Vec<Slip>,
    group: Option<String>,
}

impl Claim {
    /// The claim that `meaning` is `value` (in `unit`, `"-"` if it has none) up to
    /// `bound`, as `oracle` confirms: `|value - oracle.value| <= bound`.
    ///
    /// `key` names it everywhere (`[a-z0-9_]+`). A bound of 0 claims equal bits.
    ///
    /// # Errors
    /// [`Error::Contradicted`] if the oracle differs by more than the bound (or
    /// anything is NaN or infinite), [`Error::Text`] for a key or text that does
    /// not fit in a table.
    pub fn new(
        key: impl Into<String>,
        meaning: impl Into<String>,
        value: f64,
        unit: impl Into<String>,
        bound: f64,
        oracle: Oracle,
    ) -> Result<Self> {
        let claim = Self {
            key: key.into(),
            meaning: meaning.into(),
            value,
            unit: unit.into(),
            bound,
            oracle,
            judged_within: 1e-3,
            slips: Vec::new(),
            group: None,
        };
        let key_is_plain = !claim.key.is_empty()
            && claim
                .key
                .bytes()
                .all(|b| b.is_ascii_lowercase() || b.is_ascii_digit() || b == b'_');
        if !key_is_plain {
            return Err(Error::Text {
                text: claim.key,
                allowed: "a key has only a-z, 0-9 and _",
            });
        }
        for cell in [&claim.meaning, &claim.unit, &claim.oracle.name] {
            super::table::check_cell(cell)?;
        }
        // Positive conditions, so that a NaN anywhere fails them.
        let agrees = (claim.value - claim.oracle.value).abs() <= claim.bound;
        if agrees && claim.bound.is_finite() && claim.value.is_finite() {
            Ok(claim)
        } else {
            Err(Error::Contradicted {
                key: claim.key,
                value: claim.value,
                oracle: claim.oracle.name,
                oracle_value: claim.oracle.value,
                bound: claim.bound,
            })
        }
    }

    /// Adds a wrong answer to be recognised by [`Claim::verdict`].
    #[must_use]
    pub fn slip(mut self, value: f64, hint: impl Into<String>) -> Self {
        self.slips.push(Slip {
            value,
            hint: hint.into(),
        });
        self
    }

    /// Sets the relative error that says how many digits a reader's answer must have, as
    /// [`digits_asked`](super::digits_asked) counts them (0.001 if never set, and so 4 digits).
    #[must_use]
    pub fn judged_within(mut self, relative: f64) -> Self {
        self.judged_within = relative;
        self
    }

    /// Offers it in the page's answer box, under the heading `group`.
    #[must_use]
    pub fn answer(mut self, group: impl Into<String>) -> Self {
        self.group = Some(group.into());
        self
    }

    /// The key, unique in its report.
    pub fn key(&self) -> &str {
        &self.key
    }
    /// What the number is, in a few words.
    pub fn meaning(&self) -> &str {
        &self.meaning
    }
    /// The number.
    pub fn value(&self) -> f64 {
        self.value
    }
    /// Its unit, `"-"` if it has none.
    pub fn unit(&self) -> &str {
        &self.unit
    }
    /// The bound on its absolute error.
    pub fn bound(&self) -> f64 {
        self.bound
    }
    /// The independent route.
    pub fn oracle(&self) -> &Oracle {
        &self.oracle
    }
    /// How far the two routes are apart.
    pub fn difference(&self) -> f64 {
        (self.value - self.oracle.value).abs()
    }
    /// The relative error that says how many digits an answer must have.
    pub fn tolerance(&self) -> f64 {
        self.judged_within
    }
    /// The wrong answers that are recognised by name.
    pub fn slips(&self) -> &[Slip] {
        &self.slips
    }

    /// The heading under which the answer box offers it, if it does.
    pub fn group(&self) -> Option<&str> {
        self.group.as_deref()
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
            below(
                self.difference(),
                EPS * self.value.abs().max(self.oracle.value.abs()),
            ),
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
    /// 6. one of [`USUAL_SLIPS`](super::USUAL_SLIPS) for the claim's unit (or the
    ///    reciprocal), if `x` is that close to it;
    /// 7. wrong.
    pub fn verdict(&self, answer: impl Into<Answer>) -> Verdict {
        answer::judge(self, &answer.into())
    }
}
