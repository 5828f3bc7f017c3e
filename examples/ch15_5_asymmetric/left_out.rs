//! What this scene leaves out, for the book thrown in a room.

use super::*;
use kit::simpson;
use rotation_dynamics::Error;
use rotation_dynamics::effects::{Effect, GravityGradient};

/// The drag coefficient of the cover, if none is given.
const DRAG: f64 = 1.2;
/// Pieces of the cover along each edge.
const PIECES: u32 = 12;

/// The torque of the air about the longest edge and the middle one. Each piece of the cover is
/// pressed by 1/2 rho C w^2 against the velocity w across it.
fn pressed(p: &Parameters, [one, two, _]: [f64; 3]) -> [f64; 2] {
    let at = |k: u32, edge: f64| edge * ((f64::from(k) + 0.5) / f64::from(PIECES) - 0.5);
    let area = p.length * p.width / f64::from(PIECES * PIECES);
    let mut torque = [0.0; 2];
    for k in 0..PIECES * PIECES {
        let (x, y) = (at(k / PIECES, p.length), at(k % PIECES, p.width));
        let across = one * y - two * x;
        let force = -0.5 * 1.204 * p.air.unwrap_or(DRAG) * area * across * across.abs();
        torque[0] += y * force;
        torque[1] -= x * force;
    }
    torque
}

/// Euler's equations with the torque of the air.
fn in_air(p: &Parameters, moments: [f64; 3]) -> impl Ode<3> {
    let law = ode(move |t, rates: &[f64; 3]| {
        let ([u, v, w], [a, b]) = (euler(moments).derivative(t, rates), pressed(p, *rates));
        [u + a / moments[0], v + b / moments[1], w]
    });
    law.scaled(|rates: &[f64; 3]| [length(*rates).max(f64::MIN_POSITIVE); 3])
}

/// The part of L that the air takes from one flip to the next: along the motion without it, and
/// from the motion with it.
fn taken(p: &Parameters, tumble: &Tumble) -> Result<([f64; 2], Work)> {
    let (time, size) = (tumble.between_flips()?, tumble.momentum());
    let first = simpson([0.0, time], 200, |t| {
        let rates = tumble.rates(t)?;
        let ([a, b], [l1, l2, _]) = (pressed(p, rates), tumble.carried(rates));
        Ok::<_, kit::Error>(-(a * l1 + b * l2) / (size * size))
    })?;
    let law = in_air(p, tumble.moments);
    let (end, work) = Dop853::new(1e-10)?.advance(&law, 0.0, &tumble.start, time)?;
    Ok(([first, 1.0 - length(tumble.carried(end)) / size], work))
}

/// By how much sooner the next flip comes if the throw is off by so much more: to first order,
/// and simulated.
fn sooner(p: &Parameters, tumble: &Tumble, aim: f64) -> Result<([f64; 2], Work)> {
    let off = |more: f64| Tumble::new(tumble.moments, p.rate, p.aside + more, tumble.about);
    let step = 1e-5 * p.aside;
    let slope = (off(-step).between_flips()? - off(step).between_flips()?) / (2.0 * step);
    let ((first, _), (second, cost)) = (off(aim).flip(1)?, off(aim).flip(2)?);
    Ok(([slope * aim, tumble.between_flips()? - (second.t - first.t)], cost))
}

/// The angle by which the gradient of gravity turns L from one flip to the next, with L at 45
/// degrees to the vertical: the sum of its torque along the motion without it, and simulated.
fn twisted(tumble: &Tumble) -> Result<([f64; 2], Work)> {
    let (body, motion) = (tumble.body()?, tumble.free_body()?);
    let (time, parts) = (tumble.between_flips()?, 400);
    let towards = SpaceVector::new(0.0, 1.0, 1.0);
    let gradient = GravityGradient::fixed((9.80665_f64 / 6.371e6).sqrt(), towards)?;
    let mut sum = SpaceVector::zero();
    for k in 0..parts {
        let t = time * (f64::from(k) + 0.5) / f64::from(parts);
        sum += gradient.torque(t, &body, &motion.state(t)) * (time / f64::from(parts));
    }
    let (start, scene) = (motion.state(0.0), Scene::new(body).with(gradient));
    let (end, work) = Dop853::new(1e-14)?.advance(&scene, 0.0, &start, time)?;
    let (before, after) = (start.angular_momentum, end.angular_momentum);
    let across = |v: &SpaceVector| before.cross(v).norm() / before.norm();
    let turned = atan2(across(&after), before.dot(&after) / before.norm());
    Ok(([across(&sum) / before.norm(), turned], work))
}

