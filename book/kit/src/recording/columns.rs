//! What the columns of a table hold, by the names and units in its header.
//!
//! What apps write: phyphox `"Gyroscope x (rad/s)"`; Physics Toolbox `wx`, `ωₓ (rad/s)`, `gFx`; Sensor
//! Logger `time,seconds_elapsed,z,y,x`, with the sensor's name in that of the file; AndroSensor
//! `GYROSCOPE X (rad/s)`, `Time since start in ms`; MATLAB Mobile `Timestamp,X,Y,Z`.

use core::f64::consts::{PI, TAU};

/// Standard gravity (m/s^2), in which apps count accelerations "in g".
pub(super) const GRAVITY: f64 = 9.80665;

/// What an error says of a header.
pub(super) const EXPECTED: &str = "expected a time and three rates, such as \"Time (s)\", \
    \"Gyroscope x (rad/s)\", \"Gyroscope y (rad/s)\", \"Gyroscope z (rad/s)\"";

#[derive(Debug, Clone, Copy, PartialEq)]
enum Quantity {
    Time,
    Rate,
    /// `gx`, `gy`, `gz`: the gyroscope of many tables.
    Letter,
    Uncalibrated,
    /// With gravity, as the sensor measures it.
    Acceleration,
    /// Less what the phone takes for gravity.
    LinearAcceleration,
    /// `x`, `y` or `z` alone.
    Bare,
}

/// What one cell of a header says.
#[derive(Debug, Clone)]
struct Column {
    quantity: Quantity,
    axis: Option<usize>,
    /// The unit in SI; `None` if the header does not say.
    unit: Option<f64>,
}

/// Where a sensor's numbers are.
#[derive(Debug, Clone)]
pub(super) struct Sensor {
    pub(super) time: usize,
    /// The unit of time in s, if the header says.
    pub(super) time_unit: Option<f64>,
    pub(super) axes: [usize; 3],
    /// The unit of the values in SI, if the header says.
    pub(super) unit: Option<f64>,
}

/// Where a table has what.
#[derive(Debug, Clone)]
pub(super) struct Layout {
    pub(super) rates: Sensor,
    pub(super) acceleration: Option<Sensor>,
    /// Whether there are uncalibrated rates as well.
    pub(super) uncalibrated: bool,
    pub(super) app: &'static str,
}

/// Four columns without a header.
pub(super) fn bare() -> Layout {
    let rates = Sensor { time: 0, time_unit: None, axes: [1, 2, 3], unit: None };
    Layout { rates, acceleration: None, uncalibrated: false, app: "a table without a header" }
}

/// The layout of a table with this header, in a file of this name; else what is missing.
pub(super) fn layout(header: &[String], file: &str) -> Result<Layout, String> {
    let columns = header.iter().map(|cell| column(cell)).collect::<Result<Vec<_>, _>>()?;
    let lacks = |what: &str| {
        let header: String = header.join(" | ").chars().take(200).collect();
        format!("the header has no column for {what}: {header}; {EXPECTED}")
    };
    let kinds = [Quantity::Rate, Quantity::Letter, Quantity::Uncalibrated, Quantity::Bare];
    let some = |kind: &Quantity| three(&columns, *kind).iter().any(Option::is_some);
    let kind = kinds.into_iter().find(some).unwrap_or(Quantity::Bare);
    let axes = three(&columns, kind);
    if kind == Quantity::Bare {
        let file = file.rsplit(['/', '\\']).next().unwrap_or(file).to_lowercase();
        let others = ["acc", "magn", "grav", "orient"].iter().any(|word| file.contains(word));
        let others = others && !file.contains("gyr");
        if others && axes.iter().all(Option::is_some) {
            return Err(
                "by the file's name its columns x, y, z are not the rates of a gyroscope: \
                        choose the file of the gyroscope (\"Gyroscope.csv\")"
                    .into(),
            );
        }
    }
    let [Some(x), Some(y), Some(z)] = axes else {
        let missing = ["x", "y", "z"].into_iter().zip(axes).filter(|(_, found)| found.is_none());
        let missing: Vec<&str> = missing.map(|(name, _)| name).collect();
        return Err(lacks(&format!("the rate about {}", missing.join(", "))));
    };
    let sensor = |axes: [usize; 3]| {
        let time = time(&columns, axes[0].min(axes[1]).min(axes[2]))?;
        let unit = columns[axes[0]].as_ref().and_then(|column| column.unit);
        let time_unit = columns[time].as_ref().and_then(|column| column.unit);
        Some(Sensor { time, time_unit, axes, unit })
    };
    let Some(rates) = sensor([x, y, z]) else {
        return Err(lacks("the time"));
    };
    let mut accelerations = [Quantity::Acceleration, Quantity::LinearAcceleration].into_iter();
    let acceleration = accelerations.find_map(|quantity| match three(&columns, quantity) {
        [Some(x), Some(y), Some(z)] => sensor([x, y, z]),
        _ => None,
    });
    let uncalibrated = kind != Quantity::Uncalibrated && some(&Quantity::Uncalibrated);
    let app = app(header, kind == Quantity::Bare);
    Ok(Layout { rates, acceleration, uncalibrated, app })
}

