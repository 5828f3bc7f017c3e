//! The free body: Euler's equations by sweeps, the attitude by quadrature.
//!
//! The momentum l on the body's axes moves by itself, l' = l x omega. Once its stages
//! are known, the attitude costs no sweep: it turns l to the constant momentum in space,
//! and only the angle about that is left, an integral.

use super::sweeps::{Companion, weighted_mean};
use super::{GaussLegendre, StageOde};
use crate::attitude::Attitude;
use crate::attitude::product::product;
use crate::body::{RigidBody, State};
use crate::error::{Error, Result, finite};
use crate::frame::{BodyVector, SpaceVector};
use crate::integrators::compensated::Compensated;
use crate::integrators::ode::check_span;
use crate::integrators::scene::components;
use crate::integrators::{Integrator, Ode, Work, advance_by_counting};
use crate::math::{DoubleDouble as Dd, Lane, ilogb, ldexp, order_of_three, sincos_turns};
use crate::scene::Scene;

/// A scene without torque, on the body's own axes:
///
/// ```text
/// q' = q (0, omega) / 2,   l' = l x omega,   omega = I^-1 l.
/// ```
///
/// Energy and |L| are quadratic in l, and Gauss's methods keep what is quadratic: the error grows
/// with the time, not with its square as it does in the variables of [`Scene`]. In units that make
/// Euler's equations a' = b c, b' = -c a, c' = a b a sweep is three products and three sums. With n
/// = l/|L| and a direction u nearby, the angle about L grows by omega (n + u)/(1 + n u) beyond the
/// shortest way from n to u, which is integrated to the same order 16.
///
/// ```
/// use rotation_dynamics::attitude::Attitude;
/// use rotation_dynamics::body::RigidBody;
/// use rotation_dynamics::exact::free_body::FreeBody;
/// use rotation_dynamics::frame::BodyVector;
/// use rotation_dynamics::inertia::PrincipalMoments;
/// use rotation_dynamics::integrators::gauss_legendre::FreeRotation;
/// use rotation_dynamics::integrators::{GaussLegendre, Integrator};
/// use rotation_dynamics::scene::Scene;
/// # fn main() -> rotation_dynamics::Result<()> {
/// let moments = PrincipalMoments::new(1.0, 2.0, 2.5)?;
/// let rates = BodyVector::new(0.8, 0.4, 0.3375);
/// let scene = Scene::new(RigidBody::new(moments));
/// let start = scene.body().state(Attitude::IDENTITY, rates)?;
/// let method = GaussLegendre::new(60)?;
/// let (end, _) = method.advance(&FreeRotation::new(&scene), 0.0, &start, 60.0)?;
/// let exact = FreeBody::new(moments, Attitude::IDENTITY, rates)?;
/// assert!(end.attitude.angle_to(&exact.attitude(60.0)) < 1e-13);
/// # Ok(())
/// # }
/// ```
///
/// As an [`Ode`], for the other methods, the components are w, x, y, z and l.
///
/// Source: notes 15.4, 15.5; for the quadratic invariants E. Hairer, C. Lubich,
/// G. Wanner, *Geometric Numerical Integration*, IV.2.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FreeRotation {
    body: RigidBody,
    /// 1/I and what its rounding leaves out: rounded alone it would turn the body
    /// by eps too much per radian, always to the same side.
    inverse: [[f64; 2]; 3],
}

impl FreeRotation {
    /// The scene's free rotation.
    pub fn new(scene: &Scene<()>) -> Self {
        Self { body: *scene.body(), inverse: inverse_moments(scene.body()) }
    }

    /// The body.
    pub const fn body(&self) -> &RigidBody {
        &self.body
    }

    /// The state as an [`Ode`] carries it: w, x, y, z and the momentum on the body axes.
    pub fn components(&self, state: &State) -> [f64; 7] {
        let [w, x, y, z] = state.attitude.quaternion();
        let [l1, l2, l3] = self.body.angular_momentum(state).to_array();
        [w, x, y, z, l1, l2, l3]
    }
}

/// 1/I in two parts.
pub(in crate::integrators) fn inverse_moments(body: &RigidBody) -> [[f64; 2]; 3] {
    body.moments().to_array().map(|i| parts(Dd::from(i).recip()))
}

fn parts(x: Dd) -> [f64; 2] {
    [x.hi(), x.lo()]
}

