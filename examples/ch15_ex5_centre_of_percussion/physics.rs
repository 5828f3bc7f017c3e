//! Bat and ball: in closed form, and as a scene of contacts that hold and push, with rigid bodies
//! that bounce or with a soft ball.

// ANCHOR: physics
use super::Parameters;
use kit::prelude::*;
use rotation_dynamics::planar::contact::{
    Contact, ContactMotion, Mechanism, MechanismState, motion_within,
};

/// Distances from the middle of the bat to the hands, and from the hands to the blow, m.
pub fn arms(p: &Parameters) -> [f64; 2] {
    [0.5 * p.length - p.hands, p.hit - p.hands]
}

/// Moment of inertia over the mass, about a point at the distance `arm` from the middle, m^2.
pub fn inertia(p: &Parameters, arm: f64) -> f64 {
    p.length * p.length / 12.0 + arm * arm
}

/// Distance of the centre of percussion from the hands, m.
pub fn centre(p: &Parameters) -> f64 {
    let [arm, _] = arms(p);
    inertia(p, arm) / arm
}

/// Impulse of the hands over that of the ball, both on the bat.
pub fn reaction(p: &Parameters) -> f64 {
    arms(p)[1] / centre(p) - 1.0
}

/// Impulse of the ball on the bat: held by the hands, or free.
pub fn impulse(p: &Parameters, held: bool) -> f64 {
    let [arm, hit] = arms(p);
    let yielding = match held {
        true => hit * hit / inertia(p, arm),
        false => 1.0 + (hit - arm) * (hit - arm) / inertia(p, 0.0),
    };
    (1.0 + p.restitution) * p.speed / (1.0 / p.ball + yielding / p.mass)
}

/// Velocity that the impulse J gives to the place of the hands on a free bat, over J/m.
pub fn free_hands(p: &Parameters) -> f64 {
    let [arm, hit] = arms(p);
    1.0 - (hit - arm) * arm / inertia(p, 0.0)
}

/// Bat and ball; the hands are at the origin, the bat lies along x, the ball comes along y.
#[derive(Debug, Clone)]
pub struct Strike {
    pub p: Parameters,
    pub held: bool,             // whether the hands hold it as a hinge does
    pub stiffness: Option<f64>, // force over depth^(3/2), N/m^(3/2); none if ball and bat are rigid
}

impl Strike {
    /// Rigid bodies; the ball comes along y, whatever the sign of `speed`.
    pub fn rigid(p: &Parameters, held: bool) -> Self {
        Self { p: p.but(|p| p.speed = p.speed.abs()), held, stiffness: None }
    }

    /// A soft ball by Hertz's law: `contact` is 2.943 times the greatest depth over the speed.
    pub fn soft(p: &Parameters) -> Self {
        let p = p.but(|p| (p.speed, p.restitution) = (p.speed.abs(), 1.0));
        let (reduced, depth) = (0.5 * impulse(&p, true) / p.speed, p.speed * p.contact / 2.943_275);
        let stiffness = Some(1.25 * reduced * p.speed * p.speed / pow(depth, 2.5));
        Self { p, held: true, stiffness }
    }

    /// How far the ball is from the bat, its gradient, and its second rate at constant velocities.
    fn gap(&self, MechanismState { q, v }: &MechanismState<5>) -> (f64, [f64; 5], f64) {
        let (s, c) = sincos(q[2]);
        let ([x, y], [u, w]) = ([q[3] - q[0], q[4] - q[1]], [v[3] - v[0], v[4] - v[1]]);
        let (along, up, rate) = (c * x + s * y, c * y - s * x, c * u + s * w);
        let bias = 2.0 * v[2] * rate + v[2] * v[2] * up;
        (-up, [-s, c, along, s, -c], bias)
    }

    /// Force between the two, N.
    pub fn push(&self, state: &MechanismState<5>) -> f64 {
        let depth = (-self.gap(state).0).max(0.0);
        self.stiffness.unwrap_or(0.0) * depth * depth.sqrt()
    }
}

// ANCHOR: scene
/// Coordinates: the middle of the bat, its angle, the ball.
impl Mechanism<5, 3> for Strike {
    fn mass(&self, _: &[f64; 5]) -> [[f64; 5]; 5] {
        let (m, ball) = (self.p.mass, self.p.ball);
        let diagonal = [m, m, m * inertia(&self.p, 0.0), ball, ball];
        core::array::from_fn(|j| core::array::from_fn(|k| if j == k { diagonal[j] } else { 0.0 }))
    }

    fn force(&self, state: &MechanismState<5>) -> [f64; 5] {
        let (push, (_, gradient, _)) = (self.push(state), self.gap(state));
        gradient.map(|part| part * push)
    }

