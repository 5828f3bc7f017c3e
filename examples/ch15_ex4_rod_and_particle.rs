//! Exercise 15.4: a free rod is hit at its end by a particle that sticks.

#[path = "ch15_ex4_rod_and_particle/figures.rs"]
mod figures;
#[path = "ch15_ex4_rod_and_particle/physics.rs"]
pub mod physics;
#[path = "ch15_5_rod_and_particle/strike.rs"]
pub mod strike;

use kit::prelude::*;
use physics::*;
use rotation_dynamics::accuracy::largest;
use rotation_dynamics::frame::DesignVector;
use rotation_dynamics::inertia::{MassProperties, solids};
use strike::{Blow, Strike};

parameters! {
    /// Rod and particle; the notes give both the same mass.
    pub struct Parameters {
        /// mass of the rod
        mass: number(0.8, "kg", from_to(1e-3, 1e3).because("beyond, the simulation loses digits").usually(0.1, 3.0));
        /// mass of the particle
        particle: number(0.8, "kg", from_to(1e-3, 1e3).because("beyond, the simulation loses digits").usually(0.1, 3.0)).open("mass of the particle", "light", "heavy");
        /// length of the rod
        length: number(1.2, "m", from_to(1e-3, 1e3).because("beyond, the simulation loses digits").usually(0.5, 2.0)).drawn(0.6, 2.0, 0.1);
        /// speed of the particle
        speed: number(5.0, "m/s", from_to(-1e3, 1e3).but_zero("at rest nothing is hit; faster, the simulation loses digits").usually(1.0, 10.0)).drawn(2.0, 9.0, 0.5).open("speed of the particle", "slow", "fast");
        /// error of the simulation: from 1e-12 to 1e-3
        tolerance: number(1e-11, "-", from_to(1e-12, 1e-3));
    }
}

/// One turn after the impact, in units of l/v.
fn turn(p: &Parameters) -> f64 {
    TAU / (Answer::new(p).angular_velocity.abs() * scene(p).unit())
}

fn claims(p: &Parameters, report: &mut Report) -> Result<()> {
    let (a, scene) = (Answer::new(p), scene(p));
    let blow = Blow::new(scene, p.tolerance, 0.5, turn(p))?;
    let (after, end) = (blow.after, blow.end()?);
    let (m, v, l, bound, whole) = (p.particle, p.speed, p.length, 1e-12, p.mass + p.particle);
    let [middle, _, w, particle, _] = after.v;
    let way = scene.centre(&end)[0] - scene.centre(&after)[0];
    let (rest, half) = (a.velocity / a.angular_velocity, 0.5 * m * v * l);
    // With a hinge the rod turns at this rate.
    let hinged = half / ((p.mass / 12.0 + 0.25 * m) * l * l);
    claims! { report,
        /// velocity of the centre of mass, before and after
        velocity: a.velocity, "m/s", "contacts simulated, after" => scene.momentum(&after)[0] / whole, within bound * v,
        in "(a) The centre of mass":
            0.5 * l * hinged => "that is the particle, with a hinge",
            -a.centre * hinged => "that is with the hinge", v => "the rod has to be carried along";
        /// angular momentum about the centre of mass, before and after
        about_centre: a.momentum, "kg m^2/s", "contacts simulated, after" => scene.angular_momentum(&after, scene.centre(&after)),
        within bound * half, in "(b) The angular momentum":
            half => "that is about the point where the middle of the rod was";
        /// about the point where the middle of the rod was
        about_middle: half, "kg m^2/s", "contacts simulated, after" => scene.angular_momentum(&after, [0.0, 0.0]),
        within bound * half, in "(b) The angular momentum":
            a.momentum => "that is about the centre of mass";
        /// angular velocity after
        angular_velocity: a.angular_velocity, "rad/s", "contacts simulated" => w, within bound * v / l, in "(c) The angular velocity":
            hinged => "that is with the hinge",
            a.momentum / (p.mass * l * l / 12.0) => "the particle turns with the rod",
            half / ((p.mass / 12.0 + 0.25 * m) * l * l - whole * a.centre * a.centre) => "moment and angular momentum about the same point";
        /// distance of the point at rest from the centre of mass, just after
        rest: rest, "m", "contacts simulated" => middle / w - a.centre, within bound * l, in "(d) The motion":
            rest + a.centre => "that is from the middle of the rod";
        /// way of the centre of mass in one turn
        way: TAU * rest, "m", "contacts simulated" => way.abs(), within 100.0 * p.tolerance * way, in "(d) The motion";
        /// velocity of the particle just after
        particle_after: a.after(-0.5 * l), "m/s", "contacts simulated" => particle, within bound * v, in "(d) The motion":
            a.velocity => "that is the centre of mass; the particle also turns about it";
        /// of the middle of the rod
        middle_after: a.after(0.0), "m/s", "contacts simulated" => middle, within bound * v, in "(d) The motion":
            a.velocity => "the middle of the rod is not the centre of mass";
        /// of the far end
        far_after: a.after(0.5 * l), "m/s", "contacts simulated" => middle - 0.5 * w * l, within bound * v, in "(d) The motion":
            -a.after(0.5 * l) => "which way does it go?",
            a.velocity => "the end also turns about the centre of mass";
        /// impulse of the particle on the rod
        impulse: p.mass * a.after(0.0), "N s", "contacts simulated" => m * (v - particle), within bound * m * v;
        /// kinetic energy after
        energy: a.energies[1], "J", "contacts simulated" => scene.energy(&after), within bound * a.energies[0];
        /// part of it that is lost
        lost: 1.0 - a.energies[1] / a.energies[0], "-", "contacts simulated" => 1.0 - scene.energy(&after) / scene.energy(&blow.before), within bound,
        in "(d) The motion":
            p.mass / whole => "the rod also turns";
    }
}