/// omega = I^-1 l.
#[inline(always)]
pub(in crate::integrators) fn rates_of<L: Lane>(
    inverse: &[[f64; 2]; 3],
    [l1, l2, l3]: [L; 3],
) -> [L; 3] {
    let [[a, a_rest], [b, b_rest], [c, c_rest]] = *inverse;
    [l1 * a + l1 * a_rest, l2 * b + l2 * b_rest, l3 * c + l3 * c_rest]
}

/// q' and l' of a body with these 1/I, all on its own axes.
#[inline(always)]
pub(super) fn rates<L: Lane>(
    inverse: &[[f64; 2]; 3],
    &[w, x, y, z, l1, l2, l3]: &[L; 7],
) -> [L; 7] {
    let [p, q, r] = rates_of(inverse, [l1, l2, l3]);
    let turn = [l2 * r - l3 * q, l3 * p - l1 * r, l1 * q - l2 * p];
    let (p, q, r) = (p * 0.5, q * 0.5, r * 0.5);
    [
        -(x * p + y * q + z * r),
        w * p + y * r - z * q,
        w * q + z * p - x * r,
        w * r + x * q - y * p,
        turn[0],
        turn[1],
        turn[2],
    ]
}

impl Ode<7> for FreeRotation {
    #[inline]
    fn derivative(&self, _t: f64, y: &[f64; 7]) -> [f64; 7] {
        rates(&self.inverse, y)
    }

    /// The lengths of the quaternion and of the momentum.
    fn scale(&self, &[w, x, y, z, l1, l2, l3]: &[f64; 7]) -> [f64; 7] {
        let q = (w * w + x * x + y * y + z * z).sqrt();
        let l = SpaceVector::new(l1, l2, l3).norm().max(f64::MIN_POSITIVE);
        [q, q, q, q, l, l, l]
    }
}

/// Euler's equations on the axes and in the units of [`Units`]:
/// a' = b c, b' = -c a, c' = a b; of a symmetric body, whose axis comes last,
/// a' = k b c, b' = -k c a, c' = 0 with k = 1, -1, or 0 for a sphere.
struct Euler {
    k: f64,
    /// 1, and 0 for a symmetric body.
    last: f64,
    scale: [f64; 3],
}

impl StageOde<3> for Euler {
    #[inline(always)]
    fn derivatives<L: Lane>(&self, _t: L, &[a, b, c]: &[L; 3]) -> [L; 3] {
        let c = c * self.k;
        [b * c, -(c * a), a * b * self.last]
    }

    fn scale(&self, _: &[f64; 3]) -> [f64; 3] {
        self.scale
    }
}

/// The axes in the order of their moments, and the unit of a momentum along each.
struct Units {
    /// Which of the body's axes is the first, second, third; the third is turned round
    /// if that order is left-handed.
    axes: [usize; 3],
    third: f64,
    /// Powers of two in which moments and momenta are of order 1.
    moment: i32,
    momentum: i32,
    /// The start in these units, and how fast the body turns and where L points for
    /// one unit along each axis.
    start: [Dd; 3],
    rate: [[f64; 2]; 3],
    direction: [[f64; 2]; 3],
    k: f64,
    symmetric: bool,
}

