//! A quantity over one parameter: an exact line and simulated dots on it.

use super::{Axis, Curve, Ink, Panel};
use crate::error::Result;
use crate::times;

/// Points of a line from end to end: about one a px.
const FINE: f64 = 260.0;

/// A parameter that is varied: what several panels have as their horizontal axis, where
/// exact lines go from end to end, and where simulations lie on them.
///
/// ```
/// use rotation_dynamics::math::tanh;
/// use kit::draw::Sweep;
/// # fn simulate(x: f64) -> kit::Result<f64> { Ok(tanh(x)) }
/// # fn main() -> kit::Result<()> {
/// let depth = Sweep::over("depth / m", 0.0, 2.0).at([0.3, 0.8, 1.3, 1.8]);
/// let panel = depth.exact_and_simulated("speed / (m/s)", tanh, simulate)?;
/// // The same, with a label to the line.
/// let panel = depth.panel("speed / (m/s)").curve(depth.exact(tanh).label("exact"));
/// let panel = panel.curve(depth.simulated(simulate)?.label("simulated"));
/// # Ok(())
/// # }
/// ```
#[derive(Debug, Clone)]
pub struct Sweep {
    label: String,
    ends: (f64, f64),
    /// From point to point of a line.
    step: f64,
    simulated: Vec<f64>,
}

impl Sweep {
    /// The parameter of this label, with its unit, from the one value to the other.
    pub fn over(label: &str, from: f64, to: f64) -> Self {
        Self {
            label: label.into(),
            ends: (from, to),
            step: (to - from) / FINE,
            simulated: Vec::new(),
        }
    }

    /// Simulated for these values.
    #[must_use]
    pub fn at(mut self, values: impl IntoIterator<Item = f64>) -> Self {
        self.simulated = values.into_iter().collect();
        self
    }

    /// The same beyond `from`, where something begins to be.
    #[must_use]
    pub fn beyond(&self, from: f64) -> Self {
        let (_, to) = self.ends;
        let simulated = self.simulated.iter().copied().filter(|x| *x >= from);
        Self { ends: (from, to), simulated: simulated.collect(), ..self.clone() }
    }

    /// An empty panel over it, for [`figures!`](crate::figures).
    pub fn panel(&self, y: impl Into<Axis>) -> Panel {
        let (from, to) = self.ends;
        Panel::over_axes(Axis::linear(&self.label).range(from, to), y)
    }

    /// The exact line, in ink.
    pub fn exact(&self, y: impl Fn(f64) -> f64) -> Curve {
        let (from, to) = self.ends;
        let count = libm::round((to - from) / self.step) as u32;
        Curve::of(times(from, to, count), y, Ink::Ink)
    }

    /// What is simulated, as dots in the colour of the body.
    ///
    /// # Errors
    /// Those of the simulation.
    pub fn simulated(&self, y: impl Fn(f64) -> Result<f64>) -> Result<Curve> {
        let values = self.simulated.iter().copied();
        Ok(Curve::sampled(values, y, Ink::Body)?.dots())
    }

    /// A panel of the exact line and of what is simulated, the dots labelled so.
    ///
    /// # Errors
    /// Those of the simulation.
    pub fn exact_and_simulated(
        &self,
        y: impl Into<Axis>,
        exact: impl Fn(f64) -> f64,
        simulate: impl Fn(f64) -> Result<f64>,
    ) -> Result<Panel> {
        let dots = self.simulated(simulate)?.label("simulated");
        Ok(self.panel(y).curve(self.exact(exact)).curve(dots))
    }
}
