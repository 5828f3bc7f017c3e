//! Parameters, declared once: the struct, its defaults, the flags, `--help`, what is
//! allowed, and what a page calls them.

use super::number::exactly;
use super::{Table, sections::PARAMETERS};
use crate::error::{Error, Result};
use crate::interval::Interval;

/// Declares the parameters of an example: a struct with named public fields, its
/// [`Default`], and its [`ParameterSet`].
///
/// Each field has its meaning as a doc comment, and is one of the kinds below. Two that stand on many
/// pages say themselves what they are:
/// - `gravity(ALLOWED)`: the acceleration of gravity, usually that of the Earth;
/// - `step(DEFAULT, LARGEST)`: the error of a step of the simulations, from 1e-15.
///
/// The others are
/// - `number(DEFAULT, UNIT, ALLOWED)`: an `f64`; `ALLOWED` is an [`Interval`] by one of the
///   functions of [`interval`](crate::interval);
/// - `optional(UNIT, ALLOWED)`: an `Option<f64>`, `None` unless it is set;
/// - `choice(DEFAULT, OTHERS…)`: one of these words, a `&'static str`;
/// - `effect(USUAL, UNIT, ALLOWED)`: an `Option<f64>`, the strength of an effect, `None` while
///   the effect is left out. On the command line `--with NAME` puts it in with its usual
///   strength, `--with NAME=VALUE` with another, and `--without NAME` leaves it out. One that
///   is in unless it is left out is `.present()`.
///
/// What may follow, in this order:
/// - `.drawn(FROM, TO, STEP)`: a problem sheet may draw the number, among these;
/// - `.shown(VALUE)`: not set, it has this value in the moving picture;
/// - `.open(TITLE)`, `.open(TITLE, LOW, HIGH)`: it is one of the two or three controls that stand
///   open below the moving picture, named by the title, the ends of its slider by what happens there.
///
/// ```
/// use kit::ParameterSet;
/// kit::parameters! {
///     /// A rod that hangs from one end.
///     pub struct Parameters {
///         /// length of the rod
///         length: number(3.0, "m", above(0.0).usually(0.5, 5.0)).drawn(1.0, 4.0, 0.5)
///             .open("length of the rod", "quick", "slow");
///         /// mass, if it matters
///         mass: optional("kg", above(0.0)).shown(2.0);
///         /// how it starts
///         start: choice("rest", "turning");
///         /// friction of the hinge
///         friction: effect(0.02, "N m s", above(0.0));
///         /// weight
///         weight: effect(9.81, "N", above(0.0)).present();
///         gravity: gravity(above(0.0));
///         tolerance: step(1e-13, 1e-3);
///     }
/// }
/// let p = Parameters { length: -3.0, ..Parameters::default() };
/// assert_eq!(p.check().unwrap_err().to_string(), "length = -3 is not allowed: it must be greater than 0");
/// assert_eq!((p.mass, p.start, p.friction, p.weight), (None, "rest", None, Some(9.81)));
/// assert_eq!((p.gravity, p.tolerance), (9.80665, 1e-13));
/// assert_eq!(Parameters::FLAGS[1].name(), "mass");
/// assert_eq!(Parameters::FLAGS[0].grid().map(|grid| grid.typed(1)).as_deref(), Some("1.5"));
/// ```
#[macro_export]
macro_rules! parameters {
    (@type number) => { f64 };
    (@type gravity) => { f64 };
    (@type step) => { f64 };
    (@type optional) => { Option<f64> };
    (@type choice) => { &'static str };
    (@type effect) => { Option<f64> };
    (@default effect @present () $usual:expr, $unit:literal, $allowed:expr) => { Some($usual) };
    (@default effect $usual:expr, $unit:literal, $allowed:expr) => { None };
    (@default gravity $allowed:expr) => { 9.80665 };
    (@default step $default:expr, $largest:literal) => { $default };
    (@default number $default:expr, $unit:literal, $allowed:expr) => { $default };
    (@default optional $unit:literal, $allowed:expr) => { None };
    (@default choice $default:literal $(, $other:literal)*) => { $default };
    (@allowed $allowed:expr) => {{
        #[allow(unused_imports, reason = "most intervals need one of these")]
        use $crate::interval::{above, above_to, any, at_least, between, from_to};
        $allowed
    }};
    (@flag number $name:expr, $meaning:expr; $default:expr, $unit:literal, $allowed:expr) => {
        $crate::Flag::number($name, $unit, $meaning, $crate::parameters!(@allowed $allowed))
    };
    (@flag gravity $name:expr, $meaning:expr; $allowed:expr) => {
        $crate::Flag::number(
            $name, "m/s^2", "acceleration of gravity", $crate::parameters!(@allowed $allowed),
        )
    };
    (@flag step $name:expr, $meaning:expr; $default:expr, $largest:literal) => {
        $crate::Flag::number(
            $name,
            "-",
            concat!("error of a step of the simulations: from 1e-15 to ", stringify!($largest)),
            $crate::interval::from_to(1e-15, $largest),
        )
    };
    (@flag optional $name:expr, $meaning:expr; $unit:literal, $allowed:expr) => {
        $crate::Flag::number($name, $unit, $meaning, $crate::parameters!(@allowed $allowed))
    };
    (@flag effect $name:expr, $meaning:expr; $usual:expr, $unit:literal, $allowed:expr) => {
        $crate::Flag::effect($name, $unit, $meaning, $usual, $crate::parameters!(@allowed $allowed))
    };
    (@flag choice $name:expr, $meaning:expr; $($word:literal),+) => {
        $crate::Flag::choice($name, $meaning, &[$($word),+])
    };
    (@value number $field:expr) => { Some($crate::Value::Number($field)) };
    (@value gravity $field:expr) => { Some($crate::Value::Number($field)) };
    (@value step $field:expr) => { Some($crate::Value::Number($field)) };
    (@value choice $field:expr) => { Some($crate::Value::Word($field)) };
    (@value $optional:ident $field:expr) => { $field.map($crate::Value::Number) };
    (@set number $field:expr, $value:expr) => {
        if let Some($crate::Value::Number(number)) = $value { $field = number; }
    };
    (@set gravity $field:expr, $value:expr) => { $crate::parameters!(@set number $field, $value) };
    (@set step $field:expr, $value:expr) => { $crate::parameters!(@set number $field, $value) };
    (@set choice $field:expr, $value:expr) => {
        if let Some($crate::Value::Word(word)) = $value { $field = word; }
    };
    (@set $optional:ident $field:expr, $value:expr) => {
        match $value {
            Some($crate::Value::Number(number)) => $field = Some(number),
            Some($crate::Value::Word(_)) => {}
            None => $field = None,
        }
    };
    (
        $(#[$about:meta])*
        $visibility:vis struct $set:ident {
            $(
                $(#[doc = $meaning:literal])*
                $field:ident : $kind:ident ( $($setting:tt)* )
                    $( .drawn($from:expr, $to:expr, $step:expr) )? $( .present $present:tt )?
                    $( .shown($shown:expr) )? $( .open($title:literal $(, $low:literal, $high:literal)?) )?;
            )*
        }
    ) => {
        $(#[$about])*
        #[derive(Debug, Clone, PartialEq)]
        #[allow(unreachable_pub, reason = "the fields are public, the set as its page wants it")]
        $visibility struct $set {
            $( $(#[doc = $meaning])* pub $field: $crate::parameters!(@type $kind), )*
        }
        impl Default for $set {
            #[inline(never)] // Many ask for them: one copy.
            fn default() -> Self {
                Self { $( $field: $crate::parameters!(@default $kind $( @present $present )? $($setting)*), )* }
            }
        }
        impl $crate::ParameterSet for $set {
            const FLAGS: &'static [$crate::Flag] = &[
                $( $crate::parameters!(@flag $kind stringify!($field), concat!($($meaning),*); $($setting)*)
                    $( .drawn($from, $to, $step) )? $( .shown($shown) )?
                    $( .open($title, &[$( $low, $high )?]) )?, )*
            ];
        }
        impl $crate::Settings for $set {
            fn flags(&self) -> &'static [$crate::Flag] {
                <Self as $crate::ParameterSet>::FLAGS
            }
            fn value(&self, field: &str) -> Option<$crate::Value> {
                match field {
                    $( stringify!($field) => $crate::parameters!(@value $kind self.$field), )*
                    _ => None,
                }
            }
            fn set(&mut self, field: &str, value: Option<$crate::Value>) {
                match field {
                    $( stringify!($field) => { $crate::parameters!(@set $kind self.$field, value); } )*
                    _ => {}
                }
            }
        }
    };
}

/// What stands before the name of an effect in the section `parameters`.
const PUT_IN: &str = "--with ";

/// The name of a parameter or an effect, from its cell in the section `parameters`.
///
/// ```
/// use kit::name_of_flag;
/// assert_eq!(["--length", "--with friction"].map(name_of_flag), ["length", "friction"]);
/// ```
pub fn name_of_flag(typed: &str) -> &str {
    let effect = typed.strip_prefix(PUT_IN);
    effect.unwrap_or(typed.trim_start_matches("--"))
}

/// The parameters of an example; made by [`parameters!`](crate::parameters).
pub trait ParameterSet: Settings + Default + Clone + 'static {
    /// Every parameter, in the order in which they are listed.
    const FLAGS: &'static [Flag];

    /// Confirms that each parameter that is set may have its value.
    ///
    /// # Errors
    /// [`Error::Parameter`] with the first that may not.
    fn check(&self) -> Result<()> {
        check(self)
    }

    /// The section `parameters` of a report: what is set, with units and meanings.
    ///
    /// # Errors
    /// [`Error::Text`] if a unit or a meaning does not fit in a table.
    fn table(&self) -> Result<Table> {
        table(self)
    }
}

/// The same parameters whatever their type: what is written for them is compiled once.
pub trait Settings {
    /// Every parameter, in the order in which they are listed.
    fn flags(&self) -> &'static [Flag];

    /// What the parameter of this field is set to; `None` for nothing.
    fn value(&self, field: &str) -> Option<Value>;

    /// Sets the parameter of this field, if it can be set to this: an effect that is left out
    /// and a number without a default also to nothing.
    fn set(&mut self, field: &str, value: Option<Value>);
}

/// What a parameter is set to.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Value {
    /// This number.
    Number(f64),
    /// This word of a choice.
    Word(&'static str),
}

pub(super) fn check(parameters: &dyn Settings) -> Result<()> {
    for flag in parameters.flags() {
        if let (Some(Value::Number(value)), Some(allowed)) =
            (parameters.value(flag.field), flag.allowed)
            && !allowed.contains(value)
        {
            return Err(Error::Parameter { name: flag.field, value, allowed });
        }
    }
    Ok(())
}

pub(super) fn table(parameters: &dyn Settings) -> Result<Table> {
    let mut table = Table::headed(PARAMETERS, ["flag", "value", "unit", "meaning"])?;
    for flag in parameters.flags() {
        // What is not set has no place among the numbers of this run; --help lists it.
        let Some(value) = flag.printed(parameters) else {
            continue;
        };
        let name = flag.name();
        let typed = match flag.usual {
            None => format!("--{name}"),
            Some(_) => format!("{PUT_IN}{name}"),
        };
        table.push([typed, value, flag.unit.into(), flag.meaning().into()])?;
    }
    Ok(table)
}

/// A parameter: what it is called, means and may be.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Flag {
    field: &'static str,
    unit: &'static str,
    meaning: &'static str,
    allowed: Option<Interval>,
    usual: Option<f64>,
    words: &'static [&'static str],
    grid: Option<Grid>,
    shown: Option<f64>,
    open: Option<Open>,
}

/// How an open control is named: its title, and what happens at the ends of its slider (two, or none).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Open {
    pub(crate) title: &'static str,
    pub(crate) ends: &'static [&'static str],
}