fn limits(_: &Parameters, report: &mut Report) -> Result<()> {
    let ([light, heavy], equal) = ([1e-9, 1e9].map(ratio), ratio(1.0));
    let rest = |a: Answer| a.centre + a.velocity / a.angular_velocity;
    limits! { report,
        /// a heavy particle goes on; the rod swings about it
        "m/M to infinity: Omega l/v": heavy.angular_velocity => 1.5, within 1e-8;
        /// a light one gives its impulse m v to a rod at rest
        "m/M to 0: Omega M l/(m v)": light.angular_velocity / 1e-9 => 6.0, within 1e-7;
        /// a light one is stopped, as by a wall
        "m/M to 0: energy after/before": light.energies[1] / light.energies[0] => 0.0, within 1e-8;
        /// a blow at the end leaves this point of the rod at rest, however strong it is
        "m/M to 0: point at rest/l": rest(light) => 1.0 / 6.0, within 1e-8;
        /// and a strong one does the same
        "m/M to infinity: point at rest/l": rest(heavy) => 1.0 / 6.0, within 1e-8;
        /// the notes' case
        "m = M: Omega l/v": equal.angular_velocity => 1.2, within 1e-15;
    }
}

/// A rod 2 cm thick, a ball of steel on its face, a table that rubs with 0.1, and a miss by 1 mm.
fn effects(p: &Parameters, report: &mut Report) -> Result<()> {
    let (a, scene, m, l) = (Answer::new(p), scene(p), p.particle, p.length);
    let (w, whole, inertia) = (a.angular_velocity, p.mass + m, a.momentum / a.angular_velocity);
    let thick = p.mass * 0.02 * 0.02 / 12.0 / inertia;
    let radius = cbrt(3.0 * m / (4.0 * PI * 7850.0));
    let ball = (0.4 * m + m * p.mass / whole) * radius * radius / inertia;
    let miss = 1e-3 / (0.5 * l);
    // A shorter lever gives less angular momentum, and less moment of inertia.
    let missed = miss * w * (p.mass * l * l / 6.0 / inertia - 1.0);
    let contact = 1e-3 * w;
    let rub = 0.1 * 9.80665 / (a.velocity * w);
    // At the start two thirds of the rod run forward and a third back, whatever the masses.
    let braked = rub.min(1.0) * a.velocity * (m + p.mass / 3.0) / whole;
    // How much slower solids turn than rod and point, with the same angular momentum.
    let slower = |rod: MassProperties, particle: MassProperties| -> Result<f64> {
        let both = MassProperties::of_parts(&[rod, particle])?.about_centre_of_mass();
        Ok(w - a.momentum / both.moment_about(DesignVector::new(1.0, 0.0, 0.0))?)
    };
    let point = MassProperties::of_points(&[(m, DesignVector::new(0.0, 0.0, -0.5 * l))])?;
    let broad = solids::cuboid(p.mass, 0.02, 0.02, l)?;
    let sphere = solids::sphere(m, radius)?.displaced(DesignVector::new(0.0, radius, -0.5 * l))?;
    let (yielding, slack) = (scene.pressed(0.0)?, 1e-13 * w);
    // The rod is hit on this side of its middle, and the table does not stop it.
    let run = |sound, strike, end: f64| when(sound, || Blow::new(strike, 1e-8, 0.5, end));
    let off = run(miss < 0.5, Strike { arm: scene.arm - 1e-3, ..scene }, 0.1)?;
    let table = run(rub < 0.5, Strike { rub: 0.1, ..scene }, 1.0 / (w.abs() * scene.unit()))?;
    let end = table.as_ref().map(Blow::end).transpose()?;
    effect_card! { report,
        "thickness of the rod": "M b^2/(12 I)" = thick, costs thick * w, "rad/s", measured slower(broad, point)?, within slack;
        "size of the particle, a ball": "(2/5 m + mu) r^2/I" = ball, costs ball * w, "rad/s",
            measured slower(solids::rod(p.mass, l)?, sphere)?, within slack;
        "it hits 1 mm off the end": "2 x/l" = miss, costs missed, "rad/s, to first order",
            measured off.as_ref().map(|blow| w - blow.after.v[2]), within miss * miss * w,
            at_work off.map(|blow| blow.work());
        "the contact lasts 1 ms": "Omega t_c" = contact, costs 0.5 * contact, "rad of the angle",
            measured yielding.0[1] * contact, at_work yielding.1;
        "friction of the table": "mu_k g/(V Omega)" = rub, costs braked, "m/s of V in the time 1/Omega, from the start",
            measured end.map(|end| a.velocity - scene.momentum(&end)[0] / whole), within 1e-8 + 1e-5 * a.velocity,
            at_work table.map(|blow| blow.work());
    }
}

/// The accuracy strip: the angle after one turn.
fn accuracy(p: &Parameters, report: &mut Report) -> Result<()> {
    let (scene, end) = (scene(p), turn(p));
    let asked = [p.tolerance, 1e-3, 1e-6, 1e-9, 1e-13];
    let run = move |tolerance| Blow::new(scene, tolerance, 0.5, end);
    let error = |blow: &Blow| Ok(largest([blow.end()?.q[2].abs() - TAU]));
    report.in_closed_form(move |part| part * TAU);
    report.controlled("contacts by DOP853", asked, run, Blow::work, error)
}

example! {
    ch15_ex4_rod_and_particle: "Exercise 15.4: a free rod is hit at its end by a particle that sticks";
    "A rod hit by a particle", "A particle hits the end of a free rod, and sticks.",
    [claims, limits, effects, accuracy];
    figures::figures, figures::trajectory, figures::moving_picture
}
