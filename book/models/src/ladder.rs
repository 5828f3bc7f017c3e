//! The sliding ladder (exercise 16.6), at any time, without stepping.
//!
//! A uniform ladder rests between a smooth wall and a smooth floor and is released at rest at the
//! angle `theta0` from the wall. While it touches the wall its motion is a Jacobi function; after
//! the wall has let go the time is a quadrature with a smooth integrand. Both are evaluated here to
//! a few units of round-off, from a release a hair off the vertical to one a hair off the floor.
//!
//! Not for: friction, a start with a push, the impact on the floor. Those scenes
//! are simulated, with [`rotation_dynamics::planar`].
//!
//! # On the wall
//!
//! With `k = cos(theta0/2)`, `k' = sin(theta0/2)`, `W^2 = 3g/(2l)` and `tau = W t`,
//! energy `theta'^2 = (3g/l)(cos theta0 - cos theta)` gives
//!
//! ```text
//! sin(theta/2) = k'/dn(tau|k^2),   cos(theta/2) = k cn(tau|k^2)/dn(tau|k^2),
//! theta' = W sin(theta0) sn/dn.
//! ```
//!
//! The two contacts together push with `m g/4` upward and `F = (9/4) m g (cos theta -
//! (2/3) cos theta0)` along the line from the corner to the centre of mass: wall
//! `F sin theta`, floor `m g/4 + F cos theta`. The wall lets go where `F = 0`.
//!
//! # Off the wall
//!
//! Let `u = cos theta`, `C = cos theta0 - cos^3 theta0/9` and `v^2 = C - u`. Then
//! `theta'^2 = (12 g/l) v^2/(4 - 3u^2)`, and in the variable `v` nothing is singular:
//!
//! ```text
//! t - t_r = sqrt(l/(12 g)) * integral of 2 sqrt((4 - 3u^2)/(1 - u^2)) dv,
//! x_top   = l * integral of (u_r - u)^2 (u + u_r/2) / (s (a sqrt(4 - 3u^2) + u v)) dv,
//! ```
//!
//! with `u_r = (2/3) cos theta0`, `s = sin theta`, `a = (cos theta0/3)^(3/2)`, both from
//! the release on. The second integrand is a square times positive factors: the top
//! moves away from the wall and never comes back, for every `theta0`. The floor pushes
//! with `m g/4 - (9/4) m g u (u_r - u)(4 - u^2 - u u_r - u_r^2)/(4 - 3u^2)^2`.
//!
//! Source: lecture notes, chapter 16, exercise 6; the two integrals are ours.

use rotation_dynamics::error::{Error, Result, finite};
use rotation_dynamics::exact::Modulus;
use rotation_dynamics::exact::carlson::rf_extended;
use rotation_dynamics::exact::jacobi::Jacobi;
use rotation_dynamics::math::{self, DoubleDouble};
use rotation_dynamics::motion::{Kept, Motion, condition_of_each};

/// The smallest angle of release: below it `theta0^2` leaves the range of the
/// double-double products.
const SMALLEST_ANGLE: f64 = 1e-140;

/// The contacts of the ladder.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Phase {
    /// Top on the wall, foot on the floor.
    OnWall,
    /// Foot on the floor only.
    OffWall,
}

/// The ladder at one time.
///
/// Lengths in metres from the corner (`x` away from the wall, `y` up), angles in
/// radians from the wall, forces in units of the weight `m g`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LadderState {
    pub phase: Phase,
    /// Angle from the wall.
    pub theta: f64,
    /// Rate of that angle, rad/s.
    pub omega: f64,
    /// Centre of mass, away from the wall.
    pub x_cm: f64,
    /// Centre of mass, above the floor.
    pub y_cm: f64,
    /// Distance of the top from the wall; exactly 0 on the wall.
    pub x_top: f64,
    /// Horizontal velocity of the centre of mass, m/s.
    pub vx_cm: f64,
    /// Force of the floor over the weight.
    pub floor_force: f64,
    /// Force of the wall over the weight; exactly 0 off the wall.
    pub wall_force: f64,
}

