//! What this scene leaves out, for the book thrown in a room.

use super::{Parameters, Tumble};
use rotation_dynamics::Result;
use rotation_dynamics::report::Report;

/// Adds the card of effects.
pub fn add(p: &Parameters, tumble: Tumble, report: &mut Report) -> Result<()> {
    let (momentum, pace) = (tumble.momentum(), tumble.pace());
    // A plate that turns about its middle edge: drag of its two halves, coefficient 1.2.
    let half = 0.5 * p.length;
    let drag = 0.5 * 1.204 * 1.2 * p.width * p.rate * p.rate * half * half * half * half / 2.0;
    let slowed = drag / momentum;
    // The start by hand: a degree.
    let aim = 0.0175;
    let shift = 2.0 * aim / (p.aside * pace);
    // Paper creaks: quality factor 20, bending at 50 Hz.
    let bending = p.rate / 314.0;
    let heated = bending * bending * p.rate / 20.0;
    let gradient = 1.5 * 9.80665 / 6.371e6 * (tumble.moments[2] - tumble.moments[0]) / momentum;
    let earth = 7.292_115e-5;
    rotation_dynamics::effect_card! { report,
        "a degree in the throw":
            "delta/aside" = aim / p.aside, costs shift, "s between flips";
        "air":
            "rho C b l^4 Omega^2/(64 L lambda)" = slowed / pace, costs slowed, "of L, a second";
        "it bends, and creaks":
            "(Omega/omega_b)^2 Omega/(Q lambda)" = heated / pace, costs heated, "of the free energy, a second";
        "gravity is weaker above":
            "3 (I3 - I1) g/(2 R_E L lambda)" = gradient / pace, costs gradient, "rad a second, at most";
        "the Earth turns": "Omega_E/lambda" = earth / pace, costs earth, "rad a second, at most";
    }
}
