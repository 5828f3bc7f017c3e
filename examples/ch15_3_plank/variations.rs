//! Other starts, a rough floor, and what the scene leaves out.

use super::*;
use kit::short;
use rotation_dynamics::planar::contact::{Mode, Sense};

/// The angle at which the simulated force of the floor is least, from 1e-9 rad.
pub fn lowest(plank: &Plank) -> Result<f64> {
    let run = plank.fall(1e-12, HAIR, 0.0)?;
    let force = |t: f64| Ok::<_, kit::Error>(run.forces(t)?[0].normal);
    let (unit, end) = ((plank.length / plank.gravity).sqrt(), run.end_time());
    // It falls before and rises after: the sign of its difference over a short time.
    let (ends, step) = ([end - 0.6 * unit, end - 2e-4 * unit], 1e-4 * unit);
    let before = |t: f64| -> Result<bool> { Ok(force(t + step)? < force(t - step)?) };
    let [early, _] = try_bisect(ends, 1e-12 * unit, before)?;
    Ok(run.at(early)?.q[2])
}

/// The times to the floor from several starts, foot free and foot held.
pub fn starts(p: &Parameters, report: &mut Report) -> Result<()> {
    let columns = "released at / rad, t_floor / s, foot held / s, ratio, omega_floor / (rad/s)";
    let angles = [1.0, 0.1, 0.01, 1e-4, 1e-10, 1e-30];
    report.add(Table::of("starts", columns.split(", "), angles, |angle| {
        let (free, held) = (exact(p, angle)?, held_time(p, angle)?);
        let (time, rate) = (free.landing_time(), free.landing().omega);
        Ok([angle, time, held, held / time, rate].map(|x| short(x, 4)))
    })?)
}

/// Where a plank on a rough floor is let go. A start below 1e-4 rad is taken as 1e-4: what holds
/// the foot is in proportion to the angle, and is lost beside the weight if that is much smaller.
fn rough_start(p: &Parameters) -> f64 {
    p.angle.max(1e-4)
}

/// The fall on a rough floor from there.
pub fn rubbing(p: &Parameters, mu: f64) -> rotation_dynamics::Result<Fall> {
    Plank { mu, ..Plank::smooth(p) }.fall(1e-8, rough_start(p), 0.0)
}

/// Coefficients of friction, and how the plank falls.
pub fn rough(p: &Parameters, report: &mut Report) -> Result<()> {
    let from = format!("mu, from {} rad", rough_start(p));
    let others = ["first slips at / rad", "which way", "t_floor / s", "omega_floor / (rad/s)"];
    let columns = [from.as_str()].into_iter().chain(others);
    let sense = |mode: Mode| match mode {
        Mode::Slip(Sense::Backward) => "forwards",
        _ => "backwards",
    };
    let all = [0.0, 0.01, 0.1, 0.3, 0.37, 0.38, 0.6, 1.0];
    report.add(Table::of("rough", columns, all, |mu| {
        let run = rubbing(p, mu)?;
        let slips = run.events().iter().find(|event| event.name == "foot slips");
        // What slips from the release on is no event.
        let (at, way) = match (run.modes(0.0)?[0], slips) {
            (Mode::Stick, None) => ("-".into(), "never"),
            (Mode::Stick, Some(event)) => {
                let after = run.modes(event.t * (1.0 + 1e-9))?[0];
                (short(event.before.q[2], 4), sense(after))
            }
            (slides, _) => ("at once".into(), sense(slides)),
        };
        let lands = run.event("arrives")?;
        let [time, rate] = [lands.t, lands.before.v[2]].map(|x| short(x, 4));
        Ok([mu.to_string(), at, way.into(), time, rate])
    })?)
}

/// The card of effects: what was left out, and what that costs.
pub fn effects(p: &Parameters, report: &mut Report) -> Result<()> {
    let (landed, l) = (exact(p, p.angle)?.landing(), p.length);
    // A plank as wide as a tenth of its length, of wood (600 kg/m^3), in air, C = 1.2.
    let (width, thickness) = (0.1 * l, p.mass / (600.0 * 0.1 * l * l));
    let drag = 0.5 * 1.204 * 1.2 * width / p.mass;
    let number = 1.5 * drag * l * l;
    let windy = |part: f64| -> Result<f64> {
        let windy = Plank { drag: part * drag, ..Plank::smooth(p) }.fall(1e-8, p.angle, 0.0)?;
        Ok(1.0 - windy.event("arrives")?.before.v[2] / landed.omega)
    };
    // What has more drag than this floats down like a leaf, and all of the rate is lost.
    let falls = number < 30.0;
    let slower = if falls { windy(1.0)? } else { 1.0 };
    // Predicted from a tenth of the effect, as the linear response to it.
    let blown = if falls { (10.0 * windy(0.1)?).min(1.0) } else { 1.0 };
    let time = |mu: f64| Ok::<_, kit::Error>(rubbing(p, mu)?.event("arrives")?.t);
    let (slides, start) = (time(0.0)?, rough_start(p));
    let response = 10.0 * (time(0.001)? / slides - 1.0);
    let of = if start > p.angle { "of t_floor from 1e-4 rad" } else { "of t_floor" };
    let friction = effect("friction, mu = 0.01").number("4 mu/(3 theta0)", 0.04 / (3.0 * start));
    effect_card! { report,
        "square-cut foot of a wooden plank": "h/l" = thickness / l, costs atan2(thickness, l), "rad to tip over";
    }?;
    report.add(friction.costs(response, of).measured(time(0.01)? / slides - 1.0).within(1e-6))?;
    effect_card! { report,
        "air drag": "3 rho C w l^2/(4 m)" = number, costs blown, "of omega_floor", measured slower, within 1e-6;
        "one-sided contact of the foot": "least N/(m g)" = least_force()[1], costs 0.0, "of omega_floor", included;
    }
}
