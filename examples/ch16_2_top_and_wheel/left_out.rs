//! What the scene leaves out. What the fixed point must hold comes from the motion; what a
//! torque against the spin costs is predicted by the library and tested by a simulation; the
//! other errors are estimates.

use super::slowing::lead_by_angles;
use super::{Body, TOP, WHEEL};
use kit::{CardLine, EffectLine, Report, Result, claim, effect, sampled, times};
use models::heavy_top::Newton;
use rotation_dynamics::effects::{CoulombBearing, DiscDrag, Effect};
use rotation_dynamics::exact::heavy_top::HeavyTop;
use rotation_dynamics::integrators::{Dop853, Ode};
use rotation_dynamics::math::{cbrt, hypot, sincos};

use core::f64::consts::{PI, TAU};

/// What holds the fixed point, over one nod: the greatest ratio of the horizontal to the
/// vertical force, and the least vertical force over the weight.
#[derive(Debug, Clone, Copy)]
struct Hold {
    grip: f64,
    load: f64,
}

impl Hold {
    /// Of these accelerations of the centre of mass: horizontal and upwards, m/s^2.
    fn over(accelerations: Vec<(f64, f64)>, gravity: f64) -> Self {
        let ratios = accelerations.iter().map(|(h, z)| h / (gravity + z));
        let loads = accelerations.iter().map(|(_, z)| 1.0 + z / gravity);
        Self { grip: ratios.fold(0.0, f64::max), load: loads.fold(f64::INFINITY, f64::min) }
    }

    /// By the tilt and its rates in closed form, with (2) and (3) of the notes.
    fn by_angles(body: &Body, exact: &HeavyTop) -> Result<Self> {
        let (i1, l) = (body.moment(), body.length);
        let momentum = exact.momenta().1;
        let samples = sampled(times(0.0, exact.nutation_period(), POINTS), |t| {
            let (s, c) = sincos(exact.angles(t).theta);
            let (fall, rate) = (exact.theta_rate(t), exact.phi_rate(t));
            let pull = body.weight_moment() * s - rate * s * (momentum - i1 * rate * c);
            let outward = pull / i1 * c - (fall * fall + rate * rate) * s;
            let sideways = fall * momentum / i1;
            let upward = -(pull / i1 * s + fall * fall * c);
            Ok((l * hypot(outward, sideways), l * upward))
        })?;
        Ok(Self::over(samples, body.gravity))
    }

    /// By a run of Newton's law in vectors.
    fn by_vectors(body: &Body, exact: &HeavyTop) -> Result<Self> {
        let (i1, weight_moment) = (body.moment(), body.weight_moment());
        let law = Newton { i1, weight_moment };
        let (momentum, axis) = (exact.angular_momentum(0.0), exact.axis(0.0));
        let ([a, b, c], [x, y, z]) = (momentum.to_array(), axis.to_array());
        let end = exact.nutation_period();
        let run = Dop853::new(1e-12)?.solve(&law, 0.0, &[a, b, c, x, y, z], end, &[])?;
        let samples = sampled(times(0.0, end, POINTS - 1), |t| {
            let y = run.at(t)?;
            // The axis moves with L x e/I1; differentiate once more.
            let rates = law.derivative(t, &y);
            let both = |i: usize, j: usize| {
                let first = rates[i] * y[3 + j] - rates[j] * y[3 + i];
                first + y[i] * rates[3 + j] - y[j] * rates[3 + i]
            };
            let [ax, ay, az] = [both(1, 2), both(2, 0), both(0, 1)].map(|d| d * body.length / i1);
            Ok((hypot(ax, ay), az))
        })?;
        Ok(Self::over(samples, body.gravity))
    }
}

/// Samples of one nod; the greatest and the least lie within 1e-5 of the true ones.
const POINTS: u32 = 2000;

/// Coefficient of friction, wood on wood.
const FRICTION: f64 = 0.2;

