//! A thing that swung with a gyroscope on it: which pendulum it was, by its recording.

use kit::draw::{Axis, Curve, Ink, Panel, Sketch, Stack};
use kit::recording::Recording;
use kit::recording::made::{Format, Made, Motion};
use kit::{Asked, Decided, Found, MovingPicture, Recorded, Report, Result, Table, Trajectory};
use kit::{decimals, times};
use rotation_dynamics::fit::{Damping, Estimate, Swing, SwingFit};
use rotation_dynamics::frame::DesignVector;
use rotation_dynamics::math::sincos;
use std::sync::Arc;

/// So many dots are drawn at most, and so many points of a line: more cannot be told apart.
const DOTS: usize = 200;
const POINTS: u32 = 1500;

const fn triple(estimate: Estimate) -> [f64; 3] {
    [estimate.value, estimate.from, estimate.to]
}

/// A piece of a recording, with the pendulum that fits it.
struct Swung {
    times: Vec<f64>,
    swing: Swing,
    fit: SwingFit,
}

impl Swung {
    /// The rates about the hinge over the time since the first sample: samples, and the fit.
    fn rates(&self) -> Result<Panel> {
        let (begin, end) = (self.times[0], self.times[self.times.len() - 1]);
        let fitted = |t: f64| Ok(self.fit.rate((begin + t).min(end))?);
        let line = Curve::sampled(times(0.0, end - begin, POINTS), fitted, Ink::Ink)?;
        let dots = self.drawn().map(|k| (self.times[k] - begin, self.swing.rates()[k]));
        let panel = Panel::over_axes("$t$ / s", Axis::linear(r"$\dot\theta$ / (rad/s)"));
        Ok(panel.curve(Curve::new(dots, Ink::Velocity).dots()).curve(line.thin()))
    }

    fn drawn(&self) -> impl Iterator<Item = usize> + use<> {
        (0..self.times.len()).step_by(self.times.len().div_ceil(DOTS))
    }

    fn figure(&self) -> Result<kit::Figure> {
        let (begin, residuals) = (self.times[0], self.fit.residuals().collect::<Vec<_>>());
        let dots = self.drawn().map(|k| (self.times[k] - begin, -residuals[k]));
        let below = Panel::over_axes("$t$ / s", Axis::linear("sample less fit / (rad/s)"));
        let below = below.level(0.0, Ink::Frame, "");
        let alt = "The rate of a swing about its hinge against time: dots, the samples, on the exact curve of a \
            pendulum. Below, what is left, in rad/s: dots to both sides of zero.";
        let stack = Stack::new("recorded_rates", alt).row_height(140).panel(self.rates()?);
        stack.panel(below.curve(Curve::new(dots, Ink::Velocity).dots())).figure()
    }

    /// The swing once more, by the fit.
    fn picture(self: Arc<Self>) -> Result<MovingPicture> {
        let (begin, last) = (self.times[0], self.times[self.times.len() - 1]);
        let end = last - begin;
        MovingPicture::above(self.rates()?, 0.0..=end, [0.0, end], move |t| {
            let angle = self.fit.angle((begin + t).min(last))?;
            let (s, c) = sincos(angle);
            let alt = format!(
                "The recorded pendulum after {t:.2} s, {angle:.2} rad from the vertical. Below, its rate against time."
            );
            let at = |along: f64, across: f64| (along * s + across * c, -along * c + across * s);
            let phone =
                [(0.86, -0.07), (0.86, 0.07), (1.14, 0.07), (1.14, -0.07)].map(|(a, b)| at(a, b));
            let scene = Sketch::within((-1.25, 1.25), (-1.25, 1.25))
                .guide([(0.0, 0.0), (0.0, -1.2)])
                .pivot((0.0, 0.0), core::f64::consts::FRAC_PI_2)
                .curve(Curve::new([(0.0, 0.0), at(0.86, 0.0)], Ink::Body))
                .body(phone, Ink::Body, 0.4);
            Ok((alt, scene))
        })
    }

