//! Cases of schema `rigid-oracle/1`: reading and comparing.

use rotation_dynamics::math::DoubleDouble;
use serde_json::Value;
use std::path::{Path, PathBuf};

pub use rotation_dynamics::math::EPS;

/// One case of a reference file.
pub struct Case {
    pub id: String,
    pub kind: String,
    json: Value,
}

/// One sample of a case, which has a time.
pub struct Sample<'a>(&'a Value, f64);

/// Why a case gives no outcome.
#[derive(Debug)]
pub enum Trouble {
    /// The case does not hold what the method needs.
    Lacks(String),
    /// The library refuses it.
    Refused(rotation_dynamics::Error),
}

impl From<rotation_dynamics::Error> for Trouble {
    fn from(error: rotation_dynamics::Error) -> Self {
        Self::Refused(error)
    }
}

pub type Result<T> = core::result::Result<T, Trouble>;

/// Why a case was not run: what it lacks.
pub fn print_not_run(case: &Case, method: &str, answer: &Result<Outcome>) {
    let why = match answer {
        Ok(outcome) => format!("nothing to compare{}", outcome.left_out()),
        Err(Trouble::Lacks(what)) => what.clone(),
        Err(Trouble::Refused(error)) => error.to_string(),
    };
    println!("{:<28} {method:<16} not run: {why}", case.id);
}

/// How well a method did on a case.
#[derive(Debug)]
pub struct Outcome {
    /// The largest error in units of `eps (|value| + condition)`.
    pub factor: f64,
    /// The field and time where it was reached.
    pub worst: String,
    /// How many numbers were compared.
    pub compared: usize,
    /// How many values have no condition and were not compared.
    pub unjudged: usize,
    /// How many samples lie further than the method promises for.
    pub too_far: usize,
}

/// The files to run, and whether they are the repository's own.
pub fn files() -> (Vec<PathBuf>, bool) {
    match std::env::var_os("REFERENCE_CASES") {
        // The test runs in its package's directory, the reader in the one above.
        Some(file) => {
            let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
            (vec![root.join(file)], false)
        }
        None => (own_files(), true),
    }
}

pub fn own_files() -> Vec<PathBuf> {
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("data");
    [
        "reference.json",
        "free_body_hard.json",
        "heavy_top_hard.json",
        "ladder_hard.json",
        "pendulum_hard.json",
        "plank_hard.json",
        "drawn.json",
    ]
    .map(|file| data.join(file))
    .to_vec()
}

pub fn read(file: &Path) -> Vec<Case> {
    let text =
        std::fs::read_to_string(file).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
    let json: Value =
        serde_json::from_str(&text).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
    assert_eq!(json["schema"], "rigid-oracle/1", "{}", file.display());
    let cases = json["cases"].as_array().expect("a list of cases");
    assert!(!cases.is_empty(), "{} holds no case", file.display());
    cases
        .iter()
        .map(|case| Case {
            id: case["id"].as_str().unwrap_or("(no id)").to_owned(),
            kind: case["kind"].as_str().unwrap_or("(no kind)").to_owned(),
            json: case.clone(),
        })
        .collect()
}

impl Case {
    /// The case without this field, in itself and in its samples.
    pub fn without(&self, field: &str) -> Self {
        self.changed(|object| {
            object.remove(field);
        })
    }

    /// The case with this text for every theta.
    pub fn with_theta(&self, text: &str) -> Self {
        self.changed(|object| {
            if let Some(theta) = object.get_mut("theta") {
                *theta = Value::from(text);
            }
        })
    }

    fn changed(&self, change: impl Fn(&mut serde_json::Map<String, Value>)) -> Self {
        let mut json = self.json.clone();
        json.as_object_mut().into_iter().for_each(&change);
        let samples = json["samples"].as_array_mut().into_iter().flatten();
        samples.filter_map(Value::as_object_mut).for_each(&change);
        Self { id: self.id.clone(), kind: self.kind.clone(), json }
    }

    /// An input number: the exact double.
    pub fn input(&self, name: &str) -> Result<f64> {
        let number = self.json["inputs"][name].as_f64();
        number.ok_or_else(|| Trouble::Lacks(format!("no input {name}")))
    }

    /// An input vector: exact doubles.
    pub fn input_vector(&self, name: &str) -> Result<[f64; 3]> {
        let list = &self.json["inputs"][name];
        match [0, 1, 2].map(|i| list[i].as_f64()) {
            [Some(a), Some(b), Some(c)] => Ok([a, b, c]),
            _ => Err(Trouble::Lacks(format!("no three numbers in input {name}"))),
        }
    }

    /// An input number, if the case has it.
    pub fn optional(&self, name: &str) -> Option<f64> {
        self.json["inputs"][name].as_f64()
    }

