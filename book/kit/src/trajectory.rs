//! A motion as samples, and as CSV.

use super::times;
use crate::error::{Error, Result};
use core::fmt::Write;
use rotation_dynamics::integrators::Solution;

/// Samples of a motion: named columns, one row per instant.
#[derive(Debug, Clone, PartialEq)]
pub struct Trajectory {
    columns: Vec<String>,
    rows: Vec<Vec<f64>>,
}

impl Trajectory {
    /// An empty trajectory; a column is named with its unit, as in `"t [s]"`.
    ///
    /// # Errors
    /// [`Error::Text`] if there is no column, or a name holds a comma or a quote.
    pub fn new<S: Into<String>>(columns: impl IntoIterator<Item = S>) -> Result<Self> {
        Self::named(columns.into_iter().map(Into::into).collect())
    }

    fn named(columns: Vec<String>) -> Result<Self> {
        let plain = |c: &String| !c.is_empty() && !c.contains([',', '"', '\n', '\r']);
        if columns.is_empty() || !columns.iter().all(plain) {
            return Err(Error::Text {
                text: columns.join(","),
                allowed: "a trajectory has columns, named without commas and quotes",
            });
        }
        Ok(Self { columns, rows: Vec::new() })
    }

    /// The samples that `sample` gives at each of these times.
    ///
    /// # Errors
    /// As [`Trajectory::new`] and [`Trajectory::push`], and those of `sample`.
    pub fn sampled<S: Into<String>, R: Into<Vec<f64>>>(
        columns: impl IntoIterator<Item = S>,
        times: impl IntoIterator<Item = f64>,
        mut sample: impl FnMut(f64) -> Result<R>,
    ) -> Result<Self> {
        let mut trajectory = Self::new(columns)?;
        let mut times = times.into_iter();
        trajectory.fill(&mut times, &mut |t| Ok(sample(t)?.into()))?;
        Ok(trajectory)
    }

    fn fill(
        &mut self,
        times: &mut dyn Iterator<Item = f64>,
        sample: &mut dyn FnMut(f64) -> Result<Vec<f64>>,
    ) -> Result<()> {
        for t in times {
            self.append(sample(t)?)?;
        }
        Ok(())
    }

    /// A solved motion: what `row` makes of each of `count + 1` times, from the start to the
    /// end, and of the state then.
    ///
    /// ```
    /// use rotation_dynamics::integrators::{Dop853, second_order};
    /// use kit::Trajectory;
    /// let run = Dop853::new(1e-9)?.solve(&second_order(|_, x, _| -x), 0.0, &[1.0, 0.0], 3.0, &[])?;
    /// let file = Trajectory::of(&run, ["t [s]", "x [m]"], 6, |t, [x, _]| [t, x])?;
    /// assert_eq!(file.rows()[6][0], 3.0);
    /// # Ok::<(), kit::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`Trajectory::new`] and [`Trajectory::push`].
    pub fn of<S: Into<String>, R: Into<Vec<f64>>, const N: usize>(
        run: &Solution<N>,
        columns: impl IntoIterator<Item = S>,
        count: u32,
        row: impl Fn(f64, [f64; N]) -> R,
    ) -> Result<Self> {
        let span = times(run.start_time(), run.end_time(), count);
        Self::sampled(columns, span, |t| Ok(row(t, run.at(t)?)))
    }

    /// Appends the sample `row`.
    ///
    /// # Errors
    /// [`Error::NotFinite`](rotation_dynamics::Error::NotFinite) for a NaN or an infinity,
    /// [`Error::Text`] for a wrong length.
    pub fn push(&mut self, row: impl Into<Vec<f64>>) -> Result<()> {
        self.append(row.into())
    }

    fn append(&mut self, row: Vec<f64>) -> Result<()> {
        for &value in &row {
            crate::error::finite("sample", value)?;
        }
        if row.len() != self.columns.len() {
            return Err(Error::Text {
                text: format!("{row:?}"),
                allowed: "a sample has as many numbers as the trajectory has columns",
            });
        }
        self.rows.push(row);
        Ok(())
    }

    /// The samples.
    pub fn rows(&self) -> &[Vec<f64>] {
        &self.rows
    }

    /// The file: a line of names, then the samples, each number with as many
    /// digits as it takes to read the same bits back.
    pub(crate) fn csv(&self) -> String {
        let mut text = self.columns.join(",") + "\n";
        for row in &self.rows {
            for (i, value) in row.iter().enumerate() {
                // Writing to a string cannot fail.
                let _ = write!(text, "{}{value:?}", if i == 0 { "" } else { "," });
            }
            text.push('\n');
        }
        text
    }
}
