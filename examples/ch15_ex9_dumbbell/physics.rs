//! A ball hits a dumbbell: in closed form, and simulated with contacts that push and know no
//! conservation law. The mass of the ball, the length of the stick and the speed are 1.

// ANCHOR: physics
use kit::prelude::*;
use rotation_dynamics::integrators::{Dop853, Work, ode, size_or};
use rotation_dynamics::planar::contact::{
    Contact, ContactMotion, Mechanism, MechanismState, motion,
};

/// Place or velocity in the plane.
pub type Plane = [f64; 2];

/// What the three laws give; masses in m, lengths in l, speeds in v0.
#[derive(Debug, Clone, Copy)]
pub struct Answer {
    pub ball: f64,   // velocity of the ball after the hit, along its own before
    pub centre: f64, // velocity of the middle of the stick, in that direction; times m, the impulse
    pub angular_velocity: f64,
}

impl Answer {
    pub fn new(restitution: f64, slant: f64) -> Self {
        let across = cos(slant);
        // The impulse J at this slant gives the struck mass the velocity J (1 + across^2) along it.
        let impulse = (1.0 + restitution) / (2.0 + across * across);
        Self { ball: 1.0 - impulse, centre: impulse, angular_velocity: 2.0 * impulse * across }
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

/// Where the ball and the two masses are.
pub fn places(q: &[f64; 5]) -> [Plane; 3] {
    let [lower, upper] = arms(q[2]).map(|arm| [q[0] + arm[0], q[1] + arm[1]]);
    [[q[3], q[4]], lower, upper]
}

/// The velocities of the three.
pub fn velocities(MechanismState { q, v }: &MechanismState<5>) -> [Plane; 3] {
    let [lower, upper] = arms(q[2]).map(|arm| [v[0] - v[2] * arm[1], v[1] + v[2] * arm[0]]);
    [[v[3], v[4]], lower, upper]
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
        let [ball, masses @ ..] = places(&state.q);
        let [v, moves @ ..] = velocities(state);
        let contact = |name, k: usize| {
            let (arm, turn) = (arms(state.q[2])[k], state.v[2]);
            // From the ball to the mass.
            let [x, y] = [0, 1].map(|i| masses[k][i] - ball[i]);
            let far = hypot(x, y);
            let n = [x / far, y / far];
            // How fast the line of centres turns, and how the mass is kept on its circle.
            let across = n[0] * (moves[k][1] - v[1]) - n[1] * (moves[k][0] - v[0]);
            let inward = -turn * turn * (n[0] * arm[0] + n[1] * arm[1]);
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
const APPROACH: f64 = 0.8;

/// The approach, the hit at t = 0, and what follows.
pub struct Blow {
    pub motion: ContactMotion<Hit, 5, 2>,
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
        Ok(self.motion.at((t + APPROACH).clamp(0.0, self.motion.end_time()))?)
    }

    /// How near the ball comes to the upper mass between these times, from middle to middle.
    pub fn nearest(&self, from: f64, to: f64) -> f64 {
        let distance = |t| self.at(t).map_or(f64::NAN, |state| to_upper(places(&state.q)));
        least(distance, from, to)
    }

    /// When the other mass is hit.
    pub fn again(&self) -> Result<f64> {
        Ok(self.motion.event("upper bounces")?.t - APPROACH)
    }
}

/// Distance from the ball to the upper mass, from middle to middle.
pub fn to_upper([ball, _, upper]: [Plane; 3]) -> f64 {
    hypot(upper[0] - ball[0], upper[1] - ball[1])
}

/// How two masses on a table that rubs are held back: the force on the middle of the stick and
/// the moment about it, for friction on each of its half of the weight, the friction being 1.
fn rubbing(angle: f64, [u, v, turn]: [f64; 3]) -> [f64; 3] {
    let [one, other] = arms(angle).map(|[x, y]| {
        let way = [u - turn * y, v + turn * x];
        let [along, up] = way.map(|part| -0.5 * part / hypot(way[0], way[1]).max(1e-12));
        [along, up, x * up - y * along]
    });
    [0, 1, 2].map(|k| one[k] + other[k])
}

/// The part of its speed V that the middle of the stick loses in the way l, per mu g l/V^2, to
/// first order: both masses rub against their own velocities, as they are without friction.
pub fn held_back([u, v, turn]: [f64; 3]) -> f64 {
    let speed = hypot(u, v);
    let part = |k: i32| {
        let angle = turn / speed * (f64::from(k) + 0.5) / 200.0;
        let [x, y, _] = rubbing(angle, [u, v, turn]);
        -(x * u + y * v) / (200.0 * speed)
    };
    (0..200).map(part).sum()
}

/// The same part simulated, for a friction mu g l/v0^2; and the work.
pub fn rubbed([u, v, turn]: [f64; 3], friction: f64) -> Result<(f64, Work)> {
    let law = ode(|_, &[_, _, angle, u, v, turn]: &[f64; 6]| {
        let [fx, fy, moment] = rubbing(angle, [u, v, turn]).map(|force| friction * force);
        [u, v, turn, fx, fy, 4.0 * moment]
    })
    .scaled(size_or([1.0; 6]));
    let (start, speed) = ([0.0, 0.0, 0.0, u, v, turn], hypot(u, v));
    let far = |y: &[f64; 6]| hypot(y[0], y[1]) - 1.0;
    let (there, work) = Dop853::new(1e-11)?.zero(&law, start, 1, 20.0 / speed, far)?;
    Ok((1.0 - hypot(there.state[3], there.state[4]) / speed, work))
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
