//! An Earth that yields: its bulge follows the pole in part.

use super::*;

/// The dynamical form factor J_2 and G M (m^3/s^2) of the Earth, and its radius at the equator (m).
const J2: f64 = 1.082_63e-3;
const GM: f64 = 3.986_004_418e14;
const EQUATOR: f64 = 6_378_137.0;

/// The Love number of a fluid Earth with this bulge, 3 J2 G M/(Omega^2 a^3).
pub fn fluid_love_number(p: &Parameters) -> f64 {
    let omega = TAU / p.day;
    3.0 * J2 * GM / (omega * omega * EQUATOR * EQUATOR * EQUATOR)
}

/// k_2/k_s: the part of the bulge that follows the pole.
fn following(p: &Parameters) -> Result<f64> {
    let part = p.love / fluid_love_number(p);
    from_to(0.0, 0.999_999_999_9)
        .check("k_2/k_s, the part of the bulge that follows the pole,", part)
}

/// The circuit of the pole, in turns of the Earth: that of a rigid body with A + k_2/k_s (C - A)
/// across its axis.
pub fn period(p: &Parameters) -> Result<f64> {
    let (f, part) = (flattening(p)?, following(p)?);
    Ok((1.0 / f + part) / (1.0 - part))
}

// ANCHOR: yielding
/// The same by simulation, the tensor of inertia computed anew for each direction of the
/// axis: I_0 + k_2/k_s (C - A) (w w^T - w^2/3), time in 1/Omega_z.
pub fn simulated(p: &Parameters, step: f64) -> Result<f64> {
    let (bulge, tilt) = (following(p)? * (p.c - p.a), tan(alpha(p)));
    let (across, along) = (p.a + bulge / 3.0, p.c - 2.0 * bulge / 3.0);
    let momentum = move |[x, y, z]: [f64; 3]| {
        let square = x * x + y * y + z * z;
        let yielded = |i: f64, w: f64| i * w + bulge * (square * w - square * w / 3.0);
        [yielded(across, x), yielded(across, y), yielded(along, z)]
    };
    // The rates that have this momentum: the tensor hardly changes with them.
    let rates = move |l: [f64; 3]| {
        let mut w = [l[0] / p.a, l[1] / p.a, l[2] / p.c];
        for _ in 0..40 {
            let off = momentum(w);
            w = core::array::from_fn(|i| w[i] + (l[i] - off[i]) / [p.a, p.a, p.c][i]);
        }
        w
    };
    let law = move |_, l: &[f64; 3]| {
        let w = rates(*l);
        [l[1] * w[2] - l[2] * w[1], l[2] * w[0] - l[0] * w[2], l[0] * w[1] - l[1] * w[0]]
    };
    let earth = ode(law).scaled(move |_| [p.a * tilt, p.a * tilt, p.c]);
    let (back, _) =
        Dop853::new(step)?.zero(&earth, momentum([tilt, 0.0, 1.0]), 2, 1e9, |l| l[1])?;
    Ok(back.t / TAU)
}
// ANCHOR_END: yielding

pub fn claims(p: &Parameters, report: &mut Report) -> Result<()> {
    let (k_s, elastic) = (fluid_love_number(p), period(p)?);
    let days = p.day / DAY;
    let simulated = simulated(p, 1e-13)?;
    // The formula is that of a small wobble.
    let bound = (1e-8 + alpha(p) * alpha(p)) * elastic;
    // The notes' own (C - A)/(M R^2), whatever the parameters are.
    let fluid = 1.084e-3 / J2;
    // The Love number for which the circuit takes the 433 days that are observed.
    let early = |k: f64| Ok::<_, kit::Error>(period(&p.but(|p| p.love = k))? * days - 433.0 < 0.0);
    let free = 1.0 / flattening(p)?;
    let needed = (433.0 / days - free) / (433.0 / days + 1.0) * k_s;
    claims! { report,
        /// Love number of a fluid Earth with this bulge
        k_s: k_s, "-", "the notes' C - A instead of J_2" => k_s * fluid, within 2e-3 * k_s.max(1.0), in "An Earth that yields":
            3.0 * k_s => "the potential of the rotation has a third in it";
        /// circuit of the pole of a mantle that yields, in turns of the Earth
        elastic_period: elastic, "-", "simulated with its tensor" => simulated, within bound, in "An Earth that yields":
            free => "that is the rigid Earth",
            free * (1.0 - p.love / k_s) => "what yields calls the pole back less strongly";
        /// the same in solar days
        elastic_period_solar: elastic * days, "d", "simulated with its tensor" => simulated * days, within bound;
        /// Love number that gives 433 days
        love_needed: needed, "-", "bisection of the period" => try_bisect([0.0, 0.999_999 * k_s], 0.0, early)?[1],
        within 1e-12, if free * days <= 433.0;
    }
}
