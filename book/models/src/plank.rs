//! A plank that falls over on a smooth floor, at any time, without stepping.
//!
//! A uniform plank is released upright, or nearly so, on a frictionless floor and tips over: its
//! centre of mass falls straight down, its foot slides away. Handled from a push of 1e-280 to a
//! release a hair off the floor.
//!
//! Not for: friction at the foot, the impact on the floor.
//!
//! # The solution
//!
//! With `y = sin^2(theta/2)`, `s = sin(theta)` and `lambda^2 = 6g/l`, energy gives
//!
//! ```text
//! theta'^2 (1 + 3 s^2) = 4 lambda^2 (y - e),    e = y0 - theta0'^2 (1 + 3 s0^2)/(4 lambda^2).
//! ```
//!
//! Time is a hyperelliptic integral, so it is a quadrature; but in the right variable
//! the integrand is close to 1 and as smooth as can be. Let `X = C tan(theta/2)`,
//! `C^2 = 1 - e`, `V^2 = X^2 - e`: then
//!
//! ```text
//! X = X0 cosh w + V0 sinh w,     V = V0 cosh w + X0 sinh w,
//! lambda t = integral from 0 to w of sqrt((1 + 3 s^2)/(1 + V^2)) dw,
//! s = 2 X C/(1 + V^2),   y = X^2/(1 + V^2),
//! V0 = theta0' sqrt(1 + 3 s0^2)/(2 lambda cos(theta0/2)),
//! (X0, C) = sqrt(1 + V0^2) (sin(theta0/2), cos(theta0/2)).
//! ```
//!
//! Nothing cancels, whatever the sign of `e`, and `w = lambda t` while the plank is
//! near the vertical. The force of the floor is
//!
//! ```text
//! N/mg = (1 + 12 e (1 - e) + 12 (y - e)^2)/(1 + 3 s^2)^2,
//! ```
//!
//! a quarter just before the impact, whatever the start. It is never negative after
//! a start at which it is not: a start that would need a floor that pulls is refused.
//!
//! Source: the notes, 15.3, exercise 3, for the equation of motion; the variable and
//! the form of N are ours.

use crate::ladder::gauss_legendre;
use rotation_dynamics::error::{Error, Result, finite, plain};
use rotation_dynamics::math::{self, DoubleDouble as Dd, EPS};
use rotation_dynamics::motion::{Kept, Motion, condition_of_each};

/// While X + V is below this, the integrand is 1 to 19 digits.
const UPRIGHT: f64 = 1e-10;

/// The plank at one time, SI.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlankState {
    /// Angle from the vertical, rad.
    pub theta: f64,
    /// Its rate, rad/s.
    pub omega: f64,
    /// Height of the centre of mass, m.
    pub y_cm: f64,
    /// Vertical velocity of the centre of mass, m/s (negative: downwards).
    pub vy_cm: f64,
    /// Force of the floor over the weight.
    pub floor_force: f64,
}

/// A uniform plank falling over on a smooth floor.
///
/// ```
/// use models::plank::Plank;
/// let plank = Plank::new(1.0, 9.80665, 0.01, 0.0)?;
/// assert!((plank.landing_time() - 0.883_792_345_570_950_95).abs() < 2e-16);
/// assert!((plank.landing().floor_force - 0.25).abs() < 1e-15);
/// # Ok::<(), rotation_dynamics::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct Plank {
    length: f64,
    gravity: f64,
    theta0: f64,
    omega0: f64,
    /// lambda.
    rate: Dd,
    x0: f64,
    v0: f64,
    c: f64,
    /// e.
    excess: f64,
    landing_time: f64,
    landing_omega: f64,
    /// Where the panels of the quadrature begin, and lambda t there; the last entry is
    /// the landing.
    panels: Vec<(f64, Dd)>,
}

