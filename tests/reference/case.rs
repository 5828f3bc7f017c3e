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

/// One sample of a case.
pub struct Sample<'a>(&'a Value);

/// How well a method did on a case.
#[derive(Debug)]
pub struct Outcome {
    /// The largest error in units of `eps (|value| + condition)`.
    pub factor: f64,
    /// The field and time where it was reached.
    pub worst: String,
    /// How many numbers were compared.
    pub compared: usize,
}

/// The files to run, and whether they are the repository's own.
pub fn files() -> (Vec<PathBuf>, bool) {
    match std::env::var_os("REFERENCE_CASES") {
        Some(file) => (vec![PathBuf::from(file)], false),
        None => (own_files(), true),
    }
}

pub fn own_files() -> Vec<PathBuf> {
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data");
    [
        "reference.json",
        "free_body_hard.json",
        "heavy_top_hard.json",
        "ladder_hard.json",
        "pendulum_hard.json",
        "plank_hard.json",
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
            id: case["id"].as_str().expect("an id").to_owned(),
            kind: case["kind"].as_str().expect("a kind").to_owned(),
            json: case.clone(),
        })
        .collect()
}

impl Case {
    /// An input number: the exact double.
    pub fn input(&self, name: &str) -> f64 {
        self.json["inputs"][name]
            .as_f64()
            .unwrap_or_else(|| panic!("{}: input {name}", self.id))
    }

    /// An input vector: exact doubles.
    pub fn input_vector(&self, name: &str) -> [f64; 3] {
        [0, 1, 2].map(|i| {
            self.json["inputs"][name][i]
                .as_f64()
                .unwrap_or_else(|| panic!("{}: input {name}[{i}]", self.id))
        })
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

    /// True if every sample says what errors made on the way do to it.
    pub fn has_path_conditions(&self) -> bool {
        self.samples()
            .all(|sample| sample.0["sens_path"].is_object())
    }

    /// A derived value, if it is a number.
    pub fn derived(&self, name: &str) -> Option<DoubleDouble> {
        self.json["derived"][name].as_str().map(decimal)
    }

    /// theta and its rate at the start of a `top_nd` case, in either of its two forms.
    pub fn start_of_top(&self) -> (f64, f64) {
        let inputs = &self.json["inputs"];
        let Some(start) = inputs["start"].as_str() else {
            return (self.input("theta0"), self.input("dtheta0"));
        };
        let theta = self
            .derived(start)
            .unwrap_or_else(|| panic!("{}: derived {start}", self.id))
            .to_f64();
        // At rest in theta, unless the turning "point" is the pole, which is passed
        // with E~ = theta'^2 / 2.
        let rate = if theta == 0.0 {
            (2.0 * self.input("Etilde")).sqrt()
        } else {
            0.0
        };
        (theta, rate)
    }

    pub fn samples(&self) -> impl Iterator<Item = Sample<'_>> {
        self.json["samples"]
            .as_array()
            .into_iter()
            .flatten()
            .map(Sample)
    }
}

impl Sample<'_> {
    pub fn t(&self) -> f64 {
        self.0["t"].as_f64().expect("a time")
    }

    /// A field that is a plain JSON number, such as the ladder's phase.
    pub fn integer(&self, field: &str) -> Option<i64> {
        self.0[field].as_i64()
    }

    /// A field that is a decimal string.
    pub fn value(&self, field: &str) -> Option<DoubleDouble> {
        self.0[field].as_str().map(decimal)
    }

    /// A field that is a list of decimal strings; empty if it is absent.
    pub fn values(&self, field: &str) -> Vec<DoubleDouble> {
        let list = self.0[field].as_array().into_iter().flatten();
        list.map(|v| decimal(v.as_str().expect("a decimal string")))
            .collect()
    }

    /// A field that is a number or a list of numbers; empty if it is absent.
    pub fn all(&self, field: &str) -> Vec<DoubleDouble> {
        let list = self.values(field);
        if list.is_empty() {
            self.value(field).into_iter().collect()
        } else {
            list
        }
    }

    /// The field's condition, `max(sens_norm, sens_path)`; where the path's has no
    /// entry for the field, that of the attitude stands in, as the schema says.
    pub fn condition(&self, field: &str) -> f64 {
        let norm = self.0["sens_norm"][field].as_f64();
        let path = &self.0["sens_path"];
        let path = path[field].as_f64().or(path["R"].as_f64());
        norm.unwrap_or(0.0).max(path.unwrap_or(0.0))
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
        }
    }

    /// Adds one comparison; `scale` is `|value| + condition`.
    pub fn compare(&mut self, what: &str, got: f64, want: DoubleDouble, scale: f64) {
        let error = (DoubleDouble::from(got) - want).abs().to_f64();
        let factor = if error == 0.0 {
            0.0
        } else {
            error / (EPS * scale)
        };
        self.compared += 1;
        if self.compared == 1 || factor.is_nan() || factor > self.factor {
            self.factor = factor;
            self.worst = what.to_owned();
        }
    }

    /// Adds every component of a field at `t`, against the largest of them and the
    /// field's condition.
    pub fn compare_field(
        &mut self,
        sample: &Sample,
        field: &str,
        t: f64,
        got: &[f64],
        want: &[DoubleDouble],
    ) {
        assert_eq!(want.len(), got.len(), "{field} at {t}");
        let largest = want.iter().fold(0.0_f64, |m, w| m.max(w.to_f64().abs()));
        let scale = largest + sample.condition(field);
        for (i, (got, want)) in got.iter().zip(want).enumerate() {
            self.compare(&format!("{field}[{i}] at {t}"), *got, *want, scale);
        }
    }
}

/// A decimal string as a double-double: all 25 digits count.
pub fn decimal(text: &str) -> DoubleDouble {
    let hi: f64 = text
        .parse()
        .unwrap_or_else(|_| panic!("{text:?} is not a number"));
    let (mantissa, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
    let exponent: i32 = exponent.parse().expect("an exponent");
    let decimals = mantissa.split_once('.').map_or(0, |(_, d)| d.len() as i32);
    let scale = exponent - decimals;
    if hi == 0.0 || !(-250..250).contains(&scale) || exponent < -250 {
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
    let value = if scale < 0 {
        value / power
    } else {
        value * power
    };
    let value = if mantissa.starts_with('-') {
        -value
    } else {
        value
    };
    assert!(
        (value - hi).abs().to_f64() <= 2.0 * EPS * hi.abs(),
        "{text}"
    );
    value
}

#[test]
fn decimals_keep_their_digits() {
    let third = decimal("3.333333333333333333333333e-1");
    assert!((third * 3.0 - 1.0).abs().to_f64() < 2e-24);
    assert_eq!(decimal("-2.5e3").to_f64(), -2500.0);
}
