//! A rod on a hinge is hit by a particle that sticks: example 1 of Section 5 of the notes.

#[path = "ch15_5_rod_and_particle/figures.rs"]
mod figures;
#[path = "ch15_5_rod_and_particle/strike.rs"]
pub mod strike;

use core::f64::consts::{FRAC_PI_2, PI};
use kit::prelude::*;
use rotation_dynamics::frame::DesignVector;
use rotation_dynamics::inertia::{MassProperties, solids};
use strike::{Blow, Strike};

parameters! {
    /// Rod and particle; the notes give both the same mass.
    pub struct Parameters {
        /// mass of the rod
        mass: number(0.8, "kg", from_to(1e-6, 1e6).usually(0.1, 3.0));
        /// mass of the particle
        particle: number(0.8, "kg", from_to(1e-6, 1e6).usually(0.1, 3.0)).open("mass of the particle", "light", "heavy");
        /// length of the rod
        length: number(1.2, "m", from_to(1e-3, 1e3).because("beyond, the simulation loses digits").usually(0.5, 2.0));
        /// speed of the particle
        speed: number(5.0, "m/s", from_to(-1e6, 1e6).but_zero("at rest nothing is hit").usually(1.0, 10.0)).open("speed of the particle", "slow", "fast");
        /// coefficient of friction of the table, for the claims about what comes later
        table: effect(0.1, "-", above_to(0.0, 1e6));
        /// error of the simulation: from 2e-12 to 1e-3
        tolerance: number(1e-11, "-", from_to(2e-12, 1e-3));
    }
}

// ANCHOR: answer
/// What the conservation of angular momentum about the hinge gives.
pub struct Answer {
    pub inertia: f64,  // of rod and particle about the hinge
    pub momentum: f64, // angular momentum about the hinge, before and after
    pub angular_velocity: f64,
    pub hinge: f64, // impulse of the hinge on the rod, along the particle's velocity
    pub energies: [f64; 2], // kinetic energy before and after
}

impl Answer {
    pub fn new(p: &Parameters) -> Self {
        let (m, v, arm) = (p.particle, p.speed, 0.5 * p.length);
        let inertia = p.mass * p.length * p.length / 12.0 + m * arm * arm;
        let momentum = m * v * arm;
        let angular_velocity = momentum / inertia;
        // After it the rod's middle rests, and the particle has Omega l/2.
        let hinge = m * (angular_velocity * arm - v);
        let energies = [0.5 * m * v * v, 0.5 * momentum * angular_velocity];
        Self { inertia, momentum, angular_velocity, hinge, energies }
    }
}
// ANCHOR_END: answer

/// The scene of these parameters.
pub fn scene(p: &Parameters, hinged: bool) -> Strike {
    let (rod, particle, length, speed) = (p.mass, p.particle, p.length, p.speed);
    Strike { rod, particle, length, speed, hinged, arm: 0.5 * length, rub: 0.0 }
}

/// The units of time, l/v, for which the simulation goes on after the impact.
const END: f64 = 4.2;