impl Units {
    /// Errors: moments or momenta too far apart for `f64`.
    fn new(body: &RigidBody, state: &State) -> Result<Self> {
        let moments = body.moments().to_array();
        let moment = ilogb(moments[0].max(moments[1]).max(moments[2]));
        let length = state.angular_momentum.to_array();
        let momentum = ilogb(length.iter().fold(0.0_f64, |m, c| m.max(c.abs())));
        let [i1, i2, i3] = moments;
        let symmetric = i1 == i2 || i2 == i3 || i3 == i1;
        let axes = if !symmetric {
            order_of_three(moments)
        } else if i1 == i2 {
            [0, 1, 2]
        } else if i2 == i3 {
            [1, 2, 0]
        } else {
            [2, 0, 1]
        };
        let third = if (axes[0] + 1) % 3 == axes[1] { 1.0 } else { -1.0 };
        let on_body = momentum_on_body(state, momentum);
        let own = axes.map(|i| on_body[i]);
        let own = [own[0], own[1], own[2] * third];
        let [i1, i2, i3] = axes.map(|i| Dd::from(ldexp(moments[i], -moment)));
        // 1/I3 - 1/I2 and its cyclic kin; the difference of the moments is exact.
        let coupling = |next: Dd, last: Dd| Dd::sum(next.hi(), -last.hi()) / next / last;
        let (k1, k2, k3) = (coupling(i2, i3), coupling(i3, i1), coupling(i1, i2));
        let (k, unit) = if symmetric {
            let k = k1.hi();
            let third = if k == 0.0 { Dd::ONE } else { k1.abs().recip() };
            let k = if k == 0.0 { 0.0 } else { k.signum() };
            (k, [Dd::ONE, Dd::ONE, third])
        } else {
            // In order the couplings have the signs -, +, -; units that are negative
            // turn them.
            let unit = |a: Dd, b: Dd| -(a.abs().sqrt() * b.abs().sqrt()).recip();
            (1.0, [unit(k2, k3), unit(k3, k1), unit(k1, k2)])
        };
        let size = own.iter().fold(Dd::ZERO, |sum, l| sum + l.square()).sqrt();
        let moments = [i1, i2, i3];
        let units = Self {
            axes,
            third,
            moment,
            momentum,
            start: core::array::from_fn(|i| own[i] / unit[i]),
            rate: core::array::from_fn(|i| parts(unit[i] / moments[i])),
            direction: core::array::from_fn(|i| parts(unit[i] / size)),
            k,
            symmetric,
        };
        let numbers = (units.rate.iter().chain(&units.direction)).flatten();
        let start = units.start.iter().map(|l| l.hi());
        for number in numbers.copied().chain(start) {
            finite("momentum in units of the body", number)?;
        }
        Ok(units)
    }

    /// A vector of these axes on the body's.
    fn to_body(&self, own: [f64; 3]) -> BodyVector {
        let mut body = [0.0; 3];
        body[self.axes[0]] = own[0];
        body[self.axes[1]] = own[1];
        body[self.axes[2]] = own[2] * self.third;
        BodyVector::from_array(body)
    }

    fn carry<const STEADY: bool>(
        &self,
        method: &GaussLegendre<STEADY>,
        span: f64,
        work: &mut Work,
    ) -> Result<([f64; 3], Quaternion)> {
        let mut turn =
            Turn { rate: self.rate, direction: self.direction, turned: [1.0, 0.0, 0.0, 0.0] };
        let start =
            Compensated { value: self.start.map(|l| l.hi()), carry: self.start.map(|l| l.lo()) };
        let scale = self.direction.map(|[n, _]| 1.0 / n.abs());
        let (k, last) = (self.k, if self.symmetric { 0.0 } else { 1.0 });
        let euler = Euler { k, last, scale };
        let end = method.run(&euler, 0.0, start, span, &mut turn, work)?;
        Ok((end, turn.turned))
    }
}

/// L on the body's axes in units of two to the `exponent`, to twice the digits.
pub(in crate::integrators) fn momentum_on_body(state: &State, exponent: i32) -> [Dd; 3] {
    let l = state.angular_momentum.to_array().map(|l| Dd::from(ldexp(l, -exponent)));
    let [w, x, y, z] = state.attitude.quaternion().map(Dd::from);
    let v = [-x, -y, -z];
    let square = v.iter().fold(Dd::ZERO, |sum, c| sum + c.square());
    let along = v[0] * l[0] + v[1] * l[1] + v[2] * l[2];
    let norm = w.square() + square;
    core::array::from_fn(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        let across = v[j] * l[k] - v[k] * l[j];
        ((w.square() - square) * l[i] + (along * v[i] + w * across) * 2.0) / norm
    })
}

type Quaternion = [f64; 4];

/// Follows the attitude, from the body's axes now to those at the start.
struct Turn {
    rate: [[f64; 2]; 3],
    direction: [[f64; 2]; 3],
    turned: Quaternion,
}

