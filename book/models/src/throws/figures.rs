//! The drawings of a throw: the rates with what is left of them, and the polhode.

use super::{AXES, Thrown};
use core::f64::consts::PI;
use kit::draw::{Axis, Curve, Ink, Panel, Side, Solid, Stack, View};
use kit::{Figure, MovingPicture, Result, times};
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::math::{cos, sin};

/// So many dots of a curve are drawn at most, and so many on the ellipsoid: more hide the curve.
const DOTS: usize = 70;
const SPOTS: usize = 36;

/// In so many parts the whole recording is drawn at most: as many as there are px.
pub(super) const COURSE: usize = 300;

impl Thrown {
    /// The whole recording, and what of it is flight.
    pub(super) fn file_figure(&self) -> Result<Figure> {
        let top = self.course.iter().map(|(_, size)| *size).fold(0.0, f64::max);
        let spans = self.flights.iter().map(|(span, _)| *span);
        let chosen = [self.times[0], self.times[self.times.len() - 1]];
        let spans: Vec<[f64; 2]> = match self.number {
            Some(_) => spans.collect(),
            None => vec![chosen],
        };
        let shaded = match (self.number, spans.len()) {
            (None, _) => "the piece shaded that is fitted".to_owned(),
            (_, 1) => "one piece shaded, a free flight between handling and catch".to_owned(),
            (_, n) => format!("{n} pieces shaded, each a free flight between handling and catch"),
        };
        let alt = format!(
            "The size of the angular velocity against time over the whole recording, with {shaded}."
        );
        let size = Axis::linear(r"$|\omega|$ / (rad/s)").range(0.0, 1.05 * top);
        let panel =
            Panel::new("recorded_file", &alt).x(Axis::linear("$t$ / s")).y(size).size(340, 190);
        let panel = spans.iter().fold(panel, |panel, [from, to]| {
            let corners = [(*from, 0.0), (*to, 0.0), (*to, 1.05 * top), (*from, 1.05 * top)];
            panel.area(corners, Ink::Body)
        });
        panel.curve(Curve::new(self.course.iter().copied(), Ink::Velocity)).figure()
    }

    /// The numbers of so many samples at most, all along the flight.
    fn drawn(&self, most: usize) -> impl Iterator<Item = usize> + Clone + use<> {
        (0..self.times.len()).step_by(self.times.len().div_ceil(most))
    }

    /// The rate about the sensor's axis `i`: so many samples at most, and the fit.
    fn curves(&self, i: usize, dots: usize) -> Result<[Curve; 2]> {
        let begin = self.times[0];
        let fitted = |t: f64| Ok(self.fit.rates(begin + t)?.to_array()[i]);
        let line = Curve::sampled(times(0.0, self.duration(), 200), fitted, Ink::Ink)?;
        let dots = self.drawn(dots).map(|k| (self.times[k] - begin, self.rates[k][i]));
        Ok([Curve::new(dots, Ink::Velocity).dots(), line])
    }

    /// The three rates over the time since the first sample (s).
    ///
    /// # Errors
    /// Those of the fit.
    pub fn rates_panel(&self) -> Result<Panel> {
        let panel = Panel::over_axes("$t$ / s", Axis::linear(r"$\omega$ / (rad/s)"));
        (0..3).try_fold(panel, |panel, i| {
            let [dots, line] = self.curves(i, SPOTS)?;
            Ok(panel.curve(dots).curve(line.label(AXES[i])))
        })
    }

