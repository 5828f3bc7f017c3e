//! Family D: the pendulum released at rest, W = 1.
//!
//! Rows: `theta0 t` -> the period and theta(t).

use super::{Answer, numbers};
use rotation_dynamics::exact::pendulum::{Pendulum, Suspension};

/// The function for a family of part D.
pub fn answerer(family: &str) -> Option<fn(&[&str]) -> Answer> {
    matches!(family, "D" | "D_gen").then_some(swing as fn(&[&str]) -> Answer)
}

fn swing(row: &[&str]) -> Answer {
    let [theta0, t] = *numbers(row)? else {
        return Err("a row of family D has two columns".into());
    };
    let unit = Suspension { moment: 1.0, mass: 1.0, gravity: 1.0, lever: 1.0 };
    let pendulum = Pendulum::new(unit, theta0, 0.0).map_err(|e| e.to_string())?;
    let state = pendulum.at(t).map_err(|e| e.to_string())?;
    Ok(vec![pendulum.period(), state.theta])
}