    /// An input word, if the case has it.
    pub fn word(&self, name: &str) -> Option<&str> {
        self.json["inputs"][name].as_str()
    }

    /// A derived word, if the case has it.
    pub fn derived_word(&self, name: &str) -> Option<&str> {
        self.json["derived"][name].as_str()
    }

    /// What happens on the way: the derived events, each with its time and its name.
    pub fn events(&self) -> Option<Vec<(DoubleDouble, &str)>> {
        let list = self.json["derived"]["events"].as_array()?;
        let time = |event: &Value| event["t"].as_str().map_or(NAN, decimal);
        let events = list.iter();
        let named = events.map(|e| (time(e), e["event"].as_str().unwrap_or("(no name)")));
        Some(named.collect())
    }

    /// True if every sample says what errors made on the way do to it.
    pub fn has_path_conditions(&self) -> bool {
        self.samples().all(|sample| sample.0["sens_path"].is_object())
    }

    /// Whether an eps of what is given moves some field by a tenth of itself, or an angle by a
    /// tenth of a radian: nothing is lost if such a case is refused.
    pub fn is_meaningless(&self) -> bool {
        let leaves_nothing = |sample: &Sample, field: &str| {
            let largest = sample.all(field).iter().fold(0.0_f64, |m, v| m.max(v.to_f64().abs()));
            let size = match field {
                "theta" | "phi" | "zeta" => largest.min(1.0),
                _ => largest,
            };
            let sharp = sample.sharp_condition(field);
            let condition = sharp.or(sample.condition(field)).unwrap_or(0.0);
            EPS * condition >= 0.1 * size
        };
        self.samples().any(|sample| {
            let fields = sample.0["sens_norm"].as_object().into_iter().flatten();
            let mut names = fields.map(|(name, _)| name);
            names.any(|name| leaves_nothing(&sample, name))
        })
    }

    /// A derived value, if it is a number.
    pub fn derived(&self, name: &str) -> Option<DoubleDouble> {
        self.json["derived"][name].as_str().map(decimal)
    }

    /// theta and its rate at the start of a `top_nd` case, in either of its two forms.
    pub fn start_of_top(&self) -> Result<(f64, f64)> {
        let inputs = &self.json["inputs"];
        let Some(start) = inputs["start"].as_str() else {
            return Ok((self.input("theta0")?, self.input("dtheta0")?));
        };
        let theta = self.derived(start);
        let theta = theta.ok_or_else(|| Trouble::Lacks(format!("no derived {start}")))?;
        let theta = theta.to_f64();
        // At rest in theta, unless the turning "point" is the pole, which is passed
        // with E~ = theta'^2 / 2.
        let rate = if theta == 0.0 { (2.0 * self.input("Etilde")?).sqrt() } else { 0.0 };
        Ok((theta, rate))
    }

    /// The samples; one without a time says nothing and is passed over.
    pub fn samples(&self) -> impl Iterator<Item = Sample<'_>> {
        self.json["samples"]
            .as_array()
            .into_iter()
            .flatten()
            .filter_map(|sample| Some(Sample(sample, sample["t"].as_f64()?)))
    }
}

impl Sample<'_> {
    pub fn t(&self) -> f64 {
        self.1
    }

    /// A field that is a plain JSON number, such as the ladder's phase.
    pub fn integer(&self, field: &str) -> Option<i64> {
        self.0[field].as_i64()
    }

    /// A field that is a word, such as what holds the plank.
    pub fn word(&self, field: &str) -> Option<&str> {
        self.0[field].as_str()
    }

    /// A field that is a decimal string.
    pub fn value(&self, field: &str) -> Option<DoubleDouble> {
        self.0[field].as_str().map(decimal)
    }

    /// A field that is a list of decimal strings; empty if it is absent.
    ///
    /// An entry that is no such string is NaN, which no method comes near.
    pub fn values(&self, field: &str) -> Vec<DoubleDouble> {
        let list = self.0[field].as_array().into_iter().flatten();
        list.map(|v| v.as_str().map_or(NAN, decimal)).collect()
    }

    /// A field that is a number or a list of numbers; empty if it is absent.
    pub fn all(&self, field: &str) -> Vec<DoubleDouble> {
        let list = self.values(field);
        if list.is_empty() { self.value(field).into_iter().collect() } else { list }
    }

    /// The field's condition, `max(sens_norm, sens_path)`; where the path's has no
    /// entry for the field, that of the attitude stands in, as the schema says; none
    /// if the sample has neither: then nobody can say what error is allowed.
    pub fn condition(&self, field: &str) -> Option<f64> {
        let norm = self.0["sens_norm"][field].as_f64();
        let path = &self.0["sens_path"];
        let path = path[field].as_f64().or(path["R"].as_f64());
        match (norm, path) {
            (Some(norm), Some(path)) => Some(norm.max(path)),
            (one, other) => one.or(other),
        }
    }

    /// The field's sharper condition, `sens`: relative changes of the inputs only.
    pub fn sharp_condition(&self, field: &str) -> Option<f64> {
        self.0["sens"][field].as_f64()
    }
}

