//! Where a function of time and state goes through zero along a solved motion.

use super::SolvedMotion;
use super::along::Found;
use crate::body::State;
use crate::error::{Error, FINITE, Result};
use crate::integrators::Work;
use crate::math::EPS;
use crate::math::bracket::{least, zero};

/// From look to look the body turns by about this (rad), by twice as much at most.
const LOOK: f64 = 0.25;
/// There are at least so many stretches between looks.
const LOOKS: f64 = 64.0;
/// Derivatives along the motion are differences over this part of the time between two looks: short
/// enough for their curvature, long enough for their rounding.
const BESIDE: f64 = 1e-2;
/// A function that is this part of its change between two looks at its zero jumps there: of smooth ones
/// rounding leaves a billionth.
const JUMP: f64 = 1e-3;
/// Derivatives by the state are differences over this change of it, the root of a rounding.
const CHANGE: f64 = 1e-8;

/// Where a function went through zero.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Crossing {
    /// When (s): just beyond the zero.
    pub t: f64,
    /// The state then, with the error that was asked of the motion.
    pub state: State,
    /// True if the function went from negative to positive along the motion.
    pub rising: bool,
    /// An upper estimate (s) of how far the true crossing is from `t`: the change of the function that
    /// the estimated errors of attitude and momentum make, over its rate, which its curvature may
    /// lessen. Infinite where these errors could undo the crossing, as at a graze, and where the function
    /// jumps over zero: there take one that is smooth, such as the sine of an angle. The rounding of
    /// the function and of `t` is not in it: it is 0 for a function of the time alone.
    pub t_estimate: f64,
}

/// A function of time and state.
type Function<'f> = dyn Fn(f64, &State) -> f64 + 'f;

impl SolvedMotion<'_> {
    /// Where `function(t, state)` goes through zero, in the order of the motion.
    ///
    /// It is looked at wherever the body has turned by about a quarter of a radian, at 64 places at
    /// least, and where it comes nearest to zero between them. [`Limits::longest_step`](super::Limits)
    /// makes the looks closer, for a function that changes faster. A graze less deep than the error of
    /// the function is left out. A function that is zero at the start has no crossing there. A
    /// jump over zero counts as a crossing.
    ///
    /// Each state is stepped to its own time, so it is as good as the motion. It lies on the far
    /// side of zero, and a motion that goes on from it does not meet the crossing again (one that
    /// goes back does, at once). Under a [sampled](crate::effects::SampledControl) control a motion
    /// that goes on from there is another one, as it calls the law anew at its start. The search
    /// takes some ten times the torques of the run, within its [`budget`](super::Limits::budget):
    /// 10 times in the median of `tests/accuracy/error_control/crossings.rs`, 30 at most.
    ///
    /// ```
    /// # use rotation_dynamics::{accuracy::Limits, attitude::Attitude, body::RigidBody};
    /// # use rotation_dynamics::{effects::GravityAtLever, frame::BodyVector};
    /// # use rotation_dynamics::{inertia::PrincipalMoments, scene::Scene};
    /// # fn main() -> rotation_dynamics::Result<()> {
    /// // When does the axis of a top pass through the plane X = 0?
    /// let body = RigidBody::new(PrincipalMoments::new(1.0, 1.5, 0.8)?);
    /// let scene = Scene::new(body).with(GravityAtLever::new(1.0, 0.4)?);
    /// let start = body.state(Attitude::IDENTITY, BodyVector::new(0.3, 0.1, 2.0))?;
    /// let motion = scene.solve_along(&start, 20.0, 1e-9, &Limits::default())?;
    /// let passes = motion.crossings("plane X = 0", |_, state| state.attitude.axis().x())?;
    /// let first = &passes[0];
    /// assert!(first.state.attitude.axis().x().abs() < 1e-15 && first.t_estimate < 1e-8);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// [`Error::FunctionOutOfRange`] where the function is no finite number; `name` says which it is.
    /// Those of [`Motion::try_state`](crate::motion::Motion::try_state).
    pub fn crossings(
        &self,
        name: &str,
        function: impl Fn(f64, &State) -> f64,
    ) -> Result<Vec<Crossing>> {
        let search = Search { motion: self, name, function: &function, work: Work::default() };
        search.crossings()
    }
}

/// A motion, gone along from look to look, and a function of it.
struct Search<'m, 's> {
    motion: &'m SolvedMotion<'s>,
    name: &'m str,
    function: &'m Function<'m>,
    /// The work of all states until now.
    work: Work,
}

/// A place where the function was looked at.
struct Look {
    t: f64,
    value: f64,
    /// 1 above zero and -1 below; zero itself is beyond.
    side: f64,
    /// The state from which the run goes on here.
    here: Found,
    rate: f64,
}

impl Search<'_, '_> {
    /// The state at `t` and the function of it, gone on from `here`, which moves on if it is to.
    fn go(&mut self, here: &Found, t: f64) -> Result<(Found, State, f64)> {
        let mut there = here.clone();
        there.work = self.work;
        let state = self.motion.state(t, &mut there)?;
        self.work = there.work;
        let value = self.value(t, &state)?;
        Ok((there, state, value))
    }

    fn value(&self, t: f64, state: &State) -> Result<f64> {
        let value = (self.function)(t, state);
        if value.is_finite() {
            return Ok(value);
        }
        let [w, x, y, z] = state.attitude.quaternion();
        let [lx, ly, lz] = state.angular_momentum.to_array();
        Err(Error::of_function(
            format!("function of the crossing \"{}\"", self.name),
            t,
            ("attitude and angular momentum", vec![w, x, y, z, lx, ly, lz]),
            &[value],
            FINITE,
        ))
    }

