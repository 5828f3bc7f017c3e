//! A reader's answer: how it is written, and how it is judged.
//!
//! The answer box of a page asks the module for this; the cases are in `tests/data/answers.json`.
//!
//! ```text
//! answer  = sum [ unit ]
//! sum     = product { ("+" | "-") product }
//! product = factor { ("*" | "/" | "x") factor | ("pi" | function | "(") … }
//! factor  = ("-" | "+") factor | atom [ "^" factor ]
//! atom    = number | "pi" | "e" | "sqrt" atom | function "(" sum ")" | "(" sum ")"
//! unit    = { name [ [ "^" ] integer ] | "1" } joined by " ", "*" or "/"
//! ```
//! A decimal comma (but for `1,000`, which may be a thousand), a true minus sign, raised digits, `×`,
//! `·`, `π` and `√` are read too.

use super::Claim;
use super::expression::{Reader, number_end, raised};
use core::f64::consts::PI;
use libm::{ceil, floor};
use rotation_dynamics::math::log10;
use std::collections::BTreeMap;

/// Longer texts are refused: no answer needs them.
const LONGEST: usize = 80;

/// What is said to a function that is not among them.
const UNKNOWN: &str = "that function is not known; there are sqrt, sin, cos, tan, asin, acos, atan, \
                       exp, ln and log10, each with its argument in parentheses";

/// A number as a reader gives it.
#[derive(Debug, Clone, PartialEq)]
pub struct Answer {
    /// Its value.
    pub value: f64,
    /// Its unit as it was typed, empty if none was.
    pub unit: String,
    /// Significant digits and the worth of the last one, if it was typed as a decimal number.
    typed: Option<(u32, f64)>,
}

impl From<f64> for Answer {
    fn from(value: f64) -> Self {
        Self { value, unit: String::new(), typed: None }
    }
}

impl Answer {
    /// Reads `2/3`, `1.5x10^-5`, `1,5`, `−0.3`, `pi/3`, `acos(2/3*cos(0.25))`, `0.876 s`.
    ///
    /// # Errors
    /// What is wrong with the text, in words.
    pub fn read(text: &str) -> Result<Self, &'static str> {
        const NONE: &str = "that is not a number";
        if text.chars().count() > LONGEST {
            return Err(NONE);
        }
        let plain = plain(text);
        if plain.contains(',') {
            return Err("decimals come after a point, thousands are not parted");
        }
        let mut reader = Reader { rest: &plain, unknown: false };
        let value = reader.sum();
        if reader.unknown {
            return Err(UNKNOWN);
        }
        let value = value.ok_or(NONE)?;
        // A hexadecimal number, as programmers write it: 0x10 is not zero times ten.
        if plain.trim_start_matches(['-', '+', ' ']).starts_with("0x") {
            return Err(NONE);
        }
        let number = &plain[..plain.len() - reader.rest.len()];
        let unit = reader.rest.trim();
        if unit == "-" || powers(unit).is_none() {
            return Err(NONE);
        }
        if !value.is_finite() {
            return Err("that is not a finite number");
        }
        Ok(Self { value, unit: unit.to_owned(), typed: typed(number) })
    }

    /// The value in this unit: an angle may be given in degrees.
    ///
    /// # Errors
    /// Which unit it must have.
    pub(crate) fn in_unit(&self, unit: &str) -> Result<f64, String> {
        match Fit::of(unit, &self.unit) {
            Fit::Same => Ok(self.value),
            Fit::Degrees => Ok(self.value / 180.0 * PI),
            Fit::Other => Err(Verdict::Unit(unit.into(), self.unit.clone()).words()),
        }
    }
}

/// How a unit that was typed goes with the one that is asked for.
enum Fit {
    Same,
    /// Degrees, where radians are asked for.
    Degrees,
    Other,
}

impl Fit {
    fn of(asked: &str, typed: &str) -> Self {
        let (Some(unit), Some(mut given)) = (powers(asked), powers(typed)) else {
            return Self::Same;
        };
        if typed.is_empty() || unit == given {
            return Self::Same;
        }
        match given.remove("deg") == Some(1) && unit == given && ANGLES.contains(&asked) {
            true => Self::Degrees,
            false => Self::Other,
        }
    }
}

