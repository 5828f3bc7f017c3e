//! Two gears: in closed form, as wheels whose rims rub, and B as four particles.

// ANCHOR: physics
use super::Parameters;
use kit::prelude::*;
use rotation_dynamics::planar::contact::{
    Contact, ContactMotion, Mechanism, MechanismState, motion_within,
};

/// R1/R2.
pub fn ratio(p: &Parameters) -> f64 {
    p.radius_a / p.radius_b
}

/// Rate of B, whose axis is carried round at the rate `arm` (0 if it is at rest).
pub fn rate_b(p: &Parameters, arm: f64) -> f64 {
    arm - (p.rate - arm) * ratio(p)
}

/// Angular momentum of both about the axis of A.
pub fn momentum(p: &Parameters, arm: f64) -> f64 {
    let distance = p.radius_a + p.radius_b;
    let carried = p.mass_b * distance * distance * arm;
    p.inertia_a * p.rate + carried + p.inertia_b * rate_b(p, arm)
}

/// Impulse of one rim on the other until B is up to speed, N s.
pub fn push(p: &Parameters) -> f64 {
    p.inertia_b * rate_b(p, 0.0).abs() / p.radius_b
}

/// How long friction takes for this, s.
pub fn time(p: &Parameters) -> f64 {
    push(p) / p.friction
}

/// The rate of A in the end if nothing drives it.
pub fn undriven(p: &Parameters) -> f64 {
    let r = ratio(p);
    p.rate / (1.0 + p.inertia_b / p.inertia_a * r * r)
}

/// Kinetic energy of the two at these rates, axes at rest.
pub fn kinetic_energy(p: &Parameters, [a, b]: [f64; 2]) -> f64 {
    0.5 * p.inertia_a * a * a + 0.5 * p.inertia_b * b * b
}

// ANCHOR: scene
/// Two wheels on axes at rest, their rims pressed together; the angles by which they have turned.
#[derive(Debug, Clone)]
pub struct Wheels {
    pub p: Parameters,
    pub driven: bool, // whether a motor keeps the rate of A
}

impl Mechanism<2, 2> for Wheels {
    fn mass(&self, _: &[f64; 2]) -> [[f64; 2]; 2] {
        [[self.p.inertia_a, 0.0], [0.0, self.p.inertia_b]]
    }

    fn force(&self, _: &MechanismState<2>) -> [f64; 2] {
        [0.0; 2]
    }

    fn contacts(&self, _: &MechanismState<2>) -> [Contact<2>; 2] {
        // Where they touch the rim of A moves up at R1 Omega1, that of B at -R2 Omega2.
        let (p, slip) = (&self.p, [self.p.radius_a, self.p.radius_b]);
        let rims = Contact::pressed("rims", p.friction).tangent(slip, 0.0);
        let on = if self.driven { 1.0 } else { 0.0 };
        let motor = Contact::joint("motor", 0.0, [on, 0.0], 0.0).rising(on * p.rate, 0.0);
        [rims.friction(1.0), motor]
    }
    // ANCHOR_END: scene

    fn scale(&self, _: &MechanismState<2>) -> MechanismState<2> {
        let v = [self.p.rate.abs(), rate_b(&self.p, 0.0).abs()];
        let q = v.map(|rate| rate * time(&self.p));
        MechanismState { q, v }
    }
}

/// A motion of the wheels.
pub type Run = ContactMotion<Wheels, 2, 2>;

/// B at rest at first; until 1.5 times the time that it needs.
pub fn spun_up(p: &Parameters, driven: bool, tolerance: f64) -> Result<Run> {
    let (q, v, end) = ([0.0; 2], [p.rate, 0.0], 1.5 * time(p));
    let (p, start) = (p.clone(), MechanismState { q, v });
    Ok(motion_within(Wheels { p, driven }, tolerance, start, end)?)
}
// ANCHOR_END: physics

// ANCHOR: particles
/// Where a point of B is, at this distance and angle from its axis, by the turns of arm and gear.
fn place(p: &Parameters, [arm, rate]: [f64; 2], t: f64, [distance, angle]: [f64; 2]) -> [f64; 2] {
    let ((s, c), (u, v)) = (sincos(arm * t), sincos(rate * t + angle));
    let apart = p.radius_a + p.radius_b;
    [apart * c + distance * v, apart * s + distance * u]
}

/// Its velocity at t = 0, from four places.
fn velocity(p: &Parameters, rates: [f64; 2], point: [f64; 2]) -> [f64; 2] {
    let h = 1e-3 / rates[0].abs().max(rates[1].abs()).max(p.rate.abs());
    let at = |k: f64| place(p, rates, k * h, point);
    let (near, far) = ([at(-1.0), at(1.0)], [at(-2.0), at(2.0)]);
    [0, 1].map(|i| (8.0 * (near[1][i] - near[0][i]) - (far[1][i] - far[0][i])) / (12.0 * h))
}

/// The rate at which the point of B that touches A moves as the rim of A: tried at two rates.
pub fn without_slip(p: &Parameters, arm: f64) -> f64 {
    let inward = [p.radius_b, 2.0 * FRAC_PI_2];
    let slip = |rate: f64| velocity(p, [arm, rate], inward)[1] - p.radius_a * p.rate;
    let tried = arm.abs().max(p.rate.abs());
    tried * slip(0.0) / (slip(0.0) - slip(tried))
}

/// Angular momentum about a point of B as four particles with its mass and moment of inertia.
pub fn particles(p: &Parameters, rates: [f64; 2], about: [f64; 2]) -> f64 {
    let distance = (p.inertia_b / p.mass_b).sqrt();
    let one = |k: i32| {
        let point = [distance, FRAC_PI_2 * (f64::from(k) + 0.3)];
        let ([x, y], [u, v]) = (place(p, rates, 0.0, point), velocity(p, rates, point));
        0.25 * p.mass_b * ((x - about[0]) * v - (y - about[1]) * u)
    };
    (0..4).map(one).sum()
}
// ANCHOR_END: particles
