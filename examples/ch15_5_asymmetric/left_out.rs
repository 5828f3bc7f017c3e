//! What this scene leaves out, for the book thrown in a room.

use super::{Parameters, Tumble, euler, length};
use rotation_dynamics::Result;
use rotation_dynamics::integrators::{Dop853, Integrator, Ode, Work, ode};
use rotation_dynamics::report::Report;

/// Pieces of the cover along each edge.
const PIECES: u32 = 12;

/// The torque of the air about the longest edge and the middle one. Each piece of the cover is
/// pressed by 1/2 rho C w^2 against the velocity w across it, with C = 1.2.
fn pressed(p: &Parameters, [one, two, _]: [f64; 3]) -> [f64; 2] {
    let at = |k: u32, edge: f64| edge * ((f64::from(k) + 0.5) / f64::from(PIECES) - 0.5);
    let area = p.length * p.width / f64::from(PIECES * PIECES);
    let mut torque = [0.0; 2];
    for (x, y) in (0..PIECES * PIECES).map(|k| (at(k / PIECES, p.length), at(k % PIECES, p.width)))
    {
        let across = one * y - two * x;
        let force = -0.5 * 1.204 * 1.2 * area * across * across.abs();
        torque[0] += y * force;
        torque[1] -= x * force;
    }
    torque
}

/// The part of L that the air takes from one flip to the next: along the motion without it, and
/// from the motion with it.
pub fn taken(p: &Parameters, tumble: &Tumble) -> Result<([f64; 2], Work)> {
    let (time, size, parts) = (tumble.between_flips()?, tumble.momentum(), 200);
    let mut first = 0.0;
    for k in 0..parts {
        let rates = tumble.rates(time * (f64::from(k) + 0.5) / f64::from(parts))?;
        let ([a, b], [l1, l2, _]) = (pressed(p, rates), tumble.carried(rates));
        first -= (a * l1 + b * l2) / (size * size) * time / f64::from(parts);
    }
    let moments = tumble.moments;
    let law = ode(move |t, rates: &[f64; 3]| {
        let ([u, v, w], [a, b]) = (euler(moments).derivative(t, rates), pressed(p, *rates));
        [u + a / moments[0], v + b / moments[1], w]
    });
    let law = law.scaled(|rates: &[f64; 3]| [length(*rates).max(f64::MIN_POSITIVE); 3]);
    let (end, work) = Dop853::new(1e-10)?.advance(&law, 0.0, &tumble.start, time)?;
    Ok(([first, 1.0 - length(tumble.carried(end)) / size], work))
}

/// By how much sooner the next flip comes if the throw is off by so much more: to first order,
/// and simulated.
pub fn sooner(p: &Parameters, tumble: &Tumble, aim: f64) -> Result<([f64; 2], Work)> {
    let off = |more: f64| Tumble::new(tumble.moments, p.rate, p.aside + more, tumble.about);
    let step = 1e-5 * p.aside;
    let slope = (off(-step).between_flips()? - off(step).between_flips()?) / (2.0 * step);
    let (thrown, method) = (off(aim), Dop853::new(1e-15)?);
    let flip = |count| {
        method.zero(
            &euler(thrown.moments),
            thrown.start,
            count,
            1e4 / thrown.pace(),
            |y| y[1],
        )
    };
    let ((first, _), (second, cost)) = (flip(1)?, flip(2)?);
    Ok((
        [slope * aim, tumble.between_flips()? - (second.t - first.t)],
        cost,
    ))
}

/// Adds the card of effects.
pub fn add(p: &Parameters, tumble: Tumble, report: &mut Report) -> Result<()> {
    let (momentum, pace) = (tumble.momentum(), tumble.pace());
    // A plate that turns about its middle edge: drag of its two halves, coefficient 1.2.
    let half = 0.5 * p.length;
    let drag = 0.5 * 1.204 * 1.2 * p.width * p.rate * p.rate * half * half * half * half / 2.0;
    let slowed = drag / momentum;
    // The start by hand: a degree.
    let aim = 0.0175;
    let ([shift, shifted], thrown) = sooner(p, &tumble, aim)?;
    let cost = |work: Work| format!("closed form, {} derivatives", work.derivatives);
    // Where air would take most of it, there is no second flip to speak of.
    let slight = slowed * tumble.between_flips()? < 0.5;
    let blown = slight.then(|| taken(p, &tumble)).transpose()?;
    // Paper creaks: quality factor 20, bending at 50 Hz.
    let bending = p.rate / 314.0;
    let heated = bending * bending * p.rate / 20.0;
    let gradient = 1.5 * 9.80665 / 6.371e6 * (tumble.moments[2] - tumble.moments[0]) / momentum;
    let earth = 7.292_115e-5;
    rotation_dynamics::effect_card! { report,
        "a degree in the throw":
            "delta/aside" = aim / p.aside, costs shift, "s between flips, to first order",
            measured shifted, within 1e-9 * tumble.between_flips()?, at_cost cost(thrown);
        "air":
            "rho C b l^4 Omega^2/(64 L lambda)" = slowed / pace,
            costs blown.map_or(1.0, |([first, _], _)| first), "of L, from flip to flip",
            measured blown.map(|([_, lost], _)| lost), within 1e-8, at_cost blown.map_or("-".into(), |(_, work)| cost(work));
        "it bends, and creaks":
            "(Omega/omega_b)^2 Omega/(Q lambda)" = heated / pace, costs heated, "of the free energy, a second";
        "gravity is weaker above":
            "3 (I3 - I1) g/(2 R_E L lambda)" = gradient / pace, costs gradient, "rad a second, at most";
        "the Earth turns": "Omega_E/lambda" = earth / pace, costs earth, "rad a second, at most";
    }
}
