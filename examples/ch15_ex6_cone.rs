//! Exercise 15.6: a solid cone that lies on a table and rolls about its vertex.

#[path = "ch15_ex6_cone/cone.rs"]
pub mod cone;
#[path = "ch15_ex6_cone/figures.rs"]
mod figures;
#[path = "ch15_ex6_cone/physics.rs"]
pub mod physics;

use cone::{blown, left_to_itself, level, spin_at_rest};
use kit::interval::above_to;
use kit::prelude::*;
use physics::*;
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::integrators::{Dop853, Event, Integrator, Work, ode, size_or};

parameters! {
    /// The cone of the exercise; the notes leave all numbers open.
    pub struct Parameters {
        /// mass of the cone
        mass: number(2.0, "kg", from_to(1e-6, 1e6).usually(0.1, 5.0)).drawn(0.5, 4.0, 0.5);
        /// its height
        height: number(0.3, "m", from_to(1e-6, 1e6).usually(0.05, 1.0)).drawn(0.15, 0.50, 0.05);
        /// half of the angle at its vertex
        half_angle: number(0.4, "rad", from_to(1e-3, 1.5698).because("a thinner or flatter cone needs more digits than doubles have").usually(0.1, 1.2)).drawn(0.25, 0.70, 0.05).open("half of the angle at the vertex", "slender", "flat");
        /// rate at which the line of contact turns about the vertical
        rate: number(1.5, "rad/s", from_to(-1e6, 1e6).but_zero("at rest nothing rolls").usually(0.5, 6.0)).drawn(0.8, 2.4, 0.2);
        /// coefficient of friction of cone and table
        friction: number(0.5, "-", above(0.0).usually(0.1, 1.5)).drawn(0.30, 0.80, 0.05);
        gravity: gravity(from_to(1e-6, 1e6).usually(1.0, 25.0));
        /// lever by which the pressure of the table runs ahead, for the claims about it
        rolling: effect(2e-5, "m", above_to(0.0, 1.0));
        /// density of the air that brakes it, for the claims about it
        air: effect(1.204, "kg/m^3", above_to(0.0, 1e6));
        /// error of a step of the simulations
        tolerance: number(1e-13, "-", from_to(1e-15, 1e-6));
    }
}

/// The rate at which the force has come to the rim, when the cone is made to roll ever faster.
pub fn tipping(p: &Parameters) -> Result<f64> {
    let (a, unit) = (p.half_angle, (p.gravity / p.height).sqrt());
    let slant = p.height / cos(a);
    let off = |rate: f64| borne_at(p, rate).map_or(f64::NAN, |d| d / slant - 1.0);
    let rim = Event::rising("at the rim", |_, y: &[f64; 1]| off(unit * y[0])).terminal();
    let law = ode(|_, _: &[f64; 1]| [1.0]).scaled(size_or([1.0; 1]));
    let run = Dop853::new(1e-12)?.solve(&law, 0.0, &[0.01], 100.0, &[rim])?;
    Ok(unit * run.end_state()[0])
}

/// The attitude after one circuit by steps, from the angular velocity alone: q' = omega q/2.
fn circuit(a: f64, step: f64) -> Result<(Attitude, Work)> {
    let law = ode(|turn, &[w, x, y, z]: &[f64; 4]| {
        let [a, b, c] = (level(turn) * angular_velocity(a) * 0.5).to_array();
        let (scalar, along) = (-a * x - b * y - c * z, a * w + b * z - c * y);
        [scalar, along, b * w + c * x - a * z, c * w + a * y - b * x]
    })
    .scaled(size_or([1.0; 4]));
    let (q, work) = Dop853::new(step)?.advance(&law, 0.0, &rolled(a, 0.0)?.quaternion(), TAU)?;
    Ok((Attitude::from_quaternion(q)?, work))
}