/// What `--with air` adds to the report: when the book flips, without air and in it, and what
/// is left of L.
pub fn flips_in_air(p: &Parameters, report: &mut Report) -> Result<()> {
    if p.air.is_none() {
        return Ok(());
    }
    let tumble = tumble(p)?;
    let (law, free) = (in_air(p, tumble.moments), tumble.between_flips()?);
    let columns = ["flip", "without air / s", "in air / s", "part of L left"];
    report.add(Table::of("air", columns, 1..=4, |flip| {
        let due = (f64::from(flip) - 0.5) * free;
        let met = Dop853::new(1e-12)?.zero(&law, tumble.start, flip, 10.0 * due, |rates| rates[1]);
        let [t, left] = match met {
            Ok((met, _)) => {
                [met.t, length(tumble.carried(met.state)) / tumble.momentum()].map(|x| short(x, 4))
            }
            Err(Error::NotReached { .. }) => ["-", "-"].map(String::from),
            Err(error) => return Err(error.into()),
        };
        Ok([flip.to_string(), short(due, 4), t, left])
    })?)
}

/// The card of effects.
pub fn effects(p: &Parameters, report: &mut Report) -> Result<()> {
    let tumble = tumble(p)?;
    let (momentum, pace) = (tumble.momentum(), tumble.pace());
    // A plate that turns about its middle edge: drag of its two halves.
    let half = 0.5 * p.length;
    let braking =
        0.5 * 1.204 * p.air.unwrap_or(DRAG) * p.width * p.rate * p.rate * half * half * half * half
            / 2.0;
    let slowed = braking / momentum;
    // The start by hand: a degree.
    let aim = 0.0175;
    let ([shift, shifted], thrown) = sooner(p, &tumble, aim)?;
    // Where air would take most of it, there is no second flip to speak of.
    let wait = tumble.between_flips()?;
    let blown = when(slowed * wait < 0.5, || taken(p, &tumble))?;
    // Paper creaks: quality factor 20, bending at 50 Hz.
    let bending = p.rate / 314.0;
    let heated = bending * bending * p.rate / 20.0;
    let gradient = 1.5 * 9.80665 / 6.371e6 * (tumble.moments[2] - tumble.moments[0]) / momentum;
    let earth = 7.292_115e-5;
    // What a wait makes larger by 16/aside^2 must stay small to be a sum along the free motion.
    let small = gradient / pace < 1e-3 * p.aside * p.aside;
    let twisted = when(small, || twisted(&tumble))?;
    effect_card! { report,
        "a degree in the throw":
            "delta/aside" = aim / p.aside, costs shift, "s between flips, to first order",
            measured shifted, within 1e-9 * wait, at_work thrown;
        "air": "rho C b l^4 Omega^2/(64 L p)" = slowed / pace,
            costs blown.map_or(1.0, |([first, _], _)| first), "of L, from flip to flip",
            measured blown.map(|([_, lost], _)| lost), within 1e-8, at_work blown.map(|(_, work)| work);
        "it bends, and creaks":
            "(Omega/omega_b)^2 Omega/(Q p)" = heated / pace, costs heated, "of the free energy, a second";
        "gravity is weaker above": "3 (I3 - I1) g/(2 R_E L p)" = gradient / pace,
            costs twisted.map_or(gradient * wait, |([first, _], _)| first), "rad from flip to flip, in the direction of L",
            measured twisted.map(|([_, turned], _)| turned), within 1e-12, at_work twisted.map(|(_, work)| work);
        "the Earth turns": "Omega_E/p" = earth / pace, costs earth, "rad a second, at most";
    }
}
