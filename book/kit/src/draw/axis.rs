//! Axes: a label, a range that defaults to the data's, and where the ticks stand.

use super::ticks::Step;
use rotation_dynamics::error::{Error, Result, finite};
use rotation_dynamics::math::log10;

#[derive(Debug, Clone, Copy, PartialEq)]
enum Scale {
    Linear,
    /// Ticks at fractions and multiples of pi.
    Angle,
    Log,
}

/// An axis of a [`super::Panel`].
///
/// Figures that stand side by side get one axis, made of what all of them show:
/// ```
/// use kit::draw::Axis;
/// let (waves, loops) = ([0.9, 1.2], [0.5, 1.5]);
/// let theta = Axis::angle(r"$\theta$").over(waves.into_iter().chain(loops)).parts_of_pi(8);
/// // .y(theta.clone()) for each panel
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Axis {
    pub(super) label: String,
    scale: Scale,
    range: Option<(f64, f64)>,
    ticks: Option<Vec<(f64, String)>>,
    step: Option<Step>,
}

/// The least and the greatest value.
fn span(values: impl IntoIterator<Item = f64>) -> (f64, f64) {
    let none = (f64::INFINITY, f64::NEG_INFINITY);
    let wider = |(low, high): (f64, f64), x| (low.min(x), high.max(x));
    values.into_iter().fold(none, wider)
}

impl From<&str> for Axis {
    fn from(label: &str) -> Self {
        Self::linear(label)
    }
}

impl Axis {
    fn new(label: &str, scale: Scale) -> Self {
        Self { label: label.into(), scale, range: None, ticks: None, step: None }
    }

    /// A linear axis; the label holds the unit, as in `"$t$ / s"`.
    pub fn linear(label: &str) -> Self {
        Self::new(label, Scale::Linear)
    }

    /// A linear axis for an angle in radians, with ticks at simple parts of pi.
    pub fn angle(label: &str) -> Self {
        Self::new(label, Scale::Angle)
    }

    /// A logarithmic axis, with ticks at powers of ten.
    pub fn log(label: &str) -> Self {
        Self::new(label, Scale::Log)
    }

    /// The axis goes from `from` to `to`; without this, from the least to the
    /// greatest value drawn.
    #[must_use]
    pub fn range(mut self, from: f64, to: f64) -> Self {
        self.range = Some((from, to));
        self
    }

    /// The axis goes from the least to the greatest of these values, whatever of them a
    /// figure shows.
    #[must_use]
    pub fn over(self, values: impl IntoIterator<Item = f64>) -> Self {
        let (low, high) = span(values);
        self.range(low, high)
    }

    /// Ticks stand at the multiples of `step`.
    #[must_use]
    pub fn step(mut self, step: f64) -> Self {
        self.step = Some(Step::Of(step));
        self
    }

    /// Ticks stand at the multiples of pi over `denominator`.
    #[must_use]
    pub fn parts_of_pi(mut self, denominator: u32) -> Self {
        self.step = Some(Step::Pi(1, denominator.into()));
        self
    }

    /// Ticks stand at these places, labelled so; without this, at round values.
    #[must_use]
    pub fn ticks<S: Into<String>>(mut self, ticks: impl IntoIterator<Item = (f64, S)>) -> Self {
        self.ticks = Some(ticks.into_iter().map(|(x, s)| (x, s.into())).collect());
        self
    }

    /// The place of `value` on the axis: itself, or its decimal logarithm.
    pub(super) fn place(&self, value: f64) -> Result<f64> {
        finite("a value in a figure", value)?;
        match self.scale {
            Scale::Log if value <= 0.0 => Err(Error::out_of_range(
                "a value on a logarithmic axis",
                value,
                "it must be greater than 0",
            )),
            Scale::Log => Ok(log10(value)),
            _ => Ok(value),
        }
    }

    /// The range in places, given the places of the data.
    pub(super) fn extent(&self, places: impl IntoIterator<Item = f64>) -> Result<(f64, f64)> {
        let (low, high) = match self.range {
            Some((from, to)) => (self.place(from)?, self.place(to)?),
            None => span(places),
        };
        if low < high {
            Ok((low, high))
        } else {
            Err(Error::out_of_range(
                "the length of an axis",
                high - low,
                "it must be greater than 0: give the axis a range",
            ))
        }
    }

    /// The places and labels of the ticks within an extent; at most about `most`.
    pub(super) fn marks(&self, extent: (f64, f64), most: usize) -> Result<Vec<(f64, String)>> {
        let Some(ticks) = &self.ticks else {
            let step = self.step.unwrap_or_else(|| match self.scale {
                Scale::Linear => Step::decimal(extent, most),
                Scale::Angle => Step::angle(extent, most),
                Scale::Log => Step::decades(extent, most),
            });
            return step.ticks(extent);
        };
        let mark = |(value, label): &(f64, String)| Ok((self.place(*value)?, label.clone()));
        ticks.iter().map(mark).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use core::f64::consts::PI;

    fn labels(axis: &Axis, extent: (f64, f64)) -> Vec<String> {
        let ticks = axis.marks(extent, 6).expect("the ticks are the axis's own");
        ticks.into_iter().map(|(_, label)| label.replace('$', "")).collect()
    }

    #[test]
    fn ticks_are_round_and_inside() {
        let axis = Axis::linear("x");
        assert_eq!(labels(&axis, (0.0, 10.0)), ["0", "2", "4", "6", "8", "10"]);
        assert_eq!(labels(&axis, (0.62, 1.36)), ["0.8", "1.0", "1.2"]);
        assert_eq!(labels(&axis, (-0.3, 0.3)), ["-0.2", "0.0", "0.2"]);
        let angle = Axis::angle("x");
        assert_eq!(labels(&angle, (0.0, PI)), ["0", "\\pi/4", "\\pi/2", "3\\pi/4", "\\pi"]);
        assert_eq!(labels(&angle, (-PI, PI)), ["-\\pi", "-\\pi/2", "0", "\\pi/2", "\\pi"]);
        let log = Axis::log("x");
        assert_eq!(
            labels(&log, (-12.0, -2.0)),
            ["10^{-12}", "10^{-10}", "10^{-8}", "10^{-6}", "10^{-4}", "10^{-2}"]
        );
    }

    #[test]
    fn siblings_have_one_range_and_one_step() {
        let axis = Axis::linear("x").over([0.3, -0.1, 1.2]).step(0.25);
        let extent = axis.extent([5.0]).expect("its own range");
        assert_eq!(extent, (-0.1, 1.2));
        assert_eq!(labels(&axis, extent), ["0.00", "0.25", "0.50", "0.75", "1.00"]);
        let angle = Axis::angle("x").parts_of_pi(8);
        assert_eq!(labels(&angle, (0.7, 1.7)), ["\\pi/4", "3\\pi/8", "\\pi/2"]);
        for step in [0.0, -1.0, f64::NAN, 1e-9] {
            assert!(Axis::linear("x").step(step).marks((0.0, 1.0), 6).is_err(), "{step}");
        }
        assert!(Axis::linear("x").over([]).extent([1.0, 2.0]).is_err());
    }

    #[test]
    fn an_axis_refuses_what_it_cannot_show() {
        assert!(Axis::log("x").place(0.0).is_err());
        assert!(Axis::linear("x").place(f64::NAN).is_err());
        assert!(Axis::linear("x").range(1.0, 1.0).extent([]).is_err());
        assert!(Axis::linear("x").extent([]).is_err());
    }
}
