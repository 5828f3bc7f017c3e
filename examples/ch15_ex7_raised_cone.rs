//! Exercise 15.7: a cone whose vertex is held above the table, so that its axis is level.

#[path = "ch15_ex6_cone/cone.rs"]
pub mod cone;
#[path = "ch15_ex7_raised_cone/figures.rs"]
mod figures;
#[path = "ch15_ex7_raised_cone/physics.rs"]
pub mod physics;

use cone::{UP, blown, left_to_itself, level, spin_at_rest};
use kit::prelude::*;
use physics::*;
use rotation_dynamics::accuracy::Problem;
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::State;

parameters! {
    /// The cone of the exercise; the notes leave all numbers open.
    pub struct Parameters {
        /// mass of the cone
        mass: number(2.0, "kg", from_to(1e-6, 1e6).usually(0.1, 5.0)).drawn(0.5, 4.0, 0.5);
        /// its height
        height: number(0.3, "m", from_to(1e-6, 1e6).usually(0.05, 1.0)).drawn(0.15, 0.50, 0.05);
        /// half of the angle at its vertex
        half_angle: number(0.4, "rad", from_to(1e-3, 1.5698).because("a thinner or flatter cone needs more digits than doubles have").usually(0.1, 1.2)).drawn(0.25, 0.70, 0.05).open("half of the angle at the vertex", "slender", "flat");
        /// rate at which its axis turns about the vertical
        rate: number(1.5, "rad/s", from_to(-1e6, 1e6).but_zero("at rest nothing rolls").usually(0.5, 12.0)).drawn(1.0, 4.0, 0.5);
        gravity: gravity(from_to(1e-6, 1e6).usually(1.0, 25.0));
        /// density of the air that brakes it, for the claims about it
        air: effect(1.204, "kg/m^3", above_to(0.0, 1e6));
        /// error of the solved attitude
        tolerance: number(1e-9, "rad", from_to(1e-11, 1e-3));
    }
}

/// For how long the cone is followed without the table, s: for a circuit, unless it is so slow that
/// the weight would have brought it down many times before. And the error asked of that: of a thin
/// cone, which spins 1/tan(alpha) times as fast as it goes round, doubles do not give less.
fn followed(p: &Parameters) -> (f64, f64) {
    let (circuit, s) = (TAU / p.rate.abs(), sin(p.half_angle));
    (circuit.min(30.0 * (p.height / p.gravity).sqrt()), p.tolerance.max(4e-13 / (s * s)))
}

/// The rate beyond which the joint must pull the vertex down.
fn lifting(p: &Parameters) -> f64 {
    (p.gravity / (1.2 * p.height * tan(p.half_angle))).sqrt()
}

/// How high the axis points in the end, rad, with that force in place of the table.
pub fn rises(p: &Parameters, n: f64) -> Result<f64> {
    let ((scene, start), (end, asked)) = (without_table(p, n)?, followed(p));
    let axis = scene.solve(&start, end, asked)?.state.attitude.axis();
    Ok(atan2(axis.z(), hypot(axis.x(), axis.y())))
}

fn claims(p: &Parameters, report: &mut Report) -> Result<()> {
    let (a, m, h, rate) = (p.half_angle, p.mass, p.height, p.rate);
    allowed! {
        "h Omega^2/g": h * rate * rate / p.gravity, from_to(1e-3, 1e3), "the weight or the turning is lost beside the other";
    }?;
    let (s, c, unit, weight) = (sin(a), cos(a), m * h * h * rate, m * p.gravity);
    let ([along, up], [rho, vertical]) = (angular_velocity(a), angular_momentum(a));
    let (w, energy) = (h * rate * rate / p.gravity, unit * rate * kinetic_energy(a));
    let contact = level(0.0) * h - UP * (h * tan(a));
    let (spin, sums) = (spin_at_rest(0.0, contact, rate)?, summed(p, rate)?);
    let (near, size) = (3e-11 / (s * s * c * c), unit * hypot(rho, vertical));
    let (n, lifted, (_, asked)) = (weight * pressure(a, w), lifting(p), followed(p));
    // As the square of the rate, the force grows from that of the cone at rest.
    let grown = pressed(p, rate)? / weight - 0.75;
    claims! { report,
        /// angular velocity, along rho
        omega_rho: rate * along, "rad/s", "the lowest point at rest" => spin, within near * rate / s, in "The motion":
            rate / s => "the axis is not the line of points at rest",
            -rate * along => "which way must the upper side of the cone move?";
        /// its size
        omega: rate.abs() * hypot(along, up), "rad/s", "the lowest point at rest" => hypot(spin, rate), within near * rate / s, in "The motion":
            -rate * along => "that is the spin alone", rate => "that is the part about the vertical alone";
        /// angular momentum about the vertex, along rho
        l_rho: unit * rho, "kg m^2/s", "24 particles" => sums.angular_momentum.x(), within near * size, in "The motion":
            -unit * rho => "which way does the spin point?";
        /// angular momentum about the vertex, upward
        l_up: unit * vertical, "kg m^2/s", "24 particles" => sums.angular_momentum.z(), within near * size, in "The motion":
            0.6 * unit => "the cone is not a thin rod",
            unit * (0.0375 + 0.15 * tan(a) * tan(a)) => "that is about the centre of mass";
        /// kinetic energy
        energy: energy, "J", "24 particles" => sums.kinetic_energy, within near * energy, in "The motion":
            2.0 * energy => "half of that", energy * c * c => "that is the cone that lies on the table",
            0.5 * unit * rate * vertical => "the cone spins as well";
        /// turns about its axis in a circuit, seen from the axis
        turns: 1.0 / tan(a), "-", "the lowest point at rest" => -spin / rate, within near / s, in "The motion":
            1.0 / s => "that is the cone that lies on the table";
        /// force of the table
        pressure: n, "N", "24 particles" => pressed(p, rate)?, within near * n, in "The forces":
            weight => "the joint bears a part of the weight", 0.75 * weight => "so it is at rest";
        /// how high the axis points after a circuit, with that force in place of the table
        level: 0.0, "rad", "solved" => rises(p, n)?, within 10.0 * asked;
        /// rate beyond which the joint must pull the vertex down
        omega_lift: lifted, "rad/s", "24 particles" => rate.abs() * (0.25 / grown).sqrt(), within near * lifted * (1.0 + 1.0 / grown),
        in "The forces":
            2.0 * lifted => "at rest the table bears three quarters already";
    }
}