/// The first column for each axis; where no name has an axis, the first three in order.
fn three(columns: &[Option<Column>], quantity: Quantity) -> [Option<usize>; 3] {
    let of = |n: &usize| columns[*n].as_ref().is_some_and(|column| column.quantity == quantity);
    let places: Vec<usize> = (0..columns.len()).filter(of).collect();
    let axis = |n: usize| columns[n].as_ref().and_then(|column| column.axis);
    if places.len() >= 3 && places.iter().all(|n| axis(*n).is_none()) {
        return [0, 1, 2].map(|k| Some(places[k]));
    }
    [0, 1, 2].map(|k| places.iter().copied().find(|n| axis(*n) == Some(k)))
}

/// The nearest time to the left of a sensor's columns, else the first; one with a unit rather.
fn time(columns: &[Option<Column>], first: usize) -> Option<usize> {
    let places = |stated: bool| -> Vec<usize> {
        let is = |column: &Column| {
            column.quantity == Quantity::Time && (column.unit.is_some() || !stated)
        };
        (0..columns.len()).filter(|n| columns[*n].as_ref().is_some_and(is)).collect()
    };
    let found = [places(true), places(false)].into_iter().find(|places| !places.is_empty())?;
    Some(found.iter().copied().rfind(|n| *n < first).unwrap_or(found[0]))
}

/// What a cell says; `None` if it is something else.
fn column(cell: &str) -> Result<Option<Column>, String> {
    let plain: String = cell.trim().to_lowercase().chars().map(latin).collect();
    let (name, unit) = named(&plain);
    let compact: String = name.chars().filter(|c| c.is_alphanumeric()).collect();
    let axis = axis(&name, &compact);
    let acceleration = match compact.contains("linear") || compact.contains("withoutg") {
        true => Quantity::LinearAcceleration,
        false => Quantity::Acceleration,
    };
    let about = |words: &[&str]| words.iter().any(|word| compact.contains(word));
    let single = |letters: &str| {
        axis.is_some() && compact.len() == letters.len() + 1 && compact.starts_with(letters)
    };
    let rate = match about(&["uncal"]) {
        true => Quantity::Uncalibrated,
        false => Quantity::Rate,
    };
    let (quantity, unit) = match unit.as_deref().map(|unit| (measure(unit), unit)) {
        _ if compact.starts_with("grav") || about(&["accuracy", "magnet"]) => return Ok(None),
        // Gravity.
        Some((Some((Quantity::Acceleration, _)), _)) if single("g") => return Ok(None),
        Some((Some((Quantity::Acceleration, unit)), _)) => (acceleration, Some(unit)),
        Some((Some((Quantity::Rate, unit)), _)) => (rate, Some(unit)),
        Some((Some((quantity, unit)), _)) => (quantity, Some(unit)),
        _ if single("gf") => (acceleration, Some(GRAVITY)),
        Some((None, unit)) if axis.is_some() && about(&["gyr", "angularv", "rotationrate"]) => {
            return Err(format!(
                "the unit ({unit}) of {cell:?} is not known: expected (rad/s), (mrad/s), (deg/s), (rev/s) or (rpm)"
            ));
        }
        _ if about(&["gyr", "angularv", "rotationrate", "omega"]) || single("w") => (rate, None),
        None if single("g") => (Quantity::Letter, None),
        None if measure(&compact).is_some_and(|(quantity, _)| quantity == Quantity::Time) => {
            (Quantity::Time, measure(&compact).map(|(_, unit)| unit))
        }
        _ if about(&["accel"]) || single("acc") || single("a") => (acceleration, None),
        _ if compact.starts_with("seconds") => (Quantity::Time, Some(1.0)),
        _ if about(&["time", "elapsed", "zeit"]) || compact == "t" => (Quantity::Time, None),
        None if single("") || (axis.is_some() && about(&["axis"])) => (Quantity::Bare, None),
        _ => return Ok(None),
    };
    // A total of three axes has a unit, too.
    let counts =
        quantity == Quantity::Time || axis.is_some() || !about(&["abs", "tot", "mag", "norm"]);
    Ok(counts.then_some(Column { quantity, axis, unit }))
}

