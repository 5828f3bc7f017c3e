//! A particle hits the end of a rod and sticks, simulated with forces and impulses of
//! contacts: no conservation law is used. The rod is hinged at its middle, or free.

use core::array::from_fn;
use rotation_dynamics::Result;
use rotation_dynamics::integrators::{Dop853, Work, ode, size_or};
use rotation_dynamics::math::{hypot, sincos};
use rotation_dynamics::planar::contact::{
    Contact, ContactMotion, Mechanism, MechanismState, motion_within,
};

/// Rod and particle on a table; the rod lies along y, the particle comes along x.
#[derive(Debug, Clone, Copy)]
pub struct Strike {
    pub rod: f64,      // mass of the rod, kg
    pub particle: f64, // mass of the particle, kg
    pub length: f64,   // of the rod, m
    pub speed: f64,    // of the particle along x, m/s; negative if it comes against x
    pub hinged: bool,  // whether the middle of the rod is held
    pub arm: f64,      // how far from its middle the rod is hit, m: usually l/2
    pub rub: f64,      // coefficient of friction of the table after the impact; 0 if it is smooth
}

/// Pieces of the rod, each of which the table brakes against its own velocity.
const PIECES: u32 = 64;

/// Coordinates: the middle of the rod, its angle, the particle.
impl Mechanism<5, 3> for Strike {
    fn mass(&self, _: &[f64; 5]) -> [[f64; 5]; 5] {
        let diagonal = [self.rod, self.rod, self.spin(), self.particle, self.particle];
        from_fn(|j| from_fn(|k| if j == k { diagonal[j] } else { 0.0 }))
    }

    fn force(&self, MechanismState { q, v }: &MechanismState<5>) -> [f64; 5] {
        let ((s, c), mut force) = (sincos(q[2]), [0.0; 5]);
        if self.rub == 0.0 || v[2] == 0.0 {
            return force;
        }
        let brake = |mass: f64, [x, y]: [f64; 2]| {
            let over_speed = -self.rub * 9.80665 * mass / hypot(x, y).max(1e-300);
            [x * over_speed, y * over_speed]
        };
        [force[3], force[4]] = brake(self.particle, [v[3], v[4]]);
        for k in 0..PIECES {
            let place = self.length * ((f64::from(k) + 0.5) / f64::from(PIECES) - 0.5);
            let velocity = [v[0] - v[2] * place * c, v[1] - v[2] * place * s];
            let [x, y] = brake(self.rod / f64::from(PIECES), velocity);
            force[2] -= place * (x * c + y * s);
            // What acts on a middle that is held goes into the hinge.
            if !self.hinged {
                force[0] += x;
                force[1] += y;
            }
        }
        force
    }

    fn contacts(&self, MechanismState { q, v }: &MechanismState<5>) -> [Contact<5>; 3] {
        let (s, c) = sincos(q[2]);
        // The particle as seen from the middle of the rod: how far in front, how far up.
        let ([x, y], [vx, vy]) = ([q[3] - q[0], q[4] - q[1]], [v[3] - v[0], v[4] - v[1]]);
        let (front, up) = (-c * x - s * y, -s * x + c * y);
        let (to, along) = (-c * vx - s * vy, -s * vx + c * vy);
        // A middle that is held does not answer to a push.
        let free = if self.hinged { 0.0 } else { 1.0 };
        let across = [free * c, free * s, -up, -c, -s];
        let lengthwise = [free * s, -free * c, front, -s, c];
        let bias = -v[2] * v[2] * front - 2.0 * v[2] * along;
        let bias_along = 2.0 * v[2] * to - v[2] * v[2] * up;
        // A rod at rest has not been hit; one that turns has the particle on it.
        if v[2] == 0.0 {
            let none = |name| Contact::joint(name, 0.0, [0.0; 5], 0.0);
            [Contact::new("particle", front, across, bias), none("across"), none("along")]
        } else {
            [
                Contact::new("particle", 1.0 + q[2], [0.0, 0.0, 1.0, 0.0, 0.0], 0.0),
                Contact::joint("across", front, across, bias),
                Contact::joint("along", up + self.arm, lengthwise, bias_along),
            ]
        }
    }
}

impl Strike {
    /// Moment of inertia of the rod about its middle, kg m^2.
    fn spin(&self) -> f64 {
        self.rod * self.length * self.length / 12.0
    }

    /// Total momentum, kg m/s.
    pub fn momentum(&self, MechanismState { v, .. }: &MechanismState<5>) -> [f64; 2] {
        [0, 1].map(|k| self.rod * v[k] + self.particle * v[k + 3])
    }

