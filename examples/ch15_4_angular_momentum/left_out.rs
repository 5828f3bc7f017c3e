//! What the scenes leave out: air, a centre off the shaft, rolling resistance, an oval orbit.

use super::*;
use rotation_dynamics::effects::KeplerOrbit;
use rotation_dynamics::integrators::{Dop853, Work, second_order};
use rotation_dynamics::math::expm1;

/// The cylinder with its motor shut off, slowed down by the air on strips of it, each across its
/// own speed: the torque, on average over the first radian, and the work. `drag` is the density
/// times the drag coefficient.
pub fn blown(p: &Parameters, drag: f64) -> Result<(f64, Work)> {
    const STRIPS: u32 = 64;
    let (inertia, rate, s) = (Shaft::of(p)?.inertia(), p.rate.abs(), sin(p.tilt));
    let slowed = second_order(|_, _, rate| {
        let strips = (0..STRIPS).map(|k| {
            let from_centre = (f64::from(k) + 0.5) / f64::from(STRIPS) - 0.5;
            let arm = (p.height * from_centre * s).abs();
            let speed = rate * arm;
            // Half of the density, and the diameter.
            -drag * p.radius * p.height / f64::from(STRIPS) * speed * speed.abs() * arm
        });
        strips.sum::<f64>() / inertia
    });
    let radian = |y: &[f64; 2]| y[0] - 1.0;
    let (end, work) = Dop853::new(1e-12)?.zero(&slowed, [0.0, rate], 1, 9.0 / rate, radian)?;
    Ok((0.5 * inertia * (rate - end.state[1]) * (rate + end.state[1]), work))
}

/// The force that leads the centre of the cylinder round, so far off the shaft, from the places
/// of its grains.
pub fn whirled(p: &Parameters, off: f64) -> Result<f64> {
    let (shaft, h) = (Shaft::of(p)?, swarm::step(p.rate));
    let grains = cylinder(p.mass, p.radius, p.height);
    // Level, as the first axis of the cylinder is.
    let off = BodyVector::new(off, 0.0, 0.0);
    let moment = |t: f64| -> SpaceVector {
        let attitude = shaft.attitude(t);
        grains.iter().map(|(mass, place)| attitude.to_space(*place + off) * *mass).sum()
    };
    Ok(swarm::rate(|t| swarm::rate(moment, t, h), 0.0, h).norm())
}

/// The torque of the air over the square of the rate; `drag` as for [`blown`].
fn dragged(p: &Parameters, drag: f64) -> f64 {
    let across = p.height * sin(p.tilt);
    drag * p.radius * across * across * across * p.height / 32.0
}

/// What `--with air` adds: what the motor has to give to the cylinder, and what it would lose without.
pub fn in_air(p: &Parameters, report: &mut Report) -> Result<()> {
    let Some(coefficient) = p.air else { return Ok(()) };
    let (inertia, drag) = (Shaft::of(p)?.inertia(), 1.2 * coefficient);
    let energy = 0.5 * inertia * p.rate * p.rate;
    let lost = -expm1(-2.0 * dragged(p, drag) / inertia);
    allowed! {
        "part of the energy that the air takes in a radian": lost, between(0.0, 0.9), "it would stop within a radian";
    }?;
    claims! { report,
        // What the strips lose is the difference of two energies, which are rounded.
        /// in air, the motor shut off: energy lost in the first radian
        air_lost: lost * energy, "J", "64 strips" => blown(p, drag)?.0, within (1e-3 * lost + 4.0 * f64::EPSILON) * energy;
    }
}

/// The card of effects. Air: 1.2 kg/m^3 and a drag coefficient of 1.2; Earth and Moon: their
/// measured masses, distance and moment.
pub fn effects(p: &Parameters, report: &mut Report) -> Result<()> {
    let (shaft, drag) = (Shaft::of(p)?, 1.2 * 1.2);
    let (inertia, size) = (shaft.inertia(), p.mass * (p.height + p.radius));
    let (slowing, unit) = (dragged(p, drag) / inertia, inertia * p.rate * p.rate);
    let breeze = when(slowing < 0.1, || blown(p, drag))?;
    let (off, speed) = (1e-4, p.wheel_radius * p.wheel_rate.abs());
    let resisted = 0.005 * p.gravity / (1.5 * speed);
    // In a second; a wheel that is hardly slowed down, or stops, tells nothing.
    let rolls = || hoop::lost(0.5, [p.wheel_radius, speed], 0.005, p.gravity, 1.0);
    let rolled = when((1e-9..0.1).contains(&resisted), rolls)?;
    let oval = 0.0167;
    let earth = KeplerOrbit::elliptic(1.0, TAU, oval)?;
    let narrower = 1.0 - earth.place(1.0).cross(&earth.velocity(1.0)).norm();
    let ([orbit, spin, third], denser) = (worked::EARTH, 0.4 / 0.330675);
    let moon = 7.2534e22 * 3.844e8 * 3.844e8 * 2.6617e-6;
    let counted = |run: Option<(f64, Work)>| match run {
        Some((_, work)) => format!("none, {} derivatives", work.derivatives),
        None => "-".into(),
    };
    effect_card! { report,
        "cylinder: drag of the air": "rho C R sin^3(theta) H^4/(32 I)" = slowing,
            costs slowing * unit, "N m of the motor, to first order",
            measured breeze.map(|(torque, _)| torque), within 1e-12 * unit, at_cost counted(breeze);
        "cylinder: centre 0.1 mm off the shaft": "M e H/|I1 - I3|" = p.mass * off * p.height / (shaft.i1 - shaft.i3).abs().max(1e-3 * shaft.i1),
            costs p.mass * off * p.rate * p.rate * p.height, "N m with the lever H, going round",
            measured whirled(p, off)? * p.height, within 1e-12 * size * p.height * p.rate * p.rate, at_cost "none, 64 attitudes";
        "rolling wheel: resistance": "C_rr g (1 s)/(1.5 R Omega)" = resisted,
            costs resisted, "of L a second",
            measured rolled.map(|(lost, _)| lost / speed), at_cost counted(rolled);
        "Earth: denser inside": "0.4/0.330675 - 1" = denser - 1.0, costs denser - 1.0, "of the spin";
        "Earth: the orbit is an ellipse": "e^2/2" = 0.5 * oval * oval,
            costs 0.5 * oval * oval, "of the orbital L, to first order",
            measured narrower, at_cost "closed form, closed form";
        "Earth: the Moon": "L_Moon/L_spin" = moon / ((spin + third) / denser), costs moon / orbit, "of the orbital L";
    }
}
