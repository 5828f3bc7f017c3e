//! A ball hits a dumbbell: in closed form, and simulated with contacts that push and know no
//! conservation law. The mass of the ball, the length of the stick and the speed are 1.

// ANCHOR: physics
use rotation_dynamics::integrators::{Dop853, Work, ode, size_or};
use rotation_dynamics::math::{cos, hypot, sincos};
use rotation_dynamics::planar::contact::{
    Contact, ContactEvent, ContactMotion, Mechanism, MechanismState, motion,
};
use rotation_dynamics::{Error, Result};

/// Place or velocity in the plane.
pub type Plane = [f64; 2];

/// What the three laws give; masses in m, lengths in l, speeds in v0.
#[derive(Debug, Clone, Copy)]
pub struct Answer {
    pub impulse: f64,
    pub ball: f64,   // velocity of the ball after the hit, along its own before
    pub centre: f64, // velocity of the middle of the stick, in the same direction
    pub angular_velocity: f64,
}

impl Answer {
    pub fn new(restitution: f64, slant: f64) -> Self {
        let across = cos(slant);
        // The impulse J at this slant gives the struck mass the velocity J (1 + across^2) along it.
        let impulse = (1.0 + restitution) / (2.0 + across * across);
        let (ball, angular_velocity) = (1.0 - impulse, 2.0 * impulse * across);
        Self { impulse, ball, centre: impulse, angular_velocity }
    }
}

/// Places after a hit at right angles, in l, when the stick has turned by `angle`: the ball, which
/// starts at the sum of the radii behind the struck mass, and the two masses on their cycloids.
pub fn cycloids(a: Answer, reach: f64, angle: f64) -> [Plane; 3] {
    let (s, c) = sincos(angle);
    let mass = |sign: f64| [0.5 * (angle + sign * s), 0.5 * (1.0 - sign * c)];
    let ball = [a.ball / a.angular_velocity * angle - reach, 0.0];
    [ball, mass(1.0), mass(-1.0)]
}

/// Ball and dumbbell, seen from above: the dumbbell lies along y.
#[derive(Debug, Clone, Copy)]
pub struct Hit {
    pub restitution: f64,
    pub slant: f64,  // direction in which the ball comes, from the x axis, rad
    pub reach: f64,  // radius of the ball and that of a mass together
    pub aside: f64,  // by how much the ball comes off the line to the middle of the mass
    pub mass: f64,   // of the dumbbell
    pub moment: f64, // of inertia of the dumbbell
}

/// The middle of the lower mass and of the upper one, seen from the middle of the stick.
pub fn arms(angle: f64) -> [Plane; 2] {
    let (s, c) = sincos(angle);
    [[0.5 * s, -0.5 * c], [-0.5 * s, 0.5 * c]]
}

/// Where the two masses are.
pub fn places(q: &[f64; 5]) -> [Plane; 2] {
    arms(q[2]).map(|arm| [q[0] + arm[0], q[1] + arm[1]])
}

/// The velocities of the two masses.
pub fn velocities(MechanismState { q, v }: &MechanismState<5>) -> [Plane; 2] {
    arms(q[2]).map(|arm| [v[0] - v[2] * arm[1], v[1] + v[2] * arm[0]])
}

impl Hit {
    /// Across the stick.
    pub const fn across(restitution: f64, reach: f64) -> Self {
        Self { restitution, slant: 0.0, reach, aside: 0.0, mass: 1.0, moment: 0.25 }
    }
}

// ANCHOR: scene
/// Coordinates: the middle of the stick, its angle, the ball.
impl Mechanism<5, 2> for Hit {
    fn mass(&self, _: &[f64; 5]) -> [[f64; 5]; 5] {
        let diagonal = [self.mass, self.mass, self.moment, 1.0, 1.0];
        core::array::from_fn(|j| core::array::from_fn(|k| if j == k { diagonal[j] } else { 0.0 }))
    }

    fn force(&self, _: &MechanismState<5>) -> [f64; 5] {
        [0.0; 5]
    }

    fn contacts(&self, state: &MechanismState<5>) -> [Contact<5>; 2] {
        let (q, v) = (&state.q, &state.v);
        let contact = |name, k: usize| {
            let (arm, at, moves) = (arms(q[2])[k], places(q)[k], velocities(state)[k]);
            let [x, y] = [at[0] - q[3], at[1] - q[4]];
            let far = hypot(x, y);
            let n = [x / far, y / far];
            // How fast the line of centres turns, and how the mass is kept on its circle.
            let across = n[0] * (moves[1] - v[4]) - n[1] * (moves[0] - v[3]);
            let inward = -v[2] * v[2] * (n[0] * arm[0] + n[1] * arm[1]);
            let gradient = [n[0], n[1], n[1] * arm[0] - n[0] * arm[1], -n[0], -n[1]];
            let bias = inward + across * across / far;
            Contact::new(name, far - self.reach, gradient, bias).restitution(self.restitution)
        };
        [contact("lower", 0), contact("upper", 1)]
    }
    // ANCHOR_END: scene
}
// ANCHOR_END: physics

/// How far the ball is from where it hits, at the start.
pub const APPROACH: f64 = 0.8;

