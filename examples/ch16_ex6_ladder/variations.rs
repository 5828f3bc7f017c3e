//! What changes if an assumption goes: the mass is spread differently, the
//! surfaces rub, the air drags.

use super::{Parameters, Sliding, Solved, Wall, uniform};
use core::f64::consts::FRAC_PI_2;
use rotation_dynamics::Result;
use rotation_dynamics::exact::ladder::Ladder;
use rotation_dynamics::math::{cos, sincos, tan};
use rotation_dynamics::planar::{Condition, Next, Phased, Run, simulate_within};
use rotation_dynamics::report::{EffectEntry, Report, Table, supported_digits};

/// Relative error asked for in this file.
const TOLERANCE: f64 = 1e-9;

/// The mass spread differently, with the centre in the middle still.
pub fn mass(p: &Parameters) -> Result<Table> {
    let columns = [
        "mass",
        "inertia",
        "height ratio",
        "t_release",
        "omega_floor",
    ];
    let mut table = Table::new("mass", columns)?;
    let spreads = [
        (0.3, "mostly in the middle"),
        (1.0, "uniform"),
        (3.0, "at both ends"),
    ];
    let end = 4.0 * Ladder::new(p.length, p.gravity, p.angle)?.landing_time();
    for (inertia, name) in spreads {
        let scene = Sliding {
            inertia,
            ..uniform(p)
        };
        let start = scene.at_rest(p.angle);
        let run = simulate_within(&scene, TOLERANCE, Wall::Touches, start, end)?.run;
        let let_go = run.transition("wall lets go")?;
        let lands = run.transition("lands")?;
        table.push([
            name.into(),
            inertia.to_string(),
            supported_digits(cos(let_go.before[0]) / cos(p.angle), 1e-7),
            supported_digits(let_go.t, 1e-7),
            supported_digits(lands.before[1], 1e-7),
        ])?;
    }
    Ok(table)
}

/// The uniform ladder with dry friction, coefficient `mu` at both ends, while it slides.
struct Rubbing {
    ladder: Sliding,
    mu: f64,
}

impl Rubbing {
    /// Forces of wall and floor per unit mass, and the angular acceleration. Friction
    /// points up at the wall and back at the foot.
    fn forces(&self, wall: Wall, [theta, omega, ..]: &[f64; 4]) -> (f64, f64, f64) {
        let (l, g, mu) = (self.ladder.length, self.ladder.gravity, self.mu);
        let (s, c) = sincos(*theta);
        // (l/6) alpha = turn_floor N_floor - turn_wall N_wall.
        let (turn_floor, turn_wall) = (s - mu * c, c + mu * s);
        let fall = g - 0.5 * l * c * omega * omega;
        match wall {
            Wall::Touches => {
                // Horizontal: N_wall - mu N_floor = push; vertical: N_floor + mu N_wall = lift,
                // each a constant plus a multiple of alpha.
                let (push, lift) = (
                    (-0.5 * l * s * omega * omega, 0.5 * l * c),
                    (fall, -0.5 * l * s),
                );
                let of_wall = |push, lift| (push + mu * lift) / (1.0 + mu * mu);
                let of_floor = |push, lift| (lift - mu * push) / (1.0 + mu * mu);
                let (wall_0, wall_1) = (of_wall(push.0, lift.0), of_wall(push.1, lift.1));
                let (floor_0, floor_1) = (of_floor(push.0, lift.0), of_floor(push.1, lift.1));
                let alpha = (turn_floor * floor_0 - turn_wall * wall_0)
                    / (l / 6.0 - turn_floor * floor_1 + turn_wall * wall_1);
                (wall_0 + wall_1 * alpha, floor_0 + floor_1 * alpha, alpha)
            }
            Wall::Free => {
                let floor = fall / (1.0 + 3.0 * s * turn_floor);
                (0.0, floor, 6.0 / l * turn_floor * floor)
            }
        }
    }
}

impl Phased<4> for Rubbing {
    type Phase = Wall;

    fn derivative(&self, phase: Wall, state: &[f64; 4]) -> [f64; 4] {
        let (wall, floor, alpha) = self.forces(phase, state);
        [state[1], alpha, state[3], wall - self.mu * floor]
    }

    fn conditions(&self, phase: Wall) -> Vec<Condition<'_, Wall, 4>> {
        let lies_flat = Condition::gap("lands", |y: &[f64; 4]| FRAC_PI_2 - y[0], Next::End);
        let mut conditions = vec![lies_flat];
        if phase == Wall::Touches {
            let force = |y: &[f64; 4]| self.forces(Wall::Touches, y).0;
            conditions.push(Condition::contact(
                "wall lets go",
                force,
                Next::Enter(Wall::Free),
            ));
        } else {
            let foot = |y: &[f64; 4]| y[3] + 0.5 * self.ladder.length * cos(y[0]) * y[1];
            conditions.push(Condition::gap("foot sticks", foot, Next::End));
        }
        conditions
    }

    fn scale(&self, state: &[f64; 4]) -> [f64; 4] {
        self.ladder.scale(state)
    }
}

