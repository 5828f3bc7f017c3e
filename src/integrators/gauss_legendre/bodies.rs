//! What the method carries of a body: states of any scene, symmetric bodies
//! without their spin, and the free body on its own axes.

use super::{GaussLegendre, LaneByLane, Lanes, StageOde};
use crate::attitude::Attitude;
use crate::body::{RigidBody, State};
use crate::effects::{AxisEffect, Effect};
use crate::error::Result;
use crate::frame::SpaceVector;
use crate::integrators::scene::{components, state};
use crate::integrators::{About, Integrator, Ode, SpinFree, Work};
use crate::math::DoubleDouble;
use crate::scene::Scene;

impl<E: Effect> Integrator<Scene<E>, State> for GaussLegendre {
    fn about(&self) -> About {
        Self::ABOUT
    }

    fn advance(
        &self,
        scene: &Scene<E>,
        t: f64,
        start: &State,
        t_end: f64,
    ) -> Result<(State, Work)> {
        let (end, work) = self.advance(&LaneByLane(scene), t, &components(start), t_end)?;
        Ok((state(&end)?, work))
    }
}

impl<'s, E: AxisEffect> Integrator<SpinFree<'s, E>, State> for GaussLegendre {
    fn about(&self) -> About {
        Self::ABOUT
    }

    fn advance(
        &self,
        problem: &SpinFree<'s, E>,
        t: f64,
        start: &State,
        t_end: f64,
    ) -> Result<(State, Work)> {
        let (end, work) = self.advance(&LaneByLane(problem), t, &components(start), t_end)?;
        let spin = problem.spin_rate(start) * (t_end - t);
        Ok((problem.state(&end, spin)?, work))
    }
}

/// A scene without torque, by attitude and momentum on the body's own axes:
///
/// ```text
/// q' = q (0, omega) / 2,   l' = l x omega,   omega = I^-1 l.
/// ```
///
/// Energy and |L| are quadratic in l, and Gauss's methods keep what is quadratic:
/// the error grows with the time, not with its square as it does in the variables
/// of [`Scene`]. No formula has a branch, so the eight stages fill vector registers.
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
/// let exact = FreeBody::new(moments, rates, Attitude::IDENTITY)?;
/// assert!(end.attitude.angle_to(&exact.attitude_at(60.0)) < 1e-13);
/// # Ok(())
/// # }
/// ```
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
        let inverse = scene.body().moments().to_array().map(|i| {
            let inverse = DoubleDouble::from(1.0) / DoubleDouble::from(i);
            [inverse.hi(), inverse.lo()]
        });
        Self {
            body: *scene.body(),
            inverse,
        }
    }

    /// The state as it is carried: w, x, y, z and the momentum on the body axes.
    pub fn components(&self, state: &State) -> [f64; 7] {
        let [w, x, y, z] = state.attitude.quaternion();
        let [l1, l2, l3] = self.body.angular_momentum(state).to_array();
        [w, x, y, z, l1, l2, l3]
    }

    /// The derivatives of the seven components, in their order.
    ///
    /// Bare numbers in and out: the compiler turns a loop over this into vector
    /// instructions, which arrays would prevent.
    #[inline(always)]
    fn rates(&self, (w, x, y, z): Four, (l1, l2, l3): Three) -> (Four, Three) {
        let [[a, a_rest], [b, b_rest], [c, c_rest]] = self.inverse;
        let (p, q, r) = (
            l1 * a + l1 * a_rest,
            l2 * b + l2 * b_rest,
            l3 * c + l3 * c_rest,
        );
        let turn = (l2 * r - l3 * q, l3 * p - l1 * r, l1 * q - l2 * p);
        let (p, q, r) = (0.5 * p, 0.5 * q, 0.5 * r);
        let rate = (
            -(x * p + y * q + z * r),
            w * p + y * r - z * q,
            w * q + z * p - x * r,
            w * r + x * q - y * p,
        );
        (rate, turn)
    }
}

type Four = (f64, f64, f64, f64);
type Three = (f64, f64, f64);

impl Ode<7> for FreeRotation {
    #[inline]
    fn derivative(&self, _t: f64, &[w, x, y, z, l1, l2, l3]: &[f64; 7]) -> [f64; 7] {
        let ((w, x, y, z), (l1, l2, l3)) = self.rates((w, x, y, z), (l1, l2, l3));
        [w, x, y, z, l1, l2, l3]
    }

    /// The length of the quaternion and that of the momentum.
    fn scale(&self, &[w, x, y, z, l1, l2, l3]: &[f64; 7]) -> [f64; 7] {
        let q = (w * w + x * x + y * y + z * z).sqrt();
        let l = SpaceVector::new(l1, l2, l3).norm().max(f64::MIN_POSITIVE);
        [q, q, q, q, l, l, l]
    }
}

impl StageOde<7> for FreeRotation {
    #[inline(always)]
    fn derivatives(&self, _t: &Lanes, [w, x, y, z, l1, l2, l3]: &[Lanes; 7]) -> [Lanes; 7] {
        let mut out = [[0.0; 8]; 7];
        for i in 0..8 {
            let (four, three) = self.rates((w[i], x[i], y[i], z[i]), (l1[i], l2[i], l3[i]));
            (out[0][i], out[1][i], out[2][i], out[3][i]) = four;
            (out[4][i], out[5][i], out[6][i]) = three;
        }
        out
    }

    fn scale(&self, y: &[f64; 7]) -> [f64; 7] {
        Ode::scale(self, y)
    }
}

/// The attitude moves; the momentum in space is that of the start.
impl Integrator<FreeRotation, State> for GaussLegendre {
    fn about(&self) -> About {
        Self::ABOUT
    }

    fn advance(
        &self,
        problem: &FreeRotation,
        t: f64,
        start: &State,
        t_end: f64,
    ) -> Result<(State, Work)> {
        let start_components = problem.components(start);
        let ([w, x, y, z, ..], work) = self.advance(problem, t, &start_components, t_end)?;
        let attitude = Attitude::from_quaternion([w, x, y, z])?;
        Ok((State { attitude, ..*start }, work))
    }
}