    fn contacts(&self, state: &MechanismState<5>) -> [Contact<5>; 3] {
        let (MechanismState { q, v }, [arm, _]) = (state, arms(&self.p));
        let ((s, c), square) = (sincos(q[2]), v[2] * v[2]);
        let ((gap, gradient, bias), none) = (self.gap(state), [0.0; 5]);
        let ball = match self.stiffness {
            None => Contact::new("ball", gap, gradient, bias).restitution(self.p.restitution),
            Some(_) => Contact::joint("ball", 0.0, none, 0.0),
        };
        // The place that the hands hold stays at the origin.
        let hold = |name, gap, gradient, bias| match self.held {
            true => Contact::joint(name, gap, gradient, bias),
            false => Contact::joint(name, 0.0, none, 0.0),
        };
        let along = hold("along", q[0] - arm * c, [1.0, 0.0, arm * s, 0.0, 0.0], arm * c * square);
        let up = hold("hands", q[1] - arm * s, [0.0, 1.0, -arm * c, 0.0, 0.0], arm * s * square);
        [ball, along, up]
    }
    // ANCHOR_END: scene

    fn scale(&self, _: &MechanismState<5>) -> MechanismState<5> {
        let (l, v) = (self.p.length, self.p.speed);
        let (q, v) = ([l, l, 1.0, l, l], [v, v, v / l, v, v]);
        MechanismState { q, v }
    }
}
// ANCHOR_END: physics

/// A blow, simulated from before the impact until the two have parted.
pub struct Blow {
    strike: Strike,
    pub motion: ContactMotion<Strike, 5, 3>,
    pub touch: f64,    // when they touch first
    pub impulse: f64,  // momentum that the ball has lost, N s
    pub hands: f64,    // momentum of the bat that does not come from the ball, N s
    pub reaction: f64, // the second over the first
    pub turn: f64,     // angular velocity of the bat just after
    pub away: f64,     // velocity of the place of the hands just after
}

impl Blow {
    pub fn new(strike: Strike, tolerance: f64) -> Result<Self> {
        let (p, [arm, hit]) = (&strike.p, arms(&strike.p));
        // Rigid bodies have parted at once, and may meet again later.
        let parted = if strike.stiffness.is_none() { 0.1 } else { 1.5 };
        let (touch, end) = (0.5 * p.contact, (0.5 + parted) * p.contact);
        let q = [arm, 0.0, 0.0, hit, -touch * p.speed];
        let v = [0.0, 0.0, 0.0, 0.0, p.speed];
        let motion = motion_within(strike.clone(), tolerance, MechanismState { q, v }, end)?;
        let (before, after) = match strike.stiffness {
            None => motion.event("ball bounces").map(|at| (at.before.v, at.after.v))?,
            Some(_) => (motion.at(touch)?.v, motion.at(end)?.v),
        };
        let impulse = p.ball * (before[4] - after[4]);
        let hands = p.mass * after[1] - impulse;
        let (reaction, turn, away) = (hands / impulse, after[2], after[1] - arm * after[2]);
        Ok(Self { strike, motion, touch, impulse, hands, reaction, turn, away })
    }

    /// Forces of the ball and of the hands on the bat, along y at the start, N.
    pub fn forces(&self, t: f64) -> Result<[f64; 2]> {
        let hands = self.motion.forces(t)?[2].normal;
        Ok([self.strike.push(&self.motion.at(t)?), hands])
    }

    /// Times from the first touch on, with these forces.
    fn pushed(&self) -> Result<Vec<(f64, [f64; 2])>> {
        let all = times(self.touch, self.motion.end_time(), 600);
        sampled(all, |t| Ok((t, self.forces(t)?)))
    }

    /// The largest of each.
    pub fn largest_forces(&self) -> Result<[f64; 2]> {
        let pushed = self.pushed()?;
        let larger = |a: f64, b: f64| if b.abs() > a.abs() { b } else { a };
        Ok([0, 1].map(|k| pushed.iter().map(|(_, forces)| forces[k]).fold(0.0, larger)))
    }

    /// How much of the impulse of a soft ball is left in a vibration of this angular frequency
    /// that it sets going: the length of the integral of force times e^(i omega t), over that
    /// of the force.
    pub fn left_swinging(&self, frequency: f64) -> Result<f64> {
        let pushed = self.pushed()?;
        let sum = |of: fn(f64) -> f64| -> f64 {
            pushed.iter().map(|(t, [ball, _])| ball * of(frequency * t)).sum()
        };
        Ok(hypot(sum(cos), sum(sin)) / sum(|_| 1.0))
    }
}
