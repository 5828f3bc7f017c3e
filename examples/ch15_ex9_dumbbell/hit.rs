//! A ball hits a dumbbell, simulated with contacts that push: no conservation law is used, and
//! whoever meets again is hit again. Mass of the ball, length of the stick and speed are 1.

use rotation_dynamics::Result;
use rotation_dynamics::integrators::{Dop853, Work};
use rotation_dynamics::math::{hypot, sincos};
use rotation_dynamics::planar::contact::{Contact, Event, Mechanism, Motion, State, motion};

/// Ball and dumbbell, seen from above: the dumbbell lies along y.
#[derive(Debug, Clone, Copy)]
pub struct Hit {
    /// Coefficient of restitution.
    pub restitution: f64,
    /// Direction in which the ball comes, from the x axis, rad.
    pub slant: f64,
    /// Radius of the ball and that of a mass together.
    pub reach: f64,
}

/// Place or velocity in the plane.
pub type Plane = [f64; 2];

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
pub fn velocities(State { q, v }: &State<5>) -> [Plane; 2] {
    arms(q[2]).map(|arm| [v[0] - v[2] * arm[1], v[1] + v[2] * arm[0]])
}

// ANCHOR: scene
/// Coordinates: the middle of the stick, its angle, the ball.
impl Mechanism<5, 10, 2> for Hit {
    fn mass(&self, _: &[f64; 5]) -> [[f64; 5]; 5] {
        let diagonal = [1.0, 1.0, 0.25, 1.0, 1.0];
        core::array::from_fn(|j| core::array::from_fn(|k| if j == k { diagonal[j] } else { 0.0 }))
    }

    fn force(&self, _: &State<5>) -> [f64; 5] {
        [0.0; 5]
    }

    fn contacts(&self, state: &State<5>) -> [Contact<5>; 2] {
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
            Contact::new(
                name,
                far - self.reach,
                gradient,
                inward + across * across / far,
            )
            .restitution(self.restitution)
        };
        [contact("lower", 0), contact("upper", 1)]
    }
    // ANCHOR_END: scene
}

/// How far the ball is from where it hits, at the start.
pub const APPROACH: f64 = 0.8;

/// The approach, the hit at t = 0, and what follows.
pub struct Blow {
    motion: Motion<Hit, 5, 10, 2>,
    /// Just before and just after.
    pub before: State<5>,
    pub after: State<5>,
}

impl Blow {
    /// Until the time `end` after the hit.
    pub fn new(hit: Hit, step: f64, end: f64) -> Result<Self> {
        let ((s, c), far) = (sincos(hit.slant), hit.reach + APPROACH);
        let start = State {
            q: [0.0, 0.5, 0.0, -far * c, -far * s],
            v: [0.0, 0.0, 0.0, c, s],
        };
        // Nothing pulls, so steps would be long, and a ball could pass a mass within one.
        let method = Dop853::new(step)?.with_longest_step(0.2 * hit.reach.min(0.25))?;
        let motion = motion(hit, &method, start, APPROACH + end)?;
        let first = motion.event("lower bounces")?;
        let (before, after) = (first.before, first.after);
        Ok(Self {
            motion,
            before,
            after,
        })
    }

    /// The state at this time after the hit.
    pub fn at(&self, t: f64) -> Result<State<5>> {
        self.motion
            .at((t + APPROACH).clamp(0.0, self.motion.end_time()))
    }

    /// The hits after the first, with their times.
    pub fn later(&self) -> impl Iterator<Item = (f64, &Event<5, 2>)> {
        let hits = self.motion.events().iter().skip(1);
        hits.map(|event| (event.t - APPROACH, event))
    }

    /// What it cost.
    pub fn work(&self) -> Work {
        self.motion.work()
    }
}

/// Kinetic energy of all.
pub fn energy(State { v, .. }: &State<5>) -> f64 {
    let square = |k: usize| v[k] * v[k] + v[k + 1] * v[k + 1];
    0.5 * (square(0) + 0.25 * v[2] * v[2] + square(3))
}

/// How far the ball is from the middle of the lower mass and of the upper one.
pub fn distances(q: &[f64; 5]) -> [f64; 2] {
    places(q).map(|[x, y]| hypot(x - q[3], y - q[4]))
}
