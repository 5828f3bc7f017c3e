//! Five motions with known answers, from easy to hard.

use rotation_dynamics::accuracy::Errors;
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::GravityAtLever;
use rotation_dynamics::exact::free_body::FreeBody;
use rotation_dynamics::exact::heavy_top::{HeavyTop, ReducedTop, Start};
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::Ode;
use rotation_dynamics::math::sincos;
use rotation_dynamics::scene::{Invariant, Scene};
use rotation_dynamics::{Error, Result};

/// A body on which nothing acts, and a heavy symmetric body: the effects of a scene are
/// part of its type.
pub type Free = Scene<()>;
pub type Gravity = ((), GravityAtLever);
pub type Top = Scene<Gravity>;

/// What moves.
pub enum Kind {
    Free {
        scene: Free,
        exact: Box<FreeBody>,
    },
    /// In units of t': I1 = 1, I3 = a, m g l = c, L_z = sqrt(a).
    Top {
        scene: Top,
        exact: Box<HeavyTop>,
        reduced: ReducedTop,
    },
}

/// A motion from a start to an end, with its exact answer.
pub struct Problem {
    /// For tables and keys.
    pub key: &'static str,
    pub name: &'static str,
    pub kind: Kind,
    pub start: State,
    /// The end, in time and in periods.
    pub end: f64,
    pub periods: f64,
    /// The exact state at the end.
    pub answer: State,
}

/// 1e-4 rad off the axis of the intermediate moment.
const NEAR_MIDDLE: BodyVector = BodyVector::new(0.0, 1.0, 1e-4);

/// The free body, L = (0.8, 0.8, 0.9) on the body axes, and a third of a period more.
pub fn generic(moments: PrincipalMoments, periods: f64) -> Result<Problem> {
    let [i1, i2, i3] = moments.to_array();
    let rates = BodyVector::new(0.8 / i1, 0.8 / i2, 0.9 / i3);
    Problem::free("free", "free body", moments, rates, periods + THIRD)
}

// ANCHOR: problems
/// The five, over so many periods (of the rates, or of the nods).
pub fn all(moments: PrincipalMoments, periods: f64) -> Result<Vec<Problem>> {
    // Figure 3 of the notes: a = 2, b = 1.2, c = 0.2, E~ = 0.55.
    let notes = (ReducedTop::new(2.0, 1.2, 0.2)?, 0.55, Start::ThetaMin);
    // A fast top released at rest: cusps, ten thousand nods in one round.
    let fast = ReducedTop::new(2.0, 0.6, 1e-4)?;
    let cusps = fast.cusp_energy().unwrap_or(0.0);
    // A top thrown so that its axis passes the vertical at 1e-4 rad.
    let (sin, cos) = sincos(1e-4);
    let energy: f64 = 0.55;
    let passing = ReducedTop::new(2.0, cos + sin * energy.sqrt(), 0.2)?;
    Ok(vec![
        generic(moments, periods)?,
        Problem::top("top", "heavy top", notes, periods)?,
        Problem::top(
            "fast",
            "fast top",
            (fast, cusps, Start::ThetaMin),
            10.0 * periods,
        )?,
        // From 1e-4 off the intermediate axis: two flips a period. It ends in the middle of a
        // flip, where the attitude is most sensitive.
        Problem::free("flips", "flips", moments, NEAR_MIDDLE, 0.5 * periods - 0.25)?,
        Problem::top(
            "pole",
            "past the pole",
            (passing, energy, Start::ThetaMax),
            periods,
        )?,
    ])
}
// ANCHOR_END: problems

/// What is added to a whole number of periods: at the whole number, where the motion is
/// symmetric in time, a symmetric method's error of the energy vanishes by luck.
const THIRD: f64 = 1.0 / 3.0;

/// How many points of the path are disturbed.
const NODES: u32 = 96;

impl Problem {
    pub fn free(
        key: &'static str,
        name: &'static str,
        moments: PrincipalMoments,
        rates: BodyVector,
        periods: f64,
    ) -> Result<Self> {
        let tilted = Attitude::from_euler(EulerAngles {
            phi: 0.3,
            theta: 0.7,
            zeta: -0.4,
        })?;
        let exact = FreeBody::new(moments, rates, tilted)?;
        let period = exact.rate_period();
        if !period.is_finite() {
            return Err(Error::OutOfRange {
                name: "I2",
                value: moments.i2(),
                allowed: "between I1 and I3, and equal to neither: the body must tumble",
            });
        }
        let scene = Scene::new(RigidBody::new(moments));
        let start = scene.body().state(tilted, rates)?;
        let kind = Kind::Free {
            scene,
            exact: Box::new(exact),
        };
        Self::new(key, name, kind, start, [periods * period, periods])
    }

    fn top(
        key: &'static str,
        name: &'static str,
        (top, energy, at): (ReducedTop, f64, Start),
        periods: f64,
    ) -> Result<Self> {
        let exact = HeavyTop::from_energy(top, energy, at, 0.0, 0.0)?;
        let body = RigidBody::new(PrincipalMoments::symmetric(1.0, top.a())?);
        let scene = Scene::new(body).with(GravityAtLever::new(top.c(), 1.0)?);
        let (attitude, rates) = exact.state(0.0);
        let start = body.state(attitude, rates)?;
        let periods = periods + THIRD;
        let end = periods * exact.nutation_period();
        let kind = Kind::Top {
            scene,
            exact: Box::new(exact),
            reduced: top,
        };
        Self::new(key, name, kind, start, [end, periods])
    }