/// The text with one spelling of everything.
fn plain(text: &str) -> String {
    let mut plain = String::new();
    let mut raised = false;
    for c in text.trim().chars() {
        let digit = "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().position(|d| d == c);
        let upper = match (digit, c) {
            (Some(digit), _) => char::from_digit(digit as u32, 10),
            (None, '⁻') => Some('-'),
            _ => None,
        };
        if let Some(upper) = upper {
            if !raised {
                plain.push('^');
            }
            plain.push(upper);
        } else {
            match c {
                '\u{2212}' | '\u{2013}' => plain.push('-'),
                '·' | '×' | '⋅' => plain.push('*'),
                'π' => plain.push_str(" pi "),
                '√' => plain.push_str(" sqrt "),
                // The ordinal sign and the ring look the same, and some keyboards have those.
                '°' | 'º' | '˚' => plain.push_str(" deg"),
                c if c.is_whitespace() => plain.push(' '),
                c => plain.push(c),
            }
        }
        raised = upper.is_some();
    }
    // One comma, and no point: a decimal comma.
    if plain.matches(',').count() == 1 && !plain.contains('.') && !may_part_thousands(&plain) {
        plain = plain.replace(',', ".");
    }
    plain
}

/// Whether the comma may as well part thousands: in `1,000`, not in `0,125`, `2,5` or `3951,522`.
fn may_part_thousands(text: &str) -> bool {
    let (before, after) = text.split_once(',').unwrap_or((text, ""));
    let is_digit = |c: char| c.is_ascii_digit();
    let whole = &before[before.trim_end_matches(is_digit).len()..];
    let decimals = after.len() - after.trim_start_matches(is_digit).len();
    (1..=3).contains(&whole.len()) && !whole.starts_with('0') && decimals == 3
}

/// Significant digits, and the worth of the last, of a decimal number or one times `10^n`.
fn typed(number: &str) -> Option<(u32, f64)> {
    let tight: String = number.chars().filter(|c| *c != ' ').collect();
    let tight = tight.replace('x', "*").replace("*10^", "e").replace('E', "e");
    let unsigned = tight.trim_start_matches(['-', '+']);
    if number_end(unsigned) != Some(unsigned.len()) {
        return None;
    }
    let (mantissa, exponent) = unsigned.split_once('e').unwrap_or((unsigned, "0"));
    let decimals = mantissa.split_once('.').map_or(0, |(_, d)| d.len() as i32);
    let digits = mantissa.replace('.', "");
    let last = exponent.parse::<i32>().ok()? - decimals;
    Some((digits.trim_start_matches('0').len() as u32, format!("1e{last}").parse().ok()?))
}

/// The powers of the base units in `unit`, radians left out; `None` if it is no unit.
fn powers(unit: &str) -> Option<BTreeMap<String, i32>> {
    let mut powers = BTreeMap::new();
    let mut rest = if unit == "-" { "" } else { unit }.trim();
    let mut inverse = false;
    while !rest.is_empty() {
        if let Some(after) = rest.strip_prefix([' ', '*', '/']) {
            inverse = rest.starts_with('/') || (inverse && rest.starts_with(' '));
            rest = after;
            continue;
        }
        if let Some(after) = rest.strip_prefix('1') {
            rest = after;
            inverse = false;
            continue;
        }
        let end = rest.bytes().take_while(u8::is_ascii_alphabetic).count();
        if end == 0 {
            return None;
        }
        let (name, after) = rest.split_at(end);
        let after_power = after.strip_prefix('^').unwrap_or(after);
        let sign = usize::from(after_power.starts_with('-'));
        let digits = after_power[sign..].bytes().take_while(u8::is_ascii_digit);
        let (power, after_power) = after_power.split_at(sign + digits.count());
        let (power, after) = match power.parse::<i32>() {
            Ok(power) => (power, after_power),
            Err(_) if after_power.len() == after.len() && sign == 0 => (1, after),
            Err(_) => return None,
        };
        let name = match name {
            "degree" | "degrees" => "deg",
            "radian" | "radians" => "rad",
            "sec" | "second" | "seconds" => "s",
            "metre" | "metres" | "meter" | "meters" => "m",
            name => name,
        };
        if name != "rad" {
            let sum: &mut i32 = powers.entry(name.to_owned()).or_default();
            *sum = sum.checked_add(if inverse { power.checked_neg()? } else { power })?;
        }
        inverse = false;
        rest = after;
    }
    powers.retain(|_, power| *power != 0);
    Some(powers)
}

/// Factors by which an answer is often off, with what to say and the units for which it is
/// tried (none: for all), in the order tried.
const USUAL_SLIPS: [(f64, &str, &[&str]); 7] = [
    (-1.0, "the size is right, the sign is not", &[]),
    (2.0, "too large by a factor 2", &[]),
    (0.5, "too small by a factor 2", &[]),
    (2.0 * PI, "too large by 2 pi: turns or radians?", TURNS),
    (0.5 / PI, "too small by 2 pi: turns or radians?", TURNS),
    (180.0 / PI, DEGREES, ANGLES),
    (PI / 180.0, "too small by 180/pi: converted to radians twice?", ANGLES),
];

