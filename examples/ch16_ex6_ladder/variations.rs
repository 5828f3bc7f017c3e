//! What changes if an assumption goes: the mass is spread differently, the
//! surfaces rub, the air drags.

use super::*;
use kit::supported_digits;
use models::ladder::Phase;

/// The motion of another ladder from the same start, to nine digits where theta has them.
fn slide(p: &Parameters, ladder: Ladder) -> Result<Slide> {
    let (start, within) = (ladder.at_rest(p.angle), rounding(p).max(1e-9));
    let end = 100.0 * Exact::new(p.length, p.gravity, p.angle)?.landing_time();
    Ok(motion_within(ladder, within, start, end)?)
}

/// Seven digits of a number.
fn digits(value: f64) -> String {
    supported_digits(value, 1e-7)
}

/// The mass spread differently, with the centre in the middle still.
pub fn mass(p: &Parameters) -> Result<Table> {
    let columns = "mass, inertia, height ratio, t_release, omega_floor".split(", ");
    let spreads = [(0.3, "mostly in the middle"), (1.0, "uniform"), (3.0, "at both ends")];
    Table::of("mass", columns, spreads, |(inertia, name)| {
        let run = slide(p, Ladder { inertia, ..Ladder::smooth(p) })?;
        let lets_go = run.event("wall lets go")?;
        let ratio = cos(lets_go.before.q[2]) / cos(p.angle);
        let numbers = [ratio, lets_go.t, run.event("lands")?.before.v[2]].map(digits);
        Ok([name.into(), inertia.to_string()].into_iter().chain(numbers))
    })
}

/// The ladder stays where it is put if `mu` is at least this: tan(theta0/2).
fn holding_friction(p: &Parameters) -> f64 {
    tan(0.5 * p.angle)
}

/// How the motion goes with this part of the friction that would hold the ladder.
pub fn rubbing(p: &Parameters, part: f64) -> Result<Slide> {
    let mu = part * holding_friction(p);
    slide(p, Ladder { mu, ..Ladder::smooth(p) })
}

/// Dry friction at both ends.
pub fn friction(p: &Parameters) -> Result<Table> {
    let columns = "mu, mu/tan(theta0/2), height ratio, t_release/s, t_floor/s";
    let parts = [0.0, 0.1, 0.3, 0.6, 0.9, 1.0];
    Table::of("friction", columns.split(", "), parts, |part| {
        let mu = supported_digits(part * holding_friction(p), 1e-6);
        let [none, stays] = ["-", "it stays"].map(String::from);
        let mut cells = [mu, part.to_string(), none, stays.clone(), stays];
        for event in rubbing(p, part)?.events() {
            match event.name.as_str() {
                "wall lets go" => {
                    cells[2] = digits(cos(event.before.q[2]) / cos(p.angle));
                    cells[3] = digits(event.t);
                }
                "lands" => cells[4] = digits(event.t),
                _ => {}
            }
        }
        Ok(cells)
    })
}

/// The starts that the page asks about, in closed form.
pub fn tries(p: &Parameters) -> Result<Table> {
    let columns = "start, theta_release, t_release, omega_floor, kept wall too fast by";
    let starts = [
        ("as above", p.gravity, p.angle),
        ("a tenth of the angle", p.gravity, 0.1 * p.angle),
        ("on the Moon", 1.62, p.angle),
        ("nearly flat", p.gravity, 1.5),
    ];
    Table::of("try", columns.split(", "), starts, |(start, gravity, angle)| {
        let exact = Exact::new(p.length, gravity, angle)?;
        let (release, omega) = (exact.release(), exact.landing().omega);
        let excess = (3.0 * gravity * cos(angle) / p.length).sqrt() / omega - 1.0;
        let numbers = [release.theta, exact.release_time(), omega, excess].map(digits);
        Ok([start.into()].into_iter().chain(numbers))
    })
}