impl Outcome {
    pub fn new() -> Self {
        Self {
            factor: 0.0,
            worst: "nothing compared".to_owned(),
            compared: 0,
            unjudged: 0,
            too_far: 0,
        }
    }

    /// Prints the line of the case: the factor reached, and what it is held to.
    pub fn print(&self, case: &Case, method: &str, allowed: f64) {
        let Self { factor, worst, compared, .. } = self;
        println!(
            "{:<28} {method:<16} K = {factor:>6.2} of {allowed} ({worst}, {compared} values{})",
            case.id,
            self.left_out()
        );
    }

    /// What was not compared, and why.
    fn left_out(&self) -> String {
        let mut text = String::new();
        for (count, what) in
            [(self.unjudged, "values without a condition"), (self.too_far, "samples too far")]
        {
            if count > 0 {
                text += &format!(", {count} {what}");
            }
        }
        text
    }

    /// Whether something was compared and the factor is a number within the bound.
    pub fn within(&self, bound: f64) -> bool {
        self.compared > 0 && self.factor <= bound
    }

    /// Adds one comparison; `scale` is `|value| + condition`.
    pub fn compare(&mut self, what: &str, got: f64, want: DoubleDouble, scale: f64) {
        let error = (DoubleDouble::from(got) - want).abs().to_f64();
        let factor = if error == 0.0 { 0.0 } else { error / (EPS * scale) };
        self.compared += 1;
        if self.compared == 1 || factor.is_nan() || factor > self.factor {
            self.factor = factor;
            self.worst = what.to_owned();
        }
    }

    /// Adds a field of the sample, if it has it: every component against the largest
    /// of them and the field's condition.
    pub fn compare_field(&mut self, sample: &Sample, field: &str, got: &[f64]) {
        self.compare_at(sample, field, got, sample.condition(field));
    }

    /// The same against the sharper condition where it is given: it asks for more.
    pub fn compare_sharply(&mut self, sample: &Sample, field: &str, got: f64) {
        let sharp = sample.sharp_condition(field);
        self.compare_at(sample, field, &[got], sharp.or(sample.condition(field)));
    }

    fn compare_at(&mut self, sample: &Sample, field: &str, got: &[f64], condition: Option<f64>) {
        let want = sample.all(field);
        let Some(condition) = condition else {
            self.unjudged += want.len();
            return;
        };
        let largest = want.iter().fold(0.0_f64, |m, w| m.max(w.to_f64().abs()));
        for (i, want_i) in want.iter().enumerate() {
            // A field of another length is one that no method comes near.
            let fits = got.len() == want.len();
            let got = if fits { got[i] } else { f64::NAN };
            let what = format!("{field}[{i}] at {}", sample.t());
            self.compare(&what, got, *want_i, largest + condition);
        }
    }
}

const NAN: DoubleDouble = DoubleDouble::from_parts(f64::NAN, 0.0);

/// A decimal string as a double-double: all 25 digits count. NaN if it is none.
pub fn decimal(text: &str) -> DoubleDouble {
    let (mantissa, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
    let (Ok(hi), Ok(exponent)) = (text.parse::<f64>(), exponent.parse::<i32>()) else {
        return NAN;
    };
    let decimals = mantissa.split_once('.').map_or(0, |(_, d)| d.len() as i32);
    let scale = exponent - decimals;
    if hi == 0.0 || !hi.is_finite() || !(-250..250).contains(&scale) || exponent < -250 {
        return DoubleDouble::from(hi);
    }
    let mut value = DoubleDouble::ZERO;
    for digit in mantissa.bytes().filter(u8::is_ascii_digit) {
        value = value * 10.0 + f64::from(digit - b'0');
    }
    let mut power = DoubleDouble::ONE;
    for _ in 0..scale.abs() {
        power = power * 10.0;
    }
    let value = if scale < 0 { value / power } else { value * power };
    let value = if mantissa.starts_with('-') { -value } else { value };
    assert!((value - hi).abs().to_f64() <= 2.0 * EPS * hi.abs(), "{text}");
    value
}

#[test]
fn decimals_keep_their_digits() {
    let third = decimal("3.333333333333333333333333e-1");
    assert!((third * 3.0 - 1.0).abs().to_f64() < 2e-24);
    assert_eq!(decimal("-2.5e3").to_f64(), -2500.0);
    for text in ["", "asleep", "1e", "1e5.5", "NaN"] {
        assert!(decimal(text).to_f64().is_nan(), "{text}");
    }
}
