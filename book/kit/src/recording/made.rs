//! Recordings that are made up, of motions that are known: to try the page with, and to test by.

mod motion;

use super::columns::GRAVITY;
use crate::error::Result;
use core::f64::consts::PI;
use core::fmt::Write;
pub use motion::Motion;
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::frame::BodyVector;
use rotation_dynamics::math::exp;

/// A motion, and the sensor that records it.
#[derive(Debug, Clone, PartialEq)]
pub struct Made {
    /// What the phone does.
    pub motion: Motion,
    /// How the principal axes are turned against the phone's (rotation vector, rad).
    pub turn: [f64; 3],
    /// Samples a second.
    pub frequency: f64,
    /// Standard deviation of the noise of a rate (rad/s); of an acceleration it is ten times as many m/s^2.
    pub noise: f64,
    /// What the gyroscope shows at rest (rad/s).
    pub offset: [f64; 3],
    /// The step in which rates are counted (rad/s); 0 for none.
    pub step: f64,
    /// By how much of a sampling interval times vary, up and down; below 0.5.
    pub jitter: f64,
    /// The time constant of the gyroscope's filter, of first order (s); 0 for none.
    pub filter: f64,
    /// With an accelerometer there, on the principal axes from the centre of mass (m).
    pub accelerometer: Option<[f64; 3]>,
    /// Another number makes other noise.
    pub seed: u64,
}

impl Default for Made {
    /// A phone thrown up once, nearly about its middle axis, at 200 samples a second.
    fn default() -> Self {
        Self {
            motion: Motion::default(),
            turn: [0.0; 3],
            frequency: 200.0,
            noise: 0.02,
            offset: [0.0; 3],
            step: 0.001,
            jitter: 0.1,
            filter: 0.0,
            accelerometer: None,
            seed: 1,
        }
    }
}

/// How a table is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// phyphox, "CSV (comma, decimal point)".
    Phyphox,
    /// phyphox, "CSV (semicolon, decimal comma)".
    PhyphoxSemicolon,
    /// phyphox, "CSV (tabulator, decimal point)".
    PhyphoxTab,
    /// Physics Toolbox: with lines of comment and a total.
    PhysicsToolbox,
    /// Sensor Logger: ns since 1970, columns z, y, x. It has the accelerometer in another file.
    SensorLogger,
    /// A table of MATLAB Mobile, with the time of the day.
    MatlabMobile,
    /// AndroSensor: rates in the middle, times in ms at the end.
    AndroSensor,
    /// Degrees per second and milliseconds.
    Degrees,
    /// Four columns of numbers with spaces between.
    Bare,
}

impl Format {
    /// All of them.
    pub const ALL: [Self; 9] = [
        Self::Phyphox,
        Self::PhyphoxSemicolon,
        Self::PhyphoxTab,
        Self::PhysicsToolbox,
        Self::SensorLogger,
        Self::MatlabMobile,
        Self::AndroSensor,
        Self::Degrees,
        Self::Bare,
    ];
}

/// What the sensors show, on the phone's axes.
#[derive(Debug, Clone, PartialEq)]
pub struct Samples {
    /// s
    pub times: Vec<f64>,
    /// rad/s
    pub rates: Vec<[f64; 3]>,
    /// m/s^2, with gravity
    pub accelerations: Option<Vec<[f64; 3]>>,
}

impl Made {
    /// What the sensors show.
    ///
    /// # Errors
    /// Those of [`FreeBody::new`](rotation_dynamics::exact::free_body::FreeBody::new) and of attitudes.
    pub fn samples(&self) -> Result<Samples> {
        let mut random = Random(self.seed);
        let mut rates = self.motion.rates(&mut random)?;
        let turn = Attitude::from_rotation_vector(self.turn.into())?;
        let phone = |v: [f64; 3]| turn.to_space(BodyVector::from(v)).to_array();
        let count = (self.motion.duration() * self.frequency) as usize;
        let mut shown = Samples { times: Vec::new(), rates: Vec::new(), accelerations: None };
        let mut accelerations = Vec::new();
        let (mut t, mut rate) = (0.0, rates(0.0));
        let mut filtered = rate;
        let mut attitude = Attitude::IDENTITY;
        for k in 0..count {
            let now = (k as f64 + 0.5 + self.jitter * random.between(-1.0, 1.0)) / self.frequency;
            // Rates are nearly straight lines over such a part.
            let part = (now - t) / PARTS as f64;
            let begin = t;
            for n in 1..=PARTS {
                t = begin + part * n as f64;
                let next = rates(t);
                let middle = [0, 1, 2].map(|i| 0.5 * part * (rate[i] + next[i]));
                attitude = attitude.turned_in_body(middle.into())?;
                for i in 0..3 {
                    filtered[i] = self.filtered(filtered[i], [rate[i], next[i]], part);
                }
                rate = next;
            }
            shown.times.push(now);
            let rate_shown = phone(filtered);
            shown.rates.push([0, 1, 2].map(|i| {
                let value = rate_shown[i] + self.offset[i] + self.noise * random.normal();
                if self.step > 0.0 { self.step * (value / self.step).round() } else { value }
            }));
            if let Some(place) = self.accelerometer {
                let held = self.motion.held(t);
                let up = attitude.to_body([0.0, 0.0, GRAVITY].into()).to_array();
                let swing = cross(rate, cross(rate, place));
                // Over an interval that the rates are smooth in.
                let [a, b] = [t - 1e-4, t + 1e-4].map(&mut rates);
                let turned = cross([0, 1, 2].map(|i| (b[i] - a[i]) / 2e-4), place);
                let felt = phone([0, 1, 2].map(|i| held * up[i] + swing[i] + turned[i]));
                accelerations.push(felt.map(|a| a + 10.0 * self.noise * random.normal()));
            }
        }
        shown.accelerations = self.accelerometer.map(|_| accelerations);
        Ok(shown)
    }