/// How much later the ladder lands with the friction `mu`, over the time of the smooth one.
///
/// To first order friction takes work and horizontal speed along the exact motion, which then
/// turns more slowly at each angle. Nearly flat that vanishes and the square counts: the floor's
/// friction presses the top against the wall, `N_wall = mu N_floor`, and the ladder turns with
/// `W^2 (1 - mu^2)/(1 - mu^2/2)`, so later by the part `mu^2/4`.
fn later(p: &Parameters, exact: &Exact, mu: f64) -> Result<f64> {
    let (l, g, landed) = (p.length, p.gravity, exact.landing_time());
    let dt = landed / 2000.0;
    // What is lost of the energy and of the horizontal speed, per unit mass, and of the time.
    let (mut work, mut speed, mut delay) = (0.0, 0.0, 0.0);
    for t in times(0.5 * dt, landed - 0.5 * dt, 1999) {
        let state = exact.at(t)?;
        let (s, c) = sincos(state.theta);
        let foot = state.vx_cm + 0.5 * l * c * state.omega;
        let (floor, wall) = (mu * g * state.floor_force, mu * g * state.wall_force);
        let half = 0.5 * dt * (floor * foot + wall * l * s * state.omega);
        work += half;
        let slower = if state.phase == Phase::OnWall {
            3.0 * work / (l * l * state.omega)
        } else {
            speed += floor * dt;
            (work - state.vx_cm * speed) / (l * l * (1.0 / 12.0 + 0.25 * s * s) * state.omega)
        };
        if state.phase == Phase::OnWall {
            speed = 0.5 * l * c * slower;
        }
        delay += dt * slower / state.omega;
        work += half;
    }
    Ok(delay / landed + 0.25 * mu * mu)
}

/// Air on a light ladder: rho C w l^2/m with its density (kg/m^3), the drag coefficient of
/// a flat plate, solid width (m) of stiles and rungs and mass (kg); and the part of the
/// fall's energy that it would take, by the work of the drag along the exact motion.
fn air(p: &Parameters, exact: &Exact) -> Result<(f64, f64)> {
    let (per_area, mass) = (1.204 * 1.2 * 0.08, 4.0 * p.length);
    let dt = exact.landing_time() / 400.0;
    let mut work = 0.0;
    for t in times(0.5 * dt, exact.landing_time() - 0.5 * dt, 399) {
        let state = exact.at(t)?;
        let (s, c) = sincos(state.theta);
        let across = -c * state.vx_cm + s * (0.5 * p.length * s * state.omega);
        for from_middle in times(-39.0 / 80.0 * p.length, 39.0 / 80.0 * p.length, 39) {
            let speed = (across + state.omega * from_middle).abs();
            work += 0.5 * per_area * speed * speed * speed * p.length / 40.0 * dt;
        }
    }
    let fall = mass * p.gravity * 0.5 * p.length * cos(p.angle);
    Ok((per_area * p.length * p.length / mass, work / fall))
}

/// The card of effects: what was left out, and what that costs.
pub fn effects(p: &Parameters, report: &mut Report) -> Result<()> {
    let Solved { exact, naive, .. } = &solve(p)?;
    let rubs = later(p, exact, 0.1 * holding_friction(p))?;
    let found = rubbing(p, 0.1)?.end_time() / exact.landing_time() - 1.0;
    let (drag, lost) = air(p, exact)?;
    let kept = landing_error(exact, naive)?;
    effect_card! { report,
        "friction, a tenth of what would hold the ladder":
            "mu / tan(theta0/2)" = 0.1, costs rubs, "of t_floor", measured found;
        "air drag on a light ladder (4 kg/m, 8 cm solid width)":
            "rho C w l^2 / m" = drag, costs 0.5 * lost, "of omega_floor";
        "one-sided contact of the wall":
            "pull / (m g) at the floor, if kept" = 1.5 * cos(p.angle), costs kept, "of omega_floor", included;
    }
}
