//! A particle hits the end of a rod and sticks, simulated with forces and impulses of
//! contacts: no conservation law is used. The rod is hinged at its middle, or free.

use rotation_dynamics::Result;
use rotation_dynamics::integrators::Work;
use rotation_dynamics::math::sincos;
use rotation_dynamics::planar::contact::{Contact, Mechanism, Motion, State, motion_within};

/// Rod and particle on a smooth table; the rod lies along y, the particle comes along x.
#[derive(Debug, Clone, Copy)]
pub struct Strike {
    /// Mass of the rod, kg.
    pub rod: f64,
    /// Mass of the particle, kg.
    pub particle: f64,
    /// Length of the rod, m.
    pub length: f64,
    /// Speed of the particle, m/s.
    pub speed: f64,
    /// Whether the middle of the rod is held.
    pub hinged: bool,
}

/// Coordinates: the middle of the rod, its angle, the particle.
impl Mechanism<5, 10, 3> for Strike {
    fn mass(&self, _: &[f64; 5]) -> [[f64; 5]; 5] {
        let (m, i) = (self.rod, self.rod * self.length * self.length / 12.0);
        let diagonal = [m, m, i, self.particle, self.particle];
        core::array::from_fn(|j| core::array::from_fn(|k| if j == k { diagonal[j] } else { 0.0 }))
    }

    fn force(&self, _: &State<5>) -> [f64; 5] {
        [0.0; 5]
    }

    fn contacts(&self, State { q, v }: &State<5>) -> [Contact<5>; 3] {
        let (s, c) = sincos(q[2]);
        // The particle as seen from the middle of the rod: how far in front, how far up.
        let ([x, y], [vx, vy]) = ([q[3] - q[0], q[4] - q[1]], [v[3] - v[0], v[4] - v[1]]);
        let (front, up) = (-c * x - s * y, -s * x + c * y);
        let (to, along) = (-c * vx - s * vy, -s * vx + c * vy);
        let square = v[2] * v[2];
        // A middle that is held does not answer to a push.
        let free = if self.hinged { 0.0 } else { 1.0 };
        let across = [free * c, free * s, -up, -c, -s];
        let lengthwise = [free * s, -free * c, front, -s, c];
        let [bias, bias_along] = [
            -square * front - 2.0 * v[2] * along,
            2.0 * v[2] * to - square * up,
        ];
        // A rod at rest has not been hit; one that turns has the particle on it.
        if v[2] == 0.0 {
            let none = |name| Contact::joint(name, 0.0, [0.0; 5], 0.0);
            [
                Contact::new("particle", front, across, bias),
                none("across"),
                none("along"),
            ]
        } else {
            [
                Contact::new("particle", 1.0 + q[2], [0.0, 0.0, 1.0, 0.0, 0.0], 0.0),
                Contact::joint("across", front, across, bias),
                Contact::joint("along", up + 0.5 * self.length, lengthwise, bias_along),
            ]
        }
    }
}

impl Strike {
    /// Total momentum, kg m/s.
    pub fn momentum(&self, State { v, .. }: &State<5>) -> [f64; 2] {
        [0, 1].map(|k| self.rod * v[k] + self.particle * v[k + 3])
    }

    /// Where the centre of mass is, m.
    pub fn centre(&self, State { q, .. }: &State<5>) -> [f64; 2] {
        let whole = self.rod + self.particle;
        [0, 1].map(|k| (self.rod * q[k] + self.particle * q[k + 3]) / whole)
    }

    /// Total angular momentum about a point at rest, kg m^2/s.
    pub fn angular_momentum(&self, State { q, v }: &State<5>, [x, y]: [f64; 2]) -> f64 {
        let about = |k: usize| (q[k] - x) * v[k + 1] - (q[k + 1] - y) * v[k];
        let spin = self.rod * self.length * self.length / 12.0 * v[2];
        self.rod * about(0) + spin + self.particle * about(3)
    }

    /// Kinetic energy, J.
    pub fn energy(&self, State { v, .. }: &State<5>) -> f64 {
        let square = |k: usize| v[k] * v[k] + v[k + 1] * v[k + 1];
        let spin = self.length * self.length / 12.0 * v[2] * v[2];
        0.5 * (self.rod * (square(0) + spin) + self.particle * square(3))
    }

    /// The time in which the particle comes as far as the rod is long, s.
    pub fn unit(&self) -> f64 {
        self.length / self.speed
    }
}

/// What happens: a flight, an impact at t = 0, and what comes after it.
pub struct Blow {
    /// Just before and just after.
    pub before: State<5>,
    pub after: State<5>,
    impact: f64,
    motion: Motion<Strike, 5, 10, 3>,
}

impl Blow {
    /// From `approach` units before the impact to `end` units after it, within `tolerance`.
    pub fn new(strike: Strike, tolerance: f64, approach: f64, end: f64) -> Result<Self> {
        let (unit, l) = (strike.unit(), strike.length);
        let start = State {
            q: [0.0, 0.0, 0.0, -approach * l, -0.5 * l],
            v: [0.0, 0.0, 0.0, strike.speed, 0.0],
        };
        let motion = motion_within(strike, tolerance, start, (approach + end) * unit)?;
        // It leaves the list of what can touch, and is held instead.
        let hit = motion.event("particle bounces")?.clone();
        let (before, after, impact) = (hit.before, hit.after, hit.t);
        Ok(Self {
            before,
            after,
            impact,
            motion,
        })
    }

    /// The state at `t` (s), counted from the impact.
    pub fn at(&self, t: f64) -> Result<State<5>> {
        self.motion
            .at((t + self.impact).clamp(0.0, self.motion.end_time()))
    }

    /// The state at the end.
    pub fn end(&self) -> Result<State<5>> {
        self.motion.at(self.motion.end_time())
    }

    /// What it cost.
    pub fn work(&self) -> Work {
        self.motion.work()
    }
}