/// A uniform ladder released at rest against a smooth wall.
///
/// ```
/// use models::ladder::{Ladder, Phase};
/// let ladder = Ladder::new(3.0, 9.80665, 0.25)?;
/// assert!((ladder.release_time() - 0.876_085_675_555_771).abs() < 1e-15);
/// assert_eq!(ladder.at(1.0)?.phase, Phase::OffWall);
/// assert!((ladder.landing().floor_force - 0.25).abs() < 1e-15);
/// # Ok::<(), rotation_dynamics::Error>(())
/// ```
#[derive(Debug, Clone, Copy)]
pub struct Ladder {
    length: f64,
    gravity: f64,
    theta0: f64,
    // On the wall.
    /// sin and cos of theta0, and of theta0/2 (that is k' and k).
    sin0: f64,
    cos0: f64,
    sin_half: f64,
    cos_half: f64,
    /// W = sqrt(3g/(2l)).
    rate: DoubleDouble,
    functions: Jacobi,
    release_time: DoubleDouble,
    // Off the wall.
    /// u_r = (2/3) cos theta0.
    release_cos: f64,
    /// v at the release, and how much it grows until the floor.
    release_v: f64,
    growth: f64,
    /// sqrt(12 g/l).
    fall_rate: f64,
    release_x: f64,
    release_vx: f64,
    landing_time: f64,
}

impl Ladder {
    /// A ladder of `length` (m, 1e-100 to 1e100) under `gravity` (m/s^2, the same
    /// range), released at rest at `theta0` (rad from the wall, above 1e-140 and
    /// below pi/2).
    ///
    /// # Errors
    /// Anything outside those ranges. At `theta0 = 0` the ladder never falls; at pi/2 and beyond it
    /// lies.
    pub fn new(length: f64, gravity: f64, theta0: f64) -> Result<Self> {
        let allowed = "it must lie between 1e-100 and 1e100";
        in_range("length", length, 1e-100..=1e100, allowed)?;
        in_range("gravity", gravity, 1e-100..=1e100, allowed)?;
        finite("theta0", theta0)?;
        if !(SMALLEST_ANGLE..core::f64::consts::FRAC_PI_2).contains(&theta0) {
            return Err(Error::out_of_range(
                "theta0",
                theta0,
                "the ladder leans at an angle from the wall, in radians, between 0 \
                          (upright: it never starts; at least 1e-140) and pi/2 = 1.5708 (flat)",
            ));
        }
        let (l, g) = (DoubleDouble::from(length), DoubleDouble::from(gravity));
        let (sin0, cos0) = DoubleDouble::from(theta0).sin_cos();
        let (sin_half, cos_half) = DoubleDouble::from(0.5 * theta0).sin_cos();
        let rate = (g * 1.5 / l).sqrt();

        // F(phi_r | k^2) with sin^2 phi_r = (2/3) c0 / ((1 + c0)(1 - c_r)); every
        // factor is a product or a sum of positive terms once 1 - c0 = 2 sin^2(theta0/2).
        let release_cos = cos0 * 2.0 / 3.0;
        let versine0 = sin_half.square().scaled(2.0);
        let release_phase = (release_cos / (cos0 + 1.0)).sqrt()
            * rf_extended(
                versine0 * (release_cos + 1.0) / (cos0 + 1.0),
                versine0,
                1.0 - release_cos,
            );

        let square0 = cos0.square();
        let release_v = (cos0 * (3.0 - square0)).sqrt() / 3.0;
        let landing_v = (cos0 * (9.0 - square0)).sqrt() / 3.0;
        let release_vx = cos0 / 3.0 * (g * l * cos0).sqrt();

        let mut ladder = Self {
            length,
            gravity,
            theta0,
            sin0: sin0.to_f64(),
            cos0: cos0.to_f64(),
            sin_half: sin_half.to_f64(),
            cos_half: cos_half.to_f64(),
            rate,
            functions: Jacobi::new(Modulus::from_m1(sin_half.square().to_f64())?),
            release_time: release_phase / rate,
            release_cos: release_cos.to_f64(),
            release_v: release_v.to_f64(),
            // The difference of the two v without cancellation.
            growth: (release_cos / (landing_v + release_v)).to_f64(),
            fall_rate: (g * 12.0 / l).sqrt().to_f64(),
            release_x: (l * 0.5 * (1.0 - release_cos.square()).sqrt()).to_f64(),
            release_vx: release_vx.to_f64(),
            landing_time: 0.0,
        };
        let fall = ladder.fall_phase(ladder.growth) / ladder.fall_rate;
        ladder.landing_time = (ladder.release_time + fall).to_f64();
        Ok(ladder)
    }

