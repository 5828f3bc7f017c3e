//! Computations that can be run again, for those who measure time.

use crate::error::Result;
use core::fmt;
use core::hint::black_box;
use std::sync::Arc;

/// The computation behind a line of the accuracy strip, to be run again.
///
/// This library never reads the clock; a benchmark runs this between two looks at it.
///
/// ```
/// use kit::Computation;
/// # fn main() -> kit::Result<()> {
/// let halving = Computation::new(
///     || Ok((0..20).fold(1.0, |x: f64, _| 0.5 * (x + 2.0 / x))),
///     |root| Ok((root - 2.0_f64.sqrt()).abs()),
/// );
/// halving.run()?;
/// assert!(halving.error()? < 1e-15);
/// # Ok(())
/// # }
/// ```
#[derive(Clone)]
pub struct Computation {
    run: Arc<dyn Fn() -> Result<()> + Send + Sync>,
    error: Arc<dyn Fn() -> Result<f64> + Send + Sync>,
}

impl Computation {
    /// `compute` is all that is timed; `error` judges its result.
    pub fn new<T>(
        compute: impl Fn() -> Result<T> + Send + Sync + 'static,
        error: impl Fn(&T) -> Result<f64> + Send + Sync + 'static,
    ) -> Self {
        let compute = Arc::new(compute);
        let judged = Arc::clone(&compute);
        Self {
            run: Arc::new(move || {
                black_box(compute()?);
                Ok(())
            }),
            error: Arc::new(move || error(&judged()?)),
        }
    }

    /// Computes and discards the result, which the compiler must not do without.
    ///
    /// # Errors
    /// Those of the computation.
    pub fn run(&self) -> Result<()> {
        (self.run)()
    }

    /// Computes and returns the error of the result.
    ///
    /// # Errors
    /// Those of the computation and of its judge.
    pub fn error(&self) -> Result<f64> {
        (self.error)()
    }
}

impl fmt::Debug for Computation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Computation")
    }
}

/// The closed form of a scene, as a function of how much of the motion is over.
///
/// One sample of it is the unit of the times in the accuracy strip.
#[derive(Clone)]
pub struct ClosedForm(Arc<dyn Fn(f64) -> Result<()> + Send + Sync>);

impl ClosedForm {
    /// `state` gives what the scene is asked for, from 0 at the start to 1 at the end.
    pub fn new<T>(
        state: impl Fn(f64) -> rotation_dynamics::Result<T> + Send + Sync + 'static,
    ) -> Self {
        Self(Arc::new(move |part| {
            black_box(state(part)?);
            Ok(())
        }))
    }

    /// Computes the state when `part` of the motion, from 0 to 1, is over.
    ///
    /// # Errors
    /// Those of the closed form.
    pub fn sample(&self, part: f64) -> Result<()> {
        (self.0)(part)
    }
}

impl fmt::Debug for ClosedForm {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("ClosedForm")
    }
}
