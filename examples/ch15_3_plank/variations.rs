//! Other starts, a rough floor, and what the scene leaves out.

use super::*;
use kit::{Table, effect, short};
use rotation_dynamics::math::atan2;
use rotation_dynamics::planar::contact::{Mode, Sense};

/// The angle at which the simulated force of the floor is least, from 1e-9 rad.
pub fn lowest(plank: &Plank) -> Result<f64> {
    let run = plank.fall(1e-12, HAIR, 0.0)?;
    let force = |t: f64| Ok::<_, rotation_dynamics::Error>(run.forces(t)?[0].normal);
    let unit = (plank.length / plank.gravity).sqrt();
    // It falls before and rises after: bisection of the difference over a short time.
    let mut early = run.end_time() - 0.6 * unit;
    let mut late = run.end_time() - 2e-4 * unit;
    let step = 1e-4 * unit;
    for _ in 0..40 {
        let middle = 0.5 * (early + late);
        match force(middle + step)? < force(middle - step)? {
            true => early = middle,
            false => late = middle,
        }
    }
    Ok(run.at(early)?.q[2])
}

/// The times to the floor from several starts, foot free and foot held.
pub fn starts(p: &Parameters) -> Result<Table> {
    let columns = "released at / rad, t_floor / s, foot held / s, ratio, omega_floor / (rad/s)";
    let mut table = Table::new("starts", columns.split(", "))?;
    for angle in [1.0, 0.1, 0.01, 1e-4, 1e-10, 1e-30] {
        let free = Exact::new(p.length, p.gravity, angle, 0.0)?;
        let held = Ladder::new(p.length, p.gravity, angle)?.held_landing_time();
        let (time, rate) = (free.landing_time(), free.landing().omega);
        table.push([angle, time, held, held / time, rate].map(|x| short(x, 4)))?;
    }
    Ok(table)
}

/// Where a plank on a rough floor is let go. A start below 1e-4 rad is taken as 1e-4: what holds
/// the foot is in proportion to the angle, and is lost beside the weight if that is much smaller.
fn rough_start(p: &Parameters) -> f64 {
    p.angle.max(1e-4)
}

/// The fall on a rough floor from there.
pub fn rubbing(p: &Parameters, mu: f64) -> rotation_dynamics::Result<Fall> {
    let plank = Plank { mu, ..Plank::smooth(p) };
    plank.fall(1e-8, rough_start(p), 0.0)
}

/// Coefficients of friction, and how the plank falls.
pub fn rough(p: &Parameters) -> Result<Table> {
    let columns = [
        format!("mu, from {} rad", rough_start(p)),
        "first slips at / rad".into(),
        "which way".into(),
        "t_floor / s".into(),
        "omega_floor / (rad/s)".into(),
    ];
    let mut table = Table::new("rough", columns)?;
    let sense = |mode: Mode| match mode {
        Mode::Slip(Sense::Backward) => "forwards",
        _ => "backwards",
    };
    for mu in [0.0, 0.01, 0.1, 0.3, 0.37, 0.38, 0.6, 1.0] {
        let run = rubbing(p, mu)?;
        let slips = run.events().iter().find(|event| event.name == "foot slips");
        // What slips from the release on is no event.
        let (at, way) = match (run.modes(0.0)?[0], slips) {
            (Mode::Stick, None) => (String::from("-"), "never"),
            (Mode::Stick, Some(event)) => {
                let after = run.modes(event.t * (1.0 + 1e-9))?[0];
                (short(event.before.q[2], 4), sense(after))
            }
            (slides, _) => ("at once".into(), sense(slides)),
        };
        let lands = run.event("arrives")?;
        table.push([
            mu.to_string(),
            at,
            way.into(),
            short(lands.t, 4),
            short(lands.before.v[2], 4),
        ])?;
    }
    Ok(table)
}

/// The card of effects: what was left out, and what that costs.
pub fn effects(p: &Parameters, solved: &Solved, report: &mut Report) -> Result<()> {
    let (exact, l) = (&solved.exact, p.length);
    // A plank as wide as a tenth of its length, of wood (600 kg/m^3), in air, C = 1.2.
    let (width, thickness) = (0.1 * l, p.mass / (600.0 * 0.1 * l * l));
    let drag = 0.5 * 1.204 * 1.2 * width / p.mass;
    let number = 1.5 * drag * l * l;
    let windy = |part: f64| -> Result<f64> {
        let drag = part * drag;
        let windy = Plank { drag, ..Plank::smooth(p) }.fall(1e-8, p.angle, 0.0)?;
        Ok(1.0 - windy.event("arrives")?.before.v[2] / exact.landing().omega)
    };
    // What has more drag than this floats down like a leaf, and all of the rate is lost.
    let slower = if number < 30.0 { windy(1.0)? } else { 1.0 };
    // Predicted from a tenth of the effect, as the linear response to it.
    let blown = if number < 30.0 { (10.0 * windy(0.1)?).min(1.0) } else { 1.0 };
    let time = |mu: f64| Ok::<_, rotation_dynamics::Error>(rubbing(p, mu)?.event("arrives")?.t);
    let slides = time(0.0)?;
    let rubbed = time(0.01)? / slides - 1.0;
    let response = 10.0 * (time(0.001)? / slides - 1.0);
    let start = rough_start(p);
    let of = if start > p.angle { "of t_floor from 1e-4 rad" } else { "of t_floor" };
    kit::effect_card! { report,
        "square-cut foot of a wooden plank": "h/l" = thickness / l, costs atan2(thickness, l), "rad to tip over";
    }?;
    report.add(
        effect("friction, mu = 0.01")
            .number("4 mu/(3 theta0)", 0.04 / (3.0 * start))
            .costs(response, of)
            .measured(rubbed)
            .within(1e-6),
    )?;
    kit::effect_card! { report,
        "air drag": "3 rho C w l^2/(4 m)" = number, costs blown, "of omega_floor", measured slower, within 1e-6;
        "one-sided contact of the foot": "least N/(m g)" = least_force()[1], costs 0.0, "of omega_floor", included;
    }
}