    /// Length, m.
    pub fn length(&self) -> f64 {
        self.length
    }

    /// Acceleration of gravity, m/s^2.
    pub fn gravity(&self) -> f64 {
        self.gravity
    }

    /// Angle of release from the wall, rad.
    pub fn theta0(&self) -> f64 {
        self.theta0
    }

    /// The time at which the wall lets go, s: [`F`](rotation_dynamics::exact::legendre::f) at the amplitude
    /// with `sin^2 phi = (2/3) cos theta0 / ((1 + cos theta0)(1 - (2/3) cos theta0))`, over `W`.
    ///
    /// Accuracy: half a unit in the last place (formed in double-double).
    pub fn release_time(&self) -> f64 {
        self.release_time.to_f64()
    }

    /// The time at which the ladder lies on the floor, s: the release time and the
    /// integral, formed to a few units in the last place.
    pub fn landing_time(&self) -> f64 {
        self.landing_time
    }

    /// The time to the floor of a ladder whose top is held to the wall, s:
    /// `sqrt(2 c0/(1 + c0)) R_F((1 - c0)/(1 + c0), 1 - c0, 1)/W`, `c0 = cos theta0`.
    ///
    /// No smooth wall does that; it is the answer of a solver that lets the wall pull.
    /// Accuracy: half a unit in the last place.
    pub fn held_landing_time(&self) -> f64 {
        let (sin_half, cos_half) = DoubleDouble::from(0.5 * self.theta0).sin_cos();
        let versine0 = sin_half.square().scaled(2.0);
        // 1 + c0 and c0 itself, without cancellation.
        let covered = cos_half.square().scaled(2.0);
        let (_, cos0) = DoubleDouble::from(self.theta0).sin_cos();
        let phase = (cos0.scaled(2.0) / covered).sqrt()
            * rf_extended(versine0 / covered, versine0, DoubleDouble::ONE);
        (phase / self.rate).to_f64()
    }

    /// The state in which the wall lets go: `cos theta = (2/3) cos theta0`,
    /// `omega^2 = g cos theta0/l`, a floor force of a quarter of the weight.
    pub fn release(&self) -> LadderState {
        LadderState { wall_force: 0.0, phase: Phase::OnWall, ..self.off_wall(0.0, 0.0) }
    }

    /// The state in which the ladder meets the floor, `theta = pi/2`, just before the
    /// impact: `omega^2 = (g cos theta0/l)(3 - cos^2 theta0/3)`, again a quarter of the weight.
    pub fn landing(&self) -> LadderState {
        LadderState {
            theta: core::f64::consts::FRAC_PI_2,
            y_cm: 0.0,
            ..self.off_wall(self.growth, self.since_release(self.landing_time))
        }
    }

    /// The state `t` seconds after the release from rest, `0 <= t <= landing_time`.
    ///
    /// Accuracy, measured on 170 ladders from 1e-100 rad off the wall to the last double
    /// below pi/2: every field within 3.3 eps of its size and condition (the change for
    /// relative changes of the inputs). `x_top` keeps its relative accuracy at the release.
    /// Cost: a set of Jacobi functions on the wall, some 130 square roots off it.
    ///
    /// # Errors
    /// A time outside the motion: the motion after the impact depends on the floor's restitution,
    /// which the problem does not state.
    pub fn at(&self, t: f64) -> Result<LadderState> {
        finite("t", t)?;
        // The last place of landing_time is not certain: that close counts as landed.
        let end = self.landing_time * (1.0 + 4.0 * math::EPS);
        if !(0.0..=end).contains(&t) {
            return Err(Error::OutsideRun { t, start: 0.0, end: self.landing_time });
        }
        if DoubleDouble::from(t) <= self.release_time {
            return self.on_wall(t);
        }
        if t >= self.landing_time {
            return Ok(self.landing());
        }
        let since = self.since_release(t);
        Ok(self.off_wall(self.grown_v(since), since))
    }

