//! What the scene leaves out. What the fixed point must hold comes from the motion; what a
//! torque against the spin costs is predicted by the library and tested by a simulation; the
//! other errors are estimates.

use super::*;
use rotation_dynamics::effects::{CoulombBearing, DiscDrag, Effect};
use rotation_dynamics::integrators::{Ode, after, ode, size_or};

/// Samples of one nod; the greatest and the least lie within 1e-5 of the true ones.
const POINTS: u32 = 2000;

/// What holds the fixed point if the centre of mass has these accelerations, horizontal and
/// upwards (m/s^2): the greatest ratio of the horizontal to the vertical force, and the least
/// vertical force over the weight.
fn hold(accelerations: &[(f64, f64)], gravity: f64) -> [f64; 2] {
    let ratios = accelerations.iter().map(|(h, z)| h / (gravity + z));
    let loads = accelerations.iter().map(|(_, z)| 1.0 + z / gravity);
    [ratios.fold(0.0, f64::max), loads.fold(f64::INFINITY, f64::min)]
}

/// That over one nod, by the tilt and its rates in closed form, with (2) and (3) of the notes.
fn hold_by_angles(body: &Body) -> Result<[f64; 2]> {
    let (exact, i1, l) = (body.motion("")?.exact, body.moment(), body.length);
    let momentum = exact.momenta().1;
    let accelerations = times(0.0, exact.nutation_period(), POINTS).map(|t| {
        let (s, c) = sincos(exact.angles(t).theta);
        let (fall, rate) = (exact.theta_rate(t), exact.phi_rate(t));
        let pull = body.weight_moment() * s - rate * s * (momentum - i1 * rate * c);
        let outward = pull / i1 * c - (fall * fall + rate * rate) * s;
        let sideways = fall * momentum / i1;
        let upward = -(pull / i1 * s + fall * fall * c);
        (l * hypot(outward, sideways), l * upward)
    });
    Ok(hold(&accelerations.collect::<Vec<_>>(), body.gravity))
}