    /// Where the centre of mass is, m.
    pub fn centre(&self, MechanismState { q, .. }: &MechanismState<5>) -> [f64; 2] {
        let whole = self.rod + self.particle;
        [0, 1].map(|k| (self.rod * q[k] + self.particle * q[k + 3]) / whole)
    }

    /// Total angular momentum about a point at rest, kg m^2/s.
    pub fn angular_momentum(&self, state: &MechanismState<5>, [x, y]: [f64; 2]) -> f64 {
        let MechanismState { q, v } = state;
        let about = |k: usize| (q[k] - x) * v[k + 1] - (q[k + 1] - y) * v[k];
        self.rod * about(0) + self.spin() * v[2] + self.particle * about(3)
    }

    /// Kinetic energy, J.
    pub fn energy(&self, MechanismState { v, .. }: &MechanismState<5>) -> f64 {
        let square = |k: usize| v[k] * v[k] + v[k + 1] * v[k + 1];
        let spin = self.length * self.length / 12.0 * v[2] * v[2];
        0.5 * (self.rod * (square(0) + spin) + self.particle * square(3))
    }

    /// An impact with a contact that gives way, its force in proportion to how far it is
    /// pressed in, until rod and particle have one speed. A pin of the hinge rubs: its radius
    /// (m) times its coefficient of friction is taken off the lever of that force. Two parts:
    /// the angular velocity over that without a pin, and how far the rod is behind one that
    /// turns from the first touch, over the angle by which that has turned.
    pub fn pressed(&self, pin: f64) -> Result<([f64; 2], Work)> {
        let turns = 12.0 * self.arm * self.arm / (self.rod * self.length * self.length);
        let free = if self.hinged { 0.0 } else { 1.0 / self.rod };
        let part = turns / (turns + free + 1.0 / self.particle);
        let lever = 1.0 - pin / self.arm;
        let slows = 1.0 - part + part * lever;
        // Depth, its rate, angular velocity and angle, each in the unit that makes it simple.
        let law = ode(move |_, &[depth, closing, rate, _]: &[f64; 4]| {
            [closing, -slows * depth, lever * depth, rate]
        });
        let (law, start) = (law.scaled(size_or([1.0; 4])), [0.0, 1.0, 0.0, 0.0]);
        let (met, work) = Dop853::new(1e-14)?.zero(&law, start, 1, 10.0, |y| y[1])?;
        let [_, _, rate, angle] = met.state;
        Ok(([rate, 1.0 - angle / (rate * met.t)], work))
    }

    /// What the simulation gives, which has the particle come along x; mirrored if it comes
    /// against x.
    fn mirrored(&self, MechanismState { q, v }: MechanismState<5>) -> MechanismState<5> {
        let sense = self.speed.signum();
        let signs = [sense, 1.0, sense, sense, 1.0];
        MechanismState { q: from_fn(|k| signs[k] * q[k]), v: from_fn(|k| signs[k] * v[k]) }
    }

    /// The time in which the particle comes as far as the rod is long, s.
    pub fn unit(&self) -> f64 {
        self.length / self.speed.abs()
    }
}

/// What happens: a flight, an impact at t = 0, and what comes after it.
pub struct Blow {
    pub before: MechanismState<5>, // just before and
    pub after: MechanismState<5>,  // just after the impact
    strike: Strike,
    impact: f64,
    motion: ContactMotion<Strike, 5, 3>,
}

impl Blow {
    /// From `approach` units before the impact to `end` units after it, within `tolerance`.
    pub fn new(strike: Strike, tolerance: f64, approach: f64, end: f64) -> Result<Self> {
        let (unit, l) = (strike.unit(), strike.length);
        let start = MechanismState {
            q: [0.0, 0.0, 0.0, -approach * l, -strike.arm],
            v: [0.0, 0.0, 0.0, strike.speed.abs(), 0.0],
        };
        let motion = motion_within(strike, tolerance, start, (approach + end) * unit)?;
        // It leaves the list of what can touch, and is held instead.
        let hit = motion.event("particle bounces")?.clone();
        let seen = |state| strike.mirrored(state);
        let (before, after, impact) = (seen(hit.before), seen(hit.after), hit.t);
        Ok(Self { strike, before, after, impact, motion })
    }

    /// The state at `t` (s), counted from the impact.
    pub fn at(&self, t: f64) -> Result<MechanismState<5>> {
        let state = self.motion.at((t + self.impact).clamp(0.0, self.motion.end_time()))?;
        Ok(self.strike.mirrored(state))
    }

    pub fn end(&self) -> Result<MechanismState<5>> {
        self.at(f64::INFINITY)
    }

    pub fn work(&self) -> Work {
        self.motion.work()
    }
}