/// Slender cones, flat ones, and a cone at rest.
fn limits(_: &Parameters, report: &mut Report) -> Result<()> {
    let flat = TAU / 4.0 - 1e-3;
    let disc = |x: f64| x / (tan(flat) * tan(flat));
    limits! { report,
        /// a slender cone does not care whether its vertex is raised: 3/10 + 3/20
        "alpha = 0.001: T/(M h^2 Omega^2)": kinetic_energy(1e-3) => 0.45, within 1e-6;
        /// a cone pressed flat, denser in its middle than a plate, about a diameter: half of 3/20 M R^2
        "alpha = pi/2 - 0.001: T/(M R^2 Omega^2)": disc(kinetic_energy(flat)) => 0.075, within 1e-6;
        /// at rest the table bears what the lever leaves to it
        "w = 0: N/(M g)": pressure(0.4, 0.0) => 0.75, within 1e-15;
        /// as a thin rod it presses no more for going round
        "alpha = 0.001, w = 1: N/(M g)": pressure(1e-3, 1.0) => 0.75, within 1e-3;
    }
}

/// What `--with air` adds: the rate that is left after a circuit, if nothing drives the cone.
fn left(p: &Parameters, report: &mut Report) -> Result<()> {
    let unit = p.mass * p.height * p.height;
    blown(p, report, 0.0, 2.0 * unit * kinetic_energy(p.half_angle))
}

/// The card of effects: hard smooth surfaces, in air.
fn effects(p: &Parameters, report: &mut Report) -> Result<()> {
    let (a, h, rate) = (p.half_angle, p.height, p.rate);
    let (w, lever, friction) = (h * rate * rate / p.gravity, 2e-5, 0.05);
    let energy = p.mass * h * h * rate * rate * kinetic_energy(a);
    // The pressure of a rolling body lies ahead of the contact by this lever, m.
    let bears = |w: f64| p.mass * p.gravity * pressure(a, w) * lever / tan(a);
    let rolling = bears(w) * TAU / energy;
    // Each strip of the side meets the air at its own speed: two fifths of what it would be at the
    // speed of the base.
    let (side, speed) = (h * h * tan(a), h * rate);
    let air = 0.4 * 0.5 * 1.204 * side * speed * speed * TAU * h / energy;
    let (turning, strips) = ([2.0 * energy / (rate * rate), rate], p.air(0.0, 1.204));
    // Slower, it also presses less.
    let pressed = |rate: f64| bears(h * rate * rate / p.gravity);
    let rolled = left_to_itself(rolling, turning, pressed)?;
    let blown = left_to_itself(air, turning, |rate| strips * rate * rate)?;
    effect_card! { report,
        "radial friction at the rim": "mu tan(alpha)" = friction * tan(a), costs friction * tan(a), "of N, at most";
        "rolling resistance": "b/h" = lever / h, costs rolling.min(1.0), "of the energy in a circuit, to first order",
            measured rolled.map(|run| run.0), within 1e-10, at_work rolled.map(|run| run.1);
        "drag of the air": "rho h S/M" = 1.204 * h * side / p.mass,
            costs air.min(1.0), "of the energy in a circuit, to first order",
            measured blown.map(|run| run.0), within 1e-10, at_work blown.map(|run| run.1);
    }
}

/// The accuracy strip: the attitude after a circuit, without the table.
fn accuracy(p: &Parameters, report: &mut Report) -> Result<()> {
    let (a, h, rate) = (p.half_angle, p.height, p.rate);
    let n = p.mass * p.gravity * pressure(a, h * rate * rate / p.gravity);
    let ((scene, start), (end, asked)) = (without_table(p, n)?, followed(p));
    let [rho, up] = angular_momentum(a);
    let momentum = (level(rate * end) * rho + UP * up) * (p.mass * h * h * rate);
    let exact = State::new(rolled(a, rate * end)?, momentum)?;
    let attitude = move |t: f64| rolled(a, rate * t).unwrap_or(Attitude::IDENTITY);
    let problem = Problem::new(scene, start, end, exact).in_closed_form(attitude);
    report.strip(&problem, &[asked, 1e-6, 1e-10])
}

example! {
    ch15_ex7_raised_cone: "Exercise 15.7: a cone with a level axis, its vertex held and its rim rolling";
    "A cone with its vertex raised", "A solid cone with a level axis: its vertex is held, its rim rolls on a table.",
    [claims, left, limits, effects, accuracy];
    figures::figures, figures::trajectory, figures::moving_picture
}