    /// `t - t_r`, exact to its own last place also just after the release.
    fn since_release(&self, t: f64) -> f64 {
        (DoubleDouble::from(t) - self.release_time).to_f64()
    }

    fn on_wall(&self, t: f64) -> Result<LadderState> {
        let phase = (self.rate * t).to_f64();
        let (sn, cn, dn) = self.functions.sn_cn_dn(phase)?;
        // dn is left out of both components: the angle does not need it.
        let theta = 2.0 * math::atan2(self.sin_half, self.cos_half * cn);
        let swing = self.sin0 * sn / dn;
        let omega = self.rate.to_f64() * swing;
        let sin = math::sin(theta);
        // Energy gives the cosine with relative accuracy also near the horizontal:
        // it falls from cos0 to (2/3) cos0 only.
        let cos = self.cos0 - 0.5 * swing * swing;
        let half = 0.5 * self.length;
        let push = 2.25 * (cos - self.release_cos);
        Ok(LadderState {
            phase: Phase::OnWall,
            theta,
            omega,
            x_cm: half * sin,
            y_cm: half * cos,
            x_top: 0.0,
            vx_cm: half * cos * omega,
            floor_force: 0.25 + push * cos,
            wall_force: push * sin,
        })
    }

    /// The state after `v` has grown by `x` in the time `since`.
    fn off_wall(&self, x: f64, since: f64) -> LadderState {
        let p = self.point(x);
        let half = 0.5 * self.length;
        // The deviation from a quarter, factored: it vanishes at the release and on the floor.
        let square = p.root * p.root;
        let ur = self.release_cos;
        let shape = 4.0 - p.cos * (p.cos + ur) - ur * ur;
        LadderState {
            phase: Phase::OffWall,
            theta: math::atan2(p.sin, p.cos),
            omega: self.fall_rate * p.v / p.root,
            x_cm: self.release_x + self.release_vx * since,
            y_cm: half * p.cos,
            x_top: self.top_gap(x),
            vx_cm: self.release_vx,
            floor_force: 0.25 - 2.25 * p.cos * p.drop * shape / (square * square),
            wall_force: 0.0,
        }
    }

    fn point(&self, x: f64) -> Point {
        // u_r - u = v^2 - v_r^2, factored.
        let drop = x * (2.0 * self.release_v + x);
        let cos = self.release_cos - drop;
        Point {
            v: self.release_v + x,
            drop,
            cos,
            sin: ((1.0 - cos) * (1.0 + cos)).sqrt(),
            root: (4.0 - 3.0 * cos * cos).sqrt(),
        }
    }

    /// The integral of `2 sqrt((4 - 3u^2)/(1 - u^2)) dv` over the first `x` of growth:
    /// the time since the release, times `sqrt(12 g/l)`.
    fn fall_phase(&self, x: f64) -> f64 {
        gauss_legendre(x, |x| self.fall_slope(x))
    }

    fn fall_slope(&self, x: f64) -> f64 {
        let p = self.point(x);
        2.0 * p.root / p.sin
    }

    /// The distance of the top from the wall.
    fn top_gap(&self, x: f64) -> f64 {
        let third = 0.5 * self.release_cos;
        let a = third * third.sqrt();
        self.length
            * gauss_legendre(x, |x| {
                let p = self.point(x);
                p.drop * p.drop * (p.cos + third) / (p.sin * (a * p.root + p.cos * p.v))
            })
    }