    fn look(&mut self, before: Option<&Look>, t: f64, here: &Found) -> Result<Look> {
        let (here, state, value) = self.go(here, t)?;
        let side = match before {
            _ if value != 0.0 => 1_f64.copysign(value),
            Some(before) => -before.side,
            None => 0.0,
        };
        let rate = self.motion.body().angular_velocity(&state).norm();
        Ok(Look { t, value, side, here, rate })
    }

    /// The look after this one, unless that is the last.
    fn next(&mut self, last: &Look) -> Result<Option<Look>> {
        let [from, to] = self.motion.span();
        if last.t == to {
            return Ok(None);
        }
        let longest = ((to - from).abs() / LOOKS).min(self.motion.longest_step());
        let mut apart = longest.min(LOOK / last.rate);
        if last.side == 0.0 {
            // Which way it leaves a zero at the start is seen at once.
            apart *= BESIDE;
        }
        loop {
            apart = apart.max(8.0 * EPS * last.t.abs());
            let is_last = (to - last.t).abs() <= apart;
            let t = if is_last { to } else { last.t + apart.copysign(to - from) };
            let next = self.look(Some(last), t, &last.here)?;
            // It has begun to turn faster.
            if next.rate * apart <= 2.0 * LOOK || apart <= 16.0 * EPS * last.t.abs() {
                return Ok(Some(next));
            }
            apart *= 0.5;
        }
    }

    fn crossings(mut self) -> Result<Vec<Crossing>> {
        let mut crossings = Vec::new();
        let [from, _] = self.motion.span();
        let mut looks = vec![self.look(None, from, &self.motion.found(1))?];
        while let Some(last) = looks.last() {
            let next = self.next(last)?;
            let is_over = next.is_none();
            looks.extend(next);
            // Between two looks, when the one after them is known too.
            let behind = if is_over { 1 } else { 2 };
            if let Some(b) = looks.len().checked_sub(behind).filter(|b| *b > 0) {
                crossings.extend(self.between(&looks, b)?);
            }
            if is_over {
                break;
            }
            looks.drain(..looks.len().saturating_sub(3));
        }
        Ok(crossings)
    }

    /// The crossings between a look and the one before it.
    fn between(&mut self, looks: &[Look], b: usize) -> Result<Vec<Crossing>> {
        let before = b.checked_sub(2).map(|before| &looks[before]);
        let (a, b, after) = (&looks[b - 1], &looks[b], looks.get(b + 1));
        let (begin, end) = ((a.t, a.value), (b.t, b.value));
        if a.side * b.side < 0.0 {
            let crossing = self.crossing(a, begin, end, [a.t, b.t])?;
            return Ok(vec![crossing]);
        }
        // A convex function stays above the secants on either side, drawn on.
        let above = |here: &Look, there: &Look, beside: Option<&Look>| {
            beside.is_some_and(|beside| {
                let slope = (here.value - beside.value) / (here.t - beside.t);
                here.side * (here.value + slope * (there.t - here.t)) > 0.0
            })
        };
        if a.side * b.side == 0.0 || above(a, b, before) || above(b, a, after) {
            return Ok(Vec::new());
        }
        let (t, value) = least(|t| Ok(self.go(&a.here, t)?.2), a.side, [a.t, b.t])?;
        let (_, state, _) = self.go(&a.here, t)?;
        if a.side * value >= -self.uncertainty(t, &state)? {
            return Ok(Vec::new());
        }
        let there = self.crossing(a, begin, (t, value), [a.t, b.t])?;
        let back = self.crossing(a, (t, value), end, [a.t, b.t])?;
        Ok(vec![there, back])
    }

    /// The crossing between two times where the signs differ, within these ends of looks.
    fn crossing(
        &mut self,
        from: &Look,
        (t_a, a): (f64, f64),
        (t_b, b): (f64, f64),
        [begin, end]: [f64; 2],
    ) -> Result<Crossing> {
        let rising = b > 0.0 || a < 0.0;
        let t = if a == 0.0 {
            t_a
        } else {
            zero(|t| Ok(self.go(&from.here, t)?.2), (t_a, a), (t_b, b))?
        };
        let (_, state, value) = self.go(&from.here, t)?;
        let by = BESIDE * (end - begin);
        let (least, most) = ((begin + by).min(end - by), (begin + by).max(end - by));
        let middle = t.clamp(least, most);
        // Rounding may lead beyond an end, where there is no motion.
        let mut at = |t: f64| Ok(self.go(&from.here, t.clamp(begin.min(end), begin.max(end)))?.2);
        let (before, here, after) = (at(middle - by)?, at(middle)?, at(middle + by)?);
        let slope = ((after - before) / (2.0 * by)).abs();
        let curvature = ((after - here) - (here - before)).abs() / (by * by);
        let uncertainty = self.uncertainty(t, &state)?;
        // The function changes by so much in this time, with the curvature against it.
        let left = slope * slope - 2.0 * curvature * uncertainty;
        let jumps = value.abs() > JUMP * (after - before).abs();
        let t_estimate = if left > 0.0 && !jumps {
            2.0 * uncertainty / (slope + left.sqrt())
        } else {
            f64::INFINITY
        };
        Ok(Crossing { t, state, rising, t_estimate })
    }

    /// How far the function of a state may be off, by what the state may be.
    fn uncertainty(&self, t: f64, state: &State) -> Result<f64> {
        let here = self.value(t, state)?;
        let mut sum = 0.0;
        for (input, error) in self.motion.errors().into_iter().enumerate() {
            let there = self.value(t, &self.motion.moved(state, input, CHANGE)?)?;
            let change = (there - here) / CHANGE * error;
            sum += change * change;
        }
        Ok(sum.sqrt())
    }
}
