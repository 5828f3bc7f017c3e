//! What the page leaves out: a camera sees turns and no rates, a laboratory turns, a rotor swells.

use super::*;
use rotation_dynamics::integrators::{Dop853, Integrator, Work};

/// By how much the turn between two pictures, over the time between them, misses the angular
/// velocity in the middle (rad/s).
pub fn filmed(g: &Gyroscope, time: f64) -> Result<f64> {
    let (before, after) = (g.after(-0.5 * time).attitude()?, g.after(0.5 * time).attitude()?);
    let turn = before.inverse().then(&after).rotation_vector();
    Ok((turn / time - g.angular_velocity()).norm())
}

/// The same to first order, |Omega''/24 - Omega x Omega'/12| dt^2: the mean of Omega is not its
/// value in the middle, and turns about changing axes do not add up.
pub fn missed(g: &Gyroscope, time: f64) -> f64 {
    let ([x, _, z], [phi, theta, zeta]) = (g.triad(), g.rates);
    // What turns the triad changes with x, and the spin with z.
    let (turning, node) = (g.of_triad(), UP.cross(&x) * phi);
    let spin = turning.cross(&z);
    let first = node * theta + spin * zeta;
    let second =
        UP.cross(&node) * (phi * theta) + ((node * theta).cross(&z) + turning.cross(&spin)) * zeta;
    let twist = g.angular_velocity().cross(&first);
    (second / 24.0 - twist / 12.0).norm() * time * time
}

/// How far the rim of a spinning elastic disc moves out, over R rho Omega^2 R^2/E; `nu` is
/// Poisson's ratio. At x = r/R the rings are stretched by e and the stress along the radius is
/// s, over that of the spinning; none is left at the rim.
pub fn swollen(nu: f64) -> Result<(f64, Work)> {
    let disc = ode(|x, [e, s]: &[f64; 2]| {
        let (along, around) = ((1.0 - nu * nu) * s - nu * e, nu * s + e);
        [(along - e) / x, (around - s) / x - x]
    })
    .scaled(size_or([1.0; 2]));
    // In the middle it is stretched alike in all directions; the stress at the rim is linear
    // in by how much.
    let run = |e: f64| Dop853::new(1e-12)?.advance(&disc, 1e-2, &[e, e / (1.0 - nu)], 1.0);
    let (([a, left], once), ([b, more], again)) = (run(0.0)?, run(1.0)?);
    Ok((a + (b - a) * left / (left - more), once + again))
}

/// The card of effects.
pub fn effects(p: &Parameters, report: &mut Report) -> Result<()> {
    let (g, dt, earth) = (Gyroscope::of(p, 1.0), 1e-3, 7.292_115e-5);
    let (omega, size, sum) = (g.angular_velocity(), g.angular_velocity().norm(), dt * g.fastest());
    // What the first order leaves, and rounding of angles over the time.
    let next = 2e-3 * sum * sum * sum * sum / dt + 1e-12;
    // A rotor of steel with 6 cm radius: 7850 kg/m^3, 200 GPa, Poisson's ratio 0.3.
    let (spinning, nu) = (7850.0 * p.spin * p.spin * 0.06 * 0.06 / 2e11, 0.3);
    let (rim, work) = swollen(nu)?;
    effect_card! { report,
        "pictures 1 ms apart, not a rate": "Omega dt" = size * dt, costs missed(&g, dt), "rad/s of Omega, to first order",
            measured filmed(&g, dt)?, within next, at_cost "none, 2 attitudes";
        "turning of the laboratory with the Earth": "Omega_E/Omega" = earth / size.max(1e-300), costs earth, "rad/s of Omega",
            measured (seen_from(earth, omega)? - omega).norm(), within 1e-11 * size, at_cost "none, 4 attitudes";
        "stretch of the spinning rotor": "rho Omega^2 R^2/E" = spinning, costs 0.25 * (1.0 - nu) * spinning, "of v at the rim",
            measured rim * spinning, at_cost format!("none, {} derivatives", work.derivatives);
    }
}