    /// The growth of `v` in the time `since`: Newton's method on [`Self::fall_phase`],
    /// whose integrand varies by a tenth only.
    fn grown_v(&self, since: f64) -> f64 {
        let target = since * self.fall_rate;
        let mut x = target / self.fall_slope(0.0);
        for _ in 0..6 {
            let step = (target - self.fall_phase(x)) / self.fall_slope(x);
            x += step;
            // Convergence is quadratic: the error left is far below this step squared.
            if step.abs() <= 1e-9 * x {
                break;
            }
        }
        x.min(self.growth)
    }
}

/// The inputs of the condition are length, gravity, theta0 and the time; the answer is theta.
impl Motion for Ladder {
    type State = LadderState;

    fn name(&self) -> &'static str {
        "closed form of the sliding ladder"
    }

    fn try_state(&self, t: f64) -> Result<LadderState> {
        self.at(t)
    }

    fn kept(&self) -> Vec<Kept> {
        vec![Kept::new("energy over m g l", "", 0.5 * self.cos0)]
    }

    fn condition(&self, t: f64) -> Result<f64> {
        let here = self.at(t)?;
        let inputs = [self.length, self.gravity, self.theta0];
        let turned = here.omega * t;
        let square = condition_of_each(turned * turned, inputs, |[length, gravity, theta0]| {
            let other = Self::new(length, gravity, theta0)?;
            // One that lands before t is no neighbour: the other direction is felt.
            Ok((other.at(t)?.theta - here.theta).abs())
        })?;
        Ok(square.sqrt())
    }
}

/// The geometry at a given growth of `v` off the wall.
struct Point {
    v: f64,
    drop: f64,
    cos: f64,
    sin: f64,
    root: f64,
}

fn in_range(
    name: &'static str,
    value: f64,
    range: core::ops::RangeInclusive<f64>,
    allowed: &'static str,
) -> Result<()> {
    finite(name, value)?;
    if range.contains(&value) { Ok(()) } else { Err(Error::out_of_range(name, value, allowed)) }
}

/// The integral of `f` from 0 to `end` by the 12-point Gauss rule.
///
/// Both integrands are analytic inside the ellipse of foci 0 and `growth` whose
/// semi-axes add up to 5.4 half-lengths, whatever `theta0`: the error is below
/// `5.4^-24 = 3e-18` of the value. (Abramowitz and Stegun, table 25.4.)
pub(crate) fn gauss_legendre(end: f64, f: impl Fn(f64) -> f64) -> f64 {
    const NODES: [(f64, f64); 6] = [
        (0.981_560_634_246_719_3, 0.047_175_336_386_511_83),
        (0.904_117_256_370_474_9, 0.106_939_325_995_318_43),
        (0.769_902_674_194_304_7, 0.160_078_328_543_346_23),
        (0.587_317_954_286_617_5, 0.203_167_426_723_065_92),
        (0.367_831_498_998_180_2, 0.233_492_536_538_354_8),
        (0.125_233_408_511_468_9, 0.249_147_045_813_402_77),
    ];
    let half = 0.5 * end;
    let sum: f64 =
        NODES.iter().map(|(x, weight)| weight * (f(half * (1.0 - x)) + f(half * (1.0 + x)))).sum();
    half * sum
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The floor carries the weight and what lifts the middle: 1 + y''/g, on the wall and off it.
    #[test]
    fn the_floor_accelerates_the_middle() {
        let (g, h) = (9.8, 1e-3);
        let ladder = Ladder::new(3.0, g, 0.25).expect("a ladder");
        let middle = |t: f64| 0.5 * (ladder.release_time() + t);
        for t in [middle(0.0), middle(ladder.landing_time())] {
            let at = |k: f64| ladder.at(t + k * h).expect("in the fall");
            let [a, b, c, d, e] = [-2.0, -1.0, 0.0, 1.0, 2.0].map(|k| at(k).y_cm);
            let lifted = (16.0 * (b + d) - 30.0 * c - (a + e)) / (12.0 * h * h);
            let force = at(0.0).floor_force;
            assert!((force - 1.0 - lifted / g).abs() < 1e-8, "{t}: {force}");
        }
    }
}
