//! The number that a formula comes to; its grammar is that of an [`Answer`](super::Answer).

use core::f64::consts::{E, PI};
use libm::{floor, sqrt};
use rotation_dynamics::math::{acos, asin, atan, cos, exp, log, log10, pow, sin, tan};

/// A function and its name.
type Function = (&'static str, fn(f64) -> f64);

/// The functions that an answer may have. A bare `log` is none: it is `ln` here and `log10` there.
const FUNCTIONS: [Function; 10] = [
    ("sqrt", sqrt),
    ("sin", sin),
    ("cos", cos),
    ("tan", tan),
    ("asin", asin),
    ("acos", acos),
    ("atan", atan),
    ("exp", exp),
    ("ln", log),
    ("log10", log10),
];

/// Where `text` stands after the longest decimal number with which it begins.
pub(super) fn number_end(text: &str) -> Option<usize> {
    let digits = |from: usize| {
        let tail = text.get(from..).unwrap_or("");
        from + tail.bytes().take_while(u8::is_ascii_digit).count()
    };
    let whole = digits(0);
    let mut end = whole;
    if text[end..].starts_with('.') {
        end = digits(end + 1);
    }
    if end == 0 || (whole == 0 && end == 1) {
        return None;
    }
    if text[end..].starts_with(['e', 'E']) {
        let from = end + 1 + usize::from(text[end + 1..].starts_with(['+', '-']));
        if digits(from) > from {
            end = digits(from);
        }
    }
    Some(end)
}

/// What is left to read, and whether a function was met that is not known.
pub(super) struct Reader<'t> {
    pub(super) rest: &'t str,
    pub(super) unknown: bool,
}

impl Reader<'_> {
    fn space(&mut self) {
        self.rest = self.rest.trim_start();
    }

    /// Takes `word`, if it stands here.
    fn take(&mut self, word: &str) -> bool {
        let rest = self.rest.trim_start();
        let found = rest.strip_prefix(word);
        self.rest = found.unwrap_or(self.rest);
        found.is_some()
    }

    /// What `read` gives, or everything as it was.
    fn attempt(&mut self, read: impl FnOnce(&mut Self) -> Option<f64>) -> Option<f64> {
        let before = self.rest;
        let value = read(self);
        if value.is_none() {
            self.rest = before;
        }
        value
    }

    pub(super) fn sum(&mut self) -> Option<f64> {
        let mut value = self.product()?;
        loop {
            if let Some(more) = self.attempt(|r| r.take("+").then(|| r.product())?) {
                value += more;
            } else if let Some(less) = self.attempt(|r| r.take("-").then(|| r.product())?) {
                value -= less;
            } else {
                return Some(value);
            }
        }
    }

    fn product(&mut self) -> Option<f64> {
        let mut value = self.factor()?;
        loop {
            if let Some(by) = self.attempt(|r| r.times().then(|| r.factor())?) {
                value *= by;
            } else if let Some(by) = self.attempt(|r| r.take("/").then(|| r.factor())?) {
                value /= by;
            } else if let Some(by) = self.attempt(|r| r.begins_word().then(|| r.factor())?) {
                value *= by;
            } else {
                return Some(value);
            }
        }
    }

    /// A sign of multiplication; the letter x is one before a digit.
    fn times(&mut self) -> bool {
        if self.take("*") {
            return true;
        }
        let before = self.rest;
        if self.take("x") && number_end(self.rest.trim_start()).is_some() {
            return true;
        }
        self.rest = before;
        false
    }

    /// Whether a factor follows that needs no sign of multiplication before it.
    fn begins_word(&self) -> bool {
        let rest = self.rest.trim_start();
        let (name, after) = named(rest);
        rest.starts_with('(')
            || ["pi", "sqrt"].contains(&name)
            || (!name.is_empty() && after.starts_with('('))
    }

    fn factor(&mut self) -> Option<f64> {
        if self.take("-") {
            return Some(-self.factor()?);
        }
        if self.take("+") {
            return self.factor();
        }
        let base = self.atom()?;
        let power = self.attempt(|r| r.take("^").then(|| r.factor())?);
        Some(match power {
            None => base,
            Some(power) => raised(base, power),
        })
    }

    fn atom(&mut self) -> Option<f64> {
        self.space();
        if let Some(end) = number_end(self.rest) {
            let (number, rest) = self.rest.split_at(end);
            self.rest = rest;
            return number.parse().ok();
        }
        if self.take("(") {
            let inside = self.sum()?;
            return self.take(")").then_some(inside);
        }
        let (name, after) = named(self.rest);
        let function = FUNCTIONS.iter().find(|(known, _)| *known == name);
        let value = match (name, function) {
            ("pi", _) => PI,
            ("e", _) => E,
            (_, Some((name, function)))
                if *name == "sqrt" || after.trim_start().starts_with('(') =>
            {
                self.rest = after;
                return Some(function(self.atom()?));
            }
            _ => {
                self.unknown |= function.is_some() || after.starts_with('(') && !name.is_empty();
                return None;
            }
        };
        self.rest = after;
        Some(value)
    }
}

/// The name with which `text` begins, empty if it begins with none, and what follows.
fn named(text: &str) -> (&str, &str) {
    let letters = text.bytes().take_while(u8::is_ascii_alphabetic).count();
    let end = if text.starts_with("log10") { 5 } else { letters };
    text.split_at(end)
}

/// `base^power`.
pub(super) fn raised(base: f64, power: f64) -> f64 {
    if base == 10.0 && power == floor(power) {
        // As the decimal number is read, to the last bit.
        return format!("1e{power}").parse().unwrap_or(f64::NAN);
    }
    pow(base, power)
}
