//! `solve`'s closed forms as a [`Motion`].

use super::error_control::ExactMotion;
use crate::body::State;
use crate::error::{Error, Result, finite};
use crate::motion::{Kept, Motion};

/// It knows its state at a time, and not from what it was made.
impl Motion for ExactMotion {
    type State = State;

    fn name(&self) -> &'static str {
        Self::name(self)
    }

    fn try_state(&self, t: f64) -> Result<State> {
        self.at(finite("t", t)?)
    }

    fn kept(&self) -> Vec<Kept> {
        Vec::new()
    }

    fn condition(&self, _t: f64) -> Result<f64> {
        Err(Error::ConditionUnknown { name: Self::name(self) })
    }
}