    fn new(
        key: &'static str,
        name: &'static str,
        kind: Kind,
        start: State,
        [end, periods]: [f64; 2],
    ) -> Result<Self> {
        let mut problem = Self {
            key,
            name,
            kind,
            start,
            end,
            periods,
            answer: start,
        };
        problem.answer = problem.exact(end)?;
        Ok(problem)
    }

    /// The exact state at any time.
    pub fn exact(&self, t: f64) -> Result<State> {
        match &self.kind {
            Kind::Free { exact, .. } => {
                State::new(exact.attitude_at(t), self.start.angular_momentum)
            }
            Kind::Top { exact, .. } => State::new(exact.attitude(t), exact.angular_momentum(t)),
        }
    }

    /// The errors of a state reached at the end.
    pub fn errors(&self, reached: &State) -> Errors {
        match &self.kind {
            Kind::Free { scene, .. } => Errors::between(scene, reached, &self.answer),
            Kind::Top { scene, .. } => Errors::between(scene, reached, &self.answer),
        }
    }

    /// The attitude after the time `dt` of a motion that starts in `state`.
    fn continued(&self, state: &State, dt: f64) -> Result<Attitude> {
        match &self.kind {
            Kind::Free { scene, .. } => {
                let rates = scene.body().angular_velocity(state);
                let motion = FreeBody::new(scene.body().moments(), rates, state.attitude)?;
                Ok(motion.attitude_at(dt))
            }
            Kind::Top { scene, reduced, .. } => {
                // The notes' numbers of this state, and its own unit of time.
                let angles = state.attitude.euler_angles();
                let rates = angles.rates(scene.body().angular_velocity(state))?;
                let axial = scene.value(Invariant::AxialMomentum, state);
                let vertical = scene.value(Invariant::MomentumZ, state);
                let unit = reduced.a().sqrt() / axial;
                let c = reduced.c() * (unit * unit);
                let top = ReducedTop::new(reduced.a(), vertical / axial, c)?;
                let EulerAngles { phi, theta, zeta } = angles;
                let motion = HeavyTop::from_angles(top, theta, rates.theta * unit, phi, zeta)?;
                Ok(motion.attitude(dt / unit))
            }
        }
    }

    /// By how much a disturbance of the state at time `t`, of relative size `size`, is
    /// magnified until the end: the sum over six directions, three in L and three in
    /// the attitude.
    pub fn condition(&self, t: f64, size: f64) -> Result<f64> {
        let state = self.exact(t)?;
        let length = state.angular_momentum.norm();
        let unit = |i: usize, by: f64| {
            SpaceVector::from_array(core::array::from_fn(|j| if i == j { by } else { 0.0 }))
        };
        let mut sum = 0.0;
        for i in 0..3 {
            let pushed = |by: f64| -> Result<Attitude> {
                let momentum = state.angular_momentum + unit(i, by * length);
                self.continued(&State::new(state.attitude, momentum)?, self.end - t)
            };
            let turned = |by: f64| -> Result<Attitude> {
                let turn = Attitude::from_rotation_vector(unit(i, by))?;
                let state = State::new(turn * state.attitude, state.angular_momentum)?;
                self.continued(&state, self.end - t)
            };
            // Two-sided: the second order drops out.
            sum += pushed(size)?.angle_to(&pushed(-size)?) / (2.0 * size);
            sum += turned(size)?.angle_to(&turned(-size)?) / (2.0 * size);
        }
        Ok(sum)
    }

    /// The largest condition from a point of the path, the start included: what
    /// round-off on the way is magnified by. And the time of that point.
    pub fn path_condition(&self, size: f64) -> Result<(f64, f64)> {
        let mut largest = (0.0, self.condition(0.0, size)?);
        for k in 1..NODES {
            let t = self.end * f64::from(k) / f64::from(NODES);
            let condition = self.condition(t, size)?;
            if condition > largest.1 {
                largest = (t, condition);
            }
        }
        Ok(largest)
    }

    /// What the start is in the angles of the notes, if it is a top.
    pub fn in_angles(&self) -> Option<(Angles, [f64; 4])> {
        match &self.kind {
            Kind::Free { .. } => None,
            Kind::Top { exact, reduced, .. } => {
                let EulerAngles { phi, theta, zeta } = exact.angles(0.0);
                Some((Angles(*reduced), [theta, exact.theta_rate(0.0), phi, zeta]))
            }
        }
    }
}

/// Equations (4) to (6) of the notes, 16.2: theta, its rate, phi and zeta. The state has
/// no pole, the angles do.
pub struct Angles(ReducedTop);

impl Ode<4> for Angles {
    fn derivative(&self, _t: f64, &[theta, rate, _, _]: &[f64; 4]) -> [f64; 4] {
        let (a, b, c) = (self.0.a(), self.0.b(), self.0.c());
        let (s, u) = sincos(theta);
        let precession = a.sqrt() * (b - u) / (s * s);
        let torque = c * s - a * (b - u) * (1.0 - b * u) / (s * s * s);
        [rate, torque, precession, 1.0 / a.sqrt() - precession * u]
    }
}

impl Angles {
    /// The state that these angles stand for.
    pub fn state(&self, scene: &Top, &[theta, rate, phi, zeta]: &[f64; 4]) -> Result<State> {
        let angles = EulerAngles { phi, theta, zeta };
        let (a, b) = (self.0.a(), self.0.b());
        let (s, u) = sincos(theta);
        let across = a.sqrt() * (b - u) / s;
        let (sin, cos) = sincos(zeta);
        let rates = BodyVector::new(
            rate * cos + across * sin,
            across * cos - rate * sin,
            1.0 / a.sqrt(),
        );
        scene.body().state(Attitude::from_euler(angles)?, rates)
    }
}