/// The values among which a problem sheet draws: from one to another in equal steps, typed with
/// the decimals of the step.
///
/// ```
/// use kit::Grid;
/// let grid = Grid { from: -0.1, to: 0.2, step: 0.05 };
/// let all: Vec<String> = (0..grid.count()).map(|n| grid.typed(n)).collect();
/// assert_eq!(all, ["-0.10", "-0.05", "0.00", "0.05", "0.10", "0.15", "0.20"]);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Grid {
    /// The first value.
    pub from: f64,
    /// The last value.
    pub to: f64,
    /// From one value to the next.
    pub step: f64,
}

impl Grid {
    /// How many values there are.
    pub fn count(&self) -> u32 {
        ((self.to - self.from) / self.step + 1.5) as u32
    }

    /// The decimals of the step; 9 if it has more.
    fn decimals(&self) -> usize {
        let whole = |decimals: &usize| {
            let typed = format!("{:.*}", decimals, self.step);
            typed.parse().is_ok_and(|typed: f64| typed == self.step)
        };
        (0..9).find(whole).unwrap_or(9)
    }

    /// The value number `n`, counted from 0, as it is typed.
    pub fn typed(&self, n: u32) -> String {
        let value = self.from + f64::from(n) * self.step;
        let typed = format!("{:.*}", self.decimals(), value);
        match typed.strip_prefix('-') {
            Some(size) if size.bytes().all(|b| b"0.".contains(&b)) => size.to_owned(),
            _ => typed,
        }
    }
}

