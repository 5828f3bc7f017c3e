//! The plank on two rollers, by the contacts of `planar`: its motion and what happens on the way.

#[path = "../planar/plank.rs"]
mod plank;

use super::case::{Case, Outcome, Result, Trouble};
use plank::{Plank, laid};
use rotation_dynamics::planar::contact::Mode;

pub fn contacts(case: &Case) -> Result<Outcome> {
    contacts_with_friction(case, 1.0)
}

/// The same with the friction multiplied by `damage`, for the test of the test.
pub fn contacts_with_friction(case: &Case, damage: f64) -> Result<Outcome> {
    let mut outcome = Outcome::new();
    let lacks = |what: &str| Trouble::Lacks(what.to_owned());
    let sense = match case.word("sense").ok_or_else(|| lacks("no input sense"))? {
        "in" => 1.0,
        "out" => -1.0,
        other => return Err(lacks(&format!("sense {other} is neither in nor out"))),
    };
    let plank = Plank {
        a: case.input("a")?,
        g: case.input("g")?,
        kinetic: case.input("mu_k")? * damage,
        holding: case.input("mu_s")? * damage,
        speed: sense * case.input("V")?,
    };
    let (x, v) = (case.input("x0")?, case.input("v0")?);
    let events = case.events().unwrap_or_default();
    let times = events.iter().map(|(t, _)| t.to_f64());
    let last = times.chain(case.samples().map(|sample| sample.t()));
    // A little beyond, so that the last event is met.
    let end = last.fold(0.0, f64::max) + 1e-3;
    let motion = laid(&plank, x, v, end, 1e-15)?;
    let mut condition = 0.0_f64;
    for sample in case.samples() {
        let (state, modes) = (motion.at(sample.t())?, motion.modes(sample.t())?);
        outcome.compare_field(&sample, "x", &[state.q[0]]);
        outcome.compare_field(&sample, "v", &[state.v[0]]);
        condition = condition.max(sample.condition("x").unwrap_or(0.0));
        let held = match modes {
            [Mode::Stick, _] => "stickL",
            [_, Mode::Stick] => "stickR",
            _ => "no",
        };
        if sample.word("stuck").is_some_and(|want| want != held) {
            outcome.compare("stuck", f64::NAN, sample.t().into(), 1.0);
        }
    }
    for (i, (t, name)) in events.iter().enumerate() {
        let found = motion.events().get(i);
        let same = found.filter(|event| means(name, &event.name));
        let (got, speed) = same.map_or((f64::NAN, 1.0), |event| (event.t, event.before.v[0].abs()));
        // The reference gives events no condition of their own: that of the place, over the speed.
        outcome.compare(name, got, *t, t.to_f64() + condition / speed);
    }
    Ok(outcome)
}

/// Whether an event of the reference is what the library calls so.
fn means(reference: &str, event: &str) -> bool {
    match reference {
        // What the roller cannot hold goes on to slip the other way.
        "catchL" => matches!(event, "left sticks" | "left reverses"),
        "catchR" => matches!(event, "right sticks" | "right reverses"),
        "break" => event.ends_with(" slips"),
        "tip" => event.ends_with(" lets go"),
        _ => false,
    }
}