impl Plank {
    /// A plank of `length` (m, 1e-100 to 1e100) under `gravity` (m/s^2, the same range), let go at
    /// `theta0` (rad from the vertical, 0 <= theta0 < pi/2) with the rate `omega0` (rad/s, not
    /// negative). Not both may be 0: it would stay upright for ever.
    ///
    /// # Errors
    /// `NotFinite` and `OutOfRange`, also if the start is so fast that the
    /// plank leaves the floor at once, `omega0^2 cos(theta0) > 2 g/l`.
    pub fn new(length: f64, gravity: f64, theta0: f64, omega0: f64) -> Result<Self> {
        let size = "it must lie between 1e-100 and 1e100";
        let angle = "the plank leans at an angle from the vertical, in radians, from 0 (upright) \
                     to below pi/2 = 1.5708 (flat)";
        let sense = "the plank falls towards growing theta: omega0 must be 0 or positive";
        let flat = core::f64::consts::FRAC_PI_2;
        for (name, value, inside, allowed) in [
            ("length", length, (1e-100..=1e100).contains(&length), size),
            ("gravity", gravity, (1e-100..=1e100).contains(&gravity), size),
            ("theta0", theta0, (0.0..flat).contains(&theta0), angle),
            ("omega0", omega0, omega0 >= 0.0, sense),
        ] {
            finite(name, value)?;
            if !inside {
                return Err(Error::out_of_range(name, value, allowed));
            }
        }
        let (sin0, cos0) = Dd::from(theta0).sin_cos();
        let limit = (2.0 * gravity / length / cos0.to_f64()).sqrt();
        if omega0 > limit {
            return Err(Error::out_of_range(
                "omega0",
                omega0,
                format!(
                    "at this angle at most {} rad/s; faster, the floor would have to pull to keep \
                     the foot down",
                    plain(limit)
                ),
            ));
        }
        let rate = (Dd::from(gravity) * 6.0 / length).sqrt();
        let (sin_half, cos_half) = Dd::from(0.5 * theta0).sin_cos();
        let stretch = sin0.square() * 3.0 + 1.0;
        let v0 = stretch.sqrt() * omega0 / (rate * cos_half).scaled(2.0);
        let factor = v0.square() + 1.0;
        let (x0, c) = (sin_half * factor.sqrt(), cos_half * factor.sqrt());
        let begin = x0 + v0;
        if begin < 1e-280 {
            return Err(Error::out_of_range(
                "theta0",
                theta0,
                "at 0 at rest the plank stands for ever; theta0 or omega0/sqrt(6g/l) \
                          must be at least 1e-280",
            ));
        }
        // C^2 - X0^2 without cancellation, which is also V^2 - V0^2 at the landing.
        let rise = factor * cos0;
        let landing_v = (v0.square() + rise).sqrt();
        let landing_w = (rise / begin * ((c + x0).recip() + (landing_v + v0).recip())).ln_1p();
        let mut plank = Self {
            length,
            gravity,
            theta0,
            omega0,
            rate,
            x0: x0.to_f64(),
            v0: v0.to_f64(),
            c: c.to_f64(),
            excess: (sin_half.square() - (v0 * cos_half).square()).to_f64(),
            landing_time: 0.0,
            landing_omega: (rate * landing_v * Dd::from(0.5).sqrt()).to_f64(),
            panels: Vec::new(),
        };
        plank.panels = plank.measured_panels(landing_w.to_f64());
        let end = plank.panels.last().map_or(Dd::ZERO, |panel| panel.1);
        plank.landing_time = (end / rate).to_f64();
        Ok(plank)
    }

    /// Length, m.
    pub fn length(&self) -> f64 {
        self.length
    }

    /// Acceleration of gravity, m/s^2.
    pub fn gravity(&self) -> f64 {
        self.gravity
    }

    /// lambda = sqrt(6g/l), 1/s: how fast the smallest tilt grows.
    pub fn growth_rate(&self) -> f64 {
        self.rate.to_f64()
    }

    /// The time at which the plank lies on the floor, s.
    ///
    /// Accuracy: relative error at most 2.9 eps over the cases of [`Self::at`].
    pub fn landing_time(&self) -> f64 {
        self.landing_time
    }