    fn found(&self, gravity: f64, compared: &[(&'static str, f64)]) -> Result<Vec<Found>> {
        let fit = &self.fit;
        let mut found = vec![
            Found::number("from", "first sample, as the file counts time", "s", self.times[0], 6),
            Found::number("to", "last sample", "s", self.times[self.times.len() - 1], 6),
            Found::word("samples", "how many are fitted", self.times.len().to_string()),
        ];
        if let Some(hinge) = self.swing.hinge() {
            let axis = hinge
                .axis
                .to_array()
                .map(|part| decimals(if part.abs() < 5e-4 { 0.0 } else { part }, 3))
                .join(", ");
            found.push(Found::word(
                "hinge",
                "its direction on the axes x, y, z of the phone",
                axis,
            ));
            found.push(Found::number(
                "wobble",
                "rate across it over that about it",
                "%",
                100.0 * hinge.wobble,
                2,
            ));
        }
        let length = format!("of the simple pendulum that swings alike, with g = {gravity} m/s^2");
        found.push(Found::estimate("length", length, "m", triple(fit.length(gravity)?)));
        for (key, length) in compared {
            found.push(Found::number(key, "the same of the page's pendulum", "m", *length, 5));
        }
        found.extend([
            Found::estimate("amplitude", "of the first swing", "rad", triple(fit.amplitude())),
            Found::estimate("period", "at that amplitude", "s", triple(fit.period())),
            Found::estimate(
                "small period",
                "of the smallest swings",
                "s",
                triple(fit.small_period()),
            ),
            Found::estimate("offset", "of the sensor", "rad/s", triple(fit.offset())),
            Found::number(
                "misfit",
                "root of the mean square of the residuals",
                "rad/s",
                fit.misfit(),
                2,
            ),
        ]);
        Ok(found)
    }

    fn decided(&self) -> Vec<Decided> {
        let decided = self.fit.decisions().iter().map(|decision| {
            let (name, value, unit) = match decision.damping {
                Damping::Linear => ("damping in proportion to the rate", self.fit.linear(), "1/s"),
                Damping::Quadratic => {
                    ("damping as the square of the rate", self.fit.quadratic(), "1/rad")
                }
            };
            Decided {
                name,
                unit,
                needed: decision.needed,
                improvement: decision.improvement,
                threshold: decision.threshold,
                values: value.into_iter().map(triple).collect(),
            }
        });
        decided.collect()
    }

    fn trajectory(&self) -> Result<Trajectory> {
        let columns = ["t [s]", "rate [rad/s]", "fitted rate [rad/s]", "fitted angle [rad]"];
        let mut samples = Trajectory::new(columns)?;
        for (t, rate) in self.times.iter().zip(self.swing.rates()) {
            samples.push([*t, *rate, self.fit.rate(*t)?, self.fit.angle(*t)?])?;
        }
        Ok(samples)
    }
}

/// What a recording of a swing says, compared with the lengths of other simple pendulums (m).
///
/// # Errors
/// Those of [`Recording::read`] and its parts, and of [`Swing::fit`].
pub fn recorded(
    name: &str,
    bytes: &[u8],
    asked: &Asked,
    gravity: f64,
    compared: &[(&'static str, f64)],
) -> Result<Recorded> {
    let recording = Recording::read(name, bytes)?;
    let rates: Vec<_> = recording.rates().iter().map(|rates| DesignVector::from(*rates)).collect();
    let mut notes = recording.notes().to_vec();
    let samples = if asked.from.is_some() || asked.to.is_some() {
        recording.between(asked.from, asked.to)?
    } else {
        let found = Swing::find(recording.times(), &rates)?;
        notes.push(format!("Fitted is what swings: {found}."));
        found.samples
    };
    let times = recording.times()[samples.clone()].to_vec();
    let swing = Swing::of_sensor(times.clone(), rates[samples].to_vec())?;
    let swung = Arc::new(Swung { fit: swing.fit()?, swing, times });
    let (found, decided) = (swung.found(gravity, compared)?, swung.decided());
    let mut report = Report::new("Your own recording", "a pendulum fitted to a swing")?;
    report.add(Table::of("recording", ["the file"], &notes, |note| Ok([note.clone()]))?)?;
    report.add(Found::table(&found)?)?;
    report.add(Decided::table(&decided)?)?;
    Ok(Recorded {
        report,
        found,
        decided,
        figures: vec![swung.figure()?],
        trajectory: swung.trajectory()?,
        pictures: vec![("recorded_swing", Arc::clone(&swung).picture()?)],
        captions: vec![
            (
                "recorded_rates",
                "The rate about the hinge that was recorded (dots) and that of the pendulum that \
                fits it best (line); below, what the fit leaves.",
            ),
            ("recorded_swing", "The swing once more, by the fit."),
        ],
    })
}

/// A phone on a rod that swings for half a minute, as phyphox exports it; nothing if it cannot be made.
pub fn made() -> String {
    let (length, gravity, amplitude) = (0.94, 9.806_65, 0.8);
    let (linear, quadratic, duration) = (0.03, 0.0, 30.0);
    let motion = Motion::Swing { length, gravity, amplitude, linear, quadratic, duration };
    let made = Made { motion, frequency: 100.0, ..Made::default() };
    made.text(Format::Phyphox).unwrap_or_default()
}
