//! What this scene leaves out: the thrown disc in air, the cylinder for the rest.

use super::{Parameters, Top};
use core::f64::consts::PI;
use rotation_dynamics::Result;
use rotation_dynamics::effects::DiscDrag;
use rotation_dynamics::report::Report;

/// Mean motion of an orbit at the ground, squared: g over the radius of the Earth.
pub const GRADIENT: f64 = 9.80665 / 6.371e6;

/// The rate (rad/s) at which the gradient of gravity turns L, at most: on average over the
/// fast rotation the torque is 3/2 GRADIENT (I3 - I1) P_2(cos theta) sin(2 psi), with psi
/// the angle of L to the vertical.
pub fn gradient_rate(top: Top) -> f64 {
    let c = super::cos(top.tilt());
    1.5 * GRADIENT * (top.i3 - top.i1).abs() * (1.5 * c * c - 0.5) / top.momentum()
}

/// Adds the card of effects. The disc is thrown at 5 m/s.
pub fn add(p: &Parameters, report: &mut Report, top: Top, disc: Top) -> Result<()> {
    let (speed, radius, density) = (5.0, 0.1, DiscDrag::AIR_DENSITY);
    // A pitching moment of 0.02, as a flying disc has a few degrees off its balance.
    let pitch = 0.02 * 0.5 * density * speed * speed * PI * radius * radius * (2.0 * radius);
    let turned = pitch / disc.momentum();
    let air = DiscDrag::new(radius, density, DiscDrag::AIR_VISCOSITY, disc.omega_z)?;
    let slowed = -air.axial_torque(disc.omega_z) / (disc.i3 * disc.omega_z);
    // Steel: shear modulus 8e10 Pa, quality factor 100, shape factor 0.02.
    let size = p.radius.max(0.5 * p.height) * top.omega_z;
    let rate = 7850.0 * 0.02 * size * size * top.omega_z / (8e10 * 100.0);
    let (gradient, earth) = (gradient_rate(top), 7.292_115e-5);
    rotation_dynamics::effect_card! { report,
        "air tips a thrown disc":
            "C_M rho v^2 pi R^3/(L Omega_P)" = turned / disc.precession(),
            costs turned, "rad a second, in the direction of L";
        "air brakes its rotation":
            "torque/(I3 Omega_z Omega_P)" = slowed / disc.precession(),
            costs slowed, "of its rotation, a second";
        "steel is not rigid, wobble dies or grows":
            "rho K^2 R^2 Omega_z^3/(mu Q Omega_P)" = rate / top.precession(),
            costs rate, "of tan(theta), a second";
        "gravity is weaker above":
            "3 |I3 - I1| g/(2 R_E L Omega_P)" = gradient / top.precession(),
            costs gradient, "rad a second, in the direction of L";
        "the Earth turns":
            "Omega_E/Omega_P" = earth / top.precession(), costs earth, "rad a second, at most";
    }
}