    /// The rates, and below them what the fit leaves.
    pub(super) fn rates_figure(&self) -> Result<Figure> {
        let begin = self.times[0];
        let alt = format!(
            "The three rates of a flight of {:.2} s, on the axes x, y and z of the phone: dots, the samples, on \
             the exact curves of a free body. Below, what is left, in rad/s: dots to both sides of zero.",
            self.duration()
        );
        let stack = Stack::new("recorded_rates", &alt).row_height(105);
        let stack = (0..3).try_fold(stack, |stack, i| {
            let label = format!(r"$\omega_{}$ / (rad/s)", AXES[i]);
            let [dots, line] = self.curves(i, DOTS)?;
            let first = self.rates[0][i];
            // What does not change has an axis, too.
            let axis = match self.rates.iter().all(|rates| rates[i] == first) {
                true => Axis::linear(&label).range(first - 1.0, first + 1.0),
                false => Axis::linear(&label),
            };
            let panel = Panel::over_axes("$t$ / s", axis);
            Ok::<_, kit::Error>(stack.panel(panel.curve(dots).curve(line)))
        })?;
        let residuals: Vec<[f64; 3]> = self.fit.residuals().map(|r| r.to_array()).collect();
        let below = Panel::over_axes("$t$ / s", Axis::linear("sample less fit / (rad/s)"));
        let below = (0..3).fold(below.level(0.0, Ink::Frame, ""), |panel, i| {
            let dots = self.drawn(DOTS).map(|k| (self.times[k] - begin, -residuals[k][i]));
            panel.curve(Curve::new(dots, Ink::Velocity).dots())
        });
        stack.panel(below).figure()
    }

    /// The rates on the ellipsoid of energy, on the principal axes, up to a time.
    pub(super) fn polhode(&self) -> Result<MovingPicture> {
        let motion = self.fit.motion().clone();
        let (begin, end) = (self.times[0], self.duration());
        let energy = motion.kinetic_energy();
        // In units in which the ellipsoid's middle half-axis is 1.
        let moments = motion.body_momentum(BodyVector::new(1.0, 1.0, 1.0)).to_array();
        let mut sorted = moments;
        sorted.sort_by(f64::total_cmp);
        let scale = (sorted[1] / (2.0 * energy)).sqrt();
        let axes = moments.map(|moment| (sorted[1] / moment).sqrt());
        let reach = axes.into_iter().fold(0.0, f64::max);
        let placed =
            move |rates: [f64; 3], above: f64| SpaceVector::from(rates.map(|w| above * scale * w));
        let profile: Vec<_> = times(0.0, PI, 20).map(|turn| (-cos(turn), sin(turn))).collect();
        let ball = Solid::turned(SpaceVector::zero(), SpaceVector::new(1.0, 0.0, 0.0), &profile);
        let solid = ball.carried(|at| {
            let at = at.to_array();
            SpaceVector::from([0, 1, 2].map(|i| axes[i] * at[i]))
        });
        // A hair above the ellipsoid.
        let exact = motion.clone();
        let at = move |t: f64| placed(exact.angular_velocity(t).to_array(), 1.01);
        // The whole of it, where it comes back.
        let whole = motion.rate_period();
        let whole = if whole.is_finite() { whole } else { end };
        let line: Vec<SpaceVector> = times(0.0, whole, 240).map(&at).collect();
        let samples = self
            .drawn(SPOTS)
            .map(|k| (self.times[k] - begin, placed(self.principal(self.rates[k]), 1.02)));
        let samples: Vec<(f64, SpaceVector)> = samples.collect();
        MovingPicture::new(0.0..=end, [end], move |t| {
            let alt = format!(
                "An ellipsoid with its three axes x, y and z. A curve on it, the polhode, is the path of the angular \
                 velocity of the body; dots on the curve are the samples of the first {t:.2} s."
            );
            let view = View::new("polhode", &alt).around(SpaceVector::zero(), reach + 0.5);
            let view = view.solid(solid.clone(), Ink::Body).line(line.iter().copied(), Ink::Ink);
            let view = (0..3).fold(view, |view, i| {
                let along = |length: f64| {
                    SpaceVector::from(
                        [0, 1, 2].map(|k| if k == i { length * axes[i] } else { 0.0 }),
                    )
                };
                view.arrow(
                    along(1.0),
                    along(1.0) * ((axes[i] + 0.35) / axes[i]),
                    Ink::Frame,
                    AXES[i],
                    Side::Right,
                )
            });
            let seen = samples.iter().filter(|(time, _)| *time <= t);
            let view = seen.fold(view, |view, (_, place)| view.spot(*place, Ink::Velocity));
            view.arrow(SpaceVector::zero(), at(t), Ink::Velocity, r"$\omega$", Side::Right).figure()
        })
    }
}
