//! Two bodies on a line that collide, one of them up to 1e12 times the other.

use super::events::{Bodies, moving, tightest};
use super::*;
use rotation_dynamics::planar::contact::{Contact, motion};

/// Of the one that hits (m/s): at 1 m/s the energies of a heavy mass are whole numbers, and
/// their difference is exact by luck.
pub const SPEED: f64 = 1.7;

/// The speed of the one that is hit, from what the energy lacks.
pub fn by_energy(m: f64, e: f64) -> f64 {
    let first = SPEED * (m - e) / (m + 1.0);
    let lost = 0.5 * (1.0 - e * e) * m / (1.0 + m) * SPEED * SPEED;
    let left = 0.5 * m * SPEED * SPEED - lost - 0.5 * m * first * first;
    (2.0 * left.max(0.0)).sqrt()
}

/// A mass that hits another of 1 kg, which is at rest 1 m on: both speeds, each relative to itself.
pub fn hit(m: f64, e: f64) -> Result<Answered> {
    let truth = [(m - e) / (m + 1.0), m * (1.0 + e) / (m + 1.0)].map(|part| part * SPEED);
    let meet = |gap: f64| [Contact::new("they meet", gap, [-1.0, 1.0], 0.0).restitution(e)];
    let pair = Bodies([m, 1.0], |_| [0.0; 2], |pair| meet(pair.q[1] - pair.q[0]));
    let found = motion(&pair, &tightest()?, moving([0.0, 1.0], [SPEED, 0.0]), 2.0);
    let after = found.map(|found| found.events().first().map(|event| event.after.v));
    // A product and a sum of what is given.
    let condition = 4.0;
    let off = |i: usize| {
        let speeds = after.clone().map(|speeds| speeds.unwrap_or([f64::NAN; 2]));
        let answer = speeds.map(|v| (v[i] / truth[i] - 1.0).abs());
        (answer, By::Contacts.bound(condition))
    };
    let error = (by_energy(m, e) / truth[1] - 1.0).abs();
    let naive = ("the second speed from what is left of the energy", error);
    Ok(Answered(condition, naive, vec![off(0), off(1)]))
}

family! { FAMILY, "impacts": "Impacts of a trillion to one",
    by [By::Contacts], in ["speed of the one that hits", "speed of the one that is hit"], seen in stepped::pushed;
    "1e-12 hits 1, elastic", "what the heavy one gets is lost in the energy of the light one": hit(1e-12, 1.0);
    "1e-8 hits 1, elastic", "what the heavy one gets is lost in the energy of the light one": hit(1e-8, 1.0);
    "1e-6 hits 1, half elastic", "what the heavy one gets is lost in the energy of the light one": hit(1e-6, 0.5);
    "1e6 hits 1, half elastic", "what the light one gets is lost in the energy of the heavy one": hit(1e6, 0.5);
    "1e8 hits 1, elastic", "what the light one gets is lost in the energy of the heavy one": hit(1e8, 1.0);
    "1e12 hits 1, elastic", "what the light one gets is lost in the energy of the heavy one": hit(1e12, 1.0);
    "1e12 hits 1, plastic", "what the light one gets is lost in the energy of the heavy one": hit(1e12, 0.0);
}