/// Adds the card, and the claims on which it stands.
pub fn add(report: &mut Report) -> Result<()> {
    let mut hold = |name: &str, body: &Body| -> Result<Hold> {
        let exact = body.motion("")?.exact;
        let angles = Hold::by_angles(body, &exact)?;
        let vectors = Hold::by_vectors(body, &exact)?;
        let entry = |what: &str, meaning: &str, value: f64, other: f64| {
            claim(format!("{name}_{what}"), format!("{name}: {meaning}"), value, "-")
                .within(1e-5)
                .against("DOP853 on dL/dt = torque", other)
        };
        report.add(vec![
            entry(
                "grip",
                "greatest horizontal over vertical force at O",
                angles.grip,
                vectors.grip,
            )
            .answer("What holds O")
            .judged_within(0.01),
            entry("load", "least vertical force at O over the weight", angles.load, vectors.load),
        ])?;
        Ok(angles)
    };
    let (tip, rope) = (hold("top", &TOP)?, hold("wheel", &WHEEL)?);

    // A disc of 2.8 cm radius on a steel tip of 1 mm radius; the wheel has 35 cm.
    let (ball, [top_disc, wheel_disc]) = (1e-3, [disc(&TOP, 0.0283)?, disc(&WHEEL, 0.35)?]);
    // Friction on the contact area (Hertz; steel on wood, E* = 10 GPa).
    let contact = cbrt(0.75 * TOP.mass * TOP.gravity * ball / 1e10);
    let drilling = 3.0 * PI / 16.0 * FRICTION * TOP.mass * TOP.gravity * contact;
    let bearing = 0.0015 * WHEEL.mass * WHEEL.gravity * 5e-3;
    let names = ["top_air_lead", "top: air"];
    let top_air = brake(report, names, &TOP, top_disc, |spin| top_disc.axial_torque(spin))?;
    let names = ["top_drill_lead", "top: the tip drills"];
    let drill = brake(report, names, &TOP, dry(&TOP, drilling)?, |_| -drilling)?;
    let names = ["wheel_air_lead", "wheel: air"];
    let wheel_air = brake(report, names, &WHEEL, wheel_disc, |spin| wheel_disc.axial_torque(spin))?;
    let names = ["wheel_bearing_lead", "wheel: bearings"];
    let bearings = brake(report, names, &WHEEL, dry(&WHEEL, bearing)?, |_| -bearing)?;

    // A tip that slides has a lever arm for its friction, which lifts the axis.
    let turn = TAU / TOP.steady_rate();
    let rise = FRICTION * TOP.weight_moment() / (TOP.i3 * TOP.spin) * turn;
    let rate = WHEEL.level_rate();
    let aside = rate * rate * WHEEL.length / WHEEL.gravity;
    let earth = 7.292115e-5;
    report.add(vec![
        effect("top: the tip slips")
            .number("greatest |F_h| / mu N, slips above 1", tip.grip / FRICTION)
            .costs(rise, "rad a turn, upwards"),
        effect("top: the tip is round")
            .number("r_tip / l", ball / TOP.length)
            .costs(TAU * ball / TOP.length, "rad a turn, in φ"),
        top_air,
        drill,
        effect("top: the tip lifts off")
            .number("1 - least N / m g, lifts off at 1", 1.0 - tip.load)
            .costs(f64::from(tip.load <= 0.0), "of the motion, nothing below 1"),
        effect("wheel: the rope gives way to the nods")
            .number("greatest |F_h| / N", rope.grip)
            .costs(rope.grip, "rad, slant of the rope"),
        effect("wheel: the rope gives way to the walk")
            .number("(dphi/dt)^2 l / g", aside)
            .costs(aside, "rad, slant of the rope"),
        wheel_air,
        bearings,
        effect("wheel: rotation of the Earth")
            .number("Omega_E / (dphi/dt)", earth / rate)
            .costs(earth * TAU / rate, "rad a turn, at most"),
    ])
}

/// The drag of the air on a disc of this radius that spins with the body.
fn disc(body: &Body, radius: f64) -> rotation_dynamics::Result<DiscDrag> {
    let (density, viscosity) = (DiscDrag::AIR_DENSITY, DiscDrag::AIR_VISCOSITY);
    DiscDrag::new(radius, density, viscosity, body.spin)
}

/// Dry friction of this torque against the spin of the body in steady precession.
fn dry(body: &Body, torque: f64) -> rotation_dynamics::Result<CoulombBearing> {
    let steady = body.steady()?;
    CoulombBearing::new(torque, steady.scene.body(), &steady.start, 0.0)
}

/// The line of the card for what brakes the spin, and the claim of what a run with it gives,
/// under this key; `torque` is what it is along the axis (N m), of the spin.
fn brake(
    report: &mut Report,
    [key, name]: [&str; 2],
    body: &Body,
    effect: impl Effect + Clone,
    torque: impl Fn(f64) -> f64,
) -> Result<EffectLine> {
    let (steady, unit) = (body.steady()?, "rad a turn, of the axis");
    let part = -torque(body.spin) * steady.turn / (body.i3 * body.spin);
    let candidates = steady.left_out()?;
    let line = candidates.line(name, "torque x turn / L_z", part, &effect, unit)?;
    let meaning = format!("{name}: simulated lead of phi after one turn");
    let lead = claim(key, meaning, steady.changed_by(effect)?[1], "rad").within(1e-8);
    let by_angles = lead_by_angles(body, torque)?;
    report.add(lead.against("DOP853 on (2), (3), L_z falling", by_angles))?;
    Ok(line)
}
