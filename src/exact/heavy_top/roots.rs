//! The cubic of the heavy top and the gaps between its roots, each to full
//! relative accuracy.
//!
//! With v = cos(theta) when gravity pulls the axis down (m g l >= 0) and
//! v = -cos(theta) otherwise, so that beta = 2 |m g l| / I1 >= 0,
//!
//!   v'^2 = F(v) = (1 - v^2)(alpha - beta v) - (A - B v)^2
//!        = beta (v - v1)(v - v2)(v - v3),   -1 <= v1 <= v2 <= 1 <= v3,
//!
//! A = L_Z/I1, B = +-L_z/I1. The motion depends on differences: 1 - v2 near the upper pole, v3 - v2
//! near the homoclinic motion, v2 - v1 near steady precession. Subtracting computed roots would
//! lose them. F is therefore expanded about v = 1, about v = -1 and about the initial state, where
//! its coefficients are known without cancellation. The products of roots (Vieta) give the small
//! ones from the large ones.
//!
//! Source: the notes, 16.2 (4)-(6); E. T. Whittaker, *Analytical Dynamics*, 71.

use crate::math::{DoubleDouble as Dd, ilogb, ldexp};

/// The conserved quantities, in the variable v.
#[derive(Debug, Clone, Copy)]
pub(super) struct Conserved {
    /// B = +-L_z/I1.
    pub(super) spin: Dd,
    /// A - B: zero for a motion that can reach v = 1.
    pub(super) difference: Dd,
    /// A + B: zero for a motion that can reach v = -1.
    pub(super) sum: Dd,
    /// alpha - beta.
    pub(super) excess: Dd,
    /// alpha + beta.
    pub(super) total: Dd,
    /// beta >= 0.
    pub(super) gravity: Dd,
}

impl Conserved {
    /// The largest of the squares of rates, to a double's digits.
    pub(super) fn largest_square(&self) -> f64 {
        [self.spin, self.difference, self.sum]
            .map(|rate| rate.hi() * rate.hi())
            .into_iter()
            .chain([self.excess, self.total, self.gravity].map(|square| square.hi().abs()))
            .fold(0.0, f64::max)
    }
}

/// Where the motion starts.
#[derive(Debug, Clone, Copy)]
pub(super) enum Origin {
    /// At the turning point v1.
    Lower,
    /// At the turning point v2.
    Upper,
    /// At a state.
    State(State),
}

/// An initial state, as the expansion of F about it.
#[derive(Debug, Clone, Copy)]
pub(super) struct State {
    /// 1 - v, without cancellation.
    pub(super) to_one: Dd,
    /// 1 + v, without cancellation.
    pub(super) from_minus_one: Dd,
    /// v'.
    pub(super) rate: Dd,
    /// F'(v).
    pub(super) slope: Dd,
}

/// The roots by their distances from 1, -1 and each other.
#[derive(Debug, Clone, Copy)]
pub(super) struct Roots {
    /// 1 - v1.
    pub(super) x1: Dd,
    /// 1 - v2.
    pub(super) x2: Dd,
    /// 1 + v1.
    pub(super) y1: Dd,
    /// 1 + v2.
    pub(super) y2: Dd,
    /// v2 - v1.
    pub(super) gap: Dd,
    /// beta (v3 - 1), finite as beta -> 0.
    pub(super) outer: Dd,
    /// beta.
    pub(super) gravity: Dd,
    /// v - v1 and v2 - v at the start.
    pub(super) start: (Dd, Dd),
}

