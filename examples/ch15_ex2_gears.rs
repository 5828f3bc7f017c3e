//! Exercise 15.2: a driven gear turns another, and their angular momentum is not kept.

#[path = "ch15_ex2_gears/figures.rs"]
mod figures;
#[path = "ch15_ex2_gears/physics.rs"]
pub mod physics;

use kit::prelude::*;
use physics::*;
use rotation_dynamics::integrators::Work;
use rotation_dynamics::planar::contact::{Load, Mechanism, MechanismState, motion_within};

parameters! {
    /// The gears of the exercise; the notes leave all numbers open.
    pub struct Parameters {
        /// moment of inertia of gear A
        inertia_a: number(0.02, "kg m^2", from_to(1e-9, 1e9).usually(0.001, 0.1)).drawn(0.010, 0.040, 0.002);
        /// moment of inertia of gear B
        inertia_b: number(0.005, "kg m^2", from_to(1e-9, 1e9).usually(0.001, 0.1)).drawn(0.002, 0.008, 0.001);
        /// radius of gear A
        radius_a: number(0.2, "m", from_to(1e-6, 1e6).usually(0.05, 0.5)).drawn(0.15, 0.30, 0.01);
        /// radius of gear B
        radius_b: number(0.1, "m", from_to(1e-6, 1e6).usually(0.05, 0.5)).drawn(0.05, 0.12, 0.01).open("radius of gear B", "turns fast", "turns slowly");
        /// rate of gear A
        rate: number(30.0, "rad/s", from_to(-1e6, 1e6).but_zero("if A is at rest the rims do not rub").usually(1.0, 100.0)).drawn(10.0, 60.0, 5.0);
        /// friction of the rims while they slip
        friction: number(10.0, "N", from_to(1e-9, 1e9).usually(1.0, 100.0)).drawn(5.0, 20.0, 1.0).open("friction of the rims", "slips long", "holds soon");
        /// mass of gear B, for the reading in which its axis moves
        mass_b: number(1.0, "kg", from_to(1e-9, 1e9).usually(0.1, 5.0));
        /// rate of the arm that carries it in that reading
        arm_rate: number(5.0, "rad/s", from_to(-1e6, 1e6).usually(-20.0, 20.0));
        /// friction of the bearing of B, for the claims about it
        bearing: effect(0.1, "N m", above_to(0.0, 1e6));
        /// relative error of the simulations
        tolerance: number(1e-12, "-", from_to(1e-13, 1e-3));
    }
}

/// What the motor has given until B is up to speed, torque times time, by Simpson's rule.
pub fn motor(run: &Run) -> Result<f64> {
    let sticks = run.event("rims sticks")?.t;
    let torque = |part: f64| run.forces(part * sticks).map(|forces| forces[1].normal);
    Ok(sticks / 6.0 * (torque(0.0)? + 4.0 * torque(0.5)? + torque(1.0)?))
}