    /// The state at t = 0.
    pub fn start(&self) -> PlankState {
        PlankState { theta: self.theta0, omega: self.omega0, ..self.state(0.0) }
    }

    /// The state just before the impact, theta = pi/2: `omega^2 = lambda^2 (1/2 - e)`,
    /// a floor force of a quarter of the weight.
    pub fn landing(&self) -> PlankState {
        PlankState {
            theta: core::f64::consts::FRAC_PI_2,
            omega: self.landing_omega,
            y_cm: 0.0,
            vy_cm: -0.5 * self.length * self.landing_omega,
            floor_force: 0.25,
        }
    }

    /// The state `t` seconds after the start, `0 <= t <= landing_time`.
    ///
    /// # Errors
    /// `NotFinite`; `OutsideRun` before the start and after the impact.
    ///
    /// # Accuracy
    /// Error over eps (|value| + sens), sens the change of the value when each input and `t` change
    /// by their own size: at most 4.21 over 68 cases. They are released at rest from 1e-30 to 1e-12
    /// short of the floor, pushed, and balanced (e = 0 to 1e-9). The largest is for the force;
    /// it is 1.82 for theta, 1.45 for omega and 1.39 for y_cm.
    ///
    /// Cost: Newton's method on a 12-point rule, three or four rounds of 13 `sinh` and `cosh`.
    pub fn at(&self, t: f64) -> Result<PlankState> {
        finite("t", t)?;
        // The last place of landing_time is not certain: that close counts as landed.
        if !(0.0..=self.landing_time * (1.0 + 4.0 * EPS)).contains(&t) {
            return Err(Error::OutsideRun { t, start: 0.0, end: self.landing_time });
        }
        if t >= self.landing_time {
            return Ok(self.landing());
        }
        Ok(self.state(self.progress(self.rate * t)))
    }

    /// The panels of the quadrature. The integrand's singularities lie pi/2 off the
    /// real axis of w, or (for a push with e < 0) asin(0.27 C/sqrt(-e)) at least: panels
    /// of 1.2 and 0.2 leave 5.4^-24 = 3e-18 to the 12-point rule.
    fn measured_panels(&self, end: f64) -> Vec<(f64, Dd)> {
        let head = (math::log(UPRIGHT) - math::log(self.x0 + self.v0)).clamp(0.0, end);
        let longest = if self.excess > -0.05 { 1.2 } else { 0.2 };
        let count = ((end - head) / longest).ceil().max(1.0);
        let mut panels = vec![(0.0, Dd::ZERO)];
        if head > 0.0 {
            panels.push((head, Dd::from(head)));
        }
        let mut at = head;
        let mut phase = Dd::from(head);
        for n in 1..=count as usize {
            let next = head + (end - head) * (n as f64 / count);
            phase += Dd::from(self.stretch_between(at, next - at));
            at = next;
            panels.push((at, phase));
        }
        panels
    }

    /// The integral of the slope from `start` over `length`.
    fn stretch_between(&self, start: f64, length: f64) -> f64 {
        gauss_legendre(length, |x| self.point(start + x).slope())
    }

    /// w at the phase lambda t: Newton's method inside one panel.
    fn progress(&self, phase: Dd) -> f64 {
        let after = self.panels.partition_point(|panel| panel.1 <= phase);
        let (start, begun) = self.panels[after.clamp(1, self.panels.len() - 1) - 1];
        let target = (phase - begun).to_f64();
        if self.point(start).x + self.point(start).v < 0.5 * UPRIGHT {
            return target;
        }
        let guess = target / self.point(start).slope();
        let mut x = target / self.point(start + 0.5 * guess).slope();
        for _ in 0..8 {
            let slope = self.point(start + x).slope();
            let step = (target - self.stretch_between(start, x)) / slope;
            x += step;
            // Convergence is quadratic: the error left is far below this step squared.
            if step.abs() <= 1e-9 * x {
                break;
            }
        }
        start + x
    }