impl Roots {
    /// The roots. Inner roots that rounding has made a complex pair are taken as
    /// equal; that the energy allows a motion is the caller's to check.
    pub(super) fn new(conserved: &Conserved, origin: &Origin) -> Self {
        let Conserved { spin, difference, sum, excess, total, gravity } = *conserved;
        // F(1 - x) = -d^2 + c1 x + c2 x^2 - beta x^3
        let c1 = (excess - difference * spin).scaled(2.0);
        let c1_size = 2.0 * (excess.hi().abs() + (difference * spin).hi().abs());
        let c2 = gravity.scaled(2.0) - excess - spin.square();
        let outer = outer_root(gravity, difference, c1, c2);
        let far = outer + gravity.scaled(2.0);

        // X1 X2 = d^2 / (beta (v3 - 1)), Y1 Y2 = s^2 / (beta (v3 + 1)).
        let product_x = if outer > 0.0 { difference.square() / outer } else { -c1 / gravity };
        let product_y = sum.square() / far;

        let other = |product: Dd, root: Dd| if root > 0.0 { product / root } else { Dd::ZERO };
        let (x1, x2, y1, y2, gap, start) = match origin {
            Origin::State(state) => {
                let (below, above) = turning_points_around(state, outer, gravity);
                let x1 = state.to_one + below;
                let y2 = state.from_minus_one + above;
                let (x2, y1) = (other(product_x, x1), other(product_y, y2));
                (x1, x2, y1, y2, below + above, (below, above))
            }
            Origin::Lower | Origin::Upper => {
                // X1 + X2 from either of two identities, whichever cancels less.
                let by_outer = (outer.hi() + c2.hi().abs()) / gravity.hi();
                let by_product = ((product_x * gravity).hi().abs() + c1_size) / outer.hi();
                let sum_x = if by_outer < by_product || outer == 0.0 {
                    (outer + c2) / gravity
                } else {
                    (product_x * gravity + c1) / outer
                };
                let (x1, x2, y1, y2, gap) = if sum_x <= 2.0 {
                    let root = distance(sum_x, product_x);
                    let x1 = (sum_x + root).scaled(0.5);
                    let x2 = other(product_x, x1);
                    let y2 = 2.0 - x2;
                    (x1, x2, other(product_y, y2), y2, root)
                } else {
                    let slope = (total + sum * spin).scaled(2.0);
                    let sum_y = (slope - product_y * gravity) / far;
                    let root = distance(sum_y, product_y);
                    let y2 = (sum_y + root).scaled(0.5);
                    let y1 = other(product_y, y2);
                    let x1 = 2.0 - y1;
                    (x1, other(product_x, x1), y1, y2, root)
                };
                let start =
                    if matches!(origin, Origin::Lower) { (Dd::ZERO, gap) } else { (gap, Dd::ZERO) };
                (x1, x2, y1, y2, gap, start)
            }
        };
        Self { x1, x2: x2.max(Dd::ZERO), y1, y2, gap, outer, gravity, start }
    }

    /// beta (v3 - v1), four times the square of the rate p of the argument.
    pub(super) fn span(&self) -> Dd {
        self.outer + self.gravity * self.x1
    }

    /// The parameter m = (v2 - v1)/(v3 - v1), and 1 - m = (v3 - v2)/(v3 - v1): a sum of gaps,
    /// nothing cancels. `span` is the span of the roots.
    pub(super) fn parameters(&self, span: Dd) -> [Dd; 2] {
        [self.gravity * self.gap / span, (self.outer + self.gravity * self.x2) / span]
    }
}

/// The distance of the two roots with this sum and product.
fn distance(sum: Dd, product: Dd) -> Dd {
    (sum.square() - product.scaled(4.0)).max(Dd::ZERO).sqrt()
}

/// The distances v - v1 and v2 - v of the state from its turning points.
///
/// F(v + y) = (y^2 - S y + P)(beta y - far) with far = beta (v3 - v): from the two
/// lowest coefficients, F(v) = v'^2 and F'(v), without the others.
fn turning_points_around(state: &State, outer: Dd, gravity: Dd) -> (Dd, Dd) {
    let far = outer + gravity * state.to_one;
    let product = -(state.rate.square() / far);
    let sum = (state.slope - product * gravity) / far;
    let half = sum.scaled(0.5);
    let root = (half.square() - product).sqrt();
    if half >= 0.0 {
        let above = half + root;
        let below = if above > 0.0 { -product / above } else { above };
        (below, above)
    } else {
        let below = root - half;
        (below, -product / below)
    }
}