/// The ladder stays where it is put if `mu` is at least this: tan(theta0/2).
fn holding_friction(p: &Parameters) -> f64 {
    tan(0.5 * p.angle)
}

/// How the motion goes with friction `mu`.
fn rubbing(p: &Parameters, mu: f64) -> Result<Run<Wall, 4>> {
    let scene = Rubbing {
        ladder: uniform(p),
        mu,
    };
    let start = scene.ladder.at_rest(p.angle);
    let end = 100.0 * Ladder::new(p.length, p.gravity, p.angle)?.landing_time();
    Ok(simulate_within(&scene, TOLERANCE, Wall::Touches, start, end)?.run)
}

/// Dry friction at both ends.
pub fn friction(p: &Parameters) -> Result<Table> {
    let columns = [
        "mu",
        "mu/tan(theta0/2)",
        "height ratio",
        "t_release/s",
        "t_floor/s",
    ];
    let mut table = Table::new("friction", columns)?;
    for part in [0.0, 0.1, 0.3, 0.6, 0.9] {
        let mu = part * holding_friction(p);
        let run = rubbing(p, mu)?;
        let mut cells = [
            supported_digits(mu, 1e-6),
            part.to_string(),
            "-".into(),
            "-".into(),
            "-".into(),
        ];
        for event in run.transitions() {
            match event.name {
                "wall lets go" => {
                    cells[2] = supported_digits(cos(event.before[0]) / cos(p.angle), 1e-7);
                    cells[3] = supported_digits(event.t, 1e-7);
                }
                "lands" => cells[4] = supported_digits(event.t, 1e-7),
                other => cells[4] = other.into(),
            }
        }
        table.push(cells)?;
    }
    let held = supported_digits(holding_friction(p), 1e-6);
    table.push([held.as_str(), "1", "-", "it stays", "it stays"])?;
    Ok(table)
}

/// Air: density (kg/m^3) and drag coefficient of a flat plate; the ladder: solid width
/// (m) of stiles and rungs, mass per length (kg/m).
const AIR: f64 = 1.204;
const DRAG: f64 = 1.2;
const WIDTH: f64 = 0.08;
const MASS_PER_LENGTH: f64 = 4.0;

/// The part of the fall's energy that air would take, to first order: the work of a
/// quadratic drag on the motion across the ladder, along the exact motion.
fn lost_to_air(p: &Parameters, ladder: &Ladder) -> Result<f64> {
    let steps = 400;
    let dt = ladder.landing_time() / f64::from(steps);
    let mut work = 0.0;
    for i in 0..steps {
        let state = ladder.at((f64::from(i) + 0.5) * dt)?;
        let (s, c) = sincos(state.theta);
        let vy = -0.5 * p.length * s * state.omega;
        let across = -c * state.vx_cm - s * vy;
        for j in 0..40 {
            let from_middle = p.length * ((f64::from(j) + 0.5) / 40.0 - 0.5);
            let speed = (across + state.omega * from_middle).abs();
            work += 0.5 * AIR * DRAG * WIDTH * speed * speed * speed * p.length / 40.0 * dt;
        }
    }
    let fall = MASS_PER_LENGTH * p.length * p.gravity * 0.5 * p.length * cos(p.angle);
    Ok(work / fall)
}

/// The card of effects: what was left out, and what that costs.
pub fn effects(p: &Parameters, solved: &Solved, report: &mut Report) -> Result<()> {
    let rubbing = rubbing(p, 0.1 * holding_friction(p))?;
    report.add_effect(EffectEntry {
        effect: "friction, a tenth of what would hold the ladder".into(),
        number: "mu / tan(theta0/2)".into(),
        value: 0.1,
        error: rubbing.end_time() / solved.exact.landing_time() - 1.0,
        unit: "of t_floor".into(),
        included: false,
    });
    report.add_effect(EffectEntry {
        effect: "air drag on a light ladder (4 kg/m, 8 cm solid width)".into(),
        number: "rho C w l^2 / m".into(),
        value: AIR * DRAG * WIDTH * p.length / MASS_PER_LENGTH,
        error: 0.5 * lost_to_air(p, &solved.exact)?,
        unit: "of omega_floor".into(),
        included: false,
    });
    report.add_effect(EffectEntry {
        effect: "one-sided contact of the wall".into(),
        number: "pull / (m g) at the floor, if kept".into(),
        value: 1.5 * cos(p.angle),
        error: super::landing_error(&solved.exact, &solved.naive)?,
        unit: "of omega_floor".into(),
        included: true,
    });
    Ok(())
}