fn claims(p: &Parameters, report: &mut Report) -> Result<()> {
    let (r, b, arm, bound) = (ratio(p), rate_b(p, 0.0), p.arm_rate, 100.0 * p.tolerance);
    allowed! {
        "radius_a/radius_b": r, from_to(1e-3, 1e3), "the simulation of the rims loses its digits beyond";
    }?;
    let (run, free) = (spun_up(p, true, p.tolerance)?, spun_up(p, false, p.tolerance)?);
    let (end, loose) = (run.at(run.end_time())?.v, free.at(free.end_time())?.v);
    let (sticks, given) = (run.event("rims sticks")?.t, motor(&run)?);
    let ([la, lb], push) = ([p.inertia_a * p.rate, p.inertia_b * b], push(p));
    let (all, energy) = (la.abs() + lb.abs(), kinetic_energy(p, [p.rate, b]));
    let (about_a, apart) = (|rates| particles(p, rates, [0.0; 2]), p.radius_a + p.radius_b);
    let gained = kinetic_energy(p, end) - kinetic_energy(p, [p.rate, 0.0]);
    let (carried, moving) = (rate_b(p, arm), p.mass_b * apart * apart * arm);
    // The rims push up or down, by the sense of A.
    let sense = p.rate.signum();
    // Nothing turns if the two would have no angular momentum together.
    let kept = if la + lb == 0.0 { 0.0 } else { la / (la + lb) * p.rate };
    let near = 1e-9 * (all + moving.abs() + p.inertia_b * carried.abs());
    claims! { report,
        /// rate of gear B
        rate_b: b, "rad/s", "wheels simulated" => end[1], within bound * b.abs(), in "The gears":
            -b => "two gears that touch turn in opposite senses",
            -p.rate / r => "the smaller gear turns faster",
            -p.rate => "the speeds of the rims are equal, not the rates";
        /// angular momentum about the axis of A
        momentum: la + lb, "kg m^2/s", "four particles for B" => la + about_a([0.0, b]), within near, in "The gears":
            la - lb => "B turns the other way", la => "B turns as well",
            la + lb + p.mass_b * apart * apart * p.rate => "the centre of B is at rest";
        /// kinetic energy
        energy: energy, "J", "wheels simulated" => kinetic_energy(p, end), within bound * energy, in "The gears":
            0.5 * (la + lb) * p.rate => "that is not a body that turns as one";
        /// time until B is up to speed
        time: time(p), "s", "located event" => sticks, within bound * time(p), in "Setting B going":
            p.inertia_b * p.rate / (p.friction * p.radius_b) => "which rate has B in the end?";
        /// push of the rims, summed over the time
        push: push, "N s", "wheels simulated" => p.friction * sticks, within bound * push;
        /// what the motor gives, torque times time
        motor: sense * push * p.radius_a, "N m s", "torque of the motor, simulated" => given, within bound * push * p.radius_a, in "Setting B going":
            sense * push * p.radius_b => "that is what B receives; the lever at A is another",
            sense * push * apart => "that is what the bearing of B takes";
        /// what the bearing of B gives, about the axis of A
        bearing: -sense * push * apart, "N m s", "particles, less the motor" => about_a([0.0, b]) - given, within near + bound * push * apart;
        /// work of the motor
        work: push * p.radius_a * p.rate.abs(), "J", "torque of the motor, simulated" => given * p.rate, within bound * energy, in "Setting B going":
            0.5 * push * p.radius_a * p.rate.abs() => "that is what B has in the end; the rims slip meanwhile";
        /// heat of the rims
        heat: 0.5 * push * p.radius_a * p.rate.abs(), "J", "work less energy, simulated" => given * p.rate - gained, within bound * energy;
        /// rate of A in the end if nothing drives it
        undriven: undriven(p), "rad/s", "wheels simulated" => loose[0], within bound * p.rate, in "Setting B going":
            kept => "the bearings give angular momentum too",
            p.inertia_a * p.rate / (p.inertia_a + p.inertia_b) => "they do not turn as one body";
        /// rate of gear B, carried by the arm
        carried_rate: carried, "rad/s", "no slip, from places" => without_slip(p, arm), within 1e-9 * (carried.abs() + p.rate.abs() + (1.0 + r) * arm.abs());
        /// angular momentum then
        carried_momentum: momentum(p, arm), "kg m^2/s", "four particles for B" => la + about_a([arm, carried]), within near;
    }
}

/// Gears like these with other ratios of radii and of moments of inertia.
fn like(p: &Parameters, ratio: f64, inertia: f64) -> Parameters {
    let p = p.but(|p| (p.inertia_a, p.radius_b, p.rate) = (1.0, 1.0, 1.0));
    p.but(|p| (p.inertia_b, p.radius_a) = (inertia, ratio))
}

fn limits(p: &Parameters, report: &mut Report) -> Result<()> {
    let of = |ratio: f64, inertia: f64| like(p, ratio, inertia);
    let (twins, far) = (of(1.0, 1.0), of(1e-3, 1.0));
    limits! { report,
        /// two like gears: what one has, the other has backward
        "R1 = R2, I1 = I2: L": momentum(&twins, 0.0) => 0.0, within 1e-15;
        /// B hardly turns
        "R2 = 1000 R1: Omega2/Omega1": rate_b(&far, 0.0) => -1e-3, within 1e-15;
        /// a light gear B: only A counts
        "I2 to 0: L/(I1 Omega1)": momentum(&of(2.0, 1e-12), 0.0) => 1.0, within 1e-11;
        /// uniform discs of one mass and twice the radius: half
        "I1 = 4 I2, R1 = 2 R2: L/(I1 Omega1)": momentum(&of(2.0, 0.25), 0.0) => 0.5, within 1e-15;
        /// and of one thickness: seven eighths
        "I1 = 16 I2, R1 = 2 R2: L/(I1 Omega1)": momentum(&of(2.0, 0.0625), 0.0) => 0.875, within 1e-15;
        /// the arm turns with A: all is one body
        "arm at Omega1: Omega2/Omega1": rate_b(&of(2.0, 1.0), 1.0) => 1.0, within 1e-15;
    }
}

/// Torques besides those of the rims: of a motor that gives way, and of the bearing of B.
struct Besides {
    rate: f64,
    motor: f64,
    bearing: f64,
}

impl Load<2> for Besides {
    fn force(&self, MechanismState { v, .. }: &MechanismState<2>) -> [f64; 2] {
        [self.motor * (self.rate - v[0]), self.rate.signum() * self.bearing]
    }
}

/// What becomes of the wheels with them.
#[derive(Clone, Copy)]
struct UpToSpeed {
    time: f64,       // until the rims no longer slip
    rates: [f64; 2], // of A and B at that time
    holds: f64,      // torque of the motor from then on, if it drives A
    work: Work,      // of the simulation
}