/// What can be counted in turns or in radians.
const TURNS: &[&str] = &["rad", "rad/s", "1/s", "s"];
/// What can be given in degrees.
const ANGLES: &[&str] = &["rad", "rad/s"];
/// What to say to degrees.
const DEGREES: &str = "that is in degrees; give radians";
/// What to say to an answer `1/v`.
const RECIPROCAL: &str = "that is one over the value";

/// What became of a reader's answer; see [`Claim::verdict`].
#[derive(Debug, Clone, PartialEq)]
pub enum Verdict {
    /// It has the digits that are asked for.
    Right,
    /// All digits given are right, but too few: how many, and how many are asked for.
    AsFarAsItGoes(u32, u32),
    /// Right to so many significant digits, and how many are asked for.
    RightTo(u32, u32),
    /// A recognised wrong answer, with its hint.
    Slip(String),
    /// The unit asked for, and the one given.
    Unit(String, String),
    /// None of these.
    Wrong,
}

impl Verdict {
    /// The verdict in words, without the value.
    pub fn words(&self) -> String {
        match self {
            Self::Right => "right".into(),
            Self::AsFarAsItGoes(given, asked) => {
                let s = if *given == 1 { "" } else { "s" };
                format!("right as far as it goes: {given} digit{s}; give {asked}")
            }
            Self::RightTo(n, asked) => format!("right to {n} digits; give {asked}"),
            Self::Slip(hint) => hint.clone(),
            Self::Unit(asked, given) if asked == "-" => format!("it has no unit, not {given}"),
            Self::Unit(asked, given) => format!("the unit is {asked}, not {given}"),
            Self::Wrong => "not this".into(),
        }
    }
}

/// The significant digits that a relative tolerance asks for: 4 for 0.001, so that what is rounded
/// to them is always within half of it.
pub fn digits_asked(tolerance: f64) -> u32 {
    // A tolerance of 1e-3 has a logarithm a rounding above or below -3.
    ceil(-log10(tolerance) - 1e-9) as u32 + 1
}

/// How far from `value` its rounding to so many significant digits may lie: half of what the last
/// of them is worth. A rounding of doubles is allowed for.
fn half_of_last(value: f64, digits: u32) -> f64 {
    let last = floor(log10(value.abs())) + 1.0 - f64::from(digits);
    0.5 * raised(10.0, last) * (1.0 + 1e-9)
}

/// Judges `answer`; the rules are those of [`Claim::verdict`].
pub(super) fn judge(claim: &Claim, answer: &Answer) -> Verdict {
    let (v, x, unit) = (claim.value, answer.value, claim.unit.as_str());
    match Fit::of(unit, &answer.unit) {
        Fit::Same => {}
        Fit::Degrees => return Verdict::Slip(DEGREES.into()),
        Fit::Other => return Verdict::Unit(unit.into(), answer.unit.clone()),
    }
    let within = |target: f64| {
        let scale = if target == 0.0 { 1.0 } else { target.abs() };
        (x - target).abs() <= (claim.judged_within * scale).max(claim.bound)
    };
    let asked = digits_asked(claim.judged_within);
    let right = match v == 0.0 {
        true => within(v),
        false => (x - v).abs() <= half_of_last(v, asked).max(claim.bound),
    };
    if right {
        return Verdict::Right;
    }
    if let Some(slip) = claim.slips.iter().find(|slip| within(slip.value)) {
        return Verdict::Slip(slip.hint.clone());
    }
    if v == 0.0 {
        return Verdict::Wrong;
    }
    if let Some((given, worth)) = answer.typed
        && given >= 1
        && (x - v).abs() <= 0.5 * worth
    {
        return match given < asked {
            true => Verdict::AsFarAsItGoes(given, asked),
            false => Verdict::RightTo(given, given + 1),
        };
    }
    // The greatest n with 2 |x - v| <= 10^(e+1-n).
    let n = floor(-log10(2.0 * (x - v).abs())) + floor(log10(v.abs())) + 1.0;
    if n >= 2.0 {
        return Verdict::RightTo(n as u32, asked.max(n as u32 + 1));
    }
    let usual = USUAL_SLIPS.iter().find(|(factor, _, units)| {
        within(factor * v) && (units.is_empty() || units.contains(&unit))
    });
    if let Some((_, hint, _)) = usual {
        return Verdict::Slip((*hint).into());
    }
    match within(1.0 / v) {
        true => Verdict::Slip(RECIPROCAL.into()),
        false => Verdict::Wrong,
    }
}
