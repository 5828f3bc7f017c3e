//! A ball hits a bat, simulated with forces and impulses of contacts: rigid bodies that bounce, or
//! a soft ball that pushes as a ball does that is pressed flat, for as long as they touch.

use super::{Parameters, arms, impulse};
use kit::prelude::*;
use rotation_dynamics::planar::contact::{
    Contact, ContactMotion, Mechanism, MechanismState, motion_within,
};

/// Bat and ball; the hands are at the origin, the bat lies along x, the ball comes along y.
#[derive(Debug, Clone)]
pub struct Strike {
    pub p: Parameters,
    /// Whether the hands hold it as a hinge does.
    held: bool,
    /// The force over depth^(3/2), N/m^(3/2); none if ball and bat are rigid.
    stiffness: Option<f64>,
}

impl Strike {
    /// Rigid bodies; the ball comes along y, whatever the sign of its velocity.
    pub fn rigid(p: &Parameters, held: bool) -> Self {
        let (p, stiffness) = (p.but(|p| p.speed = p.speed.abs()), None);
        Self { p, held, stiffness }
    }

    /// A soft, elastic ball that touches the bat for about the time `contact` (Hertz's law).
    pub fn soft(p: &Parameters) -> Self {
        let p = p.but(|p| (p.speed, p.restitution) = (p.speed.abs(), 1.0));
        let reduced = 0.5 * impulse(&p, true) / p.speed;
        let depth = p.speed * p.contact / 2.943_275;
        let stiffness = Some(1.25 * reduced * p.speed * p.speed / pow(depth, 2.5));
        let held = true;
        Self { p, held, stiffness }
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
    fn force(&self, state: &MechanismState<5>) -> f64 {
        let depth = (-self.gap(state).0).max(0.0);
        self.stiffness.unwrap_or(0.0) * depth * depth.sqrt()
    }
}

// ANCHOR: scene
/// Coordinates: the middle of the bat, its angle, the ball.
impl Mechanism<5, 3> for Strike {
    fn mass(&self, _: &[f64; 5]) -> [[f64; 5]; 5] {
        let (m, ball) = (self.p.mass, self.p.ball);
        let diagonal = [m, m, m * super::inertia(&self.p, 0.0), ball, ball];
        core::array::from_fn(|j| core::array::from_fn(|k| if j == k { diagonal[j] } else { 0.0 }))
    }

    fn force(&self, state: &MechanismState<5>) -> [f64; 5] {
        let (push, (_, gradient, _)) = (self.force(state), self.gap(state));
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
        let x = [1.0, 0.0, arm * s, 0.0, 0.0];
        let y = [0.0, 1.0, -arm * c, 0.0, 0.0];
        let along = hold("along", q[0] - arm * c, x, arm * c * square);
        let across = hold("hands", q[1] - arm * s, y, arm * s * square);
        [ball, along, across]
    }
    // ANCHOR_END: scene

    fn scale(&self, _: &MechanismState<5>) -> MechanismState<5> {
        let (l, v) = (self.p.length, self.p.speed);
        let (q, v) = ([l, l, 1.0, l, l], [v, v, v / l, v, v]);
        MechanismState { q, v }
    }
}

/// What happens, from before the impact until the two have parted.
pub struct Blow {
    strike: Strike,
    pub before: MechanismState<5>,
    pub after: MechanismState<5>,
    /// When they touch first.
    pub touch: f64,
    pub motion: ContactMotion<Strike, 5, 3>,
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
            None => motion
                .event("ball bounces")
                .map(|at| (at.before, at.after))?,
            Some(_) => (motion.at(touch)?, motion.at(end)?),
        };
        Ok(Self {
            strike,
            before,
            after,
            touch,
            motion,
        })
    }

    /// Momentum that the ball has lost, N s.
    pub fn impulse(&self) -> f64 {
        self.strike.p.ball * (self.before.v[4] - self.after.v[4])
    }

    /// Momentum of the bat that does not come from the ball, N s.
    pub fn hands(&self) -> f64 {
        self.strike.p.mass * self.after.v[1] - self.impulse()
    }

    pub fn reaction(&self) -> f64 {
        self.hands() / self.impulse()
    }

    /// Velocity of the place of the hands just after.
    pub fn end_velocity(&self) -> f64 {
        self.after.v[1] - arms(&self.strike.p)[0] * self.after.v[2]
    }

    /// By which angle the bat turns while a soft ball touches it, rad.
    pub fn turned(&self) -> Result<f64> {
        Ok(self.motion.at(self.touch + self.strike.p.contact)?.q[2])
    }

    /// How much of the impulse of a soft ball is left in a vibration of this angular frequency
    /// that it sets going: the length of the integral of force times e^(i omega t), over that
    /// of the force.
    pub fn left_swinging(&self, frequency: f64) -> Result<f64> {
        let all = times(self.touch, self.motion.end_time(), 600);
        let pushed = sampled(all, |t| {
            let (s, c) = sincos(frequency * t);
            let force = self.strike.force(&self.motion.at(t)?);
            Ok([force, force * c, force * s])
        })?;
        let [sum, c, s] = [0, 1, 2].map(|k| pushed.iter().map(|now| now[k]).sum::<f64>());
        Ok(hypot(c, s) / sum)
    }

    /// Forces of the ball and of the hands on the bat, along y at the start, N.
    pub fn forces(&self, t: f64) -> Result<[f64; 2]> {
        let hands = self.motion.forces(t)?[2].normal;
        Ok([self.strike.force(&self.motion.at(t)?), hands])
    }

    /// The largest of each.
    pub fn largest_forces(&self) -> Result<[f64; 2]> {
        let all = times(self.touch, self.motion.end_time(), 600);
        let all = sampled(all, |t| self.forces(t))?;
        let larger = |a: f64, b: f64| if b.abs() > a.abs() { b } else { a };
        Ok([0, 1].map(|k| all.iter().map(|now| now[k]).fold(0.0, larger)))
    }
}
