//! The notes' dimensionless top (16.2): parameters a, b, c and the effective
//! potential.

use crate::error::{Error, Result, finite, positive};
use crate::math::{self, DoubleDouble as Dd, EPS};

/// The dimensionless parameters of a heavy symmetric top.
///
/// a = I3/I1, b = L_Z/L_z, c = m g l I3/L_z^2; the time is t' = t L_z/sqrt(I1 I3).
/// Then
///
///   theta'' = c sin - a (b - cos)(1 - b cos)/sin^3,
///   phi' = sqrt(a) (b - cos)/sin^2,   zeta' = 1/sqrt(a) - phi' cos,
///   E~ = theta'^2/2 + U_eff,   U_eff = (a/2) ((b - cos)/sin)^2 - c (1 - cos).
///
/// ```
/// use rotation_dynamics::exact::heavy_top::ReducedTop;
/// let (theta, energy) = ReducedTop::new(2.0, 1.2, 0.2)?.minimum();
/// assert!((theta - 0.630_629_186_649).abs() < 1e-12);
/// assert!((energy - 0.404_261_861_702_4).abs() < 1e-12);
/// # Ok::<(), rotation_dynamics::Error>(())
/// ```
///
/// Source: the notes, 16.2 (4)-(6).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ReducedTop {
    a: f64,
    b: f64,
    c: f64,
}

impl ReducedTop {
    /// The top with these parameters: 0 < a <= 2 (no body has I3 > 2 I1), any b and c.
    ///
    /// # Errors
    /// A parameter that is not finite; a outside (0, 2];
    /// [`Error::OutOfRange`] for parameters whose squares leave the range of doubles.
    pub fn new(a: f64, b: f64, c: f64) -> Result<Self> {
        positive("a", a)?;
        if a > 2.0 {
            return Err(Error::out_of_range(
                "a",
                a,
                "a = I3/I1 lies in (0, 2]: no body has I3 > 2 I1",
            ));
        }
        Self::formal(a, b, c)
    }

    /// The same equations for any a > 0, whether a body has it or not.
    ///
    /// # Errors
    /// A parameter that is not finite; a <= 0;
    /// [`Error::OutOfRange`] for parameters whose squares leave the range of doubles.
    pub fn formal(a: f64, b: f64, c: f64) -> Result<Self> {
        let top = Self { a: positive("a", a)?, b: finite("b", b)?, c: finite("c", c)? };
        let moderate = |x: f64| x == 0.0 || (1e-40..1e40).contains(&x.abs());
        if [a, b - 1.0, b + 1.0, c].into_iter().all(moderate) {
            return Ok(top);
        }
        let (theta, value) = top.minimum();
        if theta.is_finite() && value.is_finite() {
            Ok(top)
        } else {
            // In units of t': the spin 1/sqrt(a), the precession, the fall.
            let fastest = (1.0 / a.sqrt()).max(a.sqrt() * (1.0 + b.abs()));
            Err(too_far_apart(fastest.max(c.abs().sqrt())))
        }
    }

    /// a = I3/I1.
    pub const fn a(&self) -> f64 {
        self.a
    }

    /// b = L_Z/L_z.
    pub const fn b(&self) -> f64 {
        self.b
    }

    /// c = m g l I3/L_z^2.
    pub const fn c(&self) -> f64 {
        self.c
    }

    /// The effective potential U_eff(theta); infinite at a pole that the top cannot
    /// reach.
    ///
    /// (b - cos)/sin = ((b + 1) tan(theta/2) + (b - 1) cot(theta/2))/2: nothing cancels
    /// that need not.
    pub fn effective_potential(&self, theta: f64) -> f64 {
        let (sin, cos) = math::sincos(theta / 2.0);
        let q = self.half_ratio(sin, cos);
        0.5 * self.a * q * q - 2.0 * self.c * sin * sin
    }

    /// The acceleration theta'' = -dU_eff/dtheta (notes, 16.2 (4)).
    pub fn torque(&self, theta: f64) -> f64 {
        let (sin, cos) = math::sincos(theta / 2.0);
        let Self { a, b, c } = *self;
        // dU/dtheta = (a/8)((b+1)^2 s/c^3 - (b-1)^2 c/s^3) - 2 c s c.
        let ratio = |factor: f64, over: f64, under: f64| {
            if factor == 0.0 { 0.0 } else { factor * factor * over / (under * under * under) }
        };
        2.0 * c * sin * cos - a / 8.0 * (ratio(b + 1.0, sin, cos) - ratio(b - 1.0, cos, sin))
    }

    /// The precession rate phi' = sqrt(a)(b - cos)/sin^2 (notes, 16.2 (5)).
    pub fn phi_rate(&self, theta: f64) -> f64 {
        let (sin, cos) = math::sincos(theta / 2.0);
        self.a.sqrt() * self.half_ratio(sin, cos) / (2.0 * sin * cos)
    }

    /// (b - cos)/sin from the sine and cosine of theta/2.
    fn half_ratio(&self, sin: f64, cos: f64) -> f64 {
        let part = |factor: f64, over: f64, under: f64| {
            if factor == 0.0 { 0.0 } else { factor * over / under }
        };
        0.5 * (part(self.b + 1.0, sin, cos) + part(self.b - 1.0, cos, sin))
    }

    /// Where U_eff is smallest, and its value: (theta, U_min).
    ///
    /// In T = tan^2(theta/2), U_eff = (a/8)((b-1)^2/T + 2(b^2-1) + (b+1)^2 T) - 2cT/(1+T)
    /// is convex (for c < 0, in 1/T), so Newton's method from the left cannot miss.
    /// Accuracy: within 1 eps of themselves in 250 cases.
    pub fn minimum(&self) -> (f64, f64) {
        let (theta, value, _) = self.minimum_dd();
        (theta.to_f64(), value.to_f64())
    }