    /// y + tau dy/dt = x from y, where x goes straight from one value to another in the time h.
    fn filtered(&self, y: f64, [from, to]: [f64; 2], h: f64) -> f64 {
        if self.filter <= 0.0 {
            return to;
        }
        let lag = (to - from) * self.filter / h;
        to - lag + (y - from + lag) * exp(-h / self.filter)
    }

    /// The table that an app exports.
    ///
    /// # Errors
    /// Those of [`Made::samples`].
    pub fn text(&self, format: Format) -> Result<String> {
        Ok(self.samples()?.text(format))
    }
}

/// Parts of a sampling interval.
const PARTS: usize = 8;

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

impl Samples {
    /// The table that an app exports of these.
    pub fn text(&self, format: Format) -> String {
        let felt = self.accelerations.as_deref();
        let with = |header: &str, more: &str| match felt {
            Some(_) => format!("{header}{more}\n"),
            None => format!("{header}\n"),
        };
        let phyphox = with(
            "\"Time (s)\",\"Gyroscope x (rad/s)\",\"Gyroscope y (rad/s)\",\"Gyroscope z (rad/s)\",\"Absolute (rad/s)\"",
            ",\"Acceleration x (m/s^2)\",\"Acceleration y (m/s^2)\",\"Acceleration z (m/s^2)\"",
        );
        let mut text = match format {
            Format::Phyphox => phyphox,
            Format::PhyphoxSemicolon => phyphox.replace(',', ";"),
            Format::PhyphoxTab => phyphox.replace(',', "\t"),
            Format::PhysicsToolbox => with(
                "# Physics Toolbox\n# Requested Sample Rate: fastest\ntime,wx (rad/s),wy (rad/s),wz (rad/s),wTotal (rad/s)",
                ",gFx,gFy,gFz",
            ),
            Format::SensorLogger => "time,seconds_elapsed,z,y,x\n".into(),
            Format::MatlabMobile => "Timestamp,X,Y,Z\n".into(),
            Format::AndroSensor => with(
                "GYROSCOPE X (rad/s);GYROSCOPE Y (rad/s);GYROSCOPE Z (rad/s)",
                ";ACCELEROMETER X (m/s²);ACCELEROMETER Y (m/s²);ACCELEROMETER Z (m/s²)",
            )
            .replace('\n', ";Time since start in ms\n"),
            Format::Degrees => "time (ms),gx (deg/s),gy (deg/s),gz (deg/s)\n".into(),
            Format::Bare => String::new(),
        };
        for (n, (t, w)) in self.times.iter().zip(&self.rates).enumerate() {
            let [x, y, z] = *w;
            let total = (x * x + y * y + z * z).sqrt();
            let a = felt.map(|felt| felt[n]);
            let row = |numbers: &[f64], between: &str| {
                let cells: Vec<String> = numbers.iter().map(|x| format!("{x:.9E}")).collect();
                cells.join(between)
            };
            let all: Vec<f64> =
                [*t, x, y, z, total].into_iter().chain(a.into_iter().flatten()).collect();
            // Writing to a `String` never fails.
            let _ = match format {
                Format::Phyphox => writeln!(text, "{}", row(&all, ",")),
                Format::PhyphoxSemicolon => writeln!(text, "{}", row(&all, ";").replace('.', ",")),
                Format::PhyphoxTab => writeln!(text, "{}", row(&all, "\t")),
                Format::PhysicsToolbox => {
                    let a = a.map_or(String::new(), |[x, y, z]| {
                        let [x, y, z] = [x, y, z].map(|a| a / GRAVITY);
                        format!(",{x:.5},{y:.5},{z:.5}")
                    });
                    writeln!(text, "{t:.6},{x:.6},{y:.6},{z:.6},{total:.6}{a}")
                }
                Format::SensorLogger => {
                    let since_1970 = 1_764_000_000_000_000_000_i64 + (1e9 * t).round() as i64;
                    writeln!(text, "{since_1970},{t:.9},{z},{y},{x}")
                }
                Format::MatlabMobile => {
                    let (minutes, seconds) = ((t / 60.0).floor(), t % 60.0);
                    writeln!(
                        text,
                        "30-Sep-2024 10:{minutes:02}:{seconds:09.6},{x:.6},{y:.6},{z:.6}"
                    )
                }
                Format::AndroSensor => {
                    let a = a.map_or(String::new(), |a| format!(";{}", row(&a, ";")));
                    writeln!(text, "{x:.6};{y:.6};{z:.6}{a};{:.3}", 1e3 * t)
                }
                Format::Degrees => {
                    let [x, y, z] = [x, y, z].map(|w| w * 180.0 / PI);
                    writeln!(text, "{:.4},{x:.5},{y:.5},{z:.5}", 1e3 * t)
                }
                Format::Bare => writeln!(text, "{t:10.6} {x:12.6} {y:12.6} {z:12.6}"),
            };
        }
        text
    }
}

/// Numbers that look random and are the same in every run. SplitMix64: G. L. Steele, D. Lea, C. H.
/// Flood, OOPSLA 2014.
#[derive(Debug, Clone)]
pub(super) struct Random(u64);

impl Random {
    fn between(&mut self, a: f64, b: f64) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        a + (b - a) * ((z ^ (z >> 31)) >> 11) as f64 * (0.5 * f64::EPSILON)
    }

    /// Nearly normal, of standard deviation 1: the sum of twelve, each of variance 1/12.
    fn normal(&mut self) -> f64 {
        (0..12).map(|_| self.between(-0.5, 0.5)).sum()
    }
}
