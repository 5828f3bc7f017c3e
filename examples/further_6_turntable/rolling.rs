//! A ball on a moving surface, in three dimensions: it rolls, or slips with dry friction.
//!
//! Newton's law for the middle and Euler's for the turning, with what the contact does: no
//! reduced equation of motion is put in.

use rotation_dynamics::Result;
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::frame::SpaceVector;
use rotation_dynamics::integrators::{Dop853, LocatedEvent, Ode, Work, after, ode, size_or};
use rotation_dynamics::math::hypot;
use rotation_dynamics::planar::{Condition, Next, Phased, Run, simulate};

/// What the ball is on. It turns about the vertical through the origin.
#[derive(Debug, Clone, Copy)]
pub enum Surface {
    /// A table; it ends so far from its axis.
    Table { edge: f64 },
    /// The inside of a cylinder, the middle of the ball so far from its axis.
    Wall { distance: f64 },
}

/// The ball, per unit mass, and what it is on.
#[derive(Debug, Clone, Copy)]
pub struct Ball {
    pub surface: Surface,
    /// Angular velocity of the surface.
    pub rate: f64,
    pub radius: f64,
    /// k = I/(m a^2).
    pub shape: f64,
    pub mu: f64,
    pub gravity: SpaceVector,
    /// Moment of rolling resistance over m a^2 and the angular velocity, 1/s.
    pub loss: f64,
}

/// Place and velocity of the middle, angular velocity in space, attitude.
#[derive(Debug, Clone, Copy)]
pub struct Moving {
    pub place: SpaceVector,
    pub velocity: SpaceVector,
    pub spin: SpaceVector,
    pub quaternion: [f64; 4],
}

/// What the ball does where it touches.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Touch {
    Rolls,
    Slips,
}

/// The state as numbers.
pub type Y = [f64; 13];
/// An event, and the work until then.
pub type Found = Result<(LocatedEvent<13>, Work)>;

impl Moving {
    pub fn of(y: &Y) -> Self {
        let [place, velocity, spin] = [0, 3, 6].map(|i| SpaceVector::new(y[i], y[i + 1], y[i + 2]));
        Self { place, velocity, spin, quaternion: [y[9], y[10], y[11], y[12]] }
    }

    pub fn numbers(&self) -> Y {
        let vectors = [self.place, self.velocity, self.spin].map(SpaceVector::to_array);
        core::array::from_fn(|i| match i {
            0..9 => vectors[i / 3][i % 3],
            _ => self.quaternion[i - 9],
        })
    }

    /// The attitude, from the body's axes to those of space.
    pub fn attitude(&self) -> Result<Attitude> {
        Attitude::from_quaternion(self.quaternion)
    }
}

/// A slip slower than this is none, m/s.
pub const STILL: f64 = 1e-10;

impl Ball {
    fn axis(&self) -> SpaceVector {
        SpaceVector::new(0.0, 0.0, self.rate)
    }

    /// From the surface to the middle, a unit vector, and its derivative.
    fn normal(&self, at: &Moving) -> [SpaceVector; 2] {
        match self.surface {
            Surface::Table { .. } => [SpaceVector::new(0.0, 0.0, 1.0), SpaceVector::zero()],
            Surface::Wall { distance } => {
                let level = |v: SpaceVector| SpaceVector::new(v.x(), v.y(), 0.0);
                let out = level(at.place) / level(at.place).norm();
                let around = level(at.velocity) - out * out.dot(&at.velocity);
                [out * -1.0, around / -distance]
            }
        }
    }

    // ANCHOR: contact
    /// The velocity of the ball at the contact, seen from the surface.
    pub fn slip(&self, at: &Moving) -> SpaceVector {
        let [n, _] = self.normal(at);
        let surface = self.axis().cross(&(at.place - n * self.radius));
        at.velocity - at.spin.cross(&n) * self.radius - surface
    }

    /// Normal force, and the friction with which the slip stays what it is: its derivative,
    /// with the accelerations that the forces give, is zero.
    pub fn forces(&self, at: &Moving) -> (f64, SpaceVector) {
        let ([n, turning], a, k) = (self.normal(at), self.radius, self.shape);
        let surface = self.axis().cross(&(at.velocity - turning * a));
        let carried = at.spin.cross(&turning) * a + surface;
        let braked = self.resistance(at).cross(&n) / (k * a);
        let without = self.gravity - carried - braked;
        let along = without - n * n.dot(&without);
        let push = -n.dot(&self.gravity) - turning.dot(&at.velocity);
        (push, along * (-k / (1.0 + k)))
    }

    /// The moment of rolling resistance, against the rolling over the surface.
    fn resistance(&self, at: &Moving) -> SpaceVector {
        let ([n, _], seen) = (self.normal(at), at.spin - self.axis());
        (seen - n * n.dot(&seen)) * (-self.loss * self.radius * self.radius)
    }

