//! What the scene leaves out, for the top and for the wheel: estimates, with the
//! formulas in the table.

use super::{Body, TOP, WHEEL};
use rotation_dynamics::math::{cbrt, pow};
use rotation_dynamics::report::{EffectEntry, Report};

use core::f64::consts::{PI, TAU};

/// Adds the card.
pub fn add(report: &mut Report) {
    let mut add = |effect: &str, number: &str, value: f64, error: f64, unit: &str| {
        report.add_effect(EffectEntry {
            effect: effect.into(),
            number: number.into(),
            value,
            error,
            unit: unit.into(),
            included: false,
        });
    };
    // Top: a disc of 2.8 cm radius on a tip of 1 mm radius, wood on wood.
    let momentum = TOP.i3 * TOP.spin;
    let turn = TAU * momentum / TOP.weight_moment();
    let tip = 1e-3;
    // The tip slides: its friction has a lever arm, and lifts the axis.
    let friction = 0.2;
    let rise = friction * TOP.weight_moment() / momentum;
    add(
        "top: the tip slides",
        "mu m g l x turn / L_z",
        rise * turn,
        rise * turn,
        "rad a turn, upwards",
    );
    add(
        "top: the tip is round",
        "r_tip / l",
        tip / TOP.length,
        TAU * tip / TOP.length,
        "rad a turn, in φ",
    );
    let air = air_torque(&TOP, 0.0283);
    add(
        "top: air",
        "torque x turn / L_z",
        air * turn / momentum,
        PI * air * turn / momentum,
        "rad a turn, in φ",
    );
    // Friction on the contact area (Hertz; steel on wood, E* = 10 GPa).
    let contact = cbrt(0.75 * TOP.mass * TOP.gravity * tip / 1e10);
    let drill = 3.0 * PI / 16.0 * friction * TOP.mass * TOP.gravity * contact;
    add(
        "top: the tip drills",
        "torque x turn / L_z",
        drill * turn / momentum,
        PI * drill * turn / momentum,
        "rad a turn, in φ",
    );
    // The tip stays down while the nods accelerate the centre of mass by less than g.
    let nod = TOP.i3 * TOP.spin / TOP.moment();
    let dip = TOP.weight_moment() * TOP.moment() / (momentum * momentum) * 0.389;
    let lift = nod * nod * dip * TOP.length * 0.389 / TOP.gravity;
    add(
        "top: the tip lifts off",
        "acceleration of the nods / g",
        lift,
        0.0,
        "as long as it is below 1",
    );

    let momentum = WHEEL.i3 * WHEEL.spin;
    let rate = WHEEL.weight_moment() / momentum;
    let turn = TAU / rate;
    let air = air_torque(&WHEEL, 0.35);
    add(
        "wheel: air",
        "torque x turn / L_z",
        air * turn / momentum,
        PI * air * turn / momentum,
        "rad a turn, in φ",
    );
    // The rope is pulled aside by the force that keeps the hub on its circle.
    let aside = rate * rate * WHEEL.length / WHEEL.gravity;
    add(
        "wheel: the rope gives way",
        "(dphi/dt)^2 l / g",
        aside,
        aside,
        "rad, slant of the rope",
    );
    let bearing = 0.0015 * WHEEL.mass * WHEEL.gravity * 5e-3;
    add(
        "wheel: bearings",
        "torque x turn / L_z",
        bearing * turn / momentum,
        PI * bearing * turn / momentum,
        "rad a turn, in φ",
    );
    let earth = 7.292115e-5;
    add(
        "wheel: rotation of the Earth",
        "Omega_E / (dphi/dt)",
        earth / rate,
        earth * turn,
        "rad a turn, at most",
    );
}

/// Torque of the air on a disc of this radius, both faces (laminar below Re = 3e5), N m.
fn air_torque(body: &Body, radius: f64) -> f64 {
    let reynolds = body.spin * radius * radius / 1.51e-5;
    let coefficient = if reynolds < 3e5 {
        3.87 / reynolds.sqrt()
    } else {
        0.146 / pow(reynolds, 0.2)
    };
    0.5 * 1.204 * body.spin * body.spin * pow(radius, 5.0) * coefficient
}
