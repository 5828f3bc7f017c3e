//! The motions the tests run over: every regime, both signs of gravity.

use rotation_dynamics::attitude::EulerAngles;
use rotation_dynamics::exact::heavy_top::{HeavyTop, ReducedTop, Start, SymmetricTop};
use rotation_dynamics::frame::BodyVector;

pub fn by_energy(a: f64, b: f64, c: f64, energy: f64, start: Start) -> HeavyTop {
    ReducedTop::new(a, b, c)
        .and_then(|top| HeavyTop::from_energy(top, energy, start, 0.3, -0.4))
        .expect("a motion")
}

pub fn by_angles(a: f64, b: f64, c: f64, theta: f64, rate: f64) -> HeavyTop {
    ReducedTop::new(a, b, c)
        .and_then(|top| HeavyTop::from_angles(top, theta, rate, 0.3, -0.4))
        .expect("a motion")
}

/// A body with I1 = 1, I3 = 0.4, m g l = `moment`.
pub fn by_body(moment: f64, euler: [f64; 3], omega: [f64; 3]) -> HeavyTop {
    let [phi, theta, zeta] = euler;
    SymmetricTop::new(1.0, 0.4, moment.abs(), 1.0_f64.copysign(moment))
        .and_then(|body| {
            let attitude = EulerAngles { phi, theta, zeta };
            HeavyTop::from_body(body, attitude, BodyVector::from_array(omega))
        })
        .expect("a motion")
}

/// One or more motions of every kind.
pub fn all() -> Vec<HeavyTop> {
    use Start::{ThetaMax, ThetaMin};
    vec![
        by_energy(2.0, 1.2, 0.2, 0.55, ThetaMin),
        by_energy(2.0, 0.6, 0.2, 0.11, ThetaMin),
        by_energy(2.0, 0.6, 0.2, -0.08, ThetaMax),
        by_energy(2.0, 0.6, 0.2, -0.085, ThetaMax),
        by_energy(1.0, 1.0, 0.5, 0.0, ThetaMax),
        by_energy(1.0, 1.0, 0.5, 1e-9, ThetaMax),
        by_energy(1.0, 1.0, 0.5, -1e-9, ThetaMax),
        by_energy(1.0, 1.0, 0.5, 0.2, ThetaMin),
        by_energy(1.0, -1.0, -0.5, 1.3, ThetaMax),
        by_energy(1.0, 1.0, -0.5, 0.3, ThetaMin),
        by_angles(1.25, 0.6, -0.3, 1.0, 0.3),
        by_angles(1.5, 1.0, 0.25, 1.0, 0.25),
        by_angles(1.5, 1.0, 0.25, 0.0, 0.25),
        by_angles(1.5, 1.0, -0.25, 0.0, 0.25),
        by_angles(1.5, -0.3, 1e-9, 2.0, 0.1),
        by_angles(1.5, -0.3, 0.0, 2.0, 0.1),
        by_angles(1e-3, 0.7, 0.1, 1.2, 0.02),
        by_body(2.0, [0.1, 0.8, 0.2], [0.3, -0.2, 6.0]),
        by_body(-2.0, [0.1, 0.8, 0.2], [0.3, -0.2, -6.0]),
        by_body(-2.0, [0.1, 0.8, 0.2], [0.3, 1.2, 0.0]),
        by_body(2.0, [0.1, 0.8, 0.0], [0.3, 0.0, 0.0]),
        by_body(2.0, [0.1, 0.8, 0.0], [5.0, 0.0, 0.0]),
        by_body(2.0, [0.1, 0.0, 0.2], [0.1, 0.2, 3.0]),
        by_body(2.0, [0.1, 0.0, 0.2], [0.0, 0.0, 3.0]),
        by_body(0.0, [0.1, 0.8, 0.2], [0.3, -0.2, 6.0]),
        by_body(0.0, [0.1, 0.8, 0.2], [0.0, 0.0, 0.0]),
    ]
}