/// Letters of headers in Latin ones.
fn latin(c: char) -> char {
    match c {
        'ₓ' => 'x',
        'ᵧ' => 'y',
        'ω' => 'w',
        'µ' | 'μ' => 'u',
        '²' => '2',
        'º' | '˚' => '°',
        c => c,
    }
}

/// The name and the unit: in brackets, or the last word if it is one.
fn named(plain: &str) -> (String, Option<String>) {
    if let Some((name, rest)) = plain.rsplit_once(['(', '[']) {
        let (unit, after) = rest.split_once([')', ']']).unwrap_or((rest, ""));
        return (format!("{name} {after}"), Some(unit.into()));
    }
    match plain.rsplit_once([' ', '_', ',']) {
        Some((name, word)) if measure(word).is_some() => (name.into(), Some(word.into())),
        _ => (plain.into(), None),
    }
}

/// Units: what is measured, how they are written, and what they are in SI.
const UNITS: [(Quantity, &[&str], f64); 11] = [
    (Quantity::Time, &["s", "sec", "secs", "second", "seconds"], 1.0),
    (Quantity::Time, &["ms", "msec", "millis", "milliseconds"], 1e-3),
    (Quantity::Time, &["us", "usec", "micros", "microseconds"], 1e-6),
    (Quantity::Time, &["ns", "nsec", "nanos", "nanoseconds"], 1e-9),
    (Quantity::Rate, &["rad/s", "rads/s", "radian/s", "radians/s"], 1.0),
    (Quantity::Rate, &["mrad/s"], 1e-3),
    (Quantity::Rate, &["deg/s", "degrees/s", "degree/s", "°/s", "dps"], DEGREE),
    (Quantity::Rate, &["rev/s", "rps", "turns/s"], TAU),
    (Quantity::Rate, &["rpm", "rev/min", "1/min"], TAU / 60.0),
    (Quantity::Acceleration, &["m/s2", "m/s/s", "ms-2"], 1.0),
    (Quantity::Acceleration, &["g", "gs", "g-force"], GRAVITY),
];

/// A degree per second (rad/s).
const DEGREE: f64 = PI / 180.0;

/// What is measured in this unit, and the unit in SI.
fn measure(unit: &str) -> Option<(Quantity, f64)> {
    let unit: String = unit.chars().filter(|c| !matches!(c, ' ' | '^' | '*' | '·' | '⋅')).collect();
    let ends = ["persecond", "second", "sec", "s-1", "ps"];
    let mut unit = unit.replace("/sec2", "/s2");
    if let Some(angle) = ends.into_iter().find_map(|end| unit.strip_suffix(end)) {
        let angle = angle.trim_end_matches('/');
        if ["rad", "deg", "°", "rev"].iter().any(|known| angle.contains(known)) {
            unit = format!("{angle}/s");
        }
    }
    let known = UNITS.iter().find(|(_, names, _)| names.contains(&unit.as_str()));
    known.map(|(quantity, _, unit)| (*quantity, *unit))
}

/// Whether a cell is a unit of time or of a rate.
pub(super) fn is_unit(cell: &str) -> bool {
    let plain: String = cell.trim().to_lowercase().chars().map(latin).collect();
    plain.len() > 1 && measure(plain.trim_matches(['(', ')', '[', ']'])).is_some()
}

/// The first name of a unit of rates.
pub(super) fn said(unit: f64) -> &'static str {
    let is = |(quantity, _, own): &&(Quantity, _, f64)| *quantity == Quantity::Rate && *own == unit;
    UNITS.iter().find(is).map_or("another unit", |(_, names, _)| names[0])
}

/// The axis of a name: a word `x`, `y` or `z`, else the last letter of it all.
fn axis(name: &str, compact: &str) -> Option<usize> {
    let place = |word: &str| ["x", "y", "z"].iter().position(|axis| *axis == word);
    let words = name.split(|c: char| !c.is_alphanumeric());
    let last = compact.char_indices().last().map_or("", |(at, _)| &compact[at..]);
    // "velocity", "accuracy".
    let spoken = compact.ends_with("ty") || compact.ends_with("cy");
    words.into_iter().find_map(place).or_else(|| place(last).filter(|_| !spoken))
}

fn app(header: &[String], bare: bool) -> &'static str {
    let has = |word: &str| header.iter().any(|cell| cell.trim().starts_with(word));
    match () {
        () if has("seconds_elapsed") => "a table of Sensor Logger",
        () if has("Gyroscope x (") => "a table of phyphox",
        () if has("GYROSCOPE X (") => "a table of AndroSensor",
        () if header[0] == "time" && (has("wx") || has("ω")) => "a table of Physics Toolbox",
        () if bare && has("Timestamp") => "a table of MATLAB Mobile",
        () => "a table",
    }
}