    /// Accelerations by Newton and Euler, and how the attitude turns.
    fn rates(&self, touch: Touch, at: &Moving) -> Moving {
        let ([n, _], (push, held), slip) = (self.normal(at), self.forces(at), self.slip(at));
        let friction = match touch {
            Touch::Rolls => held,
            Touch::Slips => slip * (-self.mu * push / slip.norm()),
        };
        let moment = n.cross(&friction) * -self.radius + self.resistance(at);
        let ([q0, q1, q2, q3], [x, y, z]) = (at.quaternion, (at.spin * 0.5).to_array());
        Moving {
            place: at.velocity,
            velocity: self.gravity + n * push + friction,
            spin: moment / (self.shape * self.radius * self.radius),
            quaternion: [
                -x * q1 - y * q2 - z * q3,
                x * q0 + y * q3 - z * q2,
                y * q0 + z * q1 - x * q3,
                z * q0 + x * q2 - y * q1,
            ],
        }
    }
    // ANCHOR_END: contact

    /// With this place and velocity, rolling, with the component `normal` of the angular velocity
    /// along the normal.
    pub fn rolling(&self, place: SpaceVector, velocity: SpaceVector, normal: f64) -> Moving {
        let (spin, quaternion) = (SpaceVector::zero(), [1.0, 0.0, 0.0, 0.0]);
        let still = Moving { place, velocity, spin, quaternion };
        let [n, _] = self.normal(&still);
        Moving { spin: self.slipping(&still, spin).spin + n * normal, ..still }
    }

    /// With another slip.
    fn slipping(&self, at: &Moving, slip: SpaceVector) -> Moving {
        let [n, _] = self.normal(at);
        Moving { spin: at.spin + n.cross(&(self.slip(at) - slip)) / self.radius, ..*at }
    }

    /// On a table without a rim.
    pub fn without_edge(self) -> Self {
        Self { surface: Surface::Table { edge: 1e9 }, ..self }
    }

    /// What is left of the friction before it slips.
    pub fn grip(&self, y: &Y) -> f64 {
        let (push, held) = self.forces(&Moving::of(y));
        self.mu * push - held.norm()
    }

    /// Which way it goes on from a state without slip; if it slips, a little to begin with.
    fn decide(&self, y: &Y) -> (Touch, Y) {
        if self.grip(y) <= 0.0 {
            return self.let_go(y);
        }
        (Touch::Rolls, self.slipping(&Moving::of(y), SpaceVector::zero()).numbers())
    }

    fn let_go(&self, y: &Y) -> (Touch, Y) {
        let at = Moving::of(y);
        let (_, held) = self.forces(&at);
        let slip = held * (-10.0 * STILL / held.norm());
        (Touch::Slips, self.slipping(&at, slip).numbers())
    }

    /// The motion that rolls in any case.
    pub fn rolls(self) -> impl Ode<13> {
        ode(move |_, y: &Y| self.rates(Touch::Rolls, &Moving::of(y)).numbers()).scaled(|y: &Y| {
            // Of a vector far beyond the sizes of a laboratory no component is better known.
            let at = Moving::of(y);
            let far = |v: SpaceVector, usual| if v.norm() > usual { v.norm() } else { 0.0 };
            let [place, velocity] = [far(at.place, 1.0), far(at.velocity, 10.0)];
            let sizes = [place, velocity, far(at.spin, 200.0), 0.0];
            core::array::from_fn(|i| y[i].abs().max(1.0).max(sizes[(i / 3).min(3)]))
        })
    }

    /// What it does after the time `t` if it rolls in any case.
    pub fn later(self, start: &Moving, t: f64, step: f64) -> Result<Moving> {
        Ok(Moving::of(&after(t, &self.rolls(), &start.numbers(), step)?))
    }

    /// Where this is zero for the n-th time before the end, if it rolls in any case.
    pub fn zero(
        self,
        start: &Moving,
        n: u32,
        end: f64,
        step: f64,
        of: impl Fn(&Y) -> f64,
    ) -> Found {
        Dop853::new(step)?.zero(&self.rolls(), start.numbers(), n, end, of)
    }

    /// The motion with an error of a step of this size, until a time or an end.
    pub fn run(&self, start: &Moving, end: f64, step: f64) -> Result<Run<Touch, 13>> {
        let (slips, y) = (self.slip(start).norm() > STILL, start.numbers());
        let (touch, y) = if slips { (Touch::Slips, y) } else { self.decide(&y) };
        simulate(self, &Dop853::new(step)?, touch, y, end)
    }
}

/// What it does at the time `t` of a run.
pub fn at(run: &Run<Touch, 13>, t: f64) -> kit::Result<Moving> {
    Ok(Moving::of(&run.at(t)?.1))
}

impl Phased<13> for Ball {
    type Phase = Touch;

    fn derivative(&self, touch: Touch, y: &Y) -> Y {
        self.rates(touch, &Moving::of(y)).numbers()
    }

    fn conditions(&self, touch: Touch) -> Vec<Condition<'_, Touch, 13>> {
        let mut all = Vec::new();
        if let Surface::Table { edge } = self.surface {
            let inside = move |y: &Y| edge - hypot(y[0], y[1]);
            all.push(Condition::gap("leaves", inside, Next::End));
        }
        all.push(match touch {
            Touch::Rolls => {
                let next = Next::decide(|_, y: &Y| Ok(self.let_go(y)));
                Condition::gap("slips", |y| self.grip(y), next)
            }
            Touch::Slips => {
                let slip = |y: &Y| self.slip(&Moving::of(y)).norm() - STILL;
                let next = Next::decide(|_, y: &Y| Ok(self.decide(y)));
                Condition::gap("rolls", slip, next)
            }
        });
        all
    }

    fn scale(&self, y: &Y) -> Y {
        size_or([1.0; 13])(y)
    }
}