impl Flag {
    /// A number, in `unit` (`"-"` if it has none).
    pub const fn number(
        field: &'static str,
        unit: &'static str,
        meaning: &'static str,
        allowed: Interval,
    ) -> Self {
        let (allowed, words) = (Some(allowed), &[]);
        Self {
            field,
            unit,
            meaning,
            allowed,
            usual: None,
            words,
            grid: None,
            shown: None,
            open: None,
        }
    }

    /// An effect, of the strength `usual` in `unit` unless another is given.
    pub const fn effect(
        field: &'static str,
        unit: &'static str,
        meaning: &'static str,
        usual: f64,
        allowed: Interval,
    ) -> Self {
        Self { usual: Some(usual), ..Self::number(field, unit, meaning, allowed) }
    }

    /// One of these words.
    pub const fn choice(
        field: &'static str,
        meaning: &'static str,
        words: &'static [&'static str],
    ) -> Self {
        let unit = "-";
        Self {
            field,
            unit,
            meaning,
            allowed: None,
            usual: None,
            words,
            grid: None,
            shown: None,
            open: None,
        }
    }

    /// Lets problem sheets draw this number: `from`, `from + step`, … `to`.
    #[must_use]
    pub const fn drawn(mut self, from: f64, to: f64, step: f64) -> Self {
        self.grid = Some(Grid { from, to, step });
        self
    }

    /// Says what value the moving picture has while this is not set.
    #[must_use]
    pub const fn shown(mut self, value: f64) -> Self {
        self.shown = Some(value);
        self
    }

    /// Lets the control stand open below the moving picture, under this title, the ends of its slider
    /// named by what happens there.
    #[must_use]
    pub const fn open(mut self, title: &'static str, ends: &'static [&'static str]) -> Self {
        self.open = Some(Open { title, ends });
        self
    }

    /// The name: that of the field, without the dashes of the command line.
    pub fn name(&self) -> String {
        self.field.replace('_', "-")
    }

    /// The unit, `"-"` if there is none.
    pub(crate) fn unit(&self) -> &'static str {
        self.unit
    }

    /// What it is, in a few words.
    pub(crate) fn meaning(&self) -> &'static str {
        self.meaning.trim()
    }

    /// What the number may be; `None` for a choice.
    pub fn allowed(&self) -> Option<Interval> {
        self.allowed
    }

    /// The same in words; `None` also where every finite number will do.
    pub(crate) fn allowed_words(&self) -> Option<String> {
        let words = self.allowed?.to_string();
        (words != "it must be finite").then_some(words)
    }

    /// The values that a problem sheet draws; `None` if it leaves the parameter alone.
    pub fn grid(&self) -> Option<Grid> {
        self.grid
    }

    /// The usual strength of an effect; `None` for what is no effect.
    pub(crate) fn usual(&self) -> Option<f64> {
        self.usual
    }

    /// How its open control is named; `None` for one in the fold.
    pub(crate) fn opened(&self) -> Option<Open> {
        self.open
    }

    /// What the moving picture shows of it unless it is set otherwise, as it is typed; `None` for what
    /// has no value there.
    pub(crate) fn on_show(&self, defaults: &dyn Settings) -> Option<String> {
        self.printed(defaults).or_else(|| self.shown.map(exactly))
    }

    /// The words to choose from; none for a number.
    pub fn words(&self) -> &'static [&'static str] {
        self.words
    }

    /// The value as it is typed; `None` if it is not set.
    pub fn printed(&self, parameters: &dyn Settings) -> Option<String> {
        Some(match parameters.value(self.field)? {
            Value::Number(number) => exactly(number),
            Value::Word(word) => word.into(),
        })
    }

    /// Sets the number, or puts the effect in with this strength; a choice stays as it is.
    pub fn set_number(&self, parameters: &mut dyn Settings, value: f64) {
        parameters.set(self.field, Some(Value::Number(value)));
    }

    /// Leaves the effect out; what is no effect stays as it is.
    pub(crate) fn leave_out(&self, parameters: &mut dyn Settings) {
        if self.usual.is_some() {
            parameters.set(self.field, None);
        }
    }

    /// Sets the choice if `word` is among its words.
    pub(crate) fn set_word(&self, parameters: &mut dyn Settings, word: &str) {
        if let Some(word) = self.words.iter().find(|w| **w == word) {
            parameters.set(self.field, Some(Value::Word(word)));
        }
    }
}