fn claims(p: &Parameters, report: &mut Report) -> Result<()> {
    let (a, m, v, l, scene) = (Answer::new(p), p.particle, p.speed, p.length, scene(p, true));
    let blow = Blow::new(scene, p.tolerance, 0.5, END)?;
    let (before, after) = (blow.before, blow.after);
    // The rod lies along the third axis.
    let particle = MassProperties::of_points(&[(m, at_end(p))])?;
    let moment = about_hinge(&[solids::rod(p.mass, l)?, particle])?;
    let kept = scene.angular_momentum(&after, [0.0, 0.0]);
    let [push, _] = scene.momentum(&after);
    let lost = scene.energy(&before) - scene.energy(&after);
    // The force of the hinge from two values of the momentum, a little later.
    let (t, h) = (0.5 * scene.unit(), 1e-4 * scene.unit());
    let [early, late] = [scene.momentum(&blow.at(t - h)?), scene.momentum(&blow.at(t + h)?)];
    let pull = hypot(late[0] - early[0], late[1] - early[1]) / (2.0 * h);
    let (w, [energy, rest]) = (a.angular_velocity, a.energies);
    let (alone, force) = (a.inertia - m * l * l / 4.0, m * w * w * 0.5 * l);
    // Before the impact nothing turns: velocities just after it are as good as its impulses.
    let bound = 1e-12;
    claims! { report,
        /// moment of inertia of rod and particle about the hinge
        inertia: a.inertia, "kg m^2", "tensors of the parts" => moment, within 1e-14 * a.inertia, in "The impact":
            alone => "that is the rod alone";
        /// angular momentum about the hinge, before and after
        momentum: a.momentum, "kg m^2/s", "contacts simulated, after" => kept, within bound * a.momentum, in "The impact":
            m * v * l => "the rod is hinged at its middle";
        /// angular velocity after
        angular_velocity: w, "rad/s", "contacts simulated" => after.v[2], within bound * w, in "The impact":
            2.0 * v / l => "momentum is not kept: the hinge pushes",
            (m * v * v / a.inertia).sqrt() => "energy is not kept: the particle sticks",
            a.momentum / alone => "the particle turns with the rod";
        /// impulse of the hinge on the rod, along the velocity of the particle
        hinge: a.hinge, "N s", "momentum, simulated" => push - m * v, within bound * m * v, in "The impact":
            -a.hinge => "that is the impulse on the hinge", 0.0 => "what stops the middle of the rod?";
        /// kinetic energy after
        energy: rest, "J", "contacts simulated" => scene.energy(&after), within bound * energy, in "The impact":
            energy => "the particle sticks";
        /// part of it that is lost
        lost: 1.0 - rest / energy, "-", "contacts simulated" => lost / energy, within bound, in "The impact";
        /// momentum after, along the velocity of the particle
        push: m * v + a.hinge, "kg m/s", "contacts simulated" => push, within bound * m * v;
        /// force of the hinge from then on, N
        force: force, "N", "change of the momentum" => pull, within 1e-6 * force;
    }
}

/// The end of the rod that is hit, on the axes of a rod along the third.
fn at_end(p: &Parameters) -> DesignVector {
    DesignVector::new(0.0, 0.0, -0.5 * p.length)
}

/// The moment of these parts about the hinge.
fn about_hinge(parts: &[MassProperties]) -> Result<f64> {
    let tensor = MassProperties::of_parts(parts)?.about(DesignVector::zero())?;
    Ok(tensor.moment_about(DesignVector::new(1.0, 0.0, 0.0))?)
}

/// What `--with table` adds: where friction stops the rod, if each piece is braked with what it weighs.
fn on_table(p: &Parameters, report: &mut Report) -> Result<()> {
    let Some(rub) = p.table else { return Ok(()) };
    let (a, l, w) = (Answer::new(p), p.length, Answer::new(p).angular_velocity);
    let braking = rub * 9.80665 * l * (0.25 * p.mass + 0.5 * p.particle) / a.inertia;
    let (time, angle) = (w.abs() / braking, 0.5 * w * w / braking);
    allowed! {
        "angle until the table stops it": angle, from_to(1e-3, 1e3), "it stops at once, or after too many turns";
    }?;
    let (strike, half) = (Strike { rub, ..scene(p, true) }, 0.5 * time);
    let end = Blow::new(strike, 1e-6, 0.5, half / strike.unit())?.end()?;
    claims! { report,
        /// with friction of the table: time from the impact until the rod stops
        stop_time: time, "s", "rate after half of it, simulated" => w / (w - end.v[2]) * half, within 1e-5 * time;
        /// angle by which it turns until then
        stop_angle: angle, "rad", "angle after half of it, simulated" => end.q[2].abs() / 0.75, within 1e-5 * angle;
    }
}

/// The answer for the ratio particle over rod, in units of the rod, its length and the speed.
fn ratio(particle: f64) -> Answer {
    let (mass, length, speed) = (1.0, 1.0, 1.0);
    Answer::new(&Parameters { mass, particle, length, speed, ..Parameters::default() })
}

fn limits(_: &Parameters, report: &mut Report) -> Result<()> {
    let ([light, heavy], equal) = ([1e-9, 1e9].map(ratio), ratio(1.0));
    limits! { report,
        /// a heavy particle hardly notices the rod: v is the speed of its end
        "m/M to infinity: Omega l/(2 v)": 0.5 * heavy.angular_velocity => 1.0, within 1e-8;
        /// and loses no energy
        "m/M to infinity: energy after/before": heavy.energies[1] / heavy.energies[0] => 1.0, within 1e-8;
        /// a light one is stopped
        "m/M to 0: energy after/before": light.energies[1] / light.energies[0] => 0.0, within 1e-8;
        /// the rod behaves as a third of its mass at its end
        "m/M to 0: Omega M l/(6 m v)": light.angular_velocity / 6e-9 => 1.0, within 1e-8;
        /// the notes' case
        "m = M: Omega l/v": equal.angular_velocity => 1.5, within 1e-15;
        /// a quarter of the momentum goes into the hinge
        "m = M: hinge/(M v)": equal.hinge => -0.25, within 1e-15;
    }
}