/// The wheels with such a motor and such a bearing, until long after B is up to speed.
fn with(p: &Parameters, [motor, bearing]: [f64; 2], driven: bool) -> Result<UpToSpeed> {
    let end = 1.5 * time(p) / (1.0 - bearing / (p.friction * p.radius_b));
    let wheels = Wheels { p: p.clone(), driven }.with(Besides { rate: p.rate, motor, bearing });
    let start = MechanismState { q: [0.0; 2], v: [p.rate, 0.0] };
    let run = motion_within(wheels, 1e-10, start, end)?;
    let (sticks, holds) = (run.event("rims sticks")?, run.forces(end)?[1].normal);
    Ok(UpToSpeed { time: sticks.t, rates: sticks.after.v, holds, work: run.work() })
}

/// What `--with bearing` adds: B takes longer, and then the motor has to go on.
fn rough(p: &Parameters, report: &mut Report) -> Result<()> {
    let Some(bearing) = p.bearing else { return Ok(()) };
    let (grip, b) = (p.friction * p.radius_b, rate_b(p, 0.0).abs());
    allowed! {
        "bearing over the torque of the rims": bearing / grip, between(0.0, 0.99), "or the bearing holds B";
    }?;
    let longer = p.inertia_b * b / (grip - bearing);
    let found = with(p, [0.0, bearing], true)?;
    claims! { report,
        /// with friction in the bearing: time until B is up to speed
        rough_time: longer, "s", "located event" => found.time, within 1e-8 * longer;
        /// power of the motor from then on
        rough_power: bearing * b, "W", "torque of the motor, simulated" => found.holds * p.rate, within 1e-8 * grip * b;
    }
}

/// The card of effects, for friction wheels with bearings of 5 mm and a motor under load.
fn effects(p: &Parameters, report: &mut Report) -> Result<()> {
    let which = p.inertia_b / p.inertia_a * ratio(p) * ratio(p);
    let (whole, of_b) = (momentum(p, 0.0).abs(), (p.inertia_b * rate_b(p, 0.0)).abs());
    let all = (p.inertia_a * p.rate).abs() + of_b;
    let rubs = 1.5e-3 * (p.mass_b * 9.80665 + p.friction) * 0.005;
    let bearing = rubs / (p.friction * p.radius_b);
    let (creep, droop, off) = (0.01, 0.03, 1e-4 / p.radius_b);
    // A motor that friction slows by this part in the end, in a time of its own.
    let gives = droop * (1.0 - exp(-which / droop));
    let motor = p.friction * p.radius_a / (droop * p.rate.abs());
    let sluggish = when(which < 1e3 * droop, || with(p, [motor, 0.0], false))?;
    let rough = when(bearing < 0.3, || with(p, [0.0, rubs], true))?;
    let free = with(p, [0.0, 0.0], false)?;
    let larger = with(&p.but(|p| p.radius_b += 1e-4), [0.0, 0.0], true)?;
    let both = |[a, b]: [f64; 2]| p.inertia_a * a + p.inertia_b * b;
    effect_card! { report,
        "the motor gives way by 3 %": "dOmega1/Omega1" = droop, costs gives * whole, "kg m^2/s",
            measured sluggish.map(|run| whole - both(run.rates).abs()), within 1e-8 * all, at_work sluggish.map(|run| run.work);
        "creep of friction wheels, 1 %": "s" = creep, costs creep * of_b, "kg m^2/s";
        "a radius off by 0.1 mm": "dR/R2" = off, costs off * of_b, "kg m^2/s",
            measured of_b - p.inertia_b * larger.rates[1].abs(), within 1e-8 * all, at_work larger.work;
        "bearing of B, 5 mm": "tau_b/(F R2)" = bearing, costs bearing * time(p), "s later",
            measured rough.map(|run| run.time - time(p)), within 1e-8 * time(p), at_work rough.map(|run| run.work);
        "which of them is driven": "I2 R1^2/(I1 R2^2)" = which, costs p.rate - undriven(p), "rad/s of Omega1",
            measured p.rate - free.rates[0], within 1e-8 * p.rate, at_work free.work, included;
    }
}

/// The accuracy strip: time and rates when B is up to speed, A being driven.
fn accuracy(p: &Parameters, report: &mut Report) -> Result<()> {
    let (p, time, b) = (p.clone(), time(p), rate_b(p, 0.0));
    let asked = [p.tolerance, 1e-3, 1e-6, 1e-9, 1e-13];
    let error = move |run: &Run| {
        let sticks = run.event("rims sticks")?;
        let rate = (sticks.after.v[1] / b - 1.0).abs();
        Ok((sticks.t / time - 1.0).abs().max(rate))
    };
    report.in_closed_form(move |part| b * part);
    let run = move |step| spun_up(&p, true, step);
    report.controlled("contacts by DOP853", asked, run, Run::work, error)
}

example! {
    ch15_ex2_gears: "Exercise 15.2: a driven gear turns another";
    "Gears", "A gear that is kept turning drives another, on an axis at rest or carried by an arm.",
    [claims, rough, limits, effects, accuracy];
    figures::figures, figures::trajectory, figures::moving_picture
}