impl Companion<3> for Turn {
    #[inline(always)]
    fn follow<L: Lane>(
        &mut self,
        [h, h_rest]: [f64; 2],
        from: &[f64; 3],
        stages: &[L; 3],
        to: &[f64; 3],
    ) {
        // The direction u, amid those the momentum has during the step.
        let mut middle = [0.0; 3];
        let mut directions = *stages;
        for i in 0..3 {
            let [unit, rest] = self.direction[i];
            directions[i] = stages[i] * unit + stages[i] * rest;
            let mut lanes = [0.0; 8];
            directions[i].store(&mut lanes);
            middle[i] = lanes[3] + lanes[4];
        }
        let u = scaled(middle, 1.0 / dot(middle, middle).sqrt());
        let (mut growth, mut near) = (L::of(0.0), L::of(1.0));
        for i in 0..3 {
            let [unit, rest] = self.rate[i];
            let rate = stages[i] * unit + stages[i] * rest;
            growth = growth + rate * (directions[i] + u[i]);
            near = near + directions[i] * u[i];
        }
        let mut rates = [0.0; 8];
        (growth / near).store(&mut rates);
        let mean = weighted_mean::<L>(&rates);
        let angle = h * mean + h_rest * mean;
        let (s, c) = sincos_turns(angle * HALF_TURNS[0] + angle * HALF_TURNS[1]);
        let about = [c, s * u[0], s * u[1], s * u[2]];
        let turn =
            product(product(shortest(u, self.along(from)), about), shortest(self.along(to), u));
        self.turned = product(self.turned, unit_quaternion(turn));
    }
}

impl Turn {
    /// Where the momentum points, of unit length.
    #[inline(always)]
    fn along(&self, own: &[f64; 3]) -> [f64; 3] {
        let [[a, _], [b, _], [c, _]] = self.direction;
        [own[0] * a, own[1] * b, own[2] * c]
    }
}

/// 1/(4 pi), in two parts: from an angle to half of it in turns.
const HALF_TURNS: [f64; 2] = [0.079_577_471_545_947_67, -4.919_669_168_795_622e-18];

#[inline(always)]
fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[inline(always)]
fn scaled([x, y, z]: [f64; 3], by: f64) -> [f64; 3] {
    [x * by, y * by, z * by]
}

/// The shortest rotation that takes one direction to another; not of unit length.
#[inline(always)]
fn shortest(from: [f64; 3], to: [f64; 3]) -> Quaternion {
    let ([a, b, c], [d, e, f]) = (from, to);
    [1.0 + dot(from, to), b * f - c * e, c * d - a * f, a * e - b * d]
}

#[inline(always)]
fn unit_quaternion([w, x, y, z]: Quaternion) -> Quaternion {
    let by = 1.0 / (w * w + x * x + y * y + z * z).sqrt();
    [w * by, x * by, y * by, z * by]
}

/// The attitude moves; the momentum in space stays as at the start.
impl<const STEADY: bool> Integrator<FreeRotation, State> for GaussLegendre<STEADY> {
    advance_by_counting!(FreeRotation, State);

    fn advance_counting(
        &self,
        problem: &FreeRotation,
        t: f64,
        start: &State,
        t_end: f64,
        work: &mut Work,
    ) -> Result<State> {
        check_span(t, &components(start), t_end)?;
        if t == t_end || start.angular_momentum == SpaceVector::zero() {
            return Ok(*start);
        }
        let units = Units::new(&problem.body, start)?;
        let exponent = units.momentum - units.moment;
        let span = finite("end time - start time in units of I/|L|", ldexp(t_end - t, exponent))?;
        let (end, turned) = units.carry(self, span, work).map_err(|error| match error {
            Error::NoConvergence { t: since, h, change } => Error::NoConvergence {
                t: t + ldexp(since, -exponent),
                h: ldexp(h, -exponent),
                change,
            },
            other => other,
        })?;
        let [x, y, z] = units.to_body([turned[1], turned[2], turned[3]]).to_array();
        let attitude = product(start.attitude.quaternion(), [turned[0], x, y, z]);
        let attitude = Attitude::from_quaternion(attitude)?;
        // The shortest rotation that brings the momentum on the body's axes to L: it
        // undoes what products of rotations have rounded away.
        let own = core::array::from_fn(|i| end[i] * units.direction[i][0]);
        let found = attitude.to_space(units.to_body(own)).to_array();
        let momentum = start.angular_momentum.to_array();
        let unit = momentum.map(|l| ldexp(l, -units.momentum));
        let unit = scaled(unit, 1.0 / dot(unit, unit).sqrt());
        let attitude = product(shortest(found, unit), attitude.quaternion());
        let attitude = Attitude::from_quaternion(attitude)?;
        Ok(State { attitude, ..*start })
    }
}