/// Hinge of 5 mm radius with a friction of 0.3, a ball of steel, a rod 2 cm thick; table 0.1.
fn effects(p: &Parameters, report: &mut Report) -> Result<()> {
    let (a, scene, l, m) = (Answer::new(p), scene(p, true), p.length, p.particle);
    let (w, pin) = (a.angular_velocity, 0.3 * 0.005);
    let hinge = pin * a.hinge.abs() / a.momentum.abs();
    let thick = p.mass * 0.02 * 0.02 / 12.0 / a.inertia;
    let radius = cbrt(3.0 * m / (4.0 * PI * 7850.0));
    let ball = (0.4 + 1.0) * m * radius * radius / a.inertia;
    let contact = 1e-3 * w;
    let rub = 0.1 * 9.80665 * l * (0.25 * p.mass + 0.5 * m) / (a.inertia * w * w);
    // How much slower solids turn than rod and point, with the same angular momentum.
    let slower =
        |rod, particle| Ok::<_, kit::Error>(w - a.momentum / about_hinge(&[rod, particle])?);
    let point = MassProperties::of_points(&[(m, at_end(p))])?;
    let broad = solids::cuboid(p.mass, 0.02, 0.02, l)?;
    let on_face = at_end(p) + DesignVector::new(0.0, radius, 0.0);
    let sphere = solids::sphere(m, radius)?.displaced(on_face)?;
    let (([_, behind], work), slack) = (scene.pressed(0.0)?, 1e-13 * w);
    // A pin as thick as the lever is long lets nothing turn, and a rough table stops all.
    let rough = when(pin < 0.25 * l, || scene.pressed(pin))?;
    let (on_table, until) = (Strike { rub: 0.1, ..scene }, 1.0 / (w.abs() * scene.unit()));
    let braked = when(rub < 0.5, || Blow::new(on_table, 1e-8, 0.5, until))?;
    let after = braked.as_ref().map(Blow::end).transpose()?;
    effect_card! { report,
        "friction in the hinge, impact": "mu r_h J_h/L" = hinge, costs hinge * w, "rad/s",
            measured rough.map(|([part, _], _)| (1.0 - part) * w), within slack, at_work rough.map(|(_, work)| work);
        "thickness of the rod": "M b^2/(12 I0)" = thick, costs thick * w, "rad/s", measured slower(broad, point)?, within slack;
        "size of the particle, a ball": "(2/5 + 1) m r^2/I0" = ball, costs ball * w, "rad/s",
            measured slower(solids::rod(p.mass, l)?, sphere)?, within slack;
        "the contact lasts 1 ms": "Omega t_c" = contact, costs 0.5 * contact, "rad of the angle",
            measured behind * contact, at_work work;
        "friction of the table": "mu g l (M/4 + m/2)/(I0 Omega^2)" = rub, costs rub.min(1.0) * w, "rad/s in the time 1/Omega",
            measured after.map(|state| w - state.v[2]), within 1e-8 * (1.0 + w.abs()), at_work braked.map(|blow| blow.work());
    }
}

/// The accuracy strip: the angle at the end.
fn accuracy(p: &Parameters, report: &mut Report) -> Result<()> {
    let scene = scene(p, true);
    let turned = Answer::new(p).angular_velocity * END * p.length / p.speed.abs();
    let asked = [p.tolerance, 1e-3, 1e-6, 1e-9, 1e-13];
    let run = move |tolerance| Blow::new(scene, tolerance, 0.5, END);
    let error = move |blow: &Blow| Ok((blow.end()?.q[2] - turned).abs());
    report.in_closed_form(move |part| part * turned);
    report.controlled("contacts by DOP853", asked, run, Blow::work, error)
}

example! {
    ch15_5_rod_and_particle: "A rod on a hinge is hit by a particle that sticks";
    "A hinged rod hit by a particle", "A particle hits the end of a rod that is hinged at its middle, and sticks.",
    [claims, on_table, limits, effects, accuracy];
    figures::figures, figures::trajectory, figures::moving_picture
}