/// The same by a run of Newton's law in vectors.
fn hold_by_vectors(body: &Body) -> Result<[f64; 2]> {
    let (exact, i1) = (body.motion("")?.exact, body.moment());
    let law = Newton { i1, weight_moment: body.weight_moment() };
    let ([a, b, c], [x, y, z]) =
        (exact.angular_momentum(0.0).to_array(), exact.axis(0.0).to_array());
    let end = exact.nutation_period();
    let run = Dop853::new(1e-12)?.solve(&law, 0.0, &[a, b, c, x, y, z], end, &[])?;
    let accelerations = sampled(times(0.0, end, POINTS - 1), |t| {
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
    Ok(hold(&accelerations, body.gravity))
}

impl Body {
    /// In slow steady precession at its tilt.
    pub fn steady(&self) -> Result<Steady> {
        Ok(Steady::new(self.rigid()?, self.weight()?, self.theta, self.spin)?)
    }

    /// The slow root of I1' cos(theta) p^2 - L_z p + m g l = 0, rad/s.
    fn steady_rate(&self) -> f64 {
        let momentum = self.i3 * self.spin;
        let four_terms = 4.0 * self.moment() * self.weight_moment() * cos(self.theta);
        2.0 * self.weight_moment() / (momentum + (momentum * momentum - four_terms).sqrt())
    }
}

/// By how much a braked body is ahead in steady precession, after the time that a turn takes
/// without the brake, rad: by (2) and (3) of the notes, in theta, theta', phi, L_z, L_Z.
/// `torque` is the brake's along the axis (N m), of the spin.
fn lead_by_angles(body: &Body, torque: impl Fn(f64) -> f64) -> Result<f64> {
    let (i1, weight_moment, rate) = (body.moment(), body.weight_moment(), body.steady_rate());
    let law = ode(move |_, &[theta, nutation, _, momentum, vertical]: &[f64; 5]| {
        let ((s, c), brake) = (sincos(theta), torque(momentum / body.i3));
        let rate = (vertical - momentum * c) / (i1 * s * s);
        let pull = weight_moment * s - rate * s * (momentum - i1 * rate * c);
        [nutation, pull / i1, rate, brake, brake * c]
    })
    .scaled(size_or([1.0; 5]));
    let momentum = body.i3 * body.spin;
    let vertical = momentum * cos(body.theta) + i1 * rate * pow(sin(body.theta), 2.0);
    let start = [body.theta, 0.0, 0.0, momentum, vertical];
    let [_, _, azimuth, ..] = after(TAU / rate, &law, &start, 1e-12)?;
    Ok(azimuth - TAU)
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
    let line = steady.left_out()?.line(name, "torque x turn / L_z", part, &effect, unit)?;
    let meaning = format!("{name}: simulated lead of phi after one turn");
    let lead = claim(key, meaning, steady.changed_by(effect)?[1], "rad");
    let by_angles = lead_by_angles(body, torque)?;
    report.add(lead.agrees_with("DOP853 on (2), (3), L_z falling", by_angles, 1e-8))?;
    Ok(line)
}

/// Adds the card, and the claims on which it stands.
pub fn effects(report: &mut Report) -> Result<()> {
    const RUN: &str = "DOP853 on dL/dt = torque";
    let ([grip, load], [rope, rope_load]) = (hold_by_angles(&TOP)?, hold_by_angles(&WHEEL)?);
    let (top, wheel) = (hold_by_vectors(&TOP)?, hold_by_vectors(&WHEEL)?);
    claims! { report,
        /// top: greatest horizontal over vertical force at O
        top_grip: grip, "-", RUN => top[0], within 1e-5, judged 0.01, in "What holds O";
        /// top: least vertical force at O over the weight
        top_load: load, "-", RUN => top[1], within 1e-5;
        /// wheel: greatest horizontal over vertical force at O
        wheel_grip: rope, "-", RUN => wheel[0], within 1e-5, judged 0.01, in "What holds O";
        /// wheel: least vertical force at O over the weight
        wheel_load: rope_load, "-", RUN => wheel[1], within 1e-5;
    }?;

    // A disc of 2.8 cm radius on a steel tip of 1 mm radius; the wheel has 35 cm.
    let ball = 1e-3;
    let disc = |body: &Body, radius| {
        DiscDrag::new(radius, DiscDrag::AIR_DENSITY, DiscDrag::AIR_VISCOSITY, body.spin)
    };
    let (top_disc, wheel_disc) = (disc(&TOP, 0.0283)?, disc(&WHEEL, 0.35)?);
    // Wood on wood, and friction on the contact area (Hertz; steel on wood, E* = 10 GPa).
    let friction = 0.2;
    let contact = cbrt(0.75 * TOP.mass * TOP.gravity * ball / 1e10);
    let drilling = 3.0 * PI / 16.0 * friction * TOP.mass * TOP.gravity * contact;
    let bearing = 0.0015 * WHEEL.mass * WHEEL.gravity * 5e-3;
    let dry = |body: &Body, torque| -> Result<_> {
        let steady = body.steady()?;
        Ok(CoulombBearing::new(torque, steady.scene.body(), &steady.start, 0.0)?)
    };
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
    let rise = friction * TOP.weight_moment() / (TOP.i3 * TOP.spin) * turn;
    let (rate, earth) = (WHEEL.level_rate(), 7.292115e-5);
    let aside = rate * rate * WHEEL.length / WHEEL.gravity;
    effect_card! { report,
        "top: the tip slips": "greatest |F_h| / mu N, slips above 1" = grip / friction, costs rise, "rad a turn, upwards";
        "top: the tip is round": "r_tip / l" = ball / TOP.length, costs TAU * ball / TOP.length, "rad a turn, in φ";
    }?;
    report.add(vec![top_air, drill])?;
    effect_card! { report,
        "top: the tip lifts off": "1 - least N / m g, lifts off at 1" = 1.0 - load,
            costs f64::from(load <= 0.0), "of the motion, nothing below 1";
        "wheel: the rope gives way to the nods": "greatest |F_h| / N" = rope, costs rope, "rad, slant of the rope";
        "wheel: the rope gives way to the walk": "(dphi/dt)^2 l / g" = aside, costs aside, "rad, slant of the rope";
    }?;
    report.add(vec![wheel_air, bearings])?;
    effect_card! { report,
        "wheel: rotation of the Earth": "Omega_E / (dphi/dt)" = earth / rate, costs earth * TAU / rate, "rad a turn, at most";
    }
}
