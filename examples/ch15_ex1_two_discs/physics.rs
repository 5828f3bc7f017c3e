//! Two discs on one axle that rub on each other: in closed form, and by a contact that pushes and
//! rubs and knows no conservation law.

// ANCHOR: physics
use super::Parameters;
use kit::prelude::*;
use rotation_dynamics::integrators::{Dop853, Event, Ode, Solution, ode, size_or};
use rotation_dynamics::planar::contact::{
    Contact, ContactMotion, Mechanism, MechanismState, motion_within,
};

/// From the kept angular momentum, and the time from a constant torque.
#[derive(Debug, Clone, Copy)]
pub struct Answer {
    pub common: f64,   // the rate at which both turn in the end, rad/s
    pub relative: f64, // how fast the upper disc turns on the lower one at the start, rad/s
    pub reduced: f64,  // I1 I2/(I1 + I2), kg m^2
    pub lost: f64,     // kinetic energy that is lost, J
    pub time: f64,     // how long friction acts with its constant torque, s
}

impl Answer {
    pub fn new(p: &Parameters) -> Self {
        let (whole, relative) = (p.upper + p.lower, p.upper_rate - p.lower_rate);
        let (share, reduced) = (p.upper / whole, p.upper * (p.lower / whole));
        Self {
            common: p.lower_rate + share * relative,
            relative,
            reduced,
            lost: 0.5 * reduced * relative * relative,
            time: reduced * relative.abs() / p.friction,
        }
    }
}

/// Kinetic energy of the turning at these rates.
pub fn kinetic_energy(p: &Parameters, [upper, lower]: [f64; 2]) -> f64 {
    0.5 * p.upper * upper * upper + 0.5 * p.lower * lower * lower
}

// ANCHOR: scene
/// The two discs: how high the upper one is above the lower, and how far both have turned.
#[derive(Debug, Clone)]
pub struct Discs {
    pub p: Parameters,
    pub bounce: f64, // the part of its speed with which the upper disc jumps back
}

impl Mechanism<3, 1> for Discs {
    fn mass(&self, _: &[f64; 3]) -> [[f64; 3]; 3] {
        let Parameters { upper, lower, .. } = self.p;
        [[1.0, 0.0, 0.0], [0.0, upper, 0.0], [0.0, 0.0, lower]]
    }

    fn force(&self, _: &MechanismState<3>) -> [f64; 3] {
        [-self.p.gravity, 0.0, 0.0]
    }

    fn contacts(&self, discs: &MechanismState<3>) -> [Contact<3>; 1] {
        // The lever at which the weight gives the torque of the friction.
        let lever = self.p.friction / self.p.gravity;
        let faces = Contact::new("discs", discs.q[0], [1.0, 0.0, 0.0], 0.0);
        let faces = faces.tangent([0.0, 1.0, -1.0], 0.0);
        [faces.friction(lever).restitution(self.bounce)]
    }
    // ANCHOR_END: scene

    fn scale(&self, _: &MechanismState<3>) -> MechanismState<3> {
        let (a, largest) = (Answer::new(&self.p), rate(&self.p));
        let v = [self.p.gravity * a.time, largest, largest];
        let q = v.map(|rate| rate * a.time);
        MechanismState { q, v }
    }
}

/// The larger of the two rates: against it errors count.
pub fn rate(p: &Parameters) -> f64 {
    p.upper_rate.abs().max(p.lower_rate.abs())
}

/// A fall of the upper disc, and the slip.
pub type Fall = ContactMotion<Discs, 3, 1>;

/// The motion from the release until `ends`, in units of the time of the slip.
pub fn fallen(p: &Parameters, bounce: f64, ends: f64, tolerance: f64) -> Result<Fall> {
    let (q, v) = ([p.drop, 0.0, 0.0], [0.0, p.upper_rate, p.lower_rate]);
    let (start, end) = (MechanismState { q, v }, ends * Answer::new(p).time);
    let p = p.clone();
    Ok(motion_within(Discs { p, bounce }, tolerance, start, end)?)
}

/// Rates of the two discs and the heat, when the torque is this function of the slip.
fn rubbing(p: &Parameters, torque: impl Fn(f64) -> f64) -> impl Ode<3> {
    let (upper, lower) = (p.upper, p.lower);
    ode(move |_, &[fast, slow, _]: &[f64; 3]| {
        let (slip, torque) = (fast - slow, torque(fast - slow));
        [-torque / upper, torque / lower, torque * slip]
    })
    .scaled(size_or([1.0; 3]))
}

/// That motion until the slip is over, or has come down to this part of it.
pub fn rubbed(p: &Parameters, left: f64, torque: impl Fn(f64) -> f64) -> Result<Solution<3>> {
    let a = Answer::new(p);
    let over = move |_: f64, y: &[f64; 3]| (y[0] - y[1]) / a.relative - left;
    let start = [p.upper_rate, p.lower_rate, 0.0];
    let over = Event::falling("over", over).terminal();
    let method = Dop853::new(p.tolerance.min(1e-9))?;
    Ok(method.solve(&rubbing(p, torque), 0.0, &start, 1e3 * a.time, &[over])?)
}
// ANCHOR_END: physics

// ANCHOR: signed
/// Friction with the sign of the slip: the solver that many would write.
pub fn sign(p: &Parameters) -> impl Ode<3> {
    let friction = p.friction;
    rubbing(p, move |slip: f64| if slip == 0.0 { 0.0 } else { friction * slip.signum() })
}

/// It, by equal steps of Euler's method: the slip at each of them.
pub fn chattering(p: &Parameters, steps: u32, end: f64) -> Vec<(f64, f64)> {
    let (law, h) = (sign(p), end / f64::from(steps));
    let mut state = [p.upper_rate, p.lower_rate, 0.0];
    let mut slips = vec![(0.0, state[0] - state[1])];
    for k in 1..=steps {
        let rates = law.derivative(0.0, &state);
        state = core::array::from_fn(|i| state[i] + h * rates[i]);
        slips.push((h * f64::from(k), state[0] - state[1]));
    }
    slips
}
// ANCHOR_END: signed