    /// True if E~ is above U_min by more than rounding in `f64` can pretend: without
    /// finding the minimum to its last digit.
    pub(super) fn is_well_above_minimum(&self, energy: f64) -> bool {
        let eighth = 0.125 * self.a;
        let (left, right) =
            if self.c >= 0.0 { (self.b - 1.0, self.b + 1.0) } else { (self.b + 1.0, self.b - 1.0) };
        let (p, q) = (eighth * left * left, eighth * right * right);
        let r = 2.0 * self.c.abs();
        // U at any place is at least U_min: where its slope begins to be sought is often enough.
        let above = |place: f64| {
            let t = place.sqrt();
            let (left, right) = (left / t, right * t);
            let rotational = eighth * (left + right) * (left + right);
            let fall = place * r / (place + 1.0);
            let here = if self.c >= 0.0 { rotational - fall } else { rotational + (r - fall) };
            let size = eighth * (left.abs() + right.abs()) * (left.abs() + right.abs()) + r;
            energy - here > 64.0 * EPS * size
        };
        let start = (p / q).sqrt().max((r / q).sqrt() - 1.0);
        above(start) || (p != 0.0 && r != 0.0 && above(newton_from_left(p, q, r, start)))
    }

    /// Angle and value of the minimum, and the size of the terms that make the value.
    pub(super) fn minimum_dd(&self) -> (Dd, Dd, f64) {
        let a = Dd::from(self.a);
        let upper = Dd::sum(self.b, -1.0);
        let lower = Dd::sum(self.b, 1.0);
        let (p, q) = if self.c >= 0.0 { (upper, lower) } else { (lower, upper) };
        let eighth = a.scaled(0.125);
        let p = eighth * p.square();
        let q = eighth * q.square();
        let r = 2.0 * self.c.abs();
        // Minimum of p/T + q T - r T/(1+T) over T >= 0. With |b^2 - 1| a/4 = 2 sqrt(pq) the
        // rotational part is a square: (a/8) (left/t + right t)^2, t^2 = T, no difference
        // of large terms.
        let (left, right) = if self.c >= 0.0 { (upper, lower) } else { (lower, upper) };
        let (theta, rotational, fall) = match convex_minimum(p, q, r) {
            None => (Dd::PI, Dd::ZERO, Dd::from(r)),
            Some(place) => {
                let t = place.sqrt();
                let sum = (left / t).abs() + (right * t).abs();
                let ratio = if t == 0.0 {
                    Dd::ZERO
                } else if self.b.abs() > 1.0 {
                    sum
                } else {
                    // A difference; by U' = 0 it is this quotient.
                    place * r / ((place + 1.0).square() * eighth * sum)
                };
                let fall = place * r / (place + 1.0);
                (t.atan().scaled(2.0), eighth * ratio.square(), fall)
            }
        };
        if self.c >= 0.0 {
            let size = rotational.hi() + fall.hi();
            (theta, rotational - fall, size)
        } else {
            // T -> 1/T turned -2cT/(1+T) into r/(1+T) = r - fall.
            let gravity = Dd::from(r) - fall;
            (Dd::PI - theta, rotational + gravity, rotational.hi() + r)
        }
    }

    /// The energy at which the path has cusps, E~ = -c (1 - b): released from rest at
    /// cos theta = b. `None` unless |b| < 1.
    pub fn cusp_energy(&self) -> Option<f64> {
        (self.b.abs() < 1.0).then(|| (Dd::sum(self.b, -1.0) * self.c).to_f64())
    }

    /// How far E~ may lie below U_min and still mean U_min: the error that rounding U_min to a
    /// double, by any sound route, may make.
    pub(super) fn energy_slack(size: f64) -> f64 {
        8.0 * EPS * size
    }
}

/// The T >= 0 at which p/T + q T - r T/(1+T) is smallest; `None` for infinity.
fn convex_minimum(p: Dd, q: Dd, r: f64) -> Option<Dd> {
    if q == 0.0 {
        return None;
    }
    let by_gravity = (Dd::from(r) / q).sqrt() - 1.0;
    let start = (p / q).sqrt().max(by_gravity).max(Dd::ZERO);
    if p == 0.0 || r == 0.0 {
        return Some(start);
    }
    let mut t = Dd::from(newton_from_left(p.hi(), q.hi(), r, start.hi()));
    for _ in 0..4 {
        let f = q - p / t.square() - Dd::from(r) / (t + 1.0).square();
        t = t - f / slope(p.hi(), r, t.hi());
    }
    Some(t)
}

/// f = q - p/T^2 - r/(1+T)^2 is increasing and concave, f(start) <= 0: Newton's steps
/// never pass the root.
fn newton_from_left(p: f64, q: f64, r: f64, start: f64) -> f64 {
    let mut t = start;
    for _ in 0..200 {
        let f = q - p / (t * t) - r / ((1.0 + t) * (1.0 + t));
        let next = t - f / slope(p, r, t);
        if next > t {
            t = next;
        } else {
            break;
        }
    }
    t
}

/// f'(T).
fn slope(p: f64, r: f64, t: f64) -> f64 {
    2.0 * (p / (t * t * t) + r / ((1.0 + t) * (1.0 + t) * (1.0 + t)))
}

/// The refusal of rates (or parameters) of which the squares are no doubles.
pub(super) fn too_far_apart(fastest: f64) -> Error {
    Error::out_of_range(
        "fastest rate",
        fastest,
        "the rates of this motion are too large, too small or too far apart; their squares, and the \
         products and quotients of the squares, must stay within doubles, from 1e-308 to 1e299",
    )
}