/// beta (v3 - 1): the one root >= 0 of s^3 + c2 s^2 - c1 beta s - (d beta)^2.
///
/// It is known as well as the coefficients are: the other two roots, -beta X1 and -beta X2,
/// lie on the other side of zero.
fn outer_root(gravity: Dd, difference: Dd, c1: Dd, c2: Dd) -> Dd {
    if gravity == 0.0 {
        return (-c2).max(Dd::ZERO);
    }
    // Sixth powers of rates are formed: in a unit of time, a power of two, that brings the largest
    // near 1.
    let largest = gravity.hi().max(c2.hi().abs()).max(f64::MIN_POSITIVE);
    let unit = ldexp(1.0, -(ilogb(largest) / 2));
    let squared = |x: Dd| x.scaled(unit).scaled(unit);
    let root = cubic_root(squared(gravity), difference.scaled(unit), squared(c1), squared(c2));
    root.scaled(1.0 / unit).scaled(1.0 / unit)
}

/// The same where sixth powers are numbers.
fn cubic_root(gravity: Dd, difference: Dd, c1: Dd, c2: Dd) -> Dd {
    let linear = c1 * gravity;
    if difference == 0.0 {
        return if c1 > 0.0 {
            positive_root(c2, linear)
        } else if c1 == 0.0 {
            (-c2).max(Dd::ZERO)
        } else {
            Dd::ZERO
        };
    }
    let constant = (difference * gravity).square();
    let mut s = Dd::from(outer_root_guess(c2.hi(), linear.hi(), constant.hi()));
    for _ in 0..12 {
        let value = (((s + c2) * s - linear) * s - constant).hi();
        let (x, c2) = (s.hi(), c2.hi());
        let slope = (3.0 * x + 2.0 * c2) * x - linear.hi();
        // To its second power: the third of a guess's error is none.
        let step = value / slope;
        let step = step * (1.0 + step * (3.0 * x + c2) / slope);
        let next = s - step;
        if !next.is_finite() || next <= 0.0 {
            break;
        }
        s = next;
        if step.abs() <= 1e-14 * x {
            break;
        }
    }
    s
}

/// Newton's method from above, where it falls monotonically onto the largest root.
fn outer_root_guess(c2: f64, linear: f64, constant: f64) -> f64 {
    let size = c2.abs().max(linear.abs().sqrt()).max(crate::math::cbrt(constant));
    let bound = if c2 > 0.0 {
        // Without s^3 >= 0 the root only grows: an upper bound, near if s is small.
        let root = (linear * linear + 4.0 * c2 * constant).sqrt();
        if linear >= 0.0 { (linear + root) / (2.0 * c2) } else { 2.0 * constant / (root - linear) }
    } else {
        // s^2 + c2 s - linear = constant/s, and s is at least the root for a constant of none.
        let root = |linear: f64| 0.5 * ((c2 * c2 + 4.0 * linear).sqrt() - c2);
        root(linear + constant / root(linear))
    };
    let mut s = (2.0 * size).min(bound);
    for _ in 0..200 {
        let value = ((s + c2) * s - linear) * s - constant;
        let slope = (3.0 * s + 2.0 * c2) * s - linear;
        let step = value / slope;
        let next = s - step;
        if !(next > 0.0 && next < s) {
            break;
        }
        s = next;
        // The next one would be about its square.
        if step < 1e-9 * s {
            break;
        }
    }
    s
}

/// The positive root of s^2 + b s - c, c > 0.
fn positive_root(b: Dd, c: Dd) -> Dd {
    let root = (b.square() + c.scaled(4.0)).sqrt();
    if b <= 0.0 { (root - b).scaled(0.5) } else { c.scaled(2.0) / (b + root) }
}