    fn point(&self, w: f64) -> Point {
        let (sinh, cosh) = (math::sinh(w), math::cosh(w));
        let x = self.x0 * cosh + self.v0 * sinh;
        let v = self.v0 * cosh + self.x0 * sinh;
        let factor = v * v + 1.0;
        let sin = 2.0 * x * self.c / factor;
        let cos = (self.c - x) * (self.c + x) / factor;
        // From the smaller of the two: the other's rounding would count in full.
        let stretch = if sin < cos { 1.0 + 3.0 * sin * sin } else { 4.0 - 3.0 * cos * cos };
        Point { x, v, factor, sin, cos, stretch }
    }

    fn state(&self, w: f64) -> PlankState {
        let p = self.point(w);
        let omega = 2.0 * self.rate.to_f64() * p.v * self.c / (p.factor * p.stretch).sqrt();
        let e = self.excess;
        // For either sign of e a sum of positive terms, but for 1 + 12 e, which vanishes
        // where the floor lets go.
        let force = if e >= 0.0 {
            let kinetic = p.v * self.c * (p.v * self.c) / p.factor;
            1.0 + 12.0 * e * (1.0 - e) + 12.0 * kinetic * kinetic
        } else {
            let y = p.x * p.x / p.factor;
            1.0 + 12.0 * e + 12.0 * y * (y - 2.0 * e)
        };
        PlankState {
            theta: 2.0 * math::atan2(p.x, self.c),
            omega,
            y_cm: 0.5 * self.length * p.cos,
            vy_cm: -0.5 * self.length * p.sin * omega,
            floor_force: force / (p.stretch * p.stretch),
        }
    }
}

/// The inputs of the condition are length, gravity, theta0, omega0 and the time; the answer is
/// theta.
impl Motion for Plank {
    type State = PlankState;

    fn name(&self) -> &'static str {
        "closed form of the falling plank"
    }

    fn try_state(&self, t: f64) -> Result<PlankState> {
        self.at(t)
    }

    fn kept(&self) -> Vec<Kept> {
        vec![Kept::new("e = y - (theta'^2 (1 + 3 s^2))/(4 lambda^2)", "", self.excess)]
    }

    fn condition(&self, t: f64) -> Result<f64> {
        let here = self.at(t)?;
        let inputs = [self.length, self.gravity, self.theta0, self.omega0];
        let turned = here.omega * t;
        let square =
            condition_of_each(turned * turned, inputs, |[length, gravity, theta0, omega0]| {
                let other = Self::new(length, gravity, theta0, omega0)?;
                // One that lands before t is no neighbour: the other direction is felt.
                Ok((other.at(t)?.theta - here.theta).abs())
            })?;
        Ok(square.sqrt())
    }
}

/// The geometry at a given w.
struct Point {
    x: f64,
    v: f64,
    /// 1 + V^2.
    factor: f64,
    sin: f64,
    cos: f64,
    /// 1 + 3 sin^2(theta).
    stretch: f64,
}

impl Point {
    /// d(lambda t)/dw.
    fn slope(&self) -> f64 {
        (self.stretch / self.factor).sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Just before the impact the plank is as it lands.
    #[test]
    fn it_lands_as_it_falls() {
        let plank = Plank::new(1.3, 9.8, 0.02, 0.1).expect("a plank");
        let (landing, before) = (plank.landing(), 1e-7 * plank.landing_time());
        let near = plank.at(plank.landing_time() - before).expect("in the fall");
        let pairs = [
            (landing.theta, near.theta + near.omega * before),
            (landing.omega, near.omega),
            (landing.y_cm, near.y_cm + near.vy_cm * before),
            (landing.vy_cm, near.vy_cm),
            (landing.floor_force, near.floor_force),
        ];
        for (there, near) in pairs {
            assert!((there - near).abs() < 1e-5, "{there} {near}");
        }
    }
}