fn claims(p: &Parameters, report: &mut Report) -> Result<()> {
    let (a, m, h, rate) = (p.half_angle, p.mass, p.height, p.rate);
    let (tips, slips, frequency) = (tips(a), p.friction / needed(a, 1.0), (p.gravity / h).sqrt());
    let (tipping_rate, slipping_rate) = (frequency * tips.sqrt(), frequency * slips.sqrt());
    allowed! {
        "|rate|, beyond which the cone tips,": rate.abs(), above_to(0.0, tipping_rate), "faster, it tips over its rim";
        "|rate|, beyond which the cone slips,": rate.abs(), above_to(0.0, slipping_rate), "faster, it slips";
    }?;
    let ((s, c), unit, w) = (sincos(a), m * h * h * rate, h * rate * rate / p.gravity);
    let (omega, energy) = (rate * angular_velocity(a), kinetic_energy(a));
    let ([rho, up], spin) = (angular_momentum(a), spin_at_rest(a, level(0.0), rate)?);
    // The spin about the axis and the turning about the vertical, added.
    let net = SpaceVector::new(spin * c, 0.0, rate + spin * s);
    let (sums, near, size) = (summed(p, rate)?, 3e-11 / (s * s * c * c), unit * hypot(rho, up));
    // At the tipping of a thin cone what the particles need is w times what the weight gives.
    let at_rim = near.max(3e-12 * tips / (s * s * c * c));
    // With the friction needed at two rates, which grows as the square of the rate.
    let friction = |rate: f64| -> Result<f64> { Ok(-summed(p, rate)?.force.x() / (m * p.gravity)) };
    claims! { report,
        /// angular velocity, along rho
        omega: omega, "rad/s", "the line of contact at rest" => net.x(), within near * omega.abs(), in "The motion":
            rate => "that is how fast the line of contact turns, not the cone",
            rate / s => "that is the spin about the axis of the cone, relative to the line of contact",
            -omega => "which way must the axis of the cone move?";
        /// its upward part
        omega_up: 0.0, "rad/s", "the line of contact at rest" => net.z(), within near * omega.abs();
        /// angular momentum about the vertex, along rho
        l_rho: unit * rho, "kg m^2/s", "24 particles" => sums.angular_momentum.x(), within near * size, in "The motion":
            -0.3 * unit * tan(a) => "the axis of the cone is not along rho";
        /// angular momentum about the vertex, upward
        l_up: unit * up, "kg m^2/s", "24 particles" => sums.angular_momentum.z(), within near * size, in "The motion":
            0.0 => "the angular velocity is level; is the angular momentum parallel to it?";
        /// kinetic energy
        energy: unit * rate * energy, "J", "24 particles" => sums.kinetic_energy, within near * unit * rate, in "The motion":
            unit * rate * energy * 2.0 => "half of that",
            0.5 * m * (0.75 * h * c * rate) * (0.75 * h * c * rate) => "that is the part of the centre of mass only";
        /// turns about its axis in a circuit, seen from the line of contact
        turns: 1.0 / s, "-", "the line of contact at rest" => -spin / rate, within near / s, in "The motion":
            1.0 / tan(a) => "the table meets the slanted side, not the base";
        /// where the table bears the cone, from the vertex
        borne_at: h * centre_of_pressure(a, w), "m", "24 particles" => borne_at(p, rate)?, within near * h, in "The forces":
            0.75 * h * c => "so it is at rest";
        /// friction needed, over the weight
        needed: needed(a, w), "-", "24 particles" => friction(rate)?, within near * needed(a, w), in "The forces":
            w * c => "how far from the vertex is the centre of mass?", 0.75 * w => "the axis of the cone is not level";
        /// rate at which it tips over the rim
        omega_tip: tipping_rate, "rad/s", "made to roll ever faster" => tipping(p)?, within at_rim * tipping_rate, in "The forces":
            frequency * (1.0 / c / -rho).sqrt() => "the weight has a moment too";
        /// rate at which it slips
        omega_slip: slipping_rate, "rad/s", "24 particles" => rate.abs() * (p.friction / friction(rate)?).sqrt(), within near * slipping_rate,
        in "The forces":
            frequency * (p.friction / c).sqrt() => "how far from the vertex is the centre of mass?";
        /// coefficient of friction above which it tips before it slips
        mu_tip: needed(a, tips), "-", "24 particles" => friction(tipping(p)?)?, within at_rim * needed(a, tips);
    }
}