/// The approach, the hit at t = 0, and what follows.
pub struct Blow {
    motion: ContactMotion<Hit, 5, 2>,
    pub after: MechanismState<5>, // just after the first hit
}

impl Blow {
    /// Until the time `end` after the hit.
    pub fn new(hit: Hit, step: f64, end: f64) -> Result<Self> {
        let ((s, c), far) = (sincos(hit.slant), hit.reach + APPROACH);
        let (x, y) = (-far * c - hit.aside * s, -far * s + hit.aside * c);
        let (q, v) = ([0.0, 0.5, 0.0, x, y], [0.0, 0.0, 0.0, c, s]);
        // Nothing pulls, so steps would be long, and a ball could pass a mass within one.
        let method = Dop853::new(step)?.with_longest_step(0.2 * hit.reach.min(0.25))?;
        let motion = motion(hit, &method, MechanismState { q, v }, APPROACH + end)?;
        let after = motion.event("lower bounces")?.after;
        Ok(Self { motion, after })
    }

    /// The state at this time after the hit.
    pub fn at(&self, t: f64) -> Result<MechanismState<5>> {
        let t = (t + APPROACH).clamp(0.0, self.motion.end_time());
        self.motion.at(t)
    }

    /// How near the ball comes to the upper mass between these times, from middle to middle.
    pub fn nearest(&self, from: f64, to: f64) -> f64 {
        let distance = |t| self.at(t).map_or(f64::NAN, |state| distances(&state.q)[1]);
        least(distance, from, to)
    }

    /// The second hit: when it is, and the state just after.
    pub fn again(&self) -> Result<(f64, MechanismState<5>)> {
        let (name, until) = ("a second hit", self.motion.end_time() - APPROACH);
        let none = Error::NotReached { name, until };
        let (t, event) = self.later().next().ok_or(none)?;
        Ok((t, event.after))
    }

    /// The hits after the first, with their times.
    pub fn later(&self) -> impl Iterator<Item = (f64, &ContactEvent<5, 2>)> {
        let hits = self.motion.events().iter().skip(1);
        hits.map(|event| (event.t - APPROACH, event))
    }

    /// What it cost.
    pub fn work(&self) -> Work {
        self.motion.work()
    }
}

/// How two masses on a table that rubs are held back: the force on the middle of the stick and
/// the moment about it, for friction on each of its half of the weight, the friction being 1.
fn rubbing(state: &MechanismState<5>) -> [f64; 3] {
    let ways = velocities(state).map(|[x, y]| {
        let speed = hypot(x, y).max(1e-12);
        [-0.5 * x / speed, -0.5 * y / speed]
    });
    let [a, b] = arms(state.q[2]);
    let about = |arm: Plane, way: Plane| arm[0] * way[1] - arm[1] * way[0];
    let moment = about(a, ways[0]) + about(b, ways[1]);
    [ways[0][0] + ways[1][0], ways[0][1] + ways[1][1], moment]
}

/// The part of its speed V that the middle of the stick loses in the way l, per mu g l/V^2, to
/// first order: both masses rub against their own velocities, as they are without friction.
pub fn held_back(after: &MechanismState<5>) -> f64 {
    let speed = hypot(after.v[0], after.v[1]);
    let part = |k: i32| {
        let mut there = *after;
        there.q[2] = after.v[2] / speed * (f64::from(k) + 0.5) / 200.0;
        let [x, y, _] = rubbing(&there);
        -(x * after.v[0] + y * after.v[1]) / (200.0 * speed)
    };
    (0..200).map(part).sum()
}

/// The same part simulated, for a friction mu g l/v0^2; and the work.
pub fn rubbed(after: &MechanismState<5>, friction: f64) -> Result<(f64, Work)> {
    let law = ode(|_, &[x, y, angle, u, v, turn]: &[f64; 6]| {
        let (q, v) = ([x, y, angle, 0.0, 0.0], [u, v, turn, 0.0, 0.0]);
        let [fx, fy, moment] = rubbing(&MechanismState { q, v }).map(|force| friction * force);
        [v[0], v[1], turn, fx, fy, 4.0 * moment]
    })
    .scaled(size_or([1.0; 6]));
    let ([u, v, turn, ..], speed) = (after.v, hypot(after.v[0], after.v[1]));
    let start = [0.0, 0.0, 0.0, u, v, turn];
    let far = |y: &[f64; 6]| hypot(y[0], y[1]) - 1.0;
    let (there, work) = Dop853::new(1e-11)?.zero(&law, start, 1, 20.0 / speed, far)?;
    Ok((1.0 - hypot(there.state[3], there.state[4]) / speed, work))
}

/// How far the ball is from the middle of the lower mass and of the upper one.
pub fn distances(q: &[f64; 5]) -> [f64; 2] {
    places(q).map(|[x, y]| hypot(x - q[3], y - q[4]))
}

/// The least value of a function with one valley between these places, by the golden section.
pub fn least(of: impl Fn(f64) -> f64, mut from: f64, mut to: f64) -> f64 {
    let part = 0.5 * (5.0_f64.sqrt() - 1.0);
    while to - from > 1e-9 {
        let (near, far) = (to - part * (to - from), from + part * (to - from));
        match of(near) < of(far) {
            true => to = far,
            false => from = near,
        }
    }
    of(0.5 * (from + to))
}