/// Slender cones, flat ones, and a rate so slow that it hardly moves.
fn limits(_: &Parameters, report: &mut Report) -> Result<()> {
    limits! { report,
        /// a rod 3/5 M h^2 on end, and the spin, ever faster: 3/10 + 3/20
        "alpha = 0.001: T/(M h^2 Omega^2)": kinetic_energy(1e-3) => 0.45, within 1e-6;
        /// a rod that sweeps round
        "alpha = 0.001: L_Z/(M h^2 Omega)": angular_momentum(1e-3)[1] => 0.6, within 1e-6;
        /// a wobbling plate of the radius R: 3/20 M R^2 about a diameter, at Omega h/R
        "alpha = pi/2 - 0.001: T/(M h^2 Omega^2)": kinetic_energy(TAU / 4.0 - 1e-3) => 0.075, within 1e-6;
        /// at rest the table bears it below its centre of mass
        "w = 0: d/(h cos(alpha))": centre_of_pressure(0.4, 0.0) / cos(0.4) => 0.75, within 1e-15;
        /// then the moment 3/20 M h R Omega^2, which turns L, is M g R
        "alpha = pi/2 - 0.001: w at tipping": tips(TAU / 4.0 - 1e-3) => 20.0 / 3.0, within 1e-4;
    }
}

/// What `--with rolling` and `--with air` add: the rate that is left after a circuit, if nothing drives the cone.
fn left(p: &Parameters, report: &mut Report) -> Result<()> {
    let (a, h, rate) = (p.half_angle, p.height, p.rate);
    let inertia = 2.0 * p.mass * h * h * kinetic_energy(a);
    if let Some(lever) = p.rolling {
        let bears = p.mass * p.gravity * lever * -angular_velocity(a);
        let lost = 2.0 * TAU * bears / (inertia * rate * rate);
        allowed! {
            "part of the energy that rolling resistance takes in a circuit": lost, between(0.0, 0.9), "it would stop within a circuit";
        }?;
        let ran = left_to_itself(lost, [inertia, rate], |_| bears)?;
        claims! { report,
            /// with rolling resistance: rate after a circuit
            rolled_rate: rate * (1.0 - lost).sqrt(), "rad/s", "simulated" => rate * (1.0 - ran.map_or(1.0, |run| run.0)).sqrt(), within 1e-10 * rate;
        }?;
    }
    blown(p, report, a, inertia)
}

/// The card of effects: hard smooth surfaces, in air.
fn effects(p: &Parameters, report: &mut Report) -> Result<()> {
    let (a, h, rate) = (p.half_angle, p.height, p.rate);
    // The pressure of a rolling body lies ahead of the contact by this lever, m.
    let (w, lever) = (h * rate * rate / p.gravity, 2e-5);
    let bears = p.mass * p.gravity * lever * -angular_velocity(a);
    let energy = p.mass * h * h * rate * rate * kinetic_energy(a);
    // As if all of its side met the air as fast as its centre of mass.
    let (side, speed) = (h * h * tan(a), 0.75 * h * rate * cos(a));
    let air = 0.5 * 1.204 * side * speed * speed * TAU * 0.75 * h * cos(a) / energy;
    let rolling = bears * TAU / energy;
    let (turning, strips) = ([2.0 * energy / (rate * rate), rate], p.air(a, 1.204));
    let rolled = left_to_itself(rolling, turning, |_| bears)?;
    let blown = left_to_itself(air, turning, |rate| strips * rate * rate)?;
    effect_card! { report,
        "friction, as far as it is needed": "3 w cos(alpha)/(4 mu)" = needed(a, w) / p.friction, costs 1.0, "of omega: it would slide", included;
        "rolling resistance": "b/h" = lever / h, costs rolling.min(1.0), "of the energy in a circuit",
            measured rolled.map(|run| run.0), within 1e-10, at_work rolled.map(|run| run.1);
        "drag of the air": "rho h S/M" = 1.204 * h * side / p.mass,
            costs air.min(1.0), "of the energy in a circuit, to first order",
            measured blown.map(|run| run.0), within 1e-10, at_work blown.map(|run| run.1);
    }
}

/// The accuracy strip: the attitude after a circuit.
fn accuracy(p: &Parameters, report: &mut Report) -> Result<()> {
    let (a, exact) = (p.half_angle, rolled(p.half_angle, TAU)?);
    let asked = [p.tolerance, 1e-6, 1e-8, 1e-10, 1e-12, 1e-15];
    let error = move |run: &(Attitude, Work)| Ok(run.0.angle_to(&exact));
    report.in_closed_form(move |part| rolled(a, part * TAU));
    report.stepped(asked, move |step| circuit(a, step), |run| run.1, error)
}

example! {
    ch15_ex6_cone: "Exercise 15.6: a solid cone that rolls on a table about its vertex";
    "A cone that rolls about its vertex", "A solid cone lies on a table and rolls, without slipping, about its vertex.",
    [claims, left, limits, effects, accuracy];
    figures::figures, figures::trajectory, figures::moving_picture
}
